"""What there is to say of one cylindrical gear."""

from dynamics_cli.gear.gear import Hand
from dynamics_cli.quantities import Angle, Module, Ratio, Size
from dynamics_cli.records import Advice, Check, record


@record
class GearData:
    """The geometry of one gear; lengths and diameters are magnitudes.

    Parameters
    ----------
    reference_diameter : Size
        Reference diameter d (AGMA: standard pitch diameter) [m].
    base_diameter : Size
        Base diameter d_b [m].
    tip_diameter : Size
        Tip diameter d_a (AGMA: outside diameter; internal: inside diameter) [m].
    root_diameter : Size
        Root diameter d_f as the rack cuts it without backlash allowance [m].
    root_form_diameter : Size
        Root form diameter d_Ff, where the trochoid of the rack's corner meets the involute [m].
    v_diameter : Size
        Diameter d_v of the V-circle, d + 2xm_n [m].
    normal_module : Module
        Normal module m_n [m].
    transverse_module : Module
        Transverse module m_t [m].
    normal_pitch : Size
        Normal pitch p_n (AGMA: normal circular pitch) [m].
    transverse_pitch : Size
        Transverse pitch p_t [m].
    axial_pitch : Size
        Axial pitch p_x [m].
    base_pitch : Size
        Transverse base pitch p_bt, equal to the pitch along the path of contact [m].
    normal_base_pitch : Size
        Normal base pitch p_bn [m].
    transverse_pressure_angle : Angle
        Transverse pressure angle α_t at the reference circle [rad].
    tip_pressure_angle : Angle
        Transverse pressure angle α_at at the tip [rad].
    base_helix_angle : Angle
        Base helix angle β_b [rad].
    tip_helix_angle : Angle
        Helix angle β_a at the tip cylinder [rad].
    lead : Size
        Lead p_z of a tooth [m].
    profile_shift : Ratio
        Profile shift factor x in ISO's sign, towards the tips.
    addendum : Size
        Addendum h_a from the reference circle [m].
    dedendum : Size
        Dedendum h_f from the reference circle [m].
    tooth_depth : Size
        Tooth depth h (AGMA: whole depth) [m].
    root_radius : Size
        Radius ρ_fP of the rack's corner [m].
    normal_thickness : Size
        Normal tooth thickness s_n at the reference circle, as arc [m].
    transverse_thickness : Size
        Transverse tooth thickness s_t at the reference circle, as arc [m].
    transverse_space : Size
        Transverse space width e_t at the reference circle, as arc [m].
    tip_thickness : Size
        Transverse tooth thickness s_at at the tip, as arc [m].
    base_thickness : Size
        Transverse tooth thickness s_bt at the base circle, as arc [m].
    virtual_teeth : Ratio
        Virtual number of teeth z_nx of the normal section.
    least_shift : Ratio
        Least profile shift factor without undercut by this rack.
    pointed_shift : Ratio
        Profile shift factor at which the tips become pointed, for tips not shortened further.
    undercut : bool
        Whether the rack cuts away part of the involute.
    hand : Hand
        Hand of the helix.
    """

    reference_diameter: Size
    base_diameter: Size
    tip_diameter: Size
    root_diameter: Size
    root_form_diameter: Size | None
    v_diameter: Size
    normal_module: Module
    transverse_module: Module | None
    normal_pitch: Size
    transverse_pitch: Size | None
    axial_pitch: Size | None
    base_pitch: Size
    normal_base_pitch: Size | None
    transverse_pressure_angle: Angle | None
    tip_pressure_angle: Angle | None
    base_helix_angle: Angle | None
    tip_helix_angle: Angle | None
    lead: Size | None
    profile_shift: Ratio
    addendum: Size
    dedendum: Size
    tooth_depth: Size
    root_radius: Size
    normal_thickness: Size
    transverse_thickness: Size | None
    transverse_space: Size
    tip_thickness: Size
    base_thickness: Size | None
    virtual_teeth: Ratio | None
    least_shift: Ratio | None
    pointed_shift: Ratio | None
    undercut: bool | None
    hand: Hand | None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
