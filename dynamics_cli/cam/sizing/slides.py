"""The smallest cam for a sliding follower: extremes of closed forms."""

from math import hypot, inf, sqrt, tan

import numpy as np

from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.analysis import analyse, concave, convex
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.program.pieces import Cover
from dynamics_cli.cam.sizing.records import CamSize
from dynamics_cli.cam.sizing.roundness import Round, best_offset
from dynamics_cli.errors import worded
from dynamics_cli.quantities import Coordinate
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.cam.program.pieces import Ends

ROOM = 1e-11
UNIT = 2.0**-53
# of the cotangent of a limit: one of the tangent, two in the last place, and the quotient
COTANGENT = 6.0 * UNIT
CURVATURE = "least radius of curvature"
ROLLER = "the roller itself: a base circle cannot be negative"


def extremes_of(motion: "Any", *functions: "Callable[..., Any]") -> "list[Ends]":
    """Certified extremes of functions of s, s′, s″."""
    return Cover(motion, lambda s, s1, s2: np.stack([function(s, s1, s2) for function in functions])).ends()


def size_flat(motion: "Any", follower: "Any", least_radius: float, rotation: str) -> CamSize:
    """Base circle of a flat-faced follower, in closed form from extremes over the turn: R_b = ρ − min(s + s″)."""
    sums, speed = extremes_of(motion, lambda s, s1, s2: s + s2, lambda s, s1, s2: s1)
    low, _ = sums.smallest()
    base = least_radius - low
    # a base circle has no negative radius, and the lowest face stays above the axis
    floor = max(0.0, -motion.stroke[0])
    binding = CURVATURE if base > floor else "a base circle cannot be negative"
    # counts where either might decide
    bound = max(sums.least_error if base + sums.least_error >= floor else 0.0, 4.0 * UNIT * floor)
    bound += UNIT * max(base, floor)
    base = max(base, floor)
    geometry = Geometry(followers.FlatFace(base), rotation)
    analysis = analyse(geometry, motion)
    low_kept = analysis.curvature.smallest()[0]
    return CamSize(
        base_radius=base, offset=None, start_radius=None, arm_start_angle=None, binding=binding,
        largest_pressure_angle=0.0, least_pressure_angle=0.0, least_convex_radius=low_kept,
        least_concave_radius=None, in_line_base_radius=None,
        face_width=speed.largest()[0] - speed.smallest()[0] + 2.0 * follower.face_margin,
        checks=(kept("radius of curvature keeps its limit", least_radius - low_kept, base + least_radius),),
        advice=no_limit(least_radius),
        numerics=Numerics("closed form on extremes over the turn", (stated(bound, base),)),
    )  # fmt: skip


def no_limit(least_radius: float) -> tuple[Advice, ...]:
    """Advice if no limit prevents a sharp cam."""
    if least_radius > 0.0:
        return ()
    return (
        Advice(
            "sharp", "no --least-radius was given: this cam has a sharp point where the curvature decides", "caution",
            "give --least-radius, for example from a limit of contact stress",
        ),
    )  # fmt: skip


def _searched(wedge: "Wedge", round_: Round, e: float, d: float) -> tuple[float, float]:
    """The best offset where curvature binds, and how much height another offset might save."""
    # no offset beyond the start radius that this one needs can do better
    reach = hypot(e, max(d, round_.height(e)))
    e, loose = best_offset(
        lambda e: hypot(e, max(wedge.height(e), round_.rough(e))),
        lambda e: hypot(e, max(wedge.height(e), round_.fine(e))),
        reach,
    )
    # the difference between the height used in the search and the one of the whole turn
    return e, loose + abs(round_.height(e) - round_.fine(e))


