"""A hostile hour: killed while writing, endless input, two writers of one file, warnings as errors, tiny terminals."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from harness import run
from shell import ROOT

SPEED = ("skid", "speed", "--distance", "60 ft", "--friction", "0.7")


def start(*argv: str, **env: str) -> "subprocess.Popen[bytes]":
    return subprocess.Popen(
        [sys.executable, "-m", "dynamics_cli", *argv],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=ROOT, env={**os.environ, **env},
    )  # fmt: skip


@pytest.mark.parametrize("how", [signal.SIGTERM, signal.SIGINT])
def test_ended_while_writing_it_leaves_the_old_file_and_no_part(how: signal.Signals, tmp_path: Path) -> None:
    target = tmp_path / "out.csv"
    target.write_text("what was there\n")
    process = start("skid", "speed", "--rows", "-", "--output", str(target))
    assert process.stdin is not None
    process.stdin.write(b"distance[ft],friction\n" + b"60,0.7\n" * 200_000)
    process.stdin.flush()
    for _ in range(200):
        if any(name.name.endswith(".part") for name in tmp_path.iterdir()):
            break
        time.sleep(0.05)
    process.send_signal(how)
    assert process.wait(20) == 130
    assert [path.name for path in tmp_path.iterdir()] == ["out.csv"]
    assert target.read_text() == "what was there\n"
    assert process.stderr is not None
    assert b"Traceback" not in process.stderr.read()


def test_two_writers_of_one_file_leave_one_whole_document(tmp_path: Path) -> None:
    target = tmp_path / "out.json"
    writers = [start(*SPEED, "--json", "--units", units, "--output", str(target)) for units in ("si", "us") * 3]
    assert [writer.wait(60) for writer in writers] == [0] * 6
    whole = {run(*SPEED, "--json", "--units", units).out for units in ("si", "us")}
    assert target.read_text() in whole
    assert [path.name for path in tmp_path.iterdir()] == ["out.json"]


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="there is no endless device")
def test_an_endless_input_is_refused() -> None:
    outcome = run(*SPEED[:2], "--input", "/dev/zero", "--json")
    assert (outcome.status, outcome.error["code"]) == (2, "too-long")


@pytest.mark.parametrize(
    "argv",
    [
        (*SPEED, "--json"),
        ("--help",),
        (*SPEED[:5], "0.7 ± 0.1", "--plot", "{folder}/a.svg"),
        ("schema", "skid", "speed"),
        ("accuracy", "skid", "yaw", "--untimed"),
    ],
)
def test_warnings_as_errors_change_nothing(argv: tuple[str, ...], tmp_path: Path) -> None:
    process = start(*(word.format(folder=tmp_path) for word in argv), PYTHONWARNINGS="error")
    _, errors = process.communicate(timeout=120)
    assert (process.returncode, errors) == (0, b"")


def test_another_locale_and_no_home_change_no_byte(tmp_path: Path) -> None:
    home = tmp_path / "home"
    home.mkdir(mode=0o555)
    process = start(*SPEED, "--json", LC_ALL="de_DE.UTF-8", LANG="de_DE.UTF-8", HOME=str(home))
    out, errors = process.communicate(timeout=60)
    assert (out.decode(), errors) == (run(*SPEED, "--json").out, b"")


@pytest.mark.parametrize("argv", [("--help",), ("skid", "--help"), ("skid", "speed", "--help"), SPEED])
def test_a_terminal_of_twenty_columns(argv: tuple[str, ...]) -> None:
    process = start(*argv, COLUMNS="20")
    out, errors = process.communicate(timeout=60)
    assert (process.returncode, errors) == (0, b"")
    assert out
