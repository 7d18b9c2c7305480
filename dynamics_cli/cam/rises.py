"""One rise at chosen angles, per radian and in time."""

from math import inf, pi

from dynamics_cli.cam.choosing import Condition, SplinePoint, area_checks, chosen
from dynamics_cli.cam.laws import Law, LawName
from dynamics_cli.cam.peaks import DERIVATIVES, continuity, peak, peak_bound
from dynamics_cli.cam.slips import HALVES_OF_FLOATS, slips
from dynamics_cli.errors import require
from dynamics_cli.quantities import (
    Acceleration,
    Angle,
    CamAcceleration,
    CamJerk,
    CamVelocity,
    Coordinate,
    Count,
    Fraction,
    Jerk,
    Ratio,
    ShaftSpeed,
    Size,
    Speed,
    Time,
)
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record

ROUNDING = 2.0**-52
UNIT = 2.0**-53
UP = 1.0 + 2.0**-40
MOST_POINTS = 100_000
DEGREES = 180.0 / pi
METHOD = "closed form from the nearer end, its roundings followed at every place"


@record
class RisePoint:
    """One rise at one angle.

    Parameters
    ----------
    angle : Angle
        Cam angle from the start of the rise [rad].
    lift : Coordinate
        Lift above the start [m].
    velocity : CamVelocity
        Its first derivative by the cam angle [m/rad].
    acceleration : CamAcceleration
        Its second [m/rad^2].
    jerk : CamJerk
        Its third [m/rad^3].
    time : Time
        Time from the start of the rise [s].
    speed : Speed
        Speed of the follower [m/s].
    acceleration_in_time : Acceleration
        Its acceleration [m/s^2].
    jerk_in_time : Jerk
        Its jerk [m/s^3].
    """

    angle: Angle
    lift: Coordinate
    velocity: CamVelocity
    acceleration: CamAcceleration
    jerk: CamJerk
    time: Time | None = None
    speed: Speed | None = None
    acceleration_in_time: Acceleration | None = None
    jerk_in_time: Jerk | None = None


