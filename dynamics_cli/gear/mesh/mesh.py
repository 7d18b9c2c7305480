"""The proof of a mesh: both exact profiles turned through it, and their actual behaviour."""

from dynamics_cli.errors import require
from dynamics_cli.gear import options
from dynamics_cli.gear.mesh.advice import EXACT, OVERLAP, advice, tip_notes, tips_meet
from dynamics_cli.gear.mesh.bounds import mesh_numerics
from dynamics_cli.gear.mesh.flank_clearance import flank_gap
from dynamics_cli.gear.mesh.profile_contact import (
    Path,
    half_play,
    path_of_contact,
    remedy_of_open_mesh,
    tips_pass,
    transmission_error,
)
from dynamics_cli.gear.mesh.root_clearance import root_gaps
from dynamics_cli.gear.pair.engagement import require_partners
from dynamics_cli.gear.pitch import Pitch
from dynamics_cli.gear.rounding import bare, carried, in_digits, in_many_digits, tighten
from dynamics_cli.gear.single.flanks import ToothForm
from dynamics_cli.gear.single.profile import tooth_form
from dynamics_cli.gear.single.rack import FULL_DEPTH
from dynamics_cli.gear.single.toothing_given import gear_inputs, gear_of
from dynamics_cli.numerics.elementary import absolute, cos, maximum, minimum, pi_beside, tan
from dynamics_cli.numerics.involute import inverse_involute
from dynamics_cli.quantities import Angle, Annotated, Coordinate, Count, Ratio, Size, Text
from dynamics_cli.records import Advice, Check, Columns, Numerics, record
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_POINTS = 10_000_000
# The same for samples of uncertain inputs: the transmission error of exact profiles is rounding at all of them.
SAMPLED = 1000
# Chords of the sampled flanks overlap by less than this share of the module where they touch.
TRIMS = 1e-4
# Inputs that say nothing of the two gears.
NOT_OF_GEARS = ("centre_distance", "points", "shown")


@record
class ContactPoint:
    """A point of contact."""

    along: Annotated[Coordinate, "Its place on the line of action, from the pitch point, positive towards recess [m]."]
    first_diameter: Annotated[Size, "Diameter of gear 1 that touches there [m]."]
    second_diameter: Annotated[Size, "Diameter of gear 2 that touches there [m]."]
    error: Annotated[Angle, "What gear 2 is ahead of the exact ratio [rad]."]


