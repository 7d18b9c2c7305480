"""Keller's equations of impact in space in 56 digits, by another way than the program: arc by arc in normal impulse.

u grows by K (−μ u_t/|u_t|, 1) per normal impulse p. The program marches in τ, dp = |u_t| dτ; here the Taylor series are
in p itself, whose steps shrink with the slip until it has stopped. After that the way out is sought as an angle.
"""

import operator
import sys
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import Any

from mpmath import mp, mpf

sys.path.insert(0, str(Path(__file__).resolve().parent))

from digits import gmpy2

DIGITS = 56
# A step of a quarter of the radius of convergence: two bits with every coefficient.
ORDER, STRIDE = 90, 0.25
# Slip this small beside that at the start has stopped.
STOPPED = "1e-44"
# A direction that turns so little, beside what turns it back, turns no more.
KEPT = "1e-50"
Number = Any
X, Y, V, FX, FY, W, H = range(7)
number: Any = gmpy2.mpfr if gmpy2 else mpf


@contextmanager
def digits(count: int) -> Iterator[None]:
    """So many digits, and a few bits."""
    bits, before = round(3.33 * count) + 4, mp.prec
    wide = gmpy2.context(gmpy2.get_context(), precision=bits) if gmpy2 else nullcontext()
    mp.prec = bits
    try:
        with wide:
            yield
    finally:
        mp.prec = before


def root(x: Number) -> Number:
    """The square root."""
    return gmpy2.sqrt(x) if gmpy2 else mp.sqrt(x)


def product(a: "list[Number]", b: "list[Number]") -> Number:
    """The last coefficient of a product of series."""
    return sum(map(operator.mul, a, reversed(b)))


