"""Torsional vibration of a shaft line with gears and branches: frequencies, shapes, critical speeds by engine order."""

import math

from dynamics_cli.errors import require, worded
from dynamics_cli.quantities import (
    Annotated,
    Count,
    DampingRatio,
    Fraction,
    Frequency,
    Positive,
    Ratio,
    ShaftSpeed,
    Text,
)
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record
from dynamics_cli.vibration.shafts.line import Gear, Rotor, Shaft, ShaftLine
from dynamics_cli.vibration.systems.modes import undamped

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.vibration.systems.elements import Elements

# A critical speed this near to the range of running is warned of.
MARGIN = 0.2
AGREE = 1e-9


@record
class TorsionMode:
    """A torsional mode."""

    number: Annotated[Count, "From the lowest that is not rigid [-]."]
    frequency: Annotated[Frequency, "Natural frequency [Hz]."]
    speed: Annotated[ShaftSpeed, "Critical speed of order one [rad/s]."]
    nodes: Annotated[Count, "Shafts that have a node [-]."]
    damping_ratio: Annotated[DampingRatio | None, "Damping over critical damping, from the dampers of shafts [-]."]
    angles: Annotated[tuple[Ratio, ...], "Angles of the rotors in their order, each in its sense [-]."]
    twisted: Annotated[Text, "The shaft that holds most of the energy."]
    twisted_share: Annotated[Fraction, "Its share of the energy of twist [-]."]


@record
class Critical:
    """A critical speed."""

    speed: Annotated[ShaftSpeed, "Speed of the reference rotor [rad/s]."]
    order: Annotated[Ratio, "Excitation per turn of the reference rotor [-]."]
    mode: Annotated[Count, "The mode excited [-]."]
    frequency: Annotated[Frequency, "Its frequency [Hz]."]
    place: Annotated[Text, "In the range of running, near to it, or off."]


@record
class TorsionalLine:
    """Torsional vibration of a shaft line."""

    first_frequency: Annotated[Frequency | None, "Lowest natural frequency above zero [Hz]."]
    second_frequency: Annotated[Frequency | None, "The next one [Hz]."]
    third_frequency: Annotated[Frequency | None, "The one after [Hz]."]
    critical_speed: Annotated[ShaftSpeed | None, "Critical speed nearest to the range of running, or lowest [rad/s]."]
    rotors: Annotated[Text, "The rotors in the order of the angles."]
    rigid_modes: Annotated[Count, "1 for a line that turns freely [-]."]
    modes: Annotated[tuple[TorsionMode, ...], "The modes from the lowest."]
    criticals: Annotated[tuple[Critical, ...] | None, "Critical speeds, from the lowest."]
    modes_below: Annotated[Count | None, "Modes below the frequency given, rigid ones left out [-]."]
    numerics: Numerics | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def shaft(
    *,
    rotors: Annotated[tuple[Rotor, ...], "The inertias."],
    shafts: Annotated[tuple[Shaft, ...], "The shafts between them."],
    gears: Annotated[tuple[Gear, ...], "Rotors that mesh."] = (),
    reference: Annotated[Text, "The rotor that speeds and orders are of; the first unless given."] = "",
    orders: Annotated[tuple[Positive, ...], "Excitations per turn of the reference rotor, e.g. 0.5, 1, 2."] = (),
    lowest_speed: Annotated[ShaftSpeed | None, "Lowest speed of running, e.g. 600 rpm."] = None,
    highest_speed: Annotated[ShaftSpeed | None, "Highest speed of running, e.g. 2200 rpm."] = None,
    below: Annotated[Frequency | None, "Count the modes below this frequency, e.g. 100 Hz."] = None,
) -> TorsionalLine:
    """Torsional frequencies of a shaft line with gears and branches, and its critical speeds by order.

    Equation
    --------
    Behind a gear, J and k count with the square of the speed over that of the reference; ω are the singular values of
    √k·A·J^{−½}. Order h meets frequency f at n = 60·f/h rpm.

    Returns
    -------
    TorsionalLine
        Frequencies, shapes, nodes, critical speeds and how far they lie from the range of running.

    Raises
    ------
    InadmissibleError
        When names are unknown or given twice, gears lock the line, a rotor has neither inertia nor shaft, or a range of
        speeds is upside down.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 13.7; Holzer's method.

    Examples
    --------
    >>> from dynamics_cli.vibration.shafts.line import Rate
    >>> made = shaft(rotors=(Rotor("a", 1.0), Rotor("b", 1.0)), shafts=(Shaft("a", "b", Rate(2.0)),))
    >>> round(made.modes[0].speed, 9)
    2.0
    """
    line = ShaftLine(rotors, shafts, gears, reference)
    elements: Any = line.system.elements
    omega, shapes, errors, numerics = undamped(line.system)
    moving = omega > 0.0
    rigid, whole = int((~moving).sum()), line.system.whole(shapes[moving]).tolist()
    rows = [_mode(line, nth, *pair) for nth, pair in enumerate(zip(omega[moving].tolist(), whole, strict=True), 1)]
    low, high = _range(lowest_speed, highest_speed)
    criticals = _criticals(rows, orders, low, high)
    bounds = tuple(
        ErrorBound(f"modes[{nth}].{name}", error)
        for nth, error in enumerate(errors[moving].tolist()) if error
        for name in ("frequency", "speed")
    )  # fmt: skip
    return TorsionalLine(
        rotors=", ".join(line.names),
        rigid_modes=rigid,
        first_frequency=rows[0].frequency if rows else None,
        second_frequency=rows[1].frequency if len(rows) > 1 else None,
        third_frequency=rows[2].frequency if len(rows) > 2 else None,
        critical_speed=_nearest([one.speed for one in criticals or ()], low, high),
        modes=tuple(rows),
        criticals=criticals,
        modes_below=None if below is None else sum(row.frequency < below for row in rows),
        numerics=Numerics(numerics.method, bounds),
        checks=_checks(elements, omega[moving], shapes[moving]),
        advice=(*line.system.advice, *_advice(criticals)),
    )


