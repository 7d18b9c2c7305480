"""How often the stated 95 % interval of a crash contains the truth, over random scenes; and its width beside samples.

Each scene has true values, drawn from wide ranges, and measurements of them with the errors that the scene states. The
truth is the crash of the true values, by a formula of this file. The program sees the measurements alone.

    python tests/impact/crash_coverage.py [SCENES] [SEED]        coverage; 500 scenes take some ten minutes
    python tests/impact/crash_coverage.py --ill [SCENES] [SEED]  widths of scenes whose paths hardly cross
"""

import math
import random
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tests.harness import run

GRAVITY = 9.80665
DEGREE = math.pi / 180.0
RESULTS = ("One start speed v₀", "One impact speed v", "Two impact speed v")
# Largest angle condition that is answered at the nominal values.
CONDITION = 12.0


def speeds(x: dict[str, Any]) -> "tuple[Any, Any, Any]":
    """Speeds of the first at its first mark and of both into the impact: momentum across each other's path."""
    exits = [
        np.sqrt(2.0 * GRAVITY * (x["road"] * x["one road"] + x["grass"] * x["one grass"])),
        np.sqrt(2.0 * GRAVITY * x["road"] * x["braking"] * x["two road"]),
    ]
    alphas, betas = (x["one way"], x["two way"]), (x["one exit"], x["two exit"])
    masses = x["one mass"], x["two mass"]
    sine = np.sin((alphas[1] - alphas[0]) * DEGREE)
    ways = []
    for this, other in ((0, 1), (1, 0)):
        total = sum(masses[k] * exits[k] * np.sin((alphas[other] - betas[k]) * DEGREE) for k in (0, 1))
        ways.append(total / (masses[this] * sine) * (1.0 if this == 0 else -1.0))
    start = np.sqrt(ways[0] ** 2 + 2.0 * GRAVITY * x["road"] * x["one marks"])
    return start, ways[0], ways[1]


def possible(x: dict[str, Any], values: "Any") -> "Any":
    """Which samples no physics excludes: forward speeds, an impulse that pushes, energy that is lost."""
    exits = [
        np.sqrt(2.0 * GRAVITY * (x["road"] * x["one road"] + x["grass"] * x["one grass"])),
        np.sqrt(2.0 * GRAVITY * x["road"] * x["braking"] * x["two road"]),
    ]
    before = [values[1 + k] * np.exp(1j * DEGREE * x[name]) for k, name in enumerate(("one way", "two way"))]
    after = [exits[k] * np.exp(1j * DEGREE * x[name]) for k, name in enumerate(("one exit", "two exit"))]
    push = x["one mass"] * (after[0] - before[0])
    closing = -((before[0] - before[1]) * push.conjugate()).real
    lost = sum(x[f"{name} mass"] * (abs(before[k]) ** 2 - abs(after[k]) ** 2) for k, name in enumerate(("one", "two")))
    return (values[1] > 0.0) & (values[2] > 0.0) & (closing >= 0.0) & (lost >= 0.0)


