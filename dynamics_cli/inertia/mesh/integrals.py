"""Volume or area, first and second moments of triangles, in blocks: edges and centroids instead of corners.

A corner a (from the reference point) and the edges e = b − a, f = c − a of a triangle give n = e × f and d = a·n, six
times the volume of the tetrahedron on it. With p = a + (e + f)/3 and q = e − f/2 the integrals are sums of squares,

    ∫ r rᵀ dV = Σ d·(p pᵀ + q qᵀ/18 + f fᵀ/24)/10,    ∫ r rᵀ dA = Σ |n|·(p pᵀ + q qᵀ/18 + f fᵀ/24)/2

with the shares of a tetrahedron and a triangle. Edges do not depend on the reference point, so thin bodies keep
their digits.
"""

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.inertia.mesh.faults.closure import Boundary
from dynamics_cli.inertia.mesh.frame import Frame, departure
from dynamics_cli.quantities import Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.mesh.stl import Source

    Array = np.ndarray[Any, np.dtype[Any]]

UNIT_ROUNDOFF = 2.0**-53
# Roundings of one term of the sums, found by search over bodies of few triangles, whose errors do not average out; the
# sums themselves are compensated from block to block.
ROUNDINGS, ROUNDINGS_SECOND = 5.0, 2.5
# What gradual underflow can take from a product.
TINY = 5e-324
# Coordinates whose fifth powers would leave the range of a double.
LARGEST = 1e55
# What is added up: second moments xx yy zz xy yz zx, first moments, closure vector, Σ nₖ², Σ w, Σ |n|,
# Σ |eᵢ fⱼ| + |eⱼ fᵢ|, Σ eₖ², Σ fₖ².
_SECOND, _FIRST, _CLOSURE, _SQUARES, _TOTAL, _AREA, _PRODUCTS, _EDGES = (
    slice(0, 6), slice(6, 9), slice(9, 12), slice(12, 15), 15, 16, slice(17, 20), slice(20, 26),
)  # fmt: skip
# Bits of the reference point's coordinates, as many as single precision has.
_REFERENCE_BITS = 24
_PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))


