"""Phase portraits: motions of two states between their equilibria."""

import math

from dynamics_cli.pictures import Arrow, Axis, Curve, Mark, Panel, Picture
from dynamics_cli.stability.equilibria.rates import Rates

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Motions begin on a grid where none has come yet, and are drawn by so many steps, each a share of the ranges.
BEGINS, STEPS, STEP, CELLS = 9, 110, 0.008, 14
STABLE, UNSTABLE = 2, 1
# A letter and a line of words, as shares of the picture.
LETTER, LINE = 0.0115, 0.06


def portrait(points: "Any", states: "Any", let: "Any") -> Picture:
    """Motions of two states from a grid of places, with the equilibria."""
    rates = Rates(states, let)
    (low, high), (bottom, top) = ((state.low, state.high) for state in states)
    wide, tall = high - low, top - bottom
    items: list[Any] = []
    taken: set[tuple[int, int]] = set()

    def cell(x: float, y: float) -> "tuple[int, int]":
        return int((x - low) / wide * CELLS), int((y - bottom) / tall * CELLS)

    for i in range(BEGINS):
        for j in range(BEGINS):
            place = low + (i + 0.5) * wide / BEGINS, bottom + (j + 0.5) * tall / BEGINS
            if cell(*place) in taken:
                continue
            x, y = _motion(rates, place, (low, high), (bottom, top))
            taken.update(map(cell, x, y))
            items.append(Curve(x, y, "", "thin", role=0))
            half = len(x) // 2
            if half > 2:
                items.append(Arrow(x[half], y[half], x[half + 1] - x[half], y[half + 1] - y[half]))
    for point in points:
        stable = point.verdict.startswith("stable")
        words = point.verdict.partition(":")[0].partition(",")[0]
        shares = [
            ((x - point.at[0]) / wide, (y - point.at[1]) / tall)
            for item in items
            for x, y in (zip(item.x, item.y, strict=True) if isinstance(item, Curve) else ((item.x, item.y),))
        ]
        items.append(
            Mark(
                point.at[0],
                point.at[1],
                words,
                _aside(shares, len(words)),
                role=STABLE if stable else UNSTABLE,
            )
        )
    axes = Axis(states[0].name, ends=(low, high)), Axis(states[1].name, ends=(bottom, top))
    return Picture((Panel(*axes, tuple(items)),), "phase portrait")


def _aside(shares: "list[tuple[float, float]]", letters: int) -> "tuple[float, float]":
    """Where beside an equilibrium words cross the fewest motions, whose places are given as shares of the picture."""
    width = LETTER * letters

    def crossed(aside: "tuple[float, float]") -> int:
        left, low = (0.01 if aside[0] > 0.0 else -0.01 - width), (0.02 if aside[1] > 0.0 else -0.02 - LINE)
        return sum(left <= x <= left + width and low <= y <= low + LINE for x, y in shares)

    return min(((5.0, 5.0), (5.0, -11.0), (-5.0, 5.0), (-5.0, -11.0)), key=crossed)


def _motion(
    rates: Rates, place: "tuple[float, float]", across: "tuple[float, float]", along: "tuple[float, float]"
) -> "tuple[list[float], list[float]]":
    """A motion by the midpoint rule in steps of even length on the picture, until it leaves or rests."""
    wide, tall = across[1] - across[0], along[1] - along[0]
    path = [place]
    for _ in range(STEPS):
        x, y = path[-1]
        first = _step(rates.at((x, y)), wide, tall)
        if first is None:
            break
        second = _step(rates.at((x + 0.5 * first[0], y + 0.5 * first[1])), wide, tall)
        if second is None or first[0] * second[0] / wide**2 + first[1] * second[1] / tall**2 < 0.0:
            break
        x, y = x + second[0], y + second[1]
        if not (across[0] <= x <= across[1] and along[0] <= y <= along[1]):
            break
        path.append((x, y))
    return [x for x, _ in path], [y for _, y in path]


def _step(rate: "Any", wide: float, tall: float) -> "tuple[float, float] | None":
    """The direction of the motion as a step of even length; none at rest."""
    size = math.hypot(rate[0] / wide, rate[1] / tall)
    return (rate[0] * STEP / size, rate[1] * STEP / size) if size > 0.0 and math.isfinite(size) else None
