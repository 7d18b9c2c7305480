"""Writes uncertainty.json: distributions of results that are known in closed form or by one-dimensional integrals.

What is known of each (its distribution function, its mean and mean square) stands in uncertainty_laws.py; quantiles are
roots of that function, and the program, which integrates along the gradient in scores, never uses any of it.
Everything is calculated twice, with other steps and more digits: the digits written, 40 at most, are those that agree.
Run: python tests/references/generate_uncertainty_references.py [FILE]. The same bytes every time.
"""

import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

from case_files import put
from mpmath import mp, mpf
from uncertainty_cases import CASES, Wanted
from uncertainty_numbers import number, precision, real

PROBABILITIES = {"low": "0.025", "median": "0.5", "high": "0.975"}
MOST_DIGITS = 40


def numbers(wanted: Wanted, near: dict[str, Any] | None = None) -> dict[str, Any]:
    """Quantiles, mean and deviation; roots are looked for near those that are known."""
    law = wanted.law()
    found = {name: law.quantile(number(p), (near or {}).get(name)) for name, p in PROBABILITIES.items()}
    first, second = law.moments()
    return {**found, "mean": first, "std": real.sqrt(second - first * first)}


def agreed(one: Any, other: Any) -> str:
    """The digits that two calculations share."""
    if one == other == 0:
        return "0"
    one, other = mpf(str(one)), mpf(str(other))
    apart = abs(one - other)
    digits = MOST_DIGITS if not apart else min(MOST_DIGITS, int(-mp.log10(apart / abs(other))) - 1)
    if abs(other) < mpf(10) ** -45:
        return "0"
    if digits < 16:
        raise ArithmeticError(f"{mp.nstr(one, 30)} is not {mp.nstr(other, 30)}")
    return str(mp.nstr(other, digits))


def line(wanted: Wanted) -> str:
    """One case."""
    with precision(48, 1):
        once = numbers(wanted)
    with precision(60, 2):
        twice = numbers(wanted, once)
        results = {name: agreed(once[name], twice[name]) for name in once}
    case = {"task": wanted.model, "kind": "hard" if wanted.why else "ordinary", "name": wanted.name}
    more = {"why": wanted.why} if wanted.why else {}
    inputs: dict[str, Any] = {"inputs": wanted.inputs}
    if wanted.correlation:
        inputs["correlation"] = wanted.correlation
    return {**case, **more, "inputs": inputs, "results": results}


def main() -> None:
    """Write the file."""
    about = "Written by generate_uncertainty_references.py: quantiles, mean and deviation; the digits that are sure."
    put("uncertainty", about, map(line, CASES))


if __name__ == "__main__":
    main()
