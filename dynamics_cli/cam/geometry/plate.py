"""Mass properties of a cam's plate: area, perimeter, centroid and polar second moment within its edge."""

from functools import lru_cache
from itertools import pairwise
from math import ceil, hypot, inf, pi

import numpy as np

from dynamics_cli.cam.geometry.contact import Geometry, check_speed
from dynamics_cli.cam.geometry.corners import BLURRED, Corner
from dynamics_cli.cam.geometry.envelope import Bridge, Envelope
from dynamics_cli.cam.program.pieces import pieces, widths, within
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import Advice, ErrorBound, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.cam.geometry.undercut import Loss

GAUSS = 16
"""Nodes of a quadrature on a piece of 15 degrees at most and its halves."""

PIECE = pi / 12.0
# Rounding of a quadrature, relative to a size without cancellation.
QUADRATURE = 8e-15
# A piece is short enough when halving it changes the total by at most this share; limits of halvings and of pieces.
GOOD = 4e-17
DEPTH = 24
# Rounding of a crossing's position, relative to the sizes of cam and roller.
ROUNDED = 2.0**-50
MOST = 4096
# A centroid nearer to the axis than this share of the perimeter is below its rounding.
SETTLED = 1e-15
UNIT = 2.0**-53
# Properties of a plate; the last three need its thickness and density.
NAMES = ("area", "perimeter", "centroid_x", "centroid_y", "mass", "inertia", "inertia_about_centroid")


@record
class Plate:
    """Area, perimeter, centroid and polar second moment within the cam's curve, by quadrature."""

    area: Annotated[float, "Area [m²]."]
    perimeter: Annotated[float, "Length of the curve [m]."]
    x: Annotated[float, "Centroid in the cam's frame [m]."]
    y: Annotated[float, "Centroid in the cam's frame [m]."]
    polar: Annotated[float, "Second moment of the area about the cam's axis [m⁴]."]
    area_error: Annotated[
        float,
        "Twice the change that halving the last pieces of the quadrature made, plus rounding, relative to each size.",
    ]
    perimeter_error: Annotated[
        float,
        "Twice the change that halving the last pieces of the quadrature made, plus rounding, relative to each size.",
    ]
    centroid_error: Annotated[float, "The same of the centroid [m]."]
    polar_error: Annotated[float, "The same for the second moment, relative to it."]


@record
class Weighed:
    """A plate as `cam profile` gives it, with its bounds and advice; None where there is no plate."""

    area: Annotated[float | None, "Area [m²]."] = None
    perimeter: Annotated[float | None, "Length of its edge [m]."] = None
    centroid_x: Annotated[float | None, "Centroid in the cam's frame [m]."] = None
    centroid_y: Annotated[float | None, "Centroid in the cam's frame [m]."] = None
    mass: Annotated[float | None, "Mass [kg]."] = None
    inertia: Annotated[float | None, "Moment of inertia about the cam's axis [kg·m²]."] = None
    inertia_about_centroid: Annotated[float | None, "Moment of inertia about the centroid [kg·m²]."] = None
    bounds: tuple[ErrorBound, ...] = ()
    advice: tuple[Advice, ...] = ()


@lru_cache(maxsize=2)
def _gauss(count: int) -> "tuple[Any, Any]":
    return np.polynomial.legendre.leggauss(count)


def plate(geometry: Geometry, motion: "Any", start_angle: float, corners: "tuple[Corner, ...]" = ()) -> Plate:
    """Integrate over the edge of the cam's plate.

    A = ½∮ r·n ds, z_C = (1/3A)∮ z (r·n) ds, I_p = ¼∮ r² (r·n) ds.

    `motion`: the program; `start_angle`: angle by which the cam's frame is turned on; `corners`: corners of an undercut
    plate, between which the curve is its edge (`undercut.Loss`). Returns the integrals. Raises InadmissibleError when a
    flat rocker turns as fast as the cam.

    Gauss–Legendre of 16 nodes on pieces halved until nothing changes: near the axis, and at the ends of a
    short steep rise, a curve turns fast. Where the velocity jumps, the edge is the arc of the roller or the length of
    the face that joins both contacts. A corner error δ changes every integral by the contribution of a length δ of the
    curve.
    """
    curve = Envelope(geometry, motion)
    stretches = _kept(curve, corners)
    spans = widths(motion)
    zone, low, high = (np.array(column) for column in zip(*_shares(curve, stretches, spans), strict=True))
    frame = geometry, motion, start_angle, np.array(spans)
    values = _integrals(*frame, zone, low, high)
    sums, errors, most = _bridged(curve, stretches, start_angle), np.zeros(5), np.zeros(2)
    for depth in range(DEPTH):
        middle = 0.5 * (low + high)
        rows = (np.concatenate(pair) for pair in ((zone, zone), (low, middle), (middle, high)))
        halves = _integrals(*frame, *rows).reshape(5, 2, -1)
        refined = halves.sum(axis=1)
        moved = np.abs(refined - values)
        most = np.maximum(most, np.abs(sums + refined.sum(axis=1))[:2])
        good = (moved[:2] <= GOOD * most[:, None]).all(axis=0) | (depth == DEPTH - 1) | (zone.size > MOST)
        sums += refined[:, good].sum(axis=1)
        errors += 2.0 * moved[:, good].sum(axis=1)
        bad = ~good
        if not bad.any():
            break
        zone = np.concatenate((zone[bad], zone[bad]))
        low, high = np.concatenate((low[bad], middle[bad])), np.concatenate((middle[bad], high[bad]))
        values = halves[:, :, bad].reshape(5, -1)
    return _plate(geometry, sums, errors + _blurred(curve, corners))


