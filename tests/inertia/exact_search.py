"""A search for bounds of sections below the true error, against exact rationals.

    python tests/inertia/exact_search.py [SECONDS [SEED]]

Sections are thin, turned and far off. The worst that were found are among the shipped cases.
"""

import math
import random
import sys
import time
from collections.abc import Callable, Iterator
from decimal import Decimal
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "references"))

import generate_inertia_sections_references as sections
import inertia_answers
from mpmath import mp, mpf, nstr

from dynamics_cli.accuracy.cases import Case
from dynamics_cli.errors import InadmissibleError

# A result's address, its true value to 40 digits, and the program's with its bound.
Result = tuple[str, str, Any]


def between(rng: random.Random, low: float, high: float) -> float:
    """A number of any order of magnitude."""
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def section(rng: random.Random) -> Iterator[Result]:
    """A polygon, a thin turned strip, a thin tube, or two pieces, near or far off."""
    kind = rng.randrange(4)
    x, y = (rng.choice((0.0, 1.0)) * sign * 10.0 ** rng.uniform(0.0, 12.0) for sign in (1.0, -1.0))
    if kind == 0:
        inputs: dict[str, Any] = {
            "polygon": sections.star(rng, 10.0 ** rng.uniform(0.0, 8.0), (x, y), rng.randrange(3))
        }
    elif kind == 1:
        inputs = {"polygon": sections.strip(1.0, 10.0 ** -rng.uniform(0.0, 10.0), rng.randrange(3), (x, y))}
    elif kind == 2:
        outer = between(rng, 1e-3, 1e3)
        inner = min(outer * (1.0 - 2.0 * between(rng, 1e-14, 0.4)), math.nextafter(outer, 0.0))
        inputs = {"pieces": [{"diameter": outer, "x": x, "y": y}], "holes": [{"diameter": inner, "x": x, "y": y}]}
    else:
        plate = {"width": between(rng, 1e-6, 1.0), "height": between(rng, 1e-6, 1.0), "x": x}
        inputs = {"pieces": [plate, {"diameter": between(rng, 1e-6, 0.1), "x": x + 3.0, "y": rng.uniform(-2.0, 2.0)}]}
    # coordinates made in multiple precision are rounded before they are exact
    inputs = {key: [_plain(item) for item in items] for key, items in inputs.items()}
    case = Case({"task": "section", "kind": "hard", "name": "", "inputs": sections.written(inputs), "results": {}})
    made = inertia_answers.section(case)
    mp.dps = 90
    for name, value in sections.results(inputs).items():
        yield name, nstr(value, 40) if abs(value) > mpf(10) ** -60 else "0.0", made[name]


def _plain(item: Any) -> Any:
    return {name: float(value) for name, value in item.items()} if isinstance(item, dict) else float(item)


def short(make: Callable[[random.Random], Iterator[Result]], rng: random.Random) -> tuple[int, list[str]]:
    """How many results one body gave, and which of them lie beyond their bound; none where it is refused."""
    try:
        results = list(make(rng))
    except (InadmissibleError, ZeroDivisionError):
        # a body that rounding has turned inside out, or left nothing of
        return 0, []
    found = []
    for name, text, own in results:
        true = Decimal(text)
        error = abs(Decimal(own.value) - true) - abs(true) * Decimal("1e-38")
        if error > Decimal(own.error):
            found.append(f"{make.__name__} {name}: off by {error:.3g}, bound {own.error:.3g}")
    return len(results), found


def main() -> None:
    """Search as long as asked."""
    seconds, seed = (float(sys.argv[1]) if len(sys.argv) > 1 else 60.0), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    rng, until, bodies, results = random.Random(seed), time.monotonic() + seconds, 0, 0
    while time.monotonic() < until:
        count, found = short(section, rng)
        bodies, results = bodies + (count > 0), results + count
        for line in found:
            print(line, flush=True)
    print(f"{bodies} sections, {results} results")


if __name__ == "__main__":
    main()
