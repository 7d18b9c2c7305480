"""Displacement over time, frequency response, transmissibility by damping, peaks of a decay."""

import math

from dynamics_cli.numerics.number import plain
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, Coordinate, Frequency, ShaftSpeed, Size, Time
from dynamics_cli.vibration.single.base import transmitted
from dynamics_cli.vibration.single.decrement import Peaks, Recorded, peaks_of
from dynamics_cli.vibration.single.forced import forced as forced_at
from dynamics_cli.vibration.single.forced import magnification
from dynamics_cli.vibration.single.free import DryFriction
from dynamics_cli.vibration.single.free import free as free_at

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

POINTS = 401
GREY = 6
# A curve ends where it leaves the frame at an undamped resonance.
HIGHEST = 1e4


def free(result: "Any", **given: "Any") -> Picture:
    """Displacement over time with its envelope."""
    given = {name: part for name, part in given.items() if name != "time"}
    dry = isinstance(given.get("damping"), DryFriction)
    if not given.get("displacement") and not given.get("start_velocity"):
        given["displacement"] = 0.01
    omega, zeta = plain(result.angular_frequency), plain(result.damping_ratio or 0.0)
    cycles = 6.0 if zeta < 0.05 else 4.0 if zeta < 0.3 else 2.0 + zeta
    end = 1.25 * plain(result.stop_time) if dry and result.stop_time else cycles * 2.0 * math.pi / omega
    times = [end * i / (POINTS - 1) for i in range(POINTS)]
    places = [plain(free_at(**given, time=t).position) for t in times]
    items: list[Any] = [Curve(times, places, role=0)]
    if result.amplitude and 0.0 < zeta < 1.0:
        edge = [plain(result.amplitude) * math.exp(-zeta * omega * t) for t in times]
        items.append(Curve(times, edge, "envelope", "dashed", role=GREY))
        items.append(Curve(times, [-y for y in edge], "", "dashed", role=GREY))
    if dry:
        band = plain(result.dead_band)
        items.append(Band(-band, band, "held by friction", vertical=False))
        items.append(Mark(plain(result.stop_time), plain(result.rest_position), "at rest", (6.0, 14.0)))
    panel = Panel(Axis("time", Time, ends=(0.0, end)), Axis("displacement", Coordinate), tuple(items))
    return Picture((panel,), f"free vibration, {result.motion}")


def _ratios(at: float) -> "list[float]":
    """Frequency ratios, closer about the resonance."""
    low, high = min(0.1, 0.5 * at), max(3.0, 1.5 * at)
    even = [low * (high / low) ** (i / (POINTS - 1)) for i in range(POINTS)]
    near = [1.0 + side * 10.0 ** (-4.0 + 3.5 * i / 80.0) for i in range(81) for side in (-1.0, 1.0)]
    return sorted({*even, *(r for r in near if low < r < high)})


def _height(value: "Callable[[], float]") -> float:
    try:
        height = value()
    except ZeroDivisionError:
        return math.nan
    return height if height < HIGHEST else math.nan


def _from_rest(given: "dict[str, Any]") -> Panel:
    """Displacement over time, from rest."""
    end = given.pop("time")
    times = [end * i / (4 * POINTS) for i in range(4 * POINTS + 1)]
    places = [plain(forced_at(**given, time=t).position) for t in times]
    return Panel(Axis("time", Time, ends=(0.0, end)), Axis("displacement", Coordinate), (Curve(times, places, role=0),))


def forced(result: "Any", **given: "Any") -> Picture:
    """Amplitude and phase over frequency, or the displacement from rest where a time is given."""
    if given.get("time"):
        return Picture((_from_rest(given),), "vibration from rest")
    zeta, at, hertz = plain(result.damping_ratio), plain(result.ratio), plain(result.natural_frequency)
    ratios = _ratios(at)
    still = None if result.amplitude is None else plain(result.amplitude) / plain(result.magnification)
    scale = 1.0 if still is None else still
    high = [_height(lambda r=r: magnification((1.0 - r) * (1.0 + r), r, zeta)[0]) for r in ratios]  # type: ignore[misc]
    lags = [magnification((1.0 - r) * (1.0 + r), r, zeta)[1] if r != 1.0 else 0.5 * math.pi for r in ratios]
    x = [r * hertz for r in ratios]
    items: list[Any] = [Curve(x, [scale * h for h in high], role=0)]
    lines: list[Any] = [Curve(x, lags, role=0)]
    if result.amplitude is not None:
        items.append(Mark(at * hertz, plain(result.amplitude), "running here"))
        lines.append(Mark(at * hertz, plain(result.phase), ""))
    if result.lower_frequency is not None:
        items.append(Band(plain(result.lower_frequency), plain(result.upper_frequency), "half power"))
    frequency = Axis("frequency", Frequency, logarithmic=True, ends=(x[0], x[-1]))
    panels = (
        Panel(frequency, Axis("amplitude", Size, logarithmic=True), tuple(items)),
        Panel(frequency, Axis("lag", Angle, step=math.pi / 4.0, ends=(0.0, math.pi)), tuple(lines)),
    )
    return Picture(panels, "frequency response")


