"""Random calls of every cam task: extremes, wrong signs, text for numbers; none may end as an internal error.

`CAM_FUZZ_SECONDS` makes the run longer, `CAM_FUZZ_SEED` chooses others.
"""

import json
import os
import random
import time
from typing import Any

import pytest
from harness import Outcome, answer, run

from dynamics_cli.cam.laws.names import LawName

TASKS = ("laws", "rise", "motion", "force", "profile", "size", "check", "export")
EXTREMES = ("0", "1e300", "1e-300", "-1", "1e-9", "1e9", "nan", "inf", "-0", "1e400", "", "x", "5e-324", "1 2")
MOVES = ("rise", "return", "dwell", "rise", "return", "fall")
UNITS = {"mm": 20.0, "deg": 60.0, "rpm": 600.0, "kg": 0.5, "N/mm": 5.0, "N": 60.0, "": 0.5}
STATES = ("lift", "velocity", "acceleration", "jerk", "rate_of_jerk")
FOLLOWING = (
    "base_radius", "roller_radius", "arm", "pivot_distance", "follower", "offset", "face_offset", "arm_angle",
    "roller_distance", "mate_arm", "kind",
)  # fmt: skip
CALLS = 160
LAWS = (*(name for name in LawName.names if name != "scca"), "scca 0.25 0.5 0.25", "3-4-5", "cycloidal")


def number(chance: random.Random, size: float) -> str:
    """A plain number of that size, or now and then one that no one would write."""
    kind = chance.random()
    if kind < 0.04:
        return chance.choice(EXTREMES)
    if kind < 0.1:
        return f"{10 ** chance.uniform(-12, 12):.6g}"
    return f"{size * 10 ** chance.gauss(0.0, 0.25):.4g}"


def program(chance: random.Random) -> str:
    """A turn, or nearly: spans that fit, or of any size."""
    unit = chance.choice(("mm", "mm", "in", "deg"))
    clauses = []
    if chance.random() < 0.85:
        spans = [chance.randint(20, 110) for _ in range(3)]
        lift = number(chance, 12.0)
        laws = [chance.choice(LAWS) for _ in range(2)]
        more = [chance.choice(("",) * 9 + (" 7", " 0.25 0.5 0.25", " v0=1 mm/rad")) for _ in range(2)]
        clauses = [
            f"rise {lift} {unit} in {spans[0]} deg {laws[0]}{more[0]}", f"dwell {spans[1]} deg",
            f"return in {spans[2]} deg {laws[1]}{more[1]}", "dwell",
        ]  # fmt: skip
    else:
        for _ in range(chance.randint(0, 6)):
            move = chance.choice(MOVES)
            amount = f" {chance.choice(('', 'to '))}{number(chance, 10.0)} {unit}" if move != "dwell" else ""
            clauses.append(f"{move}{amount} in {number(chance, 80.0)} deg {chance.choice(('', *LawName.names))}")
        if chance.random() < 0.5:
            clauses.append("return in 60 deg; dwell")
    return "; ".join(clauses)


def value(chance: random.Random, schema: dict[str, Any], whole: dict[str, Any]) -> Any:
    """Something for one parameter, by its schema."""
    if "$ref" in schema:
        schema = whole["$defs"][schema["$ref"].rpartition("/")[2]]
    if "enum" in schema:
        return chance.choice([*schema["enum"], "none of these"] if chance.random() < 0.05 else schema["enum"])
    if schema.get("type") == "array":
        count = chance.choice((0, 1, 2, 3, 3, 5, 12, 40) if chance.random() < 0.9 else (300,))
        return [value(chance, schema["items"], whole) for _ in range(count)]
    if schema.get("type") == "object":
        return {
            name: value(chance, part, whole)
            for name, part in schema["properties"].items()
            if name in schema.get("required", ()) or chance.random() < 0.5
        }
    if schema.get("type") == "boolean":
        return chance.random() < 0.5
    if schema.get("type") == "integer":
        return chance.choice((0, 1, 2, 3, 5, 7, 12, 37, -1, 10**30, 4))
    example = next((one for one in schema.get("examples", ()) if isinstance(one, str)), "")
    unit = example.partition(" ")[2] if example[:1].isdigit() or example[:1] == "-" else ""
    size = float(example.split()[0]) if unit else UNITS[""]
    return f"{number(chance, abs(size) or 1.0)} {unit}".strip()


