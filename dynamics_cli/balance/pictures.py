"""Polar plots of balance runs, force and couple of an engine, torque with its mean."""

import math
from itertools import pairwise

from dynamics_cli.errors import worded
from dynamics_cli.pictures import Arrow, Axis, Band, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, BalanceMass, Force, Kind, Mass, ShaftSpeed, Torque, Unbalance

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Plane = tuple[float, float]

ROUND = 121
THIRD = 2.0 * math.pi / 3.0
SPOKES = 12
INITIAL = "initial"
# Sizes stand on the rings between two spokes, at the first of these angles that no arrow comes near.
FREE, CLEAR = (285.0, 255.0, 345.0, 195.0, 75.0, 105.0), 25.0
# That of the outer ring stands within it, clear of the angles around.
INSIDE = 0.88
STEPS = 361
# Forces below this share of one cylinder's are not drawn beside couples.
SLIGHT = 5e-3
# Grades of ISO 21940-11 in m/s, those within a factor of the one asked for, over so much less and more of the speed.
GRADES = [g * 1e-3 for g in (0.4, 1.0, 2.5, 6.3, 16.0, 40.0, 100.0, 250.0, 630.0, 1600.0, 4000.0)]
NEAR_GRADES, SPEEDS = 20.0, 5.0
GREY = 6


def _polar(arrows: "Sequence[tuple[Plane, Plane, str, int]]", kind: "Any", title: str) -> Panel:
    """Arrows on rings and spokes; zero degrees is to the right, angles run counter-clockwise."""
    ends = [(x + dx, y + dy) for (x, y), (dx, dy), _, _ in arrows]
    reach = 1.05 * max(math.hypot(*end) for end in ends) or 1.0
    items: list[Any] = []
    turns = [2.0 * math.pi * i / (ROUND - 1) for i in range(ROUND)]
    near = _free(arrows)
    for share in (0.5, 1.0):
        x = [share * reach * math.cos(turn) for turn in turns]
        items.append(Curve(x, [share * reach * math.sin(turn) for turn in turns], "", "dots", role=GREY))
        text = worded("{size:3}", size=(share * reach, kind))
        place = min(share, INSIDE) * reach
        items.append(Label(place * near[0], place * near[1], text))
    for spoke in range(SPOKES):
        turn = 2.0 * math.pi * spoke / SPOKES
        cosine, sine = math.cos(turn), math.sin(turn)
        items.append(Curve([0.0, reach * cosine], [0.0, reach * sine], "", "dots", role=GREY))
        items.append(Label(1.12 * reach * cosine, 1.12 * reach * sine, f"{360 * spoke // SPOKES}°"))
    for (x0, y0), (dx, dy), label, role in arrows:
        items.append(Arrow(x0, y0, dx, dy, "", role=role, dashed=(x0, y0) != (0.0, 0.0)))
        if label:
            items.append(_named(dx, dy, label, role, [way for start, way, _, _ in arrows if start == (0.0, 0.0)]))
    side = (-1.25 * reach, 1.25 * reach)
    return Panel(Axis("", kind, ends=side), Axis("", kind, ends=side), tuple(items), title, equal=True, bare=True)


def _free(arrows: "Sequence[tuple[Plane, Plane, str, int]]") -> "Plane":
    """A direction between the arrows for the sizes of the rings."""
    ways = [math.degrees(math.atan2(y + dy, x + dx)) for (x, y), (dx, dy), _, _ in arrows]
    apart = {free: min(abs((free - way + 180.0) % 360.0 - 180.0) for way in ways) for free in FREE}
    free = next((free for free in FREE if apart[free] >= CLEAR), max(FREE, key=lambda each: apart[each]))
    return math.cos(math.radians(free)), math.sin(math.radians(free))


def _named(dx: float, dy: float, label: str, role: int, others: "Sequence[Plane]") -> Mark:
    """The name of an arrow from the centre beside its tip, on the side away from the other arrows."""
    side = sum(dx * y - dy * x for x, y in others)
    across = (dy, -dx) if side >= 0.0 else (-dy, dx)
    length = math.hypot(dx, dy) or 1.0
    away = (across[0] / length, across[1] / length)
    # the initial reading lies among those of the trials, and has its name half way
    share = 0.55 if role == 0 and label == INITIAL else 1.0
    return Mark(share * dx, share * dy, label, (math.copysign(5.0, away[0]), 6.0 * away[1]), dot=False, role=role)


def _at(size: "Any", angle: "Any") -> "Plane":
    return (0.0, 0.0) if angle is None else (size * math.cos(angle), size * math.sin(angle))


