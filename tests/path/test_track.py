"""Measured tracks: what is read, what the smoothing leaves of known motions, and whether the noise stated is true."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from harness import answer, run

from dynamics_cli.errors import DynamicsError
from dynamics_cli.numerics.fitting.smoothing import Smooth
from dynamics_cli.path.tracks.file import read_track, third_differences
from dynamics_cli.path.tracks.task import Smoothing, table

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
    assert all(check.passed for check in made.checks)
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
    assert track.globe


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
