"""Turning moment of an engine: gas and inertia torque of all cylinders over a cycle, and by order."""

import math
from bisect import bisect_left
from itertools import pairwise, product

from dynamics_cli.balance.engines.crank import CrankRadius, Stroke, motion, require_rod
from dynamics_cli.balance.engines.engine import Cylinder
from dynamics_cli.balance.engines.firing import TURN, Strokes, firing
from dynamics_cli.balance.engines.layouts import Preset, layout
from dynamics_cli.balance.flywheel import require_increasing
from dynamics_cli.balance.phasors import Phasor, polar, total
from dynamics_cli.errors import require
from dynamics_cli.numerics.quadrature.gauss import legendre
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Count,
    Length,
    Mass,
    Power,
    Pressure,
    Ratio,
    ShaftSpeed,
    Size,
    Text,
    Torque,
)
from dynamics_cli.records import Check, record
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.balance.engines.firing import Fired

    # Gas and inertia torque of an order, of cylinders alike, and their firing angles.
    Waves = list[tuple[tuple[Phasor, Phasor], list[float]]]

FOUR = Strokes("four")
DEGREE = math.pi / 180.0
# Panels of integration, and points in each: torques times waves of order 20 to the last digits.
PANEL, NODES = 5.0 * DEGREE, 8
HIGHEST = 20
# What the first and the last pressure of a cycle may differ by, beside the largest; and its length.
CLOSED = 1e-9
# What is left of cylinders that cancel, beside what they would add up to.
CANCELLED = 1e-11
LARGEST = 1e300


@record
class Diagram:
    """The pressure in a cylinder at a crank angle."""

    angle: Annotated[Angle, "Crank angle after top dead centre of its firing, e.g. 15 deg."]
    pressure: Annotated[Pressure, "Pressure above that in the crankcase, e.g. 40 bar."]
    cylinder: Annotated[Count | None, "Of this cylinder alone, such as one that misfires, e.g. 2."] = None


@record
class TorqueOrder:
    """One order of the turning moment: a wave over the crank angle."""

    order: Annotated[Ratio, "Waves in a turn of the crankshaft [-]."]
    torque: Annotated[Torque, "Its amplitude [N·m]."]
    phase: Annotated[Angle | None, "Its phase: amplitude·cos(order·angle + phase) [rad]."]
    gas: Annotated[Torque, "Amplitude of the gas torque alone [N·m]."]
    inertia: Annotated[Torque, "Amplitude of the inertia torque alone [N·m]."]
    single: Annotated[Torque, "Amplitude of one cylinder alone [N·m]."]


@record
class TorquePoint:
    """The turning moment at a crank angle."""

    angle: Annotated[Angle, "Crank angle after the first cylinder fires [rad]."]
    torque: Annotated[Torque, "Turning moment of all cylinders [N·m]."]
    gas: Annotated[Torque, "Its gas part [N·m]."]
    inertia: Annotated[Torque, "Its inertia part [N·m]."]


@record
class Firing:
    """When a cylinder fires."""

    cylinder: Annotated[int, "Number of the cylinder [-]."]
    angle: Annotated[Angle, "Crank angle at which it fires [rad]."]
    interval: Annotated[Angle, "Until the next one fires [rad]."]


@record
class Turning:
    """The turning moment of an engine."""

    mean_torque: Annotated[Torque, "Mean turning moment, before friction [N·m]."]
    power: Annotated[Power, "Indicated power [W]."]
    mean_pressure: Annotated[Pressure, "Indicated mean effective pressure [Pa]."]
    largest: Annotated[Torque, "Largest turning moment of the table [N·m]."]
    largest_angle: Annotated[Angle, "Where it is [rad]."]
    smallest: Annotated[Torque, "Smallest turning moment of the table [N·m]."]
    smallest_angle: Annotated[Angle, "Where it is [rad]."]
    firing_order: Annotated[Text, "Cylinders in the order in which they fire."]
    evenness: Annotated[Text, "Even, or the intervals between firings in degrees."]
    orders: Annotated[tuple[TorqueOrder, ...], "The turning moment by order, without those that cancel."]
    firings: Annotated[tuple[Firing, ...], "When each cylinder fires."]
    torque: Annotated[tuple[TorquePoint, ...], "The turning moment over a cycle."]
    checks: tuple[Check, ...] = ()


