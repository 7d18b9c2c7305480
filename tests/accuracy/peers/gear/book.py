"""Further ways beside those of `alternatives/gear/book`."""

from math import tan

from dynamics_cli.accuracy.alternatives.gear.book import pair, spur
from dynamics_cli.accuracy.alternatives.gear.involute import newton
from peers.gear.involute import brent_inverse

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Function = Callable[[float], float]
    Crossing = Callable[[Function, float], float]


def tabulated(angle: float) -> float:
    """The same as tables print it: six decimals."""
    return round(tan(angle) - angle, 6)


def spur_by_table(**given: "Any") -> "dict[str, float]":
    """The same, involutes looked up."""
    return spur(**given, inv=tabulated)


def by_halving(f: "Function", low: float) -> float:
    """Where the teeth are pointed, by halving."""
    high = low + 1.0
    while f(high) > 0.0:
        low, high = high, high + 1.0
    while low < (middle := 0.5 * (low + high)) < high:
        low, high = (middle, high) if f(middle) > 0.0 else (low, middle)
    return low


def spur_by_radii(**given: "Any") -> "dict[str, float]":
    """The same with thicknesses as differences of half angles at the base circle, and the pointed tip by halving."""
    return spur(**given, crossing=by_halving)


def pair_by_table(**given: "Any") -> "dict[str, float]":
    """The same, involutes looked up to six decimals and back."""
    return pair(**given, inv=tabulated, inverse=lambda value: newton(round(value, 6))["phi"])


def pair_by_brent(**given: "Any") -> "dict[str, float]":
    """The same, the working angle by Brent's bracketed method."""
    return pair(**given, inverse=lambda value: brent_inverse(value)["phi"])
