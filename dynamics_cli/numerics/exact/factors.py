"""Arrays of doubles times an exact factor, each result rounded once: the same bits as exact integers give.

The factor is held as the sum of two doubles (about 106 bits) and the product is formed with its rounding error
(Dekker 1971). Rounding it is certain unless the exact product lies within 2^-100 of itself from the middle of two
doubles, or near the ends of the range; those few are marked doubtful and left to integers (Ziv 1991).
"""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]
    Mask = NDArray[Any]

# π to 100 decimals: its error, 2^-332, is negligible against the 2^-107 of a pair of doubles.
_PI = 31415926535897932384626433832795028841971693993751058209749445923078164062862089986280348253421170679
_PI_SCALE = 10**100
_SPLITTER = 134217729.0
# The product's error term must be a normal double, and splitting a factor must not overflow.
_SMALLEST, _LARGEST = 1e-270, 1e290
_FACTOR_RANGE = (1e-140, 1e140)
_DOUBT = 2.0**-100
WHOLE_LIMIT = 2**53
# Powers of ten that are doubles, and the digits of a decimal that a double always distinguishes.
TENS = tuple(10.0**k for k in range(23))
DECIMAL_DIGITS = 15
# Ends of the decades in which a decimal of 15 digits is a whole number over one of those powers.
_DECADES = tuple(float(f"1e{k}") for k in range(-8, 16))


class Factor:
    """y = x · numerator/denominator · π^pi + shift, exactly; `shift` is a ratio.

    References
    ----------
    T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971) 224; A.
    Ziv, Fast evaluation of elementary mathematical functions with correctly rounded last bit, ACM Trans. Math.
    Softw. 17 (1991) 410.
    """

    __slots__ = (
        "_by_tens", "denominator", "direct", "gives_ties", "high", "inverse", "low", "numerator", "pi", "shift",
        "shift_high", "shift_low",
    )  # fmt: skip

    def __init__(self, numerator: int, denominator: int, pi: int = 0, shift: "tuple[int, int]" = (0, 1)) -> None:
        self.numerator = numerator
        self.denominator = denominator
        self.pi = pi
        self.shift = shift
        self.high, self.low = _pair(*_with_pi(numerator, denominator, pi))
        self.shift_high, self.shift_low = _pair(*shift)
        # A factor that is one double, or one over a double, needs a single correctly rounded operation.
        self.direct = ""
        self.inverse = 0.0
        if not pi and not shift[0]:
            if _is_double(numerator, denominator):
                self.direct = "*"
            elif _is_double(denominator, numerator):
                self.direct = "/"
                self.inverse = denominator / numerator
        # x·n/d and a middle m, if not equal, differ by 1 in x·n − m·d, a number of fewer than 54 + 40 + 1 bits: by more
        # than the doubt. So what is doubtful lies exactly in the middle.
        self.gives_ties = not pi and not shift[0] and max(abs(numerator), denominator) < 2**40
        self._by_tens: dict[int, Factor] = {}

    def over_ten_to(self, power: int) -> "Factor":
        """This factor for numbers that still have to be divided by 10^power."""
        if power == 0:
            return self
        if power not in self._by_tens:
            self._by_tens[power] = Factor(self.numerator, self.denominator * 10**power, self.pi, self.shift)
        return self._by_tens[power]

    @property
    def is_one(self) -> bool:
        """Whether scaling does nothing."""
        return self.numerator == self.denominator and not self.pi and not self.shift[0]


def scale(values: "Array", factor: Factor, scalar: "Callable[[float], float]", *, whole: bool = False) -> "Array":
    """Scale finite numbers, the doubtful ones by `scalar` (which gives NaN where no double holds the result).

    `whole` says that all values are integers below 2^53.
    """
    with np.errstate(all="ignore"):
        result, doubtful = _scaled(values, factor, whole)
    if doubtful is not None and doubtful.any():
        where = np.flatnonzero(doubtful)
        result[where] = [scalar(value) for value in values[where].tolist()]
    # No result is a negative zero: exact arithmetic knows one zero.
    return result + 0.0


