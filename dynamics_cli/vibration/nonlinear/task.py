"""Nonlinear oscillators: Krylov–Bogoliuboff amplitude and frequency beside what integration gives."""

import math

from dynamics_cli.errors import require, worded
from dynamics_cli.quantities import Angle, Annotated, Count, Fraction, Frequency, Positive, Ratio, Text, Time
from dynamics_cli.records import Advice, Numerics, record, tagged
from dynamics_cli.sampling import drawing
from dynamics_cli.vibration.single.oscillator import require_damping

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Law = Callable[[float, float], float]

MOST_CYCLES, MOST_MU = 1000, 200.0
# Differences of two tolerances beyond this are reported.
ROUGH = 1e-6
WIDE = 0.05


@tagged("law")
@record
class Pendulum:
    """A pendulum."""

    swing: Annotated[Angle, "Largest angle from the vertical, e.g. 90 deg."]


@tagged("law")
@record
class Duffing:
    """A spring that hardens or softens: ẍ + x + α·x³ = 0."""

    cubic: Annotated[Ratio, "α: cubic part of the spring over its linear part at x = 1; negative softens, e.g. 0.1."]
    amplitude: Annotated[Positive, "Amplitude in that unit of x, e.g. 1."] = 1.0


@tagged("law")
@record
class ForcedDuffing:
    """The same with damping under a force F·cos Ωt."""

    cubic: Annotated[Ratio, "α: cubic part of the spring over its linear part at x = 1; negative softens, e.g. 0.1."]
    damping_ratio: Annotated[Ratio, "Damping over critical damping, e.g. 0.02."]
    force: Annotated[Positive, "Static deflection of the force in that unit of x, e.g. 0.2."]
    frequency_ratio: Annotated[Positive, "Frequency of the force over the linear natural one, e.g. 1.6."]


@tagged("law")
@record
class VanDerPol:
    """Self-excited: ẍ − μ(1 − x²)ẋ + x = 0."""

    mu: Annotated[Positive, "μ, e.g. 1."]


@tagged("law")
@record
class QuadraticDamping:
    """Damping by the square of the velocity: ẍ + c·|ẋ|ẋ + x = 0."""

    coefficient: Annotated[Positive, "c in that unit of x, e.g. 0.1."]
    amplitude: Annotated[Positive, "Amplitude in that unit of x, e.g. 1."] = 1.0
    cycles: Annotated[Count, "After how many cycles the amplitude is asked for."] = 5


@tagged("law")
@record
class Custom:
    """Any law: ẍ + x + f(x, v) = 0."""

    function: Annotated[Text, "f of displacement x and velocity v, e.g. 0.05*v*abs(v) + 0.1*x^3."]
    amplitude: Annotated[Positive, "Amplitude in that unit of x, e.g. 1."] = 1.0
    cycles: Annotated[Count, "After how many cycles the amplitude is asked for."] = 5


@record
class Branch:
    """A steady amplitude under the force."""

    amplitude: Annotated[Ratio, "By averaging (harmonic balance) [-]."]
    true_amplitude: Annotated[Ratio | None, "First harmonic of the integrated cycle [-]."]
    error: Annotated[Fraction | None, "The first over the second, less one; signs left out [-]."]
    stable: Annotated[bool, "Whether the motion stays on it [-]."]


@record
class Nonlinear:
    """Averaging beside the truth."""

    averaged_frequency: Annotated[Ratio | None, "Frequency over the linear one, by Krylov and Bogoliuboff [-]."]
    true_frequency: Annotated[Ratio | None, "Frequency over the linear one, integrated or closed [-]."]
    frequency_error: Annotated[Fraction | None, "How far averaging is off [-]."]
    averaged_amplitude: Annotated[Ratio | None, "Amplitude by averaging: of the cycle, or after the cycles [-]."]
    true_amplitude: Annotated[Ratio | None, "The same, integrated [-]."]
    amplitude_error: Annotated[Fraction | None, "How far averaging is off [-]."]
    period: Annotated[Ratio | None, "Period in radians of the linear vibration, 2π for small amplitudes [-]."]
    true_period: Annotated[Time | None, "Period, beside a natural frequency [s]."]
    branches: Annotated[tuple[Branch, ...] | None, "Steady amplitudes under the force, the smallest first."]
    jumps: Annotated[tuple[Ratio, ...] | None, "Frequency ratios at which the amplitude jumps, by averaging [-]."]
    rising_jump: Annotated[Ratio | None, "Where it jumps while the frequency rises, over the linear one [-]."] = None
    falling_jump: Annotated[Ratio | None, "Where it jumps while the frequency falls, over the linear one [-]."] = None
    large_amplitude: Annotated[Ratio | None, "Largest stable amplitude under the force, by averaging [-]."] = None
    small_amplitude: Annotated[Ratio | None, "The other stable amplitude, by averaging [-]."] = None
    numerics: Numerics | None = None
    advice: tuple[Advice, ...] = ()


