"""Elementary functions that take a float, an array or a tracked number, and give the same bits for all of them.

numpy and the C library differ in the last bit of many functions, so arrays are mapped through the same scalar function
(70-100 ns a value); only `sqrt`, which is correctly rounded everywhere, uses numpy's own loop.
For a type checker they are functions of `float`.
"""

import math

from dynamics_cli.numerics.number import is_array, is_carrier, is_many

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence
    from typing import Any


def pi_beside(*numbers: "Any") -> float:
    """π to the precision of the accompanying numbers: a double, or with the digits that a double omits."""
    for number in numbers:
        operation = getattr(number, "apply", None)
        if operation is not None:
            return operation("pi", number)  # type: ignore[no-any-return]
    return math.pi


def only_in_doubles(*numbers: "Any") -> None:
    """Refuse a number of many digits: the code that follows iterates in doubles, and would hide its error."""
    if any(is_many(number) for number in numbers):
        raise ArithmeticError("known in doubles only")


def over_array(function: "Callable[..., float]", *arguments: "Any") -> "Any":
    """A function of doubles over arrays, value by value; the result is of the arrays' class.

    An array that keeps what is `known` of it (lanes do) is not mapped by the same function twice.
    """
    import numpy as np

    known: dict[Any, Any] | None = getattr(arguments[0], "known", None) if len(arguments) == 1 else None
    if known is not None and function in known:
        return known[function]
    arrays = np.broadcast_arrays(*arguments)
    columns = [array.ravel().tolist() for array in arrays]
    mapped = np.fromiter(map(function, *columns), dtype=float, count=arrays[0].size)
    result = in_class_of_first(mapped.reshape(arrays[0].shape), *arguments)
    if known is not None:
        known[function] = result
        # what is known must stay true
        result.flags.writeable = arguments[0].flags.writeable = False
    return result


def in_class_of_first(array: "Any", *arguments: "Any") -> "Any":
    """An array in the class of the first array it came from, which numpy's functions drop."""
    for argument in arguments:
        if hasattr(argument, "dtype") and hasattr(argument, "__array_finalize__"):
            return array.view(type(argument))
    return array


def _apply(name: str, function: "Callable[..., float]", *arguments: "Any") -> "Any":
    if all(isinstance(argument, (float, int)) for argument in arguments):
        return function(*arguments)
    for argument in arguments:
        operation = getattr(argument, "apply", None)
        if operation is not None:
            return operation(name, *arguments)
    return over_array(function, *arguments)


def sqrt(x: float) -> float:
    """Square root, correctly rounded."""
    if type(x) is float:
        return math.sqrt(x)
    if is_array(x):
        import numpy as np

        return np.sqrt(x)  # type: ignore[no-any-return]
    return _apply("sqrt", math.sqrt, x)  # type: ignore[no-any-return]


def sin(x: float) -> float:
    """Sine of an angle in radians."""
    return math.sin(x) if type(x) is float else _apply("sin", math.sin, x)


def cos(x: float) -> float:
    """Cosine of an angle in radians."""
    return math.cos(x) if type(x) is float else _apply("cos", math.cos, x)


def tan(x: float) -> float:
    """Tangent of an angle in radians."""
    return math.tan(x) if type(x) is float else _apply("tan", math.tan, x)


def asin(x: float) -> float:
    """Arc sine, in radians."""
    return math.asin(x) if type(x) is float else _apply("asin", math.asin, x)


def acos(x: float) -> float:
    """Arc cosine, in radians."""
    return math.acos(x) if type(x) is float else _apply("acos", math.acos, x)


def atan(x: float) -> float:
    """Arc tangent, in radians."""
    return math.atan(x) if type(x) is float else _apply("atan", math.atan, x)


def exp(x: float) -> float:
    """Exponential."""
    return math.exp(x) if type(x) is float else _apply("exp", math.exp, x)


def log(x: float) -> float:
    """Natural logarithm."""
    return math.log(x) if type(x) is float else _apply("log", math.log, x)


def sinh(x: float) -> float:
    """Hyperbolic sine."""
    return math.sinh(x) if type(x) is float else _apply("sinh", math.sinh, x)


def cosh(x: float) -> float:
    """Hyperbolic cosine."""
    return math.cosh(x) if type(x) is float else _apply("cosh", math.cosh, x)


def tanh(x: float) -> float:
    """Hyperbolic tangent."""
    return math.tanh(x) if type(x) is float else _apply("tanh", math.tanh, x)


