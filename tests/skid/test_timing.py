"""Phases, meetings, contacts and sight: integrated references, both directions, what cannot be."""

import json
import math
from pathlib import Path

import pytest
from harness import answer, run
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.numerics.polynomials import roots_between, shifted, value
from dynamics_cli.numerics.road.phases import Kind, Phase
from dynamics_cli.pictures import Curve
from dynamics_cli.skid.commands.timing import MEET
from dynamics_cli.skid.stop import stop
from dynamics_cli.skid.timing.follow import follow
from dynamics_cli.skid.timing.meet import Party, meet
from dynamics_cli.skid.timing.sight import sight
from dynamics_cli.skid.timing.timeline import EndSpeed, StartSpeed, timeline

REFERENCE = json.loads((Path(__file__).parent / "timing.json").read_text(encoding="utf-8"))
NEAR = 4e-15
DRIVER = (
    Phase(Kind("reaction"), duration=1.2), Phase(Kind("build-up"), duration=0.2),
    Phase(Kind("braking"), distance=14.0, friction=0.7),
)  # fmt: skip
CAR = Party(DRIVER, EndSpeed(8.0))


def walker(distance: float, speed: float) -> Party:
    return Party(Phase(Kind("constant"), distance=distance), EndSpeed(speed))


def about(text: str) -> object:
    return pytest.approx(float(text), rel=NEAR)


def test_a_reaction_a_build_up_and_braking_back_from_the_impact() -> None:
    found, exact = timeline(phases=DRIVER, known=EndSpeed(8.0)), REFERENCE["car"]
    assert found.start_speed == about(exact["start_speed"])
    assert found.distance == about(exact["distance"])
    assert found.duration == about(exact["duration"])
    reaction, rise, braking = found.phases
    assert reaction.distance == about(exact["reaction_distance"])
    assert rise.distance == about(exact["build_up_distance"])
    assert (braking.duration, braking.start_speed) == (about(exact["braking_time"]), about(exact["braking_speed"]))


def test_a_pedestrian_and_what_would_have_sufficed() -> None:
    exact = REFERENCE["meeting"]
    found = meet(first=CAR, second=walker(4.6, 1.4), clear_distance=0.44)
    for name in ("hazard_time", "first_distance", "stopping_speed", "late_speed"):
        assert getattr(found, name) == about(exact[name]), name
    assert found.sufficient_speed == found.late_speed
    # beyond 1.9 m the car would stand before the way is clear: to stop short is what governs
    governed = meet(first=CAR, second=walker(4.6, 1.4), clear_distance=1.9)
    assert (governed.late_speed, governed.sufficient_speed) == (None, about(exact["stopping_speed"]))


def test_a_way_that_is_clear_before_the_brakes_act_fully() -> None:
    exact = REFERENCE["quick_meeting"]
    driver = (
        Phase(Kind("reaction"), duration=1.1), Phase(Kind("build-up"), duration=0.3),
        Phase(Kind("braking"), distance=6.0, friction=0.6),
    )  # fmt: skip
    car = Party(driver, EndSpeed(5.0))
    for name, way, clear in (("build_up", 7.0, 1.0), ("reaction", 5.0, 0.4)):
        found = meet(first=car, second=walker(way, 6.25), clear_distance=clear)
        assert found.first_distance == about(exact[f"{name}_away"])
        assert found.late_speed == about(exact[f"{name}_late"])


def test_the_speed_that_stops_short_does_and_the_deceleration_that_suffices_too() -> None:
    found = meet(first=CAR, second=walker(4.6, 1.4))
    assert found.stopping_speed is not None
    whole = stop(speed=found.stopping_speed, friction=0.7, reaction_time=1.2, build_up_time=0.2)
    assert whole.stopping_distance == pytest.approx(found.first_distance, rel=1e-14)
    assert found.sufficient_deceleration is not None
    harder = stop(
        speed=found.first_speed, friction=found.sufficient_deceleration / 9.80665, reaction_time=1.2, build_up_time=0.2
    )
    assert harder.stopping_distance == pytest.approx(found.first_distance, rel=1e-14)
    assert found.earlier is not None
    whole = stop(speed=found.first_speed, friction=0.7, reaction_time=1.2, build_up_time=0.2)
    assert found.first_speed * found.earlier == pytest.approx(whole.stopping_distance - found.first_distance, rel=1e-13)


