"""Pedestrian throws: the flight and slide make the throw, the bounds hold for every angle they name, refusals."""

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.skid.pedestrian import pedestrian

G = 9.80665
FRICTION = st.floats(0.2, 1.2)
HEIGHT = st.floats(0.0, 1.5)


def reached_by(speed: float, angle: float, height: float, friction: float) -> tuple[float, float]:
    """Where a body thrown so comes to rest, and the speed it has left after landing, negative when landing stops it."""
    down = math.sqrt((speed * math.sin(angle)) ** 2 + 2.0 * G * height)
    time = (speed * math.sin(angle) + down) / G
    left = speed * math.cos(angle) - friction * down
    return speed * math.cos(angle) * time + max(left, 0.0) ** 2 / (2.0 * friction * G), left


def throw(speed: float, angle: float, height: float, friction: float) -> float:
    """Where a body thrown so comes to rest, or NaN when the landing stops it."""
    reached, left = reached_by(speed, angle, height, friction)
    return reached if left >= 0.0 else math.nan


@given(st.floats(3.0, 30.0), st.floats(-0.3, 0.9), HEIGHT, FRICTION)
def test_it_finds_the_speed_of_a_simulated_throw(speed: float, angle: float, height: float, friction: float) -> None:
    reached = throw(speed, angle, height, friction)
    assume(reached > 1.01 * friction * height)
    answer = pedestrian(throw_distance=reached, friction=friction, launch_angle=angle, launch_height=height)
    assert answer.speed == pytest.approx(speed, rel=1e-12)
    assert answer.flight_distance is not None
    assert answer.slide_distance is not None
    assert answer.flight_distance + answer.slide_distance == pytest.approx(reached, rel=1e-11)
    assert answer.least_speed <= speed * (1.0 + 1e-12)
    within = 0.0 <= angle <= answer.greatest_angle
    if within:
        assert speed <= answer.greatest_speed * (1.0 + 1e-12)
    assert ("beyond-greatest-angle" in [one.code for one in answer.advice]) is not within
    assert all(check.passed for check in answer.checks)


@given(st.floats(0.2, 60.0), st.floats(0.05, 3.0), st.floats(0.0, 3.0), st.floats(0.0, 1.0))
def test_the_greatest_speed_holds_exactly_up_to_the_greatest_angle(
    distance: float, friction: float, height: float, share: float
) -> None:
    assume(distance > 1.001 * friction * height)
    bounds = pedestrian(throw_distance=distance, friction=friction, launch_height=height)
    fast, angle = bounds.greatest_speed, bounds.greatest_angle
    # a faster throw goes farther, so the speed is enough where its throw reaches the distance
    assert reached_by(fast, share * angle, height, friction)[0] >= distance * (1.0 - 1e-9)
    assert reached_by(fast, 0.0, height, friction)[0] == pytest.approx(distance, rel=1e-9)
    assert reached_by(fast, angle, height, friction)[0] == pytest.approx(distance, rel=1e-9)
    assert reached_by(fast, angle + 1e-3, height, friction)[0] < distance or angle + 1e-3 > math.pi / 2
    assert angle <= 2.0 * math.atan(friction) * (1.0 + 1e-15)
    told = [one.code for one in bounds.advice]
    assert ("high-friction" in told) == (friction > 1.5)


@pytest.mark.parametrize("friction", [0.3, 0.57, 0.58, 0.66, 0.9, 1.4])
def test_greatest_angle_from_the_ground(friction: float) -> None:
    bounds = pedestrian(throw_distance=25.0, friction=friction)
    assert bounds.advice == ()
    if friction < math.tan(math.pi / 6):
        assert bounds.greatest_angle == 2.0 * math.atan(friction)
    else:
        limit = 0.5 * (math.pi - math.asin(0.5 / friction))
        assert bounds.greatest_angle == pytest.approx(limit, rel=1e-15)


def test_a_flight_that_landing_stops_can_need_more_than_a_slide() -> None:
    # 18.4 m/s at 66.84 degrees: within 2 atan 0.66, yet above the speed of a level launch
    bounds = pedestrian(throw_distance=25.0, friction=0.66)
    angle = math.radians(66.84)
    needed = math.sqrt(25.0 * G / math.sin(2.0 * angle))
    assert needed == pytest.approx(18.41, abs=0.01)
    assert needed > bounds.greatest_speed
    assert bounds.greatest_angle < angle < 2.0 * math.atan(0.66)


def test_a_throw_short_of_twice_friction_times_height_is_a_level_fall() -> None:
    bounds = pedestrian(throw_distance=1.0, friction=0.66, launch_height=1.0)
    assert bounds.greatest_speed == pytest.approx(math.sqrt(G / 2.0), rel=1e-15)
    assert bounds.greatest_angle == pytest.approx(math.pi / 4, rel=1e-15)


