"""The proof of a mesh: both exact profiles turned through it, with what they really do."""

from dynamics_cli.errors import require
from dynamics_cli.gear.contact import Path, half_play, path_of_contact, tips_pass, transmission_error
from dynamics_cli.gear.door import gear_of
from dynamics_cli.gear.flanks import ToothForm
from dynamics_cli.gear.gear import FULL_DEPTH, Pitch, Sign
from dynamics_cli.gear.gear import Profile as BasicProfile
from dynamics_cli.gear.mesh_advice import EXACT, OVERLAP, advice, tip_notes, tips_meet
from dynamics_cli.gear.mesh_bounds import mesh_numerics
from dynamics_cli.gear.profile import tooth_form
from dynamics_cli.gear.room import flank_gap
from dynamics_cli.gear.root_gap import least_places, root_gap
from dynamics_cli.gear.rounding import bare, carried, in_digits, in_many_digits, tighten
from dynamics_cli.numerics.elementary import absolute, cos, maximum, minimum, pi_beside, tan
from dynamics_cli.numerics.involute import inverse_involute
from dynamics_cli.quantities import Angle, Coordinate, Count, Ratio, Size, Text
from dynamics_cli.records import Advice, Check, Columns, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

FULL = BasicProfile("a")
ISO = Sign("iso")
MOST_POINTS = 10_000_000
# Chords of the sampled flanks overlap by less than this share of the module where they touch.
TRIMS = 1e-4


@record
class ContactPoint:
    """A point of contact.

    Parameters
    ----------
    along : Coordinate
        Its place on the line of action, from the pitch point, positive towards recess [m].
    first_diameter : Size
        Diameter of gear 1 that touches there [m].
    second_diameter : Size
        Diameter of gear 2 that touches there [m].
    error : Angle
        What gear 2 is ahead of the exact ratio [rad].
    """

    along: Coordinate
    first_diameter: Size
    second_diameter: Size
    error: Angle


