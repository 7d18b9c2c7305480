"""The root cut by a rack: the exact start of the involute, and the trochoid below it, with or without undercut.

Everything is in modules (normal ones for a helical gear) in the transverse plane. The rounded corner of the rack is a
circle in the normal plane and an ellipse in the transverse one; one formula serves both. A point of the corner is named
by the direction θ of its transverse normal, from the transverse pressure angle at the flank to π/2 at the tip; it cuts
when that normal passes through the pitch point.
"""

from math import pi

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, atan, atan2, cos, maximum, pi_beside, sin, sqrt, tan
from dynamics_cli.numerics.number import like, over_plain
from dynamics_cli.numerics.roots import sign_change
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.quantities import Annotated, Ratio
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

# t − atan t by its series below this: terms decrease as t², and above it the difference loses no significant digit.
SERIES_LIMIT = 0.5
_TERMS = 24


def roll_less_arc(t: float) -> float:
    """The involute function of atan t, t − atan t, without cancellation."""
    if hasattr(t, "apply") and not hasattr(t, "slopes") and not hasattr(t, "dtype"):
        # numbers of more digits than the coefficients here
        return t.apply("roll_less_arc", t)  # type: ignore[no-any-return]
    if not absolute(t) < SERIES_LIMIT:
        return t - atan(t)
    square = t * t
    series = 0.0 * square + 1.0 / (2 * _TERMS + 3)
    for k in range(_TERMS - 1, -1, -1):
        series = 1.0 / (2 * k + 3) - square * series
    return t * square * series


def transverse(pressure_angle: float, helix_angle: float) -> float:
    """α_t of tan α_t = tan α_n/cos β; for a spur gear the given angle itself, without rounding (ISO 21771)."""
    if helix_angle == 0.0:
        return pressure_angle
    return atan2(sin(pressure_angle), cos(pressure_angle) * cos(helix_angle))


@record
class Cutter:
    """A rack and how it generates a gear, in normal modules."""

    teeth: Annotated[int, "Teeth of the gear."]
    pressure_angle: Annotated[float, "Normal pressure angle [rad]."]
    helix_angle: Annotated[float, "Helix angle; its sign does not matter [rad]."] = 0.0
    shift: Annotated[float, "Profile shift factor x."] = 0.0
    dedendum: Annotated[float, "Dedendum factor of the gear, h_fP*."] = 1.25
    tip_radius: Annotated[float, "Radius of the rack's corner, ρ_fP*."] = 0.38

    @property
    def stretch(self) -> float:
        """1/cos β: the widening in the transverse plane."""
        return 1.0 / cos(self.helix_angle)

    @property
    def pitch_radius(self) -> float:
        """r/m_n."""
        return 0.5 * self.teeth * self.stretch

    @property
    def transverse_angle(self) -> float:
        """The transverse pressure angle α_t."""
        return transverse(self.pressure_angle, self.helix_angle)

    @property
    def base_radius(self) -> float:
        """r_b/m_n."""
        return self.pitch_radius * cos(self.transverse_angle)

    @property
    def root_radius(self) -> float:
        """r_f/m_n."""
        return self.pitch_radius - (self.dedendum - self.shift)

    @property
    def corner_depth(self) -> float:
        """Depth of the corner's centre below the pitch line."""
        return self.dedendum - self.tip_radius - self.shift

    @property
    def corner_offset(self) -> float:
        """Transverse distance of the corner's centre from the centreline of the rack's tooth."""
        sine, cosine = sin(self.pressure_angle), cos(self.pressure_angle)
        flat = 0.25 * pi_beside(sine) - self.dedendum * sine / cosine
        return (flat - self.tip_radius * (1.0 - sine) / cosine) * self.stretch

    @property
    def form_depth(self) -> float:
        """Depth of the end of the rack's straight flank below the pitch line."""
        return self.dedendum - self.tip_radius * (1.0 - sin(self.pressure_angle)) - self.shift

    @property
    def space_half_angle(self) -> float:
        """Half the angle of the tooth space where the involutes leave the base circle."""
        t = tan(self.transverse_angle)
        across = 0.5 * pi_beside(self.shift, self.pressure_angle) - 2.0 * self.shift * tan(self.pressure_angle)
        return across / self.teeth - roll_less_arc(t)


@record
class Root:
    """Where the involute flank begins, and the trochoid that ends there, in normal modules."""

    form_radius: Annotated[float, "Radius at which involute and trochoid meet, d_Ff/(2 m_n)."]
    roll: Annotated[float, "t = √((R/r_b)² − 1) there: the roll angle of the involute."]
    undercut: Annotated[bool, "Whether the rack cuts away part of the involute."]
    direction: Annotated[float, "Direction θ of the trochoid's normal at the junction [rad]."]
    margin: Annotated[
        float,
        "ξ/m_n: how far along the line of action the rack's last straight point is from the base circle; negative "
        "with undercut, and the shift that would end it is −margin·sin α_t.",
    ]


