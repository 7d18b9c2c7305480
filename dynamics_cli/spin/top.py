"""The task `top`: a spinning top on a fixed point."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import acos, cos, pi_beside, sin, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Frequency,
    Gravity,
    Inertia,
    Length,
    Mass,
    ShaftSpeed,
    Text,
    TurnRate,
)
from dynamics_cli.records import record

ROUNDING = 1.0 + 1e-12
PI = 3.141592653589793


@record
class Top:
    """How a top precesses, and whether it sleeps."""

    slow: Annotated[TurnRate | None, "Slow steady precession at the tilt [rad/s]."]
    fast: Annotated[TurnRate | None, "Fast steady precession; none where the axis is level [rad/s]."]
    nutation: Annotated[Frequency | None, "Nutation about the slow precession, small [Hz]."]
    lowest_tilt: Annotated[Angle | None, "Tilt it dips to, its axis let go at rest at the tilt [rad]."]
    least_spin: Annotated[ShaftSpeed | None, "Least spin of steady precession at the tilt [rad/s]."]
    sleeping_spin: Annotated[ShaftSpeed, "It sleeps, upright and stable, from this spin [rad/s]."]
    upright: Annotated[Text, "Whether it sleeps at its spin."]


def top(
    *,
    mass: Annotated[Mass, "Mass of the top, e.g. 0.5 kg."],
    distance: Annotated[Length, "From the point it stands on to its centre of mass, e.g. 60 mm."],
    axial: Annotated[Inertia, "Moment of inertia about its axis, e.g. 6e-4 kg*m^2."],
    transverse: Annotated[Inertia, "Moment of inertia across it, about the point, e.g. 2.5e-3 kg*m^2."],
    spin: Annotated[ShaftSpeed, "Angular velocity along its axis, in all, e.g. 200 rad/s."],
    tilt: Annotated[Angle | None, "Angle of the axis from the vertical, e.g. 30 deg."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Top:
    """A heavy symmetric top on a fixed point: slow and fast precession, nutation, sleeping limit.

    Equation
    --------
    A·cos θ·Ω² − C·n·Ω + m·g·ℓ = 0; it sleeps if C²·n² ≥ 4·A·m·g·ℓ; nutation √(Ω²·sin² θ + (C·n/A − 2·Ω·cos θ)²).

    Returns
    -------
    Top
        Precessions at a tilt, and what it does upright.

    Raises
    ------
    InadmissibleError
        When mass, distance or a moment is not above zero, the transverse moment is too small for a body with that
        mass and distance, the top does not spin, the tilt is not between 0 and 180 degrees, or it is too slow for
        steady precession.

    References
    ----------
    Euler's equations, with components along the spin axis and across it.

    Examples
    --------
    >>> given = {"mass": 0.5, "distance": 0.06, "axial": 0.0006, "transverse": 0.0025, "spin": 200.0}
    >>> round(top(**given, tilt=0.5235987755982988).slow, 9)
    2.570914194
    """
    _check(mass, distance, axial, transverse, spin, tilt)
    pull = mass * gravity * distance
    momentum = axial * abs(spin)
    sleeping = 2.0 * sqrt(transverse * pull) / axial
    upright = "sleeps" if plain(abs(spin)) >= plain(sleeping) else "falls: it is too slow to sleep"
    if tilt is None:
        return Top(
            slow=None, fast=None, nutation=None, lowest_tilt=None, least_spin=None, sleeping_spin=sleeping,
            upright=upright,
        )  # fmt: skip
    sine, cosine = sin(tilt), cos(tilt)
    least = sleeping * sqrt(cosine) if plain(cosine) > 0.0 else 0.0 * sleeping
    require(
        abs(spin) >= least, "at {spin} it falls: steady precession at {tilt} needs {least}", spin=(spin, ShaftSpeed),
        tilt=(tilt, Angle), least=(least, ShaftSpeed), code="falls",
        hint="give more spin, or leave out the tilt for the sleeping limit",
    )  # fmt: skip
    # √(C²n² − 4A·mgℓ·cos θ), as a product where it is a difference
    squared = momentum * momentum - 4.0 * transverse * pull * cosine
    if plain(cosine) > 0.0:
        squared = axial * axial * (abs(spin) - least) * (abs(spin) + least)
    root = sqrt(squared) if plain(squared) > 0.0 else 0.0 * squared
    sign = 1.0 if plain(spin) > 0.0 else -1.0
    slow = 2.0 * pull / (momentum + root)
    fast = (momentum + root) / (2.0 * transverse * cosine) if abs(plain(cosine)) > 1e-15 else None
    swing = sqrt((slow * sine) * (slow * sine) + (root / transverse) * (root / transverse))
    return Top(
        slow=sign * slow,
        fast=None if fast is None else sign * fast,
        nutation=swing / (2.0 * pi_beside(mass, axial, spin, tilt)),
        lowest_tilt=_dip(momentum, transverse, pull, sine, cosine),
        least_spin=least,
        sleeping_spin=sleeping,
        upright=upright,
    )


def _check(mass: float, distance: float, axial: float, transverse: float, spin: float, tilt: "float | None") -> None:
    require((mass > 0.0) & (distance > 0.0), "mass and distance are not both above zero", code="no-weight",
            hint="a rotor held at its centre of mass is a matter for spin gyro")  # fmt: skip
    require((axial > 0.0) & (transverse > 0.0), "a moment of inertia is not above zero", code="impossible-body",
            hint="give both moments above zero")  # fmt: skip
    least = mass * distance * distance + 0.5 * axial
    require(
        transverse * ROUNDING >= least, "no body has only {transverse} across its axis, about the point",
        transverse=(transverse, Inertia), least=(least, Inertia), code="impossible-body",
        hint="the moment about the point is mass times distance squared, and at least half the axial one, together",
    )  # fmt: skip
    require(abs(spin) > 0.0, "the top does not spin: it falls", code="falls",
            hint="its swing is that of dynamics pendulum compound")  # fmt: skip
    require(
        tilt is None or bool((tilt > 0.0) & (tilt < PI)), "a tilt of {tilt} leaves nothing to precess",
        tilt=(tilt if tilt is not None else 0.0, Angle), code="upright",
        hint="give a tilt between 0 and 180 deg, or leave it out for the sleeping limit",
    )  # fmt: skip


def _dip(momentum: float, transverse: float, pull: float, sine: float, cosine: float) -> float:
    """Where the axis, let go at rest, turns back: cos θ − cos θ₁ = δ with δ² + (P − 2·cos θ)·δ − sin² θ = 0."""
    half = 0.5 * (momentum * momentum / (2.0 * transverse * pull) - 2.0 * cosine)
    root = sqrt(half * half + sine * sine)
    dip = sine * sine / (half + root) if plain(half) > 0.0 else root - half
    return acos(cosine - dip)
