"""A straight line or an arc of the hand: the joints in time, their speeds, limits and singular postures on the way."""

from math import inf

from dynamics_cli.errors import MissingError, require, worded
from dynamics_cli.numerics.number import over_plain
from dynamics_cli.numerics.orientation.rotations import Turn
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Coordinate,
    Count,
    HandPosition,
    Ratio,
    RotationVector,
    Size,
    Speed,
    Text,
    Time,
    TurnRate,
)
from dynamics_cli.records import Advice, Check, Numerics, record
from dynamics_cli.robot.arms.chain import Chain, chain_of, coordinates_of
from dynamics_cli.robot.arms.records import ORIGIN, Arm
from dynamics_cli.robot.inverse.structures import structure_of
from dynamics_cli.robot.inverse.task import SAME_POSE, Inverse, Solution, inverse, orientation_of
from dynamics_cli.robot.path.course import Course, Profile, course_of
from dynamics_cli.robot.path.trace import Step, Trace
from dynamics_cli.robot.velocities import CLOSE, chosen_rows

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

SMOOTH = Profile("smooth")
NEAR = {
    "wrist": "its wrist is {margin} from having its outer axes in line",
    "elbow": "its elbow is {margin} from straight or folded",
    "shoulder": "its wrist centre is {margin} from over the first axis",
}


@record
class PathPoint:
    """The arm at one time."""

    time: Annotated[Time, "Time from the start [s]."]
    position: Annotated[HandPosition, "The hand [m]."]
    angles: Annotated[tuple[Angle, ...], "Angles of the revolute joints [rad]."]
    slides: Annotated[tuple[Coordinate, ...] | None, "Travels of the prismatic joints [m]."]
    speeds: Annotated[tuple[TurnRate, ...], "Speeds of the revolute joints [rad/s]."]
    slide_speeds: Annotated[tuple[Speed, ...] | None, "Speeds of the prismatic joints [m/s]."]
    nearness: Annotated[Ratio, "Smallest over largest singular value, 0 where singular [-]."]


@record
class JointPath:
    """One joint on the way."""

    joint: Annotated[Text, "The joint."]
    start: Annotated[Angle | None, "Where it starts, of a revolute joint [rad]."]
    end: Annotated[Angle | None, "Where it ends [rad]."]
    start_travel: Annotated[Coordinate | None, "The same of a prismatic joint [m]."]
    end_travel: Annotated[Coordinate | None, "The same of a prismatic joint [m]."]
    peak_speed: Annotated[TurnRate | None, "Its largest speed [rad/s]."]
    peak_slide_speed: Annotated[Speed | None, "Its largest speed, of a prismatic joint [m/s]."]
    peak_time: Annotated[Time, "When it has it [s]."]
    share: Annotated[Ratio | None, "Of the speed that it may have [-]."]


