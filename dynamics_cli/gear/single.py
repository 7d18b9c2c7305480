"""One cylindrical gear, spur or helical, external or internal: every diameter, pitch, thickness and limit."""

from math import pi

from dynamics_cli.errors import require
from dynamics_cli.gear.gear import (
    FULL_DEPTH,
    Gear,
    Hand,
    Pitch,
    Profile,
    Sign,
    SpurPitch,
    basic_rack,
    module_advice,
    module_of,
    signed_gear,
)
from dynamics_cli.gear.gear_data import GearData
from dynamics_cli.gear.limits import LEAST_TIP, least_shift, plain, pointed_shift
from dynamics_cli.gear.trochoid import root
from dynamics_cli.numerics.elementary import absolute, atan, cos, pi_beside, sin, tan
from dynamics_cli.quantities import Angle, Ratio, Size, Teeth
from dynamics_cli.records import Advice, Check


def spur(
    *,
    teeth: Teeth,
    pitch: SpurPitch,
    pressure_angle: Angle = FULL_DEPTH,
    profile_shift: Ratio = 0.0,
    profile: Profile = Profile("a"),  # noqa: B008
    addendum_factor: Ratio | None = None,
    dedendum_factor: Ratio | None = None,
    root_radius_factor: Ratio | None = None,
    tip_shortening: Size = 0.0,
    internal: bool = False,
    shift_sign: Sign = Sign("iso"),  # noqa: B008
    avoid_undercut: bool = False,
) -> GearData:
    """All dimensions of one spur gear from its generating rack.

    Equation
    --------
    d = z m; d_b = d cos α; d_a = d + 2m(h_a* + x + k); d_f = d − 2m(h_fP* − x); s = m(π/2 + 2x tan α);
    s_a = d_a(s/d + inv α − inv α_a).

    Parameters
    ----------
    teeth : Teeth
        Number of teeth z (AGMA: N).
    pitch : NormalModule | NormalDiametralPitch | NormalCircularPitch
        Size of the teeth.
    pressure_angle : Angle
        Pressure angle α of the rack (AGMA: φ) [rad].
    profile_shift : Ratio
        Profile shift factor x, in modules.
    profile : Profile
        Basic rack: a to d of ISO 53, stub, agma-coarse, agma-fine; the factors below replace its own.
    addendum_factor : Ratio
        Addendum factor h_a*.
    dedendum_factor : Ratio
        Dedendum factor h_fP*.
    root_radius_factor : Ratio
        Radius of the rack's corner ρ_fP*; a profile's own that does not fit becomes a full round.
    tip_shortening : Size
        How much the tips are cut back, radially [m].
    internal : bool
        An internal gear (ring).
    shift_sign : Sign
        Sign of an internal gear's shift: iso, positive towards its tips, or outward, as KHK and JIS have it.
    avoid_undercut : bool
        Choose the least shift, not below zero, that leaves the involute whole, in place of the one given.

    Returns
    -------
    GearData
        Diameters, pitches, thicknesses and limits.

    Raises
    ------
    InadmissibleError
        When there is no such gear: the circles are out of order, the teeth are pointed below their tips, the rack
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
    >>> from dynamics_cli.gear.gear import NormalModule
    >>> round(1e3 * spur(teeth=12, pitch=NormalModule(0.003)).base_diameter, 3)
    33.829
    """
    rack = basic_rack(profile, pressure_angle, addendum_factor, dedendum_factor, root_radius_factor)
    module = module_of(pitch, 0.0)
    gear = signed_gear(
        teeth,
        module,
        rack,
        internal=internal,
        sign=shift_sign,
        shift=profile_shift,
        tip_change=-tip_shortening / module,
    )
    return describe(_without_undercut(gear) if avoid_undercut else gear, pitch, None)


