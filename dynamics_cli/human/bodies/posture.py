"""The task `posture`: stick figure, mass centre, inertia and balance of a body in a posture."""

from dynamics_cli.errors import require, worded
from dynamics_cli.human.bodies.centres import JointCentre, from_centres
from dynamics_cli.human.bodies.figure import Figure, Flexions, Inclinations, side_view
from dynamics_cli.human.bodies.person import Height, Lengths, provenance
from dynamics_cli.human.bodies.tables import Sex
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, Inertia, InertiaTensor, Length, Mass, SpacePosition, Text
from dynamics_cli.records import Advice, Check, record

ARM = ("upper arm", "forearm", "hand")


@record
class Joint:
    """Where a joint or an end is."""

    name: Annotated[Text, "The joint."]
    at: Annotated[SpacePosition, "Forward, left, up [m]."]


@record
class PlacedSegment:
    """A segment in its place."""

    name: Annotated[Text, "The segment."]
    mass: Annotated[Mass, "Its mass; of a side view that of both [kg]."]
    centre: Annotated[SpacePosition, "Its mass centre: forward, left, up [m]."]


@record
class Posture:
    """A body in a posture."""

    centre: Annotated[SpacePosition, "Mass centre: forward, left, up, from the floor below the ankles [m]."]
    height: Annotated[Length, "Height of the mass centre above the floor [m]."]
    inertia: Annotated[Inertia, "Moment of inertia about the mass centre and the left-right axis [kg*m^2]."]
    gyration: Annotated[Length, "Radius of gyration about the mass centre and the left-right axis [m]."]
    ankle_inertia: Annotated[Inertia | None, "The same about the ankles: of the body as a pendulum [kg*m^2]."]
    tensor: Annotated[InertiaTensor | None, "Inertia tensor about the mass centre, axes forward, left, up [kg*m^2]."]
    balance: Annotated[Text | None, "Whether the mass centre is over the feet."]
    toe_margin: Annotated[Length | None, "How far the mass centre is behind the toes [m]."]
    heel_margin: Annotated[Length | None, "How far it is in front of the heels [m]."]
    joints: Annotated[tuple[Joint, ...], "The joints."]
    segments: Annotated[tuple[PlacedSegment, ...], "The segments."]
    table: Annotated[Text, "Where the table of segments comes from."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def posture(
    *,
    mass: Annotated[Mass, "Mass of the body, e.g. 75 kg."],
    sex: Annotated[Sex | None, "Male or female: which part of the table."] = None,
    pose: Annotated[Flexions | Inclinations, "Joint angles, or inclinations of the segments."] = Flexions(),  # noqa: B008
    size: Annotated[Lengths | Height, "Lengths of segments; with joint centres none."] = Lengths(),  # noqa: B008
    ankle_height: Annotated[Length, "Ankle joint above the sole, e.g. 8 cm."] = 0.08,
    heel: Annotated[Length, "Ankle joint in front of the heel, e.g. 6 cm."] = 0.06,
    foot_inclination: Annotated[Angle, "Foot, from heel to toe, negative on tiptoe, e.g. -30 deg."] = 0.0,
    hip_width: Annotated[Length | None, "Between the hip joints, for the whole tensor, e.g. 17 cm."] = None,
    shoulder_width: Annotated[Length | None, "Between the shoulder joints, for the whole tensor, e.g. 36 cm."] = None,
    centres: Annotated[
        tuple[JointCentre, ...] | None, "Joint centres measured, in place of lengths and angles."
    ] = None,
    any_posture: Annotated[bool, "Take joint angles beyond what people reach."] = False,
) -> Posture:
    """Mass centre, moments of inertia and balance of a human body in a posture.

    Equation
    --------
    r = Σ m_i·r_i/Σ m_i, I = Σ (I_i + m_i·(d_i²·1 − d_i d_iᵀ)) about the mass centre.

    Returns
    -------
    Posture
        The mass centre from the floor below the ankles, inertia, the margin over the feet, joints and segments.

    Raises
    ------
    InadmissibleError
        When an angle is beyond what people reach, or a length or mass is not above zero.

    Notes
    -----
    In the side view left and right are alike; the whole tensor needs the widths at hips and shoulders, arms and legs
    in planes of their own beside it. Joint centres may lie anywhere in space, each side on its own.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 20.4 and 20.5; de Leva 1996, table 4.

    Examples
    --------
    >>> lengths = Lengths(
    ...     head=0.24, trunk=0.6, shoulder=0.5, upper_arm=0.28, forearm=0.27, hand=0.085,
    ...     thigh=0.42, shank=0.43, foot=0.26,
    ... )
    >>> answer = posture(mass=75.0, sex=Sex("male"), size=lengths)
    >>> round(answer.height, 6), round(answer.inertia, 6)
    (0.999856, 12.079128)
    """
    if centres:
        figure = from_centres(mass, sex, centres)
    else:
        figure = side_view(
            mass, sex, size, pose, ankle_height, heel, foot_inclination, any_posture=any_posture
        )  # fmt: skip
    sides = None if centres else _sides(figure, hip_width, shoulder_width)
    whole = figure if centres else sides
    centre = figure.centre
    back, front = _feet(figure)
    ahead = None if front is None else front - centre[0]
    behind = None if back is None else centre[0] - back
    ankle = figure.joints.get("ankle")
    inertia = figure.tensor()[1][1]
    return Posture(
        centre=centre,
        height=centre[2],
        inertia=inertia,
        gyration=sqrt(inertia / figure.mass),
        ankle_inertia=None if ankle is None else inertia + figure.mass * (
            (centre[0] - ankle[0]) * (centre[0] - ankle[0]) + (centre[2] - ankle[2]) * (centre[2] - ankle[2])
        ),
        tensor=None if whole is None else whole.tensor(),
        balance=_balance(ahead, behind),
        toe_margin=ahead,
        heel_margin=behind,
        joints=tuple(Joint(name, at) for name, at in figure.joints.items()),
        segments=tuple(PlacedSegment(part.name, part.mass, part.centre) for part in figure.parts),
        table=provenance("de-leva", sex),
        checks=(_tensor_check(figure),),
        advice=_advice(figure, mass, whole is not None),
    )  # fmt: skip


def _feet(figure: Figure) -> "tuple[float | None, float | None]":
    """From where to where the feet touch the floor, forward."""
    heels = [at for name, at in figure.joints.items() if name.endswith("heel")]
    toes = [at for name, at in figure.joints.items() if name.endswith("toe")]
    if not heels or not toes:
        return None, None
    floor = min(float(plain(at[2])) for at in heels + toes)
    touching = [at[0] for at in heels + toes if float(plain(at[2])) < floor + 0.02]
    return min(touching, key=lambda x: float(plain(x))), max(touching, key=lambda x: float(plain(x)))


def _balance(ahead: "float | None", behind: "float | None") -> "str | None":
    if ahead is None or behind is None:
        return None
    if float(plain(ahead)) < 0.0:
        return "topples forward: the mass centre is ahead of the toes"
    if float(plain(behind)) < 0.0:
        return "topples backward: the mass centre is behind the heels"
    return "the mass centre is over the feet"


def _sides(figure: Figure, hip_width: "float | None", shoulder_width: "float | None") -> "Figure | None":
    """The figure with its limbs apart on both sides, for the whole tensor."""
    if hip_width is None or shoulder_width is None:
        return None
    for width in (hip_width, shoulder_width):
        require(width >= 0.0, "a width of {width} is below zero", width=(width, Length), code="width")
    parts = []
    for part in figure.parts:
        parts += part.split(shoulder_width if part.name in ARM else hip_width)
    return Figure(figure.joints, parts)


def _tensor_check(figure: Figure) -> Check:
    """No segment has a moment above the sum of its other two."""
    excess = max(2.0 * max(m) - sum(m) for m in ([float(plain(x)) for x in part.moments] for part in figure.parts))
    return Check("moments of every segment", excess <= 1e-12, excess, 0.0)


def _advice(figure: Figure, mass: float, whole: bool) -> "tuple[Advice, ...]":
    advice = []
    lost = mass - figure.mass
    if abs(float(plain(lost))) > 1e-3 * float(plain(mass)):
        words = worded("the segments are {lost} short of the body's mass", lost=(lost, Mass))
        advice.append(Advice("mass", words, remedy="give every joint centre"))
    if not whole:
        advice.append(Advice(
            "width", "the tensor about all axes is left out: the side view does not say how wide the body is",
            severity="note", remedy="give --hip-width and --shoulder-width",
        ))  # fmt: skip
    return tuple(advice)
