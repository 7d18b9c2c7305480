"""Recorded speeds: exact rationals for distance, limits, deviations and the event; brute force between the samples."""

import math
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import pytest
from harness import answer, run
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.skid.timing.recorded import ListedSpeeds
from dynamics_cli.skid.timing.recorder import record_of

TABLE = (78, 78, 78, 78, 77, 76, 74, 66, 54, 41, 29)
SPEEDS = tuple(speed / 3.6 for speed in TABLE)


def test_the_distance_is_the_sum_of_trapezoids() -> None:
    exact = sum(Fraction(a + b) / 2 * Fraction(1, 2) for a, b in pairwise(TABLE)) / Fraction(36, 10)
    found = record_of(recorded=ListedSpeeds(SPEEDS))
    assert found.distance == pytest.approx(float(exact), rel=1e-15)
    assert found.intervals[6].distance_left == pytest.approx(29.513888888888888889, rel=1e-15)


def test_common_and_rounding_errors_are_kept_apart() -> None:
    found = record_of(recorded=ListedSpeeds(SPEEDS))
    weights = [Fraction(1, 4), *[Fraction(1, 2)] * 9, Fraction(1, 4)]
    rounding = math.sqrt(float(sum(w * w for w in weights) / 12)) / 3.6
    assert found.rounding_deviation == pytest.approx(rounding, rel=1e-14)
    assert found.common_deviation == pytest.approx(5.0 / math.sqrt(3.0) / 3.6, rel=1e-14)
    assert found.distance_deviation == pytest.approx(0.81134176705193907018, rel=1e-14)


def test_limits_between_the_samples() -> None:
    found = record_of(recorded=ListedSpeeds(SPEEDS), greatest_acceleration=0.9 * 9.80665)
    assert found.greatest_distance == pytest.approx(found.distance + 4.3644264012359221025496, rel=1e-14)
    assert found.least_distance == pytest.approx(found.distance - 4.3644264012359221025496, rel=1e-14)


@given(st.lists(st.floats(0.0, 30.0), min_size=2, max_size=4), st.floats(0.2, 2.0), st.floats(1.0, 1.6))
def test_limits_are_those_of_hardest_braking_and_driving(speeds: list[float], interval: float, more: float) -> None:
    most = more * max(abs(b - a) for a, b in pairwise(speeds)) / interval + 1.0
    found = record_of(recorded=ListedSpeeds(tuple(speeds), interval), greatest_acceleration=most)
    least = greatest = 0.0
    for before, after in pairwise(speeds):
        # speeds at a fine grid of times: the least are cut off by both ends and by rest, the greatest by both ends
        steps = 2000
        times = [interval * (i + 0.5) / steps for i in range(steps)]
        least += sum(max(before - most * t, after - most * (interval - t), 0.0) for t in times) * interval / steps
        greatest += sum(min(before + most * t, after + most * (interval - t)) for t in times) * interval / steps
    assert found.least_distance == pytest.approx(least, abs=1e-5 * (1.0 + found.distance + most * interval**2))
    assert found.greatest_distance == pytest.approx(greatest, abs=1e-5 * (1.0 + found.distance + most * interval**2))


def test_the_speed_at_the_event_and_the_slip_of_its_wheels() -> None:
    found = record_of(recorded=ListedSpeeds(SPEEDS))
    assert found.least_event_speed == pytest.approx(4.7222222222222222222, rel=1e-14)
    assert found.greatest_event_speed == pytest.approx(8.0555555555555555556, rel=1e-14)
    slipping = record_of(recorded=ListedSpeeds(SPEEDS), greatest_age=0.0, least_slip=0.08, greatest_slip=0.18)
    assert slipping.least_event_speed == pytest.approx(8.7560386473429951691, rel=1e-14)
    assert slipping.greatest_event_speed == pytest.approx(9.8238482384823848238, rel=1e-14)


def test_braking_began_within_an_interval_and_the_age() -> None:
    found = record_of(recorded=ListedSpeeds(SPEEDS), brake_on=8)
    assert (found.brake_latest, found.brake_earliest, found.speed_before_braking) == (1.5, 2.5, SPEEDS[6])
    assert record_of(recorded=ListedSpeeds(SPEEDS), brake_on=1).brake_earliest is None


