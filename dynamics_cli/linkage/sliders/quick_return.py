"""Quick returns: a crank whose pin slides along a lever, oscillating (crank shorter) or turning (Whitworth)."""

from math import tau

from dynamics_cli.errors import require
from dynamics_cli.linkage.fourbar.table import spread
from dynamics_cli.linkage.sliders.double_slider import require_long
from dynamics_cli.numerics.elementary import atan2, hypot, pi_beside, sqrt
from dynamics_cli.numerics.number import decides, over_plain, single
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import (
    Acceleration,
    Angle,
    AngularAcceleration,
    Annotated,
    Count,
    PartPoint,
    PartVelocity,
    Ratio,
    Size,
    Speed,
    Text,
    TurnRate,
)
from dynamics_cli.records import record
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


@record
class LeverStep:
    """One crank angle of the table."""

    crank_angle: Annotated[Angle, "Crank angle θ₂ [rad]."]
    lever_angle: Annotated[Angle, "Lever angle θ₄, from 0 to 360 degrees [rad]."]
    lever_ratio: Annotated[Ratio, "ω₄/ω₂."]
    lever_speed: Annotated[TurnRate | None, "ω₄ at the speed given [rad/s]."] = None
    lever_acceleration: Annotated[AngularAcceleration | None, "α₄ there [rad/s^2]."] = None
    slip: Annotated[Speed | None, "Speed of the pin along the lever, outwards [m/s]."] = None


@record
class QuickReturn:
    """A quick return in one pose, and its time ratio."""

    lever_angle: Annotated[Angle | None, "Angle θ₄ of the lever, from the line of the pivots on [rad]."] = None
    lever_ratio: Annotated[Ratio | None, "ω₄/ω₂."] = None
    lever_speed: Annotated[TurnRate | None, "Angular velocity ω₄ of the lever [rad/s]."] = None
    lever_acceleration: Annotated[AngularAcceleration | None, "Its angular acceleration α₄ [rad/s^2]."] = None
    reach: Annotated[Size | None, "Distance of the crank's pin from the lever's pivot [m]."] = None
    slip: Annotated[Speed | None, "Speed of the pin along the lever, outwards [m/s]."] = None
    coriolis: Annotated[Acceleration | None, "Coriolis acceleration 2ω₄·slip of the pin [m/s^2]."] = None
    tip: Annotated[PartPoint | None, "The lever's tip [m]."] = None
    tip_velocity: Annotated[PartVelocity | None, "Its velocity [m/s]."] = None
    time_ratio: Annotated[Ratio | None, "Time of the working stroke over that of the return."] = None
    swing: Annotated[Angle | None, "Angle through which an oscillating lever swings [rad]."] = None
    stroke: Annotated[Size | None, "Chord of the tip's path, of an oscillating lever [m]."] = None
    kind: Annotated[Text | None, "Oscillating lever, or Whitworth's turning one."] = None
    table: Annotated[tuple[LeverStep, ...] | None, "A full turn of the crank, where no angle was given."] = None


def quick_return(
    *,
    crank: Annotated[Size, "Length a of the crank, e.g. 50 mm."],
    ground: Annotated[Size, "Distance d of the crank's pivot from the lever's, e.g. 120 mm."],
    crank_angle: Annotated[
        Angle | None, "Crank angle θ₂ from the line to the lever's pivot; without it a table."
    ] = None,
    speed: Annotated[TurnRate | None, "Angular velocity ω₂ of the crank, e.g. 10 rad/s."] = None,
    angular_acceleration: Annotated[AngularAcceleration, "Angular acceleration α₂ of the crank [rad/s^2]."] = 0.0,
    lever: Annotated[Size | None, "Length of the lever from its pivot to its tip, e.g. 250 mm."] = None,
    steps: Annotated[Count, "Steps of the table over a full turn."] = 24,
) -> QuickReturn:
    """Lever of a quick return: angle, speed, acceleration, slip of the pin, time ratio.

    Equation
    --------
    r⃗ = a⃗ − d⃗; ω₄ = ω₂ a⃗·r⃗/r², slip ṙ = ω₂ a⃗×r⃗/r, α₄ = (a⃗_A·n − 2ṙω₄)/r; time ratio (π + 2γ)/(π − 2γ) with
    sin γ = a/d of an oscillating lever, d/a of Whitworth's.

    Raises
    ------
    InadmissibleError
        When a length is not above zero, or the crank's pin passes through the lever's pivot.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 5.3.

    Examples
    --------
    >>> round(quick_return(crank=0.05, ground=0.12).time_ratio, 12)
    1.753317372194
    """
    for name, length in (("crank", crank), ("ground link", ground)):
        require_long(name, length)
    fields = _ratio(crank, ground, lever)
    if crank_angle is None:
        return QuickReturn(**fields, table=_table(crank, ground, steps, (speed, angular_acceleration)) or None)  # type: ignore[arg-type]
    return QuickReturn(**fields, **_pose(crank, ground, crank_angle, (speed, angular_acceleration), lever))  # type: ignore[arg-type]


