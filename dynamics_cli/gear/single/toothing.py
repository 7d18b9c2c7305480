"""The quantities of a toothing for sizes, profiles and meshes, transverse and in metres."""

from dynamics_cli.gear.single.trochoid import transverse
from dynamics_cli.numerics.elementary import cos, maximum, pi_beside, sin, sqrt
from dynamics_cli.numerics.involute import involute
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from functools import cached_property

    once = cached_property
else:
    # importing functools would cost a shell user more than it saves; a tracked number costs a thousand times a float.
    class once:  # noqa: N801
        """A property that is calculated once."""

        def __init__(self, method):
            self.method = method
            self.name = method.__name__
            self.__doc__ = method.__doc__

        def __get__(self, instance, owner):
            if instance is None:
                return self
            value = instance.__dict__[self.name] = self.method(instance)
            return value


@record
class Toothing:
    """An involute toothing."""

    teeth: Annotated[int, "Number of teeth."]
    internal: Annotated[bool, "Whether the teeth point inwards."]
    module: Annotated[float, "Normal module [m]."]
    pressure_angle: Annotated[float, "Normal pressure angle [rad]."]
    helix_angle: Annotated[float, "Helix angle [rad]."]
    shift: Annotated[float, "Profile shift factor, positive outwards for an internal gear too (the sign of KHK)."]
    tip: Annotated[float, "Tip radius [m]."]
    root: Annotated[float, "Root radius [m]."]
    form: Annotated[float | None, "Radius where the involute begins above the root, where it is known [m]."] = None

    @once
    def transverse_angle(self) -> float:
        """Transverse pressure angle α_t."""
        return transverse(self.pressure_angle, self.helix_angle)

    @once
    def pitch_radius(self) -> float:
        """Pitch radius r."""
        return self.teeth * self.module / (2.0 * cos(self.helix_angle))

    @once
    def base_radius(self) -> float:
        """Base radius r_b."""
        return self.pitch_radius * cos(self.transverse_angle)

    @once
    def shifted_roll(self) -> float:
        """Roll angle tan α at d + 2xm; how far that lies above the base circle is a sum, not a difference of radii."""
        half = sin(0.5 * self.transverse_angle)
        above = maximum(2.0 * self.pitch_radius * half * half + self.shift * self.module, 0.0)
        return sqrt(above * (2.0 * self.base_radius + above)) / self.base_radius

    @once
    def base_helix_cosine(self) -> float:
        """The cosine of the base helix angle, cos β_b = √(1 − (sin β cos α_n)²)."""
        across = sin(self.helix_angle) * cos(self.pressure_angle)
        return sqrt((1.0 - across) * (1.0 + across))

    @once
    def pitch_involute(self) -> float:
        """The involute of the pressure angle, inv α_t."""
        return involute(self.transverse_angle)

    @once
    def shift_angle(self) -> float:
        """2 x tan α_n/z: the profile shift's addition to half the tooth (half the space of an internal gear)."""
        return 2.0 * self.shift * sin(self.pressure_angle) / (cos(self.pressure_angle) * self.teeth)

    @once
    def solid_half(self) -> float:
        """Half angle at the base circle between the involutes: of the tooth, or an internal gear's space."""
        return 0.5 * pi_beside(self.shift_angle) / self.teeth + self.shift_angle + self.pitch_involute

    @once
    def hollow_half(self) -> float:
        """Half angle at the base circle of the gap: of the space, or an internal gear's tooth."""
        return 0.5 * pi_beside(self.shift_angle) / self.teeth - self.shift_angle - self.pitch_involute
