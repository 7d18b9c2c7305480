"""Measured tracks: what is read, what the smoothing leaves of known motions, and whether the noise stated is true."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from harness import answer, run

from dynamics_cli.errors import DynamicsError
from dynamics_cli.numerics.fitting.smoothing import Smooth
from dynamics_cli.path import pictures
from dynamics_cli.path.relative.motions import Mover
from dynamics_cli.path.relative.task import relative
from dynamics_cli.path.tracks.file import read_track, third_differences
from dynamics_cli.path.tracks.task import Smoothing, table
from dynamics_cli.pictures import Curve
from dynamics_cli.records import Formula

SIGMA = 0.02


def ring(count: int, sigma: float, seed: int) -> tuple[Any, Any, Any]:
    times = np.linspace(0.0, 2.0 * math.pi, count)
    places = np.column_stack([np.cos(times), np.sin(times)])
    return times, places + sigma * np.random.default_rng(seed).standard_normal(places.shape), places


def written(folder: Path, text: str) -> str:
    path = folder / "track.csv"
    path.write_text(text, encoding="utf-8")
    return str(path)


def as_csv(times: Any, places: Any, header: str = "t[s],x[m],y[m]") -> str:
    rows = (",".join(map(repr, map(float, (t, *place)))) for t, place in zip(times, places, strict=True))
    return header + "\n" + "\n".join(rows) + "\n"


@pytest.mark.parametrize("sigma", [None, SIGMA])
def test_the_noise_stated_is_that_of_the_derivatives(sigma: float | None) -> None:
    """Over many tracks with known motion the errors are as large as they are said to be, within a factor."""
    shares, found = [], []
    for seed in range(30):
        times, measured, places = ring(50, SIGMA, seed)
        fit = Smooth(times, measured, sigma)
        rate, noise = fit.at(times, 2)
        shares.append(((rate + places) / noise[:, None]) ** 2)
        found.append(fit.measured_sigma)
    assert 0.5 < math.sqrt(np.mean(shares)) < 1.4
    assert np.mean(found) == pytest.approx(SIGMA, rel=0.06)


def test_second_differences_are_far_noisier() -> None:
    times, measured, places = ring(400, 1e-4, 5)
    step = times[1] - times[0]
    raw = np.diff(measured, 2, axis=0) / step**2 + places[1:-1]
    assert raw.std() == pytest.approx(1e-4 * math.sqrt(6.0) / step**2, rel=0.1)
    fit = Smooth(times, measured, None)
    smooth, _ = fit.at(times[1:-1], 2)
    assert (smooth + places[1:-1]).std() < raw.std() / 50.0
    assert third_differences(measured) == pytest.approx(1e-4, rel=0.1)


def test_quadratics_are_kept_as_they_are() -> None:
    times = np.linspace(1.0, 3.0, 20)
    fit = Smooth(times, np.column_stack([5.0 + 3.0 * times - 2.0 * times**2]), 0.1)
    rate, _ = fit.at(times, 2)
    assert rate == pytest.approx(np.full((20, 1), -4.0), abs=1e-6)
    assert fit.freedom == pytest.approx(3.0, abs=1e-6)


def test_long_tracks_have_fewer_knots_than_points() -> None:
    times, measured, places = ring(2000, 1e-3, 2)
    fit = Smooth(times, measured, None)
    assert fit.thinned
    assert fit.measured_sigma == pytest.approx(1e-3, rel=0.05)
    assert (fit.at(times, 0)[0] - places).std() < 3e-4


def test_a_circle_comes_back(tmp_path: Path) -> None:
    times, measured, _ = ring(80, 0.003, 1)
    made = table(written(tmp_path, as_csv(times, measured)), sigma=0.003)
    middle = made.points[40]
    assert middle.speed == pytest.approx(1.0, abs=4.0 * middle.speed_noise)
    assert middle.normal == pytest.approx(1.0, abs=4.0 * middle.acceleration_noise)
    assert middle.curvature == pytest.approx(1.0, abs=4.0 * middle.curvature_noise)
    assert made.length == pytest.approx(2.0 * math.pi, rel=0.01)
    assert made.raw_noise > 5.0 * made.acceleration_noise
    assert [one.code for one in made.advice] == []


def test_a_wrong_sigma_is_noticed(tmp_path: Path) -> None:
    times, measured, _ = ring(80, 0.003, 1)
    made = table(written(tmp_path, as_csv(times, measured)), sigma=0.03)
    assert [one.code for one in made.advice] == ["sigma"]


def test_units_of_the_header_and_one_coordinate(tmp_path: Path) -> None:
    times = np.linspace(0.0, 2.0, 21)
    text = as_csv(times * 1e3, np.column_stack([1e3 * times**2]), "time [ms], x [mm]")
    made = table(written(tmp_path, "# a drop\n" + text), sigma=1e-4)
    assert made.points[10].speed == pytest.approx(2.0, rel=1e-6)
    assert made.strongest_acceleration == pytest.approx(2.0, rel=1e-6)
    assert (made.strongest_lateral, made.points[10].y, made.points[10].curvature) == (None, None, None)


def test_latitude_and_longitude_are_metres_on_the_ground(tmp_path: Path) -> None:
    """A second of arc of latitude at 45° is 30.87 m; of longitude 21.90 m (WGS 84)."""
    rows = "".join(f"{t},{45 + t / 3600:.9f},{-179.9995 - t / 3600:.9f}\n" for t in range(10))
    track = read_track(written(tmp_path, "t,lat,lon\n" + rows))
    assert track.places[9] == pytest.approx([-9 * 21.902, 9 * 30.869], rel=2e-4)
    assert track.origin


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "empty"),
        ("a,b\n1,2\n", "no columns of a time"),
        ("t,lat\n1,2\n", "no columns of a time"),
        ("t[s],x[furlong]\n0,1\n", "that tracks cannot have"),
        ("t,x\n0,1\n1,nan\n", "line 3: 'nan' is not a number"),
        ("t,x\n0,1\n1\n", "line 3: '' is not a number"),
        ("t,x\n0,1\n1,2\n1,3\n", "line 4"),
        ("t,x\n0,1\n1,2\n2,3\n", "has 3 points"),
    ],
)
def test_damaged_tracks_are_refused(tmp_path: Path, text: str, words: str) -> None:
    with pytest.raises(DynamicsError) as caught:
        table(written(tmp_path, text))
    assert words in caught.value.message


def test_raw_differences_are_refused_with_their_noise(tmp_path: Path) -> None:
    times, measured, _ = ring(101, 0.003, 1)
    with pytest.raises(DynamicsError) as caught:
        table(written(tmp_path, as_csv(times, measured)), sigma=0.003, smoothing=Smoothing("none"))
    step = 2.0 * math.pi / 100
    assert f"{0.003 * math.sqrt(6.0) / step**2:.4g} m/s^2" in caught.value.message


def test_the_command_answers_and_draws(tmp_path: Path) -> None:
    times, measured, _ = ring(40, 0.003, 1)
    file = written(tmp_path, as_csv(times, measured))
    document = answer("path", "table", file, "--sigma", "3 mm", "--plot", str(tmp_path / "track.svg"))
    assert len(document["results"]["points"]) == 40
    assert (tmp_path / "track.svg").stat().st_size > 1000
    assert run("path", "table", file, "--smoothing", "none").status == 3


def test_the_noise_of_a_track_takes_no_distribution_of_its_own() -> None:
    """It says itself how uncertain positions are; thousands of smoothings would take hours."""
    outcome = run("path", "table", "examples/gps_track/track.csv", "--sigma", "2..3 cm", "--json")
    assert outcome.status == 2
    assert outcome.error["code"] == "uncertain"
    assert outcome.error["parameter"] == "sigma"


def crossing(folder: Path, seed: int) -> tuple[Mover, Mover]:
    """Two tracks that pass each other: straight on at 15 m/s, and across with a growing speed."""
    random = np.random.default_rng(seed)
    movers = []
    first, second = np.arange(0.0, 12.01, 0.2), np.arange(2.0, 14.0, 0.25)
    places = (
        np.column_stack([15.0 * first, 0.0 * first]),
        np.column_stack([0.0 * second + 120.0, -80.0 + 11.0 * second]),
    )
    places[1][:, 1] += 0.1 * second**2
    for name, times, place in (("a", first, places[0]), ("b", second, places[1])):
        path = folder / f"{name}{seed}.csv"
        path.write_text(as_csv(times, place + SIGMA * random.standard_normal(place.shape)), encoding="utf-8")
        movers.append(Mover(track=str(path), sigma=SIGMA))
    return movers[0], movers[1]


def test_two_tracks_come_as_close_as_the_motions_behind_them_within_the_noise_stated(tmp_path: Path) -> None:
    steady = Mover(velocity=(15.0, 0.0, 0.0)), Mover((120.0, -80.0, 0.0), (0.0, 11.0, 0.0), (0.0, 0.2, 0.0))
    exact = relative(first=steady[0], second=steady[1], time=5.0)
    shares: dict[str, list[float]] = {"closest_distance": [], "closest_time": [], "distance": [], "closing_speed": []}
    tracks = 30
    for seed in range(tracks):
        first, second = crossing(tmp_path, seed)
        seen = relative(first=first, second=second, time=5.0)
        assert all(check.passed for check in seen.checks)
        for name, values in shares.items():
            values.append((getattr(seen, name) - getattr(exact, name)) / getattr(seen, f"{name}_noise"))
    for name, values in shares.items():
        # the noise stated includes a share for what smoothing removes: it is not too small
        assert 0.5 < math.sqrt(np.mean(np.square(values))) < 1.3, name
        assert abs(np.mean(values)) < 4.0 / math.sqrt(tracks), name


def test_a_track_beside_formulas_and_a_steady_point(tmp_path: Path) -> None:
    first, second = crossing(tmp_path, 1)
    both = relative(first=first, second=second)
    formula = Mover(x=Formula("120", 1.0, "m"), y=Formula("-80 + 11*t + 0.1*t^2", 1.0, "m"))
    steady = Mover((120.0, -80.0, 0.0), (0.0, 11.0, 0.0), (0.0, 0.2, 0.0))
    beside = [relative(first=first, second=other) for other in (formula, steady)]
    assert beside[0].closest_distance == pytest.approx(beside[1].closest_distance, rel=1e-12)
    assert beside[0].closest_distance == pytest.approx(both.closest_distance, abs=0.06)
    assert (beside[0].shown_time, both.shown_time, both.points[0].time) == (0.0, 2.0, 2.0)
    assert 0.0 < beside[0].closest_distance_noise < both.closest_distance_noise
    seen = relative(first=second, second=first)
    assert seen.closest_distance == pytest.approx(both.closest_distance, rel=1e-12)
    early = relative(first=first, second=second, end=5.0)
    assert (early.closest_time, early.closest_time_noise, early.advice[0].code) == (5.0, None, "edge")


def test_tracks_on_the_globe_share_an_origin_and_touching_ones_are_upper_limits(tmp_path: Path) -> None:
    times = np.linspace(0.0, 10.0, 60)
    north = 1.0 / 111_200.0
    tracks = []
    for name, east in (("a", 0.0), ("b", 5.0)):
        degrees = np.column_stack([52.0 + 12.0 * times * north, 10.0 + 0.0 * times + east * north / 0.6157])
        path = tmp_path / f"{name}.csv"
        path.write_text(as_csv(times, degrees, "t[s],lat[deg],lon[deg]"), encoding="utf-8")
        tracks.append(Mover(track=str(path), sigma=0.01))
    assert relative(first=tracks[0], second=tracks[1], time=4.0).distance == pytest.approx(5.0, rel=0.01)
    same = relative(first=tracks[0], second=tracks[0])
    assert "within-noise" in [one.code for one in same.advice]
    assert same.closest_distance == 0.0


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"first": Mover(track="a", x=Formula("t", 1.0, "m"))}, "two of these are given"),
        ({"first": Mover(sigma=0.1)}, "without a track"),
        ({"second": Mover(track="late")}, "ends at 12 s, the other begins 1 s later, at 13 s"),
        ({"second": Mover(track="flat")}, "the first track has x, y, the second x"),
        ({"second": Mover(track="globe")}, "the second latitude, longitude"),
        ({"first": Mover(), "second": Mover(track="globe")}, "no place beside it"),
        ({"second": Mover(track="short")}, "the second track has 4 points"),
        ({"second": Mover(track="b"), "time": 1.0}, "from 2 s to 12 s does not hold 1 s"),
        ({"second": Mover(track="b"), "end": 1.5}, "ends at 1.5 s, not after its start at 2 s"),
    ],
)
def test_tracks_without_a_common_frame_are_refused(given: dict[str, Any], words: str, tmp_path: Path) -> None:
    times = np.linspace(0.0, 12.0, 20)
    files = {
        "a": as_csv(times, np.column_stack([times, times])),
        "b": as_csv(times + 2.0, np.column_stack([times, times])),
        "late": as_csv(times + 13.0, np.column_stack([times, times])),
        "flat": as_csv(times, times[:, None], "t[s],x[m]"),
        "globe": as_csv(times, np.column_stack([times, times]), "t[s],lat[deg],lon[deg]"),
        "short": as_csv(times[:4], np.column_stack([times, times])[:4]),
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text, encoding="utf-8")

    def placed(mover: Mover) -> Mover:
        values = {name: getattr(mover, name) for name in Mover.fields}  # type: ignore[attr-defined]
        return Mover(**(values | {"track": str(tmp_path / mover.track) if mover.track else ""}))

    movers = {"first": Mover(track="a"), "second": Mover()} | given
    movers = {name: placed(value) if isinstance(value, Mover) else value for name, value in movers.items()}
    with pytest.raises(DynamicsError, match=words):
        relative(**movers)


def test_dates_with_times_count_from_the_first(tmp_path: Path) -> None:
    """As GPS loggers write them; two tracks of one clock stay apart by what lies between their first rows."""
    rows = [f"{second},{0.5 * second * second}" for second in range(12)]
    for name, hour, head in (("a", "2024-05-01T23:59:5", "t,x[m]"), ("b", "", "t[s],x[m]")):
        times = (row.replace(f"{k},", f"{hour}{k}Z," if k < 10 else f"2024-05-02T00:00:0{k - 10}Z,", 1) if hour else row
                 for k, row in enumerate(rows))  # fmt: skip
        (tmp_path / f"{name}.csv").write_text("\n".join([head, *times]), encoding="utf-8")
    dated, plain = (read_track(str(tmp_path / f"{name}.csv")) for name in "ab")
    assert (dated.times, dated.places) == (plain.times, plain.places)
    later = (tmp_path / "a.csv").read_text(encoding="utf-8").split("\n")
    (tmp_path / "c.csv").write_text("\n".join(later[:1] + later[3:]), encoding="utf-8")
    a, b, c = (Mover(track=str(tmp_path / f"{name}.csv")) for name in "abc")
    assert relative(first=a, second=c).closest_distance == pytest.approx(0.0, abs=1e-9)
    with pytest.raises(DynamicsError, match="times of one track are dates"):
        relative(first=a, second=b)


def test_two_tracks_are_drawn_with_their_distance_and_closing_speed(tmp_path: Path) -> None:
    first, second = crossing(tmp_path, 2)
    seen = relative(first=first, second=second)
    paths, distance, closing = pictures.relative(seen, first=first, second=second).panels
    assert len([item for item in paths.items if isinstance(item, Curve)]) == 3
    assert min(distance.items[0].y) == pytest.approx(seen.closest_distance, abs=0.2)
    speed, lower, upper = closing.items
    assert all(low < middle < high for low, middle, high in zip(lower.y, speed.y, upper.y, strict=True))


@pytest.mark.parametrize("sigma", [SIGMA, None])
@pytest.mark.parametrize("count", [40, 500])
def test_a_track_run_backwards_is_the_same_track(count: int, sigma: float | None) -> None:
    """The smoothest functions, whose penalties are smallest, decide; both ways round they are the same."""
    times, places, _ = ring(count, SIGMA, 3)
    forwards = Smooth(times, places, sigma)
    backwards = Smooth(times[-1] - times[::-1], places[::-1], sigma)
    middle = np.linspace(0.0, times[-1], 29)
    for order, tolerance in ((0, 1e-9), (1, 1e-7), (2, 1e-5)):
        one, other = forwards.at(middle, order)[0], backwards.at(times[-1] - middle, order)[0] * (-1.0) ** order
        assert abs(one - other).max() < tolerance * abs(one).max()
