"""Principal second moments of numbers that may carry derivatives: axes from the doubles, moments along them."""

from dynamics_cli.inertia.lump import each, turned
from dynamics_cli.inertia.principal import principal
from dynamics_cli.numerics.elementary import only_in_doubles, sqrt
from dynamics_cli.numerics.symmetric import eigen

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.lump import Matrix, Vector

# A stated bound covers the unit a number is shown in: the rounding of the unit's ratio, and of the product with it.
SHOWN = (1.0 + 2.0**-40) * 2.0**-52


class Spread:
    """Second moments along the principal axes, moments about them (smallest first), axes, what is undetermined."""

    __slots__ = ("axes", "degeneracy", "moments", "seconds")

    def __init__(self, seconds: "Vector", axes: "Matrix", degeneracy: str) -> None:
        self.seconds = seconds
        self.moments = (seconds[1] + seconds[2], seconds[2] + seconds[0], seconds[0] + seconds[1])
        self.axes = axes
        self.degeneracy = degeneracy


def plain(x: float) -> float:
    """The number inside a tracked number; a float as it is."""
    return getattr(x, "value", x)


def root(x: float) -> float:
    """√x, zero where rounding made a zero negative."""
    return sqrt(x) if x > 0.0 else 0.0


def ellipsoid(moments: "tuple[float, ...]") -> "Vector":
    """Semi-axes 1/√I over the longest; a body without inertia about an axis has an ellipsoid that is a line."""
    least = moments[0]
    if not least > 0.0:
        return each(lambda moment: 1.0 if not moment > 0.0 else 0.0, moments)
    return each(lambda moment: root(least / moment), moments)


def spread_of(second: "Matrix") -> Spread:
    """The principal axes of second moments.

    A tracked matrix gives tracked moments: their slopes are those of vᵀ S v along the fixed axis v (Hellmann and
    Feynman), their bound is that of the same sum and of the eigenvalues' own.
    """
    only_in_doubles(*second[0], *second[1], *second[2])
    matrix = tuple(tuple(plain(x) for x in row) for row in second)
    found = principal(matrix)  # type: ignore[arg-type]
    if not any(hasattr(x, "slopes") for row in second for x in row):
        return Spread(found.seconds, found.axes, found.degeneracy)
    return Spread(bounded(second, found.seconds, eigen(matrix).vectors), found.axes, found.degeneracy)  # type: ignore[arg-type]


def bounded(second: "Matrix", values: "Vector", axes: "Matrix") -> "Vector":
    """Eigenvalues of a tracked matrix with the slopes of their Rayleigh quotients and bounds proved afterwards.

    Along its axes the matrix is T = V S Vᵀ. Gershgorin's disc about T's element k holds an eigenvalue; scaled so that
    the others stay apart, its radius is Σ 2 tₖⱼ²/gapₖⱼ over the elements beside it, tₖⱼ itself where there is no gap
    (Wilkinson, The Algebraic Eigenvalue Problem, 2.15). The axes are unit vectors to a few roundings, which turns
    every eigenvalue by as many of its own (Ostrowski).
    """
    from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF, Tracked

    along = turned(second, axes)
    # where discs overlap, which eigenvalue is in which is not told: all of a group may be off by its largest
    alike = [[k == j for j in range(3)] for k in range(3)]
    errors = []
    off = [[abs(plain(x)) + getattr(x, "error", 0.0) for x in row] for row in along]
    found = []
    for k in range(3):
        mine = along[k][k]
        slopes = getattr(mine, "slopes", None)
        radius = 0.0
        for j in range(3):
            gap = abs(values[k] - values[j]) - getattr(mine, "error", 0.0) - getattr(along[j][j], "error", 0.0)
            alike[k][j] = alike[k][j] or gap <= 0.0 or abs(values[k] - values[j]) <= 2.0 * off[k][j]
            if j != k and off[k][j] > 0.0:
                radius += off[k][j] * min(1.0, 2.0 * off[k][j] / gap if gap > 0.0 else 1.0)
        error = getattr(mine, "error", 0.0) + abs(plain(mine) - values[k]) + radius
        if any(x not in (0.0, 1.0, -1.0) for row in axes for x in row):
            error += 8.0 * UNIT_ROUNDOFF * abs(values[k])
        errors.append(error)
        found.append(slopes if slopes is not None else _no_slopes(second))
    widest = [max(error for error, near in zip(errors, group, strict=True) if near) for group in alike]
    made = [Tracked(*parts) for parts in zip(values, widest, found, strict=True)]
    return made[0], made[1], made[2]  # type: ignore[return-value]


def _no_slopes(second: "Matrix") -> "tuple[float, ...]":
    """As many zeros as the tracked elements of a matrix have slopes."""
    count = next(len(x.slopes) for row in second for x in row if hasattr(x, "slopes"))
    return (0.0,) * count