@record
class HandPath:
    """The joints along a path of the hand."""

    length: Annotated[Size, "Length of the hand's path [m]."]
    duration: Annotated[Time, "Duration [s]."]
    peak_hand_speed: Annotated[Speed, "Largest speed of the hand [m/s]."]
    posture: Annotated[Text, "The posture at the start, by name."]
    fastest_joint: Annotated[Text, "The joint with the largest speed, or the largest share of its allowed speed."]
    shortest_duration: Annotated[Time | None, "Duration at which the fastest joint has its allowed speed [s]."]
    within: Annotated[Text | None, "Whether all joints keep their limits and allowed speeds."]
    least_nearness: Annotated[Ratio, "Smallest over largest singular value, where it is least; 0: singular [-]."]
    least_time: Annotated[Time, "When that is [s]."]
    jumps: Annotated[Count, "How often the arm must change to another posture on the way."]
    joints: Annotated[tuple[JointPath, ...], "Each joint."]
    points: Annotated[tuple[PathPoint, ...], "The arm in time."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def path(
    arm: Annotated[Arm, "The arm, from a file."],
    /,
    *,
    start: Annotated[HandPosition, "Where the hand starts (of planar arms two numbers do), e.g. 450, 100, 900 mm."],
    end: Annotated[HandPosition, "Where it ends, e.g. 450, -200, 900 mm."],
    via: Annotated[
        HandPosition | None, "A point on the way: an arc through it instead of a line, e.g. 500, 0, 900 mm."
    ] = None,
    hand_angle: Annotated[Angle | None, "Angle of the last link to the x axis, of a planar arm, e.g. 40 deg."] = None,
    turn: Annotated[Turn | None, "Orientation of the hand at the start, in one of the notations."] = None,
    hand_turn: Annotated[
        RotationVector, "Its turn on the way: the axis, in base axes, times the angle, e.g. 0, 0, 90 deg."
    ] = ORIGIN,
    duration: Annotated[Time | None, "Duration, e.g. 2 s."] = None,
    hand_speed: Annotated[Speed | None, "Or the largest speed of the hand, e.g. 0.5 m/s."] = None,
    profile: Annotated[Profile, "smooth, from rest to rest, or constant speed."] = SMOOTH,
    max_speeds: Annotated[tuple[TurnRate, ...], "Speeds that the revolute joints may have, e.g. 120, 90 deg/s."] = (),
    max_slide_speeds: Annotated[tuple[Speed, ...], "The same of the prismatic joints, e.g. 0.8 m/s."] = (),
    near: Annotated[tuple[Angle, ...], "Revolute joints at the start, nearly, e.g. 0, 30, -60, 0, 30, 0 deg."] = (),
    points: Annotated[Count, "Rows of the table of times."] = 51,
) -> HandPath:
    """Joints of an arm whose hand moves along a straight line or an arc, with a steady turn of the hand.

    Equation
    --------
    q(s) by the closed form of the inverse, the posture nearest to the one before; q̇ = J⁻¹·(p′, θ′)·ṡ; smooth motion:
    s = 10τ³ − 15τ⁴ + 6τ⁵, τ = t/T.

    Raises
    ------
    InadmissibleError
        When the path leaves what the arm reaches (after what length), has no length, or the arm has no closed form.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 19.12 and 19.15.

    Examples
    --------
    >>> answer = path(Arm(lengths=(1.0, 1.0)), start=(1.0, 1.0, 0.0), end=(1.0, -1.0, 0.0), duration=2.0)
    >>> [round(angle, 6) for angle in answer.points[-1].angles]
    [-1.570796, 1.570796]
    """
    chain: Chain = over_plain(chain_of(arm))
    begin, finish, between = over_plain((start, end, via))
    structure = structure_of(chain)
    rotation = orientation_of(structure, hand_angle, turn)
    course = course_of(begin, finish, between, rotation, over_plain(hand_turn))
    _require_turn(course, chain, structure.kind)
    time = _duration(course, profile, over_plain(duration), over_plain(hand_speed))
    require(points >= 2, "a table of times needs at least two rows", code="points")
    found = inverse(arm, position=start, hand_angle=hand_angle, turn=turn, near=near)
    trace, chosen = _best(chain, course, found, bool(near), points, profile)
    allowed = _allowed(chain, over_plain(max_speeds), over_plain(max_slide_speeds))
    times = [_when(profile, step.share) * time for step in trace.steps]
    speeds = [_rate(profile, at / time) / time for at in times]
    joints = tuple(_joint(trace, number, times, speeds, allowed[number]) for number in range(len(chain.joints)))
    shares = [joint.share for joint in joints if joint.share is not None]
    fastest = max(joints, key=lambda joint: (joint.share or 0.0, joint.peak_speed or 0.0))
    least = min(range(len(times)), key=lambda k: trace.steps[k].nearness)
    worst = max(row.position_error / structure.size for row in found.solutions)
    return HandPath(
        length=course.length,
        duration=time,
        peak_hand_speed=course.length * profile.peak / time,
        posture=chosen.configuration,
        fastest_joint=fastest.joint,
        shortest_duration=time * max(shares) if shares else None,
        within=_within(trace, shares, found.within is not None),
        least_nearness=trace.steps[least].nearness,
        least_time=times[least],
        jumps=len(trace.jumps),
        joints=joints,
        points=_points(trace, profile, time, points),
        checks=(Check("the first posture gives the pose", worst <= SAME_POSE, worst, SAME_POSE),),
        advice=_advice(trace, times, chosen, bool(near)),
        numerics=Numerics("closed form"),
    )


def _require_turn(course: Course, chain: Chain, kind: str) -> None:
    """Refuse a turn of the hand that the arm cannot choose."""
    rows = chosen_rows(chain)
    require(
        all(not part or row in rows for row, part in zip((3, 4, 5), course.turn, strict=True)),
        "this arm cannot turn its hand so on the way: {kind}", kind=kind, code="no-wrist",
        hint="planar arms of three joints turn it about z, arms of six joints as they are asked",
    )  # fmt: skip


def _duration(course: Course, profile: Profile, duration: float | None, speed: float | None) -> float:
    if duration is None and speed is None:
        raise MissingError("the duration is missing", (("duration",), ("hand_speed",)), code="no-duration")
    require(duration is None or speed is None, "the duration is given twice, by --duration and by --hand-speed",
            code="two-durations")  # fmt: skip
    if speed is not None:
        require(speed > 0.0 and course.length > 0.0, "the hand has no speed, or no length to go", code="no-duration",
                hint="give --duration")  # fmt: skip
        return course.length * profile.peak / speed
    assert duration is not None
    require(duration > 0.0, "the duration is not above zero", code="no-duration")
    return duration


def _best(
    chain: Chain, course: Course, found: Inverse, near: bool, points: int, profile: Profile
) -> "tuple[Trace, Solution]":
    """The way from the first posture at the start that goes to the end within the limits; else from the first."""
    structure = structure_of(chain)
    best: tuple[Trace, Solution] | None = None
    for solution in found.solutions[: 1 if near else None]:
        trace = Trace(chain, structure, course, coordinates_of(chain, solution.angles, solution.slides or ()))
        for number in range(1, points):
            trace.to(profile.share(number / (points - 1)))
        if best is None:
            best = trace, solution
        if not trace.jumps and not trace.beyond:
            return trace, solution
    assert best is not None
    return best


def _when(profile: Profile, share: float) -> float:
    """The share of the time at which a share of the way is done."""
    if profile == "constant" or share in (0.0, 1.0):
        return share
    low, high = 0.0, 1.0
    for _ in range(52):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if profile.share(middle) < share else (low, middle)
    return 0.5 * (low + high)


def _rate(profile: Profile, time: float) -> float:
    return profile.rate(min(max(time, 0.0), 1.0))


def _allowed(chain: Chain, turns: "Sequence[float]", travels: "Sequence[float]") -> "list[float]":
    """The speed that each joint may have, in the order of the joints."""
    words = ("max-speeds", "max-slide-speeds")
    turns = turns or (inf,) * chain.turning.count(True)
    travels = travels or (inf,) * chain.turning.count(False)
    require(min(*turns, *travels, inf) > 0.0, "the speed that a joint may have is not above zero", code="max-speeds")
    return coordinates_of(chain, turns, travels, words)


def _joint(trace: Trace, number: int, times: "Sequence[float]", speeds: "Sequence[float]", allowed: float) -> JointPath:
    rates = [abs(step.rates[number]) * speed for step, speed in zip(trace.steps, speeds, strict=True)]
    peak = max(rates)
    turns = trace.chain.turning[number]
    ends = trace.steps[0].coordinates[number], trace.steps[-1].coordinates[number]
    return JointPath(
        joint=trace.chain.names[number],
        start=ends[0] if turns else None,
        end=ends[1] if turns else None,
        start_travel=None if turns else ends[0],
        end_travel=None if turns else ends[1],
        peak_speed=peak if turns else None,
        peak_slide_speed=None if turns else peak,
        peak_time=times[rates.index(peak)],
        share=peak / allowed if allowed < inf else None,
    )


def _within(trace: Trace, shares: "Sequence[float]", limited: bool) -> str | None:
    if not limited and not shares:
        return None
    over = [name for _, (name, _, _) in trace.beyond]
    if over:
        return f"no, {', '.join(over)} beyond a limit"
    return "no, too fast" if max(shares, default=0.0) > 1.0 + 1e-12 else "yes"


def _points(trace: Trace, profile: Profile, time: float, count: int) -> "tuple[PathPoint, ...]":
    by_share = {step.share: step for step in trace.steps}
    turning = trace.chain.turning
    rows = []
    for number in range(count):
        at = number / (count - 1)
        step: Step = by_share[profile.share(at)]
        speed = _rate(profile, at) / time
        both = list(zip(step.coordinates, step.rates, turning, strict=True))
        rows.append(
            PathPoint(
                time=at * time,
                position=trace.course.position(step.share),
                angles=tuple(value for value, _, turns in both if turns),
                slides=tuple(value for value, _, turns in both if not turns) or None,
                speeds=tuple(rate * speed + 0.0 for _, rate, turns in both if turns),
                slide_speeds=tuple(rate * speed + 0.0 for _, rate, turns in both if not turns) or None,
                nearness=step.nearness,
            )
        )
    return tuple(rows)


def _advice(trace: Trace, times: "Sequence[float]", chosen: Solution, near: bool) -> "tuple[Advice, ...]":
    advice = []
    at = {step.share: time for step, time in zip(trace.steps, times, strict=True)}
    for jump in trace.jumps:
        message = worded(
            "at {time} joint {joint} jumps by {turn}: the arm passes a singular posture, or changes its posture there",
            time=(at[jump.share], Time), joint=jump.joint, turn=(jump.turn, Angle),
        )  # fmt: skip
        advice.append(Advice("jump", message, severity="serious", remedy="start in another posture by --near"))
    for step, (name, excess, turns) in trace.beyond:
        message = worded(
            "joint {name} is beyond its limit from {time} on, by {excess} there",
            name=name, time=(at[step.share], Time), excess=(excess, Angle if turns else Coordinate),
        )  # fmt: skip
        remedy = "leave out --near to try all postures at the start" if near else "no posture at the start avoids it"
        advice.append(Advice("beyond-limit", message, severity="serious", remedy=remedy))
    least = min(trace.steps, key=lambda step: step.nearness)
    if least.nearness < CLOSE:
        posture = least.posture
        size = trace.structure.size
        named = [
            (part.margin / (size if name == "shoulder" else 1.0), part.margin, name)
            for name, part in (("wrist", posture.wrist), ("elbow", posture.elbow), ("shoulder", posture.shoulder))
            if part is not None
        ]
        _, margin, name = min(named)
        message = worded(
            f"at {{time}} the arm passes near a singular posture: {NEAR[name]}",
            time=(at[least.share], Time), margin=(margin, Size if name == "shoulder" else Angle),
        )  # fmt: skip
        advice.append(Advice("near-singular", message))
    end = " ".join(trace.steps[-1].posture.configuration)
    if end != chosen.configuration:
        message = worded("the posture changes from {start} to {end} on the way", start=chosen.configuration, end=end)
        advice.append(Advice("posture", message, severity="note"))
    return tuple(advice)
