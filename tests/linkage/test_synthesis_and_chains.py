"""Synthesis checked by analysis, and the small tasks: chains, bodies, sliders, refusals of each."""

from cmath import rect
from math import acos, cos, degrees, pi, radians

import pytest
from harness import answer, run

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.linkage.bodies.body import Place, Turning, TwoPoints, body
from dynamics_cli.linkage.bodies.chain import Angles, ChainLink, chain
from dynamics_cli.linkage.fourbar.closure import Branch
from dynamics_cli.linkage.fourbar.four_bar import four_bar
from dynamics_cli.linkage.fourbar.grashof import classify
from dynamics_cli.linkage.fourbar.synthesis import (
    AnglePairs,
    Pair,
    Pose,
    Poses,
    PosesOnPivots,
    QuickSwing,
    Synthesis,
    synthesize,
)
from dynamics_cli.linkage.sliders.driven import Pin
from dynamics_cli.linkage.sliders.pictures import moving_slider
from dynamics_cli.linkage.sliders.quick_return import quick_return
from dynamics_cli.linkage.sliders.slider_crank import slider_crank


def lengths(made: Synthesis) -> dict[str, float]:
    return {name: getattr(made, name) for name in ("crank", "coupler", "rocker", "ground")}


@pytest.mark.parametrize("step", [0.3, 0.6, -0.2])
def test_three_pairs_are_met(step: float) -> None:
    pairs = tuple(Pair(0.5 * k + 0.1, 0.9 + step * k) for k in range(3))
    made = synthesize(task=AnglePairs(pairs, 0.1))
    for met in made.met or ():
        pose = four_bar(**lengths(made), crank_angle=met.crank_angle, branch=Branch(met.branch))
        assert pose.rocker_angle is not None
        assert cos(pose.rocker_angle - met.rocker_angle) == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize(("swing", "ratio"), [(60.0, 1.2), (40.0, 1.0), (90.0, 1.05)])
def test_swing_and_time_ratio_are_kept(swing: float, ratio: float) -> None:
    made = synthesize(task=QuickSwing(radians(swing), ratio, 0.08))
    done = classify(**lengths(made))
    assert done.kind == "crank-rocker"
    assert done.swing is not None
    assert degrees(done.swing) == pytest.approx(swing, rel=1e-9)
    assert done.time_ratio == pytest.approx(ratio, rel=1e-9)
    assert max(lengths(made).values()) <= 3.0 * 0.08 * (1.0 + 1e-9)


def test_three_poses_are_met() -> None:
    poses = (Pose(0.0, 0.0, 0.0), Pose(0.05, 0.03, radians(20.0)), Pose(0.11, 0.02, radians(55.0)))
    made = synthesize(task=Poses(poses, (0.0, 0.0), (0.06, 0.01)))
    assert made.crank_pivot is not None
    assert made.rocker_pivot is not None
    for pose in poses:
        turn = rect(1.0, pose.angle)
        for pin, pivot, length in (
            ((0.0, 0.0), made.crank_pivot, made.crank),
            ((0.06, 0.01), made.rocker_pivot, made.rocker),
        ):
            place = complex(pose.x, pose.y) + turn * complex(*pin)
            assert abs(place - complex(*pivot)) == pytest.approx(length, rel=1e-12)


@pytest.mark.parametrize(
    ("task", "words"),
    [
        (AnglePairs((Pair(0.1, 0.2), Pair(0.3, 0.4)), 0.1), "three are needed"),
        (AnglePairs((Pair(0.1, 0.2), Pair(0.1, 0.2), Pair(0.3, 0.4)), 0.1), "are the same"),
        (
            Poses((Pose(0.0, 0.0, 0.0), Pose(0.1, 0.0, 0.0), Pose(0.2, 0.0, 0.0)), (0.0, 0.0), (1.0, 0.0)),
            "lie on a line",
        ),
        (QuickSwing(radians(190.0), 3.0, 0.1), "not between 0 and 180"),
        (QuickSwing(1.0, 0.8, 0.1), "at least 1"),
    ],
)
def test_tasks_without_a_linkage_are_refused(task: AnglePairs | Poses | QuickSwing, words: str) -> None:
    with pytest.raises(InadmissibleError, match=words):
        synthesize(task=task)


