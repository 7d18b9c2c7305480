"""One table of speed: ours, the peer, the limit and the ratio, in one run; run it with this Python's interpreter.

    python tests/benchmarks/table.py [--rows 100000] [--rounds 3] [--triangles N] [--only start,rows,uncertain,...]

Each figure is the best of its rounds, ours and the peer's in turn; bytecode is compiled first. A peer that is not
installed (GNU units, pycrash, trimesh) leaves its columns empty. The limit is the least ratio that the project asks for
(of times and exponents, the largest); what misses it is marked. README's and the pages' figures come from this table.
"""

# ruff: noqa: E402
import argparse
import contextlib
import io
import math
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):
    os.environ.setdefault(name, "1")
HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(ROOT), str(HERE)]

import growth
import rows_of_tasks

# Least ratios to GNU units' conversions a second, and to impacts a second of pycrash in a loop.
UNITS_LIMITS = {"skid speed, csv": 10.0, "skid speed, ndjson": 8.0, "convert": 10.0}
CRASH = ("impact planar", "impact momentum", "impact central")
CRASH_LIMIT = 5.0
# A stream that takes more seconds is measured once.
LONG = 10.0
# What has no peer: rows a second.
ROWS_LIMITS = {"gear pair": 1e4, "inertia shape": 1e4, "cam rise": 1e4}
PLANAR = (
    ("--friction", "0.5", "0.5 ± 0.05"),
    ("--restitution", "0.1", "0.1 ± 0.02"),
    ("--normal", "10 deg", "10 ± 3 deg"),
    ("--second-mass", "1200 kg", "1200 ± 30 kg"),
    ("--first-lever", "2, -0.4 m", "2, -0.4 ± 0.05 m"),
    ("--second-velocity", "0, 10 m/s", "0, 10 ± 0.5 m/s"),
)
PLANAR_REST = (
    "--first-mass", "1500 kg", "--first-inertia", "2500 kg*m^2", "--first-velocity", "15, 0 m/s",
    "--second-inertia", "1800 kg*m^2", "--second-lever", "-0.8, 0.5 m",
)  # fmt: skip
MOMENTUM = (
    "--first-mass", "1500 ± 40 kg", "--first-approach-heading", "0 ± 2 deg", "--first-exit-speed", "8 ± 0.4 m/s",
    "--first-exit-heading", "40 ± 3 deg", "--second-mass", "1200 kg", "--second-approach-heading", "90 deg",
    "--second-exit-speed", "9 ± 0.4 m/s", "--second-exit-heading", "37 ± 3 deg",
)  # fmt: skip

STARTS = (
    (("convert", "60", "mph", "ft/s"), 2.2),
    (("skid", "speed", "--distance", "60 ft", "--friction", "0.7"), 2.8),
    (("vec", "resultant", "20 N @ 30 deg", "15 N @ 110 deg"), 2.2),
    (("orient", "convert", "--euler-angles", "181, 5, 10 deg", "--euler-order", "zyx"), 2.2),
    (("path", "rectilinear", "--start-speed", "20 m/s", "--acceleration", "-4 m/s^2", "--distance", "48 m"), 2.2),
    (
        ("linkage", "four-bar", "--crank", "40 mm", "--coupler", "120 mm", "--rocker", "80 mm", "--ground", "100 mm",
         "--crank-angle", "70 deg"),
        2.2,
    ),
    (("balance", "grade", "--mass", "40 kg", "--speed", "3000 rpm", "--grade", "6.3 mm/s"), 2.2),
    (("inertia", "shape", "cylinder", "--radius", "40 mm", "--length", "120 mm", "--material", "steel"), 2.2),
    (("inertia", "tensor", "--moments", "2, 2, 3 kg*m^2", "--products", "-0.5, 0, 0 kg*m^2"), 2.2),
    (("cam", "rise", "--law", "cycloidal", "--lift", "20 mm", "--span", "90 deg", "--at", "30 deg"), 2.2),
    (("gear", "spur", "--teeth", "12", "--module", "3 mm", "--profile-shift", "0.6"), 2.2),
    (("vibration", "free", "--mass", "2 kg", "--stiffness", "0.05 N/mm", "--damping", "4 N*s/m"), 2.2),
    (("stability", "routh", "s^4 + 10s^3 + 35s^2 + 50s + 24"), 2.2),
    (("pendulum", "simple", "--length", "1 m", "--amplitude", "60 deg", "--mass", "2 kg"), 2.2),
    (
        ("impact", "central", "--first-mass", "2 kg", "--first-velocity", "3 m/s", "--second-mass", "1 kg",
         "--restitution", "0.5"),
        2.2,
    ),
)  # fmt: skip