def turning(
    *,
    diagram_points: Annotated[tuple[Diagram, ...], "Pressure in a cylinder over its cycle, linear between points."],
    bore: Annotated[Size, "Bore of a cylinder, e.g. 86 mm."],
    reciprocating_mass: Annotated[Mass, "Piston, pin and small-end share of the rod, of one cylinder, e.g. 0.5 kg."],
    crank: Annotated[CrankRadius | Stroke, "Crank radius, or stroke."],
    rod_length: Annotated[Size, "Between the centres of the rod's eyes, e.g. 150 mm."],
    speed: Annotated[ShaftSpeed, "Speed of the crankshaft, e.g. 3000 rpm."],
    preset: Annotated[Preset | None, "A standard layout, e.g. inline-4."] = None,
    cylinders: Annotated[tuple[Cylinder, ...], "The cylinders, for any other layout."] = (),
    bank_angle: Annotated[Angle | None, "Angle between the banks of a V, e.g. 90 deg."] = None,
    offset: Annotated[
        Length,
        "Distance of the cylinder's axis from the crankshaft's, to the side where the crank pin goes down, e.g. 10 mm.",
    ] = 0.0,
    strokes: Annotated[Strokes, "Strokes of a cycle."] = FOUR,
    firing_order: Annotated[Text | None, "Numbers of the cylinders, e.g. 1-3-4-2; without it the most even."] = None,
    highest_order: Annotated[Count, "Orders above this are left out."] = 6,
    step: Annotated[Angle, "Step of the table."] = 5.0 * DEGREE,
) -> Turning:
    """Turning moment of an engine over a cycle and by order, from a pressure diagram and the inertia of its pistons.

    Equation
    --------
    T = p·A·r·v − m·r²·ω²·a·v, v = sin θ + u·cos θ/√(1 − u²), u = λ·sin θ − e/l, a the acceleration over r·ω²; order n:
    (2/C)·∫T·e^{−inθ}dθ over the cycle C, times Σe^{−inθₖ} of the firing angles θₖ.

    Returns
    -------
    Turning
        Mean, orders and table of the turning moment, the firing order and its intervals.

    Raises
    ------
    InadmissibleError
        When neither or both of preset and cylinders are given, the pressures are not those of one closed cycle, the
        firing order is not one of this crankshaft, the crank is too long for the rod, or the speed is zero.

    References
    ----------
    Virtual power: the torque is the force on the piston times its speed over that of the crankshaft.

    Examples
    --------
    >>> flat = tuple(Diagram(turn * math.pi, 1e5) for turn in range(5))
    >>> made = turning(diagram_points=flat, bore=0.086, reciprocating_mass=0.5, crank=CrankRadius(0.043),
    ...                rod_length=0.15, speed=300.0, preset=Preset("inline-4"))
    >>> abs(made.mean_torque) < 1e-9, made.firing_order
    (True, '1-3-4-2')
    """
    require(
        (preset is None) != (len(cylinders) == 0),
        "an engine is given by --preset or by its cylinders" if preset is None else "--preset has its own cylinders",
        code="engine",
        hint='for example --preset inline-4, or --cylinder "crank=0 deg, bank=0 deg" for each',
    )
    require(abs(speed) > 0.0, "an engine at rest has no turning moment", code="at-rest")
    require(rod_length > 0.0, "the rod has no length", code="rod")
    require(bore > 0.0, "the bore is zero", code="bore")
    require((highest_order >= 1) and (highest_order <= HIGHEST), "orders must be from 1 to 20", code="order")
    ratio, aside = crank.radius / rod_length, offset / rod_length
    require_rod(ratio, aside)
    turns = 2 if strokes == FOUR else 1
    cycle = turns * TURN
    count = _steps(step, cycle)
    places = [(c.crank, c.bank) for c in cylinders]
    if preset is not None:
        places = [(crank, bank) for crank, bank, _ in layout(preset, bank_angle, 1.0)]
    fired, even = firing(places, turns, firing_order)
    area = 0.25 * math.pi * bore * bore
    rim = crank.radius * speed
    alike = [
        (_Cylinder(points, ratio, aside, area * crank.radius, -reciprocating_mass * rim * rim), angles)
        for points, angles in _diagrams(diagram_points, fired, cycle)
    ]
    numbers = [k / turns for k in range(1 if drawing() else turns * highest_order + 1)]
    parts = [[(cylinder.wave(n, cycle), angles) for cylinder, angles in alike] for n in numbers]
    orders = [_order(n, waves) for n, waves in zip(numbers[1:], parts[1:], strict=True)]
    orders = [row for row in orders if row.torque > 0.0]
    table = _table(alike, cycle, count)
    gas, inertia = (math.fsum(0.5 * len(angles) * wave[i].x for wave, angles in parts[0]) for i in range(2))
    high, low = _extreme(table, 1.0), _extreme(table, -1.0)
    scale = abs(alike[0][0].mass) * len(fired) or 1.0
    swept = 2.0 * area * crank.radius * len(fired)
    return Turning(
        mean_torque=gas,
        power=gas * abs(speed),
        mean_pressure=gas * cycle / swept,
        largest=high.torque,
        largest_angle=high.angle,
        smallest=low.torque,
        smallest_angle=low.angle,
        firing_order="-".join(str(number) for number, _, _ in fired),
        evenness=even,
        orders=tuple(orders),
        firings=tuple(Firing(*one) for one in fired),
        torque=tuple(table),
        checks=(Check("the inertia torque has no mean", abs(inertia) <= 1e-10 * scale, abs(inertia) / scale, 1e-10),),
    )


