"""How a gear is given to measuring, profiles and meshes: normal data at the door, the toothing inside."""

from math import pi, radians

from dynamics_cli.errors import require
from dynamics_cli.gear.toothing import Toothing
from dynamics_cli.gear.trochoid import Cutter, roll_less_arc, root
from dynamics_cli.numerics.elementary import atan2, cos, sin, sqrt
from dynamics_cli.quantities import DiametralPitch, Module, Size
from dynamics_cli.records import record

TWENTY_DEGREES = radians(20.0)


@record
class ByModule:
    """The size of the teeth by their normal module.

    Parameters
    ----------
    module : Module
        Normal module [m].
    """

    module: Module

    @property
    def normal_module(self) -> float:
        """m_n."""
        return self.module


@record
class ByDiametralPitch:
    """The size of the teeth by their normal diametral pitch.

    Parameters
    ----------
    diametral_pitch : DiametralPitch
        Teeth for each length of pitch diameter, in the normal plane [1/m].
    """

    diametral_pitch: DiametralPitch

    @property
    def normal_module(self) -> float:
        """m_n."""
        return 1.0 / self.diametral_pitch


@record
class ByCircularPitch:
    """The size of the teeth by their normal circular pitch.

    Parameters
    ----------
    circular_pitch : Size
        Pitch along the pitch circle, in the normal plane [m].
    """

    circular_pitch: Size

    @property
    def normal_module(self) -> float:
        """m_n."""
        return self.circular_pitch / pi


Pitch = ByModule | ByDiametralPitch | ByCircularPitch


def cutter_of(
    teeth: int, pressure_angle: float, helix_angle: float, shift: float, dedendum: float, root_radius: float
) -> Cutter:
    """The rack that cuts an external gear."""
    return Cutter(teeth, pressure_angle, helix_angle, shift, dedendum, root_radius)


def require_gear(teeth: int, module: float, pressure_angle: float, helix_angle: float) -> None:
    """Refuse what is no gear at all."""
    require(teeth >= 3, "a gear of {0} teeth is none", teeth, code="teeth")
    require(module > 0.0, "teeth of module {0:.6g} mm have no size", 1e3 * module, code="module")
    require(
        (pressure_angle > 0.01) & (pressure_angle < 0.25 * pi),
        "a pressure angle of {0:.6g} rad is none of a gear",
        pressure_angle,
        code="pressure-angle",
        hint="give an angle between 1 and 45 degrees",
    )
    require(
        abs(helix_angle) < 0.47 * pi,
        "a helix angle of {0:.6g} rad leaves no gear",
        helix_angle,
        code="helix-angle",
        hint="give an angle below 84 degrees",
    )


def toothing(
    *,
    teeth: int,
    module: float,
    pressure_angle: float,
    helix_angle: float,
    profile_shift: float,
    internal: bool,
    addendum: float,
    dedendum: float,
    root_radius: float,
    tip_diameter: float | None = None,
) -> Toothing:
    """The toothing of a gear; its form radius from the exact trochoid when a rack cuts it."""
    require_gear(teeth, module, pressure_angle, helix_angle)
    radius = 0.5 * teeth * module / cos(helix_angle)
    if internal:
        own_tip, own_root = radius - (addendum - profile_shift) * module, radius + (dedendum + profile_shift) * module
        form = _internal_form(radius * cos(_transverse(pressure_angle, helix_angle)), own_root, root_radius * module)
    else:
        own_tip, own_root = radius + (addendum + profile_shift) * module, radius - (dedendum - profile_shift) * module
        cutter = cutter_of(teeth, pressure_angle, helix_angle, profile_shift, dedendum, root_radius)
        form = root(cutter).form_radius * module
    if tip_diameter is not None:
        own_tip = 0.5 * tip_diameter
    gear = Toothing(teeth, internal, module, pressure_angle, helix_angle, profile_shift, own_tip, own_root, form)
    require_teeth(gear, form)
    return gear


def require_teeth(gear: Toothing, form: float) -> None:
    """Refuse teeth without a flank between root and tip, and teeth that end in a point below their tips."""
    flank_end = "the tips lie at {0:.9g} mm diameter, the flank begins at {1:.9g} mm: no involute is left"
    outside = form > gear.tip if gear.internal else gear.tip > form
    require(
        outside, flank_end, 2e3 * gear.tip, 2e3 * form, code="no-flank", hint="change the profile shift or the tips"
    )
    ratio = gear.tip / gear.base_radius
    require(
        ratio >= 1.0,
        "the tips at {0:.9g} mm diameter lie inside the base circle of {1:.9g} mm, where there is no involute",
        2e3 * gear.tip,
        2e3 * gear.base_radius,
        code="tip-inside-base",
        hint="raise the tip diameter, or the profile shift",
    )
    roll = roll_less_arc(sqrt((ratio - 1.0) * (ratio + 1.0)))
    half = gear.hollow_half + roll if gear.internal else gear.solid_half - roll
    require(
        half > 0.0,
        "the teeth are pointed below their tips: the tip thickness would be {0:.6g} mm",
        2e3 * half * gear.tip,
        code="pointed",
        hint="lower the profile shift, or give a smaller tip diameter"
        if not gear.internal
        else "give a larger tip diameter",
    )


def _transverse(pressure_angle: float, helix_angle: float) -> float:
    return atan2(sin(pressure_angle), cos(pressure_angle) * cos(helix_angle))


def _internal_form(base: float, root_circle: float, fillet: float) -> float:
    """Where a fillet tangent to root circle and involute ends."""
    centre = root_circle - fillet
    require(centre > base, "a root radius of {0:.6g} mm does not fit", 1e3 * fillet, code="root-radius")
    reach = sqrt((centre - base) * (centre + base)) + fillet
    return sqrt(base * base + reach * reach)
