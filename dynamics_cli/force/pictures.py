"""Forces where they act, with their resultant and its line of action, or with the reactions of supports."""

import math

from dynamics_cli.errors import worded
from dynamics_cli.force import ratios
from dynamics_cli.force.diagram import body, symbols
from dynamics_cli.force.system import Load, System, vector
from dynamics_cli.pictures import Arrow, Axis, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import DistributedForce, Force, Length, Torque

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    # Tail, vector, label and colour of an arrow.
    Drawn = tuple[tuple[float, ...], tuple[float, ...], str, int]

GIVEN, ANSWER, LEVER = 0, 1, 2
# Arrows of a distributed load end where they act.
ROW = 3
VIEWS = (((0, 1), "from above"), ((0, 2), "from the front"), ((1, 2), "from the side"))
# The longest arrow beside the extent of the points.
LONGEST = 0.45
# A support's symbol beside it.
SYMBOL = 0.05
# Arrows of a distributed load, less one.
ARROWS = 8


def resultant(
    answer: "Any", *, loads: "Any" = None, couples: "Any" = None, distributed_loads: "Any" = None, **_: "Any"
) -> Picture:  # fmt: skip
    """The forces where they act and the resultant on its axis."""
    drawn, planar = _given(loads, couples, distributed_loads)
    if answer.axis_point is not None:
        name = worded("R = {size}", size=(answer.magnitude, Force))
        drawn.append((answer.axis_point, answer.force, name, ANSWER))
    title = f"resultant: {answer.system}"
    words = _couples(couples, planar=planar)
    if answer.wrench_moment is not None:
        words.append(worded("about the axis {moment}", moment=(answer.wrench_moment, Torque)))
    elif answer.axis_point is None:
        words.append(worded("moment {moment}", moment=(math.hypot(*answer.moment), Torque)))
    return _picture(
        drawn, title, planar=planar, axis=answer.axis_point and (answer.axis_point, answer.force), words=words
    )


def equilibrium(
    answer: "Any", *, supports: "Any", loads: "Any" = None, couples: "Any" = None, distributed_loads: "Any" = None,
    **_: "Any",
) -> Picture:  # fmt: skip
    """The body with its supports, the loads, and the reactions."""
    drawn, planar = _given(loads, couples, distributed_loads)
    words = _couples(couples, planar=planar)
    for reaction in answer.reactions:
        planar = planar and not reaction.force[2] and not reaction.at[2]
        label = worded("{name}: {size}", name=reaction.name, size=(reaction.size, Force))
        drawn.append((reaction.at, reaction.force, label, ANSWER))
        if reaction.moment is not None and any(reaction.moment):
            couple = reaction.moment[2] if planar else math.hypot(*reaction.moment)
            words.append(worded("{name}: {moment}", name=reaction.name, moment=(couple, Torque)))
    shapes: list[Curve] = []
    if planar:
        points = [(tail[0], tail[1]) for tail, *_ in drawn]
        extent = max(max(p[i] for p in points) - min(p[i] for p in points) for i in range(2)) or 1.0
        shapes = [*body(points), *symbols(supports, points, SYMBOL * extent)]
    title = "loads and reactions on the body"
    return _picture(drawn, title, planar=planar, axis=None, words=words, shapes=shapes)


def moment(answer: "Any", *, force: "Any", at: "Any", about: "Any" = (0.0, 0.0, 0.0), **_: "Any") -> Picture:
    """The force, the point and the lever between."""
    drawn, planar = _given(Load(force, at), None)
    planar = planar and at[2] == about[2]
    drawn = [(at, way, name, role) for _, way, name, role in drawn]
    lever = (about, answer.foot, worded("lever {lever}", lever=(answer.lever, Length))) if answer.foot else None
    axis = (at, drawn[0][1]) if drawn else None
    words = [worded("M = {moment}", moment=(answer.moment[2] if planar else answer.magnitude, Torque))]
    return _picture(drawn, "moment of a force about a point", planar=planar, axis=axis, words=words, lever=lever)


def _couples(couples: "Any", *, planar: bool) -> "list[str]":
    """Labels of the couples, which have no place in the picture."""
    words: list[str] = []
    for couple in System(None, couples, needed=False).couples:
        moment = ratios.rounded(couple)
        words.append(worded("couple {moment}", moment=(moment[2] if planar else math.hypot(*moment), Torque)))
    return words


def _given(loads: "Any", couples: "Any", distributed: "Any" = None) -> "tuple[list[Drawn], bool]":
    system = System(loads, couples, needed=False)
    drawn: list[Drawn] = []
    for point, force in zip(system.points, system.forces, strict=True):
        name = worded("{size}", size=(ratios.size(force), Force))
        drawn.append((ratios.rounded(point), ratios.rounded(force), name, GIVEN))
    return drawn + _rows(distributed), System(loads, couples, distributed, needed=False).planar


