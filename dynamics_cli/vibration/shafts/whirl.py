"""A disk on a flexible shaft: critical speed, whirl, bearing force; gyroscopic splitting of a disk that tilts."""

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
    Pressure,
    Ratio,
    ShaftSpeed,
    Size,
    SpringRate,
)
from dynamics_cli.records import Advice, Choice, record
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
    amplitude: Annotated[Size, "Whirl of the middle of the shaft at the speed given [m]."]
    phase: Annotated[Angle, "By how much it lags the centre of mass [rad]."]
    response: Annotated[Ratio, "Amplitude over eccentricity, r²·H [-]."]
    bearing_force: Annotated[Force, "Rotating force that bends the shaft, on both bearings together [N]."]
    ratio: Annotated[Ratio, "Speed over critical speed r [-]."]
    peak_amplitude: Annotated[Size | None, "Largest whirl while passing the critical speed slowly [m]."]
    static_deflection: Annotated[Size, "Deflection of a horizontal shaft under the weight [m]."]
    stiffness: Annotated[SpringRate, "Stiffness of the shaft at the disk [N/m]."]
    forward_speed: Annotated[ShaftSpeed | None, "Critical speed of forward whirl, the disk tilting [rad/s]."]
    backward_speed: Annotated[ShaftSpeed | None, "Critical speed of backward whirl, the disk tilting [rad/s]."]
    advice: tuple[Advice, ...] = ()


def whirl(
    *,
    mass: Annotated[Mass, "Mass of the disk, e.g. 30 kg."],
    shaft: Annotated[Known | Bar, "The shaft."],
    eccentricity: Annotated[Eccentricity, "Centre of mass off the shaft, e.g. 20 um."],
    speed: Annotated[ShaftSpeed, "Speed of the shaft, e.g. 3000 rpm."],
    damping_ratio: Annotated[DampingRatio, "External damping over critical damping, e.g. 0.02."] = 0.0,
    polar_inertia: Annotated[Inertia | None, "Of the disk about its axis, if it tilts, e.g. 0.5 kg*m^2."] = None,
    diametral_inertia: Annotated[Inertia | None, "Of the disk about a diameter, e.g. 0.25 kg*m^2."] = None,
) -> Whirl:
    """Critical speed and whirl of one disk on a flexible shaft with an eccentric mass.

    Equation
    --------
    Ω_c = √(k/m), amplitude e·r²/√((1 − r²)² + (2ζr)²); k = 3EIL/(a²b²) between bearings, 3EI/L³ overhung. A disk that
    tilts: det[[k₁₁ − mΩ², k₁₂], [k₁₂, k₂₂ − (I_d ∓ I_p)Ω²]] = 0 for forward and backward whirl at the speed itself.

    Returns
    -------
    Whirl
        Critical speed, amplitude, phase, bearing force, deflection; forward and backward critical speeds.

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
    stiffness, across, tilting = _stiffness(shaft)
    require(stiffness > 0.0, "the shaft has no stiffness", code="no-stiffness")
    critical = sqrt(stiffness / mass)
    turning = absolute(speed)
    require(turning > 0.0, "a shaft at rest does not whirl", code="at-rest")
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
    response = ratio * ratio * size
    forward, backward = _tilting(mass, stiffness, across, tilting, polar_inertia, diametral_inertia)
    peaks = damping_ratio > 0.0 and damping_ratio < NO_PEAK
    square = damping_ratio * damping_ratio
    return Whirl(
        critical_speed=critical,
        amplitude=eccentricity * response,
        phase=lag,
        response=response,
        bearing_force=stiffness * eccentricity * response,
        ratio=ratio,
        peak_amplitude=eccentricity / (2.0 * damping_ratio * sqrt(1.0 - square)) if peaks else None,
        static_deflection=STANDARD_GRAVITY * mass / stiffness,
        stiffness=stiffness,
        forward_speed=forward,
        backward_speed=backward,
        advice=_advice(ratio),
    )


def _stiffness(shaft: "Known | Bar") -> "tuple[Any, Any, Any]":
    """Stiffness at the disk against displacement, the coupling with tilt, and against tilt; None where not known."""
    if isinstance(shaft, Known):
        return shaft.stiffness, None, None
    require(shaft.diameter > 0.0, "the diameter of the shaft is zero", code="section")
    require(shaft.length > 0.0, "the length of the shaft is zero", code="no-length")
    square = shaft.diameter * shaft.diameter
    bending = shaft.elastic_modulus * pi_beside(shaft.diameter) / 64.0 * square * square
    length = shaft.length
    if shaft.support == "overhung":
        cube = length * length * length
        return 3.0 * bending / cube, 6.0 * bending / (length * length), 4.0 * bending / length
    a = 0.5 * length if shaft.position is None else shaft.position
    b = length - a
    require(b > 0.0, "the disk at {a} lies beyond the second bearing at {l}", a=(a, Size), l=(length, Size),
            code="position", hint="--support overhung is a disk beyond a bearing")  # fmt: skip
    require(a > 0.0, "the disk lies at the bearing", code="position")
    cubes = 3.0 * bending * (1.0 / (a * a * a) + 1.0 / (b * b * b))
    return (
        3.0 * bending * length / (a * a * b * b),
        (cubes, 3.0 * bending * (1.0 / (a * a) - 1.0 / (b * b))),
        3.0 * bending * (1.0 / a + 1.0 / b),
    )


def _tilting(
    mass: "Any", stiffness: "Any", across: "Any", tilting: "Any", polar: "Any", diametral: "Any"
) -> "tuple[Any, Any]":
    """Critical speeds of synchronous forward and backward whirl of a disk that tilts."""
    if polar is None and diametral is None:
        return None, None
    require(
        polar is not None and diametral is not None,
        "a disk that tilts needs both its inertias",
        code="missing",
        hint="give --polar-inertia and --diametral-inertia; a thin disk has half the polar one",
    )
    require(tilting is not None, "tilting needs the shaft's size", code="missing",
            hint="give --diameter and --length instead of --stiffness")  # fmt: skip
    if isinstance(across, tuple):
        direct, cross = across
    else:
        direct, cross = 4.0 * stiffness, across
    made = []
    for sign in (-1.0, 1.0):
        moment = diametral + sign * polar
        # m·M·x² − (k₁₁·M + k₂₂·m)·x + k₁₁·k₂₂ − k₁₂² = 0, x = Ω²
        left = direct * tilting - cross * cross
        middle = direct * moment + tilting * mass
        root = sqrt(middle * middle - 4.0 * mass * moment * left)
        made.append(sqrt(2.0 * left / (middle + root)))
    return made[0], made[1]


def _advice(ratio: "Any") -> "tuple[Advice, ...]":
    if not single(ratio) or absolute(ratio - 1.0) > MARGIN:
        return ()
    text = "the speed lies within 20 % of the critical speed: the whirl is as uncertain as the damping"
    return (Advice("near-critical", text, remedy="change the speed, or the stiffness of the shaft"),)
