"""Forces of arms: closed forms, equal springs, mirror images, the jump verdict, and what is refused."""

from math import asin, cos, isnan, pi, radians, sqrt

import pytest
from harness import run
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.cam.forces.check import check
from dynamics_cli.cam.forces.forces import force
from dynamics_cli.cam.forces.pictures import forces
from dynamics_cli.cam.forces.records import ArmOnSpring, ArmOnTorsionSpring, Contact, Slide
from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.program.reading import Program
from dynamics_cli.errors import InadmissibleError, UsageError
from dynamics_cli.pictures import Curve

SWING = "rise 15 deg in 120 deg 3-4-5; dwell 60 deg; return in 120 deg modified-sine; dwell"
BACK = "dwell 60 deg; rise 15 deg in 120 deg modified-sine; dwell 60 deg; return in 120 deg 3-4-5"
HARMONIC = "rise 20 deg in 180 deg harmonic; return in 180 deg harmonic"
STEEP = "rise 25 deg in 40 deg 3-4-5; return in 60 deg 3-4-5; dwell"
LINE = "rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg 3-4-5; dwell"
TRAIN = ArmOnTorsionSpring(0.002, 10.0, 2.0)
ARM = followers.OscillatingRoller(0.03, 0.008, 0.08, 0.1)
BROAD = followers.OscillatingRoller(0.03, 0.025, 0.08, 0.1)
ROCKER = followers.OscillatingFlat(0.045, 0.12, 0.004)


def at(line: str = SWING, speed: float = 50.0, train=TRAIN, **given_):
    return force(Program(), program=line, shaft_speed=speed, train=train, **given_)


def test_a_harmonic_arm_in_closed_form() -> None:
    # ψ = a(1 − cos θ): M = P + k a + (I ω² − k) a cos θ, T = a sin θ M
    a, i, k, p, w = radians(10.0), 0.002, 10.0, 2.0, 50.0
    found = at(HARMONIC, w)
    mean, swing = p + k * a, (i * w * w - k) * a
    assert found.least_arm_torque == pytest.approx(mean - abs(swing), rel=1e-13)
    assert found.greatest_arm_torque == pytest.approx(mean + abs(swing), rel=1e-13)
    # dT/dθ = 0: mean·cos θ + swing·(2 cos² θ − 1) = 0
    x = (-mean + sqrt(mean * mean + 8.0 * swing * swing)) / (4.0 * swing)
    top = a * sqrt(1.0 - x * x) * (mean + swing * x)
    assert found.greatest_torque == pytest.approx(top, rel=1e-13)
    assert found.least_torque == pytest.approx(-top, rel=1e-13)
    assert found.greatest_power == pytest.approx(top * w, rel=1e-13)
    # it leaves at the top of its swing, where ψ″ = −a
    assert found.jump_speed == pytest.approx(sqrt((2.0 * a * k + p) / (i * a)), rel=1e-13)
    assert found.jump_at == pytest.approx(pi, abs=1e-6)


def test_levers_of_a_resting_arm_in_closed_form() -> None:
    # sides 3, 4, 5: the arm stands square to the line of centres, its whole length is the lever
    found = at("rise 1 deg in 10 deg; return in 10 deg; dwell", 0.0, ArmOnTorsionSpring(0.002, 0.0, 2.0),
               follower=followers.OscillatingRoller(0.02, 0.01, 0.04, 0.05))  # fmt: skip
    assert found.contact_table.arrays["contact_force"][-1] == pytest.approx(2.0 / 0.04, rel=1e-14)
    assert found.contact_table.arrays["pressure_angle"][-1] == pytest.approx(0.0, abs=1e-15)
    # a resting face touches at c cos ψ from the pivot, sin ψ = (R + f)/c
    found = at("rise 1 deg in 10 deg; return in 10 deg; dwell", 0.0, ArmOnTorsionSpring(0.002, 0.0, 2.0),
               follower=ROCKER)  # fmt: skip
    lever = 0.12 * cos(asin(0.049 / 0.12))
    assert found.contact_table.arrays["contact_force"][-1] == pytest.approx(2.0 / lever, rel=1e-14)


