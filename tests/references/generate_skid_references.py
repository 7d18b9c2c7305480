"""Writes skid.json: the skid tasks' answers to 40 digits, for ordinary and hard inputs.

Run: python tests/references/generate_skid_references.py [FILE]. The same bytes every time.
"""

import json
import random
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

import skid_motion
from mpmath import mp, mpf

G = 9.80665
DATA = Path(__file__).resolve().parents[2] / "dynamics_cli" / "accuracy" / "data"
Case = tuple[str, str, dict[str, Any]]


def exact(tree: Any) -> Any:
    """Doubles as exact numbers."""
    if isinstance(tree, float):
        return mpf(tree)
    if isinstance(tree, dict):
        return {name: exact(part) for name, part in tree.items()}
    return [exact(part) for part in tree] if isinstance(tree, list) else tree


def written(tree: Any) -> Any:
    """Doubles as text that reads back to the same bits."""
    if isinstance(tree, float):
        return repr(tree)
    if isinstance(tree, dict):
        return {name: written(part) for name, part in tree.items()}
    return [written(part) for part in tree] if isinstance(tree, list) else tree


def draw(generator: random.Random, low: float, high: float) -> float:
    """A double as a person would write it, or any double."""
    value = generator.uniform(low, high)
    return round(value, 2) if generator.random() < 0.4 else value


def segment(d: float, f: float, grade: float = 0.0, braking: float = 1.0) -> dict[str, float]:
    return {"distance": d, "friction": f, "grade": grade, "braking": braking}


def road(generator: random.Random) -> dict[str, float]:
    return {
        "friction": draw(generator, 0.2, 0.9),
        "grade": draw(generator, -0.1, 0.1),
        "braking": draw(generator, 0.6, 1.0),
        "gravity": G,
    }


NEAR_ZERO = [-0.7 * (1.0 - 1e-3), -0.7 * (1.0 - 1e-8), -0.7 * (1.0 - 1e-12), -0.7 + 1e-15]


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
        yield "ordinary", f"{count} surfaces", inputs
    for grade in NEAR_ZERO:
        yield (
            "hard",
            f"drag near zero, grade {grade!r}",
            {"segments": [segment(60.0, 0.7, grade)], "end_speed": 3.0, "gravity": G},
        )
    for end, d in [(30.0, 1e-9), (30.0, 1e-20), (13.0, 5e-324), (0.0, 0.0), (12.0, 0.0), (1e-12, 20.0)]:
        yield "hard", f"end {end!r} after {d!r} m", {"segments": [segment(d, 0.7)], "end_speed": end, "gravity": G}
    for d, f, grade in [
        (1e-300, 0.7, 0.0),
        (1e300, 0.7, 0.0),
        (60.0, 1e-300, 0.0),
        (60.0, 0.7, 1e16),
        (60.0, 1e-9, 1e-9),
    ]:
        inputs = {"segments": [segment(d, f, grade)], "end_speed": 0.0, "gravity": G}
        yield "hard", f"{d!r} m, friction {f!r}, grade {grade!r}", inputs
    mixed = [segment(1e-6, 0.05), segment(500.0, 0.9, -0.3), segment(3.0, 0.01, 0.2, 0.0), segment(40.0, 0.5, 0.1, 0.5)]
    yield "hard", "surfaces of very different work", {"segments": mixed, "end_speed": 0.1, "gravity": G, "mass": 1500.0}


