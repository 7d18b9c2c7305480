"""Every task of pendulums against references by other formulas."""

import json
import math
from pathlib import Path
from typing import Any

import pytest
from mpmath import mp

from dynamics_cli.numerics.elliptic import functions
from dynamics_cli.pendulum.compound import CentralInertia, Gyration, PivotInertia, compound, rod
from dynamics_cli.pendulum.conical import BobSpeed, ConeAngle, ConeHeight, ConePeriod, ConeSpeed, conical
from dynamics_cli.pendulum.damped import FINE, _by_energy, _integrated, _sampled, damped
from dynamics_cli.pendulum.design import design
from dynamics_cli.pendulum.simple import Amplitude, BottomSpeed, FromTop, State, simple

REFERENCES: dict[str, Any] = json.loads((Path(__file__).parent / "pendulum.json").read_text(encoding="utf-8"))
EXACT = 4e-15
G = 9.80665


def near(value: Any, text: str, tolerance: float = EXACT) -> None:
    assert value == pytest.approx(float(text), rel=tolerance, abs=0.0)


@pytest.mark.parametrize(("degrees", "text"), REFERENCES["slowdown"].items())
def test_slowdown(degrees: str, text: str) -> None:
    """The double nearest to an angle in radians is up to 1e-16 off, which near the top is 9e-13 of the answer."""
    near(
        simple(length=1.0, start=Amplitude(math.radians(float(degrees)))).slowdown,
        text,
        1e-11 if degrees == "179.999" else EXACT,
    )


@pytest.mark.parametrize(("degrees", "text"), REFERENCES["near_top"].items())
def test_slowdown_near_the_top(degrees: str, text: str) -> None:
    near(simple(length=1.0, start=FromTop(math.radians(float(degrees)))).slowdown, text)


def test_going_round() -> None:
    made = simple(length=1.0, start=BottomSpeed(6.5), time=2.7)
    near(made.period, REFERENCES["whirl"])
    near(made.angle_then, REFERENCES["around"][0], 1e-14)
    near(made.rate_then, REFERENCES["around"][1], 1e-13)


def test_state_at_a_time() -> None:
    made = simple(length=1.0, start=Amplitude(2.0), time=1.5)
    near(made.angle_then, REFERENCES["state"][0], 1e-14)
    near(made.rate_then, REFERENCES["state"][1], 1e-13)


@pytest.mark.parametrize("amplitude", [0.01, 1.0, 2.5, 3.1])
def test_ways_to_start_agree(amplitude: float) -> None:
    one = simple(length=0.7, start=Amplitude(amplitude), mass=2.0)
    others = [
        simple(length=0.7, start=BottomSpeed(one.bottom_speed), mass=2.0),
        simple(length=0.7, start=State(0.5 * amplitude, _rate(0.7, amplitude)), mass=2.0),
    ]
    for other in others:
        assert other.period == pytest.approx(one.period, rel=1e-11)
        assert other.amplitude == pytest.approx(amplitude, rel=1e-9)
        assert other.end_tension == pytest.approx(one.end_tension, rel=1e-9, abs=1e-9)


def _rate(length: float, amplitude: float) -> float:
    return math.sqrt(2.0 * G / length * (math.cos(0.5 * amplitude) - math.cos(amplitude)))


def test_both_sides_of_going_round() -> None:
    limit = 2.0 * math.sqrt(G)
    assert simple(length=1.0, start=BottomSpeed(limit * (1 - 1e-12))).motion == "swing"
    assert simple(length=1.0, start=BottomSpeed(limit * (1 + 1e-12))).motion == "goes round"


def test_a_string_goes_slack_between_90_degrees_and_all_round() -> None:
    assert simple(length=1.0, start=Amplitude(math.radians(89.999))).slack_angle is None
    made = simple(length=1.0, start=Amplitude(2.0))
    assert made.slack_angle is not None
    # there gravity along the string is what the motion needs
    rate = math.sqrt(2.0 * G * (math.cos(made.slack_angle) - math.cos(2.0)))
    assert G * math.cos(made.slack_angle) + rate**2 == pytest.approx(0.0, abs=1e-12)
    assert simple(length=1.0, start=BottomSpeed(math.sqrt(4.9 * G))).slack_angle is not None
    assert simple(length=1.0, start=BottomSpeed(math.sqrt(5.1 * G))).slack_angle is None


@pytest.mark.parametrize("time", [0.0, 0.3, 1.9, 7.0])
@pytest.mark.parametrize("start", [Amplitude(1.3), BottomSpeed(5.0), BottomSpeed(8.0)])
def test_energy_is_kept(start: Any, time: float) -> None:
    made = simple(length=1.0, start=start, time=time)
    assert made.angle_then is not None
    assert made.rate_then is not None
    energy = 0.5 * made.rate_then**2 + G * (1.0 - math.cos(made.angle_then))
    assert energy == pytest.approx(0.5 * made.bottom_speed**2, rel=1e-13)


