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
from dynamics_cli.impact.spatial.straight_slip import End
from dynamics_cli.quantities import Energy
from dynamics_cli.records import Advice, ErrorBound, Numerics
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
        before = dict(numbers(report(solved)))
    except InadmissibleError as error:
        if error.code not in DOUBTFUL:
            raise
    if drawing() and before is not None:
        _refuse_gain(solved)
        return report(solved)
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
        bounds = tuple(_bounds(after, residuals))
        answer = _rounded(answer, "", residuals)
    solved = _plain(solved)
    _refuse_gain(solved)
    more = {"checks": certificate(answer, solved), "advice": advice, "numerics": Numerics(solved.how, bounds)}
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
    assert answer.numerics is not None
    assert full.numerics is not None
    more = {bound.result: bound for bound in full.numerics.bounds}
    values, full_values = dict(numbers(answer)), dict(numbers(full))
    vectors: dict[str, float] = {}
    errors = []
    for bound in answer.numerics.bounds:
        name = bound.result
        if name not in values:
            # a vector's stands after those of its parts
            errors.append(ErrorBound(name, vectors.get(name, 0.0), relative=False))
            continue
        size = abs(values[name])
        error = bound.bound * (size if bound.relative else 1.0) + abs(values[name] - full_values[name])
        error += more[name].bound * (abs(full_values[name]) if more[name].relative else 1.0)
        errors.append(ErrorBound(name, error / size) if size else ErrorBound(name, error, relative=False))
        vector = name.partition("[")[0]
        vectors[vector] = max(error, vectors.get(vector, 0.0))
    numerics = Numerics(answer.numerics.method, tuple(errors))
    return SpatialImpact(**{**answer.__dict__, "numerics": numerics})


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


def _bounds(values: "dict[str, Any]", left: dict[str, Decimal]) -> "Iterator[ErrorBound]":
    """Errors by rounding, here and where a result is shown in another unit, and by the path.

    Of a vector also one for all its parts, in its unit.
    """
    vectors: dict[str, float] = {}
    for name, value in values.items():
        size, error = abs(float(value)), float(left[name]) * 1.001
        if size <= error:
            size, error = 0.0, size + error
        if size or error:
            error += (8.0 if name.endswith(ANGLES) else 2.0) * UNIT_ROUNDOFF * size + SMALLEST
        yield ErrorBound(name, error / size) if size else ErrorBound(name, error, relative=False)
        vector, bracket, _ = name.partition("[")
        if bracket:
            vectors[vector] = max(error, vectors.get(vector, 0.0))
    for vector, error in vectors.items():
        yield ErrorBound(vector, error, relative=False)


def _rounded(tree: "Any", address: str, left: "dict[str, Decimal]") -> "Any":
    """The answer in doubles; numbers indistinguishable from zero are zero."""
    if hasattr(tree, "fields"):
        parts = {name: getattr(tree, name) for name in tree.fields}
        return type(tree)(
            **{name: _rounded(part, f"{address}.{name}" if address else name, left) for name, part in parts.items()}
        )
    if isinstance(tree, tuple):
        return tuple(_rounded(part, f"{address}[{index}]", left) for index, part in enumerate(tree))
    if not isinstance(tree, Decimal):
        return tree
    # as the bounds have it
    return 0.0 if abs(float(tree)) <= float(left[address]) * 1.001 else float(tree)


def _plain(solved: Solved) -> Solved:
    """The solution, in doubles."""

    def plain(tree: "Any") -> "Any":
        if isinstance(tree, tuple):
            return tuple(map(plain, tree))
        if isinstance(tree, End):
            return End(**{name: plain(getattr(tree, name)) for name in End.__slots__})
        if hasattr(tree, "inertia"):
            return type(tree)(*(plain(getattr(tree, name)) for name in tree.given))
        return float(tree) if isinstance(tree, Decimal) else tree

    return Solved(**{name: plain(getattr(solved, name)) for name in Solved.__slots__})
