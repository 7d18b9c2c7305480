"""Trains: exact ratios by other methods, torques and powers that balance, and trains that cannot be."""

import itertools
import math
import random
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.gear.trains.scene import Mesh, Network, Planetary, Shaft, Stages
from dynamics_cli.gear.trains.train import TrainMotion, train

TEETH = st.integers(6, 300)
RPM = math.pi / 30.0


def shaft(answer: TrainMotion, name: str):
    return next(one for one in answer.shafts if one.name == name)


@given(st.lists(st.tuples(TEETH, TEETH), min_size=1, max_size=6))
def test_a_compound_train_multiplies_its_stages(pairs: list[tuple[int, int]]) -> None:
    answer = train(arrangement=Stages(", ".join(f"{a}:{b}" for a, b in pairs)))
    wanted = math.prod(Fraction(-b, a) for a, b in pairs)
    assert Fraction(answer.ratio) == wanted
    assert answer.ratio_value == float(wanted)
    assert all(check.passed for check in answer.checks)


@given(TEETH, TEETH, TEETH)
def test_an_idler_changes_only_the_sign(first: int, idler: int, last: int) -> None:
    with_idler = train(arrangement=Stages(f"{first}:{idler}:{last}"))
    without = train(arrangement=Stages(f"{first}:{last}"))
    assert Fraction(with_idler.ratio) == -Fraction(without.ratio)


@given(st.integers(10, 90), st.integers(5, 60), st.integers(5, 60), st.integers(100, 300))
def test_a_planetary_set_keeps_willis_formula(sun: int, inner: int, outer: int, ring: int) -> None:
    """Against the closed formula of each choice of fixed shaft."""
    stepped = Planetary(sun=sun, ring=ring, planet=inner, stepped=outer, planets=1)
    basic = Fraction(-ring * inner, sun * outer)
    for fixed, driver, driven, wanted in (
        ("ring", "sun", "carrier", 1 - basic),
        ("sun", "ring", "carrier", 1 - 1 / basic),
        ("carrier", "sun", "ring", basic),
        ("ring", "carrier", "sun", 1 / (1 - basic)),
    ):
        answer = train(arrangement=stepped, driver=driver, driven=driven, fixed=fixed)
        assert Fraction(answer.ratio) == wanted
        assert Fraction(answer.basic_ratio) == basic


def test_ten_thousand_million_to_one_is_exact() -> None:
    """1/(1 − 99999·100001/100000²) = 10¹⁰: a product of doubles loses ten digits here."""
    meshes = (
        Mesh("a", 99999, "planet", 100000, carrier="arm"),
        Mesh("planet", 100001, "b", 100000, carrier="arm"),
    )
    answer = train(arrangement=Network(meshes), driver="arm", driven="b", fixed="a", speed=1.0, torque=1e-3)
    assert answer.ratio == "10000000000"
    assert shaft(answer, "b").speed == 1e-10
    # the double nearest to −10⁷ times the double 0.001, rounded once
    assert shaft(answer, "b").torque == float(-(10**10) * Fraction(1e-3))
    assert all(check.passed for check in answer.checks)


def random_train(generator: random.Random) -> tuple[Network, list[str]]:
    """A connected train of one freedom: every new shaft is met once, now and then on a carrier."""
    names = ["s0"]
    meshes = []
    for index in range(1, generator.randint(2, 9)):
        other = generator.choice(names)
        free = [name for name in names if name != other]
        carrier = generator.choice(free) if free and generator.random() < 0.4 else "frame"
        internal = generator.random() < 0.3
        first = generator.randint(8, 90)
        second = generator.randint(first + 1, 200) if internal else generator.randint(8, 200)
        meshes.append(Mesh(other, first, f"s{index}", second, internal, carrier))
        names.append(f"s{index}")
    return Network(tuple(meshes)), names


