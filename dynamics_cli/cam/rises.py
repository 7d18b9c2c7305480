"""Rise laws by themselves: their peak factors and continuity, and one rise at chosen angles."""

from math import inf

from dynamics_cli.cam.laws import Law, LawName, law_named
from dynamics_cli.cam.peaks import continuity, extremes, peak
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
    Text,
    Time,
)
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record

DERIVATIVES = ("lift", "velocity", "acceleration", "jerk", "rate of jerk")
MOST_POINTS = 100_000
METHOD = "closed form from the nearer end: lift and velocity within 1e-15 of the peak, acceleration 5e-15, jerk 5e-14"
PEAK_BOUND = 4e-15


@record
class Condition:
    """What a polynomial law is to be at one place, in units of the rise: place 0 to 1, lift 0 to 1.

    Parameters
    ----------
    place : Fraction
        Share of the span.
    lift : Ratio
        Share of the lift.
    velocity : Ratio
        First derivative by the share of the span.
    acceleration : Ratio
        Second derivative.
    jerk : Ratio
        Third derivative.
    rate_of_jerk : Ratio
        Fourth derivative.
    """

    place: Fraction
    lift: Ratio | None = None
    velocity: Ratio | None = None
    acceleration: Ratio | None = None
    jerk: Ratio | None = None
    rate_of_jerk: Ratio | None = None


@record
class SplinePoint:
    """A point a spline law goes through, in units of the rise.

    Parameters
    ----------
    place : Fraction
        Share of the span.
    lift : Ratio
        Share of the lift.
    """

    place: Fraction
    lift: Ratio


@record
class Peaks:
    """Peak factors of one law: what lift/span, lift/span² and lift/span³ are multiplied by.

    Parameters
    ----------
    law : Text
        Its name.
    velocity : Ratio
        C_v, greatest velocity; none where it is infinite.
    velocity_at : Ratio
        Where first, as a share of the span.
    acceleration : Ratio
        C_a, greatest acceleration; none where it is infinite.
    acceleration_at : Ratio
        Where first.
    jerk : Ratio
        C_j, greatest jerk; none where it is infinite.
    jerk_at : Ratio
        Where first.
    jerk_inside : Ratio
        Greatest finite jerk, apart from where the acceleration jumps.
    continuity : Text
        C0 to C4: the highest derivative without a jump between rest and rest.
    jumps : Text
        Which derivative jumps first, and where.
    also : Text
        Other names, those of VDI 2143 among them.
    """

    law: Text
    velocity: Ratio | None
    velocity_at: Ratio
    acceleration: Ratio | None
    acceleration_at: Ratio
    jerk: Ratio | None
    jerk_at: Ratio
    jerk_inside: Ratio
    continuity: Text
    jumps: Text
    also: Text


@record
class LawTable:
    """Laws and their peak factors.

    Parameters
    ----------
    laws : tuple of Peaks
        One row for each law.
    """

    laws: tuple[Peaks, ...]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def laws(
    *,
    law: LawName | None = None,
    shares: tuple[Ratio, ...] = (),
    constant: Fraction | None = None,
    conditions: tuple[Condition, ...] = (),
    points: tuple[SplinePoint, ...] = (),
    start_velocity: Ratio = 0.0,
    end_velocity: Ratio = 0.0,
) -> LawTable:
    """Rise laws with their peak factors, where the peaks are, and how smooth the rise is between rest and rest.

    Equation
    --------
    v = C_v h/β, a = C_a h/β², j = C_j h/β³ at the peaks, for lift h over the span β.

    Parameters
    ----------
    law : LawName
        One law; all named laws when not given.
    shares : tuple of Ratio
        Shares b, c, d of sine, constant and cosine acceleration of scca.
    constant : Fraction
        Share of the rise at constant velocity, of modified-constant-velocity or scca.
    conditions : tuple of Condition
        What a polynomial is to meet; as many values as it has coefficients, to degree 9.
    points : tuple of SplinePoint
        Points a clamped cubic spline goes through between (0, 0) and (1, 1).
    start_velocity : Ratio
        Slope of a spline at its start.
    end_velocity : Ratio
        Slope of a spline at its end.

    Returns
    -------
    LawTable
        A row for each law.

    Raises
    ------
    InadmissibleError
        When shares do not sum to 1, or conditions fix no polynomial.

    Notes
    -----
    A peak is infinite where the derivative below it jumps; half rises go on at full speed at one end, which counts as
    no jump there. Places are bisected to the last bit.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.9 and 16.11 to 16.14; the peak factors
    as published for the standard laws of cam design.

    Examples
    --------
    >>> row = laws(law=LawName("cycloidal")).laws[0]
    >>> round(row.velocity, 6), round(row.acceleration, 6), round(row.jerk, 6)
    (2.0, 6.283185, 39.478418)
    """
    if law is None:
        require(
            not (shares or conditions or points or constant),
            "shares, conditions and points belong to one law",
            code="law",
            hint="name it: --law scca, --law polynomial, --law spline",
        )
        named = [law_named(name) for name in LawName.names if name not in ("scca", "polynomial", "spline")]
        chosen = sorted(named, key=lambda one: -continuity(one)[0])
    else:
        chosen = [_chosen(law, shares, constant, conditions, points, start_velocity, end_velocity)]
    rows = tuple(_peaks(one) for one in chosen)
    bounds = tuple(
        ErrorBound(f"laws[{i}].{name}", PEAK_BOUND)
        for i, row in enumerate(rows)
        for name in DERIVATIVES[1:4]
        if getattr(row, name) is not None
    )
    checks = [check for one in chosen for check in _checks(one)]
    worst = max(check.value or 0.0 for check in checks)
    return LawTable(
        rows,
        checks=(Check("areas under velocity and acceleration", worst <= 1e-12, worst, 1e-12),),
        advice=_infinite_rows(rows),
        numerics=Numerics("closed form; peaks bisected to the last bit", bounds),
    )


