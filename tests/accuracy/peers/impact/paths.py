"""The path of a planar impact by its impulse, by an integrator with events."""

from math import copysign

from dynamics_cli.accuracy.cases import Case

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from peers.impact.march import March, State


class Contact:
    """K, velocities, friction and restitution of a contact, and the law that ends it."""

    def __init__(
        self, k: "tuple[float, float, float]", u: "tuple[float, float]", mu: float, e: float, law: str
    ) -> None:
        self.kt, self.kx, self.kn = k
        self.ut, self.un = u
        self.mu, self.e, self.law = mu, e, law

    @classmethod
    def of(cls, case: Case) -> "Contact":
        """That of a case."""
        given = case.inputs
        kt, kx, kn = (float(given[name]) for name in ("tangential", "coupling", "normal"))
        u = float(given["slip"]), float(given["approach"])
        return cls((kt, kx, kn), u, float(given["friction"]), float(given["restitution"]), given["law"]["word"])

    def ratio(self, ut: float) -> float:
        """Friction per normal impulse now, with stick where the slip is zero and friction holds."""
        if ut == 0.0:
            return -min(max(self.kx / self.kt, -self.mu), self.mu)
        return -copysign(self.mu, ut)


def integral(c: Contact, march: "March") -> "tuple[float, float]":
    """Normal and tangential impulse, the march stopping where slip stops, compression ends and the law ends it."""
    # slip, approach, tangential impulse, work and normal impulse
    y = [c.ut, c.un, 0.0, 0.0, 0.0]
    compression = done = 0.0
    longest = 1e3 * (-c.un + abs(c.ut)) / min(c.kn, c.kt)
    for _ in range(8):
        ratio = c.ratio(y[0])
        rates = c.kx + c.kt * ratio if y[0] or abs(c.kx) > c.mu * c.kt else 0.0, c.kn + c.kx * ratio

        def slope(_: float, y: "State", rates: "Any" = rates, ratio: float = ratio) -> "State":
            return [rates[0], rates[1], ratio, y[1], 1.0]

        y, (stopped, ended) = march(slope, y, _events(c, y[0], compression, done), 1e-15 * -c.un, longest)
        if stopped:
            y[0] = 0.0
        if ended:
            if compression or c.e == 0.0:
                return y[4], y[2]
            compression, done = y[4], -y[3]
    raise ArithmeticError


def _events(c: Contact, side: float, compression: float, done: float) -> "list[Callable[[float, State], float]]":
    """What rises to zero where slip stops, and where compression or, after it, the impact is over."""

    def stops(_: float, y: "State") -> float:
        return -copysign(1.0, side) * y[0] if side else -1.0

    def ends(_: float, y: "State") -> float:
        if not compression:
            return y[1]
        if c.law == "newton":
            return y[1] + c.e * c.un
        if c.law == "poisson":
            return y[4] - (1.0 + c.e) * compression
        return y[3] + (1.0 - c.e * c.e) * done

    return [stops, ends]
