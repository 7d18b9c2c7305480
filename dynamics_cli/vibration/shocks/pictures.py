"""Displacement after a sudden load, shock spectra."""

import math

from dynamics_cli.errors import worded
from dynamics_cli.pictures import Axis, Band, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Acceleration, Coordinate, Frequency, Size, Time, VibrationSpeed
from dynamics_cli.vibration.shocks.shock import Pulse
from dynamics_cli.vibration.shocks.shock import shock as spectrum

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

GREY = 6
# Oscillators in an octave for a smooth curve.
SMOOTH = 24


def transient(result: "Any", **_: "Any") -> Picture:
    """Displacement over time with its peak and the slow value."""
    table = result.history.arrays
    # the side of the peak, as the nearest row of the table has it
    sign = 1.0 if table["displacement"][abs(table["time"] - result.peak_time).argmin()] >= 0.0 else -1.0
    items: tuple[Any, ...] = (
        Curve(table["time"], table["displacement"], role=0),
        Band(sign * result.static, sign * result.static, "if it came slowly", vertical=False),
        Mark(result.peak_time, sign * result.peak, "peak"),
    )
    time = Axis("time", Time, ends=(0.0, float(table["time"][-1])))
    return Picture((Panel(time, Axis("displacement", Coordinate), items),), "after the load")


def shock(result: "Any", *, per_octave: int = 12, **given: "Any") -> Picture:
    """The spectrum, primary and residual, and pseudo-velocity; all scales logarithmic."""
    if per_octave < SMOOTH and isinstance(given["input_"], Pulse):
        result = spectrum(per_octave=SMOOTH, **given)
    table = result.spectrum.arrays
    x = table["frequency"]
    floor = 1e-3 * result.worst
    frequency = Axis("natural frequency", Frequency, logarithmic=True, ends=(float(x[0]), float(x[-1])))
    curves: list[Any] = [Curve(x, table["maximax"], "maximax", "thick", role=0)]
    for name, role in (("primary", 1), ("residual", 2)):
        curves.append(Curve(x, [max(float(y), floor) for y in table[name]], name, "dashed", role=role))
    curves.append(Band(result.peak_input, result.peak_input, "peak of the input", vertical=False))
    panels = (
        Panel(frequency, Axis("acceleration", Acceleration, logarithmic=True), tuple(curves)),
        _four_way(x, table["pseudo_velocity"]),
    )
    quality = "undamped" if result.quality is None else f"Q = {result.quality:.3g}"
    return Picture(panels, f"shock response spectrum, {quality}")


def _decades(low: float, high: float) -> "list[float]":
    """Powers of ten between two numbers."""
    return [10.0**n for n in range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)]


def _four_way(x: "Any", y: "Any") -> Panel:
    """Pseudo-velocity over frequency, with lines of equal displacement and acceleration, a decade apart."""
    left, right = float(x[0]), float(x[-1])
    bottom, top = 0.5 * max(float(min(y)), 1e-3 * float(max(y))), 2.0 * float(max(y))
    turn = 2.0 * math.pi
    items: list[Any] = []
    # V = 2πf·d rises, V = a/(2πf) falls
    for kind, unit, sign, low, high in (
        (Size, 1e-3, 1.0, bottom / (turn * right), top / (turn * left)),
        (Acceleration, 1.0, -1.0, bottom * turn * left, top * turn * right),
    ):
        for value in (unit * part for part in _decades(low / unit, high / unit)):
            meets = [(v / (turn * value)) if sign > 0.0 else value / (turn * v) for v in (bottom, top)]
            ends = [min(max(f, left), right) for f in sorted(meets)]
            if ends[1] < 1.3 * ends[0]:
                continue
            speeds = [turn * f * value if sign > 0.0 else value / (turn * f) for f in ends]
            items.append(Curve(ends, speeds, "", "dotted", role=GREY))
            # displacements are named at the beginning of their lines, accelerations at the end
            inset = math.log(right / left)
            at = ends[0] * math.exp(0.11 * inset) if sign > 0.0 else ends[1] * math.exp(-0.07 * inset)
            height = turn * at * value if sign > 0.0 else value / (turn * at)
            if max(ends[0], 1.3 * left) < at < ends[1]:
                items.append(Label(at, height, worded("{value:6}", value=(value, kind))))
    items.append(Curve(x, y, "", "thick", role=0))
    axes = (Axis("natural frequency", Frequency, logarithmic=True, ends=(left, right)),
            Axis("pseudo-velocity", VibrationSpeed, logarithmic=True, ends=(bottom, top)))  # fmt: skip
    return Panel(*axes, tuple(items), "four-way: dotted lines of displacement (rising) and acceleration (falling)")
