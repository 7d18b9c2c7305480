"""Two cylindrical gears in mesh: working pressure angle, centre distance, and the path of contact, in ISO's signs."""

from math import pi

from dynamics_cli.errors import require
from dynamics_cli.gear.gear import Gear
from dynamics_cli.gear.limits import plain
from dynamics_cli.gear.trochoid import root
from dynamics_cli.numerics.elementary import absolute, atan2, cos, pi_beside, sin, sqrt, tan
from dynamics_cli.numerics.involute import inverse_involute, involute
from dynamics_cli.quantities import Angle, Size
from dynamics_cli.records import record


@record
class Engagement:
    """Two gears at a centre distance.

    Parameters
    ----------
    first : Gear
        The driving gear.
    second : Gear
        The driven gear; internal when its number of teeth is negative.
    centre_distance : Size
        Working centre distance a_w, negative with an internal gear [m].
    angle : Angle
        Working transverse pressure angle α_wt [rad].
    tight_angle : Angle
        The working pressure angle at which the gears would mesh without backlash [rad].
    """

    first: Gear
    second: Gear
    centre_distance: Size
    angle: Angle
    tight_angle: Angle

    @property
    def ratio(self) -> float:
        """z₂/z₁, negative with an internal gear."""
        return self.second.teeth / self.first.teeth

    @property
    def line(self) -> float:
        """Length of the line of action between the base circles, a_w sin α_wt, with the sign of a_w."""
        return self.centre_distance * sin(self.angle)

    @property
    def pitch_curvature(self) -> float:
        """Radius of curvature of the first gear's flank at the pitch point, r_b1 tan α_wt."""
        return 0.5 * self.first.base_diameter * sin(self.angle) / cos(self.angle)

    def working_diameter(self, gear: Gear) -> float:
        """Working pitch diameter, 2 a_w z/(z₁ + z₂)."""
        return 2.0 * self.centre_distance * gear.teeth / (self.first.teeth + self.second.teeth)

    @property
    def backlash(self) -> float:
        """Circumferential backlash on the working pitch circle without allowances, 2a_w(inv α_wt − inv α_tight)."""
        return 2.0 * self.centre_distance * (involute(self.angle) - involute(self.tight_angle))


def reference_distance(first: Gear, second: Gear) -> float:
    """Sum of the reference radii, negative with an internal gear."""
    return 0.5 * (first.reference_diameter + second.reference_diameter)


def require_partners(first: Gear, second: Gear) -> None:
    """Refuse gears that cannot stand side by side or one in the other."""
    require(
        not second.internal or -second.teeth > first.teeth,
        "a pinion of {0} teeth does not go into a ring of {1}",
        first.teeth,
        abs(second.teeth),
        code="ring-too-small",
        hint="the internal gear needs more teeth than its pinion",
    )


def tight_involute(first: Gear, second: Gear) -> float:
    """Involute of α_wt without backlash: inv α_t + 2(x₁ + x₂) tan α_n/(z₁ + z₂); refused where it is negative."""
    total = first.teeth + second.teeth
    own = involute(first.transverse_angle)
    value = own + 2.0 * (first.shift + second.shift) * tan(first.rack.pressure_angle) / total
    least = plain(-own * total / (2.0 * tan(first.rack.pressure_angle)))
    require(
        value >= 0.0,
        "inv α_w would be {0:.6g}, below 0: the profile shifts sum to {1:.6g}, and these gears mesh only {2} {3:.6g}",
        value,
        plain(first.shift + second.shift),
        "from" if total > 0 else "up to",
        least,
        code="involute-below-zero",
        hint=f"change the sum of the profile shifts by {least - plain(first.shift + second.shift):.6g}",
    )
    return value


def at_tight_distance(first: Gear, second: Gear) -> Engagement:
    """The engagement without backlash."""
    require_partners(first, second)
    angle = inverse_involute(tight_involute(first, second))
    distance = reference_distance(first, second) * cos(first.transverse_angle) / cos(angle)
    return Engagement(first, second, distance, angle, angle)


