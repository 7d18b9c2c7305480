"""Further ways beside those of `alternatives/inertia/walls`."""

from math import pi

from dynamics_cli.accuracy.alternatives.inertia.walls import _given, _results

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from dynamics_cli.accuracy.cases import Case

    # Measure, height of the centroid, and second moments about the centroid, for a mass of one.
    Solid = tuple[float, float, float, float, float]


def as_surface(case: "Case") -> "Callable[[], dict[str, float]]":
    """All mass on the surface in the middle of the wall; balls, tubes and rings only."""
    record, sizes, mass = _given(case)
    if record not in ("Annulus", "HollowSphere", "HollowCylinder", "HollowTorus"):
        raise ArithmeticError

    def answer() -> "dict[str, float]":
        wall = sizes["thickness"]
        radius = sizes["radius"] - 0.5 * wall
        across, along, area = radius**2 / 2.0, 0.0, 2.0 * pi * radius
        if record == "HollowSphere":
            across = along = radius**2 / 3.0
            area = 4.0 * pi * radius**2
        elif record == "HollowCylinder":
            along, area = sizes["length"] ** 2 / 12.0, area * sizes["length"]
        elif record == "HollowTorus":
            ring = sizes["ring_radius"]
            across, along, area = ring**2 / 2.0 + 0.75 * radius**2, radius**2 / 2.0, 2.0 * pi * ring * area
        return _results(mass, area * wall, 0.0, (across, across, along), flat=record == "Annulus")

    return answer
