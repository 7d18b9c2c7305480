"""Rows a second of every task by `--rows`, from CSV and from NDJSON; run it with this Python's interpreter.

    python tests/benchmarks/rows_of_tasks.py [--rows 2000 20000] [--rounds 1] [--only "gear spur"] [--profile]

Each figure is rows a second of processor time of a whole process with its output discarded, the best of its rounds. The
rows are the example of a task with every number moved a little, the same in every run. The last column is the rate
beside GNU units' conversions a second, where it is installed: a case is to cost no more than a conversion. `--profile`
shows where a stream spends its time.
"""

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
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# The call of every task measured: what it says in numbers varies from row to row.
CALLS = (
    'skid speed --distance "60 ft" --friction 0.7',
    'skid distance --speed "50 mph" --friction 0.7 --grade "-3 %"',
    'skid friction --speed "30 mph" --distance "43 ft"',
    'skid drag-factor --friction 0.7 --grade "-4 %" --braking "85 %"',
    'skid stop --speed "50 km/h" --friction 0.75 --reaction-time "1.0 s" --build-up-time "0.2 s"',
    'skid yaw --chord "100 ft" --middle-ordinate "3.5 ft" --friction 0.72',
    'skid vault --distance "18 m" --rise "-3 m" --take-off "6 deg"',
    'skid pedestrian --throw-distance "25 m" --friction 0.66',
    'skid avoid --speed "62 km/h" --speed-limit "50 km/h" --sight-distance "32 m" --reaction-time "1.2 s"'
    " --friction 0.75",
    'skid spin --rotation "210 deg" --rolling-drag "10 %" --distance "18 m" --friction 0.65',
    'impact central --first-mass "2 kg" --first-velocity "3 m/s" --second-mass "1 kg" --restitution 0.5',
    'impact oblique --first-mass "1 kg" --first-velocity "3, 0.2 m/s" --second-mass "1 kg"'
    ' --second-velocity "-1, 0.4 m/s" --normal "2 deg" --restitution 0.95',
    'impact drop --height "1 m" --rebound-height "0.64 m"',
    'impact pendulum --shot-mass "10 g" --block-mass "2 kg" --rise "10 cm"',
    'impact seize --plate-mass "1 kg" --side "1 m" --spin "10 rad/s" --seized edge',
    'impact step --radius "300 mm" --height "100 mm"',
    'impact momentum --first-mass "1500 kg" --first-approach-heading "0.1 deg" --first-exit-speed "8 m/s"'
    ' --first-exit-heading "40 deg" --second-mass "1200 kg" --second-approach-heading "90 deg"'
    ' --second-exit-speed "9 m/s" --second-exit-heading "37 deg"',
    'impact crush --first-mass "1500 kg" --first-energy "62 kJ" --second-mass "1200 kg" --second-ees "30 km/h"'
    " --restitution 0.15",
    'impact yaw-inertia --mass "1500 kg" --wheelbase "2.7 m" --length "4.6 m" --width "1.8 m"',
    'impact planar --first-mass "1500 kg" --first-inertia "2500 kg*m^2" --first-velocity "15, 0.1 m/s"'
    ' --first-lever "2, -0.4 m" --second-mass "1200 kg" --second-inertia "1800 kg*m^2"'
    ' --second-velocity "0.1, 10 m/s" --second-lever "-0.8, 0.5 m" --normal "10 deg" --friction 0.5 --restitution 0.1',
    'inertia shape cylinder --radius "40 mm" --length "120 mm" --material steel',
    'inertia tensor --moments "2, 2.2, 3 kg*m^2" --products "-0.5, 0.1, 0.2 kg*m^2"',
    'inertia torque --tensor "[[0.02, 0, 0], [0, 0.03, 0], [0, 0, 0.04]] kg*m^2" --angular-velocity "1, 300, 2 rad/s"',
    'cam rise --law cycloidal --lift "20 mm" --span "90 deg" --at "30 deg"',
    'gear spur --teeth 12 --module "3 mm" --profile-shift 0.6',
    'gear helical --teeth 12 --module "3 mm" --helix-angle "30 deg" --profile-shift 0.09809',
    'gear involute --angle "20 deg"',
    'gear pair --first-teeth 12 --second-teeth 24 --module "3 mm" --first-profile-shift 0.6'
    " --second-profile-shift 0.36",
    'gear rack --teeth 12 --module "3 mm" --profile-shift 0.6',
    'gear bevel --first-teeth 20 --second-teeth 40 --module "3 mm" --face-width "22 mm"',
    'gear crossed --first-teeth 15 --first-helix-angle "20 deg" --first-profile-shift 0.4 --second-teeth 24'
    ' --second-helix-angle "30 deg" --second-profile-shift 0.2 --module "3 mm"',
    'gear worm --threads 2 --teeth 30 --module "3 mm" --worm-diameter "44 mm"',
    'gear wheels --first-diameter "100 mm" --second-diameter "300 mm"',
    'gear measure --teeth 24 --module "3 mm" --profile-shift 0.4',
    "coords 3 1 4 --from cartesian --into spherical",
)
NUMBER = re.compile(r"-?\d+\.?\d*")
# A number is moved by so much of itself, as no row may leave what its task admits.
SPREAD = 0.02


