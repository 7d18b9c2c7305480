"""One complete motion of a four-bar over a parameter in which it is analytic, even through toggles and change points.

A crank that turns fully is its own parameter. Between limits θ₂ oscillates: with sin(θ₂/2) = S sin u the root that
vanishes at the limits is 2√(ad)·S·cos u exactly, so that both branches are one smooth closed curve in u.
"""

from itertools import pairwise

import numpy as np

from dynamics_cli.linkage.fourbar.closure import Frame
from dynamics_cli.linkage.fourbar.grashof import limits
from dynamics_cli.numerics.discs import Disc
from dynamics_cli.numerics.expressions.jets import Jet

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

FULL = 2.0 * np.pi


def wave(u: "Any") -> "tuple[Jet, Jet]":
    """Cosine and sine of the parameter, of arrays or of discs that hold them, with two derivatives."""
    cosine, sine = np.cos(u), np.sin(u)
    return Jet([cosine, -sine, cosine * -0.5]), Jet([sine, cosine, sine * -0.5])


def _root(u: Jet) -> Jet:
    """Its square root, where it is positive."""
    value = np.sqrt(u.parts[0])
    slope = u.parts[1] / (value * 2.0)
    return Jet([value, slope, (u.parts[2] - slope * slope) / (value * 2.0)])


class Circuit:
    """A closed motion over u from 0 to 2π.

    `side` is the branch of a crank that turns fully, else the side of the ground link on which the crank swings where
    there are two limits; elsewhere both branches belong to one motion.
    """

    def __init__(self, links: Frame, side: float) -> None:
        self.links = links
        self.side = side
        self.outer, self.inner = limits(links)
        # a motion through one change point closes after two turns of the crank
        self.turns = 2 if self.full and (links.outer == 0.0) != (links.inner == 0.0) else 1

    @property
    def full(self) -> bool:
        """Whether the crank turns fully."""
        return self.outer is None and self.inner is None

    def crank(self, u: "Any") -> "tuple[Jet, Jet, Jet]":
        """Cosine and sine of θ₂, and the signed √(D₁D₂)."""
        if self.full:
            return self._turning(u)
        links, (cosine, sine) = self.links, wave(u)
        a, b, c, d = links.lengths
        ad = links.product
        if self.outer is not None and self.inner is not None:
            far, near = np.cos(self.inner), np.cos(self.outer)
            middle, half = 0.5 * (far + near), 0.5 * (far - near)
            turn = sine * half + middle
            return turn, _root(1.0 - turn * turn) * self.side, cosine * (2.0 * ad * half)
        reach = np.sin(0.5 * self.outer) if self.outer is not None else np.cos(0.5 * self.inner)  # type: ignore[operator]
        relative = sine * reach
        square = relative * relative
        other = _root(1.0 - square)
        turn, across = 1.0 - square * 2.0, relative * other * 2.0
        root = cosine * (2.0 * np.sqrt(ad) * reach)
        gap = abs(links.slim)
        if self.outer is not None:
            if links.inner == 0.0:
                return turn, across, root * relative * (2.0 * np.sqrt(ad))
            return turn, across, root * _root(square * (4.0 * ad) + links.inner * (links.apart + gap))
        if links.outer == 0.0:
            return -turn, -across, root * relative * (2.0 * np.sqrt(ad))
        return -turn, -across, root * _root(square * (4.0 * ad) + links.outer * (a + b + c + d))

    def _turning(self, u: "Any") -> "tuple[Jet, Jet, Jet]":
        links = self.links
        b, c, ad = links.b, links.c, links.product
        if self.turns == 2:
            half_cosine, half_sine = wave(u)
            turn, across = half_cosine * half_cosine * 2.0 - 1.0, half_cosine * half_sine * 2.0
            square = half_sine * half_sine * (4.0 * ad)
        else:
            turn, across = wave(u)
            square = (1.0 - turn) * (2.0 * ad)
        gap = abs(links.slim)
        first = (b + c - links.apart) * (b + c + links.apart) - square
        second = square + links.inner * (links.apart + gap)
        if links.outer == 0.0 and links.inner == 0.0:
            return turn, across, across * (2.0 * ad * self.side)
        if links.outer == 0.0:
            return turn, across, half_cosine * _root(second) * (2.0 * np.sqrt(ad) * self.side)
        if links.inner == 0.0:
            return turn, across, half_sine * _root(first) * (2.0 * np.sqrt(ad) * self.side)
        return turn, across, _root(first * second) * self.side

    def place(self, u: "Any", point: complex) -> "tuple[Jet, Jet]":
        """A coupler point's coordinates as jets over u; the point is given from A along and left of AB."""
        links = self.links
        along, aside = point.real / links.b, point.imag / links.b
        if links.apart == 0.0 and links.slim == 0.0:
            (ax, ay), (bx, by) = self._kite(u)
            return ax + bx * along - by * aside, ay + by * along + bx * aside
        turn, across, area = self.crank(u)
        ax, ay = turn * links.a, across * links.a
        fx, fy = -ax + links.d, -ay
        square = (1.0 - turn) * (2.0 * links.product) + links.apart * links.apart
        twice = 0.5 / square
        ahead, offset = (square + links.excess) * twice, area * twice
        bx, by = ahead * fx - offset * fy, ahead * fy + offset * fx
        return ax + bx * along - by * aside, ay + by * along + bx * aside

    def _kite(self, u: "Any") -> "tuple[tuple[Jet, Jet], tuple[Jet, Jet]]":
        """Crank and coupler of a kite, a = d and b = c, whose pin A may pass O₄: b⃗ = ½f⃗ + ½√D₁·e^{iθ₂/2}."""
        links, (cosine, sine) = self.links, wave(u)
        a, b = links.a, links.b
        if links.outer == 0.0:
            # a rhombus, √D₁ = 2a·cos(θ₂/2), with θ₂ for the parameter
            ax, ay = cosine * a, sine * a
            leanx, leany = (cosine + 1.0) * (0.5 * a * self.side), sine * (0.5 * a * self.side)
        else:
            half, root = (cosine, sine), None
            if self.outer is not None:
                reach = np.sin(0.5 * self.outer)
                relative = sine * reach
                half, root = (_root(1.0 - relative * relative), relative), cosine * (2.0 * a * reach)
            if root is None:
                root = _root(4.0 * b * b - half[1] * half[1] * (4.0 * a * a)) * self.side
            ax, ay = (half[0] * half[0] * 2.0 - 1.0) * a, half[0] * half[1] * (2.0 * a)
            leanx, leany = root * half[0] * 0.5, root * half[1] * 0.5
        return (ax, ay), ((links.d - ax) * 0.5 + leanx, -ay * 0.5 + leany)


