"""Rows a second of every task by `--rows`, from CSV and from NDJSON; run it with this Python's interpreter.

    python tests/benchmarks/rows_of_tasks.py [--rows 2000 20000] [--rounds 1] [--only "gear spur"] [--profile]

Each figure is rows a second of processor time of a whole process with its output discarded, the best of its rounds. The
rows are the example of a task with every number moved a little, the same in every run. The last column is the rate
beside GNU units' conversions a second, where it is installed: a case is to cost no more than a conversion. `--profile`
shows where a stream spends its time.
"""

# ruff: noqa: E402
import argparse
import cProfile
import json
import os
import pstats
import random
import re
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.inputs.settings import UNIVERSAL_OPTIONS
from dynamics_cli.core.inputs.specification import Field, Leaf, Many, Record
from dynamics_cli.registry import FAMILIES

# A number of a call, but no exponent of a unit.
NUMBER = re.compile(r"(?<![\w^.])-?\d+\.?\d*(?:e-?\d+)?")
LIST = re.compile(rf"({NUMBER.pattern})((?:, ?{NUMBER.pattern})*)(?: +([^\d,@±][^,@±]*))?")
# The methods of tasks whose rows are measured.
METHODS = ("closed form", "closed-form Routh–Keller path", "Jacobi rotations", "series, no iteration")
# A row of the first two is a design or a drawing; of the next two not every row is a body's; of the others each has
# postures, segments or a table of its own, and is answered alone.
LEFT_OUT = (
    "cam size", "gear profile", "spin free", "spin shaft", "robot inverse", "robot path", "robot workspace",
    "human segments", "human posture", "human gait", "human fall",
)  # fmt: skip
# What such parameters say is the same in all rows.
FIXED = ("whole", "text", "flag", "unit", "file")
# A number is moved by so much of itself, as no row may leave what its task admits.
SPREAD = 0.02


def moved(number: float, draw: random.Random) -> float:
    """A number a little larger or smaller, of no more digits than people write; zero stays."""
    return float(f"{number * (1.0 + SPREAD * (draw.random() - 0.5)):.5g}")


def tasks() -> Iterator[Task]:
    """Every task of the program."""
    for name, entry in FAMILIES.items():
        families = __import__(entry.module, fromlist=["FAMILIES"]).FAMILIES
        if name in families:
            yield from families[name].tasks.values()


def calls() -> list[str]:
    """The first example of every task in closed form whose parameters are cells, not a scene or phases."""
    chosen = []
    for task in tasks():
        text = task.examples[0].removeprefix("dynamics ")
        closed = any(model.method in METHODS for model in task.models) and task.path not in LEFT_OUT
        if closed and not task.listing and " --format " not in text:
            call = Call(text)
            if any(varies and NUMBER.search(given) for _, given, varies in call.given) and call.complete:
                chosen.append(text)
    return chosen


