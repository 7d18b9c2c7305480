"""A rolling wheel that meets a step: what the impact on the edge leaves, and the least speed to get over."""

from dynamics_cli.errors import require
from dynamics_cli.impact.diagnostics import balance, not_above, plain, require_sizes, single
from dynamics_cli.numerics.elementary import sqrt, where
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    AngularSpeed,
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
    """A wheel by how its mass is spread.

    Parameters
    ----------
    inertia_factor : Positive
        Moment of inertia about the axle over m r²: 0.5 for a uniform disk, 1 for a hoop, 0.4 for a ball [-].
    """

    inertia_factor: Positive = 0.5


DISK = Factor()


@record
class AxleInertia:
    """A wheel by its moment of inertia.

    Parameters
    ----------
    axle_inertia : Inertia
        Moment of inertia about the axle; needs the mass [kg·m²].
    """

    axle_inertia: Inertia


@record
class StepMet:
    """What a step does to a rolling wheel.

    Parameters
    ----------
    least_speed : Speed
        Least rolling speed that takes the wheel over the step [m/s].
    angular_ratio : Ratio
        Angular velocity after the impact over that before [-].
    share_lost : Ratio
        Share of the kinetic energy lost in the impact [-].
    leaves_edge_speed : Speed
        Rolling speed above which the wheel jumps off the edge at once [m/s].
    angular_velocity : AngularSpeed
        Angular velocity before; needs the speed [rad/s].
    angular_velocity_after : AngularSpeed
        Angular velocity about the edge just after; needs the speed [rad/s].
    centre_speed_after : Speed
        Speed of the centre just after; needs the speed [m/s].
    gets_over : bool
        Whether the wheel gets over; needs the speed.
    speed_on_step : Speed
        Rolling speed on the step, when it gets over and stays on the edge [m/s].
    greatest_rise : Size
        How far the centre rises when it does not get over [m].
    energy_lost : Energy
        Energy lost in the impact; needs speed and mass [J].
    impulse_forward : Impulse
        Impulse of the edge along the road, against the motion when negative; needs speed and mass [N·s].
    impulse_upward : Impulse
        Impulse of the edge upwards; needs speed and mass [N·s].
    """

    least_speed: Speed
    angular_ratio: Ratio
    share_lost: Ratio
    leaves_edge_speed: Speed
    angular_velocity: AngularSpeed | None
    angular_velocity_after: AngularSpeed | None
    centre_speed_after: Speed | None
    gets_over: bool | None
    speed_on_step: Speed | None
    greatest_rise: Size | None
    energy_lost: Energy | None
    impulse_forward: Impulse | None
    impulse_upward: Impulse | None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def step(
    *,
    radius: Size,
    height: Size,
    wheel: Factor | AxleInertia = DISK,
    speed: Speed | None = None,
    mass: Mass | None = None,
    gravity: Gravity = STANDARD_GRAVITY,
) -> StepMet:
    """A wheel that rolls against a step: angular momentum about the edge in the impact, energy on the way up.

    Equation
    --------
    ω'/ω = (κ + 1 − h/r)/(κ + 1), ½(κ + 1) r² ω'² ≥ g h; v_least = √(2 g h (κ + 1))/(κ + 1 − h/r), κ = J/(m r²).

    Parameters
    ----------
    radius : Size
        Radius of the wheel [m].
    height : Size
        Height of the step [m].
    wheel : Factor | AxleInertia
        How the mass of the wheel is spread: a uniform disk unless it says otherwise.
    speed : Speed
        Rolling speed before the step; without it the least speed alone is answered [m/s].
    mass : Mass
        Mass of the wheel; wanted for energy and impulses, and with a moment of inertia [kg].
    gravity : Gravity
        Acceleration of gravity [m/s^2].

    Returns
    -------
    StepMet
        Least speed, angular velocities, energy lost, impulses, and what becomes of the wheel.

    Raises
    ------
    InadmissibleError
        When the wheel has no radius, the step is no lower than the axle, a moment of inertia comes without mass, or the
        wheel does not roll towards the step.

    Notes
    -----
    The wheel rolls without slip; the edge does not give way, and the wheel neither rebounds from it nor slips on it.
    Shares lost and speeds left are factored, never differences of energies.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.11.

    Examples
    --------
    >>> round(step(radius=0.3, height=0.1).least_speed, 6)
    1.470192
    """
    require_sizes(radius=radius, height=height, wheel=wheel, speed=speed, mass=mass, gravity=gravity)
    require(radius > 0.0, "a wheel of radius {0:.6g} m does not roll", radius, code="no-radius")
    require(height > 0.0, "a step of {0:.6g} m is none: the wheel rolls on", height, code="no-impact")
    require(
        height < radius,
        "a step of {0:.6g} m is not lower than the axle at {1:.6g} m: the wheel meets a wall",
        height,
        radius,
        code="wall",
    )
    factor = _factor(wheel, mass, radius)
    whole = 1.0 + factor
    depth = height / radius
    kept = whole - depth
    ratio = kept / whole
    share = depth * (2.0 * whole - depth) / (whole * whole)
    least = sqrt(2.0 * gravity * height * whole) / kept
    leaves = sqrt(gravity * (radius - height)) / ratio
    advice = _never_stays(least, leaves)
    if speed is None:
        return StepMet(least, ratio, share, leaves, None, None, None, None, None, None, None, None, None, (), advice)
    require(speed > 0.0, "a speed of {0:.6g} m/s does not bring the wheel to the step", speed, code="no-impact")
    spin = speed / radius
    after = ratio * spin
    over = speed >= least
    left = where(over, (speed - least) * (speed + least), 0.0)
    down = where(over, 0.0, ratio * speed * (ratio * speed) * whole / (2.0 * gravity))
    advice += _jump(speed, leaves)
    answer = StepMet(
        least_speed=least,
        angular_ratio=ratio,
        share_lost=share,
        leaves_edge_speed=leaves,
        angular_velocity=spin,
        angular_velocity_after=after,
        centre_speed_after=ratio * speed,
        gets_over=over,
        speed_on_step=ratio * sqrt(left),
        greatest_rise=down,
        energy_lost=None if mass is None else 0.5 * mass * whole * speed * speed * share,
        impulse_forward=None if mass is None else -mass * speed * (depth * (1.0 + whole - depth) / whole),
        impulse_upward=None if mass is None else mass * speed * ratio * sqrt(depth * (2.0 - depth)),
        advice=advice,
    )
    return StepMet(**{**answer.__dict__, "checks": _checks(answer, factor, speed, depth, mass)})


