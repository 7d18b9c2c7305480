"""What there is to look at in one gear: its teeth with their circles, where it is measured, its rack."""

from math import acos, cos, degrees, nan, pi, sin, tan

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.gear.pictures_trains import outline_points
from dynamics_cli.pictures import Axis, Bars, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Coordinate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Points = tuple[list[float], list[float]]

X, Y = Axis("x", Coordinate), Axis("y", Coordinate)
SHOWN = 3
STEPS = 96
# What a line on paper can show of a module.
FINE = 2e-3


def gear_picture(made: "Any", *, teeth: int, internal: bool = False, **given: "Any") -> Picture:
    """Three teeth in the transverse plane with their circles."""
    items: list[Any] = []
    outline = _outline(made, teeth, internal, SHOWN, given)
    if outline is not None:
        items.append(Curve(*outline, "teeth", role=6))
    reach = 1.15 * pi * SHOWN / teeth
    circles = (
        ("tip", made.tip_diameter, "thin"),
        ("reference", made.reference_diameter, "dashed"),
        ("base", made.base_diameter, "dotted"),
        ("root", made.root_diameter, "thin"),
    )
    for role, (name, diameter, style) in enumerate(circles):
        items.append(_arc(0.5 * float(diameter), min(reach, pi), name, style, role))
    return Picture((Panel(X, Y, tuple(items), equal=True),), f"{teeth} teeth, transverse section")


def measure_picture(
    made: "Any", *, teeth: int, internal: bool = False, profile_shift: float = 0.0, **given: "Any"
) -> Picture:
    """The gear with its span and the two pins or balls in their spaces, in the transverse plane."""
    items: list[Any] = []
    drawn = _profile(teeth, internal, None, {**given, "profile_shift": profile_shift})
    if drawn is None:
        limits = [float(made.pins.centre_diameter)] if made.pins is not None else []
    else:
        items.append(Curve(*outline_points(drawn.drawing.outlines[0]), role=6))
        limits = [float(drawn.base_diameter)]
    if made.span is not None and drawn is not None:
        items += _jaws(float(drawn.base_diameter), made.span, teeth)
    if made.pins is not None:
        items += _pins(made.pins, teeth)
    if not limits:
        items.append(Mark(0.0, 0.0, "no size of this gear can be drawn"))
    return Picture((Panel(X, Y, tuple(items), equal=True),), f"{teeth} teeth and how they are measured")


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
        Curve([x for x, _ in line], [y for _, y in line], f"span over {int(span.over)} teeth", "dashed", 1),
        Curve([x for x, _ in ends], [y for _, y in ends], role=1),
    ]


