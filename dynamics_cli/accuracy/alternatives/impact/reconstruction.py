"""Reconstruction as printed: speeds by Cramer's rule, or by the quadratic of momentum and energy."""

from math import cos, hypot, sin, sqrt

from dynamics_cli.accuracy.alternatives.impact.plane import angle_of, change, heading_of, mass_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def cross_products(*, first: "Any", second: "Any", gravity: float) -> "dict[str, Any]":
    """The program's own: each speed from the parts of momentum across the other's path."""
    from dynamics_cli.impact.reconstruction.momentum_terms import Term, solve

    before = [Term(1.0, car.bulk.mass, None, car.approach_heading, "before") for car in (first, second)]
    after = [Term(-1.0, car.bulk.mass, car.exit_speed, car.exit_heading, "after") for car in (first, second)]
    solve([*before, *after], None)
    return {"first.approach_speed": before[0].speed, "second.approach_speed": before[1].speed}


def by_cramer(*, first: "Any", second: "Any", gravity: float) -> "dict[str, float]":
    """Momentum along x and y as a 2×2 system, by Cramer's rule."""
    both = first, second
    (a, b), (c, d) = ([car.bulk.mass * f(car.approach_heading) for car in both] for f in (cos, sin))
    x, y = (sum(car.bulk.mass * car.exit_speed * f(car.exit_heading) for car in both) for f in (cos, sin))
    whole = a * d - b * c
    return {"first.approach_speed": (x * d - b * y) / whole, "second.approach_speed": (a * y - c * x) / whole}


class Crash:
    """Two vehicles: masses, and for each of the four momenta its speed and mathematical angle, None where unknown."""

    def __init__(self, given: "dict[str, Any]") -> None:
        self.axes: str = given["axes"]
        self.zero: str = given["pdof_zero"]
        self.vehicles = given["first"], given["second"]
        self.masses: list[Any] = [mass_of(car.bulk, given["gravity"]) for car in self.vehicles]
        self.speeds: list[Any] = [car.approach_speed for car in self.vehicles]
        self.speeds += [car.exit_speed for car in self.vehicles]
        headings = [car.approach_heading for car in self.vehicles] + [car.exit_heading for car in self.vehicles]
        self.angles: list[Any] = [
            (0.0 if speed == 0.0 else None) if heading is None else angle_of(heading, self.axes)
            for speed, heading in zip(self.speeds, headings, strict=True)
        ]

    def results(self, line: float) -> "dict[str, float]":
        """Everything once speeds and angles are known: ΔV along a line, impulse, energies as differences."""
        vectors = [(v * cos(a), v * sin(a)) for v, a in zip(self.speeds, self.angles, strict=True)]
        along = [v * cos(a - line) for v, a in zip(self.speeds, self.angles, strict=True)]
        for k, (x, y) in enumerate(vectors[:2]):
            gain = along[k + 2] - along[k]
            vectors[k + 2] = x + gain * cos(line), y + gain * sin(line)
        x, y = (self.masses[0] * (vectors[2][k] - vectors[0][k]) for k in (0, 1))
        total = [sum(m * v[k] for m, v in zip(self.masses, vectors[2:], strict=True)) for k in (0, 1)]
        results = {
            "impulse": hypot(x, y), "impulse_heading": heading_of(x, y, self.axes), "total_momentum": hypot(*total),
            "closing_speed": hypot(vectors[0][0] - vectors[1][0], vectors[0][1] - vectors[1][1]), "energy_lost": 0.0,
            "momentum_heading": heading_of(total[0], total[1], self.axes),
        }  # fmt: skip
        for k, name in enumerate(("first", "second")):
            v, u, m = self.speeds[k], self.speeds[k + 2], self.masses[k]
            before, after = (angle_of(self.angles[k + late], self.axes) for late in (0, 2))
            gain = 0.5 * m * u * u - 0.5 * m * v * v
            results["energy_lost"] -= gain
            results |= {
                f"{name}.approach_speed": v, f"{name}.approach_heading": before, f"{name}.exit_speed": u,
                f"{name}.exit_heading": after, f"{name}.energy_change": gain,
            }  # fmt: skip
            nose = before if self.vehicles[k].nose is None else self.vehicles[k].nose
            results |= change(name, vectors[k], vectors[k + 2], nose, self.axes, self.zero)
        return results


def by_energy(**given: "Any") -> "dict[str, float]":
    """V₂ from momentum put into ½m₁v₁² + ½m₂v₂² = E + ½m₁u₁² + ½m₂u₂²: the larger root for v₁, as taught."""
    c, damage = Crash(given), given["damage"]
    (m1, m2), line = c.masses, c.angles[0]
    u1, u2 = (c.speeds[k] * cos(c.angles[k] - line) for k in (2, 3))
    if hasattr(damage, "first_ees"):
        energy = 0.5 * m1 * damage.first_ees**2 + 0.5 * m2 * damage.second_ees**2
    else:
        energy = damage.first_crush_energy + damage.second_crush_energy
    p, energy = m1 * u1 + m2 * u2, energy + 0.5 * m1 * u1**2 + 0.5 * m2 * u2**2
    a, b, q = m1 * (m1 + m2), -2.0 * m1 * p, p**2 - 2.0 * m2 * energy
    v1 = (-b + sqrt(b**2 - 4.0 * a * q)) / (2.0 * a)
    v2 = (p - m1 * v1) / m2
    c.speeds[0], c.speeds[1] = v1, v2 if cos(c.angles[1] - line) >= 0.0 else -v2
    return c.results(line) | {
        "impulse": abs(m1 * (v1 - u1)), "closing_along_impulse": v1 - v2, "separation_along_impulse": u2 - u1,
        "restitution": (u2 - u1) / (v1 - v2),
    }  # fmt: skip
