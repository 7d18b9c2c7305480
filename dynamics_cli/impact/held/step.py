"""A rolling wheel that meets a step: motion after the impact on the edge, and the minimum speed to get over it."""

from dynamics_cli.errors import (
    require,
    require_given,
    worded,
)
from dynamics_cli.impact.diagnostics import balance, not_above, require_sizes
from dynamics_cli.numerics.elementary import sqrt, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    AngularSpeed,
    Annotated,
    Distance,
    Energy,
    Gravity,
    Impulse,
    Inertia,
    Mass,
    Positive,
    Ratio,
    Size,
    Speed,
)
from dynamics_cli.records import Advice, Check, record


@record
class Factor:
    """A wheel by the distribution of its mass."""

    inertia_factor: Annotated[
        Positive,
        "Moment of inertia about the axle over m r²: 0.5 for a uniform disk, 1 for a hoop, 0.4 for a ball [-].",
    ] = 0.5


DISK = Factor()


@record
class AxleInertia:
    """A wheel by its moment of inertia."""

    axle_inertia: Annotated[Inertia, "Moment of inertia about the axle; needs the mass, e.g. 0.5 kg*m^2 [kg·m²]."]


@record
class StepMet:
    """Results of a rolling wheel that meets a step."""

    least_speed: Annotated[Speed, "Least rolling speed that takes the wheel over the step [m/s]."]
    angular_ratio: Annotated[Ratio, "Angular velocity after the impact over that before [-]."]
    share_lost: Annotated[Ratio, "Share of the kinetic energy lost in the impact [-]."]
    leaves_edge_speed: Annotated[Speed, "Rolling speed above which the wheel jumps off the edge at once [m/s]."]
    angular_velocity: Annotated[AngularSpeed | None, "Angular velocity before; needs the speed [rad/s]."]
    angular_velocity_after: Annotated[
        AngularSpeed | None, "Angular velocity about the edge just after; needs the speed [rad/s]."
    ]
    centre_speed_after: Annotated[Speed | None, "Speed of the centre just after; needs the speed [m/s]."]
    gets_over: Annotated[bool | None, "Whether the wheel gets over; needs the speed."]
    speed_on_step: Annotated[Speed | None, "Rolling speed on the step, when it gets over and stays on the edge [m/s]."]
    greatest_rise: Annotated[Size | None, "How far the centre rises when it does not get over [m]."]
    energy_lost: Annotated[Energy | None, "Energy lost in the impact; needs speed and mass [J]."]
    impulse_forward: Annotated[
        Impulse | None,
        "Impulse of the edge along the road, against the motion when negative; needs speed and mass [N·s].",
    ]
    impulse_upward: Annotated[Impulse | None, "Impulse of the edge upwards; needs speed and mass [N·s]."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def step(
    *,
    radius: Annotated[Size, "Radius of the wheel, e.g. 300 mm [m]."],
    height: Annotated[Size, "Height of the step, e.g. 100 mm [m]."],
    wheel: Annotated[Factor | AxleInertia, "Distribution of the wheel's mass; a uniform disk if left out."] = DISK,
    speed: Annotated[
        Speed | None,
        "Rolling speed before the step; without it only the minimum speed is calculated, e.g. 6 km/h [m/s].",
    ] = None,
    mass: Annotated[
        Mass | None, "Mass of the wheel; needed for energy and impulses, and with a moment of inertia, e.g. 18 kg [kg]."
    ] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> StepMet:
    """A wheel that rolls against a step: angular momentum about the edge in the impact, then energy while climbing.

    Equation
    --------
    ω'/ω = (κ + 1 − h/r)/(κ + 1), ½(κ + 1) r² ω'² ≥ g h; v_least = √(2 g h (κ + 1))/(κ + 1 − h/r), κ = J/(m r²).

    Returns
    -------
    StepMet
        Minimum speed, angular velocities, energy lost, impulses, and whether the wheel gets over.

    Raises
    ------
    InadmissibleError
        When the wheel has no radius, the step is no lower than the axle, a moment of inertia comes without mass, or the
        wheel does not roll towards the step.

    Notes
    -----
    The wheel rolls without slip; the edge does not give way, and the wheel neither rebounds from it nor slips on it.
    Energy shares and speeds are factored, never differences of energies.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.11.

    Examples
    --------
    >>> round(step(radius=0.3, height=0.1).least_speed, 6)
    1.470192
    """
    require_sizes(radius=radius, height=height, wheel=wheel, speed=speed, mass=mass, gravity=gravity)
    require(radius > 0.0, "the radius of the wheel must be above zero", code="no-radius")
    require(height > 0.0, "the height of the step must be above zero", code="no-impact")
    require(
        height < radius,
        "a step of {height:6} is not lower than the axle at {radius:6}: the wheel meets a wall",
        height=(height, Distance),
        radius=(radius, Distance),
        code="wall",
    )
    factor = _factor(wheel, mass, radius)
    radius_factor = 1.0 + factor
    depth = height / radius
    retained = radius_factor - depth
    ratio = retained / radius_factor
    lost = depth * (2.0 * radius_factor - depth) / (radius_factor * radius_factor)
    least = sqrt(2.0 * gravity * height * radius_factor) / retained
    leaves = sqrt(gravity * (radius - height)) / ratio
    advice = _never_stays(least, leaves)
    if speed is None:
        return StepMet(least, ratio, lost, leaves, None, None, None, None, None, None, None, None, None, (), advice)
    require(speed > 0.0, "the speed of the wheel must be above zero", code="no-impact")
    spin = speed / radius
    after = ratio * spin
    over = speed >= least
    square_left = where(over, (speed - least) * (speed + least), 0.0)
    down = where(over, 0.0, ratio * speed * (ratio * speed) * radius_factor / (2.0 * gravity))
    advice += _jump(speed, leaves)
    answer = StepMet(
        least_speed=least,
        angular_ratio=ratio,
        share_lost=lost,
        leaves_edge_speed=leaves,
        angular_velocity=spin,
        angular_velocity_after=after,
        centre_speed_after=ratio * speed,
        gets_over=over,
        speed_on_step=ratio * sqrt(square_left),
        greatest_rise=down,
        energy_lost=None if mass is None else 0.5 * mass * radius_factor * speed * speed * lost,
        impulse_forward=None
        if mass is None
        else -mass * speed * (depth * (1.0 + radius_factor - depth) / radius_factor),
        impulse_upward=None if mass is None else mass * speed * ratio * sqrt(depth * (2.0 - depth)),
        advice=advice,
    )
    return StepMet(**{**answer.__dict__, "checks": _checks(answer, factor, speed, depth, mass)})


def _factor(wheel: Factor | AxleInertia, mass: float | None, radius: float) -> float:
    if isinstance(wheel, Factor):
        return wheel.inertia_factor
    require_given(mass is not None, "a moment of inertia needs the mass as well", ("mass",), code="no-mass")
    assert mass is not None
    require(mass > 0.0, "the mass of the wheel must be above zero", code="no-mass")
    return wheel.axle_inertia / (mass * radius * radius)


def _never_stays(least: float, leaves: float) -> tuple[Advice, ...]:
    if not single(least, leaves) or plain(least) <= plain(leaves):
        return ()
    message = worded(
        "at the minimum speed the wheel would already leave the edge (above {leaves}): it can climb this step "
        "by pivoting on the edge only if something holds it there",
        leaves=(leaves, Speed),
    )
    return (Advice(code="leaves-edge", message=message, severity="caution"),)


def _jump(speed: float, leaves: float) -> tuple[Advice, ...]:
    if not single(speed, leaves) or plain(speed) <= plain(leaves):
        return ()
    message = worded(
        "at {speed} the wheel leaves the edge at once (above {leaves}): the speed on the step is that of a "
        "wheel held to the edge",
        speed=(speed, Speed),
        leaves=(leaves, Speed),
    )
    return (Advice(code="jumps", message=message),)


def _checks(answer: StepMet, factor: float, speed: float, depth: float, mass: float | None) -> tuple[Check, ...]:
    """Angular momentum about the edge, energy, and the impulse's moment about the axle, per mass."""
    ratio = answer.angular_ratio
    radius_factor = 1.0 + factor
    checks = balance("angular momentum about the edge", factor + (1.0 - depth), radius_factor * ratio, radius_factor)
    checks += balance("energy", radius_factor * (1.0 - ratio * ratio), radius_factor * answer.share_lost, radius_factor)
    checks += not_above("no energy is gained", ratio, 1.0, 1.0)
    if mass is None or answer.impulse_forward is None or answer.impulse_upward is None:
        return checks
    side = sqrt(depth * (2.0 - depth))
    moment = answer.impulse_forward * (1.0 - depth) + answer.impulse_upward * side
    size = mass * speed
    return checks + balance(
        "moment of the impulse about the axle", moment, factor * (depth / radius_factor) * size, size
    )