def _plate(geometry: Geometry, sums: "Any", left: "Any") -> Plate:
    """The plate from the integrals and their errors besides rounding."""
    area, perimeter, x, y, polar = sums.tolist()
    third = 1.0 / (3.0 * area) if area else 0.0
    relative = [
        off / abs(integral) + QUADRATURE if integral else 0.0
        for off, integral in zip(left.tolist(), sums.tolist(), strict=True)
    ]
    # the contact of an arm is a difference of lengths from its pivot, which may be far larger than the cam
    reach = 2.0**-51 * getattr(geometry.follower, "pivot_distance", 0.0)
    if area and perimeter:
        across, along = reach * perimeter / abs(area), reach * 2.0 * pi / perimeter
        relative = [error + more for error, more in zip(relative, (across, along, 0.0, 0.0, 2.0 * across), strict=True)]
    away = abs(third) * hypot(x, y)
    # first moments are sums of a mean radius times the area
    centroid = abs(third) * float(left[2] + left[3]) + away * relative[0] + QUADRATURE * perimeter / (2.0 * pi)
    return Plate(area, perimeter, third * x, third * y, polar, relative[0], relative[1], centroid, relative[4])


def _kept(curve: Envelope, corners: "tuple[Corner, ...]") -> "list[tuple[int, float, float]]":
    """The edge of the plate: parts of the curve in order, and the shares of each where it begins and ends."""
    end = float(len(curve.parts))
    stretches = [(0.0, end)] if not corners else []
    for corner, after in zip(corners, (*corners[1:], *corners[:1]), strict=True):
        if after.leaves < corner.returns:
            stretches += [(corner.returns, end), (0.0, after.leaves)]
        else:
            stretches.append((corner.returns, after.leaves))
    return [
        (part, max(low - part, 0.0), min(high - part, 1.0))
        for low, high in stretches
        for part in range(int(low), ceil(high))
    ]


def _shares(
    curve: Envelope, stretches: "list[tuple[int, float, float]]", spans: "list[float]"
) -> "list[tuple[int, float, float]]":
    """Zones of the edge cut into pieces of 15 degrees or less, each with the shares of the zone at its ends."""
    pieces = []
    for part, low, high in stretches:
        zone = curve.parts[part]
        if isinstance(zone, Bridge):
            continue
        parts = max(1, ceil(spans[zone] * (high - low) / PIECE - 1e-9))
        cuts = [low + (high - low) * (index / parts) for index in range(parts)] + [high]
        pieces += [(zone, first, last) for first, last in pairwise(cuts)]
    return pieces


def _bridged(curve: Envelope, stretches: "list[tuple[int, float, float]]", start_angle: float) -> "Any":
    """The integrals over the bridges at velocity jumps."""
    nodes, weights = _gauss(GAUSS)
    turn = curve.geometry.turn
    total = np.zeros(5)
    for part, low, high in stretches:
        bridge = curve.parts[part]
        if not isinstance(bridge, Bridge) or not bridge.run:
            continue
        parts = max(1, ceil(abs(bridge.turning) / PIECE))
        half = 0.5 * (high - low) / parts
        starts = low + 2.0 * half * np.arange(parts)
        point, velocity = curve.at(part, (starts[:, None] + half * (1.0 + nodes)).ravel())
        weight = half * np.tile(weights, parts)
        swept = -turn * (point.conj() * velocity).imag * weight
        turned = point * np.exp(1j * start_angle)
        square = point.real * point.real + point.imag * point.imag
        rows = (0.5 * swept, np.abs(velocity) * weight, turned.real * swept, turned.imag * swept, 0.25 * square * swept)
        total += np.array([row.sum() for row in rows])
    return total