class CouplerPath:
    """A coupler curve with the interface for fitting and proof: over u, cut at its cusps."""

    parameter = "parameter"
    sharp = "the point nearly stops there: allow a wider tolerance, or draw lines"
    turn = 1.0

    def __init__(self, circuit: Circuit, point: complex, cusps: "Sequence[float]" = (), tolerance: float = 0.0) -> None:
        self.circuit = circuit
        self.point = point
        places = sorted(cusps)
        starts = list(places or [0.0])
        for place, after in pairwise([*places, *(cusp + FULL for cusp in places[:1])]):
            reach = 0.2 * (after - place)
            starts += [place + self._short(place, reach, tolerance), after - self._short(after, -reach, tolerance)]
        self.starts = np.array(sorted(starts))
        self.ends = np.append(self.starts[1:], self.starts[0] + FULL)
        self.still = np.zeros(self.starts.size, dtype=bool)
        # from each cusp on: a line away from it, the smooth piece, a line up to the next
        self.straight = [index for index in range(self.starts.size) if places and index % 3 != 1]

    def _short(self, cusp: float, room: float, tolerance: float) -> float:
        """Width beside a cusp over which a straight line keeps half the tolerance; `room` is negative before it."""
        fractions = np.linspace(0.0, 1.0, 17)
        while True:
            x, y = self.circuit.place(cusp + room * fractions, self.point)
            z = x.parts[0] + 1j * y.parts[0]
            chord = z[-1] - z[0]
            if np.abs(((z - z[0]) * chord.conj()).imag).max() <= 0.5 * tolerance * abs(chord):
                return abs(room)
            room *= 0.5

    def at(self, theta: "Any", piece: "int | None" = None) -> "tuple[Any, ...]":
        """Point, unit direction of travel and speed."""
        del piece
        x, y = self.circuit.place(theta, self.point)
        speed = np.hypot(x.parts[1], y.parts[1])
        over = 1.0 / np.where(speed > 0.0, speed, 1.0)
        return x.parts[0], y.parts[0], x.parts[1] * over, y.parts[1] * over, speed

    def on(self, piece: int) -> "Any":
        """The curve seen from within its piece."""
        from dynamics_cli.numerics.fitting.path import OnPiece

        return OnPiece(self, piece)

    def points(self, theta: "Any", piece: int) -> "tuple[Disc, Disc]":
        """Discs that hold the coordinates."""
        del piece
        x, y = self.circuit.place(Disc(theta, np.zeros_like(theta)), self.point)
        return x.parts[0], y.parts[0]

    def acceleration(self, theta: "Any", half: "Any", piece: int) -> "tuple[Any, Any]":
        """Bounds of the second and the first derivative on cells."""
        del piece
        with np.errstate(all="ignore"):
            x, y = self.circuit.place(Disc(theta, half), self.point)
            pairs = (x.parts[2] * 2.0, y.parts[2] * 2.0), (x.parts[1], y.parts[1])
            return (np.hypot(part.size, other.size) * (1.0 + 2.0**-49) for part, other in pairs)  # type: ignore[return-value]
