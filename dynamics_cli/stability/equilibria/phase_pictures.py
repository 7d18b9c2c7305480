"""Phase portraits: motions of two states between their equilibria."""

import math

from dynamics_cli.pictures import Arrow, Axis, Curve, Mark, Panel, Picture
from dynamics_cli.stability.equilibria.rates import Rates

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Motions begin on a grid where none has come yet, and are drawn by so many steps, each a share of the ranges.
BEGINS, STEPS, STEP, CELLS = 9, 110, 0.008, 14
STABLE, UNSTABLE, GREY = 2, 1, 6


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
        items.append(
            Mark(
                point.at[0],
                point.at[1],
                point.verdict.partition(":")[0].partition(",")[0],
                role=STABLE if stable else UNSTABLE,
            )
        )
    axes = Axis(states[0].name, ends=(low, high)), Axis(states[1].name, ends=(bottom, top))
    return Picture((Panel(*axes, tuple(items)),), "phase portrait")


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
