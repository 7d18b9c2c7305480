"""Outlines of vehicles as seen from above: cars, and two-wheelers where a vehicle is that narrow."""

import math

from dynamics_cli.pictures import Curve

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    Pair = tuple[float, float]
    Place = Callable[[Sequence[Pair]], tuple[list[float], list[float]]]

# A neutral outline, where nothing is known of a vehicle's size.
LENGTH, WIDTH = 4.5, 1.8
# What is narrower is a motorcycle or a bicycle.
NARROW = 1.1


def outline(at: "Pair", way: "Pair", role: int, *, length: float = LENGTH, width: float = WIDTH) -> "list[Any]":
    """A vehicle with its centre at a point and its nose in a direction: body, windscreen or handlebar, nose, wheels."""
    x, y = way

    def place(points: "Sequence[Pair]") -> "tuple[list[float], list[float]]":
        return [at[0] + a * x - b * y for a, b in points], [at[1] + a * y + b * x for a, b in points]

    drawn = _two_wheeler if width < NARROW else _car
    return drawn(place, role, length, width)


def _two_wheeler(place: "Place", role: int, length: float, width: float) -> "list[Any]":
    half, side, wheel = 0.36 * length, 0.25 * width, 0.14 * length
    turn = [math.pi * step / 12.0 for step in range(25)]
    bar, tip = 0.22 * length, 0.3 * length
    return [
        Curve(*place([(half * math.cos(t), side * math.sin(t)) for t in turn]), "", "filled", role),
        Curve(*place([(bar, 0.5 * width), (bar, -0.5 * width)]), "", "solid", role),
        Curve(*place([(tip, 0.0), (0.5 * bar, 0.7 * side), (0.5 * bar, -0.7 * side), (tip, 0.0)]), "", "filled", role),
        *(Curve(*place([(end - wheel, 0.0), (end + wheel, 0.0)]), "", "thick", role) for end in (half, -half)),
    ]


def _car(place: "Place", role: int, length: float, width: float) -> "list[Any]":
    half, side = 0.5 * length, 0.5 * width
    corner = 0.25 * width
    body = [
        (half - corner, side), (half - 0.3 * corner, side - 0.3 * corner), (half, side - corner),
        (half, corner - side), (half - 0.3 * corner, 0.3 * corner - side), (half - corner, -side),
        (-half, -side), (-half, side), (half - corner, side),
    ]  # fmt: skip
    screen = [(0.15 * length, 0.4 * width), (0.05 * length, 0.35 * width), (0.05 * length, -0.35 * width),
              (0.15 * length, -0.4 * width), (0.15 * length, 0.4 * width)]  # fmt: skip
    nose = [(0.44 * length, 0.0), (0.3 * length, 0.14 * length), (0.3 * length, -0.14 * length), (0.44 * length, 0.0)]
    nose = [(a, b * width / (0.4 * length)) for a, b in nose]
    items: list[Any] = [
        Curve(*place(body), "", "filled", role),
        Curve(*place(screen), "", "filled", role),
        Curve(*place(nose), "", "filled", role),
    ]
    for along in (0.31 * length, -0.31 * length):
        for across in (side, -side):
            ends = [(along - 0.07 * length, across), (along + 0.07 * length, across)]
            items.append(Curve(*place(ends), "", "thick", role))
    return items
