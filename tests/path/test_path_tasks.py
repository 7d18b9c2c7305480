"""What the tasks of path answer and refuse: both sides of every switch, and motion against differences of position."""

import math
from typing import Any

import numpy as np
import pytest
from harness import answer, run
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp, mpf

from dynamics_cli.errors import DynamicsError, InadmissibleError
from dynamics_cli.numerics.orientation.moving_frame import moving_frame
from dynamics_cli.path.circle import Running, Turning, circle
from dynamics_cli.path.components import Axes, components
from dynamics_cli.path.coordinates import cylindrical, polar, spherical
from dynamics_cli.path.curves.named import Clothoid, Cycloid, Ellipse, Helix, Involute, Line
from dynamics_cli.path.curves.task import curve
from dynamics_cli.path.relative.motions import Mover
from dynamics_cli.path.relative.task import relative
from dynamics_cli.path.straight.task import Phase, rectilinear, rectilinear_law
from dynamics_cli.records import Formula, Let

# Closed forms beside each other lose a few roundings.
SAME = 1e-12
SPEED = st.floats(-30.0, 30.0)


def metres(text: str) -> Formula:
    return Formula(text, 1.0, "m")


def law(text: str) -> Formula:
    return Formula(text, 1.0, "m/s^2")


def refused(call: Any) -> DynamicsError:
    with pytest.raises(DynamicsError) as caught:
        call()
    return caught.value


# rectilinear


@settings(max_examples=60, deadline=None)
@given(SPEED, st.floats(0.1, 9.0), st.floats(0.1, 20.0))
def test_every_three_of_the_five_give_the_others(u: float, a: float, t: float) -> None:
    five = {"start_speed": u, "end_speed": u + a * t, "acceleration": a, "distance": u * t + 0.5 * a * t * t, "time": t}
    for first in five:
        for second in five:
            given_ = {name: value for name, value in five.items() if name not in (first, second)}
            if first == second or ((first, second) == ("acceleration", "time") and abs(five["distance"]) < 1e-3):
                continue
            if {first, second} == {"acceleration", "time"} and abs(u + five["end_speed"]) < 1e-2:
                continue
            made = rectilinear(phases=Phase(**given_))
            fits = [made, *(made.alternatives or ())]
            assert any(abs(one.time - t) <= 1e-5 * t for one in fits), (given_, fits)


def test_it_stops_or_passes_twice() -> None:
    twice = rectilinear(phases=Phase(start_speed=20.0, acceleration=-4.0, distance=49.9999))
    assert twice.alternatives is not None
    assert (twice.time, twice.alternatives[0].time) == pytest.approx(
        (4.9929289321881345, 5.0070710678118655), rel=1e-12
    )
    touching = rectilinear(phases=Phase(start_speed=20.0, acceleration=-4.0, distance=50.0))
    assert (touching.time, touching.alternatives, touching.end_speed) == (5.0, None, 0.0)
    short = refused(lambda: rectilinear(phases=Phase(start_speed=20.0, acceleration=-4.0, distance=50.3)))
    assert "stops after 50 m, 0.3 m short of 50.3 m" in short.message
    away = refused(lambda: rectilinear(phases=Phase(start_speed=5.0, acceleration=10.0, distance=-20.0)))
    assert "moves away" in away.message


@pytest.mark.parametrize(
    ("phase", "words"),
    [
        ({"start_speed": 1.0}, "1 given"),
        ({"start_speed": 1.0, "end_speed": 1.0, "acceleration": 0.0}, "open"),
        ({"start_speed": 1.0, "end_speed": 2.0, "acceleration": 0.0}, "does not change"),
        ({"start_speed": 1.0, "end_speed": -1.0, "distance": 3.0}, "zero, not 3 m"),
        ({"start_speed": 1.0, "end_speed": -1.0, "distance": 0.0}, "open"),
        ({"start_speed": 1.0, "end_speed": 2.0, "distance": 0.0}, "needs a distance"),
        ({"start_speed": 1.0, "end_speed": 2.0, "acceleration": -1.0}, "before it starts"),
        ({"start_speed": 1.0, "end_speed": 2.0, "time": 0.0}, "time is zero"),
        ({"start_speed": 0.0, "acceleration": 0.0, "distance": 3.0}, "does not move"),
        ({"start_speed": -20.0, "acceleration": -4.0, "distance": 5.0}, "before it starts"),
        ({"start_speed": 20.0, "end_speed": 0.0, "time": 5.0, "distance": 60.0}, "the time is 6 s, not 5 s"),
    ],
)
def test_triples_that_contradict_or_leave_open(phase: dict[str, float], words: str) -> None:
    assert words in refused(lambda: rectilinear(phases=Phase(**phase))).message


