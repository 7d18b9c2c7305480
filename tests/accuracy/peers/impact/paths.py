"""The path of a planar impact by steps of its impulse, by integrators with events, and by a spring."""

from math import copysign, sqrt, tanh

from dynamics_cli.accuracy.cases import Case
from peers.impact.march import own, scipy

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from peers.impact.march import March, State

MOST_STEPS = 200_000


# A spring that has not thrown the bodies apart after so many is taken for a jam.
MOST_OF_SPRING = 20_000


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


def integrated(march: "March") -> "Callable[[Case], Callable[[], tuple[float, float]]]":
    """The path integrated in normal impulse."""

    def prepare(case: Case) -> "Callable[[], tuple[float, float]]":
        c = Contact.of(case)
        return lambda: integral(c, march)

    return prepare


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


def steps(count: int) -> "Callable[[Case], Callable[[], tuple[float, float]]]":
    """Equal steps of normal impulse, so many to the compression without friction; slip may stop after each."""

    def prepare(case: Case) -> "Callable[[], tuple[float, float]]":
        c = Contact.of(case)

        def answer() -> "tuple[float, float]":
            step = -c.un / c.kn / count
            pn = pt = work = compression = done = 0.0
            ut, un = c.ut, c.un
            for _ in range(MOST_STEPS):
                ratio = c.ratio(ut)
                before, old = ut, un
                ut, un = ut + (c.kx + c.kt * ratio) * step, un + (c.kn + c.kx * ratio) * step
                if before * ut < 0.0:
                    ut = 0.0
                pn, pt, work = pn + step, pt + ratio * step, work + 0.5 * (old + un) * step
                if not compression and un >= 0.0:
                    compression, done = pn, -work
                if compression and _over(c, un, pn, work, compression, done):
                    return pn, pt
            raise ArithmeticError

        return answer

    return prepare


def _over(c: Contact, un: float, pn: float, work: float, compression: float, done: float) -> bool:
    if c.law == "newton":
        return un >= -c.e * c.un
    if c.law == "poisson":
        return pn >= (1.0 + c.e) * compression
    return work >= (c.e * c.e - 1.0) * done


def spring(count: int) -> "Callable[[Case], Callable[[], tuple[float, float]]]":
    """A spring, stiffer by 1/e² when it opens, and smoothed friction, in so many steps of RK4: Stronge's law."""

    def prepare(case: Case) -> "Callable[[], tuple[float, float]]":
        c = Contact.of(case)
        if c.law != "stronge" or c.e == 0.0:
            raise ArithmeticError
        # of unit stiffness: the path does not depend on it
        step = sqrt(1.0 / c.kn) / count
        smooth = 1e-3 * (abs(c.un) + abs(c.ut))

        def rates(y: "tuple[float, ...]", deepest: float) -> "tuple[float, ...]":
            ut, un, depth = y[:3]
            push = depth if not deepest else deepest + (depth - deepest) / (c.e * c.e)
            rub = -c.mu * tanh(ut / smooth) * push
            return c.kt * rub + c.kx * push, c.kx * rub + c.kn * push, -un, push, rub

        def answer() -> "tuple[float, float]":
            y: tuple[float, ...] = (c.ut, c.un, 0.0, 0.0, 0.0)
            deepest = 0.0
            for _ in range(MOST_OF_SPRING):
                a = rates(y, deepest)
                b = rates(_ahead(y, a, 0.5 * step), deepest)
                d = rates(_ahead(y, b, 0.5 * step), deepest)
                f = rates(_ahead(y, d, step), deepest)
                y = tuple(
                    v + step / 6.0 * (p + 2.0 * q + 2.0 * r + s) for v, p, q, r, s in zip(y, a, b, d, f, strict=True)
                )
                if not deepest and y[1] >= 0.0:
                    deepest = y[2]
                if deepest and y[2] <= deepest * (1.0 - c.e * c.e):
                    return y[3], y[4]
            raise ArithmeticError

        return answer

    return prepare


def _ahead(y: "tuple[float, ...]", slope: "tuple[float, ...]", step: float) -> "tuple[float, ...]":
    return tuple(value + step * rate for value, rate in zip(y, slope, strict=True))


hundred_steps, thousand_steps, by_spring = steps(100), steps(1000), spring(200)
by_dormand_prince = integrated(own(1e-12))
by_scipy = integrated(scipy("RK45", 1e-12))