def test_stress_of_a_resting_arm_in_closed_form() -> None:
    # hardly moving, and with no spring rate, the pressure is that of two circles under M/L
    found = at("rise 1e-9 deg in 180 deg; return in 180 deg", 0.0, ArmOnTorsionSpring(0.002, 0.0, 2.0),
               follower=followers.OscillatingRoller(0.02, 0.01, 0.04, 0.05), contact=Contact(0.01))  # fmt: skip
    give = 2.0 * (1.0 - 0.09) / 206e9
    assert found.stress == pytest.approx(sqrt(50.0 * (1 / 0.02 + 1 / 0.01) / (pi * 0.01 * give)), rel=1e-8)


@settings(max_examples=15, deadline=None)
@given(st.floats(0.01, 0.2), st.floats(0.0, 5e4), st.floats(0.0, 300.0), st.floats(1.0, 150.0))
def test_a_spring_at_a_radius_is_a_torsion_spring(radius: float, rate: float, preload: float, speed: float) -> None:
    linear = at(speed=speed, train=ArmOnSpring(0.002, radius, rate, preload))
    twisted = at(speed=speed, train=ArmOnTorsionSpring(0.002, rate * radius * radius, preload * radius))
    for name in ("least_arm_torque", "greatest_arm_torque", "greatest_torque", "least_torque", "jump_speed"):
        assert getattr(linear, name) == getattr(twisted, name), name
    assert linear.preload_needed * radius == pytest.approx(twisted.preload_torque_needed, rel=1e-14)


@pytest.mark.parametrize("follower", [ARM, ROCKER])
def test_a_motion_run_backwards_on_a_cam_that_turns_back_presses_alike(follower) -> None:
    one = at(SWING, follower=follower, rotation=followers.Rotation("ccw"), contact=Contact(0.01))
    other = at(BACK, follower=follower, rotation=followers.Rotation("cw"), contact=Contact(0.01))
    assert one.greatest_contact_force == pytest.approx(other.greatest_contact_force, rel=1e-12)
    assert one.least_contact_force == pytest.approx(other.least_contact_force, rel=1e-12)
    assert one.greatest_torque == pytest.approx(-other.least_torque, rel=1e-12)
    assert one.stress == pytest.approx(other.stress, rel=1e-12)
    same_way = at(SWING, follower=follower, rotation=followers.Rotation("cw"))
    ratio = same_way.contact_table.arrays["contact_force"] / one.contact_table.arrays["contact_force"]
    assert abs(ratio - 1.0).max() > 1e-2


@settings(max_examples=15, deadline=None)
@given(st.floats(0.2, 5.0))
def test_a_cam_of_another_size_presses_in_proportion(scale: float) -> None:
    # lengths by λ, moments of inertia by λ⁵, springs' torques by λ³: forces by λ², pressures alike, speeds by 1/λ
    size, cube = scale, scale**3
    big = followers.OscillatingRoller(0.03 * size, 0.008 * size, 0.08 * size, 0.1 * size)
    train = ArmOnTorsionSpring(0.002 * size**5, 10.0 * cube, 2.0 * cube)
    one = at(follower=ARM, contact=Contact(0.01))
    other = at(speed=50.0 / size, train=train, follower=big, contact=Contact(0.01 * size))
    assert other.greatest_contact_force == pytest.approx(one.greatest_contact_force * size * size, rel=1e-12)
    assert other.stress == pytest.approx(one.stress, rel=1e-12)
    assert other.jump_speed * size == pytest.approx(one.jump_speed, rel=1e-12)


def test_the_contact_force_vanishes_with_the_torque() -> None:
    speed = at().jump_speed
    found = at(speed=speed, follower=ARM)
    assert abs(found.least_arm_torque) <= 1e-12 * found.greatest_arm_torque
    assert abs(found.least_contact_force) <= 1e-12 * found.greatest_contact_force
    assert at(speed=1.001 * speed, follower=ARM).least_contact_force < 0.0


def test_every_check_passes_and_the_preload_that_is_needed_is_enough() -> None:
    found = at(speed=120.0, follower=ARM, contact=Contact(0.01))
    assert [one.passed for one in found.checks] == [True, True]
    assert found.least_arm_torque < 0.0
    assert found.preload_needed is None
    kept = at(speed=120.0, train=ArmOnTorsionSpring(0.002, 10.0, found.preload_torque_needed))
    assert abs(kept.least_arm_torque) <= 1e-12 * kept.greatest_arm_torque


