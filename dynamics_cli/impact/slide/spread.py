"""The motion at the separation over the spread of a sample: solved for on a grid, and splines between its points.

Coordinates are those of the sample itself: along its principal axes, in its own deviations. The grid is solved from its
middle outwards, hundreds of points side by side, each from the solution and the derivatives of the nearest point
before. Slides at further places of the sample say what the splines are off by.
"""

import numpy as np

from dynamics_cli.impact.slide.back import Target, followed, newton, roots, sloped
from dynamics_cli.impact.slide.lanes import Lanes

TYPE_CHECKING = False
if TYPE_CHECKING:
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
# Places of the sample at which the splines are tried.
TRIALS = 128


class Spread:
    """Velocity ahead and to the left and gyration times spin, by where the car came to rest from its separation.

    `missed` is what they are off by, in their deviations.
    """

    def __init__(self, car: "Car", places: "Array") -> None:
        self.lanes = Lanes(car)
        self.middle = places.mean(axis=1)
        sizes, axes = np.linalg.eigh(np.cov(places))
        kept = sizes > STILL * STILL
        self.axes = axes[:, kept] * np.sqrt(sizes[kept])
        self.inverse = (axes[:, kept] / np.sqrt(sizes[kept])).T
        self._solve(car)
        self.missed = self._tried()

    def _solve(self, car: "Car") -> None:
        from scipy.ndimage import spline_filter

        width = int(np.ceil(RINGS[-1] / SPACING))
        count, shape = self.axes.shape[1], (2 * width + 1,) * self.axes.shape[1]
        grid = SPACING * (np.indices(shape).reshape(count, -1) - width)
        size = np.sqrt((grid * grid).sum(axis=0))
        ahead, left, turn = self.middle.tolist()
        turn /= car.gyration
        start = roots(car, Target((0.0, 0.0), 0.0, (ahead, left), turn))[0].unknowns
        found, slopes = np.zeros((3, size.size)), np.zeros((size.size, 3, 3))
        first = size == 0.0
        found[:, first] = np.array(start)[:, None]
        slopes[first] = sloped(self.lanes, self._target(grid[:, first]), found[:, first], FINE)[1]
        solved = first
        for ring in RINGS:
            near = (size <= ring) & ~solved
            self._from(grid, found, slopes, solved, near)
            found[:, near], _, slopes[near], off = followed(
                self.lanes, self._target(grid[:, near]), found[:, near], self._off, CLOSE, FINE
            )
            solved = solved | near
            solved[near] = off < UNREACHED
        self._from(grid, found, slopes, solved, ~solved)
        self.width = width
        self.reached = solved.reshape(shape) | (size > RINGS[-1]).reshape(shape)
        self.splines = [spline_filter(part.reshape(shape)) for part in found]

    def _from(self, grid: "Array", found: "Array", slopes: "Array", solved: "Array", new: "Array") -> None:
        """Starts at new points, by the derivatives of the nearest solved one."""
        from scipy.spatial import cKDTree

        known = np.flatnonzero(solved)
        _, nearest = cKDTree(grid[:, known].T).query(grid[:, new].T)
        nearest = known[nearest]
        apart = self.axes @ (grid[:, new] - grid[:, nearest])
        slopes[new] = slopes[nearest]
        found[:, new] = found[:, nearest] + np.linalg.solve(slopes[nearest], apart.T[:, :, None])[:, :, 0].T

    def _target(self, z: "Array") -> "Array":
        wanted: Array = self.middle[:, None] + self.axes @ z
        return wanted

    def _off(self, gaps: "Array") -> "Array":
        """Gaps in deviations of the sample; of what does not vary, in the last place that counts."""
        off: Array = np.abs(self.inverse @ gaps).max(axis=0, initial=0.0)
        return np.where(np.isfinite(off), off, 1e9)

    def at(self, places: "Array") -> "tuple[Array, Array]":
        """The unknowns (3, n) at places, and whether they are reached at all."""
        from scipy.ndimage import map_coordinates

        z = self.inverse @ (places - self.middle[:, None]) / SPACING + self.width
        made = [map_coordinates(spline, z, mode="nearest", prefilter=False) for spline in self.splines]
        nearest = np.rint(z).clip(0, 2 * self.width).astype(int)
        return np.array(made), self.reached[tuple(nearest)]

    def _tried(self) -> float:
        """The error of the splines at places of the sample, root mean square in deviations."""
        from dynamics_cli.numerics.distributions.normal_arrays import quantile
        from dynamics_cli.numerics.quadrature.lattice import lattice

        z = quantile(lattice(len(self.inverse), TRIALS, 1, 2))
        places = self._target(z)
        motions, reached = self.at(places)
        gaps, slopes = sloped(self.lanes, places, motions, FINE)
        reached = reached & np.isfinite(gaps).all(axis=0)
        steps = newton(slopes[reached], gaps[:, reached])[0]
        if not reached.sum() > 1:
            return 1.0
        std = motions[:, reached].std(axis=1)
        return float((np.sqrt((steps * steps).mean(axis=1)) / std).max())