def _infinite_rows(rows: "tuple[Peaks, ...]") -> "tuple[Advice, ...]":
    """Why a peak is missing: where it is, the derivative below it jumps."""
    return tuple(
        Advice(
            "infinite-" + DERIVATIVES[order],
            f"{row.law}: the {DERIVATIVES[order]} has no greatest value: {row.jumps.replace(' at', ' jumps at')}",
            "note",
            result=f"laws[{i}].{DERIVATIVES[order]}",
        )
        for i, row in enumerate(rows)
        for order in (2, 3)
        if getattr(row, DERIVATIVES[order]) is None
    )


def _chosen(
    name: LawName,
    shares: "tuple[float, ...]",
    constant: float | None,
    conditions: "tuple[Condition, ...]",
    points: "tuple[SplinePoint, ...]",
    start_velocity: float = 0.0,
    end_velocity: float = 0.0,
) -> Law:
    require(name == "polynomial" or not conditions, "the law {0} takes no conditions", name, code="law")
    require(name == "spline" or not points, "the law {0} goes through no points", name, code="law")
    require(
        name == "spline" or (start_velocity == 0.0 and end_velocity == 0.0),
        "the law {0} has velocities of its own at its ends",
        name,
        code="law",
        hint="take a polynomial with conditions",
    )
    if name == "polynomial":
        from dynamics_cli.cam.polynomials import polynomial

        require(bool(conditions), "a polynomial needs conditions", code="conditions", hint=CONDITION_HINT)
        return polynomial([found for one in conditions for found in _conditions(one)])
    if name == "spline":
        from dynamics_cli.cam.polynomials import spline

        inner = [(point.place, point.lift) for point in points]
        return spline([(0.0, 0.0), *inner, (1.0, 1.0)], start_velocity, end_velocity)
    return law_named(name, shares or None, constant)


CONDITION_HINT = 'for example --condition "place=0, lift=0, velocity=0" --condition "place=1, lift=1, velocity=0"'


def _conditions(one: Condition) -> "list[tuple[float, int, float]]":
    values = (one.lift, one.velocity, one.acceleration, one.jerk, one.rate_of_jerk)
    found = [(one.place, order, value) for order, value in enumerate(values) if value is not None]
    require(
        bool(found), "the condition at {0:.6g} asks for nothing", one.place, code="conditions", hint=CONDITION_HINT
    )
    return found


def _peaks(law: Law) -> Peaks:
    values = [peak(law, order) for order in (1, 2, 3)]
    order, where = continuity(law)
    jumps = "" if where is None else f"{DERIVATIVES[order + 1]} at {where:.6g}"
    tops = [None if top == inf else top for top, _ in values]
    return Peaks(
        law.name,
        tops[0], values[0][1],
        tops[1], values[1][1],
        tops[2], values[2][1],
        max(abs(value) for _, value in extremes(law, 3)),
        f"C{order}" if order >= 0 else "none",
        jumps,
        ", ".join(alias for alias, name in LawName.aliases.items() if name == law.name),
    )  # fmt: skip


