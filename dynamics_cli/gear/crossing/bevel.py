"""Bevel gears of any shaft angle: straight, spiral and zerol, with crown and internal wheels."""

from math import pi

from dynamics_cli.errors import require, worded
from dynamics_cli.gear.crossing.bevel_records import BevelData, BevelGear, Flank, Kind
from dynamics_cli.gear.crossing.virtual_teeth import tooth_advice
from dynamics_cli.gear.load import torque_of
from dynamics_cli.gear.pitch import require_module
from dynamics_cli.gear.single.rack import FULL_DEPTH, require_pressure_angle
from dynamics_cli.numerics.elementary import absolute, atan, atan2, cos, pi_beside, sin, sqrt, tan
from dynamics_cli.numerics.number import like, plain
from dynamics_cli.quantities import Angle, Annotated, Module, Power, Ratio, ShaftSpeed, Size, Teeth, Torque
from dynamics_cli.records import Advice, Check

RIGHT_ANGLE = 0.5 * pi
# Gleason's usual spiral angles of cutters.
USUAL_SPIRAL = 35.0 * pi / 180.0
_NO_CONE = 1e-12
_REMEDY = ("use more teeth, or a larger pressure angle", "use more teeth, or a smaller addendum")


# of h_a2 in modules: 0.54 + 0.46/(…), working depth, whole depth
_DEPTHS = {"gleason": (0.54, 0.46, 2.0, 2.188), "zerol": (0.54, 0.46, 2.0, 2.188), "spiral": (0.46, 0.39, 1.7, 1.888)}


def _require_spiral(spiral: float, kind: Kind) -> None:
    require(
        spiral < 0.5 * pi,
        "the spiral angle {spiral:6} must be below 90 degrees",
        spiral=(spiral, Angle),
        code="spiral-angle",
    )
    require(
        kind == "spiral" or plain(spiral) == 0.0,
        "{kind} teeth have no spiral angle at the middle of the face",
        kind=kind,
        code="spiral-angle",
        hint="use --kind spiral",
    )


