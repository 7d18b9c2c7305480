"""Every task that has something to look at: its examples' pictures, in the terminal and in files."""

import io
import math
import shlex
from pathlib import Path
from unicodedata import east_asian_width

import pytest
from harness import run
from shell import ROOT

from dynamics_cli import cli
from dynamics_cli.core.terminal import Terminal

# What answers with words, lists or a file alone has nothing to look at.
WITHOUT = {
    "linkage mobility",
    "balance lanchester",
    "convert", "coords", "units list", "units show", "units search", "units table", "gear glossary", "gear data-block",
    "inertia shapes", "inertia materials", "cam laws", "cam size", "cam check", "cam export",
    "force equivalent", "force spring", "force gravity", "force friction", "force wedge", "force screw",
    "force first-moment",
    "particle fall", "particle hoop", "particle incline", "particle circle", "particle rotating-frame",
    "energy body", "energy speed", "energy drop", "energy roll", "energy power", "energy draw-in",
    "pendulum compound", "pendulum rod", "pendulum conical", "pendulum design",
    "spin shaft", "spin rod",
    "vec matrix", "skid values", "motion equations", "human segments", "human solid", "human limb",
    "multibody topology", "multibody mass-matrix", "multibody equilibrium", "multibody modes",
}  # fmt: skip
TASKS = [task for name in cli.FAMILIES if name != "accuracy" for task in cli.family(name).tasks.values()]
PICTURED = [task for task in TASKS if task.plot]
TWICE = list({task.path.partition(" ")[0]: task for task in PICTURED}.values())
EXAMPLES = [(task, text) for task in PICTURED for text in task.examples]


class Screen(io.BytesIO):
    """Standard error that is a terminal."""

    def isatty(self) -> bool:
        return True


def test_every_other_task_has_a_picture() -> None:
    assert {task.path for task in TASKS if not task.plot} <= WITHOUT


@pytest.mark.parametrize(("task", "text"), EXAMPLES, ids=[text[9:60] for _, text in EXAMPLES])
def test_an_example_fits_a_terminal_of_eighty_columns(
    task: "cli.Task", text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(ROOT)
    monkeypatch.setenv("COLUMNS", "80")
    screen = Screen()
    words = [word for word in shlex.split(text)[1:] if word != "--json"]
    status = cli.run_argv([*words, "--plot", "-"], Terminal(io.BytesIO(), io.BytesIO(), screen, {}))
    shown = screen.getvalue().decode()
    assert status == 0, shown
    assert "nothing to show" not in shown
    lines = shown.splitlines()
    assert len(lines) > 3
    assert all(east_asian_width(letter) not in "WF" for letter in shown)
    assert max(map(len, lines)) <= 80, max(lines, key=len)


@pytest.mark.parametrize("task", PICTURED, ids=lambda task: task.path)
def test_a_picture_s_file_is_the_size_of_a_page_and_the_same_every_time(
    task: "cli.Task", tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(ROOT)
    words = shlex.split(task.examples[0])[1:]
    drawn = []
    # a family draws its tasks' pictures alike: one of each twice
    for _ in range(1 + (task in TWICE)):
        outcome = run(*words, "--plot", str(tmp_path / "picture.svg"))
        assert outcome.status == 0, outcome.err
        drawn.append((tmp_path / "picture.svg").read_bytes())
    data = drawn[0]
    assert drawn[1:] in ([], [data])
    assert len(data) > 2000
    assert b"nan" not in data
    height, width = (float(_attribute(data, name)) for name in (b"height", b"width"))
    assert math.isclose(width, 6.6 * 72, rel_tol=1e-6) or width <= 8.4 * 72
    assert height < 15 * 72


def _attribute(data: bytes, name: bytes) -> bytes:
    start = data.index(b"<svg")
    head = data[start : data.index(b">", start)]
    return head.partition(name + b'="')[2].partition(b"pt")[0]
