"""Impulses beside their references: errors in shares of the whole impulse, for methods that give parts of it."""

from decimal import Decimal
from math import inf, isfinite

from dynamics_cli.accuracy.measure import DIGITS, Errors, Pace, seconds
from dynamics_cli.accuracy.rows import row

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from dynamics_cli.accuracy.cases import Case
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
    name: str, cases: "Sequence[Case]", ways: "Sequence[Way]", names: "Sequence[str]", *, full: bool, timed: bool,
    more: "Sequence[tuple[str, Any]]" = (),
) -> "list[Row]":  # fmt: skip
    """Rows of the ways, the chosen one first; times are the mean over some of the cases each can answer."""
    pace = Pace(full=full)
    made: list[Row] = []
    base: float | None = None
    own: Errors | None = None
    for way in (*ways, *(Way(*one) for one in more)):
        errors, calls = Errors(), []
        for index, case in enumerate(cases):
            try:
                call = way.prepare(case)
                error = share(case, call(), names)
            except (ArithmeticError, ValueError):
                error = inf
            if error == inf:
                errors.refused += 1
                continue
            calls.append(call)
            errors.cases += 1
            errors.note(case.name, error, way.stated(case) if way.stated else None)
            errors.found[f"{index} impulse"] = error
        some = calls[:: max(1, len(calls) // 4)]
        time = None
        if timed and some:
            time = seconds(lambda: [call() for call in some], repeats=3, least=pace.least) / len(some)  # noqa: B023
        base = base or time
        array_time = None
        if timed and way.many:
            array_time = seconds(way.many(cases[0], pace.rows), repeats=3, least=pace.least) / pace.rows
        made.append(row(name, way.name, errors, time, base, array_time=array_time, own=own))
        own = own or errors
    return made
