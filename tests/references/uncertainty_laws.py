"""Distributions of inputs and of results in multiple precision, for the references of uncertainty.

An input knows its distribution function, its quantiles and expectations of functions of it. A result's law is a
distribution function, a bracket of its quantiles, and its first two moments.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from itertools import product
from math import factorial, inf, prod
from typing import Any

from uncertainty_numbers import (
    Function,
    bell,
    density,
    fineness,
    integral,
    number,
    phi,
    precision,
    real,
    score,
    special,
    total,
    working_digits,
)

REACH = 15
# steps of the trapezoidal rule in a deviation
STEPS = {1: 8, 2: 10}


class Input(ABC):
    """An uncertain input; most give expectations of functions, readings their moments."""

    low: Any = -inf
    high: Any = inf

    @abstractmethod
    def cdf(self, x: Any) -> Any:
        """Share below a value."""

    @abstractmethod
    def quantile(self, p: Any) -> Any:
        """The value below which a share lies."""


class Normal(Input):
    def __init__(self, mean: str, std: str) -> None:
        self.mean, self.std = number(float(mean)), number(float(std))

    def cdf(self, x: Any) -> Any:
        return phi((x - self.mean) / self.std)

    def quantile(self, p: Any) -> Any:
        return self.mean + self.std * score(p)

    def expect(self, function: Function, kinks: Sequence[Any] = (), *, finer: int = 1) -> Any:
        """`finer`: so many times the steps, for what is analytic in a narrow strip only."""
        if kinks:
            places = [-REACH, *sorted((k - self.mean) / self.std for k in kinks), REACH]
            return integral(lambda t: density(t) * function(self.mean + self.std * t), places)
        # the trapezoidal rule: for what is analytic its error falls faster than any power of the step
        return total(w * function(self.mean + self.std * t) for t, w in bell(finer * STEPS[fineness()], REACH))


class Uniform(Input):
    def __init__(self, low: str, high: str) -> None:
        self.low, self.high = number(float(low)), number(float(high))

    def cdf(self, x: Any) -> Any:
        return min(max((x - self.low) / (self.high - self.low), number(0)), number(1))

    def quantile(self, p: Any) -> Any:
        return self.low + (self.high - self.low) * p

    def expect(self, function: Function, kinks: Sequence[Any] = ()) -> Any:
        inside = sorted(k for k in kinks if self.low < k < self.high)
        return integral(function, [self.low, *inside, self.high]) / (self.high - self.low)


class Triangular(Input):
    def __init__(self, low: str, mode: str, high: str) -> None:
        self.low, self.mode, self.high = number(float(low)), number(float(mode)), number(float(high))

    def cdf(self, x: Any) -> Any:
        a, m, b = self.low, self.mode, self.high
        if x <= m:
            return max(x - a, number(0)) ** 2 / ((b - a) * (m - a)) if m > a else number(0)
        return 1 - max(b - x, number(0)) ** 2 / ((b - a) * (b - m))

    def quantile(self, p: Any) -> Any:
        a, m, b = self.low, self.mode, self.high
        if p * (b - a) <= m - a:
            return a + real.sqrt(p * (b - a) * (m - a))
        return b - real.sqrt((1 - p) * (b - a) * (b - m))

    def expect(self, function: Function, kinks: Sequence[Any] = ()) -> Any:
        a, m, b = self.low, self.mode, self.high
        below = [a, *sorted(k for k in kinks if a < k < m), m]
        above = [m, *sorted(k for k in kinks if m < k < b), b]
        left = integral(lambda x: function(x) * (x - a), below) / (m - a) if m > a else number(0)
        right = integral(lambda x: function(x) * (b - x), above) / (b - m) if b > m else number(0)
        return 2 * (left + right) / (b - a)


class Lognormal(Input):
    low = number(0)

    def __init__(self, mean: str, std: str) -> None:
        m, s = number(float(mean)), number(float(std))
        self.width = real.sqrt(real.log1p((s / m) ** 2))
        self.centre = real.log(m) - self.width**2 / 2

    def cdf(self, x: Any) -> Any:
        return phi((real.log(x) - self.centre) / self.width) if x > 0 else number(0)

    def quantile(self, p: Any) -> Any:
        return real.exp(self.centre + self.width * score(p))

    def expect(self, function: Function, kinks: Sequence[Any] = ()) -> Any:
        plain = Normal("0", "1")
        logs = [(real.log(k) - self.centre) / self.width for k in kinks]
        return plain.expect(lambda t: function(real.exp(self.centre + self.width * t)), logs, finer=3)


class Truncated(Input):
    def __init__(self, centre: str, width: str, low: str, high: str) -> None:
        self.centre, self.width, self.low, self.high = (number(float(x)) for x in (centre, width, low, high))
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
        return integral(lambda x: function(x) * density(self._score(x)), places) / (self.width * self.part)


class Readings(Input):
    def __init__(self, *readings: str) -> None:
        values = [number(float(x)) for x in readings]
        count = len(values)
        self.freedom = number(count - 1)
        self.mean = total(values) / count
        self.scale = real.sqrt(total((x - self.mean) ** 2 for x in values) / ((count - 1) * count))

    def cdf(self, x: Any) -> Any:
        t, n = (x - self.mean) / self.scale, self.freedom
        tail = special("betainc", n / 2, number(1) / 2, 0, n / (n + t * t), regularized=True) / 2
        return tail if t < 0 else 1 - tail

    def quantile(self, p: Any) -> Any:
        if p == number(1) / 2:
            return self.mean
        return root(lambda x: self.cdf(x) - p, (self.mean - 40 * self.scale, self.mean + 40 * self.scale))

    def moment(self, power: int) -> Any:
        """The second or fourth moment about the mean."""
        n = self.freedom
        return self.scale**2 * n / (n - 2) if power == 2 else 3 * self.scale**4 * n**2 / ((n - 2) * (n - 4))


def root(function: Function, ends: tuple[Any, Any], near: Any = None) -> Any:
    """The root of a growing function between two ends, or near a place: secants of more and more digits."""
    if near is None:
        with precision(16):
            near = _bracketed(function, *ends)
        with precision(30):
            near = _by_secants(function, number(near), number(10) ** -9)
    return _by_secants(function, number(near), number(10) ** -22)


def _by_secants(function: Function, x: Any, apart: Any) -> Any:
    y = x * (1 + apart) + apart * number(10) ** -12
    fx, fy = function(x), function(y)
    for _ in range(12):
        if fy == fx:
            break
        x, fx, y = y, fy, y - fy * (y - x) / (fy - fx)
        if abs(y - x) <= number(10) ** (4 - working_digits()) * abs(y):
            break
        fy = function(y)
    return y


def _bracketed(function: Function, low: Any, high: Any) -> Any:
    """A few digits of the root: Illinois's regula falsi, which halves a stale end's weight."""
    below, above = function(low), function(high)
    for _ in range(60):
        middle = (low * above - high * below) / (above - below)
        there = function(middle)
        if there == 0 or high - low <= abs(middle) * number(10) ** -9:
            return middle
        if there < 0:
            low, below, above = middle, there, above / 2
        else:
            high, above, below = middle, there, below / 2
        if abs(there) < number(10) ** -11:
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

    def quantile(self, p: Any, near: Any = None) -> Any:
        """Where the distribution function is p."""
        if self._quantile is not None:
            return self._quantile(p)
        return root(lambda w: self.cdf(w) - p, self.ends, near)


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
        lambda w: None, (0, 0), lambda: (mean, variance + mean**2), lambda p: mean + real.sqrt(variance) * score(p)
    )


def lognormal(centre: Any, variance: Any) -> Law:
    """A result whose logarithm is normal."""
    return Law(
        lambda w: None,
        (0, 0),
        lambda: (real.exp(centre + variance / 2), real.exp(2 * centre + 2 * variance)),
        lambda p: real.exp(centre + real.sqrt(variance) * score(p)),
    )


def sum_of_uniforms(*inputs: Uniform) -> Law:
    """Exact piecewise polynomials: Σ ± max(w − Σ of corners, 0)ⁿ/(n!·Π widths)."""
    widths = [one.high - one.low for one in inputs]
    start, n = total(one.low for one in inputs), len(inputs)
    scale = factorial(n) * prod(widths)
    corners = [
        ((-1) ** sum(on), total(width for width, o in zip(widths, on, strict=True) if o))
        for on in product((0, 1), repeat=n)
    ]

    def cdf(w: Any) -> Any:
        return total(sign * max(w - start - corner, number(0)) ** n for sign, corner in corners) / scale

    mean = total((one.low + one.high) / 2 for one in inputs)
    variance = total(width**2 for width in widths) / 12
    return Law(cdf, (start, start + total(widths)), lambda: (mean, variance + mean**2))


def by_survival(cdf: Function, places: Sequence[Any]) -> Callable[[], tuple[Any, Any]]:
    """Moments from a distribution function: E = a + ∫(1 − F), E² = a² + ∫ 2w(1 − F), its kinks among the places."""
    start = places[0]

    def moments() -> tuple[Any, Any]:
        first = start + integral(lambda w: 1 - cdf(w), places)
        second = start**2 + integral(lambda w: 2 * w * (1 - cdf(w)), places)
        return first, second

    return moments
