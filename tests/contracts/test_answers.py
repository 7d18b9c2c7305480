"""The short answer of every task: each example fits a screen of 80 columns and 24 lines, or three more of a table."""

import shlex
from pathlib import Path

import pytest
from harness import answer, run
from shell import ROOT

from dynamics_cli import cli
from dynamics_cli.core.command.template import takes_scene
from dynamics_cli.core.output.render import whole_table

# A screen, and the lines for which no table is cut.
COLUMNS, LINES = 80, 24 + 3
TASKS = {task.path: task for name in cli.FAMILIES for task in cli.family(name).tasks.values()}
# Options that ask for another answer than the short one; those of the second line take a value.
OTHER_ANSWERS = ("--json", "-j", "--all", "--explain")
FORMATS = ("--format", "--rows", "--sweep")
FILES = ("--output", "-o", "--drawing", "--plot")
EXAMPLES = [
    example for task in TASKS.values() for example in task.examples if not any(word in example for word in FORMATS)
]


def short(example: str, folder: Path) -> list[str]:
    """The words of an example that answers in the short form and writes its files to a folder."""
    words = [word for word in shlex.split(example)[1:] if word not in OTHER_ANSWERS]
    return [str(folder / word) if place and words[place - 1] in FILES else word for place, word in enumerate(words)]


@pytest.mark.parametrize("example", EXAMPLES)
def test_an_answer_fits_the_screen(example: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", str(COLUMNS))
    outcome = run(*short(example, tmp_path))
    assert outcome.status == 0, outcome.err
    lines = outcome.out.splitlines()
    assert lines[0].strip(), "the answer begins on the first line"
    assert max(map(len, lines)) <= COLUMNS, [line for line in lines if len(line) > COLUMNS]
    # `accuracy` is a report, as long as its questions are many
    assert len(lines) <= LINES or "accuracy" in example, outcome.out


SCENES = [path for path, task in TASKS.items() if takes_scene(task)]


@pytest.mark.parametrize("path", SCENES)
def test_the_answer_of_a_template_fits_the_screen(path: str, tmp_path: Path) -> None:
    words = path.split()
    file = tmp_path / "scene.toml"
    file.write_text(run(*words, "--template").out, encoding="utf-8")
    outcome = run(*words, "--input", str(file))
    assert outcome.status == 0, outcome.err
    lines = outcome.out.splitlines()
    assert max(map(len, lines)) <= COLUMNS, [line for line in lines if len(line) > COLUMNS]
    assert len(lines) <= LINES, outcome.out


def test_inputs_in_answers_are_words_not_addresses() -> None:
    outcome = run("impact", "crash", str(ROOT / "examples" / "crash_scene" / "crash.toml"))
    assert "Opel after 1 braking" in outcome.out
    assert "Ford before: 1, Ford after: 2" in outcome.out
    assert "[" not in outcome.out
    oblique = run(*shlex.split(
        'impact oblique --first-mass "1500 ± 20 kg" --first-velocity "50 km/h @ 10 deg" --second-mass "1200 kg" '
        '--second-velocity "-20 ± 2, 5 km/h" --normal "0 deg" --restitution 0.15'
    ))  # fmt: skip
    assert "second velocity along x" in oblique.out
    slow = run(*shlex.split(
        'impact oblique --first-mass "1 kg" --first-velocity "20 cm/s @ 45 deg" --second-mass "1 kg" '
        '--second-velocity "0, 0 m/s" --normal "0 deg" --restitution 0.9'
    ))  # fmt: skip
    assert "first velocity 20 cm/s @ 45 deg" in slow.out


def test_a_whole_table_is_folded_on_a_terminal_that_is_narrower() -> None:
    document = answer("impact", "crash", str(ROOT / "examples" / "crash_scene" / "crash.toml"))
    whole = whole_table(document, "links", 6, "table").splitlines()
    folded = whole_table(document, "links", 6, "table", 60).splitlines()
    assert max(map(len, whole)) > 60 >= max(map(len, folded))
    # every block names its rows
    assert sum(line.startswith("  slide of Ford") for line in folded) == 2
    assert {word for line in whole for word in line.split()} == {word for line in folded for word in line.split()}


def test_bodies_are_called_by_their_names() -> None:
    outcome = run(
        *shlex.split(
            'impact central --first-name Ford --second-name "Opel Corsa" --first-mass "1500 ± 20 kg" --first-velocity '
            '"12 ± 1 m/s" --second-mass "1200 kg" --restitution 0.1 --limit "first.velocity=10 m/s"'
        )
    )
    first, limit, second = outcome.out.splitlines()[:3]
    assert first.startswith("Ford velocity after v₁′")
    assert "10 m/s exceeded" in limit
    assert second.startswith("Opel Corsa velocity after v₂′")
    assert "driven by  Ford velocity" in outcome.out
    assert "for   Ford mass 1500 ± 20 kg, Ford velocity" in outcome.out
    assert "first" not in outcome.out.partition("\nby ")[0]
