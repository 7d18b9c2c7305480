"""Cylindrical worm pairs: geometry, lead angle, efficiency both ways, and self-locking with its sign."""

from math import pi

from dynamics_cli.errors import require, require_given, worded
from dynamics_cli.gear.crossing.virtual_teeth import tooth_advice
from dynamics_cli.gear.crossing.worm_records import (
    AxialModule,
    DiameterFactor,
    LeadAngle,
    WormData,
    WormDiameter,
    WormNormalModule,
)
from dynamics_cli.gear.load import torque_of
from dynamics_cli.gear.pitch import require_module
from dynamics_cli.gear.single.rack import FULL_DEPTH, require_pressure_angle
from dynamics_cli.numerics.elementary import absolute, atan, atan2, cos, multiply_add, pi_beside, sin, sqrt, tan
from dynamics_cli.numerics.number import like, plain
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Friction,
    Power,
    Ratio,
    ShaftSpeed,
    Size,
    Teeth,
    Torque,
)
from dynamics_cli.records import Advice, Check

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Results that need a torque.
LOADED = (
    "worm_torque", "wheel_torque", "worm_tangential_force", "worm_axial_force", "radial_force", "normal_force",
    "release_torque",
)  # fmt: skip


def worm(
    *,
    threads: Annotated[Teeth, "Number of threads of the worm z₁, e.g. 2."],
    teeth: Annotated[Teeth, "Number of teeth of the wheel z₂."],
    size: Annotated[AxialModule | WormNormalModule, "Size of the teeth, axial or normal."],
    worm: Annotated[
        WormDiameter | DiameterFactor | LeadAngle | None,
        "The worm's reference diameter, diameter factor or lead angle; without any, as the centre distance asks.",
    ] = None,
    pressure_angle: Annotated[Angle, "Normal pressure angle α_n [rad]."] = FULL_DEPTH,
    profile_shift: Annotated[
        Ratio | None,
        "Profile shift factor x₂ of the wheel, in axial modules; 0 unless given, or found from the centre "
        "distance, e.g. 0.3.",
    ] = None,
    centre_distance: Annotated[
        Size | None, "Centre distance, in place of the profile shift, or of the worm's diameter, e.g. 68 mm [m]."
    ] = None,
    addendum_factor: Annotated[Ratio, "Addendum factor."] = 1.0,
    dedendum_factor: Annotated[Ratio, "Dedendum factor."] = 1.25,
    friction: Annotated[Friction, "Coefficient of friction μ of the flanks."] = 0.05,
    speed: Annotated[ShaftSpeed | None, "Speed of the worm [rad/s]."] = None,
    torque: Annotated[Torque | None, "Torque on the worm, driving, e.g. 12 N*m [N*m]."] = None,
    power: Annotated[
        Power | None, "Power into the worm, in place of the torque; needs the speed, e.g. 5 kW [W]."
    ] = None,
) -> WormData:
    """Geometry of a worm pair with shafts at right angles, its efficiency both ways, and self-locking.

    Equation
    --------
    tan γ = m_x z₁/d₁; a = (d₁ + d₂)/2 + x₂ m_x; F_n = F_t/(cos α_n sin γ + μ cos γ);
    η = tan γ/tan(γ + ρ'), η' = tan(γ − ρ')/tan γ, tan ρ' = μ/cos α_n.

    Returns
    -------
    WormData
        Worm, wheel, efficiency and forces.

    Raises
    ------
    InadmissibleError
        When no diameter of the worm fits, its root vanishes, or friction locks it in both directions.

    Notes
    -----
    The pitch-point model of friction on an inclined plane; η' is negative when the worm locks itself, with the sign
    of tan(γ − ρ'). Tooth form (ZA, ZN, ZI, ZK) and strength are outside this task; length, face width and outside
    diameter are the usual choices, not limits.

    References
    ----------
    DIN 3975; Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 17.14.

    Examples
    --------
    >>> from math import degrees
    >>> answer = worm(threads=2, teeth=30, size=AxialModule(0.003), worm=WormDiameter(0.044))
    >>> round(degrees(answer.lead_angle), 5)
    7.76517
    """
    require_pressure_angle(pressure_angle)
    if worm is None:
        worm, centre_distance = _of_distance(size, teeth, profile_shift or 0.0, centre_distance), None
    module, gamma, slope, diameter = _worm(size, worm, threads)
    require_module(module)
    pressure_angle, friction = like(pressure_angle, module), like(friction, module)
    wheel, ded = teeth * module, dedendum_factor * module
    _require_root("worm", diameter - 2.0 * ded, "give the worm a larger diameter, or a smaller lead angle")
    profile_shift = _shift(profile_shift, centre_distance, 0.5 * (diameter + wheel), module)
    shift = profile_shift * module
    _require_root("wheel", wheel + 2.0 * (shift - ded), "give it more teeth, or a larger profile shift")
    rho, forward, backward = _efficiency(gamma, slope, pressure_angle, friction)
    axial = atan2(sin(pressure_angle), cos(pressure_angle) * cos(gamma))
    load = torque_of(torque, power, speed)
    load = None if load is None else absolute(load)
    return WormData(
        ratio=teeth / threads,
        lead_angle=gamma,
        axial_pressure_angle=axial,
        centre_distance=0.5 * (diameter + wheel) + shift if centre_distance is None else centre_distance,
        profile_shift=profile_shift,
        **_sizes(threads, teeth, module, gamma, diameter),
        **_heights(diameter, wheel, module, shift, addendum_factor * module, ded),
        friction_angle=rho,
        efficiency=forward,
        backward_efficiency=backward / slope,
        locking_margin=-atan(backward),
        self_locking=plain(-atan(backward)) >= 0.0,
        sliding_speed=None if speed is None else 0.5 * absolute(speed) * diameter / cos(gamma),
        wheel_speed=None if speed is None else speed * (threads / teeth),
        **_forces(load, wheel, diameter, gamma, rho, backward, pressure_angle, friction),
        checks=_checks(forward, gamma, pressure_angle, friction),
        advice=_advice(gamma, rho)
        + tooth_advice(
            "the wheel",
            teeth,
            axial,
            addendum_factor + profile_shift,
            addendum_factor - profile_shift,
            profile_shift,
            ("raise its profile shift, or give it more teeth", "lower its profile shift"),
        ),
    )


