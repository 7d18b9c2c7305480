"""Bodies at one time: places and velocities of the points that joints and forces act on."""

from math import cos, sin

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any


class Frame:
    """Coordinates q and rates v of the bodies, and of every spot its place, arm from the mass centre, and velocity.

    A spot is a body (-1: ground), and a point relative to its mass centre in its own axes.
    """

    __slots__ = ("c", "phases", "q", "rx", "ry", "s", "v", "vx", "vy", "w", "x", "y")

    def __init__(
        self, n: int, spots: "Sequence[Any]", state: "list[Any]", cosine: "Any" = cos, sine: "Any" = sin
    ) -> None:
        end = 3 * n
        self.q, self.v, self.phases = q, v, _ = state[:end], state[end : 2 * end], state[2 * end :]
        self.w = w = v[2::3]
        self.c = c = [cosine(a) for a in q[2::3]]
        self.s = s = [sine(a) for a in q[2::3]]
        x: list[float] = []
        y: list[float] = []
        rx: list[float] = []
        ry: list[float] = []
        vx: list[float] = []
        vy: list[float] = []
        for body, px, py in spots:
            if body < 0:
                x.append(px)
                y.append(py)
                for zero in (rx, ry, vx, vy):
                    zero.append(0.0)
                continue
            a, b, turn, k = c[body] * px - s[body] * py, s[body] * px + c[body] * py, w[body], 3 * body
            x.append(q[k] + a)
            y.append(q[k + 1] + b)
            rx.append(a)
            ry.append(b)
            vx.append(v[k] - turn * b)
            vy.append(v[k + 1] + turn * a)
        self.x, self.y, self.rx, self.ry, self.vx, self.vy = x, y, rx, ry, vx, vy
