"""Sizes that keep their limits and no smaller ones, and refusals."""

import random
from math import atan, hypot, pi, radians, tan

import numpy as np
import pytest
from geometry_cases import CYCLE, NOTHING, SWING, random_program

from dynamics_cli.cam.export.export import export
from dynamics_cli.cam.forces.check import check
from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.contact import turned_back
from dynamics_cli.cam.geometry.profile import profile
from dynamics_cli.cam.program.reading import motion_of
from dynamics_cli.cam.sizing import records, size
from dynamics_cli.cam.sizing.slides import best_slide
from dynamics_cli.errors import InadmissibleError

ARM = followers.OscillatingRoller(0.01, 0.005, 0.05, 0.1)
TOO_FAST = "rise 30 deg in 90 deg; return in 20 deg; dwell"


def brute(program: str, rise: float, back: float) -> float:
    """The smallest start radius over a fine grid of offsets, from dense samples."""
    motion = motion_of(NOTHING, program)
    theta = np.concatenate([zone.start + (zone.end - zone.start) * np.linspace(0, 1, 4001) for zone in motion.zones])
    s, s1 = motion.at(theta, 1)
    a, b = (s1 / tan(rise) - s).max(), (-s1 / tan(back) - s).max()
    low, high = -0.2, 0.2
    for _ in range(4):
        offsets = np.linspace(low, high, 20_001)
        heights = np.maximum(np.maximum(a - offsets / tan(rise), b + offsets / tan(back)), 0.0)
        radii = np.hypot(offsets, heights)
        best, step = offsets[radii.argmin()], offsets[1] - offsets[0]
        low, high = best - 3.0 * step, best + 3.0 * step
    return float(radii.min())


@pytest.mark.parametrize("seed", range(25))
def test_no_smaller_start_radius_keeps_two_pressure_angles(seed: int) -> None:
    chance = random.Random(seed)
    program = random_program(chance)
    rise, back = radians(chance.uniform(12, 60)), radians(chance.uniform(12, 60))
    found = size.size(NOTHING, program=program, follower=records.KnifeEdge(), rise_limit=rise, return_limit=back)
    assert found.start_radius == pytest.approx(brute(program, rise, back), rel=1e-6, abs=1e-12)
    assert found.largest_pressure_angle <= rise + 1e-12
    assert -found.least_pressure_angle <= back + 1e-12
    assert found.in_line_base_radius >= found.start_radius * (1.0 - 1e-12)
    assert all(one.passed for one in found.checks)


def test_a_foot_in_place_of_the_apex() -> None:
    # wide limits that differ: the apex would need an offset beyond the wedge
    e, d, binding = best_slide(0.02, 0.001, 1 / tan(radians(75)), 1 / tan(radians(80)))
    assert binding == "rise limit"
    c = 1 / tan(radians(75))
    assert hypot(e, d) == pytest.approx(0.02 / hypot(1.0, c), rel=1e-14)
    e2, d2, binding = best_slide(0.001, 0.02, 1 / tan(radians(80)), 1 / tan(radians(75)))
    assert (e2, d2, binding) == (pytest.approx(-e), pytest.approx(d), "return limit")


@pytest.mark.parametrize("rotation", ["ccw", "cw"])
def test_a_cam_turned_the_other_way_is_offset_the_other_way(rotation: str) -> None:
    limits = {"rise_limit": radians(25), "return_limit": radians(35)}
    found = size.size(
        NOTHING, program=CYCLE, follower=records.Roller(0.006), rotation=followers.Rotation(rotation), **limits
    )
    assert found.largest_pressure_angle == pytest.approx(radians(25), abs=1e-12)
    assert found.least_pressure_angle == pytest.approx(-radians(35), abs=1e-12)
    assert found.offset == pytest.approx((1 if rotation == "ccw" else -1) * 0.0016158053939, rel=1e-6)


@pytest.mark.parametrize("wanted", [0.002, 0.008, 0.02, 0.05])
@pytest.mark.parametrize("offset", [0.0, 0.005])
def test_a_radius_of_curvature_that_binds_is_met(wanted: float, offset: float) -> None:
    found = size.size(
        NOTHING, program=CYCLE, follower=records.Roller(0.006, offset), least_radius=wanted,
        rise_limit=radians(85), return_limit=radians(85),
    )  # fmt: skip
    assert found.binding == "least radius of curvature"
    assert found.least_convex_radius == pytest.approx(wanted, rel=1e-11)
    smaller = check(NOTHING, program=CYCLE, follower=followers.Roller(found.base_radius - 1e-9, 0.006, offset))
    assert smaller.least_convex_radius < wanted