def test_more_than_three_that_agree_are_taken() -> None:
    made = rectilinear(phases=Phase(start_speed=20.0, end_speed=0.0, acceleration=-4.0, distance=50.0, time=5.0))
    assert made.distance == 50.0


def test_phases_follow_one_another() -> None:
    phases = (
        Phase(start_speed=0.0, end_speed=20.0, acceleration=1.0),
        Phase(acceleration=0.0, time=30.0),
        Phase(end_speed=0.0, acceleration=-2.0),
    )
    made = rectilinear(phases=phases)
    assert (made.time, made.distance) == (60.0, 200.0 + 600.0 + 100.0)
    assert made.motion[-1].speed == 0.0
    jump = (phases[0], Phase(start_speed=5.0, acceleration=0.0, time=1.0))
    assert "ends at 20 m/s" in refused(lambda: rectilinear(phases=jump)).message


LAWS = [
    ("-0.05*v", Phase(start_speed=20.0, time=3.0), 400.0 * -math.expm1(-0.15), 20.0 * math.exp(-0.15)),
    ("9.80665-0.004*v^2", Phase(start_speed=0.0, time=3.0), 41.754259671997424537, 26.385604345956000154),
    ("-0.004*v^2", Phase(start_speed=20.0, time=3.0), math.log1p(0.24) / 0.004, 20.0 / 1.24),
    ("-4*x", Phase(start_speed=2.0, time=0.6), math.sin(1.2), 2.0 * math.cos(1.2)),
    ("6*t", Phase(start_speed=1.0, time=2.0), 10.0, 13.0),
    ("3", Phase(start_speed=1.0, time=2.0), 8.0, 7.0),
]


@pytest.mark.parametrize(("text", "phase", "distance", "speed"), LAWS)
def test_laws_with_closed_forms(text: str, phase: Phase, distance: float, speed: float) -> None:
    made = rectilinear_law(phases=phase, law=law(text))
    assert made.numerics is not None
    bounds = {bound.result: bound.bound for bound in made.numerics.bounds}
    assert abs(made.distance - distance) <= bounds["distance"] + 4.0 * math.ulp(distance)
    assert abs(made.end_speed - speed) <= bounds["end_speed"] + 4.0 * math.ulp(speed)
    assert max(bounds.values()) < 1e-12 * max(distance, speed)
    assert all(check.passed for check in made.checks)


def test_a_law_ends_at_rest_at_a_distance_or_at_a_speed() -> None:
    spring = law("-4*x")
    assert rectilinear_law(phases=Phase(start_speed=2.0), law=spring).time == pytest.approx(math.pi / 4, rel=SAME)
    assert rectilinear_law(phases=Phase(start_speed=2.0, distance=0.5), law=spring).time == pytest.approx(
        math.pi / 12, rel=SAME
    )
    slowed = rectilinear_law(phases=Phase(start_speed=20.0, end_speed=10.0), law=law("-0.05*v"))
    assert slowed.time == pytest.approx(math.log(2.0) / 0.05, rel=SAME)
    thrown = rectilinear_law(phases=Phase(start_speed=2.0, distance=-10.0), law=law("-9.81"))
    assert thrown.stop_time == pytest.approx(2.0 / 9.81, rel=SAME)
    rooted = rectilinear_law(phases=Phase(start_speed=20.0), law=law("-0.5*sqrt(v)"))
    assert rooted.time == pytest.approx(4.0 * math.sqrt(20.0), rel=1e-9)


