"""One gear as its generating rack makes it: everything else in the family stands on this record.

Signs are those of ISO 21771: an internal gear has a negative number of teeth, and with it negative diameters, so that
one set of formulas serves both. The user's convention is turned into it at the door (`Sign`, `signed_gear`), and
lengths are given back as magnitudes.
"""

from math import pi

from dynamics_cli.errors import require
from dynamics_cli.gear.toothing import once
from dynamics_cli.gear.trochoid import Cutter, transverse
from dynamics_cli.numerics.elementary import absolute, atan, atan2, cos, pi_beside, sin, sqrt, tan
from dynamics_cli.numerics.involute import involute
from dynamics_cli.quantities import Angle, DiametralPitch, Module, Ratio, Size
from dynamics_cli.records import Advice, Choice, record

FULL_DEPTH = 20.0 * pi / 180.0
# Modules between these [m] keep every length of a gear within the range of doubles.
SMALLEST, LARGEST = 1e-12, 1e3
# ISO 54, in mm: the series to prefer, and the second.
SERIES_I = (1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 16, 20, 25, 32, 40, 50)
SERIES_II = (1.125, 1.375, 1.75, 2.25, 2.75, 3.5, 4.5, 5.5, 6.5, 7, 9, 11, 14, 18, 22, 28, 36, 45)


class Hand(Choice):
    """Hand of a helix: which way a tooth leans as it goes away from the eye."""

    names = ("right", "left")
    aliases = {"r": "right", "rh": "right", "right-hand": "right", "l": "left", "lh": "left", "left-hand": "left"}  # noqa: RUF012


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


class Sign(Choice):
    """Whose sign the profile shift of an internal gear has: ISO's (towards the tip), or outward as KHK and JIS."""

    names = ("iso", "outward")
    aliases = {"iso-21771": "iso", "din": "iso", "khk": "outward", "jis": "outward", "agma": "outward"}  # noqa: RUF012


@record
class NormalModule:
    """Size of the teeth as the module.

    Parameters
    ----------
    module : Module
        Normal module m_n [m].
    """

    module: Module

    def normal(self, helix_cosine: float) -> float:
        """The normal module."""
        return self.module


@record
class NormalDiametralPitch:
    """Size of the teeth as the diametral pitch of AGMA.

    Parameters
    ----------
    diametral_pitch : DiametralPitch
        Normal diametral pitch P_nd, teeth per length of pitch diameter [1/m].
    """

    diametral_pitch: DiametralPitch

    def normal(self, helix_cosine: float) -> float:
        """The normal module."""
        return 1.0 / self.diametral_pitch


@record
class NormalCircularPitch:
    """Size of the teeth as the pitch.

    Parameters
    ----------
    circular_pitch : Size
        Normal pitch p_n on the reference cylinder [m].
    """

    circular_pitch: Size

    def normal(self, helix_cosine: float) -> float:
        """The normal module."""
        return self.circular_pitch / pi_beside(self.circular_pitch)


@record
class TransverseModule:
    """Size of the teeth as the module in the plane of rotation.

    Parameters
    ----------
    transverse_module : Module
        Transverse module m_t [m].
    """

    transverse_module: Module

    def normal(self, helix_cosine: float) -> float:
        """The normal module."""
        return self.transverse_module * helix_cosine


@record
class TransverseDiametralPitch:
    """Size of the teeth as the diametral pitch in the plane of rotation.

    Parameters
    ----------
    transverse_diametral_pitch : DiametralPitch
        Transverse diametral pitch P_d [1/m].
    """

    transverse_diametral_pitch: DiametralPitch

    def normal(self, helix_cosine: float) -> float:
        """The normal module."""
        return helix_cosine / self.transverse_diametral_pitch


@record
class TransverseCircularPitch:
    """Size of the teeth as the pitch in the plane of rotation.

    Parameters
    ----------
    transverse_circular_pitch : Size
        Transverse pitch p_t on the reference cylinder [m].
    """

    transverse_circular_pitch: Size

    def normal(self, helix_cosine: float) -> float:
        """The normal module."""
        pitch = self.transverse_circular_pitch
        return pitch * helix_cosine / pi_beside(pitch, helix_cosine)


SpurPitch = NormalModule | NormalDiametralPitch | NormalCircularPitch
Pitch = (
    NormalModule
    | NormalDiametralPitch
    | NormalCircularPitch
    | TransverseModule
    | TransverseDiametralPitch
    | TransverseCircularPitch
)


@record
class BasicRack:
    """Proportions of the generating rack, in normal modules.

    Parameters
    ----------
    pressure_angle : Angle
        Normal pressure angle α_n [rad].
    addendum : Ratio
        Addendum factor of the gear, h_a*.
    dedendum : Ratio
        Dedendum factor of the gear, h_fP*.
    tip_radius : Ratio
        Radius of the rack's corner, ρ_fP*: the root radius of the gear.
    """

    pressure_angle: Angle = FULL_DEPTH
    addendum: Ratio = 1.0
    dedendum: Ratio = 1.25
    tip_radius: Ratio = 0.38


