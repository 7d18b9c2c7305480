"""Oblique impact as textbooks teach it: components along and across the line of impact, or one system."""

from math import asin, atan2, cos, sin

from dynamics_cli.accuracy.alternatives.impact.plane import (
    angle_of,
    change,
    heading_of,
    kinetic,
    mass_of,
    state,
    velocity_of,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.accuracy.alternatives.impact.plane import Pair


def _line(line: "Any", relative: "Pair", axes: str) -> float:
    """The angle of the line of impact; of an offset d by sin θ = d/(r₁ + r₂) from the relative path."""
    if hasattr(line, "normal"):
        return angle_of(line.normal, axes)
    if hasattr(line, "offset"):
        return atan2(relative[1], relative[0]) + asin(line.offset / (line.first_radius + line.second_radius))
    one, two = line.first_centre, line.second_centre
    return atan2(two[1] - one[1], two[0] - one[0])


class Meeting:
    """Masses, velocities before and the line of impact."""

    def __init__(self, given: "dict[str, Any]") -> None:
        self.axes: str = given["axes"]
        self.zero: str = given["pdof_zero"]
        self.bodies = given["first"], given["second"]
        self.masses = [mass_of(body.bulk, given["gravity"]) for body in self.bodies]
        self.before = [velocity_of(body.motion, self.axes) for body in self.bodies]
        relative = self.before[0][0] - self.before[1][0], self.before[0][1] - self.before[1][1]
        angle = _line(given["line"], relative, self.axes)
        self.n = cos(angle), sin(angle)
        self.t = -self.n[1], self.n[0]
        self.e: float = given["contact"].restitution

    def along(self, velocity: "Pair") -> "Pair":
        """Parts of a velocity along and across the line."""
        (a, b), (c, d) = self.n, self.t
        return velocity[0] * a + velocity[1] * b, velocity[0] * c + velocity[1] * d


def _results(m: Meeting, after: "list[Pair]") -> "dict[str, float]":
    """Everything from velocities after: ΔV, impulse and energies as differences."""
    one, two = m.masses
    parts = [(m.along(old), m.along(new)) for old, new in zip(m.before, after, strict=True)]
    (old1, new1), (old2, new2) = parts
    assert one is not None
    results = {
        "impulse": one * (old1[0] - new1[0]),
        "normal_direction": heading_of(*m.n, m.axes),
        "closing_speed": old1[0] - old2[0],
        "separation_speed": new2[0] - new1[0],
        "sliding_speed": abs(old1[1] - old2[1]),
    }
    gains = []
    for name, body, mass, old, new, (_, along) in zip(
        ("first", "second"), m.bodies, m.masses, m.before, after, parts, strict=True
    ):
        results |= state(name, new, m.axes)
        results |= {f"{name}.normal_velocity": along[0], f"{name}.tangential_velocity": along[1]}
        if mass is not None:
            gains.append(kinetic(mass, new) - kinetic(mass, old))
            results[f"{name}.energy_change"] = gains[-1]
            results |= change(name, old, new, body.nose, m.axes, m.zero)
    if two is not None:
        results["energy_lost"] = -sum(gains)
    return results


def by_components(**given: "Any") -> "dict[str, float]":
    """v₁ₙ' = (m₁v₁ₙ + m₂v₂ₙ − m₂e(v₁ₙ − v₂ₙ))/(m₁ + m₂), tangential parts kept; all else as differences."""
    m = Meeting(given)
    (a, s), (b, t) = (m.along(v) for v in m.before)
    one, two = m.masses
    if two is None:
        new = b - m.e * (a - b), b
    else:
        assert one is not None
        new = (
            (one * a + two * b - two * m.e * (a - b)) / (one + two),
            (one * a + two * b + one * m.e * (a - b)) / (one + two),
        )
    after = [
        (along * m.n[0] + across * m.t[0], along * m.n[1] + across * m.t[1])
        for along, across in zip(new, (s, t), strict=True)
    ]
    return _results(m, after)
