"""Keller's equations of an impact with friction in space, marched by Taylor series to the end or until slip stops.

While the contact slips, dp_t = −μ (u_t/|u_t|) dp_n. In the variable τ with dp_n = |u_t| dτ the equations are
u_t' = −μ K_tt u_t + k_tn |u_t|: regular where the slip nearly stops and turns at once, and where the normal velocity is
not monotone (a contact that jams), so that neither step by impulse nor step by normal velocity would do.
"""

from math import exp, log, sqrt

TYPE_CHECKING = False
if TYPE_CHECKING:
    Vector = tuple[float, float, float]
    Matrix = tuple[Vector, Vector, Vector]
    Series = list[list[float]]

ORDER = 24
# Jorba and Zou (2005): with this share of the radius of convergence a series of this order keeps all digits.
STRIDE = exp(-2.0)
MOST_STEPS = 5000
# Slip this much smaller than that which one impact makes has stopped.
STOPPED = 1e-17
# u_t, u_n, p_n, p_t, normal work, heat of friction
X, Y, V, P, FX, FY, W, H = range(8)


class Slip:
    """The state while the contact slips, and what is known of the end."""

    __slots__ = ("compression", "restoring", "state", "steps", "stopped", "turn", "work")

    def __init__(self, state: "list[float]") -> None:
        self.state = state
        self.steps = 0
        self.stopped = False
        self.compression: float | None = None
        self.work = 0.0
        self.restoring = False
        self.turn = 0.0


def series(k: "Matrix", friction: float, start: "list[float]", order: int) -> "Series":
    """Taylor coefficients of the state in τ."""
    (k11, k12, k13), (_, k22, k23), (_, _, k33) = k
    x, y, v, p, fx, fy, w, h = ([value] for value in start)
    s = [sqrt(x[0] * x[0] + y[0] * y[0])]
    double = 0.5 / s[0]
    # τ in units of its own, so that no coefficient leaves the range
    unit = 1.0 / ((1.0 + friction) * max(k11, k22, k33))
    for i in range(order):
        scale = unit / (i + 1)
        xi, yi, si = x[i], y[i], s[i]
        x.append((k13 * si - friction * (k11 * xi + k12 * yi)) * scale)
        y.append((k23 * si - friction * (k12 * xi + k22 * yi)) * scale)
        v.append((k33 * si - friction * (k13 * xi + k23 * yi)) * scale)
        p.append(si * scale)
        fx.append(-friction * xi * scale)
        fy.append(-friction * yi * scale)
        w.append(sum([a * b for a, b in zip(v, s[i::-1], strict=False)]) * scale)
        h.append(friction * sum([a * b for a, b in zip(s, s[i::-1], strict=False)]) * scale)
        square = sum([a * b for a, b in zip(x, x[::-1], strict=True)])
        square += sum([a * b for a, b in zip(y, y[::-1], strict=True)])
        known = sum([a * b for a, b in zip(s[1:], s[:0:-1], strict=True)])
        s.append((square - known) * double)
    return [x, y, v, p, fx, fy, w, h]


def reach(coefficients: "Series", order: int, stride: float) -> float:
    """How far the series may go."""
    x, y = coefficients[X], coefficients[Y]
    size = max(abs(x[0]), abs(y[0]))
    # where the slip hardly changes, no farther than compression and restitution can last
    radius = 1e3 * (1.0 + abs(coefficients[V][0]) / size)
    for index in (order - 1, order):
        last = max(abs(x[index]), abs(y[index]))
        if last > 0.0:
            radius = min(radius, exp(log(size / last) / index))
    return radius * stride


def value(coefficients: "list[float]", step: float) -> float:
    """The series at `step`."""
    total = 0.0
    for coefficient in reversed(coefficients):
        total = total * step + coefficient
    return total


