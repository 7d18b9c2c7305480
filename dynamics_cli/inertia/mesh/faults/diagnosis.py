"""Diagnosis of a surface: faulty edges, flipped, duplicated and degenerate triangles, with counts and places."""

import numpy as np

from dynamics_cli.inertia.mesh.faults.closure import vertex_hashes
from dynamics_cli.inertia.mesh.faults.crossing import Crossings, Placement
from dynamics_cli.inertia.mesh.surface import Faults

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.mesh.stl import Source

    Array = np.ndarray[Any, np.dtype[Any]]

# Places named of each kind of fault.
NAMED = 3


def diagnose(source: "Source", *, closed: bool, most: "int | None" = None) -> "Faults | None":
    """Count and locate the faults that keep a surface from bounding a solid.

    None if more than `most` pairs of triangles are near each other: memory and time grow with their number.
    """
    corners, flat = _corners(source)
    faces, points = _joined(corners)
    equal = (faces[:, 0] == faces[:, 1]) | (faces[:, 1] == faces[:, 2]) | (faces[:, 2] == faces[:, 0])
    degenerate = np.flatnonzero(equal | flat)
    doubled = _doubled(np.sort(faces, axis=1))
    edges = _Edges(faces)
    flipped, piece = _turned(edges, len(faces))
    sound = faces[~(equal | flat)]
    crossings = Crossings(points, sound)
    placement = Placement(points, faces, _joined_pieces(edges, piece)) if closed else None
    pairs = crossings.cost + (placement.cost if placement else 0)
    if most is not None and pairs > most:
        return None
    crossing = np.flatnonzero(~(equal | flat))[crossings.triangles()]
    within, against = placement.triangles() if placement else (crossing[:0], crossing[:0])
    places = [
        *(f"open edge {_edge(points, edges, k)} of triangle {edges.owner(k)}" for k in edges.open[:NAMED]),
        *(f"clashing edge {_edge(points, edges, k)} of triangle {edges.owner(k)}" for k in edges.clashing[:NAMED]),
        *(f"triangle {k + 1} is flipped" for k in flipped[:NAMED]),
        *(f"triangle {k + 1} is given twice" for k in doubled[:NAMED]),
        *(f"triangle {k + 1} has no area" for k in degenerate[:NAMED]),
        *(f"an edge passes through triangle {k + 1}" for k in crossing[:NAMED]),
        *(f"triangle {k + 1} lies within the solid" for k in within[:NAMED]),
        *(f"triangle {k + 1} bounds the solid from inside" for k in against[:NAMED]),
    ]
    return Faults(
        vertices=len(points),
        edges=len(edges.start),
        shells=int(piece.max()) + 1,
        open_edges=len(edges.open),
        clashing_edges=len(edges.clashing),
        flipped=len(flipped),
        duplicated=len(doubled),
        repeated=len(_doubled(_from_least(faces))),
        degenerate=len(degenerate),
        crossing=len(crossing),
        within=len(within),
        against=len(against),
        pairs=pairs,
        places=tuple(places),
    )


def _corners(source: "Source") -> "tuple[Array, Array]":
    """Every corner as a row of three doubles, and which triangles have no area to the last bit."""
    parts, flat = [], []
    for block in source.blocks():
        coordinates = block.astype(np.float64)
        a, b, c = coordinates.reshape(3, 3, -1)
        flat.append(~np.cross(b - a, c - a, axis=0).any(axis=0))
        parts.append(np.ascontiguousarray(coordinates.T))
    return np.concatenate(parts).reshape(-1, 3), np.concatenate(flat)


def _joined(corners: "Array") -> "tuple[Array, Array]":
    """Triangles by the numbers of their corners, corners of the same coordinates being one."""
    h, spare = np.empty((2, 1, len(corners)), np.uint64)
    vertex_hashes(np.ascontiguousarray(corners.T), h, spare)
    _, first, number = np.unique(h[0], return_index=True, return_inverse=True)
    return number.reshape(-1, 3), corners[first]


