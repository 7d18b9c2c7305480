"""Volume or area, first and second moments of a few triangles in integer arithmetic: only the results are rounded.

Doubles are whole multiples of a power of two, and the integrals of a solid are polynomials in them. With the corners
a, b, c of a triangle from a point, s = a + b + c and d = a·(b × c), six times the volume of the tetrahedron on it,

    ∫ dV = Σ d/6,    ∫ r dV = Σ d·s/24,    ∫ r rᵀ dV = Σ d·(s sᵀ + a aᵀ + b bᵀ + c cᵀ)/120;

of a shell |n|, twice the area, takes the place of d with the shares 2, 6 and 24; its root is cut after 120 bits.
"""

from math import isqrt
from operator import lshift

import numpy as np

from dynamics_cli.inertia.bodies.principal import principal
from dynamics_cli.numerics.eigen3.residual import UNIT_ROUNDOFF, along, grams, whole

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.inertia.mesh.stl import Source

    Array = np.ndarray[Any, np.dtype[Any]]

# Bits of the root that an area is.
ROOT_BITS = 120
# Bits of a double and of a number of single precision.
_DOUBLE, _SINGLE = 53, 24
# Error of a result by gradual underflow.
TINY = 5e-324
# A double from a ratio of integers is within half of its last bit; slightly more covers the bound's own rounding.
_ONCE = UNIT_ROUNDOFF * (1.0 + 2.0**-30)
_CELLS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))


class WholeMoments:
    """Integrals over a few triangles, in the unit of their file, each rounded once; the same as `Moments`.

    `measure` and `centroid` are in the axes of the file, `second` is about the mass centre in the axes that are the
    rows of `frame`.
    """

    def __init__(self, source: "Source", *, shell: bool) -> None:
        self.shell = shell
        self.frame: Array | None = None
        corners = np.concatenate([block.astype(np.float64, copy=False) for block in source.blocks()], axis=1)
        rows, unit = _rows(corners)
        origin = rows[0][:3]
        total, first, second = _sums(rows, origin, shell=shell)
        # of the volume, of r and of r rᵀ, and the power of the unit that the volume has
        parts, power = ((2, 6, 24), 2) if shell else ((6, 24, 120), 3)
        scale = unit**power << (ROOT_BITS if shell else 0)
        self.measure = total / (parts[0] * scale)
        # truncation error of the roots, and its maximum distance from any point of the body
        self._cut = len(rows) / (unit * unit << ROOT_BITS) + TINY if shell else 0.0
        self._size = float(np.ptp(corners.reshape(3, 3, -1), axis=(0, 2)).max())
        self.measure_error = _ONCE * abs(self.measure) + (self._cut + TINY)
        self.centroid = np.zeros(3)
        self.second = np.zeros((3, 3))
        self._in_file = self.second
        self._stretch = 0.0
        if total:
            down = parts[1] * total
            middle = [(origin[k] * down + parts[0] * first[k]) / (down * unit) for k in range(3)]
            self.centroid = np.array(middle)
            self._turned(_central(total, first, second, parts), parts[2] * parts[1] ** 2 * total * scale * unit**2)

    def _turned(self, central: "list[list[int]]", scale: int) -> None:
        """Second moments in the axes of the file, then in their principal axes."""
        self._in_file = np.array([[part / scale for part in row] for row in central])
        sign = 1.0 if self.measure > 0.0 else -1.0
        axes = principal(tuple(map(tuple, (sign * self._in_file).tolist()))).axes  # type: ignore[arg-type]
        self.frame = np.array(axes)
        lines, _ = whole(axes)
        products, cells = grams(lines), along(central, lines)
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


def _rows(corners: "Array") -> "tuple[list[tuple[int, ...]], int]":
    """The nine coordinates of each triangle as whole multiples of one over a power of two, and that power."""
    mantissas, exponents = np.frexp(corners)
    parts = (mantissas * 2.0**_DOUBLE).astype(np.int64)
    bits = _DOUBLE
    if not (parts & (1 << (_DOUBLE - _SINGLE)) - 1).any():
        parts >>= _DOUBLE - _SINGLE
        bits = _SINGLE
    low = min(int(exponents[parts != 0].min(initial=bits)), bits)
    shifts = np.where(parts == 0, 0, exponents - low)
    columns = [list(map(lshift, part, shift)) for part, shift in zip(parts.tolist(), shifts.tolist(), strict=True)]
    return list(zip(*columns, strict=True)), 1 << (bits - low)


def _sums(rows: "list[tuple[int, ...]]", origin: "Sequence[int]", *, shell: bool) -> "tuple[int, list[int], list[int]]":
    """Σ d, Σ d·s and the six Σ d·(s sᵀ + a aᵀ + b bᵀ + c cᵀ) over the triangles."""
    u, v, w = origin
    total, first, second = 0, [0, 0, 0], [0] * 6
    for ax, ay, az, bx, by, bz, cx, cy, cz in rows:
        ax, ay, az, bx, by, bz, cx, cy, cz = ax - u, ay - v, az - w, bx - u, by - v, bz - w, cx - u, cy - v, cz - w
        if shell:
            d = _twice_area(bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az)
        else:
            d = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
        if not d:
            continue
        x, y, z = ax + bx + cx, ay + by + cy, az + bz + cz
        total += d
        first[0] += d * x
        first[1] += d * y
        first[2] += d * z
        second[0] += d * (x * x + ax * ax + bx * bx + cx * cx)
        second[1] += d * (y * y + ay * ay + by * by + cy * cy)
        second[2] += d * (z * z + az * az + bz * bz + cz * cz)
        second[3] += d * (x * y + ax * ay + bx * by + cx * cy)
        second[4] += d * (y * z + ay * az + by * bz + cy * cz)
        second[5] += d * (z * x + az * ax + bz * bx + cz * cx)
    return total, first, second


def _twice_area(ex: int, ey: int, ez: int, fx: int, fy: int, fz: int) -> int:
    """The length of the cross product of two edges, in units of 2⁻¹²⁰ of theirs squared."""
    x, y, z = ey * fz - ez * fy, ez * fx - ex * fz, ex * fy - ey * fx
    return isqrt((x * x + y * y + z * z) << (2 * ROOT_BITS))


def _central(total: int, first: "list[int]", second: "list[int]", shares: "tuple[int, int, int]") -> "list[list[int]]":
    """Second moments about the mass centre, times shares[2]·shares[1]²·total."""
    cell = {}
    for (i, j), part in zip(_CELLS, second, strict=True):
        cell[i, j] = cell[j, i] = shares[1] ** 2 * part * total - shares[0] * shares[2] * first[i] * first[j]
    return [[cell[i, j] for j in range(3)] for i in range(3)]
