"""Momentum before a crash by components along x and y, and by a solver for two unknowns; all else as differences."""

from math import atan2, cos, hypot, pi, sin, sqrt, tan

from dynamics_cli.accuracy.alternatives.impact.plane import angle_of, change, heading_of, mass_of, polar

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.accuracy.alternatives.impact.plane import Pair


class Crash:
    """Two vehicles: masses, and for each of the four momenta its speed and mathematical angle, None where unknown."""

    def __init__(self, given: "dict[str, Any]") -> None:
        self.axes: str = given["axes"]
        self.zero: str = given["pdof_zero"]
        self.vehicles = given["first"], given["second"]
        masses = [mass_of(one.bulk, given["gravity"]) for one in self.vehicles]
        self.masses: list[float] = [mass for mass in masses if mass is not None]
        self.speeds: list[Any] = [one.approach_speed for one in self.vehicles]
        self.speeds += [one.exit_speed for one in self.vehicles]
        headings = [one.approach_heading for one in self.vehicles] + [one.exit_heading for one in self.vehicles]
        self.angles: list[Any] = [
            (0.0 if speed == 0.0 else None) if heading is None else angle_of(heading, self.axes)
            for speed, heading in zip(self.speeds, headings, strict=True)
        ]

    def amount(self, k: int) -> float:
        """Mass of momentum k in the equation, negative after the impact."""
        return self.masses[k % 2] * (1.0 if k < 2 else -1.0)

    def rest(self) -> "Pair":
        """The sum of the momenta that are known, along x and y."""
        known = [k for k in range(4) if self.speeds[k] is not None and self.angles[k] is not None]
        parts = [(self.amount(k) * self.speeds[k], self.angles[k]) for k in known]
        return sum(p * cos(a) for p, a in parts), sum(p * sin(a) for p, a in parts)

    def closing(self, k: int) -> float:
        """The angle of momentum k that closes the sum of the others."""
        x, y = self.rest()
        return atan2(-y / self.amount(k), -x / self.amount(k))


def _results(c: Crash) -> "dict[str, float]":
    """Everything once all speeds and angles are known: ΔV, impulse and energies as differences."""
    vectors = [(v * cos(a), v * sin(a)) for v, a in zip(c.speeds, c.angles, strict=True)]
    headings = [angle_of(a, c.axes) for a in c.angles]
    x, y = (c.masses[0] * (vectors[2][k] - vectors[0][k]) for k in (0, 1))
    before = vectors[0][0] - vectors[1][0], vectors[0][1] - vectors[1][1]
    after = vectors[2][0] - vectors[3][0], vectors[2][1] - vectors[3][1]
    size = hypot(x, y)
    closing, parting = -(before[0] * x + before[1] * y) / size, (after[0] * x + after[1] * y) / size
    total = [sum(m * v[k] for m, v in zip(c.masses, vectors[2:], strict=True)) for k in (0, 1)]
    results = {
        "impulse": size, "impulse_heading": heading_of(x, y, c.axes), "closing_speed": hypot(*before),
        "closing_along_impulse": closing, "separation_along_impulse": parting, "restitution": parting / closing,
        "total_momentum": hypot(*total), "momentum_heading": heading_of(total[0], total[1], c.axes),
    }  # fmt: skip
    lost = 0.0
    for k, name in enumerate(("first", "second")):
        v, u, m = c.speeds[k], c.speeds[k + 2], c.masses[k]
        gain = 0.5 * m * u * u - 0.5 * m * v * v
        lost -= gain
        results |= {
            f"{name}.approach_speed": v, f"{name}.approach_heading": headings[k], f"{name}.exit_speed": u,
            f"{name}.exit_heading": headings[k + 2], f"{name}.energy_change": gain,
        }  # fmt: skip
        nose = headings[k] if c.vehicles[k].nose is None else c.vehicles[k].nose
        results |= change(name, vectors[k], vectors[k + 2], nose, c.axes, c.zero)
    return results | {"energy_lost": lost}


def _condition(one: float, other: float) -> float:
    """Cot of half the angle between two lines."""
    apart = abs(one - other) % pi
    return 1.0 / tan(0.5 * min(apart, pi - apart))


