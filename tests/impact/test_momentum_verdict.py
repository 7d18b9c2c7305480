"""How far momentum determines each speed, and that its intervals hold every point that physics allows."""

import math
import os
from typing import Any

import numpy as np
import pytest
from harness import answer, run
from mpmath import mp, mpf

from dynamics_cli.core.inputs.uncertain.distributions import Normal
from dynamics_cli.core.uncertainty.model import Sampled
from dynamics_cli.core.uncertainty.propagation import propagate
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.impact.conventions import ByMass
from dynamics_cli.impact.reconstruction.crush import Damaged, GivenEnergy, MeanCrush, Opponent, Stations, crush
from dynamics_cli.impact.reconstruction.crush_stiffness import Coefficients
from dynamics_cli.impact.reconstruction.momentum import Branch, CrushEnergies, Vehicle, momentum, momentum_and_energy
from dynamics_cli.sampling import Drawing

# masses; speed and heading after of both; headings before: speeds before, tolerances in degrees (40-digit references)
TOLERANCES = [
    ((8000, 300), (15, 2, 14, 10), (0, 90),
     ("15.507886475617845181", "16.390873168337413542"), (144.5579, 0.22709280610783763829)),
    ((18000, 250), (14, 0.5, 12, 20), (0, 80),
     ("14.124488998636404952", "13.099601889617770428"), (31.24, 0.072682013072605139046)),
    ((1500, 1200), (8, 40, 9, 37), (0, 90),
     ("11.878531217292332775", "11.844211305233827782"), (7.1827250462901408580, 4.5704190663783028844)),
    ((1600, 200), (11, 3, 9, 25), (0, 75),
     ("11.722868743719489284", "8.7057704392804040179"), (19.09, 0.51374751271992661486)),
    ((1500, 1300), (13, 4, 12, 7), (0, 12),
     ("13.061651446223193849", "12.066561611596278499"), (1.2087, 0.95376)),
]  # fmt: skip


def options(masses: Any, after: Any, before: Any) -> list[str]:
    return [
        *("--first-mass", f"{masses[0]} kg", "--second-mass", f"{masses[1]} kg"),
        *("--first-exit-speed", f"{after[0]} m/s", "--first-exit-heading", f"{after[1]} deg"),
        *("--second-exit-speed", f"{after[2]} m/s", "--second-exit-heading", f"{after[3]} deg"),
        *("--first-approach-heading", f"{before[0]} deg", "--second-approach-heading", f"{before[1]} deg"),
        *("--units", "base"),
    ]


def reconstructed_at(masses: Any, after: Any, one: Any, other: Any) -> Any:
    """Of headings before, angles in radians."""
    first = Vehicle(ByMass(float(masses[0])), None, one, float(after[0]), after[1])
    return momentum(first=first, second=Vehicle(ByMass(float(masses[1])), None, other, float(after[2]), after[3]))


def reconstructed(masses: Any, after: Any, before: Any) -> Any:
    turned = after[0], math.radians(after[1]), after[2], math.radians(after[3])
    return reconstructed_at(masses, turned, *map(math.radians, before))


@pytest.mark.parametrize(("masses", "after", "before", "speeds", "tolerances"), TOLERANCES)
def test_every_speed_has_its_own_tolerance(masses: Any, after: Any, before: Any, speeds: Any, tolerances: Any) -> None:
    found = reconstructed(masses, after, before)
    for side, speed, tolerance in zip((found.first, found.second), speeds, tolerances, strict=True):
        assert side.approach_speed == pytest.approx(float(speed), rel=1e-13)
        assert math.degrees(side.determined.heading_tolerance) == pytest.approx(tolerance, rel=3e-4)
        expected = "good" if tolerance >= 3.0 else "caution" if tolerance >= 1.0 else "undetermined"
        assert side.determined.verdict == expected
        assert side.determined.per_degree == pytest.approx(0.1 * float(speed) / tolerance, rel=3e-4)


def test_a_degree_of_the_worst_heading_and_the_name_of_its_vehicle() -> None:
    light = [reconstructed(masses, after, before) for masses, after, before, _, _ in TOLERANCES[:2]]
    found = [one.second.determined.per_degree for one in light]
    assert found == pytest.approx([7.2176981073341529842, 18.023168781156382768], rel=1e-13)
    named = run("impact", "momentum", *options((8000, 300), (15, 2, 14, 10), (0, 90)), "--second-name", "Scooter")
    assert "Scooter verdict          undetermined" in named.out
    assert "v₂ error per degree      7.2177 m/s" in named.out
    assert "does not determine the speed of Scooter: one degree of the\n  approach heading of the first" in named.out