@record
class MeshProof:
    """What two profiles do in mesh.

    Parameters
    ----------
    centre_distance : Size
        Centre distance [m].
    working_pressure_angle : Angle
        Transverse working pressure angle [rad].
    contact_ratio : Ratio
        Transverse contact ratio of the involutes that are really there, between form circles and tips.
    nominal_contact_ratio : Ratio
        The same by the tip circles alone.
    begins_at : Text
        What begins the contact.
    ends_at : Text
        What ends it.
    transmission_error : Angle
        Largest angle that gear 2 is off the exact ratio, over the whole path of contact [rad].
    contact_points : Count
        Points of contact that were looked at.
    backlash : Coordinate
        Transverse backlash along the line of action; negative when the teeth jam [m].
    first_in_second : Coordinate
        Least distance of gear 1's teeth from the root of gear 2's spaces; negative when they overlap [m].
    second_in_first : Coordinate
        Least distance of gear 2's teeth from the root of gear 1's spaces [m].
    first_tip_clearance : Coordinate
        From the tips of gear 1 to the root circle of gear 2 [m].
    second_tip_clearance : Coordinate
        From the tips of gear 2 to the root circle of gear 1 [m].
    runs : bool
        Whether the pair runs: contact without a gap, no jam, no overlap.
    path : Columns of ContactPoint
        Some of the points of contact.
    """

    centre_distance: Size
    working_pressure_angle: Angle
    contact_ratio: Ratio
    nominal_contact_ratio: Ratio
    begins_at: Text
    ends_at: Text
    transmission_error: Angle
    contact_points: Count
    backlash: Coordinate
    first_in_second: Coordinate | None
    second_in_first: Coordinate | None
    first_tip_clearance: Coordinate
    second_tip_clearance: Coordinate
    runs: bool
    path: Columns[ContactPoint]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def mesh(
    *,
    first_teeth: Count,
    second_teeth: Count,
    pitch: Pitch,
    centre_distance: Size | None = None,
    internal: bool = False,
    profile: BasicProfile = FULL,
    pressure_angle: Angle = FULL_DEPTH,
    helix_angle: Angle = 0.0,
    first_profile_shift: Ratio = 0.0,
    second_profile_shift: Ratio = 0.0,
    shift_sign: Sign = ISO,
    addendum_factor: Ratio | None = None,
    dedendum_factor: Ratio | None = None,
    root_radius_factor: Ratio | None = None,
    first_tip_diameter: Size | None = None,
    second_tip_diameter: Size | None = None,
    points: Count = 100000,
    shown: Count = 11,
) -> MeshProof:
    """Turn two exact profiles through their mesh: transmission error, least clearances, real contact ratio.

    Equation
    --------
    At each point of the line of action both gears are turned until their flanks pass through it; gear 2's angle is held
    against z₁/z₂ times gear 1's. Distances from a root: the edge of a tooth's tip against trochoid or fillet and where
    the flank begins, where the normal passes through the pitch point; tips against the root circle.

    Parameters
    ----------
    first_teeth : Count
        Teeth of gear 1, which drives.
    second_teeth : Count
        Teeth of gear 2.
    pitch : Pitch
        Module, diametral pitch or circular pitch, normal or transverse.
    centre_distance : Size
        Centre distance; without backlash unless given [m].
    internal : bool
        Whether gear 2 is an internal gear.
    profile : Profile
        Basic rack: a, b, c, d of ISO 53, stub, agma-coarse or agma-fine.
    pressure_angle : Angle
        Normal pressure angle [rad].
    helix_angle : Angle
        Helix angle [rad].
    first_profile_shift : Ratio
        Profile shift factor of gear 1.
    second_profile_shift : Ratio
        Profile shift factor of gear 2.
    shift_sign : Sign
        Whose sign the profile shift of an internal gear has: iso (towards the tips) or outward (KHK, JIS).
    addendum_factor : Ratio
        Addendum in modules, in place of the basic rack's.
    dedendum_factor : Ratio
        Dedendum in modules, in place of the basic rack's.
    root_radius_factor : Ratio
        Radius of the rack's corner in modules; of an internal gear's fillet (0.2 unless given).
    first_tip_diameter : Size
        Tip diameter of gear 1, where it is not that of the rack [m].
    second_tip_diameter : Size
        Tip diameter of gear 2, where it is not that of the rack [m].
    points : Count
        Points of contact to look at.
    shown : Count
        How many of them to show.

    Returns
    -------
    MeshProof
        What the profiles do, and whether the pair runs.

    Raises
    ------
    InadmissibleError
        When the base circles do not leave room, or no involutes meet at all.

    Notes
    -----
    Transverse profiles of gears on parallel axes, rigid and exact. Distances from the roots are those of the exact
    profiles; overlaps below a millionth of a module do not keep a pair from running. Only whether tips trim flanks
    beside the line of action is sampled.

    References
    ----------
    ISO 21771 (line of action, contact ratio, interference).

    Examples
    --------
    >>> from dynamics_cli.gear.gear import NormalModule
    >>> round(mesh(first_teeth=20, second_teeth=20, pitch=NormalModule(0.001)).contact_ratio, 4)
    1.5568
    """
    require(points >= 2, "{0} points of contact prove nothing", points, code="points", hint="give 2 at least")
    require(points <= MOST_POINTS, "{0} points are too many", points, code="points")
    given = {
        "first_teeth": first_teeth,
        "second_teeth": second_teeth,
        "pitch": pitch,
        "internal": internal,
        "profile": profile,
        "pressure_angle": pressure_angle,
        "helix_angle": helix_angle,
        "first_profile_shift": first_profile_shift,
        "second_profile_shift": second_profile_shift,
        "shift_sign": shift_sign,
        "addendum_factor": addendum_factor,
        "dedendum_factor": dedendum_factor,
        "root_radius_factor": root_radius_factor,
        "first_tip_diameter": first_tip_diameter,
        "second_tip_diameter": second_tip_diameter,
    }
    known = _Known(carried(given), carried(centre_distance))
    exact = in_digits(lambda: _Known(in_many_digits(given), in_many_digits(centre_distance), known.places))
    if exact is not None:
        tighten(known.numbers(), exact.numbers())
    bare_tips = first_tip_diameter is None and second_tip_diameter is None and not internal
    return _proof(known, exact, points, shown, bare_tips)


