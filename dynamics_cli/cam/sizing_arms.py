"""How the smallest cam of an arm is found: the angle at which the arm may start, in closed form at every cam angle."""

from math import asin, atan2, cos, hypot, inf, pi, sin, sqrt, tan

import numpy as np

from dynamics_cli.cam import followers, size
from dynamics_cli.cam.analysis import analyse
from dynamics_cli.cam.contact import Geometry
from dynamics_cli.cam.profile import concave, convex
from dynamics_cli.cam.roundness import sure_about
from dynamics_cli.cam.sizing import CURVATURE, ROLLER, UNIT, extremes_of, kept, no_limit, signs, stated, undercut
from dynamics_cli.errors import require
from dynamics_cli.numerics.discs import Disc
from dynamics_cli.records import Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

DEGREE = pi / 180.0


@record
class Reach:
    """Angles of an arm at zero lift that keep the limits of pressure angle.

    Parameters
    ----------
    least, most : float
        The angles [rad].
    binding : str
        The limit that decides the least.
    error : float
        Bound of the error of the least [rad].
    most_error : float
        Bound of the error of the most [rad].
    """

    least: float
    most: float
    binding: str
    error: float
    most_error: float


def reach(motion: "Any", arm: float, pivot: float, limits: tuple[float, float], turn: float) -> Reach:
    """Between which angles the arm may start.

    Parameters
    ----------
    motion : Motion
        The program.
    arm, pivot : float
        Length of the arm and distance of its pivot [m].
    limits : pair of float
        The limits of rise and return [rad].
    turn : float
        -1 for a clockwise cam.

    Returns
    -------
    Reach
        The angles.

    Raises
    ------
    InadmissibleError
        When no angle keeps one of the limits (long arms).
    """
    require(arm > 0.0 and pivot > 0.0, "an arm and its pivot distance are above zero", code="no-triangle")
    # positive pressure angles of a clockwise cam are negative ones of its mirror image
    up, down = limits if turn > 0.0 else limits[::-1]

    def part(s1: "Any", limit: float) -> "Any":
        return arm * (1.0 + turn * s1) * Disc(cos(limit), 4.0 * UNIT) / pivot

    def at_best(strain: float, limit: float) -> float:
        return arm * (1.0 + strain) * cos(limit) / pivot

    (speed,) = extremes_of(motion, lambda s, s1, s2: turn * s1)
    # the quickest way up strains one limit, a way down faster than the cam turns the other
    for limit, strain in ((up, speed.largest()[0]), (down, -2.0 - speed.smallest()[0])):
        require(
            at_best(strain, limit) < 1.0,
            "no base circle keeps the limit of {0:.6g} deg: with an arm of {1:.6g} m, {2:.6g} m from the cam, the "
            "pressure angle reaches {3:.6g} deg at best",
            limit / DEGREE, arm, pivot, _best_angle(arm * (1.0 + strain) / pivot) / DEGREE,
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
    # a limit that might decide counts with its own error
    error = max(slip for value, slip, _ in ends if value + slip >= least - error)
    if error == inf:
        # an arc cosine is cut off somewhere on the turn, which leaves its proxies unproved there
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
        seen = analyse(geometry, motion).pressure
        ends = ((seen.greatest - limits[0], seen.greatest_error), (-seen.least - limits[1], seen.least_error))
        return max(1.0 + excess for excess, _ in ends), max(error for _, error in ends)

    return sure_about(pressed, 1.0, start, 1e-6)


def require_reach(found: Reach, start: float) -> None:
    """Refuse an arm that would have to start beyond what the other limit allows."""
    require(
        start <= found.most,
        "no base circle keeps both limits: the {0} wants the arm at {1:.6g} deg or more, and it may be at {2:.6g} deg "
        "at most",
        found.binding, start / DEGREE, found.most / DEGREE,
        code="limits-clash", hint="widen the limits, shorten the arm or move the pivot",
    )  # fmt: skip


def size_arm(
    motion: "Any", follower: "Any", limits: tuple[float, float], least_radius: "float | None", rotation: str, flank: str
) -> size.CamSize:
    """Base circle of a rocker: the least angle of the arm that keeps both limits and the curvature."""
    arm, pivot, roller = follower.arm, follower.pivot_distance, follower.roller_radius
    turn, side = signs(rotation, flank)
    found = reach(motion, arm, pivot, limits, turn)
    start, binding, method = found.least, found.binding, "closed form on certified extremes"
    require_reach(found, start)
    error = found.error
    if least_radius is not None:
        curved, off = round_start(motion, arm, pivot, start, least_radius + roller, turn, side)
        if curved > start:
            start, binding, method, error = curved, CURVATURE, "bisection on certified extremes", off
            require_round(found, start)
    radius = distance(arm, pivot, start)
    slip = moved(arm, pivot, start, error)
    if radius < roller:
        radius, binding = roller, ROLLER
    base = radius - roller
    slip += UNIT * base
    geometry = Geometry(followers.OscillatingRoller(base, roller, arm, pivot), rotation, flank)
    seen = analyse(geometry, motion)
    round_, hollow = convex(geometry, seen)[0], concave(geometry, seen)[0]
    high, low = seen.pressure.largest()[0], seen.pressure.smallest()[0]
    return size.CamSize(
        base_radius=base, offset=None, start_radius=radius, arm_start_angle=geometry.start, binding=binding,
        largest_pressure_angle=high, least_pressure_angle=low, least_convex_radius=round_ if side > 0.0 else None,
        least_concave_radius=hollow if side < 0.0 else None, in_line_base_radius=None, face_width=None,
        checks=(
            kept("largest pressure angle keeps its limit", high - limits[0], 1.0),
            kept("least pressure angle keeps its limit", -low - limits[1], 1.0),
        ),
        advice=undercut(round_ if side > 0.0 else hollow, radius),
        numerics=Numerics(method, (stated(slip, base),)),
    )  # fmt: skip


def distance(arm: float, pivot: float, angle: float) -> float:
    """Distance of the roller's centre from the cam's axis, the arm at that angle."""
    return hypot(pivot - arm, 2.0 * sqrt(pivot * arm) * sin(0.5 * angle))


def moved(arm: float, pivot: float, angle: float, error: float) -> float:
    """What that distance may be off where the angle may be, its own roundings included."""
    radius = distance(arm, pivot, angle)
    lever = arm * pivot * (abs(sin(angle)) + error) / radius if radius else arm + pivot
    return min(lever, arm + pivot) * error + 8.0 * UNIT * radius


def require_round(found: Reach, start: float) -> None:
    """Refuse a curvature that wants the arm beyond what the pressure angles allow."""
    require(
        start <= found.most,
        "the least radius of curvature wants the arm at {0:.6g} deg, beyond the {1:.6g} deg that the pressure "
        "angle allows",
        start / DEGREE, found.most / DEGREE,
        code="limits-clash", hint="allow a smaller radius of curvature or a larger pressure angle",
    )  # fmt: skip


def _best_angle(part: float) -> float:
    """The least pressure angle that an arm of L(1 + ψ′)/c above one can reach: cos φ = c/(L(1 + ψ′))."""
    return atan2(sqrt(max(part * part - 1.0, 0.0)), 1.0)


def round_start(
    motion: "Any", arm: float, pivot: float, start: float, wanted: float, turn: float, side: float
) -> tuple[float, float]:
    """The least angle of the arm, from `start` on, whose pitch curve is as round as wanted, and what it may be off.

    Parameters
    ----------
    motion : Motion
        The program.
    arm, pivot : float
        Length of the arm and distance of its pivot [m].
    start : float
        The least angle [rad].
    wanted : float
        Least radius of curvature of the pitch curve, where it is hollow on an outer flank [m].
    turn, side : float
        -1 for a clockwise cam; -1 for an outer flank.

    Returns
    -------
    (float, float)
        The angle, and the bound of its error [rad].

    Raises
    ------
    InadmissibleError
        When there is none.

    Notes
    -----
    Bisection on certified extremes, after steps that double. The curvature is surely too large an error below the
    angle, and surely not an error above it.
    """
    prime = distance(arm, pivot, 0.5 * pi)
    geometry = Geometry(followers.OscillatingRoller(prime, 0.0, arm, pivot), "cw" if turn < 0.0 else "ccw")

    def bend(angle: float) -> tuple[float, float]:
        geometry.start = angle
        seen = analyse(geometry, motion).curvature
        return (seen.greatest, seen.greatest_error) if side > 0.0 else (-seen.least, seen.least_error)

    def short(angle: float) -> bool:
        return bend(angle)[0] * wanted > 1.0

    if not short(start):
        return start, 0.0
    low, step = start, max(0.01 * start, 1e-3)
    while short(low + step):
        low, step = low + step, 2.0 * step
        require(
            low + step < pi,
            "no base circle gives this cam a radius of curvature of {0:.6g} m for its roller's centre",
            wanted,
            code="curvature-binds",
            hint="lengthen arm and pivot distance, or give the motion larger angles",
        )
    angle = _halved(short, low, low + step)
    return angle, sure_about(bend, wanted, angle, UNIT * angle)


def _halved(short: "Callable[[float], bool]", low: float, high: float) -> float:
    """Where it is not short any more, by bisection."""
    while True:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            return high
        if short(middle):
            low = middle
        else:
            high = middle


def size_rocker(
    motion: "Any", follower: "Any", limits: tuple[float, float], least_radius: float, rotation: str
) -> size.CamSize:
    """Base circle of a flat rocker: c(A sin ψ + B cos ψ) ≥ (ρ + f)(1 + ψ′)³, A = (1 + 2ψ′)(1 + ψ′), B = ψ″.

    With M = √(A² + B²), β = atan2(B, A), this is M sin(ψ + β) ≥ C: ψ₀ ≥ asin(C/M) − β − s, in closed form.
    """
    pivot, back = follower.pivot_distance, follower.face_offset
    turn, _ = signs(rotation, "inner")
    require(pivot > abs(back), "the face's offset reaches beyond the pivot's distance", code="pivot-inside",
            hint="move the pivot outwards")  # fmt: skip
    slowest = 1.0 + extremes_of(motion, lambda s, s1, s2: turn * s1)[0].smallest()[0]
    require(
        slowest > 0.0,
        "the rocker turns as fast as the cam (1 + dψ/dθ falls to {0:.6g}): a flat face cannot follow this motion",
        slowest, code="face-too-fast", hint="give the return a larger angle of the cam",
    )  # fmt: skip

    def parts(s1: "Any", s2: "Any") -> "tuple[Any, Any]":
        speed = 1.0 + turn * s1
        a = (1.0 + 2.0 * turn * s1) * speed
        factor = (least_radius + back) / pivot
        needs = speed * speed * speed * Disc(factor, 2.0 * UNIT * abs(factor)) / np.hypot(a, s2)
        # β from −90 to 270 degrees, without a branch: its proxies are proved
        return needs, 0.5 * pi + np.arctan2(-a, s2)

    (needed,) = extremes_of(motion, lambda s, s1, s2: parts(s1, s2)[0])
    require(
        needed.largest()[0] < 1.0,
        "no base circle gives this cam a least radius of curvature of {0:.6g} m: the pivot is {1:.6g} m from the cam's "
        "axis, and it would have to be {2:.6g} m at least",
        least_radius, pivot, pivot * needed.largest()[0],
        code="curvature-binds", hint="move the pivot outwards, or give the motion larger angles",
    )  # fmt: skip
    # the limit that the face's offset runs against: the normal leans the same way all the time
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
        (0.5 * pi - lift.largest()[0], "the face, which would be touched at its pivot"),
    )
    require(
        start <= most,
        "no base circle keeps the limits: the {0} wants the face at {1:.6g} deg or more, and the {2} at {3:.6g} deg at "
        "most",
        binding, start / DEGREE, cap, most / DEGREE,
        code="limits-clash", hint="move the pivot outwards, bring the face nearer to it, or widen the limits",
    )  # fmt: skip
    base = max(pivot * sin(start) - back, 0.0)
    error = lowest.greatest_error if start > floor else lift.least_error + 6.0 * UNIT * floor
    slip = pivot * (cos(start) + error) * error + 6.0 * UNIT * pivot * sin(start) + UNIT * base
    geometry = Geometry(followers.OscillatingFlat(base, pivot, back), rotation)
    seen = analyse(geometry, motion)
    least, high, low = convex(geometry, seen)[0], seen.pressure.largest()[0], seen.pressure.smallest()[0]
    assert seen.along is not None
    width = seen.along.largest()[0] - seen.along.smallest()[0] + 2.0 * follower.face_margin
    assert least is not None
    return size.CamSize(
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
            "closed form on certified extremes",
            (stated(slip, base),),
        ),
    )  # fmt: skip


def _arcsine(part: "Any") -> "Any":
    return np.arcsin(np.clip(part, -1.0, 1.0))
