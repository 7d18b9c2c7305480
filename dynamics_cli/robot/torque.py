"""Torques of an arm's joints for a motion, a payload and a force of the hand, part by part."""

from dynamics_cli.errors import MissingError, require
from dynamics_cli.numerics.elementary import absolute, maximum, sqrt, where
from dynamics_cli.numerics.number import over_plain, plain, single
from dynamics_cli.numerics.orientation.rotations import about_axis, product, transposed
from dynamics_cli.numerics.trees.newton_euler import back, inverse, sweep
from dynamics_cli.numerics.trees.tree import FIXED, PRISMATIC, REVOLUTE, Link, Tree, placed, poses
from dynamics_cli.numerics.vectors import add, cross, dot, scale, times
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Angle,
    AngularAcceleration,
    Annotated,
    Coordinate,
    Direction,
    Force,
    ForceVector,
    Gravity,
    Mass,
    PotentialEnergy,
    Power,
    Speed,
    Text,
    Torque,
    TorqueVector,
    TurnRate,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.robot.arms.chain import Chain, chain_of, coordinates_of
from dynamics_cli.robot.arms.records import ANGLES, ORIGIN, SLIDES, Arm
from dynamics_cli.robot.pose import limit_advice
from dynamics_cli.robot.velocities import columns_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

UP = (0.0, 0.0, 1.0)
NOTHING = (None,)
# Step in time of the difference quotient of the energy, and what it leaves as a share of the powers.
STEP, AGREES = 1e-5, 1e-6
SAME = 1e-12
# A moment this much above the sum of the other two is not rounding.
IMPOSSIBLE = 1e-9


@record
class TorqueParts:
    """Torque of one revolute joint, as the sum of its parts."""

    joint: Annotated[Text, "The joint."]
    torque: Annotated[Torque, "Torque on the link: gravity, inertia, velocities, payload and hand [N*m]."]
    drive: Annotated[Torque | None, "Torque of the drive at the joint: with rotor and friction, where given [N*m]."]
    gravity: Annotated[Torque, "For the weights of the links [N*m]."]
    inertia: Annotated[Torque, "For the accelerations of the joints [N*m]."]
    velocity: Annotated[Torque, "For their speeds: Coriolis and centrifugal parts [N*m]."]
    payload: Annotated[Torque | None, "For the payload, its weight and its acceleration [N*m]."]
    hand: Annotated[Torque | None, "For the force and moment of the hand, Jᵀ·F [N*m]."]
    rotor: Annotated[Torque | None, "To accelerate the motor's rotor, ratio² times its moment of inertia [N*m]."]
    friction: Annotated[Torque | None, "Against friction of the joint [N*m]."]


@record
class ForceParts:
    """Force of one prismatic joint, as the sum of its parts."""

    joint: Annotated[Text, "The joint."]
    force: Annotated[Force, "Force on the link: all of the following [N]."]
    gravity: Annotated[Force, "For the weights of the links [N]."]
    inertia: Annotated[Force, "For the accelerations of the joints [N]."]
    velocity: Annotated[Force, "For their speeds: Coriolis and centrifugal parts [N]."]
    payload: Annotated[Force | None, "For the payload, its weight and its acceleration [N]."]
    hand: Annotated[Force | None, "For the force and moment of the hand, Jᵀ·F [N]."]


