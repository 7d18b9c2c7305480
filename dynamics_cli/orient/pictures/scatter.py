"""The picture of orientations about their mean."""

from dynamics_cli.pictures import Axis, Band, Bars, Curve, Panel, Picture
from dynamics_cli.quantities import Angle

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# With more orientations than this they are a curve, with fewer a bar each.
MOST_BARS = 20


def average(answer: "Any", **_: "Any") -> Picture:
    """How far each orientation is from the mean, beside the scatter."""
    sizes = [row.deviation for row in answer.deviations]
    scatter, title = answer.scatter, "deviation from the mean"
    if len(sizes) <= MOST_BARS:
        bars = Bars(tuple(row.name for row in answer.deviations), [0.0] * len(sizes), sizes)
        panel = Panel(Axis(title, Angle), Axis(""), (bars, Band(scatter, scatter, "scatter (rms)")))
    else:
        places = list(range(1, len(sizes) + 1))
        level = Curve([1, len(sizes)], [scatter, scatter], "scatter (rms)", "dashed")
        panel = Panel(Axis("number"), Axis(title, Angle), (Curve(places, sizes, "deviation"), level))
    return Picture((panel,), "orientations about their mean")
