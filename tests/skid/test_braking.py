"""Speeds from marks and distances from speeds: laws that hold for any road, refusals, advice."""

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.skid.braking import Segment, distance, speed

LENGTH = st.floats(0.1, 200.0)
FRICTION = st.floats(0.1, 1.0)
GRADE = st.floats(-0.08, 0.2)
SPEED = st.floats(0.0, 60.0)
SEGMENT = st.builds(Segment, distance=LENGTH, friction=FRICTION, grade=GRADE, braking=st.floats(0.85, 1.0))
SEGMENTS = st.lists(SEGMENT, min_size=1, max_size=6).map(tuple)


@given(SEGMENT, SPEED, st.floats(0.0, 1.0))
def test_splitting_a_surface_changes_nothing(one: Segment, end: float, share: float) -> None:
    first = Segment(one.distance * share, one.friction, one.grade, one.braking)
    second = Segment(one.distance - first.distance, one.friction, one.grade, one.braking)
    whole, parts = speed(segments=one, end_speed=end), speed(segments=(first, second), end_speed=end)
    assert parts.speed == pytest.approx(whole.speed, rel=1e-14)
    assert parts.time == pytest.approx(whole.time, rel=1e-12)
    assert parts.total_distance == pytest.approx(one.distance, rel=1e-15)


@given(SEGMENTS, SPEED)
def test_marching_surface_by_surface_gives_the_same(segments: tuple[Segment, ...], end: float) -> None:
    whole = speed(segments=segments, end_speed=end)
    now = end
    for one, row in zip(reversed(segments), reversed(whole.surfaces), strict=True):
        assert row.exit_speed == pytest.approx(now, rel=1e-13)
        now = speed(segments=one, end_speed=now).speed
        assert row.entry_speed == pytest.approx(now, rel=1e-13)
    assert whole.speed == pytest.approx(now, rel=1e-13)
    assert [row.entry_speed for row in whole.surfaces[1:]] == [row.exit_speed for row in whole.surfaces[:-1]]


@given(SEGMENTS, SPEED, st.floats(500.0, 5000.0))
def test_energy_lost_is_friction_and_height(segments: tuple[Segment, ...], end: float, mass: float) -> None:
    answer = speed(segments=segments, end_speed=end, mass=mass)
    climbed = math.fsum(one.distance * math.sin(math.atan(one.grade)) for one in segments)
    assert answer.energy is not None
    assert answer.friction_work is not None
    lost = answer.energy - 0.5 * mass * end * end
    assert lost == pytest.approx(answer.friction_work + mass * 9.80665 * climbed, rel=1e-9, abs=1e-6)


@given(SEGMENT, SPEED, st.floats(0.1, 10.0))
def test_lengths_and_gravity_scale(one: Segment, end: float, factor: float) -> None:
    base = speed(segments=one, end_speed=end)
    longer = Segment(one.distance * factor, one.friction, one.grade, one.braking)
    scaled = speed(segments=longer, end_speed=end * math.sqrt(factor))
    assert scaled.speed == pytest.approx(base.speed * math.sqrt(factor), rel=1e-13)
    heavier = speed(segments=one, end_speed=end * math.sqrt(factor), gravity=9.80665 * factor)
    assert heavier.speed == pytest.approx(base.speed * math.sqrt(factor), rel=1e-13)


@given(SEGMENT, SPEED, st.floats(1.001, 2.0))
def test_more_of_anything_means_more_speed(one: Segment, end: float, factor: float) -> None:
    base = speed(segments=one, end_speed=end).speed
    assert (
        speed(segments=Segment(one.distance * factor, one.friction, one.grade, one.braking), end_speed=end).speed > base
    )
    assert (
        speed(segments=Segment(one.distance, one.friction * factor, one.grade, one.braking), end_speed=end).speed > base
    )
    assert (
        speed(segments=Segment(one.distance, one.friction, one.grade + 0.05, one.braking), end_speed=end).speed > base
    )
    assert speed(segments=one, end_speed=end + factor).speed > base