def _diagrams(
    points: "tuple[Diagram, ...]", fired: "list[Fired]", cycle: float
) -> "list[tuple[tuple[Diagram, ...], list[float]]]":
    """Each diagram with the firing angles of its cylinders, that of most cylinders first."""
    own: dict[int | None, list[Diagram]] = {}
    for point in points:
        own.setdefault(point.cylinder, []).append(point)
    found: dict[int | None, list[float]] = {None: []}
    for number, at, _ in fired:
        found.setdefault(number if number in own else None, []).append(at)
    for unknown in own.keys() - found.keys():
        require(False, "there is no cylinder {number}: the engine has {count}", code="cylinder",
                number=str(unknown), count=str(len(fired)))  # fmt: skip
    require(bool(own.get(None)) or not found[None], "the pressures of the other cylinders are missing", code="missing",
            hint="points without a cylinder are of all that have none of their own")  # fmt: skip
    made = [(tuple(own[number]), angles) for number, angles in found.items() if angles]
    for part, _ in made:
        _require_cycle(part, cycle)
    return made


def _require_cycle(pressures: "tuple[Diagram, ...]", cycle: float) -> None:
    require(
        len(pressures) >= 3,
        "{count} points do not make a cycle of pressure",
        code="too-few",
        hint="give three or more, such as those of a file: --diagram @diagram.csv",
        count=str(len(pressures)),
    )
    require_increasing([point.angle for point in pressures])
    width = pressures[-1].angle - pressures[0].angle
    require(
        abs(width - cycle) <= CLOSED * cycle, "the pressures are those of {width}, wanted {cycle}", code="cycle",
        hint="a cycle of four strokes is two turns, one of two strokes (--strokes two) one turn",
        width=(width, Angle), cycle=(cycle, Angle),
    )  # fmt: skip
    first, last = pressures[0].pressure, pressures[-1].pressure
    require(
        abs(last - first) <= CLOSED * max(abs(one.pressure) for one in pressures),
        "the cycle does not close: it begins with {first} and ends with {last}", code="open",
        hint="end it with the pressure that it begins with", first=(first, Pressure), last=(last, Pressure),
    )  # fmt: skip


def _steps(step: float, cycle: float) -> int:
    require((step >= 0.1 * DEGREE) and (step <= 30.0 * DEGREE), "a step of {step} is not within 0.1 and 30 deg",
            code="step", step=(step, Angle))  # fmt: skip
    count = round(cycle / step)
    require(abs(count * step - cycle) <= CLOSED * cycle, "steps of {step} do not fill the cycle", code="step",
            hint="give a step that divides 360 deg", step=(step, Angle))  # fmt: skip
    return count


