"""Synthesis of four-bars: three angle pairs, three poses of a body, or swing and time ratio."""

from itertools import accumulate, pairwise
from math import ceil, floor, pi

from dynamics_cli.errors import require
from dynamics_cli.linkage.fourbar.grashof import POOR, kind_of, poor
from dynamics_cli.linkage.fourbar.swinging import crank_rocker, smallest
from dynamics_cli.numerics.elementary import absolute, atan2, cos, hypot, sin, sqrt
from dynamics_cli.quantities import Angle, Annotated, Coordinate, PartPoint, Positive, Size, Text
from dynamics_cli.records import Advice, Check, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

CLOSES = 1e-9


@record
class Pair:
    """A crank angle with its rocker angle."""

    crank_angle: Annotated[Angle, "Crank angle θ₂, e.g. 40 deg."]
    rocker_angle: Annotated[Angle, "Rocker angle θ₄, e.g. 70 deg."]


@record
class AnglePairs:
    """Three pairs of angles (Freudenstein)."""

    pairs: Annotated[tuple[Pair, ...], "The three pairs, in order."]
    ground: Annotated[Size, "Distance of the pivots, e.g. 100 mm."]


@record
class Pose:
    """A required pose of a body."""

    x: Annotated[Coordinate, "Its reference point, e.g. 100 mm."]
    y: Annotated[Coordinate, "Its height y, e.g. 40 mm."]
    angle: Annotated[Angle, "Its angle, e.g. 30 deg."]


@record
class Poses:
    """Three poses of a body that is the coupler, and its two pins."""

    poses: Annotated[tuple[Pose, ...], "The three poses, in order."]
    first_pin: Annotated[PartPoint, "Pin A in the body's own axes, e.g. 0, 0 mm."]
    second_pin: Annotated[PartPoint, "Pin B in the body's own axes, e.g. 60, 10 mm."]


@record
class PosesOnPivots:
    """Three poses of a body that is the coupler, and the pivots on the ground."""

    poses: Annotated[tuple[Pose, ...], "The three poses, in order."]
    crank_pivot: Annotated[PartPoint, "Pivot O₂ where the crank is to turn, e.g. 0, 0 mm."]
    rocker_pivot: Annotated[PartPoint, "Pivot O₄ where the rocker is to turn, e.g. 120, 0 mm."]


@record
class QuickSwing:
    """A crank-rocker by the motion of its rocker."""

    swing: Annotated[Angle, "Angle through which the rocker swings, e.g. 60 deg."]
    time_ratio: Annotated[Positive, "Time of the slow stroke over that of the quick one, e.g. 1.2."]
    rocker: Annotated[Size, "Length of the rocker, e.g. 80 mm."]


@record
class Met:
    """One pair or pose as the linkage reaches it."""

    crank_angle: Annotated[Angle, "Crank angle from the line of the pivots [rad]."]
    rocker_angle: Annotated[Angle, "Rocker angle from it [rad]."]
    transmission_angle: Annotated[Angle, "Transmission angle there [rad]."]
    branch: Annotated[Text, "The branch on which it is reached."]


