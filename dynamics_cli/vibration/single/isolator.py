"""The mounts that keep a vibration from passing: how soft they must be, and what given ones do."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, pi_beside, sqrt
from dynamics_cli.numerics.number import single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Annotated,
    Count,
    DampingRatio,
    Fraction,
    Frequency,
    Gravity,
    Mass,
    Ratio,
    Size,
    SpringRate,
)
from dynamics_cli.records import Advice, record
from dynamics_cli.vibration.single.base import require_share, transmitted
from dynamics_cli.vibration.single.oscillator import AtFrequency, AtSpeed, require_damping

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# A deflection that metal springs reach only when they are tall, and rubber never.
DEEP = 0.05


@record
class Passing:
    """The wish as transmissibility."""

    transmissibility: Annotated[Ratio, "Share of the vibration that may pass, e.g. 0.1."]


@record
class Kept:
    """The wish as isolation."""

    isolation: Annotated[Fraction, "Share of the vibration to keep away, e.g. 90 %."]


@record
class Given:
    """Given mounts."""

    static_deflection: Annotated[Size, "Deflection of the mounts under the weight, e.g. 5 mm."]


@record
class Isolator:
    """The mounts."""

    natural_frequency: Annotated[Frequency, "Natural frequency on the mounts f_n [Hz]."]
    static_deflection: Annotated[Size, "Deflection under the weight [m]."]
    stiffness: Annotated[SpringRate | None, "Stiffness of all mounts together [N/m]."]
    mount_stiffness: Annotated[SpringRate | None, "Stiffness of each mount [N/m]."]
    transmissibility: Annotated[Ratio, "Vibration that passes T [-]."]
    isolation: Annotated[Fraction | None, "1 − T; none where the mounts amplify [-]."]
    ratio: Annotated[Ratio, "Disturbing over natural frequency r [-]."]
    peak: Annotated[Ratio | None, "Transmissibility while running through resonance [-]."]
    advice: tuple[Advice, ...] = ()


def isolator(
    *,
    excitation: Annotated[AtFrequency | AtSpeed, "The lowest disturbing frequency."],
    wish: Annotated[Passing | Kept | Given, "What the mounts must do, or what they are."],
    damping_ratio: Annotated[DampingRatio, "Damping ratio of the mounts, e.g. 0.05."] = 0.0,
    mass: Annotated[Mass | None, "Mass on the mounts, e.g. 400 kg."] = None,
    mounts: Annotated[Count | None, "Number of mounts that share it, e.g. 4."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Isolator:
    """Mounts that let only a wanted share of a vibration pass, or what given mounts let pass.

    Equation
    --------
    u = r² is the positive root of T²u² + (4ζ²T² − 4ζ² − 2T²)u + T² − 1 = 0; f_n = f/r, δ = g/(2πf_n)², k = m(2πf_n)².

    Returns
    -------
    Isolator
        Natural frequency, deflection, stiffness, transmissibility and the peak at resonance.

    Raises
    ------
    InadmissibleError
        When the transmissibility is not between 0 and 1, the damping negative, or a frequency or deflection zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 13.6.

    Examples
    --------
    >>> made = isolator(excitation=AtFrequency(25.0), wish=Passing(0.1), damping_ratio=0.05)
    >>> round(made.ratio, 12)
    3.399494338501
    """
    require_damping(damping_ratio, DampingRatio)
    require(mass is None or mass > 0.0, "the mass is zero", code="no-mass")
    require(mounts is None or mounts > 0, "no mount carries the mass", code="no-mount", hint="give --mounts 4")
    turn = 2.0 * pi_beside(damping_ratio)
    hertz: Any = excitation.frequency if isinstance(excitation, AtFrequency) else absolute(excitation.speed) / turn
    require(hertz > 0.0, "the disturbing frequency is zero", code="at-rest")
    if isinstance(wish, Given):
        require(wish.static_deflection > 0.0, "a deflection of zero: the mounts are rigid", code="rigid")
        sag: Any = wish.static_deflection
        natural: Any = sqrt(gravity / sag) / turn
        ratio = hertz / natural
    else:
        ratio = _ratio(wish.transmissibility if isinstance(wish, Passing) else 1.0 - wish.isolation, damping_ratio)
        natural = hertz / ratio
        sag = gravity / (turn * natural * turn * natural)
    gap = (1.0 - ratio) * (1.0 + ratio)
    require(
        damping_ratio + absolute(gap) > 0.0, "these mounts are in resonance, undamped", code="resonance",
        hint="use softer mounts",
    )  # fmt: skip
    passed, _ = transmitted(gap, ratio, damping_ratio)
    stiffness = None if mass is None else mass * turn * natural * turn * natural
    return Isolator(
        natural_frequency=natural,
        static_deflection=sag,
        stiffness=stiffness,
        mount_stiffness=None if stiffness is None or mounts is None else stiffness / float(mounts),
        transmissibility=passed,
        isolation=1.0 - passed if passed < 1.0 else None,
        ratio=ratio,
        peak=_peak(damping_ratio),
        advice=_advice(passed, sag),
    )


def _ratio(passed: "Any", zeta: "Any") -> "Any":
    """R from the quadratic, whose positive root is a sum."""
    require_share(passed)
    a = passed * passed
    left = (1.0 - passed) * (1.0 + passed)
    half = 2.0 * zeta * zeta * left + a
    return sqrt((half + sqrt(half * half + a * left)) / a)


def _peak(zeta: "Any") -> "Any":
    if not zeta > 0.0:
        return None
    eight = sqrt(1.0 + 8.0 * zeta * zeta)
    gap = 8.0 * zeta * zeta / ((eight + 1.0) * (eight + 1.0))
    return transmitted(gap, sqrt(2.0 / (1.0 + eight)), zeta)[0]


def _advice(passed: "Any", sag: "Any") -> "tuple[Advice, ...]":
    if not single(passed, sag):
        return ()
    if not passed < 1.0:
        text = "these mounts amplify: the disturbing frequency lies below √2 times the natural one"
        return (Advice("no-isolation", text, remedy="use softer mounts: a larger static deflection"),)
    if sag > DEEP:
        text = "a deflection of more than 50 mm needs tall springs or air springs; check stability against tipping"
        return (Advice("deep", text, severity="note"),)
    return ()
