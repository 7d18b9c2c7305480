"""Many poses of a four-bar at once, and its table over the crank angles it reaches."""

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.linkage.fourbar.closure import Closed, Frame, close, discriminants, ratios
from dynamics_cli.linkage.fourbar.grashof import limits
from dynamics_cli.linkage.fourbar.records import Step
from dynamics_cli.numerics.number import over_plain, plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MANY = 20_000


def turns(theta: "Any") -> "tuple[tuple[Any, Any], tuple[Any, Any]]":
    """Cosine and sine of angles and of their halves, from two library calls a value."""
    cosine, sine = np.cos(0.5 * theta), np.sin(0.5 * theta)
    return ((cosine - sine) * (cosine + sine), 2.0 * (sine * cosine)), (cosine, sine)


def poses(links: Frame, theta: "Any", side: float) -> "tuple[Closed, tuple[Any, ...]]":
    """The loop, and the speed ratios with their derivatives, at many crank angles that can be reached."""
    turn, half = turns(theta)
    loop = close(links, turn, half, side)
    return loop, ratios(links, loop)


def reachable(links: Frame) -> "tuple[tuple[float, float], ...]":
    """Ranges of crank angles that can be reached, one or two."""
    outer, inner = limits(links)
    if outer is None and inner is None:
        return ((0.0, 2.0 * np.pi),)
    if inner is None:
        return ((-(outer or 0.0), outer or 0.0),)
    if outer is None:
        return ((inner, 2.0 * np.pi - inner),)
    return (-outer, -inner), (inner, outer)


def table(links: Frame, side: float, steps: int, speed: float | None = None, gain: float = 0.0) -> "tuple[Step, ...]":
    """Rows over every range of crank angles, including its ends; what does not exist at a toggle is left out."""
    require(2 <= steps <= MANY, "steps: {count}; a table has 2 to {most}", count=steps, most=MANY, code="steps")
    links = over_plain(links)
    parts = []
    for low, high in reachable(links):
        theta = np.linspace(low, high, steps + 1)
        ends = np.array([low != 0.0, *[False] * (steps - 1), low != 0.0])
        parts.append(_rows(links, theta, side, ends, (speed, gain)))
    return tuple(row for part in parts for row in part)


def _rows(
    links: Frame, theta: "Any", side: float, toggles: "Any", turning: "tuple[float | None, float]"
) -> "list[Step]":
    turn, half = turns(theta)
    both_discriminants: Any = discriminants(links, half)
    # at the ends of a range one of the two is zero but for rounding
    first, second = (np.where(toggles & (d <= 1e-9 * np.abs(d).max()), 0.0, d) for d in both_discriminants)
    free = links.apart == 0.0
    stuck = (half[1] == 0.0) & free
    with np.errstate(all="ignore"):
        loop = close(links, turn, half, side, (first, second))
        speeds = ratios(links, loop)
    smooth = links.outer == 0.0 or links.inner == 0.0
    still = stuck | (((loop.first * loop.second) == 0.0) & (not smooth))
    regular_speeds = [np.where(still, np.nan, part) for part in speeds]
    coupler, rocker = np.arctan2(loop.by + 0.0, loop.bx), np.arctan2(loop.cy + 0.0, loop.cx)
    transmission = 2.0 * np.arctan2(np.abs(loop.second), np.abs(loop.first))
    columns = (theta, np.where(stuck, np.nan, coupler), np.where(stuck, np.nan, rocker),
               regular_speeds[0], *_speeds(regular_speeds[1], regular_speeds[3], *turning), transmission)  # fmt: skip
    return [Step(*row) for row in zip(*(_known(column) for column in columns), strict=True)]


def _speeds(ratio: "Any", change: "Any", speed: float | None, gain: float) -> "tuple[Any, ...]":
    """ω₄/ω₂ and α₄/ω₂², or ω₄ and α₄ where the speed of the crank is known."""
    nothing = np.full(ratio.shape, np.nan)
    if speed is None:
        return ratio, change, nothing, nothing
    return nothing, nothing, ratio * plain(speed), change * plain(speed) ** 2 + ratio * plain(gain)


def _known(column: "Any") -> "list[float | None]":
    """The number, or None if it is not finite."""
    return [value if np.isfinite(value) else None for value in column.tolist()]
