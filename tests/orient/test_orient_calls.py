"""Orient on the command line: refusals with the number that decides, advice, rows, results that others take."""

import csv
import io
import json
import shlex
import sys
from pathlib import Path

import pytest
from harness import answer, run

CONVERT = "orient convert "
# A call, its exit status, and words of its message or hint.
REFUSED = [
    (CONVERT + '--rotation-matrix "[[1, 0, 0], [0, 1, 0], [0, 0, -1]]"', 3, "reflection: its determinant is -1"),
    (CONVERT + '--rotation-matrix "[[2, 0, 0], [0, 2, 0], [0, 0, 2]]"', 3, "divide it by 2"),
    (CONVERT + '--rotation-matrix "1, 0, 0;; 0, 1, 0"', 2, "has an empty row"),
    (CONVERT + '--rotation-matrix "[[1, 0.3, 0], [0, 1, 0], [0, 0, 1]]"', 3, "right angles by 0.3"),
    (CONVERT + '--rotation-matrix "[[0, 0, 0], [0, 0, 0], [0, 0, 0]]"', 3, "not a rotation"),
    (CONVERT + '--rotation-matrix "[[1, 0, 0], [0, 1, 0]]"', 3, "read 2 rows of a rotation matrix, wanted 3"),
    (CONVERT + '--rotation-matrix "[[1, 0], [0, 1], [0, 0]]"', 2, "read 2 components, wanted 3"),
    (CONVERT + '--quaternion "0, 0, 0, 0"', 3, "the quaternion has no length"),
    (CONVERT + "--qw 1 --qx 0", 2, "--qy is missing"),
    ("orient average --reading 'yaw=1 deg'", 3, "one orientation has no mean"),
    ("orient average --reading 'quaternion=(1, 0, 0, 0)' --reading 'quaternion=(0, 1, 0, 0)'", 3, "have no mean"),
    ("orient compose --simple-turn 'axis=x, angle=1 deg' --general-turn 'yaw=1 deg'", 3, "order of simple and general"),
    (CONVERT + '--quaternion "1, 0, 0"', 2, "read 3 components, wanted 4"),
    (CONVERT + '--rotation-axis "0, 0, 0" --rotation-angle "30 deg"', 3, "the rotation axis has no length"),
    (CONVERT + '--rotation-axis "0, 0, 1" --rotation-angle 30', 2, "has no unit"),
    (CONVERT + '--euler-angles "1, 2, 3 deg" --euler-order xyy', 3, "the sequence 'xyy' is unknown"),
    (CONVERT + '--euler-angles "1, 2, 3 deg" --euler-order zYx', 3, "the sequence 'zYx' is unknown"),
    (CONVERT + '--euler-angles "1, 2 deg" --euler-order zyx', 3, "read 2 Euler angles, wanted 3"),
    (CONVERT + '--quaternion "1, 0, 0, 0" --sequence abc', 3, "no axis twice in a row"),
    (CONVERT + '--quaternion "1, 0, 0, 0" --sequence ""', 3, "is unknown"),
    (CONVERT + '--from-direction "1, 0, 0" --to-direction "-2, 0, 0"', 3, "are opposite"),
    (CONVERT + '--from-direction "0, 0, 0" --to-direction "-2, 0, 0"', 3, "zero vector"),
    (CONVERT + '--quaternion "1, 0, 0, 0" --rotation-vector "0, 0, 1 rad"', 2, "cannot be given together"),
    ('orient compose --simple-turn "axis=w, angle=3 deg"', 2, "wanted one of x, y, z"),
    (
        'orient rates --euler-angles "30, 90, 10 deg" --angular-velocity "1, 0, 0 rad/s"', 3,
        "about the direction (-0.866, -0.5, 0)",
    ),
    ('orient points --body-point "position=(1, 0, 0 m), velocity=(0, 1, 0 m/s)"', 3, "the velocities given (1) do not"),
    (
        'orient points --body-point "position=(1, 0, 0 m), velocity=(0, 1, 0 m/s)" --body-point "position=(2, 0, 0 m), '
        'velocity=(0, 2, 0 m/s)" --body-point "position=(3, 0, 0 m), velocity=(0, 3, 0 m/s)"', 3, "on one line",
    ),
    ('orient bearing --cone-angle "45 deg" --ball-radius "12 mm"', 3, "half-angle 45 deg has no circle"),
    ('orient disk --radius "1 m" --tilt "0 deg" --spin-rate "1 rad/s"', 3, "lies flat"),
    ('orient disk --radius "0 m" --tilt "90 deg" --spin-rate "1 rad/s"', 3, "radius 0"),
    ('orient joint --joint-angle "90 deg"', 3, "angle of 90 deg does not turn"),
    ('orient align --pair "before=(1, 0, 0), after=(0, 1, 0)"', 3, "one pair"),
    (
        'orient align --pair "before=(1, 0, 0), after=(0, 1, 0)" --pair "before=(2, 0, 0), after=(0, 1, 0)"', 3,
        "any turn about (1, 0, 0) fits as well",
    ),
    ('orient screw --rotation-vector "0, 0, 0 rad" --displacement "0, 0, 0 m"', 3, "nothing moves"),
    ('orient rolling --contact "1, 0, 0 m" --normal "0, 0, 0" --first-axis "0, 0, 1"', 3, "normal is the zero vector"),
    ('orient rolling --contact "1, 0, 0 m" --normal "0, 0, 1" --first-axis "1, 0, 0"', 3, "passes through the contact"),
]  # fmt: skip
# A call, and the code of its advice.
ADVISED = [
    (CONVERT + '--rotation-matrix "[[0, 0, 1], [0, 1, 0], [-1, 0, 0]]"', "lock"),
    (CONVERT + '--euler-angles "30, 89.9, 10 deg" --euler-order zyx', "near-lock"),
    (CONVERT + '--rotation-matrix "[[0.87, -0.5, 0], [0.5, 0.87, 0], [0, 0, 1]]"', None),
    (CONVERT + '--rotation-matrix "[[0.866, -0.5, 0], [0.5, 0.866, 0], [0, 0, 1]]"', "repaired"),
    (CONVERT + '--quaternion "0, 0, 2, 0"', "half-turn"),
    (CONVERT + '--quaternion "3, 0, 0, 0"', "no-turn"),
    ('orient rolling --contact "1, 0, 0 m" --normal "0, 0, 1" --first-axis "0, 1, 0" --first-point "1, 0, 1 m" '
     '--first-velocity "1, 1, 0 m/s"', "slips"),
    ('orient bearing --cone-angle "25 deg" --ball-radius "12 mm" --centre-radius "40 mm"', "spin"),
    ('orient joint --joint-angle "60 deg"', "steep-joint"),
    ('orient screw --rotation-vector "0, 0, 0 rad" --displacement "0, 0, 1 m"', "translation"),
    ('orient align --pair "before=(1, 0, 0), after=(0, 1, 0)" '
     '--pair "before=(1, 0.001, 0), after=(0, 1, 0.001)"', "weak"),
]  # fmt: skip


