"""Throws on a grade, rollovers, surveyed marks, swerves, start-ups, moving sight: references, invariants, refusals."""

import json
import math
from pathlib import Path

import pytest
from harness import answer, run
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.elliptic import first_kind_with_pair
from dynamics_cli.numerics.fitting.circle import circle_through
from dynamics_cli.numerics.road.phases import Kind, Phase
from dynamics_cli.skid.curved.survey import Points
from dynamics_cli.skid.curved.swerve import swerve
from dynamics_cli.skid.pedestrian import pedestrian
from dynamics_cli.skid.rollover.task import rollover
from dynamics_cli.skid.throw import on_grade
from dynamics_cli.skid.timing.follow import follow
from dynamics_cli.skid.timing.hidden import Obstruction
from dynamics_cli.skid.timing.meet import Party
from dynamics_cli.skid.timing.sight import sight
from dynamics_cli.skid.timing.timeline import EndSpeed, StartSpeed, timeline
from dynamics_cli.skid.values.data import ROWS
from dynamics_cli.skid.values.task import SURFACES, TOPICS, values
from dynamics_cli.skid.yaw import Radius, yaw

REFERENCE = json.loads((Path(__file__).parent / "evidence.json").read_text(encoding="utf-8"))
NEAR = 4e-15
G = 9.80665
CAR = {"track_width": 1.54, "cm_height": 0.7, "roll_gyration": 0.55**0.5}
MARK = (0.0, 0.0, 5.0, 2.29, 10.0, 4.30, 15.0, 6.07, 20.0, 7.53, 25.0, 8.74, 30.0, 9.65, 35.0, 10.31, 40.0, 10.70)
# the fit's own condition: a nanometre of a point moves this radius by forty
FITTED = 1e-13


def about(text: str, near: float = NEAR) -> object:
    return pytest.approx(float(text), rel=near)


# throws


@pytest.mark.parametrize(("name", "grade"), [("up", 0.06), ("level", 0.0), ("down", -0.08)])
def test_a_throw_along_a_grade_is_the_simulated_one(name: str, grade: float) -> None:
    exact = REFERENCE["throws"][name]
    found = on_grade(throw_distance=28.0, friction=0.6, launch_height=0.9, launch_angle=math.radians(15.0), grade=grade)
    for result in ("speed", "flight_time", "flight_distance", "least_speed"):
        assert getattr(found, result) == about(exact[result]), result
    assert found.flight_distance + found.slide_distance == pytest.approx(28.0, rel=1e-14)
    assert all(check.passed for check in found.checks)


@pytest.mark.parametrize(
    ("grade", "speed", "least"),
    [
        (0.06, 16.800323120735602210, 16.152433157170801591),
        (0.0, 16.032876792801304094, 15.414582734617013991),
        (-0.08, 14.902009803788526313, 14.327326655170840069),
    ],
)
def test_distances_measured_along_the_road_are_turned(grade: float, speed: float, least: float) -> None:
    """S 28 m along the road from the foot of the normal, H 0.9 m along that, α 15 degrees from the road."""
    slope = math.atan(grade)
    found = on_grade(
        throw_distance=28.0 * math.cos(slope) + 0.9 * math.sin(slope), friction=0.6,
        launch_height=0.9 / math.cos(slope), launch_angle=math.radians(15.0) + slope, grade=grade,
    )  # fmt: skip
    assert found.speed == pytest.approx(speed, rel=1e-14)
    assert found.least_speed == pytest.approx(least, rel=1e-14)


@given(st.floats(5.0, 60.0), st.floats(0.3, 0.9), st.floats(0.0, 1.2), st.floats(0.0, 0.5))
def test_a_grade_of_zero_is_the_level_road(distance: float, friction: float, height: float, angle: float) -> None:
    inputs = {"throw_distance": distance, "friction": friction, "launch_height": height, "launch_angle": angle}
    try:
        level = pedestrian(**inputs)
    except InadmissibleError:
        return
    if distance <= friction * height:
        return
    graded = on_grade(**inputs, grade=0.0)
    assert graded.speed == pytest.approx(level.speed, rel=1e-13)
    assert graded.slide_time == pytest.approx(level.slide_time, rel=1e-9, abs=1e-6)


