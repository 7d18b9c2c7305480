"""Further ways beside those of `alternatives/impact/space`."""

from dynamics_cli.accuracy.alternatives.impact.space import CHOSEN, Contact, integrated, taylor
from dynamics_cli.accuracy.alternatives.march import own
from dynamics_cli.accuracy.cases import Case
from peers.impact.march import scipy

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    Vector = tuple[float, float, float]
    State = list[float]


MOST_STEPS = 100_000


def _euler(c: Contact, y: "State", step: float) -> "State":
    return [a + step * b for a, b in zip(y, c.rates(y), strict=True)]


def _rk4(c: Contact, y: "State", step: float) -> "State":
    a = c.rates(y)
    b = c.rates([v + 0.5 * step * r for v, r in zip(y, a, strict=True)])
    d = c.rates([v + 0.5 * step * r for v, r in zip(y, b, strict=True)])
    e = c.rates([v + step * r for v, r in zip(y, d, strict=True)])
    return [v + step / 6.0 * (p + 2.0 * q + 2.0 * r + s) for v, p, q, r, s in zip(y, a, b, d, e, strict=True)]


def steps(advance: "Callable[[Contact, State, float], State]", count: int) -> "Callable[[Case], Callable[[], Vector]]":
    """Equal steps of normal impulse, so many to the compression without friction; ends by secants within a step."""

    def prepare(case: Case) -> "Callable[[], Vector]":
        c = Contact.of(case)

        def answer() -> "Vector":
            y: State = [*c.u, 0.0, 0.0, 0.0, 0.0]
            step = -c.u[2] / c.k[2][2] / count
            compression = done = 0.0
            for _ in range(MOST_STEPS):
                new = advance(c, y, step)
                if c.aim(new, compression, done) < 0.0:
                    y = new
                    continue
                y = _within(c, advance, y, step, compression, done)
                if compression or c.e == 0.0:
                    return y[3], y[4], y[5]
                compression, done = y[5], -y[6]
            raise ArithmeticError

        return answer

    return prepare


def _within(
    c: Contact, advance: "Callable[[Contact, State, float], State]", y: "State", step: float, compression: float,
    done: float,
) -> "State":  # fmt: skip
    """The state where the aim is reached, within a step."""
    low, high = 0.0, step
    below, above = c.aim(y, compression, done), c.aim(advance(c, y, step), compression, done)
    new = y
    for _ in range(60):
        part = low + (high - low) * min(max(below / (below - above), 0.05), 0.95) if below != above else high
        new = advance(c, y, part)
        here = c.aim(new, compression, done)
        if here < 0.0:
            low, below = part, here
        else:
            high, above = part, here
        if high - low <= 1e-15 * step or here == 0.0:
            break
    return new


order_16, order_10 = taylor(16, CHOSEN[1]), taylor(10, CHOSEN[1])
long_strides = taylor(24, 0.5)
coarse_steps = integrated(own(1e-6))
rk4_40, rk4_10, by_euler = steps(_rk4, 40), steps(_rk4, 10), steps(_euler, 1000)
by_scipy = integrated(scipy("DOP853", 1e-12))
