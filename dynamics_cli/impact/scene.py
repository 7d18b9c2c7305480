"""A scene of two bodies and one contact, answered by the smallest model that it calls for.

All models see the scene through one matrix K in the frame of its contact; each leaves out what a scene does not have:
`spatial` nothing, `planar` the turning of the slip, `oblique` friction and spin, `central` all motion across the line.
"""

from dynamics_cli.errors import require
from dynamics_cli.impact.conventions import BySpeed, Fixed, mass_of
from dynamics_cli.impact.decimals import cosine_and_sine
from dynamics_cli.impact.scene_records import ByMoment, ByRadius, ByTensor, Scene, SceneBody, YawRate
from dynamics_cli.impact.space import (
    Matrix,
    SolidInSpace,
    Vector,
    cross,
    dot,
    frame_about,
    mobility,
    nose_in_plane,
    nothing,
    relative_velocity,
    require_inertia,
    subtract,
    unit,
)
from dynamics_cli.impact.spatial import approach, lever_of, solved_in_space
from dynamics_cli.impact.spatial_results import Solved, SpatialImpact
from dynamics_cli.impact.straight import End, Slip, end_of, from_rest, glide
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Gravity,
)
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

# What is so many times smaller than what it is compared with is the rounding of the inputs, and absent.
ABSENT = 10**13


class _Seen:
    """A scene as its contact sees it, and what it has of what the smaller models leave out."""

    def __init__(self, scene: Scene, gravity: float) -> None:
        contact = scene.contact
        x, y, z = unit(contact.normal)
        self.inward = -x, -y, -z
        self.friction = contact.friction
        self.restitution = contact.restitution
        self.law = str(contact.law)
        self.bodies = (
            _solid(scene.first, contact.point, gravity, "the first body"),
            _solid(scene.second, contact.point, gravity, "the second body"),
        )
        one, two = self.bodies
        require(
            one.mass is not None or two.mass is not None, "both bodies are fixed: nothing can give way", code="no-mass"
        )
        slip = relative_velocity(one, two)
        self.frame = frame_about(self.inward, slip)
        self.before = approach(self.bodies, self.frame)
        # the first tangent is the direction of slip
        self.before = self.before[0], self.before[0] * 0, self.before[2]
        self.k = mobility(self.bodies, self.frame)
        self.slips = self.before[0] != 0
        scale = max(self.k[0][0], self.k[1][1], self.k[2][2])
        coupled = ABSENT * max(abs(self.k[0][2]), abs(self.k[1][2])) > scale
        # without friction nothing depends on a slip: it is kept, however little it is
        if contact.friction > 0 and ABSENT * abs(self.before[0]) <= abs(self.before[2]):
            self.before = *nothing(self.before[2])[:2], self.before[2]
            if coupled:
                # without slip the coupling says which way friction will act
                push = tuple(self.k[0][2] * a + self.k[1][2] * b for a, b in zip(*self.frame[:2], strict=True))
                self.frame = frame_about(self.inward, push)  # type: ignore[arg-type]
                self.k = mobility(self.bodies, self.frame)
        self.rubs = contact.friction > 0 and (self.before[0] != 0 or coupled)
        # an impulse along the normal turns a body that it passes by, though it moves the contact along the normal only
        self.eccentric = coupled or ABSENT * ABSENT * self.turning > self.k[2][2]
        self.turns = ABSENT * max(abs(self.k[0][1]), abs(self.k[1][2])) > scale
        self.single = [name for name, body in (("first", scene.first), ("second", scene.second)) if _one_moment(body)]

    @property
    def turning(self) -> float:
        """What k_n has of turning: it vanishes where the normal passes through the mass centres."""
        moments = [cross(body.lever, self.inward) for body in self.bodies]
        return sum(dot(moment, body.turned(moment)) for body, moment in zip(self.bodies, moments, strict=True))

    @property
    def across(self) -> bool:
        """Whether anything moves across the line of impact, or spins."""
        for body in self.bodies:
            along = dot(body.velocity, self.inward)
            off = subtract(body.velocity, tuple(along * part for part in self.inward))  # type: ignore[arg-type]
            if ABSENT * ABSENT * dot(off, off) > dot(body.velocity, body.velocity) or any(body.spin):
                return True
        return False


