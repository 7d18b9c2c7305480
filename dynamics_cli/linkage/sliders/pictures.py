"""Pictures of slider-cranks and quick returns, and a moving SVG."""

from math import cos, pi, sin

from dynamics_cli.animation import animated
from dynamics_cli.errors import worded
from dynamics_cli.linkage.drawing import LEFT, TURN, ZERO, block, circle, here, over_turn, pin, plan, turned
from dynamics_cli.linkage.sliders.quick_return import quick_return
from dynamics_cli.linkage.sliders.slider_crank import slider_crank
from dynamics_cli.linkage.sliders.stroke import RIGHT, End
from dynamics_cli.pictures import Axis, Curve, Panel, Picture, complex_curve
from dynamics_cli.quantities import Acceleration, CamVelocity, Coordinate, Size, Speed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

FRAMES = 120
STEPS = 360
SHOWN = pi / 3.0


def _pins(crank: float, rod: float, offset: float, end: End, angle: float) -> "tuple[complex, complex] | None":
    height = offset - crank * sin(angle)
    if abs(height) > rod:
        return None
    side = 1.0 if end == RIGHT else -1.0
    crank_pin = crank * turned(angle)
    return crank_pin, complex(crank_pin.real + side * ((rod - height) * (rod + height)) ** 0.5, offset)


def slider_picture(
    result: "Any", *, crank: float, rod: float, offset: float = 0.0, crank_angle: "float | None" = None,
    end: End = RIGHT, speed: "float | None" = None, angular_acceleration: float = 0.0, **_: "Any",
) -> Picture:  # fmt: skip
    """The mechanism in several poses; position, velocity and acceleration over the crank angle."""
    if result.crank_angle is not None:
        crank_angle, speed = result.crank_angle, result.crank_speed if speed is None else speed
        angular_acceleration = result.crank_acceleration or angular_acceleration
        end = End("left" if result.position < crank * cos(crank_angle) else "right")
    turning = {"speed": speed, "angular_acceleration": angular_acceleration}
    rows = slider_crank(crank=crank, rod=rod, offset=offset, end=end, steps=STEPS, **turning).table or ()  # type: ignore[arg-type]
    names, axes = ("slope", "bend"), (Axis("velocity v/ω", CamVelocity), Axis("acceleration a/ω²", Coordinate))
    if speed is not None:
        names, axes = ("velocity", "acceleration"), (Axis("velocity v", Speed), Axis("acceleration a", Acceleration))
    columns = {
        name: [float("nan") if getattr(row, name) is None else getattr(row, name) for row in rows]
        for name in ("crank_angle", "position", *names)
    }
    items: list[Any] = []
    for index in range(12):
        pins = _pins(crank, rod, offset, end, index * pi / 6.0)
        if pins:
            items.append(complex_curve((0j, *pins), "", "dots", 6))
    pins = _pins(crank, rod, offset, end, SHOWN if crank_angle is None else crank_angle)
    low, high = min(columns["position"]), max(columns["position"])
    size = 0.1 * rod
    if pins:
        items += [
            complex_curve((0j, pins[0]), "crank", "thick", 0),
            complex_curve(pins, "rod", "thick", 1),
            complex_curve(block(pins[1], size), "slider", "solid", 2),
            pin(pins[0], "A", (-12.0, 5.0)),
        ]
    ends = (complex(low - 1.5 * size, offset), complex(high + 1.5 * size, offset))
    items += [complex_curve(ends, "", "centre", 5), pin(0j, "O", LEFT)]
    angles, bands = columns["crank_angle"], here(crank_angle)
    return Picture(
        (
            plan(items),
            over_turn(Axis("position x", Coordinate), angles, columns["position"], 2, *bands),
            *(over_turn(axis, angles, columns[name], 2, ZERO, *bands) for name, axis in zip(names, axes, strict=True)),
        ),
        worded("slider-crank: crank {a}, rod {b}, offset {e}", a=(crank, Size), b=(rod, Size), e=(offset, Coordinate)),
    )


def moving_slider(
    result: "Any", crank: float = 0.0, rod: float = 0.0, offset: float = 0.0, end: End = RIGHT, **_: "Any"
) -> str:
    """One turn of the crank, or its oscillation between limits, as an animated SVG."""
    del result
    poses = [_pins(crank, rod, offset, end, 2.0 * pi * index / FRAMES) for index in range(FRAMES)]
    every = [pins for pins in poses if pins]
    if len(every) < FRAMES:
        # the poses of one stretch, forward and back
        gaps = [index for index in range(FRAMES) if poses[index] is None]
        start = gaps[-1] + 1
        ordered = [poses[(start + index) % FRAMES] for index in range(FRAMES)]
        stretch = [pins for pins in ordered if pins]
        every = stretch + stretch[::-1]
    size = 0.1 * rod
    frames = [((0j, a), (a, b), block(b, size)) for a, b in every]
    low, high = min(b.real for _, b in every), max(b.real for _, b in every)
    slide = (complex(low - 1.5 * size, offset), complex(high + 1.5 * size, offset))
    return animated("One turn of a slider-crank", frames, [slide], (0j,), [(a, b) for a, b in every])


def quick_return_picture(
    result: "Any", *, crank: float, ground: float, crank_angle: "float | None" = None, lever: "float | None" = None,
    **_: "Any",
) -> Picture:  # fmt: skip
    """Crank and lever in several poses; the lever's angle and speed ratio over the crank angle."""
    pivot = complex(ground)
    length = lever or 1.1 * (crank + ground)
    items: list[Any] = [complex_curve(circle(0j, crank), "path of the pin", "thin", 6)]

    def lever_at(angle: float) -> "tuple[complex, complex]":
        place = crank * turned(angle)
        along = place - pivot
        return place, pivot + length * along / abs(along) if along else pivot

    for index in range(12):
        place, tip = lever_at(index * pi / 6.0 + 1e-9)
        items += [complex_curve((0j, place), "", "dots", 6), complex_curve((pivot, tip), "", "dots", 6)]
    place, tip = lever_at(SHOWN if crank_angle is None else crank_angle)
    items += [
        complex_curve((0j, place), "crank", "thick", 0), complex_curve((pivot, tip), "lever", "thick", 1),
        pin(0j, "O₂", LEFT), pin(pivot, "O₄"), pin(place, "A"),
    ]  # fmt: skip
    rows = quick_return(crank=crank, ground=ground, steps=STEPS).table or ()
    angles, ratios = [row.crank_angle for row in rows], [row.lever_ratio for row in rows]
    words = "the return is where the lever runs against the crank" if crank < ground else ""
    speeds = Panel(TURN, Axis("speed ratio ω₄/ω₂"), (Curve(angles, ratios, role=1), ZERO), words)
    title = worded("quick return: crank {a}, pivots {d} apart", a=(crank, Size), d=(ground, Size))
    return Picture((plan(items), speeds), title)
