"""Every task of particles against references by integration of the equations of motion."""

import json
import math
from pathlib import Path
from typing import Any

import pytest

from dynamics_cli.particle.aiming import DragBody, Elevation, Target, Terminal
from dynamics_cli.particle.fall import fall
from dynamics_cli.particle.flights import Linear, Quadratic, Upright
from dynamics_cli.particle.incline import circle, incline
from dynamics_cli.particle.projectile import projectile, with_drag
from dynamics_cli.particle.rotating_frame import OnEarth, Turning, rotating_frame
from dynamics_cli.particle.tube import Plane, Spring, hoop, tube

REFERENCES: dict[str, Any] = json.loads((Path(__file__).parent / "particle.json").read_text(encoding="utf-8"))
G = 9.80665
AIM = Elevation(math.pi / 4)


def near(value: Any, text: str, tolerance: float = 4e-15) -> None:
    assert value == pytest.approx(float(text), rel=tolerance, abs=0.0)


def landing(made: Any, name: str, tolerance: float) -> None:
    found = (made.time, made.range, made.impact_speed, made.impact_angle)
    for value, text in zip(found, REFERENCES[name], strict=True):
        near(value, text, tolerance)


def test_flights() -> None:
    landing(projectile(speed=30.0, aim=AIM, height=2.0), "drop", 4e-15)
    landing(with_drag(speed=30.0, aim=AIM, time_constant=3.0), "linear", 1e-14)
    landing(with_drag(speed=30.0, aim=AIM, drag=Terminal(25.0)), "quadratic", 1e-14)
    landing(with_drag(speed=50.0, aim=Elevation(math.radians(35.0)), drag=Terminal(40.0), height=1.0), "steep", 1e-14)
    landing(with_drag(speed=30.0, aim=AIM, drag=Terminal(25.0), wind=-6.0), "wind", 1e-14)
    landing(with_drag(speed=200.0, aim=AIM, drag=Terminal(40.0)), "fast", 1e-12)


def test_weak_drag_is_nearly_none() -> None:
    """The page's values for a time constant of 1e8 s and a terminal speed of 1e6 m/s."""
    near(with_drag(speed=30.0, aim=AIM, time_constant=1e8).range, "91.77445652106108488783", 2e-14)
    near(with_drag(speed=30.0, aim=AIM, drag=Terminal(1e6)).range, "91.774459103259467387", 2e-14)


def test_best_angles() -> None:
    made = projectile(speed=30.0, aim=AIM, height=2.0)
    near(math.degrees(made.best_elevation or 0.0), "44.38895809546671832")
    near(made.greatest_range, "93.75312897313581932")
    drag = with_drag(speed=30.0, aim=AIM, drag=Terminal(25.0))
    assert math.degrees(drag.best_elevation or 0.0) == pytest.approx(39.88449134, abs=1e-5)
    near(drag.greatest_range, "47.100178354703", 1e-12)


def test_targets() -> None:
    made = projectile(speed=30.0, aim=Target((80.0, 5.0)))
    near(made.elevation, REFERENCES["target"][0])
    near(made.other_elevation, REFERENCES["target"][1])
    flat = projectile(speed=1e5, aim=Target((1.0, 0.0)))
    near(flat.elevation, "4.903325000000000001e-10")
    least = projectile(speed=30.0, aim=Target((80.0, 5.0))).least_speed
    assert least is not None
    touched = projectile(speed=least * (1 + 1e-12), aim=Target((80.0, 5.0)))
    assert touched.elevation == pytest.approx(touched.other_elevation, rel=1e-5)


@pytest.mark.parametrize(
    "drag", [{"time_constant": 3.0}, {"drag": Terminal(25.0)}, {"drag": Terminal(25.0), "wind": -3.0}]
)
def test_targets_with_drag_are_met(drag: Any) -> None:
    made = with_drag(speed=30.0, aim=Target((35.0, 4.0)), **drag)
    for angle in (made.elevation, made.other_elevation):
        assert angle is not None
        flight = with_drag(speed=30.0, aim=Elevation(angle), height=-4.0, **drag)
        passes = flight.range
        # the flatter one may still be rising there
        assert passes >= 35.0 - 1e-6
    assert made.range == pytest.approx(35.0, rel=1e-12)


def test_a_body_has_its_terminal_speed() -> None:
    body = DragBody(mass=0.145, area=42e-4, drag_coefficient=0.4, density=1.2)
    speed = math.sqrt(0.145 * G / (0.5 * 1.2 * 0.4 * 42e-4))
    assert with_drag(speed=40.0, aim=AIM, drag=body).range == with_drag(speed=40.0, aim=AIM, drag=Terminal(speed)).range