def _pins(pins: "Any", teeth: int) -> "list[Any]":
    """Both pins as circles, in spaces that are opposite or next to it."""
    items: list[Any] = []
    # A quarter turn from where the span is drawn.
    for nth, space in enumerate((teeth // 4, teeth // 4 + teeth // 2)):
        angle = (2 * space + 1) * pi / teeth
        radius = 0.5 * float(pins.centre_diameter)
        x, y = _round(0.5 * float(pins.pin))
        at = radius * sin(angle), radius * cos(angle)
        items.append(
            Curve([at[0] + own for own in x], [at[1] + own for own in y], "" if nth else "pins or balls", role=0)
        )
    return items


def rack_picture(made: "Any", *, teeth: int, helix_angle: float = 0.0, **given: "Any") -> Picture:
    """The gear on its rack in the transverse plane, the rack below."""
    items: list[Any] = []
    outline = _outline(made, teeth, False, SHOWN, {**given, "helix_angle": helix_angle})
    if outline is not None:
        items.append(Curve([-x for x in outline[0]], [-y for y in outline[1]], "gear", role=0))
    pitch, datum = float(made.pitch), -float(made.datum_distance)
    lean = tan(acos(min(1.0, float(made.base_diameter) / float(made.reference_diameter))))
    add, dedendum = float(made.addendum), float(made.dedendum)
    x: list[float] = []
    y: list[float] = []
    for nth in range(-2, 2):
        # The gear's middle tooth stands in the rack's space at x = 0.
        middle = (nth + 0.5) * pitch
        foot, top = 0.25 * pitch + dedendum * lean, 0.25 * pitch - add * lean
        x += [middle - foot, middle - top, middle + top, middle + foot]
        y += [datum - dedendum, datum + add, datum + add, datum - dedendum]
    wide = [-2.0 * pitch, 2.0 * pitch]
    radius = 0.5 * float(made.reference_diameter)
    reach = min(1.15 * pi * SHOWN / teeth, pi)
    circle = _arc(radius, reach, "pitch circle", "dotted", 2)
    items += [
        Curve(x, y, "rack", role=1),
        Curve(wide, [datum, datum], "datum line", "dashed", 3),
        Curve(circle.x, [-own for own in circle.y], "pitch circle", "dotted", 2),
        Curve(wide, [-radius, -radius], "pitch line", "thin", 2),
    ]
    return Picture((Panel(X, Y, tuple(items), equal=True),), "gear and rack, transverse section")


def _outline(made: "Any", teeth: int, internal: bool, shown: int, given: "dict[str, Any]") -> "Points | None":
    """The exact outline of some teeth about +y; None when they are none (pointed, say)."""
    shift = given.get("profile_shift", 0.0)
    own = getattr(made, "profile_shift", None)
    drawn = _profile(teeth, internal, shown, {**given, "profile_shift": shift if own is None else float(own)}, made)
    if drawn is None:
        return None
    # Tooth after tooth anticlockwise from +y: turned back by half of them, they stand about it.
    turn = -pi * (min(shown, teeth) - 1) / teeth
    x, y = outline_points(drawn.drawing.outlines[0])
    return (
        [cos(turn) * a - sin(turn) * b for a, b in zip(x, y, strict=True)],
        [sin(turn) * a + cos(turn) * b for a, b in zip(x, y, strict=True)],
    )


def _profile(teeth: int, internal: bool, shown: "int | None", given: "dict[str, Any]", made: "Any" = None) -> "Any":
    from dynamics_cli.gear.gear import module_of
    from dynamics_cli.gear.profile import profile
    from dynamics_cli.gear.single import normal_pressure_angle

    helix = given.get("helix_angle", 0.0)
    names = ("profile", "addendum_factor", "dedendum_factor", "root_radius_factor")
    taken = {name: given[name] for name in names if given.get(name) is not None}
    transverse = given.get("transverse_pressure_angle")
    if transverse is not None or given.get("pressure_angle") is not None:
        taken["pressure_angle"] = normal_pressure_angle(given.get("pressure_angle"), transverse, helix)
    if made is not None:
        taken["tip_diameter"] = float(made.tip_diameter)
    elif given.get("tip_diameter") is not None:
        taken["tip_diameter"] = given["tip_diameter"]
    if made is None and "shift_sign" in given:
        taken["shift_sign"] = given["shift_sign"]
    try:
        return profile(
            teeth=teeth,
            pitch=given["pitch"],
            helix_angle=helix,
            profile_shift=given["profile_shift"],
            internal=internal,
            only_teeth=None if shown is None else min(shown, teeth),
            tolerance=FINE * module_of(given["pitch"], helix),
            **taken,
        )
    except InadmissibleError:
        return None


def _arc(radius: float, reach: float, label: str, style: "Any", role: int) -> Curve:
    """An arc about the centre, symmetrical about +y."""
    turns = [reach * (2.0 * k / STEPS - 1.0) for k in range(STEPS + 1)]
    return Curve([radius * sin(t) for t in turns], [radius * cos(t) for t in turns], label, style, role)


def _round(radius: float) -> "Points":
    turns = [2.0 * pi * k / STEPS for k in range(STEPS + 1)]
    return [radius * cos(t) for t in turns], [radius * sin(t) for t in turns]


def candidates(made: "Any", **_: "Any") -> Picture:
    """How well each candidate agrees with what was read."""
    names = tuple(f"{one.size}, {degrees(float(one.pressure_angle)):.4g}°" for one in made.candidates)
    worst = [float(one.disagreement) for one in made.candidates]
    bars = Bars(names, [0.0] * len(worst), worst)
    return Picture((Panel(Axis("disagreement, in readings' accuracy"), Axis(""), (bars,)),), "which gear it may be")


def trains(made: "Any", **_: "Any") -> Picture:
    """The best trains by how far they miss the ratio, and by how many teeth they take."""
    names = tuple(one.stages for one in made.best)
    misses = [1e6 * abs(float(one.error_value)) for one in made.best]
    teeth = [float(one.teeth) for one in made.best]
    zeros = [0.0] * len(names)
    panels = (
        Panel(Axis("error of the ratio, parts per million"), Axis(""), (Bars(names, zeros, misses),)),
        Panel(Axis("teeth of all wheels together"), Axis(""), (Bars(names, zeros, teeth),)),
    )
    return Picture(panels, "trains for the ratio")
