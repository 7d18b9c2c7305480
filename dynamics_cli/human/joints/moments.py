"""The task `moments`: net joint forces and moments of a body in a posture, with loads in its hands."""

from dynamics_cli.errors import UsageError, judge, require, worded
from dynamics_cli.human.bodies.figure import Figure, Flexions, Inclinations, side_view
from dynamics_cli.human.bodies.person import Height, Lengths, provenance
from dynamics_cli.human.bodies.tables import Sex, plain_name
from dynamics_cli.human.joints.muscles import Muscle, MuscleLoad, muscle_loads
from dynamics_cli.numerics.elementary import absolute, hypot
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Angle,
    AngularAcceleration,
    Annotated,
    Force,
    Gravity,
    Length,
    Mass,
    PartAcceleration,
    PlanarForce,
    Ratio,
    Text,
    Torque,
)
from dynamics_cli.records import Advice, Check, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    Action = tuple[float, float, float, float, float]

ARM = ("upper arm", "forearm", "hand")
# What each joint carries, from its upper side: the segments beyond it, and whether the load in the hands is there.
BEYOND = {
    "neck": (("head",), False),
    "shoulder": (ARM, True),
    "elbow": (("forearm", "hand"), True),
    "wrist": (("hand",), True),
    "hip": (("trunk", "head", *ARM), True),
    "knee": (("thigh", "trunk", "head", *ARM), True),
    "ankle": (("shank", "thigh", "trunk", "head", *ARM), True),
}
# The muscles that turn what is beyond the joint backwards (anticlockwise, seen with forward to the right), the others,
# and the sign of what is called positive: extension of legs, back and neck, flexion of the arm.
TURNS = {
    "neck": ("extensors", "flexors", 1.0), "shoulder": ("flexors", "extensors", 1.0),
    "elbow": ("flexors", "extensors", 1.0), "wrist": ("flexors", "extensors", 1.0),
    "hip": ("extensors", "flexors", 1.0), "knee": ("flexors", "extensors", -1.0),
    "ankle": ("plantar flexors", "dorsiflexors", 1.0),
}  # fmt: skip
AGREE = 1e-9
# A moment below this share of the weight, on a lever of a metre, is rounding: no muscle is at work.
ROUNDING = 1e-12


@record
class SegmentMotion:
    """How a segment is accelerated at this instant."""

    segment: Annotated[Text, "Its name, e.g. trunk."]
    acceleration: Annotated[PartAcceleration, "Of its mass centre: forward, up, e.g. 0.5, 1.2 m/s^2."]
    rotation: Annotated[AngularAcceleration, "Angular acceleration, anticlockwise with forward to the right."] = 0.0


@record
class GroundForce:
    """The force of the ground as measured, on both feet."""

    force: Annotated[PlanarForce, "Force of the ground on the feet: forward, up, e.g. -20, 850 N."]
    at: Annotated[Length, "Where it acts, forward of the ankles, e.g. 12 cm."]


@record
class JointLoad:
    """Net force and moment at a joint, both sides together."""

    name: Annotated[Text, "The joint."]
    moment: Annotated[Torque, "Moment of the muscles, both sides: extension of legs and neck, flexion of arms [N·m]."]
    side: Annotated[Torque, "The same of one side, of a pair [N·m]."]
    muscles: Annotated[Text, "Which muscles give it."]
    force: Annotated[PlanarForce, "Force on the part above or beyond: forward, up, both sides [N]."]
    below: Annotated[Torque | None, "Moment from the other side, with the ground forces [N·m]."]


