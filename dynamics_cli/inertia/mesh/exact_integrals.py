"""Volume or area, first and second moments of a few triangles in integer arithmetic: only the results are rounded.

Doubles are whole multiples of a power of two, and the integrals of a solid are polynomials in them. With the corners
a, b, c of a triangle from a point, s = a + b + c and d = a·(b × c), six times the volume of the tetrahedron on it,

    ∫ dV = Σ d/6,    ∫ r dV = Σ d·s/24,    ∫ r rᵀ dV = Σ d·(s sᵀ + a aᵀ + b bᵀ + c cᵀ)/120;

of a shell |n|, twice the area, takes the place of d with the shares 2, 6 and 24; its root is cut after 120 bits.
"""

from math import isqrt

import numpy as np

from dynamics_cli.inertia.bodies.principal import principal
from dynamics_cli.numerics.eigen3.residual import UNIT_ROUNDOFF, along, grams, whole

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.mesh.stl import Source

    Array = np.ndarray[Any, np.dtype[Any]]

# Bits of the root that an area is.
ROOT_BITS = 120
# Error of a result by gradual underflow.
TINY = 5e-324
# A double from a ratio of integers is within half of its last bit; slightly more covers the bound's own rounding.
_ONCE = UNIT_ROUNDOFF * (1.0 + 2.0**-30)


class WholeMoments:
    """Integrals over a few triangles, in the unit of their file, each rounded once; the same as `Moments`.

    `measure` and `centroid` are in the axes of the file, `second` is about the mass centre in the axes that are the
    rows of `frame`.
    """

    def __init__(self, source: "Source", *, shell: bool) -> None:
        self.shell = shell
        self.frame: Array | None = None
        doubles = np.concatenate([block.T.astype(np.float64) for block in source.blocks()])
        lines, unit = whole(doubles.tolist())
        corners = np.array(lines, dtype=object).reshape(-1, 3, 3)
        origin = corners[0, 0]
        total, first, second = _sums(corners - origin, shell=shell)
        # of the volume, of r and of r rᵀ, and the power of the unit that the volume has
        parts, power = ((2, 6, 24), 2) if shell else ((6, 24, 120), 3)
        scale = unit**power << (ROOT_BITS if shell else 0)
        self.measure = total / (parts[0] * scale)
        # truncation error of the roots, and its maximum distance from any point of the body
        self._cut = len(lines) / (unit * unit << ROOT_BITS) + TINY if shell else 0.0
        self._size = float(np.ptp(doubles.reshape(-1, 3), axis=0).max())
        self.measure_error = _ONCE * abs(self.measure) + (self._cut + TINY)
        self.centroid = np.zeros(3)
        self.second = np.zeros((3, 3))
        self._in_file = self.second
        self._stretch = 0.0
        if total:
            down = parts[1] * total
            self.centroid = ((origin * down + parts[0] * first) / (down * unit)).astype(float)
            # about the mass centre, times parts[2]·parts[1]²·total
            central = parts[1] ** 2 * total * second - parts[0] * parts[2] * np.outer(first, first)
            self._turned(central, parts[2] * parts[1] ** 2 * total * scale * unit**2)

    def _turned(self, central: "Array", scale: int) -> None:
        """Second moments in the axes of the file, then in their principal axes."""
        self._in_file = (central / scale).astype(float)
        sign = 1.0 if self.measure > 0.0 else -1.0
        axes = principal(tuple(map(tuple, (sign * self._in_file).tolist()))).axes  # type: ignore[arg-type]
        self.frame = np.array(axes)
        lines, _ = whole(axes)
        products, cells = grams(lines), along(central.tolist(), lines)
        # divided by the squared lengths of the axes; off the diagonal by one of them instead of both
        long = [products[k][k] * scale for k in range(3)]
        self.second = np.array([[cells[i][j] / long[max(i, j)] for j in range(3)] for i in range(3)])
        beside = [sum(abs(products[i][j]) for j in range(3) if j != i) / products[i][i] for i in range(3)]
        self._stretch = max(beside)

    @property
    def centroid_error(self) -> "Array":
        """Error bound of each coordinate of the mass centre."""
        cut = self._cut * self._size / abs(self.measure) if self.measure else 0.0
        return _ONCE * abs(self.centroid) + (cut + TINY)

    def in_file(self) -> "tuple[Array, Array]":
        """Second moments in the axes of the file, and their error bounds."""
        return self._in_file, _ONCE * abs(self._in_file) + (self._cut * self._size * self._size + TINY)

    @property
    def second_error(self) -> "Array":
        """Error bound of each element of `second`: one rounding, and four off the diagonal."""
        roundings = 4.0 - 3.0 * np.eye(3)
        return _ONCE * roundings * abs(self.second) + (self._cut * self._size * self._size + TINY)

    def spread_error(self, value: float) -> float:
        """Relative change of an eigenvalue of `second` by axes that are not exactly orthogonal (Ostrowski)."""
        return self._stretch * abs(value)


def _sums(corners: "Array", *, shell: bool) -> "tuple[Any, Array, Array]":
    """Σ d, Σ d·s and Σ d·(s sᵀ + a aᵀ + b bᵀ + c cᵀ) over triangles of whole numbers."""
    a, b, c = (corners[:, k] for k in range(3))
    if shell:
        normals = np.cross(b - a, c - a)
        d = np.array([isqrt(size << (2 * ROOT_BITS)) for size in (normals * normals).sum(axis=1)], dtype=object)
    else:
        d = (a * np.cross(b, c)).sum(axis=1)
    s = a + b + c
    return d.sum(), d @ s, sum((d[:, None] * part).T @ part for part in (s, a, b, c))
