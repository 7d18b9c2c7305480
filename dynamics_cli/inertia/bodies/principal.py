"""Principal moments and axes of a body from its second moments, with undetermined axes declared as such."""

from dynamics_cli.numerics.eigen3.jacobi import UNIT_ROUNDOFF, eigen
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.orientation.rotations import IDENTITY, product
from dynamics_cli.numerics.vectors import cross

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.bodies.mass_moments import Matrix, Vector

# Moments closer than this many roundings (2⁻⁵²) of the largest one are equal within the accuracy of doubles.
EQUAL = 8.0
# Texts about axes that are not determined.
_EVERY = "every axis is principal"
_FIRST_TWO = "axes 1 and 2 are any two in the plane across axis 3"
_LAST_TWO = "axes 2 and 3 are any two in the plane across axis 1"


class Principal:
    """Second moments along the principal axes, the moments about them, the axes as rows, and undetermined ones.

    The moments are in ascending order, so the second moments descend. `vectors` are the eigenvectors that they were
    found with, in the axes of the matrix, also where the axes are not determined.
    """

    __slots__ = ("axes", "degeneracy", "seconds", "vectors")

    def __init__(self, seconds: "Vector", axes: "Matrix", degeneracy: str, vectors: "Matrix") -> None:
        self.seconds = seconds
        self.axes = axes
        self.degeneracy = degeneracy
        self.vectors = vectors

    @property
    def moments(self) -> "Vector":
        """Principal moments, the smallest first: each the sum of the two second moments across its axis."""
        a, b, c = self.seconds
        return b + c, c + a, a + b


def principal(second_moments: "Matrix", errors: "Vector" = (0.0, 0.0, 0.0), frame: "Matrix | None" = None) -> Principal:
    """Principal second moments and axes of a body.

    `second_moments`: symmetric matrix S = ∫ r rᵀ dm about the mass centre [kg*m^2]; `errors`: error of each principal
    second moment, the greatest first [kg*m^2]; `frame`: the axes of the second moments, seen in the input axes, when
    they are others [-]. Returns second moments, moments, axes and a sentence about axes that are not determined. Raises
    OverflowError when a number of the matrix is not finite.

    Sums of second moments lose no digits, unlike differences of moments: the smallest moment of a needle is accurate. A
    second moment below zero by rounding only is set to zero. Moments closer than 8·2⁻⁵² of the greatest, or than both
    their errors, determine no axes between them; the axes then given are those closest to the input axes. Axes are
    right-handed; the first two have their largest component positive.

    Equation
    --------
    S vᵢ = sᵢ vᵢ; I₁ = s₂ + s₃ ≤ I₂ = s₃ + s₁ ≤ I₃ = s₁ + s₂.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 7.7 to 7.9.

    Examples
    --------
    >>> principal(((1.0, 0.0, 0.0), (0.0, 3.0, 0.0), (0.0, 0.0, 1.0))).degeneracy
    'axes 2 and 3 are any two in the plane across axis 1: their moments are equal'
    """
    system = eigen(second_moments)
    norm = max(abs(value) for value in system.values)
    a, b, c = seconds = tuple(0.0 if -16.0 * UNIT_ROUNDOFF * norm <= value <= 0.0 else value for value in system.values)
    tolerance = EQUAL * 2.0 * UNIT_ROUNDOFF * (a + b)
    vectors = system.vectors if frame is None else product(system.vectors, frame)
    upper, lower = a - b <= max(tolerance, errors[0] + errors[1]), b - c <= max(tolerance, errors[1] + errors[2])
    beyond = (upper and a - b > tolerance) or (lower and b - c > tolerance)
    axes, words = _axes(vectors, upper, lower, beyond=beyond)
    return Principal(seconds, axes, words, system.vectors)  # type: ignore[arg-type]


def principal_of_many_digits(second_moments: "Matrix") -> Principal:
    """The same from second moments in many digits; whether axes are determined is decided by the nearest doubles."""
    from dynamics_cli.numerics.eigen3.jacobi_digits import eigen_of_many_digits

    near = principal(tuple(tuple(getattr(x, "value", x) for x in row) for row in second_moments))  # type: ignore[arg-type]
    values, vectors = eigen_of_many_digits(second_moments)
    upper, lower = (near.degeneracy.startswith((_EVERY, words)) for words in (_FIRST_TWO, _LAST_TWO))
    axes, _ = _axes(vectors, upper, lower, beyond=False)  # type: ignore[arg-type]
    return Principal(values, tuple(map(_alike, axes, near.axes)), near.degeneracy, vectors)  # type: ignore[arg-type]


def _alike(axis: "Vector", near: "Vector") -> "Vector":
    """An axis with the sense of another one."""
    along = axis[0] * near[0] + axis[1] * near[1] + axis[2] * near[2]
    return axis if along >= 0.0 else (-axis[0], -axis[1], -axis[2])


def _axes(vectors: "Matrix", upper: bool, lower: bool, *, beyond: bool) -> "tuple[Matrix, str]":
    """Axes in order of their moments, and the sentence about them; `upper`: the first two moments are equal."""
    why = "their moments differ by less than the uncertainty" if beyond else "their moments are equal"
    if upper and lower:
        return IDENTITY, f"{_EVERY}: {why.replace('their', 'all')}"
    if upper:
        third = _positive(vectors[2])
        first, second = _across(third)
        return (first, second, third), f"{_FIRST_TWO}: {why}"
    if lower:
        first = _positive(vectors[0])
        second, third = _across(first)
        return (first, second, third), f"{_LAST_TWO}: {why}"
    first, second = _positive(vectors[0]), _positive(vectors[1])
    return (first, second, _without_minus_zeros(cross(first, second))), "none: the principal moments are different"


def _positive(v: "Vector") -> "Vector":
    """The vector with its largest component positive, the first of equal ones."""
    largest = max(range(3), key=lambda k: (abs(v[k]), -k))
    return v if v[largest] > 0.0 else (0.0 - v[0], 0.0 - v[1], 0.0 - v[2])


def _across(u: "Vector") -> "tuple[Vector, Vector]":
    """Two unit vectors right-handed with `u`, the first the projection of the input axis most across it."""
    k = min(range(3), key=lambda i: (abs(u[i]), i))
    along = tuple((1.0 if i == k else 0.0) - u[k] * u[i] for i in range(3))
    length = sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2])
    first = (along[0] / length, along[1] / length, along[2] / length)
    return first, _without_minus_zeros(cross(u, first))


def _without_minus_zeros(v: "Vector") -> "Vector":
    return v[0] + 0.0, v[1] + 0.0, v[2] + 0.0
