"""Hypoid gears at the pitch point: two cones that touch with their axes apart."""

from math import pi

from dynamics_cli.errors import require
from dynamics_cli.gear.limits import bisect, plain
from dynamics_cli.numerics.elementary import absolute, asin, atan, atan2, cos, sin, tan
from dynamics_cli.quantities import Angle, Coordinate, Curvature, Ratio, ShaftSpeed, Size, Speed, Teeth
from dynamics_cli.records import Advice, Check, record

RIGHT_ANGLE = 0.5 * pi
PINION_SPIRAL = 50.0 * pi / 180.0


@record
class HypoidData:
    """The pitch point of a hypoid pair.

    Parameters
    ----------
    ratio : Ratio
        Gear ratio u = z₂/z₁.
    first_pitch_angle : Angle
        Pitch angle of the pinion δ₁ [rad].
    second_pitch_angle : Angle
        Pitch angle of the wheel δ₂ [rad].
    first_spiral_angle : Angle
        Spiral angle of the pinion β₁ [rad].
    second_spiral_angle : Angle
        Spiral angle of the wheel β₂ [rad].
    axial_offset_angle : Angle
        Offset angle in the axial plane of the wheel, η [rad].
    pitch_offset_angle : Angle
        Offset angle in the pitch plane, ε' = β₁ − β₂ [rad].
    first_pitch_radius : Size
        Pitch radius of the pinion r₁ [m].
    second_pitch_radius : Size
        Pitch radius of the wheel r₂ [m].
    first_cone_distance : Size
        Cone distance of the pinion R₁ [m].
    second_cone_distance : Size
        Cone distance of the wheel R₂ [m].
    enlargement : Ratio
        Pinion radius over that of a bevel pinion of the same wheel and ratio.
    normal_module : Size
        Mean normal module [m].
    first_apex_distance : Coordinate
        From the axes' crossing point to the apex of the pinion, along its axis towards the pitch point [m].
    second_apex_distance : Coordinate
        From the axes' crossing point to the apex of the wheel, along its axis away from the pitch point [m].
    limit_pressure_angle : Angle
        Limit pressure angle α_lim, about which the flanks' pressure angles are balanced [rad].
    limit_curvature : Curvature
        Limit normal curvature of the teeth's lengthwise curve, 1/ρ_lim [1/m].
    sliding_ratio : Ratio
        Lengthwise sliding over the speed of the wheel's pitch point.
    sliding_speed : Speed
        Sliding velocity along the teeth [m/s].
    second_speed : ShaftSpeed
        Speed of the wheel [rad/s].
    """

    ratio: Ratio
    first_pitch_angle: Angle
    second_pitch_angle: Angle
    first_spiral_angle: Angle
    second_spiral_angle: Angle
    axial_offset_angle: Angle
    pitch_offset_angle: Angle
    first_pitch_radius: Size
    second_pitch_radius: Size
    first_cone_distance: Size
    second_cone_distance: Size
    enlargement: Ratio
    normal_module: Size
    first_apex_distance: Coordinate
    second_apex_distance: Coordinate
    limit_pressure_angle: Angle
    limit_curvature: Curvature
    sliding_ratio: Ratio
    sliding_speed: Speed | None
    second_speed: ShaftSpeed | None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def hypoid(
    *,
    first_teeth: Teeth,
    second_teeth: Teeth,
    offset: Coordinate,
    wheel_radius: Size,
    pinion_spiral_angle: Angle = PINION_SPIRAL,
    wheel_pitch_angle: Angle | None = None,
    shaft_angle: Angle = RIGHT_ANGLE,
    speed: ShaftSpeed | None = None,
) -> HypoidData:
    """Pitch-point geometry of a hypoid pair: cones, offset and spiral angles, sliding, limit pressure angle.

    Equation
    --------
    sin η = E/(r₂ + r₁cos δ₂/cos δ₁); sin δ₁ = cos δ₂ cos η sin Σ − sin δ₂ cos Σ; tan ε' = sin η sin Σ/(cos η sin δ₂
    sin Σ + cos δ₂ cos Σ); β₂ = β₁ − ε'; r₁ = r₂(z₁/z₂)cos β₂/cos β₁.

    Parameters
    ----------
    first_teeth : Teeth
        Number of teeth of the pinion z₁.
    second_teeth : Teeth
        Number of teeth of the wheel z₂.
    offset : Coordinate
        Hypoid offset E; positive enlarges the pinion, negative (as on crane axles, rarely) shrinks it [m].
    wheel_radius : Size
        Mean pitch radius of the wheel r₂ [m].
    pinion_spiral_angle : Angle
        Spiral angle of the pinion β₁ [rad].
    wheel_pitch_angle : Angle
        Pitch angle of the wheel δ₂; that of the bevel pair without offset unless given [rad].
    shaft_angle : Angle
        Shaft angle Σ [rad].
    speed : ShaftSpeed
        Speed of the pinion [rad/s].

    Returns
    -------
    HypoidData
        The pitch point.

    Raises
    ------
    InadmissibleError
        When the offset is too large for the wheel, or no pinion cone touches there.

    Notes
    -----
    The free choice of a hypoid, its wheel pitch angle, is left to the user; a cutter that suits has the limit
    curvature. Tooth proportions (ISO 23509) and strength are outside this task. Without offset the pair is bevel.

    References
    ----------
    Wildhaber, Basic relationship of hypoid gears, 1946; ISO 23509; Josephs & Huston, Dynamics of Mechanical Systems,
    CRC Press 2002, section 17.14.

    Examples
    --------
    >>> from math import radians
    >>> answer = hypoid(first_teeth=10, second_teeth=40, offset=0.03, wheel_radius=0.08)
    >>> answer.enlargement > 1.0
    True
    """
    require(
        (shaft_angle > 0.0) & (shaft_angle < pi),
        "a shaft angle of {0:.6g} rad makes no hypoid pair",
        shaft_angle,
        code="shaft-angle",
    )
    require(wheel_radius > 0.0, "a wheel of {0:.6g} m radius is none", wheel_radius, code="wheel-radius")
    require(
        absolute(pinion_spiral_angle) < 0.5 * pi,
        "a spiral angle of {0:.6g} rad never crosses the face",
        pinion_spiral_angle,
        code="spiral-angle",
    )
    require(
        absolute(offset) < wheel_radius,
        "an offset of {0:.6g} mm is not less than the wheel's radius {1:.6g} mm",
        1e3 * absolute(offset),
        1e3 * wheel_radius,
        code="offset",
    )
    u = second_teeth / first_teeth
    plain_wheel = atan2(u * sin(shaft_angle), 1.0 + u * cos(shaft_angle))
    wheel = plain_wheel if wheel_pitch_angle is None else wheel_pitch_angle
    point = _Point(u, offset, wheel_radius, pinion_spiral_angle, wheel, shaft_angle)
    eta = _solved(point)
    first, turned, radius = point.at(eta)
    spiral = pinion_spiral_angle - turned
    return _result(point, eta, first, turned, radius, spiral, plain_wheel, first_teeth, second_teeth, speed)


