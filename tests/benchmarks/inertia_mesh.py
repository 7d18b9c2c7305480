"""Mass properties of meshes: time against error, beside trimesh and MuJoCo where they are installed.

    python tests/benchmarks/inertia_mesh.py [--huge]

Ratios of one run count, not times. Errors are those of principal moments against exact rationals, each tool's on the
corners it was given: doubles for this program and trimesh, single precision for MuJoCo, which takes no other.
`--huge` writes a file of 10⁸ triangles (5 GB) to the temporary folder, and removes it.
"""

# ruff: noqa: E402
import os

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(name, "1")

import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parents[1]), str(HERE.parent / "references"), str(HERE.parent)]

import numpy as np
from generate_inertia_mesh_references import STILL, TURN, integrals, recipe
from inertia_solids import triangles, write_stl
from mpmath import mp, mpf

from dynamics_cli.inertia.bodies.amount import OfDensity
from dynamics_cli.inertia.mesh import measurement as reading
from dynamics_cli.inertia.mesh.opening import open_mesh
from dynamics_cli.inertia.mesh.passes import first_pass
from dynamics_cli.inertia.mesh.surface import LengthUnit
from dynamics_cli.inertia.mesh.task import mesh

try:
    import trimesh
except ImportError:
    trimesh = None
try:
    import mujoco
except ImportError:
    mujoco = None

RECORD = np.dtype([("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")])
FAR = (1.0, -0.7, 0.3)


def ours(path: str) -> list[float]:
    reading._LAST.clear()
    made = mesh(path, length_unit=LengthUnit("m"), amount=OfDensity(1.0)).principal_moments
    return [made.first, made.second, made.third]


def by_trimesh(corners: np.ndarray) -> list[float]:
    made = trimesh.Trimesh(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3), process=False)
    tensor = made.mass_properties["inertia"]
    return sorted(float(x) for x in np.linalg.eigvalsh(np.asarray(tensor)))


def by_mujoco(path: str) -> list[float]:
    text = (
        f'<mujoco><compiler balanceinertia="false"/><asset><mesh name="m" file="{path}" inertia="exact"/></asset>'
        '<worldbody><body><freejoint/><geom type="mesh" mesh="m" density="1"/></body></worldbody></mujoco>'
    )
    model = mujoco.MjModel.from_xml_string(text)
    return sorted(float(x) for x in model.body_inertia[1])


def timed(call: Callable[[], Any], repeat: int = 3) -> tuple[float, Any]:
    best, made = float("inf"), None
    for _ in range(repeat):
        start = time.perf_counter()
        made = call()
        best = min(best, time.perf_counter() - start)
    return best, made


def attempt(call: Callable[[], list[float]], true: list[Any]) -> str:
    """Error and time of one tool, or why it gave none."""
    try:
        seconds, found = timed(call)
    except Exception as error:  # a peer may refuse in any way it likes
        return f"refused: {(str(error).splitlines() or [''])[0][:24]}"
    error = max(float(abs(x - t) / abs(t)) for x, t in zip(found, true, strict=True))
    return f"{error:8.0e}{' negative' if min(found) < 0 else ''} {seconds * 1e6:7.0f} µs"


def hard_cases() -> Iterator[tuple[str, dict[str, Any]]]:
    size = (1.0, 0.75, 0.5)
    for power in (0, 2, 4, 5, 6, 8):
        far = 10.0**power if power else 0.0
        yield f"ellipsoid at {far:g} sizes", recipe("ball 2", size, TURN, tuple(far * x for x in FAR))
    for power in (3, 6):
        thin = 10.0**-power
        for turn, word in ((STILL, ""), (TURN, " turned")):
            yield f"needle 1e{power}{word}", recipe("ball 2", (1.0, 1.25 * thin, thin), turn)
        yield f"plate 1e{power} turned", recipe("ball 2", (1.0, 0.75, thin), TURN)
    yield "needle 1e6 turned at 10 sizes", recipe("ball 2", (1.0, 1.25e-6, 1e-6), TURN, (10.0, -7.0, 3.0))
    yield "plate 1e6 turned at 1e3 sizes", recipe("ball 2", (1.0, 0.75, 1e-6), TURN, (1e3, -7e2, 3e2))


