"""Sparse grids for independent standard normals: Smolyak's combination of embedded Genz–Keister rules.

The one-dimensional rules grow only when the degree requires it (1, 3, 3, 9, 9, …, 19, …: Petras 2003), so a grid of
level L is exact for polynomials of total degree 2L + 1 with few points: 1 + 2d, then O(d²) and so on.
"""

from itertools import combinations
from math import comb, prod

import numpy as np

from dynamics_cli.numerics.quadrature.hermite import GENZ_KEISTER_WEIGHTS, genz_keister

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# Points of the one-dimensional rule of each level: degree 2·level + 1 with the fewest.
SIZES = (1, 3, 3, 9, 9, 9, 9, 9, 19, 19, 19, 19, 19, 19, 19, 35)
_made: "dict[tuple[int, int], tuple[Array, Array]]" = {}


def smolyak(dimensions: int, level: int) -> "tuple[Array, Array]":
    """Points (dimensions, n) and weights (n, some negative) of the sparse grid.

    References
    ----------
    T. Gerstner, M. Griebel, Numerical integration using sparse grids, Numer. Algorithms 18 (1998) 209; K. Petras,
    Smolyak cubature of given polynomial degree with few nodes for increasing dimension, Numer. Math. 93 (2003)
    729.
    """
    key = (dimensions, level)
    if key not in _made:
        _made[key] = _build(dimensions, level)
    return _made[key]


def size(dimensions: int, level: int) -> int:
    """Number of points of the grid, without building it."""
    new = [SIZES[0]] + [SIZES[k] - SIZES[k - 1] for k in range(1, level + 1)]
    # The coefficient of x^k in (Σ new x^i)^d, by repeated multiplication.
    counts = [1] + [0] * level
    for _ in range(dimensions):
        counts = [sum(new[i] * counts[k - i] for i in range(k + 1)) for k in range(level + 1)]
    return sum(counts)


def _patterns(total: int, parts: int) -> "Iterator[tuple[int, ...]]":
    """The ways to write at most `total` as `parts` levels, each at least one."""
    if parts == 0:
        yield ()
        return
    for first in range(1, total - parts + 2):
        for rest in _patterns(total - first, parts - 1):
            yield (first, *rest)


def _build(dimensions: int, level: int) -> "tuple[Array, Array]":
    """Points by their active axes: a point's weight depends on its non-zero coordinates only, so it is found once.

    The grid is the sum over multi-indices |i| ≤ level of products of differences Δ_i = Q_i − Q_{i−1}; an inactive axis
    (coordinate 0) takes the central weight of its difference.
    """
    differences = _differences(level)
    centres = np.array([row[0] for row in differences])
    points: list[Array] = []
    weights: list[Array] = []
    idle: dict[int, Array] = {}
    for active in range(min(level, dimensions) + 1):
        idle[active] = _powers(centres, dimensions - active, level)
        coordinates, point_weights = _active(differences, idle[active], active, level)
        for axes in combinations(range(dimensions), active):
            block = np.zeros((dimensions, point_weights.size))
            block[list(axes)] = coordinates
            points.append(block)
            weights.append(point_weights)
    grid, total = np.concatenate(points, axis=1), np.concatenate(weights)
    weighted = total != 0.0
    return grid[:, weighted], total[weighted]


def _differences(level: int) -> "list[Array]":
    """Weights of Q_k − Q_{k−1} on the nodes of the largest rule."""
    most = SIZES[level]
    rows = []
    before = np.zeros(most)
    for k in range(level + 1):
        now = np.zeros(most)
        now[: SIZES[k]] = genz_keister(SIZES[k])[1]
        rows.append(now - before)
        before = now
    return rows


def _powers(centres: "Array", axes: int, level: int) -> "Array":
    """Summed weight of `axes` idle axes by the level they use up, cumulated."""
    total = np.zeros(level + 1)
    total[0] = 1.0
    for _ in range(axes):
        total = np.convolve(total, centres)[: level + 1]
    return np.cumsum(total)


def _active(differences: "list[Array]", idle: "Array", active: int, level: int) -> "tuple[Array, Array]":
    """Coordinates (active, n) of the points with so many non-zero ones, and their weights."""
    nodes = genz_keister(SIZES[level])[0][1:]
    coordinates: dict[tuple[int, ...], float] = {}
    if active == 0:
        return np.empty((0, 1)), np.array([idle[level]])
    for pattern in _patterns(level, active):
        rest = float(idle[level - sum(pattern)])
        supports = [np.flatnonzero(differences[k][1:]) for k in pattern]
        for index in np.ndindex(*(len(s) for s in supports)):
            key = tuple(int(s[i]) for s, i in zip(supports, index, strict=True))
            weight = rest * prod(float(differences[k][1 + node]) for k, node in zip(pattern, key, strict=True))
            coordinates[key] = coordinates.get(key, 0.0) + weight
    keys = np.array(list(coordinates))
    return nodes[keys].T, np.array(list(coordinates.values()))


def chaos_terms(dimensions: int, degree: int) -> int:
    """Number of Hermite polynomials of total degree ≤ `degree`."""
    return comb(dimensions + degree, degree)


assert set(SIZES) <= set(GENZ_KEISTER_WEIGHTS)
