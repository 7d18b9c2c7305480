"""A crash from one vehicle's recorded ΔV: the other vehicle's change, closing speed, and its speed before."""

from dynamics_cli.errors import judge, require
from dynamics_cli.impact.conventions import AXES, PDOF_ZERO, Axes, PdofZero, direction_of
from dynamics_cli.impact.recorded.answer import Found, answer
from dynamics_cli.impact.recorded.records import Partner, Recorder, RecordResult
from dynamics_cli.impact.recorded.scene import Crash, Pair, plus, slopes
from dynamics_cli.numerics.elementary import absolute, cos, maximum, minimum, sin, where
from dynamics_cli.numerics.number import single
from dynamics_cli.numerics.vectors import planar_cross as cross
from dynamics_cli.numerics.vectors import planar_dot as dot
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Fraction,
    Gravity,
    PlanarPosition,
    Ratio,
    Restitution,
    RoadSpeed,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

# Sine of 5 degrees: nearly perpendicular to the normal, restitution does not determine a speed.
ALONG_THE_SURFACE = 0.08715574274765817
DEGREE = 0.017453292519943295
HALF_TURN = 3.141592653589793


def head_on(
    *,
    first: Annotated[Recorder, "The vehicle with the recorder."],
    second: Annotated[Partner, "The other vehicle."],
    least_restitution: Annotated[Restitution | None, "Lowest restitution that is possible, e.g. 0."] = None,
    greatest_restitution: Annotated[Restitution | None, "Highest restitution that is possible, e.g. 0.2."] = None,
    normal: Annotated[Angle | None, "Contact normal from the first vehicle to the second, e.g. 12 deg."] = None,
    contact_point: Annotated[PlanarPosition | None, "Place of the contact, where mass centres are placed."] = None,
    tolerance: Annotated[Fraction, "Limits of the recorded ΔV; 49 CFR 563.8 allows 10 %."] = 0.1,
    final_change: Annotated[
        RoadSpeed | None, "How far the recorded ΔV still changed over its last 20 ms, e.g. 2 km/h."
    ] = None,
    axes: Annotated[Axes, "Axes of velocities and headings: mathematical, compass, sae or iso."] = AXES,
    pdof_zero: Annotated[PdofZero, "Where a force of PDOF zero comes from: heading, travel or scene."] = PDOF_ZERO,
    gravity: Annotated[Gravity, "Acceleration of gravity, for vehicles given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> RecordResult:
    """Closing speed of vehicles that met in line, from the recorded ΔV of one and a range of restitution.

    Equation
    --------
    u = p·(1/(γ₁m₁) + 1/(γ₂m₂))/(1 + e), p = m₁ΔV₁, γ = k²/(k² + h²), h the lever arm of the line of force.

    Returns
    -------
    RecordResult
        ΔV of both, closing speed with its limits; the other's speed where that of the recorder's vehicle is given.

    Raises
    ------
    InadmissibleError
        When the range of restitution is missing, or the recorded ΔV is zero.

    References
    ----------
    49 CFR 563.8, table III: tolerance of ΔV. CRASH3 (NHTSA): effective mass with a lever arm.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> car, other = Recorder(ByMass(1500.0), -7.5), Partner(ByMass(1200.0))
    >>> round(head_on(first=car, second=other, least_restitution=0.0, greatest_restitution=0.2).closing_speed, 6)
    15.340909
    """
    crash = Crash(
        first, second, least_restitution, greatest_restitution, normal, contact_point, tolerance, final_change, axes,
        pdof_zero, gravity,
    )  # fmt: skip
    restitutions = _range(crash)
    inward = crash.impulse[0] / crash.size, crash.impulse[1] / crash.size
    gained = dot(crash.gained(), inward)
    closing, *ends = [gained / (1.0 + e) for e in restitutions]
    speeds = _limits(crash, lambda scale, k: scale * ends[k])
    velocity = None
    other: tuple[float, float, float] | None = None
    if crash.before is not None:
        along = dot(crash.contact(crash.one, crash.before), inward)
        lone = along - dot(crash.contact(crash.two, (0.0, 0.0)), inward)
        speed = lone + closing
        velocity = speed * inward[0], speed * inward[1]
        other = (speed, lone + speeds[0], lone + speeds[1])
    values = Found(inward, restitutions[0], closing, speeds, velocity, other, in_line=True)
    return answer(crash, values)


def by_restitution(
    *,
    first: Annotated[Recorder, "The vehicle with the recorder."],
    second: Annotated[Partner, "The other vehicle."],
    **circumstances: "Any",
) -> RecordResult:
    """Speed of the other vehicle from the recorded ΔV, the contact normal and a range of restitution, as `head_on`.

    Equation
    --------
    u_n = −(K·p)·n/(1 + e); v₂ = (V₁·n − u_n)/(d₂·n) at the contact, with the other's approach direction d₂.

    Returns
    -------
    RecordResult
        ΔV of both, closing speed and the other's speed with their limits, slip, spins, energy lost.

    Raises
    ------
    InadmissibleError
        When the speed before, the normal or the range of restitution is missing, the impulse would pull, the other came
        along the surface (within 5 degrees), or would have driven backwards.

    References
    ----------
    49 CFR 563.8, table III: tolerance of ΔV. R. M. Brach, R. M. Brach, Vehicle Accident Analysis and Reconstruction
    Methods, SAE 2011: planar impact mechanics.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> car = Recorder(ByMass(1500.0), -8.0, approach_speed=14.0)
    >>> other = Partner(ByMass(1200.0), approach_heading=3.141592653589793)
    >>> result = by_restitution(first=car, second=other, least_restitution=0.0, greatest_restitution=0.2, normal=0.0)
    >>> round(result.second.approach_speed, 6)
    2.363636
    """
    crash = Crash(first, second, **circumstances)
    before, travel = _planar(crash)
    require(
        crash.normal is not None,
        "restitution acts along the contact normal, which is not given",
        code="no-normal",
        hint="give the normal, or the exit heading of the second vehicle instead",
    )
    inward = _inward(crash)
    _require_push(crash, inward)
    restitutions = _range(crash)
    facing = dot(travel, inward)
    judge(
        absolute(facing) >= ALONG_THE_SURFACE,
        "the second vehicle came along the surface of contact, with only {sine:2} of its speed across it: restitution "
        "says nothing about its speed",
        sine=(absolute(facing), Ratio),
        hint="give its exit heading instead",
        results=("second.approach_speed",),
    )
    gained = dot(crash.gained(), inward)
    lone = dot(plus(crash.contact(crash.one, before), crash.contact(crash.two, (0.0, 0.0)), -1.0), inward)
    closing, *ends = [gained / (1.0 + e) for e in restitutions]
    speed = (lone + closing) / facing
    _require_forward(speed)
    speeds = _limits(crash, lambda scale, k: scale * ends[k])
    limits = _limits(crash, lambda scale, k: (lone + scale * ends[k]) / facing)
    velocity = speed * travel[0], speed * travel[1]
    approach, tilt = slopes(crash, inward, travel, before, restitutions[0], speed)
    steepest = maximum(maximum(approach, tilt), 1e-12 * (1.0 + speed))
    worst = where(approach >= tilt, "second.approach_heading", "normal")  # type: ignore[arg-type]
    bearing = minimum(0.1 * speed / steepest, HALF_TURN)
    values = Found(inward, restitutions[0], closing, speeds, velocity, (speed, *limits), bearing=bearing,
                   worst=str(worst) if single(worst) else None, per_degree=DEGREE * steepest)  # fmt: skip
    return answer(crash, values)


def by_headings(
    *,
    first: Annotated[Recorder, "The vehicle with the recorder."],
    second: Annotated[Partner, "The other vehicle."],
    **circumstances: "Any",
) -> RecordResult:
    """Speed of the other vehicle from the recorded ΔV and its headings before and after; parameters of `head_on`.

    Equation
    --------
    v₂ = −(ΔV₂ × d_β)/(d₂ × d_β), u₂ = (ΔV₂ × d₂)/(d_β × d₂), ΔV₂ = −m₁ΔV₁/m₂.

    Returns
    -------
    RecordResult
        ΔV of both, the other's speeds before and after; with the first's speed and the normal the implied restitution.

    Raises
    ------
    InadmissibleError
        When the directions before and after are the same, one degree changes the speed by a tenth, or the other vehicle
        would have driven backwards.

    References
    ----------
    49 CFR 563.8, table III: tolerance of ΔV. Conservation of momentum; cross products with the directions.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> car = Recorder(ByMass(1500.0), -8.0, approach_speed=14.0)
    >>> other = Partner(ByMass(1200.0), approach_heading=1.5707963267948966, exit_heading=0.7853981633974483)
    >>> round(by_headings(first=car, second=other).second.approach_speed, 6)
    10.0
    """
    crash = Crash(first, second, **circumstances)
    alpha, beta = second.approach_heading, second.exit_heading
    require(
        alpha is not None and beta is not None,
        "this needs the directions of travel of the second vehicle before and after",
        code="not-enough", hint="give its approach heading and exit heading",
    )  # fmt: skip
    travel, leaving = direction_of(alpha, crash.axes), direction_of(beta, crash.axes)  # type: ignore[arg-type]
    sine = cross(travel, leaving)
    require(
        absolute(sine) > 1e-12,
        "the second vehicle kept its direction: its headings do not give its speed", code="undetermined",
        hint="give the contact normal and a range of restitution instead of its exit heading",
    )  # fmt: skip
    speed = 0.0 - cross(crash.second_change, leaving) / sine
    after = 0.0 - cross(crash.second_change, travel) / sine
    _require_forward(speed)
    _require_forward(after, "leave")
    bend = beta - alpha  # type: ignore[operator]
    leaving_slope, coming_slope = after / absolute(sin(bend)), absolute(speed * cos(bend)) / absolute(sin(bend))
    steepest = maximum(leaving_slope, coming_slope)
    worst = where(leaving_slope >= coming_slope, "second.exit_heading", "second.approach_heading")  # type: ignore[arg-type]
    bearing = 0.1 * speed / steepest
    judge(
        bearing >= DEGREE,
        "these headings do not determine the speed of the second vehicle: {bearing:2} of error changes it by a tenth",
        bearing=(bearing, Angle),
        hint="give the contact normal and a range of restitution instead of its exit heading",
        results=("second.approach_speed",),
    )
    velocity = speed * travel[0], speed * travel[1]
    limits = _limits(crash, lambda scale, _: scale * speed)
    inward = restitution = closing = speeds = None
    if crash.normal is not None and crash.before is not None:
        inward = _inward(crash)
        _require_push(crash, inward)
        relative = plus(crash.contact(crash.one, crash.before), crash.contact(crash.two, velocity), -1.0)
        closing = 0.0 - dot(relative, inward)
        require(closing > 0.0, "along this normal the vehicles would part before they meet", code="pull")
        restitution = dot(crash.gained(), inward) / closing - 1.0
        lone = dot(relative, inward) + speed * dot(travel, inward)
        facing = dot(travel, inward)
        speeds = _limits(crash, lambda scale, _: scale * speed * facing - lone)
    values = Found(inward, restitution, closing, speeds, velocity, (speed, *limits), bearing=bearing,
                   worst=str(worst) if single(worst) else None, per_degree=DEGREE * steepest, bend=True)  # fmt: skip
    return answer(crash, values)


def in_line(*, second: Partner, **_: object) -> str | None:
    """Reason why only the closing speed can be answered."""
    return "no approach heading of the second is given: they met in line" if second.approach_heading is None else None


def restitution_decides(*, second: Partner, **_: object) -> str | None:
    """Reason why restitution applies."""
    return "no exit heading of the second is given: restitution decides" if second.exit_heading is None else None


def _planar(crash: Crash) -> "tuple[Pair, Pair]":
    """Velocity of the first before, and the direction from which the second came."""
    heading = crash.other.approach_heading
    require(
        crash.before is not None and heading is not None,
        "the speed of the second vehicle needs the approach speed of the first and the second's approach heading",
        code="not-enough",
        hint="give the first approach speed from the pre-crash record; a missing heading leaves the closing speed",
    )
    return crash.before, direction_of(heading, crash.axes)  # type: ignore[return-value,arg-type]


def _inward(crash: Crash) -> Pair:
    x, y = direction_of(crash.normal, crash.axes)  # type: ignore[arg-type]
    return 0.0 - x, 0.0 - y


def _require_push(crash: Crash, inward: Pair) -> None:
    push = dot(crash.impulse, inward) / crash.size
    require(
        push > 0.0,
        "the recorded ΔV would pull along this normal: its component from the second to the first is {push:3}",
        push=(push, Ratio),
        code="pull",
        hint="the normal points from the first vehicle to the second; ΔV ahead and to the left is positive",
    )


def _require_forward(speed: float, verb: str = "come") -> None:
    require(
        speed >= 0.0,
        "no crash can give this record: the second vehicle would {verb} backwards at {speed:3}",
        verb=verb,
        speed=(0.0 - speed, RoadSpeed),
        code="backwards",
        hint="check signs of ΔV, the nose and the headings, which are directions of travel",
    )


def _range(crash: Crash) -> "tuple[float, float, float]":
    """Middle, low and high of the restitution, the largest uncertainty of all."""
    low, high = crash.restitutions
    require(
        low is not None and high is not None,
        "the closing speed depends on restitution, 0.1 of which is 9 % of it: its range is not given",
        code="no-restitution",
        hint="give --least-restitution 0 --greatest-restitution 0.2, or what tests of such vehicles show",
    )
    require(low <= high, "the lowest restitution is above the highest", code="order")  # type: ignore[operator]
    return 0.5 * (low + high), low, high  # type: ignore[operator,return-value]


def _limits(crash: Crash, at: "Callable[[float, int], float]") -> "tuple[float, float]":
    """Lowest and highest of a quantity that is linear in the scale of the record, at the ends of restitution."""
    ends = [at(scale, k) for scale in (1.0 - crash.tolerance, 1.0 + crash.tolerance) for k in (0, 1)]
    low, high = ends[0], ends[0]
    for end in ends[1:]:
        low, high = minimum(low, end), maximum(high, end)
    return maximum(low, 0.0), high
