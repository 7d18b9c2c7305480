"""Writes uncertainty.json: distributions of results that can be had by one-dimensional integrals, to 20 digits.

The speed from a skid, v = √(2·g·μ·d) with normal friction μ and length d: P(v ≤ w) = ∫ φ(t)·Φ((w²/(2g·d(t)) − m)/s) dt,
by the trapezoidal rule in multiple precision and root finding; the program integrates along the gradient in scores and
never by this formula. With lognormal inputs the result is lognormal, in closed form.
Run: python tests/references/generate_uncertainty_references.py [FILE]. The same bytes every time.
"""

import json
import sys
from pathlib import Path

from mpmath import mp, mpf

DATA = Path(__file__).resolve().parents[2] / "dynamics_cli" / "accuracy" / "data"
G = mpf("9.80665")
PROBABILITIES = ("0.025", "0.5", "0.975")
NORMAL = (
    ("an ordinary skid", "ordinary", "", ("0.7", "0.05", "18", "0.5")),
    ("friction known badly", "hard", "nine deviations from no friction, the root bends", ("0.45", "0.05", "30", "1")),
    ("one input decides", "hard", "the length hardly matters", ("0.6", "0.05", "25", "0.001")),
    ("both matter alike", "hard", "no axis is the right one to integrate along", ("0.5", "0.05", "10", "1")),
)  # fmt: skip
LOGNORMAL = (
    ("lognormal inputs", "ordinary", "", ("0.7", "0.05", "18", "0.5")),
    ("wide lognormal inputs", "hard", "half the mean for a deviation", ("0.5", "0.25", "20", "10")),
)


# The trapezoidal rule over scores: its error falls faster than any power of the step; beyond the reach lies 2e-21.
STEP, REACH = mpf(1) / 16, mpf("9.5")


def expected(function):
    """The expectation of a function of a standard normal score."""
    terms = []
    for k in range(-int(REACH * 16), int(REACH * 16) + 1):
        t = k * STEP
        terms.append(mp.exp(-t * t / 2) * function(t))
    return mp.fsum(terms) * STEP / mp.sqrt(2 * mp.pi)


def below(w, mean, std, length, width):
    """P(v ≤ w)."""
    return expected(lambda t: mp.ncdf((w * w / (2 * G * (length + width * t)) - mean) / std))


def moments(mean, std, length, width):
    """Mean and deviation of √(2·g·μ·d): expectations multiply; below zero lies next to nothing."""

    def root(centre, spread):
        return expected(lambda t: mp.sqrt(max(centre + spread * t, mpf(0))))

    first = mp.sqrt(2 * G) * root(mean, std) * root(length, width)
    return first, mp.sqrt(2 * G * mean * length - first * first)


def normal_case(values):
    mean, std, length, width = (mpf(value) for value in values)
    guess, scale = moments(mean, std, length, width)
    out = {}
    for p, name in zip(PROBABILITIES, ("low", "median", "high"), strict=True):
        centre = guess + scale * mp.sqrt(2) * mp.erfinv(2 * mpf(p) - 1)
        ends = (centre - scale / 2, centre + scale / 2)
        out[name] = mp.findroot(lambda w, p=p: below(w, mean, std, length, width) - mpf(p), ends, solver="ridder")
    return {**out, "mean": guess, "std": scale}


def lognormal_case(values):
    mean, std, length, width = (mpf(value) for value in values)
    a, b = mp.log(1 + (std / mean) ** 2), mp.log(1 + (width / length) ** 2)
    centre = (mp.log(mean) - a / 2 + mp.log(length) - b / 2 + mp.log(2 * G)) / 2
    spread = mp.sqrt(a + b) / 2
    scores = (-mp.sqrt(2) * mp.erfinv(mpf("0.95")), mpf(0), mp.sqrt(2) * mp.erfinv(mpf("0.95")))
    out = {name: mp.exp(centre + spread * z) for name, z in zip(("low", "median", "high"), scores, strict=True)}
    first = mp.exp(centre + spread**2 / 2)
    return {**out, "mean": first, "std": first * mp.sqrt(mp.expm1(spread**2))}


def main() -> None:
    mp.dps = 30
    lines = []
    for shape, cases, solve in (("normal", NORMAL, normal_case), ("lognormal", LOGNORMAL, lognormal_case)):
        for name, kind, why, values in cases:
            case = {"task": "skid", "kind": kind, "name": name, **({"why": why} if why else {})}
            inputs = {"shape": shape, **dict(zip(("mean", "std", "length", "width"), values, strict=True))}
            results = {key: mp.nstr(value, 20) for key, value in solve(values).items()}
            lines.append(json.dumps({**case, "inputs": inputs, "results": results}))
    about = "Written by generate_uncertainty_references.py: quantiles, mean and deviation of v = √(2·g·μ·d)."
    text = f'{{"about": {json.dumps(about, ensure_ascii=False)},\n"cases": [\n' + ",\n".join(lines) + "\n]}\n"
    (Path(sys.argv[1]) if len(sys.argv) > 1 else DATA / "uncertainty.json").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
