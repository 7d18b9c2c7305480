"""A body in plane motion: angular velocity and acceleration, instant centre, centre of zero acceleration."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, atan2, hypot
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    Angle,
    AngularAcceleration,
    Annotated,
    Coordinate,
    PartAcceleration,
    PartPoint,
    PartVelocity,
    Size,
    Speed,
    TurnRate,
)
from dynamics_cli.records import Advice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    Pair = tuple[float, float]

# Points that separate faster than this share of their relative velocity are not on one rigid body.
RIGID = 1e-3
ROUNDING = 1e-12


@record
class TwoPoints:
    """A second point with its velocity, and its acceleration where the first has one."""

    second_point: Annotated[PartPoint, "The second point, e.g. 80, 10 mm."]
    second_velocity: Annotated[PartVelocity, "Its velocity, e.g. 1.5, 4 m/s."]
    second_acceleration: Annotated[PartAcceleration | None, "Its acceleration, e.g. 3, -4 m/s^2."] = None


@record
class Turning:
    """How the body turns."""

    angular_velocity: Annotated[TurnRate, "Angular velocity ω of the body, e.g. 5 rad/s."]
    angular_acceleration: Annotated[AngularAcceleration | None, "Its angular acceleration α [rad/s^2]."] = None


@record
class Place:
    """A further point of the body."""

    x: Annotated[Coordinate, "Where it is, e.g. 40 mm."]
    y: Annotated[Coordinate, "Its height y, e.g. 60 mm."]


@record
class PlacedPoint:
    """A further point with its motion."""

    position: Annotated[PartPoint, "Where it is [m]."]
    velocity: Annotated[PartVelocity, "Its velocity [m/s]."]
    speed: Annotated[Speed, "The magnitude of it [m/s]."]
    acceleration: Annotated[PartAcceleration | None, "Its acceleration [m/s^2]."]
    radius_of_curvature: Annotated[Coordinate | None, "Radius of curvature of its path, positive to the left [m]."]


@record
class BodyMotion:
    """The plane motion of a body at one instant."""

    angular_velocity: Annotated[TurnRate, "ω, counter-clockwise positive [rad/s]."]
    angular_acceleration: Annotated[AngularAcceleration | None, "α [rad/s^2]."]
    instant_centre: Annotated[PartPoint | None, "The point without velocity; none in translation [m]."]
    distance: Annotated[Size | None, "Distance of the first point from it [m]."]
    zero_acceleration: Annotated[PartPoint | None, "The point without acceleration [m]."]
    inflection_diameter: Annotated[Size | None, "Diameter of the inflection circle, where paths are straight now [m]."]
    inflection_direction: Annotated[Angle | None, "Direction of that diameter from the instant centre [rad]."]
    parting: Annotated[Speed | None, "Speed at which two given points part: zero of a rigid body [m/s]."]
    points: Annotated[tuple[PlacedPoint, ...] | None, "Further points."] = None
    advice: tuple[Advice, ...] = ()


def body(
    *,
    point: Annotated[PartPoint, "A point A of the body, e.g. 0, 0 mm."],
    velocity: Annotated[PartVelocity, "Its velocity, e.g. 2, 0 m/s."],
    acceleration: Annotated[PartAcceleration | None, "Its acceleration, e.g. 0, -5 m/s^2."] = None,
    rest: Annotated[TwoPoints | Turning, "A second point with its velocity, or the body's angular velocity."],
    places: Annotated[tuple[Place, ...], "Further points to report the motion of."] = (),
) -> BodyMotion:
    """Plane motion of a body from two points, or one and its rotation: centres of velocity and acceleration.

    Equation
    --------
    ω = r×Δv/r², α = r×Δa/r²; instant centre A + k×v/ω; zero acceleration A + a(ω² + iα)/(ω⁴ + α²); v = v_A + ω k×r,
    a = a_A + α k×r − ω²r; inflection circle: diameter from the instant centre P to P + a_P/ω².

    Raises
    ------
    InadmissibleError
        When the two points coincide, or separate faster than a rigid body allows.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 5.3, 5.4, 5.7 and 5.8.

    Examples
    --------
    >>> result = body(point=(0.0, 0.0), velocity=(2.0, 0.0), rest=Turning(angular_velocity=4.0))
    >>> result.instant_centre
    (0.0, 0.5)
    """
    parting = None
    if isinstance(rest, TwoPoints):
        omega, alpha, parting = _rotation(point, velocity, acceleration, rest)
    else:
        omega, alpha = rest.angular_velocity, rest.angular_acceleration
        if alpha is None and acceleration is not None:
            alpha = 0.0 * omega
    turns = plain(omega) != 0.0
    bent = acceleration is not None and alpha is not None
    centre = (point[0] - velocity[1] / omega, point[1] + velocity[0] / omega) if turns else None
    zero = inflection = direction = None
    if acceleration is not None and alpha is not None:
        square = omega * omega
        size = square * square + alpha * alpha
        if plain(size) != 0.0:
            ax, ay = acceleration
            zero = (
                point[0] + (ax * square - ay * alpha) / size,
                point[1] + (ay * square + ax * alpha) / size,
            )
        if centre is not None:
            pole = _acceleration(point, acceleration, omega, alpha, centre)
            inflection = hypot(pole[0], pole[1]) / square
            direction = atan2(pole[1], pole[0]) if plain(inflection) != 0.0 else None
    placed = tuple(
        _placed(point, velocity, acceleration if bent else None, omega, alpha, (place.x, place.y)) for place in places
    )
    return BodyMotion(
        angular_velocity=omega,
        angular_acceleration=alpha if bent or alpha is not None else None,
        instant_centre=centre,
        distance=None if centre is None else hypot(velocity[0], velocity[1]) / absolute(omega),
        zero_acceleration=zero,
        inflection_diameter=inflection,
        inflection_direction=direction,
        parting=parting,
        points=placed or None,
        advice=()
        if turns
        else (
            Advice(
                "translation",
                "the body does not turn: its instant centre is at infinity, perpendicular to the velocity",
                severity="note",
                result="instant_centre",
            ),
        ),
    )


def _rotation(
    point: "Pair", velocity: "Pair", acceleration: "Pair | None", second: TwoPoints
) -> "tuple[float, float | None, float]":
    rx, ry = second.second_point[0] - point[0], second.second_point[1] - point[1]
    square = rx * rx + ry * ry
    require(square > 0.0, "the two points coincide: they do not determine the rotation", code="one-point",
            hint="give a second point elsewhere on the body")  # fmt: skip
    ux, uy = second.second_velocity[0] - velocity[0], second.second_velocity[1] - velocity[1]
    length = hypot(rx, ry)
    parting = (rx * ux + ry * uy) / length
    require(
        absolute(parting) <= RIGID * hypot(ux, uy) + ROUNDING * (absolute(velocity[0]) + absolute(velocity[1])),
        "the two points separate at {parting}, which points of a rigid body cannot",
        parting=(absolute(parting), Speed),
        code="not-rigid",
        hint="give velocities whose parts along the line between the points are equal",
    )
    omega = (rx * uy - ry * ux) / square
    if acceleration is None or second.second_acceleration is None:
        return omega, None, parting
    bx, by = second.second_acceleration[0] - acceleration[0], second.second_acceleration[1] - acceleration[1]
    return omega, (rx * by - ry * bx) / square, parting


def _acceleration(point: "Pair", acceleration: "Pair", omega: float, alpha: float, at: "Pair") -> "Pair":
    rx, ry = at[0] - point[0], at[1] - point[1]
    square = omega * omega
    return acceleration[0] - alpha * ry - square * rx, acceleration[1] + alpha * rx - square * ry


def _placed(
    point: "Pair", velocity: "Pair", acceleration: "Pair | None", omega: float, alpha: "float | None", at: "Pair"
) -> PlacedPoint:
    vx, vy = velocity[0] - omega * (at[1] - point[1]), velocity[1] + omega * (at[0] - point[0])
    speed = hypot(vx, vy)
    bent = radius = None
    if acceleration is not None and alpha is not None:
        bent = _acceleration(point, acceleration, omega, alpha, at)
        cross = vx * bent[1] - vy * bent[0]
        if plain(cross) != 0.0 and plain(speed) != 0.0:
            radius = speed * speed * speed / cross
    return PlacedPoint(at, (vx, vy), speed, bent, radius)