def test_relative_angles_of_a_chain_are_the_absolute_ones_summed() -> None:
    relative = chain(links=(ChainLink(0.3, 0.5, 2.0, 1.0), ChainLink(0.2, 0.4, -3.0, 2.0)), angles=Angles("relative"))
    absolute = chain(links=(ChainLink(0.3, 0.5, 2.0, 1.0), ChainLink(0.2, 0.9, -1.0, 3.0)))
    assert relative.position == pytest.approx(absolute.position)
    assert relative.acceleration == pytest.approx(absolute.acceleration)
    # v = Σ partial velocity × rate
    for made, rates in ((relative, (2.0, -3.0)), (absolute, (2.0, -1.0))):
        for i in (0, 1):
            total = sum(rate * joint.partial_velocity[i] for rate, joint in zip(rates, made.joints, strict=True))
            assert made.velocity[i] == pytest.approx(total)


def test_two_points_of_a_body() -> None:
    turning = body(point=(0.1, 0.2), velocity=(1.0, -2.0), acceleration=(0.5, 3.0), rest=Turning(4.0, -2.0),
                   places=(Place(0.4, -0.3),))  # fmt: skip
    assert turning.points is not None
    other = turning.points[0]
    back = body(point=(0.1, 0.2), velocity=(1.0, -2.0), acceleration=(0.5, 3.0),
                rest=TwoPoints(other.position, other.velocity, other.acceleration))  # fmt: skip
    assert (back.angular_velocity, back.angular_acceleration) == pytest.approx((4.0, -2.0))
    assert back.parting == pytest.approx(0.0, abs=1e-15)
    with pytest.raises(InadmissibleError, match="separate at"):
        body(point=(0.0, 0.0), velocity=(1.0, 0.0), rest=TwoPoints((1.0, 0.0), (2.0, 1.0)))
    with pytest.raises(InadmissibleError, match="coincide"):
        body(point=(0.0, 0.0), velocity=(1.0, 0.0), rest=TwoPoints((0.0, 0.0), (1.0, 0.0)))
    moved = body(point=(0.0, 0.0), velocity=(1.0, 2.0), rest=Turning(0.0))
    assert moved.instant_centre is None
    assert [one.code for one in moved.advice] == ["translation"]


def test_the_slider_crank_at_its_dead_centres() -> None:
    close = slider_crank(crank=0.05, rod=0.15, crank_angle=1e-7)
    assert close.travel == pytest.approx(3.3333333333333287037e-16, rel=1e-14)
    offset = slider_crank(crank=0.05, rod=0.15, offset=0.02)
    ends = degrees(offset.outer_at or 0.0), degrees(offset.inner_at or 0.0)
    assert ends == pytest.approx((5.73917047726679, 191.536959032815), rel=1e-14)
    line = slider_crank(crank=1.0, rod=3.5)
    assert degrees(line.top_at or 0.0) == pytest.approx(75.13558695385620715409, rel=1e-13)
    assert line.top_slope == pytest.approx(1.040244084128667156987, rel=1e-15)
    assert (offset.stroke, offset.time_ratio) == pytest.approx((0.101017897709996867, 1.06656389155424092))
    assert offset.outer_at is not None
    assert slider_crank(crank=0.05, rod=0.15, offset=0.02, crank_angle=offset.outer_at).slope == pytest.approx(
        0.0, abs=1e-16
    )
    short = slider_crank(crank=0.05, rod=0.03, crank_angle=0.1)
    assert short.stroke is None
    with pytest.raises(InadmissibleError, match="does not reach the slide"):
        slider_crank(crank=0.05, rod=0.03, crank_angle=1.0)
    with pytest.raises(InadmissibleError, match="perpendicular to the slide"):
        slider_crank(crank=0.05, rod=0.05, crank_angle=pi / 2.0, speed=1.0)
    assert moving_slider(None, 0.05, 0.03).count("<animate ") == 7


def test_slider_speed_against_differences_and_power() -> None:
    for angle in (0.4, 2.0, 5.0):
        made = slider_crank(crank=0.05, rod=0.15, offset=-0.01, crank_angle=angle, speed=3.0, load_force=200.0)
        ahead, behind = (
            slider_crank(crank=0.05, rod=0.15, offset=-0.01, crank_angle=angle + step) for step in (1e-6, -1e-6)
        )
        assert made.velocity == pytest.approx(
            3.0 * ((ahead.position or 0.0) - (behind.position or 0.0)) / 2e-6, abs=1e-9
        )
        assert (made.crank_torque or 0.0) * 3.0 == pytest.approx(200.0 * (made.velocity or 0.0))


