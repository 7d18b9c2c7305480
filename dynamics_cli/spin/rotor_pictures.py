"""A rotor out of line between its bearings, and the loads that turn with the shaft."""

import math

from dynamics_cli.errors import worded
from dynamics_cli.numerics.number import plain
from dynamics_cli.pictures import Arrow, Axis, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Force, ShaftSpeed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

LEFT, RIGHT, MIDDLE, GREY = 0, 1, 2, 6
BARE = Axis("")
POINTS = 60
# Of a rotor beside a span of one: half its height, half its width, its tilt and offset as drawn, a bearing's size.
HIGH, WIDE, TILT, OFFSET, BEARING = 0.22, 0.05, 0.22, 0.035, 0.06
# The longest load as drawn.
LONGEST = 0.45
# A shorter arrow is not drawn.
SEEN = 1e-3


def shaft(
    answer: "Any",
    *,
    speed: float,
    span: float,
    position: float,
    eccentricity: float = 0.0,
    skew: float = 0.0,
    skew_direction: float = 0.0,
    **_: "Any",
) -> Picture:
    """The shaft in the plane of its eccentricity, the turning loads seen along it, and their growth with the speed."""
    place = plain(position) / plain(span)
    forces = {
        "left": (plain(answer.left_load), plain(answer.left_angle), LEFT),
        "right": (plain(answer.right_load), plain(answer.right_angle), RIGHT),
        "centrifugal": (plain(answer.force), 0.0, MIDDLE),
    }
    scale = LONGEST / max(size for size, _, _ in forces.values())
    places = {"left": 0.0, "right": 1.0, "centrifugal": place}
    # the plane of the larger bearing load shows most of what happens
    plane = max(forces["left"], forces["right"])[1]
    leaning = plain(skew) * math.cos(plain(skew_direction) - plane)
    off = plain(eccentricity) * math.cos(plane)
    items = _rotor(place, *(math.copysign(most, part) if abs(part) > 1e-12 else 0.0
                            for part, most in ((off, OFFSET), (leaning, TILT))))  # fmt: skip
    for name, (size, angle, role) in forces.items():
        up = scale * size * math.cos(angle - plane)
        if abs(up) > SEEN:
            start = math.copysign(HIGH if name == "centrifugal" else BEARING, up)
            items.append(Arrow(places[name], start, 0.0, up, "", role))
    side = Panel(BARE, BARE, tuple(items), equal=True, bare=True)
    end = Panel(
        BARE, BARE, tuple(_end(forces, scale, plain(skew), plain(skew_direction))), equal=True, bare=True
    )  # fmt: skip
    title = worded("bearing loads turning with the shaft at {speed}", speed=(plain(speed), ShaftSpeed))
    subtitle = "in the plane of the larger load, offset and tilt enlarged; and seen from the right"
    return Picture((side, end, _growth(forces, plain(speed))), title, columns=2, subtitle=subtitle)


def _rotor(place: float, height: float, tilt: float) -> "list[Any]":
    """Shaft, bearings as triangles, and the rotor with the axis that it is not on."""
    first, last = min(0.0, place), max(1.0, place)
    items: list[Any] = [Curve([first - 0.12, last + 0.12], [0.0, 0.0], "", "centre", GREY)]
    items.append(Curve([min(first, place - 0.05), max(last, place + 0.05)], [0.0, 0.0], "", "thick", GREY))
    for x in (0.0, 1.0):
        size = BEARING
        items.append(Curve([x, x - size, x + size, x], [0.0, -1.6 * size, -1.6 * size, 0.0], "", "filled", GREY))
    cosine, sine = math.cos(tilt), math.sin(tilt)
    corners = [(WIDE * i, HIGH * j) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))]
    turned = [(place + u * cosine - v * sine, height + u * sine + v * cosine) for u, v in corners]
    items.append(Curve([u for u, _ in turned], [v for _, v in turned], "", "filled", MIDDLE))
    if tilt:
        length = 0.3
        along, up = length * cosine, length * sine
        items.append(Curve([place - along, place + along], [height - up, height + up], "", "centre", MIDDLE))
    items.append(Mark(place, height, "", role=MIDDLE))
    items += [Label(x, -2.6 * BEARING, words, role) for x, words, role in ((0.0, "left", LEFT), (1.0, "right", RIGHT))]
    return items


def _end(forces: "Any", scale: float, skew: float, leans: float) -> "list[Any]":
    """The loads about the shaft's axis, counted from the eccentricity, which points up."""
    turns = [2.0 * math.pi * k / POINTS for k in range(POINTS + 1)]
    items: list[Any] = [
        Curve([0.5 * HIGH * math.cos(t) for t in turns], [0.5 * HIGH * math.sin(t) for t in turns], "", "filled", GREY)
    ]
    items.append(Curve([0.0, 0.0], [0.0, 1.2 * LONGEST], "", "centre", GREY))
    for name, (size, angle, role) in forces.items():
        if scale * size < SEEN:
            continue
        by = (-scale * size * math.sin(angle), scale * size * math.cos(angle))
        items.append(Arrow(0.0, 0.0, *by, worded(name + " {size}", size=(size, Force)), role))
    if skew:
        turned = leans if skew > 0.0 else leans + math.pi
        x, y = -1.25 * HIGH * math.sin(turned), 1.25 * HIGH * math.cos(turned)
        items += [Curve([0.0, x], [0.0, y], "", "dotted", GREY), Label(1.15 * x, 1.15 * y, "leans here", GREY)]
    items.append(Label(0.0, 1.28 * LONGEST, "eccentricity", GREY))
    return items


def _growth(forces: "Any", speed: float) -> Panel:
    top = 1.25 * abs(speed)
    speeds = [top * k / POINTS for k in range(POINTS + 1)]
    items: list[Any] = []
    for name in ("left", "right"):
        size, _, role = forces[name]
        items.append(
            Curve(speeds, [size * (x / speed) ** 2 for x in speeds], name, "dashed" if role else "solid", role)
        )
        items.append(Mark(abs(speed), size, "", role=role))
    return Panel(Axis("speed", ShaftSpeed), Axis("bearing load", Force), tuple(items), wide=True)
