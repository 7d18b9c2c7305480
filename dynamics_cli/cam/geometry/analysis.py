"""Extremes of curvature, pressure angle and contact of a whole cam."""

from math import inf

import numpy as np

from dynamics_cli.cam.geometry.contact import Geometry, check_speed
from dynamics_cli.cam.geometry.followers import FlatFace
from dynamics_cli.cam.program.pieces import Cover, Ends
from dynamics_cli.errors import require
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import ErrorBound, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


UNIT = 2.0**-53
# an angle that passes half a turn jumps by a whole one, and no interpolant follows it
ACROSS = 1e-3


@record
class Analysis:
    """Extremes of one cam."""

    curvature: Annotated[Ends, "Curvature of the pitch curve, or under a flat face the radius of curvature of the cam."]
    pressure: Annotated[Ends, "Pressure angle."]
    along: Annotated[
        Ends | None,
        "Where a flat face is touched: to the right of the slide, or away from the pivot; None for other followers.",
    ]

    @property
    def face_width(self) -> float | None:
        """How much of a flat face is touched."""
        return None if self.along is None else self.along.greatest - self.along.least


def analyse(geometry: Geometry, motion: "Any") -> Analysis:
    """Find every extreme of curvature, pressure angle and contact.

    `motion`: the program. Returns the extremes. Raises InadmissibleError when the roller's centre passes through the
    cam's axis, the pressure angle passes 180 degrees, or a flat rocker turns as fast as the cam.

    Chebyshev interpolants on each piece of each law give the places; the values are those of the formulas there, with
    bounded rounding (`numerics.chebyshev`).
    """
    start_error = start_slip(geometry)

    def functions(s: "Any", s1: "Any", s2: "Any") -> "Any":
        check_speed(geometry, s1.centre)
        return np.stack(geometry.bends(s.widened(start_error), s1, s2))

    try:
        with np.errstate(all="ignore"):
            cover = Cover(motion, functions)
    except ValueError:
        refuse_size()
        raise
    ends = cover.ends()
    require(
        ends[1].error < ACROSS,
        "the pressure angle passes 180 deg: the cam would have to pull the follower through",
        code="pulled",
        hint="take another base circle, or let an arm start farther from the line of pivot and axis",
    )
    return Analysis(ends[0], ends[1], ends[2] if geometry.flat else None)


def refuse_size() -> None:
    """Refuse a cam whose proxies are not finite."""
    require(
        False,
        "a cam of this size is impossible: the point of contact passes through the cam's axis, or numbers overflow",
        code="through-axis",
        hint="take a base radius above zero, of the size of the lift",
    )


def runs_forward(geometry: Geometry, analysis: Analysis) -> bool:
    """Whether the cam's curve surely never stops or runs backwards within the zones of the motion.

    1 − R κ > 0 all round (on an outer flank 1 + R κ), or ρ > 0 under a flat face, by more than its error.
    """
    bend = analysis.curvature
    if geometry.flat:
        return bend.smallest()[0] > bend.error
    tightest = bend.largest()[0] if geometry.side > 0.0 else -bend.smallest()[0]
    return geometry.roller * (tightest + bend.error) < 1.0 - 2.0**-50


def start_slip(geometry: Geometry) -> float:
    """Rounding error of the follower's height or angle at zero lift.

    Heights are roots of products of two sums that are rounded once: 3 u. Angles are twice arc tangents, within a unit
    in the last place, of quotients of such roots, 6 u at most. For a second follower it follows from the given distance
    or angle.
    """
    f = geometry.follower
    if isinstance(f, FlatFace):
        return 0.0
    offsets = getattr(f, "arm_angle", 0.0) + getattr(f, "roller_distance", 0.0)
    rounded = (8.0 if geometry.oscillating else 3.0) * abs(geometry.start + offsets)
    return UNIT * (rounded + (abs(geometry.start) if offsets else 0.0)) * (1.0 + 2.0**-40)


def pressure_bounds(analysis: Analysis) -> tuple[ErrorBound, ...]:
    """Proved bounds of the two extremes of the pressure angle, relative to each."""
    pressure = analysis.pressure
    return tuple(
        ErrorBound(name, error / abs(value))
        for name, value, error in (
            ("largest_pressure_angle", pressure.greatest, pressure.greatest_error),
            ("least_pressure_angle", pressure.least, pressure.least_error),
        )
        if value and error < inf
    )


def convex(geometry: Geometry, analysis: Analysis) -> tuple[float | None, float | None]:
    """Minimum radius of curvature of the cam where the pitch curve is convex, and where."""
    if geometry.flat:
        return analysis.curvature.smallest()
    value, place = analysis.curvature.largest()
    return (1.0 / value - geometry.side * geometry.roller, place) if value > 0.0 else (None, None)


def concave(geometry: Geometry, analysis: Analysis) -> tuple[float | None, float | None]:
    """Minimum radius of curvature of the cam where the pitch curve is concave, and where."""
    if geometry.flat:
        return None, None
    value, place = analysis.curvature.smallest()
    return (geometry.side * geometry.roller - 1.0 / value, place) if value < -1e-12 else (None, None)


def radius_bounds(geometry: Geometry, analysis: Analysis) -> tuple[ErrorBound, ...]:
    """Proved bounds of the minimum radii of curvature: the error of 1/κ from that of κ, and two roundings."""
    bend = analysis.curvature
    bounds = []
    for name, radius, value, error in (
        ("least_convex_radius", convex(geometry, analysis)[0], bend.greatest, bend.greatest_error),
        ("least_concave_radius", concave(geometry, analysis)[0], bend.least, bend.least_error),
    ):
        if radius is None:
            continue
        off = bend.least_error
        if not geometry.flat:
            margin = abs(value) - error
            off = error / (abs(value) * margin) + 2.0 * UNIT / abs(value) if margin > 0.0 else inf
        if off < inf:
            bounds.append(ErrorBound(name, (off + UNIT * abs(radius)) * (1.0 + 2.0**-40), relative=False))
    return tuple(bounds)


def extreme_results(geometry: Geometry, analysis: Analysis) -> "dict[str, Any]":
    """The extremes and their cam angles by the names of results."""
    names = "largest_pressure_angle", "least_pressure_angle", "least_convex_radius", "least_concave_radius"
    pressure = analysis.pressure
    ends = pressure.largest(), pressure.smallest(), convex(geometry, analysis), concave(geometry, analysis)
    values = {name: value for name, (value, _) in zip(names, ends, strict=True)}
    return values | {f"{name}_at": place for name, (_, place) in zip(names, ends, strict=True)}


def extreme_bounds(geometry: Geometry, analysis: Analysis) -> tuple[ErrorBound, ...]:
    """Proved bounds of the extremes."""
    return *pressure_bounds(analysis), *radius_bounds(geometry, analysis)
