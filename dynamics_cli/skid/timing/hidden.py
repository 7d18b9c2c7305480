"""Sight past an obstruction that moves, or that has an end: when the line from eye to target crosses it."""

from itertools import pairwise

from dynamics_cli.errors import require_given
from dynamics_cli.numerics.elementary import cos, sin
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.polynomials import product
from dynamics_cli.numerics.road.phases import Phase
from dynamics_cli.quantities import Angle, Annotated, RoadSpeed
from dynamics_cli.records import record
from dynamics_cli.skid.timing.courses import Course, crossings
from dynamics_cli.skid.timing.timeline import EndSpeed, StartSpeed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Poly = list[Any]


@record
class Obstruction:
    """An obstruction between the two: its motion up to the moment of the impact, and its size."""

    phases: Annotated[Phase | tuple[Phase, ...], "Its phases up to the moment of the impact, in order of time."]
    start_speed: Annotated[RoadSpeed | None, "Its speed where the first phase begins [m/s]."] = None
    end_speed: Annotated[RoadSpeed | None, "Its speed at the moment of the impact, in place of it [m/s]."] = None
    heading: Annotated[
        Angle,
        "Its direction of travel from that of the first, toward the second's: 0 deg the same, 180 deg oncoming [rad].",
    ] = 0.0

    @property
    def known(self) -> StartSpeed | EndSpeed:
        """The speed that is given."""
        require_given(
            (self.start_speed is None) != (self.end_speed is None), "the obstruction needs one speed",
            ("obstruction.end_speed",), ("obstruction.start_speed",),
        )  # fmt: skip
        if self.start_speed is not None:
            return StartSpeed(self.start_speed)
        assert self.end_speed is not None
        return EndSpeed(self.end_speed)


class Wall:
    """An obstruction as a line back from its corner; all places as polynomials of the time."""

    def __init__(self, before: float, aside: float, heading: float, length: "float | None", crossing: float) -> None:
        self.before = before
        self.aside = aside
        self.along, self.across = cos(heading), sin(heading)
        self.length = length
        self.target = cos(crossing), sin(crossing)

    def terms(self, eye: "Poly", target: "Poly", mover: "Poly") -> "tuple[Poly, Poly, Poly, Poly, Poly]":
        """The deciding functions: remaining distances of eye, target and obstruction give five determinants.

        Sides of eye and target to the wall's line; how the line of sight runs to the wall; its two ends to the line.
        """
        before = added([self.before], mover, self.along)
        aside = added([self.aside], mover, self.across)
        beyond = added(eye, before, -1.0)
        first = added(
            scaled(product(beyond, target), -self.target[1]), product(aside, added(eye, target, -self.target[0])), 1.0
        )
        run = added(scaled(target, -self.along * self.target[1]), added(eye, target, -self.target[0]), -self.across)
        eye_side = added(scaled(aside, self.along), beyond, self.across)
        target_side = added(eye_side, run, 1.0)
        last = first if self.length is None else added(first, run, -self.length)
        return eye_side, target_side, run, first, last

    def hides(self, eye: float, target: float, mover: float) -> bool:
        """Whether the line of sight crosses the wall, eye, target and obstruction being so far from the impact."""
        terms = self.terms([eye], [target], [mover])
        eye_side, target_side, run, first, last = (float(plain(part[0])) for part in terms)
        return eye_side * target_side < 0.0 and first * run >= 0.0 and (self.length is None or last * run <= 0.0)


def scaled(poly: "Poly", by: "Any") -> "Poly":
    """A polynomial times a number."""
    return [by * part for part in poly]


def added(poly: "Poly", other: "Poly", by: "Any") -> "Poly":
    """Poly + by·other, coefficients from the constant up."""
    size = max(len(poly), len(other))
    padded = [[*part, *[0.0] * (size - len(part))] for part in (poly, other)]
    return [a + by * b for a, b in zip(*padded, strict=True)]


def openings(
    wall: Wall, eye_course: Course, target_course: Course, mover: "Course | None", eye_behind: float, begin: float
) -> "list[tuple[Any, bool]]":
    """Times before the impact at which the sight opens or closes, and which it does."""
    courses = [eye_course, target_course] if mover is None else [eye_course, target_course, mover]

    def decisive(*places: "Poly") -> "list[Poly]":
        eye, target = added([eye_behind], places[0], -1.0), scaled(places[1], -1.0)
        eye_side, target_side, _, first, last = wall.terms(
            eye, target, scaled(places[2], -1.0) if mover is not None else [0.0]
        )
        return [eye_side, target_side, first, last][: 3 if wall.length is None else 4]

    def hidden(time: float) -> bool:
        eye, target, *rest = (-course.at(time)[0] for course in courses)
        return wall.hides(eye + eye_behind, target, rest[0] if rest else 0.0)

    times = crossings(courses, decisive, begin, 0.0)
    if not times:
        return []
    edges = [begin, *(plain(time) for time in times), 0.0]
    states = [hidden(0.5 * (low + high)) for low, high in pairwise(edges)]
    return [(time, was) for time, (was, now) in zip(times, pairwise(states), strict=True) if was != now]


def past_corner(before: float, aside: float, eye_behind: float, crossing: float) -> "Callable[[Poly, Poly], Poly]":
    """How far the line of sight passes a corner that stands, above zero where it is free.

    The function takes the courses' polynomials, in which distances still to go are less than zero.
    """
    across, along = sin(crossing), cos(crossing)

    def cleared(eye: "Poly", target: "Poly") -> "Poly":
        back = [eye_behind - eye[0], *(-part for part in eye[1:])]
        negated = [-part for part in target]
        beyond = [back[0] - before, *back[1:]]
        hidden = product(beyond, negated)
        clear = [0.0] * len(hidden)
        for index, part in enumerate(back):
            clear[index] = clear[index] + aside * part
        for index, part in enumerate(negated):
            clear[index] = clear[index] - aside * along * part
        return [a - across * b for a, b in zip(clear, hidden, strict=True)]

    return cleared


def within(distance: float, eye_behind: float, crossing: float) -> "Callable[[Poly, Poly], Poly]":
    """How far the target is within a distance of the eye, as a difference of squares; above zero where it is.

    The function takes the courses' polynomials, as that of `past_corner` does.
    """
    along = cos(crossing)

    def nearer(eye: "Poly", target: "Poly") -> "Poly":
        back = [eye_behind - eye[0], *(-part for part in eye[1:])]
        left = [-part for part in target]
        apart = added(added(product(back, back), product(left, left), 1.0), product(back, left), -2.0 * along)
        return [distance * distance - apart[0], *(-part for part in apart[1:])]

    return nearer


def both(past: "list[tuple[Any, bool]]", near: "list[tuple[Any, bool]]") -> "tuple[list[tuple[Any, bool]], str | None]":
    """When the sight is free past the corner and near enough at once, and what opened it last.

    Each list has one's changes in order of time; without any it is open all the while.
    """
    named = [(plain(time), time, opens, 0) for time, opens in past] + [(plain(t), t, opens, 1) for t, opens in near]
    free = [not (changes and changes[0][1]) for changes in (past, near)]
    times: list[tuple[Any, bool]] = []
    cause: str | None = None
    for _, time, opens, which in sorted(named, key=lambda entry: entry[0]):
        was = all(free)
        free[which] = opens
        if all(free) != was:
            times.append((time, opens))
            cause = ("corner", "recognition distance")[which] if opens else cause
    return times, cause
