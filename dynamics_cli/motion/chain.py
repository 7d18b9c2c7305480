"""The task `chain`: rods pinned to one another, let go."""

import math

from dynamics_cli.errors import require, worded
from dynamics_cli.motion.rods import Rods, chain_of, many
from dynamics_cli.motion.runs import APART, Runs
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Coordinate,
    Count,
    Force,
    Fraction,
    Frequency,
    Gravity,
    Inertia,
    Length,
    Mass,
    Text,
    Time,
    TurnRate,
)
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

# Rates times duration: more would take minutes.
LONGEST = 10000.0
KEPT = 1e-9
# Amplitudes whose motion is that of small oscillations to a few thousandths.
SMALL = 0.05
STILL = 1e-12
REGULAR = "holds to the end; no horizon in sight"


@record
class Instant:
    """The chain at one time."""

    time: Annotated[Time, "Time since the start [s]."]
    angles: Annotated[tuple[Angle, ...], "Angles of the rods from the downward vertical [rad]."]
    rates: Annotated[tuple[TurnRate, ...], "Angular velocities of the rods [rad/s]."]


@record
class RodState:
    """One rod at the end."""

    rod: Annotated[Count, "From the top [-]."]
    angle: Annotated[Angle, "Angle from the downward vertical [rad]."]
    rate: Annotated[TurnRate, "Angular velocity [rad/s]."]
    across: Annotated[Coordinate, "Its lower end from the upper pin, to the right [m]."]
    up: Annotated[Coordinate, "Its lower end from the upper pin, upwards [m]."]
    pin_force: Annotated[Force, "Force in the pin at its upper end [N]."]


