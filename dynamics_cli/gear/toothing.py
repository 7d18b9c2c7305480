"""The few numbers of a toothing that measuring sizes, profiles and meshes are made of, transverse and in metres."""

from math import pi

from dynamics_cli.numerics.elementary import atan2, cos, sin, sqrt
from dynamics_cli.numerics.involute import involute
from dynamics_cli.records import record


@record
class Toothing:
    """An involute toothing.

    Parameters
    ----------
    teeth : int
        Number of teeth.
    internal : bool
        Whether the teeth point inwards.
    module : Module
        Normal module [m].
    pressure_angle : Angle
        Normal pressure angle [rad].
    helix_angle : Angle
        Helix angle [rad].
    shift : Ratio
        Profile shift factor, positive outwards for an internal gear too (the sign of KHK).
    tip : Length
        Tip radius [m].
    root : Length
        Root radius [m].
    form : Length
        Radius where the involute begins above the root, where it is known [m].
    """

    teeth: int
    internal: bool
    module: float
    pressure_angle: float
    helix_angle: float
    shift: float
    tip: float
    root: float
    form: float | None = None

    @property
    def transverse_angle(self) -> float:
        """Transverse pressure angle α_t."""
        return atan2(sin(self.pressure_angle), cos(self.pressure_angle) * cos(self.helix_angle))

    @property
    def pitch_radius(self) -> float:
        """Pitch radius r."""
        return self.teeth * self.module / (2.0 * cos(self.helix_angle))

    @property
    def base_radius(self) -> float:
        """Base radius r_b."""
        return self.pitch_radius * cos(self.transverse_angle)

    @property
    def base_helix_cosine(self) -> float:
        """The cosine of the base helix angle, cos β_b = √(1 − (sin β cos α_n)²)."""
        across = sin(self.helix_angle) * cos(self.pressure_angle)
        return sqrt((1.0 - across) * (1.0 + across))

    @property
    def pitch_involute(self) -> float:
        """The involute of the pressure angle, inv α_t."""
        return involute(self.transverse_angle)

    @property
    def shift_angle(self) -> float:
        """2 x tan α_n/z: what the profile shift adds to half the tooth (or to half the space of an internal gear)."""
        return 2.0 * self.shift * sin(self.pressure_angle) / (cos(self.pressure_angle) * self.teeth)

    @property
    def solid_half(self) -> float:
        """Half angle at the base circle of what the involutes bound: the tooth, or an internal gear's space."""
        return 0.5 * pi / self.teeth + self.shift_angle + self.pitch_involute

    @property
    def hollow_half(self) -> float:
        """Half angle at the base circle of what lies between: the space, or an internal gear's tooth."""
        return 0.5 * pi / self.teeth - self.shift_angle - self.pitch_involute
