"""Shocks, nonlinear oscillators and complex modes against references by other formulas; speeds of counts."""

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from dynamics_cli.vibration.nonlinear.task import (
    Custom,
    Duffing,
    ForcedDuffing,
    Pendulum,
    QuadraticDamping,
    VanDerPol,
    nonlinear,
)  # fmt: skip
from dynamics_cli.vibration.shafts.beam import shape
from dynamics_cli.vibration.shocks.pulses import Shape
from dynamics_cli.vibration.shocks.shock import Pulse, shock
from dynamics_cli.vibration.shocks.transient import Jolt, Push, transient
from dynamics_cli.vibration.single.oscillator import DampingShare, Natural, Spring
from dynamics_cli.vibration.systems.elements import BY_FACTOR, CERTAIN, SMALL, Elements
from dynamics_cli.vibration.systems.inputs import Line, Matrices
from dynamics_cli.vibration.systems.modes import modes

REFERENCES: dict[str, Any] = json.loads((Path(__file__).parent / "motion.json").read_text(encoding="utf-8"))
# Some ten roundings; closed forms with complex exponentials.
EXACT, WAVES = 5e-15, 2e-13
# What the integrators state.
INTEGRATED = 1e-10


@pytest.mark.parametrize("case", REFERENCES["shocks"], ids=lambda case: f"{case['shape']}-{case['frequency']:g}")
def test_shock_spectra(case: dict[str, Any]) -> None:
    hertz = case["frequency"]
    made = shock(
        input_=Pulse(Shape(case["shape"]), 1.0, case["duration"]), damping_ratio=case["damping_ratio"], lowest=hertz,
        highest=hertz * 2.0, per_octave=1,
    )  # fmt: skip
    table = made.spectrum.arrays
    assert table["positive"][0] == pytest.approx(float(case["positive"]), rel=WAVES)
    assert table["negative"][0] == pytest.approx(float(case["negative"]), rel=WAVES)
    # the same oscillator by itself
    alone = transient(
        spring=Natural(hertz), damping=DampingShare(case["damping_ratio"]),
        load=Jolt(1.0, Shape(case["shape"]), case["duration"]),
    )  # fmt: skip
    assert abs(alone.peak_acceleration or 0.0) == pytest.approx(float(table["maximax"][0]), rel=WAVES)


def test_the_undamped_half_sine() -> None:
    wanted = REFERENCES["undamped"]
    for ratio, during in ((float(wanted["at"]), wanted["largest"]), (7.3, wanted["primary"])):
        made = shock(
            input_=Pulse(Shape("half-sine"), 1.0, 1.0), damping_ratio=0.0, lowest=0.5 * ratio, highest=ratio,
            per_octave=1,
        )  # fmt: skip
        assert made.spectrum.arrays["primary"][0] == pytest.approx(float(during), rel=WAVES)
    assert made.spectrum.arrays["residual"][0] == pytest.approx(float(wanted["residual"]), rel=1e-12)


def test_step_and_ramp_overshoot() -> None:
    zeta = 0.1
    made = transient(mass=500.0, spring=Spring(4e5), damping=DampingShare(zeta), load=Push(2e3, Shape("step")))
    assert made.overshoot == pytest.approx(math.exp(-math.pi * zeta / math.sqrt(1.0 - zeta**2)), rel=WAVES)
    # a ramp of a whole period leaves an undamped mass at its new place without overshoot
    still = transient(spring=Natural(4.0), load=Jolt(1.0, Shape("ramp"), 0.25))
    assert still.overshoot == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("share", REFERENCES["duffing"])
def test_duffing(share: str) -> None:
    made = nonlinear(oscillator=Duffing(float(share)))
    assert made.true_frequency == pytest.approx(float(REFERENCES["duffing"][share]), rel=EXACT)
    assert made.averaged_frequency == 1.0 + 0.375 * float(share)


