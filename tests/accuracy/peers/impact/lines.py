"""Bounces followed one by one."""

from math import sqrt

from dynamics_cli.accuracy.alternatives.impact.lines import _restitution

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# A body that bounces more often than this before it rests is not followed to its end.
MOST_BOUNCES = 20_000


def drop_by_bounces(
    *, evidence: "Any", height: "float | None" = None, bounces: int, gravity: float, mass: "float | None" = None
) -> "dict[str, float]":
    """From bounce to bounce: fall, rebound, rise v²/2g, until one adds nothing to the time, or too many."""
    e, h = _restitution(evidence, height, gravity)
    fall = sqrt(2.0 * h / gravity)
    found = {"restitution": e, "drop_height": h, "fall_time": fall}
    time, way, top = fall, h, h
    for n in range(MOST_BOUNCES):
        down = sqrt(2.0 * gravity * top)
        up = e * down
        flight, top = 2.0 * up / gravity, up * up / (2.0 * gravity)
        if n == 0:
            found |= {"impact_speed": down, "share_lost": (down * down - up * up) / (down * down)}
            if mass is not None:
                found["energy_lost"] = 0.5 * mass * down * down - 0.5 * mass * up * up
        if n < bounces:
            found |= {
                f"bounces[{n}].number": n + 1.0, f"bounces[{n}].time": time, f"bounces[{n}].impact_speed": down,
                f"bounces[{n}].rebound_speed": up, f"bounces[{n}].height": top, f"bounces[{n}].flight_time": flight,
            }  # fmt: skip
        if n >= bounces and time + flight == time:
            return found | {"time_to_rest": time, "way_to_rest": way}
        time, way = time + flight, way + 2.0 * top
    # it bounces on: what has been seen of it is all there is
    return found
