"""What holds of every rotor and engine: nothing is left of a balanced one, orders add up to the exact force."""

import cmath
import itertools
import math
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.balance.engines.crank import CrankRadius
from dynamics_cli.balance.engines.engine import Cylinder, engine
from dynamics_cli.balance.engines.firing import Strokes
from dynamics_cli.balance.engines.layouts import Preset
from dynamics_cli.balance.engines.turning import Diagram, turning
from dynamics_cli.balance.flywheel import Point, flywheel
from dynamics_cli.balance.four_runs import four_runs
from dynamics_cli.balance.grade import grade
from dynamics_cli.balance.planes import Unbalance, planes
from dynamics_cli.balance.split import Holes, split
from dynamics_cli.balance.trial import Phase, Sensor, TrialWeight, trial
from dynamics_cli.errors import InadmissibleError

angles = st.floats(-3.0, 3.0)
sizes = st.floats(0.1, 10.0)
few = settings(max_examples=25, deadline=None)


@few
@given(st.lists(st.tuples(sizes, angles, st.floats(-2.0, 2.0)), min_size=1, max_size=5), st.floats(0.2, 3.0))
def test_a_balanced_rotor_has_no_residue(rows: list[tuple[float, float, float]], span: float) -> None:
    those = tuple(Unbalance(*row) for row in rows)
    made = planes(unbalances=those, first_plane=-0.1, second_plane=span)
    added = [(made.first_unbalance, made.first_angle, -0.1), (made.second_unbalance, made.second_angle, span)]
    whole = [*rows, *((size, angle or 0.0, place) for size, angle, place in added)]
    scale = sum(size for size, _, _ in whole) * 3.0
    assert abs(sum(cmath.rect(u, a) for u, a, _ in whole)) <= 1e-13 * scale
    assert abs(sum(cmath.rect(u, a) * z for u, a, z in whole)) <= 1e-13 * scale


def pair(z: complex) -> Any:
    return z.real, z.imag


@few
@given(st.lists(st.complex_numbers(min_magnitude=0.5, max_magnitude=2.0), min_size=6, max_size=6), angles, angles)
def test_trial_runs_of_a_known_rotor_give_its_unbalance(z: list[complex], one: float, other: float) -> None:
    """Readings of a rotor whose coefficients are known lead back to what unbalances it, lag or lead, left on or not."""
    alpha = [[z[0] + 4.0, z[1]], [z[2], z[3] - 4.0]]
    unbalance = z[4:]
    puts = cmath.rect(0.3, one), cmath.rect(0.2, other)
    for left_on in (False, True):
        for phase in ("lead", "lag"):
            sensors = []
            for row in alpha:
                start = row[0] * unbalance[0] + row[1] * unbalance[1]
                first = start + row[0] * puts[0]
                second = (first if left_on else start) + row[1] * puts[1]
                runs = [v.conjugate() if phase == "lag" else v for v in (start, first, second)]
                sensors.append(Sensor(*(pair(v) for v in runs)))
            made = trial(
                sensors=tuple(sensors),
                first_trial=TrialWeight(0.3, one),
                second_trial=TrialWeight(0.2, other),
                left_on=left_on,
                phase=Phase(phase),
            )
            assert made.second_mass is not None
            assert made.second_angle is not None
            assert abs(cmath.rect(made.first_mass, made.first_angle or 0.0) + unbalance[0]) < 1e-11
            assert abs(cmath.rect(made.second_mass, made.second_angle) + unbalance[1]) < 1e-11


