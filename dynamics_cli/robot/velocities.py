"""The columns of an arm's Jacobian, and what its singular values say, free of units."""

from math import hypot

from dynamics_cli.numerics.singular_values import Singular
from dynamics_cli.numerics.vectors import Vector, cross, subtract
from dynamics_cli.records import record
from dynamics_cli.robot.arms.chain import Chain
from dynamics_cli.robot.pose import is_planar

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    Columns = list[tuple[Vector, Vector]]

# Smallest singular value over the largest, lengths as shares of the arm: below the first an arm is singular, below the
# second nearly so.
SINGULAR, CLOSE = 1e-12, 1e-2
# What rounding leaves of a distance, as a share of the arm's size.
ROUNDING = 4e-15
NOTHING = (0.0, 0.0, 0.0)


def columns_of(chain: Chain, coordinates: "Sequence[float]") -> "Columns":
    """Velocity and angular velocity of the hand for each joint at unit speed, in base axes.

    References
    ----------
    Partial velocities: Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 19.5 and 19.12.
    """
    links = chain.links(coordinates)
    hand = chain.hand(links).position
    columns: Columns = []
    for frame, turning in zip(chain.axes(links), chain.turning, strict=True):
        arm = cross(frame.z, subtract(hand, frame.position))
        columns.append((arm, frame.z) if turning else (frame.z, NOTHING))
    return columns


def without_rounding(chain: Chain, columns: "Columns") -> "Columns":
    """The columns, of joints on whose axes the hand is without what rounding leaves of a distance."""
    least = ROUNDING * chain.reach
    return [(linear if hypot(*linear) >= least else NOTHING, angular) for linear, angular in columns]


def chosen_rows(chain: Chain) -> "tuple[int, ...]":
    """Which of x, y, z and the turns about them the arm can choose, by the number and the directions of its joints."""
    turns, slides = chain.turning.count(True), chain.turning.count(False)
    if is_planar(chain):
        return ((0, 1) if turns > 1 else ()) + ((2,) if slides else ()) + ((5,) if turns != 2 else ())
    return (0, 1, 2) if turns + slides <= 3 else (0, 1, 2, 3, 4, 5)


def matrix_of(columns: "Columns", rows: "Sequence[int]") -> "list[list[float]]":
    """These rows of the Jacobian."""
    return [[(*linear, *angular)[row] for linear, angular in columns] for row in rows]


@record
class Rank:
    """Singular values of the rows that an arm can choose, lengths as shares of its size, and what they leave out."""

    nearness: float
    """The smallest over the largest."""
    lost: "tuple[Vector, Vector] | None"
    """Where singular: all velocities of the hand, in these parts, have a sum of products of zero with these two."""
    idle: "tuple[float, ...] | None"
    """Speeds of joints that leave the hand at rest; None where there are none, or several independent ones."""

    @property
    def singular(self) -> bool:
        """Whether a motion is lost."""
        return self.nearness < SINGULAR


def rank_of(chain: Chain, columns: "Columns") -> Rank:
    """Singular values that do not depend on units: lengths are divided by the size of the arm."""
    rows, size = chosen_rows(chain), chain.reach or 1.0
    scaled = [
        [value / size if turning and row < 3 else value for value, turning in zip(line, chain.turning, strict=True)]
        for row, line in zip(rows, matrix_of(columns, rows), strict=True)
    ]
    values = Singular(scaled)
    nearness = values.values[-1] / values.values[0] if values.values[0] else 0.0
    singular = nearness < SINGULAR
    lost = None
    if singular and len(rows) <= len(columns):
        parts = [0.0] * 6
        for row, part in zip(rows, values.left[-1], strict=True):
            parts[row] = part
        lost = (parts[0], parts[1], parts[2]), (parts[3], parts[4], parts[5])
    kept = values.right[: -1 if singular else None]
    return Rank(nearness=nearness, lost=lost, idle=idle_of(kept, len(columns)))


def idle_of(kept: "Sequence[Sequence[float]]", count: int) -> "tuple[float, ...] | None":
    """The one direction at right angles to some others, its largest part 1."""
    if count - len(kept) != 1:
        return None
    best: list[float] = []
    for index in range(count):
        way = [float(index == k) for k in range(count)]
        for _ in range(2):
            for other in kept:
                along = sum(a * b for a, b in zip(way, other, strict=True))
                way = [a - along * b for a, b in zip(way, other, strict=True)]
        if not best or sum(a * a for a in way) > sum(a * a for a in best):
            best = way
    largest = max(best, key=abs)
    return tuple(a / largest for a in best)


def determinant(matrix: "Sequence[Sequence[float]]") -> float:
    """Determinant of a small matrix, by elimination with pivots."""
    rows = [list(row) for row in matrix]
    size, product = len(rows), 1.0
    for column in range(size):
        best = max(range(column, size), key=lambda row: abs(rows[row][column]))
        pivot = rows[best][column]
        if pivot == 0.0:
            return 0.0
        if best != column:
            rows[column], rows[best] = rows[best], rows[column]
            product = -product
        product *= pivot
        for row in range(column + 1, size):
            factor = rows[row][column] / pivot
            rows[row] = [a - factor * b for a, b in zip(rows[row], rows[column], strict=True)]
    return product
