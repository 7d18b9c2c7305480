"""Links in a plane with limits: which points they reach, with which angles, and the arcs that can be the border."""

from cmath import exp, phase
from itertools import product
from math import acos, pi, remainder

from dynamics_cli.records import record
from dynamics_cli.robot.inverse.subproblems import Gap, two_links

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

TURN = 2.0 * pi
# Angles this little beyond a limit are at it; links this short, as a share of all, have no length; postures nearer
# than the last are one.
EDGE, SHORT, ALIKE = 1e-12, 1e-12, 1e-9
FOLDS = (0.0, pi)


@record
class PlanarArm:
    """Two or three links that turn in a plane: where each is at zero, and between which angles each turns."""

    links: "tuple[complex, ...]"
    limits: "tuple[tuple[float, float], ...]"
    base: complex = 0j

    @property
    def size(self) -> float:
        """All links in line."""
        return sum(map(abs, self.links))

    def point(self, angles: "Sequence[float]") -> complex:
        """Where the end is."""
        place, turned = self.base, 0.0
        for link, angle in zip(self.links, angles, strict=True):
            turned += angle
            place += link * exp(1j * turned)
        return place

    def within(self, angles: "Sequence[float]") -> "tuple[float, ...] | None":
        """The angles, by whole turns between their limits, the nearest to zero; None where one cannot be."""
        out = []
        for angle, (low, high) in zip(angles, self.limits, strict=True):
            start = remainder(angle, TURN)
            turns = sorted((start + TURN * count for count in range(-2, 3)), key=abs)
            fits = [turn for turn in turns if low - EDGE <= turn <= high + EDGE]
            if not fits:
                return None
            out.append(min(max(fits[0], low), high))
        return tuple(out)

    def postures(self, target: complex) -> "list[tuple[float, ...]]":
        """Angles at which the end is at a point.

        Of three links these are the ends of the family of postures: a joint is at a limit, or two links are in line
        with each other or with the point. A point that has none of them is out of reach, for any family ends so.
        """
        way = target - self.base
        ways = _two(self.links, way) if len(self.links) == 2 else self._three(way)
        kept: list[tuple[float, ...]] = []
        for angles in ways:
            fits = self.within(angles)
            if fits is not None and not any(_same(fits, other) for other in kept):
                kept.append(fits)
        return kept

    def _three(self, way: complex) -> "Iterator[tuple[float, ...]]":
        one, two, three = self.links
        lows = [{angle for angle in pair if abs(angle) < 1e9} for pair in self.limits]
        bend = phase(two) - phase(three)
        l1, l2, l3, far = abs(one), abs(two), abs(three), abs(way)
        thirds = lows[2] | {bend, bend + pi}
        for span in (abs(far - l1), far + l1):
            # the last joint turns back where the first two and the point are in line
            cosine = (span * span - l2 * l2 - l3 * l3) / (2.0 * l2 * l3)
            if abs(cosine) <= 1.0:
                thirds |= {bend + acos(cosine), bend - acos(cosine)}
        for third in thirds:
            for a, b in _two((one, two + three * exp(1j * third)), way):
                yield a, b, third
        for second in lows[1]:
            turn = exp(1j * second)
            for a, b in _two((one + two * turn, three * turn), way):
                yield a, second, b
        for first in lows[0]:
            turn = exp(1j * first)
            for a, b in _two((two, three), way / turn - one):
                yield first, a, b

    def reaches(self, target: complex) -> bool:
        """Whether the end can be at a point."""
        way = target - self.base
        ways = _two(self.links, way) if len(self.links) == 2 else self._three(way)
        return any(self.within(angles) is not None for angles in ways)

    def arcs(self) -> "list[Arc]":
        """Every arc that can be a border: joints before one are at limits, those after it at limits or in line.

        On a border the end can move along it alone: all joints that are not at a limit are in line with the end.
        """
        out = []
        for free in range(len(self.links)):
            before = [[angle for angle in pair if abs(angle) < 1e9] for pair in self.limits[:free]]
            after = len(self.links) - free - 1
            for start in product(*before):
                for choices in product(range(4), repeat=after):
                    arc = self._arc(free, start, choices)
                    if arc is not None:
                        out.append(arc)
        return out

    def _arc(self, free: int, start: "Sequence[float]", choices: "Sequence[int]") -> "Arc | None":
        """Of the joints after the free one, 0 and 1 are its limits, 2 and 3 in line: stretched and folded."""
        later = self._later(free, choices)
        if later is None:
            return None
        lever = PlanarArm(self.links[free:], ()).point((0.0, *later))
        if abs(lever) < SHORT * self.size:
            return None
        low, high = self.limits[free]
        if high - low >= TURN - EDGE:
            low, high = 0.0, TURN
        centre = self.base + PlanarArm(self.links[:free], ()).point(start)
        ahead = phase(lever) + sum(start)
        singular = free == 0 and min(choices, default=2) > 1
        return Arc(centre, abs(lever), low + ahead, high + ahead, singular, later)

    def _later(self, free: int, choices: "Sequence[int]") -> "tuple[float, ...] | None":
        """Angles of the joints after the free one: what is rigid from one free joint to the next is in line."""
        later: list[float] = []
        ahead = _rigid(self.links[free:], self.limits[free + 1 :], choices)
        for number, choice in enumerate(choices):
            if choice < 2:
                later.append(self.limits[free + 1 + number][choice])
                if ahead is None or abs(later[-1]) > 1e9:
                    return None
                ahead = ahead[0], ahead[1] - later[-1]
                continue
            at = free + 1 + number
            body = _rigid(self.links[at:], self.limits[at + 1 :], choices[number + 1 :])
            if ahead is None or body is None:
                return None
            angle = ahead[1] - body[1] + FOLDS[choice - 2]
            found = PlanarArm((1.0,), (self.limits[at],)).within((angle,))
            if found is None:
                return None
            later += found
            ahead = body
        return tuple(later)


