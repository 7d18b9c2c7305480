"""Rolling wheels and belts: speeds, length and wrap of the belt, and the force that friction transmits."""

from math import pi

from dynamics_cli.errors import require, require_given, worded
from dynamics_cli.gear.load import torque_of
from dynamics_cli.numerics.elementary import absolute, acos, asin, exp, pi_beside, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Force,
    Friction,
    LinearDensity,
    Power,
    Ratio,
    ShaftSpeed,
    Size,
    Speed,
    Torque,
)
from dynamics_cli.records import Advice, Check, Choice, record


class Drive(Choice):
    """Type of drive between the wheels."""

    names = ("external", "internal", "open-belt", "crossed-belt")
    aliases = {"contact": "external", "rolling": "external", "belt": "open-belt"}  # noqa: RUF012


@record
class WheelsData:
    """Two wheels that roll on each other or share a belt."""

    ratio: Annotated[Ratio, "Speed of the first over that of the second, negative when they turn opposite ways."]
    second_speed: Annotated[ShaftSpeed | None, "Speed of the second wheel [rad/s]."]
    rim_speed: Annotated[Speed | None, "Speed of both rims, and of the belt [m/s]."]
    centre_distance: Annotated[Size, "Distance of the axes [m]."]
    belt_length: Annotated[Size | None, "Length of the belt [m]."]
    span: Annotated[Size | None, "Free length of the belt between the wheels [m]."]
    first_wrap: Annotated[Angle | None, "Angle of wrap on the first wheel [rad]."]
    second_wrap: Annotated[Angle | None, "Angle of wrap on the second wheel [rad]."]
    tension_ratio: Annotated[
        Ratio | None, "Tight over slack tension when the belt is about to slip, both less the centrifugal tension."
    ]
    tight_tension: Annotated[Force | None, "Tension of the tight side that just carries the load [N]."]
    slack_tension: Annotated[Force | None, "Tension of the slack side then [N]."]
    normal_force: Annotated[Force | None, "Force that must press rolling wheels together [N]."]
    rim_force: Annotated[Force | None, "Force at the rims [N]."]
    first_torque: Annotated[Torque | None, "Torque on the first wheel [N*m]."]
    second_torque: Annotated[Torque | None, "Torque on the second wheel [N*m]."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def wheels(
    *,
    first_diameter: Annotated[Size, "Diameter of the driving wheel, e.g. 100 mm [m]."],
    second_diameter: Annotated[Size, "Diameter of the driven wheel, e.g. 300 mm [m]."],
    drive: Annotated[
        Drive, "Rolling outside (external) or inside (internal), or by an open-belt or crossed-belt."
    ] = Drive("external"),  # noqa: B008
    centre_distance: Annotated[Size | None, "Distance of the axes; belts need one, e.g. 500 mm [m]."] = None,
    speed: Annotated[ShaftSpeed | None, "Speed of the first wheel [rad/s]."] = None,
    friction: Annotated[
        Friction | None, "Coefficient of friction between the wheels, or of belt and wheel, e.g. 0.3."
    ] = None,
    torque: Annotated[Torque | None, "Torque on the first wheel, e.g. 12 N*m [N*m]."] = None,
    power: Annotated[Power | None, "Power, in place of the torque; needs the speed, e.g. 2 kW [W]."] = None,
    belt_mass: Annotated[
        LinearDensity, "Mass of the belt per length, whose inertia lifts it off at speed [kg/m]."
    ] = 0.0,
) -> WheelsData:
    """Speeds of two wheels that roll without slipping or share a belt, belt length and wrap, and friction's limit.

    Equation
    --------
    r₁ω₁ = r₂ω₂ (opposite ways when rolling outside or with a crossed belt); open belt: L = 2√(C² − (r₂ − r₁)²) +
    r₁θ₁ + r₂θ₂, θ = π ∓ 2 asin((r₂ − r₁)/C); crossed: r₂ + r₁ for the difference; (T₁ − mv²)/(T₂ − mv²) = exp(μθ).

    Returns
    -------
    WheelsData
        Speeds, belt and forces.

    Raises
    ------
    InadmissibleError
        When a wheel has no diameter, a belt's wheels overlap, the distance of rolling wheels does not match their
        radii, or a load is given without friction.

    Notes
    -----
    Rigid wheels and a belt that neither stretches nor resists bending.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 17.2; Euler's belt formula.

    Examples
    --------
    >>> answer = wheels(first_diameter=0.1, second_diameter=0.3, drive=Drive("open-belt"), centre_distance=0.5)
    >>> round(answer.belt_length, 4)
    1.6484
    """
    first, second = 0.5 * first_diameter, 0.5 * second_diameter
    require((first > 0.0) & (second > 0.0), "a wheel needs a diameter above zero", code="diameter")
    belt = drive in ("open-belt", "crossed-belt")
    opposite = drive in ("external", "crossed-belt")
    ratio = -second / first if opposite else second / first
    load = torque_of(torque, power, speed)
    rim = None if speed is None else absolute(speed) * first
    force = None if load is None else absolute(load) / first
    length = span = tension = tight = slack = normal = None
    wraps: tuple[float | None, float | None] = (None, None)
    if belt:
        distance, span, wraps = _belt(first, second, centre_distance, drive)
        length = 2.0 * span + first * wraps[0] + second * wraps[1]
        if friction is not None:
            least = wraps[0] if plain(wraps[0]) <= plain(wraps[1]) else wraps[1]
            tension = exp(friction * least)
    else:
        distance = _rolling(first, second, centre_distance, drive)
    if force is not None and friction is not None:
        require(friction > 0.0, "without friction no load is carried", code="friction")
        if belt:
            lifted = 0.0 if rim is None else belt_mass * rim * rim
            slack = force / (tension - 1.0) + lifted  # type: ignore[operator]
            tight = slack + force
        else:
            normal = force / friction
    return WheelsData(
        ratio=ratio,
        second_speed=None if speed is None else speed / ratio,
        rim_speed=rim,
        centre_distance=distance,
        belt_length=length,
        span=span,
        first_wrap=wraps[0],
        second_wrap=wraps[1],
        tension_ratio=tension,
        tight_tension=tight,
        slack_tension=slack,
        normal_force=normal,
        rim_force=force,
        first_torque=load,
        second_torque=None if load is None else load * ratio,
        checks=() if not belt else _checks(first, second, wraps, drive),
        advice=_advice(wraps, belt, friction, load),
    )


def _belt(first: float, second: float, distance: float | None, drive: str) -> tuple[float, float, tuple[float, float]]:
    """Centre distance, free span and both wraps of a belt."""
    require_given(
        distance is not None, "a belt needs the distance between the axes", ("centre_distance",), code="no-distance"
    )
    apart: float = distance  # type: ignore[assignment]
    require(
        apart >= first + second,
        "wheels of {first:6} and {second:6} radius overlap at a distance of {apart:6}",
        first=(first, Size),
        second=(second, Size),
        apart=(apart, Size),
        code="overlap",
    )
    if drive == "crossed-belt":
        radius_sum = first + second
        span = sqrt((apart - radius_sum) * (apart + radius_sum))
        wrap = 2.0 * acos(-(radius_sum / apart))
        return apart, span, (wrap, wrap)
    lean = second - first
    span = sqrt((apart - lean) * (apart + lean))
    tilt = 2.0 * asin(lean / apart)
    around = pi_beside(tilt)
    return apart, span, (around - tilt, around + tilt)


def _rolling(first: float, second: float, distance: float | None, drive: str) -> float:
    apart = first + second if drive == "external" else absolute(second - first)
    require(drive == "external" or apart > 0.0, "equal wheels do not roll inside each other", code="equal-wheels")
    require(
        distance is None or absolute(distance - apart) <= 1e-9 * (first + second),
        "rolling wheels of these diameters are {apart:9} apart, not {distance:9}",
        apart=(plain(apart), Size),
        distance=(None if distance is None else plain(distance), Size),
        code="distance",
        hint="leave --centre-distance out",
    )
    return apart


def _checks(first: float, second: float, wraps: "tuple[float | None, float | None]", drive: str) -> tuple[Check, ...]:
    """Check that a closed belt turns by one full turn, or by zero if it is crossed."""
    total = plain(wraps[0]) + (-plain(wraps[1]) if drive == "crossed-belt" else plain(wraps[1]))
    residual = abs(total - (0.0 if drive == "crossed-belt" else 2.0 * pi))
    return (Check("turns of the belt", residual <= 1e-14, residual, 1e-14),)


def _advice(
    wraps: "tuple[float | None, float | None]", belt: bool, friction: float | None, load: float | None
) -> tuple[Advice, ...]:
    if belt and min(plain(wraps[0]), plain(wraps[1])) < 2.0 * pi / 3.0:
        message = worded("the belt wraps only {wrap} of one wheel", wrap=(min(plain(wraps[0]), plain(wraps[1])), Angle))
        return (Advice("small-wrap", message, remedy="move the axes apart, or lead the slack side over an idler"),)
    if load is not None and friction is None:
        return (Advice("no-friction", "whether friction carries the load is not known", "note", "give --friction"),)
    return ()
