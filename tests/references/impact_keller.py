"""Keller's equations of impact in space by another way than the program's: by direction and speed of the slip.

With ŝ = (cos φ, sin φ) the direction and σ the speed of the slip, r = k_tn − μ K_tt ŝ and dp_n = σ dτ,

    φ' = n̂·r,    σ' = σ (ŝ·r),    n̂ ⟂ ŝ.

The direction alone decides how it turns; speed, normal velocity, impulses, work and heat follow. (The program marches
u_t itself, in doubles and decimals.) One path serves every law and restitution: it is the same, and ends earlier or
later. Where the slip has stopped all is linear.
"""

import sys
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from itertools import pairwise
from math import exp
from operator import mul
from pathlib import Path as File
from typing import Any, NamedTuple

from mpmath import mp

sys.path.insert(0, str(File(__file__).resolve().parent))

from digits import MANY, gmpy2


class Effort(NamedTuple):
    """Bits of the arithmetic, order of the series, and two shares as powers of two.

    Slip that has become as small a share of the approach, or of what it was, has stopped. A direction as near to one
    that it would keep is taken for it.
    """

    bits: int
    order: int
    stopped: int
    near: int


# For thousands of impacts to twenty digits, and for references of forty.
SEARCH, REFERENCE = Effort(128, 25, 76, 67), Effort(210, 66, 150, 168)
Exact = MANY.number
STRIDE = Exact(exp(-2.0))
MOST_STEPS = 600
PIECES = 8
C, S, G, V, P, FX, FY, W, H = range(9)
sqrt, log, power = MANY.sqrt, MANY.library.log, MANY.library.exp
Number = Any
Matrix = list[list[Number]]


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Arithmetic of so many bits."""
    with mp.workprec(bits), gmpy2.context(gmpy2.get_context(), precision=bits) if gmpy2 else nullcontext():
        yield


def value(coefficients: list[Number], step: Number) -> Number:
    """The series at `step`."""
    total = coefficients[-1]
    for coefficient in coefficients[-2::-1]:
        total = total * step + coefficient
    return total


class Path:
    """The slip of an impact from its start for as long as it is asked for."""

    def __init__(self, k: Matrix, velocity: list[Number], mu: Number, effort: Effort) -> None:
        self.k, self.mu, self.effort = k, mu, effort
        self.least, self.near = Exact(2) ** -effort.stopped, Exact(2) ** -effort.near
        x, y, self.approach = velocity
        speed = sqrt(x * x + y * y)
        zero = Exact(0)
        # a slip that is little beside the approach still has a direction, which its impulse takes
        self.size = min(abs(self.approach), speed)
        self.states = [[x / speed, y / speed, speed, self.approach, zero, zero, zero, zero, zero]]
        self.series: list[list[list[Number]]] = []
        self.steps: list[Number] = []
        self.stopped = False

    def piece(self, index: int) -> bool:
        """Whether there is a step of that number: the slip may have stopped before."""
        while len(self.series) <= index and not self.stopped:
            state = self.states[-1]
            if state[G] <= self.least * self.size:
                self.stopped = True
                break
            if len(self.series) >= MOST_STEPS:
                raise ArithmeticError("too long a path")
            series, step = self._straight(state) or self._curved(state)
            made = [value(one, step) for one in series]
            # the direction keeps its length
            length = sqrt(made[C] * made[C] + made[S] * made[S])
            made[C], made[S] = made[C] / length, made[S] / length
            self.series.append(series)
            self.steps.append(step)
            self.states.append(made)
        return len(self.series) > index

    def _curved(self, state: list[Number]) -> "tuple[list[list[Number]], Number]":
        series = self._series(state)
        return series, self._reach(series)

    def _straight(self, state: list[Number]) -> "tuple[list[list[Number]], Number] | None":
        """The series in the normal impulse of a slip that keeps its direction, to where it stops; else nothing.

        It keeps the direction to which it turns from both sides. Where K is nearly singular it turns there at once, and
        the curved series would have to take steps as short for as long as the slip lasts.
        """
        (k11, k12, k13), (_, k22, k23), (_, _, k33) = self.k
        mu, (c, s, speed, v, p, fx, fy, w, h) = self.mu, state
        turn = k23 * c - k13 * s - mu * (k12 * (c * c - s * s) + (k22 - k11) * c * s)
        back = k23 * s + k13 * c + mu * ((k22 - k11) * (c * c - s * s) - 4 * k12 * c * s)
        if not back > 0 or abs(turn) > back * self.near:
            return None
        c, s = c - s * turn / back, s + c * turn / back
        growth = k13 * c + k23 * s - mu * (k11 * c * c + 2 * k12 * c * s + k22 * s * s)
        slope = k33 - mu * (k13 * c + k23 * s)
        # no impact lasts longer where it does not stop
        step = -speed / growth if growth < 0 else 1000 * (abs(v) + abs(self.approach)) / abs(slope)
        return [
            [c], [s], [speed, growth], [v, slope], [p, Exact(1)], [fx, -mu * c], [fy, -mu * s],
            [w, v, slope / 2], [h, mu * speed, mu * growth / 2],
        ], step  # fmt: skip

    def _series(self, state: list[Number]) -> list[list[Number]]:
        """Taylor coefficients in τ of direction, speed, normal velocity, impulses, work and heat."""
        (k11, k12, k13), (_, k22, k23), (_, _, k33) = self.k
        mu = self.mu
        unit = self.unit
        made = [[number] for number in state]
        c, s, g, v, p, fx, fy, w, h = made
        gc, gs = [g[0] * c[0]], [g[0] * s[0]]
        turn: list[Number] = []
        grow: list[Number] = []
        apart = k22 - k11
        for n in range(self.effort.order):
            back = slice(n, None, -1)
            cc, cs = sum(map(mul, c, c[back])), sum(map(mul, c, s[back]))
            ss = (1 if n == 0 else 0) - cc
            turn.append(k23 * c[n] - k13 * s[n] - mu * (k12 * (cc - ss) + apart * cs))
            grow.append(k13 * c[n] + k23 * s[n] - mu * (k11 * cc + 2 * k12 * cs + k22 * ss))
            over = unit / (n + 1)
            c.append(-sum(map(mul, s, turn[::-1])) * over)
            s.append(sum(map(mul, c, turn[::-1])) * over)
            v.append((k33 * g[n] - mu * (k13 * gc[n] + k23 * gs[n])) * over)
            p.append(g[n] * over)
            fx.append(-mu * gc[n] * over)
            fy.append(-mu * gs[n] * over)
            w.append(sum(map(mul, v, g[back])) * over)
            h.append(mu * sum(map(mul, g, g[back])) * over)
            g.append(sum(map(mul, g, grow[::-1])) * over)
            gc.append(sum(map(mul, g, c[n + 1 :: -1])))
            gs.append(sum(map(mul, g, s[n + 1 :: -1])))
        return made

    @property
    def unit(self) -> Number:
        """Of τ, so that no coefficient leaves the range."""
        return 1 / ((1 + self.mu) * max(self.k[0][0], self.k[1][1], self.k[2][2]))

    def _reach(self, series: list[list[Number]]) -> Number:
        """A share of the radius of convergence, and no farther than what an impact can last."""
        speed, closing = series[G][0], abs(series[V][0])
        radius = 1000 * (1 + closing / speed)
        # work and heat, of products, need smaller steps than what they are products of
        scales = {C: 1, S: 1, G: speed, W: (speed + closing) * speed * self.unit, H: speed * speed * self.unit}
        for order in (self.effort.order - 1, self.effort.order):
            last = max(abs(series[place][order]) / scale for place, scale in scales.items())
            if last > 0:
                radius = min(radius, power(-log(last) / order))
        return radius * STRIDE


class End:
    """Impulses in the frame of the contact and heat at the end of an impact, and what came before it."""

    def __init__(self, impulse: tuple[Number, ...], compression: Number, heat: Number, slip: Number) -> None:
        self.impulse = impulse
        self.compression = compression
        self.heat = heat
        # normal impulse until the first slip stopped, or all of it
        self.slip = slip


def end(path: Path, e: Number, law: str) -> End:
    """Where a law ends the impact whose path is given."""
    index, start = 0, Exact(0)
    compression: Number = None
    work = Exact(0)
    while path.piece(index):
        series, far = path.series[index], path.steps[index]
        if compression is None:
            sought, target = V, Exact(0)
        elif law == "newton":
            sought, target = V, -e * path.approach
        elif law == "poisson":
            sought, target = P, (1 + e) * compression
        else:
            sought, target = W, (e * e - 1) * work
        place = _crossing(series[sought], target, start, far, path.effort.bits)
        if place is None:
            index, start = index + 1, Exact(0)
            continue
        if compression is not None or e == 0:
            at = [value(one, place) for one in series]
            return End((at[FX], at[FY], at[P]), at[P] if compression is None else compression, at[H], at[P])
        compression, work, start = value(series[P], place), -value(series[W], place), place
    return from_rest(path.k, path.mu, path.states[-1], path.approach, compression, work, e, law)


def _crossing(series: list[Number], target: Number, start: Number, far: Number, bits: int) -> Number | None:
    """Where a series first rises to its target within a step, or nothing: by halves, then by Newton's method."""
    places = [start + (far - start) * part / PIECES for part in range(PIECES + 1)]
    values = [value(series, place) - target for place in places]
    for (low, high), (_, after) in zip(pairwise(places), pairwise(values), strict=True):
        if after < 0:
            continue
        return _root(series, target, low, high, bits)
    return None


