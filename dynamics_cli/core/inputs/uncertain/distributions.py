"""Distributions of uncertain inputs, in SI: each maps a standard normal z to its quantile x = F⁻¹(Φ(z)).

For z > 0 the upper tail is used, so both ends keep their digits. `mean` is an input's nominal value.
"""

import math
from abc import ABC, abstractmethod

import numpy as np

from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.distributions import beta, normal, student
from dynamics_cli.numerics.distributions import normal_arrays as arrays

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# With smaller shapes a beta distribution degenerates to its two bounds, with larger ones to a normal one.
LEAST_SHAPE, MOST_SHAPE = 0.2, 1e4
# The largest angle whose tangent is taken.
_UPRIGHT = 0.5 * math.pi


class Distribution(ABC):
    """An uncertain number: mean, standard deviation, support, and `at(z)`.

    `smooth`: `at` has all derivatives, and no bound is near enough to slow quadrature down.
    """

    name = ""
    smooth = False
    mean: float
    std: float
    low: float = -math.inf
    high: float = math.inf

    @abstractmethod
    def at(self, z: "Array") -> "Array":
        """The quantiles at standard normal scores."""

    @abstractmethod
    def parameters(self) -> "dict[str, Any]":
        """Its parameters by their JSON names, in the unit of the values."""

    def interval(self, coverage: float) -> tuple[float, float]:
        """The central interval."""
        z = -normal.quantile(0.5 * (1.0 - coverage))
        low, high = self.at(np.array([-z, z]))
        return float(low), float(high)


class Normal(Distribution):
    """`0.72 ± 0.04`: mean and standard uncertainty."""

    name = "normal"
    smooth = True

    def __init__(self, mean: float, std: float) -> None:
        _check(std >= 0.0, f"a standard uncertainty of {std:g} is negative")
        self.mean, self.std = mean, std

    def at(self, z: "Array") -> "Array":
        """A straight line."""
        return self.mean + self.std * z

    def parameters(self) -> "dict[str, Any]":
        """Mean and standard deviation."""
        return {"mean": self.mean, "std": self.std}


class Uniform(Distribution):
    """`0.65..0.75`: all values between two bounds equally likely."""

    name = "uniform"

    def __init__(self, low: float, high: float) -> None:
        _check(low <= high, f"the lower bound {low:g} is above the upper one {high:g}")
        self.low, self.high = low, high
        self.mean = 0.5 * low + 0.5 * high
        self.std = (high - low) / math.sqrt(12.0)

    def at(self, z: "Array") -> "Array":
        """Measured from the nearer bound."""
        width = self.high - self.low
        inset = width * arrays.tail(np.minimum(np.abs(z), 40.0))
        return np.where(z < 0.0, self.low + inset, self.high - inset)

    def parameters(self) -> "dict[str, Any]":
        """The bounds."""
        return {"low": self.low, "high": self.high}


class Triangular(Distribution):
    """`0.6..0.7..0.8`: lower bound, most likely value, upper bound."""

    name = "triangular"

    def __init__(self, low: float, mode: float, high: float) -> None:
        _check(low <= mode <= high, f"the most likely value {mode:g} is not between {low:g} and {high:g}")
        self.low, self.mode, self.high = low, mode, high
        self.mean = math.fsum((low, mode, high)) / 3.0
        a, b = mode - low, high - mode
        self.std = math.sqrt((a * a + a * b + b * b) / 18.0)

    def at(self, z: "Array") -> "Array":
        """Two square roots that meet at the mode."""
        width = self.high - self.low
        if width == 0.0:
            return np.full_like(z, self.mode)
        t = arrays.tail(np.minimum(np.abs(z), 40.0))
        below = np.where(z < 0.0, t, 1.0 - t)
        above = np.where(z < 0.0, 1.0 - t, t)
        a, b = self.mode - self.low, self.high - self.mode
        return np.where(
            below * width <= a, self.low + np.sqrt(below * width * a), self.high - np.sqrt(above * width * b)
        )

    def parameters(self) -> "dict[str, Any]":
        """Bounds and mode."""
        return {"low": self.low, "mode": self.mode, "high": self.high}


