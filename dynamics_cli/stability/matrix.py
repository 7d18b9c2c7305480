"""The task `matrix`: stability of ẋ = A·x, or of M·ẍ + (C + G)·ẋ + K·x = 0."""

from dynamics_cli.errors import UsageError, require, require_given
from dynamics_cli.numerics.exact.rational import lowest, reduce_rows, total, written
from dynamics_cli.numerics.exact.whole_polynomials import common_divisor, mirrored, primitive, square_free, times
from dynamics_cli.quantities import Annotated, Count, GrowthRate, InputFile, Matrix, Text
from dynamics_cli.records import Advice, Numerics, record
from dynamics_cli.stability.counting import MARGINAL, REPEATED, Counts, count, verdict
from dynamics_cli.stability.roots import METHOD, Root, root_bounds, roots

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any, TypeAlias

    Pair: TypeAlias = tuple[int, int]
    Rows: TypeAlias = Sequence[Sequence[Pair]]
    Whole: TypeAlias = list[list[int]]

DIVERGENCE = "divergence: a real root grows without oscillation"
FLUTTER = "flutter: a pair grows in oscillation"


@record
class MatrixStability:
    """What the matrices of a linear system say of stability."""

    verdict: Annotated[Text, "Stable, marginal or unstable."]
    growth: Annotated[Text | None, "Divergence or flutter; none where nothing grows."]
    left: Annotated[Count, "Roots in the left half plane."]
    right: Annotated[Count, "Roots in the right half plane."]
    axis: Annotated[Count, "Roots on the imaginary axis."]
    rightmost: Annotated[GrowthRate, "Largest real part of a root [1/s]."]
    roots: Annotated[tuple[Root, ...], "The roots, the rightmost first; of a pair the upper one."]
    polynomial: Annotated[Text, "Coefficients of the characteristic polynomial, from the highest power down, exactly."]
    without_gyroscopic: Annotated[Text | None, "Verdict without the gyroscopic matrix; none where none is given."]
    numerics: Numerics
    advice: tuple[Advice, ...] = ()


def matrix(
    matrix: Annotated[
        Matrix | None, 'A of a first-order system, rows parted by semicolons, e.g. "0, 1; -4, -0.2".'
    ] = None,
    /,
    *,
    mass: Annotated[Matrix | None, "M of a system of second order, e.g. 2, 0; 0, 1."] = None,
    damping: Annotated[Matrix | None, "C, forces in proportion to velocities, e.g. 0.1, 0; 0, 0.2."] = None,
    gyroscopic: Annotated[Matrix | None, "G, skew-symmetric, e.g. 0, -3; 3, 0."] = None,
    stiffness: Annotated[Matrix | None, "K, symmetric or not, e.g. 4, -1; -1, 2."] = None,
    file: Annotated[
        InputFile, "JSON of vibration modes or motion modes, or text with M, C, G, K or A above their rows."
    ] = "",
) -> MatrixStability:
    """Stability of a linear system from its matrices, exactly: up to six by six, from a file up to twelve by twelve.

    Equation
    --------
    det(s·1 − A) = 0, with A = [[0, 1], [−M⁻¹·K, −M⁻¹·(C + G)]] for M·ẍ + (C + G)·ẋ + K·x = 0.

    Returns
    -------
    MatrixStability
        The verdict, the roots and the characteristic polynomial.

    Raises
    ------
    UsageError
        When neither A nor M and K are given, or both, or one of them both typed and in the file.
    InadmissibleError
        When sizes do not fit, the mass matrix is singular, G is not skew-symmetric, or the file has no matrices.

    Notes
    -----
    Repeated roots on the axis are unstable only where the system has fewer modes than roots there; the ranks of the
    matrices decide it exactly.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 14.5 to 14.7; Chetaev, The Stability of
    Motion, Pergamon 1961 (gyroscopic stabilization).

    Examples
    --------
    >>> matrix((((0, 1), (1, 1)), ((-4, 1), (-1, 5)))).verdict
    'asymptotically stable'
    """
    given = {"matrix": matrix, "mass": mass, "damping": damping, "gyroscopic": gyroscopic, "stiffness": stiffness}
    if file:
        given = _with_file(given, file)
    matrix, mass, damping, gyroscopic, stiffness = given.values()
    if matrix is not None:
        extra = [name for name, rows in given.items() if rows is not None and name != "matrix"]
        if extra:
            raise UsageError(f"MATRIX and --{extra[0]} are both given", code="ambiguous",
                             hint="give MATRIX alone, or --mass, --damping, --gyroscopic and --stiffness")  # fmt: skip
        _require_size(matrix, "MATRIX", len(matrix), "a square matrix")
        system = [list(row) for row in matrix]
    else:
        require_given(mass is not None and stiffness is not None, "neither MATRIX nor --mass and --stiffness are given",
                      ("matrix",), ("mass", "stiffness"), ("file",))  # fmt: skip
        system = _first_order(mass, damping, gyroscopic, stiffness)
    counts, judged, p, denominator = _judged(system)
    roots_proved = roots(p)
    plain = None
    if gyroscopic is not None:
        plain = _judged(_first_order(mass, damping, None, stiffness))[1]
    return MatrixStability(
        verdict=judged,
        growth=_growth(roots_proved),
        left=counts.left,
        right=counts.right,
        axis=counts.axis,
        rightmost=roots_proved[0].real,
        roots=roots_proved,
        polynomial=", ".join(written((c, denominator)) for c in reversed(p)),
        without_gyroscopic=plain,
        numerics=Numerics(METHOD, root_bounds(roots_proved, "rightmost")),
        advice=_advice(judged, plain, "" if matrix is not None or damping is not None else "give --damping"),
    )


