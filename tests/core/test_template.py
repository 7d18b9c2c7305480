"""A template is a scene that is read back as it stands."""

from pathlib import Path

import pytest
from harness import run

from dynamics_cli import cli
from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.command.template import takes_scene

TASKS = [task for name in cli.FAMILIES for task in cli.family(name).tasks.values()]
SCENES = [task for task in TASKS if takes_scene(task)]


def written(task: Task, folder: Path) -> Path:
    file = folder / "scene.toml"
    text = run(*task.path.split(), "--template").out
    assert max(map(len, text.splitlines())) <= 80
    file.write_text(text, encoding="utf-8")
    return file


@pytest.mark.parametrize("task", SCENES, ids=lambda task: task.path)
def test_a_template_is_read_back(task: Task, tmp_path: Path) -> None:
    """What it says may not yet be a case that has an answer, but nothing of it is misread."""
    ran = run(*task.path.split(), "--input", str(written(task, tmp_path)), "--json")
    assert ran.status in (0, 3), ran.error


@pytest.mark.parametrize("path", ["inertia body", "inertia compare", "inertia section", "skid speed"])
def test_a_template_is_a_case_with_an_answer(path: str, tmp_path: Path) -> None:
    task = next(task for task in SCENES if task.path == path)
    assert run(*path.split(), "--input", str(written(task, tmp_path)), "--json").status == 0


def test_a_task_without_a_scene_has_no_template() -> None:
    assert run("inertia", "torque", "--template", "--json").error["parameter"] == "template"
    assert "--template" not in run("inertia", "torque", "--help").out
    assert "--template" in run("inertia", "body", "--help").out
