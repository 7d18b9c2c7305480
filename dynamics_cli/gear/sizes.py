"""Sizes that show the thickness of a tooth: span, over pins or balls, chordal and constant-chord thickness."""

from dynamics_cli.errors import require
from dynamics_cli.gear.toothing import Toothing
from dynamics_cli.gear.trochoid import roll_less_arc
from dynamics_cli.numerics.elementary import asin, atan, cos, pi_beside, sin, sqrt, tan
from dynamics_cli.numerics.involute import inverse_involute
from dynamics_cli.quantities import Count, Ratio, Size
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator


_FIELDS = tuple(Toothing.__annotations__)
# Flanks that lean farther than this from their middle hold no pin of sensible size.
_WIDEST = 1.5
# Van Keuren's wire for external gears, in modules.
_USUAL = 1.728


def plain(x: float) -> float:
    """A tracked number as the double it is."""
    return getattr(x, "value", x)


@record
class Span:
    """Base tangent length over several teeth (over spaces of an internal gear).

    Parameters
    ----------
    over : Count
        Teeth (or spaces) spanned, k.
    span : Size
        W_k, for the nominal thickness [m].
    span_upper : Size
        W_k at the upper allowance of the thickness [m].
    span_lower : Size
        W_k at the lower allowance [m].
    contact_diameter : Size
        Diameter where the anvils touch [m].
    ideal_over : Ratio
        The k, not whole, for contact at d + 2 x m.
    least_face_width : Size
        Face width that a helical gear needs for the anvils to touch [m].
    """

    over: Count
    span: Size
    span_upper: Size | None
    span_lower: Size | None
    contact_diameter: Size
    ideal_over: Ratio
    least_face_width: Size | None = None


@record
class Pins:
    """Size over two pins or balls (between them in an internal gear).

    Parameters
    ----------
    pin : Size
        Their diameter, D_M [m].
    ideal_pin : Size
        The diameter that touches at d + 2 x m [m].
    size : Size
        M_dK, for the nominal thickness [m].
    size_upper : Size
        M_dK at the upper allowance of the thickness [m].
    size_lower : Size
        M_dK at the lower allowance [m].
    contact_diameter : Size
        Diameter where they touch the flanks [m].
    centre_diameter : Size
        Diameter on which their centres lie [m].
    """

    pin: Size
    ideal_pin: Size | None
    size: Size
    size_upper: Size | None
    size_lower: Size | None
    contact_diameter: Size
    centre_diameter: Size


@record
class Chord:
    """A thickness along a chord, and the height of the chord below the tips.

    Parameters
    ----------
    thickness : Size
        The chord, for the nominal thickness [m].
    thickness_upper : Size
        At the upper allowance [m].
    thickness_lower : Size
        At the lower allowance [m].
    height : Size
        From the tip circle to the chord, h_a with the arc's rise [m].
    """

    thickness: Size
    thickness_upper: Size | None
    thickness_lower: Size | None
    height: Size


def thinned(gear: Toothing, allowance: float) -> float:
    """The profile shift that gives the tooth this much more normal thickness (an internal gear's grows inwards)."""
    change = allowance / (2.0 * gear.module * tan(gear.pressure_angle))
    return gear.shift - change if gear.internal else gear.shift + change


def bare(gear: Toothing) -> Toothing:
    """The same gear in plain doubles, for choosing."""
    return Toothing(*(plain(getattr(gear, name)) for name in _FIELDS))  # type: ignore[arg-type]


def with_shift(gear: Toothing, shift: float) -> Toothing:
    """The same blank cut with another profile shift."""
    return Toothing(*(shift if name == "shift" else getattr(gear, name) for name in _FIELDS))  # type: ignore[arg-type]


# ---- span ----


def span_length(gear: Toothing, over: int) -> float:
    """W_k = m_n cos α_n ((k − ½) π + z inv α_t) + 2 x m_n sin α_n."""
    alpha = gear.pressure_angle
    base = gear.module * cos(alpha) * ((over - 0.5) * pi_beside(gear.module) + gear.teeth * gear.pitch_involute)
    return base + 2.0 * gear.shift * gear.module * sin(alpha)