def _root(series: list[Number], target: Number, low: Number, high: Number, bits: int) -> Number:
    """Newton's method, kept between a place below the target and one above it."""
    slopes = [index * coefficient for index, coefficient in enumerate(series)][1:]
    place = high
    for _ in range(400):
        short = value(series, place) - target
        if short >= 0:
            high = place
        else:
            low = place
        slope = value(slopes, place)
        new = place - short / slope if slope > 0 else low
        if not low < new < high:
            new = (low + high) / 2
        if abs(new - place) <= high * Exact(2) ** (16 - bits):
            return new
        place = new
    raise ArithmeticError("the end is not found")


def from_rest(
    k: Matrix, mu: Number, state: list[Number], approach: Number, compression: Number, work: Number, e: Number, law: str
) -> End:
    """The end where slip has stopped: friction holds, or is used up along the one way out."""
    (k11, k12, k13), (_, k22, k23), (_, _, k33) = k
    det = k11 * k22 - k12 * k12
    c = (k12 * k23 - k22 * k13) / det, (k12 * k13 - k11 * k23) / det
    growth = Exact(0)
    if c[0] * c[0] + c[1] * c[1] > mu * mu:
        x, y, growth = way_out(k, mu) if mu else (Exact(1), Exact(0), Exact(0))
        c = -mu * x, -mu * y
    slope = k33 + k13 * c[0] + k23 * c[1]
    begin, speed, done, more = state[P], state[V], state[W], Exact(0)
    if compression is None:
        more = -speed / slope
        compression, work, done, speed = begin + more, more * speed / 2 - done, done + more * speed / 2, Exact(0)
        work = -done
    if law == "newton":
        rest = (-e * approach - speed) / slope
    elif law == "poisson":
        rest = (1 + e) * compression - begin - more
    else:
        left = e * e * work - (done + work)
        rest = (sqrt(speed * speed + 2 * slope * left) - speed) / slope
    more = more + rest
    heat = state[H] + mu * growth * more * more / 2
    return End((state[FX] + c[0] * more, state[FY] + c[1] * more, begin + more), compression, heat, begin)


