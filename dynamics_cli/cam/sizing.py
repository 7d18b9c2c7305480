"""How the smallest cam is found: certified extremes of closed forms, and a secant where a curvature binds."""

from math import atan2, cos, hypot, inf, pi, sin, sqrt, tan

import numpy as np

from dynamics_cli.cam import followers, size
from dynamics_cli.cam.analysis import analyse
from dynamics_cli.cam.contact import Geometry
from dynamics_cli.cam.pieces import over_pieces, turning_places, within
from dynamics_cli.cam.profile import convex
from dynamics_cli.errors import require
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

DEGREE = pi / 180.0
ROOM = 1e-11
CURVATURE = "least radius of curvature"
# Steps of the first look for the best offset to either side, and where the search for it ends, of the whole reach.
GRID = 16
FINEST = 1e-11
GOLDEN = 0.5 * (sqrt(5.0) - 1.0)


def _extremes_of(motion: "Any", *functions: "Callable[..., Any]") -> "list[Any]":
    """Certified extremes of functions of s, s′, s″."""
    made = over_pieces(motion, lambda s, s1, s2: np.stack([function(s, s1, s2) for function in functions]))
    return [turning_places(motion, made, index) for index in range(len(functions))]


def size_flat(motion: "Any", follower: "Any", least_radius: float, rotation: str) -> size.CamSize:
    """Base circle of a flat-faced follower: R_b = ρ − min(s + s″), in closed form from certified extremes."""
    both, lift, speed = _extremes_of(motion, lambda s, s1, s2: s + s2, lambda s, s1, s2: s, lambda s, s1, s2: s1)
    low, _ = both.smallest()
    base = least_radius - low
    # a base circle has no negative radius, and the lowest face stays above the axis
    floor = max(0.0, -lift.smallest()[0])
    binding = "least radius of curvature" if base > floor else "a base circle cannot be negative"
    base = max(base, floor)
    geometry = Geometry(followers.FlatFace(base), rotation)
    found = analyse(geometry, motion)
    low_kept = found.curvature.smallest()[0]
    return size.CamSize(
        base_radius=base, offset=None, start_radius=None, arm_start_angle=None, binding=binding,
        largest_pressure_angle=0.0, least_pressure_angle=0.0, least_convex_radius=low_kept,
        in_line_base_radius=None, face_width=speed.largest()[0] - speed.smallest()[0] + 2.0 * follower.face_margin,
        checks=(_kept("radius of curvature keeps its limit", least_radius - low_kept, base + least_radius),),
        advice=_no_limit(least_radius),
        numerics=Numerics("closed form on certified extremes", (ErrorBound("base_radius", _share(both.error, base)),)),
    )  # fmt: skip


def _no_limit(least_radius: float) -> tuple[Advice, ...]:
    if least_radius > 0.0:
        return ()
    return (
        Advice(
            "sharp", "no least radius of curvature was asked for: this cam comes to a point where it binds", "caution",
            "give a least radius, e.g. for contact stress",
        ),
    )  # fmt: skip


