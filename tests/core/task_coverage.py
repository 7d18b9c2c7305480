"""Do intervals of whole tasks contain what they claim, and do their stated errors hold? Fresh random problems.

    python tests/core/task_coverage.py [PROBLEMS [SEED]]

Every problem is typed as a user would, and the probability of what its interval takes in is integrated by formulas
that share nothing with the program's: momentum from its two equations along headings, one exit speed integrated in
closed form and the rest by scrambled Sobol points (their scatter is the noise), skids by quadrature
(`skid_reference.py`). A stated error below the reference's noise is not judged, unless the reference contradicts it:
those of momentum at wide angles are judged by `coverage_experiment.py`.
"""

import json
import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import skid_reference as skid
from harness import run
from scipy.special import ndtr, ndtri
from scipy.stats import qmc

from dynamics_cli.core.inputs.uncertain.distributions import Normal

DEG = np.pi / 180.0
SCRAMBLES, POINTS = 12, 2**13
# Scores beyond which there is nothing.
FAR = 12.0
# Probabilities below the interval's ends and the median.
LEVELS = (0.025, 0.5, 0.975)
# What quadrature may err in a probability, and the share of a deviation that a density is taken over.
QUADRATURE, STEP = 2e-7, 2e-3
Below = Callable[[float], tuple[float, float]]


class Verdict(NamedTuple):
    """One result: the probability in its interval, the worst error in deviations, what it may err, what was stated."""

    where: str
    inside: float
    error: float
    noise: float
    stated: float

    @property
    def told(self) -> bool:
        """Whether the reference is fine enough to judge the stated error."""
        return self.stated >= 2.0 * self.noise or not self.held

    @property
    def held(self) -> bool:
        return self.error <= self.stated + 4.0 * self.noise


def judged(where: str, document: dict[str, Any], name: str, below: Below) -> Verdict:
    """A result's verdict by the reference's probabilities, each with its noise."""
    result: Any = document["results"]
    for part in name.split("."):
        result = result[part]
    low, high = result["interval"]
    # of a pole there is no deviation
    std = result["std"] if result["std"] is not None else (high - low) / 4.0
    chances, error, noise = [], 0.0, 0.0
    for p, level in zip(LEVELS, (low, result["median"], high), strict=True):
        chance, doubt = below(level)
        density = (below(level + STEP * std)[0] - below(level - STEP * std)[0]) / (2.0 * STEP)
        chances.append(chance)
        error, noise = max(error, abs(chance - p) / density), max(noise, doubt / density)
    stated = document["numerics"]["uncertainty"]["results"][name]["estimate"]
    return Verdict(where, chances[2] - chances[0], error, noise, stated)


def written(inputs: dict[str, Normal], units: dict[str, str]) -> list[str]:
    typed = []
    for name, unit in units.items():
        typed += [f"--{name}", f"{inputs[name].mean!r} ± {inputs[name].std!r} {unit}".strip()]
    return typed


MOMENTUM_UNITS = {
    "first-mass": "kg", "second-mass": "kg", "second-exit-speed": "m/s", "first-approach-heading": "deg",
    "second-approach-heading": "deg", "first-exit-heading": "deg", "second-exit-heading": "deg",
    "first-exit-speed": "m/s",
}  # fmt: skip


def crash(rng: np.random.Generator, angle: float) -> dict[str, Normal]:
    """A crash at an angle between the approaches, in degrees: what leaves balances what came, before measuring."""
    m, v = rng.uniform(900, 2500, 2), rng.uniform(5, 20, 2)
    heading = np.array([0.0, angle * DEG])
    before = v * np.exp(1j * heading)
    common = (m @ before) / m.sum()
    parting = rng.uniform(0.3, 2.0) * np.exp(2j * np.pi * rng.uniform())
    after = common + parting * np.array([m[1], -m[0]]) / m.sum()
    means = [*m, abs(after[1]), 0.0, angle, *(np.angle(after) / DEG), abs(after[0])]
    stds = [*rng.uniform(10, 60, 2), rng.uniform(0.2, 0.8), *rng.uniform(0.3, 3.0, 4), rng.uniform(0.2, 0.8)]
    return {name: Normal(float(a), float(b)) for name, a, b in zip(MOMENTUM_UNITS, means, stds, strict=True)}


class Line(NamedTuple):
    """Start and slope of what goes with the score of the first's exit speed: a number, or a vector as a complex one."""

    start: Any
    slope: Any

    def times(self, other: "Line") -> tuple[Any, Any, Any]:
        """Coefficients of the scalar product, the constant first."""
        pairs = ((self.start, other.start), (self.slope, other.slope))
        mixed = (np.conj(self.start) * other.slope + np.conj(self.slope) * other.start).real
        return (np.conj(pairs[0][0]) * pairs[0][1]).real, mixed, (np.conj(pairs[1][0]) * pairs[1][1]).real


