"""Pictures of trains, profiles and meshes, as data."""

from math import cos, pi, sin

from dynamics_cli.gear.planets import place_angle
from dynamics_cli.gear.train_scene import Planetary, Stages
from dynamics_cli.outlines import Arc, Points
from dynamics_cli.pictures import Arrow, Axis, Bars, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, Coordinate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.gear.flanks import ToothForm
    from dynamics_cli.gear.mesh import MeshProof
    from dynamics_cli.gear.profile import GearProfile
    from dynamics_cli.gear.train import TrainMotion
    from dynamics_cli.outlines import Outline

_MODULES = Axis("modules")
_X, _Y = Axis("x", Coordinate), Axis("y", Coordinate)


def _circle(x: float, y: float, radius: float, label: str = "", style: str = "solid", role: int = 0) -> Curve:
    turns = [2.0 * pi * index / 96 for index in range(97)]
    return Curve(
        tuple(x + radius * cos(turn) for turn in turns),
        tuple(y + radius * sin(turn) for turn in turns),
        label,
        style,  # type: ignore[arg-type]
        role,
    )


def train_picture(result: "TrainMotion", *, arrangement: "Any", **_: "Any") -> Picture:
    """Sketch a train by its pitch circles, and the turns of its shafts."""
    panels = []
    if isinstance(arrangement, Planetary):
        panels.append(_planetary(result, arrangement))
    elif isinstance(arrangement, Stages):
        panels.append(_stages(arrangement))
    speeds = [(one.name, one.speed if one.turns is None else one.turns) for one in result.shafts]
    known = [(name, value) for name, value in speeds if value is not None]
    title = "turns for each turn of the driver" if result.ratio is not None else "speed, rad/s"
    bars = Bars(
        tuple(name for name, _ in known),
        tuple(min(value, 0.0) for _, value in known),
        tuple(max(value, 0.0) for _, value in known),
    )
    panels.append(Panel(Axis(title), Axis("shaft"), (bars,)))
    return Picture(tuple(panels), "Gear train" if result.ratio is None else f"Gear train, i = {result.ratio}")


def _planetary(result: "TrainMotion", arrangement: Planetary) -> Panel:
    inner, outer = arrangement.planet_teeth
    distance = 0.5 * (arrangement.sun + inner)
    items: list[Any] = [
        _circle(0.0, 0.0, 0.5 * arrangement.sun, "sun", role=0),
        _circle(0.0, 0.0, distance + 0.5 * outer, "ring", role=2),
    ]
    assert result.assembly is not None
    for index, place in enumerate(result.assembly.places):
        angle = 0.5 * pi + place_angle(place)
        x, y = distance * cos(angle), distance * sin(angle)
        items.append(_circle(x, y, 0.5 * inner, "planet" if index == 0 else "", role=1))
        if outer != inner:
            items.append(_circle(x, y, 0.5 * outer, "", "dashed", role=1))
        items.append(Curve((0.0, x), (0.0, y), "carrier" if index == 0 else "", "thin", 3))
    return Panel(_MODULES, Axis("modules"), tuple(items), "pitch circles", equal=True)


def _stages(arrangement: Stages) -> Panel:
    items: list[Any] = []
    x = 0.0
    for index, mesh in enumerate(arrangement.meshes()):
        first, second = 0.5 * mesh.first_teeth, 0.5 * mesh.second_teeth
        forward = int(mesh.first) < int(mesh.second)
        own, other = (first, second) if forward else (second, first)
        items.append(_circle(x, 0.0, own, "", role=index))
        following = x + (
            own - other if mesh.internal and not forward else other - own if mesh.internal else own + other
        )
        items.append(_circle(following, 0.0, other, "", role=index))
        items.append(Mark(x, 0.0, mesh.first if forward else mesh.second))
        x = following
    items.append(Mark(x, 0.0, str(len(arrangement.meshes()) + 1)))
    return Panel(_MODULES, Axis("modules"), tuple(items), "pitch circles, all of one module", equal=True)


