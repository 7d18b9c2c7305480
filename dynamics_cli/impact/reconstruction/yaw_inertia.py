"""Yaw moment of inertia of a road vehicle, estimated by named published rules, with their scatter."""

from dynamics_cli.errors import (
    require,
    worded,
)
from dynamics_cli.impact.conventions import ByMass, ByWeight, mass_of
from dynamics_cli.impact.diagnostics import not_above, require_sizes
from dynamics_cli.numerics.elementary import maximum, minimum, sqrt
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Annotated,
    Distance,
    Fraction,
    Gravity,
    Inertia,
    Length,
    Mass,
    Text,
)
from dynamics_cli.records import Advice, Check, Choice, record

BURG = 0.1269
# Dynamic index k²/(ab) of passenger cars.
LOW_INDEX, HIGH_INDEX = 0.7, 1.1


class InertiaRule(Choice):
    """Rule of the estimate: Burg's product, the dynamic index one, a uniform rectangle, or their mean."""

    names = ("mean", "burg", "dynamic-index", "rectangle")


MEAN = InertiaRule("mean")


@record
class RuleEstimate:
    """The estimate of one rule."""

    rule: Annotated[Text, "Its name and formula."]
    yaw_inertia: Annotated[Inertia, "Yaw moment of inertia [kg·m²]."]


@record
class YawInertia:
    """An estimate and its scatter."""

    yaw_inertia: Annotated[Inertia, "Yaw moment of inertia about the mass centre, by the rule asked for [kg·m²]."]
    lowest: Annotated[Inertia, "Lowest of all rules that apply [kg·m²]."]
    highest: Annotated[Inertia, "Highest of all rules that apply [kg·m²]."]
    radius_of_gyration: Annotated[Length, "√(J/m) [m]."]
    mass: Annotated[Mass, "Mass of the vehicle [kg]."]
    rules: Annotated[tuple[RuleEstimate, ...], "The estimate of every rule whose sizes are known."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def yaw_inertia(
    *,
    bulk: Annotated[ByMass | ByWeight, "Mass or weight of the vehicle."],
    wheelbase: Annotated[Distance, "Wheelbase R, e.g. 2.7 m [m]."],
    length: Annotated[Distance | None, "Overall length L, e.g. 4.6 m [m]."] = None,
    width: Annotated[Distance | None, "Overall width B, e.g. 1.8 m [m]."] = None,
    front_distance: Annotated[
        Distance | None,
        "Distance a of the mass centre behind the front axle; half the wheelbase when left out, e.g. 1.2 m [m].",
    ] = None,
    rule: Annotated[InertiaRule, "Rule of the estimate; the mean of all that apply if left out."] = MEAN,
    gravity: Annotated[Gravity, "Acceleration of gravity, for a vehicle given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> YawInertia:
    """Yaw moment of inertia of a vehicle from mass, wheelbase, length and width: an estimate, with the rules' scatter.

    Equation
    --------
    Burg: J = 0.1269 m L R; dynamic index: J = i m a b with i = 0.7…1.1, 1 for the estimate; rectangle: m (L² + B²)/12.

    Returns
    -------
    YawInertia
        The estimate, the lowest and highest value of all rules, the radius of gyration, and each rule's value.

    Raises
    ------
    InadmissibleError
        When a size is zero, the mass centre is outside the wheelbase, or a rule's sizes are missing.

    Notes
    -----
    Rules for passenger cars without load; measured values scatter by some 10 to 20 % about any of them. The range of
    the dynamic index counts towards lowest and highest.

    References
    ----------
    Burg's formula as commonly used in reconstruction programs; dynamic index k²/(ab) ≈ 0.7 to 1.1 as commonly
    published in vehicle dynamics; parallel axes for the rectangle.

    Examples
    --------
    >>> round(yaw_inertia(bulk=ByMass(1500.0), wheelbase=2.7, length=4.6, width=1.8).yaw_inertia, 1)
    2716.0
    """
    require_sizes(
        bulk=bulk, wheelbase=wheelbase, length=length, width=width, front_distance=front_distance, gravity=gravity
    )
    mass = mass_of(bulk, gravity, "the vehicle")
    require(wheelbase > 0.0, "the wheelbase must be above zero", code="no-size")
    front = 0.5 * wheelbase if front_distance is None else front_distance
    rear = wheelbase - front
    require(
        (front > 0.0) & (rear > 0.0),
        "a mass centre {front:6} behind the front axle is not within a wheelbase of {wheelbase:6}",
        front=(front, Distance),
        wheelbase=(wheelbase, Distance),
        code="mass-centre",
    )
    estimates = {"dynamic-index": mass * front * rear}
    labels = {"dynamic-index": "dynamic index 1: m a b"}
    if length is not None:
        _require_length(length, wheelbase)
        estimates["burg"] = BURG * mass * length * wheelbase
        labels["burg"] = "Burg: 0.1269 m L R"
        if width is not None:
            require(width > 0.0, "the width must be above zero", code="no-size")
            estimates["rectangle"] = mass * (length * length + width * width) / 12.0
            labels["rectangle"] = "uniform rectangle: m (L² + B²)/12"
    require(
        rule == "mean" or rule in estimates,
        "the rule {rule} needs sizes that are missing",
        rule=str(rule),
        code="missing-size",
        hint="burg needs --length, rectangle --length and --width",
    )
    names = [name for name in ("burg", "dynamic-index", "rectangle") if name in estimates]
    total = estimates[names[0]]
    lowest, highest = LOW_INDEX * estimates["dynamic-index"], HIGH_INDEX * estimates["dynamic-index"]
    for name in names[1:]:
        total = total + estimates[name]
    for name in names:
        lowest, highest = minimum(lowest, estimates[name]), maximum(highest, estimates[name])
    estimate = total / float(len(names)) if rule == "mean" else estimates[rule]
    return YawInertia(
        yaw_inertia=estimate,
        lowest=lowest,
        highest=highest,
        radius_of_gyration=sqrt(estimate / mass),
        mass=mass,
        rules=tuple(RuleEstimate(labels[name], estimates[name]) for name in names),
        checks=not_above("within the rules", lowest, estimate, estimate)
        + not_above("within the rules from above", estimate, highest, highest),
        advice=_advice(estimate, lowest, highest),
    )


def _require_length(length: float, wheelbase: float) -> None:
    require(
        length > wheelbase,
        "a vehicle of {length:6} is not longer than its wheelbase {wheelbase:6}",
        length=(length, Distance),
        wheelbase=(wheelbase, Distance),
        code="length",
        hint="check that length and wheelbase are not exchanged",
    )


def _advice(estimate: float, lowest: float, highest: float) -> tuple[Advice, ...]:
    if not single(estimate, lowest, highest):
        return ()
    text = worded(
        "an estimate, not a measurement: the rules reach from {below:2} below to {above:2} above it",
        below=(1.0 - plain(lowest) / plain(estimate), Fraction),
        above=(plain(highest) / plain(estimate) - 1.0, Fraction),
    )
    message = text
    remedy = "use a measured value where there is one"
    return (Advice(code="estimate", message=message, severity="note", remedy=remedy),)
