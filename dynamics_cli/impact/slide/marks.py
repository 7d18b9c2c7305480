"""What a run leaves on the road: marks of its wheels, and the car at equal times."""

from dynamics_cli.impact.slide.motion import Moment, Run
from dynamics_cli.impact.slide.records import PathPoint, WheelMark
from dynamics_cli.impact.slide.wheels import NAMES, Car, Wheel
from dynamics_cli.numerics.elementary import cos, hypot, sin

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    Pair = tuple[float, float]

POINTS = 12
# A wheel braked by this much of its friction leaves a mark, whatever its slip angle.
LOCKED = 0.5
# Slower than this nothing is marked.
CREEP = 1e-3


def at_wheel(wheel: Wheel, moment: Moment) -> "Pair":
    """Where a wheel is."""
    c, s = cos(moment.nose), sin(moment.nose)
    return moment.x + c * wheel.ahead - s * wheel.left, moment.y + s * wheel.ahead + c * wheel.left


def marking(wheel: Wheel, moment: Moment) -> bool:
    """Whether a wheel leaves a mark: locked, or slipping sideways by more than its grip slope."""
    c, s = cos(moment.nose), sin(moment.nose)
    u = c * moment.velocity[0] + s * moment.velocity[1] - moment.spin * wheel.left
    v = c * moment.velocity[1] - s * moment.velocity[0] + moment.spin * wheel.ahead
    along, across = wheel.cosine * u + wheel.sine * v, wheel.cosine * v - wheel.sine * u
    if hypot(along, across) < CREEP:
        return False
    return wheel.share >= LOCKED or across * across > wheel.slope_squared * along * along


def lines(wheel: Wheel, done: Run) -> "list[list[Pair]]":
    """The marks of a wheel, broken where it does not slip."""
    pieces: list[list[Pair]] = [[]]
    for moment in done.moments:
        if marking(wheel, moment) or (moment is done.end and pieces[-1]):
            pieces[-1].append(at_wheel(wheel, moment))
        elif pieces[-1]:
            pieces.append([])
    return [piece for piece in pieces if len(piece) > 1]


def marks(car: Car, done: Run) -> "tuple[WheelMark, ...]":
    """Each wheel: its share of the energy, its mark, and where it stands at rest."""
    total = sum(done.end.work)
    listed = []
    for index, wheel in enumerate(car.wheels):
        length = 0.0
        before = at_wheel(wheel, done.moments[0])
        marked = marking(wheel, done.moments[0])
        for moment in done.moments[1:]:
            here, marks_here = at_wheel(wheel, moment), marking(wheel, moment)
            if marked or marks_here:
                length += hypot(here[0] - before[0], here[1] - before[1])
            before, marked = here, marks_here
        share = min(done.end.work[index] / total, 1.0)
        listed.append(WheelMark(NAMES[index], wheel.share, share, length, before))
    return tuple(listed)


def points(done: Run, heading: "Callable[[float], float]") -> "tuple[PathPoint, ...]":
    """The car at equal times, its nose written by `heading`."""
    listed = []
    for index in range(POINTS + 1):
        time = done.end.time * index / POINTS
        x, y, nose = done.at(time)
        listed.append(PathPoint(time, (x, y), heading(nose)))
    return tuple(listed)
