"""Points of a cam along the radius."""

from dynamics_cli.accuracy.alternatives.cam.extremes import angles, pitch_curve

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.cam.geometry.contact import Geometry


def by_radius(geometry: "Geometry", motion: "Any") -> "tuple[Any, Any]":
    """The roller's radius taken off along the radius, as if the pressure angle were zero."""
    import numpy as np

    x, y = pitch_curve(geometry, motion, angles())
    share = 1.0 - geometry.side * geometry.roller / np.hypot(x, y)
    return x * share, y * share
