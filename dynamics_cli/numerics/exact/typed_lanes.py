"""Sums of products of numbers as they were typed, for many cases at once: whole numbers over a common denominator."""

from math import lcm

import numpy as np

from dynamics_cli.numerics.exact.factors import Decimals, has_more_digits
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
    tops: list[Any] = []
    bottoms: list[int] = []
    for term in terms:
        top, bottom = 1, 1
        for factor in term:
            whole, unit = _whole(factor, typed)
            top, bottom = top * whole, bottom * unit
        tops.append(top)
        bottoms.append(bottom)
    common = lcm(*bottoms)
    total: Any = sum(top * (common // bottom) for top, bottom in zip(tops, bottoms, strict=True))
    lanes = next(factor for term in terms for factor in term if isinstance(factor, Lanes))
    return (total / common).astype(float).view(type(lanes))


def _whole(factor: "Any", typed: "Typed") -> "tuple[Any, int]":
    """The whole numbers of lanes and their common denominator; of a single number its own."""
    if not isinstance(factor, Lanes):
        return typed(float(factor))
    if "typed" not in factor.known:
        numbers = np.asarray(factor)
        integers, power, missing = Decimals().find(numbers)
        short = integers if missing is None else np.where(missing, 0.0, integers)
        whole, unit = short.astype(np.int64).astype(object), 10**power
        if missing is not None:
            tops, bottom = _ratios(numbers[missing], typed)
            common = lcm(unit, bottom)
            whole, unit = whole * (common // unit), common
            whole[missing] = tops * (common // bottom)
        factor.known["typed"] = whole, unit
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