@pytest.mark.parametrize("degrees", REFERENCES["pendulum"])
def test_pendulum(degrees: str) -> None:
    made = nonlinear(oscillator=Pendulum(math.radians(float(degrees))))
    assert made.true_frequency == pytest.approx(float(REFERENCES["pendulum"][degrees]), rel=EXACT)


def test_van_der_pol() -> None:
    wanted = REFERENCES["van_der_pol"]["1"]
    made = nonlinear(oscillator=VanDerPol(1.0))
    assert made.period == pytest.approx(float(wanted["period"]), rel=INTEGRATED)
    assert made.true_amplitude == pytest.approx(float(wanted["amplitude"]), rel=INTEGRATED)
    stiff = nonlinear(oscillator=VanDerPol(25.0))
    mild = nonlinear(oscillator=VanDerPol(15.0))
    # period (3 − 2·ln 2)μ + 7.0143/μ^⅓ − …, on both sides of the switch of integrators
    for made, mu in ((stiff, 25.0), (mild, 15.0)):
        assert made.period == pytest.approx((3 - 2 * math.log(2)) * mu + 7.01432 * mu ** (-1 / 3), rel=0.02)


def test_forced_duffing_and_its_jumps() -> None:
    made = nonlinear(oscillator=ForcedDuffing(0.5, 0.02, 0.2, 1.6))
    assert made.jumps == pytest.approx([float(one) for one in REFERENCES["jumps"]], rel=1e-12)
    assert made.branches is not None
    assert [row.amplitude for row in made.branches] == pytest.approx(
        [0.128607851307754735, 1.98822767783297353, 2.08576382212390098], rel=EXACT
    )
    assert [row.stable for row in made.branches] == [True, False, True]
    assert made.branches[2].true_amplitude == pytest.approx(2.0564, abs=5e-5)
    linear = nonlinear(oscillator=ForcedDuffing(0.0, 0.02, 0.2, 0.9))
    assert linear.branches is not None
    assert linear.branches[0].amplitude == pytest.approx(0.2 / math.hypot(1 - 0.81, 0.036), rel=EXACT)
    assert linear.branches[0].error == pytest.approx(0.0, abs=1e-9)


def test_a_softening_spring_has_no_amplitude_where_it_pushes_away() -> None:
    made = nonlinear(oscillator=ForcedDuffing(-0.1, 0.05, 0.1, 0.2))
    assert made.branches is not None
    assert [row.stable for row in made.branches] == [True]
    assert made.jumps == ()
    assert "pushed-away" in [one.code for one in made.advice]
    jumps = nonlinear(oscillator=ForcedDuffing(-0.1, 0.04, 0.1, 0.9)).jumps
    assert jumps is not None
    assert len(jumps) == 2
    assert all(one < 1.0 for one in jumps)


def test_averaging_of_quadratic_damping_is_its_closed_form() -> None:
    made = nonlinear(oscillator=QuadraticDamping(0.1, 1.0, 5))
    time = (made.period or 0.0) * 5
    assert made.averaged_amplitude == pytest.approx(1.0 / (1.0 + 4.0 * 0.1 * time / (3.0 * math.pi)), rel=1e-6)
    assert made.true_amplitude == pytest.approx(made.averaged_amplitude, rel=1e-3)
    viscous = nonlinear(oscillator=Custom("0.02*v", 1.0, 3))
    decay = math.exp(-0.01 * 3 * 2 * math.pi / math.sqrt(1 - 1e-4))
    assert viscous.true_amplitude == pytest.approx(decay, rel=INTEGRATED)


def test_complex_modes() -> None:
    made = modes(
        system=Matrices(
            (((2, 1), (0, 1)), ((0, 1), (1, 1))), (((300, 1), (-100, 1)), ((-100, 1), (100, 1))),
            (((1, 2), (0, 1)), ((0, 1), (0, 1))),
        )
    )  # fmt: skip
    for row, (real, imaginary) in zip(made.modes, REFERENCES["complex_modes"], strict=True):
        size = math.hypot(float(real), float(imaginary))
        assert row.angular_frequency == pytest.approx(size, rel=1e-13)
        assert row.damping_ratio == pytest.approx(-float(real) / size, rel=1e-12)