@pytest.mark.parametrize(("call", "status", "words"), REFUSED, ids=[call[7:60] for call, _, _ in REFUSED])
def test_a_wrong_call_is_refused_with_what_decides(call: str, status: int, words: str) -> None:
    outcome = run(*shlex.split(call))
    assert outcome.status == status, (outcome.out, outcome.err)
    assert words in outcome.err
    assert outcome.out == ""


@pytest.mark.parametrize(("call", "code"), ADVISED, ids=[call[7:60] for call, _ in ADVISED])
def test_what_a_user_should_know_is_said(call: str, code: str | None) -> None:
    if code is None:
        assert run(*shlex.split(call)).status == 3
        return
    assert code in [warning["code"] for warning in answer(*shlex.split(call))["warnings"]]


@pytest.mark.parametrize(
    ("name", "order"),
    [
        ("yaw-pitch-roll", "zyx"),
        ("rpy", "XYZ"),
        ("3-1-3", "zxz"),
        ("fixed xyz", "XYZ"),
        ("Body ZYX", "zyx"),
        ("313", "zxz"),
    ],
)
def test_sequences_have_the_names_that_people_use(name: str, order: str) -> None:
    results = answer("orient", "convert", "--quaternion", "1, 2, 3, 4", "--sequence", name)["results"]
    assert results["euler_order"] == order


