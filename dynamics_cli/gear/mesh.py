"""The proof of a mesh: both exact profiles turned through it, with what they really do."""

from math import cos, pi, sqrt, tan

from dynamics_cli.errors import require
from dynamics_cli.gear.contact import Path, half_play, path_of_contact, tips_pass, transmission_error
from dynamics_cli.gear.door import gear_of
from dynamics_cli.gear.flanks import ToothForm
from dynamics_cli.gear.gear import FULL_DEPTH, Pitch, Sign
from dynamics_cli.gear.gear import Profile as BasicProfile
from dynamics_cli.gear.profile import tooth_form
from dynamics_cli.gear.room import least_gaps
from dynamics_cli.numerics.involute import inverse_involute
from dynamics_cli.quantities import Angle, Coordinate, Count, Ratio, Size, Text
from dynamics_cli.records import Advice, Check, Columns, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

FULL = BasicProfile("a")
ISO = Sign("iso")
MOST_POINTS = 10_000_000
EXACT = 1e-12
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
    against z₁/z₂ times gear 1's. Clearances: every point of a tooth, root trochoid and tip with it, in the space it
    turns through.

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
    Transverse profiles of gears on parallel axes, rigid and exact. Clearances are sampled: their sign is safe where
    they exceed a millionth of a module.

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
    first, second = forms_of(
        first_teeth=first_teeth,
        second_teeth=second_teeth,
        pitch=pitch,
        internal=internal,
        profile=profile,
        pressure_angle=pressure_angle,
        helix_angle=helix_angle,
        first_profile_shift=first_profile_shift,
        second_profile_shift=second_profile_shift,
        shift_sign=shift_sign,
        addendum_factor=addendum_factor,
        dedendum_factor=dedendum_factor,
        root_radius_factor=root_radius_factor,
        first_tip_diameter=first_tip_diameter,
        second_tip_diameter=second_tip_diameter,
    )
    distance = centre_distance
    if distance is None:
        distance = _without_backlash(first, second)
    path = path_of_contact(first, second, distance)
    _require_contact(path)
    bare = first_tip_diameter is None and second_tip_diameter is None and not internal
    notes = _tip_notes(first, second, distance) if bare else ()
    return _proof(first, second, distance, path, points, shown, notes)


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


def _without_backlash(first: ToothForm, second: ToothForm) -> float:
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
    return abs(first.base + sign * second.base) / cos(inverse_involute(value))


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
    first: ToothForm, second: ToothForm, distance: float, path: Path, points: int, shown: int, notes: tuple[Advice, ...]
) -> MeshProof:
    import numpy as np

    lengths, error = transmission_error(first, second, distance, path, points)
    worst = float(np.max(np.abs(error)))
    play = half_play(first, second, path)
    backlash = 2.0 * play * second.base
    inward, own = least_gaps(first, second, distance, max(play, 0.0))
    outward, other = least_gaps(second, first, distance, max(play, 0.0) * second.teeth / first.teeth)
    # a jam makes the flanks overlap by itself
    trimmed = max(0.0, -min(own, other) - max(0.0, -backlash), -tips_pass(first, second, distance) - EXACT)
    clearances = _tip_clearances(first, second, distance)
    ratio = (path.end - path.start) / path.pitch
    jam = -EXACT * distance
    room = -1e-6 * first.module
    gaps = {"gear 1 in the root of gear 2": inward, "gear 2 in the root of gear 1": outward}
    trims = trimmed > TRIMS * first.module or tips_pass(first, second, distance) < -EXACT
    runs = ratio >= 1.0 and backlash >= jam and min(inward, outward, *clearances) >= room and not trims
    picks = np.unique(np.linspace(0, len(lengths) - 1, max(2, min(shown, len(lengths)))).astype(int))
    return MeshProof(
        centre_distance=distance,
        working_pressure_angle=path.pressure_angle,
        contact_ratio=ratio,
        nominal_contact_ratio=(path.tip_end - path.tip_start) / path.pitch,
        begins_at="tip of gear 2" if path.start == path.tip_start else "form circle of gear 1",
        ends_at="tip of gear 1" if path.end == path.tip_end else "form circle of gear 2",
        transmission_error=worst,
        contact_points=len(lengths),
        backlash=backlash,
        first_in_second=inward if np.isfinite(inward) else None,
        second_in_first=outward if np.isfinite(outward) else None,
        first_tip_clearance=clearances[0],
        second_tip_clearance=clearances[1],
        runs=runs,
        path=_points(first, second, path, lengths[picks], error[picks]),
        checks=(Check("conjugate action", worst <= EXACT, worst, EXACT),),
        advice=_advice(path, ratio, backlash, gaps, clearances, first) + (_tips_meet(trimmed) if trims else ()) + notes,
        numerics=_numerics(first, distance, path),
    )


