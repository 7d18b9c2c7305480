"""Conversions: exact rationals rounded once, and factors held as doubles."""

from dynamics_cli.accuracy.cases import Case
from dynamics_cli.accuracy.questions import Comparison

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.measure import Errors
    from dynamics_cli.accuracy.rows import Row

QUESTIONS = (Comparison("convert", "", "convert", "dynamics_cli.accuracy.alternatives.convert:compare"),)


def exact(case: Case) -> "Callable[[], float]":
    """The program's own: the decimal as written, an exact factor, one rounding."""
    from dynamics_cli.core.inputs.quantity_text import read_amount
    from dynamics_cli.core.units.conversion import convert, nearest
    from dynamics_cli.core.units.lookup import parse_pair

    source, target = parse_pair(case.inputs["from"], case.inputs["to"])
    ((numerator, denominator, _),) = read_amount(case.inputs["value"]).parts
    return lambda: nearest(*convert(numerator, denominator, source, target))


def doubles(case: Case) -> "Callable[[], float]":
    """To SI and back by factors that are doubles: three roundings and more."""
    from dynamics_cli.core.units.lookup import parse_pair

    value = float(case.inputs["value"])
    (a, zero), (b, origin) = (_double(unit) for unit in parse_pair(case.inputs["from"], case.inputs["to"]))
    return lambda: (value * a + zero - origin) / b


def _double(unit: "Any") -> "tuple[float, float]":
    from math import pi

    return unit.numerator / unit.denominator * pi**unit.pi, unit.offset[0] / unit.offset[1]


# What is rounded once is within half a last bit, and the document says so.
ONE_ROUNDING = 2.0**-53
METHODS = (("exact rational factor (chosen)", exact), ("factors as doubles", doubles))


def compare(comparing: "Comparing") -> "list[Row]":
    """Every method over every case."""

    def answer(errors: "Errors", case: Case, prepare: "Callable[[Case], Any]", _: int) -> "Callable[[], float]":
        call = prepare(case)
        value = call()
        stated = ONE_ROUNDING * abs(value) if prepare is exact else None
        errors.add(case.name, value, case.results["value"], stated)
        return call  # type: ignore[no-any-return]

    return comparing.rows(METHODS, comparing.cases("convert.json"), answer, most=comparing.pace.timed_cases)