def test_a_torsion_spring_surges_by_its_own_inertia() -> None:
    found = at(train=ArmOnTorsionSpring(0.002, 10.0, 2.0, 0.0, 1e-6))
    assert found.surge_frequency == pytest.approx(0.5 * sqrt(10.0 / 1e-6))


def test_a_velocity_that_drops_lets_go_at_any_speed() -> None:
    found = force(Program(), program="rise 9 mm in 90 deg linear; dwell 90 deg; return in 90 deg 3-4-5; dwell",
                  shaft_speed=10.0, train=Slide(0.5, 5000.0, 60.0))  # fmt: skip
    assert found.jump_speed == 0.0
    assert found.jump_at == pytest.approx(pi / 2)
    assert any(advice.code == "velocity-jump" and advice.severity == "serious" for advice in found.advice)
    assert all(one.passed for one in found.checks)


def test_the_jump_verdict_of_an_arm_is_that_of_its_forces() -> None:
    found = check(Program(), program=SWING, follower=ARM, rise_limit=pi / 3, return_limit=pi / 3,
                  inertia=0.002, torsion_rate=10.0, preload_torque=2.0, shaft_speed=50.0)  # fmt: skip
    assert found.jump_speed == at().jump_speed
    assert found.jump_at == at().jump_at
    assert found.numerics is not None
    bounds = {bound.result: bound for bound in found.numerics.bounds}
    assert bounds["jump_speed"] in at().numerics.bounds
    assert found.jump_kept
    assert "jump speed" not in found.binding
    for speed in (100.0, -100.0):
        fast = check(Program(), program=SWING, follower=ARM, inertia=0.002, torsion_rate=10.0, preload_torque=2.0,
                     shaft_speed=speed)  # fmt: skip
        assert fast.jump_kept is False
        assert "jump speed" in fast.binding


@pytest.mark.parametrize(
    ("given_", "code"),
    [
        ({"mass": 0.2, "spring_rate": 2e4, "preload": 100.0}, "spring"),
        ({"inertia": 0.002, "torsion_rate": 10.0}, "spring"),
        ({"shaft_speed": 50.0}, "spring"),
        ({"inertia": 0.002, "torsion_rate": 10.0, "preload_torque": 0.0}, "slack"),
        ({"inertia": 0.0, "torsion_rate": 10.0, "preload_torque": 2.0}, "mass"),
    ],
)
def test_a_verdict_lacking_its_spring_is_refused(given_, code: str) -> None:
    with pytest.raises(InadmissibleError) as refused:
        check(Program(), program=SWING, follower=ARM, **given_)
    assert refused.value.code == code


@pytest.mark.parametrize(
    ("given_", "code"),
    [
        ({"train": ArmOnTorsionSpring(0.0)}, "mass"),
        ({"train": ArmOnTorsionSpring(0.002, 1.0, -1.0)}, "preload"),
        ({"train": ArmOnSpring(0.002, 0.0, 100.0)}, "spring-radius"),
        ({"train": ArmOnTorsionSpring(0.002, 0.0, 1.0, 0.0, 1e-6)}, "spring-rate"),
        ({"follower": followers.Roller(0.04, 0.01)}, "lift-kind"),
        ({"follower": followers.OscillatingRoller(0.01, 0.008, 0.08, 0.1)}, "no-triangle"),
        ({"follower": followers.OscillatingRoller(0.1715, 0.008, 0.08, 0.1)}, "no-lever"),
        ({"follower": followers.OscillatingFlat(0.1, 0.1001)}, "no-lever"),
        ({"follower": followers.OscillatingFlat(0.1, 0.1)}, "pivot-inside"),
        ({"line": "rise 40 deg in 60 deg; return in 50 deg; dwell", "follower": ROCKER}, "face-too-fast"),
        ({"line": STEEP, "follower": BROAD, "contact": Contact(0.01)}, "undercut"),
    ],
)
def test_what_an_arm_cannot_do_is_refused(given_, code: str) -> None:
    with pytest.raises(InadmissibleError) as refused:
        at(**given_)
    assert refused.value.code == code