@pytest.mark.parametrize(
    ("text", "phase", "words"),
    [
        ("1/(2-t)", Phase(start_speed=0.0, time=3.0), "beyond 2 s"),
        ("-4*x", Phase(start_speed=2.0, distance=1.1), "turns back at 1 m"),
        ("-0.05*v", Phase(start_speed=20.0, distance=401.0), "does not reach 401 m"),
        ("-0.05*v", Phase(start_speed=20.0), "does not reach 0 m/s"),
        ("-5*x", Phase(start_speed=0.0), "does not move"),
        ("1/v", Phase(start_speed=0.0, time=1.0), "pole"),
        ("-0.05*q", Phase(start_speed=20.0), "'q' has no value"),
        ("-0.05*v", Phase(start_speed=20.0, time=1.0, distance=3.0), "one end"),
        ("-0.05*v", Phase(time=1.0), "needs the start speed"),
        ("-0.05*v", Phase(start_speed=1.0, acceleration=2.0), "leave out the number"),
    ],
)
def test_laws_that_lead_nowhere(text: str, phase: Phase, words: str) -> None:
    assert words in refused(lambda: rectilinear_law(phases=phase, law=law(text))).message


# circle, coordinates, components


def test_circle_by_speed_and_by_angular_velocity_agree() -> None:
    one = circle(radius=2.0, state=Turning(3.0, 0.5), time=4.0)
    other = circle(radius=2.0, state=Running(6.0, 1.0), angle=one.angle)
    assert other.time == pytest.approx(4.0, rel=SAME)
    assert (other.speed, other.normal, other.turns) == pytest.approx((one.speed, one.normal, one.turns), rel=SAME)
    uniform = circle(radius=2.0, state=Turning(3.0), arc=6.0)
    assert (uniform.time, uniform.inclination) == (1.0, 0.0)


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ({"angle": 5.0}, "stops after 4.5 rad"),
        ({"angle": -5.0, "state": Turning(3.0, 1.0)}, "turns the other way"),
        ({"radius": 0.0}, "not above zero"),
        ({"angle": 1.0, "time": 2.0}, "one of them"),
    ],
)
def test_circle_refuses(more: dict[str, Any], words: str) -> None:
    assert words in refused(lambda: circle(**{"radius": 2.0, "state": Turning(3.0, -1.0), **more})).message


def test_circle_reaches_its_stop_and_comes_back() -> None:
    stop = circle(radius=2.0, state=Turning(3.0, -1.0), angle=4.5)
    assert (stop.angular_velocity, stop.time) == (0.0, 3.0)
    assert circle(radius=2.0, state=Turning(3.0, -1.0), angle=-3.5).time == pytest.approx(7.0)


def test_cylindrical_in_the_plane_is_polar_and_the_equator_too() -> None:
    flat = polar(
        radius=0.3, angle=0.4, radial_speed=0.8, angular_velocity=5.0, radial_speed_rate=0.1, angular_acceleration=2.0
    )
    round_ = cylindrical(
        radius=0.3, angle=0.4, radial_speed=0.8, angular_velocity=5.0, radial_speed_rate=0.1, angular_acceleration=2.0
    )
    pole = spherical(
        radius=0.3,
        polar_angle=math.pi / 2,
        azimuth=0.4,
        radial_speed=0.8,
        azimuth_rate=5.0,
        radial_speed_rate=0.1,
        azimuth_second=2.0,
    )
    assert flat.radius_of_curvature == round_.radius_of_curvature
    assert pole.azimuth_acceleration == pytest.approx(flat.transverse_acceleration, rel=SAME)
    assert pole.cartesian_acceleration[:2] == pytest.approx(flat.cartesian_acceleration[:2], rel=SAME)
    assert (flat.axial_velocity, round_.axial_velocity) == (None, 0.0)


def test_polar_angle_is_within_its_range() -> None:
    assert spherical(radius=1.0, polar_angle=0.0, polar_rate=1.0).speed == 1.0
    for angle in (-1e-9, 3.1416):
        assert "from 0 to 180 degrees" in refused(lambda angle=angle: spherical(radius=1.0, polar_angle=angle)).message


