"""Equilibria that linear terms do not decide: what terms of higher order, or an area that is kept, say of them."""

import math

from dynamics_cli.stability.equilibria.multiple import distinct

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from dynamics_cli.stability.equilibria.rates import Point, Rates

# Terms of a single state, and along the direction of a root at zero, are looked at up to this order.
ORDER = 8
# A term is zero below the first share of the largest. Equilibria that coincide are found to a fraction of the digits,
# which leaves lower terms behind: between the shares it is open whether a term is that.
NOTHING, REMAINDER = 1e-12, 1e-4
ROUNDING = 1e-15
CLOSE = "undecided: equilibria coincide, or nearly so"
# The divergence is taken at so many places; a trace below that share of the slopes is taken for zero.
PLACES, NO_TRACE = 60, 1e-12
# A Lyapunov coefficient below that share of the terms it is made of is taken for zero.
NO_COEFFICIENT = 1e-9
NTH = ("", "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth")
CENTRE = "stable centre: the area of states is kept"


def of_one_state(rates: "Rates", at: float, reach: float, multiplicity: int) -> "str | None":
    """The verdict on one state by the first term that is not zero, where that is not the linear one."""
    rate = rates.along((at,), (1.0,), ORDER)[0]
    parts = [abs(part) * reach**k for k, part in enumerate(rate)]
    order = next((k for k in range(multiplicity, ORDER + 1) if parts[k] > NOTHING * max(parts[1:])), 0)
    if order < 2:
        return None
    if order % 2 == 0:
        return f"unstable on one side, degenerate: by the term of order {order}"
    return f"{'stable' if rate[order] < 0.0 else 'unstable'} equilibrium, degenerate: by the term of order {order}"


def keeps_area(rates: "Rates", ranges: "Sequence[tuple[float, float]]") -> bool:
    """Whether two states flow without divergence: then a quantity is conserved, with an extremum at a centre."""
    for k in range(1, PLACES + 1):
        # places spread evenly by multiples of irrational numbers
        place = tuple(
            low + (high - low) * (k * step % 1.0)
            for (low, high), step in zip(ranges, (0.7548776662466927, 0.5698402909980532), strict=True)
        )
        (a, _), (_, d) = rates.jacobian(place)
        if math.isfinite(a) and math.isfinite(d) and abs(a + d) > NO_TRACE * max(abs(a), abs(d)):
            return False
    return True


def critical_root(
    rates: "Rates", place: "Point", slopes: "list[list[float]]", reach: float
) -> "tuple[Point, str | None]":
    """A simple root at zero, all else on the left: the place with all its digits, and the verdict.

    Along the direction of that root the first term of the reduced rate decides, as for one state.
    """
    curve, rate = _reduced(rates, place, slopes)

    def taylor(at: float, order: int) -> "list[float]":
        near = abs(at) < reach
        return [_shifted(rate, at, k) if near else math.nan for k in range(order + 1)]

    ((at, multiplicity),) = distinct(taylor, (0.0,), reach)
    exact = tuple(_shifted(row, at, 0) for row in curve)
    parts = taylor(at, ORDER)
    sizes = [abs(part) * reach**k for k, part in enumerate(parts)]
    order = next((k for k in range(multiplicity, ORDER + 1) if sizes[k] > NOTHING * max(sizes[1:])), 0)
    if not order:
        return place, None
    if order == 1 or sizes[order] < REMAINDER * max(sizes[order:]):
        return place, CLOSE
    words = "unstable on one side" if order % 2 == 0 else "stable" if parts[order] < 0.0 else "unstable"
    return exact, f"{words}, by terms of {NTH[order]} order"


