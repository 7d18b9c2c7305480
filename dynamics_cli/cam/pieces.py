"""Pieces of a motion on which it is smooth, and proved extremes over them, each piece in a coordinate of its own."""

from itertools import pairwise
from math import ceil, pi

import numpy as np

from dynamics_cli.cam.enclosures import discs
from dynamics_cli.numerics.chebyshev import Extremes, Proxies, extremes, proxies
from dynamics_cli.numerics.discs import Disc
from dynamics_cli.numerics.remainders import proved_proxies

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.cam.motion import Motion

STEP = pi / 6.0


def pieces(motion: "Motion") -> "tuple[Any, Any]":
    """Starts and ends of the pieces of one turn, in radians and in order."""
    return np.array([zone.start for zone in motion.zones]), np.array([zone.end for zone in motion.zones])


def sample(motion: "Motion", theta: "Any", derivatives: int = 3) -> "tuple[Any, ...]":
    """Lift and its derivatives by cam angle at an array of angles."""
    return motion.at(theta, derivatives)


def within(motion: "Motion", place: "Any", piece: "Any", derivatives: int = 2) -> "tuple[Any, ...]":
    """Lift and its derivatives at shares (m, n) of the pieces that the m rows lie in."""
    out = np.empty((derivatives + 1, *place.shape))
    # numpy.unique would import numpy.ma, a quarter of the import of numpy
    for index in sorted(set(piece.tolist())):
        rows = piece == index
        out[:, rows] = motion.in_zone(index, place[rows], derivatives)
    return tuple(out)


def over_pieces(motion: "Motion", function: "Callable[..., Any]", derivatives: int = 2) -> Proxies:
    """Proxies, their remainders proved, of functions (q, m, n) of lift and derivatives, on shares of every piece.

    The function is called with discs (`numerics.discs`): arithmetic, roots, sines, arc tangents, `numpy.stack` and the
    like work on them as on arrays. Comparisons and branches on values do not: such a function is called with arrays,
    and what its proxies leave out is estimated (`Proxies.proved` is false); so it is for a motion without `parts_of`.
    """
    if not hasattr(motion, "parts_of"):
        return _estimated(motion, function, derivatives)
    parts, owner, rows = _rows(motion)
    starts, ends, which, far, first, width = rows

    def sampled(place: Disc, piece: "Any") -> "Any":
        here = far[piece][:, None]
        t = first[piece][:, None] + width[piece][:, None] * np.where(here, 1.0 - place.centre, place.centre)
        span = np.array([parts[index].span for index in which[piece].tolist()])
        radius = np.broadcast_to(place.radius, (piece.size, np.shape(place.radius)[-1] if np.ndim(place.radius) else 1))
        radius = radius * (width[piece] * span)[:, None]
        return function(*discs(parts, which[piece], t, radius, derivatives, shares=True))

    try:
        made = proved_proxies(sampled, starts, ends)
    except TypeError:
        return _estimated(motion, function, derivatives)
    return Proxies(owner[made.owner], made.starts, made.ends, made.coefficients, made.error, made.proved)


def _estimated(motion: "Motion", function: "Callable[..., Any]", derivatives: int) -> Proxies:
    """Proxies by arrays, their remainders estimated from the last coefficients."""
    count = len(motion.zones)
    return proxies(
        lambda place, piece: function(*within(motion, place, piece, derivatives)), np.zeros(count), np.ones(count)
    )


def _rows(motion: "Motion") -> "tuple[Any, ...]":
    """Parts of the motion, the piece each row is of, and the rows: parts cut into steps of 30 degrees or less."""
    parts: list[Any] = []
    owner: list[int] = []
    rows: list[tuple[float, ...]] = []
    for index in range(len(motion.zones)):
        own = motion.parts_of(index)
        laws = [part.law_piece for part in own]
        low, high = (0.0, 1.0) if laws[0] is None else (laws[0].low, laws[-1].high)
        for part, law in zip(own, laws, strict=True):
            a, b = (0.0, 1.0) if law is None else ((law.low - low) / (high - low), (law.high - low) / (high - low))
            steps = 1 if law is None else max(1, ceil((b - a) * (high - low) * part.span / STEP - 1e-9))
            edges = [a + (b - a) * i / steps for i in range(steps)] + [1.0 if part is own[-1] else b]
            far = law is not None and law.far
            rows += [
                (start, end, len(parts), far, 1.0 - high if far else low, high - low) for start, end in pairwise(edges)
            ]
            owner += [index] * steps
            parts.append(part)
    starts, ends, which, fars, first, width = (np.array(column) for column in zip(*rows, strict=True))
    return parts, np.array(owner), (starts, ends, which.astype(int), fars.astype(bool), first, width)


def turning_places(motion: "Motion", made: Proxies, which: int = 0, *, every: bool = False) -> Extremes:
    """Extremes of one function, their places as cam angles."""
    found = extremes(made, which, every=every)
    starts, ends = pieces(motion)
    theta = starts[found.owner] + found.places * (ends - starts)[found.owner]
    return Extremes(found.owner, theta, found.values, found.inside, found.error)


def joint_jumps(motion: "Motion") -> tuple[int, int]:
    """Joints where velocity or acceleration jumps, beyond rounding."""
    counts = [0, 0]
    before = [motion.in_zone(index, 1.0, 2) for index in range(len(motion.zones))]
    after = [motion.in_zone(index, 0.0, 2) for index in range(len(motion.zones))]
    for order in (1, 2):
        peak = max(abs(state[order]) for state in (*before, *after))
        peak = max(peak, *(abs(motion.in_zone(index, 0.37, 2)[order]) for index in range(len(before))))
        for index, state in enumerate(after):
            counts[order - 1] += abs(state[order] - before[index - 1][order]) > 1e-9 * peak
    return counts[0], counts[1]
