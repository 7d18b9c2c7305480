"""Rows a second of `--rows` against GNU units' conversions a second, and memory; run it with this Python's interpreter.

    python tests/benchmarks/rows.py [--rows 1000000] [--rounds 3] [--memory 10000000]

Both are whole processes with their output discarded, run in turn; each figure is the best of its rounds. The data are
the same in every run. Without `units` on the path only the rows a second are printed. `--memory N` adds the most memory
that a stream of N rows from a pipe takes.
"""

import argparse
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAIRS = (
    ("mph", "ft/s"), ("lb", "kg"), ("ft", "m"), ("psi", "kPa"), ("in", "mm"),
    ("km/h", "mph"), ("hp", "kW"), ("slug", "lb"), ("yd", "ft"), ("nmi", "mi"),
)  # fmt: skip
# GNU units' names for the same units.
NAMES = {"km/h": "km/hour", "lb": "pound", "nmi": "nauticalmile", "yd": "yard", "hp": "horsepower"}
GOALS = {"text": 6.0, "fixed": 10.0, "csv": 10.0, "ndjson": 8.0}
COMMANDS = {
    "text": ("convert",),
    "fixed": ("convert", "mph", "ft/s"),
    "csv": ("skid", "speed"),
    "ndjson": ("skid", "speed"),
}


def write_data(folder: Path, count: int) -> None:
    """The rows of every case, and GNU units' queries: have and want on two lines."""
    generator = random.Random(20240229)
    with (
        (folder / "text").open("w") as text,
        (folder / "fixed").open("w") as fixed,
        (folder / "csv").open("w") as cells,
        (folder / "ndjson").open("w") as objects,
        (folder / "units").open("w") as queries,
    ):
        cells.write("distance[ft],friction\n")
        for index in range(count):
            number = f"{generator.randint(1, 99999) / 100:g}"
            friction = f"{generator.randint(30, 90) / 100:g}"
            source, target = PAIRS[index % len(PAIRS)]
            text.write(f"{number} {source} {target}\n")
            fixed.write(f"{number}\n")
            cells.write(f"{number},{friction}\n")
            objects.write(f'{{"distance":{{"value":{number},"unit":"ft"}},"friction":{friction}}}\n')
            queries.write(f"{number} {NAMES.get(source, source)}\n{NAMES.get(target, target)}\n")


def environment() -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": str(ROOT)}


def timed(command: list[str], file: Path | None = None) -> tuple[float, float]:
    """Seconds and megabytes of a process that reads a file."""
    with open(file or os.devnull, "rb") as source, open(os.devnull, "wb") as sink:
        start = time.perf_counter()
        process = subprocess.Popen(command, stdin=source, stdout=sink, stderr=sink, env=environment())
        _, status, usage = os.wait4(process.pid, 0)
        took = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit(f"{' '.join(command)} ended with status {process.returncode}")
    return took, usage.ru_maxrss / 1024


def program(case: str, file: str) -> list[str]:
    return [sys.executable, "-m", "dynamics_cli", *COMMANDS[case], "--rows", file]


def compare(folder: Path, count: int, rounds: int) -> None:
    """One line a case: rows a second, ratio to GNU units in the same round-robin, memory."""
    units = shutil.which("units")
    best: dict[str, float] = {}
    memory: dict[str, float] = {}
    for _ in range(rounds):
        if units:
            best["units"] = min(best.get("units", 1e9), timed([units, "-t", "-o", "%.17g"], folder / "units")[0])
        for case in COMMANDS:
            took, size = timed(program(case, str(folder / case)))
            best[case] = min(best.get(case, 1e9), took)
            memory[case] = max(memory.get(case, 0.0), size)
    if units:
        print(f"{'GNU units':10} {count / best['units']:12,.0f} /s")
    for case in COMMANDS:
        ratio = f"{best['units'] / best[case]:6.1f} x (goal {GOALS[case]:.0f} x)" if units else ""
        print(f"{case:10} {count / best[case]:12,.0f} /s  {ratio:24} {memory[case]:6.1f} MB")


def measure_memory(count: int) -> None:
    """The most memory of long streams from a pipe."""
    lines = {
        "text": b"60.25 mph ft/s\n",
        "csv": b"60.25,0.7\n",
        "ndjson": b'{"distance":{"value":60.25,"unit":"ft"},"friction":0.7}\n',
    }
    for case, line in lines.items():
        with open(os.devnull, "wb") as sink:
            process = subprocess.Popen(program(case, "-"), stdin=subprocess.PIPE, stdout=sink, env=environment())
            assert process.stdin is not None
            if case == "csv":
                process.stdin.write(b"distance[ft],friction\n")
            for _ in range(count // 10000):
                process.stdin.write(line * 10000)
            process.stdin.close()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        print(f"{case:10} {count:,} rows: {usage.ru_maxrss / 1024:.1f} MB, status {process.returncode}")


def main() -> None:
    parser = argparse.ArgumentParser(description="Rows a second against GNU units.")
    parser.add_argument("--rows", type=int, default=1_000_000)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--memory", type=int, default=0)
    asked = parser.parse_args()
    # Interpreters that find no bytecode compile first, and that is not what is measured.
    subprocess.run([sys.executable, "-m", "compileall", "-q", str(ROOT / "dynamics_cli")], check=False)
    with tempfile.TemporaryDirectory() as folder:
        write_data(Path(folder), asked.rows)
        compare(Path(folder), asked.rows, asked.rounds)
    if asked.memory:
        measure_memory(asked.memory)


if __name__ == "__main__":
    main()
