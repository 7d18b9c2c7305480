"""Yaw moment of inertia of a road vehicle, estimated by named published rules, with their scatter."""

from dynamics_cli.errors import require
from dynamics_cli.impact.conventions import ByMass, ByWeight, mass_of
from dynamics_cli.impact.diagnostics import not_above, plain, require_sizes, single
from dynamics_cli.numerics.elementary import maximum, minimum, sqrt
from dynamics_cli.quantities import STANDARD_GRAVITY, Distance, Gravity, Inertia, Length, Mass, Text
from dynamics_cli.records import Advice, Check, Choice, record

BURG = 0.1269
# Dynamic index k²/(ab) of passenger cars.
LOW_INDEX, HIGH_INDEX = 0.7, 1.1


class InertiaRule(Choice):
    """Which rule gives the estimate: Burg's product, the dynamic index one, a uniform rectangle, or their mean."""

    names = ("mean", "burg", "dynamic-index", "rectangle")


MEAN = InertiaRule("mean")


@record
class RuleEstimate:
    """What one rule gives.

    Parameters
    ----------
    rule : Text
        Its name and formula.
    yaw_inertia : Inertia
        Yaw moment of inertia [kg·m²].
    """

    rule: Text
    yaw_inertia: Inertia


@record
class YawInertia:
    """An estimate and its scatter.

    Parameters
    ----------
    yaw_inertia : Inertia
        Yaw moment of inertia about the mass centre, by the rule asked for [kg·m²].
    lowest : Inertia
        Lowest of all rules that apply [kg·m²].
    highest : Inertia
        Highest of all rules that apply [kg·m²].
    radius_of_gyration : Length
        √(J/m) [m].
    mass : Mass
        Mass of the vehicle [kg].
    rules : tuple[RuleEstimate, ...]
        What every rule gives for which the sizes are known.
    """

    yaw_inertia: Inertia
    lowest: Inertia
    highest: Inertia
    radius_of_gyration: Length
    mass: Mass
    rules: tuple[RuleEstimate, ...]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def yaw_inertia(
    *,
    bulk: ByMass | ByWeight,
    wheelbase: Distance,
    length: Distance | None = None,
    width: Distance | None = None,
    front_distance: Distance | None = None,
    rule: InertiaRule = MEAN,
    gravity: Gravity = STANDARD_GRAVITY,
) -> YawInertia:
    """Yaw moment of inertia of a vehicle from mass, wheelbase, length and width: an estimate, with the rules' scatter.

    Equation
    --------
    Burg: J = 0.1269 m L R; dynamic index: J = i m a b with i = 0.7…1.1, 1 for the estimate; rectangle: m (L² + B²)/12.

    Parameters
    ----------
    bulk : ByMass | ByWeight
        Mass or weight of the vehicle.
    wheelbase : Distance
        Wheelbase R [m].
    length : Distance
        Overall length L [m].
    width : Distance
        Overall width B [m].
    front_distance : Distance
        Distance a of the mass centre behind the front axle; half the wheelbase when left out [m].
    rule : InertiaRule
        Which rule gives the estimate; the mean of those that apply unless it is named.
    gravity : Gravity
        Acceleration of gravity, for a vehicle given by weight [m/s^2].

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
    require(wheelbase > 0.0, "a wheelbase of {0:.6g} m is none", wheelbase, code="no-size")
    front = 0.5 * wheelbase if front_distance is None else front_distance
    rear = wheelbase - front
    require(
        (front > 0.0) & (rear > 0.0),
        "a mass centre {0:.6g} m behind the front axle is not within a wheelbase of {1:.6g} m",
        front,
        wheelbase,
        code="mass-centre",
    )
    found = {"dynamic-index": mass * front * rear}
    words = {"dynamic-index": "dynamic index 1: m a b"}
    if length is not None:
        _require_length(length, wheelbase)
        found["burg"] = BURG * mass * length * wheelbase
        words["burg"] = "Burg: 0.1269 m L R"
        if width is not None:
            require(width > 0.0, "a width of {0:.6g} m is none", width, code="no-size")
            found["rectangle"] = mass * (length * length + width * width) / 12.0
            words["rectangle"] = "uniform rectangle: m (L² + B²)/12"
    require(
        rule == "mean" or rule in found,
        f"the rule {rule} needs sizes that are missing",
        code="missing-size",
        hint="burg needs --length, rectangle --length and --width",
    )
    names = [name for name in ("burg", "dynamic-index", "rectangle") if name in found]
    total = found[names[0]]
    lowest, highest = LOW_INDEX * found["dynamic-index"], HIGH_INDEX * found["dynamic-index"]
    for name in names[1:]:
        total = total + found[name]
    for name in names:
        lowest, highest = minimum(lowest, found[name]), maximum(highest, found[name])
    estimate = total / float(len(names)) if rule == "mean" else found[rule]
    return YawInertia(
        yaw_inertia=estimate,
        lowest=lowest,
        highest=highest,
        radius_of_gyration=sqrt(estimate / mass),
        mass=mass,
        rules=tuple(RuleEstimate(words[name], found[name]) for name in names),
        checks=not_above("within the rules", lowest, estimate, estimate)
        + not_above("within the rules from above", estimate, highest, highest),
        advice=_advice(estimate, lowest, highest),
    )


def _require_length(length: float, wheelbase: float) -> None:
    require(
        length > wheelbase,
        "a vehicle of {0:.6g} m is not longer than its wheelbase {1:.6g} m",
        length,
        wheelbase,
        code="length",
        hint="check that length and wheelbase are not exchanged",
    )


def _advice(estimate: float, lowest: float, highest: float) -> tuple[Advice, ...]:
    if not single(estimate, lowest, highest):
        return ()
    below = 100.0 * (1.0 - plain(lowest) / plain(estimate))
    above = 100.0 * (plain(highest) / plain(estimate) - 1.0)
    return (
        Advice(
            code="estimate",
            message=f"an estimate, no measurement: the rules reach from {below:.2g} % below to {above:.2g} % above it",
            severity="note",
            mend="use a measured value where there is one",
        ),
    )
