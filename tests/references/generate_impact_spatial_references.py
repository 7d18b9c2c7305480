"""Writes impact_spatial.json: impacts in space to 20 digits, in the frame of the contact.

Run: python tests/references/generate_impact_spatial_references.py [FILE]; some minutes, the same bytes every time.
See impact_keller: extrapolated midpoint rules in 34 digits.
"""

import json
import math
import random
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from mpmath import mp
from references.impact_keller import impact

DATA = Path(__file__).resolve().parents[2] / "dynamics_cli" / "accuracy" / "data"
LAWS = ("stronge", "newton", "poisson")


def matrix(generator: random.Random, floor: float = 0.1) -> list[list[float]]:
    """A random symmetric matrix with eigenvalues of at least about `floor`."""
    rows = [[generator.gauss(0.0, 1.0) for _ in range(3)] for _ in range(3)]
    full = [[sum(a * b for a, b in zip(x, y, strict=True)) for y in rows] for x in rows]
    return [[full[min(i, j)][max(i, j)] + (floor if i == j else 0.0) for j in range(3)] for i in range(3)]


def symmetric(a: float, b: float, c: float, d: float, e: float, f: float) -> list[list[float]]:
    return [[a, b, c], [b, d, e], [c, e, f]]


def scenes() -> list[tuple[str, str, str, list[list[float]], list[float], float, float, str]]:
    r = random.Random(1986)
    found = []
    for index in range(12):
        speed = r.choice([0.3, 1.0, 5.0])
        u = [r.gauss(0.0, speed), r.gauss(0.0, speed), -r.uniform(0.2, 3.0)]
        law = LAWS[index % 3]
        found.append(
            (f"random {index}, {law}", "ordinary", "", matrix(r), u, r.uniform(0.05, 0.9), r.uniform(0.0, 1.0), law)
        )
    k = symmetric(3.0, 0.4, -0.9, 2.0, 0.7, 1.5)

    def hard(name: str, why: str, k: list[list[float]], u: list[float], mu: float, e: float, law: str) -> None:
        found.append((f"{name}, {law}", "hard", why, k, u, mu, e, law))

    for law in LAWS:
        hard("slip turns at once near zero", "the slip passes zero at a part of its size and comes out another way",
             k, [0.3, -0.62, -1.0], 0.25, 0.5, law)  # fmt: skip
        hard("slip stops and sticks", "slip approaches zero along the one direction that its rate keeps", k,
             [0.4, 0.3, -1.0], 0.9, 0.6, law)  # fmt: skip
        hard("slip stops and starts anew", "friction cannot hold: the way out is a root of its own",
             symmetric(1.3, -0.5, 0.7, 5.5, -0.1, 1.1), [-0.48, -0.78, -1.0], 0.44, 0.6, law)  # fmt: skip
        hard("jam", "the normal velocity falls at first, so that it is no clock",
             symmetric(26.0, 0.5, -15.0, 3.0, 0.4, 10.0), [-6.0, 0.7, -1.0], 1.5, 0.5, law)  # fmt: skip
        hard("grazing", "slip is nine orders above the approach", k, [12.0, -3.0, -1e-9], 0.4, 0.5, law)
        hard("hardly any slip", "slip is twelve orders below the approach", k, [1e-12, -2e-12, -1.0], 0.3, 0.5, law)
    hard("from rest, held", "no slip at first: stick is decided by K alone", k, [0.0, 0.0, -1.0], 0.6, 0.5, "stronge")
    hard("from rest, not held", "no slip at first: it starts along the way out",
         symmetric(2.0, 0.1, -1.2, 2.2, 0.3, 1.6), [0.0, 0.0, -1.0], 0.3, 0.5, "stronge")  # fmt: skip
    hard("plastic", "the law's end is that of compression", k, [1.0, 2.0, -1.0], 0.3, 0.0, "stronge")
    hard("elastic", "nothing may be lost but to friction", k, [1.0, 2.0, -1.0], 0.3, 1.0, "stronge")
    hard("threshold of stick", "friction is that which just holds, rounded", symmetric(2.0, 0.0, -1.0, 2.0, 0.0, 2.0),
         [0.3, 0.2, -1.0], 0.5, 0.5, "stronge")  # fmt: skip
    hard("threshold of stick, just below", "friction is one rounding short of what holds",
         symmetric(2.0, 0.0, -1.0, 2.0, 0.0, 2.0), [0.3, 0.2, -1.0], math.nextafter(0.5, 0.0), 0.5,
         "stronge")  # fmt: skip
    hard("planar in space", "the slip keeps its line, the closed form is known",
         symmetric(2.0, 0.0, -1.0, 3.0, 0.0, 2.0), [0.5, 0.0, -1.0], 0.4, 0.5, "stronge")  # fmt: skip
    hard("long lever", "K is nearly singular", symmetric(2.0001, 1.9, -1.95, 2.0002, -1.95, 2.0003), [0.7, -0.2, -1.0],
         0.4, 0.5, "stronge")  # fmt: skip
    return found


def answered(scene: Any) -> dict[str, Any]:
    mp.dps = 34
    name, kind, why, k, u, mu, e, law = scene
    impulse, compression = impact(k, u, mu, e, law)
    texts = {f"impulse[{i}]": mp.nstr(part + 0, 20, strip_zeros=True) for i, part in enumerate(impulse)}
    texts["compression"] = mp.nstr(compression, 20, strip_zeros=True)
    case = {"task": "spatial", "kind": kind, "name": name, **({"why": why} if why else {})}
    inputs = {
        "mobility": [[repr(x) for x in row] for row in k], "velocity": [repr(x) for x in u], "friction": repr(mu),
        "restitution": repr(e), "law": law,
    }  # fmt: skip
    return {**case, "inputs": inputs, "results": texts}


def main() -> None:
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else DATA / "impact_spatial.json"
    rows = ",\n".join(json.dumps(answered(scene), ensure_ascii=False) for scene in scenes())
    about = "Written by generate_impact_spatial_references.py: doubles in, 20 digits out, in the frame of the contact."
    target.write_text(f'{{"about": "{about}",\n"cases": [\n{rows}\n]}}\n', encoding="utf-8")


if __name__ == "__main__":
    main()