@given(st.floats(10.0, 60.0), st.floats(0.4, 0.9), st.floats(-0.12, 0.12), st.floats(-0.2, 0.9))
def test_no_launch_needs_less_than_the_least_speed(
    distance: float, friction: float, grade: float, angle: float
) -> None:
    try:
        found = on_grade(throw_distance=distance, friction=friction, launch_angle=angle, launch_height=0.8, grade=grade)
    except InadmissibleError:
        return
    assert found.speed is not None
    assert found.speed >= found.least_speed * (1.0 - 1e-13)


def test_the_vehicle_was_faster_than_the_body_it_threw() -> None:
    body = on_grade(throw_distance=25.0, friction=0.66, launch_angle=0.2, grade=0.01)
    masses = {"efficiency": 0.8, "body_mass": 75.0, "vehicle_mass": 1300.0}
    found = on_grade(throw_distance=25.0, friction=0.66, launch_angle=0.2, grade=0.01, **masses)
    assert body.vehicle_speed is None
    assert found.vehicle_speed == pytest.approx(body.speed * (14.0 * 1375.0 / 1300.0 / 0.8) / 14.0, rel=1e-15)
    # as printed: 14 m/s of projection
    assert 14.0 * found.vehicle_speed / found.speed == pytest.approx(18.509615384615384615, rel=1e-15)
    level = pedestrian(throw_distance=25.0, friction=0.66, **masses)
    assert level.least_vehicle_speed == pytest.approx(level.least_speed * 1375.0 / 1300.0 / 0.8, rel=1e-15)


def test_both_names_of_a_throw_lead_to_it() -> None:
    words = ("--throw-distance", "25 m", "--friction", "0.66")
    for route in ("", "tree"):
        old, new = (run("skid", name, *words, "--json", route=route) for name in ("pedestrian", "throw"))
        assert (old.status, old.out) == (0, new.out)
    assert "\n  pedestrian" not in run("skid", "--help").out
    assert run("schema", "skid", "pedestrian").out == run("schema", "skid", "throw").out
    assert run("skid", "pedestrian", "--help").out == run("skid", "throw", "--help").out


# rollovers


def test_trips_at_a_kerb_and_in_soil() -> None:
    exact = REFERENCE["rollovers"]
    found = rollover(**CAR, trip_deceleration=1.4 * G)
    assert found.stability == pytest.approx(1.1, rel=1e-15)
    assert found.kerb_speed == about(exact["kerb"]["speed"])
    assert found.trip_speed == about(exact["soil"]["speed"])
    assert found.trip_angle == about(exact["soil"]["angle"])
    assert found.trip_time == about(exact["soil"]["time"])
    weak = rollover(**CAR, trip_deceleration=1.15 * G)
    assert weak.trip_speed == about(exact["weak_soil"]["speed"], 1e-14)
    # a millionth above what tips: nine digits of the difference are left
    near = rollover(**CAR, trip_deceleration=1.1000001 * G)
    assert near.trip_speed == about(exact["limit"]["speed"], 1e-9)


@given(st.floats(1.2, 1.8), st.floats(0.4, 1.2), st.floats(0.4, 1.0), st.floats(1.001, 50.0))
def test_a_kerb_is_the_limit_of_hard_soil(track: float, height: float, gyration: float, times: float) -> None:
    limit = 0.5 * track / height * G
    sizes = {"track_width": track, "cm_height": height, "roll_gyration": gyration}
    found, harder, hardest = (
        rollover(**sizes, trip_deceleration=limit * share) for share in (times, 1.3 * times, 1e12 * times)
    )
    assert found.trip_speed > harder.trip_speed > found.kerb_speed
    assert hardest.trip_speed == pytest.approx(found.kerb_speed, rel=1e-5)


@given(st.floats(0.1, 10.0))
def test_everything_longer_by_a_scale_is_slower_by_its_root(scale: float) -> None:
    one = rollover(**CAR, trip_deceleration=1.4 * G)
    many = rollover(**{name: scale * size for name, size in CAR.items()}, trip_deceleration=1.4 * G)
    assert many.trip_speed == pytest.approx(one.trip_speed * math.sqrt(scale), rel=1e-13)
    assert many.trip_angle == pytest.approx(one.trip_angle, rel=1e-13)


