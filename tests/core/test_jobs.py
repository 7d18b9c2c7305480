"""`--jobs`: the same bytes in the same order by several processes."""

import os
import signal
import subprocess
import sys
import time
from multiprocessing import active_children
from pathlib import Path

import pytest
from harness import run

from dynamics_cli.core.batch.jobs import spread
from dynamics_cli.core.batch.stream import _pieces
from dynamics_cli.errors import FaultError, ManyErrors, UsageError

SPEED = ("skid", "speed")
pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="several processes need a system that forks")


@pytest.fixture
def many(tmp_path: Path) -> Path:
    """Rows of several makes, some of them wrong, more than several pieces of them."""
    file = tmp_path / "rows.csv"
    makes = ("{d},0.7,a", "{d},0.{f},b", "{d},-1,c", "x,0.5,d", "{d} m,0.6,e")
    # wrong ones are answered one by one, and a few in each piece tell as much as many
    lines = [makes[(i // 7) % (5 if i % 2000 < 200 else 2)].format(d=20 + i % 89, f=3 + i % 6) for i in range(60_000)]
    file.write_text("distance[ft],friction,note\n" + "\n".join(lines) + "\n")
    return file


@pytest.mark.parametrize("form", ["csv", "ndjson"])
def test_rows_are_the_same_bytes(many: Path, form: str) -> None:
    alone = run(*SPEED, "--rows", str(many), "--format", form)
    together = run(*SPEED, "--rows", str(many), "--format", form, "--jobs", "3")
    assert alone.status == together.status == 4
    assert alone.out == together.out
    assert alone.err == together.err


def test_names_that_pass_through_are_told_whichever_process_saw_them() -> None:
    rows = '{"distance": "60 ft", "friction": 0.7}\n' * 40_000 + '{"distance": "60 ft", "friction": 0.7, "grad": 1}\n'
    alone = run(*SPEED, "--rows", "-", stdin=rows)
    together = run(*SPEED, "--rows", "-", "--jobs", "2", stdin=rows)
    assert "'grad' is not a parameter" in alone.err
    assert together == alone


@pytest.mark.parametrize(("friction", "count"), [("0.7", 301), ("0.7 ± 0.05", 70)])
def test_sweeps_are_the_same_bytes(friction: str, count: int) -> None:
    argv = (*SPEED, "--distance", "60 ft", "--friction", friction, "--sweep", f"grade=-80 %:20 %:{count}", "--json")
    alone, together = run(*argv), run(*argv, "--jobs", "2")
    assert alone.status == 4
    assert alone == together


def test_rows_that_are_slow_alone_are_spread_and_written_a_few_at_a_time() -> None:
    blocks = [[b"%d" % row for row in range(150)], [None], [b"last"]]
    pieces = list(_pieces(iter(blocks), 2, singly=True))
    assert [len(piece) for piece in pieces] == [64, 64, 22, 1, 1]
    assert [line for piece in pieces for line in piece] == [line for block in blocks for line in block]
    rows = "distance[ft],friction\n" + "".join(f"{20 + i % 89},0.{3 + i % 6} ± 0.05\n" for i in range(70))
    alone = run(*SPEED, "--rows", "-", stdin=rows)
    assert run(*SPEED, "--rows", "-", "--jobs", "2", stdin=rows) == alone
    assert alone.out.count("\n") == 71


def test_one_case_needs_no_processes() -> None:
    outcome = run(*SPEED, "--distance", "60 ft", "--friction", "0.7", "--jobs", "2", "--json")
    assert (outcome.status, outcome.error["parameter"]) == (2, "jobs")


@pytest.mark.parametrize("text", ["0", "-1", "two", "1.5", ""])
def test_what_is_no_number_of_processes_is_refused(text: str) -> None:
    outcome = run(*SPEED, "--rows", "-", "--jobs", text, "--json")
    assert (outcome.status, outcome.error["parameter"]) == (2, "jobs")


def test_all_is_every_processor() -> None:
    assert run(*SPEED, "--rows", "-", "--jobs", "all", stdin="distance[ft],friction\n60,0.7\n").status == 0


def test_order_is_kept_and_work_is_never_far_ahead() -> None:
    asked: list[int] = []

    def pieces():
        for i in range(200):
            asked.append(i)
            yield i

    for place, result in enumerate(spread(lambda piece: piece * piece, pieces(), 2)):
        assert result == place * place
        assert len(asked) <= place + 8


def test_an_error_in_a_process_comes_back_in_its_turn() -> None:
    results = spread(lambda piece: 1 // piece, [1, 2, 0, 4], 2)
    assert [next(results), next(results)] == [1, 0]
    with pytest.raises(ZeroDivisionError):
        next(results)


def test_an_error_that_cannot_be_sent_says_what_it_was() -> None:
    def work(piece: int) -> int:
        raise ManyErrors([UsageError(f"piece {piece} is wrong")])

    with pytest.raises(FaultError, match="ManyErrors: piece 1 is wrong"):
        list(spread(work, [1, 2], 2))


def test_a_process_ended_from_outside_is_told() -> None:
    def work(piece: int) -> int:
        if piece == 1:
            os.kill(os.getpid(), signal.SIGKILL)
        return piece

    with pytest.raises(FaultError, match="killed from outside"):
        list(spread(work, range(20), 2))


def test_whoever_stops_early_never_waits_for_a_result_half_sent() -> None:
    """Results larger than a pipe holds: the processes are ended while they are writing them."""
    for _ in range(20):
        results = spread(lambda piece: bytes(4_000_000), range(10), 2)
        next(results)
        results.close()
    assert not active_children()


def _start(many: Path, *more: str) -> "subprocess.Popen[bytes]":
    command = [sys.executable, "-m", "dynamics_cli", *SPEED, "--rows", str(many), "--jobs", "2", *more]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def test_a_pipe_closed_early_ends_it_quietly(many: Path) -> None:
    process = _start(many)
    assert process.stdout is not None
    process.stdout.readline()
    process.stdout.close()
    assert process.wait(20) == 0
    assert process.stderr is not None
    assert process.stderr.read() == b""


def test_an_interruption_ends_all_of_it(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    process = _start(pipe)
    with pipe.open("w") as rows:
        rows.write("distance[ft],friction\n" + "60,0.7\n" * 100_000)
        rows.flush()
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        assert process.wait(20) == 130
    assert process.stderr is not None
    assert b"Traceback" not in process.stderr.read()
