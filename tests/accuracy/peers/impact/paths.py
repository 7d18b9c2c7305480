"""Further ways beside those of `alternatives/impact/paths`."""

from math import sqrt, tanh

from dynamics_cli.accuracy.alternatives.impact.paths import Contact, integrated
from dynamics_cli.accuracy.cases import Case
from peers.impact.march import scipy

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable


MOST_STEPS = 200_000


# A spring that has not thrown the bodies apart after so many is taken for a jam.
MOST_OF_SPRING = 20_000


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
by_scipy = integrated(scipy("RK45", 1e-12))
