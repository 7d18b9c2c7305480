"""Exact conversions in bulk: the same rational factor for all rows of a pair of units, each row rounded once."""

from math import gcd

import numpy as np

from dynamics_cli.core.batch.rows.answered import Answered
from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.text.columns import Column, Unsuited, exact_scale, texts
from dynamics_cli.core.inputs.quantity_text import read_number
from dynamics_cli.core.inputs.values import Constant, Several
from dynamics_cli.core.output.row_layout import Part
from dynamics_cli.core.units.conversion import convert, is_offset, nearest
from dynamics_cli.core.units.lookup import parse_pair
from dynamics_cli.core.units.unit import Unit, conformable
from dynamics_cli.errors import DynamicsError, UsageError
from dynamics_cli.numerics.exact.factors import WHOLE_LIMIT, Decimals, Factor
from dynamics_cli.records import ExactQuantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]
    Mask = NDArray[Any]
    Result = tuple[Part, str, Any]

NAN = float("nan")


class Conversion:
    """From one unit to another: y = x · factor + shift in exact ratios, times a power of π."""

    def __init__(self, source: Unit, target: Unit) -> None:
        if not conformable(source, target):
            raise Unsuited("the units do not fit")
        self.source = source
        self.target = target
        up, over = source.offset
        down, under = target.offset
        numerator, denominator = source.numerator * target.denominator, source.denominator * target.numerator
        shift = ((up * under - down * over) * target.denominator, over * under * target.numerator)
        self.factor = Factor(numerator, denominator, source.pi - target.pi, shift)
        # Temperatures are refused below absolute zero, which depends on their scale.
        scale = Factor(source.numerator, source.denominator, 0, source.offset)
        self.kelvin = scale if is_offset(source) or is_offset(target) else None
        self.decimals = Decimals()

    def _exact(self, numerator: int, denominator: int) -> float:
        try:
            return nearest(*convert(numerator, denominator, self.source, self.target))
        except UsageError:
            return NAN

    def _exact_kelvin(self, numerator: int, denominator: int) -> float:
        up, over = self.source.offset
        n = numerator * self.source.numerator * over + up * denominator * self.source.denominator
        return float((n > 0) - (n < 0))

    def run(self, column: Column, *, flag: bool) -> "tuple[Array, Mask | None, list[bool] | None]":
        """Converted numbers, which of them a single call would refuse (None: none), and which are exact."""
        odd = column.suspicious()
        values, integers, power, singly = exact_scale(column, self.factor, self.decimals, self._exact)
        lost = np.isnan(values)
        if lost.any():
            odd = lost if odd is None else odd | lost
        if self.kelvin is not None:
            below = exact_scale(column, self.kelvin, self.decimals, self._exact_kelvin)[0] < 0.0
            if below.any():
                odd = below if odd is None else odd | below
        if odd is not None:
            values[odd] = 0.0
        return values, odd, self._exactness(column, values, integers, power, singly) if flag else None

    def _exactness(
        self, column: Column, values: "Array", integers: "Array", power: int, singly: "list[int]"
    ) -> "list[bool]":
        """Whether each number is the exact result: whether the remaining denominator divides N."""
        factor = self.factor
        ten = 10**power
        if factor.shift[0]:
            exact = [False] * len(values)
            singly = list(range(len(values)))
        elif factor.pi:
            return (values == 0.0).tolist()  # type: ignore[no-any-return]
        else:
            denominator = factor.denominator * ten
            odd = denominator // gcd(denominator, factor.numerator)
            odd //= odd & -odd
            divides = np.fmod(integers, float(odd)) == 0.0 if odd < WHOLE_LIMIT else integers == 0.0
            exact = divides.tolist()
            # A quotient of more than 53 bits is not a double, even if exact.
            if float(np.abs(integers).max(initial=0.0)) * abs(factor.numerator) >= WHOLE_LIMIT:
                singly = sorted({*singly, *np.flatnonzero(divides).tolist()})
        for row in singly:
            exact[row] = self._is_exact(column.tokens[row], float(values[row]))
        return exact

    def _is_exact(self, token: bytes, value: float) -> bool:
        try:
            n, d, pi = convert(*read_number(token.decode()), self.source, self.target)
        except UsageError:
            return False
        return pi == 0 and value.as_integer_ratio() == (n, d)


class ExactPlan:
    """Rows of an exact quantity in one unit, converted to one or several units."""

    def __init__(self, case: Case, raw: "dict[str, Any]", addresses: "Sequence[str]") -> None:
        self.case = case
        self.proved: set[tuple[Any, ...]] = set()
        self.failures = 0
        name, targets = case.measure
        self.addresses = list(addresses)
        parameters = case.raw(raw)
        if set(parameters) != {name, targets} or self.addresses != [name]:
            raise Unsuited("more than a value and its unit is given", {name})
        bound = case.bind(raw)
        value, target_units = bound.fields[name], bound.fields[targets]
        assert isinstance(value, Constant)
        assert isinstance(value.value, ExactQuantity)
        assert isinstance(target_units, Several)
        self.targets = [str(item.assemble()) for item in target_units.items]
        if not value.value.unit or not self.targets or any(";" in target for target in self.targets):
            raise Unsuited("only plain units can be converted as a column", {name})
        self.conversions = [Conversion(*parse_pair(value.value.unit, target)) for target in self.targets]

    def run(self, columns: "list[Column]") -> "list[Answered]":
        """The converted numbers of all rows that a single call would not refuse."""
        flags = [part for part in self.case.layout.parts if part.how == "flag"]
        runs = [conversion.run(columns[0], flag=bool(flags)) for conversion in self.conversions]
        good: Mask | None = None
        for _, odd, _ in runs:
            if odd is not None:
                good = ~odd if good is None else good & ~odd
        rows = None if good is None else np.flatnonzero(good).tolist()
        results: list[Result] = []
        for part in self.case.layout.parts:
            if part.how == "flag":
                exact = [all(row) for row in zip(*(run[2] or () for run in runs), strict=True)]
                kept = exact if rows is None else [exact[row] for row in rows]
                results.append((part, "each", [b"true" if flag else b"false" for flag in kept]))
            else:
                results.append(self._measured(part, [run[0] if good is None else run[0][good] for run in runs]))
        places = np.arange(len(columns[0].tokens)) if good is None else np.flatnonzero(good)
        return [Answered(places, results, ())] if len(places) else []

    def _measured(self, part: Part, values: "list[Array]") -> "Result":
        if part.unit:
            index = part.steps[-1] if isinstance(part.steps[-1], int) else 0
            return part, "measured", ([texts(values[index])], [self.targets[index]])
        if part.several != (len(self.targets) > 1):
            return part, "all", None
        return part, "measured", (list(map(texts, values)), self.targets)


class Pairs:
    """Lines of a number, its unit and the target unit: grouped by the text after the number."""

    def __init__(self, case: Case) -> None:
        self.case = case
        self.plans: dict[bytes, ExactPlan | None] = {}

    def plan(self, rest: bytes, token: bytes) -> "ExactPlan | None":
        """The plan for lines that end like this one, or None when they are answered one by one."""
        if rest not in self.plans:
            if len(self.plans) >= 2048:
                self.plans.clear()
            try:
                if b"'" in rest or b'"' in rest:
                    raise Unsuited("quotes may join words")
                raw = self.case.words((token + b" " + rest).decode().split())
                self.plans[rest] = ExactPlan(self.case, raw, [self.case.measure[0]])
            except (Unsuited, DynamicsError, UnicodeDecodeError):
                self.plans[rest] = None
        return self.plans[rest]