_last: "tuple[Scene, float, _Seen] | None" = None


def _seen(scene: Scene, gravity: float) -> _Seen:
    """The scene as its contact sees it: in doubles one is asked for again and again, by one model after the other."""
    global _last
    if not isinstance(gravity, float):
        return _Seen(scene, gravity)
    last = _last
    if last is None or last[0] is not scene or last[1] != gravity:
        _last = last = scene, gravity, _Seen(scene, gravity)
    return last[2]


def _one_moment(body: SceneBody) -> bool:
    """Whether a body's inertia is known about one axis only."""
    return isinstance(body.turning, ByMoment | ByRadius) and not isinstance(body.bulk, Fixed)


def _solid(body: SceneBody, contact: Vector | None, gravity: float, name: str) -> SolidInSpace:
    motion = body.motion
    if isinstance(motion, BySpeed):
        along, across = cosine_and_sine(motion.heading)
        velocity: Vector = (motion.speed * along, motion.speed * across, motion.speed * 0)
    else:
        velocity = motion.velocity
    if isinstance(body.rotation, YawRate):
        spin: Vector = *nothing(body.rotation.yaw_rate)[:2], body.rotation.yaw_rate
    else:
        spin = body.rotation.spin
    nose = nose_in_plane(body.nose, velocity)
    lever = nothing(velocity[0]) if body.arm is None else lever_of(body.arm, contact, name)
    if isinstance(body.bulk, Fixed):
        require(body.bulk.fixed, name + " has neither mass nor weight and is not fixed", code="no-mass")
        return SolidInSpace(None, None, lever, velocity, spin, nose)
    mass = mass_of(body.bulk, gravity, name)
    if body.turning is None:
        require(
            not any(lever) and not any(spin),
            name + " has a lever or a spin, but no inertia",
            code="no-inertia",
            hint="give its inertia, its moment or its radius of gyration",
        )
        return SolidInSpace(mass, None, lever, velocity, spin, nose)
    require(
        body.arm is not None,
        name + " has inertia, but no lever to the contact",
        code="no-lever",
        hint="give its lever, or its centre and the point of the contact; leave the inertia out for a particle",
    )
    inertia = _tensor(body.turning, mass)
    require_inertia(inertia, name)
    return SolidInSpace(mass, inertia, lever, velocity, spin, nose)


def _tensor(turning: ByTensor | ByMoment | ByRadius, mass: float) -> Matrix:
    if isinstance(turning, ByTensor):
        return turning.inertia
    if isinstance(turning, ByRadius):
        moment = mass * turning.radius_of_gyration * turning.radius_of_gyration
    else:
        moment = turning.moment
    zero = type(moment)(0)
    return (moment, zero, zero), (zero, moment, zero), (zero, zero, moment)


def central_suffices(scene: Scene, /, *, gravity: float = STANDARD_GRAVITY) -> str | None:
    """Say why the line of impact is enough, or nothing."""
    seen = _seen(scene, gravity)
    if seen.rubs or seen.eccentric or seen.across:
        return None
    return "both bodies move along the normal, which passes through their mass centres: nothing acts across it"


def oblique_suffices(scene: Scene, /, *, gravity: float = STANDARD_GRAVITY) -> str | None:
    """Say why an oblique impact without friction or spin is enough, or nothing."""
    seen = _seen(scene, gravity)
    if seen.rubs or seen.eccentric:
        return None
    why = "without friction" if seen.friction == 0 else "without slip at the contact"
    return f"{why} and with the normal through the mass centres nothing acts across it and no spin changes"


