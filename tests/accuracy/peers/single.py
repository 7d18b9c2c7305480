"""The textbooks' formulas in numbers of 32 bits, as small devices and old programs calculate."""

from types import SimpleNamespace

from dynamics_cli.accuracy.alternatives import coords
from dynamics_cli.accuracy.alternatives.gear import sizes
from dynamics_cli.accuracy.alternatives.impact import damage
from dynamics_cli.accuracy.alternatives.skid import flights, roads

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


def single(function: "Callable[..., dict[str, Any]]") -> "Callable[..., dict[str, float]]":
    """The same formula, every number and every operation of 32 bits; it takes elementary functions as `m`."""

    def made(**given: "Any") -> "dict[str, float]":
        import numpy as np

        functions = SimpleNamespace(
            sqrt=np.sqrt, sin=np.sin, cos=np.cos, tan=np.tan, atan=np.arctan, acos=np.arccos, asin=np.arcsin
        )
        with np.errstate(all="ignore"):
            found = function(**{name: _narrow(value, np) for name, value in given.items()}, m=functions)
        return {name: float(value[0]) for name, value in found.items()}

    return made


def _narrow(value: "Any", np: "Any") -> "Any":
    if isinstance(value, float):
        # an array: plain numbers beside it do not widen it, whichever the numpy
        return np.array([value], dtype=np.float32)
    if isinstance(value, tuple):
        return tuple(_narrow(one, np) for one in value)
    if hasattr(value, "fields"):
        fields = {name: _narrow(getattr(value, name), np) for name in value.fields}
        # formulas tell records apart by the names of their classes
        return type(type(value).__name__, (SimpleNamespace,), {})(**fields)
    return value


cylindrical = single(coords.textbook_cylindrical)
spherical = single(coords.textbook_spherical)
cartesian_from_cylindrical = single(coords.cartesian_from_cylindrical)
spherical_from_cylindrical = single(coords.spherical_from_cylindrical)
cartesian_from_spherical = single(coords.cartesian_from_spherical)
cylindrical_from_spherical = single(coords.cylindrical_from_spherical)
speed = single(roads.speed_by_slope_angle)
distance = single(roads.distance_by_squares)
yaw = single(roads.yaw_by_bank_angle)
friction = single(roads.friction_by_sums)
drag_factor = single(roads.drag_by_angles)
stop = single(roads.stop_by_book)
avoid = single(roads.avoid_by_roots)
spin = single(roads.spin_by_differences)
least_vault = single(flights.least_vault_by_book)
vault = single(flights.vault_by_book)
pedestrian = single(flights.throw_by_searle)
yaw_inertia = single(damage.yaw_by_gyration)
bevel = single(sizes.bevel_by_book)
worm = single(sizes.worm_by_book)
