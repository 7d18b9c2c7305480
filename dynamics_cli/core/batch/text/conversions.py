"""Exact conversions in bulk: the same ratio for all rows of a pair of units, each row rounded once by `int / int`."""

import re
from math import gcd

from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.text.weaving import Answered, Tokens, Unsuited
from dynamics_cli.core.inputs.quantity_text import read_number
from dynamics_cli.core.inputs.values import Constant, Several
from dynamics_cli.core.units.conversion import PI, PI_DIGITS, convert, is_offset, nearest
from dynamics_cli.core.units.lookup import parse_pair
from dynamics_cli.core.units.unit import Unit, conformable
from dynamics_cli.errors import UsageError
from dynamics_cli.records import ExactQuantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.core.batch.text.weaving import Result

    # Of a number N·10^-k: what N is multiplied by, and by k what is added and what divides.
    Way = tuple[int, list[int], list[int]]

NAN = float("nan")
# Numbers with more decimals, or longer than this, are converted one by one.
DECIMALS, LONGEST = 41, 100
_is_short = re.compile(rb" *[+-]?(?:[0-9]{1,40}\.?[0-9]{0,40}|\.[0-9]{1,40}) *").fullmatch
# From so many numbers on the import of a faster writer pays.
MANY = 25_000


class Conversion:
    """From one unit to another; where π is in the ratio by a lower and an upper bound of it."""

    def __init__(self, source: Unit, target: Unit) -> None:
        if not conformable(source, target):
            raise Unsuited("the units do not fit")
        self.source = source
        self.target = target
        pi = source.pi - target.pi
        up, over = source.offset
        down, under = target.offset
        top = source.numerator * over * under * target.denominator
        shift = source.denominator * (up * under - down * over) * target.denominator
        bottom = source.denominator * over * under * target.numerator
        self.ways: list[Way] = []
        for bound in (PI, PI + 1) if pi else (1,):
            larger, smaller = bound ** abs(pi), 10 ** (PI_DIGITS * abs(pi))
            above, below = (larger, smaller) if pi > 0 else (smaller, larger)
            common = gcd(top * above, shift, bottom * below)
            added, divisor = shift // common, bottom * below // common
            tens = [10**power for power in range(DECIMALS)]
            self.ways.append((top * above // common, [added * ten for ten in tens], [divisor * ten for ten in tens]))
        # Temperatures are refused below absolute zero: N times the first and the second together are below zero.
        self.kelvin: Way | None = None
        if is_offset(source) or is_offset(target):
            self.kelvin = source.numerator * over, [up * source.denominator * ten for ten in tens], []

    def run(self, tokens: "list[bytes]", *, flag: bool) -> "tuple[list[float], set[int], list[bool]]":
        """Converted numbers, which of them a single call would refuse, and which are exact."""
        try:
            values, exact = self._together(tokens, flag=flag)
        except (OverflowError, ValueError, IndexError):
            short = {row: token for row, token in enumerate(tokens) if _is_short(token)}
            if 0 < len(short) < len(tokens):
                made, _, marks = self.run(list(short.values()), flag=True)
                pairs = dict(zip(short, zip(made, marks, strict=True), strict=True))
            else:
                pairs = {}
            every = [pairs[row] if row in pairs else self._single(token) for row, token in enumerate(tokens)]
            values, exact = [value for value, _ in every], [exact for _, exact in every]
        total = sum(values)
        return values, {row for row, value in enumerate(values) if value != value} if total != total else set(), exact

    def _together(self, tokens: "list[bytes]", *, flag: bool) -> "tuple[list[float], list[bool]]":
        """Those of short decimals without exponents; other numbers are an error."""
        if b" " in b"".join(tokens):
            tokens = [token.strip() for token in tokens]
        if len(max(tokens, key=len)) > LONGEST or b" " in b"".join(tokens):
            raise ValueError
        parts = [token.partition(b".") for token in tokens]
        places = [len(after) for _, _, after in parts]
        wholes = list(map(int, [before + after for before, _, after in parts]))
        top, shifts, bottoms = self.ways[0]
        tops = (
            [n * top + shifts[k] for n, k in zip(wholes, places, strict=True)]
            if shifts[0]
            else [n * top for n in wholes]
        )
        values = [n / bottoms[k] for n, k in zip(tops, places, strict=True)]
        for other, _, divisors in self.ways[1:]:
            if values != [n * other / divisors[k] for n, k in zip(wholes, places, strict=True)]:
                raise ValueError
        if 0.0 in values:
            values = [NAN if n and not value else value for n, value in zip(tops, values, strict=True)]
        if self.kelvin is not None:
            factor, zeros, _ = self.kelvin
            for row, (n, k) in enumerate(zip(wholes, places, strict=True)):
                if n * factor + zeros[k] < 0:
                    values[row] = NAN
        if not flag:
            return values, []
        rational = len(self.ways) == 1
        every = zip(tops, places, values, strict=True)
        exact = [value == value and (rational or not n) and _is(value, n, bottoms[k]) for n, k, value in every]
        return values, exact

    def _single(self, token: bytes) -> "tuple[float, bool]":
        text = token.decode().strip()
        try:
            near = float(text)
            n, d = read_number(text)
            if near - near != 0.0 or (n and not near):
                return NAN, False
            if self.kelvin is not None and n * self.kelvin[0] + d * self.kelvin[1][0] < 0:
                return NAN, False
            top, bottom, pi = convert(n, d, self.source, self.target)
            value = nearest(top, bottom, pi)
        except (UsageError, ValueError):
            return NAN, False
        return value, pi == 0 and _is(value, top, bottom)


def _texts(numbers: "list[float]", *, many: bool) -> "list[bytes]":
    """The shortest text of each number that reads back as it: what `repr` writes."""
    if many:
        from msgspec.json import encode

        encoded = encode(numbers)
        # it writes exponents in another way, or none
        if b"e" not in encoded and b"0.0000" not in encoded:
            return encoded[1:-1].split(b",")
    return repr(numbers)[1:-1].encode().split(b", ")


def _is(value: float, top: int, bottom: int) -> bool:
    """Whether a double is this ratio."""
    p, q = value.as_integer_ratio()
    return p * bottom == top * q


class ExactPlan:
    """Rows of an exact quantity in one unit, converted to one or several units."""

    def __init__(self, case: Case, raw: "dict[str, Any]", addresses: "Sequence[str]", *, flags: bool = True) -> None:
        self.case = case
        self.proved: set[tuple[Any, ...]] = set()
        self.failures = 0
        # How many rows it has answered.
        self.done = 0
        self.flags = flags and any(part.how == "flag" for part in case.layout.parts)
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

    @staticmethod
    def written(results: "list[Result]", form: str) -> "list[Result]":
        """The results, which are texts."""
        return results

    @staticmethod
    def texts_of(runs: "list[list[Any]]") -> "list[list[bytes]]":
        """Their columns, each alone."""
        return [run[0] for run in runs]

    def run(self, columns: "Sequence[Tokens]") -> "list[Answered]":
        """The converted numbers of all rows that a single call would not refuse."""
        tokens = columns[0].tokens
        runs = [conversion.run(tokens, flag=self.flags) for conversion in self.conversions]
        refused = set[int]().union(*(run[1] for run in runs))
        rows = [row for row in range(len(tokens)) if row not in refused] if refused else list(range(len(tokens)))
        if not rows:
            return []
        values, exact = [run[0] for run in runs], [run[2] for run in runs]
        if refused:
            values = [[column[row] for row in rows] for column in values]
            exact = [[column[row] for row in rows] for column in exact if column]
        self.done += len(rows)
        texts = [_texts(column, many=self.done > MANY) for column in values]
        results: list[Result] = []
        for part in self.case.layout.parts:
            if part.how == "flag" and not self.flags:
                results.append((part, "all", None))
            elif part.how == "flag":
                results.append((part, "each", [b"true" if all(row) else b"false" for row in zip(*exact, strict=True)]))
            elif part.unit:
                index = part.steps[-1] if isinstance(part.steps[-1], int) else 0
                results.append((part, "measured", ([texts[index]], [self.targets[index]])))
            else:
                several = part.several == (len(self.targets) > 1)
                results.append((part, "measured", (texts, self.targets)) if several else (part, "all", None))
        return [Answered(rows, results, ())]
