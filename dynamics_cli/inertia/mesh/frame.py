"""Triangles seen from a point in rotated axes, each coordinate exact to one rounding.

Rotation by plain products leaves errors of a rounding of the longest side in every coordinate, too much for a needle or
a plate. Here the axes and the corners are split on grids so coarse that the leading product is exact whatever
its order of operations (Ozaki, Ogita, Oishi & Rump, Error-free transformations of matrix multiplication, Numer.
Algorithms 59 (2012) 95); the rest is 2⁻²⁶ of it and may be rounded. The axes need be orthogonal only to rounding:
second moments R S Rᵀ have the eigenvalues of S, except for the factor by which R stretches (Ostrowski).
"""

from math import frexp, ldexp

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Array = np.ndarray[Any, np.dtype[Any]]

# Bits of the leading parts: a sum of three products of them fits a double.
_BITS = 25


class Frame:
    """Axes as rows and a point to look from; `size` bounds the coordinates seen.

    The error of a coordinate is a rounding of itself and of `grain`, the remainder of the longest ones on the grid.
    """

    def __init__(self, rows: "Array", point: "Array", size: float, room: int) -> None:
        self.rows = rows
        self._high = np.round(rows * 2.0**_BITS) * 2.0**-_BITS
        self._low = rows - self._high
        self._point = point[:, None]
        # adding and taking away this number rounds to a multiple of 2⁻²⁵ of the size
        self._grid = ldexp(1.5, frexp(size)[1] + 52 - _BITS)
        self.grain = ldexp(1.0, frexp(size)[1] - _BITS)
        self._x, self._lost, self._lead, self._seen = np.empty((4, 9 * room))

    def seen(self, corners: "Array") -> "Array":
        """A block as coordinates by vectors a, e, f by triangles, seen in these axes from this point."""
        size = corners.shape[1]
        x, lost, lead, out = (
            space[: 9 * size].reshape(3, 3, size) for space in (self._x, self._lost, self._lead, self._seen)
        )
        a, b, c = corners.reshape(3, 3, size)
        for vector, (end, start) in enumerate(((a, self._point), (b, a), (c, a))):
            _difference(end, start, x[:, vector], lost[:, vector])
        np.add(x, self._grid, out=lead)
        lead -= self._grid
        lost += x - lead
        flat = (3, 3 * size)
        seen = np.matmul(self._high, lost.reshape(flat), out=out.reshape(flat))
        seen += self._low @ x.reshape(flat)
        seen += self._high @ lead.reshape(flat)
        return out

    def blur(self, extent: "Array") -> "Array":
        """Error along the file's axes of a point with this reach along these axes, in roundings.

        An axis of the file's own is seen without the grain of the grid.
        """
        aligned = np.isin(self.rows, (-1.0, 0.0, 1.0)).all(axis=1)
        return np.abs(self.rows.T) @ (extent + np.where(aligned, 0.0, self.grain))  # type: ignore[no-any-return]


def departure(rows: "Array") -> "Array":
    """R Rᵀ − 1 of the very doubles of the axes."""
    ratios = [[part.as_integer_ratio() for part in row] for row in rows.tolist()]
    common = max(down for row in ratios for _, down in row)
    whole = [[up * (common // down) for up, down in row] for row in ratios]
    one = common * common
    return np.array(
        [[(sum(x * y for x, y in zip(a, b, strict=True)) - one * (a is b)) / one for b in whole] for a in whole]
    )


def _difference(a: "Array", b: "Array", x: "Array", lost: "Array") -> None:
    """A − b and its rounding error."""
    np.subtract(a, b, out=x)
    virtual = x - a
    np.subtract(a - (x - virtual), b + virtual, out=lost)
