"""The smallest conjugate pair: both cams keep the limits, each on the stroke that it drives."""

from math import hypot, pi, sqrt

from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.analysis import analyse, convex
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.sizing.arms import distance, moved, reach, require_reach, require_round, round_start
from dynamics_cli.cam.sizing.records import CamSize, SecondCam
from dynamics_cli.cam.sizing.roundness import Falling, Round
from dynamics_cli.cam.sizing.slides import CURVATURE, ROLLER, UNIT, Wedge, kept, signs, stated, undercut
from dynamics_cli.errors import require
from dynamics_cli.quantities import Angle, Size
from dynamics_cli.records import Check, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def size_pair(
    motion: "Any", follower: "Any", limits: tuple[float, float], least_radius: "float | None", rotation: str
) -> CamSize:
    """Two rollers on one slide: the second cam is the first one for the inverted motion, mirrored."""
    turn, _ = signs(rotation, "inner")
    roller, offset = follower.roller_radius, follower.offset
    e = turn * offset
    heights, bindings, errors = [], [], []
    for moves, sense in ((motion, 1.0), (Falling(motion), -1.0)):
        d, binding, error = _height(moves, sense * e, limits, roller, least_radius, sense * turn)
        heights.append(d)
        bindings.append(binding)
        errors.append(error)
    least = heights[0] + heights[1]
    apart = least if follower.roller_distance is None else follower.roller_distance
    require(
        apart >= least * (1.0 - 1e-14),
        "rollers {apart} apart are too near to each other: the first cam needs its roller {first} above its axis "
        "({above}), the second {second} below ({below})",
        apart=(apart, Size), first=(heights[0], Size), above=bindings[0], second=(heights[1], Size), below=bindings[1],
        code="limits-clash", hint="take a roller distance of {least:6} or more, or leave it out", least=(least, Size),
    )  # fmt: skip
    base = hypot(e, heights[0]) - roller
    first = Geometry(followers.Roller(base, roller, offset), rotation)
    second = Geometry(followers.ConjugateRoller(base, roller, apart, offset), rotation)
    return _both(
        motion, first, second, limits, least_radius,
        binding=bindings[0] if follower.roller_distance is not None else f"{bindings[0]}; second cam: {bindings[1]}",
        base_radius=base, offset=offset, start_radius=hypot(e, heights[0]), roller_distance=apart,
        second_start=hypot(e, apart - heights[0]), error=errors[0] * heights[0] / (base + roller),
    )  # fmt: skip


def _height(
    motion: "Any", e: float, limits: tuple[float, float], roller: float, least_radius: "float | None", turn: float
) -> tuple[float, str, float]:
    """The minimum height of one of the rollers, the deciding limit, and its error."""
    wedge = Wedge(motion, limits)
    d, binding, error = wedge.height(e), wedge.binding(e), wedge.slip(e)
    if least_radius is not None:
        round_ = Round(motion, least_radius + roller, turn, 1.0)
        if not round_.kept(e, d):
            d, binding = max(d, round_.height(e)), CURVATURE
            error = max(error, round_.slip(e, d))
    if hypot(e, d) < roller:
        d, binding = sqrt((roller - e) * (roller + e)), ROLLER
    return d, binding, error


