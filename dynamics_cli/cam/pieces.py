"""Pieces of a motion on which it is smooth, and extremes over them, each piece in a coordinate of its own."""

import numpy as np

from dynamics_cli.numerics.chebyshev import Extremes, Proxies, extremes, proxies

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.cam.motion import Motion


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
    """Proxies of functions (q, m, n) of the lift and its derivatives, on shares of every piece."""
    count = len(motion.zones)

    def sampled(place: "Any", piece: "Any") -> "Any":
        return function(*within(motion, place, piece, derivatives))

    return proxies(sampled, np.zeros(count), np.ones(count))


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