def test_random_trains_agree_with_shaft_by_shaft_substitution() -> None:
    generator = random.Random(7)
    for _ in range(300):
        network, names = random_train(generator)
        speeds = {"s0": Fraction(1), "frame": Fraction(0)}
        for mesh in network.meshes:
            first, second = mesh.teeth
            arm = speeds[mesh.carrier]
            speeds[mesh.second] = arm - Fraction(first, second) * (speeds[mesh.first] - arm)
        last = names[-1]
        answer = train(arrangement=network, driver="s0", driven=last, speed=100.0, torque=3.0)
        for one in answer.shafts:
            assert Fraction(one.per_driver) == speeds[one.name]
            assert one.speed == float(100 * speeds[one.name])
        if speeds[last]:
            assert shaft(answer, last).torque == float(-3 / speeds[last]), network
            assert answer.input_power == 300.0
        assert all(check.passed for check in answer.checks)


@given(st.floats(-400.0, 400.0), st.floats(-400.0, 400.0))
def test_a_differential_adds_its_two_speeds(sun: float, ring: float) -> None:
    answer = train(
        arrangement=Planetary(sun=24, ring=72),
        fixed="none",
        speed=sun,
        shafts=(Shaft("ring", speed=ring),),
    )
    assert answer.freedom == 2
    assert shaft(answer, "carrier").speed == float((24 * Fraction(sun) + 72 * Fraction(ring)) / 96)
    assert answer.ratio is None


def test_a_differential_splits_torque_whatever_the_speeds() -> None:
    for ring in (-10.0, 0.0, 40.0):
        answer = train(
            arrangement=Planetary(sun=24, ring=72),
            fixed="none",
            speed=30.0,
            torque=2.0,
            shafts=(Shaft("ring", speed=ring),),
        )
        assert [shaft(answer, name).torque for name in ("sun", "ring", "carrier", "planet")] == [2.0, 6.0, -8.0, 0.0]


def test_power_instead_of_torque() -> None:
    by_torque = train(arrangement=Stages("20:60"), speed=157.0, torque=12.0)
    by_power = train(arrangement=Stages("20:60"), speed=157.0, power=12.0 * 157.0)
    assert by_power.shafts == by_torque.shafts
    assert by_power.input_power == 12.0 * 157.0


def coupled(sun_a: int, sun_b: int) -> Network:
    """Two sets whose suns share the driver and whose carriers share the output, one ring driven back by the other."""
    return Network(
        (
            Mesh("in", sun_a, "p", 20, carrier="out"),
            Mesh("p", 20, "link", 80, internal=True, carrier="out"),
            Mesh("link", sun_b, "q", 20),
            Mesh("q", 20, "out", 70, internal=True),
        )
    )


def test_circulating_power_is_seen() -> None:
    """Worked by hand: the gear loop from the ring back to the carrier carries more than goes in, or less."""
    answer = train(arrangement=coupled(40, 30), driver="in", driven="out", speed=1.0, torque=1.0)
    speeds = {one.name: Fraction(one.per_driver) for one in answer.shafts}
    # 40 in + 80 link = 120 out in the set; out = −30/70 link in the loop
    assert 40 * speeds["in"] + 80 * speeds["link"] == 120 * speeds["out"]
    assert speeds["out"] == Fraction(-30, 70) * speeds["link"]
    # the set's torques stand as 40 : 80 : −120, so the ring carries 2 N·m at its speed
    ring_flow = abs(2 * speeds["link"])
    carrier_flow = abs(3 * speeds["out"])
    wanted = max(Fraction(0), max(ring_flow, carrier_flow, Fraction(1)) - 1)
    assert answer.circulating_power == pytest.approx(float(wanted), rel=1e-15)
    assert answer.input_power == 1.0


def test_a_plain_train_circulates_nothing() -> None:
    assert train(arrangement=Stages("20:60, 18:54"), speed=1.0, torque=1.0).circulating_power == 0.0
    assert train(arrangement=Planetary(sun=24, ring=72), speed=1.0, torque=1.0).circulating_power == 0.0


