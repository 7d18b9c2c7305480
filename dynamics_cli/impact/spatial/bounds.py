"""An impact in space in doubles and again in decimals: results rounded once, with bounds that the two runs prove.

Doubles and decimals follow the same path by the same formulas, so their difference is the loss of doubles on this
impact, however ill-conditioned it is. Decimals of 24 digits, with a series of order 29, lose nine orders less: 1e-6
of the difference bounds their error with three orders to spare. Where that is more than some last bits, 32 digits of
order 38 follow, with seven orders less loss, and then 42, with ten more.
"""

from decimal import Context, Decimal, localcontext

from dynamics_cli.errors import InadmissibleError, require
from dynamics_cli.impact.diagnostics import require_finite
from dynamics_cli.impact.spatial.arithmetic import widened
from dynamics_cli.impact.spatial.results import Solved, SpatialImpact, certificate, report
from dynamics_cli.quantities import Energy
from dynamics_cli.records import Advice, ErrorBound, Numerics, over_parts
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any

UNIT_ROUNDOFF = 2.0**-53
SMALLEST = 5e-324
# A bound of at most this many half units in the last place is tight.
ENOUGH = 64 * Decimal(UNIT_ROUNDOFF)
# Order of the series, digits of the path, digits of the rest: the truncation of the series is below the path's
# precision.
EFFORTS = (29, 24, 80), (38, 32, 95), (50, 42, 110)
# Error as a share of the difference from the run before.
LEFT = {24: Decimal("1e-6"), 32: Decimal("1e-4"), 42: Decimal("1e-7")}
# Refusals that rounding may cause: decimals decide.
DOUBTFUL = "singular", "no-impact"
# Angles are calculated in doubles, by the C library.
ANGLES = ("pdof", "elevation")


def answered(solver: "Callable[..., Solved]", *inputs: "Any", advice: tuple[Advice, ...] = ()) -> SpatialImpact:
    """The answer of a solver that takes doubles and decimals and, for decimals, order and digits of the path."""
    before: dict[str, Any] | None = None
    try:
        solved = solver(*inputs)
        require_finite(solved.end.impulse[2] * solved.before[2], "the energy of the impact")
        answer = report(solved)
        before = dict(numbers(answer))
    except InadmissibleError as error:
        if error.code not in DOUBTFUL:
            raise
    if drawing() and before is not None:
        _refuse_gain(solved)
        return answer
    exact, residuals = widened(inputs), None
    with localcontext(Context()) as context:
        for order, digits, context.prec in EFFORTS:
            try:
                solved = solver(*exact, order=order, digits=digits)
            except ArithmeticError:
                # this many digits need too many steps: the previous run is used
                if residuals is None:
                    raise
                break
            answer = report(solved)
            after = dict(numbers(answer))
            residuals = None if before is None else _left(before, after, digits)
            before = after
            if residuals is not None and all(_small(after[name], error) for name, error in residuals.items()):
                break
        assert residuals is not None
        values, errors = _doubles(after, residuals)
        answer = _rounded(answer, "", values)
    solved = _plain(solved)
    _refuse_gain(solved)
    numerics = Numerics(solved.how, tuple(_stated(values, errors)))
    more = {"checks": certificate(answer, solved), "advice": advice, "numerics": numerics}
    return SpatialImpact(**{**answer.__dict__, **more})


def _refuse_gain(solved: Solved) -> None:
    """Refuse a law that gains energy."""
    end = solved.end
    require(
        solved.restitution > 1.0 or solved.lost + end.heat >= -1e-11 * (end.work + end.heat),
        "{law}: the law gains {gain:6} of energy here, which no passive contact does",
        law=str(solved.law),
        gain=(-(solved.lost + end.heat), Energy),
        code="energy-gained",
        hint="--law stronge never gains energy",
    )


def numbers(tree: "Any", address: str = "") -> "Iterator[tuple[str, Any]]":
    """Every number of an answer by address; not the hour of a clock, which is whole."""
    if hasattr(tree, "fields"):
        for name in tree.fields:
            if name not in ("clock", "checks", "advice", "numerics"):
                yield from numbers(getattr(tree, name), f"{address}.{name}" if address else name)
    elif isinstance(tree, tuple):
        for index, part in enumerate(tree):
            yield from numbers(part, f"{address}[{index}]")
    elif tree is not None and not isinstance(tree, str):
        yield address, tree