def motions(values: Any, spread: float) -> tuple[dict[str, Line], list[tuple[Any, Any, Any]]]:
    """Approach speeds of both vehicles, and what must not be negative: speeds, closing, energy lost."""
    m1, m2, u2, a1, a2, b1, b2, u1 = values
    way = {key: np.exp(1j * DEG * x) for key, x in (("a1", a1), ("a2", a2), ("b1", b1), ("b2", b2))}

    def cross(one: str, other: str) -> Any:
        return (np.conj(way[one]) * way[other]).imag

    first_of, second_of = cross("b1", "a2") / cross("a1", "a2"), cross("b2", "a2") / cross("a1", "a2")
    one = Line(first_of * u1 + m2 / m1 * second_of * u2, first_of * spread)
    first_of, second_of = cross("a1", "b1") / cross("a1", "a2"), cross("a1", "b2") / cross("a1", "a2")
    two = Line(m1 / m2 * first_of * u1 + second_of * u2, m1 / m2 * first_of * spread)
    before = Line(*(x * way["a1"] - y * way["a2"] for x, y in zip(one, two, strict=True)))
    after = Line(u1 * way["b1"] - u2 * way["b2"], spread * way["b1"])
    # the push on the first goes with the change of what moves it past the second, against the closing
    change = Line(*(y - x for x, y in zip(before, after, strict=True)))
    closing = tuple(-x for x in before.times(change))
    lost = tuple(x - y for x, y in zip(before.times(before), after.times(after), strict=True))
    none = np.zeros_like(one.start)
    speeds = [(*one, none), (*two, none), (u1 + none, spread + none, none), (u2 + none, none, none)]
    return {"first.approach_speed": one, "second.approach_speed": two}, [*speeds, closing, lost]


class Momentum:
    """Probabilities of an approach speed, given that the crash is one that can happen."""

    def __init__(self, inputs: dict[str, Normal], name: str, seed: int) -> None:
        means, stds = (np.array([getattr(inputs[key], part) for key in MOMENTUM_UNITS]) for part in ("mean", "std"))
        # Sobol points are most even in their first coordinate, so that is laid along the gradient
        steps = 1e-4 * np.diag(stds)[:-1]
        ends = [motions((means[:, None] + np.outer(s, [-1.0, 1.0])), 1.0)[0][name].start for s in steps]
        turn = np.linalg.qr(np.column_stack([[high - low for low, high in ends], np.eye(len(ends))]))[0]
        points = [qmc.Sobol(len(ends), seed=np.random.default_rng([seed, i])).random(POINTS) for i in range(SCRAMBLES)]
        z = turn @ ndtri(np.concatenate(points)).T
        speeds, limits = motions([*(means[:-1, None] + stds[:-1, None] * z), means[-1]], stds[-1])
        self._line = speeds[name]
        # between one change of sign and the next the crash can happen or cannot
        with np.errstate(all="ignore"):
            ends = [np.nan_to_num(root, nan=FAR) for limit in limits for root in roots(limit)]
        bends = np.sort(np.clip(ends, -FAR, FAR), axis=0)
        edges = np.concatenate([np.full_like(bends[:1], -FAR), bends, np.full_like(bends[:1], FAR)])
        middle = 0.5 * (edges[1:] + edges[:-1])
        can = np.all([a + middle * (b + middle * c) >= 0.0 for a, b, c in limits], axis=0)
        self._low, self._high = edges[:-1], np.where(can, edges[1:], edges[:-1])
        self.admissible = self._means(self._low, self._high)

    @staticmethod
    def _means(low: Any, high: Any) -> Any:
        return (ndtr(high) - ndtr(np.minimum(low, high))).sum(axis=0).reshape(SCRAMBLES, POINTS).mean(axis=1)

    def below(self, level: float) -> tuple[float, float]:
        """The probability below a level, and its noise."""
        start, slope = self._line
        at, rises = (level - start) / slope, slope > 0.0
        low = np.maximum(self._low, np.where(rises, -FAR, at))
        high = np.minimum(self._high, np.where(rises, at, FAR))
        shares = self._means(low, high) / self.admissible.mean()
        # the scatter of a ratio: what both parts share falls out
        scatter = shares - shares.mean() * self.admissible / self.admissible.mean()
        return float(shares.mean()), float(np.std(scatter, ddof=1) / SCRAMBLES**0.5)


def roots(coefficients: tuple[Any, Any, Any]) -> list[Any]:
    """Real roots of a + b z + c z², NaN where there are none."""
    a, b, c = coefficients
    half = -0.5 * (b + np.copysign(np.sqrt(b * b - 4.0 * a * c), b))
    return [half / c, a / half]


