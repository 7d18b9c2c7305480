"""The border of what links in a plane reach: arcs that can be it, cut where they meet, tried on both sides."""

from cmath import exp, phase
from math import acos, pi, remainder

from dynamics_cli.robot.workspace.planar import TURN, Arc

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

# As shares of the arm: circles nearer than the first are one; how far beside an arc a point is tried.
SAME, BESIDE = 1e-10, 1e-9
# Cuts nearer than this angle are one; circles that touch to this share of one meet once.
TINY, TOUCH = 1e-6, 1e-13


class Side:
    """A piece of the border, and whether what is reached lies nearer to the arc's centre."""

    def __init__(self, arc: Arc, inner: bool) -> None:
        self.arc, self.inner = arc, inner

    @property
    def ends(self) -> "tuple[complex, complex]":
        """From where to where it runs, what is reached on its left."""
        ends = self.arc.at(self.arc.start), self.arc.at(self.arc.end)
        return ends if self.inner else ends[::-1]

    @property
    def area(self) -> float:
        """Its part of ½∮(x dy − y dx)."""
        arc = self.arc
        chord = exp(1j * arc.end) - exp(1j * arc.start)
        swept = 0.5 * arc.radius * (arc.radius * (arc.end - arc.start) + (arc.centre.conjugate() * chord).imag)
        return swept if self.inner else -swept


def border(arcs: "Sequence[Arc]", reaches: "Callable[[complex], bool]", size: float) -> "list[Side]":
    """The pieces with what is reached on one side alone."""
    sides = []
    for piece in pieces(arcs, size):
        at, out = piece.at(piece.middle), exp(1j * piece.middle)
        step = min(BESIDE * size, 0.1 * piece.radius)
        inner, outer = reaches(at - step * out), reaches(at + step * out)
        if inner != outer:
            sides.append(Side(piece, inner))
    return sides


def pieces(arcs: "Sequence[Arc]", size: float) -> "list[Arc]":
    """The arcs cut at one another, what is common to several kept once."""
    out = []
    for circle in circles(arcs, size):
        first = circle[0]
        cuts = [arc.start for arc in circle] + [arc.end for arc in circle]
        for other in arcs:
            if not _one_circle(first, other, size):
                cuts += meetings(first, other)
        start = cuts[0]
        marks = _apart([(cut - start) % TURN for cut in cuts])
        for low, high in zip(marks, [*marks[1:], TURN], strict=True):
            middle = start + 0.5 * (low + high)
            owner = next((arc for arc in circle if arc.inside(middle) is not None), None)
            if owner is not None:
                out.append(owner.part(start + low, start + high))
    return out


def _apart(cuts: "Sequence[float]") -> "list[float]":
    """Cuts in order, of those that are one the first named: the ends of arcs are known better than where they meet."""
    marks = [0.0]
    for cut in cuts:
        if all(abs(remainder(cut - mark, TURN)) > TINY for mark in marks):
            marks.append(cut)
    return sorted(marks)


def circles(arcs: "Sequence[Arc]", size: float) -> "list[list[Arc]]":
    """The arcs by their circles."""
    groups: list[list[Arc]] = []
    for arc in sorted(arcs, key=lambda arc: not arc.singular):
        for group in groups:
            if _one_circle(group[0], arc, size):
                group.append(arc)
                break
        else:
            groups.append([arc])
    return groups


def _one_circle(first: Arc, second: Arc, size: float) -> bool:
    near = SAME * size
    return abs(first.centre - second.centre) < near and abs(first.radius - second.radius) < near


def meetings(first: Arc, second: Arc) -> "list[float]":
    """Angles on the first circle where it meets the second arc's circle."""
    way = second.centre - first.centre
    apart = abs(way)
    if not apart:
        return []
    cosine = (apart * apart + first.radius**2 - second.radius**2) / (2.0 * apart * first.radius)
    if abs(cosine) > 1.0 + 1e-12:
        return []
    if abs(cosine) > 1.0 - TOUCH:
        return [phase(way) if cosine > 0.0 else phase(-way)]
    side = acos(cosine)
    return [phase(way) + side, phase(way) - side]


def loops(sides: "Sequence[Side]", size: float) -> "list[list[Side]]":
    """The pieces in closed lines, what is reached on their left; at a point where several go on, the leftmost."""
    left = list(sides)
    out = []
    while left:
        line = [left.pop(0)]
        while abs(line[-1].ends[1] - line[0].ends[0]) > 1e-6 * size:
            end = line[-1].ends[1]
            ahead = [side for side in left if abs(side.ends[0] - end) < 1e-6 * size]
            if not ahead:
                break
            best = max(ahead, key=lambda side: phase(-_leaving(side) / _arriving(line[-1])) % TURN)
            left.remove(best)
            line.append(best)
        out.append(line)
    return out


def _leaving(side: Side) -> complex:
    arc = side.arc
    return 1j * exp(1j * arc.start) if side.inner else -1j * exp(1j * arc.end)


def _arriving(side: Side) -> complex:
    arc = side.arc
    return 1j * exp(1j * arc.end) if side.inner else -1j * exp(1j * arc.start)


def points_of(side: Side, step: float = pi / 90.0) -> "list[complex]":
    """Points along a piece, from its start to its end."""
    arc = side.arc
    count = max(2, int((arc.end - arc.start) / step) + 2)
    points = [arc.at(arc.start + (arc.end - arc.start) * k / (count - 1)) for k in range(count)]
    return points if side.inner else points[::-1]


def extremes(arc: Arc, directions: "Sequence[float]") -> "list[complex]":
    """Both ends of an arc, and its points in some directions from its centre."""
    inner = [arc.inside(angle) for angle in directions]
    return [arc.at(arc.start), arc.at(arc.end), *(arc.at(angle) for angle in inner if angle is not None)]


def distance_to(arc: Arc, point: complex) -> float:
    """From a point to the nearest point of an arc."""
    way = point - arc.centre
    if way and arc.inside(phase(way)) is not None:
        return abs(abs(way) - arc.radius)
    return min(abs(point - arc.at(arc.start)), abs(point - arc.at(arc.end)))
