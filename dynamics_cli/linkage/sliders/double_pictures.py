"""Pictures of scotch yokes, Oldham couplings and trammels."""

from math import cos, pi, sin, tan

from dynamics_cli.errors import worded
from dynamics_cli.linkage.sliders.pictures import _block
from dynamics_cli.pictures import Arrow, Axis, Band, Curve, Mark, Panel, Picture, complex_curve
from dynamics_cli.quantities import Angle, CamVelocity, Coordinate, Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

STEPS = 180


def _wave(angle: float) -> complex:
    return complex(cos(angle), sin(angle))


def _circle(centre: complex, radius: float) -> "list[complex]":
    return [centre + radius * _wave(2.0 * pi * k / STEPS) for k in range(STEPS + 1)]


def _flat(items: "list[Any]") -> Panel:
    return Panel(Axis("x", Coordinate), Axis("y", Coordinate), tuple(items), equal=True)


def yoke_picture(
    result: "Any", *, crank: float, crank_angle: float = 0.0, slot_angle: float = 0.0, **_: "Any"
) -> Picture:
    """Crank and yoke to scale; position, velocity and acceleration over a turn."""
    reach, lean = crank / cos(slot_angle), tan(slot_angle)
    pin = crank * _wave(crank_angle)
    slot = complex(result.position)
    half = 1.2 * crank * complex(lean, 1.0)
    edge = 0.12 * crank / cos(slot_angle)
    items: list[Any] = [
        complex_curve(_circle(0j, crank), "", "thin", 6),
        complex_curve((complex(-2.6 * reach), complex(2.6 * reach)), "", "centre", 5),
        complex_curve(
            (slot - half - edge, slot + half - edge, slot + half + edge, slot - half + edge, slot - half - edge),
            "yoke",
            "solid",
            1,
        ),
        complex_curve((slot + edge, slot + edge + 1.3 * reach), "", "solid", 1),
        complex_curve((0j, pin), "crank", "thick", 0),
        Mark(0.0, 0.0, "O", (-14.0, -12.0)),
        Mark(pin.real, pin.imag, "A"),
    ]
    angles = [2.0 * pi * k / STEPS for k in range(STEPS + 1)]
    place = [reach * cos(angle + slot_angle) for angle in angles]
    slope = [-reach * sin(angle + slot_angle) for angle in angles]
    axis = Axis("crank angle θ", Angle, ends=(0.0, 2.0 * pi), step=pi / 6.0)
    mark = Band(crank_angle % (2.0 * pi), crank_angle % (2.0 * pi))
    zero = Band(0.0, 0.0, vertical=False)
    return Picture(
        (
            _flat(items),
            Panel(axis, Axis("position x", Coordinate), (Curve(angles, place, role=1), zero, mark)),
            Panel(axis, Axis("velocity v/ω", CamVelocity), (Curve(angles, slope, role=1), zero, mark)),
            Panel(
                axis, Axis("acceleration a/ω²", Coordinate), (Curve(angles, [-x for x in place], role=1), zero, mark)
            ),
        ),
        worded("scotch yoke: crank {a}, stroke {s}", a=(crank, Size), s=(result.stroke, Size)),
    )


def oldham_picture(result: "Any", *, offset: float, shaft_angle: float = 0.0, **_: "Any") -> Picture:
    """The shafts' axes, both slots, and the circle on which the disc's centre goes round."""
    centre = complex(*result.centre)
    direction = _wave(shaft_angle)
    reach = 1.6 * offset
    items: list[Any] = [
        complex_curve(_circle(0.5 * offset + 0j, 0.5 * offset), "path of the centre", "thin", 3),
        complex_curve(_circle(centre, reach), "disc", "solid", 6),
        complex_curve((-reach * direction, reach * direction), "first slot", "thick", 0),
        complex_curve((offset - 1j * reach * direction, offset + 1j * reach * direction), "second slot", "thick", 1),
        Mark(0.0, 0.0, "first shaft", (-52.0, -14.0)),
        Mark(offset, 0.0, "second shaft", (8.0, -14.0)),
        Mark(centre.real, centre.imag, "C"),
    ]
    return Picture((_flat(items),), worded("Oldham coupling: shafts {e} apart", e=(offset, Size)))


def trammel_picture(result: "Any", *, bar: float, angle: float, point: float = 0.0, **_: "Any") -> Picture:
    """The bar between its slides, the ellipse of its point, and the instant centre."""
    foot, top, tracing_point = complex(result.foot), complex(0.0, result.top), complex(*result.position)
    turns = [2.0 * pi * k / STEPS for k in range(STEPS + 1)]
    far = foot + (top - foot) * max(1.0, point / bar)
    near = foot + (top - foot) * min(0.0, point / bar)
    items: list[Any] = [
        complex_curve((complex(-1.1 * bar), complex(1.1 * bar)), "", "centre", 5),
        complex_curve((complex(0.0, -1.1 * bar), complex(0.0, 1.1 * bar)), "", "centre", 5),
        complex_curve([complex((bar - point) * cos(t), point * sin(t)) for t in turns], "path of P", "thin", 3),
        complex_curve((foot, foot + top, top), "", "dots", 6),
        complex_curve((near, far), "bar", "thick", 0),
        *(complex_curve(_block(end, 0.05 * bar), "", "solid", 2) for end in (foot, top)),
        Mark(foot.real, foot.imag, "A", (8.0, -14.0)),
        Mark(top.real, top.imag, "B", (-16.0, 6.0)),
        Mark(tracing_point.real, tracing_point.imag, "P"),
        Mark(foot.real, top.imag, "instant centre"),
    ]
    if result.velocity is not None and any(result.velocity):
        speed = complex(*result.velocity)
        arrow = speed * (0.3 * bar / abs(speed))
        items.append(Arrow(tracing_point.real, tracing_point.imag, arrow.real, arrow.imag, "v", 6))
    return Picture((_flat(items),), worded("bar of {l} on two slides", l=(bar, Size)))
