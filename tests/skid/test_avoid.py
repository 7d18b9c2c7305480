"""Avoidability: the sufficient speed stops exactly at the hazard, the speed at the hazard obeys energy, refusals."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.skid.avoid import avoid
from dynamics_cli.skid.stop import stop

SPEED = st.floats(0.5, 60.0)
SIGHT = st.floats(1.0, 200.0)
TIME = st.floats(0.0, 3.0)
FRICTION = st.floats(0.15, 1.0)
GRADE = st.floats(-0.08, 0.2)


@given(SPEED, SIGHT, TIME, FRICTION, GRADE)
def test_stops_and_impacts_obey_energy(v: float, sight: float, reaction: float, mu: float, grade: float) -> None:
    answer = avoid(speed=v, sight_distance=sight, reaction_time=reaction, friction=mu, grade=grade)
    whole = stop(speed=v, friction=mu, reaction_time=reaction, grade=grade)
    travelled = answer.approaches[0]
    assert travelled.stopping_distance == pytest.approx(whole.stopping_distance, rel=1e-14)
    # the difference is rounded at the size of the sight distance
    room = 1e-12 * whole.stopping_distance + 2.0**-52 * sight
    assert answer.margin == pytest.approx(sight - whole.stopping_distance, rel=0.0, abs=room)
    if Fraction(sight) <= Fraction(v) * Fraction(reaction):
        assert answer.impact_speed == v
        assert travelled.time == pytest.approx(sight / v, rel=1e-14)
    elif answer.avoidable:
        assert travelled.time == pytest.approx(whole.stopping_time, rel=1e-6)
    else:
        lost = 2.0 * whole.deceleration * (sight - v * reaction)
        assert answer.impact_speed**2 + lost == pytest.approx(v * v, rel=1e-12)
        braked = (v - answer.impact_speed) / whole.deceleration
        assert travelled.time == pytest.approx(reaction + braked, rel=1e-7)
    assert answer.avoidable == (answer.margin >= 0.0) == (answer.impact_speed == 0.0)
    assert all(check.passed for check in answer.checks)


@given(SIGHT, TIME, FRICTION, GRADE)
def test_the_sufficient_speed_stops_at_the_hazard(sight: float, reaction: float, mu: float, grade: float) -> None:
    enough = avoid(speed=10.0, sight_distance=sight, reaction_time=reaction, friction=mu, grade=grade).sufficient_speed
    again = stop(speed=enough, friction=mu, reaction_time=reaction, grade=grade)
    assert again.stopping_distance == pytest.approx(sight, rel=1e-13)
    for factor, avoidable in ((1.0 - 1e-9, True), (1.0 + 1e-9, False)):
        answer = avoid(speed=enough * factor, sight_distance=sight, reaction_time=reaction, friction=mu, grade=grade)
        assert answer.avoidable is avoidable
        assert answer.impact_speed == pytest.approx(0.0, abs=1e-3 * enough)


@given(SIGHT, TIME, FRICTION, GRADE)
def test_the_answer_at_the_sufficient_speed_never_contradicts_itself(
    sight: float, reaction: float, mu: float, grade: float
) -> None:
    given_ = {"sight_distance": sight, "reaction_time": reaction, "friction": mu, "grade": grade}
    enough = avoid(speed=10.0, **given_).sufficient_speed
    for step in (0.0, -math.inf, math.inf):
        for v in (enough, math.nextafter(enough, step)):
            answer = avoid(speed=v, **given_)
            assert answer.avoidable == (answer.margin >= 0.0) == (answer.impact_speed == 0.0)
            assert abs(answer.margin) <= 1e-14 * sight


@given(SIGHT, TIME, FRICTION, st.floats(1.01, 2.0))
def test_more_sight_or_friction_allows_more_speed(sight: float, reaction: float, mu: float, factor: float) -> None:
    def enough(**change: float) -> float:
        base = {"speed": 10.0, "sight_distance": sight, "reaction_time": reaction, "friction": mu}
        return avoid(**{**base, **change}).sufficient_speed

    assert enough(sight_distance=sight * factor) > enough()
    assert enough(friction=mu * factor) > enough()
    assert enough(reaction_time=reaction + factor) < enough()


@given(SPEED, SPEED, SIGHT, TIME, FRICTION)
def test_the_limit_is_judged_as_a_speed_travelled(
    v: float, limit: float, sight: float, reaction: float, mu: float
) -> None:
    both = avoid(speed=v, sight_distance=sight, reaction_time=reaction, friction=mu, speed_limit=limit)
    alone = avoid(speed=limit, sight_distance=sight, reaction_time=reaction, friction=mu)
    assert both.avoidable_at_limit == alone.avoidable
    assert both.margin_at_limit == alone.margin
    assert both.impact_speed_at_limit == alone.impact_speed
    assert [row.case for row in both.approaches] == ["travelled", "limit", "sufficient"]
    assert alone.avoidable_at_limit is None
    assert [row.case for row in alone.approaches] == ["travelled", "sufficient"]


def test_a_long_reaction_is_the_limit_of_distance_over_time() -> None:
    answer = avoid(speed=20.0, sight_distance=30.0, reaction_time=1e9, friction=0.7)
    assert answer.sufficient_speed == pytest.approx(3e-8, rel=1e-12)
    no_reaction = avoid(speed=20.0, sight_distance=30.0, reaction_time=0.0, friction=0.7)
    assert no_reaction.sufficient_speed == pytest.approx(math.sqrt(2.0 * 9.80665 * 0.7 * 30.0), rel=1e-15)


def test_a_close_call_is_pointed_out() -> None:
    def codes(v: float) -> list[str]:
        return [one.code for one in avoid(speed=v, sight_distance=50.0, reaction_time=1.5, friction=0.7).advice]

    assert codes(17.8) == ["close-call"]
    assert codes(17.9) == ["close-call"]
    assert codes(25.0) == []
    assert codes(10.0) == []


def test_refusals_give_the_deciding_number() -> None:
    with pytest.raises(InadmissibleError, match="the sight distance must be more than zero"):
        avoid(speed=20.0, sight_distance=0.0, reaction_time=1.0, friction=0.7)
    with pytest.raises(InadmissibleError, match=r"drag factor of -0.09806"):
        avoid(speed=20.0, sight_distance=30.0, reaction_time=1.0, friction=0.1, grade=-0.2)


def test_at_the_end_of_the_reaction_the_bound_covers_both_sides() -> None:
    # v·t rounds up to the sight distance that it is half a unit in the last place short of
    given_ = [0.034699316716686815, 0.04163918006002418, 1.2, 1.0631169876047193]
    names = ("speed", "sight_distance", "reaction_time", "friction")
    answer = avoid(**dict(zip(names, Tracked.inputs(given_), strict=True)))  # type: ignore[arg-type]
    v, sight, reaction, friction = (Fraction(x) for x in given_)
    squared = v * v - 2 * Fraction(9.80665) * friction * max(sight - v * reaction, Fraction(0))
    own = answer.impact_speed
    assert isinstance(own, Tracked)
    assert Fraction(own.value - own.error) ** 2 <= squared <= Fraction(own.value + own.error) ** 2
