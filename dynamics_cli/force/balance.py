"""Equations of equilibrium, solved exactly: the reactions, a motion that is free, or the surplus of unknowns."""

from dynamics_cli.errors import worded
from dynamics_cli.force import ratios
from dynamics_cli.force.supports import PLANE, SPACE
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.exact.rational import lowest, nearest, reduce_rows
from dynamics_cli.quantities import Length

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.force.ratios import Ratios
    from dynamics_cli.force.supports import Unknown
    from dynamics_cli.numerics.exact.rational import Pair

NO_UNKNOWNS = float("inf")


class Balance:
    """Unknowns of the supports against a load, in the plane or in space.

    `values`: the unknowns, where they have one solution; `rank`: how many of the `equations` are independent;
    `consistent`: whether the supports can carry this load at all; `motions`: the motions that they leave free.
    """

    __slots__ = ("consistent", "equations", "motions", "rank", "rows", "unknowns", "values")

    def __init__(self, unknowns: "Sequence[Unknown]", force: "Ratios", moment: "Ratios", *, planar: bool) -> None:
        self.rows = PLANE if planar else SPACE
        self.equations = len(self.rows)
        self.unknowns = unknowns
        columns = [[unknown.column[row] for row in self.rows] for unknown in unknowns]
        load = [(*force, *moment)[row] for row in self.rows]
        against = [(-top, bottom) for top, bottom in load]
        count = len(columns)
        reduced, pivots = reduce_rows([_whole([*line, right]) for *line, right in zip(*columns, against, strict=True)])
        self.consistent = count not in pivots
        self.rank = sum(pivot < count for pivot in pivots)
        self.values: list[Pair] | None = None
        if self.consistent and self.rank == count:
            self.values = [lowest(row[-1], row[place]) for place, row in enumerate(reduced)]
        self.motions = _motions(columns, self.equations)
        # a motion that the load drives comes first: messages name it
        self.motions.sort(key=lambda motion: not any_work(motion, load))

    @property
    def excess(self) -> int:
        """The number of unknowns that equilibrium does not determine."""
        return len(self.unknowns) - self.rank

    def least_singular_value(self, spread: float) -> float:
        """A lower bound of the least singular value of the equations, their columns scaled to length one."""
        if len(self.unknowns) != self.equations:
            return NO_UNKNOWNS
        columns = []
        for unknown in self.unknowns:
            length = ratios.size(unknown.axis) * (spread if unknown.couple else 1.0)
            scale = ratios.of_number(1.0 / length)
            arm = ratios.of_number(1.0 / spread)
            column = [*ratios.times(scale, unknown.force), *ratios.times(arm, ratios.times(scale, unknown.moment))]
            columns.append([column[row] for row in self.rows])
        identity = [[(int(i == j), 1) for j in range(self.equations)] for i in range(self.equations)]
        rows = [_whole([*left, *right]) for left, right in zip(zip(*columns, strict=True), identity, strict=True)]
        reduced, _ = reduce_rows(rows)
        inverse = [nearest((value, row[i])) for i, row in enumerate(reduced) for value in row[self.equations :]]
        return 1.0 / sqrt(sum(value * value for value in inverse))


def any_work(motion: "Sequence[Pair]", load: "Sequence[Pair]") -> bool:
    """Whether the load does work in a motion."""
    work = sum(
        a[0] * b[0] * _other_denominators(motion, load, i) for i, (a, b) in enumerate(zip(motion, load, strict=True))
    )
    return work != 0


def _other_denominators(motion: "Sequence[Pair]", load: "Sequence[Pair]", left_out: int) -> int:
    product = 1
    for i, (a, b) in enumerate(zip(motion, load, strict=True)):
        if i != left_out:
            product *= a[1] * b[1]
    return product


def _whole(line: "Sequence[Pair]") -> "list[int]":
    """A row of ratios as whole numbers, over a common denominator."""
    common = 1
    for _, bottom in line:
        common = common * bottom // _gcd(common, bottom)
    return [top * (common // bottom) for top, bottom in line]


def _gcd(a: int, b: int) -> int:
    while b:
        a, b = b, a % b
    return a


def _motions(columns: "Sequence[Sequence[Pair]]", equations: int) -> "list[list[Pair]]":
    """Motions in which no support does work: velocity of the origin, then angular velocity."""
    reduced, pivots = reduce_rows([_whole(column) for column in columns])
    motions = []
    for free in (column for column in range(equations) if column not in pivots):
        motion: list[Pair] = [(int(column == free), 1) for column in range(equations)]
        for place, row in zip(pivots, reduced, strict=True):
            motion[place] = lowest(-row[free], row[place])
        motions.append(motion)
    return motions


def described(motion: "Sequence[Pair]", *, planar: bool) -> str:
    """A motion in words: it turns about a point or an axis, or it slides."""
    speed: Ratios
    turning: Ratios
    if planar:
        speed, turning = (motion[0], motion[1], ratios.ZERO), (ratios.ZERO, ratios.ZERO, motion[2])
    else:
        speed, turning = (motion[0], motion[1], motion[2]), (motion[3], motion[4], motion[5])
    if ratios.is_zero(turning):
        return worded("it slides along {line}", line=_line(speed, planar=planar))
    top, bottom = ratios.dot(turning, turning)
    x, y, z = ratios.rounded(ratios.times((bottom, top), ratios.cross(turning, speed)))
    if planar:
        return worded("it turns about the point {x}, {y}", x=(x, Length), y=(y, Length))
    return worded(
        "it {twist} about the axis through {x}, {y}, {z} along {line}",
        twist="turns and slides" if ratios.dot(turning, speed)[0] else "turns",
        x=(x, Length), y=(y, Length), z=(z, Length), line=_line(turning, planar=False),
    )  # fmt: skip


def _line(direction: "Ratios", *, planar: bool) -> str:
    """A direction by the name of its axis, or by its cosines."""
    for axis, name in zip(ratios.AXES, "xyz", strict=True):
        if ratios.is_zero(ratios.cross(direction, axis)):
            return name
    size = ratios.size(direction)
    components = ratios.rounded(direction)[: 2 if planar else 3]
    return ", ".join(f"{component / size:.4g}" for component in components)
