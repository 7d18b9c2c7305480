"""A whole revolution of cam motion as reported: table, extremes, joints, the book's singularity functions."""

from itertools import pairwise

from dynamics_cli.cam.laws.rounded_points import rounding_advice
from dynamics_cli.cam.program.motion import Motion
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.cam.program.revolution_records import (
    AccelerationRange,
    InTime,
    JerkRange,
    Joint,
    LiftRange,
    MotionPoint,
    Revolution,
    SwingInTime,
    SwingJoint,
    SwingPoint,
    SwingRange,
    VelocityRange,
)
from dynamics_cli.cam.program.summary import Extreme, extreme, jumps, order_of_continuity, root_mean_square
from dynamics_cli.errors import require, worded
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Count,
    ShaftSpeed,
    Text,
)
from dynamics_cli.records import Advice, Check, Columns, ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Impulses = tuple[float | None, float | None]

MOST_POINTS = 1_000_001
ROUNDING = 2.0**-52
UNIT = 2.0**-53
NAMES = ("lift", "velocity", "acceleration", "jerk")


def motion(
    scene: Annotated[Program, "One turn of the cam in segments, from a file."],
    /,
    *,
    program: Annotated[Text, "Segments in one line, in place of a file."] = "",
    count: Annotated[Count, "Points of the table, including both ends of the turn."] = 37,
    at: Annotated[tuple[Angle, ...], "Cam angles of the table, in place of its count, e.g. 30, 45 deg [rad]."] = (),
    shaft_speed: Annotated[ShaftSpeed | None, "Speed of the cam shaft, for values in time [rad/s]."] = None,
    singularity: Annotated[
        bool, "Also write the motion in the book's singularity functions, and show that they agree."
    ] = False,
) -> Revolution:
    """One revolution of cam motion: extremes, jumps at every joint, root mean square, and the table of s, v, a, j.

    Equation
    --------
    s(θ) = s_i + h_i f_i((θ − θ_i)/β_i) on segment i; a_rms² = (1/2π) ∮ (d²s/dθ²)² dθ.

    Returns
    -------
    Revolution
        Extremes, joints and table; for an arm (a program in angles) those of its swing.

    Raises
    ------
    InadmissibleError
        When spans do not make one turn, the motion does not close, or a law lacks what it needs.

    Notes
    -----
    Where a derivative jumps the table gives the later value, and the joints give the jump. Where the velocity jumps the
    acceleration is an impulse: it has no extreme in that sense and no mean square; the extreme's place is that of the
    first such jump.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.9 to 16.14.

    Examples
    --------
    >>> result = motion(Program(), program="rise 20 mm in 90 deg; dwell 60 deg; return in 90 deg; dwell")
    >>> result.continuity, result.lift.greatest
    ('C2', 0.02)
    """
    require(
        2 <= count <= MOST_POINTS,
        "count: {count} points; a table has 2 to {most}",
        count=count, most=MOST_POINTS, code="count",
    )  # fmt: skip
    turn = motion_of(scene, program)
    ends = [extreme(turn, order) for order in range(4)]
    steps = jumps(turn)
    impulse = _impulses(steps)
    finite = impulse == (None, None)
    rms, rms_error = root_mean_square(turn, 2)
    order = order_of_continuity(steps)
    form = _form(turn) if singularity else None
    checks = [_closing(turn)]
    if form is not None:
        worst = form.disagreement()
        checks.append(Check("singularity functions agree with the motion", worst <= 1e-10, worst, 1e-10))
    swing = turn.swing
    tables = _table(turn, _angles(turn, at) if at else angles_of_turn(turn, count)[0])
    return Revolution(
        f"C{order}",
        None if swing else LiftRange(*_fields(ends[0])),
        None if swing else VelocityRange(*_fields(ends[1])),
        None if swing else AccelerationRange(*_with_impulses(ends[2], impulse)),
        None if swing else JerkRange(*_fields(ends[3])),
        rms if finite and not swing else None,
        _swing(ends, impulse) if swing else None,
        rms if finite and swing else None,
        None if swing else _in_time(ends, rms, shaft_speed, finite=finite),
        _swing_in_time(ends, rms, shaft_speed, finite=finite) if swing else None,
        None if swing else tuple(Joint(angle, words, *jump) for angle, words, jump in steps),
        tuple(SwingJoint(angle, words, *jump) for angle, words, jump in steps) if swing else None,
        None if form is None else form.written(),
        *tables,
        checks=tuple(checks),
        advice=(
            *_advice(order, steps, rows=any(span.law and span.law.steps for span in turn.segments)),
            *_missing(impulse, swing=swing, timed=shaft_speed is not None),
            *(
                advice
                for i, span in enumerate(turn.segments, 1)
                if span.law
                for advice in rounding_advice(span.law, f"segment {i}: ")
            ),
        ),
        numerics=_numerics(turn, ends, (rms, rms_error), tables[1 if swing else 0], shaft_speed, impulse),
    )


