"""Whirl over speed, a machine with and without its absorber, shapes of beams."""

import math

from dynamics_cli.errors import worded
from dynamics_cli.numerics.number import plain
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Frequency, ShaftSpeed, Size
from dynamics_cli.vibration.shafts.absorber import amplitude
from dynamics_cli.vibration.shafts.beam import shape
from dynamics_cli.vibration.shafts.campbell import TiltingDisk, diagram
from dynamics_cli.vibration.shafts.whirl import stiffness_of
from dynamics_cli.vibration.single.forced import magnification

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

POINTS = 401
MOST_SHAPES = 4
HIGHEST = 1e3
GREY = 6


def whirl(
    made: "Any", *, mass: float, shaft: "Any", damping_ratio: float = 0.0, polar_inertia: "float | None" = None,
    diametral_inertia: "float | None" = None, orders: "tuple[float, ...]" = (), highest_speed: "float | None" = None,
    **_: "Any",
) -> Picture:  # fmt: skip
    """The Campbell diagram of a disk that tilts, and the amplitude of the whirl over speed."""
    critical, at = plain(made.critical_speed), plain(made.ratio)
    top = max(2.5 * critical, 1.3 * at * critical) if highest_speed is None else plain(highest_speed)
    panels = [_whirl_amplitude(made, critical, at, plain(damping_ratio), top)]
    if polar_inertia is not None:
        _, springs = stiffness_of(shaft)
        numbers = (plain(part) for part in (*springs, polar_inertia, diametral_inertia))  # type: ignore[misc]
        *parts, polar, diametral = numbers
        disk = TiltingDisk(plain(mass), tuple(parts), polar, diametral)  # type: ignore[arg-type]
        panels.insert(0, _campbell(disk, made.criticals, orders or (1.0,), (at * critical, top)))
    return Picture(tuple(panels), "whirl of a disk on a shaft", columns=1)


def _campbell(disk: TiltingDisk, criticals: "Any", orders: "tuple[float, ...]", ends: "tuple[float, float]") -> Panel:
    """Whirl frequencies over speed, the lines of the orders, and where they meet."""
    at, top = ends
    rows = diagram(disk, top, POINTS // 4)
    speeds = [row.speed for row in rows]
    ceiling = 1.08 * min(rows[-1].second_forward, 3.0 * rows[0].second_forward)
    items: list[Any] = [Band(at, at, "running here")]
    for nth, mode in enumerate(("first", "second")):
        for whirl, style in (("forward", "solid"), ("backward", "dashed")):
            heights = [getattr(row, f"{mode}_{whirl}") for row in rows]
            items.append(Curve(speeds, heights, f"{nth + 1} {whirl}", style, role=nth))  # type: ignore[arg-type]
    for order in orders:
        end = min(top, ceiling * 2.0 * math.pi / plain(order))
        height = plain(order) * end / (2.0 * math.pi)
        items += [
            Curve([0.0, end], [0.0, height], "", "thin", role=GREY),
            Mark(0.88 * end, 0.88 * height, f"order {plain(order):g}", dot=False),
        ]
    items += [Mark(plain(row.speed), plain(row.frequency), "") for row in criticals if plain(row.speed) <= top]
    axes = Axis("speed", ShaftSpeed, ends=(0.0, top)), Axis("frequency", Frequency, ends=(0.0, ceiling))
    return Panel(*axes, tuple(items), "Campbell diagram")


def _whirl_amplitude(made: "Any", critical: float, at: float, damping_ratio: float, end: float) -> Panel:
    """Amplitude of the whirl over speed, the disk not tilting."""
    off, top = plain(made.amplitude) / plain(made.response), end / critical
    ratios = sorted({top * i / POINTS for i in range(1, POINTS + 1)} | {1.0 + i / 4000.0 for i in range(-80, 81)})
    sizes = []
    for r in ratios:
        gap = (1.0 - r) * (1.0 + r)
        size = r * r * magnification(gap, r, damping_ratio)[0] if gap or damping_ratio else HIGHEST
        sizes.append(off * size if size < HIGHEST else math.nan)
    items: list[Any] = [Curve([r * critical for r in ratios], sizes, role=0), Band(critical, critical, "critical")]
    items += [
        Band(off, off, "eccentricity", vertical=False),
        Mark(at * critical, plain(made.amplitude), "running here"),
    ]
    axes = Axis("speed", ShaftSpeed, ends=(0.0, end)), Axis("whirl", Size, logarithmic=True)
    return Panel(*axes, tuple(items), "amplitude, the disk not tilting" if made.forward_speed is not None else "")


def absorber(made: "Any", *, size: "Any", **_: "Any") -> Picture:
    """Amplitude of the machine with and without the absorber, and with its damper too weak and too strong."""
    mu = plain(size.mass_ratio) if hasattr(size, "mass_ratio") else plain(size.absorber_mass) / plain(size.mass)
    f, zeta = plain(made.frequency_ratio), plain(made.damping_ratio)
    ratios = [0.6 + 0.8 * i / POINTS for i in range(POINTS + 1)]
    curves: list[Any] = []
    for nth, (times, name) in enumerate(((1.0, "as tuned"), (0.4, "less damping"), (2.5, "more damping"))):
        style: Any = "thick" if nth == 0 else "dashed"
        curves.append(Curve(ratios, [amplitude(mu, f, times * zeta, r) for r in ratios], name, style, role=nth))
    alone = [1.0 / abs((1.0 - r) * (1.0 + r)) if r != 1.0 else HIGHEST for r in ratios]
    limit = 4.0 * max(plain(made.lower_peak), plain(made.upper_peak))
    curves.append(Curve(ratios, [y if y < limit else math.nan for y in alone], "without absorber", "thin", role=GREY))
    for r, peak in ((made.lower_ratio, made.lower_peak), (made.upper_ratio, made.upper_peak)):
        curves.append(Mark(plain(r), plain(peak), f"{plain(peak):.4g}"))
    x = Axis("frequency over that of the machine", ends=(ratios[0], ratios[-1]))
    return Picture((Panel(x, Axis("amplitude over F/k", logarithmic=True), tuple(curves)),), "tuned absorber")


def beam(made: "Any", *, ends: str, length: float, **_: "Any") -> Picture:
    """The lowest shapes with their nodes."""
    panels = []
    shares = [i / (POINTS - 1) for i in range(POINTS)]
    for mode in made.modes[:MOST_SHAPES]:
        y = [shape(str(ends), mode.number, x) for x in shares]
        largest = max(map(abs, y))
        items: list[Any] = [Curve([x * plain(length) for x in shares], [v / largest for v in y], role=0)]
        items += [Mark(node * plain(length), 0.0, "") for node in mode.nodes]
        items.append(Band(0.0, 0.0, "", vertical=False))
        title = worded("mode {n}: {f:5}", n=str(mode.number), f=(plain(mode.frequency), Frequency))
        x_axis = Axis("along the beam", Size, ends=(0.0, plain(length)))
        panels.append(Panel(x_axis, Axis("shape", ends=(-1.15, 1.15)), tuple(items), title))
    return Picture(tuple(panels), f"beam, {ends}", columns=2 if len(panels) > 1 else 1)
