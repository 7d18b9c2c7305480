"""The results for one cylindrical gear."""

from dynamics_cli.gear.single.gear import Hand
from dynamics_cli.quantities import Angle, Annotated, Count, Module, Ratio, Size
from dynamics_cli.records import Advice, Check, record


@record
class GearData:
    """The geometry of one gear; lengths and diameters are magnitudes."""

    reference_diameter: Annotated[Size, "Reference diameter d (AGMA: standard pitch diameter) [m]."]
    base_diameter: Annotated[Size, "Base diameter d_b [m]."]
    tip_diameter: Annotated[Size, "Tip diameter d_a (AGMA: outside diameter; internal: inside diameter) [m]."]
    root_diameter: Annotated[Size, "Root diameter d_f as the rack cuts it without backlash allowance [m]."]
    root_form_diameter: Annotated[
        Size | None, "Root form diameter d_Ff, where the trochoid of the rack's corner meets the involute [m]."
    ]
    v_diameter: Annotated[Size, "Diameter d_v of the V-circle, d + 2xm_n [m]."]
    normal_module: Annotated[Module, "Normal module m_n [m]."]
    transverse_module: Annotated[Module | None, "Transverse module m_t [m]."]
    normal_pitch: Annotated[Size, "Normal pitch p_n (AGMA: normal circular pitch) [m]."]
    transverse_pitch: Annotated[Size | None, "Transverse pitch p_t [m]."]
    axial_pitch: Annotated[Size | None, "Axial pitch p_x [m]."]
    base_pitch: Annotated[Size, "Transverse base pitch p_bt, equal to the pitch along the path of contact [m]."]
    normal_base_pitch: Annotated[Size | None, "Normal base pitch p_bn [m]."]
    transverse_pressure_angle: Annotated[Angle | None, "Transverse pressure angle α_t at the reference circle [rad]."]
    tip_pressure_angle: Annotated[Angle | None, "Transverse pressure angle α_at at the tip [rad]."]
    base_helix_angle: Annotated[Angle | None, "Base helix angle β_b [rad]."]
    tip_helix_angle: Annotated[Angle | None, "Helix angle β_a at the tip cylinder [rad]."]
    lead: Annotated[Size | None, "Lead p_z of a tooth [m]."]
    profile_shift: Annotated[Ratio, "Profile shift factor x in ISO's sign, towards the tips."]
    addendum: Annotated[Size, "Addendum h_a from the reference circle [m]."]
    dedendum: Annotated[Size, "Dedendum h_f from the reference circle [m]."]
    tooth_depth: Annotated[Size, "Tooth depth h (AGMA: whole depth) [m]."]
    root_radius: Annotated[Size, "Radius ρ_fP of the rack's corner [m]."]
    normal_thickness: Annotated[Size, "Normal tooth thickness s_n at the reference circle, as arc [m]."]
    transverse_thickness: Annotated[Size | None, "Transverse tooth thickness s_t at the reference circle, as arc [m]."]
    transverse_space: Annotated[Size, "Transverse space width e_t at the reference circle, as arc [m]."]
    tip_thickness: Annotated[Size, "Transverse tooth thickness s_at at the tip, as arc [m]."]
    base_thickness: Annotated[Size | None, "Transverse tooth thickness s_bt at the base circle, as arc [m]."]
    virtual_teeth: Annotated[Ratio | None, "Virtual number of teeth z_nx of the normal section."]
    equivalent_teeth: Annotated[
        Ratio | None, "Number of teeth of the equivalent spur gear z_v = z/cos³β, as handbooks choose cutters by it."
    ]
    least_shift: Annotated[Ratio | None, "Minimum profile shift factor without undercut by this rack."]
    least_teeth: Annotated[Count | None, "Minimum number of teeth without undercut by this rack at this profile shift."]
    pointed_shift: Annotated[
        Ratio | None, "Profile shift factor at which the tips become pointed, for tips not shortened further."
    ]
    undercut: Annotated[bool | None, "Whether the rack cuts away part of the involute."]
    hand: Annotated[Hand | None, "Hand of the helix."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
