"""Work, energy and momentum: known values, refusals, and what must hold whatever the numbers."""

import math
import shlex
from pathlib import Path

import pytest
from harness import answer, run
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.energy.body import Body, body
from dynamics_cli.energy.drop import Falling, Known, Running, Stroke, drop
from dynamics_cli.energy.impulse import Steady, draw_in, impulse
from dynamics_cli.energy.power import AtSpeed, WithPower, drive
from dynamics_cli.energy.roll import Form, Inertial, Shape, roll
from dynamics_cli.energy.speed import speed
from dynamics_cli.energy.work import Between, Measured, Spring, work

G = 9.80665
SIZES = st.floats(0.01, 1000.0)
COORDINATES = st.floats(-100.0, 100.0)


def near(value: float | None, wanted: float, tolerance: float = 4e-15) -> None:
    assert value == pytest.approx(wanted, rel=tolerance, abs=0.0)


def test_known_values() -> None:
    near(speed(mass=1500.0, start_speed=33.3, work=1e-6).change, 2.0020020020014002e-11)
    near(work(spring=Spring(2000.0, 0.0, 1e-7)).total, -1.0e-11)
    assert work(spring=Spring(2000.0, 0.3, -0.3)).total == 0.0
    near(drop(mass=2.0, arrival=Falling(1e-9), spring=Known(5000.0)).compression, 0.0078453209999998725355)
    near(drop(mass=2.0, arrival=Falling(0.5), spring=Known(5000.0)).compression, 0.066676522522362717112)
    near(draw_in(inertia=5.0, end_inertia=1.2, rotation=2.0).work, 31.666666666666666667)
    car = {"mass": 1500.0, "slope": 0.05, "rolling_resistance": 0.012, "drag_area": 0.7, "density": 1.2}
    near(drive(at=AtSpeed(25.0), **car).power, 29334.514000931165989)
    # a chain of 1 m that leaves a smooth edge, 0.1 m over it at first: its weight over the edge is a force table
    pulled = work(measured=Measured((0.0, 0.9), (0.1 * G, G))).total
    near(speed(mass=1.0, work=pulled).end_speed, 3.1158599936454141007)


@pytest.mark.parametrize(("form", "share"), [("hoop", 1 / 2), ("disk", 2 / 3), ("sphere", 5 / 7), ("shell", 3 / 5)])
def test_rolling_bodies_down_one_slope(form: str, share: float) -> None:
    near(roll(body=Shape(Form(form)), angle=0.4).acceleration, share * G * math.sin(0.4))


def test_friction_takes_work_on_a_closed_path() -> None:
    there = work(distance=4.0, friction=0.3, normal_force=50.0).total
    near(there, -60.0)
    near(work(distance=8.0, friction=0.3, normal_force=50.0).total, 2.0 * there)


def test_steps_and_lines_of_a_table() -> None:
    positions, forces = (0.0, 1.0, 3.0), (10.0, 20.0, 40.0)
    near(work(measured=Measured(positions, forces)).total, 15.0 + 60.0)
    near(work(measured=Measured(positions, forces, Between("steps"))).total, 10.0 + 40.0)


@given(angle=st.floats(0.05, 1.5), ratio=st.floats(0.1, 2.0))
def test_rolling_begins_where_friction_suffices(angle: float, ratio: float) -> None:
    """At the limit both motions are the same, and energy is kept on either side of it."""
    shape = Inertial(ratio)
    limit = roll(body=shape, angle=angle, distance=1.0).needed_friction
    above = roll(body=shape, angle=angle, friction=limit * (1 + 1e-9), distance=1.0)
    below = roll(body=shape, angle=angle, friction=limit * (1 - 1e-9), distance=1.0)
    assert (above.motion, below.motion) == ("rolls", "slips and turns")
    assert below.acceleration == pytest.approx(above.acceleration, rel=1e-7)
    assert above.lost_share == 0.0
    for case in (above, below, roll(body=shape, angle=angle, friction=0.3 * limit, distance=1.0)):
        assert case.speed is not None
        assert case.rim_speed is not None
        kept = 0.5 * (case.speed**2 + ratio * case.rim_speed**2)
        assert kept == pytest.approx(G * math.sin(angle) * (1.0 - case.lost_share), rel=1e-9)


