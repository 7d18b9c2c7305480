"""Pictures of turns: axes before and after, and the ways their tips take."""

from dynamics_cli.errors import worded
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.orientation.quaternions import multiply, rotated
from dynamics_cli.numerics.orientation.rotations import IDENTITY, from_quaternion
from dynamics_cli.orient.pictures.space import GREY, arrow, curve, numbers, scene, swept, triad, words
from dynamics_cli.pictures import Picture
from dynamics_cli.quantities import Angle, Length

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

UNITS = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
ROOM = 1.35


def _axis_line(axis: "Any", angle: float) -> "list[Any]":
    """The axis of a turn, through the origin."""
    if not angle:
        return []
    n = numbers(axis)
    ends = [tuple(-0.5 * part for part in n), tuple(1.15 * part for part in n)]
    return [curve(ends, "centre", 3), words(tuple(1.25 * part for part in n), "n", 3)]


def _ways(axis: "Any", angle: float, starts: "Any") -> "list[Any]":
    return [curve(swept(axis, angle, numbers(start)), "dots", 1) for start in starts] if angle else []


def converted(answer: "Any", **_: "Any") -> Picture:
    """Fixed axes and body axes, with the axis of the turn."""
    angle = float(plain(answer.rotation_angle))
    items = [
        *triad(IDENTITY, "", GREY, dashed=True),
        *_ways(answer.rotation_axis, angle, UNITS),
        *_axis_line(answer.rotation_axis, angle),
        *triad(answer.rotation_matrix, "′", 0),
    ]
    subtitle = worded("fixed axes dashed; body axes x′ y′ z′ after {angle} about n", angle=(angle, Angle))
    return Picture((scene(items, subtitle, room=ROOM),), "orientation")


def between(answer: "Any", *, first: "Any", **_: "Any") -> Picture:
    """Axes of both orientations, and the ways of their tips."""
    from dynamics_cli.orient.turns.attitude import orientation

    start = orientation(first.turn).quaternion
    floats = tuple(float(plain(part)) for part in start)
    before = from_quaternion(floats)  # type: ignore[arg-type]
    after = from_quaternion(multiply(floats, tuple(float(plain(part)) for part in answer.quaternion)))  # type: ignore[arg-type]
    angle = float(plain(answer.rotation_angle))
    items = [
        *triad(before, "₁", GREY, dashed=True),
        *_ways(answer.rotation_axis, angle, [rotated(before, unit) for unit in UNITS]),
        *_axis_line(answer.rotation_axis, angle),
        *triad(after, "₂", 0),
    ]
    subtitle = worded("first orientation dashed; the second after {angle} about n", angle=(angle, Angle))
    return Picture((scene(items, subtitle, room=ROOM),), "from one orientation to another")


def aligned(answer: "Any", *, pairs: "Any", **_: "Any") -> Picture:
    """Directions as measured, and as the rotation gives them."""
    from dynamics_cli.numerics.orientation.quaternions import unit

    matrix = tuple(numbers(row) for row in answer.rotation_matrix)
    items: list[Any] = triad(matrix, "′", GREY, dashed=True)
    for pair, fit in zip(pairs if isinstance(pairs, tuple) else (pairs,), answer.pairs, strict=True):
        measured = unit(numbers(pair.after))
        items += [arrow(measured, "", 1), words(tuple(1.12 * part for part in measured), fit.name, 1)]
        items.append(arrow(rotated(matrix, unit(numbers(pair.before))), "", 0, dashed=True))  # type: ignore[arg-type]
    subtitle = worded("measured, and rotated (dashed); {off} remains", off=(answer.residual, Angle))
    return Picture((scene(items, subtitle, room=ROOM),), "directions and the rotation that fits")


def screw(answer: "Any", **_: "Any") -> Picture:
    """The screw axis, and the helix on which the point at the origin moves."""
    d = numbers(answer.displacement)
    n = numbers(answer.axis)
    size = max(sum(part * part for part in d) ** 0.5, 1e-300)
    start = (0.0, 0.0, 0.0)
    foot = numbers(answer.point) if answer.point is not None else start
    travel, angle = float(plain(answer.travel)), float(plain(answer.rotation_angle))
    arm = tuple(-part for part in foot)
    turned = swept(n, angle, arm) if angle else [arm] * 49  # type: ignore[arg-type]
    helix = [
        tuple(f + t + travel * k / (len(turned) - 1) * e for f, t, e in zip(foot, turned_point, n, strict=True))
        for k, turned_point in enumerate(turned)
    ]
    ends = [tuple(f + k * size * e for f, e in zip(foot, n, strict=True)) for k in (-0.6, 1.2)]
    items: list[Any] = [
        curve(ends, "centre", 3),
        curve(helix, "solid", 0),
        arrow(d, "", 1, dashed=True),
        words(tuple(0.5 * part for part in d), "d", 1),
        words(ends[1], "n", 3),
    ]
    for unit, name in zip(UNITS, "xyz", strict=True):
        items.append(arrow(tuple(0.3 * size * part for part in unit), name, GREY))
    title = worded("{angle} about the axis, {travel} along it", angle=(angle, Angle), travel=(travel, Length))
    return Picture((scene(items, title),), "displacement as a screw")
