"""Meshes, unknown gears, data blocks and profiles by formulas of handbooks."""

from math import acos, cos, pi, sqrt, tan

from dynamics_cli.accuracy.alternatives.gear.involute import newton

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def _involute(angle: float) -> float:
    return tan(angle) - angle


def mesh_by_book(
    *, first_teeth: int, second_teeth: int, pitch: "Any", pressure_angle: float, first_profile_shift: float,
    second_profile_shift: float, internal: bool, helix_angle: float = 0.0, centre_distance: "float | None" = None,
    **other: "Any",
) -> "dict[str, float]":  # fmt: skip
    """Distance, angle and contact ratio of the tips by tan α − α and arc cosines, as handbooks have them."""
    if any(name not in ("points", "shown", "root_radius_factor") for name in other):
        raise ArithmeticError
    sign = -1 if internal else 1
    m, total = pitch.module, first_teeth + sign * second_teeth
    transverse = pressure_angle if helix_angle == 0.0 else _transverse(pressure_angle, helix_angle)
    r1, r2 = (0.5 * teeth * m / cos(helix_angle) for teeth in (first_teeth, second_teeth))
    b1, b2 = r1 * cos(transverse), r2 * cos(transverse)
    shifts = first_profile_shift + second_profile_shift
    if centre_distance is None:
        value = _involute(transverse) + 2.0 * shifts * tan(pressure_angle) / total
        if not value > 0.0:
            raise ArithmeticError
        angle = newton(value)["phi"]
        distance = abs(b1 + sign * b2) / cos(angle)
    else:
        distance = centre_distance
        angle = acos(abs(b1 + sign * b2) / distance)
    a1, a2 = r1 + m * (1.0 + first_profile_shift), r2 + sign * m * (1.0 + second_profile_shift)
    if a2 < b2:
        raise ArithmeticError
    length = sqrt(a1 * a1 - b1 * b1) + sign * sqrt(a2 * a2 - b2 * b2) - sign * distance * cos(angle) * tan(angle)
    return {
        "centre_distance": distance,
        "working_pressure_angle": angle,
        "nominal_contact_ratio": length * first_teeth / (2.0 * pi * b1),
    }


def _transverse(pressure_angle: float, helix_angle: float) -> float:
    from math import atan

    return atan(tan(pressure_angle) / cos(helix_angle))


def identify_by_book(
    *, teeth: int, spans: "Any", helix_angle: float, count: int, reading: float, tip_diameter: "float | None" = None,
    decimals: int = 17,
) -> "dict[str, float]":  # fmt: skip
    """The shift of the best gear, whose size and angle are taken as found, by tan α − α."""
    from dynamics_cli.gear.measure.identify import identify as own

    if helix_angle:
        raise ArithmeticError
    best = own(teeth=teeth, spans=spans, tip_diameter=tip_diameter, reading=reading, count=1).candidates[0]
    angle, shifts = best.pressure_angle, []
    for one in spans:
        base = (one.over - 0.5) * pi + teeth * round(_involute(angle), decimals)
        shifts.append((one.length / best.module - cos(angle) * base) / (2.0 * tan(angle) * cos(angle)))
    return {"candidates[0].profile_shift": sum(shifts) / len(shifts)}


def block_by_book(
    *, teeth: int, pitch: "Any", pressure_angle: float, profile_shift: float, internal: bool, helix_angle: float,
    over: "int | None" = None, decimals: int = 4, digits: int = 17, **other: "Any",
) -> "dict[str, float]":  # fmt: skip
    """Diameters and span by tan α − α, printed with four decimals."""
    if internal or "addendum_factor" in other:
        raise ArithmeticError
    m, transverse = pitch.module, _transverse(pressure_angle, helix_angle)
    d = teeth * m / cos(helix_angle)
    out = {"d": d, "d_b": d * cos(transverse), "d_a": d + 2.0 * m * (1.0 + profile_shift)}
    if over is not None:
        base = (over - 0.5) * pi + teeth * round(tan(transverse) - transverse, digits)
        out["W_k"] = m * (cos(pressure_angle) * base + 2.0 * profile_shift * tan(pressure_angle) * cos(pressure_angle))
    return {name: round(1e3 * value, decimals) for name, value in out.items()}


def profile_by_book(
    *, teeth: int, pitch: "Any", pressure_angle: float, profile_shift: float, internal: bool, helix_angle: float,
    root_radius_factor: "float | None" = None, **other: "Any",
) -> "dict[str, float]":  # fmt: skip
    """The form circle where the rack's straight flank ends, undercut or not, as handbooks have it."""
    from math import sin

    if internal or "addendum_factor" in other:
        raise ArithmeticError
    m, transverse = pitch.module, _transverse(pressure_angle, helix_angle)
    d = teeth * m / cos(helix_angle)
    depth = m * (
        1.25
        - (0.38 if root_radius_factor is None else root_radius_factor) * (1.0 - sin(pressure_angle))
        - profile_shift
    )
    base = d * cos(transverse)
    along = d * sin(transverse) - 2.0 * depth / sin(transverse)
    return {"base_diameter": base, "form_diameter": sqrt(base * base + along * along)}


def profile_by_halving(
    *, teeth: int, pitch: "Any", pressure_angle: float, profile_shift: float, internal: bool, helix_angle: float,
    root_radius_factor: "float | None" = None, **other: "Any",
) -> "dict[str, float]":  # fmt: skip
    """The form circle where trochoid and involute meet, by halving of the textbook's equation of half angles."""
    from dynamics_cli.accuracy.alternatives.gear.root import halving

    if internal or "addendum_factor" in other:
        raise ArithmeticError
    base = teeth * pitch.module / cos(helix_angle) * cos(_transverse(pressure_angle, helix_angle))
    form = halving(
        teeth=teeth, pressure_angle=pressure_angle, helix_angle=helix_angle, shift=profile_shift, dedendum=1.25,
        tip_radius=0.38 if root_radius_factor is None else root_radius_factor,
    )  # fmt: skip
    return {"base_diameter": base, "form_diameter": 2.0 * pitch.module * form["form_radius"]}
