"""Campbell diagrams, shapes and orbits of rotors over speed."""

import math

from dynamics_cli.pictures import Axis, Band, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, Frequency, ShaftSpeed, Size
from dynamics_cli.vibration.rotors.response import built, orbit, speeds_of
from dynamics_cli.vibration.rotors.stepped import Material
from dynamics_cli.vibration.shafts.rotor_pictures import order_lines

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

GREY = 6
POINTS = 100
MOST = 4
# Below this share of the range an amplitude is too small to be drawn beside a peak.
START = 0.05


def rotor(
    result: "Any", *, bearings: "Any", disks: "Any" = (), orders: "tuple[float, ...]" = (1.0,),
    speed: "float | None" = None, **_: "Any",
) -> Picture:  # fmt: skip
    """The Campbell diagram of a rotor, and its shapes at the critical speeds of unbalance."""
    rows = result.campbell
    speeds = [row.speed for row in rows]
    top = speeds[-1]
    shown = min(len(rows[0].forward), 3)
    ceiling = 1.08 * max(max(row.forward[shown - 1] for row in rows[:1]), max(orders) * top / (2.0 * math.pi))
    items: list[Any] = [Band(abs(speed), abs(speed), "running here")] if speed else []
    for nth in range(len(rows[0].forward)):
        for whirl, style in (("forward", "solid"), ("backward", "dashed")):
            heights = [getattr(row, whirl)[nth] for row in rows]
            if heights[0] < ceiling:
                items.append(Curve(speeds, heights, f"{nth + 1} {whirl}", style, role=nth))  # type: ignore[arg-type]
    items += order_lines(orders, top, ceiling)
    items += [
        Mark(row.speed, row.frequency, "") for row in result.criticals if row.speed <= top and row.frequency < ceiling
    ]
    axes = Axis("speed", ShaftSpeed, ends=(0.0, top)), Axis("frequency", Frequency, ends=(0.0, ceiling))
    along = Axis("along the shaft", Size)
    places = [row.position for row in result.shapes]
    curves = [
        Curve(places, [getattr(row, name) for row in result.shapes], f"{nth} forward", role=nth - 1)
        for nth, name in enumerate(("first", "second", "third"), 1)
        if result.shapes and getattr(result.shapes[0], name) is not None
    ]
    parts: list[Any] = [Band(0.0, 0.0, "", vertical=False)]
    parts += [Curve([disk.position] * 2, [-0.25, 0.25], "", "thick", role=GREY) for disk in disks]
    parts += [Label(bearing.position, -0.07, "▲") for bearing in bearings]
    bent = Panel(along, Axis("deflection", ends=(-1.1, 1.1)), (*parts, *curves),
                 "shapes at critical speeds")  # fmt: skip
    panels = (Panel(*axes, tuple(items), "Campbell diagram"), *((bent,) if curves else ()))
    return Picture(panels, "whirl of a rotor", columns=1)


def rotor_response(
    result: "Any", *, sections: "Any", bearings: "Any", disks: "Any" = (), unbalances: "Any" = (),
    speed: "float | None" = None, read_at: "Any" = (), elastic_modulus: float = 210e9, poisson_ratio: float = 0.3,
    density: float = 7850.0, **_: "Any",
) -> Picture:  # fmt: skip
    """Amplitude and lag at each place read, frequencies and decrements of free whirls, over speed."""
    top = result.campbell[-1].speed
    material = Material(elastic_modulus, poisson_ratio, density)
    system, stations, rotor = built(sections, bearings, disks, unbalances, read_at, material)
    along = Axis("speed", ShaftSpeed, ends=(0.0, top))
    here: list[Any] = [Band(abs(speed), abs(speed), "running here")] if speed else []
    rows = result.campbell
    speeds = [row.speed for row in rows]
    count = min(min(len(row.frequencies) for row in rows), MOST)
    ceiling = 1.08 * max(row.frequencies[count - 1] for row in rows)
    unnamed: list[Any] = [Band(band.low, band.high) for band in here]
    whirls, losses = list(unnamed), [*unnamed, Band(0.0, 0.0, "", vertical=False)]
    for nth in range(count):
        whirls.append(Curve(speeds, [row.frequencies[nth] for row in rows], f"mode {nth + 1}", role=nth))
        losses.append(Curve(speeds, [row.decrements[nth] for row in rows], f"mode {nth + 1}", role=nth))
    if result.onset:
        losses.append(Band(result.onset, top, "unstable"))
    whirls += order_lines((1.0,), top, ceiling)
    panels = [
        Panel(along, Axis("frequency", Frequency, ends=(0.0, ceiling)), tuple(whirls), "free whirls"),
        Panel(along, Axis("logarithmic decrement"), tuple(losses)),
    ]
    if result.orbits is not None or result.peaks is not None:
        panels = [*_curves(rotor, system, stations, top, along, result.peaks, here), *panels]
    return Picture(tuple(panels), "a rotor over speed", columns=2)


def _curves(
    rotor: "Any", system: "Any", stations: "list[int]", top: float, along: Axis, peaks: "Any", here: "list[Any]"
) -> "list[Panel]":
    """Amplitude and lag, horizontal and vertical, of every place read."""
    from numpy import unwrap

    points = [at for at in speeds_of(rotor, top, POINTS) if at > START * top]
    motions = rotor.responses(points)
    sizes: list[Any] = list(here)
    lags: list[Any] = [Band(band.low, band.high) for band in here]
    for nth, station in enumerate(stations[:MOST]):
        place = system.stations[station]
        rows = [orbit(rotor, place, station, at, motion) for at, motion in zip(points, motions, strict=True)]
        for way, style in (("horizontal", "solid"), ("vertical", "dashed")):
            name = f"{way} at {nth + 1}" if len(stations) > 1 else way
            sizes.append(Curve(points, [getattr(row, way) for row in rows], name, style, role=nth))  # type: ignore[arg-type]
            turned = unwrap([getattr(row, f"{way}_lag") for row in rows])
            lags.append(Curve(points, turned, "", style, role=nth))  # type: ignore[arg-type]
    moves = any(max(item.y) > 0.0 for item in sizes if isinstance(item, Curve))
    amplitude = Axis("amplitude", Size, logarithmic=moves)
    return [
        Panel(along, amplitude, tuple(sizes), "response to unbalance"),
        Panel(along, Axis("lag", Angle, step=math.pi / 2.0), tuple(lags)),
    ]
