"""What a user gives of bearings and unbalances, and what a rotor answers."""

from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Force,
    Frequency,
    Ratio,
    ShaftSpeed,
    Size,
    SpringRate,
    Text,
    TorsionStiffness,
    ViscousDamping,
)
from dynamics_cli.quantities import Unbalance as Imbalance
from dynamics_cli.records import Advice, record


@record
class Bearing:
    """A bearing by its coefficients, x horizontal and y vertical; rigid without kxx."""

    position: Annotated[Size, "From the left end, e.g. 50 mm."]
    kxx: Annotated[SpringRate | None, "Stiffness, horizontal; rigid unless given, e.g. 80 kN/mm."] = None
    kyy: Annotated[SpringRate | None, "Vertical; as kxx unless given, e.g. 120 kN/mm."] = None
    cxx: Annotated[ViscousDamping, "Damping, horizontal, e.g. 40 kN*s/m."] = 0.0
    cyy: Annotated[ViscousDamping | None, "Vertical; as cxx unless given, e.g. 60 kN*s/m."] = None
    kxy: Annotated[SpringRate, "Horizontal force per vertical deflection, e.g. 20 kN/mm."] = 0.0
    kyx: Annotated[SpringRate, "Vertical force per horizontal deflection, e.g. -20 kN/mm."] = 0.0
    cxy: Annotated[ViscousDamping, "Horizontal force per vertical speed, e.g. 5 kN*s/m."] = 0.0
    cyx: Annotated[ViscousDamping, "Vertical force per horizontal speed, e.g. 5 kN*s/m."] = 0.0
    swirl: Annotated[Ratio, "Speed of the oil film over that of the shaft, where it drives whirl, e.g. 0.48."] = 0.0
    tilting: Annotated[TorsionStiffness, "Stiffness against tilting of the shaft, e.g. 5000 N*m/rad."] = 0.0


@record
class Unbalance:
    """An unbalance in one plane."""

    position: Annotated[Size, "From the left end, e.g. 300 mm."]
    unbalance: Annotated[Imbalance, "Mass times radius, e.g. 500 g*mm."]
    angle: Annotated[Angle, "From the mark on the shaft, with the rotation, e.g. 90 deg."] = 0.0


@record
class RotorMode:
    """A free whirl."""

    frequency: Annotated[Frequency, "Its frequency [Hz]."]
    decrement: Annotated[Ratio, "Logarithmic decrement; below zero it grows [-]."]
    whirl: Annotated[Text, "forward, backward, mixed along the shaft, or in a line."]


@record
class RotorModes:
    """Free whirls at one speed."""

    speed: Annotated[ShaftSpeed, "Speed of the shaft [rad/s]."]
    frequencies: Annotated[tuple[Frequency, ...], "Frequencies from the lowest [Hz]."]
    decrements: Annotated[tuple[Ratio, ...], "Their logarithmic decrements [-]."]


@record
class RotorCritical:
    """A speed at which unbalance meets a whirl without damping."""

    speed: Annotated[ShaftSpeed, "Speed of the shaft [rad/s]."]
    whirl: Annotated[Text, "forward, backward, mixed along the shaft, or in a line."]


@record
class RotorOrbit:
    """The orbit of one place at one speed."""

    position: Annotated[Size, "From the left end [m]."]
    speed: Annotated[ShaftSpeed, "Speed of the shaft [rad/s]."]
    horizontal: Annotated[Size, "Amplitude [m]."]
    horizontal_lag: Annotated[Angle, "By how much it lags the mark in passing that direction [rad]."]
    vertical: Annotated[Size, "Amplitude [m]."]
    vertical_lag: Annotated[Angle, "By how much it lags the mark in passing that direction [rad]."]
    major: Annotated[Size, "Long half axis of the orbit [m]."]
    minor: Annotated[Size, "Short half axis [m]."]
    whirl: Annotated[Text, "forward, backward or in a line."]


@record
class RotatingLoad:
    """What the unbalances do to a bearing."""

    position: Annotated[Size, "From the left end [m]."]
    horizontal: Annotated[Force, "Amplitude of the force on it [N]."]
    vertical: Annotated[Force, "Amplitude of the force on it [N]."]


@record
class RotorResponse:
    """Response and stability of a rotor."""

    onset: Annotated[ShaftSpeed | None, "Lowest speed at which a whirl grows by itself [rad/s]."]
    stable_to: Annotated[ShaftSpeed | None, "End of the range, if no whirl grows below it [rad/s]."]
    onset_frequency: Annotated[Frequency | None, "Frequency of that whirl [Hz]."]
    critical_speed: Annotated[ShaftSpeed | None, "First peak of the response, at any place read [rad/s]."]
    amplitude: Annotated[Size | None, "Largest long half axis of the places read, at the running speed [m]."]
    force: Annotated[Force | None, "Largest amplitude of the force on a bearing, either way, at the running speed [N]."]
    margin: Annotated[Ratio | None, "Running speed over the nearest peak [-]."]
    decrement: Annotated[Ratio | None, "Least logarithmic decrement at the running speed [-]."]
    modes: Annotated[tuple[RotorMode, ...] | None, "Free whirls at the running speed."]
    orbits: Annotated[tuple[RotorOrbit, ...] | None, "Places read, at the running speed."]
    loads: Annotated[tuple[RotatingLoad, ...] | None, "Rotating forces on the bearings, at the running speed."]
    peaks: Annotated[tuple[RotorOrbit, ...] | None, "Peaks of the long half axis, at each place read."]
    criticals: Annotated[tuple[RotorCritical, ...], "Where unbalance meets whirls, without damping."]
    over_speed: Annotated[tuple[RotorOrbit, ...] | None, "Places read, over speed."]
    campbell: Annotated[tuple[RotorModes, ...], "Free whirls over speed."]
    advice: tuple[Advice, ...] = ()
