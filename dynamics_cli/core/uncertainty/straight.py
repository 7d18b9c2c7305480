"""Results that are another result times a number plus a number: velocities after an impact, and its impulse.

One distribution serves them all. Whether they are is looked at on so many cases that a branch taken now and then shows.
"""

import numpy as np

from dynamics_cli.core.uncertainty.space import Space
from dynamics_cli.numerics.distributions.normal_arrays import quantile
from dynamics_cli.numerics.quadrature.lattice import MOST_DIMENSIONS, lattice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

CASES = 8192
# Of so few results it saves nothing.
FEW_RESULTS = 4
# How far from a straight line, in deviations, rounding may leave a result.
ROUNDING = 1e-9


class Straight:
    """Which results are others times a number, plus a number."""

    def __init__(self, space: Space, probe: "Array", seed: int) -> None:
        self._names = space.results
        self._probe = probe
        self._sample = probe
        many = len(space.results) > FEW_RESULTS
        if many and not space.slow and 0 < space.size <= MOST_DIMENSIONS:
            drawn = space.evaluate(quantile(lattice(space.size, CASES, 1, seed)))
            self._sample = np.concatenate([probe, drawn], axis=1)
        self._exact = space.slow or space.heavy or not many
        sound = ~np.isnan(self._sample)
        count, whole = np.maximum(sound.sum(axis=1), 1), np.where(sound, self._sample, 0.0)
        with np.errstate(all="ignore"):
            self._mean = whole.sum(axis=1) / count
            apart = np.where(sound, self._sample - self._mean[:, None], 0.0)
            self._std = np.sqrt((apart * apart).sum(axis=1) / count)
            scores = (self._sample - self._mean[:, None]) / self._std[:, None]
        # The same sense for all: the farthest case is above the mean.
        whole = np.nan_to_num(scores)
        place = np.abs(whole[0]).argmax() if len(whole) else 0
        self._sense = np.where(whole[:, place] < 0.0, -1.0, 1.0)
        self._scores = scores * self._sense[:, None]

    def of(self, row: int) -> "tuple[str, float, float]":
        """The first result that another one is on a straight line with (or no name), the scale and the shift."""
        for other in range(row):
            if np.array_equal(self._sample[other], self._sample[row], equal_nan=True):
                return self._names[other], 1.0, 0.0
            if self._exact or not self._std[other] > 0.0 or not self._std[row] > 0.0:
                continue
            apart = np.abs(self._scores[other] - self._scores[row])
            missing = np.isnan(apart)
            if missing.any() and not np.array_equal(np.isnan(self._sample[other]), np.isnan(self._sample[row])):
                continue
            if np.max(apart, where=~missing, initial=0.0) <= ROUNDING:
                scale = float(self._sense[other] * self._sense[row] * self._std[row] / self._std[other])
                return self._names[other], scale, float(self._mean[row] - scale * self._mean[other])
        return "", 1.0, 0.0
