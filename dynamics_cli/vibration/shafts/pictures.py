"""Shapes of a torsional line, Campbell diagrams, response of a rotor."""

import math

from dynamics_cli.errors import worded
from dynamics_cli.pictures import Axis, Band, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Frequency, ShaftSpeed
from dynamics_cli.vibration.systems.pictures import shape_over_names

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_SHAPES = 4
ORDERS = (1.0, 2.0, 3.0)


def shaft(
    result: "Any", *, orders: "tuple[float, ...]" = (), lowest_speed: "float | None" = None,
    highest_speed: "float | None" = None, **_: "Any",
) -> Picture:  # fmt: skip
    """Campbell diagram with critical speeds, and the shapes of the lowest modes."""
    names = tuple(result.rotors.split(", "))
    panels = [_campbell(result, orders or ORDERS, lowest_speed, highest_speed)]
    panels += [shape_over_names(mode, names, list(mode.angles)) for mode in result.modes[:MOST_SHAPES]]
    return Picture(tuple(panels), "torsional vibration", columns=2)


def _campbell(result: "Any", orders: "tuple[float, ...]", low: "float | None", high: "float | None") -> Panel:
    shown = result.modes[:MOST_SHAPES]
    top = high * 1.25 if high else 1.1 * max((mode.speed / min(orders) for mode in shown[:2]), default=1.0)
    ceiling = 1.2 * max((mode.frequency for mode in shown), default=1.0)
    items: list[Any] = []
    if low is not None or high is not None:
        items.append(Band(low or 0.0, high if high is not None else top, "running"))
    for mode in shown:
        items.append(Curve([0.0, top], [mode.frequency, mode.frequency], role=0))
        text = worded("mode {n}", n=str(mode.number))
        items.append(Label(0.01 * top, mode.frequency + 0.035 * ceiling, text, left=True))
    for nth, order in enumerate(orders):
        end = min(top, ceiling * 2.0 * math.pi / order)
        items.append(
            Curve([0.0, end], [0.0, order * end / (2.0 * math.pi)], f"order {order:g}", "dashed", role=1 + nth)
        )
        for mode in shown:
            speed = mode.speed / order
            if speed <= top:
                items.append(Mark(speed, mode.frequency, ""))
    axes = Axis("speed", ShaftSpeed, ends=(0.0, top)), Axis("frequency", Frequency, ends=(0.0, ceiling))
    return Panel(*axes, tuple(items), "Campbell diagram", wide=True)
