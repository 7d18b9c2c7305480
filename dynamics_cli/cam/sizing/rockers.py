"""The smallest cam for a flat-faced rocker: extremes of closed forms."""

from math import asin, cos, pi, sin, tan

import numpy as np

from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.analysis import analyse, convex
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.sizing.records import CamSize
from dynamics_cli.cam.sizing.slides import CURVATURE, UNIT, extremes_of, kept, no_limit, signs, stated
from dynamics_cli.errors import require
from dynamics_cli.numerics.discs import Disc
from dynamics_cli.quantities import Angle, Ratio, Size
from dynamics_cli.records import Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def size_rocker(
    motion: "Any", follower: "Any", limits: tuple[float, float], least_radius: float, rotation: str
) -> CamSize:
    """Base circle of a flat rocker: c(A sin ψ + B cos ψ) ≥ (ρ + f)(1 + ψ′)³, A = (1 + 2ψ′)(1 + ψ′), B = ψ″.

    With M = √(A² + B²), β = atan2(B, A), this is M sin(ψ + β) ≥ C: ψ₀ ≥ asin(C/M) − β − s, in closed form.
    """
    pivot, back = follower.pivot_distance, follower.face_offset
    require(pivot > abs(back), "the face's offset reaches beyond the pivot's distance", code="pivot-inside",
            hint="move the pivot outwards")  # fmt: skip
    start, binding, error, slowest = _start(motion, pivot, back, limits, least_radius, signs(rotation, "inner")[0])
    base = max(pivot * sin(start) - back, 0.0)
    bound = pivot * (cos(start) + error) * error + 6.0 * UNIT * pivot * sin(start) + UNIT * base
    geometry = Geometry(followers.OscillatingFlat(base, pivot, back), rotation)
    analysis = analyse(geometry, motion)
    least, high, low = convex(geometry, analysis)[0], analysis.pressure.largest()[0], analysis.pressure.smallest()[0]
    assert analysis.along is not None
    width = analysis.along.largest()[0] - analysis.along.smallest()[0] + 2.0 * follower.face_margin
    assert least is not None
    return CamSize(
        base_radius=base, offset=None, start_radius=None, arm_start_angle=geometry.start, binding=binding,
        largest_pressure_angle=high, least_pressure_angle=low, least_convex_radius=least, least_concave_radius=None,
        in_line_base_radius=None, face_width=width,
        checks=(
            kept("radius of curvature keeps its limit", least_radius - least, pivot / slowest**3),
            kept("largest pressure angle keeps its limit", high - limits[0], 1.0),
            kept("least pressure angle keeps its limit", -low - limits[1], 1.0),
        ),
        advice=no_limit(least_radius),
        numerics=Numerics(
            "closed form on extremes over the turn",
            (stated(bound, base),),
        ),
    )  # fmt: skip


def _start(
    motion: "Any", pivot: float, back: float, limits: tuple[float, float], least_radius: float, turn: float
) -> "tuple[float, str, float, float]":
    """The minimum angle of the face at zero lift, the deciding limit, its error, and the minimum of 1 + dψ/dθ."""
    slowest = 1.0 + extremes_of(motion, lambda s, s1, s2: turn * s1)[0].smallest()[0]
    require(
        slowest > 0.0,
        "the rocker turns as fast as the cam (1 + dψ/dθ falls to {slowest}): a flat face cannot follow this motion",
        slowest=(slowest, Ratio), code="face-too-fast", hint="give the return a larger angle of the cam",
    )  # fmt: skip

    def parts(s1: "Any", s2: "Any") -> "tuple[Any, Any]":
        speed = 1.0 + turn * s1
        a = (1.0 + 2.0 * turn * s1) * speed
        factor = (least_radius + back) / pivot
        needs = speed * speed * speed * Disc(factor, 2.0 * UNIT * abs(factor)) / np.hypot(a, s2)
        # β from −90 to 270 degrees, without a branch
        return needs, 0.5 * pi + np.arctan2(-a, s2)

    (needed,) = extremes_of(motion, lambda s, s1, s2: parts(s1, s2)[0])
    require(
        needed.largest()[0] < 1.0,
        "no base circle gives this cam a minimum radius of curvature of {radius}: the pivot is {pivot} from the cam's "
        "axis; at least {needed:6} would be needed",
        radius=(least_radius, Size), pivot=(pivot, Size), needed=(pivot * needed.largest()[0], Size),
        code="curvature-binds", hint="move the pivot outwards, or give the motion larger angles",
    )  # fmt: skip
    # the limit that the face's offset acts on: the normal always leans to the same side
    limit = limits[1] if turn * back > 0.0 else limits[0]
    lean = abs(back) / tan(limit) / pivot
    lowest, highest, steep, lift = extremes_of(
        motion,
        lambda s, s1, s2: _arcsine(parts(s1, s2)[0]) - parts(s1, s2)[1] - s,
        lambda s, s1, s2: pi - _arcsine(parts(s1, s2)[0]) - parts(s1, s2)[1] - s,
        lambda s, s1, s2: np.arccos(np.clip(lean * (1.0 + turn * s1), -1.0, 1.0)) - s,
        lambda s, s1, s2: s,
    )
    floor = max(asin(back / pivot) - min(lift.smallest()[0], 0.0), 0.0)
    start, binding = max((lowest.largest()[0], CURVATURE), (floor, "a base circle cannot be negative"))
    most, cap = min(
        (highest.smallest()[0], CURVATURE),
        (steep.smallest()[0], "rise limit" if limit == limits[0] else "return limit"),
        (0.5 * pi - lift.largest()[0], "the face, which would be touched at the pivot"),
    )
    require(
        start <= most,
        "no base circle keeps the limits: the {binding} needs the face at {start:6} or more, the {cap} at {most:6} or "
        "less",
        binding=binding, start=(start, Angle), cap=cap, most=(most, Angle),
        code="limits-clash", hint="move the pivot outwards, bring the face nearer to it, or widen the limits",
    )  # fmt: skip
    error = lowest.greatest_error if start > floor else lift.least_error + 6.0 * UNIT * floor
    return start, binding, error, slowest


def _arcsine(part: "Any") -> "Any":
    return np.arcsin(np.clip(part, -1.0, 1.0))
