"""Crush and yaw inertia: formulas as printed, the force summed over the face, mean depths, radii of gyration."""

from itertools import pairwise
from math import cos, sin, sqrt, tan

from dynamics_cli.accuracy.alternatives.impact.plane import mass_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


def _stiffness(given: "Any") -> "tuple[float, float]":
    """A = m·b₀·b₁/w, B = m·b₁²/w, b₁ = (v − b₀)/C of one test."""
    if hasattr(given, "stiffness_a"):
        return given.stiffness_a, given.stiffness_b
    slope = given.speed_slope if hasattr(given, "speed_slope") else (
        given.test_speed - given.no_damage_speed
    ) / given.test_crush  # fmt: skip
    first = given.test_mass * given.no_damage_speed * slope / given.test_width
    return first, given.test_mass * slope**2 / given.test_width


def _depths(profile: "Any") -> "tuple[float, ...]":
    if hasattr(profile, "stations"):
        return tuple(profile.stations)
    return profile.mean_crush, profile.mean_crush


def printed(depths: "tuple[float, ...]", a: float, b: float) -> float:
    """Energy per width, [A/2·(C₁ + 2C₂ + … + Cₙ) + B/6·(C₁² + 2C₂² + … + C₁C₂ + …)]/(n − 1) + A²/2B."""
    pieces = len(depths) - 1
    first = depths[0] + 2.0 * sum(depths[1:-1]) + depths[-1]
    squares = depths[0] ** 2 + 2.0 * sum(c**2 for c in depths[1:-1]) + depths[-1] ** 2
    products = sum(c * d for c, d in pairwise(depths))
    return (0.5 * a * first + b / 6.0 * (squares + products)) / pieces + a**2 / (2.0 * b)


def _damage(
    name: str, vehicle: "Any", mass: float, energy: "Callable[[tuple[float, ...], float, float], float]"
) -> "dict[str, float]":
    """E·(1 + tan²α), EBS = √(2E/m), effective mass m·k²/(k² + h²)."""
    a, b = _stiffness(vehicle.stiffness)
    depths, width = _depths(vehicle.profile), vehicle.profile.width
    normal = width * energy(depths, a, b)
    whole = normal * (1.0 + tan(vehicle.force_angle) ** 2)
    pieces = len(depths) - 1
    middle = (0.5 * (depths[0] + depths[-1]) + sum(depths[1:-1])) / pieces
    lever = vehicle.lever_arm or 0.0
    if vehicle.offset is not None:
        away = vehicle.face_distance or 0.0
        lever = vehicle.offset * cos(vehicle.force_angle) - away * sin(vehicle.force_angle)
    share = 1.0
    if lever:
        k2 = vehicle.yaw_inertia / mass
        share = k2 / (k2 + lever**2)
    results = {
        "energy": whole, "energy_normal": normal, "equivalent_barrier_speed": sqrt(2.0 * whole / mass),
        "force": width * (a + b * middle), "stiffness_a": a, "stiffness_b": b, "stiffness_g": a**2 / (2.0 * b),
        "mean_crush": middle, "mass": mass, "effective_mass": mass * share, "effective_share": share,
    }  # fmt: skip
    if hasattr(vehicle.profile, "stations"):
        moment = sum(
            (k + (c + 2.0 * d) / (3.0 * (c + d))) * 0.5 * (c + d) if c + d else 0.0
            for k, (c, d) in enumerate(pairwise(depths))
        )
        results["crush_centre"] = width * moment / (pieces * (pieces * middle))
    return {f"{name}.{key}": value for key, value in results.items()}


def _crush(
    energy: "Callable[[tuple[float, ...], float, float], float]", first: "Any", second: "Any", e: float, gravity: float
) -> "dict[str, float]":
    """Closing speed u = √(2E/(m_r·(1 − e²))), p = m_r·(1 + e)·u, ΔV = p/m."""
    mass = mass_of(first.bulk, gravity)
    assert mass is not None
    results = _damage("first", first, mass, energy)
    results["energy"] = results["first.energy"]
    if second is None:
        return results
    other = mass_of(second.bulk, gravity)
    reduced = results["first.effective_mass"]
    if other is not None:
        partner = other
        if second.profile is not None:
            results |= _damage("second", second, other, energy)
            results["energy"] += results["second.energy"]
            partner = results["second.effective_mass"]
        reduced = reduced * partner / (reduced + partner)
    closing = sqrt(2.0 * results["energy"] / (reduced * (1.0 - e**2)))
    push = reduced * (1.0 + e) * closing
    results |= {"closing_speed": closing, "impulse": push, "first.delta_v": push / mass}
    if other is not None:
        results["second_delta_v" if second.profile is None else "second.delta_v"] = push / other
    return results


def crush_as_printed(*, first: "Any", restitution: float, gravity: float, second: "Any" = None) -> "dict[str, float]":
    """The sum over stations as CRASH3's formula for two to six of them, for any number."""
    return _crush(printed, first, second, restitution, gravity)


def yaw_by_gyration(
    *, bulk: "Any", wheelbase: float, rule: str, gravity: float, length: "float | None" = None,
    width: "float | None" = None, front_distance: "float | None" = None, m: "Any" = None,
) -> "dict[str, float]":  # fmt: skip
    """Every rule as a radius of gyration, k = √(a·b), √(0.1269·L·R), √((L² + B²)/12), and J = m·k²."""
    root = m.sqrt if m else sqrt
    mass = bulk.mass if hasattr(bulk, "mass") else bulk.weight / gravity
    front = wheelbase / 2 if front_distance is None else front_distance
    radii = {"dynamic-index": root(front * (wheelbase - front))}
    if length is not None:
        radii = {"burg": root(0.1269 * length * wheelbase)} | radii
        if width is not None:
            radii["rectangle"] = root((length**2 + width**2) / 12)
    moments = {name: mass * radius**2 for name, radius in radii.items()}
    every = [*moments.values(), 0.7 * moments["dynamic-index"], 1.1 * moments["dynamic-index"]]
    values = list(moments.values())
    estimate = sum(values[1:], values[0]) / len(values) if rule == "mean" else moments[rule]
    results = {f"rules[{k}].yaw_inertia": value for k, value in enumerate(values)}
    return results | {
        "yaw_inertia": estimate, "lowest": min(every), "highest": max(every), "mass": mass,
        "radius_of_gyration": root(estimate / mass),
    }  # fmt: skip
