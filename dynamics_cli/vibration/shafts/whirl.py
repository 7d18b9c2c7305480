"""A disk on a flexible shaft: critical speeds, whirl, bearing force; the Campbell diagram of a disk that tilts."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, pi_beside, sqrt
from dynamics_cli.numerics.number import single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    DampingRatio,
    Eccentricity,
    Force,
    Inertia,
    Mass,
    Positive,
    Pressure,
    Ratio,
    ShaftSpeed,
    Size,
    SpringRate,
)
from dynamics_cli.records import Advice, Choice, record
from dynamics_cli.vibration.shafts.campbell import (
    FreeWhirl,
    TiltingDisk,
    WhirlCritical,
    WhirlsAtSpeed,
    diagram,
    meetings,
    whirls_at,
)
from dynamics_cli.vibration.single.forced import NO_PEAK, magnification
from dynamics_cli.vibration.single.oscillator import require_damping

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Rotors run at least this far from a critical speed.
MARGIN = 0.2


class Support(Choice):
    """How the shaft is held."""

    names = ("bearings", "overhung")


BEARINGS = Support("bearings")


@record
class Known:
    """The shaft by its stiffness at the disk."""

    stiffness: Annotated[SpringRate, "Force at the disk per deflection there, e.g. 4000 N/mm."]


@record
class Bar:
    """A round shaft."""

    diameter: Annotated[Size, "Diameter of the shaft, e.g. 40 mm."]
    length: Annotated[Size, "Between the bearings, or the overhang, e.g. 900 mm."]
    position: Annotated[Size | None, "From one bearing to the disk; the middle unless given, e.g. 300 mm."] = None
    support: Annotated[Support, "bearings: a short bearing at each end; overhung: clamped at one end."] = BEARINGS
    elastic_modulus: Annotated[Pressure, "Elastic modulus; steel unless given, e.g. 210000 MPa."] = 210e9


@record
class Whirl:
    """Whirl of a disk on a shaft."""

    critical_speed: Annotated[ShaftSpeed, "Critical speed, the disk not tilting [rad/s]."]
    amplitude: Annotated[Size | None, "Whirl of the middle of the shaft at the speed given [m]."]
    phase: Annotated[Angle | None, "By how much it lags the centre of mass [rad]."]
    response: Annotated[Ratio | None, "Amplitude over eccentricity, r²·H [-]."]
    bearing_force: Annotated[Force | None, "Rotating force that bends the shaft, on both bearings together [N]."]
    ratio: Annotated[Ratio | None, "Speed over critical speed r [-]."]
    peak_amplitude: Annotated[Size | None, "Largest whirl while passing the critical speed slowly [m]."]
    static_deflection: Annotated[Size, "Deflection of a horizontal shaft under the weight [m]."]
    stiffness: Annotated[SpringRate, "Stiffness of the shaft at the disk [N/m]."]
    forward_speed: Annotated[ShaftSpeed | None, "Critical speed of forward whirl, the disk tilting [rad/s]."]
    backward_speed: Annotated[ShaftSpeed | None, "Critical speed of backward whirl, the disk tilting [rad/s]."]
    whirls: Annotated[tuple[FreeWhirl, ...] | None, "Free whirls at the speed given, the disk tilting."]
    criticals: Annotated[tuple[WhirlCritical, ...] | None, "Critical speeds of every order asked for."]
    campbell: Annotated[tuple[WhirlsAtSpeed, ...] | None, "Whirl frequencies over speed, up to the highest speed."]
    advice: tuple[Advice, ...] = ()


def whirl(
    *,
    mass: Annotated[Mass, "Mass of the disk, e.g. 30 kg."],
    shaft: Annotated[Known | Bar, "The shaft."],
    eccentricity: Annotated[Eccentricity | None, "Centre of mass off the shaft, for its whirl, e.g. 20 um."] = None,
    speed: Annotated[ShaftSpeed | None, "Speed of the shaft, for its whirl, e.g. 3000 rpm."] = None,
    damping_ratio: Annotated[DampingRatio, "External damping over critical damping, e.g. 0.02."] = 0.0,
    polar_inertia: Annotated[Inertia | None, "Of the disk about its axis, if it tilts, e.g. 0.5 kg*m^2."] = None,
    diametral_inertia: Annotated[Inertia | None, "Of the disk about a diameter, e.g. 0.25 kg*m^2."] = None,
    orders: Annotated[
        tuple[Positive, ...], "Excitations per turn that meet a whirl; of a disk that tilts 1 unless given, e.g. 1, 2."
    ] = (),
    highest_speed: Annotated[ShaftSpeed | None, "End of the Campbell diagram and its table, e.g. 6000 rpm."] = None,
) -> Whirl:
    """Critical speed and whirl of one disk on a flexible shaft with an eccentric mass.

    Equation
    --------
    Ω_c = √(k/m), amplitude e·r²/√((1 − r²)² + (2ζr)²); k = 3EIL/(a²b²) between bearings, 3EI/L³ overhung. A disk that
    tilts: det[[k₁₁ − mλ², k₁₂], [k₁₂, k₂₂ + I_pΩλ − I_dλ²]] = 0 for whirl at λ, backward where λ < 0; order h meets it
    at λ = ±hΩ.

    Returns
    -------
    Whirl
        Critical speed, amplitude, phase, bearing force, deflection; forward and backward whirl at the speed, critical
        speeds by order, the Campbell diagram.

    Raises
    ------
    InadmissibleError
        At the critical speed without damping, for negative damping, a disk off the shaft, or one inertia alone.

    References
    ----------
    Jeffcott, Phil. Mag. 37 (1919) 304; Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 13.6.

    Examples
    --------
    >>> made = whirl(mass=1.0, shaft=Known(1.0), eccentricity=1e-3, speed=2.0)
    >>> round(made.response, 9)
    1.333333333
    """
    require(mass > 0.0, "the mass of the disk is zero", code="no-mass")
    require_damping(damping_ratio, DampingRatio)
    stiffness, springs = stiffness_of(shaft)
    require(stiffness > 0.0, "the shaft has no stiffness", code="no-stiffness")
    critical = sqrt(stiffness / mass)
    require(speed is None or absolute(speed) > 0.0, "a shaft at rest does not whirl", code="at-rest")
    turning = None if speed is None else absolute(speed)
    ratio = None if turning is None else turning / critical
    response = lag = amplitude = force = None
    if turning is not None and eccentricity is not None:
        response, lag = _response(critical, turning, eccentricity, damping_ratio)
        amplitude, force = eccentricity * response, stiffness * eccentricity * response
    disk = _disk(mass, springs, polar_inertia, diametral_inertia)
    forward = backward = None
    if disk is not None:
        firsts = {way: place for place, way, mode in disk.criticals(1.0) if mode == 1}
        forward, backward = firsts["forward"], firsts["backward"]
    require(
        highest_speed is None or disk is not None,
        "without tilting the whirl is the same at every speed",
        code="missing",
        hint="give --polar-inertia and --diametral-inertia, or leave out --highest-speed",
    )
    peak = None
    if eccentricity is not None and damping_ratio > 0.0 and damping_ratio < NO_PEAK:
        peak = eccentricity / (2.0 * damping_ratio * sqrt(1.0 - damping_ratio * damping_ratio))
    return Whirl(
        critical_speed=critical,
        amplitude=amplitude,
        phase=lag,
        response=response,
        bearing_force=force,
        ratio=ratio,
        peak_amplitude=peak,
        static_deflection=STANDARD_GRAVITY * mass / stiffness,
        stiffness=stiffness,
        forward_speed=forward,
        backward_speed=backward,
        whirls=None if disk is None or turning is None else whirls_at(disk, turning),
        criticals=meetings(disk, critical, orders or (() if disk is None else (1.0,))) or None,
        campbell=None if disk is None or highest_speed is None else diagram(disk, highest_speed),
        advice=() if turning is None else _advice(turning / (critical if forward is None else forward)),
    )


def _response(critical: "Any", turning: "Any", eccentricity: "Any", damping_ratio: "Any") -> "tuple[Any, Any]":
    """Whirl over eccentricity at a speed, and its lag."""
    ratio = turning / critical
    gap = (critical - turning) * (critical + turning) / (critical * critical)
    require(
        damping_ratio + absolute(gap) > 0.0,
        "at its critical speed without damping the whirl grows, by {growth} in each turn",
        growth=(pi_beside(ratio) * eccentricity, Size),
        code="resonance",
        hint="give --damping-ratio",
    )
    size, lag = magnification(gap, ratio, damping_ratio)
    return ratio * ratio * size, lag


def stiffness_of(shaft: "Known | Bar") -> "tuple[Any, tuple[Any, Any, Any] | None]":
    """Stiffness at a disk that does not tilt; stiffness against shift and tilt, and their determinant, where known."""
    if isinstance(shaft, Known):
        return shaft.stiffness, None
    require(shaft.diameter > 0.0, "the diameter of the shaft is zero", code="section")
    require(shaft.length > 0.0, "the length of the shaft is zero", code="no-length")
    square = shaft.diameter * shaft.diameter
    bending = shaft.elastic_modulus * pi_beside(shaft.diameter) / 64.0 * square * square
    length = shaft.length
    if shaft.support == "overhung":
        area = length * length
        direct, tilting = 12.0 * bending / (area * length), 4.0 * bending / length
        determinant = 12.0 * bending * bending / (area * area)
    else:
        a = 0.5 * length if shaft.position is None else shaft.position
        b = length - a
        require(b > 0.0, "the disk at {a} lies beyond the second bearing at {l}", a=(a, Size), l=(length, Size),
                code="position", hint="--support overhung is a disk beyond a bearing")  # fmt: skip
        require(a > 0.0, "the disk lies at the bearing", code="position")
        direct = 3.0 * bending * (1.0 / (a * a * a) + 1.0 / (b * b * b))
        tilting = 3.0 * bending * length / (a * b)
        determinant = 9.0 * bending * bending * length * length / (a * a * a * b * b * b)
    return determinant / tilting, (direct, tilting, determinant)


def _disk(mass: "Any", springs: "tuple[Any, Any, Any] | None", polar: "Any", diametral: "Any") -> "TiltingDisk | None":
    """The disk with its tilting, where its inertias are given."""
    if polar is None and diametral is None:
        return None
    require(
        polar is not None and diametral is not None,
        "a disk that tilts needs both its inertias",
        code="missing",
        hint="give --polar-inertia and --diametral-inertia; a thin disk has half the polar one",
    )
    require(springs is not None, "tilting needs the shaft's size", code="missing",
            hint="give --diameter and --length instead of --stiffness")  # fmt: skip
    require(diametral > 0.0, "the diametral inertia is zero", code="no-inertia",
            hint="leave out both inertias for a disk that does not tilt")  # fmt: skip
    return TiltingDisk(mass, springs, polar, diametral)  # type: ignore[arg-type]


def _advice(ratio: "Any") -> "tuple[Advice, ...]":
    if not single(ratio) or absolute(ratio - 1.0) > MARGIN:
        return ()
    text = "the speed lies within 20 % of the critical speed: the whirl is as uncertain as the damping"
    return (Advice("near-critical", text, remedy="change the speed, or the stiffness of the shaft"),)
