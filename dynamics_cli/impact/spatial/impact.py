"""Impact of two rigid bodies in space, with friction: Keller's equations to the end that the law sets."""

from dynamics_cli.errors import require, require_given
from dynamics_cli.impact.conventions import ByMass, ByWeight, Energetic, Fixed, Restituted, mass_of, side_of
from dynamics_cli.impact.particles.central import contact_advice, require_approach
from dynamics_cli.impact.spatial.bodies import (
    Matrix,
    SolidInSpace,
    Vector,
    frame_about,
    inverse,
    mobility,
    nose_in_plane,
    nothing,
    relative_velocity,
    require_inertia,
    unit,
)
from dynamics_cli.impact.spatial.hodograph import ORDER, STRIDE, travel
from dynamics_cli.impact.spatial.results import Solved, SpatialImpact
from dynamics_cli.impact.spatial.straight_slip import End
from dynamics_cli.numerics.vectors import dot, subtract
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    AngularVelocity,
    Annotated,
    Direction,
    Friction,
    Gravity,
    InertiaTensor,
    SpacePosition,
    SpaceVelocity,
)
from dynamics_cli.records import Choice, record

# Spare digits of the path, and of velocities at the contact that cancel.
GUARDS = 12
SPARE = 20


class SpatialLaw(Choice):
    """The law that ends an impact in space; the default is Stronge's energetic restitution, which never gains energy.

    stronge: the normal force gives back e² of its work. newton: u_n' = −e u_n. poisson: p_n = (1 + e) p_c.
    """

    names = ("stronge", "newton", "poisson")
    aliases = {"energetic": "stronge", "kinematic": "newton", "kinetic": "poisson"}  # noqa: RUF012


SPATIAL_LAW = SpatialLaw("stronge")


@record
class LeverInSpace:
    """The contact by its place relative to the mass centre."""

    lever: Annotated[SpacePosition, "From the mass centre to the contact, along the axes of the scene [m]."]


@record
class PlacedInSpace:
    """The contact by where the mass centre is; the contact point is then given for the scene."""

    centre: Annotated[SpacePosition, "Place of the mass centre in the scene [m]."]


@record
class BodyInSpace:
    """A rigid body that moves in space."""

    bulk: Annotated[ByMass | ByWeight, "Its mass or its weight."]
    inertia: Annotated[InertiaTensor, "Its inertia about the mass centre, along the axes of the scene [kg·m²]."]
    arm: Annotated[LeverInSpace | PlacedInSpace, "Where it is struck."]
    velocity: Annotated[SpaceVelocity, "Velocity of the mass centre before [m/s]."] = (0.0, 0.0, 0.0)
    spin: Annotated[AngularVelocity, "Angular velocity before [rad/s]."] = (0.0, 0.0, 0.0)
    nose: Annotated[
        Direction | None, "Direction of its nose, for PDOF; unless given, its direction of travel, e.g. 1, 0, 0."
    ] = None


@record
class TargetInSpace:
    """The other rigid body, or a fixed barrier, which needs neither inertia nor lever."""

    bulk: Annotated[ByMass | ByWeight | Fixed, "Its mass or its weight, or that it is fixed."]
    inertia: Annotated[
        InertiaTensor | None, "Its inertia about the mass centre, along the axes of the scene [kg·m²]."
    ] = None
    arm: Annotated[LeverInSpace | PlacedInSpace | None, "Where it is struck."] = None
    velocity: Annotated[SpaceVelocity, "Velocity of the mass centre before [m/s]."] = (0.0, 0.0, 0.0)
    spin: Annotated[AngularVelocity, "Angular velocity before [rad/s]."] = (0.0, 0.0, 0.0)
    nose: Annotated[
        Direction | None, "Direction of its nose, for PDOF; unless given, its direction of travel, e.g. 1, 0, 0."
    ] = None


