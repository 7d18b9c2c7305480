"""The tuned absorber: Den Hartog's tuning, the one of least peak, and the peaks that really result."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import hypot, sqrt
from dynamics_cli.numerics.number import is_array, plain
from dynamics_cli.numerics.roots import sign_change
from dynamics_cli.quantities import (
    Annotated,
    DampingRatio,
    Frequency,
    Mass,
    Positive,
    Ratio,
    SpringRate,
    ViscousDamping,
)
from dynamics_cli.records import Choice, record
from dynamics_cli.vibration.single.oscillator import require_damping

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any


class Tuning(Choice):
    """How the absorber is tuned."""

    names = ("den-hartog", "minimax")
    aliases = {"optimal": "minimax", "h-infinity": "minimax"}  # noqa: RUF012


DEN_HARTOG = Tuning("den-hartog")
# Looks for the valley between the peaks: a factor (high/low)^(1/256) apart, over one and a half times that range.
HALVED_STEPS, LOOKS = 8, 384
# A peak to this relative width is exact after one step of Newton.
NEAR = 1e-9
# Values that stay in the processor's cache.
BLOCK = 4096


@record
class MassRatio:
    """The absorber by its share."""

    mass_ratio: Annotated[Positive, "Mass of the absorber over that of the machine, e.g. 0.05."]


@record
class Masses:
    """The absorber by its mass."""

    mass: Annotated[Mass, "Mass of the machine, e.g. 200 kg."]
    absorber_mass: Annotated[Mass, "Mass of the absorber, e.g. 10 kg."]


@record
class ChosenTuning:
    """A tuning as wanted."""

    frequency_ratio: Annotated[Positive, "Frequency of the absorber alone over that of the machine, e.g. 0.95."]
    damping_ratio: Annotated[DampingRatio, "Damping over critical damping of the absorber alone, e.g. 0.13."]


@record
class RuleTuning:
    """A tuning by rule."""

    tuning: Annotated[Tuning, "den-hartog: equal fixed points; minimax: the least peak."] = DEN_HARTOG


BY_RULE = RuleTuning()


@record
class Absorber:
    """A tuned absorber."""

    frequency_ratio: Annotated[Ratio, "Frequency of the absorber alone over that of the machine [-]."]
    damping_ratio: Annotated[DampingRatio, "Damping c over 2·m_a·ω_a, of the absorber alone [-]."]
    damping_by_machine: Annotated[DampingRatio, "Damping c over 2·m_a·ω_machine, as Den Hartog counts [-]."]
    lower_peak: Annotated[Ratio, "First peak of the machine, amplitude over F/k [-]."]
    lower_ratio: Annotated[Ratio, "Where it lies, over the machine's frequency [-]."]
    upper_peak: Annotated[Ratio, "Second peak [-]."]
    upper_ratio: Annotated[Ratio, "Where it lies [-]."]
    fixed_point: Annotated[Ratio, "Height of the fixed points of that rule, √(1 + 2/μ) [-]."]
    frequency: Annotated[Frequency | None, "Frequency of the absorber alone [Hz]."]
    absorber_mass: Annotated[Mass | None, "Mass of the absorber [kg]."]
    stiffness: Annotated[SpringRate | None, "Its spring [N/m]."]
    damping: Annotated[ViscousDamping | None, "Its damper [N·s/m]."]


def amplitude(mu: "Any", f: "Any", zeta: "Any", r: "Any") -> "Any":
    """Amplitude of the machine over F/k; `zeta` is of the absorber alone."""
    own = (f - r) * (f + r)
    across = 2.0 * zeta * f * r
    left = (1.0 - r) * (1.0 + r)
    real = left * own - mu * f * f * r * r
    imaginary = across * (left - mu * r * r)
    return hypot(own, across) / hypot(real, imaginary)


def _slope(mu: "Any", f: "Any", zeta: "Any", u: "Any") -> "Any":
    """A number of the sign of d(amplitude²)/du, u = r²: N'·D − N·D' of the quotient N/D."""
    square, four = f * f, 4.0 * zeta * zeta * f * f
    own, left = square - u, 1.0 - u
    above, above_rate = own * own + four * u, four - 2.0 * own
    real = left * own - mu * square * u
    real_rate = 0.0 - own - left - mu * square
    rest = left - mu * u
    below = real * real + four * u * rest * rest
    below_rate = 2.0 * real * real_rate + four * rest * (rest - 2.0 * u * (1.0 + mu))
    return above_rate * below - above * below_rate


def _peaks(mu: "Any", f: "Any", zeta: "Any") -> "tuple[Any, Any]":
    """r² of both peaks: where the slope falls through zero before the valley and beyond it; zeros where there is none.

    They are found in doubles, one step of Newton from exact.
    """
    middle, product = 0.5 * (1.0 + f * f * (1.0 + mu)), f * f
    root = sqrt(middle * middle - product)
    low, high = product / (middle + root), middle + root
    before, after = _beside_valley(mu, f, zeta, low, high)
    lower, upper = (
        sign_change(lambda u: _slope(mu, f, zeta, u), a, b, NEAR) * (after > 0.0)
        for a, b in ((0.1 * low, before), (after, 4.0 * high))
    )
    return lower, upper


def _in_blocks(mu: "Any", f: "Any", zeta: "Any") -> "tuple[Any, Any]":
    import numpy as np

    lower, upper = np.empty(mu.shape), np.empty(mu.shape)
    for begin in range(0, mu.size, BLOCK):
        block = slice(begin, begin + BLOCK)
        some: list[Any] = [np.asarray(each).flat[block] for each in (mu, f, zeta)]
        lower.flat[block], upper.flat[block] = _peaks(*some)
    return lower, upper


def _beside_valley(mu: "Any", f: "Any", zeta: "Any", low: "Any", high: "Any") -> "tuple[Any, Any]":
    """Places before and after the valley between the peaks, from which the curve rises; zeros where there is none."""
    step, u = high / low, low / sqrt(sqrt(high / low))
    for _ in range(HALVED_STEPS):
        step = sqrt(step)
    before = after = 0.0 * u
    rising = _slope(mu, f, zeta, u) > 0.0
    for _ in range(LOOKS):
        u, last = u * step, u
        now = _slope(mu, f, zeta, u) > 0.0
        if is_array(u):
            here = now & ~rising & (after == 0.0)
            before, after = before + here * last, after + here * u
            if (after > 0.0).all():
                break
        elif now and not rising:
            return last, u
        rising = now
    return before, after


def _bend(mu: "Any", f: "Any", zeta: "Any", u: "Any") -> "Any":
    """The slope's own slope."""
    step = 1e-5 * u
    none = u == 0.0
    return (_slope(mu, f, zeta, u + step) - _slope(mu, f, zeta, u - step) + none) / (2.0 * step + none)


