"""Vectors, orientation and four-bars beside other people's libraries: errors, and what each does at the hard cases.

Run where they are installed, with this project on the path, for example from an environment of its own:
    pip install numpy scipy sympy pytransform3d spatialmath-python pylinkage mechanism mpmath
    PYTHONPATH=. python tests/benchmarks/kinematics_peers.py [--write]
`--write` puts the tables into docs/accuracy.md. A library that is missing leaves its cells empty.
"""

import importlib
import math
import sys
import time
import warnings
from collections.abc import Callable
from importlib.metadata import version
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from linkage_four_bar import poses
from mpmath import acos, mp, mpf, sqrt

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.linkage.fourbar.closure import frame
from dynamics_cli.linkage.fourbar.four_bar import four_bar
from dynamics_cli.numerics.orientation.rotations import ByMatrix, euler
from dynamics_cli.orient.turns.attitude import RotationVector
from dynamics_cli.orient.turns.convert import convert, distance_of
from dynamics_cli.vec.angles import angle

PAGE = Path(__file__).resolve().parents[2] / "docs" / "accuracy.md"
START, END = "<!-- kinematics -->", "<!-- /kinematics -->"
PEERS = ("scipy", "pytransform3d", "spatialmath-python", "sympy", "pylinkage", "mechanism")
FULL = 2.0 * math.pi
mp.dps = 60

Answer = Callable[..., Any]