def _scaled(x: "Array", factor: Factor, whole: bool) -> "tuple[Array, Mask | None]":
    if factor.is_one:
        return x.copy(), None
    if whole and not factor.pi and not factor.shift[0] and factor.denominator < WHOLE_LIMIT:
        biggest = float(np.abs(x).max(initial=0.0))
        if factor.numerator < WHOLE_LIMIT and biggest * factor.numerator < WHOLE_LIMIT:
            return (x * float(factor.numerator)) / float(factor.denominator), None
    if factor.direct:
        y = x * factor.high if factor.direct == "*" else x / factor.inverse
        size = np.abs(y)
        return y, ~((size < np.inf) & (size > 1e-300)) & (x != 0.0)
    if not _FACTOR_RANGE[0] < abs(factor.high) < _FACTOR_RANGE[1]:
        return np.zeros_like(x), np.ones(x.shape, dtype=bool)
    return _in_pairs(x, factor)


def _in_pairs(x: "Array", factor: Factor) -> "tuple[Array, Mask]":
    product = x * factor.high
    tail = _product_error(x, factor.high, product) + x * factor.low
    size = np.abs(product)
    certain = (size > _SMALLEST) & (size < _LARGEST) & (np.abs(x) < _LARGEST)
    if factor.shift[0]:
        total = product + factor.shift_high
        part = total - product
        tail = ((product - (total - part)) + (factor.shift_high - part)) + (tail + factor.shift_low)
        product = total
        size = size + abs(factor.shift_high)
    else:
        certain |= x == 0.0
    doubt = size * _DOUBT
    below, above = product + (tail - doubt), product + (tail + doubt)
    differ = below != above
    if factor.gives_ties:
        # Neighbours, and the exact product half way between them: the even one.
        odd = (below.view(np.int64) & 1).astype(bool)
        return np.where(differ & odd, above, below), ~certain
    return below, ~certain | differ


def _product_error(x: "Array", factor: float, product: "Array") -> "Array":
    big = x * _SPLITTER
    high = big - (big - x)
    low = x - high
    big_factor = factor * _SPLITTER
    factor_high = big_factor - (big_factor - factor)
    factor_low = factor - factor_high
    rest = ((product - high * factor_high) - low * factor_high) - high * factor_low
    return low * factor_low - rest


def _with_pi(numerator: int, denominator: int, pi: int) -> "tuple[int, int]":
    if pi >= 0:
        return numerator * _PI**pi, denominator * _PI_SCALE**pi
    return numerator * _PI_SCALE**-pi, denominator * _PI**-pi


def _pair(numerator: int, denominator: int) -> "tuple[float, float]":
    """The double nearest to a ratio and the double nearest to the remainder; (0, 0) out of range, which is refused."""
    try:
        high = numerator / denominator
    except OverflowError:
        return 0.0, 0.0
    up, down = high.as_integer_ratio()
    return high, (numerator * down - up * denominator) / (denominator * down)


def _is_double(numerator: int, denominator: int) -> bool:
    try:
        value = numerator / denominator
    except OverflowError:
        return False
    up, down = value.as_integer_ratio()
    return up * denominator == numerator * down and _FACTOR_RANGE[0] < abs(value) < _FACTOR_RANGE[1]


class Decimals:
    """Finds the integers N and the power k of decimals N·10^-k that were read as doubles.

    Two decimals of at most 15 digits are never the same double, so an N of at most 15 digits with N/10^k equal to the
    double is the decimal that was written, if what was written had no more digits than that.
    """

    def __init__(self) -> None:
        self.power = 0

    def find(self, values: "Array") -> "tuple[Array, int, Mask | None]":
        """The integers, their common power, and where they were not found (None: everywhere found)."""
        best: tuple[Array, int, Mask] | None = None
        missing = 0
        with np.errstate(all="ignore"):
            for power in (self.power, *range(len(TENS))):
                ten = TENS[power]
                integers = np.rint(values * ten)
                mask = (integers / ten == values) & (np.abs(integers) < TENS[DECIMAL_DIGITS])
                lost = mask.size - int(np.count_nonzero(mask))
                if best is None or lost < missing:
                    best, missing = (integers, power, mask), lost
                if lost == 0:
                    break
        assert best is not None
        integers, self.power, mask = best
        return integers, self.power, ~mask if missing else None


def has_more_digits(values: "Array") -> "Mask":
    """Where doubles are certainly no decimals of at most 15 digits; those below 1e-8 and from 1e15 on are left out."""
    size = np.abs(values)
    decade = np.searchsorted(_DECADES, size, side="right")
    inside = (decade > 0) & (decade < len(_DECADES))
    ten = np.array(TENS)[len(_DECADES) - 1 - np.where(inside, decade, 1)]
    return np.asarray(inside & (np.rint(size * ten) / ten != size))
