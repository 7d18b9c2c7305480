"""Principal second moments of tracked numbers: axes from the doubles, moments along them."""

from dynamics_cli.inertia.bodies.mass_moments import each
from dynamics_cli.inertia.bodies.principal import principal, principal_of_many_digits
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.number import is_many, is_tracked, plain
from dynamics_cli.records import ErrorBound

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.bodies.mass_moments import Matrix, Vector

# A stated bound covers the unit a number is shown in: the rounding of the unit's ratio, and of the product with it.
SHOWN = (1.0 + 2.0**-40) * 2.0**-52
# No bound is stated for an axis with a possible error above this angle [rad].
LARGEST_TILT = 0.5


class Spread:
    """Second moments along the principal axes, moments about them (smallest first), axes, undetermined directions."""

    __slots__ = ("axes", "degeneracy", "moments", "seconds", "tilts")

    def __init__(self, seconds: "Vector", axes: "Matrix", degeneracy: str, tilts: "Vector | None" = None) -> None:
        self.seconds = seconds
        self.moments = (seconds[1] + seconds[2], seconds[2] + seconds[0], seconds[0] + seconds[1])
        self.axes = axes
        self.degeneracy = degeneracy
        # possible rotation of each axis from the true one, if known and all are determined
        self.tilts = tilts if determined(degeneracy) else None

    def axes_bound(self) -> "tuple[ErrorBound, ...]":
        """The bound of every component of the axes, if there is a useful one."""
        return stated_tilt(self.tilts)


def determined(degeneracy: str) -> bool:
    """Whether all principal axes are."""
    return degeneracy.startswith("none")


def stated_tilt(tilts: "Vector | None") -> "tuple[ErrorBound, ...]":
    """The bound of every component of principal axes that may be turned so far."""
    if tilts is None or not max(tilts) < LARGEST_TILT:
        return ()
    return (ErrorBound("principal_axes", max(tilts), relative=False),)


def in_many_digits(matrix: "Matrix") -> bool:
    """Whether any number of a matrix is of many digits."""
    return any(is_many(x) for row in matrix for x in row)


def root(x: float) -> float:
    """√x, or zero where rounding made a zero negative."""
    return sqrt(x) if x > 0.0 else 0.0


def ellipsoid(moments: "tuple[float, ...]") -> "Vector":
    """Semi-axes 1/√I over the longest; a body without inertia about an axis has an ellipsoid that is a line."""
    least = moments[0]
    if not least > 0.0:
        return each(lambda moment: 1.0 if not moment > 0.0 else 0.0, moments)
    return each(lambda moment: root(least / moment), moments)


def spread_of(second: "Matrix") -> Spread:
    """The principal axes of second moments.

    A tracked matrix gives tracked moments: their slopes are the slopes of vᵀ S v for the fixed axis v (Hellmann and
    Feynman), their bound combines that of this sum and that of the eigenvalues.
    """
    if in_many_digits(second):
        precise = principal_of_many_digits(second)
        return Spread(precise.seconds, precise.axes, precise.degeneracy)
    matrix = tuple(tuple(plain(x) for x in row) for row in second)
    axes = principal(matrix)  # type: ignore[arg-type]
    if not any(is_tracked(x) for row in second for x in row):
        return Spread(axes.seconds, axes.axes, axes.degeneracy)
    seconds = bounded(second, axes.seconds, axes.vectors)
    axes = principal(matrix, each(error_of, seconds))  # type: ignore[arg-type]
    return Spread(seconds, axes.axes, axes.degeneracy, tilts_of(second, axes.axes))


def error_of(x: float) -> float:
    """The bound that a tracked number carries."""
    return getattr(x, "error", 0.0)


def tilts_of(matrix: "Matrix", axes: "Matrix", stretch: float = 0.0) -> "Vector":
    """How far axes may be turned from the principal axes of a tracked matrix seen in a frame that stretches so much."""
    from dynamics_cli.numerics.eigen3.residual import tilt_bounds

    sizes = [stretch * abs(plain(matrix[i][i])) for i in range(3)]
    errors = tuple(tuple(error_of(matrix[i][j]) + sizes[i] + sizes[j] for j in range(3)) for i in range(3))
    return tilt_bounds(tuple(each(plain, row) for row in matrix), axes, errors)  # type: ignore[arg-type]


def bounded(second: "Matrix", values: "Vector", axes: "Matrix") -> "Vector":
    """Eigenvalues of a tracked matrix with the slopes of their Rayleigh quotients and bounds proved afterwards."""
    from dynamics_cli.numerics.eigen3.residual import residual_bounds
    from dynamics_cli.numerics.tracked import Tracked

    doubles = tuple(tuple(plain(x) for x in row) for row in second)
    errors = tuple(tuple(getattr(x, "error", 0.0) for x in row) for row in second)
    bounds = residual_bounds(doubles, values, axes, errors)  # type: ignore[arg-type]
    slopes = [_slopes(second, axis) for axis in axes]
    return tuple(map(Tracked, values, bounds, slopes))  # type: ignore[return-value]


def _slopes(second: "Matrix", axis: "Vector") -> "tuple[float, ...]":
    """Slopes of vᵀ S v along a fixed axis v."""
    parts = [(axis[i] * axis[j], getattr(second[i][j], "slopes", ())) for i in range(3) for j in range(3)]
    width = max(len(slopes) for _, slopes in parts)
    return tuple([sum([weight * slopes[n] for weight, slopes in parts if slopes]) for n in range(width)])