def test_rest_and_straight_paths_say_what_does_not_exist() -> None:
    rest = components(velocity=(0.0, 0.0, 0.0), acceleration=(1.0, 2.0, 0.0), position=(1.0, 0.0, 0.0))
    assert (rest.tangential, rest.curvature, rest.tangent) == (None, None, None)
    assert {"tangential", "normal", "curvature", "tangent"} <= {one.result for one in rest.advice}
    straight = components(velocity=(1.0, 2.0, 3.0), acceleration=(2.0, 4.0, 6.0))
    assert (straight.curvature, straight.radius_of_curvature, straight.normal) == (0.0, None, 0.0)
    bent = components(velocity=(1.0, 2.0, 3.0), acceleration=(2.0, 4.0, 6.0 + 1e-15))
    assert bent.radius_of_curvature is not None


@settings(max_examples=40, deadline=None)
@given(*[st.tuples(SPEED, SPEED, SPEED)] * 3)
def test_components_come_back_from_every_system(v: Any, a: Any, place: Any) -> None:
    if math.hypot(*place[:2]) < 1e-3 or math.hypot(*v) < 1e-3:
        return
    made = components(velocity=v, acceleration=a, position=place)
    for system in ("cylindrical", "spherical"):
        given_ = {what: getattr(made, f"{system}_{what}") for what in ("velocity", "acceleration")}
        again = components(position=place, axes=Axes(system), **given_)
        assert again.cartesian_velocity == pytest.approx(v, abs=1e-11)
        assert again.cartesian_acceleration == pytest.approx(a, abs=1e-11)
    if made.normal_direction is not None and made.normal > 1e-6:
        parts = [
            made.tangential * t + made.normal * n for t, n in zip(made.tangent, made.normal_direction, strict=True)
        ]
        assert parts == pytest.approx(a, abs=1e-8)
        assert abs(sum(t * n for t, n in zip(made.tangent, made.normal_direction, strict=True))) < 1e-9


def test_directions_need_a_place() -> None:
    for place in (None, (0.0, 0.0, 3.0)):
        error = refused(
            lambda p=place: components(velocity=(1, 0, 0), acceleration=(0, 1, 0), position=p, axes=Axes("polar"))
        )
        assert error.code == "on-axis"


# curve


@settings(max_examples=25, deadline=None)
@given(st.floats(0.05, 6.0), st.sampled_from([Ellipse(3.0, 2.0), Helix(2.0, 3.0), Cycloid(0.5, 0.7), Involute(0.3)]))
def test_velocity_and_acceleration_are_differences_of_positions(at: float, shape: Any) -> None:
    step = 1e-4
    here = curve(shape=shape, at=at, start=at)
    before, after = (curve(shape=shape, at=at + s, start=at + s) for s in (-step, step))
    for k in range(3):
        assert (after.position[k] - before.position[k]) / (2 * step) == pytest.approx(here.velocity[k], abs=1e-6)
        assert (after.velocity[k] - before.velocity[k]) / (2 * step) == pytest.approx(here.acceleration[k], abs=1e-6)


def test_a_nearly_straight_path_and_a_turning_tube() -> None:
    nearly = components(velocity=(300.0, 0.0, 0.0), acceleration=(9.8, 1e-7, 0.0))
    assert (nearly.normal, nearly.radius_of_curvature) == pytest.approx((1e-7, 9e11), rel=1e-15)
    tube = polar(radius=0.3, radial_speed=0.8, angular_velocity=5.0, angular_acceleration=2.0)
    assert (tube.radial_acceleration, tube.transverse_acceleration) == (-7.5, 8.6)


def test_published_curves() -> None:
    made = curve(x=metres("t^2"), y=metres("sin(3*t)"), z=metres("exp(-t)"), end=0.8)
    wanted = (2.7668830736899897, 5.9439901373771936, 2.4139529687754316, 3.1714130484305902, -0.66851701181875830)
    found = (made.speed, made.tangential, made.normal, made.radius_of_curvature, made.torsion)
    assert found == pytest.approx(wanted, rel=1e-15)
    assert made.arc_length == pytest.approx(1.6959532066764195, rel=1e-14)
    helix = curve(shape=Helix(3.0, 8.0 * math.pi), at=1.7)
    assert (helix.curvature, helix.torsion) == pytest.approx((0.12, 0.16), rel=1e-15)
    assert curve(shape=Ellipse(3.0, 2.0), end=2.0 * math.pi).arc_length == pytest.approx(15.865439589290590, rel=1e-14)
    spiral = curve(shape=Clothoid(1.0), end=1.0)
    assert spiral.position[:2] == pytest.approx((0.97528768820034454, 0.16371404737570058), rel=1e-15)


