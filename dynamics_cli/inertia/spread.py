"""Principal second moments of numbers that may carry derivatives: axes from the doubles, moments along them."""

from dynamics_cli.inertia.lump import turned
from dynamics_cli.inertia.principal import principal
from dynamics_cli.numerics.symmetric import ROUNDINGS, UNIT_ROUNDOFF

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.lump import Matrix, Vector

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
    if not any(hasattr(x, "slopes") for row in second for x in row):
        return Spread(found.seconds, found.axes, found.degeneracy)
    share = share_of(second)
    seconds = [
        carried(own, axis, second, bound, share)
        for own, axis, bound in zip(found.seconds, found.axes, found.bounds, strict=True)
    ]
    return Spread((seconds[0], seconds[1], seconds[2]), found.axes, found.degeneracy)


def share_of(second: "Matrix") -> float:
    """The greatest error of an element over the geometric mean of its diagonal elements; 0 for a diagonal matrix."""
    if all(plain(second[i][j]) == 0.0 == getattr(second[i][j], "error", 0.0) for i in range(3) for j in range(i)):
        return 0.0
    worst = 0.0
    for i in range(3):
        for j in range(i + 1):
            error = getattr(second[i][j], "error", 0.0)
            mean = (abs(plain(second[i][i])) ** 0.5) * (abs(plain(second[j][j])) ** 0.5)
            worst = max(worst, error / mean if mean > 0.0 else (float("inf") if error else 0.0))
    return worst


def carried(own: float, axis: "Vector", second: "Matrix", bound: float, share: float) -> float:
    """An eigenvalue with its slopes and its bound.

    The solver's bound is so many roundings of the smaller of the norm and of the scaled condition times the
    eigenvalue; errors of the elements, as shares of the diagonal's geometric means, act through the same factor
    (Demmel and Veselić 1992, theorem 2.3), three to a row.
    """
    from dynamics_cli.numerics.tracked import Tracked

    along = turned(second, (axis, axis, axis))[0][0]
    if not hasattr(along, "slopes"):
        return own
    if bound == 0.0:
        return along
    error = bound * (1.0 + 3.0 * share / (ROUNDINGS * UNIT_ROUNDOFF))
    return Tracked(own, error, along.slopes)  # type: ignore[return-value]
