"""Commands, documents and rows made up at random: whatever is written, no call may end as an internal error (status 1).

    python tests/fuzz/fuzz.py commands --seed 7 --seconds 600
    python tests/fuzz/fuzz.py rows --seed 7 --only 1234

Every case depends on the seed and its own number alone, so that one case can be made again.
"""

import argparse
import io
import json
import random
import re
import shlex
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from copy import deepcopy
from functools import cache
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
if __name__ == "__main__":
    sys.path.insert(0, str(ROOT))

from dynamics_cli import cli  # noqa: E402
from dynamics_cli.core.answering.task import Task  # noqa: E402
from dynamics_cli.core.terminal import Terminal  # noqa: E402

NUMBERS = ("0", "-0.0", "1", "-1", "0.5", "3", "12", "1e300", "-1e300", "1e-320", "1e999", "nan", "inf", "2/3", "1e17",
           "9007199254740993", "0x10", "1_000", "1,5", "½", "1e", "--", "7" * 400)  # fmt: skip
UNITS = ("", "m", "mm", "ft", "in", "kg", "lb", "s", "deg", "rad", "rpm", "km/h", "mph", "N*m", "kg*m^2", "m/s^2", "%",
         "ft;in", "m/0", "degC", "nosuch", "m^99", "1/m", "kg/m^3", "Hz", "g", "{x}")  # fmt: skip
SHAPES = ("{n} {u}", "{n}{u}", "{n} ± {m} {u}", "{n}..{m} {u}", "{n}, {m} {u}", "{n} {u} @ {m} deg", "[{n}, {m}] {u}",
          "uniform({n}, {m}) {u}", "{n} {u} {m} {u}", "{n}+/-{m} {u}", "({n})")  # fmt: skip
WORDS = ("", " ", "-", "--", "{x}", "{}", "%s", "@", "@none.json:speed", "@examples/flywheel.toml:mass", "a=b", "=",
         "a" * 3000, "\udcff", "𝒳", "²", "a\x00b", "a\nb", "[", "a[0", "a[²].b", "1:2:3", "=1+1", "true", "../..", "é",
         "<b>", "20:60", "x=1, y=2", "null", ";", ",", "first", "0,0,1")  # fmt: skip
NODES: tuple[Any, ...] = (
    None, True, 0, -1, 0.5, 1e308, 10**30, "", "x", "1 m", "{x}", [], {}, [1, 2], [[1]], {"value": 1},
    {"value": "x", "unit": 5}, {"value": [1, 2], "unit": "m", "std": 0.1}, {"value": 1, "unit": "m", "interval": 5},
    {"value": 1, "unit": "m", "distribution": "normal", "mean": 1, "std": -1}, "\ud800", [None], {"": {}},
)  # fmt: skip
SETTINGS = ("--json", "--explain", "--all", "--units=us", "--units=base", "--format=csv", "--format=markdown",
            "--digits=17", "--method=linear", "--method=monte-carlo", "--samples=500", "--coverage=0.5", "--limit=1",
            "--plot=-", "--to=x=m", "--model=x", "--sweep=x=1:2:3", "--seed=3", "--correlate=a,b=0.5", "--timing",
            "--output=/dev/null")  # fmt: skip
NUMBER = re.compile(r"(?<![\w.])\d+(\.\d+)?")
# What starts processes, takes memory or reads and writes where it likes is not left to chance.
LEFT_OUT = ("jobs", "samples", "rows", "output", "drawing", "plot", "input")
# A case that takes longer is told as slow, in seconds.
PATIENCE = 20


def run(argv: list[str], given: bytes = b"") -> tuple[int, str, str]:
    """A call's status and what it writes; rows give back what they were given, be it text or not."""
    out, err = io.BytesIO(), io.BytesIO()
    status = cli.run_argv(argv, Terminal(io.BytesIO(given), out, err, {}))
    return status, out.getvalue().decode(errors="backslashreplace"), err.getvalue().decode()


@cache
def tasks() -> list[Task]:
    names = [name for name in cli.FAMILIES if name != "accuracy"]
    return [task for name in names for task in cli.family(name).tasks.values()]


@cache
def calls(task: Task) -> list[list[str]]:
    """The examples of a task that are plain calls."""
    found = [shlex.split(example)[1:] for example in task.examples]
    return [one for one in found if not {f"--{name}" for name in LEFT_OUT} & set(one) and not {"|", ">"} & set(one)]


def value(chance: random.Random) -> str:
    if chance.random() < 0.3:
        return chance.choice(WORDS)
    n, m, u = chance.choice(NUMBERS), chance.choice(NUMBERS), chance.choice(UNITS)
    if chance.random() < 0.5:
        n, m = f"{chance.uniform(-5, 50):.4g}", f"{chance.uniform(0, 5):.3g}"
    return chance.choice(SHAPES).replace("{n}", n).replace("{m}", m).replace("{u}", u)


def command(chance: random.Random) -> list[str]:
    """A call: an example changed in some places, or options of a task with values at random."""
    task = chance.choice(tasks())
    examples = calls(task)
    argv = list(chance.choice(examples)) if examples and chance.random() < 0.8 else task.path.split()
    first = len(task.path.split())
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        places = [place for place in range(first, len(argv)) if not argv[place].startswith("--")]
        act = chance.random()
        if act < 0.55 and places:
            place = chance.choice(places)
            argv[place] = NUMBER.sub(lambda found: another(found.group(), chance), argv[place], count=1)
        elif act < 0.7 and places:
            argv[chance.choice(places)] = value(chance)
        elif act < 0.8 and len(argv) > first:
            del argv[chance.randrange(first, len(argv))]
        elif act < 0.9:
            argv.append(chance.choice(SETTINGS))
        else:
            names = [name for name in task.options if name not in LEFT_OUT] or ["x"]
            argv += [f"--{chance.choice(names)}", value(chance)]
    return argv


