"""A four-bar in one pose, with velocities and accelerations, or its table over the crank angles it reaches."""

from dynamics_cli.errors import require
from dynamics_cli.linkage.fourbar.closure import (
    OPEN,
    Branch,
    Closed,
    Frame,
    close,
    discriminants,
    frame,
    is_regular,
    ratios,
)
from dynamics_cli.linkage.fourbar.grashof import POOR, closeness, kind_of, limits, poor, rocking
from dynamics_cli.linkage.fourbar.lengths import require_links
from dynamics_cli.linkage.fourbar.records import FourBar
from dynamics_cli.numerics.elementary import atan2, hypot, sqrt, where
from dynamics_cli.numerics.number import decides, plain, single
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import (
    Angle,
    AngularAcceleration,
    Annotated,
    Count,
    PartPoint,
    Size,
    Torque,
    TurnRate,
)
from dynamics_cli.records import Advice, Check
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Pair = tuple[float, float]

MANY = 1_000_000
# Rounding of a closed loop, relative to the sum of its lengths.
CLOSES = 1e-12
PI = 3.141592653589793


def four_bar(
    *,
    crank: Annotated[Size, "Length a of the driving link, from O₂ to A, e.g. 40 mm."],
    coupler: Annotated[Size, "Length b of the link between the pins A and B, e.g. 120 mm."],
    rocker: Annotated[Size, "Length c of the driven link, from O₄ to B, e.g. 80 mm."],
    ground: Annotated[Size, "Distance d of the pivots O₂ and O₄, e.g. 100 mm."],
    crank_angle: Annotated[Angle | None, "Crank angle θ₂ from O₂–O₄; without it a table, e.g. 40 deg."] = None,
    branch: Annotated[Branch, "The side of the line from A to O₄ where B lies: left (open) or right (crossed)."] = OPEN,
    speed: Annotated[TurnRate | None, "Angular velocity ω₂ of the crank, e.g. 10 rad/s."] = None,
    angular_acceleration: Annotated[AngularAcceleration, "Angular acceleration α₂ of the crank [rad/s^2]."] = 0.0,
    load_torque: Annotated[Torque | None, "Torque that the rocker delivers, e.g. 20 N*m."] = None,
    point: Annotated[PartPoint | None, "A coupler point P from A, along AB and to its left, e.g. 60, 40 mm."] = None,
    steps: Annotated[Count, "Steps of the table over the crank angles that can be reached."] = 24,
) -> FourBar:
    """Position, velocity and acceleration of a four-bar linkage on both branches, or its table over the crank angle.

    Equation
    --------
    f² = (a − d)² + 4ad·sin²(θ₂/2), D₁ = (b + c)² − f², D₂ = f² − (b − c)²; B = A + (f⃗(f² + b² − c²) ± √(D₁D₂)
    k×f⃗)/2f²; μ = 2 atan2(√D₂, √D₁); ω₃, ω₄ from ω₂ k×a⃗ + ω₃ k×b⃗ = ω₄ k×c⃗; T₂ = T₄·ω₄/ω₂.

    Raises
    ------
    InadmissibleError
        When a length is not above zero, the links cannot be closed at all or not at this crank angle, when crank pin
        and rocker pivot coincide, or at a toggle, where no speed of the crank moves the rocker.

    Notes
    -----
    A branch is a side, not the pose nearest to the last one: rows are independent. At an exact change point the
    branch is a whole smooth motion, named by its side at small positive crank angles: a parallelogram stays one.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 5.3 to 5.5.

    Examples
    --------
    >>> pose = four_bar(crank=0.04, coupler=0.12, rocker=0.08, ground=0.1, crank_angle=0.6981317007977318)
    >>> round(pose.rocker_angle, 12)
    1.000507900539
    """
    require_links(crank, coupler, rocker, ground)
    lengths = (crank, coupler, rocker, ground)
    links = frame(*lengths)
    alone = single(*lengths, crank_angle)
    parted = decides(*lengths, crank_angle)
    kind = kind_of(lengths) if parted else None
    side = 1.0 if branch == OPEN else -1.0
    swing = _swing(lengths, kind, side) if kind else _sampled_swing(lengths, side) if drawing() else {}
    if crank_angle is None and drawing():
        return FourBar(**swing)
    if crank_angle is None:
        return _turn(links, swing, side, (steps, speed, angular_acceleration))
    turn, half = turned(crank_angle), turned(0.5 * crank_angle)
    both_discriminants = discriminants(links, half)
    require_closed(links, both_discriminants, crank_angle)
    loop, other = (close(links, turn, half, sign * side, both_discriminants) for sign in (1.0, -1.0))
    if speed is not None or load_torque is not None:
        require(
            is_regular(links, loop),
            "coupler and rocker are in line (a toggle): the crank cannot move through this pose, only the rocker can "
            "drive",
            code="toggle",
            hint="give a crank angle near it, or let the rocker drive",
        )
    regular = bool(is_regular(links, loop)) if parted else True
    speeds = ratios(links, loop)
    transmission = 2.0 * atan2(_size(loop.second), _size(loop.first))
    pin = (crank * turn[0], crank * turn[1])
    return FourBar(
        rocker_angle=_angle(loop.cy, loop.cx),
        coupler_angle=_angle(loop.by, loop.bx),
        transmission_angle=transmission,
        rocker_ratio=speeds[1] if regular else None,
        coupler_ratio=speeds[0] if regular else None,
        crank_torque=None if load_torque is None else load_torque * speeds[1],
        other_rocker_angle=_angle(other.cy, other.cx),
        other_coupler_angle=_angle(other.by, other.bx),
        other_rocker_ratio=ratios(links, other)[1] if regular else None,
        crank_pin=pin,
        rocker_pin=(pin[0] + loop.bx, pin[1] + loop.by),
        **_moving(links, loop, pin, speeds, (speed, angular_acceleration), point),
        **(swing if kind in ("crank-rocker", None) else {"kind": kind}),
        side=_side(kind, side, plain(turn[1])) if kind else None,
        checks=_checks(links, loop, pin, speeds) if alone and regular else (),
        advice=(*closeness(lengths, kind), *_poor(transmission, regular)) if alone and kind else (),
    )


