"""A whole revolution of cam motion as a user reads it: table, extremes, joints, the book's singularity functions."""

from itertools import pairwise
from math import pi

from dynamics_cli.cam.motion import Motion
from dynamics_cli.cam.program import Program, motion_of
from dynamics_cli.cam.revolution_records import (
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
from dynamics_cli.cam.slips import of_part
from dynamics_cli.cam.survey import Extreme, extreme, jumps, order_of_continuity, root_mean_square
from dynamics_cli.errors import require
from dynamics_cli.quantities import (
    Count,
    ShaftSpeed,
    Text,
)
from dynamics_cli.records import Advice, Check, Columns, ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_POINTS = 1_000_001
ROUNDING = 2.0**-52
UNIT = 2.0**-53
NAMES = ("lift", "velocity", "acceleration", "jerk")


def motion(
    scene: Program,
    /,
    *,
    program: Text = "",
    count: Count = 37,
    shaft_speed: ShaftSpeed | None = None,
    singularity: bool = False,
) -> Revolution:
    """One revolution of cam motion: extremes, jumps at every joint, root mean square, and the table of s, v, a, j.

    Equation
    --------
    s(θ) = s_i + h_i f_i((θ − θ_i)/β_i) on segment i; a_rms² = (1/2π) ∮ (d²s/dθ²)² dθ.

    Parameters
    ----------
    scene : Program
        Segments from a file.
    program : Text
        Segments in one line: `rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg 3-4-5; dwell`.
    count : Count
        Points of the table, both ends of the turn among them.
    shaft_speed : ShaftSpeed
        Speed of the cam shaft, for values in time [rad/s].
    singularity : bool
        Also write the motion in the book's singularity functions, and show that they agree.

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
    Where a derivative jumps the table gives the later value, and the joints give the jump.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.9 to 16.14.

    Examples
    --------
    >>> found = motion(Program(), program="rise 20 mm in 90 deg; dwell 60 deg; return in 90 deg; dwell")
    >>> found.continuity, found.lift.greatest
    ('C2', 0.02)
    """
    require(2 <= count <= MOST_POINTS, "a table has 2 to {0} points, not {1}", MOST_POINTS, count, code="count")
    found = motion_of(scene, program)
    ends = [extreme(found, order) for order in range(4)]
    steps = jumps(found)
    rms, rms_error = root_mean_square(found, 2)
    order = order_of_continuity(steps)
    form = _form(found) if singularity else None
    checks = [_closing(found)]
    if form is not None:
        worst = form.disagreement()
        checks.append(Check("singularity functions agree with the motion", worst <= 1e-10, worst, 1e-10))
    swing = found.swing
    tables = _table(found, count)
    return Revolution(
        f"C{order}",
        None if swing else LiftRange(*_fields(ends[0])),
        None if swing else VelocityRange(*_fields(ends[1])),
        None if swing else AccelerationRange(*_fields(ends[2])),
        None if swing else JerkRange(*_fields(ends[3])),
        None if swing else rms,
        _swing(ends) if swing else None,
        rms if swing else None,
        None if swing else _in_time(ends, rms, shaft_speed),
        _swing_in_time(ends, rms, shaft_speed) if swing else None,
        None if swing else tuple(Joint(angle, words, *jump) for angle, words, jump in steps),
        tuple(SwingJoint(angle, words, *jump) for angle, words, jump in steps) if swing else None,
        None if form is None else form.written(),
        *tables,
        checks=tuple(checks),
        advice=_advice(order, steps),
        numerics=_numerics(found, ends, (rms, rms_error), tables[1 if swing else 0], shaft_speed),
    )


def _fields(one: Extreme) -> "tuple[float, float, float, float]":
    return one.least, one.least_at, one.greatest, one.greatest_at


def _form(found: Motion) -> "Any":
    from dynamics_cli.cam.singularity import Form

    return Form(found)


def _closing(found: Motion) -> Check:
    """The end of the turn is its start, to the bit."""
    gap = abs(found.in_zone(len(found.zones) - 1, 1.0, 0)[0] - found.in_zone(0, 0.0, 0)[0])
    return Check("the lift closes over the turn", gap == 0.0, gap, 0.0)


def angles_of_turn(found: Motion, count: int) -> "tuple[Any, Any]":
    """Equal steps over one turn, both ends among them; whole degrees land on the joints as the program gives them."""
    import numpy as np

    top, bottom = found.segments[0].start
    first = top / bottom
    degrees = first + np.arange(count) * 360.0 / (count - 1)
    angles = np.array([_radians(degree) for degree in degrees.tolist()]) if count <= 4000 else np.radians(degrees)
    angles[0], angles[-1] = found.joints[0], found.joints[-1]
    return angles, degrees


def _radians(degrees: float) -> float:
    from dynamics_cli.cam.motion import radians

    return radians(degrees.as_integer_ratio())[0]


def _table(found: Motion, count: int) -> "tuple[Any, Any]":
    angles, _ = angles_of_turn(found, count)
    values = [column.copy() for column in found.at(angles, 4)]
    last = found.at(float(angles[-1]), 4, side=-1)
    for column, value in zip(values, last, strict=True):
        column[-1] = value
    # an angle is a double: where a value is less than its change over the angle's rounding, it is zero
    for column, slope in pairwise(values):
        column[abs(column) <= ROUNDING * abs(angles * slope)] = 0.0
    names = ("swing" if found.swing else "lift", *NAMES[1:])
    # minus zero is zero
    columns = {name: column + 0.0 for name, column in zip(names, values[:4], strict=True)}
    if found.swing:
        return None, Columns(SwingPoint, angle=angles, **columns)
    return Columns(MotionPoint, angle=angles, **columns), None


def _greatest(one: Extreme) -> float:
    return max(abs(one.least), abs(one.greatest))


def _swing(ends: "list[Extreme]") -> SwingRange:
    lift, velocity, acceleration, jerk = ends
    return SwingRange(
        *_fields(lift),
        velocity.least, velocity.greatest,
        acceleration.least, acceleration.greatest,
        jerk.least, jerk.greatest,
    )  # fmt: skip


def _in_time(ends: "list[Extreme]", rms: float, omega: float | None) -> InTime | None:
    if omega is None:
        return None
    w = abs(omega)
    return InTime(_greatest(ends[1]) * w, _greatest(ends[2]) * w * w, _greatest(ends[3]) * w * w * w, rms * w * w)


def _swing_in_time(ends: "list[Extreme]", rms: float, omega: float | None) -> SwingInTime | None:
    if omega is None:
        return None
    w = abs(omega)
    return SwingInTime(_greatest(ends[1]) * w, _greatest(ends[2]) * w * w, rms * w * w)


def _advice(order: int, steps: "list[tuple[float, str, list[float]]]") -> "tuple[Advice, ...]":
    if order >= 2:
        return ()
    angle, words, _ = next(step for step in steps if step[2][order + 1])
    what, then = (("velocity", "the acceleration is infinite"), ("acceleration", "the jerk is infinite"))[max(order, 0)]
    return (
        Advice(
            code=f"{what}-jumps",
            message=f"the {what} jumps at {angle * 180.0 / pi:.6g} deg ({words}): {then} there",
            severity="serious" if order < 1 else "caution",
            mend="take a law of higher continuity, or a polynomial, which meets the state of its neighbours",
        ),
    )


def _numerics(
    found: Motion, ends: "list[Extreme]", rms: tuple[float, float], table: "Any", omega: float | None
) -> Numerics:
    """Bounds of the extremes, of the mean, and of every column of the table."""
    if found.swing:
        names = ["swing.{}", *(f"swing.{{}}_{name}" for name in NAMES[1:])]
    else:
        names = [f"{name}.{{}}" for name in NAMES]
    made = []
    for name, one in zip(names, ends, strict=True):
        made.append(ErrorBound(name.format("least"), one.least_error, relative=False))
        made.append(ErrorBound(name.format("greatest"), one.greatest_error, relative=False))
    made.append(ErrorBound("rms_swing_acceleration" if found.swing else "rms_acceleration", rms[1], relative=False))
    first = ("swing" if found.swing else "lift", *NAMES[1:])
    address = "swing_table" if found.swing else "table"
    made += [
        ErrorBound(f"{address}.{name}", error, relative=False)
        for name, error in zip(first, _column_errors(found, table), strict=True)
    ]
    if omega is not None:
        made += _in_time_bounds(found.swing, ends, rms, abs(omega))
    return Numerics(
        "closed form from the nearer end of each segment, its roundings followed; exact table of segments in degrees",
        tuple(made),
    )


def _in_time_bounds(swing: bool, ends: "list[Extreme]", rms: tuple[float, float], rate: float) -> "list[ErrorBound]":
    address = "swing_in_time" if swing else "in_time"
    made = []
    for order, name in enumerate(("speed", "acceleration") if swing else ("speed", "acceleration", "jerk"), 1):
        one = ends[order]
        error = max(one.least_error, one.greatest_error) + (order + 1.0) * UNIT * _greatest(one)
        made.append(ErrorBound(f"{address}.{name}", error * rate**order, relative=False))
    error = (rms[1] + 3.0 * UNIT * rms[0]) * rate * rate
    return [*made, ErrorBound(f"{address}.rms_acceleration", error, relative=False)]


def _column_errors(found: Motion, table: "Any") -> "list[float]":
    """What lift and derivatives of a table may be off, at the worst of its rows."""
    import numpy as np

    arrays = table.arrays
    angles = arrays["angle"]
    worst = [0.0] * 4
    values = [arrays[name] for name in arrays if name != "angle"]
    for part, rows in found.by_parts(angles):
        t = np.abs(part.local(angles[rows].copy())) if part.law_piece is not None else np.zeros(rows.shape)
        steep = [np.abs(value) for value in part.give(t, 4)]
        for order, error in enumerate(of_part(part, t)):
            # less than its change over the rounding of the angle is shown as zero
            still = 2.0 * ROUNDING * np.abs(angles[rows]) * steep[order + 1]
            own = error + np.where(values[order][rows] == 0.0, still, 0.0)
            worst[order] = max(worst[order], float(own.max()))
    return worst
