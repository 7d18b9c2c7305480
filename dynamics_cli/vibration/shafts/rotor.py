"""Critical speeds, whirl and Campbell diagram of a stepped shaft with disks on several bearings."""

import math
from itertools import pairwise

from dynamics_cli.errors import require
from dynamics_cli.quantities import (
    Annotated,
    Count,
    Density,
    Frequency,
    Inertia,
    Mass,
    Positive,
    Pressure,
    Ratio,
    ShaftSpeed,
    Size,
    SpringRate,
    TorsionStiffness,
)
from dynamics_cli.records import Advice, Numerics, record
from dynamics_cli.sampling import drawing
from dynamics_cli.vibration.shafts.beam_elements import Matrices, critical_rates, stations_of, whirl_rates
from dynamics_cli.vibration.shafts.campbell import BACKWARD, FORWARD, WhirlCritical

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

ELEMENTS, MODES, DIAGRAM_STEPS = 40, 3, 12
# A running speed this near to a critical one is warned of.
MARGIN = 0.2
# A place this share of the length beyond an end is rounding.
BEYOND = 1e-12
# A deflection below this share of the largest is rounding.
NOTHING = 1e-9
# Rounding of an element of a matrix; the share of a lowest frequency that is refused.
ROUNDING, POOR = 2.3e-16, 1e-3


@record
class Section:
    """A stretch of the shaft; sections follow one another from the left end."""

    length: Annotated[Size, "Length of the section, e.g. 200 mm."]
    diameter: Annotated[Size, "Diameter of the section, e.g. 50 mm."]
    bore: Annotated[Size, "Diameter of its bore, e.g. 20 mm."] = 0.0


@record
class Disk:
    """A rigid disk on the shaft."""

    position: Annotated[Size, "From the left end, e.g. 300 mm."]
    mass: Annotated[Mass, "Its mass, e.g. 30 kg."]
    polar_inertia: Annotated[Inertia, "About its axis, e.g. 0.5 kg*m^2."] = 0.0
    diametral_inertia: Annotated[
        Inertia | None, "About a diameter; half the polar one, as of a thin disk, unless given, e.g. 0.25 kg*m^2."
    ] = None


@record
class Bearing:
    """A bearing, the same in every direction."""

    position: Annotated[Size, "From the left end, e.g. 50 mm."]
    stiffness: Annotated[SpringRate | None, "Its stiffness; rigid unless given, e.g. 80 kN/mm."] = None
    tilting: Annotated[TorsionStiffness, "Stiffness against tilting of the shaft, e.g. 5000 N*m/rad."] = 0.0


@record
class RotorWhirl:
    """A free whirl at the running speed."""

    mode: Annotated[Count, "From the lowest of its direction [-]."]
    backward: Annotated[Frequency, "Frequency of backward whirl [Hz]."]
    forward: Annotated[Frequency, "Frequency of forward whirl [Hz]."]


@record
class RotorAtSpeed:
    """A row of the Campbell diagram."""

    speed: Annotated[ShaftSpeed, "Speed of the shaft [rad/s]."]
    backward: Annotated[tuple[Frequency, ...], "Backward whirls from the lowest [Hz]."]
    forward: Annotated[tuple[Frequency, ...], "Forward whirls from the lowest [Hz]."]


@record
class RotorPlace:
    """The bent shaft at one place, at the first critical speeds of unbalance; the largest deflection of each is 1."""

    position: Annotated[Size, "From the left end [m]."]
    first: Annotated[Ratio, "Deflection at the first critical speed [-]."]
    second: Annotated[Ratio | None, "At the second [-]."]
    third: Annotated[Ratio | None, "At the third [-]."]


@record
class RotorCriticals:
    """Critical speeds and whirls of a rotor."""

    critical_speed: Annotated[ShaftSpeed | None, "First critical speed of forward whirl, by unbalance [rad/s]."]
    margin: Annotated[Ratio | None, "Running speed over the nearest critical speed of unbalance [-]."]
    mass: Annotated[Mass, "Shaft and disks [kg]."]
    criticals: Annotated[tuple[WhirlCritical, ...], "Where the orders meet whirls, from the lowest speed."]
    whirls: Annotated[tuple[RotorWhirl, ...] | None, "Free whirls at the running speed."]
    campbell: Annotated[tuple[RotorAtSpeed, ...], "Whirl frequencies over speed."]
    shapes: Annotated[tuple[RotorPlace, ...], "Shapes of the shaft at the critical speeds of unbalance, by place."]
    numerics: Numerics
    advice: tuple[Advice, ...] = ()


