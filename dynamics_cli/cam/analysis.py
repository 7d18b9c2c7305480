"""Certified extremes of curvature, pressure angle and contact of a whole cam, and what its plate weighs."""

from functools import lru_cache
from math import ceil, hypot, inf, pi

import numpy as np

from dynamics_cli.cam.contact import Geometry, check_speed
from dynamics_cli.cam.followers import FlatFace
from dynamics_cli.cam.pieces import Cover, Ends, pieces, widths, within
from dynamics_cli.errors import require
from dynamics_cli.records import ErrorBound, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

GAUSS = 16
"""Nodes of a quadrature on a piece of 15 degrees at most and its halves."""

PIECE = pi / 12.0
# Roundings of a quadrature, as a share of a size that does not cancel.
QUADRATURE = 8e-15
# A piece is short enough when halving it moves the whole by this share at most; so often at most, and so many.
GOOD = 4e-17
DEPTH = 24
MOST = 4096


@record
class Analysis:
    """Extremes of one cam.

    Parameters
    ----------
    curvature : Ends
        Curvature of the pitch curve, or under a flat face the radius of curvature of the cam.
    pressure : Ends
        Pressure angle.
    along : Ends
        Where a flat face is touched: to the right of the slide, or away from the pivot; None for other followers.
    """

    curvature: Ends
    pressure: Ends
    along: Ends | None


def analyse(geometry: Geometry, motion: "Any") -> Analysis:
    """Find every extreme of curvature, pressure angle and contact.

    Parameters
    ----------
    geometry : Geometry
        The follower in place.
    motion : Motion
        The program.

    Returns
    -------
    Analysis
        The extremes.

    Raises
    ------
    InadmissibleError
        When a centre of the roller passes through the cam's axis, the pressure angle passes 180 degrees, or a flat
        rocker turns as fast as the cam.

    Notes
    -----
    Chebyshev proxies on each piece of each law, their remainders proved on discs of the complex plane, tell where; the
    values are those of the formulas there, with their own roundings followed. See `numerics.remainders`,
    `numerics.summits` and `cam.enclosures`. No value on the turn is beyond the extremes by more than their errors.
    """
    slip = start_slip(geometry)

    def functions(s: "Any", s1: "Any", s2: "Any") -> "Any":
        check_speed(geometry, s1.centre)
        return np.stack(geometry.bends(s.widened(slip), s1, s2))

    try:
        with np.errstate(all="ignore"):
            made = Cover(motion, functions)
    except ValueError:
        refuse_size()
        raise
    found = made.ends()
    require(
        found[1].error < inf,
        "the pressure angle passes 180 deg: the cam would have to pull the follower through",
        code="pulled",
        hint="take another base circle, or let an arm start farther from the line of pivot and axis",
    )
    return Analysis(found[0], found[1], found[2] if geometry.flat else None)


def refuse_size() -> None:
    """Refuse a cam whose proxies are not finite."""
    require(
        False,
        "there is no cam of this size: the point of contact runs through the cam's axis, or numbers overflow",
        code="through-axis",
        hint="take a base radius above zero, of the size of the lift",
    )


def runs_forward(geometry: Geometry, found: Analysis) -> bool:
    """Whether the cam's curve is proved to stand nowhere and to run backwards nowhere within the zones of the motion.

    1 − R κ > 0 all round (on an outer flank 1 + R κ), or ρ > 0 under a flat face, by more than the proved error.
    """
    bend = found.curvature
    if geometry.flat:
        return bend.smallest()[0] > bend.error
    tightest = bend.largest()[0] if geometry.side > 0.0 else -bend.smallest()[0]
    return geometry.roller * (tightest + bend.error) < 1.0 - 2.0**-50


def start_slip(geometry: Geometry) -> float:
    """What the height or angle of the follower at zero lift is off by rounding.

    Heights are roots of products of two sums that are rounded once: 3 u. Angles are twice arc tangents, within a unit
    in the last place, of quotients of such roots, 6 u at most. A second follower's is what a distance or angle leaves.
    """
    f = geometry.follower
    if isinstance(f, FlatFace):
        return 0.0
    left = getattr(f, "arm_angle", 0.0) + getattr(f, "roller_distance", 0.0)
    rounded = (8.0 if geometry.oscillating else 3.0) * abs(geometry.start + left)
    return 2.0**-53 * (rounded + (abs(geometry.start) if left else 0.0)) * (1.0 + 2.0**-40)


