"""Critical speed of a vehicle that left yaw marks at the limit of side friction."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import absolute, multiply_add, sqrt
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.drag import friction_advice, grade_advice, secant, speed_advice
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Annotated,
    Distance,
    DragFactor,
    Friction,
    Gravity,
    Length,
    Ratio,
    RoadSpeed,
    Slope,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.skid.curved.survey import Points, SurveyFile, surveyed, yaw_scatter
from dynamics_cli.skid.diagnostics import balance


@record
class Radius:
    """A mark of known radius."""

    radius: Annotated[Distance, "Radius of the mark, e.g. 80 m [m]."]


@record
class Chord:
    """A mark measured by a chord and its middle ordinate."""

    chord: Annotated[Distance, "Straight distance between two points of the mark, e.g. 20 m [m]."]
    middle_ordinate: Annotated[Distance, "From the middle of the chord to the mark, across the chord, e.g. 0.6 m [m]."]

    @property
    def radius(self) -> float:
        """Radius of the circle through the three points."""
        return self.chord * (self.chord / (8.0 * self.middle_ordinate)) + 0.5 * self.middle_ordinate


@record
class CriticalSpeed:
    """Speed at the limit of side friction."""

    speed: Annotated[RoadSpeed, "Critical speed [m/s]."]
    path_radius: Annotated[Distance, "Radius of the path of the mass centre [m]."]
    mark_radius: Annotated[Distance, "Radius of the mark as measured [m]."]
    lateral_acceleration: Annotated[
        Acceleration, "Acceleration towards the centre of the path, in the horizontal plane [m/s^2]."
    ]
    speed_deviation: Annotated[
        RoadSpeed | None, "Standard deviation of the speed by the surveyed points alone; needs points [m/s]."
    ] = None
    radius_deviation: Annotated[Distance | None, "Standard deviation of the radius by them; needs points [m]."] = None
    point_scatter: Annotated[Distance | None, "Scatter of the points about their circle; needs four points [m]."] = None
    sagitta: Annotated[Distance | None, "Height of the arc over the chord of its ends; needs points [m]."] = None
    centre: Annotated[tuple[Length, Length] | None, "Centre of the circle of the mark; needs points [m]."] = None
    first_half_radius: Annotated[Distance | None, "Radius of the first half of the mark; needs five points [m]."] = None
    second_half_radius: Annotated[Distance | None, "Radius of its second half; needs five points [m]."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def yaw(
    *,
    path: Annotated[
        Radius | Chord | Points | SurveyFile,
        "The radius of the mark, or a chord and its middle ordinate, or surveyed points, listed or in a file.",
    ],
    friction: Annotated[Friction, "Coefficient of side friction between tyre and road [-]."],
    superelevation: Annotated[
        Slope, "Rise over run of the road across the path, positive when the outside of the curve is higher [-]."
    ] = 0.0,
    track_width: Annotated[
        Distance | None,
        "Track width, if the outer tyres left the mark and the speed is that of the mass centre's path, e.g. 1.5 m "
        "[m].",
    ] = None,
    braking_drag: Annotated[
        DragFactor | None, "Part of the friction that braking used up along the path, e.g. 0.25 [-]."
    ] = None,
    test_error: Annotated[
        Ratio | None,
        "Speed by this method over the true one, less one, as tests found it: 4.1 % ± 6.3 % by a 20 m chord, "
        "-2 % ± 5.2 % by the path of the mass centre; e.g. 4 % [-].",
    ] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> CriticalSpeed:
    """Critical speed of a vehicle on a curved path at the limit of side friction, with the bank of the road.

    Equation
    --------
    v² = g R (f + e)/(1 − f e); R = C²/(8M) + M/2 from a chord, or that of the circle with the least Σ(|p − c| − R)²
    through surveyed points, less half the track width when the mark is a tyre's. Braking takes f = √(μ² − f_x²).

    Returns
    -------
    CriticalSpeed
        The speed, the radii of path and mark, and the lateral acceleration.

    Raises
    ------
    InadmissibleError
        When the chord or the middle ordinate is zero, half the track exceeds the radius, friction does not hold
        against an adverse bank (f + e ≤ 0), or the bank holds the vehicle at any speed (1 − f e ≤ 0); when braking
        uses all of the friction, or surveyed points do not decide a circle.

    Notes
    -----
    A point mass on a circle in a horizontal plane, neither braking nor driven; 1 − f e is rounded once. Speed grows as
    √R, and R from a chord as 1/M: a short middle ordinate dominates the error. The deviation by the points is theirs
    alone; for an interval of everything give the radius with its deviation, or every coordinate with its own.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 3 (motion on a circle); the critical
    speed formula as commonly published in accident reconstruction. Errors in 29 tests: Amirault & MacInnis 2009.

    Examples
    --------
    >>> round(yaw(path=Chord(chord=30.0, middle_ordinate=1.0), friction=0.75).speed, 4)
    28.829
    """
    if isinstance(path, Chord):
        _require_arc(path)
    survey = surveyed(path) if isinstance(path, Points | SurveyFile) else None
    mark_radius = survey.radius if survey is not None else path.radius  # type: ignore[union-attr]
    require(mark_radius > 0.0, "the radius of the mark must be more than zero", code="radius")
    path_radius = mark_radius
    if track_width is not None:
        path_radius = mark_radius - 0.5 * track_width
        require(
            path_radius > 0.0,
            "half the track width of {width} exceeds the radius of the mark, {radius}",
            code="track",
            width=(track_width, Distance),
            radius=(mark_radius, Distance),
        )
    sideways = friction if braking_drag is None else _left_for_the_curve(friction, braking_drag)
    lean = multiply_add(-sideways, superelevation, 1.0)
    grip = _share(sideways, superelevation, lean)
    speed = sqrt(gravity * path_radius * grip)
    if test_error is not None:
        require(
            test_error > -1.0,
            "with a test error of {e} the speed would not be above zero",
            e=(test_error, Ratio),
            code="test-error",
        )
        speed = speed / (1.0 + test_error)
    return CriticalSpeed(
        speed=speed,
        path_radius=path_radius,
        mark_radius=mark_radius,
        lateral_acceleration=gravity * grip,
        speed_deviation=yaw_scatter(speed, path_radius, survey),
        radius_deviation=survey.deviation if survey else None,
        point_scatter=survey.residual if survey else None,
        sagitta=survey.sagitta if survey else None,
        centre=survey.centre if survey else None,
        first_half_radius=survey.first_half if survey else None,
        second_half_radius=survey.second_half if survey else None,
        checks=_check(sideways, superelevation, grip),
        advice=friction_advice(friction)
        + grade_advice(superelevation, "superelevation")
        + (survey.advice if survey else _arc_advice(path))
        + _bank_advice(lean)
        or speed_advice(speed, "a critical speed", "check the path and its unit"),
    )


def _share(friction: float, bank: float, lean: float) -> float:
    """Lateral acceleration over gravity at the limit; `lean` is 1 − f·e."""
    grip = friction + bank
    require(
        grip > 0.0,
        "friction and superelevation sum to {grip}: the vehicle slides off the bank at any speed",
        code="adverse-bank",
        grip=(grip, Ratio),
    )
    require(
        lean > 0.0,
        "1 - friction × superelevation is {lean}: the bank holds the vehicle at any speed; no speed is critical",
        code="no-critical-speed",
        lean=(lean, Ratio),
    )
    return grip / lean


def _left_for_the_curve(friction: float, braking: float) -> float:
    """The lateral friction that braking leaves on the friction circle."""
    require(
        braking < friction, "braking with {braking} uses all of the friction of {friction}: none is left for the curve",
        braking=(braking, DragFactor), friction=(friction, Friction), code="no-side-friction",
    )  # fmt: skip
    return sqrt((friction - braking) * (friction + braking))


def _require_arc(path: Chord) -> None:
    require(path.chord > 0.0, "the chord must be more than zero", code="chord")
    require(
        path.middle_ordinate > 0.0,
        "the middle ordinate must be more than zero: the mark would be straight",
        code="middle-ordinate",
    )


def _check(friction: float, bank: float, share: float) -> tuple[Check, ...]:
    """Balance of forces along the banked road, from the acceleration that was returned."""
    cosine = 1.0 / secant(bank)
    sine = bank * cosine
    outward = share * (cosine - friction * sine)
    inward = sine + friction * cosine
    scale = share * (cosine + friction * absolute(sine)) + absolute(sine) + friction * cosine
    return balance("forces across the path", outward, inward, scale, friction, bank, share)


def _arc_advice(path: Radius | Chord | Points | SurveyFile) -> tuple[Advice, ...]:
    if not isinstance(path, Chord) or not single(path.chord, path.middle_ordinate):
        return ()
    chord, ordinate = plain(path.chord), plain(path.middle_ordinate)
    if ordinate > 0.5 * chord:
        message = worded(
            "the middle ordinate of {ordinate} exceeds half the chord of {chord}: more than half a turn",
            ordinate=(ordinate, Distance),
            chord=(chord, Distance),
        )
        remedy = "check that chord and middle ordinate are not exchanged"
        return (Advice(code="beyond-half-circle", message=message, remedy=remedy),)
    if ordinate >= 0.25:
        return ()
    percent = 0.5 / ordinate
    return (
        Advice(
            code="short-middle-ordinate",
            message=worded(
                "an error of 1 cm in the middle ordinate of {ordinate} changes the speed by {percent}",
                ordinate=(ordinate, Distance),
                percent=f"{percent:.3g} %",
            ),
            severity="caution" if percent < 10.0 else "serious",
            remedy="measure a longer chord",
        ),
    )


def _bank_advice(lean: float) -> tuple[Advice, ...]:
    if not single(lean) or plain(lean) > 0.2:
        return ()
    message = worded(
        "1 - friction × superelevation is only {lean:3}: as it approaches zero the speed grows without limit",
        lean=(lean, Ratio),
    )
    return (Advice(code="near-self-holding-bank", message=message, severity="serious"),)
