"""Error and time of a method: against references in decimal arithmetic, by the median of repeats."""

import math
from decimal import Context, Decimal
from numbers import Integral
from statistics import median
from time import perf_counter

from dynamics_cli.accuracy.cases import Case, build, flat, leaves
from dynamics_cli.errors import DynamicsError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence
    from typing import Any

    from dynamics_cli.accuracy.machine import Peer
    from dynamics_cli.accuracy.questions import Method
    from dynamics_cli.records import ErrorBound

    # What the error of a result is a share of, from its address and the sizes of all results.
    Scale = Callable[[str, dict[str, Decimal]], Decimal]

# Enough digits that the subtraction of a double from a 40-digit reference is exact enough.
DIGITS = Context(prec=60)
SMALLEST_NORMAL = Decimal(2.0**-1022)
# Errors beyond this are shown as this: a tiny number taken for one.
MOST = Decimal("1e300")
HALF_ULP = Decimal(2.0**-53)
# No double is nearer to zero, so that no bound can be smaller either.
SMALLEST = Decimal(2.0**-1074)
# The reference itself is rounded to 40 digits.
REFERENCE = Decimal("1e-39")
# What takes longer than this in all [s] is not timed again.
LONG = 0.25
# What a report on all families takes of a question: so many of its hard cases, fewer where each takes a tenth of a
# second, and so many methods.
MANY, FEW, FEW_METHODS = 30, 2, 2


def representative(cases: "Sequence[Any]", most: int = FEW) -> "Sequence[Any]":
    """The hard ones of many cases, or as many as are wanted, evenly spread."""
    hard = [case for case in cases if getattr(case, "hard", True)] or cases
    return hard[:: max(1, math.ceil(len(hard) / most))]


class Errors:
    """A method's errors over its cases: relative and in units in the last place, and whether its bounds held."""

    def __init__(self) -> None:
        self.relative: list[float] = []
        self.ulps: list[float] = []
        self.looseness: list[float] = []
        self.cases = 0
        self.refused = 0
        self.broken = 0
        self.bounded = 0
        self.worst = ("", -1.0)
        # the true value of that result: a share of one that all but vanishes says little
        self.worst_reference: float | None = None
        # how many results were whole numbers
        self.whole = 0
        # relative errors by case and result, so that methods can be compared over the same ones
        self.by_result: dict[str, float] = {}

    def add(self, where: str, value: float, text: str, bound: "float | None", key: str = "") -> None:
        """Count one result of one case; `key` distinguishes cases of one name."""
        reference = Decimal(text)
        error = _error(value, reference)
        near = float(reference)
        # Below the normal doubles a last bit is a large share of the number, by necessity.
        share = DIGITS.divide(error, max(reference.copy_abs(), SMALLEST_NORMAL)) if near else error
        relative = float(min(share, MOST))
        self.relative.append(relative)
        self.by_result[key or where] = max(relative, self.by_result.get(key or where, 0.0))
        if near or not error:
            # beside zero there is no last place: what is left there is held against the bound
            ulps = float(min(DIGITS.divide(error, Decimal(math.ulp(near))), MOST))
            self.ulps.append(ulps)
            if ulps > self.worst[1]:
                self.worst, self.worst_reference = (where, ulps), near
        if bound is not None:
            self.bounded += 1
            self.broken += Decimal(bound) < error
            # An answer that happens to be exact would make any bound infinitely loose; and what is left beside zero is
            # chance, of a processor's sines as much as of the method.
            least = max(error, DIGITS.multiply(HALF_ULP, reference.copy_abs()))
            if bound and near:
                self.looseness.append(float(min(DIGITS.divide(Decimal(bound), max(least, SMALLEST)), MOST)))

    def decide(self, where: str, value: Integral, text: str, bound: "float | None", key: str) -> None:
        """Count a whole number, which is right or wrong."""
        self.whole += 1
        wrong = int(value) != Decimal(text)
        self.relative.append(float(wrong))
        self.by_result[key] = float(wrong)
        if wrong:
            self.worst, self.worst_reference = (where, math.inf), float(text)
        if bound is not None:
            self.bounded += 1
            self.broken += wrong

    def note(self, where: str, error: float, estimate: "float | None") -> None:
        """Count an error measured as a share of a size, beside the bound or the estimate stated for it."""
        # numbers of numpy are not for documents
        error = float(error)
        self.relative.append(error)
        if error > self.worst[1]:
            self.worst, self.worst_reference = (where, error), None
        if estimate is not None:
            self.bounded += 1
            estimate = float(estimate)
            self.broken += estimate < error
            if estimate:
                self.looseness.append(float(min(Decimal(estimate) / max(Decimal(error), HALF_ULP), MOST)))


def _error(value: float, reference: Decimal) -> Decimal:
    """How far a value is off, but for the rounding of the reference itself."""
    off = DIGITS.subtract(Decimal(value), reference).copy_abs()
    return max(DIGITS.subtract(off, DIGITS.multiply(reference.copy_abs(), REFERENCE)), Decimal(0))