def likely(chance: random.Random, task: str) -> dict[str, Any]:
    """Parameters with which a task has an answer, often."""
    found: dict[str, Any] = {}
    if task == "rise":
        found = {"law": chance.choice(LawName.names), "lift": f"{number(chance, 10.0)} mm", "span": "90 deg"}
    if task in ("rise", "laws") and (task == "rise" or chance.random() < 0.5):
        found["law"] = chance.choice((*LawName.names, "scca", "polynomial", "spline", "polynomial", "spline"))
        if found["law"] == "scca":
            found["shares"] = [chance.choice((0.25, 0.5, 0.0, 1e-9, 0.3)) for _ in range(2)]
            found["shares"].append(1.0 - sum(found["shares"]))
        if found["law"] == "spline":
            places = sorted({round(chance.random(), chance.choice((1, 3, 17))) for _ in range(chance.randint(0, 30))})
            found["points"] = [{"place": x, "lift": round(x + chance.gauss(0.0, 0.1), 3)} for x in places]
        if found["law"] == "polynomial":
            found["conditions"] = [
                {"place": x, **{name: chance.choice((0, 0, 1, 0.5, 1e-9, -30)) for name in chance.sample(STATES, 2)}}
                for x in chance.sample((0, 1, 0.5, 0.25, 1e-12, 0.3), chance.choice((2, 2, 3)))
            ]
    if task in ("rise", "laws"):
        return found
    found["program"] = program(chance)
    swing = " deg in" in found["program"].partition(";")[0]
    if task == "force":
        found["shaft_speed"] = f"{number(chance, 600.0)} rpm"
        if swing:
            found |= {"inertia": "0.002 kg*m^2", "torsion_rate": "10 N*m/rad", "preload_torque": "2 N*m"}
        else:
            found |= {
                "mass": f"{number(chance, 0.5)} kg", "spring_rate": f"{number(chance, 5.0)} N/mm",
                "preload": f"{number(chance, 60.0)} N",
            }  # fmt: skip
    if task in ("profile", "check", "export", "size") or (task == "force" and chance.random() < 0.3):
        kind = chance.choice(
            ("oscillating-roller", "oscillating-flat") if swing else ("roller", "flat-face", "knife-edge")
        )
        names = {
            "roller": ("base_radius", "roller_radius"),
            "oscillating-roller": ("base_radius", "roller_radius", "arm", "pivot_distance"),
            "oscillating-flat": ("base_radius", "pivot_distance"),
        }.get(kind, ("base_radius",))
        sizes = {"base_radius": 25.0, "roller_radius": 6.0, "arm": 80.0, "pivot_distance": 100.0}
        found["follower"] = kind
        for name in names:
            if task != "size" or name != "base_radius":
                found[name] = f"{number(chance, sizes[name])} mm"
    if task == "export":
        found["tolerance"] = chance.choice(("1 um", "10 um", "0.1 mm"))
    return found


def options(inputs: dict[str, Any], chance: random.Random) -> list[str]:
    """The parameters that options can carry plainly, now and then twice."""
    found = []
    for name, given in inputs.items():
        option = "--" + name.replace("_", "-")
        if given is True:
            found.append(option)
        elif isinstance(given, str | int) and given is not False:
            found += [option, str(given)] * (2 if chance.random() < 0.03 else 1)
    return found


def call(chance: random.Random, schemas: dict[str, Any]) -> tuple[list[str], str]:
    """One call: a task, a few of its parameters anyhow and the rest likely, in a document or as options."""
    task = chance.choice(TASKS)
    properties = schemas[task]["properties"]["inputs"]["properties"]
    inputs = likely(chance, task)
    for name in list(inputs):
        if name in properties and name != "follower" and chance.random() < 0.08:
            inputs[name] = value(chance, properties[name], schemas[task])
    rest = [name for name in properties if name not in inputs and name not in ("segments", "program", *FOLLOWING)]
    for name in chance.sample(rest, min(len(rest), chance.choice((0, 0, 1, 2)))):
        inputs[name] = value(chance, properties[name], schemas[task])
    if "segments" in properties and chance.random() < 0.05:
        del inputs["program"]
        inputs["segments"] = value(chance, properties["segments"], schemas[task])
    more = chance.choice(([], [], ["--json"], ["--explain"], ["--units", "us"], ["--format", "csv"]))
    if chance.random() < 0.5:
        return ["cam", task, *options(inputs, chance), *more], ""
    return ["cam", task, "--input", "-", *more], json.dumps(inputs)


def failure(argv: list[str], text: str) -> str | None:
    """What is wrong with how a call ends."""
    outcome: Outcome = run(*argv, stdin=text)
    wrong = outcome.status not in (0, 2, 3) or "Traceback" in outcome.err or "NaN" in outcome.out
    return f"{outcome.status} {argv} {text} {outcome.err[-400:]}" if wrong else None


@pytest.fixture(scope="module")
def schemas() -> dict[str, Any]:
    return {task: json.loads(run("schema", "cam", task).out) for task in TASKS}


def test_no_call_ends_as_an_internal_error(schemas: dict[str, Any]) -> None:
    chance = random.Random(os.environ.get("CAM_FUZZ_SEED", "15"))
    seconds = float(os.environ.get("CAM_FUZZ_SECONDS", "0"))
    stop, wrong, count = time.monotonic() + seconds, [], 0
    while count < CALLS or time.monotonic() < stop:
        found = failure(*call(chance, schemas))
        wrong += [found] if found else []
        count += 1
    assert not wrong, "\n".join(wrong)


def test_the_calls_reach_answers(schemas: dict[str, Any]) -> None:
    chance = random.Random(2)
    statuses = [run(*argv, stdin=text).status for argv, text in (call(chance, schemas) for _ in range(60))]
    assert min(map(statuses.count, (0, 2, 3))) >= 3
    assert answer("cam", "laws")["results"]
