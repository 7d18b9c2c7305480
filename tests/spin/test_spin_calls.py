"""Calls of `dynamics spin`: refusals, pictures."""

import math
import shlex
from pathlib import Path

import pytest
from harness import answer, run

from dynamics_cli.spin import pictures
from dynamics_cli.spin.top import top as steady

TOP = 'top --mass "0.5 kg" --distance "60 mm" --axial "6e-4 kg*m^2" --transverse "2.5e-3 kg*m^2"'
REFUSED = {
    "flat rotor": (
        'gyro --axial "3 kg*m^2" --transverse "1 kg*m^2" --spin "9 rpm" --precession "1 rad/s"',
        "impossible-body",
    ),
    "one bearing": (
        'gyro --axial "1 kg*m^2" --transverse "1 kg*m^2" --spin "9 rpm" --precession "1 rad/s" --span "0 mm"',
        "span",
    ),
    "not at right angles": (
        'gyro --axial "1 kg*m^2" --spin "9 rpm" --precession "1 rad/s" --angle "80 deg" --span "1 m"',
        "missing",
    ),
    "triangle": ('free --moments "1, 2, 3.5 kg*m^2" --angular-velocity "0, 1, 1 rad/s"', "impossible-body"),
    "no body": ('free --moments "0, 2, 2 kg*m^2" --angular-velocity "0, 1, 1 rad/s"', "impossible-body"),
    "still": ('free --moments "1, 2, 2 kg*m^2" --angular-velocity "0, 0, 0 rad/s"', "at-rest"),
    "falling": (f'{TOP} --spin "50 rpm" --tilt "30 deg"', "falls"),
    "not spinning": (f'{TOP} --spin "0 rpm"', "falls"),
    "upright": (f'{TOP} --spin "900 rpm" --tilt "0 deg"', "upright"),
    "in line": ('shaft --mass "1 kg" --speed "9 rpm" --span "1 m" --position "1 m"', "in-line"),
    "no moments": ('shaft --mass "1 kg" --speed "9 rpm" --span "1 m" --position "1 m" --skew "2 deg"', "missing"),
    "half a turn": ('disk --radius "1 m" --lean "20 deg"', "missing"),
    "flat": ('disk --radius "1 m" --lean "90 deg" --turn "1 rad/s"', "lean"),
    "no turn": ('disk --radius "1 m" --lean "20 deg" --turn "0 rad/s"', "turn"),
    "no rod": ('rod --length "0 m" --speed "9 rpm"', "inadmissible"),
    "thin": (
        'top --mass "0.5 kg" --distance "60 mm" --axial "6e-4 kg*m^2" --transverse "1.8e-3 kg*m^2" --spin "9 rpm"',
        "impossible-body",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str) -> None:
    call, code = REFUSED[name]
    out = run(*shlex.split("spin " + call), "--json")
    assert out.status in (2, 3)
    assert out.error["code"] == code


def test_the_refusal_names_the_least_spin() -> None:
    assert "803.4 rpm" in run(*shlex.split(f'spin {TOP} --spin "50 rpm" --tilt "30 deg"')).err


@pytest.mark.parametrize("rates", ["0.2, 1, 0.5", "1, 0.1, 0.2", "0, 1, 0", "0, 0, 1"])
def test_pictures(rates: str, tmp_path: Path) -> None:
    target = tmp_path / "picture.svg"
    call = f'spin free --moments "1, 2, 3 kg*m^2" --angular-velocity "{rates} rad/s"'
    assert run(*shlex.split(call), "--plot", str(target)).status == 0
    assert target.stat().st_size > 5000


@pytest.mark.parametrize(
    "call",
    [
        f'{TOP} --spin "200 rad/s" --tilt "30 deg"',
        f'{TOP} --spin "-3000 rpm" --tilt "150 deg"',
        f'{TOP} --spin "3000 rpm" --tilt "90 deg"',
        f'{TOP} --spin "100 rpm"',
        'gyro --axial "0.03 kg*m^2" --transverse "0.02 kg*m^2" --spin "-9 rpm" --precession "-2 rad/s" --angle "2 rad"',
        'gyro --axial "0.03 kg*m^2" --transverse "0.02 kg*m^2" --spin "0 rpm" --precession "0 rad/s"',
        'disk --radius "1 m"',
        'disk --radius "1 m" --wheel hoop --roll "9 rad/s" --lean "70 deg" --turn "-2 rad/s"',
    ],
)
def test_pictures_of_tops_gyroscopes_and_disks(call: str, tmp_path: Path) -> None:
    target = tmp_path / "picture.svg"
    outcome = run("spin", *shlex.split(call), "--plot", str(target))
    assert outcome.status == 0, outcome.err
    assert b"nan" not in target.read_bytes()


@pytest.mark.parametrize("spin", [120.0, 200.0, -600.0])
@pytest.mark.parametrize("tilt", [0.5, 1.6, 2.5])
def test_the_path_that_is_drawn_dips_to_the_tilt_answered(spin: float, tilt: float) -> None:
    top = steady(mass=0.5, distance=0.06, axial=6e-4, transverse=2.5e-3, spin=spin, tilt=tilt)
    assert top.nutation is not None
    assert top.slow is not None
    pull = 0.5 * 9.80665 * 0.06
    path = pictures.let_go(2.5e-3, 6e-4 * spin, pull, tilt, top.nutation, top.slow)
    assert max(angle for angle, _ in path) == pytest.approx(top.lowest_tilt, abs=2e-4)
    assert min(angle for angle, _ in path) == pytest.approx(tilt, abs=1e-6)


def test_at_right_angles_the_moment_across_does_not_count(tmp_path: Path) -> None:
    typed = shlex.split('spin gyro --axial "60 t*m^2" --spin "120 rpm" --precession "2 deg/s" --only torque')
    assert run(*typed).out == run(*typed, "--transverse", "40 t*m^2").out == "26318.9 N·m\n"
    assert run(*typed, "--plot", str(tmp_path / "gyro.svg")).status == 0


def test_a_tensor_turns_like_its_principal_moments() -> None:
    turned = '"2, -0.5, 0; -0.5, 2, 0; 0, 0, 3 kg*m^2"'
    half = 0.5**0.5
    along = f"{1.2 * half!r}, {-0.8 * half!r}, 0.5"
    tensor = answer(*shlex.split(f'spin free --tensor {turned} --angular-velocity "0.2, 1, 0.5 rad/s"'))["results"]
    moments = answer(*shlex.split(f'spin free --moments "1.5, 2.5, 3 kg*m^2" --angular-velocity "{along} rad/s"'))
    for name in ("period", "energy", "greatest_nutation", "least_precession"):
        assert tensor[name]["value"] == pytest.approx(moments["results"][name]["value"], rel=1e-13)
    assert tensor["axes"][2]["value"] == [0.0, 0.0, -1.0]


def test_a_tensor_counts_in_the_sensitivities() -> None:
    call = 'spin free --tensor "2, -0.5, 0.1; -0.5, {}, 0; 0.1, 0, 3 kg*m^2" --angular-velocity "0.2, 1, 0.5 rad/s"'
    step = 1e-6
    document = answer(*shlex.split(call.format(2.0)))
    low, high = (
        answer(*shlex.split(call.format(repr(2.0 * (1.0 + part)))))["results"]["period"]["value"]
        for part in (-step, step)
    )
    expected = abs(high - low) / (2.0 * step * document["results"]["period"]["value"])
    condition = document["numerics"]["condition"]["period"]
    assert abs(condition["tensor[1][1]"]) == pytest.approx(expected, rel=1e-6)


def test_a_rotor_by_mass_and_radius() -> None:
    turns = '--spin "10000 rpm" --precession "2 rad/s"'
    for rotor, moment in (('--radius "100 mm"', 0.025), ('--gyration "90 mm"', 0.0405)):
        results = answer(*shlex.split(f'spin gyro --mass "5 kg" {rotor} {turns}'))["results"]
        assert results["torque"]["value"] == pytest.approx(moment * 2.0 * 10000.0 * math.pi / 30.0, rel=1e-14)
