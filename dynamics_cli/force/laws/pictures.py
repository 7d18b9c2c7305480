"""Blocks and wedges with their forces to scale, each contact with its cone of friction."""

import math

from dynamics_cli.errors import worded
from dynamics_cli.numerics.number import plain
from dynamics_cli.pictures import Arrow, Axis, Curve, Label, Panel, Picture, Ranges
from dynamics_cli.quantities import STANDARD_GRAVITY, Angle, Force

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Plane = tuple[float, float]

LOADS, ANSWER, CONE, GREY = 0, 1, 2, 6
BARE = Axis("")
# The longest arrow beside a block of width one, and the length of a cone's sides.
LONGEST, SIDE = 1.0, 0.55
# A reaction that acts farther than this from the middle of the base is not drawn there.
FAR = 1.5
# A wedge is so long, if it is not too high, and so thick at its thin end.
WEDGE, HIGHEST, THIN = 2.0, 1.4, 0.1
# Where the words of load, face, guide, drive and ground stand beside the middles of their arrows.
ASIDE = (None, None, (0.0, 0.15), (0.0, 0.15), None)
POLYGON = ((-0.17, 0.0), None, (0.0, 0.05), (0.0, -0.05), None)


def friction(
    answer: "Any",
    *,
    mass: float,
    friction: float,
    angle: float = 0.0,
    width: "float | None" = None,
    centre_height: "float | None" = None,
    push: float = 0.0,
    push_height: "float | None" = None,
    gravity: float = STANDARD_GRAVITY,
    **_: "Any",
) -> Picture:
    """The block with its forces and the cone of friction, and the pushes that it withstands."""
    base = plain(width) if width else 1.0
    centre = plain(centre_height) / base if centre_height else 0.4
    high = plain(push_height) / base if push_height is not None else centre
    slope, push = plain(angle), plain(push)
    normal, needed = plain(answer.normal_force), plain(answer.friction_force)
    weight = plain(mass) * plain(gravity)
    scale = LONGEST / max(weight, abs(push), math.hypot(normal, needed))

    def at(along: float, up: float) -> "Plane":
        return along * math.cos(slope) - up * math.sin(slope), along * math.sin(slope) + up * math.cos(slope)

    point = plain(answer.pressure_point) / base if answer.pressure_point is not None else 0.0
    contact = at(max(-0.5, min(0.5, point)), 0.0)
    top = max(2.0 * centre, high)
    floor = [at(-1.9, 0.0), at(1.9, 0.0), at(1.9, -0.12), at(-1.9, -0.12)]
    items: list[Any] = [
        _shape(floor, "fill"),
        _shape([at(-0.5, 0.0), at(0.5, 0.0), at(0.5, top), at(-0.5, top)], "filled"),
        *_cone(contact, slope + 0.5 * math.pi, math.atan(plain(friction)), SIDE),
        *_force(at(0.0, centre), (0.0, -scale * weight), "weight {size}", weight, LOADS, at=1.0, aside=(0.0, -0.1)),
    ]
    if push:
        side = math.copysign(0.5, push)
        head, tail = at(-side, high), at(-side - scale * push, high)
        by = (head[0] - tail[0], head[1] - tail[1])
        items += _force(tail, by, "push {size}", abs(push), LOADS, aside=(0.0, 0.12))
    reaction = at(scale * needed, scale * normal)
    if abs(point) <= FAR:
        words = "reaction {size}" if answer.verdict == "holds" else "reaction {size} that would hold it"
        items += _force(at(point, 0.0), reaction, words, math.hypot(normal, needed), ANSWER, at=1.0, aside=(0.0, 0.12))
    title = f"the block {answer.verdict}"
    panels = [Panel(BARE, BARE, tuple(items), "", equal=True, bare=True)]
    if answer.least_push is not None:
        least, largest = plain(answer.least_push), plain(answer.largest_push)
        limits = ((least, f"below: {answer.below}"), (largest, f"above: {answer.above}"))
        bar = Ranges(("holds",), [least], [largest], [push], limits=limits)
        panels.append(Panel(Axis("push, uphill positive", Force), BARE, (bar,)))
    subtitle = worded("dashed: cone of friction, {angle:3} to either side", angle=(math.atan(plain(friction)), Angle))
    return Picture(tuple(panels), title, subtitle=subtitle)


def _shape(corners: "Sequence[Plane]", style: "Any", role: int = GREY) -> Curve:
    closed = [*corners, corners[0]]
    return Curve([x for x, _ in closed], [y for _, y in closed], "", style, role)


def _cone(tip: "Plane", middle: float, half: float, side: float) -> "list[Curve]":
    """Both sides of a cone of friction about the direction `middle`."""
    return [
        Curve(
            [tip[0], tip[0] + side * math.cos(middle + turn)], [tip[1], tip[1] + side * math.sin(middle + turn)],
            "", "dashed", CONE,
        )
        for turn in (half, -half)
    ]  # fmt: skip


def _force(
    tail: "Plane", by: "Plane", words: str, size: float, role: int, *, at: float = 0.5, aside: "Plane | None" = None
) -> "list[Any]":
    """A force with its words beside it at a share of its length; to its right where no other place is given."""
    x, y = tail[0] + at * by[0], tail[1] + at * by[1]
    dx, dy = aside or (0.06, 0.0)
    label = Label(x + dx, y + dy, worded(words, size=(size, Force)), role, left=aside is None or dx > 0.0)
    return [Arrow(*tail, *by, "", role), label]


