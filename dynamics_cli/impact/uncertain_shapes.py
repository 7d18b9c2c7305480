"""Uncertain places and headings of a scene: ellipses and fans with the coverage of the answer's intervals."""

import math

from dynamics_cli.pictures import Curve

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.pictures import Spreads

    Pair = tuple[float, float]

POINTS = 72
# A fan wider than half a turn shows no direction.
WIDEST = math.pi


def ellipse(centre: "Pair", covariance: "tuple[float, float, float]", coverage: float, role: int) -> "list[Any]":
    """The ellipse of a normal distribution in the plane; `covariance` is xx, xy and yy."""
    xx, xy, yy = covariance
    half, difference = 0.5 * (xx + yy), math.hypot(0.5 * (xx - yy), xy)
    if half + difference <= 0.0:
        return []
    size = math.sqrt(-2.0 * math.log1p(-coverage))
    turn = 0.5 * math.atan2(2.0 * xy, xx - yy)
    major = size * math.sqrt(half + difference)
    minor = size * math.sqrt(max(half - difference, 0.0))
    c, s = math.cos(turn), math.sin(turn)
    angles = [math.tau * nth / POINTS for nth in range(POINTS)] + [0.0]
    x = [centre[0] + major * math.cos(a) * c - minor * math.sin(a) * s for a in angles]
    y = [centre[1] + major * math.cos(a) * s + minor * math.sin(a) * c for a in angles]
    return [Curve(x, y, "", "fill", role), Curve(x, y, "", "dots", role)]


def at_place(spreads: "Spreads", address: str, centre: "Pair", flip: float, role: int) -> "list[Any]":
    """The ellipse of a position among the results or inputs; nothing of one that is certain."""
    x, y = f"{address}[0]", f"{address}[1]"
    covariance = spreads.covariance(x, x), flip * spreads.covariance(x, y), spreads.covariance(y, y)
    return ellipse(centre, covariance, spreads.coverage, role)


def at_tip(
    spreads: "Spreads", side: str, tip: "Pair", arrow: "Pair", scale: float, sense: float, role: int
) -> "list[Any]":
    """The ellipse about the tip of the arrow of a vehicle's velocity after the impact.

    `scale` is the length of an arrow per speed; `sense` is +1 or -1 as headings grow anticlockwise or clockwise.
    """
    speed, heading = f"{side}.exit_speed", f"{side}.exit_heading"
    reach = math.hypot(*arrow) or 1.0
    x, y = arrow[0] / reach, arrow[1] / reach
    along = scale * scale * spreads.covariance(speed, speed)
    across = reach * reach * spreads.covariance(heading, heading)
    both = sense * scale * reach * spreads.covariance(speed, heading)
    covariance = (
        along * x * x - 2.0 * both * x * y + across * y * y,
        along * x * y + both * (x * x - y * y) - across * x * y,
        along * y * y + 2.0 * both * x * y + across * x * x,
    )
    return ellipse(tip, covariance, spreads.coverage, role)


def fan(
    spreads: "Spreads | None", address: str, at: "Pair", length: float, way: "Callable[[float], Pair]", role: int
) -> "list[Any]":
    """The fan of an uncertain heading from a point; `way` is a heading as a direction on the page."""
    low, high = (0.0, 0.0) if spreads is None else spreads.intervals.get(address, (0.0, 0.0))
    if not 0.0 < high - low < WIDEST:
        return []
    directions = [way(low + (high - low) * nth / POINTS) for nth in range(POINTS + 1)]
    x = [at[0], *(at[0] + length * a for a, _ in directions), at[0]]
    y = [at[1], *(at[1] + length * b for _, b in directions), at[1]]
    return [Curve(x, y, "", "fill", role), Curve(x, y, "", "dots", role)]
