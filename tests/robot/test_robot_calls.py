"""Calls of `dynamics robot`: refusals, notes, documents that go on, pictures."""

import shlex
from pathlib import Path

import pytest
from harness import run

PUMA = "--robot puma-560"
AT = f'inverse {PUMA} --position "450, 100, 900 mm" --euler-angles "0, 90, 0 deg" --euler-order XYZ'
STANFORD = (
    '--convention standard --joint "d=400 mm, alpha=-90 deg" --joint "d=150 mm, alpha=90 deg" '
    '--joint "type=prismatic" --joint "alpha=-90 deg" --joint "alpha=90 deg" --joint "d=100 mm"'
)
REFUSED = {
    "no arm": ('pose --angles "30 deg"', "no-arm"),
    "two arms": (f'pose {PUMA} --lengths "1 m" --angles "30 deg"', "two-arms"),
    "unknown arm": ('pose --robot irb-120 --angles "30 deg"', "unknown-arm"),
    "no convention": ('pose --joint "a=1 m" --angles "30 deg"', "convention"),
    "too few angles": (f'pose {PUMA} --angles "30, 20 deg"', "joint-count"),
    "slides of none": ('pose --lengths "1 m" --angles "30 deg" --slides "2 mm"', "joint-count"),
    "limits upside down": (
        'pose --convention standard --joint "a=1 m, lower=90 deg, upper=-90 deg" --angles "0 deg"', "limit",
    ),
    "limits of a slide": ('pose --convention standard --joint "type=prismatic, lower=1 deg" --slides "0 mm"', "limit"),
    "out of reach": ('inverse --lengths "500, 400 mm" --position "700, 600 mm"', "out-of-reach"),
    "too near": ('inverse --lengths "500, 400 mm" --position "50, 60 mm"', "out-of-reach"),
    "out of the plane": ('inverse --lengths "500, 400 mm" --position "500, 60, 10 mm"', "out-of-reach"),
    "too near the first axis": (
        f'inverse {PUMA} --position "100, 100, 900 mm" --euler-angles "0, 90, 0 deg" --euler-order XYZ', "out-of-reach",
    ),
    "no orientation": (f'inverse {PUMA} --position "450, 100, 900 mm"', "no-orientation"),
    "orientation of no wrist": (
        'inverse --lengths "500, 400 mm" --position "500, 60 mm" --hand-angle "1 rad"', "no-wrist",
    ),
    "a hand angle in space": (f'inverse {PUMA} --position "450, 100, 900 mm" --hand-angle "1 rad"', "hand-angle"),
    "tilted out of the plane": (
        'inverse --lengths "500, 400, 100 mm" --position "500, 60 mm" --rotation-axis "1, 0, 0" '
        '--rotation-angle "9 deg"',
        "out-of-reach",
    ),
    "no rotation": (
        f'inverse {PUMA} --position "450, 100, 900 mm" --rotation-matrix "(1, 0, 0), (0, 1, 0), (0, 0.01, 1)"',
        "rotation",
    ),
    "no closed form": (f'inverse {STANFORD} --position "400, 100, 500 mm" --quaternion "1, 0, 0, 0"', "no-closed-form"),
    "no velocity": ('rates --lengths "500, 400 mm" --angles "30, 45 deg"', "no-velocity"),
    "straight": ('rates --lengths "500, 400 mm" --angles "30, 0 deg" --velocity "1, 0, 0 m/s"', "singular"),
    "out of the level": ('rates --lengths "500, 400 mm" --angles "30, 9 deg" --velocity "1, 0, 1 m/s"', "out-of-plane"),
    "too few joints": (
        'rates --lengths "500, 400 mm" --angles "30, 45 deg" --velocity "1, 0, 0 m/s" '
        '--angular-velocity "0, 0, 0 rad/s"',
        "too-few-joints",
    ),
    "one weight of two": (
        'rates --lengths "500, 400 mm" --angles "30, 45 deg" --velocity "1, 0, 0 m/s" --weights 2', "joint-count",
    ),
    "no masses": ('torque --lengths "500, 400 mm" --angles "30, 45 deg"', "no-masses"),
    "one mass of two": ('torque --lengths "500, 400 mm" --masses "3 kg" --angles "30, 45 deg"', "masses"),
    "no way up": ('torque --lengths "50 mm" --masses "2 kg" --angles "30 deg" --up "0, 0, 0"', "direction"),
    "a link of no length": ('inverse --lengths "500, 0 mm" --position "500, 0 mm"', "no-closed-form"),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str) -> None:
    call, code = REFUSED[name]
    out = run(*shlex.split("robot " + call), "--json")
    assert out.status in (2, 3), out.out
    assert out.error["code"] == code
    assert "nan" not in out.error["message"]


