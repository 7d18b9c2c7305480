"""Loads over time on several masses, motions of their base, and how far the masses move."""

from dynamics_cli.quantities import (
    Acceleration,
    AccelerationFormula,
    Annotated,
    Coordinate,
    Force,
    ForceFormula,
    Frequency,
    InputFile,
    LengthFormula,
    Size,
    Text,
    Time,
    VibrationSpeed,
)
from dynamics_cli.records import record


@record
class SineForce:
    """A sine force that begins at time 0."""

    force: Annotated[Force, "Amplitude of the force F·cos ωt, e.g. 500 N."]
    frequency: Annotated[Frequency, "Frequency of the sine, e.g. 12 Hz."]


@record
class ForceLaw:
    """A force as a formula."""

    force_law: Annotated[ForceFormula, "Force as a formula of t [s], its unit at its end, e.g. 200*exp(-5*t) N."]


@record
class SineBase:
    """A base that begins to shake at time 0."""

    base_acceleration: Annotated[Acceleration, "Amplitude of the acceleration of the base A·cos ωt, e.g. 0.5 g."]
    frequency: Annotated[Frequency, "Frequency of the sine, e.g. 12 Hz."]


@record
class BaseLaw:
    """The acceleration of the base as a formula."""

    base_law: Annotated[AccelerationFormula, "Acceleration of the base as a formula of t [s], e.g. 9*sin(40*t) m/s^2."]


@record
class SineMotion:
    """A base that begins to move by a sine at time 0."""

    base_amplitude: Annotated[Size, "Amplitude of the displacement of the base A·sin ωt, e.g. 2 mm."]
    frequency: Annotated[Frequency, "Frequency of the sine, e.g. 12 Hz."]


@record
class MotionLaw:
    """The displacement of the base as a formula."""

    base_motion: Annotated[
        LengthFormula, "Displacement of the base as a formula of t [s], from 0 before, e.g. 5*(1 - cos(40*t)) mm."
    ]


@record
class Recorded:
    """A recorded load."""

    file: Annotated[
        InputFile,
        "CSV with t[s] and F[N] (or kN, lbf), or of the base a[g] (or m/s^2) or x[mm] (or m, in), e.g. load.csv.",
    ]


@record
class Reach:
    """How far a coordinate moves."""

    name: Annotated[Text, "The coordinate."]
    displacement: Annotated[Coordinate, "Displacement, against a base that moves, that is largest in size [m]."]
    time: Annotated[Time, "When [s]."]
    velocity: Annotated[VibrationSpeed, "Velocity, likewise, that is largest in size [m/s]."]
    acceleration: Annotated[Acceleration, "Absolute acceleration that is largest in size [m/s^2]."]
    absolute: Annotated[Coordinate | None, "On a base that moves: displacement in space that is largest in size [m]."]
