"""Minimum distance between the teeth of one gear and the root of the other, exact apart from rounding.

Between two gears the normal at a minimum distance passes through the pitch point, as at a contact; only the edge of a
tooth's tip can be there (other points with such a normal are on the line of action, and touch). So the edge's path in
the space is compared with the root: trochoid or fillet, start of the flank, and root circle. Places are located in
doubles; at a minimum an error of the place counts only by its square, and the distance itself carries its rounding
bound.
"""

import math
from math import pi

from dynamics_cli.gear.rounding import bare, error_of, with_error
from dynamics_cli.gear.single.flanks import ToothForm, fillet_centre
from dynamics_cli.numerics import elementary
from dynamics_cli.numerics.elementary import absolute, acos, atan, cos, pi_beside, sin, sqrt
from dynamics_cli.numerics.number import like

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]
    Vector = tuple[float, float]
    # Angle of the gear, which edge, place along the root (None: where the flank begins), and which side of the space.
    Place = tuple[float, float, float | None, float]

# Rotations of the gear and places along the root in the first pass; number of minima that are refined.
TURNS, PLACES, BEST = 481, 49, 3
# Steps of Newton's method for all nearest places at once, and for a single one; how many steps it may move away.
SHARPER, STEPS, FAR = 3, 40, 2.0
# Tolerance of angles, and where rounding prevents it the second: the distance errs by the square.
SHARP, BLUNT = 1e-13, 1e-10
# An edge is considered up to this many modules beyond the form circle: farther off it is farther from the root than
# that.
BESIDE = 0.7


class RootCurve:
    """One side of a gear's space below its flank, in the space's frame: x along its middle, y ≥ 0.

    `functions` has the elementary functions for the numbers used.
    """

    def __init__(self, form: ToothForm, functions: "Any" = elementary) -> None:
        self.form = form
        self.functions = functions
        if form.internal:
            self._fillet()
        else:
            self._trochoid()

    def _trochoid(self) -> None:
        form, cutter, junction = self.form, self.form.cutter, self.form.junction
        assert cutter is not None
        assert junction is not None
        self.radius, self.excess = cutter.pitch_radius, cutter.stretch * cutter.stretch - 1.0
        self.depth, self.offset, self.rounding = cutter.corner_depth, cutter.corner_offset, cutter.tip_radius
        self.range = (0.5 * pi, bare(junction.direction))
        self.forward = 1.0
        self.end = form.form, pi_beside(form.half_base) / form.teeth - form.half_angle(junction.roll)

    def _fillet(self) -> None:
        form = self.form
        centre, angle = fillet_centre(form)
        half = pi_beside(angle) / form.teeth - angle
        self.centre = centre * cos(half), centre * sin(half)
        ratio = centre / form.base
        # from the radius to the normal of the involute, which leans by the pressure angle of the centre
        lean = 0.5 * pi - atan(sqrt((ratio - 1.0) * (ratio + 1.0)))
        self.range = (bare(half), bare(half + lean))
        self.forward = -1.0
        self.end = form.form, form.half_angle(form.roll(form.form))

    def at(self, theta: "Any") -> "tuple[Any, Any]":
        """The point at θ, and the unit normal into the space."""
        sin, cos, sqrt = self.functions.sin, self.functions.cos, self.functions.sqrt
        sine, cosine = sin(theta), cos(theta)
        if self.form.internal:
            x, y = self.centre
            return (x + self.form.fillet * cosine, y + self.form.fillet * sine), (-cosine, -sine)
        widening = sqrt(1.0 + self.excess * cosine * cosine)
        xi = self.radius * sine - (self.depth + self.rounding * sine / widening) / sine
        across = self.radius * cosine
        travel = self.depth * cosine / sine - self.offset
        turn = (travel - self.rounding * self.excess * cosine / widening) / self.radius
        # the curve's direction is θ − turn; its point lies on its normal, ξ from the foot nearest the centre
        sine, cosine = sin(theta - turn), cos(theta - turn)
        module = self.form.module
        point = module * (across * cosine + xi * sine), module * (across * sine - xi * cosine)
        return point, (sine, -cosine)

    def corner(self) -> "Vector":
        """Where the flank begins."""
        radius, angle = self.end
        return radius * self.functions.cos(angle), radius * self.functions.sin(angle)