def closing_speeds(unknown: str) -> Any:
    """Vehicles of a crash at right angles with one quantity of the second left out."""
    first = Vehicle(ByMass(1500.0), None, 0.1, 8.0, 0.7)
    second = {"approach_speed": 11.0, "approach_heading": 1.6, "exit_speed": 9.0, "exit_heading": 0.65}
    return first, Vehicle(ByMass(1200.0), **{name: None if name == unknown else second[name] for name in second})


@pytest.mark.parametrize("unknown", ["approach_speed", "exit_speed", "approach_heading", "exit_heading", "nothing"])
def test_tolerances_are_those_of_differences(unknown: str) -> None:
    def speed(first: Vehicle, second: Vehicle) -> float:
        with Drawing():
            return momentum(first=first, second=second, branch=Branch("larger")).first.approach_speed

    first, second = closing_speeds(unknown)
    found = momentum(first=first, second=second, branch=Branch("larger"))
    steepest, worst = 0.0, ""
    for side, vehicle in (("first", first), ("second", second)):
        for name in ("approach_heading", "exit_heading"):
            if getattr(vehicle, name) is None:
                continue
            ends = []
            for step in (1e-5, -1e-5):
                moved = Vehicle(**{**vehicle.__dict__, name: getattr(vehicle, name) + step})
                ends.append(speed(moved, second) if side == "first" else speed(first, moved))
            slope = abs(ends[0] - ends[1]) / 2e-5
            if slope > steepest:
                steepest, worst = slope, f"{side}.{name}"
    stated = found.first.determined
    assert stated.worst_heading == worst
    assert stated.heading_tolerance == pytest.approx(0.1 * found.first.approach_speed / steepest, rel=1e-6)


def test_a_light_vehicle_at_right_angles_is_not_determined_and_the_heavy_one_is() -> None:
    document = answer("impact", "momentum", *options((90, 20000), (8, 88, 10, 89.9), (0, 90)))
    results = document["results"]
    assert results["angle_condition"]["value"] == pytest.approx(1.0)
    assert [results[side]["determined"]["verdict"] for side in ("first", "second")] == ["undetermined", "good"]
    assert document["warnings"][0]["code"] == "undetermined-speed"
    assert document["warnings"][0]["severity"] == "serious"
    assert "the approach heading of the second changes it by 38.9 m/s" in document["warnings"][0]["message"]


def test_a_refusal_by_judgement_gives_the_interval_and_one_by_physics_does_not() -> None:
    near = run("impact", "momentum", *options((1500, 1300), (13, 4, 12, 4.5), (0, "9 ± 3")), "--json")
    assert (near.status, near.error["code"]) == (3, "undetermined")
    assert "first.approach_speed is from 2.6" in near.error["hint"]
    sure = run("impact", "momentum", *options((1500, 1300), (13, 4, 12, 4.5), (0, 9)), "--json")
    assert (sure.status, sure.error["code"]) == (3, "undetermined")
    assert "is from" not in sure.error["hint"]
    back = run("impact", "momentum", *options((1500, 1300), (13, 4, 12, 4.5), (0, "4 ± 3")), "--json")
    assert (back.status, back.error["code"]) == (3, "backwards")