def test_terms_that_cancel_are_taken_in_more_digits() -> None:
    typed = curve(x=metres("t - sin(t)"), y=metres("1 - cos(t)"), start=1e-6, at=1e-6)
    named = curve(shape=Cycloid(1.0), start=1e-6, at=1e-6)
    assert typed.radius_of_curvature == pytest.approx(1.9999999999999166667e-6, rel=1e-15)
    assert named.radius_of_curvature == pytest.approx(1.9999999999999166667e-6, rel=1e-15)


def test_events_of_a_cycloid_an_ellipse_and_a_wave() -> None:
    rolled = curve(shape=Cycloid(0.3), start=1.0, end=14.0)
    cusps = [one.time for one in rolled.events if one.event == "cusp or rest"]
    assert cusps == pytest.approx([2.0 * math.pi, 4.0 * math.pi], abs=1e-6)
    oval = curve(shape=Ellipse(3.0, 2.0), start=0.1, end=3.2)
    assert [(one.event, round(one.time, 6)) for one in oval.events] == [
        ("fastest", round(math.pi / 2, 6)), ("flattest", round(math.pi / 2, 6)),
        ("slowest", round(math.pi, 6)), ("tightest", round(math.pi, 6)),
    ]  # fmt: skip
    wave = curve(x=metres("t"), y=metres("sin(t)"), start=0.5, end=5.0)
    assert [round(one.time, 6) for one in wave.events if one.event == "inflection"] == [round(math.pi, 6)]
    assert curve(shape=Helix(1.0, 2.0), end=9.0).events is None


def test_a_cusp_itself_is_rest() -> None:
    made = curve(shape=Cycloid(1.0), start=0.0, at=0.0)
    assert (made.speed, made.tangential, made.radius_of_curvature) == (0.0, None, None)
    line = curve(shape=Line((1.0, 2.0, 2.0)), end=3.0)
    assert (line.curvature, line.radius_of_curvature, line.arc_length) == (0.0, None, pytest.approx(3.0))


@pytest.mark.parametrize(
    ("given_", "words"),
    [
        ({"x": metres("tan(t)"), "end": 2.0}, "at 1.5708 s"),
        ({"x": metres("abs(t-1)"), "end": 2.0}, "at 1 s"),
        ({"x": metres("t"), "start": 3.0, "end": 2.0}, "before it starts"),
        ({"x": metres("t")}, "a time is missing"),
        ({"end": 2.0}, "either formulas"),
        ({"x": metres("t"), "shape": Cycloid(1.0), "end": 1.0}, "either formulas"),
        ({"x": metres("t"), "end": 2.0, "at": 3.0}, "not in the range"),
        ({"shape": Cycloid(1.0), "length_law": metres("t"), "end": 1.0}, "is its angle"),
        ({"x": metres("t"), "angle_law": metres("t"), "end": 1.0}, "named curve"),
        ({"x": metres("a*t"), "end": 1.0}, "'a' has no value"),
        ({"x": Formula("a*t", 1e-3, "mm"), "let": (Let("a", 3.0, "m"),), "end": 1.0}, "ends in mm"),
    ],
)
def test_curve_refuses(given_: dict[str, Any], words: str) -> None:
    assert words in refused(lambda: curve(**given_)).message


def test_a_motion_that_changes_too_often_says_so() -> None:
    made = curve(x=metres("sin(1000*t)"), y=metres("t"), end=100.0)
    assert [one.code for one in made.advice] == ["busy"]
    assert made.numerics is not None
    # the mean of √(10⁶cos² + 1) over a period is 636.62
    assert abs(made.arc_length - 63662.1) <= made.numerics.bounds[0].bound


