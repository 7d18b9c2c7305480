"""Conversions: exact rationals rounded once, factors held as doubles, and pint."""

from functools import cache
from statistics import median

from dynamics_cli.accuracy.cases import Case, load
from dynamics_cli.accuracy.measure import Errors, Pace, seconds
from dynamics_cli.accuracy.questions import Comparison
from dynamics_cli.accuracy.rows import row

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.rows import Row

# pint is there wherever the program is: it is named among the libraries of others, and always takes part.
QUESTIONS = (
    Comparison("convert", "", "convert", "dynamics_cli.accuracy.alternatives.convert:compare", needs=("pint",)),
)


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


@cache
def _registry() -> "Any":
    from dynamics_cli.core.units.fallback import registry

    return registry()


def by_pint(case: Case) -> "Callable[[], float]":
    """The usual library, its quantity made and converted."""
    source, target = (case.inputs[key].replace("^", "**").replace("rev", "turn") for key in ("from", "to"))
    value, quantity = float(case.inputs["value"]), _registry().Quantity
    return lambda: float(quantity(value, source).to(target).magnitude)


# What is rounded once is within half a last bit, and the document says so.
ONE_ROUNDING = 2.0**-53
METHODS: "tuple[tuple[str, Callable[[Case], Callable[[], float]], float | None], ...]" = (
    ("exact rational factor (chosen)", exact, ONE_ROUNDING),
    ("factors as doubles", doubles, None),
    ("pint", by_pint, None),
)


def compare(name: str, *, hard: bool, full: bool, timed: bool) -> "list[Row]":
    """Every method over every case."""
    pace = Pace(full=full)
    cases = [case for case in load("convert.json") if case.hard or not hard]
    made: list[Row] = []
    base: float | None = None
    for method, prepare, stated in METHODS:
        errors = Errors()
        for case in cases:
            errors.cases += 1
            value = prepare(case)()
            errors.add(case.name, value, case.results["value"], None if stated is None else stated * abs(value))
        time = None
        if timed:
            some = cases[: pace.timed_cases]
            time = median([seconds(prepare(case), repeats=pace.repeats, least=pace.least) for case in some])
        base = base or time
        made.append(row(name, method, errors, time, base))
    return made
