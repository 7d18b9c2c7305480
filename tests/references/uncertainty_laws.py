"""Distributions of inputs and of results in multiple precision, for the references of uncertainty.

An input knows its distribution function, its quantiles and expectations of functions of it. A result's law is a
distribution function, a bracket of its quantiles, and its first two moments.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from itertools import pairwise, product
from typing import Any

from mpmath import mp, mpf

Function = Callable[[Any], Any]
REACH = 15
STEPS = {1: 8, 2: 10}
_fineness = 1


@contextmanager
def precision(digits: int, fineness: int) -> Iterator[None]:
    """So many digits, and rules of so fine steps."""
    global _fineness
    before = mp.dps, _fineness
    mp.dps, _fineness = digits, fineness
    try:
        yield
    finally:
        mp.dps, _fineness = before


def phi(x: Any) -> Any:
    """The normal distribution function, its tails as exact as its middle."""
    return mp.erfc(-x / mp.sqrt(2)) / 2


def score(p: Any) -> Any:
    """The normal quantile."""
    return mp.sqrt(2) * mp.erfinv(2 * p - 1)


def integral(function: Function, places: Sequence[Any]) -> Any:
    """Between the first place and the last, in pieces: tanh–sinh, whatever the ends are like."""
    pieces = [pair for pair in pairwise(places) if pair[0] < pair[1]]
    return mp.fsum(mp.quad(function, pair, maxdegree=7 + _fineness) for pair in pieces)


class Input:
    """An uncertain input."""

    low: Any = -mp.inf
    high: Any = mp.inf

    def cdf(self, x: Any) -> Any:
        raise NotImplementedError

    def quantile(self, p: Any) -> Any:
        raise NotImplementedError

    def expect(self, function: Function, kinks: Sequence[Any] = ()) -> Any:
        """The expectation of a function that is smooth between its kinks."""
        raise NotImplementedError


class Normal(Input):
    def __init__(self, mean: str, std: str) -> None:
        self.mean, self.std = mpf(float(mean)), mpf(float(std))

    def cdf(self, x: Any) -> Any:
        return phi((x - self.mean) / self.std)

    def quantile(self, p: Any) -> Any:
        return self.mean + self.std * score(p)

    def expect(self, function: Function, kinks: Sequence[Any] = ()) -> Any:
        if kinks:
            places = [-REACH, *sorted((k - self.mean) / self.std for k in kinks), REACH]
            return integral(lambda t: mp.npdf(t) * function(self.mean + self.std * t), places)
        # the trapezoidal rule: for what is analytic its error falls faster than any power of the step
        count = STEPS[_fineness]
        terms = [
            mp.exp(-((mpf(k) / count) ** 2) / 2) * function(self.mean + self.std * k / count)
            for k in range(-REACH * count, REACH * count + 1)
        ]
        return mp.fsum(terms) / (count * mp.sqrt(2 * mp.pi))


class Uniform(Input):
    def __init__(self, low: str, high: str) -> None:
        self.low, self.high = mpf(float(low)), mpf(float(high))

    def cdf(self, x: Any) -> Any:
        return min(max((x - self.low) / (self.high - self.low), mpf(0)), mpf(1))

    def quantile(self, p: Any) -> Any:
        return self.low + (self.high - self.low) * p

    def expect(self, function: Function, kinks: Sequence[Any] = ()) -> Any:
        inside = sorted(k for k in kinks if self.low < k < self.high)
        return integral(function, [self.low, *inside, self.high]) / (self.high - self.low)


class Triangular(Input):
    def __init__(self, low: str, mode: str, high: str) -> None:
        self.low, self.mode, self.high = mpf(float(low)), mpf(float(mode)), mpf(float(high))

    def cdf(self, x: Any) -> Any:
        a, m, b = self.low, self.mode, self.high
        if x <= m:
            return max(x - a, mpf(0)) ** 2 / ((b - a) * (m - a)) if m > a else mpf(0)
        return 1 - max(b - x, mpf(0)) ** 2 / ((b - a) * (b - m))

    def quantile(self, p: Any) -> Any:
        a, m, b = self.low, self.mode, self.high
        if p * (b - a) <= m - a:
            return a + mp.sqrt(p * (b - a) * (m - a))
        return b - mp.sqrt((1 - p) * (b - a) * (b - m))

    def expect(self, function: Function, kinks: Sequence[Any] = ()) -> Any:
        a, m, b = self.low, self.mode, self.high
        below = [a, *sorted(k for k in kinks if a < k < m), m]
        above = [m, *sorted(k for k in kinks if m < k < b), b]
        left = integral(lambda x: function(x) * (x - a), below) / (m - a) if m > a else mpf(0)
        right = integral(lambda x: function(x) * (b - x), above) / (b - m) if b > m else mpf(0)
        return 2 * (left + right) / (b - a)


class Lognormal(Input):
    low = mpf(0)

    def __init__(self, mean: str, std: str) -> None:
        m, s = mpf(float(mean)), mpf(float(std))
        self.width = mp.sqrt(mp.log1p((s / m) ** 2))
        self.centre = mp.log(m) - self.width**2 / 2

    def cdf(self, x: Any) -> Any:
        return phi((mp.log(x) - self.centre) / self.width) if x > 0 else mpf(0)

    def quantile(self, p: Any) -> Any:
        return mp.exp(self.centre + self.width * score(p))

    def expect(self, function: Function, kinks: Sequence[Any] = ()) -> Any:
        plain = Normal("0", "1")
        logs = [(mp.log(k) - self.centre) / self.width for k in kinks]
        return plain.expect(lambda t: function(mp.exp(self.centre + self.width * t)), logs)


class Truncated(Input):
    def __init__(self, centre: str, width: str, low: str, high: str) -> None:
        self.centre, self.width, self.low, self.high = (mpf(float(x)) for x in (centre, width, low, high))
        self.below, self.above = phi(self._score(self.low)), phi(-self._score(self.high))
        self.part = 1 - self.below - self.above
        if self.below > 0.5:
            self.part = phi(-self._score(self.low)) - self.above

    def _score(self, x: Any) -> Any:
        return (x - self.centre) / self.width

    def cdf(self, x: Any) -> Any:
        x = min(max(x, self.low), self.high)
        if self.below > 0.5:
            return (phi(-self._score(self.low)) - phi(-self._score(x))) / self.part
        return (phi(self._score(x)) - self.below) / self.part

    def quantile(self, p: Any) -> Any:
        ends = (self.low, self.high)
        return root(lambda x: self.cdf(x) - p, ends)

    def expect(self, function: Function, kinks: Sequence[Any] = ()) -> Any:
        middle = [x for x in (self.centre, *kinks) if self.low < x < self.high]
        places = [self.low, *sorted(middle), self.high]
        return integral(lambda x: function(x) * mp.npdf(self._score(x)), places) / (self.width * self.part)


class Readings(Input):
    def __init__(self, *readings: str) -> None:
        values = [mpf(float(x)) for x in readings]
        count = len(values)
        self.freedom = mpf(count - 1)
        self.mean = mp.fsum(values) / count
        self.scale = mp.sqrt(mp.fsum((x - self.mean) ** 2 for x in values) / ((count - 1) * count))

    def cdf(self, x: Any) -> Any:
        t, n = (x - self.mean) / self.scale, self.freedom
        tail = mp.betainc(n / 2, mpf(1) / 2, 0, n / (n + t * t), regularized=True) / 2
        return tail if t < 0 else 1 - tail

    def quantile(self, p: Any) -> Any:
        if p == mpf(1) / 2:
            return self.mean
        return root(lambda x: self.cdf(x) - p, (self.mean - 40 * self.scale, self.mean + 40 * self.scale))

    def moment(self, power: int) -> Any:
        """The second or fourth moment about the mean."""
        n = self.freedom
        return self.scale**2 * n / (n - 2) if power == 2 else 3 * self.scale**4 * n**2 / ((n - 2) * (n - 4))


def root(function: Function, ends: tuple[Any, Any]) -> Any:
    """The root of a growing function between two ends: bracketed in low precision, then by secants in full."""
    full = mp.dps
    mp.dps = 15
    try:
        x = _bracketed(function, *ends)
    finally:
        mp.dps = full
    y = x * (1 + mpf(10) ** -8) + mpf(10) ** -20
    fx, fy = function(x), function(y)
    for _ in range(12):
        if fy == fx:
            break
        x, fx, y = y, fy, y - fy * (y - x) / (fy - fx)
        fy = function(y)
        if abs(y - x) <= mpf(10) ** (4 - mp.dps) * abs(y) or fy == 0:
            break
    return y


def _bracketed(function: Function, low: Any, high: Any) -> Any:
    """A few digits of the root: Illinois's regula falsi, which halves a stale end's weight."""
    below, above = function(low), function(high)
    for _ in range(60):
        middle = (low * above - high * below) / (above - below)
        there = function(middle)
        if there == 0 or high - low <= abs(middle) * mpf(10) ** -9:
            return middle
        if there < 0:
            low, below, above = middle, there, above / 2
        else:
            high, above, below = middle, there, below / 2
        if abs(there) < mpf(10) ** -11:
            return middle
    return middle


class Law:
    """What is known of a result: P(result ≤ w), an interval that holds its quantiles, E(result), E(result²)."""

    def __init__(
        self, cdf: Function, ends: tuple[Any, Any], moments: Callable[[], tuple[Any, Any]],
        quantile: Function | None = None,
    ) -> None:  # fmt: skip
        self.cdf = cdf
        self.ends = ends
        self.moments = moments
        self._quantile = quantile

    def quantile(self, p: Any) -> Any:
        """Where the distribution function is p."""
        if self._quantile is not None:
            return self._quantile(p)
        return root(lambda w: self.cdf(w) - p, self.ends)


def rising(made: Input, function: Function, kinks: Sequence[Any] = (), *, sign: int = 1) -> Law:
    """A rising (or falling) function of one input."""
    return Law(
        lambda w: None,
        (0, 0),
        lambda: (made.expect(function, kinks), made.expect(lambda x: function(x) ** 2, kinks)),
        lambda p: function(made.quantile(p if sign > 0 else 1 - p)),
    )


def normal(mean: Any, variance: Any) -> Law:
    """A normal result."""
    return Law(
        lambda w: None, (0, 0), lambda: (mean, variance + mean**2), lambda p: mean + mp.sqrt(variance) * score(p)
    )


def lognormal(centre: Any, variance: Any) -> Law:
    """A result whose logarithm is normal."""
    return Law(
        lambda w: None,
        (0, 0),
        lambda: (mp.exp(centre + variance / 2), mp.exp(2 * centre + 2 * variance)),
        lambda p: mp.exp(centre + mp.sqrt(variance) * score(p)),
    )


def sum_of_uniforms(*inputs: Uniform) -> Law:
    """Exact piecewise polynomials: Σ ± max(w − Σ of corners, 0)ⁿ/(n!·Π widths)."""
    widths = [one.high - one.low for one in inputs]
    start, n = mp.fsum(one.low for one in inputs), len(inputs)
    scale = mp.factorial(n) * mp.fprod(widths)
    corners = [
        ((-1) ** sum(on), mp.fsum(width for width, o in zip(widths, on, strict=True) if o))
        for on in product((0, 1), repeat=n)
    ]

    def cdf(w: Any) -> Any:
        return mp.fsum(sign * max(w - start - corner, mpf(0)) ** n for sign, corner in corners) / scale

    mean = mp.fsum((one.low + one.high) / 2 for one in inputs)
    variance = mp.fsum(width**2 for width in widths) / 12
    return Law(cdf, (start, start + mp.fsum(widths)), lambda: (mean, variance + mean**2))


def by_survival(cdf: Function, places: Sequence[Any]) -> Callable[[], tuple[Any, Any]]:
    """Moments from a distribution function: E = a + ∫(1 − F), E² = a² + ∫ 2w(1 − F), its kinks among the places."""
    start = places[0]

    def moments() -> tuple[Any, Any]:
        first = start + integral(lambda w: 1 - cdf(w), places)
        second = start**2 + integral(lambda w: 2 * w * (1 - cdf(w)), places)
        return first, second

    return moments