class Moments:
    """Integrals over the triangles of one file, in its unit of length.

    `measure` is the volume (or the area of a shell), `second` the second moments about `centroid`, both in the axes of
    the file when `frame` is None, else `second` in the axes that are the rows of `frame`. The errors are rounding
    bounds: of the measure, of each coordinate, and of each second moment; `terms` is that of the weights of all
    triangles, `box` how far they reach, or what they are off by reaches, from the reference along the axes of the file.
    """

    def __init__(
        self, sums: "Sums", reference: "Array", frame: "Frame | None" = None, box: "Array | None" = None
    ) -> None:
        # the integral of one over a body of weight w, of r, and of r rᵀ
        scale = (2.0, 2.0, 2.0) if sums.shell else (6.0, 8.0, 10.0)
        self.shell = sums.shell
        self.frame = None if frame is None else frame.rows
        self.box = sums.extent if box is None or frame is None else np.maximum(box, frame.blur(sums.extent))
        # excess length of the axes, to first order: a solid is corrected for the stretch
        longer = np.zeros(3) if frame is None or sums.shell else 0.5 * np.diag(departure(frame.rows))
        self.measure = sums.total / scale[0] * (1.0 - float(longer.sum()))
        first = sums.first / scale[1]
        xx, yy, zz, xy, yz, zx = sums.second / scale[2]
        second = np.array(((xx, xy, zx), (xy, yy, yz), (zx, yz, zz)))
        extent, products = sums.extent + sums.grain, sums.products()
        # turned axes stretch a shell by a few roundings, which are not given back
        weight = float(products.sum()) + 4.0 * sums.area if sums.shell else float(extent @ products)
        unit = ROUNDINGS * UNIT_ROUNDOFF
        # loss by underflow in each product, before multiplication by others
        weight += sums.count * 32.0 * TINY * (1.0 + float(extent.max())) / unit
        self.measure_error = unit * weight / scale[0]
        self.reference = reference
        if self.measure == 0.0:
            self.centre = np.zeros(3)
            self.second = second
            self.centre_error = self.second_error = extent * 0.0
            self.terms, self.known = 0.0, False
            return
        centre = first * (1.0 - float(longer.sum())) / self.measure
        self.centre = centre
        second = second * (1.0 - float(longer.sum())) - self.measure * np.outer(centre, centre)
        self.second = second * (1.0 - (longer[:, None] + longer))
        # of a volume that may be half its own error nothing that is divided by it is known
        share = self.measure_error / abs(self.measure)
        room = abs(self.measure) * (1.0 - share) if share < 0.5 else 0.0
        self.known = room > 0.0
        self.centre_error = unit * weight * extent / scale[1] / room if self.known else np.full(3, np.inf)
        self.terms = ROUNDINGS_SECOND * UNIT_ROUNDOFF * (weight / scale[2]) / (1.0 - min(share, 0.5))
        reach = np.sqrt(sums.spread) + sums.grain if sums.grain else extent
        self.second_error = self.terms * np.outer(reach, reach) if self.known else np.full((3, 3), np.inf)

    @property
    def centroid(self) -> "Array":
        """The mass centre in the axes of the file."""
        offset = self.centre if self.frame is None else self.frame.T @ self.centre
        return self.reference + offset

    @property
    def centroid_error(self) -> "Array":
        """How far each coordinate of the mass centre may be off, with the rounding of the sum that it is."""
        error = self.centre_error
        if self.frame is not None and self.known:
            error = abs(self.frame.T) @ (error + 4.0 * UNIT_ROUNDOFF * abs(self.centre))
        return error + UNIT_ROUNDOFF * abs(self.centroid)

    def in_file(self) -> "tuple[Array, Array]":
        """Second moments in the axes of the file, and how far they may be off."""
        matrix, error = self.second, self.second_error
        if self.frame is None:
            return matrix, error
        back = self.frame.T @ matrix @ self.frame
        if not self.known:
            return back, error
        turn, size = abs(self.frame.T), abs(matrix)
        # axes that are not quite across one another do not turn back by their transpose
        apart = abs(departure(self.frame))
        # the extent of the body along the axes of the file bounds the error of the weights as well
        error = np.minimum(turn @ error @ turn.T, self.terms * np.outer(self.box, self.box))
        error = error + turn @ (8.0 * UNIT_ROUNDOFF * size + apart @ size + size @ apart) @ turn.T
        return back, error + UNIT_ROUNDOFF**2 * size.sum()

    def spread_error(self, value: float) -> float:
        """By how much an eigenvalue of `second` is stretched by axes that are orthonormal to rounding only."""
        return 0.0 if self.frame is None else 2.0 * UNIT_ROUNDOFF * abs(value)


