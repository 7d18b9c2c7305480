"""A vehicle seen from behind, standing and where it tips; the speeds that the answer gives."""

import math

from dynamics_cli.errors import worded
from dynamics_cli.pictures import Axis, Bars, Curve, Dimension, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Length, RoadSpeed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

TYRE = 0.2
SPEEDS = (
    ("speed", "before the trip"), ("roll_speed", "as it began to roll"), ("trip_speed", "trips in soil"),
    ("kerb_speed", "trips at a kerb"), ("curve_speed", "tips in the curve"),
)  # fmt: skip


def rollover(made: "Any", *, track_width: float, cm_height: float, **_: "Any") -> Picture:
    """The vehicle standing, and balanced over its outer wheels; below, each speed as a bar."""
    half, lean = 0.5 * track_width, math.atan2(0.5 * track_width, cm_height)
    ends = (-half - 0.9, 2.0 * half + 1.7 * cm_height)
    ground = ([ends[0], *ends, ends[1]], [-0.5, 0.0, 0.0, -0.5])
    items: list[Any] = [Curve(*ground, style="fill", role=6), Curve(list(ends), [0.0, 0.0], style="thin", role=6)]
    shapes = _shapes(half, cm_height)
    items += [Curve(*shape, style="outline", role=0) for shape in shapes]
    items += [Curve(*_turned(shape, half, lean), style="dotted", role=1) for shape in shapes]
    centre = _turned(([0.0], [cm_height]), half, lean)
    items += [
        Mark(0.0, cm_height, "mass centre", aside=(8.0, 6.0), role=0),
        Mark(centre[0][0], centre[1][0], "balance", aside=(8.0, 6.0), role=1),
        Dimension((-half, half), (-0.25, -0.25), worded("{track}", track=(track_width, Length))),
        Dimension((-half - 0.55, -half - 0.55), (0.0, cm_height), ""),
        Label(-half - 0.8, 0.5 * cm_height, worded("{height}", height=(cm_height, Length))),
        Label(half + 0.08, -0.14, "tips here", role=1, left=True),
    ]
    panels = [Panel(Axis("across", Length), Axis("up", Length), tuple(items), equal=True, bare=True)]
    speeds = [(words, float(getattr(made, name))) for name, words in SPEEDS if getattr(made, name) is not None]
    if speeds:
        bars = Bars(tuple(words for words, _ in speeds), [0.0] * len(speeds), [number for _, number in speeds])
        panels.append(Panel(Axis("speed", RoadSpeed), Axis(""), (bars,)))
    return Picture(tuple(panels), "rollover", subtitle=f"stability factor {float(made.stability):.3g}")


def _shapes(half: float, height: float) -> "list[tuple[list[float], list[float]]]":
    """Body, cabin and wheels from behind, in proportion to track and height."""
    floor, belt, roof, side = 0.45 * height, 1.35 * height, 2.2 * height, half
    body = ([-side, -side, side, side, -side], [floor, belt, belt, floor, floor])
    cabin = ([-side, -0.75 * side, 0.75 * side, side], [belt, roof, roof, belt])
    wheels = [([x, x, x + TYRE, x + TYRE, x], [0.0, floor * 1.3, floor * 1.3, 0.0, 0.0]) for x in (-half, half - TYRE)]
    return [body, cabin, *wheels]


def _turned(shape: "tuple[list[float], list[float]]", pivot: float, angle: float) -> "tuple[list[float], list[float]]":
    """A shape turned about the outer wheel's foot, to the right."""
    cosine, sine = math.cos(angle), math.sin(angle)
    x = [pivot + (a - pivot) * cosine + b * sine for a, b in zip(*shape, strict=True)]
    y = [-(a - pivot) * sine + b * cosine for a, b in zip(*shape, strict=True)]
    return x, y
