"""What a planar impact reports."""

from dynamics_cli.impact.bodies import Pair, Solid, cross, travel_of
from dynamics_cli.impact.conventions import Axes, Conventions, DeltaV, PdofZero, delta_v, heading_of
from dynamics_cli.numerics.elementary import hypot
from dynamics_cli.quantities import (
    Angle,
    AngularImpulse,
    AngularSpeed,
    Energy,
    Force,
    Impulse,
    PlanarImpulse,
    PlanarVelocity,
    Ratio,
    RoadSpeed,
    RoadVelocity,
    Text,
    Time,
)
from dynamics_cli.records import Advice, Check, record


@record
class AfterPlanar:
    """One body after a planar impact.

    Parameters
    ----------
    velocity : PlanarVelocity
        Velocity of the mass centre after [m/s].
    speed : RoadSpeed
        Its size [m/s].
    heading : Angle
        Direction of travel after [rad].
    spin : AngularSpeed
        Angular velocity after [rad/s].
    spin_change : AngularSpeed
        Change of the angular velocity, from the moment of the impulse over the inertia [rad/s].
    delta_v : DeltaV
        Change of velocity, from the impulse over the mass; none of a fixed body.
    energy_change : Energy
        Change of its kinetic energy; of a fixed body, the work done on it [J].
    """

    velocity: PlanarVelocity
    speed: RoadSpeed
    heading: Angle
    spin: AngularSpeed
    spin_change: AngularSpeed
    delta_v: DeltaV | None
    energy_change: Energy


@record
class Critical:
    """Impulse ratios that decide about slip.

    Parameters
    ----------
    impulse_ratio : Ratio
        p_t/p_n that would just stop the slip at the end with u_n' = −e u_n (Brach's critical ratio), signed [-].
    share : Ratio
        Friction over its size [-].
    stick_friction : Ratio
        Friction that holds the contact once slip has stopped, |k_x|/k_t [-].
    """

    impulse_ratio: Ratio | None
    share: Ratio | None
    stick_friction: Ratio


@record
class Alternative:
    """The same impact by one law.

    Parameters
    ----------
    normal_impulse : Impulse
        Normal impulse [N·s].
    tangential_impulse : Impulse
        Tangential impulse [N·s].
    impulse_ratio : Ratio
        Tangential over normal impulse [-].
    first_delta_v : RoadSpeed
        ΔV of the first body [m/s].
    second_delta_v : RoadSpeed
        ΔV of the second body [m/s].
    first_spin : AngularSpeed
        Spin of the first body after [rad/s].
    second_spin : AngularSpeed
        Spin of the second body after [rad/s].
    separation_speed : RoadVelocity
        Normal relative speed after [m/s].
    sliding_after : RoadVelocity
        Tangential relative speed after [m/s].
    energy_lost : Energy
        Kinetic energy lost [J].
    slip_history : Text
        What the contact did.
    """

    normal_impulse: Impulse
    tangential_impulse: Impulse
    impulse_ratio: Ratio
    first_delta_v: RoadSpeed | None
    second_delta_v: RoadSpeed | None
    first_spin: AngularSpeed
    second_spin: AngularSpeed
    separation_speed: RoadVelocity
    sliding_after: RoadVelocity
    energy_lost: Energy
    slip_history: Text


