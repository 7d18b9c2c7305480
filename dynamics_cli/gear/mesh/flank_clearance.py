"""Clearance between the edges of a tooth's tip and the flanks of the space it turns through, off the line of action.

The flanks of two involutes touch on the line of action alone, so that only a tip's edge can cut into a flank beside it.
It is sampled while it turns through the space, and where it crosses the form circle, below which the space's flank is
not an involute; about the minimum distances the angles are sampled again, finer each time.
"""

from math import acos, pi, sqrt

from dynamics_cli.gear.single.flanks import ToothForm, fillet_centre, flank

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# Chords of the space's flanks, relative to the module.
FINE = 1e-6
# Angles in the first pass, and in each finer one about the minima.
STEPS, FINER_STEPS, ROUNDS = 2001, 41, 4
# A point on the form circle counts as below and above it, whichever way it rounds.
EDGE = 1e-12


def flank_gap(first: ToothForm, second: ToothForm, distance: float, play: float) -> float:
    """Minimum distance of the tip's edges of `first` from the flanks of the space of `second` they turn through.

    `play` is half the angle `second` can be turned by: the driving flanks touch. Where contact ends the distance is
    zero by design, to the chords; negative ones are overlaps (off the line of action: trimming). Infinite if
    nothing comes near.
    """
    import numpy as np

    turn, reach = _Turn(first, second, distance, play), _reach(first, second, distance)
    half = first.half_angle(first.roll(first.tip))
    half = pi / first.teeth - half if first.internal else half
    grid = np.linspace(-reach, reach, STEPS)
    least = float("inf")
    for edge in (-half, half):
        value, angle = turn.least(edge, grid)
        width = grid[1] - grid[0]
        for _ in range(ROUNDS if value < least else 0):
            least = min(least, value)
            value, angle = turn.least(edge, np.linspace(angle - width, angle + width, FINER_STEPS))
            width *= 2.0 / (FINER_STEPS - 1)
        least = min(least, value)
    return least


class _Turn:
    """A tooth's points, turned with their gear, in the space of the other gear."""

    def __init__(self, first: ToothForm, second: ToothForm, distance: float, play: float) -> None:
        self.first = first
        self.second = second
        self.distance = distance
        self.play = play
        self.radius, self.half, self.across = wall(second, FINE * second.module)
        inside = first.internal or second.internal
        self.ratio = (1.0 if inside else -1.0) * first.teeth / second.teeth

    def least(self, edge: float, turns: "Array") -> tuple[float, float]:
        """The minimum distance of an edge from the flanks and its angle; infinite where it is never in the space."""
        import numpy as np

        turns = np.append(turns, self._crossings(edge, turns))
        gaps = self._gaps(edge, turns)
        place = int(gaps.argmin())
        return float(gaps[place]), float(turns[place])

    def _gaps(self, edge: float, turns: "Array") -> "Array":
        import numpy as np

        first, second = self.first, self.second
        x, y = first.tip * np.cos(edge + turns), first.tip * np.sin(edge + turns)
        if first.internal:
            x = x - self.distance
        elif second.internal:
            x = x + self.distance
        else:
            x, y = self.distance - x, -y
        away = np.hypot(x, y)
        near = away > second.tip if second.internal else away < second.tip
        # of the equivalent angles, the one in which the space has turned with the tooth
        lean = np.remainder(np.arctan2(y, x) - self.ratio * turns + pi, 2.0 * pi) - pi
        beside = away * (np.interp(away, self.radius, self.half) - np.abs(lean - self.play))
        beside *= np.interp(away, self.radius, self.across)
        below = second.form - away if not second.internal else away - second.form
        return np.where(near & (below <= EDGE * second.form), beside, np.inf)

    def _crossings(self, edge: float, turns: "Array") -> "list[float]":
        """The angles among those given at which the edge crosses the form circle."""
        side, tip, form = -1.0 if self.second.internal else 1.0, self.first.tip, self.second.form
        cosine = side * (tip * tip + self.distance**2 - form * form) / (2.0 * tip * self.distance)
        if abs(cosine) > 1.0:
            return []
        return [angle for angle in (acos(cosine) - edge, -acos(cosine) - edge) if turns[0] <= angle <= turns[-1]]


def wall(form: ToothForm, tolerance: float) -> "tuple[Array, Array, Array]":
    """The side of a tooth space: rising radii, half angles of the space, and the share of arcs that lies across."""
    import numpy as np

    chain = flank(form, tolerance)
    radius, half = chain.radius, pi / form.teeth - chain.angle
    if form.internal:
        radius, half = radius[::-1], half[::-1]
    if form.internal and form.fillet > 0.0:
        more_radius, more_half = _fillet_points(form)
        radius, half = np.concatenate([radius, more_radius[1:]]), np.concatenate([half, more_half[1:]])
    slope = radius * np.gradient(half, radius)
    return radius, half, 1.0 / np.sqrt(1.0 + slope * slope)


def _fillet_points(form: ToothForm) -> "tuple[Array, Array]":
    """The fillet of an internal gear from the involute to the root circle, as radii and half angles of the space."""
    import numpy as np

    centre, angle = fillet_centre(form)
    reach = sqrt((centre - form.base) * (centre + form.base))
    half = pi / form.teeth - angle
    # from the normal of the involute, which leans by the pressure angle of the centre, to the radius
    directions = np.linspace(0.5 * pi - np.arctan(reach / form.base), 0.0, 33)
    x = centre + form.fillet * np.cos(directions)
    y = form.fillet * np.sin(directions)
    return np.hypot(x, y), half + np.arctan2(y, x)


def _reach(first: ToothForm, second: ToothForm, distance: float) -> float:
    """Angular range about the line of centres in which a tip of `first` is within the teeth of `second`."""
    if first.internal:
        cosine = (first.tip**2 + distance**2 - second.tip**2) / (2.0 * first.tip * distance)
    elif second.internal:
        cosine = (second.tip**2 - first.tip**2 - distance**2) / (2.0 * first.tip * distance)
    else:
        cosine = (first.tip**2 + distance**2 - second.tip**2) / (2.0 * first.tip * distance)
    # a little more, so that the tooth's width is included at both ends
    return min(pi, (0.0 if cosine >= 1.0 else acos(max(cosine, -1.0))) + 2.0 * pi / first.teeth)
