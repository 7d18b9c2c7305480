"""How a call ends from outside: interrupted at any time, its reader gone, nowhere to write; always quietly."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from harness import run
from shell import ROOT

PROGRAM = f"{sys.executable} -m dynamics_cli"
UNCERTAIN = ("skid", "speed", "--distance", "60 ± 1 ft", "--friction", "0.7 ± 0.01", "--method", "monte-carlo",
             "--samples", "30000000")  # fmt: skip


def sh(line: str, folder: Path, **env: str) -> "subprocess.CompletedProcess[str]":
    """A line of bash that tells the status of the first command of its pipe."""
    given = {**os.environ, "PYTHONPATH": str(ROOT), **env}
    return subprocess.run(
        ["bash", "-c", line], cwd=folder, env=given, capture_output=True, text=True, timeout=60, check=False
    )


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="the system tells nothing of its processes")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_at_any_time_it_says_nothing(number: signal.Signals) -> None:
    """From the first of our own instructions: what Python itself does before them is not ours."""
    code = (
        "import sys; sys.path.insert(0, sys.argv.pop(1)); import dynamics_cli.core.termination as e; e.leave_quietly();"
        "print('begun', flush=True); import dynamics_cli.__main__ as m; sys.argv[0] = 'dynamics'; m.script()"
    )
    for delay in range(0, 400, 40):
        process = subprocess.Popen(
            [sys.executable, "-c", code, str(ROOT), *UNCERTAIN], stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )
        assert process.stdout is not None
        assert process.stdout.readline() == b"begun\n"
        time.sleep(delay / 1000.0)
        process.send_signal(number)
        out, err = process.communicate(timeout=60)
        assert (process.returncode, out, err) == (130, b"", b""), delay


def test_the_program_is_quiet_before_it_imports_anything() -> None:
    """The first import of the process's own module is the one that says what signals do."""
    lines = (ROOT / "dynamics_cli" / "__main__.py").read_text().splitlines()
    imports = [line for line in lines if line.startswith(("import ", "from "))]
    assert imports[0] == "from dynamics_cli.core.termination import leave_quietly"
    assert lines.index("leave_quietly()") < lines.index(imports[1])
    assert 'dynamics = "dynamics_cli.__main__:script"' in (ROOT / "pyproject.toml").read_text()


def test_a_signal_that_the_caller_ignores_stays_ignored(tmp_path: Path) -> None:
    line = f"trap '' INT TERM HUP; {PROGRAM} skid speed --rows - --output a.csv & sleep 1; kill -TERM $!; kill -HUP $!"
    line = f"(sleep 2; printf 'distance[ft],friction\\n60,0.7\\n') | ({line}; wait $!)"
    # A command in the background reads nothing unless told so.
    done = sh(line.replace("--rows -", "--rows /dev/fd/3").replace("| (", "| (exec 3<&0; "), tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "a.csv").exists()


@pytest.mark.parametrize(
    "argv",
    ["--help", "", "skid", "skid speed --help", "reference", "schema skid speed", "--version", "units list",
     "--show-completion bash", "skid speed --distance 60ft --friction 0.7", "report a.json"],
)  # fmt: skip
def test_a_reader_that_has_seen_enough_ends_it_quietly(argv: str, tmp_path: Path) -> None:
    (tmp_path / "a.json").write_text(run("skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--json").out)
    done = sh(f"{PROGRAM} {argv} | true; exit ${{PIPESTATUS[0]}}", tmp_path)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no full device")
@pytest.mark.parametrize(
    ("line", "status"),
    [
        (f"{PROGRAM} skid speed 2>/dev/full", 2),
        (f"{PROGRAM} skid speed --json 2>/dev/full", 2),
        (f"{PROGRAM} skid speed --distance 60ft --friction 0.7 >/dev/full 2>/dev/full", 5),
        (f"{PROGRAM} skid speed 2>&1 | true; exit ${{PIPESTATUS[0]}}", 2),
        (f"{PROGRAM} skid speed 2>&-", 2),
        (f"{PROGRAM} nosuch 2>/dev/full", 2),
    ],
)
def test_where_nobody_reads_errors_the_status_tells(line: str, status: int, tmp_path: Path) -> None:
    assert sh(line, tmp_path).returncode == status


@pytest.mark.parametrize(
    ("name", "value", "status"),
    [("MPLBACKEND", "nosuch", 0), ("MPLBACKEND", "module://nosuch", 0), ("MATPLOTLIBRC", "rc", 2)],
)
def test_settings_of_the_drawing_library(name: str, value: str, status: int, tmp_path: Path) -> None:
    (tmp_path / "rc").write_bytes(b"\xff\xfe\xd1")
    argv = "skid speed --distance 60ft --friction 0.7 --sweep friction=0.1:0.2:3 --plot a.svg"
    done = sh(f"{PROGRAM} {argv}", tmp_path, **{name: value})
    assert done.returncode == status, done.stderr
    assert (tmp_path / "a.svg").exists() is (status == 0)
    assert "internal error" not in done.stderr
