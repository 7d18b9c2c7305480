"""The size over two pins or balls, or between them in an internal gear."""

from dynamics_cli.errors import require
from dynamics_cli.gear.measure.sizes import flank_radii, thinned, with_shift
from dynamics_cli.gear.single.toothing import Toothing
from dynamics_cli.gear.single.trochoid import roll_less_arc
from dynamics_cli.numerics.elementary import atan, cos, pi_beside, sin, sqrt, tan
from dynamics_cli.numerics.involute import inverse_involute
from dynamics_cli.numerics.number import over_plain, plain
from dynamics_cli.quantities import Annotated, Ratio, Size
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

# Flanks inclined more than this to their middle hold no pin of sensible size.
_WIDEST = 1.5
# Van Keuren's wire for external gears, in modules.
_USUAL = 1.728


@record
class Pins:
    """Size over two pins or balls (between them in an internal gear)."""

    pin: Annotated[Size, "Their diameter, D_M [m]."]
    ideal_pin: Annotated[Size | None, "The diameter that touches at d + 2 x m [m]."]
    size: Annotated[Size, "M_dK, for the nominal thickness [m]."]
    size_upper: Annotated[Size | None, "M_dK at the upper allowance of the thickness [m]."]
    size_lower: Annotated[Size | None, "M_dK at the lower allowance [m]."]
    contact_diameter: Annotated[Size, "Diameter where they touch the flanks [m]."]
    centre_diameter: Annotated[Size, "Diameter on which their centres lie [m]."]


def _odd(gear: Toothing) -> float:
    return cos(0.5 * pi_beside(gear.module) / gear.teeth) if gear.teeth % 2 else 1.0


def pin_roll(gear: Toothing, pin: float) -> float:
    """Roll angle tan α_K of the circle of the pins' centres."""
    half = pin / (2.0 * gear.base_radius * gear.base_helix_cosine)
    value = gear.solid_half - half if gear.internal else half - gear.hollow_half
    require(
        value > 0.0,
        "a pin of {pin:6} drops to the base circle: inv α_K would be {involute:6}",
        pin=(pin, Size),
        involute=(value, Ratio),
        code="pin-off-flank",
        hint="take a larger pin" if not gear.internal else "take a smaller pin",
    )
    return tan(inverse_involute(value))


def pin_size(gear: Toothing, pin: float) -> float:
    """M = d_K + D_M (between pins d_K − D_M), d_K shortened by cos 90°/z for an odd number of teeth (ISO 21771)."""
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
    """The diameter that touches at d + 2xm; None where the flanks of few teeth open so widely that no pin does.

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
        "the pins' centres would lie on {across:9}, inside the base circle of {base_radius:9}",
        across=(across, Size),
        base_radius=(2.0 * gear.base_radius, Size),
        code="pin-off-flank",
    )
    value = roll_less_arc(sqrt((ratio - 1.0) * (ratio + 1.0)))
    half = pin / (2.0 * gear.base_radius * gear.base_helix_cosine)
    shift_angle = (value + half if gear.internal else value - half) - gear.pitch_involute
    space = 0.5 * pi_beside(shift_angle) / gear.teeth
    shift_angle = shift_angle - space if gear.internal else shift_angle + space
    return 0.5 * shift_angle * gear.teeth / tan(gear.pressure_angle)


def standard_pins(near: float) -> "Iterator[float]":
    """Standard pins and balls, nearest first: in tenths of mm below 2 mm, halves below 12 mm, then whole mm."""
    step = 1e-4 if near < 2e-3 else 5e-4 if near < 12e-3 else 1e-3
    middle = round(near / step)
    for index in sorted(range(max(1, middle - 12), middle + 13), key=lambda index: abs(index * step - near)):
        # 3.5 mm as written, not as a rounded product
        yield index / (1.0 / step)


def pin_fault(gear: Toothing, pin: float) -> "tuple[str, float, float] | None":
    """The fault of a pin, as a sentence with its two decisive diameters; None if it can be used."""
    contact, (low, high) = plain(pin_contact(gear, pin)), flank_radii(gear)
    first, last = ("tip", "form") if gear.internal else ("form", "tip")
    if contact < low:
        return f"a pin of {{pin:6}} touches at {{at:6}} diameter, below the {first} diameter {{limit:6}}", contact, low
    if contact > high:
        return f"a pin of {{pin:6}} touches at {{at:6}} diameter, beyond the {last} diameter {{limit:6}}", contact, high
    centre = plain(gear.base_radius * sqrt(1.0 + pin_roll(gear, pin) * pin_roll(gear, pin)))
    half, root, tip = 0.5 * plain(pin), plain(gear.root), plain(gear.tip)
    inwards = 1.0 if gear.internal else -1.0
    bottom, top = centre + inwards * half, centre - inwards * half
    if inwards * (bottom - root) > 0.0:
        return "a pin of {pin:6} meets the root: it reaches {at:6} diameter, the root lies at {limit:6}", bottom, root
    if inwards * (top - tip) > 0.0:
        text = "a pin of {pin:6} does not protrude from the space: it ends at {at:6} diameter, the tips at {limit:6}"
        return text, top, tip
    return None


def pins(gear: Toothing, pin: float | None, allowances: "tuple[float | None, float | None]") -> Pins:
    """The size over pins of a given diameter, or of the standard one nearest the ideal."""
    ideal = ideal_pin(gear)
    chosen = pin
    if chosen is None:
        near = _USUAL * plain(gear.module) if ideal is None else plain(ideal)
        doubles = over_plain(gear)
        chosen = next((item for item in standard_pins(near) if _serves(doubles, item)), None)
        require(chosen is not None, "no standard pin touches on the flanks", code="pin-off-flank", hint="give --pin")
        assert chosen is not None
    else:
        require(chosen > 0.0, "the pin diameter {pin:6} must be above zero", pin=(chosen, Size), code="pin")
        fault = pin_fault(over_plain(gear), plain(chosen))
        if fault is not None:
            text, diameter, limit = fault
            require(
                False,
                text,
                pin=(chosen, Size),
                at=(2.0 * diameter, Size),
                limit=(2.0 * limit, Size),
                ideal=(ideal, Size),
                code="pin-off-flank",
                hint=None if ideal is None else "the ideal is {ideal:6}",
            )
    roll = pin_roll(gear, chosen)
    upper, lower = (
        None if item is None else pin_size(with_shift(gear, thinned(gear, item)), chosen) for item in allowances
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
    return inside and pin_fault(gear, pin) is None
