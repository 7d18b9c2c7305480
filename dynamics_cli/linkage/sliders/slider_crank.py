"""The slider-crank, in line or offset: one pose with velocity and acceleration, its stroke, or a table."""

from math import tau

from dynamics_cli.errors import require, worded
from dynamics_cli.linkage.fourbar.table import spread
from dynamics_cli.linkage.sliders.double_slider import require_long
from dynamics_cli.linkage.sliders.driven import LEFT, Pin, crank_of, rates_of
from dynamics_cli.linkage.sliders.stroke import RIGHT, End, fastest, slopes_at, stroke_of
from dynamics_cli.numerics.elementary import absolute, atan2, sqrt, where
from dynamics_cli.numerics.number import decides, plain, single
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import (
    Acceleration,
    Angle,
    AngularAcceleration,
    Annotated,
    CamVelocity,
    Coordinate,
    Count,
    Force,
    Ratio,
    Size,
    Speed,
    Torque,
    TurnRate,
)
from dynamics_cli.records import Advice, record
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


@record
class SliderStep:
    """One crank angle of the table."""

    crank_angle: Annotated[Angle, "Crank angle θ [rad]."]
    position: Annotated[Coordinate, "Slider position x from the crank's pivot [m]."]
    velocity: Annotated[Speed | None, "Velocity of the slider at the speed given [m/s]."]
    acceleration: Annotated[Acceleration | None, "Acceleration of the slider there [m/s^2]."]
    slope: Annotated[CamVelocity | None, "dx/dθ, where no speed is given: the velocity over that of the crank [m/rad]."]
    bend: Annotated[Coordinate | None, "d²x/dθ²: the acceleration over ω² of a crank at uniform speed [m]."]
    rod_angle: Annotated[Angle, "Angle of the rod to the slide [rad]."]


@record
class SliderCrank:
    """A slider-crank in one pose, its stroke, or its table."""

    crank_angle: Annotated[Angle | None, "Crank angle θ, where the slider's position was given [rad]."] = None
    crank_speed: Annotated[TurnRate | None, "Angular velocity ω of the crank that the slider drives [rad/s]."] = None
    crank_acceleration: Annotated[AngularAcceleration | None, "Its angular acceleration α [rad/s^2]."] = None
    position: Annotated[Coordinate | None, "Slider position x from the crank's pivot along the slide [m]."] = None
    travel: Annotated[Coordinate | None, "Distance from the outer dead centre [m]."] = None
    velocity: Annotated[Speed | None, "Velocity of the slider [m/s]."] = None
    acceleration: Annotated[Acceleration | None, "Acceleration of the slider [m/s^2]."] = None
    slope: Annotated[CamVelocity | None, "dx/dθ [m/rad]."] = None
    rod_angle: Annotated[Angle | None, "Angle of the rod to the slide: the pressure angle [rad]."] = None
    rod_speed: Annotated[TurnRate | None, "Angular velocity ω₃ of the rod [rad/s]."] = None
    rod_acceleration: Annotated[AngularAcceleration | None, "Its angular acceleration α₃ [rad/s^2]."] = None
    crank_torque: Annotated[Torque | None, "Torque at the crank that balances the slider's force [N*m]."] = None
    stroke: Annotated[Size | None, "Distance between the dead centres; none unless the crank turns fully [m]."] = None
    time_ratio: Annotated[Ratio | None, "Time of the slow stroke over that of the quick one."] = None
    outer_at: Annotated[Angle | None, "Crank angle at the outer dead centre [rad]."] = None
    inner_at: Annotated[Angle | None, "Crank angle at the inner dead centre [rad]."] = None
    largest_rod_angle: Annotated[Angle | None, "Largest angle of the rod to the slide [rad]."] = None
    top_speed: Annotated[Speed | None, "Largest speed of the slider in a turn at this ω [m/s]."] = None
    top_slope: Annotated[CamVelocity | None, "Largest |dx/dθ| in a turn [m/rad]."] = None
    top_at: Annotated[Angle | None, "Crank angle at which it is reached first [rad]."] = None
    table: Annotated[tuple[SliderStep, ...] | None, "A full turn of the crank, where no angle was given."] = None
    advice: tuple[Advice, ...] = ()


