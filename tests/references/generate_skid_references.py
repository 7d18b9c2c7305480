"""Writes skid.json: the skid tasks' answers to 40 digits, for ordinary and hard inputs.

Run: python tests/references/generate_skid_references.py [FILE]. The same bytes every time.
"""

import random
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

import skid_hard_cases
import skid_motion
from case_files import put
from found_cases import doubles, found, numbered
from mpmath import mp
from trees import draw, exact, written

G = 9.80665
Case = tuple[str, dict[str, Any]]


def road(generator: random.Random) -> dict[str, float]:
    return {
        "friction": draw(generator, 0.2, 0.9),
        "grade": draw(generator, -0.1, 0.1),
        "braking": draw(generator, 0.6, 1.0),
        "gravity": G,
    }


def speeds(generator: random.Random) -> Iterator[Case]:
    for count in [1] * 14 + [2, 2, 3, 3, 5, 8]:
        segments = []
        for _ in range(count):
            own = road(generator)
            own.pop("gravity")
            segments.append({"distance": draw(generator, 1.0, 90.0), **own})
        inputs = {"segments": segments, "end_speed": draw(generator, 0.0, 20.0), "gravity": G}
        if generator.random() < 0.5:
            inputs["mass"] = draw(generator, 700.0, 4000.0)
        yield f"{count} surfaces", inputs
    exam = {"distance": 11.0, "friction": 0.65, "grade": 0.0, "braking": 1.0}
    yield "published, examination question", {"segments": [exam], "end_speed": 3.5, "gravity": 9.81}


def distances(generator: random.Random) -> Iterator[Case]:
    for _ in range(20):
        own = {"speed": draw(generator, 10.0, 50.0), "end_speed": draw(generator, 0.0, 9.0), **road(generator)}
        own["friction"] += 0.2
        if generator.random() < 0.5:
            own["mark"] = draw(generator, 1.0, 3.0)
        yield "slowing", own


def frictions(generator: random.Random) -> Iterator[Case]:
    for count in [1] * 6 + [2, 3, 3, 4, 5, 6, 8]:
        skids = [
            {
                "speed": draw(generator, 10.0, 15.0),
                "distance": draw(generator, 10.0, 16.0),
                "grade": draw(generator, -0.08, 0.08),
                "braking": draw(generator, 0.8, 1.0),
            }
            for _ in range(count)
        ]
        yield f"{count} test skids", {"skids": skids, "gravity": G}


def drag_factors(generator: random.Random) -> Iterator[Case]:
    for _ in range(10):
        own = road(generator)
        own.pop("gravity")
        yield "surface", {"measurement": {"record": "Surface", **own}, "gravity": G}
        base = draw(generator, 2.2, 3.6)
        axles = {
            "record": "Axles",
            "front_friction": draw(generator, 0.3, 0.9),
            "rear_friction": draw(generator, 0.3, 0.9),
            "wheelbase": base,
            "cm_position": base * draw(generator, 0.35, 0.6),
            "cm_height": draw(generator, 0.4, 0.8),
            "front_braking": draw(generator, 0.5, 1.0),
            "rear_braking": draw(generator, 0.0, 1.0),
            "grade": draw(generator, -0.06, 0.06),
        }
        yield "axles", {"measurement": axles, "gravity": G}
        sled = {
            "record": "Sled",
            "pull": draw(generator, 100.0, 150.0),
            "weight": draw(generator, 170.0, 200.0),
            "pull_angle": draw(generator, -0.2, 0.4),
            "grade": draw(generator, -0.06, 0.06),
        }
        yield "sled", {"measurement": sled, "gravity": G}


def stops(generator: random.Random) -> Iterator[Case]:
    for number in range(18):
        own = {
            "speed": draw(generator, 5.0, 45.0),
            "reaction_time": draw(generator, 0.5, 2.5),
            **road(generator),
            "steps": 4,
        }
        if number % 3:
            own["build_up_time"] = draw(generator, 0.1, 0.6)
        yield "stop", own


