"""Further ways beside those of `alternatives/gear/root`."""

from math import cos, pi, sin, tan

from dynamics_cli.accuracy.alternatives.gear.root import MOST_STEPS, _without_undercut

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def newton_of_two(**given: "Any") -> "dict[str, float]":
    """Newton for both unknowns, θ and the involute's angle, on x and y of the two curves in the tooth's space."""
    from dynamics_cli.gear.single.trochoid import Cutter, trochoid_point

    cutter = Cutter(**given)
    plain = _without_undercut(cutter)
    if plain is not None:
        return {"form_radius": plain}
    transverse, base = cutter.transverse_angle, cutter.base_radius
    space = (0.5 * pi - 2.0 * cutter.shift * tan(cutter.pressure_angle)) / cutter.teeth - (tan(transverse) - transverse)

    def apart(theta: float, angle: float) -> "tuple[float, float]":
        radius, half = trochoid_point(cutter, theta)
        own, place = base / cos(angle), space + tan(angle) - angle
        return radius * sin(half) - own * sin(place), radius * cos(half) - own * cos(place)

    theta, angle, h = 1.2 * transverse, 0.5 * transverse, 1e-7
    for _ in range(MOST_STEPS):
        x, y = apart(theta, angle)
        (xt, yt), (xa, ya) = apart(theta + h, angle), apart(theta, angle + h)
        a, c, b, d = (xt - x) / h, (yt - y) / h, (xa - x) / h, (ya - y) / h
        whole = a * d - b * c
        one, two = (x * d - y * b) / whole, (a * y - c * x) / whole
        theta, angle = theta - one, angle - two
        if abs(one) + abs(two) <= 1e-14:
            return {"form_radius": trochoid_point(cutter, theta)[0]}
    raise ArithmeticError