def _table(crank: float, ground: float, steps: int, turning: "tuple[float | None, float]") -> "tuple[LeverStep, ...]":
    """Poses over a turn; without that in which the pin lies on the lever's pivot."""
    if drawing() or not single(crank, ground):
        return ()
    a, d, turning = over_plain((crank, ground, turning))
    rows = []
    for angle in spread(0.0, tau, steps):
        if a * turned(angle)[0] != d:
            pose = _pose(a, d, angle, turning, None)
            moving = (pose.get(name) for name in ("lever_ratio", "lever_speed", "lever_acceleration", "slip"))
            # an oscillating lever swings about the half turn
            rows.append(LeverStep(angle, pose["lever_angle"] % tau, *moving))  # type: ignore[arg-type]
    return tuple(rows)


def _pose(
    crank: float, ground: float, crank_angle: float, turning: "tuple[float | None, float]", lever: "float | None"
) -> "dict[str, Any]":
    """The lever at a crank angle."""
    speed, angular_acceleration = turning
    turn, half = turned(crank_angle), turned(0.5 * crank_angle)
    apart = crank - ground
    # a cos θ − d without cancellation where the pin passes near the lever's pivot
    rx = apart - 2.0 * crank * (half[1] * half[1])
    ax, ay = crank * turn[0], crank * turn[1]
    reach = hypot(rx, ay)
    require(
        reach > 0.0,
        "the crank's pin lies on the lever's pivot: the lever has no direction",
        code="free",
        hint="give a crank angle beside it, or lengths that differ",
    )
    ex, ey = rx / reach, ay / reach
    ratio = (ax * ex + ay * ey) / reach
    size = lever if lever is not None else 0.0 * reach
    pose = {
        "lever_angle": atan2(ay, rx),
        "lever_ratio": ratio,
        "reach": reach,
        "tip": None if lever is None else (ground + size * ex, size * ey),
    }
    if speed is None:
        return pose
    slip, lever_speed = (ax * ey - ay * ex) * speed, ratio * speed
    across = (
        -(angular_acceleration * ay + speed * speed * ax) * -ey + (angular_acceleration * ax - speed * speed * ay) * ex
    )
    coriolis = 2.0 * slip * lever_speed
    return pose | {
        "lever_speed": lever_speed,
        "lever_acceleration": (across - coriolis) / reach,
        "slip": slip,
        "coriolis": coriolis,
        "tip_velocity": None if lever is None else (-(size * ey) * lever_speed, size * ex * lever_speed),
    }


def _ratio(crank: float, ground: float, lever: "float | None") -> "dict[str, object]":
    if not decides(crank, ground):
        return {}
    if crank == ground:
        return {"kind": "crank as long as the ground link: the lever turns at half the crank's speed"}
    pi = pi_beside(crank, ground)
    short, long = (crank, ground) if crank < ground else (ground, crank)
    leg = sqrt((long - short) * (long + short))
    angle, rest = 2.0 * atan2(short, leg), 2.0 * atan2(leg, short)
    if crank < ground:
        stroke = None if lever is None else 2.0 * lever * (crank / ground)
        fields: dict[str, object] = {"swing": angle, "stroke": stroke, "kind": "oscillating lever"}
    else:
        fields = {"kind": "turning lever (Whitworth)"}
    return {"time_ratio": (pi + angle) / rest, **fields}
