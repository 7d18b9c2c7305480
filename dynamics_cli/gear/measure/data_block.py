"""The data table on a gear's drawing: everything needed to make and to measure the gear."""

from math import pi

from dynamics_cli.gear import options
from dynamics_cli.gear.measure.measurement import Measurements, measure
from dynamics_cli.gear.pitch import Pitch
from dynamics_cli.gear.rounding import bare, carried, error_of
from dynamics_cli.gear.single.cylindrical import helical
from dynamics_cli.gear.single.rack import FULL_DEPTH
from dynamics_cli.gear.single.records import GearData
from dynamics_cli.gear.single.toothing_given import gear_inputs
from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF
from dynamics_cli.quantities import Annotated, Count, Ratio, Size, Teeth, Text
from dynamics_cli.records import Advice, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_DEGREES = 180.0 / pi


@record
class DataRow:
    """One line of the data block."""

    item: Annotated[Text, "What it is."]
    symbol: Annotated[Text, "Its symbol in ISO 21771."]
    data: Annotated[Text, "Its value for this gear."]
    unit: Annotated[Text, "Its unit."]


@record
class DataBlock:
    """The data block of a gear drawing."""

    rows: Annotated[tuple[DataRow, ...], "Its lines."]
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def data_block(
    *,
    teeth: Annotated[Teeth, "Number of teeth."],
    pitch: Annotated[Pitch, "Size of the teeth, normal or transverse."],
    helix_angle: options.HelixAngle = 0.0,
    hand: options.HelixHand = options.RIGHT,
    pressure_angle: options.PressureAngle = FULL_DEPTH,
    profile_shift: Annotated[Ratio, "Profile shift factor x."] = 0.0,
    profile: options.RackName = options.RACK_A,
    addendum_factor: options.AddendumFactor = None,
    dedendum_factor: options.DedendumFactor = None,
    root_radius_factor: options.RackCorner = None,
    internal: options.Internal = False,
    shift_sign: options.ShiftSign = options.ISO,
    upper_allowance: options.UpperAllowance = None,
    lower_allowance: options.LowerAllowance = None,
    face_width: Annotated[Size | None, "Face width b, e.g. 20 mm [m]."] = None,
    over: options.Over = None,
    pin: options.Pin = None,
    mate_teeth: Annotated[Teeth | None, "Number of teeth of the mating gear, e.g. 30."] = None,
    centre_distance: Annotated[Size | None, "Centre distance with the mating gear, e.g. 116.5 mm [m]."] = None,
    accuracy: Annotated[Text, "Accuracy grade, in the standard's words."] = "",
    drawing_number: Annotated[Text, "Drawing number of the mating gear."] = "",
    decimals: Annotated[Count, "Decimals of lengths in mm and angles in degrees, up to 9."] = 4,
) -> DataBlock:
    """The data block of a gear drawing, with its inspection sizes, as table, Markdown or CSV.

    Equation
    --------
    As `gear helical` and `gear measure`.

    Returns
    -------
    DataBlock
        The lines.

    Raises
    ------
    InadmissibleError
        When the gear is impossible.

    Notes
    -----
    Values are rounded, as on a drawing, and each row's bound adds the rounding to the error of the calculation;
    `gear helical` and `gear measure` give all digits.

    References
    ----------
    ISO 1340 (information to be given to the manufacturer), ISO 21771.

    Examples
    --------
    >>> from dynamics_cli.gear.pitch import NormalModule
    >>> data_block(teeth=24, pitch=NormalModule(0.003)).rows[0].data
    '24'
    """
    same = carried(gear_inputs(locals()))
    gear = helical(hand=hand, **same)
    sizes = measure(
        face_width=carried(face_width),
        over=over,
        pin=carried(pin),
        upper_allowance=carried(upper_allowance),
        lower_allowance=carried(lower_allowance),
        **same,
    )
    lines = _Lines(min(decimals, 9))
    lines.number("Number of teeth", "z", -teeth if internal else teeth)
    lines.length("Normal module", "m_n", gear.normal_module)
    lines.angle("Normal pressure angle", "α_n", pressure_angle)
    lines.word("Basic rack", "", rack_name(profile, addendum_factor, dedendum_factor, root_radius_factor))
    lines.angle("Helix angle", "β", abs(helix_angle))
    if gear.hand is not None:
        lines.word("Hand of helix", "", str(gear.hand))
        lines.length("Lead", "p_z", gear.lead)
    lines.factor("Profile shift factor", "x", gear.profile_shift)
    _circles(lines, gear)
    _inspection(lines, sizes, upper_allowance, lower_allowance)
    lines.length("Face width", "b", face_width)
    lines.word("Accuracy grade", "", accuracy)
    lines.number("Teeth of mating gear", "z₂", mate_teeth)
    lines.word("Drawing of mating gear", "", drawing_number)
    lines.length("Centre distance", "a_w", centre_distance)
    return DataBlock(tuple(lines.rows), gear.advice, Numerics("rounded to the requested decimals", tuple(lines.bounds)))