class Scene:
    """True values and the measurements of them."""

    def __init__(self, dice: random.Random, *, ill: bool) -> None:
        crossing = dice.uniform(12.0, 25.0) if ill else dice.uniform(35.0, 145.0)
        way = dice.uniform(0.0, 360.0)
        bend = dice.uniform(0.35, 0.65)
        sigmas: dict[str, tuple[float, float]] = {
            "road": (dice.uniform(0.5, 0.8), 0.04), "grass": (dice.uniform(0.35, 0.5), 0.05),
            "one mass": (dice.uniform(900, 2200), 30.0), "two mass": (dice.uniform(900, 2200), 30.0),
            "one way": (way, dice.choice([0.5, 2.0])), "two way": (way + crossing, dice.choice([0.5, 2.0])),
            "one exit": (way + bend * crossing - dice.uniform(2, 6), dice.uniform(1, 3)),
            "two exit": (way + bend * crossing + dice.uniform(2, 6), dice.uniform(1, 3)),
            "one road": (dice.uniform(3, 12), 0.3), "one grass": (dice.uniform(2, 8), 0.2),
            "two road": (dice.uniform(6, 20), 0.4), "one marks": (dice.uniform(4, 20), 0.3),
        }  # fmt: skip
        self.sigmas = {name: sigma for name, (_, sigma) in sigmas.items()}
        self.true = {name: value for name, (value, _) in sigmas.items()} | {"braking": dice.uniform(0.6, 0.9)}
        self.measured = {name: dice.gauss(value, sigma) for name, (value, sigma) in sigmas.items()}
        self.truth = speeds(self.true)
        half = math.tan(0.5 * (self.measured["two way"] - self.measured["one way"]) * DEGREE)
        self.decided = max(abs(half), abs(1.0 / half)) < CONDITION

    def toml(self) -> str:
        """The scene as a user states it."""

        def said(name: str, unit: str) -> str:
            return f'"{self.measured[name]!r} ± {self.sigmas[name]!r}{unit}"'

        return f"""
[surfaces.road]
friction = {said("road", "")}
[surfaces.grass]
friction = {said("grass", "")}
[first]
name = "One"
mass = {said("one mass", " kg")}
approach_heading = {said("one way", " deg")}
exit_heading = {said("one exit", " deg")}
before = [{{ distance = {said("one marks", " m")}, surface = "road" }}]
after = [
    {{ distance = {said("one road", " m")}, surface = "road" }},
    {{ distance = {said("one grass", " m")}, surface = "grass" }},
]
[second]
name = "Two"
mass = {said("two mass", " kg")}
approach_heading = {said("two way", " deg")}
exit_heading = {said("two exit", " deg")}
after = [{{ distance = {said("two road", " m")}, surface = "road", braking = "60..90 %" }}]
"""

    def intervals(self, *more: str) -> "list[tuple[float, float]] | None":
        """What the program states, in m/s; None where it refuses the nominal answer."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "scene.toml"
            path.write_text(self.toml(), encoding="utf-8")
            said = run("impact", "crash", str(path), "-q", "--digits", "6", *more)
        if said.status != 0:
            return None
        found = {}
        for line in said.out.splitlines():
            label, _, ends = line.partition("95 %:")
            if ends:
                low, _, high = ends.partition(" to ")
                found[" ".join(label.split()[:-2])] = (float(low) / 3.6, float(high.split()[0]) / 3.6)
        return [found[name] for name in RESULTS]

    def sampled(self, count: int, seed: int) -> "list[tuple[float, float]]":
        """The same by plain samples, those left out that cannot be."""
        drawn = np.random.default_rng(seed)
        x: dict[str, Any] = {
            name: value + self.sigmas[name] * drawn.standard_normal(count) for name, value in self.measured.items()
        }
        x["braking"] = drawn.uniform(0.6, 0.9, count)
        with np.errstate(all="ignore"):
            values = np.array(speeds(x))
        kept = values[:, possible(x, values)]
        return [(float(low), float(high)) for low, high in np.quantile(kept, [0.025, 0.975], axis=1).T]


def scenes(count: int, seed: int, *, ill: bool = False) -> "list[Scene]":
    """So many random scenes in which both vehicles drive forward and the paths cross enough."""
    dice = random.Random(seed)
    listed: list[Scene] = []
    while len(listed) < count:
        scene = Scene(dice, ill=ill)
        # neither the truth nor the nominal answer reverses
        if min(scene.truth) > 3.0 and min(speeds({**scene.measured, "braking": 0.75})) > 1.0 and scene.decided:
            listed.append(scene)
    return listed


def coverage(count: int, seed: int) -> "tuple[list[int], int]":
    """How many intervals of each result contain the truth, and of how many scenes."""
    inside, answered = [0] * len(RESULTS), 0
    for scene in scenes(count, seed):
        # of five hundred scenes an end that is off by a hundredth of the width does not matter
        stated = scene.intervals("--samples", "5000")
        if stated is None:
            continue
        answered += 1
        for index, ((low, high), truth) in enumerate(zip(stated, scene.truth, strict=True)):
            inside[index] += low <= truth <= high
    return inside, answered


def narrowest(count: int, seed: int, samples: int = 2_000_000) -> "tuple[float, int]":
    """The least width stated for an ill-conditioned scene, beside that of samples, and of how many scenes.

    Two million samples know a width to 0.1 %; the program's own stated error is up to 1.6 % of it. Over 87 widths of 29
    scenes (seed 1) the ratio is 1.0000 on average with a deviation of 0.0016, from 0.9924 to 1.0039: errors of
    integration to both sides within those stated, no bias. Five more seeds of the samples leave the extremes in place.
    """
    least, answered = math.inf, 0
    for index, scene in enumerate(scenes(count, seed, ill=True)):
        stated = scene.intervals()
        if stated is None:
            continue
        answered += 1
        for (low, high), (a, b) in zip(stated, scene.sampled(samples, index), strict=True):
            least = min(least, (high - low) / (b - a))
    return least, answered


def main(words: "list[str]") -> None:
    """As the head of this file says."""
    numbers = [int(word) for word in words if not word.startswith("-")] + [0, 0]
    if "--ill" in words:
        least, answered = narrowest(numbers[0] or 30, numbers[1] or 1)
        print(f"{answered} scenes answered; narrowest interval {least:.4f} of that of samples")
        return
    inside, answered = coverage(numbers[0] or 500, numbers[1] or 1)
    for name, number in zip(RESULTS, inside, strict=True):
        print(f"{name}: {number} of {answered} intervals contain the truth, {100.0 * number / answered:.1f} %")


if __name__ == "__main__":
    main(sys.argv[1:])
