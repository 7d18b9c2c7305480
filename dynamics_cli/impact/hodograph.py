"""Keller's equations of an impact with friction in space, marched by Taylor series to the end or until slip stops.

While the contact slips, dp_t = −μ (u_t/|u_t|) dp_n. In the variable τ with dp_n = |u_t| dτ the equations are
u_t' = −μ K_tt u_t + k_tn |u_t|: regular where the slip nearly stops and turns at once, and where the normal velocity is
not monotone (a contact that jams), so that neither step by impulse nor step by normal velocity would do.
"""

from math import exp, log, sqrt

from dynamics_cli.impact.straight import End, P, Slip, V, W, X, Y, end_of, from_rest, glide, settled

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
        way = settled(k, friction, slip)
        if way is not None:
            glide(k, slip, way, friction, start[2], restitution, law)
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
                if slip.restoring:
                    return slip
                slip.compressed()
                if restitution == 0.0:
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
            return end_of(slip, "slip")
    return from_rest(k, slip, start[2], friction, restitution, law, at_rest)
