"""One cylindrical gear, spur or helical, external or internal: every diameter, pitch, thickness and limit."""

from math import pi

from dynamics_cli.errors import require, worded
from dynamics_cli.gear import options
from dynamics_cli.gear.pitch import Pitch, SpurPitch, module_advice, module_of
from dynamics_cli.gear.single.gear import Gear, Hand, require_circles, signed_gear
from dynamics_cli.gear.single.limits import LEAST_TIP, least_shift, least_teeth, pointed_shift
from dynamics_cli.gear.single.rack import FULL_DEPTH, basic_rack
from dynamics_cli.gear.single.records import GearData
from dynamics_cli.numerics.elementary import absolute, atan, cos, pi_beside, sin, tan
from dynamics_cli.numerics.number import over_plain, plain
from dynamics_cli.quantities import Angle, Annotated, Ratio, Size, Teeth
from dynamics_cli.records import Advice, Check

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def spur(
    *,
    teeth: Annotated[Teeth, "Number of teeth z (AGMA: N)."],
    pitch: Annotated[SpurPitch, "Size of the teeth."],
    pressure_angle: Annotated[Angle, "Pressure angle α of the rack (AGMA: φ) [rad]."] = FULL_DEPTH,
    profile_shift: Annotated[Ratio, "Profile shift factor x, in modules."] = 0.0,
    profile: options.RackName = options.RACK_A,
    addendum_factor: options.AddendumFactor = None,
    dedendum_factor: options.DedendumFactor = None,
    root_radius_factor: options.RackCorner = None,
    tip_shortening: options.TipShortening = 0.0,
    tip_diameter: options.TipDiameter = None,
    internal: options.Internal = False,
    shift_sign: options.ShiftSign = options.ISO,
    avoid_undercut: options.AvoidUndercut = False,
) -> GearData:
    """All dimensions of one spur gear from its generating rack.

    Equation
    --------
    d = z m; d_b = d cos α; d_a = d + 2m(h_a* + x + k); d_f = d − 2m(h_fP* − x); s = m(π/2 + 2x tan α);
    s_a = d_a(s/d + inv α − inv α_a).

    Returns
    -------
    GearData
        Diameters, pitches, thicknesses and limits.

    Raises
    ------
    InadmissibleError
        When the gear is impossible: the circles are out of order, the teeth are pointed below their tips, the rack
        leaves no involute, an internal tip lies inside the base circle, or no shift avoids undercut.

    Notes
    -----
    Geometry without allowances. Rating of strength (ISO 6336, AGMA 2001) is outside this program. The tip thickness is
    a difference: its condition grows as the tooth becomes pointed.

    References
    ----------
    ISO 21771, ISO 53; Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 17.4 and 17.5.

    Examples
    --------
    >>> from dynamics_cli.gear.pitch import NormalModule
    >>> round(1e3 * spur(teeth=12, pitch=NormalModule(0.003)).base_diameter, 3)
    33.829
    """
    return _described(hand=None, helix_angle=0.0, transverse_pressure_angle=None, **locals())


def helical(
    *,
    teeth: Annotated[Teeth, "Number of teeth z (AGMA: N)."],
    pitch: Annotated[Pitch, "Size of the teeth, normal or transverse."],
    helix_angle: Annotated[Angle, "Helix angle β at the reference cylinder (AGMA: ψ), e.g. 15 deg [rad]."],
    hand: options.HelixHand = options.RIGHT,
    pressure_angle: Annotated[
        Angle | None, "Normal pressure angle α_n (AGMA: φ_n); 20 degrees unless one is given, e.g. 20 deg [rad]."
    ] = None,
    transverse_pressure_angle: options.TransverseAngle = None,
    profile_shift: Annotated[Ratio, "Profile shift factor x, in normal modules."] = 0.0,
    profile: options.RackName = options.RACK_A,
    addendum_factor: options.AddendumFactor = None,
    dedendum_factor: options.DedendumFactor = None,
    root_radius_factor: options.RackCorner = None,
    tip_shortening: options.TipShortening = 0.0,
    tip_diameter: options.TipDiameter = None,
    internal: options.Internal = False,
    shift_sign: options.ShiftSign = options.ISO,
    avoid_undercut: options.AvoidUndercut = False,
) -> GearData:
    """All dimensions of one helical gear from its generating rack.

    Equation
    --------
    m_t = m_n/cos β; tan α_t = tan α_n/cos β; d = z m_t; sin β_b = sin β cos α_n; p_z = π d/tan β; factors and shift
    count in normal modules.

    Returns
    -------
    GearData
        Diameters, pitches, thicknesses and limits.

    Raises
    ------
    InadmissibleError
        As `spur` does, and for a helix of 90 degrees, or both pressure angles given.

    Notes
    -----
    Geometry without allowances. Rating of strength (ISO 6336, AGMA 2001) is outside this program.

    References
    ----------
    ISO 21771, ISO 53; Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 17.12.

    Examples
    --------
    >>> from dynamics_cli.gear.pitch import NormalModule
    >>> from math import degrees, radians
    >>> answer = helical(teeth=12, pitch=NormalModule(0.003), helix_angle=radians(30.0))
    >>> round(degrees(answer.transverse_pressure_angle), 5)
    22.79588
    """
    given = locals()
    leaning = hand if plain(helix_angle) >= 0.0 else Hand("left" if hand == "right" else "right")
    return _described(**{**given, "hand": leaning, "helix_angle": absolute(helix_angle)})


