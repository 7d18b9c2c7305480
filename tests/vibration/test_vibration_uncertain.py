"""Uncertain systems: results that stand by themselves, samples beside full answers, and the speed of the recursion."""

import math

import numpy as np
import pytest
from harness import answer, run

from dynamics_cli.core.output.answer_words import interval_in_words
from dynamics_cli.records import Formula
from dynamics_cli.sampling import Drawing
from dynamics_cli.vibration.nonlinear.truth import balance_roots, jumps
from dynamics_cli.vibration.shocks.pulses import Shape
from dynamics_cli.vibration.shocks.recursion import followed
from dynamics_cli.vibration.shocks.shock import Pulse, shock
from dynamics_cli.vibration.systems.history import history
from dynamics_cli.vibration.systems.inputs import Line
from dynamics_cli.vibration.systems.loads import ForceLaw

# A sample of a formula agrees with the answer of full steps to this.
SAMPLE = 1e-4
# Rounding of some hundred steps.
ROUNDING = 1e-12


def test_recursions_by_doubling_are_those_step_by_step() -> None:
    rng = np.random.default_rng(1)
    factor = 0.4 * rng.standard_normal((3, 2, 2))
    states = rng.standard_normal((3, 301, 2))
    expected = states.copy()
    for k in range(1, 301):
        expected[:, k] += np.einsum("nij,nj->ni", factor, expected[:, k - 1])
    assert followed(states.copy(), factor) == pytest.approx(expected, rel=ROUNDING, abs=ROUNDING)


def test_the_first_frequency_of_uncertain_springs_has_its_interval() -> None:
    """Of one mass and spring, σ_f/f is half of σ_k/k."""
    document = answer("vibration", "modes", "--masses", "2 kg", "--stiffnesses", "10 ± 0.2 N/mm")
    first = document["results"]["first_frequency"]
    assert first["value"] == pytest.approx(math.sqrt(1e4 / 2.0) / (2.0 * math.pi))
    assert first["std"] == pytest.approx(0.5 * 0.02 * first["value"], rel=2e-3)


def test_frequencies_have_limits_and_sweeps() -> None:
    masses = ("--masses", "1, 2, 3 kg", "--stiffnesses", "1, 1, 1 N/mm")
    document = answer("vibration", "modes", *masses, "--limit", "first_frequency=1 Hz")
    assert document["limits"][0]["beyond"] is True
    table = answer("vibration", "modes", *masses, "--sweep", "masses[0]=1 kg:2 kg:2")["results"]["sweep"]
    assert table["first_frequency"]["value"][0] == document["results"]["first_frequency"]["value"]


def test_a_critical_speed_is_the_one_nearest_to_running() -> None:
    """Two equal rotors: ω² = 2k/J; order 1 lies in the range, order 2 at half of it below."""
    line = (
        "--rotor", "name=a, inertia=1 kg*m^2", "--rotor", "name=b, inertia=1 kg*m^2",
        "--shaft", "from=a, to=b, stiffness=5000 N*m/rad", "--orders", "1, 2", "--lowest-speed", "800 rpm",
    )  # fmt: skip
    results = answer("vibration", "shaft", *line)["results"]
    assert results["critical_speed"]["value"] == pytest.approx(100.0 * 30.0 / math.pi)


def test_undamped_systems_answer_at_a_frequency_but_not_at_resonance() -> None:
    system = ("--masses", "10, 1 kg", "--stiffnesses", "10, 1 N/mm", "--force-at", "1", "--read-at", "1")
    results = answer("vibration", "response", *system, "--force", "10 N", "--frequency", "4 Hz")["results"]
    rate = 8.0 * math.pi
    exact = np.linalg.solve(np.array([[11e3, -1e3], [-1e3, 1e3]]) - rate**2 * np.diag([10.0, 1.0]), [10.0, 0.0])
    assert results["amplitude"]["value"] == pytest.approx(1e3 * exact[0])
    one = ("--masses", "1 kg", "--stiffnesses", "100 N/m", "--force-at", "1", "--read-at", "1")
    refused = run("vibration", "response", *one, "--frequency", repr(10.0 / (2.0 * math.pi)) + " Hz", "--json")
    assert (refused.status, refused.error["code"]) == (3, "resonance")


