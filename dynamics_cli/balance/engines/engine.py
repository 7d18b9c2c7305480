"""Inertia forces and couples of piston engines by order, and what counterweights and balance shafts take away."""

from dynamics_cli.balance.engines.crank import CrankRadius, Stroke, order_factors, require_rod
from dynamics_cli.balance.engines.layouts import Preset, layout
from dynamics_cli.balance.phasors import Phasor, polar, total
from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import pi_beside
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Count,
    CoupleUnbalance,
    Force,
    Length,
    Mass,
    Ratio,
    ShaftSpeed,
    Size,
    Text,
    Torque,
    Unbalance,
)
from dynamics_cli.records import Advice, Choice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# What is left of cylinders that cancel, beside what they would add up to.
CANCELLED = 1e-12
MOST_ORDER = 40


@record
class Cylinder:
    """One cylinder."""

    crank: Annotated[Angle, "Angle of its throw on the crankshaft, e.g. 120 deg."]
    bank: Annotated[Angle, "Direction of its axis, in the sense of rotation, e.g. 30 deg."] = 0.0
    position: Annotated[Length, "Its place along the crankshaft, e.g. 90 mm."] = 0.0


class Turns(Choice):
    """Which way a shaft turns, beside the crankshaft."""

    names = ("with", "against")


WITH = Turns("with")


@record
class Counterweight:
    """A weight on the crankshaft, or on a balance shaft of its own."""

    unbalance: Annotated[Unbalance, "Mass times radius, e.g. 9000 g*mm."]
    angle: Annotated[Angle, "Where it stands at crank angle zero, e.g. 180 deg."]
    position: Annotated[Length, "Its place along the crankshaft, from where couples are taken."] = 0.0
    order: Annotated[Count, "Speed of its shaft over that of the crankshaft."] = 1
    turns: Annotated[Turns, "With the crankshaft, or against it."] = WITH


@record
class Order:
    """One order of the inertia forces and couples: two rotating parts, one with the crankshaft and one against it."""

    order: Annotated[int, "Multiple of the crankshaft's speed [-]."]
    force: Annotated[Force, "Largest force over a turn [N]."]
    forward: Annotated[Force, "Its part that turns with the crankshaft [N]."]
    forward_angle: Annotated[Angle | None, "Where that part stands at crank angle zero [rad]."]
    backward: Annotated[Force, "Its part that turns against the crankshaft [N]."]
    backward_angle: Annotated[Angle | None, "Where that part stands at crank angle zero [rad]."]
    couple: Annotated[Torque | None, "Largest couple over a turn, about the middle; none without places [N·m]."]
    forward_couple: Annotated[Torque | None, "Its part that turns with the crankshaft [N·m]."]
    forward_couple_angle: Annotated[Angle | None, "Where the forces of it stand at crank angle zero [rad]."]
    backward_couple: Annotated[Torque | None, "Its part that turns against the crankshaft [N·m]."]
    backward_couple_angle: Annotated[Angle | None, "Where the forces of it stand at crank angle zero [rad]."]
    force_remedy: Annotated[Text, "What balances the force."]
    couple_remedy: Annotated[Text | None, "What balances the couple."]


@record
class Shaft:
    """Balance weights that take one rotating part of an order away: counterweights, or a shaft of their own."""

    order: Annotated[int, "Multiple of the crankshaft's speed [-]."]
    turns: Annotated[Text, "With the crankshaft, or against it."]
    speed: Annotated[ShaftSpeed, "Speed of the weights [rad/s]."]
    unbalance: Annotated[Unbalance, "Unbalance that takes the force away [kg·m]."]
    angle: Annotated[Angle | None, "Where it stands at crank angle zero [rad]."]
    couple: Annotated[
        CoupleUnbalance | None, "Unbalance times distance of the pair that takes the couple away [kg·m²]."
    ]
    couple_angle: Annotated[
        Angle | None, "Where the weight at the end of the last cylinder stands, the other opposite."
    ]


@record
class EngineBalance:
    """Forces and couples of an engine."""

    cylinders: Annotated[int, "Number of cylinders [-]."]
    ratio: Annotated[Ratio, "Crank radius over rod length λ [-]."]
    primary_force: Annotated[Force, "Largest force of order 1 [N]."]
    secondary_force: Annotated[Force, "Largest force of order 2 [N]."]
    primary_couple: Annotated[Torque | None, "Largest couple of order 1 [N·m]."]
    secondary_couple: Annotated[Torque | None, "Largest couple of order 2 [N·m]."]
    orders: Annotated[tuple[Order, ...], "Forces and couples by order."]
    shafts: Annotated[tuple[Shaft, ...], "Weights that take each order away, part by part."]
    advice: tuple[Advice, ...] = ()