class Crash:
    """The two speeds by Cramer's rule, and whether physics allows them; for numbers of mpmath or arrays."""

    def __init__(self, masses: Any, after: Any) -> None:
        self.masses = masses
        self.after = after

    def speeds(self, one: Any, other: Any, m: Any = np) -> Any:
        (m1, m2), (u1, b1, u2, b2) = self.masses, self.after
        x = m1 * u1 * m.cos(b1) + m2 * u2 * m.cos(b2)
        y = m1 * u1 * m.sin(b1) + m2 * u2 * m.sin(b2)
        whole = m.cos(one) * m.sin(other) - m.sin(one) * m.cos(other)
        return (x * m.sin(other) - y * m.cos(other)) / (m1 * whole), (y * m.cos(one) - x * m.sin(one)) / (m2 * whole)

    def allowed(self, one: Any, other: Any, m: Any = np) -> Any:
        (m1, m2), (u1, b1, u2, _) = self.masses, self.after
        v1, v2 = self.speeds(one, other, m)
        lost = m1 * (v1 * v1 - u1 * u1) + m2 * (v2 * v2 - u2 * u2)
        push = u1 * m.cos(b1) - v1 * m.cos(one), u1 * m.sin(b1) - v1 * m.sin(one)
        closing = v1 * m.cos(one) - v2 * m.cos(other), v1 * m.sin(one) - v2 * m.sin(other)
        pushed = closing[0] * push[0] + closing[1] * push[1]
        return (v1 >= 0) & (v2 >= 0) & (lost >= 0) & (pushed <= 0)


def exact_interval(crash: Crash, middle: Any, deviation: Any) -> tuple[list[Any], Any, Any]:
    """Quantiles at 2.5, 50 and 97.5 % of the first speed, its deviation and the share left out, of one heading."""

    def at(z: Any) -> Any:
        return middle + deviation * z

    cut = mp.findroot(lambda z: crash.speeds(mpf(0), at(z), mp)[0], (mpf("-1.8"), mpf("-1.9")), solver="anderson")
    while not crash.allowed(mpf(0), at(cut + mpf(10) ** -15), mp):
        cut += mpf(10) ** -15
    inside = 1 - mp.ncdf(cut)
    scores = [mp.findroot(lambda z, p=p: mp.ncdf(z) - mp.ncdf(cut) - p * inside, 0) for p in (0.025, 0.5, 0.975)]
    moments = [
        mp.quad(lambda z, k=k: mp.npdf(z) * crash.speeds(mpf(0), at(z), mp)[0] ** k, [cut, -1, 0, 1, 2, 4, 9]) / inside
        for k in (1, 2)
    ]
    quantiles = [crash.speeds(mpf(0), at(z), mp)[0] for z in scores]
    return quantiles, mp.sqrt(moments[1] - moments[0] ** 2), 1 - inside


def speeds_of(masses: Any, after: Any) -> Any:
    """The program's two speeds as a model of both headings before: rows that physics refuses are left out."""

    def model(inputs: dict[str, Any]) -> tuple[dict[str, Any], Any]:
        count = max(np.size(value) for value in inputs.values())
        columns = [np.broadcast_to(inputs[name], count).astype(float) for name in ("one", "other")]
        kept = np.arange(count)
        speeds = np.full((2, count), np.nan)
        while kept.size:
            one, other = (column[kept].view(Sampled) for column in columns)
            try:
                with Drawing():
                    found = reconstructed_at(masses, after, one, other)
            except InadmissibleError as error:
                kept = kept[~np.asarray(error.refused)]
                continue
            speeds[:, kept] = found.first.approach_speed, found.second.approach_speed
            break
        return {"first": speeds[0], "second": speeds[1]}, np.isnan(speeds[0])

    return model


def test_ill_conditioned_points_stay_in_the_interval() -> None:
    """The angle condition is above 12 for most of these points; only speeds below zero leave the distribution."""
    with mp.workdps(30):
        degree = mp.pi / 180
        crash = Crash((1500, 1250), (10, 4 * degree, 11, 5 * degree))
        quantiles, deviation, outside = exact_interval(crash, 10 * degree, 3 * degree)
    document = answer("impact", "momentum", *options((1500, 1250), (10, 4, 11, 5), (0, "10 ± 3")))
    speed = document["results"]["first"]["approach_speed"]
    assert [*speed["interval"], speed["median"]] == pytest.approx(
        [float(quantiles[0]), float(quantiles[2]), float(quantiles[1])], abs=1e-4 * float(deviation)
    )
    assert speed["interval"] == pytest.approx([2.85, 13.86], abs=0.01)
    assert speed["std"] == pytest.approx(float(deviation), rel=1e-4)
    stated = document["numerics"]["uncertainty"]["results"]["first.approach_speed"]
    assert 1.0 - stated["admissible"] == pytest.approx(float(outside), rel=1e-6)