def test_hard_cases_with_known_digits() -> None:
    nearly = components(velocity=(300.0, 0.0, 0.0), acceleration=(9.8, 1e-7, 0.0))
    assert (nearly.normal, nearly.radius_of_curvature) == pytest.approx((1e-7, 9e11), rel=1e-15)
    slow = rectilinear(phases=Phase(start_speed=20.0, acceleration=1e-14, distance=100.0))
    assert slow.time == pytest.approx(4.99999999999999375, rel=2e-16)
    angles = {"polar_angle": math.radians(50.0), "azimuth": math.radians(20.0), "polar_rate": 0.4, "azimuth_rate": -0.7}
    seconds = {"radial_speed_rate": 0.05, "polar_second": -0.2, "azimuth_second": 0.6}
    made = spherical(radius=2.0, radial_speed=0.3, **angles, **seconds)
    parts = (made.radial_acceleration, made.polar_acceleration, made.azimuth_acceleration, made.radius_of_curvature)
    wanted = (-0.84508760705679587094, -0.64255579897598194909, -0.12240745721612117802, 1.9531206754748342100)
    assert parts == pytest.approx(wanted, rel=1e-14)
    grazing = relative(first=Mover(), second=Mover((1000.0, 500.0, 0.0), (-10.0, -5.000001, 0.0)))
    # as doubles the inputs differ from the decimals by their rounding, which the small distance shows
    assert grazing.closest_time == pytest.approx(99.99999599999952, rel=1e-15)
    assert grazing.closest_distance == pytest.approx(8.9442715522282680748e-5, rel=1e-8)
    wide = curve(shape=Helix(1e-8, 2.0 * math.pi), at=0.3)
    assert (wide.curvature, wide.torsion) == pytest.approx((9.999999999999999e-9, 0.9999999999999999), rel=1e-15)


# relative, moving frame


def test_closest_approach_on_both_sides_of_time_zero() -> None:
    parting = relative(first=Mover(), second=Mover(position=(3.0, 4.0, 0.0), velocity=(1.0, 1.0, 0.0)))
    assert (parting.closest_time, parting.closest_distance, parting.advice[0].code) == (0.0, 5.0, "parting")
    still = relative(first=Mover(), second=Mover(position=(3.0, 4.0, 0.0)))
    assert (still.closest_distance, still.advice[0].code) == (5.0, "at-rest")
    falling = relative(first=Mover(), second=Mover((10.0, 0.0, 20.0), (-2.0, 0.0, 0.0), (0.0, 0.0, -9.81)), time=1.0)
    around = [math.dist((0, 0, 0), (10 - 2 * t, 0, 20 - 4.905 * t * t)) for t in np.linspace(0.0, 6.0, 60001)]
    assert falling.closest_distance == pytest.approx(min(around), abs=1e-7)


@settings(max_examples=30, deadline=None)
@given(*[st.tuples(SPEED, SPEED, SPEED)] * 4)
def test_moving_frame_is_the_motion_of_a_turned_point(w: Any, alpha: Any, r: Any, rel: Any) -> None:
    """Beside differences of the position of a point carried by a turning matrix."""
    spin = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
    turn = np.array([[0, -alpha[2], alpha[1]], [alpha[2], 0, -alpha[0]], [-alpha[1], alpha[0], 0]]) + spin @ spin
    made = moving_frame(position=r, angular_velocity=w, angular_acceleration=alpha, relative_velocity=rel)
    assert made.velocity == pytest.approx(spin @ r + rel, abs=1e-9)
    assert made.acceleration == pytest.approx(turn @ r + 2.0 * spin @ rel, abs=1e-6)


def test_orientation_turns_into_fixed_axes() -> None:
    half = math.sqrt(0.5)
    made = moving_frame(position=(1.0, 0.0, 0.0), angular_velocity=(0.0, 0.0, 2.0), orientation=(half, 0.0, 0.0, half))
    assert made.fixed_velocity == pytest.approx((-2.0, 0.0, 0.0), abs=1e-12)
    bad = refused(lambda: moving_frame(position=(1.0, 0.0, 0.0), orientation=(1.0, 0.0, 0.0, 1.0)))
    assert isinstance(bad, InadmissibleError)


# the command line


