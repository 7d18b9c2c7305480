"""Planar impacts: speed beside pycrash, and what both answer to the same cases.

Run: python tests/benchmarks/impact_planar.py. pycrash (GPL) is run where it is installed, and only run: its static
impact is called with plain objects. Ratios are of one run; absolute times say little on a shared machine.
"""

import contextlib
import io
import math
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import numpy as np

from dynamics_cli.impact.conventions import Axes, ByMass, BySpeed, Restituted
from dynamics_cli.impact.planar.bodies import ByInertia, OnBody, RigidBody, RigidTarget
from dynamics_cli.impact.planar.envelope import envelope
from dynamics_cli.impact.planar.impact import planar
from dynamics_cli.impact.planar.laws import Law

FT, LBF, MPH, DEG = 0.3048, 4.4482216152605, 0.44704, math.pi / 180.0
MILLION = 1_000_000


def best(action: Callable[[], Any], least: float = 0.2, runs: int = 5) -> float:
    """Seconds a call takes, the best of several runs."""
    fastest = math.inf
    for _ in range(runs):
        count, start = 0, time.perf_counter()
        while time.perf_counter() - start < least / runs or not count:
            action()
            count += 1
        fastest = min(fastest, (time.perf_counter() - start) / count)
    return fastest


def peer() -> Callable[..., Any] | None:
    """Pycrash's static impact, silent; None where it is not installed."""
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            from pycrash.impc import impc_calcs
    except Exception as error:
        print(f"pycrash is not here ({error}): its lines are left out\n")
        return None
    return impc_calcs


# NHTSA 4363 as Rose, Fenton and Beauchamp give it (SAE 2006-01-0908)
CASE = {
    "weight": (3451.1, 4695.4), "inertia": (2152.0, 2805.0), "reach": (2.6, 5.7), "angle": (23.8, 10.6),
    "heading": (180.0, 32.0), "speed": (35.1, 35.0), "gamma": 55.0, "restitution": 0.126,
}  # fmt: skip
PRINTED = {"ΔV 1 [mph]": 39.5, "ΔV 2 [mph]": 29.1, "Δω 1 [deg/s]": 31.0, "Δω 2 [deg/s]": 182.0}


def vehicles(case: dict[str, Any]) -> tuple[SimpleNamespace, SimpleNamespace, float, float, dict[str, float]]:
    """The case in the units and the frame that pycrash takes: feet, that of vehicle 1."""
    made = []
    for index in (0, 1):
        turn = (case["heading"][index] - case["heading"][0]) * DEG
        speed = case["speed"][index] * MPH / FT
        reach, angle = case["reach"][index], case["angle"][index] * DEG
        made.append(
            SimpleNamespace(
                weight=case["weight"][index], izz=case["inertia"][index], omega_z=0.0, head_angle=turn / DEG,
                vx_initial=speed, vy_initial=0.0, pimpact_x=reach * math.cos(angle),
                pimpact_y=reach * math.sin(angle), impc_result=None,
            )
        )  # fmt: skip
    inputs = {"cor": case["restitution"], "cof": 10.0, "impact_norm_deg": case["gamma"] + 180.0 - case["heading"][0]}
    return made[0], made[1], made[1].pimpact_x, made[1].pimpact_y, inputs


def ours(case: dict[str, Any], law: str) -> Any:
    """The same by this program."""
    made = []
    for index, kind in enumerate((RigidBody, RigidTarget)):
        heading, angle = case["heading"][index] * DEG, case["angle"][index] * DEG
        reach = case["reach"][index] * FT
        mass = case["weight"][index] * LBF / (32.174 * FT)
        made.append(
            kind(
                ByMass(mass), ByInertia(case["inertia"][index] * LBF * FT),
                OnBody((reach * math.cos(angle), reach * math.sin(angle))),
                BySpeed(case["speed"][index] * MPH, heading), 0.0, heading,
            )
        )  # fmt: skip
    return planar(first=made[0], second=made[1], normal=(case["gamma"] + 180.0) * DEG, friction=10.0,
                  contact=Restituted(case["restitution"]), law=Law(law), axes=Axes("sae"))  # fmt: skip


