"""A phase of a motion whose every number is known."""

from dynamics_cli.numerics.elementary import absolute, exp, sinh

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Below a fade of one over the time, so many terms leave 1e-60.
TERMS = 46


class Leg:
    """A phase whose every number is known: speeds at its ends, duration, distance, and the rate it ends with.

    `rate` is the acceleration along the path, less than zero while braking; in a build-up it is the one reached, in a
    start-up the one at its beginning, which falls with the speed by `fade`.
    """

    __slots__ = ("distance", "duration", "end", "fade", "kind", "rate", "start")

    def __init__(
        self, kind: str, start: float, end: float, duration: float, distance: float, rate: float, fade: float = 0.0
    ) -> None:
        self.kind = kind
        self.start = start
        self.end = end
        self.duration = duration
        self.distance = distance
        self.rate = rate
        self.fade = fade

    def at(self, time: "Any") -> "tuple[Any, Any]":
        """Distance and speed so long after the phase began."""
        if self.kind == "build-up":
            lost = 0.5 * self.rate * time * time / self.duration
            return time * (self.start + lost / 3.0), self.start + lost
        if self.kind == "start-up":
            gained, more = faded(time, self.fade)
            return self.start * time + self.rate * more, self.start + self.rate * gained
        gained = self.rate * time
        return time * (self.start + 0.5 * gained), self.start + gained


def faded(time: "Any", fade: "Any") -> "tuple[Any, Any]":
    """∫e^(−βt) dt = (1 − e^(−βt))/β and its integral (βt − 1 + e^(−βt))/β², without cancellation; β of either sign."""
    turned = fade * time
    if absolute(turned) < 1.0:
        first, second = 1.0, 1.0
        for term in range(TERMS, 1, -1):
            first = 1.0 - turned * first / term
            second = 1.0 - turned * second / (term + 1.0)
        return time * first, 0.5 * time * (time * second)
    gained = 2.0 * exp(-0.5 * turned) * sinh(0.5 * turned) / fade
    return gained, (time - gained) / fade
