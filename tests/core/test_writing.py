"""Files written: every step fails or is interrupted once, and each time the old file or the whole new one is there.

In the manner of SQLite's tests: the calls of the operating system are counted, and the nth of them fails.
"""

import errno
import io
import os
import resource
import signal
import stat
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from harness import run
from shell import ROOT

from dynamics_cli.cli import run_argv
from dynamics_cli.core.output import files
from dynamics_cli.core.output.files import Files
from dynamics_cli.core.terminal import Terminal
from dynamics_cli.core.termination import leave_quietly
from dynamics_cli.errors import OutputError

SPEED = ("skid", "speed", "--distance", "60 ft", "--friction", "0.7")
OLD = "what was there\n"
CALLS = ("open", "fdopen", "stat", "fchown", "fchmod", "fsync", "link", "replace", "unlink")
PIECES = ("write", "flush", "close")
FAULTS: tuple[Callable[[], BaseException], ...] = (
    lambda: OSError(errno.EIO, "a fault"),
    lambda: OSError(errno.ENOSPC, "no space"),
    MemoryError,
    KeyboardInterrupt,
)


class Faulty:
    """The module `os`, or a file: the nth call of the listed ones does `fault`, before or after its own work."""

    def __init__(self, real: Any, names: tuple[str, ...], count: list[int], fault: Callable[[], None], after: bool):
        self._real, self._names, self._count, self._fault, self._after = real, names, count, fault, after

    def __getattr__(self, name: str) -> Any:
        real = getattr(self._real, name)
        if name not in self._names:
            return real

        def call(*values: Any) -> Any:
            self._count[0] -= 1
            now = self._count[0] == 0
            if now and not self._after:
                self._fault()
            made = real(*values)
            if now and self._after:
                self._fault()
            return Faulty(made, PIECES, self._count, self._fault, self._after) if name == "fdopen" else made

        return call


def scenarios(folder: Path) -> Iterator[tuple[tuple[str, ...], bytes, list[Path]]]:
    """Calls that write two files or one, and these files."""
    plate = ("toy", "plate", "--width", "0.3 m", "--drawing", str(folder / "plate.svg"), "--json",
             "--output", str(folder / "plate.json"))  # fmt: skip
    rows = (*SPEED[:2], "--rows", "-", "--output", str(folder / "rows.csv"))
    yield plate, b"", [folder / "plate.svg", folder / "plate.json"]
    yield rows, b"distance[ft],friction\n" + b"60,0.7\n" * 3, [folder / "rows.csv"]


def leftovers(folder: Path) -> list[str]:
    return [path.name for path in folder.iterdir() if path.name.startswith(".")]