def engine(
    *,
    reciprocating_mass: Annotated[Mass, "Piston, pin and small-end share of the rod, of one cylinder, e.g. 0.5 kg."],
    crank: Annotated[CrankRadius | Stroke, "Crank radius, or stroke."],
    rod_length: Annotated[Size, "Between the centres of the rod's eyes, e.g. 150 mm."],
    speed: Annotated[ShaftSpeed, "Speed of the crankshaft, e.g. 6000 rpm."],
    preset: Annotated[Preset | None, "A standard layout, e.g. inline-4."] = None,
    cylinders: Annotated[tuple[Cylinder, ...], "The cylinders, for any other layout."] = (),
    bank_angle: Annotated[Angle | None, "Angle between the banks of a V, e.g. 90 deg."] = None,
    spacing: Annotated[
        Size, "Spacing from one cylinder (in a V: pair) to the next; without it there are no couples, e.g. 90 mm."
    ] = 0.0,
    offset: Annotated[
        Length,
        "Distance of the cylinder's axis from the crankshaft's, to the side where the crank pin goes down, e.g. 10 mm.",
    ] = 0.0,
    rotating_mass: Annotated[Mass, "Mass at the crank pin of one cylinder that no counterweight balances."] = 0.0,
    counterweights: Annotated[
        tuple[Counterweight, ...], "Weights on the crankshaft or on balance shafts; the answer is what is left."
    ] = (),
    highest_order: Annotated[Count, "Orders above this are left out."] = 6,
) -> EngineBalance:
    """Inertia forces and couples of an engine by order, turning with and against the crankshaft.

    Equation
    --------
    Order n: forward ½·m·r·ω²·ΣA_n·e^{i(n(φ−β)+β)}, backward ½·m·r·ω²·ΣA_n·e^{i(−n(φ−β)+β)}; the force runs round an
    ellipse of half-axes |f| ± |b|. With an offset A_n − i·B_n stands forward, A_n + i·B_n backward.

    Returns
    -------
    EngineBalance
        Forces and couples by order, and the unbalances that take them away.

    Raises
    ------
    InadmissibleError
        When neither or both of preset and cylinders are given, the speed is zero, the crank is too long for the rod, or
        the highest order is not within 1 to 40.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 15.5 to 15.10.

    Examples
    --------
    >>> made = engine(reciprocating_mass=0.5, crank=CrankRadius(0.043), rod_length=0.172, speed=628.3185307179587,
    ...               preset=Preset("inline-4"))
    >>> round(made.secondary_force, 4)
    8624.5158
    """
    require(
        (preset is None) != (len(cylinders) == 0),
        "an engine is given by --preset or by its cylinders" if preset is None else "--preset has its own cylinders",
        code="engine",
        hint='for example --preset inline-4, or --cylinder "crank=0 deg, bank=0 deg, position=0 mm" for each',
    )
    require((highest_order >= 1) and (highest_order <= MOST_ORDER), "orders must be from 1 to 40", code="order")
    require(abs(plain(speed)) > 0.0, "an engine at rest has no inertia force", code="at-rest")
    require(rod_length > 0.0, "the rod has no length", code="rod")
    require(
        all((one.order >= 1) and (one.order <= MOST_ORDER) for one in counterweights),
        "the order of a counterweight must be from 1 to 40",
        code="order",
    )
    ratio = crank.radius / rod_length
    aside = offset / rod_length
    require_rod(ratio, aside)
    if preset is None:
        places = [(one.crank, one.bank, one.position) for one in cylinders]
    else:
        places = layout(preset, bank_angle, spacing)
    unit = crank.radius * speed * speed
    advice = _advice(places, preset)
    counted = not advice
    fitted = {one.order for one in counterweights}
    numbers = [
        n
        for n in range(1, max(highest_order, *fitted, 1) + 1)
        if n in fitted or (n <= highest_order and (n == 1 or n % 2 == 0 or plain(offset) != 0.0))
    ]
    force = reciprocating_mass * unit
    orders = [
        _order(n, places, Phasor(force * a, -force * b), rotating_mass * unit, _balancing(counterweights, n, speed),
               counted=counted)
        for n, (a, b) in zip(numbers, order_factors(ratio, aside, numbers), strict=True)
    ]  # fmt: skip
    second = next((row for row in orders if row.order == 2), None)
    return EngineBalance(
        cylinders=len(places),
        ratio=ratio,
        primary_force=orders[0].force,
        secondary_force=second.force if second else 0.0,
        primary_couple=orders[0].couple,
        secondary_couple=second.couple if second else (0.0 if counted else None),
        orders=tuple(orders),
        shafts=tuple(shaft for row in orders for shaft in _shafts(row, speed)),
        advice=advice,
    )