def crossing(coefficients: "list[float]", target: float, low: float, high: float) -> float:
    """Where a rising series reaches `target`, between two steps: Newton's method kept within the bracket."""
    step = 0.5 * (low + high)
    slopes = [index * coefficient for index, coefficient in enumerate(coefficients)][1:]
    for _ in range(200):
        short = value(coefficients, step) - target
        if short > 0.0:
            high = step
        else:
            low = step
        slope = value(slopes, step)
        new = step - short / slope if slope > 0.0 else low
        if not low < new < high:
            new = 0.5 * (low + high)
        if abs(new - step) <= 1e-17 * high or new in (low, high):
            return new
        step = new
    return step


def march(
    k: "Matrix",
    start: "Vector",
    friction: float,
    restitution: float,
    law: str,
    order: int = ORDER,
    stride: float = STRIDE,
) -> Slip:
    """Slip from the velocity `start` (u_1, u_2, u_n) until the law ends the impact or the slip stops."""
    slip = Slip([*start, 0.0, 0.0, 0.0, 0.0, 0.0])
    # unit of slip: what the impact itself can make
    unit = max(abs(start[2]), sqrt(start[0] * start[0] + start[1] * start[1]))
    while slip.steps < MOST_STEPS:
        state = slip.state
        if sqrt(state[X] * state[X] + state[Y] * state[Y]) <= STOPPED * unit:
            slip.stopped = True
            return slip
        coefficients = series(k, friction, state, order)
        step = reach(coefficients, order, stride)
        slip.steps += 1
        index, target = _aim(slip, start[2], restitution, law)
        # where the aim is passed, within the step
        pieces = [step * part for part in (0.25, 0.5, 0.75, 1.0)]
        low = 0.0
        for high in pieces:
            if value(coefficients[index], high) >= target:
                step = crossing(coefficients[index], target, low, high)
                slip.state = [value(series_, step) for series_ in coefficients]
                slip.state[index] = target
                if slip.restoring or _ends(slip, restitution):
                    return slip
                break
            low = high
        else:
            slip.state = [value(series_, step) for series_ in coefficients]
    raise ArithmeticError("the slip did not end")


def _aim(slip: Slip, approach: float, restitution: float, law: str) -> "tuple[int, float]":
    """Which quantity is to reach what: the end of compression, then that of the law."""
    if not slip.restoring:
        return V, 0.0
    if law == "newton":
        return V, -restitution * approach
    if law == "poisson":
        return P, (1.0 + restitution) * slip.compression  # type: ignore[operator]
    return W, (restitution * restitution - 1.0) * slip.work


def _ends(slip: Slip, restitution: float) -> bool:
    """The end of compression; whether it is the end of all."""
    slip.compression = slip.state[P]
    slip.work = -slip.state[W]
    slip.restoring = True
    return restitution == 0.0


def stick_ratio(k: "Matrix") -> "tuple[float, float]":
    """Friction per normal impulse that keeps the contact from slipping, −K_tt⁻¹ k_tn."""
    (k11, k12, k13), (_, k22, k23), _ = k
    det = k11 * k22 - k12 * k12
    return (k12 * k23 - k22 * k13) / det, (k12 * k13 - k11 * k23) / det


def way_out(k: "Matrix", friction: float) -> "tuple[float, float]":
    """Direction in which slip starts from rest where friction cannot hold: −μ K_tt ŝ + k_tn = g ŝ with g > 0.

    (g + μ K_tt) ŝ = k_tn with |ŝ| = 1: the size of (g + μ K_tt)⁻¹ k_tn falls with g, so there is one such g.
    """
    (k11, k12, k13), (_, k22, k23), _ = k

    def direction(growth: float) -> "tuple[float, float]":
        a, b, d = growth + friction * k11, friction * k12, growth + friction * k22
        det = a * d - b * b
        return (d * k13 - b * k23) / det, (a * k23 - b * k13) / det

    low, high = 0.0, sqrt(k13 * k13 + k23 * k23)
    for _ in range(200):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        x, y = direction(middle)
        if x * x + y * y > 1.0:
            low = middle
        else:
            high = middle
    x, y = direction(0.5 * (low + high))
    size = sqrt(x * x + y * y)
    return x / size, y / size


