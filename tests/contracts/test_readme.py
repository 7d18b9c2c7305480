"""Every command of the README and every example script, run and its output compared."""

import shutil
from pathlib import Path

import pytest
from shell import ROOT, shell

EXAMPLES = ROOT / "examples"
TOOLS = ("jq", "sqlite3")


def sessions(text: str) -> list[tuple[str, str]]:
    """Commands and their printed output, from the console blocks of a Markdown text."""
    found: list[tuple[str, str]] = []
    inside = False
    for line in text.splitlines():
        if line.startswith("```"):
            inside = line == "```console"
        elif inside and line.startswith("$ "):
            found.append((line[2:], ""))
        elif inside and found and found[-1][0].endswith("\\") and not found[-1][1]:
            found[-1] = (f"{found[-1][0]}\n{line}", "")
        elif inside and found:
            found[-1] = (found[-1][0], f"{found[-1][1]}{line}\n")
    return found


README = sessions((ROOT / "README.md").read_text())
SCRIPTS = sorted(EXAMPLES.glob("**/*.sh"))


def missing(text: str) -> list[str]:
    return [tool for tool in TOOLS if tool in text and shutil.which(tool) is None]


@pytest.mark.parametrize(("command", "expected"), README, ids=[command[:60] for command, _ in README])
def test_readme_commands_print_what_they_are_said_to(command: str, expected: str, tmp_path: Path) -> None:
    if missing(command):
        pytest.skip(f"{missing(command)} is not installed")
    done = shell(command, EXAMPLES, tmp_path)
    assert done.stdout + done.stderr == expected


@pytest.mark.parametrize("script", SCRIPTS, ids=[path.name for path in SCRIPTS])
def test_example_scripts_print_what_stands_beside_them(script: Path, tmp_path: Path) -> None:
    if missing(script.read_text()):
        pytest.skip(f"{missing(script.read_text())} is not installed")
    done = shell(f"sh {script.name}", script.parent, tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout == script.with_suffix(".out").read_text()


@pytest.mark.parametrize("script", SCRIPTS, ids=[path.name for path in SCRIPTS])
def test_example_scripts_pass_shellcheck(script: Path) -> None:
    if shutil.which("shellcheck") is None:
        pytest.skip("shellcheck is not installed")
    import subprocess

    done = subprocess.run(["shellcheck", str(script)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_the_readme_leads_with_its_two_commands() -> None:
    text = (ROOT / "README.md").read_text()
    ci = (ROOT / ".ci" / "run").read_text()
    assert text.index("pip install") < text.index("## ")
    assert "pip install -e '.[test]'" in text
    assert "-m pytest" in text
    assert "-e '.[test]'" in ci
    assert "-m pytest" in ci