@few
@given(
    st.complex_numbers(min_magnitude=0.5, max_magnitude=2.0), st.complex_numbers(min_magnitude=0.5, max_magnitude=2.0),
    st.floats(0.3, 2.0), angles,
)  # fmt: skip
def test_amplitudes_of_four_runs_give_what_phases_give(
    alpha: complex, unbalance: complex, mass: float, at: float
) -> None:
    """The same synthetic runs with phases and without lead to the same correction, whose circles meet in a point."""
    start = alpha * unbalance
    places = [at, at + 2.0, at - 1.5]
    runs = [start + alpha * cmath.rect(mass, place) for place in places]
    made = four_runs(
        initial=abs(start), first=abs(runs[0]), second=abs(runs[1]), third=abs(runs[2]), trial_mass=mass,
        first_angle=places[0], second_angle=places[1], third_angle=places[2],
    )  # fmt: skip
    vectors = trial(sensors=Sensor(pair(start), pair(runs[0])), first_trial=TrialWeight(mass, at))
    assert cmath.rect(made.mass, made.angle) == pytest.approx(
        cmath.rect(vectors.first_mass, vectors.first_angle or 0.0), abs=1e-10
    )
    assert made.consistency == pytest.approx(1.0, rel=1e-10)
    assert abs(made.miss.value) < 1e-10
    assert made.effect.value == pytest.approx(abs(alpha) * mass, rel=1e-10)


@few
@given(
    st.lists(st.tuples(angles, angles, st.floats(-1.0, 1.0)), min_size=1, max_size=4),
    st.floats(0.1, 0.5),
    st.floats(0.0, 6.0),
    st.sampled_from([0.0, 0.2, -0.15, 0.01]),
)
def test_orders_sum_to_the_exact_force(
    rows: list[tuple[float, float, float]], ratio: float, turn: float, offset: float
) -> None:
    made = engine(
        reciprocating_mass=2.0, crank=CrankRadius(1.0), rod_length=1.0 / ratio, offset=offset / ratio, speed=1.0,
        highest_order=40, cylinders=tuple(Cylinder(*row) for row in rows),
    )  # fmt: skip
    force = couple = 0j
    for crank, bank, place in rows:
        s, c = math.sin(turn + crank - bank), math.cos(turn + crank - bank)
        lean = ratio * s - offset
        root = math.sqrt(1.0 - lean * lean)
        away = 2.0 * (c + (ratio * c * c - s * lean) / root + ratio * (lean * c) ** 2 / root**3)
        force += cmath.rect(away, bank)
        couple += cmath.rect(away * place, bank)
    orders = forces = 0j
    for row in made.orders:
        orders += cmath.rect(row.forward, (row.forward_angle or 0.0) + row.order * turn)
        orders += cmath.rect(row.backward, (row.backward_angle or 0.0) - row.order * turn)
        forces += cmath.rect(row.forward_couple or 0.0, (row.forward_couple_angle or 0.0) + row.order * turn)
        forces += cmath.rect(row.backward_couple or 0.0, (row.backward_couple_angle or 0.0) - row.order * turn)
    assert abs(orders - force) < 1e-10
    assert abs(forces - couple) < 1e-10
    for shaft in made.shafts:
        sense = 1.0 if shaft.turns == "with the crank" else -1.0
        for size, angle in ((shaft.unbalance, shaft.angle), (shaft.couple or 0.0, shaft.couple_angle)):
            turned = cmath.rect(size * shaft.speed**2, (angle or 0.0) + sense * shaft.order * turn)
            if angle is not None and size is shaft.unbalance:
                orders += turned
            elif angle is not None:
                forces += turned
    # the shafts take everything away
    assert abs(orders) < 1e-10
    assert abs(forces) < 1e-10


@few
@given(sizes, angles, st.integers(3, 36))
def test_holes_hold_the_correction(mass: float, angle: float, holes: int) -> None:
    made = split(mass=mass, angle=angle, places=Holes(holes))
    both = cmath.rect(made.first_mass, made.first_angle) + cmath.rect(made.second_mass, made.second_angle)
    assert abs(both - cmath.rect(mass, angle)) < 1e-12 * mass
    near = split(mass=mass, angle=angle, places=Holes(holes), stock=0.01)
    assert near.residual <= 0.0075
    assert near.first_mass == pytest.approx(made.first_mass, abs=0.0101)


