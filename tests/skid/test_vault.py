"""Vaults: flights computed step by step land where they should, the least speed is least, refusals."""

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError, UsageError
from dynamics_cli.skid.vault import Vault, least_speed_suffices, vault_known_angle, vault_least_speed

G = 9.80665
DISTANCE = st.floats(0.5, 80.0)
RISE = st.floats(-20.0, 10.0)


def lands(answer: Vault, distance: float, rise: float) -> None:
    """Fly it: position and velocity at the landing."""
    forward = answer.speed * math.cos(answer.launch_angle)
    upward = answer.speed * math.sin(answer.launch_angle)
    time = answer.flight_time
    size = abs(upward * time) + 0.5 * G * time**2
    assert forward * time == pytest.approx(distance, rel=1e-12)
    assert upward * time - 0.5 * G * time**2 == pytest.approx(rise, abs=1e-12 * size)
    landing = answer.landing_speed
    assert landing * math.cos(answer.landing_angle) == pytest.approx(forward, rel=1e-9, abs=1e-9 * landing)
    assert -landing * math.sin(answer.landing_angle) == pytest.approx(
        upward - G * time, abs=1e-9 * (G * time + landing)
    )
    assert all(check.passed for check in answer.checks)


@given(DISTANCE, RISE)
def test_the_least_speed_lands_there(distance: float, rise: float) -> None:
    answer = vault_least_speed(distance=distance, rise=rise)
    lands(answer, distance, rise)
    assert answer.launch_angle + answer.landing_angle == pytest.approx(math.pi / 2, rel=1e-14)


@given(DISTANCE, RISE, st.floats(-1.2, 1.5))
def test_a_known_angle_lands_there_and_is_never_slower(distance: float, rise: float, angle: float) -> None:
    assume(distance * math.sin(angle) - rise * math.cos(angle) > 1e-3)
    answer = vault_known_angle(distance=distance, rise=rise, take_off=angle)
    lands(answer, distance, rise)
    assert answer.speed >= vault_least_speed(distance=distance, rise=rise).speed * (1.0 - 1e-14)


@given(DISTANCE, RISE)
def test_the_known_angle_at_the_least_speeds_angle_gives_it(distance: float, rise: float) -> None:
    least = vault_least_speed(distance=distance, rise=rise)
    known = vault_known_angle(distance=distance, rise=rise, take_off=least.launch_angle)
    assert known.speed == pytest.approx(least.speed, rel=1e-11)


@given(DISTANCE, RISE, st.floats(0.01, 100.0))
def test_lengths_scale(distance: float, rise: float, factor: float) -> None:
    base = vault_least_speed(distance=distance, rise=rise)
    scaled = vault_least_speed(distance=distance * factor, rise=rise * factor)
    assert scaled.speed == pytest.approx(base.speed * math.sqrt(factor), rel=1e-14)
    assert scaled.launch_angle == pytest.approx(base.launch_angle, rel=1e-13)


def test_flying_back_takes_the_landings_speed() -> None:
    there = vault_least_speed(distance=20.0, rise=-5.0)
    back = vault_least_speed(distance=20.0, rise=5.0)
    assert back.speed == there.landing_speed
    assert back.landing_speed == there.speed
    assert back.launch_angle == there.landing_angle


@pytest.mark.parametrize("step", [1e-9, -1e-9])
def test_level_ground_is_met_from_both_sides(step: float) -> None:
    level = vault_least_speed(distance=20.0)
    assert level.speed == pytest.approx(math.sqrt(G * 20.0), rel=4e-16)
    assert level.launch_angle == pytest.approx(math.pi / 4, rel=4e-16)
    assert vault_least_speed(distance=20.0, rise=step).speed == pytest.approx(level.speed, rel=1e-9)
    flat = vault_known_angle(distance=20.0, rise=-2.0, take_off=0.0).speed
    assert flat == pytest.approx(20.0 * math.sqrt(G / 4.0), rel=4e-16)
    assert vault_known_angle(distance=20.0, rise=-2.0, take_off=step).speed == pytest.approx(flat, rel=1e-8)


def test_refusals_give_the_deciding_number() -> None:
    with pytest.raises(InadmissibleError, match=r"at 0.3491 rad cannot land there: it must point above 0.4636 rad"):
        vault_known_angle(distance=20.0, rise=10.0, take_off=math.radians(20.0))
    with pytest.raises(InadmissibleError, match=r"at 1.571 rad does not go forward"):
        vault_known_angle(distance=20.0, take_off=math.pi / 2)
    with pytest.raises(InadmissibleError, match="distance of a flight must be more than zero"):
        vault_least_speed(distance=0.0)
    with pytest.raises(UsageError) as caught:
        vault_known_angle(distance=20.0)
    assert caught.value.parameter == "take_off"


def test_the_smallest_model_is_chosen_by_what_is_given() -> None:
    assert least_speed_suffices(distance=20.0, rise=0.0, take_off=0.1) is None
    assert "no take-off angle" in str(least_speed_suffices(distance=20.0, rise=0.0, take_off=None))
    assert [one.code for one in vault_least_speed(distance=20.0, take_off=0.1).advice] == ["take-off-unused"]