def tried(call: Answer, *given: Any) -> Any:
    """An answer, or the name of what a library raised."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return call(*given)
        except Exception as error:  # any refusal of a library is one of its answers here
            return "refused" if isinstance(error, (ValueError, InadmissibleError)) else type(error).__name__


def module(name: str) -> Any:
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def written(number: Any) -> str:
    """An error of two digits; words as they are."""
    if isinstance(number, str):
        return number
    if number is None:
        return "–"
    return "NaN" if math.isnan(number) else f"{number:.0e}" if number else "0"


def table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> list[str]:
    rule = "|".join(["---", *["---:"] * (len(head) - 1)])
    return [f"| {' | '.join(head)} |", f"|{rule}|", *(f"| {' | '.join(row)} |" for row in rows), ""]


# angles of vectors


def by_cosine(a: Any, b: Any) -> float:
    return float(np.arccos(np.clip(np.dot(a, b) / (np.linalg.norm(a) * np.linalg.norm(b)), -1.0, 1.0)))


def by_sympy(a: Any, b: Any) -> float:
    vector = module("sympy.physics.vector")
    axes = vector.ReferenceFrame("N")
    one, other = (sum(float(x) * way for x, way in zip(v, axes, strict=True)) for v in (a, b))
    return float(one.angle_between(other))


def angles() -> list[str]:
    ours = lambda a, b: angle(a, b).angle  # noqa: E731
    methods: dict[str, Answer | None] = {"dynamics vec angle": ours, "numpy, arc cosine": by_cosine}
    methods["sympy, angle_between"] = by_sympy if module("sympy") else None
    rotations = module("pytransform3d.rotations")
    methods["pytransform3d"] = rotations.angle_between_vectors if rotations else None
    cases = (
        ("1e-9 rad apart", (1.0, 0.0, 0.0), (1.0, 1e-9, 0.0)),
        ("2⁻⁴⁰ in one component", (1.0, 1.0, 1.0), (1.0, 1.0, 1.0 + 2.0**-40)),
        ("1e-3 rad apart", (1.0, 2.0, 3.0), (1.0, 2.0, 3.0 + 2.0**-8)),
        ("square, 1e200 long", (1e200, 0.0, 0.0), (0.0, 1e200, 0.0)),
        ("a zero vector", (1.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
    )
    rows = []
    for name, a, b in cases:
        one, other = ([mpf(x) for x in v] for v in (a, b))
        sizes = [sqrt(sum(x * x for x in v)) for v in (one, other)]
        dot = sum(x * y for x, y in zip(one, other, strict=True))
        exact = acos(dot / (sizes[0] * sizes[1])) if all(sizes) else None
        cells = []
        for call in methods.values():
            got = tried(call, np.array(a), np.array(b)) if call not in (None, ours) else tried(call, a, b)
            if call is None:
                cells.append("–")
            elif exact is None or isinstance(got, str) or math.isnan(got):
                cells.append(got if isinstance(got, str) else "NaN" if math.isnan(got) else f"{got:g} rad")
            else:
                cells.append(written(float(abs(mpf(float(got)) / exact - 1))))
        rows.append((name, *cells))
    return table(("angle of two vectors, relative error", *methods), rows)


# orientation


def rotation(method: str) -> tuple[Answer | None, Answer | None]:
    """Angles zyx of a matrix, and the rotation vector of a matrix, by one library."""
    if method == "scipy":
        turn = module("scipy.spatial.transform")
        if turn is None:
            return None, None
        return (
            lambda m: turn.Rotation.from_matrix(m).as_euler("ZYX"), lambda m: turn.Rotation.from_matrix(m).as_rotvec()
        )  # fmt: skip
    if method == "pytransform3d":
        rotations = module("pytransform3d.rotations")
        if rotations is None:
            return None, None
        return (
            lambda m: rotations.euler_from_matrix(m, 2, 1, 0, extrinsic=False),
            lambda m: rotations.compact_axis_angle_from_matrix(m),
        )
    if method == "spatialmath":
        base = module("spatialmath.base")
        if base is None:
            return None, None
        return (
            lambda m: base.tr2rpy(m, order="zyx")[::-1],
            lambda m: np.multiply(*base.tr2angvec(m)[::-1]),
        )
    return (
        lambda m: convert(turn=ByMatrix(rotation_matrix=m)).euler_angles,
        lambda m: convert(turn=ByMatrix(rotation_matrix=m)).rotation_vector,
    )


NAMES = ("dynamics orient convert", "scipy", "pytransform3d", "spatialmath")


def asked(method: str, which: int, matrix: Any) -> Any:
    call = rotation(method)[which]
    if call is None:
        return None
    given = matrix if method.startswith("dynamics") else np.array(matrix)
    answer = tried(call, given)
    return answer if isinstance(answer, str) else tuple(map(float, answer))


def orientations() -> list[str]:
    rows = []
    for off in (1e-3, 1.1e-7, 9e-8, 1e-8, 1e-12, 0.0):
        matrix = euler((0.7, math.pi / 2 - off, 0.3), "zyx")
        cells = [asked(name, 0, matrix) for name in NAMES]
        worst = [
            one if one is None or isinstance(one, str) else distance_of(euler(one, "zyx"), matrix) for one in cells
        ]
        rows.append((f"{off:g} rad from lock" if off else "at lock", *map(written, worst)))
    lines = table(("yaw, pitch, roll of a matrix: error of the rotation they give", *NAMES), rows)
    rows = []
    axis = (1 / 3, 2 / 3, -2 / 3)
    for turn in (1e-12, 1e-8, 1e-3, math.pi - 1e-6, math.pi - 1e-9):
        given = tuple(turn * part for part in axis)
        matrix = convert(turn=RotationVector(rotation_vector=given)).rotation_matrix
        cells = [asked(name, 1, matrix) for name in NAMES]
        worst = [
            one if one is None or isinstance(one, str)
            else min(math.hypot(*(p - s * q for p, q in zip(one, given, strict=True))) for s in (1, -1)) / turn
            for one in cells
        ]  # fmt: skip
        name = f"{turn:g} rad" if turn < 1.0 else f"π − {math.pi - turn:.0e} rad"
        rows.append((name, *map(written, worst)))
    lines += table(("rotation vector of a matrix: relative error", *NAMES), rows)
    rows = []
    for name, matrix in (
        ("stretched: diag(2, 1, 1)", ((2.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))),
        ("sheared by 0.3", ((1.0, 0.3, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))),
        ("mirror: diag(1, 1, −1)", ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, -1.0))),
        ("zeros", ((0.0,) * 3,) * 3),
    ):
        cells = [asked(one, 0, matrix) for one in NAMES]
        rows.append((name, *("–" if c is None else c if isinstance(c, str) else "answers" for c in cells)))
    return [*lines, *table(("a matrix that is no rotation", *NAMES), rows)]


# four-bars


def by_pylinkage(lengths: tuple[float, ...], start: float, steps: int) -> Any:
    """Crank and rocker angles of a turn, starting from the open assembly."""
    library = module("pylinkage")
    simulation = importlib.import_module("pylinkage.simulation")
    a, b, c, d = lengths
    first = four_bar(crank=a, coupler=b, rocker=c, ground=d, crank_angle=start)
    at = first.rocker_pin or (0.0, 0.0)
    origin, pivot = library.Ground(0.0, 0.0), library.Ground(d, 0.0)
    crank = library.Crank(anchor=origin, radius=a, angular_velocity=FULL / steps, initial_angle=start)
    pin = library.RRRDyad(crank.output, pivot, b, c, *at)
    return simulation.Linkage([origin, pivot, crank, pin], order=None)


def angles_of(lengths: tuple[float, ...], pins: list[Any]) -> list[tuple[float, float]]:
    d = lengths[3]
    return [(math.atan2(ay, ax), math.atan2(by, bx - d)) for (ax, ay), (bx, by) in pins]


def pylinkage_turn(lengths: tuple[float, ...], start: float, steps: int) -> list[tuple[float, float]]:
    linkage = by_pylinkage(lengths, start, steps)
    return angles_of(lengths, [(frame_[-2], frame_[-1]) for frame_ in linkage.step(iterations=steps, dt=1.0)])


def mechanism_turn(lengths: tuple[float, ...], start: float, steps: int) -> list[tuple[float, float]]:
    library = module("mechanism")
    a, b, c, d = lengths
    first = four_bar(crank=a, coupler=b, rocker=c, ground=d, crank_angle=start)
    origin, joint_a, joint_b, pivot = library.get_joints("O A B C")
    crank, coupler = library.Vector((origin, joint_a), r=a), library.Vector((joint_a, joint_b), r=b)
    rocker = library.Vector((pivot, joint_b), r=c)
    ground = library.Vector((origin, pivot), r=d, theta=0.0)

    def loops(x: Any, i: Any) -> Any:
        return (crank(i) + coupler(x[0]) - rocker(x[1]) - ground()).flatten()

    theta = start + FULL / steps * np.arange(1, steps + 1)
    guess = (np.array([first.coupler_angle, first.rocker_angle]),)
    made = library.Mechanism(
        vectors=(crank, coupler, rocker, ground), origin=origin, loops=loops, pos=theta, guess=guess
    )
    made.iterate()
    return list(zip(theta.tolist(), rocker.pos.thetas.tolist(), strict=True))


def ours_turn(lengths: tuple[float, ...], start: float, steps: int) -> list[tuple[float, float]]:
    a, b, c, d = lengths
    theta = [start + FULL / steps * k for k in range(1, steps + 1)]
    made = [four_bar(crank=a, coupler=b, rocker=c, ground=d, crank_angle=at).rocker_angle or 0.0 for at in theta]
    return list(zip(theta, made, strict=True))


def gap_of(lengths: tuple[float, ...], crank: float, rocker: float) -> float:
    """How far the coupler would have to stretch."""
    a, b, c, d = lengths
    return abs(abs(d + c * np.exp(1j * rocker) - a * np.exp(1j * crank)) - b)


def verdict(lengths: tuple[float, ...], start: float, turn: Answer, steps: int = 360) -> str:
    """What becomes of a turn: jumps of the rocker, and links that stretch."""
    rows = tried(turn, lengths, start, steps)
    if isinstance(rows, str):
        return rows
    worst = max(gap_of(lengths, *row) for row in rows)
    if worst > 1e-6:
        return f"links stretched by {worst:.2g}"
    changes = [(q - p + math.pi) % FULL - math.pi for (_, p), (_, q) in pairwise(rows)]
    # the rocker's change from step to step is smooth, or else it took the other branch there
    bends = [abs(q - p) for p, q in pairwise(changes)]
    worst_bend = max(bends)
    where = math.degrees(rows[bends.index(worst_bend) + 1][0]) % 360.0
    return f"jumps at {where:.0f}°" if worst_bend > 0.3 * FULL / steps else "one motion"


def four_bars() -> list[str]:
    names: dict[str, Answer | None] = {
        "dynamics linkage": ours_turn,
        "pylinkage": pylinkage_turn if module("pylinkage") else None,
        "mechanism": mechanism_turn if module("mechanism") else None,
    }
    rows = []
    for name, lengths, start in (
        ("crank-rocker 40, 120, 80, 100", (0.04, 0.12, 0.08, 0.1), 0.7),
        ("parallelogram 1, 3, 1, 3", (1.0, 3.0, 1.0, 3.0), 0.5),
        ("change point 2, 5, 4, 3", (2.0, 5.0, 4.0, 3.0), 0.5),
        ("triple rocker 3, 2, 2.5, 4, over its limit", (3.0, 2.0, 2.5, 4.0), 0.5),
        ("crank of 0.4 µm", (4e-7, 1.2e-6, 8e-7, 1e-6), 0.7),
    ):
        cells = ["–" if call is None else verdict(lengths, start, call) for call in names.values()]
        rows.append((name, *cells))
    return [*table(("four-bar through one turn", *names), rows), *speeds()]


def best(call: Answer, runs: int) -> float:
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return min(times)


def speeds() -> list[str]:
    lengths, count = (0.04, 0.12, 0.08, 0.1), 2048
    theta = np.linspace(0.0, FULL, count, endpoint=False)
    links = frame(*lengths)
    ours = best(lambda: poses(links, theta, 1.0), 200) / count
    rows = [("dynamics, position, velocity, acceleration of arrays", f"{1e6 * ours:.3f}", "1")]
    if module("pylinkage"):
        linkage = by_pylinkage(lengths, 0.7, count)
        plain = best(lambda: list(linkage.step(iterations=count, dt=1.0)), 5) / count
        rows.append(("pylinkage `step`, position", f"{1e6 * plain:.1f}", f"{plain / ours:.0f}"))
        moving = tried(lambda: best(lambda: linkage.step_fast_with_kinematics(iterations=count, dt=1.0), 3) / count)
        if not isinstance(moving, str):
            name = "pylinkage `step_fast_with_kinematics`" + ("" if module("numba") else ", without numba")
            rows.append((name, f"{1e6 * moving:.1f}", f"{moving / ours:.0f}"))
    if module("mechanism"):
        solved = best(lambda: mechanism_turn(lengths, 0.7, 256), 2) / 256
        rows.append(("mechanism, position", f"{1e6 * solved:.0f}", f"{solved / ours:.0f}"))
    return table(("a pose of a four-bar", "µs", "times ours"), rows)


def main() -> None:
    there = [f"{name} {version(name)}" for name in PEERS if module(name.partition("-")[0])]
    lines = [*angles(), *orientations(), *four_bars(), f"Measured with {', '.join(there)}, numpy {np.__version__}.", ""]
    print("\n".join(lines))
    if "--write" in sys.argv:
        text = PAGE.read_text(encoding="utf-8")
        before, _, rest = text.partition(START)
        PAGE.write_text("\n".join([before + START, "", *lines, END]) + rest.partition(END)[2], encoding="utf-8")


if __name__ == "__main__":
    main()