def test_an_arm_keeps_its_limits_and_no_smaller_does() -> None:
    limit = radians(40)
    found = size.size(
        NOTHING,
        program=SWING,
        follower=records.OscillatingRoller(0.008, 0.08, 0.1),
        rise_limit=limit,
        return_limit=limit,
    )
    assert max(found.largest_pressure_angle, -found.least_pressure_angle) == pytest.approx(limit, abs=1e-12)
    smaller = check(
        NOTHING, program=SWING, follower=followers.OscillatingRoller(found.base_radius - 1e-6, 0.008, 0.08, 0.1)
    )
    assert max(smaller.largest_pressure_angle, -smaller.least_pressure_angle) > limit


@pytest.mark.parametrize(
    ("code", "call"),
    [
        ("limit", lambda: size.size(NOTHING, program=CYCLE, follower=records.Roller(0.006), rise_limit=0.0)),
        ("limit", lambda: check(NOTHING, program=CYCLE, follower=followers.FlatFace(0.05), rise_limit=-0.1)),
        ("limit", lambda: check(NOTHING, program=CYCLE, follower=followers.FlatFace(0.05), return_limit=2.0)),
        ("through-axis", lambda: export(NOTHING, program=CYCLE, follower=followers.KnifeEdge(0.0))),
        ("range", lambda: export(NOTHING, program=CYCLE, follower=followers.Roller(1e200, 0.006))),
        ("swing", lambda: check(
            NOTHING, program="rise 1e9 deg in 90 deg; return",
            follower=followers.OscillatingRoller(0.03, 0.008, 0.08, 0.1))),
        ("limit-binds", lambda: size.size(
            NOTHING, program=SWING, follower=records.OscillatingRoller(0.006, 0.1, 0.05))),
        ("offset", lambda: check(NOTHING, program=CYCLE, follower=followers.Roller(0.01, 0.005, 0.016))),
        ("no-triangle", lambda: check(NOTHING, program=SWING, follower=ARM)),
        ("pivot-inside", lambda: check(NOTHING, program=SWING, follower=followers.OscillatingFlat(0.05, 0.04))),
        ("lift-kind", lambda: check(NOTHING, program=CYCLE, follower=followers.OscillatingFlat(0.02, 0.08))),
        ("lift-kind", lambda: check(NOTHING, program=SWING, follower=followers.FlatFace(0.02))),
        ("face-too-fast", lambda: check(
            NOTHING, program=TOO_FAST, follower=followers.OscillatingFlat(0.03, 0.1))),
        ("flank", lambda: check(
            NOTHING, program=CYCLE, follower=followers.KnifeEdge(0.03), flank=followers.Flank("outer"))),
        ("spring", lambda: check(NOTHING, program=CYCLE, follower=followers.FlatFace(0.05), mass=0.2)),
        ("slack", lambda: check(
            NOTHING, program=CYCLE, follower=followers.FlatFace(0.05), mass=0.2, spring_rate=2e4, preload=0.0)),
        ("plate", lambda: profile(NOTHING, program=CYCLE, follower=followers.FlatFace(0.05), thickness=0.01)),
        ("arm-angle", lambda: check(
            NOTHING, program=SWING, follower=followers.ConjugateOscillatingRoller(0.03, 0.008, 0.08, 0.1, 0.1))),
    ],
)  # fmt: skip
def test_refusals(code: str, call) -> None:
    with pytest.raises(InadmissibleError) as error:
        call()
    assert error.value.code == code


def test_the_jump_speed_is_where_the_spring_lets_go() -> None:
    found = check(
        NOTHING,
        program=CYCLE,
        follower=followers.FlatFace(0.05),
        mass=0.2,
        spring_rate=2e4,
        preload=100.0,
        shaft_speed=150.0,
    )
    motion = motion_of(NOTHING, CYCLE)
    s, _, s2 = motion.at(found.jump_at, 2)
    assert 0.2 * s2 * found.jump_speed**2 + 2e4 * s + 100.0 == pytest.approx(0.0, abs=1e-9)
    theta = np.linspace(0.0, 2.0 * pi, 20_001)
    s, _, s2 = motion.at(theta, 2)
    assert (0.2 * s2 * (found.jump_speed * (1 - 1e-9)) ** 2 + 2e4 * s + 100.0).min() > 0.0
    assert found.jump_kept


