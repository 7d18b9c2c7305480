"""Motion of one link or pin over the range of the first driver."""

from math import pi

from dynamics_cli.errors import require, worded
from dynamics_cli.linkage.scenes.pose import is_free, posed
from dynamics_cli.numerics.linkages.records import GROUND
from dynamics_cli.quantities import (
    Angle,
    AngularAcceleration,
    Annotated,
    Coordinate,
    PartAcceleration,
    PartPoint,
    PartVelocity,
    TurnRate,
)
from dynamics_cli.records import Advice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.linkage.scenes.continuation import Continuation
    from dynamics_cli.numerics.linkages.system import System

MANY = 2_000
TURN = 2.0 * pi


@record
class Followed:
    """One position of the driver."""

    driver_angle: Annotated[Angle | None, "Angle of the first driver, of a link that is turned [rad]."] = None
    driver_position: Annotated[Coordinate | None, "Its position, of a pin that is pushed [m]."] = None
    angle: Annotated[Angle | None, "Angle of the link [rad]."] = None
    speed: Annotated[TurnRate | None, "Its angular velocity [rad/s]."] = None
    acceleration: Annotated[AngularAcceleration | None, "Its angular acceleration [rad/s^2]."] = None
    position: Annotated[PartPoint | None, "Where the pin is [m]."] = None
    velocity: Annotated[PartVelocity | None, "Its velocity [m/s]."] = None
    pin_acceleration: Annotated[PartAcceleration | None, "Its acceleration [m/s^2]."] = None


def followed(
    system: "System", q: "Any", name: str, steps: int, turn: "float | None", travel: "float | None"
) -> "dict[str, Any]":
    """Fields of a solution: rows over the first driver's range from the pose q on, joined to each other without a jump.

    Without a range the driver goes through a turn, or to its limits either way. A range beyond a limit ends there, with
    a caution.
    """
    from dynamics_cli.linkage.scenes.continuation import Continuation

    first = system.scene.drivers[0]
    require(1 <= steps <= MANY, "steps: {count}; a range has 1 to {most}", count=steps, most=MANY, code="steps")
    require(
        (travel is None) if not first.point else (turn is None and travel is not None),
        "the first driver pushes a pin: say how far"
        if first.point
        else "the first driver turns a link: it has no travel",
        code="range",
        hint="--travel '80 mm'" if first.point else "--turn '90 deg'",
    )
    named = {*system.shapes, *system.known, *system.unknown}
    require(name in named, "no link or pin is called {name}", name=repr(name), code="name",
            hint="there are {known}", known=", ".join(sorted(named - {GROUND})))  # fmt: skip
    span = travel or (TURN if turn is None else turn)
    ahead = Continuation(system, q)
    rows = [_row(ahead, name)]
    reached = _along(ahead, rows, name, [span * (k + 1) / steps for k in range(steps)])
    parts = [ahead]
    if not reached and turn is None and not first.point:
        back = Continuation(system, q)
        behind: list[Followed] = []
        _along(back, behind, name, [-span * (k + 1) / steps for k in range(steps)])
        rows = [*behind[::-1], *rows]
        parts.append(back)
    return _motion(parts, _unwrapped(rows), reached)


def _along(walk: "Continuation", rows: "list[Followed]", name: str, shifts: "list[float]") -> bool:
    for shift in shifts:
        if not walk.to(shift):
            return False
        rows.append(_row(walk, name))
    return True


def _row(walk: "Continuation", name: str) -> Followed:
    jacobian = walk.system.jacobian(walk.q)
    links, pins = posed(walk.system, walk.q, jacobian, is_free(walk.system, jacobian))
    driver = walk.system.scene.drivers[0]
    position: dict[str, Any] = {"driver_position": driver.position} if driver.point else {"driver_angle": driver.angle}
    for item in links:
        if item.name == name:
            return Followed(**position, angle=item.angle, speed=item.speed, acceleration=item.acceleration)
    pin = next(item for item in pins if item.name == name)
    return Followed(**position, position=pin.position, velocity=pin.velocity, pin_acceleration=pin.acceleration)


def _unwrapped(rows: "list[Followed]") -> "list[Followed]":
    """Angles that continue beyond half a turn, as the link does."""
    out, last = [], None
    for row in rows:
        if row.angle is not None and last is not None:
            angle = row.angle + TURN * round((last - row.angle) / TURN)
            fields = {key: getattr(row, key) for key in Followed.fields} | {"angle": angle}  # type: ignore[attr-defined]
            row = Followed(**fields)
        last = row.angle
        out.append(row)
    return out


def _motion(parts: "list[Continuation]", rows: "list[Followed]", reached: bool) -> "dict[str, Any]":
    """The rows, the range that the driver went through, and advice about it."""
    first = parts[0].start.scene.drivers[0]
    kind = Coordinate if first.point else Angle
    base = first.position if first.point else first.angle
    shifts = [0.0, *(part.shift for part in parts)]
    low, high = base + min(shifts), base + max(shifts)
    count = sum(part.steps for part in parts)
    crossed = sorted({round(base + shift, 6) for part in parts for shift in part.crossed})
    advice = []
    if crossed:
        words = worded(
            "at {at:4} the linkage passes a change point, where it can go on in two ways: the smooth one is shown",
            at=(crossed[0], kind),
        )
        advice.append(Advice("change-point", words, remedy="a second driver there decides which way it goes"))
    if not reached:
        words = worded(
            "the linkage follows its driver from {low:8} to {high:8} only", low=(low, kind), high=(high, kind)
        )
        advice.append(Advice("limit", words, severity="note"))
    return {
        "driver_from": None if first.point else low,
        "driver_to": None if first.point else high,
        "followed_by": f"one motion{' over a change point' if crossed else ''}, followed in {count} steps",
        "motion": tuple(rows),
        "advice": tuple(advice),
    }
