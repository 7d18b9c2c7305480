"""One rise at chosen angles, per radian and in time."""

from math import inf, pi

from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.normalised import Law
from dynamics_cli.cam.laws.peaks import DERIVATIVES, continuity, errors_of, peak, peak_bound
from dynamics_cli.cam.laws.rounded_points import rounding_advice
from dynamics_cli.cam.laws.selection import Condition, SplinePoint, area_checks, chosen
from dynamics_cli.errors import require, worded
from dynamics_cli.quantities import (
    Acceleration,
    Angle,
    Annotated,
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
from dynamics_cli.records import Advice, Check, ErrorBound, LateNumerics, Numerics, record

ROUNDING = 2.0**-52
UNIT = 2.0**-53
UP = 1.0 + 2.0**-40
MOST_POINTS = 100_000
# One turn, for spans that rounding makes slightly longer.
TURN = 2.0 * pi * (1.0 + 2.0**-50)
# The derivatives of the lift by the time.
IN_TIME = ("speed", "acceleration_in_time", "jerk_in_time")
METHOD = "closed form from the nearer end, rounding bounded at every point"


@record
class RisePoint:
    """One rise at one angle."""

    angle: Annotated[Angle, "Cam angle from the start of the rise [rad]."]
    lift: Annotated[Coordinate, "Lift above the start [m]."]
    velocity: Annotated[CamVelocity, "Its first derivative by the cam angle [m/rad]."]
    acceleration: Annotated[CamAcceleration, "Its second [m/rad^2]."]
    jerk: Annotated[CamJerk, "Its third [m/rad^3]."]
    time: Annotated[Time | None, "Time from the start of the rise [s]."] = None
    speed: Annotated[Speed | None, "Speed of the follower [m/s]."] = None
    acceleration_in_time: Annotated[Acceleration | None, "Its acceleration [m/s^2]."] = None
    jerk_in_time: Annotated[Jerk | None, "Its jerk [m/s^3]."] = None


@record
class Rise:
    """One rise: its peaks, and its values at angles."""

    peak_velocity: Annotated[CamVelocity | None, "Maximum magnitude of the velocity [m/rad]."]
    peak_velocity_at: Annotated[Angle, "Where first [rad]."]
    peak_acceleration: Annotated[CamAcceleration | None, "Maximum magnitude of the acceleration [m/rad^2]."]
    peak_acceleration_at: Annotated[Angle, "Where first [rad]."]
    peak_jerk: Annotated[CamJerk | None, "Maximum magnitude of the jerk [m/rad^3]."]
    peak_jerk_at: Annotated[Angle, "Where first [rad]."]
    points: Annotated[tuple[RisePoint, ...], "Values at the angles."]
    peak_speed: Annotated[Speed | None, "Maximum speed of the follower at the shaft speed given [m/s]."] = None
    peak_acceleration_in_time: Annotated[Acceleration | None, "Its maximum acceleration [m/s^2]."] = None
    peak_jerk_in_time: Annotated[Jerk | None, "Its maximum jerk [m/s^3]."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def rise(
    *,
    law: Annotated[LawName, "The law."],
    lift: Annotated[Size, "How far the follower rises, e.g. 20 mm [m]."],
    span: Annotated[Angle, "Cam angle of the rise, e.g. 90 deg [rad]."],
    at: Annotated[
        tuple[Angle, ...],
        "Angles from the start of the rise; a table of `count` when not given, e.g. 0, 30, 60 deg [rad].",
    ] = (),
    count: Annotated[Count, "Number of points of the table."] = 19,
    falling: Annotated[bool, "A return from the lift to zero, h (1 − f(θ/β)), as in `cam motion`."] = False,
    mirrored: Annotated[
        bool, "A return that is the rise run backwards, h f(1 − θ/β); it differs where a law is not symmetric."
    ] = False,
    shaft_speed: Annotated[ShaftSpeed | None, "Speed of the cam shaft [rad/s]."] = None,
    shares: Annotated[
        tuple[Ratio, ...], "Shares b, c, d of sine, constant and cosine acceleration of scca, e.g. 0.25, 0.5, 0.25."
    ] = (),
    constant: Annotated[
        Fraction | None, "Share of the rise at constant velocity, of modified-constant-velocity or scca, e.g. 50 %."
    ] = None,
    conditions: Annotated[tuple[Condition, ...], "Conditions that a polynomial is to meet, in units of the rise."] = (),
    points: Annotated[tuple[SplinePoint, ...], "Points a spline goes through, in units of the rise."] = (),
    start_velocity: Annotated[Ratio, "Slope of a spline at its start, in units of the rise."] = 0.0,
    end_velocity: Annotated[Ratio, "Slope of a spline at its end."] = 0.0,
) -> Rise:
    """Lift, velocity, acceleration and jerk of one rise, per radian and, at a shaft speed, in time.

    Equation
    --------
    s = h f(θ/β), ds/dθ = h f′/β, d²s/dθ² = h f″/β², d³s/dθ³ = h f‴/β³; in time ω, ω², ω³ times these. Falling:
    s = h (f(1) − f(θ/β)), as a return of `cam motion`; mirrored: s = h f(1 − θ/β).

    Returns
    -------
    Rise
        The peaks and the table.

    Raises
    ------
    InadmissibleError
        When lift or span is zero, the span is more than one turn, an angle is outside it, or the law lacks what it
        needs.

    Notes
    -----
    Lift keeps its digits at both ends of the rise. Where a derivative jumps inside, the later value is given; at the
    ends, the value within the rise.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.9 and 16.11 to 16.14.

    Examples
    --------
    >>> result = rise(law=LawName("cycloidal"), lift=0.02, span=1.5, at=(0.75,)).points[0]
    >>> result.lift, round(result.velocity, 12)
    (0.01, 0.026666666667)
    """
    _require_rise(lift, span, count, at=bool(at), both=falling and mirrored)
    profile = chosen(law, shares, constant, conditions, points, start_velocity, end_velocity)
    direction = "falling" if falling else "mirrored" if mirrored else "rising"
    scales = [lift / span**order for order in range(4)]
    angles = at or [span * (i / (count - 1)) for i in range(count - 1)] + [span]
    table = tuple(_point(profile, angle, span, lift, scales, direction, shaft_speed) for angle in angles)
    tops = [peak(profile, order, -1 if mirrored else 1) for order in (1, 2, 3)]
    peaks = [None if top == inf else top * scales[order] for order, (top, _) in enumerate(tops, 1)]
    places = [(1.0 - x if mirrored else x) * span for _, x in tops]
    return Rise(
        peaks[0], places[0],
        peaks[1], places[1],
        peaks[2], places[2],
        table,
        **_in_time(peaks, shaft_speed),
        checks=area_checks(profile),
        advice=(*_infinite(profile, peaks, places), *_ways_down(profile, direction), *rounding_advice(profile)),
        numerics=LateNumerics(
            METHOD,
            lambda: (
                *_peak_bounds(profile, peaks, shaft_speed),
                *_bounds(profile, table, span, lift, shaft_speed, direction),
            ),
        ),
    )  # fmt: skip


def _require_rise(lift: float, span: float, count: int, *, at: bool, both: bool) -> None:
    """Refuse anything but a rise within one turn, and a table of too many points."""
    require(
        lift > 0.0,
        "the lift is {lift}; a rise needs a positive lift",
        lift=(lift, Size),
        code="lift",
        hint="a dwell needs no law",
    )
    require(
        span > 0.0,
        "the span is {span}; a rise needs a positive span",
        span=(span, Angle),
        code="span",
        hint="give a positive span",
    )
    require(
        span <= TURN,
        "the span of {span} is more than one turn of the cam",
        span=(span, Angle),
        code="span",
        hint="give a span of at most {turn}",
        turn=(2.0 * pi, Angle),
    )
    require(1e-100 < lift < 1e100 and span > 1e-50, "lift or span is outside the range of any cam", code="range")
    require(
        at or 2 <= count <= MOST_POINTS,
        "count: {count} points; a table has 2 to {most}",
        count=count,
        most=MOST_POINTS,
        code="count",
    )
    require(
        not both,
        "a return is either falling or mirrored",
        code="falling",
        hint="--falling follows the law downwards; --mirrored runs the rise backwards",
    )


def _in_time(peaks: "list[float | None]", omega: float | None) -> "dict[str, float | None]":
    """The peaks at a shaft speed."""
    if omega is None:
        return {}
    rates = (abs(omega), omega * omega, abs(omega * omega * omega))
    return {
        f"peak_{name}": None if value is None else value * rate
        for name, value, rate in zip(IN_TIME, peaks, rates, strict=True)
    }


def _peak_bounds(law: Law, peaks: "list[float | None]", omega: float | None) -> "list[ErrorBound]":
    # lift over a power of the span: two roundings for each factor and two of the products
    bounds = []
    for order, value in enumerate(peaks, 1):
        if value is not None:
            bound = peak_bound(law, order) + (2.0 * order + 3.0) * UNIT
            bounds.append(ErrorBound(f"peak_{DERIVATIVES[order]}", bound))
            if omega is not None:
                bounds.append(ErrorBound(f"peak_{IN_TIME[order - 1]}", (bound + (order + 1.0) * UNIT) * UP))
    return bounds


def _bounds(
    law: Law, points: "tuple[RisePoint, ...]", span: float, lift: float, omega: float | None, way: str
) -> "list[ErrorBound]":
    """Error bound of each column, the largest of its rows."""
    worst = [0.0] * 4
    for point in points:
        x, rest = point.angle / span, (span - point.angle) / span
        if way == "mirrored":
            x, rest = rest, x
        values = (point.lift, point.velocity, point.acceleration, point.jerk)
        for piece in law.pieces:
            if piece.low <= x <= piece.high:
                t = rest if piece.far else x
                # the quotient counts two roundings, of a difference and its own
                errors = errors_of(piece, t, 2.0 * UNIT * t, 3)
                sizes = [abs(value) for value in piece.shape(t, 4)]
                for order, (error, value) in enumerate(zip(errors, values, strict=True)):
                    # a value below its change over the rounding of the angle is shown as zero
                    still = 2.0 * ROUNDING * x * sizes[order + 1] if order and not value else 0.0
                    scaled = (error + still) * lift / span**order + (2.0 * order + 4.0) * UNIT * abs(value)
                    worst[order] = max(worst[order], scaled)
    bounds = [
        ErrorBound(f"points.{name}", error * UP, relative=False)
        for name, error in zip(("lift", *DERIVATIVES[1:4]), worst, strict=True)
    ]
    if omega is None:
        return bounds
    rate = abs(omega)
    sizes = [max(abs(getattr(point, name)) for point in points) for name in DERIVATIVES[1:4]]
    for order, name in enumerate(IN_TIME, 1):
        error = (worst[order] + (order + 1.0) * UNIT * sizes[order - 1]) * rate**order * UP
        bounds.append(ErrorBound(f"points.{name}", error, relative=False))
    return bounds


def _point(
    law: Law, angle: float, span: float, lift: float, scales: "list[float]", way: str, omega: float | None
) -> RisePoint:
    require(
        0.0 <= angle <= span,
        "the angle {angle} is outside the span, {start} to {span}",
        angle=(angle, Angle), start=(0.0, Angle), span=(span, Angle),
        code="angle", hint="angles count from the start of the rise",
    )  # fmt: skip
    x, rest = angle / span, (span - angle) / span
    # at the ends the value within, inside the later one: the earlier one of a rise run backwards
    side = -1 if angle == span else 1
    if way == "mirrored":
        x, rest, side = rest, x, -side
    f, *slopes, last = _measured(law, x, rest, side, down=way == "falling")
    # angles are doubles: a value smaller than its change over the rounding of the angle is zero
    slopes = [
        slope if abs(slope) > ROUNDING * (angle / span) * abs(change) else 0.0
        for slope, change in zip(slopes, (*slopes[1:], last), strict=True)
    ]
    signs = {"rising": (1.0, 1.0, 1.0), "falling": (-1.0, -1.0, -1.0), "mirrored": (-1.0, 1.0, -1.0)}[way]
    v, a, j = (sign * slope * scale + 0.0 for sign, slope, scale in zip(signs, slopes, scales[1:], strict=True))
    s = lift * f
    if omega is None:
        return RisePoint(angle, s, v, a, j)
    time = angle / abs(omega) if omega else None
    return RisePoint(angle, s, v, a, j, time, v * omega, a * (omega * omega), j * (omega * omega * omega))


def _measured(law: Law, x: float, rest: float, side: int, *, down: bool) -> "tuple[float, ...]":
    """The law at x, or its distance from the end, with 1 − x as a separate quotient: both ends keep their digits."""
    for piece in law.pieces:
        if x < piece.high or (x == piece.high and side < 0) or piece is law.pieces[-1]:
            t = rest if piece.far else x
            f, *slopes = law.upright(piece, t, 4)
            if down:
                f = piece.shape(t, 0)[0] if piece.far else law.total - f
            return (f, *slopes)
    raise AssertionError


def _ways_down(law: Law, way: str) -> "tuple[Advice, ...]":
    """Note which of the two returns of an asymmetric law is shown."""
    places = [k / 32.0 for k in range(17)]
    if way == "rising" or all(abs(law.at(x, 0)[0] + law.at(1.0 - x, 0)[0] - law.total) <= 1e-12 for x in places):
        return ()
    meant, other = "follows the law downwards, as in cam motion", "--mirrored gives the rise run backwards"
    if way == "mirrored":
        meant, other = "is the rise run backwards", "--falling follows the law downwards, as in cam motion"
    return (Advice("return", f"the law {law.name} is not symmetric: this return {meant}", "note", other),)


def _infinite(law: Law, peaks: "list[float | None]", places: "list[float]") -> "tuple[Advice, ...]":
    advice: list[Advice] = []
    for order, (value, place) in enumerate(zip(peaks, places, strict=True), 1):
        if value is None:
            advice.append(
                Advice(
                    code="infinite-" + DERIVATIVES[order],
                    message=worded(
                        "the {below} jumps at {place:6}: the {name} has no maximum",
                        below=DERIVATIVES[continuity(law)[0] + 1],
                        place=(place, Angle),
                        name=DERIVATIVES[order],
                    ),
                    severity="serious" if order < 3 else "caution",
                    remedy="take a law of higher continuity, such as cycloidal or 3-4-5",
                    result="peak_" + DERIVATIVES[order],
                )
            )
    return tuple(advice)