def rotor(
    *,
    sections: Annotated[Section | tuple[Section, ...], "The shaft from its left end."],
    bearings: Annotated[tuple[Bearing, ...], "Its bearings."],
    disks: Annotated[tuple[Disk, ...], "Disks on it."] = (),
    speed: Annotated[ShaftSpeed | None, "Running speed, e.g. 3000 rpm."] = None,
    orders: Annotated[tuple[Positive, ...], "Excitations per turn; 1 is unbalance, e.g. 1, 2."] = (1.0,),
    highest_speed: Annotated[
        ShaftSpeed | None,
        "End of the Campbell diagram; beyond the second critical speed unless given, e.g. 9000 rpm.",
    ] = None,
    elastic_modulus: Annotated[Pressure, "Of the shaft; steel unless given, e.g. 210000 MPa."] = 210e9,
    density: Annotated[Density, "Of the shaft; steel unless given, e.g. 7850 kg/m^3."] = 7850.0,
) -> RotorCriticals:
    """Critical speeds and free whirl of a stepped shaft with disks on two or more bearings.

    Equation
    --------
    M·z̈ − iΩG·ż + K·z = 0 for z = x + iy by beam elements: (K + λΩG − λ²M)·z = 0 for whirl at λ, backward where λ < 0;
    order h is met where λ = ±hΩ, K·z = λ²(M ∓ G/h)·z.

    Returns
    -------
    RotorCriticals
        Critical speeds by order, whirls at the running speed, the Campbell diagram, shapes.

    Raises
    ------
    InadmissibleError
        When sizes are not above zero, disks or bearings lie off the shaft, or the bearings leave the shaft free.

    Notes
    -----
    Slender beams with rotary inertia and gyroscopic moments of shaft and disks; shear and damping are left out.

    References
    ----------
    Hermitian beam elements; checked against transfer matrices of the exact equations of each section.

    Examples
    --------
    >>> shaft = Section(1.0, 0.02)
    >>> made = rotor(sections=shaft, bearings=(Bearing(0.0), Bearing(1.0)))
    >>> round(made.critical_speed, 1)
    255.3
    """
    stretches = sections if isinstance(sections, tuple) else (sections,)
    shaft_mass, ends = _checked(stretches, disks, bearings)
    system, coarse = (
        _matrices(stretches, ends, disks, bearings, elastic_modulus, density, count)
        for count in (ELEMENTS, ELEMENTS // 2)
    )
    *matrices, rest = system.free()
    rounding = _require_held(bearings, matrices[2])
    unbalance = critical_rates(matrices, 1.0, 1.0, MODES)
    check = critical_rates(coarse.free()[:3], 1.0, 1.0, MODES)
    first = unbalance[0][0] if unbalance else None
    criticals = tuple(
        WhirlCritical(rate / order, order, way, number, rate / (2.0 * math.pi))
        for order in orders
        for way, sign in ((FORWARD, 1.0), (BACKWARD, -1.0))
        for number, (rate, _) in enumerate(critical_rates(matrices, order, sign, MODES), 1)
    )
    top = highest_speed or 1.5 * (unbalance[:2] or [(max(row.speed for row in criticals), None)])[-1][0]
    nearest = min((rate for rate, _ in unbalance), key=lambda rate: abs(rate - abs(speed or 0.0)), default=None)
    margin = abs(speed) / nearest if speed and nearest else None
    return RotorCriticals(
        critical_speed=first,
        margin=margin,
        mass=shaft_mass * density + sum(disk.mass for disk in disks),
        criticals=tuple(sorted(criticals, key=lambda row: row.speed)),
        whirls=None
        if speed is None
        else tuple(
            RotorWhirl(n, *pair) for n, pair in enumerate(zip(*_frequencies(matrices, abs(speed)), strict=False), 1)
        ),
        campbell=tuple(
            RotorAtSpeed(top * k / DIAGRAM_STEPS, *_frequencies(matrices, top * k / DIAGRAM_STEPS))
            for k in range(0 if drawing() else DIAGRAM_STEPS + 1)
        ),
        shapes=_shapes(system.stations, rest, [shape for _, shape in unbalance]),
        numerics=Numerics(_method(unbalance, check, rounding)),
        advice=_advice(margin),
    )


def _method(fine: "list[tuple[float, Any]]", coarse: "list[tuple[float, Any]]", rounding: float) -> str:
    """The method, with how far half as many elements move the first critical speeds: 16 times the error."""
    apart = max((abs(a / b - 1.0) for (a, _), (b, _) in zip(fine, coarse, strict=False)), default=0.0) / 15.0 + rounding
    return f"beam elements, symmetric eigenvalues; critical speeds of unbalance to about {apart:.0e}"


def _checked(stretches: "Any", disks: "Any", bearings: "Any") -> "tuple[float, list[float]]":
    """The volume of the shaft and where its sections end; refused are sizes and places that no shaft has."""
    volume, ends = 0.0, [0.0]
    for number, part in enumerate(stretches, 1):
        require(part.length > 0.0, "section {number} has no length", code="no-length", number=str(number))
        require(
            part.diameter > part.bore,
            "section {number} has a bore of {bore} in a diameter of {diameter}",
            code="section", number=str(number), bore=(part.bore, Size), diameter=(part.diameter, Size),
        )  # fmt: skip
        volume += math.pi / 4.0 * (part.diameter - part.bore) * (part.diameter + part.bore) * part.length
        ends.append(ends[-1] + part.length)
    for name, parts in (("disk", disks), ("bearing", bearings)):
        for number, part in enumerate(parts, 1):
            require(
                -BEYOND * ends[-1] <= part.position <= ends[-1] * (1.0 + BEYOND),
                "{name} {number} at {place} lies off the shaft, which is {length} long",
                code="position", name=name, number=str(number), place=(part.position, Size), length=(ends[-1], Size),
            )  # fmt: skip
    return volume, ends


def _matrices(
    stretches: "Any", ends: "list[float]", disks: "Any", bearings: "Any", modulus: float, density: float, elements: int
) -> Matrices:
    marks = [*ends, *(part.position for part in (*disks, *bearings))]
    system = Matrices(stations_of(marks, elements))
    for number, (low, high) in enumerate(pairwise(system.stations)):
        middle = 0.5 * (low + high)
        part = next((one for one, end in zip(stretches, ends[1:], strict=True) if middle < end), stretches[-1])
        area = math.pi / 4.0 * (part.diameter - part.bore) * (part.diameter + part.bore)
        second = area / 16.0 * (part.diameter**2 + part.bore**2)
        system.add_element(number, modulus * second, density * area, density * second)
    for disk in disks:
        across = 0.5 * disk.polar_inertia if disk.diametral_inertia is None else disk.diametral_inertia
        system.add_disk(disk.position, disk.mass, disk.polar_inertia, across)
    for bearing in bearings:
        system.add_bearing(bearing.position, bearing.stiffness, bearing.tilting)
    return system


def _require_held(bearings: "Any", stiffness: "Any") -> float:
    """Refuse a shaft that can move without bending; what rounding makes of its lowest frequency."""
    from scipy.linalg import eigvalsh

    holding = [bearing for bearing in bearings if bearing.stiffness != 0.0]
    places = {bearing.position for bearing in holding}
    tilting = any(bearing.tilting > 0.0 for bearing in bearings)
    require(
        len(places) > 1 or (len(places) == 1 and tilting),
        "the bearings leave the shaft free to move without bending",
        code="mechanism", hint="give two bearings at different places, or one that resists tilting (tilting=...)",
    )  # fmt: skip
    sizes = stiffness.diagonal() ** -0.5
    scaled = eigvalsh(sizes[:, None] * stiffness * sizes)
    rounding = ROUNDING * float(scaled[-1]) / max(float(scaled[0]), 1e-300)
    require(rounding < POOR, "the bearings are too soft beside the shaft: its lowest frequency is lost in rounding",
            code="soft-bearings", hint="check their stiffness and its unit")  # fmt: skip
    return rounding


def _frequencies(matrices: "Sequence[Any]", speed: float) -> "tuple[tuple[float, ...], tuple[float, ...]]":
    backward, forward = whirl_rates(matrices, speed, MODES)
    return tuple(rate / (2.0 * math.pi) for rate in backward), tuple(rate / (2.0 * math.pi) for rate in forward)


def _shapes(stations: "list[float]", rest: "Any", shapes: "list[Any]") -> "tuple[RotorPlace, ...]":
    columns: list[Any] = []
    for shape in shapes:
        deflections = [0.0] * len(stations)
        for number, value in zip(rest, shape, strict=True):
            if number % 2 == 0:
                deflections[number // 2] = float(value)
        largest = max(deflections, key=abs)
        columns.append([0.0 if abs(value) < NOTHING * abs(largest) else value / largest for value in deflections])
    columns += [[None] * len(stations)] * (MODES - len(columns))
    return tuple(RotorPlace(*row) for row in zip(stations, *columns, strict=True)) if shapes else ()


def _advice(margin: "float | None") -> "tuple[Advice, ...]":
    if margin is None or abs(margin - 1.0) > MARGIN:
        return ()
    text = "the running speed lies within 20 % of a critical speed of unbalance"
    return (Advice("near-critical", text, remedy="change the speed, the bearings or the diameter of the shaft"),)
