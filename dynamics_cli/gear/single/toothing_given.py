"""From inputs to the gear of its rack, and to the toothing for measuring, profiles and meshes."""

from math import pi

from dynamics_cli.errors import require
from dynamics_cli.gear.pitch import module_of
from dynamics_cli.gear.single.gear import MOST_FOLLOWED, Gear, require_number, signed_gear
from dynamics_cli.gear.single.rack import basic_rack
from dynamics_cli.gear.single.toothing import Toothing
from dynamics_cli.gear.single.trochoid import roll_less_arc
from dynamics_cli.numerics.elementary import absolute, sqrt
from dynamics_cli.numerics.roots import halved
from dynamics_cli.quantities import Angle, Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.gear.pitch import Pitch

# Default fillet of an internal gear in modules: that of most pinion cutters, which fits most spaces.
INTERNAL_FILLET = 0.2
STEEPEST = 84.0 * pi / 180.0
# What `gear_of` needs to know, as the tasks call it.
GEAR = (
    "teeth", "pitch", "profile", "pressure_angle", "addendum_factor", "dedendum_factor", "root_radius_factor",
    "helix_angle", "profile_shift", "internal", "shift_sign",
)  # fmt: skip


def gear_inputs(given: "dict[str, Any]") -> "dict[str, Any]":
    """Those of a task's inputs that describe the gear."""
    return {name: given[name] for name in GEAR}


def gear_of(
    *,
    teeth: int,
    pitch: "Pitch",
    profile: str,
    pressure_angle: float,
    addendum_factor: float | None,
    dedendum_factor: float | None,
    root_radius_factor: float | None,
    helix_angle: float,
    profile_shift: float,
    internal: bool,
    shift_sign: str,
) -> Gear:
    """The gear of the inputs, in ISO's signs; refuses an impossible gear."""
    require(teeth >= 3, "a gear needs at least 3 teeth, not {teeth}", teeth=teeth, code="teeth")
    require_number(teeth, MOST_FOLLOWED)
    require(
        (pressure_angle > 0.01) & (pressure_angle < 0.25 * pi),
        "the pressure angle {pressure_angle:6} is not possible for a gear",
        pressure_angle=(pressure_angle, Angle),
        code="pressure-angle",
        hint="give an angle between 1 and 45 degrees",
    )
    require(
        absolute(helix_angle) < STEEPEST,
        "the helix angle {helix_angle:6} is too large",
        helix_angle=(helix_angle, Angle),
        code="helix-angle",
        hint="give an angle below 84 degrees",
    )
    rack = basic_rack(profile, pressure_angle, addendum_factor, dedendum_factor, root_radius_factor)
    return signed_gear(
        teeth,
        module_of(pitch, helix_angle),
        rack,
        internal=internal,
        sign=shift_sign,
        helix_angle=helix_angle,
        shift=profile_shift,
    )


def fillet_of(gear: Gear, root_radius_factor: float | None) -> float:
    """Radius in the root, in modules: of the rack's corner, or of an internal gear's fillet.

    The default fillet is 0.2 modules, or the largest that fits the space if that is less.
    """
    if not gear.internal:
        return gear.rack.tip_radius
    if root_radius_factor is not None:
        return root_radius_factor
    if _space_beside(gear, INTERNAL_FILLET) >= 0.0:
        return INTERNAL_FILLET
    require(
        _space_beside(gear, 0.0) > 0.0,
        "the tooth spaces are pointed before their root at {root_diameter:6}: half the angle left is {half_angle:6}",
        root_diameter=(absolute(gear.root_diameter), Size),
        half_angle=(_space_beside(gear, 0.0), Angle),
        code="pointed-space",
        hint="give a smaller dedendum factor, or another profile shift",
    )
    return halved(lambda fillet: _space_beside(gear, fillet) >= 0.0, 0.0, INTERNAL_FILLET, 40)[0]


def _space_beside(gear: Gear, fillet: float) -> float:
    """Half the angle between a fillet and the centreline of an internal gear's space."""
    base, size = 0.5 * absolute(gear.base_diameter), fillet * gear.module
    ratio = (0.5 * absolute(gear.root_diameter) - size) / base
    if not ratio > 1.0:
        return -1.0
    space = pi / abs(gear.teeth) + gear.base_half_angle
    value = space - roll_less_arc(sqrt((ratio - 1.0) * (ratio + 1.0))) - size / base
    return getattr(value, "value", value)


def toothing(gear: Gear, *, tip_diameter: float | None = None, fillet: float = INTERNAL_FILLET) -> Toothing:
    """The toothing of a gear, in magnitudes; its form radius from the exact trochoid when a rack cuts it."""
    own_tip, own_root = 0.5 * absolute(gear.tip_diameter), 0.5 * absolute(gear.root_diameter)
    if tip_diameter is not None:
        own_tip = 0.5 * tip_diameter
    if gear.internal:
        form = internal_form(0.5 * absolute(gear.base_diameter), own_root, fillet * gear.module)
    else:
        form = gear.junction.form_radius * gear.module
    teeth_of_gear = Toothing(
        abs(gear.teeth),
        gear.internal,
        gear.module,
        gear.rack.pressure_angle,
        gear.helix_angle,
        -gear.shift if gear.internal else gear.shift,
        own_tip,
        own_root,
        form,
    )
    require_teeth(teeth_of_gear, form)
    return teeth_of_gear


def require_teeth(gear: Toothing, form: float) -> None:
    """Refuse teeth without a flank between root and tip, and teeth that end in a point below their tips."""
    outside = form > gear.tip if gear.internal else gear.tip > form
    require(
        outside,
        "the tips lie at {tip:9} diameter, the flank begins at {form:9}: no involute is left",
        tip=(2.0 * gear.tip, Size),
        form=(2.0 * form, Size),
        code="no-flank",
        hint="change the profile shift or the tips",
    )
    ratio = gear.tip / gear.base_radius
    require(
        ratio >= 1.0,
        "the tips at {tip:9} diameter lie inside the base circle of {base_radius:9}, where there is no involute",
        tip=(2.0 * gear.tip, Size),
        base_radius=(2.0 * gear.base_radius, Size),
        code="tip-inside-base",
        hint="raise the tip diameter, or the profile shift",
    )
    roll = roll_less_arc(sqrt((ratio - 1.0) * (ratio + 1.0)))
    half = gear.hollow_half + roll if gear.internal else gear.solid_half - roll
    require(
        half > 0.0,
        "the teeth are pointed below their tips: the tip thickness would be {thickness:6}",
        thickness=(2.0 * half * gear.tip, Size),
        code="pointed",
        hint="lower the profile shift, or give a smaller tip diameter"
        if not gear.internal
        else "give a larger tip diameter",
    )


def internal_form(base: float, root_circle: float, fillet: float) -> float:
    """Where a fillet tangent to root circle and involute ends."""
    centre = root_circle - fillet
    require(centre > base, "a root radius of {fillet:6} does not fit", fillet=(fillet, Size), code="root-radius")
    reach = sqrt((centre - base) * (centre + base)) + fillet
    return sqrt(base * base + reach * reach)
