"""A scene in the frame of its contact: bodies, matrix K, velocities, and the terms that smaller models neglect."""

from dynamics_cli.errors import require, require_given
from dynamics_cli.impact.conventions import BySpeed, Fixed, mass_of, side_of
from dynamics_cli.impact.spatial.arithmetic import cosine_and_sine
from dynamics_cli.impact.spatial.bodies import (
    Matrix,
    SolidInSpace,
    Vector,
    frame_about,
    mobility,
    nose_in_plane,
    nothing,
    relative_velocity,
    unit,
)
from dynamics_cli.impact.spatial.impact import TargetInSpace, approach, lever_of, solid
from dynamics_cli.impact.spatial.scene_records import ByMoment, ByRadius, ByTensor, Scene, SceneBody, YawRate
from dynamics_cli.numerics.vectors import cross, dot, subtract

# A value smaller than this share of its reference is rounding of the inputs and counts as absent.
ABSENT = 10**13


class SeenScene:
    """A scene at its contact, with the effects that smaller models neglect."""

    def __init__(self, scene: Scene, gravity: float, absent: int = ABSENT) -> None:
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
        first, second = self.bodies
        require(
            first.mass is not None or second.mass is not None,
            "both bodies are fixed: one of them must be able to move",
            code="no-mass",
        )
        slip = relative_velocity(first, second)
        self.frame = frame_about(self.inward, slip)
        self.before = approach(self.bodies, self.frame)
        # the first tangent is the direction of slip
        self.before = self.before[0], self.before[0] * 0, self.before[2]
        self.k = mobility(self.bodies, self.frame)
        scale = max(self.k[0][0], self.k[1][1], self.k[2][2])
        coupled = absent * max(abs(self.k[0][2]), abs(self.k[1][2])) > scale
        # without friction the slip has no effect: even the smallest is kept
        if contact.friction > 0 and absent * abs(self.before[0]) <= abs(self.before[2]):
            self.before = *nothing(self.before[2])[:2], self.before[2]
            if coupled:
                # without slip the coupling determines the direction of friction
                push = tuple(self.k[0][2] * a + self.k[1][2] * b for a, b in zip(*self.frame[:2], strict=True))
                self.frame = frame_about(self.inward, push)  # type: ignore[arg-type]
                self.k = mobility(self.bodies, self.frame)
        self.rubs = contact.friction > 0 and (self.before[0] != 0 or coupled)
        # an impulse along the normal turns a body that it passes by, though it moves the contact along the normal only
        self.eccentric = coupled or absent * absent * self.turning > self.k[2][2]
        self.turns = absent * max(abs(self.k[0][1]), abs(self.k[1][2])) > scale
        self.effects = self.rubs, self.eccentric, self.across(absent), self.turns
        self.single = [
            name for name, body in (("first", scene.first), ("second", scene.second)) if _has_one_moment(body)
        ]

    @property
    def turning(self) -> float:
        """The rotational part of k_n: zero where the normal passes through the mass centres."""
        moments = [cross(body.lever, self.inward) for body in self.bodies]
        return sum(dot(moment, body.turned(moment)) for body, moment in zip(self.bodies, moments, strict=True))

    def across(self, absent: int = ABSENT) -> bool:
        """Whether anything moves across the line of impact, or spins."""
        for body in self.bodies:
            along = dot(body.velocity, self.inward)
            off = subtract(body.velocity, tuple(along * part for part in self.inward))  # type: ignore[arg-type]
            if absent * absent * dot(off, off) > dot(body.velocity, body.velocity) or any(body.spin):
                return True
        return False


_last: "tuple[Scene, float, SeenScene] | None" = None


def viewed(scene: Scene, gravity: float) -> SeenScene:
    """The scene at its contact, cached for doubles because each model asks for it."""
    global _last
    if not isinstance(gravity, float):
        return SeenScene(scene, gravity)
    last = _last
    if last is None or last[0] is not scene or last[1] != gravity:
        _last = last = scene, gravity, SeenScene(scene, gravity)
    return last[2]


def _has_one_moment(body: SceneBody) -> bool:
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
    fixed = isinstance(body.bulk, Fixed)
    if body.turning is None and not fixed:
        lever = nothing(velocity[0]) if body.arm is None else lever_of(body.arm, contact, name)
        mass = mass_of(body.bulk, gravity, name)  # type: ignore[arg-type]
        require_given(
            not any(lever) and not any(spin),
            "{name} has a lever or a spin, but no inertia",
            *((f"{side_of(name)}.{part}",) for part in ("inertia", "moment", "radius_of_gyration")),
            name=name,
            code="no-inertia",
        )
        return SolidInSpace(mass, None, None, lever, velocity, spin, nose_in_plane(body.nose, velocity))
    side = side_of(name)
    require_given(
        fixed or body.arm is not None,
        "{name} has inertia, but no lever to the contact (a particle has no inertia)",
        (f"{side}.lever",),
        (f"{side}.centre", "contact.point"),
        name=name,
        code="no-lever",
    )
    inertia = None if fixed else _tensor(body, gravity, name)
    return solid(TargetInSpace(body.bulk, inertia, body.arm, velocity, spin, body.nose), contact, gravity, name)


def _tensor(body: SceneBody, gravity: float, name: str) -> Matrix:
    turning = body.turning
    if isinstance(turning, ByTensor):
        return turning.inertia
    if isinstance(turning, ByRadius):
        mass = mass_of(body.bulk, gravity, name)  # type: ignore[arg-type]
        moment = mass * turning.radius_of_gyration * turning.radius_of_gyration
    else:
        moment = turning.moment  # type: ignore[union-attr]
    zero = type(moment)(0)
    return (moment, zero, zero), (zero, moment, zero), (zero, zero, moment)
