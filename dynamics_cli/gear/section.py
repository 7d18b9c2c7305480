"""Gears in their transverse section as picture items: true teeth with fillets, circles and centre lines."""

from math import atan, atan2, cos, hypot, pi, sin

from dynamics_cli.errors import InadmissibleError, worded
from dynamics_cli.gear.single.outline import gear_outline
from dynamics_cli.gear.single.profile import tooth_form
from dynamics_cli.gear.single.trochoid import roll_less_arc
from dynamics_cli.numerics.number import over_plain
from dynamics_cli.outlines import Arc, Points
from dynamics_cli.pictures import Axis, Curve, Mark, Panel, Rows
from dynamics_cli.quantities import Coordinate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.gear.single.flanks import ToothForm
    from dynamics_cli.gear.single.gear import Gear
    from dynamics_cli.outlines import Outline
    from dynamics_cli.pictures import Style

    Place = tuple[float, float]
    Line = tuple[tuple[float, ...], tuple[float, ...]]

GREEN, BLACK = 2, 6
STEPS = 180
# Resolution of a printed line, relative to the module and to a gear's diameter.
FINE, FINE_OF_GEAR = 2e-3, 5e-5
# Gears with more teeth are drawn as their tip circle: the teeth would merge.
MOST_DRAWN = 400
# How far a ring is drawn beyond its root circle, in modules.
RIM = 2.0


def form_of(gear: "Gear", tip_diameter: float | None = None, root_radius: float | None = None) -> "ToothForm | None":
    """The true form of a gear; None where it cannot be drawn, for example for pointed teeth."""
    try:
        return over_plain(tooth_form(gear, tip_diameter, root_radius))  # type: ignore[no-any-return]
    except InadmissibleError:
        return None


def sizes(*listed: "tuple[str, str, Any, Any]", wide: bool = False) -> Panel:
    """A table of names, symbols and values; values of None are left out, and text (of no kind) is unchanged."""
    rows = [
        (name, symbol, value if kind is None else worded("{value:6}", value=(float(value), kind)))
        for name, symbol, value, kind in listed
        if value is not None
    ]
    return Panel(Axis(""), Axis(""), (Rows(tuple(rows)),), wide=wide)


def gear_items(form: "ToothForm", at: "Place", tooth: float, role: int, pitch_radius: float) -> "list[Curve]":
    """A whole gear about `at`, the middle of a tooth in the direction `tooth`, with its pitch and base circles."""
    return [
        *body(form, at, tooth, role),
        circle(at, pitch_radius, "", "centre", role),
        circle(at, form.base, "", "dots", role),
    ]


def meshing(forms: "list[ToothForm]", distance: float, radii: "Place") -> "list[Curve]":
    """Two gears of true shape, flank on flank at the pitch point; the first about the origin, the second on the x-axis.

    The first gear's tooth below the line of centres touches the second gear's tooth above it.
    """
    first, second = forms
    halves = [form.half_base - roll_less_arc(form.roll(radius)) for form, radius in zip(forms, radii, strict=True)]
    beyond = pi / second.teeth if second.internal else pi
    second_centre = (-distance if second.internal else distance, 0.0)
    return [
        *gear_items(first, (0.0, 0.0), -halves[0], 0, radii[0]),
        *gear_items(second, second_centre, beyond - halves[1], 1, radii[1]),
    ]


def body(form: "ToothForm", at: "Place", tooth: float, role: int) -> "list[Curve]":
    """The gear's outline with its material filled: inside it, or for a ring between it and a rim."""
    x, y = tooth_line(form, at, tooth)
    if not form.internal:
        return [Curve(x, y, "", "filled", role)]
    rim = circle(at, form.root + RIM * form.module, "", "solid", role)
    return [
        Curve((*rim.x, *reversed(x), rim.x[0]), (*rim.y, *reversed(y), rim.y[0]), "", "fill", role),
        Curve(x, y, "", "outline", role),
    ]


def tooth_line(form: "ToothForm", at: "Place", tooth: float) -> "Line":
    """The closed line of all teeth; the tip circle where they would merge."""
    if form.teeth > MOST_DRAWN:
        around = circle(at, form.tip, "", "solid", 0)
        return tuple(around.x), tuple(around.y)
    outline, _ = gear_outline(form, max(FINE * form.module, FINE_OF_GEAR * form.tip))
    x, y = turned(outline_points(outline), tooth - 0.5 * pi, at)
    return (*x, x[0]), (*y, y[0])