class TipPath:
    """The edge of a tooth's tip in the space that it turns through."""

    def __init__(
        self, first: ToothForm, second: ToothForm, distance: float, play: float, functions: "Any" = elementary
    ) -> None:
        self.functions = functions
        self.first = first
        self.second = second
        self.distance = distance
        self.play = play
        half = first.half_angle(first.roll(first.tip))
        self.half = pi_beside(half) / first.teeth - half if first.internal else half
        inside = first.internal or second.internal
        self.way = 1.0 if inside else -1.0
        self.ratio = self.way * first.teeth / second.teeth

    def at(self, turn: "Any", side: float) -> "tuple[Any, Any]":
        """Position of the edge at an angle of its gear, and its derivative by that angle."""
        sin, cos = self.functions.sin, self.functions.cos
        angle = turn + side * self.half
        along, across = self.first.tip * cos(angle), self.first.tip * sin(angle)
        if self.first.internal:
            x, y, sense = along - self.distance, across, 1.0
        elif self.second.internal:
            x, y, sense = along + self.distance, across, 1.0
        else:
            x, y, sense = self.distance - along, -across, -1.0
        # in this order, so that doubles standing for exact angles lose nothing in other numbers
        back = self.way * turn * self.first.teeth / self.second.teeth + self.play
        sine, cosine = sin(back), cos(back)
        px, py = x * cosine + y * sine, y * cosine - x * sine
        vx, vy = -sense * across, sense * along
        # motion of its gear relative to the space
        return (px, py), (vx * cosine + vy * sine + self.ratio * py, vy * cosine - vx * sine - self.ratio * px)

    def reach(self) -> float:
        """The angle to either side within which the edge may be near the root."""
        first, second, a = self.first, self.second, self.distance
        if second.internal:
            edge = max(second.form - BESIDE * second.module, second.tip)
            cosine = (edge * edge - first.tip * first.tip - a * a) / (2.0 * first.tip * a)
        else:
            edge = min(second.form + BESIDE * second.module, second.tip)
            cosine = (first.tip * first.tip + a * a - edge * edge) / (2.0 * first.tip * a)
        polar = pi if cosine <= -1.0 else 0.0 if cosine >= 1.0 else acos(cosine)
        return min(pi, polar + self.half)


def root_gaps(
    first: ToothForm,
    second: ToothForm,
    distance: float,
    play: float,
    touches: "tuple[float | None, float | None]",
    places: "tuple[Any, Any] | None" = None,
) -> "tuple[float | None, float | None, tuple[Any, Any]]":
    """The minimum distances of the first gear's teeth from the second's roots and of the second's from the first's.

    None where the tips stay beyond the form circle; the places of the least distances come with them.
    """
    turned = play * (second.teeth / first.teeth)
    if places is None:
        pinion, wheel, apart = bare(first), bare(second), bare(distance)
        places = least_places(pinion, wheel, apart, bare(play)), least_places(wheel, pinion, apart, bare(turned))
    into, out = places
    inward = None if into is None else root_gap(first, second, distance, play, touches[0], into)
    outward = None if out is None else root_gap(second, first, distance, turned, touches[1], out)
    return inward, outward, places


def root_gap(
    first: ToothForm,
    second: ToothForm,
    distance: float,
    play: float,
    touch: "float | None",
    places: "tuple[Place, ...]",
) -> float:
    """The minimum distance of a tooth of `first` from the root of the space of `second` it turns through.

    `play` is half the angle `second` can be turned by: the driving flanks touch. `touch` is the design distance
    from the start of the flank, if an involute of `first` reaches it. Negative ones are overlaps.
    """
    path, curve = TipPath(first, second, distance, play), RootCurve(second)
    gaps = [_tip_clearance(first, second, distance), *(_distance(path, curve, *place) for place in places)]
    if touch is not None:
        gaps.append(touch)
    least = min(gaps, key=bare)
    # whichever of nearly equal ones is the minimum, their common bound holds
    worst = max(error_of(gap) for gap in gaps if bare(gap - least) <= error_of(gap))
    return with_error(least, worst)  # type: ignore[no-any-return]


