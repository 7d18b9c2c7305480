"""Records of a pair of gears: inputs of each gear, a point of contact, and the results."""

from dynamics_cli.gear.pair.forces import BearingLoad, ToothForces
from dynamics_cli.gear.pair.interference import Verdict
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Coordinate,
    Count,
    Fraction,
    Frequency,
    Ratio,
    Size,
    Speed,
    Teeth,
    Text,
    Torque,
)
from dynamics_cli.records import Advice, Check, record


@record
class Mate:
    """Inputs of one gear of a pair."""

    teeth: Annotated[Teeth, "Number of teeth (AGMA: N); gear ratio finds both for a ratio."]
    profile_shift: Annotated[Ratio | None, "Profile shift factor x; unless given, 0 or from the centre distance."] = (
        None
    )
    tip_diameter: Annotated[Size | None, "Tip diameter, in place of that of the rack, e.g. 80 mm [m]."] = None
    thinning: Annotated[
        Size, "Allowance by which each tooth is thinner, in the normal plane at the reference circle, for backlash [m]."
    ] = 0.0


@record
class ContactPoint:
    """A point of the path of contact."""

    point: Annotated[
        Text, "A where contact begins, B and D the ends of single contact, C the pitch point, E where contact ends."
    ]
    path: Annotated[Coordinate, "Distance from the pitch point along the path of contact [m]."]
    first_diameter: Annotated[Size, "Diameter on the first gear [m]."]
    second_diameter: Annotated[Size, "Diameter on the second gear [m]."]
    first_curvature: Annotated[Size, "Radius of curvature of the first flank ρ₁ [m]."]
    second_curvature: Annotated[Size, "Radius of curvature of the second flank ρ₂ [m]."]
    sliding_factor: Annotated[
        Ratio, "Sliding velocity over the pitch line velocity, K_g; negative before the pitch point."
    ]
    sliding_speed: Annotated[Speed | None, "Sliding velocity v_g, of the first flank over the second [m/s]."]
    first_sliding: Annotated[Ratio | None, "Specific sliding ζ₁."]
    second_sliding: Annotated[Ratio | None, "Specific sliding ζ₂."]


@record
class PairData:
    """A pair of cylindrical gears in mesh; lengths are magnitudes."""

    centre_distance: Annotated[Size, "Working centre distance a_w (AGMA: operating center distance) [m]."]
    working_pressure_angle: Annotated[
        Angle, "Working transverse pressure angle α_wt (AGMA: operating pressure angle) [rad]."
    ]
    involute: Annotated[Ratio, "inv α_wt without backlash; negative where no centre distance is free of backlash."]
    ratio: Annotated[Ratio, "Gear ratio u = z₂/z₁."]
    first_profile_shift: Annotated[Ratio, "Profile shift factor x₁ in ISO's sign."]
    second_profile_shift: Annotated[Ratio, "Profile shift factor x₂ in ISO's sign."]
    reference_distance: Annotated[Size, "Reference centre distance a_d = (d₁ + d₂)/2 [m]."]
    distance_modification: Annotated[Ratio, "Centre distance modification factor y = (a_w − a_d)/m_n."]
    tip_change: Annotated[
        Ratio | None,
        "Change k of both addenda in modules that keeps the tip clearance of the rack, where it is applied.",
    ]
    first_working_diameter: Annotated[Size, "Working pitch diameter d_w1 [m]."]
    second_working_diameter: Annotated[Size, "Working pitch diameter d_w2 [m]."]
    first_base_diameter: Annotated[Size, "Base diameter d_b1 [m]."]
    second_base_diameter: Annotated[Size, "Base diameter d_b2 [m]."]
    first_tip_diameter: Annotated[Size, "Tip diameter d_a1 [m]."]
    second_tip_diameter: Annotated[Size, "Tip diameter d_a2 [m]."]
    first_root_diameter: Annotated[Size, "Root diameter d_f1 [m]."]
    second_root_diameter: Annotated[Size, "Root diameter d_f2 [m]."]
    transverse_contact_ratio: Annotated[Ratio, "Transverse contact ratio ε_α over the actual flanks."]
    nominal_contact_ratio: Annotated[Ratio | None, "ε_α as if no involute were missing, where that differs."]
    overlap_ratio: Annotated[Ratio | None, "Overlap ratio ε_β."]
    total_contact_ratio: Annotated[Ratio | None, "Total contact ratio ε_γ."]
    path_length: Annotated[Size, "Length of the path of contact g_α [m]."]
    approach_length: Annotated[Coordinate, "Length of approach, A to C [m]."]
    recess_length: Annotated[Coordinate, "Length of recess, C to E [m]."]
    first_generating_shift: Annotated[
        Ratio | None,
        "Generating profile shift factor of the first gear x_E1, with which a full rack cuts its thinned teeth.",
    ]
    second_generating_shift: Annotated[Ratio | None, "The same for the second gear, x_E2."]
    circumferential_backlash: Annotated[Coordinate, "Circumferential backlash j_wt on the working pitch circle [m]."]
    normal_backlash: Annotated[Coordinate, "Normal backlash j_bn, as a feeler gauge measures it [m]."]
    first_tip_clearance: Annotated[Coordinate, "From the first gear's tip to the second's root [m]."]
    second_tip_clearance: Annotated[Coordinate, "From the second gear's tip to the first's root [m]."]
    loss_factor: Annotated[Ratio, "Loss factor H_v of sliding, 1 − η over the coefficient of friction."]
    efficiency: Annotated[Fraction, "Estimated efficiency η of the mesh alone, without bearings and churning."]
    common_factor: Annotated[
        Count, "Greatest common divisor of the tooth numbers; 1 when every tooth meets every other."
    ]
    pitch_line_speed: Annotated[Speed | None, "Pitch line velocity [m/s]."]
    mesh_frequency: Annotated[Frequency | None, "Tooth meshing frequency z₁n₁ [Hz]."]
    hunting_frequency: Annotated[Frequency | None, "Hunting tooth frequency: how often the same two teeth meet [Hz]."]
    torque: Annotated[Torque | None, "Torque on the first gear [N m]."]
    second_torque: Annotated[Torque | None, "Torque on the second gear without losses [N m]."]
    forces: Annotated[ToothForces | None, "Forces of the teeth."]
    bearings: Annotated[tuple[BearingLoad, ...] | None, "Loads of the bearings."]
    points: Annotated[tuple[ContactPoint, ...], "The path of contact."]
    verdicts: Annotated[tuple[Verdict, ...], "Interference."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
