"""Slides with spin to rest: against 30 digits, conservation, mirrors and turned scenes, and back from rest."""

import json
import math
import shlex
import time
from pathlib import Path
from typing import Any

import pytest
from harness import answer, run
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.impact.conventions import Axes
from dynamics_cli.impact.slide import back, pictures
from dynamics_cli.impact.slide.records import AtRest, Ground, Separation, SlideResult
from dynamics_cli.impact.slide.task import slide

CASES = json.loads((Path(__file__).parent / "slide.json").read_text(encoding="utf-8"))["cases"]
DEGREE = math.pi / 180.0
# The step control keeps 1e-8 a step; at rest a hundred times that of the path is left.
CLOSE = 1e-6
WHEELS = ("left_front", "right_front", "left_rear", "right_rear")
CAR: dict[str, Any] = {
    "front_axle": 1.2, "rear_axle": 1.4, "track": 1.5, "radius_of_gyration": 1.35, "friction": 0.7, "braking": 1.0,
}  # fmt: skip


def posed(case: dict[str, Any]) -> dict[str, Any]:
    ahead, behind, track, gyration, friction, shares, slope, steer = case["car"]
    numbers = dict(zip(WHEELS, map(float, shares.split()), strict=True))
    return {
        "front_axle": float(ahead), "rear_axle": float(behind), "track": float(track),
        "radius_of_gyration": float(gyration), "friction": float(friction), "braking": 1.0, **numbers,
        "grip_slope": float(slope), "steer": float(steer) * DEGREE, "nose": float(case["motion"][2]) * DEGREE,
    }  # fmt: skip


def motion(case: dict[str, Any]) -> Separation:
    speed, course, _, spin = map(float, case["motion"])
    return Separation(speed, course * DEGREE, spin)


@pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])
def test_against_thirty_digits(case: dict[str, Any]) -> None:
    result = slide(motion=motion(case), **posed(case))
    wanted = [float(part) for part in case["rest"]]
    size = float(case["path"]) + 1.0
    assert result.rest_position == pytest.approx(wanted, rel=0.0, abs=CLOSE * size)
    assert result.rest_heading == pytest.approx(float(case["nose"]), abs=CLOSE * size)
    assert result.time == pytest.approx(float(case["time"]), CLOSE)
    assert result.path_length == pytest.approx(float(case["path"]), CLOSE)
    assert result.turned_about == (None if case["about"] is None else WHEELS[case["about"]].replace("_", " "))
    assert all(check.passed for check in result.checks)
    assert sum(wheel.energy_share for wheel in result.wheels) == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize("case", CASES[:4], ids=[case["name"] for case in CASES[:4]])
def test_back_from_rest(case: dict[str, Any]) -> None:
    rest = float(case["rest"][0]), float(case["rest"][1])
    result = slide(motion=AtRest(rest, float(case["nose"])), **posed(case))
    wanted = motion(case)
    assert result.speed == pytest.approx(wanted.speed, 1e-6)
    assert result.course == pytest.approx(wanted.course, abs=1e-6)
    assert result.spin == pytest.approx(wanted.spin, abs=1e-6 * wanted.speed)
    assert result.rest_position == pytest.approx(rest, abs=1e-6)


def test_locked_without_spin_it_slides_straight() -> None:
    result = slide(motion=Separation(12.0, 30 * DEGREE), mass=1500.0, **CAR)
    distance = 144.0 / (2.0 * 0.7 * 9.80665)
    assert result.path_length == pytest.approx(distance, 1e-7)
    assert result.rest_heading == pytest.approx(0.0, abs=1e-9)
    assert result.mean_share == pytest.approx(1.0, abs=1e-7)
    assert result.energy == pytest.approx(0.5 * 1500.0 * 144.0)
    assert result.time == pytest.approx(12.0 / (0.7 * 9.80665), 1e-7)


def test_drag_as_skid_spin_counts_it() -> None:
    result = slide(motion=Separation(5.0, 0.0, -7.0), **{**CAR, "nose": 90 * DEGREE})
    assert result.mean_share == pytest.approx(0.37871424, abs=1e-7)


