"""`dynamics motion chain`: motions and frequencies by another formulation, the horizon, energy, refusals."""

import json
import math
import shlex
from pathlib import Path
from typing import Any

import pytest
from harness import answer, run
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.motion.chain import chain
from dynamics_cli.motion.growth import Growth
from dynamics_cli.motion.modes import modes
from dynamics_cli.motion.rods import PLAIN, Rods, chain_of
from dynamics_cli.pendulum.simple import Amplitude, simple

REFERENCES: dict[str, Any] = json.loads((Path(__file__).parent / "chains.json").read_text(encoding="utf-8"))
RIGHT = (math.pi / 2,)
BENT = tuple(math.radians(x) for x in (30.0, -20.0, 45.0))
UNIT: dict[str, Any] = {"lengths": (1.0, 1.0), "masses": (1.0,), "angles": RIGHT, "gravity": 1.0}
POINTS: dict[str, Any] = {
    "lengths": (1.0, 1.0),
    "masses": (0.0,),
    "end_masses": (1.0,),
    "angles": RIGHT,
    "gravity": 9.81,
}
CALLS: dict[str, dict[str, Any]] = {
    "unit rods, 1 s": {**UNIT, "duration": 1.0},
    "unit rods, 5 s": {**UNIT, "duration": 5.0},
    "unit points, 1 s": {**POINTS, "duration": 1.0},
    "unit points, 10 s": {**POINTS, "duration": 10.0},
    "three rods, 2 s": {"lengths": (0.5,) * 3, "masses": (1.0,), "angles": BENT, "duration": 2.0},
    "rods with ends, 1 s": {
        "lengths": (0.4, 0.9), "masses": (2.0, 0.5), "end_masses": (1.0, 3.0), "angles": (1.0, 2.0),
        "rates": (-1.5, 4.0), "duration": 1.0,
    },
}  # fmt: skip