def test_tipping_in_a_curve_and_the_speed_of_rolling() -> None:
    bank = REFERENCE["rollovers"]["bank"]
    found = rollover(
        track_width=1.54, cm_height=0.7, superelevation=float(bank["superelevation"]), radius=60.0,
        roll_distance=44.0, roll_drag=0.53, turns=3.0, trip_distance=4.0, trip_deceleration=1.4 * G,
    )  # fmt: skip
    assert found.tip_drag == about(bank["tip_drag"])
    assert found.curve_speed == about(bank["curve_speed"])
    assert found.roll_speed == about(REFERENCE["rollovers"]["roll"]["speed"])
    assert found.roll_rate == pytest.approx(6.0 * math.pi / (88.0 / found.roll_speed), rel=1e-14)
    assert found.speed**2 == pytest.approx(found.roll_speed**2 + 2.0 * 1.4 * G * 4.0, rel=1e-14)
    # the same by two segments of a skid
    segments = ("distance=4 m, friction=1.4", "distance=44 m, friction=0.53")
    document = answer("skid", "speed", *(part for text in segments for part in ("--segment", text)))
    assert document["results"]["speed"]["value"] == pytest.approx(3.6 * found.speed, rel=1e-14)


@given(st.floats(0.01, 100.0), st.floats(0.01, 100.0))
def test_the_elliptic_integral_of_real_arguments(x: float, y: float) -> None:
    """R_F(x, y, y) is elementary."""
    if abs(x / y - 1.0) < 1e-3:
        return
    exact = math.acos(math.sqrt(x / y)) / math.sqrt(y - x) if x < y else math.acosh(math.sqrt(x / y)) / math.sqrt(x - y)
    assert first_kind_with_pair(x, y, 0.0) == pytest.approx(exact, rel=1e-12)


# surveyed marks


def test_a_surveyed_mark() -> None:
    exact = REFERENCE["marks"]
    found = yaw(path=Points(MARK, 0.03), friction=0.72, track_width=1.5)
    whole = exact["whole"]
    assert found.mark_radius == about(whole["radius"], FITTED)
    assert found.centre == (about(whole["centre_x"], FITTED), about(whole["centre_y"], FITTED))
    assert found.radius_deviation == about(whole["deviation"], 1e-11)
    assert found.point_scatter == about(whole["scatter"], 1e-10)
    assert found.first_half_radius == about(exact["first_half"]["radius"], 1e-11)
    assert found.second_half_radius == about(exact["second_half"]["radius"], 1e-11)
    assert found.speed == about(exact["speed"]["speed"], FITTED)
    assert found.speed_deviation == pytest.approx(found.speed * 0.5 * found.radius_deviation / found.path_radius)
    # it tightens, as a mark at the limit does
    assert [item.code for item in found.advice] == []
    # without a deviation the scatter speaks
    alone = yaw(path=Points(MARK), friction=0.72)
    assert alone.radius_deviation == pytest.approx(found.radius_deviation * found.point_scatter / 0.03, rel=1e-12)


def test_three_points_and_a_flat_mark() -> None:
    exact = REFERENCE["marks"]
    three = yaw(path=Points((0.0, 0.0, 20.0, 7.53, 40.0, 10.70), 0.03), friction=0.72)
    assert three.mark_radius == about(exact["three"]["radius"], FITTED)
    assert three.radius_deviation == about(exact["three"]["deviation"], 1e-11)
    assert yaw(path=Points((0.0, 0.0, 20.0, 7.53, 40.0, 10.70)), friction=0.72).advice[0].code == "no-scatter"
    flat = (0.0, 0.0, 10.0, 0.05, 20.0, 0.07, 30.0, 0.05, 40.0, 0.0)
    with pytest.raises(InadmissibleError, match="do not decide the radius") as refused:
        yaw(path=Points(flat, 0.03), friction=0.72)
    assert refused.value.code == "undetermined"
    fitted = circle_through(flat[0::2], flat[1::2])
    assert fitted is not None
    assert (fitted.radius, 0.03 * fitted.factor) == (
        about(exact["flat"]["radius"], 1e-10), about(exact["flat"]["deviation"], 1e-6)
    )  # fmt: skip


def test_grid_coordinates_keep_the_decimals_as_typed() -> None:
    far = [f"{500000 + x:.0f}, {5400000 + y:.2f}" for x, y in zip(MARK[0::2], MARK[1::2], strict=True)]
    document = answer(
        "skid", "yaw", "--points", f"{', '.join(far)} m", "--friction", "0.72", "--point-deviation", "3 cm"
    )
    assert document["results"]["mark_radius"]["value"] == about(REFERENCE["marks"]["whole"]["radius"], 1e-12)