@record
class Rise:
    """One rise: its peaks, and its values at angles.

    Parameters
    ----------
    peak_velocity : CamVelocity
        Greatest magnitude of the velocity [m/rad].
    peak_velocity_at : Angle
        Where first [rad].
    peak_acceleration : CamAcceleration
        Greatest magnitude of the acceleration [m/rad^2].
    peak_acceleration_at : Angle
        Where first [rad].
    peak_jerk : CamJerk
        Greatest magnitude of the jerk [m/rad^3].
    peak_jerk_at : Angle
        Where first [rad].
    points : tuple of RisePoint
        Values at the angles.
    """

    peak_velocity: CamVelocity | None
    peak_velocity_at: Angle
    peak_acceleration: CamAcceleration | None
    peak_acceleration_at: Angle
    peak_jerk: CamJerk | None
    peak_jerk_at: Angle
    points: tuple[RisePoint, ...]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def rise(
    *,
    law: LawName,
    lift: Size,
    span: Angle,
    at: tuple[Angle, ...] = (),
    count: Count = 19,
    falling: bool = False,
    shaft_speed: ShaftSpeed | None = None,
    shares: tuple[Ratio, ...] = (),
    constant: Fraction | None = None,
    conditions: tuple[Condition, ...] = (),
    points: tuple[SplinePoint, ...] = (),
    start_velocity: Ratio = 0.0,
    end_velocity: Ratio = 0.0,
) -> Rise:
    """Lift, velocity, acceleration and jerk of one rise, per radian and, at a shaft speed, in time.

    Equation
    --------
    s = h f(θ/β), ds/dθ = h f′/β, d²s/dθ² = h f″/β², d³s/dθ³ = h f‴/β³; in time ω, ω², ω³ times these.

    Parameters
    ----------
    law : LawName
        The law.
    lift : Size
        How far the follower rises [m].
    span : Angle
        Cam angle it takes [rad].
    at : tuple of Angle
        Angles from the start of the rise; a table of `count` when not given [rad].
    count : Count
        How many points the table has.
    falling : bool
        A return from the lift to nothing.
    shaft_speed : ShaftSpeed
        Speed of the cam shaft [rad/s].
    shares : tuple of Ratio
        Shares b, c, d of sine, constant and cosine acceleration of scca.
    constant : Fraction
        Share of the rise at constant velocity, of modified-constant-velocity or scca.
    conditions : tuple of Condition
        What a polynomial is to meet, in units of the rise.
    points : tuple of SplinePoint
        Points a spline goes through, in units of the rise.
    start_velocity : Ratio
        Slope of a spline at its start, in units of the rise.
    end_velocity : Ratio
        Slope of a spline at its end.

    Returns
    -------
    Rise
        The peaks and the table.

    Raises
    ------
    InadmissibleError
        When lift or span is zero, an angle is outside the span, or the law lacks what it needs.

    Notes
    -----
    Lift keeps its digits at both ends of the rise. Where a derivative jumps inside, the later value is given; at the
    ends, the value within the rise.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.9 and 16.11 to 16.14.

    Examples
    --------
    >>> found = rise(law=LawName("cycloidal"), lift=0.02, span=1.5, at=(0.75,)).points[0]
    >>> found.lift, round(found.velocity, 12)
    (0.01, 0.026666666667)
    """
    require(lift > 0.0, "a lift of {0:.6g} m is no rise", lift, code="lift", hint="a dwell needs no law")
    require(
        span > 0.0,
        "a span of {0:.6g} deg leaves no room for the rise",
        span * DEGREES,
        code="span",
        hint="give a positive span",
    )
    require(1e-100 < lift < 1e100 and 1e-50 < span < 1e50, "lift or span is beyond what any cam has", code="range")
    require(
        bool(at) or 2 <= count <= MOST_POINTS, "a table has 2 to {0} points, not {1}", MOST_POINTS, count, code="count"
    )
    own = chosen(law, shares, constant, conditions, points, start_velocity, end_velocity)
    scales = [lift / span**order for order in range(4)]
    angles = at or [span * (i / (count - 1)) for i in range(count - 1)] + [span]
    found = tuple(_point(own, angle, span, lift, scales, falling, shaft_speed) for angle in angles)
    tops = [peak(own, order) for order in (1, 2, 3)]
    peaks = [None if top == inf else top * scales[order] for order, (top, _) in enumerate(tops, 1)]
    places = [(1.0 - x if falling else x) * span for _, x in tops]
    return Rise(
        peaks[0], places[0],
        peaks[1], places[1],
        peaks[2], places[2],
        found,
        checks=area_checks(own),
        advice=_infinite(own, peaks, places),
        numerics=Numerics(METHOD, (*_peak_bounds(own, peaks), *_bounds(own, found, span, lift, shaft_speed, falling))),
    )  # fmt: skip


def _peak_bounds(law: Law, peaks: "list[float | None]") -> "list[ErrorBound]":
    # lift over a power of the span: two roundings for each factor and two of the products
    return [
        ErrorBound(f"peak_{DERIVATIVES[order]}", peak_bound(law, order) + (2.0 * order + 3.0) * UNIT)
        for order, value in enumerate(peaks, 1)
        if value is not None
    ]


