"""The textbook's gears with involutes looked up in a table, and by other solvers."""

from functools import partial
from math import atan, cos, sin, tan
from unittest.mock import patch

from dynamics_cli.accuracy.alternatives.gear import book, sizes
from peers.gear.involute import brent_inverse

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Function = Callable[[float], float]


def _tabulated(angle: float) -> float:
    """The involute as tables print it: six decimals."""
    return round(tan(angle) - angle, 6)


def _looked_up(name: str, **given: "Any") -> "dict[str, float]":
    """A calculation of the handbook's with the table's involutes."""
    with patch.object(book, "involute", _tabulated):
        return getattr(book, name)(**given)  # type: ignore[no-any-return]


spur_by_table, pair_by_table = partial(_looked_up, "spur"), partial(_looked_up, "pair")
pair_by_brent = partial(book.pair, inverse=brent_inverse)
measure_by_brent = partial(book.measure, inverse=brent_inverse)


def by_halving(f: "Function", low: float) -> float:
    """Where the teeth are pointed, by halving."""
    high = low + 1.0
    while f(high) > 0.0:
        low, high = high, high + 1.0
    while low < (middle := 0.5 * (low + high)) < high:
        low, high = (middle, high) if f(middle) > 0.0 else (low, middle)
    return low


def spur_by_halving(**given: "Any") -> "dict[str, float]":
    """The pointed tip by halving."""
    with patch.object(book, "by_secants", by_halving):
        return book.spur(**given)


def crossed_by_brent(**given: "Any") -> "dict[str, float]":
    """The working angle by Brent's bracketed method."""
    with patch.object(sizes, "newton", brent_inverse):
        return sizes.crossed(**given)


def worm_by_angles(**given: "Any") -> "dict[str, float]":
    """η = tan γ/tan(γ + ρ'), η' = tan(γ − ρ')/tan γ with tan ρ' = μ/cos α, as of a screw."""
    results = sizes.worm(**given)
    lead, rho = results["lead_angle"], atan(given["friction"] / cos(given["pressure_angle"]))
    results |= {"efficiency": tan(lead) / tan(lead + rho), "backward_efficiency": tan(lead - rho) / tan(lead)}
    if given.get("torque") is not None:
        push = 2 * given["torque"] / given["worm"].worm_diameter
        results["worm_axial_force"] = push / tan(lead + rho)
        results["radial_force"] = push * tan(given["pressure_angle"]) * cos(rho) / sin(lead + rho)
    return results