def test_quick_returns_of_both_kinds() -> None:
    whitworth = quick_return(crank=0.12, ground=0.05)
    assert whitworth.kind == "turning lever (Whitworth)"
    assert whitworth.time_ratio == pytest.approx(quick_return(crank=0.05, ground=0.12).time_ratio)
    with pytest.raises(InadmissibleError, match="lies on the lever's pivot"):
        quick_return(crank=0.05, ground=0.05, crank_angle=0.0)
    # equal lengths: the lever turns at half the crank's speed
    made = quick_return(crank=0.05, ground=0.05, crank_angle=1.0, speed=2.0)
    assert made.lever_speed == pytest.approx(1.0)
    assert made.slip == pytest.approx(0.1 * cos(0.5))
    rows = quick_return(crank=0.05, ground=0.12, speed=2.0, steps=5).table or ()
    for row in rows:
        pose = quick_return(crank=0.05, ground=0.12, speed=2.0, crank_angle=row.crank_angle)
        assert row.lever_angle == pytest.approx((pose.lever_angle or 0.0) % (2.0 * pi))
        assert (row.lever_speed, row.lever_acceleration) == (pose.lever_speed, pose.lever_acceleration)
    # the pin passes through the lever's pivot at an angle of zero
    assert len(quick_return(crank=0.05, ground=0.05, steps=4).table or ()) == 3


def test_rows_uncertainty_and_unknown_units() -> None:
    rows = "crank[mm],coupler[mm],rocker[mm],ground[mm],crank_angle[deg]\n40,120,80,100,40\n3,2,2.5,4,90\n"
    done = run("linkage", "four-bar", "--rows", "-", stdin=rows)
    assert done.status == 4
    first, second = done.out.splitlines()[1:]
    assert ",57.3248800703608" in first
    assert "leave a gap of 0.5 mm" in second
    arm = ("--crank", "40 ± 0.1 mm", "--coupler", "120 mm", "--rocker", "80 mm", "--ground", "100 mm")
    made = answer("linkage", "four-bar", *arm, "--crank-angle", "40 deg")["results"]["rocker_angle"]
    one, other = (
        four_bar(crank=a, coupler=0.12, rocker=0.08, ground=0.1, crank_angle=radians(40.0)).rocker_angle or 0.0
        for a in (0.0401, 0.0399)
    )
    assert made["std"] == pytest.approx(abs(degrees(one - other)) / 2.0, rel=1e-3)
    assert "without" not in run("linkage", "four-bar", *arm, "--crank-angle", "40").out


@pytest.mark.parametrize("angle", [(), ("--crank-angle", "75 deg")])
def test_tolerances_have_stroke_swing_and_time_ratio(angle: tuple[str, ...]) -> None:
    """Results that arrays do not have are those of single samples."""
    lever = answer("linkage", "quick-return", "--crank", "50 ± 0.1 mm", "--ground", "120 mm", *angle)["results"]
    ends = [quick_return(crank=a, ground=0.12).time_ratio or 0.0 for a in (0.0501, 0.0499)]
    assert lever["time_ratio"]["std"] == pytest.approx((ends[0] - ends[1]) / 2.0, rel=1e-3)
    bars = ("--coupler", "120 mm", "--rocker", "80 mm", "--ground", "100 mm")
    wiper = answer("linkage", "four-bar", "--crank", "40 ± 0.1 mm", *bars, *angle)["results"]["swing"]
    swings = [classify(crank=a, coupler=0.12, rocker=0.08, ground=0.1).swing or 0.0 for a in (0.0401, 0.0399)]
    assert wiper["std"] == pytest.approx(degrees(swings[0] - swings[1]) / 2.0, rel=1e-3)


def test_pairs_of_many_turns_are_met() -> None:
    """Differences of angles of 1e8 turns lose eight digits; the linkage is that of the angles within a turn."""
    turn = 2.0 * pi * 1e8
    plain = (Pair(0.5, 1.0), Pair(1.0, 1.25), Pair(1.5, 1.6))
    many = (Pair(0.5, 1.0), Pair(1.0 + turn, 1.25), Pair(1.5, 1.6))
    made = synthesize(task=AnglePairs(many, 0.1))
    assert all(check.passed for check in made.checks)
    assert made.crank == pytest.approx(synthesize(task=AnglePairs(plain, 0.1)).crank, rel=1e-5)


