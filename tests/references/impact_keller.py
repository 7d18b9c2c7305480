"""Keller's equations of impact in space in 56 digits, by another way than the program: arc by arc in normal impulse.

u grows by K (−μ u_t/|u_t|, 1) per normal impulse p. The program marches in τ, dp = |u_t| dτ; here the Taylor series are
in p itself, whose steps shrink with the slip until it has stopped. After that the way out is sought as an angle.
"""

from decimal import Decimal, localcontext
from typing import Any

from mpmath import mp, mpf

DIGITS = 56
# A step of a quarter of the radius of convergence: two bits with every coefficient.
ORDER, STRIDE = 90, Decimal("0.25")
# Slip this small beside that at the start has stopped.
STOPPED = Decimal("1e-44")
Number = Decimal
X, Y, V, FX, FY, W, H = range(7)


def series(k: Any, mu: Number, state: "list[Number]") -> "list[list[Number]]":
    """Taylor coefficients in p of u_1, u_2, u_n, p_1, p_2, the normal force's work and friction's heat."""
    x, y, v, fx, fy, w, h = ([value] for value in state)
    s = [(x[0] * x[0] + y[0] * y[0]).sqrt()]
    c, d = [x[0] / s[0]], [y[0] / s[0]]
    for n in range(ORDER):
        constant = 1 if n == 0 else 0
        a, b, over = -mu * c[n], -mu * d[n], Decimal(n + 1)
        x.append((k[0][2] * constant + k[0][0] * a + k[0][1] * b) / over)
        y.append((k[1][2] * constant + k[0][1] * a + k[1][1] * b) / over)
        v.append((k[2][2] * constant + k[0][2] * a + k[1][2] * b) / over)
        fx.append(a / over)
        fy.append(b / over)
        w.append(v[n] / over)
        h.append(mu * s[n] / over)
        square = sum(map(Decimal.__mul__, x, reversed(x))) + sum(map(Decimal.__mul__, y, reversed(y)))
        s.append((square - sum(map(Decimal.__mul__, s[1:], reversed(s[1:])))) / (2 * s[0]))
        c.append((x[n + 1] - sum(map(Decimal.__mul__, s[1:], reversed(c)))) / s[0])
        d.append((y[n + 1] - sum(map(Decimal.__mul__, s[1:], reversed(d)))) / s[0])
    return [x, y, v, fx, fy, w, h]


def value(coefficients: "list[Number]", step: Number) -> Number:
    total = Decimal(0)
    for coefficient in reversed(coefficients):
        total = total * step + coefficient
    return total


def reach(coefficients: "list[list[Number]]", farthest: Number) -> Number:
    """A step within the radius of convergence, and within the slip that is left."""
    x, y = coefficients[X], coefficients[Y]
    square, change = x[0] * x[0] + y[0] * y[0], x[0] * x[1] + y[0] * y[1]
    size = square.sqrt()
    step = -square / change if change < 0 else farthest
    for order in (ORDER - 2, ORDER - 1, ORDER):
        last = max(abs(x[order]), abs(y[order]))
        if last:
            step = min(step, ((size / last).ln() / order).exp())
    return step * STRIDE


def kept(k: Any, mu: Number, state: "list[Number]") -> "tuple[Number, Number] | None":
    """The direction of a slip that will turn no more in as many digits: from both sides it is turned back."""
    size = (state[X] * state[X] + state[Y] * state[Y]).sqrt()
    c, d = state[X] / size, state[Y] / size
    a = k[0][2] - mu * (k[0][0] * c + k[0][1] * d)
    b = k[1][2] - mu * (k[0][1] * c + k[1][1] * d)
    back = (a * c + b * d) + mu * (k[0][0] * d * d - 2 * k[0][1] * c * d + k[1][1] * c * c)
    return (c, d) if back > 0 and abs(b * c - a * d) < Decimal(10) ** (6 - DIGITS) * back else None


def line(k: Any, mu: Number, state: "list[Number]", way: "tuple[Number, Number]") -> "list[list[Number]]":
    """The series of a slip that keeps its direction: of two terms, of three for work and heat."""
    a, b = -mu * way[0], -mu * way[1]
    slope = k[2][2] + k[0][2] * a + k[1][2] * b
    growth = way[0] * (k[0][2] + k[0][0] * a + k[0][1] * b) + way[1] * (k[1][2] + k[0][1] * a + k[1][1] * b)
    slip = state[X] * way[0] + state[Y] * way[1]
    first = growth * way[0], growth * way[1], slope, a, b, state[V], mu * slip
    second = 0, 0, 0, 0, 0, slope / 2, mu * growth / 2
    return [[here, one, Decimal(two)] for here, one, two in zip(state, first, second, strict=True)]