def planar_suffices(scene: Scene, /, *, gravity: float = STANDARD_GRAVITY) -> str | None:
    """Say why the plane of normal and slip is enough, or nothing."""
    seen = _seen(scene, gravity)
    if seen.friction == 0:
        return "without friction the direction of slip does not matter"
    if seen.turns:
        return None
    return "an impulse in the plane of normal and slip moves the contact in that plane only: the slip keeps its line"


def solve_central(scene: Scene, /, *, gravity: Gravity = STANDARD_GRAVITY) -> SpatialImpact:
    """Central impact of a scene: what happens on the line of impact.

    Equation
    --------
    p = (1 + e) m_r u_n with 1/m_r = 1/m₁ + 1/m₂.

    Parameters
    ----------
    scene : Scene
        Two bodies and a contact.
    gravity : Gravity
        Acceleration of gravity, for bodies given by weight [m/s^2].
    """
    seen = _seen(scene, gravity)
    neglects = _neglects(
        ("friction", seen.rubs), ("the levers", seen.eccentric), ("motion across the line", seen.across)
    )
    return _answered(_smooth, scene, gravity, "central impact", advice=neglects)


def solve_oblique(scene: Scene, /, *, gravity: Gravity = STANDARD_GRAVITY) -> SpatialImpact:
    """Oblique impact of a scene without friction and spin: velocities across the normal stay.

    Equation
    --------
    p = (1 + e) m_r u_n with 1/m_r = 1/m₁ + 1/m₂.

    Parameters
    ----------
    scene : Scene
        Two bodies and a contact.
    gravity : Gravity
        Acceleration of gravity, for bodies given by weight [m/s^2].
    """
    seen = _seen(scene, gravity)
    neglects = _neglects(("friction", seen.rubs), ("the levers", seen.eccentric))
    return _answered(_smooth, scene, gravity, "oblique impact", advice=neglects)


def _answered(
    solver: "Callable[..., Solved]", scene: Scene, gravity: float, *more: str, advice: tuple[Advice, ...] = ()
) -> SpatialImpact:
    """The answer of a smaller model; where it leaves out what is absent but for rounding, its bounds hold that."""
    from dynamics_cli.impact.spatial_bounds import answered, beside

    found = answered(solver, scene, gravity, *more, advice=advice)
    if advice or found.numerics is None or not _left_out(scene, gravity, plane=solver is _in_plane):
        return found
    return beside(found, answered(_in_space, scene, gravity))


def _left_out(scene: Scene, gravity: float, *, plane: bool) -> bool:
    """Whether a smaller model leaves out anything at all."""
    from decimal import Context, localcontext

    from dynamics_cli.impact.decimals import widened

    with localcontext(Context(prec=80)):
        seen = _Seen(widened(scene), widened(gravity))
        k = seen.k
        least = max(k[0][0], k[1][1], k[2][2]) / 10**60
        coupled = (k[0][1], k[1][2]) if plane else (k[0][2], k[1][2])
        if any(abs(entry) > least for entry in coupled):
            return seen.friction > 0 or not plane
        if not plane and seen.turning > least / 10**60:
            return True
        return seen.slips and seen.friction > 0 and not seen.before[0]


def _smooth(scene: Scene, gravity: float, name: str, **_: int) -> Solved:
    """An impulse along the normal through both mass centres."""
    seen = _seen(scene, gravity)
    # with inertia left out nothing turns; with its lever a spin still moves the contact
    one, two = (SolidInSpace(body.mass, None, body.lever, body.velocity, body.spin, body.nose) for body in seen.bodies)
    k = mobility((one, two), seen.frame)
    before = approach((one, two), seen.frame)
    e = seen.restitution
    compression = -before[2] / k[2][2]
    impulse = (1 + e) * compression
    work = compression * -before[2] / 2
    zero = before[2] * 0
    end = End(
        velocity=(before[0], before[1], -e * before[2]),
        impulse=(zero, zero, impulse),
        compression=compression,
        work=work,
        work_back=e * e * work,
        heat=zero,
        history="slip without friction" if before[0] or before[1] else "no slip",
        slip_impulse=impulse if seen.friction == 0 else zero,
    )
    return Solved((one, two), seen.frame, k, before, end, zero, e, seen.law, f"closed form of a {name}, in decimals")


