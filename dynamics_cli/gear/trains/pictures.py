"""Pictures of gear trains: the gears in mesh with the teeth of a standard rack, and the turns of the shafts."""

from math import cos, pi, sin

from dynamics_cli.gear.section import BLACK, RIM, circle, form_of, gear_items
from dynamics_cli.gear.single.gear import Gear
from dynamics_cli.gear.single.rack import BasicRack
from dynamics_cli.gear.trains.planets import place_angle
from dynamics_cli.gear.trains.scene import Planetary, Stages
from dynamics_cli.pictures import Axis, Bars, Curve, Label, Panel, Picture

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.gear.trains.train import TrainMotion

    Place = tuple[float, float]

MODULES = Axis("modules")
SUN, PLANET, RING = 0, 1, 2
UPWARDS = 0.5 * pi


def train_picture(result: "TrainMotion", *, arrangement: "Any", **_: "Any") -> Picture:
    """The gears of a train in mesh, and the turns of its shafts."""
    panels, name = [], "Gear train"
    if isinstance(arrangement, Planetary):
        panels.append(_planetary(result, arrangement))
        name = f"Planetary gear train {arrangement.sun} / {arrangement.planet_teeth[0]} / {arrangement.ring}"
    elif isinstance(arrangement, Stages):
        panels.append(_stages(arrangement))
        name = f"Gear train {arrangement.stages}"
    speeds = [(row.name, row.speed if row.turns is None else row.turns) for row in result.shafts]
    turning = [(shaft, value) for shaft, value in speeds if value is not None]
    title = "turns for each turn of the driver" if result.ratio is not None else "speed, rad/s"
    bars = Bars(
        tuple(shaft for shaft, _ in turning),
        tuple(min(value, 0.0) for _, value in turning),
        tuple(max(value, 0.0) for _, value in turning),
    )
    panels.append(Panel(Axis(title), Axis("shaft"), (bars,)))
    subtitle = "Pitch circles dash-dotted, base circles dotted; all of one module, teeth without profile shift"
    title = name if result.ratio is None else f"{name}, i = {result.ratio}"
    return Picture(tuple(panels), title, subtitle=subtitle if len(panels) > 1 else "")


def _gear(teeth: int, at: "Place", tooth: float, role: int, *, internal: bool = False) -> "list[Curve]":
    """A gear of module 1 cut by the standard rack; its pitch circle where no such gear exists."""
    form = form_of(Gear(-teeth if internal else teeth, 1.0, BasicRack()))
    return gear_items(form, at, tooth, role, 0.5 * teeth) if form else [circle(at, 0.5 * teeth, "", "centre", role)]


def _mate(teeth: int, tooth: float, other: int, towards: float, *, internal: bool = False) -> float:
    """Direction of a tooth of the mate, which has a space where the gear has a tooth.

    `towards` is the direction of the pitch point from the gear; a ring sees it in the same direction, an external mate
    in the opposite one. The turn of the gear in teeth, (θ − φ)z/2π, gives that of the mate.
    """
    turns = (towards - tooth) * teeth / (2.0 * pi)
    if internal:
        return towards - (turns + 0.5) * 2.0 * pi / other
    return towards + pi - (0.5 - turns) * 2.0 * pi / other


def _planetary(result: "TrainMotion", arrangement: Planetary) -> Panel:
    inner, outer = arrangement.planet_teeth
    distance = 0.5 * (arrangement.sun + inner)
    items: list[Any] = [*_gear(arrangement.sun, (0.0, 0.0), UPWARDS, SUN)]
    assert result.assembly is not None
    for index, place in enumerate(result.assembly.places):
        angle = UPWARDS + place_angle(place)
        centre = distance * cos(angle), distance * sin(angle)
        tooth = _mate(arrangement.sun, UPWARDS, inner, angle)
        items += _gear(inner, centre, tooth, PLANET)
        if outer != inner:
            items.append(circle(centre, 0.5 * outer, "", "dashed", PLANET))
        elif not index:
            ring = _mate(inner, tooth, arrangement.ring, angle, internal=True)
            items += _gear(arrangement.ring, (0.0, 0.0), ring, RING, internal=True)
        items.append(Curve((0.0, centre[0]), (0.0, centre[1]), "", "thin", BLACK))
    if outer != inner:
        items.append(circle((0.0, 0.0), distance + 0.5 * outer, "", "centre", RING))
    radius = 0.5 * arrangement.ring + 1.25 + RIM
    items += [
        Label(0.22 * arrangement.sun, -0.12 * arrangement.sun, f"sun\n{arrangement.sun}", SUN),
        Label(0.25 * inner, distance + 0.1 * inner, f"planet\n{inner}", PLANET),
        Label(0.0, 1.06 * radius, f"ring {arrangement.ring}", RING),
    ]
    return Panel(MODULES, MODULES, tuple(items), equal=True, bare=True)


def _stages(arrangement: Stages) -> Panel:
    items: list[Any] = []
    x = 0.0
    meshes = arrangement.meshes()
    for role, mesh in enumerate(meshes):
        forward = int(mesh.first) < int(mesh.second)
        teeth, other = (mesh.first_teeth, mesh.second_teeth) if forward else (mesh.second_teeth, mesh.first_teeth)
        apart = 0.5 * (abs(other - teeth) if mesh.internal else teeth + other)
        # a ring has its pinion, and the pinion its pitch point, on the side away from the ring's centre
        towards = pi if mesh.internal and forward else 0.0
        items += _gear(teeth, (x, 0.0), UPWARDS, role, internal=mesh.internal and not forward)
        mate = _mate(teeth, UPWARDS, other, towards, internal=mesh.internal)
        items += _gear(other, (x + apart, 0.0), mate, role, internal=mesh.internal and forward)
        items.append(Label(x, 0.0, f"{mesh.first if forward else mesh.second}\n{teeth} teeth", role))
        x += apart
        if role + 1 == len(meshes):
            items.append(Label(x, 0.0, f"{len(meshes) + 1}\n{other} teeth", role))
    return Panel(MODULES, MODULES, tuple(items), equal=True, bare=True)


def ratio_picture(result: "Any", *, target: "Any" = None, **_: "Any") -> Picture:
    """The best train's gears in mesh, and the errors of the best trains."""
    best = result.best
    names = tuple(train.stages for train in best)
    misses = [1e6 * float(train.error_value) for train in best]
    bars = Bars(names, [min(miss, 0.0) for miss in misses], [max(miss, 0.0) for miss in misses])
    panels = [Panel(Axis("error of the ratio, parts per million"), Axis("train"), (bars,))]
    teeth = [int(train.teeth) for train in best]
    if len(set(teeth)) > 1:
        bars = Bars(names, [0.0] * len(teeth), teeth)
        panels.append(Panel(Axis("teeth of all wheels together"), Axis("train"), (bars,)))
    panels.insert(0, _stages(Stages(best[0].stages)))
    title = "Gear trains for a ratio" + (f" of {target[0] / target[1]:.9g}" if target is not None else "")
    subtitle = f"Best of {result.considered} trains: {best[0].stages}; standard teeth of one module"
    return Picture(tuple(panels), title, subtitle=subtitle)