def test_a_survey_in_a_file_is_the_same_mark(tmp_path: Path) -> None:
    rows = [f"A,{1640000 + x / 0.3048!r},{y / 0.3048!r}" for x, y in zip(MARK[::2], MARK[1::2], strict=True)]
    file = tmp_path / "survey.csv"
    words = ("skid", "yaw", "--survey", str(file), "--friction", "0.72", "--point-deviation", "3 cm")
    file.write_text("\n".join(["# right rear", "point,Easting[ft],Northing[ft]", *rows]))
    assert answer(*words)["results"]["mark_radius"]["value"] == about(REFERENCE["marks"]["whole"]["radius"], 1e-7)
    for text, wanted in (("", "empty"), ("a,b\n1,2", "no columns"), ("x[m],y[chain]", "unit"), ("x,y\n1,?", "'?'"),
                         ("x,y\n1,2\n2,2.5", "three points")):  # fmt: skip
        file.write_text(text)
        outcome = run(*words)
        assert (outcome.status, wanted in outcome.err) == (3, True), outcome.err


@given(st.floats(-3.0, 3.0), st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.booleans())
def test_turned_moved_and_mirrored_marks_have_one_radius(turn: float, x: float, y: float, mirrored: bool) -> None:
    cosine, sine, sign = math.cos(turn), math.sin(turn), -1.0 if mirrored else 1.0
    points: list[float] = []
    for a, b in zip(MARK[0::2], MARK[1::2], strict=True):
        points += [x + a * cosine - sign * b * sine, y + a * sine + sign * b * cosine]
    found = yaw(path=Points(tuple(points), 0.03), friction=0.72)
    assert found.mark_radius == about(REFERENCE["marks"]["whole"]["radius"], 1e-8)


@given(st.floats(20.0, 500.0), st.floats(0.3, 2.0), st.integers(3, 12))
def test_points_on_a_circle_give_it(radius: float, turn: float, count: int) -> None:
    points: list[float] = []
    for i in range(count):
        points += [radius * math.cos(turn * i / (count - 1)), radius * math.sin(turn * i / (count - 1))]
    found = yaw(path=Points(tuple(points), 0.001), friction=0.7)
    assert found.speed == pytest.approx(yaw(path=Radius(radius), friction=0.7).speed, rel=1e-9)


def test_a_mark_that_opens_is_no_yaw_at_the_limit() -> None:
    back = tuple(part for i in reversed(range(9)) for part in MARK[2 * i : 2 * i + 2])
    assert [item.code for item in yaw(path=Points(back, 0.03), friction=0.72).advice] == ["opening-mark"]
    # within its own scatter a difference decides nothing
    assert [item.code for item in yaw(path=Points(back, 0.1), friction=0.72).advice] == []


def test_a_braked_yaw_and_the_error_of_tests() -> None:
    exact = REFERENCE["marks"]["braked"]
    assert yaw(path=Radius(95.0), friction=0.75, braking_drag=0.25).speed == about(exact["with_braking"])
    assert yaw(path=Radius(95.0), friction=0.75, braking_drag=0.0).speed == about(exact["without"])
    assert yaw(path=Radius(95.0), friction=0.75, test_error=0.041).speed == pytest.approx(
        float(exact["without"]) / 1.041, rel=1e-15
    )
    document = answer("skid", "yaw", "--radius", "95 m", "--friction", "0.75", "--test-error", "4.1 % ± 6.3 %")
    assert document["results"]["speed"]["std"] == pytest.approx(95.16 / 1.041 * 0.063 / 1.041, rel=0.03)


# swerves


def test_a_swerve_in_arcs_and_as_a_sine() -> None:
    exact = REFERENCE["swerve"]
    found = swerve(speed=25.0, lateral_shift=3.5, lateral_acceleration=0.35 * G, drag_factor=0.7)
    assert found.distance == about(exact["distance"])
    assert found.time == about(exact["time"])
    assert found.one_arc_distance == about(exact["one_arc"])
    assert found.sine_time == about(exact["sine_time"])
    assert found.equal_speed == about(exact["equal_speed"])
    same = swerve(speed=found.equal_speed, lateral_shift=3.5, lateral_acceleration=0.35 * G, drag_factor=0.7)
    assert same.braking_distance == pytest.approx(same.distance, rel=1e-13)
    lean = swerve(speed=25.0, lateral_shift=3.5, lateral_acceleration=G)
    assert lean.lean_angle == pytest.approx(math.pi / 4.0, rel=1e-15)