def _turn(links: Frame, swing: "dict[str, Any]", side: float, table_of: "tuple[int, float | None, float]") -> FourBar:
    """The table over all crank angles, headed by the rocker's swing."""
    from dynamics_cli.linkage.fourbar.table import table

    require(
        bool(swing),
        "rows need a crank angle: a table is for a single linkage",
        code="no-angle",
        hint="add a column crank_angle",
    )
    return FourBar(**swing, table=table(links, side, *table_of), advice=closeness(links.lengths, swing["kind"]))


def _swing(lengths: "tuple[float, ...]", kind: str, side: float) -> "dict[str, Any]":
    """Class and swing of the rocker; its ends, where it has two on this branch."""
    low, high, swing = rocking(lengths)
    if kind != "crank-rocker" or low is None or high is None:
        return {"kind": kind, "swing": swing}
    ends = (low, high) if side > 0.0 else (-high, -low)
    return {"kind": kind, "swing": swing, "rocker_least": ends[0], "rocker_greatest": ends[1]}


def _sampled_swing(lengths: "tuple[float, ...]", side: float) -> "dict[str, Any]":
    """The same of samples, where the rocker has two ends; elsewhere no number."""
    a, b, c, d = lengths
    links = frame(c, b, a, d)
    gap, total, nothing = _size(links.slim), a + b + c + d, float("nan")
    both = (links.outer < 0.0) & (links.inner < 0.0)
    far = (a + b - links.apart) * (a + b + links.apart), links.outer * total
    near = links.inner * (gap + links.apart), (c + d - gap) * (c + d + gap)
    low, high = (PI - 2.0 * atan2(sqrt(_size(one)), sqrt(_size(other))) for one, other in (far, near))
    low, high = where(both, low, nothing), where(both, high, nothing)
    ends = (low, high) if side > 0.0 else (-high, -low)
    return {"swing": high - low, "rocker_least": ends[0], "rocker_greatest": ends[1]}


def _moving(
    links: Frame,
    loop: Closed,
    pin: "Pair",
    speeds: "tuple[float, ...]",
    crank: "tuple[float | None, float]",
    point: "Pair | None",
) -> "dict[str, Any]":
    """The motion of coupler, rocker and coupler point from the crank's."""
    place = None if point is None else _carried(links, loop, pin, point)
    speed, bend = crank
    if speed is None:
        return {"position": place}
    square = speed * speed
    bends = (speeds[0] * bend + speeds[2] * square, speeds[1] * bend + speeds[3] * square)
    motion = None if place is None else _motion(pin, place, (speed, bend), (speeds[0] * speed, bends[0]))
    return {
        "position": place,
        "velocity": motion and motion[0],
        "acceleration": motion and motion[1],
        "rocker_speed": speeds[1] * speed,
        "coupler_speed": speeds[0] * speed,
        "rocker_acceleration": bends[1],
        "coupler_acceleration": bends[0],
    }


