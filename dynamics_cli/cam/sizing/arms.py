"""The smallest cam for an arm: the angle at which the arm may start, in closed form at every cam angle."""

from math import atan2, cos, hypot, pi, sin, sqrt

import numpy as np

from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.analysis import analyse, concave, convex
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.sizing.records import CamSize
from dynamics_cli.cam.sizing.roundness import sure_about
from dynamics_cli.cam.sizing.slides import CURVATURE, ROLLER, UNIT, extremes_of, kept, signs, stated, undercut
from dynamics_cli.errors import require
from dynamics_cli.numerics.discs import Disc
from dynamics_cli.numerics.roots import halved
from dynamics_cli.quantities import Angle, Annotated, Size
from dynamics_cli.records import Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


# a larger error of an angle is that of a bent function
CLIPPED = 1e-12


@record
class Reach:
    """Angles of an arm at zero lift that keep the limits of pressure angle."""

    least: Annotated[float, "The angles [rad]."]
    most: Annotated[float, "The angles [rad]."]
    binding: Annotated[str, "The limit that decides the minimum."]
    error: Annotated[float, "Bound of the error of the minimum [rad]."]
    most_error: Annotated[float, "Bound of the error of the most [rad]."]


def reach(motion: "Any", arm: float, pivot: float, limits: tuple[float, float], turn: float) -> Reach:
    """The range of angles in which the arm may start.

    `motion`: the program; `arm`, `pivot`: length of the arm and distance of its pivot [m]; `limits`: the limits of rise
    and return [rad]; `turn`: -1 for a clockwise cam. Returns the angles. Raises InadmissibleError when no angle keeps
    one of the limits (long arms).
    """
    require(arm > 0.0 and pivot > 0.0, "arm and pivot distance must be positive", code="no-triangle")
    # positive pressure angles of a clockwise cam are negative ones of its mirror image
    up, down = limits if turn > 0.0 else limits[::-1]

    def part(s1: "Any", limit: float) -> "Any":
        return arm * (1.0 + turn * s1) * Disc(cos(limit), 4.0 * UNIT) / pivot

    def at_best(strain: float, limit: float) -> float:
        return arm * (1.0 + strain) * cos(limit) / pivot

    (speed,) = extremes_of(motion, lambda s, s1, s2: turn * s1)
    # the fastest rise is critical for one limit, a return faster than the cam turns for the other
    for limit, strain in ((up, speed.largest()[0]), (down, -2.0 - speed.smallest()[0])):
        require(
            at_best(strain, limit) < 1.0,
            "no base circle keeps the limit of {limit}: with an arm of {arm}, {pivot} from the cam, the smallest "
            "possible maximum of the pressure angle is {best:6}",
            limit=(limit, Angle), arm=(arm, Size), pivot=(pivot, Size),
            best=(_best_angle(arm * (1.0 + strain) / pivot), Angle),
            code="limit-binds", hint="shorten the arm, move the pivot outwards, or give the motion a larger angle",
        )  # fmt: skip
    high, low, over, lift = extremes_of(
        motion,
        lambda s, s1, s2: np.arccos(np.clip(part(s1, down), -1.0, 1.0)) - down - s,
        lambda s, s1, s2: up - np.arccos(np.clip(part(s1, up), -1.0, 1.0)) - s,
        lambda s, s1, s2: up + np.arccos(np.clip(part(s1, up), -1.0, 1.0)) - s,
        lambda s, s1, s2: s,
    )
    names = ("return limit", "rise limit") if turn > 0.0 else ("rise limit", "return limit")
    ends = [(high.greatest, high.greatest_error, names[0]), (low.greatest, low.greatest_error, names[1])]
    least, error, binding = max(ends)
    most, most_error = min((over.least, over.least_error), (pi - lift.greatest, lift.greatest_error + 4.0 * UNIT))
    # a limit that might decide contributes its error
    error = max(bound for value, bound, _ in ends if value + bound >= least - error)
    if error > CLIPPED:
        # an arc cosine is clipped somewhere on the turn, where no interpolant follows it
        error = _pressed(motion, (arm, pivot), least, limits, turn)
    floor = max(-lift.least, 0.0)
    return Reach(max(least, floor), most, binding, error if least + error > floor else lift.least_error, most_error)


def _pressed(
    motion: "Any", lengths: tuple[float, float], start: float, limits: tuple[float, float], turn: float
) -> float:
    """How far from an angle of the arm the pressure angle surely breaks a limit below and surely keeps both above."""
    arm, pivot = lengths
    prime = distance(arm, pivot, 0.5 * pi)
    geometry = Geometry(followers.OscillatingRoller(prime, 0.0, arm, pivot), "cw" if turn < 0.0 else "ccw")

    def pressed(angle: float) -> tuple[float, float]:
        geometry.start = angle
        phi = analyse(geometry, motion).pressure
        ends = ((phi.greatest - limits[0], phi.greatest_error), (-phi.least - limits[1], phi.least_error))
        return max(1.0 + excess for excess, _ in ends), max(error for _, error in ends)

    return sure_about(pressed, 1.0, start, 1e-6)


def require_reach(allowed: Reach, start: float) -> None:
    """Refuse an arm whose required start is beyond the other limit."""
    require(
        start <= allowed.most,
        "no base circle keeps both limits: the {binding} needs the arm at {start:6} or more, the other limit at "
        "{most:6} or less",
        binding=allowed.binding, start=(start, Angle), most=(allowed.most, Angle),
        code="limits-clash", hint="widen the limits, shorten the arm or move the pivot",
    )  # fmt: skip