@record
class PlanarImpact:
    """What a planar impact did.

    Parameters
    ----------
    first : AfterPlanar
        The first body.
    second : AfterPlanar
        The second body.
    law : Text
        The law these results are by.
    slip_history : Text
        What the contact did: slip; slip, stick; slip, reversed slip; …
    impulse : PlanarImpulse
        Impulse on the second body along the axes of the scene; the first gets the opposite [N·s].
    impulse_magnitude : Impulse
        Its size [N·s].
    normal_impulse : Impulse
        Its part along the normal [N·s].
    tangential_impulse : Impulse
        Its part along the tangent, a quarter turn from the normal from x towards y [N·s].
    moment_impulse : AngularImpulse
        Moment impulse at the contact on the second body, with Brach's moment restitution [N·m·s].
    impulse_direction : Angle
        Direction of the impulse on the second body [rad].
    impulse_ratio : Ratio
        Tangential over normal impulse [-].
    critical : Critical
        The ratios that decide about slip.
    compression_impulse : Impulse
        Normal impulse until the greatest compression [N·s].
    slip_impulse : Impulse
        Normal impulse until the first slip stopped, or all of it when it never did [N·s].
    closing_speed : RoadSpeed
        Normal relative speed at the contact before [m/s].
    separation_speed : RoadVelocity
        Normal relative speed at the contact after [m/s].
    sliding_before : RoadVelocity
        Tangential velocity of the first body relative to the second at the contact before, along the tangent [m/s].
    sliding_after : RoadVelocity
        The same after [m/s].
    energy_lost : Energy
        Kinetic energy turned into other forms [J].
    energy_lost_normal : Energy
        The part the normal impulse took [J].
    energy_lost_tangential : Energy
        The part friction took [J].
    energy_lost_moment : Energy
        The part the moment impulse took [J].
    conventions : Conventions
        Axes, headings and the zero of PDOF.
    duration : Time
        Time in contact, where its stiffness is given [s].
    peak_force : Force
        Greatest normal force, where the stiffness is given [N].
    stronge : Alternative
        The impact by Stronge's law, where all laws were asked for.
    newton : Alternative
        By Newton's law.
    poisson : Alternative
        By Poisson's law.
    brach : Alternative
        By Brach's impulse ratio.
    kudlich_slibar : Alternative
        By Kudlich and Slibar.
    """

    first: AfterPlanar
    second: AfterPlanar
    law: Text
    slip_history: Text
    impulse: PlanarImpulse
    impulse_magnitude: Impulse
    normal_impulse: Impulse
    tangential_impulse: Impulse
    moment_impulse: AngularImpulse | None
    impulse_direction: Angle
    impulse_ratio: Ratio
    critical: Critical
    compression_impulse: Impulse | None
    slip_impulse: Impulse | None
    closing_speed: RoadSpeed
    separation_speed: RoadVelocity
    sliding_before: RoadVelocity
    sliding_after: RoadVelocity
    energy_lost: Energy
    energy_lost_normal: Energy
    energy_lost_tangential: Energy
    energy_lost_moment: Energy | None
    conventions: Conventions
    duration: Time | None = None
    peak_force: Force | None = None
    stronge: Alternative | None = None
    newton: Alternative | None = None
    poisson: Alternative | None = None
    brach: Alternative | None = None
    kudlich_slibar: Alternative | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def after_impact(body: Solid, impulse: Pair, moment: float | None, axes: Axes, zero: PdofZero) -> AfterPlanar:
    """State of one body after its impulse at the lever, and a moment impulse."""
    change: DeltaV | None = None
    after, half, turned = body.velocity, (0.0, 0.0), 0.0
    twist: float = 0.0 if moment is None else moment
    if body.mass is not None and body.inertia is not None:
        travel = travel_of(body.velocity, axes)
        change = delta_v(impulse, body.mass, body.nose, axes=axes, pdof_zero=zero, travel=travel)
        x, y = change.vector
        twist = cross(body.lever, impulse) + twist
        turned = twist / body.inertia
        after, half = (body.velocity[0] + x, body.velocity[1] + y), (0.5 * x, 0.5 * y)
    else:
        twist = cross(body.lever, impulse) + twist
    work = impulse[0] * (body.velocity[0] + half[0]) + impulse[1] * (body.velocity[1] + half[1])
    return AfterPlanar(
        velocity=after,
        speed=hypot(after[0], after[1]),
        heading=heading_of(after[0], after[1], axes),
        spin=body.spin + turned,
        spin_change=turned,
        delta_v=change,
        energy_change=work + twist * (body.spin + 0.5 * turned),
    )