def test_the_reference_crash_of_twelve_degrees() -> None:
    degree = math.pi / 180.0
    model = speeds_of((1500, 1300), (13, 4 * degree, 12, 7 * degree))
    spreads = propagate(
        model, {"one": Normal(0.0, 0.0), "other": Normal(12 * degree, 3 * degree)}, shares=False
    ).spreads
    for side, interval in (
        ("first", [4.6974465329824061556, 16.557856821189150849]),
        ("second", [8.1638319138959755789, 21.600071993289298715]),
    ):
        assert spreads[side].interval == pytest.approx(interval, rel=1e-4)
        assert 1.0 - spreads[side].admissible == pytest.approx(0.013133722206737024692, rel=1e-6)


def random_problem(generator: Any) -> tuple[Any, Any, float, Any]:
    """Two cars that stay together but for a degree or two, on paths 8 to 60 degrees apart; angles in radians."""
    masses = generator.uniform(900.0, 2200.0, 2).tolist()
    v1, v2 = generator.uniform(8.0, 20.0, 2)
    apart = math.radians(generator.uniform(8.0, 60.0))
    x = (masses[0] * v1 + masses[1] * v2 * math.cos(apart)) / sum(masses)
    y = masses[1] * v2 * math.sin(apart) / sum(masses)
    size, way = math.hypot(x, y), math.atan2(y, x)
    return masses, (0.98 * size, way - 0.01, 1.02 * size, way + 0.01), apart, np.radians(generator.uniform(0.5, 4.0, 2))


def test_stated_intervals_cover_random_crashes() -> None:
    """Of two uncertain headings; an independent sample of 200,000 physical points is the reference.

    The long search of bounds (SEARCH_EVALUATIONS, tests/accuracy/search_length.py) takes twelve crashes.
    """
    generator = np.random.default_rng(15)
    count, inside, estimates = 200_000, [], []
    for _ in range(12 if "SEARCH_EVALUATIONS" in os.environ else 4):
        masses, after, apart, deviations = random_problem(generator)
        given = {"one": Normal(0.0, deviations[0]), "other": Normal(apart, deviations[1])}
        spreads = propagate(speeds_of(masses, after), given, shares=False, accuracy=1e-3).spreads
        crash = Crash(masses, after)
        one, other = generator.normal(np.array([[0.0], [apart]]), deviations[:, None], (2, count))
        allowed = crash.allowed(one, other)
        for side, every in zip(("first", "second"), crash.speeds(one, other), strict=True):
            sample, spread = every[allowed], spreads[side]
            assert spread.admissible == pytest.approx(allowed.mean(), abs=5.0 * math.sqrt(0.25 / count))
            low, high = spread.interval
            share = float(np.mean((sample >= low) & (sample <= high)))
            inside.append(abs(share - 0.95) <= 4.0 * math.sqrt(0.05 * 0.95 / sample.size))
            # the quantiles of the sample have a scatter of their own
            blocks = np.array([np.quantile(part, (0.025, 0.975)) for part in np.array_split(sample, 20)])
            noise = blocks.std(axis=0) / math.sqrt(20.0)
            off = np.abs(np.array([low, high]) - np.quantile(sample, (0.025, 0.975)))
            estimates.append(bool((off <= spread.estimate * spread.std + 3.0 * noise).all()))
    assert all(inside)
    assert np.mean(estimates) >= 0.95


def test_a_steep_force_stays_in_the_distribution_of_its_energy() -> None:
    """E ∝ 1/cos²α of α = 40 ± 5 degrees: a sixth of the points are beyond the 45 degrees of the judgement."""
    call = ["impact", "crush", "--first-mass", "1500 kg", "--first-stiffness-a", "600 N/cm", "--first-stiffness-b",
            "45 N/cm^2", "--first-mean-crush", "30 cm", "--first-width", "150 cm", "--units", "base"]  # fmt: skip
    energy = answer(*call, "--first-force-angle", "40 ± 5 deg")["results"]["energy"]
    straight = crush(first=Damaged(ByMass(1500.0), Coefficients(6e4, 4.5e5), MeanCrush(0.3, 1.5))).energy
    scores = [-1.959963984540054, 1.959963984540054]
    ends = [straight / math.cos(math.radians(40.0 + 5.0 * z)) ** 2 for z in scores]
    assert energy["interval"] == pytest.approx(ends, rel=1e-6)
    beyond = run(*call, "--first-force-angle", "46 ± 1 deg", "--json")
    assert (beyond.status, beyond.error["code"]) == (3, "force-angle")
    assert "energy is from" in beyond.error["hint"]


