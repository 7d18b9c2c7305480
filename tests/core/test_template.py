"""A template is a scene that is read back as it stands."""

import re
import tomllib
from pathlib import Path
from typing import Any

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
    # a long list of an example stands on one line
    assert max(len(line) for line in text.splitlines() if ' = "' not in line) <= 80
    file.write_text(text, encoding="utf-8")
    return file


@pytest.mark.parametrize("task", SCENES, ids=lambda task: task.path)
def test_a_template_is_a_case_with_an_answer(task: Task, tmp_path: Path) -> None:
    ran = run(*task.path.split(), "--input", str(written(task, tmp_path)), "--json")
    assert ran.status == 0, ran.error


@pytest.mark.parametrize("task", [task for task in SCENES if task.scene], ids=lambda task: task.path)
def test_a_template_shows_the_values_of_its_scene(task: Task, tmp_path: Path) -> None:
    shown = tomllib.loads(written(task, tmp_path).read_text(encoding="utf-8"))
    for address, value in task.scene.items():
        node: Any = shown
        for part in re.split(r"[.\[\]]+", address.rstrip("]")):
            node = node[int(part)] if part.isdigit() else node[part]
        # TOML writes true and false in small letters
        assert (str(node).lower() if isinstance(node, bool) else str(node)) == value


def test_a_task_that_takes_words_has_no_template() -> None:
    assert run("convert", "--template", "--json").error["parameter"] == "template"
    assert "--template" in run("inertia", "body", "--help").out


def test_a_template_without_groups_has_the_values_of_the_first_example(tmp_path: Path) -> None:
    pair = next(task for task in TASKS if task.path == "gear pair")
    shown = tomllib.loads(written(pair, tmp_path).read_text(encoding="utf-8"))
    assert shown["first"]["teeth"] == 12