def test_a_refusal_gives_the_gap_and_what_stands_against_a_closed_form() -> None:
    assert "21.95 mm beyond the reach" in run(*shlex.split("robot " + REFUSED["out of reach"][0])).err
    assert "1 prismatic joint" in run(*shlex.split("robot " + REFUSED["no closed form"][0])).err


def test_the_nearest_posture_within_limits_comes_first() -> None:
    answer = run(*shlex.split(f'robot {AT} --near "30, 80, -200, 60, 40, -50 deg"'), "--json").document
    first = answer["results"]["solutions"][0]
    assert first["configuration"] == "front up"
    assert first["within"] == "yes"
    assert "flip" in run(*shlex.split(f'robot {AT} --near "30, -27, 23, -30, -86, 2 deg"')).out.splitlines()[8]


def test_no_posture_within_limits_is_a_serious_warning() -> None:
    arm = '--convention standard --joint "a=500 mm, lower=-10 deg, upper=10 deg" --joint "a=400 mm"'
    out = run(*shlex.split(f'robot inverse {arm} --position "0, 500 mm"'))
    assert out.status == 0
    assert "no posture is within the limits" in out.out + out.err


def test_a_pose_goes_on_to_the_inverse_and_its_posture_back(tmp_path: Path) -> None:
    pose, inverse = tmp_path / "pose.json", tmp_path / "inverse.json"
    typed = shlex.split(f'robot pose {PUMA} --angles "0.3, 0.4, -0.5, 0.7, 1.1, -0.2 rad"')
    assert run(*typed, "-o", str(pose)).status == 0
    assert run("robot", "inverse", "--robot", "puma", "--input", str(pose), "-o", str(inverse)).status == 0
    back = run("robot", "pose", "--robot", "puma", "--input", str(inverse), "--only", "position")
    assert back.out == run(*typed, "--only", "position").out


def test_a_sideways_force_on_a_planar_arm() -> None:
    out = run(*shlex.split('robot jacobian --lengths "3, 4 ft" --angles "0, 90 deg" --force "0, 10, 0 lbf" --units us'))
    assert "[30, 0] lbf·ft" in next(line for line in out.out.splitlines() if line.startswith("joint torques"))


def test_a_slide_lifts_with_the_force_itself() -> None:
    typed = shlex.split(
        'robot jacobian examples/scara.toml --angles "30, 60, 0 deg" --slides "80 mm" --force "0, 0, -9 N"'
    )
    results = run(*typed, "--json").document["results"]
    # the quill points down
    assert results["slide_forces"]["value"] == [9]
    assert results["determinant"]["unit"] == "m²"


@pytest.mark.parametrize(
    ("call", "verdict"),
    [
        (f'{PUMA} --angles "20, 40, -30, 0, 0, 0 deg"', "singular: the outer axes of the wrist are in line"),
        (f'{PUMA} --angles "20, 40, -30, 0, 0.1, 0 deg"', "nearly singular: the outer axes of the wrist are in line"),
        ('--lengths "500, 400 mm" --angles "30, 180 deg"', "singular: the elbow is straight or folded"),
        ('--lengths "500, 400, 300 mm" --angles "30, 20, 10 deg"', "regular"),
    ],
)
@pytest.mark.parametrize("unit", ["m", "in"])
def test_a_verdict_has_no_unit(call: str, verdict: str, unit: str) -> None:
    results = run("robot", "jacobian", *shlex.split(call), "--to", f"position={unit}", "--json").document["results"]
    assert results["verdict"] == verdict


def test_uncertain_lengths_and_angles() -> None:
    out = run(*shlex.split('robot pose --lengths "500 ± 1, 400 ± 1 mm" --angles "30 ± 0.1, 45 ± 0.1 deg"'))
    assert out.status == 0, out.err
    assert "95 %" in out.out