def needed(distance: float, angle: float, height: float, friction: float) -> float:
    """Speed whose simulated throw ends at the distance, by bisection; infinite when no speed reaches it."""
    low, high = 0.0, 1.0
    while reached_by(high, angle, height, friction)[0] < distance:
        high *= 2.0
        if high > 1e6:
            return math.inf
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if reached_by(middle, angle, height, friction)[0] < distance else (low, middle)
    return high


@given(st.floats(0.1, 1.2), st.floats(0.2, 1.5), st.floats(0.01, 0.999), st.floats(-0.7, 0.99))
def test_a_short_throw_ends_where_it_lands(friction: float, height: float, share: float, part: float) -> None:
    distance = share * friction * height
    bounds = pedestrian(throw_distance=distance, friction=friction, launch_height=height)
    assert [one.code for one in bounds.advice] == ["stops-where-it-lands"]
    lowest = -math.atan2(height, distance)
    angle = part * (bounds.greatest_angle if part > 0.0 else -lowest)
    answer = pedestrian(throw_distance=distance, friction=friction, launch_height=height, launch_angle=angle)
    assert answer.speed == pytest.approx(needed(distance, angle, height, friction), rel=1e-11)
    assert answer.speed is not None
    reached, left = reached_by(answer.speed, angle, height, friction)
    assert left <= 0.0
    assert reached == pytest.approx(distance, rel=1e-12)
    assert (answer.slide_time, answer.slide_distance) == (0.0, 0.0)
    assert answer.flight_distance == pytest.approx(distance, rel=1e-14)
    assert answer.least_speed <= answer.speed * (1.0 + 1e-14)
    if part >= 0.0:
        assert answer.speed <= answer.greatest_speed * (1.0 + 1e-14)
    assert all(check.passed for check in answer.checks)


@pytest.mark.parametrize(("distance", "height", "friction"), [(0.5, 1.0, 0.66), (0.66, 1.0, 0.66), (0.05, 1.2, 0.4)])
def test_bounds_of_a_short_throw_are_those_of_a_search_over_angles(
    distance: float, height: float, friction: float
) -> None:
    bounds = pedestrian(throw_distance=distance, friction=friction, launch_height=height)
    angles = [math.radians(0.1 * step) for step in range(-880, 890)]
    assert bounds.least_speed == pytest.approx(
        min(needed(distance, angle, height, friction) for angle in angles), rel=1e-5
    )
    level = needed(distance, 0.0, height, friction)
    assert bounds.greatest_speed == pytest.approx(level, rel=1e-12)
    assert needed(distance, bounds.greatest_angle, height, friction) == pytest.approx(level, rel=1e-12)
    assert needed(distance, bounds.greatest_angle + 1e-3, height, friction) > level


@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_both_sides_of_friction_times_height(sign: float) -> None:
    at, angle = 0.66 * 1.2 * (1.0 - 1e-12), 0.1
    beside = pedestrian(throw_distance=at * (1.0 + sign * 1e-9), friction=0.66, launch_height=1.2)
    limit = pedestrian(throw_distance=at, friction=0.66, launch_height=1.2, launch_angle=angle)
    assert beside.greatest_speed == pytest.approx(limit.greatest_speed, rel=1e-8)
    assert beside.greatest_angle == pytest.approx(limit.greatest_angle, rel=1e-8)
    assert ("stops-where-it-lands" in [one.code for one in beside.advice]) is (sign < 0.0)
    assert limit.speed == pytest.approx(needed(at, angle, 1.2, 0.66), rel=1e-12)


def test_rows_on_both_sides_are_answered_as_single_throws() -> None:
    import numpy as np

    distances = np.array([0.5, 0.66, 0.7, 5.0])
    rows = pedestrian(throw_distance=distances, friction=0.66, launch_height=1.0)  # type: ignore[arg-type]
    for index, distance in enumerate(distances.tolist()):
        alone = pedestrian(throw_distance=distance, friction=0.66, launch_height=1.0)
        for name in ("least_speed", "greatest_speed", "greatest_angle"):
            assert np.broadcast_to(getattr(rows, name), 4)[index] == pytest.approx(getattr(alone, name), rel=1e-15)


@given(st.floats(5.0, 60.0), FRICTION)
def test_bounds_are_reached(distance: float, friction: float) -> None:
    bounds = pedestrian(throw_distance=distance, friction=friction)
    least = pedestrian(throw_distance=distance, friction=friction, launch_angle=0.0)
    assert least.speed == pytest.approx(bounds.greatest_speed, rel=1e-15)
    assert bounds.speed is None
    best = math.atan(friction)
    if math.cos(best) > friction * math.sin(best):
        assert bounds.least_speed * math.hypot(1.0, friction) == pytest.approx(bounds.greatest_speed, rel=1e-14)
        answer = pedestrian(throw_distance=distance, friction=friction, launch_angle=best)
        assert answer.speed == pytest.approx(bounds.least_speed, rel=1e-14)


