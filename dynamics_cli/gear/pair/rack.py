"""A gear on a rack: dimensions and position of the rack, contact, motion and forces."""

from dynamics_cli.errors import require, worded
from dynamics_cli.gear import options
from dynamics_cli.gear.load import torque_of
from dynamics_cli.gear.pitch import Pitch, module_advice, module_of
from dynamics_cli.gear.single.cylindrical import normal_pressure_angle
from dynamics_cli.gear.single.gear import Gear, signed_gear
from dynamics_cli.gear.single.rack import BasicRack, basic_rack
from dynamics_cli.numerics.elementary import absolute, pi_beside, sin, tan
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Coordinate,
    Force,
    Power,
    Ratio,
    ShaftSpeed,
    Size,
    Speed,
    Teeth,
    Torque,
)
from dynamics_cli.records import Advice, record


@record
class RackData:
    """A rack and the gear on it."""

    pitch: Annotated[Size, "Transverse pitch p_t of the rack, along its travel [m]."]
    normal_pitch: Annotated[Size, "Normal pitch p_n [m]."]
    tooth_thickness: Annotated[Size, "Normal tooth thickness at the rack's datum line, half the pitch [m]."]
    addendum: Annotated[Size, "Addendum of the rack h_aP [m]."]
    dedendum: Annotated[Size, "Dedendum of the rack h_fP [m]."]
    tooth_depth: Annotated[Size, "Tooth depth [m]."]
    datum_distance: Annotated[Size, "From the gear's axis to the rack's datum line, r + x m_n, without backlash [m]."]
    mounting_distance: Annotated[
        Size | None, "From the gear's axis to the back of the rack, where its datum height is given [m]."
    ]
    tip_diameter: Annotated[Size, "Tip diameter of the gear d_a [m]."]
    base_diameter: Annotated[Size, "Base diameter of the gear d_b [m]."]
    reference_diameter: Annotated[Size, "Reference diameter of the gear d, which rolls on the rack's pitch line [m]."]
    transverse_contact_ratio: Annotated[Ratio, "Transverse contact ratio ε_α."]
    nominal_contact_ratio: Annotated[
        Ratio | None, "ε_α by the tips alone, as if no involute were cut away; given where some is."
    ]
    overlap_ratio: Annotated[Ratio | None, "Overlap ratio ε_β."]
    approach_length: Annotated[Coordinate, "Path of contact on the side of the rack's tips [m]."]
    recess_length: Annotated[Coordinate, "Path of contact on the side of the gear's tips [m]."]
    root_margin: Annotated[
        Coordinate, "Margin along the line of action between the rack's tip and the gear's root form circle [m]."
    ]
    travel: Annotated[Size, "Travel of the rack in one turn of the gear, z p_t [m]."]
    rack_speed: Annotated[Speed | None, "Speed of the rack [m/s]."]
    tangential_force: Annotated[Force | None, "Force along the travel [N]."]
    radial_force: Annotated[Force | None, "Force that parts gear and rack [N]."]
    axial_force: Annotated[Force | None, "Force across the travel [N]."]
    advice: tuple[Advice, ...] = ()


def _line_of_action(gear: Gear, basic: BasicRack, profile_shift: float) -> tuple[float, float, float, float, float]:
    """Lengths of approach and recess, the root's margin, the remaining approach, and the contact ratio."""
    module = gear.module
    radius = 0.5 * gear.reference_diameter
    sine = sin(gear.transverse_angle)
    approach = (basic.addendum - profile_shift) * module / sine
    recess = 0.5 * gear.base_diameter * gear.tip_roll - radius * sine
    form = gear.junction.roll * 0.5 * gear.base_diameter
    margin = radius * sine - approach - form
    first = approach if plain(margin) >= 0.0 else radius * sine - form
    ratio = (recess + first) / gear.base_pitch
    require(
        ratio > 0.0,
        "gear and rack never touch: the contact ratio would be {ratio:6}",
        ratio=(ratio, Ratio),
        code="open-mesh",
    )
    return approach, recess, margin, first, ratio


