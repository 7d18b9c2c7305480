"""The joints along a course: from one posture to the next nearest one, in steps short enough to see a jump."""

from math import hypot, pi, remainder

from dynamics_cli.errors import InadmissibleError, require
from dynamics_cli.numerics.singular_values import Singular
from dynamics_cli.quantities import Size
from dynamics_cli.records import record
from dynamics_cli.robot.arms.chain import Chain, beyond_limits
from dynamics_cli.robot.inverse.postures import Posture, postures_of
from dynamics_cli.robot.inverse.structures import Structure
from dynamics_cli.robot.path.course import Course
from dynamics_cli.robot.velocities import chosen_rows, columns_of, matrix_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

# Steps in which no joint turns farther, and the shortest step: a joint that turns farther in it jumps.
FAR, SHORTEST = 0.08, 1e-7
# The nearest posture is the next one if it is nearer by this factor than any other.
CLEAR = 0.25
# A singular value below this share of the largest is zero.
LOST = 1e-12
# What rounding leaves of the speed of a joint at rest, as a share of the largest.
ROUNDING = 1e-13


@record
class Step:
    """The joints at a share of the way, and their derivatives by it."""

    share: float
    coordinates: "tuple[float, ...]"
    rates: "tuple[float, ...]"
    nearness: float
    """Smallest over largest singular value, lengths as shares of the arm."""
    posture: Posture


@record
class Jump:
    """Where no neighbouring posture goes on."""

    share: float
    joint: str
    turn: float


class Trace:
    """All steps of one way along the course, from one posture at its start."""

    def __init__(self, chain: Chain, structure: Structure, course: Course, start: "Sequence[float]") -> None:
        self.chain, self.structure, self.course = chain, structure, course
        self.steps: list[Step] = []
        self.jumps: list[Jump] = []
        found, _clear = self._nearest(0.0, start)
        self._keep(0.0, found)

    def to(self, share: float) -> Step:
        """Go on to a share of the way."""
        ahead = [share]
        while ahead:
            last, goal = self.steps[-1], ahead[-1]
            if goal <= last.share:
                ahead.pop()
                continue
            step = goal - last.share
            found, clear = self._nearest(
                goal, [old + step * rate for old, rate in zip(last.coordinates, last.rates, strict=True)]
            )
            moves = [
                abs(a - b) / (1.0 if turning else self.structure.size)
                for a, b, turning in zip(found[0], last.coordinates, self.chain.turning, strict=True)
            ]
            if (max(moves) > FAR or not clear) and step > SHORTEST:
                ahead.append(0.5 * (last.share + goal))
                continue
            if max(moves) > FAR:
                joint = moves.index(max(moves))
                self.jumps.append(Jump(goal, self.chain.names[joint], found[0][joint] - last.coordinates[joint]))
            self._keep(goal, found)
            ahead.pop()
        return self.steps[-1]

    @property
    def beyond(self) -> "list[tuple[Step, tuple[str, float, bool]]]":
        """The first step at which each joint is beyond a limit."""
        out: list[tuple[Step, tuple[str, float, bool]]] = []
        for step in self.steps:
            for over in beyond_limits(self.chain, step.coordinates):
                if over[0] not in {known[0] for _, known in out}:
                    out.append((step, over))
        return out

    def _nearest(self, share: float, before: "Sequence[float]") -> "tuple[tuple[tuple[float, ...], Posture], bool]":
        """The posture nearest to what is expected, whole turns chosen, and whether it is clearly nearer than others."""
        ways = []
        for posture in self._postures(share, before):
            turned = tuple(
                old + remainder(new - old, 2.0 * pi) if turning else new
                for new, old, turning in zip(posture.coordinates, before, self.chain.turning, strict=True)
            )
            ways.append((hypot(*(a - b for a, b in zip(turned, before, strict=True))), turned, posture))
        ways.sort(key=lambda way: way[0])
        off, turned, posture = ways[0]
        return (turned, posture), len(ways) == 1 or off < CLEAR * ways[1][0]

    def _postures(self, share: float, before: "Sequence[float]") -> "list[Posture]":
        course = self.course
        try:
            return postures_of(self.structure, course.position(share), course.orientation(share), before)
        except InadmissibleError:
            low, high = (self.steps[-1].share if self.steps else 0.0), share
            while high - low > SHORTEST:
                middle = 0.5 * (low + high)
                try:
                    postures_of(self.structure, course.position(middle), course.orientation(middle), before)
                    low = middle
                except InadmissibleError:
                    high = middle
            require(
                low <= 0.0,
                "the path leaves what the arm reaches {done} after its start, of {length}",
                done=(low * course.length, Size), length=(course.length, Size), code="out-of-reach",
                hint="`robot workspace` shows what it reaches",
            )  # fmt: skip
            raise

    def _keep(self, share: float, found: "tuple[tuple[float, ...], Posture]") -> None:
        coordinates, posture = found
        rates, nearness = self._rates(share, coordinates)
        self.steps.append(Step(share, coordinates, rates, nearness, posture))

    def _rates(self, share: float, coordinates: "Sequence[float]") -> "tuple[tuple[float, ...], float]":
        """Derivatives of the joints by the share of the way, J⁻¹·(p′, θ′), and how near to singular the arm is."""
        chain, size = self.chain, self.structure.size
        rows = chosen_rows(chain)
        scales = [1.0 if turning else size for turning in chain.turning]
        matrix = [
            [value * scale / (size if row < 3 else 1.0) for value, scale in zip(line, scales, strict=True)]
            for row, line in zip(rows, matrix_of(columns_of(chain, coordinates), rows), strict=True)
        ]
        wanted = [*(part / size for part in self.course.tangent(share)), *self.course.turn]
        parts = Singular(matrix)
        rates = [0.0] * len(scales)
        for value, left, right in zip(parts.values, parts.left, parts.right, strict=True):
            if value > LOST * parts.values[0]:
                along = sum(a * wanted[row] for a, row in zip(left, rows, strict=True)) / value
                rates = [rate + along * part for rate, part in zip(rates, right, strict=True)]
        nearness = parts.values[-1] / parts.values[0] if parts.values[0] else 0.0
        least = ROUNDING * max(map(abs, rates))
        return tuple(
            scale * rate if abs(rate) > least else 0.0 for rate, scale in zip(rates, scales, strict=True)
        ), nearness
