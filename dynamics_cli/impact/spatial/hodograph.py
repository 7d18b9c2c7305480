"""Keller's equations of an impact with friction in space, marched by Taylor series to the end or until slip stops.

While the contact slips, dp_t = −μ (u_t/|u_t|) dp_n. In the variable τ with dp_n = |u_t| dτ the equations are
u_t' = −μ K_tt u_t + k_tn |u_t|: regular where the slip nearly stops and turns at once, and where the normal velocity is
not monotone (a contact that jams), so that steps by impulse or by normal velocity would both fail.
"""

from math import exp, log
from operator import mul

from dynamics_cli.impact.spatial.arithmetic import root
from dynamics_cli.impact.spatial.straight_slip import (
    DOUBLE,
    End,
    H,
    P,
    Slip,
    V,
    W,
    X,
    Y,
    end_of,
    from_rest,
    glide,
    settled,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    Vector = tuple[float, float, float]
    Matrix = tuple[Vector, Vector, Vector]
    Series = list[list[float]]

ORDER = 24
# Jorba and Zou (2005): with this share of the radius of convergence a series of this order keeps all digits.
STRIDE = exp(-2.0)
MOST_STEPS = 5000
# Where little slip remains: the minimum power of the step, and spare orders, each worth e².
LEAST_CARE = 0.3
SPARE = 3


def series(k: "Matrix", friction: float, start: "list[float]", order: int) -> "Series":
    """Taylor coefficients of the state in τ."""
    (k11, k12, k13), (_, k22, k23), (_, _, k33) = k
    x, y, v, p, fx, fy, w, h = ([value] for value in start)
    square = x[0] * x[0] + y[0] * y[0]
    s = [root(square)]
    double = 1 / (2 * s[0])
    # τ is scaled so that no coefficient overflows or underflows
    unit = 1 / ((1 + friction) * max(k11, k22, k33))
    rub, unity = friction * unit, type(unit)(1)
    a11, a12, a22, a13, a23 = rub * k11, rub * k12, rub * k22, rub * k13, rub * k23
    b13, b23, b33 = unit * k13, unit * k23, unit * k33
    for i in range(order):
        xi, yi, si = x[i], y[i], s[i]
        part = unity / (i + 1)
        x.append((b13 * si - a11 * xi - a12 * yi) * part)
        y.append((b23 * si - a12 * xi - a22 * yi) * part)
        rise, heat = unit * part, rub * part
        p.append(si * rise)
        fx.append(-heat * xi)
        fy.append(-heat * yi)
        w.append(sum(map(mul, v, s[::-1])) * rise)
        v.append((b33 * si - a13 * xi - a23 * yi) * part)
        h.append(square * heat)
        n = i + 1
        square = _middle(x, 0, n) + _middle(y, 0, n)
        s.append((square - _middle(s, 1, n - 1)) * double)
    return [x, y, v, p, fx, fy, w, h]


def _middle(a: "list[float]", first: int, last: int) -> float:
    """Σ a_j a_(first + last − j) from `first` to `last`, every product once."""
    count = last - first + 1
    half = count // 2
    total: float = 2 * sum(map(mul, a[first : first + half], a[last : last - half if last > half else None : -1]))
    if count % 2:
        total += a[first + half] * a[first + half]
    return total


def _log(x: float) -> float:
    """Natural logarithm, of decimals that leave the range of doubles too."""
    if not hasattr(x, "adjusted"):
        return log(x)
    digits = x.adjusted()
    return log(float(x.scaleb(-digits))) + 2.302585092994046 * digits  # type: ignore[attr-defined, no-any-return]


def reach(coefficients: "Series", order: int, stride: float) -> float:
    """How far the series may go."""
    x, y = coefficients[X], coefficients[Y]
    size = max(abs(x[0]), abs(y[0]))
    # where the slip hardly changes, no farther than compression and restitution can last
    radius = 1e3 * (1.0 + float(abs(coefficients[V][0]) / size))
    for index in (order - 1, order):
        last = max(abs(x[index]), abs(y[index]))
        if last > 0:
            radius = min(radius, exp((_log(size) - _log(last)) / index))
    # work and heat are products: where the slip dies down as an exponential, theirs converges half as far
    heat = coefficients[H]
    if heat[1] != 0 and heat[order] != 0:
        radius = min(radius, exp((_log(abs(heat[1])) - _log(abs(heat[order]))) / (order - 1)))
    return type(size)(radius * stride)


def value(coefficients: "list[float]", step: float) -> float:
    """The series at `step`."""
    total = 0 * step
    for coefficient in reversed(coefficients):
        total = total * step + coefficient
    return total


def crossing(coefficients: "list[float]", target: float, low: float, high: float, digits: int = DOUBLE) -> float:
    """Where a rising series reaches `target`, between two steps: Newton's method kept within the bracket."""
    number = type(high)
    step = (low + high) / 2
    if number is not float:
        # decimals begin where doubles end
        start = crossing(list(map(float, coefficients)), float(target), float(low), float(high))
        step = number(start) if low < start < high else step
    least = high * number(f"1e-{digits + 1}")
    slopes = [index * coefficient for index, coefficient in enumerate(coefficients)][1:]
    for _ in range(200):
        short = value(coefficients, step) - target
        if short > 0:
            high = step
        else:
            low = step
        slope = value(slopes, step)
        new = step - short / slope if slope > 0 else low
        if not low < new < high:
            new = (low + high) / 2
        if abs(new - step) <= least or new in (low, high):
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
    digits: int = DOUBLE,
) -> Slip:
    """Slip from the velocity `start` (u_1, u_2, u_n) until the law ends the impact or the slip stops."""
    zero = type(start[2])(0)
    slip = Slip([*start, zero, zero, zero, zero, zero])
    # slip this much smaller than the impact can cause counts as stopped
    size = max(abs(start[2]), root(start[0] * start[0] + start[1] * start[1]))
    stopped = size * type(size)(f"1e-{digits + (1 if digits == DOUBLE else 3)}")
    fastest = zero
    while slip.steps < MOST_STEPS:
        state = slip.state
        speed = root(state[X] * state[X] + state[Y] * state[Y])
        if speed <= stopped:
            slip.stopped = True
            return slip
        exit_direction = settled(k, friction, slip, digits)
        if exit_direction is not None:
            glide(k, slip, exit_direction, friction, start[2], restitution, law)
            return slip
        fastest = max(speed, fastest)
        coefficients = series(k, friction, state, order)
        step = reach(coefficients, order, stride ** _care(speed / fastest, order))
        slip.steps += 1
        index, target = _aim(slip, start[2], restitution, law)
        # where the target is passed, within the step
        pieces = [step * part / 4 for part in (1, 2, 3, 4)]
        low = zero
        for high in pieces:
            if value(coefficients[index], high) >= target:
                step = crossing(coefficients[index], target, low, high, digits)
                slip.state = [value(series_, step) for series_ in coefficients]
                slip.state[index] = target
                if slip.restoring:
                    return slip
                slip.compressed()
                if restitution == 0:
                    return slip
                break
            low = high
        else:
            slip.state = [value(series_, step) for series_ in coefficients]
    raise ArithmeticError("the slip did not end")


