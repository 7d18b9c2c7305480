"""Completion in real shells, where they are installed."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from harness import run
from shell import ROOT

CASES = [
    ("dynamics sk", "skid"),
    ("dynamics skid sp", "speed"),
    ("dynamics skid speed --fr", "--friction"),
    ("dynamics skid speed --format j", "json"),
    ("dynamics convert 60 mp", "mph"),
    ("dynamics schema skid th", "throw"),
    ("dynamics cam rise --law cyc", "cycloidal"),
    ("dynamics inertia shape cyl", "cylinder"),
    ("dynamics report --ti", "--title"),
    ("dynamics inertia mesh --material alum", "aluminium-6061"),
    ("dynamics skid speed --to sp", "speed="),
    ("dynamics impact momentum --limit first.app", "first.approach_speed="),
    ("dynamics skid speed --sweep fr", "friction="),
]


@pytest.fixture
def command(tmp_path: Path) -> dict[str, str]:
    """An environment in which `dynamics` is this checkout's."""
    script = tmp_path / "dynamics"
    script.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m dynamics_cli "$@"\n')
    script.chmod(0o755)
    return {**os.environ, "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}", "PYTHONPATH": str(ROOT)}


def printed(shell: str, tmp_path: Path) -> Path:
    """The completion script that the program prints for a shell."""
    if shutil.which(shell) is None:
        pytest.skip(f"{shell} is not installed")
    file = tmp_path / f"completion.{shell}"
    file.write_text(run("--show-completion", shell).out)
    return file


@pytest.mark.parametrize(("line", "expected"), CASES, ids=[line for line, _ in CASES])
class TestShells:
    def test_bash(self, line: str, expected: str, command: dict[str, str], tmp_path: Path) -> None:
        words = " ".join(f"'{word}'" for word in line.split(" "))
        code = (
            f'source "{printed("bash", tmp_path)}"; COMP_WORDS=({words}); COMP_CWORD={line.count(" ")}; '
            'COMP_LINE="${COMP_WORDS[*]}"; $(complete -p dynamics | sed "s/.*-F \\([^ ]*\\) .*/\\1/") dynamics; '
            'printf "%s\\n" "${COMPREPLY[@]}"'
        )
        done = subprocess.run(["bash", "-c", code], capture_output=True, text=True, env=command, check=False)
        assert expected in done.stdout.split(), done.stderr

    def test_fish(self, line: str, expected: str, command: dict[str, str], tmp_path: Path) -> None:
        code = f"source {printed('fish', tmp_path)}; complete -C '{line}'"
        env = {**command, "HOME": str(tmp_path)}
        done = subprocess.run(["fish", "-c", code], capture_output=True, text=True, env=env, check=False)
        assert expected in [found.split("\t")[0] for found in done.stdout.splitlines()], done.stderr

    def test_zsh(self, line: str, expected: str, command: dict[str, str], tmp_path: Path) -> None:
        words = " ".join(f"'{word}'" for word in line.split(" "))
        # Outside an interactive shell the widgets of completion are stood in for; the quoting and `eval` are zsh's own.
        code = (
            "compdef() { : }; _files() { : }; _arguments() { print -r -- ${(M)@:#*:*} }; "
            f"words=({words}); CURRENT={line.count(' ') + 1}; source {printed('zsh', tmp_path)}; _dynamics_completion"
        )
        done = subprocess.run(["zsh", "-f", "-c", code], capture_output=True, text=True, env=command, check=False)
        assert f'"{expected}"' in done.stdout, done.stderr


def test_zsh_reads_its_script(tmp_path: Path) -> None:
    done = subprocess.run(["zsh", "-n", str(printed("zsh", tmp_path))], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize(("line", "expected"), CASES, ids=[line for line, _ in CASES])
def test_powershell_is_given_words_with_tips(line: str, expected: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """What its script runs; the shell itself is on no machine that these tests run on."""
    monkeypatch.setenv("_DYNAMICS_COMPLETE", "complete_powershell")
    monkeypatch.setenv("_TYPER_COMPLETE_ARGS", line)
    monkeypatch.setenv("_TYPER_COMPLETE_WORD_TO_COMPLETE", line.rpartition(" ")[2])
    done = subprocess.run([sys.executable, "-m", "dynamics_cli"], capture_output=True, text=True, check=False)
    assert expected in [word.partition(":::")[0] for word in done.stdout.splitlines() if ":::" in word], done.stderr


def test_powershell_s_script_sets_what_the_program_reads() -> None:
    script = run("--show-completion", "powershell").out
    assert "-CommandName dynamics" in script
    for name in ("_DYNAMICS_COMPLETE", "_TYPER_COMPLETE_ARGS", "_TYPER_COMPLETE_WORD_TO_COMPLETE"):
        assert script.count(f"$env:{name} = ") == 2
    assert script.count("{") == script.count("}")
