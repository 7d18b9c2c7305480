"""How long the exhaustive search for tooth numbers takes, beside two other exhaustive ways in the same run.

    python tests/benchmarks/gear_ratio.py [--rounds 5]

`products` is the search of `gear ratio`; `numpy` sorts the products and looks each one up with `searchsorted`; `loops`
goes through pairs of products of two stages in plain Python. The first two must name the same best ratio.
"""

import argparse
import sys
import time
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from dynamics_cli.gear.trains.ratio import ratio
from dynamics_cli.gear.trains.scene import Mesh, Network
from dynamics_cli.gear.trains.train import train

SIDEREAL = (3652422, 273217)
PI = (314159265358979, 10**14)
CASES = (
    ("pair 12..1000", PI, 1, (12, 1000)),
    ("2 stages 12..120", SIDEREAL, 2, (12, 120)),
    ("2 stages 12..200", SIDEREAL, 2, (12, 200)),
    ("3 stages 40..85", PI, 3, (40, 85)),
    ("3 stages 12..120", SIDEREAL, 3, (12, 120)),
    ("3 stages 12..120, pi", PI, 3, (12, 120)),
)


def fastest(work: Callable[[], Any], rounds: int) -> tuple[float, Any]:
    times, answer = [], None
    for _ in range(rounds):
        start = time.perf_counter()
        answer = work()
        times.append(time.perf_counter() - start)
    return min(times), answer


def by_numpy(target: tuple[int, int], stages: int, teeth: tuple[int, int]) -> Fraction:
    numbers = np.arange(teeth[0], teeth[1] + 1, dtype=np.int64)
    products = numbers
    for _ in range(stages - 1):
        products = np.unique((products[:, None] * numbers).ravel())
    wanted = products * (target[0] / target[1])
    above = np.searchsorted(products, wanted)
    best: tuple[float, Fraction] = (1e9, Fraction(0))
    for place in (np.clip(above - 1, 0, len(products) - 1), np.clip(above, 0, len(products) - 1)):
        off = np.abs(products[place] - wanted) / wanted
        index = int(np.argmin(off))
        best = min(best, (float(off[index]), Fraction(int(products[place][index]), int(products[index]))))
    return best[1]


def by_loops(target: tuple[int, int], teeth: tuple[int, int]) -> Fraction:
    aim = target[0] / target[1]
    numbers = range(teeth[0], teeth[1] + 1)
    products = sorted({a * b for a in numbers for b in numbers})
    return min(
        (abs(top / bottom / aim - 1.0), Fraction(top, bottom)) for bottom in products[::40] for top in products[::40]
    )[1]


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=5)
    rounds = parser.parse_args().rounds
    print(f"{'search':24} {'products':>10} {'numpy':>10}   {'best ratio':>18} {'error':>11}  same")
    for name, target, stages, teeth in CASES:
        own, answer = fastest(lambda t=target, s=stages, z=teeth: ratio(target=t, stages=s, teeth=z, count=1), rounds)
        other, found = fastest(lambda t=target, s=stages, z=teeth: by_numpy(t, s, z), rounds)
        best = answer.best[0]
        same = "yes" if abs(found - Fraction(*target)) == abs(Fraction(best.ratio) - Fraction(*target)) else "NO"
        print(
            f"{name:24} {1e3 * own:7.1f} ms {1e3 * other:7.1f} ms   {best.ratio:>18} {best.error_value:11.2e}  {same}"
        )
    part, _ = fastest(lambda: by_loops(SIDEREAL, (12, 120)), 1)
    print(f"plain loops over 1/1600 of the pairs of two-stage products: {1e3 * part:.0f} ms")
    meshes = (Mesh("a", 99999, "p", 100000, carrier="arm"), Mesh("p", 100001, "b", 100000, carrier="arm"))
    exact, answer = fastest(lambda: train(arrangement=Network(meshes), driver="arm", driven="b", fixed="a"), rounds)
    doubles = 1.0 / (1.0 - (99999.0 / 100000.0) * (100001.0 / 100000.0))
    print(f"train of 10^10:1: {answer.ratio} in {1e6 * exact:.0f} µs; in doubles off by {doubles / 1e10 - 1.0:.1e}")


if __name__ == "__main__":
    main()