def slider_crank(
    *,
    crank: Annotated[Size, "Length a of the crank, e.g. 50 mm."],
    rod: Annotated[Size, "Length b of the connecting rod, e.g. 150 mm."],
    offset: Annotated[Coordinate, "Offset e of the slide above the crank's pivot, e.g. 20 mm."] = 0.0,
    crank_angle: Annotated[Angle | None, "Crank angle θ from the slide's direction; without it a table."] = None,
    end: Annotated[End, "Side of the crank pin on which the slider is."] = RIGHT,
    speed: Annotated[TurnRate | None, "Angular velocity ω of the crank, e.g. 3000 rpm."] = None,
    angular_acceleration: Annotated[AngularAcceleration, "Angular acceleration α of the crank [rad/s^2]."] = 0.0,
    slider_position: Annotated[Coordinate | None, "Or the slider's position x, which gives the crank angle."] = None,
    slider_velocity: Annotated[Speed | None, "Velocity of a slider that drives the crank, e.g. 0.5 m/s."] = None,
    slider_acceleration: Annotated[Acceleration, "Its acceleration, e.g. 2 m/s^2."] = 0.0,
    pin: Annotated[Pin, "Side of the line from pivot to slider where the crank pin then is."] = LEFT,
    load_force: Annotated[Force | None, "Force that the slider delivers along x, e.g. 500 N."] = None,
    steps: Annotated[Count, "Steps of the table over a full turn."] = 24,
) -> SliderCrank:
    """Position, velocity and acceleration of a slider-crank, its stroke and time ratio, or its table.

    Equation
    --------
    x = a cos θ ± √((b − h)(b + h)), h = e − a sin θ; ω₃ = −aω cos θ/b_x, v = −aω sin θ − ω₃h; stroke
    4ab/(√((b + a)² − e²) + √((b − a)² − e²)); from dead centre in line 2a sin²(θ/2) + a² sin²θ/(b + √(b² − a² sin²θ)).

    Raises
    ------
    InadmissibleError
        When a length is not above zero, the rod does not reach the slide at this angle, or is perpendicular to it
        where a velocity is requested.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 5.3.

    Examples
    --------
    >>> round(slider_crank(crank=0.05, rod=0.15, offset=0.02, crank_angle=1.0471975511965976).position, 9)
    0.173179117
    """
    for name, length in (("crank", crank), ("rod", rod)):
        require_long(name, length)
    _require_one_driver(crank_angle, slider_position, speed, slider_velocity)
    side = 1.0 if end == RIGHT else -1.0
    driven: dict[str, Any] = {}
    if slider_position is not None:
        crank_angle, side = crank_of((crank, rod, offset), slider_position, pin)
        driven = {"crank_angle": crank_angle}
    stroke = stroke_of(crank, rod, offset, side)
    if stroke and (drawing() or decides(crank, rod, offset)):
        stroke |= fastest(crank, rod, offset, side, speed)
    if crank_angle is None:
        if drawing():
            return SliderCrank(**stroke)
        require(
            single(crank, rod, offset),
            "rows need a crank angle: a table is for a single mechanism",
            code="no-angle",
            hint="add a column crank_angle",
        )
        rows = _table((crank, rod, offset), end, steps, speed, angular_acceleration)
        return SliderCrank(**stroke, table=rows, advice=_partial(crank, rod, offset))
    turn, half = turned(crank_angle), turned(0.5 * crank_angle)
    along, rise = crank * turn[0], crank * turn[1]
    height = offset - rise
    across = _across(rod, height, crank_angle, speed is not None or load_force is not None)
    if slider_velocity is not None:
        slopes = slopes_at(crank, rod, offset, side, turn)
        speed, angular_acceleration = rates_of(slopes, slider_velocity, slider_acceleration)
        driven |= {"crank_speed": speed, "crank_acceleration": angular_acceleration}
        driven |= {"velocity": slider_velocity, "acceleration": slider_acceleration}
    reach = side * across
    position = along + reach if slider_position is None else slider_position
    moving = _moving((along, rise), (reach, height), across, speed, angular_acceleration, load_force)
    return SliderCrank(
        **stroke,
        position=position,
        travel=_travel((crank, rod, offset), (across, height), half[1], side, position),
        rod_angle=atan2(height, across),
        **(moving | driven),
    )


