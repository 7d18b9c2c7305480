"""Calls of `dynamics pendulum`: refusals, advice, uncertainty, rows, pictures."""

import math
import shlex
from pathlib import Path

import pytest
from harness import answer, run

REFUSED = {
    "top": ('simple --length "1 m" --amplitude "180 deg"', "at-top"),
    "nothing": ('simple --length "1 m"', "missing"),
    "two starts": ('simple --length "1 m" --amplitude "3 deg" --bottom-speed "1 m/s"', "exclusive"),
    "at rest": ('simple --length "1 m" --amplitude "0 deg"', "at-rest"),
    "length": ('simple --length "0 m" --amplitude "3 deg"', "inadmissible"),
    "time": ('simple --length "1 m" --angle "3 deg" --rate "1 rad/s" --time "1 s"', "start"),
    "centre": ('compound --mass "1 kg" --distance "0 m" --gyration "1 m"', "centre"),
    "body": ('compound --mass "1 kg" --distance "1 m" --inertia "0.5 kg*m^2"', "impossible-body"),
    "beyond": ('rod --length "1 m" --mass "1 kg" --amplitude "10 deg" --angle "20 deg"', "beyond"),
    "slow cone": ('conical --length "1 m" --rotation "20 rpm"', "too-slow"),
    "tall cone": ('conical --length "1 m" --height "1 m"', "height"),
    "flat cone": ('conical --length "1 m" --angle "90 deg"', "angle"),
    "no drag": ('damped --length "1 m" --amplitude "9 deg"', "no-drag"),
    "feeding": ('damped --length "1 m" --amplitude "9 deg" --damping -0.1', "drag"),
    "until": ('damped --length "1 m" --amplitude "9 deg" --damping 0.1 --until "10 deg"', "until"),
    "overdamped": ('damped --length "1 m" --amplitude "9 deg" --damping 1.5', "no-swing"),
    "slow": ('design --period "2 s" --length "1 m"', "too-long"),
    "both": ('design --period "2 s" --length "1 m" --amplitude "3 deg"', "ambiguous"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str) -> None:
    call, code = REFUSED[name]
    out = run(*shlex.split("pendulum " + call), "--json")
    assert out.status in (2, 3)
    assert out.error["code"] == code


def test_at_the_limit_there_is_no_period() -> None:
    made = answer("pendulum", "simple", "--length", "1 m", "--bottom-speed", "6 m/s", "--gravity", "9 m/s^2")
    assert made["results"]["period"] is None
    assert {warning["code"] for warning in made["warnings"]} >= {"no-period"}


def test_uncertainty_and_limits() -> None:
    made = answer(
        "pendulum", "simple", "--length", "1.00 ± 0.01 m", "--amplitude", "20..40 deg", "--limit", "period=2.05 s"
    )
    assert made["results"]["period"]["std"] > 0.0
    assert 0.0 < made["limits"][0]["probability"] < 1.0


def test_rows() -> None:
    out = run("pendulum", "rod", "--rows", "-", stdin="length[m],amplitude[deg]\n1.2,60\n-1,0\n")
    assert "1.925918508248075" in out.out
    assert "above zero" in out.out


@pytest.mark.parametrize(
    "call",
    [
        'simple --length "1 m" --amplitude "60 deg"',
        'simple --length "1 m" --bottom-speed "8 m/s" --time "1 s"',
        'damped --length "1 m" --amplitude "60 deg" --damping 0.05 --until "10 deg"',
    ],
)
def test_pictures(call: str, tmp_path: Path) -> None:
    target = tmp_path / "picture.svg"
    assert run(*shlex.split("pendulum " + call), "--plot", str(target)).status == 0
    assert target.stat().st_size > 5000


def test_a_period_alone_gives_the_length_for_small_swings() -> None:
    made = answer("pendulum", "design", "--period", "2 s")["results"]
    assert made["length"]["value"] == pytest.approx(9.80665 / math.pi**2, rel=1e-15)
    assert made["amplitude"]["value"] == 0.0