def _places(mu: "Any", f: "Any", zeta: "Any") -> "Iterator[Any]":
    """R of both peaks: found in doubles, then one step of Newton in the arithmetic of the inputs."""
    if is_array(mu) or is_array(f) or is_array(zeta):
        spread = 0.0 * (mu + f + zeta)
        mu, f, zeta = mu + spread, f + spread, zeta + spread
        peaks = _in_blocks(mu, f, zeta)
    else:
        peaks = _peaks(plain(mu), plain(f), plain(zeta))
    for peak in peaks:
        bend = _bend(plain(mu), plain(f), plain(zeta), peak)
        u = peak + 0.0 * mu
        require(
            u > 0.0, "with so much damping the two peaks are one: the absorber hardly moves against the machine",
            code="one-peak", hint="give less damping, or --tuning minimax",
        )  # fmt: skip
        yield sqrt(u - _slope(mu, f, zeta, u) / bend)


def absorber(
    *,
    size: Annotated[MassRatio | Masses, "Mass of the absorber."],
    natural_frequency: Annotated[Frequency | None, "Natural frequency of the machine alone, e.g. 12 Hz."] = None,
    tune: Annotated[RuleTuning | ChosenTuning, "How it is tuned."] = BY_RULE,
) -> Absorber:
    """A damped absorber on an undamped machine under a force: tuning, its true peaks, spring and damper.

    Equation
    --------
    Den Hartog: f = 1/(1 + μ), ζ² = 3μ/(8(1 + μ)) of the absorber alone, which is 3μ/(8(1 + μ)³) by the machine's
    frequency. Least peak: f² = 8[16 + 23μ + 9μ² + 2(2 + μ)√(4 + 3μ)]/(3(1 + μ)²(64 + 80μ + 27μ²)),
    ζ² = μ(96 + 81μ)/(16(1 + μ)(8 + 9μ + 4√(4 + 3μ))).

    Returns
    -------
    Absorber
        Tuning, both peaks as they are, fixed points, spring and damper.

    Raises
    ------
    InadmissibleError
        When a mass is zero, or the damping is zero or negative.

    References
    ----------
    Den Hartog, Mechanical Vibrations; least peak after Nishihara & Asami, J. Vib. Acoust. 124 (2002), confirmed by
    search.

    Examples
    --------
    >>> made = absorber(size=MassRatio(0.05))
    >>> round(made.lower_peak, 6), round(made.upper_peak, 6)
    (6.407492, 6.408443)
    """
    mu: Any
    if isinstance(size, Masses):
        require(size.mass > 0.0, "the mass of the machine is zero", code="no-mass")
        require(size.absorber_mass > 0.0, "the mass of the absorber is zero", code="no-mass")
        mu = size.absorber_mass / size.mass
    else:
        mu = size.mass_ratio
    f, zeta = _tuned(mu, tune)
    places = list(_places(mu, f, zeta))
    heights = [amplitude(mu, f, zeta, r) for r in places]
    frequency = mass = stiffness = damping = None
    if natural_frequency is not None:
        from dynamics_cli.numerics.elementary import pi_beside

        require(natural_frequency > 0.0, "the natural frequency is zero", code="no-stiffness")
        frequency = f * natural_frequency
        if isinstance(size, Masses):
            omega = 2.0 * pi_beside(frequency) * frequency
            mass = size.absorber_mass
            stiffness, damping = mass * omega * omega, 2.0 * zeta * mass * omega
    return Absorber(
        frequency_ratio=f,
        damping_ratio=zeta,
        damping_by_machine=zeta * f,
        lower_peak=heights[0],
        lower_ratio=places[0],
        upper_peak=heights[1],
        upper_ratio=places[1],
        fixed_point=sqrt((2.0 + mu) / mu),
        frequency=frequency,
        absorber_mass=mass,
        stiffness=stiffness,
        damping=damping,
    )


def _tuned(mu: "Any", tune: "RuleTuning | ChosenTuning") -> "tuple[Any, Any]":
    """Frequency ratio and damping ratio of the absorber alone."""
    if isinstance(tune, ChosenTuning):
        require_damping(tune.damping_ratio, DampingRatio)
        require(
            tune.damping_ratio > 0.0, "an absorber without damping has two peaks without height",
            code="undamped", hint="give --damping-ratio, or --tuning den-hartog",
        )  # fmt: skip
        return tune.frequency_ratio, tune.damping_ratio
    whole = 1.0 + mu
    if tune.tuning == "den-hartog":
        return 1.0 / whole, sqrt(3.0 * mu / (8.0 * whole))
    root = sqrt(4.0 + 3.0 * mu)
    above = 8.0 * (16.0 + 23.0 * mu + 9.0 * mu * mu + 2.0 * (2.0 + mu) * root)
    f = sqrt(above / (3.0 * (64.0 + 80.0 * mu + 27.0 * mu * mu))) / whole
    zeta = 0.25 * sqrt(mu * (96.0 + 81.0 * mu) / (whole * (8.0 + 9.0 * mu + 4.0 * root)))
    return f, zeta
