"""The motion at the separation over the spread of a sample: solved for on a grid, and splines between its points.

Of an uncertain car (its brakes, its axles) the grid is solved for its middle, and once more to either side along each
principal axis of what varies: between them the motions are parabolas.

Coordinates are those of the sample itself: along its principal axes, in its own deviations. The grid is solved from its
middle outwards, hundreds of points side by side, each from the solution and the derivatives of the nearest point
before. Slides at further places of the sample say what the splines are off by.
"""

import numpy as np

from dynamics_cli.impact.slide.back import Target, followed, newton, roots, sloped
from dynamics_cli.impact.slide.lanes import Lanes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.impact.slide.wheels import Car

    Array = NDArray[Any]

# Distance of the points of the grid and where it ends, in deviations of the sample; and its rings, from within.
SPACING, RINGS = 0.7, (1.2, 2.2, 3.3, 4.4)
# An axis that varies less than this, of a metre, does not.
STILL = 1e-9
# What a point may be off by, in deviations.
CLOSE = 5e-4
# A point that ends this far off, in deviations, has no slide.
UNREACHED = 0.05
FINE = 1e-5
# Members of the sample at which the splines are tried.
TRIALS = 128
# How far to either side other cars are solved for, in deviations.
ASIDE = 1.7
GYRATION = 3


class Grid:
    """Velocity ahead and to the left and spin of one car, by where it came to rest from its separation.

    Places have a third part, the turn times `scale`; `near` is the grid of a car that is nearly the same.
    """

    def __init__(self, car: "Car", scale: float, middle: "Array", axes: "Array", near: "Grid | None" = None) -> None:
        from scipy.ndimage import spline_filter

        self.lanes, self.middle, self.axes = Lanes(car), middle, axes
        self.scaled: Array = np.array([[1.0], [1.0], [car.gyration / scale]])
        self.inverse: Array = np.linalg.pinv(axes)
        self.width = int(np.ceil(RINGS[-1] / SPACING))
        count, shape = axes.shape[1], (2 * self.width + 1,) * axes.shape[1]
        grid = SPACING * (np.indices(shape).reshape(count, -1) - self.width)
        size: Array = np.sqrt((grid * grid).sum(axis=0))
        self.found, self.slopes = np.zeros((3, size.size)), np.zeros((size.size, 3, 3))
        if near is None:
            solved = self._outwards(car, scale, grid, size)
        else:
            self.found = near.found.copy()
            solved = self._settle(grid, size <= RINGS[-1])
        self._from(grid, solved, ~solved)
        self.reached = solved.reshape(shape) | (size > RINGS[-1]).reshape(shape)
        parts = (*self.found[:2], self.found[2] / car.gyration)
        self.splines = [spline_filter(part.reshape(shape)) for part in parts]

    def _outwards(self, car: "Car", scale: float, grid: "Array", size: "Array") -> "Array":
        """Solve from the middle ring by ring; which points have a solution."""
        ahead, left, turn = self.middle.tolist()
        start = roots(car, Target((0.0, 0.0), 0.0, (ahead, left), turn / scale))[0].unknowns
        solved: Array = size == 0.0
        self.found[:, solved] = np.array(start)[:, None]
        self.slopes[solved] = sloped(self.lanes, self._target(grid[:, solved]), self.found[:, solved], FINE)[1]
        for ring in RINGS:
            new = (size <= ring) & ~solved
            self._from(grid, solved, new)
            solved = solved | self._settle(grid, new)
        return solved

    def _settle(self, grid: "Array", chosen: "Array") -> "Array":
        """Solve points from where they are; those that end there."""
        self.found[:, chosen], _, self.slopes[chosen], off = followed(
            self.lanes, self._target(grid[:, chosen]), self.found[:, chosen], self._off, CLOSE, FINE
        )
        reached: Array = chosen.copy()
        reached[chosen] = off < UNREACHED
        return reached

    def _from(self, grid: "Array", solved: "Array", new: "Array") -> None:
        """Starts at new points, by the derivatives of the nearest solved one."""
        from scipy.spatial import cKDTree

        known = np.flatnonzero(solved)
        _, nearest = cKDTree(grid[:, known].T).query(grid[:, new].T)
        nearest = known[nearest]
        apart = self.scaled * (self.axes @ (grid[:, new] - grid[:, nearest]))
        self.slopes[new] = self.slopes[nearest]
        steps = np.linalg.solve(self.slopes[nearest], apart.T[:, :, None])[:, :, 0].T
        self.found[:, new] = self.found[:, nearest] + steps

    def _target(self, z: "Array") -> "Array":
        wanted: Array = self.scaled * (self.middle[:, None] + self.axes @ z)
        return wanted

    def _off(self, gaps: "Array") -> "Array":
        """Gaps in deviations of the sample; of what does not vary, in the last place that counts."""
        off: Array = np.abs(self.inverse @ gaps).max(axis=0, initial=0.0)
        return np.where(np.isfinite(off), off, 1e9)

    def at(self, places: "Array") -> "tuple[Array, Array]":
        """The motions (3, n) at places, and whether they are reached at all."""
        from scipy.ndimage import map_coordinates

        z = self.inverse @ (places - self.middle[:, None]) / SPACING + self.width
        made = [map_coordinates(spline, z, mode="nearest", prefilter=False) for spline in self.splines]
        nearest = np.rint(z).clip(0, 2 * self.width).astype(int)
        return np.array(made), self.reached[tuple(nearest)]


