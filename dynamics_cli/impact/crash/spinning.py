"""A slide with spin after the impact: the motion at the separation from the rest position and the nose there."""

from dynamics_cli.errors import require
from dynamics_cli.impact.conventions import direction_of, heading_of
from dynamics_cli.impact.crash.scene import CrashScene, CrashVehicle, surface_friction
from dynamics_cli.impact.slide.marks import lines
from dynamics_cli.impact.slide.motion import run
from dynamics_cli.impact.slide.records import Separation
from dynamics_cli.impact.slide.separation import separation
from dynamics_cli.impact.slide.task import car_of, shares_of, start_of
from dynamics_cli.numerics.elementary import atan2, cos, hypot, sin, sqrt
from dynamics_cli.numerics.number import plain, single

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.impact.crash.results import CrashCourse

STEPS = 60


class Spinning:
    """Speed, heading and spin at the separation; distance and time of the slide follow straight from them."""

    def __init__(self, scene: CrashScene, side: str, gravity: float) -> None:
        given = getattr(scene, side)
        part = given.slide
        place = f"{side}.slide: "
        nose = _nose(given, place)
        self.friction = surface_friction(scene, part, place)
        require(
            self.friction is not None,
            "{place}neither a surface nor a friction is given",
            place=place, code="no-surface", hint="name one of the [surfaces], or give friction",
        )  # fmt: skip
        shares = shares_of(part.__dict__)
        numbers = (part.front_axle, part.rear_axle, part.track, part.radius_of_gyration, part.grip_slope, *shares)
        if single(*numbers):
            # refused here what no car is
            ahead, behind, track, gyration, slope, *plain_shares = (plain(one) for one in numbers)
            car_of(ahead, behind, track, gyration, 1.0, plain_shares, slope, 0.0, 1.0)
        way = given.rest[0] - scene.impact.point[0], given.rest[1] - scene.impact.point[1]
        self.distance = hypot(*way)
        require(self.distance > 0.0, "{place}it came to rest where it was struck", place=place, code="no-heading")
        x, y = direction_of(nose, scene.axes)
        beside = atan2(x * way[1] - y * way[0], x * way[0] + y * way[1])
        turn = part.rest_nose - nose
        # seen from above with y to the right the car is its mirror image
        mirror = -1.0 if scene.axes == "sae" else 1.0
        if scene.axes == "compass":
            turn = 0.0 - turn
        if mirror < 0.0:
            left_front, right_front, left_rear, right_rear = shares
            numbers = (*numbers[:5], right_front, left_front, right_rear, left_rear)
        speed, bend, spin = separation(numbers, self.distance, beside, turn, side)
        pace = sqrt(self.friction * gravity)  # type: ignore[operator]
        self.speed = pace * speed
        self.spin = pace * spin
        c, s = cos(bend), sin(bend)
        self.heading = heading_of(c * way[0] - s * way[1], s * way[0] + c * way[1], scene.axes)
        self.nose = nose
        # what the way and the speed leave for the mean deceleration
        self.time = 2.0 * self.distance / self.speed


def _nose(given: CrashVehicle, place: str) -> float:
    """The heading of its nose at the separation; refuses what a slide with spin cannot stand beside."""
    require(
        given.rest is not None,
        "{place}the slide goes to the rest position, which is not given",
        place=place, code="no-rest", hint="give rest, e.g. rest = \"12.4, 7.1 m\", from the axes of the scene",
    )  # fmt: skip
    for word, other in (("stretches after the impact", given.after), ("the exit heading", given.exit_heading),
                        ("the exit speed", given.exit_speed)):  # fmt: skip
        require(
            other is None or other == (),
            "{place}{word} and a slide with spin both say how it came to rest",
            place=place, word=word, code="twice", hint="leave one of them out",
        )  # fmt: skip
    nose = given.approach_heading if given.nose is None else given.nose
    require(nose is not None, "{place}its nose at the impact is not given", place=place, code="no-nose")
    assert nose is not None
    return nose


def swept(
    scene: CrashScene, side: str, course: "CrashCourse", gravity: float
) -> "tuple[list[tuple[float, float, float]], list[list[tuple[float, float]]]]":
    """Places from the separation and angles of the nose along a slide with spin, and marks of its wheels: a picture."""
    given = getattr(scene, side)
    part = given.slide
    car = car_of(
        part.front_axle, part.rear_axle, part.track, part.radius_of_gyration, surface_friction(scene, part, "") or 0.0,
        shares_of(part.__dict__), part.grip_slope, 0.0, gravity, (), scene.axes,
    )  # fmt: skip
    motion = Separation(course.exit_speed, course.exit_heading, course.exit_spin or 0.0)
    nose = given.approach_heading if given.nose is None else given.nose
    done = run(car, start_of(motion, nose, (0.0, 0.0), scene.axes))
    marks = [line for wheel in car.wheels for line in lines(wheel, done)]
    return [done.at(done.end.time * index / STEPS) for index in range(STEPS + 1)], marks