def angle_at(first: Gear, second: Gear, distance: float) -> float:
    """α_wt at a centre distance in ISO's sign: cos α_wt = a cos α_t/a_w, as the angle of a right triangle."""
    base = reference_distance(first, second) * cos(first.transverse_angle)
    square = (distance - base) * (distance + base)
    require(
        square >= 0.0,
        "the centre distance {0:.9g} mm is less than that of the base circles, {1:.9g} mm",
        1e3 * absolute(distance),
        1e3 * absolute(base),
        code="centre-distance",
        hint="raise the centre distance",
    )
    return atan2(sqrt(square), absolute(base))


def needed_shift(first: Gear, second: Gear, angle: float) -> float:
    """Sum of the profile shift factors for no backlash at α_wt."""
    turn = involute(angle) - involute(first.transverse_angle)
    return 0.5 * (first.teeth + second.teeth) * turn / tan(first.rack.pressure_angle)


def with_shift(gear: Gear, shift: float, tip_change: float = 0.0) -> Gear:
    """The gear with another shift and another change of its tips."""
    return Gear(gear.teeth, gear.module, gear.rack, gear.helix_angle, shift, tip_change)


@record
class Path:
    """The path of contact, as radii of curvature of the first gear's flank.

    Parameters
    ----------
    start : Size
        At A, where the tip of the second gear begins the contact [m].
    end : Size
        At E, where the tip of the first gear ends it [m].
    nominal_start : Size
        A if the first gear had an involute all the way [m].
    nominal_end : Size
        E if the second gear had one [m].
    first_form : Size
        Radius of curvature where the involute of the first gear begins [m].
    second_form : Size
        Radius of curvature where the involute of the second gear begins; None for an internal one [m].
    """

    start: Size
    end: Size
    nominal_start: Size
    nominal_end: Size
    first_form: Size
    second_form: Size | None


def path(mesh: Engagement) -> Path:
    """The path of contact, ended by the tips, and by the root form circles where a gear is undercut that far."""
    first, second = mesh.first, mesh.second
    end = 0.5 * first.base_diameter * first.tip_roll
    start = mesh.line - 0.5 * second.base_diameter * second.tip_roll
    own_form = 0.5 * first.base_diameter * root(first.cutter).roll
    other_form = None
    begin = start if plain(start) >= plain(own_form) else own_form
    stop = end
    if not second.internal:
        other_form = root(second.cutter).roll * 0.5 * second.base_diameter
        latest = mesh.line - other_form
        stop = end if plain(end) <= plain(latest) else latest
    require(
        begin < stop,
        "the gears never touch at a centre distance of {1:.9g} mm and a working pressure angle of {2:.6g} degrees: "
        "contact would begin {0:.6g} mm after it has ended",
        1e3 * plain(begin - stop),
        1e3 * abs(plain(mesh.centre_distance)),
        plain(mesh.angle) * 180.0 / pi,
        code="open-mesh",
        hint="lower the centre distance, or lengthen the tips",
    )
    return Path(begin, stop, start, end, own_form, other_form)


def contact_ratio(mesh: Engagement, start: float, end: float) -> float:
    """ε_α of a path from `start` to `end`."""
    return (end - start) / mesh.first.base_pitch


def specific_sliding(mesh: Engagement, curvature: float) -> tuple[float | None, float | None]:
    """ζ₁ and ζ₂ where the first flank has this radius of curvature, None at a base circle: sliding over own rolling."""
    other = mesh.line - curvature
    away = curvature - mesh.pitch_curvature
    # 1 + 1/u and 1 + u, from teeth: with an internal gear the ratio itself would cancel
    first, second = mesh.first.teeth, mesh.second.teeth
    both = first + second
    own = away * (both / second) / curvature if plain(curvature) > 0.0 else None
    mate = -away * (both / first) / other if plain(other) * mesh.ratio > 0.0 else None
    return own, mate


def overlap_ratio(gear: Gear, width: float) -> float:
    """ε_β = b sin β/(π m_n)."""
    return width * sin(gear.helix_angle) / (pi_beside(gear.module) * gear.module)
