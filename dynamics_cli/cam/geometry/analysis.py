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
    return 2.0**-53 * (rounded + (abs(geometry.start) if offsets else 0.0)) * (1.0 + 2.0**-40)


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
