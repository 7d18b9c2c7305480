"""Sums of products of numbers as they were typed: exact, and rounded once.

Whether three vectors are coplanar, two parallel, or forces in equilibrium is decided by a sum of products that
cancels. 0.1·0.9 − 0.3·0.3 is zero for the decimals, but 1.4e-17 in doubles. A double whose
shortest text has at most 15 digits is taken as that decimal, since every such decimal reads back; any other double is
taken as it is.
"""

from math import isfinite

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.elementary import hypot
from dynamics_cli.numerics.exact.rational import nearest, product, total
from dynamics_cli.numerics.number import is_array, is_many, is_tracked, plain
from dynamics_cli.numerics.tracked import TINY, UNIT_ROUNDOFF, Tracked
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.numerics.exact.rational import Pair

    Vector = tuple[float, float, float]

# Every decimal of at most this many digits is recovered from its double.
DECIMAL_DIGITS = 15
# Margin for second-order terms of a bound.
SLACK = 1.0 + 2.0**-20


def typed(x: float) -> "Pair":
    """The exact decimal that a double stands for.

    >>> typed(0.1)
    (1, 10)
    """
    if not isfinite(x):
        raise InadmissibleError("a number leaves the range of a double", code="range", hint="check the inputs")
    mantissa, _, power = repr(float(x)).partition("e")
    integer, _, fraction = mantissa.partition(".")
    if len((integer + fraction).strip("-0")) > DECIMAL_DIGITS:
        return float(x).as_integer_ratio()
    digits = int(integer + fraction)
    exponent = int(power or 0) - len(fraction)
    return product((digits * 10**exponent, 1) if exponent >= 0 else (digits, 10**-exponent))


def sum_of_products(*terms: "Sequence[float]") -> float:
    """The sum of products of single numbers, each term its factors; a leading −1.0 subtracts.

    Doubles and tracked numbers give the exact sum of the numbers as typed, rounded once; other numbers the plain sum.

    References
    ----------
    Derived: exact rational arithmetic of the decimals as typed, rounded once.
    """
    factors = [factor for term in terms for factor in term]
    if any(is_many(factor) for factor in factors):
        return _plain_sum([[as_typed(factor) for factor in term] for term in terms])
    if any(is_array(factor) for factor in factors):
        if drawing() or not any(hasattr(factor, "known") for factor in factors):
            return _plain_sum(terms)
        from dynamics_cli.numerics.exact.typed_lanes import summed

        return summed(terms, typed)  # type: ignore[no-any-return]
    if drawing():
        return _plain_sum(terms)
    value = nearest(total([product(*[typed(plain(factor)) for factor in term]) for term in terms]))
    width = max((len(factor.slopes) for factor in factors if is_tracked(factor)), default=-1)  # type: ignore[attr-defined]
    if width < 0:
        return value
    return _tracked(value, terms, width)  # type: ignore[return-value]


def _plain_sum(terms: "Sequence[Sequence[float]]") -> float:
    result = 0.0
    for term in terms:
        term_product = term[0]
        for factor in term[1:]:
            term_product = term_product * factor
        result = result + term_product
    return result


def as_typed(factor: float) -> float:
    """A number of many digits: one that is a double is an input, and stands for what was typed. Others as they are."""
    if not is_many(factor) or factor.exact != type(factor.exact)(factor.value):  # type: ignore[attr-defined]
        return factor
    top, bottom = typed(factor.value)  # type: ignore[attr-defined]
    number = type(factor.exact)  # type: ignore[attr-defined]
    return type(factor)(number(top) / number(bottom))


def _tracked(value: float, terms: "Sequence[Sequence[float]]", width: int) -> Tracked:
    slopes = [0.0] * width
    spread = 0.0
    for term in terms:
        for place, factor in enumerate(term):
            if not is_tracked(factor):
                continue
            rest = 1.0
            for other, number in enumerate(term):
                if other != place:
                    rest *= plain(number)
            for index, slope in enumerate(factor.slopes):  # type: ignore[attr-defined]
                slopes[index] += rest * slope
            error = factor.error  # type: ignore[attr-defined]
            if error:
                # what is not typed is a double as well as its shortest text
                spread += abs(rest) * (error + 2.0 * UNIT_ROUNDOFF * abs(plain(factor))) * len(term)
    error = (UNIT_ROUNDOFF * abs(value) + spread) * SLACK
    return Tracked(value, error + (TINY if 0.0 < abs(value) < 1e-290 else 0.0), tuple(slopes))


def dot(a: "Vector", b: "Vector") -> float:
    """Scalar product."""
    return sum_of_products((a[0], b[0]), (a[1], b[1]), (a[2], b[2]))


def cross(a: "Vector", b: "Vector") -> "Vector":
    """Vector product, every component rounded once."""
    return (
        sum_of_products((a[1], b[2]), (-1.0, a[2], b[1])),
        sum_of_products((a[2], b[0]), (-1.0, a[0], b[2])),
        sum_of_products((a[0], b[1]), (-1.0, a[1], b[0])),
    )


def triple(a: "Vector", b: "Vector", c: "Vector") -> float:
    """Triple scalar product a·(b×c)."""
    return sum_of_products(
        (a[0], b[1], c[2]), (a[1], b[2], c[0]), (a[2], b[0], c[1]),
        (-1.0, a[0], b[2], c[1]), (-1.0, a[1], b[0], c[2]), (-1.0, a[2], b[1], c[0]),
    )  # fmt: skip


def difference(a: "Vector", b: "Vector") -> "Vector":
    """From `b` to `a`."""
    return (
        sum_of_products((a[0],), (-1.0, b[0])),
        sum_of_products((a[1],), (-1.0, b[1])),
        sum_of_products((a[2],), (-1.0, b[2])),
    )


def norm(a: "Vector") -> float:
    """Length, without overflow."""
    return hypot(hypot(a[0], a[1]), a[2])


def unit(a: "Vector") -> "Vector":
    """The unit vector; the caller has checked that it is not zero."""
    length = norm(a)
    return a[0] / length, a[1] / length, a[2] / length


def scaled(a: "Vector") -> "Vector":
    """The vector times a power of two where products of its components would leave the range of doubles."""
    largest = max(abs(plain(part)) for part in a)
    factor = 1.0 if largest == 0.0 or 1e-60 < largest < 1e60 else 2.0 ** -_exponent(largest)
    return a if factor == 1.0 else (a[0] * factor, a[1] * factor, a[2] * factor)


def _exponent(x: float) -> int:
    from math import frexp

    return min(max(frexp(x)[1], -1000), 1000)
