"""What there is to say of a worm pair."""

from dynamics_cli.quantities import Angle, Coordinate, Force, Module, Ratio, ShaftSpeed, Size, Speed, Torque
from dynamics_cli.records import Advice, Check, record


@record
class WormData:
    """A worm and its wheel.

    Parameters
    ----------
    ratio : Ratio
        Gear ratio u = z₂/z₁.
    lead_angle : Angle
        Lead angle γ of the worm at its reference cylinder; the helix angle of the wheel [rad].
    lead : Size
        Lead of the worm p_z, its advance in a turn [m].
    axial_pitch : Size
        Axial pitch of the worm p_x, transverse pitch of the wheel [m].
    axial_module : Module
        Axial module m_x [m].
    normal_module : Module
        Normal module m_n [m].
    diameter_factor : Ratio
        Diameter factor q.
    axial_pressure_angle : Angle
        Pressure angle in the axial section α_x [rad].
    centre_distance : Size
        Centre distance a [m].
    worm_diameter : Size
        Reference diameter of the worm d₁ [m].
    worm_tip_diameter : Size
        Tip diameter of the worm d_a1 [m].
    worm_root_diameter : Size
        Root diameter of the worm d_f1 [m].
    worm_length : Size
        Length of the thread that a usual worm has, (4.5 + 0.02 z₂)π m_x [m].
    wheel_diameter : Size
        Reference diameter of the wheel d₂ [m].
    throat_diameter : Size
        Throat diameter of the wheel d_a2 in its mid-plane [m].
    wheel_outer_diameter : Size
        Outside diameter of the wheel d_e2 that is usual [m].
    wheel_root_diameter : Size
        Root diameter of the wheel d_f2 [m].
    throat_radius : Size
        Radius of the throat r_k, about the worm's axis [m].
    face_width : Size
        Face width of the wheel that is usual, 2m_x√(q + 1) [m].
    friction_angle : Angle
        Angle of friction ρ' = atan(μ/cos α_n) [rad].
    efficiency : Ratio
        Efficiency when the worm drives.
    backward_efficiency : Ratio
        Efficiency when the wheel drives; at or below zero the worm locks itself.
    locking_margin : Angle
        Angle of friction less lead angle; positive is self-locking [rad].
    self_locking : bool
        Whether the wheel cannot drive the worm.
    sliding_speed : Speed
        Sliding velocity at the reference cylinder v_g [m/s].
    wheel_speed : ShaftSpeed
        Speed of the wheel [rad/s].
    worm_torque : Torque
        Torque on the worm when it drives [N m].
    wheel_torque : Torque
        Torque of the wheel [N m].
    worm_tangential_force : Force
        Tangential force on the worm, axial on the wheel [N].
    worm_axial_force : Force
        Axial force on the worm, tangential on the wheel [N].
    radial_force : Force
        Force that parts worm and wheel [N].
    release_torque : Torque
        Torque on the worm that lets the loaded wheel go: negative when it runs away by itself [N m].
    """

    ratio: Ratio
    lead_angle: Angle
    lead: Size
    axial_pitch: Size
    axial_module: Module
    normal_module: Module
    diameter_factor: Ratio
    axial_pressure_angle: Angle
    centre_distance: Size
    worm_diameter: Size
    worm_tip_diameter: Size
    worm_root_diameter: Coordinate
    worm_length: Size
    wheel_diameter: Size
    throat_diameter: Size
    wheel_outer_diameter: Size
    wheel_root_diameter: Size
    throat_radius: Coordinate
    face_width: Size
    friction_angle: Angle
    efficiency: Ratio
    backward_efficiency: Ratio
    locking_margin: Angle
    self_locking: bool
    sliding_speed: Speed | None
    wheel_speed: ShaftSpeed | None
    worm_torque: Torque | None
    wheel_torque: Torque | None
    worm_tangential_force: Force | None
    worm_axial_force: Force | None
    radial_force: Force | None
    release_torque: Torque | None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
