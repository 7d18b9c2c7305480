"""Undercut as lift lost: corners against a construction by brute force, merged, tiny, cut through, on both flanks."""

import random
from math import inf, pi, radians

import numpy as np
import pytest
from geometry_cases import CYCLE, KINDS, LAWS, NOTHING, STEEP, SWINGING, random_follower, random_program

from dynamics_cli.cam.forces.check import check
from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.analysis import analyse, runs_forward
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.geometry.corners import clearance
from dynamics_cli.cam.geometry.envelope import Envelope
from dynamics_cli.cam.geometry.profile import profile
from dynamics_cli.cam.geometry.undercut import lift_lost, seat
from dynamics_cli.cam.program.reading import motion_of
from dynamics_cli.cam.sizing import records, size
from dynamics_cli.errors import InadmissibleError

COUNT = 1500


def lost_by_force(geometry: Geometry, motion) -> float:
    """Lift lost with the cam as those points of the envelope that none of many positions of the follower covers."""
    theta = np.linspace(0.0, 2.0 * pi, COUNT, endpoint=False) + 1e-4
    fine = np.linspace(0.0, 2.0 * pi, 8 * COUNT, endpoint=False)
    touch = geometry.touch(*motion.at(fine, 2))
    points = (touch.point[0] + 1j * touch.point[1]) * np.exp(-1j * geometry.turn * fine)
    level = motion.at(theta, 0)[0]
    for angle, lift in zip(theta, level, strict=True):
        points = points[clearance(geometry, lift, points * np.exp(1j * geometry.turn * angle)) >= -1e-9]
    worst, drives = -inf, geometry.way * geometry.side
    for angle, lift in zip(theta, level, strict=True):
        rests = seat(geometry, np.array([angle]), points.real, points.imag)
        # a wall on the other side of the axis does not hold a roller up
        worst = max(worst, drives * lift - rests[rests < drives * lift + 1e-5].max())
    return worst


def agrees(found: float, forced: float) -> bool:
    """Points of a curve leave less of a cam than the curve does, by their spacing at a corner."""
    return found - 4e-6 <= forced <= 1.03 * found + 8e-6


@pytest.mark.parametrize(
    ("program", "follower", "corners"),
    [
        (STEEP, followers.Roller(0.015, 0.015), 2),
        (STEEP, followers.Roller(0.013, 0.014, 0.004), 2),
        (CYCLE, followers.FlatFace(0.012), 2),
        ("rise 25 deg in 60 deg cycloidal; dwell 60 deg; return in 60 deg cycloidal; dwell",
         followers.OscillatingRoller(0.015, 0.02, 0.08, 0.09), 1),
        ("rise 25 deg in 60 deg cycloidal; dwell 60 deg; return in 70 deg cycloidal; dwell",
         followers.OscillatingFlat(0.02, 0.1), 2),
        ("rise 20 mm in 60 deg linear; dwell 60 deg; return in 60 deg linear; dwell", followers.Roller(0.02, 0.01), 2),
        ("rise 20 mm in 60 deg linear; dwell 60 deg; return in 60 deg linear; dwell", followers.FlatFace(0.02), 2),
        ("rise 30 mm in 30 deg cycloidal; dwell 5 deg; return in 30 deg; dwell", followers.FlatFace(0.002), 1),
    ],
)  # fmt: skip
@pytest.mark.parametrize("rotation", ["ccw", "cw"])
def test_the_lift_lost_is_that_of_a_follower_lowered_onto_what_is_left(program, follower, corners, rotation) -> None:
    motion, geometry = motion_of(NOTHING, program), Geometry(follower, rotation)
    found = lift_lost(geometry, motion)
    assert found is not None
    assert found.lift > 1e-5
    assert len(found.corners) == corners
    assert agrees(found.lift, lost_by_force(geometry, motion))
    assert found.error < 1e-9