def answers(static: Callable[..., Any] | None) -> None:
    """What each says of a published solution."""
    print("Published solution of NHTSA 4363 beside answers (impulse ratio at its critical value)")
    print(f"{'':28s}" + "".join(f"{name:>15s}" for name in PRINTED))
    print(f"{'SAE 2006-01-0908, printed':28s}" + "".join(f"{value:15.4g}" for value in PRINTED.values()))
    for law in ("brach", "stronge", "newton", "poisson", "kudlich-slibar"):
        found = ours(CASE, law)
        row = [found.first.delta_v.magnitude / MPH, found.second.delta_v.magnitude / MPH,
               abs(found.first.spin_change) / DEG, abs(found.second.spin_change) / DEG]  # fmt: skip
        print(f"{'impact planar, ' + law:28s}" + "".join(f"{value:15.5g}" for value in row))
    if static is None:
        return
    with contextlib.redirect_stdout(io.StringIO()):
        made = static(*vehicles(CASE))
    row = [math.hypot(float(np.ravel(one["dvx"])[0]), float(np.ravel(one["dvy"])[0])) for one in made]
    # without spin before, the spin after is its change
    row += [abs(float(np.ravel(one["oz_deg"])[-1])) for one in made]
    print(f"{'pycrash static impact':28s}" + "".join(f"{value:15.5g}" for value in row))
    one, two, x, y, inputs = vehicles(CASE)
    print("\nCalls that have no answer")
    for name, change in (("bodies that separate", {"vx_initial": -51.0}), ("e = 1.5", {"cor": 1.5})):
        first = SimpleNamespace(**{**vars(one), **{k: v for k, v in change.items() if k != "cor"}})
        with contextlib.redirect_stdout(io.StringIO()):
            after = static(first, two, x, y, {**inputs, **{k: v for k, v in change.items() if k == "cor"}})
        peer_says = f"ΔV {math.hypot(float(np.ravel(after[0]['dvx'])[0]), float(np.ravel(after[0]['dvy'])[0])):.3g} mph"
        print(f"{name:28s}pycrash: {peer_says}; impact planar: {refusal(change)}")


def refusal(change: dict[str, Any]) -> str:
    """What the program says to the same call."""
    if "cor" in change:
        return "status 2, a restitution is at most 1"
    from dynamics_cli.errors import InadmissibleError

    try:
        ours({**CASE, "speed": (change["vx_initial"] * FT / MPH, 0.0)}, "stronge")
    except InadmissibleError as error:
        return f"status 3, {error.message}"
    return "an answer"


def speeds(static: Callable[..., Any] | None) -> None:
    """Impacts a second."""
    base = None
    print(f"\n{'':44s}{'per impact':>14s}{'impacts/s':>14s}{'ratio':>10s}")

    def line(name: str, seconds: float) -> None:
        ratio = f"{base / seconds:10.0f}" if base else ""
        print(f"{name:44s}{seconds * 1e6:11.4f} µs{1.0 / seconds:14.3g}{ratio}")

    if static is not None:
        scene = vehicles(CASE)

        def one() -> None:
            with contextlib.redirect_stdout(io.StringIO()):
                static(*scene)

        base = best(one)  # printing into nothing is part of every call
        line("pycrash static impact", base)
    line("impact planar in Python, with certificate", best(lambda: ours(CASE, "stronge")))
    scene_ = ours_scene()
    line("impact envelope, a million points", best(lambda: envelope(**scene_), 2.0) / MILLION)


def ours_scene() -> dict[str, Any]:
    mass = [weight * LBF / (32.174 * FT) for weight in CASE["weight"]]
    made = [
        kind(ByMass(mass[i]), ByInertia(CASE["inertia"][i] * LBF * FT), OnBody((CASE["reach"][i] * FT, 0.3)),
             BySpeed(CASE["speed"][i] * MPH, CASE["heading"][i] * DEG), 0.0, CASE["heading"][i] * DEG)
        for i, kind in enumerate((RigidBody, RigidTarget))
    ]  # fmt: skip
    return {"first": made[0], "second": made[1], "normal": (CASE["gamma"] + 180.0) * DEG, "axes": Axes("sae")}


def main() -> None:
    static = peer()
    answers(static)
    speeds(static)


if __name__ == "__main__":
    main()