def atan2(y: float, x: float) -> float:
    """Angle of the point (x, y), in radians."""
    return _apply("atan2", math.atan2, y, x)  # type: ignore[no-any-return]


def hypot(x: float, y: float) -> float:
    """√(x² + y²) without overflow."""
    if type(x) is float and x == 0.0:
        return absolute(y)
    if type(y) is float and y == 0.0:
        return absolute(x)
    return _apply("hypot", math.hypot, x, y)  # type: ignore[no-any-return]


def binary_exponent(x: float) -> int:
    """The power of two next above a number's magnitude."""
    if not is_array(x):
        return math.frexp(x)[1]
    import numpy as np

    return np.frexp(x)[1]  # type: ignore[no-any-return]


def times_power_of_two(x: float, exponent: int) -> float:
    """x·2^exponent."""
    if not is_array(x) and not is_array(exponent):
        return math.ldexp(x, exponent)
    import numpy as np

    return np.ldexp(x, exponent)  # type: ignore[no-any-return]


def absolute(x: float) -> float:
    """Magnitude of `x`."""
    return abs(x)


def where(condition: bool, yes: float, no: float) -> float:
    """`yes` where `condition` holds, `no` elsewhere; both are computed when the condition is an array."""
    if not is_array(condition):
        return yes if condition else no
    import numpy as np

    return in_class_of_first(np.where(condition, yes, no), condition)  # type: ignore[no-any-return]


def maximum(x: float, y: float) -> float:
    """The larger of the two."""
    if is_carrier(x) or is_carrier(y):
        return _apply("maximum", max, x, y)  # type: ignore[no-any-return]
    return where(x >= y, x, y)


def minimum(x: float, y: float) -> float:
    """The smaller of the two."""
    if is_carrier(x) or is_carrier(y):
        return _apply("minimum", min, x, y)  # type: ignore[no-any-return]
    return where(x <= y, x, y)


# Veltkamp's constant, 2^27 + 1, splits a double into two halves of 26 bits.
_SPLITTER = 134217729.0
# Above this the splitting overflows.
_SPLIT_LIMIT = 6e299


def product_error(a: float, b: float, product: float) -> float:
    """The exact a·b less its rounded value `product` (Dekker 1971), unless a part leaves the range.

    References
    ----------
    T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971) 224.
    """
    big_a = _SPLITTER * a
    high_a = big_a - (big_a - a)
    low_a = a - high_a
    big_b = _SPLITTER * b
    high_b = big_b - (big_b - b)
    low_b = b - high_b
    return low_a * low_b - (((product - high_a * high_b) - low_a * high_b) - high_a * low_b)


def _compensated(a: float, b: float, c: float, product: float) -> float:
    total = product + c
    back = total - product
    lost = (product - (total - back)) + (c - back)
    return total + (lost + product_error(a, b, product))


def _multiply_add(a: float, b: float, c: float) -> float:
    product = a * b
    if max(abs(a), abs(b), abs(product)) > _SPLIT_LIMIT:
        return product + c
    return _compensated(a, b, c, product)


def multiply_add(a: float, b: float, c: float) -> float:
    """a·b + c as if in twice the precision: within little more than one rounding of exact, even where it cancels.

    References
    ----------
    T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971) 224.
    """
    if type(a) is float and type(b) is float and type(c) is float:
        return _multiply_add(a, b, c)
    if any(is_carrier(x) for x in (a, b, c)) or not any(is_array(x) for x in (a, b, c)):
        return _apply("multiply_add", _multiply_add, a, b, c)  # type: ignore[no-any-return]
    import numpy as np

    with np.errstate(all="ignore"):
        product = a * b
        large = np.maximum(np.maximum(abs(a), abs(b)), abs(product)) > _SPLIT_LIMIT
        value = np.where(large, product + c, _compensated(a, b, c, product))
        return in_class_of_first(value, product)  # type: ignore[no-any-return]


def total(numbers: "Iterable[float]") -> float:
    """The sum from first to last, for any number type; Python's `sum` rounds differently since 3.12."""
    added: float = 0.0
    for number in numbers:
        added = added + number
    return added


def summed(parts: "Sequence[float]") -> float:
    """The sum of one or more numbers of any type, without a leading zero."""
    result = parts[0]
    for part in parts[1:]:
        result = result + part
    return result


def horner(coefficients: "Sequence[float]", x: float) -> float:
    """Σ c_k x^k by Horner's rule, coefficients from the constant up."""
    result = coefficients[-1]
    for coefficient in coefficients[-2::-1]:
        result = result * x + coefficient
    return result
