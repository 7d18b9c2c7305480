"""Response to unbalance, damping and stability of a rotor on bearings of eight coefficients."""

import cmath
import math

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.roots import highest
from dynamics_cli.quantities import (
    Annotated,
    Density,
    Pressure,
    Ratio,
    ShaftSpeed,
    Size,
)
from dynamics_cli.records import Advice
from dynamics_cli.sampling import cost, drawing
from dynamics_cli.vibration.rotors.orbit_records import (
    Bearing,
    RotatingLoad,
    RotorCritical,
    RotorMode,
    RotorModes,
    RotorOrbit,
    RotorResponse,
    Unbalance,
)
from dynamics_cli.vibration.rotors.orbits import Rotor, Support, axes, growth, lag
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

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

MODES, CRITICALS, ROWS, GRID = 4, 6, 30, 200
# Of a sample of uncertain inputs, rows that look for an onset, speeds that look for peaks, and its seconds.
FEWER_ROWS, FEWER, COST = 5, 40, 0.008
# A running speed this near to a peak is warned of.
MARGIN = 0.2
# Growth over frequency that is no rounding; how far a peak or the onset is narrowed, and that of a sample.
GROWS, NARROW, ROUGHLY = 1e-9, 1e-9, 1e-5


def rotor_response(
    *,
    sections: Annotated[Section | tuple[Section, ...], "The shaft from its left end."],
    bearings: Annotated[tuple[Bearing, ...], "Its bearings."],
    disks: Annotated[tuple[Disk, ...], "Disks on it."] = (),
    unbalances: Annotated[tuple[Unbalance, ...], "Unbalances."] = (),
    speed: Annotated[ShaftSpeed | None, "Running speed, e.g. 3000 rpm."] = None,
    highest_speed: Annotated[
        ShaftSpeed | None, "End of the range; half beyond the second critical speed unless given, e.g. 9000 rpm."
    ] = None,
    read_at: Annotated[tuple[Size, ...], "Places read; the disks unless given, e.g. 400 mm, 970 mm."] = (),
    elastic_modulus: Annotated[Pressure, "Of the shaft; steel unless given, e.g. 210000 MPa."] = 210e9,
    poisson_ratio: Annotated[Ratio, "Of the shaft; steel unless given, e.g. 0.3."] = 0.3,
    density: Annotated[Density, "Of the shaft; steel unless given, e.g. 7850 kg/m^3."] = 7850.0,
) -> RotorResponse:
    """Response to unbalance, damping and onset of instability of a rotor on real bearings.

    Equation
    --------
    M·q̈ + (C + ΩJ)·q̇ + (K + ΩS)·q = Ω²·u·e^{iΩt} for q = (x, y) of beam elements; free whirl e^{st} with logarithmic
    decrement −2π·Re s/Im s; a film that turns at λΩ adds S = λ·C·[[0, 1], [−1, 0]].

    Returns
    -------
    RotorResponse
        Orbits and forces at the running speed, peaks over speed, decrements, the onset of instability.

    Raises
    ------
    InadmissibleError
        When sizes are not above zero, something lies off the shaft, or the bearings leave the shaft free.

    Notes
    -----
    Coefficients of bearings hold at every speed; damping within the shaft is left out, and so are whirls damped beyond
    half the critical damping.

    References
    ----------
    Timoshenko beam elements, shear coefficient of Cowper; checked against transfer matrices of the exact equations.

    Examples
    --------
    >>> soft = (Bearing(0.0, 1e7, 2e7, 1e3), Bearing(1.0, 1e7, 2e7, 1e3))
    >>> made = rotor_response(sections=Section(1.0, 0.05), bearings=soft, speed=100.0)
    >>> round(made.modes[0].frequency, 3), round(made.modes[0].decrement, 4)
    (90.047, 0.0386)
    """
    system, stations, rotor = built(sections, bearings, disks, unbalances, read_at, Material(
        elastic_modulus, poisson_ratio, density))  # fmt: skip
    criticals = rotor.criticals(CRITICALS)
    running = abs(speed) if speed else None
    top = max(abs(highest_speed or 0.0) or default_top(rotor, speed), running or 0.0)
    count = FEWER_ROWS if drawing() else ROWS
    if drawing():
        cost(0.0, COST, 1)
    steps = [top * k / count for k in range(count + 1)]
    rates = [rotor.rates(at) for at in steps]
    onset, frequency = _onset(rotor, steps, rates) or (None, None)
    damped = any(bearing.cxx or bearing.cyy for bearing in bearings)
    places = [(system.stations[station], station) for station in stations]
    peaks = _peaks(rotor, places, top) if unbalances and damped else None
    nearest = min((row.speed for row in peaks or ()), key=lambda at: abs(at - (running or 0.0)), default=None)
    margin = running / nearest if running and nearest else None
    modes = None
    if running is not None:
        modes = tuple(RotorMode(*_mode(rate), way) for rate, way in rotor.modes(running, MODES))
    orbits = loads = None
    if running is not None and unbalances:
        orbits, loads = _running(rotor, places, bearings, running)
    return RotorResponse(
        onset=onset,
        stable_to=top if onset is None else None,
        onset_frequency=frequency,
        critical_speed=min((row.speed for row in peaks or ()), default=None),
        amplitude=max((row.major for row in orbits or ()), default=None),
        force=max((max(row.horizontal, row.vertical) for row in loads or ()), default=None),
        margin=margin,
        decrement=min((row.decrement for row in modes or ()), default=None),
        modes=modes,
        orbits=orbits,
        loads=loads,
        peaks=peaks or None,
        criticals=tuple(RotorCritical(*row) for row in criticals),
        over_speed=tuple(orbit(rotor, *place, at, rotor.response(at)) for place in places for at in steps[1:])
        if unbalances and not drawing()
        else None,
        campbell=tuple(
            RotorModes(at, *zip(*map(_mode, each[:MODES]), strict=True)) for at, each in zip(steps, rates, strict=True)
        ),
        advice=_advice(onset, running, margin, bool(unbalances) and not damped),
    )  # fmt: skip


