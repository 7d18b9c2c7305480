"""Crossed helical (screw) gears on skew shafts, by the virtual gears of handbooks."""

from math import pi

from dynamics_cli.errors import require, worded
from dynamics_cli.gear.crossing.virtual_teeth import tooth_advice
from dynamics_cli.gear.pitch import require_module
from dynamics_cli.gear.single.gear import Gear, signed_gear
from dynamics_cli.gear.single.rack import FULL_DEPTH, basic_rack
from dynamics_cli.numerics.elementary import absolute, atan, cos, sin, tan
from dynamics_cli.numerics.involute import inverse_involute, involute
from dynamics_cli.numerics.number import like, plain
from dynamics_cli.quantities import Angle, Annotated, Fraction, Friction, Module, Ratio, ShaftSpeed, Size, Speed, Teeth
from dynamics_cli.records import Advice, record

# Working pressure angles that differ by less than a millionth of a degree agree.
LEAST_DIFFERENCE = 1e-6 * pi / 180.0


@record
class Screw:
    """One gear of a crossed pair."""

    teeth: Annotated[Teeth, "Number of teeth."]
    helix_angle: Annotated[
        Angle, "Helix angle β at the reference cylinder, right hand positive, left hand negative, e.g. 15 deg [rad]."
    ]
    profile_shift: Annotated[Ratio, "Profile shift factor, in normal modules."] = 0.0


@record
class CrossedData:
    """A pair of crossed helical gears."""

    shaft_angle: Annotated[Angle, "Working shaft angle Σ [rad]."]
    reference_shaft_angle: Annotated[Angle, "Shaft angle of the reference helices, |β₁ + β₂| [rad]."]
    centre_distance: Annotated[Size, "Working centre distance a_w [m]."]
    reference_distance: Annotated[Size, "Reference centre distance (d₁ + d₂)/2 [m]."]
    distance_modification: Annotated[Ratio, "Centre distance modification factor y."]
    working_pressure_angle: Annotated[Angle, "Working normal pressure angle α_wn [rad]."]
    involute: Annotated[Ratio, "inv α_wn."]
    ratio: Annotated[Ratio, "Gear ratio z₂/z₁."]
    first_diameter: Annotated[Size, "Reference diameter d₁ [m]."]
    second_diameter: Annotated[Size, "Reference diameter d₂ [m]."]
    first_working_diameter: Annotated[Size, "Working pitch diameter d_w1 [m]."]
    second_working_diameter: Annotated[Size, "Working pitch diameter d_w2 [m]."]
    first_working_helix: Annotated[Angle, "Working helix angle β_w1, with its hand [rad]."]
    second_working_helix: Annotated[Angle, "Working helix angle β_w2, with its hand [rad]."]
    first_tip_diameter: Annotated[Size, "Tip diameter d_a1 that keeps the tip clearance [m]."]
    second_tip_diameter: Annotated[Size, "Tip diameter d_a2 that keeps the tip clearance [m]."]
    first_root_diameter: Annotated[Size, "Root diameter d_f1 [m]."]
    second_root_diameter: Annotated[Size, "Root diameter d_f2 [m]."]
    efficiency: Annotated[Fraction, "Efficiency at the pitch point when the first drives."]
    backward_efficiency: Annotated[Fraction, "Efficiency when the second drives; at or below zero it cannot."]
    sliding_speed: Annotated[Speed | None, "Sliding velocity along the teeth at the pitch point [m/s]."]
    second_speed: Annotated[ShaftSpeed | None, "Speed of the second gear [rad/s]."]
    advice: tuple[Advice, ...] = ()


def _shafts(first: Screw, second: Screw) -> float:
    """The shaft angle without profile shift."""
    reference_angle = absolute(first.helix_angle + second.helix_angle)
    require(
        reference_angle > 0.0,
        "the helices {first:6} and {second:6} cancel: the shafts are parallel",
        first=(first.helix_angle, Angle),
        second=(second.helix_angle, Angle),
        code="parallel",
        hint="use gear pair",
    )
    return reference_angle


def _working_involute(gears: list[Gear], shifts: float, pressure_angle: float) -> tuple[float, float]:
    """The sum of the virtual numbers of teeth, and inv α_wn."""
    cosines = [cos(gear.helix_angle) for gear in gears]
    virtual = sum(gear.teeth / (c * c * c) for gear, c in zip(gears, cosines, strict=True))
    value = involute(pressure_angle) + 2.0 * shifts * tan(pressure_angle) / virtual
    require(
        value >= 0.0,
        "inv α_wn would be {involute:6}, below 0",
        involute=(value, Ratio),
        code="involute-below-zero",
        hint="raise the profile shifts",
    )
    return virtual, value


