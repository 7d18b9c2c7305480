"""Clearance between a tooth and the flanks of the space it turns through, off the line of action.

A tooth is sampled point by point while it turns through the space, and also where each of its points crosses the form
circle, below which the space's flank is not an involute. Around the minimum distances, points and angles are sampled
again, finer each time.
"""

from math import acos, pi, sqrt

from dynamics_cli.gear.single.flanks import ToothForm, fillet_centre, flank

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# Chords of a tooth in the first pass, then of it and of the space, relative to the module.
COARSE, FINE = 2e-4, 1e-6
# Angles in the first pass, and in each finer one about the minima.
STEPS, FINER_STEPS, ROUNDS, PLACES = 241, 41, 4, 4
LAND, FINE_LAND = 9, 129
# A point on the form circle counts as below and above it, whichever way it rounds.
EDGE = 1e-12


def flank_gap(first: ToothForm, second: ToothForm, distance: float, play: float) -> float:
    """Minimum distance of a tooth of `first` from the flanks of the space of `second` it turns through.

    `play` is half the angle `second` can be turned by: the driving flanks touch. Along the involutes the distance is
    zero by design, to the chords; negative ones are overlaps (off the line of action: trimming). Infinite if
    nothing comes near.
    """
    import numpy as np

    turn = _Turn(first, second, distance, play)
    reach = _reach(first, second, distance)
    tooth, fine = _tooth_points(first, COARSE, LAND), _tooth_points(first, FINE, FINE_LAND)
    grid = np.linspace(-reach, reach, STEPS)
    gap, turned = turn.gaps(*tooth, grid)
    return _finest(turn, gap, turned, tooth, fine, float(grid[1] - grid[0]))


def _finest(
    turn: "_Turn", gap: "Array", turned: "Array", tooth: "tuple[Array, Array]",
    fine: "tuple[Array, Array]", step: float,
) -> float:  # fmt: skip
    """The minimum distance about the few angles with minima of the first pass."""
    least = float(gap.min())
    if least == float("inf"):
        return least
    for row, column in _places(gap):
        near = _beside(tooth, fine, column)
        angle, width = float(turned[row, column]), step
        for _ in range(ROUNDS):
            value, angle = turn.least(*near, angle, width)
            least = min(least, value)
            width *= 2.0 / (FINER_STEPS - 1)
    return least


def _places(gap: "Array") -> "list[tuple[int, int]]":
    """The angles (and points) of local minima of the distance, best first."""
    import numpy as np

    columns = gap.argmin(axis=1)
    values = gap[np.arange(len(gap)), columns]
    padded = np.concatenate(([np.inf], values, [np.inf]))
    rows = np.flatnonzero((values <= padded[:-2]) & (values <= padded[2:]) & np.isfinite(values))
    best = rows[np.argsort(values[rows], kind="stable")][:PLACES]
    return [(int(row), int(columns[row])) for row in best]


def _beside(tooth: "tuple[Array, Array]", fine: "tuple[Array, Array]", column: int) -> "tuple[Array, Array]":
    """The fine points of the tooth between the neighbours of one of its coarse points."""
    low, high = max(column - 1, 0), min(column + 2, len(tooth[0]))
    inside = True
    for coarse, points in zip(tooth, fine, strict=True):
        part = coarse[low:high]
        slack = 1e-9 * abs(part).max()
        inside = inside & (points >= part.min() - slack) & (points <= part.max() + slack)
    return fine[0][inside], fine[1][inside]


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

    def gaps(self, radius: "Array", angle: "Array", grid: "Array") -> "tuple[Array, Array]":
        """Distances (angles, points) from the flanks, and the angles.

        Infinite where a point is not in the space; two more angles of each point are those where it crosses the form
        circle.
        """
        import numpy as np

        first, second = self.first, self.second
        turned = np.concatenate(
            (np.broadcast_to(grid[:, None], (grid.size, radius.size)), self._crossings(radius, angle, grid))
        )
        x, y = radius * np.cos(angle + turned), radius * np.sin(angle + turned)
        if first.internal:
            x, y = x - self.distance, y
        elif second.internal:
            x = x + self.distance
        else:
            x, y = self.distance - x, -y
        away = np.hypot(x, y)
        near = away > second.tip if second.internal else away < second.tip
        # of the equivalent angles, the one in which the space has turned with the tooth
        lean = np.remainder(np.arctan2(y, x) - self.ratio * turned + pi, 2.0 * pi) - pi
        beside = away * (np.interp(away, self.radius, self.half) - np.abs(lean - self.play))
        beside *= np.interp(away, self.radius, self.across)
        below = second.form - away if not second.internal else away - second.form
        involute = radius <= first.form if first.internal else radius >= first.form
        return np.where(near & involute & (below <= EDGE * second.form), beside, np.inf), turned

    def _crossings(self, radius: "Array", angle: "Array", grid: "Array") -> "Array":
        """The two angles at which each point crosses the form circle; the first of the grid where it does not."""
        import numpy as np

        side = -1.0 if self.second.internal else 1.0
        cosine = side * (radius * radius + self.distance**2 - self.second.form**2) / (2.0 * radius * self.distance)
        polar = np.arccos(np.clip(cosine, -1.0, 1.0))
        angles = np.stack((polar, -polar)) - angle
        angles = np.remainder(angles + pi, 2.0 * pi) - pi
        crosses = (np.abs(cosine) <= 1.0) & (angles >= grid[0]) & (angles <= grid[-1])
        return np.where(crosses, angles, grid[0])

    def least(self, radius: "Array", angle: "Array", middle: float, width: float) -> tuple[float, float]:
        """The minimum distance within a width of an angle, and its angle."""
        import numpy as np

        gaps, turned = self.gaps(radius, angle, np.linspace(middle - width, middle + width, FINER_STEPS))
        place = np.unravel_index(int(gaps.argmin()), turned.shape)
        value = float(gaps[place])
        return value, float(turned[place]) if value < float("inf") else middle


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


def _tooth_points(form: ToothForm, chord: float, land_points: int) -> "tuple[Array, Array]":
    """Radii and angles of the points of a whole tooth, its tip land with them."""
    import numpy as np

    chain = flank(form, chord * form.module)
    land = np.linspace(-chain.angle[-1], chain.angle[-1], land_points)[1:-1]
    radius = np.concatenate([chain.radius, np.full(land.shape, form.tip), chain.radius[::-1]])
    return radius, np.concatenate([-chain.angle, land, chain.angle[::-1]])


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
