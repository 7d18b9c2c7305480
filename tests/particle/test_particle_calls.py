"""Calls of `dynamics particle`: refusals, models, uncertainty, pictures."""

import shlex
from pathlib import Path

import pytest
from harness import answer, run

REFUSED = {
    "short": ('projectile --speed "20 m/s" --target "80, 5 m"', "out-of-reach"),
    "short with drag": ('projectile --speed "30 m/s" --target "80, 5 m" --terminal-speed "25 m/s"', "out-of-reach"),
    "too low": ('projectile --speed "5 m/s" --elevation "45 deg" --height "-2 m"', "out-of-reach"),
    "level": ('projectile --speed "5 m/s" --elevation "0 deg"', "no-flight"),
    "backwards": ('projectile --speed "5 m/s" --elevation "95 deg"', "elevation"),
    "straight up": ('projectile --elevation "90 deg" --target "80, 5 m"', "elevation"),
    "behind": ('projectile --speed "50 m/s" --target "-3, 5 m"', "target"),
    "two drags": (
        'projectile --speed "5 m/s" --elevation "45 deg" --time-constant "3 s" --terminal-speed "9 m/s"',
        "exclusive",
    ),
    "idle wind": ('projectile --speed "5 m/s" --elevation "45 deg" --wind "3 m/s"', "wind"),
    "target and height": ('projectile --speed "50 m/s" --target "3, 5 m" --height "1 m"', "exclusive"),
    "standing": ('projectile --speed "0 m/s" --elevation "45 deg"', "inadmissible"),
    "no height": ('fall --height "0 m"', "inadmissible"),
    "pole": ('fall --height "1 m" --latitude "91 deg"', "latitude"),
    "still tube": ('tube --rotation "0 rpm" --start "1 m" --time "1 s"', "at-rest"),
    "spring": (
        'tube --rotation "9 rpm" --start "1 m" --time "1 s" --spring-stiffness "1 N/m" --spring-free-length "1 m"',
        "missing",
    ),
    "beyond the pole": ('rotating-frame --latitude "91 deg" --velocity "1, 0, 0 m/s"', "latitude"),
    "two frames": ('rotating-frame --latitude "9 deg" --angular-velocity "0, 0, 1 rad/s"', "exclusive"),
    "no mass": ('rotating-frame --latitude "9 deg" --velocity "1, 0, 0 m/s" --mass "0 kg"', "inadmissible"),
    "upright": ('incline --mass "1 kg" --angle "90 deg" --friction 0.3', "angle"),
    "lifted": ('incline --mass "1 kg" --angle "9 deg" --friction 0.3 --force "50 N" --force-angle "60 deg"', "lifts"),
    "friction": ('incline --mass "1 kg" --angle "9 deg" --friction 0.3 --kinetic 0.4', "friction"),
    "outside": ('circle --radius "9 m" --friction 0.1 --bank "-9 deg"', "slides"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str) -> None:
    call, code = REFUSED[name]
    out = run(*shlex.split("particle " + call), "--json")
    assert out.status in (2, 3)
    assert out.error["code"] == code


def test_the_refusal_names_the_least_speed() -> None:
    out = run(*shlex.split('particle projectile --speed "20 m/s" --target "80, 5 m"'))
    assert "28.9 m/s" in out.err


@pytest.mark.parametrize(
    ("more", "model"),
    [("", "parabola"), ('--time-constant "3 s"', "linear drag"), ('--terminal-speed "25 m/s"', "quadratic drag")],
)
def test_the_smallest_model_that_suffices(more: str, model: str) -> None:
    made = answer(*shlex.split(f'particle projectile --speed "30 m/s" --elevation "45 deg" {more}'))
    assert made["model"]["name"] == model


def test_uncertain_drag() -> None:
    call = 'particle projectile --speed "30 ± 1 m/s" --elevation "45 deg" --terminal-speed "20..30 m/s"'
    made = answer(*shlex.split(call))
    assert 3.0 < made["results"]["range"]["std"] < 6.0


@pytest.mark.parametrize(
    "call",
    [
        'projectile --speed "30 m/s" --elevation "45 deg" --height "2 m"',
        'projectile --speed "30 m/s" --target "80, 5 m"',
        'projectile --speed "30 m/s" --elevation "45 deg" --terminal-speed "25 m/s" --wind "-5 m/s"',
    ],
)
def test_pictures(call: str, tmp_path: Path) -> None:
    target = tmp_path / "picture.svg"
    assert run(*shlex.split("particle " + call), "--plot", str(target)).status == 0
    assert target.stat().st_size > 5000


@pytest.mark.parametrize("drag", ["", '--terminal-speed "40 m/s"', '--time-constant "3 s" --wind "-4 m/s"'])
def test_the_speed_for_an_angle_and_a_target_passes_the_target(drag: str) -> None:
    found = answer(*shlex.split(f'particle projectile --elevation "40 deg" --target "80, 5 m" {drag}'))["results"]
    speed = found["launch_speed"]["value"]
    back = answer(*shlex.split(f'particle projectile --speed "{speed!r} m/s" --target "80, 5 m" {drag}'))["results"]
    angles = [back[name]["value"] for name in ("elevation", "other_elevation")]
    assert min(abs(angle - 40.0) for angle in angles) < 1e-7
    if not drag:
        assert speed == pytest.approx(29.33849129739612, rel=1e-13)


def test_rows_of_a_particle_at_rest_on_earth_have_no_circle() -> None:
    speeds = [5, *[0, 5] * 160, 5]
    rows = "latitude[deg],velocity[0][m/s],velocity[1][m/s],velocity[2][m/s]\n" + "".join(
        f"52,{v},0,0\n" for v in speeds
    )
    out = run("particle", "rotating-frame", "--only", "inertial_radius", "--rows", "-", stdin=rows).out
    assert [bool(line.split(",")[4]) for line in out.splitlines()[1:]] == [bool(v) for v in speeds]