def size_slide(
    motion: "Any", follower: "Any", limits: tuple[float, float], least_radius: "float | None", rotation: str, flank: str
) -> CamSize:
    """Base circle and offset of a slide: the apex or a foot of the limits' wedge, raised where curvature binds."""
    turn, side = signs(rotation, flank)
    roller = getattr(follower, "roller_radius", 0.0)
    wedge = Wedge(motion, limits)
    round_ = None if least_radius is None else Round(motion, least_radius + roller, turn, side)
    if follower.offset is None:
        e, d, binding, bound = wedge.best()
    else:
        e = turn * follower.offset
        d, binding = wedge.height(e), wedge.binding(e)
        bound = wedge.slip(e) * abs(d) / hypot(e, d) if d else wedge.slip(e)
    method = "closed form on extremes over the turn"
    if round_ is not None and not round_.kept(e, d):
        binding, method, loose = CURVATURE, "secant on extremes over the turn", 0.0
        if follower.offset is None:
            e, loose = _searched(wedge, round_, e, d)
            method = "golden section over the offset, secant on extremes over the turn"
        pressed, bent = wedge.height(e), round_.height(e)
        d = max(pressed, bent)
        bound = loose + (round_.slip(e, d) if bent >= pressed else wedge.slip(e)) * d / hypot(e, d)
        if abs(pressed - bent) <= 1e-9 * hypot(e, d):
            binding = f"{CURVATURE} and {wedge.binding(e)}"
    radius = hypot(e, d)
    if radius < roller:
        binding, d = ROLLER, sqrt((roller - e) * (roller + e))
        radius = roller
    base = radius - roller
    offset = turn * e + 0.0
    follows = followers.Roller(base, roller, offset)
    analysis = analyse(Geometry(follows, rotation), motion)
    high, low = analysis.pressure.largest()[0], analysis.pressure.smallest()[0]
    least, _ = convex(Geometry(follows, rotation), analysis)
    hollow, _ = concave(Geometry(follows, rotation, flank), analysis) if side < 0.0 else (None, None)
    in_line, curved = max(wedge.a, wedge.b, wedge.floor) - roller, binding.startswith(CURVATURE)
    # a base radius and an offset in doubles determine a much smaller height no better
    lever = 1.0 + 1e-4 * (radius / d) ** 2 if d > 0.0 else inf
    checks = [
        kept("largest pressure angle keeps its limit", high - limits[0], lever),
        kept("least pressure angle keeps its limit", -low - limits[1], lever),
    ]
    counts = least if side > 0.0 else hollow
    if least_radius is not None and counts is not None:
        checks.append(kept("radius of curvature keeps its limit", least_radius - counts, radius))
    return CamSize(
        base_radius=base, offset=offset, start_radius=radius, arm_start_angle=None, binding=binding,
        largest_pressure_angle=high, least_pressure_angle=low, least_convex_radius=least if side > 0.0 else None,
        least_concave_radius=hollow,
        in_line_base_radius=in_line if in_line > 0.0 and not curved else None, face_width=None,
        checks=tuple(checks), advice=undercut(counts, radius),
        numerics=Numerics(method, (stated(bound + UNIT * (2.0 * radius + base), base),)),
    )  # fmt: skip


