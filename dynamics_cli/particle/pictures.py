"""The path of a projectile among those of other angles, with the parabola of safety."""

import math

from dynamics_cli.numerics.number import plain
from dynamics_cli.particle.aiming import Elevation, launcher
from dynamics_cli.particle.tube import tube as motion_in_tube
from dynamics_cli.pictures import Axis, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import STANDARD_GRAVITY, Length, Speed, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

POINTS = 80
FAN = (15.0, 30.0, 45.0, 60.0, 75.0)
GREY = 6


def projectile(
    answer: "Any",
    *,
    speed: "float | None" = None,
    aim: "Any",
    height: float = 0.0,
    time_constant: "float | None" = None,
    drag: "Any" = None,
    wind: float = 0.0,
    gravity: float = STANDARD_GRAVITY,
    **_: "Any",
) -> Picture:
    """The path, a fan of other angles, and the parabola of safety where there is no drag."""
    speed = plain(answer.launch_speed if speed is None else speed)
    launch = launcher(speed, plain(gravity), time_constant, drag, plain(wind))
    fall = plain(height) if isinstance(aim, Elevation) else max(-plain(aim.target[1]), 0.0)
    items: list[Any] = [_path(launch, math.radians(degrees), fall, "thin", "", GREY) for degrees in FAN]
    if answer.other_elevation is not None:
        items.append(_path(launch, answer.other_elevation, fall, "dashed", "steeper angle", 1))
    items.append(_path(launch, answer.elevation, fall, "thick", "this flight", 0))
    if time_constant is None and drag is None:
        top = speed * speed / (2.0 * gravity)
        reach = math.sqrt(4.0 * top * (top + fall))
        x = [reach * k / POINTS for k in range(POINTS + 1)]
        items.append(Curve(x, [top - at * at / (4.0 * top) for at in x], "safety parabola", "dotted", role=2))
    items.append(Mark(answer.apex_distance, answer.apex_height, "", role=0))
    if not isinstance(aim, Elevation):
        items.append(Mark(plain(aim.target[0]), plain(aim.target[1]), "target", role=1))
    panel = Panel(Axis("distance", Length), Axis("height", Length), tuple(items), equal=True)
    return Picture((panel,), "trajectory", subtitle="thin: other angles, by 15 degrees")


def _path(launch: "Any", angle: float, fall: float, style: "Any", label: str, role: int) -> Curve:
    flight = launch(angle)
    end = flight.landing(fall)[0]
    states = [flight.at(end * k / POINTS) for k in range(POINTS + 1)]
    return Curve([state[1] for state in states], [state[2] for state in states], label, style, role=role)


def tube(answer: "Any", *, steps: int = 0, **given: "Any") -> Picture:
    """Distance from the axis and speed along the tube over time."""
    path = motion_in_tube(**given, steps=max(steps, POINTS)).path
    times = [row.time for row in path]
    place = Curve(times, [row.position for row in path], "distance from the axis", role=0)
    pace = Curve(times, [row.speed for row in path], "speed along the tube", role=1)
    rest: list[Any] = []
    if answer.rest is not None:
        rest.append(Curve([times[0], times[-1]], [answer.rest] * 2, "at rest", "dotted", role=GREY))
    time = Axis("time", Time)
    panels = (Panel(time, Axis("position", Length), (place, *rest)), Panel(time, Axis("speed", Speed), (pace,)))
    return Picture(panels, f"particle in a turning tube: {answer.motion}")