def profile_picture(result: "GearProfile", **_: "Any") -> Picture:
    """Show the profile with its circles."""
    assert result.drawing is not None
    outline = result.drawing.outlines[0]
    x, y = outline_points(outline)
    items: list[Any] = [Curve(x, y, outline.name, role=0)]
    circles = (
        ("tip", result.tip_diameter),
        ("root", result.root_diameter),
        ("base", result.base_diameter),
        ("form", result.form_diameter),
    )
    if outline.closed:
        items += [
            _circle(0.0, 0.0, 0.5 * diameter, name, "dotted", role)
            for role, (name, diameter) in enumerate(circles, 1)
            if diameter is not None
        ]
    return Picture((Panel(_X, _Y, tuple(items), equal=True),), f"Profile: {outline.name}")


def outline_points(outline: "Outline") -> tuple[tuple[float, ...], tuple[float, ...]]:
    """A line through an outline, its arcs as chords."""
    found: list[tuple[float, float]] = []
    for piece in outline.pieces:
        if isinstance(piece, Points):
            found += piece.points
        elif isinstance(piece, Arc):
            found += _arc(piece)
        else:
            found += [piece.start, piece.end]
    return tuple(x for x, _ in found), tuple(y for _, y in found)


def _arc(arc: Arc) -> list[tuple[float, float]]:
    from math import atan, atan2

    (cx, cy), radius, turn = arc.centre, arc.radius, 4.0 * atan(arc.bulge)
    start = atan2(arc.start[1] - cy, arc.start[0] - cx)
    inner = [start + turn * index / 12 for index in range(1, 12)]
    return [arc.start, *((cx + radius * cos(a), cy + radius * sin(a)) for a in inner), arc.end]


def mesh_picture(result: "MeshProof", **given: "Any") -> Picture:
    """Show both profiles about the pitch point with the line of action, and the error along it."""
    from dynamics_cli.gear.mesh import forms_of, mesh

    every = {**(mesh.__kwdefaults__ or {}), **given}
    first, second = forms_of(
        **{name: every[name] for name in every if name not in ("centre_distance", "points", "shown")}
    )
    distance = result.centre_distance
    alpha = result.working_pressure_angle
    pitch_point = first.base / cos(alpha)
    items: list[Any] = [
        _teeth(first, 0.0, 0.0, "gear 1", 0),
        _second_teeth(first, second, distance, "gear 2", 1),
    ]
    along = result.path.arrays["along"]
    low, high = float(along[0]), float(along[-1])
    items.append(
        Curve(
            (pitch_point + low * sin(alpha), pitch_point + high * sin(alpha)),
            (low * cos(alpha), high * cos(alpha)),
            "contact",
            role=3,
        )
    )
    items.append(Mark(pitch_point, 0.0, "C"))
    reach = 0.6 * first.module
    items.append(Arrow(pitch_point, 0.0, reach * sin(alpha), reach * cos(alpha), "line of action", 3))
    error = Panel(
        Axis("along the line of action", Coordinate),
        Axis("transmission error", Angle),
        (Curve(tuple(map(float, along)), tuple(map(float, result.path.arrays["error"])), "", "points"),),
    )
    return Picture((Panel(_X, _Y, tuple(items), equal=True), error), "Mesh of two exact profiles")


def _teeth(form: "ToothForm", turn: float, at: float, label: str, role: int, *, mirror: bool = False) -> Curve:
    """Three teeth about the x-axis; nan breaks nothing, the chains run on along the root."""
    from dynamics_cli.gear.flanks import flank

    chain = flank(form, 1e-3 * form.module)
    radius = [*chain.radius.tolist(), *reversed(chain.radius.tolist())]
    angle = [*(-chain.angle).tolist(), *reversed(chain.angle.tolist())]
    xs, ys = [], []
    for index in (-1, 0, 1):
        for own, lean in zip(radius, angle, strict=True):
            a = turn + 2.0 * pi * index / form.teeth + lean
            xs.append(at + (-1.0 if mirror else 1.0) * own * cos(a))
            ys.append((-1.0 if mirror else 1.0) * own * sin(a))
    return Curve(tuple(xs), tuple(ys), label, role=role)


def _second_teeth(first: "ToothForm", second: "ToothForm", distance: float, label: str, role: int) -> Curve:
    """Gear 2 with a space where gear 1 has its tooth."""
    half = pi / second.teeth
    if second.internal:
        return _teeth(second, half, -distance, label, role)
    return _teeth(second, half, distance, label, role, mirror=True)