def helical(
    *,
    teeth: Teeth,
    pitch: Pitch,
    helix_angle: Angle,
    hand: Hand = Hand("right"),  # noqa: B008
    pressure_angle: Angle | None = None,
    transverse_pressure_angle: Angle | None = None,
    profile_shift: Ratio = 0.0,
    profile: Profile = Profile("a"),  # noqa: B008
    addendum_factor: Ratio | None = None,
    dedendum_factor: Ratio | None = None,
    root_radius_factor: Ratio | None = None,
    tip_shortening: Size = 0.0,
    internal: bool = False,
    shift_sign: Sign = Sign("iso"),  # noqa: B008
    avoid_undercut: bool = False,
) -> GearData:
    """All dimensions of one helical gear from its generating rack.

    Equation
    --------
    m_t = m_n/cos β; tan α_t = tan α_n/cos β; d = z m_t; sin β_b = sin β cos α_n; p_z = π d/tan β; factors and shift
    count in normal modules.

    Parameters
    ----------
    teeth : Teeth
        Number of teeth z (AGMA: N).
    pitch : Pitch
        Size of the teeth, normal or transverse.
    helix_angle : Angle
        Helix angle β at the reference cylinder (AGMA: ψ) [rad].
    hand : Hand
        Hand of the helix.
    pressure_angle : Angle
        Normal pressure angle α_n (AGMA: φ_n); 20 degrees unless one is given [rad].
    transverse_pressure_angle : Angle
        Transverse pressure angle α_t, in place of the normal one [rad].
    profile_shift : Ratio
        Profile shift factor x, in normal modules.
    profile : Profile
        Basic rack: a to d of ISO 53, stub, agma-coarse, agma-fine; the factors below replace its own.
    addendum_factor : Ratio
        Addendum factor h_a*.
    dedendum_factor : Ratio
        Dedendum factor h_fP*.
    root_radius_factor : Ratio
        Radius of the rack's corner ρ_fP*; a profile's own that does not fit becomes a full round.
    tip_shortening : Size
        How much the tips are cut back, radially [m].
    internal : bool
        An internal gear (ring).
    shift_sign : Sign
        Sign of an internal gear's shift: iso, positive towards its tips, or outward, as KHK and JIS have it.
    avoid_undercut : bool
        Choose the least shift, not below zero, that leaves the involute whole, in place of the one given.

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
    >>> from dynamics_cli.gear.gear import NormalModule
    >>> from math import degrees, radians
    >>> answer = helical(teeth=12, pitch=NormalModule(0.003), helix_angle=radians(30.0))
    >>> round(degrees(answer.transverse_pressure_angle), 5)
    22.79588
    """
    lean = absolute(helix_angle)
    require(lean < 0.5 * pi, "a helix angle of {0:.6g} rad never winds", helix_angle, code="helix-angle")
    angle = normal_pressure_angle(pressure_angle, transverse_pressure_angle, lean)
    rack = basic_rack(profile, angle, addendum_factor, dedendum_factor, root_radius_factor)
    module = module_of(pitch, lean)
    gear = signed_gear(
        teeth,
        module,
        rack,
        internal=internal,
        sign=shift_sign,
        helix_angle=lean,
        shift=profile_shift,
        tip_change=-tip_shortening / module,
    )
    leaning = hand if plain(helix_angle) >= 0.0 else Hand("left" if hand == "right" else "right")
    return describe(_without_undercut(gear) if avoid_undercut else gear, pitch, leaning)


def normal_pressure_angle(normal: float | None, transverse: float | None, helix_angle: float) -> float:
    """α_n, from whichever was given."""
    if transverse is None:
        return FULL_DEPTH if normal is None else normal
    require(
        normal is None,
        "the pressure angle is given twice, normal and transverse",
        code="two-pressure-angles",
        hint="give one of them",
    )
    require(
        transverse < 0.5 * pi, "a pressure angle of {0:.6g} rad makes no involute", transverse, code="pressure-angle"
    )
    return atan(tan(transverse) * cos(helix_angle))


def _without_undercut(gear: Gear) -> Gear:
    """The same gear with the least shift that leaves its involute whole."""
    require(not gear.internal, "an internal gear is not cut by a rack", code="internal")
    least = least_shift(gear)
    shift = least if least > 0.0 else 0.0 * least
    most = pointed_shift(gear)
    require(
        shift <= most,
        "no shift serves {0} teeth: undercut ends at x = {1:.6g}, but the tips are pointed from x = {2:.6g}",
        gear.teeth,
        plain(shift),
        plain(most),
        code="no-shift-serves",
        hint="use more teeth, a larger pressure angle, a smaller addendum factor, or shortened tips",
    )
    return Gear(gear.teeth, gear.module, gear.rack, gear.helix_angle, shift, gear.tip_change)


