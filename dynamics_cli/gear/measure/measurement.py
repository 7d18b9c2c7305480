"""Measuring a gear: every size that shows its tooth thickness, and the profile shift back from a measured size."""

from dynamics_cli.errors import InadmissibleError, require, worded
from dynamics_cli.gear import options
from dynamics_cli.gear.measure.pins import Pins, pins, shift_from_pins
from dynamics_cli.gear.measure.sizes import (
    Chord,
    Span,
    chordal,
    constant_chord,
    shift_from_chord,
    shift_from_span,
    span,
)
from dynamics_cli.gear.pitch import Pitch, module_advice
from dynamics_cli.gear.single.gear import Gear, require_circles
from dynamics_cli.gear.single.rack import FULL_DEPTH
from dynamics_cli.gear.single.toothing_given import fillet_of, gear_inputs, gear_of, toothing
from dynamics_cli.numerics.elementary import absolute, pi_beside, tan
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Annotated, Coordinate, Count, Ratio, Size
from dynamics_cli.records import Advice, Check, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import TypeVar

    from dynamics_cli.gear.single.toothing import Toothing

    Sized = TypeVar("Sized")


# Names of the measured sizes in refusals.
_READ = ("a span", "a size over pins", "a chordal thickness")


@record
class ShiftFound:
    """The tooth that a measured size implies."""

    profile_shift: Annotated[Ratio, "The profile shift that gives the measured size."]
    thickness_deviation: Annotated[Coordinate, "Normal tooth thickness at the pitch circle, measured less nominal [m]."]


