"""Volume or area, first and second moments of triangles: edges and centroids instead of corners.

A corner a (from the reference point) and the edges e = b − a, f = c − a of a triangle give n = e × f and d = a·n, six
times the volume of the tetrahedron on it. With h = e + f, g = e − f and p = a + h/3 the integrals are sums of squares,

    ∫ r rᵀ dV = Σ d·(p pᵀ + g gᵀ/24 + h hᵀ/72)/10,    ∫ r rᵀ dA = Σ |n|·(p pᵀ + g gᵀ/24 + h hᵀ/72)/2

with the shares of a tetrahedron and a triangle. Edges do not depend on the reference point, so thin bodies keep
their digits.
"""

from math import fsum

import numpy as np

from dynamics_cli.inertia.mesh.frame import Frame, departure

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Array = np.ndarray[Any, np.dtype[Any]]

UNIT_ROUNDOFF = 2.0**-53
# Roundings of one term of the sums, found by search over bodies of few triangles, whose errors do not average out; the
# sums themselves are compensated from block to block.
ROUNDINGS, ROUNDINGS_SECOND = 5.0, 2.5
# Error of a product by gradual underflow.
TINY = 5e-324


class Moments:
    """Integrals over the triangles of one file, in its unit of length.

    `measure` is the volume (or the area of a shell), `second` the second moments about `centroid`, both in the axes of
    the file when `frame` is None, else `second` in the axes that are the rows of `frame`. The errors are rounding
    bounds: of the measure, of each coordinate, and of each second moment; `terms` is the error of the weights of all
    triangles, `box` their extent, or that of their error, from the reference along the axes of the file.
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
        # symmetric but for rounding
        second = (sums.second + sums.second.T) / (2.0 * scale[2])
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
        relative = self.measure_error / abs(self.measure)
        least_measure = abs(self.measure) * (1.0 - relative) if relative < 0.5 else 0.0
        self.known = least_measure > 0.0
        self.centre_error = unit * weight * extent / scale[1] / least_measure if self.known else np.full(3, np.inf)
        self.terms = ROUNDINGS_SECOND * UNIT_ROUNDOFF * (weight / scale[2]) / (1.0 - min(relative, 0.5))
        reach = np.sqrt(sums.spread) + sums.grain if sums.grain else extent
        self.second_error = self.terms * np.outer(reach, reach) if self.known else np.full((3, 3), np.inf)

    @property
    def centroid(self) -> "Array":
        """The mass centre in the axes of the file."""
        offset = self.centre if self.frame is None else self.frame.T @ self.centre
        return self.reference + offset

    @property
    def centroid_error(self) -> "Array":
        """Error bound of each coordinate of the mass centre, with the rounding of its sum."""
        error = self.centre_error
        if self.frame is not None and self.known:
            error = abs(self.frame.T) @ (error + 4.0 * UNIT_ROUNDOFF * abs(self.centre))
        return error + UNIT_ROUNDOFF * abs(self.centroid)  # type: ignore[no-any-return]

    def in_file(self) -> "tuple[Array, Array]":
        """Second moments in the axes of the file, and their error bounds."""
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
    """The sums of one pass over the triangles, from those of its blocks.

    `spread` is the greatest mean square of a triangle's coordinates along the axes of the second pass, `grain` their
    common error; `proved` asks whether every directed edge is proved to have an opposite one.
    """

    def __init__(self, parts: "Array", *, shell: bool, proved: bool = False, grain: float = 0.0) -> None:
        self.shell = shell
        self.grain = grain
        self.count = int(parts["count"].sum())
        self.closed = proved and int(parts["edges"].sum()) == 0
        self.low, self.high = (find(parts[name].reshape(-1, 3), axis=0, initial=far) for name, find, far in
                               (("low", np.min, np.inf), ("high", np.max, -np.inf)))  # fmt: skip
        self.extent, self.spread = (parts[name].max(axis=0, initial=0.0) for name in ("extent", "spread"))
        centroids = _added(parts["centroids"])
        self.first = centroids[:, 3]
        self.second = centroids[:, :3] + _added(parts["differences"]) / 24.0 + _added(parts["sums"]) / 72.0
        self.closure, self.squares = 0.5 * _added(parts["closure"]), 0.25 * _added(parts["squares"])
        self.total, self.area = float(_added(parts["total"])), 0.5 * float(_added(parts["area"]))
        self._products, self._lengths = _added(parts["products"]), _added(parts["lengths"])

    def products(self) -> "Array":
        """Σ |eᵢ fⱼ| + |eⱼ fᵢ|, whose rounding is the error of n = e × f: the normal of a sliver is a small difference.

        The error of rotated edges is a rounding of themselves and of the grain, or of their length where that is less.
        """
        exact = np.array([self._products[k - 2, k - 1] + self._products[k - 1, k - 2] for k in range(3)])
        if not self.grain:
            return exact
        squares = self._lengths
        e, f = np.sqrt(squares)
        more, other = np.minimum(np.sqrt(self.count) * self.grain, np.sqrt(squares.sum(axis=1)))
        # Cauchy and Schwarz: Σ |eᵢ fⱼ| ≤ √(Σ eᵢ² Σ fⱼ²)
        turned = [more * (f[k - 1] + f[k - 2]) + other * (e[k - 1] + e[k - 2]) + 2.0 * more * other for k in range(3)]
        return exact + np.array(turned)  # type: ignore[no-any-return]


def _added(parts: "Array") -> "Array":
    """The sum of the blocks' sums, rounded once."""
    columns = parts.reshape(len(parts), -1).T.tolist()
    total: Array = np.array([fsum(column) for column in columns]).reshape(parts.shape[1:])
    return total
