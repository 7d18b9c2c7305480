"""The path of an impact by its impulse: the program's own beside the textbook's two cases.

Errors are shares of the whole impulse.
"""

from decimal import Decimal
from math import copysign, hypot, inf, isfinite

from dynamics_cli.accuracy.measure import DIGITS, Errors

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row

    Parts = tuple[float, ...]
    Call = Callable[[], Parts]

PLANE, SPACE = ("normal", "tangential"), ("impulse[0]", "impulse[1]", "impulse[2]")
# What the closed form promises, in shares of the impulse, and half a last bit of the largest part.
PROMISE, ROUNDED = 2e-15, 1.0001 * 2.0**-53
# The order of the series in space, and its steps in shares of the radius of convergence.
ORDER, STRIDE = 24, 0.1353352832366127


def contact_of(case: "Case") -> "tuple[float, ...]":
    """K as tangential, coupling, normal; slip, approach, friction and restitution."""
    names = ("tangential", "coupling", "normal", "slip", "approach", "friction", "restitution")
    return tuple(float(case.inputs[name]) for name in names)


def closed_form(case: "Case") -> "Call":
    """The program's own."""
    from dynamics_cli.impact.planar.path import Mobility, determinant, travel

    kt, kx, kn, ut, un, mu, e = contact_of(case)

    def answer() -> "Parts":
        path = travel(Mobility(kt, kx, kn, determinant(kt, kx, kn)), ut, un, mu, e, case.inputs["law"]["word"])
        return path.normal, path.tangential

    return answer


def two_cases(case: "Case") -> "Call":
    """The textbook: it slides to the end, or else it sticks at the end; slip that turns round is not thought of."""
    kt, kx, kn, ut, un, mu, e = contact_of(case)

    def answer() -> "Parts":
        ratio = -copysign(mu, ut) if ut else -min(max(kx / kt, -mu), mu)
        rise, slope = -(1.0 + e) * un, kn + kx * ratio
        if slope > 0.0 and ut * (ut + (kx + kt * ratio) * rise / slope) >= 0.0:
            return rise / slope, ratio * rise / slope
        det = kt * kn - kx * kx
        return (kt * rise + kx * ut) / det, (-kn * ut - kx * rise) / det

    return answer


def in_space(case: "Case") -> "tuple[Any, ...]":
    """K, velocity, friction, restitution and the law."""
    given = case.inputs
    k, u = tuple(tuple(map(float, row)) for row in given["mobility"]), tuple(map(float, given["velocity"]))
    return k, u, float(given["friction"]), float(given["restitution"]), given["law"]["word"]


def taylor(case: "Case", order: int = ORDER, stride: float = STRIDE) -> "Call":
    """The program's own series in doubles, of this order and with steps of this share of the radius of convergence."""
    from dynamics_cli.impact.spatial.hodograph import travel

    k, u, mu, e, law = in_space(case)
    return lambda: travel(k, u, mu, e, law, order, stride).impulse


def decimals(case: "Case") -> "Call":
    """The program's own, in the decimals that its answers are rounded from."""
    from decimal import Context, localcontext

    from dynamics_cli.impact.spatial.arithmetic import widened
    from dynamics_cli.impact.spatial.bounds import EFFORTS
    from dynamics_cli.impact.spatial.impact import followed

    k, u, mu, e, law = widened(in_space(case))
    order, digits, most = EFFORTS[0]

    def answer() -> "Parts":
        with localcontext(Context(prec=most)):
            x, y, z = followed(k, u, mu, e, law, order=order, digits=digits).impulse
            return float(x), float(y), float(z)

    return answer


def as_it_starts(case: "Case") -> "Call":
    """The textbook: friction against the slip as it was at the start, or no slip at the end."""
    import numpy as np

    k, u, mu, e, _ = in_space(case)

    def answer() -> "Parts":
        slip, rise = hypot(u[0], u[1]), -(1.0 + e) * u[2]
        way = np.array([-mu * u[0] / slip, -mu * u[1] / slip, 1.0]) if slip else np.array([0.0, 0.0, 1.0])
        parts = rise / (np.array(k[2]) @ way) * way
        if not slip or (np.array(u) + np.array(k) @ parts)[:2] @ np.array(u[:2]) < 0.0:
            parts = np.linalg.solve(np.array(k), np.array([-u[0], -u[1], rise]))
        return tuple(parts.tolist())

    return answer


def share(case: "Case", parts: "Parts", names: "Sequence[str]") -> float:
    """The largest error of the parts, over the size of the impulse."""
    exact = [Decimal(case.results[name]) for name in names]
    size = DIGITS.sqrt(sum((DIGITS.multiply(part, part) for part in exact), Decimal(0)))
    if not all(map(isfinite, parts)):
        return inf
    worst = max(abs(DIGITS.subtract(Decimal(part), true)) for part, true in zip(parts, exact, strict=True))
    return float(DIGITS.divide(worst, size))


def _compared(
    comparing: "Comparing", cases: "list[Case]", ways: "Sequence[tuple[str, Any]]", names: "Sequence[str]", bound: float
) -> "list[Row]":
    def answer(errors: "Errors", case: "Case", prepare: "Any", index: int) -> "Call":
        call: Call = prepare(case)
        error = share(case, call(), names)
        if error == inf:
            raise ArithmeticError
        errors.note(case.name, error, bound if prepare is ways[0][1] else None)
        errors.by_result[f"{index} impulse"] = error
        return call

    return comparing.rows(ways, cases, answer, most=4, repeats=3, shared=True)


def compare(comparing: "Comparing") -> "list[Row]":
    """Normal and tangential impulse in the plane."""
    ways = (
        ("closed form by cases (chosen)", closed_form),
        ("slides or sticks, as in textbooks", two_cases),
    )
    return _compared(comparing, comparing.cases("impact_rigid.json", task="path"), ways, PLANE, PROMISE)


def compare_in_space(comparing: "Comparing") -> "list[Row]":
    """Keller's equations of an impact in space."""
    ways = (
        ("Taylor in decimals, rounded once (chosen)", decimals),
        ("slides or sticks, as in textbooks", as_it_starts),
        ("Taylor of order 24, in doubles", taylor),
    )
    return _compared(comparing, comparing.cases("impact_spatial.json", task="keller"), ways, SPACE, ROUNDED)
