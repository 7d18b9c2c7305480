"""Crashes of which momentum gives both speeds before, for impact_particles.json: small angles and crawling vehicles."""

import random
from collections.abc import Iterator
from typing import Any

from mpmath import atan2, cos, hypot, lu_solve, matrix, mpf, sin

Case = tuple[str, str, dict[str, Any]]


def crash(m1: float, m2: float, v1: float, v2: float, heading: float, apart: float, bend: float) -> dict[str, Any]:
    """A crash with such speeds before, but for the rounding of what is measured after it."""
    before = [m1 * v1 * f(heading) + m2 * v2 * f(heading + apart) for f in (cos, sin)]
    size, way = hypot(*before) / (m1 + m2), atan2(before[1], before[0])
    # the vehicles leave a little apart, the second faster so that momentum across is kept
    swing = -bend * m1 / m2
    return {
        "first": vehicle(m1, heading, float(size * cos(mpf(swing)) / cos(mpf(bend))), float(way + bend)),
        "second": vehicle(m2, heading + apart, float(size), float(way + swing)),
        "gravity": 9.80665,
    }


def vehicle(mass: float, before: float, speed: float, after: float) -> dict[str, Any]:
    return {
        "bulk": {"record": "ByMass", "mass": mass}, "approach_heading": before, "exit_speed": speed,
        "exit_heading": after,
    }  # fmt: skip


def approach(x: dict[str, Any]) -> dict[str, Any]:
    """The 2×2 system in many digits."""
    both = x["first"], x["second"]
    masses = [one["bulk"]["mass"] for one in both]
    rows = [[m * f(one["approach_heading"]) for m, one in zip(masses, both, strict=True)] for f in (cos, sin)]
    held = [
        sum(m * one["exit_speed"] * f(one["exit_heading"]) for m, one in zip(masses, both, strict=True))
        for f in (cos, sin)
    ]
    one, two = lu_solve(matrix(rows), matrix(held))
    return {"first.approach_speed": one, "second.approach_speed": two}


def approaches(generator: random.Random) -> Iterator[Case]:
    r = generator
    for _ in range(12):
        masses = r.uniform(800.0, 2500.0), r.uniform(800.0, 2500.0)
        speeds = r.uniform(5.0, 25.0), r.uniform(5.0, 25.0)
        yield "ordinary", "", crash(*masses, *speeds, r.uniform(-3.0, 3.0), r.uniform(0.5, 2.5), r.uniform(0.01, 0.1))
    for degrees in (10.0, -12.0, 169.0):
        why = f"approach paths {abs(degrees):.0f} degrees apart: the system is nearly singular"
        yield "hard", why, crash(1500.0, 1200.0, 14.0, 11.0, r.uniform(0.2, 1.4), degrees / 57.3, 0.03)
    for crawl in (0.1, 1e-3, 1e-6, 1e-9):
        why = f"the second crawls at {crawl:g} m/s: its momentum is what is left of two far larger ones"
        own = crash(1500.0, 1200.0, 14.0, crawl, r.uniform(0.2, 1.4), 1.2, 0.0)
        yield "hard", why, own
        why = f"the first crawls at {crawl:g} m/s, on a path nearly along the other's"
        yield "hard", why, crash(1500.0, 1200.0, crawl, 11.0, r.uniform(0.2, 1.4), 0.25, 0.0)
    for ratio in (1e4, 1e8):
        why = f"a mass {ratio:g} times the other: the light one's speed is in the last digits of all momentum"
        yield "hard", why, crash(1500.0 * ratio, 1500.0, 14.0, 11.0, 0.8, 1.1, 0.0)
    square = crash(1500.0, 1200.0, 14.0, 11.0, 0.8, 1.5707963267948966, 0.03)
    yield "hard", "paths square to double precision but turned: no sine or cosine is zero", square