class Spread:
    """The motions at the separation of a sample: of its `bodies` (9, n) and where they came to rest.

    `missed` is what they are off by, in their deviations.
    """

    def __init__(self, car_of: "Callable[[tuple[float, ...]], Car]", bodies: "Array", places: "Array") -> None:
        self.car_of = car_of
        self.body = bodies.mean(axis=1)
        self.scale = float(self.body[GYRATION])
        middle = places.mean(axis=1)
        axes = _principal(places)
        self.grid = Grid(car_of(tuple(self.body)), self.scale, middle, axes)
        ways = _principal(bodies)
        self.inverse: Array = np.linalg.pinv(ways)
        self.aside = []
        for way, z in zip(ways.T, self.inverse @ (bodies - self.body[:, None]), strict=True):
            # within what the sample has: brakes are used between nothing and wholly
            ends = max(-ASIDE, float(z.min())), min(ASIDE, float(z.max()))
            cars = [car_of(tuple(self.body + end * way)) for end in ends]
            self.aside.append((ends, [Grid(one, self.scale, middle, axes, self.grid) for one in cars]))
        self.missed = self._tried(bodies[:, :TRIALS], places[:, :TRIALS])

    def at(self, bodies: "Array", places: "Array") -> "tuple[Array, Array]":
        """Velocities ahead and to the left and spins (3, n), and whether there are such."""
        middle, reached = self.grid.at(places)
        made = middle.copy()
        apart = self.inverse @ (bodies - self.body[:, None])
        for z, (ends, grids) in zip(apart, self.aside, strict=True):
            for end, other, grid in zip(ends, reversed(ends), grids, strict=True):
                motions, there = grid.at(places)
                made += z * (z - other) / (end * (end - other)) * (motions - middle)
                reached = reached & there
        return made, reached

    def _tried(self, bodies: "Array", places: "Array") -> float:
        """The error of the splines at members of the sample, root mean square in deviations."""
        motions, reached = self.at(bodies, places)
        bodies, motions, places = bodies[:, reached], motions[:, reached], places[:, reached].copy()
        if not reached.sum() > 1:
            return 1.0
        lanes = self.grid.lanes
        if self.aside:
            lanes = Lanes.joined([Lanes(self.car_of(tuple(body))) for body in bodies.T])
        for part in (motions, places):
            part[2] *= lanes.gyration / (1.0 if part is motions else self.scale)
        gaps, slopes = sloped(lanes, places, motions, FINE)
        whole = np.isfinite(gaps).all(axis=0)
        steps = newton(slopes[whole], gaps[:, whole])[0]
        return float((np.sqrt((steps * steps).mean(axis=1)) / motions.std(axis=1)).max()) if whole.any() else 1.0


def _principal(sample: "Array") -> "Array":
    """The axes along which a sample varies, a column each, as long as its deviation."""
    sizes, axes = np.linalg.eigh(np.cov(sample))
    kept = sizes > STILL * STILL
    chosen: Array = axes[:, kept] * np.sqrt(sizes[kept])
    return chosen
