"""Bevels, worms and crossed gears as textbooks print them: by angles, their differences and tan α − α."""

from math import atan, cos, sin, tan
from typing import Any

from dynamics_cli.accuracy.alternatives.gear.involute import newton


def bevel(
    *, first_teeth: int, second_teeth: int, module: float, shaft_angle: float, kind: str, **_: "Any"
) -> "dict[str, float]":
    """δ₁ = tan⁻¹(sin Σ/(u + cos Σ)), δ₂ = Σ − δ₁, R = d₂/(2·sin δ₂): digits go as δ₂ comes near a flat gear or zero."""
    if first_teeth > second_teeth:
        raise ArithmeticError
    one = atan(sin(shaft_angle) / (second_teeth / first_teeth + cos(shaft_angle)))
    two = shaft_angle - one
    cone = module * second_teeth / (2 * sin(two))
    results = {
        "cone_distance": cone, "first.pitch_angle": one, "second.pitch_angle": two, "crown_teeth": 2 * cone / module,
    }  # fmt: skip
    if kind == "standard":
        results |= {
            "first.tip_angle": one + atan(module / cone), "second.root_angle": two - atan(1.25 * module / cone),
            "second.tip_distance": cone * cos(two) - module * sin(two),
        }  # fmt: skip
    return results


def worm(
    *, threads: int, teeth: int, size: "Any", worm: "Any", pressure_angle: float, profile_shift: float,
    friction: float, torque: "float | None" = None, **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """η = (cos α − μ·tan γ)/(cos α + μ·cot γ), and with −μ the other way: digits go at the limit."""
    diameter, module = getattr(worm, "worm_diameter", None), getattr(size, "module", None)
    if diameter is None or module is None:
        raise ArithmeticError
    lead = atan(threads * module / diameter)
    tangent, cosine = tan(lead), cos(pressure_angle)
    results = {
        "lead_angle": lead, "centre_distance": (diameter + module * teeth) / 2 + profile_shift * module,
        "efficiency": (cosine - friction * tangent) / (cosine + friction / tangent),
        "backward_efficiency": (cosine - friction / tangent) / (cosine + friction * tangent),
        "locking_margin": atan(friction / cosine) - lead,
    }  # fmt: skip
    if torque is not None:
        push = 2 * torque / diameter / (cosine * sin(lead) + friction * cos(lead))
        results |= {
            "worm_axial_force": push * (cosine * cos(lead) - friction * sin(lead)),
            "radial_force": push * sin(pressure_angle),
        }
    return results


def crossed(*, first: "Any", second: "Any", module: float, pressure_angle: float) -> "dict[str, float]":
    """The working normal angle of the virtual spur gears, z/cos³β teeth each, from tan α − α by Newton.

    Y = (z_v1 + z_v2)/2·(cos α/cos α_w − 1), a = (d₁ + d₂)/2 + y·m, tan β_w = (d_w/d)·tan β, Σ = β_w1 + β_w2.
    """
    gears = first, second
    virtual = sum(gear.teeth / cos(gear.helix_angle) ** 3 for gear in gears)
    shift = first.profile_shift + second.profile_shift
    working = newton(2 * tan(pressure_angle) * shift / virtual + tan(pressure_angle) - pressure_angle)["phi"]
    more = virtual / 2 * (cos(pressure_angle) / cos(working) - 1)
    reference = sum(gear.teeth * module / (2 * cos(gear.helix_angle)) for gear in gears)
    distance = reference + more * module
    helices = [atan(distance / reference * tan(gear.helix_angle)) for gear in gears]
    return {
        "working_pressure_angle": working, "distance_modification": more, "centre_distance": distance,
        "first_working_helix": helices[0], "shaft_angle": abs(sum(helices)),
    }  # fmt: skip
