"""Every command there is: documented, with examples that run alike by both routes and validate against its schema."""

import json
import shlex
from functools import cache
from pathlib import Path

import jsonschema
import pytest
from harness import Outcome, run

from dynamics_cli import cli
from dynamics_cli.core.answering.task import UNIVERSAL, Task
from dynamics_cli.core.command.help import undescribed
from dynamics_cli.core.command.schema import schema
from dynamics_cli.core.inputs.settings import UNIVERSAL_OPTIONS

TASKS = {task.path: task for name in cli.FAMILIES for task in cli.family(name).tasks.values()}
EXAMPLES = [(path, example) for path, task in TASKS.items() for example in task.examples if "--rows" not in example]


def words(example: str) -> list[str]:
    assert example.startswith("dynamics ")
    return shlex.split(example)[1:]


@cache
def printed(example: str, form: str) -> Outcome:
    """What an example prints; run once for all that is asked of it."""
    outcome = run(*words(example), env={"DYNAMICS_FORMAT": form})
    assert outcome.status == 0, outcome.err
    return outcome


@pytest.fixture(params=TASKS, ids=list(TASKS))
def task(request: pytest.FixtureRequest) -> Task:
    return TASKS[request.param]


def test_every_task_has_an_example_a_summary_and_sources(task: Task) -> None:
    assert task.examples
    assert task.summary.endswith(".")
    assert all(model.source and model.name for model in task.models)


def test_every_parameter_is_described(task: Task) -> None:
    assert undescribed(task) == []


def test_help_is_complete(task: Task) -> None:
    text = run(*task.path.split(), "--help").out
    assert "Examples:" in text
    assert "Source:" in text
    assert "dynamics help options" in text
    for name in task.options:
        assert f"--{name}" in text or name.partition("-")[2] in text
    assert len(text.splitlines()) <= 60


def test_the_options_of_every_task_are_listed() -> None:
    text = run("help", "options").out
    assert [name for name in UNIVERSAL_OPTIONS if f"--{name}" not in text] == []
    assert max(map(len, text.splitlines())) <= 80


def test_the_public_function_is_documented(task: Task) -> None:
    for model in task.models:
        text = model.call().__doc__ or ""
        assert text.splitlines()[0].endswith(".")


def test_the_schema_is_a_schema(task: Task) -> None:
    jsonschema.Draft202012Validator.check_schema(schema(task))
    assert json.loads(run("schema", *task.path.split()).out) == json.loads(json.dumps(schema(task)))


@pytest.mark.parametrize(("path", "example"), EXAMPLES, ids=[example for _, example in EXAMPLES])
class TestExamples:
    def test_both_routes_are_byte_identical(self, path: str, example: str) -> None:
        # the form is written behind both routes alike: one example of a task in both is enough
        for form in ("json", "table")[: 2 if example == TASKS[path].examples[0] else 1]:
            assert printed(example, form) == run(*words(example), env={"DYNAMICS_FORMAT": form}, route="tree")

    @pytest.mark.parametrize("form", ["csv", "markdown", "ndjson"])
    def test_it_is_written_in_every_form(self, path: str, example: str, form: str) -> None:
        if example == TASKS[path].examples[0]:
            assert printed(example, form).out.endswith("\n")

    def test_everything_is_printed(self, path: str, example: str) -> None:
        if example == TASKS[path].examples[0] and "--format" not in example:
            outcome = run(*words(example), "--all")
            assert outcome.status == 0, outcome.err
            assert outcome.out.startswith(path)

    def test_the_document_keeps_its_schema(self, path: str, example: str) -> None:
        if "--format" in example:
            return
        document = printed(example, "json").document
        inputs = {key: value for key, value in document["inputs"].items() if key != "sweep"}
        if "sweep" not in document["inputs"]:
            told = {"inputs": inputs, "results": document["results"]}
            jsonschema.Draft202012Validator(schema(TASKS[path])).validate(told)

    def test_the_inputs_of_a_document_give_the_same_document(self, path: str, example: str) -> None:
        if "--input" in example or "--format" in example or "--sweep" in example or "--limit" in example:
            return
        document = printed(example, "json").document
        shown = _shown_options(words(example))
        again = run(*path.split(), "--input", "-", "--json", *shown, stdin=json.dumps(document["inputs"]))
        assert again.status == 0, again.err
        assert again.document["results"] == document["results"]
        assert again.document["inputs"] == document["inputs"]


# In test_pictures.py every one is drawn in the terminal, and of every task the first as a file.
PICTURED = [(path, example) for path, example in EXAMPLES if TASKS[path].plot and example != TASKS[path].examples[0]]


@pytest.mark.slow
@pytest.mark.parametrize(("path", "example"), PICTURED, ids=[example for _, example in PICTURED])
def test_every_other_example_of_a_task_with_a_picture_has_one(path: str, example: str, tmp_path: Path) -> None:
    if "--sweep" in example or "--plot" in example:
        return
    file = tmp_path / "picture.svg"
    outcome = run(*words(example), "--plot", str(file))
    assert outcome.status == 0, outcome.err
    assert file.stat().st_size > 2000


def _shown_options(argv: list[str]) -> list[str]:
    """The universal options of a call, which its inputs do not hold."""
    kept: list[str] = []
    for index, word in enumerate(argv):
        how = UNIVERSAL_OPTIONS.get(word[2:], ("",))[0] if word.startswith("--") else ""
        if how == "flag" and word != "--json":
            kept.append(word)
        elif how in ("value", "many"):
            kept += [word, argv[index + 1]]
    return kept


def test_universal_options_are_reserved() -> None:
    assert set(UNIVERSAL_OPTIONS) <= set(UNIVERSAL)


def test_family_help_lists_every_task() -> None:
    for name in cli.FAMILIES:
        family = cli.family(name)
        if family.alone is None:
            text = run(name, "--help").out
            assert all(task in text for task in family.tasks)
            assert run(name).out == text


def test_top_help_is_a_line_for_each_command() -> None:
    assert len(run("--help").out.splitlines()) <= len(cli.FAMILIES) + 30