def accuracy(folder: Path) -> None:
    print("error of principal moments, and time from file (trimesh: from arrays) to moments, 128 triangles")
    print(f"  {'case':31s} {'this program':>20s} {'trimesh':>30s} {'MuJoCo, single':>30s}")
    mp.dps = 90
    for name, inputs in hard_cases():
        made = triangles(inputs)
        # MuJoCo keeps a mesh by the name of its file
        text, binary = folder / "case.stl", folder / f"{name.replace(' ', '-')}.stl"
        write_stl(text, made, binary=False)
        names = ("first", "second", "third")
        true = [mpf(integrals(inputs)[f"principal_moments.{k}"]) for k in names]
        row = attempt(lambda path=str(text): ours(path), true), "", ""
        if trimesh:
            row = row[0], attempt(lambda made=made: by_trimesh(np.array(made)), true), ""
        if mujoco:
            write_stl(binary, made, binary=True)
            single = {**inputs, "single": True}
            try:
                own = [mpf(integrals(single)[f"principal_moments.{k}"]) for k in names]
                row = row[0], row[1], attempt(lambda path=str(binary): by_mujoco(path), own)
            except ZeroDivisionError:
                row = row[0], row[1], "nothing left of it"
        print(f"  {name:31s} {row[0]:>20s} {row[1]:>30s} {row[2]:>30s}", flush=True)


def torus(around: int, across: int) -> np.ndarray:
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across, indexing="ij")
    r = 10.0 * (1.0 + 0.1 * np.sin(5 * u) * np.cos(3 * v))
    points = np.stack([(30 + r * np.cos(v)) * np.cos(u), (30 + r * np.cos(v)) * np.sin(u), r * np.sin(v)], -1)
    a = points.astype(np.float32)
    b, d = np.roll(a, -1, 0), np.roll(a, -1, 1)
    c = np.roll(b, -1, 1)
    rows = np.zeros(2 * around * across, RECORD)
    rows["v"] = np.concatenate([np.stack(three, -2).reshape(-1, 3, 3) for three in ((a, b, c), (a, c, d))])
    return rows


def write(path: Path, rows: np.ndarray, times: int = 1) -> None:
    with open(path, "wb") as file:
        file.write(b"benchmark".ljust(80) + np.uint32(times * len(rows)).tobytes())
        for _ in range(times):
            rows.tofile(file)


