"""Polar plots of balance runs, force and couple of an engine, torque with its mean."""

import math

from dynamics_cli.errors import worded
from dynamics_cli.pictures import Arrow, Axis, Band, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, BalanceMass, Force, Kind, ShaftSpeed, Torque, Unbalance

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Plane = tuple[float, float]

ROUND = 121
SPOKES = 12
STEPS = 361
GREY = 6


def _polar(arrows: "Sequence[tuple[Plane, Plane, str, int]]", kind: "Any", title: str) -> Panel:
    """Arrows on rings and spokes; zero degrees is to the right, angles run counter-clockwise."""
    ends = [(x + dx, y + dy) for (x, y), (dx, dy), _, _ in arrows]
    reach = 1.05 * max(math.hypot(*end) for end in [*ends, *(start for start, _, _, _ in arrows)]) or 1.0
    items: list[Any] = []
    for share in (0.5, 1.0):
        turns = [2.0 * math.pi * i / (ROUND - 1) for i in range(ROUND)]
        x = [share * reach * math.cos(turn) for turn in turns]
        y = [share * reach * math.sin(turn) for turn in turns]
        items.append(Curve(x, y, "", "dots", role=GREY))
    for spoke in range(SPOKES):
        turn = 2.0 * math.pi * spoke / SPOKES
        cosine, sine = math.cos(turn), math.sin(turn)
        items.append(Curve([0.0, reach * cosine], [0.0, reach * sine], "", "dots", role=GREY))
        items.append(Label(1.13 * reach * cosine, 1.13 * reach * sine, worded("{at}", at=(turn, Angle))))
    corner = 1.25 * reach
    items.append(Curve([-corner, corner], [-corner, corner], "", "fill", GREY))
    for (x0, y0), (dx, dy), label, role in arrows:
        items.append(Arrow(x0, y0, dx, dy, "", role=role))
        if label:
            right = 5.0 if dx >= 0.0 else -5.0
            items.append(Mark(x0 + 0.75 * dx, y0 + 0.75 * dy, label, (right, 5.0), dot=False, role=role))
    return Panel(Axis("towards 0 deg", kind), Axis("towards 90 deg", kind), tuple(items), title, equal=True)


def _at(size: "Any", angle: "Any") -> "Plane":
    return (0.0, 0.0) if angle is None else (size * math.cos(angle), size * math.sin(angle))


def trial(made: "Any", *, sensors: "Any", **_: "Any") -> Picture:
    """For each sensor the readings of all runs, and the corrections."""
    rows = sensors if isinstance(sensors, tuple) else (sensors,)
    first = rows[0].initial.kind
    kind = Kind(first.name, first.unit, si=first.si, us=first.us)
    panels = []
    for nth, row in enumerate(rows, 1):
        start = row.initial.value
        arrows = [((0.0, 0.0), start, "initial", 0)]
        for name, reading, role in (("1st trial", row.first, 1), ("2nd trial", row.second, 2)):
            if reading is not None:
                arrows.append(((0.0, 0.0), reading.value, name, role))
                change = (reading.value[0] - start[0], reading.value[1] - start[1])
                arrows.append((start, change, "", role))
        panels.append(_polar(arrows, kind, f"readings of sensor {nth}"))
    masses = [((0.0, 0.0), _at(made.first_mass, made.first_angle), "1st plane", 1)]
    if made.second_mass is not None:
        masses.append(((0.0, 0.0), _at(made.second_mass, made.second_angle), "2nd plane", 2))
    panels.append(_polar(masses, BalanceMass, "masses to add"))
    return Picture(tuple(panels), "balance run", columns=min(len(panels), 3))


