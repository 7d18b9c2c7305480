"""Whirl over speed, a machine with and without its absorber, shapes of beams."""

import math

from dynamics_cli.errors import require
from dynamics_cli.numerics.number import plain
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Frequency, ShaftSpeed, Size
from dynamics_cli.vibration.shafts.absorber import amplitude
from dynamics_cli.vibration.shafts.beam import shape
from dynamics_cli.vibration.shafts.campbell import TiltingDisk, diagram
from dynamics_cli.vibration.shafts.whirl import stiffness_of
from dynamics_cli.vibration.single.pictures import over_speed
from dynamics_cli.vibration.systems.pictures import shape_panel

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

POINTS = 401
MOST_SHAPES = 4
HIGHEST = 1e3
GREY = 6


def whirl(
    result: "Any", *, mass: float, shaft: "Any", damping_ratio: float = 0.0, polar_inertia: "float | None" = None,
    diametral_inertia: "float | None" = None, orders: "tuple[float, ...]" = (), highest_speed: "float | None" = None,
    **_: "Any",
) -> Picture:  # fmt: skip
    """The Campbell diagram of a disk that tilts, and the amplitude of the whirl over speed."""
    require(
        result.amplitude is not None,
        "without speed and eccentricity there is no whirl to draw",
        code="missing",
        hint="give --speed and --eccentricity",
    )
    critical, at = plain(result.critical_speed), plain(result.ratio)
    top = max(2.5 * critical, 1.3 * at * critical) if highest_speed is None else plain(highest_speed)
    title = "" if polar_inertia is None else "amplitude, the disk not tilting"
    panels = [over_speed(result, plain(damping_ratio), "whirl", "eccentricity", top, title)]
    if polar_inertia is not None:
        _, springs = stiffness_of(shaft)
        numbers = (plain(part) for part in (*springs, polar_inertia, diametral_inertia))  # type: ignore[misc]
        *parts, polar, diametral = numbers
        disk = TiltingDisk(plain(mass), tuple(parts), polar, diametral)  # type: ignore[arg-type]
        panels.insert(0, _campbell(disk, result.criticals, orders or (1.0,), (at * critical, top)))
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
    items += order_lines(orders, top, ceiling)
    items += [Mark(plain(row.speed), plain(row.frequency), "") for row in criticals if plain(row.speed) <= top]
    axes = Axis("speed", ShaftSpeed, ends=(0.0, top)), Axis("frequency", Frequency, ends=(0.0, ceiling))
    return Panel(*axes, tuple(items), "Campbell diagram")


def order_lines(orders: "tuple[float, ...]", top: float, ceiling: float) -> "list[Any]":
    """A line for each order, named near its end."""
    items: list[Any] = []
    for order in orders:
        end = min(top, ceiling * 2.0 * math.pi / plain(order))
        height = plain(order) * end / (2.0 * math.pi)
        items += [
            Curve([0.0, end], [0.0, height], "", "thin", role=GREY),
            Mark(0.88 * end, 0.88 * height, f"order {plain(order):g}", dot=False),
        ]
    return items


def absorber(result: "Any", *, size: "Any", **_: "Any") -> Picture:
    """Amplitude of the machine with and without the absorber, and with its damper too weak and too strong."""
    mu = plain(size.mass_ratio) if hasattr(size, "mass_ratio") else plain(size.absorber_mass) / plain(size.mass)
    f, zeta = plain(result.frequency_ratio), plain(result.damping_ratio)
    ratios = [0.6 + 0.8 * i / POINTS for i in range(POINTS + 1)]
    curves: list[Any] = []
    for nth, (times, name) in enumerate(((1.0, "as tuned"), (0.4, "less damping"), (2.5, "more damping"))):
        style: Any = "thick" if nth == 0 else "dashed"
        curves.append(Curve(ratios, [amplitude(mu, f, times * zeta, r) for r in ratios], name, style, role=nth))
    alone = [1.0 / abs((1.0 - r) * (1.0 + r)) if r != 1.0 else HIGHEST for r in ratios]
    limit = 4.0 * max(plain(result.lower_peak), plain(result.upper_peak))
    curves.append(Curve(ratios, [y if y < limit else math.nan for y in alone], "without absorber", "thin", role=GREY))
    for r, peak in ((result.lower_ratio, result.lower_peak), (result.upper_ratio, result.upper_peak)):
        curves.append(Mark(plain(r), plain(peak), ""))
    x = Axis("frequency over that of the machine", ends=(ratios[0], ratios[-1]))
    return Picture((Panel(x, Axis("amplitude over F/k", logarithmic=True), tuple(curves)),), "tuned absorber")


def beam(result: "Any", *, ends: str, length: float, **_: "Any") -> Picture:
    """The lowest shapes with their nodes."""
    panels = []
    places = [plain(length) * i / (POINTS - 1) for i in range(POINTS)]
    axis = Axis("along the beam", Size, ends=(0.0, plain(length)))
    for mode in result.modes[:MOST_SHAPES]:
        y = [shape(str(ends), mode.number, i / (POINTS - 1)) for i in range(POINTS)]
        largest = max(map(abs, y))
        nodes = [Mark(node * plain(length), 0.0, "") for node in mode.nodes]
        panels.append(shape_panel(mode, axis, places, [v / largest for v in y], nodes))
    return Picture(tuple(panels), f"beam, {ends}", columns=2 if len(panels) > 1 else 1)