def test_rolling_power_of_a_planetary_set() -> None:
    """In a set with its ring fixed the teeth carry P (1 − 1/i): three quarters at a ratio of four."""
    answer = train(arrangement=Planetary(sun=24, ring=72), speed=10.0, torque=4.0)
    assert [mesh.rolling_power for mesh in answer.meshes] == [30.0, 30.0]
    assert answer.meshes[0].frequency == pytest.approx(24 * 7.5 / (2 * math.pi), rel=1e-15)


def test_a_driven_shaft_may_stand_still() -> None:
    """Ferguson's paradox: with equal tooth numbers the last wheel does not turn at all."""
    meshes = (Mesh("a", 100, "p", 20, carrier="arm"), Mesh("p", 20, "b", 100, carrier="arm"))
    answer = train(arrangement=Network(meshes), driver="arm", driven="b", fixed="a")
    assert answer.ratio is None
    assert [one.code for one in answer.advice] == ["driven-stands"]
    assert shaft(answer, "b").per_driver == "0"


def test_parallel_ways_leave_torques_open() -> None:
    """Two equal paths from one shaft to another: speeds are settled, the share of the load is not."""
    meshes = (Mesh("a", 20, "p", 30), Mesh("a", 20, "q", 30), Mesh("p", 30, "b", 40), Mesh("q", 30, "b", 40))
    answer = train(arrangement=Network(meshes), driver="a", driven="b", speed=1.0, torque=1.0)
    assert answer.ratio == "2"
    assert "torques-open" in [one.code for one in answer.advice]
    assert answer.input_power is None


@pytest.mark.parametrize(
    ("arguments", "code", "message"),
    [
        ({"arrangement": Planetary(sun=24, ring=72), "fixed": "ring,carrier"}, "locked", "locked with ring, carrier"),
        ({"arrangement": Stages("20:60"), "fixed": "2"}, "locked", "locked with 2"),
        (
            {
                "arrangement": Network((Mesh("a", 20, "b", 30), Mesh("b", 30, "c", 40), Mesh("c", 40, "a", 20))),
                "driver": "a",
            },
            "locked",
            "allow no motion of its 3 shafts",
        ),
        (
            {"arrangement": Planetary(sun=24, ring=72), "fixed": "none"},
            "indeterminate",
            "2 speeds can be chosen and 1 are given",
        ),
        ({"arrangement": Planetary(sun=24, ring=72), "driver": "moon"}, "unknown-shaft", "no shaft 'moon'"),
        ({"arrangement": Planetary(sun=24, ring=72), "driver": "ring", "fixed": "ring"}, "fixed-driver", "also held"),
        ({"arrangement": Planetary(sun=24, ring=71)}, "planet", r"47/2 is not whole"),
        ({"arrangement": Planetary(sun=24, ring=72, planets=6)}, "planets-touch", "overlap by 2 modules"),
        ({"arrangement": Planetary(sun=72, ring=24)}, "no-planet", "24 teeth has no space"),
        ({"arrangement": Stages("20:-20")}, "no-room", "20 teeth cannot hold a gear of 20"),
        ({"arrangement": Stages("-20:-30")}, "two-internal-gears", "-20 and -30"),
        ({"arrangement": Stages("20")}, "stage", "the stage '20', wanted two"),
        ({"arrangement": Stages("20:0")}, "teeth", "'0' is not"),
        ({"arrangement": Stages("20:6.5")}, "teeth", "'6.5' is not"),
        ({"arrangement": Stages("20:60"), "power": 5.0}, "speed", "needs the speed"),
        ({"arrangement": Stages("20:60"), "power": 5.0, "torque": 5.0}, "torque", "not both"),
        (
            {"arrangement": Stages("20:60"), "speed": 1.0, "shafts": (Shaft("2", speed=1.0),)},
            "too-many-speeds",
            "only 1 can be chosen",
        ),
        ({"arrangement": Network((Mesh("a", 20, "a", 30),)), "driver": "a"}, "mesh", "all different"),
        ({"arrangement": Network((Mesh("a", 0, "b", 30),)), "driver": "a"}, "teeth", "has no teeth"),
    ],
)
def test_what_cannot_be_is_refused(arguments: dict, code: str, message: str) -> None:
    with pytest.raises(InadmissibleError, match=message) as caught:
        train(**arguments)
    assert caught.value.code == code