def test_turns_that_come_out_go_into_inertia(tmp_path: Path) -> None:
    file = tmp_path / "turn.json"
    file.write_text(json.dumps(answer(*shlex.split(CONVERT + '--euler-angles "30, 20, -40 deg" --euler-order zyx'))))
    body = ("inertia", "tensor", "--moments", "1, 2, 2.5 kg*m^2")
    tensors = [
        answer(*body, *given)["results"]["tensor"]["value"]
        for given in (
            ("--quaternion", f"@{file}:quaternion"),
            ("--rotation-matrix", f"@{file}:rotation_matrix"),
            ("--euler-angles", f"@{file}:euler_angles", "--euler-order", "zyx"),
            ("--rotation-axis", f"@{file}:rotation_axis", "--rotation-angle", f"@{file}:rotation_angle"),
        )
    ]
    wanted = answer(*body, "--euler-angles", "30, 20, -40 deg", "--euler-order", "zyx")["results"]["tensor"]["value"]
    for tensor in tensors:
        for row, other in zip(tensor, wanted, strict=True):
            assert row == pytest.approx(other, abs=1e-15)


LOG = "t[s],quaternion[0],quaternion[1],quaternion[2],quaternion[3]\n" + "".join(
    f"{k / 100},{1.0 + 0.01 * k},{0.3 - 0.002 * k},{-0.2 + 0.01 * k},{0.1 * (k % 7)}\n" for k in range(40)
)


@pytest.mark.parametrize("sequence", ["zyx", "zxz", "rpy"])
def test_rows_are_single_answers_to_the_bit(sequence: str) -> None:
    # enough rows for the way of arrays
    text = LOG + "".join(LOG.splitlines(keepends=True)[1:] * 40)
    outcome = run("orient", "convert", "--rows", "-", "--sequence", sequence, stdin=text)
    assert outcome.status == 0, outcome.err
    rows = list(csv.reader(io.StringIO(outcome.out)))
    assert len(rows) == 1 + 41 * 40
    for row in (1, 17, 40, 900):
        given = ", ".join(rows[row][1:5])
        results = answer("orient", "convert", "--quaternion", given, "--sequence", sequence)["results"]
        head = rows[0]
        got = [float(rows[row][head.index(f"euler_angles[{k}][deg]")]) for k in range(3)]
        assert got == results["euler_angles"]["value"]
        assert float(rows[row][head.index("rotation_matrix[1][2]")]) == results["rotation_matrix"]["value"][1][2]


def test_rows_of_matrices_with_a_bad_one() -> None:
    head = ",".join(f"rotation_matrix[{i}][{j}]" for i in range(3) for j in range(3))
    good, mirror = "0,-1,0,1,0,0,0,0,1", "0,1,0,1,0,0,0,0,1"
    outcome = run(
        "orient", "convert", "--rows", "-", stdin="\n".join([head, *[good] * 30, mirror, *[good] * 30]) + "\n"
    )
    assert outcome.status == 4
    rows = list(csv.DictReader(io.StringIO(outcome.out)))
    assert [bool(row["error"]) for row in rows] == [k == 30 for k in range(61)]
    assert "reflection" in rows[30]["error"]
    assert {row["euler_angles[0][deg]"] for k, row in enumerate(rows) if k != 30} == {"90.0"}


def test_an_uncertain_angle_spreads_into_the_others() -> None:
    results = answer(*shlex.split(CONVERT + '--euler-angles "30 ± 1, 20, -40 deg" --euler-order zyx --sequence xyz'))
    angle = results["results"]["rotation_angle"]
    assert angle["std"] == pytest.approx(0.45, abs=0.2)


