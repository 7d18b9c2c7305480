"""Basic racks: proportions of the generating rack by name, of ISO 53 and of the trade."""

from math import pi

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import cos, pi_beside, sin
from dynamics_cli.quantities import Angle, Annotated, Ratio
from dynamics_cli.records import Choice, record

FULL_DEPTH = 20.0 * pi / 180.0


class Profile(Choice):
    """Basic rack: those of ISO 53, and common ones of the trade."""

    names = ("a", "b", "c", "d", "stub", "agma-coarse", "agma-fine")
    aliases = {  # noqa: RUF012
        "iso-53-a": "a",
        "iso-53-b": "b",
        "iso-53-c": "c",
        "iso-53-d": "d",
        "full-depth": "a",
        "khk": "a",
        "jis": "a",
        "agma-201": "agma-coarse",
        "agma-207": "agma-fine",
    }


# addendum, dedendum and corner radius in modules
_RACKS = {
    "a": (1.0, 1.25, 0.38),
    "b": (1.0, 1.25, 0.3),
    "c": (1.0, 1.25, 0.25),
    "d": (1.0, 1.4, 0.39),
    "stub": (0.8, 1.0, 0.3),
    "agma-coarse": (1.0, 1.25, 0.3),
    "agma-fine": (1.0, 1.2, 0.0),
}


@record
class BasicRack:
    """Proportions of the generating rack, in normal modules."""

    pressure_angle: Annotated[Angle, "Normal pressure angle α_n [rad]."] = FULL_DEPTH
    addendum: Annotated[Ratio, "Addendum factor of the gear, h_a*."] = 1.0
    dedendum: Annotated[Ratio, "Dedendum factor of the gear, h_fP*."] = 1.25
    tip_radius: Annotated[Ratio, "Radius of the rack's corner, ρ_fP*: the root radius of the gear."] = 0.38


def basic_rack(
    profile: str,
    pressure_angle: float,
    addendum_factor: float | None = None,
    dedendum_factor: float | None = None,
    root_radius_factor: float | None = None,
) -> BasicRack:
    """The rack of a named profile with the given factors; refuses proportions that are not those of a rack."""
    addendum, dedendum, radius = _RACKS[profile]
    addendum = addendum if addendum_factor is None else addendum_factor
    dedendum = dedendum if dedendum_factor is None else dedendum_factor
    _require_rack(BasicRack(pressure_angle, addendum, dedendum, 0.0))
    if root_radius_factor is not None:
        radius = root_radius_factor
    else:
        sine, cosine = sin(pressure_angle), cos(pressure_angle)
        widest = (0.25 * pi_beside(cosine, dedendum) * cosine - dedendum * sine) / (1.0 - sine)
        require(
            widest >= 0.0,
            "the rack is pointed above its tip: π/4 − h_fP·tan α is {half_land:6}",
            half_land=(0.25 * pi - dedendum * sine / cosine, Ratio),
            code="pointed-rack",
            hint="give a smaller dedendum factor",
        )
        # a basic rack's corner that does not fit at this pressure angle becomes a full round
        radius = widest if widest < radius else radius
    rack = BasicRack(pressure_angle, addendum, dedendum, radius)
    _require_rack(rack)
    return rack


def require_pressure_angle(angle: float) -> None:
    """Refuse pressure angles that no rack has."""
    require(
        (angle > 0.0) & (angle < 0.5 * pi),
        "the pressure angle {angle:6} must be above 0 and below 90 degrees",
        angle=(angle, Angle),
        code="pressure-angle",
        hint="20 deg is usual",
    )


def _require_rack(rack: BasicRack) -> None:
    require_pressure_angle(rack.pressure_angle)
    require(
        rack.addendum + rack.dedendum > 0.0,
        "addendum and dedendum factors add up to {depth:6}: the teeth have no height",
        depth=(rack.addendum + rack.dedendum, Ratio),
        code="no-tooth",
    )
    require(
        rack.tip_radius >= 0.0,
        "the corner radius of the rack is {tip_radius:6}; it must not be negative",
        tip_radius=(rack.tip_radius, Ratio),
        code="tip-radius",
    )