def test_plates_of_one_breadth_and_of_known_shape() -> None:
    # an eccentric circle as a flat-faced cam: harmonic rise and return
    made = profile(NOTHING, program="rise 20 mm in 180 deg harmonic; return in 180 deg harmonic",
                   follower=followers.FlatFace(0.03), thickness=0.01, density=7800.0)  # fmt: skip
    assert made.area == pytest.approx(pi * 0.04**2, rel=1e-14)
    assert made.perimeter == pytest.approx(2 * pi * 0.04, rel=1e-14)
    assert hypot(made.centroid_x, made.centroid_y) == pytest.approx(0.01, rel=1e-13)
    assert made.inertia_about_centroid == pytest.approx(7800 * 0.01 * pi * 0.04**4 / 2, rel=1e-13)
    assert made.least_convex_radius == pytest.approx(0.04, rel=1e-14)
    assert made.face_width == pytest.approx(0.02, rel=1e-13)


def test_pressure_angle_of_the_book_in_line() -> None:
    made = profile(NOTHING, program=CYCLE, follower=followers.KnifeEdge(0.03), points=36)
    motion = motion_of(NOTHING, CYCLE)
    for angle, pressure in zip(made.points.arrays["cam_angle"], made.points.arrays["pressure_angle"], strict=True):
        s, s1 = motion.at(float(angle), 1)
        assert pressure == pytest.approx(atan(s1 / (0.03 + s)), abs=1e-15)


@pytest.mark.parametrize("rotation", ["ccw", "cw"])
def test_the_start_angle_turns_the_drawing(rotation: str) -> None:
    given = {
        "program": CYCLE,
        "follower": followers.Roller(0.025, 0.006, 0.004),
        "rotation": followers.Rotation(rotation),
    }
    plain, turned = profile(NOTHING, **given), profile(NOTHING, start_angle=0.7, **given)
    z = plain.points.arrays["x"] + 1j * plain.points.arrays["y"]
    w = turned.points.arrays["x"] + 1j * turned.points.arrays["y"]
    assert np.abs(w - z * np.exp(0.7j)).max() < 1e-16
    assert turned.area == pytest.approx(plain.area, rel=1e-14)


def test_a_conjugate_pair_holds_its_rollers_apart() -> None:
    first = profile(NOTHING, program=CYCLE, follower=followers.Roller(0.03, 0.008, 0.004)).points.arrays
    second = profile(NOTHING, program=CYCLE, follower=followers.ConjugateRoller(0.03, 0.008, 0.09, 0.004)).points.arrays
    apart = np.hypot(first["pitch_x"] - second["pitch_x"], first["pitch_y"] - second["pitch_y"])
    assert np.abs(apart - 0.09).max() < 1e-16


@pytest.mark.parametrize("least", [0.01, 0.05, 0.1])
def test_no_offset_beats_the_best_one_for_a_curvature_by_more_than_the_bound(least: float) -> None:
    limit = radians(30)

    def smallest(offset: float | None) -> records.CamSize:
        slide = records.Roller(0.006, offset)
        return size.size(
            NOTHING, program=CYCLE, follower=slide, rise_limit=limit, return_limit=limit, least_radius=least
        )

    found = smallest(None)
    assert found.numerics is not None
    bound = found.numerics.bounds[0].bound * found.base_radius
    others = [smallest(offset).base_radius for offset in np.linspace(-0.1, 0.1, 41)]
    assert min(others) >= found.base_radius - bound
    # and the offset found is kept by the size without a search
    assert smallest(found.offset).base_radius == pytest.approx(found.base_radius, rel=1e-12)
    assert found.in_line_base_radius is None


@pytest.mark.parametrize("count", [4, 8, 12, 36, 37, 1001])
@pytest.mark.parametrize("rotation", ["ccw", "cw"])
@pytest.mark.parametrize("start", [0.0, 0.5 * pi, -pi, 0.3])
def test_quarters_of_the_turn_are_exact_and_the_rest_is_right(count: int, rotation: str, start: float) -> None:
    turn = 1.0 if rotation == "ccw" else -1.0
    cos, sin = turned_back(count, start, turn)
    angle = turn * np.arange(count) * (2.0 * pi / count) - start
    assert np.abs(cos - np.cos(angle)).max() < 2e-15
    assert np.abs(sin - np.sin(angle)).max() < 2e-15
    if start != 0.3:
        assert not np.any((np.abs(cos) < 1e-12) & (cos != 0.0))
        assert not np.any((np.abs(sin) < 1e-12) & (sin != 0.0))
        assert not np.signbit(cos[cos == 0.0]).any()