def test_straight_up_is_the_limit_of_steep() -> None:
    upright, steep = Upright(30.0, G, 25.0), Quadratic(1e-7, 30.0, G, 25.0, 0.0)
    assert steep.apex()[2] == pytest.approx(upright.apex()[2], rel=1e-13)
    assert steep.landing(0.0)[0] == pytest.approx(upright.landing(0.0)[0], rel=1e-13)
    assert -upright.landing(0.0)[4] == pytest.approx(30.0 / math.sqrt(1.0 + 1.44), rel=1e-15)
    assert upright.at(3.0)[2] == pytest.approx(steep.at(3.0)[2], rel=1e-13)


def test_a_flight_is_one_curve() -> None:
    """States at times lie on the way to the landing, and velocities are the differences of places."""
    for flight in (
        Linear(20.0, 25.0, G, 3.0, -2.0),
        Quadratic(20.0, 25.0, G, 30.0, 4.0),
        Quadratic(3.0, 25.0, G, 30.0, 8.0),
    ):
        for time in (0.3, 1.7, 3.1):
            before, here, after = flight.at(time - 1e-4), flight.at(time), flight.at(time + 1e-4)
            for place, rate in ((1, 3), (2, 4)):
                assert (after[place] - before[place]) / 2e-4 == pytest.approx(here[rate], rel=1e-6, abs=1e-6)


def test_falls() -> None:
    near(fall(height=100.0, latitude=math.pi / 4).deflection, "0.0155239", 4e-6)
    for height in (1e-6, 1.0, 30.0, 40.0, 1000.0):
        made = fall(height=height, terminal_speed=60.0)
        depth = G * height / 3600.0
        # the energy left over is what drag took, integrated the other way: v² = v_t²·(1 − e^(−2d))
        assert made.speed == pytest.approx(60.0 * math.sqrt(-math.expm1(-2.0 * depth)), rel=1e-14)
        assert math.tanh(G * made.time / 60.0) == pytest.approx(made.speed / 60.0, rel=1e-14)


def test_tubes() -> None:
    near(tube(rotation=1e-4, start=0.1, time=1.0, plane=Plane("vertical")).position, REFERENCES["tube"])
    made = tube(
        rotation=2.0 * math.pi, start=0.2, time=0.7, mass=0.5, spring=Spring(40.0, 0.2), plane=Plane("vertical")
    )
    near(made.position, REFERENCES["spring"][0], 2e-14)
    near(made.speed, REFERENCES["spring"][1], 2e-14)


@pytest.mark.parametrize("stiffness", [0.0, 10.0, 19.999999999, 20.0, 20.000000001, 40.0, 39.9999999, 80.0])
@pytest.mark.parametrize("plane", ["horizontal", "vertical"])
def test_tubes_on_both_sides_of_every_switch(stiffness: float, plane: str) -> None:
    """m = 0.2 kg at 10 rad/s: without stiffness at 20 N/m, in resonance with gravity at 40 N/m."""
    given: dict[str, Any] = {"rotation": 10.0, "start": 0.3, "start_speed": 0.1, "mass": 0.2, "plane": Plane(plane)}
    spring = Spring(stiffness, 0.25)
    before, here, after = (tube(time=0.4 + step, spring=spring, **given) for step in (-1e-4, 0.0, 1e-4))
    assert (after.position - before.position) / 2e-4 == pytest.approx(here.speed, rel=1e-6, abs=1e-6)
    assert (after.speed - before.speed) / 2e-4 == pytest.approx(here.acceleration, rel=1e-5, abs=1e-6)


def test_hoop() -> None:
    made = hoop(radius=0.25, rotation=8.0)
    near(made.angle, REFERENCES["hoop"][0])
    near(2.0 * math.pi * (made.frequency or 0.0), REFERENCES["hoop"][1])
    critical = made.critical_rotation
    assert hoop(radius=0.25, rotation=critical * (1 - 1e-9)).angle is None
    assert hoop(radius=0.25, rotation=critical * (1 + 1e-9)).bottom == "unstable"


@pytest.mark.parametrize(
    ("force", "motion"),
    [(0.0, "slides down"), (47.0, "slides down"), (47.2, "rests"), (149.0, "rests"), (149.1, "slides up")],
)
def test_incline(force: float, motion: str) -> None:
    made = incline(mass=20.0, angle=math.pi / 6, friction=0.3, force=force)
    assert made.motion == motion
    assert (made.holding_force < force < made.moving_force) == (motion == "rests")
    net = force + made.friction_force - 20.0 * G * 0.5
    assert net == pytest.approx(20.0 * made.acceleration, abs=1e-12)


