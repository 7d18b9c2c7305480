"""Uncertain chains: few calls, the distribution of plain Monte Carlo, and peaks that are no accident of sampling."""

import math

import numpy as np
import pytest
from harness import run

from dynamics_cli.motion.chain import chain
from dynamics_cli.motion.peaks import peaks
from dynamics_cli.motion.side_by_side import chains
from dynamics_cli.quantities import STANDARD_GRAVITY

ONE = ("--lengths", "0.5 ± 0.01 m", "--masses", "1 kg", "--angles", "30 deg", "--duration", "0.5 s")


def test_one_uncertain_length_takes_few_calls() -> None:
    document = run("motion", "chain", *ONE, "--json").document
    assert document["numerics"]["uncertainty"]["evaluations"] < 200
    results = document["results"]
    # through the bottom, at any length: weight and 3/2·(1 − cos 30°) of it
    exact = STANDARD_GRAVITY * (1.0 + 1.5 * (1.0 - math.cos(math.pi / 6.0)))
    assert results["top_force"]["value"] == pytest.approx(exact, rel=1e-10)
    assert "interval" not in results["top_force"]
    assert not any(name in document["numerics"]["uncertainty"]["results"] for name in ("horizon", "tenfold"))
    low, high = results["angle"]["interval"]
    ends = [math.degrees(chain(lengths=(0.5 + 0.01 * z,), masses=(1.0,), angles=(math.pi / 6,), duration=0.5).angle)
            for z in (-1.9599639845400545, 1.9599639845400545)]  # fmt: skip
    assert [low, high] == pytest.approx(sorted(ends), abs=2e-3)


def test_side_by_side_as_alone() -> None:
    cases = [{"lengths": (0.5, 0.4 + 0.01 * k, 0.3), "masses": (1.0, 0.0, 2.0), "end_masses": (0.0, 0.5, 0.0),
              "angles": (0.5, -0.3, 1.0), "rates": (0.0, 2.0, 0.0), "duration": 1.5} for k in range(4)]  # fmt: skip
    together = chains([*cases, {**cases[0], "lengths": (0.5, -1.0, 0.3)}])
    assert isinstance(together[-1], Exception)
    for case, one in zip(cases, together, strict=False):
        alone = chain(**case)
        for name in ("top_force", "angle", "rate", "across", "up"):
            assert getattr(one, name) == pytest.approx(getattr(alone, name), rel=1e-7), name


def test_a_motion_that_turns_has_the_distribution_of_plain_monte_carlo() -> None:
    case = ("--lengths", "1, 1 m", "--masses", "1 kg", "--angles", "90 ± 1, 90 deg", "--duration", "5 s", "--json")
    results = run("motion", "chain", *case).document["results"]
    normal = np.random.default_rng(3).standard_normal(2000)
    given = {"lengths": (1.0, 1.0), "masses": (1.0,), "duration": 5.0}
    made = chains([{**given, "angles": (math.radians(90.0 + z), 0.5 * math.pi)} for z in normal.tolist()])
    for name, scale in (("angle", math.degrees(1.0)), ("across", 1e3), ("up", 1e3)):
        values = scale * np.array([getattr(one, name) for one in made])
        found = [*results[name]["interval"], results[name]["std"]]
        plain = [*np.quantile(values, (0.025, 0.975)), values.std()]
        assert found == pytest.approx(plain, abs=0.12 * values.std()), name


@pytest.mark.parametrize("phase", [0.0, 0.3, 1.1, 2.9])
def test_the_peak_between_samples(phase: float) -> None:
    x = np.linspace(0.0, 6.0, 60)
    history = np.array([2.0 + np.cos(x - phase), 3.0 - 0.5 * x, np.full(60, 7.0), x * x])
    assert peaks(history) == pytest.approx([3.0, 3.0, 7.0, 36.0], rel=1e-8)


def test_a_history_that_falls_from_its_first_value_peaks_there() -> None:
    x = np.linspace(0.0, 0.1, 60)
    slightly = 50.0 - x + 1e-9 * np.sin(40.0 * x)
    assert peaks(np.array([slightly, slightly[::-1]])) == pytest.approx([50.0, 50.0], rel=1e-9)
