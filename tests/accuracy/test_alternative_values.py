"""Every question has an alternative, and every alternative is right within its own error where nothing is difficult."""

import math
from statistics import median
from types import SimpleNamespace as Given
from typing import Any

import pytest
from peers import skid as more_skid
from peers.gear import involute as more_gear_involute
from peers.impact import lines as more_impact_lines

from dynamics_cli.accuracy import catalogue
from dynamics_cli.accuracy.alternatives.impact import lines, rigid
from dynamics_cli.accuracy.alternatives.inertia import bodies as inertia_bodies
from dynamics_cli.accuracy.cases import load
from dynamics_cli.accuracy.measure import errors_of
from dynamics_cli.accuracy.questions import Method, Question
from dynamics_cli.core.answering.task import load as imported

QUESTIONS = [question for question in catalogue.questions("", "") if isinstance(question, Question)]
# Alternatives that approximate, by words of their names: the median and the worst of their errors over ordinary cases.
COARSE = {
    # a step that is as good for second differences
    "central differences of the formulas": (1e-8, 1e-3),
    "golden sections": (1e-8, 1e-7),
    "mean sine by degrees": (1e-5, 1e-4),
    # angles up to 72°, where five terms are far too few
    "power series": (1e-5, 0.1),
    # points a ten-thousandth of a module apart, beside distances that may be as small
    "distances between points": (0.01, 1.0),
    # a spring that swings through a whole period in its hundred steps
    "Runge–Kutta, 100 steps": (1e-8, 1e-4),
    "1e-10": (1e-11, 1e-7),
    # it thinks of no slip that turns, so that only some bodies come out right
    "slides or sticks, LAPACK": (0.01, math.inf),
    # a number of the array is zero even in ordinary polynomials
    "Routh's array with ε": (1e-15, 2.0),
    # read from a diagram
    "1,000 gains": (0.01, 0.1),
    "1,000 frequencies": (1e-4, 1e-2),
    # they find the trivial root, too
    "Newton on half angles": (1e-15, 1.0),
}
EXACT = 5e-15, 1e-8
FURTHER = catalogue.peers() or {}
ALTERNATIVES = [
    pytest.param(question, method, id=f"{question.name}: {method.name}")
    for question in QUESTIONS
    if question.family != "cam"
    for method in (*question.methods, *FURTHER.get(question.name, ()))
    if not method.chosen and not method.needs
]


def test_every_question_has_the_chosen_method_and_most_an_alternative(report_rows: list[dict[str, Any]]) -> None:
    asked: dict[tuple[str, str], list[str]] = {}
    for row in report_rows:
        asked.setdefault((row["family"], row["question"]), []).append(row["method"])
    assert sum(len(methods) > 1 for methods in asked.values()) >= 55
    for methods in asked.values():
        assert ["(chosen)" in method for method in methods] == [True] + [False] * (len(methods) - 1)
        assert len(set(methods)) == len(methods)


@pytest.mark.parametrize(("question", "method"), ALTERNATIVES)
def test_it_is_right_on_ordinary_cases(question: Question, method: Method) -> None:
    cases = [case for case in load(question.file) if case.task == question.cases and not case.hard]
    scale = imported(question.scale) if question.scale else None
    errors = errors_of(method.call(), cases, catalogue.groups(question.family), tracked=False, scale=scale)
    middle, worst = next((limits for words, limits in COARSE.items() if words in method.name), EXACT)
    assert errors.cases >= min(5.0, 0.4 * len(cases))
    assert median(errors.relative) <= middle
    # where a result vanishes a share of it says nothing
    large = [error for where, error in errors.by_result.items() if not _vanishes(cases, where)]
    assert max(large) <= worst


def _vanishes(cases: list[Any], where: str) -> bool:
    index, _, name = where.partition(" ")
    return abs(float(cases[int(index)].results[name])) < 1e-13


