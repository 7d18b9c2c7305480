"""Impulses beside their references: errors in shares of the whole impulse, for methods that give parts of it."""

from decimal import Decimal
from math import inf, isfinite

from dynamics_cli.accuracy.measure import DIGITS, Errors, seconds

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row

    Parts = tuple[float, ...]
    # makes the call of a case; raises ArithmeticError where the method has no answer
    Prepared = Callable[[Case], Callable[[], Parts]]


class Way:
    """A method: its name, what makes its call, and what it states for its error in a case, if anything.

    `many` makes a call that answers a case so many times at once, where the method takes arrays.
    """

    def __init__(
        self,
        name: str,
        prepare: "Prepared",
        stated: "Callable[[Case], float] | None" = None,
        many: "Callable[[Case, int], Callable[[], object]] | None" = None,
    ) -> None:
        self.name = name
        self.prepare = prepare
        self.stated = stated
        self.many = many


def share(case: "Case", parts: "Parts", names: "Sequence[str]") -> float:
    """The largest error of the parts, over the size of the impulse."""
    exact = [Decimal(case.results[name]) for name in names]
    size = DIGITS.sqrt(sum((DIGITS.multiply(part, part) for part in exact), Decimal(0)))
    if not all(map(isfinite, parts)):
        return inf
    worst = max(abs(DIGITS.subtract(Decimal(part), true)) for part, true in zip(parts, exact, strict=True))
    return float(DIGITS.divide(worst, size))


def compared(
    comparing: "Comparing", cases: "Sequence[Case]", ways: "Sequence[Way]", names: "Sequence[str]"
) -> "list[Row]":
    """Rows of the ways, the chosen one first."""

    def answer(errors: "Errors", case: "Case", method: "Any", index: int) -> "Callable[[], Parts]":
        way = method if isinstance(method, Way) else Way("", method)
        call = way.prepare(case)
        error = share(case, call(), names)
        if error == inf:
            raise ArithmeticError
        errors.note(case.name, error, way.stated(case) if way.stated else None)
        errors.found[f"{index} impulse"] = error
        return call

    def arrays(method: "Any") -> "float | None":
        if not getattr(method, "many", None):
            return None
        pace = comparing.pace
        return seconds(method.many(cases[0], pace.rows), repeats=3, least=pace.least) / pace.rows

    pairs = [(way.name, way) for way in ways]
    return comparing.rows(pairs, cases, answer, most=4, repeats=3, shared=True, arrays=arrays)