def square(a: "list[Number]") -> Number:
    """The last coefficient of a square: its terms come in pairs."""
    n = len(a)
    half = 2 * sum(map(operator.mul, a[: n // 2], reversed(a)))
    return half + a[n // 2] * a[n // 2] if n % 2 else half


def series(k: Any, mu: Number, state: "list[Number]") -> "list[list[Number]]":
    """Taylor coefficients in p of u_1, u_2, u_n, p_1, p_2, the normal force's work and friction's heat."""
    x, y, v, fx, fy, w, h = ([value] for value in state)
    s = [root(x[0] * x[0] + y[0] * y[0])]
    c, d = [x[0] / s[0]], [y[0] / s[0]]
    for n in range(ORDER):
        constant, over = 1 if n == 0 else 0, n + 1
        a, b = -mu * c[n], -mu * d[n]
        x.append((k[0][2] * constant + k[0][0] * a + k[0][1] * b) / over)
        y.append((k[1][2] * constant + k[0][1] * a + k[1][1] * b) / over)
        v.append((k[2][2] * constant + k[0][2] * a + k[1][2] * b) / over)
        fx.append(a / over)
        fy.append(b / over)
        w.append(v[n] / over)
        h.append(mu * s[n] / over)
        later = s[1:]
        s.append((square(x) + square(y) - (square(later) if later else 0)) / (2 * s[0]))
        c.append((x[n + 1] - product(s[1:], c)) / s[0])
        d.append((y[n + 1] - product(s[1:], d)) / s[0])
    return [x, y, v, fx, fy, w, h]


def value(coefficients: "list[Number]", step: Number) -> Number:
    total = number(0)
    for coefficient in reversed(coefficients):
        total = total * step + coefficient
    return total


def reach(coefficients: "list[list[Number]]", farthest: Number) -> Number:
    """A step within the radius of convergence, and within the slip that is left."""
    x, y = coefficients[X], coefficients[Y]
    squared, change = x[0] * x[0] + y[0] * y[0], x[0] * x[1] + y[0] * y[1]
    size = root(squared)
    step = -squared / change if change < 0 else farthest
    for order in (ORDER - 2, ORDER - 1, ORDER):
        last = max(abs(x[order]), abs(y[order]))
        if last:
            step = min(step, (size / last) ** (number(1) / order))
    return step * number(str(STRIDE))


def kept(k: Any, mu: Number, state: "list[Number]") -> "tuple[Number, Number] | None":
    """The direction of a slip that will turn no more in as many digits: from both sides it is turned back."""
    size = root(state[X] * state[X] + state[Y] * state[Y])
    c, d = state[X] / size, state[Y] / size
    a = k[0][2] - mu * (k[0][0] * c + k[0][1] * d)
    b = k[1][2] - mu * (k[0][1] * c + k[1][1] * d)
    back = (a * c + b * d) + mu * (k[0][0] * d * d - 2 * k[0][1] * c * d + k[1][1] * c * c)
    return (c, d) if back > 0 and abs(b * c - a * d) < number(KEPT) * back else None


def line(k: Any, mu: Number, state: "list[Number]", way: "tuple[Number, Number]") -> "list[list[Number]]":
    """The series of a slip that keeps its direction: of two terms, of three for work and heat."""
    a, b = -mu * way[0], -mu * way[1]
    slope = k[2][2] + k[0][2] * a + k[1][2] * b
    growth = way[0] * (k[0][2] + k[0][0] * a + k[0][1] * b) + way[1] * (k[1][2] + k[0][1] * a + k[1][1] * b)
    slip = state[X] * way[0] + state[Y] * way[1]
    first = growth * way[0], growth * way[1], slope, a, b, state[V], mu * slip
    second = 0, 0, 0, 0, 0, slope / 2, mu * growth / 2
    return [[here, one, number(two)] for here, one, two in zip(state, first, second, strict=True)]


def stop(coefficients: "list[list[Number]]", way: "tuple[Number, Number]") -> Number:
    """Where a slip that keeps its direction stops."""
    x, y = coefficients[X], coefficients[Y]
    growth = x[1] * way[0] + y[1] * way[1]
    return -(x[0] * way[0] + y[0] * way[1]) / growth if growth < 0 else number("inf")


def crossing(coefficients: "list[Number]", target: Number, low: Number, high: Number) -> Number:
    """Where a rising series reaches the target: halving, then Newton's method."""
    for _ in range(64):
        middle = (low + high) / 2
        low, high = (low, middle) if value(coefficients, middle) > target else (middle, high)
    slopes = [index * coefficient for index, coefficient in enumerate(coefficients)][1:]
    place = (low + high) / 2
    for _ in range(8):
        slope = value(slopes, place)
        if slope:
            place -= (value(coefficients, place) - target) / slope
    assert low <= place <= high
    return place


class March:
    """Where the slip is, and what is known of the impact's end."""

    def __init__(self, velocity: "list[Number]") -> None:
        self.state = [*velocity, *[number(0)] * 4]
        self.impulse = number(0)
        self.compression: Number | None = None
        self.work = number(0)
        self.steps = 0

    @property
    def slip(self) -> Number:
        return root(self.state[X] * self.state[X] + self.state[Y] * self.state[Y])

    def compressed(self) -> None:
        self.compression, self.work = self.impulse, -self.state[W]


def march(k: Any, mu: Number, e: Number, law: str, velocity: "list[Number]") -> "tuple[March, bool]":
    """Slip to the law's end, or until it has stopped; whether it stopped."""
    now = March(velocity)
    start = max(now.slip, abs(velocity[2]))
    # no impact lasts longer, even where it slips at a constant rate
    farthest = 100 * (start + abs(velocity[2])) / k[2][2]
    while now.steps < 20000:
        if now.slip <= number(STOPPED) * start:
            return now, True
        now.steps += 1
        way = kept(k, mu, now.state)
        coefficients = series(k, mu, now.state) if way is None else line(k, mu, now.state, way)
        step = reach(coefficients, farthest) if way is None else min(farthest, stop(coefficients, way))
        if now.compression is None:
            sought, target = coefficients[V], number(0)
        elif law == "newton":
            sought, target = coefficients[V], -e * velocity[2]
        elif law == "poisson":
            sought, target = [now.impulse, number(1)], (1 + e) * now.compression
        else:
            sought, target = coefficients[W], (e * e - 1) * now.work
        low = number(0)
        for part in range(1, 9):
            high = step * part / 8
            if value(sought, high) >= target:
                step = crossing(sought, target, low, high)
                break
            low = high
        else:
            part = 0
        now.state = [value(one, step) for one in coefficients]
        now.impulse += step
        if part:
            if now.compression is not None:
                return now, False
            now.compressed()
            if e == 0:
                return now, False
    raise AssertionError("no end")


def way_out(k: Any, mu: Number) -> "tuple[Number, Number]":
    """Direction that slip from rest keeps and grows along, where friction cannot hold: an angle."""
    with digits(DIGITS + 10):
        return tuple(number(mp.nstr(part, DIGITS)) for part in _way_out(k, mu))


def _way_out(k: Any, mu: Number) -> "tuple[Any, Any]":
    most = max(mpf(str(entry)) for row in k for entry in row)
    full = [[mpf(str(entry)) / most for entry in row] for row in k]
    friction = mpf(str(mu))

    def rates(angle: Any) -> "tuple[Any, Any]":
        c, s = mp.cos(angle), mp.sin(angle)
        x = full[0][2] - friction * (full[0][0] * c + full[0][1] * s)
        y = full[1][2] - friction * (full[0][1] * c + full[1][1] * s)
        return x * c + y * s, y * c - x * s

    places = [2 * mp.pi * index / 720 for index in range(721)]
    turns = [rates(place)[1] for place in places]
    for low, high, a, b in zip(places, places[1:], turns, turns[1:], strict=False):
        if a * b <= 0:
            angle = mp.findroot(
                lambda angle: rates(angle)[1], (low, high), solver="anderson", tol=mpf(10) ** (-2 * DIGITS - 12)
            )
            if rates(angle)[0] > 0:
                return mp.cos(angle), mp.sin(angle)
    raise AssertionError("no way out")


def straight(k: Any, mu: Number, e: Number, law: str, now: March, approach: Number) -> "tuple[Number, ...]":
    """From where slip has stopped: p_t = c p_n."""
    det = k[0][0] * k[1][1] - k[0][1] * k[0][1]
    c = (k[0][1] * k[1][2] - k[1][1] * k[0][2]) / det, (k[0][1] * k[0][2] - k[0][0] * k[1][2]) / det
    growth = number(0), number(0)
    if c[0] * c[0] + c[1] * c[1] > mu * mu:
        x, y = way_out(k, mu) if mu else (number(1), number(0))
        c = -mu * x, -mu * y
        growth = tuple(k[i][2] + k[i][0] * c[0] + k[i][1] * c[1] for i in (0, 1))  # type: ignore[assignment]
    slope = k[2][2] + k[0][2] * c[0] + k[1][2] * c[1]
    speed, more = now.state[V], number(0)
    if now.compression is None:
        more = -speed / slope
        now.work = -now.state[W] - more * speed / 2
        now.compression, left = now.impulse + more, e * e * now.work
        speed = number(0)
    else:
        left = e * e * now.work - (now.state[W] + now.work)
    if law == "newton":
        rest = (-e * approach - speed) / slope
    elif law == "poisson":
        rest = (1 + e) * now.compression - now.impulse - more
    else:
        rest = (root(speed * speed + 2 * slope * left) - speed) / slope
    more += rest
    heat = now.state[H] + mu * root(growth[0] * growth[0] + growth[1] * growth[1]) * more * more / 2
    return now.state[FX] + c[0] * more, now.state[FY] + c[1] * more, now.impulse + more, heat


class Impact:
    """An impact's end in the frame of the contact, in 56 digits."""

    def __init__(self, k: Any, velocity: Any, mu: Any, e: Any, law: str) -> None:
        """Each number a double, a decimal, or text of digits."""
        with digits(DIGITS):
            full = [[number(entry) for entry in row] for row in k]
            u, friction, restitution = [number(entry) for entry in velocity], number(mu), number(e)
            if friction == 0 or (u[0] == 0 and u[1] == 0):
                now, stopped = March(u), True
            else:
                now, stopped = march(full, friction, restitution, law, u)
            self.slip_impulse = now.impulse
            if stopped:
                *impulse, self.heat = straight(full, friction, restitution, law, now, u[2])
                self.impulse = tuple(impulse)
                if friction == 0:
                    self.slip_impulse = impulse[2]
            else:
                self.impulse, self.heat = (now.state[FX], now.state[FY], now.impulse), now.state[H]
            assert now.compression is not None
            self.compression: Number = now.compression