def on_one_line(**change: float) -> Any:
    """Cars that met on one line, by energy; headings straight on."""
    given = {"energy": 40e3, "first_exit": 5.0, "second_exit": 6.5, **change}
    first = Vehicle(ByMass(1000.0), None, 0.0, given["first_exit"], 0.0)
    second = Vehicle(ByMass(1400.0), None, 0.0, given["second_exit"], 0.0)
    return momentum_and_energy(
        first=first, second=second, damage=CrushEnergies(0.6 * given["energy"], 0.4 * given["energy"])
    )


@pytest.mark.parametrize("side", ["first", "second"])
def test_the_energy_route_is_judged_by_differences(side: str) -> None:
    found = on_one_line()
    own = getattr(found, side)
    effects = {}
    for name, size in (("energy", 40e3), ("first_exit", 5.0), ("second_exit", 6.5)):
        ends = [getattr(on_one_line(**{name: size * (1.0 + step)}), side).approach_speed for step in (1e-6, -1e-6)]
        effects[name] = abs(ends[0] - ends[1]) / 2e-6
    worst = max(effects, key=lambda name: effects[name])
    wanted = {"energy": "energy of deformation", "first_exit": "first.exit_speed", "second_exit": "second.exit_speed"}
    assert own.determined.worst_quantity == wanted[worst]
    scale = max(own.approach_speed, 0.25 * found.closing_speed)
    assert own.determined.tolerance == pytest.approx(0.1 * scale / effects[worst], rel=1e-6)
    assert (
        found.verdict == min((found.first, found.second), key=lambda one: one.determined.tolerance).determined.verdict
    )


def test_a_speed_that_energy_leaves_open_is_warned_of() -> None:
    slow = momentum_and_energy(
        first=Vehicle(ByMass(1000.0), None, 0.0, 3.0, 0.0), second=Vehicle(ByMass(1000.0), None, 0.0, 3.2, 0.0),
        damage=CrushEnergies(9e3, 0.0),
    )  # fmt: skip
    assert [slow.first.determined.verdict, slow.second.determined.verdict] == ["good", "caution"]
    assert [(note.code, note.severity) for note in slow.advice] == [("sensitive-speed", "caution")]


def test_damage_is_judged_by_differences() -> None:
    def speed(depth: float = 0.0, angle: float = 0.0) -> float:
        profile = Stations(tuple(0.01 * part + depth for part in (5, 20, 35, 10)), 1.5)
        car = Damaged(ByMass(1500.0), Coefficients(60e3, 500e3), profile, force_angle=0.5 + angle)
        return crush(first=car).first.equivalent_barrier_speed

    profile = Stations((0.05, 0.2, 0.35, 0.1), 1.5)
    car = Damaged(ByMass(1500.0), Coefficients(60e3, 500e3), profile, force_angle=0.5)
    one = crush(first=car).first
    for name, stated in (("depth", one.determined.depth_tolerance), ("angle", one.determined.angle_tolerance)):
        slope = abs(speed(**{name: 1e-6}) - speed(**{name: -1e-6})) / 2e-6
        assert stated == pytest.approx(0.1 * one.equivalent_barrier_speed / slope, rel=1e-6)
    assert one.determined.verdict == "good"


def test_shallow_crush_and_high_restitution_are_warned_of() -> None:
    car = Damaged(ByMass(1500.0), Coefficients(10e3, 900e3), MeanCrush(0.05, 1.5))
    found = crush(first=car, second=Opponent(ByMass(1200.0)), restitution=0.8)
    assert found.first.determined.verdict == "undetermined"
    assert [note.code for note in found.advice] == ["undetermined-damage", "sensitive-restitution"]
    more = crush(first=car, second=Opponent(ByMass(1200.0)), restitution=0.8 + 1e-6).first.delta_v
    less = crush(first=car, second=Opponent(ByMass(1200.0)), restitution=0.8 - 1e-6).first.delta_v
    assert found.restitution_tolerance == pytest.approx(0.1 * found.first.delta_v / ((more - less) / 2e-6), rel=1e-6)
    given = crush(first=Damaged(ByMass(1500.0), damage=GivenEnergy(5e4)))
    assert given.first.determined is None
