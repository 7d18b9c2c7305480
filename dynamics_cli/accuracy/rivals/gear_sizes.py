"""Sizes of gears as textbooks print them: bevels by angles, worms by efficiencies, spans and pins by tan α − α."""

import math

from dynamics_cli.accuracy.rivals.gear_involute import newton
from dynamics_cli.accuracy.rivals.single import DOUBLES, single

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def bevel_by_book(
    *, first_teeth: int, second_teeth: int, module: float, shaft_angle: float, kind: str,
    face_width: "float | None" = None, m: "Any" = DOUBLES, **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """δ₁ = tan⁻¹(sin Σ/(u + cos Σ)), δ₂ = Σ − δ₁, R = d₂/(2·sin δ₂): digits go as δ₂ comes near a flat gear or zero."""
    if first_teeth > second_teeth:
        raise ArithmeticError
    one = m.atan(m.sin(shaft_angle) / (second_teeth / first_teeth + m.cos(shaft_angle)))
    other = shaft_angle - one
    cone = module * second_teeth / (2 * m.sin(other))
    out = {
        "cone_distance": cone,
        "first.pitch_angle": one,
        "second.pitch_angle": other,
        "crown_teeth": 2 * cone / module,
    }
    if face_width is not None:
        out["mean_module"] = module * (cone - face_width / 2) / cone
    return out


def worm_by_book(
    *, threads: int, teeth: int, size: "Any", worm: "Any", pressure_angle: float, profile_shift: float,
    friction: float, m: "Any" = DOUBLES, **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """η = (cos α − μ·tan γ)/(cos α + μ·cot γ), and with −μ the other way: digits go at the limit."""
    diameter = getattr(worm, "worm_diameter", None)
    module = getattr(size, "module", None)
    if diameter is None or module is None:
        raise ArithmeticError
    lead = m.atan(threads * module / diameter)
    tangent, cosine = m.tan(lead), m.cos(pressure_angle)
    return {
        "lead_angle": lead,
        "centre_distance": (diameter + module * teeth) / 2 + profile_shift * module,
        "efficiency": (cosine - friction * tangent) / (cosine + friction / tangent),
        "backward_efficiency": (cosine - friction / tangent) / (cosine + friction * tangent),
    }


def crossed_by_book(
    *, first: "Any", second: "Any", module: float, pressure_angle: float, m: "Any" = DOUBLES, **_: "Any"
) -> "dict[str, float]":
    """The working normal angle of the virtual spur gears, z/cos³β teeth each, from tan α − α by Newton."""
    virtual = [one.teeth / m.cos(one.helix_angle) ** 3 for one in (first, second)]
    slope = m.tan(pressure_angle)
    shift = first.profile_shift + second.profile_shift
    involute = 2 * slope * shift / (virtual[0] + virtual[1]) + slope - pressure_angle
    return {"working_pressure_angle": newton(float(involute))["phi"]}


def span_by_book(
    *, teeth: int, module: float, pressure_angle: float, helix_angle: float, profile_shift: float, internal: bool,
    over: int = 0, pin: "float | None" = None, tip_diameter: "float | None" = None, m: "Any" = DOUBLES, **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """W = m·cos α·(π·(k − ½) + z·(tan α_t − α_t)) + 2·x·m·sin α, pins by Newton on the involute; external gears."""
    if internal or pin is None:
        raise ArithmeticError
    transverse = m.atan(m.tan(pressure_angle) / m.cos(helix_angle))
    involute = m.tan(transverse) - transverse
    sine, cosine = m.sin(pressure_angle), m.cos(pressure_angle)
    thickness = module * (math.pi / 2 + 2 * profile_shift * m.tan(pressure_angle))
    out = {
        "normal_thickness": thickness,
        "constant_chord.thickness": thickness * cosine * cosine,
        "pins.centre_diameter": _pin_circle(
            teeth, module, pressure_angle, helix_angle, profile_shift, pin, involute, transverse, m
        ),
    }
    if over:
        whole = math.pi * (over - 0.5) + teeth * involute
        out["span.span"] = module * cosine * whole + 2 * profile_shift * module * sine
    return out


def _pin_circle(
    teeth: int, module: float, pressure_angle: float, helix_angle: float, shift: float, pin: float, involute: float,
    transverse: float, m: "Any",
) -> float:  # fmt: skip
    cosine, tangent = m.cos(pressure_angle), m.tan(pressure_angle)
    at = pin / (module * teeth * cosine) - math.pi / (2 * teeth) + involute + 2 * shift * tangent / teeth
    return teeth * module / m.cos(helix_angle) * m.cos(transverse) / m.cos(newton(float(at))["phi"])  # type: ignore[no-any-return]


bevel_single = single(bevel_by_book)
worm_single = single(worm_by_book)