def size_slide(
    motion: "Any", follower: "Any", limits: tuple[float, float], least_radius: "float | None", rotation: str
) -> size.CamSize:
    """Base circle and offset of a slide: the apex or a foot of the limits' wedge, raised where curvature binds."""
    turn = -1.0 if rotation == "clockwise" else 1.0
    roller = getattr(follower, "roller_radius", 0.0)
    c1, c2 = (1.0 / tan(limit) for limit in limits)
    # the clockwise cam is the anticlockwise one run backwards: its rise is a return there, and its offset the other way
    rise, back, lift = _extremes_of(
        motion, lambda s, s1, s2: s1 * c1 - s, lambda s, s1, s2: -s1 * c2 - s, lambda s, s1, s2: s
    )
    (a, _), (b, _), floor = rise.largest(), back.largest(), -lift.smallest()[0]
    wanted = None if least_radius is None else least_radius + roller

    def height(e: float) -> float:
        return float(max(a - e * c1, b + e * c2, floor))

    if follower.offset is None:
        e, d, binding = size.best_slide(a, b, c1, c2)
    else:
        e = turn * follower.offset
        d = height(e)
        binding = "rise limit" if a - e * c1 >= b + e * c2 else "return limit"
    radius = hypot(e, d)
    loose = 0.0
    method = "closed form on certified extremes"
    if wanted is not None and not _curved_enough(motion, e, d, roller, wanted, turn):
        binding, method = CURVATURE, "secant on certified extremes"
        if follower.offset is None:
            # no offset beyond the start radius that this one needs can do better
            reach = hypot(e, max(d, _rough_height(motion, e, wanted, turn)))
            e = _search(lambda e: hypot(e, max(height(e), _rough_height(motion, e, wanted, turn))), reach)
            # the rough height is never above the certified one: what lies between is all that another could gain
            loose = reach * FINEST * (1.0 + max(c1, c2)) - _rough_height(motion, e, wanted, turn)
        d = max(height(e), _height_for(motion, e, roller, wanted, turn))
        loose = max(loose + d, 0.0) if follower.offset is None else 0.0
        radius = hypot(e, d)
    if radius < roller:
        binding, d = "the roller itself: a base circle cannot be negative", sqrt((roller - e) * (roller + e))
        radius = roller
    base = radius - roller
    offset = turn * e + 0.0
    follows = followers.Roller(base, roller, offset)
    found = analyse(Geometry(follows, rotation), motion)
    high, low = found.pressure.largest()[0], found.pressure.smallest()[0]
    least, _ = convex(Geometry(follows, rotation), found)
    in_line, curved = max(a, b, floor) - roller, binding == CURVATURE
    error = c1 * rise.error + c2 * back.error + loose
    # a base radius and an offset of doubles tell a height far below them no better
    lever = 1.0 + 1e-4 * (radius / d) ** 2 if d > 0.0 else inf
    checks = [
        _kept("largest pressure angle keeps its limit", high - limits[0], lever),
        _kept("least pressure angle keeps its limit", -low - limits[1], lever),
    ]
    if wanted is not None and least is not None:
        checks.append(_kept("radius of curvature keeps its limit", wanted - roller - least, radius))
    advice: tuple[Advice, ...] = ()
    if least is not None and least <= 0.0:
        message = f"at this size the cam is undercut: its least radius of curvature comes to {least:.6g} m"
        advice = (Advice("undercut", message, "serious", "give --least-radius above zero"),)
    return size.CamSize(
        base_radius=base, offset=offset, start_radius=radius, arm_start_angle=None, binding=binding,
        largest_pressure_angle=high, least_pressure_angle=low, least_convex_radius=least,
        in_line_base_radius=in_line if in_line > 0.0 and not curved else None, face_width=None,
        checks=tuple(checks), advice=advice,
        numerics=Numerics(method, (ErrorBound("base_radius", _share(error, base)),)),
    )  # fmt: skip


def _kept(name: str, excess: float, scale: float) -> Check:
    return Check(name, excess <= ROOM * scale, max(excess, 0.0), ROOM * scale)


def _share(error: float, value: float) -> float:
    return (error + 1e-15 * value) / value if value > 0.0 else inf


def _least(motion: "Any", e: float, d: float, turn: float) -> float:
    """Least convex radius of the pitch curve of a slide at height d; infinite where it is nowhere convex."""
    geometry = Geometry(followers.KnifeEdge(hypot(e, d), turn * e), "clockwise" if turn < 0.0 else "ccw")
    geometry.start = d
    value, _ = analyse(geometry, motion).curvature.largest()
    return 1.0 / value if value > 0.0 else inf


def _curved_enough(motion: "Any", e: float, d: float, roller: float, wanted: float, turn: float) -> bool:
    return _least(motion, e, d, turn) >= wanted