def places(answer: TrainMotion) -> list[Fraction]:
    assert answer.assembly is not None
    return [Fraction(place) for place in answer.assembly.places]


def fits(sun: int, inner: int, outer: int, ring: int, turn: Fraction) -> bool:
    """Whether a planet cut like the first goes in at this place: some turn of the planet suits both meshes."""
    return any(
        (Fraction(a) * outer - (outer - ring) * turn * inner + (sun + inner) * turn * outer) % inner == 0
        for a in range(inner * outer)
    )


@pytest.mark.parametrize(
    ("sun", "planet", "stepped", "ring", "planets"),
    [(24, 24, None, 72, 5), (20, 31, None, 82, 4), (21, 40, 18, 79, 3), (12, 18, 12, 42, 3), (15, 15, None, 45, 4)],
)
def test_planets_go_in_where_it_is_said_and_nowhere_nearer(
    sun: int, planet: int, stepped: int | None, ring: int, planets: int
) -> None:
    arrangement = Planetary(sun=sun, ring=ring, planet=planet, stepped=stepped, planets=planets)
    answer = train(arrangement=arrangement)
    assembly = answer.assembly
    assert assembly is not None
    outer = stepped or planet
    step = Fraction(math.gcd(planet, outer), sun * outer + ring * planet)
    for index, place in enumerate(places(answer)):
        assert fits(sun, planet, outer, ring, place)
        assert (place / step).denominator == 1
        assert abs(place - Fraction(index, planets)) <= step / 2
    assert assembly.equal_spacing == all(place == Fraction(k, planets) for k, place in enumerate(places(answer)))
    assert assembly.equal_spacing == (Fraction(assembly.deciding_number).denominator == 1)
    assert ("uneven-planets" in [one.code for one in answer.advice]) != assembly.equal_spacing


def test_the_nearest_ring_really_spreads_the_planets() -> None:
    for sun, planet, planets in itertools.product((38, 40, 55), (20, 23, 25), (3, 4, 5)):
        ring = sun + 2 * planet
        answer = train(arrangement=Planetary(sun=sun, ring=ring, planets=planets))
        uneven = [one for one in answer.advice if one.code == "uneven-planets"]
        if uneven and "ring of" in uneven[0].remedy:
            better = int(uneven[0].remedy.rpartition("ring of ")[2].split()[0])
            again = train(arrangement=Planetary(sun=sun, ring=better, planets=planets))
            assert again.assembly is not None
            assert again.assembly.equal_spacing


@pytest.mark.parametrize("planets", [3, 4, 5])
def test_neighbours_by_their_coordinates(planets: int) -> None:
    answer = train(arrangement=Planetary(sun=30, ring=82, planets=planets, module=0.002))
    assembly = answer.assembly
    assert assembly is not None
    angles = [2.0 * math.pi * float(place) for place in places(answer)]
    centres = [(28.0 * math.cos(angle), 28.0 * math.sin(angle)) for angle in angles]
    least = min(math.dist(a, b) for a, b in itertools.combinations(centres, 2))
    assert assembly.neighbour_clearance == pytest.approx(least - 28.0, rel=1e-12)
    assert assembly.neighbour_gap == pytest.approx(0.002 * (least - 28.0), rel=1e-12)


def test_only_planets_that_have_room_are_offered() -> None:
    answer = train(arrangement=Planetary(sun=24, ring=72, planets=5))
    (uneven,) = (one for one in answer.advice if one.code == "uneven-planets")
    assert answer.assembly is not None
    assert answer.assembly.most_planets == 5
    assert uneven.remedy.startswith("2, 3, 4 planets fit")


@pytest.mark.parametrize("stages", ["20:60, 18:54", "20/60, 18/54", "20x60; 18 × 54", "20 : 60 18 : 54"])
def test_stages_as_people_write_them(stages: str) -> None:
    assert train(arrangement=Stages(stages)).ratio == "9"
