"""Further ways beside those of `alternatives/solvers`."""

from math import inf

from dynamics_cli.accuracy.alternatives.solvers import ROUNDING

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    State = list[float]
    Slope = Callable[[float, State], Sequence[float]]
    Event = Callable[[float, State], float]


def newton_of_two(
    f: "Callable[[float, float], tuple[float, float]]", x: float, y: float, scale: "tuple[float, float]"
) -> "tuple[float, float]":
    """A root of two equations in two unknowns, by central differences over 1e-6 of their scales; steps are halved
    while they lead away.
    """
    (p, q), size = f(x, y), inf
    for _ in range(100):
        size = abs(p) + abs(q)
        dx, dy = 1e-6 * scale[0], 1e-6 * scale[1]
        (a, c), (b, d) = f(x + dx, y), f(x - dx, y)
        (e, g), (h, k) = f(x, y + dy), f(x, y - dy)
        px, qx, py, qy = (a - b) / (2.0 * dx), (c - d) / (2.0 * dx), (e - h) / (2.0 * dy), (g - k) / (2.0 * dy)
        whole = px * qy - py * qx
        if whole == 0.0:
            raise ArithmeticError
        one, two, share = (p * qy - q * py) / whole, (q * px - p * qx) / whole, 1.0
        while share > 1e-3 and sum(map(abs, f(x - share * one, y - share * two))) > 2.0 * size:
            share *= 0.5
        x, y = x - share * one, y - share * two
        p, q = f(x, y)
        if abs(one) <= 1e-15 * scale[0] + ROUNDING * abs(x) and abs(two) <= 1e-15 * scale[1] + ROUNDING * abs(y):
            break
        if abs(p) + abs(q) == 0.0:
            break
    if not abs(p) + abs(q) <= 1e-9:
        raise ArithmeticError
    return x, y
