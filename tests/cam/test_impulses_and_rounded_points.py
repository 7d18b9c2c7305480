"""Accelerations that are impulses, and what points of a table that end at some decimal leave open."""

import random
from math import cos, pi, radians

import pytest
from harness import answer

from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.normalised import law_named
from dynamics_cli.cam.laws.polynomials import spline
from dynamics_cli.cam.laws.rise import rise
from dynamics_cli.cam.laws.rounded_points import decimal_step, effects
from dynamics_cli.cam.laws.selection import SplinePoint
from dynamics_cli.cam.program.reading import Move, Point, Program, Segment
from dynamics_cli.cam.program.revolution import motion


@pytest.mark.parametrize(("unit", "swing"), [("mm", False), ("deg", True)])
def test_where_the_velocity_jumps_the_acceleration_has_no_extreme(unit: str, swing: bool) -> None:
    line = f"rise 10 {unit} in 90 deg linear; dwell 90 deg; return in 90 deg linear; dwell"
    found = answer("cam", "motion", "--program", line, "--shaft-speed", "600 rpm")
    results, bounds = found["results"], found["numerics"]["error_bound"]
    own = results["swing"] if swing else results["acceleration"]
    least, greatest = ("least_acceleration", "greatest_acceleration") if swing else ("least", "greatest")
    timed = results["swing_in_time" if swing else "in_time"]
    assert own[least] is own[greatest] is timed["acceleration"] is timed["rms_acceleration"] is None
    assert results["rms_swing_acceleration" if swing else "rms_acceleration"] is None
    assert not [name for name in bounds if "acceleration" in name and "table" not in name]
    if not swing:
        assert (own["least_at"]["value"], own["greatest_at"]["value"]) == (90.0, 0.0)
    messages = [one["message"] for one in found["warnings"] if one["code"] == "infinite-acceleration"]
    assert any("impulse where the velocity jumps, at 90 deg" in message for message in messages)


def test_a_velocity_that_only_jumps_up_leaves_the_least_acceleration() -> None:
    found = motion(Program(), program="rise 10 mm in 180 deg half-cycloid-end; return in 180 deg half-cycloid-start")
    assert found.acceleration.greatest is None
    # at x = ½ of either half: −π h/β²
    assert found.acceleration.least == pytest.approx(-0.01 / pi, rel=1e-14)
    assert found.rms_acceleration is None


def changes(exact, rounded) -> list[float]:
    """The greatest change of velocity, acceleration and jerk at the joints of two splines of the same places."""
    most = [0.0] * 3
    for x in (0.0, *exact.breaks, 1.0):
        for side in (-1, 1):
            one, two = exact.at(x, 3, side), rounded.at(x, 3, side)
            most = [max(m, abs(a - b)) for m, a, b in zip(most, one[1:], two[1:], strict=True)]
    return most


@pytest.mark.parametrize("seed", range(10))
def test_no_rounding_of_the_points_moves_a_spline_further_than_stated(seed: int) -> None:
    chance = random.Random(seed)
    law = law_named(chance.choice(("cycloidal", "3-4-5", "modified-sine")))
    count, digits = chance.randint(5, 30), chance.choice((2, 3, 4))
    inner = (
        sorted(chance.uniform(0.02, 0.98) for _ in range(count)) if seed % 2 else [k / count for k in range(1, count)]
    )
    points = [(x, law.at(x)[0]) for x in inner]
    cut = [(x, round(f, digits)) for x, f in points]
    worst = [(x, f + (0.5 if i % 2 else -0.5) * 10.0**-digits) for i, (x, f) in enumerate(points)]
    made = [spline([(0.0, 0.0), *some, (1.0, 1.0)], 0.0, 0.0) for some in (points, cut, worst)]
    stated = effects(made[1], 0.0, 10.0**-digits)
    for other in made[1:]:
        assert all(
            change <= bound * (1.0 + 1e-9) for change, bound in zip(changes(made[0], other), stated, strict=True)
        )
    if not seed % 2 and count > 10:
        # by turns up and down: the bound of acceleration and jerk is reached
        assert changes(made[0], made[2])[1] >= 0.9 * stated[1]
        assert changes(made[0], made[2])[2] >= 0.9 * stated[2]


def table(count: int, digits: int) -> list[tuple[float, float]]:
    return [(k / count, round(0.5 - 0.5 * cos(pi * k / count), digits)) for k in range(1, count)]


def test_a_rise_through_rounded_points_says_what_that_leaves_open() -> None:
    points = table(40, 4)
    found = rise(
        law=LawName("spline"), lift=0.01, span=1.0, points=tuple(SplinePoint(x, f) for x, f in points), at=(0.5,)
    )
    (said,) = [one for one in found.advice if one.code == "rounded-points"]
    assert said.severity == "caution"
    assert "multiples of 0.0001 of the rise" in said.message
    # half a step, 12/h² times: 12 · 5e-5 · 1600 = 0.96 of the peak, which is about π²/2
    share = float(said.message.split("are off by up to ")[1].split(", ")[1].split(" and ")[0])
    peak = found.peak_acceleration / 0.01
    assert share == pytest.approx(0.96 / peak, rel=0.05)
    assert abs(peak - pi**2 / 2) <= share * peak
    exact = rise(
        law=LawName("spline"), lift=0.01, span=1.0, at=(0.5,),
        points=tuple(SplinePoint(k / 40, 0.5 - 0.5 * cos(pi * k / 40)) for k in range(1, 40)),
    )  # fmt: skip
    assert not [one for one in exact.advice if one.code == "rounded-points"]


def test_a_program_through_rounded_points_says_so_in_any_unit() -> None:
    for unit in (1e-3, 0.0254):
        points = tuple(Point(radians(90 * x), 10 * unit * f) for x, f in table(18, 3))
        segments = (
            Segment(Move("rise"), radians(90.0), lift=10 * unit, law=LawName("spline"), points=points),
            Segment(Move("dwell"), radians(90.0)), Segment(Move("return"), radians(90.0)), Segment(Move("dwell")),
        )  # fmt: skip
        (said,) = [one for one in motion(Program(segments)).advice if one.code == "rounded-points"]
        assert said.message.startswith("segment 1: the lifts of the points are multiples of 0.001 of the rise")


def test_the_decimal_step_is_the_largest_that_fits() -> None:
    assert decimal_step([0.5, 0.25]) == 0.01
    assert decimal_step([0.0254 * 1.234, 0.0254 * 5.1], (1.0, 0.0254)) == pytest.approx(0.0254e-3)
    assert decimal_step([1 / 3]) == 0.0
