"""Gears, pairs, measurements and profiles as handbooks calculate them: tan α − α, arc cosines, differences."""

from math import acos, asin, atan, cos, pi, sin, sqrt, tan

from dynamics_cli.accuracy.alternatives.gear.involute import newton

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Function = Callable[[float], float]
    Inverse = Callable[[float], dict[str, float]]

# Basic rack A of ISO 53: addendum, dedendum and corner.
ADDENDUM, DEDENDUM, CORNER = 1.0, 1.25, 0.38


def involute(angle: float) -> float:
    """The involute function as it is defined."""
    return tan(angle) - angle


class Toothing:
    """A toothing by its angles; of an internal gear teeth and diameters are negative."""

    def __init__(
        self, teeth: int, module: float, alpha: float, beta: "float | None", shift: float, *, internal: bool = False
    ) -> None:
        self.teeth = -teeth if internal else teeth
        self.module, self.alpha, self.beta, self.shift = module, alpha, beta or 0.0, shift
        self.transverse = atan(tan(alpha) / cos(self.beta))
        self.reference = self.teeth * module / cos(self.beta)
        self.base = self.reference * cos(self.transverse)
        self.tip = self.reference + 2.0 * module * (ADDENDUM + shift)
        self.root = self.reference - 2.0 * module * (DEDENDUM - shift)
        self.thickness = module * (0.5 * pi + 2.0 * shift * tan(alpha))

    def half(self, diameter: float) -> float:
        """Half of the tooth's angle at a diameter."""
        angle = acos(min(self.base / diameter, 1.0))
        start = (0.5 * pi + 2.0 * self.shift * tan(self.alpha)) / self.teeth
        return start + involute(self.transverse) - involute(angle)


def spur(
    *, teeth: int, pitch: "Any", pressure_angle: float, profile_shift: float, internal: bool,
    helix_angle: "float | None" = None,
) -> "dict[str, float]":  # fmt: skip
    """s_a = d_a·((π/2 + 2·x·tan α)/z + inv α_t − inv α_a) with cos α_a = d_b/d_a; where it vanishes by iteration."""
    gear = Toothing(teeth, pitch.module, pressure_angle, helix_angle, profile_shift, internal=internal)
    results = {
        "reference_diameter": abs(gear.reference), "base_diameter": abs(gear.base), "tip_diameter": abs(gear.tip),
        "root_diameter": abs(gear.root), "tip_pressure_angle": acos(gear.base / gear.tip),
        "tip_thickness": gear.tip * gear.half(gear.tip), "normal_thickness": gear.thickness,
    }  # fmt: skip
    if not internal:

        def half(shift: float) -> float:
            other = Toothing(teeth, pitch.module, pressure_angle, helix_angle, shift)
            return other.half(other.tip)

        results["pointed_shift"] = by_secants(half, -ADDENDUM)
        results["least_shift"] = (
            DEDENDUM - CORNER * (1.0 - sin(pressure_angle)) - teeth * sin(gear.transverse) ** 2 / (2.0 * cos(gear.beta))
        )
    if helix_angle is not None:
        base_helix = asin(sin(helix_angle) * cos(pressure_angle))
        results |= {
            "transverse_pressure_angle": gear.transverse, "base_helix_angle": base_helix,
            "normal_base_pitch": pi * pitch.module * cos(pressure_angle),
            "virtual_teeth": gear.teeth / (cos(base_helix) ** 2 * cos(helix_angle)),
            "lead": pi * gear.reference / tan(helix_angle),
        }  # fmt: skip
    return results


def by_secants(f: "Function", low: float) -> float:
    """Where the teeth are pointed: by the secant of two guesses as long as it moves."""
    high = low + 1.0
    while f(high) > 0.0:
        low, high = high, high + 1.0
    a, b = f(low), f(high)
    for _ in range(100):
        if a == b or abs(high - low) <= 4e-16 * abs(high):
            break
        low, high, a = high, high - b * (high - low) / (b - a), b
        b = f(high)
    return high


def pair(
    *, first: "Any", second: "Any", pitch: "Any", pressure_angle: float, helix_angle: float, internal: bool, tips: str,
    centre_distance: "float | None" = None, inverse: "Inverse" = newton,
) -> "dict[str, float]":  # fmt: skip
    """Inv α_w = inv α_t + 2·(x₁ + x₂)·tan α/(z₁ + z₂) by Newton, a = a_d·cos α_t/cos α_w; the path of contact from
    √(r_a² − r_b²) and a·sin α_w, its ends' sliding from the radii of curvature there.
    """  # noqa: D205
    one, two = (
        Toothing(mate.teeth, pitch.module, pressure_angle, helix_angle, mate.profile_shift, internal=ring)
        for mate, ring in ((first, False), (second, internal))
    )
    shifts = one.shift + two.shift
    value = involute(one.transverse) + 2.0 * shifts * tan(pressure_angle) / (one.teeth + two.teeth)
    if not value > 0.0:
        raise ArithmeticError
    angle = tight = inverse(value)["phi"]
    reference, base = 0.5 * (one.reference + two.reference), 0.5 * (one.base + two.base)
    distance = base / cos(tight)
    if centre_distance is not None:
        distance = -centre_distance if internal else centre_distance
        angle = acos(base / distance)
    lift = distance - reference - shifts * pitch.module if tips == "clearance" else 0.0
    line, (a, b) = distance * sin(angle), (0.5 * gear.tip + lift for gear in (one, two))
    # radii of curvature at the tips, negative inside a ring
    start = line - sqrt(b**2 - 0.25 * two.base**2) * (-1.0 if internal else 1.0)
    stop = sqrt(a**2 - 0.25 * one.base**2)
    return {
        "working_pressure_angle": angle, "centre_distance": abs(distance),
        "first_working_diameter": one.base / cos(angle), "first_tip_diameter": 2.0 * abs(a),
        "second_tip_diameter": 2.0 * abs(b),
        "nominal": (stop - start) * one.teeth / (pi * one.base), "recess_length": stop - 0.5 * one.base * tan(angle),
        "first_sliding_at_start": 1.0 - one.teeth * (line - start) / (two.teeth * start),
        "second_sliding_at_end": 1.0 - two.teeth * stop / (one.teeth * (line - stop)),
        "circumferential_backlash": 2.0 * distance * (involute(angle) - involute(tight)),
    }  # fmt: skip


