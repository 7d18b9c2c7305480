"""Contribution of one block of triangles to the integrals, in arrays that the next block reuses.

Everything of a block fits the cache of one core: corners make room for the weighted vectors, vectors for the words of
the proof that edges meet.
"""

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
_PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))


class BlockSum:
    """Sums over one block, its box and reach, and the sum over its directed edges."""

    __slots__ = ("boundary", "count", "extent", "high", "low", "spread", "terms")

    def __init__(self, count: int) -> None:
        self.count = count
        self.terms = np.zeros(TERMS)
        self.low: Array | None = None
        self.high: Array | None = None
        self.extent: Array | None = None
        self.spread: Array | None = None
        self.boundary = 0


class Room:
    """Arrays for the blocks of one thread, and the views of them: each would take as long as a thousand additions."""

    def __init__(self, size: int) -> None:
        self.size = size
        # vectors by coordinates x, y, z, and x, y again: a cross product is then a product of neighbouring rows
        vectors = np.empty((15, size))
        e, f = vectors[3:8], vectors[8:13]
        self.a, self.e, self.f = vectors[:3], e[:3], f[:3]
        self.normals, self.spare = np.empty((2, 3, size))
        self.weighted = np.empty((9, size))
        self._again = (e[3:], e[:2]), (f[3:], f[:2])
        self._factors = e[1:4], f[2:5], e[2:5], f[1:4]
        self._spare_rows = list(self.spare)
        self._corners = self.weighted[:3], self.weighted[3:6], self.weighted[6:]
        # rows of the three vectors, coordinate by coordinate, and those weighted
        self._pairs = [
            [(self.weighted[i + 3 * v], vector[j]) for v, vector in enumerate((self.a, self.e, self.f))]
            for i, j in _PAIRS
        ]
        words = vectors.view(np.uint64)
        self.words, self.hashes, self.mixed = words[:9], words[9:12], words[12:]

    def seen(self, reference: "Array") -> None:
        """Put corner a from a point and the edges e, f of the corners in `weighted` among the vectors."""
        a, b, c = self._corners
        np.subtract(b, a, out=self.e)
        np.subtract(c, a, out=self.f)
        np.subtract(a, reference, out=self.a)

    def add(self, part: BlockSum, *, shell: bool, turned: bool) -> None:
        """The sums over the vectors, seen from the reference point; overwrites them, and `weighted`."""
        n, t, terms = self.normals, self.spare, part.terms
        a, e, f = self.a, self.e, self.f
        d, weighted_row, more = self._spare_rows
        self._cross(n, t, terms)
        if turned:
            terms[EDGES] = [np.dot(row, row) for edge in (e, f) for row in edge]
        np.add.reduce(n, axis=1, out=terms[CLOSURE])
        np.multiply(n, n, out=t)
        np.add.reduce(t, axis=1, out=terms[SQUARES])
        np.add(d, weighted_row, out=d)
        np.add(d, more, out=d)
        np.sqrt(d, out=d)
        terms[AREA] = np.add.reduce(d)
        if not shell:
            np.multiply(a, n, out=t)
            np.add(d, weighted_row, out=d)
            np.add(d, more, out=d)
        terms[TOTAL] = np.add.reduce(d)
        np.add(e, f, out=n)
        np.multiply(n, 1.0 / 3.0, out=n)
        np.add(a, n, out=a)
        np.multiply(f, 0.5, out=n)
        np.subtract(e, n, out=e)
        if turned:
            spread = a * a + e * e * (1.0 / 18.0) + f * f * (1.0 / 24.0)
            part.spread = spread.max(axis=1)
        first, second, third = self._corners
        np.multiply(a, d, out=first)
        np.multiply(d, 1.0 / 18.0, out=weighted_row)
        np.multiply(e, weighted_row, out=second)
        np.multiply(d, 1.0 / 24.0, out=weighted_row)
        np.multiply(f, weighted_row, out=third)
        np.add.reduce(first, axis=1, out=terms[FIRST])
        # products this short stay on one thread: waking others costs more than they do
        dot = np.dot
        terms[SECOND] = [dot(*pair) + dot(*second_pair) + dot(*three) for pair, second_pair, three in self._pairs]

    def _cross(self, n: "Array", t: "Array", terms: "Array") -> None:
        """The cross product of the edges, and the sums of the sizes of the products that it is differences of."""
        for target, source in self._again:
            np.copyto(target, source)
        e, f, other_e, other_f = self._factors
        size, more, _ = self._corners
        np.multiply(e, f, out=n)
        np.multiply(other_e, other_f, out=t)
        np.abs(n, out=size)
        np.abs(t, out=more)
        np.add(size, more, out=size)
        np.add.reduce(size, axis=1, out=terms[PRODUCTS])
        np.subtract(n, t, out=n)