def size_arms(
    motion: "Any", follower: "Any", limits: tuple[float, float], least_radius: "float | None", rotation: str
) -> CamSize:
    """Two rollers on one rocker, each cam at the least angle of its arm that the other leaves."""
    turn, _ = signs(rotation, "inner")
    arm, pivot, roller = follower.arm, follower.pivot_distance, follower.roller_radius
    starts, mosts, bindings, errors = [], [], [], []
    for moves, sense in ((motion, 1.0), (Falling(motion), -1.0)):
        reached = reach(moves, arm, pivot, limits, sense * turn)
        start, binding, error = reached.least, reached.binding, reached.error
        require_reach(reached, start)
        if least_radius is not None:
            start, off = round_start(moves, arm, pivot, start, least_radius + roller, sense * turn, 1.0)
            binding, error = (CURVATURE, off) if start > reached.least else (binding, error)
            require_round(reached, start)
        if distance(arm, pivot, start) < roller:
            start, binding = followers.start_angle_of_arm(0.0, roller, arm, pivot), ROLLER
        starts.append(start)
        mosts.append(reached.most)
        bindings.append(binding)
        errors.append((error, reached.most_error))
    angle = starts[0] + starts[1] if follower.arm_angle is None else follower.arm_angle
    # the second arm has the rest of the angle, which is limited on both sides too
    start = max(starts[0], angle - mosts[1])
    require(
        starts[1] <= angle - start + 1e-14 and start <= mosts[0] and 0.0 < angle - start < pi,
        "arms {angle} apart keep the limits on one of the two cams only: the first arm may start at {a0} to {a1} from "
        "the line of pivot and axis, the second at {b0} to {b1}",
        angle=(angle, Angle), a0=(starts[0], Angle), a1=(mosts[0], Angle), b0=(starts[1], Angle), b1=(mosts[1], Angle),
        code="limits-clash", hint="take an arm angle of {least:6} to {most:6}, or leave it out",
        least=(starts[0] + starts[1], Angle), most=(mosts[0] + mosts[1], Angle),
    )  # fmt: skip
    error = errors[0][0]
    if start > starts[0]:
        error = errors[1][1] + UNIT * (abs(angle) + mosts[1])
        bindings[0] = "the second cam's limits, with this arm angle"
    radius = distance(arm, pivot, start)
    base = max(radius - roller, 0.0)
    first = Geometry(followers.OscillatingRoller(base, roller, arm, pivot), rotation)
    second = Geometry(followers.ConjugateOscillatingRoller(base, roller, arm, pivot, angle), rotation)
    return _both(
        motion, first, second, limits, least_radius,
        binding=bindings[0] if follower.arm_angle is not None else f"{bindings[0]}; second cam: {bindings[1]}",
        base_radius=base, start_radius=radius, arm_start_angle=first.start, arm_angle=angle,
        second_start=distance(arm, pivot, angle - start), error=moved(arm, pivot, start, error),
    )  # fmt: skip


def _both(
    motion: "Any", first: Geometry, second: Geometry, limits: tuple[float, float], least_radius: "float | None", *,
    binding: str, base_radius: float, start_radius: float, second_start: float, error: float,
    offset: "float | None" = None, arm_start_angle: "float | None" = None, roller_distance: "float | None" = None,
    arm_angle: "float | None" = None,
) -> CamSize:  # fmt: skip
    """The record of a pair, with the extremes of both cams."""
    checks: list[Check] = []
    extremes = []
    for name, geometry in (("first", first), ("second", second)):
        analysis = analyse(geometry, motion)
        high, low, least = (
            analysis.pressure.largest()[0],
            analysis.pressure.smallest()[0],
            convex(geometry, analysis)[0],
        )
        extremes.append((high, low, least))
        checks += [
            kept(f"largest pressure angle of the {name} cam keeps its limit", high - limits[0], 1.0),
            kept(f"least pressure angle of the {name} cam keeps its limit", -low - limits[1], 1.0),
        ]
        if least_radius is not None and least is not None:
            checks.append(
                kept(f"radius of curvature of the {name} cam keeps its limit", least_radius - least, start_radius)
            )
    (high, low, least), mate = extremes
    return CamSize(
        base_radius=base_radius, offset=offset, start_radius=start_radius, arm_start_angle=arm_start_angle,
        binding=binding, largest_pressure_angle=high, least_pressure_angle=low, least_convex_radius=least,
        least_concave_radius=None, in_line_base_radius=None, face_width=None, roller_distance=roller_distance,
        arm_angle=arm_angle, second=SecondCam(second_start, *mate), checks=tuple(checks),
        advice=undercut(min((item[2] for item in extremes if item[2] is not None), default=None), start_radius),
        numerics=Numerics(
            ("closed form" if least_radius is None else "secant or bisection") + " on extremes over the turn",
            (stated(error + UNIT * (3.0 * start_radius + base_radius), base_radius),),
        ),
    )  # fmt: skip
