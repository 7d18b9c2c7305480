"""Pictures of measuring: a gear with its span and pins, and the candidates for readings."""

from math import cos, degrees, nan, pi, sin

from dynamics_cli.errors import worded
from dynamics_cli.gear.section import BLACK, body, circle, sizes
from dynamics_cli.gear.single.pictures import form_in
from dynamics_cli.pictures import Axis, Bars, Curve, Label, Mark, Panel, Picture
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
    form = form_in(teeth, internal, {**inputs, "profile_shift": profile_shift})
    if form is not None:
        items += [*body(form, (0.0, 0.0), 0.5 * pi, 0), circle((0.0, 0.0), form.base, "", "dots", BLACK)]
        if result.span is not None:
            items += _jaws(2.0 * form.base, result.span, teeth)
    if result.pins is not None:
        items += _pins(result.pins, teeth)
    if not items:
        items.append(Mark(0.0, 0.0, "none of this gear's sizes can be drawn"))
    title = worded("Measuring a gear of {teeth} teeth, x = {shift}", teeth=teeth, shift=(float(profile_shift), Ratio))
    if getattr(inputs.get("pitch"), "module", None) is not None:
        title = worded("{title}, module {module:6}", title=title, module=(float(inputs["pitch"].module), Module))
    scene = Panel(X, Y, tuple(items), equal=True, bare=True)
    return Picture(
        (scene, _table(result)), title, subtitle="Transverse section; base circle dotted, jaws tangent to it"
    )


def _table(result: "Any") -> Panel:
    """The sizes that an inspector reads, with their symbols."""
    listed: list[tuple[str, str, Any, Any]] = [("normal tooth thickness", "s_n", result.normal_thickness, Size)]
    if result.span is not None:
        over = int(result.span.over)
        listed.append((f"span over {over} teeth", f"W_{over}", result.span.span, Size))
        listed.append(("touched at diameter", "", result.span.contact_diameter, Size))
    if result.pins is not None:
        listed += [("pin or ball", "D_M", result.pins.pin, Size), ("size over pins", "M", result.pins.size, Size)]
    if result.chordal is not None:
        listed.append(("chordal thickness", "", result.chordal.thickness, Size))
        listed.append(("chordal height", "", result.chordal.height, Size))
    return sizes(*listed)


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
    by_tip = result.candidates[0].pressure_angle is None
    names = tuple(
        row.size if by_tip else f"{row.size}, {degrees(float(row.pressure_angle)):.4g}°" for row in result.candidates
    )
    worst = [float(row.disagreement) for row in result.candidates]
    bars = Bars(names, [0.0] * len(worst), worst)
    title = f"Which gear of {teeth} teeth it may be" if teeth else "Candidate gears"
    axis = Axis("largest deviation from a reading; below 1 the gear fits")
    subtitle = (
        "Size of the teeth, by the tip diameter" if by_tip else "Size of the teeth and pressure angle, best first"
    )
    return Picture((Panel(axis, Axis(""), (bars,)),), title, subtitle=subtitle)