def describe(gear: Gear, pitch: object, hand: Hand | None) -> GearData:
    """Everything about a gear that stands by itself."""
    helical_gear = hand is not None
    tip = gear.tip_diameter
    roll = gear.tip_roll
    tip_thickness = gear.tip_thickness
    require(
        tip_thickness >= 0.0,
        "the teeth are pointed below their tips: at {0:.6g} mm diameter they would be {1:.6g} mm thick",
        1e3 * absolute(tip),
        1e3 * tip_thickness,
        code="pointed",
        hint="lower the profile shift, or shorten the tips",
    )
    module, beta = gear.module, gear.helix_angle
    cosine = cos(beta)
    transverse = gear.transverse_angle
    base_helix = gear.base_helix_angle
    normal_thickness = module * (0.5 * pi_beside(module) + 2.0 * gear.shift * tan(gear.rack.pressure_angle))
    normal_pitch = pi_beside(module) * module
    junction = None if gear.internal else root(gear.cutter)
    cos_base = cos(base_helix)
    least = None if gear.internal else least_shift(gear)
    most = None if gear.internal else pointed_shift(gear)
    tilted = helical_gear and plain(beta) > 0.0
    form = None if junction is None else 2.0 * module * junction.form_radius
    if form is not None:
        require(
            form < tip,
            "the rack leaves no involute: the root reaches {0:.9g} mm diameter, the tips {1:.9g} mm",
            1e3 * form,
            1e3 * tip,
            code="no-flank",
            hint="raise the profile shift",
        )
    return GearData(
        reference_diameter=absolute(gear.reference_diameter),
        base_diameter=absolute(gear.base_diameter),
        tip_diameter=absolute(tip),
        root_diameter=absolute(gear.root_diameter),
        root_form_diameter=form,
        v_diameter=absolute(gear.reference_diameter + 2.0 * gear.shift * module),
        normal_module=module,
        transverse_module=gear.transverse_module if helical_gear else None,
        normal_pitch=normal_pitch,
        transverse_pitch=normal_pitch / cosine if helical_gear else None,
        axial_pitch=normal_pitch / sin(beta) if tilted else None,
        base_pitch=gear.base_pitch,
        normal_base_pitch=normal_pitch * cos(gear.rack.pressure_angle) if helical_gear else None,
        transverse_pressure_angle=transverse if helical_gear else None,
        tip_pressure_angle=atan(roll),
        base_helix_angle=base_helix if helical_gear else None,
        tip_helix_angle=atan(tan(beta) * tip / gear.reference_diameter) if helical_gear else None,
        lead=pi_beside(module) * absolute(gear.reference_diameter) / tan(beta) if tilted else None,
        profile_shift=gear.shift,
        addendum=module * (gear.rack.addendum + gear.shift + gear.tip_change),
        dedendum=module * (gear.rack.dedendum - gear.shift),
        tooth_depth=module * (gear.rack.addendum + gear.rack.dedendum + gear.tip_change),
        root_radius=module * gear.rack.tip_radius,
        normal_thickness=normal_thickness,
        transverse_thickness=normal_thickness / cosine if helical_gear else None,
        transverse_space=(normal_pitch - normal_thickness) / cosine,
        tip_thickness=tip_thickness,
        base_thickness=gear.base_diameter * gear.base_half_angle if not gear.internal else None,
        virtual_teeth=abs(gear.teeth) / (cos_base * cos_base * cosine) if helical_gear else None,
        least_shift=least,
        pointed_shift=most,
        undercut=None if junction is None else junction.undercut,
        hand=hand if tilted else None,
        checks=_checks(gear, roll, tip_thickness),
        advice=_advice(gear, pitch, least, most, tip_thickness, form),
    )


def _checks(gear: Gear, roll: float, tip_thickness: float) -> tuple[Check, ...]:
    """The tip thickness again from the tooth thickness at the reference circle."""
    from dynamics_cli.numerics.involute import involute

    steepness = tan(plain(gear.transverse_angle))
    if steepness > 10.0:
        return ()
    turn = involute(plain(gear.transverse_angle)) - involute(atan(plain(roll)))
    across = 0.5 * pi + 2.0 * plain(gear.shift) * tan(plain(gear.rack.pressure_angle))
    again = plain(gear.tip_diameter) * (across / gear.teeth + turn)
    residual = absolute(again - plain(tip_thickness)) / plain(gear.module)
    size = abs(plain(gear.tip_diameter)) / plain(gear.module)
    tolerance = 1e-13 * (size + 10.0) * (1.0 + steepness * steepness)
    return (Check("tooth thickness at the tip", residual <= tolerance, residual, tolerance),)


def _advice(
    gear: Gear,
    pitch: object,
    least: float | None,
    most: float | None,
    tip_thickness: float,
    form: float | None,
) -> tuple[Advice, ...]:
    found = list(module_advice(pitch, gear.module))
    share = plain(tip_thickness) / plain(gear.module)
    if share < LEAST_TIP:
        found.append(
            Advice(
                "thin-tip",
                f"the tips are {share:.3g} modules thick, less than {LEAST_TIP:g}",
                mend="lower the profile shift, or shorten the tips",
            )
        )
    if least is None or most is None or plain(least) <= plain(gear.shift):
        return tuple(found)
    low, high = plain(least), plain(most)
    mend = f"raise the profile shift by {low - plain(gear.shift):.4g} to {low:.6g}"
    if low > high:
        mend = f"no shift serves {gear.teeth} teeth: undercut ends at x = {low:.6g}, tips are pointed from {high:.6g}"
    found.append(
        Advice(
            "undercut",
            f"the rack undercuts the teeth: the involute begins at {1e3 * plain(form):.6g} mm diameter",
            "serious" if low > high else "caution",
            mend,
        )
    )
    return tuple(found)