def require_closed(links: Frame, both: "Pair", crank_angle: float) -> None:
    """Refuse a crank angle that the links cannot reach, with the gap, the remedy, and the nearest possible angle."""
    b, c = links.b, links.c
    sine = turned(0.5 * crank_angle)[1]
    reach = sqrt(links.apart * links.apart + 4.0 * links.product * (sine * sine))
    outer, inner = limits(links) if single(*links.lengths) else (None, None)
    for reserve, limit, words, gap, change in (
        (both[0], outer, "stretched", reach - (b + c), "lengthen coupler or rocker"),
        (both[1], inner, "folded", where(b >= c, b - c, c - b) - reach, "bring coupler and rocker nearer in length"),
    ):
        nearest = limit if limit is not None else 0.0 * crank_angle
        require(
            reserve >= 0.0,
            f"at a crank angle of {{angle:6}} coupler and rocker, {words}, leave a gap of {{gap}}",
            angle=(crank_angle, Angle),
            gap=(gap, Size),
            nearest=(nearest, Angle),
            code="unreachable",
            hint=f"the nearest crank angle that can be reached is ±{{nearest:8}}; or {change} by {{gap}}",
        )
    require(
        reach > 0.0,
        "the crank's pin lies on the rocker's pivot: coupler and rocker turn about it freely",
        code="free",
        hint="give a crank angle near it",
    )


def _size(x: float) -> float:
    return where(x < 0.0, -x, x)


def _angle(y: float, x: float) -> float:
    """An angle in (−180°, 180°], without negative zero."""
    return atan2(where(y == 0.0, y * y + y, y), x)


def _carried(links: Frame, loop: Closed, pin: "Pair", point: "Pair") -> "Pair":
    """A point given along and left of the coupler, in the fixed frame."""
    ex, ey = loop.bx / links.b, loop.by / links.b
    return pin[0] + point[0] * ex - point[1] * ey, pin[1] + point[0] * ey + point[1] * ex


def _motion(pin: "Pair", place: "Pair", crank: "Pair", coupler: "Pair") -> "tuple[Pair, Pair]":
    """Velocity and acceleration of a coupler point: that of A and the turn about it."""
    rx, ry = place[0] - pin[0], place[1] - pin[1]
    (w2, a2), (w3, a3) = crank, coupler
    velocity = (-(w2 * pin[1]) - w3 * ry, w2 * pin[0] + w3 * rx)
    acceleration = (
        -(a2 * pin[1]) - w2 * w2 * pin[0] - a3 * ry - w3 * w3 * rx,
        a2 * pin[0] - w2 * w2 * pin[1] + a3 * rx - w3 * w3 * ry,
    )
    return velocity, acceleration


def _side(kind: str, side: float, sine: float) -> str:
    """The circuit in words: poses of one circuit are joined without taking the linkage apart."""
    name = "open" if side > 0.0 else "crossed"
    if kind in ("crank-rocker", "double crank"):
        return f"{name}, a separate circuit"
    if kind in ("double rocker", "rocker-crank"):
        return f"{name}, on the circuit with the crank {'above' if sine >= 0.0 else 'below'} the ground link"
    if kind.startswith("change"):
        return f"{name}, joined to the other at the change points"
    return f"{name}, joined to the other at the toggles"


def _checks(links: Frame, loop: Closed, pin: "Pair", speeds: "Any") -> "tuple[Check, ...]":
    size = plain(links.a + links.b + links.c + links.d)
    bx, by, cx, cy = (plain(x) for x in (loop.bx, loop.by, loop.cx, loop.cy))
    ax, ay = plain(pin[0]), plain(pin[1])
    gap = hypot(ax + bx - cx - plain(links.d), ay + by - cy) / size
    w3, w4 = plain(speeds[0]), plain(speeds[1])
    residual = hypot(-ay - w3 * by + w4 * cy, ax + w3 * bx - w4 * cx) / (size * (1.0 + abs(w3) + abs(w4)))
    return (
        Check("the loop closes", gap <= CLOSES, gap, CLOSES),
        Check("B has one velocity (power in = power out)", residual <= CLOSES, residual, CLOSES),
    )


def _poor(transmission: float, regular: bool) -> "tuple[Advice, ...]":
    if not regular:
        return (
            Advice(
                "toggle",
                "coupler and rocker are in line (a toggle): the crank's speed does not determine the rocker's",
                remedy="give a crank angle near it",
                result="rocker_ratio",
            ),
        )
    angle = plain(transmission)
    if POOR <= angle <= PI - POOR:
        return ()
    remedy = "keep it between 40 and 140 deg where force is transmitted"
    return (poor("is more than 50 deg from 90 deg here", remedy),)
