"""Orientation as textbooks have it: arc functions lose digits at small angles, half turns and near lock."""

import math

from dynamics_cli.accuracy.questions import textbooks
from dynamics_cli.numerics.orientation.sequences import sequence_of
from dynamics_cli.orient.turns.attitude import orientation

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.orient.turns.attitude import Attitude


def _addresses(name: str, v: "Any") -> "dict[str, float]":
    return {f"{name}[{k}]": x for k, x in enumerate(v)}


def textbook(turn: "Attitude", sequence: str) -> "dict[str, float]":
    """Angle by the arc cosine of the trace, axis over its sine, quaternion by the trace, angles by an arc sine."""
    m = orientation(turn).matrix
    angle = math.acos(min(1.0, max(-1.0, 0.5 * (m[0][0] + m[1][1] + m[2][2] - 1.0))))
    over = 0.5 / math.sin(angle)
    axis = [over * (m[2][1] - m[1][2]), over * (m[0][2] - m[2][0]), over * (m[1][0] - m[0][1])]
    w = 0.5 * math.sqrt(1.0 + m[0][0] + m[1][1] + m[2][2])
    share = 0.25 / w
    quaternion = [w, share * (m[2][1] - m[1][2]), share * (m[0][2] - m[2][0]), share * (m[1][0] - m[0][1])]
    return {
        "rotation_angle": angle,
        **_addresses("rotation_axis", axis),
        **_addresses("quaternion", quaternion),
        **_addresses("rotation_vector", [angle * part for part in axis]),
        **_addresses("euler_angles", _angles(m, sequence)),
    }


def _angles(m: "Any", sequence: str) -> "tuple[float, ...]":
    """The middle angle by its arc function, the others by two elements each."""
    order = sequence_of(sequence)
    i, j, k = order.axes
    e, last = order.cycle, 3 - i - j
    if order.repeats:
        b = math.acos(min(1.0, max(-1.0, m[i][i])))
        first, third = (m[j][i], -e * m[last][i]), (m[i][j], e * m[i][last])
    else:
        b = math.asin(min(1.0, max(-1.0, e * m[i][k])))
        first, third = (-e * m[j][k], m[k][k]), (-e * m[i][j], m[i][i])
    a, c = math.atan2(*first), math.atan2(*third)
    return (c, b, a) if order.fixed else (a, b, c)


QUESTIONS = textbooks(
    "orient", "orient.json", "dynamics_cli.accuracy.alternatives.orient:",
    ("convert", "textbook, acos and asin", "textbook"),
)  # fmt: skip
