"""Contribution of one block of triangles to the integrals, in arrays that the next block reuses."""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Array = np.ndarray[Any, np.dtype[Any]]

# Terms of the sums: second moments xx yy zz xy yz zx, first moments, closure vector, Σ nₖ², Σ w, Σ |n|,
# Σ |eᵢ fⱼ| + |eⱼ fᵢ|, Σ eₖ², Σ fₖ².
SECOND, FIRST, CLOSURE, SQUARES, TOTAL, AREA, PRODUCTS, EDGES = (
    slice(0, 6), slice(6, 9), slice(9, 12), slice(12, 15), 15, 16, slice(17, 20), slice(20, 26),
)  # fmt: skip
TERMS = 26
# Sums over one block, the box of each corner, the reach and mean square along the axes of the second pass, and the sum
# over its directed edges.
PART = np.dtype(
    [
        ("count", np.int64),
        ("terms", np.float64, TERMS),
        ("low", np.float64, 9),
        ("high", np.float64, 9),
        ("extent", np.float64, 3),
        ("spread", np.float64, 3),
        ("edges", np.uint64),
    ]
)
# The elements of a symmetric matrix in their order, and the axes across each axis.
_ROWS, _COLUMNS = (0, 1, 2, 0, 1, 2), (0, 1, 2, 1, 2, 0)
_ACROSS = ((1, 2), (2, 0), (0, 1))


class Room:
    """Arrays for the blocks of one process, and views of them: each would take as long as a thousand additions."""

    def __init__(self, size: int) -> None:
        self.size = size
        self.corners = np.empty((9, size))
        vectors = np.ones((10, size))
        self.normals, self._spare = np.empty((2, 3, size))
        self.a, self.e, self.f = vectors[:3], vectors[4:7], vectors[7:]
        self._a_and_one, self._edges = vectors[:4], vectors[4:]
        self._sizes = self.corners[:6]
        self._three = self.corners[:3], self.corners[3:6], self.corners[6:]
        self._factors = [
            [
                (self.e[i], self.f[j], into[k])
                for (i, j), into in (((k - 2, k - 1), self.normals), ((k - 1, k - 2), self._spare))
            ]
            for k in range(3)
        ]
        self.hashes, self.mixed = self.normals.view(np.uint64), self._spare.view(np.uint64)

    def seen(self, reference: "Array") -> None:
        """Put corner a from a point and the edges e, f of `corners` among the vectors."""
        a, b, c = self._three
        np.subtract(b, a, out=self.e)
        np.subtract(c, a, out=self.f)
        np.subtract(a, reference, out=self.a)

    def add(self, part: "Any", *, shell: bool, turned: bool) -> None:
        """The sums over the vectors, seen from the reference point; overwrites them, and `corners`."""
        n, t, terms = self.normals, self._spare, part["terms"]
        a, e, f = self.a, self.e, self.f
        d, other, more = t
        self._cross(n, t, terms)
        if turned:
            terms[EDGES] = [np.dot(row, row) for row in self._edges]
        np.add.reduce(n, axis=1, out=terms[CLOSURE])
        np.multiply(n, n, out=t)
        np.add.reduce(t, axis=1, out=terms[SQUARES])
        np.add(d, other, out=d)
        np.add(d, more, out=d)
        np.sqrt(d, out=d)
        terms[AREA] = np.add.reduce(d)
        if not shell:
            np.einsum("ij,ij->j", a, n, out=d)
        terms[TOTAL] = np.add.reduce(d)
        # the sum and the difference of the edges, in the rooms of the normals and of e; a becomes the centroid p
        h, third, g = n, f, e
        np.add(e, f, out=h)
        np.subtract(e, f, out=g)
        np.multiply(h, 1.0 / 3.0, out=third)
        np.add(a, third, out=a)
        if turned:
            part["spread"] = (a * a + g * g * (1.0 / 24.0) + h * h * (1.0 / 72.0)).max(axis=1)
        for vector, weighted in zip((a, g, h), self._three, strict=True):
            np.multiply(vector, d, out=weighted)
        of_p, of_g, of_h = self._three
        by_p = np.dot(of_p, self._a_and_one.T)
        second = by_p[:, :3] + np.dot(of_g, g.T) / 24.0 + np.dot(of_h, h.T) / 72.0
        terms[FIRST] = by_p[:, 3]
        terms[SECOND] = second[_ROWS, _COLUMNS]

    def _cross(self, n: "Array", t: "Array", terms: "Array") -> None:
        """The cross product of the edges, and the sums of the sizes of the products that it is differences of."""
        for pair in self._factors:
            for e, f, product in pair:
                np.multiply(e, f, out=product)
        np.subtract(n, t, out=n)
        np.abs(self._edges, out=self._sizes)
        products = np.dot(self._sizes[:3], self._sizes[3:].T)
        terms[PRODUCTS] = [products[i, j] + products[j, i] for i, j in _ACROSS]
