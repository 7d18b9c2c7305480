"""Numbers with rounding bounds for tasks that work on arrays: conversion to and from them, tightening, statement."""

from dynamics_cli.errors import DynamicsError
from dynamics_cli.numerics.number import is_carrier
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.records import ErrorBound, over_parts

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any


def carried(part: "Any") -> "Any":
    """The doubles of records and dictionaries as exact numbers that will carry bounds, without derivatives."""
    if type(part) is float:
        return Tracked(part, 0.0, ())
    return over_parts(part, carried)


def in_many_digits(part: "Any") -> "Any":
    """The doubles of records and dictionaries as numbers of 60 digits."""
    if type(part) is float:
        from dynamics_cli.numerics.exact.many_digits import ManyDigits

        return ManyDigits.inputs([part])[0]
    return over_parts(part, in_many_digits)


def bare(part: "Any") -> "Any":
    """The plain doubles again."""
    if is_carrier(part):
        return part.value
    return over_parts(part, bare)


def in_digits(call: "Callable[[], Any]") -> "Any":
    """The result of a call in 60-digit arithmetic; None where that leads to a refusal."""
    from dynamics_cli.numerics.exact.many_digits import run

    try:
        return run(call)
    except (DynamicsError, ArithmeticError):
        return None


def measured(value: float, exact: "Any", bound: float) -> float:
    """The error of a value against the same number in many digits; its bound if there is none."""
    from dynamics_cli.numerics.exact.many_digits import ManyDigits, measured_error

    return measured_error(value, exact, bound) if isinstance(exact, ManyDigits) else bound


def tighten(numbers: "Iterable[Any]", exact: "Iterable[Any]") -> None:
    """Replace the bounds of numbers by their errors as measured against the same numbers in many digits."""
    for number, reference in zip(numbers, exact, strict=True):
        if isinstance(number, Tracked):
            number.error = measured(number.value, reference, number.error)


def error_of(number: "Any") -> float:
    """The rounding bound of a number."""
    return number.error if isinstance(number, Tracked) else 0.0


def with_error(number: "Any", error: float) -> "Any":
    """A number with another bound; one without a bound is unchanged."""
    return Tracked(number.value, error, number.slopes) if isinstance(number, Tracked) else number


def share(name: str, number: "Any") -> ErrorBound:
    """The bound of a result relative to it; absolute where the result is zero."""
    size = abs(bare(number))
    if size == 0.0:
        return ErrorBound(name, error_of(number), relative=False)
    return ErrorBound(name, error_of(number) / size * (1.0 + 2.0**-50))


def width(name: str, number: "Any", more: float = 0.0) -> ErrorBound:
    """The bound of a result that is a difference, in its own unit."""
    return ErrorBound(name, error_of(number) + more, relative=False)
