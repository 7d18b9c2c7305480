"""The profile of a gear, an internal gear or a rack, as a drawing of ordered pieces."""

from dynamics_cli.errors import require, worded
from dynamics_cli.gear import options
from dynamics_cli.gear.pitch import Pitch
from dynamics_cli.gear.rounding import bare, carried, error_of, in_digits, in_many_digits, share, tighten
from dynamics_cli.gear.single.flanks import ToothForm, fillet_centre
from dynamics_cli.gear.single.outline import bore_outline, construction_lines, gear_outline, rack_outline
from dynamics_cli.gear.single.rack import FULL_DEPTH
from dynamics_cli.gear.single.toothing_given import fillet_of, gear_inputs, gear_of, internal_form, toothing
from dynamics_cli.numerics.elementary import pi_beside
from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF
from dynamics_cli.outlines import Drawing
from dynamics_cli.quantities import Annotated, Count, Ratio, Size
from dynamics_cli.records import Advice, Check, Choice, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.gear.single.gear import Gear
    from dynamics_cli.outlines import Outline

ONE_MICROMETRE = 1e-6
# Below this the rounding of coordinates would be part of the deviation.
FINEST = 1e-12
# The gear that a rack is taken from.
ANY_TEETH = 1000
# A form circle's bound above this many half units in the last place is measured.
LOOSE = 20.0
CIRCLES = ("tip", "root", "base", "form")


class Form(Choice):
    """Kind of pieces of a drawn profile."""

    names = ("arcs", "lines")
    aliases = {"arc": "arcs", "line": "lines", "polyline": "lines"}  # noqa: RUF012


ARCS = Form("arcs")