@record
class Torques:
    """Torques and forces of all joints."""

    torques: Annotated[tuple[Torque, ...] | None, "Torques of the revolute joints on their links, in order [N*m]."]
    largest_torque: Annotated[Torque | None, "The largest of them, as a magnitude [N*m]."]
    largest_joint: Annotated[Text | None, "The joint that has it."]
    slide_forces: Annotated[tuple[Force, ...] | None, "Forces of the prismatic joints, in order [N]."]
    drives: Annotated[tuple[Torque, ...] | None, "With rotors and friction of the joints, where given [N*m]."]
    power: Annotated[Power | None, "Power of the joints on their links, where they move [W]."]
    kinetic_energy: Annotated[PotentialEnergy, "Kinetic energy of links and payload [J]."]
    base_force: Annotated[ForceVector, "Force of the base on the arm, in base axes [N]."]
    base_moment: Annotated[TorqueVector, "Moment of the base on the arm about its origin, in base axes [N*m]."]
    joints: Annotated[tuple[TorqueParts, ...] | None, "Parts of the torque of each revolute joint."]
    prismatic: Annotated[tuple[ForceParts, ...] | None, "Parts of the force of each prismatic joint."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def torque(
    arm: Annotated[Arm, "The arm with its masses, from a file."],
    /,
    *,
    angles: Annotated[tuple[Angle, ...], ANGLES] = (),
    slides: Annotated[tuple[Coordinate, ...], SLIDES] = (),
    speeds: Annotated[
        tuple[TurnRate, ...], "Speeds of the revolute joints, at rest unless given, e.g. 1, 2 rad/s."
    ] = (),
    slide_speeds: Annotated[tuple[Speed, ...], "Speeds of the prismatic joints, e.g. 0.1 m/s."] = (),
    accelerations: Annotated[
        tuple[AngularAcceleration, ...], "Accelerations of the revolute joints, e.g. 3, -2 rad/s^2."
    ] = (),
    slide_accelerations: Annotated[tuple[Acceleration, ...], "Of the prismatic joints, e.g. 0.5 m/s^2."] = (),
    payload: Annotated[Mass | None, "A point mass in the hand, at the tip of the tool, e.g. 5 kg."] = None,
    force: Annotated[ForceVector | None, "Force that the hand pushes with, in base axes, e.g. 0, 0, -50 N."] = None,
    moment: Annotated[TorqueVector | None, "Moment that it turns with, in base axes, e.g. 0, 0, 5 N*m."] = None,
    up: Annotated[Direction, "Upwards, in base axes: 0, 1, 0 for a planar arm in a vertical plane."] = UP,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Torques:
    """Torques of an arm's joints for its posture, speeds, accelerations, payload and the force of its hand.

    Equation
    --------
    Newton–Euler from the base outwards and back: f = m·a_C, n = I·α + ω × I·ω + c × f; τ = z·n or z·f; gravity is an
    acceleration of the base. Rotor: ratio²·J·q̈; friction: b·q̇ + c·sign q̇.

    Raises
    ------
    InadmissibleError
        When the arm has no mass, no payload and no force of the hand, or numbers of positions, speeds or accelerations
        are not those of the joints.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 19.13 to 19.15.

    Examples
    --------
    >>> arm = Arm(lengths=(1.0, 1.0), masses=(2.0, 1.0))
    >>> [round(part, 9) for part in torque(arm, angles=(0.0, 0.0), up=(0.0, 1.0, 0.0), gravity=10.0).torques]
    [25.0, 5.0]
    """
    chain = chain_of(arm)
    q = coordinates_of(chain, angles, slides)
    v = _rates(chain, speeds, slide_speeds, ("speeds", "slide-speeds"))
    a = _rates(chain, accelerations, slide_accelerations, ("accelerations", "slide-accelerations"))
    _require_loads(chain, payload, force, moment)
    length = sqrt(dot(up, up))
    require(length > 0.0, "the direction upwards has no length", code="direction", hint="for example 0, 0, 1")
    lift = scale(gravity / length, up)
    links, held = Tree(links_of(chain)), Tree(links_of(chain, masses=False) + _payload(chain, payload or 0.0))
    frames = poses(links, q)
    rest = [0.0] * len(q)
    weights = inverse(links, frames, rest, rest, ground=lift)[0]
    inertia = inverse(links, frames, rest, a)[0]
    velocity = inverse(links, frames, v, rest)[0]
    load = inverse(held, poses(held, q), v, a, ground=lift)[0]
    hand = [dot(x, force or ORIGIN) + dot(w, moment or ORIGIN) for x, w in columns_of(chain, q)]
    parts = list(zip(weights, inertia, velocity, load, hand, strict=True))
    total = [part[0] + part[1] + part[2] + part[3] + part[4] for part in parts]
    given = chain, q, v, a, (payload or 0.0, lift, force, moment)
    whole = _Whole(*given)
    turning = chain.turning
    rotor = [
        joint.rotor_inertia * joint.gear_ratio * joint.gear_ratio * second
        for joint, second in zip(chain.joints, a, strict=True)
    ]
    friction = [_friction(joint, rate) for joint, rate in zip(chain.joints, v, strict=True)]
    driven = any(plain(x) for joint in chain.joints for x in (joint.rotor_inertia, joint.viscous, joint.coulomb))
    alone = single(*q, *v, *a, *total)
    loaded = payload is not None, force is not None or moment is not None
    shown = [(*part[:3], part[3] if loaded[0] else None, part[4] if loaded[1] else None) for part in parts]
    rows = list(zip(chain.names, total, shown, rotor, friction, turning, strict=True))
    turned = [(name, absolute(t)) for name, t, turns in zip(chain.names, total, turning, strict=True) if turns]
    return Torques(
        torques=tuple(t for t, turns in zip(total, turning, strict=True) if turns) or None,
        largest_torque=_largest([size for _, size in turned]),
        largest_joint=max(turned, key=lambda each: plain(each[1]))[0] if turned and alone else None,
        slide_forces=tuple(t for t, turns in zip(total, turning, strict=True) if not turns) or None,
        drives=tuple(row[1] + row[3] + row[4] for row in rows if row[5]) if driven else None,
        power=_sum(t * rate for t, rate in zip(total, v, strict=True)) if speeds or slide_speeds else None,
        kinetic_energy=whole.kinetic,
        base_force=whole.force,
        base_moment=whole.moment,
        joints=tuple(
            TorqueParts(name, t, *((t + r + f,) if driven else NOTHING), *part, *((r, f) if driven else NOTHING * 2))
            for name, t, part, r, f, turns in rows
            if turns
        )
        or None,
        prismatic=tuple(ForceParts(name, t, *part) for name, t, part, _, _, turns in rows if not turns) or None,
        checks=_checks(_Whole(*over_plain(_tuples(given))), total) if alone else (),
        advice=(*limit_advice(chain, q), *_impossible(chain)) if alone else (),
    )


def _rates(
    chain: Chain, turns: "Sequence[float]", travels: "Sequence[float]", words: "tuple[str, str]"
) -> "list[float]":
    """Speeds or accelerations in the order of the joints, zero where none are given."""
    turns = turns or (0.0,) * chain.turning.count(True)
    travels = travels or (0.0,) * chain.turning.count(False)
    return coordinates_of(chain, turns, travels, words)


def _require_loads(chain: Chain, *loads: "Any") -> None:
    heavy = any(plain(joint.mass) or any(map(any, over_plain(joint.tensor))) for joint in chain.joints)
    rotors = any(plain(joint.rotor_inertia) or plain(joint.coulomb) or plain(joint.viscous) for joint in chain.joints)
    if not heavy and not rotors and all(load is None for load in loads):
        raise MissingError("the links have no masses", (("masses",), ("payload",), ("force",)), code="no-masses")


def _tuples(given: "tuple[Any, ...]") -> "tuple[Any, ...]":
    return tuple(tuple(part) if isinstance(part, list) else part for part in given)


def _largest(sizes: "Sequence[float]") -> float | None:
    largest: float | None = None
    for size in sizes:
        largest = size if largest is None else maximum(largest, size)
    return largest


def _sum(numbers: "Any") -> float:
    total: float = 0.0
    for number in numbers:
        total = total + number
    return total


def _friction(joint: "Any", rate: float) -> float:
    """Viscous and dry friction against which a joint moves; none of a joint at rest."""
    forward = joint.coulomb
    backward = forward if joint.coulomb_back is None else absolute(joint.coulomb_back)
    dry = where(rate > 0.0, forward, where(rate < 0.0, -backward, 0.0 * rate))
    total: float = joint.viscous * rate + dry
    return total


def links_of(chain: Chain, *, masses: bool = True) -> "list[Link]":
    """The links as a tree: each frame at its joint, turning with its link, where a table's frame is at the far end."""
    links: list[Link] = []
    rotation, position = about_axis(2, 0.0), ORIGIN
    for number, joint in enumerate(chain.joints):
        turn, twist = about_axis(2, joint.theta), about_axis(0, joint.alpha)
        far = (joint.a, 0.0, joint.d)
        if chain.standard:
            start, place = product(rotation, turn), position
            centroid, tensor = add(far, times(twist, joint.centroid)), _turned(twist, joint.tensor)
            rotation, position = twist, far
        else:
            start, place = product(twist, turn), add((joint.a, 0.0, 0.0), times(twist, (0.0, 0.0, joint.d)))
            centroid, tensor = joint.centroid, joint.tensor
        links.append(
            Link(
                chain.names[number], number - 1, REVOLUTE if chain.turning[number] else PRISMATIC,
                position=place, rotation=start,
                mass=joint.mass if masses else 0.0,
                centroid=centroid,
                tensor=tensor if masses else (ORIGIN, ORIGIN, ORIGIN),
            )
        )  # fmt: skip
    return links


def _turned(rotation: "Any", tensor: "Any") -> "Any":
    return product(product(rotation, tensor), transposed(rotation))


def _payload(chain: Chain, mass: float) -> "list[Link]":
    """The payload, fixed to the last link at the tip of the tool."""
    last = chain.joints[-1]
    tip = chain.tool
    if chain.standard:
        tip = add((last.a, 0.0, last.d), times(about_axis(0, last.alpha), tip))
    return [Link("payload", len(chain.joints) - 1, FIXED, mass=mass, centroid=tip)]


class _Whole:
    """The arm with its payload and the force of its hand in one calculation, against which the parts are compared."""

    def __init__(
        self, chain: Chain, q: "Sequence[float]", v: "Sequence[float]", a: "Sequence[float]", load: "tuple[Any, ...]"
    ) -> None:
        payload, self.lift, force, moment = load
        self.tree = Tree(links_of(chain) + _payload(chain, payload))
        self.q, self.v, self.a = q, v, a
        frames = poses(self.tree, q)
        ground = placed(self.tree, frames)
        loads: list[Any] = [None] * len(self.tree.links)
        if force is not None or moment is not None:
            # what the hand pushes with pushes back on it
            turn, at = ground[-1]
            arm = chain.hand(chain.links(q)).position
            lever = (arm[0] - at[0], arm[1] - at[1], arm[2] - at[2])
            pull = scale(-1.0, force or ORIGIN)
            twist = add(scale(-1.0, moment or ORIGIN), cross(lever, pull))
            loads[-1] = (back(turn, pull), back(turn, twist))
        self.efforts, wrenches = inverse(self.tree, frames, v, a, ground=self.lift, loads=loads)
        turn, at = ground[0]
        self.force = times(turn, wrenches[0][0])
        self.moment = add(times(turn, wrenches[0][1]), cross(at, self.force))
        self.hand = force, moment
        self.chain = chain
        self.kinetic = self.kinetic_at(q, v)

    def kinetic_at(self, q: "Sequence[float]", v: "Sequence[float]") -> float:
        """Kinetic energy in a state."""
        total: float = 0.0
        for link, (omega, _, velocity, _) in zip(
            self.tree.links, sweep(self.tree, poses(self.tree, q), v), strict=True
        ):
            centre = add(velocity, cross(omega, link.centroid))
            total = total + 0.5 * (link.mass * dot(centre, centre) + dot(omega, times(link.tensor, omega)))
        return total

    def energy_at(self, time: float) -> float:
        """Kinetic and potential energy a little before or after, on the motion with these accelerations."""
        q = [x + time * (s + 0.5 * time * t) for x, s, t in zip(self.q, self.v, self.a, strict=True)]
        v = [s + time * t for s, t in zip(self.v, self.a, strict=True)]
        height: float = 0.0
        for link, (turn, at) in zip(self.tree.links, placed(self.tree, poses(self.tree, q)), strict=True):
            height = height + link.mass * dot(self.lift, add(at, times(turn, link.centroid)))
        return self.kinetic_at(q, v) + height


def _checks(whole: _Whole, total: "Sequence[float]") -> "tuple[Check, ...]":
    """The parts beside one calculation of all, and the power beside the rate of the energy."""
    efforts = whole.efforts
    scale_ = max(1e-300, *map(abs, efforts))
    off = max(abs(plain(t) - effort) for t, effort in zip(total, efforts, strict=True)) / scale_
    checks = [Check("parts add to the torques", off <= SAME, off, SAME)]
    if any(whole.v):
        rate = (whole.energy_at(STEP) - whole.energy_at(-STEP)) / (2.0 * STEP)
        force, moment = whole.hand
        columns = columns_of(whole.chain, whole.q)
        pushed = [dot(x, force or ORIGIN) + dot(w, moment or ORIGIN) for x, w in columns]
        shares = [effort * rate_ for effort, rate_ in zip(efforts, whole.v, strict=True)]
        power = sum(shares) - sum(push * rate_ for push, rate_ in zip(pushed, whole.v, strict=True))
        size = max(1e-12, *map(abs, shares))
        gap = abs(power - rate) / size
        checks.append(Check("power is the rate of the energy", gap <= AGREES, gap, AGREES))
    return tuple(checks)


def _impossible(chain: Chain) -> "tuple[Advice, ...]":
    """Links whose moments of inertia no body has; a table may lump moments about one axis alone."""
    names = []
    for name, joint in zip(chain.names, chain.joints, strict=True):
        x, y, z = (plain(joint.tensor[k][k]) for k in range(3))
        if max(x, y, z) * (2.0 - IMPOSSIBLE) > x + y + z:
            names.append(name)
    if not names:
        return ()
    message = f"the moments of inertia of {', '.join(names)} are of no body: one is above the sum of the other two"
    return (Advice("impossible-body", message, severity="note"),)
