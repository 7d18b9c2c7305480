"""Writes linkage.json: answers of the linkage tasks to 40 digits, for ordinary and hard inputs.

Run: python tests/references/generate_linkage_references.py [FILE]. The same bytes every time.
"""

import random
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

import linkage_exact
from case_files import put
from mpmath import mp, mpf, pi
from trees import exact, written

Case = tuple[str, str, dict[str, Any], dict[str, str]]
# At these lengths are what was typed, not the doubles nearest to it: the difference decides.
TYPED = "limit: nearly a change point, of the decimals as typed"
CHANGE = "limit: both motions through a change point all but meet"
DEGREE = 0.017453292519943295
MOTION = {"speed": 10.0, "angular_acceleration": 5.0, "point": [0.06, 0.04], "load_torque": 12.0}


def links(a: float, b: float, c: float, d: float) -> dict[str, Any]:
    return {"crank": a, "coupler": b, "rocker": c, "ground": d}


def four_bars(generator: random.Random) -> Iterator[Case]:
    for branch in ("open", "crossed"):
        yield (
            f"crank-rocker, {branch}",
            "",
            links(0.04, 0.12, 0.08, 0.1) | {"crank_angle": 40 * DEGREE} | MOTION,
            {"branch": branch},
        )
    drawn = 0
    while drawn < 24:
        a, b, c, d = (round(generator.uniform(0.02, 0.2), 3) for _ in range(4))
        angle = generator.uniform(-3.0, 3.0)
        f = abs(a * mp.expj(angle) - d)
        if abs(b - c) + 0.004 < f < b + c - 0.004:
            drawn += 1
            yield (
                "drawn",
                "",
                links(a, b, c, d) | {"crank_angle": angle} | MOTION,
                {"branch": generator.choice(("open", "crossed"))},
            )
    tiny = links(1e-6, 1.0, 0.8, 0.9) | {"crank_angle": 70 * DEGREE} | MOTION | {"speed": 1.0}
    yield "a crank of a micrometre", "limit: rates of the rocker are small differences", tiny, {"branch": "open"}
    for branch in ("open", "crossed"):
        near = links(1.0, 3.0, 1.000000001, 3.0) | {"crank_angle": float(pi) + 1e-6} | MOTION
        yield f"1e-9 from a parallelogram, {branch}", TYPED, near, {"branch": branch}
    for step in (1e-3, 1e-6, 1e-9):
        for branch in ("open", "crossed"):
            change = links(2.0, 5.0, 4.0, 3.0) | {"crank_angle": step} | MOTION
            yield f"{step:g} past a change point, {branch}", CHANGE, change, {"branch": branch}
    decimals = links(0.1, 0.5, 0.3, 0.7) | {"crank_angle": 3.1415926} | MOTION
    yield "beside a change point of decimals", TYPED, decimals, {"branch": "open"}
    for step in (1e-3, 1e-6, 1e-8):
        near = links(3.0, 2.0, 2.5, 4.0) | {"crank_angle": 1.3715642395497258 - step} | MOTION
        yield f"{step:g} before the limit", "limit: coupler and rocker nearly stretched", near, {"branch": "open"}


def classes(generator: random.Random) -> Iterator[Case]:
    yield "crank-rocker", "", links(0.04, 0.12, 0.08, 0.1), {}
    yield "triple rocker", "", links(3.0, 2.0, 2.5, 4.0), {}
    drawn = 0
    while drawn < 30:
        lengths = [round(generator.uniform(0.02, 0.2), 3) for _ in range(4)]
        s, p, q, longest = sorted(lengths)
        if longest < s + p + q - 0.004 and abs(s + longest - p - q) > 0.002:
            drawn += 1
            yield "drawn", "", links(*lengths), {}


def sliders(generator: random.Random) -> Iterator[Case]:
    more = {"speed": 100.0, "angular_acceleration": -20.0, "load_force": 500.0}
    first = {"crank": 0.05, "rod": 0.15, "offset": 0.02, "crank_angle": 60 * DEGREE}
    yield "offset", "", first | more, {}
    for step in (1e-7, 1e-3):
        centre = {"crank": 0.05, "rod": 0.15, "offset": 0.0, "crank_angle": step}
        yield f"{step:g} past dead centre", "limit: the drop is 1e-14 of the stroke", centre | more, {}
    for _ in range(15):
        crank = round(generator.uniform(0.02, 0.06), 3)
        own = {"crank": crank, "rod": round(generator.uniform(2.2, 4.0) * crank, 3)}
        own |= {"offset": round(generator.uniform(-0.8, 0.8) * crank, 3), "crank_angle": generator.uniform(-3.0, 6.0)}
        yield "drawn", "", own | more, {}


def returns(generator: random.Random) -> Iterator[Case]:
    more = {"speed": 10.0, "angular_acceleration": 4.0, "lever": 0.25}
    yield "oscillating", "", {"crank": 0.05, "ground": 0.12, "crank_angle": 75 * DEGREE} | more, {}
    close = {"crank": 0.05, "ground": 0.05 + 2.0**-40, "crank_angle": 1e-9}
    yield "a pin that all but meets the pivot", "limit: the lever turns over within a billionth", close | more, {}
    for _ in range(15):
        own = {"crank": round(generator.uniform(0.02, 0.2), 3), "ground": round(generator.uniform(0.02, 0.2), 3)}
        yield "drawn", "", own | {"crank_angle": generator.uniform(-3.0, 6.0)} | more, {}


