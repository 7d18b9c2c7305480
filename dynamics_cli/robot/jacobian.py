"""Jacobian of an arm: velocities of the hand for those of its joints, and what it cannot do."""

from math import hypot, prod

from dynamics_cli.numerics.number import over_plain
from dynamics_cli.numerics.orientation.rotations import transposed
from dynamics_cli.numerics.singular_values import Singular
from dynamics_cli.numerics.vectors import Vector, dot, subtract, times
from dynamics_cli.quantities import (
    Angle,
    AngularVelocity,
    Annotated,
    Coordinate,
    Direction,
    Force,
    ForceVector,
    PartPosition,
    Ratio,
    Size,
    Speed,
    Text,
    Torque,
    TorqueVector,
    TurnRate,
    Velocity,
)
from dynamics_cli.records import Advice, Check, Choice, Measured, record
from dynamics_cli.robot.arms.chain import Chain, chain_of, coordinates_of
from dynamics_cli.robot.arms.records import ANGLES, SLIDES, Arm
from dynamics_cli.robot.inverse.structures import Margins, margins, structure_or_none
from dynamics_cli.robot.pose import limit_advice
from dynamics_cli.robot.velocities import (
    CLOSE,
    NOTHING,
    SINGULAR,
    Rank,
    chosen_rows,
    columns_of,
    determinant,
    matrix_of,
    rank_of,
    without_rounding,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.robot.velocities import Columns

# A part of a direction below this is rounding.
PART = 1e-9
WHY = {
    "elbow": "the elbow is straight or folded",
    "wrist": "the outer axes of the wrist are in line",
    "shoulder": "the wrist centre is over the first axis",
}
# Step of the difference quotient that the columns are compared with, and what it leaves.
STEP, AGREES = 1e-6, 1e-8


class AxesOf(Choice):
    """Whose axes the components are along."""

    names = ("base", "hand")
    aliases = {"ground": "base", "world": "base", "tool": "hand", "body": "hand"}  # noqa: RUF012


IN_BASE = AxesOf("base")


@record
class Column:
    """What one joint does to the hand."""

    joint: Annotated[Text, "The joint."]
    linear: Annotated[PartPosition | None, "Velocity of the hand for a joint that turns at 1 rad/s: a length [m]."]
    slide: Annotated[Direction | None, "The same of a prismatic joint, per speed of the joint [-]."]
    angular: Annotated[Direction, "Angular velocity of the hand, per speed of the joint [-]."]


@record
class EllipsoidAxis:
    """One axis of the velocity and force ellipsoids of the hand."""

    direction: Annotated[Direction, "Its direction [-]."]
    velocity: Annotated[Size, "Speed of the hand for joint speeds whose squares add to (1 rad/s)²: a length [m]."]
    force: Annotated[Measured | None, "Force of the hand for joint torques whose squares add to (1 N·m)² [1/m]."]


@record
class Jacobian:
    """The Jacobian, its singular values and verdict."""

    verdict: Annotated[Text, "Whether the arm is singular here, and what of it."]
    determinant: Annotated[Measured | None, "Determinant of the rows that the arm can choose, where square."]
    manipulability: Annotated[Measured | None, "√det(J·Jᵀ) of the linear rows, or √det(Jᵀ·J) of fewer joints."]
    shoulder_factor: Annotated[Size | None, "Distance of the wrist centre from the shoulder singularity [m]."]
    elbow_factor: Annotated[Angle | None, "Angle of the elbow from straight or folded [rad]."]
    wrist_factor: Annotated[Angle | None, "Angle of the wrist from having its outer axes in line [rad]."]
    nearness: Annotated[Ratio, "Smallest singular value over the largest, lengths as shares of the arm's size [-]."]
    lost_direction: Annotated[Direction | None, "Where singular: the hand cannot move this way without turning [-]."]
    lost_turn: Annotated[Direction | None, "Where singular: it cannot turn about this with its place held [-]."]
    idle: Annotated[
        tuple[Ratio, ...] | None,
        "Joint speeds that leave the hand at rest, where singular or redundant [-].",
    ]
    position: Annotated[PartPosition, "The hand [m]."]
    velocity: Annotated[Velocity | None, "Velocity of the hand at the joint speeds given [m/s]."]
    angular_velocity: Annotated[AngularVelocity | None, "Angular velocity of the hand at these speeds [rad/s]."]
    torques: Annotated[tuple[Torque, ...] | None, "Torques of the revolute joints for the force given [N*m]."]
    slide_forces: Annotated[tuple[Force, ...] | None, "Forces of the prismatic joints, likewise [N]."]
    columns: Annotated[tuple[Column, ...], "The columns, joint by joint."]
    speed_ratios: Annotated[
        tuple[Size, ...] | None,
        "Speeds of the hand for joint speeds whose squares add to (1 rad/s)², the largest first: lengths [m].",
    ]
    ellipsoid: Annotated[
        tuple[EllipsoidAxis, ...] | None, "Axes of the velocity ellipsoid, the longest first, of an arm without slides."
    ]
    angular_values: Annotated[tuple[Ratio, ...], "Singular values of the angular rows [-]."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def jacobian(
    arm: Annotated[Arm, "The arm, from a file."],
    /,
    *,
    angles: Annotated[tuple[Angle, ...], ANGLES] = (),
    slides: Annotated[tuple[Coordinate, ...], SLIDES] = (),
    axes: Annotated[AxesOf, "Axes of all vectors: those of the base, or of the hand."] = IN_BASE,
    speeds: Annotated[
        tuple[TurnRate, ...], "Speeds of the revolute joints, for the hand's velocity, e.g. 1, 2 rad/s."
    ] = (),
    slide_speeds: Annotated[tuple[Speed, ...], "Speeds of the prismatic joints, e.g. 0.1 m/s."] = (),
    force: Annotated[
        ForceVector | None, "Force that the hand is to push with, in these axes, e.g. 0, 0, -50 N."
    ] = None,
    moment: Annotated[TorqueVector | None, "Moment that it is to turn with, e.g. 0, 0, 5 N*m."] = None,
) -> Jacobian:
    """Jacobian of the hand, its singular values, linear and angular apart, and which motions are lost.

    Equation
    --------
    Revolute: v = z × (p − o), ω = z; prismatic: v = z, ω = 0; torques τ = Jᵀ·(F, M).

    Raises
    ------
    InadmissibleError
        When the arm is missing or given twice, or numbers of positions or speeds are not those of the joints.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 19.5 and 19.12; T. Yoshikawa,
    Manipulability of robotic mechanisms, Int. J. Robotics Research 4 (1985) 3.

    Examples
    --------
    >>> answer = jacobian(Arm(lengths=(0.5, 0.4)), angles=(0.0, 1.5707963267948966))
    >>> round(answer.determinant.value, 12), answer.verdict
    (0.2, 'regular')
    """
    chain: Chain = over_plain(chain_of(arm))
    coordinates = coordinates_of(chain, over_plain(angles), over_plain(slides))
    hand = chain.hand(chain.links(coordinates))
    fixed = without_rounding(chain, columns_of(chain, coordinates))
    back = transposed(hand.rotation)
    columns = [(times(back, v), times(back, w)) for v, w in fixed] if axes == "hand" else fixed
    rows = chosen_rows(chain)
    rank = rank_of(chain, columns)
    known = structure_or_none(chain)
    factors = margins(known, chain, coordinates) if known else Margins()
    turning_only = all(chain.turning)
    linear = Singular(matrix_of(columns, [row for row in rows if row < 3]))
    lost = rank.lost or (NOTHING, NOTHING)
    return Jacobian(
        verdict=_verdict(rank, factors, chain.reach),
        determinant=_square(chain, columns, rows, rank),
        manipulability=_manipulability(linear) if turning_only else None,
        shoulder_factor=factors.shoulder,
        elbow_factor=factors.elbow,
        wrist_factor=factors.wrist,
        nearness=rank.nearness,
        lost_direction=_unit(lost[0]),
        lost_turn=_unit(lost[1]),
        idle=rank.idle,
        position=hand.position,
        **_hand_motion(chain, columns, over_plain(speeds), over_plain(slide_speeds)),
        **_joint_loads(chain, columns, over_plain(force), over_plain(moment)),
        columns=tuple(
            Column(
                joint=name,
                linear=column[0] if turning else None,
                slide=None if turning else column[0],
                angular=column[1],
            )
            for name, column, turning in zip(chain.names, columns, chain.turning, strict=True)
        ),
        speed_ratios=tuple(linear.values) if turning_only else None,
        ellipsoid=_ellipsoid(linear, [row for row in rows if row < 3]) if turning_only else None,
        angular_values=tuple(Singular(matrix_of(columns, (3, 4, 5))).values),
        checks=(_difference(chain, coordinates, fixed),),
        advice=limit_advice(chain, coordinates),
    )


def _verdict(rank: Rank, factors: Margins, size: float) -> str:
    """Regular, nearly singular, or singular, with the part of the arm that makes it so."""
    if rank.nearness >= CLOSE:
        return "regular"
    word = "singular" if rank.singular else "nearly singular"
    shoulder = None if factors.shoulder is None else factors.shoulder / size
    parts = {"shoulder": shoulder, "elbow": factors.elbow, "wrist": factors.wrist}
    shares = {name: share for name, share in parts.items() if share is not None}
    return f"{word}: {WHY[min(shares, key=lambda name: shares[name])]}" if shares else word


def _manipulability(linear: Singular) -> Measured:
    """Yoshikawa's measure; what rounding leaves of nothing is zero."""
    lost = linear.values[-1] <= SINGULAR * linear.values[0]
    return Measured(0.0 if lost else prod(linear.values), _power(len(linear.values)))


def _power(exponent: int) -> str:
    """The unit of a product of lengths, of six at the most."""
    return "m" + "⁰¹²³⁴⁵⁶"[exponent].replace("¹", "") if exponent else ""


def _square(chain: Chain, columns: "Columns", rows: "tuple[int, ...]", rank: Rank) -> "Measured | None":
    """The determinant where the rows are as many as the joints; what rounding leaves of nothing is zero."""
    if len(rows) != len(columns):
        return None
    # of rows in lengths, those that slides do not cancel
    unit = _power(sum(row < 3 for row in rows) - chain.turning.count(False))
    return Measured(0.0 if rank.singular else determinant(matrix_of(columns, rows)), unit)


def _unit(v: Vector) -> Vector | None:
    size = hypot(*v)
    return (v[0] / size, v[1] / size, v[2] / size) if size > PART else None


def _ellipsoid(linear: Singular, rows: "list[int]") -> "tuple[EllipsoidAxis, ...]":
    axes = []
    for value, parts in zip(linear.values, linear.left, strict=True):
        way = [0.0, 0.0, 0.0]
        for row, part in zip(rows, parts, strict=True):
            way[row] = part
        force = Measured(1.0 / value, "1/m") if value > SINGULAR * linear.values[0] else None
        axes.append(EllipsoidAxis(direction=(way[0], way[1], way[2]), velocity=value, force=force))
    return tuple(axes)


def _hand_motion(
    chain: Chain, columns: "Columns", speeds: "Sequence[float]", slide_speeds: "Sequence[float]"
) -> "dict[str, Any]":
    """Velocity of the hand at the speeds of the joints, if given."""
    if not speeds and not slide_speeds:
        return {"velocity": None, "angular_velocity": None}
    rates = coordinates_of(chain, speeds, slide_speeds, ("speeds", "slide-speeds"))
    sums = [sum(value * rate for value, rate in zip(row, rates, strict=True)) for row in matrix_of(columns, range(6))]
    return {"velocity": tuple(sums[:3]), "angular_velocity": tuple(sums[3:])}


def _joint_loads(chain: Chain, columns: "Columns", force: "Vector | None", moment: "Vector | None") -> "dict[str, Any]":
    """Torques and forces of the joints that push with a force and turn with a moment, if given."""
    if force is None and moment is None:
        return {"torques": None, "slide_forces": None}
    loads = [dot(v, force or NOTHING) + dot(w, moment or NOTHING) for v, w in columns]
    turning = chain.turning
    return {
        "torques": tuple(load for load, turns in zip(loads, turning, strict=True) if turns),
        "slide_forces": tuple(load for load, turns in zip(loads, turning, strict=True) if not turns) or None,
    }


def _difference(chain: Chain, coordinates: "Sequence[float]", columns: "Columns") -> Check:
    """The linear rows beside difference quotients of the hand's place."""
    worst = 0.0
    for index, (linear, _) in enumerate(columns):
        step = STEP if chain.turning[index] else STEP * chain.reach
        ends = []
        for sign in (1.0, -1.0):
            moved = [q + sign * step * (k == index) for k, q in enumerate(coordinates)]
            ends.append(chain.hand(chain.links(moved)).position)
        quotient = subtract(ends[0], ends[1])
        scale = chain.reach if chain.turning[index] else 1.0
        worst = max(worst, *(abs(q / (2.0 * step) - v) / scale for q, v in zip(quotient, linear, strict=True)))
    return Check("columns are difference quotients of the place", worst <= AGREES, worst, AGREES)