@record
class JointMoments:
    """Joint forces and moments of a posture."""

    joints: Annotated[tuple[JointLoad, ...], "The joints."]
    largest: Annotated[Torque, "The largest joint moment, both sides [N·m]."]
    largest_joint: Annotated[Text, "Its joint."]
    muscles: Annotated[tuple[MuscleLoad, ...], "Single equivalent muscles."]
    muscle_force: Annotated[Force | None, "Force of the first muscle [N]."]
    compression: Annotated[Force | None, "Compression of its joint [N]."]
    shear: Annotated[Force | None, "Shear of its joint [N]."]
    ground_force: Annotated[PlanarForce, "Force of the ground on both feet: forward, up [N]."]
    pressure_centre: Annotated[Length, "Where it acts, forward of the ankles [m]."]
    toe_margin: Annotated[Length, "How far that is behind the toes [m]."]
    friction: Annotated[Ratio, "Friction that the feet need [-]."]
    residual_force: Annotated[Force | None, "With a measured force: what is missing at the root [N]."]
    residual_moment: Annotated[Torque | None, "The moment missing at the hips [N·m]."]
    table: Annotated[Text, "Where the table of segments comes from."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def moments(
    *,
    mass: Annotated[Mass, "Mass of the body, e.g. 75 kg."],
    sex: Annotated[Sex | None, "Male or female: which part of the table."] = None,
    load: Annotated[Mass, "What both hands hold at the knuckles, e.g. 15 kg."] = 0.0,
    muscles: Annotated[tuple[Muscle, ...] | None, "Single muscles that stand for all of a joint."] = None,
    hand_force: Annotated[PlanarForce | None, "Further force on the hands: forward, up, e.g. -120, 0 N."] = None,
    load_acceleration: Annotated[Acceleration, "Of the load, upwards, e.g. 1.5 m/s^2."] = 0.0,
    pose: Annotated[Flexions | Inclinations, "Joint angles, or inclinations of the segments."] = Flexions(),  # noqa: B008
    size: Annotated[Lengths | Height, "Lengths of segments."] = Lengths(),  # noqa: B008
    rail: Annotated[bool, "The hands also rest on something that pushes with an unknown force."] = False,
    ground: Annotated[GroundForce | None, "The force of the ground, where it was measured."] = None,
    motions: Annotated[tuple[SegmentMotion, ...] | None, "Accelerations of segments; at rest if left out."] = None,
    ankle_height: Annotated[Length, "Ankle joint above the sole, e.g. 8 cm."] = 0.08,
    heel: Annotated[Length, "Ankle joint in front of the heel, e.g. 6 cm."] = 0.06,
    foot_inclination: Annotated[Angle, "Foot, from heel to toe, negative on tiptoe, e.g. -30 deg."] = 0.0,
    any_posture: Annotated[bool, "Take joint angles beyond what people reach."] = False,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> JointMoments:
    """Net joint forces and moments of a standing body, with a load in the hands, and the force of a single muscle.

    Equation
    --------
    M = −Σ (r − r_joint) × (m·g − m·a) + Σ I·α over everything beyond the joint, and from the ground up the same.

    Returns
    -------
    JointMoments
        Moments and forces of the joints, muscle forces, the force of the ground and where it acts.

    Raises
    ------
    InadmissibleError
        When the body would topple, when hands on a rail leave the forces open, or several muscles share a joint.

    Notes
    -----
    Net moments say what muscles do together, not what each of them does; muscles that pull against each other raise
    the forces of joints beyond what is given here. With a measured force the moments of the legs come from the ground
    up, those of the hips and above from the hands down, and what does not agree is the residual.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 20.6 to 20.9.

    Examples
    --------
    >>> lengths = Lengths(
    ...     head=0.24, trunk=0.6, shoulder=0.5, upper_arm=0.28, forearm=0.27, hand=0.085,
    ...     thigh=0.42, shank=0.43, foot=0.26,
    ... )
    >>> answer = moments(mass=75.0, sex=Sex("male"), size=lengths, pose=Flexions(hip_flexion=0.5), load=10.0)
    >>> answer.largest_joint, round(answer.largest, 3)
    ('ankle', 63.042)
    """
    figure = side_view(mass, sex, size, pose, ankle_height, heel, foot_inclination, any_posture=any_posture)
    actions = _actions(figure, load, load_acceleration, hand_force, motions, gravity)
    forward, up, turn = _total([*actions.values()], (0.0, 0.0))
    if rail:
        _refuse_the_rail(figure, up, turn, known=hand_force is not None)
    # the force of the ground acts where nothing is left to turn the body
    push, pressure = (0.0 - forward, 0.0 - up), turn / up
    if ground is None:
        _refuse_toppling(figure, pressure, load)
    at, force = (pressure, push) if ground is None else (ground.at, ground.force)
    under = (at, 0.0, *force, 0.0)
    joints = tuple(_joint(name, figure, actions, under, measured=ground is not None) for name in BEYOND)
    loads = muscle_loads(muscles or (), figure, {joint.name: joint for joint in joints})
    largest = max(joints, key=lambda joint: abs(float(plain(joint.moment))))
    first = loads[0] if loads else None
    hip = next(joint for joint in joints if joint.name == "hip")
    return JointMoments(
        joints=joints,
        largest=absolute(largest.moment),
        largest_joint=largest.name,
        muscles=loads,
        muscle_force=None if first is None else first.force,
        compression=None if first is None else first.compression,
        shear=None if first is None else first.shear,
        ground_force=force,
        pressure_centre=at,
        toe_margin=figure.joints["toe"][0] - at,
        friction=absolute(force[0]) / force[1],
        residual_force=None if ground is None else hypot(force[0] - push[0], force[1] - push[1]),
        residual_moment=None if ground is None or hip.below is None else hip.below - hip.moment,
        table=provenance("de-leva", sex),
        checks=() if ground is not None else _both_sides(joints, mass * gravity),
        advice=_advice(loads),
    )


def _actions(
    figure: Figure, load: float, load_acceleration: float, hand_force: "tuple[float, float] | None",
    motions: "tuple[SegmentMotion, ...] | None", gravity: float,
) -> "dict[str, Action]":  # fmt: skip
    """Weight and inertia force of each segment and of the load: place forward and up, force, couple."""
    require(load >= 0.0, "the load of {load} is below zero", load=(load, Mass), code="load")
    moving = {}
    for motion in motions or ():
        name = plain_name(motion.segment)
        if name not in {part.name for part in figure.parts}:
            raise UsageError(
                f"there is no segment {motion.segment!r}", code="segment", parameter="motions",
                hint="name one of " + ", ".join(part.name for part in figure.parts),
            )  # fmt: skip
        moving[name] = motion
    actions: dict[str, Action] = {}
    for part in figure.parts:
        motion_here = moving.get(part.name)
        forward, up = motion_here.acceleration if motion_here else (0.0, 0.0)
        couple = -part.moments[1] * motion_here.rotation if motion_here else 0.0
        actions[part.name] = (
            part.centre[0], part.centre[2], -part.mass * forward, -part.mass * (gravity + up), couple,
        )  # fmt: skip
    knuckle = figure.joints["knuckle"]
    extra = hand_force or (0.0, 0.0)
    actions["load"] = knuckle[0], knuckle[2], extra[0], extra[1] - load * (gravity + load_acceleration), 0.0
    return actions


def _total(actions: "list[Action]", about: "tuple[float, float]") -> "tuple[float, float, float]":
    """Sum of forces and their moment about a point, anticlockwise."""
    forward = up = turn = 0.0
    for x, z, push, lift, couple in actions:
        forward, up = forward + push, up + lift
        turn = turn + ((x - about[0]) * lift - (z - about[1]) * push + couple)
    return forward, up, turn


def _joint(name: str, figure: Figure, actions: "dict[str, Action]", under: "Action", *, measured: bool) -> JointLoad:
    segments, carries = BEYOND[name]
    at = figure.joints[name][0], figure.joints[name][2]
    forward, up, turn = _total([actions[one] for one in (*segments, *(["load"] if carries else []))], at)
    backwards, forwards, sign = TURNS[name]
    moment, force = sign * (0.0 - turn), (0.0 - forward, 0.0 - up)
    below = None
    if name in ("hip", "knee", "ankle"):
        lower = [one for one in ("foot", "shank", "thigh") if one not in segments]
        forward, up, turn = _total([*(actions[one] for one in lower), under], at)
        below = sign * turn
        if measured and name != "hip":
            moment, force = below, (forward, up)
    turning = float(plain(moment)) * sign
    idle = abs(turning) <= ROUNDING * abs(float(plain(under[3])))
    return JointLoad(
        name=name,
        moment=moment,
        side=moment if name == "neck" else 0.5 * moment,
        muscles="none" if idle else backwards if turning > 0.0 else forwards,
        force=force,
        below=below,
    )


def _refuse_toppling(figure: Figure, pressure: float, load: float) -> None:
    """Nobody stands at rest with the centre of pressure beside the feet."""
    ends = [figure.joints[name] for name in ("heel", "toe")]
    floor = [at[0] for at in ends if abs(float(plain(at[2]))) < 0.02]
    back, front = (pick(floor, key=lambda x: float(plain(x))) for pick in (min, max))
    what = "with the load the body" if float(plain(load)) > 0.0 else "the body"
    judge(
        pressure <= front,
        "{what} topples forward: the force of the ground would have to act {ahead} ahead of the toes",
        what=what, ahead=(pressure - front, Length), code="topples", results=("pressure_centre",),
        hint="lean back, bend the knees, or give the support that holds it as --hand-force",
    )  # fmt: skip
    judge(
        pressure >= back,
        "{what} topples backward: the force of the ground would have to act {behind} behind the heels",
        what=what, behind=(back - pressure, Length), code="topples", results=("pressure_centre",),
        hint="lean forward, or give the support that holds it as --hand-force; a seat is not modelled",
    )  # fmt: skip


def _refuse_the_rail(figure: Figure, up: float, turn: float, *, known: bool) -> None:
    """Feet and hands together leave one force open; its span follows from where the feet may carry."""
    if known:
        raise UsageError(
            "--rail is for an unknown force, --hand-force for a known one", code="rail", parameter="rail",
            hint="leave out --rail",
        )  # fmt: skip
    hands = float(plain(figure.joints["knuckle"][0]))
    weight, turning = float(plain(up)), float(plain(turn))
    lifts = []
    for end in ("heel", "toe"):
        x = float(plain(figure.joints[end][0]))
        # the rail lifts at the hands, the ground carries the rest at x
        if abs(hands - x) > 1e-9:
            lifts.append((weight * x - turning) / (hands - x))
    low, high = min(lifts), max(lifts)
    require(
        False,
        "two feet and two hands on a rail leave the forces open, a family of one parameter: pushing straight up, the "
        "rail may carry anything from {low} to {high}", low=(low, Force), high=(high, Force), code="undetermined",
        hint="measure the force on the hands and give it as --hand-force",
    )  # fmt: skip


def _both_sides(joints: "tuple[JointLoad, ...]", weight: float) -> "tuple[Check, ...]":
    """Moments of hip, knee and ankle from above and from the ground up are the same."""
    apart = max(
        abs(float(plain(joint.moment)) - float(plain(joint.below))) for joint in joints if joint.below is not None
    ) / float(plain(weight))
    return (Check("moments from above and from the ground", apart <= AGREE, apart, AGREE),)


def _advice(loads: "tuple[MuscleLoad, ...]") -> "tuple[Advice, ...]":
    """A lever is usually that of the extensors of legs and back and of the flexors of arms: say where others pull."""
    usual = {name: backwards if sign > 0.0 else forwards for name, (backwards, forwards, sign) in TURNS.items()}
    others = []
    for load in loads:
        joint = "hip" if load.joint == "back" else load.joint
        if load.muscles not in (usual[joint], "none"):
            words = worded("the moment at the {joint} is one of the {muscles}: the lever must be theirs",
                           joint=load.joint, muscles=load.muscles)  # fmt: skip
            others.append(Advice("other-muscles", words, severity="note"))
    return tuple(others)