class Sums:
    """The sums of one pass over the triangles."""

    def __init__(self, *, shell: bool, room: int, boundary: "Boundary | None" = None, grain: float = 0.0) -> None:
        self.shell = shell
        self.grain = grain
        self.boundary = boundary
        self.count = 0
        self.low = np.full(3, np.inf)
        self.high = np.full(3, -np.inf)
        self.extent = np.zeros(3)
        # the greatest mean square of a triangle's coordinates, of the second pass
        self.spread = np.zeros(3)
        self._sum, self._lost, self._part = np.zeros((3, 26))
        self._w, self._n, self._t = (np.empty(rows * room) for rows in (9, 3, 3))

    second = property(lambda self: self._sum[_SECOND])
    first = property(lambda self: self._sum[_FIRST])
    closure = property(lambda self: 0.5 * self._sum[_CLOSURE])
    squares = property(lambda self: 0.25 * self._sum[_SQUARES])
    total = property(lambda self: float(self._sum[_TOTAL]))
    area = property(lambda self: 0.5 * float(self._sum[_AREA]))

    def products(self) -> "Array":
        """Σ |eᵢ fⱼ| + |eⱼ fᵢ|, by whose rounding n = e × f is off: a sliver's normal is a small difference.

        Turned edges are off by a rounding of themselves and of the grain, or of their length where that is less.
        """
        exact = self._sum[_PRODUCTS]
        if not self.grain:
            return exact
        squares = self._sum[_EDGES].reshape(2, 3)
        e, f = np.sqrt(squares)
        more, other = np.minimum(np.sqrt(self.count) * self.grain, np.sqrt(squares.sum(axis=1)))
        # Cauchy and Schwarz: Σ |eᵢ fⱼ| ≤ √(Σ eᵢ² Σ fⱼ²)
        turned = [more * (f[k - 1] + f[k - 2]) + other * (e[k - 1] + e[k - 2]) + 2.0 * more * other for k in range(3)]
        return exact + np.array(turned)  # type: ignore[no-any-return]

    def add(self, x: "Array") -> None:
        """Add a block seen from the reference point, coordinates by vectors a, e, f by triangles; overwrites it."""
        size = x.shape[2]
        w = self._w[: 9 * size].reshape(3, 3, size)
        n, t = (m[: 3 * size].reshape(3, size) for m in (self._n, self._t))
        part = self._part
        a, e, f = x[:, 0], x[:, 1], x[:, 2]
        part[_PRODUCTS] = _cross(e, f, n, t)
        if self.grain:
            part[_EDGES] = [np.dot(row, row) for edge in (e, f) for row in edge]
        np.add.reduce(n, axis=1, out=part[_CLOSURE])
        np.add.reduce(np.multiply(n, n, out=t), axis=1, out=part[_SQUARES])
        t[0] += t[1]
        t[0] += t[2]
        d = np.sqrt(t[0], out=t[0])
        part[_AREA] = d.sum()
        if not self.shell:
            np.multiply(a, n, out=t)
            d = np.add(t[0], t[1], out=t[0])
            d += t[2]
        part[_TOTAL] = d.sum()
        np.add(e, f, out=n)
        n *= 1.0 / 3.0
        a += n
        np.multiply(f, 0.5, out=n)
        e -= n
        if self.grain:
            spread = a * a + e * e * (1.0 / 18.0) + f * f * (1.0 / 24.0)
            np.maximum(self.spread, spread.max(axis=1), out=self.spread)
        np.multiply(a, d, out=w[:, 0])
        np.multiply(e, np.multiply(d, 1.0 / 18.0, out=t[1]), out=w[:, 1])
        np.multiply(f, np.multiply(d, 1.0 / 24.0, out=t[1]), out=w[:, 2])
        # products this short stay on one thread: waking others costs more than they do
        part[_SECOND] = [sum(np.dot(w[i, k], x[j, k]) for k in range(3)) for i, j in _PAIRS]
        np.add.reduce(w[:, 0], axis=1, out=part[_FIRST])
        self.count += size
        self._accumulate()

    def _accumulate(self) -> None:
        """Add the block's sums to the whole's, keeping what rounding loses."""
        before, part = self._sum, self._part
        after = before + part
        virtual = after - before
        self._lost += (before - (after - virtual)) + (part - virtual)
        self._sum = after

    def finish(self) -> None:
        """Add the compensation of the sums."""
        self._sum = self._sum + self._lost


