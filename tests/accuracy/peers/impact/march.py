"""How an impact is marched along its impulse until slip stops or the law ends it: own steps, or those of scipy."""

from peers.solvers import dormand_prince

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

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


def scipy(method: str, tolerance: float) -> "March":
    """A method of scipy's `solve_ivp`."""

    def march(
        slope: "Slope", y: "State", events: "Sequence[Event]", absolute: float, longest: float
    ) -> "tuple[State, list[bool]]":
        from scipy.integrate import solve_ivp

        ends = [_terminal(event) for event in events]
        found = solve_ivp(slope, [0.0, longest], y, method=method, events=ends, rtol=tolerance, atol=absolute)
        if found.status != 1:
            raise ArithmeticError
        return [float(value) for value in found.y[:, -1]], [len(times) > 0 for times in found.t_events]

    return march


def _terminal(event: "Event") -> "Any":
    def made(t: float, y: "Any") -> float:
        return float(event(t, y))

    made.terminal, made.direction = True, 1.0  # type: ignore[attr-defined]
    return made