def trial(result: "Any", *, sensors: "Any", **_: "Any") -> Picture:
    """For each sensor the readings of all runs, and the corrections."""
    rows = sensors if isinstance(sensors, tuple) else (sensors,)
    first = rows[0].initial.kind
    kind = Kind(first.name, first.unit, si=first.si, us=first.si)
    panels = []
    for nth, row in enumerate(rows, 1):
        start = row.initial.value
        arrows = [((0.0, 0.0), start, INITIAL, 0)]
        for name, reading, role in (("1st trial", row.first, 1), ("2nd trial", row.second, 2)):
            if reading is not None:
                arrows.append(((0.0, 0.0), reading.value, name, role))
                change = (reading.value[0] - start[0], reading.value[1] - start[1])
                arrows.append((start, change, "", role))
        if row.now is not None:
            arrows.append(((0.0, 0.0), row.now.value, "now", 3))
        panels.append(_polar(arrows, kind, f"readings of sensor {nth}"))
        left = result.predicted[nth - 1].residual.value
        if left > SLIGHT * math.hypot(*start):
            words = worded("left: {size}", size=(left, kind))
            rest: list[Any] = [
                _circle((0.0, 0.0), left, "thick", 3),
                Mark(left * 0.26, left * 0.97, words, dot=False, role=3),
            ]
            last = panels[-1]
            panels[-1] = Panel(last.x, last.y, (*last.items, *rest), last.title, equal=True, bare=True)
    masses = [((0.0, 0.0), _at(result.first_mass, result.first_angle), "1st plane", 1)]
    if result.second_mass is not None:
        masses.append(((0.0, 0.0), _at(result.second_mass, result.second_angle), "2nd plane", 2))
    panels.append(_polar(masses, BalanceMass, "masses to add"))
    return Picture(tuple(panels), "balance run", columns=2)


def four_runs(
    result: "Any", *, initial: "Any", first: "Any", second: "Any", third: "Any", trial_mass: float,
    first_angle: float = 0.0, second_angle: float = THIRD, third_angle: float = 2.0 * THIRD, **_: "Any",
) -> Picture:  # fmt: skip
    """The circles of the three runs about their places on that of the first, and where they meet."""
    still = initial.value[0]
    kind = Kind(initial.kind.name, initial.kind.unit, si=initial.kind.si, us=initial.kind.si)
    items: list[Any] = [_circle((0.0, 0.0), still, "dashed", GREY)]
    for nth, (run, angle) in enumerate(((first, first_angle), (second, second_angle), (third, third_angle)), 1):
        centre, size = _at(still, angle), run.value[0]
        words = worded("run {nth}: {size}", nth=str(nth), size=(size, kind))
        aside = (math.copysign(5.0, centre[0]), 5.0)
        items += [_circle(centre, size, "solid", nth), Mark(*centre, words, aside, role=nth)]
    circles = [item for item in items if isinstance(item, Curve)]
    ways = ([v for one in circles for v in one.x], [v for one in circles for v in one.y])
    x, y = (Axis("", kind, ends=(min(way) - 0.15 * still, max(way) + 0.15 * still)) for way in ways)
    items.append(Arrow(0.0, 0.0, *_at(result.consistency * result.effect.value, result.angle), "", role=0))
    subtitle = worded(
        "dashed: the initial reading; arrow: where to add {mass}, at {angle}",
        mass=(result.mass, BalanceMass),
        angle=(result.angle, Angle),
    )
    return Picture((Panel(x, y, tuple(items), "", equal=True),), "four runs and their circles", subtitle=subtitle)


def _circle(centre: "Plane", radius: float, style: "Any", role: int) -> Curve:
    turns = [2.0 * math.pi * i / (ROUND - 1) for i in range(ROUND)]
    x, y = centre
    return Curve([x + radius * math.cos(t) for t in turns], [y + radius * math.sin(t) for t in turns], "", style, role)


def planes(result: "Any", *, unbalances: "Any", **_: "Any") -> Picture:
    """The unbalances and the corrections."""
    rows = unbalances if isinstance(unbalances, tuple) else (unbalances,)
    zero = (0.0, 0.0)
    given = [(zero, _at(one.amount, one.angle), str(nth), 0) for nth, one in enumerate(rows, 1)]
    added = [
        (zero, _at(result.first_unbalance, result.first_angle), "1st plane", 1),
        (zero, _at(result.second_unbalance, result.second_angle), "2nd plane", 2),
    ]
    panels = (_polar(given, Unbalance, "unbalances"), _polar(added, Unbalance, "corrections, mass added"))
    return Picture(panels, "two-plane balance", columns=2)