def first_pass(source: "Source", *, shell: bool, prove: bool) -> "tuple[Sums, Moments]":
    """Integrate over a source in the axes of its file, its boundary summed on the way when `prove` says so.

    Raises InadmissibleError when a coordinate is not finite or out of range, or there are no triangles.
    """
    boundary = Boundary(single=source.single, room=source.room) if prove else None
    sums = Sums(shell=shell, room=source.room, boundary=boundary)
    room, spare = np.empty((2, 9 * source.room))
    reference = np.zeros((3, 1))
    for corners in source.blocks():
        size = corners.shape[1]
        low, high = _box(corners, sums.count)
        np.minimum(sums.low, low, out=sums.low)
        np.maximum(sums.high, high, out=sums.high)
        double = spare[: 9 * size].reshape(9, size)
        double[:] = corners
        if sums.boundary is not None:
            sums.boundary.add(double)
        if sums.count == 0:
            reference = _reference(double)
        block = room[: 9 * size].reshape(3, 3, size)
        np.subtract(double[3:6], double[0:3], out=block[:, 1])
        np.subtract(double[6:9], double[0:3], out=block[:, 2])
        np.subtract(double[0:3], reference, out=block[:, 0])
        sums.add(block)
    require(sums.count > 0, "there are no triangles", code="empty")
    sums.finish()
    middle = reference[:, 0]
    sums.extent = np.maximum(sums.high - middle, middle - sums.low)
    return sums, Moments(sums, middle)


def second_pass(source: "Source", before: Sums, moments: Moments, rows: "Array") -> Moments:
    """Integrate again, seen from the mass centre in the axes that are the rows of `rows`.

    Coordinates in these axes are exact to a rounding of themselves, so what is thin in them keeps all its digits.
    """
    reference = moments.centroid
    frame = Frame(rows, reference, float(max(before.high - before.low)), source.room)
    sums = Sums(shell=moments.shell, room=source.room, grain=frame.grain)
    for corners in source.blocks():
        block = frame.seen(corners)
        a, e, f = block[:, 0], block[:, 1], block[:, 2]
        for corner in (a, a + e, a + f):
            np.maximum(sums.extent, np.abs(corner).max(axis=1), out=sums.extent)
        sums.add(block)
    sums.finish()
    return Moments(sums, reference, frame, np.maximum(before.high - reference, reference - before.low))


def _reference(corners: "Array") -> "Array":
    """A point near the first triangles, on a coarse grid so that differences from it are mostly exact."""
    mean = corners.reshape(3, 3, -1).mean(axis=(0, 2), dtype=np.float64)
    share, exponent = np.frexp(mean)
    return np.ldexp(np.round(share * 2.0**_REFERENCE_BITS), exponent - _REFERENCE_BITS)[:, None]  # type: ignore[no-any-return]


def _box(corners: "Array", before: int) -> "tuple[Array, Array]":
    """Minimum and maximum coordinates of a block; refuses coordinates that cannot be integrated."""
    low, high = corners.min(axis=1).reshape(3, 3).min(axis=0), corners.max(axis=1).reshape(3, 3).max(axis=0)
    size = max(float(np.abs(low).max()), float(np.abs(high).max()))
    if not size < np.inf:
        column = int(np.argmin(np.isfinite(corners).all(axis=0)))
        row = int(np.argmin(np.isfinite(corners[:, column])))
        require(
            False,
            "coordinate {axis} of corner {corner} of triangle {triangle} is {value}",
            code="not-finite",
            hint="export the file again",
            axis="xyz"[row % 3],
            corner=row // 3 + 1,
            triangle=before + column + 1,
            value=float(corners[row, column]),
        )
    require(size < LARGEST, "a coordinate of {size:3} is out of range", code="range", size=(size, Ratio))
    return low.astype(np.float64), high.astype(np.float64)


def _cross(e: "Array", f: "Array", n: "Array", t: "Array") -> "list[float]":
    """The cross product of the edges; returns the sums of the sizes of the products that it is differences of."""
    sizes = []
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        np.multiply(e[i], f[j], out=n[k])
        np.multiply(e[j], f[i], out=t[0])
        np.abs(n[k], out=t[1])
        np.abs(t[0], out=t[2])
        t[1] += t[2]
        sizes.append(np.add.reduce(t[1]))
        n[k] -= t[0]
    return sizes