def forms_of(
    *,
    first_teeth: int,
    second_teeth: int,
    first_profile_shift: float,
    second_profile_shift: float,
    internal: bool,
    shift_sign: str,
    root_radius_factor: float | None,
    first_tip_diameter: float | None,
    second_tip_diameter: float | None,
    **common: "Any",
) -> tuple[ToothForm, ToothForm]:
    """Both profiles; what they have in common is given once."""
    common = {**common, "root_radius_factor": root_radius_factor, "sign": shift_sign}
    one = gear_of(teeth=first_teeth, profile_shift=first_profile_shift, internal=False, **common)
    two = gear_of(teeth=second_teeth, profile_shift=second_profile_shift, internal=internal, **common)
    return tooth_form(one, first_tip_diameter, root_radius_factor), tooth_form(
        two, second_tip_diameter, root_radius_factor
    )


def without_backlash(first: ToothForm, second: ToothForm) -> float:
    """The centre distance at which the flanks touch on both sides: thicknesses and pitch on the working circles."""
    sign = -1.0 if second.internal else 1.0
    total = first.teeth + sign * second.teeth
    thick = first.teeth * first.half_base + sign * (second.teeth * second.half_base)
    value = (thick if second.internal else thick - pi_beside(thick)) / total
    require(
        value >= 0.0,
        "inv α_w would be {0:.6g}: these gears cannot mesh without backlash",
        value,
        code="no-working-angle",
        hint="raise the sum of the profile shifts",
    )
    return absolute(first.base + sign * second.base) / cos(inverse_involute(value))


def _require_contact(path: Path) -> None:
    require(
        path.end > path.start,
        "no involutes meet: contact would begin at {0:.6g} mm and end at {1:.6g} mm along the line of action",
        1e3 * path.start,
        1e3 * path.end,
        code="open-mesh",
        hint="bring the gears closer together, or give them higher teeth",
    )


def _proof(known: "_Known", exact: "_Known | None", points: int, shown: int, bare_tips: bool) -> MeshProof:
    """The proof, of numbers that carry rounding bounds; turned in plain doubles."""
    import numpy as np

    first, second, plain = bare(known.first), bare(known.second), bare(known.path)
    apart = bare(known.results["centre_distance"])
    lengths, error = transmission_error(first, second, apart, plain, points)
    worst = float(np.max(np.abs(error)))
    jammed = max(0.0, -bare(known.backlash))
    trimmed = max(
        0.0, -_beside(first, second, apart, bare(known.play)) - jammed, -tips_pass(first, second, apart) - EXACT
    )
    trims = trimmed > TRIMS * first.module or tips_pass(first, second, apart) < -EXACT
    found = {name: bare(value) for name, value in known.results.items()}
    gaps = {"gear 1 in the root of gear 2": known.inward, "gear 2 in the root of gear 1": known.outward}
    overlaps = {where: bare(gap) for where, gap in gaps.items() if gap is not None}
    clearances = found["first_tip_clearance"], found["second_tip_clearance"]
    room = min((*overlaps.values(), *clearances)) >= -OVERLAP * first.module
    runs = found["contact_ratio"] >= 1.0 and found["backlash"] >= -EXACT * apart and room and not trims
    picks = np.unique(np.linspace(0, len(lengths) - 1, max(2, min(shown, len(lengths)))).astype(int))
    path = _points(first, second, plain, lengths[picks], error[picks])
    shares = len(lengths) - 1, picks.tolist()
    notes = tip_notes(first, second, apart) if bare_tips else ()
    return MeshProof(
        **found,
        begins_at="tip of gear 2" if plain.start == plain.tip_start else "form circle of gear 1",
        ends_at="tip of gear 1" if plain.end == plain.tip_end else "form circle of gear 2",
        transmission_error=worst,
        contact_points=len(lengths),
        first_in_second=bare(known.inward),
        second_in_first=bare(known.outward),
        runs=runs,
        path=path,
        checks=(Check("conjugate action", worst <= EXACT, worst, EXACT),),
        advice=advice(plain, found["contact_ratio"], found["backlash"], overlaps, clearances, first)
        + (tips_meet(trimmed) if trims else ())
        + notes,
        numerics=mesh_numerics(known, exact, worst, path.arrays, shares),
    )


