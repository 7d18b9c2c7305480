"""Bevels, worms and crossed gears as textbooks print them: by angles, their differences and tan α − α."""

import math

from dynamics_cli.accuracy.alternatives.gear.involute import newton

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Inverse = Callable[[float], dict[str, float]]


def bevel_by_book(
    *, first_teeth: int, second_teeth: int, module: float, shaft_angle: float, kind: str,
    face_width: "float | None" = None, m: "Any" = math, **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """δ₁ = tan⁻¹(sin Σ/(u + cos Σ)), δ₂ = Σ − δ₁, R = d₂/(2·sin δ₂): digits go as δ₂ comes near a flat gear or zero."""
    if first_teeth > second_teeth:
        raise ArithmeticError
    one = m.atan(m.sin(shaft_angle) / (second_teeth / first_teeth + m.cos(shaft_angle)))
    return _bevel((first_teeth, second_teeth), module, (one, shaft_angle - one), kind, face_width, m)


def _bevel(
    teeth: "tuple[int, int]", module: float, angles: "tuple[Any, Any]", kind: str, face: "float | None", m: "Any"
) -> "dict[str, float]":
    """Sizes from both pitch angles; addendum m and dedendum 1.25·m."""
    (one, other), cone = angles, module * teeth[1] / (2 * m.sin(angles[1]))
    out = {
        "cone_distance": cone,
        "first.pitch_angle": one,
        "second.pitch_angle": other,
        "crown_teeth": 2 * cone / module,
    }
    if kind != "standard":
        return out
    rise, tip = m.atan(module / cone), one + m.atan(module / cone)
    out |= {
        "first.tip_angle": tip,
        "second.root_angle": other - m.atan(1.25 * module / cone),
        "second.tip_distance": cone * m.cos(other) - module * m.sin(other),
    }
    if face is not None:
        outer = module * teeth[0] + 2 * module * m.cos(one)
        out |= {
            "mean_module": module * (cone - face / 2) / cone,
            "first.inner_diameter": outer - 2 * face * m.sin(tip) / m.cos(rise),
        }
    return out


def worm_by_book(
    *, threads: int, teeth: int, size: "Any", worm: "Any", pressure_angle: float, profile_shift: float,
    friction: float, torque: "float | None" = None, m: "Any" = math, **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """η = (cos α − μ·tan γ)/(cos α + μ·cot γ), and with −μ the other way: digits go at the limit."""
    out, lead = _worm(threads, teeth, size, worm, profile_shift, m)
    tangent, cosine = m.tan(lead), m.cos(pressure_angle)
    rho = m.atan(friction / cosine)
    out |= {
        "efficiency": (cosine - friction * tangent) / (cosine + friction / tangent),
        "backward_efficiency": (cosine - friction / tangent) / (cosine + friction * tangent),
        "locking_margin": rho - lead,
    }
    if torque is not None:
        push = 2 * torque / worm.worm_diameter
        share = cosine * m.sin(lead) + friction * m.cos(lead)
        axial = push * (cosine * m.cos(lead) - friction * m.sin(lead)) / share
        out |= {"worm_axial_force": axial, "radial_force": push * m.sin(pressure_angle) / share}
    return out


def _worm(
    threads: int, teeth: int, size: "Any", worm: "Any", profile_shift: float, m: "Any"
) -> "tuple[dict[str, float], Any]":
    """Lead angle and centre distance, of worms by axial module and diameter."""
    diameter, module = getattr(worm, "worm_diameter", None), getattr(size, "module", None)
    if diameter is None or module is None:
        raise ArithmeticError
    lead = m.atan(threads * module / diameter)
    distance = (diameter + module * teeth) / 2 + profile_shift * module
    return {"lead_angle": lead, "centre_distance": distance}, lead


def crossed_by_book(*, first: "Any", second: "Any", module: float, pressure_angle: float) -> "dict[str, float]":
    """The working normal angle of the virtual spur gears, z/cos³β teeth each, from tan α − α by Newton."""
    return _crossed(first, second, module, pressure_angle, newton)


def _crossed(first: "Any", second: "Any", module: float, alpha: float, inverse: "Inverse") -> "dict[str, float]":
    """Y = (z_v1 + z_v2)/2·(cos α/cos α_w − 1), a = (d₁ + d₂)/2 + y·m, tan β_w = (d_w/d)·tan β, Σ = β_w1 + β_w2."""
    virtual = sum(one.teeth / math.cos(one.helix_angle) ** 3 for one in (first, second))
    shift = first.profile_shift + second.profile_shift
    working = inverse(2 * math.tan(alpha) * shift / virtual + math.tan(alpha) - alpha)["phi"]
    more = virtual / 2 * (math.cos(alpha) / math.cos(working) - 1)
    reference = sum(one.teeth * module / (2 * math.cos(one.helix_angle)) for one in (first, second))
    distance = reference + more * module
    helices = [math.atan(distance / reference * math.tan(one.helix_angle)) for one in (first, second)]
    return {
        "working_pressure_angle": working,
        "distance_modification": more,
        "centre_distance": distance,
        "first_working_helix": helices[0],
        "shaft_angle": abs(helices[0] + helices[1]),
    }