def root(cutter: Cutter) -> Root:
    """Give the junction of involute and trochoid of a gear cut by a rack.

    `cutter`: the rack and the gear. Returns radius, roll angle, undercut or not, and the direction at which the
    trochoid begins. Raises InadmissibleError when the rack's corner does not fit its tooth, or the root would lie
    beyond the gear's centre.

    The unit of length is the normal module. The condition of R is below 1 for all inputs; within 1e-14 of 40-digit
    values for z = 5 … 1000, x = −12 … +1.

    Equation
    --------
    ξ = r sin α_t − h_F/sin α_t; ξ ≥ 0: R² = r_b² + ξ². ξ < 0: the trochoid's half angle meets the involute's, solved in
    δ = θ − α_t between its start on the involute's other branch (δ = 0) and the base circle, with every term written
    as a difference from that start, so that nothing cancels as ξ → 0.

    References
    ----------
    ISO 21771; law of gearing applied to the corner of the rack.
    """
    _require_rack(cutter)
    curve = _Corner(cutter)
    margin = curve.margin
    if margin >= 0.0:
        base = cutter.base_radius
        return Root(sqrt(base * base + margin * margin), margin / base, False, cutter.transverse_angle, margin)
    corner = _Corner(over_plain(cutter))
    place = _meeting(corner)
    # One Newton step in the numbers of the input carries their derivatives and rounding bounds through the root.
    delta = like(place, margin)
    start = Tracked.inputs([place])[0]
    slope = corner.residual(start).slopes[0]  # type: ignore[arg-type, attr-defined]
    step = curve.residual(delta) / slope
    # R along the trochoid, so that both parts take the same step
    radius = curve.radius(delta) - corner.radius(start).slopes[0] * step  # type: ignore[arg-type, attr-defined]
    delta = delta - step
    roll = sqrt(maximum(curve.roll_squared(delta), 0.0))
    return Root(radius, roll, True, cutter.transverse_angle + delta, margin)


def _require_rack(cutter: Cutter) -> None:
    require(
        cutter.corner_offset >= -1e-15,
        "a corner radius of {tip_radius:6} modules does not fit the rack's tooth",
        tip_radius=(cutter.tip_radius, Ratio),
        code="tip-radius",
        hint="it may be at most (π/4 − h_fP·tan α)·cos α/(1 − sin α)",
    )
    require(
        cutter.root_radius > 0.0,
        "the root would reach {root_radius:6} modules beyond the centre of the gear",
        root_radius=(-cutter.root_radius, Ratio),
        code="no-root",
        hint="raise the profile shift or the number of teeth",
    )


class _Corner:
    """The trochoid as differences from its start at the end of the rack's flank."""

    def __init__(self, cutter: Cutter) -> None:
        self.radius_ = cutter.pitch_radius
        self.base = cutter.base_radius
        self.angle = cutter.transverse_angle
        self.depth = cutter.corner_depth
        self.tip = cutter.tip_radius
        self.excess = cutter.stretch * cutter.stretch - 1.0
        self.sine, self.cosine = sin(self.angle), cos(self.angle)
        self.widening = sqrt(1.0 + self.excess * self.cosine * self.cosine)
        self.margin = (self.radius_ * self.sine * self.sine - cutter.form_depth) / self.sine
        self.start = roll_less_arc(-self.margin / self.base)

    def _parts(self, delta: float) -> tuple[float, float, float, float]:
        """Sine and cosine of θ, ξ(θ) − ξ(α), and the change of 1/D along the ellipse."""
        theta = self.angle + delta
        sine, cosine = sin(theta), cos(theta)
        widening = sqrt(1.0 + self.excess * cosine * cosine)
        narrowing = (
            self.excess * sin(delta) * sin(self.angle + theta) / (widening * self.widening * (widening + self.widening))
        )
        rise = 2.0 * cos(self.angle + 0.5 * delta) * sin(0.5 * delta)
        change = rise * (self.radius_ + self.depth / (sine * self.sine)) - self.tip * narrowing
        return sine, cosine, change, narrowing

    def roll_squared(self, delta: float) -> float:
        """t² = (R/r_b)² − 1."""
        _, _, change, _ = self._parts(delta)
        xi = self.margin + change
        down = self.radius_ * self.radius_ * sin(delta) * sin(2.0 * self.angle + delta)
        return (xi * xi - down) / (self.base * self.base)

    def radius(self, delta: float) -> float:
        """R."""
        _, cosine, change, _ = self._parts(delta)
        xi = self.margin + change
        across = self.radius_ * cosine
        return sqrt(across * across + xi * xi)

    def residual(self, delta: float) -> float:
        """Half angle of the trochoid less that of the involute; below the base circle the involute's is left out."""
        sine, cosine, change, narrowing = self._parts(delta)
        xi = self.margin + change
        # difference of the two arc tangents of −ξ/(r cos θ) as one
        fall = 2.0 * sin(self.angle + 0.5 * delta) * sin(0.5 * delta)
        step = -(change * self.cosine + self.margin * fall) / (self.radius_ * cosine * self.cosine)
        tangent = xi * self.margin / (self.radius_ * self.radius_ * cosine * self.cosine)
        turned = delta + atan(step / (1.0 + tangent))
        travel = -self.depth * sin(delta) / (sine * self.sine)
        bend = -fall / sqrt(1.0 + self.excess * cosine * cosine) + self.cosine * narrowing
        travel = travel - self.tip * self.excess * bend
        square = self.roll_squared(delta)
        involute_angle = roll_less_arc(sqrt(square)) if square > 0.0 else 0.0
        return turned - travel / self.radius_ - involute_angle - self.start


def _meeting(curve: _Corner) -> float:
    """δ at the junction in doubles, between the trochoid's start and its crossing of the base circle."""
    base = _bracketed(lambda delta: -curve.roll_squared(delta), 0.5 * pi - curve.angle)
    if curve.residual(base) <= 0.0:
        return base  # the two differ by a rounding
    return _bracketed(curve.residual, base)


def _bracketed(f: "Callable[[float], float]", high: float) -> float:
    """The sign change of f between 0 (f < 0) and high (f ≥ 0), bracketed downwards by sixteenths."""
    low = 0.0625 * high
    while f(low) > 0.0 and low > 1e-60:
        high, low = low, 0.0625 * low
    return sign_change(lambda delta: -f(delta), low, high)