def test_what_the_wheels_did_is_said() -> None:
    assert [one.code for one in record_of(recorded=ListedSpeeds(SPEEDS)).advice] == ["wheel-slip"]
    assert record_of(recorded=ListedSpeeds(SPEEDS), greatest_slip=0.1).advice == ()
    assert [one.code for one in record_of(recorded=ListedSpeeds((20.0, 5.0))).advice] == ["wheel-locked"]
    assert [one.code for one in record_of(recorded=ListedSpeeds((60.0, 60.0))).advice] == ["end-of-range"]


@pytest.mark.parametrize(
    "more", [{"recorded": ListedSpeeds((20.0,))}, {"brake_on": 12}, {"least_age": 2.0}, {"least_slip": 0.3}]
)
def test_what_no_record_can_be(more: dict) -> None:
    with pytest.raises(InadmissibleError):
        record_of(**{"recorded": ListedSpeeds(SPEEDS), **more})


def test_a_jump_names_what_it_needs() -> None:
    outcome = run("skid", "record", "--speeds", "78, 20 km/h", "--greatest-acceleration", "0.9 g")
    assert outcome.status == 3
    assert "needs 3.286 g; at most 0.9 g is possible" in outcome.err


def test_each_speed_may_be_uncertain() -> None:
    found = answer("skid", "record", "--speeds", "78 ± 1, 77 ± 1, 60 ± 1 km/h", "--interval", "0.5 s")["results"]
    assert found["distance"]["std"] == pytest.approx(0.5 / 3.6 * math.sqrt(1.5), rel=1e-3)


def test_a_file_says_what_a_list_does_and_when_the_brake_was_on(tmp_path: Path) -> None:
    file = tmp_path / "edr.csv"
    rows = [f"{-5.0 + 0.5 * n},{speed},{'on' if n >= 7 else 'off'}" for n, speed in enumerate(TABLE)]
    file.write_text("\n".join(["time[s],speed[km/h],brake", *rows]))
    listed = answer("skid", "record", "--speeds", f"{','.join(map(str, TABLE))} km/h", "--brake-on", "8")["results"]
    results = answer("skid", "record", "--file", str(file))["results"]
    for name in ("distance", "least_event_speed", "brake_earliest", "speed_before_braking"):
        assert results[name]["value"] == pytest.approx(listed[name]["value"], rel=1e-12)
    # a table that ends at -0.5 s has a last sample that is half a second older
    file.write_text("\n".join(["time[s],speed[km/h],brake", *rows[:-1]]))
    early = answer("skid", "record", "--file", str(file))
    assert early["results"]["brake_latest"]["value"] == pytest.approx(1.5)
    assert [entry["code"] for entry in early["warnings"]] == ["stops-early", "wheel-slip"]
    # heads as spreadsheets have them
    file.write_text("\n".join(["Time [s], Speed [km/h], Brake", *rows]))
    assert answer("skid", "record", "--file", str(file))["results"] == results
    file.write_text("time[s],speed[km/h]\n-1,50\n-0.6,48\n0,40\n")
    uneven = run("skid", "record", "--file", str(file))
    assert uneven.status == 3
    assert "not equally spaced: 0.4 s to 0.6 s apart" in uneven.err


def test_rows_of_vehicles_that_stand_between_samples_are_those_of_single_calls() -> None:
    """Among rows that do not stand."""
    least = ["--greatest-acceleration", "9 m/s^2", "--only", "least_distance"]
    rows = ["60,50,40", *["60,50,40", "20,6,2"] * 160, "60,50,40"]
    out = run(
        "skid",
        "record",
        *least,
        "--rows",
        "-",
        stdin="speeds[0][km/h],speeds[1][km/h],speeds[2][km/h]\n" + "\n".join(rows),
    ).out
    wanted = {
        row: repr(answer("skid", "record", *least[:2], "--speeds", f"{row} km/h")["results"]["least_distance"]["value"])
        for row in set(rows)
    }
    assert [line.split(",")[3] for line in out.splitlines()[1:]] == [wanted[row] for row in rows]
