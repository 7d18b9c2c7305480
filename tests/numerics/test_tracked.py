"""The rounding bound and derivatives of tracked numbers, against 60-digit arithmetic over random formulas."""

import math
import random
from collections.abc import Callable
from fractions import Fraction

import mpmath
import pytest

from dynamics_cli.numerics import elementary as el
from dynamics_cli.numerics.tracked import Tracked

mpmath.mp.dps = 60
UNARY: list[tuple[Callable, Callable, Callable[[float], bool]]] = [
    (el.sqrt, mpmath.sqrt, lambda x: x > 0.0),
    (el.sin, mpmath.sin, lambda x: abs(x) < 1e4),
    (el.cos, mpmath.cos, lambda x: abs(x) < 1e4),
    (el.tan, mpmath.tan, lambda x: abs(x) < 1.5),
    (el.atan, mpmath.atan, lambda x: True),
    (el.asin, mpmath.asin, lambda x: abs(x) < 0.999),
    (el.acos, mpmath.acos, lambda x: abs(x) < 0.999),
    (el.exp, mpmath.exp, lambda x: abs(x) < 300.0),
    (el.log, mpmath.log, lambda x: x > 0.0),
    (el.sinh, mpmath.sinh, lambda x: abs(x) < 300.0),
    (el.cosh, mpmath.cosh, lambda x: abs(x) < 300.0),
    (el.tanh, mpmath.tanh, lambda x: True),
    (abs, abs, lambda x: True),
    (lambda x: -x, lambda x: -x, lambda x: True),
]
BINARY: list[tuple[Callable, Callable, Callable[[float, float], bool]]] = [
    (lambda a, b: a + b, lambda a, b: a + b, lambda a, b: True),
    (lambda a, b: a - b, lambda a, b: a - b, lambda a, b: True),
    (lambda a, b: a * b, lambda a, b: a * b, lambda a, b: abs(a) < 1e100 and abs(b) < 1e100),
    (lambda a, b: a / b, lambda a, b: a / b, lambda a, b: abs(b) > 1e-100 and abs(a) < 1e100),
    (el.hypot, mpmath.hypot, lambda a, b: abs(a) < 1e100 and abs(b) < 1e100),
    (el.atan2, mpmath.atan2, lambda a, b: abs(a) + abs(b) > 1e-100),
]


def grow(generator: random.Random, inputs: list[float], depth: int) -> tuple[Tracked, mpmath.mpf]:
    """A random formula of random inputs, tracked and in 60 digits, within every function's domain."""
    numbers = Tracked.inputs(inputs)
    pool: list[tuple[Tracked, mpmath.mpf]] = [(n, mpmath.mpf(x)) for n, x in zip(numbers, inputs, strict=True)]
    for _ in range(depth):
        kind = generator.random()
        if kind < 0.45:
            function, exact, fits = generator.choice(UNARY)
            x, ex = generator.choice(pool)
            if fits(x.value) and x.error < 1e-3 * max(abs(x.value), 1e-3):
                pool.append((function(x), exact(ex)))
        elif kind < 0.9:
            function, exact, fits = generator.choice(BINARY)
            (a, ea), (b, eb) = generator.choice(pool), generator.choice(pool)
            if fits(a.value, b.value) and b.error < 0.1 * abs(b.value):
                pool.append((function(a, b), exact(ea, eb)))
        else:
            (a, ea), (b, eb), (c, ec) = (generator.choice(pool) for _ in range(3))
            if max(abs(a.value), abs(b.value)) < 1e100:
                pool.append((el.multiply_add(a, b, c), ea * eb + ec))
    return pool[-1]