@given(st.floats(8.0, 60.0), st.floats(0.5, 5.0), st.floats(1.0, 7.0), st.floats(0.0, 2.0))
def test_the_reaction_comes_on_top_and_mirrors_in_time(speed: float, shift: float, rate: float, late: float) -> None:
    found = swerve(speed=speed, lateral_shift=shift, lateral_acceleration=rate)
    later = swerve(speed=speed, lateral_shift=shift, lateral_acceleration=rate, reaction_time=late, steering_lag=0.1)
    assert later.total_distance == pytest.approx(found.distance + speed * (late + 0.1), rel=1e-14)
    assert later.total_time == pytest.approx(found.time + late + 0.1, rel=1e-14)
    # an arc is longer than its chord along the road, and each half is half of both
    assert found.distance < speed * found.time
    half = swerve(speed=speed, lateral_shift=0.5 * shift, lateral_acceleration=rate)
    assert half.one_arc_distance == pytest.approx(0.5 * found.distance, rel=1e-13)


# start-ups and moving sight


@pytest.mark.parametrize(
    ("name", "alpha", "fade", "way"), [("book", 2.0, 0.12, 11.0), ("strong", 3.0, 0.6, 80.0), ("weak", 2.0, 1e-9, 11.0)]
)
def test_a_start_up_by_lambert(name: str, alpha: float, fade: float, way: float) -> None:
    exact = REFERENCE["start_up"][name]
    phase = Phase(Kind("start-up"), acceleration=alpha, fade=fade, distance=way)
    found = timeline(phases=phase, known=StartSpeed(0.0))
    assert (found.duration, found.end_speed) == (about(exact["time"]), about(exact["speed"]))
    # as one piece of a course, in polynomials
    leader = Party(Phase(Kind("constant"), duration=1.0), StartSpeed(0.0))
    assert follow(leader=leader, follower=Party(phase, StartSpeed(0.0)), gap=way).contact_time == about(
        exact["time"], 1e-13
    )


@given(st.floats(0.0, 8.0), st.floats(1.0, 4.0), st.floats(0.0, 0.1), st.floats(0.1, 6.0))
def test_a_start_up_back_and_forward(start: float, alpha: float, fade: float, time: float) -> None:
    law = {"acceleration": alpha, "fade": fade}
    if alpha - fade * start < 0.05:
        return
    forward = timeline(phases=Phase(Kind("start-up"), duration=time, **law), known=StartSpeed(start))
    for known in ({"duration": time}, {"distance": forward.distance * (1.0 - 1e-13)}):
        back = timeline(phases=Phase(Kind("start-up"), **known, **law), known=EndSpeed(forward.end_speed))
        assert back.start_speed == pytest.approx(start, abs=1e-5)
    again = timeline(phases=Phase(Kind("start-up"), speed=forward.end_speed, **law), known=StartSpeed(start))
    assert again.duration == pytest.approx(time, rel=1e-10)
    if fade == 0.0:
        even = timeline(phases=Phase(Kind("accelerating"), duration=time, acceleration=alpha), known=StartSpeed(start))
        assert even.distance == pytest.approx(forward.distance, rel=1e-14)


def steady(speed: float) -> Party:
    return Party(Phase(Kind("constant"), duration=5.0), EndSpeed(speed))


VAN = Obstruction(Phase(Kind("constant"), duration=5.0), end_speed=10.0, heading=math.pi)


def test_a_walker_steps_out_behind_an_oncoming_van() -> None:
    exact = REFERENCE["sight"]
    found = sight(
        first=steady(13.0), second=steady(1.5), corner_before=20.0, corner_aside=1.2, eye_behind=2.0, obstruction=VAN,
        obstruction_length=12.0,
    )  # fmt: skip
    assert [row.change for row in found.changes] == ["closes", "opens"]
    assert found.changes[0].time_left == about(exact["closes"])
    assert found.time_left == about(exact["opens"])


def test_what_stands_is_what_moves_at_no_speed() -> None:
    places = {"corner_before": 6.0, "corner_aside": 1.8, "eye_behind": 2.0}
    fixed = sight(first=steady(13.0), second=steady(1.5), **places)
    still = Obstruction(Phase(Kind("waiting"), duration=5.0), end_speed=0.0)
    for more in (
        {"obstruction": still},
        {"obstruction_length": 1e4},
        {"obstruction": still, "obstruction_length": 1e4},
    ):
        assert sight(first=steady(13.0), second=steady(1.5), **places, **more).time_left == pytest.approx(
            fixed.time_left, rel=1e-13
        )
    # all three twice as fast: the moment is half as long before
    quick = Obstruction(Phase(Kind("constant"), duration=5.0), end_speed=20.0, heading=math.pi)
    places = {"corner_before": 20.0, "corner_aside": 1.2, "eye_behind": 2.0, "obstruction_length": 12.0}
    slow = sight(first=steady(13.0), second=steady(1.5), **places, obstruction=VAN).time_left
    assert sight(first=steady(26.0), second=steady(3.0), **places, obstruction=quick).time_left == pytest.approx(
        0.5 * slow
    )