class _Cylinder:
    """One cylinder over its cycle, from its firing."""

    def __init__(self, pressures: "tuple[Diagram, ...]", ratio: float, aside: float, push: float, mass: float) -> None:
        self.ratio, self.aside, self.push, self.mass = ratio, aside, push, mass
        self.points = [(one.angle, one.pressure) for one in pressures]
        require(
            max(push * max(abs(one.pressure) for one in pressures), abs(mass)) < LARGEST,
            "the torques are beyond the range of a double",
            code="range",
            hint="check the units of bore, mass, speed and pressures",
        )
        self.weighted = self._weighted()

    def torques(self, angle: float, pressure: float) -> "tuple[float, float]":
        """Gas and inertia torque."""
        speed, bend = motion(self.ratio, self.aside, math.cos(angle), math.sin(angle))
        return self.push * pressure * speed, self.mass * bend * speed

    def at(self, angle: float, cycle: float) -> "tuple[float, float]":
        """Torques at any angle after its firing."""
        begin = self.points[0][0]
        within = begin + (angle - begin) % cycle
        after = min(bisect_left(self.points, (within,), 1), len(self.points) - 1)
        (low, first), (high, second) = self.points[after - 1 : after + 1]
        return self.torques(within, first + (second - first) * (within - low) / (high - low))

    def wave(self, order: float, cycle: float) -> "tuple[Phasor, Phasor]":
        """(2/C)·∫T·e^{−inθ}dθ of both torques."""
        gas_cosine = gas_sine = inertia_cosine = inertia_sine = 0.0
        for angle, gas, inertia in self.weighted:
            cosine, sine = math.cos(order * angle), -math.sin(order * angle)
            gas_cosine += gas * cosine
            gas_sine += gas * sine
            inertia_cosine += inertia * cosine
            inertia_sine += inertia * sine
        part = 2.0 / cycle
        return Phasor(part * gas_cosine, part * gas_sine), Phasor(part * inertia_cosine, part * inertia_sine)

    def _weighted(self) -> "list[tuple[float, float, float]]":
        """Angles of a quadrature over the cycle, with both torques times their weights."""
        places = []
        for (low, first), (high, second) in pairwise(self.points):
            panels = math.ceil((high - low) / PANEL)
            for panel, (node, weight) in product(range(panels), legendre(NODES)):
                share = (panel + node) / panels
                gas, inertia = self.torques(low + share * (high - low), first + share * (second - first))
                width = weight * (high - low) / panels
                places.append((low + share * (high - low), width * gas, width * inertia))
        return places


def _order(order: float, waves: "Waves") -> TorqueOrder:
    turned = [(wave, _turned(order, angles)) for wave, angles in waves]
    # the masses are alike, so that their torques may cancel where pressures do not
    inertia = waves[0][0][1] * _turned(order, [at for _, angles in waves for at in angles])
    gas = total(wave[0] * turn for wave, turn in turned)
    both = gas + inertia
    first = waves[0][0]
    return TorqueOrder(
        order=order,
        torque=both.size,
        phase=both.angle if both.size > 0.0 else None,
        gas=gas.size,
        inertia=inertia.size,
        single=(first[0] + first[1]).size,
    )


def _turned(order: float, angles: "list[float]") -> Phasor:
    turn = total(polar(1.0, -order * angle) for angle in angles)
    return turn if turn.size > CANCELLED * len(angles) else Phasor(0.0, 0.0)


def _extreme(table: "list[TorquePoint]", sign: float) -> TorquePoint:
    """The row of the largest torque of a sense; of equal ones, as of cylinders that fire evenly, the first."""
    top = max(sign * row.torque for row in table)
    return next(row for row in table if sign * row.torque >= top - CANCELLED * abs(top))


def _table(alike: "list[tuple[_Cylinder, list[float]]]", cycle: float, count: int) -> "list[TorquePoint]":
    rows = []
    for angle in (cycle * k / count for k in range(count)):
        parts = [cylinder.at(angle - fires, cycle) for cylinder, angles in alike for fires in angles]
        gas, inertia = (math.fsum(part[i] for part in parts) for i in range(2))
        rows.append(TorquePoint(angle, gas + inertia, gas, inertia))
    return [*rows, TorquePoint(cycle, rows[0].torque, rows[0].gas, rows[0].inertia)]
