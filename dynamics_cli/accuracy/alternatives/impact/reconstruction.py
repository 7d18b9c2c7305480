"""Reconstruction as printed: momentum by components, crush energy by sums over stations, yaw inertia by gyration."""

from itertools import pairwise
from math import atan2, cos, hypot, pi, sin, sqrt, tan

from dynamics_cli.accuracy.alternatives.impact.plane import angle_of, change, heading_of, mass_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Pair = tuple[float, float]


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

    def amount(self, k: int) -> float:
        """Mass of momentum k in the equation, negative after the impact."""
        return self.masses[k % 2] * (1.0 if k < 2 else -1.0)  # type: ignore[no-any-return]

    def rest(self) -> "Pair":
        """The sum of the momenta that are known, along x and y."""
        known = [k for k in range(4) if self.speeds[k] is not None and self.angles[k] is not None]
        parts = [(self.amount(k) * self.speeds[k], self.angles[k]) for k in known]
        return sum(p * cos(a) for p, a in parts), sum(p * sin(a) for p, a in parts)

    def closing(self, k: int) -> float:
        """The angle of momentum k that closes the sum of the others."""
        x, y = self.rest()
        return atan2(-y / self.amount(k), -x / self.amount(k))

    def results(self, line: "float | None" = None) -> "dict[str, float]":
        """Everything once speeds and angles are known: ΔV (along a line, if any), impulse, energies as differences."""
        vectors = [(v * cos(a), v * sin(a)) for v, a in zip(self.speeds, self.angles, strict=True)]
        if line is not None:
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
        apart = abs(c.angles[i] - c.angles[j]) % pi
        results["angle_condition"] = 1.0 / tan(0.5 * min(apart, pi - apart))
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
    return c.results() | results


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


def _stiffness(given: "Any") -> "Pair":
    """A = m·b₀·b₁/w, B = m·b₁²/w, b₁ = (v − b₀)/C of one test."""
    if hasattr(given, "stiffness_a"):
        return given.stiffness_a, given.stiffness_b
    slope = given.speed_slope if hasattr(given, "speed_slope") else (
        given.test_speed - given.no_damage_speed
    ) / given.test_crush  # fmt: skip
    first = given.test_mass * given.no_damage_speed * slope / given.test_width
    return first, given.test_mass * slope**2 / given.test_width


def _damage(vehicle: "Any", mass: float) -> "dict[str, float]":
    """E = w·[A/2·(C₁ + 2C₂ + … + Cₙ) + B/6·(C₁² + 2C₂² + … + C₁C₂ + …)]/(n − 1) + w·A²/2B, times 1 + tan²α.

    EBS = √(2E/m), effective mass m·k²/(k² + h²).
    """
    (a, b), profile, width = _stiffness(vehicle.stiffness), vehicle.profile, vehicle.profile.width
    c = profile.stations if hasattr(profile, "stations") else (profile.mean_crush, profile.mean_crush)
    pieces = len(c) - 1
    depths = c[0] + 2.0 * sum(c[1:-1]) + c[-1]
    squares = c[0] ** 2 + 2.0 * sum(x**2 for x in c[1:-1]) + c[-1] ** 2 + sum(x * y for x, y in pairwise(c))
    normal = width * ((0.5 * a * depths + b / 6.0 * squares) / pieces + a**2 / (2.0 * b))
    energy = normal * (1.0 + tan(vehicle.force_angle) ** 2)
    lever = vehicle.lever_arm or 0.0
    if vehicle.offset is not None:
        away = vehicle.face_distance or 0.0
        lever = vehicle.offset * cos(vehicle.force_angle) - away * sin(vehicle.force_angle)
    k2 = vehicle.yaw_inertia / mass if lever else 1.0
    return {
        "energy": energy, "energy_normal": normal, "equivalent_barrier_speed": sqrt(2.0 * energy / mass),
        "force": width * (a + 0.5 * b * depths / pieces), "stiffness_a": a, "stiffness_b": b,
        "stiffness_g": a**2 / (2.0 * b), "mean_crush": 0.5 * depths / pieces,
        "effective_mass": mass * k2 / (k2 + lever**2),
    }  # fmt: skip


def crush(*, first: "Any", restitution: float, gravity: float, second: "Any" = None) -> "dict[str, float]":
    """CRASH3's sum over stations; closing speed u = √(2E/(m_r·(1 − e²))), p = m_r·(1 + e)·u, ΔV = p/m."""
    mass = mass_of(first.bulk, gravity)
    assert mass is not None
    results = {f"first.{key}": value for key, value in _damage(first, mass).items()}
    results["energy"] = results["first.energy"]
    if second is None:
        return results
    other = mass_of(second.bulk, gravity)
    reduced = results["first.effective_mass"]
    if other is not None:
        partner = other
        if second.profile is not None:
            results |= {f"second.{key}": value for key, value in _damage(second, other).items()}
            results["energy"] += results["second.energy"]
            partner = results["second.effective_mass"]
        reduced = reduced * partner / (reduced + partner)
    closing = sqrt(2.0 * results["energy"] / (reduced * (1.0 - restitution**2)))
    push = reduced * (1.0 + restitution) * closing
    results |= {"closing_speed": closing, "impulse": push, "first.delta_v": push / mass}
    if other is not None:
        results["second_delta_v" if second.profile is None else "second.delta_v"] = push / other
    return results


def yaw_inertia(
    *, bulk: "Any", wheelbase: float, rule: str, gravity: float, length: "float | None" = None,
    width: "float | None" = None, front_distance: "float | None" = None,
) -> "dict[str, float]":  # fmt: skip
    """Every rule as a radius of gyration, k = √(a·b), √(0.1269·L·R), √((L² + B²)/12), and J = m·k²."""
    mass = mass_of(bulk, gravity)
    front = wheelbase / 2 if front_distance is None else front_distance
    radii = {"dynamic-index": sqrt(front * (wheelbase - front))}
    if length is not None:
        radii = {"burg": sqrt(0.1269 * length * wheelbase)} | radii
        if width is not None:
            radii["rectangle"] = sqrt((length**2 + width**2) / 12)
    moments = {name: mass * radius**2 for name, radius in radii.items()}  # type: ignore[operator]
    estimate = sum(moments.values()) / len(moments) if rule == "mean" else moments[rule]
    results = {f"rules[{k}].yaw_inertia": value for k, value in enumerate(moments.values())}
    return results | {"yaw_inertia": estimate, "radius_of_gyration": sqrt(estimate / mass)}  # type: ignore[operator]