@pytest.mark.parametrize(
    ("offset", "width"), [(-20.0, None), (0.0, None), (3.0, None), (6.0, None), (40.0, None), (3.0, 2.5), (-1.0, 4.0)]
)
def test_ground_beyond_an_edge(offset: float, width: float | None) -> None:
    """Straight over the edge: the front wheels cross it before the rear ones, and their loads are known."""
    grass = Ground(0.35, (offset, 10.0), (offset, -10.0), width, patch=width is not None)
    # left of the line downwards is to its right
    result = slide(motion=Separation(11.0, 0.0), grounds=(grass,), **CAR)
    front, rear = 1.4 / 2.6, 1.2 / 2.6

    def work(way: float) -> float:
        reach = math.inf if width is None else width
        beyond, after = (
            min(max(way + place - offset, 0.0), reach) - min(max(place - offset, 0.0), reach) for place in (1.2, -1.4)
        )
        return 9.80665 * (0.7 * way - 0.35 * (front * beyond + rear * after))

    low, high = 0.0, 60.0
    while high - low > 1e-10:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if work(middle) < 60.5 else (low, middle)
    assert result.path_length == pytest.approx(low, abs=1e-5)


MOTIONS = st.tuples(st.floats(2.0, 16.0), st.floats(-3.0, 3.0), st.floats(-5.0, 5.0), st.floats(0.02, 1.0))


@given(MOTIONS, st.floats(-3.0, 3.0))
@settings(max_examples=15, deadline=None, derandomize=True)
def test_turned_and_mirrored_scenes(given_motion: tuple[float, float, float, float], turn: float) -> None:
    speed, course, spin, share = given_motion
    car = {**CAR, "braking": 0.05, "left_front": share}
    one = slide(motion=Separation(speed, course, spin), **car)
    other = slide(motion=Separation(speed, course + turn, spin), nose=turn, **car)
    assert other.turned == pytest.approx(one.turned, abs=1e-4)
    x, y = one.rest_position
    c, s = math.cos(turn), math.sin(turn)
    size = one.path_length + 1.0
    assert other.rest_position == pytest.approx((c * x - s * y, s * x + c * y), abs=1e-4 * size)
    swapped = {**CAR, "braking": 0.05, "right_front": share}
    mirrored = slide(motion=Separation(speed, -course, -spin), **swapped)
    assert mirrored.rest_position == pytest.approx((x, -y), abs=1e-4 * size)
    # the same scene seen with y to the right, spins clockwise
    sae = slide(motion=Separation(speed, -course, -spin), axes=Axes("sae"), **car)
    assert sae.rest_position == pytest.approx((x, -y), abs=1e-4 * size)
    compass = slide(motion=Separation(speed, 0.5 * math.pi - course, spin), nose=0.5 * math.pi, axes=Axes("compass"),
                    **car)  # fmt: skip
    assert compass.rest_position == pytest.approx((x, y), abs=1e-4 * size)
    assert compass.turned == pytest.approx(-one.turned, abs=1e-4)


@given(MOTIONS)
@settings(max_examples=20, deadline=None, derandomize=True)
def test_energy_is_that_of_the_tyres(given_motion: tuple[float, float, float, float]) -> None:
    speed, course, spin, share = given_motion
    result = slide(motion=Separation(speed, course, spin), **{**CAR, "braking": share, "grip_slope": 0.08})
    assert all(check.passed for check in result.checks)
    assert result.path[0].position == (0.0, 0.0)
    assert result.path[-1].position == pytest.approx(result.rest_position)