def test_soft_modes_where_matrices_fail() -> None:
    """Assembled, the lowest frequency is 16 times too high; from the factor it is right."""
    from scipy.linalg import eigh

    made = modes(system=Line((1.0,) * 4, (1e-3, 1e15, 1e15, 1e15)))
    assert made.modes[0].angular_frequency == pytest.approx(0.015811388300841896653, rel=1e-15)
    k = np.diag([1e-3 + 1e15, 2e15, 2e15, 1e15]) - 1e15 * (np.eye(4, k=1) + np.eye(4, k=-1))
    assert math.sqrt(abs(eigh(k, eigvals_only=True)[0])) > 5.0 * 0.0158


def _uniform(count: int) -> list[float]:
    """√λ of a chain of equal masses and springs from a wall: 2·sin((2j − 1)π/(4n + 2))."""
    from mpmath import mp, mpf, sin

    mp.dps = 30
    return [float(2 * sin((2 * j - 1) * mp.pi / mpf(4 * count + 2))) for j in range(1, count + 1)]


@pytest.mark.parametrize("count", [30, 31, 200])
def test_large_ordinary_chains_are_answered_from_their_matrix(count: int) -> None:
    """On both sides of the size at which the matrix is tried first, frequencies lie within the bound stated."""
    chain = Elements([1.0] * count, [(i, i - 1, 1.0) for i in range(count)])
    omega, _, widths, _ = chain.modes()
    assert (widths > 0.0).all()
    assert (widths <= CERTAIN).all()
    assert (abs(omega / np.array(_uniform(count)) - 1.0) <= widths).all()
    assert (omega == chain.by_matrix()[0]).all() == (count > SMALL)


def test_large_graded_chains_are_answered_from_their_factor() -> None:
    """With a soft mount the bound of the matrix says that it does not serve."""
    soft, stiff = 1e-3, 1e15
    chain = Elements([1.0] * 40, [(0, -1, soft), *((i, i - 1, stiff) for i in range(1, 40))])
    assert chain.by_matrix()[2] > 1e3 * CERTAIN
    omega, _, widths, method = chain.modes()
    assert method == BY_FACTOR
    assert widths[0] == 0.0
    assert omega[0] == pytest.approx(math.sqrt(soft / 40.0), rel=EXACT)


def test_the_bound_of_frequencies_from_a_matrix_holds() -> None:
    """Random chains, trees and rings, with springs over more and more decades, beside the factor's frequencies."""
    chance = np.random.default_rng(7)
    served = 0
    for decades in (0, 2, 4, 6, 8):
        for extra in (0, 3):
            springs = [(i, int(chance.integers(-1, i)), 10.0 ** chance.uniform(0, decades)) for i in range(40)]
            springs += [(i, i + 7, 10.0 ** chance.uniform(0, decades)) for i in range(extra)]
            chain = Elements(chance.uniform(1.0, 3.0, 40).tolist(), springs)
            (first, _, width), (second, _) = chain.by_matrix(), chain.by_factor()
            moving = second > 0.0
            assert abs(first[moving] / second[moving] - 1.0).max() <= width + EXACT
            served += width <= CERTAIN
    assert 2 <= served < 10


def test_beam_shapes_stay_right_in_high_modes() -> None:
    """The 14th cantilever: written with cosh and sinh, its shape is off by more than itself."""
    from mpmath import cos, cosh, findroot, mp, mpf, sin, sinh

    mp.dps = 40
    beta = findroot(lambda z: cos(z) + 1 / cosh(z), mpf("13.5") * mp.pi)
    s = (sinh(beta) - sin(beta)) / (cosh(beta) + cos(beta))
    for i in range(11):
        x = mpf(i) / 10
        exact = cosh(beta * x) - cos(beta * x) - s * (sinh(beta * x) - sin(beta * x))
        assert shape("clamped-free", 14, i / 10) == pytest.approx(float(exact), abs=1e-14)
