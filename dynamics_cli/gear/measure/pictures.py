"""Pictures of measuring: a gear with its span and pins, and the candidates for readings."""

from math import cos, degrees, nan, pi, sin

from dynamics_cli.errors import worded
from dynamics_cli.gear.section import BLACK, RIM, circle, outline_points
from dynamics_cli.gear.single.pictures import exact_profile
from dynamics_cli.pictures import Axis, Bars, Curve, Label, Mark, Panel, Picture, Rows
from dynamics_cli.quantities import Coordinate, Module, Ratio, Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

X, Y = Axis("x", Coordinate), Axis("y", Coordinate)
PEN = 1


def measure_picture(
    result: "Any", *, teeth: int, internal: bool = False, profile_shift: float = 0.0, **inputs: "Any"
) -> Picture:
    """The gear with its span and the two pins or balls in their spaces, in the transverse plane, and the sizes."""
    items: list[Any] = []
    profile = exact_profile(teeth, internal, None, {**inputs, "profile_shift": profile_shift})
    if profile is None:
        limits = [float(result.pins.centre_diameter)] if result.pins is not None else []
    else:
        items += _gear(profile, internal)
        limits = [float(profile.base_diameter)]
    if result.span is not None and profile is not None:
        items += _jaws(float(profile.base_diameter), result.span, teeth)
    if result.pins is not None:
        items += _pins(result.pins, teeth)
    if not limits:
        items.append(Mark(0.0, 0.0, "none of this gear's sizes can be drawn"))
    title = worded("Measuring a gear of {teeth} teeth, x = {shift}", teeth=teeth, shift=(float(profile_shift), Ratio))
    if getattr(inputs.get("pitch"), "module", None) is not None:
        title = worded("{title}, module {module:6}", title=title, module=(float(inputs["pitch"].module), Module))
    scene = Panel(X, Y, tuple(items), equal=True, bare=True)
    table = Panel(X, Y, (Rows(_rows(result)),))
    return Picture((scene, table), title, subtitle="Transverse section; base circle dotted, jaws tangent to it")


def _gear(profile: "Any", internal: bool) -> "list[Any]":
    """The gear filled, with its base circle."""
    x, y = outline_points(profile.drawing.outlines[0])
    x, y = (*x, x[0]), (*y, y[0])
    base = circle((0.0, 0.0), 0.5 * float(profile.base_diameter), "", "dots", BLACK)
    if not internal:
        return [Curve(x, y, "", "filled", 0), base]
    depth = 0.5 * (float(profile.root_diameter) - float(profile.tip_diameter))
    rim = circle((0.0, 0.0), 0.5 * float(profile.root_diameter) + 0.5 * RIM * depth, "", "solid", 0)
    around = (*rim.x, *reversed(x), rim.x[0]), (*rim.y, *reversed(y), rim.y[0])
    return [Curve(*around, "", "fill", 0), Curve(x, y, "", "outline", 0), base]


def _rows(result: "Any") -> "tuple[tuple[str, str, str], ...]":
    """The sizes that an inspector reads, with their symbols."""
    listed: list[tuple[str, str, Any, Any]] = [("normal tooth thickness", "s_n", result.normal_thickness, Size)]
    if result.span is not None:
        listed.append(
            (f"span over {int(result.span.over)} teeth", f"W_{int(result.span.over)}", result.span.span, Size)
        )
        listed.append(("touched at diameter", "", result.span.contact_diameter, Size))
    if result.pins is not None:
        listed += [("pin or ball", "D_M", result.pins.pin, Size), ("size over pins", "M", result.pins.size, Size)]
    if result.chordal is not None:
        listed.append(("chordal thickness", "", result.chordal.thickness, Size))
        listed.append(("chordal height", "", result.chordal.height, Size))
    return tuple(
        (name, symbol, worded("{value:6}", value=(float(value), kind)))
        for name, symbol, value, kind in listed
        if value is not None
    )


def _jaws(base: float, span: "Any", teeth: int) -> "list[Any]":
    """The measured line, tangent to the base circle, with the jaws of the instrument at its ends."""
    half = 0.5 * (float(span.contact_diameter) ** 2 - base * base) ** 0.5
    # Over an odd number of teeth the middle is a tooth, over an even one a space.
    turn = 0.0 if int(span.over) % 2 else pi / teeth
    along, out = (cos(turn), -sin(turn)), (sin(turn), cos(turn))

    def at(u: float, v: float) -> "tuple[float, float]":
        return u * along[0] + v * out[0], u * along[1] + v * out[1]

    low, high = 0.5 * base - 0.15 * half, 0.5 * base + 0.6 * half
    line = [at(-half, 0.5 * base), at(half, 0.5 * base)]
    ends = [at(-half, low), at(-half, high), (nan, nan), at(half, low), at(half, high)]
    return [
        Curve([x for x, _ in line], [y for _, y in line], "", "dashed", PEN),
        Curve([x for x, _ in ends], [y for _, y in ends], "", "thick", PEN),
        Label(
            *at(0.0, 0.5 * base + 0.75 * half),
            worded("W_{over} = {span:6}", over=int(span.over), span=(float(span.span), Size)),
            PEN,
        ),
    ]


def _pins(pins: "Any", teeth: int) -> "list[Any]":
    """Both pins as circles, in spaces that are opposite or next to it, and the size over them."""
    items: list[Any] = []
    radius = 0.5 * float(pins.centre_diameter)
    # A quarter turn from where the span is drawn.
    for space in (teeth // 4, teeth // 4 + teeth // 2):
        angle = (2 * space + 1) * pi / teeth
        centre = radius * sin(angle), radius * cos(angle)
        items.append(circle(centre, 0.5 * float(pins.pin), "", "filled", 2))
        items.append(Mark(*centre))
    items.append(Label(0.0, -0.12 * radius, worded("M = {size:6}", size=(float(pins.size), Size)), 2))
    items.append(Label(0.0, -0.26 * radius, worded("over pins of {size:6}", size=(float(pins.pin), Size)), 2))
    return items


def candidates(result: "Any", *, teeth: int = 0, **_: "Any") -> Picture:
    """How well each candidate agrees with the readings."""
    names = tuple(f"{row.size}, {degrees(float(row.pressure_angle)):.4g}°" for row in result.candidates)
    worst = [float(row.disagreement) for row in result.candidates]
    bars = Bars(names, [0.0] * len(worst), worst)
    title = f"Which gear of {teeth} teeth it may be" if teeth else "Candidate gears"
    axis = Axis("largest deviation from a reading; below 1 the gear fits")
    return Picture(
        (Panel(axis, Axis(""), (bars,)),), title, subtitle="Size of the teeth and pressure angle, best first"
    )
