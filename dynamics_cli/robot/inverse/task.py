"""Inverse kinematics: all sets of joint positions that give a pose of the hand, with their limits and margins."""

from math import hypot, pi, remainder

from dynamics_cli.errors import MissingError, require, worded
from dynamics_cli.numerics.number import over_plain, plain
from dynamics_cli.numerics.orientation.rotations import (
    ByMatrix,
    Matrix,
    Turn,
    departure,
    matrix_of,
    product,
    transposed,
)
from dynamics_cli.numerics.vectors import subtract, times
from dynamics_cli.quantities import Angle, Annotated, Coordinate, Count, HandPosition, Ratio, Size, Text
from dynamics_cli.records import Advice, Check, Numerics, record
from dynamics_cli.robot.arms.chain import INFINITE, Chain, beyond_limits, chain_of, coordinates_of, limits
from dynamics_cli.robot.arms.records import REVOLUTE, Arm
from dynamics_cli.robot.inverse.postures import Posture, postures_of
from dynamics_cli.robot.inverse.structures import PARALLEL, PLANAR, POSITION, Structure, structure_of
from dynamics_cli.robot.inverse.subproblems import angle_about, turned_about

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

# Half the spacing of doubles at one: a pose in doubles is not known better, as a share of the arm's size.
ROUNDING = 2.0**-53
# A posture whose pose is off by more than this, as a share of the arm's size, is a mistake of the program.
SAME_POSE = 1e-11
# Postures nearer than this to a singular one deserve a remark: half a degree, and that share of the arm's size.
NEAR = pi / 360.0
NOTATIONS = (
    ("euler_angles", "euler_order"), ("quaternion",), ("rotation_matrix",), ("rotation_axis", "rotation_angle"),
)  # fmt: skip
# A matrix was rounded in writing if it departs from a rotation by more than this.
WRITTEN = 1e-14


@record
class Solution:
    """One posture that gives the pose."""

    number: Annotated[Count, "Its number, those within limits first, or the nearest."]
    angles: Annotated[tuple[Angle, ...], "Angles of the revolute joints [rad]."]
    slides: Annotated[tuple[Coordinate, ...] | None, "Travels of the prismatic joints [m]."]
    configuration: Annotated[
        Text, "Shoulder (front as at zero, back), elbow (up, down; left, right), wrist (flip: its middle angle < 0)."
    ]
    within: Annotated[Text | None, "Whether every joint is within its limits."]
    beyond: Annotated[Text, "Joints beyond a limit."]
    excess: Annotated[Angle | None, "The largest angle by which a revolute joint is beyond its limit [rad]."]
    distance: Annotated[Angle | None, "Root of the sum of squares of turns from the posture to be near [rad]."]
    shoulder_margin: Annotated[Size | None, "From where front and back fall together [m]."]
    elbow_margin: Annotated[Angle | None, "Elbow from straight or folded [rad]."]
    wrist_margin: Annotated[Angle | None, "Wrist from having its outer axes in line [rad]."]
    wrist_sum: Annotated[
        Angle | None, "In line: the first wrist angle plus the last, all that the pose determines [rad]."
    ]
    undetermined: Annotated[Text | None, "A joint whose angle the pose leaves open: its axis goes through the target."]
    position_error: Annotated[Size, "Distance of its hand from the position given [m]."]
    turn_error: Annotated[Angle, "Its hand's turn from the orientation given [rad]."]
    angle_error: Annotated[Angle, "Estimate of how well a pose in doubles determines the angles [rad]."]