def _bounds(
    law: Law, points: "tuple[RisePoint, ...]", span: float, lift: float, omega: float | None, falling: bool
) -> "list[ErrorBound]":
    """What the values of each column may be off, at the worst of its rows."""
    worst = [0.0] * 4
    for point in points:
        x, rest = point.angle / span, (span - point.angle) / span
        if falling:
            x, rest = rest, x
        values = (point.lift, point.velocity, point.acceleration, point.jerk)
        for piece in law.pieces:
            if piece.low <= x <= piece.high:
                t = rest if piece.far else x
                # the quotient counts two roundings, of a difference and its own
                found = slips(piece.shape, t, 2.0 * UNIT * t, 3, HALVES_OF_FLOATS)
                sizes = [abs(value) for value in piece.shape(t, 4)]
                for order, (error, value) in enumerate(zip(found, values, strict=True)):
                    # less than its change over the rounding of the angle is shown as zero
                    still = 2.0 * ROUNDING * x * sizes[order + 1] if order and not value else 0.0
                    scaled = (error + still) * lift / span**order + (2.0 * order + 4.0) * UNIT * abs(value)
                    worst[order] = max(worst[order], scaled)
    made = [
        ErrorBound(f"points.{name}", error * UP, relative=False)
        for name, error in zip(("lift", *DERIVATIVES[1:4]), worst, strict=True)
    ]
    if omega is None:
        return made
    rate = abs(omega)
    sizes = [max(abs(getattr(point, name)) for point in points) for name in DERIVATIVES[1:4]]
    for order, name in enumerate(("speed", "acceleration_in_time", "jerk_in_time"), 1):
        error = (worst[order] + (order + 1.0) * UNIT * sizes[order - 1]) * rate**order * UP
        made.append(ErrorBound(f"points.{name}", error, relative=False))
    return made


def _point(
    law: Law, angle: float, span: float, lift: float, scales: "list[float]", falling: bool, omega: float | None
) -> RisePoint:
    require(
        0.0 <= angle <= span,
        "the angle {0:.6g} deg is not within the span, 0 to {1:.6g} deg",
        angle * DEGREES,
        span * DEGREES,
        code="angle",
        hint="angles count from the start of the rise",
    )
    x = angle / span
    # Where a fall is a rise run backwards, the side turns too.
    side = -1 if x == (0.0 if falling else 1.0) else 1
    side = -side if falling and 0.0 < x < 1.0 else side
    f, *slopes, last = _measured(law, (span - angle) / span if falling else x, (span - angle) / span, x, falling, side)
    # an angle is a double: what is less than its change over the angle's rounding is zero
    slopes = [
        slope if abs(slope) > ROUNDING * x * abs(change) else 0.0
        for slope, change in zip(slopes, (*slopes[1:], last), strict=True)
    ]
    signs = (-1.0, 1.0, -1.0) if falling else (1.0, 1.0, 1.0)
    v, a, j = (sign * slope * scale + 0.0 for sign, slope, scale in zip(signs, slopes, scales[1:], strict=True))
    s = lift * f
    if omega is None:
        return RisePoint(angle, s, v, a, j)
    time = angle / abs(omega) if omega else None
    return RisePoint(angle, s, v, a, j, time, v * omega, a * (omega * omega), j * (omega * omega * omega))


def _measured(law: Law, x: float, far: float, near: float, falling: bool, side: int) -> "tuple[float, ...]":
    """The law at x, with 1 − x as its own quotient, so that the end keeps its digits."""
    rest = near if falling else far
    for piece in law.pieces:
        if x < piece.high or (x == piece.high and side < 0) or piece is law.pieces[-1]:
            return tuple(law.upright(piece, rest if piece.far else x, 4))
    raise AssertionError


def _infinite(law: Law, peaks: "list[float | None]", places: "list[float]") -> "tuple[Advice, ...]":
    found: list[Advice] = []
    for order, (value, place) in enumerate(zip(peaks, places, strict=True), 1):
        if value is None:
            found.append(
                Advice(
                    code="infinite-" + DERIVATIVES[order],
                    message=f"the {DERIVATIVES[continuity(law)[0] + 1]} jumps at {place * DEGREES:.6g} deg: "
                    f"the {DERIVATIVES[order]} has no greatest value",
                    severity="serious" if order < 3 else "caution",
                    mend="take a law of higher continuity, such as cycloidal or 3-4-5",
                    result="peak_" + DERIVATIVES[order],
                )
            )
    return tuple(found)