def _running(
    rotor: Rotor, places: "Sequence[tuple[float, int]]", bearings: "Sequence[Bearing]", speed: float
) -> "tuple[tuple[RotorOrbit, ...], tuple[RotatingLoad, ...]]":
    """Orbits and forces on the bearings at a speed."""
    motion = rotor.response(speed)
    loads = tuple(
        RotatingLoad(bearing.position, *map(abs, rotor.reaction(support, speed, motion)))
        for bearing, support in zip(bearings, rotor.supports, strict=True)
    )
    return tuple(orbit(rotor, *place, speed, motion) for place in places), loads


def built(
    sections: "Any", bearings: "Sequence[Bearing]", disks: "Sequence[Disk]",
    unbalances: "Sequence[Unbalance]", read_at: "Sequence[float]", material: Material,
) -> "tuple[Any, list[int], Rotor]":  # fmt: skip
    """The elements, the stations that are read, and the rotor in two planes."""
    import numpy as np

    stretches = sections if isinstance(sections, tuple) else (sections,)
    marks = {
        "bearing": [bearing.position for bearing in bearings],
        "unbalance": [one.position for one in unbalances],
        "reading": list(read_at),
    }
    _, ends = checked(stretches, disk=[disk.position for disk in disks], **marks)
    system = assembled(stretches, ends, disks, [at for each in marks.values() for at in each], material,
                       FEW_ELEMENTS if drawing() else ELEMENTS)  # fmt: skip
    supports = []
    holding = set()
    for number, bearing in enumerate(bearings, 1):
        at = system.nearest(bearing.position)
        system.stiffness[2 * at + 1, 2 * at + 1] += bearing.tilting
        stiffness = damping = None
        require(bearing.kxx is not None or not (bearing.kyy or bearing.cxx or bearing.cyy or bearing.swirl),
                "bearing {number} has coefficients but no kxx", code="missing", number=str(number),
                hint="give kxx, or leave them out for a rigid bearing")  # fmt: skip
        if bearing.kxx is not None:
            vertical = bearing.kxx if bearing.kyy is None else bearing.kyy
            stiffness = np.array([[bearing.kxx, bearing.kxy], [bearing.kyx, vertical]])
            across = bearing.cxx if bearing.cyy is None else bearing.cyy
            damping = np.array([[bearing.cxx, bearing.cxy], [bearing.cyx, across]])
            require(min(bearing.kxx, vertical, bearing.cxx, across) >= 0.0,
                    "bearing {number} has a direct stiffness or damping below zero", code="negative",
                    number=str(number), hint="kxx, kyy, cxx and cyy are zero or more; kxy and kyx have signs",
                    )  # fmt: skip
            for name, (row, other) in (("k", stiffness), ("c", damping)):
                require((0.5 * (row[1] + other[0])) ** 2 <= row[0] * other[1],
                        "bearing {number} pushes the shaft away: {name}xy + {name}yx is too large beside {name}xx and "
                        "{name}yy", code="negative", number=str(number), name=name,
                        hint="of a bearing that turns the shaft, kxy and kyx have opposite signs")  # fmt: skip
        if stiffness is None or min(stiffness[0, 0], stiffness[1, 1]) > 0.0:
            holding.add(bearing.position)
        supports.append(Support(at, stiffness, damping, bearing.swirl))
    loads = [(system.nearest(one.position), cmath.rect(one.unbalance, one.angle)) for one in unbalances]
    places = read_at or [disk.position for disk in disks] or marks["unbalance"] or marks["bearing"]
    stations = sorted({system.nearest(place) for place in places})
    tilts = [system.nearest(disk.position) for disk in disks]
    rotor = Rotor(system, supports, loads, tilts)
    require_held(holding, any(bearing.tilting > 0.0 for bearing in bearings), rotor.alike)
    return system, stations, rotor