def beside(answer: SpatialImpact, full: SpatialImpact) -> SpatialImpact:
    """The answer of a smaller model, with bounds that include its neglected terms."""
    values, widths = dict(numbers(answer)), _widths(answer)
    full_values, full_widths = dict(numbers(full)), _widths(full)
    errors = {name: widths[name] + abs(values[name] - full_values[name]) + full_widths[name] for name in values}
    assert answer.numerics is not None
    numerics = Numerics(answer.numerics.method, tuple(_stated(values, errors)))
    return SpatialImpact(**{**answer.__dict__, "numerics": numerics})


def _widths(answer: SpatialImpact) -> dict[str, float]:
    """Bounds of the numbers of an answer, absolute."""
    assert answer.numerics is not None
    bounds = {bound.result: bound for bound in answer.numerics.bounds}
    return {
        name: bounds[name].bound * (abs(value) if bounds[name].relative else 1.0) for name, value in numbers(answer)
    }


def _left(before: "dict[str, Any]", after: "dict[str, Any]", digits: int) -> dict[str, Decimal]:
    """Remaining error of each number; components of a vector share the largest, as one may agree by chance."""
    shared: dict[str, Decimal] = {}
    sizes = _sizes(after)
    for name, value in after.items():
        vector, apart = name.partition("[")[0], Decimal(0)
        # zero in both is exactly zero
        if value or before[name]:
            apart = LEFT[digits] * abs(Decimal(value) - Decimal(before[name]))
            apart += sizes[_kind(name)].scaleb(-digits)
        shared[vector] = max(apart, shared.get(vector, apart))
    return {name: shared[name.partition("[")[0]] for name in after}


def _kind(name: str) -> str:
    if name.endswith(("impulse_ratio", "stick_friction", *ANGLES)):
        return "number"
    return next((kind for kind in ("energy", "spin", "impulse") if kind in name), "speed")


def _sizes(values: "dict[str, Any]") -> dict[str, Decimal]:
    """The largest number of each kind, the scale for differences of such numbers."""
    sizes = {"energy": abs(values["closing_speed"] * values["normal_impulse"]), "number": Decimal(1)}
    for name, value in values.items():
        kind = _kind(name)
        sizes[kind] = max(abs(Decimal(value)), sizes.get(kind, Decimal(0)))
    return sizes


def _small(value: "Any", error: Decimal) -> bool:
    return not value or error <= ENOUGH * abs(Decimal(value))


def _doubles(exact: "dict[str, Any]", left: dict[str, Decimal]) -> "tuple[dict[str, float], dict[str, float]]":
    """The numbers in doubles, and their errors by rounding, here and where shown in another unit, and by the path."""
    values, errors = {}, {}
    for name, number in exact.items():
        value, error = float(number), float(left[name]) * 1.001
        if abs(value) <= error:
            # indistinguishable from zero
            value, error = 0.0, error + abs(value)
        if value or error:
            error += (8.0 if name.endswith(ANGLES) else 2.0) * UNIT_ROUNDOFF * abs(value) + SMALLEST
        values[name], errors[name] = value, error
    return values, errors


def _stated(values: "dict[str, float]", errors: "dict[str, float]") -> "Iterator[ErrorBound]":
    """Bounds of all numbers, and of each vector one for all its parts, in its unit."""
    vectors: dict[str, float] = {}
    for name, error in errors.items():
        size = abs(values[name])
        yield ErrorBound(name, error / size) if size else ErrorBound(name, error, relative=False)
        vector, bracket, _ = name.partition("[")
        if bracket:
            vectors[vector] = max(error, vectors.get(vector, 0.0))
    for vector, error in vectors.items():
        yield ErrorBound(vector, error, relative=False)


def _rounded(tree: "Any", address: str, values: "dict[str, float]") -> "Any":
    """The answer in the doubles of `values`."""
    if hasattr(tree, "fields"):
        parts = {name: getattr(tree, name) for name in tree.fields}
        return type(tree)(
            **{name: _rounded(part, f"{address}.{name}" if address else name, values) for name, part in parts.items()}
        )
    if isinstance(tree, tuple):
        return tuple(_rounded(part, f"{address}[{index}]", values) for index, part in enumerate(tree))
    return values[address] if isinstance(tree, Decimal) else tree


def _plain(tree: "Any") -> "Any":
    """A solution in doubles."""
    return float(tree) if isinstance(tree, Decimal) else over_parts(tree, _plain)
