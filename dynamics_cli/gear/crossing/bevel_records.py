"""Records of bevel pairs: proportions of the teeth, one gear, and the answer."""

from dynamics_cli.quantities import Angle, Annotated, Coordinate, Force, Module, Ratio, Size
from dynamics_cli.records import Advice, Check, Choice, record


class Kind(Choice):
    """Proportions of a bevel gear's teeth."""

    names = ("gleason", "standard", "spiral", "zerol")
    aliases = {"straight": "gleason", "gleason-straight": "gleason", "plain": "standard"}  # noqa: RUF012


class Flank(Choice):
    """The driving flank of the pinion: the concave one, as usual, pushes it away from its apex."""

    names = ("concave", "convex")


@record
class BevelGear:
    """One gear of a bevel pair, at its outer end; angles above 90 degrees belong to an internal wheel."""

    pitch_angle: Annotated[Angle, "Pitch cone angle δ [rad]."]
    pitch_diameter: Annotated[Size, "Outer pitch diameter d_e [m]."]
    mean_diameter: Annotated[Size, "Pitch diameter in the middle of the face, d_m [m]."]
    addendum: Annotated[Size, "Outer addendum h_ae [m]."]
    dedendum: Annotated[Size, "Outer dedendum h_fe [m]."]
    addendum_angle: Annotated[Angle, "Addendum angle θ_a [rad]."]
    dedendum_angle: Annotated[Angle, "Dedendum angle θ_f [rad]."]
    tip_angle: Annotated[Angle, "Tip cone angle δ_a (AGMA: face angle) [rad]."]
    root_angle: Annotated[Angle, "Root cone angle δ_f [rad]."]
    tip_diameter: Annotated[Coordinate, "Outer tip diameter d_ae [m]."]
    tip_distance: Annotated[
        Coordinate, "From the apex of the pitch cone to the outer tip, along the axis (KHK: X) [m]."
    ]
    tip_width: Annotated[Coordinate, "Axial width of the face at the tips (KHK: X_b) [m]."]
    inner_diameter: Annotated[Coordinate, "Tip diameter at the inner end (KHK: d_i) [m]."]
    virtual_teeth: Annotated[Ratio | None, "Teeth of the spur gear of the back cone, z/cos δ; absent for a crown gear."]
    tangential_force: Annotated[Force | None, "Tangential force F_t at the mean diameter [N]."]
    axial_force: Annotated[Force | None, "Axial force, positive away from the apex [N]."]
    radial_force: Annotated[Force | None, "Radial force, positive towards its own axis [N]."]


@record
class BevelData:
    """A bevel pair."""

    ratio: Annotated[Ratio, "Gear ratio u = z₂/z₁."]
    cone_distance: Annotated[Size, "Outer cone distance R_e [m]."]
    mean_cone_distance: Annotated[Size, "Mean cone distance R_m [m]."]
    mean_module: Annotated[Module, "Transverse module in the middle of the face m_mt [m]."]
    face_ratio: Annotated[Ratio, "Face width over outer cone distance, best below 1/3."]
    transverse_pressure_angle: Annotated[Angle | None, "Transverse pressure angle α_t of spiral teeth [rad]."]
    crown_teeth: Annotated[Ratio, "Number of teeth of the crown gear that both mesh with, z₁/sin δ₁."]
    crown_shaft_angle: Annotated[
        Angle | None, "Shaft angle at which the wheel of these tooth numbers is a crown gear, cos Σ = −z₁/z₂ [rad]."
    ]
    contact_ratio: Annotated[Ratio | None, "Transverse contact ratio of the spur gears of the back cones (Tredgold)."]
    overlap_ratio: Annotated[Ratio | None, "Overlap ratio of spiral teeth at the mean cone distance."]
    first: Annotated[BevelGear, "The pinion."]
    second: Annotated[BevelGear, "The wheel."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
