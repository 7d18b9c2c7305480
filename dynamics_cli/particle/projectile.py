"""The task `projectile`: range, target, best angle, with no, linear or quadratic drag."""

from dynamics_cli.errors import MissingError, require, worded
from dynamics_cli.numerics.elementary import absolute, atan, atan2, hypot, sqrt, tan
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.turns import turned
from dynamics_cli.particle.aiming import (
    RIGHT,
    Aimed,
    DragBody,
    Elevation,
    Target,
    Terminal,
    angles_to,
    best_angle,
    launch_speed,
    launcher,
    least_speed,
    meeting_speed,
)
from dynamics_cli.particle.flights import FEWER, Quadratic, Vacuum
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Count,
    Gravity,
    Length,
    Speed,
    Time,
)
from dynamics_cli.records import Advice, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from dynamics_cli.particle.aiming import Flight, Launch

    # The speed that meets a target at a slope.
    Meeting = Callable[[float, float, float], float]

MOST_ROWS = 10000


@record
class Point:
    """One row of the path."""

    time: Annotated[Time, "Time since the launch [s]."]
    distance: Annotated[Length, "Horizontal distance [m]."]
    height: Annotated[Length, "Height above the launch [m]."]
    speed: Annotated[Speed, "Speed [m/s]."]


@record
class Projectile:
    """A flight, and what other angles would do."""

    launch_speed: Annotated[Speed | None, "Speed that meets the target at this angle, where it is found [m/s]."]
    elevation: Annotated[Angle, "Angle of the launch above the horizontal [rad]."]
    other_elevation: Annotated[Angle | None, "The other angle that meets the target, the steeper one [rad]."]
    range: Annotated[Length, "Horizontal distance of the landing, or of the target [m]."]
    time: Annotated[Time, "Time until then [s]."]
    apex_height: Annotated[Length, "Greatest height above the launch [m]."]
    apex_distance: Annotated[Length, "Horizontal distance of it [m]."]
    impact_speed: Annotated[Speed, "Speed at the landing, or at the target [m/s]."]
    impact_angle: Annotated[Angle, "Angle of the path below the horizontal there [rad]."]
    best_elevation: Annotated[Angle | None, "Angle of the greatest range; to a landing [rad]."]
    greatest_range: Annotated[Length | None, "That range [m]."]
    least_speed: Annotated[Speed | None, "Least speed that reaches the target; without drag [m/s]."]
    path: Annotated[tuple[Point, ...], "The path at equal times."]
    numerics: Numerics | None = None
    advice: tuple[Advice, ...] = ()


def no_drag(*, time_constant: float | None = None, drag: object = None, **_: object) -> str | None:
    """Without drag the path is a parabola."""
    return "no drag is given" if time_constant is None and drag is None else None


def linear_drag(*, drag: object = None, **_: object) -> str | None:
    """Drag in proportion to the speed has a closed form."""
    return "the drag is in proportion to the speed" if drag is None else None


