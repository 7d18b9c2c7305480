"""A system without fork, interval timers and POSIX signals, as Windows is: simulated, by taking them away first."""

import subprocess
import sys

LACKING = """
import os, signal, sys
for name in ("fork", "set_blocking", "sched_getaffinity", "getuid", "killpg", "fchmod"):
    if hasattr(os, name):
        delattr(os, name)
kept = {"SIGINT", "SIGTERM", "SIGABRT", "SIGFPE", "SIGILL", "SIGSEGV"}
for module in (signal, sys.modules["_signal"]):
    for name in list(vars(module)):
        lacking = ("setitimer", "getitimer", "alarm", "pthread_sigmask", "pthread_kill", "siginterrupt")
        if name in lacking or (name.startswith("SIG") and name not in kept and not name.startswith("SIG_")):
            delattr(module, name)
for name in ("fcntl", "resource", "termios", "pwd", "grp"):
    sys.modules[name] = None
from dynamics_cli.cli import main
sys.exit(main())
"""


def run_there(*argv: str, stdin: str = "") -> "subprocess.CompletedProcess[str]":
    command = [sys.executable, "-X", "utf8", "-c", LACKING, *argv]
    return subprocess.run(command, input=stdin, capture_output=True, text=True, check=False)


def test_jobs_fall_back_to_one_process() -> None:
    rows = "distance[ft],friction\n" + "".join(f"{60 + i},0.7\n" for i in range(300))
    done = run_there("skid", "speed", "--rows", "-", "--jobs", "4", stdin=rows)
    assert (done.returncode, done.stderr) == (0, "")
    assert len(done.stdout.splitlines()) == 301


def test_a_time_limit_is_refused_with_its_reason() -> None:
    done = run_there("skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--time-limit", "1 s")
    assert done.returncode == 2
    assert "--time-limit works" in done.stderr
    assert "Traceback" not in done.stderr


def test_answers_are_utf_8() -> None:
    done = run_there("skid", "speed", "--distance", "60 ft", "--friction", "0.7 ± 0.03")
    assert done.returncode == 0
    assert "work–energy" in done.stdout
