"""How long profiles and mesh proofs take, and how true they are; beside py_gearworks where this Python can import it.

    python tests/benchmarks/gear_profile.py [--rounds 7]

Junctions are held against accuracy/data/gear_trains.json. py_gearworks is run, never imported by the program; its
figures are those of its own functions for the same gears (its rack has sharp corners, so only contact ratios and times
are set side by side).
"""

import argparse
import json
import math
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from mpmath import mp, mpf  # noqa: E402

from dynamics_cli.gear.mesh.mesh import mesh  # noqa: E402
from dynamics_cli.gear.mesh.profile_contact import path_of_contact, transmission_error  # noqa: E402
from dynamics_cli.gear.pitch import NormalModule  # noqa: E402
from dynamics_cli.gear.single.flanks import ToothForm, flank  # noqa: E402
from dynamics_cli.gear.single.gear import Gear  # noqa: E402
from dynamics_cli.gear.single.outline import chain_points, gear_outline  # noqa: E402
from dynamics_cli.gear.single.profile import tooth_form  # noqa: E402
from dynamics_cli.gear.single.rack import BasicRack  # noqa: E402
from dynamics_cli.gear.single.trochoid import Cutter, root  # noqa: E402

MM = 1e-3
TWENTY = math.radians(20.0)


def fastest(work: Callable[[], Any], rounds: int) -> tuple[float, Any]:
    times, answer = [], None
    for _ in range(rounds):
        start = time.perf_counter()
        answer = work()
        times.append(time.perf_counter() - start)
    return min(times), answer


def junctions(rounds: int) -> None:
    cases = json.loads((ROOT / "dynamics_cli/accuracy/data/gear_trains.json").read_text(encoding="utf-8"))["cases"]
    roots = [case for case in cases if case["task"] == "root"]
    mp.dps = 60
    worst, times = mpf(0), []
    for case in roots:
        cutter = Cutter(**{k: float(v) if isinstance(v, str) else v for k, v in case["inputs"].items()})
        taken, found = fastest(lambda own=cutter: root(own), rounds)
        times.append(taken)
        reference = mpf(case["results"]["form_radius"])
        worst = max(worst, abs(mpf(found.form_radius) / reference - 1))
    print(f"junction of involute and trochoid, {len(roots)} cases: worst relative error {float(worst):.1e}, ", end="")
    print(f"{1e6 * sorted(times)[len(times) // 2]:.0f} µs the middle one, {1e6 * max(times):.0f} µs the slowest")


def profiles(rounds: int) -> None:
    print(f"{'whole gear':30} {'points':>7} {'bound':>10} {'curves':>10} {'drawing':>10}")
    for teeth, tolerance in ((9, 5e-6), (20, 1e-5), (20, 1e-6), (100, 5e-5), (1000, 1e-5)):
        form = form_of(teeth)

        def curves(own: Any = form, fine: float = tolerance, z: int = teeth) -> Any:
            chain = flank(own, fine)
            return chain, chain_points(own, chain, z)

        quick, (chain, points) = fastest(curves, rounds)
        drawn, _ = fastest(lambda own=form, fine=tolerance: gear_outline(own, fine), rounds)
        name = f"z = {teeth}, tolerance {1e6 * tolerance:g} µm"
        print(
            f"{name:30} {points[0].size:7} {1e6 * chain.deviation:7.3f} µm {1e3 * quick:7.3f} ms {1e3 * drawn:7.3f} ms"
        )


def form_of(teeth: int) -> ToothForm:
    """A gear of module 2 mm."""
    return tooth_form(Gear(teeth, 2 * MM, BasicRack()), None, None)


def meshes(rounds: int) -> None:
    first = form_of(17)
    second = form_of(53)
    path = path_of_contact(first, second, 70 * MM)
    taken, (_, error) = fastest(lambda: transmission_error(first, second, 70 * MM, path, 100_000), rounds)
    print(
        f"100 000 points of contact: {1e3 * taken:.1f} ms, transmission error {float(abs(error).max()):.1e} rad; ",
        end="",
    )
    whole, answer = fastest(
        lambda: mesh(first_teeth=17, second_teeth=53, pitch=NormalModule(2 * MM), points=100_000), rounds
    )
    print(f"the whole proof with clearances {1e3 * whole:.1f} ms, runs: {answer.runs}")


def peers(rounds: int) -> None:
    try:
        start = time.perf_counter()
        import py_gearworks as pg
    except ImportError:
        print("py_gearworks is not installed: pip install py_gearworks")
        return
    print(f"py_gearworks: import {time.perf_counter() - start:.1f} s")
    a1 = math.sqrt(11.0**2 - (10 * math.cos(TWENTY)) ** 2)
    exact = (2 * a1 - 20 * math.sin(TWENTY)) / (math.pi * math.cos(TWENTY))

    def theirs() -> float:
        options = {"number_of_teeth": 20, "module": 1.0, "dedendum_coefficient": 1.25}
        one, two = pg.SpurGear(**options), pg.SpurGear(**options)
        one.mesh_to(two)
        return float(pg.get_contact_ratio(one, two))

    taken, value = fastest(theirs, rounds)
    own, answer = fastest(
        lambda: mesh(first_teeth=20, second_teeth=20, pitch=NormalModule(1 * MM), points=1000), rounds
    )
    print(f"contact ratio 20/20: theirs {value:.9f} (off {value / exact - 1:.1e}) in {1e3 * taken:.1f} ms, ", end="")
    print(f"ours {answer.contact_ratio:.9f} (off {answer.contact_ratio / exact - 1:.1e}) in {1e3 * own:.1f} ms")

    def their_profile() -> Any:
        import numpy as np

        curve = pg.SpurGear(number_of_teeth=20, module=2.0, dedendum_coefficient=1.25).gearcore.boundary_at_z(0.0)
        return [curve(t) for t in np.linspace(0.0, 1.0, 1000)]

    taken, _ = fastest(their_profile, rounds)
    form = form_of(20)
    own, _ = fastest(lambda: chain_points(form, flank(form, 6e-6), 20), rounds)
    print(f"whole profile of 20 teeth, about 1000 points: theirs {1e3 * taken:.1f} ms, ours {1e3 * own:.3f} ms")


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=7)
    rounds = parser.parse_args().rounds
    junctions(rounds)
    profiles(rounds)
    meshes(rounds)
    peers(min(rounds, 3))


if __name__ == "__main__":
    main()