class End:
    """How an impact in space ended, in the frame of the contact."""

    __slots__ = ("compression", "heat", "history", "impulse", "slip_impulse", "steps", "velocity", "work", "work_back")

    def __init__(
        self,
        velocity: "Vector",
        impulse: "Vector",
        compression: float,
        work: float,
        work_back: float,
        heat: float,
        history: str,
        slip_impulse: float,
        steps: int = 0,
    ) -> None:
        self.velocity = velocity
        self.impulse = impulse
        self.compression = compression
        self.work = work
        self.work_back = work_back
        self.heat = heat
        self.history = history
        self.slip_impulse = slip_impulse
        self.steps = steps


def _end_of(slip: Slip, history: str) -> End:
    state = slip.state
    return End(
        velocity=(state[X], state[Y], state[V]),
        impulse=(state[FX], state[FY], state[P]),
        compression=slip.compression or 0.0,
        work=slip.work,
        work_back=state[W] + slip.work,
        heat=state[H],
        history=history,
        slip_impulse=state[P],
        steps=slip.steps,
    )


def travel(
    k: "Matrix",
    start: "Vector",
    friction: float,
    restitution: float,
    law: str,
    order: int = ORDER,
    stride: float = STRIDE,
) -> End:
    """The whole impact: curved slip, and after it stick or slip along the way out, both linear in the impulse."""
    # without friction nothing depends on how it slips
    at_rest = friction == 0.0 or (start[0] == 0.0 and start[1] == 0.0)
    if at_rest:
        slip = Slip([*start, 0.0, 0.0, 0.0, 0.0, 0.0])
    else:
        slip = march(k, start, friction, restitution, law, order, stride)
        if not slip.stopped:
            return _end_of(slip, "slip")
    return _straight(k, slip, start[2], friction, restitution, law, at_rest)


def _straight(
    k: "Matrix", slip: Slip, approach: float, friction: float, restitution: float, law: str, at_rest: bool
) -> End:
    """After the slip has stopped: p_t = c p_n with a constant c."""
    (_, _, k13), (_, _, k23), (_, _, k33) = k
    state = slip.state
    ratio = stick_ratio(k)
    sticks = ratio[0] * ratio[0] + ratio[1] * ratio[1] <= friction * friction
    growth = 0.0, 0.0
    if not sticks:
        out = way_out(k, friction)
        ratio = -friction * out[0], -friction * out[1]
        growth = tuple(row[0] * ratio[0] + row[1] * ratio[1] + row[2] for row in k[:2])  # type: ignore[assignment]
    slope = k33 + k13 * ratio[0] + k23 * ratio[1]
    begin = state[P]
    words = ("slip from rest", "stick") if at_rest else ("slip, slip anew", "slip, stick")
    end = _end_of(slip, words[sticks] if friction > 0.0 else "slip without friction")
    more, speed = 0.0, state[V]
    if not slip.restoring:
        more = -speed / slope
        end.compression = begin + more
        end.work = -state[W] + 0.5 * more * -speed
        end.work_back = 0.0
        speed = 0.0
    rest, after = _restitution(end, speed, slope, begin + more, approach, restitution, law)
    more += rest
    end.work_back += 0.5 * (speed + after) * rest
    end.heat += 0.5 * friction * more * more * sqrt(growth[0] * growth[0] + growth[1] * growth[1])
    before = (state[X], state[Y]) if at_rest else (0.0, 0.0)
    end.velocity = before[0] + growth[0] * more, before[1] + growth[1] * more, after
    end.impulse = state[FX] + ratio[0] * more, state[FY] + ratio[1] * more, begin + more
    end.slip_impulse = begin if friction > 0.0 else begin + more
    return end


def _restitution(
    end: End, speed: float, slope: float, impulse: float, approach: float, restitution: float, law: str
) -> "tuple[float, float]":
    """Impulse still to come in restitution, and the normal velocity at its end."""
    if law == "newton":
        after = -restitution * approach
        return (after - speed) / slope, after
    if law == "poisson":
        rest = (1.0 + restitution) * end.compression - impulse
        return rest, speed + slope * rest
    left = max(restitution * restitution * end.work - end.work_back, 0.0)
    after = sqrt(speed * speed + 2.0 * slope * left)
    return (2.0 * left / (speed + after) if after > 0.0 else 0.0), after