@given(SEGMENT, SPEED)
def test_distance_undoes_speed(one: Segment, end: float) -> None:
    fast = speed(segments=one, end_speed=end)
    back = distance(
        speed=fast.speed, friction=one.friction, grade=one.grade, braking=one.braking, end_speed=end, mark=one.distance
    )
    room = 1e-14 * fast.speed**2 / (2.0 * back.deceleration)
    assert back.distance == pytest.approx(one.distance, rel=1e-13, abs=room)
    assert back.time == pytest.approx(fast.time, rel=1e-11)
    assert back.exit_speed == pytest.approx(end, rel=1e-13, abs=1e-7 * fast.speed)


@pytest.mark.parametrize("grade", [-0.05, 0.0, 0.05])
def test_level_road_is_the_limit_of_slopes_from_both_sides(grade: float) -> None:
    exact = speed(segments=Segment(40.0, 0.7, grade)).speed
    for step in (1e-9, -1e-9):
        assert speed(segments=Segment(40.0, 0.7, grade + step)).speed == pytest.approx(exact, rel=2e-9)
    assert speed(segments=Segment(40.0, 0.7, -0.0)).speed == speed(segments=Segment(40.0, 0.7)).speed


def test_no_mark_leaves_the_end_speed() -> None:
    assert speed(segments=Segment(0.0, 0.7), end_speed=12.0).speed == 12.0
    assert speed(segments=Segment(0.0, 0.7)).time == 0.0
    assert distance(speed=12.0, friction=0.7, end_speed=12.0).distance == 0.0


def test_drag_that_does_not_slow_is_refused_with_its_number_and_place() -> None:
    with pytest.raises(InadmissibleError, match=r"segments\[1\]: the drag factor -0.0995037 is not above zero"):
        speed(segments=(Segment(10.0, 0.7), Segment(10.0, 0.0, -0.1)))
    with pytest.raises(InadmissibleError, match="drag factor 0 is not above zero"):
        distance(speed=10.0, friction=0.1, grade=-0.1)
    with pytest.raises(InadmissibleError, match="no segment"):
        speed(segments=())
    with pytest.raises(InadmissibleError, match="is no road"):
        speed(segments=Segment(10.0, 0.7, 1e200))


def test_end_speed_above_the_speed_is_refused() -> None:
    with pytest.raises(InadmissibleError, match="end speed 21 m/s exceeds the speed 20 m/s"):
        distance(speed=20.0, friction=0.7, end_speed=21.0)


def test_mark_that_exceeds_the_stop_is_refused_with_the_stop() -> None:
    with pytest.raises(InadmissibleError, match=r"mark of 40 m exceeds the stop.*at rest after 29.13") as caught:
        distance(speed=20.0, friction=0.7, mark=40.0)
    assert caught.value.code == "mark-exceeds-stop"
    stop = distance(speed=20.0, friction=0.7).distance
    assert distance(speed=20.0, friction=0.7, mark=stop).exit_speed == pytest.approx(0.0, abs=1e-6)


@given(SEGMENT, SPEED)
def test_energies_exist_only_with_a_mass(one: Segment, end: float) -> None:
    answer = speed(segments=one, end_speed=end)
    assert (answer.energy, answer.friction_work) == (None, None)
    assert all(check.passed for check in answer.checks)


def test_drag_by_difference_is_pointed_out() -> None:
    answer = speed(segments=(Segment(10.0, 0.7), Segment(10.0, 0.1, -0.095)))
    assert [advice.code for advice in answer.advice] == ["drag-by-difference"]
    assert "segments[1]" in answer.advice[0].message
    assert answer.advice[0].severity == "caution"
    assert speed(segments=Segment(10.0, 0.1, -0.0999)).advice[0].severity == "serious"
    assert not speed(segments=Segment(10.0, 0.7, -0.1)).advice


@given(st.floats(1e-150, 1e150), FRICTION)
def test_answers_stay_finite(length: float, friction: float) -> None:
    assume(length > 0.0)
    answer = speed(segments=Segment(length, friction))
    assert 0.0 < answer.speed < math.inf
    assert math.isfinite(answer.time)