class Call:
    """One task with the parameters of its call, to be written as rows; `complete` if all of them are cells."""

    def __init__(self, text: str) -> None:
        rest = shlex.split(text)
        self.task = next(task for task in tasks() if rest[: len(task.path.split())] == task.path.split())
        self.command = self.task.path.split()
        self.given: list[tuple[tuple[str | int, ...], str, bool]] = []
        self.complete = True
        del rest[: len(self.command)]
        fields = iter(self.task.specification.words)
        while rest:
            word = rest.pop(0)
            option = self.task.options.get(word.removeprefix("--"))
            if not word.startswith("--"):
                self._word(next(fields), [word, *rest], rest)
            elif option is None or option.flag:
                takes = option is None and UNIVERSAL_OPTIONS[word[2:]][0] != "flag"
                self.command += [word, rest.pop(0)] if takes else [word]
            else:
                self.complete &= option.leaf is not None
                self.given.append((option.path, rest.pop(0), option.leaf is None or option.leaf.kind.form not in FIXED))

    def _word(self, field: Field, words: list[str], rest: list[str]) -> None:
        node = field.node
        self.complete &= not isinstance(node, Record)
        if isinstance(node, Many):
            several = [word for word in words if not word.startswith("--")]
            self.given += [((field.key, index), text, True) for index, text in enumerate(several)]
            del rest[: len(several) - 1]
        else:
            varies = not isinstance(node, Leaf) or node.kind.form not in FIXED
            self.given.append(((getattr(node, "key", None) or field.key,), words[0], varies))

    def row(self, draw: random.Random) -> dict[str, object]:
        """One row as an object."""
        made: dict[str, object] = {}
        for path, text, varies in self.given:
            inner: dict = made  # type: ignore[type-arg]
            value = self._value(text, draw) if varies else (int(text) if text.isdigit() else text)
            if isinstance(path[-1], int):
                made.setdefault(path[0], []).append(value)  # type: ignore[attr-defined]
                continue
            for step in path[:-1]:
                inner = inner.setdefault(step, {})
            inner[path[-1]] = value
        return made

    @staticmethod
    def _value(text: str, draw: random.Random) -> object:
        """A value as people write it: a number, a list of them, either with a unit, or a text with numbers in it."""
        changed = NUMBER.sub(lambda match: f"{moved(float(match[0]), draw):g}", text)
        matrix, _, unit = changed.rpartition("]")
        if matrix:
            return {"value": json.loads(matrix + "]"), "unit": unit.strip()}
        several = LIST.fullmatch(changed)
        if several is None:
            return changed
        numbers = [float(number) for number in f"{several[1]}{several[2]}".split(",")]
        value = numbers if several[2] else numbers[0]
        return {"value": value, "unit": several[3]} if several[3] else value

    def cells(self, row: dict[str, object]) -> list[tuple[str, str]]:
        """One row as columns' heads and cells."""
        made: list[tuple[str, str]] = []

        def walk(node: object, path: str, unit: str) -> None:
            if isinstance(node, dict) and "value" in node:
                walk(node["value"], path, f"[{node['unit']}]")
            elif isinstance(node, dict):
                for key, item in node.items():
                    walk(item, f"{path}.{key}".lstrip("."), "")
            elif isinstance(node, list):
                for index, item in enumerate(node):
                    walk(item, f"{path}[{index}]", unit)
            else:
                made.append((path + unit, f"{node:g}" if isinstance(node, float) else str(node)))

        walk(row, "", "")
        return made

    def write(self, count: int, folder: Path) -> dict[str, Path]:
        """Files of so many rows, by format."""
        draw = random.Random(20240229)
        files = {form: folder / f"{'-'.join(self.command)}-{count}.{form}" for form in ("csv", "ndjson")}
        with files["csv"].open("w") as cells, files["ndjson"].open("w") as objects:
            for index in range(count):
                row = self.row(draw)
                pairs = self.cells(row)
                if not index:
                    cells.write(",".join(head for head, _ in pairs) + "\n")
                cells.write(",".join(f'"{cell}"' if "," in cell else cell for _, cell in pairs) + "\n")
                objects.write(json.dumps(row) + "\n")
        return files


def seconds(command: list[str], source: Path | None = None) -> float:
    """Processor seconds of a whole process: what others do on the machine hardly counts."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    with open(source or os.devnull, "rb") as given, open(os.devnull, "wb") as sink:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(command, stdin=given, stdout=sink, stderr=subprocess.PIPE, env=environment, check=False)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    took = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    if done.returncode:
        print(f"  {' '.join(command[3:5])} ended with status {done.returncode}: {done.stderr.decode()[:200]}")
    return took


def conversions(count: int, folder: Path) -> float:
    """GNU units' conversions a second, 0 without it."""
    units = shutil.which("units")
    if not units:
        return 0.0
    queries = folder / "units"
    queries.write_text("".join(f"{index / 100:g} mph\nft/s\n" for index in range(count)))
    return count / seconds([units, "-t", "-o", "%.17g"], queries)


def profile(call: Call, file: Path) -> None:
    """Where one stream's time goes."""
    from dynamics_cli import cli
    from dynamics_cli.core.terminal import Terminal

    watch = cProfile.Profile()
    with open(os.devnull, "wb") as sink, open(os.devnull, "rb") as nothing:
        terminal = Terminal(nothing, sink, sink, {})
        watch.runcall(cli.run_argv, [*call.command, "--rows", str(file)], terminal)
    pstats.Stats(watch).sort_stats("tottime").print_stats(35)


def main() -> None:
    parser = argparse.ArgumentParser(description="Rows a second of every task.")
    parser.add_argument("--rows", type=int, nargs="+", default=[2000, 20000])
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--only", default="")
    parser.add_argument("--profile", default="", choices=("", "csv", "ndjson"))
    asked = parser.parse_args()
    subprocess.run([sys.executable, "-m", "compileall", "-q", str(ROOT / "dynamics_cli")], check=False)
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        rate = conversions(max(asked.rows), folder)
        heads = "".join(f"{f'{form} {count:,}':>16}" for count in asked.rows for form in ("csv", "ndjson"))
        print(f"{'rows a second':22}{heads}  of GNU units' {rate:,.0f}/s")
        for text in calls():
            if not text.startswith(asked.only):
                continue
            call = Call(text)
            line = f"{call.task.path:22}"
            best = 0.0
            for count in asked.rows:
                for form, file in call.write(count, folder).items():
                    if asked.profile:
                        if form == asked.profile:
                            profile(call, file)
                        continue
                    command = [sys.executable, "-m", "dynamics_cli", *call.command, "--rows", str(file)]
                    best = count / min(seconds(command) for _ in range(asked.rounds))
                    line += f"{best:16,.0f}"
            print(line + (f"{best / rate:8.2f} x" if rate else ""), flush=True)


if __name__ == "__main__":
    main()
