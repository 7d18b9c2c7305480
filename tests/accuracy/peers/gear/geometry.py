"""Further ways beside those of `alternatives/gear/geometry`."""

from math import atan, cos, tan

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def pair_by_py_gearworks(
    *, first: "Any", second: "Any", pitch: "Any", pressure_angle: float, helix_angle: float, internal: bool, tips: str,
    centre_distance: "float | None" = None,
) -> "dict[str, float]":  # fmt: skip
    """The distance of two gears by PyPI's `py_gearworks`, from radii and half angles in doubles; external pairs."""
    from math import pi

    from py_gearworks.gearmath import calc_involute_mesh_distance  # type: ignore[import-not-found]

    if centre_distance is not None or internal:
        raise ArithmeticError
    transverse = atan(tan(pressure_angle) / cos(helix_angle))
    sizes = [
        (
            0.5 * one.teeth * pitch.module / cos(helix_angle) * cos(transverse),
            (0.5 * pi + 2.0 * one.profile_shift * tan(pressure_angle)) / one.teeth + tan(transverse) - transverse,
        )
        for one in (first, second)
    ]
    (radius, half), (other, width) = sizes
    return {"centre_distance": float(calc_involute_mesh_distance(radius, other, half, width, 2.0 * pi / second.teeth))}
