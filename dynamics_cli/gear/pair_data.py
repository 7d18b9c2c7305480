"""Records of a pair of gears: what is given of each, a point of contact, and the answer."""

from dynamics_cli.gear.forces import BearingLoad, ToothForces
from dynamics_cli.gear.interference import Verdict
from dynamics_cli.quantities import (
    Angle,
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
    """What belongs to one gear of a pair.

    Parameters
    ----------
    teeth : Teeth
        Number of teeth (AGMA: N).
    profile_shift : Ratio
        Profile shift factor x; left out, it is 0, or found from the centre distance.
    tip_diameter : Size
        Tip diameter as it is, in place of the one of the rack [m].
    thinning : Size
        Allowance by which each tooth is thinner, in the normal plane at the reference circle, for backlash [m].
    """

    teeth: Teeth
    profile_shift: Ratio | None = None
    tip_diameter: Size | None = None
    thinning: Size = 0.0


@record
class ContactPoint:
    """A point of the path of contact.

    Parameters
    ----------
    point : Text
        A where contact begins, B and D the ends of single contact, C the pitch point, E where contact ends.
    path : Coordinate
        Distance from the pitch point along the path of contact [m].
    first_diameter : Size
        Diameter on the first gear [m].
    second_diameter : Size
        Diameter on the second gear [m].
    first_curvature : Size
        Radius of curvature of the first flank ρ₁ [m].
    second_curvature : Size
        Radius of curvature of the second flank ρ₂ [m].
    sliding_factor : Ratio
        Sliding velocity over the pitch line velocity, K_g; negative before the pitch point.
    sliding_speed : Speed
        Sliding velocity v_g, of the first flank over the second [m/s].
    first_sliding : Ratio
        Specific sliding ζ₁.
    second_sliding : Ratio
        Specific sliding ζ₂.
    """

    point: Text
    path: Coordinate
    first_diameter: Size
    second_diameter: Size
    first_curvature: Size
    second_curvature: Size
    sliding_factor: Ratio
    sliding_speed: Speed | None
    first_sliding: Ratio | None
    second_sliding: Ratio | None


@record
class PairData:
    """A pair of cylindrical gears in mesh; lengths are magnitudes.

    Parameters
    ----------
    centre_distance : Size
        Working centre distance a_w (AGMA: operating center distance) [m].
    working_pressure_angle : Angle
        Working transverse pressure angle α_wt (AGMA: operating pressure angle) [rad].
    involute : Ratio
        inv α_wt without backlash.
    ratio : Ratio
        Gear ratio u = z₂/z₁.
    first_profile_shift : Ratio
        Profile shift factor x₁ in ISO's sign.
    second_profile_shift : Ratio
        Profile shift factor x₂ in ISO's sign.
    reference_distance : Size
        Reference centre distance a_d = (d₁ + d₂)/2 [m].
    distance_modification : Ratio
        Centre distance modification factor y = (a_w − a_d)/m_n.
    tip_change : Ratio
        Change k of both addenda in modules that keeps the tip clearance of the rack, where it is applied.
    first_working_diameter : Size
        Working pitch diameter d_w1 [m].
    second_working_diameter : Size
        Working pitch diameter d_w2 [m].
    first_base_diameter : Size
        Base diameter d_b1 [m].
    second_base_diameter : Size
        Base diameter d_b2 [m].
    first_tip_diameter : Size
        Tip diameter d_a1 [m].
    second_tip_diameter : Size
        Tip diameter d_a2 [m].
    first_root_diameter : Size
        Root diameter d_f1 [m].
    second_root_diameter : Size
        Root diameter d_f2 [m].
    transverse_contact_ratio : Ratio
        Transverse contact ratio ε_α over the flanks that are there.
    nominal_contact_ratio : Ratio
        ε_α if no involute were missing, where that differs.
    overlap_ratio : Ratio
        Overlap ratio ε_β.
    total_contact_ratio : Ratio
        Total contact ratio ε_γ.
    path_length : Size
        Length of the path of contact g_α [m].
    approach_length : Coordinate
        Length of approach, A to C [m].
    recess_length : Coordinate
        Length of recess, C to E [m].
    circumferential_backlash : Coordinate
        Circumferential backlash j_wt on the working pitch circle [m].
    normal_backlash : Coordinate
        Normal backlash j_bn, as a feeler gauge measures it [m].
    first_tip_clearance : Coordinate
        From the first gear's tip to the second's root [m].
    second_tip_clearance : Coordinate
        From the second gear's tip to the first's root [m].
    loss_factor : Ratio
        Loss factor H_v of sliding, 1 − η over the coefficient of friction.
    efficiency : Fraction
        Estimated efficiency η of the mesh alone, without bearings and churning.
    common_factor : Count
        Greatest common divisor of the tooth numbers; 1 when every tooth meets every other.
    pitch_line_speed : Speed
        Pitch line velocity [m/s].
    mesh_frequency : Frequency
        Tooth meshing frequency z₁n₁ [Hz].
    hunting_frequency : Frequency
        Hunting tooth frequency: how often the same two teeth meet [Hz].
    torque : Torque
        Torque on the first gear [N m].
    second_torque : Torque
        Torque on the second gear without losses [N m].
    forces : ToothForces
        Forces of the teeth.
    bearings : tuple of BearingLoad
        Loads of the bearings.
    points : tuple of ContactPoint
        The path of contact.
    verdicts : tuple of Verdict
        Interference.
    """

    centre_distance: Size
    working_pressure_angle: Angle
    involute: Ratio
    ratio: Ratio
    first_profile_shift: Ratio
    second_profile_shift: Ratio
    reference_distance: Size
    distance_modification: Ratio
    tip_change: Ratio | None
    first_working_diameter: Size
    second_working_diameter: Size
    first_base_diameter: Size
    second_base_diameter: Size
    first_tip_diameter: Size
    second_tip_diameter: Size
    first_root_diameter: Size
    second_root_diameter: Size
    transverse_contact_ratio: Ratio
    nominal_contact_ratio: Ratio | None
    overlap_ratio: Ratio | None
    total_contact_ratio: Ratio | None
    path_length: Size
    approach_length: Coordinate
    recess_length: Coordinate
    circumferential_backlash: Coordinate
    normal_backlash: Coordinate
    first_tip_clearance: Coordinate
    second_tip_clearance: Coordinate
    loss_factor: Ratio
    efficiency: Fraction
    common_factor: Count
    pitch_line_speed: Speed | None
    mesh_frequency: Frequency | None
    hunting_frequency: Frequency | None
    torque: Torque | None
    second_torque: Torque | None
    forces: ToothForces | None
    bearings: tuple[BearingLoad, ...] | None
    points: tuple[ContactPoint, ...]
    verdicts: tuple[Verdict, ...]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
