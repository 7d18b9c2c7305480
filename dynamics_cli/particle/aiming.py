"""Launches with and without drag, and the angles that meet a target or reach farthest."""

import math

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import hypot, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.roots import halved, highest
from dynamics_cli.numerics.turns import turned
from dynamics_cli.particle.flights import Linear, Quadratic, Upright, Vacuum
from dynamics_cli.quantities import Angle, Annotated, Area, Density, Mass, PlanarPosition, Positive, Speed
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import TypeAlias

    Flight: TypeAlias = Vacuum | Linear | Quadratic | Upright
    Launch: TypeAlias = Callable[[float], Flight]

RIGHT = 1.5707963267948966
SCAN = 60
# Angles to either side of the best, whose ranges are compared.
BESIDE = 1e-4


@record
class Elevation:
    """Aim by the angle."""

    elevation: Annotated[Angle, "Angle of the launch above the horizontal, e.g. 45 deg."]


@record
class Target:
    """Aim at a point."""

    target: Annotated[PlanarPosition, "Where it is to pass: distance and height from the launch, e.g. 80, 5 m."]


@record
class Aimed:
    """Aim at a point by an angle: the speed is found."""

    elevation: Annotated[Angle, "Angle of the launch above the horizontal, e.g. 45 deg."]
    target: Annotated[PlanarPosition, "Where it is to pass: distance and height from the launch, e.g. 80, 5 m."]


@record
class Terminal:
    """Drag by the square of the speed, by the speed at which a fall becomes steady."""

    terminal_speed: Annotated[Speed, "Speed at which drag carries the weight, e.g. 25 m/s."]


@record
class DragBody:
    """Drag by the square of the speed, of a body."""

    mass: Annotated[Mass, "Mass of the projectile, e.g. 0.145 kg."]
    area: Annotated[Area, "Area across its path, e.g. 42 cm^2."]
    drag_coefficient: Annotated[Positive, "Drag coefficient c_d, e.g. 0.4."]
    density: Annotated[Density, "Density of the air, e.g. 1.2 kg/m^3."] = 1.225


def launcher(
    speed: float, gravity: float, time_constant: "float | None", drag: "Terminal | DragBody | None", wind: float
) -> "Launch":
    """The flight at an angle."""
    if time_constant is not None:
        require(time_constant > 0.0, "the time constant is not above zero", code="drag")
    terminal = None if drag is None else _terminal(drag, gravity)

    def launch(angle: float) -> "Flight":
        cosine, sine = turned(angle)
        if terminal is None:
            if time_constant is None:
                return Vacuum(speed * cosine, speed * sine, gravity)
            return Linear(speed * cosine, speed * sine, gravity, time_constant, wind)
        if speed * cosine == wind:
            require(wind == 0.0, "it is launched straight up in the moving air", code="upright",
                    hint="change the elevation a little")  # fmt: skip
            require(sine > 0.0, "straight down it is a fall", code="downwards", hint="ask `dynamics particle fall`")
            return Upright(speed * sine, gravity, terminal)
        return Quadratic(speed * cosine, speed * sine, gravity, terminal, wind)

    return launch


def _terminal(drag: "Terminal | DragBody", gravity: float) -> float:
    if isinstance(drag, Terminal):
        speed = plain(drag.terminal_speed)
    else:
        carried = 0.5 * plain(drag.density) * plain(drag.drag_coefficient) * plain(drag.area)
        require((carried > 0.0) & (plain(drag.mass) > 0.0), "mass, area and density are above zero", code="drag")
        speed = math.sqrt(plain(drag.mass) * gravity / carried)
    require(speed > 0.0, "the terminal speed is not above zero", code="drag")
    return speed


def angles_to(launch: "Launch", x: float, y: float) -> "tuple[float, float | None]":
    """The flatter and the steeper angle at which a flight with drag passes a point."""

    def miss(angle: float) -> float:
        passed = launch(angle).passing(x)
        return -math.inf if passed is None else passed[2] - y

    floor = math.atan2(y, x)
    angles = [floor + (RIGHT - floor) * k / SCAN for k in range(SCAN)]
    misses = [miss(angle) for angle in angles]
    top = max(range(SCAN), key=misses.__getitem__)
    low, high = angles[max(top - 1, 0)], angles[min(top + 1, SCAN - 1)]
    crown = highest(miss, low, high, 1e-9 * max(abs(low), abs(high)))
    require(miss(crown) >= 0.0, "at this speed it passes below the target at every angle", code="out-of-reach",
            hint="launch it faster, or aim lower")  # fmt: skip
    flat, steep = (halved(lambda angle: miss(angle) < 0.0, end, crown)[1] for end in (floor, RIGHT - 1e-12))
    return flat, steep


def meeting_speed(x: float, y: float, slope: float, gravity: float) -> float:
    """The speed without drag that meets a target at a slope."""
    above = x * slope - y
    require(above > 0.0, "the target lies above the line of the launch", code="out-of-reach", hint="aim higher")
    return x * sqrt(gravity * (1.0 + slope * slope) / (2.0 * above))


def least_speed(x: float, y: float, gravity: float) -> float:
    """The least speed that reaches a target without drag."""
    return sqrt(gravity * (y + hypot(x, y))) if plain(y) >= 0.0 else sqrt(gravity * x * x / (hypot(x, y) - y))


def launch_speed(
    vacuum: float, x: float, y: float, angle: float, gravity: float, time_constant: "float | None",
    drag: "Terminal | DragBody | None", wind: float,
) -> float:  # fmt: skip
    """The speed at which a flight with drag passes a point at an angle, from that without drag on."""

    def short(speed: float) -> bool:
        passed = launcher(speed, gravity, time_constant, drag, wind)(angle).passing(x)
        return passed is None or passed[2] < y

    low, high = vacuum, vacuum
    while low > 1e-3 * vacuum and not short(low):
        low *= 0.5
    for _ in range(SCAN):
        if not short(high):
            return halved(short, low, high)[1]
        high *= 1.5
    require(False, "no speed reaches the target against this drag", code="out-of-reach", hint="aim elsewhere")
    raise AssertionError


def best_angle(launch: "Launch", height: float) -> float:
    """The angle of the greatest range to a landing so far below the launch: a little more and less reach as far."""

    def gain(angle: float) -> float:
        return launch(angle + BESIDE).landing(height)[1] - launch(angle - BESIDE).landing(height)[1]

    low, high = 1.01 * BESIDE, RIGHT - 1.01 * BESIDE
    at_low, at_high = gain(low), gain(high)
    if at_low <= 0.0 or at_high >= 0.0:
        return low if at_low <= 0.0 else high
    last = 0.0
    for _ in range(60):
        angle = (low * at_high - high * at_low) / (at_high - at_low)
        here = gain(angle)
        # an end that stays twice counts half, so that both close in (Illinois rule)
        if here > 0.0:
            at_high *= 0.5 if last > 0.0 else 1.0
            step, low, at_low = angle - low, angle, here
        else:
            at_low *= 0.5 if last < 0.0 else 1.0
            step, high, at_high = high - angle, angle, here
        last = here
        if min(step, high - low) < 1e-10 or not here:
            break
    return angle
