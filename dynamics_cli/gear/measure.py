"""Measuring a gear: every size that shows its tooth thickness, and the profile shift back from a measured size."""

from dynamics_cli.errors import InadmissibleError, require
from dynamics_cli.gear.door import fillet_of, gear_of, toothing
from dynamics_cli.gear.gear import FULL_DEPTH, Pitch, Sign, module_advice
from dynamics_cli.gear.gear import Profile as BasicProfile
from dynamics_cli.gear.sizes import (
    Chord,
    Pins,
    Span,
    chordal,
    constant_chord,
    pins,
    plain,
    shift_from_chord,
    shift_from_pins,
    shift_from_span,
    span,
)
from dynamics_cli.numerics.elementary import absolute, pi_beside, tan
from dynamics_cli.quantities import Angle, Coordinate, Count, Ratio, Size
from dynamics_cli.records import Advice, Check, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import TypeVar

    from dynamics_cli.gear.toothing import Toothing

    Sized = TypeVar("Sized")


FULL = BasicProfile("a")
ISO = Sign("iso")


@record
class ShiftFound:
    """What a measured size says of the tooth.

    Parameters
    ----------
    profile_shift : Ratio
        The profile shift that gives the measured size.
    thickness_deviation : Coordinate
        Normal tooth thickness at the pitch circle, measured less nominal [m].
    """

    profile_shift: Ratio
    thickness_deviation: Coordinate


@record
class Measurements:
    """The sizes of a gear.

    Parameters
    ----------
    normal_thickness : Size
        Normal tooth thickness at the pitch circle, s_n [m].
    span : Span
        Base tangent length, W_k.
    pins : Pins
        Size over pins or balls, M_dK.
    chordal : Chord
        Chordal thickness at the pitch circle.
    constant_chord : Chord
        Constant chord.
    from_span : ShiftFound
        From the measured span.
    from_pins : ShiftFound
        From the measured size over pins.
    from_chord : ShiftFound
        From the measured chordal thickness.
    """

    normal_thickness: Size
    span: Span | None
    pins: Pins | None
    chordal: Chord | None
    constant_chord: Chord | None
    from_span: ShiftFound | None = None
    from_pins: ShiftFound | None = None
    from_chord: ShiftFound | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def measure(
    *,
    teeth: Count,
    pitch: Pitch,
    profile: BasicProfile = FULL,
    pressure_angle: Angle = FULL_DEPTH,
    helix_angle: Angle = 0.0,
    profile_shift: Ratio = 0.0,
    internal: bool = False,
    shift_sign: Sign = ISO,
    addendum_factor: Ratio | None = None,
    dedendum_factor: Ratio | None = None,
    root_radius_factor: Ratio | None = None,
    tip_diameter: Size | None = None,
    face_width: Size | None = None,
    over: Count | None = None,
    pin: Size | None = None,
    upper_allowance: Coordinate | None = None,
    lower_allowance: Coordinate | None = None,
    measured_span: Size | None = None,
    measured_pins: Size | None = None,
    measured_chord: Size | None = None,
) -> Measurements:
    """Sizes that show a gear's tooth thickness: span, over pins or balls, chordal and constant chord, with tolerances.

    Equation
    --------
    W_k = m_n cos α_n ((k − ½) π + z inv α_t) + 2 x m_n sin α_n;
    inv α_K = D_M/(z m_n cos α_n) − π/(2z) + 2 x tan α_n/z + inv α_t, M = d_b/cos α_K (· cos 90°/z) + D_M;
    s̄ = z_v m_n sin(s_n/(z_v m_n)), z_v = z/cos³β; constant chord s_n cos²α_n.

    Parameters
    ----------
    teeth : Count
        Number of teeth.
    pitch : Pitch
        Module, diametral pitch or circular pitch, normal or transverse.
    profile : Profile
        Basic rack: a, b, c, d of ISO 53, stub, agma-coarse or agma-fine.
    pressure_angle : Angle
        Normal pressure angle [rad].
    helix_angle : Angle
        Helix angle [rad].
    profile_shift : Ratio
        Profile shift factor.
    internal : bool
        Whether the teeth point inwards.
    shift_sign : Sign
        Whose sign the profile shift of an internal gear has: iso (towards the tips) or outward (KHK, JIS).
    addendum_factor : Ratio
        Addendum in modules, in place of the basic rack's.
    dedendum_factor : Ratio
        Dedendum in modules, in place of the basic rack's.
    root_radius_factor : Ratio
        Radius of the rack's corner in modules; of an internal gear's fillet (0.2 unless given).
    tip_diameter : Size
        Tip diameter, where it is not that of the rack [m].
    face_width : Size
        Face width, to see whether a helical gear is wide enough for its span [m].
    over : Count
        Teeth to span (spaces of an internal gear); the best number unless given.
    pin : Size
        Diameter of pins or balls; the nearest standard one unless given [m].
    upper_allowance : Coordinate
        Upper deviation of the normal tooth thickness, E_sns, negative for backlash [m].
    lower_allowance : Coordinate
        Lower deviation of the normal tooth thickness, E_sni [m].
    measured_span : Size
        A span that was measured over `over` teeth [m].
    measured_pins : Size
        A size that was measured over pins of diameter `pin` [m].
    measured_chord : Size
        A chordal thickness that was measured at the pitch circle [m].

    Returns
    -------
    Measurements
        Every size that this gear allows, its limits, where the instrument touches, and the shift from measured sizes.

    Raises
    ------
    InadmissibleError
        When a span or pin that was asked for does not touch on the flanks.

    Notes
    -----
    Exact but for the chordal thickness of a helical gear, which is that of the equivalent spur gear by convention.
    Helical gears: balls, or pins for an even number of teeth. The condition of W and M to the module is 1.

    References
    ----------
    ISO 21771 (tooth thickness and its measures); KHK Gear Technical Reference, tooth thickness.

    Examples
    --------
    >>> from dynamics_cli.gear.gear import NormalModule
    >>> answer = measure(teeth=24, pitch=NormalModule(0.003), profile_shift=0.4)
    >>> (answer.span.over, round(1e3 * answer.span.span, 4))
    (4, 32.8266)
    """
    made = gear_of(
        teeth=teeth,
        pitch=pitch,
        profile=profile,
        pressure_angle=pressure_angle,
        addendum_factor=addendum_factor,
        dedendum_factor=dedendum_factor,
        root_radius_factor=root_radius_factor,
        helix_angle=helix_angle,
        profile_shift=profile_shift,
        internal=internal,
        sign=shift_sign,
    )
    gear = toothing(made, tip_diameter=tip_diameter, fillet=fillet_of(made, root_radius_factor))
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
    return Measurements(
        normal_thickness=_thickness(gear),
        span=spanned,
        pins=pinned,
        chordal=chord,
        constant_chord=constant,
        from_span=_from_span(gear, spanned, measured_span),
        from_pins=_from_pins(gear, pin, measured_pins),
        from_chord=None if measured_chord is None else _found(gear, shift_from_chord(gear, measured_chord)),
        checks=_checks(gear, spanned, pinned),
        advice=tuple(advice) + module_advice(pitch, made.module),
    )


