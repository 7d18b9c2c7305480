"""How time grows with size: each size is doubled three times, and the exponent of the time is printed (1 is linear).

    python tests/benchmarks/growth.py [--rounds 3]

Calls run in this process, so that neither start-up nor imports count; each figure is the least processor time of its
rounds. The exponent is the slope of a straight line through the logarithms; what is not linear is marked.
"""

import argparse
import io
import json
import math
import random
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOUBLINGS = 4
# Beyond this an exponent is no scatter of the machine.
LINEAR = 1.2


def segments(count: int, folder: Path) -> list[str]:
    """A skid over so many surfaces."""
    draw = random.Random(count)
    parts = [{"distance": f"{draw.uniform(0.5, 1.5):.3f} m", "friction": draw.uniform(0.4, 0.8)} for _ in range(count)]
    file = folder / f"segments-{count}.json"
    file.write_text(json.dumps({"segments": parts}))
    return ["skid", "speed", "--input", str(file)]


def uncertain(count: int, folder: Path) -> list[str]:
    """A skid over so many surfaces of uncertain lengths."""
    draw = random.Random(count)
    parts = [
        {"distance": f"{draw.uniform(0.5, 1.5):.3f} ± 0.05 m", "friction": draw.uniform(0.4, 0.8)} for _ in range(count)
    ]
    file = folder / f"uncertain-{count}.json"
    file.write_text(json.dumps({"segments": parts}))
    return ["skid", "speed", "--input", str(file)]


def bodies(count: int, folder: Path) -> list[str]:
    """A row of balls at rest, and one that runs into it."""
    parts = [{"mass": "1 kg", "velocity": "0 m/s" if index else "1 m/s"} for index in range(count)]
    file = folder / f"bodies-{count}.json"
    file.write_text(json.dumps({"bodies": parts, "restitution": 1, "law": "sequential"}))
    return ["impact", "chain", "--input", str(file)]


def parts(count: int, folder: Path) -> list[str]:
    """A body of so many balls."""
    draw = random.Random(count)
    rows = [
        f'[[parts]]\nname = "ball {index}"\nshape = "sphere"\nradius = "{draw.uniform(1, 5):.3f} mm"\nmass = "2 g"\n'
        f'position = ["{draw.uniform(-1, 1):.4f} m", "{draw.uniform(-1, 1):.4f} m", "{draw.uniform(-1, 1):.4f} m"]\n'
        for index in range(count)
    ]
    file = folder / f"parts-{count}.toml"
    file.write_text('name = "balls"\n' + "".join(rows))
    return ["inertia", "body", str(file)]


def rows(count: int, folder: Path) -> list[str]:
    """A stream of so many cases."""
    file = folder / f"rows-{count}.csv"
    file.write_text(
        "distance[ft],friction\n" + "".join(f"{20 + index % 97},0.{40 + index % 50}\n" for index in range(count))
    )
    return ["skid", "speed", "--rows", str(file)]


def columns(count: int, folder: Path) -> list[str]:
    """A stream of some cases with so many columns that pass through."""
    file = folder / f"columns-{count}.csv"
    more = "".join(f",note{index}" for index in range(count))
    line = ",7" * count
    file.write_text(
        f"distance[ft],friction{more}\n" + "".join(f"{20 + index % 97},0.7{line}\n" for index in range(500))
    )
    return ["skid", "speed", "--rows", str(file)]


def triangles(count: int, folder: Path) -> list[str]:
    """A closed surface: a sphere of rings."""
    import numpy as np

    around = max(int(math.sqrt(count)), 3)
    rings = max(count // (2 * around), 2)
    theta = np.linspace(0.0, math.pi, rings + 1)
    phi = np.linspace(0.0, 2.0 * math.pi, around + 1)
    ring, turn = np.meshgrid(theta, phi, indexing="ij")
    points = np.stack([np.sin(ring) * np.cos(turn), np.sin(ring) * np.sin(turn), np.cos(ring)], axis=-1)
    points[:, -1], points[0], points[-1] = points[:, 0], (0.0, 0.0, 1.0), (0.0, 0.0, -1.0)
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    faces = np.concatenate(
        [np.stack([a, b, c], axis=2)[:-1].reshape(-1, 3, 3), np.stack([a, c, d], axis=2)[1:].reshape(-1, 3, 3)]
    )
    made = np.zeros(len(faces), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
    made["corners"] = 1000.0 * faces
    file = folder / f"triangles-{count}.stl"
    file.write_bytes(bytes(80) + len(faces).to_bytes(4, "little") + made.tobytes())
    return ["inertia", "mesh", str(file), "--length-unit", "mm", "--density", "2700 kg/m^3"]


# The first size of each, its maker, and what is counted.
CASES: dict[str, tuple[int, Callable[[int, Path], list[str]]]] = {
    "segments": (1250, segments),
    "uncertain segments": (100, uncertain),
    "bodies": (60, bodies),
    "parts": (250, parts),
    "rows": (20_000, rows),
    "columns": (100, columns),
    "triangles": (50_000, triangles),
}


def seconds(argv: list[str], rounds: int) -> float:
    """The least processor time of a call in this process."""
    from dynamics_cli import cli
    from dynamics_cli.core.terminal import Terminal

    best = math.inf
    for _ in range(rounds):
        errors = io.BytesIO()
        start = time.process_time()
        status = cli.run_argv([*argv], Terminal(io.BytesIO(), io.BytesIO(), errors, {}))
        best = min(best, time.process_time() - start)
        if status:
            raise SystemExit(f"{' '.join(argv[:2])} ended with status {status}: {errors.getvalue().decode()[:300]}")
    return best


def exponents(rounds: int) -> Iterator[tuple[str, list[int], list[float], float]]:
    """Each case: its sizes, their seconds, and the exponent."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        for name, (first, maker) in CASES.items():
            sizes = [first << power for power in range(DOUBLINGS)]
            calls = [maker(size, folder) for size in sizes]
            seconds(calls[0], 1)
            times = [seconds(call, rounds) for call in calls]
            x, y = [math.log(size) for size in sizes], [math.log(max(took, 1e-9)) for took in times]
            mean = sum(x) / len(x)
            slope = sum((a - mean) * b for a, b in zip(x, y, strict=True)) / sum((a - mean) ** 2 for a in x)
            yield name, sizes, times, slope


def main() -> None:
    parser = argparse.ArgumentParser(description="How time grows with size.")
    parser.add_argument("--rounds", type=int, default=3)
    asked = parser.parse_args()
    print(f"{'what':20}{'sizes':>22}{'seconds':>40}{'exponent':>12}")
    for name, sizes, times, slope in exponents(asked.rounds):
        told = "  ".join(f"{took:8.4f}" for took in times)
        mark = "" if slope <= LINEAR else "  not linear"
        print(f"{name:20}{f'{sizes[0]:,} to {sizes[-1]:,}':>22}{told:>40}{slope:12.2f}{mark}", flush=True)


if __name__ == "__main__":
    sys.path.insert(0, str(ROOT))
    main()
