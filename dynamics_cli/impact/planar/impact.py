"""Planar impact of two rigid bodies with friction: the path of the contact, its end by a named law, its certificate."""

from dynamics_cli.errors import (
    require,
    worded,
)
from dynamics_cli.impact.conventions import (
    AXES,
    PDOF_ZERO,
    Axes,
    Energetic,
    PdofZero,
    Restituted,
    conventions,
    direction_of,
    heading_of,
)
from dynamics_cli.impact.diagnostics import require_finite
from dynamics_cli.impact.particles.central import contact_advice, plain_above, require_approach
from dynamics_cli.impact.particles.springs import Hertz, Spring, contact_history, force_advice
from dynamics_cli.impact.planar.bodies import (
    Pair,
    RigidBody,
    RigidTarget,
    Solid,
    contact_velocity,
    mobility,
    solid,
)
from dynamics_cli.impact.planar.certificate import (
    certificate,
    lever_advice,
    restituted_advice,
    side_advice,
)
from dynamics_cli.impact.planar.laws import LAW, LAWS, Law, Meeting, Outcome, critical_ratio, outcome
from dynamics_cli.impact.planar.results import Alternative, Critical, PlanarImpact, after_impact
from dynamics_cli.numerics.elementary import absolute, hypot, maximum, sqrt, where
from dynamics_cli.numerics.number import single
from dynamics_cli.numerics.vectors import planar_dot as dot
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Energy,
    Friction,
    Gravity,
    PlanarPosition,
    Ratio,
    RoadSpeed,
)
from dynamics_cli.records import Advice

TURNED = "the normal points from the first body to the second: turn it by 180 degrees, or check the velocities"