@given(mass=SIZES, before=SIZES, force=SIZES, distance=SIZES)
def test_there_and_back(mass: float, before: float, force: float, distance: float) -> None:
    """The way back from the end speed takes the same work, and the distance comes out again."""
    after = speed(mass=mass, start_speed=before, force=force, distance=distance)
    again = speed(mass=mass, start_speed=before, end_speed=after.end_speed, distance=distance)
    assert again.work == pytest.approx(after.work, rel=1e-6, abs=1e-9 * after.end_energy)
    back = speed(mass=mass, start_speed=after.end_speed, force=-force, distance=distance * (1 - 1e-12))
    assert back.end_speed**2 == pytest.approx(before**2, rel=1e-9, abs=1e-9 * after.end_speed**2)


@given(st.lists(st.tuples(SIZES, COORDINATES, COORDINATES, COORDINATES, COORDINATES), min_size=2, max_size=4))
def test_a_moving_frame_changes_energy_by_the_mass_centre(rows: list[tuple[float, ...]]) -> None:
    """König: the energy beside the mass centre and the central momentum are the same in every frame."""
    still = body(bodies=tuple(Body(m, (u, v, 0.0), (x, y, 0.0), 1.0, 2.0) for m, u, v, x, y in rows))
    moved = body(bodies=tuple(Body(m, (u + 7.0, v - 3.0, 0.0), (x, y, 0.0), 1.0, 2.0) for m, u, v, x, y in rows))
    assert still.inner_energy is not None
    assert moved.inner_energy == pytest.approx(still.inner_energy, rel=1e-9)
    assert moved.central_momentum[2] == pytest.approx(still.central_momentum[2], rel=1e-9, abs=1e-6)
    carried = 0.5 * still.mass * sum(part * part for part in still.centre_velocity)
    assert still.energy == pytest.approx(still.inner_energy + carried, rel=1e-12)


@given(power=st.just(0.0) | st.floats(1e-3, 1e6), slope=st.floats(-0.3, 0.3), area=st.floats(1e-9, 2.0))
def test_top_speed_takes_the_power(power: float, slope: float, area: float) -> None:
    car = {"mass": 1500.0, "slope": slope, "rolling_resistance": 0.012, "drag_area": area, "efficiency": 0.9}
    top = drive(at=WithPower(power), **car)
    there = drive(at=AtSpeed(top.speed), **car)
    scale = (abs(there.rolling) + abs(there.climbing) + there.drag) * top.speed
    assert there.force * top.speed == pytest.approx(0.9 * power, abs=1e-12 * scale)


@pytest.mark.parametrize("stiffness", [10.0, 5000.0, 1e6])
def test_a_stroke_and_its_stiffness_agree(stiffness: float) -> None:
    for arrival in (Falling(0.3), Falling(0.0), Running(1.5)):
        stop = drop(mass=3.0, arrival=arrival, spring=Known(stiffness))
        near(drop(mass=3.0, arrival=arrival, spring=Stroke(stop.compression)).stiffness, stiffness, 1e-14)


def test_let_go_on_a_spring_the_force_is_twice_the_weight() -> None:
    near(drop(mass=3.0, arrival=Falling(0.0), spring=Known(700.0)).factor, 2.0)


def test_impulse_and_work_agree() -> None:
    made = impulse(cause=Steady(-800.0, 0.25), mass=80.0, start_speed=5.0)
    near(made.end_speed, 2.5)
    near(made.work, -750.0)