def _rough_height(motion: "Any", e: float, wanted: float, turn: float) -> float:
    """Height at which the least radius of curvature is the wanted one, from the nodes of every piece.

    At each angle the largest root in X of w³ = ρ(w² + Y s′ − X s″), Y = s′ − e, as (w²)³ = ρ²(…)².
    """
    nodes = 0.5 + 0.5 * np.sin(0.5 * np.pi * (np.arange(49) / 24.0 - 1.0))
    count = len(motion.zones)
    s, s1, s2 = (part.ravel() for part in within(motion, np.tile(nodes, (count, 1)), np.arange(count)))
    s1 = turn * s1
    y = s1 - e
    # D = X² − s″X + q; the polynomial in X of degree 6, largest coefficient one
    q, yy, rho = y * (y + s1), y * y, wanted * wanted
    rows = np.zeros((s.size, 6, 6))
    rows[:, np.arange(1, 6), np.arange(5)] = 1.0
    rows[:, 0, 1] = -(3.0 * yy - rho)
    rows[:, 0, 2] = -2.0 * rho * s2
    rows[:, 0, 3] = -(3.0 * yy * yy - rho * (s2 * s2 + 2.0 * q))
    rows[:, 0, 4] = -2.0 * rho * s2 * q
    rows[:, 0, 5] = -(yy * yy * yy - rho * q * q)
    roots = np.linalg.eigvals(rows)
    x = roots.real
    true = (np.abs(roots.imag) < 1e-6 * wanted) & (x * x - s2[:, None] * x + q[:, None] > 0.0)
    heights = np.where(true, x - s[:, None], -np.inf)
    return float(heights.max())


def _height_for(motion: "Any", e: float, roller: float, wanted: float, turn: float) -> float:
    """Height at which the least radius of curvature, certified, is the wanted one: secant from the rough one."""
    d = _rough_height(motion, e, wanted, turn)
    error = _least(motion, e, d, turn) - wanted
    slope = 1.0
    for _ in range(12):
        if abs(error) <= 2e-15 * wanted or not np.isfinite(error):
            break
        new = d - error / slope
        now = _least(motion, e, new, turn) - wanted
        if new != d and now != error:
            slope = min(max((now - error) / (new - d), 0.1), 10.0)
        d, error = new, now
    return d


def _search(cost: "Callable[[float], float]", reach: float) -> float:
    """The offset of least cost: the best of a grid, for there may be several dips, then golden section."""
    step = reach / GRID
    best = min((k * step for k in range(-GRID, GRID + 1)), key=cost)
    low, high = best - step, best + step
    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_a, at_b = cost(a), cost(b)
    for _ in range(50):
        if at_a < at_b:
            high, b, at_b = b, a, at_a
            a = high - GOLDEN * (high - low)
            at_a = cost(a)
        else:
            low, a, at_a = a, b, at_b
            b = low + GOLDEN * (high - low)
            at_b = cost(b)
    return 0.0 if cost(0.0) <= min(at_a, at_b) else 0.5 * (low + high)