def wedge(
    answer: "Any",
    *,
    load: float,
    angle: float,
    friction: float,
    ground_friction: "float | None" = None,
    guide_friction: float = 0.0,
    **_: "Any",
) -> Picture:
    """Wedge and load apart with the forces on each while it is driven, and the closed polygon of these forces."""
    load, slope = plain(load), plain(angle)
    face, guide = math.atan(plain(friction)), math.atan(plain(guide_friction))
    ground = face if ground_friction is None else math.atan(plain(ground_friction))
    drive, lift, across = plain(answer.drive), plain(answer.face_force), plain(answer.guide_force)
    bottom = load + across * math.sin(guide)
    loads = (
        ("load {size}", (0.0, -load), load, LOADS),
        ("face {size}", (lift * math.sin(slope + face), lift * math.cos(slope + face)), lift, ANSWER),
        ("guide {size}", (-across * math.cos(guide), -across * math.sin(guide)), across, CONE),
        ("drive {size}", (drive, 0.0), drive, LOADS),
        ("ground {size}", (-bottom * math.tan(ground), bottom), bottom / math.cos(ground), CONE),
    )
    return Picture(
        (_apart(loads, slope, (face, guide, ground)), _polygon(loads)),
        _wedge_title(answer),
        columns=2,
        subtitle="dashed: normals of the faces; on the right the forces tip to tail",
    )


def _wedge_title(answer: "Any") -> str:
    release = plain(answer.release)
    words = "holds by itself, pulled out by {size}" if release >= 0.0 else "slips out unless it is held by {size}"
    return worded("a wedge driven in: " + words, size=(abs(release), Force))


def _apart(loads: "Any", slope: float, angles: "tuple[float, float, float]") -> Panel:
    """Wedge, load, guide and ground apart by the forces between them, each on its line of action."""
    scale = LONGEST / max(size for _, _, size, _ in loads)
    _, face, guide, _, ground = ((scale * by[0], scale * by[1]) for _, by, _, _ in loads)
    length = min(WEDGE, HIGHEST / math.tan(slope))

    def top(x: float) -> float:
        return THIN - x * math.tan(slope)

    wedge = [(-length, 0.0), (0.0, 0.0), (0.0, THIN), (-length, top(-length))]
    touch = (-0.55 * length, top(-0.55 * length))
    press = (touch[0] + face[0], touch[1] + face[1])
    # the forces on each body meet in one point
    up = min(0.4 * length, 0.2 * length * face[1] / max(face[0], 1e-9))
    middle = press[0] + up * face[0] / face[1]
    left, right = middle - 0.35 * length, middle + 0.35 * length
    low = [press[1] - (x - press[0]) * math.tan(slope) for x in (left, right)]
    high = low[0] + 0.6 * length
    meets = press[1] + up + (right - middle) * math.tan(angles[1])
    pushed = 0.5 * top(-length)
    under = touch[0] + (pushed - touch[1]) * face[0] / face[1] + pushed * math.tan(angles[2])
    floor, wall = -ground[1], right - guide[0]
    heads = ((middle, high), press, (right, meets), (-length, pushed), (under, 0.0))
    normals = ((0.0, 0.0), (-math.sin(slope), -math.cos(slope)), (1.0, 0.0), (0.0, 0.0), (0.0, -1.0))
    items: list[Any] = [
        _shape(wedge, "filled"),
        _shape([(left, low[0]), (right, low[1]), (right, high), (left, high)], "filled"),
        _shape(
            [(-1.3 * length, floor), (0.3 * length, floor), (0.3 * length, floor - 0.1), (-1.3 * length, floor - 0.1)],
            "fill",
        ),
        _shape([(wall, low[1]), (wall + 0.1, low[1]), (wall + 0.1, high), (wall, high)], "fill"),
    ]
    for (x, y), (u, v) in zip(heads, normals, strict=True):
        if u or v:
            items.append(Curve([x, x + SIDE * u], [y, y + SIDE * v], "", "dashed", GREY))
    for (words, by, size, role), head, aside in zip(loads, heads, ASIDE, strict=True):
        tail = (head[0] - scale * by[0], head[1] - scale * by[1])
        items += _force(tail, (scale * by[0], scale * by[1]), words, size, role, aside=aside)
    items.append(Arrow(*press, -face[0], -face[1], "", ANSWER))
    return Panel(BARE, BARE, tuple(items), equal=True, bare=True)


def _polygon(loads: "Any") -> Panel:
    """The forces on the load and those on the wedge, tip to tail; the force on the face is in both."""
    weight, face, _, drive, _ = (by for _, by, _, _ in loads)
    under = (weight[0], weight[1])
    corner, foot = (under[0] + face[0], under[1] + face[1]), (under[0] + drive[0], under[1] + drive[1])
    starts = ((0.0, 0.0), under, corner, under, foot)
    scale = LONGEST / max(size for _, _, size, _ in loads)
    items: list[Any] = []
    for (x, y), (words, by, size, role), aside in zip(starts, loads, POLYGON, strict=True):
        way = (scale * by[0], scale * by[1])
        items += _force((scale * x, scale * y), way, words, size, role, aside=aside)
    return Panel(BARE, BARE, tuple(items), equal=True, bare=True)
