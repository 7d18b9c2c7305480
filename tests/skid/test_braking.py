"""Speeds from marks and distances from speeds: laws that hold for any road, refusals, advice."""

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.skid.avoid import avoid
from dynamics_cli.skid.braking import Segment, distance, speed
from dynamics_cli.skid.diagnostics import balance
from dynamics_cli.skid.drag import Sled, drag_factor
from dynamics_cli.skid.friction import TestSkid as OneSkid
from dynamics_cli.skid.friction import friction
from dynamics_cli.skid.pedestrian import pedestrian
from dynamics_cli.skid.spin import Share, spin
from dynamics_cli.skid.vault import vault_known_angle
from dynamics_cli.skid.yaw import Radius, yaw

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
    with pytest.raises(InadmissibleError, match=r"segments\[1\]: the drag factor of -0.0995 is not above zero"):
        speed(segments=(Segment(10.0, 0.7), Segment(10.0, 0.0, -0.1)))
    with pytest.raises(InadmissibleError, match="drag factor of 0 is not above zero"):
        distance(speed=10.0, friction=0.1, grade=-0.1)
    with pytest.raises(InadmissibleError, match="no segment"):
        speed(segments=())
    with pytest.raises(InadmissibleError, match="is too steep"):
        speed(segments=Segment(10.0, 0.7, 1e200))


def test_end_speed_above_the_speed_is_refused() -> None:
    with pytest.raises(InadmissibleError, match="end speed of 21 m/s exceeds the speed of 20 m/s"):
        distance(speed=20.0, friction=0.7, end_speed=21.0)


def test_mark_that_exceeds_the_stop_is_refused_with_the_stop() -> None:
    with pytest.raises(InadmissibleError, match=r"mark of 40 m exceeds the stop.*at rest after 29.13") as caught:
        distance(speed=20.0, friction=0.7, mark=40.0)
    assert caught.value.code == "mark-exceeds-stop"
    stop = distance(speed=20.0, friction=0.7).distance
    assert distance(speed=20.0, friction=0.7, mark=stop).exit_speed == pytest.approx(0.0, abs=1e-6)


def test_a_mark_that_ends_at_the_stop_is_said_to_have_no_condition() -> None:
    exact = {"speed": 32.0, "friction": 0.5, "gravity": 16.0}
    at_stop = distance(**exact, mark=64.0)
    assert (at_stop.exit_speed, at_stop.exit_time) == (0.0, 4.0)
    assert [one.code for one in at_stop.advice] == ["mark-at-stop"]
    short = distance(**exact, mark=math.nextafter(64.0, 0.0))
    # √(2·8·2⁻⁴⁷), to the last bit
    assert short.exit_speed == math.sqrt(16.0 * (64.0 - math.nextafter(64.0, 0.0)))
    assert not short.advice


def test_what_leaves_the_range_of_a_double_is_refused() -> None:
    with pytest.raises(InadmissibleError, match="range of a double") as caught:
        speed(segments=Segment(1e-200, 1e-200))
    assert caught.value.code == "range"
    assert speed(segments=Segment(1e-200, 1e-200), end_speed=3.0).speed == 3.0
    for task, inputs in (
        (avoid, {"speed": 1e-170, "sight_distance": 1.0, "reaction_time": 1.0, "friction": 0.7}),
        (spin, {"drag": Share(1e-200), "distance": 1e-200, "friction": 0.7}),
        (pedestrian, {"throw_distance": 1e-200, "friction": 1e-200}),
    ):
        with pytest.raises(InadmissibleError, match="range of a double"):
            task(**inputs)


def test_numbers_that_no_road_has_are_pointed_out() -> None:
    def codes(**surface: float) -> list[tuple[str, str]]:
        return [(one.code, one.severity) for one in speed(segments=Segment(distance=10.0, **surface)).advice]

    assert codes(friction=0.7, grade=3.0) == [("steep-grade", "caution")]
    assert codes(friction=70.0) == [("high-friction", "caution")]
    assert codes(friction=70.0, grade=-3.0) == [("high-friction", "caution"), ("steep-grade", "caution")]
    assert codes(friction=1.5, grade=0.3) == codes(friction=1.5, grade=-0.3) == []
    several = speed(segments=(Segment(10.0, 0.7), Segment(10.0, 0.7, 3.0)))
    assert several.advice[0].message.startswith("segments[1]: grade of 3 is steeper")
    assert several.advice[0].remedy == "write 3 % for three percent"
    found = friction(skids=OneSkid(speed=48.0, distance=13.0)).advice
    assert [one.code for one in found] == ["high-friction", "one-test-skid"]
    level = yaw(path=Radius(30.0), friction=0.7, superelevation=-0.5).advice[0].message
    assert level.startswith("superelevation of -0.5")
    assert pedestrian(throw_distance=20.0, friction=66.0).advice[0].code == "high-friction"


def test_checks_keep_out_of_the_ends_of_the_range() -> None:
    for answer in (
        distance(speed=6.1e-101, friction=3.07e150, grade=0.0506),
        avoid(speed=0.436, sight_distance=8.8e-150, reaction_time=2.2e300, friction=2.82),
        speed(segments=Segment(5.5e99, 5.25e-323)),
        drag_factor(measurement=Sled(pull=3.4e-19, weight=1.25e300)),
        vault_known_angle(distance=2.1e-160, rise=-0.13, take_off=0.0),
    ):
        assert not answer.checks


def test_a_check_fails_on_a_wrong_formula_and_allows_for_rounding() -> None:
    assert balance("exact", 1.0, 1.0 + 1e-11, 1.0)[0].passed is False
    one, other = Tracked.inputs([1.0, 1.0 + 1e-11])
    assert balance("exact inputs", one, other, 1.0)[0].passed is False
    blurred = Tracked(1.0 + 1e-11, 2e-11, (0.0, 1.0))
    (check,) = balance("known only so far", one, blurred, 1.0)
    assert check.passed
    assert check.tolerance == pytest.approx(2e-11, rel=0.02)
    assert not balance("known not at all", one, Tracked(1.0, math.inf, (0.0, 1.0)), 1.0)


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