def spatial(
    *,
    first: Annotated[BodyInSpace, "The first body."],
    second: Annotated[TargetInSpace, "The second body, or a fixed barrier."],
    normal: Annotated[Direction, "Contact normal from the first body to the second, of any length."],
    friction: Annotated[Friction, "Coefficient of friction at the contact [-]."],
    contact: Annotated[
        Restituted | Energetic,
        "Coefficient of restitution in the sense of the law, or the ratio of a contact that gives energy.",
    ],
    law: Annotated[SpatialLaw, "Law that ends the impact: stronge, newton or poisson."] = SPATIAL_LAW,
    contact_point: Annotated[
        SpacePosition | None, "Where the bodies touch, when bodies are placed by their centres [m]."
    ] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity, for bodies given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> SpatialImpact:
    """Two rigid bodies in space, or one and a fixed barrier, meet at a point with friction and restitution.

    Equation
    --------
    du = K (−μ u_t/|u_t|, 1) dp_n while the contact slips; p_t = −K_tt⁻¹ k_tn p_n while it sticks, which needs
    |K_tt⁻¹ k_tn| ≤ μ; K = Σ (1/m − [r] J⁻¹ [r]); end by the law.

    Returns
    -------
    SpatialImpact
        Velocities and spins after, impulses, ΔV, slip history, energies.

    Raises
    ------
    InadmissibleError
        When the bodies do not approach at the contact, a tensor is not that of a body, or the law gains energy.

    Notes
    -----
    The slip turns while it lasts. Its equations are marched by Taylor series of order 24 in τ, dp_n = |u_t| dτ: regular
    where slip nearly stops, and where a contact jams, so that the normal velocity is not monotone. After slip has
    stopped everything is linear: it sticks, or slips along the one exit direction. The path is followed in doubles and
    again in decimals: results are rounded once, and the two runs bound the remaining error, even for slender bodies and
    long levers.

    References
    ----------
    J. B. Keller, Impact with friction, J. Appl. Mech. 53 (1986); W. J. Stronge, Impact Mechanics (2000), chapter 4.

    Examples
    --------
    >>> sphere = ((0.4, 0.0, 0.0), (0.0, 0.4, 0.0), (0.0, 0.0, 0.4))
    >>> ball = BodyInSpace(ByMass(1.0), sphere, LeverInSpace((0.0, 0.0, -1.0)), (1.0, 0.0, -2.0))
    >>> floor = TargetInSpace(Fixed(True))
    >>> hit = spatial(first=ball, second=floor, normal=(0.0, 0.0, -1.0), friction=0.05, contact=Restituted(0.5))
    >>> round(hit.normal_impulse, 12), round(hit.tangential_impulse, 12), hit.slip_history
    (3.0, 0.15, 'slip')
    """
    from dynamics_cli.impact.spatial.bounds import answered

    arguments = first, second, normal, friction, contact.restitution, str(law), contact_point, gravity
    return answered(_solved, *arguments, advice=contact_advice(contact))


def _solved(
    first: BodyInSpace,
    second: TargetInSpace,
    normal: Vector,
    friction: float,
    restitution: float,
    law: str,
    contact_point: Vector | None,
    gravity: float,
    **effort: int,
) -> Solved:
    x, y, z = unit(normal)
    body = solid(first, contact_point, gravity, "the first body")
    two = solid(second, contact_point, gravity, "the second body")
    return solved_in_space((body, two), (-x, -y, -z), friction, restitution, law, **effort)


def solved_in_space(
    bodies: tuple[SolidInSpace, SolidInSpace],
    inward: Vector,
    friction: float,
    restitution: float,
    law: str,
    **effort: int,
) -> Solved:
    """Keller's equations for two bodies and a normal that points at the first."""
    # along the slip: a motion in one plane then slips along one axis
    frame = frame_about(inward, relative_velocity(*bodies))
    before = approach(bodies, frame)
    k = cleaned(mobility(bodies, frame))
    end = followed(k, before, friction, restitution, law, **effort)
    how = f"Taylor series in decimals, {end.steps} steps of slip" if end.steps else "closed form: no slip to follow"
    return Solved(bodies, frame, k, before, end, friction, restitution, law, how)


def followed(
    k: Matrix, before: Vector, friction: float, restitution: float, law: str, order: int = ORDER, digits: int = 0
) -> End:
    """The path in doubles, or in decimals with a few more than the given digits."""
    if not digits:
        return travel(k, before, friction, restitution, law)
    from decimal import getcontext, localcontext

    with localcontext(getcontext()) as context:
        context.prec = digits + GUARDS
        # drop the digits that the path does not carry
        rows = tuple(tuple(+entry for entry in row) for row in k)
        start = tuple(+part for part in before)
        return travel(rows, start, +friction, +restitution, law, order, STRIDE, digits)  # type: ignore[arg-type]


def cleaned(k: Matrix) -> Matrix:
    """K in decimals, with entries that are zero except for rounding set to zero."""
    if not hasattr(k[0][0], "sqrt"):
        return k
    from decimal import getcontext

    least = max(k[0][0], k[1][1], k[2][2]).scaleb(SPARE - getcontext().prec)  # type: ignore[attr-defined]
    return tuple(tuple(entry if abs(entry) > least else 0 * entry for entry in row) for row in k)  # type: ignore[return-value]


def approach(bodies: tuple[SolidInSpace, SolidInSpace], frame: Matrix) -> Vector:
    """Relative velocity at the contact in its frame; refuses bodies that do not approach."""
    relative = relative_velocity(*bodies)
    before = dot(relative, frame[0]), dot(relative, frame[1]), dot(relative, frame[2])
    if hasattr(before[0], "sqrt"):
        # decimals of only rounding are zero
        speeds = [max(map(abs, body.velocity)) for body in bodies]
        speeds += [max(map(abs, body.spin)) * max(map(abs, body.lever)) for body in bodies]
        from decimal import getcontext

        least = max(speeds).scaleb(SPARE - getcontext().prec)  # type: ignore[attr-defined]
        before = tuple(part if abs(part) > least else 0 * part for part in before)  # type: ignore[assignment]
    require_approach(-before[2])
    return before


def solid(body: BodyInSpace | TargetInSpace, contact: Vector | None, gravity: float, name: str) -> SolidInSpace:
    """Read a body; refuses one without mass, inertia or lever that needs them."""
    nose = nose_in_plane(body.nose, body.velocity)
    if isinstance(body.bulk, Fixed):
        require(body.bulk.fixed, "{name} has neither mass nor weight and is not fixed", name=name, code="no-mass")
        lever = nothing(body.velocity[0]) if body.arm is None else lever_of(body.arm, contact, name)
        return SolidInSpace(None, None, None, lever, body.velocity, body.spin, nose)
    mass = mass_of(body.bulk, gravity, name)
    require(
        body.inertia is not None, "{name} has no inertia", name=name, code="no-inertia", hint="give its inertia tensor"
    )
    require(
        body.arm is not None, "{name} has no lever to the contact", name=name, code="no-lever", hint="give its lever"
    )
    inertia: Matrix = body.inertia  # type: ignore[assignment]
    require_inertia(inertia, name)
    lever = lever_of(body.arm, contact, name)  # type: ignore[arg-type]
    return SolidInSpace(mass, inertia, inverse(inertia), lever, body.velocity, body.spin, nose)


def lever_of(arm: LeverInSpace | PlacedInSpace, contact: Vector | None, name: str) -> Vector:
    """From the mass centre to the contact."""
    if isinstance(arm, LeverInSpace):
        return arm.lever
    require_given(
        contact is not None,
        "{name} is placed by its centre, but there is no contact point in the same axes",
        ("contact_point",),
        (f"{side_of(name)}.lever",),
        name=name,
        code="no-contact-point",
    )
    return subtract(contact, arm.centre)  # type: ignore[arg-type]