def static(result: "Any", *, weights: "Any", **_: "Any") -> Picture:
    """The unbalance of each mass, what they add up to, and its correction."""
    rows = weights if isinstance(weights, tuple) else (weights,)
    zero = (0.0, 0.0)
    arrows = [(zero, _at(one.mass * one.radius, one.angle), str(nth), 0) for nth, one in enumerate(rows, 1)]
    if len(rows) > 1:
        arrows.append((zero, _at(result.unbalance, result.angle), "sum", 1))
    arrows.append((zero, _at(result.unbalance, result.correction_angle), "correction", 2))
    return Picture((_polar(arrows, Unbalance, ""),), "unbalance of the masses in one plane")


def split(result: "Any", *, mass: float, angle: float, places: "Any", **_: "Any") -> Picture:
    """The correction and the two masses that make it, with the holes of a pattern."""
    zero = (0.0, 0.0)
    names = [f"hole {hole}" if hole else name for hole, name in
             ((result.first_hole, "1st place"), (result.second_hole, "2nd place"))]  # fmt: skip
    wanted = _at(mass, angle)
    arrows = [
        (zero, wanted, "", 0),
        (zero, _at(result.first_mass, result.first_angle), names[0], 1),
        (zero, _at(result.second_mass, result.second_angle), names[1], 2),
    ]
    panel = _polar(arrows, BalanceMass, "")
    count = getattr(places, "holes", 0)
    ring = 1.05 * max(mass, result.first_mass, result.second_mass)
    holes = [Mark(*_at(ring, places.first_hole + 2.0 * math.pi * k / count), role=GREY) for k in range(count)]
    # the correction lies between the places, and has its name beyond its tip
    name = Mark(*wanted, "correction", (0.0, math.copysign(9.0, wanted[1])), dot=False, role=0)
    items = (*panel.items, *holes, name)
    return Picture((Panel(panel.x, panel.y, items, "", equal=True, bare=True),), "a correction on two places")


def grade(
    result: "Any", *, grade: float, speed: float, mass: float, measured: "float | None" = None, **_: "Any"
) -> Picture:
    """Lines of equal grade over speed for the mass of the rotor, with what is permitted and what was measured."""
    ends = abs(speed) / SPEEDS, abs(speed) * SPEEDS
    asked = any(abs(grade / each - 1.0) < 1e-9 for each in GRADES)
    near = [each for each in GRADES if grade / NEAR_GRADES <= each <= grade * NEAR_GRADES]
    items: list[Any] = []
    for each in near if asked else sorted([*near, grade]):
        this = abs(each / grade - 1.0) < 1e-9
        items.append(
            Curve(ends, [each * mass / end for end in ends], "", "thick" if this else "thin", role=0 if this else GREY)
        )
        items.append(
            Mark(ends[1], each * mass / ends[1], f"G {each * 1e3:.4g}", (5.0, 0.0), dot=False, role=0 if this else GREY)
        )
    up = -12.0 if measured and measured > result.unbalance else 12.0
    items.append(
        Mark(
            abs(speed),
            result.unbalance,
            worded("permitted {most:4}", most=(result.unbalance, Unbalance)),
            (6.0, up),
            role=0,
        )
    )
    if measured:
        items.append(
            Mark(abs(speed), measured, worded("measured {size:4}", size=(measured, Unbalance)), (-6.0, -up), role=1)
        )
    panel = Panel(
        Axis("speed", ShaftSpeed, logarithmic=True, ends=(ends[0], 1.6 * ends[1])),
        Axis("permissible unbalance", Unbalance, logarithmic=True),
        tuple(items),
    )
    return Picture((panel,), worded("balance grades of a rotor of {mass}", mass=(mass, Mass)))


def engine(result: "Any", *, reciprocating_mass: float, crank: "Any", speed: float, **_: "Any") -> Picture:
    """Force and couple over the turn of the crank, and the paths of their tips by order."""
    single = reciprocating_mass * crank.radius * speed * speed
    forces = [(row.order, row.forward, row.forward_angle, row.backward, row.backward_angle) for row in result.orders]
    couples = [
        (row.order, row.forward_couple, row.forward_couple_angle, row.backward_couple, row.backward_couple_angle)
        for row in result.orders
        if row.couple
    ]
    panels: list[Panel] = []
    # what is left of the force beside that of one cylinder, unless nothing else is
    if max(row.force for row in result.orders) > SLIGHT * single or not couples:
        panels += _shaking(forces, Force, "force")
    if couples:
        panels += _shaking(couples, Torque, "couple")
    return Picture(tuple(panels), worded("inertia forces at {speed}", speed=(speed, ShaftSpeed)))


