"""The task `modes`: small oscillations of a hanging chain."""

import math

from dynamics_cli.motion.rods import chain_of
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    AngularRate,
    Annotated,
    Count,
    Frequency,
    Gravity,
    Inertia,
    Length,
    Mass,
    Ratio,
    Time,
)
from dynamics_cli.records import Check, Numerics, record

SAME = 1e-13


@record
class ChainMode:
    """One mode."""

    number: Annotated[Count, "From the slowest [-]."]
    frequency: Annotated[Frequency, "Natural frequency [Hz]."]
    angular_frequency: Annotated[AngularRate, "That in radians [rad/s]."]
    period: Annotated[Time, "Time of one oscillation [s]."]
    shape: Annotated[tuple[Ratio, ...], "Angles of the rods, the largest 1 [-]."]
    ends: Annotated[tuple[Ratio, ...], "Sideways motion of the lower ends, the largest 1 [-]."]


@record
class ChainModes:
    """The small oscillations of a chain."""

    slowest: Annotated[Frequency, "Lowest frequency [Hz]."]
    fastest: Annotated[Frequency, "Highest frequency [Hz]."]
    modes: Annotated[tuple[ChainMode, ...], "The modes from the slowest."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()


def modes(
    *,
    lengths: Annotated[tuple[Length, ...], "Of the rods from the top, e.g. 0.5, 0.5 m."],
    masses: Annotated[tuple[Mass, ...], "Of the rods, one for all or one each; 0 for massless, e.g. 1, 2 kg."],
    end_masses: Annotated[tuple[Mass, ...], "Points at the lower ends of the rods, e.g. 0, 3 kg."] = (),
    inertias: Annotated[tuple[Inertia, ...], "Central inertias; those of slender rods by default."] = (),
    count: Annotated[Count | None, "So many rods alike, where one length is given."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> ChainModes:
    """Small oscillations of a chain of rods about hanging at rest: frequencies and shapes.

    Equation
    --------
    (g·diag b − ω²·A)·φ = 0; 1/ω are the singular values of √m·B·(g·b)^(−½), B the partial velocities of the masses.

    Returns
    -------
    ChainModes
        Frequencies and periods from the slowest, with the angles of the rods and the sideways motion of their ends.

    Raises
    ------
    InadmissibleError
        When a rod has no mass and no mass at its end, or lists do not go together.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 12.5 and 13.8; one-sided Jacobi of
    Drmač & Veselić, SIAM J. Matrix Anal. Appl. 29 (2008) 1322.

    Examples
    --------
    >>> made = modes(lengths=(1.0, 1.0), masses=(1.0,), gravity=1.0)
    >>> round(made.modes[0].angular_frequency ** 2, 6)
    0.732213
    """
    rods = chain_of(lengths, masses, end_masses, inertias, count, gravity)
    slowness, shapes = rods.oscillations()
    found = []
    for number, (slow, shape) in enumerate(zip(slowness, shapes, strict=True), 1):
        ends = [0.0]
        for length, angle in zip(rods.lengths, shape, strict=True):
            ends.append(ends[-1] + length * angle)
        hertz = 1.0 / (2.0 * math.pi * slow)
        found.append(
            ChainMode(number=number, frequency=hertz, angular_frequency=1.0 / slow, period=2.0 * math.pi * slow,
            shape=_scaled(shape), ends=_scaled(ends[1:]))
        )  # fmt: skip
    # the sum of 1/ω² is a trace
    trace = math.fsum(rods.a[i][i] / (gravity * rods.b[i]) for i in range(rods.n))
    off = abs(math.fsum(slow * slow for slow in slowness) / trace - 1.0)
    return ChainModes(
        slowest=found[0].frequency,
        fastest=found[-1].frequency,
        modes=tuple(found),
        numerics=Numerics("one-sided Jacobi on the factor of the mass matrix"),
        checks=(Check("sum of 1/ω² is the trace", off < SAME, off, SAME),),
    )


def _scaled(shape: "list[float]") -> "tuple[float, ...]":
    largest = max(shape, key=abs)
    return tuple(value / largest for value in shape)
