"""Durations of a valve above given lifts, and its ramps."""

from math import pi

from dynamics_cli.cam.forces.records import Duration, Ramp
from dynamics_cli.cam.laws.peaks import extremes
from dynamics_cli.errors import require, worded
from dynamics_cli.quantities import Coordinate
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.cam.program.motion import Motion

TURN = 2.0 * pi
# Lifts at which engine makers quote durations: 0.050 in and 1 mm.
QUOTED = (0.00127, 0.001)


def durations(
    motion: "Motion", lifts: "tuple[float, ...]", omega: float
) -> "tuple[tuple[Duration, ...], tuple[Advice, ...]]":
    """Give the cam angles above some lifts, and note the lifts never reached.

    `lifts`: lifts above the lowest [m]. Returns one for every time a lift is passed upwards; a note for every lift that
    never is.
    """
    durations_above = []
    missed = []
    least = motion.stroke[0]
    for lift in lifts:
        passages = crossings(motion, least + lift)
        ups = [angle for angle, up in passages if up]
        downs = [angle for angle, up in passages if not up]
        if not ups:
            message = worded(
                "the follower never passes a lift of {lift:6}: there is no duration above it", lift=(lift, Coordinate)
            )
            missed.append(Advice("duration", message, "note"))
        for opens in ups:
            closes = min((angle if angle > opens else angle + TURN) for angle in downs)
            span = closes - opens
            speeds = [motion.at(angle, 1)[1] * omega for angle in (opens, closes)]
            durations_above.append(Duration(lift, opens, closes, span, 2.0 * span, *speeds))
    return tuple(durations_above), tuple(missed)


def ramps(motion: "Motion", lash: float | None, lifts: "tuple[float, ...]", omega: float) -> "tuple[Ramp, ...] | None":
    """Give the ramps from the lash to the highest of some lifts, opening and closing; None without a lash.

    `lash`: lash of the valve gear [m]; `lifts`: lifts above the lowest [m]. Returns in order of the angle at which they
    end. Raises InadmissibleError when the lash is not below the highest lift.
    """
    if lash is None or not lifts:
        return None
    top = max(lifts)
    require(
        lash < top,
        "the lash of {lash} is not below the lift of {top} at which the ramps end",
        lash=(lash, Coordinate),
        top=(top, Coordinate),
        code="lash",
        hint="give a higher lift by --at-lifts",
    )
    least = motion.stroke[0]
    low, high = crossings(motion, least + lash), crossings(motion, least + top)
    ramps_between = []
    for angle, up in high:
        side = [other for other, upwards in low if upwards == up]
        if side:
            span = min((angle - other if up else other - angle) % TURN for other in side)
            mean = (top - lash) / span * abs(omega) * (1.0 if up else -1.0)
            ramps_between.append(Ramp("opening" if up else "closing", lash, top, span, mean))
    return tuple(ramps_between)


def crossings(motion: "Motion", level: float) -> "list[tuple[float, bool]]":
    """Cam angles at which the lift passes a level, and whether upwards.

    `level`: the lift [m]. Returns in order of the angle. Touching without passing does not count.
    """
    passages = []
    for index, span in enumerate(motion.segments):
        if span.law is None:
            continue
        start, end = motion.joints[index], motion.joints[index + 1]
        places = sorted({x for x, _ in extremes(span.law, 0)})
        angles = [start, *(start + x * (end - start) for x in places if 0.0 < x < 1.0), end]
        values = [motion.at(angle, 0, 1 if angle < end else -1)[0] - level for angle in angles]
        for low, high, before, after in zip(angles, angles[1:], values, values[1:], strict=False):
            if (before < 0.0) != (after < 0.0):
                angle = _passed(motion, level, low, high)
                passages.append((angle if angle < TURN else high, after >= 0.0))
    return passages


def _passed(motion: "Motion", level: float, low: float, high: float) -> float:
    """Where a monotone stretch passes a level: Newton's method, safeguarded by bisection."""
    below = motion.at(low, 0)[0] < level
    angle = 0.5 * (low + high)
    while low < angle < high:
        lift, slope = motion.at(angle, 1)
        if (lift < level) == below:
            low = angle
        else:
            high = angle
        step = (level - lift) / slope if slope else high - low
        if abs(step) <= 2.0**-52 * angle:
            break
        angle = angle + step if low < angle + step < high else 0.5 * (low + high)
    return angle
