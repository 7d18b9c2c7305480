"""Spins: the mean of |sin ψ| is the integral it should be, shares and rotations agree, limits and refusals."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.skid.braking import Segment, speed
from dynamics_cli.skid.spin import Rotation, Share, mean_across, spin

START = st.floats(-10.0, 10.0)
TURN = st.floats(0.01, 40.0)


def across(start: float, rotation: float) -> float:
    """Mean of |sin| by the antiderivative, half-turn by half-turn."""

    def integral(x: float) -> float:
        turns = math.floor(x / math.pi)
        return 2.0 * turns + 1.0 - math.cos(x - turns * math.pi)

    return (integral(start + rotation) - integral(start)) / rotation


@given(START, TURN)
def test_mean_is_that_of_the_antiderivative(start: float, rotation: float) -> None:
    mean = mean_across(start, rotation)
    assert mean == pytest.approx(across(start, rotation), abs=1e-13 + 1e-15 / rotation)
    assert 0.0 <= mean <= 1.0


@given(START, TURN, st.floats(0.1, 0.9))
def test_parts_of_a_rotation_add(start: float, rotation: float, share: float) -> None:
    first = rotation * share
    parts = first * mean_across(start, first) + (rotation - first) * mean_across(start + first, rotation - first)
    assert parts == pytest.approx(rotation * mean_across(start, rotation), rel=1e-12, abs=1e-14)


@given(START, TURN)
def test_half_turns_and_mirrors_do_not_matter(start: float, rotation: float) -> None:
    mean = mean_across(start, rotation)
    assert mean_across(start + math.pi, rotation) == pytest.approx(mean, rel=1e-12, abs=1e-13)
    assert mean_across(-start - rotation, rotation) == pytest.approx(mean, rel=1e-12, abs=1e-13)


@pytest.mark.parametrize("start", [0.0, 0.5, math.pi / 2, math.pi, -math.pi, 3.0, -0.5])
def test_a_small_rotation_tends_to_the_sine(start: float) -> None:
    for turned in (1e-6, 1e-9, 1e-12):
        # the sine's own zero leaves half the rotation
        sine = abs(math.sin(start))
        assert mean_across(start, turned) == pytest.approx(sine, abs=turned)


def test_whole_half_turns_leave_two_over_pi() -> None:
    for count in (1, 2, 7, 1000):
        assert mean_across(0.7, count * math.pi) == pytest.approx(2.0 / math.pi, rel=1e-12)


@given(st.floats(0.5, 20.0), START, st.floats(0.0, 1.0), st.floats(0.0, 20.0))
def test_a_rotation_is_the_share_it_stands_for(turned: float, start: float, rolling: float, end: float) -> None:
    by_turn = spin(drag=Rotation(turned, start, rolling), distance=20.0, friction=0.7, end_speed=end)
    by_share = spin(drag=Share(by_turn.mean_share), distance=20.0, friction=0.7, end_speed=end)
    assert by_turn.speed == by_share.speed
    assert by_share.mean_yaw_rate is None
    assert by_turn.mean_yaw_rate == pytest.approx(turned / by_turn.time, rel=1e-15)
    assert by_turn.speed - by_turn.speed_lost == pytest.approx(end, rel=1e-13, abs=1e-13)
    assert all(check.passed for check in by_turn.checks)


@given(st.floats(0.5, 20.0), st.floats(-0.05, 0.2), st.floats(0.0, 20.0))
def test_locked_wheels_skid_whatever_the_rotation(turned: float, grade: float, end: float) -> None:
    locked = spin(drag=Rotation(turned, 0.3, 1.0), distance=20.0, friction=0.7, grade=grade, end_speed=end)
    skid = speed(segments=Segment(20.0, 0.7, grade), end_speed=end)
    assert locked.speed == pytest.approx(skid.speed, rel=1e-15)
    assert locked.time == pytest.approx(skid.time, rel=1e-14)


def test_a_short_rotation_is_pointed_out() -> None:
    assert [one.code for one in spin(drag=Rotation(0.3), distance=5.0, friction=0.7).advice] == ["short-rotation"]
    assert not spin(drag=Rotation(3.0), distance=5.0, friction=0.7).advice


def test_refusals_give_the_deciding_number() -> None:
    with pytest.raises(InadmissibleError, match=r"must be more than zero, not -1 rad"):
        spin(drag=Rotation(-1.0), distance=5.0, friction=0.7)
    with pytest.raises(InadmissibleError, match="the distance of a spin must be more than zero"):
        spin(drag=Rotation(1.0), distance=0.0, friction=0.7)
    with pytest.raises(InadmissibleError, match="more than zero, not 0 rad"):
        spin(drag=Rotation(0.0), distance=5.0, friction=0.7)
    with pytest.raises(InadmissibleError, match=r"drag factor of 0 is not above zero"):
        spin(drag=Share(0.0), distance=5.0, friction=0.7)
