"""Help fits a terminal, and what it shows can be copied and run."""

import re

import pytest
from harness import run

from dynamics_cli import cli
from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.command.help import describe_options
from dynamics_cli.core.command.task_help import option_text

TASKS = [task for name in cli.FAMILIES for task in cli.family(name).tasks.values()]


@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.path)
def test_help_fits_eighty_columns_and_its_examples_are_whole(task: Task, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    text = run(*task.path.split(), "--help").out
    # One option is never broken, however long its value.
    assert [
        line for line in text.splitlines() if len(line) > 80 and not re.match(r' +--\S+ "[^"]*"( \\)?$', line)
    ] == []
    joined = re.sub(r" \\\n +", " ", text)
    for example in task.shown_examples[:2]:
        assert example in joined


def test_no_option_is_said_to_be_unused() -> None:
    assert [task.path for task in TASKS if "Not used" in run(*task.path.split(), "--help").out] == []


@pytest.mark.parametrize("friction", ["0.7", "0.7 ± 0.05"])
def test_a_method_that_is_none_is_refused_whether_or_not_it_is_needed(friction: str) -> None:
    call = ("skid", "speed", "--distance", "60 ft", "--friction", friction, "--json")
    assert run(*call, "--method", "linaer").error["code"] == "unknown-choice"
    assert run(*call, "--method", "linear").status == 0
    assert run(*call, "--coverage", "95").error["parameter"] == "coverage"
    assert run(*call, "--coverage", "95 %").status == 0


def test_defaults_are_written_as_a_user_writes_them() -> None:
    text = " ".join(run("gear", "bevel", "--help").out.split())
    assert "(default 20 deg)" in text
    assert "(default 90 deg)" in text
    assert "(default 0 mm)" in " ".join(run("gear", "spur", "--help").out.split())
    assert "(default 100 %)" in " ".join(run("skid", "speed", "--help").out.split())


def test_a_formula_that_differs_only_in_what_fills_it_is_said_once() -> None:
    assert (
        run("reference", "impact").out.partition("### dynamics impact momentum")[2].partition("\n## ")[0].count("κ =")
        <= 1
    )


def test_no_formula_says_that_a_thing_is_itself() -> None:
    helps = {name: " ".join(run("reference", name).out.split()) for name in cli.FAMILIES}
    assert [path for path, text in helps.items() if re.search(r"[ ,;](\w+) = \1[ ,;]", text)] == []


MOST_LINES = 60


@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.path)
def test_help_is_no_longer_than_its_limit(task: Task, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    assert len(run(*task.path.split(), "--help").out.splitlines()) <= MOST_LINES


@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.path)
def test_every_example_value_is_accepted_by_its_option(task: Task) -> None:
    """All bad parameters are refused at once, so what else is missing does not hide a bad example."""
    refused = {}
    texts = describe_options(task)
    for name, option in task.options.items():
        if option.leaf is None or option.flag or option.leaf.kind.form in ("text", "file"):
            continue
        text = option_text(option, texts)
        _, said, example = text.partition("e.g. ")
        if not said:
            continue
        example = example.partition(" (default")[0].partition(";")[0].strip()
        ran = run(*task.path.split(), f"--{name}", example, "--json")
        errors = ran.error.get("errors", [ran.error]) if ran.status else []
        mine = [error["message"] for error in errors if error["parameter"] == ".".join(option.path)]
        if any("missing" not in message for message in mine):
            refused[f"{name} {example}"] = mine
    assert refused == {}


def test_a_list_of_records_or_its_single_fields_are_alternatives() -> None:
    text = run("balance", "planes", "--help").out
    assert "either --unbalance, or --amount with --angle with --position" in text
    assert "repeatable; takes amount, angle, position" in text
    assert "either --masses with --stiffnesses, or --body with --coupling" in run("vibration", "modes", "--help").out


def test_what_may_be_left_out_is_not_called_required() -> None:
    assert "Usage: dynamics stability matrix [MATRIX] [OPTIONS]" in run("stability", "matrix", "--help").out
    text = run("skid", "sight", "--help").out
    assert "either --second-phase, or --second-kind" in text
    assert "either --obstruction-phase" not in text