def bevel(
    *,
    first_teeth: Annotated[Teeth, "Number of teeth of the pinion z₁, e.g. 20."],
    second_teeth: Annotated[Teeth, "Number of teeth of the wheel z₂, e.g. 40."],
    module: Annotated[Module, "Outer transverse module m_et [m]."],
    shaft_angle: Annotated[Angle, "Shaft angle Σ [rad]."] = RIGHT_ANGLE,
    face_width: Annotated[Size, "Face width b along the pitch cone, e.g. 22 mm [m]."],
    pressure_angle: Annotated[Angle, "Normal pressure angle α_n [rad]."] = FULL_DEPTH,
    kind: Annotated[
        Kind, "Proportions: gleason (straight teeth, also written straight), standard, spiral or zerol."
    ] = Kind("gleason"),  # noqa: B008
    spiral_angle: Annotated[
        Angle | None,
        "Mean spiral angle β_m; 35 degrees for spiral teeth and 0 for the others, unless given, e.g. 35 deg [rad].",
    ] = None,
    flank: Annotated[
        Flank, "Driving flank of the pinion, concave or convex; it decides the thrust of spiral teeth."
    ] = Flank("concave"),  # noqa: B008
    torque: Annotated[Torque | None, "Torque on the pinion, for the forces, e.g. 12 N*m [N*m]."] = None,
    power: Annotated[Power | None, "Power, in place of the torque; needs the speed, e.g. 5 kW [W]."] = None,
    speed: Annotated[ShaftSpeed | None, "Speed of the pinion [rad/s]."] = None,
) -> BevelData:
    """Dimensions of a bevel pair at any shaft angle, straight, spiral or zerol, and its tooth forces.

    Equation
    --------
    δ₁ = atan2(sin Σ, u + cos Σ), δ₂ = atan2(u sin Σ, 1 + u cos Σ); R_e = d_e/(2 sin δ); θ_f = atan(h_f/R_e).

    Returns
    -------
    BevelData
        The pair and both gears.

    Raises
    ------
    InadmissibleError
        When the shaft angle is not between 0 and 180 degrees, the pinion would not be a cone, the face reaches the
        apex, or Gleason's proportions are requested for an internal wheel.

    Notes
    -----
    δ₂ above 90° is an internal wheel, and exactly 90°, at cos Σ = −z₁/z₂, a crown wheel. Strength (ISO 10300) is not
    rated. At equal torque the forces on both gears are the same force, resolved along two axes.

    References
    ----------
    ISO 23509; Gleason proportions as handbooks print them; Josephs & Huston, Dynamics of Mechanical Systems, CRC Press
    2002, section 17.13.

    Examples
    --------
    >>> from math import degrees
    >>> answer = bevel(first_teeth=20, second_teeth=40, module=0.003, face_width=0.022)
    >>> round(degrees(answer.first.tip_angle), 5)
    30.48699
    """
    angles = _cones(first_teeth, second_teeth, like(shaft_angle, module))
    require_pressure_angle(pressure_angle)
    require_module(module)
    pressure_angle = like(pressure_angle, module)
    usual = like(USUAL_SPIRAL, module) if kind == "spiral" else 0.0
    spiral = usual if spiral_angle is None else absolute(spiral_angle)
    _require_spiral(spiral, kind)
    ratio = second_teeth / first_teeth
    cone = 0.5 * first_teeth * module / sin(angles[0])
    require(
        (face_width > 0.0) & (face_width < cone),
        "the face width {face_width:6} must be above zero and below the cone distance {cone:6}",
        face_width=(face_width, Size),
        cone=(cone, Size),
        code="face-width",
        hint="take less than a third of the cone distance",
    )
    middle = cone - 0.5 * face_width
    mean_module = module * middle / cone
    depths = _depths(kind, module, angles, first_teeth, second_teeth)
    thetas = [atan(depth[1] / cone) for depth in depths]
    tips = (thetas[1], thetas[0]) if kind != "standard" else tuple(atan(depth[0] / cone) for depth in depths)
    mean_radius = 0.5 * first_teeth * mean_module
    load = torque_of(torque, power, speed)
    tangential = None if load is None else absolute(load) / mean_radius
    gears = []
    for index, (teeth, angle, depth) in enumerate(zip((first_teeth, second_teeth), angles, depths, strict=True)):
        lean = spiral if (flank == "concave") == (index == 0) else -spiral
        sizes = module, mean_module, cone, face_width
        gears.append(_gear(teeth, angle, depth, tips[index], thetas[index], sizes, tangential, pressure_angle, lean))
    transverse = atan2(sin(pressure_angle), cos(pressure_angle) * cos(spiral))
    overlap = face_width * tan(spiral) / (pi_beside(mean_module) * mean_module) if plain(spiral) > 0.0 else None
    return BevelData(
        ratio=ratio,
        cone_distance=cone,
        mean_cone_distance=middle,
        mean_module=mean_module,
        face_ratio=face_width / cone,
        transverse_pressure_angle=transverse if plain(spiral) > 0.0 else None,
        crown_teeth=first_teeth / sin(angles[0]),
        crown_shaft_angle=_crown(first_teeth, second_teeth, module),
        contact_ratio=_tredgold(first_teeth, second_teeth, angles, depths, module, transverse),
        overlap_ratio=overlap,
        first=gears[0],
        second=gears[1],
        checks=_checks(angles, shaft_angle),
        advice=_advice(angles, face_width / cone, face_width / module)
        + _teeth_advice((first_teeth, second_teeth), angles, depths, module, transverse),
    )


def _cones(first: int, second: int, shaft_angle: float) -> tuple[float, float]:
    """Both pitch angles; refuses shaft angles that are not those of a bevel pair."""
    require(
        (shaft_angle > 0.0) & (shaft_angle < pi),
        "the shaft angle {shaft_angle:6} must be above 0 and below 180 degrees",
        shaft_angle=(shaft_angle, Angle),
        code="shaft-angle",
        hint="parallel shafts take gear pair",
    )
    ratio = second / first
    sine, cosine = sin(shaft_angle), cos(shaft_angle)
    pitch_angle = atan2(sine, ratio + cosine)
    other = atan2(ratio * sine, 1.0 + ratio * cosine)
    require(
        pitch_angle < 0.5 * pi,
        "the first gear would be internal: its pitch angle is {pitch_angle:6}",
        pitch_angle=(pitch_angle, Angle),
        code="internal-pinion",
        hint="exchange the gears",
    )
    return pitch_angle, other


def _crown(first: int, second: int, beside: float) -> float | None:
    """Shaft angle at which the wheel is a crown gear; None where the pinion has as many teeth or more."""
    if second <= first:
        return None
    return atan2(sqrt(like(float((second - first) * (second + first)), beside)), like(-float(first), beside))


