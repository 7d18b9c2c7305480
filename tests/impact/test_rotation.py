"""A light vehicle's speed from the spin of the heavy one: exact case, planar impact as a check, refusals."""

import math

import pytest
from harness import answer, run

from dynamics_cli.impact.reconstruction.rotation import rotation

CASE = {"heavy_inertia": 1800.0, "heavy_spin": 1.15, "lever": 1.6, "light_mass": 250.0, "exit_speed": 2.0}


def test_the_impulse_and_the_speed() -> None:
    found = rotation(**CASE, heavy_mass=1450.0)
    assert (found.impulse, found.speed) == (pytest.approx(1293.75, rel=1e-15), pytest.approx(7.175, rel=1e-15))
    assert found.heavy_change == pytest.approx(1293.75 / 1450.0, rel=1e-15)
    assert found.advice[0].severity == "note"
    assert rotation(**{**CASE, "lever": 0.3}).advice[0].severity == "caution"


def test_it_finds_the_approach_that_an_impact_was_calculated_from() -> None:
    """A motorcycle of 250 kg at 15 m/s into the side of a car at rest, plastic, without friction at the contact."""
    words = (
        "impact", "planar", "--first-mass", "1450 kg", "--first-inertia", "1800 kg*m^2", "--first-lever", "1.6, 0.8 m",
        "--first-velocity", "0, 0 m/s", "--second-mass", "250 kg", "--second-inertia", "40 kg*m^2",
        "--second-lever", "0, -0.9 m", "--second-velocity", "0, -15 m/s", "--normal", "90 deg",
        "--restitution", "0", "--friction", "0",
    )  # fmt: skip
    results = answer(*words)["results"]
    spin = results["first"]["spin_change"]["value"] * math.pi / 180.0
    left = -results["second"]["velocity"]["value"][1]
    found = rotation(heavy_inertia=1800.0, heavy_spin=abs(spin), lever=1.6, light_mass=250.0, exit_speed=left / 3.6)
    assert found.speed == pytest.approx(15.0, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [("lever", "0 m", "turns nothing"), ("heavy-spin", "-1 rad/s", "give its amount"), ("light-mass", "0 kg", "mass")],
)
def test_what_turns_nothing_is_refused(name: str, text: str, words: str) -> None:
    given = {"heavy-inertia": "1800 kg*m^2", "heavy-spin": "1.15 rad/s", "lever": "1.6 m", "light-mass": "250 kg"}
    pairs = {**given, name: text}.items()
    outcome = run("impact", "rotation", *(part for key, value in pairs for part in (f"--{key}", value)))
    assert outcome.status in (2, 3)
    assert words in outcome.err
