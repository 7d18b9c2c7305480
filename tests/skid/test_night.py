"""Recognition at night, alone and past a corner; the curve of the first as it would have avoided the impact."""

import math

import pytest
from harness import answer, run
from mpmath import mp, mpf

from dynamics_cli.errors import InadmissibleError, UsageError
from dynamics_cli.numerics.road.phases import Kind, Phase
from dynamics_cli.pictures import Curve
from dynamics_cli.skid.timing.meet import Party, meet
from dynamics_cli.skid.timing.pictures import meet as drawn
from dynamics_cli.skid.timing.sight import sight
from dynamics_cli.skid.timing.timeline import EndSpeed

CAR, WALKER = (Party(Phase(Kind("constant"), duration=5.0), EndSpeed(speed)) for speed in (13.0, 1.5))
CORNER = {"corner_before": 6.0, "corner_aside": 1.8}


def near(distance: str, tilt: float = 90.0) -> float:
    """Time left at which eye and target are so far apart: a quadratic of steady speeds, to 40 digits."""
    with mp.workdps(40):
        fast, slow, behind, c = mpf(13), mpf("1.5"), mpf(2), mp.cos(mp.radians(tilt))
        a, half = fast**2 + slow**2 - 2 * fast * slow * c, behind * (fast - slow * c)
        return float((-half + mp.sqrt(half**2 - a * (behind**2 - mpf(distance) ** 2))) / a)


@pytest.mark.parametrize(("distance", "tilt"), [("35", 90.0), ("15", 90.0), ("20", 60.0), ("20", 175.0)])
def test_recognition_at_a_distance(distance: str, tilt: float) -> None:
    found = sight(
        first=CAR, second=WALKER, recognition_distance=float(distance), eye_behind=2.0, crossing=math.radians(tilt)
    )
    assert found.time_left == pytest.approx(near(distance, tilt), rel=1e-13)
    assert found.sight_line == pytest.approx(float(distance), rel=1e-13)
    assert found.by == "recognition distance"


def test_the_later_of_corner_and_night_opens_the_sight() -> None:
    corner = sight(first=CAR, second=WALKER, eye_behind=2.0, **CORNER)
    assert corner.by == "corner"
    for distance in (15.0, 22.0, 24.0, 40.0):
        found = sight(first=CAR, second=WALKER, eye_behind=2.0, recognition_distance=distance, **CORNER)
        times = near(str(distance)), corner.time_left
        assert found.time_left == pytest.approx(min(times), rel=1e-13)
        assert found.by == ("recognition distance" if times[0] < times[1] else "corner")
    far = sight(first=CAR, second=WALKER, eye_behind=2.0, recognition_distance=400.0)
    assert (far.time_left, far.by, far.advice[0].code) == (5.0, None, "always-in-sight")


def test_a_night_that_shows_nothing_is_refused() -> None:
    with pytest.raises(InadmissibleError, match="within 1 m, less than the eye's 2 m"):
        sight(first=CAR, second=WALKER, eye_behind=2.0, recognition_distance=1.0)
    with pytest.raises((InadmissibleError, UsageError), match="neither a corner"):
        sight(first=CAR, second=WALKER)
    steady = "--first-kind constant --first-duration 5s --first-end-speed 13m/s --second-kind constant"
    half = run("skid", "sight", *steady.split(), "--second-duration", "5s", "--second-end-speed", "1m/s",
               "--corner-before", "6m", "--json")  # fmt: skip
    assert half.status == 2
    assert "--corner-aside" in half.error["hint"]


def test_an_uncertain_distance_of_recognition() -> None:
    car = "--first-kind constant --first-duration 5s --first-end-speed 13m/s --eye-behind 2m"
    walker = "--second-kind constant --second-duration 5s --second-end-speed 1.5m/s"
    found = answer("skid", "sight", *car.split(), *walker.split(), "--recognition-distance", "30..40 m")["results"][
        "time_left"
    ]
    ends = near("30.25"), near("39.75")
    assert found["interval"] == pytest.approx(ends, rel=1e-6)


def test_the_avoiding_curve_begins_with_the_hazard_and_stops_short() -> None:
    phases = (
        Phase(Kind("reaction"), duration=1.2), Phase(Kind("build-up"), duration=0.2),
        Phase(Kind("braking"), distance=14.0, friction=0.7),
    )  # fmt: skip
    given = {"first": Party(phases, EndSpeed(8.0)), "second": Party(Phase(Kind("constant"), 1.0), EndSpeed(1.4))}
    found = meet(**given)
    curves = [one for one in drawn(found, **given).panels[0].items if isinstance(one, Curve) and one.style == "dashed"]
    assert (curves[0].x[0], curves[0].y[0]) == (
        pytest.approx(found.hazard_time), pytest.approx(found.first_distance)
    )  # fmt: skip
    assert curves[0].y[-1] == pytest.approx(0.0, abs=1e-9 * found.first_distance)
