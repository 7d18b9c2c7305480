"""Hypoid gears at the pitch point: two cones that touch with their axes apart."""

from math import pi

from dynamics_cli.errors import require, worded
from dynamics_cli.gear.crossing.hypoid_records import HypoidData
from dynamics_cli.numerics.elementary import absolute, asin, atan, atan2, cos, sin, sqrt, tan
from dynamics_cli.numerics.number import like, plain
from dynamics_cli.numerics.roots import sign_change
from dynamics_cli.quantities import Angle, Annotated, Coordinate, ShaftSpeed, Size, Teeth
from dynamics_cli.records import Advice, Check

RIGHT_ANGLE = 0.5 * pi
PINION_SPIRAL = 50.0 * pi / 180.0


def _require_pair(shaft_angle: float, wheel_radius: float, pinion_spiral_angle: float) -> None:
    require(
        (shaft_angle > 0.0) & (shaft_angle < pi),
        "the shaft angle {shaft_angle:6} must be above 0 and below 180 degrees",
        shaft_angle=(shaft_angle, Angle),
        code="shaft-angle",
    )
    require(
        wheel_radius > 0.0,
        "the pitch radius of the wheel must be above zero, not {wheel_radius:6}",
        wheel_radius=(wheel_radius, Size),
        code="wheel-radius",
    )
    require(
        absolute(pinion_spiral_angle) < 0.5 * pi,
        "the spiral angle {pinion_spiral_angle:6} must be below 90 degrees",
        pinion_spiral_angle=(pinion_spiral_angle, Angle),
        code="spiral-angle",
    )


def hypoid(
    *,
    first_teeth: Annotated[Teeth, "Number of teeth of the pinion z₁, e.g. 20."],
    second_teeth: Annotated[Teeth, "Number of teeth of the wheel z₂, e.g. 40."],
    offset: Annotated[
        Coordinate | None,
        "Hypoid offset E; positive enlarges the pinion, negative (as on crane axles, rarely) shrinks it [m]. Left "
        "out, it follows from both spiral angles, e.g. 35 mm.",
    ] = None,
    wheel_radius: Annotated[Size, "Mean pitch radius of the wheel r₂, e.g. 85 mm [m]."],
    pinion_spiral_angle: Annotated[Angle, "Spiral angle of the pinion β₁ [rad]."] = PINION_SPIRAL,
    wheel_spiral_angle: Annotated[
        Angle | None, "Spiral angle of the wheel β₂, in place of the offset, e.g. 27 deg [rad]."
    ] = None,
    wheel_pitch_angle: Annotated[
        Angle | None,
        "Pitch angle of the wheel δ₂; unless given, as in the bevel pair without offset, e.g. 70 deg [rad].",
    ] = None,
    shaft_angle: Annotated[Angle, "Shaft angle Σ [rad]."] = RIGHT_ANGLE,
    speed: Annotated[ShaftSpeed | None, "Speed of the pinion [rad/s]."] = None,
) -> HypoidData:
    """Pitch-point geometry of a hypoid pair: cones, offset and spiral angles, sliding, limit pressure angle.

    Equation
    --------
    sin η = E/(r₂ + r₁cos δ₂/cos δ₁); sin δ₁ = cos δ₂ cos η sin Σ − sin δ₂ cos Σ; tan ε' = sin η sin Σ/(cos η sin δ₂
    sin Σ + cos δ₂ cos Σ); β₂ = β₁ − ε'; r₁ = r₂(z₁/z₂)cos β₂/cos β₁.

    Returns
    -------
    HypoidData
        The pitch point.

    Raises
    ------
    InadmissibleError
        When the offset is too large for the wheel, or no pinion cone touches the wheel there.

    Notes
    -----
    The wheel pitch angle is the designer's choice and an input; a suitable cutter has the limit curvature. Tooth
    proportions (ISO 23509) and strength are outside this task. Without offset the pair is bevel.

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
    _require_pair(shaft_angle, wheel_radius, pinion_spiral_angle)
    pinion_spiral_angle, shaft_angle = like(pinion_spiral_angle, wheel_radius), like(shaft_angle, wheel_radius)
    u = second_teeth / first_teeth
    plain_wheel = atan2(u * sin(shaft_angle), 1.0 + u * cos(shaft_angle))
    wheel = plain_wheel if wheel_pitch_angle is None else wheel_pitch_angle
    require(
        (offset is None) != (wheel_spiral_angle is None),
        "give the offset or the wheel's spiral angle: the other follows from it",
        code="offset",
        hint='--offset "30 mm" or --wheel-spiral-angle "30 deg"',
    )
    if offset is None:
        assert wheel_spiral_angle is not None
        pitch = _Point(u, 0.0, wheel_radius, pinion_spiral_angle, wheel, shaft_angle)
        eta = pitch.offset_angle(pinion_spiral_angle - wheel_spiral_angle)
        offset_reached = pitch.residual(eta)
    else:
        offset_reached = offset
    require(
        absolute(offset_reached) < wheel_radius,
        "an offset of {offset:6} is not less than the wheel's radius {wheel_radius:6}",
        offset=(absolute(offset_reached), Size),
        wheel_radius=(wheel_radius, Size),
        code="offset",
    )
    point = _Point(u, offset_reached, wheel_radius, pinion_spiral_angle, wheel, shaft_angle)
    if offset is not None:
        eta = _solved(point)
    first, turned, radius = point.at(eta)
    require(
        first > 0.0,
        "no pinion fits a wheel pitch angle of {wheel:6} at this offset angle",
        wheel=(plain(wheel), Angle),
        code="wheel-pitch-angle",
    )
    spiral = pinion_spiral_angle - turned
    return _result(point, eta, first, turned, radius, spiral, plain_wheel, first_teeth, second_teeth, speed,
                   None if offset is not None else offset_reached)  # fmt: skip


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

    def offset_angle(self, turned: float) -> float:
        """η of the pitch offset angle ε' = β₁ − β₂: sin η sin Σ cos ε' = sin ε'(cos η sin δ₂ sin Σ + cos δ₂ cos Σ)."""
        components = sin(self.shafts) * cos(turned), sin(turned) * sin(self.wheel) * sin(self.shafts)
        rest = sin(turned) * cos(self.wheel) * cos(self.shafts)
        size = sqrt(components[0] * components[0] + components[1] * components[1])
        require(
            absolute(rest) < size,
            "no offset turns the teeth by {turned:6}",
            turned=(plain(turned), Angle),
            code="spiral-angle",
            hint="bring the spiral angles closer together",
        )
        return atan2(components[1], components[0]) + asin(rest / size)

    def residual(self, eta: float) -> float:
        """Offset of the pinion's axis at η, less the one wanted."""
        first, _, radius = self.at(eta)
        return sin(eta) * (self.radius + radius * cos(self.wheel) / cos(first)) - self.offset