def _across(rod: float, height: float, crank_angle: float, moves: bool) -> float:
    """How far the rod reaches along the slide; refused where it does not reach it, or cannot be moved."""
    require(
        absolute(height) <= rod,
        "at a crank angle of {angle:6} the rod of {rod} does not reach the slide: it is {gap} too short",
        angle=(crank_angle, Angle),
        rod=(rod, Size),
        gap=(absolute(height) - rod, Size),
        code="unreachable",
        hint="lengthen the rod by {gap}, or bring the slide nearer to the crank's pivot",
    )
    across = sqrt((rod - height) * (rod + height))
    if moves:
        require(
            across > 0.0,
            "the rod is perpendicular to the slide: the crank cannot move the slider through this pose",
            code="toggle",
            hint="give a crank angle beside it",
        )
    return across


def _require_one_driver(
    crank_angle: "float | None", slider_position: "float | None", speed: "float | None", slider_velocity: "float | None"
) -> None:
    """Refuse a pose or a speed that is given twice."""
    require(
        crank_angle is None or slider_position is None,
        "crank angle and slider position are both given",
        code="exclusive",
        hint="either follows from the other",
    )
    require(
        slider_velocity is None or speed is None,
        "speeds of crank and slider are both given",
        code="exclusive",
        hint="either follows from the other",
    )
    require(
        slider_velocity is None or crank_angle is not None or slider_position is not None,
        "a velocity of the slider belongs to one pose",
        code="no-angle",
        hint="--slider-position '170 mm' or --crank-angle '60 deg'",
    )


def _travel(
    lengths: "tuple[float, float, float]",
    arm: "tuple[float, float]",
    half: float,
    side: float,
    position: float,
) -> float:
    """Distance from the outer dead centre; in line without cancellation."""
    (crank, rod, offset), (across, height) = lengths, arm
    far = (crank + rod - absolute(offset)) * (crank + rod + absolute(offset))
    outer = sqrt(where(far > 0.0, far, 0.0 * far))
    dropped = 2.0 * crank * (half * half) + height * height / (rod + across)
    return where((offset == 0.0) & (side > 0.0), dropped, outer - side * position)


def _moving(
    pin: "tuple[float, float]",
    arm: "tuple[float, float]",
    across: float,
    speed: "float | None",
    bend: float,
    load_force: "float | None",
) -> "dict[str, Any]":
    """Velocities and accelerations of slider and rod, the rod's ends apart by `arm`."""
    (along, rise), (reach, height) = pin, arm
    safe = where(across > 0.0, reach, 1.0)
    lean = -(along / safe)
    slope = -rise - lean * height
    torque = {"slope": slope, "crank_torque": None if load_force is None else load_force * slope}
    if speed is None:
        return torque
    turning = lean * speed
    square = speed * speed
    bending = (rise * square - along * bend + turning * turning * height) / safe
    return torque | {
        "velocity": slope * speed,
        "acceleration": -(along * square) - rise * bend - turning * turning * reach - bending * height,
        "rod_speed": turning,
        "rod_acceleration": bending,
    }


def _table(
    lengths: "tuple[float, float, float]", end: End, steps: int, speed: float | None, gain: float
) -> "tuple[SliderStep, ...]":
    a, b, e = map(plain, lengths)
    side = 1.0 if end == RIGHT else -1.0
    rows = []
    for angle in spread(0.0, tau, steps):
        turn = turned(angle)
        height = e - a * turn[1]
        if abs(height) >= b:
            continue
        reach = side * sqrt((b - height) * (b + height))
        slope, bend = slopes_at(a, b, e, side, turn)
        moving: tuple[float | None, ...] = (None, None, slope, bend)
        if speed is not None:
            rate = plain(speed)
            moving = (slope * rate, bend * rate * rate + slope * plain(gain), None, None)
        row: Any = (angle, a * turn[0] + reach, *moving, atan2(height, abs(reach)))
        rows.append(SliderStep(*row))
    require(
        bool(rows),
        "the rod of {rod} reaches the slide at no crank angle",
        rod=(b, Size),
        code="unreachable",
        hint="lengthen the rod, or bring the slide nearer to the crank's pivot",
    )
    return tuple(rows)


def _partial(crank: float, rod: float, offset: float) -> "tuple[Advice, ...]":
    """That the crank does not turn fully, and the rod with which it would."""
    full = plain(crank) + abs(plain(offset))
    if plain(rod) >= full:
        return ()
    message = "the crank does not turn fully: crank angles at which the rod does not reach the slide are left out"
    remedy = worded("with a rod longer than {full} it does", full=(full, Size))
    return (Advice("partial-turn", message, severity="note", remedy=remedy),)
