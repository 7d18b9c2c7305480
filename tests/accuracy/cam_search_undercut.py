"""The undercut verdict of `cam check` and the lift it costs, for the search."""

from collections.abc import Iterator
from typing import Any

from cam_search_compared import Compared, Stated
from cam_search_contact import Carried, extreme
from cam_search_motion import Turn
from precise import Exact


def room(carried: Carried, *state: Any) -> Any:
    """Radius of curvature under a flat face, 1 − Rκ of a roller: below zero where the envelope runs backwards."""
    touch = carried.touch(*state)
    if carried.flat:
        return touch["radius"]
    roller = float(carried.roller) if hasattr(state[0], "shape") else carried.roller
    return 1 - carried.side * roller * touch["curvature"]


def lost(answer: Any, turn: Turn, carried: Carried, stated: Stated) -> Iterator[Compared]:
    """Whether the envelope runs backwards anywhere is the verdict, where no velocity jumps."""
    if answer.velocity_jumps or (not carried.flat and carried.roller == 0):
        return
    least = extreme(turn, lambda *state: room(carried, *state), -1)
    scale = carried.sizes["base_radius"] if carried.flat else 1.0
    if least < -1e-9 * scale:
        # a verdict is right or wrong
        yield from stated.compare("undercut", float(answer.undercut), Exact(1), 0.5)
    elif least > 1e-9 * scale and not answer.undercut:
        yield from stated.compare("undercut", 0.0, Exact(0), 0.5)
