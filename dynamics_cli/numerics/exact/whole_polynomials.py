"""Polynomials with whole coefficients, from the constant up: division, common divisors, Sturm chains, real roots.

Every answer is exact. Coefficients are kept small by dividing by their common factor, without the `fractions` module,
whose import takes as long as two starts of the interpreter.
"""

from itertools import pairwise
from math import gcd, lcm

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from typing import TypeAlias

    Polynomial: TypeAlias = tuple[int, ...]
    Pair: TypeAlias = tuple[int, int]

ONE = (1,)


def trimmed(coefficients: "Iterable[int]") -> "Polynomial":
    """The coefficients without leading zeros; nothing at all of the zero polynomial."""
    out = list(coefficients)
    while out and out[-1] == 0:
        out.pop()
    return tuple(out)


def primitive(coefficients: "Iterable[int]") -> "Polynomial":
    """The polynomial without the common factor of its coefficients; signs stay."""
    out = trimmed(coefficients)
    common = gcd(*out)
    return tuple(c // common for c in out) if common > 1 else out


def plus(first: "Sequence[int]", second: "Sequence[int]", times: int = 1) -> "Polynomial":
    """First + times·second."""
    length = max(len(first), len(second))
    out = [0] * length
    for k, c in enumerate(first):
        out[k] = c
    for k, c in enumerate(second):
        out[k] += times * c
    return trimmed(out)


def times(first: "Sequence[int]", second: "Sequence[int]") -> "Polynomial":
    """The product."""
    if not first or not second:
        return ()
    out = [0] * (len(first) + len(second) - 1)
    for i, a in enumerate(first):
        for j, b in enumerate(second):
            out[i + j] += a * b
    return tuple(out)


def power(base: "Sequence[int]", exponent: int) -> "Polynomial":
    """The base raised to a whole power."""
    product: Polynomial = ONE
    for _ in range(exponent):
        product = times(product, base)
    return product


def mirrored(p: "Sequence[int]") -> "Polynomial":
    """p(−s)."""
    return tuple(-c if k % 2 else c for k, c in enumerate(p))


def derivative(p: "Sequence[int]") -> "Polynomial":
    """p′(s)."""
    return tuple(k * c for k, c in enumerate(p))[1:]


def remainder(p: "Sequence[int]", q: "Sequence[int]") -> "Polynomial":
    """The remainder of p divided by q, times a positive number, in lowest terms."""
    rest, lead = list(trimmed(p)), q[-1]
    while len(rest) >= len(q):
        top, shift = rest.pop(), len(rest) + 1 - len(q)
        # a positive factor alone keeps the sign, on which Sturm's chain depends
        factor, part = (lead, top) if lead > 0 else (-lead, -top)
        rest = [factor * c for c in rest]
        for k, c in enumerate(q[:-1]):
            rest[shift + k] -= part * c
        rest = list(primitive(rest)) if len(rest) >= len(q) else rest
    return primitive(rest)


def quotient(p: "Sequence[int]", q: "Sequence[int]") -> "Polynomial":
    """p/q where q divides p, in lowest terms with the sign of p/q."""
    rest, out = list(p), [0] * (len(p) - len(q) + 1)
    lead = q[-1]
    for shift in range(len(out) - 1, -1, -1):
        top = rest[shift + len(q) - 1]
        common = gcd(top, lead)
        scale, part = lead // common, top // common
        if scale < 0:
            scale, part = -scale, -part
        if scale != 1:
            rest = [scale * c for c in rest]
            out = [scale * c for c in out]
        out[shift] = part
        for k, c in enumerate(q):
            rest[shift + k] -= part * c
    if any(rest):
        raise ArithmeticError("the divisor leaves a remainder")
    return primitive(out)


def common_divisor(p: "Sequence[int]", q: "Sequence[int]") -> "Polynomial":
    """The greatest common divisor, with a positive leading coefficient."""
    a, b = primitive(p), primitive(q)
    while b:
        a, b = b, remainder(a, b)
    return negated(a) if a and a[-1] < 0 else a


def divides(q: "Sequence[int]", p: "Sequence[int]") -> bool:
    """Whether p is a multiple of q."""
    return not p or (len(p) >= len(q) and not remainder(p, q))


def square_free(p: "Sequence[int]") -> "tuple[tuple[Polynomial, int], ...]":
    """The factors of p by the multiplicity of their roots, by Yun's algorithm.

    >>> square_free((1, 1, -1, -1))  # (1 − s)(1 + s)²
    (((-1, 1), 1), ((1, 1), 2))
    """
    primitive_part = primitive(p)
    if len(primitive_part) < 2:
        return ()
    common = common_divisor(primitive_part, derivative(primitive_part))
    rest, out, multiplicity = quotient(primitive_part, common), [], 1
    while len(rest) > 1:
        shared = common_divisor(rest, common)
        factor = quotient(rest, shared)
        if len(factor) > 1:
            out.append((factor if factor[-1] > 0 else negated(factor), multiplicity))
        rest, common = shared, quotient(common, shared)
        multiplicity += 1
    return tuple(out)


def sign_at(p: "Sequence[int]", at: "Pair") -> int:
    """The sign of p at a ratio."""
    top, bottom = at
    value, scale = 0, 1
    for c in reversed(p):
        value = value * top + c * scale
        scale *= bottom
    # p(a/b)·b^n, and b is positive
    return (value > 0) - (value < 0)


def chain(first: "Sequence[int]", second: "Sequence[int]") -> "list[Polynomial]":
    """Sturm's chain: each polynomial is minus the remainder of the two before it."""
    out = [primitive(first), primitive(second)]
    while out[-1]:
        out.append(negated(remainder(out[-2], out[-1])))
    return out[:-1]


def negated(p: "Sequence[int]") -> "Polynomial":
    """−p(s)."""
    return tuple(-c for c in p)


def changes(signs: "Iterable[int]") -> int:
    """How often the sign changes along a row, zeros left out."""
    nonzero = [sign for sign in signs if sign]
    return sum(a != b for a, b in pairwise(nonzero))


def changes_at(polynomials: "Sequence[Sequence[int]]", at: "Pair") -> int:
    """Sign changes along a chain at a ratio."""
    return changes(sign_at(p, at) for p in polynomials)


def changes_far(polynomials: "Sequence[Sequence[int]]", side: int) -> int:
    """Sign changes along a chain far to the right (side 1) or to the left (−1)."""
    return changes((1 if p[-1] > 0 else -1) * (side if len(p) % 2 == 0 else 1) for p in polynomials)


def root_bound(p: "Sequence[int]") -> int:
    """A power of two beyond the size of every root, by Cauchy's bound."""
    lead = abs(p[-1])
    most = max((abs(c) for c in p[:-1]), default=0)
    return 1 << (most // lead + 1).bit_length()


def isolated(p: "Sequence[int]") -> "list[tuple[Pair, Pair]]":
    """Intervals with ratios as ends that hold one real root each, from the least up; a root at a ratio is both ends.

    `p` has no multiple roots. The ends of an interval are not roots, unless it is a point.
    """
    if len(p) < 2:
        return []
    sturm = chain(p, derivative(p))
    bound = root_bound(p)
    intervals: list[tuple[Pair, Pair]] = []
    waiting = [((-bound, 1), (bound, 1), changes_far(sturm, -1), changes_far(sturm, 1))]
    while waiting:
        low, high, before, after = waiting.pop()
        if before == after:
            continue
        if before - after == 1 and sign_at(p, high):
            intervals.append((low, high))
            continue
        middle = _middle(low, high)
        between = changes_at(sturm, middle)
        # Sturm's count is of the roots above the lower end, the upper end among them
        if not sign_at(p, middle):
            intervals.append((middle, middle))
            waiting.append((middle, high, between, after))
            gap = _below(p, sturm, low, middle, between + 1)
            waiting.append((low, gap, before, between + 1))
        else:
            waiting.append((middle, high, between, after))
            waiting.append((low, middle, before, between))
    made = [_off_root(p, *interval) for interval in intervals]
    common = lcm(*(low[1] for low, _ in made))
    return sorted(made, key=lambda interval: interval[0][0] * (common // interval[0][1]))


def _below(p: "Sequence[int]", sturm: "Sequence[Polynomial]", low: "Pair", root: "Pair", count: int) -> "Pair":
    """A ratio below a root with no other root between."""
    place = _middle(low, root)
    while changes_at(sturm, place) != count or not sign_at(p, place):
        place = _middle(place, root)
    return place


def _off_root(p: "Sequence[int]", low: "Pair", high: "Pair") -> "tuple[Pair, Pair]":
    """The interval with its lower end moved up from a neighbouring root."""
    if low == high or sign_at(p, low):
        return low, high
    end = sign_at(p, high)
    while True:
        middle = _middle(low, high)
        sign = sign_at(p, middle)
        if sign == 0:
            return middle, middle
        if sign != end:
            return middle, high
        high = middle


def _middle(low: "Pair", high: "Pair") -> "Pair":
    top, bottom = low[0] * high[1] + high[0] * low[1], 2 * low[1] * high[1]
    common = gcd(top, bottom)
    return top // common, bottom // common


def narrowed(p: "Sequence[int]", interval: "tuple[Pair, Pair]", digits: int) -> "tuple[Pair, Pair]":
    """The interval of a single root halved until its ends agree to so many digits."""
    low, high = interval
    if low == high:
        return interval
    at_high = sign_at(p, high)
    while (high[0] * low[1] - low[0] * high[1]) * 10**digits > min(abs(low[0]) * high[1], abs(high[0]) * low[1]):
        middle = _middle(low, high)
        sign = sign_at(p, middle)
        if sign == 0:
            return middle, middle
        low, high = (low, middle) if sign == at_high else (middle, high)
    return low, high
