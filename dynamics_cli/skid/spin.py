"""Spin: the speed lost by a rotating vehicle after an impact, by tyre drag that grows with the slip angle."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import hypot, multiply_add, sin, sqrt, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.drag import drag_advice, drag_along, require_drag
from dynamics_cli.numerics.road.slide import crossing_time
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    AngularSpeed,
    Annotated,
    Distance,
    DragFactor,
    Fraction,
    Friction,
    Gravity,
    RoadSpeed,
    Slope,
    Time,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.skid.diagnostics import DEGREES, balance

# π as the sum of two doubles, so that whole half-turns are taken off without loss.
HALF_TURN = 3.141592653589793
HALF_TURN_REST = 1.2246467991473532e-16


@record
class Rotation:
    """Drag from the rotation of the vehicle along its path."""

    rotation: Annotated[Angle, "Angle the vehicle turned through, whole turns included [rad]."]
    start_angle: Annotated[
        Angle, "Angle between heading and path at the start, in the sense of the rotation [rad]."
    ] = 0.0
    rolling_drag: Annotated[
        Fraction,
        "Share of the full friction when the vehicle points along its path: near 0 when they roll, 1 when locked [-].",
    ] = 0.0

    @property
    def share(self) -> float:
        """Mean share of the full friction over the rotation."""
        return self.rolling_drag + (1.0 - self.rolling_drag) * mean_across(self.start_angle, self.rotation)


@record
class Share:
    """Drag given as a share of the full friction."""

    drag_share: Annotated[Fraction, "Mean share of the full friction over the distance [-]."]

    @property
    def share(self) -> float:
        """Mean share of the full friction."""
        return self.drag_share


@record
class SpinLoss:
    """Speed at the start of a spin, and the loss."""

    speed: Annotated[RoadSpeed, "Speed of the mass centre where the spin begins [m/s]."]
    speed_lost: Annotated[RoadSpeed, "Speed lost over the distance [m/s]."]
    mean_share: Annotated[Fraction, "Mean share of the full friction that dragged [-]."]
    drag_factor: Annotated[DragFactor, "Mean deceleration along the path over gravity [-]."]
    time: Annotated[Time, "Time of the spin [s]."]
    mean_yaw_rate: Annotated[AngularSpeed | None, "Rotation over time; needs the rotation [rad/s]."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def mean_across(start: float, rotation: float) -> float:
    """Mean of |sin ψ| for ψ from `start` through `rotation`, by whole half-turns and a rest without cancellation."""
    turns = plain(rotation) // HALF_TURN
    rest = _beyond(rotation, turns)
    before = plain(start) // HALF_TURN
    # the start lies `begun` beyond a zero of the sine and `to_go` before the next one
    begun, to_go = _beyond(start, before), -_beyond(start, before + 1.0)
    to_go = where(begun < 0.0, -begun, to_go)
    begun = where(begun < 0.0, begun + HALF_TURN, begun)
    middle = where(begun <= 0.5 * HALF_TURN, begun + 0.5 * rest, to_go - 0.5 * rest)
    inside = 2.0 * sin(middle) * sin(0.5 * rest)
    falling, rising = sin(0.5 * to_go), sin(0.5 * (rest - to_go))
    across = 2.0 * (falling * falling + rising * rising)
    return (2.0 * turns + where(rest <= to_go, inside, across)) / rotation


def _beyond(angle: float, turns: float) -> float:
    """The remainder of an angle beyond whole half-turns."""
    return multiply_add(-turns, HALF_TURN, angle) - turns * HALF_TURN_REST


def spin(
    *,
    drag: Annotated[
        Rotation | Share, "The rotation from which the mean share of friction follows, or that share itself."
    ],
    distance: Annotated[Distance, "Length of the path of the mass centre during the spin [m]."],
    friction: Annotated[Friction, "Coefficient of friction of a tyre sliding sideways [-]."],
    end_speed: Annotated[RoadSpeed, "Speed where the spin ends [m/s]."] = 0.0,
    grade: Annotated[Slope, "Rise over run of the road in the direction of the path, uphill positive [-]."] = 0.0,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> SpinLoss:
    """Speed that a vehicle spinning after an impact had, from its distance and the partial drag of its turning tyres.

    Equation
    --------
    v² = v_e² + 2 g f d, f = (kμ + G)/√(1 + G²); k = r + (1 − r)·mean |sin ψ| over the rotation, r the rolling drag.

    Returns
    -------
    SpinLoss
        The speed at the start, the speed lost, the mean share and drag factor, time and mean yaw rate.

    Raises
    ------
    InadmissibleError
        When the rotation or its distance is zero, or the drag factor is not above zero.

    Notes
    -----
    Model "mean sine of the slip angle": a tyre at slip angle ψ drags with the share r + (1 − r)|sin ψ| of the full
    friction, and the vehicle turns uniformly along its path. Tyres are taken as sliding at once, so for rotations of
    a few degrees from straight ahead, where a tyre still grips, the model does not hold; it is meant for spins of a
    quarter turn and more. The energy of rotation is neglected: it is small beside that of translation.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10 (work and energy); the partial
    drag of a rotating vehicle as commonly used in accident reconstruction.

    Examples
    --------
    >>> round(spin(drag=Rotation(rotation=3.141592653589793), distance=20.0, friction=0.7).speed, 4)
    13.2215
    """
    rate: float | None = None
    if isinstance(drag, Rotation):
        require(
            drag.rotation > 0.0,
            "the rotation of a spin must be more than zero, not {rotation}: it counts in the direction of the spin",
            code="no-rotation",
            hint="give drag-share instead when the vehicle did not turn",
            rotation=(drag.rotation, Angle),
        )
        require(distance > 0.0, "the distance of a spin must be more than zero", code="no-way")
    braking = drag.share
    factor = require_drag(drag_along(friction, grade, braking))
    shed = 2.0 * gravity * (factor * distance)
    speed = hypot(end_speed, sqrt(shed))
    time = crossing_time(distance, speed, end_speed)
    if isinstance(drag, Rotation):
        rate = drag.rotation / time
    speed_sum = speed + end_speed
    # crossing_time has refused speeds that underflowed, so both are zero only without a distance
    lost = shed / where(speed_sum > 0.0, speed_sum, 1.0)
    return SpinLoss(
        speed=speed,
        speed_lost=lost,
        mean_share=braking,
        drag_factor=factor,
        time=time,
        mean_yaw_rate=rate,
        checks=balance(
            "energy balance", lost * (2.0 * end_speed + lost), shed, speed * speed, speed, factor, distance, gravity
        ),
        advice=drag_advice(friction, grade, braking) + _turn_advice(drag),
    )


def _turn_advice(drag: Rotation | Share) -> tuple[Advice, ...]:
    if not isinstance(drag, Rotation) or not single(drag.rotation, drag.start_angle):
        return ()
    if plain(drag.rotation) * DEGREES >= 45.0:
        return ()
    message = worded(
        "a rotation of {turned:3} is short for a mean: near straight ahead tyres still grip",
        turned=(drag.rotation, Angle),
    )
    remedy = "give drag-share, or take the rotation over the whole spin"
    return (Advice(code="short-rotation", message=message, remedy=remedy),)
