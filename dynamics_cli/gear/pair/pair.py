"""Two cylindrical gears on parallel shafts: position, contact, sliding, forces and interference."""

from math import gcd

from dynamics_cli.errors import require, require_given
from dynamics_cli.gear import options
from dynamics_cli.gear.load import torque_of
from dynamics_cli.gear.pair.advice import pair_advice
from dynamics_cli.gear.pair.backlash import as_cut, generating_shift, thinned_for, total_backlash
from dynamics_cli.gear.pair.engagement import (
    Engagement,
    Path,
    contact_ratio,
    overlap_ratio,
    path,
    reference_distance,
    specific_sliding,
)
from dynamics_cli.gear.pair.forces import BearingLoad, Bearings, ToothForces, bearing_loads, loss_factor, tooth_forces
from dynamics_cli.gear.pair.interference import Verdict, verdicts
from dynamics_cli.gear.pair.records import ContactPoint, Mate, PairData
from dynamics_cli.gear.pair.shift_split import Split, Tips, engaged
from dynamics_cli.gear.pitch import Pitch, module_advice, module_of
from dynamics_cli.gear.single.cylindrical import normal_pressure_angle
from dynamics_cli.gear.single.gear import Hand, signed_gear
from dynamics_cli.gear.single.rack import basic_rack
from dynamics_cli.numerics.elementary import absolute, cos, pi_beside, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Annotated, Friction, Power, Ratio, ShaftSpeed, Size, Torque
from dynamics_cli.records import Check

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

EQUAL, CLEARANCE = Split("equal"), Tips("clearance")


def pair(
    *,
    first: Annotated[Mate, "The driving gear (of an internal pair, the pinion)."],
    second: Annotated[Mate, "The driven gear (of an internal pair, the ring)."],
    pitch: Annotated[Pitch, "Size of the teeth, normal or transverse."],
    pressure_angle: options.NormalAngle = None,
    transverse_pressure_angle: options.TransverseAngle = None,
    helix_angle: options.HelixAngle = 0.0,
    hand: Annotated[Hand, "Hand of the first gear's helix."] = Hand("right"),  # noqa: B008
    profile: options.RackName = options.RACK_A,
    addendum_factor: options.AddendumFactor = None,
    dedendum_factor: options.DedendumFactor = None,
    root_radius_factor: options.RackCorner = None,
    internal: Annotated[bool, "The second gear is internal."] = False,
    shift_sign: options.ShiftSign = options.ISO,
    centre_distance: Annotated[
        Size | None, "Working centre distance; with both shifts given, the backlash follows from it, e.g. 90 mm [m]."
    ] = None,
    split: Annotated[
        Split,
        "How the shift that a centre distance requires is divided: equal, by-teeth, first, second, balanced-sliding.",
    ] = EQUAL,
    tips: Annotated[
        Tips, "Tips shortened so that the rack's tip clearance is kept (clearance), or not (full)."
    ] = CLEARANCE,
    backlash: Annotated[
        Size | None,
        "Circumferential backlash j_wt on the working pitch circles: teeth of both gears are thinned alike for it, "
        "e.g. 0.1 mm [m].",
    ] = None,
    face_width: Annotated[Size | None, "Common face width b, for the overlap ratio, e.g. 20 mm [m]."] = None,
    friction: Annotated[Friction, "Mean coefficient of friction of the flanks, for the efficiency."] = 0.06,
    torque: Annotated[Torque | None, "Torque on the first gear, e.g. 12 N*m [N*m]."] = None,
    power: Annotated[Power | None, "Power, in place of the torque; needs the speed, e.g. 5 kW [W]."] = None,
    speed: Annotated[ShaftSpeed | None, "Speed of the first gear [rad/s]."] = None,
    first_bearings: Annotated[Bearings | None, "Bearings of the first gear's shaft."] = None,
    second_bearings: Annotated[Bearings | None, "Bearings of the second gear's shaft."] = None,
) -> PairData:
    """Two gears in mesh: centre distance, contact, sliding, backlash, interference and forces.

    Equation
    --------
    inv α_wt = inv α_t + 2(x₁ + x₂)tan α_n/(z₁ + z₂); a_w = a_d cos α_t/cos α_wt; ε_α = [√(r_a1² − r_b1²) +
    √(r_a2² − r_b2²) − a_w sin α_wt]/p_bt; an internal gear has z₂ < 0, and with it negative lengths.

    Returns
    -------
    PairData
        The geometry of the pair, its path of contact, verdicts on interference, and forces.

    Raises
    ------
    InadmissibleError
        When inv α_w would be negative, when the centre distance is less than that of the base circles or jams the
        teeth, when a ring has too few teeth, when the gears never touch, or when one gear is impossible by itself.

    Notes
    -----
    The geometry is nominal, without deviations or deflection. Strength (ISO 6336, AGMA 2001) is not rated. As α_wt → 0
    the centre distance becomes ever more sensitive to the shifts (as inv α_t/tan α_wt), and its error bound grows with
    it. The efficiency is Ohlendorf's estimate for a constant coefficient of friction and a contact ratio from 1 to 2.

    References
    ----------
    ISO 21771, sections 5 to 7; Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 17.6 to 17.8.

    Examples
    --------
    >>> from dynamics_cli.gear.pitch import NormalModule
    >>> answer = pair(first=Mate(12, 0.6), second=Mate(24, 0.36), pitch=NormalModule(0.003))
    >>> round(1e3 * answer.centre_distance, 4)
    56.4999
    """
    helix = absolute(helix_angle)
    angle = normal_pressure_angle(pressure_angle, transverse_pressure_angle, helix)
    rack = basic_rack(profile, angle, addendum_factor, dedendum_factor, root_radius_factor)
    module = module_of(pitch, helix)
    gears = [
        signed_gear(
            mate.teeth,
            module,
            rack,
            internal=ring,
            sign=shift_sign,
            helix_angle=helix,
            shift=0.0 if mate.profile_shift is None else mate.profile_shift,
        )
        for mate, ring in ((first, False), (second, internal))
    ]
    mesh, tip_change = engaged(gears[0], gears[1], first, second, centre_distance, split, tips)
    if backlash is not None:
        first, second = thinned_for(mesh, first, second, backlash)
        mesh, tip_change = engaged(gears[0], gears[1], first, second, centre_distance, split, tips)
    actual_backlash = total_backlash(mesh, (first, second))
    cut = as_cut(mesh.first, first.thinning), as_cut(mesh.second, second.thinning)
    contact_path = path(mesh)
    input_torque = torque_of(torque, power, speed)
    interference = verdicts(mesh, contact_path, actual_backlash, cut, root_radius_factor)
    forces = None if input_torque is None else tooth_forces(mesh, input_torque, _first_hand(hand, helix_angle))
    working = mesh.working_diameter(mesh.first), mesh.working_diameter(mesh.second)
    contact = _contact(mesh, contact_path, face_width)
    thinned = first.thinning, second.thinning
    return PairData(
        **_circles(mesh, working),
        tip_change=tip_change,
        **contact,
        **_clearances(mesh, interference, actual_backlash, thinned),
        **_losses(mesh, contact_path, friction),
        **_running(mesh, working[0], input_torque, speed),
        forces=forces,
        bearings=_bearing_loads(forces, working, (first_bearings, second_bearings)),
        points=tuple(_points(mesh, contact_path, working[0], speed)),
        verdicts=interference,
        checks=_checks(mesh),
        advice=pair_advice(mesh, contact["transverse_contact_ratio"], actual_backlash, interference, thinned)
        + module_advice(pitch, module),
    )


