"""The path of a planar impact: closed form by cases, beside steps, an integrator, a spring and textbooks' two cases."""

from math import copysign

from dynamics_cli.accuracy.alternatives.march import own
from dynamics_cli.accuracy.alternatives.shares import Way, compared
from dynamics_cli.accuracy.cases import Case

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.alternatives.march import March, State
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row

FILE = "impact_rigid.json"
NAMES = ("normal", "tangential")
# What the closed form promises, in shares of the impulse.
PROMISE = 2e-15


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


def closed_form(case: Case) -> "Callable[[], tuple[float, float]]":
    """The program's own."""
    from dynamics_cli.impact.planar.path import Mobility, determinant, travel

    c = Contact.of(case)

    def answer() -> "tuple[float, float]":
        k = Mobility(c.kt, c.kx, c.kn, determinant(c.kt, c.kx, c.kn))
        path = travel(k, c.ut, c.un, c.mu, c.e, c.law)
        return path.normal, path.tangential

    return answer


def plain_sums(case: Case) -> "Callable[[], tuple[float, float]]":
    """The program's own for whole maps, in plain sums; here one at a time."""
    from dynamics_cli.impact.planar.path_arrays import planar_impacts

    c = Contact.of(case)

    def answer() -> "tuple[float, float]":
        pn, pt = planar_impacts(c.kt, c.kx, c.kn, c.ut, c.un, c.mu, c.e, law=c.law)
        return float(pn), float(pt)

    return answer


def plain_arrays(case: Case, rows: int) -> "Callable[[], Any]":
    """So many of one contact, each with a friction of its own."""
    import numpy as np

    from dynamics_cli.impact.planar.path_arrays import planar_impacts

    c = Contact.of(case)
    kt, kx, kn, ut, un = (np.full(rows, value) for value in (c.kt, c.kx, c.kn, c.ut, c.un))
    friction = np.linspace(0.0, 1.0, rows)
    return lambda: planar_impacts(kt, kx, kn, ut, un, friction, c.e, law=c.law)


def two_cases(case: Case) -> "Callable[[], tuple[float, float]]":
    """The textbook: it slides to the end, or else it sticks at the end; slip that turns round is not thought of."""
    c = Contact.of(case)

    def answer() -> "tuple[float, float]":
        ratio, rise = c.ratio(c.ut), -(1.0 + c.e) * c.un
        slope = c.kn + c.kx * ratio
        if slope > 0.0:
            pn = rise / slope
            if c.ut * (c.ut + (c.kx + c.kt * ratio) * pn) >= 0.0:
                return pn, ratio * pn
        det = c.kt * c.kn - c.kx * c.kx
        return (c.kt * rise + c.kx * c.ut) / det, (-c.kn * c.ut - c.kx * rise) / det

    return answer


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


WAYS = (
    Way("closed form by cases (chosen)", closed_form, lambda _: PROMISE),
    Way("the same in plain sums, for maps", plain_sums, many=plain_arrays),
    Way("slides or sticks, as in textbooks", two_cases),
    Way("Dormand–Prince 5(4) to 1e-12, events by Brent", integrated(own(1e-12))),
)


def compare(comparing: "Comparing") -> "list[Row]":
    """Normal and tangential impulse by every method."""
    return compared(comparing, comparing.cases(FILE, task="path"), WAYS, NAMES)