class _Edges:
    """Edges between different corners, sorted: the triangles along each, and how they go along it."""

    def __init__(self, faces: "Array") -> None:
        size = int(faces.max()) + 1
        u = faces.ravel()
        v = faces[:, (1, 2, 0)].ravel()
        proper = np.flatnonzero(u != v)
        u, v = u[proper], v[proper]
        key = np.minimum(u, v) * size + np.maximum(u, v)
        order = np.argsort(key, kind="stable")
        key = key[order]
        self.size = size
        self.face = proper[order] // 3
        self.way = np.where(u[order] < v[order], 1, -1)
        self.start = np.flatnonzero(np.concatenate(([True], key[1:] != key[:-1]))) if len(key) else key
        self.count = np.diff(np.append(self.start, len(key)))
        self.key = key[self.start]
        sums = np.add.reduceat(self.way, self.start) if len(key) else self.way
        self.open = np.flatnonzero(self.count == 1)
        self.clashing = np.flatnonzero((sums != 0) & (self.count > 1))

    def owner(self, k: int) -> int:
        """The first triangle along an edge, counted from 1."""
        return int(self.face[self.start[k]]) + 1


def _turned(edges: _Edges, count: int) -> "tuple[list[int], Array]":
    """Triangles turned against most of their piece, and the piece of each, joined by edges of two triangles.

    Each piece is traversed from one triangle outward, front by front, with the orientation of each.
    """
    paired = edges.start[edges.count == 2]
    first_face, second_face = edges.face[paired], edges.face[paired + 1]
    against = edges.way[paired] == edges.way[paired + 1]
    ends = np.concatenate((first_face, second_face))
    neighbour = np.concatenate((second_face, first_face))
    clash = np.concatenate((against, against))
    order = np.argsort(ends, kind="stable")
    neighbour, clash = neighbour[order], clash[order]
    begin = np.searchsorted(ends[order], np.arange(count + 1))
    piece = np.full(count, -1)
    flipped = np.zeros(count, dtype=bool)
    pieces = seed = 0
    while seed < count:
        piece[seed] = pieces
        front = np.array([seed])
        while front.size:
            sizes = begin[front + 1] - begin[front]
            links = np.repeat(begin[front] - np.concatenate(([0], np.cumsum(sizes)[:-1])), sizes) + np.arange(
                sizes.sum()
            )
            neighbours, turned = neighbour[links], np.repeat(flipped[front], sizes) ^ clash[links]
            fresh = piece[neighbours] < 0
            neighbours, first = np.unique(neighbours[fresh], return_index=True)
            piece[neighbours], flipped[neighbours] = pieces, turned[fresh][first]
            front = neighbours
        pieces += 1
        rest = np.flatnonzero(piece[seed:] < 0)
        seed = seed + int(rest[0]) if rest.size else count
    turned_count = np.bincount(piece, weights=flipped, minlength=pieces)
    total = np.bincount(piece, minlength=pieces)
    minority = flipped ^ (2 * turned_count > total)[piece]
    return np.flatnonzero(minority).tolist(), piece


def _joined_pieces(edges: _Edges, piece: "Array") -> "Array":
    """Pieces joined by every edge that they share: of a closed surface each of these is closed."""
    several = np.flatnonzero(edges.count > 2)
    sizes = edges.count[several]
    first = np.repeat(edges.start[several], sizes)
    place = first + np.arange(len(first)) - np.repeat(np.cumsum(sizes) - sizes, sizes)
    links = np.unique(np.stack((piece[edges.face[first]], piece[edges.face[place]])), axis=1)
    number = list(range(int(piece.max()) + 1))
    for one, second in links.T.tolist():
        while number[one] != one:
            one = number[one]
        while number[second] != second:
            second = number[second]
        number[max(one, second)] = min(one, second)
    for index, to in enumerate(number):
        # a piece is joined to one of a lower number, which is already known
        number[index] = number[to]
    joined: Array = np.array(number)[piece]
    return joined


def _from_least(faces: "Array") -> "Array":
    """Corners in the order they go round, from the one of the least number."""
    places = (np.argmin(faces, axis=1)[:, None] + np.arange(3)) % 3
    return np.take_along_axis(faces, places, axis=1)


def _doubled(faces: "Array") -> "list[int]":
    """Triangles with the corners of an earlier one."""
    _, first = np.unique(faces, axis=0, return_index=True)
    later = np.ones(len(faces), dtype=bool)
    later[first] = False
    return np.flatnonzero(later).tolist()


def _edge(points: "Array", edges: _Edges, k: int) -> str:
    u, v = divmod(int(edges.key[k]), edges.size)
    return f"{_point(points[u])} to {_point(points[v])}"


def _point(point: "Array") -> str:
    return "(" + ", ".join(f"{part:.6g}" for part in point.tolist()) + ")"