def _care(share: float, order: int) -> float:
    """Power of the step where little slip remains: its contribution needs correspondingly fewer digits."""
    return 1.0 if share == 1 else min(max((order + SPARE + _log(share) / 2) / order, LEAST_CARE), 1.0)


def _aim(slip: Slip, approach: float, restitution: float, law: str) -> "tuple[int, float]":
    """The quantity and its target: the end of compression, then the end by the law."""
    if not slip.restoring:
        return V, type(approach)(0)
    if law == "newton":
        return V, -restitution * approach
    if law == "poisson":
        return P, (1 + restitution) * slip.compression  # type: ignore[operator]
    return W, (restitution * restitution - 1) * slip.work


def travel(
    k: "Matrix",
    start: "Vector",
    friction: float,
    restitution: float,
    law: str,
    order: int = ORDER,
    stride: float = STRIDE,
    digits: int = DOUBLE,
) -> End:
    """The whole impact: curved slip, and after it stick or slip along the exit direction, both linear in the impulse.

    Takes doubles, or decimals of a few more than `digits` digits.
    """
    # without friction the slip has no effect
    at_rest = friction == 0 or (start[0] == 0 and start[1] == 0)
    if at_rest:
        zero = type(start[2])(0)
        slip = Slip([*start, zero, zero, zero, zero, zero])
    else:
        slip = march(k, start, friction, restitution, law, order, stride, digits)
        if not slip.stopped:
            return end_of(slip, "slip")
    return from_rest(k, slip, start[2], friction, restitution, law, at_rest)