def _described(hand: "Hand | None", helix_angle: float, pitch: Pitch, **given: "Any") -> GearData:
    """All dimensions of the gear of a task's inputs, its helix angle a magnitude."""
    module = module_of(pitch, helix_angle)
    angle = normal_pressure_angle(given["pressure_angle"], given["transverse_pressure_angle"], helix_angle)
    factors = given["addendum_factor"], given["dedendum_factor"], given["root_radius_factor"]
    gear = signed_gear(
        given["teeth"],
        module,
        basic_rack(given["profile"], angle, *factors),
        internal=given["internal"],
        sign=given["shift_sign"],
        helix_angle=helix_angle,
        shift=given["profile_shift"],
        tip_change=-given["tip_shortening"] / module,
    )
    gear = _without_undercut(gear) if given["avoid_undercut"] else gear
    if given["tip_diameter"] is not None:
        require(
            plain(given["tip_shortening"]) == 0.0,
            "tip diameter and tip shortening are both given",
            code="tip-diameter",
            hint="give one of them: each follows from the other",
        )
        gear = gear.tipped(given["tip_diameter"])
        require_circles(gear)
    return describe(gear, pitch, hand)


def normal_pressure_angle(normal: float | None, transverse: float | None, helix_angle: float) -> float:
    """α_n, from whichever angle was given."""
    if transverse is None:
        return FULL_DEPTH if normal is None else normal
    require(
        normal is None,
        "the pressure angle is given twice, normal and transverse",
        code="two-pressure-angles",
        hint="give one of them",
    )
    require(
        transverse < 0.5 * pi,
        "the pressure angle {transverse:6} must be below 90 degrees",
        transverse=(transverse, Angle),
        code="pressure-angle",
    )
    return atan(tan(transverse) * cos(helix_angle))


def _without_undercut(gear: Gear) -> Gear:
    """The same gear with the smallest shift that avoids undercut."""
    require(not gear.internal, "an internal gear is not cut by a rack", code="internal")
    least = least_shift(gear)
    shift = least if least > 0.0 else 0.0 * least
    most = pointed_shift(gear)
    require(
        shift <= most,
        "no profile shift is possible with {teeth} teeth: undercut ends at x = {shift:6}, but the tips are pointed "
        "from x = {most:6}",
        teeth=gear.teeth,
        shift=(plain(shift), Ratio),
        most=(plain(most), Ratio),
        code="no-shift-serves",
        hint="use more teeth, a larger pressure angle, a smaller addendum factor, or shortened tips",
    )
    return gear.shifted(shift, gear.tip_change)


def describe(gear: Gear, pitch: object, hand: Hand | None) -> GearData:
    """All dimensions of a single gear; a spur gear has no `hand`."""
    junction = None if gear.internal else gear.junction
    form = None if junction is None else 2.0 * gear.module * junction.form_radius
    tip_thickness, tip_roll = gear.tip_thickness, gear.tip_roll
    _require_flanks(gear.tip_diameter, tip_thickness, form)
    least = None if gear.internal else least_shift(gear)
    most = None if gear.internal else pointed_shift(gear)
    module, rack = gear.module, gear.rack
    normal_pitch = pi_beside(module) * module
    normal_thickness = module * (0.5 * pi_beside(module) + 2.0 * gear.shift * tan(rack.pressure_angle))
    return GearData(
        reference_diameter=absolute(gear.reference_diameter),
        base_diameter=absolute(gear.base_diameter),
        tip_diameter=absolute(gear.tip_diameter),
        root_diameter=absolute(gear.root_diameter),
        root_form_diameter=form,
        v_diameter=absolute(gear.reference_diameter + 2.0 * gear.shift * module),
        normal_module=module,
        normal_pitch=normal_pitch,
        base_pitch=gear.base_pitch,
        tip_pressure_angle=atan(tip_roll),
        profile_shift=gear.shift,
        addendum=module * (rack.addendum + gear.shift + gear.tip_change),
        dedendum=module * (rack.dedendum - gear.shift),
        tooth_depth=module * (rack.addendum + rack.dedendum + gear.tip_change),
        root_radius=module * rack.tip_radius,
        normal_thickness=normal_thickness,
        transverse_space=(normal_pitch - normal_thickness) / cos(gear.helix_angle),
        tip_thickness=tip_thickness,
        base_thickness=None if gear.internal else gear.base_diameter * gear.base_half_angle,
        least_shift=least,
        least_teeth=None if least is None else least_teeth(over_plain(gear)),
        pointed_shift=most,
        undercut=None if junction is None else junction.undercut,
        **_along_the_helix(gear, hand, normal_pitch, normal_thickness),
        checks=_checks(gear, tip_roll, tip_thickness),
        advice=_advice(gear, pitch, least, most, tip_thickness, form),
    )