def projectile(
    *,
    speed: Annotated[
        Speed | None, "Speed of the launch; without one it is found from elevation and target, e.g. 30 m/s."
    ] = None,
    aim: Annotated[Elevation | Target | Aimed, "Where it is aimed."],
    height: Annotated[Length, "Height of the launch above the landing, e.g. 2 m."] = 0.0,
    time_constant: Annotated[
        Time | None, "Drag in proportion to the speed: the time in which it falls by e, e.g. 3 s."
    ] = None,
    drag: Annotated[Terminal | DragBody | None, "Drag by the square of the speed."] = None,
    wind: Annotated[Speed, "Wind along the ground, a tail wind positive; with drag, e.g. -5 m/s."] = 0.0,
    steps: Annotated[Count, "Rows of the path, less one [-]."] = 8,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Projectile:
    """A projectile without drag: range and time, both angles for a target, the best angle and the least speed.

    Equation
    --------
    t = (v_y + √(v_y² + 2·g·h))/g. Target (x, y): tan α = (v² ± √(v⁴ − g·(g·x² + 2·y·v²)))/(g·x),
    the flatter one from the
    product of both. Best: tan α = v/√(v² + 2·g·h), range v·√(v² + 2·g·h)/g.

    Returns
    -------
    Projectile
        The flight to the landing, or to the target.

    Raises
    ------
    InadmissibleError
        When it never comes down to the landing, or never reaches the target: with the least speed that does.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 8.7.

    Examples
    --------
    >>> round(projectile(speed=30.0, aim=Elevation(0.7853981633974483), height=2.0).range, 9)
    93.732676151
    """
    require(time_constant is None and drag is None, "a drag is for the models with drag", code="model")
    require(plain(wind) == 0.0, "a wind has no effect without drag", code="wind", hint="give the drag too, or no wind")
    speed = _check(speed, aim, height, steps, lambda x, y, slope: meeting_speed(x, y, slope, gravity))
    least = other = None
    if isinstance(aim, Target):
        x, y = aim.target
        flat, steep, least = _to_target(speed, x, y, gravity)
        # by the slope itself, which an angle near 90 degrees has lost
        scale = speed / sqrt(1.0 + flat * flat)
        elevation, other = atan(flat), atan(steep)
        flight = Vacuum(scale, scale * flat, gravity)
    else:
        elevation = aim.elevation
        cosine, sine = turned(elevation)
        flight = Vacuum(speed * cosine, speed * sine, gravity)
        if isinstance(aim, Aimed):
            least = least_speed(*aim.target, gravity)
    best = greatest = None
    if isinstance(aim, Elevation):
        reach = speed * speed + 2.0 * gravity * height
        if plain(reach) > 0.0:
            best, greatest = atan(speed / sqrt(reach)), speed * sqrt(reach) / gravity
    end = _end(flight, aim, height)
    return _answer(
        flight, speed if isinstance(aim, Aimed) else None, end, elevation, other, best, greatest, least, steps, None
    )


def with_drag(
    *,
    speed: Annotated[
        Speed | None, "Speed of the launch; without one it is found from elevation and target, e.g. 30 m/s."
    ] = None,
    aim: Annotated[Elevation | Target | Aimed, "Where it is aimed."],
    height: Annotated[Length, "Height of the launch above the landing, e.g. 2 m."] = 0.0,
    time_constant: Annotated[
        Time | None, "Drag in proportion to the speed: the time in which it falls by e, e.g. 3 s."
    ] = None,
    drag: Annotated[Terminal | DragBody | None, "Drag by the square of the speed."] = None,
    wind: Annotated[Speed, "Wind along the ground, a tail wind positive; with drag, e.g. -5 m/s."] = 0.0,
    steps: Annotated[Count, "Rows of the path, less one [-]."] = 8,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Projectile:
    """A projectile with drag in proportion to its speed, or to the square of it, in a steady wind.

    Equation
    --------
    Linear: x = v_x·τ·(1 − e^(−t/τ)),
    y = v_y·τ·(1 − e^(−t/τ)) − g·τ²·(t/τ − 1 + e^(−t/τ)). Quadratic, with the slope p of
    the path: 1/v_x² = 1/v_x0² + (G(p₀) − G(p))/v_t², G = p·√(1 + p²) + asinh p; t, x, y = ∫ v_x dp/g, ∫ v_x² dp/g,
    ∫ p·v_x² dp/g.

    Returns
    -------
    Projectile
        The flight to the landing, or to the target.

    Raises
    ------
    InadmissibleError
        When it never comes down to the landing, or reaches the target at no angle.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 8.7; Bernoulli's hodograph (1719).

    Examples
    --------
    >>> aim = Elevation(0.7853981633974483)
    >>> round(with_drag(speed=30.0, aim=aim, drag=Terminal(25.0)).range, 9)
    46.540398983
    """
    require(time_constant is None or drag is None, "two sorts of drag are given", code="exclusive",
            hint="give --time-constant or the quadratic drag")  # fmt: skip
    if time_constant is None and drag is None:
        raise MissingError("no drag is given", (("time_constant",), ("drag.terminal_speed",)))
    angle = 0.0 if isinstance(aim, Target) else plain(aim.elevation)
    given = plain(gravity), plain(time_constant), drag, plain(wind)
    speed = _check(speed, aim, height, steps, lambda x, y, slope: launch_speed(
        plain(meeting_speed(x, y, slope, gravity)), plain(x), plain(y), angle, *given))  # fmt: skip
    launch = launcher(plain(speed), *given)
    other = None
    if isinstance(aim, Target):
        x, y = plain(aim.target[0]), plain(aim.target[1])
        elevation, other = angles_to(launch, x, y)
    else:
        elevation = plain(aim.elevation)
    flight = launch(elevation)
    end = _end(flight, aim, plain(height))
    best = greatest = None
    if isinstance(aim, Elevation) and plain(height) >= 0.0:
        best = best_angle(launch, plain(height))
        greatest = launch(best).landing(plain(height))[1]
    return _answer(
        flight,
        speed if isinstance(aim, Aimed) else None,
        end,
        elevation,
        other,
        best,
        greatest,
        None,
        steps,
        _numerics(launch, elevation, aim, plain(height), end),
    )


def _check(
    speed: "float | None", aim: "Elevation | Target | Aimed", height: float, steps: int, meeting: "Meeting"
) -> float:
    """The speed, or that which meets the target at the elevation."""
    require((steps >= 1) & (steps <= MOST_ROWS), "the path cannot have {steps} rows", code="steps", steps=steps)
    if not isinstance(aim, Target):
        require(absolute(aim.elevation) <= RIGHT, "an elevation of {angle} points backwards",
                angle=(aim.elevation, Angle), code="elevation",
                hint="give an angle between -90 and 90 deg")  # fmt: skip
    if isinstance(aim, Elevation):
        require(
            (aim.elevation > 0.0) | (height > 0.0), "launched level or downwards it needs a height above the landing",
            code="no-flight", hint="give --height, or an elevation above zero",
        )  # fmt: skip
    else:
        require(aim.target[0] > 0.0, "the target lies {distance} ahead", distance=(aim.target[0], Length),
                code="target", hint="give a target with a distance above zero")  # fmt: skip
        require(plain(height) == 0.0, "with a target the height is its own", code="exclusive",
                hint="leave out --height: the target's height is counted from the launch")  # fmt: skip
    if isinstance(aim, Aimed):
        require(speed is None, "speed, elevation and target are all given", code="exclusive",
                hint="leave out one: it is found from the others")  # fmt: skip
        require(absolute(aim.elevation) < RIGHT, "straight up or down it does not come to a target ahead",
                code="elevation", hint="give an elevation between -90 and 90 deg")  # fmt: skip
        return meeting(*aim.target, tan(aim.elevation))
    if speed is None:
        raise MissingError("the speed is not given", (("speed",), ("elevation", "target")))
    require(speed > 0.0, "the speed of {speed} is not above zero", speed=(speed, Speed))
    return speed


def _to_target(speed: float, x: float, y: float, gravity: float) -> "tuple[float, float, float]":
    """The slopes of the flatter and the steeper launch, and the least speed."""
    least = least_speed(x, y, gravity)
    square = speed * speed
    rest = square * square - gravity * (gravity * x * x + 2.0 * y * square)
    require(
        rest >= 0.0, "at {speed} it does not reach the target: {least} is the least", speed=(speed, Speed),
        least=(least, Speed), code="out-of-reach", hint=worded("launch it at {least} or more", least=(least, Speed)),
    )  # fmt: skip
    steep = (square + sqrt(rest)) / (gravity * x)
    flat = (gravity * x * x + 2.0 * y * square) / (gravity * x * x) / steep
    return flat, steep, least


def _end(flight: "Flight", aim: "Elevation | Target | Aimed", height: float) -> "tuple[float, ...]":
    if not isinstance(aim, Elevation):
        passed = flight.passing(plain(aim.target[0]))
        assert passed is not None
        return passed
    apex = flight.apex()[2]
    require(
        plain(apex) >= -plain(height), "it rises {apex} and never comes to a landing {rise} above the launch",
        apex=(apex, Length), rise=(-height, Length), code="out-of-reach", hint="launch it faster or steeper",
    )  # fmt: skip
    return flight.landing(height)


def _numerics(
    launch: "Launch", elevation: float, aim: "Elevation | Target | Aimed", height: float, end: "tuple[float, ...]"
) -> Numerics:
    """The difference that fewer nodes make, with room for rounding."""
    flight = launch(elevation)
    if not isinstance(flight, Quadratic):
        return Numerics("closed form, time by Newton's rule")
    flight.nodes = FEWER
    other = _end(flight, aim, height)
    names = ("time", "range") if isinstance(aim, Elevation) else ("time",)
    bounds = tuple(
        ErrorBound(name, max(abs(a - b) / abs(a), 1e-14) if a else 1e-14)
        for name, a, b in zip(names, end, other, strict=False)
    )
    return Numerics("Bernoulli's hodograph, Gauss–Legendre with 16 and 12 nodes a panel", bounds=bounds)


def _answer(
    flight: "Flight",
    needed_speed: "float | None",
    end: "tuple[float, ...]",
    elevation: float,
    other: "float | None",
    best: "float | None",
    greatest: "float | None",
    least: "float | None",
    steps: int,
    numerics: "Numerics | None",
) -> Projectile:
    time, x, _, across, up = end
    apex = flight.apex()
    rows = []
    for k in range(steps + 1):
        t, distance, height, v_x, v_y = flight.at(time * k / steps) if k < steps else end
        rows.append(Point(time=t, distance=distance, height=height, speed=hypot(v_x, v_y)))
    return Projectile(
        launch_speed=needed_speed,
        elevation=elevation,
        other_elevation=other,
        range=x,
        time=time,
        apex_height=apex[2],
        apex_distance=apex[1],
        impact_speed=hypot(across, up),
        impact_angle=atan2(-up, across),
        best_elevation=best,
        greatest_range=greatest,
        least_speed=least,
        path=tuple(rows),
        numerics=numerics,
    )
