"""The task `curve`: motion along formulas or a named curve, its arc length, extremes, cusps and inflections."""

import math

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.number import is_many, plain
from dynamics_cli.numerics.vectors import length
from dynamics_cli.path.bends import advice_of, along_and_across
from dynamics_cli.path.curves.events import Event, arc_lengths, events
from dynamics_cli.path.curves.moving_point import MovingPoint, State
from dynamics_cli.path.curves.named import Shape
from dynamics_cli.quantities import (
    Acceleration,
    AccelerationVector,
    Angle,
    AngleFormula,
    Annotated,
    Count,
    Curvature,
    Distance,
    Jerk,
    Length,
    LengthFormula,
    Position,
    Speed,
    Time,
    Variable,
    Velocity,
)
from dynamics_cli.records import Advice, Check, ErrorBound, Formula, Numerics, record
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_STEPS = 2000
# An arc length less certain than this share of it is reported as uncertain.
LOOSE = 1e-6
DUST = 4e-15


@record
class Point:
    """One row of the motion."""

    time: Annotated[Time, "Time [s]."]
    x: Annotated[Length, "Along x [m]."]
    y: Annotated[Length, "Along y [m]."]
    z: Annotated[Length | None, "Along z, for curves in space [m]."]
    speed: Annotated[Speed, "Speed [m/s]."]
    tangential: Annotated[Acceleration | None, "Tangential acceleration [m/s^2]."]
    normal: Annotated[Acceleration | None, "Normal acceleration [m/s^2]."]
    curvature: Annotated[Curvature | None, "Curvature [1/m]."]
    arc: Annotated[Distance, "Length of the path since the start [m]."]