def _first_hand(hand: Hand, helix_angle: float) -> str:
    """The hand of the first gear; a negative helix angle turns it round."""
    return str(hand) if plain(helix_angle) >= 0.0 else ("left" if hand == "right" else "right")


def _circles(mesh: Engagement, working: tuple[float, float]) -> "dict[str, Any]":
    """Distance, shifts and diameters by the names of results; lengths of an internal gear without their sign."""
    first, second = mesh.first, mesh.second
    reference = reference_distance(first, second)
    return {
        "centre_distance": absolute(mesh.centre_distance),
        "working_pressure_angle": mesh.angle,
        "involute": mesh.tight,
        "ratio": abs(second.teeth) / first.teeth,
        "first_profile_shift": first.shift,
        "second_profile_shift": second.shift,
        "reference_distance": absolute(reference),
        "distance_modification": absolute(mesh.centre_distance / first.module) - absolute(reference / first.module),
        "first_working_diameter": working[0],
        "second_working_diameter": absolute(working[1]),
        "first_base_diameter": first.base_diameter,
        "second_base_diameter": absolute(second.base_diameter),
        "first_tip_diameter": first.tip_diameter,
        "second_tip_diameter": absolute(second.tip_diameter),
        "first_root_diameter": first.root_diameter,
        "second_root_diameter": absolute(second.root_diameter),
    }


def _contact(mesh: Engagement, contact_path: Path, face_width: float | None) -> "dict[str, Any]":
    """Contact ratios and lengths of the path of contact."""
    transverse = contact_ratio(mesh, contact_path.start, contact_path.end)
    nominal = contact_ratio(mesh, contact_path.nominal_start, contact_path.nominal_end)
    overlap = None if face_width is None else overlap_ratio(mesh.first, face_width)
    return {
        "transverse_contact_ratio": transverse,
        "nominal_contact_ratio": nominal if plain(nominal) != plain(transverse) else None,
        "overlap_ratio": overlap,
        "total_contact_ratio": None if overlap is None else transverse + overlap,
        "path_length": contact_path.end - contact_path.start,
        "approach_length": mesh.pitch_curvature - contact_path.start,
        "recess_length": contact_path.end - mesh.pitch_curvature,
    }


