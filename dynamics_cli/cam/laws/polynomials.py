"""Custom polynomial and spline laws: from conditions at chosen places, solved exactly, and through points."""

import itertools

from dynamics_cli.cam.laws.components import Mixed
from dynamics_cli.cam.laws.normalised import Law, Piece
from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from fractions import Fraction

    Condition = tuple[float, int, float]

MOST_CONDITIONS = 10


def polynomial(conditions: "Sequence[Condition]", name: str = "polynomial") -> Law:
    """Give the polynomial of lowest degree that meets conditions (x, order of derivative, value).

    `conditions`: place 0 ≤ x ≤ 1, order 0 to 4, and value of the derivative there; as many as the polynomial has
    coefficients; `name`: name of the law. Returns the law; its total is f(1) − f(0), and f(0) is taken off. Raises
    InadmissibleError when a condition is given twice, there are more than ten, or they do not fix a polynomial
    (Birkhoff's problem has no solution for some).

    Solved in exact rationals, expanded about both ends and the middle and rounded once: nothing is lost to the
    conditioning of the monomials, and values near both ends keep their digits.

    Examples
    --------
    >>> law = polynomial([(0.0, k, 0.0) for k in range(3)] + [(1.0, 0, 1.0), (1.0, 1, 0.0), (1.0, 2, 0.0)])
    >>> law.at(0.25)
    (0.103515625, 1.0546875, 5.625, -7.5)
    """
    from fractions import Fraction

    count = len(conditions)
    require(
        2 <= count <= MOST_CONDITIONS,
        "{count} conditions; a polynomial takes 2 to 10, for degree 1 to 9",
        count=count,
        code="conditions",
    )
    places = [(x, order) for x, order, _ in conditions]
    require(
        len(set(places)) == count, "a condition is given twice", code="conditions", hint="give each derivative once"
    )
    rows = [
        [_monomial(Fraction(x), i, order) for i in range(count)] + [Fraction(value)] for x, order, value in conditions
    ]
    solved = _solve(rows)
    require(
        solved is not None,
        "these conditions are met by no polynomial of degree {degree}, or by more than one",
        degree=count - 1,
        code="conditions",
        hint="give the lift at one place at least, and with each derivative all lower ones",
    )
    about_start = solved or []
    about_end = _about(about_start, Fraction(1))
    about_middle = _about(about_start, Fraction(1, 2))
    far = [-c if i % 2 == 0 else c for i, c in enumerate(about_end)]
    far[0] = Fraction(0)
    about_middle[0] -= about_start[0]
    pieces = (
        Piece(0.0, 0.25, False, Mixed([0.0, *map(float, about_start[1:])])),
        Piece(0.25, 0.75, False, Mixed([float(c) for c in about_middle], origin=0.5)),
        Piece(0.75, 1.0, True, Mixed([float(c) for c in far])),
    )
    return Law(name, pieces, monotone=False, total=float(about_end[0] - about_start[0]))


def _monomial(x: "Fraction", power: int, order: int) -> "Fraction":
    factor = 1
    for k in range(order):
        factor *= power - k
    return x ** (power - order) * factor if power >= order else 0 * x


def _solve(rows: "list[list[Fraction]]") -> "list[Fraction] | None":
    """Gauss and Jordan in exact rationals; None when singular."""
    count = len(rows)
    for column in range(count):
        pivot = next((i for i in range(column, count) if rows[i][column]), None)
        if pivot is None:
            return None
        rows[column], rows[pivot] = rows[pivot], rows[column]
        lead = rows[column][column]
        top = rows[column] = [value / lead for value in rows[column]]
        for i in range(count):
            factor = rows[i][column]
            if i != column and factor:
                rows[i] = [a - factor * b for a, b in zip(rows[i], top, strict=True)]
    return [row[-1] for row in rows]