def test_a_correction_at_a_hole_is_put_there_alone() -> None:
    made = split(mass=3.0, angle=math.pi / 3.0, places=Holes(12))
    assert (made.first_hole, made.second_mass) == (3, 0.0)
    assert made.first_mass == pytest.approx(3.0, rel=1e-15)


@few
@given(st.lists(st.floats(-100.0, 100.0), min_size=3, max_size=8).filter(lambda t: max(t) - min(t) > 1.0))
def test_a_flywheel_of_this_inertia_keeps_the_fluctuation(torques: list[float]) -> None:
    table = [*torques, torques[0]]
    made = flywheel(points=tuple(Point(float(i), t) for i, t in enumerate(table)), speed=10.0, fluctuation=0.05)
    assert made.inertia * 0.05 * 100.0 == pytest.approx(made.energy, rel=1e-14)
    energies = [row.energy for row in made.crossings]
    assert max(energies) - min(energies) == made.energy > 0.0
    kinds = [row.speed for row in made.crossings]
    assert all(one != other for one, other in itertools.pairwise(kinds))


@pytest.mark.parametrize(("first", "second", "share"), [(0.2, 0.3, 0.6), (0.1, 0.9, 0.7), (0.9, 0.1, 0.3)])
def test_shares_of_planes_are_kept_within_bounds(first: float, second: float, share: float) -> None:
    made = grade(grade=0.001, speed=1.0, mass=1.0, first_distance=first, second_distance=second, measured=0.002)
    assert (made.first_unbalance, made.second_unbalance) == pytest.approx((share * 1e-3, (1.0 - share) * 1e-3))
    assert made.permitted is False
    assert made.usage == pytest.approx(2.0)
    assert bool(made.advice) == (share in (0.3, 0.7))


PRESSURES = [(0, 25.0), (20, 55.0), (90, 8.0), (180, 0.0), (540, 0.0), (700, 12.0), (720, 25.0)]


def of_engine(**more: Any) -> Any:
    given: dict[str, Any] = {
        "diagram_points": tuple(Diagram(math.radians(a), 1e5 * p) for a, p in PRESSURES), "bore": 0.08,
        "reciprocating_mass": 0.5, "crank": CrankRadius(0.04), "rod_length": 0.13, "speed": 200.0, **more,
    }  # fmt: skip
    return turning(**given)


@pytest.mark.parametrize("name", ["inline-1", "inline-3", "inline-4", "v2", "v6", "radial-5", "boxer-4"])
@pytest.mark.parametrize("offset", [0.0, 0.006])
def test_orders_sum_to_the_turning_moment(name: str, offset: float) -> None:
    smooth = tuple(Diagram(math.radians(a), 1e6 * (1.0 + math.cos(math.radians(a / 2)))) for a in range(0, 721, 4))
    made = of_engine(
        preset=Preset(name), offset=offset, highest_order=20, step=math.radians(15.0), diagram_points=smooth
    )
    scale = max(abs(row.torque) for row in made.torque)
    for point in made.torque:
        waves = sum(row.torque * math.cos(row.order * point.angle + (row.phase or 0.0)) for row in made.orders)
        # the diagram is a wave of order ½ by chords of 4 degrees: beyond order 20 is less than their sag
        assert abs(made.mean_torque + waves - point.torque) < math.radians(2.0) ** 2 / 8.0 * scale
    assert made.torque[-1].torque == made.torque[0].torque