def test_an_uncertain_payload() -> None:
    arm = '--lengths "500, 400 mm" --masses "6, 4 kg" --angles "30, 45 deg" --up "0, 1, 0"'
    call = f'robot torque {arm} --payload "2 ± 0.1 kg"'
    out = run(*shlex.split(call), "--json").document["results"]["largest_torque"]
    # g·(l₁ cos 30° + l₂ cos 75°) of the standard uncertainty
    assert out["std"] == pytest.approx(0.1 * 9.80665 * (0.5 * 0.8660254 + 0.4 * 0.2588190), rel=1e-3)


def test_a_lifting_slide_carries_its_load() -> None:
    call = 'robot torque examples/scara.toml --angles "30, 60, 0 deg" --slides "80 mm" --payload "3 kg"'
    out = run(*shlex.split(call), "--json").document["results"]
    # the quill points down: its joint pulls up
    assert out["slide_forces"]["value"] == pytest.approx([-3 * 9.80665])
    assert out["torques"]["value"] == pytest.approx([0, 0, 0], abs=1e-12)


def test_rows_of_poses() -> None:
    rows = b'{"angles": ["0 deg", "90 deg"]}\n{"angles": ["30 deg", "0 deg"]}\n'
    out = run("robot", "pose", "--lengths", "500, 400 mm", "--rows", "-", stdin=rows)
    assert out.status == 0, out.err
    assert len(out.out.splitlines()) == 2


@pytest.mark.parametrize(
    "call",
    [
        f'pose {PUMA} --angles "20, 40, -30, 0, 60, 0 deg"',
        f"pose {STANFORD} --angles '20, 30, 0, 60, 0 deg' --slides '300 mm'",
        'pose examples/scara.toml --angles "30, 60, 0 deg" --slides "80 mm"',
        AT,
        'inverse --lengths "500, 400 mm" --position "900, 0 mm"',
        f'jacobian {PUMA} --angles "20, 40, -30, 0, 0, 0 deg" --axes hand',
        'jacobian examples/scara.toml --angles "30, 60, 0 deg" --slides "80 mm"',
        'jacobian --lengths "500, 400 mm" --angles "30, 0 deg"',
        f'rates {PUMA} --angles "20, 40, -30, 0, 60, 0 deg" --velocity "0.1, 0, 0 m/s"',
        'rates examples/scara.toml --angles "30, 60, 0 deg" --slides "80 mm" --velocity "0.1, 0, -0.1 m/s"',
        f'torque {PUMA} --angles "20, 40, -30, 0, 60, 0 deg" --payload "2 kg"',
        'torque examples/scara.toml --angles "30, 60, 0 deg" --slides "80 mm" --payload "2 kg"',
    ],
)
def test_pictures(call: str, tmp_path: Path) -> None:
    target = tmp_path / "picture.svg"
    outcome = run("robot", *shlex.split(call), "--plot", str(target))
    assert outcome.status == 0, outcome.err
    assert b"nan" not in target.read_bytes()


def test_a_target_on_the_first_axis_leaves_its_joint_open() -> None:
    out = run(*shlex.split('robot inverse --lengths "500, 500 mm" --position "0, 0 mm"'))
    assert "every angle of that" in out.out + out.err


def test_four_parallel_axes_are_called_parallel() -> None:
    out = run(*shlex.split('robot inverse --lengths "1, 1, 1, 1 m" --position "1, 1 m" --hand-angle 10deg'))
    assert out.status == 3
    assert "4 joints turn about parallel axes" in out.err


def test_speeds_near_a_singular_posture_are_remarked() -> None:
    call = 'robot rates --lengths "500, 400 mm" --velocity "0.1, 0, 0 m/s" --angles'
    assert "nearly singular" in run(*shlex.split(call), "30, 0.001 deg").out
    assert "nearly" not in run(*shlex.split(call), "30, 45 deg").out


def test_uncertain_lengths_are_not_called_irrelevant() -> None:
    out = run(*shlex.split('robot inverse --lengths "500 ± 1, 400 mm" --position "550, 350 mm"')).out
    assert "none of the results" not in out
    assert "hold at the means" in out