def nonlinear(
    *,
    oscillator: Annotated[
        Pendulum | Duffing | ForcedDuffing | VanDerPol | QuadraticDamping | Custom,
        "The oscillator; time counts in 1/ω.",
    ],
    natural_frequency: Annotated[
        Frequency | None, "Linear natural frequency, for periods in seconds, e.g. 2 Hz."
    ] = None,
) -> Nonlinear:
    """Amplitude and frequency of a nonlinear oscillator by Krylov and Bogoliuboff, and what integration gives.

    Equation
    --------
    ẍ + x + f(x, ẋ) = 0, x = a·sin ψ: ȧ = −(1/2π)∮f·cos ψ dψ, ψ̇ = 1 + (1/2πa)∮f·sin ψ dψ; Duffing's true frequency is
    M(√(1 + αa²), √(1 + ½αa²)), the pendulum's M(1, cos ½θ), with M the arithmetic–geometric mean.

    Returns
    -------
    Nonlinear
        Frequency and amplitude both ways, their difference; branches, stability and jumps under a force.

    Raises
    ------
    InadmissibleError
        When the spring pushes away within the amplitude, the pendulum stands on its head, damping is negative, or the
        motion does not come back.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 13.9 and 13.10; Krylov & Bogoliuboff,
    Introduction to Non-Linear Mechanics, Princeton 1947.

    Examples
    --------
    >>> answer = nonlinear(oscillator=Duffing(0.1))
    >>> round(answer.averaged_frequency, 9), round(answer.true_frequency, 9)
    (1.0375, 1.036716907)
    """
    require(natural_frequency is None or natural_frequency > 0.0, "the natural frequency is zero", code="no-stiffness")
    if isinstance(oscillator, ForcedDuffing):
        return _forced(oscillator)
    if isinstance(oscillator, QuadraticDamping | Custom):
        return _decaying(oscillator)
    if isinstance(oscillator, VanDerPol):
        return _van_der_pol(oscillator.mu, natural_frequency)
    from dynamics_cli.numerics.elliptic import mean

    if isinstance(oscillator, Pendulum):
        swing = abs(oscillator.swing)
        require(swing < math.pi, "at {swing} the pendulum stands on its head", swing=(swing, Angle), code="at-top",
                hint="give an angle below 180 deg")  # fmt: skip
        # cos ½θ without its cancellation near the top
        true, averaged = mean(1.0, math.sin(0.5 * (math.pi - swing))), 1.0 - swing * swing / 16.0
    else:
        share = oscillator.cubic * oscillator.amplitude**2
        require(
            share > -1.0,
            "with α·a² = {share} the spring pushes away within the amplitude: the motion does not come back",
            share=(share, Ratio),
            code="no-return",
            hint="a softening spring swings below a = 1/√(−α)",
        )
        true, averaged = mean(math.sqrt(1.0 + share), math.sqrt(1.0 + 0.5 * share)), 1.0 + 0.375 * share
    return _answer(averaged, true, natural_frequency, method="arithmetic–geometric mean")


def _answer(
    averaged: float, true: float, natural: "float | None", amplitudes: "tuple[float, float] | None" = None,
    method: str = "", rough: float = 0.0,
) -> Nonlinear:  # fmt: skip
    """Both ways side by side."""
    off = abs(averaged / true - 1.0)
    a, b = amplitudes or (None, None)
    drift = None if a is None or not b else abs(a / b - 1.0)
    notes = []
    if max(off, drift or 0.0) > WIDE:
        text = "averaging is {off} off here: use the integrated values"
        notes.append(Advice("averaging", worded(text, off=(max(off, drift or 0.0), Fraction))))
    if rough > ROUGH:
        notes.append(Advice("tolerance", worded("two tolerances differ by {rough}", rough=(rough, Ratio))))
    period = 2.0 * math.pi / true
    return Nonlinear(
        averaged_frequency=averaged,
        true_frequency=true,
        frequency_error=off,
        averaged_amplitude=a,
        true_amplitude=b,
        amplitude_error=drift,
        period=period,
        true_period=None if natural is None else 1.0 / (true * natural),
        branches=None,
        jumps=None,
        numerics=Numerics(method),
        advice=tuple(notes),
    )


def law_of(oscillator: "Any") -> "Law":
    """F of ẍ + x + f(x, ẋ) = 0."""
    if isinstance(oscillator, VanDerPol):
        mu = oscillator.mu
        return lambda x, v: -mu * (1.0 - x * x) * v
    if isinstance(oscillator, QuadraticDamping):
        c = oscillator.coefficient
        return lambda x, v: c * abs(v) * v
    if isinstance(oscillator, Pendulum):
        return lambda x, v: math.sin(x) - x
    if isinstance(oscillator, Duffing):
        cubic = oscillator.cubic
        return lambda x, v: cubic * x * x * x
    from dynamics_cli.numerics.expressions import parse

    read = parse(oscillator.function, {"x", "v"})
    return lambda x, v: float(read(x=x, v=v))


