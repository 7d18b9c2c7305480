"""Properties of a coupler curve over its analytic parameter."""

import numpy as np

from dynamics_cli.linkage.fourbar.circuit import FULL, Circuit, CouplerPath
from dynamics_cli.linkage.fourbar.records import CurvePoint, Special
from dynamics_cli.numerics.fitting.outline import outlined
from dynamics_cli.numerics.lanes import sign_changes
from dynamics_cli.records import Columns

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.outlines import Outline

START, MOST = 72, 36_864
SETTLED = 1e-13
# A point slower than this share of its mean speed is at rest: the remainder is rounding.
STILL = 1e-7
SAMPLES = 1440
SEGMENTS = 360
STEPS = 8


def measures(circuit: Circuit, point: complex) -> "tuple[float, float, float]":
    """Length of the closed curve, an estimate of its error, and the enclosed area, anticlockwise positive."""
    count, before = START, np.inf
    while True:
        u = np.arange(count) * (FULL / count)
        x, y = circuit.place(u, point)
        length = float(np.hypot(x.parts[1], y.parts[1]).mean()) * FULL
        area = 0.5 * FULL * float((x.parts[0] * y.parts[1] - y.parts[0] * x.parts[1]).mean())
        error = abs(length - before)
        if error <= SETTLED * length or count >= MOST:
            return length, max(error, 4e-16 * length), area
        count, before = 2 * count, length


def _roots(function: "Any", value: "Any", u: "Any") -> "Any":
    """Places between samples where a function, which has these values at them, changes sign."""
    change = np.flatnonzero(np.sign(value) * np.sign(np.roll(value, -1)) <= 0.0)
    sign = np.where(value[change] < 0.0, -1.0, 1.0)
    return sign_changes(lambda place: sign * function(place), u[change], u[change] + FULL / u.size)


def extremes(circuit: Circuit, point: complex) -> "tuple[tuple[float, float], tuple[float, float]]":
    """Smallest and largest coordinates."""
    u = np.arange(SAMPLES) * (FULL / SAMPLES)
    ends = []
    for which, sampled in enumerate(circuit.place(u, point)):

        def slope(place: "Any", which: int = which) -> "Any":
            return circuit.place(place, point)[which].parts[1]

        turns = circuit.place(_roots(slope, sampled.parts[1], u), point)[which].parts[0]
        values = np.concatenate((turns, sampled.parts[0]))
        ends.append((float(values.min()), float(values.max())))
    return ends[0], ends[1]


def angle_at(circuit: Circuit, u: "Any") -> "Any":
    """Crank angles, from 0 to 360 degrees, or twice that where the motion takes two turns."""
    if circuit.full:
        return np.mod(u, FULL) * circuit.turns
    turn, across, _ = circuit.crank(u)
    angle = np.arctan2(across.parts[0], turn.parts[0])
    return angle if circuit.inner is None or circuit.outer is not None else np.mod(angle, FULL)


def cusp_places(circuit: Circuit, point: complex, length: float) -> "list[float]":
    """Where over the parameter the point stops: minima of its speed that are zero within rounding."""
    u = np.arange(SAMPLES) * (FULL / SAMPLES)

    def slope(place: "Any") -> "Any":
        x, y = circuit.place(place, point)
        return x.parts[1] * x.parts[2] + y.parts[1] * y.parts[2]

    x, y = circuit.place(u, point)
    if not np.ptp(np.hypot(x.parts[1], y.parts[1])) > SETTLED * length:
        return []
    places = _roots(slope, x.parts[1] * x.parts[2] + y.parts[1] * y.parts[2], u)
    x, y = circuit.place(places, point)
    speed = np.hypot(x.parts[1], y.parts[1])
    specials: list[float] = []
    for place in sorted(places[speed <= STILL * length / FULL].tolist()):
        if not specials or place - specials[-1] > FULL / SAMPLES:
            specials.append(place)
    return specials


def cusps(circuit: Circuit, point: complex, places: "list[float]") -> "tuple[Special, ...]":
    """The cusps at these places."""
    specials = []
    for place in places:
        x, y = circuit.place(place, point)
        specials.append(Special(float(angle_at(circuit, place)), None, float(x.parts[0]), float(y.parts[0])))
    return tuple(specials)


def crossings(circuit: Circuit, point: complex) -> "tuple[Special, ...]":
    """Points that the curve passes twice: crossings of its chords, then Newton."""
    u = np.arange(SEGMENTS) * (FULL / SEGMENTS)
    x, y = circuit.place(u, point)
    z = x.parts[0] + 1j * y.parts[0]
    step = np.roll(z, -1) - z
    apart = z[None, :] - z[:, None]
    cross = (np.conj(step[:, None]) * step[None, :]).imag
    with np.errstate(all="ignore"):
        s = (np.conj(apart) * step[None, :]).imag / cross
        t = (np.conj(apart) * step[:, None]).imag / cross
    i, j = np.nonzero((s >= 0.0) & (s < 1.0) & (t >= 0.0) & (t < 1.0))
    far = (j - i > 1) & (i - j + SEGMENTS > 1)
    specials: list[Special] = []
    for first, second in zip(u[i[far]] + s[i, j][far] * u[1], u[j[far]] + t[i, j][far] * u[1], strict=True):
        pair = _crossing(circuit, point, first, second)
        if pair is None:
            continue
        (ax, ay), angles = circuit.place(pair[0], point), (angle_at(circuit, pair[0]), angle_at(circuit, pair[1]))
        specials.append(Special(float(angles[0]), float(angles[1]), float(ax.parts[0]), float(ay.parts[0])))
    return tuple(specials)


def _crossing(circuit: Circuit, point: complex, first: float, second: float) -> "tuple[float, float] | None":
    for _ in range(STEPS):
        (ax, ay), (bx, by) = circuit.place(first, point), circuit.place(second, point)
        determinant = ax.parts[1] * by.parts[1] - ay.parts[1] * bx.parts[1]
        if determinant == 0.0:
            return None
        ex, ey = bx.parts[0] - ax.parts[0], by.parts[0] - ay.parts[0]
        first += (ex * by.parts[1] - ey * bx.parts[1]) / determinant
        second += (ex * ay.parts[1] - ey * ax.parts[1]) / determinant
    return (first, second) if abs(first - second) > FULL / SEGMENTS else None


def columns(circuit: Circuit, point: complex, count: int) -> "Columns[CurvePoint]":
    """The table."""
    u = np.arange(count) * (FULL / count)
    x, y = circuit.place(u, point)
    speed = np.hypot(x.parts[1], y.parts[1])
    still = speed <= STILL * speed.mean()
    tangent = np.arctan2(np.where(still, y.derivative(2), y.parts[1]), np.where(still, x.derivative(2), x.parts[1]))
    return Columns(CurvePoint, crank_angle=angle_at(circuit, u), x=x.parts[0], y=y.parts[0], tangent_angle=tangent)


def drawn(circuit: Circuit, point: complex, form: str, tolerance: float, sharp: "list[float]") -> "Outline":
    """The curve as an outline with a proved deviation; next to cusps it consists of lines."""
    path = CouplerPath(circuit, point, sharp, tolerance)
    start = np.stack(path.at(path.starts)[:2], axis=1)
    return outlined(path, form, tolerance, start, "coupler curve")
