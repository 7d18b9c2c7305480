"""Drag factors by statics: both axles carry the weight, limits from both sides, refusals."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.skid.drag import Axles, Sled, Surface, drag_factor

FRICTION = st.floats(0.1, 1.0)
GRADE = st.floats(-0.08, 0.2)


@st.composite
def vehicles(draw: st.DrawFn) -> Axles:
    base = draw(st.floats(2.0, 4.0))
    front, rear = draw(FRICTION), draw(FRICTION)
    return Axles(front, rear, base, base * draw(st.floats(0.4, 0.6)), draw(st.floats(0.1, 0.75)), grade=draw(GRADE))


@given(vehicles())
def test_loads_share_the_weight_and_balance(axles: Axles) -> None:
    answer = drag_factor(measurement=axles)
    front, rear = answer.front_share, answer.rear_share
    assert front is not None
    assert rear is not None
    assert front + rear == pytest.approx(1.0, rel=1e-15)
    friction = axles.front_friction * front + axles.rear_friction * rear
    assert answer.effective_friction == pytest.approx(friction, rel=1e-13)
    static = (axles.wheelbase - axles.cm_position) / axles.wheelbase
    assert front - static == pytest.approx(answer.weight_transfer, abs=1e-14)
    assert all(check.passed for check in answer.checks)


@given(FRICTION, GRADE, vehicles())
def test_alike_axles_are_a_surface_wherever_the_mass_centre_is(friction: float, grade: float, axles: Axles) -> None:
    alike = Axles(friction, friction, axles.wheelbase, axles.cm_position, 0.3, grade=grade)
    plain = drag_factor(measurement=Surface(friction, grade))
    assert drag_factor(measurement=alike).drag_factor == pytest.approx(plain.drag_factor, rel=1e-13)


@given(vehicles(), st.floats(0.01, 0.3))
def test_a_higher_mass_centre_helps_the_front_brakes(axles: Axles, more: float) -> None:
    def braked(height: float, front: float, rear: float) -> float:
        given = Axles(0.6, 0.6, axles.wheelbase, axles.cm_position, height, front, rear)
        return drag_factor(measurement=given).drag_factor

    assert braked(0.4 + more, 1.0, 0.0) > braked(0.4, 1.0, 0.0)
    assert braked(0.4 + more, 0.0, 1.0) < braked(0.4, 0.0, 1.0)


@given(FRICTION, st.floats(-0.3, 0.6), GRADE)
def test_a_sled_pulled_over_a_surface_measures_it(friction: float, angle: float, grade: float) -> None:
    road = math.atan(grade)
    weight = 180.0
    # equilibrium of the sled, solved for the pull
    pull = weight * (friction * math.cos(road) + math.sin(road)) / (math.cos(angle) + friction * math.sin(angle))
    answer = drag_factor(measurement=Sled(pull, weight, angle, grade))
    assert answer.effective_friction == pytest.approx(friction, rel=1e-12)
    assert answer.drag_factor == pytest.approx(drag_factor(measurement=Surface(friction, grade)).drag_factor, rel=1e-12)
    assert all(check.passed for check in answer.checks)


def test_a_level_pull_is_the_drag_factor_itself() -> None:
    assert drag_factor(measurement=Sled(28.0, 40.0)).drag_factor == 0.7
    assert drag_factor(measurement=Sled(28.0, 40.0), gravity=10.0).deceleration == 7.0


def test_rear_wheels_that_just_stay_down_carry_nothing() -> None:
    limit = Axles(0.75, 0.75, 2.5, 0.75, 1.0)
    answer = drag_factor(measurement=limit)
    assert answer.rear_share == 0.0
    assert answer.drag_factor == 0.75
    assert answer.advice[0].code == "light-rear-axle"
    near = Axles(0.75, 0.75, 2.5, 0.75, 1.0 - 1e-9)
    assert drag_factor(measurement=near).rear_share == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("measurement", "message"),
    [
        (Axles(0.75, 0.75, 2.5, 0.75, 1.01), "lifts the rear axle: friction of 0.75 .* height 1.01 m .* 0.75 m behind"),
        (Axles(0.75, 0.75, 2.5, 2.6, 0.5), "2.6 m behind the front axle, is not between axles 2.5 m apart"),
        (Axles(0.75, 0.75, 2.5, 0.0, 0.5), "is not between axles"),
        (Surface(0.1, -0.2), "drag factor of -0.09806 is not above zero"),
        (Surface(0.7, 0.0, 0.0), "drag factor of 0 is not above zero"),
        (Sled(200.0, 100.0, 1.0), "lifts the sled: it leaves -68.29 N"),
        (Sled(10.0, 100.0, 0.0, 0.2), "friction would be -0.098"),
        (Sled(10.0, 100.0, 1.6), "along the road, not at 1.6 rad"),
    ],
)
def test_refusals_give_the_deciding_number(measurement: Surface | Axles | Sled, message: str) -> None:
    with pytest.raises(InadmissibleError, match=message):
        drag_factor(measurement=measurement)


def test_drag_near_zero_keeps_its_digits() -> None:
    grade = -0.7 + 1e-13
    exact = (0.7 + grade) / math.hypot(1.0, grade)
    assert drag_factor(measurement=Surface(0.7, grade)).drag_factor == pytest.approx(exact, rel=4e-16)