# What is measured, ours, the peer's figure and name, the limit, and whether ratios below it are the good ones.
Line = tuple[str, float, float, str, float, bool]


# The `dynamics` command as installers write it; pip before 25.1 adds an import of `re`, and `python -m` as much, 4 ms.
INSTALLED = "import sys\nfrom dynamics_cli.__main__ import script\nif __name__ == '__main__':\n    sys.exit(script())\n"


def process(*arguments: str, how: tuple[str, ...] = ("-m", "dynamics_cli")) -> float:
    """Processor seconds of a whole call."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [sys.executable, *how, *arguments]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def least(call: Callable[[], float], rounds: int) -> float:
    return min(call() for _ in range(rounds))


def impacts_of_peer() -> float:
    """Planar impacts a second of pycrash in a Python loop, 0 where it is not installed."""
    with contextlib.redirect_stdout(io.StringIO()):
        try:
            import impact_planar

            static = impact_planar.peer()
            if static is None:
                return 0.0
            one, two, x, y, inputs = impact_planar.vehicles(impact_planar.CASE)
            return 1.0 / impact_planar.best(lambda: static(one, two, x, y, inputs))
        except Exception:
            return 0.0


def streams(count: int, rounds: int, folder: Path) -> Iterator[Line]:
    """Rows a second of every task."""
    crash = impacts_of_peer()
    (folder / "convert").write_text("".join(f"{index % 9999 / 100:g}\n" for index in range(count)))
    convert = [sys.executable, "-m", "dynamics_cli", "convert", "mph", "ft/s", "--rows", str(folder / "convert")]
    took, units = math.inf, 0.0
    for _ in range(rounds):
        units = max(units, rows_of_tasks.conversions(count, folder))
        took = min(took, rows_of_tasks.seconds(convert))
    yield "convert, rows/s", count / took, units, "GNU units", UNITS_LIMITS["convert"], True
    for text in rows_of_tasks.calls():
        call = rows_of_tasks.Call(text)
        path = call.task.path
        for form, file in call.write(count, folder).items():
            command = [sys.executable, "-m", "dynamics_cli", *call.command, "--rows", str(file)]
            took, units = math.inf, 0.0
            for _ in range(rounds):
                units = max(units, rows_of_tasks.conversions(min(count, 20_000), folder))
                took = min(took, rows_of_tasks.seconds(command))
                if took > LONG:
                    break
            file.unlink()
            what = f"{path}, {form} rows/s"
            if path in ROWS_LIMITS:
                yield what, count / took, ROWS_LIMITS[path], "asked", 1.0, True
            elif path in CRASH:
                yield what, count / took, crash, "pycrash", CRASH_LIMIT, True
            else:
                yield what, count / took, units, "GNU units", UNITS_LIMITS.get(f"{path}, {form}", 1.0), True


def uncertain(rounds: int) -> Iterator[Line]:
    """Processor seconds of whole uncertain calls."""
    for form in ((), ("--json",)):
        word = "short" if not form else "JSON"
        for count in range(1, len(PLANAR) + 1):
            given = [part for index, (name, certain, spread) in enumerate(PLANAR)
                     for part in (name, spread if index < count else certain)]  # fmt: skip
            took = least(
                lambda given=given, form=form: process("impact", "planar", *PLANAR_REST, *given, *form), rounds
            )
            yield f"planar, {count} uncertain, {word}, s", took, 1.0, "asked", 1.0, False
        took = least(lambda form=form: process("impact", "momentum", *MOMENTUM, *form), rounds)
        yield f"momentum, 6 uncertain, {word}, s", took, 0.5, "asked", 1.0, False


def growing(rounds: int) -> Iterator[Line]:
    """Exponents, and many segments beside few."""
    for name, sizes, times, slope in growth.exponents(rounds):
        yield f"{name}, {sizes[0]:,} to {sizes[-1]:,}, exponent", slope, 1.0, "linear", growth.LINEAR, False
        if name == "segments":
            yield f"{name}, {sizes[-1]:,}, s", times[-1], 1.0, "asked", 1.0, False


def meshes(count: int, rounds: int, folder: Path) -> Iterator[Line]:
    """Nanoseconds a triangle, from file to results, with the proof that the surface is closed; by the clock.

    The yardstick reads the file in blocks of 1 MiB and adds them up as whole numbers of 64 bits.
    """
    try:
        import inertia_mesh
    except ImportError:
        return
    around = int(math.sqrt(count / 2.0))
    file = folder / "torus.stl"
    made = inertia_mesh.torus(around, around)
    inertia_mesh.write(file, made)
    faces = len(made)
    ours = yardstick = math.inf
    processor = plain = math.inf
    for _ in range(rounds):
        start, busy = time.perf_counter(), time.process_time()
        inertia_mesh.read_whole(str(file))
        yardstick = min(yardstick, time.perf_counter() - start)
        plain = min(plain, time.process_time() - busy)
        start, busy = time.perf_counter(), time.process_time()
        inertia_mesh.ours(str(file))
        ours = min(ours, time.perf_counter() - start)
        processor = min(processor, time.process_time() - busy)
    own, least_time = 1e9 * ours / faces, 1e9 * yardstick / faces
    yield f"mesh, {faces:,} triangles, ns each", own, least_time, "read+sum", 7.0, False
    yield "  processor time, ns each", 1e9 * processor / faces, 1e9 * plain / faces, "read+sum", 14.0, False
    if inertia_mesh.trimesh is not None:
        start = time.perf_counter()
        loaded = inertia_mesh.trimesh.load(str(file))
        loaded.mass_properties["inertia"]
        took = time.perf_counter() - start
        yield f"mesh, {faces:,} triangles/s", faces / ours, faces / took, "trimesh", 45.0, True


def starting(rounds: int, folder: Path) -> Iterator[Line]:
    """Processor seconds of a short call by the installed command, beside those of the bare interpreter."""
    (folder / "dynamics").write_text(INSTALLED)

    def bare() -> float:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([sys.executable, "-c", "pass"], check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime

    for words, limit in STARTS:
        pairs = [(process(*words, how=(str(folder / "dynamics"),)), bare()) for _ in range(max(5 * rounds, 10))]
        ours, yardstick = (min(pair[one] for pair in pairs) for one in (0, 1))
        yield f"start: {' '.join(words[:2])}, s", ours, yardstick, "python -c pass", limit, False


def show(line: Line) -> None:
    what, ours, peer, name, limit, more = line
    ratio = ours / peer if peer else math.nan
    missed = not (ratio >= limit if more else ratio <= limit)
    told = f"{peer:12,.4g} {name:14}{limit:7.1f} {ratio:9.2f} x" if peer else f"{'':12} {name + ' not here':14}"
    print(f"{what:44}{ours:12,.4g} {told}{'   missed' if peer and missed else ''}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description="One table of speed.")
    parser.add_argument("--rows", type=int, default=100_000)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--triangles", type=int, default=5_000_000)
    parser.add_argument("--only", default="start,rows,uncertain,growth,mesh")
    asked = parser.parse_args()
    subprocess.run([sys.executable, "-m", "compileall", "-q", str(ROOT / "dynamics_cli")], check=False)
    wanted = asked.only.split(",")
    print(f"{'what':44}{'ours':>12} {'peer':>12} {'':14}{'limit':>7} {'ratio':>11}")
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        parts = {
            "start": lambda: starting(asked.rounds, folder),
            "rows": lambda: streams(asked.rows, asked.rounds, folder),
            "uncertain": lambda: uncertain(asked.rounds),
            "growth": lambda: growing(asked.rounds),
            "mesh": lambda: meshes(asked.triangles, asked.rounds, folder),
        }
        for name in wanted:
            for line in parts[name]():
                show(line)


if __name__ == "__main__":
    main()
