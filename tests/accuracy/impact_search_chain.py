"""Chains of bodies: pairs in turn, and every set of acting contacts tried, in 700 bits."""

import json
import random
from collections.abc import Iterator
from itertools import combinations
from typing import Any

from climbing import Answer, Question, Tree, arguments, bits, read, stated
from precise import Exact

from dynamics_cli.accuracy.cases import DATA, flat
from dynamics_cli.impact.particles.chain import Body, ChainLaw, chain

GROUPS: dict[str, type] = {"bodies": Body}
# Pairs that close slower than this share of the fastest body no longer collide.
NOTHING = 180
# What the exact side leaves of a result that comes to nothing, beside the fastest and the heaviest.
NOISE = 160
MOST_HITS = 3000
# A light body between heavy ones takes twice the digits of their ratio from the equations of all contacts.
BITS = 700


def line_hit(m: Any, other: Any, v: Any, w: Any, e: Any) -> tuple[Any, Any]:
    """Velocities after two bodies have met: by their common velocity, and what restitution gives back."""
    common = (m * v + other * w) / (m + other)
    return common + other * e * (w - v) / (m + other), common + m * e * (v - w) / (m + other)


def in_turn(masses: list[Any], v: list[Any], ratios: list[Any], least: Any) -> list[Any]:
    """Impulses of pairs one after another, the one that closes fastest first; changes the velocities."""
    pushes = [Exact(0)] * len(ratios)
    for _ in range(MOST_HITS):
        closing = [v[i] - v[i + 1] for i in range(len(ratios))]
        i = max(range(len(ratios)), key=closing.__getitem__)
        if closing[i] <= least:
            return pushes
        before = v[i]
        v[i], v[i + 1] = line_hit(masses[i], masses[i + 1], v[i], v[i + 1], ratios[i])
        pushes[i] += masses[i] * (before - v[i])
    raise ArithmeticError("too many collisions to follow")


def solved(rows: list[list[Any]], right: list[Any]) -> list[Any]:
    """Linear equations by elimination; of masses, so that no pivot vanishes."""
    size = len(right)
    a = [[*row, value] for row, value in zip(rows, right, strict=True)]
    for k in range(size):
        for i in range(k + 1, size):
            factor = a[i][k] / a[k][k]
            for j in range(k, size + 1):
                a[i][j] -= factor * a[k][j]
    found = [Exact(0)] * size
    for k in reversed(range(size)):
        found[k] = (a[k][size] - sum(a[k][j] * found[j] for j in range(k + 1, size))) / a[k][k]
    return found


def coupling(masses: list[Any], i: int, j: int) -> Any:
    """How much faster contact i opens by a unit impulse in contact j."""
    if i == j:
        return 1 / masses[i] + 1 / masses[i + 1]
    return -1 / masses[max(i, j)] if abs(i - j) == 1 else Exact(0)


def at_once(masses: list[Any], v: list[Any], ratios: list[Any], least: Any) -> list[Any]:
    """Impulses of all contacts at one moment, in rounds; of every set of acting contacts the one without tension."""
    count = len(ratios)
    k = [[coupling(masses, i, j) for j in range(count)] for i in range(count)]
    pushes = [Exact(0)] * count
    for _ in range(MOST_HITS):
        closing = [v[i] - v[i + 1] for i in range(count)]
        if max(closing) <= least:
            return pushes
        for i, p in enumerate(_plastic(k, closing, least)):
            grown = (1 + ratios[i]) * p
            pushes[i] += grown
            v[i] -= grown / masses[i]
            v[i + 1] += grown / masses[i + 1]
    raise ArithmeticError("too many rounds to follow")


def _plastic(k: list[list[Any]], closing: list[Any], least: Any) -> list[Any]:
    """The impulses after which no contact closes."""
    count = len(closing)
    for size in range(1, count + 1):
        for acting in combinations(range(count), size):
            part = solved([[k[i][j] for j in acting] for i in acting], [closing[i] for i in acting])
            # what rounding leaves of a contact that just does not act is no tension
            if any(k[i][i] * p < -least for i, p in zip(acting, part, strict=True)):
                continue
            made = [part[acting.index(i)] if i in acting else Exact(0) for i in range(count)]
            opened = [sum(k[i][j] * p for j, p in enumerate(made)) for i in range(count)]
            if all(o >= u - least for o, u in zip(opened, closing, strict=True)):
                return made
    raise AssertionError("no set of contacts holds")


def exact(inputs: Tree) -> dict[str, Any]:
    """Every result of one law."""
    masses = [Exact(body["mass"]) for body in inputs["bodies"]]
    start = [Exact(body.get("velocity", 0.0)) for body in inputs["bodies"]]
    ratios = [Exact(body.get("restitution", inputs["restitution"])) for body in inputs["bodies"][:-1]]
    v, least = list(start), max(map(abs, start)) * Exact(2) ** -NOTHING
    follow = in_turn if inputs["law"]["word"] == "sequential" else at_once
    pushes = follow(masses, v, ratios, least)
    out = {
        "momentum": sum(m * x for m, x in zip(masses, start, strict=True)),
        "laws[0].energy_lost": sum(m * (a - b) * (a + b) for m, a, b in zip(masses, start, v, strict=True)) / 2,
    }
    for i, speed in enumerate(v):
        out |= {f"bodies[{i}].velocity": speed, f"bodies[{i}].delta_v": speed - start[i]}
        if i < len(pushes):
            out[f"bodies[{i}].impulse_to_next"] = pushes[i]
    return out


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
