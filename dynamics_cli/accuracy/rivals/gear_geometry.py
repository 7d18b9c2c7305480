"""Gears and pairs: the program's functions in the words of the references, and a pair as textbooks calculate it."""

from math import atan, cos, tan

from dynamics_cli.accuracy.cases import flat
from dynamics_cli.accuracy.rivals.gear_involute import newton

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


def spur(**given: "Any") -> "Any":
    """A spur gear."""
    from dynamics_cli.gear.single import spur as own

    return own(**given)


def helical(**given: "Any") -> "Any":
    """A helical gear."""
    from dynamics_cli.gear.single import helical as own

    return own(**given)


def _involute(angle: float) -> float:
    return tan(angle) - angle


def _tabulated(angle: float) -> float:
    """The involute as tables print it: six decimals."""
    return round(tan(angle) - angle, 6)


def spur_by_table(**given: "Any") -> "dict[str, float]":
    """The same, involutes looked up."""
    return spur_by_book(**given, involute=_tabulated)


def spur_by_book(
    *, teeth: int, pitch: "Any", pressure_angle: float, profile_shift: float, internal: bool, helix_angle: float = 0.0,
    involute: "Callable[[float], float]" = _involute,
) -> "dict[str, float]":  # fmt: skip
    """Thickness at the tip from tan α − α at both radii; external gears."""
    from math import acos, pi

    if internal:
        raise ArithmeticError
    transverse = atan(tan(pressure_angle) / cos(helix_angle))
    reference = teeth * pitch.module / cos(helix_angle)
    base = reference * cos(transverse)
    tip = reference + 2.0 * pitch.module * (1.0 + profile_shift)
    angle = acos(base / tip)
    half = (0.5 * pi + 2.0 * profile_shift * tan(pressure_angle)) / teeth
    return {
        "reference_diameter": reference,
        "base_diameter": base,
        "tip_diameter": tip,
        "tip_pressure_angle": angle,
        "tip_thickness": tip * (half + involute(transverse) - involute(angle)),
    }


def pair(*, tips: str, **given: "Any") -> "dict[str, Any]":
    """A pair of gears, the results under the names of its references."""
    from dynamics_cli.gear.pair import pair as own
    from dynamics_cli.gear.split import Tips

    answer = own(tips=Tips(tips), **given)
    found = flat(answer)
    found["nominal"] = answer.nominal_contact_ratio or answer.transverse_contact_ratio
    found["margin"] = answer.verdicts[0].margin
    if answer.nominal_contact_ratio is None:
        # where root form circles cut the path, its ends are not those of the tips
        found["first_sliding_at_start"] = answer.points[0].first_sliding
        found["second_sliding_at_end"] = answer.points[-1].second_sliding
    return found


def pair_by_table(**given: "Any") -> "dict[str, float]":
    """The same, involutes looked up to six decimals and back."""
    return pair_by_book(**given, look_up=_tabulated)


def pair_by_book(
    *, first: "Any", second: "Any", pitch: "Any", pressure_angle: float, helix_angle: float, internal: bool, tips: str,
    centre_distance: "float | None" = None, look_up: "Callable[[float], float]" = _involute,
) -> "dict[str, float]":  # fmt: skip
    """The working angle from tan α − α by Newton, and a from it."""
    if centre_distance is not None:
        raise ArithmeticError
    transverse = atan(tan(pressure_angle) / cos(helix_angle))
    sign = -1.0 if internal else 1.0
    teeth = second.teeth + sign * first.teeth
    shift = second.profile_shift + sign * first.profile_shift
    involute = 2.0 * tan(pressure_angle) * shift / teeth + look_up(transverse)
    if look_up is _tabulated:
        involute = round(involute, 6)
    angle = newton(involute)["phi"]
    module = pitch.module / cos(helix_angle)
    return {
        "working_pressure_angle": angle,
        "centre_distance": 0.5 * module * teeth * cos(transverse) / cos(angle),
        "first_working_diameter": first.teeth * module * cos(transverse) / cos(angle),
    }


def pair_by_py_gearworks(
    *, first: "Any", second: "Any", pitch: "Any", pressure_angle: float, helix_angle: float, internal: bool, tips: str,
    centre_distance: "float | None" = None,
) -> "dict[str, float]":  # fmt: skip
    """The distance of two gears by PyPI's `py_gearworks`, from radii and half angles in doubles; external pairs."""
    from math import pi

    from py_gearworks.gearmath import calc_involute_mesh_distance  # type: ignore[import-not-found]

    if centre_distance is not None or internal:
        raise ArithmeticError
    transverse = atan(tan(pressure_angle) / cos(helix_angle))
    sizes = [
        (
            0.5 * one.teeth * pitch.module / cos(helix_angle) * cos(transverse),
            (0.5 * pi + 2.0 * one.profile_shift * tan(pressure_angle)) / one.teeth + tan(transverse) - transverse,
        )
        for one in (first, second)
    ]
    (radius, half), (other, width) = sizes
    return {"centre_distance": float(calc_involute_mesh_distance(radius, other, half, width, 2.0 * pi / second.teeth))}


def bevel(*, kind: str, **given: "Any") -> "Any":
    """Bevel gears."""
    from dynamics_cli.gear.bevel import Kind
    from dynamics_cli.gear.bevel import bevel as own

    return own(kind=Kind(kind), **given)


def worm(**given: "Any") -> "Any":
    """A worm and its wheel."""
    from dynamics_cli.gear.worm import worm as own

    return own(**given)


def crossed(**given: "Any") -> "Any":
    """Crossed helical gears."""
    from dynamics_cli.gear.crossed import crossed as own

    return own(**given)


def measure(*, module: float, internal: bool, helix_angle: float, **given: "Any") -> "Any":
    """Sizes over teeth and over pins; an internal helical gear has no span."""
    from dynamics_cli.gear.gear import NormalModule
    from dynamics_cli.gear.measure import measure as own

    if internal and helix_angle:
        given.pop("over")
    return own(pitch=NormalModule(module), internal=internal, helix_angle=helix_angle, **given)
