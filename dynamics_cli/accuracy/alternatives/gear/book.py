"""Gears and pairs as textbooks calculate them: tan α − α, arc cosines, differences of squares; z < 0 is internal."""

from math import acos, asin, atan, cos, pi, sin, sqrt, tan

from dynamics_cli.accuracy.alternatives.gear.involute import newton

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Function = Callable[[float], float]
    Crossing = Callable[[Function, float], float]

# Basic rack A of ISO 53: addendum, dedendum and corner.
ADDENDUM, DEDENDUM, CORNER = 1.0, 1.25, 0.38


def involute(angle: float) -> float:
    """The involute function as it is defined."""
    return tan(angle) - angle


def spur(
    *, teeth: int, pitch: "Any", pressure_angle: float, profile_shift: float, internal: bool,
    helix_angle: "float | None" = None, inv: "Function" = involute, crossing: "Crossing | None" = None,
) -> "dict[str, float]":  # fmt: skip
    """s_a = d_a·((π/2 + 2·x·tan α)/z + inv α_t − inv α_a) with cos α_a = d_b/d_a; where it vanishes by iteration."""
    z, beta, x = (-teeth if internal else teeth), helix_angle or 0.0, profile_shift
    module, slope = pitch.module, tan(pressure_angle)
    transverse = atan(slope / cos(beta))
    reference = z * module / cos(beta)
    base = reference * cos(transverse)
    tip = reference + 2.0 * module * (ADDENDUM + x)
    angle = acos(base / tip)
    results = {
        "reference_diameter": abs(reference), "base_diameter": abs(base), "tip_diameter": abs(tip),
        "root_diameter": abs(reference - 2.0 * module * (DEDENDUM - x)), "tip_pressure_angle": angle,
        "tip_thickness": tip * ((0.5 * pi + 2.0 * x * slope) / z + inv(transverse) - inv(angle)),
        "normal_thickness": module * (0.5 * pi + 2.0 * x * slope),
    }  # fmt: skip
    if not internal:

        def half(shift: float) -> float:
            outer = acos(min(base / (reference + 2.0 * module * (ADDENDUM + shift)), 1.0))
            return (0.5 * pi + 2.0 * shift * slope) / z + inv(transverse) - inv(outer)

        results["least_shift"] = (
            DEDENDUM - CORNER * (1.0 - sin(pressure_angle)) - z * sin(transverse) ** 2 / (2.0 * cos(beta))
        )
        results["pointed_shift"] = (crossing or by_secants)(half, -ADDENDUM)
    if helix_angle is not None:
        base_helix = asin(sin(beta) * cos(pressure_angle))
        results |= {
            "transverse_pressure_angle": transverse, "base_helix_angle": base_helix,
            "normal_base_pitch": pi * module * cos(pressure_angle),
            "virtual_teeth": z / (cos(base_helix) ** 2 * cos(beta)), "lead": pi * reference / tan(beta),
        }  # fmt: skip
    return results


def by_secants(f: "Function", low: float) -> float:
    """Where the teeth are pointed: by the secant of two guesses as long as it moves."""
    high = low + 1.0
    while f(high) > 0.0:
        low, high = high, high + 1.0
    a, b = f(low), f(high)
    for _ in range(100):
        if a == b:
            break
        low, high, a = high, high - b * (high - low) / (b - a), b
        b = f(high)
        if abs(high - low) <= 4e-16 * abs(high):
            break
    return high


def pair(
    *, first: "Any", second: "Any", pitch: "Any", pressure_angle: float, helix_angle: float, internal: bool, tips: str,
    centre_distance: "float | None" = None, inv: "Function" = involute, inverse: "Function | None" = None,
) -> "dict[str, float]":  # fmt: skip
    """Inv α_w = inv α_t + 2·(x₁ + x₂)·tan α/(z₁ + z₂) by Newton, a = a_d·cos α_t/cos α_w; the path of contact from
    √(r_a² − r_b²) and a·sin α_w, its ends' sliding from the radii of curvature there.
    """  # noqa: D205
    module, transverse = pitch.module, atan(tan(pressure_angle) / cos(helix_angle))
    z = first.teeth, (-second.teeth if internal else second.teeth)
    x = first.profile_shift, second.profile_shift
    value = inv(transverse) + 2.0 * sum(x) * tan(pressure_angle) / sum(z)
    reference = 0.5 * module * sum(z) / cos(helix_angle)
    tight = inverse(value) if inverse else newton(value)["phi"]
    distance, angle, backlash = reference * cos(transverse) / cos(tight), tight, 0.0
    if centre_distance is not None:
        distance = -centre_distance if internal else centre_distance
        angle = acos(reference * cos(transverse) / distance)
        backlash = 2.0 * distance * (inv(angle) - inv(tight))
    lift = (distance - reference) / module - sum(x) if tips == "clearance" else 0.0
    outer = [0.5 * n * module / cos(helix_angle) + module * (ADDENDUM + s + lift) for n, s in zip(z, x, strict=True)]
    base = [0.5 * n * module / cos(helix_angle) * cos(transverse) for n in z]
    line = distance * sin(angle)
    # radii of curvature at the tips, negative inside a ring
    ends = [sqrt(a**2 - b**2) * (1.0 if n > 0 else -1.0) for n, a, b in zip(z, outer, base, strict=True)]
    start, stop = line - ends[1], ends[0]
    other = line - stop
    return {
        "working_pressure_angle": angle,
        "centre_distance": abs(distance),
        "first_working_diameter": 2.0 * base[0] / cos(angle),
        "first_tip_diameter": 2.0 * abs(outer[0]),
        "second_tip_diameter": 2.0 * abs(outer[1]),
        "nominal": (stop - start) / (pi * module / cos(helix_angle) * cos(transverse)),
        "recess_length": stop - base[0] * tan(angle),
        "first_sliding_at_start": 1.0 - z[0] * ends[1] / (z[1] * start),
        "second_sliding_at_end": 1.0 - z[1] * stop / (z[0] * other),
        "circumferential_backlash": backlash,
    }
