"""Pictures of scotch yokes, Oldham couplings and trammels."""

from math import cos, pi, sin, tan

from dynamics_cli.errors import worded
from dynamics_cli.linkage.drawing import BELOW, LEFT, ROUND, ZERO, block, circle, here, over_turn, pin, plan, turned
from dynamics_cli.pictures import Arrow, Axis, Picture, complex_curve
from dynamics_cli.quantities import CamVelocity, Coordinate, Distance, Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

TURNS = [2.0 * pi * k / ROUND for k in range(ROUND + 1)]


def yoke_picture(
    result: "Any", *, crank: float, crank_angle: float = 0.0, slot_angle: float = 0.0, **_: "Any"
) -> Picture:
    """Crank and yoke to scale; position, velocity and acceleration over a turn."""
    reach, lean = crank / cos(slot_angle), tan(slot_angle)
    place = crank * turned(crank_angle)
    slot = complex(result.position)
    half = 1.2 * crank * complex(lean, 1.0)
    edge = 0.12 * crank / cos(slot_angle)
    outline = [slot + side for side in (-half - edge, half - edge, half + edge, edge - half, -half - edge)]
    items: list[Any] = [
        complex_curve(circle(0j, crank), "", "thin", 6),
        complex_curve((complex(-2.6 * reach), complex(2.6 * reach)), "", "centre", 5),
        complex_curve(outline, "yoke", "solid", 1),
        complex_curve((slot + edge, slot + edge + 1.3 * reach), "", "solid", 1),
        complex_curve((0j, place), "crank", "thick", 0),
        pin(0j, "O", LEFT),
        pin(place, "A"),
    ]
    x = [reach * cos(angle + slot_angle) for angle in TURNS]
    slope = [-reach * sin(angle + slot_angle) for angle in TURNS]
    bands = ZERO, *here(crank_angle)
    return Picture(
        (
            plan(items),
            over_turn(Axis("position x", Coordinate), TURNS, x, 1, *bands),
            over_turn(Axis("velocity v/ω", CamVelocity), TURNS, slope, 1, *bands),
            over_turn(Axis("acceleration a/ω²", Coordinate), TURNS, [-part for part in x], 1, *bands),
        ),
        worded("scotch yoke: crank {a}, stroke {s}", a=(crank, Size), s=(result.stroke, Size)),
    )


def oldham_picture(result: "Any", *, offset: float, shaft_angle: float = 0.0, **_: "Any") -> Picture:
    """The shafts' axes, both slots, and the circle on which the disc's centre goes round."""
    centre = complex(*result.centre)
    direction = turned(shaft_angle)
    reach = 1.6 * offset
    # the quarters in which no slot lies
    clear = 6.0 if direction.real * direction.imag >= 0.0 else -14.0
    items: list[Any] = [
        complex_curve(circle(0.5 * offset + 0j, 0.5 * offset), "path of the centre", "thin", 3),
        complex_curve(circle(centre, reach), "disc", "solid", 6),
        complex_curve((-reach * direction, reach * direction), "first slot", "thick", 0),
        complex_curve((offset - 1j * reach * direction, offset + 1j * reach * direction), "second slot", "thick", 1),
        pin(0j, "first shaft", (-8.0, clear)),
        pin(complex(offset), "second shaft", (8.0, clear)),
        pin(centre, "C"),
    ]
    return Picture((plan(items),), worded("Oldham coupling: shafts {e} apart", e=(offset, Size)))


def trammel_picture(result: "Any", *, bar: float, angle: float, point: float = 0.0, **_: "Any") -> Picture:
    """The bar between its slides, the ellipse of its point, and the instant centre."""
    foot, top, tracing_point = complex(result.foot), complex(0.0, result.top), complex(*result.position)
    far = foot + (top - foot) * max(1.0, point / bar)
    near = foot + (top - foot) * min(0.0, point / bar)
    items: list[Any] = [
        complex_curve((complex(-1.1 * bar), complex(1.1 * bar)), "", "centre", 5),
        complex_curve((complex(0.0, -1.1 * bar), complex(0.0, 1.1 * bar)), "", "centre", 5),
        complex_curve([complex((bar - point) * cos(t), point * sin(t)) for t in TURNS], "path of P", "thin", 3),
        complex_curve((foot, foot + top, top), "", "dots", 6),
        complex_curve((near, far), "bar", "thick", 0),
        *(complex_curve(block(end, 0.05 * bar), "", "solid", 2) for end in (foot, top)),
        pin(foot, "A", BELOW),
        pin(top, "B", (-16.0, 6.0)),
        pin(tracing_point, "P"),
        pin(foot + top, "instant centre"),
    ]
    if result.velocity is not None and any(result.velocity):
        speed = complex(*result.velocity)
        arrow = speed * (0.3 * bar / abs(speed))
        items.append(Arrow(tracing_point.real, tracing_point.imag, arrow.real, arrow.imag, "v", 6))
    return Picture((plan(items),), worded("bar of {l} on two slides", l=(bar, Distance)))