@record
class Synthesis:
    """A four-bar for the task, and its defects."""

    crank: Annotated[Size, "Length a [m]."]
    coupler: Annotated[Size, "Length b [m]."]
    rocker: Annotated[Size, "Length c [m]."]
    ground: Annotated[Size, "Length d [m]."]
    kind: Annotated[Text, "Class by Grashof's rule."]
    defects: Annotated[Text, "Its defects for this task."]
    least_transmission_angle: Annotated[
        Angle,
        "Smallest transmission angle from the first pair or pose to the last; for a swing, of a whole turn [rad].",
    ]
    crank_pivot: Annotated[PartPoint | None, "Pivot O₂, where poses were given [m]."] = None
    rocker_pivot: Annotated[PartPoint | None, "Pivot O₄ [m]."] = None
    first_pin: Annotated[PartPoint | None, "Pin A in the body's own axes [m]."] = None
    second_pin: Annotated[PartPoint | None, "Pin B there [m]."] = None
    met: Annotated[tuple[Met, ...] | None, "The pairs or poses as it reaches them."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def synthesize(
    *,
    task: Annotated[
        AnglePairs | Poses | PosesOnPivots | QuickSwing, "Three angle pairs, three poses, or swing and time ratio."
    ],
) -> Synthesis:
    """Four-bar for three pairs of angles, three poses of its coupler, or a swing with a time ratio; with its defects.

    Equation
    --------
    Freudenstein: R₁ cos θ₄ − R₂ cos θ₂ + R₃ = cos(θ₂ − θ₄), R₁ = d/a, R₂ = d/c, R₃ = (a² − b² + c² + d²)/2ac; poses:
    each pivot is the centre of the circle through the three places of its pin, or each pin that of the three places of
    its pivot as seen from the body; swing: O₂ sees the rocker's ends under
    π(Q − 1)/(Q + 1), a and b half the difference and the sum of its distances, best smallest |sin μ|.

    Raises
    ------
    InadmissibleError
        When there are not three pairs or poses, they have no linkage, or no crank-rocker has this swing.

    References
    ----------
    Freudenstein, Approximate synthesis of four-bar linkages, Transactions of the ASME 77 (1955).

    Examples
    --------
    >>> pairs = (Pair(0.5, 1.0), Pair(1.0, 1.25), Pair(1.5, 1.6))
    >>> synthesize(task=AnglePairs(pairs, 0.1)).defects
    'none'
    """
    if isinstance(task, QuickSwing):
        return _by_swing(task)
    name, given = ("pair", task.pairs) if isinstance(task, AnglePairs) else ("pose", task.poses)
    require(len(given) == 3, f"{{count}} {name}s given; three are needed", count=len(given), code="count",
            hint=f"give --{name} three times")  # fmt: skip
    if isinstance(task, AnglePairs):
        return _by_angles(task)
    if isinstance(task, Poses):
        return Synthesis(**_by_poses(task))
    pinned = _pinned(task)
    pins = {"first_pin": pinned.first_pin, "second_pin": pinned.second_pin}
    pivots = {"crank_pivot": task.crank_pivot, "rocker_pivot": task.rocker_pivot}
    return Synthesis(**_by_poses(pinned) | pins | pivots)


def _within_a_turn(angle: float) -> float:
    """An angle of many turns as one of half a turn at the most: differences of such angles lose digits."""
    return angle if abs(angle) <= 4.0 * pi else atan2(sin(angle), cos(angle))


def _by_angles(task: AnglePairs) -> Synthesis:
    met = [(_within_a_turn(pair.crank_angle), _within_a_turn(pair.rocker_angle)) for pair in task.pairs]
    rows = [(cos(rocker), -cos(crank), cos(crank - rocker)) for crank, rocker in met]
    (a, b, c), (d, e, f), (g, h, i) = rows
    # differences take R₃ out
    first_row, second_row = (a - d, b - e, c - f), (a - g, b - h, c - i)
    determinant = first_row[0] * second_row[1] - first_row[1] * second_row[0]
    require(
        absolute(determinant) > 1e-12,
        "these pairs have no linkage: two of them are the same",
        code="no-linkage",
        hint="take pairs farther apart",
    )
    first = (first_row[2] * second_row[1] - first_row[1] * second_row[2]) / determinant
    second = (first_row[0] * second_row[2] - first_row[2] * second_row[0]) / determinant
    third = c - a * first - b * second
    require(
        (first != 0.0) & (second != 0.0),
        "these pairs need a link of infinite length",
        code="no-linkage",
        hint="change a pair a little",
    )
    crank, rocker, ground = task.ground / first, task.ground / second, task.ground
    square = crank * crank + rocker * rocker + ground * ground - 2.0 * crank * rocker * third
    require(square > 0.0, "these pairs need a coupler of zero length", code="no-linkage", hint="change a pair a little")
    # a negative length is one turned by half a turn
    met = [(t + (pi if crank < 0.0 else 0.0), r + (pi if rocker < 0.0 else 0.0)) for t, r in met]
    back = [name for name, length in (("crank", crank), ("rocker", rocker)) if length < 0.0]
    words = f"{' and '.join(back)} 180 deg from the angles asked for; " if back else ""
    return _judged((absolute(crank), sqrt(square), absolute(rocker), ground), met, words)


def _centre(places: "list[complex]", words: str, hint: str) -> complex:
    """Centre of the circle through three places."""
    first_chord, second_chord = places[1] - places[0], places[2] - places[0]
    across = 2.0 * (first_chord.conjugate() * second_chord).imag
    require(
        abs(across) > 1e-9 * abs(first_chord) * abs(second_chord),
        words,
        code="no-pivot",
        hint=hint,
    )
    return places[0] - 1j * (second_chord * abs(first_chord) ** 2 - first_chord * abs(second_chord) ** 2) / across


def frames(poses: "tuple[Pose, ...]") -> "list[tuple[complex, complex]]":
    """Origin and direction of the body's axes in each pose."""
    return [(complex(pose.x, pose.y), complex(cos(pose.angle), sin(pose.angle))) for pose in poses]


def _pinned(task: PosesOnPivots) -> Poses:
    """The same poses with the pins on the body that the pivots call for."""
    words, hint = "a pivot seen from the body moves along a line: its pin would be at infinity", "move that pivot"
    pins = []
    for pivot in (task.crank_pivot, task.rocker_pivot):
        seen = [(complex(*pivot) - origin) / turn for origin, turn in frames(task.poses)]
        pin = _centre(seen, words, hint)
        pins.append((pin.real, pin.imag))
    return Poses(task.poses, *pins)


def _by_poses(task: Poses) -> "dict[str, Any]":
    """The fields of the linkage through three poses."""
    ends = [
        [origin + turn * complex(*pin) for origin, turn in frames(task.poses)]
        for pin in (task.first_pin, task.second_pin)
    ]
    words = "three positions of a pin lie on a line: its pivot would be at infinity"
    pivots = [_centre(places, words, "move the pin on the body, or use a slide") for places in ends]
    base = pivots[1] - pivots[0]
    require(abs(base) > 0.0, "both pivots fall on one point", code="no-pivot", hint="move a pin on the body")
    direction = base / abs(base)
    met = []
    for first_end, second_end in zip(*ends, strict=True):
        arms = (first_end - pivots[0]) / direction, (second_end - pivots[1]) / direction
        met.append((atan2(arms[0].imag, arms[0].real), atan2(arms[1].imag, arms[1].real)))
    lengths = (abs(ends[0][0] - pivots[0]), abs(ends[1][0] - ends[0][0]), abs(ends[1][0] - pivots[1]), abs(base))
    result = _judged(lengths, met, "")
    places = [(pivot.real, pivot.imag) for pivot in pivots]
    fields = {name: getattr(result, name) for name in Synthesis.fields}  # type: ignore[attr-defined]
    return fields | {"crank_pivot": places[0], "rocker_pivot": places[1]}


def _judged(lengths: "tuple[float, float, float, float]", met: "list[tuple[float, float]]", words: str) -> Synthesis:
    """The record, with the branch of every pair and the defects."""
    a, b, c, d = lengths
    rows, sides, worst = [], [], 0.0
    for theta, angle in met:
        ax, ay, bx, by = a * cos(theta), a * sin(theta), d + c * cos(angle), c * sin(angle)
        sides.append((bx - ax) * (-ay) - (by - ay) * (d - ax) < 0.0)
        worst = max(worst, absolute(hypot(bx - ax, by - ay) - b) / (a + b + c + d))
        rows.append(Met(theta, angle, _transmission(lengths, theta)[0], "open" if sides[-1] else "crossed"))
    kind = kind_of(lengths)
    faults = [words.strip("; ")] if words else []
    if len(set(sides)) > 1:
        faults.append("branch: it must be taken apart between the pairs")
    turns = [(later[0] - first[0] + pi) % (2.0 * pi) - pi for first, later in pairwise(met)]
    if turns[0] * turns[1] < 0.0:
        faults.append("order: the crank turns back between the pairs")
    crank_sides = {sin(theta) >= 0.0 for theta, _ in met}
    if kind in ("double rocker", "rocker-crank") and len(crank_sides) > 1:
        faults.append("circuit: it must be taken apart between the pairs")
    least, passable = _between(lengths, met[0][0], turns)
    if not passable:
        faults.append("limit: coupler and rocker do not reach each other at crank angles between the pairs")
    return Synthesis(
        a, b, c, d, kind, "; ".join(faults) or "none", least, met=tuple(rows),
        checks=(Check("every pair is reached", worst <= CLOSES, worst, CLOSES),),
        advice=_poor(least),
    )  # fmt: skip


def _transmission(lengths: "tuple[float, float, float, float]", angle: float) -> "tuple[float, bool]":
    """Transmission angle at a crank angle, and whether the linkage can take that pose at all."""
    a, b, c, d = lengths
    square = (a - d) * (a - d) + 4.0 * a * d * sin(0.5 * angle) ** 2
    first, second = (b + c) * (b + c) - square, square - (b - c) * (b - c)
    angle = 2.0 * atan2(sqrt(max(second, 0.0)), sqrt(max(first, 0.0)))
    return angle, min(first, second) >= -CLOSES * (b + c) * (b + c)


def _between(lengths: "tuple[float, float, float, float]", start: float, turns: "list[float]") -> "tuple[float, bool]":
    """The smallest transmission angle along the crank angles from pair to pair, and whether all can be reached."""
    angles = [*accumulate(turns, initial=start)]
    # between two pairs the angle is extreme where the crank lies along the ground link
    angles += [pi * k for k in range(ceil(min(angles) / pi), floor(max(angles) / pi) + 1)]
    poses = [_transmission(lengths, angle) for angle in angles]
    return min(min(angle, pi - angle) for angle, _ in poses), all(reached for _, reached in poses)


def _poor(least: float) -> "tuple[Advice, ...]":
    remedy = "try other lengths or pairs, or keep the crank away from there"
    return () if least >= POOR else (poor("comes within 40 deg of 0 or 180 deg", remedy),)


def _by_swing(task: QuickSwing) -> Synthesis:
    lengths = crank_rocker(task.swing, task.time_ratio, task.rocker)
    least = smallest(lengths)
    return Synthesis(
        *lengths, kind=kind_of(lengths), defects="none", least_transmission_angle=least, advice=_poor(least)
    )
