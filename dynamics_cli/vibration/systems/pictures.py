"""Mode shapes, frequency responses of several masses."""

import math

from dynamics_cli.errors import worded
from dynamics_cli.numerics.number import plain
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Acceleration, Coordinate, Force, Frequency, Size, Time
from dynamics_cli.vibration.systems.inputs import System
from dynamics_cli.vibration.systems.modal import Modal
from dynamics_cli.vibration.systems.response import grid

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

GREY = 6
MOST_SHAPES = 6
POINTS = 2000


def modes(result: "Any", **_: "Any") -> Picture:
    """Each shape over its coordinates."""
    names = tuple(result.coordinates.split(", "))
    panels = []
    for mode in result.modes[:MOST_SHAPES]:
        y = list(mode.shape)
        if mode.phases is not None:
            y = [size * math.cos(math.radians(turn)) for size, turn in zip(y, mode.phases, strict=True)]
        panels.append(shape_over_names(mode, names, y))
    return Picture(tuple(panels), "mode shapes", columns=2 if len(panels) > 1 else 1)


def shape_over_names(mode: "Any", names: "tuple[str, ...]", y: "list[float]") -> Panel:
    """A shape over its coordinates, with a point at each."""
    x = [float(i + 1) for i in range(len(names))]
    return shape_panel(mode, Axis("", names=names, ends=(0.5, len(x) + 0.5)), x, y, [Curve(x, y, "", "points", role=0)])


def shape_panel(mode: "Any", along: Axis, x: "list[float]", y: "list[float]", more: "list[Any]") -> Panel:
    """A shape with its line of rest, named by its number and frequency."""
    title = f"mode {mode.number}"
    if mode.frequency is not None:
        title = worded("mode {n}: {f:5}", n=str(mode.number), f=(plain(mode.frequency), Frequency))
    limit = 1.15 * max(max(map(abs, y)), 1e-300)
    items = (Curve(x, y, role=0), *more, Band(0.0, 0.0, "", vertical=False))
    return Panel(along, Axis("shape", ends=(-limit, limit)), items, title)


def _continuous(angles: "list[float]") -> "list[float]":
    """Angles in degrees without jumps of a turn."""
    result = angles[:1]
    for angle in angles[1:]:
        result.append(angle + 360.0 * round((result[-1] - angle) / 360.0))
    return result


def response(
    result: "Any", *, system: "Any", force_at: str, read_at: str, force: float = 1.0,
    damping_ratio: "float | None" = None, excitation: "Any" = None, **_: "Any",
) -> Picture:  # fmt: skip
    """Amplitude and lag over frequency, and the curve of Nyquist."""
    model = System(system)
    modal = Modal(model, damping_ratio)
    rates = grid(modal)
    curve = modal.curve(rates, modal.shapes[:, model.moving(force_at)], model.moving(read_at)) * abs(force)
    hertz = [float(rate) / (2.0 * math.pi) for rate in rates]
    lags = _continuous([math.degrees(-math.atan2(z.imag, z.real)) % 360.0 for z in curve])
    frequency = Axis("frequency", Frequency, logarithmic=True, ends=(hertz[0], hertz[-1]))
    items: list[Any] = [Curve(hertz, [abs(z) for z in curve], role=0)]
    if result.amplitude is not None:
        at = excitation.frequency if hasattr(excitation, "frequency") else abs(excitation.speed) / (2.0 * math.pi)
        items.append(Mark(at, result.amplitude, "running here"))
    title = f"{read_at} for a force on {force_at}"
    panels = (
        Panel(frequency, Axis("amplitude", Size, logarithmic=True), tuple(items), title),
        Panel(frequency, Axis("lag [deg]", step=90.0), (Curve(hertz, lags, role=0),)),
        Panel(
            Axis("in phase with the force", Coordinate), Axis("across", Coordinate),
            (Curve([z.real for z in curve], [z.imag for z in curve], role=0),), "Nyquist", equal=True,
        ),
    )  # fmt: skip
    return Picture(panels, "frequency response")


def history(
    result: "Any", *, system: "Any", load: "Any", damping_ratio: "float | None" = None, force_at: str = "",
    duration: "float | None" = None, **_: "Any",
) -> Picture:  # fmt: skip
    """The load, and every coordinate over time."""
    from dynamics_cli.vibration.systems.runs import run

    model = System(system)
    motion = run(model, damping_ratio, load, force_at, duration)
    pick = motion.picked(POINTS)
    times = motion.times[pick]
    time = Axis("time", Time, ends=(0.0, float(motion.times[-1])))
    names = [model.names[kept] for kept in model.kept]
    shown = range(len(names)) if len(names) <= MOST_SHAPES else [names.index(result.read)]

    def moves(title: str, over: "Any") -> Panel:
        lines: list[Any] = [
            Curve(times, (motion.places[i] + over)[pick], names[i], role=n) for n, i in enumerate(shown)
        ]
        if motion.moved and title.endswith("space"):
            lines.insert(0, Curve(times, motion.base_place[pick], "base", "thin", role=GREY))
        else:
            lines.append(Mark(result.peak_time, result.peak, result.read))
        return Panel(time, Axis(title, Coordinate), tuple(lines))

    acts = Axis("acceleration of the base", Acceleration) if motion.based else Axis(f"force on {force_at}", Force)
    panels = [moves("against the base" if motion.based else "displacement", 0.0)]
    if motion.moved:
        panels.insert(0, moves("displacement in space", motion.base_place))
    else:
        panels.insert(0, Panel(time, acts, (Curve(times, motion.loads[pick], role=GREY),)))
    return Picture(tuple(panels), "motion from rest")