def by_components(**given: "Any") -> "dict[str, float]":
    """M₁v₁·cos α₁ + m₂v₂·cos α₂ = …, and with sines: two speeds by Cramer's rule, a lost vector as what is left."""
    c = Crash(given)
    speeds = [k for k in range(4) if c.speeds[k] is None]
    angles = [k for k in range(4) if c.angles[k] is None]
    x, y = c.rest()
    results: dict[str, float] = {}
    if len(speeds) == 2 and not angles:
        i, j = speeds
        (a, b), (p, q) = ([c.amount(k) * f(c.angles[k]) for k in speeds] for f in (cos, sin))
        whole = a * q - b * p
        c.speeds[i], c.speeds[j] = (b * y - q * x) / whole, (p * x - a * y) / whole
        results["angle_condition"] = _condition(c.angles[i], c.angles[j])
    elif len(speeds) == 1 and speeds == angles:
        k = speeds[0]
        c.speeds[k] = hypot(x, y) / c.masses[k % 2]
        c.angles[k] = c.closing(k)
    elif len(speeds) == 1 and len(angles) == 1:
        i, j = speeds[0], angles[0]
        along, reach = x * cos(c.angles[i]) + y * sin(c.angles[i]), c.amount(j) * c.speeds[j]
        # a²·v² + 2·a·v·(p·d) + p² = q²
        root = sqrt(along**2 - (x**2 + y**2) + reach**2)
        c.speeds[i] = max((-along + root) / c.amount(i), (-along - root) / c.amount(i))
        c.angles[j] = c.closing(j)
    else:
        raise ArithmeticError
    return _results(c) | results


class Line:
    """Vehicles on one line: speeds after along it, energies, and which way the second moves."""

    def __init__(self, given: "dict[str, Any]") -> None:
        self.crash = c = Crash(given)
        damage = given["damage"]
        if hasattr(damage, "first_ees"):
            self.damage = 0.5 * c.masses[0] * damage.first_ees**2 + 0.5 * c.masses[1] * damage.second_ees**2
        else:
            self.damage = damage.first_crush_energy + damage.second_crush_energy
        self.line = c.angles[0]
        self.sense = 1.0 if cos(c.angles[1] - self.line) >= 0.0 else -1.0
        self.after = [c.speeds[k] * cos(c.angles[k] - self.line) for k in (2, 3)]

    def results(self, v1: float, v2: float) -> "dict[str, float]":
        """Everything from velocities before along the line."""
        c, (u1, u2) = self.crash, self.after
        c.speeds[0], c.speeds[1] = v1, self.sense * v2
        results = _results(c)
        (m1, m2), way = c.masses, (cos(self.line), sin(self.line))
        size = m1 * v1 - m1 * u1
        results |= {
            "impulse": abs(size), "closing_along_impulse": v1 - v2, "separation_along_impulse": u2 - u1,
            "restitution": (u2 - u1) / (v1 - v2), "impulse_heading": heading_of(-size * way[0], -size * way[1], c.axes),
            "energy_lost": 0.5 * m1 * (v1**2 - u1**2) + 0.5 * m2 * (v2**2 - u2**2),
        }  # fmt: skip
        for k, (name, v, u) in enumerate((("first", v1, u1), ("second", v2, u2))):
            old = polar(c.speeds[k], angle_of(c.angles[k], c.axes), c.axes)
            new = old[0] + (u - v) * way[0], old[1] + (u - v) * way[1]
            nose = angle_of(c.angles[k], c.axes) if c.vehicles[k].nose is None else c.vehicles[k].nose
            results |= change(name, old, new, nose, c.axes, c.zero)
        return results


def energy_by_quadratic(**given: "Any") -> "dict[str, float]":
    """V₂ from momentum put into ½m₁v₁² + ½m₂v₂² = E + ½m₁u₁² + ½m₂u₂²: the larger root for v₁, as taught."""
    one = Line(given)
    (m1, m2), (u1, u2) = one.crash.masses, one.after
    p, energy = m1 * u1 + m2 * u2, one.damage + 0.5 * m1 * u1**2 + 0.5 * m2 * u2**2
    a, b, c = m1 * (m1 + m2), -2.0 * m1 * p, p**2 - 2.0 * m2 * energy
    v1 = (-b + sqrt(b**2 - 4.0 * a * c)) / (2.0 * a)
    return one.results(v1, (p - m1 * v1) / m2)
