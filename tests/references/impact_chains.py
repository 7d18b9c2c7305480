"""Chains of bodies: pairs in turn, and every set of acting contacts tried; in numbers of any length."""

from itertools import combinations
from typing import Any

MOST_HITS = 3000


def line_hit(m: Any, other: Any, v: Any, w: Any, e: Any) -> tuple[Any, Any]:
    """Velocities after two bodies have met: by their common velocity, and what restitution gives back."""
    common = (m * v + other * w) / (m + other)
    return common + other * e * (w - v) / (m + other), common + m * e * (v - w) / (m + other)


def in_turn(masses: list[Any], v: list[Any], ratios: list[Any], least: Any) -> tuple[list[Any], int]:
    """Impulses of pairs one after another, the fastest first, and how many collided; changes the velocities."""
    pushes = [0 * masses[0]] * len(ratios)
    for hits in range(MOST_HITS):
        closing = [v[i] - v[i + 1] for i in range(len(ratios))]
        i = max(range(len(ratios)), key=closing.__getitem__)
        if closing[i] <= least:
            return pushes, hits
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
    found = [0 * right[0]] * size
    for k in reversed(range(size)):
        found[k] = (a[k][size] - sum(a[k][j] * found[j] for j in range(k + 1, size))) / a[k][k]
    return found


def coupling(masses: list[Any], i: int, j: int) -> Any:
    """How much faster contact i opens by a unit impulse in contact j."""
    if i == j:
        return 1 / masses[i] + 1 / masses[i + 1]
    return -1 / masses[max(i, j)] if abs(i - j) == 1 else 0 * masses[0]


def at_once(masses: list[Any], v: list[Any], ratios: list[Any], least: Any) -> tuple[list[Any], int]:
    """Impulses of all contacts at one moment, in rounds; of every set of acting contacts the one without tension."""
    count = len(ratios)
    k = [[coupling(masses, i, j) for j in range(count)] for i in range(count)]
    pushes = [0 * masses[0]] * count
    for hits in range(MOST_HITS):
        closing = [v[i] - v[i + 1] for i in range(count)]
        if max(closing) <= least:
            return pushes, hits
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
            made = [part[acting.index(i)] if i in acting else 0 * least for i in range(count)]
            opened = [sum(k[i][j] * p for j, p in enumerate(made)) for i in range(count)]
            if all(o >= u - least for o, u in zip(opened, closing, strict=True)):
                return made
    raise AssertionError("no set of contacts holds")


def chained(masses: list[Any], start: list[Any], ratios: list[Any], law: str, least: Any) -> dict[str, Any]:
    """Every result of one law; pairs that close no faster than `least` no longer collide."""
    v = list(start)
    pushes, hits = (in_turn if law == "sequential" else at_once)(masses, v, ratios, least)
    zero = 0 * masses[0]
    out = {
        "momentum": sum(m * x for m, x in zip(masses, start, strict=True)),
        "laws[0].energy_lost": sum(m * (a - b) * (a + b) for m, a, b in zip(masses, start, v, strict=True)) / 2,
        "laws[0].collisions": zero + hits,
    }
    for i, speed in enumerate(v):
        out |= {
            f"bodies[{i}].body": zero + i + 1,
            f"bodies[{i}].velocity": speed,
            f"bodies[{i}].delta_v": speed - start[i],
        }
        if i < len(pushes):
            out[f"bodies[{i}].impulse_to_next"] = pushes[i]
    return out