def errors_of(
    function: "Callable[..., Any]", cases: "Sequence[Case]", groups: "Mapping[str, type]", *,
    tracked: bool, foreign: bool = False, scale: "Scale | None" = None,
) -> Errors:  # fmt: skip
    """The errors of a method over its cases; a `foreign` one, of another library, may fail in any way it likes."""
    refusals = Exception if foreign else (DynamicsError, ArithmeticError, ValueError)
    errors = Errors()
    for index, case in enumerate(cases):
        numbers: list[Any] = list(leaves(case.inputs))
        if tracked:
            from dynamics_cli.numerics.tracked import Tracked

            numbers = Tracked.inputs(numbers)

        def call(numbers: "Iterable[Any]", case: "Case" = case) -> "Any":
            return function(**build(case.inputs, iter(numbers), groups), **case.choices)

        try:
            answer = call(numbers)
        except refusals:
            errors.refused += 1
            continue
        if tracked:
            from dynamics_cli.core.answering.tightening import tighten

            tighten(answer, list(leaves(case.inputs)), call)
        try:
            count(errors, case, index, answer, scale, tracked=tracked)
        except ArithmeticError:
            errors.refused += 1
        else:
            errors.cases += 1
    return errors


def count(
    errors: Errors, case: Case, index: int, answer: "Any", scale: "Scale | None" = None, *, tracked: bool = False
) -> None:
    """Count the results of a case that an answer gives, with its bounds; with a `scale` errors are shares of that."""
    results, stated = results_of(answer), stated_by(answer)
    values = {name: getattr(results[name], "value", results[name]) for name in case.results if name in results}
    if not values or not all(map(math.isfinite, values.values())):
        raise ArithmeticError
    sizes = {name: Decimal(text).copy_abs() for name, text in case.results.items()} if scale else {}
    for name, value in values.items():
        bound = getattr(results[name], "error", 0.0 if tracked else None)
        if name in stated:
            bound = stated[name].bound * (abs(value) if stated[name].relative else 1.0)
        where, key, text = f"{case.name}: {name}", f"{index} {name}", case.results[name]
        if scale is None:
            if isinstance(value, Integral):
                errors.decide(where, value, text, bound, key)
            else:
                errors.add(where, float(value), text, bound, key)
            continue
        size = scale(name, sizes)
        share = float(DIGITS.divide(_error(float(value), Decimal(text)), size))
        errors.note(where, share, None if bound is None else float(DIGITS.divide(Decimal(bound), size)))
        errors.by_result[key] = errors.relative[-1]


def results_of(answer: "Any") -> "dict[str, Any]":
    """Results by address, of a record or a dictionary."""
    return answer if isinstance(answer, dict) else flat(answer)


def stated_by(answer: "Any") -> "dict[str, ErrorBound]":
    """The bounds that a solver states for its results."""
    numerics = getattr(answer, "numerics", None)
    return {bound.result: bound for bound in numerics.bounds} if numerics is not None else {}


def seconds(call: "Callable[[], Any]", *, repeats: int, least: float) -> float:
    """The time of one call: the median of repeats, each of as many calls as take `least` seconds."""
    count = 1
    while True:
        start = perf_counter()
        for _ in range(count):
            call()
        took = perf_counter() - start
        if took >= least or count >= 1 << 20:
            break
        count = max(2 * count, min(1 << 20, int(1.2 * count * least / max(took, 1e-9))))
    times = [took / count]
    for _ in range(min(repeats - 1, int(LONG / max(took, 1e-9)))):
        start = perf_counter()
        for _ in range(count):
            call()
        times.append((perf_counter() - start) / count)
    return median(times)


class Pace:
    """How much time the report may take."""

    def __init__(self, *, full: bool, few: bool = False) -> None:
        self.timed_cases = 25 if full else 1 if few else 5
        self.repeats = 15 if full else 5
        self.least = 5e-3 if full else 5e-4


class Asked:
    """What of the report is wanted, and which libraries of others are there."""

    def __init__(
        self, *, hard: bool, full: bool, timed: bool, few: bool, libraries: "Mapping[str, Peer]",
        more: "Mapping[str, Any]",
    ) -> None:  # fmt: skip
        self.hard = hard
        self.full = full
        self.few = few
        self.timed = timed
        self.libraries = libraries
        self.more = more
        self.pace = Pace(full=full, few=few)

    def takes(self, method: "Method") -> bool:
        """Whether a method needs no library, or one that was asked for and is installed."""
        return not method.needs or (method.needs in self.libraries and self.libraries[method.needs].installed)

    def peers_of(self, question: str) -> "list[Method]":
        """The further methods of a question that were asked for and can run."""
        return [method for method in self.more.get(question, ()) if self.takes(method)]


def scalar_time(
    function: "Callable[..., Any]", cases: "Sequence[Case]", groups: "Mapping[str, type]", pace: Pace
) -> "float | None":
    """The median over some cases of the time of one scalar call."""
    times = []
    for case in cases:
        arguments = build(case.inputs, leaves(case.inputs), groups) | case.choices
        try:
            time = seconds(lambda: function(**arguments), repeats=pace.repeats, least=pace.least)  # noqa: B023
        except Exception:
            continue
        times.append(time)
        if len(times) == pace.timed_cases or sum(times) > LONG:
            break
    return median(times) if times else None