class TestInertia:
    def test_eulers_equations(self) -> None:
        """I = diag(1, 2, 2.5), ω = (0, 3, 4), α = (0, 0, 1): T* = ((2 − 2.5)·3·4, 0, −2.5) by hand."""
        tensor = ((1.0, 0.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, 2.5))
        found = inertia_bodies.torque_by_cross(
            tensor=tensor, angular_velocity=(0.0, 3.0, 4.0), angular_acceleration=(0.0, 0.0, 1.0)
        )
        assert [found[f"inertia_torque[{k}]"] for k in range(3)] == pytest.approx([-6.0, 0.0, -2.5], abs=1e-14)
        assert found["rotational_energy"] == pytest.approx(0.5 * (2.0 * 9.0 + 2.5 * 16.0))


class TestImpactsByHand:
    @pytest.mark.parametrize("method", [lines.central])
    def test_central(self, method: Any) -> None:
        """2 kg at 3 m/s on 1 kg at rest, e = ½: 1.5 and 3 m/s, 3 N·s, 2.25 J."""
        given = {"contact": Given(restitution=0.5), "gravity": 9.80665}
        found = method(first=body(2.0, 3.0), second=body(1.0, None), **given)
        names = ("first.velocity", "second.velocity", "impulse", "energy_lost", "share_lost")
        assert [found[name] for name in names] == pytest.approx([1.5, 3.0, 3.0, 2.25, 0.75])
        wall = method(first=body(2.0, 3.0), second=Given(bulk=Given(fixed=True), velocity=None), **given)
        assert (wall["first.velocity"], wall["impulse"]) == pytest.approx((-1.5, 9.0))

    @pytest.mark.parametrize("method", [rigid.oblique])
    def test_oblique(self, method: Any) -> None:
        """Balls of 1 kg, the second at rest, line of impact at 45°, elastic: the parts along it change places."""
        first = Given(bulk=Given(mass=1.0), motion=Given(velocity=(2.0, 0.0)), nose=None)
        second = Given(bulk=Given(mass=1.0), motion=Given(velocity=(0.0, 0.0)), nose=0.0)
        found = method(
            first=first, second=second, line=Given(normal=0.25 * math.pi), contact=Given(restitution=1.0),
            axes="mathematical", pdof_zero="heading", gravity=9.80665,
        )  # fmt: skip
        assert [found[f"first.velocity[{k}]"] for k in (0, 1)] == pytest.approx([1.0, -1.0])
        assert [found[f"second.velocity[{k}]"] for k in (0, 1)] == pytest.approx([1.0, 1.0])
        assert found["first.delta_v.pdof"] == pytest.approx(-0.25 * math.pi)
        assert found["energy_lost"] == pytest.approx(0.0, abs=1e-15)

    @pytest.mark.parametrize("method", [lines.drop, more_impact_lines.drop_by_bounces])
    def test_bounces(self, method: Any) -> None:
        found = method(evidence=Given(restitution=0.5), height=1.0, bounces=2, gravity=2.0)
        assert [found[f"bounces[{k}].height"] for k in (0, 1)] == pytest.approx([0.25, 0.0625])
        assert (found["fall_time"], found["time_to_rest"]) == pytest.approx((1.0, 3.0))
        assert found["way_to_rest"] == pytest.approx(5.0 / 3.0)

    @pytest.mark.parametrize("method", [lines.pendulum])
    def test_pendulum(self, method: Any) -> None:
        """A swing to 60° on 1 m rises by half a metre: √g m/s, a hundredfold before."""
        given = {"shot_mass": 0.01, "block": Given(bulk=Given(mass=0.99)), "gravity": 9.0}
        found = method(swing=Given(swing=math.pi / 3.0, length=1.0), restitution=0.0, **given)
        names = ("pendulum_speed", "speed", "rise", "share_lost")
        assert [found[name] for name in names] == pytest.approx([3.0, 300.0, 0.5, 0.99], rel=1e-10)

    @pytest.mark.parametrize("method", [lines.step])
    def test_a_disk_and_a_step(self, method: Any) -> None:
        """A third of the radius: 7/9 of the spin is left, and √(3·g·h)·6/7 is needed."""
        found = method(radius=0.3, height=0.1, wheel=Given(inertia_factor=0.5), gravity=9.80665, speed=2.0, mass=1.0)
        assert found["angular_ratio"] == pytest.approx(7.0 / 9.0)
        assert found["least_speed"] == pytest.approx(math.sqrt(0.3 * 9.80665) * 6.0 / 7.0, rel=1e-14)
        moment = found["impulse_forward"] * 0.2 + found["impulse_upward"] * math.sqrt(0.05)
        assert moment == pytest.approx(0.5 * 0.09 * (2.0 / 0.3) * (2.0 / 9.0))

    def test_a_ball_on_a_floor_in_the_plane(self) -> None:
        """M = 1, k = ½, r = (0, −1), (2, −2) m/s, μ = 0.1, e = ½: it slides, p = (0.3, 3)."""
        found = rigid.by_system(
            **ball(1.0, Given(radius_of_gyration=0.5), (0.0, -1.0), (2.0, -2.0), -0.5 * math.pi, 0.1)
        )
        assert (found["normal_impulse"], found["tangential_impulse"]) == pytest.approx((3.0, 0.3), rel=1e-9)
        assert found["first.velocity[1]"] == pytest.approx(1.0)

    def test_a_ball_on_a_floor_in_space(self) -> None:
        """The same in space, I = 0.4, 2 m/s along: p_n = 3, and μ·p_n = 0.3 against the slip, which lasts."""
        sphere = ((0.4, 0.0, 0.0), (0.0, 0.4, 0.0), (0.0, 0.0, 0.4))
        first = Given(bulk=Given(mass=1.0), inertia=sphere, arm=Given(lever=(0.0, 0.0, -1.0)),
                      velocity=(2.0, 0.0, -2.0), spin=(0.0, 0.0, 0.0), nose=None)  # fmt: skip
        floor = Given(bulk=Given(fixed=True), velocity=(0.0, 0.0, 0.0), spin=(0.0, 0.0, 0.0), nose=None)
        found = rigid.by_system(first=first, second=floor, normal=(0.0, 0.0, -1.0), friction=0.1,
                       contact=Given(restitution=0.5), law="stronge")  # fmt: skip
        assert found["normal_impulse"] == pytest.approx(3.0, rel=1e-9)
        assert found["first.velocity[0]"] == pytest.approx(1.7, rel=1e-9)

    def test_a_law_that_a_textbook_does_not_have_is_left_to_others(self) -> None:
        with pytest.raises(ArithmeticError):
            rigid.by_system(**ball(1.0, Given(radius_of_gyration=0.5), (0.0, -1.0), (0.1, -2.0), -0.5 * math.pi, 0.9))