class _Known:
    """What is known of a mesh in closed form, in numbers that carry rounding bounds."""

    def __init__(
        self, given: "dict[str, Any]", distance: "float | None", places: "tuple[Any, Any] | None" = None
    ) -> None:
        first, second = forms_of(**given)
        if distance is None:
            distance = without_backlash(first, second)
        path = path_of_contact(first, second, distance)
        _require_contact(path)
        self.first, self.second, self.path = first, second, path
        play = half_play(first, second, path)
        self.backlash = 2.0 * play * second.base
        self.play = maximum(play, 0.0)
        self.pitch_point = first.base * tan(path.pressure_angle)
        clearances = _tip_clearances(first, second, distance)
        self.results = {
            "centre_distance": distance,
            "working_pressure_angle": path.pressure_angle,
            "contact_ratio": (path.end - path.start) / path.pitch,
            "nominal_contact_ratio": (path.tip_end - path.tip_start) / path.pitch,
            "backlash": self.backlash,
            "first_tip_clearance": clearances[0],
            "second_tip_clearance": clearances[1],
        }
        self._gaps(distance, places)

    def _gaps(self, distance: float, places: "tuple[Any, Any] | None") -> None:
        first, second, path = self.first, self.second, self.path
        turned = self.play * (second.teeth / first.teeth)
        if places is None:
            one, two, apart = bare(first), bare(second), bare(distance)
            places = least_places(one, two, apart, bare(self.play)), least_places(two, one, apart, bare(turned))
        self.places = places
        # where an involute gets to where the other begins, they touch there by design, or jam
        touch = minimum(0.5 * self.backlash, 0.0)
        ends, begins = touch if path.end < path.tip_end else None, touch if path.start > path.tip_start else None
        into, out = places
        self.inward = None if into is None else root_gap(first, second, distance, self.play, ends, into)
        self.outward = None if out is None else root_gap(second, first, distance, turned, begins, out)

    def numbers(self) -> "list[Any]":
        """Every number whose bound is stated or goes into one."""
        path = self.path
        lengths = (path.start, path.end, path.total, self.pitch_point, self.first.base, self.second.base)
        return [*self.results.values(), self.inward, self.outward, *lengths]


def _beside(first: ToothForm, second: ToothForm, distance: float, play: float) -> float:
    """The least distance of either gear's teeth from the other's flanks, beside the line of action."""
    one = flank_gap(first, second, distance, play)
    return min(one, flank_gap(second, first, distance, play * second.teeth / first.teeth))


def _tip_clearances(first: ToothForm, second: ToothForm, distance: float) -> tuple[float, float]:
    if second.internal:
        return second.root - distance - first.tip, second.tip - distance - first.root
    return distance - first.tip - second.root, distance - second.tip - first.root


def _points(first: ToothForm, second: ToothForm, path: Path, lengths: object, error: object) -> Columns[ContactPoint]:
    import numpy as np

    own: np.ndarray = lengths  # type: ignore[assignment]
    other = own + path.total if second.internal else path.total - own
    return Columns(
        ContactPoint,
        along=own - first.base * tan(path.pressure_angle),
        first_diameter=2.0 * np.hypot(first.base, own),
        second_diameter=2.0 * np.hypot(second.base, other),
        error=error,
    )
