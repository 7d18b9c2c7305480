"""Duration and peak force of an impact whose contact has a stiffness: a spring, or Hertz's law.

Loading follows F = k δ^(q−1), q = 2 for a spring and 5/2 for Hertz; unloading falls from the peak force by the same
power of a smaller deflection, such that it returns the work of restitution. Time is ∫ dδ/|u_n| along the path.
"""

from dynamics_cli.errors import worded
from dynamics_cli.impact.planar.laws import ON_THE_PATH, Meeting
from dynamics_cli.impact.planar.path import travel
from dynamics_cli.numerics.elementary import atan2, exp, log, sqrt
from dynamics_cli.numerics.number import single
from dynamics_cli.quantities import Annotated, Distance, Pressure, Stiffness
from dynamics_cli.records import Advice, record

HALF_PI = 1.5707963267948966
# ∫₀¹ dx/√(1 − x^(5/2)) = √π Γ(2/5)/(5/2 · Γ(9/10))
HERTZ_QUARTER = 1.4716375921623523
NODES = 28


@record
class Spring:
    """A contact by a constant stiffness."""

    contact_stiffness: Annotated[Stiffness, "Normal force per deflection of the contact, e.g. 60 kN/m [N/m]."]


@record
class Hertz:
    """A contact of two spheres or a sphere and a plane, by Hertz's law."""

    contact_radius: Annotated[Distance, "Effective radius of curvature, 1/R = 1/R₁ + 1/R₂, e.g. 20 mm [m]."]
    contact_modulus: Annotated[Pressure, "Effective modulus, 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, e.g. 2 GPa [Pa]."]


def contact_history(force: Spring | Hertz | None, m: Meeting, law: str) -> tuple[float | None, float | None]:
    """Duration and peak force; None without a stiffness, or of a law that knows no path."""
    if force is None or law not in ON_THE_PATH:
        return None, None
    path = travel(m.mobility, m.slip, m.approach, m.friction, m.restitution, law)
    k, c1, c2 = m.mobility, *path.slopes
    first = path.first_slip
    numbers = (
        m.approach, path.compression_work, path.restitution_work, path.normal_after, first, path.compression,
        path.ended_first, k.normal + k.coupling * c1, k.normal + k.coupling * c2, _stiffness(force),
    )  # fmt: skip
    hertz = isinstance(force, Hertz)
    if single(*numbers):
        return _history(hertz, *numbers)
    import numpy as np

    columns = np.broadcast_arrays(*numbers)
    rows = [_history(hertz, *row) for row in zip(*(column.tolist() for column in columns), strict=True)]
    table = np.array(rows)
    return table[:, 0], table[:, 1]  # type: ignore[return-value]


def force_advice(force: Spring | Hertz | None, duration: float | None, law: str) -> tuple[Advice, ...]:
    """Advice when a law has no path along which a force could grow and fall."""
    if force is None or duration is not None:
        return ()
    text = worded("the law {law} gives impulses only, not their history: no duration and no peak force", law=law)
    return tuple(Advice("no-path", text, "note", "--law stronge", result=name) for name in ("duration", "peak_force"))


def _stiffness(force: Spring | Hertz) -> float:
    if isinstance(force, Spring):
        return force.contact_stiffness
    return (4.0 / 3.0) * force.contact_modulus * sqrt(force.contact_radius)


def _history(
    hertz: bool,
    approach: float,
    work: float,
    back: float,
    after: float,
    first: float,
    compression: float,
    ended: bool,
    slope: float,
    later: float,
    stiffness: float,
) -> tuple[float, float]:
    """Duration and peak force of one case."""
    from dynamics_cli.errors import require

    require(stiffness > 0.0, "a contact without stiffness has no duration", code="no-stiffness")
    power = 2.5 if hertz else 2.0
    peak = exp(0.4 * log(stiffness) + 0.6 * log(2.5 * work)) if hertz else sqrt(2.0 * stiffness * work)
    quarter = HERTZ_QUARTER if hertz else HALF_PI
    deep = power * work / peak
    turned = approach + slope * first
    inside = ended or compression <= first
    if inside:
        time = _pace(deep, slope, work) * quarter
    else:
        time = _pace(deep, later, work) * _rest(hertz, later * first and turned * turned / (2.0 * later), work)
        if first > 0.0:
            work_done = -0.5 * (approach + turned) * first
            time = time + _before(hertz, deep, work, approach, slope, turned, work_done)
    if not back > 0.0:
        return time, peak
    shallow = power * back / peak
    if ended or not inside:
        return time + _pace(shallow, slope if ended else later, back) * quarter, peak
    regained = turned * turned / (2.0 * slope)
    if regained > 0.0:
        time = time + _pace(shallow, slope, back) * _rest(hertz, regained, back)
    return time + _before(hertz, shallow, back, -after, later, turned, back - regained), peak


def _pace(deflection: float, slope: float, work: float) -> float:
    """Deflection over the speed that the whole work gives."""
    return deflection / sqrt(2.0 * slope * work)


def _rest(hertz: bool, left: float, work: float) -> float:
    """∫ dx/√(1 − x^q) from where the work `left` is still to be done to the turning point x = 1."""
    if not left < work:
        return HERTZ_QUARTER if hertz else HALF_PI
    if not hertz:
        return atan2(sqrt(left), sqrt(work - left)) if left > 0.0 else 0.0 * work
    return HERTZ_QUARTER - _hertz_integral(_fifth_root((work - left) / work))


def _before(
    hertz: bool, deflection: float, work: float, speed: float, slope: float, turned: float, work_done: float
) -> float:
    """Time from no force, at `speed`, until the work `work_done` has been done on a path of constant `slope`."""
    if not work_done > 0.0:
        return 0.0 * work
    if slope > 0.0:
        limit = speed * speed / (2.0 * slope)
        if not hertz:
            stretch = deflection * sqrt(limit / work)
            return stretch / abs(speed) * atan2(sqrt(work_done), abs(turned) / sqrt(2.0 * slope))
        stretch = deflection * exp(0.4 * log(limit / work))
        ratio = work_done / limit
        reach = _fifth_root(ratio) if ratio < 1.0 else 1.0 + 0.0 * ratio
        return stretch / abs(speed) * _hertz_integral(reach)
    ratio = work_done / work
    top = _fifth_root(ratio) if hertz else sqrt(sqrt(ratio))
    total = 0.0 * ratio
    from dynamics_cli.numerics.quadrature.gauss import legendre

    for node, weight in legendre(NODES):
        z = top * node
        fourth = z * z * z * z
        square = speed * speed - 2.0 * slope * work * (fourth * z if hertz else fourth)
        total = total + weight * (2.0 * z / sqrt(square))
    return deflection * top * total


def _fifth_root(x: float) -> float:
    """The fifth root z, whose square is x^(2/5)."""
    return exp(0.2 * log(x))


def _hertz_integral(reach: float) -> float:
    """∫₀^z 2z dz/√(1 − z⁵): with z = 1 − s² the end z = 1 is regular, and Gauss converges as 2⁻²ᴺ."""
    from dynamics_cli.numerics.quadrature.gauss import legendre

    gap = 1.0 - reach
    if not gap > 0.0:
        return HERTZ_QUARTER + 0.0 * reach
    low = sqrt(gap)
    span = 1.0 - low
    total = 0.0 * reach
    for node, weight in legendre(NODES):
        s = low + span * node
        z = 1.0 - s * s
        # (1 − z⁵)/(1 − z) as a sum
        ratio = 1.0 + z * (1.0 + z * (1.0 + z * (1.0 + z)))
        total = total + weight * (4.0 * z / sqrt(ratio))
    return span * total
