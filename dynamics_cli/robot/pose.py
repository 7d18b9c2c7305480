"""Pose of an arm: where its hand and every link are for given joint positions."""

from dynamics_cli.errors import worded
from dynamics_cli.numerics.elementary import absolute, atan2, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.orientation.quaternions import of_rotation, upright
from dynamics_cli.numerics.orientation.rotations import Matrix
from dynamics_cli.numerics.orientation.sequences import angles_in_words, angles_of_rotation, sequence_of
from dynamics_cli.numerics.turns import turned
from dynamics_cli.numerics.vectors import length
from dynamics_cli.quantities import (
    Angle,
    AngleTriple,
    Annotated,
    Coordinate,
    Direction,
    PartPosition,
    Quaternion,
    RotationMatrix,
    Size,
    Text,
)
from dynamics_cli.records import Advice, record
from dynamics_cli.robot.arms.chain import Chain, beyond_limits, chain_of, coordinates_of, limits
from dynamics_cli.robot.arms.records import ANGLES, REVOLUTE, SLIDES, Arm

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

# A scalar part below this is rounding of a half turn, of which both signs are right.
HALF_TURN = 1e-9


@record
class LinkPose:
    """One joint and the link after it."""

    joint: Annotated[Text, "The joint."]
    angle: Annotated[Angle | None, "Its angle, of a revolute joint [rad]."]
    travel: Annotated[Coordinate | None, "Its travel, of a prismatic joint [m]."]
    to_limit: Annotated[Angle | None, "From the nearer limit, negative beyond it; of a revolute joint [rad]."]
    travel_to_limit: Annotated[Coordinate | None, "The same of a prismatic joint [m]."]
    joint_position: Annotated[PartPosition, "A point on the joint's axis [m]."]
    axis: Annotated[Direction, "Direction of the joint's axis [-]."]
    position: Annotated[PartPosition, "Origin of the link's frame [m]."]
    rotation_matrix: Annotated[RotationMatrix, "Its columns are the link's axes [-]."]


@record
class Pose:
    """Where the hand is, and every link."""

    position: Annotated[PartPosition, "The hand: the tip of the tool, or the last frame's origin [m]."]
    hand_angle: Annotated[Angle | None, "Angle of the last link to the x axis, of a planar arm [rad]."]
    orientation_angles: Annotated[
        AngleTriple | None, "Angles of the hand in the sequence asked for, of an arm that is not planar [rad]."
    ]
    angle_names: Annotated[Text, "These angles in words."]
    euler_parameters: Annotated[Quaternion, "Euler parameters of the hand, scalar first [-]."]
    rotation_matrix: Annotated[RotationMatrix, "Takes components in hand axes to base axes [-]."]
    distance: Annotated[Size, "Distance of the hand from the origin of the base [m]."]
    links: Annotated[tuple[LinkPose, ...], "Each joint with its link."]
    advice: tuple[Advice, ...] = ()


def pose(
    arm: Annotated[Arm, "The arm, from a file."],
    /,
    *,
    angles: Annotated[tuple[Angle, ...], ANGLES] = (),
    slides: Annotated[tuple[Coordinate, ...], SLIDES] = (),
    sequence: Annotated[
        Text, "Angles to report: XYZ or rpy about the fixed axes, zyx or zyz … about the turned ones."
    ] = "XYZ",
) -> Pose:
    """Forward kinematics: place and orientation of the hand and of every link for given joint positions.

    Equation
    --------
    T = T₁·T₂·…·Tₙ; standard: Tᵢ = Rz(θ)·Tz(d)·Tx(a)·Rx(α); modified: Tᵢ = Rx(α)·Tx(a)·Rz(θ)·Tz(d).

    Raises
    ------
    InadmissibleError
        When the arm is missing or given twice, or the number of joint positions is not that of the joints.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 19.2, 19.3 and 19.8.

    Examples
    --------
    >>> pose(Arm(lengths=(0.5, 0.4)), angles=(0.0, 1.5707963267948966)).position
    (0.5, 0.4, 0.0)
    """
    chain = chain_of(arm)
    coordinates = coordinates_of(chain, angles, slides)
    links = chain.links(coordinates)
    axes = chain.axes(links)
    hand = chain.hand(links)
    order = sequence_of(sequence)
    rotation = hand.rotation
    planar = is_planar(chain)
    flat = planar and plain(rotation[2][2]) == 1.0
    rows = []
    for name, joint, coordinate, axis, link in zip(chain.names, chain.joints, coordinates, axes, links, strict=True):
        turns = joint.type == REVOLUTE
        low, high = limits(joint)
        limited = max(-low, high) < float("inf")
        nearer = min(plain(coordinate) - low, high - plain(coordinate)) if limited and single(coordinate) else None
        rows.append(
            LinkPose(
                joint=name,
                angle=coordinate if turns else None,
                travel=None if turns else coordinate,
                to_limit=nearer if turns else None,
                travel_to_limit=None if turns else nearer,
                joint_position=axis.position,
                axis=axis.z,
                position=link.position,
                rotation_matrix=link.rotation,
            )
        )
    return Pose(
        position=hand.position,
        hand_angle=atan2(rotation[1][0], rotation[0][0]) if planar else None,
        orientation_angles=None if flat else angles_of_rotation(rotation, order).angles,
        angle_names=angles_in_words(order),
        euler_parameters=_parameters(rotation),
        rotation_matrix=rotation,
        distance=length(hand.position),
        links=tuple(rows),
        advice=limit_advice(chain, coordinates) if single(*coordinates) else (),
    )


def _parameters(rotation: Matrix) -> Quaternion:
    """Euler parameters with a scalar part that is not negative, beyond what rounding leaves of a half turn."""
    q = of_rotation(rotation)
    clear = absolute(q[0]) > HALF_TURN
    w, x, y, z = (where(clear, a, b) for a, b in zip(upright(q), q, strict=True))
    return w, x, y, z


def is_planar(chain: Chain) -> bool:
    """Whether every joint turns about, or slides along, the z axis of the base, or against it."""
    return all(turned(plain(joint.alpha))[1] == 0.0 for joint in chain.joints[: -1 if chain.standard else None])


def limit_advice(chain: Chain, coordinates: "Sequence[float]") -> "tuple[Advice, ...]":
    """A caution for each joint beyond a limit."""
    return tuple(
        Advice(
            "beyond-limit",
            worded(
                "joint {name} is {excess} beyond its limit", name=name, excess=(excess, Angle if turns else Coordinate)
            ),
        )
        for name, excess, turns in beyond_limits(chain, coordinates)
    )
