"""The proof of a mesh: both exact profiles turned through it, with what they really do."""

from math import pi

from dynamics_cli.errors import require
from dynamics_cli.gear.contact import Path, half_play, path_of_contact, tips_pass, transmission_error, turning_bound
from dynamics_cli.gear.door import gear_of
from dynamics_cli.gear.flanks import ToothForm
from dynamics_cli.gear.gear import FULL_DEPTH, Pitch, Sign
from dynamics_cli.gear.gear import Profile as BasicProfile
from dynamics_cli.gear.mesh_advice import EXACT, OVERLAP, advice, tip_notes, tips_meet
from dynamics_cli.gear.profile import tooth_form
from dynamics_cli.gear.room import flank_gap
from dynamics_cli.gear.root_gap import root_gap
from dynamics_cli.gear.rounding import bare, carried, error_of, share, width
from dynamics_cli.numerics.elementary import absolute, cos, maximum, minimum, tan
from dynamics_cli.numerics.involute import inverse_involute
from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF
from dynamics_cli.quantities import Angle, Coordinate, Count, Ratio, Size, Text
from dynamics_cli.records import Advice, Check, Columns, ErrorBound, Numerics, record

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
    forms = forms_of(
        **carried(
            {
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
        )
    )
    distance = carried(centre_distance)
    if distance is None:
        distance = without_backlash(*forms)
    bare_tips = first_tip_diameter is None and second_tip_diameter is None and not internal
    return _proof(forms, distance, points, shown, bare_tips)


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
    if second.internal:
        value = (second.teeth * second.half_base - first.teeth * first.half_base) / (second.teeth - first.teeth)
    else:
        value = (first.teeth * first.half_base + second.teeth * second.half_base - pi) / (first.teeth + second.teeth)
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


def _proof(
    carried_forms: tuple[ToothForm, ToothForm], distance: float, points: int, shown: int, bare_tips: bool
) -> MeshProof:
    """The proof, of forms whose numbers carry rounding bounds; turned in plain doubles."""
    import numpy as np

    path = path_of_contact(*carried_forms, distance)
    _require_contact(path)
    known = _Known(*carried_forms, distance, path)
    first, second, apart, plain = bare(carried_forms[0]), bare(carried_forms[1]), bare(distance), bare(path)
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
        path=_points(first, second, plain, lengths[picks], error[picks]),
        checks=(Check("conjugate action", worst <= EXACT, worst, EXACT),),
        advice=advice(plain, found["contact_ratio"], found["backlash"], overlaps, clearances, first)
        + (tips_meet(trimmed) if trims else ())
        + notes,
        numerics=_numerics(known, plain, turning_bound(first, second, plain)),
    )


class _Known:
    """What is known of a mesh in closed form, in numbers that carry rounding bounds."""

    def __init__(self, first: ToothForm, second: ToothForm, distance: float, path: Path) -> None:
        self.first, self.second, self.path = first, second, path
        play = half_play(first, second, path)
        self.backlash = 2.0 * play * second.base
        self.play = maximum(play, 0.0)
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
        # where an involute gets to where the other begins, they touch there by design, or jam
        touch = minimum(0.5 * self.backlash, 0.0)
        self.inward = root_gap(first, second, distance, self.play, touch if path.end < path.tip_end else None)
        turned = self.play * (second.teeth / first.teeth)
        self.outward = root_gap(second, first, distance, turned, touch if path.start > path.tip_start else None)


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


def _numerics(known: _Known, plain: Path, turning: float) -> Numerics:
    """The bounds: of lengths and ratios as shares of them, of differences in metres."""
    differences = ("backlash", "first_tip_clearance", "second_tip_clearance")
    bounds = [
        width(name, value) if name in differences else share(name, value) for name, value in known.results.items()
    ]
    for name, gap in (("first_in_second", known.inward), ("second_in_first", known.outward)):
        if gap is not None:
            bounds.append(width(name, gap))
    path, first, second = known.path, known.first, known.second
    # points stand at equal steps from the start of contact to its end
    ends = max(error_of(path.start), error_of(path.end)) + 4.0 * UNIT_ROUNDOFF * max(abs(plain.start), abs(plain.end))
    pitch_point = first.base * tan(path.pressure_angle)
    other = ends + error_of(path.total) + UNIT_ROUNDOFF * (plain.total + abs(plain.end))
    bounds += (
        # they are none at all; what is found is rounding
        ErrorBound("transmission_error", turning, relative=False),
        width("path.along", pitch_point, ends + UNIT_ROUNDOFF * max(plain.end, bare(pitch_point))),
        ErrorBound("path.first_diameter", _diameter_bound(first.base, plain.end, ends), relative=False),
        ErrorBound(
            "path.second_diameter", _diameter_bound(second.base, plain.total + plain.end, other), relative=False
        ),
        ErrorBound("path.error", turning, relative=False),
    )
    return Numerics("closed forms that carry rounding bounds; profiles turned point by point", tuple(bounds))


def _diameter_bound(base: float, length: float, error: float) -> float:
    """Of 2·√(r_b² + l²), by the largest l."""
    return 2.0 * (error_of(base) + error + 2.0 * UNIT_ROUNDOFF * (bare(base) + abs(length)))
