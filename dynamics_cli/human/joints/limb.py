"""The task `limb`: joint forces and moments of a moving limb at one instant, from the ground up."""

from dynamics_cli.errors import require
from dynamics_cli.human.joints.newton import Link, joint_of, muscles_of, up_the_limb
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    AngularAcceleration,
    Annotated,
    Gravity,
    Inertia,
    Mass,
    PartAcceleration,
    PlanarForce,
    PlanarPosition,
    Text,
    Torque,
)
from dynamics_cli.records import Check, record

AGREE = 1e-9


@record
class Segment:
    """A segment at this instant; x forward, y up."""

    name: Annotated[Text, "Its name, e.g. foot."]
    mass: Annotated[Mass, "Its mass, e.g. 1.0275 kg."]
    inertia: Annotated[Inertia, "Moment of inertia about its mass centre, e.g. 0.0042 kg*m^2."]
    centre: Annotated[PlanarPosition, "Its mass centre: forward, up, e.g. 0.93, 0.062 m."]
    joint: Annotated[PlanarPosition, "The joint at its upper end, e.g. 0.878, 0.105 m."]
    acceleration: Annotated[PartAcceleration, "Of its mass centre, e.g. 0.4, -0.2 m/s^2."] = (0.0, 0.0)
    rotation: Annotated[AngularAcceleration, "Angular acceleration, anticlockwise, e.g. -1.5 rad/s^2."] = 0.0


@record
class OuterForce:
    """The force on the far end of the limb: of the ground on the foot, of a load on the hand."""

    force: Annotated[PlanarForce, "The force: forward, up, e.g. -60, 710 N."]
    at: Annotated[PlanarPosition, "Where it acts, e.g. 0.95, 0 m."]


@record
class JointAction:
    """Net force and moment that a joint exerts on the segment below or beyond it."""

    name: Annotated[Text, "The joint."]
    force: Annotated[PlanarForce, "Force on the segment: forward, up [N]."]
    moment: Annotated[Torque, "Moment on the segment, anticlockwise with forward to the right [N·m]."]
    muscles: Annotated[Text, "Which muscles give it."]


@record
class Limb:
    """Joint forces and moments of a limb."""

    joints: Annotated[tuple[JointAction, ...], "The joints, from the far end to the body."]
    largest: Annotated[Torque, "The largest joint moment [N·m]."]
    largest_joint: Annotated[Text, "Its joint."]
    checks: tuple[Check, ...] = ()


def limb(
    *,
    segments: Annotated[tuple[Segment, ...], "The segments, from the foot or hand to the body."],
    ground: Annotated[OuterForce | None, "Force on the far end, of the ground or a load; none if it swings."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Limb:
    """Joint forces and moments of a limb at one instant, by the equations of Newton and Euler from the far end.

    Equation
    --------
    F_i = m_i·(a_i + g) − F_(i−1), M_i = I_i·α_i − (r_i − c_i)×F_i − (r_(i−1) − c_i)×F_(i−1) − M_(i−1), where
    what acts on the far end of a segment is opposite to what the joint exerts on the one before.

    Returns
    -------
    Limb
        Force and moment of each joint on the segment below it.

    Raises
    ------
    InadmissibleError
        When a mass is not above zero, or no segment is given.

    Notes
    -----
    Axes: x forward, y up; angles and moments anticlockwise. The moment of everything beyond each joint in one sum is a
    check of the recursion.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 20.7 to 20.9.

    Examples
    --------
    >>> foot = Segment("foot", 1.0275, 0.0042, (0.93, 0.062), (0.878, 0.105), (0.4, -0.2), -1.5)
    >>> answer = limb(segments=(foot,), ground=OuterForce((-60.0, 710.0), (0.95, 0.0)), gravity=9.81)
    >>> round(answer.joints[0].moment, 7)
    -44.2951647
    """
    require(len(segments) > 0, "no segment is given", code="missing",
            hint='such as --segment "name=foot, mass=1.03 kg, inertia=0.0042 kg*m^2, centre=0.93, 0.062 m, '
            'joint=0.878, 0.105 m"')  # fmt: skip
    for segment in segments:
        require(segment.mass > 0.0, "the mass of the {name}, {mass}, is not above zero", name=segment.name,
                mass=(segment.mass, Mass), code="mass")  # fmt: skip
    links = [
        Link(s.mass, s.inertia, s.centre, s.joint, s.acceleration, s.rotation) for s in segments
    ]  # fmt: skip
    outer = (ground.force, ground.at) if ground else ((0.0, 0.0), segments[0].centre)
    actions = up_the_limb(links, *outer, gravity)
    joints = []
    for segment, action in zip(segments, actions, strict=True):
        name = joint_of(segment.name)
        joints.append(JointAction(name, action[0], action[1], muscles_of(name, float(plain(action[1])))))
    largest = max(joints, key=lambda joint: abs(float(plain(joint.moment))))
    return Limb(
        joints=tuple(joints),
        largest=absolute(largest.moment),
        largest_joint=largest.name,
        checks=(_check(links, outer, actions, gravity),),
    )


def _check(
    links: "list[Link]",
    outer: "tuple[tuple[float, float], tuple[float, float]]",
    actions: "list[tuple[tuple[float, float], float]]",
    gravity: float,
) -> Check:
    """The moment at the last joint, of everything beyond it in one sum."""
    x, y = links[-1].joint
    (push, lift), (at_x, at_y) = outer
    turn = (at_x - x) * lift - (at_y - y) * push
    size = abs(float(plain(turn)))
    for link in links:
        forward, up = link.mass * link.acceleration[0], link.mass * (link.acceleration[1] + gravity)
        part = link.inertia * link.rotation + (link.centre[0] - x) * up - (link.centre[1] - y) * forward
        turn = turn - part
        size += abs(float(plain(part)))
    apart = abs(float(plain(turn)) + float(plain(actions[-1][1]))) / (size or 1.0)
    return Check("moment of everything beyond the last joint", apart <= AGREE, apart, AGREE)
