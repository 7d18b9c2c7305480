"""A gear on a rack: the rack's own dimensions, where it stands, how it touches and what it moves."""

from dynamics_cli.errors import require
from dynamics_cli.gear.gear import Pitch, Profile, basic_rack, module_advice, module_of, signed_gear
from dynamics_cli.gear.limits import plain
from dynamics_cli.gear.single import normal_pressure_angle
from dynamics_cli.gear.trochoid import root
from dynamics_cli.numerics.elementary import absolute, pi_beside, sin, tan
from dynamics_cli.quantities import Angle, Coordinate, Force, Ratio, ShaftSpeed, Size, Speed, Teeth, Torque
from dynamics_cli.records import Advice, record


@record
class RackData:
    """A rack and the gear on it.

    Parameters
    ----------
    pitch : Size
        Transverse pitch p_t of the rack, along its travel [m].
    normal_pitch : Size
        Normal pitch p_n [m].
    tooth_thickness : Size
        Normal tooth thickness at the rack's datum line, half the pitch [m].
    addendum : Size
        Addendum of the rack h_aP [m].
    dedendum : Size
        Dedendum of the rack h_fP [m].
    tooth_depth : Size
        Tooth depth [m].
    datum_distance : Size
        From the gear's axis to the rack's datum line, r + x m_n, without backlash [m].
    mounting_distance : Size
        From the gear's axis to the back of the rack, where its datum height is given [m].
    tip_diameter : Size
        Tip diameter of the gear d_a [m].
    base_diameter : Size
        Base diameter of the gear d_b [m].
    reference_diameter : Size
        Reference diameter of the gear d, which rolls on the rack's pitch line [m].
    transverse_contact_ratio : Ratio
        Transverse contact ratio ε_α.
    overlap_ratio : Ratio
        Overlap ratio ε_β.
    approach_length : Coordinate
        Path of contact on the side of the rack's tips [m].
    recess_length : Coordinate
        Path of contact on the side of the gear's tips [m].
    root_margin : Coordinate
        What is left along the line of action between the rack's tip and the gear's root form circle [m].
    travel : Size
        Travel of the rack in one turn of the gear, z p_t [m].
    rack_speed : Speed
        Speed of the rack [m/s].
    tangential_force : Force
        Force along the travel [N].
    radial_force : Force
        Force that parts gear and rack [N].
    axial_force : Force
        Force across the travel [N].
    """

    pitch: Size
    normal_pitch: Size
    tooth_thickness: Size
    addendum: Size
    dedendum: Size
    tooth_depth: Size
    datum_distance: Size
    mounting_distance: Size | None
    tip_diameter: Size
    base_diameter: Size
    reference_diameter: Size
    transverse_contact_ratio: Ratio
    overlap_ratio: Ratio | None
    approach_length: Coordinate
    recess_length: Coordinate
    root_margin: Coordinate
    travel: Size
    rack_speed: Speed | None
    tangential_force: Force | None
    radial_force: Force | None
    axial_force: Force | None
    advice: tuple[Advice, ...] = ()


def rack(
    *,
    teeth: Teeth,
    pitch: Pitch,
    pressure_angle: Angle | None = None,
    transverse_pressure_angle: Angle | None = None,
    helix_angle: Angle = 0.0,
    profile_shift: Ratio = 0.0,
    profile: Profile = Profile("a"),  # noqa: B008
    addendum_factor: Ratio | None = None,
    dedendum_factor: Ratio | None = None,
    root_radius_factor: Ratio | None = None,
    tip_shortening: Size = 0.0,
    datum_height: Size | None = None,
    face_width: Size | None = None,
    speed: ShaftSpeed | None = None,
    torque: Torque | None = None,
) -> RackData:
    """Dimensions of a rack and of its mesh with a gear: distance, contact ratio, travel, forces.

    Equation
    --------
    a = z m_t/2 + x m_n (+ H); ε_α = [√(r_a² − r_b²) − r sin α_t + (h_a* − x)m_n/sin α_t]/p_bt; v = ω d/2.

    Parameters
    ----------
    teeth : Teeth
        Number of teeth of the gear.
    pitch : Pitch
        Size of the teeth, normal or transverse.
    pressure_angle : Angle
        Normal pressure angle α_n; 20 degrees unless one is given [rad].
    transverse_pressure_angle : Angle
        Transverse pressure angle α_t, in place of the normal one [rad].
    helix_angle : Angle
        Helix angle β of the gear, and of the rack's teeth [rad].
    profile_shift : Ratio
        Profile shift factor x of the gear.
    profile : Profile
        Basic rack: a to d of ISO 53, stub, agma-coarse, agma-fine; the factors below replace its own.
    addendum_factor : Ratio
        Addendum factor h_a* of gear and rack.
    dedendum_factor : Ratio
        Dedendum factor h_fP* of gear and rack.
    root_radius_factor : Ratio
        Radius of the generating rack's corner ρ_fP*.
    tip_shortening : Size
        How much the gear's tips are cut back, radially [m].
    datum_height : Size
        Height H of the rack's datum line above its back [m].
    face_width : Size
        Face width, for the overlap ratio [m].
    speed : ShaftSpeed
        Speed of the gear [rad/s].
    torque : Torque
        Torque on the gear [N m].

    Returns
    -------
    RackData
        Rack, mesh and motion.

    Raises
    ------
    InadmissibleError
        When there is no such gear, or the two never touch.

    Notes
    -----
    The pressure angle of the mesh is that of the rack whatever the distance. Strength is not rated.

    References
    ----------
    ISO 53, ISO 21771; Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 17.9.

    Examples
    --------
    >>> from dynamics_cli.gear.gear import NormalModule
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
    sine = sin(alpha)
    approach = (basic.addendum - profile_shift) * module / sine
    recess = 0.5 * gear.base_diameter * gear.tip_roll - radius * sine
    form = root(gear.cutter).roll * 0.5 * gear.base_diameter
    margin = radius * sine - approach - form
    first = approach if plain(margin) >= 0.0 else radius * sine - form
    ratio = (recess + first) / gear.base_pitch
    require(ratio > 0.0, "gear and rack never touch: the contact ratio would be {0:.6g}", ratio, code="open-mesh")
    transverse = pi_beside(gear.transverse_module) * gear.transverse_module
    distance = radius + profile_shift * module
    if datum_height is not None:
        require(
            datum_height > basic.dedendum * module,
            "the rack's teeth reach {0:.6g} mm below its datum line, which is {1:.6g} mm above the back",
            1e3 * plain(basic.dedendum * module),
            1e3 * plain(datum_height),
            code="datum-height",
            hint="raise --datum-height",
        )
    tangential = None if torque is None else torque / radius
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


def _advice(margin: float, ratio: float) -> tuple[Advice, ...]:
    made = []
    if plain(margin) < 0.0:
        made.append(
            Advice(
                "interference",
                f"the rack's tip reaches {-plain(margin):.4g} modules beyond the gear's involute",
                "serious" if plain(margin) < -1e-3 else "note",
                "raise the profile shift, or the number of teeth",
            )
        )
    if plain(ratio) < 1.0:
        made.append(Advice("contact-ratio", f"the transverse contact ratio is {plain(ratio):.6g}, below 1", "serious"))
    return tuple(made)