def size_arm(
    motion: "Any", follower: "Any", limits: tuple[float, float], least_radius: "float | None", rotation: str
) -> size.CamSize:
    """Base circle of a rocker: the least angle of the arm that keeps both limits, in closed form at every cam angle."""
    arm, pivot, roller = follower.arm, follower.pivot_distance, follower.roller_radius
    require(arm > 0.0 and pivot > 0.0, "an arm and its pivot distance are above zero", code="no-triangle")
    turn = -1.0 if rotation == "clockwise" else 1.0
    # positive pressure angles of a clockwise cam are negative ones of its mirror image
    up, down = limits if turn > 0.0 else limits[::-1]

    def share(s1: "Any", limit: float) -> "Any":
        return arm * (1.0 + turn * s1) * cos(limit) / pivot

    speed = _extremes_of(motion, lambda s, s1, s2: turn * s1)[0].largest()[0]
    require(
        share(turn * speed, up) < 1.0,
        "no base circle keeps the limit of {0:.6g} deg: with an arm of {1:.6g} m, {2:.6g} m from the cam, the pressure "
        "angle reaches {3:.6g} deg at best",
        up / DEGREE, arm, pivot, _best_angle(arm * (1.0 + speed) / pivot) / DEGREE,
        code="limit-binds", hint="shorten the arm, move the pivot outwards, or give the rise a larger angle",
    )  # fmt: skip
    high, low, over, lift = _extremes_of(
        motion,
        lambda s, s1, s2: np.arccos(np.clip(share(s1, down), -1.0, 1.0)) - down - s,
        lambda s, s1, s2: up - np.arccos(np.clip(share(s1, up), -1.0, 1.0)) - s,
        lambda s, s1, s2: up + np.arccos(np.clip(share(s1, up), -1.0, 1.0)) - s,
        lambda s, s1, s2: s,
    )
    names = ("return limit", "rise limit") if turn > 0.0 else ("rise limit", "return limit")
    choices = [(high.largest()[0], names[0]), (low.largest()[0], names[1])]
    start, binding = max(choices)
    most = min(over.smallest()[0], pi - lift.largest()[0])
    start = max(start, -lift.smallest()[0], 0.0)
    require(
        start <= most,
        "no base circle keeps both limits: the {0} wants the arm at {1:.6g} deg or more, and it may be at {2:.6g} deg "
        "at most",
        binding, start / DEGREE, most / DEGREE,
        code="limits-clash", hint="widen the limits, shorten the arm or move the pivot",
    )  # fmt: skip
    radius = hypot(pivot - arm, 2.0 * sqrt(pivot * arm) * sin(0.5 * start))
    method = "closed form on certified extremes"
    if least_radius is not None:
        curved = _arm_radius_for(motion, follower, radius, least_radius, rotation)
        if curved > radius:
            radius, binding, method = curved, "least radius of curvature", "bisection on certified extremes"
            start = followers.start_angle_of_arm(radius, 0.0, arm, pivot)
            require(
                start <= most,
                "the least radius of curvature wants the arm at {0:.6g} deg, beyond the {1:.6g} deg that the pressure "
                "angle allows",
                start / DEGREE, most / DEGREE,
                code="limits-clash", hint="allow a smaller radius of curvature or a larger pressure angle",
            )  # fmt: skip
    if radius < roller:
        radius, binding = roller, "the roller itself: a base circle cannot be negative"
    base = radius - roller
    geometry = Geometry(followers.OscillatingRoller(base, roller, arm, pivot), rotation)
    found = analyse(geometry, motion)
    return size.CamSize(
        base_radius=base, offset=None, start_radius=radius, arm_start_angle=geometry.start, binding=binding,
        largest_pressure_angle=found.pressure.largest()[0], least_pressure_angle=found.pressure.smallest()[0],
        least_convex_radius=convex(geometry, found)[0], in_line_base_radius=None, face_width=None,
        checks=(
            _kept("largest pressure angle keeps its limit", found.pressure.largest()[0] - limits[0], 1.0),
            _kept("least pressure angle keeps its limit", -found.pressure.smallest()[0] - limits[1], 1.0),
        ),
        numerics=Numerics(method, (ErrorBound("base_radius", _share(4.0 * pivot * (high.error + low.error), base)),)),
    )  # fmt: skip


def _best_angle(share: float) -> float:
    """The least pressure angle that an arm of L(1 + ψ′)/c above one can reach: cos φ = c/(L(1 + ψ′))."""
    return atan2(sqrt(max(share * share - 1.0, 0.0)), 1.0)


def _arm_radius_for(motion: "Any", follower: "Any", radius: float, least_radius: float, rotation: str) -> float:
    """The least start radius, from `radius` on, whose cam is as round as wanted; bisection after doubling steps."""

    def short(prime: float) -> bool:
        geometry = Geometry(followers.OscillatingRoller(prime, 0.0, follower.arm, follower.pivot_distance), rotation)
        value, _ = analyse(geometry, motion).curvature.largest()
        return bool(value * (least_radius + follower.roller_radius) > 1.0)

    if not short(radius):
        return radius
    most = follower.arm + follower.pivot_distance
    low, step = radius, 0.02 * radius
    while short(low + step):
        low, step = low + step, 2.0 * step
        require(
            low + step < most,
            "no base circle gives this cam a least radius of curvature of {0:.6g} m",
            least_radius,
            code="curvature-binds",
            hint="lengthen arm and pivot distance, or give the motion larger angles",
        )
    high = low + step
    for _ in range(60):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        if short(middle):
            low = middle
        else:
            high = middle
    return high
