"""A number that carries its derivatives and a rounding bound through the formula that computes it.

Sent through a physics function in place of floats, it does the same floating-point operations in the same order, so
its `value` is the answer to the bit; `error` bounds its rounding error (for the doubles that went in), and
`slopes` are its derivatives by the inputs.

Running error analysis: with unit roundoff u = 2⁻⁵³ an operation turns bounds into |f'|·e + second order + u·|result|
(Higham, Accuracy and Stability of Numerical Algorithms, 3.3). Functions of the C library count as one ulp (2u).
"""

import math

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

UNIT_ROUNDOFF = 2.0**-53
# Error that gradual underflow can add to any result.
TINY = 5e-324
_UNDERFLOWS = 1e-290
# A product with one of these is exact.
_EXACT_FACTORS = (1.0, -1.0, 2.0, -2.0, 0.5, -0.5)
# Covers the rounding of the bound's own arithmetic.
_SLACK = 1.0 + 2.0**-30

if TYPE_CHECKING:
    Number = "Tracked | float"


class Tracked:
    """A value with a bound on its rounding error and its derivatives by the tracked inputs.

    References
    ----------
    N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., SIAM 2002, section 3.3.
    """

    __slots__ = ("error", "slopes", "value")

    def __init__(self, value: float, error: float, slopes: "tuple[float, ...]") -> None:
        self.value = value
        self.error = error
        self.slopes = slopes

    @classmethod
    def inputs(cls, values: "Sequence[float]") -> "list[Tracked]":
        """Exact inputs, each with slope one with respect to itself."""
        count = len(values)
        return [cls(value, 0.0, tuple(1.0 if i == j else 0.0 for j in range(count))) for i, value in enumerate(values)]

    def _result(self, value: float, spread: float, slopes: "tuple[float, ...]", roundings: float = 1.0) -> "Tracked":
        error = (spread + roundings * UNIT_ROUNDOFF * abs(value)) * _SLACK
        if 0.0 < abs(value) < _UNDERFLOWS:
            error += TINY
        return Tracked(value, error, slopes)

    def _of(self, other: "Tracked | float") -> "Tracked":
        if isinstance(other, Tracked):
            return other
        return Tracked(other, 0.0, (0.0,) * len(self.slopes))

    def _chain(self, slope: float) -> "tuple[float, ...]":
        return tuple([slope * part for part in self.slopes])

    def __add__(self, other: "Tracked | float") -> "Tracked":
        if not isinstance(other, Tracked):
            if other == 0.0:
                # minus zero and zero is zero, as for doubles: an arc tangent turns by 2π with the sign of a zero
                return self if self.value else Tracked(self.value + other, self.error, self.slopes)
            return self._result(self.value + other, self.error, self.slopes)
        slopes = tuple([a + b for a, b in zip(self.slopes, other.slopes, strict=True)])
        exact = _exact_sum(self.value, other.value)
        return self._result(self.value + other.value, self.error + other.error, slopes, 0.0 if exact else 1.0)

    __radd__ = __add__

    def __neg__(self) -> "Tracked":
        return Tracked(-self.value, self.error, self._chain(-1.0))

    def __pos__(self) -> "Tracked":
        return self

    def __abs__(self) -> "Tracked":
        return self if math.copysign(1.0, self.value) > 0.0 else -self

    def __sub__(self, other: "Tracked | float") -> "Tracked":
        if not isinstance(other, Tracked):
            return self + (-other)
        slopes = tuple([a - b for a, b in zip(self.slopes, other.slopes, strict=True)])
        exact = _exact_sum(self.value, -other.value)
        return self._result(self.value - other.value, self.error + other.error, slopes, 0.0 if exact else 1.0)

    def __rsub__(self, other: float) -> "Tracked":
        return (-self) + other

    def __mul__(self, other: "Tracked | float") -> "Tracked":
        b = self._of(other)
        spread = abs(self.value) * b.error + abs(b.value) * self.error + self.error * b.error
        if spread < _UNDERFLOWS and (self.error or b.error):
            spread += _faint(self, b)
        slopes = tuple([b.value * i + self.value * j for i, j in zip(self.slopes, b.slopes, strict=True)])
        value = self.value * b.value
        exact = self.value in _EXACT_FACTORS or b.value in _EXACT_FACTORS
        return self._result(value, spread + _lost(value, self.value, b.value), slopes, 0.0 if exact else 1.0)

    __rmul__ = __mul__

    def __truediv__(self, other: "Tracked | float") -> "Tracked":
        b = self._of(other)
        value = self.value / b.value
        least_divisor = abs(b.value) - b.error
        spread = (self.error + abs(value) * b.error) / least_divisor if least_divisor > 0.0 else math.inf
        if spread < _UNDERFLOWS and (self.error or b.error):
            spread += 4.0 * TINY if self.value or self.error else 0.0
        slopes = tuple([(i - value * j) / b.value for i, j in zip(self.slopes, b.slopes, strict=True)])
        return self._result(value, spread + _lost(value, self.value), slopes)

    def __rtruediv__(self, other: float) -> "Tracked":
        return self._of(other) / self

    def __pow__(self, exponent: float) -> "Tracked":
        raise TypeError("write x*x, not x**2: powers differ in the last bit between float and array")

    def __float__(self) -> float:
        raise TypeError("a tracked number does not turn into a float: use the functions of numerics.elementary")

    def __bool__(self) -> bool:
        return self.value != 0.0

    def __lt__(self, other: "Tracked | float") -> bool:
        return self.value < _plain(other)

    def __le__(self, other: "Tracked | float") -> bool:
        return self.value <= _plain(other)

    def __gt__(self, other: "Tracked | float") -> bool:
        return self.value > _plain(other)

    def __ge__(self, other: "Tracked | float") -> bool:
        return self.value >= _plain(other)

    def __eq__(self, other: object) -> bool:
        return self.value == _plain(other)  # type: ignore[arg-type]

    def __hash__(self) -> int:
        return hash(self.value)

    def __repr__(self) -> str:
        return f"Tracked({self.value!r} ± {self.error:.1e})"

    def apply(self, name: str, *arguments: "Tracked | float") -> "Tracked":
        """The elementary function `name` of tracked and plain arguments."""
        tracked = [self._of(argument) for argument in arguments]
        value, spread, partials, roundings = _RULES[name](*tracked)
        if spread < _UNDERFLOWS and any(argument.error for argument in tracked):
            spread += 4.0 * TINY
        slopes = tuple(
            [
                # an infinite slope, as of a root at zero, applies to the inputs that the argument depends on
                sum([partial * slope for partial, slope in zip(partials, column, strict=True) if slope], 0.0)
                for column in zip(*[argument.slopes for argument in tracked], strict=True)
            ]
        )
        return self._result(value, spread, slopes, roundings)


