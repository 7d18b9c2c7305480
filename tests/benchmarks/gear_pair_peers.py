"""Centre distances, cone angles and contact ratios beside py_gearworks, where it is installed: error and time.

Run: python tests/benchmarks/gear_pair_peers.py. References from 50-digit arithmetic in this file.
"""

import time
from collections.abc import Callable
from math import degrees, radians
from typing import Any

from mpmath import acos, atan, cos, findroot, mp, mpf, pi, sin, sqrt, tan

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.gear.crossing.bevel import bevel
from dynamics_cli.gear.crossing.bevel_records import Kind
from dynamics_cli.gear.pair.pair import pair
from dynamics_cli.gear.pair.records import Mate
from dynamics_cli.gear.pair.shift_split import Tips
from dynamics_cli.gear.pitch import NormalModule
from dynamics_cli.gear.single.gear import signed_gear
from dynamics_cli.gear.single.rack import basic_rack

PAIRS = {"T4.3, spur 12/24": (12, 24, 0.6, 0.36, 0.0), "T4.8, helical 12/60": (12, 60, 0.09809, 0.0, 30.0),
         "large, 80/900": (80, 900, 0.3, -0.2, 12.0)}  # fmt: skip
BEVELS = [(20, 40, 90.0), (20, 40, 60.0), (20, 20, 120.0), (20, 40, 140.0), (20, 60, 179.0)]
MODULE = 0.003


def reference(z1: int, z2: int, x1: float, x2: float, beta: float) -> tuple[Any, Any]:
    """Centre distance, and ε_α with full tips."""
    mp.dps = 50
    alpha, lean = mpf(radians(20.0)), mpf(radians(beta))
    transverse = atan(tan(alpha) / cos(lean))
    value = tan(transverse) - transverse + 2 * (mpf(x1) + mpf(x2)) * tan(alpha) / (z1 + z2)
    work = findroot(lambda a: tan(a) - a - value, (3 * value) ** (mpf(1) / 3))
    radii = [z * mpf(MODULE) / cos(lean) / 2 for z in (z1, z2)]
    distance = sum(radii) * cos(transverse) / cos(work)
    reach = sum(
        sqrt((r + mpf(MODULE) * (1 + mpf(x))) ** 2 - (r * cos(transverse)) ** 2)
        for r, x in zip(radii, (x1, x2), strict=True)
    )
    pitch = pi * mpf(MODULE) / cos(lean) * cos(transverse)
    return distance, (reach - distance * sin(work)) / pitch


def timed(work: Callable[[], Any], repeats: int = 20) -> tuple[Any, float]:
    made, best = work(), float("inf")
    for _ in range(repeats):
        start = time.process_time()
        work()
        best = min(best, time.process_time() - start)
    return made, best


def relative(value: float, exact: Any) -> str:
    return f"{float(abs(mpf(value) / exact - 1)):.1e}"


def main() -> None:
    start = time.perf_counter()
    try:
        import py_gearworks as peer  # type: ignore[import-not-found]
    except ImportError:
        peer = None
    print(f"py_gearworks: {'not installed' if peer is None else f'import {time.perf_counter() - start:.1f} s'}\n")
    print(f"{'pair':22s} {'a_w ours':>10s} {'ε_α ours':>10s} {'time':>9s} {'a_w peer':>10s} {'time':>9s}")
    for name, (z1, z2, x1, x2, beta) in PAIRS.items():
        distance, ratio = reference(z1, z2, x1, x2, beta)

        def ours(z1: int = z1, z2: int = z2, x1: float = x1, x2: float = x2, beta: float = beta) -> Any:
            return pair(first=Mate(z1, x1), second=Mate(z2, x2), pitch=NormalModule(MODULE), helix_angle=radians(beta),
                        tips=Tips("full"))  # fmt: skip

        made, took = timed(ours)
        own = made.nominal_contact_ratio or made.transverse_contact_ratio
        cells = f"{relative(made.centre_distance, distance):>10s} {relative(own, ratio):>10s} {1e6 * took:6.0f} µs"
        if peer is not None:
            rack = basic_rack("a", radians(20.0))
            one = signed_gear(z1, MODULE, rack, helix_angle=radians(beta), shift=x1)
            two = signed_gear(z2, MODULE, rack, helix_angle=radians(beta), shift=x2)

            def theirs(one: Any = one, two: Any = two) -> float:
                return float(
                    peer.calc_involute_mesh_distance(
                        one.base_diameter / 2,
                        two.base_diameter / 2,
                        one.base_half_angle,
                        two.base_half_angle,
                        2 * float(pi) / two.teeth,
                    )
                )

            found, took = timed(theirs)
            cells += f" {relative(found, distance):>10s} {1e6 * took:6.0f} µs"
        print(f"{name:22s} {cells}")
    print(f"\n{'bevel':22s} {'true δ₁':>10s} {'δ₂':>9s} {'ours':>20s} {'py_gearworks':>24s}")
    for z1, z2, shafts in BEVELS:
        first = acos(
            (z2 + z1 * cos(mpf(radians(shafts)))) / sqrt(z1**2 + z2**2 + 2 * z1 * z2 * cos(mpf(radians(shafts))))
        )
        try:
            own = bevel(first_teeth=z1, second_teeth=z2, module=MODULE, face_width=1e-4, shaft_angle=radians(shafts),
                        kind=Kind("standard"))  # fmt: skip
            shown = f"{degrees(own.first.pitch_angle):.5f} {degrees(own.second.pitch_angle):.5f}"
        except InadmissibleError as error:
            shown = error.code
        peers = ""
        if peer is not None:
            cones = peer.cone_angle_from_teeth(z1, z2, radians(shafts)) / 2
            peers = f"{degrees(cones[0]):.5f} {degrees(cones[1]):.5f}"
        true = f"{degrees(float(first)):10.5f} {shafts - degrees(float(first)):9.5f}"
        print(f"{z1}/{z2}, {shafts:g}°{'':12s} {true} {shown:>20s} {peers:>24s}")


if __name__ == "__main__":
    main()
