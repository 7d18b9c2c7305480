"""Numbers that carry rounding bounds through tasks that work on arrays: put in, taken out, and stated."""

from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF, Tracked
from dynamics_cli.records import ErrorBound

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def carried(part: "Any") -> "Any":
    """The doubles of records and dictionaries as exact numbers that will carry bounds, without derivatives."""
    if type(part) is float:
        return Tracked(part, 0.0, ())
    return _over(part, carried)


def bare(part: "Any") -> "Any":
    """The plain doubles again."""
    if isinstance(part, Tracked):
        return part.value
    return _over(part, bare)


def _over(part: "Any", function: "Any") -> "Any":
    if isinstance(part, dict):
        return {name: function(item) for name, item in part.items()}
    if isinstance(part, tuple):
        return tuple(function(item) for item in part)
    if hasattr(part, "fields"):
        return type(part)(**{name: function(getattr(part, name)) for name in part.fields})
    return part


def rounded(constant: float, roundings: float, beside: "Any") -> "Any":
    """A constant that was itself rounded, as a number like the one it stands beside."""
    if not isinstance(beside, Tracked):
        return constant
    return Tracked(constant, roundings * UNIT_ROUNDOFF * abs(constant), (0.0,) * len(beside.slopes))


def error_of(number: "Any") -> float:
    """What rounding may have done to a number."""
    return number.error if isinstance(number, Tracked) else 0.0


def share(name: str, number: "Any") -> ErrorBound:
    """The bound of a result as a share of it; as it is where the result is zero."""
    size = abs(bare(number))
    if size == 0.0:
        return ErrorBound(name, error_of(number), relative=False)
    return ErrorBound(name, error_of(number) / size * (1.0 + 2.0**-50))


def width(name: str, number: "Any", more: float = 0.0) -> ErrorBound:
    """The bound of a result that is a difference, in its own unit."""
    return ErrorBound(name, error_of(number) + more, relative=False)