def pressure_bounds(found: Analysis) -> tuple[ErrorBound, ...]:
    """Proved bounds of the two extremes of the pressure angle, relative to each."""
    own = found.pressure
    return tuple(
        ErrorBound(name, error / abs(value))
        for name, value, error in (
            ("largest_pressure_angle", own.greatest, own.greatest_error),
            ("least_pressure_angle", own.least, own.least_error),
        )
        if value and error < inf
    )


@record
class Plate:
    """Area, perimeter, centroid and polar second moment of what the cam's curve encloses, by quadrature.

    Parameters
    ----------
    area : float
        Area [m²].
    perimeter : float
        Length of the curve [m].
    x, y : float
        Centroid in the cam's frame [m].
    polar : float
        Second moment of the area about the cam's axis [m⁴].
    area_error, perimeter_error : float
        Twice what halving the last pieces of the quadrature moved, and rounding, as shares of the sizes.
    centroid_error : float
        The same of the centroid [m].
    polar_error : float
        The same of the second moment, as a share of it.
    """

    area: float
    perimeter: float
    x: float
    y: float
    polar: float
    area_error: float
    perimeter_error: float
    centroid_error: float
    polar_error: float


@lru_cache(maxsize=2)
def _gauss(count: int) -> "tuple[Any, Any]":
    return np.polynomial.legendre.leggauss(count)


def plate(geometry: Geometry, motion: "Any", start_angle: float) -> Plate:
    """Integrate over the cam's curve.

    A = ½∮ r·n ds, z_C = (1/3A)∮ z (r·n) ds, I_p = ¼∮ r² (r·n) ds.

    Parameters
    ----------
    geometry : Geometry
        The follower in place.
    motion : Motion
        The program.
    start_angle : Angle
        Angle by which the cam's frame is turned on.

    Returns
    -------
    Plate
        The integrals.

    Raises
    ------
    InadmissibleError
        When a flat rocker turns as fast as the cam.

    Notes
    -----
    Gauss-Legendre of 16 nodes on pieces that are halved until that moves nothing: near the axis, and at the ends of a
    short steep rise, a curve turns fast. A curve that cuts itself counts loops twice.
    """
    spans = widths(motion)
    zone, low, high = (np.array(column) for column in zip(*_shares(spans), strict=True))
    frame = geometry, motion, start_angle, np.array(spans)
    values = _integrals(*frame, zone, low, high)
    sums, left, most = np.zeros(5), np.zeros(5), np.zeros(2)
    for depth in range(DEPTH):
        middle = 0.5 * (low + high)
        rows = (np.concatenate(pair) for pair in ((zone, zone), (low, middle), (middle, high)))
        halves = _integrals(*frame, *rows).reshape(5, 2, -1)
        both = halves.sum(axis=1)
        moved = np.abs(both - values)
        most = np.maximum(most, np.abs(sums + both.sum(axis=1))[:2])
        good = (moved[:2] <= GOOD * most[:, None]).all(axis=0) | (depth == DEPTH - 1) | (zone.size > MOST)
        sums += both[:, good].sum(axis=1)
        left += 2.0 * moved[:, good].sum(axis=1)
        bad = ~good
        if not bad.any():
            break
        zone = np.concatenate((zone[bad], zone[bad]))
        low, high = np.concatenate((low[bad], middle[bad])), np.concatenate((middle[bad], high[bad]))
        values = halves[:, :, bad].reshape(5, -1)
    area, perimeter, x, y, polar = sums.tolist()
    third = 1.0 / (3.0 * area) if area else 0.0
    shares = [
        off / abs(whole) + QUADRATURE if whole else 0.0 for off, whole in zip(left.tolist(), sums.tolist(), strict=True)
    ]
    # an arm's contact is a difference of lengths that reach to its pivot, however small the cam
    reach = 2.0**-51 * getattr(geometry.follower, "pivot_distance", 0.0)
    if area and perimeter:
        across, along = reach * perimeter / abs(area), reach * 2.0 * pi / perimeter
        shares = [share + more for share, more in zip(shares, (across, along, 0.0, 0.0, 2.0 * across), strict=True)]
    away = abs(third) * hypot(x, y)
    # first moments are sums of a mean radius times the area
    centroid = abs(third) * float(left[2] + left[3]) + away * shares[0] + QUADRATURE * perimeter / (2.0 * pi)
    return Plate(area, perimeter, third * x, third * y, polar, shares[0], shares[1], centroid, shares[4])


def _shares(spans: "list[float]") -> "list[tuple[int, float, float]]":
    """Zones cut into pieces of 15 degrees or less: zone, and the shares of it that each reaches from and to."""
    made = []
    for zone, span in enumerate(spans):
        parts = max(1, ceil(span / PIECE - 1e-9))
        made += [(zone, index / parts, (index + 1) / parts) for index in range(parts)]
    return made


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
