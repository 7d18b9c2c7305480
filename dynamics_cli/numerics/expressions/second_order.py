"""Motion along a line under a law a(t, x, v), by Taylor series of high order with steps chosen by their convergence.

Each piece holds the Taylor polynomials of position and velocity about its start, so values anywhere within it, and
places where something is reached, cost a polynomial.
"""

import math

from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.roots import bisected

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

ORDER = 18
# Size of the last term of a piece relative to the first.
SHARE = 1e-17
GROWTH = 8.0
MOST_PIECES = 600
SAMPLES = 16
# A step this small relative to the elapsed time means a pole of the law.
SMALLEST = 1e-11


class Piece:
    """A stretch of the motion: its start, its length, and the Taylor coefficients of position and velocity."""

    __slots__ = ("length", "position", "start", "velocity")

    def __init__(self, start: float, length: float, position: "list[float]", velocity: "list[float]") -> None:
        self.start = start
        self.length = length
        self.position = position
        self.velocity = velocity

    def at(self, time: float) -> "tuple[float, float, float]":
        """Position, velocity and acceleration a time after the piece's start."""
        slope = [k * c for k, c in enumerate(self.velocity)][1:]
        return _polynomial(self.position, time), _polynomial(self.velocity, time), _polynomial(slope, time)


class Pole(ArithmeticError):
    """The law cannot be followed further; `state` is time, position and velocity there."""

    def __init__(self, state: "tuple[float, float, float]") -> None:
        super().__init__("the law cannot be followed further")
        self.state = state


def _polynomial(parts: "Sequence[float]", x: float) -> float:
    value = 0.0
    for part in reversed(parts):
        value = value * x + part
    return value


def _series(law: "Callable[..., Any]", state: "tuple[float, float, float]") -> "tuple[list[float], list[float]]":
    time, position, velocity = state
    x, v = [position], [velocity]
    for k in range(ORDER):
        clock = [time, 1.0, *[0.0] * k][: k + 1]
        rate = law(t=Jet(clock), x=Jet(x), v=Jet(v))
        part = rate.parts[k] if isinstance(rate, Jet) else rate if k == 0 else 0.0
        x.append(v[k] / (k + 1))
        v.append(part / (k + 1))
    return x, v


def _step(parts: "Sequence[float]") -> float:
    """The step at which the last terms have the allowed size relative to the first."""
    first = next((j for j, part in enumerate(parts) if part), None)
    if first is None:
        return math.inf
    steps = [
        (SHARE * abs(parts[first] / parts[k])) ** (1.0 / (k - first))
        for k in (len(parts) - 2, len(parts) - 1)
        if k > first and parts[k]
    ]
    return min(steps, default=math.inf)


def pieces(
    law: "Callable[..., Any]", speed: float, *, first: float, most: float = math.inf, halved: bool = False
) -> "Any":
    """The motion from x = 0 at t = 0, piece by piece; `first` is the longest first piece, `most` the end of time.

    References
    ----------
    G. Corliss, Y. F. Chang, Solving ordinary differential equations using Taylor series, ACM Trans. Math. Softw.
    8 (1982) 114.
    """
    state = (0.0, 0.0, speed)
    longest = first
    for _ in range(MOST_PIECES * (2 if halved else 1)):
        try:
            x, v = _series(law, state)
            good = all(map(math.isfinite, (*x, *v)))
        except (ArithmeticError, ValueError):
            good = False
        if not good:
            raise Pole(state)
        length = min(_step(x), _step(v)) * (0.5 if halved else 1.0)
        if length < SMALLEST * max(state[0], SMALLEST * first if first < math.inf else 0.0):
            raise Pole(state)
        length = min(length, longest, most - state[0])
        if length == math.inf:
            return
        piece = Piece(state[0], length, x, v)
        yield piece
        if state[0] + length >= most:
            return
        position, velocity, _ = piece.at(length)
        state = (state[0] + length, position, velocity)
        longest = GROWTH * length


def crossing(piece: Piece, value: "Callable[[float], float]") -> float | None:
    """The first time within a piece at which `value` passes zero, by halving between samples."""
    low, before = 0.0, value(0.0)
    for sample in range(1, SAMPLES + 1):
        high = piece.length * sample / SAMPLES
        after = value(high)
        if after == 0.0 or (before != 0.0 and (before < 0.0) != (after < 0.0)):
            return bisected(value, low, high)
        low, before = high, after
    return None
