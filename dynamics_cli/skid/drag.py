"""Drag factor: deceleration over gravity, from a surface, from unequally braked axles or from a drag sled."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import absolute, cos, multiply_add, sin
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.drag import (
    along_the_road,
    drag_advice,
    drag_along,
    friction_advice,
    grade_advice,
    require_drag,
    secant,
)
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Angle,
    Annotated,
    Distance,
    DragFactor,
    Force,
    Fraction,
    Friction,
    Gravity,
    Slope,
    Weight,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.skid.diagnostics import balance, split_product

RIGHT_ANGLE = 1.5707963267948966


@record
class Surface:
    """A vehicle braking equally on all wheels."""

    friction: Annotated[Friction, "Coefficient of friction between tyre and road [-]."]
    grade: Annotated[Slope, "Rise over run of the road in the direction of travel, uphill positive [-]."] = 0.0
    braking: Annotated[
        Fraction, "Share of the full friction that the brakes use, 1 when all wheels are locked [-]."
    ] = 1.0

    @property
    def effective_friction(self) -> float:
        """Retarding force over normal force."""
        return self.braking * self.friction

    @property
    def drag(self) -> float:
        """Deceleration over gravity."""
        return drag_along(self.friction, self.grade, self.braking)


@record
class Axles:
    """A two-axle vehicle whose axles brake unequally, with the weight that braking shifts to the front."""

    front_friction: Annotated[Friction, "Coefficient of friction at the front axle [-]."]
    rear_friction: Annotated[Friction, "Coefficient of friction at the rear axle [-]."]
    wheelbase: Annotated[Distance, "Distance between the axles, e.g. 2.7 m [m]."]
    cm_position: Annotated[Distance, "Distance of the mass centre behind the front axle, e.g. 1.2 m [m]."]
    cm_height: Annotated[Distance, "Height of the mass centre above the road, e.g. 0.55 m [m]."]
    front_braking: Annotated[Fraction, "Share of the friction used by the front axle, 0 when unbraked [-]."] = 1.0
    rear_braking: Annotated[Fraction, "Share of the friction used by the rear axle, 0 when unbraked [-]."] = 1.0
    grade: Annotated[Slope, "Rise over run of the road in the direction of travel, uphill positive [-]."] = 0.0

    @property
    def loads(self) -> tuple[float, float, float]:
        """Front and rear moments that carry the load, and their sum; the shares are first/sum and second/sum."""
        front = self.wheelbase - self.cm_position
        front_moment = multiply_add(self.cm_height, self.rear_braking * self.rear_friction, front)
        # near lift-off the rear's is a small difference: the rounding of the friction is made good
        grip, rest = split_product(self.front_braking, self.front_friction)
        rear_moment = multiply_add(-self.cm_height, grip, self.cm_position) - self.cm_height * rest
        return front_moment, rear_moment, front_moment + rear_moment

    @property
    def effective_friction(self) -> float:
        """Retarding force over normal force."""
        front = self.wheelbase - self.cm_position
        grip = self.front_braking * self.front_friction * front
        return (grip + self.rear_braking * self.rear_friction * self.cm_position) / self.loads[2]

    @property
    def drag(self) -> float:
        """Deceleration over gravity."""
        return along_the_road(self.effective_friction, self.grade)


@record
class Sled:
    """A drag sled pulled at constant speed in the direction the vehicle went."""

    pull: Annotated[Force, "Force that keeps the sled sliding [N]."]
    weight: Annotated[Weight, "Weight of the sled [N]."]
    pull_angle: Annotated[Angle, "Angle of the pull above the road surface [rad]."] = 0.0
    grade: Annotated[Slope, "Rise over run of the road in the direction of the pull, uphill positive [-]."] = 0.0

    @property
    def pressing(self) -> float:
        """Normal force times 1/cos θ [N]."""
        return self.weight - self.pull * sin(self.pull_angle) * secant(self.grade)

    @property
    def effective_friction(self) -> float:
        """Retarding force over normal force."""
        along = self.pull * cos(self.pull_angle) * secant(self.grade)
        return (along - self.weight * self.grade) / self.pressing

    @property
    def drag(self) -> float:
        """Deceleration over gravity: the pull's horizontal part over the normal force's vertical one."""
        return self.pull * (cos(self.pull_angle) - self.grade * sin(self.pull_angle)) / self.pressing


@record
class DragFactors:
    """A drag factor and its origin."""

    drag_factor: Annotated[DragFactor, "Deceleration along the road over gravity [-]."]
    deceleration: Annotated[Acceleration, "Deceleration along the road [m/s^2]."]
    effective_friction: Annotated[Friction, "Retarding force of the tyres over the load on the road [-]."]
    front_share: Annotated[Fraction | None, "Share of the load on the front axle while braking [-]."] = None
    rear_share: Annotated[Fraction | None, "Share of the load on the rear axle while braking [-]."] = None
    weight_transfer: Annotated[
        Fraction | None, "Share of the load that braking moves from the rear axle to the front one [-]."
    ] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def drag_factor(
    *,
    measurement: Annotated[
        Surface | Axles | Sled,
        "What the drag factor is known from: friction, grade and braking; two axles; or a drag sled's pull and weight.",
    ],
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> DragFactors:
    """Drag factor of a braking vehicle, from its surface, from its axles or from a drag sled.

    Equation
    --------
    f = (ημ + G)/√(1 + G²). Axles: ημ becomes (μ_f b + μ_r a)/(b + hμ_r + a − hμ_f), with the mass centre a behind the
    front axle, b = wheelbase − a ahead of the rear one and h above the road.
    Sled: f = P(cos α − G sin α)/(W − P sin α √(1 + G²)).

    Returns
    -------
    DragFactors
        The drag factor, the deceleration, and the loads on the axles.

    Raises
    ------
    InadmissibleError
        When drag is not above zero, when the mass centre is not between the axles, when braking lifts the rear axle,
        or when the pull lifts the sled or is less than the grade's share of its weight.

    Notes
    -----
    Axles by statics in the braking vehicle's frame: N_f + N_r = W cos θ across the road, and about the mass centre
    a N_f − b N_r = h(μ_f N_f + μ_r N_r). Suspension travel, air drag and the wheels' rotary inertia are left out.
    Every denominator is a sum of terms that are positive wherever both axles press on the road, so nothing cancels
    but ημ + G itself.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10 (skidding) and
    chapter 6 (force systems).

    Examples
    --------
    >>> round(drag_factor(measurement=Surface(friction=0.7, grade=-0.03)).drag_factor, 4)
    0.6697
    """
    if isinstance(measurement, Axles):
        _require_standing(measurement)
    elif isinstance(measurement, Sled):
        _require_dragged(measurement)
    drag = require_drag(measurement.drag)
    friction = measurement.effective_friction
    front_share: float | None = None
    rear_share: float | None = None
    transfer: float | None = None
    if isinstance(measurement, Axles):
        front, rear, total = measurement.loads
        front_share, rear_share = front / total, rear / total
        transfer = measurement.cm_height * friction / measurement.wheelbase
    checks, advice = _examine(measurement, friction)
    return DragFactors(
        drag_factor=drag,
        deceleration=gravity * drag,
        effective_friction=friction,
        front_share=front_share,
        rear_share=rear_share,
        weight_transfer=transfer,
        checks=checks,
        advice=advice,
    )


def _examine(measurement: Surface | Axles | Sled, friction: float) -> tuple[tuple[Check, ...], tuple[Advice, ...]]:
    """Check the statics by another equation than the one that was solved."""
    if isinstance(measurement, Axles):
        front, rear, total = measurement.loads
        behind = rear * (measurement.wheelbase - measurement.cm_position) + measurement.cm_height * friction * total
        ahead = front * measurement.cm_position
        checks = balance(
            "moments about the mass centre",
            ahead,
            behind,
            measurement.wheelbase * total,
            measurement.wheelbase,
            measurement.cm_position,
            measurement.cm_height,
            friction,
        )
        absurd = friction_advice(measurement.front_friction, "front friction")
        absurd += friction_advice(measurement.rear_friction, "rear friction") + grade_advice(measurement.grade)
        return checks, absurd + _light_rear(rear / total)
    if isinstance(measurement, Sled):
        fall = measurement.weight * measurement.grade
        friction_moment = friction * measurement.pressing
        along = measurement.pull * cos(measurement.pull_angle) * secant(measurement.grade)
        checks = balance(
            "forces along the road",
            along,
            fall + friction_moment,
            absolute(fall) + along,
            measurement.pull,
            measurement.weight,
            measurement.grade,
        )
        advice = friction_advice(friction, "the friction found", "check pull, weight and their units")
        return checks, advice + grade_advice(measurement.grade)
    return (), drag_advice(measurement.friction, measurement.grade, measurement.braking)


def _require_standing(axles: Axles) -> None:
    require(
        (axles.cm_position > 0.0) & (axles.cm_position < axles.wheelbase),
        "the mass centre, {position} behind the front axle, is not between axles {wheelbase} apart",
        code="mass-centre",
        position=(axles.cm_position, Distance),
        wheelbase=(axles.wheelbase, Distance),
    )
    require(
        axles.loads[1] >= 0.0,
        "braking lifts the rear axle: friction of {friction} at the front times the height {height} of the mass centre "
        "exceeds its distance {position} behind the front axle",
        code="axle-lifts",
        friction=(axles.front_braking * axles.front_friction, Friction),
        height=(axles.cm_height, Distance),
        position=(axles.cm_position, Distance),
    )


def _light_rear(share: float) -> tuple[Advice, ...]:
    if not single(share) or plain(share) >= 0.1:
        return ()
    message = worded("only {share:3} of the load stays on the rear axle", share=(share, Fraction))
    return (Advice(code="light-rear-axle", message=message, remedy="check the height of the mass centre"),)


def _require_dragged(sled: Sled) -> None:
    require(
        absolute(sled.pull_angle) < RIGHT_ANGLE,
        "the sled must be pulled along the road, not at {angle} to it",
        code="pull-angle",
        angle=(sled.pull_angle, Angle),
    )
    require(
        sled.pressing > 0.0,
        "the pull lifts the sled: it leaves {load} of its weight on the road",
        code="sled-lifts",
        load=(sled.pressing, Force),
    )
    require(
        sled.effective_friction >= 0.0,
        "the pull is less than the grade's share of the weight: friction would be {friction}",
        code="negative-friction",
        friction=(sled.effective_friction, Friction),
    )
