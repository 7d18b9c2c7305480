"""A short seeded run of tests/impact/crash_coverage.py; its head says how to run the long one."""

import pytest
from impact.crash_coverage import coverage, narrowest, scenes, speeds

from dynamics_cli.impact.conventions import ByMass
from dynamics_cli.impact.crash.scene import CrashScene, CrashVehicle, SegmentAfter
from dynamics_cli.impact.crash.solve import crash

DEGREE = 0.017453292519943295


def test_intervals_of_random_scenes_contain_the_truth() -> None:
    inside, answered = coverage(6, 5)
    assert answered == 6
    # 18 intervals of 95 %: fewer than 14 inside would happen once in a thousand
    assert sum(inside) >= 14


def test_intervals_of_paths_that_hardly_cross_are_not_narrower_than_samples() -> None:
    # half a million samples know a width to 0.2 %
    least, answered = narrowest(1, 3, 500_000)
    assert answered == 1
    # the program states its own error: up to 1.6 % of a width
    assert least > 0.984


def test_the_truth_of_a_scene_is_that_of_the_program() -> None:
    """Another formula, so the coverage is not of the program against itself."""
    scene = scenes(1, 7)[0]
    x = scene.true
    one = CrashVehicle(
        ByMass(x["one mass"]), x["one way"] * DEGREE, exit_heading=x["one exit"] * DEGREE,
        after=(SegmentAfter(x["one road"], friction=x["road"]), SegmentAfter(x["one grass"], friction=x["grass"])),
    )  # fmt: skip
    two = CrashVehicle(
        ByMass(x["two mass"]), x["two way"] * DEGREE, exit_heading=x["two exit"] * DEGREE,
        after=(SegmentAfter(x["two road"], friction=x["road"], braking=x["braking"]),),
    )  # fmt: skip
    made = crash(CrashScene(one, two))
    assert made.first.approach_speed == pytest.approx(float(speeds(x)[1]), 1e-12)
    assert made.second.approach_speed == pytest.approx(float(speeds(x)[2]), 1e-12)
