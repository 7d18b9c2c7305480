"""How an impact is marched along its impulse until slip stops or the law ends it."""

from peers.solvers import dormand_prince

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    State = list[float]
    Slope = Callable[[float, State], Sequence[float]]
    Event = Callable[[float, State], float]
    # slopes, state, events that rise to zero, what may be lost of any part, and the longest way
    March = Callable[[Slope, State, Sequence[Event], float, float], tuple[State, list[bool]]]


def own(tolerance: float) -> "March":
    """Dormand and Prince's steps of order five."""

    def march(
        slope: "Slope", y: "State", events: "Sequence[Event]", absolute: float, longest: float
    ) -> "tuple[State, list[bool]]":
        _, end, which = dormand_prince(slope, y, events, tolerance, absolute, first=1e-6 * longest)
        return end, which

    return march