class Beta(Distribution):
    """`beta(2, 3, 0.6, 0.8)`: shapes α and β of a beta distribution between two bounds."""

    name = "beta"

    def __init__(self, alpha: float, beta: float, low: float, high: float) -> None:
        for shape in (alpha, beta):
            _check(LEAST_SHAPE <= shape <= MOST_SHAPE, f"a shape of {shape:g} is not from 0.2 to 10000")
        _check(low < high, f"the lower bound {low:g} is not below the upper one {high:g}")
        self.alpha, self.beta, self.low, self.high = alpha, beta, low, high
        width, total = high - low, alpha + beta
        self.mean = low + width * (alpha / total)
        self.std = width * math.sqrt(alpha * beta / (total + 1.0)) / total
        self.smooth = min(alpha, beta) > 10.0

    def at(self, z: "Array") -> "Array":
        """Measured from the nearer bound."""
        odds = beta.log_odds(z, self.alpha, self.beta)
        inset = (self.high - self.low) / (1.0 + np.exp(np.minimum(np.abs(odds), 700.0)))
        return np.where(odds < 0.0, self.low + inset, self.high - inset)

    def parameters(self) -> "dict[str, Any]":
        """Shapes and bounds."""
        return {"alpha": self.alpha, "beta": self.beta, "low": self.low, "high": self.high}


class Lognormal(Distribution):
    """`lognormal(0.72 ± 0.04)`: a number whose logarithm is normal; mean and deviation are the number's own."""

    name = "lognormal"
    smooth = True

    def __init__(self, mean: float, std: float) -> None:
        _check(mean > 0.0, f"a lognormal mean of {mean:g} is not above zero")
        _check(std >= 0.0, f"a standard uncertainty of {std:g} is negative")
        self.mean, self.std, self.low = mean, std, 0.0
        self._width = math.sqrt(math.log1p((std / mean) ** 2))
        self._median = mean / math.sqrt(1.0 + (std / mean) ** 2)

    def at(self, z: "Array") -> "Array":
        """Median times a power."""
        return self._median * np.exp(self._width * z)

    def parameters(self) -> "dict[str, Any]":
        """Mean and standard deviation of the number itself."""
        return {"mean": self.mean, "std": self.std}


class Truncated(Distribution):
    """`truncated(0.72 ± 0.1, 0.5, 0.9)`: a normal distribution, given that the number is between two bounds."""

    name = "truncated"

    def __init__(self, centre: float, width: float, low: float, high: float) -> None:
        _check(width > 0.0, f"a standard uncertainty of {width:g} is not above zero")
        _check(low < high, f"the lower bound {low:g} is not below the upper one {high:g}")
        self.centre, self.width, self.low, self.high = centre, width, low, high
        a, b = (low - centre) / width, (high - centre) / width
        # Mirrored if necessary, so that the nearer bound is the lower one and tails stay small numbers.
        self._mirrored = a + b < 0.0
        self._a, self._b = (-b, -a) if self._mirrored else (a, b)
        _check(self._a < 37.0, f"the probability of {centre:g} ± {width:g} between {low:g} and {high:g} is too small")
        self._upper_a, self._upper_b = normal.upper(self._a), normal.upper(self._b)
        first, second = arrays.truncated_moments(self._a, self._b)
        self.mean = centre + width * (-first if self._mirrored else first)
        self.std = width * second

    def at(self, z: "Array") -> "Array":
        """The normal quantile of the share between the bounds' tails, from the smaller side."""
        z = -z if self._mirrored else z
        t = arrays.tail(np.minimum(np.abs(z), 40.0))
        tail = np.where(z < 0.0, 1.0 - t, t)  # P(Z > z)
        part = self._upper_a - self._upper_b
        above = self._upper_b + part * tail
        below = normal.lower(self._a) + part * (np.where(z < 0.0, t, 1.0 - t))
        score = np.where(above <= 0.5, -_quantile(np.minimum(above, 0.5)), _quantile(np.minimum(below, 0.5)))
        score = np.clip(score, self._a, self._b)
        quantile = self.centre + self.width * (-score if self._mirrored else score)
        return np.clip(quantile, self.low, self.high)

    def parameters(self) -> "dict[str, Any]":
        """The normal distribution before it was cut, and the bounds."""
        return {"centre": self.centre, "width": self.width, "low": self.low, "high": self.high}


class StudentT(Distribution):
    """`[0.71, 0.74, 0.70]`: the mean of repeated readings, with a scaled Student t (GUM Supplement 1, 6.4.9)."""

    name = "readings"

    def __init__(self, readings: "Sequence[float]") -> None:
        _check(len(readings) > 1, "repeated readings need at least two")
        count = len(readings)
        self.readings = tuple(readings)
        self.mean = math.fsum(readings) / count
        self.freedom = float(count - 1)
        self.scale = math.sqrt(math.fsum((x - self.mean) ** 2 for x in readings) / (count - 1) / count)
        freedom = self.freedom
        spread = math.sqrt(freedom / (freedom - 2.0)) if freedom > 2.0 else math.inf
        self.std = self.scale * spread if self.scale > 0.0 else 0.0
        self.smooth = count > 10

    def at(self, z: "Array") -> "Array":
        """Student's quantile, scaled."""
        return self.mean + self.scale * student.quantiles(z, self.freedom)

    def parameters(self) -> "dict[str, Any]":
        """The readings."""
        return {"readings": list(self.readings)}