# published ranges


def test_every_range_has_ends_in_order_and_a_source() -> None:
    found = values().values
    assert len(found) == len(ROWS)
    for row in found:
        assert row.source
        assert row.topic in TOPICS
        assert row.least is None or row.least <= row.greatest


def test_words_and_surfaces_choose() -> None:
    assert {row.surface for row in values("friction", surface="asphalt").values} == {"asphalt"}
    assert {row.topic for row in values("reaction").values} == {"reaction"}
    assert {row.topic for row in values("tire", "friction").values} == {"friction"}
    assert [row.greatest for row in values("roll", "drag").values] == [0.53, 0.6]
    assert "gravel" in SURFACES
    for words in (("skid", "values", "frictoin"), ("skid", "values", "--surface", "cobbles")):
        outcome = run(*words)
        assert outcome.status == 3
        assert "friction" in outcome.err or "asphalt" in outcome.err
    lines = run("skid", "values").out.splitlines()
    assert max(map(len, lines)) <= 80


REFUSED = {
    "slides on": ("throw --throw-distance|25 m|--friction|0.06|--grade|-8 %", "slides on"),
    "one mass": ("throw --throw-distance|25 m|--friction|0.6|--body-mass|75 kg", "--vehicle-mass"),
    "masses alone": (
        "throw --throw-distance|25 m|--friction|0.6|--body-mass|75 kg|--vehicle-mass|1 t",
        "projection efficiency",
    ),
    "no throw": ("throw --throw-distance|25 m|--friction|0.6|--efficiency|0", "throws nobody"),
    "stops": (
        "throw --throw-distance|25 m|--friction|0.6|--launch-angle|70 deg|--grade|2 %|--launch-height|1 m",
        "landing stops the body",
    ),
    "too soft": (
        "rollover --track-width|5 ft|--cm-height|2 ft|--roll-gyration|2 ft|--trip-deceleration|30 ft/s^2",
        "more than 40.22 ft/s²",
    ),
    "tips alone": ("rollover --track-width|1 m|--cm-height|1 m|--superelevation|-60 %", "tips by itself"),
    "no rolling": ("rollover --track-width|1 m|--cm-height|1 m|--roll-distance|9 m", "--roll-drag"),
    "half a point": ("yaw --points|0, 0, 5, 1, 10 m|--friction|0.7", "5 numbers"),
    "a line": ("yaw --points|0, 0, 5, 5, 10, 10 m|--friction|0.7", "lie on a line"),
    "all braking": ("yaw --radius|95 m|--friction|0.7|--braking-drag|0.7", "uses all of the friction"),
    "a turn": ("swerve --speed|5 km/h|--lateral-shift|3.5 m|--lateral-acceleration|0.4 g", "more than two arcs"),
    "no room": ("swerve --speed|0 km/h|--lateral-shift|3.5 m|--lateral-acceleration|0.4 g", "at rest"),
    "beyond": (
        "timeline --start-speed|60 km/h|--kind|start-up|--acceleration|2 m/s^2|--fade|0.12 1/s|--duration|2 s",
        "nothing is left of the acceleration",
    ),
    "fades": ("timeline --start-speed|6 km/h|--kind|constant|--fade|0.12 1/s|--duration|2 s", "no meaning"),
    "too long": (
        "timeline --end-speed|6 m/s|--kind|start-up|--acceleration|2 m/s^2|--fade|0.12 1/s|--distance|20 m",
        "began at rest",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_is_refused_with_its_reason(name: str) -> None:
    call, words = REFUSED[name]
    task, _, rest = call.partition(" ")
    outcome = run("skid", task, *rest.split("|"))
    assert outcome.status in (2, 3), outcome.out
    assert words in outcome.err.replace("\n  ", " "), outcome.err


def test_the_references_are_calculated_again() -> None:
    from references import generate_skid_evidence_references as generator

    assert generator.swerves() == REFERENCE["swerve"]
    assert generator.start_ups() == REFERENCE["start_up"]
    assert generator.moving_sight() == REFERENCE["sight"]
