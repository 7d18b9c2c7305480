"""Critical speeds, whirl and Campbell diagram of a stepped shaft with disks on several bearings."""

import math

from dynamics_cli.quantities import (
    Annotated,
    Count,
    Density,
    Frequency,
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
from dynamics_cli.sampling import cost, drawing
from dynamics_cli.vibration.rotors.beam_elements import critical_rates, whirl_rates
from dynamics_cli.vibration.rotors.stepped import (
    ELEMENTS,
    FEW_ELEMENTS,
    Disk,
    Material,
    Section,
    assembled,
    checked,
    require_held,
)
from dynamics_cli.vibration.shafts.campbell import BACKWARD, FORWARD, WhirlCritical

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.vibration.rotors.beam_elements import Matrices

MODES, DIAGRAM_STEPS = 3, 12
# Seconds of a sample of uncertain inputs.
COST = 0.002
# A running speed this near to a critical one is warned of.
MARGIN = 0.2
# A deflection below this share of the largest is rounding.
NOTHING = 1e-9


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
    second_critical_speed: Annotated[ShaftSpeed | None, "Second critical speed of forward whirl [rad/s]."]
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
    poisson_ratio: Annotated[Ratio, "Of the shaft; steel unless given, e.g. 0.3."] = 0.3,
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
    Beams with shear, rotary inertia and gyroscopic moments of shaft and disks; damping is left out.

    References
    ----------
    Timoshenko beam elements, shear coefficient of Cowper; checked against transfer matrices of the exact equations.

    Examples
    --------
    >>> shaft = Section(1.0, 0.02)
    >>> made = rotor(sections=shaft, bearings=(Bearing(0.0), Bearing(1.0)))
    >>> round(made.critical_speed, 1)
    255.2
    """
    stretches = sections if isinstance(sections, tuple) else (sections,)
    material = Material(elastic_modulus, poisson_ratio, density)
    places = [bearing.position for bearing in bearings]
    volume, ends = checked(stretches, disk=[disk.position for disk in disks], bearing=places)

    def held(elements: int) -> "Matrices":
        system = assembled(stretches, ends, disks, places, material, elements)
        for bearing in bearings:
            system.add_bearing(bearing.position, bearing.stiffness, bearing.tilting)
        return system

    system = held(FEW_ELEMENTS if drawing() else ELEMENTS)
    *matrices, rest = system.free()
    holding = {bearing.position for bearing in bearings if bearing.stiffness != 0.0}
    rounding = require_held(holding, any(bearing.tilting > 0.0 for bearing in bearings), matrices[2])
    unbalance = critical_rates(matrices, 1.0, 1.0, MODES)
    rates = [rate for rate, _ in unbalance]
    nearest = min(rates, key=lambda rate: abs(rate - abs(speed or 0.0)), default=None)
    margin = abs(speed) / nearest if speed and nearest else None
    numbers: dict[str, Any] = {
        "critical_speed": rates[0] if rates else None,
        "second_critical_speed": rates[1] if len(rates) > 1 else None,
        "margin": margin,
        "mass": volume * density + sum(disk.mass for disk in disks),
    }
    if drawing():
        cost(0.0, COST, 1)
        return RotorCriticals(**numbers, criticals=(), whirls=None, campbell=(), shapes=(), numerics=Numerics(""))
    check = critical_rates(held(ELEMENTS // 2).free()[:3], 1.0, 1.0, MODES)
    criticals = _criticals(matrices, orders)
    top = highest_speed or 1.5 * (rates[:2] or [criticals[-1].speed])[-1]
    return RotorCriticals(
        **numbers,
        criticals=criticals,
        whirls=None if speed is None else _whirls(matrices, abs(speed)),
        campbell=tuple(
            RotorAtSpeed(top * k / DIAGRAM_STEPS, *_frequencies(matrices, top * k / DIAGRAM_STEPS))
            for k in range(DIAGRAM_STEPS + 1)
        ),
        shapes=_shapes(system.stations, rest, [shape for _, shape in unbalance]),
        numerics=Numerics(_method(unbalance, check, rounding)),
        advice=_advice(margin),
    )


def _criticals(matrices: "Sequence[Any]", orders: "Sequence[float]") -> "tuple[WhirlCritical, ...]":
    """Where the orders meet whirls, by speed."""
    criticals = [
        WhirlCritical(rate / order, order, way, number, rate / (2.0 * math.pi))
        for order in orders
        for way, sign in ((FORWARD, 1.0), (BACKWARD, -1.0))
        for number, (rate, _) in enumerate(critical_rates(matrices, order, sign, MODES), 1)
    ]
    return tuple(sorted(criticals, key=lambda row: row.speed))


def _whirls(matrices: "Sequence[Any]", speed: float) -> "tuple[RotorWhirl, ...]":
    return tuple(RotorWhirl(n, *pair) for n, pair in enumerate(zip(*_frequencies(matrices, speed), strict=False), 1))


def _method(fine: "list[tuple[float, Any]]", coarse: "list[tuple[float, Any]]", rounding: float) -> str:
    """The method, with how far half as many elements move the first critical speeds: four times the error."""
    apart = max((abs(a / b - 1.0) for (a, _), (b, _) in zip(fine, coarse, strict=False)), default=0.0) / 3.0 + rounding
    return f"beam elements, symmetric eigenvalues; critical speeds of unbalance to about {apart:.0e}"


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