def _depths(
    kind: str, module: float, angles: tuple[float, float], first: int, second: int
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Addendum and dedendum of pinion and wheel."""
    if kind == "standard":
        return (module, 1.25 * module), (module, 1.25 * module)
    least, more, working, full = _DEPTHS[kind]
    equivalent = first * cos(angles[1]) / (second * cos(angles[0]))
    require(
        equivalent > -_NO_CONE,
        "Gleason's proportions do not exist for an internal wheel; its pitch angle is {pitch_angle:6}",
        pitch_angle=(angles[1], Angle),
        code="internal-wheel",
        hint="use --kind standard",
    )
    wheel = (least + more * equivalent) * module
    pinion = working * module - wheel
    return (pinion, full * module - pinion), (wheel, full * module - wheel)


def _gear(
    teeth: int,
    angle: float,
    depth: tuple[float, float],
    addendum_angle: float,
    dedendum_angle: float,
    sizes: tuple[float, float, float, float],
    tangential: float | None,
    pressure_angle: float,
    lean: float,
) -> BevelGear:
    module, mean_module, cone, face = sizes
    sine, cosine = sin(angle), cos(angle)
    tip = angle + addendum_angle
    diameter = teeth * module + 2.0 * depth[0] * cosine
    forces: tuple[float | None, float | None] = (None, None)
    if tangential is not None:
        up = tan(pressure_angle) / cos(lean)
        along = sin(lean) / cos(lean)
        forces = tangential * (up * sine + along * cosine), tangential * (up * cosine - along * sine)
    return BevelGear(
        pitch_angle=angle,
        pitch_diameter=teeth * module,
        mean_diameter=teeth * mean_module,
        addendum=depth[0],
        dedendum=depth[1],
        addendum_angle=addendum_angle,
        dedendum_angle=dedendum_angle,
        tip_angle=tip,
        root_angle=angle - dedendum_angle,
        tip_diameter=diameter,
        tip_distance=cone * cosine - depth[0] * sine,
        tip_width=face * cos(tip) / cos(addendum_angle),
        inner_diameter=diameter - 2.0 * face * sin(tip) / cos(addendum_angle),
        virtual_teeth=teeth / cosine if abs(plain(cosine)) > _NO_CONE else None,
        tangential_force=tangential,
        axial_force=forces[0],
        radial_force=forces[1],
    )


def _tredgold(
    first: int,
    second: int,
    angles: tuple[float, float],
    depths: tuple[tuple[float, float], tuple[float, float]],
    module: float,
    pressure_angle: float,
) -> float | None:
    """ε_α of the spur gears on the back cones, those of an internal wheel negative."""
    cosines = cos(angles[0]), cos(angles[1])
    sine, cosine = sin(pressure_angle), cos(pressure_angle)
    total = 0.0 * module
    for teeth, cone, depth in zip((first, second), cosines, depths, strict=True):
        if abs(plain(cone)) <= 1e-9:
            total = total + depth[0] / sine
            continue
        radius = 0.5 * teeth * module / cone
        base, tip = radius * cosine, radius + depth[0]
        square = (tip - base) * (tip + base)
        if plain(square) < 0.0:
            return None
        reach = sqrt(square)
        total = total + ((reach if plain(cone) > 0.0 else -reach) - radius * sine)
    return total / (pi_beside(module, cosine) * module * cosine)


def _teeth_advice(
    teeth: tuple[int, int],
    angles: tuple[float, float],
    depths: tuple[tuple[float, float], tuple[float, float]],
    module: float,
    pressure_angle: float,
) -> tuple[Advice, ...]:
    """Undercut and tips of the teeth on the back cones; the flank of the tool ends where the mate's tips do."""
    advice: tuple[Advice, ...] = ()
    for index, who in enumerate(("the pinion", "the wheel")):
        cosine = cos(angles[index])
        if plain(cosine) > _NO_CONE:
            height, depth = depths[index][0] / module, depths[1 - index][0] / module
            # a long addendum needs a thick tooth: Gleason adds half the difference of the addenda times tan α
            shift = 0.5 * (height - depth)
            advice += tooth_advice(who, teeth[index] / cosine, pressure_angle, height, depth, shift, _REMEDY)
    return advice


def _checks(angles: tuple[float, float], shaft_angle: float) -> tuple[Check, ...]:
    residual = abs(plain(angles[0]) + plain(angles[1]) - plain(shaft_angle))
    return (Check("pitch angles add to the shaft angle", residual <= 1e-14, residual, 1e-14),)


def _advice(angles: tuple[float, float], face_ratio: float, face_modules: float) -> tuple[Advice, ...]:
    advice = []
    wheel = plain(angles[1])
    if abs(wheel - 0.5 * pi) <= 1e-9:
        advice.append(Advice("crown-wheel", "the wheel is a crown gear: its pitch cone is flat", "note"))
    elif wheel > 0.5 * pi:
        advice.append(Advice("internal-wheel", "the wheel is internal: its pitch angle is above 90 degrees", "note"))
    if plain(face_ratio) > 1.0 / 3.0 or plain(face_modules) > 10.0:
        message = worded(
            "the face is {face_ratio:3} of the cone distance and {face_modules:3} modules wide",
            face_ratio=(plain(face_ratio), Ratio),
            face_modules=(plain(face_modules), Ratio),
        )
        advice.append(Advice("wide-face", message, remedy="keep it below a third of the cone distance and ten modules"))
    return tuple(advice)
