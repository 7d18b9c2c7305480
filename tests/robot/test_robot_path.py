"""Paths of hands: lines and arcs kept, speeds by differences, limits, jumps, refusals, pictures."""

import shlex
from math import atan2, hypot, pi, radians
from pathlib import Path

import pytest
from harness import run

from dynamics_cli.numerics.orientation.rotations import ByMatrix, Euler
from dynamics_cli.robot.arms.records import Arm
from dynamics_cli.robot.path.course import Profile, course_of
from dynamics_cli.robot.path.task import HandPath, path
from dynamics_cli.robot.pose import pose

PUMA = Arm(robot="puma-560")
DOWN = Euler(euler_angles=(0.0, pi / 2.0, 0.0), euler_order="XYZ")
CONSTANT = Profile("constant")


def puma(points: int = 51) -> HandPath:
    return path(
        PUMA, start=(0.45, 0.15, 0.9), end=(0.45, -0.25, 0.7), turn=DOWN, hand_turn=(0.0, 0.0, 0.4), duration=2.0,
        points=points,
    )  # fmt: skip


def test_the_hand_stays_on_its_line_and_turns_steadily() -> None:
    answer = puma()
    first = pose(PUMA, angles=answer.points[0].angles)
    for point in answer.points:
        at = pose(PUMA, angles=point.angles)
        assert at.position == pytest.approx(point.position, abs=1e-14)
        share = hypot(*(a - b for a, b in zip(point.position, (0.45, 0.15, 0.9), strict=True))) / answer.length
        # the hand's z axis is along x at the start, and turns about the base's z axis
        way = at.rotation_matrix[0][2], at.rotation_matrix[1][2]
        assert atan2(way[1], way[0]) == pytest.approx(0.4 * share, abs=1e-9)
    assert first.rotation_matrix[0][2] == pytest.approx(1.0)
    assert answer.jumps == 0


def test_speeds_are_the_differences_of_the_angles() -> None:
    answer = puma(2001)
    for before, at, after in zip(answer.points, answer.points[1:], answer.points[2:], strict=False):
        for a, speed, b in zip(before.angles, at.speeds, after.angles, strict=True):
            assert speed == pytest.approx((b - a) / (after.time - before.time), abs=2e-5)


def test_an_arc_goes_through_its_three_points() -> None:
    course = course_of((1.0, 0.0, 0.2), (-1.0, 0.0, 0.2), (0.0, 1.0, 0.2), ((1, 0, 0), (0, 1, 0), (0, 0, 1)), (0, 0, 0))
    assert course.length == pytest.approx(pi)
    assert course.position(0.5) == pytest.approx((0.0, 1.0, 0.2))
    assert course.position(1.0) == pytest.approx((-1.0, 0.0, 0.2))
    assert course.tangent(0.0) == pytest.approx((0.0, pi, 0.0))
    large = course_of((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, -1.0, 0.0), course.rotation, (0.0, 0.0, 0.0))
    assert large.length == pytest.approx(1.5 * pi)


def test_one_link_pair_by_hand() -> None:
    """Half way the hand is nearest to the base, at a distance of the links: a triangle of equal sides."""
    answer = path(
        Arm(lengths=(1.0, 1.0)), start=(1.0, 1.0, 0.0), end=(1.0, -1.0, 0.0), duration=2.0, profile=CONSTANT,
    )  # fmt: skip
    middle = answer.points[25]
    assert middle.position == pytest.approx((1.0, 0.0, 0.0))
    assert middle.angles == pytest.approx((-pi / 3.0, 2.0 * pi / 3.0))
    assert answer.peak_hand_speed == pytest.approx(1.0)
    # the distance does not change there: both links turn as one, at -v/r
    assert middle.speeds == pytest.approx((-1.0, 0.0))


def test_the_shortest_duration_has_the_fastest_joint_at_its_limit() -> None:
    arm, ends = Arm(lengths=(0.5, 0.4)), {"start": (0.7, 0.1, 0.0), "end": (0.2, 0.5, 0.0)}
    allowed = (radians(60.0), radians(60.0))
    first = path(arm, **ends, duration=2.0, max_speeds=allowed)
    assert first.within == "yes"
    again = path(arm, **ends, duration=first.shortest_duration, max_speeds=allowed)
    assert max(joint.share or 0.0 for joint in again.joints) == pytest.approx(1.0)
    assert path(arm, **ends, duration=1.0, max_speeds=allowed).within == "no, too fast"


def test_the_posture_that_stays_within_limits_is_taken() -> None:
    ends = {"start": (0.7, 0.1, 0.0), "end": (0.2, 0.5, 0.0), "duration": 1.0}
    right = path(Arm(lengths=(0.5, 0.4)), **ends)
    left = path(Arm(lengths=(0.5, 0.4), lower=(-3.0, -3.0), upper=(3.0, 0.0)), **ends)
    assert (right.posture, left.posture) == ("elbow right", "elbow left")
    assert left.within == "yes"