@record
class Measurements:
    """The sizes of a gear."""

    normal_thickness: Annotated[Size, "Normal tooth thickness at the pitch circle, s_n [m]."]
    span: Annotated[Span | None, "Base tangent length, W_k."]
    pins: Annotated[Pins | None, "Size over pins or balls, M_dK."]
    chordal: Annotated[Chord | None, "Chordal thickness at the pitch circle."]
    constant_chord: Annotated[Chord | None, "Constant chord."]
    from_span: Annotated[ShiftFound | None, "From the measured span."] = None
    from_pins: Annotated[ShiftFound | None, "From the measured size over pins."] = None
    from_chord: Annotated[ShiftFound | None, "From the measured chordal thickness."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def measure(
    *,
    teeth: Annotated[Count, "Number of teeth, e.g. 24."],
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
    face_width: Annotated[
        Size | None, "Face width, to see whether a helical gear is wide enough for its span, e.g. 20 mm [m]."
    ] = None,
    over: options.Over = None,
    pin: options.Pin = None,
    upper_allowance: options.UpperAllowance = None,
    lower_allowance: options.LowerAllowance = None,
    measured_span: Annotated[Size | None, "A span that was measured over `over` teeth, e.g. 32.8 mm [m]."] = None,
    measured_pins: Annotated[
        Size | None, "A size that was measured over pins of diameter `pin`, e.g. 82.1 mm [m]."
    ] = None,
    measured_chord: Annotated[
        Size | None, "A chordal thickness that was measured at the pitch circle, e.g. 4.7 mm [m]."
    ] = None,
) -> Measurements:
    """Sizes that show a gear's tooth thickness: span, over pins or balls, chordal and constant chord, with tolerances.

    Equation
    --------
    W_k = m_n cos α_n ((k − ½) π + z inv α_t) + 2 x m_n sin α_n;
    inv α_K = D_M/(z m_n cos α_n) − π/(2z) + 2 x tan α_n/z + inv α_t, M = d_b/cos α_K (· cos 90°/z) + D_M;
    s̄ = z_v m_n sin(s_n/(z_v m_n)), z_v = z/cos³β; constant chord s_n cos²α_n.

    Returns
    -------
    Measurements
        Every size possible for this gear, its limits, the points of contact, and the shift from measured sizes.

    Raises
    ------
    InadmissibleError
        When a given span or pin does not touch on the flanks.

    Notes
    -----
    Exact except for the chordal thickness of a helical gear, which is that of the equivalent spur gear by convention.
    Helical gears: balls, or pins for an even number of teeth. The condition of W and M to the module is 1.

    References
    ----------
    ISO 21771 (tooth thickness and its measures); KHK Gear Technical Reference, tooth thickness.

    Examples
    --------
    >>> from dynamics_cli.gear.pitch import NormalModule
    >>> answer = measure(teeth=24, pitch=NormalModule(0.003), profile_shift=0.4)
    >>> (answer.span.over, round(1e3 * answer.span.span, 4))
    (4, 32.8266)
    """
    given_gear = gear_of(**gear_inputs(locals()))
    gear = toothing(given_gear, tip_diameter=tip_diameter, fillet=fillet_of(given_gear, root_radius_factor))
    _require_allowances(upper_allowance, lower_allowance, gear)
    allowances = (upper_allowance, lower_allowance)
    advice: list[Advice] = []
    spanned = _if_possible("span", lambda: span(gear, over, allowances), over is not None, advice)
    pinned = _if_possible("pins", lambda: pins(gear, pin, allowances), pin is not None, advice)
    chord = _if_possible("chordal", lambda: chordal(gear, allowances), False, advice)
    constant = (
        None if internal else _if_possible("constant_chord", lambda: constant_chord(gear, allowances), False, advice)
    )
    advice += _advice(gear, spanned, face_width)
    from_chord = None if measured_chord is None else _found(gear, shift_from_chord(gear, measured_chord))
    readings = _from_span(gear, spanned, measured_span), _from_pins(gear, pin, measured_pins), from_chord
    for shift_found, size, name in zip(readings, (measured_span, measured_pins, measured_chord), _READ, strict=True):
        if shift_found is not None:
            _require_cut(given_gear, shift_found.profile_shift, size, name, tip_diameter, root_radius_factor)
    return Measurements(
        normal_thickness=_thickness(gear),
        span=spanned,
        pins=pinned,
        chordal=chord,
        constant_chord=constant,
        from_span=readings[0],
        from_pins=readings[1],
        from_chord=readings[2],
        checks=_checks(gear, spanned, pinned),
        advice=tuple(advice) + module_advice(pitch, given_gear.module),
    )


def _require_allowances(upper: float | None, lower: float | None, gear: "Toothing") -> None:
    least = upper if lower is None else lower
    if least is not None:
        require(
            least > -_thickness(gear),
            "an allowance of {least:6} removes more than the tooth thickness of {thickness:6}",
            least=(plain(least), Size),
            thickness=(plain(_thickness(gear)), Size),
            code="allowances",
            hint="give a small negative allowance, such as -0.05 mm",
        )
    if upper is not None and lower is not None:
        require(
            lower <= upper,
            "the lower allowance {lower:6} is above the upper one {upper:6}",
            lower=(lower, Size),
            upper=(upper, Size),
            code="allowances",
        )


def _if_possible(name: str, make: "Callable[[], Sized]", requested: bool, advice: list[Advice]) -> "Sized | None":
    """A size, or advice why it does not exist; refused if it was requested."""
    if requested:
        return make()
    try:
        return make()
    except InadmissibleError as error:
        advice.append(Advice(error.code, error.message, "note", error.hint, result=name))
        return None


def _thickness(gear: "Toothing") -> float:
    shift = -gear.shift if gear.internal else gear.shift
    return gear.module * (0.5 * pi_beside(gear.module) + 2.0 * shift * tan(gear.pressure_angle))


def _found(gear: "Toothing", shift: float) -> ShiftFound:
    change = 2.0 * (shift - gear.shift) * gear.module * tan(gear.pressure_angle)
    return ShiftFound(shift, -change if gear.internal else change)


def _from_span(gear: "Toothing", spanned: Span | None, measured: float | None) -> ShiftFound | None:
    if measured is None:
        return None
    require(
        spanned is not None, "give the number of teeth that the span was measured over", code="over", hint="--over 4"
    )
    assert spanned is not None
    return _found(gear, shift_from_span(gear, spanned.over, measured))


def _from_pins(gear: "Toothing", pin: float | None, measured: float | None) -> ShiftFound | None:
    if measured is None:
        return None
    require(pin is not None, "give the pins that the size was measured over", code="pin", hint='--pin "5 mm"')
    assert pin is not None
    return _found(gear, shift_from_pins(gear, pin, measured))


def _require_cut(
    gear: Gear, shift: float, size: float | None, name: str, tip_diameter: float | None, radius: float | None
) -> None:
    """Refuse a reading whose profile shift makes the gear impossible."""
    cut = gear.shifted(-shift if gear.internal else shift)
    try:
        require_circles(cut)
        toothing(cut, tip_diameter=tip_diameter, fillet=fillet_of(cut, radius))
    except InadmissibleError as error:
        require(
            False,
            "{name} of {size:6} would mean a profile shift of {shift:6}, impossible for {teeth} teeth: {reason}",
            name=name,
            size=(size, Size),
            shift=(shift, Ratio),
            teeth=abs(gear.teeth),
            reason=error.message,
            code="measured",
            hint="check the reading, the number of teeth spanned, the module and the tip diameter",
        )


def _checks(gear: "Toothing", spanned: Span | None, pinned: Pins | None) -> tuple[Check, ...]:
    """Check the profile shift by recalculating it from the returned sizes."""
    checks = []
    tolerance = 1e-12 * (1.0 + absolute(gear.shift)) * gear.teeth
    if spanned is not None:
        off = absolute(shift_from_span(gear, spanned.over, spanned.span) - gear.shift)
        checks.append(Check("profile shift back from the span", bool(off <= tolerance), plain(off), plain(tolerance)))
    if pinned is not None:
        off = absolute(shift_from_pins(gear, pinned.pin, pinned.size) - gear.shift)
        checks.append(Check("profile shift back from the pins", bool(off <= tolerance), plain(off), plain(tolerance)))
    return tuple(checks)


def _advice(gear: "Toothing", spanned: Span | None, face_width: float | None) -> list[Advice]:
    advice = []
    if spanned is not None and spanned.least_face_width is not None and face_width is not None:
        least = plain(spanned.least_face_width)
        if plain(face_width) <= least:
            text = worded(
                "a face of {face_width:6} is too narrow: the anvils need {least:6}",
                face_width=(plain(face_width), Size),
                least=(least, Size),
            )
            advice.append(Advice("narrow-face", text, "serious", "span fewer teeth, or measure over balls"))
    if gear.teeth % 2 and plain(gear.helix_angle) != 0.0:
        message = "an odd helical gear is measured over balls in one transverse plane, not over pins"
        advice.append(Advice("odd-helical", message, "note"))
    return advice