def stop(coefficients: "list[list[Number]]", way: "tuple[Number, Number]") -> Number:
    """Where a slip that keeps its direction stops."""
    x, y = coefficients[X], coefficients[Y]
    growth = x[1] * way[0] + y[1] * way[1]
    return -(x[0] * way[0] + y[0] * way[1]) / growth if growth < 0 else Decimal("Infinity")


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
        self.state = [*velocity, *[Decimal(0)] * 4]
        self.impulse = Decimal(0)
        self.compression: Number | None = None
        self.work = Decimal(0)
        self.steps = 0

    @property
    def slip(self) -> Number:
        return (self.state[X] * self.state[X] + self.state[Y] * self.state[Y]).sqrt()

    def compressed(self) -> None:
        self.compression, self.work = self.impulse, -self.state[W]


def march(k: Any, mu: Number, e: Number, law: str, velocity: "list[Number]") -> "tuple[March, bool]":
    """Slip to the law's end, or until it has stopped; whether it stopped."""
    now = March(velocity)
    start = max(now.slip, abs(velocity[2]))
    # no impact lasts longer, even where it slips at a constant rate
    farthest = 100 * (start + abs(velocity[2])) / k[2][2]
    while now.steps < 20000:
        if now.slip <= STOPPED * start:
            return now, True
        now.steps += 1
        way = kept(k, mu, now.state)
        coefficients = series(k, mu, now.state) if way is None else line(k, mu, now.state, way)
        step = reach(coefficients, farthest) if way is None else min(farthest, stop(coefficients, way))
        if now.compression is None:
            sought, target = coefficients[V], Decimal(0)
        elif law == "newton":
            sought, target = coefficients[V], -e * velocity[2]
        elif law == "poisson":
            sought, target = [now.impulse, Decimal(1)], (1 + e) * now.compression
        else:
            sought, target = coefficients[W], (e * e - 1) * now.work
        low = Decimal(0)
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
    mp.dps = DIGITS + 10
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
                return Decimal(mp.nstr(mp.cos(angle), DIGITS)), Decimal(mp.nstr(mp.sin(angle), DIGITS))
    raise AssertionError("no way out")


def straight(k: Any, mu: Number, e: Number, law: str, now: March, approach: Number) -> "tuple[Number, ...]":
    """From where slip has stopped: p_t = c p_n."""
    det = k[0][0] * k[1][1] - k[0][1] * k[0][1]
    c = (k[0][1] * k[1][2] - k[1][1] * k[0][2]) / det, (k[0][1] * k[0][2] - k[0][0] * k[1][2]) / det
    growth = Decimal(0), Decimal(0)
    if c[0] * c[0] + c[1] * c[1] > mu * mu:
        x, y = way_out(k, mu) if mu else (Decimal(1), Decimal(0))
        c = -mu * x, -mu * y
        growth = tuple(k[i][2] + k[i][0] * c[0] + k[i][1] * c[1] for i in (0, 1))  # type: ignore[assignment]
    slope = k[2][2] + k[0][2] * c[0] + k[1][2] * c[1]
    speed, more = now.state[V], Decimal(0)
    if now.compression is None:
        more = -speed / slope
        now.work = -now.state[W] - more * speed / 2
        now.compression, left = now.impulse + more, e * e * now.work
        speed = Decimal(0)
    else:
        left = e * e * now.work - (now.state[W] + now.work)
    if law == "newton":
        rest = (-e * approach - speed) / slope
    elif law == "poisson":
        rest = (1 + e) * now.compression - now.impulse - more
    else:
        rest = ((speed * speed + 2 * slope * left).sqrt() - speed) / slope
    more += rest
    heat = now.state[H] + mu * (growth[0] * growth[0] + growth[1] * growth[1]).sqrt() * more * more / 2
    return now.state[FX] + c[0] * more, now.state[FY] + c[1] * more, now.impulse + more, heat


class Impact:
    """An impact's end in the frame of the contact, in 56 digits."""

    def __init__(self, k: Any, velocity: Any, mu: Any, e: Any, law: str) -> None:
        """Each number a double, a decimal, or text of digits."""
        with localcontext(prec=DIGITS):
            full = [[Decimal(entry) for entry in row] for row in k]
            u, friction, restitution = [Decimal(entry) for entry in velocity], Decimal(mu), Decimal(e)
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