def _shaking(orders: "Sequence[Any]", kind: "Any", name: str) -> "list[Panel]":
    """A force, or the forces of a couple, over the crank angle, and round its path by order where that is no line."""
    angles = [2.0 * math.pi * i / (STEPS - 1) for i in range(STEPS)]
    paths = [[_turned(order, angle) for angle in angles] for order in orders]
    sums = [[sum(path[i][axis] for path in paths) for i in range(STEPS)] for axis in (0, 1)]
    level = Band(0.0, 0.0, "", vertical=False)
    crank = Axis("crank angle", Angle, step=math.pi / 3.0)
    largest = max(order[1] + order[3] for order in orders)
    seen = [nth for nth, order in enumerate(orders) if order[1] + order[3] > 1e-3 * largest]
    along, across = Axis(f"{name} at bank angle 0", kind), Axis(f"{name} across it", kind)
    if max(map(abs, sums[1])) <= 1e-3 * largest:
        curves = [Curve(angles, [x for x, _ in paths[nth]], f"order {orders[nth][0]}", role=nth) for nth in seen]
        if len(curves) > 1:
            curves.append(Curve(angles, sums[0], "all orders", "thin", role=GREY))
        return [Panel(crank, along, (*curves, level))]
    both = (Curve(angles, sums[0], "at bank angle 0", role=0), Curve(angles, sums[1], "across it", role=1), level)
    tips = tuple(
        Curve([x for x, _ in paths[nth]], [y for _, y in paths[nth]], f"order {orders[nth][0]}", role=nth)
        for nth in seen
    )
    return [Panel(crank, Axis(name, kind), both), Panel(along, across, tips, f"{name} by order", equal=True)]


def _turned(order: "Any", angle: float) -> "Plane":
    """The force of one order at a crank angle."""
    number, forward, forward_angle, backward, backward_angle = order
    turn = number * angle
    one = _at(forward, None if forward_angle is None else forward_angle + turn)
    other = _at(backward, None if backward_angle is None else backward_angle - turn)
    return one[0] + other[0], one[1] + other[1]


def turning(result: "Any", **_: "Any") -> Picture:
    """The turning moment over a cycle with its parts, and its orders."""
    rows = result.torque
    x = [row.angle for row in rows]
    mean = result.mean_torque
    items = (
        Curve(x, [row.gas for row in rows], "gas", "dashed", role=1),
        Curve(x, [row.inertia for row in rows], "inertia", "thin", role=2),
        Curve(x, [row.torque for row in rows], "both", role=0),
        Curve([x[0], x[-1]], [mean, mean], "mean", "centre", role=3),
    )
    over = Panel(Axis("crank angle", Angle, step=math.pi / 2.0), Axis("turning moment", Torque), items)
    stems = tuple(Curve([row.order] * 2, [0.0, row.torque], "", "thick", role=0) for row in result.orders)
    top = max((row.torque for row in result.orders), default=1.0)
    last = max((row.order for row in result.orders), default=1.0) + 0.5
    by_order = Panel(Axis("order", ends=(0.0, last)), Axis("amplitude", Torque, ends=(0.0, 1.1 * top)), stems)
    return Picture((over, by_order), "turning moment", subtitle=f"firing order {result.firing_order}")


def flywheel(result: "Any", *, points: "Any", **_: "Any") -> Picture:
    """Torque over the cycle, its mean, and where the shaft is fastest and slowest."""
    x, y = [one.angle for one in points], [one.torque for one in points]
    mean = result.mean_torque
    items: tuple[Any, ...] = (
        *_areas(points, result),
        Curve(x, y, "torque", role=0),
        Curve([x[0], x[-1]], [mean, mean], "mean", "dashed", role=1),
        Mark(result.fastest, mean, "fastest"),
        Mark(result.slowest, mean, "slowest", (6.0, -12.0)),
    )
    panel = Panel(Axis("angle", Angle, step=math.pi / 3.0), Axis("torque", Torque), items)
    return Picture((panel,), "torque and its mean")


def _areas(points: "Any", result: "Any") -> "list[Curve]":
    """The areas between torque and mean from crossing to crossing: work that the flywheel takes up and gives back."""
    ends = [points[0].angle, *(row.angle for row in result.crossings), points[-1].angle]
    areas = []
    for low, high in pairwise(ends):
        inner = [(one.angle, one.torque) for one in points if low <= one.angle <= high]
        if inner:
            corners = [(low, result.mean_torque), *inner, (high, result.mean_torque)]
            above = max(inner, key=lambda corner: abs(corner[1] - result.mean_torque))[1] > result.mean_torque
            areas.append(Curve([a for a, _ in corners], [t for _, t in corners], "", "fill", role=0 if above else 1))
    return areas
