"""Rayleigh's quotients of many matrices side by side, each rounded once: pairs of doubles, else whole numbers.

A pair of doubles has an error of about 2⁻¹⁰⁴ of the sizes added (Dekker, A floating-point technique for extending
the available precision, Numer. Math. 18 (1971) 224). Where both ends of this interval round to the same double, so does
the quotient; the others are divided in integers.
"""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Array = np.ndarray[Any, np.dtype[Any]]
    # three elements, or rows of them: arrays of one number for each matrix
    Triple = tuple[Any, Any, Any]
    Rows = tuple[Triple, Triple, Triple]

# Error bound of a pair relative to the sizes added, at least 2⁶ times the sum of the roundings.
_OPEN = 2.0**-97
# Sizes outside this range may lose parts of a product to underflow or overflow.
_SMALLEST, _LARGEST = 2.0**-700, 2.0**900
_SPLIT = 2.0**27 + 1.0


def quotients(matrix: "Rows", vectors: "Rows", exact: "Callable[[Any, Any], Triple]") -> "Triple":
    """Rayleigh's quotients vᵀ A v/vᵀ v of symmetric 3 × 3 matrices whose elements are arrays, each rounded once.

    `exact` gives those of one matrix of doubles.
    """
    leaves = [x for row in (*matrix, *vectors) for x in row]
    kind = next(type(x) for x in leaves if isinstance(x, np.ndarray))
    numbers = np.array(np.broadcast_arrays(*leaves))
    a, v = numbers[:9].reshape(3, 3, -1), numbers[9:].reshape(3, 3, -1)
    with np.errstate(all="ignore"):
        values, certain = _in_pairs(a, v)
    for lane in np.flatnonzero(~certain.all(axis=0)).tolist():
        values[:, lane] = exact(a[:, :, lane].tolist(), v[:, :, lane].tolist())
    shape = numbers.shape[1:]
    first, second, third = (row.reshape(shape).view(kind) for row in values)
    return first, second, third


def _in_pairs(a: "Array", v: "Array") -> "tuple[Array, Array]":
    """Quotients by vectors and lanes, and which of them are correctly rounded."""
    # A v by vectors, rows and lanes
    half = _sum_of_three([_product(a[:, j], v[:, None, j]) for j in range(3)])
    above = _sum_of_three([_product(half[0][:, i], v[:, i], half[1][:, i]) for i in range(3)])
    below = _sum_of_three([_product(v[:, i], v[:, i]) for i in range(3)])
    size = abs(v)
    sizes = sum((size[:, None, j] * abs(a[:, j]) for j in range(1, 3)), size[:, None, 0] * abs(a[:, 0]))
    added = size[:, 0] * sizes[:, 0] + size[:, 1] * sizes[:, 1] + size[:, 2] * sizes[:, 2]
    quotient = above[0] / below[0]
    product, lost = _product(quotient, below[0])
    rest = (((above[0] - product) - lost) + above[1] - quotient * below[1]) / below[0]
    uncertainty = _OPEN * added / below[0]
    low, high = quotient + (rest - uncertainty), quotient + (rest + uncertainty)
    return low, (low == high) & (added > _SMALLEST) & (added < _LARGEST)


def _product(x: "Array", y: "Array", low: "Array | None" = None) -> "tuple[Array, Array]":
    """A product and its rounding error; `low` is the second part of a pair `x`."""
    product = x * y
    x_high, y_high = _SPLIT * x, _SPLIT * y
    x_high, y_high = x_high - (x_high - x), y_high - (y_high - y)
    x_low, y_low = x - x_high, y - y_high
    lost = ((x_high * y_high - product) + x_high * y_low + x_low * y_high) + x_low * y_low
    return product, lost if low is None else lost + low * y


def _sum_of_three(pairs: "list[tuple[Array, Array]]") -> "tuple[Array, Array]":
    """The sum of three pairs as a pair."""
    (a, a_low), (b, b_low), (c, c_low) = pairs
    total, lost = _sum(a, b)
    total, more = _sum(total, c)
    return _sum(total, (a_low + b_low) + c_low + (lost + more))


def _sum(x: "Array", y: "Array") -> "tuple[Array, Array]":
    """A sum and its rounding error."""
    total = x + y
    other = total - x
    return total, (x - (total - other)) + (y - other)
