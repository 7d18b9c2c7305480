"""Forces over ways and times with the areas below them; resistance and power of a vehicle over its speed."""

from dynamics_cli.energy.power import AtSpeed
from dynamics_cli.energy.power import drive as driven
from dynamics_cli.errors import worded
from dynamics_cli.numerics.number import plain
from dynamics_cli.pictures import Axis, Bars, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Force, Impulse, Length, PotentialEnergy, Power, RoadSpeed, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

POINTS = 100
# A vehicle's curves go this far beyond the speed in question.
BEYOND = 1.25
NAMES = {
    "constant": "the force", "couple": "the couple", "weight": "gravity", "rubbing": "friction", "spring": "the spring",
    "measured": "the measured force",
}  # fmt: skip


def work(made: "Any", *, measured: "Any" = None, **_: "Any") -> Picture:
    """The measured force over the way with its area, and the work of each as bars."""
    panels = []
    if measured is not None:
        x, y = _traced(measured.positions, measured.forces, str(measured.between))
        title = worded("area {work}", work=(plain(made.measured), PotentialEnergy))
        panels.append(Panel(Axis("position", Length), Axis("force", Force), _area(x, y), title))
    works = {NAMES[name]: getattr(made, name) for name in NAMES if getattr(made, name) is not None}
    if len(works) > 1 or not panels:
        works["all"] = made.total
        values = [plain(value) for value in works.values()]
        bars = Bars(tuple(works), [min(value, 0.0) for value in values], [max(value, 0.0) for value in values])
        panels.append(Panel(Axis("work", PotentialEnergy), Axis(""), (bars,)))
    return Picture(tuple(panels), "work")


def impulse(made: "Any", *, cause: "Any", **_: "Any") -> Picture:
    """The force over time, its area, and its mean."""
    if hasattr(cause, "times"):
        x, y = _traced(cause.times, cause.forces, str(cause.between))
    else:
        x, y = [0.0, plain(made.duration)], [plain(made.mean_force)] * 2
    mean = plain(made.mean_force)
    items = (*_area(x, y), Curve([x[0], x[-1]], [mean, mean], "mean", "dashed", role=1))
    title = worded("area {impulse}", impulse=(plain(made.impulse), Impulse))
    return Picture((Panel(Axis("time", Time), Axis("force", Force), items, title),), "impulse")


def drive(made: "Any", *, at: "Any", efficiency: float = 1.0, **rest: "Any") -> Picture:
    """Resistances and the power for them over the speed, with the point in question."""
    given = {name: plain(value) for name, value in rest.items() if value is not None}
    end = plain(made.speed)
    speeds = [BEYOND * end * k / POINTS for k in range(1, POINTS + 1)]
    states = [driven(at=AtSpeed(speed), efficiency=plain(efficiency), **given) for speed in speeds]
    forces = (
        Curve(speeds, [state.force for state in states], "all", "thick", role=0),
        Curve(speeds, [state.drag for state in states], "drag", "dashed", role=1),
        Curve(speeds, [state.force - state.drag for state in states], "without drag", "dotted", role=2),
        Mark(end, plain(made.force), "", role=0),
    )
    powers = (
        Curve(speeds, [state.power for state in states], "", "thick", role=0),
        Mark(end, plain(made.power), worded("{power}", power=(plain(made.power), Power)), (-6.0, 6.0), role=0),
    )
    axis = Axis("speed", RoadSpeed, ends=(0.0, BEYOND * end))
    panels = (Panel(axis, Axis("force at the wheels", Force), forces), Panel(axis, Axis("power", Power), powers))
    return Picture(panels, "vehicle on a road")


def _area(x: "Sequence[float]", y: "Sequence[float]") -> "tuple[Curve, Curve]":
    return (
        Curve([x[0], *x, x[-1]], [0.0, *y, 0.0], "", "fill", role=0),
        Curve(x, y, "", "solid", role=0),
    )


def _traced(places: "Any", values: "Any", between: str) -> "tuple[list[float], list[float]]":
    x, y = [plain(place) for place in places], [plain(value) for value in values]
    if between != "steps":
        return x, y
    return [place for place in x for _ in (0, 1)][1:-1], [value for value in y[:-1] for _ in (0, 1)]