def test_rows_equal_single_calls() -> None:
    rows = "position,angular_velocity,relative_velocity\n" + '"1,0,0 m","0,0,3 rad/s","2,0,0 m/s"\n' * 2
    out = run("path", "moving-frame", "--rows", "-", stdin=rows)
    document = answer(
        "path",
        "moving-frame",
        "--position",
        "1,0,0 m",
        "--angular-velocity",
        "0,0,3 rad/s",
        "--relative-velocity",
        "2,0,0 m/s",
    )
    assert str(document["results"]["acceleration"]["value"][1]) in out.out
    bad = run(
        "path",
        "rectilinear",
        "--rows",
        "-",
        stdin="start_speed[m/s],acceleration[m/s^2],distance[m]\n20,-4,48\n20,-4,51\n",
    )
    assert bad.status == 4
    assert "1 m short of 51 m" in bad.out


def test_formulas_at_the_edge() -> None:
    scaled = answer("path", "curve", "--x", "1000*t^2 mm", "--at", "2 s")
    assert scaled["results"]["speed"]["value"] == pytest.approx(4.0)
    spun = answer("path", "curve", "--curve", "circle", "--radius", "2 m", "--angle-law", "90*t deg", "--at", "1 s")
    assert spun["results"]["speed"]["value"] == pytest.approx(math.pi)
    uncertain = answer("path", "curve", "--x", "a*t^2 m", "--let", "a=3 ± 0.1 m", "--at", "2 s")
    assert uncertain["results"]["speed"]["std"] == pytest.approx(0.4, rel=1e-3)
    assert uncertain["inputs"]["let"] == ["a=3 ± 0.1 m"]


@pytest.mark.parametrize(
    ("option", "text", "words"),
    [
        ("--x", "3*t", "no unit at its end"),
        ("--x", "3 t m", "products with *"),
        ("--x", "3*t kg", "is a mass"),
        ("--x", "sin(t) foo", "neither a unit"),
        ("--x", "3*q m", "'q' has no value"),
        ("--let", "a3 m", "NAME=VALUE"),
        ("--let", "t=3 s", "meaning in formulas"),
        ("--let", "a=3 blorp", "unknown unit"),
    ],
)
def test_bad_formulas_are_told_with_their_option(option: str, text: str, words: str) -> None:
    more = [] if option == "--x" else ["--x", "a*t m"]
    outcome = run("path", "curve", option, text, *more, "--at", "1 s")
    assert outcome.status == 2
    assert words in outcome.err


def test_a_time_beyond_the_doubles_is_refused_by_name() -> None:
    outcome = run("path", "rectilinear", "--start-speed", "3 m/s", "--distance", "1e308 m", "--acceleration", "1 m/s^2",
                  "--json")  # fmt: skip
    assert outcome.status == 3
    assert outcome.error["code"] == "range"
    assert "nan" not in outcome.err


def test_relative_motion_of_formulas_agrees_with_constant_accelerations() -> None:
    plain = Mover((0.0, 9.0, 0.0), (0.8, -1.0, 0.0), (0.0, 0.3, 0.1))
    typed = Mover(x=metres("0.8*t"), y=metres("9 - t + 0.15*t^2"), z=metres("0.05*t^2"))
    first = Mover(velocity=(2.0, 1.0, 0.0))
    one, other = relative(first=first, second=plain, time=1.0), relative(first=first, second=typed, time=1.0, end=20.0)
    for name in ("closest_distance", "closest_time", "closest_speed", "distance", "closing_speed", "position",
                 "velocity", "acceleration", "first_position", "second_position"):  # fmt: skip
        assert getattr(other, name) == pytest.approx(getattr(one, name), rel=1e-12, abs=1e-12), name