def mesh(
    *, first_teeth: int, second_teeth: int, pitch: "Any", pressure_angle: float, first_profile_shift: float,
    second_profile_shift: float, internal: bool, helix_angle: float = 0.0, centre_distance: "float | None" = None,
    **other: "Any",
) -> "dict[str, float]":  # fmt: skip
    """Distance, angle and contact ratio of a pair of the basic rack."""
    from types import SimpleNamespace

    if any(name not in ("points", "shown", "root_radius_factor") for name in other):
        raise ArithmeticError
    results = pair(
        first=SimpleNamespace(teeth=first_teeth, profile_shift=first_profile_shift),
        second=SimpleNamespace(teeth=second_teeth, profile_shift=second_profile_shift), pitch=pitch, internal=internal,
        pressure_angle=pressure_angle, helix_angle=helix_angle, tips="", centre_distance=centre_distance,
    )  # fmt: skip
    return {**results, "nominal_contact_ratio": results["nominal"]}


def measure(
    *, teeth: int, module: float, pressure_angle: float, helix_angle: float, profile_shift: float, internal: bool,
    over: "int | None" = None, pin: "float | None" = None, tip_diameter: "float | None" = None,
    inverse: "Inverse" = newton,
) -> "dict[str, float]":  # fmt: skip
    """W = m·cos α·(π·(k − ½) + z·inv α_t) + 2·x·m·sin α; pins by Newton on tan α − α; s̄ = d_v·sin(s/d_v).

    Inv α_K = D/(z·m·cos α) − π/2z + inv α_t + 2·x·tan α/z, d_K = d_b/cos α_K, M = d_K·cos(90°/z) + D.
    """
    # of an internal gear the shift is that of its spaces
    sign, spaces = (-1.0, -profile_shift) if internal else (1.0, profile_shift)
    gear = Toothing(teeth, module, pressure_angle, helix_angle, spaces)
    thickness = module * (pi / 2 + 2 * profile_shift * tan(pressure_angle))
    virtual = teeth * module / cos(helix_angle) ** 3
    results = {"normal_thickness": thickness, "chordal.thickness": virtual * sin(thickness / virtual)}
    if not internal:
        results["constant_chord.thickness"] = thickness * cos(pressure_angle) ** 2
    if tip_diameter is not None:
        high = sign * (tip_diameter - gear.reference) / 2
        if not internal:
            results["constant_chord.height"] = high - thickness / 2 * sin(pressure_angle) * cos(pressure_angle)
        results["chordal.height"] = high + sign * virtual / 2 * (1 - cos(thickness / virtual))
    helix = sqrt(1 - (sin(helix_angle) * cos(pressure_angle)) ** 2)
    if pin is not None:
        share = pin / (teeth * module * cos(pressure_angle))
        more = involute(gear.transverse) + 2 * spaces * tan(pressure_angle) / teeth
        angle = inverse(more + sign * (share - pi / (2 * teeth)))["phi"]
        centre = gear.base / cos(angle)
        results |= {
            "pins.centre_diameter": centre,
            "pins.size": (centre * cos(pi / (2 * teeth)) if teeth % 2 else centre) + sign * pin,
            "pins.contact_diameter": sqrt(gear.base**2 + (gear.base * tan(angle) - sign * pin * helix) ** 2),
        }  # fmt: skip
    if over and not (internal and helix_angle):
        base = module * cos(pressure_angle) * (pi * (over - 0.5) + teeth * involute(gear.transverse))
        span = base + 2 * spaces * module * sin(pressure_angle)
        results |= {"span.span": span, "span.contact_diameter": sqrt(gear.base**2 + (span * helix) ** 2)}
    return results


def profile(
    *, teeth: int, pitch: "Any", pressure_angle: float, profile_shift: float, internal: bool, helix_angle: float,
    root_radius_factor: float = CORNER, **other: "Any",
) -> "dict[str, float]":  # fmt: skip
    """The form circle where the rack's straight flank ends, undercut or not, as handbooks have it."""
    if internal or "addendum_factor" in other:
        raise ArithmeticError
    gear = Toothing(teeth, pitch.module, pressure_angle, helix_angle, profile_shift)
    depth = pitch.module * (DEDENDUM - root_radius_factor * (1.0 - sin(pressure_angle)) - profile_shift)
    along = gear.reference * sin(gear.transverse) - 2.0 * depth / sin(gear.transverse)
    return {"base_diameter": gear.base, "form_diameter": sqrt(gear.base * gear.base + along * along)}
