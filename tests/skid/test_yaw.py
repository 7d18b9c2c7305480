"""Critical speed: chord and radius say the same, banks and limits from both sides, refusals."""

import math

import pytest
from harness import answer
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.skid.yaw import Chord, Radius, yaw

RADIUS = st.floats(10.0, 500.0)
FRICTION = st.floats(0.1, 1.0)
BANK = st.floats(-0.09, 0.3)


@given(RADIUS, st.floats(0.01, 3.0), FRICTION, BANK)
def test_chord_and_radius_say_the_same(radius: float, half_angle: float, friction: float, bank: float) -> None:
    chord = Chord(2.0 * radius * math.sin(half_angle), 2.0 * radius * math.sin(0.5 * half_angle) ** 2)
    given_radius = yaw(path=Radius(radius), friction=friction, superelevation=bank)
    by_chord = yaw(path=chord, friction=friction, superelevation=bank)
    assert by_chord.speed == pytest.approx(given_radius.speed, rel=1e-12)
    assert by_chord.mark_radius == pytest.approx(radius, rel=1e-12)


@given(RADIUS, FRICTION, BANK)
def test_friction_and_bank_angles_add(radius: float, friction: float, bank: float) -> None:
    answer = yaw(path=Radius(radius), friction=friction, superelevation=bank)
    lateral = 9.80665 * math.tan(math.atan(friction) + math.atan(bank))
    assert answer.lateral_acceleration == pytest.approx(lateral, rel=1e-12, abs=1e-14)
    assert answer.speed**2 / radius == pytest.approx(answer.lateral_acceleration, rel=1e-14)
    assert all(check.passed for check in answer.checks)


@given(RADIUS, FRICTION, BANK, st.floats(0.01, 4.0))
def test_the_mass_centre_runs_inside_the_mark(radius: float, friction: float, bank: float, track: float) -> None:
    answer = yaw(path=Radius(radius), friction=friction, superelevation=bank, track_width=track)
    direct = yaw(path=Radius(radius - 0.5 * track), friction=friction, superelevation=bank)
    assert answer.speed == direct.speed
    assert (answer.mark_radius, answer.path_radius) == (radius, radius - 0.5 * track)


@given(RADIUS, FRICTION, BANK, st.floats(1.001, 4.0))
def test_scaling_and_monotony(radius: float, friction: float, bank: float, factor: float) -> None:
    base = yaw(path=Radius(radius), friction=friction, superelevation=bank).speed
    wider = yaw(path=Radius(radius * factor), friction=friction, superelevation=bank).speed
    assert wider == pytest.approx(base * math.sqrt(factor), rel=1e-14)
    assert yaw(path=Radius(radius), friction=friction, superelevation=bank + 0.01).speed > base
    assert yaw(path=Radius(radius), friction=friction + 0.01, superelevation=bank).speed > base


@pytest.mark.parametrize("step", [1e-9, -1e-9])
def test_a_level_road_is_met_from_both_sides(step: float) -> None:
    level = yaw(path=Radius(60.0), friction=0.7).speed
    assert level == pytest.approx(math.sqrt(9.80665 * 60.0 * 0.7), rel=4e-16)
    assert yaw(path=Radius(60.0), friction=0.7, superelevation=step).speed == pytest.approx(level, rel=2e-9)


@pytest.mark.parametrize(
    ("inputs", "message"),
    [
        ({"path": Radius(0.0)}, "the radius of the mark must be more than zero"),
        ({"path": Chord(0.0, 1.0)}, "the chord must be more than zero"),
        ({"path": Chord(30.0, 0.0)}, "middle ordinate must be more than zero"),
        ({"track_width": 120.0}, "half the track width of 120 m exceeds the radius of the mark, 60 m"),
        ({"superelevation": -0.9}, "sum to -0.1: the vehicle slides off"),
        ({"superelevation": 1.25}, "1 - friction × superelevation is -"),
        ({"superelevation": 2.0}, "1 - friction × superelevation is -0.6"),
    ],
)
def test_refusals_give_the_deciding_number(inputs: dict[str, object], message: str) -> None:
    base: dict[str, object] = {"path": Radius(60.0), "friction": 0.8}
    with pytest.raises(InadmissibleError, match=message):
        yaw(**{**base, **inputs})  # type: ignore[arg-type]


def test_doubtful_measurements_are_pointed_out() -> None:
    def codes(path: Radius | Chord, bank: float = 0.0) -> list[tuple[str, str]]:
        return [(one.code, one.severity) for one in yaw(path=path, friction=0.8, superelevation=bank).advice]

    assert codes(Chord(30.0, 1.0)) == []
    assert codes(Chord(10.0, 0.1)) == [("short-middle-ordinate", "caution")]
    assert codes(Chord(10.0, 0.01)) == [("short-middle-ordinate", "serious")]
    assert codes(Chord(1.0, 30.0)) == [("beyond-half-circle", "caution")]
    assert codes(Radius(30.0), 1.1) == [("steep-grade", "caution"), ("near-self-holding-bank", "serious")]


def test_a_surveyed_point_may_be_uncertain() -> None:
    points = "0, 0, 10, 4.30, 20, {}, 30, 9.65, 40, 10.70 m"
    document = answer("skid", "yaw", "--points", points.format("7.53 ± 0.05"), "--friction", "0.72")
    low, high = document["results"]["speed"]["interval"]
    ends = [
        answer("skid", "yaw", "--points", points.format(y), "--friction", "0.72")["results"]["speed"]["value"]
        for y in ("7.628", "7.432")
    ]
    assert [low, high] == pytest.approx(sorted(ends), rel=1e-3)
    assert "interval" not in document["results"]["point_scatter"]