def _clearances(
    mesh: Engagement, interference: tuple[Verdict, ...], backlash: float, thinned: tuple[float, float]
) -> "dict[str, Any]":
    """Backlash with the shifts that cut it, and the clearance at the tips."""
    tips = interference[-4:] if mesh.second.internal else interference[-2:]
    return {
        "first_generating_shift": generating_shift(mesh.first, thinned[0]),
        "second_generating_shift": generating_shift(mesh.second, thinned[1]),
        "circumferential_backlash": backlash,
        "normal_backlash": backlash * cos(mesh.angle) * cos(mesh.first.base_helix_angle),
        "first_tip_clearance": tips[0].margin,
        "second_tip_clearance": tips[1].margin,
    }


def _losses(mesh: Engagement, contact_path: Path, friction: float) -> "dict[str, Any]":
    """The loss factor, and the efficiency by it."""
    losses = loss_factor(mesh, contact_path)
    require(
        friction * losses < 1.0,
        "with a coefficient of friction of {friction:6} the losses would be {loss:6} times the power",
        friction=(friction, Ratio),
        loss=(friction * losses, Ratio),
        code="friction",
        hint="lubricated gears have about 0.03 to 0.1",
    )
    return {"loss_factor": losses, "efficiency": 1.0 - friction * losses}


def _running(mesh: Engagement, working: float, torque: float | None, speed: float | None) -> "dict[str, Any]":
    """Speeds, frequencies and torques, as far as the speed and the torque of the first gear are given."""
    first, second = mesh.first.teeth, abs(mesh.second.teeth)
    common = gcd(first, second)
    turns = None if speed is None else absolute(speed) / (2.0 * pi_beside(speed))
    return {
        "common_factor": common,
        "pitch_line_speed": None if speed is None else 0.5 * absolute(speed) * working,
        "mesh_frequency": None if turns is None else turns * first,
        "hunting_frequency": None if turns is None else turns * common / second,
        "torque": torque,
        "second_torque": None if torque is None else torque * second / first,
    }


def _points(mesh: Engagement, contact_path: Path, working: float, speed: float | None) -> "list[ContactPoint]":
    """Diameters, curvatures and sliding at the five points of the path of contact."""
    pitch = mesh.first.base_pitch
    places = (
        ("A", contact_path.start),
        ("B", contact_path.end - pitch),
        ("C", mesh.pitch_curvature),
        ("D", contact_path.start + pitch),
        ("E", contact_path.end),
    )
    points = []
    for name, curvature in places:
        second_curvature = mesh.line - curvature
        path_length = curvature - mesh.pitch_curvature
        factor = 2.0 * path_length * ((mesh.first.teeth + mesh.second.teeth) / mesh.second.teeth) / working
        first_sliding, second_sliding = specific_sliding(mesh, curvature)
        base1, base2 = 0.5 * mesh.first.base_diameter, 0.5 * mesh.second.base_diameter
        points.append(
            ContactPoint(
                name,
                path_length,
                2.0 * sqrt(base1 * base1 + curvature * curvature),
                2.0 * sqrt(base2 * base2 + second_curvature * second_curvature),
                absolute(curvature),
                absolute(second_curvature),
                factor,
                None if speed is None else 0.5 * factor * working * absolute(speed),
                first_sliding,
                second_sliding,
            )
        )
    return points


def _bearing_loads(
    forces: ToothForces | None, working: tuple[float, float], bearings: tuple[Bearings | None, Bearings | None]
) -> tuple[BearingLoad, ...] | None:
    if bearings[0] is None and bearings[1] is None:
        return None
    require_given(
        forces is not None,
        "loads of the bearings need a torque",
        ("torque",),
        ("power", "speed"),
        code="load",
    )
    loads: tuple[BearingLoad, ...] = ()
    for name, diameter, shaft in zip(("first", "second"), working, bearings, strict=True):
        if shaft is not None:
            loads += bearing_loads(name, forces, 0.5 * absolute(diameter), shaft)  # type: ignore[arg-type]
    return loads


def _checks(mesh: Engagement) -> tuple[Check, ...]:
    """Check that working pitch circle and base circle of the first gear agree."""
    from dynamics_cli.numerics.elementary import cos as cosine

    pinion_base = plain(mesh.working_diameter(mesh.first)) * cosine(plain(mesh.angle))
    base = plain(mesh.first.base_diameter)
    residual = abs(pinion_base - base) / base
    return (Check("working pitch circle and base circle", residual <= 1e-13, residual, 1e-13),)
