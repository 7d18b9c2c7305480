"""The reference of all commands: whole, as Markdown and as a manual page, from the data that help is made of."""

import shutil
import subprocess
from pathlib import Path

import pytest
from harness import run

from dynamics_cli import cli
from dynamics_cli.core.inputs.settings import UNIVERSAL_OPTIONS

TASKS = [task for name in cli.FAMILIES for task in cli.family(name).tasks.values()]


def test_every_task_parameter_example_and_source_is_there() -> None:
    text = run("reference").out
    for task in TASKS:
        assert f"### dynamics {task.path}\n" in text
        assert all(example in text for example in task.shown_examples)
        part = text.partition(f"### dynamics {task.path}\n")[2].partition("\n##")[0]
        for name in task.options:
            assert f"`--{name}" in part
        for field in task.specification.result.fields:
            if field.key not in ("checks", "advice", "numerics"):
                assert f"`{field.key}" in part, (task.path, field.key)
    assert all(f"`--{name}" in text for name in UNIVERSAL_OPTIONS)
    assert "| `130` | interrupted |" in text


def test_tables_have_two_cells_in_every_row() -> None:
    for line in run("reference").out.splitlines():
        if line.startswith("| "):
            assert line.replace("\\|", "").count("|") == 3, line


def test_one_family_has_its_own() -> None:
    text = run("reference", "skid").out
    assert "### dynamics skid speed" in text
    assert "### dynamics convert" not in text


@pytest.mark.parametrize("name", list(cli.FAMILIES))
def test_the_manual_page_is_one_that_man_reads_without_complaint(name: str, tmp_path: Path) -> None:
    text = run("reference", name, "--format", "man").out
    assert text.startswith(".TH DYNAMICS 1")
    assert ".SH EXIT STATUS" in text
    if shutil.which("groff") is None:
        pytest.skip("groff is not installed")
    page = tmp_path / "dynamics.1"
    page.write_text(text)
    done = subprocess.run(
        ["groff", "-man", "-Tutf8", "-Kutf8", "-ww", "-z", str(page)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0
    assert [
        line for line in done.stderr.splitlines() if "cannot adjust" not in line and "cannot break" not in line
    ] == []


def test_wrong_words_are_refused_with_the_right_ones() -> None:
    outcome = run("reference", "skd")
    assert outcome.status == 2
    assert "did you mean dynamics skid?" in outcome.err
    assert run("reference", "skid", "--format", "pdf").status == 2
