"""Rollover: the limit of standing, the speed that trips, and the speed from the distance of rolling."""

from dynamics_cli.errors import require, require_given
from dynamics_cli.numerics.elementary import hypot, multiply_add, pi_beside, sqrt
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.drag import grade_advice
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    AngularSpeed,
    Annotated,
    Deceleration,
    Distance,
    DragFactor,
    Gravity,
    Positive,
    Ratio,
    RoadSpeed,
    Slope,
    Time,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.skid.diagnostics import balance
from dynamics_cli.skid.rollover.trip import kerb_speed, soil_trip


@record
class Rollover:
    """The tipping limit, the tripping speed, and the speeds at the begin of tripping and rolling."""

    stability: Annotated[Ratio, "Static stability factor, track over twice the height of the mass centre [-]."]
    tip_drag: Annotated[
        DragFactor, "Lateral acceleration over gravity at which the inner wheels lift, on the bank given [-]."
    ]
    curve_speed: Annotated[RoadSpeed | None, "Speed at which they lift in the curve; needs the radius [m/s]."]
    kerb_speed: Annotated[
        RoadSpeed | None, "Least sideways speed that a kerb trips; needs the roll gyration radius [m/s]."
    ]
    trip_speed: Annotated[
        RoadSpeed | None,
        "Least sideways speed that the deceleration trips; needs it and the roll gyration radius [m/s].",
    ]
    trip_angle: Annotated[Angle | None, "Roll angle at which that trip needs no more force; needs the same [rad]."]
    trip_time: Annotated[Time | None, "How long that trip takes; needs the same [s]."]
    roll_speed: Annotated[
        RoadSpeed | None, "Speed at which the rolling began; needs roll distance and roll drag [m/s]."
    ]
    roll_time: Annotated[Time | None, "Time of the rolling; needs the same [s]."]
    roll_rate: Annotated[AngularSpeed | None, "Mean roll rate; needs the same and the turns [rad/s]."]
    speed: Annotated[
        RoadSpeed | None, "Speed where the trip began; needs trip distance, trip deceleration and rolling [m/s]."
    ]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def rollover(
    *,
    track_width: Annotated[Distance, "Track width, between the middles of the tyres, e.g. 1.54 m [m]."],
    cm_height: Annotated[Distance, "Height of the mass centre above the road, e.g. 0.7 m [m]."],
    roll_gyration: Annotated[
        Distance | None, "Radius of gyration about the roll axis through the mass centre, e.g. 0.74 m [m]."
    ] = None,
    superelevation: Annotated[
        Slope, "Rise over run of the road across the path, positive when the outside of the curve is higher [-]."
    ] = 0.0,
    radius: Annotated[Distance | None, "Radius of the curve, for the speed at which it tips, e.g. 60 m [m]."] = None,
    trip_deceleration: Annotated[
        Deceleration | None, "Sideways deceleration while soil or a soft edge trips it, e.g. 1.4 g [m/s^2]."
    ] = None,
    trip_distance: Annotated[Distance | None, "How far it slid sideways while it was tripped, e.g. 3 m [m]."] = None,
    roll_distance: Annotated[Distance | None, "From the trip to rest, e.g. 44 m [m]."] = None,
    roll_drag: Annotated[
        DragFactor | None, "Mean drag factor of the rolling, e.g. 0.53; see dynamics skid values roll [-]."
    ] = None,
    turns: Annotated[Positive | None, "Whole turns and parts of one while it rolled, e.g. 2.5 [-]."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Rollover:
    """When a rigid vehicle tips, what sideways speed trips it, and its speed from the distance of tripping and rolling.

    Equation
    --------
    S = T/(2h); a/g = (S + e)/(1 − S e) on a bank e. Kerb: v = √(2g I_o·rise/m)/h, rise = t²/(r + h), t = T/2,
    r² = h² + t², I_o/m = k² + r². Soil: v = a ∫₀^θ₁ dθ/√(2(aX − gY) m/I_o), X = h sinθ + t(1 − cosθ),
    Y = t sinθ − h(1 − cosθ), a X(θ₁) = g·rise. Rolling: v = √(2g f d).

    Returns
    -------
    Rollover
        The stability factor and what tips; with more inputs the trip and the rolling.

    Raises
    ------
    InadmissibleError
        When track or height is zero, the bank tips the vehicle alone or holds it at any speed, or the deceleration does
        not exceed that which tips.

    Notes
    -----
    A rigid vehicle on a level surface while it trips. Suspension and tyres deflect: real vehicles tip earlier, so these
    are upper limits of stability.

    References
    ----------
    Static stability factor: NHTSA. Trips derived from moment of momentum and energy; Josephs & Huston, Dynamics of
    Mechanical Systems, CRC Press 2002, chapters 9 and 10 (impulse and momentum, work and energy).

    Examples
    --------
    >>> round(rollover(track_width=1.54, cm_height=0.7, roll_gyration=0.55**0.5).kerb_speed, 6)
    4.718405
    """
    require((track_width > 0.0) & (cm_height > 0.0), "track width and height must be more than zero", code="no-size")
    half = 0.5 * track_width
    stability = half / cm_height
    tip = _tip(stability, superelevation)
    curve = None
    if radius is not None:
        require(radius > 0.0, "the radius must be more than zero", code="radius")
        curve = sqrt(gravity * radius * tip)
    kerb, trip = _trips(half, cm_height, roll_gyration, trip_deceleration, gravity)
    roll, time, rate = _roll(roll_distance, roll_drag, turns, gravity)
    return Rollover(
        stability=stability,
        tip_drag=tip,
        curve_speed=curve,
        kerb_speed=kerb,
        trip_speed=trip[0],
        trip_angle=trip[1],
        trip_time=trip[2],
        roll_speed=roll,
        roll_time=time,
        roll_rate=rate,
        speed=_before(roll, trip_deceleration, trip_distance),
        checks=()
        if curve is None or radius is None
        else balance(
            "moments about the outer wheels", curve * curve, gravity * radius * tip, curve * curve, curve, radius
        ),
        advice=grade_advice(superelevation, "superelevation") + _advice(stability),
    )


def _tip(stability: float, bank: float) -> float:
    """Lateral acceleration over gravity at which the load leaves the inner wheels."""
    over, under = stability + bank, multiply_add(-stability, bank, 1.0)
    require(
        over > 0.0, "on a superelevation of {bank} the vehicle tips by itself: its stability factor is {factor}",
        bank=(bank, Slope), factor=(stability, Ratio), code="tips-alone",
    )  # fmt: skip
    require(
        under > 0.0, "on a superelevation of {bank} no speed tips the vehicle: 1 - S·e is {under}",
        bank=(bank, Slope), under=(under, Ratio), code="never-tips",
    )  # fmt: skip
    return over / under


def _trips(
    half: float, height: float, gyration: "float | None", deceleration: "float | None", gravity: float
) -> "tuple[float | None, tuple[float | None, float | None, float | None]]":
    """Speeds that trip at a kerb and in soil, where the roll gyration radius is known."""
    if gyration is None:
        return None, (None, None, None)
    radius = hypot(half, height)
    turning = gyration * gyration + radius * radius
    kerb = kerb_speed(half, height, turning, gravity)
    if deceleration is None:
        return kerb, (None, None, None)
    return kerb, soil_trip(half, height, turning, deceleration, gravity)


def _roll(
    distance: "float | None", drag: "float | None", turns: "float | None", gravity: float
) -> "tuple[float | None, float | None, float | None]":
    """Speed at the beginning of the rolling, its time and its mean rate."""
    together = (distance is None) == (drag is None)
    require_given(together, "the speed of rolling needs its distance and its drag", ("roll_distance", "roll_drag"))
    require_given(
        turns is None or distance is not None, "the roll rate needs the rolling", ("roll_distance", "roll_drag")
    )
    if distance is None or drag is None:
        return None, None, None
    require((distance > 0.0) & (drag > 0.0), "roll distance and roll drag must be more than zero", code="no-roll")
    speed = sqrt(2.0 * gravity * drag * distance)
    time = 2.0 * distance / speed
    return speed, time, None if turns is None else 2.0 * pi_beside(turns, time) * turns / time


def _before(roll: "float | None", deceleration: "float | None", distance: "float | None") -> "float | None":
    """Speed where the trip began, from the speed at which the rolling began."""
    if distance is None:
        return None
    require_given(
        roll is not None and deceleration is not None,
        "the speed before the trip needs its deceleration and the rolling",
        ("trip_deceleration", "roll_distance", "roll_drag"),
    )  # fmt: skip
    assert roll is not None
    assert deceleration is not None
    return hypot(roll, sqrt(2.0 * deceleration * distance))


def _advice(stability: float) -> tuple[Advice, ...]:
    if not single(stability):
        return ()
    message = "a rigid vehicle: suspension and tyres give way, and a real one tips at less"
    notes = [Advice(code="rigid", message=message, severity="note")]
    if not 0.3 <= plain(stability) <= 3.0:
        notes.insert(
            0,
            Advice(
                code="unlikely-stability",
                message="road vehicles have stability factors from about 0.4 (trucks) to 1.6 (cars)",
                remedy="check track width and height of the mass centre",
            ),
        )
    return tuple(notes)
