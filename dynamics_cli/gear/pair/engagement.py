"""Two cylindrical gears in mesh: working pressure angle, centre distance, and the path of contact, in ISO's signs."""

from dynamics_cli.errors import require
from dynamics_cli.gear.mesh.profile_contact import remedy_of_open_mesh
from dynamics_cli.gear.single.gear import Gear
from dynamics_cli.numerics.elementary import absolute, atan2, cos, pi_beside, sin, sqrt, tan
from dynamics_cli.numerics.involute import inverse_involute, involute
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, Ratio, Size
from dynamics_cli.records import record


@record
class Engagement:
    """Two gears at a centre distance."""

    first: Annotated[Gear, "The driving gear."]
    second: Annotated[Gear, "The driven gear; internal when its number of teeth is negative."]
    centre_distance: Annotated[Size, "Working centre distance a_w, negative with an internal gear [m]."]
    angle: Annotated[Angle, "Working transverse pressure angle α_wt [rad]."]
    tight: Annotated[
        Ratio, "Involute of the working pressure angle without backlash; below zero at no centre distance."
    ]

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
        """Circumferential backlash on the working pitch circle without allowances, 2a_w(inv α_wt − inv α_w)."""
        return 2.0 * self.centre_distance * (involute(self.angle) - self.tight)


def reference_distance(first: Gear, second: Gear) -> float:
    """Sum of the reference radii, negative with an internal gear."""
    return 0.5 * (first.reference_diameter + second.reference_diameter)


def require_partners(first: Gear, second: Gear) -> None:
    """Refuse gears that cannot mesh, externally or internally."""
    require(
        not second.internal or -second.teeth > first.teeth,
        "a pinion of {pinion} teeth does not fit into a ring of {ring}",
        pinion=first.teeth,
        ring=abs(second.teeth),
        code="ring-too-small",
        hint="the internal gear needs more teeth than its pinion",
    )


def tight_involute(first: Gear, second: Gear) -> float:
    """Involute of α_w, the working pressure angle without backlash: inv α_t + 2(x₁ + x₂) tan α_n/(z₁ + z₂)."""
    turn = 2.0 * (first.shift + second.shift) * tan(first.rack.pressure_angle) / (first.teeth + second.teeth)
    return involute(first.transverse_angle) + turn


def _require_tight(first: Gear, second: Gear) -> float:
    """The involute of α_w; refused where it is negative."""
    total = first.teeth + second.teeth
    inv = involute(first.transverse_angle)
    value = tight_involute(first, second)
    least = plain(-inv * total / (2.0 * tan(first.rack.pressure_angle)))
    require(
        value >= 0.0,
        "inv α_w would be {involute:6}, below 0: the profile shifts add up to {shifts:6}, and these gears need "
        "{bound} {least:6}",
        involute=(value, Ratio),
        shifts=(plain(first.shift + second.shift), Ratio),
        bound="at least" if total > 0 else "at most",
        least=(least, Ratio),
        change=(least - plain(first.shift + second.shift), Ratio),
        code="involute-below-zero",
        hint="change the sum of the profile shifts by {change:6}",
    )
    return value


def at_tight_distance(first: Gear, second: Gear) -> Engagement:
    """The engagement without backlash."""
    require_partners(first, second)
    angle = inverse_involute(_require_tight(first, second))
    distance = reference_distance(first, second) * cos(first.transverse_angle) / cos(angle)
    return Engagement(first, second, distance, angle, involute(angle))


def angle_at(first: Gear, second: Gear, distance: float) -> float:
    """α_wt at a centre distance in ISO's sign: cos α_wt = a cos α_t/a_w, in a right triangle (ISO 21771)."""
    base = reference_distance(first, second) * cos(first.transverse_angle)
    square = (distance - base) * (distance + base)
    require(
        square >= 0.0,
        "the centre distance {distance:9} is less than that of the base circles, {base:9}",
        distance=(absolute(distance), Size),
        base=(absolute(base), Size),
        code="centre-distance",
        hint="raise the centre distance",
    )
    return atan2(sqrt(square), absolute(base))


def needed_shift(first: Gear, second: Gear, angle: float) -> float:
    """Sum of the profile shift factors for no backlash at α_wt."""
    turn = involute(angle) - involute(first.transverse_angle)
    return 0.5 * (first.teeth + second.teeth) * turn / tan(first.rack.pressure_angle)


@record
class Path:
    """The path of contact, as radii of curvature of the first gear's flank."""

    start: Annotated[Size, "At A, where the tip of the second gear begins the contact [m]."]
    end: Annotated[Size, "At E, where the tip of the first gear ends it [m]."]
    nominal_start: Annotated[Size, "A if the first gear had an involute all the way [m]."]
    nominal_end: Annotated[Size, "E if the second gear had one [m]."]
    first_form: Annotated[Size, "Radius of curvature where the involute of the first gear begins [m]."]
    second_form: Annotated[
        Size | None, "Radius of curvature where the involute of the second gear begins; None for an internal one [m]."
    ]


def path(mesh: Engagement) -> Path:
    """The path of contact, ended by the tips, and by the root form circles where a gear is undercut that far."""
    first, second = mesh.first, mesh.second
    end = 0.5 * first.base_diameter * first.tip_roll
    start = mesh.line - 0.5 * second.base_diameter * second.tip_roll
    own_form = 0.5 * first.base_diameter * first.junction.roll
    other_form = None
    begin = start if plain(start) >= plain(own_form) else own_form
    stop = end
    if not second.internal:
        other_form = second.junction.roll * 0.5 * second.base_diameter
        latest = mesh.line - other_form
        stop = end if plain(end) <= plain(latest) else latest
    require(
        begin < stop,
        "the gears never touch at a centre distance of {distance:9} and a working pressure angle of {angle:6}: "
        "contact would begin {gap:6} after its end",
        distance=(abs(plain(mesh.centre_distance)), Size),
        angle=(plain(mesh.angle), Angle),
        gap=(plain(begin - stop), Size),
        code="open-mesh",
        hint=remedy_of_open_mesh(plain(start) < plain(own_form), plain(stop) < plain(end)),
    )
    return Path(begin, stop, start, end, own_form, other_form)


def contact_ratio(mesh: Engagement, start: float, end: float) -> float:
    """ε_α of a path from `start` to `end`."""
    return (end - start) / mesh.first.base_pitch


def specific_sliding(mesh: Engagement, curvature: float) -> tuple[float | None, float | None]:
    """ζ₁ and ζ₂ where the first flank has this radius of curvature, None at a base circle."""
    other = mesh.line - curvature
    away = curvature - mesh.pitch_curvature
    # 1 + 1/u and 1 + u from the teeth: with an internal gear the ratio would cancel
    first, second = mesh.first.teeth, mesh.second.teeth
    total = first + second
    first_sliding = away * (total / second) / curvature if plain(curvature) > 0.0 else None
    second_sliding = -away * (total / first) / other if plain(other) * mesh.ratio > 0.0 else None
    return first_sliding, second_sliding


def overlap_ratio(gear: Gear, width: float) -> float:
    """ε_β = b sin β/(π m_n) (ISO 21771)."""
    return width * sin(gear.helix_angle) / (pi_beside(gear.module) * gear.module)
