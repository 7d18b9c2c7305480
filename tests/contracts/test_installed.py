"""The program in other forms than its source with everything beside it: without docstrings, in one zip file."""

import subprocess
import sys
import zipapp
from pathlib import Path

import pytest
from harness import run
from shell import ROOT


def python(*argv: str) -> str:
    done = subprocess.run([sys.executable, *argv], capture_output=True, text=True, cwd=ROOT, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("argv", [("reference", "inertia", "skid"), ("inertia", "shapes"), ("gear", "spur", "--help")])
def test_help_is_the_same_where_docstrings_are_dropped(argv: tuple[str, ...]) -> None:
    assert python("-OO", "-m", "dynamics_cli", *argv) == python("-m", "dynamics_cli", *argv)


def test_one_zip_file_holds_its_data(tmp_path: Path) -> None:
    package = ROOT / "dynamics_cli"
    archive = tmp_path / "dynamics.pyz"

    def kept(path: Path) -> bool:
        return path.is_relative_to("dynamics_cli") and "__pycache__" not in path.parts and path.suffix != ".part"

    (tmp_path / "app").mkdir()
    (tmp_path / "app" / "dynamics_cli").symlink_to(package)
    zipapp.create_archive(package.parent, archive, main="dynamics_cli.cli:script", filter=kept)
    table = ("units", "table", "josephs-huston", "--json")
    assert python("-I", str(archive), *table) == run(*table).out
    cases = "from dynamics_cli.accuracy.listing import listed; from dynamics_cli.accuracy.cases import load; "
    cases += "print(len(listed('convert', '', hard=False)), len(load(listed('convert', '', hard=False)[0].file)))"
    code = f"import sys; sys.path.insert(0, {str(archive)!r}); {cases}"
    assert python("-I", "-c", code) == python("-c", cases)
    help_ = ("skid", "speed", "--help")
    assert python("-I", "-OO", str(archive), *help_) == python("-I", str(archive), *help_)