REFUSED = {
    "nothing": ("work", "nothing"),
    "half": ('work --force "3 N"', "missing"),
    "idle": ('work --distance "3 m" --torque "3 N*m" --turn "20 deg"', "missing"),
    "turn alone": ('work --turn "20 deg" --mass "1 kg" --rise "1 m"', "missing"),
    "rise alone": ('work --rise "1 m" --torque "3 N*m" --turn "20 deg"', "missing"),
    "pressed alone": ('work --normal-force "5 N" --force "3 N" --distance "2 m"', "missing"),
    "angle alone": ('work --angle "20 deg" --mass "1 kg" --rise "1 m"', "missing"),
    "torque as energy": ('speed --mass "2 kg" --work "3 N*m"', "kind"),
    "turning back": ('work --measured-positions "0, 2, 1 m" --measured-forces "1, 2, 3 N"', "order"),
    "unequal": ('work --measured-positions "0, 1, 2 m" --measured-forces "1, 2 N"', "lengths"),
    "alone": ('work --measured-positions "1 m" --measured-forces "2 N"', "too-few"),
    "pulled": ('work --distance "1 m" --friction 0.3 --normal-force "-5 N"', "normal-force"),
    "stops": ('speed --mass "2 kg" --start-speed "3 m/s" --force "-6 N" --distance "40 m"', "stops"),
    "no way": ('speed --mass "2 kg" --force "6 N"', "distance"),
    "against": ('speed --mass "2 kg" --start-speed "3 m/s" --end-speed "5 m/s" --force "-6 N"', "wrong-way"),
    "known": ('speed --mass "2 kg" --end-speed "5 m/s" --force "6 N" --distance "3 m"', "nothing-unknown"),
    "idle speed": ('speed --mass "2 kg" --start-speed "5 m/s"', "nothing"),
    "at rest": ('drop --mass "2 kg" --speed "0 m/s" --stiffness "3 N/mm"', "speed"),
    "level": ('roll --form disk --angle "0 deg"', "angle"),
    "nothing arrives": ('power --force "3 N" --speed "1 m/s" --efficiency "0 %"', "efficiency"),
    "no end": ('drive --mass "1500 kg" --power "3 kW"', "no-top"),
    "no time": ('impulse --force "3 N" --time "0 s"', "time"),
    "unknown mass": ('impulse --end-speed "3 m/s" --duration "1 s"', "mass"),
    "no inertia": ('draw-in --inertia "5 kg*m^2" --end-inertia "0 kg*m^2" --rotation "2 rad/s"', "inertia"),
    "no body": ("body", "missing"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str) -> None:
    call, code = REFUSED[name]
    out = run(*shlex.split("energy " + call), "--json")
    assert out.status in (2, 3)
    assert out.error["code"] == code


def test_the_refusal_says_where_it_stops() -> None:
    out = run(*shlex.split('energy speed --mass "2 kg" --start-speed "3 m/s" --force "-6 N" --distance "40 m"'))
    assert "lacks 231 J" in out.err
    assert "after 1.5 m" in out.err


def test_uncertain_friction_makes_slipping_a_probability() -> None:
    made = answer(*shlex.split('energy roll --form disk --angle "30 deg" --friction "0.19 ± 0.02" --distance "2 m"'))
    assert made["results"]["acceleration"]["std"] > 0.0


@pytest.mark.parametrize(
    "call",
    [
        'work --measured-positions "0, 1, 2 m" --measured-forces "1, 5, 2 N" --mass "1 kg" --rise "0.1 m"',
        'drive --mass "1500 kg" --power "60 kW" --rolling-resistance 0.012 --drag-area "0.7 m^2"',
        'impulse --times "0, 2, 5 ms" --forces "0, 900, 0 N"',
    ],
)
def test_pictures(call: str, tmp_path: Path) -> None:
    target = tmp_path / "picture.svg"
    assert run(*shlex.split("energy " + call), "--plot", str(target)).status == 0
    assert target.stat().st_size > 5000