def distances(generator: random.Random) -> Iterator[Case]:
    for _ in range(20):
        own = {"speed": draw(generator, 10.0, 50.0), "end_speed": draw(generator, 0.0, 9.0), **road(generator)}
        own["friction"] += 0.2
        if generator.random() < 0.5:
            own["mark"] = draw(generator, 1.0, 3.0)
        yield "ordinary", "slowing", own
    base = {"friction": 0.7, "grade": 0.0, "braking": 1.0, "gravity": G}
    for v, end in [
        (30.0, 30.0),
        (30.0, 29.999999999999996),
        (30.0, 29.9999999),
        (1e-300, 0.0),
        (1e150, 1.0),
        (0.0, 0.0),
    ]:
        yield "hard", f"{v!r} to {end!r}", {**base, "speed": v, "end_speed": end}
    for grade in NEAR_ZERO:
        yield "hard", f"drag near zero, grade {grade!r}", {**base, "grade": grade, "speed": 30.0, "end_speed": 10.0}
    # 32²/(2·16·0.5) = 64: a mark that ends at the stop, and one that misses it by half a millionth of a nanometre
    stop = {**base, "speed": 32.0, "friction": 0.5, "gravity": 16.0, "end_speed": 0.0}
    for mark in [64.0, 63.99999999999999, 63.999999]:
        yield "hard", f"mark {mark!r} of a stop of 64", {**stop, "mark": mark}
    for mark in [65.5, 65.553, 65.55318, 1e-15]:
        yield "hard", f"mark {mark!r} near the stop", {**base, "speed": 30.0, "end_speed": 0.0, "mark": mark}


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
        yield "ordinary", f"{count} test skids", {"skids": skids, "gravity": G}
    one = {"speed": 13.4, "distance": 12.9, "grade": 0.0, "braking": 1.0}
    yield "hard", "equal test skids", {"skids": [one, one, one], "gravity": G}
    yield "hard", "nearly equal", {"skids": [one, {**one, "distance": 12.900000000001}], "gravity": G}
    yield "hard", "steep", {"skids": [{**one, "grade": 0.70}], "gravity": G}
    yield "hard", "downhill", {"skids": [{**one, "grade": -0.9}], "gravity": G}
    yield "hard", "tiny", {"skids": [{**one, "speed": 1e-100, "distance": 1e-200}], "gravity": G}


AXLES = {
    "record": "Axles",
    "front_friction": 0.75,
    "rear_friction": 0.75,
    "wheelbase": 2.7,
    "cm_position": 1.2,
    "cm_height": 0.55,
    "front_braking": 1.0,
    "rear_braking": 0.4,
    "grade": 0.0,
}
SLED = {"record": "Sled", "pull": 130.0, "weight": 180.0, "pull_angle": 0.0, "grade": 0.0}


def drag_factors(generator: random.Random) -> Iterator[Case]:
    for _ in range(10):
        own = road(generator)
        own.pop("gravity")
        yield "ordinary", "surface", {"measurement": {"record": "Surface", **own}, "gravity": G}
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
        yield "ordinary", "axles", {"measurement": axles, "gravity": G}
        sled = {
            "record": "Sled",
            "pull": draw(generator, 100.0, 150.0),
            "weight": draw(generator, 170.0, 200.0),
            "pull_angle": draw(generator, -0.2, 0.4),
            "grade": draw(generator, -0.06, 0.06),
        }
        yield "ordinary", "sled", {"measurement": sled, "gravity": G}
    for grade in NEAR_ZERO:
        surface = {"record": "Surface", "friction": 0.7, "grade": grade, "braking": 1.0}
        yield "hard", f"drag near zero, grade {grade!r}", {"measurement": surface, "gravity": G}
    for change in [
        {"rear_braking": 0.0},
        {"cm_height": 1.599999999},
        {"cm_height": 2.2857142857, "front_braking": 0.7},
        {"cm_height": 0.0},
        {"grade": -0.45},
        {"cm_position": 2.699999999999},
        {"front_braking": 0.0},
    ]:
        yield "hard", f"axles with {change}", {"measurement": {**AXLES, **change}, "gravity": G}
    for change in [
        {"pull_angle": 1.2},
        {"grade": -0.3, "pull": 20.0},
        {"pull_angle": -1.5},
        {"grade": 0.5, "pull": 100.0},
    ]:
        yield "hard", f"sled with {change}", {"measurement": {**SLED, **change}, "gravity": G}


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
        yield "ordinary", "stop", own
    base = {
        "speed": 20.0,
        "reaction_time": 1.0,
        "friction": 0.7,
        "grade": 0.0,
        "braking": 1.0,
        "steps": 3,
        "gravity": G,
    }
    for change in [
        {"build_up_time": 0.0},
        {"build_up_time": 5.8},
        {"build_up_time": 5.826944438860908},
        {"build_up_time": 5.8269444388609065},
        {"build_up_time": 5.826944438860909},
        {"speed": 28.29286781753336, "friction": 1.1, "grade": -0.69, "braking": 0.63, "build_up_time": 1924.5},
        {"build_up_time": 8.0},
        {"reaction_time": 0.0, "build_up_time": 1e-12},
        {"speed": 1e-9, "build_up_time": 0.3},
        {"grade": -0.7 + 1e-12, "build_up_time": 0.3},
        {"speed": 1e100},
    ]:
        yield "hard", f"stop with {change}", {**base, **change}


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
        yield "ordinary", "yaw", own
    base = {"path": {"record": "Radius", "radius": 60.0}, "friction": 0.8, "superelevation": 0.0, "gravity": G}
    for change in [
        {"superelevation": 1.25 - 1e-9},
        {"superelevation": 1.2499999999999998},
        {"superelevation": -0.8 + 1e-12},
        {"friction": 0.0, "superelevation": 0.1},
        {"track_width": 119.99999999},
        {"path": {"record": "Chord", "chord": 30.0, "middle_ordinate": 1e-12}},
        {"path": {"record": "Chord", "chord": 1e-3, "middle_ordinate": 40.0}},
        {"path": {"record": "Chord", "chord": 30.0, "middle_ordinate": 15.0}},
        {"path": {"record": "Chord", "chord": 1e200, "middle_ordinate": 1e199}},
    ]:
        yield "hard", f"yaw with {change}", {**base, **change}