def _rows(distributed: "Any") -> "list[Drawn]":
    """Distributed loads as rows of arrows, a quarter as long as a force of their whole size would be."""
    drawn: list[Drawn] = []
    for line in distributed or ():
        force = ratios.rounded(vector(line.force, DistributedForce, "", ""))
        last = ratios.rounded(vector(line.end_force or line.force, DistributedForce, "", ""))
        start, end = (ratios.rounded(ratios.of_vector(place)) for place in (line.from_, line.to))
        size = 0.25 * math.dist(start, end)
        largest = max((force, last), key=lambda one: math.hypot(*one))
        name = worded("{size}", size=(math.hypot(*largest), DistributedForce))
        for k in range(ARROWS + 1):
            share = k / ARROWS
            at, way = (
                tuple(a + share * (b - a) for a, b in zip(*ends, strict=True)) for ends in ((start, end), (force, last))
            )
            labelled = k == ARROWS // 2 if force == last else (way == largest)
            drawn.append((at, tuple(size * part for part in way), name if labelled else "", ROW))
    return drawn


def _picture(
    drawn: "Sequence[Drawn]", title: str, *, planar: bool, axis: "Any", words: "Sequence[str]", lever: "Any" = None,
    shapes: "Sequence[Curve]" = (),
) -> Picture:  # fmt: skip
    views = VIEWS[:1] if planar else VIEWS
    points = [tail for tail, *_ in drawn] + ([lever[0], lever[1]] if lever else []) or [(0.0, 0.0, 0.0)]
    extent = max(max(p[i] for p in points) - min(p[i] for p in points) for i in range(3)) or 1.0
    longest = max((math.hypot(*way) for _, way, *_ in drawn), default=0.0) or 1.0
    scale = LONGEST * extent / longest
    panels = [_view(drawn, points, scale, extent, view, axis, lever, "" if planar else name) for view, name in views]
    if shapes:
        panels[0] = Panel(panels[0].x, panels[0].y, (*shapes, *panels[0].items), equal=True)
    if words:
        first = panels[-1]
        low = min(min(item.y) for item in first.items if isinstance(item, Curve) and item.style == "fill")
        left = min(min(item.x) for item in first.items if isinstance(item, Curve) and item.style == "fill")
        labels = [
            Label(left + 0.03 * extent, low + (0.05 + 0.06 * line) * extent, text, 6, left=True)
            for line, text in enumerate(reversed(words))
        ]
        panels[-1] = Panel(first.x, first.y, (*first.items, *labels), first.title, equal=True)
    return Picture(tuple(panels), title, columns=1 if planar else 2)


def _view(
    drawn: "Sequence[Drawn]", points: "Sequence[Any]", scale: float, extent: float, view: "tuple[int, int]",
    axis: "Any", lever: "Any", title: str,
) -> Panel:  # fmt: skip
    """One view: arrows where they act, with room around them."""
    i, j = view
    ends = [(p[i], p[j]) for p in points]
    signs = [-scale if role == ROW else scale for *_, role in drawn]
    ends += [(tail[i] + k * way[i], tail[j] + k * way[j]) for (tail, way, *_), k in zip(drawn, signs, strict=True)]
    room = 0.2 * extent
    left, right = min(x for x, _ in ends) - room, max(x for x, _ in ends) + room
    low, high = min(y for _, y in ends) - room, max(y for _, y in ends) + room
    items: list[Any] = [Curve([left, right], [low, high], "", "fill", 6)]
    if axis:
        items += _line(axis, view, (left, right, low, high))
    if lever:
        start, foot, name = lever
        items.append(Curve([start[i], foot[i]], [start[j], foot[j]], "", "dashed", LEVER))
        items.append(Mark(start[i], start[j], name, (6.0, -12.0), role=LEVER))
    rows = any(role == ROW for *_, role in drawn)
    for tail, way, name, role in drawn:
        dx, dy = scale * way[i], scale * way[j]
        if role == ROW:
            items.append(Arrow(tail[i] - dx, tail[j] - dy, dx, dy, "", GIVEN))
            if name:
                items.append(Label(tail[i] - dx, tail[j] - dy + 0.03 * extent, name, GIVEN))
            continue
        seen = math.hypot(dx, dy) > 0.02 * extent
        answer = role == ANSWER
        # beside the line of action, on the side that falls away from it
        aside = (6.0, 6.0 if dx * dy <= 0.0 else -14.0)
        items.append(Mark(tail[i], tail[j], name if (answer and not rows) or not seen else "", aside, role=role))
        if seen:
            items.append(Arrow(tail[i], tail[j], dx, dy, "" if answer and not rows else name, role))
    return Panel(Axis("xyz"[i], Length), Axis("xyz"[j], Length), tuple(items), title, equal=True)


def _line(axis: "Any", view: "tuple[int, int]", box: "tuple[float, float, float, float]") -> "list[Curve]":
    """A line across the view, dash-dotted."""
    (point, way), (i, j) = axis, view
    size = math.hypot(way[i], way[j])
    if not size:
        return []
    u, v = way[i] / size, way[j] / size
    low, high = -math.inf, math.inf
    for start, part, least, most in ((point[i], u, box[0], box[1]), (point[j], v, box[2], box[3])):
        if part:
            ends = (least - start) / part, (most - start) / part
            low, high = max(low, min(ends)), min(high, max(ends))
    if not low < high:
        return []
    return [
        Curve(
            [point[i] + low * u, point[i] + high * u], [point[j] + low * v, point[j] + high * v], "", "centre", ANSWER
        )
    ]