def _with_file(given: "dict[str, Any]", file: str) -> "dict[str, Any]":
    """The matrices of the file beside those that were typed."""
    from dynamics_cli.stability.matrix_file import read_system

    system = read_system(file, alone=not any(given.values()))
    twice = [name for name in system if given[name] is not None]
    if twice:
        name = "MATRIX" if twice[0] == "matrix" else f"--{twice[0]}"
        raise UsageError(f"{name} is given, and --file has it too", code="ambiguous", hint="leave out one of them")
    return {**given, **system}


def _growth(roots_proved: "Sequence[Root]") -> "str | None":
    growing = [root for root in roots_proved if root.real > 0.0]
    if not growing:
        return None
    kinds = {FLUTTER if root.pair else DIVERGENCE for root in growing}
    return "divergence and flutter" if len(kinds) == 2 else kinds.pop()


def _advice(judged: str, plain: "str | None", remedy: str) -> "tuple[Advice, ...]":
    if plain == "unstable" and judged == MARGINAL and remedy:
        message = "the gyroscopic forces alone hold it: with damping in every direction, however small, it is unstable"
        return (Advice("gyroscopic", message, severity="serious", remedy=f"{remedy} and ask again"),)
    if judged in (MARGINAL, REPEATED):
        message = "roots on the axis are there for the elements exactly as typed: the smallest change moves them"
        return (Advice("axis", message, remedy=f"{remedy} too, if there is any" if remedy else None),)
    return ()


def _require_size(rows: "Rows", name: str, size: int, wanted: str) -> None:
    fits = len(rows) == size and all(len(row) == size for row in rows)
    require(fits, "{name} is {rows} by {columns}, wanted {wanted}", name=name, rows=str(len(rows)),
            columns=str(len(rows[0])), wanted=wanted, code="sizes")  # fmt: skip


