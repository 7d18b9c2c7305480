"""The law of a call, by name or custom, and the check that its derivatives are consistent."""

from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.normalised import Law, law_named
from dynamics_cli.errors import require
from dynamics_cli.quantities import (
    Annotated,
    Fraction,
    Ratio,
)
from dynamics_cli.records import Check, record


@record
class Condition:
    """A condition of a polynomial law at one place, in units of the rise: place 0 to 1, lift 0 to 1."""

    place: Annotated[Fraction, "Share of the span."]
    lift: Annotated[Ratio | None, "Share of the lift."] = None
    velocity: Annotated[Ratio | None, "First derivative by the share of the span."] = None
    acceleration: Annotated[Ratio | None, "Second derivative."] = None
    jerk: Annotated[Ratio | None, "Third derivative."] = None
    rate_of_jerk: Annotated[Ratio | None, "Fourth derivative."] = None


@record
class SplinePoint:
    """A point a spline law goes through, in units of the rise."""

    place: Annotated[Fraction, "Share of the span."]
    lift: Annotated[Ratio, "Share of the lift."]


def chosen(
    name: LawName,
    shares: "tuple[float, ...]",
    constant: float | None,
    conditions: "tuple[Condition, ...]",
    points: "tuple[SplinePoint, ...]",
    start_velocity: float = 0.0,
    end_velocity: float = 0.0,
) -> Law:
    """Give the law of a name, with its particular data: shares, conditions or points.

    `shares`: shares of scca; `constant`: share at constant velocity; `conditions`: what a polynomial meets; `points`:
    what a spline goes through; `start_velocity`, `end_velocity`: slopes of a spline at its ends. Raises
    InadmissibleError when something belongs to another law, or is missing.
    """
    require(name == "polynomial" or not conditions, "the law {name} takes no conditions", name=name, code="law")
    require(name == "spline" or not points, "the law {name} takes no points", name=name, code="law")
    require(
        name == "spline" or (start_velocity == 0.0 and end_velocity == 0.0),
        "the law {name} has fixed velocities at its ends",
        name=name,
        code="law",
        hint="take a polynomial with conditions",
    )
    if name == "polynomial":
        from dynamics_cli.cam.laws.polynomials import polynomial

        require(bool(conditions), "a polynomial needs conditions", code="conditions", hint=CONDITION_HINT)
        return polynomial([row for condition in conditions for row in _conditions(condition)])
    if name == "spline":
        from dynamics_cli.cam.laws.polynomials import spline
        from dynamics_cli.cam.laws.rounded_points import decimal_step

        inner = [(point.place, point.lift) for point in points]
        steps = decimal_step([x for x, _ in inner]), decimal_step([f for _, f in inner])
        return spline([(0.0, 0.0), *inner, (1.0, 1.0)], start_velocity, end_velocity, steps)
    return law_named(name, shares or None, constant)


CONDITION_HINT = 'for example --condition "place=0, lift=0, velocity=0" --condition "place=1, lift=1, velocity=0"'


def _conditions(condition: Condition) -> "list[tuple[float, int, float]]":
    values = (condition.lift, condition.velocity, condition.acceleration, condition.jerk, condition.rate_of_jerk)
    conditions = [(condition.place, order, value) for order, value in enumerate(values) if value is not None]
    require(
        bool(conditions),
        "the condition at {place} gives no lift and no derivative",
        place=(condition.place, Fraction), code="conditions", hint=CONDITION_HINT,
    )  # fmt: skip
    return conditions


def area_checks(law: Law) -> "tuple[Check, ...]":
    """The areas under velocity and acceleration, by Gauss's rule, are lift and gain of velocity."""
    if "areas" not in law.known:
        law.known["areas"] = _area_checks(law)
    return law.known["areas"]  # type: ignore[no-any-return]


def _area_checks(law: Law) -> "tuple[Check, ...]":
    area = [0.0, 0.0]
    travel = size = 0.0
    for piece in law.pieces:
        start, end = piece.ends
        half = 0.5 * (end - start)
        for node, weight in GAUSS:
            for t in (start + half * (1.0 - node), start + half * (1.0 + node)):
                orders = law.upright(piece, t, 2)
                area = [area[0] + weight * half * orders[1], area[1] + weight * half * orders[2]]
                travel += weight * half * abs(orders[1])
                size += weight * half * abs(orders[2])
    gain = law.at(1.0, 1, -1)[1] - law.at(0.0, 1)[1]
    # a law that returns to its start has zero lift: its size is the total distance covered
    scale = max(abs(law.total) if law.monotone else max(abs(law.total), travel), 1e-300)
    worst = max(abs(area[0] - law.total) / scale, abs(area[1] - gain) / max(size, 1e-300) if size else 0.0)
    return (Check(f"areas under {law.name}", worst <= 1e-12, worst, 1e-12),)


# Abscissae and weights of Gauss's rule of 16 points, the positive half.
GAUSS = (
    (0.09501250983763744, 0.1894506104550685), (0.2816035507792589, 0.18260341504492358),
    (0.45801677765722737, 0.16915651939500254), (0.6178762444026438, 0.14959598881657674),
    (0.755404408355003, 0.12462897125553388), (0.8656312023878318, 0.09515851168249279),
    (0.9445750230732326, 0.06225352393864789), (0.9894009349916499, 0.027152459411754095),
)  # fmt: skip