def least_places(first: ToothForm, second: ToothForm, distance: float, play: float) -> "tuple[Place, ...] | None":
    """The places of the minimum distances, in doubles; None where the tips stay beyond the form circle."""
    import numpy as np

    deepest = distance + first.tip if second.internal else absolute(distance - first.tip)
    if (deepest < second.form) if second.internal else (deepest > second.form):
        return None
    curves = TipPath(first, second, distance, play, np), RootCurve(second, np)
    path, curve = TipPath(first, second, distance, play, math), RootCurve(second, math)
    # without backlash one side is the mirror image of the other
    sides = (-1.0, 1.0) if play > 0.0 else (1.0,)
    places = [place for side in sides for place in _places(curves, path, curve, side)]
    gaps = [_distance(path, curve, *place) for place in places]
    nearly = min(gaps, default=0.0) + 1e-9 * second.module
    return tuple(place for place, gap in zip(places, gaps, strict=True) if gap <= nearly)


def _tip_clearance(first: ToothForm, second: ToothForm, distance: float) -> float:
    if second.internal:
        return second.root - distance - first.tip
    return first.tip - distance - second.root if first.internal else distance - first.tip - second.root


def _distance(path: TipPath, curve: RootCurve, turn: float, side: float, theta: "float | None", mirror: float) -> float:
    """The distance at a place: along the normal of the root, or straight to where the flank begins."""
    (x, y), _ = path.at(like(turn, path.play), side)
    y = mirror * y
    if theta is None:
        px, py = curve.corner()
        return sqrt((x - px) * (x - px) + (y - py) * (y - py))
    (px, py), (nx, ny) = curve.at(like(theta, path.play))
    return (x - px) * nx + (y - py) * ny  # type: ignore[no-any-return]


def _places(both: "tuple[TipPath, RootCurve]", path: TipPath, curve: RootCurve, side: float) -> "Iterator[Place]":
    """The minimum distances of one edge, from a scan of many angles at once (`both` take arrays)."""
    import numpy as np

    reach = path.reach()
    turns, thetas = np.linspace(-reach, reach, TURNS), np.linspace(*curve.range, PLACES)
    gap, places, mirrored = _look(*both, turns, thetas, side)
    padded = np.concatenate(([np.inf], gap, [np.inf]))
    least = np.flatnonzero((gap <= padded[:-2]) & (gap <= padded[2:]) & (gap < np.inf))
    for row in least[np.argsort(gap[least], kind="stable")][:BEST]:
        mirror = -1.0 if mirrored[row] else 1.0
        start, steps = (turns[row], places[row]), (turns[1] - turns[0], thetas[1] - thetas[0])
        for turn, theta in _refined(path, curve, _floats(start), _floats(steps), side, mirror):
            yield turn, side, theta, mirror


def _floats(two: "tuple[Any, Any]") -> "tuple[float, float]":
    return float(two[0]), float(two[1])


def _look(
    path: TipPath, curve: RootCurve, turns: "Array", thetas: "Array", side: float
) -> "tuple[Array, Array, Array]":
    """At each angle the distance from the root, the nearest place of it, and whether that is on the mirrored side."""
    import numpy as np

    (x, y), _ = path.at(turns, side)
    mirrored, y = y < 0.0, np.abs(y)
    (cx, cy), _ = curve.at(thetas)
    theta = thetas[np.hypot(x[:, None] - cx, y[:, None] - cy).argmin(axis=1)]
    low, high = sorted(curve.range)

    def along(angles: "Array") -> "Array":
        (cx, cy), (nx, ny) = curve.at(angles)
        return (y - cy) * nx - (x - cx) * ny  # type: ignore[no-any-return]

    half_step = 1e-4 * (thetas[1] - thetas[0])
    for _ in range(SHARPER):
        slope = (along(theta + half_step) - along(theta - half_step)) / (2.0 * half_step)
        move = along(theta) / np.where(slope == 0.0, np.inf, slope)
        theta = np.clip(theta - np.clip(move, -(high - low), high - low), low, high)
    (cx, cy), (nx, ny) = curve.at(theta)
    off = (x - cx) * nx + (y - cy) * ny
    # an edge beyond the end of the root, in the flank, is treated elsewhere
    beyond = (theta == curve.range[1]) & (curve.forward * along(theta) > 0.0)
    gap = np.where(beyond, np.where(off > 0.0, np.hypot(x - cx, y - cy), np.inf), off)
    away = np.hypot(x, y)
    near = away > path.second.tip if path.second.internal else away < path.second.tip
    return np.where(near, gap, np.inf), theta, mirrored


