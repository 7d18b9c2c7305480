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


SEVERAL = ("skid", "speed", "--distance", "60 ± 2 ft", "--friction", "0.7 ± 0.05", "--jobs", "2")


def workers(process: "subprocess.Popen[bytes]") -> list[int]:
    """The processes that a call has forked, once there are two."""
    for _ in range(200):
        found = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
        if len(found) == 2:
            return [int(one) for one in found]
        time.sleep(0.05)
    raise AssertionError("no processes were forked")


def gone(process: int) -> bool:
    for _ in range(100):
        try:
            state = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
        except OSError:
            return True
        if state == "Z":
            return True
        time.sleep(0.05)
    return False


@pytest.mark.skipif(
    not Path(f"/proc/{os.getpid()}/task/{os.getpid()}/children").exists(), reason="the system lists no children"
)
@pytest.mark.parametrize("kind", ["sweep", "rows"])
class TestSeveralProcesses:
    @pytest.fixture
    def long(self, kind: str, tmp_path: Path) -> "subprocess.Popen[bytes]":
        """A call that keeps two processes busy for minutes."""
        if kind == "sweep":
            return start(*SEVERAL, "--sweep", "friction=0.3:0.9:900000", "--output", str(tmp_path / "out.json"))
        rows = tmp_path / "rows.csv"
        rows.write_text("distance[ft],friction\n" + "60,0.7 ± 0.05\n" * 200_000)
        argv = ("skid", "speed", "--rows", str(rows), "--jobs", "2", "--output", str(tmp_path / "out.csv"))
        return start(*argv)

    @pytest.mark.parametrize("how", [signal.SIGTERM, signal.SIGINT])
    def test_a_request_to_end_is_heard_at_once_and_leaves_nothing(
        self, kind: str, how: signal.Signals, long: "subprocess.Popen[bytes]", tmp_path: Path
    ) -> None:
        children = workers(long)
        time.sleep(0.5)
        long.send_signal(how)
        assert long.wait(10) == 130
        assert all(gone(child) for child in children)
        assert not [path.name for path in tmp_path.iterdir() if "out." in path.name]
        assert long.stderr is not None
        assert long.stderr.read() == b""

    def test_a_process_ended_from_outside_is_told(
        self, kind: str, long: "subprocess.Popen[bytes]", tmp_path: Path
    ) -> None:
        children = workers(long)
        time.sleep(0.5)
        os.kill(children[1], signal.SIGKILL)
        assert long.wait(10) == 1
        assert gone(children[0])
        assert not [path.name for path in tmp_path.iterdir() if "out." in path.name]
        assert long.stderr is not None
        assert b"killed from outside" in long.stderr.read()

    def test_processes_end_with_a_parent_that_was_killed(self, kind: str, long: "subprocess.Popen[bytes]") -> None:
        children = workers(long)
        time.sleep(0.5)
        long.kill()
        long.wait(10)
        assert all(gone(child) for child in children)


def shell(line: str, folder: Path) -> "subprocess.CompletedProcess[str]":
    """A line of sh in which "$dynamics" is the program."""
    env = {**os.environ, "dynamics": f"{sys.executable} -m dynamics_cli", "PYTHONPATH": str(ROOT)}
    return subprocess.run(
        ["sh", "-c", line], cwd=folder, env=env, capture_output=True, text=True, timeout=60, check=False
    )


@pytest.mark.parametrize(
    ("line", "status", "words"),
    [
        ("$dynamics skid speed --distance 60ft --friction 0.7 <&- >&-", 5, "standard output is closed"),
        ("$dynamics skid speed --rows - <&-", 2, "standard input is closed"),
        ("$dynamics skid speed --input - <&-", 2, "standard input is closed"),
        ("$dynamics --help >&-", 5, "standard output is closed"),
        ("$dynamics skid speed --input .", 2, "Is a directory"),
        ("$dynamics skid speed --rows .", 2, "Is a directory"),
        ("$dynamics inertia mesh . --length-unit mm --density 1kg/m^3", 2, "is a directory"),
        ("$dynamics skid speed --distance 60ft --friction 0.7 --output .", 5, "directory"),
    ],
)
def test_streams_and_files_that_are_none(line: str, status: int, words: str, tmp_path: Path) -> None:
    done = shell(line, tmp_path)
    assert (done.returncode, done.stdout) == (status, "")
    assert words in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no full device")
@pytest.mark.parametrize("argv", ["--help", "skid speed --help", "reference", "schema skid speed", "report a.json"])
def test_a_full_disk_is_told_whatever_is_written(argv: str, tmp_path: Path) -> None:
    assert shell("$dynamics skid speed --distance 60ft --friction 0.7 --json > a.json", tmp_path).returncode == 0
    done = shell(f"$dynamics {argv} > /dev/full", tmp_path)
    assert done.returncode == 5
    assert "No space left" in done.stderr


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes")
def test_a_named_pipe_is_read_and_written(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    text = '{"distance": "60 ft", "friction": 0.7}'
    done = shell(f"echo '{text}' > pipe & $dynamics skid speed --input pipe --json", tmp_path)
    assert '"speed"' in done.stdout
    done = shell("cat pipe & $dynamics skid speed --distance 60ft --friction 0.7 --json --output pipe; wait", tmp_path)
    assert '"speed"' in done.stdout
    assert (tmp_path / "pipe").is_fifo()


def test_a_report_prints_nothing_that_commands_a_terminal(tmp_path: Path) -> None:
    (tmp_path / "a.json").write_text(run(*SPEED, "--json").out.replace("work–energy", "\\u001b[31mwork"))
    for form in ("markdown", "html"):
        outcome = run("report", str(tmp_path / "a.json"), "--title", "a\x1b[31m\udcff", "--format", form)
        assert outcome.status == 0
        assert "\x1b" not in outcome.out
        assert "31mwork" in outcome.out


def test_a_file_that_may_not_be_read_is_a_wrong_call(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    mesh = tmp_path / "a.stl"
    mesh.write_text("solid a\nendsolid a\n")

    def refused(*_: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("dynamics_cli.core.inputs.sources.hashes.entry_of_file", refused)
    outcome = run("inertia", "mesh", str(mesh), "--length-unit", "mm", "--density", "1 kg/m^3", "--json")
    assert (outcome.status, outcome.error["code"]) == (2, "unreadable")


def test_a_part_that_is_not_installed_is_a_wrong_call(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    mesh = tmp_path / "a.obj"
    mesh.write_text("v 0 0 0\n")
    monkeypatch.setitem(sys.modules, "trimesh", None)
    outcome = run("inertia", "mesh", str(mesh), "--length-unit", "mm", "--density", "1 kg/m^3", "--json")
    assert (outcome.status, outcome.error["code"]) == (2, "not-installed")
    assert "dynamics-cli[mesh]" in outcome.error["hint"]