def vaults(generator: random.Random) -> Iterator[Case]:
    for _ in range(14):
        own = {"distance": draw(generator, 3.0, 50.0), "rise": draw(generator, -8.0, 2.0), "gravity": G}
        yield "ordinary", "vault", own
    for x, y in [
        (20.0, 0.0),
        (1e-9, -5.0),
        (1e-9, 5.0),
        (1e9, -5.0),
        (20.0, -1e-12),
        (1e-150, 1e-150),
        (1e150, -1e150),
    ]:
        yield "hard", f"{x!r} m out, {y!r} m up", {"distance": x, "rise": y, "gravity": G}


def launches(generator: random.Random) -> Iterator[Case]:
    for _ in range(16):
        own = {"distance": draw(generator, 3.0, 50.0), "rise": draw(generator, -8.0, 0.4), "gravity": G}
        yield "ordinary", "vault", {**own, "take_off": generator.uniform(0.15, 1.2)}
    near_vertical, sight = 1.5707963267948966, 0.4636476090008061
    for x, y, angle in [
        (20.0, 0.0, 1e-9),
        (20.0, 0.0, 1e-300),
        (20.0, -2.0, 0.0),
        (20.0, -2.0, -0.09),
        (20.0, -2.0, -0.0996686524),
        (20.0, -2.0, near_vertical - 1e-9),
        (20.0, 3.0, near_vertical - 2e-15),
        (20.0, 10.0, sight + 1e-3),
        (20.0, 10.0, sight + 1e-10),
        (20.0, 10.0, 0.7853981633974483),
        (1e-200, -1e-200, 0.3),
        (1e200, -1e200, 0.3),
    ]:
        yield "hard", f"{x!r}, {y!r} at {angle!r}", {"distance": x, "rise": y, "take_off": angle, "gravity": G}


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
        yield "ordinary", "throw", own
    base = {"throw_distance": 25.0, "friction": 0.66, "launch_height": 1.0, "gravity": G}
    for change in [
        {"throw_distance": 0.66 + 1e-12},
        {"launch_height": 0.0, "launch_angle": 0.0},
        {"launch_angle": -0.4},
        {"launch_height": 0.0, "launch_angle": -0.9},
        {"launch_height": 0.0, "launch_angle": 0.98},
        {"launch_height": 0.0, "launch_angle": 0.9874},
        {"friction": 1e-9, "launch_angle": 0.3},
        {"throw_distance": 1e200, "launch_height": 0.0, "launch_angle": 0.2},
        {"launch_angle": 1e-300},
        {"launch_height": 0.0, "launch_angle": 0.95},
        {"friction": 0.5773502691896257, "launch_height": 0.0},
        {"friction": 0.5773502691896258, "launch_height": 0.0},
        {"friction": 0.577, "launch_height": 0.0},
        {"friction": 0.578, "launch_height": 0.0},
        {"friction": 0.4, "throw_distance": 2.0},
        {"friction": 3.0, "throw_distance": 60.0},
        {"throw_distance": 1.32},
        {"throw_distance": 1.3},
        {"throw_distance": 1.34, "launch_angle": 1e-3},
        {"friction": 0.2, "throw_distance": 1e4, "launch_angle": 1.3},
        {"friction": 0.9, "launch_height": 0.3, "launch_angle": 0.8},
    ]:
        yield "hard", f"throw with {change}", {**base, **change}


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
        yield "ordinary", "avoid", own
    base = {
        "speed": 25.0,
        "sight_distance": 50.0,
        "reaction_time": 1.5,
        "friction": 0.7,
        "grade": 0.0,
        "braking": 1.0,
        "gravity": G,
    }
    for change in [
        {"speed": 17.85427588404575},
        {"speed": 17.854275884045748},
        {"speed": 17.854275884045752},
        {"speed": 17.8542},
        {"reaction_time": 2.0},
        {"reaction_time": 3.0},
        {"reaction_time": 0.0},
        {"reaction_time": 1e9},
        {"speed": 0.0},
        {"grade": -0.7 + 1e-12},
        {"sight_distance": 1e-200},
        {"sight_distance": 1e200},
        {"speed": 33.333333333333336},
        {"speed": 33.33333333333333},
        {"speed": 17.85427589},
    ]:
        yield "hard", f"avoid with {change}", {**base, **change}


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
        yield "ordinary", "spin", own
    base = {"distance": 20.0, "friction": 0.7, "end_speed": 0.0, "grade": 0.0, "gravity": G}
    pi = 3.141592653589793
    for turned, start, rolling in [
        (pi, 0.0, 0.0),
        (2 * pi, 0.0, 0.0),
        (100 * pi, 0.3, 0.0),
        (1e-9, 0.0, 0.1),
        (1e-9, 0.7, 0.0),
        (pi / 2, pi / 2, 0.0),
        (3.0, -0.1, 0.0),
        (0.2, 3.1, 0.0),
        (1e-6, pi - 5e-7, 0.0),
        (12345.678, -2.5, 0.05),
    ]:
        drag = {"record": "Rotation", "rotation": turned, "start_angle": start, "rolling_drag": rolling}
        yield "hard", f"spin by {turned!r} from {start!r}", {**base, "drag": drag}
    share = {"record": "Share", "drag_share": 0.5}
    yield "hard", "spin near zero drag", {**base, "drag": share, "grade": -0.35 + 1e-12}
    yield "hard", "short spin at speed", {**base, "drag": share, "distance": 1e-12, "end_speed": 30.0}


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


def generate() -> dict[str, Any]:
    cases = []
    for task, make in TASKS.items():
        for kind, name, inputs in make(random.Random(task)):
            results = getattr(skid_motion, task)(**exact(inputs))
            texts = {key: mp.nstr(value, 40) for key, value in results.items()}
            cases.append({"task": task, "kind": kind, "name": name, "inputs": written(inputs), "results": texts})
    about = (
        "Written by generate_skid_references.py: SI inputs as doubles, results to 40 digits from 60-digit arithmetic."
    )
    return {"about": about, "cases": cases}


def main(target: Path) -> None:
    data = generate()
    lines = [json.dumps(case, ensure_ascii=False) for case in data["cases"]]
    text = f'{{"about": {json.dumps(data["about"])},\n"cases": [\n' + ",\n".join(lines) + "\n]}\n"
    target.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else DATA / "skid.json")