def _refined(
    path: TipPath,
    curve: RootCurve,
    start: "tuple[float, float]",
    steps: "tuple[float, float]",
    side: float,
    mirror: float,
) -> "list[tuple[float, float | None]]":
    """The refined angle and place of a minimum distance."""

    def towards(turn: float, theta: float) -> "tuple[float, float]":
        """Distance of the edge from the normal of the root, and its speed along that normal."""
        (x, y), (u, v) = path.at(turn, side)
        (px, py), (nx, ny) = curve.at(theta)
        return (x - px) * ny - (mirror * y - py) * nx, u * nx + mirror * v * ny

    def to_corner(turn: float) -> float:
        (x, y), (u, v) = path.at(turn, side)
        px, py = curve.corner()
        return (x - px) * u + (mirror * y - py) * mirror * v  # type: ignore[no-any-return]

    refined: list[tuple[float, float | None]] = []
    low, high = sorted(curve.range)
    place = _newton(towards, start, steps)
    if place is not None and low <= place[1] <= high and abs(place[0] - start[0]) < FAR * steps[0]:
        refined.append(place)
    turn = _newton_of_one(to_corner, start[0], steps[0])
    if turn is not None and abs(turn - start[0]) < FAR * steps[0]:
        (x, y), _ = path.at(turn, side)
        px, py = curve.corner()
        (_, _), (nx, ny) = curve.at(curve.range[1])
        if (x - px) * nx + (mirror * y - py) * ny > 0.0:
            refined.append((turn, None))
    return refined


def _newton_of_one(function: "Callable[[float], float]", x: float, step: float) -> "float | None":
    """The root of a function near x by secants; None if they diverge."""
    before, f_before = x - 1e-3 * step, function(x - 1e-3 * step)
    for _ in range(STEPS):
        value = function(x)
        if value == f_before or value == 0.0:
            return x
        move = value * (x - before) / (value - f_before)
        before, f_before, x = x, value, x - min(max(move, -step), step)
        if abs(x - before) <= SHARP:
            return x
    return None


def _newton(
    function: "Callable[[float, float], tuple[float, float]]", start: "tuple[float, float]",
    steps: "tuple[float, float]",
) -> "tuple[float, float] | None":  # fmt: skip
    """The root of two functions of two variables, slopes by differences; None if the steps diverge."""
    x, y = start
    hx, hy = 1e-4 * steps[0], 1e-4 * steps[1]
    for _ in range(STEPS):
        f, g = function(x, y)
        fx, gx = (0.5 * (a - b) / hx for a, b in zip(function(x + hx, y), function(x - hx, y), strict=True))
        fy, gy = (0.5 * (a - b) / hy for a, b in zip(function(x, y + hy), function(x, y - hy), strict=True))
        slope = fx * gy - fy * gx
        if slope == 0.0:
            return None
        dx, dy = (f * gy - g * fy) / slope, (g * fx - f * gx) / slope
        cut = max(abs(dx) / steps[0], abs(dy) / steps[1], 1.0)
        x, y = x - dx / cut, y - dy / cut
        if abs(dx) <= SHARP and abs(dy) <= SHARP:
            return x, y
    return (x, y) if abs(dx) <= BLUNT and abs(dy) <= BLUNT else None
