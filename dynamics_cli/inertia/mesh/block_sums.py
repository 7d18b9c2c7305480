"""Contribution of one block of triangles to the integrals, in arrays that the next block reuses."""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Array = np.ndarray[Any, np.dtype[Any]]

# The sums over one block: directed edges, weighted squares of p (with Σ w p), e − f and e + f, Σ |eᵢ||fⱼ|, Σ n, Σ nₖ²,
# Σ w, Σ |n|, Σ eₖ² and Σ fₖ²; and the box of each corner, the reach and mean square along the axes of the second pass.
PART = np.dtype(
    [
        ("count", np.int64),
        ("edges", np.uint64),
        ("low", np.float64, 9),
        ("high", np.float64, 9),
        ("extent", np.float64, 3),
        ("spread", np.float64, 3),
        ("centroids", np.float64, (3, 4)),
        ("differences", np.float64, (3, 3)),
        ("sums", np.float64, (3, 3)),
        ("products", np.float64, (3, 3)),
        ("closure", np.float64, 3),
        ("squares", np.float64, 3),
        ("total", np.float64),
        ("area", np.float64),
        ("lengths", np.float64, (2, 3)),
    ]
)


class Room:
    """Arrays for the blocks of one process, and views of them: each would take as long as a thousand additions."""

    def __init__(self, size: int) -> None:
        self.size = size
        self.corners = np.empty((9, size))
        vectors = np.ones((10, size))
        self.normals, self._spare = np.empty((2, 3, size))
        self.a, self.e, self.f = vectors[:3], vectors[4:7], vectors[7:]
        self._a_and_one, self._edges = vectors[:4].T, vectors[4:]
        self._sizes = self.corners[:6]
        self._three = self.corners[:3], self.corners[3:6], self.corners[6:]
        self._factors = [
            (self.e[i], self.f[j], into[k])
            for k in range(3)
            for (i, j), into in (((k - 2, k - 1), self.normals), ((k - 1, k - 2), self._spare))
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
        n, weights = self.normals, self._spare[0]
        a, e, f = self.a, self.e, self.f
        for one, other, product in self._factors:
            np.multiply(one, other, out=product)
        np.subtract(n, self._spare, out=n)
        np.abs(self._edges, out=self._sizes)
        np.dot(self._sizes[:3], self._sizes[3:].T, out=part["products"])
        if turned:
            part["lengths"] = np.reshape([np.dot(row, row) for row in self._edges], (2, 3))
        np.add.reduce(n, axis=1, out=part["closure"])
        part["squares"] = [np.dot(row, row) for row in n]
        np.einsum("ij,ij->j", n, n, out=weights)
        np.sqrt(weights, out=weights)
        part["area"] = np.add.reduce(weights)
        if not shell:
            np.einsum("ij,ij->j", a, n, out=weights)
        part["total"] = np.add.reduce(weights)
        # the sum and the difference of the edges, in the rooms of the normals and of e; a becomes the centroid p
        h, third, g = n, f, e
        np.add(e, f, out=h)
        np.subtract(e, f, out=g)
        np.multiply(h, 1.0 / 3.0, out=third)
        np.add(a, third, out=a)
        if turned:
            part["spread"] = (a * a + g * g * (1.0 / 24.0) + h * h * (1.0 / 72.0)).max(axis=1)
        of_p, of_g, of_h = self._three
        np.multiply(a, weights, out=of_p)
        np.multiply(g, weights, out=of_g)
        np.multiply(h, weights, out=of_h)
        np.dot(of_p, self._a_and_one, out=part["centroids"])
        np.dot(of_g, g.T, out=part["differences"])
        np.dot(of_h, h.T, out=part["sums"])