def _require_flanks(tip: float, tip_thickness: float, form: float | None) -> None:
    """Refuse teeth that are pointed below their tips, or whose root (`form`, its diameter) leaves no involute."""
    require(
        tip_thickness >= 0.0,
        "the teeth are pointed below their tips: at {tip:6} diameter they would be {tip_thickness:6} thick",
        tip=(absolute(tip), Size),
        tip_thickness=(tip_thickness, Size),
        code="pointed",
        hint="lower the profile shift, or shorten the tips",
    )
    if form is not None:
        require(
            form < tip,
            "the teeth have no involute: the root reaches {form:9} diameter, the tips {tip:9}",
            form=(form, Size),
            tip=(tip, Size),
            code="no-flank",
            hint="raise the profile shift",
        )


def _along_the_helix(gear: Gear, hand: Hand | None, normal_pitch: float, normal_thickness: float) -> "dict[str, Any]":
    """What only a helical gear has, by the names of results."""
    beta, cosine = gear.helix_angle, cos(gear.helix_angle)
    cos_base = cos(gear.base_helix_angle)
    values = {
        "transverse_module": gear.transverse_module,
        "transverse_pitch": normal_pitch / cosine,
        "normal_base_pitch": normal_pitch * cos(gear.rack.pressure_angle),
        "transverse_pressure_angle": gear.transverse_angle,
        "base_helix_angle": gear.base_helix_angle,
        "tip_helix_angle": atan(tan(beta) * gear.tip_diameter / gear.reference_diameter),
        "transverse_thickness": normal_thickness / cosine,
        "virtual_teeth": abs(gear.teeth) / (cos_base * cos_base * cosine),
        "equivalent_teeth": abs(gear.teeth) / (cosine * cosine * cosine),
    }
    helical_values = values if hand is not None else dict.fromkeys(values)
    tilted = hand is not None and plain(beta) > 0.0
    return {
        **helical_values,
        "axial_pitch": normal_pitch / sin(beta) if tilted else None,
        "lead": pi_beside(gear.module) * absolute(gear.reference_diameter) / tan(beta) if tilted else None,
        "hand": hand if tilted else None,
    }


def _checks(gear: Gear, roll: float, tip_thickness: float) -> tuple[Check, ...]:
    """Check the tip thickness from the tooth thickness at the reference circle."""
    from dynamics_cli.numerics.involute import involute

    steepness = tan(plain(gear.transverse_angle))
    if steepness > 10.0:
        return ()
    turn = involute(plain(gear.transverse_angle)) - involute(atan(plain(roll)))
    across = 0.5 * pi + 2.0 * plain(gear.shift) * tan(plain(gear.rack.pressure_angle))
    thickness = plain(gear.tip_diameter) * (across / gear.teeth + turn)
    residual = absolute(thickness - plain(tip_thickness)) / plain(gear.module)
    size = abs(plain(gear.tip_diameter)) / plain(gear.module)
    tolerance = 1e-13 * (size + 10.0) * (1.0 + steepness * steepness)
    return (Check("tooth thickness at the tip", residual <= tolerance, residual, tolerance),)


def _advice(
    gear: Gear, pitch: object, least: float | None, most: float | None, tip_thickness: float, form: float | None
) -> tuple[Advice, ...]:
    advice = list(module_advice(pitch, gear.module))
    relative = plain(tip_thickness) / plain(gear.module)
    if relative < LEAST_TIP:
        text = worded(
            "the tips are {share:3} modules thick, less than {limit}", share=(relative, Ratio), limit=(LEAST_TIP, Ratio)
        )
        advice.append(Advice("thin-tip", text, remedy="lower the profile shift, or shorten the tips"))
    if least is None or most is None or plain(least) <= plain(gear.shift):
        return tuple(advice)
    low, high = plain(least), plain(most)
    remedy = worded("raise the profile shift to {low:6}", low=(low, Ratio))
    if low > high:
        remedy = worded(
            "no profile shift is possible with {teeth} teeth: undercut ends at x = {low:6}, tips are pointed from "
            "{high:6}",
            teeth=gear.teeth,
            low=(low, Ratio),
            high=(high, Ratio),
        )
    message = worded("the rack undercuts the teeth: the involute begins at {form:6} diameter", form=(plain(form), Size))
    advice.append(Advice("undercut", message, "serious" if low > high else "caution", remedy))
    return tuple(advice)