def _advice(places: "list[Any]", preset: "Preset | None") -> "tuple[Advice, ...]":
    if preset is None or len(places) < 2 or preset.startswith("radial") or any(plain(z) != 0.0 for _, _, z in places):
        return ()
    if preset == "v2":
        return ()
    message = "without the spacing of the cylinders their couples are not counted"
    return (Advice("no-spacing", message, severity="note", remedy="give --spacing"),)


def _balancing(weights: "tuple[Counterweight, ...]", n: int, speed: "Any") -> "list[tuple[Phasor, Any, bool]]":
    """Force, place and sense of the weights that turn at an order's speed."""
    square = n * n * speed * speed
    return [(polar(w.unbalance * square, w.angle), w.position, w.turns == WITH) for w in weights if w.order == n]


def _order(
    n: int,
    places: "list[Any]",
    size: Phasor,
    rotating: "Any",
    weights: "list[tuple[Phasor, Any, bool]]",
    *,
    counted: bool,
) -> Order:
    """The phasors of one order, of the size that one cylinder has, with the weights that turn at its speed."""
    ways = [
        (polar(1.0, n * (crank - bank) + bank), polar(1.0, -n * (crank - bank) + bank), crank)
        for crank, bank, _ in places
    ]
    arms = [z for _, _, z in places]
    forwards = [way * size.times(0.5) for way, _, _ in ways]
    backwards = [way * size.conjugate.times(0.5) for _, way, _ in ways]
    if n == 1:
        forwards = [one + polar(rotating, crank) for one, (_, _, crank) in zip(forwards, ways, strict=True)]
    sides = [
        [*zip(parts, arms, strict=True), *((one, z) for one, z, sense in weights if sense is along)]
        for parts, along in ((forwards, True), (backwards, False))
    ]
    largest = 0.5 * plain(size.size) + (plain(rotating) if n == 1 else 0.0)
    largest = max([largest, *(plain(one.size) for one, _, _ in weights)])
    force = [_cleared(total(one for one, _ in side), len(side) * largest) for side in sides]
    couple = [
        _cleared(total(one.times(z) for one, z in side), sum(abs(plain(z)) for _, z in side) * largest)
        for side in sides
    ]
    sizes, turns = [one.size for one in force], [one.size for one in couple]
    return Order(
        order=n,
        force=sizes[0] + sizes[1],
        forward=sizes[0],
        forward_angle=_angle(force[0]),
        backward=sizes[1],
        backward_angle=_angle(force[1]),
        couple=turns[0] + turns[1] if counted else None,
        forward_couple=turns[0] if counted else None,
        forward_couple_angle=_angle(couple[0]),
        backward_couple=turns[1] if counted else None,
        backward_couple_angle=_angle(couple[1]),
        force_remedy=_remedy(n, sizes),
        couple_remedy=_remedy(n, turns) if counted else None,
    )


def _shafts(row: Order, speed: "Any") -> "list[Shaft]":
    """The weights against both parts of an order, opposite to them."""
    square = row.order * row.order * speed * speed
    parts = (
        ("with the crank", row.forward, row.forward_angle, row.forward_couple, row.forward_couple_angle),
        ("against it", row.backward, row.backward_angle, row.backward_couple, row.backward_couple_angle),
    )
    return [
        Shaft(
            order=row.order,
            turns=sense,
            speed=row.order * speed,
            unbalance=force / square,
            angle=_opposite(angle),
            couple=None if couple is None else couple / square,
            couple_angle=None if couple is None else _opposite(couple_angle),
        )
        for sense, force, angle, couple, couple_angle in parts
        if angle is not None or (couple is not None and couple_angle is not None)
    ]


def _opposite(angle: "Any") -> "Any":
    if angle is None:
        return None
    return angle + pi_beside(angle) if plain(angle) <= 0.0 else angle - pi_beside(angle)


def _cleared(whole: Phasor, largest: float) -> Phasor:
    """A sum, zero where the cylinders cancel."""
    return whole if abs(plain(whole.x)) + abs(plain(whole.y)) > CANCELLED * largest else Phasor(0.0, 0.0)


def _angle(one: Phasor) -> "Any":
    return None if plain(one.x) == 0.0 == plain(one.y) else one.angle


def _remedy(n: int, sizes: "list[Any]") -> str:
    forward, backward = (plain(size) > 0.0 for size in sizes)
    with_it = "counterweight" if n == 1 else "shaft forward"
    if forward and backward:
        return with_it + " and shaft backward" if n == 1 else "two shafts"
    if forward:
        return with_it
    return "shaft backward" if backward else "balanced"
