"""`[points]` of a scene: coordinates by name."""

import io
import json
from pathlib import Path

import pytest

from dynamics_cli.cli import run_argv
from dynamics_cli.core.terminal import Terminal

SCENE = """
[points]
A = "0, 0 m"
B = "4, 0 m"
C = [1.5, 0]

[units]
point = "m"

[[loads]]
force = "0, -500 N"
at = "C"

[[loads]]
force = "300 N from A to B"
at = "B"

[[supports]]
type = "pin"
at = "A"

[[supports]]
type = "roller"
at = "B"
"""


def answered(tmp_path: Path, scene: str, *more: str, task: str = "force equilibrium") -> "tuple[int, str, str]":
    """Exit status, output and errors of a task with this scene."""
    (tmp_path / "scene.toml").write_text(scene, encoding="utf-8")
    out, err = io.BytesIO(), io.BytesIO()
    terminal = Terminal(io.BytesIO(), out, err, {})
    status = run_argv([*task.split(), "--input", str(tmp_path / "scene.toml"), *more], terminal)
    terminal.flush()
    return status, out.getvalue().decode(), err.getvalue().decode()


def test_points_stand_for_their_coordinates(tmp_path: Path) -> None:
    _, by_name, _ = answered(tmp_path, SCENE, "--json")
    spelled = SCENE.partition("[units]")[2].replace('point = "m"', "")
    spelled = spelled.replace('at = "A"', 'name = "A"\nat = "0, 0 m"').replace(
        'type = "roller"\nat = "B"', 'type = "roller"\nname = "B"\nat = "4, 0 m"'
    )
    spelled = spelled.replace('at = "C"', 'at = "1.5, 0 m"').replace('at = "B"', 'at = "4, 0 m"')
    spelled = spelled.replace("from A to B", "from 0, 0 m to 4, 0 m")
    _, by_numbers, _ = answered(tmp_path, spelled, "--json")
    first, second = json.loads(by_name), json.loads(by_numbers)
    assert first["inputs"] == second["inputs"]
    assert first["results"] == second["results"]
    assert [reaction["name"] for reaction in first["results"]["reactions"]] == ["A", "B"]


def test_options_may_name_points_too(tmp_path: Path) -> None:
    status, out, _ = answered(tmp_path, SCENE, "--force", "0, -1 kN", "--at", "C", "--only", "load")
    assert (status, out.split()) == (0, ["[0,", "-1000,", "0]", "N"])


@pytest.mark.parametrize(
    ("scene", "status", "message"),
    [
        (SCENE.replace('at = "C"', 'at = "D"'), 2, "there is no point 'D'\n  points are A, B, C"),
        (SCENE.replace('"4, 0 m"', '"4 ± 0.1, 0 m"'), 2, "point B is uncertain"),
        ('[points]\nA = "0, 0 m"\n[[loads]]\nforce = "1, 0 N"\nat = "0, 0 m"\n', 2, "there is no parameter 'points'"),
    ],
)
def test_wrong_points_are_refused(tmp_path: Path, scene: str, status: int, message: str) -> None:
    got, _, errors = answered(tmp_path, scene)
    assert got == status
    assert message in errors


def test_points_of_a_task_without_points_are_refused(tmp_path: Path) -> None:
    scene = 'distance = "60 ft"\nfriction = 0.7\n[points]\nA = "0, 0 m"\n'
    status, _, errors = answered(tmp_path, scene, task="skid speed")
    assert status == 2
    assert "there is no parameter 'points'" in errors