def test_bends_at_their_limits() -> None:
    for bank in (0.0, 0.1, 0.4):
        made = circle(radius=60.0, friction=0.2, bank=bank)
        assert made.greatest_speed is not None
        at_limit = circle(radius=60.0, friction=0.2, bank=bank, speed=made.greatest_speed)
        assert at_limit.needed_friction == pytest.approx(0.2, rel=1e-13)
        if made.least_speed > 0.0:
            assert circle(
                radius=60.0, friction=0.2, bank=bank, speed=made.least_speed
            ).needed_friction == pytest.approx(0.2)
        free = circle(radius=60.0, friction=0.2, bank=bank, speed=made.free_speed)
        assert free.needed_friction == pytest.approx(0.0, abs=1e-15)
    assert circle(radius=60.0, friction=1.5, bank=0.7).greatest_speed is None
    ideal = circle(radius=60.0, bank=0.3, speed=10.0)
    assert (ideal.greatest_speed, ideal.least_speed, ideal.slides) == (None, None, None)
    assert ideal.free_speed == circle(radius=60.0, friction=0.2, bank=0.3).free_speed


def test_a_body_at_rest_in_space_circles_backwards_on_a_turntable() -> None:
    """Seen from the table it moves at −ω×r and needs ω²r inwards, which the apparent accelerations give."""
    made = rotating_frame(frame=Turning((0.0, 0.0, 2.0), (1.5, 0.0, 0.0)), velocity=(0.0, -3.0, 0.0))
    assert made.true_velocity == (0.0, 0.0, 0.0)
    assert made.apparent == (-6.0, 0.0, 0.0)


@pytest.mark.parametrize("latitude", [-1.2, -0.3, 0.3, 1.5707963267948966])
def test_a_level_motion_circles_at_the_coriolis_acceleration(latitude: float) -> None:
    made = rotating_frame(frame=OnEarth(latitude), velocity=(30.0, 40.0, 0.0))
    level = math.hypot(made.coriolis[0], made.coriolis[1])
    assert made.inertial_radius == pytest.approx(2500.0 / level, rel=1e-14)
    assert made.foucault_time == pytest.approx(2.0 * made.inertial_time, rel=1e-15)  # type: ignore[operator]
    # to the right in the north
    right = made.coriolis[0] * 40.0 - made.coriolis[1] * 30.0
    assert right * latitude > 0.0


def test_on_the_equator_nothing_turns() -> None:
    made = rotating_frame(frame=OnEarth(0.0), velocity=(30.0, 0.0, 0.0))
    assert made.inertial_radius is made.foucault_time is None
    # eastwards one is lighter (Eötvös)
    assert made.coriolis[2] == pytest.approx(2.0 * 7.292115e-5 * 30.0, rel=1e-15)


def test_a_block_kicked_up_an_incline_comes_back_slower() -> None:
    made = incline(mass=20.0, angle=math.pi / 6, friction=0.3, start_speed=6.0)
    loss = 0.3 * math.cos(math.pi / 6)
    assert made.stop_distance == pytest.approx(18.0 / (G * (0.5 + loss)), rel=1e-14)
    # the energy that friction takes on both ways
    back = math.sqrt(36.0 - 4.0 * G * loss * made.stop_distance)
    assert made.return_speed == pytest.approx(back, rel=1e-13)
    assert incline(mass=20.0, angle=math.pi / 6, friction=0.7, start_speed=6.0).after == "then rests"
    past = incline(mass=20.0, angle=math.pi / 6, friction=0.3, start_speed=6.0, distance=3.0)
    assert past.speed is None


@pytest.mark.parametrize("tilt", [-0.6, 0.0, 0.4])
def test_a_force_at_an_angle_holds_and_moves_a_block_at_its_limits(tilt: float) -> None:
    made = incline(mass=20.0, angle=0.6, friction=0.3, force_angle=tilt)
    for limit in (made.holding_force, made.moving_force):
        at = incline(mass=20.0, angle=0.6, friction=0.3, force=limit, force_angle=tilt)
        assert at.needed_friction == pytest.approx(0.3, rel=1e-12)


@pytest.mark.parametrize(("tilt", "holds"), [(55.0, True), (65.0, False), (80.0, False)])
def test_a_force_beyond_the_vertical_lifts_and_neither_holds_nor_moves(tilt: float, holds: bool) -> None:
    made = incline(mass=10.0, angle=math.pi / 6, friction=0.2, force_angle=math.radians(tilt))
    assert made.motion == "slides down"
    assert ((made.holding_force or 0.0) > 0.0, made.moving_force is not None) == (holds, holds)
    assert incline(mass=10.0, angle=0.1, friction=0.2, force_angle=math.radians(tilt)).holding_force == 0.0