def _of_distance(
    size: AxialModule | WormNormalModule, teeth: int, shift: float, distance: float | None
) -> WormDiameter:
    """The worm that fills a centre distance."""
    require_given(
        distance is not None and isinstance(size, AxialModule),
        "the worm's diameter is not given",
        ("worm_diameter",),
        ("diameter_factor",),
        ("lead_angle",),
        ("module", "centre_distance"),
        code="worm",
    )
    assert distance is not None
    assert isinstance(size, AxialModule)
    diameter = 2.0 * (distance - shift * size.module) - teeth * size.module
    require(
        diameter > 0.0,
        "a wheel of {teeth} teeth does not fit into a centre distance of {distance:6}",
        teeth=teeth,
        distance=(distance, Size),
        code="centre-distance",
        hint="a smaller module, or fewer teeth",
    )
    return WormDiameter(diameter)


def _require_root(name: str, root: float, hint: str) -> None:
    code = "no-root" if name == "worm" else "no-wheel-root"
    message = "the {name}'s root diameter would be {root:6}"
    require(root > 0.0, message, name=name, root=(root, Size), code=code, hint=hint)


def _efficiency(gamma: float, slope: float, pressure_angle: float, friction: float) -> tuple[float, float, float]:
    """Angle of friction, efficiency with the worm driving, and tan(γ − ρ'); refuses a worm that cannot drive."""
    drag = friction / cos(pressure_angle)
    rho = atan(drag)
    require(
        gamma + rho < 0.5 * pi,
        "lead angle and angle of friction sum to {total:6}: the worm cannot drive the wheel either",
        total=(gamma + rho, Angle),
        code="locked",
        hint="a smaller lead angle or less friction",
    )
    # tan(γ ± ρ) from the tangents: a difference of angles would lose digits
    forward = slope * multiply_add(-slope, drag, 1.0) / (slope + drag)
    return rho, forward, (slope - drag) / (1.0 + slope * drag)


def _sizes(threads: int, teeth: int, module: float, gamma: float, diameter: float) -> "dict[str, Any]":
    """Pitches, modules and the usual lengths of the pair."""
    return {
        "lead": pi_beside(module) * module * threads,
        "axial_pitch": pi_beside(module) * module,
        "axial_module": module,
        "normal_module": module * cos(gamma),
        "diameter_factor": diameter / module,
        "worm_length": pi_beside(module) * module * (4.5 + 0.02 * teeth),
        "face_width": 2.0 * module * sqrt(diameter / module + 1.0),
    }


def _heights(diameter: float, wheel: float, module: float, shift: float, add: float, ded: float) -> "dict[str, Any]":
    """Diameters of worm and wheel at tip, pitch and root."""
    return {
        "worm_diameter": diameter,
        "worm_tip_diameter": diameter + 2.0 * add,
        "worm_root_diameter": diameter - 2.0 * ded,
        "wheel_diameter": wheel,
        "throat_diameter": wheel + 2.0 * (add + shift),
        "wheel_outer_diameter": wheel + 2.0 * (add + shift) + module,
        "wheel_root_diameter": wheel + 2.0 * (shift - ded),
        "throat_radius": 0.5 * diameter - add,
    }


