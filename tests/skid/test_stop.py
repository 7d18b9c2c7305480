"""A whole stop: phases join without a jump, the table is its own account of the motion, limits are met."""

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp, mpf

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.skid.braking import distance
from dynamics_cli.skid.stop import stop

SPEED = st.floats(0.5, 60.0)
FRICTION = st.floats(0.15, 1.0)
GRADE = st.floats(-0.08, 0.2)
TIME = st.floats(0.0, 3.0)
BUILD_UP = st.floats(0.0, 5.0)


@given(SPEED, FRICTION, TIME, GRADE)
def test_without_build_up_it_is_reaction_and_skid(v: float, friction: float, reaction: float, grade: float) -> None:
    answer = stop(speed=v, friction=friction, reaction_time=reaction, grade=grade)
    skid = distance(speed=v, friction=friction, grade=grade)
    assert answer.braking_distance == pytest.approx(skid.distance, rel=1e-15)
    assert answer.stopping_distance == pytest.approx(v * reaction + skid.distance, rel=1e-15)
    assert answer.build_up_distance is None
    assert answer.braking_speed == v
    assert {row.phase for row in answer.timeline} == {"reaction", "braking"}


@given(SPEED, FRICTION, TIME, BUILD_UP, st.integers(1, 9))
def test_the_table_is_continuous_and_ends_at_rest(
    v: float, mu: float, reaction: float, rise: float, steps: int
) -> None:
    answer = stop(speed=v, friction=mu, reaction_time=reaction, build_up_time=rise, steps=steps)
    rows = answer.timeline
    assert len(rows) == 1 + 3 * steps
    assert rows[-1].speed == 0.0
    assert rows[-1].time == pytest.approx(answer.stopping_time, rel=1e-14)
    assert rows[-1].distance == pytest.approx(answer.stopping_distance, rel=1e-14)
    for one, other in pairwise(rows):
        assert other.time >= one.time
        assert other.distance >= one.distance
        assert other.speed <= one.speed * (1.0 + 1e-14)
        # a path between two times lies between those of the two speeds
        gone, time = other.distance - one.distance, other.time - one.time
        room = 1e-12 * answer.stopping_distance
        assert other.speed * time - room <= gone <= one.speed * time + room


@given(SPEED, FRICTION, st.floats(0.01, 5.0))
def test_build_up_agrees_with_fine_steps(v: float, friction: float, rise: float) -> None:
    answer = stop(speed=v, friction=friction, reaction_time=0.0, build_up_time=rise)
    most = answer.deceleration
    # Simpson's rule is exact for the quadratic that the speed is while the deceleration rises
    assert answer.build_up_duration is not None
    assert answer.build_up_distance is not None
    duration = answer.build_up_duration

    def left(time: float) -> float:
        return v - most * time * time / (2.0 * rise)

    simpson = duration / 6.0 * (v + 4.0 * left(duration / 2.0) + left(duration))
    assert answer.build_up_distance == pytest.approx(simpson, rel=1e-12)
    assert answer.braking_speed == pytest.approx(max(left(duration), 0.0), abs=1e-12 * v)


@given(SPEED, FRICTION)
def test_limits_of_the_build_up_are_met_from_both_sides(v: float, friction: float) -> None:
    base = stop(speed=v, friction=friction, reaction_time=1.0)
    none = stop(speed=v, friction=friction, reaction_time=1.0, build_up_time=0.0)
    brief = stop(speed=v, friction=friction, reaction_time=1.0, build_up_time=1e-9)
    assert none.stopping_distance == pytest.approx(base.stopping_distance, rel=1e-14)
    assert brief.stopping_distance == pytest.approx(base.stopping_distance, rel=1e-7)
    corner = 2.0 * v / base.deceleration
    ends = [
        stop(speed=v, friction=friction, reaction_time=1.0, build_up_time=corner * (1.0 + step))
        for step in (-1e-9, 1e-9)
    ]
    assert ends[0].stopping_distance == pytest.approx(ends[1].stopping_distance, rel=1e-8)
    assert ends[1].braking_time == 0.0
    assert ends[1].braking_speed == 0.0


@given(SPEED, FRICTION, st.integers(-3, 3))
def test_at_the_corner_of_the_build_up_the_bounds_cover_both_sides(v: float, friction: float, ulps: int) -> None:
    rise = 2.0 * v / (9.80665 * friction)
    for _ in range(abs(ulps)):
        rise = math.nextafter(rise, math.inf if ulps > 0 else 0.0)
    one, mu, wait, grow, g = Tracked.inputs([v, friction, 0.0, rise, 9.80665])
    answer = stop(speed=one, friction=mu, reaction_time=wait, build_up_time=grow, gravity=g)  # type: ignore[arg-type]
    with mp.workdps(60):
        full, start = mpf(9.80665) * mpf(friction), mpf(v)
        duration = min(mpf(rise), mp.sqrt(2 * start * mpf(rise) / full))
        left = max(start - full * mpf(rise) / 2, mpf(0))
        truths = (duration, left, left / full, left * left / (2 * full))
    names = ("build_up_duration", "braking_speed", "braking_time", "braking_distance")
    for name, truth in zip(names, truths, strict=True):
        own = getattr(answer, name)
        assert abs(own.value - truth) <= own.error, name


@given(SPEED, FRICTION, TIME, st.floats(0.01, 1.0))
def test_slower_brakes_take_longer(v: float, friction: float, reaction: float, rise: float) -> None:
    without = stop(speed=v, friction=friction, reaction_time=reaction)
    with_rise = stop(speed=v, friction=friction, reaction_time=reaction, build_up_time=rise)
    assert with_rise.stopping_distance > without.stopping_distance
    assert with_rise.stopping_time > without.stopping_time
    assert math.isfinite(with_rise.stopping_time)


def test_refusals_give_the_deciding_number() -> None:
    with pytest.raises(InadmissibleError, match="cannot have 0 rows"):
        stop(speed=20.0, friction=0.7, reaction_time=1.0, steps=0)
    with pytest.raises(InadmissibleError, match="cannot have 10001 rows"):
        stop(speed=20.0, friction=0.7, reaction_time=1.0, steps=10001)
    with pytest.raises(InadmissibleError, match=r"drag factor of -0.09806"):
        stop(speed=20.0, friction=0.1, reaction_time=1.0, grade=-0.2)
