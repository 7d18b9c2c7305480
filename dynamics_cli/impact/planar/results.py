"""Results of a planar impact, body by body."""

from dynamics_cli.impact.conventions import Axes, Conventions, DeltaV, PdofZero, delta_v, heading_of, travel_of
from dynamics_cli.impact.planar.bodies import Pair, Solid
from dynamics_cli.numerics.elementary import hypot
from dynamics_cli.numerics.vectors import planar_cross as cross
from dynamics_cli.quantities import (
    Angle,
    AngularImpulse,
    AngularSpeed,
    Annotated,
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
    """One body after a planar impact."""

    velocity: Annotated[PlanarVelocity, "Velocity of the mass centre after [m/s]."]
    speed: Annotated[RoadSpeed, "Its size [m/s]."]
    heading: Annotated[Angle, "Direction of travel after [rad]."]
    spin: Annotated[AngularSpeed, "Angular velocity after [rad/s]."]
    spin_change: Annotated[
        AngularSpeed, "Change of the angular velocity, from the moment of the impulse over the inertia [rad/s]."
    ]
    delta_v: Annotated[DeltaV | None, "Change of velocity, from the impulse over the mass; none of a fixed body."]
    energy_change: Annotated[Energy, "Change of its kinetic energy; of a fixed body, the work done on it [J]."]


@record
class Critical:
    """Impulse ratios that decide about slip."""

    impulse_ratio: Annotated[
        Ratio | None,
        "p_t/p_n that would just stop the slip at the end with u_n' = −e u_n (Brach's critical ratio), signed [-].",
    ]
    share: Annotated[Ratio | None, "Friction over its size [-]."]
    stick_friction: Annotated[Ratio, "Friction that holds the contact once slip has stopped, |k_x|/k_t [-]."]


@record
class Alternative:
    """The same impact by one law."""

    normal_impulse: Annotated[Impulse, "Normal impulse [N·s]."]
    tangential_impulse: Annotated[Impulse, "Tangential impulse [N·s]."]
    impulse_ratio: Annotated[Ratio, "Tangential over normal impulse [-]."]
    first_delta_v: Annotated[RoadSpeed | None, "ΔV of the first body [m/s]."]
    second_delta_v: Annotated[RoadSpeed | None, "ΔV of the second body [m/s]."]
    first_spin: Annotated[AngularSpeed, "Spin of the first body after [rad/s]."]
    second_spin: Annotated[AngularSpeed, "Spin of the second body after [rad/s]."]
    separation_speed: Annotated[RoadVelocity, "Normal relative speed after [m/s]."]
    sliding_after: Annotated[RoadVelocity, "Tangential relative speed after [m/s]."]
    energy_lost: Annotated[Energy, "Kinetic energy lost [J]."]
    slip_history: Annotated[Text, "History of the contact."]


@record
class PlanarImpact:
    """Results of a planar impact."""

    first: Annotated[AfterPlanar, "The first body."]
    second: Annotated[AfterPlanar, "The second body."]
    law: Annotated[Text, "The law of these results."]
    slip_history: Annotated[Text, "History of the contact: slip; slip, stick; slip, reversed slip; …"]
    impulse: Annotated[
        PlanarImpulse, "Impulse on the second body along the axes of the scene; the first gets the opposite [N·s]."
    ]
    impulse_magnitude: Annotated[Impulse, "Its size [N·s]."]
    normal_impulse: Annotated[Impulse, "Its part along the normal [N·s]."]
    tangential_impulse: Annotated[
        Impulse, "Its part along the tangent, a quarter turn from the normal from x towards y [N·s]."
    ]
    moment_impulse: Annotated[
        AngularImpulse | None,
        "Moment impulse at the contact on the second body, with Brach's moment restitution [N·m·s].",
    ]
    impulse_direction: Annotated[Angle, "Direction of the impulse on the second body [rad]."]
    impulse_ratio: Annotated[Ratio, "Tangential over normal impulse [-]."]
    critical: Annotated[Critical, "The ratios that decide about slip."]
    compression_impulse: Annotated[Impulse | None, "Normal impulse until the greatest compression [N·s]."]
    slip_impulse: Annotated[
        Impulse | None, "Normal impulse until the first slip stopped, or all of it when it never did [N·s]."
    ]
    closing_speed: Annotated[RoadSpeed, "Normal relative speed at the contact before [m/s]."]
    separation_speed: Annotated[RoadVelocity, "Normal relative speed at the contact after [m/s]."]
    sliding_before: Annotated[
        RoadVelocity,
        "Tangential velocity of the first body relative to the second at the contact before, along the tangent [m/s].",
    ]
    sliding_after: Annotated[RoadVelocity, "The same after [m/s]."]
    energy_lost: Annotated[Energy, "Kinetic energy turned into other forms [J]."]
    energy_lost_normal: Annotated[Energy, "The part the normal impulse took [J]."]
    energy_lost_tangential: Annotated[Energy, "The part friction took [J]."]
    energy_lost_moment: Annotated[Energy | None, "The part the moment impulse took [J]."]
    conventions: Annotated[Conventions, "Axes, headings and the zero of PDOF."]
    equivalent_barrier_speed: Annotated[
        RoadSpeed | None,
        "Of a vehicle against a fixed body: speed of a straight impact without rebound that loses as much [m/s].",
    ] = None
    duration: Annotated[Time | None, "Time in contact, where its stiffness is given [s]."] = None
    peak_force: Annotated[Force | None, "Greatest normal force, where the stiffness is given [N]."] = None
    stronge: Annotated[Alternative | None, "The impact by Stronge's law, where all laws were requested."] = None
    newton: Annotated[Alternative | None, "By Newton's law."] = None
    poisson: Annotated[Alternative | None, "By Poisson's law."] = None
    brach: Annotated[Alternative | None, "By Brach's impulse ratio."] = None
    kudlich_slibar: Annotated[Alternative | None, "By Kudlich and Slibar."] = None
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
