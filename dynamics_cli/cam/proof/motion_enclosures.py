"""Proved bounds of a motion and its derivatives about given angles of the cam."""

import numpy as np

from dynamics_cli.cam.proof.law_discs import Parts, discs

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.cam.program.motion import Motion
    from dynamics_cli.numerics.discs import Disc


def about_angles(motion: "Motion", index: int, theta: "Any", radius: "Any", derivatives: int) -> "tuple[Disc, ...]":
    """Discs about cam angles (n,) of one zone of a motion, which are taken as exact and need not be within the zone."""
    parts = motion.parts_of(index)
    which = np.zeros(theta.shape, dtype=int)
    t = theta if parts[0].law_piece is None else parts[0].local(theta)
    for number, part in enumerate(parts[1:], 1):
        other = part.local(theta)
        # measured from the other end, or farther along
        inside = (1.0 - other if part.law_piece.far else other) >= part.law_piece.low
        which[inside], t[inside] = number, other[inside]
    return discs(Parts(parts), which, t, radius, derivatives)