def way_out(k: Matrix, mu: Number) -> tuple[Number, Number, Number]:
    """Direction ŝ and growth g > 0 of slip from rest: k_tn = (g + μ K_tt) ŝ, by Newton's method on |ŝ(g)| = 1.

    With K_tt turned to its axes ŝ = (a/(g + μ λ), b/(g + μ λ')); the sum of squares falls with g and is convex.
    """
    (k11, k12, k13), (_, k22, k23), _ = k
    half, mean = (k11 - k22) / 2, (k11 + k22) / 2
    apart = sqrt(half * half + k12 * k12)
    high, low = mu * (mean + apart), mu * (mean - apart)
    # the axis of the greater eigenvalue, from the column that does not vanish
    x, y = (half + apart, k12) if half > 0 else (k12, apart - half)
    size = sqrt(x * x + y * y)
    x, y = (x / size, y / size) if size > 0 else (Exact(1), Exact(0))
    a, b = x * k13 + y * k23, x * k23 - y * k13
    g = Exact(0)
    for _ in range(300):
        s, t = a / (g + high), b / (g + low)
        short = s * s + t * t - 1
        step = short / (2 * (s * s / (g + high) + t * t / (g + low)))
        g = g + step
        if abs(step) <= abs(g) * Exact(2) ** -100:
            break
    s, t = a / (g + high), b / (g + low)
    return s * x - t * y, s * y + t * x, g


def smooth(k: Matrix, velocity: list[Number], e: Number) -> End:
    """Without friction: one impulse along the normal, whatever the law."""
    compression = -velocity[2] / k[2][2]
    whole = (1 + e) * compression
    return End((Exact(0), Exact(0), whole), compression, Exact(0), whole)


def whole(k: Matrix, velocity: list[Number], mu: Number, effort: Effort = SEARCH) -> "Path | list[Number]":
    """The path; of a contact that does not slip at first, the state that it rests in."""
    if velocity[0] == 0 and velocity[1] == 0:
        return [Exact(1), Exact(0), Exact(0), velocity[2], *[Exact(0)] * 5]
    return Path(k, velocity, mu, effort)


def ended(found: "Path | list[Number]", k: Matrix, mu: Number, velocity: list[Number], e: Number, law: str) -> End:
    """The end by one law of what `whole` gave."""
    if isinstance(found, Path):
        return end(found, e, law)
    return from_rest(k, mu, found, velocity[2], None, Exact(0), e, law)


def reference(k: Any, velocity: Any, mu: Any, e: Any, law: str, effort: Effort = REFERENCE) -> End:
    """The end of an impact to forty digits; each number a double, a decimal, or text of digits."""
    with precision(effort.bits):
        rows, u = [[Exact(entry) for entry in row] for row in k], [Exact(entry) for entry in velocity]
        friction, restitution = Exact(mu), Exact(e)
        if not friction:
            return smooth(rows, u, restitution)
        return ended(whole(rows, u, friction, effort), rows, friction, u, restitution, law)