def _tip_clearances(first: ToothForm, second: ToothForm, distance: float) -> tuple[float, float]:
    if second.internal:
        return second.root - distance - first.tip, second.tip - distance - first.root
    return distance - first.tip - second.root, distance - second.tip - first.root


def _tip_notes(first: ToothForm, second: ToothForm, distance: float) -> tuple[Advice, ...]:
    """Say so when the tips are left at full height where `gear pair` shortens them."""
    one, two = first.cutter, second.cutter
    if one is None or two is None:
        return ()
    change = distance - first.module * (one.pitch_radius + two.pitch_radius + one.shift + two.shift)
    if change > -1e-9 * first.module:
        return ()
    tips = [2e3 * (form.tip + change) for form in (first, second)]
    return (
        Advice(
            "full-tips",
            f"the tips are full height; gear pair shortens them by {-1e3 * change:.6g} mm to keep the tip clearance",
            "note",
            f'for its tips --first-tip-diameter "{tips[0]:.9g} mm" --second-tip-diameter "{tips[1]:.9g} mm"',
        ),
    )


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


def _advice(
    path: Path,
    ratio: float,
    backlash: float,
    gaps: "dict[str, float]",
    clearances: tuple[float, float],
    first: ToothForm,
) -> tuple[Advice, ...]:
    found = []
    if ratio < 1.0:
        found.append(
            Advice(
                "open-mesh",
                f"the contact ratio is {ratio:.6g}: between one pair of teeth and the next nothing is in contact",
                "serious",
                "bring the gears closer together, or give them higher teeth",
            )
        )
    if backlash < -EXACT:
        found.append(
            Advice(
                "jam",
                f"the teeth are {-1e3 * backlash:.6g} mm too thick along the line of action",
                "serious",
                "raise the centre distance, or lower the profile shifts",
            )
        )
    for where, gap in gaps.items():
        if gap < -1e-6 * first.module:
            found.append(
                Advice(
                    "interference",
                    f"{where}: the profiles overlap by {-1e3 * gap:.6g} mm",
                    "serious",
                    "shorten the tips",
                )
            )
    for which, clearance in zip(("gear 1", "gear 2"), clearances, strict=True):
        if clearance < 0.0:
            message = f"the tips of {which} reach {-1e3 * clearance:.6g} mm into the root circle"
            found.append(Advice("tip-clearance", message, "serious", "shorten the tips"))
    if path.start > path.tip_start + EXACT:
        lost = 1e3 * (path.start - path.tip_start)
        found.append(
            Advice(
                "clipped", f"the tip of gear 2 meets no involute for {lost:.6g} mm: it is below gear 1's form circle"
            )
        )
    if path.end < path.tip_end - EXACT:
        lost = 1e3 * (path.tip_end - path.end)
        found.append(
            Advice("clipped", f"the tip of gear 1 meets no involute for {lost:.6g} mm: it is past gear 2's form circle")
        )
    return tuple(found)


def _tips_meet(overlap: float) -> tuple[Advice, ...]:
    message = f"off the line of action the tips overlap the flanks they pass by {1e3 * overlap:.6g} mm"
    return (Advice("tip-interference", message, "serious", "shorten the tips, or make the tooth numbers differ more"),)


def _numerics(first: ToothForm, distance: float, path: Path) -> Numerics:
    # absolute bounds are in the unit shown, at most a thousand to the metre
    # α_w = acos(Σr_b/a): a rounding of a is worth cot α_w of it
    angle = path.pressure_angle
    spread = 8.0 * 2.0**-53 / max(tan(angle), 1e-8)
    ratio = (path.end - path.start) / path.pitch
    loose = 2.0**-50 * (distance / path.pitch) * (1.0 + 1.0 / max(tan(angle), 1e-8)) / ratio
    return Numerics(
        "profiles turned point by point",
        (
            ErrorBound("centre_distance", 2.0**-49),
            ErrorBound("working_pressure_angle", spread / max(angle, 1e-8) + 2.0**-50),
            ErrorBound("contact_ratio", loose),
            ErrorBound("nominal_contact_ratio", loose),
            # it is none at all; what is found is rounding, and checked to be
            ErrorBound("transmission_error", EXACT, relative=False),
            ErrorBound("backlash", 2.0**-48 * (distance + sqrt(first.base * distance)), relative=False),
        ),
    )