def turned(line: "Line", angle: float, at: "Place" = (0.0, 0.0)) -> "Line":
    """A line turned about the origin, then moved to `at`."""
    c, s = cos(angle), sin(angle)
    x, y = line
    return (
        tuple(at[0] + c * a - s * b for a, b in zip(x, y, strict=True)),
        tuple(at[1] + s * a + c * b for a, b in zip(x, y, strict=True)),
    )


def circle(at: "Place", radius: float, label: str, style: "Style", role: int) -> Curve:
    """A whole circle."""
    return arc(at, radius, (0.0, 2.0 * pi), label, style, role)


def arc(at: "Place", radius: float, ends: "Place", label: str, style: "Style", role: int) -> Curve:
    """An arc between two directions."""
    angles = [ends[0] + (ends[1] - ends[0]) * k / STEPS for k in range(STEPS + 1)]
    x, y = [at[0] + radius * cos(a) for a in angles], [at[1] + radius * sin(a) for a in angles]
    return Curve(tuple(x), tuple(y), label, style, role)


def centre_lines(at: "Place", reach: float) -> "list[Curve]":
    """The two centre lines of a gear, `reach` to each side."""
    (x, y), black = at, 6
    return [
        Curve((x - reach, x + reach), (y, y), "", "centre", black),
        Curve((x, x), (y - reach, y + reach), "", "centre", black),
    ]


def contact_points(along: "list[tuple[str, float]]", radius: float, angle: float) -> "list[tuple[str, float, float]]":
    """Points of the line of action in the plane of `meshing`, by their distance from the pitch point."""
    return [(name, radius + s * sin(angle), s * cos(angle)) for name, s in along]


def contact_panel(
    gears: "list[Curve]",
    points: "list[tuple[str, float, float]]",
    module: float,
    *,
    wide: bool = False,
    titled: bool = True,
) -> Panel:
    """The teeth about the pitch point with the path of contact from the first of the points to the last."""
    (_, x0, y0), (_, x1, y1) = points[0], points[-1]
    length = hypot(x1 - x0, y1 - y0)
    beyond = 0.6 * module * (x1 - x0) / length, 0.6 * module * (y1 - y0) / length
    reach = 0.5 * length + 1.6 * module
    across = (1.7 if wide else 1.05) * reach
    middle = 0.5 * (x0 + x1), 0.5 * (y0 + y1)
    items: tuple[Any, ...] = (
        *gears,
        Curve((x0 - beyond[0], x1 + beyond[0]), (y0 - beyond[1], y1 + beyond[1]), "", "thin", BLACK),
        Curve((x0, x1), (y0, y1), "", "thick", GREEN),
        *(Mark(x, y, name, (7.0, -4.0)) for name, x, y in points),
    )
    return Panel(
        Axis("x", Coordinate, ends=(middle[0] - across, middle[0] + across)),
        Axis("y", Coordinate, ends=(middle[1] - reach, middle[1] + reach)),
        items,
        "" if wide or not titled else f"Path of contact, {points[0][0]} to {points[-1][0]}",
        equal=True,
        bare=True,
        wide=wide,
    )


def outline_points(outline: "Outline") -> "Line":
    """A line through an outline, its arcs as chords."""
    points: list[Place] = []
    for piece in outline.pieces:
        if isinstance(piece, Points):
            points += piece.points
        elif isinstance(piece, Arc):
            points += _arc_points(piece)
        else:
            points += [piece.start, piece.end]
    return tuple(x for x, _ in points), tuple(y for _, y in points)


def _arc_points(piece: Arc) -> "list[Any]":
    if not piece.bulge:
        return [piece.start, piece.end]
    (cx, cy), radius, turn = piece.centre, piece.radius, 4.0 * atan(piece.bulge)
    start = atan2(piece.start[1] - cy, piece.start[0] - cx)
    count = 2 + 2 * min(5, int(20.0 * abs(turn)))
    inner = [start + turn * index / count for index in range(1, count)]
    return [piece.start, *((cx + radius * cos(a), cy + radius * sin(a)) for a in inner), piece.end]