def test_a_calculation_takes_milliseconds() -> None:
    slide(motion=Separation(3.0, 0.0, 1.0), **CAR)
    begin = time.process_time()
    for case in CASES[:3]:
        slide(motion=motion(case), **posed(case))
    # 20 ms each on the quiet machine of development; a loaded or slower one is allowed three times that
    assert (time.process_time() - begin) / 3 < 0.06


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"motion": Separation(0.0, 0.0)}, "neither moves nor turns"),
        ({"motion": AtRest((0.0, 0.0), 0.0)}, "neither moved nor turned"),
        ({"braking": 0.0}, "no wheel brakes"),
        ({"friction": 0.0}, "a friction is zero"),
        ({"front_axle": 0.0}, "mass centre is not between the axles"),
        ({"radius_of_gyration": 0.0}, "radius of gyration"),
        ({"grounds": (Ground(0.4, (1.0, 1.0), (1.0, 1.0)),)}, "no direction"),
        ({"grounds": (Ground(0.4, (1.0, 1.0), (2.0, 1.0), 0.0),)}, "has no width"),
    ],
)
def test_what_has_no_slide_is_refused(change: dict[str, Any], words: str) -> None:
    with pytest.raises(InadmissibleError, match=words):
        slide(**{"motion": Separation(5.0, 0.0), **CAR, **change})


def test_a_rest_that_nothing_leads_to_is_refused_with_the_miss(monkeypatch: pytest.MonkeyPatch) -> None:
    """Three equations for three unknowns nearly always have an answer; so the search is cut short here."""
    monkeypatch.setattr(back, "MOST_ROUNDS", 0)
    monkeypatch.setattr(back, "LAST_ROUNDS", 0)
    with pytest.raises(InadmissibleError, match=r"the nearest that was found ends 0\.\d+ m from the rest position"):
        slide(motion=AtRest((9.6, 5.6), 192 * DEGREE), **CAR)


def test_the_command_in_short_and_in_json() -> None:
    line = shlex.split(
        "impact slide --speed 43.2km/h --course 30deg --spin 3rad/s --front-axle 1.2m --rear-axle 1.4m --track 1.5m "
        "--radius-of-gyration 1.35m --friction 0.7 --braking 100%"
    )
    assert "[9.56341, 5.60082] m" in run(*line).out
    document = answer(*line)
    assert document["results"]["rest_heading"]["value"] == pytest.approx(192.32881, abs=1e-4)
    assert "speed" not in document["results"]


def test_the_picture_has_the_marks_and_outlines() -> None:
    result: SlideResult = slide(motion=Separation(12.0, 30 * DEGREE, 3.0), **CAR)
    picture = pictures.slide(result, motion=Separation(12.0, 30 * DEGREE, 3.0), **CAR)
    items = picture.panels[0].items
    words = " ".join(getattr(one, "label", "") or getattr(one, "text", "") for one in items)
    assert "at the separation\n12 m/s" in words
    assert "at rest" in words
    assert sum(getattr(one, "style", "") == "solid" for one in items) >= 4


def test_uncertain_inputs_against_a_sixteen_times_larger_sample() -> None:
    """Quantiles of 131,072 slides; a car on one locked wheel, whose nose ends along its course or goes on turning."""
    line = shlex.split(
        "impact slide --speed '10 ± 0.3 m/s' --course '0 ± 2 deg' --spin '2.5 ± 0.2 rad/s' --nose 20deg "
        "--front-axle 1.1m --rear-axle 1.5m --track 1.5m --radius-of-gyration 1.3m --friction '0.65 ± 0.03' "
        "--braking 2% --left-front 100% --grip-slope 0.15"
    )
    document = answer(*line)
    known = {
        "rest_heading": (167.5906, 177.1907, 193.0276, 6.5004),
        "time": (2.7898, 3.4227, 4.0283, 0.3168),
        "path_length": (10.3046, 13.1076, 16.2509, 1.5268),
    }
    spread = document["numerics"]["uncertainty"]
    for name, (low, median, high, deviation) in known.items():
        result, estimate = document["results"][name], spread["results"][name]["estimate"]
        found = (result["interval"][0], result["median"], result["interval"][1])
        assert estimate < 0.03, name
        assert found == pytest.approx((low, median, high), abs=(estimate + 0.01) * deviation), name
    assert spread["evaluations"] < 10_000


def test_a_spin_of_many_turns_a_second_is_pointed_out() -> None:
    found = slide(motion=Separation(11.0, 0.0, 15.0), **CAR)
    assert [note.code for note in found.advice if note.code == "fast-spin"] == ["fast-spin"]
    assert not slide(motion=Separation(11.0, 0.0, 5.0), **CAR).advice