def _reduced(rates: "Rates", place: "Point", slopes: "list[list[float]]") -> "tuple[list[list[float]], list[float]]":
    """Terms of the curve along which only the direction of a root at zero is left, and of the rate on it.

    Equation
    --------
    A·q = 0, Aᵀ·p = 0, ⟨p, q⟩ = 1: f(x(u)) = g(u)·q with x = x₀ + u·q + w(u), ⟨p, w⟩ = 0, order by order
    (Liapunov–Schmidt); u̇ = g(u) but for terms above the first.
    """
    import numpy as np

    system = np.array(slopes)
    left, _, right = np.linalg.svd(system)
    p, q = left[:, -1], right[-1]
    p = p / (p @ q)
    bordered = np.block([[system, -q[:, None]], [p[None, :], np.zeros((1, 1))]])
    terms = np.zeros((ORDER + 1, len(place)))
    terms[0], terms[1] = place, q
    rate = np.zeros(ORDER + 1)
    for order in range(ORDER + 1):
        beside = np.array([parts[order] for parts in rates.on(terms.T.tolist())])
        *step, rate[order] = np.linalg.solve(bordered, [*-beside, 0.0])
        terms[order] += step
    return terms.T.tolist(), rate.tolist()


def _shifted(parts: "Sequence[float]", at: float, order: int) -> float:
    """A Taylor coefficient about another place."""
    return sum(math.comb(k, order) * parts[k] * at ** (k - order) for k in range(order, len(parts)))


def weak_focus(rates: "Rates", place: "Point", slopes: "list[list[float]]") -> "str | None":
    """The verdict on a simple pair on the axis, all else on the left, by the first Lyapunov coefficient.

    Equation
    --------
    A·q = iω·q, Aᵀ·p = −iω·p, ⟨p, q⟩ = 1, B and C the second and third derivatives of the rates:
    ℓ = Re(⟨p, C(q, q, q̄)⟩ − 2⟨p, B(q, A⁻¹·B(q, q̄))⟩ + ⟨p, B(q̄, (2iω − A)⁻¹·B(q, q))⟩)/2ω;
    the motion spirals in where ℓ < 0. Nothing is returned where ℓ is zero.

    References
    ----------
    The first Lyapunov coefficient of the Hopf bifurcation; its sign is checked by integrated motions.
    """
    import numpy as np

    system = np.array(slopes)
    values, vectors = np.linalg.eig(system)
    number = int(np.argmax(values.imag - 1e3 * abs(values.real)))
    rate, q = values[number].imag, vectors[:, number]
    left_values, left_vectors = np.linalg.eig(system.T)
    p = left_vectors[:, int(np.argmin(abs(left_values + 1j * rate)))]
    p = p / np.conj(np.vdot(p, q))

    second, third = _derivatives(rates, place)
    both, alike = second(q, q.conj()), second(q, q)
    terms = (
        np.vdot(p, third(q.real, q.imag)),
        -2.0 * np.vdot(p, second(q, np.linalg.solve(system, both))),
        np.vdot(p, second(q.conj(), np.linalg.solve(2j * rate * np.eye(len(system)) - system, alike))),
    )
    coefficient = sum(terms).real
    if abs(coefficient) <= NO_COEFFICIENT * sum(map(abs, terms)):
        return None
    return f"{'stable' if coefficient < 0.0 else 'unstable'} focus, by terms of third order"


def _derivatives(rates: "Rates", place: "Point") -> "tuple[Callable[..., Any], Callable[..., Any]]":
    """The second derivatives as B(u, v), and the third ones as C(q, q, q̄) of the parts of q, by directions."""
    import numpy as np

    def along(direction: "Any", order: int) -> "Any":
        rows = rates.along(place, tuple(map(float, direction)), order)
        return math.factorial(order) * np.array([row[order] for row in rows])

    def real_second(u: "Any", v: "Any") -> "Any":
        return (along(u + v, 2) - along(u - v, 2)) / 4.0

    def second(u: "Any", v: "Any") -> "Any":
        real = real_second(u.real, v.real) - real_second(u.imag, v.imag)
        return real + 1j * (real_second(u.real, v.imag) + real_second(u.imag, v.real))

    def third(a: "Any", b: "Any") -> "Any":
        aaa, bbb, plus, minus = along(a, 3), along(b, 3), along(a + b, 3), along(a - b, 3)
        abb, aab = (plus + minus - 2.0 * aaa) / 6.0, (plus - minus - 2.0 * bbb) / 6.0
        return aaa + abb + 1j * (aab + bbb)

    return second, third
