"""Whole motions in degrees."""

from dynamics_cli.accuracy.alternatives.cam.laws import _motion

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.cases import Case


def by_degrees(case: "Case") -> "Callable[[], Any]":
    """Everything in degrees, as a table of a controller has it."""
    from math import degrees, pi

    motion, theta = _motion(case)

    def answer() -> "Any":
        joints = [degrees(joint) for joint in motion.joints]
        place = degrees(theta)
        index = max(i for i in range(len(motion.segments)) if joints[i] <= place)
        segment, width = motion.segments[index], joints[index + 1] - joints[index]
        scale, unit = segment.high - segment.low, 180.0 / pi
        values = segment.law.at((place - joints[index]) / width)
        return (segment.low + scale * values[0], *(scale * values[k] / width**k * unit**k for k in (1, 2, 3)))

    return answer