def _about(coefficients: "list[Fraction]", place: "Fraction") -> "list[Fraction]":
    """The coefficients in powers of x − place, by repeated synthetic division."""
    shifted = list(coefficients)
    for start in range(len(shifted)):
        for i in range(len(shifted) - 2, start - 1, -1):
            shifted[i] = shifted[i] + place * shifted[i + 1]
    return shifted


def spline(
    points: "Sequence[tuple[float, float]]", start_slope: float, end_slope: float,
    steps: "tuple[float, float] | None" = None,
) -> Law:  # fmt: skip
    """Give the clamped cubic spline through points, with given slopes at its ends.

    `points`: places and values, the first at x = 0 and the last at x = 1; `start_slope`, `end_slope`: slopes at the
    ends; `steps`: decimal steps that places and lifts are multiples of (`rounded_points`). Returns the law: lift,
    velocity and acceleration are continuous, jerk jumps at the points. Raises InadmissibleError when the places do not
    increase.

    The tridiagonal system for the slopes is diagonally dominant: its solution is good to a few roundings for any
    places.

    Examples
    --------
    >>> [round(value, 6) for value in spline([(0.0, 0.0), (0.5, 0.5), (1.0, 1.0)], 0.0, 0.0).at(0.25)[:3]]
    [0.15625, 1.125, 3.0]
    """
    places = [x for x, _ in points]
    require(
        all(a < b for a, b in itertools.pairwise(places)),
        "the places of the points are not in increasing order",
        code="points",
        hint="put the points in order, each once",
    )
    slopes = slopes_through(points, start_slope, end_slope)
    first, last = points[0][1], points[-1][1]
    pieces = []
    for i in range(len(points) - 1):
        (x0, f0), (x1, f1) = points[i], points[i + 1]
        if x0 >= 0.5:
            z0, z1 = 1.0 - x1, 1.0 - x0
            shape = Mixed(_cubic(z1 - z0, last - f1, last - f0, slopes[i + 1], slopes[i]), origin=z0)
        else:
            shape = Mixed(_cubic(x1 - x0, f0 - first, f1 - first, slopes[i], slopes[i + 1]), origin=x0)
        pieces.append(Piece(x0, x1, x0 >= 0.5, shape))
    closed = _closed(pieces, slopes[-1], last - first)
    return Law("spline", closed, places[1:-1], monotone=False, total=last - first, steps=steps)


def _closed(pieces: "list[Piece]", slope: float, total: float) -> "list[Piece]":
    """The last piece measured from the end, so that the end is met to the bit."""
    piece = pieces[-1]
    if piece.far:
        return pieces
    value, rate, bend, twist = piece.shape(piece.high, 3)
    del value, rate
    shape = Mixed((0.0, slope, -0.5 * bend, twist / 6.0))
    middle = 0.5 * (piece.low + 1.0)
    return [*pieces[:-1], Piece(piece.low, middle, False, piece.shape), Piece(middle, 1.0, True, shape)]


def _cubic(width: float, f0: float, f1: float, v0: float, v1: float) -> "tuple[float, ...]":
    chord = (f1 - f0) / width
    return f0, v0, (3.0 * chord - 2.0 * v0 - v1) / width, (v0 + v1 - 2.0 * chord) / (width * width)


def slopes_through(points: "Sequence[tuple[float, float]]", first: float, last: float) -> "list[float]":
    """Slopes at the points for a continuous second derivative (Thomas)."""
    count = len(points)
    widths = [points[i + 1][0] - points[i][0] for i in range(count - 1)]
    chords = [(points[i + 1][1] - points[i][1]) / widths[i] for i in range(count - 1)]
    upper, right = [0.0], [first]
    for i in range(1, count - 1):
        width, previous = widths[i], widths[i - 1]
        pivot = 2.0 * (width + previous) - width * upper[-1]
        upper.append(previous / pivot)
        right.append((3.0 * (width * chords[i - 1] + previous * chords[i]) - width * right[-1]) / pivot)
    slopes = [last]
    for i in range(count - 2, 0, -1):
        slopes.append(right[i] - upper[i] * slopes[-1])
    slopes.append(first)
    return slopes[::-1]
