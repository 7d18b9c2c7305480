"""The ballistic pendulum: speed of a shot from the swing of the body it strikes."""

from dynamics_cli.errors import require
from dynamics_cli.impact.conventions import ByMass, ByWeight, mass_of
from dynamics_cli.impact.diagnostics import balance, not_above, require_finite, require_sizes
from dynamics_cli.numerics.elementary import absolute, hypot, sin, sqrt
from dynamics_cli.numerics.number import is_array
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    AngularSpeed,
    Annotated,
    Distance,
    Energy,
    Gravity,
    Impulse,
    Inertia,
    Mass,
    Ratio,
    Restitution,
    Size,
    Speed,
)
from dynamics_cli.records import Check, record

PI = 3.141592653589793


@record
class Rise:
    """Rise of the block."""

    rise: Annotated[Size, "Rise of the mass centre of the pendulum, e.g. 10 cm [m]."]


@record
class Swing:
    """Swing of the block on its cords."""

    swing: Annotated[Angle, "Greatest angle of swing, e.g. 18 deg [rad]."]
    length: Annotated[Distance, "Length of the cords, to the mass centre of the pendulum, e.g. 1.2 m [m]."]

    @property
    def rise(self) -> float:
        """L(1 − cos θ) without cancellation."""
        half = sin(0.5 * self.swing)
        return 2.0 * self.length * half * half


@record
class Sideways:
    """Sideways movement of the block."""

    travel: Annotated[Size, "Greatest horizontal travel of the mass centre, e.g. 350 mm [m]."]
    length: Annotated[Distance, "Length of the cords, to the mass centre of the pendulum, e.g. 1.2 m [m]."]

    @property
    def rise(self) -> float:
        """L − √(L² − x²) without cancellation."""
        require(self.length > 0.0, "the length of the cords must be above zero", code="no-length")
        require(
            self.travel <= self.length,
            "cords of {length:6} do not let the block travel {travel:6} sideways",
            length=(self.length, Distance),
            travel=(self.travel, Distance),
            code="too-far",
        )
        share = self.travel / self.length
        return self.travel * share / (1.0 + sqrt((1.0 - share) * (1.0 + share)))


@record
class Hinged:
    """A rigid pendulum on a hinge."""

    swing: Annotated[Angle, "Greatest angle of swing, e.g. 18 deg [rad]."]
    inertia: Annotated[
        Inertia, "Moment of inertia of the pendulum about the hinge, without the shot, e.g. 1.1 kg*m^2 [kg·m²]."
    ]
    centre_distance: Annotated[Distance, "Distance of its mass centre from the hinge, e.g. 0.55 m [m]."]
    impact_distance: Annotated[Distance, "Distance of the place it is struck from the hinge, e.g. 0.6 m [m]."]


@record
class Shot:
    """Speed of the shot and results of the impact."""

    speed: Annotated[Speed, "Speed of the shot before [m/s]."]
    pendulum_speed: Annotated[Speed, "Speed of the struck place just after [m/s]."]
    shot_speed_after: Annotated[
        Speed, "Speed of the shot just after: that of the place it struck when it stays in it [m/s]."
    ]
    angular_velocity: Annotated[AngularSpeed | None, "Angular velocity just after, of a hinged pendulum [rad/s]."]
    rise: Annotated[Size, "Rise of the mass centre of the pendulum, e.g. 10 cm [m]."]
    impulse: Annotated[Impulse, "Impulse on the pendulum [N·s]."]
    hinge_impulse: Annotated[
        Impulse | None,
        "Impulse at the hinge, against the shot when positive; none when struck at the centre of percussion [N·s].",
    ]
    effective_mass: Annotated[Mass, "Mass of the pendulum as the shot feels it [kg]."]
    energy_before: Annotated[Energy, "Kinetic energy of the shot [J]."]
    energy_lost: Annotated[Energy, "Energy lost in the impact [J]."]
    share_lost: Annotated[Ratio, "The same over the energy before [-]."]
    checks: tuple[Check, ...] = ()


@record
class Block:
    """The block that hangs and is struck."""

    bulk: Annotated[ByMass | ByWeight, "Its mass or its weight, without the shot."]


