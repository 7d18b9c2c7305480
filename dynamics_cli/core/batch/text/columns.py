"""Columns of decimal numbers, from their text to SI, each value rounded once as a single call would round it."""

import msgspec
import numpy as np

from dynamics_cli.core.batch.text.numbers import loose_numbers
from dynamics_cli.core.batch.text.weaving import Tokens
from dynamics_cli.core.inputs.quantity_text import read_number
from dynamics_cli.core.units.conversion import to_si
from dynamics_cli.core.units.unit import Unit
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.exact.factors import DECIMAL_DIGITS, Decimals, Factor, scale

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.quantities import Kind

    Array = NDArray[Any]
    Mask = NDArray[Any]
    Ratio = tuple[int, int]

NAN = float("nan")
_decode = msgspec.json.Decoder(list[float]).decode
_encode = msgspec.json.Encoder().encode
# From the first to below the second, and from the third on, msgspec does not write a double as `repr` does: 0.00001 or
# 1e-7 for 1e-05 or 1e-07, 1e16 for 1e+16.
_ODD_LOW, _ODD_HIGH, _LARGE = 1e-9, 1e-4, 1e16


class Column(Tokens):
    """Tokens that are all numbers, with spaces around them perhaps, and the doubles nearest to them."""

    __slots__ = ("long", "values")

    def __init__(self, tokens: "list[bytes]", values: "Array") -> None:
        super().__init__(tokens)
        self.values = values
        longest = max(map(len, tokens), default=0)
        # Longer tokens may have more digits than a double distinguishes.
        self.long: list[int] = []
        if longest > DECIMAL_DIGITS:
            self.long = [index for index, token in enumerate(tokens) if len(token) > DECIMAL_DIGITS]

    def suspicious(self) -> "Mask | None":
        """Mask of numbers beyond the range of a double, for which the single call writes the message."""
        odd = ~np.isfinite(self.values)
        zeros = np.flatnonzero(self.values == 0.0).tolist()
        lost = {
            token for token in {self.tokens[row] for row in zeros} if token.lower().partition(b"e")[0].strip(b"+-0. \t")
        }
        for row in zeros if lost else ():
            odd[row] = self.tokens[row] in lost
        return odd if odd.any() else None


def column_of(tokens: "list[bytes]", *, strict: bool = False) -> "Column | None":
    """The column, or None when some token is not a number: a JSON number where they are `strict`."""
    values: list[float] | None
    try:
        values = _decode(b"[" + b",".join(tokens) + b"]")
    except (msgspec.MsgspecError, ValueError):
        values = None if strict else loose_numbers(tokens)
    if values is None or len(values) != len(tokens):
        return None
    return Column(tokens, np.fromiter(values, float, len(values)))


class Slot:
    """Where a column's numbers go: the address of the input, its kind and its unit."""

    def __init__(self, address: str, kind: "Kind", unit: Unit) -> None:
        self.address = address
        self.kind = kind
        self.unit = unit
        self.factor = Factor(unit.numerator, unit.denominator, unit.pi, unit.offset)
        self.decimals = Decimals()

    def _exact(self, read: "Callable[[], tuple[int, int]]") -> float:
        try:
            return to_si(*read(), self.unit)
        except UsageError:
            return NAN

    def read(self, column: Column) -> "tuple[Array, Mask | None]":
        """SI values, and a mask of those that a single call would refuse (None: none)."""
        odd = column.suspicious()
        if self.factor.is_one:
            return column.values + 0.0, self._outside(column.values, odd)
        integers, power, missing = self.decimals.find(column.values)
        singly = sorted({*column.long, *(np.flatnonzero(missing).tolist() if missing is not None else ())})
        ten = 10**power
        integers[singly] = 0.0
        factor = self.factor.over_ten_to(power)
        values = scale(integers, factor, lambda value: self._exact(lambda: (int(value), ten)), whole=True)
        for row in singly:
            values[row] = self._exact(lambda: read_number(column.tokens[row].decode().strip()))  # noqa: B023  at once
        lost = np.isnan(values)
        if lost.any():
            odd = lost if odd is None else odd | lost
        return values, self._outside(values, odd)

    def _outside(self, values: "Array", odd: "Mask | None") -> "Mask | None":
        kind = self.kind
        for limit, holds in ((kind.low, np.greater_equal), (kind.above, np.greater),
                             (kind.high, np.less_equal), (kind.below, np.less)):  # fmt: skip
            if limit is not None:
                inside = holds(values, limit)
                if not inside.all():
                    odd = ~inside if odd is None else odd | ~inside
        return odd


def texts(columns: "list[Array]") -> "list[list[bytes]]":
    """The shortest text of each number that reads back as it, column by column: what `repr` writes."""
    cells = _encoded(np.stack(columns, axis=1).ravel())[1:-1].split(b",")
    return [cells[place :: len(columns)] for place in range(len(columns))]


def joined_texts(columns: "list[Array]") -> "list[bytes]":
    """The same of several numbers a row, with commas between them."""
    return _encoded(np.stack(columns, axis=1))[2:-2].split(b"],[")


def _encoded(numbers: "Array") -> bytes:
    """One list of numbers, or a list of lists, as JSON with numbers as `repr` writes them."""
    listed = numbers.tolist()
    size = np.abs(numbers)
    odd = ((size < _ODD_HIGH) & (size >= _ODD_LOW)) | (size >= _LARGE)
    if odd.any():
        written = repr(numbers[odd].tolist())[1:-1].encode().split(b", ")
        for *row, place, text in zip(*[axis.tolist() for axis in np.nonzero(odd)], written, strict=True):
            (listed[row[0]] if row else listed)[place] = msgspec.Raw(text)
    return _encode(listed)
