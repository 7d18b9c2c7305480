"""Gears and pairs: the program's functions in the words of the references, and a pair by a library of others."""

from math import atan, cos, tan

from dynamics_cli.accuracy.cases import flat

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def spur(**given: "Any") -> "Any":
    """A spur gear."""
    from dynamics_cli.gear.single import spur as own

    return own(**given)


def helical(**given: "Any") -> "Any":
    """A helical gear."""
    from dynamics_cli.gear.single import helical as own

    return own(**given)


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