def moved(number: float, draw: random.Random) -> float:
    """A number a little larger or smaller, of no more digits than people write; zero stays."""
    return float(f"{number * (1.0 + SPREAD * (draw.random() - 0.5)):.5g}")


class Call:
    """One task with the parameters of a call, to be written as rows."""

    def __init__(self, text: str) -> None:
        from dynamics_cli.registry import FAMILIES

        words = shlex.split(text)
        tasks = __import__(FAMILIES[words[0]].module, fromlist=["FAMILIES"]).FAMILIES[words[0]].tasks
        self.task = tasks.get(words[1]) or tasks[""]
        self.command = self.task.path.split()
        rest = words[len(self.command) :]
        self.given: list[tuple[tuple[str, ...], str, bool]] = []
        places = iter(self.task.specification.words)
        while rest:
            if rest[0].startswith("--"):
                option = self.task.options[rest[0][2:]]
                varies = option.leaf is None or option.leaf.kind.form not in ("whole", "text", "flag")
                self.given.append((option.path, rest[1], varies))
                rest = rest[2:]
            else:
                field = next(places)
                key = getattr(field.node, "key", None) or field.key
                self.given.append(((key,), rest.pop(0), True))

    def row(self, draw: random.Random) -> dict[str, object]:
        """One row as an object."""
        made: dict[str, object] = {}
        for path, text, varies in self.given:
            inner: dict = made  # type: ignore[type-arg]
            for step in path[:-1]:
                inner = inner.setdefault(step, {})
            inner[path[-1]] = self._value(text, draw) if varies else (int(text) if text.isdigit() else text)
        return made

    @staticmethod
    def _value(text: str, draw: random.Random) -> object:
        numbers = NUMBER.findall(text.partition("kg")[0])
        if not NUMBER.match(text.lstrip("[")):
            return text
        unit = re.sub(r"^[-\d.,\[\]\s]+", "", text)
        if text.startswith("["):
            value: object = json.loads(
                NUMBER.sub(lambda match: repr(moved(float(match[0]), draw)), text[: text.rindex("]") + 1])
            )
        elif "," in text:
            value = [moved(float(number), draw) for number in numbers]
        else:
            value = moved(float(numbers[0]), draw)
        return {"value": value, "unit": unit} if unit else value

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
                cells.write(",".join(cell for _, cell in pairs) + "\n")
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
    sys.path.insert(0, str(ROOT))
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
        for text in CALLS:
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
    sys.path.insert(0, str(ROOT))
    main()
