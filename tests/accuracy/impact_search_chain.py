"""Chains of bodies against those of `impact_chains` in 700 bits."""

import json
import random
from collections.abc import Iterator
from typing import Any

from climbing import Answer, Question, Tree, arguments, bits, read, stated
from precise import Exact
from references.impact_chains import chained

from dynamics_cli.accuracy.cases import DATA, flat
from dynamics_cli.impact.particles.chain import Body, ChainLaw, chain

GROUPS: dict[str, type] = {"bodies": Body}
# Pairs that close slower than this share of the fastest body no longer collide.
NOTHING = 180
# What the exact side leaves of a result that comes to nothing, beside the fastest and the heaviest.
NOISE = 160
# A light body between heavy ones takes twice the digits of their ratio from the equations of all contacts.
BITS = 700


def exact(inputs: Tree) -> dict[str, Any]:
    """Every result of one law."""
    masses = [Exact(body["mass"]) for body in inputs["bodies"]]
    start = [Exact(body.get("velocity", 0.0)) for body in inputs["bodies"]]
    ratios = [Exact(body.get("restitution", inputs["restitution"])) for body in inputs["bodies"][:-1]]
    return chained(masses, start, ratios, inputs["law"]["word"], max(map(abs, start)) * Exact(2) ** -NOTHING)


def long(inputs: Tree) -> bool:
    """Whether pairs may collide thousands of times before, or without, an end."""
    ratios = [body.get("restitution", inputs["restitution"]) for body in inputs["bodies"][:-1]]
    return inputs["law"]["word"] == "sequential" and len(ratios) > 1 and min(ratios) < 0.4


def ask(rng: random.Random, inputs: Tree) -> Iterator[Answer]:
    """One chain by one law; of those that may cost seconds one in ten."""
    if long(inputs) and rng.random() > 0.1:
        return
    given = arguments({name: part for name, part in inputs.items() if name != "law"}, GROUPS)
    answer = chain(**given, law=ChainLaw(inputs["law"]["word"]))
    with bits(BITS):
        made = exact(inputs)
    fastest = max(abs(body["velocity"]) for body in inputs["bodies"])
    heaviest = max(body["mass"] for body in inputs["bodies"])
    noise = {"velocity": fastest, "delta_v": fastest, "energy_lost": heaviest * fastest * fastest}

    def slack(name: str) -> Any:
        return Exact(noise.get(name.rpartition(".")[2], heaviest * fastest)) * Exact(2) ** -NOISE

    yield Answer(inputs, stated(answer, flat(answer), made, slack), inputs["law"]["word"])


def draw(rng: random.Random) -> Tree:
    """Two to five bodies; pairs in turn that rebound little would collide without end, and cost seconds."""
    law = rng.choice(("sequential", "simultaneous"))
    count = rng.randrange(2, 6)
    bodies: list[dict[str, float]] = [
        {"mass": 10.0 ** rng.uniform(-3.0, 3.0) if rng.random() < 0.5 else 1.0} for _ in range(count)
    ]
    speeds = sorted((rng.choice((0.0, rng.uniform(-5.0, 5.0))) for _ in bodies), reverse=rng.random() < 0.5)
    for body, speed in zip(bodies, speeds, strict=True):
        body["velocity"] = speed
    if rng.random() < 0.2:
        for body in bodies[:-1]:
            body["restitution"] = rng.choice((0.0, 1.0, rng.random()))
    restitution = rng.choice((0.0, 1.0, rng.random()))
    if law == "sequential" and count > 2:
        restitution = rng.choice((1.0, rng.uniform(0.5, 1.0)))
    return {"bodies": bodies, "restitution": restitution, "law": {"word": law}}


def starts() -> list[Tree]:
    """The hard cases that are shipped."""
    cases = json.loads((DATA / "impact_particles.json").read_text(encoding="utf-8"))["cases"]
    return [read(case["inputs"]) for case in cases if case["task"] == "chain" and case["kind"] == "hard"]


def question() -> Question:
    """`impact chain`."""
    return Question("impact chain", starts(), draw, ask)