def another(number: str, chance: random.Random) -> str:
    """Another number in the place of one: smaller or larger, uncertain, or one that no calculation likes."""
    size = float(number) * chance.choice((0.0, -1.0, 0.5, 0.999, 1.0, 2.0, 10.0, 1e3, 1e-3, 1e9, 1e-9))
    wide = abs(size) * chance.choice((1e-9, 0.01, 0.3, 3.0)) + 1e-6
    return chance.choice(
        (f"{size:.6g}", f"{size:.6g} ± {wide:.3g}", f"{size:.6g}..{size + wide:.6g}", chance.choice(NUMBERS))
    )


@cache
def documents() -> list[str]:
    """The documents of some examples."""
    found = []
    for task in tasks():
        for argv in calls(task)[:1]:
            status, out, _ = run([*argv, "--json"])
            found += [out] if status == 0 and len(out) < 20_000 else []
    return found


def changed(node: Any, chance: random.Random) -> None:
    """Put something else in place of one part of a document, or take it away."""
    while True:
        keys = list(node) if isinstance(node, dict) else range(len(node))
        key = chance.choice(list(keys))
        inner = node[key]
        if isinstance(inner, dict | list) and inner and chance.random() < 0.8:
            node = inner
            continue
        if chance.random() < 0.2:
            del node[key]
        else:
            node[key] = deepcopy(chance.choice(NODES))
        return


def document(chance: random.Random) -> tuple[list[str], bytes]:
    """A result document with some parts changed, for a report or as the input of its own command."""
    made = json.loads(chance.choice(documents()))
    path = made["command"]
    for _ in range(chance.randint(1, 3)):
        if made:
            changed(made, chance)
    if chance.random() < 0.5:
        made = made.get("inputs", made)
        argv = [*path.split(), "--input", "-"]
    else:
        argv = ["report", "-", *chance.choice(([], ["--format", "html"]))]
    text = json.dumps(made)
    if chance.random() < 0.1:
        place = chance.randrange(len(text))
        text = text[:place] + chance.choice(("", '"', "}", "NaN", "9" * 5000, "\x00", "[" * 3000)) + text[place + 1 :]
    return argv, text.encode("utf-8", "surrogatepass")


def rows(chance: random.Random) -> tuple[list[str], bytes]:
    """A stream of cases for a task, as CSV or as objects, good cells and bad ones mixed."""
    task = chance.choice([task for task in tasks() if task.options])
    names = [name.replace("-", "_") for name in task.options if name not in LEFT_OUT]
    columns = chance.sample(names, min(len(names), chance.randint(1, 4)))
    good = [given for argv in calls(task) for given in argv[2:] if not given.startswith("--")] or ["1"]
    lines = []
    if chance.random() < 0.5:
        heads = [name + chance.choice(("", "", "[mm]", "[ft]", "[nosuch]", "[")) for name in columns]
        lines.append(",".join(heads) if chance.random() < 0.9 else value(chance))
    for _ in range(chance.randint(1, 6)):
        cells = [chance.choice(good) if chance.random() < 0.5 else value(chance) for _ in columns]
        if len(lines) and not lines[0].startswith("{"):
            lines.append(",".join(f'"{cell}"' if "," in cell else cell for cell in cells))
        else:
            given = [cell if chance.random() < 0.7 else chance.choice(NODES) for cell in cells]
            lines.append(json.dumps(dict(zip(columns, given, strict=True))))
    more = chance.choice(([], [], ["--format", "csv"], ["--format", "ndjson"], ["--units", "us"]))
    return [*task.path.split(), "--rows", "-", *more], "\n".join(lines).encode("utf-8", "surrogatepass") + b"\n"


MAKERS = {"commands": lambda chance: (command(chance), b""), "documents": document, "rows": rows}


class SlowError(BaseException):
    """A case took too long."""


@contextmanager
def patience() -> Iterator[None]:
    def stop(*_: object) -> None:
        raise SlowError

    before = signal.signal(signal.SIGALRM, stop)
    signal.alarm(PATIENCE)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def wrong(status: int, out: str, err: str) -> str:
    """What is wrong with an outcome: an internal error, also one told within a report or a row."""
    if status not in (0, 2, 3, 4, 5, 6) or "internal error" in out + err or "Traceback" in err:
        return f"status {status}: {(err + out).partition('internal error')[2][:300] or err[:300]}"
    return ""


def fuzz(kind: str, seed: int, seconds: float, most: int = 10**9, only: int | None = None) -> Iterator[str]:
    """What is wrong, as a line for each case."""
    end = time.monotonic() + seconds
    for number in range(most) if only is None else (only,):
        if only is None and time.monotonic() > end:
            return
        argv, given = MAKERS[kind](random.Random(f"{kind} {seed} {number}"))
        told = f"{kind} --seed {seed} --only {number}: {shlex.join(argv)} {given[:2000]!r}"
        try:
            with patience():
                reason = wrong(*run(argv, given))
        except SlowError:
            print("slow:", told, flush=True)
            continue
        except BaseException as error:
            reason = f"escaped: {error!r}"
        if reason:
            yield f"{told}\n    {reason}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kind", choices=MAKERS)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--only", type=int)
    asked = parser.parse_args()
    found = 0
    for line in fuzz(asked.kind, asked.seed, asked.seconds, only=asked.only):
        found += 1
        print(line, flush=True)
    return found > 0


if __name__ == "__main__":
    sys.exit(main())
