"""Joint speeds for a velocity of the hand: the only ones, or those of least norm, weighted or damped."""

from math import hypot, sqrt

from dynamics_cli.errors import MissingError, require, worded
from dynamics_cli.numerics.number import over_plain
from dynamics_cli.numerics.singular_values import Singular
from dynamics_cli.quantities import (
    Angle,
    AngularRate,
    AngularVelocity,
    Annotated,
    Coordinate,
    Direction,
    Positive,
    Ratio,
    Speed,
    Text,
    TurnRate,
    Velocity,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.robot.arms.chain import Chain, chain_of, coordinates_of
from dynamics_cli.robot.arms.records import ANGLES, SLIDES, Arm
from dynamics_cli.robot.pose import is_planar, limit_advice
from dynamics_cli.robot.velocities import CLOSE, SINGULAR, columns_of, idle_of, matrix_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

# A residual below this share of the velocity asked for is rounding.
REACHED = 1e-9


@record
class JointRate:
    """Speed of one joint."""

    joint: Annotated[Text, "The joint."]
    speed: Annotated[TurnRate | None, "Its speed, of a revolute joint [rad/s]."]
    slide_speed: Annotated[Speed | None, "Its speed, of a prismatic joint [m/s]."]


@record
class Rates:
    """Joint speeds that give the hand its velocity."""

    speeds: Annotated[tuple[TurnRate, ...] | None, "Speeds of the revolute joints, in order [rad/s]."]
    slide_speeds: Annotated[tuple[Speed, ...] | None, "Speeds of the prismatic joints, in order [m/s]."]
    solution: Annotated[Text, "Whether they are the only ones, or by which rule they were chosen."]
    norm: Annotated[AngularRate, "Root of their weighted sum of squares, slides as shares of the arm's size [rad/s]."]
    missing_velocity: Annotated[Speed | None, "By how much damping leaves the hand short of its velocity [m/s]."]
    missing_turn: Annotated[AngularRate | None, "By how much it leaves it short of its angular velocity [rad/s]."]
    nearness: Annotated[Ratio, "Smallest singular value over the largest, lengths as shares of the arm's size [-]."]
    idle: Annotated[tuple[Ratio, ...] | None, "Joint speeds that may be added, for the hand stays at rest [-]."]
    joints: Annotated[tuple[JointRate, ...], "Each joint."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def rates(
    arm: Annotated[Arm, "The arm, from a file."],
    /,
    *,
    angles: Annotated[tuple[Angle, ...], ANGLES] = (),
    slides: Annotated[tuple[Coordinate, ...], SLIDES] = (),
    velocity: Annotated[Velocity | None, "Velocity of the hand, in base axes, e.g. 0.2, -0.1, 0 m/s."] = None,
    angular_velocity: Annotated[
        AngularVelocity | None, "Its angular velocity, in base axes; left out, it is free, e.g. 0, 0, 0.5 rad/s."
    ] = None,
    weights: Annotated[tuple[Positive, ...], "Weights of the joints' squares: large ones move less, e.g. 4, 2."] = (),
    damping: Annotated[
        Ratio,
        "Damping: singular values below it, lengths as shares of the arm, are held back, e.g. 0.02.",
    ] = 0.0,
) -> Rates:
    """Joint speeds for a velocity of the hand; of an arm with joints to spare those of least norm, weighted if asked.

    Equation
    --------
    q̇ = W⁻¹·Jᵀ·(J·W⁻¹·Jᵀ)⁻¹·v by singular values of J·W^(−½); damped: σ/(σ² + λ²) for 1/σ.

    Raises
    ------
    InadmissibleError
        When the arm is singular for what is asked and damping is not given, with the lost direction, or when it has too
        few joints for it.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 19.16; Y. Nakamura, H. Hanafusa, J. Dyn.
    Syst. Meas. Control 108 (1986) 163 (damping).

    Examples
    --------
    >>> answer = rates(Arm(lengths=(1.0, 1.0)), angles=(0.0, 1.5707963267948966), velocity=(1.0, 0.0, 0.0))
    >>> [round(speed, 12) for speed in answer.speeds]
    [0.0, -1.0]
    """
    chain: Chain = over_plain(chain_of(arm))
    q = coordinates_of(chain, over_plain(angles), over_plain(slides))
    wanted, rows = _wanted(chain, over_plain(velocity), over_plain(angular_velocity))
    factors = _factors(chain, over_plain(weights))
    columns, size = columns_of(chain, q), chain.reach or 1.0
    matrix = [
        [value * (factor if row > 2 else factor / size) for value, factor in zip(line, factors, strict=True)]
        for row, line in zip(rows, matrix_of(columns, rows), strict=True)
    ]
    target = [value / size if row < 3 else value for row, value in zip(rows, wanted, strict=True)]
    parts = Singular(matrix)
    nearness = parts.values[-1] / parts.values[0] if parts.values[0] else 0.0
    _require_regular(parts, rows, nearness, damping)
    scaled = _solved(parts, target, damping)
    speeds = [part * factor for part, factor in zip(scaled, factors, strict=True)]
    short = _short(matrix_of(columns, rows), rows, speeds, wanted)
    off = hypot(short[0] / size, short[1]) / (hypot(*target) or 1.0)
    require(
        damping > 0.0 or off <= REACHED,
        "the arm has {count} joints: it cannot have this velocity, and {gap} and {turn} would be missing",
        count=len(q), gap=(short[0], Speed), turn=(short[1], AngularRate), code="too-few-joints",
        hint="leave out the angular velocity, or give --damping for the nearest",
    )  # fmt: skip
    turning = chain.turning
    return Rates(
        speeds=tuple(speed for speed, turns in zip(speeds, turning, strict=True) if turns) or None,
        slide_speeds=tuple(speed for speed, turns in zip(speeds, turning, strict=True) if not turns) or None,
        solution=_solution(len(rows) < len(q), bool(weights), damping),
        norm=hypot(*scaled),
        missing_velocity=short[0] if damping else None,
        missing_turn=short[1] if damping else None,
        nearness=nearness,
        idle=_idle(parts, factors),
        joints=tuple(
            JointRate(name, speed if turns else None, None if turns else speed)
            for name, speed, turns in zip(chain.names, speeds, turning, strict=True)
        ),
        checks=() if damping else (Check("the hand has its velocity", off <= REACHED, off, REACHED),),
        advice=(*limit_advice(chain, q), *_closeness(nearness, damping)),
    )


def _closeness(nearness: float, damping: float) -> "tuple[Advice, ...]":
    """Near a singular posture the speeds are large, without being wrong."""
    if damping or nearness >= CLOSE:
        return ()
    message = worded(
        "the arm is nearly singular here (ratio of singular values {nearness:2}): joint speeds are large",
        nearness=(nearness, Ratio),
    )
    return (Advice("nearly-singular", message, remedy="--damping 0.02 limits them, at some error of the velocity"),)


def _solved(parts: Singular, target: "Sequence[float]", damping: float) -> "list[float]":
    """The solution of least norm, by singular values, damped if asked."""
    solution = [0.0] * len(parts.right[0])
    for value, left, right in zip(parts.values, parts.left, parts.right, strict=True):
        gain = value / (value * value + damping * damping) if value else 0.0
        share = gain * sum(a * b for a, b in zip(left, target, strict=True))
        solution = [old + share * part for old, part in zip(solution, right, strict=True)]
    return solution


def _short(
    lines: "Sequence[Sequence[float]]", rows: "Sequence[int]", speeds: "Sequence[float]", wanted: "Sequence[float]"
) -> "tuple[float, float]":
    """By how much the speeds miss the velocity, and the angular velocity."""
    gaps = [
        sum(value * speed for value, speed in zip(line, speeds, strict=True)) - goal
        for line, goal in zip(lines, wanted, strict=True)
    ]
    linear = [gap for row, gap in zip(rows, gaps, strict=True) if row < 3]
    return hypot(*linear), hypot(*(gap for row, gap in zip(rows, gaps, strict=True) if row > 2))


def _wanted(
    chain: Chain, velocity: "Sequence[float] | None", turn: "Sequence[float] | None"
) -> "tuple[list[float], list[int]]":
    """What is asked of the hand, row by row; of a planar arm only what is in its plane."""
    if velocity is None and turn is None:
        raise MissingError(
            "the velocity of the hand is missing", (("velocity",), ("angular_velocity",)), code="no-velocity"
        )
    both = [*(velocity or (None,) * 3), *(turn or (None,) * 3)]
    planar = is_planar(chain)
    kept = ((0, 1, 5) if all(chain.turning) else (0, 1, 2, 5)) if planar else range(6)
    require(
        not planar or all(not both[row] for row in range(6) if row not in kept),
        "the arm moves in one plane, and the velocity asked for leaves it",
        code="out-of-plane",
    )
    rows = [row for row in kept if both[row] is not None]
    return [both[row] for row in rows], rows


def _factors(chain: Chain, weights: "Sequence[float]") -> "list[float]":
    """W^(−½), with the arm's size for slides, so that all joints count in one unit."""
    require(
        len(weights) in (0, len(chain.joints)), "read {read} weights for {count} joints",
        read=len(weights), count=len(chain.joints), code="joint-count", hint="one weight for each joint",
    )  # fmt: skip
    sizes = [1.0 if turning else chain.reach for turning in chain.turning]
    return [size / sqrt(weight) for size, weight in zip(sizes, weights or [1.0] * len(sizes), strict=True)]


def _require_regular(parts: Singular, rows: "Sequence[int]", nearness: float, damping: float) -> None:
    """Refuse a singular posture, with the direction that is lost."""
    if damping or nearness >= SINGULAR or len(parts.left[-1]) != len(rows):
        return
    lost = [0.0] * 6
    for row, part in zip(rows, parts.left[-1], strict=True):
        lost[row] = part
    turn = hypot(*lost[:3]) < hypot(*lost[3:])
    way = lost[3:] if turn else lost[:3]
    size = hypot(*way) or 1.0
    x, y, z = ((round(part / size, 12) + 0.0, Direction) for part in way)
    require(
        False,
        "the arm is singular here: its hand cannot {move} ({x}, {y}, {z})",
        move="turn about" if turn else "move along", x=x, y=y, z=z, code="singular",
        hint="give --damping 0.02 for damped speeds; `robot jacobian` says what is singular",
    )  # fmt: skip


def _solution(spare: bool, weighted: bool, damping: float) -> str:
    if damping:
        return "damped least squares"
    return ("least weighted norm" if weighted else "least norm") if spare else "the only one"


def _idle(parts: Singular, factors: "Sequence[float]") -> "tuple[float, ...] | None":
    way = idle_of(parts.right, len(factors))
    if way is None:
        return None
    speeds = [part * factor for part, factor in zip(way, factors, strict=True)]
    largest = max(speeds, key=abs)
    return tuple(speed / largest for speed in speeds)
