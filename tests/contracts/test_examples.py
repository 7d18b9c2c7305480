"""The worked examples: complete, shipped, copied whole, never over a file that exists."""

import shlex
import tomllib
from pathlib import Path

import pytest
from harness import run
from shell import ROOT, shell

from dynamics_cli.examples_command.command import folder, names
from dynamics_cli.examples_command.worked import WORKED

ROOM = ROOT / "examples"


def test_every_file_belongs_to_an_example() -> None:
    files = {str(path.relative_to(ROOM)) for path in ROOM.rglob("*") if path.is_file()}
    listed = {name for example in WORKED for name in example.files}
    assert listed == {name for name in files if not name.endswith((".out", ".pyc"))}
    assert len(set(names())) == len(names())


def test_they_ship_where_the_command_looks() -> None:
    wheel = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["hatch"]["build"]["targets"]["wheel"]
    assert wheel["force-include"] == {"examples": "dynamics_cli/examples"}
    assert folder() == ROOM


def test_the_list_has_a_line_for_each() -> None:
    text = run("examples").out
    assert [name for name in names() if f"\n  {name} " not in text] == []
    assert text.index("Crash reconstruction:") < text.index("  pedestrian ") < text.index("Bodies:")
    assert max(map(len, text.splitlines())) <= 80


def test_a_family_lists_the_examples_that_use_it() -> None:
    text = run("examples", "skid").out
    assert all(f"\n{name} " in f"\n{text}" for name in ("crash", "pedestrian", "rollover", "recorder"))
    assert "gearbox" not in text
    assert run("examples", "spin").status in (0, 2)


@pytest.mark.parametrize("name", names())
def test_each_is_copied_and_runs(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert run("examples", name, "--copy").status == 0
    example = next(example for example in WORKED if example.name == name)
    assert {str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*") if path.is_file()} == set(example.files)
    assert example.run in run("examples", name).out
    if example.run.startswith("dynamics "):
        assert run(*shlex.split(example.run)[1:]).status == 0


def test_examples_that_share_a_file_stand_in_one_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert run("examples", "flywheel", "--copy").status == 0
    assert run("examples", "rotor", "--copy").status == 0


def test_a_file_that_exists_is_left_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "crash").mkdir()
    (tmp_path / "crash" / "crash.sh").write_text("mine")
    refused = run("examples", "crash", "--copy")
    assert refused.status == 5
    assert (tmp_path / "crash" / "crash.sh").read_text() == "mine"
    assert len(list(tmp_path.rglob("*.toml"))) == 0


def test_a_name_may_be_that_of_a_file_or_nearly_right() -> None:
    assert run("examples", "flywheel.toml").out == run("examples", "flywheel").out
    assert "did you mean crash" in run("examples", "crahs").err
    assert run("examples", "--copy").status == 2
    assert run("examples", "crash", "cam").status == 2


def test_names_are_completed(tmp_path: Path) -> None:
    line = "env _DYNAMICS_COMPLETE=complete_bash COMP_WORDS='dynamics examples c' COMP_CWORD=2 dynamics"
    offered = shell(line, tmp_path, tmp_path).stdout.split()
    assert {"crash", "cam", "cases"} <= set(offered)


def test_help_names_no_file_that_a_user_has_not() -> None:
    text = run("inertia", "body", "--help").out
    assert "examples/" not in text
    assert "dynamics examples flywheel.toml --copy" in text
