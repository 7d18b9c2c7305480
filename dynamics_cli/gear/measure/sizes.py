"""Sizes that show the thickness of a tooth: span, chordal and constant-chord thickness."""

from dynamics_cli.errors import require
from dynamics_cli.gear.single.toothing import Toothing
from dynamics_cli.numerics.elementary import asin, cos, pi_beside, sin, sqrt, tan
from dynamics_cli.numerics.number import over_plain, plain
from dynamics_cli.quantities import Angle, Annotated, Count, Ratio, Size
from dynamics_cli.records import record


@record
class Span:
    """Base tangent length over several teeth (over spaces of an internal gear)."""

    over: Annotated[Count, "Teeth (or spaces) spanned, k."]
    span: Annotated[Size, "W_k, for the nominal thickness [m]."]
    span_upper: Annotated[Size | None, "W_k at the upper allowance of the thickness [m]."]
    span_lower: Annotated[Size | None, "W_k at the lower allowance [m]."]
    contact_diameter: Annotated[Size, "Diameter where the anvils touch [m]."]
    ideal_over: Annotated[Ratio, "The k, not a whole number, for contact at d + 2 x m."]
    least_face_width: Annotated[Size | None, "Face width that a helical gear needs for the anvils to touch [m]."] = None


@record
class Chord:
    """A thickness along a chord, and the height of the chord below the tips."""

    thickness: Annotated[Size, "The chord, for the nominal thickness [m]."]
    thickness_upper: Annotated[Size | None, "At the upper allowance [m]."]
    thickness_lower: Annotated[Size | None, "At the lower allowance [m]."]
    height: Annotated[Size, "From the tip circle to the chord, h_a with the arc's rise [m]."]


def thinned(gear: Toothing, allowance: float) -> float:
    """The profile shift that increases the normal tooth thickness by this amount (inwards for an internal gear)."""
    change = allowance / (2.0 * gear.module * tan(gear.pressure_angle))
    return gear.shift - change if gear.internal else gear.shift + change


def with_shift(gear: Toothing, shift: float) -> Toothing:
    """The same blank cut with another profile shift."""
    return Toothing(**{name: getattr(gear, name) for name in Toothing.__annotations__} | {"shift": shift})


# ---- span ----


def span_length(gear: Toothing, over: int) -> float:
    """W_k = m_n cos α_n ((k − ½) π + z inv α_t) + 2 x m_n sin α_n (ISO 21771)."""
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
        "d + 2xm = {reach:6} lies inside the base circle of {base:6}: there is no flank to span",
        reach=(2.0 * reach, Size),
        base=(2.0 * base, Size),
        code="span-off-flank",
    )
    length = 2.0 * base * gear.shifted_roll / gear.base_helix_cosine
    alpha = gear.pressure_angle
    turns = (length - 2.0 * gear.shift * gear.module * sin(alpha)) / (gear.module * cos(alpha))
    return (turns - gear.teeth * gear.pitch_involute) / pi_beside(turns) + 0.5


def spans_that_serve(gear: Toothing) -> list[int]:
    """Every number of teeth whose span touches on the flanks."""
    low, high = flank_radii(gear)
    most = max(gear.teeth // 2, int(2.0 * ideal_over(gear)))
    return [over for over in range(1, most + 2) if _touches(gear, span_length(gear, over), low, high)]


def _touches(gear: Toothing, length: float, low: float, high: float) -> bool:
    return length > 0.0 and low <= span_contact(gear, length) <= high


def flank_radii(gear: Toothing) -> tuple[float, float]:
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
    serving = spans_that_serve(over_plain(gear))
    chosen = over
    if chosen is None:
        require(bool(serving), "no span touches on the flanks", code="span-off-flank", hint="measure over pins")
        # halfway between two, rounding must not decide
        chosen = min(serving, key=lambda k: round(abs(k - plain(ideal)), 9))
    require(chosen >= 1, "a span is over one tooth at least", code="span-off-flank")
    length = span_length(gear, chosen)
    contact = span_contact(gear, length)
    low, high = flank_radii(gear)
    serves = f"{serving[0]} to {serving[-1]} teeth serve" if serving else "no number of teeth serves"
    if not low <= contact <= high:
        side, end = ("below", low) if contact < low else ("beyond", high)
        circle = "form" if gear.internal == (side == "beyond") else "tip"
        require(
            False,
            "the span over {over} teeth touches at {contact:6} diameter, {side} the {circle} circle of {end:6}",
            over=chosen,
            contact=(2.0 * contact, Size),
            side=side,
            circle=circle,
            end=(2.0 * end, Size),
            code="span-off-flank",
            hint=serves,
        )
    upper, lower = (None if a is None else span_length(with_shift(gear, thinned(gear, a)), chosen) for a in allowances)
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


# ---- chords ----


def chordal(gear: Toothing, allowances: "tuple[float | None, float | None]") -> Chord:
    """Chordal thickness at the pitch circle; of a helical gear, of the equivalent spur gear z/cos³β."""
    cosine = cos(gear.helix_angle)
    equivalent = gear.teeth / (cosine * cosine * cosine)
    diameter = equivalent * gear.module

    def half_angle(shift: float) -> float:
        signed_shift = -shift if gear.internal else shift
        return (0.5 * pi_beside(signed_shift, gear.module) + 2.0 * signed_shift * tan(gear.pressure_angle)) / equivalent

    half = half_angle(gear.shift)
    require(
        half > 0.0,
        "the teeth have no thickness at the pitch circle: half angle {half:6}",
        half=(half, Angle),
        code="no-tooth",
    )
    upper, lower = (None if a is None else diameter * sin(half_angle(thinned(gear, a))) for a in allowances)
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
    require(
        sine < 1.0,
        "a chord of {thickness:6} is longer than the pitch diameter",
        thickness=(thickness, Size),
        code="chord",
    )
    signed_shift = 0.5 * (asin(sine) * equivalent - 0.5 * pi_beside(sine)) / tan(gear.pressure_angle)
    return -signed_shift if gear.internal else signed_shift


def constant_chord(gear: Toothing, allowances: "tuple[float | None, float | None]") -> Chord:
    """The chord where a rack's flanks touch both sides of the tooth: s cos²α, the same for any number of teeth."""
    require(not gear.internal, "the constant chord is for external gears only", code="constant-chord")
    sine, cosine = sin(gear.pressure_angle), cos(gear.pressure_angle)

    def chord(shift: float) -> float:
        return gear.module * (0.5 * pi_beside(gear.module) * cosine * cosine + 2.0 * shift * sine * cosine)

    thickness = chord(gear.shift)
    upper, lower = (None if a is None else chord(thinned(gear, a)) for a in allowances)
    height = gear.tip - gear.pitch_radius - 0.5 * thickness * sine / cosine
    require(
        height > 0.0, "the constant chord lies {height:6} above the tips", height=(-height, Size), code="constant-chord"
    )
    return Chord(thickness=thickness, thickness_upper=upper, thickness_lower=lower, height=height)
