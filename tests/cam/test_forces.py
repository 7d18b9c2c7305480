"""Forces on a cam: closed forms, energy, the speed of jump, Hertz stress, durations, and what is refused."""

import warnings
from math import pi, sqrt

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.cam.forces.durations import crossings
from dynamics_cli.cam.forces.forces import force
from dynamics_cli.cam.forces.records import Contact, Slide
from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.errors import InadmissibleError

LINE = "rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg 3-4-5; dwell"
SINES = "rise 10 mm in 90 deg modified-sine; dwell 90 deg; return in 90 deg cycloidal; dwell"
ROLLER = followers.Roller(0.04, 0.01)
HARMONIC = "rise 20 mm in 180 deg harmonic; return in 180 deg harmonic"
SLIDE = {"mass": 0.5, "spring_rate": 5000.0, "preload": 60.0}


def at(line: str = LINE, shaft_speed: float = 50.0, **given):
    train = Slide(**SLIDE | {name: given.pop(name) for name in Slide.fields if name in given})
    return force(Program(), program=line, shaft_speed=shaft_speed, train=train, **given)


def test_an_eccentric_jumps_at_the_closed_form_speed() -> None:
    # s = 10 mm (1 − cos θ): the force k s + P + m ω² r cos θ is least at the top, where s'' = −r
    r, k, p, m = 0.01, 5000.0, 60.0, 0.5
    found = at(HARMONIC)
    assert found.jump_speed == pytest.approx(sqrt((2 * r * k + p) / (m * r)), rel=1e-13)
    assert found.jump_at == pytest.approx(pi, abs=1e-6)


def test_an_examination_problem_worked_by_hand() -> None:
    # adapala-academy.com, forum question 1522: cycloidal rise and return of 10 mm in 120 deg each, two equal dwells,
    # 1000 rpm, 1.8 kg, 15 N/mm compressed by 2.5 mm; force and torque at 100 deg. x = 5/6, sin 2πx = −√3/2:
    # s = 10 (5/6 + √3/4π) mm = 9.7117 mm, spring 15 (9.7117 + 2.5) = 183.17 N; β = 2.0944, ω = 104.72 rad/s:
    # a = −(10 mm)(2π)(√3/2)(ω/β)² = −136.03 m/s², inertia −244.86 N; ds/dθ = (10 mm)(1 − ½)/β = 2.3873 mm
    line = "rise 10 mm in 120 deg cycloidal; dwell 60 deg; return in 120 deg cycloidal; dwell"
    found = at(line, 2000.0 * pi / 60.0, mass=1.8, spring_rate=15e3, preload=37.5, count=37)
    row = {name: column[10] for name, column in found.table.arrays.items()}
    assert row["angle"] == pytest.approx(1.745329, abs=1e-6)
    assert row["lift"] == pytest.approx(9.7117e-3, abs=5e-8)
    assert row["axial_force"] == pytest.approx(183.17 - 244.86, abs=0.02)
    assert row["torque"] == pytest.approx(-61.69 * 2.3873e-3, abs=5e-5)
    assert found.jump_speed * 30.0 / pi < 1000.0
    assert any(advice.code == "follower-leaves" for advice in found.advice)


@settings(max_examples=25, deadline=None)
@given(st.floats(0.01, 5.0), st.floats(100.0, 50000.0), st.floats(0.1, 500.0))
def test_at_the_jump_speed_the_least_force_is_nothing(mass: float, rate: float, preload: float) -> None:
    given_ = {"mass": mass, "spring_rate": rate, "preload": preload}
    speed = at(**given_).jump_speed
    found = at(**given_, shaft_speed=speed)
    assert abs(found.least_force) <= 1e-10 * found.greatest_force
    assert at(**given_, shaft_speed=0.999 * speed).least_force > 0.0
    assert at(**given_, shaft_speed=1.001 * speed).least_force < 0.0


@settings(max_examples=25, deadline=None)
@given(st.floats(1.0, 300.0))
def test_forces_are_those_of_the_table(speed: float) -> None:
    found = at(shaft_speed=speed, count=3601)
    column = found.table.arrays["axial_force"]
    torque = found.table.arrays["torque"]
    size = abs(column).max()
    assert column.max() <= found.greatest_force + 1e-12 * size
    assert column.max() >= found.greatest_force - 1e-4 * size
    assert column.min() >= found.least_force - 1e-12 * size
    assert torque.max() <= found.greatest_torque + 1e-12 * abs(torque).max()
    assert torque.min() >= found.least_torque - 1e-12 * abs(torque).max()
    assert found.greatest_power == pytest.approx(speed * max(found.greatest_torque, -found.least_torque))


def test_a_dip_narrower_than_the_samples_is_found() -> None:
    # at the start the force is lower than at every sample of the dip to zero at the end of the rise
    given_ = {"mass": 1.0, "spring_rate": 34238.0, "preload": 0.125}
    found = at(**given_, shaft_speed=at(**given_).jump_speed)
    assert abs(found.least_force) <= 1e-9