def planes(made: "Any", *, unbalances: "Any", **_: "Any") -> Picture:
    """The unbalances and the corrections."""
    rows = unbalances if isinstance(unbalances, tuple) else (unbalances,)
    zero = (0.0, 0.0)
    given = [(zero, _at(one.amount, one.angle), str(nth), 0) for nth, one in enumerate(rows, 1)]
    added = [
        (zero, _at(made.first_unbalance, made.first_angle), "1st plane", 1),
        (zero, _at(made.second_unbalance, made.second_angle), "2nd plane", 2),
    ]
    panels = (_polar(given, Unbalance, "unbalances"), _polar(added, Unbalance, "corrections, mass added"))
    return Picture(panels, "two-plane balance", columns=2)


def engine(made: "Any", *, speed: float, **_: "Any") -> Picture:
    """Force over the turn of the crank, and the path of its tip by order."""
    angles = [2.0 * math.pi * i / (STEPS - 1) for i in range(STEPS)]
    paths = [[_turned(row, angle) for angle in angles] for row in made.orders]
    whole = [(sum(path[i][0] for path in paths), sum(path[i][1] for path in paths)) for i in range(STEPS)]
    crank = Axis("crank angle", Angle, step=math.pi / 3.0)
    over = [
        Curve(angles, [x for x, _ in whole], "at bank angle 0", role=0),
        Curve(angles, [y for _, y in whole], "across it", role=1),
        Band(0.0, 0.0, "", vertical=False),
    ]
    ellipses = [
        Curve([x for x, _ in path], [y for _, y in path], f"order {row.order}", role=nth)
        for nth, (row, path) in enumerate(zip(made.orders, paths, strict=True))
        if row.force > 1e-3 * max(one.force for one in made.orders)
    ]
    tips = Panel(
        Axis("at bank angle 0", Force), Axis("across it", Force), tuple(ellipses), "force by order", equal=True
    )
    names = tuple(f"order {row.order}" for row in made.orders)
    panels = [Panel(crank, Axis("force", Force), tuple(over), "inertia force on the frame")] if ellipses else []
    if ellipses:
        panels.append(tips)
    if any(row.couple > 0.0 for row in made.orders):
        couples = [
            Curve(angles, [_couple(row, angle) for angle in angles], name, role=nth)
            for nth, (row, name) in enumerate(zip(made.orders, names, strict=True))
            if row.couple > 1e-3 * made.orders[0].couple or made.orders[0].couple == 0.0
        ]
        panels.append(Panel(crank, Axis("couple", Torque), (*couples, Band(0.0, 0.0, "", vertical=False)), "couple"))
    return Picture(tuple(panels), worded("inertia forces at {speed}", speed=(speed, ShaftSpeed)))


def _turned(row: "Any", angle: float) -> "Plane":
    """The force of one order at a crank angle."""
    turn = row.order * angle
    forward = _at(row.forward, None if row.forward_angle is None else row.forward_angle + turn)
    backward = _at(row.backward, None if row.backward_angle is None else row.backward_angle - turn)
    return forward[0] + backward[0], forward[1] + backward[1]


def _couple(row: "Any", angle: float) -> float:
    """The couple of one order at a crank angle, of the force at bank angle zero."""
    turn = row.order * angle
    forward = 0.0 if row.forward_couple_angle is None else math.cos(row.forward_couple_angle + turn)
    backward = 0.0 if row.backward_couple_angle is None else math.cos(row.backward_couple_angle - turn)
    together: float = row.forward_couple * forward + row.backward_couple * backward
    return together


def flywheel(made: "Any", *, points: "Any", **_: "Any") -> Picture:
    """Torque over the cycle, its mean, and where the shaft is fastest and slowest."""
    x, y = [one.angle for one in points], [one.torque for one in points]
    mean = made.mean_torque
    items = (
        Curve(x, y, "torque", role=0),
        Curve([x[0], x[-1]], [mean, mean], "mean", "dashed", role=1),
        Mark(made.fastest, mean, "fastest"),
        Mark(made.slowest, mean, "slowest", (6.0, -12.0)),
    )
    panel = Panel(Axis("angle", Angle), Axis("torque", Torque), items)
    return Picture((panel,), "torque and its mean")
