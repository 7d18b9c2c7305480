"""Gains at which a pair of roots of a closed loop has a wanted damping ratio."""

import math

from dynamics_cli.errors import require
from dynamics_cli.quantities import AngularRate, Annotated, Gain, GrowthRate, Ratio, Text
from dynamics_cli.records import record
from dynamics_cli.stability.counting import count, verdict

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

NEWTON = 4
# A root of the polynomial of the ray is real if its imaginary part is below this share of it.
REAL = 1e-6
# Gains this small beside the terms that they are made of are zero.
NOTHING = 1e-12


@record
class Design:
    """A gain at which a pair of roots has the damping ratio."""

    gain: Annotated[Gain, "The gain [-]."]
    natural: Annotated[AngularRate, "Natural frequency of the pair ω₀ [rad/s]."]
    real: Annotated[GrowthRate, "Its real part [1/s]."]
    imaginary: Annotated[AngularRate, "Its imaginary part [rad/s]."]
    verdict: Annotated[Text, "Whether the loop is stable there, all roots taken together."]


def designs(family: "Sequence[Sequence[int]]", zeta: float) -> "tuple[Design, ...]":
    """The positive gains K at which p + K·q, coefficients from the constant up, has a pair with damping ratio ζ.

    On the ray s = ω·e^{iφ} with cos φ = −ζ, K = −p/q is real where Im(p·q̄) = 0, a polynomial in ω.
    """
    import numpy as np

    require(0.0 < zeta < 1.0, "a pair of roots has a damping ratio between 0 and 1, not {zeta}", zeta=(zeta, Ratio),
            code="damping-ratio", hint="for example 0.5")  # fmt: skip
    require(len(family) == 2, "the gain stands in higher powers: gains for a damping ratio are not looked for",
            code="gain-degree", hint="write the loop with K to the first power")  # fmt: skip
    p, q = family
    phi = math.acos(-zeta)
    across = np.zeros(len(p) + len(q) - 1)
    for j, a in enumerate(p):
        for k, b in enumerate(q):
            across[j + k] += float(a) * float(b) * math.sin((j - k) * phi)
    across = np.trim_zeros(across)
    rays: Any = np.polynomial.Polynomial(across)
    slope = rays.deriv()
    turn = complex(-zeta, math.sin(phi))
    rows = []
    for root in map(complex, rays.roots()):
        if root.real <= 0.0 or abs(root.imag) > REAL * abs(root):
            continue
        omega = root.real
        for _ in range(NEWTON):
            omega -= float(rays(omega) / slope(omega)) if slope(omega) else 0.0
        s = omega * turn
        over, under = (np.polynomial.polynomial.polyval(s, [float(c) for c in each]) for each in (p, q))
        sizes = np.polynomial.polynomial.polyval(omega, [abs(float(c)) for c in p])
        if under == 0.0 or abs(over) <= NOTHING * sizes:
            continue
        gain = float((-over / under).real)
        if gain > 0.0:
            rows.append(Design(gain, omega, s.real, s.imag, _verdict(p, q, gain)))
    require(bool(rows), "at no positive gain does a pair of roots have a damping ratio of {zeta}", zeta=(zeta, Ratio),
            code="no-design", hint="give another damping ratio")  # fmt: skip
    return tuple(sorted(rows, key=lambda row: row.gain))


def _verdict(p: "Sequence[int]", q: "Sequence[int]", gain: float) -> str:
    """That of the loop at a gain, from exact counts."""
    from dynamics_cli.numerics.exact.whole_polynomials import plus, trimmed

    top, bottom = gain.as_integer_ratio()
    return verdict(count(trimmed(plus(plus((), p, bottom), q, top))))