def random_undercut(chance: random.Random):
    """A follower too large for its motion, of any kind, on either flank."""
    kind = chance.choice(["roller", "flat", "arm", "rocker", "outer"])
    swing = kind in ("arm", "rocker")
    lift, unit = chance.uniform(8, 20 if swing else 30), "deg" if swing else "mm"
    up, down, top = chance.randint(40, 90), chance.randint(40, 90), chance.randint(1, 40)
    second = chance.choice(["", f"; rise {0.6 * lift:.3f} {unit} in 40 deg harmonic; return in 30 deg 3-4-5"])
    program = (
        f"rise {lift:.3f} {unit} in {up} deg {chance.choice(LAWS)}; dwell {top} deg; "
        f"return in {down} deg {chance.choice(LAWS)}{second}; dwell"
    )
    base, roller = chance.uniform(0.012, 0.03), chance.uniform(0.008, 0.02)
    follower = {
        "roller": followers.Roller(base, roller, chance.uniform(-0.3, 0.3) * base),
        "outer": followers.Roller(base, roller),
        "flat": followers.FlatFace(base),
        "arm": followers.OscillatingRoller(base, roller, 0.08, 0.09),
        "rocker": followers.OscillatingFlat(base, 0.1, chance.uniform(-0.003, 0.01)),
    }[kind]
    flank = "outer" if kind == "outer" else "inner"
    return program, Geometry(follower, chance.choice(["ccw", "cw"]), flank)


def test_random_undercuts_merged_or_not_against_brute_force() -> None:
    chance, merged, lone = random.Random(16), 0, 0
    for _ in range(24):
        program, geometry = random_undercut(chance)
        motion = motion_of(NOTHING, program)
        if geometry.flat and geometry.oscillating:
            speed = 1.0 + geometry.turn * motion.at(np.linspace(0.0, 6.28, 4000), 1)[1]
            if speed.min() <= 0.02:
                continue
        found, forced = lift_lost(geometry, motion), lost_by_force(geometry, motion)
        assert agrees(0.0 if found is None else found.lift, forced), program
        merged += found is not None and len(found.corners) < len(found.stretches)
        lone += found is not None and len(found.corners) == len(found.stretches)
    assert min(merged, lone) >= 5


def test_the_cost_of_a_small_undercut_grows_with_the_square_of_its_depth() -> None:
    base = size.size(NOTHING, program=STEEP, follower=records.Roller(0.015, 0.0), least_radius=0.0,
                     rise_limit=radians(89.0), return_limit=radians(89.0)).base_radius  # fmt: skip
    motion = motion_of(NOTHING, STEEP)
    costs = [lift_lost(Geometry(followers.Roller(base - depth, 0.015)), motion) for depth in (1e-5, 1e-6, 1e-7)]
    assert [len(cost.corners) for cost in costs] == [2, 2, 2]
    assert costs[0].lift == pytest.approx(3.984e-10, rel=1e-3)
    assert costs[1].lift == pytest.approx(1e-2 * costs[0].lift, rel=1e-3)
    assert costs[2].lift == pytest.approx(1e-4 * costs[0].lift, rel=1e-2)


def test_a_lobe_whose_neck_is_cut_through_falls_off() -> None:
    program = "rise 200 mm in 6 deg cycloidal; dwell 40 deg; return in 6 deg cycloidal; dwell"
    found = check(NOTHING, program=program, follower=followers.Roller(0.005, 0.02))
    assert found.undercut
    assert found.pieces_cut_off == 1
    assert found.lift_lost == pytest.approx(0.2, rel=0.01)
    assert "cut off" in found.advice[0].message


def test_nothing_left_around_the_axis_is_said_and_not_infinite() -> None:
    program = "return 30 mm in 90 deg cycloidal; dwell 90 deg; rise 30 mm in 90 deg cycloidal; dwell"
    found = check(NOTHING, program=program, follower=followers.FlatFace(0.012))
    assert found.undercut
    assert found.lift_lost is None
    assert found.advice[0].result == "lift_lost"


@pytest.mark.parametrize("base", [0.0, 1e-9])
def test_a_cam_that_comes_down_to_its_axis_is_answered(base: float) -> None:
    program = "rise 30 mm in 120 deg cycloidal; return in 120 deg cycloidal; dwell"
    round_ = lift_lost(Geometry(followers.Roller(base, 0.02)), motion_of(NOTHING, program))
    flat = lift_lost(Geometry(followers.FlatFace(base)), motion_of(NOTHING, program))
    assert round_ is None
    assert flat is not None
    assert flat.lift == pytest.approx(0.0017160084, rel=1e-6)


def test_an_outer_flank_lets_its_follower_overshoot() -> None:
    program = "rise 29.6 mm in 46 deg modified-sine; dwell 33 deg; return in 46 deg modified-sine; dwell"
    found = check(NOTHING, program=program, follower=followers.Roller(0.0193, 0.0121), flank=followers.Flank("outer"))
    assert found.undercut
    motion = motion_of(NOTHING, program)
    assert agrees(found.lift_lost, lost_by_force(Geometry(followers.Roller(0.0193, 0.0121), "ccw", "outer"), motion))
    assert "overshoot" in found.advice[0].message