def _factor(wheel: Factor | AxleInertia, mass: float | None, radius: float) -> float:
    if isinstance(wheel, Factor):
        return wheel.inertia_factor
    require(mass is not None, "a moment of inertia needs the mass beside it", code="no-mass", hint="give --mass")
    assert mass is not None
    require(mass > 0.0, "a wheel of {0:.6g} kg has no weight to lift", mass, code="no-mass")
    return wheel.axle_inertia / (mass * radius * radius)


def _never_stays(least: float, leaves: float) -> tuple[Advice, ...]:
    if not single(least, leaves) or plain(least) <= plain(leaves):
        return ()
    return (
        Advice(
            code="leaves-edge",
            message=f"at the least speed the wheel would already leave the edge (above {plain(leaves):.4g} m/s): "
            "it cannot climb this step by pivoting on the edge without something that holds it there",
            severity="caution",
        ),
    )


def _jump(speed: float, leaves: float) -> tuple[Advice, ...]:
    if not single(speed, leaves) or plain(speed) <= plain(leaves):
        return ()
    return (
        Advice(
            code="jumps",
            message=f"at {plain(speed):.4g} m/s the wheel leaves the edge at once (above {plain(leaves):.4g} m/s): the "
            "speed on the step is that of a wheel held to the edge",
        ),
    )


def _checks(answer: StepMet, factor: float, speed: float, depth: float, mass: float | None) -> tuple[Check, ...]:
    """Angular momentum about the edge, energy, and the impulse's moment about the axle, per mass."""
    ratio = answer.angular_ratio
    whole = 1.0 + factor
    checks = balance("angular momentum about the edge", factor + (1.0 - depth), whole * ratio, whole)
    checks += balance("energy", whole * (1.0 - ratio * ratio), whole * answer.share_lost, whole)
    checks += not_above("energy never gained", ratio, 1.0, 1.0)
    if mass is None or answer.impulse_forward is None or answer.impulse_upward is None:
        return checks
    side = sqrt(depth * (2.0 - depth))
    moment = answer.impulse_forward * (1.0 - depth) + answer.impulse_upward * side
    size = mass * speed
    return checks + balance("moment of the impulse about the axle", moment, factor * (depth / whole) * size, size)