@record
class Chain:
    """How a chain moves, and how long that can be known."""

    verdict: Annotated[Text, "Whether the answer holds to the end of the time asked for."]
    horizon: Annotated[Time | None, "Beyond it the answer means nothing; null where errors hardly grow [s]."]
    tenfold: Annotated[Time | None, "Time in which an error of the start grows tenfold, about [s]."]
    difference: Annotated[Angle, "Largest difference of two runs at different tolerances [rad]."]
    energy_error: Annotated[Fraction, "Largest change of the energy over that of the start above rest [-]."]
    top_force: Annotated[Force, "Largest force in the uppermost pin [N]."]
    frequencies: Annotated[
        tuple[Frequency, ...], "Frequencies of small oscillations about hanging, from the lowest [Hz]."
    ]
    angle: Annotated[Angle | None, "Angle of the lowest rod at the end; null past the horizon [rad]."]
    rate: Annotated[TurnRate | None, "Its angular velocity then [rad/s]."]
    across: Annotated[Coordinate | None, "Its lower end from the upper pin then, to the right [m]."]
    up: Annotated[Coordinate | None, "Its lower end from the upper pin then, upwards [m]."]
    rods: Annotated[tuple[RodState, ...] | None, "The rods at the end; null past the horizon."]
    motion: Annotated[tuple[Instant, ...], "The motion over time, up to the horizon."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def chain(
    *,
    lengths: Annotated[tuple[Length, ...], "Of the rods from the top, e.g. 0.5, 0.5 m."],
    masses: Annotated[tuple[Mass, ...], "Of the rods, one for all or one each; 0 for massless, e.g. 1, 2 kg."],
    angles: Annotated[
        tuple[Angle, ...], "From the downward vertical at the start, one for all or each, e.g. 30, -20 deg."
    ],
    duration: Annotated[Time, "How long, e.g. 2 s."],
    rates: Annotated[
        tuple[TurnRate, ...], "Angular velocities at the start; at rest by default, e.g. 0, 2 rad/s."
    ] = (),
    end_masses: Annotated[tuple[Mass, ...], "Points at the lower ends of the rods, e.g. 0, 3 kg."] = (),
    inertias: Annotated[
        tuple[Inertia, ...], "Central inertias; those of slender rods by default, e.g. 0.02, 0.04 kg*m^2."
    ] = (),
    count: Annotated[Count | None, "So many rods alike, where one length is given."] = None,
    steps: Annotated[Count, "Lines of the table after the start."] = 8,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Chain:
    """Rods hung on one another by pins, let go from any angles and rates: their motion, and how long it can be known.

    Equation
    --------
    Σ_j a_ij·[q̈_j·cos(q_i − q_j) + q̇_j²·sin(q_i − q_j)] + g·b_i·sin q_i = 0, b_i = m_i·l_i/2 + l_i·μ_i,
    a_ij = l_i·b_j for i < j, a_ii = I_i + m_i·l_i²/4 + l_i²·μ_i, μ_i the mass at and below the lower end of rod i.

    Returns
    -------
    Chain
        Angles and rates over time and at the end with pin forces, the horizon, the energy balance, and frequencies of
        small oscillations.

    Raises
    ------
    InadmissibleError
        When a rod has no mass and no mass at its end, lists do not go together, nothing would move, or the time is too
        long to be integrated.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 12.4 and 12.5; integrated by DOP853
    (Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I, Springer 1993, section II.10).

    Examples
    --------
    >>> made = chain(lengths=(1.0, 1.0), masses=(1.0,), angles=(1.5707963267948966,), duration=1.0, gravity=1.0)
    >>> round(made.rods[1].angle, 6)
    1.62861
    """
    require(steps >= 1, "a table of no steps shows nothing", code="steps", hint="give 1 or more")
    rods, start = let_go(lengths, masses, angles, duration, rates, end_masses, inertias, count, gravity)
    import numpy as np

    from dynamics_cli.motion.peaks import peaks

    runs = Runs(rods, start, duration)
    slowness, shapes = rods.oscillations()
    kept, tenfold, horizon = max(runs.energy_errors()), runs.growth.tenfold(), runs.horizon()
    end = None if runs.reached else _end(rods, runs.states[-1])
    checks = [Check("energy is kept", kept < KEPT, kept, KEPT), *_small(runs, slowness, shapes)]
    numerics = Numerics("DOP853, two tolerances", bounds=(ErrorBound("motion", runs.difference, relative=False),))
    return Chain(
        verdict=_verdict(runs, horizon),
        horizon=horizon,
        tenfold=tenfold,
        difference=runs.difference,
        energy_error=kept,
        top_force=float(peaks(np.array([[rods.pin_forces(state)[0] for state in runs.states]]))[0]),
        frequencies=tuple(1.0 / (2.0 * math.pi * slow) for slow in slowness),
        angle=end[-1].angle if end else None,
        rate=end[-1].rate if end else None,
        across=end[-1].across if end else None,
        up=end[-1].up if end else None,
        rods=end,
        motion=_motion(runs, steps),
        numerics=numerics,
        checks=tuple(checks),
        advice=_advice(runs),
    )


def let_go(
    lengths: "Sequence[float]", masses: "Sequence[float]", angles: "Sequence[float]", duration: float,
    rates: "Sequence[float]", end_masses: "Sequence[float]", inertias: "Sequence[float]", count: int | None,
    gravity: float, fastest: float | None = None,
) -> "tuple[Rods, list[float]]":  # fmt: skip
    """The rods, and their angles and rates at the start; of chains alike the fastest oscillation of one serves."""
    rods = chain_of(lengths, masses, end_masses, inertias, count, gravity)
    start = many(angles, rods.n, "angles", 0.0) + many(rates, rods.n, "rates", 0.0)
    require(duration > 0.0, "a time of {duration} is not above zero", duration=(duration, Time))
    still = all(abs(math.sin(q)) < STILL for q in start[: rods.n]) and not any(start[rods.n :])
    require(not still, "it is let go at rest in equilibrium: nothing moves", code="at-rest",
            hint="turn a rod away from the vertical, or give --rates")  # fmt: skip
    longest = LONGEST / rods.scale(start[: rods.n], start[rods.n :], fastest)
    require(duration <= longest, "{duration} are too many swings to follow", duration=(duration, Time),
            code="too-long", hint="give {longest} or less", longest=(longest, Time))  # fmt: skip
    return rods, start


def _verdict(runs: Runs, horizon: float | None) -> str:
    if horizon is None:
        return REGULAR
    if runs.reached:
        return str(worded("ends at the horizon, about {horizon:2}", horizon=(horizon, Time)))
    return str(worded("holds to the end; means nothing beyond about {horizon:2}", horizon=(horizon, Time)))


def _end(rods: Rods, state: "list[float]") -> "tuple[RodState, ...]":
    n = rods.n
    x, y = rods.joints(state[:n])
    forces = rods.pin_forces(state)
    return tuple(
        RodState(rod=i + 1, angle=state[i], rate=state[n + i], across=x[i + 1], up=y[i + 1], pin_force=forces[i])
        for i in range(n)
    )


def _motion(runs: Runs, steps: int) -> "tuple[Instant, ...]":
    """So many steps, as samples lie nearest; to the horizon where that is earlier."""
    last, n = len(runs.times) - 1, runs.rods.n
    places = sorted({round(last * k / steps) for k in range(steps + 1)})
    return tuple(
        Instant(time=runs.times[k], angles=tuple(runs.states[k][:n]), rates=tuple(runs.states[k][n:])) for k in places
    )


def _small(runs: Runs, slowness: "Sequence[float]", shapes: "Sequence[Sequence[float]]") -> "list[Check]":
    """Beside small oscillations, where it is small enough; what is left out grows as the cube, and with time."""
    rods, start = runs.rods, runs.states[0]
    n = rods.n
    parts = []
    for slow, shape in zip(slowness, shapes, strict=True):
        # shapes are of unit potential energy: Σ g·b·φ² = 1
        weights = [rods.gravity * b * value for b, value in zip(rods.b, shape, strict=True)]
        parts.append(
            (sum(w * q for w, q in zip(weights, start[:n], strict=True)),
            slow * sum(w * r for w, r in zip(weights, start[n:], strict=True)))
        )  # fmt: skip
    sizes = [math.hypot(*part) for part in parts]
    largest = max(sum(size * abs(shape[i]) for size, shape in zip(sizes, shapes, strict=True)) for i in range(n))
    tolerance = largest**3 * (1.0 + runs.times[-1] / min(slowness))
    if largest > SMALL or tolerance > 0.1 * largest:
        return []
    off = 0.0
    for time, state in zip(runs.times, runs.states, strict=True):
        turns = [time / slow for slow in slowness]
        swings = [p * math.cos(t) + v * math.sin(t) for (p, v), t in zip(parts, turns, strict=True)]
        for i in range(n):
            off = max(off, abs(state[i] - sum(s * shape[i] for s, shape in zip(swings, shapes, strict=True))))
    return [Check("as small oscillations", off <= tolerance, off, tolerance)]


def _advice(runs: Runs) -> "tuple[Advice, ...]":
    if not runs.reached:
        return ()
    message = worded(
        "after {horizon} two runs at different tolerances part by {apart}: what follows is one motion of many",
        horizon=(runs.times[-1], Time), apart=(APART, Angle),
    )  # fmt: skip
    remedy = worded("ask for {horizon} or less", horizon=(runs.times[-1], Time))
    return (Advice("past-horizon", message, "serious", result="rods", remedy=remedy),)
