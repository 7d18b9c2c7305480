"""Keller's equations of an impact in space: Taylor series in τ, beside other orders, DOP853, RK4 and Euler by impulse.

By normal impulse the slip's direction is singular where the slip stops, so the rivals stop it below a share of the
start and go on straight, as the program does.
"""

from math import hypot

from dynamics_cli.accuracy.cases import Case, load
from dynamics_cli.accuracy.rivals.impact_shares import Rival, compared

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.rows import Row

    Vector = tuple[float, float, float]
    State = list[float]

FILE = "impact_spatial.json"
NAMES = ("impulse[0]", "impulse[1]", "impulse[2]")
# Slip below this share of the speeds at the start has stopped, for those that march by impulse.
STOPPED = 1e-9
MOST_STEPS = 100_000


class Contact:
    """K, velocity, friction and restitution of a case, and the law that ends it."""

    def __init__(self, case: Case) -> None:
        given = case.inputs
        rows = tuple(tuple(map(float, row)) for row in given["mobility"])
        self.k: Any = rows
        self.u: Vector = tuple(map(float, given["velocity"]))  # type: ignore[assignment]
        self.mu, self.e = float(given["friction"]), float(given["restitution"])
        self.law: str = given["law"]["word"]
        self.least = STOPPED * max(hypot(self.u[0], self.u[1]), -self.u[2])

    def held(self, slip: float) -> bool:
        """Whether the slip has stopped."""
        return slip <= self.least

    def ratio(self, x: float, y: float) -> "tuple[float, float]":
        """Friction per normal impulse: against the slip, and once it has stopped what holds it or the one way out."""
        from dynamics_cli.impact.straight import stick_ratio, way_out

        slip = hypot(x, y)
        if not self.held(slip):
            return -self.mu * x / slip, -self.mu * y / slip
        hold = stick_ratio(self.k)
        if hypot(*hold) <= self.mu:
            return hold
        out = way_out(self.k, self.mu)
        return -self.mu * out[0], -self.mu * out[1]

    def rates(self, y: "State") -> "State":
        """d/dp_n of u_1, u_2, u_n, p_1, p_2, p_n, normal work."""
        a, b = self.ratio(y[0], y[1])
        u = [row[0] * a + row[1] * b + row[2] for row in self.k]
        return [*u, a, b, 1.0, y[2]]

    def aim(self, state: "State", compression: float, done: float) -> float:
        """What is negative until compression is over, and then until the law's end."""
        if not compression:
            return state[2]
        if self.law == "newton":
            return state[2] + self.e * self.u[2]
        if self.law == "poisson":
            return state[5] - (1.0 + self.e) * compression
        return state[6] + (1.0 - self.e * self.e) * done


def taylor(order: int, stride: float) -> "Callable[[Case], Callable[[], Vector]]":
    """The program's own, of this order and with steps of this share of the radius of convergence."""

    def prepare(case: Case) -> "Callable[[], Vector]":
        from dynamics_cli.impact.hodograph import travel

        c = Contact(case)
        return lambda: travel(c.k, c.u, c.mu, c.e, c.law, order, stride).impulse

    return prepare


def decimals(case: Case) -> "Callable[[], Vector]":
    """The program's own, in the decimals that its answers are rounded from."""
    from decimal import Context, localcontext

    from dynamics_cli.impact.decimals import widened
    from dynamics_cli.impact.spatial import followed
    from dynamics_cli.impact.spatial_bounds import EFFORTS

    c = Contact(case)
    k, u, mu, e, law = widened((c.k, c.u, c.mu, c.e, c.law))
    order, digits, most = EFFORTS[0]

    def answer() -> "Vector":
        with localcontext(Context(prec=most)):
            x, y, z = followed(k, u, mu, e, law, order=order, digits=digits).impulse
            return float(x), float(y), float(z)

    return answer


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
        c = Contact(case)

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


def dop853(tolerance: float) -> "Callable[[Case], Callable[[], Vector]]":
    """Scipy's solve_ivp by normal impulse, with events where slip has stopped, compression ends and the law ends it."""

    def prepare(case: Case) -> "Callable[[], Vector]":
        c = Contact(case)

        def answer() -> "Vector":
            from scipy.integrate import solve_ivp

            y: State = [*c.u, 0.0, 0.0, 0.0, 0.0]
            compression = done = 0.0
            longest = 1e3 * (-c.u[2] + hypot(c.u[0], c.u[1])) / min(c.k[0][0], c.k[1][1], c.k[2][2])
            for _ in range(4):
                straight = c.held(hypot(y[0], y[1]))
                fixed = c.rates([0.0, 0.0, *y[2:]]) if straight else None

                def rhs(_: float, y: "Any", fixed: "Any" = fixed) -> "State":
                    return c.rates(y) if fixed is None else [*fixed[:6], y[2]]

                def stops(_: float, y: "Any", straight: bool = straight) -> float:
                    return 1.0 if straight else float(hypot(y[0], y[1]) - c.least)

                def ends(_: float, y: "Any", compression: float = compression, done: float = done) -> float:
                    return float(c.aim(y, compression, done))

                stops.terminal = ends.terminal = True  # type: ignore[attr-defined]
                ends.direction = 1.0  # type: ignore[attr-defined]
                found = solve_ivp(
                    rhs, [0.0, longest], y, method="DOP853", events=[stops, ends], rtol=tolerance,
                    atol=1e-3 * tolerance * -c.u[2],
                )  # fmt: skip
                if found.status != 1:
                    raise ArithmeticError
                y = [float(value) for value in found.y[:, -1]]
                if len(found.t_events[0]):
                    y[0] = y[1] = 0.0
                if len(found.t_events[1]):
                    if compression or c.e == 0.0:
                        return y[3], y[4], y[5]
                    compression, done = y[5], -y[6]
            raise ArithmeticError

        return answer

    return prepare


CHOSEN = 24, 0.1353352832366127
# Half a last bit of the largest part.
ROUNDED = 1.0001 * 2.0**-53
RIVALS = (
    Rival("Taylor in decimals, rounded once (chosen)", decimals, lambda _: ROUNDED),
    Rival("Taylor of order 24", taylor(*CHOSEN)),
    Rival("Taylor of order 16", taylor(16, CHOSEN[1])),
    Rival("Taylor of order 10", taylor(10, CHOSEN[1])),
    Rival("Taylor of order 24, strides of half the radius", taylor(24, 0.5)),
    Rival("scipy DOP853, 1e-12", dop853(1e-12), needs="scipy"),
    Rival("scipy DOP853, 1e-6", dop853(1e-6), needs="scipy"),
    Rival("RK4, 40 steps", steps(_rk4, 40)),
    Rival("RK4, 10 steps", steps(_rk4, 10)),
    Rival("Euler, 1,000 steps", steps(_euler, 1000)),
)


def compare(name: str, *, hard: bool, full: bool, timed: bool, peers: "tuple[str, ...]" = ()) -> "list[Row]":
    """The impulse by every method; Euler, which takes seconds, in the full report alone."""
    cases = [case for case in load(FILE) if case.task == "keller" and (case.hard or not hard)]
    rivals = RIVALS if full else RIVALS[:-1]
    return compared(name, cases, rivals, NAMES, full=full, timed=timed, peers=peers)