def solve_planar(scene: Scene, /, *, gravity: Gravity = STANDARD_GRAVITY) -> SpatialImpact:
    """Planar impact of a scene: the closed-form path in the plane of the normal and the first slip.

    Equation
    --------
    u' = u + K p in that plane; slip, then stick or reversed slip, as `impact planar`.

    Parameters
    ----------
    scene : Scene
        Two bodies and a contact.
    gravity : Gravity
        Acceleration of gravity, for bodies given by weight [m/s^2].
    """
    seen = _seen(scene, gravity)
    turns = seen.turns and seen.friction > 0
    return _answered(_in_plane, scene, gravity, advice=_neglects(("the turning of the slip out of its plane", turns)))


def _in_plane(scene: Scene, gravity: float, **_: int) -> Solved:
    """Slip along its line, and then stick or reversed slip."""
    seen = _seen(scene, gravity)
    k, before, zero = seen.k, seen.before, seen.before[2] * 0
    plane = (k[0][0], zero, k[0][2]), (zero, k[1][1], zero), (k[0][2], zero, k[2][2])
    slip = Slip([*before, zero, zero, zero, zero, zero])
    given = before[2], seen.friction, seen.restitution, seen.law
    slides = before[0] != 0 and seen.friction > 0
    if slides and glide(plane, slip, (before[0] / abs(before[0]), zero), given[1], before[2], *given[2:]):
        end = end_of(slip, "slip")
    else:
        end = from_rest(plane, slip, *given, at_rest=not slides)
    if end.history == "slip, slip anew":
        end.history = "slip, reversed slip"
    aside = k[0][1] * end.impulse[0] + k[1][2] * end.impulse[2]
    end.velocity = end.velocity[0], aside, end.velocity[2]
    how = "closed-form Routh–Keller path in the plane of normal and slip, in decimals"
    return Solved(seen.bodies, seen.frame, k, before, end, seen.friction, seen.restitution, seen.law, how)


def solve(scene: Scene, /, *, gravity: Gravity = STANDARD_GRAVITY) -> SpatialImpact:
    """Two bodies and one contact in space, with friction, spin and slip that turns.

    Equation
    --------
    As `impact spatial`.

    Parameters
    ----------
    scene : Scene
        Two bodies and a contact.
    gravity : Gravity
        Acceleration of gravity, for bodies given by weight [m/s^2].

    Returns
    -------
    SpatialImpact
        Velocities and spins after, impulses, ΔV, slip history, energies.

    Raises
    ------
    InadmissibleError
        When the bodies do not approach, lack what their motion needs, or are described in frames that do not fit.

    Notes
    -----
    Which smaller model suffices is decided by K in the frame of the contact, not by how the scene was written down.
    """
    seen = _seen(scene, gravity)
    require(
        not seen.single,
        f"the impact leaves the plane, but the {' and the '.join(seen.single)} body has one moment of inertia only",
        code="one-moment",
        hint="give the inertia tensor, or choose --model planar and say why",
    )
    from dynamics_cli.impact.spatial_bounds import answered

    return answered(_in_space, scene, gravity)


def _in_space(scene: Scene, gravity: float, **effort: int) -> Solved:
    seen = _seen(scene, gravity)
    return solved_in_space(seen.bodies, seen.inward, seen.friction, seen.restitution, seen.law, **effort)


def _neglects(*what: tuple[str, bool]) -> tuple[Advice, ...]:
    """Say what a model that was asked for leaves out of this scene."""
    names = [name for name, present in what if present]
    if not names:
        return ()
    text = "this scene has more than the model: it leaves out " + ", ".join(names)
    return (Advice("model-too-small", text, "serious", mend="leave out --model"),)
