"""Every task of balancing against references by other formulas, and against the numbers of textbook engines."""

import cmath
import json
import math
from pathlib import Path
from typing import Any

import pytest

from dynamics_cli.balance.engines.crank import CrankRadius, order_factor, order_factors
from dynamics_cli.balance.engines.engine import Cylinder, engine
from dynamics_cli.balance.engines.lanchester import lanchester
from dynamics_cli.balance.engines.layouts import Preset
from dynamics_cli.balance.engines.turning import Diagram, turning
from dynamics_cli.balance.flywheel import Point, flywheel
from dynamics_cli.balance.four_runs import four_runs
from dynamics_cli.balance.grade import grade
from dynamics_cli.balance.planes import Unbalance, planes
from dynamics_cli.balance.split import Angles, split
from dynamics_cli.balance.trial import Sensor, TrialWeight, trial
from dynamics_cli.numerics.turns import turned

REFERENCES: dict[str, Any] = json.loads((Path(__file__).parent / "balance.json").read_text(encoding="utf-8"))
# Some ten roundings of doubles.
EXACT = 5e-15
# Differences of readings cancel a digit.
READ = 2e-14
# Means of 128 accelerations of size 1.
MEANS = 1e-15
# Sums of a thousand products of size 1.
QUADRATURE = 2e-14
RPM = math.pi / 30.0
MICRO = 1e-6


def near(value: Any, text: str, tolerance: float = EXACT) -> None:
    assert value == pytest.approx(float(text), rel=tolerance, abs=0.0)


def reading(size: float, degrees: float) -> Any:
    cosine, sine = turned(math.radians(degrees))
    return size * MICRO * cosine, size * MICRO * sine


TWO = (
    Sensor(reading(170, 112), reading(235, 94), reading(186, 115)),
    Sensor(reading(53, 78), reading(58, 68), reading(77, 104)),
)
THIRD = Sensor(reading(120, 95), reading(150, 80), reading(139, 101))
WEIGHT = TrialWeight(0.00115, 0.0)


def test_two_planes_of_known_unbalances() -> None:
    given = ((12, 30, 0.1), (20, 140, 0.35), (8, 260, 0.6))
    those = tuple(Unbalance(u * MICRO, math.radians(a), z) for u, a, z in given)
    made = planes(unbalances=those, first_plane=0.05, second_plane=0.7)
    for name in ("first", "second"):
        size, angle = REFERENCES["planes"][name]
        near(getattr(made, f"{name}_unbalance") / MICRO, size)
        near(math.degrees(getattr(made, f"{name}_angle")), angle, READ)
    assert all(check.passed for check in made.checks)


def test_trial_weight_in_one_plane() -> None:
    made = trial(sensors=Sensor(reading(6, 40), reading(8, 110)), first_trial=TrialWeight(0.005, 0.0))
    size, angle = REFERENCES["one_plane"]["masses"][0]
    near(made.first_mass * 1e3, size)
    near(math.degrees(made.first_angle or 0.0), angle)
    assert made.second_mass is None
    assert made.condition is None


@pytest.mark.parametrize(("case", "sensors"), [("two_planes", TWO), ("least_squares", (*TWO, THIRD))])
def test_trial_weights_in_two_planes(case: str, sensors: tuple[Sensor, ...]) -> None:
    made = trial(sensors=sensors, first_trial=WEIGHT, second_trial=WEIGHT)
    wanted = REFERENCES[case]
    for name, (size, angle) in zip(("first", "second"), wanted["masses"], strict=True):
        near(getattr(made, f"{name}_mass") * 1e3, size, READ)
        near(math.degrees(getattr(made, f"{name}_angle")), angle, READ)
    for row, residual in zip(made.predicted, wanted["residuals"], strict=True):
        assert row.residual.value / MICRO == pytest.approx(float(residual), rel=READ)


@pytest.mark.parametrize("case", REFERENCES["four_runs"])
def test_four_runs_without_phase(case: dict[str, Any]) -> None:
    readings = [float(size) for _, size in case["runs"]]
    angles = [math.radians(angle) for angle, _ in case["runs"]]
    made = four_runs(
        initial=float(case["still"]), first=readings[0], second=readings[1], third=readings[2],
        trial_mass=float(case["trial"]), first_angle=angles[0], second_angle=angles[1], third_angle=angles[2],
    )  # fmt: skip
    size, angle = case["mass"]
    near(made.mass, size, READ)
    near(math.degrees(made.angle), angle, READ)
    near(made.consistency, case["consistency"], READ)
    near(made.effect.value, case["effect"], READ)
    near(made.miss.value, case["miss"], READ)
    assert [one.code for one in made.advice] == (["inconsistent"] if case["still"] == "6" else [])


def test_condition_is_of_columns_of_length_one() -> None:
    made = trial(sensors=TWO, first_trial=WEIGHT, second_trial=WEIGHT)
    assert made.condition == pytest.approx(1.778187722767, rel=1e-12)