@record
class Arc:
    """Part of a circle, counter-clockwise."""

    centre: complex
    radius: float
    start: float
    end: float
    singular: bool = False
    """Whether on it the links are in line, every joint free."""
    later: "tuple[float, ...]" = ()
    """Angles of the joints after the one that turns on it."""

    def at(self, angle: float) -> complex:
        """The point at an angle."""
        return self.centre + self.radius * exp(1j * angle)

    @property
    def middle(self) -> float:
        """Half way."""
        return 0.5 * (self.start + self.end)

    def part(self, start: float, end: float) -> "Arc":
        """A part of it."""
        return Arc(self.centre, self.radius, start, end, self.singular, self.later)

    def inside(self, angle: float) -> float | None:
        """An angle by whole turns on the arc, if it is on it."""
        turned = self.start + (angle - self.start) % TURN
        return turned if turned <= self.end else None


def _rigid(
    links: "Sequence[complex]", limits: "Sequence[tuple[float, float]]", choices: "Sequence[int]"
) -> "tuple[float, float] | None":
    """Length and direction of a link with those after it whose joints are at limits; None without a length."""
    vector, turned, size = links[0], 0.0, abs(links[0])
    for link, limit, choice in zip(links[1:], limits, choices, strict=False):
        if choice > 1:
            break
        turned += limit[choice]
        size += abs(link)
        vector += link * exp(1j * turned) if abs(turned) < 1e9 else 0.0
    return (abs(vector), phase(vector)) if abs(vector) > SHORT * size else None


def _two(links: "tuple[complex, ...]", way: complex) -> "list[tuple[float, ...]]":
    if min(map(abs, links)) < SHORT * sum(map(abs, links)):
        return []
    ways = two_links(links[0], links[1], way)
    return [] if isinstance(ways, Gap) else [(elbow.first, elbow.second) for elbow in ways]


def _same(first: "Sequence[float]", second: "Sequence[float]") -> bool:
    return all(abs(remainder(a - b, TURN)) < ALIKE for a, b in zip(first, second, strict=True))
