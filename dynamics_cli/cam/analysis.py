"""Certified extremes of curvature, pressure angle and contact of a whole cam, and what its plate weighs."""

from functools import lru_cache
from math import inf, pi

import numpy as np

from dynamics_cli.cam.contact import Geometry, check_speed
from dynamics_cli.cam.followers import FlatFace
from dynamics_cli.cam.pieces import Cover, Ends, pieces, within
from dynamics_cli.errors import require
from dynamics_cli.records import ErrorBound, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

GAUSS = 12
"""Nodes of a quadrature on a piece of 15 degrees at most, its halves and its quarters."""

PIECE = pi / 12.0
# Roundings of a quadrature, as a share of a size that does not cancel.
QUADRATURE = 8e-15
# Halving helps for good once it does by this.
FAST = 0.01


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
        return np.stack(np.broadcast_arrays(*geometry.bends(s.widened(slip), s1, s2)))

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
        What the quadrature may leave out by what halving its pieces moved, and rounding, as shares of the sizes.
    """

    area: float
    perimeter: float
    x: float
    y: float
    polar: float
    area_error: float
    perimeter_error: float


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
    Gauss-Legendre of 12 nodes on pieces of 3.75 degrees or less, held against pieces twice and four times as long: near
    the axis a curve turns fast. A curve that cuts itself counts loops twice.
    """
    levels = [_integrals(geometry, motion, start_angle, level) for level in range(3)]
    area, perimeter, x, y, polar = (float(part.sum()) for part in levels[-1])
    third = 1.0 / (3.0 * area) if area else 0.0
    errors = [
        _left(*(level[which] for level in levels)) / abs(whole) + QUADRATURE if whole else 0.0
        for which, whole in enumerate((area, perimeter))
    ]
    return Plate(area, perimeter, third * x, third * y, polar, *errors)


def _left(coarse: "Any", middle: "Any", fine: "Any") -> float:
    """What a quadrature may leave out, by what halving each piece moved, and halving its halves.

    Where the second time moved it by less than a hundredth of the first the next ones move it by less still.
    """
    first, second = np.abs(middle - coarse), np.abs(fine - middle)
    with np.errstate(all="ignore"):
        ratio = np.where(first > 0.0, second / np.where(first > 0.0, first, 1.0), 1.0)
    return float((second * np.where(ratio < FAST, 4.0 * ratio, 2.0)).sum())


def _integrals(geometry: Geometry, motion: "Any", start_angle: float, level: int) -> "tuple[Any, ...]":
    """Area, length, first moments (thrice) and polar second moment of pieces of 15 degrees, each in 2^level parts."""
    starts, ends = pieces(motion)
    parts = np.maximum(np.ceil((ends - starts) / PIECE - 1e-9), 1.0).astype(int) << level
    owner = np.repeat(np.arange(parts.size), parts)
    share = 1.0 / parts[owner]
    index = np.arange(owner.size) - (np.cumsum(parts) - parts)[owner]
    nodes, weights = _gauss(GAUSS)
    place = (index[:, None] + 0.5 * (1.0 + nodes)) * share[:, None]
    width = (ends - starts)[owner]
    theta = starts[owner][:, None] + width[:, None] * place
    weight = 0.5 * (width * share)[:, None] * weights
    s, s1, s2 = within(motion, place, owner)
    check_speed(geometry, s1)
    touch = geometry.touch(s, s1, s2)
    (x, y), (nx, ny) = touch.point, touch.normal
    swept = (x * nx + y * ny) * touch.run * weight
    zx, zy = geometry.turned((x, y), theta, start_angle)
    rows = (0.5 * swept, np.abs(touch.run) * weight, zx * swept, zy * swept, 0.25 * ((x * x + y * y) * swept))
    return tuple(row.reshape(-1, GAUSS << level).sum(axis=1) for row in rows)