class _Point:
    """The pitch point as a function of the offset angle η."""

    def __init__(self, u: float, offset: float, radius: float, spiral: float, wheel: float, shafts: float) -> None:
        self.u = u
        self.offset = offset
        self.radius = radius
        self.spiral = spiral
        self.wheel = wheel
        self.shafts = shafts

    def bare(self) -> "_Point":
        """The same in plain doubles."""
        return _Point(*(plain(value) for value in self.__dict__.values()))

    def at(self, eta: float) -> tuple[float, float, float]:
        """δ₁, ε' and r₁."""
        sine, cosine = sin(self.wheel), cos(self.wheel)
        across, along = sin(self.shafts), cos(self.shafts)
        rise = cosine * cos(eta) * across - sine * along
        first = asin(rise)
        turned = atan2(sin(eta) * across, cos(eta) * sine * across + cosine * along)
        radius = self.radius * cos(self.spiral - turned) / (self.u * cos(self.spiral))
        return first, turned, radius

    def residual(self, eta: float) -> float:
        """Offset of the pinion's axis at η, less the one wanted."""
        first, _, radius = self.at(eta)
        return sin(eta) * (self.radius + radius * cos(self.wheel) / cos(first)) - self.offset


def _solved(point: _Point) -> float:
    """η in plain numbers within its bracket, and one Newton step in the numbers that came in."""
    own = point.bare()
    least = own.at(0.0)[0]
    require(
        least > 0.0,
        "a wheel pitch angle of {0:.6g} degrees leaves no pinion at this shaft angle",
        plain(own.wheel) * 180.0 / pi,
        code="wheel-pitch-angle",
    )
    sign = 1.0 if own.offset >= 0.0 else -1.0
    high = 0.0
    step = 0.01
    while sign * own.residual(sign * high) < 0.0:
        high += step
        first, turned, _ = own.at(sign * high)
        require(
            high < 0.5 * pi and first > 0.0 and abs(own.spiral - turned) < 0.5 * pi,
            "no pinion reaches an offset of {0:.6g} mm on this wheel: its cone closes at an angle of {1:.4g} deg",
            1e3 * own.offset,
            high * 180.0 / pi,
            code="offset",
            hint="a smaller offset, or another pitch angle of the wheel",
        )
    found = sign * bisect(lambda eta: -sign * own.residual(sign * eta), high - step, high) if own.offset else 0.0
    slope = (own.residual(found + 1e-6) - own.residual(found - 1e-6)) / 2e-6
    # Among tracked numbers, so that the rounding of its sine and cosine counts.
    start = point.offset * 0.0 + found
    return start - point.residual(start) / slope