@record
class CurveMotion:
    """The motion at one time, and over a range of times."""

    time: Annotated[Time, "The time of the state shown [s]."]
    position: Annotated[Position, "Position [m]."]
    velocity: Annotated[Velocity, "Velocity [m/s]."]
    acceleration: Annotated[AccelerationVector, "Acceleration [m/s^2]."]
    speed: Annotated[Speed, "Magnitude of the velocity [m/s]."]
    acceleration_size: Annotated[Acceleration, "Magnitude of the acceleration [m/s^2]."]
    tangential: Annotated[Acceleration | None, "Tangential acceleration a_t [m/s^2]."]
    normal: Annotated[Acceleration | None, "Normal acceleration a_n [m/s^2]."]
    radius_of_curvature: Annotated[Length | None, "Radius of curvature ρ [m]."]
    curvature: Annotated[Curvature | None, "Curvature κ [1/m]."]
    torsion: Annotated[Curvature | None, "Torsion τ, for curves in space [1/m]."]
    jerk_size: Annotated[Jerk, "Magnitude of the jerk [m/s^3]."]
    arc_length: Annotated[Distance | None, "Length of the path from the start to the end [m]."]
    events: Annotated[tuple[Event, ...] | None, "Extremes of speed and curvature, cusps and inflections."]
    points: Annotated[tuple[Point, ...], "The motion at equally spaced times."]
    radius: Annotated[Length | None, "Distance r from the z-axis, where it has a law [m]."] = None
    angle: Annotated[Angle | None, "Angle θ beside it [rad]."] = None
    radial_velocity: Annotated[Speed | None, "v_r = ṙ [m/s]."] = None
    transverse_velocity: Annotated[Speed | None, "v_θ = rθ̇ [m/s]."] = None
    radial_acceleration: Annotated[Acceleration | None, "a_r = r̈ − rθ̇² [m/s^2]."] = None
    transverse_acceleration: Annotated[Acceleration | None, "a_θ = rθ̈ + 2ṙθ̇ [m/s^2]."] = None
    coriolis: Annotated[Acceleration | None, "The term 2ṙθ̇ of it [m/s^2]."] = None
    numerics: Numerics | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def curve(
    *,
    x: Annotated[LengthFormula | None, "x as a function of the time t [s], e.g. 20*t m."] = None,
    y: Annotated[LengthFormula | None, "y as a function of t, e.g. 5*t - 4.9*t^2 m."] = None,
    z: Annotated[LengthFormula | None, "z as a function of t, e.g. exp(-t) m."] = None,
    shape: Annotated[Shape | None, "A curve by its name, in place of formulas."] = None,
    radius_law: Annotated[LengthFormula | None, "Or the distance r from the z-axis over t, e.g. 2 + 0.1*t m."] = None,
    angle_law: Annotated[
        AngleFormula | None, "Angle beside that distance or along a named curve, as a function of t, e.g. 90*t deg."
    ] = None,
    length_law: Annotated[LengthFormula | None, "Length or x along a named curve over t, e.g. 3*t m."] = None,
    let: Annotated[tuple[Variable, ...], "Variables of the formulas, e.g. a=3 m, w=2 rad/s."] = (),
    start: Annotated[Time, "Start of the range of times, e.g. 0 s."] = 0.0,
    end: Annotated[Time | None, "End of the range, where the state is shown, e.g. 5 s."] = None,
    at: Annotated[Time | None, "Another time at which to show the state, e.g. 2 s."] = None,
    steps: Annotated[Count, "Intervals of the table [-]."] = 10,
) -> CurveMotion:
    """Velocity, acceleration, curvature and torsion along a curve over time, with exact derivatives.

    Equation
    --------
    v = dr/dt, a = dv/dt, j = da/dt; a_t = v·a/‖v‖, a_n = ‖v×a‖/‖v‖, κ = ‖v×a‖/‖v‖³, τ = (v×a)·j/‖v×a‖²; s = ∫‖v‖dt.

    Raises
    ------
    UsageError
        When a formula cannot be read.
    InadmissibleError
        When a formula has a pole or a corner in the range, or times are not in order.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 3.2 to 3.6.

    Examples
    --------
    >>> from dynamics_cli.records import Formula
    >>> result = curve(x=Formula("t^2", 1.0, "m"), y=Formula("sin(3*t)", 1.0, "m"), end=0.8)
    >>> round(result.speed, 9)
    2.730154835
    """
    laws = {"radius law": radius_law, "angle law": angle_law, "length law": length_law}
    motion = moving_point({"x": x, "y": y, "z": z}, laws, shape, let)
    first, last, now = _range(start, end, at, steps)
    complete = not (drawing() or is_many(now))
    if complete:
        motion.check(first, last)
    state = motion.sharp(now)
    bend = state.bend
    lengths: tuple[float | None, float] = (None, 0.0)
    events_met: tuple[Event, ...] = ()
    rows: tuple[Point, ...] = ()
    if not is_many(now) and drawing() and last > first:
        arcs, doubt = arc_lengths(motion.plainly(), [first, last])
        lengths = (arcs[-1], doubt)
    elif complete and last > first:
        plainly = motion.plainly()
        times = [first + (last - first) * i / steps for i in range(steps)] + [last]
        arcs, doubt = arc_lengths(plainly, times)
        rows = tuple(_row(plainly.sharp(time), time, arc, plainly.flat) for time, arc in zip(times, arcs, strict=True))
        events_met = events(plainly, first, last)
        lengths = (arcs[-1], doubt)
    names = ("radius_of_curvature", *(() if motion.flat else ("torsion",)), "tangential", "normal", "curvature")
    return CurveMotion(
        time=now,
        position=state.position,
        velocity=state.velocity,
        acceleration=state.acceleration,
        **along_and_across(bend),
        **(_turning(motion, now) if motion.turns else {}),
        acceleration_size=bend.magnitude,
        curvature=bend.curvature,
        torsion=None if motion.flat else bend.torsion,
        jerk_size=length(state.jerk),
        arc_length=lengths[0],
        events=events_met or None,
        points=rows,
        numerics=_numerics(lengths),
        advice=(*advice_of(bend, *names), *_loose(lengths)),
    )


