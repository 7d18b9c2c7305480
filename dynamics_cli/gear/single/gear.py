"""One gear as its generating rack makes it: everything else in the family stands on this record.

Signs are those of ISO 21771: an internal gear has a negative number of teeth, and with it negative diameters, so that
one set of formulas serves both. The user's convention is converted on entry (`Sign`, `signed_gear`), and
lengths are given back as magnitudes.
"""

from math import pi

from dynamics_cli.errors import require
from dynamics_cli.gear.single.rack import BasicRack
from dynamics_cli.gear.single.toothing import once
from dynamics_cli.gear.single.trochoid import Cutter, transverse
from dynamics_cli.numerics.elementary import absolute, atan, atan2, cos, pi_beside, sin, sqrt, tan
from dynamics_cli.numerics.involute import involute
from dynamics_cli.numerics.number import like
from dynamics_cli.quantities import Angle, Annotated, Module, Ratio, Size
from dynamics_cli.records import Choice, record

# Of closed forms, and of what is followed tooth by tooth or point by point.
MOST_TEETH, MOST_FOLLOWED = 1_000_000_000, 1_000_000


class Hand(Choice):
    """Hand of a helix: which way a tooth leans as it goes away from the eye."""

    names = ("right", "left")
    aliases = {"r": "right", "rh": "right", "right-hand": "right", "l": "left", "lh": "left", "left-hand": "left"}  # noqa: RUF012


class Sign(Choice):
    """Whose sign the profile shift of an internal gear has: ISO's (towards the tip), or outward as KHK and JIS."""

    names = ("iso", "outward")
    aliases = {"iso-21771": "iso", "din": "iso", "khk": "outward", "jis": "outward", "agma": "outward"}  # noqa: RUF012


@record
class Gear:
    """One cylindrical gear from its generating rack, in the signs of ISO 21771."""

    teeth: Annotated[int, "Number of teeth z, negative for an internal gear."]
    module: Annotated[Module, "Normal module m_n [m]."]
    rack: Annotated[BasicRack, "The generating rack."]
    helix_angle: Annotated[Angle, "Helix angle β, a magnitude [rad]."] = 0.0
    shift: Annotated[Ratio, "Profile shift factor x, positive towards the tips."] = 0.0
    tip_change: Annotated[Ratio, "Change of the addendum k in modules; negative shortens."] = 0.0

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
            "there is no involute at a diameter of {diameter:9}: the base circle has {base:9}",
            diameter=(absolute(diameter), Size),
            base=(absolute(base), Size),
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
            "the tips at {tip_diameter:9} diameter lie inside the base circle of {base_diameter:9}, where there "
            "is no involute",
            tip_diameter=(absolute(self.tip_diameter), Size),
            base_diameter=(absolute(self.base_diameter), Size),
            code="tip-inside-base",
            hint="an internal gear needs more teeth, a lower addendum or shortened tips; an external one more shift",
        )
        return sqrt(above * (1.0 + rise + cosine)) / cosine

    @property
    def tip_thickness(self) -> float:
        """Transverse tooth thickness s_at along the tip circle."""
        from dynamics_cli.gear.single.trochoid import roll_less_arc

        return self.tip_diameter * (self.base_half_angle - roll_less_arc(self.tip_roll))

    def thickness(self, diameter: float) -> float:
        """Transverse tooth thickness along the circle of a diameter: s_yt = d_y (ψ_b − inv α_y)."""
        from dynamics_cli.gear.single.trochoid import roll_less_arc

        return diameter * (self.base_half_angle - roll_less_arc(self.roll(diameter)))


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
    require(teeth >= 1, "read {teeth} teeth, wanted at least 1", teeth=teeth, code="teeth")
    require_number(teeth, MOST_TEETH)
    lean = absolute(helix_angle)
    require(
        lean < 0.5 * pi,
        "the helix angle is {helix_angle:6}; it must be below 90 degrees",
        helix_angle=(helix_angle, Angle),
        code="helix-angle",
    )
    own = -shift if internal and sign == "outward" else shift
    # what was not given is a double that rounds in every formula as the given numbers do
    rack = BasicRack(*(like(value, module) for value in rack.__dict__.values()))
    gear = Gear(-teeth if internal else teeth, module, rack, lean, own, tip_change)
    require_circles(gear)
    return gear


def require_number(teeth: int, most: int) -> None:
    """Refuse more teeth than any gear has."""
    require(
        teeth <= most,
        "{teeth} teeth are too many: at most {most} are taken",
        teeth=teeth,
        most=most,
        code="too-many-teeth",
    )


def require_circles(gear: Gear) -> None:
    """Refuse a gear whose tip and root circles are not in order about its centre."""
    least, name = (gear.tip_diameter, "tip") if gear.internal else (gear.root_diameter, "root")
    way = -1.0 if gear.internal else 1.0
    require(
        way * least > 0.0,
        "the {name} circle would have a diameter of {diameter:6}",
        name=name,
        diameter=(way * least, Size),
        code="no-root",
        hint="raise the number of teeth or the profile shift",
    )
    require(
        gear.tip_diameter > gear.root_diameter,
        "the tips at {tip_diameter:6} diameter do not rise above the root at {root_diameter:6}",
        tip_diameter=(absolute(gear.tip_diameter), Size),
        root_diameter=(absolute(gear.root_diameter), Size),
        code="no-tooth",
        hint="shorten the tips less",
    )
