"""Shifted rank-1 lattices on the unit cube, folded by the baker transform; the same seed gives the same points.

The generating vector comes from tests/references/generate_lattice.py and serves every power of two up to 2^14 points a
shift; the baker transform makes the error of a smooth, non-periodic integrand fall nearly with the square of the count.
"""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

VECTOR = (
    1, 3535, 1647, 7335, 2821, 7695, 2785, 5051, 1243, 7491, 3125, 6169, 7151, 4137, 4023, 6525, 6571, 1935, 5879, 6297,
    5195, 1961, 5305, 3217, 5971, 5485, 2217, 3301, 5241, 1795, 2659, 8101, 5999, 1065, 2673, 4963, 1113, 5221, 6723,
    7191,
)  # fmt: skip
MOST_POINTS = 1 << 14
MOST_DIMENSIONS = len(VECTOR)
DEFAULT_SEED = 1
_GOLDEN = 0x9E3779B97F4A7C15
_MASK = (1 << 64) - 1
# No coordinate comes nearer to 0 or 1, where a quantile would be infinite.
_EDGE = 2.0**-54


def uniforms(seed: int, count: int) -> "list[float]":
    """Numbers in (0, 1) by SplitMix64 (Steele, Lea & Flood 2014): shifts do not need a generator that costs an import.

    References
    ----------
    G. L. Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number generators, OOPSLA 2014.
    """
    numbers = []
    state = (seed * 0xD1342543DE82EF95 + 0x2545F4914F6CDD1D) & _MASK
    for _ in range(count):
        state = (state + _GOLDEN) & _MASK
        mixed = ((state ^ (state >> 30)) * 0xBF58476D1CE4E5B9) & _MASK
        mixed = ((mixed ^ (mixed >> 27)) * 0x94D049BB133111EB) & _MASK
        numbers.append(((mixed ^ (mixed >> 31)) + 0.5) / 2.0**64)
    return numbers


def lattice(dimensions: int, count: int, shifts: int, seed: int = DEFAULT_SEED) -> "Array":
    """Points (dimensions, shifts · count) in the open unit cube, shift by shift.

    `count` is a power of two up to 2^14.

    References
    ----------
    I. H. Sloan, S. Joe, Lattice Methods for Multiple Integration, Oxford 1994; baker transform: F. J. Hickernell,
    Obtaining O(N^(−2+ε)) convergence for lattice quadrature rules, in Monte Carlo and Quasi-Monte Carlo Methods
    2000, Springer 2002.
    """
    if dimensions > MOST_DIMENSIONS or count > MOST_POINTS or count & (count - 1):
        raise ValueError(f"no lattice of {count} points in {dimensions} dimensions")
    index = np.arange(count)
    generator = np.array(VECTOR[:dimensions])
    offsets = np.array(uniforms(seed, MOST_DIMENSIONS * shifts)).reshape(shifts, MOST_DIMENSIONS)[:, :dimensions]
    base = ((generator[:, None] * index) & (count - 1)) / count
    points = (base[:, None, :] + offsets.T[:, :, None]) % 1.0
    folded = 1.0 - np.abs(2.0 * points - 1.0)
    return np.clip(folded.reshape(dimensions, -1), _EDGE, 1.0 - _EDGE)  # type: ignore[no-any-return]