def _blurred(curve: Envelope, corners: "tuple[Corner, ...]") -> "Any":
    """Error of the integrals due to the error of the corners, where both arcs end."""
    total = np.zeros(5)
    for corner in corners:
        ends, directions = [], []
        for place in (corner.leaves, corner.returns):
            part = min(int(place), len(curve.parts) - 1)
            ends.append(complex(curve.at(part, np.array([place - part]))[0][0]))
            directions.append(curve.way(part, place - part))
        away = abs(corner.point)
        off = abs(ends[1] - ends[0]) + BLURRED * away
        if corner.exact:
            # arcs that cross at a small angle leave the position of their crossing uncertain along both
            slope = abs((directions[0].conjugate() * directions[1]).imag)
            gap = abs(ends[1] - ends[0]) + ROUNDED * (away + curve.geometry.roller)
            off = gap / slope if slope else inf
        total += 2.0 * off * np.array([0.5 * away, 1.0, away * away, away * away, 0.25 * away**3])
    return total


def _integrals(
    geometry: Geometry, motion: "Any", start_angle: float, spans: "Any", zone: "Any", low: "Any", high: "Any"
) -> "Any":
    """Area, length, first moments (thrice) and polar second moment of pieces, (5, n)."""
    starts, _ = pieces(motion)
    nodes, weights = _gauss(GAUSS)
    half = 0.5 * (high - low)
    place = 0.5 * (low + high)[:, None] + half[:, None] * nodes
    theta = starts[zone][:, None] + spans[zone][:, None] * place
    weight = (spans[zone] * half)[:, None] * weights
    s, s1, s2 = within(motion, place, zone)
    check_speed(geometry, s1)
    touch = geometry.touch(s, s1, s2)
    (x, y), (nx, ny) = touch.point, touch.normal
    swept = (x * nx + y * ny) * touch.run * weight
    zx, zy = geometry.turned((x, y), theta, start_angle)
    rows = (0.5 * swept, np.abs(touch.run) * weight, zx * swept, zy * swept, 0.25 * ((x * x + y * y) * swept))
    return np.stack([row.sum(axis=1) for row in rows])


def weighed(
    geometry: Geometry, motion: "Any", start_angle: float, loss: "Loss | None", thickness: float | None,
    density: float | None,
) -> Weighed:  # fmt: skip
    """Give the plate of a cam; for an undercut one, the remaining piece about its axis.

    `motion`: the program; `start_angle`: angle by which the cam's frame is turned on; `loss`: the effect of an
    undercut; `thickness`: thickness of the plate [m]; `density`: its density [kg/m³]. Returns the plate; without
    results, but with the reason, if no material remains around the axis.
    """
    weight = None if thickness is None or density is None else thickness * density
    if loss is not None and not loss.corners:
        return Weighed(advice=tuple(_missing(name) for name in (NAMES[:4] if weight is None else NAMES)))
    body = plate(geometry, motion, start_angle, () if loss is None else loss.corners)
    x, y = (value if abs(value) > SETTLED * body.perimeter else 0.0 for value in (body.x, body.y))
    about_centroid = body.polar - body.area * (body.x * body.x + body.y * body.y)
    return Weighed(
        body.area, body.perimeter, x, y,
        None if weight is None else weight * body.area,
        None if weight is None else weight * body.polar,
        None if weight is None else weight * about_centroid,
        bounds=_bounds(body, weight),
        advice=() if loss is None else (_trimmed(loss),),
    )  # fmt: skip


def _missing(name: str) -> Advice:
    message = f"no plate remains around the axis of the cam: it has no {name.replace('_', ' ')}"
    return Advice("no-plate", message, "serious", "raise the base radius", result=name)


def _trimmed(loss: "Loss") -> Advice:
    message = "area, perimeter, centroid and inertia are of the remaining plate; the table covers the whole curve"
    if loss.pieces:
        message += f"; pieces cut off: {loss.pieces}"
    return Advice("trimmed-plate", message, "note")


def _bounds(body: Plate, weight: "float | None") -> tuple[ErrorBound, ...]:
    """Bounds of the quadrature."""
    bounds = [ErrorBound("area", body.area_error), ErrorBound("perimeter", body.perimeter_error)]
    off = body.centroid_error
    bounds += [ErrorBound(name, off, relative=False) for name in ("centroid_x", "centroid_y")]
    if weight is not None:
        away = hypot(body.x, body.y)
        polar = body.polar_error * body.polar + abs(body.area) * away * (away * body.area_error + 3.0 * off)
        bounds.append(ErrorBound("mass", body.area_error + UNIT))
        bounds.append(ErrorBound("inertia", body.polar_error + UNIT))
        bounds.append(ErrorBound("inertia_about_centroid", weight * (polar + 4.0 * UNIT * body.polar), relative=False))
    return tuple(bound for bound in bounds if bound.bound < inf)