def pendulum(
    *,
    shot_mass: Annotated[Mass, "Mass of the shot, e.g. 10 g [kg]."],
    block: Annotated[Block, "The block or pendulum that is struck."],
    swing: Annotated[
        Rise | Swing | Sideways | Hinged,
        "Its swing: rise, angle and length, sideways travel and length, or angle of a hinged body.",
    ],
    restitution: Annotated[
        Restitution, "Coefficient of restitution: 0 when the shot stays in the block, above when it bounces off [-]."
    ] = 0.0,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Shot:
    """Speed of a shot from the swing of the ballistic pendulum that it strikes: momentum in the impact, energy after.

    Equation
    --------
    V = √(2gh), v = V (m + M)/((1 + e) m); hinged: M is J/b², V = b ω, ½(J + mb²)ω² = (Md + mb) g (1 − cos θ).

    Returns
    -------
    Shot
        Speed of the shot, speeds after, impulse, energy lost.

    Raises
    ------
    InadmissibleError
        When a mass is zero, the pendulum does not swing or swings over the top, or the shot strikes the hinge.

    Notes
    -----
    The shot strikes a pendulum at rest, horizontally and perpendicular to it; the impact is over before the pendulum
    has moved. A shot that bounces off does not swing along.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 9.10 and 10.5.

    Examples
    --------
    >>> round(pendulum(shot_mass=0.01, block=Block(ByMass(2.0)), swing=Rise(0.1)).speed, 6)
    281.495459
    """
    require_sizes(shot_mass=shot_mass, block=block, swing=swing, restitution=restitution, gravity=gravity)
    mass = mass_of(block.bulk, gravity, "the block")
    require(shot_mass > 0.0, "the mass of the shot must be above zero", code="no-mass")
    if isinstance(swing, Hinged):
        return _hinged(shot_mass, mass, swing, restitution, gravity)
    if isinstance(swing, Swing):
        _require_swing(swing.swing)
    rise = swing.rise
    require(rise > 0.0, "the rise of the block must be above zero", code="no-impact")
    speed = sqrt(2.0 * gravity * rise)
    return _shot(shot_mass, mass, speed, restitution, rise, None)


def _require_swing(swing: float) -> None:
    require(
        (absolute(swing) > 0.0) & (absolute(swing) < PI),
        "an angle of swing of {swing:6} is zero or over the top",
        swing=(swing, Angle),
        code="swing",
        hint="the angle lies between 0 and 180 degrees",
    )


def _hinged(shot: float, mass: float, swing: Hinged, restitution: float, gravity: float) -> Shot:
    _require_swing(swing.swing)
    arm = swing.impact_distance
    require(arm > 0.0, "the shot must strike at a distance from the hinge above zero", code="no-arm")
    require(
        (swing.inertia > 0.0) & (swing.centre_distance > 0.0),
        "moment of inertia and distance of the mass centre must be above zero",
        code="no-pendulum",
    )
    require(
        swing.inertia >= mass * (swing.centre_distance * swing.centre_distance) * (1.0 - 1e-12),
        "a moment of inertia of {inertia:6} about the hinge is less than that of the mass centre alone",
        inertia=(swing.inertia, Inertia),
        code="inertia",
        hint="give the moment about the hinge, not about the mass centre",
    )
    # a shot that stays swings along; one that bounces off does not
    along = restitution == 0.0
    stays = (1.0 if along else 0.0) if not is_array(along) else 1.0 * along
    inertia = swing.inertia + stays * (shot * arm * arm)
    lift = mass * swing.centre_distance + stays * (shot * arm)
    half = absolute(sin(0.5 * swing.swing))
    spin = 2.0 * half * sqrt(gravity * lift / inertia)
    rise = 2.0 * half * half * lift / (mass + stays * shot)
    effective = swing.inertia / (arm * arm)
    answer = _shot(shot, effective, arm * spin, restitution, rise, spin)
    hinge = answer.impulse - mass * swing.centre_distance * spin
    return Shot(**{**answer.__dict__, "hinge_impulse": hinge})


def _shot(shot: float, mass: float, speed: float, restitution: float, rise: float, spin: float | None) -> Shot:
    """The impact of shot and (effective) mass, from the speed of the struck body after it."""
    total = shot + mass
    before = speed * (total / shot) / (1.0 + restitution)
    require_finite(before * before * shot, "the energy of the shot")
    impulse = mass * speed
    after = before * ((shot - restitution * mass) / total)
    kinetic = 0.5 * shot * before * before
    share = (1.0 - restitution) * (1.0 + restitution) * (mass / total)
    lost = kinetic * share
    size = shot * before + impulse
    left = 0.5 * shot * after * after + 0.5 * mass * speed * speed
    checks = balance("momentum", shot * before, shot * after + mass * speed, size)
    checks += balance("restitution", speed - after, restitution * before, hypot(speed, before))
    checks += balance("energy", kinetic - left, lost, kinetic)
    checks += not_above("no energy is gained", left, kinetic, kinetic)
    return Shot(
        speed=before,
        pendulum_speed=speed,
        shot_speed_after=after,
        angular_velocity=spin,
        rise=rise,
        impulse=impulse,
        hinge_impulse=None,
        effective_mass=mass,
        energy_before=kinetic,
        energy_lost=lost,
        share_lost=share,
        checks=checks,
    )