def basic_rack(
    profile: str,
    pressure_angle: float,
    addendum_factor: float | None = None,
    dedendum_factor: float | None = None,
    root_radius_factor: float | None = None,
) -> BasicRack:
    """The rack of a named profile, with what was given in place of its own; refuses what is no rack."""
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
            "the rack is pointed above its tip: π/4 − h_fP·tan α is {0:.6g}",
            0.25 * pi - dedendum * sine / cosine,
            code="pointed-rack",
            hint="give a smaller dedendum factor",
        )
        # a profile's own corner that does not fit at this pressure angle becomes a full round
        radius = widest if widest < radius else radius
    rack = BasicRack(pressure_angle, addendum, dedendum, radius)
    _require_rack(rack)
    return rack


def _require_rack(rack: BasicRack) -> None:
    angle = rack.pressure_angle
    require(
        angle > 0.0 and angle < 0.5 * pi,
        "a pressure angle of {0:.6g} rad makes no involute",
        angle,
        code="pressure-angle",
        hint="it lies between 0 and 90 degrees; 20 deg is usual",
    )
    require(
        rack.addendum + rack.dedendum > 0.0,
        "addendum and dedendum factors sum to {0:.6g}: there is no tooth",
        rack.addendum + rack.dedendum,
        code="no-tooth",
    )
    require(rack.tip_radius >= 0.0, "a corner radius of {0:.6g} is none", rack.tip_radius, code="tip-radius")


@record
class Gear:
    """One cylindrical gear from its generating rack, in the signs of ISO 21771.

    Parameters
    ----------
    teeth : int
        Number of teeth z, negative for an internal gear.
    module : Module
        Normal module m_n [m].
    rack : BasicRack
        The generating rack.
    helix_angle : Angle
        Helix angle β, a magnitude [rad].
    shift : Ratio
        Profile shift factor x, positive towards the tips.
    tip_change : Ratio
        Change of the addendum k in modules; negative shortens.
    """

    teeth: int
    module: Module
    rack: BasicRack
    helix_angle: Angle = 0.0
    shift: Ratio = 0.0
    tip_change: Ratio = 0.0

    @property
    def internal(self) -> bool:
        """Whether the teeth point inwards."""
        return self.teeth < 0

    @once
    def transverse_module(self) -> float:
        """m_t = m_n/cos β."""
        return self.module / cos(self.helix_angle)

    @once
    def transverse_angle(self) -> float:
        """α_t: tan α_t = tan α_n/cos β."""
        return transverse(self.rack.pressure_angle, self.helix_angle)

    @once
    def transverse_cosine(self) -> float:
        """Cos α_t, from the sides of its triangle: accurate also for steep helices."""
        if self.helix_angle == 0.0:
            return cos(self.rack.pressure_angle)
        along = cos(self.rack.pressure_angle) * cos(self.helix_angle)
        across = sin(self.rack.pressure_angle)
        return along / sqrt(across * across + along * along)

    @once
    def base_helix_angle(self) -> float:
        """β_b: sin β_b = sin β·cos α_n."""
        sine, cosine = sin(self.rack.pressure_angle), cos(self.rack.pressure_angle)
        along = cosine * cos(self.helix_angle)
        return atan2(sin(self.helix_angle) * cosine, sqrt(sine * sine + along * along))

    @once
    def reference_diameter(self) -> float:
        """Reference diameter z·m_t."""
        return self.teeth * self.transverse_module

    @once
    def base_diameter(self) -> float:
        """d_b = d·cos α_t."""
        return self.reference_diameter * self.transverse_cosine

    @once
    def tip_diameter(self) -> float:
        """d_a = d + 2 m_n (h_a* + x + k)."""
        return self.reference_diameter + 2.0 * self.module * (self.rack.addendum + self.shift + self.tip_change)

    @once
    def root_diameter(self) -> float:
        """d_f = d − 2 m_n (h_fP* − x)."""
        return self.reference_diameter - 2.0 * self.module * (self.rack.dedendum - self.shift)

    @property
    def base_pitch(self) -> float:
        """p_bt = π·m_t·cos α_t."""
        return pi_beside(self.transverse_module) * self.transverse_module * cos(self.transverse_angle)

    @once
    def base_half_angle(self) -> float:
        """ψ_b: half the angle of a tooth on the base circle; of ISO's sign, negative for an internal gear."""
        across = 0.5 * pi_beside(self.module) + 2.0 * self.shift * tan(self.rack.pressure_angle)
        tangent = tan(self.rack.pressure_angle) / cos(self.helix_angle)
        # near 90° the tangent says more than the angle
        own = involute(self.transverse_angle) if tangent < 1.0 else tangent - atan(tangent)
        return across / self.teeth + own

    @property
    def cutter(self) -> Cutter:
        """The rack as the trochoid wants it; an internal gear has none."""
        rack = self.rack
        return Cutter(self.teeth, rack.pressure_angle, self.helix_angle, self.shift, rack.dedendum, rack.tip_radius)

    def roll(self, diameter: float) -> float:
        """Roll angle tan α_y at a diameter, √((d_y/d_b)² − 1), with nothing lost near the base circle."""
        base = self.base_diameter
        require(
            absolute(diameter) >= absolute(base),
            "there is no involute at a diameter of {0:.9g} mm: the base circle has {1:.9g} mm",
            1e3 * absolute(diameter),
            1e3 * absolute(base),
            code="inside-base-circle",
        )
        return sqrt((diameter - base) * (diameter + base)) / absolute(base)

    @once
    def tip_roll(self) -> float:
        """Roll angle at the tip from q = d_a/d: √((q − c)(q + c))/c with c = cos α_t and q − c free of cancellation."""
        height = self.rack.addendum + self.shift + self.tip_change
        rise = 2.0 * cos(self.helix_angle) * height / self.teeth
        angle = self.transverse_angle
        cosine, half = cos(angle), sin(0.5 * angle)
        above = rise + 2.0 * half * half
        require(
            above >= 0.0,
            "the tips at {0:.9g} mm diameter lie inside the base circle of {1:.9g} mm, where there is no involute",
            1e3 * absolute(self.tip_diameter),
            1e3 * absolute(self.base_diameter),
            code="tip-inside-base",
            hint="an internal gear needs more teeth, a lower addendum or shortened tips; an external one more shift",
        )
        return sqrt(above * (1.0 + rise + cosine)) / cosine

    @property
    def tip_thickness(self) -> float:
        """Transverse tooth thickness s_at along the tip circle."""
        from dynamics_cli.gear.trochoid import roll_less_arc

        return self.tip_diameter * (self.base_half_angle - roll_less_arc(self.tip_roll))

    def thickness(self, diameter: float) -> float:
        """Transverse tooth thickness along the circle of a diameter: s_yt = d_y (ψ_b − inv α_y)."""
        from dynamics_cli.gear.trochoid import roll_less_arc

        return diameter * (self.base_half_angle - roll_less_arc(self.roll(diameter)))


