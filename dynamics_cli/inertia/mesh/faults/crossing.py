"""Self-intersections of a surface, and parts of it inside its own volume: faults that closure does not show.

A closed surface bounds each point of a solid once: just outside a triangle the winding number is 0 and just inside it
is 1. It is counted along a ray parallel to an axis, by the triangles that the ray leaves and enters; a ray that meets
an edge or runs along a face is shifted infinitesimally (by ε and ε², in signs only). A point touched by other
triangles is not judged.
"""

import numpy as np

from dynamics_cli.inertia.mesh.faults.broad_phase import BoxesAround, MeetingBoxes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Array = np.ndarray[Any, np.dtype[Any]]

# The sign of a determinant below this share of its terms may be rounding.
_ROUNDING = 1e-13
# The same relative to the product of three lengths, an upper bound of a determinant's terms; with a margin.
_APART = 16.0 * _ROUNDING


class Crossings:
    """Triangles that an edge of another one passes through, which shares no corner with it."""

    def __init__(self, points: "Array", faces: "Array") -> None:
        self.faces = faces
        self.corners = points[faces]
        self.boxes = MeetingBoxes(self.corners.min(axis=1), self.corners.max(axis=1)) if len(faces) else None

    @property
    def cost(self) -> int:
        """Number of pairs of triangles examined."""
        return self.boxes.pairs.count if self.boxes else 0

    def triangles(self) -> "Array":
        """Their numbers."""
        numbers = [np.empty(0, dtype=int)]
        planes = _Planes(self.corners)
        columns = [np.ascontiguousarray(self.faces[:, k]) for k in range(3)]
        for first, second in self.boxes or ():
            for k in range(3):
                for m in range(3):
                    apart = columns[k][first] != columns[m][second]
                    first, second = first[apart], second[apart]
            near = planes.may_cross(first, second)
            first, second = first[near], second[near]
            near = planes.may_cross(second, first)
            first, second = first[near], second[near]
            for through, along in ((first, second), (second, first)):
                for k in range(3):
                    p, q = self.corners[along, k], self.corners[along, k - 1]
                    numbers.append(through[_pierced(p, q, self.corners[through])])
        return np.unique(np.concatenate(numbers))


class _Planes:
    """The planes of triangles, and the distance within which rounding may decide."""

    def __init__(self, corners: "Array") -> None:
        self.corners = corners
        u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        self.start = np.ascontiguousarray(corners[:, 0])
        self.normals = np.cross(u, v)
        self.lengths = _APART * np.sqrt((u * u).sum(axis=1) * (v * v).sum(axis=1))

    def clear_sides(self, number: "Array", points: "Array") -> "Array":
        """The side of the planes that points are clearly on; 0 if undecided."""
        away = points - self.start[number]
        height = np.einsum("ij,ij->i", self.normals[number], away)
        clear = self.lengths[number] * np.sqrt(np.einsum("ij,ij->i", away, away))
        return np.where(np.abs(height) > clear, np.sign(height), 0.0)

    def sides(self, number: "Array", points: "Array") -> "tuple[Array, Array]":
        """Which side of the planes points are on, 0 where no triangle can hold one; and which triangles touch one."""
        sides = self.clear_sides(number, points)
        flush = np.flatnonzero(sides == 0.0)
        flush = flush[self._hold(number[flush], points[flush])]
        sides[flush] = _side(*(self.corners[number[flush], k] for k in range(3)), points[flush])  # type: ignore[call-arg]
        return sides, flush[sides[flush] == 0.0]

    def _hold(self, number: "Array", points: "Array") -> "Array":
        """Which points in the planes of triangles are within them, or on their edges within rounding."""
        inside = np.arange(len(points))
        for k in range(3):
            triangles = number[inside]
            start = self.corners[triangles, k - 1]
            edge, away, normal = self.corners[triangles, k] - start, points[inside] - start, self.normals[triangles]
            height = np.einsum("ij,ij->i", normal, np.cross(edge, away))
            lengths = [np.sqrt(np.einsum("ij,ij->i", part, part)) for part in (normal, edge, away)]
            inside = inside[height >= -_APART * np.prod(lengths, axis=0)]
        return inside

    def may_cross(self, triangle: "Array", other: "Array") -> "Array":
        """Whether the others' corners are not all clearly on one side of the planes of the first."""
        first, second, third = (self.clear_sides(triangle, self.corners[other, k]) for k in range(3))
        return (first == 0.0) | (first != second) | (second != third)  # type: ignore[no-any-return]