def crossed(
    *,
    first: Annotated[Screw, "The driving gear."],
    second: Annotated[Screw, "The driven gear."],
    module: Annotated[Module, "Normal module m_n [m]."],
    pressure_angle: Annotated[Angle, "Normal pressure angle α_n [rad]."] = FULL_DEPTH,
    addendum_factor: Annotated[Ratio, "Addendum factor h_a*."] = 1.0,
    dedendum_factor: Annotated[Ratio, "Dedendum factor h_fP*."] = 1.25,
    friction: Annotated[Friction, "Coefficient of friction of the flanks."] = 0.06,
    speed: Annotated[ShaftSpeed | None, "Speed of the first gear [rad/s]."] = None,
) -> CrossedData:
    """Centre distance, working helices and shaft angle, sliding and efficiency of crossed helical gears.

    Equation
    --------
    z_v = z/cos³β; inv α_wn = inv α_n + 2(x₁ + x₂)tan α_n/(z_v1 + z_v2); y = (z_v1 + z_v2)(cos α_n/cos α_wn − 1)/2;
    a_w = (d₁ + d₂)/2 + y m_n; tan β_w = (d_w/d)tan β; Σ = |β_w1 + β_w2|.

    Returns
    -------
    CrossedData
        The pair.

    Raises
    ------
    InadmissibleError
        When the helices make the shafts parallel, inv α_wn would be negative, or one gear is impossible.

    Notes
    -----
    Exact for x₁ + x₂ = 0; otherwise the handbooks' approximation by virtual spur gears, whose two working normal
    pressure angles sin β_b/sin β_w differ: the advice says by how much.

    References
    ----------
    KHK gear technical reference, screw gears; Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002,
    section 17.14.

    Examples
    --------
    >>> from math import radians
    >>> answer = crossed(first=Screw(15, radians(20), 0.4), second=Screw(24, radians(30), 0.2), module=0.003)
    >>> round(1e3 * answer.centre_distance, 4)
    67.1925
    """
    require_module(module)
    pressure_angle = like(pressure_angle, module)
    rack = basic_rack("a", pressure_angle, addendum_factor, dedendum_factor, 0.0)
    gears = [
        signed_gear(screw.teeth, module, rack, helix_angle=screw.helix_angle, shift=screw.profile_shift)
        for screw in (first, second)
    ]
    reference_angle = _shafts(first, second)
    virtual, value = _working_involute(gears, first.profile_shift + second.profile_shift, pressure_angle)
    working = inverse_involute(value)
    modification = 0.5 * virtual * (cos(pressure_angle) / cos(working) - 1.0)
    reference = 0.5 * (gears[0].reference_diameter + gears[1].reference_diameter)
    distance = reference + modification * module
    growth = distance / reference
    helices = [atan(growth * tan(screw.helix_angle)) for screw in (first, second)]
    shafts = absolute(helices[0] + helices[1])
    clearance = modification - first.profile_shift - second.profile_shift
    tips = [gear.reference_diameter + 2.0 * module * (addendum_factor + gear.shift + clearance) for gear in gears]
    rho = atan(friction / cos(working))
    lead, lag = _oriented(helices)
    return CrossedData(
        shaft_angle=shafts,
        reference_shaft_angle=reference_angle,
        centre_distance=distance,
        reference_distance=reference,
        distance_modification=modification,
        working_pressure_angle=working,
        involute=value,
        ratio=second.teeth / first.teeth,
        first_diameter=gears[0].reference_diameter,
        second_diameter=gears[1].reference_diameter,
        first_working_diameter=gears[0].reference_diameter * growth,
        second_working_diameter=gears[1].reference_diameter * growth,
        first_working_helix=helices[0],
        second_working_helix=helices[1],
        first_tip_diameter=tips[0],
        second_tip_diameter=tips[1],
        first_root_diameter=gears[0].root_diameter,
        second_root_diameter=gears[1].root_diameter,
        efficiency=cos(lag + rho) * cos(lead) / (cos(lag) * cos(lead - rho)),
        backward_efficiency=cos(lead + rho) * cos(lag) / (cos(lead) * cos(lag - rho)),
        sliding_speed=None
        if speed is None
        else 0.5 * absolute(speed) * gears[0].reference_diameter * growth * sin(shafts) / cos(lag),
        second_speed=None if speed is None else speed * (first.teeth / second.teeth),
        advice=_advice(gears, helices, working) + _teeth_advice(gears, addendum_factor, clearance),
    )


def _oriented(helices: list[float]) -> tuple[float, float]:
    """Both helix angles with the sign that makes their sum positive."""
    if plain(helices[0] + helices[1]) >= 0.0:
        return helices[0], helices[1]
    return -helices[0], -helices[1]


def _advice(gears: list[Gear], helices: list[float], working: float) -> tuple[Advice, ...]:
    """Difference of the two gears' working pressure angles."""
    angles = []
    for gear, helix in zip(gears, helices, strict=True):
        helix_angle = abs(plain(helix))
        if helix_angle > 1e-6:
            ratio = sin(plain(gear.base_helix_angle)) / sin(helix_angle)
            angles.append(atan((max(1.0 - ratio * ratio, 0.0)) ** 0.5 / ratio))
    difference = max((abs(angle - plain(working)) for angle in angles), default=0.0)
    if difference < LEAST_DIFFERENCE:
        return ()
    message = worded(
        "approximation by virtual gears: the working normal pressure angles of the two gears differ from "
        "it by up to {difference:3}",
        difference=(difference, Angle),
    )
    return (Advice("approximate", message, "note", "with profile shifts that sum to zero the geometry is exact"),)


def _teeth_advice(gears: list[Gear], addendum: float, clearance: float) -> tuple[Advice, ...]:
    """Undercut and tips of each gear in its transverse section; the rack's corner lies within the tip clearance."""
    advice: tuple[Advice, ...] = ()
    remedy = "raise its profile shift, or give it more teeth", "lower its profile shift"
    for gear, who in zip(gears, ("the first gear", "the second gear"), strict=True):
        cosine = cos(gear.helix_angle)
        height, depth = (addendum + gear.shift + clearance) * cosine, (addendum - gear.shift) * cosine
        # s_t/m_t keeps π/2 + 2x·tan α_n = π/2 + 2x·cos β·tan α_t
        advice += tooth_advice(who, gear.teeth, gear.transverse_angle, height, depth, gear.shift * cosine, remedy)
    return advice