def shift_from_span(gear: Toothing, over: int, length: float) -> float:
    """The profile shift whose span is `length`."""
    alpha = gear.pressure_angle
    base = gear.module * cos(alpha) * ((over - 0.5) * pi_beside(gear.module) + gear.teeth * gear.pitch_involute)
    return (length - base) / (2.0 * gear.module * sin(alpha))


def span_contact(gear: Toothing, length: float) -> float:
    """Radius where the anvils touch."""
    half = 0.5 * length * gear.base_helix_cosine
    base = gear.base_radius
    return sqrt(base * base + half * half)


def ideal_over(gear: Toothing) -> float:
    """The number of teeth, not whole, for contact at d + 2 x m."""
    reach = gear.pitch_radius + gear.shift * gear.module
    base = gear.base_radius
    require(
        reach > base,
        "d + 2xm = {0:.6g} mm lies inside the base circle of {1:.6g} mm: there is no flank to span",
        2e3 * reach,
        2e3 * base,
        code="span-off-flank",
    )
    length = 2.0 * base * gear.shifted_roll / gear.base_helix_cosine
    alpha = gear.pressure_angle
    turns = (length - 2.0 * gear.shift * gear.module * sin(alpha)) / (gear.module * cos(alpha))
    return (turns - gear.teeth * gear.pitch_involute) / pi_beside(turns) + 0.5