@pytest.mark.parametrize("distance", [1e-3, 0.2, 0.9])
def test_a_hazard_so_near_that_the_build_up_is_not_over(distance: float) -> None:
    driver = (Phase(Kind("build-up"), duration=2.0), Phase(Kind("braking"), duration=0.1, friction=0.8))
    found = meet(first=Party(driver, EndSpeed(1.0)), second=walker(distance / 9.0, 1.0), clear_distance=None)
    assert found.stopping_speed is not None
    whole = stop(speed=found.stopping_speed, friction=0.8, reaction_time=0.0, build_up_time=2.0)
    assert whole.stopping_distance == pytest.approx(found.first_distance, rel=1e-13)


def pair(leader: float, follower: float, *, reaction: float = 1.1) -> tuple[Party, Party]:
    late = (Phase(Kind("reaction"), duration=reaction), Phase(Kind("braking"), speed=0.0, acceleration=6.5))
    ahead = Party(Phase(Kind("braking"), speed=0.0, acceleration=7.0), StartSpeed(leader))
    return ahead, Party(late, StartSpeed(follower))


def test_a_follower_reaches_a_leader_that_stands() -> None:
    exact = REFERENCE["following"]
    leader, follower = pair(20.0, 20.5)
    found = follow(leader=leader, follower=follower, gap=25.0)
    assert found.contact_time == about(exact["contact_time"])
    assert found.closing_speed == pytest.approx(float(exact["closing_speed"]), rel=1e-13)
    assert found.leader_speed == 0.0
    # a nanometre decides both ways
    lost = float(exact["way_lost"])
    assert follow(leader=leader, follower=follower, gap=lost - 1e-9).contact
    apart = follow(leader=leader, follower=follower, gap=lost + 1e-9)
    assert not apart.contact
    assert apart.least_gap == pytest.approx(1e-9, abs=1e-14)
    assert found.sufficient_gap == pytest.approx(lost, rel=1e-14)
    assert found.missing_gap == pytest.approx(lost - 25.0, rel=1e-13)


def test_the_least_gap_is_where_the_speeds_are_equal() -> None:
    exact = REFERENCE["following"]
    leader = Party(Phase(Kind("constant"), duration=1.0), StartSpeed(18.0))
    follower = Party(Phase(Kind("braking"), duration=2.0, acceleration=4.0), StartSpeed(25.0))
    found = follow(leader=leader, follower=follower, gap=20.0)
    assert (found.least_gap, found.least_gap_time) == (about(exact["least_gap"]), about(exact["least_gap_time"]))


def test_a_faster_follower_arrives_in_the_end() -> None:
    slow = Party(Phase(Kind("constant"), duration=1.0), StartSpeed(18.0))
    fast = Party(Phase(Kind("constant"), duration=1.0), StartSpeed(20.0))
    found = follow(leader=slow, follower=fast, gap=70.0)
    assert found.contact_time == pytest.approx(35.0, rel=1e-14)
    # no gap suffices
    assert (found.sufficient_gap, found.missing_gap) == (None, 70.0)
    assert not follow(leader=fast, follower=slow, gap=70.0).contact


def test_sight_past_a_corner() -> None:
    exact = REFERENCE["sight"]
    car, other = (Party(Phase(Kind("constant"), duration=5.0), EndSpeed(speed)) for speed in (13.0, 1.5))
    found = sight(first=car, second=other, corner_before=6.0, corner_aside=1.8, eye_behind=2.0)
    assert found.time_left == about(exact["steadily"])
    assert found.first_distance == about(exact["steadily_first"])
    assert found.second_distance == about(exact["steadily_second"])
    assert [row.change for row in found.changes] == ["opens"]