def _van_der_pol(mu: float, natural: "float | None") -> Nonlinear:
    from dynamics_cli.vibration.nonlinear.truth import LOOSER, STIFF, TOLERANCE, limit_cycle

    require(mu <= MOST_MU, "μ = {mu} is beyond {most}: use its relaxation limit, period (3 − 2·ln 2)·μ",
            mu=(mu, Ratio), most=(MOST_MU, Ratio), code="too-stiff")  # fmt: skip
    f = law_of(VanDerPol(mu))

    def jacobian(_: float, y: "Any") -> "list[list[float]]":
        return [[0.0, 1.0], [-1.0 - 2.0 * mu * y[0] * y[1], mu * (1.0 - y[0] * y[0])]]

    stiff = jacobian if mu > STIFF else None
    fine = 1e-11 if stiff else TOLERANCE
    amplitude, period = limit_cycle(f, 2.0, stiff, fine)
    _, other = limit_cycle(f, 2.0, stiff, 1e-9 if stiff else LOOSER)
    rough = abs(other / period - 1.0)
    method = f"half-cycle map by {'Radau' if stiff else 'DOP853'}; two tolerances differ by {rough:.1e}"
    return _answer(1.0, 2.0 * math.pi / period, natural, (2.0, amplitude), method, rough)


def _decaying(oscillator: "QuadraticDamping | Custom") -> Nonlinear:
    from dynamics_cli.vibration.nonlinear.averaging import after
    from dynamics_cli.vibration.nonlinear.truth import LOOSER, TOLERANCE, after_cycles

    cycles, a = oscillator.cycles, oscillator.amplitude
    require(1 <= cycles <= MOST_CYCLES, "{n} cycles: give 1 to {most}", n=str(cycles), most=str(MOST_CYCLES),
            code="cycles")  # fmt: skip
    f = law_of(oscillator)
    true, time = after_cycles(f, a, cycles, TOLERANCE)
    other = true if drawing() else after_cycles(f, a, cycles, LOOSER)[0]
    rough = abs(other - true) / a
    averaged, phase = after(f, a, time)
    method = f"averaged and full equations by DOP853; two tolerances differ by {rough:.1e}"
    return _answer(phase / time, 2.0 * math.pi * cycles / time, None, (averaged, true), method, rough)


def _forced(given: ForcedDuffing) -> Nonlinear:
    from dynamics_cli.vibration.nonlinear.truth import Forced, balance_roots, jumps

    require_damping(given.damping_ratio, Ratio)
    require(given.damping_ratio > 0.0, "without damping the branches have no end", code="undamped",
            hint="give --damping-ratio, for example 0.02")  # fmt: skip
    numbers = given.damping_ratio, given.cubic, given.force, given.frequency_ratio
    omega = given.frequency_ratio
    amplitudes = balance_roots(*numbers)
    full = None if drawing() else Forced(*numbers)
    rows = []
    for nth, a in enumerate(amplitudes):
        if 1.0 + given.cubic * a * a <= 0.0:
            continue
        lag = math.atan2(2.0 * given.damping_ratio * omega, (1.0 - omega) * (1.0 + omega) + 0.75 * given.cubic * a * a)
        stable = len(amplitudes) == 1 or nth != 1
        cycle = full and full.cycle(a, lag)
        true = None if not cycle or cycle[2] != stable or abs(cycle[0] / a - 1.0) > 0.5 else cycle[0]
        rows.append(Branch(a, true, None if true is None else abs(a / true - 1.0), stable))
    require(bool(rows), "every amplitude lies where the softening spring pushes away", code="no-return",
            hint="give a smaller force")  # fmt: skip
    top = 3.0 * max(omega, 1.0, math.sqrt(1.0 + 0.75 * abs(given.cubic) * max(amplitudes) ** 2))
    notes = [Advice("averaging", "an amplitude is of the first harmonic; the motion has others", severity="note")]
    if len(rows) > 1:
        notes.append(Advice("several", "which stable amplitude comes depends on how the force began"))
    if len(rows) < len(amplitudes):
        notes.append(Advice("pushed-away", "amplitudes at which the spring pushes away are left out", severity="note"))
    if any(row.true_amplitude is None for row in rows):
        notes.append(Advice("not-followed", "no true cycle lies near to one of the averaged amplitudes"))
    held = [row.amplitude for row in rows if row.stable]
    places = jumps(given.damping_ratio, given.cubic, given.force, top)
    # a soft spring has a fold below these too, of amplitudes that no sweep of the frequency leads to
    falling, rising = places[-2:] if len(places) > 1 else (None, None)
    return Nonlinear(
        averaged_frequency=None, true_frequency=None, frequency_error=None, averaged_amplitude=None,
        true_amplitude=None, amplitude_error=None, period=None, true_period=None, branches=tuple(rows),
        jumps=tuple(place for place in places if place is not None), rising_jump=rising, falling_jump=falling,
        large_amplitude=max(held, default=None), small_amplitude=min(held) if len(held) > 1 else None,
        numerics=Numerics("harmonic balance; true cycles by shooting with DOP853"), advice=tuple(notes),
    )  # fmt: skip
