"""Displacement after a sudden load, shock spectra."""

from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Acceleration, Coordinate, Frequency, Time, VibrationSpeed
from dynamics_cli.vibration.shocks.shock import Pulse
from dynamics_cli.vibration.shocks.shock import shock as spectrum

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

GREY = 6
# Oscillators in an octave for a smooth curve.
SMOOTH = 24


def transient(made: "Any", **_: "Any") -> Picture:
    """Displacement over time with its peak and the slow value."""
    table = made.history.arrays
    sign = 1.0 if made.peak >= 0.0 else -1.0
    items: tuple[Any, ...] = (
        Curve(table["time"], table["displacement"], role=0),
        Band(sign * made.static, sign * made.static, "if it came slowly", vertical=False),
        Mark(made.peak_time, made.peak, "peak"),
    )
    time = Axis("time", Time, ends=(0.0, float(table["time"][-1])))
    return Picture((Panel(time, Axis("displacement", Coordinate), items),), "after the load")


def shock(made: "Any", *, per_octave: int = 12, **given: "Any") -> Picture:
    """The spectrum, primary and residual, and pseudo-velocity; all scales logarithmic."""
    if per_octave < SMOOTH and isinstance(given["input_"], Pulse):
        made = spectrum(per_octave=SMOOTH, **given)
    table = made.spectrum.arrays
    x = table["frequency"]
    floor = 1e-3 * made.worst
    frequency = Axis("natural frequency", Frequency, logarithmic=True, ends=(float(x[0]), float(x[-1])))
    curves: list[Any] = [Curve(x, table["maximax"], "maximax", "thick", role=0)]
    for name, role in (("primary", 1), ("residual", 2)):
        curves.append(Curve(x, [max(float(y), floor) for y in table[name]], name, "dashed", role=role))
    curves.append(Band(made.peak_input, made.peak_input, "peak of the input", vertical=False))
    panels = (
        Panel(frequency, Axis("acceleration", Acceleration, logarithmic=True), tuple(curves)),
        Panel(
            frequency, Axis("pseudo-velocity", VibrationSpeed, logarithmic=True),
            (Curve(x, table["pseudo_velocity"], role=0),),
        ),
    )  # fmt: skip
    quality = "undamped" if made.quality is None else f"Q = {made.quality:.3g}"
    return Picture(panels, f"shock response spectrum, {quality}")
