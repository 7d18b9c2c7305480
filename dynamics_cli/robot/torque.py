"""Torques of an arm's joints for a motion, a payload and a force of the hand, part by part."""

from dynamics_cli.errors import MissingError, require
from dynamics_cli.numerics.elementary import absolute, maximum, sqrt, where
from dynamics_cli.numerics.elementary import total as total_of
from dynamics_cli.numerics.number import decides, over_plain, plain, single
from dynamics_cli.numerics.trees.newton_euler import inverse
from dynamics_cli.numerics.trees.tree import Tree, poses
from dynamics_cli.numerics.vectors import dot, scale
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
from dynamics_cli.robot.heavy import Loaded, checks_of, impossible, links_of, payload_of
from dynamics_cli.robot.pose import limit_advice
from dynamics_cli.robot.velocities import columns_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

UP = (0.0, 0.0, 1.0)
NOTHING = (None,)


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
    loads = payload or 0.0, lift, force, moment
    parts = _parts(chain, q, v, a, loads)
    total = [part[0] + part[1] + part[2] + part[3] + part[4] for part in parts]
    instant = chain, q, v, a, loads
    whole = Loaded(*instant)
    driven = any(plain(x) for joint in chain.joints for x in (joint.rotor_inertia, joint.viscous, joint.coulomb))
    alone, ordered = single(*q, *v, *a, *total), decides(*total)
    held, pushed = payload is not None, force is not None or moment is not None
    turned, slid = [], []
    for name, joint, turning, effort, part, rate, second in zip(
        chain.names, chain.joints, chain.turning, total, parts, v, a, strict=True
    ):
        shares = (*part[:3], part[3] if held else None, part[4] if pushed else None)
        if not turning:
            slid.append(ForceParts(name, effort, *shares))
            continue
        rotor = joint.rotor_inertia * joint.gear_ratio * joint.gear_ratio * second
        friction = _friction(joint, rate)
        drive = (effort + rotor + friction,) if driven else NOTHING
        turned.append(TorqueParts(name, effort, *drive, *shares, *((rotor, friction) if driven else NOTHING * 2)))
    sizes = [absolute(row.torque) for row in turned]
    return Torques(
        torques=tuple(row.torque for row in turned) or None,
        largest_torque=_largest(sizes),
        largest_joint=max(turned, key=lambda row: plain(absolute(row.torque))).joint if turned and ordered else None,
        slide_forces=tuple(row.force for row in slid) or None,
        drives=tuple(row.drive for row in turned) if driven else None,  # type: ignore[misc]
        power=total_of([t * rate for t, rate in zip(total, v, strict=True)]) if speeds or slide_speeds else None,
        kinetic_energy=whole.kinetic,
        base_force=whole.force,
        base_moment=whole.moment,
        joints=tuple(turned) or None,
        prismatic=tuple(slid) or None,
        checks=checks_of(Loaded(*over_plain(_tuples(instant))), total) if alone else (),
        advice=(*limit_advice(chain, q), *impossible(chain)) if alone else (),
    )


def _parts(
    chain: Chain, q: "list[float]", v: "list[float]", a: "list[float]", loads: "tuple[Any, ...]"
) -> "list[tuple[float, ...]]":
    """Of every joint the parts for weights, accelerations, speeds, the payload and the force of the hand."""
    payload, lift, force, moment = loads
    links, held = Tree(links_of(chain)), Tree(links_of(chain, masses=False) + payload_of(chain, payload))
    frames, still = poses(links, q), [0.0] * len(q)
    weights = inverse(links, frames, still, still, ground=lift)[0]
    inertia = inverse(links, frames, still, a)[0]
    velocity = inverse(links, frames, v, still)[0]
    load = inverse(held, poses(held, q), v, a, ground=lift)[0]
    hand = [dot(x, force or ORIGIN) + dot(w, moment or ORIGIN) for x, w in columns_of(chain, q)]
    return list(zip(weights, inertia, velocity, load, hand, strict=True))


def _rates(
    chain: Chain, turns: "Sequence[float]", travels: "Sequence[float]", words: "tuple[str, str]"
) -> "list[float]":
    """Speeds or accelerations in the order of the joints, zero where none are given."""
    turns = turns or (0.0,) * chain.turning.count(True)
    travels = travels or (0.0,) * chain.turning.count(False)
    return coordinates_of(chain, turns, travels, words)


def _require_loads(chain: Chain, *loads: "Any") -> None:
    heavy = any(plain(joint.mass) or joint.tensor is not None for joint in chain.joints)
    rotors = any(plain(joint.rotor_inertia) or plain(joint.coulomb) or plain(joint.viscous) for joint in chain.joints)
    if not heavy and not rotors and all(load is None for load in loads):
        raise MissingError("the links have no masses", (("masses",), ("payload",), ("force",)), code="no-masses")


def _tuples(parts: "tuple[Any, ...]") -> "tuple[Any, ...]":
    return tuple(tuple(part) if isinstance(part, list) else part for part in parts)


def _largest(sizes: "Sequence[float]") -> float | None:
    largest: float | None = None
    for size in sizes:
        largest = size if largest is None else maximum(largest, size)
    return largest


def _friction(joint: "Any", rate: float) -> float:
    """Viscous and dry friction against which a joint moves; none of a joint at rest."""
    forward = joint.coulomb
    backward = forward if joint.coulomb_back is None else absolute(joint.coulomb_back)
    dry = where(rate > 0.0, forward, where(rate < 0.0, -backward, 0.0 * rate))
    total: float = joint.viscous * rate + dry
    return total
