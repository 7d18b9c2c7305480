"""Formulas in doubles or, as small devices and old programs calculate, in numbers of 32 bits."""

import math
from types import SimpleNamespace

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

DOUBLES = SimpleNamespace(
    sqrt=math.sqrt, sin=math.sin, cos=math.cos, tan=math.tan, atan=math.atan, acos=math.acos, asin=math.asin
)


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
        return SimpleNamespace(**fields, kind=type(value).__name__)
    return value


def kind_of(group: "Any") -> str:
    """Which of its union's records a group is, in either kind of numbers."""
    return getattr(group, "kind", type(group).__name__)
