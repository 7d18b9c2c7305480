"""Small matrices of exact numbers: determinant, inverse, products and linear equations as ratios of whole numbers."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.rational import lowest, nearest, product, total, written
from dynamics_cli.quantities import Annotated, Count, Matrix, MatrixOfNumbers, Ratio, Text
from dynamics_cli.records import Advice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.exact.rational import Pair

    Rows = tuple[tuple[Pair, ...], ...]

# Beyond this an inverse in three-digit data means little.
ILL_CONDITIONED = 1e6


@record
class MatrixAnswer:
    """Results for one or two matrices, as decimals and as exact ratios."""

    rank: Annotated[Count, "Number of independent rows."]
    determinant: Annotated[Ratio | None, "Determinant of a square matrix [-]."]
    determinant_exact: Annotated[Text | None, "The determinant as a ratio of whole numbers."]
    inverse: Annotated[MatrixOfNumbers | None, "Inverse, if the matrix is not singular."]
    inverse_exact: Annotated[Text | None, "The inverse in ratios, rows separated by semicolons."]
    condition: Annotated[Ratio | None, "Condition number: norm of the matrix times that of its inverse (row sums) [-]."]
    transpose: Annotated[MatrixOfNumbers, "Rows and columns exchanged."]
    sum: Annotated[MatrixOfNumbers | None, "The sum with the matrix to add."]
    sum_exact: Annotated[Text | None, "The sum in ratios."]
    product: Annotated[MatrixOfNumbers | None, "The product, with the second matrix on the right."]
    product_exact: Annotated[Text | None, "The product in ratios."]
    solution: Annotated[MatrixOfNumbers | None, "x of A·x = b, one row for each unknown."]
    solution_exact: Annotated[Text | None, "The solution in ratios."]
    advice: tuple[Advice, ...] = ()


def matrix(
    matrix: Annotated[Matrix, 'Rows separated by semicolons, such as "2, 1; 1, 3".'],
    /,
    *,
    plus: Annotated[Matrix | None, "A matrix to add."] = None,
    times: Annotated[Matrix | None, "A matrix to multiply by, on the right."] = None,
    right_hand: Annotated[Matrix | None, "The right-hand side b of A·x = b, e.g. 3, 5."] = None,
) -> MatrixAnswer:
    """Determinant, inverse, sum, product and linear equations of matrices up to six by six, exactly.

    Equation
    --------
    A⁻¹·A = 1 and A·x = b by elimination in ratios of whole numbers.

    Raises
    ------
    InadmissibleError
        When sizes do not fit, or equations have no solution or many.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 2.10.

    Examples
    --------
    >>> matrix((((2, 1), (1, 1)), ((1, 1), (3, 1)))).determinant
    5.0
    """
    size, width = len(matrix), len(matrix[0])
    square = size == width
    identity = tuple(tuple((int(i == j), 1) for j in range(size)) for i in range(size))
    determinant, reduced, rank = _eliminated(matrix, identity)
    regular = square and rank == size
    inverse = reduced if regular else None
    added = _added(matrix, plus) if plus is not None else None
    multiplied = _multiplied(matrix, times) if times is not None else None
    solution = _solution(matrix, right_hand) if right_hand is not None else None
    condition = nearest(product(_norm(matrix), _norm(inverse))) if inverse is not None else None
    return MatrixAnswer(
        rank=rank,
        determinant=nearest(determinant) if square else None,
        determinant_exact=written(determinant) if square else None,
        inverse=_decimals(inverse),
        inverse_exact=_texts(inverse),
        condition=condition,
        transpose=tuple(tuple(nearest(cell) for cell in row) for row in zip(*matrix, strict=True)),
        sum=_decimals(added),
        sum_exact=_texts(added),
        product=_decimals(multiplied),
        product_exact=_texts(multiplied),
        solution=_decimals(solution),
        solution_exact=_texts(solution),
        advice=_advice(square, rank, size, condition),
    )


def _advice(square: bool, rank: int, size: int, condition: "float | None") -> "tuple[Advice, ...]":
    if square and rank < size:
        message = f"the matrix is singular: {rank} of its {size} rows are independent, so that there is no inverse"
        return (Advice("singular", message, severity="note", result="inverse"),)
    if condition is not None and condition > ILL_CONDITIONED:
        message = f"a relative error in the matrix or the right-hand side may grow {condition:.2g} times"
        return (
            Advice("condition", message, remedy="the answer is exact for the numbers as typed: type all known digits"),
        )
    return ()


def _eliminated(left: "Rows", right: "Rows") -> "tuple[Pair, Rows, int]":
    """Determinant (of a square matrix), the reduced right side, and the rank, by exact elimination."""
    rows = [[lowest(*cell) for cell in (*a, *b)] for a, b in zip(left, right, strict=True)]
    width = len(left[0])
    determinant: Pair = (1, 1)
    rank = 0
    for column in range(width):
        pivot = next((i for i in range(rank, len(rows)) if rows[i][column][0]), None)
        if pivot is None:
            determinant = (0, 1)
            continue
        if pivot != rank:
            rows[rank], rows[pivot] = rows[pivot], rows[rank]
            determinant = (-determinant[0], determinant[1])
        top, bottom = rows[rank][column]
        determinant = product(determinant, (top, bottom))
        chosen = rows[rank] = [product(cell, (bottom, top)) for cell in rows[rank]]
        for i, row in enumerate(rows):
            if i != rank and row[column][0]:
                up, down = row[column]
                rows[i] = [
                    total((cell, product((-up, down), reduced))) for cell, reduced in zip(row, chosen, strict=True)
                ]
        rank += 1
    return determinant, tuple(tuple(row[width:]) for row in rows), rank


def _added(first: "Rows", second: "Rows") -> "Rows":
    fits = len(first) == len(second) and len(first[0]) == len(second[0])
    require(fits, "a {first} matrix and a {other} matrix cannot be added", **_sizes(first, second), code="sizes",
            hint="give matrices of one size")  # fmt: skip
    return tuple(tuple(total(pair) for pair in zip(a, b, strict=True)) for a, b in zip(first, second, strict=True))


def _multiplied(first: "Rows", second: "Rows") -> "Rows":
    require(len(first[0]) == len(second), "a {first} matrix cannot multiply a {other} matrix", **_sizes(first, second),
            code="sizes", hint="the first must have as many columns as the second has rows")  # fmt: skip
    columns = tuple(zip(*second, strict=True))
    return tuple(
        tuple(total(product(a, b) for a, b in zip(row, column, strict=True)) for column in columns) for row in first
    )


def _sizes(first: "Rows", second: "Rows") -> "dict[str, str]":
    return {"first": f"{len(first)} by {len(first[0])}", "other": f"{len(second)} by {len(second[0])}"}


def _solution(a: "Rows", b: "Rows") -> "Rows":
    # numbers in one row are a column
    b = tuple((cell,) for cell in b[0]) if len(b) == 1 and len(a) > 1 else b
    require(len(a) == len(b), "a {first} matrix and a {other} right-hand side do not fit", **_sizes(a, b), code="sizes",
            hint="give as many numbers as the matrix has rows")  # fmt: skip
    _, reduced, rank = _eliminated(a, b)
    consistent = not any(cell[0] for row in reduced[rank:] for cell in row)
    require(consistent, "the equations contradict each other: {rank} of {count} are independent",
            rank=str(rank), count=str(len(a)), code="inconsistent", hint="check the numbers")  # fmt: skip
    require(rank == len(a[0]), "the equations leave {free} of {count} unknowns free",
            free=str(len(a[0]) - rank), count=str(len(a[0])), code="undetermined",
            hint="give as many independent equations as unknowns")  # fmt: skip
    return reduced[:rank]


def _norm(rows: "Rows") -> "Pair":
    """The largest sum of sizes along a row."""
    sums = [total((abs(top), bottom) for top, bottom in row) for row in rows]
    largest = sums[0]
    for row_sum in sums[1:]:
        largest = row_sum if row_sum[0] * largest[1] > largest[0] * row_sum[1] else largest
    return largest


def _decimals(rows: "Rows | None") -> "tuple[tuple[float, ...], ...] | None":
    return None if rows is None else tuple(tuple(nearest(cell) for cell in row) for row in rows)


def _texts(rows: "Rows | None") -> "str | None":
    return None if rows is None else "; ".join(", ".join(written(cell) for cell in row) for row in rows)
