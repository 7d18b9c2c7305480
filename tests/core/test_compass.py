"""Headings in words of the compass: clockwise from north, with compass axes alone."""

import pytest
from harness import answer, run

from dynamics_cli.core.inputs.context import Context
from dynamics_cli.core.inputs.forms.compass import POINTS, in_degrees

COMPASS = Context({})
COMPASS.axes = "compass"


@pytest.mark.parametrize(
    ("words", "degrees"),
    [
        ("north", "0.0 deg"), ("N", "0.0 deg"), ("due east", "90.0 deg"), ("South-West", "225.0 deg"),
        ("westbound", "270.0 deg"), ("north-north-east", "22.5 deg"), ("NE ± 2 deg", "45.0 deg ± 2 deg"),
        ("N 30 E", "30.0 deg"), ("S12.5W", "192.5 deg"), ("N 30 ± 2 W", "-30.0 deg ± 2"),
        ("30 deg east of north", "30.0 deg"), ("10° north of east", "80.0 deg"),
        ("20 ± 1.5 deg west of south", "200.0 deg ± 1.5"), ("S 5 E ± 1 deg", "175.0 deg ± 1 deg"),
        ("normal(30 deg, 2 deg)", "normal(30 deg, 2 deg)"),
    ],
)  # fmt: skip
def test_words_are_degrees_clockwise_from_north(words: str, degrees: str) -> None:
    assert in_degrees(words, COMPASS) == degrees


def test_the_points_are_equally_apart() -> None:
    assert [in_degrees(point, COMPASS) for point in POINTS] == [f"{22.5 * place} deg" for place in range(16)]


CRASH = (
    "impact", "momentum", "--first-mass", "1500 kg", "--first-exit-speed", "41 km/h", "--second-mass", "1150 kg",
    "--second-exit-speed", "40 km/h",
)  # fmt: skip
NAMES = ("--first-approach-heading", "--first-exit-heading", "--second-approach-heading", "--second-exit-heading")


def headed(*headings: str) -> tuple[str, ...]:
    return (*CRASH, *(word for pair in zip(NAMES, headings, strict=True) for word in pair))


def test_a_crash_is_the_same_in_words_and_in_degrees() -> None:
    words = answer(*headed("eastbound", "N 48 E", "north", "53 deg east of north"), "--axes", "compass")
    assert words["results"] == answer(*headed("90 deg", "48 deg", "0 deg", "53 deg"), "--axes", "compass")["results"]


@pytest.mark.parametrize("heading", ["nort", "N 100 E", "N 30", "30 deg south of north", "north of", "N nan E"])
def test_other_words_are_no_headings(heading: str) -> None:
    error = run(*headed(heading, "48 deg", "0 deg", "53 deg"), "--axes", "compass").err
    assert error.startswith("dynamics: --first-approach-heading: ")
    assert "N 30 E" in error or "90 deg" in error


def test_words_need_a_compass() -> None:
    error = run(*headed("north", "48 deg", "0 deg", "53 deg")).err
    assert "the axes are mathematical" in error
    assert "--axes compass" in error