def rack_name(profile: str, *factors: float | None) -> str:
    """The basic rack as a drawing names it, with the factors that differ from the standard."""
    name = f"ISO 53 {profile.upper()}" if profile in ("a", "b", "c", "d") else str(profile)
    differing = [
        f"{symbol} {factor:g}"
        for symbol, factor in zip(("h_a*", "h_fP*", "ρ_fP*"), factors, strict=True)
        if factor is not None
    ]
    return ", ".join([name, *differing])


def _circles(lines: "_Lines", gear: GearData) -> None:
    lines.length("Reference diameter", "d", gear.reference_diameter)
    lines.length("Base diameter", "d_b", gear.base_diameter)
    lines.length("Tip diameter", "d_a", gear.tip_diameter)
    lines.length("Root diameter", "d_f", gear.root_diameter)
    lines.length("Root form diameter", "d_Ff", gear.root_form_diameter)
    lines.length("Tooth depth", "h", gear.tooth_depth)
    lines.length("Normal tooth thickness", "s_n", gear.normal_thickness)


def _inspection(lines: "_Lines", sizes: Measurements, upper: float | None, lower: float | None) -> None:
    lines.length("Upper thickness allowance", "E_sns", upper)
    lines.length("Lower thickness allowance", "E_sni", lower)
    span = sizes.span
    if span is not None:
        lines.number("Teeth to span", "k", span.over)
        lines.length("Span", "W_k", span.span)
        lines.length("Span, greatest", "W_k,s", span.span_upper)
        lines.length("Span, least", "W_k,i", span.span_lower)
    pins = sizes.pins
    if pins is not None:
        lines.length("Pin diameter", "D_M", pins.pin)
        lines.length("Size over pins", "M_d", pins.size)
        lines.length("Size over pins, of thickest teeth", "M_d,s", pins.size_upper)
        lines.length("Size over pins, of thinnest teeth", "M_d,i", pins.size_lower)


class _Lines:
    """The lines as they are written."""

    def __init__(self, decimals: int) -> None:
        self.decimals = decimals
        self.rows: list[DataRow] = []
        self.bounds: list[ErrorBound] = []

    def word(self, item: str, symbol: str, text: str, unit: str = "") -> None:
        """A line, unless it is empty."""
        if text:
            self.rows.append(DataRow(item, symbol, text, unit))

    def number(self, item: str, symbol: str, value: int | None) -> None:
        """A whole number."""
        if value is not None:
            self.word(item, symbol, str(value))

    def factor(self, item: str, symbol: str, value: "Any") -> None:
        """A pure number."""
        self._decimal(item, symbol, value, "+", "")

    def length(self, item: str, symbol: str, value: "Any") -> None:
        """A length in mm."""
        if value is not None:
            self._decimal(item, symbol, 1e3 * value, "", "mm")

    def angle(self, item: str, symbol: str, value: "Any") -> None:
        """An angle in degrees."""
        self._decimal(item, symbol, _DEGREES * value, "", "deg")

    def _decimal(self, item: str, symbol: str, value: "Any", sign: str, unit: str) -> None:
        """A number to so many decimals, with its bound: truncation, its own error, and unit conversion."""
        number = bare(value)
        text = f"{number:{sign}.{self.decimals}f}"
        off = abs(float(text) - number) + error_of(value) + 4.0 * UNIT_ROUNDOFF * abs(number)
        self.bounds.append(ErrorBound(f"rows[{len(self.rows)}].data", off, relative=False))
        self.word(item, symbol, text, unit)