@pytest.mark.parametrize("name", CALLS)
def test_motions(name: str) -> None:
    made = chain(**CALLS[name])
    assert made.rods is not None
    state = [*(rod.angle for rod in made.rods), *(rod.rate for rod in made.rods)]
    wanted = [float(x) for x in REFERENCES["motions"][name]]
    assert state == pytest.approx(wanted, rel=0.0, abs=5e-11 if "10 s" in name else 1e-11)
    # the two runs stand for the error
    off = max(abs(a - b) for a, b in zip(state[: len(state) // 2], wanted, strict=False))
    assert off <= made.difference + 1e-14
    assert all(check.passed for check in made.checks)
    assert made.verdict.startswith("holds to the end")


SHAPES = {
    "3 rods": ("1 kg", "0 kg", 3), "10 rods": ("1 kg", "0 kg", 10), "3 points": ("0 kg", "1 kg", 3),
    "6 points": ("0 kg", "1 kg", 6), "points 1e-6, 1, 1e6": ("0 kg", "1e-6, 1, 1e6 kg", 3),
    "points 1e6, 1, 1e-6": ("0 kg", "1e6, 1, 1e-6 kg", 3),
}  # fmt: skip


@pytest.mark.parametrize("name", SHAPES)
def test_frequencies(name: str) -> None:
    masses, ends, n = SHAPES[name]
    rods = chain_of((1.0,), _numbers(masses), _numbers(ends), (), n, 1.0)
    squares = [1.0 / slow**2 for slow in rods.oscillations()[0]]
    assert squares == pytest.approx([float(x) for x in REFERENCES["squares"][name]], rel=4e-15, abs=0.0)


def _numbers(text: str) -> tuple[float, ...]:
    return tuple(float(word) for word in text.removesuffix(" kg").split(","))


def test_past_the_horizon_there_is_no_state() -> None:
    made = chain(**POINTS, duration=40.0)
    assert made.rods is None
    assert made.verdict.startswith("ends at the horizon, about 2")
    assert made.horizon is not None
    # a difference of 1e-12 grows to 0.01 by 28.5 s
    assert 20.0 < made.horizon < 30.0
    assert made.motion[-1].time == made.horizon
    assert {advice.code for advice in made.advice} == {"past-horizon"}
    # energy says nothing of it
    assert made.energy_error < 1e-10


def test_before_the_end_the_horizon_is_that_of_a_longer_run() -> None:
    call: dict[str, Any] = {"lengths": (0.5,) * 3, "masses": (1.0,), "angles": (math.radians(120.0),)}
    short, long = chain(**call, duration=6.0), chain(**call, duration=20.0)
    assert short.rods is not None
    assert short.horizon is not None
    assert long.horizon is not None
    assert short.horizon == pytest.approx(long.horizon, rel=0.4)


def test_one_point_is_the_pendulum() -> None:
    made = chain(lengths=(0.7,), masses=(0.0,), end_masses=(2.0,), angles=(2.0,), duration=1.7)
    alone = simple(length=0.7, start=Amplitude(2.0), mass=2.0, time=1.7)
    assert made.rods is not None
    assert made.rods[0].angle == pytest.approx(alone.angle_then, abs=1e-11)
    assert made.rods[0].rate == pytest.approx(alone.rate_then, abs=1e-11)


def test_a_rod_near_the_top_returns_after_its_period() -> None:
    start = math.radians(179.9999)
    alone = simple(length=2.0 / 3.0, start=Amplitude(start))
    assert alone.period is not None
    made = chain(lengths=(1.0,), masses=(1.0,), angles=(start,), duration=0.25 * alone.period)
    assert made.rods is not None
    assert made.rods[0].angle == pytest.approx(0.0, abs=1e-6)


def test_pins_carry_the_weight_at_rest() -> None:
    rods = chain_of((1.0, 2.0), (3.0, 4.0), (0.5, 0.25), (), None, 10.0)
    assert rods.pin_forces([0.0] * 4) == pytest.approx([77.5, 42.5])


def test_both_sides_of_plain_floats() -> None:
    """Nine rods go by arrays; the same equations."""
    state = [0.1 * k - 0.3 for k in range(2 * PLAIN)]
    plain = Rods([0.5] * PLAIN, [1.0] * PLAIN, [0.2] * PLAIN, [0.02] * PLAIN, 9.81)
    import numpy as np

    by_arrays = plain._rate_by_arrays(np.array(state))
    assert plain.rate(0.0, state) == pytest.approx(by_arrays.tolist(), rel=1e-11, abs=1e-11)


def test_small_swings_are_checked() -> None:
    made = chain(lengths=(0.5, 0.5), masses=(1.0,), angles=(0.02, -0.01), rates=(0.01, 0.02), duration=3.0)
    (check,) = (check for check in made.checks if check.name == "as small oscillations")
    assert check.passed
    assert check.value is not None
    assert check.value < 1e-3
    large = chain(lengths=(0.5, 0.5), masses=(1.0,), angles=(0.5,), duration=1.0)
    assert all(check.name != "as small oscillations" for check in large.checks)


@settings(max_examples=6, deadline=None)
@given(st.floats(0.2, 3.0), st.floats(-3.0, 3.0), st.floats(-3.0, 3.0))
def test_scaled_chains_move_alike(scale: float, one: float, two: float) -> None:
    """Lengths by s, times by √s: the same angles; masses by any factor."""
    if abs(math.sin(one)) < 1e-3:
        return
    first = chain(lengths=(1.0, 0.6), masses=(1.0, 2.0), angles=(one, two), duration=1.0)
    second = chain(
        lengths=(scale, 0.6 * scale), masses=(3.0, 6.0), angles=(one, two), duration=math.sqrt(scale),
    )  # fmt: skip
    assert first.rods is not None
    assert second.rods is not None
    for a, b in zip(first.rods, second.rods, strict=True):
        assert a.angle == pytest.approx(b.angle, abs=1e-9)


REFUSED = {
    "massless": ('--lengths "1, 1 m" --masses "1, 0 kg" --angles "9 deg" --duration "1 s"', "massless"),
    "lists": ('--lengths "1, 1, 1 m" --masses "1, 2 kg" --angles "9 deg" --duration "1 s"', "count"),
    "count": ('--lengths "1, 1 m" --count 3 --masses "1 kg" --angles "9 deg" --duration "1 s"', "count"),
    "many": ('--lengths "1 m" --count 61 --masses "1 kg" --angles "9 deg" --duration "1 s"', "count"),
    "hangs": ('--lengths "1, 1 m" --masses "1 kg" --angles "0 deg" --duration "1 s"', "at-rest"),
    "stands": ('--lengths "1, 1 m" --masses "1 kg" --angles "180, 0 deg" --duration "1 s"', "at-rest"),
    "long": ('--lengths "1, 1 m" --masses "1 kg" --angles "9 deg" --duration "9 h"', "too-long"),
    "length": ('--lengths "1, 0 m" --masses "1 kg" --angles "9 deg" --duration "1 s"', "inadmissible"),
    "back": ('--lengths "1, 1 m" --masses "1 kg" --angles "9 deg" --duration "-1 s"', "bounds"),
    "weightless": ('--lengths "1 m" --masses "1 kg" --angles "9 deg" --duration "1 s" --gravity "0 m/s^2"', "bounds"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str) -> None:
    call, code = REFUSED[name]
    out = run("motion", "chain", *shlex.split(call), "--json")
    assert out.status in (2, 3)
    assert out.error["code"] == code


def test_the_horizon_in_a_document() -> None:
    made = answer("motion", "chain", *shlex.split(
        '--lengths "0.5, 0.5, 0.5 m" --masses "1 kg" --angles "120 deg" --duration "20 s"'
    ))  # fmt: skip
    assert made["results"]["rods"] is None
    assert made["results"]["horizon"]["value"] < 12.0


def test_modes_of_two_rods() -> None:
    """ω²l/g = 3(1 ∓ 2/√7), and the shapes turn each other's energy away."""
    made = modes(lengths=(1.0, 1.0), masses=(1.0,), gravity=1.0)
    wanted = [3.0 * (1.0 - 2.0 / math.sqrt(7.0)), 3.0 * (1.0 + 2.0 / math.sqrt(7.0))]
    assert [mode.angular_frequency**2 for mode in made.modes] == pytest.approx(wanted, rel=4e-15)
    # potential energies: b = 3/2 and 1/2
    one, two = (mode.shape for mode in made.modes)
    assert 1.5 * one[0] * two[0] + 0.5 * one[1] * two[1] == pytest.approx(0.0, abs=1e-14)
    assert all(check.passed for check in made.checks)


def test_many_rods_are_a_hanging_chain() -> None:
    made = modes(lengths=(0.025,), masses=(1.0,), count=40, gravity=1.0)
    assert made.modes[0].angular_frequency == pytest.approx(1.20243581381737717, rel=1e-14)
    # the limit is half the first zero of J₀
    assert made.modes[0].angular_frequency == pytest.approx(0.5 * 2.404825557695773, rel=1e-4)


@pytest.mark.parametrize("call", [POINTS, {"lengths": (0.5,) * 3, "masses": (1.0,), "angles": (math.radians(120.0),)}])
def test_a_short_run_tells_the_horizon_of_a_long_one(call: dict[str, Any]) -> None:
    short, long = chain(**call, duration=1.5), chain(**call, duration=40.0)
    assert short.rods is not None
    assert short.horizon == pytest.approx(long.horizon, rel=0.25)
    assert "means nothing beyond about" in short.verdict


def test_a_regular_motion_has_no_horizon() -> None:
    """Small swings, and one rod, which never is chaotic."""
    small = chain(lengths=(0.5, 0.5), masses=(1.0,), angles=(0.1, -0.05), duration=2.0)
    alone = chain(lengths=(0.7,), masses=(1.0,), angles=(3.0,), duration=2.0)
    for made in (small, alone):
        assert made.horizon is None
        assert made.verdict == "holds to the end; no horizon in sight"


def test_growth_is_that_of_two_runs_a_hair_apart() -> None:
    start = [math.pi / 2] * 2 + [0.0] * 2
    rods = chain_of((1.0, 1.0), (0.0,), (1.0,), (), None, 9.81)
    growth = Growth(rods, start, 1.0)
    one, other = (
        chain(**{**POINTS, "angles": (math.pi / 2 + nudge, math.pi / 2)}, duration=10.0).rods for nudge in (0.0, 1e-8)
    )
    assert one is not None
    assert other is not None
    apart = max(abs(a.angle - b.angle) for a, b in zip(one, other, strict=True))
    assert math.log10(apart / 1e-8) == pytest.approx(growth._at(10.0), abs=0.5)