def test_the_preload_that_is_needed_is_enough() -> None:
    found = at(shaft_speed=120.0)
    assert found.least_force < 0.0
    kept = at(shaft_speed=120.0, preload=found.preload_needed)
    assert abs(kept.least_force) <= 1e-10
    assert any(advice.code == "follower-leaves" for advice in found.advice)


def test_without_a_downward_acceleration_or_mass_to_throw_nothing_jumps() -> None:
    found = at("dwell")
    assert found.jump_speed is None
    assert any(advice.code == "no-jump" and advice.result == "jump_speed" for advice in found.advice)


def test_without_a_spring_every_speed_lifts_the_follower_and_nothing_warns() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = force(Program(), program=SINES, shaft_speed=0.0, train=Slide(0.5))
    assert found.jump_speed == 0.0


def test_hertz_stress_on_an_eccentric_circle_in_closed_form() -> None:
    # a flat face on s = r (1 − cos θ): the cam is a circle of radius R_b + r wherever it is touched
    r, base, width, young, poisson = 0.01, 0.03, 0.01, 206e9, 0.3
    found = at(HARMONIC, follower=followers.FlatFace(base), contact=Contact(width), shaft_speed=30.0)
    give = 2 * (1 - poisson**2) / young
    normal = found.greatest_force
    assert found.stress == pytest.approx(sqrt(normal / (pi * width * give * (base + r))), rel=1e-12)


def test_hertz_stress_of_a_roller_in_a_dwell_in_closed_form() -> None:
    base, roller, width = 0.04, 0.01, 0.012
    found = at("dwell", follower=followers.Roller(base, roller), contact=Contact(width))
    give = 2 * (1 - 0.09) / 206e9
    assert found.stress == pytest.approx(sqrt(60.0 * (1 / base + 1 / roller) / (pi * width * give)), rel=1e-12)


def test_surge_of_the_spring() -> None:
    found = at(spring_mass=0.2)
    assert found.surge_frequency == pytest.approx(0.5 * sqrt(5000.0 / 0.2))
    assert found.surge_order == pytest.approx(found.surge_frequency * 2 * pi / 50.0)
    assert any(advice.code == "spring-surge" for advice in found.advice)
    assert not any(advice.code == "spring-surge" for advice in at(spring_mass=0.005).advice)


def test_durations_are_where_the_lift_is() -> None:
    motion = motion_of(Program(), LINE)
    found = at(lash=0.0002)
    assert [duration.lift for duration in found.durations] == [0.00127, 0.001]
    for duration in found.durations:
        for angle in (duration.opens, duration.closes):
            assert motion.at(angle)[0] == pytest.approx(duration.lift, rel=1e-12)
        assert duration.crank_duration == 2 * duration.duration
        assert duration.closing_speed < 0.0 < duration.opening_speed
    opening, closing = found.ramps
    assert opening.side == "opening"
    assert opening.angle == pytest.approx(found.durations[0].opens - crossings(motion, 0.0002)[0][0])
    assert closing.mean_speed < 0.0


def test_a_lobe_over_the_start_of_the_turn_has_one_duration() -> None:
    line = "return 4 mm in 60 deg; dwell 180 deg; rise 4 mm in 60 deg; dwell"
    assert [up for _, up in crossings(motion_of(Program(), line), -0.002)] == [False, True]
    found = at(line, at_lifts=(0.002,)).durations
    assert len(found) == 1
    assert found[0].opens == pytest.approx(1.5 * pi)
    assert found[0].duration == pytest.approx(2 * pi / 3)


def test_a_lift_that_is_never_reached_is_told() -> None:
    found = at(at_lifts=(0.5,))
    assert found.durations == ()
    assert any(advice.code == "duration" for advice in found.advice)


@pytest.mark.parametrize(
    ("given_", "code"),
    [
        ({"mass": 0.0}, "mass"),
        ({"preload": -1.0}, "preload"),
        ({"follower": ROLLER, "contact": Contact(0.0)}, "width"),
        ({"follower": ROLLER, "contact": Contact(0.01, cam_modulus=0.0)}, "modulus"),
        ({"follower": ROLLER, "contact": Contact(0.01, cam_poisson=1.2)}, "poisson"),
        ({"follower": followers.KnifeEdge(0.04), "contact": Contact(0.01)}, "edge"),
        ({"follower": followers.FlatFace(0.001), "contact": Contact(0.01)}, "undercut"),
        ({"follower": followers.Roller(0.005, 0.03), "contact": Contact(0.01)}, "undercut"),
        ({"follower": followers.Roller(0.04, 0.01, 0.06)}, "offset"),
        ({"follower": followers.Roller(0.03, 0.01, 0.04)}, "through-axis"),
        ({"follower": followers.OscillatingFlat(0.03, 0.1)}, "lift-kind"),
        ({"shaft_speed": 1e200}, "overflow"),
        ({"spring_mass": 0.0}, "spring-mass"),
        ({"spring_rate": 0.0, "spring_mass": 0.1}, "spring-rate"),
        ({"lash": 0.01}, "lash"),
        ({"count": 1}, "count"),
    ],
)
def test_what_has_no_answer_is_refused(given_, code: str) -> None:
    with pytest.raises(InadmissibleError) as refused:
        at(**given_)
    assert refused.value.code == code