def _fields(extreme: Extreme) -> "tuple[float, float, float, float]":
    return extreme.least, extreme.least_at, extreme.greatest, extreme.greatest_at


def _impulses(steps: "list[tuple[float, str, list[float]]]") -> "Impulses":
    """Cam angles at which the velocity first jumps down and first jumps up: there the acceleration is an impulse."""
    down, up = ([angle for angle, _, jump in steps if sign * jump[1] > 0.0] for sign in (-1.0, 1.0))
    return (down[0] if down else None), (up[0] if up else None)


def _with_impulses(extreme: Extreme, impulse: "Impulses") -> "tuple[float | None, float, float | None, float]":
    """Extremes of the acceleration; an impulse has a place but no value."""
    down, up = impulse
    least = (extreme.least, extreme.least_at) if down is None else (None, down)
    greatest = (extreme.greatest, extreme.greatest_at) if up is None else (None, up)
    return *least, *greatest


def _form(turn: Motion) -> "Any":
    from dynamics_cli.cam.program.singularity import Form

    return Form(turn)


def _closing(turn: Motion) -> Check:
    """Check that the end of the turn equals its start to the bit."""
    gap = abs(turn.in_zone(len(turn.zones) - 1, 1.0, 0)[0] - turn.in_zone(0, 0.0, 0)[0])
    return Check("the lift closes over the turn", gap == 0.0, gap, 0.0)


def angles_of_turn(turn: Motion, count: int) -> "tuple[Any, Any]":
    """Equal steps over one turn, including both ends; whole degrees land on the joints as the program gives them."""
    import numpy as np

    top, bottom = turn.segments[0].start
    first = top / bottom
    degrees = first + np.arange(count) * 360.0 / (count - 1)
    angles = np.array([_radians(degree) for degree in degrees.tolist()]) if count <= 4000 else np.radians(degrees)
    angles[0], angles[-1] = turn.joints[0], turn.joints[-1]
    return angles, degrees


def _radians(degrees: float) -> float:
    from dynamics_cli.cam.program.parts import radians

    return radians(degrees.as_integer_ratio())[0]


def _angles(turn: Motion, at: "tuple[float, ...]") -> "Any":
    """The cam angles asked for, in order; each within the turn."""
    import numpy as np

    first, last = turn.joints[0], turn.joints[-1]
    for angle in at:
        require(
            first <= angle <= last,
            "the cam angle {angle:6} is outside the turn from {first:6} to {last:6}",
            angle=(angle, Angle),
            first=(first, Angle),
            last=(last, Angle),
            code="at",
        )
    return np.array(sorted(at))


def _table(turn: Motion, angles: "Any") -> "tuple[Any, Any]":
    values = [column.copy() for column in turn.at(angles, 4)]
    if angles[-1] == turn.joints[-1]:
        last = turn.at(float(angles[-1]), 4, side=-1)
        for column, value in zip(values, last, strict=True):
            column[-1] = value
    # an angle is a double: a value below its change over the angle's rounding is zero
    for column, slope in pairwise(values):
        column[abs(column) <= 2.0 * ROUNDING * abs(angles * slope)] = 0.0
    names = ("swing" if turn.swing else "lift", *NAMES[1:])
    # minus zero is zero
    columns = {name: column + 0.0 for name, column in zip(names, values[:4], strict=True)}
    if turn.swing:
        return None, Columns(SwingPoint, angle=angles, **columns)
    return Columns(MotionPoint, angle=angles, **columns), None


def _greatest(extreme: Extreme) -> float:
    return max(abs(extreme.least), abs(extreme.greatest))


def _swing(ends: "list[Extreme]", impulse: "Impulses") -> SwingRange:
    lift, velocity, acceleration, jerk = ends
    least, _, greatest, _ = _with_impulses(acceleration, impulse)
    return SwingRange(
        *_fields(lift),
        velocity.least, velocity.greatest,
        least, greatest,
        jerk.least, jerk.greatest,
    )  # fmt: skip


def _in_time(ends: "list[Extreme]", rms: float, omega: float | None, *, finite: bool) -> InTime | None:
    if omega is None:
        return None
    w = abs(omega)
    acceleration = _greatest(ends[2]) * w * w if finite else None
    return InTime(_greatest(ends[1]) * w, acceleration, _greatest(ends[3]) * w * w * w, rms * w * w if finite else None)


def _swing_in_time(ends: "list[Extreme]", rms: float, omega: float | None, *, finite: bool) -> SwingInTime | None:
    if omega is None:
        return None
    w = abs(omega)
    acceleration = _greatest(ends[2]) * w * w if finite else None
    return SwingInTime(_greatest(ends[1]) * w, acceleration, rms * w * w if finite else None)