@record
class GearProfile:
    """A profile with the data of its gear."""

    deviation: Annotated[Size, "Proved bound on the distance of the drawing from the exact profile [m]."]
    points: Annotated[Count, "Number of points of its curves."]
    pieces: Annotated[Count, "Number of its pieces: arcs, lines and curves."]
    tip_diameter: Annotated[Size | None, "Tip diameter [m]."]
    root_diameter: Annotated[Size | None, "Root diameter [m]."]
    base_diameter: Annotated[Size | None, "Base diameter [m]."]
    form_diameter: Annotated[Size | None, "Where the involute begins above the root [m]."]
    undercut: Annotated[bool | None, "Whether the rack cuts into the involute."]
    drawing: Annotated[Drawing | None, "The profile."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def tooth_form(gear: "Gear", tip_diameter: float | None, root_radius_factor: float | None) -> ToothForm:
    """The form of a gear: cut by its rack, or with a fillet when it is internal; refuses impossible teeth."""
    fillet = fillet_of(gear, root_radius_factor)
    teeth = toothing(gear, tip_diameter=tip_diameter, fillet=fillet)
    module = gear.module
    if not gear.internal:
        cutter, junction = gear.cutter, gear.junction
        half = pi_beside(module) / cutter.teeth - cutter.space_half_angle
        radii = cutter.base_radius * module, teeth.tip, junction.form_radius * module, cutter.root_radius * module
        return ToothForm(cutter.teeth, False, module, *radii, half, cutter, junction)
    base, size = teeth.base_radius, fillet * module
    radii = base, teeth.tip, internal_form(base, teeth.root, size), teeth.root
    form = ToothForm(teeth.teeth, True, module, *radii, teeth.solid_half, fillet=size)
    fillet_centre(form)
    return form


def profile(
    *,
    teeth: Annotated[Count, "Number of teeth (of a rack: how many are drawn), e.g. 24."],
    pitch: Annotated[Pitch, "Module, diametral pitch or circular pitch, normal or transverse."],
    profile: options.RackName = options.RACK_A,
    pressure_angle: options.PressureAngle = FULL_DEPTH,
    helix_angle: options.HelixAngle = 0.0,
    profile_shift: Annotated[Ratio, "Profile shift factor."] = 0.0,
    internal: options.Internal = False,
    shift_sign: options.ShiftSign = options.ISO,
    addendum_factor: options.AddendumFactor = None,
    dedendum_factor: options.DedendumFactor = None,
    root_radius_factor: options.RootRadius = None,
    tip_diameter: options.TipDiameter = None,
    rack: Annotated[bool, "Draw the rack that meshes with the gear, in its normal plane."] = False,
    only_teeth: Annotated[
        Count | None, "Draw only this many teeth, as an open outline; tooth 0 points along +y, e.g. 3."
    ] = None,
    form: Annotated[
        Form, "How flanks and root curves are drawn: as arcs with a common tangent where they join, or as lines."
    ] = ARCS,
    tolerance: Annotated[Size, "How far the drawing may be from the exact profile [m]."] = ONE_MICROMETRE,
    bore: Annotated[Size | None, "Diameter of the bore, drawn as a circle, e.g. 12 mm [m]."] = None,
) -> GearProfile:
    """Draw the exact transverse profile of a gear: root arcs, trochoids, involutes and tip arcs that share their ends.

    Equation
    --------
    Involute: R = r_b √(1 + t²), half angle ψ = ψ_b − (t − atan t). Trochoid: the rack's corner cuts where its normal
    passes through the pitch point. A chord of the involute deviates by at most (t₁² − t₀²)² r_b/(32 t₀); a chord of the
    trochoid lies with its arc in the triangle of its end tangents.

    Returns
    -------
    GearProfile
        The drawing, its proved deviation, and the diameters.

    Raises
    ------
    InadmissibleError
        When the teeth are pointed below their tips, no flank remains, or the corner does not fit.

    Notes
    -----
    Tip and root arcs are exact; flanks and trochoids are pairs of arcs (or chords) distributed so that all deviate
    equally. An internal gear's root is a fillet tangent to root circle and involute, not a particular pinion cutter's
    trochoid.

    References
    ----------
    ISO 21771; Litvin & Fuentes, Gear Geometry and Applied Theory (generation by a rack).

    Examples
    --------
    >>> from dynamics_cli.gear.pitch import NormalModule
    >>> drawn = profile(teeth=20, pitch=NormalModule(0.002))
    >>> (drawn.pieces, drawn.deviation <= 1e-6)
    (520, True)
    """
    given = locals()
    require(
        tolerance >= FINEST,
        "the tolerance {tolerance:3} is smaller than the rounding of the coordinates",
        tolerance=(tolerance, Size),
        code="tolerance",
    )
    require(teeth > 0, "a profile needs at least 1 tooth, not {teeth}", teeth=teeth, code="teeth")
    require(
        not (rack and internal), "a rack is neither internal nor external", code="rack", hint="leave out --internal"
    )
    inputs = gear_inputs(given)
    if rack:
        inputs |= {"teeth": ANY_TEETH, "profile_shift": 0.0}
        toothed = gear_of(**inputs)
        cutter = toothed.cutter
        require(
            cutter.corner_offset >= 0.0,
            "a root radius of {tip_radius:6} modules does not fit the rack",
            tip_radius=(toothed.rack.tip_radius, Ratio),
            code="tip-radius",
        )
        outline = rack_outline(cutter, toothed.module, toothed.rack.addendum, teeth)
        return _result(outline, 4 * teeth, None, None, Drawing((outline,), title="rack"))
    gear = gear_of(**carried(inputs))
    shape = tooth_form(gear, carried(tip_diameter), carried(root_radius_factor))
    if error_of(shape.form) > LOOSE * UNIT_ROUNDOFF * bare(shape.form):
        more = [in_many_digits(part) for part in (inputs, tip_diameter, root_radius_factor)]
        exact = in_digits(lambda: tooth_form(gear_of(**more[0]), *more[1:]))
        if exact is not None:
            tighten((shape.form,), (exact.form,))
    outline, points = gear_outline(bare(shape), tolerance, teeth=only_teeth, arcs=str(form) == "arcs")
    title = "tooth" if only_teeth is not None else "internal gear" if internal else "gear"
    drawing = Drawing((outline,), title=title)
    if only_teeth is None:
        outer = 2.0 * bare(max(shape.root, shape.tip))
        lines = construction_lines(abs(bare(gear.reference_diameter)), outer)
        drawing = Drawing((outline, *_bore(bore, bare(shape))), title, lines)
    return _result(outline, points, shape, tolerance, drawing)


def _bore(bore: float | None, form: ToothForm) -> "tuple[Outline, ...]":
    """The outline of a bore; refuses one that leaves no rim under the teeth."""
    if bore is None:
        return ()
    require(not form.internal, "an internal gear has no bore", code="bore", hint="leave out --bore")
    require(
        0.0 < bore < 2.0 * form.root,
        "the bore of {bore:6} must be above zero and below the root diameter {root:6}",
        bore=(bore, Size),
        root=(2.0 * form.root, Size),
        code="bore",
    )
    return (bore_outline(bore),)


def _result(
    outline: "Outline", points: int, form: ToothForm | None, tolerance: float | None, drawing: Drawing
) -> GearProfile:
    """The results; the form's numbers carry rounding bounds."""
    undercut = form.junction.undercut if form is not None and form.junction is not None else None
    advice: tuple[Advice, ...] = ()
    if undercut and form is not None and form.junction is not None:
        advice = (_undercut_advice(bare(form)),)
    diameters = {} if form is None else {f"{name}_diameter": 2.0 * getattr(form, name) for name in CIRCLES}
    checks: tuple[Check, ...] = ()
    if tolerance is not None:
        checks = (
            Check(
                "the proved deviation keeps the tolerance",
                outline.deviation <= 1.01 * tolerance,
                outline.deviation,
                tolerance,
            ),
        )
    return GearProfile(
        deviation=outline.deviation,
        points=points,
        pieces=len(outline.pieces),
        tip_diameter=bare(diameters.get("tip_diameter")),
        root_diameter=bare(diameters.get("root_diameter")),
        base_diameter=bare(diameters.get("base_diameter")),
        form_diameter=bare(diameters.get("form_diameter")),
        undercut=undercut,
        drawing=drawing,
        checks=checks,
        advice=advice,
        numerics=None
        if form is None
        else Numerics(
            "closed forms; the junction of trochoid and involute bracketed",
            tuple(share(name, value) for name, value in diameters.items()),
        ),
    )


def _undercut_advice(form: ToothForm) -> Advice:
    junction, cutter = form.junction, form.cutter
    assert junction is not None
    assert cutter is not None
    from math import sin

    more = -junction.margin * sin(cutter.transverse_angle)
    message = worded("the rack undercuts the involute below {form:6} diameter", form=(2.0 * form.form, Size))
    remedy = worded("raise the profile shift to {shift:6}", shift=(cutter.shift + more, Ratio))
    return Advice("undercut", message, remedy=remedy)