def _pierced(p: "Array", q: "Array", corners: "Array") -> "Array":
    """Whether the segment from p to q passes through the inside of a triangle, beyond rounding."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    across = _side(a, b, c, p) * _side(a, b, c, q) < 0
    turns = [_side(p, q, *ends) for ends in ((a, b), (b, c), (c, a))]
    through: Array = across & (turns[0] != 0) & (turns[0] == turns[1]) & (turns[1] == turns[2])
    return through


def _side(a: "Array", b: "Array", c: "Array", d: "Array") -> "Array":
    """Which side of the plane through a, b, c the point d is on; 0 where rounding may decide."""
    u, v, w = b - a, c - a, d - a
    terms = [u[:, i] * v[:, j] * w[:, k] for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1))]
    terms += [-u[:, i] * v[:, j] * w[:, k] for i, j, k in ((0, 2, 1), (1, 0, 2), (2, 1, 0))]
    value, size = sum(terms), sum(map(np.abs, terms))
    return np.where(np.abs(value) > _ROUNDING * size, np.sign(value), 0.0)


class Windings:
    """Winding numbers of a surface about points, seen along an axis; triangles of a point's label are left out."""

    def __init__(self, corners: "Array", at: "Array", axis: "Array", without: "Array", label: "Array") -> None:
        self.corners, self.at, self.without, self.label = corners, at, without, label
        self.planes = _Planes(corners)
        low, high = corners.min(axis=1), corners.max(axis=1)
        self.rays = []
        for ray in range(3):
            chosen, plane = np.flatnonzero(axis == ray), (ray - 2, ray - 1)
            if len(chosen):
                self.rays.append((chosen, plane, BoxesAround(at[chosen][:, plane], low[:, plane], high[:, plane])))

    @property
    def cost(self) -> int:
        """Number of pairs of points and triangles examined."""
        return sum(boxes.pairs.count for _, _, boxes in self.rays)

    def numbers(self) -> "Array":
        """The winding number about each point; not a number where a triangle touches it."""
        total, touched = np.zeros(len(self.at)), np.zeros(len(self.at), dtype=bool)
        for chosen, plane, boxes in self.rays:
            for place, triangle in boxes:
                point = chosen[place]
                other = self.without[point] != self.label[triangle]
                point, triangle = point[other], triangle[other]
                side, flush = self.planes.sides(triangle, self.at[point])
                touched[point[flush]] = True
                turn = -side
                for k in range(3):
                    # the ray leaves a triangle that is seen from inside
                    turns = _turn(self.corners[triangle, k - 1], self.corners[triangle, k], self.at[point], plane)
                    touching = (turns == turn) & (turns != 0.0)
                    point, triangle, turn = point[touching], triangle[touching], turns[touching]
                total += np.bincount(point, turn, len(total))
        return np.where(touched, np.nan, total)


def _turn(u: "Array", v: "Array", p: "Array", plane: "tuple[int, int]") -> "Array":
    """On which side of an edge, seen along an axis, a point is: 1 on the left, −1 on the right.

    The same to both triangles of an edge, whose ends are taken in one order. A point on it is moved by ε and ε²; 0 is
    of an edge that is seen end on.
    """
    i, j = plane
    swapped = (u[:, i] > v[:, i]) | ((u[:, i] == v[:, i]) & (u[:, j] > v[:, j]))
    low, high = np.where(swapped[:, None], v, u), np.where(swapped[:, None], u, v)
    x, y = high[:, i] - low[:, i], high[:, j] - low[:, j]
    value = np.sign(x * (p[:, j] - low[:, j]) - y * (p[:, i] - low[:, i]))
    value = np.where(value == 0.0, np.where(y == 0.0, np.sign(x), -np.sign(y)), value)
    return np.where(swapped, -value, value)  # type: ignore[no-any-return]


class Placement:
    """Triangles inside the volume of others, which is then counted twice, and triangles that face inwards."""

    def __init__(self, points: "Array", faces: "Array", piece: "Array") -> None:
        corners = points[faces]
        count = np.arange(len(faces))
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        # along the axis that a triangle faces most, its middle is well inside it
        axis = np.argmax(np.abs(normal), axis=1)
        self.inwards = normal[count, axis] < 0.0
        middle = corners - corners.mean(axis=(0, 1))
        volumes = np.bincount(piece, weights=(middle[:, 0] * np.cross(middle[:, 1], middle[:, 2])).sum(axis=1))
        self.hollow = volumes[piece] < 0.0
        self.middles = Windings(corners, corners.mean(axis=1), axis, count, count)
        # corners of one piece against all other pieces: those of a piece that faces inwards lie within another one
        self.corners = Windings(corners, corners[:, 0], axis, piece, piece) if piece.any() else None

    @property
    def cost(self) -> int:
        """Number of pairs of points and triangles examined."""
        return self.middles.cost + (self.corners.cost if self.corners else 0)

    def triangles(self) -> "tuple[Array, Array]":
        """The numbers of triangles within, and of triangles against."""
        # the ray from a triangle begins on the side that the triangle shows it
        winding = np.nan_to_num(self.middles.numbers() - self.inwards)
        if self.corners:
            beside = np.nan_to_num(self.corners.numbers() - self.hollow)
            winding = np.where(winding == 0.0, beside, winding)
        return np.flatnonzero(winding > 0.0), np.flatnonzero(winding < 0.0)