def _worm(
    size: AxialModule | WormNormalModule, worm: WormDiameter | DiameterFactor | LeadAngle, threads: int
) -> tuple[float, float, float, float]:
    """Axial module, lead angle and its tangent, reference diameter."""
    if isinstance(worm, LeadAngle):
        gamma = worm.lead_angle
        require(
            (gamma > 0.0) & (gamma < 0.5 * pi),
            "the lead angle {gamma:6} must be above 0 and below 90 degrees",
            gamma=(gamma, Angle),
            code="lead-angle",
        )
        module = size.module if isinstance(size, AxialModule) else size.normal_module / cos(gamma)
        return module, gamma, tan(gamma), threads * module / tan(gamma)
    if isinstance(worm, DiameterFactor):
        gamma = atan2(threads, worm.diameter_factor)
        module = size.module if isinstance(size, AxialModule) else size.normal_module / cos(gamma)
        return module, gamma, threads / worm.diameter_factor, worm.diameter_factor * module
    diameter = worm.worm_diameter
    require(
        diameter > 0.0,
        "the diameter of the worm must be above zero, not {diameter:6}",
        diameter=(diameter, Size),
        code="worm-diameter",
    )
    if isinstance(size, AxialModule):
        rise = threads * size.module
        return size.module, atan2(rise, diameter), rise / diameter, diameter
    # sin γ = m_n z₁/d₁
    rise = threads * size.normal_module
    require(
        rise < diameter,
        "a worm of {diameter:6} diameter is too small for {threads} threads of {normal_module:6} normal "
        "module: sin γ would be {sine:6}",
        diameter=(diameter, Size),
        threads=threads,
        normal_module=(size.normal_module, Size),
        sine=(rise / diameter, Ratio),
        code="worm-diameter",
        hint="give the worm a larger diameter",
    )
    run = sqrt((diameter - rise) * (diameter + rise))
    gamma = atan2(rise, run)
    return size.normal_module / cos(gamma), gamma, rise / run, diameter


def _shift(shift: float | None, distance: float | None, reference: float, module: float) -> float:
    """x₂ as given, or as the centre distance requires."""
    require(
        shift is None or distance is None,
        "profile shift and centre distance are both given",
        code="shift",
        hint="give one of them: each follows from the other",
    )
    if distance is not None:
        return (distance - reference) / module
    return 0.0 if shift is None else shift


def _forces(
    torque: float | None,
    wheel: float,
    diameter: float,
    gamma: float,
    rho: float,
    left: float,
    pressure_angle: float,
    friction: float,
) -> "dict[str, Any]":
    """Torques and tooth forces when the worm drives; None without a torque."""
    if torque is None:
        return dict.fromkeys(LOADED)
    tangential = 2.0 * torque / diameter
    axial = tangential / tan(gamma + rho)
    normal = tangential / (cos(pressure_angle) * sin(gamma) + friction * cos(gamma))
    return {
        "worm_torque": torque,
        "wheel_torque": 0.5 * wheel * axial,
        "worm_tangential_force": tangential,
        "worm_axial_force": axial,
        "radial_force": normal * sin(pressure_angle),
        "normal_force": normal,
        "release_torque": 0.5 * diameter * axial * -left,
    }


def _checks(forward: float, gamma: float, pressure_angle: float, friction: float) -> tuple[Check, ...]:
    """The efficiency again from the forces of an inclined plane."""
    g, a, mu = plain(gamma), plain(pressure_angle), plain(friction)
    expected = tan(g) * (cos(a) - mu * tan(g)) / (cos(a) * tan(g) + mu)
    residual = abs(plain(forward) - expected)
    return (Check("efficiency from the forces", residual <= 1e-13, residual, 1e-13),)


def _advice(gamma: float, rho: float) -> tuple[Advice, ...]:
    lead, friction = plain(gamma), plain(rho)
    if lead <= friction:
        word = "statically self-locking" if lead > 0.5 * friction else "self-locking"
        message = worded(
            "{word}: the lead angle {lead} is below the angle of friction {friction}",
            word=word,
            lead=(lead, Angle),
            friction=(friction, Angle),
        )
        return (Advice("self-locking", message, "note", "vibration lowers friction: do not rely on it as a brake"),)
    if lead < 1.5 * friction:
        text = worded(
            "the lead angle {lead} is little above the angle of friction {friction}",
            lead=(lead, Angle),
            friction=(friction, Angle),
        )
        return (Advice("nearly-self-locking", text, remedy="its locking depends on lubrication and vibration"),)
    return ()