def test_a_scalar_call_loads_no_numpy() -> None:
    import subprocess

    code = (
        "import sys; sys.argv = ['dynamics', 'orient', 'convert', '--quaternion', '1, 0.2, 0.1, 0'];"
        "from dynamics_cli.cli import main; main(); print(sorted({'numpy', 'scipy', 'typer'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "[]"


def test_no_column_of_rows_has_the_name_of_another() -> None:
    rows = "quaternion[0],quaternion[1],quaternion[2],quaternion[3]\n1,0,0,0.5\n"
    head = run("orient", "convert", "--rows", "-", stdin=rows).out.splitlines()[0].split(",")
    assert len(set(head)) == len(head)
    assert "results.quaternion[0]" in head


def test_yaw_pitch_and_roll_are_the_angles_zyx() -> None:
    named = answer("orient", "convert", "--yaw", "30 deg", "--pitch", "20 deg", "--roll", "-40 deg")["results"]
    listed = answer("orient", "convert", "--euler-angles", "30, 20, -40 deg", "--euler-order", "zyx")["results"]
    assert named == listed


def test_the_point_whose_velocity_is_told_is_the_base() -> None:
    told = "position=(1, 0, 0 m), velocity=(1, 0, 0 m/s)"
    turning = ("--angular-velocity", "0, 0, 3 rad/s", "--body-point", "position=(1, 2, 0 m)")
    one = answer("orient", "points", *turning, "--body-point", told)["results"]
    other = answer("orient", "points", *turning, "--base", "1, 0, 0 m", "--base-velocity", "1, 0, 0 m/s")["results"]
    assert one["points"][0]["velocity"] == other["points"][0]["velocity"] == {"value": [-5, 0, 0], "unit": "m/s"}


def test_a_rounded_matrix_says_how_far_it_is_from_a_rotation() -> None:
    rows = "0.8138, -0.4410, 0.3785; 0.4698, 0.8826, 0.0180; -0.3420, 0.1632, 0.9254"
    turned = answer("orient", "convert", "--rotation-matrix", rows)["results"]
    assert turned["departure"]["value"] == pytest.approx(7.24580291497726e-5, rel=1e-11)


def test_nine_numbers_are_three_rows() -> None:
    turned = answer("orient", "convert", "--rotation-matrix", "1, 0, 0, 0, 0, -1, 0, 1, 0")["results"]
    assert turned["rotation_angle"]["value"] == 90


def test_columns_of_a_log_are_quaternions_in_any_order(tmp_path: Path) -> None:
    log = tmp_path / "log.csv"
    log.write_text("time,qx,qy,qz,qw\n0,0,0,0,1\n1,0,0,0.3826834323650898,0.9238795325112867\n2,0,0,0,0\n")
    rows = list(csv.DictReader(io.StringIO(run("orient", "convert", "--rows", str(log), "--only", "euler_angles").out)))
    assert [float(row["euler_angles[0][deg]"]) for row in rows[:2]] == pytest.approx([0.0, 45.0])
    assert "no length" in rows[2]["error"]
    mean = answer("orient", "average", "--log", str(log))["results"]
    assert mean["count"]["value"] == 2
    assert mean["euler_angles"]["value"][0] == pytest.approx(22.5)


def test_an_uncertain_disk_has_its_circles() -> None:
    disk = ("--radius", "0.35 ± 0.01 m", "--tilt", "75 deg", "--heading-rate", "40 deg/s", "--spin-rate", "-90 rpm")
    results = answer("orient", "disk", *disk)["results"]
    # r·|ψ̇/φ̇|, in proportion to the radius
    assert results["contact_path_radius"]["value"] == pytest.approx(0.35 * 540 / 40)
    assert results["contact_path_radius"]["std"] == pytest.approx(0.01 * 540 / 40, rel=1e-3)


def test_rows_of_disks_have_radii_where_the_tilt_is_steady() -> None:
    """Among rows that sway: the first and the last row alone would not show it."""
    rates = [0.4, *[0.0, 0.4] * 160, 0.4]
    lines = "".join(f"0.35,60,1.5,-6,{rate}\n" for rate in rates)
    head = "radius[m],tilt[deg],heading_rate[rad/s],spin_rate[rad/s],tilt_rate[rad/s]\n"
    out = run("orient", "disk", "--rows", "-", "--only", "centre_path_radius", stdin=head + lines).out
    assert [bool(line.split(",")[5]) for line in out.splitlines()[1:]] == [not rate for rate in rates]