def test_the_bound_is_never_below_the_true_error() -> None:
    generator = random.Random(1)
    ratios = []
    for _ in range(6000):
        inputs = [generator.choice([-1, 1]) * 10.0 ** generator.uniform(-3, 3) for _ in range(3)]
        number, exact = grow(generator, inputs, generator.randint(1, 8))
        if not math.isfinite(number.value) or not math.isfinite(number.error):
            continue
        error = abs(mpmath.mpf(number.value) - exact)
        assert number.error >= error, (inputs, number, exact)
        ratios.append(number.error / max(float(error), 2.0**-53 * abs(number.value), 1e-300))
    ratios.sort()
    assert len(ratios) > 5000
    assert ratios[len(ratios) // 2] < 10.0


def test_cancellation_is_seen() -> None:
    (x,) = Tracked.inputs([1.0 / 3.0])
    difference = (x + 1.0) - 1.0 - x
    exact = abs(mpmath.mpf(difference.value))
    assert exact <= difference.error < 1e-15


@pytest.mark.parametrize(
    ("function", "x"),
    [(el.sqrt, 2.0), (el.sin, 0.7), (el.cos, 0.7), (el.tan, 0.7), (el.atan, 3.0), (el.exp, 1.5), (el.log, 3.0)]
    + [(el.asin, 0.4), (el.acos, 0.4), (abs, -2.0), (lambda x: 1.0 / x, 3.0), (lambda x: x * x - 2.0 * x, 5.0)],
)
def test_slopes_are_derivatives(function: Callable, x: float) -> None:
    (tracked,) = Tracked.inputs([x])
    plain = {el.sqrt: mpmath.sqrt, el.sin: mpmath.sin, el.cos: mpmath.cos, el.tan: mpmath.tan, el.atan: mpmath.atan}
    plain.update({el.exp: mpmath.exp, el.log: mpmath.log, el.asin: mpmath.asin, el.acos: mpmath.acos})
    expected = mpmath.diff(plain.get(function, function), mpmath.mpf(x))
    assert function(tracked).slopes[0] == pytest.approx(float(expected), rel=1e-13)


def test_slopes_of_two_arguments() -> None:
    x, y = Tracked.inputs([3.0, 4.0])
    assert el.hypot(x, y).slopes == pytest.approx((0.6, 0.8))
    assert el.atan2(y, x).slopes == pytest.approx((-4.0 / 25.0, 3.0 / 25.0))
    assert el.multiply_add(x, y, x).slopes == pytest.approx((5.0, 3.0))


def test_what_would_lose_the_tracking_is_refused() -> None:
    (x,) = Tracked.inputs([2.0])
    with pytest.raises(TypeError, match="x\\*x"):
        _ = x**2
    with pytest.raises(TypeError, match="elementary"):
        math.sqrt(x)


def test_comparisons_are_of_values() -> None:
    x, y = Tracked.inputs([2.0, 3.0])
    assert x < y
    assert x <= 2.0
    assert not x > y
    assert x == 2.0
    assert max(x, y) is y


def test_a_sum_that_is_exact_adds_nothing_to_the_bound() -> None:
    exact = [(0.07, -0.04), (300.0, -299.99999999999994), (1.5, 0.25), (1.0, 0.0), (5e-324, 5e-324), (1e300, -1e300)]
    for a, b in exact:
        one, two = Tracked.inputs([a, b])
        assert Fraction(a) + Fraction(b) == Fraction(a + b)
        assert (one + two).error <= 5e-324
    for a, b in [(0.1, 0.2), (1.0, 2.0**-54), (0.07, 0.04), (1e16, 1.0 + 2.0**-52)]:
        one, two = Tracked.inputs([a, b])
        left = abs(Fraction(a) + Fraction(b) - Fraction(a + b))
        assert 0 < left <= Fraction((one + two).error)
    one, two = Tracked.inputs([1e308, 1e308])
    assert (one + two).error == math.inf


@pytest.mark.parametrize("value", [0.0, -0.0, 1.0, -1.0])
@pytest.mark.parametrize("other", [0.0, -0.0])
def test_zeros_have_the_signs_of_doubles(value: float, other: float) -> None:
    """An arc tangent turns by 2π with the sign of a zero: a heading of exactly 180 degrees came out as −180."""
    (x,) = Tracked.inputs([value])
    pairs = [(x + other, value + other), (other + x, other + value), (x - other, value - other), (abs(x), abs(value))]
    pairs += [(other - x, other - value), (-x, -value), (x * other, value * other)]
    for tracked, plain in pairs:
        assert (tracked.value, math.copysign(1.0, tracked.value)) == (plain, math.copysign(1.0, plain))
    assert el.atan2(x + 0.0, Tracked.inputs([-1.0])[0]).value == math.atan2(value + 0.0, -1.0)