@pytest.mark.parametrize("ratio", REFERENCES["orders"])
def test_orders_of_a_piston(ratio: str) -> None:
    for order, wanted in zip((2, 4, 6), REFERENCES["orders"][ratio], strict=True):
        near(order_factor(float(ratio), order), wanted)


@pytest.mark.parametrize("case", REFERENCES["offset_orders"])
def test_orders_of_a_piston_beside_the_crankshaft(case: str) -> None:
    ratio, offset = map(float, case.split())
    made = order_factors(ratio, offset, [1, 2, 3, 4, 5, 6])
    for (a, b), wanted in zip(made, REFERENCES["offset_orders"][case], strict=True):
        assert [a, b] == pytest.approx([float(text) for text in wanted], rel=0.0, abs=MEANS)


@pytest.mark.parametrize("order", [name for name in REFERENCES["turning"]["0.3 0.05"] if name != "0"])
def test_turning_moment_of_one_cylinder_by_order(order: str) -> None:
    """The same diagram for gas alone, and no gas: in units of bar·A·r and m·r²·ω²."""
    points = REFERENCES["turning"]["diagram"]
    crank: dict[str, Any] = {
        "bore": 2.0 / math.sqrt(math.pi), "crank": CrankRadius(1.0), "rod_length": 1.0 / 0.3, "offset": 0.05 / 0.3,
        "speed": 1.0, "cylinders": (Cylinder(0.0),),
    }  # fmt: skip
    wanted = [complex(*map(float, pair)) for pair in REFERENCES["turning"]["0.3 0.05"][order]]
    for part, (pressure, mass) in enumerate(((1.0, 0.0), (0.0, 1.0))):
        rows = tuple(Diagram(math.radians(angle), p * pressure) for angle, p in points)
        made = turning(diagram_points=rows, reciprocating_mass=mass, **crank)
        row = next((one for one in made.orders if one.order == float(order)), None)
        value = cmath.rect(row.torque, row.phase or 0.0) if row else 0j
        assert abs(value - wanted[part]) < QUADRATURE * (25.0 if part == 0 else 1.0)
        mean = [complex(*map(float, pair)) for pair in REFERENCES["turning"]["0.3 0.05"]["0"]][part]
        assert 2.0 * made.mean_torque == pytest.approx(mean.real if part == 0 else 0.0, abs=QUADRATURE * 25.0)


@pytest.mark.parametrize("name", REFERENCES["engines"])
def test_engines(name: str) -> None:
    made = engine(
        reciprocating_mass=1.0, crank=CrankRadius(1.0), rod_length=4.0, speed=1.0, preset=Preset(name), spacing=1.0
    )
    for row in made.orders[:3]:
        wanted = [float(text) for text in REFERENCES["engines"][name][str(row.order)]]
        sizes = [row.forward, row.backward, row.forward_couple, row.backward_couple]
        assert sizes == pytest.approx(wanted, rel=1e-13, abs=0.0)


def test_lanchester_takes_the_second_order_of_four_cylinders() -> None:
    crank: dict[str, Any] = {
        "reciprocating_mass": 0.5,
        "crank": CrankRadius(0.043),
        "rod_length": 0.172,
        "speed": 6000 * RPM,
    }
    made = lanchester(**crank)
    near(made.force, "8624.5157638570279608")
    near(made.shaft_unbalance / MICRO, "2730.7692047999842231")
    shafts = [one for one in engine(**crank, preset=Preset("inline-4")).shafts if one.order == 2]
    assert [one.unbalance for one in shafts] == pytest.approx([made.shaft_unbalance] * 2, rel=EXACT)
    assert [one.speed for one in shafts] == pytest.approx([made.shaft_speed] * 2)


def test_flywheel_looks_between_the_points_of_the_table() -> None:
    table = ((0, -80), (30, 400), (75, 900), (120, 350), (180, -120), (270, -160), (360, -80))
    made = flywheel(points=tuple(Point(math.radians(a), float(t)) for a, t in table), speed=300 * RPM)
    wanted = REFERENCES["flywheel"]
    near(made.mean_torque, wanted["mean"])
    near(made.energy, wanted["energy"])
    near(made.inertia, wanted["inertia"])
    near(math.degrees(made.slowest), wanted["slowest"])
    near(math.degrees(made.fastest), wanted["fastest"])


def test_grade_and_split() -> None:
    made = grade(grade=0.0063, speed=3000 * RPM, mass=120.0)
    near(made.eccentricity / MICRO, "20.053522829578812307")
    near(made.unbalance / MICRO, "2406.4227395494574768")
    angles = Angles(math.radians(20), math.radians(65))
    parts = split(mass=10.0, angle=math.radians(37), places=angles)
    near(parts.first_mass, "6.6393305124029875324")
    near(parts.second_mass, "4.1347603007303616607")