def test_pivots_on_the_ground_and_pins_on_the_body_give_one_linkage() -> None:
    poses = (Pose(0.0, 0.0, 0.0), Pose(0.05, 0.03, radians(20)), Pose(0.08, 0.07, radians(60)))
    by_pins = synthesize(task=Poses(poses, (0.0, 0.0), (0.04, 0.0)))
    assert by_pins.crank_pivot
    assert by_pins.rocker_pivot
    by_pivots = synthesize(task=PosesOnPivots(poses, by_pins.crank_pivot, by_pins.rocker_pivot))
    assert by_pivots.first_pin == pytest.approx((0.0, 0.0), abs=1e-12)
    assert by_pivots.second_pin == pytest.approx((0.04, 0.0), abs=1e-12)
    assert by_pivots.crank == pytest.approx(by_pins.crank)


def test_the_smallest_transmission_angle_is_that_between_the_pairs() -> None:
    pairs = tuple(Pair(radians(a), radians(b)) for a, b in ((30, 60), (60, 80), (90, 110)))
    linkage = synthesize(task=AnglePairs(pairs, 0.1))
    a, b, c, d = linkage.crank, linkage.coupler, linkage.rocker, linkage.ground
    angles = []
    for step in range(601):
        square = a * a + d * d - 2.0 * a * d * cos(radians(30 + 0.1 * step))
        angle = acos((b * b + c * c - square) / (2.0 * b * c))
        angles.append(min(angle, pi - angle))
    assert linkage.least_transmission_angle == pytest.approx(min(angles), rel=1e-9)
    assert linkage.kind.startswith("triple rocker")
    assert not linkage.advice


@pytest.mark.parametrize(("angle", "pin"), [(60.0, "left"), (200.0, "right"), (300.0, "below"), (100.0, "above")])
def test_a_slider_drives_the_crank_as_the_crank_drives_the_slider(angle: float, pin: str) -> None:
    links = {"crank": 0.05, "rod": 0.15, "offset": 0.02}
    there = slider_crank(**links, crank_angle=radians(angle), speed=-30.0, angular_acceleration=7.0)
    assert there.position is not None
    back = slider_crank(
        **links, slider_position=there.position, slider_velocity=there.velocity,
        slider_acceleration=there.acceleration or 0.0, pin=Pin(pin),
    )  # fmt: skip
    assert back.crank_angle is not None
    assert degrees(back.crank_angle) % 360.0 == pytest.approx(angle, rel=1e-12)
    assert back.crank_speed == pytest.approx(-30.0, rel=1e-12)
    assert back.crank_acceleration == pytest.approx(7.0, rel=1e-9)
    assert back.rod_speed == pytest.approx(there.rod_speed, rel=1e-12)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("--slider-position 210mm", "10 mm too far from the crank's pivot"),
        ("--slider-position 90mm", "10 mm too near to the crank's pivot"),
        ("--slider-position 200mm --slider-velocity 1m/s", "a dead centre"),
        ("--slider-position 150mm --crank-angle 3deg", "both given"),
        ("--slider-velocity 1m/s", "belongs to one pose"),
    ],
)
def test_what_a_slider_cannot_drive_is_refused(words: str, message: str) -> None:
    refused = run("linkage", "slider-crank", "--crank", "50 mm", "--rod", "150 mm", *words.split())
    assert (refused.status, message in refused.err) == (3, True), refused.err


def test_an_uncertain_crank_has_a_fastest_pose() -> None:
    links = ("--crank", "50 ± 0.5 mm", "--rod", "150 mm", "--offset", "5 mm", "--crank-angle", "60 deg")
    results = answer("linkage", "slider-crank", *links, "--speed", "3000 rpm")["results"]
    # 4000 samples of the crank, each over 2880 angles
    assert results["top_at"]["mean"] == pytest.approx(288.32, abs=0.02)
    assert results["top_at"]["std"] == pytest.approx(0.13, rel=0.05)
    assert results["top_speed"]["mean"] == pytest.approx(16.76, abs=0.02)