def default_top(rotor: Rotor, speed: "float | None") -> float:
    """The end of the range: half beyond the first two critical speeds and the running speed."""
    speeds = [at for at, _ in rotor.criticals(2)]
    return 1.5 * max(*speeds[:2], abs(speed or 0.0))


def orbit(rotor: Rotor, position: float, station: int, speed: float, motion: "Any") -> RotorOrbit:
    """The orbit of one place."""
    x, y = map(complex, rotor.at(station, motion))
    major, minor, way = axes(x, y)
    return RotorOrbit(position, speed, abs(x), lag(x), abs(y), lag(1j * y), major, minor, way)


def _mode(rate: complex) -> "tuple[float, float]":
    """Frequency and logarithmic decrement."""
    decrement = -2.0 * math.pi * rate.real / rate.imag
    return rate.imag / (2.0 * math.pi), decrement if abs(decrement) > GROWS else 0.0


def _onset(rotor: Rotor, speeds: "Sequence[float]", rates: "Sequence[list[complex]]") -> "tuple[float, float] | None":
    """The lowest speed at which a mode grows, and its frequency."""
    found = next((k for k, each in enumerate(rates) if growth(each) > GROWS), None)
    if found is None:
        return None
    low, high = speeds[max(found - 1, 0)], speeds[found]
    while high - low > (ROUGHLY if drawing() else NARROW) * high:
        half = 0.5 * (low + high)
        low, high = (low, half) if growth(rotor.rates(half)) > GROWS else (half, high)
    growing = max(rotor.rates(high), key=lambda rate: rate.real / abs(rate))
    return high, _mode(growing)[0]


def speeds_of(rotor: Rotor, top: float, count: int) -> "list[float]":
    """Speeds of a curve, closer about critical ones."""
    near = [at * (1.0 + sign * 10.0 ** (-k / 5.0)) for at, _ in rotor.criticals(CRITICALS) for sign in (-1.0, 1.0)
            for k in range(3, 21)]  # fmt: skip
    return sorted({*(top * k / count for k in range(1, count + 1)), *(at for at in near if 0.0 < at < top)})


def _peaks(rotor: Rotor, places: "Sequence[tuple[float, int]]", top: float) -> "tuple[RotorOrbit, ...]":
    speeds = speeds_of(rotor, top, FEWER if drawing() else GRID)
    motions = rotor.responses(speeds)
    narrow = ROUGHLY if drawing() else NARROW
    rows = []
    for position, station in places:

        def size(speed: float, at: int = station) -> float:
            return axes(*rotor.at(at, rotor.response(speed)))[0]

        sizes = [axes(*rotor.at(station, motion))[0] for motion in motions]
        for k in range(1, len(sizes) - 1):
            if sizes[k - 1] < sizes[k] >= sizes[k + 1]:
                speed = highest(size, speeds[k - 1], speeds[k + 1], narrow * speeds[k + 1])
                rows.append(orbit(rotor, position, station, speed, rotor.response(speed)))
    return tuple(rows)


def _advice(onset: "float | None", running: "float | None", margin: "float | None", bare: bool) -> "tuple[Advice, ...]":
    notes = []
    if onset is not None and (running is None or running >= onset):
        text = "a whirl grows by itself above {onset}" if onset else "a whirl grows by itself at every speed"
        remedy = "more damping, or less cross-coupling in the bearings"
        notes.append(Advice("unstable", worded(text, onset=(onset, ShaftSpeed)), "serious", remedy=remedy))
    if margin is not None and abs(margin - 1.0) <= MARGIN:
        text = "the running speed lies within 20 % of a peak of the response"
        notes.append(Advice("near-critical", text, remedy="change the speed, the bearings or the shaft"))
    if bare:
        text = "without damping there is no largest amplitude at a critical speed"
        notes.append(Advice("undamped", text, remedy="give cxx (and cyy) of a bearing", result="critical_speed"))
    return tuple(notes)