class Wedge:
    """Heights that the pressure angles of a slide allow at an offset e: d ≥ A − e cot φ₁, d ≥ B + e cot φ₂.

    `motion`: the program; `limits`: the limits of rise and return [rad].
    """

    def __init__(self, motion: "Any", limits: tuple[float, float]) -> None:
        c1, c2 = self.cotangents = (1.0 / tan(limits[0]), 1.0 / tan(limits[1]))
        # the clockwise cam is the anticlockwise one run backwards: its rise is a return there, its offset reversed
        rise, back = extremes_of(motion, lambda s, s1, s2: s1 * c1 - s, lambda s, s1, s2: -s1 * c2 - s)
        self.a, self.b, self.floor = rise.greatest, back.greatest, -motion.stroke[0]
        # a cotangent is within three roundings of that of its limit
        most = max(map(abs, motion.stroke))
        self.errors = tuple(end.greatest_error + COTANGENT * (abs(end.greatest) + most) for end in (rise, back))

    def height(self, e: float) -> float:
        """The least height."""
        return float(max(self.a - e * self.cotangents[0], self.b + e * self.cotangents[1], self.floor))

    def slip(self, e: float) -> float:
        """Error bound of the minimum height: the largest of the limits that might decide."""
        heights = (self.a - e * self.cotangents[0], self.b + e * self.cotangents[1], self.floor)
        errors = [
            error + 2.0 * COTANGENT * abs(e) * cotangent + UNIT * abs(limit)
            for error, limit, cotangent in zip(self.errors, (self.a, self.b), self.cotangents, strict=True)
        ] + [4.0 * UNIT * abs(self.floor)]
        best = max(height - error for height, error in zip(heights, errors, strict=True))
        return max(float(error) for height, error in zip(heights, errors, strict=True) if height + error >= best)

    def best(self) -> "tuple[float, float, str, float]":
        """Offset and height nearest to the axis, the binding limits, and the error bound of the start radius."""
        e, d, binding = best_slide(self.a, self.b, *self.cotangents)
        (first, second), (c1, c2) = self.errors, self.cotangents
        cots = c1 + c2
        if "and" not in binding:
            # the foot on one line: a/√(1 + c²)
            error, c = (first, c1) if binding.startswith("rise") else (second, c2)
            bound = error / hypot(1.0, c) + 8.0 * UNIT * hypot(e, d)
        else:
            across = (first + second) / cots + 2.0 * COTANGENT * abs(e) + UNIT * (abs(self.a) + abs(self.b)) / cots
            up = (first * c2 + second * c1) / cots + 8.0 * UNIT * (abs(self.a) * c2 + abs(self.b) * c1) / cots
            radius = hypot(e, d)
            bound = (abs(e) * across + abs(d) * up) / radius if radius else across + up
            # an offset equal to zero within its error is zero
            e = e if abs(e) > across else 0.0
        if d < self.floor:
            # the lift may fall below the limits' apex
            d, bound = self.floor, bound + 4.0 * UNIT * self.floor
        return e, d, binding, bound

    def binding(self, e: float) -> str:
        """Which limit decides."""
        first, second = self.a - e * self.cotangents[0], self.b + e * self.cotangents[1]
        if self.floor > max(first, second):
            return "the lift, which falls to the axis"
        return "rise limit" if first >= second else "return limit"


def signs(rotation: str, flank: str) -> tuple[float, float]:
    """-1 for a clockwise cam, and -1 for an outer flank."""
    return -1.0 if followers.Rotation(rotation) == "clockwise" else 1.0, -1.0 if flank == "outer" else 1.0


def undercut(least: "float | None", scale: float) -> tuple[Advice, ...]:
    """Advice on a size that leaves the cam undercut, or with a radius of curvature of zero within rounding."""
    if least is None or least > ROOM * scale:
        return ()
    if least >= -ROOM * scale:
        return (Advice("sharp", "at this size the cam has a sharp point", "caution", "give --least-radius above zero"),)
    message = worded(
        "at this size the cam is undercut: its minimum radius of curvature is {least:6}", least=(least, Coordinate)
    )
    return (Advice("undercut", message, "serious", "give --least-radius above zero"),)


def kept(name: str, excess: float, scale: float) -> Check:
    """A check that a limit is kept within rounding."""
    return Check(name, excess <= ROOM * scale, max(excess, 0.0), ROOM * scale)


def stated(error: float, base: float) -> ErrorBound:
    """Error bound of a base radius: relative, or absolute where the base radius is zero."""
    if base > 0.0 and error <= base:
        return ErrorBound("base_radius", error / base)
    return ErrorBound("base_radius", error, relative=False)


def best_slide(a: float, b: float, cot_rise: float, cot_return: float) -> tuple[float, float, str]:
    """The nearest (e, d) to the origin with d + e c₁ ≥ A and d − e c₂ ≥ B.

    `a`, `b`: a and B [m]; `cot_rise`, `cot_return`: cotangents of the limits. Returns offset, height and the limits
    that bind.

    The apex is the answer unless the foot of the perpendicular on one line keeps the other.

    Examples
    --------
    >>> best_slide(2.0, 2.0, 1.0, 1.0)
    (0.0, 2.0, 'rise and return limit')
    """
    e = (a - b) / (cot_rise + cot_return)
    d = (a * cot_return + b * cot_rise) / (cot_rise + cot_return)
    if e > d * cot_rise:
        foot = a / (1.0 + cot_rise * cot_rise)
        return foot * cot_rise, foot, "rise limit"
    if e < -d * cot_return:
        foot = b / (1.0 + cot_return * cot_return)
        return -foot * cot_return, foot, "return limit"
    return e, d, "rise and return limit"