def _exact_sum(a: float, b: float) -> bool:
    """Whether a sum is exact (Knuth's error of it is zero), as when nearly equal numbers are subtracted."""
    total = a + b
    part = total - a
    return (a - (total - part)) + (b - part) == 0.0


def _lost(value: float, *factors: float) -> float:
    """Bound of a product or quotient that underflowed to zero."""
    return TINY if value == 0.0 and all(factors) else 0.0


def _faint(a: Tracked, b: Tracked) -> float:
    """Amount that underflow may have removed from the bound of a product."""
    uncertain = (a.error and (b.value or b.error)) or (b.error and a.value)
    return 4.0 * TINY if uncertain else 0.0


def _plain(x: "Tracked | float") -> float:
    return x.value if isinstance(x, Tracked) else x


if TYPE_CHECKING:
    Rule = Callable[..., tuple[float, float, tuple[float, ...], float]]


def _sqrt(x: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    value = math.sqrt(x.value)
    low = math.sqrt(max(x.value - x.error, 0.0))
    spread = x.error / (value + low) if value > 0.0 else math.sqrt(x.error)
    # at zero the slope is infinite, and a condition number is meaningless
    return value, spread, (0.5 / value if value > 0.0 else math.inf,), 1.0


def _monotone(
    function: "Callable[[float], float]", slope: "Callable[[float], float]", low: float, high: float
) -> "Rule":
    """A rule for a function whose slope is largest at an end of the uncertain interval, within (low, high)."""

    def rule(x: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
        steepest = 0.0
        if x.error:
            a, b = x.value - x.error, x.value + x.error
            inside = low < a and b < high and not (function is math.tan and _pole_between(a, b))
            steepest = max(abs(slope(a)), abs(slope(b))) if inside else math.inf
        return function(x.value), steepest * x.error if x.error else 0.0, (slope(x.value),), 2.0

    return rule


def _pole_between(left: float, right: float) -> bool:
    """Whether a tangent passes a pole between the two."""
    return right - left >= math.pi or math.cos(left) * math.cos(right) <= 0.0


def _sin(x: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    slope = math.cos(x.value)
    return math.sin(x.value), min(abs(slope) + x.error, 1.0) * x.error, (slope,), 2.0


def _cos(x: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    slope = -math.sin(x.value)
    return math.cos(x.value), min(abs(slope) + x.error, 1.0) * x.error, (slope,), 2.0


def _atan(x: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    nearest = max(abs(x.value) - x.error, 0.0)
    return math.atan(x.value), x.error / (1.0 + nearest * nearest), (1.0 / (1.0 + x.value * x.value),), 2.0


def _hypot(x: Tracked, y: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    value = math.hypot(x.value, y.value)
    if value == 0.0:
        return value, x.error + y.error, (0.0, 0.0), 2.0
    along, across = x.value / value, y.value / value
    second_order = (x.error * (x.error / value) + y.error * (y.error / value)) * 0.5
    spread = min(abs(along) * x.error + abs(across) * y.error + second_order, x.error + y.error)
    return value, spread, (along, across), 2.0


def _atan2(y: Tracked, x: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    value = math.atan2(y.value, x.value)
    radius = math.hypot(x.value, y.value)
    disc = math.hypot(x.error, y.error)
    if disc == 0.0:
        spread = 0.0
    elif disc < radius:
        # the sine of the angle between the two points is their cross product over both radii, to all orders
        sine = (abs(x.value / radius) * y.error + abs(y.value / radius) * x.error) / (radius - disc)
        spread = sine * (1.0 + sine * sine) if sine < 0.5 else math.pi / 2 * min(sine, 1.0)
    else:
        spread = math.inf
    spread += _lost(value, y.value)
    partials = (x.value / radius / radius, -y.value / radius / radius) if radius > 0.0 else (0.0, 0.0)
    return value, spread, partials, 2.0


def _exp(x: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    value = math.exp(x.value)
    grown = math.exp(x.value + x.error) if x.error else value
    return value, grown * x.error + (TINY if value == 0.0 else 0.0), (value,), 2.0


# The C library's hyperbolic functions are within two units in the last place.
_HYPERBOLIC = 5.0


def _sinh(x: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    return math.sinh(x.value), math.cosh(abs(x.value) + x.error) * x.error, (math.cosh(x.value),), _HYPERBOLIC


def _cosh(x: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    return math.cosh(x.value), math.sinh(abs(x.value) + x.error) * x.error, (math.sinh(x.value),), _HYPERBOLIC


def _tanh(x: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    steepest = 1.0 / math.cosh(min(max(abs(x.value) - x.error, 0.0), 300.0))
    slope = 1.0 / math.cosh(min(abs(x.value), 300.0))
    return math.tanh(x.value), steepest * steepest * x.error, (slope * slope,), _HYPERBOLIC


def _larger(x: Tracked, y: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    winner, loser = (x, y) if x.value >= y.value else (y, x)
    apart = winner.value - winner.error > loser.value + loser.error
    spread = winner.error if apart else max(x.error, y.error)
    return winner.value, spread, (1.0, 0.0) if winner is x else (0.0, 1.0), 0.0


def _smaller(x: Tracked, y: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    value, spread, partials, roundings = _larger(-x, -y)
    return -value, spread, partials, roundings


def _multiply_add(a: Tracked, b: Tracked, c: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    from dynamics_cli.numerics.elementary import multiply_add, product_error

    value = multiply_add(a.value, b.value, c.value)
    spread = abs(a.value) * b.error + abs(b.value) * a.error + a.error * b.error + c.error
    # Dekker's product is exact while nothing underflows; the compensation itself is rounded at u².
    product = abs(a.value * b.value)
    if 0.0 < product < 1e-290 or product > 6e299:
        spread += 2.0 * UNIT_ROUNDOFF * product + 4.0 * TINY
    else:
        spread += 4.0 * UNIT_ROUNDOFF * UNIT_ROUNDOFF * (product + abs(c.value))
    rounded = a.value * b.value
    exact = (
        value - rounded == c.value and value - c.value == rounded and product_error(a.value, b.value, rounded) == 0.0
    )
    return value, spread, (b.value, a.value, 1.0), 0.0 if exact else 1.0


def _pi(x: Tracked) -> "tuple[float, float, tuple[float, ...], float]":
    # a double is 1.23e-16 off
    return math.pi, 0.0, (0.0,), 0.36


_RULES: "dict[str, Rule]" = {
    "pi": _pi,
    "sqrt": _sqrt,
    "sin": _sin,
    "cos": _cos,
    "atan": _atan,
    "hypot": _hypot,
    "atan2": _atan2,
    "multiply_add": _multiply_add,
    "exp": _exp,
    "maximum": _larger,
    "minimum": _smaller,
    "log": _monotone(math.log, lambda x: 1.0 / x, 0.0, math.inf),
    "sinh": _sinh,
    "cosh": _cosh,
    "tanh": _tanh,
    "tan": _monotone(math.tan, lambda x: 1.0 + math.tan(x) ** 2, -math.inf, math.inf),
    "asin": _monotone(math.asin, lambda x: 1.0 / math.sqrt((1.0 - x) * (1.0 + x)), -1.0, 1.0),
    "acos": _monotone(math.acos, lambda x: -1.0 / math.sqrt((1.0 - x) * (1.0 + x)), -1.0, 1.0),
}