@pytest.mark.usefixtures("toy")
@pytest.mark.parametrize("existing", [True, False], ids=["over what is there", "new"])
@pytest.mark.parametrize("after", [False, True], ids=["before it works", "after it worked"])
@pytest.mark.parametrize("which", [0, 1], ids=["drawing and document", "rows"])
def test_every_step_fails_once(
    which: int, after: bool, existing: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    argv, given, targets = list(scenarios(tmp_path))[which]
    whole = {}
    assert run(*argv, stdin=given).status == 0
    whole = {target: target.read_text() for target in targets}
    for fault in FAULTS:
        for step in range(1, 1000):
            for target in targets:
                target.unlink(missing_ok=True)
                if existing:
                    target.write_text(OLD)
            done: list[str] = []

            def fail(fault: Callable[[], BaseException] = fault, done: list[str] = done) -> None:
                done.append("failed")
                raise fault()

            count = [step]
            with monkeypatch.context() as patch:
                patch.setattr(files, "os", Faulty(os, CALLS, count, fail, after))
                status = run(*argv, stdin=given).status
            if not done:
                assert status == 0
                break
            found = [target.read_text() if target.exists() else None for target in targets]
            for target, text in zip(targets, found, strict=True):
                assert text in (whole[target], OLD if existing else None), (step, status)
            new = [text == whole[target] for target, text in zip(targets, found, strict=True)]
            if not after:
                assert len(set(new)) == 1, "one file without the other"
            assert status != 0 or all(new)
            for name in leftovers(tmp_path):
                (tmp_path / name).unlink()
        else:
            raise AssertionError("no end of steps")
        assert step > 5


@pytest.mark.usefixtures("toy")
@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system cannot fork")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGKILL])
@pytest.mark.parametrize("which", [0, 1], ids=["drawing and document", "rows"])
def test_a_signal_at_every_step_leaves_whole_files_and_nothing_else(
    which: int, number: signal.Signals, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    argv, given, targets = list(scenarios(tmp_path))[which]
    assert run(*argv, stdin=given).status == 0
    whole = {target: target.read_text() for target in targets}
    for step in range(1, 1000):
        for target in targets:
            target.write_text(OLD)
        child = os.fork()
        if not child:
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            if number != signal.SIGKILL:
                signal.signal(number, signal.SIG_DFL)
            leave_quietly()
            fault = lambda: signal.raise_signal(number)  # noqa: E731
            monkeypatch.setattr(files, "os", Faulty(os, CALLS, [step], fault, False))
            os._exit(run_argv(list(argv), Terminal(io.BytesIO(given), io.BytesIO(), io.BytesIO(), {})))
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        if status == 0:
            break
        assert status == (130 if number in (signal.SIGINT, signal.SIGTERM) else -number)
        found = {target: target.read_text() for target in targets}
        if number == signal.SIGKILL:
            assert all(text in (OLD, whole[target]) for target, text in found.items())
            for name in leftovers(tmp_path):
                (tmp_path / name).unlink()
        else:
            assert found in (whole, dict.fromkeys(targets, OLD))
            assert leftovers(tmp_path) == []
    assert step > 5


def test_no_space_is_told_and_the_old_file_stays(tmp_path: Path) -> None:
    target = tmp_path / "a.csv"
    target.write_text(OLD)
    line = f"ulimit -f 1; exec {sys.executable} -m dynamics_cli skid speed --rows - --output {target}"
    rows = b"distance[ft],friction\n" + b"60,0.7\n" * 20_000
    done = subprocess.run(["sh", "-c", line], input=rows, capture_output=True, cwd=ROOT, check=False)
    assert done.returncode == 5
    assert b"File too large" in done.stderr
    assert target.read_text() == OLD
    assert leftovers(tmp_path) == []


def test_the_part_has_a_name_nobody_can_foresee_and_what_is_planted_is_not_followed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = []
    for _ in range(2):
        with Files([(str(tmp_path / "a.json"), b"new", "output")]):
            names += leftovers(tmp_path)
    assert len(set(names)) == 2
    assert all(len(name) > len(".dynamics-.part") + 15 for name in names)
    # Were the name foreseen after all, the file would still be made new, or nothing written.
    secret = tmp_path / "secret"
    secret.write_text("untouched")
    (tmp_path / names[0]).symlink_to(secret)
    foreseen = bytes.fromhex(names[0].removeprefix(".dynamics-").removesuffix(".part"))
    monkeypatch.setattr(files.os, "urandom", lambda size: foreseen)
    outcome = run(*SPEED, "--json", "--output", str(tmp_path / "a.json"))
    assert (outcome.status, (tmp_path / "a.json").read_text()) == (5, "new")
    assert secret.read_text() == "untouched"


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o664, 0o755])
def test_mode_and_owner_stay(mode: int, tmp_path: Path) -> None:
    target = tmp_path / "a.json"
    target.write_text(OLD)
    if os.geteuid() == 0:
        os.chown(target, 1234, 2345)
    target.chmod(mode)
    before = target.stat()
    with Files([(str(target), b"new", "output")]):
        (part,) = leftovers(tmp_path)
        # What is not yet there under its name is no more open to others than the file itself.
        assert stat.S_IMODE((tmp_path / part).stat().st_mode) == mode
    after = target.stat()
    assert (after.st_uid, after.st_gid, after.st_mode) == (before.st_uid, before.st_gid, before.st_mode)
    assert target.read_bytes() == b"new"


def test_a_new_file_has_the_mode_that_umask_leaves(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        assert run(*SPEED, "--output", str(tmp_path / "a.txt")).status == 0
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "a.txt").stat().st_mode) == 0o640


def test_a_read_only_file_is_refused(tmp_path: Path) -> None:
    target = tmp_path / "a.json"
    target.write_text(OLD)
    target.chmod(0o444)
    outcome = run(*SPEED, "--json", "--output", str(target))
    assert (outcome.status, outcome.error["parameter"]) == (5, "output")
    assert "read-only" in outcome.error["message"]
    assert target.read_text() == OLD


def test_a_name_of_255_bytes_and_names_that_are_links(tmp_path: Path) -> None:
    longest = tmp_path / ("a" * 250 + ".json")
    assert run(*SPEED, "--output", str(longest)).status == 0
    assert longest.exists()
    link = tmp_path / "link.json"
    link.symlink_to(longest)
    longest.write_text(OLD)
    assert run(*SPEED, "--output", str(link)).status == 0
    assert link.is_symlink()
    assert longest.read_text() != OLD


@pytest.mark.parametrize("name", ["-", "/dev/stdout"])
def test_a_dash_is_standard_output(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(*SPEED, "--json", "--output", name).out == run(*SPEED, "--json").out
    rows = b"distance[ft],friction\n60,0.7\n"
    one, other = (run(*SPEED[:2], "--rows", "-", *more, stdin=rows) for more in (("--output", name), ()))
    assert one.out == other.out
    (tmp_path / "a.json").write_text(run(*SPEED, "--json").out)
    assert run("report", "a.json", "--output", name).out == run("report", "a.json").out
    assert [path.name for path in tmp_path.iterdir()] == ["a.json"]


def test_a_device_is_written_and_stays(tmp_path: Path) -> None:
    assert run(*SPEED, "--output", os.devnull).status == 0
    assert not Path(os.devnull).is_file()


def test_of_two_files_the_first_is_put_back_where_the_second_cannot_be_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    first.write_text(OLD)

    def refuse(source: str, target: str) -> None:
        if target == str(second):
            raise PermissionError(errno.EPERM, "Operation not permitted")
        real(source, target)

    real = os.replace
    monkeypatch.setattr(files.os, "replace", refuse)
    with (
        pytest.raises(OutputError, match="Operation not permitted"),
        Files([(str(first), b"new", "drawing"), (str(second), b"new", "output")]),
    ):
        pass
    assert [path.name for path in tmp_path.iterdir()] == ["first"]
    assert first.read_text() == OLD
