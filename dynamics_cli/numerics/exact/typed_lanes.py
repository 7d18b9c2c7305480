"""Sums of products of numbers as they were typed, for many cases at once: whole numbers over a common denominator."""

from math import lcm, prod

import numpy as np

from dynamics_cli.numerics.exact.factors import WHOLE_LIMIT, Decimals, has_more_digits
from dynamics_cli.numerics.lanes import Lanes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]
    Typed = Callable[[float], tuple[int, int]]

# Bits of a double.
MANTISSA = 53


def summed(terms: "Sequence[Sequence[Any]]", typed: "Typed") -> "Any":
    """The sums of lanes, each rounded once; `typed` gives the ratio that a single number stands for."""
    parted = [[_whole(factor, typed) for factor in term] for term in terms]
    bottoms = [prod(unit for _, unit, _ in term) for term in parted]
    common = lcm(*bottoms)
    scales = [common // bottom for bottom in bottoms]
    reach = sum(scale * prod(largest for _, _, largest in term) for scale, term in zip(scales, parted, strict=True))
    # below 2^53 doubles hold every product and sum
    exact = common < WHOLE_LIMIT and reach < WHOLE_LIMIT
    total: Any = 0
    for scale, term in zip(scales, parted, strict=True):
        top: Any = float(scale) if exact else scale
        for whole, _, _ in term:
            top = top * (whole if exact else _as_integers(whole))
        total = total + top
    lanes = next(factor for term in terms for factor in term if isinstance(factor, Lanes))
    # the zero of whole numbers has no sign
    return (total / common + 0.0).astype(float).view(type(lanes))


def _as_integers(whole: "Any") -> "Any":
    """Whole numbers of any length instead of doubles."""
    return whole if isinstance(whole, int) or whole.dtype == object else whole.astype(np.int64).astype(object)


def _whole(factor: "Any", typed: "Typed") -> "tuple[Any, int, Any]":
    """The whole numbers of lanes, their common denominator and largest size; of a single number its own."""
    if not isinstance(factor, Lanes):
        top, bottom = typed(float(factor))
        return top, bottom, max(abs(top), 1)
    if "typed" not in factor.known:
        numbers = np.asarray(factor)
        whole, power, missing = Decimals().find(numbers)
        unit, largest = 10**power, max(int(np.abs(whole).max()), 1)
        if missing is not None:
            tops, bottom = _ratios(numbers[missing], typed)
            unit = lcm(10**power, bottom)
            whole = _as_integers(np.where(missing, 0.0, whole)) * (unit // 10**power)
            whole[missing] = tops * (unit // bottom)
            largest = WHOLE_LIMIT
        factor.known["typed"] = whole, unit, largest
    return factor.known["typed"]  # type: ignore[no-any-return]


def _ratios(numbers: "Array", typed: "Typed") -> "tuple[Array, int]":
    """Whole numbers over a common denominator for any doubles: those of many digits are mantissas over powers of 2."""
    long = has_more_digits(numbers)
    mantissas, exponents = np.frexp(np.where(long, numbers, 1.0))
    least = min(int(exponents.min()) - MANTISSA, 0)
    tops = (mantissas * 2.0**MANTISSA).astype(np.int64).astype(object) << (exponents - MANTISSA - least).astype(object)
    bottom = 2**-least
    if not long.all():
        others = [typed(number) for number in numbers[~long].tolist()]
        common = lcm(bottom, *{under for _, under in others})
        tops, bottom = tops * (common // bottom), common
        tops[~long] = [top * (common // under) for top, under in others]
    return tops, bottom