def planar(
    *,
    first: Annotated[RigidBody, "The first body."],
    second: Annotated[RigidTarget, "The second body, or a fixed barrier."],
    normal: Annotated[
        Angle, "Direction of the contact normal from the first body to the second, counted like a heading [rad]."
    ],
    friction: Annotated[
        Friction, "Coefficient of friction at the contact; for Brach's law the limit of the impulse ratio [-]."
    ],
    contact: Annotated[
        Restituted | Energetic,
        "Coefficient of restitution in the sense of the law, or the ratio of a contact that gives energy.",
    ],
    law: Annotated[
        Law, "Law that ends the impact: stronge, newton, poisson, brach, kudlich-slibar, or all side by side."
    ] = LAW,
    contact_point: Annotated[
        PlanarPosition | None, "Where the bodies touch, when bodies are placed by their centres [m]."
    ] = None,
    moment_restitution: Annotated[
        Ratio, "Brach's moment coefficient: 1 without a moment at the contact, 0 with one that makes the spins one [-]."
    ] = 1.0,
    closing_speed: Annotated[
        RoadSpeed | None,
        "Normal speed of approach at the contact, where it is known better than the velocities tell [m/s].",
    ] = None,
    force: Annotated[Spring | Hertz | None, "Stiffness of the contact, for duration and peak force."] = None,
    axes: Annotated[Axes, "Axes of vectors, headings and spins: mathematical, compass, sae or iso."] = AXES,
    pdof_zero: Annotated[PdofZero, "Where a force of PDOF zero comes from: heading, travel or scene."] = PDOF_ZERO,
    gravity: Annotated[Gravity, "Acceleration of gravity, for bodies given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> PlanarImpact:
    """Two rigid bodies in the plane, or one and a fixed barrier, meet at a point with friction and restitution.

    Equation
    --------
    u' = u + K p, K = [[k_t, k_x], [k_x, k_n]], k_t = Σ(1/m + r_n²/J), k_n = Σ(1/m + r_t²/J), k_x = −Σ r_t r_n/J;
    slip: dp_t = −μ sgn(u_t) dp_n, stick: dp_t = −(k_x/k_t) dp_n where |k_x| ≤ μ k_t; end by the law.

    Returns
    -------
    PlanarImpact
        Velocities and spins after, impulses, ΔV and PDOF, slip history, energies, other laws if requested.

    Raises
    ------
    InadmissibleError
        When the bodies do not approach at the contact, lack mass, inertia, lever or contact point, or when the law
        gives no compressive impulse or gains energy.

    Notes
    -----
    K and its determinant are sums of positive terms; stick is decided by |k_x| ≤ μ k_t, never by a small velocity; ΔV
    follows from the impulse and the energy from the work of the forces. Newton's and Brach's laws can gain energy: such
    an answer is refused. All laws agree where slip never stops; `stronge` never gains energy.

    References
    ----------
    E. J. Routh, Dynamics of a System of Rigid Bodies (1877); J. B. Keller, Impact with friction, J. Appl. Mech. 53
    (1986); W. J. Stronge, Impact Mechanics (2000); R. M. Brach, R. M. Brach, Vehicle Accident Analysis and
    Reconstruction Methods (2011).

    Examples
    --------
    >>> from dynamics_cli.impact.planar.bodies import ByGyration, Lever
    >>> from dynamics_cli.impact.conventions import ByMass, ByVelocity, Fixed
    >>> ball = RigidBody(ByMass(1.0), ByGyration(0.5), Lever((0.0, -1.0)), ByVelocity((1.0, -2.0)))
    >>> floor = RigidTarget(Fixed(True))
    >>> from dynamics_cli.impact.conventions import Restituted
    >>> hit = planar(first=ball, second=floor, normal=-1.5707963267948966, friction=0.05, contact=Restituted(0.5))
    >>> round(hit.normal_impulse, 12), round(hit.tangential_impulse, 12), hit.slip_history
    (3.0, 0.15, 'slip')
    """
    body = solid(first, contact_point, axes, gravity, "the first body")
    two = solid(second, contact_point, axes, gravity, "the second body")
    towards = direction_of(normal, axes)
    inward = -towards[0], -towards[1]
    require(
        absolute(moment_restitution) <= 1.0,
        "a moment restitution lies between -1 (spins exchanged), 0 (common spin) and 1 (no moment); it cannot be "
        "{value:6}",
        value=(moment_restitution, Ratio),
        code="moment-restitution",
    )
    meeting = meeting_of(body, two, inward, closing_speed, friction, contact.restitution, moment_restitution)
    main = LAWS[0] if law == "all" else law
    solved = outcome(meeting, main)
    energetic = plain_above(contact.restitution)
    require_finite(solved.normal * meeting.approach, "the energy of the impact")
    refuse(solved, main, energetic)
    answer = _answer(solved, main, meeting, body, two, inward, axes, pdof_zero)
    alternatives, missing = _all_laws(meeting, body, two, inward, energetic) if law == "all" else ({}, ())
    duration, peak = contact_history(force, meeting, main)
    advice = contact_advice(contact) + force_advice(force, duration, main) + missing
    advice += side_advice(body, two, towards) + lever_advice(body, two) + restituted_advice(main, moment_restitution)
    checks = certificate(answer, solved, main, meeting, body, two, inward)
    return PlanarImpact(
        **{
            **answer.__dict__,
            **alternatives,
            "conventions": conventions(axes, pdof_zero),
            "duration": duration,
            "peak_force": peak,
            "checks": checks,
            "advice": advice,
        }
    )


def meeting_of(
    a: Solid,
    b: Solid,
    inward: Pair,
    closing: float | None,
    friction: float,
    restitution: float,
    moment_restitution: float,
) -> Meeting:
    """Velocities and mobility in the frame of the contact; refuses bodies that do not approach there."""
    relative = contact_velocity(a, b)
    across = -inward[1], inward[0]
    approach = dot(relative, inward)
    if closing is not None:
        speeds = absolute(relative[0]) + absolute(relative[1]) + absolute(a.velocity[0]) + absolute(a.velocity[1])
        require(
            absolute(closing + approach) <= 1e-6 * closing + 4e-15 * speeds,
            "the velocities close at {approach:9} at the contact, but the closing speed is {closing:9}",
            approach=(-approach, RoadSpeed),
            closing=(closing, RoadSpeed),
            code="contradiction",
            hint="leave out the closing speed, or correct the velocities",
        )
        approach = -closing
    else:
        # below this the approach is only rounding of the normal's direction
        slide = absolute(relative[0]) + absolute(relative[1])
        require(
            (approach >= 0.0) | (-approach > 2.0**-52 * slide),
            "no impact: the bodies slide along each other, closing at {approach:3} of {slide:6}, which is rounding",
            approach=(-approach, RoadSpeed),
            slide=(slide, RoadSpeed),
            code="no-impact",
            hint="give --closing-speed if they do meet",
        )
    require_approach(-approach, TURNED)
    k, arms = mobility(a, b, inward)
    compliance: float = 0.0
    for body in (a, b):
        if body.inertia is not None:
            compliance = compliance + 1.0 / body.inertia
    return Meeting(
        mobility=k,
        slip=dot(relative, across),
        approach=approach,
        friction=friction,
        restitution=restitution,
        turning=a.spin - b.spin,
        moment_restitution=moment_restitution,
        compliance=compliance,
        arms=arms,
    )


def refuse(solved: Outcome, law: str, energetic: bool) -> None:
    """Refuse a law that gives no compressive impulse or gains energy."""
    require(
        solved.feasible,
        "{law}: {why}",
        law=str(law),
        why=solved.why,
        code="no-push",
        hint="--law stronge always has an answer",
    )
    if energetic:
        return
    require(
        solved.lost >= -1e-12 * solved.scale,
        "{law}: the law gains {gain:6} of energy here, which no passive contact does",
        law=str(law),
        gain=(-solved.lost, Energy),
        code="energy-gained",
        hint="--law stronge never gains energy",
    )


def _scene_impulse(solved: Outcome, inward: Pair) -> Pair:
    """The impulse on body 1 along the axes of the scene."""
    x = solved.normal * inward[0] - solved.tangential * inward[1]
    y = solved.normal * inward[1] + solved.tangential * inward[0]
    return x, y


def _answer(
    solved: Outcome, law: str, m: Meeting, a: Solid, b: Solid, inward: Pair, axes: Axes, zero: PdofZero
) -> PlanarImpact:
    impulse = _scene_impulse(solved, inward)
    back = -impulse[0], -impulse[1]
    moment = solved.moment
    lost = solved.lost
    return PlanarImpact(
        first=after_impact(a, impulse, moment, axes, zero),
        second=after_impact(b, back, None if moment is None else -moment, axes, zero),
        law=str(law),
        slip_history=solved.history,
        impulse=back,
        impulse_magnitude=hypot(solved.normal, solved.tangential),
        normal_impulse=solved.normal,
        tangential_impulse=solved.tangential,
        moment_impulse=None if moment is None else -moment,
        impulse_direction=heading_of(back[0], back[1], axes),
        impulse_ratio=solved.tangential / solved.normal,
        critical=_critical(m),
        compression_impulse=solved.compression,
        slip_impulse=solved.first_slip,
        closing_speed=-m.approach,
        separation_speed=solved.normal_after,
        sliding_before=0.0 - m.slip,
        sliding_after=0.0 - solved.tangential_after,
        energy_lost=lost,
        energy_lost_normal=solved.normal_lost,
        energy_lost_tangential=solved.tangential_lost,
        energy_lost_moment=solved.moment_lost,
        conventions=conventions(axes, zero),
        equivalent_barrier_speed=None
        if a.mass is None or b.mass is not None
        else sqrt(2.0 * maximum(lost, 0.0) / a.mass),
    )


def _critical(m: Meeting) -> Critical:
    """Critical impulse ratio; without a normal impulse it would be infinite and is omitted."""
    along, across = critical_ratio(m)
    exists = across != 0.0
    if single(exists) and not exists:
        return Critical(None, None, absolute(m.mobility.coupling) / m.mobility.tangential)
    ratio = along / across
    size = absolute(ratio)
    if single(size) and not size > 0.0:
        return Critical(ratio, None, absolute(m.mobility.coupling) / m.mobility.tangential)
    return Critical(ratio, m.friction / size, absolute(m.mobility.coupling) / m.mobility.tangential)


def _all_laws(
    m: Meeting, a: Solid, b: Solid, inward: Pair, energetic: bool
) -> tuple[dict[str, Alternative | None], tuple[Advice, ...]]:
    """Every law's answer by name; for a single case, a law without an answer is None with the reason."""
    answers: dict[str, Alternative | None] = {}
    missing: tuple[Advice, ...] = ()
    for law in LAWS:
        name = law.replace("-", "_")
        solved = outcome(m, law)
        if single(solved.feasible) and not solved.feasible:
            text = worded("{law}: {why}", law=str(law), why=solved.why)
        elif single(solved.lost) and not energetic and solved.gains:
            text = worded(
                "{law}: it gains {gain:6} of energy here, which no passive contact does",
                law=str(law),
                gain=(-solved.lost, Energy),
            )
        else:
            # rows where a law has no answer are removed and calculated one by one
            refuse(solved, law, energetic)
            answers[name] = _alternative(solved, a, b, inward)
            continue
        answers[name] = None
        missing += (Advice("law-inadmissible", text, "note", result=name),)
    return answers, missing


def _alternative(solved: Outcome, a: Solid, b: Solid, inward: Pair) -> Alternative:
    impulse = _scene_impulse(solved, inward)
    size = hypot(solved.normal, solved.tangential)
    first = after_impact(a, impulse, solved.moment, AXES, PDOF_ZERO)
    second = after_impact(
        b, (-impulse[0], -impulse[1]), None if solved.moment is None else -solved.moment, AXES, PDOF_ZERO
    )
    return Alternative(
        normal_impulse=solved.normal,
        tangential_impulse=solved.tangential,
        impulse_ratio=solved.tangential / where(solved.normal != 0.0, solved.normal, 1.0),
        first_delta_v=None if a.mass is None else size / a.mass,
        second_delta_v=None if b.mass is None else size / b.mass,
        first_spin=first.spin,
        second_spin=second.spin,
        separation_speed=solved.normal_after,
        sliding_after=0.0 - solved.tangential_after,
        energy_lost=solved.lost,
        slip_history=solved.history,
    )