class Empirical(Distribution):
    """`empirical(0.71, 0.74, 0.70)`: one of the listed values, each as likely as the others."""

    name = "empirical"

    def __init__(self, values: "Sequence[float]") -> None:
        _check(len(values) > 0, "an empirical distribution needs values")
        self.values = np.sort(np.array(values, dtype=float))
        count = len(values)
        self.mean = math.fsum(values) / count
        self.std = math.sqrt(math.fsum((x - self.mean) ** 2 for x in values) / count)
        self.low, self.high = float(self.values[0]), float(self.values[-1])

    def at(self, z: "Array") -> "Array":
        """The value whose share of the probability holds Φ(z)."""
        count = len(self.values)
        index = np.ceil(arrays.lower(z) * count - 1e-12).astype(np.int64) - 1
        return self.values[np.clip(index, 0, count - 1)]

    def parameters(self) -> "dict[str, Any]":
        """The values."""
        return {"values": self.values.tolist()}


class Result(Distribution):
    """An earlier result, known by median and interval: normal, or skewed like a shifted lognormal."""

    name = "result"
    smooth = True

    def __init__(self, median: float, low: float, high: float, coverage: float) -> None:
        _check(low <= median <= high and 0.0 < coverage < 1.0, "an interval that does not contain its median")
        self.median, self.ends, self.coverage = median, (low, high), coverage
        score = -normal.quantile(0.5 * (1.0 - coverage))
        below, above = median - low, high - median
        self._bend = math.log(above / below) / score if below > 0.0 and above > 0.0 else 0.0
        bend = self._bend
        straight = abs(bend * score) < 1e-9
        self._scale = (high - low) / (2.0 * score) if straight else bend * above / math.expm1(bend * score)
        self._straight = straight
        self.mean, self.std = median, self._scale
        if not straight:
            half = 0.5 * bend * bend
            self.mean += self._scale * math.expm1(half) / bend
            self.std *= math.exp(half) * math.sqrt(math.expm1(2.0 * half)) / abs(bend)

    def at(self, z: "Array") -> "Array":
        """Through the median and both ends of the interval."""
        if self._straight:
            return self.median + self._scale * z
        return self.median + self._scale * np.expm1(self._bend * z) / self._bend

    def parameters(self) -> "dict[str, Any]":
        """Median and interval."""
        return {"median": self.median, "low": self.ends[0], "high": self.ends[1], "coverage": self.coverage}


class Tangent(Distribution):
    """The tangent of an uncertain angle, such as a grade in degrees: the tangent of each quantile.

    The nominal value is the tangent of the mean angle, `std` its first-order deviation. At 90 degrees and beyond the
    tangent is NaN.
    """

    def __init__(self, angle: Distribution) -> None:
        self.angle = angle
        self.name = angle.name
        self.smooth = angle.smooth
        self.mean = math.tan(angle.mean)
        self.std = angle.std * (1.0 + self.mean * self.mean) if angle.std else 0.0
        if abs(angle.low) < _UPRIGHT and abs(angle.high) < _UPRIGHT:
            self.low, self.high = math.tan(angle.low), math.tan(angle.high)

    def at(self, z: "Array") -> "Array":
        """The tangents of the angle's quantiles."""
        return self.of(self.angle.at(z))

    @staticmethod
    def of(angle: "Array") -> "Array":
        """The tangents of angles."""
        return np.where(np.abs(angle) < _UPRIGHT, np.tan(angle), np.nan)

    def parameters(self) -> "dict[str, Any]":
        """Parameters of the angle."""
        return self.angle.parameters()


def _check(holds: bool, message: str) -> None:
    if not holds:
        raise UsageError(message, code="distribution")


def _quantile(p: "Array") -> "Array":
    return arrays.quantile(np.maximum(p, 1e-320))


KINDS: "dict[str, type[Distribution]]" = {
    made.name: made for made in (Normal, Uniform, Triangular, Beta, Lognormal, Truncated, StudentT, Empirical, Result)
}