def _checks(law: Law) -> "tuple[Check, ...]":
    """The areas under velocity and acceleration, by Gauss's rule, are lift and gain of velocity."""
    area = [0.0, 0.0]
    size = 0.0
    for piece in law.pieces:
        start, end = piece.ends
        half = 0.5 * (end - start)
        for node, weight in GAUSS:
            for t in (start + half * (1.0 - node), start + half * (1.0 + node)):
                found = law.upright(piece, t, 2)
                area = [area[0] + weight * half * found[1], area[1] + weight * half * found[2]]
                size += weight * half * abs(found[2])
    gain = law.at(1.0, 1, -1)[1] - law.at(0.0, 1)[1]
    scale = max(abs(law.total), 1e-300)
    worst = max(abs(area[0] - law.total) / scale, abs(area[1] - gain) / max(size, 1e-300) if size else 0.0)
    return (Check(f"areas under {law.name}", worst <= 1e-12, worst, 1e-12),)


# Abscissae and weights of Gauss's rule of 16 points, the positive half.
GAUSS = (
    (0.09501250983763744, 0.1894506104550685), (0.2816035507792589, 0.18260341504492358),
    (0.45801677765722737, 0.16915651939500254), (0.6178762444026438, 0.14959598881657674),
    (0.755404408355003, 0.12462897125553388), (0.8656312023878318, 0.09515851168249279),
    (0.9445750230732326, 0.06225352393864789), (0.9894009349916499, 0.027152459411754095),
)  # fmt: skip


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
        span > 0.0, "a span of {0:.6g} rad leaves no room for the rise", span, code="span", hint="give a positive span"
    )
    require(
        1e-100 < lift < 1e100 and 1e-50 < span < 1e50, "lift or span is beyond what any cam has", code="range"
    )
    require(bool(at) or 2 <= count <= MOST_POINTS, "a table has 2 to {0} points, not {1}", MOST_POINTS, count, code="count")
    chosen = _chosen(law, shares, constant, conditions, points, start_velocity, end_velocity)
    scales = [lift / span**order for order in range(4)]
    angles = at or [span * (i / (count - 1)) for i in range(count - 1)] + [span]
    found = tuple(_point(chosen, angle, span, lift, scales, falling, shaft_speed) for angle in angles)
    tops = [peak(chosen, order) for order in (1, 2, 3)]
    peaks = [None if top == inf else top * scales[order] for order, (top, _) in enumerate(tops, 1)]
    places = [(1.0 - x if falling else x) * span for _, x in tops]
    return Rise(
        peaks[0], places[0],
        peaks[1], places[1],
        peaks[2], places[2],
        found,
        checks=_checks(chosen),
        advice=_infinite(chosen, peaks, places),
        numerics=Numerics(
            METHOD, tuple(
                ErrorBound(f"peak_{name}", PEAK_BOUND)
                for name, value in zip(DERIVATIVES[1:4], peaks, strict=True)
                if value is not None
            )
        ),
    )  # fmt: skip


def _point(
    law: Law, angle: float, span: float, lift: float, scales: "list[float]", falling: bool, omega: float | None
) -> RisePoint:
    require(
        0.0 <= angle <= span,
        "the angle {0:.6g} rad is not within the span, 0 to {1:.6g} rad",
        angle,
        span,
        code="angle",
        hint="angles count from the start of the rise",
    )
    x = angle / span
    # Where a fall is a rise run backwards, the side turns too.
    side = -1 if x == (0.0 if falling else 1.0) else 1
    side = -side if falling and 0.0 < x < 1.0 else side
    f, *slopes = _measured(law, (span - angle) / span if falling else x, (span - angle) / span, x, falling, side)
    signs = (-1.0, 1.0, -1.0) if falling else (1.0, 1.0, 1.0)
    v, a, j = (sign * slope * scale for sign, slope, scale in zip(signs, slopes, scales[1:], strict=True))
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
            return tuple(law.upright(piece, rest if piece.far else x, 3))
    raise AssertionError


def _infinite(law: Law, peaks: "list[float | None]", places: "list[float]") -> "tuple[Advice, ...]":
    found: list[Advice] = []
    for order, (value, place) in enumerate(zip(peaks, places, strict=True), 1):
        if value is None:
            found.append(
                Advice(
                    code="infinite-" + DERIVATIVES[order],
                    message=f"the {DERIVATIVES[continuity(law)[0] + 1]} jumps at {place:.6g} rad: "
                    f"the {DERIVATIVES[order]} has no greatest value",
                    severity="serious" if order < 3 else "caution",
                    mend="take a law of higher continuity, such as cycloidal or 3-4-5",
                    result="peak_" + DERIVATIVES[order],
                )
            )
    return tuple(found)
