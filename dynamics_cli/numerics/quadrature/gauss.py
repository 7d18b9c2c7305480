"""Gauss–Legendre nodes and weights without numpy."""

import math

_found: "dict[int, tuple[tuple[float, float], ...]]" = {}


def legendre(count: int) -> tuple[tuple[float, float], ...]:
    """Nodes and weights on (0, 1), by Newton's method from Tricomi's estimate; exact to a few roundings.

    References
    ----------
    W. H. Press et al., Numerical Recipes, 3rd ed., Cambridge 2007, section 4.6.
    """
    if count in _found:
        return _found[count]
    pairs = []
    for index in range(count):
        x = math.cos(math.pi * (index + 0.75) / (count + 0.5))
        for _ in range(100):
            below, value = 1.0, x
            for degree in range(2, count + 1):
                below, value = value, ((2 * degree - 1) * x * value - (degree - 1) * below) / degree
            slope = count * (below - x * value) / ((1.0 - x) * (1.0 + x))
            step = value / slope
            x -= step
            if abs(step) < 1e-16:
                break
        pairs.append((0.5 * (1.0 - x), 1.0 / ((1.0 - x) * (1.0 + x) * slope * slope)))
    _found[count] = tuple(pairs)
    return _found[count]
