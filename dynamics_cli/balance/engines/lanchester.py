"""Lanchester's balancer: two shafts turning at an order's speed against each other."""

from dynamics_cli.balance.engines.crank import CrankRadius, Stroke, order_factor, require_rod
from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.quantities import Annotated, BalanceMass, Count, Force, Mass, Ratio, ShaftSpeed, Size, Unbalance
from dynamics_cli.records import record


@record
class Lanchester:
    """The two shafts of an in-line engine."""

    force: Annotated[Force, "Largest force of the order that the shafts take away [N]."]
    shaft_speed: Annotated[ShaftSpeed, "Speed of each shaft [rad/s]."]
    shaft_unbalance: Annotated[Unbalance, "Unbalance of each shaft [kg·m]."]
    shaft_force: Annotated[Force, "Rotating force of each shaft on its bearings [N]."]
    shaft_mass: Annotated[BalanceMass | None, "Mass of each shaft's weight at the radius given [kg]."]


def lanchester(
    *,
    reciprocating_mass: Annotated[Mass, "Piston, pin and small-end share of the rod, of one cylinder, e.g. 0.5 kg."],
    crank: Annotated[CrankRadius | Stroke, "Crank radius, or stroke."],
    rod_length: Annotated[Size, "Between the centres of the rod's eyes, e.g. 172 mm."],
    speed: Annotated[ShaftSpeed, "Speed of the crankshaft, e.g. 6000 rpm."],
    cylinders: Annotated[Count, "Cylinders whose forces of the order add up."] = 4,
    order: Annotated[Count, "The order to balance, an even number."] = 2,
    weight_radius: Annotated[Size | None, "Radius of the centre of mass of each shaft's weight, e.g. 15 mm."] = None,
) -> Lanchester:
    """Two shafts that take the force of an even order away from an in-line engine.

    Equation
    --------
    F = z·|A_n|·m·r·ω², U = F/(2·n²·ω²) for each shaft; at A₂ and four cylinders U = m·r·A₂/2.

    Returns
    -------
    Lanchester
        Force, speed, unbalance and mass of each shaft.

    Raises
    ------
    InadmissibleError
        When the order is odd, there is no cylinder or no speed, or the crank is too long for the rod.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 15.6.

    Notes
    -----
    The weights are down when a piston of the first cylinder is on top.

    Examples
    --------
    >>> made = lanchester(reciprocating_mass=0.5, crank=CrankRadius(0.043), rod_length=0.172, speed=628.3185307179587)
    >>> round(made.shaft_unbalance * 1e6, 4)
    2730.7692
    """
    require(
        (order >= 2) and (order <= 40) and order % 2 == 0,
        "order {order} has no two-shaft balancer: a piston has even orders from 2 on",
        code="order",
        hint="order 1 is balanced by counterweights and one shaft: dynamics balance engine shows them",
        order=str(order),
    )
    require(cylinders >= 1, "an engine has at least one cylinder", code="cylinders")
    require(absolute(speed) > 0.0, "an engine at rest has no inertia force", code="at-rest")
    require(rod_length > 0.0, "the rod has no length", code="rod")
    require(weight_radius is None or weight_radius > 0.0, "a weight at the axis balances nothing", code="no-radius")
    ratio: Ratio = crank.radius / rod_length
    require_rod(ratio)
    each = cylinders * absolute(order_factor(ratio, order)) * reciprocating_mass * crank.radius
    unbalance = 0.5 * each / (order * order)
    return Lanchester(
        force=each * speed * speed,
        shaft_speed=order * speed,
        shaft_unbalance=unbalance,
        shaft_force=0.5 * each * speed * speed,
        shaft_mass=None if weight_radius is None else unbalance / weight_radius,
    )