def momentum(rng: np.random.Generator, near: bool) -> tuple[str, list[Verdict]]:
    """Approaches at 25° to 155°, or `near` one line: 4° to 20° apart or from head on."""
    angle = float(rng.uniform(4, 20)) if near else float(rng.uniform(25, 155))
    if near and rng.uniform() < 0.5:
        angle = 180.0 - angle
    inputs = crash(rng, angle)
    argv = ["impact", "momentum", *written(inputs, MOMENTUM_UNITS)]
    outcome = run(*argv, "--units", "base", "--json")
    if not outcome.out:
        return outcome.err, []
    seed = int(rng.integers(2**31))
    names = ("first.approach_speed", "second.approach_speed")
    return "", [judged(f"{argv}", outcome.document, name, Momentum(inputs, name, seed).below) for name in names]


SKID_UNITS = {"distance": "m", "friction": "", "grade": "deg"}
SKID_NAMES = {"mu": "friction", "theta": "grade", "d": "distance"}


def slope(rng: np.random.Generator, correlated: bool) -> tuple[str, list[Verdict]]:
    """A skid on a slope uncertain in degrees; `correlated` ones may have inadmissible drag."""
    if correlated:
        inputs, correlation = skid.problem(rng)
    else:
        inputs, correlation = (
            {
                "mu": Normal(rng.uniform(0.35, 0.9), rng.uniform(0.01, 0.08)),
                "theta": Normal(rng.uniform(-0.4, 0.4), rng.uniform(0.01, 0.12)),
                "d": Normal(rng.uniform(8.0, 80.0), rng.uniform(0.1, 2.0)),
            },
            {},
        )
    theta = inputs["theta"]
    asked = {
        "distance": inputs["d"], "friction": inputs["mu"], "grade": Normal(theta.mean / DEG, theta.std / DEG),
    }  # fmt: skip
    argv = ["skid", "speed", *written(asked, SKID_UNITS)]
    for (one, other), rho in correlation.items():
        argv += ["--correlate", f"{SKID_NAMES[one]},{SKID_NAMES[other]}={rho!r}"]
    outcome = run(*argv, "--units", "base", "--json")
    if not outcome.out:
        return outcome.err, []
    reference = skid.Reference(inputs, correlation, slopes=14 if correlated else 84)
    return "", [
        judged(str(argv), outcome.document, name, lambda c, n=name: (reference.below(n, c), QUADRATURE))
        for name in ("speed", "time")
    ]


KINDS: dict[str, Callable[[np.random.Generator], tuple[str, list[Verdict]]]] = {
    "momentum": lambda rng: momentum(rng, near=False),
    "momentum near one line": lambda rng: momentum(rng, near=True),
    "skid on an uncertain slope": lambda rng: slope(rng, correlated=False),
    "correlated skid": lambda rng: slope(rng, correlated=True),
}


class Coverage(NamedTuple):
    """What many problems of a kind gave."""

    verdicts: list[Verdict]
    refusals: list[str]

    @property
    def contain(self) -> float:
        """The share of intervals with 93 % to 97 % of the truth in them."""
        return float(np.mean([0.93 <= verdict.inside <= 0.97 for verdict in self.verdicts]))

    @property
    def told(self) -> list[Verdict]:
        return [verdict for verdict in self.verdicts if verdict.told]

    @property
    def held(self) -> int:
        """How many stated errors hold, of those that the reference can judge."""
        return sum(verdict.held for verdict in self.told)


def coverage(kind: str, problems: int, seed: int) -> Coverage:
    rng = np.random.default_rng([seed, list(KINDS).index(kind)])
    verdicts, refusals = [], []
    for _ in range(problems):
        refusal, made = KINDS[kind](rng)
        verdicts += made
        refusals += [refusal] * bool(refusal)
    return Coverage(verdicts, refusals)


def main(problems: int = 20, seed: int = 15) -> None:
    """Print what many problems of every kind give."""
    print(
        f"{'problems':28} {'intervals':>9} {'least':>7} {'mean':>7} {'most':>7} "
        f"{'93-97 %':>8} {'judged':>7} {'held':>7}"
    )
    for kind in KINDS:
        # quadrature of skids is quick
        made = coverage(kind, problems if "momentum" in kind else 4 * problems, seed)
        inside = np.array([verdict.inside for verdict in made.verdicts])
        print(
            f"{kind:28} {inside.size:9} {inside.min():7.2%} {inside.mean():7.2%} {inside.max():7.2%} "
            f"{made.contain:8.1%} {len(made.told):7} {made.held:7}",
            flush=True,
        )
        for verdict in made.verdicts:
            if not verdict.held or not 0.93 <= verdict.inside <= 0.97:
                print(f"    {verdict}")
        codes = Counter(json.loads(refusal)["error"]["code"] for refusal in made.refusals)
        for code, count in codes.items():
            print(f"    refused as {code}: {count}")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
