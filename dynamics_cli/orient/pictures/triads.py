"""Pictures of turns: axes before and after, the ways their tips take, and the configuration graph of a chain."""

from math import hypot

from dynamics_cli.errors import worded
from dynamics_cli.numerics.orientation.quaternions import multiply, of_axis_angle
from dynamics_cli.numerics.orientation.rotations import IDENTITY, from_quaternion
from dynamics_cli.numerics.vectors import times as rotated
from dynamics_cli.orient.turns.compose import letter
from dynamics_cli.pictures import Axis, Curve, Label, Mark, Panel, Picture
from dynamics_cli.pictures.vectors import GREY, arrow, curve, numbers, scene, times, tipped, unit, words
from dynamics_cli.quantities import Angle, Length

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.orient.turns.compose import SimpleTurn
    from dynamics_cli.pictures.vectors import Vector

UNITS = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
ROOM = 1.35
STEPS = 48
# Columns stand this far apart, rows at a distance of one.
APART = 1.6


def triad(matrix: "Any", mark: str, role: int, *, dashed: bool = False) -> "list[Any]":
    """Three arrows along the columns of a rotation matrix."""
    items: list[Any] = []
    for k, name in enumerate("xyz"):
        tip = numbers([row[k] for row in matrix])
        # primed names farther out, for axes that fall together
        items += [
            arrow(tip, "", role, dashed=dashed),
            words(times(1.2 if mark in ("′", "₂") else 1.08, tip), name + mark, role),
        ]
    return items


def _swept(axis: "Sequence[float]", angle: float, start: "Vector") -> "list[Vector]":
    """The way of a vector that turns about an axis."""
    turns = (of_axis_angle(numbers(axis), angle * k / STEPS) for k in range(STEPS + 1))
    return [rotated(from_quaternion(turn), start) for turn in turns]


def _axis_line(axis: "Any", angle: float) -> "list[Any]":
    """The axis of a turn, through the origin."""
    n = numbers(axis)
    return [curve([times(-0.5, n), times(1.15, n)], "centre", 3), words(times(1.25, n), "n", 3)] if angle else []


def _ways(axis: "Any", angle: float, starts: "Any") -> "list[Any]":
    return [curve(_swept(axis, angle, numbers(start)), "dots", 1) for start in starts] if angle else []


def converted(answer: "Any", **_: "Any") -> Picture:
    """Fixed axes and body axes, with the axis of the turn."""
    angle = answer.rotation_angle
    items = [
        *triad(IDENTITY, "", GREY, dashed=True),
        *_ways(answer.rotation_axis, angle, UNITS),
        *_axis_line(answer.rotation_axis, angle),
        *triad(answer.rotation_matrix, "′", 0),
    ]
    words_ = "fixed axes dashed; body axes x′ y′ z′ " + ("after {angle} about n" if angle else "have not turned")
    subtitle = worded(words_, angle=(angle, Angle))
    return Picture((scene(items, subtitle, room=ROOM),), "orientation")


def between(answer: "Any", *, first: "Any", **_: "Any") -> Picture:
    """Axes of both orientations, and the ways of their tips."""
    from dynamics_cli.orient.turns.attitude import orientation

    start = orientation(first.turn).quaternion
    before, after = from_quaternion(start), from_quaternion(multiply(start, answer.quaternion))
    angle = answer.rotation_angle
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
    x, y, z = (numbers(row) for row in answer.rotation_matrix)
    matrix = (x, y, z)
    items: list[Any] = triad(matrix, "′", GREY, dashed=True)
    for pair, fit in zip(pairs if isinstance(pairs, tuple) else (pairs,), answer.pairs, strict=True):
        measured = unit(numbers(pair.after))
        items += [
            *tipped(measured, fit.name, 1),
            arrow(rotated(matrix, unit(numbers(pair.before))), "", 0, dashed=True),
        ]
    subtitle = worded("measured, and rotated (dashed); {off} remains", off=(answer.residual, Angle))
    return Picture((scene(items, subtitle, room=ROOM),), "directions and the rotation that fits")


def screw(answer: "Any", **_: "Any") -> Picture:
    """The screw axis, and the helix on which the point at the origin moves."""
    d, n = numbers(answer.displacement), numbers(answer.axis)
    size = max(hypot(*d), 1e-300)
    foot = numbers(answer.point) if answer.point is not None else (0.0, 0.0, 0.0)
    travel, angle = answer.travel, answer.rotation_angle
    arm = times(-1.0, foot)
    turned = _swept(n, angle, arm) if angle else [arm] * (STEPS + 1)
    helix = [times(travel * k / STEPS, n, times(1.0, point, foot)) for k, point in enumerate(turned)]
    ends = [times(k * size, n, foot) for k in (-0.6, 1.2)]
    items: list[Any] = [
        # an unseen line keeps the name of z off the title
        curve([(0.0, 0.0, 0.0), (0.0, 0.0, 0.4 * size)], "fill"),
        curve(ends, "centre", 3),
        curve(helix, "solid", 0),
        arrow(d, "", 1, dashed=True),
        words(times(1.08, d), "d", 1),
        words(ends[1], "n", 3),
        *(arrow(times(0.3 * size, axis), name, GREY) for axis, name in zip(UNITS, "xyz", strict=True)),
    ]
    title = worded("{angle} about the axis, {travel} along it", angle=(angle, Angle), travel=(travel, Length))
    return Picture((scene(items, title),), "displacement as a screw")


def configuration(answer: "Any", *, turns: "Any" = (), about: str = "body", base: str = "A", **_: "Any") -> Picture:
    """Frames as columns of dots; a level line for the axis of a turn, a slanted one where only plus signs stand."""
    if turns == ():
        # a general turn has no such graph
        return converted(answer)
    chain: list[SimpleTurn] = list(turns) if isinstance(turns, tuple) else [turns]
    names = [base, *(turn.name or letter(nth) for nth, turn in enumerate(chain, 1))]
    subtitle = "level: the axis of the turn; slanted: the pair with plus signs only; the third pair takes the minus"
    if about == "fixed":
        # about fixed axes the last turn is the first about the body's
        chain = chain[::-1]
        names = [base, *(f"{turn.name or 'turn ' + turn.axis}" for turn in chain)]
        subtitle = "turns about fixed axes, in the reverse order as turns about the body's"
    items: list[Any] = []
    for place, name in enumerate(names):
        items.append(Label(APART * place, 0.6, name))
        items += [Mark(APART * place, -float(k), role=6) for k in range(3)]
    items += [Label(-0.45, -float(k), axis) for k, axis in enumerate("xyz")]
    for place, turn in enumerate(chain):
        i = "xyz".index(turn.axis)
        left, right = APART * place, APART * (place + 1)
        up, down = (i + 2) % 3, (i + 1) % 3
        items.append(Curve([left, right], [-float(i), -float(i)], role=0))
        items.append(Curve([left, right], [-float(up), -float(down)], role=1))
        angle = worded("{angle} about " + turn.axis, angle=(turn.angle, Angle))
        items.append(Label(0.5 * (left + right), -2.55, angle))
    x = Axis("", ends=(-0.7, APART * len(chain) + 0.5))
    panel = Panel(x, Axis("", ends=(-2.9, 0.9)), tuple(items), equal=True, bare=True)
    return Picture((panel,), "configuration graph", subtitle=subtitle)
