"""Arithmetic for the references of uncertainty: numbers, the normal distribution function, integrals, at a precision.

Numbers are MPFR's where gmpy2 is installed and mpmath's otherwise. The normal distribution function is expanded about
the nearest of its values at every eighth, kept: within a sixteenth its Taylor series has a dozen digits in ten terms.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from itertools import pairwise
from typing import Any

from digits import gmpy2
from mpmath import mp, mpf

Function = Callable[[Any], Any]
number: Any = gmpy2.mpfr if gmpy2 else mpf
real: Any = gmpy2 or mp
# bits of the precision set, and how much finer than need be rules are to be
_state = {"bits": 200, "fineness": 1}


@contextmanager
def precision(digits: int, fineness: int | None = None) -> Iterator[None]:
    """So many digits, and rules of so fine steps."""
    before = dict(_state)
    _set(round(digits * 3.33) + 4, fineness or _state["fineness"])
    try:
        yield
    finally:
        _set(before["bits"], before["fineness"])


def _set(bits: int, fineness: int) -> None:
    _state.update(bits=bits, fineness=fineness)
    mp.prec = bits
    if gmpy2:
        gmpy2.get_context().precision = bits


def fineness() -> int:
    """1 or 2."""
    return _state["fineness"]


def working_digits() -> int:
    """Decimal digits of the precision set."""
    return int(_state["bits"] / 3.33)


def pi() -> Any:
    """π at the precision set."""
    return gmpy2.const_pi() if gmpy2 else +mp.pi


def special(name: str, *arguments: Any, **options: Any) -> Any:
    """One of mpmath's special functions."""
    found = getattr(mp, name)(*(mpf(x) if x else mpf(0) for x in arguments), **options)
    if not gmpy2 or not mp.isfinite(found):
        return number(str(found)) if gmpy2 else found
    sign, mantissa, exponent, _ = found._mpf_
    return (
        gmpy2.mul_2exp(gmpy2.mpfr(-mantissa if sign else mantissa), exponent)
        if exponent >= 0
        else gmpy2.div_2exp(gmpy2.mpfr(-mantissa if sign else mantissa), -exponent)
    )


def total(terms: Any) -> Any:
    """A sum."""
    return sum(terms, number(0))


def density(x: Any) -> Any:
    """The normal density."""
    return real.exp(-x * x / 2) / real.sqrt(2 * pi())


_TABLE: dict[tuple[int, int], list[Any]] = {}
EIGHTHS, FARTHEST = 8, 16


def phi(x: Any) -> Any:
    """The normal distribution function, its lower tail as exact as its middle."""
    if not abs(x) < FARTHEST:
        return number(1) - phi(-x) if x > 0 else special("erfc", -x / real.sqrt(number(2))) / 2
    place = round(float(x) * EIGHTHS)
    key = (_state["bits"], place)
    if key not in _TABLE:
        _TABLE[key] = _coefficients(number(place) / EIGHTHS)
    h, found = x - number(place) / EIGHTHS, number(0)
    for coefficient in reversed(_TABLE[key]):
        found = found * h + coefficient
    return found


def _coefficients(at: Any) -> list[Any]:
    """Taylor's, from Φ″ = −x Φ′: as many as the precision asks for where |h| is a sixteenth."""
    c = [special("erfc", -at / real.sqrt(number(2))) / 2, density(at)]
    least = abs(c[0]) * number(2) ** -(_state["bits"] + 8)
    while len(c) < 8 or max(abs(c[-1]), abs(c[-2])) / 16 ** (len(c) - 2) > least:
        k = len(c) - 2
        before = k * c[k] if k else number(0)
        # (k+2)(k+1) c_{k+2} = −(at (k+1) c_{k+1} + k c_k)
        c.append(-(at * (k + 1) * c[k + 1] + before) / ((k + 2) * (k + 1)))
    return c


def score(p: Any) -> Any:
    """The normal quantile."""
    return real.sqrt(number(2)) * special("erfinv", 2 * p - 1)


_BELLS: dict[tuple[int, int], list[tuple[Any, Any]]] = {}


def bell(count: int, reach: int) -> list[tuple[Any, Any]]:
    """The trapezoidal rule under the normal density: places, `count` in a deviation, and weights."""
    key = (_state["bits"], count)
    if key not in _BELLS:
        places = [number(k) / count for k in range(-reach * count, reach * count + 1)]
        _BELLS[key] = [(t, density(t) / count) for t in places]
    return _BELLS[key]


_NODES: dict[tuple[int, int], list[tuple[Any, Any]]] = {}
FIRST, LAST = 3, 9


def _nodes(level: int) -> list[tuple[Any, Any]]:
    """Distance from the nearer end, as a share, and weight, of the places that a level adds."""
    key = (_state["bits"], level)
    if key not in _NODES:
        made, k, step = [], 1, number(1) / 2**level
        least = number(2) ** -(_state["bits"] + 10)
        while True:
            t = k * step
            grown = real.exp(pi() * real.sinh(t))
            share = 1 / (1 + grown)
            weight = pi() * real.cosh(t) * share * share * grown
            if weight < least:
                break
            made.append((share, weight))
            k += 1 if level == FIRST else 2
        _NODES[key] = made
    return _NODES[key]


def integral(function: Function, places: Sequence[Any]) -> Any:
    """Between the first place and the last, in pieces: the tanh–sinh rule, whatever the ends are like."""
    return total(_piece(function, number(a), number(b)) for a, b in pairwise(places) if a < b)


def _piece(function: Function, a: Any, b: Any) -> Any:
    """Halved steps until two sums agree in half of the digits: the last has twice as many; then `fineness` − 1 more."""
    width, middle = b - a, function((a + b) / 2) * pi() / 4
    heap, before, more = middle, None, fineness() - 1
    enough = number(2) ** -(_state["bits"] * 6 // 10)
    for level in range(FIRST, LAST + 1):
        heap += total(
            weight * (function(a + width * share) + function(b - width * share)) for share, weight in _nodes(level)
        )
        found = heap / 2**level
        if before is not None and abs(found - before) <= enough * abs(found):
            if more == 0:
                return found * width
            more -= 1
        before = found
    return found * width
