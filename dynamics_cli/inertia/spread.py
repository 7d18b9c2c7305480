"""Principal second moments of numbers that may carry derivatives: axes from the doubles, moments along them."""

from dynamics_cli.inertia.lump import turned
from dynamics_cli.inertia.principal import principal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.lump import Matrix, Vector

# Jacobi's rotations leave elements this many roundings of the norm away from those of the exact eigenvalues.
ROUNDINGS = 16.0


class Spread:
    """Second moments along the principal axes, the moments about them (smallest first), the axes, what is undetermined."""

    __slots__ = ("axes", "degeneracy", "moments", "seconds")

    def __init__(self, seconds: "Vector", axes: "Matrix", degeneracy: str) -> None:
        self.seconds = seconds
        self.moments = (seconds[1] + seconds[2], seconds[2] + seconds[0], seconds[0] + seconds[1])
        self.axes = axes
        self.degeneracy = degeneracy


def plain(x: float) -> float:
    """The number inside a tracked number; a float as it is."""
    return getattr(x, "value", x)


def spread_of(second: "Matrix") -> Spread:
    """The principal axes of second moments.

    A tracked matrix gives tracked moments: their slopes are those of vᵀ S v along the fixed axis v (Hellmann and
    Feynman), their bound is that of the same sum and of the eigenvalues' own.
    """
    matrix = tuple(tuple(plain(x) for x in row) for row in second)
    found = principal(matrix)  # type: ignore[arg-type]
    seconds = tuple(_carried(own, axis, second, matrix) for own, axis in zip(found.seconds, found.axes, strict=True))
    return Spread(seconds, found.axes, found.degeneracy)  # type: ignore[arg-type]


def _carried(own: float, axis: "Vector", second: "Matrix", matrix: "Matrix") -> float:
    """An eigenvalue with the slopes and the bound of its Rayleigh quotient."""
    along = turned(second, (axis, axis, axis))[0][0]
    if not hasattr(along, "slopes"):
        return own
    from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF, Tracked

    diagonal = all(matrix[i][j] == 0.0 for i in range(3) for j in range(i))
    norm = max(abs(x) for row in matrix for x in row)
    error = along.error + abs(along.value - own) + (0.0 if diagonal else ROUNDINGS * UNIT_ROUNDOFF * norm)
    return Tracked(own, error, along.slopes)  # type: ignore[return-value]
