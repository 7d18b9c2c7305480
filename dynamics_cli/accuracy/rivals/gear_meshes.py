"""Meshes, unknown gears, data blocks and profiles: the program's functions, and other ways to the same numbers."""

from math import acos, cos, pi, sqrt, tan

from dynamics_cli.accuracy.cases import flat
from dynamics_cli.accuracy.rivals.gear_involute import newton

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Stated(dict):  # type: ignore[type-arg]
    """Results by address, with the bounds that a task states for them."""

    numerics: "Any" = None


def mesh(**given: "Any") -> Stated:
    """The proof of a mesh; points of contact by their number in place of whole columns."""
    from dynamics_cli.gear.mesh import mesh as own
    from dynamics_cli.records import ErrorBound, Numerics

    answer = own(**given)
    assert answer.numerics is not None
    made = Stated({name: value for name, value in flat(answer).items() if name != "path"})
    bounds = []
    for bound in answer.numerics.bounds:
        _, _, column = bound.result.partition("path.")
        if not column:
            bounds.append(bound)
            continue
        for index, value in enumerate(answer.path.arrays[column]):
            address = f"{bound.result}[{index}]"
            made[address] = float(value)
            bounds.append(ErrorBound(address, bound.bound, bound.relative))
    made.numerics = Numerics("", tuple(bounds))
    return made


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


def mesh_by_polygons(points: int = 101, shown: int = 3, **given: "Any") -> "dict[str, float]":
    """Distances from the roots between points: both outlines within a micrometre a metre of module, turned in steps."""
    import numpy as np

    from dynamics_cli.gear.contact import half_play, path_of_contact
    from dynamics_cli.gear.flanks import flank
    from dynamics_cli.gear.gear import FULL_DEPTH
    from dynamics_cli.gear.mesh import FULL, ISO, forms_of, without_backlash

    distance = given.pop("centre_distance", None)
    usual = {
        "profile": FULL, "shift_sign": ISO, "pressure_angle": FULL_DEPTH, "helix_angle": 0.0, "addendum_factor": None,
        "dedendum_factor": None, "root_radius_factor": None, "first_tip_diameter": None, "second_tip_diameter": None,
    }  # fmt: skip
    first, second = forms_of(**{**usual, **given})
    if first.internal or second.internal:
        raise ArithmeticError
    apart = without_backlash(first, second) if distance is None else distance
    play = max(half_play(first, second, path_of_contact(first, second, apart)), 0.0)
    found = {}
    for name, one, two, turned in (
        ("first_in_second", first, second, play),
        ("second_in_first", second, first, play * second.teeth / first.teeth),
    ):
        if apart - one.tip > two.form:
            continue
        chain = flank(two, 1e-4 * two.module)
        below = chain.joint + 1
        root = chain.radius[:below] * np.exp(1j * (pi / two.teeth - chain.angle[:below]))
        half = one.half_angle(one.roll(one.tip))
        reach = acos(min((one.tip**2 + apart**2 - two.tip**2) / (2.0 * one.tip * apart), 1.0)) + half
        turns = np.linspace(-reach, reach, 1001)[:, None]
        edge = (apart - one.tip * np.exp(1j * (turns + half))) * np.exp(1j * (turns * one.teeth / two.teeth - turned))
        found[name] = float(
            min(apart - one.tip - two.root, *(np.abs(edge - root).min(), np.abs(edge.conj() - root).min()))
        )
    return found


def identify(**given: "Any") -> "Any":
    """Standard gears that fit the readings."""
    from dynamics_cli.gear.identify import identify as own

    return own(**given)


def identify_by_table(
    *, teeth: int, spans: "Any", helix_angle: float, count: int, reading: float, tip_diameter: "float | None" = None
) -> "dict[str, float]":
    """The shift of the best gear, whose size and angle are taken as found, by an involute of six decimals."""
    from dynamics_cli.gear.identify import identify as own

    if helix_angle:
        raise ArithmeticError
    best = own(teeth=teeth, spans=spans, tip_diameter=tip_diameter, reading=reading, count=1).candidates[0]
    angle, shifts = best.pressure_angle, []
    for one in spans:
        base = (one.over - 0.5) * pi + teeth * round(_involute(angle), 6)
        shifts.append((one.length / best.module - cos(angle) * base) / (2.0 * tan(angle) * cos(angle)))
    return {"candidates[0].profile_shift": sum(shifts) / len(shifts)}


def data_block(**given: "Any") -> Stated:
    """The rows of a data block as numbers, by their symbols."""
    from dynamics_cli.gear.data_block import data_block as own
    from dynamics_cli.records import ErrorBound, Numerics

    answer = own(**given)
    assert answer.numerics is not None
    bounds = {bound.result: bound for bound in answer.numerics.bounds}
    made, kept = Stated(), []
    for index, row in enumerate(answer.rows):
        bound = bounds.get(f"rows[{index}].data")
        if bound is not None:
            made[row.symbol] = float(row.data)
            kept.append(ErrorBound(row.symbol, bound.bound, bound.relative))
    made.numerics = Numerics("", tuple(kept))
    return made


def block_by_table(
    *, teeth: int, pitch: "Any", pressure_angle: float, profile_shift: float, internal: bool, helix_angle: float,
    over: "int | None" = None, decimals: int = 4, **other: "Any",
) -> "dict[str, float]":  # fmt: skip
    """Diameters and span with an involute of six decimals, as tables print it."""
    if internal or "addendum_factor" in other:
        raise ArithmeticError
    m, transverse = pitch.module, _transverse(pressure_angle, helix_angle)
    d = teeth * m / cos(helix_angle)
    out = {"d": d, "d_b": d * cos(transverse), "d_a": d + 2.0 * m * (1.0 + profile_shift)}
    if over is not None:
        base = (over - 0.5) * pi + teeth * round(tan(transverse) - transverse, 6)
        out["W_k"] = m * (cos(pressure_angle) * base + 2.0 * profile_shift * tan(pressure_angle) * cos(pressure_angle))
    return {name: round(1e3 * value, decimals) for name, value in out.items()}


def profile(**given: "Any") -> "Any":
    """A drawn profile."""
    from dynamics_cli.gear.profile import profile as own

    return own(**given)


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