def _result(
    point: _Point,
    eta: float,
    first: float,
    turned: float,
    radius: float,
    spiral: float,
    plain_wheel: float,
    first_teeth: int,
    second_teeth: int,
    speed: float | None,
) -> HypoidData:
    wheel, own = point.wheel, point.spiral
    cones = radius / sin(first), point.radius / sin(wheel)
    lean = tan(first) * tan(wheel) / cos(turned)
    below = cones[0] * tan(first) + cones[1] * tan(wheel)
    limit = atan(-lean * (cones[0] * sin(own) - cones[1] * sin(spiral)) / below)
    bend = tan(own) / (cones[0] * tan(first)) + tan(spiral) / (cones[1] * tan(wheel))
    curve = -tan(limit) * bend + 1.0 / (cones[0] * cos(own)) - 1.0 / (cones[1] * cos(spiral))
    apart = sin(turned) / (cos(own) * cos(spiral))
    require(
        absolute(apart) > 0.0,
        "without an offset the pair is bevel",
        code="no-offset",
        hint="use gear bevel --kind spiral",
    )
    # tan β₁ − tan β₂ = sin ε'/(cos β₁ cos β₂)
    curvature = curve * cos(limit) / apart
    apexes = _apexes(point, eta, first, radius)
    slide = sin(turned) / cos(own)
    wheel_speed = None if speed is None else speed * (first_teeth / second_teeth)
    return HypoidData(
        ratio=point.u,
        first_pitch_angle=first,
        second_pitch_angle=wheel,
        first_spiral_angle=own,
        second_spiral_angle=spiral,
        axial_offset_angle=eta,
        pitch_offset_angle=turned,
        first_pitch_radius=radius,
        second_pitch_radius=point.radius,
        first_cone_distance=cones[0],
        second_cone_distance=cones[1],
        enlargement=radius * point.u / point.radius,
        normal_module=2.0 * point.radius * cos(spiral) / second_teeth,
        first_apex_distance=apexes[0],
        second_apex_distance=apexes[1],
        limit_pressure_angle=limit,
        limit_curvature=curvature,
        sliding_ratio=slide,
        sliding_speed=None if wheel_speed is None else absolute(wheel_speed * point.radius * slide),
        second_speed=wheel_speed,
        checks=_checks(point, eta, first, turned, radius, spiral),
        advice=_advice(turned, spiral, plain(wheel) - plain(plain_wheel)),
    )


def _apexes(point: _Point, eta: float, first: float, radius: float) -> tuple[float, float]:
    """Apexes of both cones from the crossing point, from the pitch point at (r₂ cos η, r₂ sin η, 0) by vectors."""
    wheel, shafts = point.wheel, point.shafts
    reach = radius / cos(first)
    # pinion axis: through A = P + t n, along k₁ = (sin Σ, 0, −cos Σ); wheel axis: the z axis, its apex up
    x = (point.radius + reach * cos(wheel)) * cos(eta)
    z = reach * sin(wheel)
    # the crossing point in the view along the common perpendicular has x = 0
    along = x / sin(shafts)
    crossing = z + along * cos(shafts)
    # A is the foot of the cone's normal: its apex lies back along the axis by t/sin δ₁
    return along - reach / sin(first), point.radius * cos(wheel) / sin(wheel) - crossing


def _checks(point: _Point, eta: float, first: float, turned: float, radius: float, spiral: float) -> tuple[Check, ...]:
    """Velocities along the common normal of the teeth, and the right triangle sin ε' = sin η sin Σ/cos δ₁."""
    own, other = plain(radius) * cos(plain(point.spiral)) * plain(point.u), plain(point.radius) * cos(plain(spiral))
    normal = abs(own - other) / plain(point.radius)
    triangle = abs(sin(plain(turned)) - sin(plain(eta)) * sin(plain(point.shafts)) / cos(plain(first)))
    return (
        Check("equal speeds along the normal", normal <= 1e-13, normal, 1e-13),
        Check("offset angles", triangle <= 1e-13, triangle, 1e-13),
    )


def _advice(turned: float, spiral: float, wheel: float) -> tuple[Advice, ...]:
    made = []
    if plain(spiral) < 0.0:
        made.append(
            Advice(
                "wheel-spiral",
                f"the wheel's spiral angle is {plain(spiral) * 180.0 / pi:.4g} degrees: its hand would turn over",
                mend="raise the pinion's spiral angle, or lower the offset",
            )
        )
    if abs(plain(turned)) > 40.0 * pi / 180.0:
        made.append(
            Advice("long-sliding", f"the offset angle {plain(turned) * 180.0 / pi:.3g} degrees makes much sliding")
        )
    if wheel == 0.0:
        made.append(
            Advice("wheel-pitch-angle", "the wheel's pitch angle is that of the bevel pair", "note", "choose your own")
        )
    return tuple(made)
