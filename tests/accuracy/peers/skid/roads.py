"""Further ways beside those of `alternatives/skid/roads`."""

import math

from dynamics_cli.accuracy.alternatives.skid.roads import _spin

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def spin_by_degrees(
    *, drag: "Any", distance: float, friction: float, end_speed: float, grade: float, gravity: float
) -> "dict[str, float]":
    """The mean of |sin| as the sum over steps of a degree, each in its middle; all else alike."""
    if type(drag).__name__ == "Share":
        share = drag.drag_share
    else:
        count = max(1, math.ceil(math.degrees(drag.rotation)))
        step = drag.rotation / count
        mean = sum(abs(math.sin(drag.start_angle + (k + 0.5) * step)) for k in range(count)) / count
        share = drag.rolling_drag + (1 - drag.rolling_drag) * mean
    return _spin(drag, share, distance, friction, end_speed, grade, gravity, math)