def test_the_swing_of_a_second_follower_is_lost_alike() -> None:
    # a conjugate pair of one arm's length: the mirror image of the first cam with the motion upside down
    program = "rise 12 deg in 60 deg cycloidal; dwell 60 deg; return in 60 deg cycloidal; dwell"
    mirrored = "return 12 deg in 60 deg cycloidal; dwell 60 deg; rise 12 deg in 60 deg cycloidal; dwell"
    second = followers.ConjugateOscillatingRoller(0.03, 0.02, 0.08, 0.1, 1.0)
    geometry = Geometry(second)
    alone = Geometry(followers.OscillatingRoller(0.03, 0.02, 0.08, 0.1), "cw")
    alone.start = -geometry.start
    one, other = lift_lost(geometry, motion_of(NOTHING, program)), lift_lost(alone, motion_of(NOTHING, mirrored))
    assert one is not None
    assert other is not None
    assert one.lift == pytest.approx(other.lift, rel=1e-12)


def test_published_loss_of_a_deep_undercut() -> None:
    found = check(NOTHING, program=STEEP, follower=followers.Roller(0.015, 0.015))
    assert found.undercut_stretches == 2
    assert not found.fits
    assert found.lift_lost == pytest.approx(0.42e-3, abs=0.005e-3)
    assert found.least_convex_radius == pytest.approx(-3.7e-3, abs=0.05e-3)


@pytest.mark.parametrize("depth", [1e-7, 1e-8, 1e-10])
def test_an_undercut_between_samples_is_seen(depth: float) -> None:
    base = size.size(NOTHING, program=STEEP, follower=records.Roller(0.015, 0.0), least_radius=0.0,
                     rise_limit=radians(89.0), return_limit=radians(89.0)).base_radius  # fmt: skip
    sharp = check(NOTHING, program=STEEP, follower=followers.Roller(base - depth, 0.015))
    round_ = check(NOTHING, program=STEEP, follower=followers.Roller(base + depth, 0.015))
    assert (sharp.undercut, round_.undercut) == (True, False)
    assert (sharp.undercut_stretches, round_.undercut_stretches) == (2, 0)
    assert 0.0 <= sharp.lift_lost < depth
    assert round_.lift_lost is None
    # a table of 360 points shows none of it
    points = profile(NOTHING, program=STEEP, follower=followers.Roller(base - depth, 0.015)).points.arrays
    radii = points["radius_of_curvature"]
    assert not ((radii < 0.0) & (radii > -1e-3)).any()


def test_a_hollow_pitch_curve_undercuts_the_outer_flank_only() -> None:
    follower = followers.Roller(0.02, 0.016)
    inner = check(NOTHING, program=STEEP, follower=followers.Roller(0.05, 0.016))
    outer = check(NOTHING, program=STEEP, follower=follower, flank=followers.Flank("outer"))
    assert not inner.undercut
    assert outer.undercut == (outer.least_concave_radius <= 0.0)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(6))
def test_a_curve_proved_to_run_forwards_has_no_backward_stretch(kind: str, seed: int) -> None:
    chance = random.Random(f"{kind} {seed}")
    motion = motion_of(NOTHING, random_program(chance, swing=kind in SWINGING))
    follower = random_follower(chance, kind)
    for flank in ("inner", "outer") if getattr(follower, "roller_radius", 0.0) else ("inner",):
        geometry = Geometry(follower, chance.choice(("ccw", "cw")), flank)
        try:
            forward = runs_forward(geometry, analyse(geometry, motion))
        except InadmissibleError:
            continue
        assert forward == (not Envelope(geometry, motion).backward())
        if forward:
            assert lift_lost(geometry, motion, forward=True) == lift_lost(geometry, motion)


def test_a_cusp_that_rounding_leaves_open_is_said() -> None:
    base = size.size(NOTHING, program=CYCLE, follower=records.FlatFace()).base_radius
    codes = []
    for radius in (base, base * (1.0 + 1e-9), base * (1.0 - 1e-9)):
        found = check(NOTHING, program=CYCLE, follower=followers.FlatFace(radius))
        codes.append([one.code for one in found.advice if one.code in ("cusp", "undercut")])
    assert codes[0] in (["cusp"], ["undercut"])
    assert codes[1:] == [[], ["undercut"]]