def test_a_cylinder_may_have_its_own_pressures() -> None:
    """Of four without gas in one: what cancelled is one cylinder's, the rest is three's; alike ones change nothing."""
    usual = of_engine(preset=Preset("inline-4"))
    points = [Diagram(math.radians(a), 1e5 * p) for a, p in PRESSURES]
    empty = [Diagram(math.radians(a), 0.0, 2) for a in (0, 360, 720)]
    dead = of_engine(preset=Preset("inline-4"), diagram_points=(*points, *empty))
    assert dead.mean_torque == pytest.approx(0.75 * usual.mean_torque, rel=1e-12)
    gas = {row.order: row.gas for row in usual.orders}
    alone = {row.order: row.gas for row in of_engine(preset=Preset("inline-1")).orders}
    for row in dead.orders:
        assert row.gas == pytest.approx(0.75 * gas[row.order] if row.order in gas else alone[row.order], rel=1e-9)
    alike = [Diagram(one.angle, one.pressure, 3) for one in points]
    same = of_engine(preset=Preset("inline-4"), diagram_points=(*points, *alike))
    for one, other in zip(same.torque, usual.torque, strict=True):
        assert one.torque == pytest.approx(other.torque, rel=1e-12, abs=1e-10)


@pytest.mark.parametrize(("more", "code"), [([Diagram(0.0, 0.0, 7)], "cylinder"), ([Diagram(0.0, 0.0, 2)], "too-few")])
def test_pressures_of_a_cylinder_that_are_no_cycle_are_refused(more: list[Diagram], code: str) -> None:
    points = [Diagram(math.radians(a), 1e5 * p) for a, p in PRESSURES]
    with pytest.raises(InadmissibleError) as caught:
        of_engine(preset=Preset("inline-4"), diagram_points=(*points, *more))
    assert caught.value.code == code


def test_the_mean_torque_is_the_work_of_the_diagram() -> None:
    """∮p dV by volumes at 0.01 degrees, N cylinders, over the angle of the cycle."""

    def volume(angle: float) -> float:
        lean = 0.04 / 0.13 * math.sin(angle)
        return -math.pi * 0.04**2 * (0.04 * math.cos(angle) + 0.13 * math.sqrt(1.0 - lean * lean))

    work = 0.0
    for (a, p), (b, q) in itertools.pairwise(PRESSURES):
        steps = 100 * (b - a)
        for k in range(steps):
            share = (k + 0.5) / steps
            low, high = (math.radians(a + (b - a) * (k + i) / steps) for i in (0, 1))
            work += 1e5 * (p + (q - p) * share) * (volume(high) - volume(low))
    for name, count in (("inline-1", 1), ("inline-4", 4), ("v12", 12)):
        made = of_engine(preset=Preset(name))
        assert made.mean_torque == pytest.approx(count * work / (4.0 * math.pi), rel=1e-7)
        assert made.power == pytest.approx(200.0 * made.mean_torque)


@pytest.mark.parametrize(
    ("name", "interval"),
    [("inline-3", 240), ("inline-4", 180), ("inline-5", 144), ("inline-6", 120), ("v6", 120), ("v8-cross", 90),
     ("v12", 60), ("radial-9", 80), ("boxer-4", 180), ("boxer-6", 120), ("boxer-2", 360)],
)  # fmt: skip
def test_usual_engines_fire_evenly(name: str, interval: int) -> None:
    made = of_engine(preset=Preset(name))
    assert made.evenness == f"even, every {interval} deg"
    again = of_engine(preset=Preset(name), firing_order=made.firing_order)
    assert [row.angle for row in again.firings] == pytest.approx([row.angle for row in made.firings])


def test_radial_engines_fire_every_second_cylinder() -> None:
    assert of_engine(preset=Preset("radial-9")).firing_order == "1-3-5-7-9-2-4-6-8"
    assert of_engine(preset=Preset("v2")).evenness == "uneven: 450, 270 deg"


def test_two_strokes_fire_every_turn() -> None:
    points = tuple(Diagram(math.radians(a), 1e5 * p) for a, p in ((0, 25), (20, 55), (90, 8), (180, 0), (360, 25)))
    made = of_engine(preset=Preset("inline-3"), diagram_points=points, strokes=Strokes("two"))
    assert made.evenness == "even, every 120 deg"
    assert {row.order for row in made.orders} == {3.0, 6.0}
