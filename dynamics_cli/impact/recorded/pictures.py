"""Pictures of a recorded crash: the scene with velocities, and the limits of its speeds."""

from itertools import pairwise

from dynamics_cli.impact.scene_pictures import axes_of, collision, names_of, north_of, seen
from dynamics_cli.pictures import Arrow, Axis, Band, Bars, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Acceleration, RoadSpeed, RoadVelocity, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def record(result: "Any", *, first: "Any", second: "Any", **_: "Any") -> Picture:
    """The vehicles with their velocities, or both ΔV where these are unknown; and the limits of the speeds."""
    axes, names = axes_of(result), names_of(first, second)
    title = "crash from a recorded ΔV"
    limits = _limits(result, names)
    if result.second.approach_speed is None:
        return Picture((_changes(result, names), limits), title, columns=2)
    heading = first.nose if first.approach_heading is None else first.approach_heading
    before = [
        seen(first.approach_speed, heading, axes),
        seen(result.second.approach_speed, result.second.approach_heading, axes),
    ]
    after = [seen(vehicle.exit_speed, vehicle.exit_heading, axes) for vehicle in (result.first, result.second)]
    facing = result.second.approach_heading if second.nose is None else second.nose
    noses = [seen(1.0, first.nose, axes), seen(1.0, facing, axes)]
    scene = collision(names, noses, before, after, north_of(axes))
    return Picture((scene, limits), title, columns=2, scene=True)


def pulse(result: "Any", *, tolerance: float = 0.1, **_: "Any") -> Picture:
    """ΔV along and across the nose over time with the band of the tolerance, and the acceleration."""
    times = [row.time for row in result.rows]
    panels: list[Any] = []
    for name, values in (
        ("along the nose", [row.longitudinal for row in result.rows]),
        ("across it", [row.lateral for row in result.rows]),
    ):
        if not any(values):
            continue
        role = len(panels)
        edges = [[(1.0 + sign * tolerance) * value for value in values] for sign in (1.0, -1.0)]
        panels.append(Curve([*times, *reversed(times)], [*edges[0], *reversed(edges[1])], "", "fill", role))
        panels.append(Curve(times, values, name, "solid", role))
    marker = Band(result.time, result.time, "greatest ΔV")
    halves = [0.5 * (a + b) for a, b in pairwise(times)]
    accelerations = [row.acceleration for row in result.rows[1:]]
    axis = Axis("time", Time, ends=(0.0, times[-1]))
    return Picture(
        (
            Panel(axis, Axis("ΔV", RoadVelocity), (*panels, marker), "as recorded, with the band of its tolerance"),
            Panel(axis, Axis("acceleration", Acceleration), (Curve(halves, accelerations, "", "solid", 3),)),
        ),
        "recorded crash pulse",
    )


def _changes(result: "Any", names: "tuple[str, str]") -> Panel:
    """Both changes of velocity from one point on one scale."""
    items: list[Any] = []
    changes = [vehicle.delta_v.vector for vehicle in (result.first, result.second)]
    size = max(abs(part) for change in changes for part in change)
    for role, (name, (x, y)) in enumerate(zip(names, changes, strict=True)):
        items += [Arrow(0.0, 0.0, x, y, "", role), Mark(0.5 * x, 0.5 * y, f"{name} ΔV", (0.1, 6.0), False, role)]
    # margin beside the arrows, which may be collinear
    reach = [max(1.15 * max(abs(change[axis]) for change in changes), 0.6 * size) for axis in (0, 1)]
    x_axis = Axis("along x", RoadSpeed, ends=(-reach[0], reach[0]))
    y_axis = Axis("along y", RoadSpeed, ends=(-reach[1], reach[1]))
    return Panel(x_axis, y_axis, tuple(items), "changes of velocity", equal=True)


def _limits(result: "Any", names: "tuple[str, str]") -> Panel:
    """The speeds with the limits of the record's tolerance and of restitution."""
    first, second = result.first, result.second
    entries = [
        (f"{names[0]} ΔV", first.delta_v_low, first.delta_v.magnitude, first.delta_v_high),
        ("closing speed", result.closing_speed_low, result.closing_speed, result.closing_speed_high),
        (f"{names[1]} before", second.approach_speed_low, second.approach_speed, second.approach_speed_high),
    ]
    rows = [entry for entry in entries if entry[1] is not None]
    bars = Bars(tuple(entry[0] for entry in rows), [entry[1] for entry in rows], [entry[3] for entry in rows])
    middles = [Mark(entry[2], float(place), role=1) for place, entry in enumerate(rows)]
    title = "limits of the record and of restitution"
    return Panel(Axis("speed", RoadSpeed), Axis(""), (bars, *middles), title)