def _require_allowances(upper: float | None, lower: float | None, gear: "Toothing") -> None:
    least = upper if lower is None else lower
    if least is not None:
        require(
            least > -_thickness(gear),
            "an allowance of {0:.6g} mm leaves nothing of teeth {1:.6g} mm thick",
            1e3 * plain(least),
            1e3 * plain(_thickness(gear)),
            code="allowances",
            hint="an allowance is a part of the tooth thickness, such as -0.05 mm",
        )
    if upper is not None and lower is not None:
        require(
            lower <= upper,
            "the lower allowance {0:.6g} mm is above the upper one {1:.6g} mm",
            1e3 * lower,
            1e3 * upper,
            code="allowances",
        )


def _if_possible(name: str, make: "Callable[[], Sized]", asked: bool, advice: list[Advice]) -> "Sized | None":
    """A size, or why there is none; refused when it was asked for."""
    if asked:
        return make()
    try:
        return make()
    except InadmissibleError as error:
        advice.append(Advice(error.code, error.message, "note", error.hint, result=name))
        return None


def _thickness(gear: "Toothing") -> float:
    own = -gear.shift if gear.internal else gear.shift
    return gear.module * (0.5 * pi_beside(gear.module) + 2.0 * own * tan(gear.pressure_angle))


def _found(gear: "Toothing", shift: float) -> ShiftFound:
    change = 2.0 * (shift - gear.shift) * gear.module * tan(gear.pressure_angle)
    return ShiftFound(shift, -change if gear.internal else change)


def _from_span(gear: "Toothing", spanned: Span | None, measured: float | None) -> ShiftFound | None:
    if measured is None:
        return None
    require(spanned is not None, "say over how many teeth the span was measured", code="over", hint="--over 4")
    assert spanned is not None
    return _found(gear, shift_from_span(gear, spanned.over, measured))


def _from_pins(gear: "Toothing", pin: float | None, measured: float | None) -> ShiftFound | None:
    if measured is None:
        return None
    require(pin is not None, "say which pins the size was measured over", code="pin", hint='--pin "5 mm"')
    assert pin is not None
    return _found(gear, shift_from_pins(gear, pin, measured))


def _checks(gear: "Toothing", spanned: Span | None, pinned: Pins | None) -> tuple[Check, ...]:
    """The profile shift found again from the sizes that were returned."""
    found = []
    room = 1e-12 * (1.0 + absolute(gear.shift)) * gear.teeth
    if spanned is not None:
        off = absolute(shift_from_span(gear, spanned.over, spanned.span) - gear.shift)
        found.append(Check("profile shift back from the span", bool(off <= room), plain(off), plain(room)))
    if pinned is not None:
        off = absolute(shift_from_pins(gear, pinned.pin, pinned.size) - gear.shift)
        found.append(Check("profile shift back from the pins", bool(off <= room), plain(off), plain(room)))
    return tuple(found)


def _advice(gear: "Toothing", spanned: Span | None, face_width: float | None) -> list[Advice]:
    found = []
    if spanned is not None and spanned.least_face_width is not None and face_width is not None:
        least = plain(spanned.least_face_width)
        if plain(face_width) <= least:
            found.append(
                Advice(
                    "narrow-face",
                    f"a face of {1e3 * plain(face_width):.6g} mm is too narrow: the anvils need {1e3 * least:.6g} mm",
                    "serious",
                    "span fewer teeth, or measure over balls",
                )
            )
    if gear.teeth % 2 and plain(gear.helix_angle) != 0.0:
        found.append(
            Advice(
                "odd-helical",
                "an odd helical gear is measured over balls in one transverse plane, not over pins",
                "note",
            )
        )
    return found