def _family(zeta: float) -> "list[float]":
    """Damping ratios beside the one that is there."""
    others = [one for one in (0.05, 0.1, 0.2, 0.5) if abs(math.log((zeta or 1e-9) / one)) > 0.3]
    return others[:4]


def _transmissibility(ratios: "list[float]", zeta: float, marks: "list[Any]") -> Panel:
    items: list[Any] = []
    for nth, one in enumerate([zeta, *_family(zeta)]):
        high = [_height(lambda r=r, one=one: transmitted((1.0 - r) * (1.0 + r), r, one)[0]) for r in ratios]  # type: ignore[misc]
        items.append(Curve(ratios, high, f"ζ = {one:.3g}", "thick" if nth == 0 else "thin", role=nth))
    items += [Band(1.0, 1.0, "", vertical=False), Band(math.sqrt(2.0), math.sqrt(2.0), "√2"), *marks]
    x = Axis("frequency over natural frequency", logarithmic=True, ends=(ratios[0], ratios[-1]))
    return Panel(x, Axis("transmissibility", logarithmic=True), tuple(items))


def base(result: "Any", **_: "Any") -> Picture:
    """Transmissibility over the frequency ratio, for several damping ratios."""
    zeta, at = plain(result.damping_ratio), plain(result.ratio)
    mark = Mark(at, plain(result.transmissibility), "running here", (-6.0, -14.0))
    return Picture((_transmissibility(_ratios(at), zeta, [mark]),), "transmissibility")


def isolator(result: "Any", *, damping_ratio: float = 0.0, **_: "Any") -> Picture:
    """Transmissibility with the mounts."""
    at = plain(result.ratio)
    mark = Mark(at, plain(result.transmissibility), "these mounts", (-6.0, -14.0))
    return Picture((_transmissibility(_ratios(at), plain(damping_ratio), [mark]),), "transmissibility")


def unbalance(result: "Any", **_: "Any") -> Picture:
    """Amplitude over speed."""
    panel = over_speed(result, plain(result.damping_ratio), "amplitude", "U/M")
    return Picture((panel,), "vibration from unbalance")


def over_speed(result: "Any", zeta: float, name: str, eccentricity: str, top: float = 0.0, title: str = "") -> Panel:
    """Amplitude r²·H of an eccentric mass over speed, with the critical speed; to `top`, or as far as it takes."""
    at, omega, eccentric = (
        plain(result.ratio),
        plain(result.critical_speed),
        plain(result.amplitude) / plain(result.response),
    )
    end = top / omega or max(3.0, 1.5 * at)
    ratios = [r for r in _ratios(max(at, end / 1.5)) if r <= end]
    high = [
        eccentric * _height(lambda r=r: r * r * magnification((1.0 - r) * (1.0 + r), r, zeta)[0])  # type: ignore[misc]
        for r in ratios
    ]
    items = (
        Curve([r * omega for r in ratios], high, role=0),
        Mark(at * omega, plain(result.amplitude), "running here"),
        Band(omega, omega, "critical"),
        Band(eccentric, eccentric, "", vertical=False),
        # beside its line: in a legend it looks like the critical speed
        Mark(0.0, eccentric, eccentricity, (4.0, 4.0), dot=False),
    )
    axes = Axis("speed", ShaftSpeed, ends=(0.0, end * omega)), Axis(name, Size, logarithmic=True)
    return Panel(*axes, items, title)


def decrement(result: "Any", *, measured: "Any", **_: "Any") -> Picture:
    """Peaks on a logarithmic scale with their line, or the resonance with its band."""
    if not isinstance(measured, Peaks | Recorded):
        zeta, hertz = plain(result.damping_ratio), plain(result.natural_frequency)
        ratios = [r for r in _ratios(1.0) if 0.6 < r < 1.6]
        high = [magnification((1.0 - r) * (1.0 + r), r, zeta)[0] for r in ratios]
        band = Band(plain(measured.lower_frequency), plain(measured.upper_frequency), "half power")
        items: tuple[Any, ...] = (Curve([r * hertz for r in ratios], high, role=0), band)
        return Picture((Panel(Axis("frequency", Frequency), Axis("magnification"), items),), "resonance")
    sizes = [plain(one) for one in (measured.peaks if isinstance(measured, Peaks) else peaks_of(measured.file)[1])]
    every = measured.every if isinstance(measured, Peaks) else 1
    cycles = [float(every * i) for i in range(len(sizes))]
    mean = sum(map(math.log, sizes)) / len(sizes)
    middle = sum(cycles) / len(cycles)
    line = [math.exp(mean - plain(result.decrement) * (n - middle)) for n in cycles]
    items = (Curve(cycles, sizes, "peaks", "points", role=0), Curve(cycles, line, "least squares", role=1))
    panel = Panel(Axis("cycles"), Axis("peak", logarithmic=True), items)
    return Picture((panel,), f"decay, ζ = {plain(result.damping_ratio):.4g}")