class TestGearsByHand:
    def test_the_series_is_right_for_small_angles(self) -> None:
        value = math.tan(0.26) - 0.26
        assert more_gear_involute.power_series(0.26)["value"] == pytest.approx(value, rel=1e-6)
        assert more_gear_involute.brent_inverse(value)["phi"] == pytest.approx(0.26, rel=1e-12)


def test_the_mean_sine_of_a_half_turn() -> None:
    turn = Given(start_angle=0.0, rotation=math.pi, rolling_drag=0.0)
    found = more_skid.spin_by_degrees(drag=turn, distance=20.0, friction=0.7, end_speed=0.0, grade=0.0, gravity=9.80665)
    assert found["mean_share"] == pytest.approx(2.0 / math.pi, rel=2e-5)


def body(mass: float, velocity: float | None) -> Given:
    return Given(bulk=Given(mass=mass), velocity=velocity)


def ball(
    mass: float, turning: Given, lever: tuple[float, float], velocity: tuple[float, float], normal: float, mu: float
) -> dict[str, Any]:
    first = Given(bulk=Given(mass=mass), turning=turning, arm=Given(lever=lever), motion=Given(velocity=velocity),
                  spin=0.0, nose=None)  # fmt: skip
    floor = Given(bulk=Given(fixed=True), motion=Given(velocity=(0.0, 0.0)), spin=0.0, nose=None)
    return {"first": first, "second": floor, "normal": normal, "friction": mu, "contact": Given(restitution=0.5),
            "law": "stronge"}  # fmt: skip
