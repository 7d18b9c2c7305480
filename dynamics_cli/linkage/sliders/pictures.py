"""Pictures of slider-cranks and quick returns, and a moving SVG."""

from math import cos, pi, sin

from dynamics_cli.animation import animated
from dynamics_cli.errors import worded
from dynamics_cli.linkage.sliders.slider_crank import RIGHT, End, slider_crank
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture, complex_curve
from dynamics_cli.quantities import Acceleration, Angle, CamVelocity, Coordinate, Size, Speed

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
    pin = crank * complex(cos(angle), sin(angle))
    return pin, complex(pin.real + side * ((rod - height) * (rod + height)) ** 0.5, offset)


def _block(at: complex, size: float) -> "list[complex]":
    return [at + size * corner for corner in (-1 - 0.6j, 1 - 0.6j, 1 + 0.6j, -1 + 0.6j, -1 - 0.6j)]


def slider_picture(
    result: "Any", *, crank: float, rod: float, offset: float = 0.0, crank_angle: "float | None" = None,
    end: End = RIGHT, speed: "float | None" = None, angular_acceleration: float = 0.0, **_: "Any",
) -> Picture:  # fmt: skip
    """The mechanism in several poses; position, velocity and acceleration over the crank angle."""
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
            complex_curve(_block(pins[1], size), "slider", "solid", 2),
            Mark(pins[0].real, pins[0].imag, "A", (-12.0, 5.0)),
        ]
    ends = (complex(low - 1.5 * size, offset), complex(high + 1.5 * size, offset))
    items += [complex_curve(ends, "", "centre", 5), Mark(0.0, 0.0, "O", (-14.0, -12.0))]
    scene = Panel(Axis("x", Coordinate), Axis("y", Coordinate), tuple(items), equal=True)
    turn = Axis("crank angle θ", Angle, ends=(0.0, 2.0 * pi), step=pi / 6.0)
    mark = () if crank_angle is None else (Band(crank_angle % (2.0 * pi), crank_angle % (2.0 * pi)),)
    angle = columns["crank_angle"]
    zero = Band(0.0, 0.0, vertical=False)
    return Picture(
        (
            scene,
            Panel(turn, Axis("position x", Coordinate), (Curve(angle, columns["position"], role=2), *mark)),
            *(
                Panel(turn, axis, (Curve(angle, columns[name], role=2), zero, *mark))
                for name, axis in zip(names, axes, strict=True)
            ),
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
    frames = [((0j, a), (a, b), _block(b, size)) for a, b in every]
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
    items: list[Any] = [
        complex_curve(
            [crank * complex(cos(0.01745 * k), sin(0.01745 * k)) for k in range(361)], "path of the pin", "thin", 6
        )
    ]

    def lever_at(angle: float) -> "tuple[complex, complex]":
        pin = crank * complex(cos(angle), sin(angle))
        along = pin - pivot
        return pin, pivot + length * along / abs(along) if along else pivot

    for index in range(12):
        pin, tip = lever_at(index * pi / 6.0 + 1e-9)
        items.append(complex_curve((0j, pin), "", "dots", 6))
        items.append(complex_curve((pivot, tip), "", "dots", 6))
    pin, tip = lever_at(SHOWN if crank_angle is None else crank_angle)
    items += [
        complex_curve((0j, pin), "crank", "thick", 0), complex_curve((pivot, tip), "lever", "thick", 1),
        Mark(0.0, 0.0, "O₂", (-14.0, -12.0)), Mark(ground, 0.0, "O₄"), Mark(pin.real, pin.imag, "A"),
    ]  # fmt: skip
    scene = Panel(Axis("x", Coordinate), Axis("y", Coordinate), tuple(items), equal=True)
    angles = [2.0 * pi * k / STEPS for k in range(STEPS + 1)]
    ratios = []
    for angle in angles:
        place = lever_at(angle)[0]
        way_out = place - pivot
        square = abs(way_out) ** 2
        ratios.append((place * way_out.conjugate()).real / square if square else float("nan"))
    axis = Axis("crank angle θ₂", Angle, ends=(0.0, 2.0 * pi), step=pi / 6.0)
    speeds = Panel(
        axis, Axis("speed ratio ω₄/ω₂"), (Curve(angles, ratios, role=1), Band(0.0, 0.0, vertical=False)),
        "the return is where the lever runs against the crank" if crank < ground else "",
    )  # fmt: skip
    title = worded("quick return: crank {a}, pivots {d} apart", a=(crank, Size), d=(ground, Size))
    return Picture((scene, speeds), title)