@record
class MeshProof:
    """The behaviour of two profiles in mesh."""

    centre_distance: Annotated[Size, "Centre distance [m]."]
    working_pressure_angle: Annotated[Angle, "Transverse working pressure angle [rad]."]
    contact_ratio: Annotated[Ratio, "Transverse contact ratio of the actual involutes, between form circles and tips."]
    nominal_contact_ratio: Annotated[Ratio, "The same by the tip circles alone."]
    begins_at: Annotated[Text, "What limits the contact at its start."]
    ends_at: Annotated[Text, "What limits it at its end."]
    transmission_error: Annotated[
        Angle, "Largest angular error of gear 2 against the exact ratio, over the whole path of contact [rad]."
    ]
    contact_points: Annotated[Count, "Points of contact that were checked."]
    backlash: Annotated[Coordinate, "Transverse backlash along the line of action; negative when the teeth jam [m]."]
    first_in_second: Annotated[
        Coordinate | None,
        "Least distance of gear 1's teeth from the root of gear 2's spaces; negative when they overlap [m].",
    ]
    second_in_first: Annotated[
        Coordinate | None, "Least distance of gear 2's teeth from the root of gear 1's spaces [m]."
    ]
    first_tip_clearance: Annotated[Coordinate, "From the tips of gear 1 to the root circle of gear 2 [m]."]
    second_tip_clearance: Annotated[Coordinate, "From the tips of gear 2 to the root circle of gear 1 [m]."]
    runs: Annotated[bool, "Whether the pair runs: contact without a gap, no jam, no overlap."]
    path: Annotated[Columns[ContactPoint], "A selection of the points of contact."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def mesh(
    *,
    first_teeth: Annotated[Count, "Teeth of gear 1, which drives, e.g. 24."],
    second_teeth: Annotated[Count, "Teeth of gear 2, e.g. 60."],
    pitch: Annotated[Pitch, "Module, diametral pitch or circular pitch, normal or transverse."],
    centre_distance: Annotated[Size | None, "Centre distance; without backlash unless given, e.g. 90 mm [m]."] = None,
    internal: Annotated[bool, "Whether gear 2 is an internal gear."] = False,
    profile: options.RackName = options.RACK_A,
    pressure_angle: options.PressureAngle = FULL_DEPTH,
    helix_angle: options.HelixAngle = 0.0,
    first_profile_shift: Annotated[Ratio, "Profile shift factor of gear 1."] = 0.0,
    second_profile_shift: Annotated[Ratio, "Profile shift factor of gear 2."] = 0.0,
    shift_sign: options.ShiftSign = options.ISO,
    addendum_factor: options.AddendumFactor = None,
    dedendum_factor: options.DedendumFactor = None,
    root_radius_factor: options.RootRadius = None,
    first_tip_diameter: Annotated[
        Size | None, "Tip diameter of gear 1, in place of that of the rack, e.g. 44.8 mm [m]."
    ] = None,
    second_tip_diameter: Annotated[
        Size | None, "Tip diameter of gear 2, in place of that of the rack, e.g. 79.4 mm [m]."
    ] = None,
    points: Annotated[Count, "Points of contact to check."] = 100000,
    shown: Annotated[Count, "Number of them to show."] = 11,
) -> MeshProof:
    """Turn two exact profiles through their mesh: transmission error, minimum clearances, actual contact ratio.

    Equation
    --------
    At each point of the line of action both gears are turned until their flanks pass through it; gear 2's angle is
    compared with z₁/z₂ times gear 1's. Distances from a root: the edge of a tooth's tip against trochoid or fillet and
    where the flank begins, where the normal passes through the pitch point; tips against the root circle.

    Returns
    -------
    MeshProof
        The behaviour of the profiles, and whether the pair runs.

    Raises
    ------
    InadmissibleError
        When the base circles overlap, or no involute flanks touch.

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
    >>> from dynamics_cli.gear.pitch import NormalModule
    >>> round(mesh(first_teeth=20, second_teeth=20, pitch=NormalModule(0.001)).contact_ratio, 4)
    1.5568
    """
    inputs = {name: value for name, value in locals().items() if name not in NOT_OF_GEARS}
    require(
        2 <= points <= MOST_POINTS,
        "points of contact: give 2 to {most}, not {points}",
        points=points,
        most=MOST_POINTS,
        code="points",
    )
    bare_tips = first_tip_diameter is None and second_tip_diameter is None and not internal
    if drawing():
        return _proof(_Known(inputs, centre_distance), None, SAMPLED, 2, bare_tips)
    known = _Known(carried(inputs), carried(centre_distance))
    exact = in_digits(lambda: _Known(in_many_digits(inputs), in_many_digits(centre_distance), known.places))
    if exact is not None:
        tighten(known.numbers(), exact.numbers())
    return _proof(known, exact, points, shown, bare_tips)


def forms_of(first_tip_diameter: float | None, second_tip_diameter: float | None, **given: "Any") -> "list[ToothForm]":
    """Both profiles, from their common and individual parameters."""
    gears = [
        gear_of(
            **gear_inputs(
                {**given, "teeth": given[f"{which}_teeth"], "profile_shift": given[f"{which}_profile_shift"],
                 "internal": internal}
            )
        )
        for which, internal in (("first", False), ("second", given["internal"]))
    ]  # fmt: skip
    require_partners(*gears)
    tips = first_tip_diameter, second_tip_diameter
    return [tooth_form(gear, tip, given["root_radius_factor"]) for gear, tip in zip(gears, tips, strict=True)]


def without_backlash(first: ToothForm, second: ToothForm) -> float:
    """The centre distance at which the flanks touch on both sides: thicknesses and pitch on the working circles."""
    sign = -1.0 if second.internal else 1.0
    total = first.teeth + sign * second.teeth
    thick = first.teeth * first.half_base + sign * (second.teeth * second.half_base)
    value = (thick if second.internal else thick - pi_beside(thick)) / total
    require(
        value >= 0.0,
        "inv α_w would be {involute:6}: these gears cannot mesh without backlash",
        involute=(value, Ratio),
        code="no-working-angle",
        hint="raise the sum of the profile shifts",
    )
    return absolute(first.base + sign * second.base) / cos(inverse_involute(value))


def _require_contact(path: Path) -> None:
    require(
        path.end > path.start,
        "the involutes do not touch: contact would begin at {start:6} and end at {end:6} along the line of action",
        start=(path.start, Size),
        end=(path.end, Size),
        code="open-mesh",
        hint=remedy_of_open_mesh(path.start > path.tip_start, path.end < path.tip_end),
    )


def _proof(known: "_Known", exact: "_Known | None", points: int, rows: int, bare_tips: bool) -> MeshProof:
    """The proof in numbers that carry rounding bounds; the turning itself is in doubles."""
    import numpy as np

    first, second, plain = bare(known.first), bare(known.second), bare(known.path)
    apart = bare(known.results["centre_distance"])
    lengths, error = transmission_error(first, second, apart, plain, points)
    worst = float(np.max(np.abs(error)))
    # gear 2 turns faster by the ratio, and so does the rounding of gear 1's angle
    turned = EXACT * max(1.0, first.teeth / second.teeth)
    jammed = max(0.0, -bare(known.backlash))
    trimmed = max(
        0.0, -_beside(first, second, apart, bare(known.play)) - jammed, -tips_pass(first, second, apart) - EXACT
    )
    trims = trimmed > TRIMS * first.module or tips_pass(first, second, apart) < -EXACT
    numbers = {name: bare(value) for name, value in known.results.items()}
    gaps = {"gear 1 in the root of gear 2": known.inward, "gear 2 in the root of gear 1": known.outward}
    overlaps = {where: bare(gap) for where, gap in gaps.items() if gap is not None}
    clearances = numbers["first_tip_clearance"], numbers["second_tip_clearance"]
    free = min((*overlaps.values(), *clearances)) >= -OVERLAP * first.module
    runs = numbers["contact_ratio"] >= 1.0 and numbers["backlash"] >= -EXACT * apart and free and not trims
    picks = np.unique(np.linspace(0, len(lengths) - 1, max(2, min(rows, len(lengths)))).astype(int))
    path = _points(first, second, plain, lengths[picks], error[picks])
    sampling = len(lengths) - 1, picks.tolist()
    notes = tip_notes(first, second, apart) if bare_tips else ()
    return MeshProof(
        **numbers,
        begins_at="tip of gear 2" if plain.start == plain.tip_start else "form circle of gear 1",
        ends_at="tip of gear 1" if plain.end == plain.tip_end else "form circle of gear 2",
        transmission_error=worst,
        contact_points=len(lengths),
        first_in_second=bare(known.inward),
        second_in_first=bare(known.outward),
        runs=runs,
        path=path,
        checks=(Check("conjugate action", worst <= turned, worst, turned),),
        advice=advice(plain, numbers["contact_ratio"], numbers["backlash"], overlaps, clearances, first)
        + (tips_meet(trimmed) if trims else ())
        + notes,
        numerics=None if drawing() else mesh_numerics(known, exact, worst, path.arrays, sampling),
    )


class _Known:
    """The closed-form quantities of a mesh, in numbers that carry rounding bounds."""

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
        # an involute that reaches the start of the other touches it there by design, or jams
        touch = minimum(0.5 * self.backlash, 0.0)
        touches = touch if path.end < path.tip_end else None, touch if path.start > path.tip_start else None
        self.inward, self.outward, self.places = root_gaps(first, second, distance, self.play, touches, places)

    def numbers(self) -> "list[Any]":
        """Every number whose bound is stated or contributes to one."""
        path = self.path
        lengths = (path.start, path.end, path.total, self.pitch_point, self.first.base, self.second.base)
        return [*self.results.values(), self.inward, self.outward, *lengths]


def _beside(first: ToothForm, second: ToothForm, distance: float, play: float) -> float:
    """The minimum distance of either gear's teeth from the other's flanks, off the line of action."""
    gap = flank_gap(first, second, distance, play)
    return min(gap, flank_gap(second, first, distance, play * second.teeth / first.teeth))


def _tip_clearances(first: ToothForm, second: ToothForm, distance: float) -> tuple[float, float]:
    if second.internal:
        return second.root - distance - first.tip, second.tip - distance - first.root
    return distance - first.tip - second.root, distance - second.tip - first.root


def _points(first: ToothForm, second: ToothForm, path: Path, lengths: object, error: object) -> Columns[ContactPoint]:
    import numpy as np

    first_lengths: np.ndarray = lengths  # type: ignore[assignment]
    second_lengths = first_lengths + path.total if second.internal else path.total - first_lengths
    return Columns(
        ContactPoint,
        along=first_lengths - first.base * tan(path.pressure_angle),
        first_diameter=2.0 * np.hypot(first.base, first_lengths),
        second_diameter=2.0 * np.hypot(second.base, second_lengths),
        error=error,
    )