@pytest.mark.parametrize(
    ("given_", "parameter"),
    [
        ({"train": Slide(0.5)}, "mass"),
        ({"line": LINE}, "inertia"),
        ({"at_lifts": (0.001,)}, "at_lifts"),
        ({"lash": 0.001}, "lash"),
        ({"contact": Contact(0.01)}, "follower"),
    ],
)
def test_what_belongs_to_the_other_kind_of_follower_is_a_wrong_call(given_, parameter: str) -> None:
    with pytest.raises(UsageError) as refused:
        at(**given_)
    assert refused.value.parameter == parameter


BASE = ("cam", "force", "--shaft-speed", "500 rpm", "--json", "--program")


@pytest.mark.parametrize(
    ("words", "parameter"),
    [
        ((SWING, "--mass", "0.5 kg"), "mass"),
        ((LINE, "--inertia", "0.002 kg*m^2"), "inertia"),
        ((LINE, "--mass", "0.5 kg", "--torsion-rate", "3 N*m/rad"), "mass"),
        ((SWING, "--inertia", "0.002 kg*m^2", "--spring-rate", "3 N/mm"), "spring_radius"),
        ((SWING, "--inertia", "0.002 kg"), "inertia"),
        ((SWING, "--inertia", "0.002 kg*m^2", "--torsion-rate", "3 N/mm"), "torsion_rate"),
        ((LINE, "--mass", "0.5 kg", "--base-radius", "40 mm"), "follower"),
        ((LINE, "--mass", "0.5 kg", "--follower", "conjugate-roller"), "follower"),
        ((LINE, "--mass", "0.5 kg", "--contact-width", "10 mm"), "follower"),
    ],
)
def test_wrong_mixtures_are_wrong_calls_that_name_the_parameter(words: tuple[str, ...], parameter: str) -> None:
    outcome = run(*BASE, *words)
    assert outcome.status == 2
    assert outcome.error["parameter"] == parameter
    assert outcome.error["hint"]


def test_a_picture_shows_torque_contact_force_and_the_line_of_no_force() -> None:
    found = at(follower=ARM)
    picture = forces(found, Program(), program=SWING, shaft_speed=50.0, train=TRAIN, follower=ARM, count=37)
    assert [panel.y.title for panel in picture.panels] == [
        "swing ψ", "arm torque M", "contact force N", "shaft torque T",
    ]  # fmt: skip
    curve = next(item for item in picture.panels[2].items if isinstance(item, Curve))
    drawn = [y for y in curve.y if not isnan(y)]
    assert max(drawn) == pytest.approx(found.greatest_contact_force, rel=1e-3)
    assert any(getattr(item, "vertical", True) is False and item.low == 0.0 for item in picture.panels[2].items)


def test_csv_writes_the_table_of_an_arm() -> None:
    words = ("cam", "force", "--program", SWING, "--shaft-speed", "500 rpm", "--inertia", "0.002 kg*m^2")
    lines = run(*words, "--count", "3", "--format", "csv", "--table", "arm_table").out.splitlines()
    assert lines[0] == "angle[deg],swing[deg],arm_torque[N·m],torque[N·m]"
    assert len(lines) == 4
    swing = run(
        "cam", "motion", "--program", SWING, "--count", "3", "--format", "csv", "--table", "swing_table"
    ).out.splitlines()
    assert swing[0].startswith("angle[deg],swing[deg],velocity")


@pytest.mark.parametrize(
    ("words", "formula"),
    [
        (("--program", LINE, "--mass", "0.5 kg"), "F = k·s + P"),
        (("--program", SWING, "--inertia", "0.002 kg*m^2", "--torsion-rate", "3 N*m/rad"), "M = k·ψ + P"),
        (("--program", SWING, "--inertia", "0.002 kg*m^2", "--spring-radius", "50 mm"), "M = r·(k·r·ψ + P)"),
    ],
)
def test_the_explanation_is_that_of_what_moves(words: tuple[str, ...], formula: str) -> None:
    text = run("cam", "force", "--shaft-speed", "500 rpm", "--explain", *words).out
    assert f"formula  {formula}" in text
    assert "with numbers" in text
