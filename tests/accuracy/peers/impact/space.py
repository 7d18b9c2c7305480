"""Keller's equations of an impact in space, by an integrator with events.

By normal impulse the slip's direction is singular where the slip stops, so it is stopped below a share of the
start and goes on straight, as the program does.
"""

from math import hypot

from dynamics_cli.accuracy.cases import Case

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from peers.impact.march import March

    Vector = tuple[float, float, float]
    State = list[float]


# Slip below this share of the speeds at the start has stopped, for those that march by impulse.
STOPPED = 1e-9
# Where the slip's direction turns ever faster an integrator's steps shrink; this many slopes are a second's work.
MOST_SLOPES = 30_000


class Contact:
    """K, velocity, friction and restitution of a contact, and the law that ends it."""

    def __init__(self, k: "Any", u: "Vector", mu: float, e: float, law: str) -> None:
        self.k = k
        self.u = u
        self.mu, self.e, self.law = mu, e, law
        self.least = STOPPED * max(hypot(u[0], u[1]), -u[2])

    @classmethod
    def of(cls, case: Case) -> "Contact":
        """That of a case."""
        given = case.inputs
        rows = tuple(tuple(map(float, row)) for row in given["mobility"])
        u: Vector = tuple(map(float, given["velocity"]))  # type: ignore[assignment]
        return cls(rows, u, float(given["friction"]), float(given["restitution"]), given["law"]["word"])

    def held(self, slip: float) -> bool:
        """Whether the slip has stopped."""
        return slip <= self.least

    def ratio(self, x: float, y: float) -> "tuple[float, float]":
        """Friction per normal impulse: against the slip, and once it has stopped what holds it or the one way out."""
        from dynamics_cli.impact.spatial.straight_slip import stick_ratio, way_out

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


def integral(c: Contact, march: "March") -> "Vector":
    """The impulse, the march stopping where slip has stopped, compression ends and the law ends it."""
    y: State = [*c.u, 0.0, 0.0, 0.0, 0.0]
    compression = done = 0.0
    slopes = 0
    longest = 1e3 * (-c.u[2] + hypot(c.u[0], c.u[1])) / min(c.k[0][0], c.k[1][1], c.k[2][2])
    for _ in range(4):
        straight = c.held(hypot(y[0], y[1]))
        fixed = c.rates([0.0, 0.0, *y[2:]]) if straight else None

        def slope(_: float, y: "State", fixed: "Any" = fixed) -> "State":
            nonlocal slopes
            slopes += 1
            if slopes > MOST_SLOPES:
                raise ArithmeticError
            return c.rates(y) if fixed is None else [*fixed[:6], y[2]]

        def stops(_: float, y: "State", straight: bool = straight) -> float:
            return -1.0 if straight else c.least - hypot(y[0], y[1])

        def ends(_: float, y: "State", compression: float = compression, done: float = done) -> float:
            return c.aim(y, compression, done)

        y, (stopped, ended) = march(slope, y, [stops, ends], 1e-15 * -c.u[2], longest)
        if stopped:
            y[0] = y[1] = 0.0
        if ended:
            if compression or c.e == 0.0:
                return y[3], y[4], y[5]
            compression, done = y[5], -y[6]
    raise ArithmeticError
