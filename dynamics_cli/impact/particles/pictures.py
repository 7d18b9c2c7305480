"""Pictures of impacts of particles, as data: scenes before and after, bounces, crush profiles."""

import math

from dynamics_cli.impact.conventions import mass_of
from dynamics_cli.impact.scene_pictures import axes_of, collision, names_of, north_of, on_page, seen, velocities
from dynamics_cli.impact.uncertain_shapes import at_tip, fan
from dynamics_cli.impact.vector_pictures import polygon
from dynamics_cli.impact.vehicle_outlines import LENGTH
from dynamics_cli.impact.verdict_pictures import worst_headings
from dynamics_cli.pictures import Axis, Band, Bars, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Count, Energy, Inertia, Length, Size, Speed, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.pictures import Spreads

    Pair = tuple[float, float]

POINTS = 61
# Inches of a picture whose last panels have long names beside them.
WIDE = 9.0


def oblique(result: "Any", *, first: "Any" = None, second: "Any" = None, **_: "Any") -> Picture:
    """Velocities before and after on one scale, and the line of impact."""
    before, after = [], []
    axes = axes_of(result)
    for end in (result.first, result.second):
        gone = (0.0, 0.0) if end.delta_v is None else end.delta_v.vector
        after.append(on_page(end.velocity, axes))
        before.append(on_page((end.velocity[0] - gone[0], end.velocity[1] - gone[1]), axes))
    way = seen(1.0, result.normal_direction, axes)
    reach = 0.7 * max(max(abs(x), abs(y)) for x, y in [*before, *after]) or 1.0
    panel = velocities(names_of(first, second), before, after, axes=axes)
    line = Curve([-reach * way[0], reach * way[0]], [-reach * way[1], reach * way[1]], "line of impact", "dotted", 2)
    return Picture((Panel(panel.x, panel.y, (line, *panel.items), panel.title, equal=True),), "oblique impact")


def momentum(
    result: "Any", *, first: "Any", second: "Any", gravity: float, damage: "Any" = None,
    spreads: "Spreads | None" = None, **_: "Any",
) -> Picture:  # fmt: skip
    """The vehicles at the impact with their velocities and what is uncertain of them, and the polygon of momenta."""
    axes = axes_of(result)
    bodies = (result.first, result.second)
    names = names_of(first, second)
    before = [seen(vehicle.approach_speed, vehicle.approach_heading, axes) for vehicle in bodies]
    after = [seen(vehicle.exit_speed, vehicle.exit_heading, axes) for vehicle in bodies]
    noses = [
        seen(1.0, body.approach_heading if entered.nose is None else entered.nose, axes)
        for body, entered in zip(bodies, (first, second), strict=True)
    ]
    masses = [mass_of(vehicle.bulk, gravity) for vehicle in (first, second)]

    def uncertain(role: int, centre: "Pair", scale: float) -> "list[Any]":
        """Fans of both headings, and the ellipse at the tip of the velocity after."""
        if spreads is None:
            return []
        side, (u, v) = ("first", "second")[role], after[role]
        reach = 0.5 * LENGTH + scale * math.hypot(*before[role])
        arrow = scale * u, scale * v
        tip, sense = (centre[0] + arrow[0], centre[1] + arrow[1]), -1.0 if axes in ("compass", "sae") else 1.0

        def way(heading: float) -> "Pair":
            return seen(1.0, heading, axes)

        return [
            *fan(spreads, f"{side}.approach_heading", centre, -reach, way, role),
            *fan(spreads, f"{side}.exit_heading", centre, math.hypot(*arrow), way, role),
            *at_tip(spreads, side, tip, arrow, scale, sense, role),
        ]

    inches = (3.4, 3.6) if spreads is None else (7.2, 3.9)
    scene = collision(names, noses, before, after, north_of(axes), None, inches, uncertain=uncertain)
    title = "velocities at the impact, before and after"
    held = spreads and f"fans of headings and ellipses of velocities hold {100.0 * spreads.coverage:.4g} %"
    panels = [scene, polygon(names, masses, before, after)]
    if damage is None and first.approach_speed is None and second.approach_speed is None:
        bulks = [vehicle.bulk for vehicle in (first, second)]
        panels += worst_headings(bodies, bulks, names, axes, gravity, wide=spreads is None)
    return Picture(tuple(panels), title, columns=2, scene=True, width=WIDE if spreads else 0.0, subtitle=held or "")


