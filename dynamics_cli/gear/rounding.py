"""Numbers that carry rounding bounds through tasks that work on arrays: put in, taken out, tightened and stated."""

from dynamics_cli.errors import DynamicsError
from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF, Tracked
from dynamics_cli.records import ErrorBound

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any

# How many half last bits of its size a bound may be before it is worth a second pass.
ROOM = 20.0


def carried(part: "Any") -> "Any":
    """The doubles of records and dictionaries as exact numbers that will carry bounds, without derivatives."""
    if type(part) is float:
        return Tracked(part, 0.0, ())
    return _over(part, carried)


def in_many_digits(part: "Any") -> "Any":
    """The doubles of records and dictionaries as numbers of 60 digits."""
    if type(part) is float:
        from dynamics_cli.numerics.many_digits import ManyDigits

        return ManyDigits.inputs([part])[0]
    return _over(part, in_many_digits)


def bare(part: "Any") -> "Any":
    """The plain doubles again."""
    if hasattr(part, "apply"):
        return part.value
    return _over(part, bare)


def tighten(numbers: "Iterable[tuple[Any, float]]", again: "Callable[[], Iterable[tuple[Any, float]]]") -> None:
    """Replace loose bounds of numbers (each with its size) by what the same numbers in many digits tell of their error.

    Where many digits go another way (to a refusal, to no number) the bounds stay.
    """
    own = list(numbers)
    if not any(
        error_of(one) > ROOM * UNIT_ROUNDOFF * max(abs(bare(one)), size) for one, size in own if one is not None
    ):
        return
    from dynamics_cli.numerics.many_digits import ManyDigits, measured_error, run

    try:
        exact = run(lambda: list(again()))
    except (DynamicsError, ArithmeticError):
        return
    for (one, _), (other, _) in zip(own, exact, strict=True):
        if isinstance(one, Tracked) and isinstance(other, ManyDigits):
            one.error = measured_error(one.value, other, one.error)


def _over(part: "Any", function: "Any") -> "Any":
    if isinstance(part, dict):
        return {name: function(item) for name, item in part.items()}
    if isinstance(part, tuple):
        return tuple(function(item) for item in part)
    if hasattr(part, "fields"):
        return type(part)(**{name: function(getattr(part, name)) for name in part.fields})
    return part


def like(number: float, beside: "Any") -> "Any":
    """A double, exact as it is, as a number like the one it stands beside."""
    if isinstance(beside, Tracked):
        return Tracked(number, 0.0, (0.0,) * len(beside.slopes))
    return type(beside).inputs([number])[0] if hasattr(beside, "apply") else number


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