@given(st.floats(5.0, 60.0), FRICTION, HEIGHT, st.floats(1.01, 3.0))
def test_farther_is_faster_and_higher_is_slower(distance: float, friction: float, height: float, factor: float) -> None:
    base = pedestrian(throw_distance=distance, friction=friction, launch_height=height).least_speed
    farther = pedestrian(throw_distance=distance * factor, friction=friction, launch_height=height).least_speed
    assert farther > base
    assert pedestrian(throw_distance=distance, friction=friction, launch_height=height + 0.1).least_speed < base


def test_launch_height_zero_and_level_launch_are_limits() -> None:
    level = pedestrian(throw_distance=25.0, friction=0.66, launch_angle=0.0)
    assert (level.flight_time, level.flight_distance) == (0.0, 0.0)
    assert level.slide_distance == pytest.approx(25.0, rel=1e-15)
    for step in (1e-9, -1e-9):
        near = pedestrian(throw_distance=25.0, friction=0.66, launch_angle=step, launch_height=1e-18)
        assert near.speed == pytest.approx(level.speed, rel=1e-8)


@pytest.mark.parametrize(
    ("inputs", "message"),
    [
        ({"friction": 0.0}, "friction of 0 does not stop"),
        ({"throw_distance": 0.0, "launch_height": 1.0}, "throw distance of zero"),
        ({"throw_distance": 0.6, "launch_height": 1.0, "launch_angle": -1.1}, "-1.1 rad points below .* 1 m lower"),
        ({"launch_angle": math.pi / 2}, "at 1.5708 rad does not move"),
        ({"launch_angle": 1.2}, "landing stops the body at once: friction takes 11.* of the 6.6"),
        ({"launch_angle": -1.2}, "at -1.2 rad is stopped by its landing at once"),
    ],
)
def test_refusals_give_the_deciding_number(inputs: dict[str, float], message: str) -> None:
    with pytest.raises(InadmissibleError, match=message):
        pedestrian(**{"throw_distance": 25.0, "friction": 0.66, **inputs})


def thrown(speed: float, angle: float, friction: float, height: float) -> float:
    """How far a body comes: the flight, and the slide that the landing leaves; g is 9.80665."""
    g = 9.80665
    forward, up = speed * math.cos(angle), speed * math.sin(angle)
    landing = math.sqrt(up * up + 2.0 * g * height)
    kept = max(forward - friction * landing, 0.0)
    return forward * (up + landing) / g + kept * kept / (2.0 * friction * g)


def least_of_all(distance: float, friction: float, height: float) -> float:
    """The least speed over launch angles that comes so far, by bisection at each of many."""
    speeds = []
    for degree in range(-889, 890, 1):
        low, high = 0.0, 200.0
        for _ in range(60):
            middle = 0.5 * (low + high)
            short = thrown(middle, math.radians(0.1 * degree), friction, height) < distance
            low, high = (middle, high) if short else (low, middle)
        speeds.append(high)
    return min(speeds)


@pytest.mark.parametrize(
    ("distance", "friction", "height"),
    [
        (1.0001, 1.0, 1.0), (1.05, 1.0, 1.0), (1.5, 1.0, 1.0), (0.7, 0.66, 1.0), (0.66001, 0.66, 1.0), (0.9, 0.66, 1.0),
        (2.5, 0.66, 1.0), (25.0, 0.66, 1.0), (10.0, 0.66, 0.0), (10.0, 1.3, 0.0), (3.0, 0.3, 1.2), (0.5, 0.3, 1.2),
        (1.2, 1.4, 0.8), (2.0, 1.4, 0.8), (40.0, 1.4, 0.8),
    ],
)  # fmt: skip
def test_the_least_speed_is_that_of_some_launch(distance: float, friction: float, height: float) -> None:
    found = pedestrian(throw_distance=distance, friction=friction, launch_height=height)
    assert found.least_speed == pytest.approx(least_of_all(distance, friction, height), rel=2e-5)


def test_the_least_speed_has_no_step_where_the_landing_stops_every_throw() -> None:
    at = pedestrian(throw_distance=0.66, friction=0.66, launch_height=1.0).least_speed
    above = pedestrian(throw_distance=0.66 * (1.0 + 1e-12), friction=0.66, launch_height=1.0).least_speed
    assert above == pytest.approx(at, rel=1e-11)