def test_rod() -> None:
    made = rod(length=1.2, mass=2.0, amplitude=math.pi / 3, angle=math.pi / 9)
    for name, value in (
        ("small", made.small_period), ("period", made.period), ("least", made.least_period),
        ("along", made.along_force), ("across", made.across_force),
    ):  # fmt: skip
        near(value, REFERENCES["rod"][name])


def test_ways_to_give_a_body_agree() -> None:
    central = 2.0 * 1.44 / 12.0
    bodies = (CentralInertia(central), PivotInertia(central + 2.0 * 0.36), Gyration(math.sqrt(central / 2.0)))
    made = [compound(mass=2.0, distance=0.6, body=body, amplitude=1.0) for body in bodies]
    for other in made[1:]:
        assert other.period == pytest.approx(made[0].period, rel=1e-15)


def test_conjugate_pivots_have_one_period() -> None:
    one = compound(mass=3.0, distance=0.25, body=Gyration(0.4))
    other = compound(mass=3.0, distance=one.conjugate_distance, body=Gyration(0.4))
    assert other.small_period == pytest.approx(one.small_period, rel=1e-15)
    assert one.least_period < one.small_period


def test_cone() -> None:
    made = conical(length=1.0, cone=ConeAngle(math.radians(40.0)))
    near(2.0 * math.pi * made.disturbance / made.rotation, REFERENCES["cone"]["disturbance"])
    near(conical(length=2.0, cone=ConeSpeed(2.5)).angle, REFERENCES["cone"]["angle"])
    for cone in (ConeSpeed(made.rotation), ConePeriod(made.period), ConeHeight(made.height), BobSpeed(made.speed)):
        assert conical(length=1.0, cone=cone).angle == pytest.approx(math.radians(40.0), rel=1e-14)


def test_turning_points() -> None:
    for name, given in (("linear", {"damping": 0.05}), ("quadratic", {"quadratic": 0.1})):
        made = damped(length=1.0, amplitude=math.pi / 3, **given)
        near(made.peaks[0].time, REFERENCES["damped"][name][0], 1e-9)
        near(made.peaks[0].amplitude, REFERENCES["damped"][name][1], 1e-10)


def test_small_swings_run_down_as_the_logarithmic_decrement_says() -> None:
    zeta = 0.02
    made = damped(length=1.0, amplitude=1e-3, damping=zeta, until=5e-4)
    wanted = math.log(2.0) / (2.0 * math.pi * zeta / math.sqrt(1.0 - zeta**2))
    assert made.swings == pytest.approx(wanted, rel=1e-5)


def test_design_and_back() -> None:
    made = design(period=2.0, amplitude=0.3)
    assert simple(length=made.length, start=Amplitude(0.3)).period == pytest.approx(2.0, rel=1e-15)
    assert design(period=2.0, length=made.length).amplitude == pytest.approx(0.3, rel=1e-12)


def test_elliptic_functions() -> None:
    """sn² + cn² = 1, dn² + k²·sn² = 1, and a quarter period of the lemniscate."""
    for u in (0.1, 1.0, 3.0, 10.0):
        sn, cn, dn = functions(u, 0.6, 0.8)
        assert sn * sn + cn * cn == pytest.approx(1.0, rel=1e-15)
        assert dn * dn + 0.36 * sn * sn == pytest.approx(1.0, rel=1e-14)


@pytest.mark.parametrize(("beta", "size"), [(0.1, 1.0), (0.02, 3.1), (5.0, 2.0), (1e-4, 0.5), (0.3, 0.01)])
def test_drag_by_the_square_alone_in_closed_form_is_as_integrated(beta: float, size: float) -> None:
    closed, run = _by_energy(3.13, beta, size, 1e-6, 6), _integrated(3.13, 0.0, beta, size, 1e-6, 1e-12, 6)
    for (time, angle), (other_time, other_angle) in zip(closed, run, strict=True):
        assert time == pytest.approx(other_time, rel=1e-10)
        assert angle == pytest.approx(other_angle, rel=1e-10)


@pytest.mark.parametrize(
    ("zeta", "beta", "size", "goal"), [(0.01, 0.02, 2.9, 1e-2), (0.3, 0.0, 1.0, 1e-6), (1.5, 0.0, 1.0, 0.1)]
)
def test_samples_turn_where_and_when_single_answers_do(zeta: float, beta: float, size: float, goal: float) -> None:
    exact = _integrated(3.13, zeta, beta, size, goal, FINE, 200)
    sampled = _sampled(3.13, zeta, beta, size, goal, 200)
    assert len(sampled) == len(exact)
    for one, other in zip(sampled, exact, strict=True):
        assert one == pytest.approx(other, rel=1e-5)


def test_a_slow_bob_keeps_the_digits_of_its_angle() -> None:
    with mp.workdps(40):
        share = mp.mpf(1e-6) ** 2 / mp.mpf(G)
        wanted = mp.acos((mp.sqrt(share * share + 4) - share) / 2)
        assert conical(length=1.0, cone=BobSpeed(1e-6)).angle == pytest.approx(float(wanted), rel=1e-15)