def _first_order(
    mass: "Rows | None", damping: "Rows | None", gyroscopic: "Rows | None", stiffness: "Rows | None"
) -> "list[list[Pair]]":
    """A of the positions and velocities."""
    assert mass is not None
    assert stiffness is not None
    size = len(mass)
    alike = f"{size} by {size} as --mass"
    _require_size(mass, "--mass", size, "a square matrix")
    _require_size(stiffness, "--stiffness", size, alike)
    rates: list[list[Pair]] = [[(0, 1)] * size for _ in range(size)]
    for name, rows in (("--damping", damping), ("--gyroscopic", gyroscopic)):
        if rows is not None:
            _require_size(rows, name, size, alike)
            rates = [
                [total((a, b)) for a, b in zip(one, two, strict=True)] for one, two in zip(rates, rows, strict=True)
            ]
    if gyroscopic is not None:
        skew = all(total((gyroscopic[i][j], gyroscopic[j][i]))[0] == 0 for i in range(size) for j in range(size))
        require(skew, "--gyroscopic is not skew-symmetric", code="gyroscopic", hint="its elements below the diagonal "
                "are those above with the other sign; give the rest as --damping")  # fmt: skip
    augmented = [_whole_row([*mass[i], *stiffness[i], *rates[i]]) for i in range(size)]
    reduced, pivots = reduce_rows(augmented)
    require(pivots[:size] == list(range(size)) and len(reduced) == size, "the mass matrix (--mass) is singular",
            code="singular", hint="give every coordinate a mass, or leave it out")  # fmt: skip
    order = sorted(range(size), key=lambda i: pivots[i])
    lower = [[lowest(-cell, reduced[i][pivots[i]]) for cell in reduced[i][size:]] for i in order]
    upper: list[list[Pair]] = [[(int(j == size + i), 1) for j in range(2 * size)] for i in range(size)]
    return [*upper, *lower]


def _whole_row(row: "Sequence[Pair]") -> "list[int]":
    common = _denominator(row)
    return [top * (common // bottom) for top, bottom in row]


def _denominator(cells: "Sequence[Pair]") -> int:
    common = 1
    for _, bottom in cells:
        common *= lowest(bottom, common)[0]
    return common


def _judged(system: "Rows") -> "tuple[Counts, str, tuple[int, ...], int]":
    """Root counts, the verdict, and the characteristic polynomial of ẋ = A·x as whole numbers and their denominator."""
    p = characteristic_of(system)
    whole, below = _whole(system)
    counts = count(p)
    judged = verdict(counts)
    if judged == REPEATED and _complete(p, whole, below):
        judged = MARGINAL
    return counts, judged, p, p[-1]


def characteristic_of(system: "Rows") -> "tuple[int, ...]":
    """det(s·1 − A) from the constant up, as whole numbers without a common factor."""
    whole, below = _whole(system)
    return primitive(c * below**k for k, c in enumerate(_characteristic(whole)))


def _whole(system: "Rows") -> "tuple[Whole, int]":
    """The matrix times its common denominator, and that."""
    below = _denominator([cell for row in system for cell in row])
    return [[top * (below // bottom) for top, bottom in row] for row in system], below


def _characteristic(rows: "Whole") -> "tuple[int, ...]":
    """det(s·1 − B) from the constant up, by Faddeev and Leverrier."""
    size = len(rows)
    out = [0] * size + [1]
    power = [[int(i == j) for j in range(size)] for i in range(size)]
    for k in range(1, size + 1):
        power = _multiplied(rows, power)
        trace = 0
        for i in range(size):
            trace += power[i][i]
        out[size - k] = -trace // k
        for i in range(size):
            power[i][i] += out[size - k]
    return tuple(out)


def _multiplied(first: "Whole", second: "Whole") -> "Whole":
    columns = list(zip(*second, strict=True))
    out = []
    for row in first:
        cells = []
        for column in columns:
            value = 0
            for a, b in zip(row, column, strict=True):
                value += a * b
            cells.append(value)
        out.append(cells)
    return out


def _complete(p: "Sequence[int]", whole: "Whole", below: int) -> bool:
    """Whether every repeated root in pairs ±s, or at zero, has as many modes as roots."""
    for factor, multiplicity in square_free(p):
        if multiplicity == 1:
            continue
        on_axis = common_divisor(factor, mirrored(factor))
        if factor[0] == 0 and on_axis[0] != 0:
            on_axis = times(on_axis, (0, 1))
        if len(on_axis) < 2:
            continue
        once = _evaluated(on_axis, whole, below)
        if _rank(once) != _rank(_multiplied(once, once)):
            return False
    return True


def _evaluated(p: "Sequence[int]", whole: "Whole", below: int) -> "Whole":
    """p(B/below) times below^degree."""
    size, degree = len(whole), len(p) - 1
    total_rows = [[0] * size for _ in range(size)]
    for k in range(degree, -1, -1):
        total_rows = _multiplied(whole, total_rows)
        for i in range(size):
            total_rows[i][i] += p[k] * below ** (degree - k)
    return total_rows


def _rank(rows: "Whole") -> int:
    return len(reduce_rows(rows)[0])