def central(result: "Any", **_: "Any") -> Picture:
    """Velocities of both bodies: before, in common at the greatest compression, and after."""
    items: list[Any] = []
    for role, (name, end) in enumerate((("first", result.first), ("second", result.second))):
        items.append(
            Curve([1.0, 2.0, 3.0], [end.velocity - end.delta_v, result.common_velocity, end.velocity], name, role=role)
        )
    stage = Axis("", names=("before", "greatest compression", "after"))
    return Picture((Panel(stage, Axis("velocity", Speed), tuple(items)),), "central impact")


def drop(result: "Any", **_: "Any") -> Picture:
    """Height over time."""
    times = [result.fall_time * i / (POINTS - 1) for i in range(POINTS)]
    heights = [result.drop_height * (1.0 - (i / (POINTS - 1)) ** 2) for i in range(POINTS)]
    for bounce in result.bounces:
        fractions = [i / (POINTS - 1) for i in range(POINTS)]
        times += [bounce.time + fraction * bounce.flight_time for fraction in fractions]
        heights += [4.0 * bounce.height * fraction * (1.0 - fraction) for fraction in fractions]
    items: list[Any] = [Curve(times, heights, role=0), Mark(0.0, result.drop_height, "let go")]
    if result.time_to_rest is not None and result.time_to_rest < 2.0 * times[-1]:
        items.append(Band(result.time_to_rest, result.time_to_rest, "rest"))
    return Picture((Panel(Axis("time", Time), Axis("height", Length), tuple(items)),), "bounces")


def crush(result: "Any", *, first: "Any", second: "Any" = None, **_: "Any") -> Picture:
    """The crush profiles of both vehicles."""
    panels = []
    for name, vehicle, damage in (("first", first, result.first), ("second", second, result.second)):
        profile = None if vehicle is None else vehicle.profile
        if profile is None or damage is None:
            if damage is not None:
                panels.append(Panel(Axis("energy of deformation", Energy), Axis(""), (_energy(damage),), name))
            continue
        depths = getattr(profile, "stations", None) or (damage.mean_crush, damage.mean_crush)
        width = profile.width
        x = [width * i / (len(depths) - 1) for i in range(len(depths))]
        items: list[Any] = [
            Curve([0.0, *x, width, 0.0], [0.0, *depths, 0.0, 0.0], "crush", "filled", 0),
            Curve(x, list(depths), "stations", "points", 1),
            Curve([0.0, width], [damage.mean_crush, damage.mean_crush], "mean", "dotted", 2),
        ]
        if damage.crush_centre is not None:
            items.append(Band(damage.crush_centre, damage.crush_centre, "centroid"))
        panels.append(Panel(Axis("along the face", Length), Axis("depth of crush", Size), tuple(items), name))
    return Picture(tuple(panels), "crush profiles")


def _energy(damage: "Any") -> Bars:
    """Energy of a vehicle whose damage is given without a profile."""
    return Bars(("energy",), [0.0], [float(damage.energy)])


def chain(result: "Any", *, bodies: "Any", **_: "Any") -> Picture:
    """Velocities of the bodies before and after, law by law."""
    numbers = [float(nth) for nth in range(1, len(bodies) + 1)]
    items: list[Any] = [Curve(numbers, [body.velocity for body in bodies], "before", "points", 0)]
    for role, law in enumerate(result.laws, 1):
        speeds = [row.velocity for row in result.bodies if row.law == law.law]
        items.append(Curve(numbers, speeds, str(law.law), "points", role))
    return Picture((Panel(Axis("body", Count), Axis("velocity", Speed), tuple(items)),), "a chain of bodies")


def yaw_inertia(result: "Any", **_: "Any") -> Picture:
    """The estimate of every rule, and the range of all."""
    names = tuple(str(estimate.rule) for estimate in result.rules)
    rules = Bars(names, [0.0] * len(names), [float(estimate.yaw_inertia) for estimate in result.rules])
    items = (
        rules,
        Band(float(result.yaw_inertia), float(result.yaw_inertia), "estimate"),
        Band(float(result.lowest), float(result.highest), "range"),
    )
    return Picture((Panel(Axis("yaw inertia", Inertia), Axis(""), items),), "yaw inertia by rules")
