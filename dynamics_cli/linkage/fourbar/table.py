"""The table of a four-bar over the crank angles it reaches."""

from math import tau

from dynamics_cli.errors import require
from dynamics_cli.linkage.fourbar.closure import Closed, Frame, close, discriminants, is_regular, ratios
from dynamics_cli.linkage.fourbar.grashof import limits
from dynamics_cli.linkage.fourbar.records import Step
from dynamics_cli.numerics.elementary import atan2
from dynamics_cli.numerics.number import over_plain, plain
from dynamics_cli.numerics.turns import turned

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Ratios = tuple[float, float, float, float]

MANY = 20_000
# At the end of a range one of the two roots is zero but for rounding, beside the square of the lengths.
TOGGLE = 1e-9
# Parts of this size beside one are rounding, as in a parallelogram.
DUST = 1e-15


def spread(low: float, high: float, steps: int) -> "list[float]":
    """Crank angles of a table, its ends among them."""
    require(2 <= steps <= MANY, "steps: {count}; a table has 2 to {most}", count=steps, most=MANY, code="steps")
    return [*(low + (high - low) * k / steps for k in range(steps)), high]


def reachable(links: Frame) -> "tuple[tuple[float, float], ...]":
    """Ranges of crank angles that can be reached, one or two."""
    outer, inner = limits(links)
    if outer is None and inner is None:
        return ((0.0, tau),)
    if inner is None:
        return ((-(outer or 0.0), outer or 0.0),)
    if outer is None:
        return ((inner, tau - inner),)
    return (-outer, -inner), (inner, outer)


def posed(links: Frame, angle: float, side: float, *, limit: bool = False) -> "tuple[Closed | None, Ratios | None]":
    """The loop at a crank angle that can be reached, and its speed ratios; neither where B turns freely about A and O₄.

    At a toggle, which a limit of the range is, it has no ratios.
    """
    turn, half = turned(angle), turned(0.5 * angle)
    if links.apart == 0.0 and half[1] == 0.0:
        return None, None
    roots = discriminants(links, half)
    if limit:
        least = TOGGLE * (links.a + links.b + links.c + links.d) ** 2
        roots = tuple(0.0 if part <= least else part for part in roots)  # type: ignore[assignment]
    loop = close(links, turn, half, side, roots)
    return loop, ratios(links, loop) if is_regular(links, loop) else None


def table(links: Frame, side: float, steps: int, speed: float | None = None, gain: float = 0.0) -> "tuple[Step, ...]":
    """Rows over every range of crank angles, including its ends; what does not exist at a toggle is left out."""
    links = over_plain(links)
    crank = None if speed is None else (plain(speed), plain(gain))
    return tuple(
        _row(angle, *posed(links, angle, side, limit=low != 0.0 and angle in (low, high)), crank)
        for low, high in reachable(links)
        for angle in spread(low, high, steps)
    )


def _row(angle: float, loop: "Closed | None", there: "Ratios | None", crank: "tuple[float, float] | None") -> Step:
    if loop is None:
        return Step(angle, None, None, None, None, None, None, None, 0.0)
    coupler, *rates = (there[0], there[1], there[3]) if there else (None, None, None)
    if crank is not None and there:
        change = there[3] if abs(there[3]) > DUST else 0.0
        rates = [there[1] * crank[0], change * crank[0] ** 2 + there[1] * crank[1]]
    moving = (*rates, None, None) if crank is None else (None, None, *rates)
    angles = _direction(loop.by, loop.bx), _direction(loop.cy, loop.cx)
    row: Any = (angle, *angles, coupler, *moving, 2.0 * atan2(abs(loop.second), abs(loop.first)))
    return Step(*row)


def _direction(y: float, x: float) -> float:
    return atan2(y if abs(y) > DUST * abs(x) else 0.0, x)