def rack(
    *,
    teeth: Annotated[Teeth, "Number of teeth of the gear."],
    pitch: Annotated[Pitch, "Size of the teeth, normal or transverse."],
    pressure_angle: options.NormalAngle = None,
    transverse_pressure_angle: options.TransverseAngle = None,
    helix_angle: Annotated[Angle, "Helix angle β of the gear, and of the rack's teeth [rad]."] = 0.0,
    profile_shift: Annotated[Ratio, "Profile shift factor x of the gear."] = 0.0,
    profile: options.RackName = options.RACK_A,
    addendum_factor: Annotated[Ratio | None, "Addendum factor h_a* of gear and rack, e.g. 1."] = None,
    dedendum_factor: Annotated[Ratio | None, "Dedendum factor h_fP* of gear and rack, e.g. 1.25."] = None,
    root_radius_factor: options.RackCorner = None,
    tip_shortening: options.TipShortening = 0.0,
    datum_height: Annotated[Size | None, "Height H of the rack's datum line above its back, e.g. 32 mm [m]."] = None,
    face_width: Annotated[Size | None, "Face width, for the overlap ratio, e.g. 20 mm [m]."] = None,
    speed: Annotated[ShaftSpeed | None, "Speed of the gear [rad/s]."] = None,
    torque: Annotated[Torque | None, "Torque on the gear, e.g. 12 N*m [N*m]."] = None,
    power: Annotated[Power | None, "Power, in place of the torque; needs the speed, e.g. 5 kW [W]."] = None,
) -> RackData:
    """Dimensions of a rack and of its mesh with a gear: distance, contact ratio, travel, forces.

    Equation
    --------
    a = z m_t/2 + x m_n (+ H); ε_α = [√(r_a² − r_b²) − r sin α_t + (h_a* − x)m_n/sin α_t]/p_bt; v = ω d/2.

    Returns
    -------
    RackData
        Rack, mesh and motion.

    Raises
    ------
    InadmissibleError
        When the gear is impossible, or the two never touch.

    Notes
    -----
    The working pressure angle is the rack's at any distance. Strength is not rated.

    References
    ----------
    ISO 53, ISO 21771; Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 17.9.

    Examples
    --------
    >>> from dynamics_cli.gear.pitch import NormalModule
    >>> answer = rack(teeth=12, pitch=NormalModule(0.003), profile_shift=0.6, datum_height=0.032)
    >>> round(1e3 * answer.mounting_distance, 3)
    51.8
    """
    lean = absolute(helix_angle)
    angle = normal_pressure_angle(pressure_angle, transverse_pressure_angle, lean)
    basic = basic_rack(profile, angle, addendum_factor, dedendum_factor, root_radius_factor)
    module = module_of(pitch, lean)
    gear = signed_gear(teeth, module, basic, helix_angle=lean, shift=profile_shift, tip_change=-tip_shortening / module)
    thickness = gear.tip_thickness
    require(thickness >= 0.0, "the gear's teeth are pointed below their tips", code="pointed", hint="lower the shift")
    alpha = gear.transverse_angle
    radius = 0.5 * gear.reference_diameter
    approach, recess, margin, first, ratio = _line_of_action(gear, basic, profile_shift)
    transverse = pi_beside(gear.transverse_module) * gear.transverse_module
    distance = radius + profile_shift * module
    if datum_height is not None:
        require(
            datum_height > basic.dedendum * module,
            "the rack's teeth reach {dedendum:6} below its datum line, which is {datum_height:6} above the back",
            dedendum=(plain(basic.dedendum * module), Size),
            datum_height=(plain(datum_height), Size),
            code="datum-height",
            hint="raise --datum-height",
        )
    load = torque_of(torque, power, speed)
    tangential = None if load is None else load / radius
    return RackData(
        pitch=transverse,
        normal_pitch=pi_beside(module) * module,
        tooth_thickness=0.5 * pi_beside(module) * module,
        addendum=basic.addendum * module,
        dedendum=basic.dedendum * module,
        tooth_depth=(basic.addendum + basic.dedendum) * module,
        datum_distance=distance,
        mounting_distance=None if datum_height is None else distance + datum_height,
        tip_diameter=gear.tip_diameter,
        base_diameter=gear.base_diameter,
        reference_diameter=gear.reference_diameter,
        transverse_contact_ratio=ratio,
        nominal_contact_ratio=(recess + approach) / gear.base_pitch if _cuts(margin / module) else None,
        overlap_ratio=None if face_width is None else face_width * sin(lean) / (pi_beside(module) * module),
        approach_length=first,
        recess_length=recess,
        root_margin=margin,
        travel=teeth * transverse,
        rack_speed=None if speed is None else speed * radius,
        tangential_force=tangential,
        radial_force=None if tangential is None else absolute(tangential) * tan(alpha),
        axial_force=None if tangential is None else absolute(tangential) * tan(lean),
        advice=module_advice(pitch, module) + _advice(margin / module, ratio),
    )


def _cuts(margin: float) -> bool:
    """Whether the involute ends short of the rack's tips by more than the corner rounding of a standard rack."""
    return plain(margin) < -1e-3


def _advice(margin: float, ratio: float) -> tuple[Advice, ...]:
    advice = []
    if _cuts(margin):
        message = worded(
            "the rack's tip reaches {margin} modules beyond the gear's involute", margin=(-plain(margin), Ratio)
        )
        remedy = "raise the profile shift, or the number of teeth"
        advice.append(Advice("interference", message, "serious", remedy))
    if plain(ratio) < 1.0:
        text = worded("the transverse contact ratio is {ratio:6}, below 1", ratio=(plain(ratio), Ratio))
        advice.append(Advice("contact-ratio", text, "serious"))
    return tuple(advice)