@record
class Inverse:
    """All postures that give the pose."""

    angles: Annotated[tuple[Angle, ...], "Angles of the first posture [rad]."]
    slides: Annotated[tuple[Coordinate, ...] | None, "Travels of the first posture [m]."]
    count: Annotated[Count, "How many postures give the pose."]
    within: Annotated[Count | None, "How many of them are within the limits of the joints."]
    at_most: Annotated[Count, "How many an arm of this structure has at most."]
    structure: Annotated[Text, "The structure that the closed form is of."]
    solutions: Annotated[tuple[Solution, ...], "The postures."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def inverse(
    arm: Annotated[Arm, "The arm, from a file."],
    /,
    *,
    position: Annotated[HandPosition, "Where the hand is to be, e.g. 450, 100, 600 mm; planar arms: 550, 350 mm."],
    hand_angle: Annotated[Angle | None, "Angle of the last link to the x axis, of a planar arm, e.g. 40 deg."] = None,
    turn: Annotated[Turn | None, "Orientation of the hand, in one of the notations."] = None,
    near: Annotated[
        tuple[Angle, ...], "Revolute joints now: the nearest posture comes first, e.g. 0, 30, -60, 0, 30, 0 deg."
    ] = (),
) -> Inverse:
    """Inverse kinematics: every posture that gives a pose of the hand, in closed form.

    Equation
    --------
    Two links to a distance r: θ₂ = ±2·atan2(√((l₁ + l₂ − r)(l₁ + l₂ + r)), √((r − |l₁ − l₂|)(r + |l₁ − l₂|)));
    first axis: e₂·R(e₁, −q₁)·w = h; wrist: R(e₄, q₄)·R(e₅, q₅)·R(e₆, q₆) = W, sin² of the middle angle = |e₄ × W·e₆|².

    Raises
    ------
    InadmissibleError
        When the pose is out of reach (by how much, and of what), the arm has no closed form, an orientation is given to
        an arm without a wrist, or a matrix is not a rotation.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 19.12.

    Examples
    --------
    >>> answer = inverse(Arm(lengths=(1.0, 1.0)), position=(1.0, 1.0, 0.0))
    >>> [[round(angle, 12) for angle in solution.angles] for solution in answer.solutions]
    [[0.0, 1.570796326795], [1.570796326795, -1.570796326795]]
    """
    chain = over_plain(chain_of(arm))
    structure = structure_of(chain)
    target = (plain(position[0]), plain(position[1]), plain(position[2]))
    rotation = orientation_of(structure, hand_angle, turn)
    start = [plain(angle) for angle in near]
    slides = chain.turning.count(False)
    now = coordinates_of(chain, start, (0.0,) * slides, ("near", "slides")) if near else None
    postures = postures_of(structure, target, rotation, now)
    rows = [_solution(structure, chain, posture, (target, rotation), now) for posture in postures]
    rows.sort(key=lambda row: (row.within == "no", row.distance or 0.0))
    rows = [Solution(**{**row.__dict__, "number": number}) for number, row in enumerate(rows, 1)]
    limited = is_limited(chain)
    worst = max(max(row.position_error / structure.size, row.turn_error) for row in rows)
    return Inverse(
        angles=rows[0].angles,
        slides=rows[0].slides,
        count=len(rows),
        within=sum(row.within == "yes" for row in rows) if limited else None,
        at_most=_most(structure),
        structure=structure.kind,
        solutions=tuple(rows),
        checks=(Check("every posture gives the pose", worst <= SAME_POSE, worst, SAME_POSE),),
        advice=_advice(structure, rows, limited, turn, bool(near)),
        numerics=Numerics("closed form"),
    )


def is_limited(chain: Chain) -> bool:
    """Whether any joint has a limit."""
    return any(low > -INFINITE or high < INFINITE for low, high in map(limits, chain.joints))


def _most(structure: Structure) -> int:
    return 2 if structure.kind == PLANAR else 4 if structure.kind == POSITION else 8


def has_wrist(structure: Structure) -> bool:
    """Whether the hand's orientation is free, beside its place."""
    return structure.kind not in (PLANAR, POSITION) or (structure.kind == PLANAR and len(structure.turns) == 3)


def orientation_of(structure: Structure, hand_angle: float | None, turn: "Turn | None") -> Matrix:
    """The rotation of the hand; where the arm does not choose it, that at zero."""
    planar = structure.kind == PLANAR
    given = hand_angle is not None or turn is not None
    if not has_wrist(structure):
        require(not given, "this arm has {count} joints that turn: it cannot choose the orientation of its hand",
                count=len(structure.turns), code="no-wrist", hint="give the position alone")  # fmt: skip
        return structure.rotation
    ways = (("hand_angle",), ("rotation_matrix",)) if planar else NOTATIONS
    if not given:
        raise MissingError("the orientation of the hand is missing", ways, code="no-orientation")
    if turn is None:
        require(planar, "a hand angle is of a planar arm; this one turns its hand in space", code="hand-angle",
                hint="give --euler-angles and --euler-order, or another notation")  # fmt: skip
        assert hand_angle is not None
        start, axis = structure.rotation, structure.axes[0]
        require(abs(axis[2]) == 1.0, "the arm does not move in the x–y plane", code="hand-angle",
                hint="give --rotation-matrix, or another notation")  # fmt: skip
        way = angle_about((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (start[0][0], start[1][0], start[2][0]))
        return _turned(start, plain(hand_angle) - way)
    require(hand_angle is None, "the orientation is given twice", code="two-orientations")
    rotation: Matrix = over_plain(matrix_of(turn))
    if planar:
        tilt = product(rotation, transposed(structure.rotation))
        axis = structure.axes[0]
        off = hypot(*subtract(times(tilt, axis), axis))
        require(off < SAME_POSE, "the orientation tilts the hand by {off} out of the plane of the arm",
                off=(off, Angle), code="out-of-reach")  # fmt: skip
    return rotation


def _turned(matrix: Matrix, angle: float) -> Matrix:
    """A matrix turned about z."""
    from math import cos, sin

    x, y, z = (turned_about((0.0, 0.0, 1.0), cos(angle), sin(angle), column) for column in transposed(matrix))
    return transposed((x, y, z))


def _solution(
    structure: Structure, chain: Chain, posture: Posture, pose: "tuple[tuple[float, float, float], Matrix]",
    now: "Sequence[float] | None",
) -> Solution:  # fmt: skip
    """A posture with whole turns chosen, compared with limits and with the pose."""
    coordinates = [
        _whole_turns(value, *limits(joint), 0.0 if now is None else now[index]) if joint.type == REVOLUTE else value
        for index, (value, joint) in enumerate(zip(posture.coordinates, chain.joints, strict=True))
    ]
    over = beyond_limits(chain, coordinates)
    hand = chain.hand(chain.links(coordinates))
    angles = tuple(value for value, turning in zip(coordinates, chain.turning, strict=True) if turning)
    start = None if now is None else [value for value, turning in zip(now, chain.turning, strict=True) if turning]
    shoulder, elbow, wrist = posture.shoulder, posture.elbow, posture.wrist
    lever = posture.lever
    error = ROUNDING * lever
    if shoulder is not None:
        error *= max(structure.size / shoulder.margin, 1.0) if shoulder.margin else 1.0
    if elbow is not None and elbow.margin:
        error /= min(elbow.margin, 1.0)
    if wrist is not None and wrist.margin:
        error /= min(wrist.margin, 1.0)
    total = None
    if wrist is not None and wrist.total is not None:
        total = remainder(wrist.total, 2.0 * pi)
    free = has_wrist(structure)
    return Solution(
        number=0,
        configuration=" ".join(posture.configuration),
        angles=angles,
        slides=tuple(value for value, turning in zip(coordinates, chain.turning, strict=True) if not turning) or None,
        within=None if not is_limited(chain) else "no" if over else "yes",
        beyond=", ".join(name for name, _, _ in over),
        excess=max((excess for _, excess, turns in over if turns), default=None),
        distance=None if start is None else hypot(*(a - b for a, b in zip(angles, start, strict=True))),
        shoulder_margin=None if shoulder is None else shoulder.margin,
        elbow_margin=None if elbow is None else elbow.margin,
        wrist_margin=None if wrist is None else wrist.margin,
        wrist_sum=total,
        undetermined=_left_open(structure, posture, chain.names),
        position_error=hypot(*subtract(hand.position, pose[0])),
        turn_error=_between(hand.rotation, pose[1]) if free else 0.0,
        angle_error=error,
    )


def _left_open(structure: Structure, posture: Posture, names: "Sequence[str]") -> "str | None":
    """The joint about whose axis the target lies, so that every angle of it will do."""
    if posture.shoulder is not None and posture.shoulder.free:
        return names[structure.turns[0]]
    if posture.elbow is not None and posture.elbow.free:
        return names[structure.turns[0 if structure.kind == PLANAR else 1]]
    return None


def _whole_turns(value: float, low: float, high: float, beside: float) -> float:
    """The same angle, of those within limits the one nearest to another; of none within, the nearest."""
    nearest = beside + remainder(value - beside, 2.0 * pi)
    if low - 1e-12 <= nearest <= high + 1e-12:
        return nearest
    turns = [nearest + 2.0 * pi * count for count in (-2, -1, 1, 2)]
    return min((turn for turn in turns if low <= turn <= high), key=lambda turn: abs(turn - beside), default=nearest)


def _between(first: Matrix, second: Matrix) -> float:
    """The angle between two rotations, small as it is."""
    off = product(transposed(first), second)
    return 0.5 * hypot(off[2][1] - off[1][2], off[0][2] - off[2][0], off[1][0] - off[0][1])


def _advice(
    structure: Structure, rows: "Sequence[Solution]", limited: bool, turn: "Turn | None", near: bool
) -> "tuple[Advice, ...]":
    advice = []
    if limited and all(row.within == "no" for row in rows):
        best = min(rows, key=lambda row: row.excess or 0.0)
        message = worded(
            "no posture is within the limits; nearest to them is posture {number}, beyond that of {joints}",
            number=best.number, joints=best.beyond,
        )  # fmt: skip
        advice.append(Advice("beyond-limits", message, severity="serious"))
    if isinstance(turn, ByMatrix):
        off = plain(departure(turn.rotation_matrix))  # type: ignore[arg-type]
        if off > WRITTEN:
            message = worded(
                "the matrix departs from a rotation by {off}; the nearest rotation was taken", off=(off, Ratio)
            )
            advice.append(Advice("repaired", message, severity="note", remedy="give more digits"))
    for row in rows:
        advice += _singular(structure, row, near)
    return tuple(advice)


def _singular(structure: Structure, row: Solution, near: bool) -> "list[Advice]":
    """What a posture loses that is singular, or nearly so."""
    first, last = ("θ₂ + θ₃ + θ₄", "θ₆") if structure.kind == PARALLEL else ("θ₄", "θ₆")
    if row.wrist_sum is not None:
        message = worded(
            "posture {number}: the outer axes of the wrist are in line, and only {first} ± {last} = {total} is "
            "determined; {free} is taken {as_}",
            number=row.number, first=first, last=last, total=(row.wrist_sum, Angle),
            free=last if structure.kind == PARALLEL else first, as_="from --near" if near else "as zero",
        )  # fmt: skip
        return [Advice("wrist-singular", message, remedy="" if near else "give the joints now by --near")]
    if row.undetermined is not None:
        message = worded(
            "posture {number}: the target is on the axis of joint {joint}: every angle of that joint gives the pose, "
            "and one of them is shown", number=row.number, joint=row.undetermined,
        )  # fmt: skip
        return [Advice("undetermined", message)]
    out = []
    for name, margin, small in (
        ("wrist", row.wrist_margin, NEAR),
        ("elbow", row.elbow_margin, NEAR),
        ("shoulder", row.shoulder_margin, NEAR * structure.size),
    ):
        if margin is None or margin > small:
            continue
        kind = Size if name == "shoulder" else Angle
        if margin == 0.0:
            message = worded("posture {number} is at the {name} singularity{why}: there two postures fall together",
                             number=row.number, name=name,
                             why=", the arm straight or folded" if name == "elbow" else "")  # fmt: skip
        else:
            message = worded(
                "posture {number} is {margin} from the {name} singularity: its angles change {times:3} times as much "
                "as the pose",
                number=row.number, margin=(margin, kind), name=name,
                times=(structure.size / margin if name == "shoulder" else 1.0 / margin, Ratio),
            )  # fmt: skip
        out.append(Advice(f"{name}-singular", message, severity="note"))
    return out
