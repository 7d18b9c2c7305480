"""Further ways beside those of `alternatives/gear/measure`."""

from dynamics_cli.accuracy.alternatives.gear.measure import _measured
from peers.gear.involute import brent_inverse

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Inverse = Callable[[float], dict[str, float]]


def by_brent(**given: "Any") -> "dict[str, float]":
    """The same by Brent's method."""
    return _measured(given, brent_inverse)