def bodies(generator: random.Random) -> Iterator[Case]:
    for _ in range(15):
        own = {name: [round(generator.uniform(-3.0, 3.0), 2) for _ in range(2)] for name in ("point", "velocity")}
        own["acceleration"] = [round(generator.uniform(-9.0, 9.0), 2) for _ in range(2)]
        rest = {"record": "Turning", "angular_velocity": round(generator.uniform(0.5, 9.0), 2)}
        yield "drawn", "", own | {"rest": rest | {"angular_acceleration": round(generator.uniform(-9.0, 9.0), 2)}}, {}


def chains(generator: random.Random) -> Iterator[Case]:
    for count in (1, 2, 3, 3, 4, 5):
        group = [
            {
                "record": "ChainLink",
                "length": round(generator.uniform(0.1, 0.5), 3), "angle": generator.uniform(-3.0, 3.0),
                "speed": round(generator.uniform(-5.0, 5.0), 2), "acceleration": round(generator.uniform(-9.0, 9.0), 2),
            }
            for _ in range(count)
        ]  # fmt: skip
        yield f"{count} links", "", {"links": group}, {}


def yokes(generator: random.Random) -> Iterator[Case]:
    more = {"speed": 31.0, "angular_acceleration": -20.0, "load_force": 500.0}
    for _ in range(8):
        own = {"crank": round(generator.uniform(0.02, 0.2), 3), "crank_angle": generator.uniform(-3.0, 6.0)}
        yield "drawn", "", own | {"slot_angle": round(generator.uniform(-1.2, 1.2), 2)} | more, {}
    steep = {"crank": 0.04, "crank_angle": 0.7, "slot_angle": 1.5707}
    yield "a slot all but along the stroke", "limit: reach over a cosine that vanishes", steep | more, {}


def couplings(generator: random.Random) -> Iterator[Case]:
    for _ in range(6):
        own = {"offset": round(generator.uniform(0.001, 0.02), 4), "speed": round(generator.uniform(-300, 300), 1)}
        yield "drawn", "", own | {"shaft_angle": generator.uniform(-3.0, 6.0), "mass": 0.2}, {}
    yield (
        "slot along the line of the shafts",
        "",
        {"offset": 0.003, "speed": 157.0, "shaft_angle": 0.0, "mass": 0.2},
        {},
    )


def bars(generator: random.Random) -> Iterator[Case]:
    for index in range(12):
        bar = round(generator.uniform(0.2, 6.0), 2)
        own = {"bar": bar, "point": round(generator.uniform(-1.0, 2.0) * bar, 2), "angle": generator.uniform(0.2, 1.5)}
        turning = {
            "speed": round(generator.uniform(-3, 3), 2),
            "angular_acceleration": round(generator.uniform(-9, 9), 2),
        }
        pulled = {"pull": round(generator.uniform(0.1, 2), 2), "pull_acceleration": round(generator.uniform(-9, 9), 2)}
        yield "drawn", "", own | (turning if index % 2 else pulled), {}
    flat = {"bar": 5.0, "point": 2.0, "angle": 1e-6, "pull": -0.5, "pull_acceleration": 0.1}
    yield "a bar all but along its slide", "limit: the rates grow without bound there", flat, {}


TASKS = {
    "four_bar": four_bars, "classify": classes, "slider_crank": sliders, "quick_return": returns, "body": bodies,
    "chain": chains, "scotch_yoke": yokes, "oldham": couplings, "trammel": bars,
}  # fmt: skip


def generate() -> list[dict[str, Any]]:
    cases = []
    for task, make in TASKS.items():
        for name, why, inputs, choices in make(random.Random(task)):
            given = exact(inputs)
            if why == TYPED:
                given |= {name: mpf(repr(inputs[name])) for name in ("crank", "coupler", "rocker", "ground")}
            results = getattr(linkage_exact, task)(**given, **choices)
            own = {"task": task, "kind": "hard" if why else "ordinary", "name": name}
            own |= {"why": why} if why else {}
            own |= {"inputs": written(inputs)} | ({"choices": choices} if choices else {})
            cases.append(own | {"results": {key: mp.nstr(value, 40) for key, value in results.items()}})
    seen: dict[tuple[str, str], int] = {}
    for case in cases:
        key = (case["task"], case["name"])
        seen[key] = seen.get(key, 0) + 1
        if sum((one["task"], one["name"].partition(" no. ")[0]) == key for one in cases) > 1:
            case["name"] = f"{case['name']} no. {seen[key]}"
    return cases


def main() -> None:
    about = "Written by generate_linkage_references.py: SI inputs as doubles, results to 40 digits from 60-digit work."
    put("linkage", about, generate())


if __name__ == "__main__":
    main()