def test_relative_motion_of_formulas_beside_more_digits() -> None:
    circle = Mover(x=metres("4*cos(0.5*t)"), y=metres("4*sin(0.5*t)"))
    line = Mover((0.0, 9.0, 0.0), (0.8, -1.0, 0.0))
    made = relative(first=circle, second=line, end=12.0)
    with mp.workdps(40):

        def gap(t: Any) -> Any:
            return mp.hypot(mpf(4) / 5 * t - 4 * mp.cos(t / 2), 9 - t - 4 * mp.sin(t / 2))

        when = mp.findroot(lambda t: mp.diff(gap, t), 2.7)
        assert made.closest_time == pytest.approx(float(when), rel=1e-14)
        assert made.closest_distance == pytest.approx(float(gap(when)), rel=1e-14)
    assert all(check.passed for check in made.checks)
    # before the minimum the end of the search is the nearest
    early = relative(first=circle, second=line, end=1.0)
    assert (early.closest_time, [one.code for one in early.advice]) == (1.0, ["edge"])


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"first": Mover(x=metres("t"))}, "needs an end"),
        ({"first": Mover(x=metres("1/(t-2)")), "end": 5.0}, "pole"),
        ({"first": Mover((1.0, 0.0, 0.0), x=metres("t")), "end": 5.0}, "two of these are given"),
        ({"first": Mover(x=metres("t")), "end": 5.0, "time": 6.0}, "does not hold"),
    ],
)
def test_relative_motion_of_formulas_is_refused(given: dict[str, Any], words: str) -> None:
    with pytest.raises(InadmissibleError, match=words):
        relative(second=Mover(), **given)


def test_parts_of_spherical_velocity_and_the_ellipse_by_other_formulas() -> None:
    made = spherical(radius=2.0, polar_angle=math.radians(50.0), azimuth=math.radians(20.0), radial_speed=0.3,
                     polar_rate=0.4, azimuth_rate=-0.7)  # fmt: skip
    parts = (made.radial_velocity, made.polar_velocity, made.azimuth_velocity)  # type: ignore[attr-defined]
    assert parts == pytest.approx((0.3, 0.8, -1.0724622203665692493), rel=1e-15)
    # ρ of an ellipse at its parameter u: (a² sin² u + b² cos² u)^(3/2)/(ab)
    sine, cosine = mp.sin(mpf(0.5)), mp.cos(mpf(0.5))
    wanted = (9 * sine**2 + 4 * cosine**2) ** mpf("1.5") / 6
    assert curve(shape=Ellipse(3.0, 2.0), at=0.5).radius_of_curvature == pytest.approx(float(wanted), rel=1e-15)
    assert float(wanted) == pytest.approx(1.9474395548949149862, rel=1e-15)


def test_laws_of_distance_and_angle_agree_with_coordinates_and_with_polar() -> None:
    radius, angle = Formula("0.2 + 0.1*t^2", 1.0, "m"), Formula("3*t - t^2", 1.0, "rad")
    by_laws = curve(radius_law=radius, angle_law=angle, z=Formula("0.1*t", 1.0, "m"), at=0.7)
    x, y = (Formula(f"(0.2 + 0.1*t^2)*{turn}(3*t - t^2)", 1.0, "m") for turn in ("cos", "sin"))
    by_places = curve(x=x, y=y, z=Formula("0.1*t", 1.0, "m"), at=0.7)
    for name in ("position", "velocity", "acceleration", "curvature", "torsion", "arc_length"):
        assert getattr(by_laws, name) == pytest.approx(getattr(by_places, name), rel=1e-12), name
    parts = polar(radius=0.249, radial_speed=0.14, angular_velocity=1.6, radial_speed_rate=0.2, angular_acceleration=-2)
    for name in (
        "radial_velocity",
        "transverse_velocity",
        "radial_acceleration",
        "transverse_acceleration",
        "coriolis",
    ):
        assert getattr(by_laws, name) == pytest.approx(getattr(parts, name), rel=1e-12), name
    with pytest.raises(InadmissibleError, match="one of the angle"):
        curve(radius_law=radius, at=0.7)


def test_a_vector_in_the_plane_may_be_a_magnitude_and_a_direction() -> None:
    words = ("path", "relative", "--second-position", "100, 0 m", "--second-velocity")
    by_angle = answer(*words, "15 m/s @ 60 deg")
    by_parts = answer(*words, f"{15 * math.cos(math.pi / 3)}, {15 * math.sin(math.pi / 3)} m/s")
    for name in ("closest_distance", "closest_time", "closest_speed"):
        assert by_angle["results"][name]["value"] == pytest.approx(by_parts["results"][name]["value"], rel=1e-12)
    uncertain = answer(*words, "15 m/s @ 60±2 deg")["results"]["closing_speed"]
    assert uncertain["std"] == pytest.approx(15 * math.sin(math.pi / 3) * math.radians(2), rel=0.01)