def moving_point(
    places: "dict[str, Formula | None]", laws: "dict[str, Formula | None]", shape: "Any", let: "tuple[Variable, ...]"
) -> MovingPoint:
    """The motion by formulas of its coordinates, of its distance and angle with its height, or along a named curve."""
    if laws["radius law"] is None:
        return MovingPoint(places, shape, _parameter(shape, laws["angle law"], laws["length law"]), let)
    require(
        laws["angle law"] is not None and shape is None and not any((places["x"], places["y"], laws["length law"])),
        "a law of the radius goes with one of the angle, in place of x, y and a named curve",
        code="motion",
        hint="--radius-law '2 + 0.1*t m' --angle-law '3*t rad'",
    )
    return MovingPoint({**laws, "z": places["z"]}, None, None, let)


def _turning(motion: MovingPoint, now: "Any") -> "dict[str, Any]":
    """Parts of velocity and acceleration along and across the line from the z-axis."""
    (r, angle), (growth, rate), (bend, gain) = motion.turning(now)
    coriolis = 2.0 * growth * rate
    return {
        "radius": r,
        "angle": angle,
        "radial_velocity": growth,
        "transverse_velocity": r * rate,
        "radial_acceleration": bend - r * (rate * rate),
        "transverse_acceleration": r * gain + coriolis,
        "coriolis": coriolis,
    }


def _parameter(shape: "Any", angle: Formula | None, along: Formula | None) -> Formula | None:
    laws = [name for name, law in (("angle", angle), ("length", along)) if law is not None]
    require(len(laws) < 2, "a curve has one parameter: angle law and length law are both given", code="exclusive")
    if not laws:
        return None
    require(shape is not None, "a law of the {law} needs a named curve", code="law", hint="--curve circle", law=laws[0])
    require(
        shape.parameter in (laws[0], "time"),
        "the parameter of this curve is its {wanted}",
        code="law",
        hint="give --{wanted}-law",
        wanted=shape.parameter,
    )
    require(shape.parameter != "time", "the parameter of this curve is the time itself: it has no law", code="law")
    return angle if angle is not None else along


def _range(start: "Any", end: "Any", at: "Any", steps: int) -> "tuple[float, float, Any]":
    require(1 <= steps <= MOST_STEPS, "the table cannot have {steps} intervals", code="steps", steps=steps,
            hint=f"give 1 to {MOST_STEPS}")  # fmt: skip
    require(end is not None or at is not None, "a time is missing", code="missing", hint="--end '5 s', or --at '2 s'")
    now = at if at is not None else end
    last = plain(end if end is not None else at)
    first = plain(start)
    require(
        first <= last,
        "the range of times ends at {end}, before it starts at {start}",
        code="times",
        hint="exchange --start and --end",
        end=(last, Time),
        start=(first, Time),
    )
    require(
        first <= plain(now) <= last,
        "the time of {at} is not in the range from {start} to {end}",
        code="times",
        hint="leave out start and end, or widen them",
        at=(plain(now), Time),
        start=(first, Time),
        end=(last, Time),
    )
    return first, last, now


def _row(state: State, time: float, arc: float, flat: bool) -> Point:
    motion = state.bend
    size = math.hypot(*state.position)
    x, y, z = (_without_dust(part, size) for part in state.position)
    tangential = None if motion.tangential is None else _without_dust(motion.tangential, motion.magnitude)
    return Point(time, x, y, None if flat else z, motion.speed, tangential, motion.normal, motion.curvature, arc)


def _without_dust(part: float, size: float) -> float:
    """Zero for values within the rounding of times and variables, relative to a size."""
    return 0.0 if abs(part) < DUST * size else part


def _numerics(lengths: "tuple[float | None, float]") -> Numerics | None:
    if lengths[0] is None:
        return None
    method = "Taylor jets (exact derivatives); arc length by Gauss–Legendre, its error estimated by halving"
    return Numerics(method, (ErrorBound("arc_length", lengths[1], relative=False),))


def _loose(lengths: "tuple[float | None, float]") -> tuple[Advice, ...]:
    """That the motion changes too often for the range of times."""
    if lengths[0] is None or lengths[1] <= LOOSE * lengths[0]:
        return ()
    message = worded(
        "the motion changes too often in this range of times: the length of the path is known to {doubt:2} only, and "
        "events may be missed",
        doubt=(lengths[1], Length),
    )
    return (Advice("busy", message, remedy="take a shorter range of times"),)
