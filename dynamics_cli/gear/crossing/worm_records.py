"""Inputs and results of a worm pair."""

from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Coordinate,
    Force,
    Fraction,
    Module,
    Positive,
    Ratio,
    ShaftSpeed,
    Size,
    Speed,
    Torque,
)
from dynamics_cli.records import Advice, Check, record


@record
class AxialModule:
    """Size of the teeth as the axial module of the worm, the transverse one of the wheel."""

    module: Annotated[Module, "Axial module m_x [m]."]


@record
class WormNormalModule:
    """Size of the teeth as the normal module."""

    normal_module: Annotated[Module, "Normal module m_n [m]."]


@record
class WormDiameter:
    """The worm by its reference diameter."""

    worm_diameter: Annotated[Size, "Reference diameter of the worm d₁, e.g. 44 mm [m]."]


@record
class DiameterFactor:
    """The worm by its diameter factor."""

    diameter_factor: Annotated[Positive, "Diameter factor q = d₁/m_x, e.g. 10."]


@record
class LeadAngle:
    """The worm by its lead angle."""

    lead_angle: Annotated[Angle, "Lead angle γ at the reference cylinder, e.g. 8 deg [rad]."]


@record
class WormData:
    """A worm and its wheel."""

    ratio: Annotated[Ratio, "Gear ratio u = z₂/z₁."]
    lead_angle: Annotated[
        Angle, "Lead angle γ of the worm at its reference cylinder; the helix angle of the wheel [rad]."
    ]
    lead: Annotated[Size, "Lead of the worm p_z, its advance in a turn [m]."]
    axial_pitch: Annotated[Size, "Axial pitch of the worm p_x, transverse pitch of the wheel [m]."]
    axial_module: Annotated[Module, "Axial module m_x [m]."]
    normal_module: Annotated[Module, "Normal module m_n [m]."]
    diameter_factor: Annotated[Ratio, "Diameter factor q."]
    axial_pressure_angle: Annotated[Angle, "Pressure angle in the axial section α_x [rad]."]
    centre_distance: Annotated[Size, "Centre distance a [m]."]
    profile_shift: Annotated[Ratio, "Profile shift factor of the wheel x₂."]
    worm_diameter: Annotated[Size, "Reference diameter of the worm d₁ [m]."]
    worm_tip_diameter: Annotated[Size, "Tip diameter of the worm d_a1 [m]."]
    worm_root_diameter: Annotated[Coordinate, "Root diameter of the worm d_f1 [m]."]
    worm_length: Annotated[Size, "Length of the thread that a usual worm has, (4.5 + 0.02 z₂)π m_x [m]."]
    wheel_diameter: Annotated[Size, "Reference diameter of the wheel d₂ [m]."]
    throat_diameter: Annotated[Size, "Throat diameter of the wheel d_a2 in its mid-plane [m]."]
    wheel_outer_diameter: Annotated[Size, "Outside diameter of the wheel d_e2 that is usual [m]."]
    wheel_root_diameter: Annotated[Size, "Root diameter of the wheel d_f2 [m]."]
    throat_radius: Annotated[Coordinate, "Radius of the throat r_k, about the worm's axis [m]."]
    face_width: Annotated[Size, "Face width of the wheel that is usual, 2m_x√(q + 1) [m]."]
    friction_angle: Annotated[Angle, "Angle of friction ρ' = atan(μ/cos α_n) [rad]."]
    efficiency: Annotated[Fraction, "Efficiency when the worm drives."]
    backward_efficiency: Annotated[
        Fraction, "Efficiency when the wheel drives; at or below zero the worm locks itself."
    ]
    locking_margin: Annotated[Angle, "Angle of friction less lead angle; positive is self-locking [rad]."]
    self_locking: Annotated[bool, "Whether the wheel cannot drive the worm."]
    sliding_speed: Annotated[Speed | None, "Sliding velocity at the reference cylinder v_g [m/s]."]
    wheel_speed: Annotated[ShaftSpeed | None, "Speed of the wheel [rad/s]."]
    worm_torque: Annotated[Torque | None, "Torque on the worm when it drives [N m]."]
    wheel_torque: Annotated[Torque | None, "Torque of the wheel [N m]."]
    worm_tangential_force: Annotated[Force | None, "Tangential force on the worm, axial on the wheel [N]."]
    worm_axial_force: Annotated[Force | None, "Axial force on the worm, tangential on the wheel [N]."]
    radial_force: Annotated[Force | None, "Force that parts worm and wheel [N]."]
    normal_force: Annotated[Force | None, "Force of the flanks along their common normal F_n, friction apart [N]."]
    release_torque: Annotated[
        Torque | None, "Torque on the worm that lets the loaded wheel go: negative when it runs away by itself [N m]."
    ]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