def read_and_sum(path: str) -> float:
    """The yardstick: the file read in blocks, all corner coordinates added up."""
    buffer, total = bytearray(50 * 65536), 0.0
    with open(path, "rb", buffering=0) as file:
        file.seek(84)
        while got := file.readinto(buffer):
            total += float(np.ndarray((got // 50, 9), "<f4", buffer, 12, (50, 4)).sum(dtype=np.float64))
    return total


def read_whole(path: str) -> int:
    """Another yardstick: the file in blocks of 1 MiB, added up as whole numbers of 64 bits."""
    total = 0
    with open(path, "rb", buffering=0) as file:
        while got := file.read(1 << 20):
            total += int(np.frombuffer(got[: len(got) // 8 * 8], dtype=np.uint64).sum())
    return total


# A child counts the memory of the process it was forked from, so a small one starts it.
LAUNCHER = """
import os, sys, time
start = time.perf_counter()
out = [(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)]
_, status, usage = os.wait4(os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ, file_actions=out), 0)
print(status, time.perf_counter() - start, usage.ru_maxrss / 1024.0)
"""


def whole_process(command: list[str]) -> tuple[float, float]:
    """Seconds and peak memory [MB] of a process."""
    launcher = [sys.executable, "-S", "-E", "-c", LAUNCHER, *command]
    status, seconds, memory = subprocess.run(launcher, check=True, capture_output=True, text=True).stdout.split()
    assert status == "0", command
    return float(seconds), float(memory)


def program(path: str) -> list[str]:
    os.environ["PYTHONPATH"] = str(HERE.parents[1])
    return [
        sys.executable,
        "-m",
        "dynamics_cli",
        "inertia",
        "mesh",
        path,
        "--length-unit",
        "mm",
        "--density",
        "1 g/cm^3",
    ]


def speed(folder: Path) -> None:
    print("\nfile to report, ns a triangle (best of 5; trimesh once from 10⁶)")
    heads = (
        "read+sum",
        "no proof",
        "with proof",
        "ratio",
        "ratio",
        "trimesh",
        "with proof",
        "ratios",
        "process s",
        "process MB",
    )
    print(f"  {'triangles':>9s} " + " ".join(f"{head:>11s}" for head in heads))
    for around, across in ((100, 50), (500, 100), (1000, 500), (2500, 1000)):
        path = folder / "torus.stl"
        write(path, torus(around, across))
        count = 2 * around * across
        source = open_mesh(str(path))
        yardstick = timed(lambda path=path: read_and_sum(str(path)), 5)[0]
        bare = timed(lambda source=source: first_pass(source, shell=False, prove=False), 5)[0]
        whole = timed(lambda path=path: ours(str(path)), 5)[0]
        peer = proved = float("nan")
        if trimesh:
            few = 1 if count >= 1_000_000 else 3

            def load(path: Path = path) -> Any:
                made = trimesh.load(str(path), process=False)
                return made, made.mass_properties

            peer, (made, _) = timed(load, few)
            made.merge_vertices()
            proved = peer + timed(lambda made=made: trimesh.Trimesh(made.vertices, made.faces).is_watertight, few)[0]
            del made
        seconds, memory = whole_process(program(str(path)))
        numbers = [1e9 * x / count for x in (yardstick, bare, whole)]
        print(
            f"  {count:9d} {numbers[0]:11.1f} {numbers[1]:11.1f} {numbers[2]:11.1f} {bare / yardstick:10.1f}x "
            f"{whole / yardstick:10.1f}x {1e9 * peer / count:11.0f} {1e9 * proved / count:11.0f} "
            f"{peer / bare:5.0f}x{proved / whole:4.0f}x {seconds:11.2f} {memory:11.0f}",
            flush=True,
        )


def start_up(folder: Path) -> None:
    path = folder / "small.stl"
    write(path, torus(100, 50))
    ratios, times = [], []
    for _ in range(9):
        yardstick = whole_process([sys.executable, "-c", "import numpy"])[0]
        times.append(whole_process(program(str(path)))[0])
        ratios.append(times[-1] / yardstick)
    seconds, ratio = statistics.median(times), statistics.median(ratios)
    print(f"\n10⁴ triangles, whole process: {seconds:.3f} s, {ratio:.2f} × import numpy")


def huge(folder: Path) -> None:
    path = folder / "huge.stl"
    rows = torus(1000, 500)
    write(path, rows, 100)
    for word, command in (("this program", program(str(path))),):
        seconds, memory = whole_process(command)
        print(f"\n10⁸ triangles, {path.stat().st_size / 1e9:.1f} GB, {word}: {seconds:.1f} s, peak {memory:.0f} MB")
    path.unlink()


if __name__ == "__main__":
    subprocess.run([sys.executable, "-m", "compileall", "-q", str(HERE.parents[1] / "dynamics_cli")], check=False)
    with tempfile.TemporaryDirectory() as place:
        accuracy(Path(place))
        speed(Path(place))
        start_up(Path(place))
        if "--huge" in sys.argv:
            huge(Path(place))
