"""Further ways beside those of `alternatives/impact/damage`."""

from itertools import pairwise

from dynamics_cli.accuracy.alternatives.impact.damage import _crush

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


# Strips that a face between two stations is summed over.
STRIPS = 50


def strips(depths: "tuple[float, ...]", a: float, b: float) -> float:
    """Energy per width of fifty strips between two stations, each as deep as in its middle."""
    total, pieces = 0.0, len(depths) - 1
    for c, d in pairwise(depths):
        for k in range(STRIPS):
            depth = c + (d - c) * (k + 0.5) / STRIPS
            total += a * depth + 0.5 * b * depth**2
    return total / (STRIPS * pieces) + a**2 / (2.0 * b)


def mean(depths: "tuple[float, ...]", a: float, b: float) -> float:
    """Energy per width as if the face were crushed by its mean depth everywhere."""
    depth = (0.5 * (depths[0] + depths[-1]) + sum(depths[1:-1])) / (len(depths) - 1)
    return a * depth + 0.5 * b * depth**2 + a**2 / (2.0 * b)


def crush_by_strips(*, first: "Any", restitution: float, gravity: float, second: "Any" = None) -> "dict[str, float]":
    """The energy of strips of the face, summed."""
    return _crush(strips, first, second, restitution, gravity)


def crush_by_mean(*, first: "Any", restitution: float, gravity: float, second: "Any" = None) -> "dict[str, float]":
    """The mean depth over all the width, as is done in haste: the square of the mean for the mean of squares."""
    return _crush(mean, first, second, restitution, gravity)