def _missing(impulse: "Impulses", *, swing: bool, timed: bool) -> "tuple[Advice, ...]":
    """Which accelerations have no value because the velocity jumps."""
    if impulse == (None, None):
        return ()
    missing: list[tuple[str, str]] = []
    for name, angle in zip(("least", "greatest"), impulse, strict=True):
        if angle is not None:
            result = f"swing.{name}_acceleration" if swing else f"acceleration.{name}"
            message = worded(
                "the acceleration has no {name}: it is an impulse where the velocity jumps, at {angle:6}",
                name="minimum" if name == "least" else "maximum",
                angle=(angle, Angle),
            )
            missing.append((result, message))
    mean = "the root mean square of the acceleration is infinite: the velocity jumps"
    missing.append(("rms_swing_acceleration" if swing else "rms_acceleration", mean))
    if timed:
        address = "swing_in_time" if swing else "in_time"
        missing.append((f"{address}.acceleration", "the acceleration in time is infinite where the velocity jumps"))
        missing.append((f"{address}.rms_acceleration", mean))
    return tuple(Advice("infinite-acceleration", message, "serious", result=result) for result, message in missing)


def _advice(order: int, steps: "list[tuple[float, str, list[float]]]", *, rows: bool) -> "tuple[Advice, ...]":
    """The first jump of velocity or acceleration; splines through `rows` have small ones at the ends of dwells."""
    if order >= 2:
        return ()
    angle, words, _ = next(step for step in steps if step[2][order + 1])
    quantity, infinite = ("velocity", "acceleration") if order < 1 else ("acceleration", "jerk")
    message = worded(
        "the {what} jumps at {angle:6} ({words}): the {infinite} is infinite there",
        what=quantity,
        angle=(angle, Angle),
        words=words,
        infinite=infinite,
    )
    remedy = "take a law of higher continuity, or a polynomial, which meets the state of its neighbours"
    if rows:
        remedy = "give rows closer together there, or a law"
    return (Advice(f"{quantity}-jumps", message, "serious" if order < 1 else "note" if rows else "caution", remedy),)


def _numerics(
    turn: Motion, ends: "list[Extreme]", rms: tuple[float, float], table: "Any", omega: float | None,
    impulse: "Impulses",
) -> Numerics:  # fmt: skip
    """Bounds of the extremes, of the mean, and of every column of the table."""
    from dynamics_cli.cam.program.pieces import column_errors

    if turn.swing:
        names = ["swing.{}", *(f"swing.{{}}_{name}" for name in NAMES[1:])]
    else:
        names = [f"{name}.{{}}" for name in NAMES]
    bounds = []
    for order, (name, ends_of) in enumerate(zip(names, ends, strict=True)):
        least, greatest = impulse if order == 2 else (None, None)
        if least is None:
            bounds.append(ErrorBound(name.format("least"), ends_of.least_error, relative=False))
        if greatest is None:
            bounds.append(ErrorBound(name.format("greatest"), ends_of.greatest_error, relative=False))
    finite = impulse == (None, None)
    if finite:
        name = "rms_swing_acceleration" if turn.swing else "rms_acceleration"
        bounds.append(ErrorBound(name, rms[1], relative=False))
    first = ("swing" if turn.swing else "lift", *NAMES[1:])
    address = "swing_table" if turn.swing else "table"
    bounds += [
        ErrorBound(f"{address}.{name}", error, relative=False)
        for name, error in zip(first, column_errors(turn, table), strict=True)
    ]
    if omega is not None:
        bounds += _in_time_bounds(turn.swing, ends, rms, abs(omega), finite=finite)
    return Numerics(
        "closed form from the nearer end of each segment, rounding bounded; exact table of segments in degrees",
        tuple(bounds),
    )


def _in_time_bounds(
    swing: bool, ends: "list[Extreme]", rms: tuple[float, float], rate: float, *, finite: bool
) -> "list[ErrorBound]":
    address = "swing_in_time" if swing else "in_time"
    in_time_bounds = []
    for order, name in enumerate(("speed", "acceleration") if swing else ("speed", "acceleration", "jerk"), 1):
        if order == 2 and not finite:
            continue
        extreme = ends[order]
        error = max(extreme.least_error, extreme.greatest_error) + (order + 1.0) * UNIT * _greatest(extreme)
        in_time_bounds.append(ErrorBound(f"{address}.{name}", error * rate**order, relative=False))
    if not finite:
        return in_time_bounds
    error = (rms[1] + 3.0 * UNIT * rms[0]) * rate * rate
    return [*in_time_bounds, ErrorBound(f"{address}.rms_acceleration", error, relative=False)]
