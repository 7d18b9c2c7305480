"""The tasks of `dynamics path`."""

from dynamics_cli.core.answering.task import Family
from dynamics_cli.path.commands import coordinates, curves

FAMILIES = {
    "path": Family(
        "path",
        "Motion of a point: straight, on circles and curves, from measured tracks.",
        curves.RECTILINEAR,
        coordinates.CIRCLE,
        coordinates.POLAR,
        coordinates.CYLINDRICAL,
        coordinates.SPHERICAL,
        coordinates.COMPONENTS,
        curves.CURVE,
        curves.TABLE,
        coordinates.RELATIVE,
        coordinates.MOVING_FRAME,
    )
}