def yaws(generator: random.Random) -> Iterator[Case]:
    for number in range(20):
        arc = {"record": "Chord", "chord": draw(generator, 10.0, 40.0), "middle_ordinate": draw(generator, 0.3, 4.0)}
        path = arc if number % 2 else {"record": "Radius", "radius": draw(generator, 20.0, 200.0)}
        own = {
            "path": path,
            "friction": draw(generator, 0.4, 0.9),
            "superelevation": draw(generator, -0.08, 0.12),
            "gravity": G,
        }
        if number % 3:
            own["track_width"] = draw(generator, 1.3, 1.8)
        yield "yaw", own


def vaults(generator: random.Random) -> Iterator[Case]:
    for _ in range(14):
        own = {"distance": draw(generator, 3.0, 50.0), "rise": draw(generator, -8.0, 2.0), "gravity": G}
        yield "vault", own


def launches(generator: random.Random) -> Iterator[Case]:
    for _ in range(16):
        own = {"distance": draw(generator, 3.0, 50.0), "rise": draw(generator, -8.0, 0.4), "gravity": G}
        yield "vault", {**own, "take_off": generator.uniform(0.15, 1.2)}


def pedestrians(generator: random.Random) -> Iterator[Case]:
    for number in range(20):
        own = {
            "throw_distance": draw(generator, 8.0, 60.0),
            "friction": draw(generator, 0.4, 0.9),
            "launch_height": draw(generator, 0.0, 1.2),
            "gravity": G,
        }
        if number % 4:
            own["launch_angle"] = generator.uniform(0.0, 0.6)
        yield "throw", own


def avoids(generator: random.Random) -> Iterator[Case]:
    for number in range(20):
        own = {
            "speed": draw(generator, 8.0, 40.0),
            "sight_distance": draw(generator, 15.0, 120.0),
            "reaction_time": draw(generator, 0.5, 2.0),
            **road(generator),
        }
        if number % 2:
            own["speed_limit"] = draw(generator, 8.0, 25.0)
        yield "avoid", own


def spins(generator: random.Random) -> Iterator[Case]:
    for number in range(20):
        turn = {
            "record": "Rotation",
            "rotation": generator.uniform(0.5, 9.0),
            "start_angle": generator.uniform(-1.5, 1.5),
            "rolling_drag": draw(generator, 0.0, 0.4),
        }
        drag = turn if number % 4 else {"record": "Share", "drag_share": draw(generator, 0.3, 1.0)}
        own = {"drag": drag, "distance": draw(generator, 3.0, 40.0), "end_speed": draw(generator, 0.0, 8.0)}
        own |= {"friction": draw(generator, 0.4, 0.9), "grade": draw(generator, -0.05, 0.05), "gravity": G}
        yield "spin", own


TASKS = {
    "speed": speeds,
    "distance": distances,
    "friction": frictions,
    "drag_factor": drag_factors,
    "stop": stops,
    "yaw": yaws,
    "vault_least_speed": vaults,
    "vault_known_angle": launches,
    "pedestrian": pedestrians,
    "avoid": avoids,
    "spin": spins,
}


def solved(task: str, inputs: dict[str, Any]) -> dict[str, Any]:
    """Inputs and results as text."""
    results = getattr(skid_motion, task)(**exact(inputs))
    return {"inputs": written(inputs), "results": {key: mp.nstr(value, 40) for key, value in results.items()}}


def generate() -> dict[str, Any]:
    cases = []
    worst = found("skid.json")
    for task, make in TASKS.items():
        for name, inputs in make(random.Random(task)):
            cases.append({"task": task, "kind": "ordinary", "name": name, **solved(task, inputs)})
        for why, name, inputs in skid_hard_cases.HARD[task]():
            cases.append({"task": task, "kind": "hard", "name": name, "why": why, **solved(task, inputs)})
        for case in worst:
            if case["task"] == task:
                own = {"kind": "hard", "name": case["name"], "why": case["why"]}
                cases.append({"task": task, **own, **solved(task, doubles(case["inputs"]))})
    about = (
        "Written by generate_skid_references.py: SI inputs as doubles, results to 40 digits from 60-digit arithmetic."
    )
    return {"about": about, "cases": numbered(cases)}


if __name__ == "__main__":
    put("skid", **generate())