def test_jumps_of_uncertain_springs_vary_and_bound_three_amplitudes() -> None:
    typed = ("--law", "forced-duffing", "--cubic", "0.5 ± 0.005", "--damping-ratio", "0.02", "--force", "0.2")
    results = answer("vibration", "nonlinear", *typed, "--frequency-ratio", "1.6")["results"]
    falling, rising = jumps(0.02, 0.5, 0.2, 8.0)
    assert falling is not None
    assert rising is not None
    assert (results["falling_jump"]["value"], results["rising_jump"]["value"]) == pytest.approx((falling, rising))
    assert all(results[name]["std"] > 0.0 for name in ("falling_jump", "rising_jump", "large_amplitude"))
    for place, inside in ((falling, 1.0), (rising, -1.0)):
        counts = [len(balance_roots(0.02, 0.5, 0.2, place + side * 1e-6)) for side in (inside, -inside)]
        assert counts == [3, 1]


def test_a_sample_of_a_history_is_its_answer() -> None:
    def peak() -> float:
        law = ForceLaw(Formula("200*exp(-30*t)*sin(60*t)", 1.0, "N"))
        return history(system=Line((1.0, 2.0), (1e4, 2e4)), load=law, force_at="1", duration=0.5).peak

    whole = peak()
    with Drawing():
        assert peak() == pytest.approx(whole, rel=SAMPLE)


def test_a_sample_of_a_shock_spectrum_has_its_worst_point() -> None:
    def worst() -> "tuple[float, float]":
        spectrum = shock(input_=Pulse(Shape("half-sine"), 300.0, 0.011))
        return spectrum.worst, spectrum.worst_frequency

    whole = worst()
    with Drawing():
        assert worst() == whole
        assert worst() == whole


SHAKEN = ("vibration", "transient", "--natural-frequency", "20 Hz", "--damping-ratio", "0.05", "--base-acceleration",
          "30 g", "--shape", "half-sine", "--duration", "11 ms")  # fmt: skip
PUSHED = ("vibration", "history", "--masses", "1, 1, 1 kg", "--damping-ratio", "0.02", "--force-law",
          "200*exp(-30*t)*sin(60*t) N", "--force-at", "1", "--read-at", "2", "--duration", "1 s")  # fmt: skip


@pytest.mark.parametrize("call", [SHAKEN, (*PUSHED, "--stiffnesses", "10, 10, 10 N/mm")], ids=["one", "three"])
def test_a_peak_to_the_negative_side_exceeds_its_limit(call: tuple[str, ...]) -> None:
    document = answer(*call, "--limit", "peak=10 mm")
    assert document["results"]["peak"]["value"] > 10.0
    assert document["limits"][0]["beyond"]


def test_a_peak_whose_side_changes_within_the_spread_is_its_size() -> None:
    """The side of the largest displacement changes about the nominal stiffness; its size hardly does."""
    results = answer(*PUSHED, "--stiffnesses", "10 ± 0.5, 10, 10 N/mm")["results"]
    low, high = results["peak"]["interval"]
    assert 0.0 < low < results["peak"]["median"] < high


def test_ends_of_an_interval_that_is_hardly_known_have_fewer_places() -> None:
    document = {
        "results": {"force": {"value": 161.0, "interval": [158.42, 164.75], "coverage": 0.95, "std": 1.564}},
        "numerics": {"uncertainty": {"results": {"force": {"estimate": 0.001}}}},
    }
    stated = document["numerics"]["uncertainty"]["results"]["force"]
    for error, wanted in ((0.001, "158.4 to 164.8"), (0.3, "158 to 165"), (None, "158 to 165")):
        stated["estimate"] = error
        assert interval_in_words(document, "force", 1.564, 6, asked=False) == f"95 %: {wanted}"