def _mode(line: ShaftLine, nth: int, value: float, shape: "list[float]") -> TorsionMode:
    angles = line.angles(shape)
    largest = max(angles, key=abs)
    twists = []
    for one in line.shafts:
        ends = [0.0 if name not in line.names else angles[line.names.index(name)] for name in (one.from_, one.to)]
        twists.append((one.spring.rate * (ends[0] - ends[1]) ** 2, ends, one))
    whole = math.fsum(energy for energy, _, _ in twists)
    energy, _, most = max(twists, key=lambda part: part[0])
    damped = math.fsum(one.damping * (ends[0] - ends[1]) ** 2 for _, ends, one in twists)
    return TorsionMode(
        number=nth,
        frequency=value / (2.0 * math.pi),
        speed=value,
        nodes=sum(ends[0] * ends[1] < 0.0 for _, ends, _ in twists),
        damping_ratio=0.5 * damped / value if damped else None,
        angles=tuple(angle / largest for angle in angles),
        twisted=f"{most.from_}–{most.to}",
        twisted_share=energy / whole,
    )


def _range(low: "float | None", high: "float | None") -> "tuple[float | None, float | None]":
    if low is not None and high is not None:
        require(
            high >= low,
            "the highest speed of {high} lies below the lowest of {low}",
            high=(high, ShaftSpeed),
            low=(low, ShaftSpeed),
            code="range",
        )
    return low, high


def _criticals(
    rows: "list[TorsionMode]", orders: "tuple[float, ...]", low: "float | None", high: "float | None"
) -> "tuple[Critical, ...] | None":
    """Every meeting of an order with a mode, by speed."""
    if not orders:
        return None
    made = []
    for order in orders:
        for row in rows:
            speed = row.speed / order
            inside = (low is None or speed >= low) and (high is None or speed <= high)
            near = (low is None or speed >= low / (1.0 + MARGIN)) and (high is None or speed <= high * (1.0 + MARGIN))
            place = "" if low is None and high is None else "in range" if inside else "near" if near else "off"
            made.append(Critical(speed, order, row.number, row.frequency, place))
    return tuple(sorted(made, key=lambda one: one.speed))


def _nearest(speeds: "list[float]", low: "float | None", high: "float | None") -> "float | None":
    """The speed nearest to the range of running, of several within it the lowest."""
    low, high = low or 0.0, math.inf if high is None else high
    return min(speeds, key=lambda speed: max(low / speed, speed / high, 1.0), default=None)


def _checks(elements: "Elements", omega: "Any", shapes: "Any") -> "tuple[Check, ...]":
    worst = float(abs(elements.rayleigh(shapes) / omega - 1.0).max(initial=0.0))
    return (Check("element Rayleigh quotients", worst <= AGREE, worst, AGREE),)


def _advice(criticals: "tuple[Critical, ...] | None") -> "tuple[Advice, ...]":
    inside = [one for one in criticals or () if one.place == "in range"]
    if not inside:
        return ()
    text = "{count} critical speeds lie in the range of running, the lowest at {speed} (order {order})"
    words = worded(text, count=str(len(inside)), speed=(inside[0].speed, ShaftSpeed), order=(inside[0].order, Ratio))
    return (Advice("critical-speed", words, remedy="detune by stiffness or inertia, or fit a damper"),)