def module_of(pitch: "Pitch", helix_angle: float) -> float:
    """The normal module of what was given; refuses a size no gear has, where doubles would leave their range."""
    lean = absolute(helix_angle)
    require(lean < 0.5 * pi, "a helix angle of {0:.6g} rad never winds", helix_angle, code="helix-angle")
    module = pitch.normal(cos(lean))
    require(
        (module > SMALLEST) & (module < LARGEST),
        "a module of {0:.6g} mm makes no teeth",
        1e3 * module,
        code="module",
        hint="modules from 1e-9 mm to 1e6 mm are taken",
    )
    return module


def signed_gear(
    teeth: int,
    module: float,
    rack: BasicRack,
    *,
    internal: bool = False,
    sign: str = "iso",
    helix_angle: float = 0.0,
    shift: float = 0.0,
    tip_change: float = 0.0,
) -> Gear:
    """A gear from numbers in the user's convention; `tip_change` is in modules and negative shortens."""
    require(teeth >= 1, "{0} teeth make no gear", teeth, code="teeth")
    lean = absolute(helix_angle)
    require(lean < 0.5 * pi, "a helix angle of {0:.6g} rad never winds", helix_angle, code="helix-angle")
    own = -shift if internal and sign == "outward" else shift
    gear = Gear(-teeth if internal else teeth, module, rack, lean, own, tip_change)
    require_circles(gear)
    return gear


def require_circles(gear: Gear) -> None:
    """Refuse a gear whose tip and root circles are not in order about its centre."""
    least, name = (gear.tip_diameter, "tip") if gear.internal else (gear.root_diameter, "root")
    way = -1.0 if gear.internal else 1.0
    require(
        way * least > 0.0,
        "the {0} circle would have a diameter of {1:.6g} mm",
        name,
        1e3 * way * least,
        code="no-root",
        hint="raise the number of teeth or the profile shift",
    )
    require(
        gear.tip_diameter > gear.root_diameter,
        "the tips at {0:.6g} mm diameter do not rise above the root at {1:.6g} mm",
        1e3 * absolute(gear.tip_diameter),
        1e3 * absolute(gear.root_diameter),
        code="no-tooth",
        hint="shorten the tips less",
    )


def module_advice(pitch: object, module: float) -> tuple[Advice, ...]:
    """Name the standard module when the one asked for is off the series of ISO 54."""
    if not isinstance(pitch, NormalModule):
        return ()
    size = getattr(module, "value", module)
    if hasattr(size, "ndim") or not 0.9e-3 < size < 60e-3:
        return ()
    own = 1e3 * size
    if any(abs(own - standard) <= 1e-9 * own for standard in (*SERIES_I, *SERIES_II)):
        return ()
    first = min(SERIES_I, key=lambda standard: abs(standard - own))
    second = min((*SERIES_I, *SERIES_II), key=lambda standard: abs(standard - own))
    # no-break spaces: the series are in millimetres, whatever the inputs are in
    also = "" if first == second else f", or {second:g}\u00a0mm of series II"
    return (
        Advice(
            code="off-series",
            message=f"a module of {own:.6g} mm is in neither series of ISO 54",
            severity="note",
            mend=f"the nearest is {first:g}\u00a0mm of series I{also}",
        ),
    )