def test_sight_of_a_braking_car_at_seventy_degrees() -> None:
    exact = REFERENCE["sight"]
    car = Party(
        (Phase(Kind("constant"), duration=2.0), Phase(Kind("braking"), duration=1.2, friction=0.6)), EndSpeed(7.0)
    )
    other = Party(Phase(Kind("accelerating"), duration=2.9, acceleration=1.5), EndSpeed(4.5))
    found = sight(
        first=car, second=other, corner_before=6.0, corner_aside=1.2, eye_behind=1.9, crossing=math.radians(70.0)
    )
    assert found.time_left == pytest.approx(float(exact["braking"]), rel=1e-14)
    assert found.first_distance == pytest.approx(float(exact["braking_first"]), rel=1e-14)
    assert found.second_distance == pytest.approx(float(exact["braking_second"]), rel=1e-14)


def test_mirrored_and_scaled_sight_is_the_same() -> None:
    def opened(scale: float) -> float:
        car, other = (Party(Phase(Kind("constant"), duration=5.0), EndSpeed(v * scale)) for v in (13.0, 1.5))
        places = {"corner_before": 6.0 * scale, "corner_aside": 1.8 * scale, "eye_behind": 2.0 * scale}
        return sight(first=car, second=other, **places).time_left

    assert opened(2.0) == pytest.approx(opened(1.0), rel=1e-14)


def test_what_nothing_hides_is_in_sight_all_along() -> None:
    car, other = (Party(Phase(Kind("constant"), duration=1.0), EndSpeed(speed)) for speed in (13.0, 1.5))
    found = sight(first=car, second=other, corner_before=6.0, corner_aside=30.0)
    assert (found.time_left, found.changes) == (1.0, ())
    assert found.advice[0].code == "always-in-sight"


SPEED = st.floats(1.0, 50.0)
TIME = st.floats(0.05, 4.0)
RATE = st.floats(0.5, 9.0)


@given(SPEED, TIME, TIME, TIME, RATE, RATE)
def test_back_and_forward_are_one_motion(
    end: float, reaction: float, rise: float, braking: float, brakes: float, drive: float
) -> None:
    phases = (
        Phase(Kind("accelerating"), duration=reaction, acceleration=0.1 * drive),
        Phase(Kind("reaction"), duration=reaction),
        Phase(Kind("build-up"), duration=rise),
        Phase(Kind("braking"), duration=braking, acceleration=brakes),
    )
    # fast enough that the first phase does not begin below rest
    back = timeline(phases=phases, known=EndSpeed(end + drive))
    forward = timeline(phases=phases, known=StartSpeed(back.start_speed))
    assert forward.end_speed == pytest.approx(back.end_speed, abs=1e-13 * back.phases[1].start_speed)
    assert forward.distance == pytest.approx(back.distance, rel=1e-13)
    assert [row.distance for row in forward.phases] == pytest.approx([row.distance for row in back.phases], rel=1e-12)
    for one, other in zip(back.moments[:-1], back.moments[1:], strict=True):
        assert one.speed >= 0.0
        assert other.distance >= one.distance


@given(SPEED, st.floats(0.0, 1.0), RATE)
def test_every_pair_of_numbers_gives_the_same_phase(start: float, share: float, rate: float) -> None:
    time = (0.02 + 0.9 * share) * start / rate
    end, way = start - rate * time, time * (start - 0.5 * rate * time)
    known = {"duration": time, "distance": way, "speed": end, "acceleration": rate}
    for pick in (("duration", "distance"), ("duration", "speed"), ("duration", "acceleration"), ("distance", "speed"),
                 ("distance", "acceleration"), ("speed", "acceleration")):  # fmt: skip
        phase = Phase(Kind("braking"), **{name: known[name] for name in pick})
        row = timeline(phases=phase, known=StartSpeed(start)).phases[0]
        assert row.duration == pytest.approx(time, rel=1e-9), pick
        assert row.distance == pytest.approx(way, rel=1e-9), pick
        assert row.end_speed == pytest.approx(end, abs=1e-7 * start), pick