def test_limits_and_jumps_are_named() -> None:
    typed = '--lengths "500, 400 mm" --start "700, 100 mm" --end "200, 500 mm" --duration "2 s"'
    out = run(*shlex.split(f'robot path {typed} --lower "-180, 0 deg" --upper "10, 120 deg"'))
    assert "no, 1 beyond a limit" in out.out
    assert "joint 1 is beyond its limit from" in out.out + out.err
    through = '--lengths "500, 500 mm" --start "-300, 0 mm" --end "300, 0 mm" --duration "2 s"'
    out = run(*shlex.split(f"robot path {through}"))
    assert "at 1 s joint 1 jumps by" in out.out + out.err
    near = '--lengths "500, 400 mm" --start "-300, 100.01 mm" --end "300, 100.01 mm" --duration "2 s"'
    out = run(*shlex.split(f"robot path {near}"))
    assert "its elbow is 0.1812 deg" in out.out + out.err
    assert "posture changes" not in out.out + out.err


def test_a_wrist_that_passes_through_its_singular_posture_and_beside_it() -> None:
    """Through it the outer axes rest; 10 mm beside it they turn half a turn, at speeds that the table's rows miss."""
    start = tuple(map(radians, (0, 30, -100, 0, 20, 0)))
    end = tuple(map(radians, (0, 60, -90, 0, -20, 0)))
    first, last = (pose(PUMA, angles=angles) for angles in (start, end))
    turn = ByMatrix(first.rotation_matrix)
    through = path(PUMA, start=first.position, end=last.position, turn=turn, duration=1.0, near=start)
    assert through.jumps == 0
    assert through.points[-1].angles == pytest.approx(end, abs=1e-12)
    assert (through.joints[3].peak_speed, through.joints[5].peak_speed) == (0.0, 0.0)
    x, y, z = first.position
    aside = path(
        PUMA, start=(x, y + 0.01, z), end=(last.position[0], y + 0.01, last.position[2]), turn=turn, duration=1.0,
        near=start,
    )  # fmt: skip
    assert aside.jumps == 0
    assert (aside.joints[3].peak_speed or 0.0) > 90.0
    assert aside.within == "no, wrist 1 beyond a limit"


@pytest.mark.parametrize(
    ("call", "code"),
    [
        ('--lengths "500, 400 mm" --start "800, 300 mm" --end "800, -500 mm" --duration "2 s"', "out-of-reach"),
        ('--lengths "500, 400 mm" --start "900, 300 mm" --end "800, 0 mm" --duration "2 s"', "out-of-reach"),
        ('--lengths "500, 400 mm" --start "800, 300 mm" --end "800, 300 mm" --duration "2 s"', "no-path"),
        ('--lengths "500, 400 mm" --start "800, 300 mm" --end "700, 300 mm"', "no-duration"),
        ('--lengths "500, 400 mm" --start "800, 300 mm" --end "700, 300 mm" --duration "0 s"', "no-duration"),
        ('--lengths "500, 400 mm" --start "800, 0 mm" --via "700, 0 mm" --end "600, 0 mm" --duration "1 s"', "no-arc"),
        (
            '--lengths "500, 400 mm" --start "800, 0 mm" --end "600, 0 mm" --duration "1 s" --hand-turn "0, 0, 1 rad"',
            "no-wrist",
        ),
        ('--lengths "500, 400 mm" --start "800, 0 mm" --end "600, 0 mm" --duration "1 s" --points 1', "points"),
    ],
)
def test_refusals(call: str, code: str) -> None:
    out = run("robot", "path", *shlex.split(call), "--json")
    assert out.status in (2, 3)
    assert out.error["code"] == code


def test_how_far_the_path_can_go() -> None:
    """On the line x = 800 mm down to where it is 900 mm away."""
    typed = '--lengths "500, 400 mm" --start "800, 300 mm" --end "800, -500 mm" --duration "2 s"'
    reached = 300.0 + (900.0**2 - 800.0**2) ** 0.5
    assert f"{reached:.1f} mm after its start" in run(*shlex.split(f"robot path {typed}")).err


@pytest.mark.parametrize(
    "call",
    [
        '--lengths "500, 400 mm" --start "700, 100 mm" --end "200, 500 mm" --duration "2 s" --max-speeds "1, 1 rad/s"',
        '--robot puma-560 --start "450, 150, 900 mm" --end "450, -250, 700 mm" --euler-angles "0, 90, 0 deg" '
        '--euler-order XYZ --hand-speed "0.5 m/s"',
        'examples/scara.toml --start "300, 350, 320 mm" --via "400, 0, 300 mm" --end "300, -350, 320 mm" '
        '--hand-angle "0 deg" --hand-turn "0, 0, 90 deg" --duration "1 s"',
    ],
)
def test_pictures(call: str, tmp_path: Path) -> None:
    target = tmp_path / "picture.svg"
    outcome = run("robot", "path", *shlex.split(call), "--plot", str(target))
    assert outcome.status == 0, outcome.err
    assert b"nan" not in target.read_bytes()