def spans_that_serve(gear: Toothing) -> list[int]:
    """Every number of teeth whose span touches on the flanks."""
    low, high = _flank(gear)
    most = max(gear.teeth // 2, int(2.0 * ideal_over(gear)))
    return [over for over in range(1, most + 2) if _touches(gear, span_length(gear, over), low, high)]


def _touches(gear: Toothing, length: float, low: float, high: float) -> bool:
    return length > 0.0 and low <= span_contact(gear, length) <= high


def _flank(gear: Toothing) -> tuple[float, float]:
    """The radii between which the involute lies, smaller one first."""
    form = plain(gear.form) if gear.form is not None else plain(gear.base_radius)
    tip = plain(gear.tip)
    return (tip, form if gear.form is not None else plain(gear.root)) if gear.internal else (form, tip)


def span(gear: Toothing, over: int | None, allowances: "tuple[float | None, float | None]") -> Span:
    """The span over `over` teeth, or over the number that touches nearest d + 2xm."""
    require(
        not (gear.internal and plain(gear.helix_angle) != 0.0),
        "an internal helical gear has no span that anvils can reach",
        code="span-off-flank",
        hint="measure between balls",
    )
    ideal = ideal_over(gear)
    serving = spans_that_serve(bare(gear))
    chosen = over
    if chosen is None:
        require(bool(serving), "no span touches on the flanks", code="span-off-flank", hint="measure over pins")
        # halfway between two, rounding must not choose
        chosen = min(serving, key=lambda k: round(abs(k - plain(ideal)), 9))
    require(chosen >= 1, "a span is over one tooth at least", code="span-off-flank")
    length = span_length(gear, chosen)
    contact = span_contact(gear, length)
    low, high = _flank(gear)
    end = "the form circle" if not gear.internal else "the tip circle"
    other = "the tip circle" if not gear.internal else "the form circle"
    serves = f"{serving[0]} to {serving[-1]} teeth serve" if serving else "no number of teeth serves"
    require(
        contact >= low,
        f"the span over {{0}} teeth touches at {{1:.6g}} mm diameter, below {end} of {{2:.6g}} mm",
        chosen,
        2e3 * contact,
        2e3 * low,
        code="span-off-flank",
        hint=serves,
    )
    require(
        contact <= high,
        f"the span over {{0}} teeth touches at {{1:.6g}} mm diameter, beyond {other} of {{2:.6g}} mm",
        chosen,
        2e3 * contact,
        2e3 * high,
        code="span-off-flank",
        hint=serves,
    )
    upper, lower = (
        None if one is None else span_length(with_shift(gear, thinned(gear, one)), chosen) for one in allowances
    )
    helical = plain(gear.helix_angle) != 0.0
    slope = sin(gear.helix_angle) * cos(gear.pressure_angle)
    return Span(
        over=chosen,
        span=length,
        span_upper=upper,
        span_lower=lower,
        contact_diameter=2.0 * contact,
        ideal_over=ideal,
        least_face_width=length * abs(slope) if helical else None,
    )


# ---- pins ----


def _odd(gear: Toothing) -> float:
    return cos(0.5 * pi_beside(gear.module) / gear.teeth) if gear.teeth % 2 else 1.0


def pin_roll(gear: Toothing, pin: float) -> float:
    """Roll angle tan α_K of the circle of the pins' centres."""
    half = pin / (2.0 * gear.base_radius * gear.base_helix_cosine)
    value = gear.solid_half - half if gear.internal else half - gear.hollow_half
    require(
        value > 0.0,
        "a pin of {0:.6g} mm drops to the base circle: inv α_K would be {1:.6g}",
        1e3 * pin,
        value,
        code="pin-off-flank",
        hint="take a larger pin" if not gear.internal else "take a smaller pin",
    )
    return tan(inverse_involute(value))


def pin_size(gear: Toothing, pin: float) -> float:
    """M = d_K + D_M (between pins d_K − D_M), d_K shortened by cos 90°/z for an odd number of teeth."""
    roll = pin_roll(gear, pin)
    across = 2.0 * gear.base_radius * sqrt(1.0 + roll * roll) * _odd(gear)
    return across - pin if gear.internal else across + pin


def pin_contact(gear: Toothing, pin: float) -> float:
    """Radius where pin and flank touch: the normal's share in the transverse plane is cos β_b."""
    back = 0.5 * pin * gear.base_helix_cosine
    base = gear.base_radius
    reach = base * pin_roll(gear, pin)
    reach = reach + back if gear.internal else reach - back
    return sqrt(base * base + reach * reach)


def ideal_pin(gear: Toothing) -> float | None:
    """The diameter that touches at d + 2xm; None where the flanks of few teeth part so widely that none does.

    Closed form for a spur gear, a few steps of Newton for a helical one.
    """
    reach = gear.pitch_radius + gear.shift * gear.module
    base = gear.base_radius
    require(reach > base, "d + 2xm lies inside the base circle: no pin touches there", code="pin-off-flank")
    touch = gear.shifted_roll
    helix = gear.base_helix_cosine
    sign = -1.0 if gear.internal else 1.0
    offset = gear.solid_half if gear.internal else gear.hollow_half
    # t_K = t_c ± δ cos β_b on the centreline: (t_K − atan t_K) ± offset = ± δ/cos β_b
    if not gear.internal and plain(atan(touch) + offset + roll_less_arc(touch)) >= _WIDEST:
        return None
    if plain(helix) == 1.0:
        # tan(φ + η) − tan φ as a product: nothing cancels
        angle, gap = atan(touch), sign * offset + roll_less_arc(touch)
        return sign * 2.0 * base * sin(gap) / (cos(angle) * cos(angle + gap))
    delta = plain(sign * (tan(touch + sign * offset) - touch))
    for _ in range(60):
        roll = touch + sign * delta * helix
        square = roll * roll
        error = offset + sign * roll_less_arc(roll) - delta / helix
        slope = helix * square / (1.0 + square) - 1.0 / helix
        step = plain(error) / plain(slope)
        if abs(step) <= 1e-16 * abs(delta):
            break
        delta = delta - step
    roll = touch + sign * delta * helix
    error = offset + sign * roll_less_arc(roll) - delta / helix
    slope = helix * roll * roll / (1.0 + roll * roll) - 1.0 / helix
    return 2.0 * base * (delta - error / slope)


def shift_from_pins(gear: Toothing, pin: float, size: float) -> float:
    """The profile shift whose size over these pins is `size`."""
    across = size + pin if gear.internal else size - pin
    ratio = across / (2.0 * gear.base_radius * _odd(gear))
    require(
        ratio > 1.0,
        "the pins' centres would lie on {0:.9g} mm, inside the base circle of {1:.9g} mm",
        1e3 * across,
        2e3 * gear.base_radius,
        code="pin-off-flank",
    )
    value = roll_less_arc(sqrt((ratio - 1.0) * (ratio + 1.0)))
    half = pin / (2.0 * gear.base_radius * gear.base_helix_cosine)
    shift_angle = (value + half if gear.internal else value - half) - gear.pitch_involute
    space = 0.5 * pi_beside(shift_angle) / gear.teeth
    shift_angle = shift_angle - space if gear.internal else shift_angle + space
    return 0.5 * shift_angle * gear.teeth / tan(gear.pressure_angle)


def standard_pins(near: float) -> "Iterator[float]":
    """Pins and balls on the shelf about a size, nearest first: tenths of mm below 2 mm, halves below 12 mm, whole."""
    step = 1e-4 if near < 2e-3 else 5e-4 if near < 12e-3 else 1e-3
    middle = round(near / step)
    for index in sorted(range(max(1, middle - 12), middle + 13), key=lambda index: abs(index * step - near)):
        # 3.5 mm as it is written, not as a product of roundings
        yield index / (1.0 / step)


def pin_trouble(gear: Toothing, pin: float) -> "tuple[str, tuple[float, float]] | None":
    """What is wrong with a pin, in words with its two deciding numbers; None when it serves."""
    contact, low_high = plain(pin_contact(gear, pin)), _flank(gear)
    low, high = low_high
    first, last = ("tip", "form") if gear.internal else ("form", "tip")
    if contact < low:
        return f"touches at {{0:.6g}} mm diameter, below the {first} diameter {{1:.6g}} mm", (2e3 * contact, 2e3 * low)
    if contact > high:
        return f"touches at {{0:.6g}} mm diameter, beyond the {last} diameter {{1:.6g}} mm", (2e3 * contact, 2e3 * high)
    centre = plain(gear.base_radius * sqrt(1.0 + pin_roll(gear, pin) * pin_roll(gear, pin)))
    half, root, tip = 0.5 * plain(pin), plain(gear.root), plain(gear.tip)
    outer, inner = centre + half, centre - half
    if gear.internal:
        if outer > root:
            return "meets the root: it reaches {0:.6g} mm diameter, the root lies at {1:.6g} mm", (
                2e3 * outer,
                2e3 * root,
            )
        if inner > tip:
            return "does not stand out of the space: it ends at {0:.6g} mm, the tips at {1:.6g} mm", (
                2e3 * inner,
                2e3 * tip,
            )
        return None
    if inner < root:
        return "meets the root: it reaches {0:.6g} mm diameter, the root lies at {1:.6g} mm", (2e3 * inner, 2e3 * root)
    if outer < tip:
        return "does not stand out of the space: it ends at {0:.6g} mm, the tips at {1:.6g} mm", (
            2e3 * outer,
            2e3 * tip,
        )
    return None


def pins(gear: Toothing, pin: float | None, allowances: "tuple[float | None, float | None]") -> Pins:
    """The size over pins of a given diameter, or of the standard one nearest the ideal."""
    ideal = ideal_pin(gear)
    chosen = pin
    if chosen is None:
        near = _USUAL * plain(gear.module) if ideal is None else plain(ideal)
        own = bare(gear)
        chosen = next((one for one in standard_pins(near) if _serves(own, one)), None)
        require(chosen is not None, "no standard pin touches on the flanks", code="pin-off-flank", hint="give --pin")
        assert chosen is not None
    else:
        require(chosen > 0.0, "a pin of {0:.6g} mm is none", 1e3 * chosen, code="pin")
        trouble = pin_trouble(bare(gear), plain(chosen))
        if trouble is not None:
            words, numbers = trouble
            require(
                False,
                f"a pin of {1e3 * plain(chosen):.6g} mm " + words,
                *numbers,
                code="pin-off-flank",
                hint=None if ideal is None else f"the ideal is {1e3 * plain(ideal):.6g} mm",
            )
    roll = pin_roll(gear, chosen)
    upper, lower = (
        None if one is None else pin_size(with_shift(gear, thinned(gear, one)), chosen) for one in allowances
    )
    return Pins(
        pin=chosen,
        ideal_pin=ideal,
        size=pin_size(gear, chosen),
        size_upper=upper,
        size_lower=lower,
        contact_diameter=2.0 * pin_contact(gear, chosen),
        centre_diameter=2.0 * gear.base_radius * sqrt(1.0 + roll * roll),
    )


def _serves(gear: Toothing, pin: float) -> bool:
    value = plain(gear.solid_half if gear.internal else gear.hollow_half)
    half = pin / plain(2.0 * gear.base_radius * gear.base_helix_cosine)
    inside = value > half if gear.internal else half > value
    return inside and pin_trouble(gear, pin) is None


# ---- chords ----


def chordal(gear: Toothing, allowances: "tuple[float | None, float | None]") -> Chord:
    """Chordal thickness at the pitch circle; of a helical gear, of the equivalent spur gear z/cos³β."""
    cosine = cos(gear.helix_angle)
    equivalent = gear.teeth / (cosine * cosine * cosine)
    diameter = equivalent * gear.module

    def half_angle(shift: float) -> float:
        own = -shift if gear.internal else shift
        return (0.5 * pi_beside(own, gear.module) + 2.0 * own * tan(gear.pressure_angle)) / equivalent

    half = half_angle(gear.shift)
    require(
        half > 0.0, "the teeth have no thickness at the pitch circle: half angle {0:.6g} rad", half, code="no-tooth"
    )
    upper, lower = (None if one is None else diameter * sin(half_angle(thinned(gear, one))) for one in allowances)
    rise = diameter * sin(0.5 * half) * sin(0.5 * half)
    addendum = gear.pitch_radius - gear.tip if gear.internal else gear.tip - gear.pitch_radius
    return Chord(
        thickness=diameter * sin(half),
        thickness_upper=upper,
        thickness_lower=lower,
        height=addendum - rise if gear.internal else addendum + rise,
    )


def shift_from_chord(gear: Toothing, thickness: float) -> float:
    """The profile shift whose chordal thickness at the pitch circle is `thickness`."""
    cosine = cos(gear.helix_angle)
    equivalent = gear.teeth / (cosine * cosine * cosine)
    sine = thickness / (equivalent * gear.module)
    require(sine < 1.0, "a chord of {0:.6g} mm is longer than the pitch diameter", 1e3 * thickness, code="chord")
    own = 0.5 * (asin(sine) * equivalent - 0.5 * pi_beside(sine)) / tan(gear.pressure_angle)
    return -own if gear.internal else own


def constant_chord(gear: Toothing, allowances: "tuple[float | None, float | None]") -> Chord:
    """The chord where a rack's flanks touch both sides of the tooth: s cos²α, the same for any number of teeth."""
    require(not gear.internal, "the constant chord belongs to external gears", code="constant-chord")
    sine, cosine = sin(gear.pressure_angle), cos(gear.pressure_angle)

    def chord(shift: float) -> float:
        return gear.module * (0.5 * pi_beside(gear.module) * cosine * cosine + 2.0 * shift * sine * cosine)

    thickness = chord(gear.shift)
    upper, lower = (None if one is None else chord(thinned(gear, one)) for one in allowances)
    height = gear.tip - gear.pitch_radius - 0.5 * thickness * sine / cosine
    require(height > 0.0, "the constant chord lies {0:.6g} mm above the tips", -1e3 * height, code="constant-chord")
    return Chord(thickness=thickness, thickness_upper=upper, thickness_lower=lower, height=height)