@given(st.lists(st.floats(-3.0, 3.0), min_size=1, max_size=5, unique=True), st.floats(-2.0, 2.0))
def test_roots_of_products_are_found(roots: list[float], by: float) -> None:
    coefficients = [1.0]
    for root in roots:
        coefficients = [b - root * a for a, b in zip([*coefficients, 0.0], [0.0, *coefficients], strict=True)]
    apart = min((abs(a - b) for a in roots for b in roots if a is not b), default=1.0)
    if apart > 0.05:
        assert roots_between(coefficients, -4.0, 4.0) == pytest.approx(sorted(roots), abs=1e-6)
    assert value(shifted(coefficients, by), 0.25) == pytest.approx(value(coefficients, 0.25 + by), abs=1e-9)


REFUSED = {
    "too much": (("kind=braking, distance=5 m, duration=1 s, friction=0.7",), "needs two"),
    "too little": (("kind=braking, distance=5 m",), "needs two"),
    "stops before": (("kind=braking, duration=9 s, friction=0.7",), "at rest after 0.7284 s"),
    "even": (("kind=reaction, duration=1 s, friction=0.7",), "no meaning"),
    "no time": (("kind=constant",), "either duration or distance"),
    "wrong way": (("kind=braking, distance=5 m, speed=90 km/h",), "cannot lead from"),
    "rising to what": (("kind=build-up, duration=0.2 s",), "not known"),
    "waits in motion": (("kind=waiting, duration=2 s",), "at rest"),
    "unknown": (("kind=hovering, duration=2 s",), "hovering"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_no_phase_can_be(name: str) -> None:
    phases, words = REFUSED[name]
    outcome = run(
        "skid", "timeline", "--start-speed", "5 m/s", *(part for phase in phases for part in ("--phase", phase))
    )
    assert outcome.status in (2, 3)
    assert words in outcome.err.replace("\n  ", " "), outcome.err


def test_shared_friction_of_a_timeline_is_carried_to_its_speed() -> None:
    document = answer(
        "skid", "timeline", "--end-speed", "8 ± 0.5 m/s", "--phase", "kind=reaction, duration=1.2 s",
        "--phase", "kind=build-up, duration=0.2 s", "--phase", "kind=braking, distance=14 m, friction=0.7 ± 0.05",
    )  # fmt: skip
    speed = document["results"]["start_speed"]
    # first order: v_b ∂v_b = v ∂v + g d ∂μ, and the build-up adds g t_b/2 ∂μ
    slope = 14.0 * 9.80665 / 16.006571775367767 + 0.1 * 9.80665
    wanted = math.hypot(0.5 * 8.0 / 16.006571775367767, 0.05 * slope) * 3.6
    assert speed["std"] == pytest.approx(wanted, rel=0.01)


def test_the_references_are_integrated_again(tmp_path: Path) -> None:
    from references import generate_skid_timing_references as generator

    again = {"car": generator.car()[3], "following": generator.following()}
    assert again == {name: REFERENCE[name] for name in again}


UNCERTAIN = (
    "skid", "meet", "--first-end-speed", "8 ± 1 m/s", "--first-phase", "kind=reaction, duration=1.0..1.4 s",
    "--first-phase", "kind=build-up, duration=0.2 s", "--first-phase", "kind=braking, distance=14 m, friction=0.7",
    "--second-kind", "constant", "--second-distance", "4.6 m", "--second-end-speed", "1.4 ± 0.2 m/s",
    "--clear-distance", "0.44 m",
)  # fmt: skip


def test_whether_it_was_avoidable_has_a_probability(monkeypatch: pytest.MonkeyPatch) -> None:
    document = answer(*UNCERTAIN)
    chance = document["chances"]["avoidable"]["probability"]
    drawn = answer(*UNCERTAIN, "--method", "monte-carlo", "--samples", "2000")
    assert drawn["chances"]["avoidable"]["probability"] == pytest.approx(chance, abs=0.04)
    assert f"yes          with a probability of {100.0 * chance:.2g} %" in run(*UNCERTAIN).out
    # cases side by side are what each of them is alone
    monkeypatch.setattr(MEET, "branches", False)
    alone = answer(*UNCERTAIN, "--method", "monte-carlo", "--samples", "2000")
    assert alone["results"]["sufficient_speed"]["std"] == pytest.approx(
        drawn["results"]["sufficient_speed"]["std"], rel=1e-12
    )
    assert "chances" not in answer("skid", "avoid", "--speed", "62 km/h", "--sight-distance", "32 m",
                                   "--reaction-time", "1.2 s", "--friction", "0.75")  # fmt: skip


def test_the_diagram_of_two_parties_has_bands_over_its_whole_length(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    from dynamics_cli.core.output import plot

    drawn = []
    monkeypatch.setattr(plot, "drawn", lambda picture, settings: (drawn.append(picture), (b"", {}))[1])
    monkeypatch.chdir(tmp_path)
    document = answer(*UNCERTAIN, "--plot", "meet.svg")
    places, speeds = (panel.items for panel in drawn[0].panels[:2])
    bands = [item for item in places if isinstance(item, Curve) and item.style == "fill"]
    assert [band.role for band in bands] == [0, 1]
    assert max(bands[0].x) >= document["results"]["hazard_time"]["interval"][1]
    # both are at the impact at time zero, whatever their speeds
    assert [y for x, y in zip(bands[0].x, bands[0].y, strict=True) if x == 0.0] == pytest.approx([0.0, 0.0])
    swift = next(item for item in speeds if isinstance(item, Curve) and item.style == "fill")
    ends = sorted(y for x, y in zip(swift.x, swift.y, strict=True) if x == 0.0)
    assert ends == pytest.approx([8.0 - 1.96, 8.0 + 1.96], abs=0.05)


def test_tables_fit_a_screen() -> None:
    words = ("skid", "timeline", "--end-speed", "8 m/s", "--phase", "kind=reaction, duration=1.2 s", "--phase",
             "kind=braking, distance=14 m, friction=0.7", "--table", "phases")  # fmt: skip
    short, whole = run(*words).out, run(*words, "--all").out
    assert max(map(len, short.splitlines())) <= 80
    assert short.endswith("more columns with --all: duration, distance, acceleration\n")
    assert "acceleration" in whole.splitlines()[0]


def test_cases_without_a_contact_are_not_called_inadmissible() -> None:
    document = answer(
        "skid", "follow", "--gap", "25 ± 2 m", "--leader-start-speed", "20 m/s", "--leader-kind", "braking",
        "--leader-speed", "0 m/s", "--leader-acceleration", "7 m/s^2", "--follower-start-speed", "20.5 m/s",
        "--follower-phase", "kind=reaction, duration=1.1 s", "--follower-phase",
        "kind=braking, speed=0 m/s, acceleration=6.5 m/s^2",
    )  # fmt: skip
    said = [warning["message"] for warning in document["warnings"] if warning["code"] == "partly-inadmissible"]
    assert len(said) == 1
    assert "of the inputs' distribution has no contact time" in said[0]


def test_the_kind_of_a_phase_may_lead_it() -> None:
    braking = "distance=14 m, friction=0.7"
    named = answer("skid", "timeline", "--end-speed", "8 m/s", "--phase", f"kind=braking, {braking}")
    led = answer("skid", "timeline", "--end-speed", "8 m/s", "--phase", f"braking, {braking}")
    assert led == named
    misspelt = run("skid", "timeline", "--end-speed", "8 m/s", "--phase", f"brakng, {braking}")
    assert misspelt.err.startswith("dynamics: --phase: read 'brakng', wanted NAME=VALUE")