def _solved(point: _Point) -> float:
    """η in doubles within its bracket, and one Newton step in the numbers of the input."""
    doubles = point.bare()
    least = doubles.at(0.0)[0]
    require(
        least > 0.0,
        "no pinion fits a wheel pitch angle of {wheel:6} at this shaft angle",
        wheel=(plain(doubles.wheel), Angle),
        code="wheel-pitch-angle",
    )
    sign = 1.0 if doubles.offset >= 0.0 else -1.0
    high = 0.0
    step = 0.01
    while sign * doubles.residual(sign * high) < 0.0:
        high += step
        first, turned, _ = doubles.at(sign * high)
        require(
            high < 0.5 * pi and first > 0.0 and abs(doubles.spiral - turned) < 0.5 * pi,
            "no pinion reaches an offset of {offset:6} on this wheel: its cone closes at an angle of {closing_angle}",
            offset=(doubles.offset, Size),
            closing_angle=(high, Angle),
            code="offset",
            hint="a smaller offset, or another pitch angle of the wheel",
        )
    roots = (
        sign * sign_change(lambda eta: -sign * doubles.residual(sign * eta), high - step, high)
        if doubles.offset
        else 0.0
    )
    slope = (doubles.residual(roots + 1e-6) - doubles.residual(roots - 1e-6)) / 2e-6
    # As a tracked number, so that the rounding of its sine and cosine is included.
    start = point.offset * 0.0 + roots
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
    offset: float | None,
) -> HypoidData:
    wheel, pinion_spiral = point.wheel, point.spiral
    cones = radius / sin(first), point.radius / sin(wheel)
    lean = tan(first) * tan(wheel) / cos(turned)
    below = cones[0] * tan(first) + cones[1] * tan(wheel)
    limit = atan(-lean * (cones[0] * sin(pinion_spiral) - cones[1] * sin(spiral)) / below)
    bend = tan(pinion_spiral) / (cones[0] * tan(first)) + tan(spiral) / (cones[1] * tan(wheel))
    curve = -tan(limit) * bend + 1.0 / (cones[0] * cos(pinion_spiral)) - 1.0 / (cones[1] * cos(spiral))
    apart = sin(turned) / (cos(pinion_spiral) * cos(spiral))
    require(
        absolute(apart) > 0.0,
        "without an offset the pair is bevel",
        code="no-offset",
        hint="use gear bevel --kind spiral",
    )
    # tan β₁ − tan β₂ = sin ε'/(cos β₁ cos β₂)
    curvature = curve * cos(limit) / apart
    apexes = _apexes(point, eta, first, radius)
    slide = sin(turned) / cos(pinion_spiral)
    wheel_speed = None if speed is None else speed * (first_teeth / second_teeth)
    return HypoidData(
        ratio=point.u,
        first_pitch_angle=first,
        second_pitch_angle=wheel,
        first_spiral_angle=pinion_spiral,
        second_spiral_angle=spiral,
        axial_offset_angle=eta,
        pitch_offset_angle=turned,
        first_pitch_radius=radius,
        second_pitch_radius=point.radius,
        first_cone_distance=cones[0],
        second_cone_distance=cones[1],
        offset=offset,
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
    own, second = plain(radius) * cos(plain(point.spiral)) * plain(point.u), plain(point.radius) * cos(plain(spiral))
    normal = abs(own - second) / plain(point.radius)
    triangle = abs(sin(plain(turned)) - sin(plain(eta)) * sin(plain(point.shafts)) / cos(plain(first)))
    return (
        Check("equal speeds along the normal", normal <= 1e-13, normal, 1e-13),
        Check("offset angles", triangle <= 1e-13, triangle, 1e-13),
    )


def _advice(turned: float, spiral: float, wheel: float) -> tuple[Advice, ...]:
    advice = []
    if plain(spiral) < 0.0:
        message = worded(
            "the wheel's spiral angle is {spiral}: its hand would be reversed", spiral=(plain(spiral), Angle)
        )
        advice.append(Advice("wheel-spiral", message, remedy="raise the pinion's spiral angle, or lower the offset"))
    if abs(plain(turned)) > 40.0 * pi / 180.0:
        text = worded("the offset angle of {turned:3} causes much lengthwise sliding", turned=(plain(turned), Angle))
        advice.append(Advice("long-sliding", text))
    if wheel == 0.0:
        advice.append(
            Advice(
                "wheel-pitch-angle", "the wheel's pitch angle is that of the bevel pair", "note", "choose one to suit"
            )
        )
    return tuple(advice)
