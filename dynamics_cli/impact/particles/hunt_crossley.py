"""Hunt and Crossley's contact, F = k δ^1.5 (1 + c δ̇), with the loss that gives a required restitution.

With δ in (m u²/k)^(2/5) and velocity in u only x = c u remains, and v dv/dδ = −δ^1.5 (1 + x v). Every number of the
contact is then a function of the restitution alone.
"""

import math

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import only_in_doubles
from dynamics_cli.numerics.number import is_array, is_tracked
from dynamics_cli.numerics.quadrature.gauss import legendre
from dynamics_cli.numerics.roots import halved
from dynamics_cli.quantities import (
    Annotated,
    Distance,
    Pressure,
    Restitution,
)
from dynamics_cli.records import record
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

# Below this the release takes ever longer: the bodies hardly separate.
LEAST_RESTITUTION = 0.1
PANELS, NODES = 12, 28
# Relative error of quadrature and root.
WRONG = 1e-13


@record
class HuntCrossley:
    """A contact by Hertz's stiffness with Hunt and Crossley's loss."""

    contact_radius: Annotated[Distance, "Effective radius of curvature, 1/R = 1/R₁ + 1/R₂, e.g. 20 mm [m]."]
    contact_modulus: Annotated[Pressure, "Effective modulus, 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, e.g. 2 GPa [Pa]."]
    hunt_crossley: Annotated[bool, "Use the loss of Hunt and Crossley, which the restitution determines."]


def shape(restitution: float) -> tuple[float, float, float]:
    """Duration, peak force and depth in units of D/u, k D^1.5 and D = (m u²/k)^(2/5), of one case or an array."""
    require(
        (restitution >= LEAST_RESTITUTION) & (restitution <= 1.0),
        "Hunt and Crossley's contact takes restitutions from 0.1 to 1, not {restitution:6}",
        restitution=(restitution, Restitution),
        code="restitution",
        hint="leave --hunt-crossley out: Hertz's contact takes any restitution up to 1",
    )
    return _shapes(restitution)  # type: ignore[no-any-return]


def _shapes(restitution: "Any") -> "Any":
    """The shape of a number, an array or a tracked number, whose slopes are differences."""
    if is_array(restitution) and restitution.ndim:
        import numpy as np

        if drawing():
            return _sampled(restitution)
        rows = np.array([_shape(e) for e in restitution.ravel().tolist()])
        columns = [rows[:, i].reshape(restitution.shape) for i in range(3)]
        return columns[0], columns[1], columns[2]
    only_in_doubles(restitution)
    plain = float(getattr(restitution, "value", restitution))
    values = _shape(plain)
    if not is_tracked(restitution):
        return values
    step = min(1e-4, 0.25 * (plain - LEAST_RESTITUTION) + 1e-6, 0.25 * (1.0 - plain) + 1e-6)
    low, high = _shape(max(plain - step, LEAST_RESTITUTION)), _shape(min(plain + step, 1.0))
    width = min(plain + step, 1.0) - max(plain - step, LEAST_RESTITUTION)
    tracked = []
    for value, before, after in zip(values, low, high, strict=True):
        slope = (after - before) / width
        error = WRONG * value + abs(slope) * restitution.error
        tracked.append(type(restitution)(value, error, tuple(slope * part for part in restitution.slopes)))
    return tracked[0], tracked[1], tracked[2]


_POLYNOMIALS: "list[Any]" = []
# Chebyshev's polynomials of this degree are within 1e-12 of the three numbers of the contact.
DEGREE = 40


def _sampled(restitution: "Any") -> "Any":
    """The shapes of a sample by polynomials: a single exact one takes a millisecond."""
    import numpy as np
    from numpy.polynomial import chebyshev

    middle, reach = 0.5 * (1.0 + LEAST_RESTITUTION), 0.5 * (1.0 - LEAST_RESTITUTION)
    if not _POLYNOMIALS:
        nodes = np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
        rows = np.array([_shape(middle + reach * node) for node in nodes.tolist()])
        _POLYNOMIALS.extend(chebyshev.chebfit(nodes, rows[:, i], DEGREE) for i in range(3))
    place = (np.asarray(restitution) - middle) / reach
    return tuple(chebyshev.chebval(place, coefficients) for coefficients in _POLYNOMIALS)


def _phi(t: float) -> float:
    """(t − ln(1 + t))/t²."""
    if abs(t) < 0.02:
        return sum((-t) ** k / (k + 2) for k in range(12))
    return (t - math.log1p(t)) / (t * t)


def loss(e: float) -> float:
    """X = c u of a restitution: the work of compression, φ(x), is e² φ(−e x) times that of release."""
    if e == 1.0:
        return 0.0
    return halved(lambda x: _phi(x) > e * e * _phi(-e * x), 0.0, (1.0 - 1e-15) / e)[0]


def _work(v: float, x: float, span: float) -> float:
    """∫ w/(1 + x w) dw from v to v + span, over the span."""
    if span == 0.0:
        return v / (1.0 + x * v)
    if x < 0.5:
        return sum(weight * w / (1.0 + x * w) for w, weight in ((v + span * z, g) for z, g in legendre(NODES)))
    return (1.0 - math.log1p(x * span / (1.0 + x * v)) / (x * span)) / x


def _shape(e: float) -> tuple[float, float, float]:
    """The three numbers of one restitution."""
    x = loss(e)
    depth = (2.5 * _phi(x)) ** 0.4

    def going_in(gap: float) -> float:
        # gap = 1 − v = s^2.5, so that the start without force is regular
        v = 1.0 - gap
        rise: float = (2.5 * _work(v, x, gap)) ** 0.6
        return 2.5 / (rise * (1.0 + x * v))

    def coming_out(gap: float) -> float:
        v = -e + gap
        rise: float = (-2.5 * _work(-e, x, gap)) ** 0.6
        return 2.5 / (rise * (1.0 + x * v))

    time = _integral(going_in, 1.0) + _integral(coming_out, e)
    # the force peaks where 1.5 v = x δ^2.5
    top, _ = halved(lambda v: 1.5 * v < 2.5 * x * (1.0 - v) * _work(v, x, 1.0 - v), 0.0, 1.0)
    peak = (2.5 * (1.0 - top) * _work(top, x, 1.0 - top)) ** 0.6 * (1.0 + x * top)
    return time, peak, depth


def _integral(function: "Callable[[float], float]", reach: float) -> float:
    """∫ f(s^2.5) ds from 0 to reach^0.4, on panels that shrink towards zero."""
    top = reach**0.4
    edges = [0.0, *(top * 0.5**k for k in range(PANELS, -1, -1))]
    total = 0.0
    for index in range(len(edges) - 1):
        left, span = edges[index], edges[index + 1] - edges[index]
        total += span * sum(weight * function((left + span * z) ** 2.5) for z, weight in legendre(NODES))
    return total