def size_arm(
    motion: "Any", follower: "Any", limits: tuple[float, float], least_radius: "float | None", rotation: str, flank: str
) -> CamSize:
    """Base circle of a rocker: the smallest angle of the arm that keeps both limits and the curvature."""
    arm, pivot, roller = follower.arm, follower.pivot_distance, follower.roller_radius
    turn, side = signs(rotation, flank)
    reached = reach(motion, arm, pivot, limits, turn)
    start, binding, method = reached.least, reached.binding, "closed form on extremes over the turn"
    require_reach(reached, start)
    error = reached.error
    if least_radius is not None:
        curved, off = round_start(motion, arm, pivot, start, least_radius + roller, turn, side)
        if curved > start:
            start, binding, method, error = curved, CURVATURE, "bisection on extremes over the turn", off
            require_round(reached, start)
    radius = distance(arm, pivot, start)
    bound = moved(arm, pivot, start, error)
    if radius < roller:
        radius, binding = roller, ROLLER
    base = radius - roller
    bound += UNIT * base
    geometry = Geometry(followers.OscillatingRoller(base, roller, arm, pivot), rotation, flank)
    analysis = analyse(geometry, motion)
    round_, hollow = convex(geometry, analysis)[0], concave(geometry, analysis)[0]
    high, low = analysis.pressure.largest()[0], analysis.pressure.smallest()[0]
    return CamSize(
        base_radius=base, offset=None, start_radius=radius, arm_start_angle=geometry.start, binding=binding,
        largest_pressure_angle=high, least_pressure_angle=low, least_convex_radius=round_ if side > 0.0 else None,
        least_concave_radius=hollow if side < 0.0 else None, in_line_base_radius=None, face_width=None,
        checks=(
            kept("largest pressure angle keeps its limit", high - limits[0], 1.0),
            kept("least pressure angle keeps its limit", -low - limits[1], 1.0),
        ),
        advice=undercut(round_ if side > 0.0 else hollow, radius),
        numerics=Numerics(method, (stated(bound, base),)),
    )  # fmt: skip


def distance(arm: float, pivot: float, angle: float) -> float:
    """Distance of the roller's centre from the cam's axis, the arm at that angle."""
    return hypot(pivot - arm, 2.0 * sqrt(pivot * arm) * sin(0.5 * angle))


def moved(arm: float, pivot: float, angle: float, error: float) -> float:
    """Error of that distance due to the error of the angle, with its own rounding."""
    radius = distance(arm, pivot, angle)
    lever = arm * pivot * (abs(sin(angle)) + error) / radius if radius else arm + pivot
    return min(lever, arm + pivot) * error + 8.0 * UNIT * radius


def require_round(allowed: Reach, start: float) -> None:
    """Refuse a curvature that needs the arm beyond the range that the pressure angles allow."""
    require(
        start <= allowed.most,
        "the limit of curvature needs the arm at {start:6}, beyond the {most:6} that the pressure angle allows",
        start=(start, Angle), most=(allowed.most, Angle),
        code="limits-clash", hint="allow a smaller radius of curvature or a larger pressure angle",
    )  # fmt: skip


def _best_angle(part: float) -> float:
    """The least pressure angle that an arm of L(1 + ψ′)/c above one can reach: cos φ = c/(L(1 + ψ′))."""
    return atan2(sqrt(max(part * part - 1.0, 0.0)), 1.0)


def round_start(
    motion: "Any", arm: float, pivot: float, start: float, wanted: float, turn: float, side: float
) -> tuple[float, float]:
    """The smallest angle of the arm, from `start` on, with the required curvature, and its error bound.

    `motion`: the program; `arm`, `pivot`: length of the arm and distance of its pivot [m]; `start`: the least angle
    [rad]; `wanted`: least radius of curvature of the pitch curve, where it is hollow on an outer flank [m]; `turn`,
    `side`: -1 for a clockwise cam; -1 for an outer flank. Returns the angle, and the bound of its error [rad]. Raises
    InadmissibleError if no angle is possible.

    Bisection on extremes over the turn, after steps that double. The curvature is certainly too large one error below
    the angle, and certainly not one error above it.
    """
    prime = distance(arm, pivot, 0.5 * pi)
    geometry = Geometry(followers.OscillatingRoller(prime, 0.0, arm, pivot), "cw" if turn < 0.0 else "ccw")

    def bend(angle: float) -> tuple[float, float]:
        geometry.start = angle
        kappa = analyse(geometry, motion).curvature
        return (kappa.greatest, kappa.greatest_error) if side > 0.0 else (-kappa.least, kappa.least_error)

    def short(angle: float) -> bool:
        return bend(angle)[0] * wanted > 1.0

    if not short(start):
        return start, 0.0
    low, step = start, max(0.01 * start, 1e-3)
    while short(low + step):
        low, step = low + step, 2.0 * step
        require(
            low + step < pi,
            "no base circle gives this cam a radius of curvature of {wanted} for its roller's centre",
            wanted=(wanted, Size),
            code="curvature-binds",
            hint="lengthen arm and pivot distance, or give the motion larger angles",
        )
    angle = halved(short, low, low + step)[1]
    return angle, sure_about(bend, wanted, angle, UNIT * angle)
