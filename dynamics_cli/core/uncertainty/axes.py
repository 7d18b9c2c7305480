"""Uncertain inputs in coordinates of their own, in which each is smooth between cuts; Gauss points on them."""

import numpy as np

from dynamics_cli.core.inputs.uncertain.distributions import StudentT, Tangent, Triangular, Truncated, Uniform
from dynamics_cli.numerics.distributions import normal_arrays
from dynamics_cli.numerics.quadrature.gauss import legendre
from dynamics_cli.numerics.quadrature.hermite import gauss_hermite

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.inputs.uncertain.distributions import Distribution

    Array = NDArray[Any]

# Scores beyond this have 2e-9 of the probability; for a Student t of five degrees of freedom, 4e-6 of the variance.
REACH = 6.0
SCORES = (-REACH, -2.2, 0.0, 2.2, REACH)
# Points of a panel, and of a Gauss–Hermite rule over an uncut axis of scores, at two levels.
COARSE, FINE = 5, 8
HERMITE = {COARSE: 9, FINE: 15}
TABLE = 4001
_gauss: "dict[int, tuple[Array, Array]]" = {}


class Axis:
    """One input in its own coordinate: the cuts, the input's value, density and distribution function."""

    def __init__(self, distribution: "Distribution") -> None:
        self._image = distribution.of if isinstance(distribution, Tangent) else None
        # For a tangent the axis is that of the angle.
        distribution = distribution.angle if isinstance(distribution, Tangent) else distribution
        self.distribution = distribution
        self.bounded = isinstance(distribution, Uniform | Triangular | Truncated)
        self.corners: tuple[float, ...] = ()
        self._table: tuple[Array, Array] | None = None
        if not self.bounded:
            self.cuts = np.array(SCORES)
            if isinstance(distribution, StudentT):
                # Its quantiles are slow; linear interpolation between this many is good to 1e-6 of a deviation.
                scores = np.linspace(-REACH, REACH, TABLE)
                self._table = scores, distribution.at(scores)
            return
        d: Any = distribution
        inner = [0.5 * (d.low + d.high)]
        if isinstance(d, Triangular):
            inner = [d.mode]
        elif isinstance(d, Truncated):
            steps = (1.5 * d.width, 3.5 * d.width)
            inner = [d.centre, *(d.low + step for step in steps), *(d.high - step for step in steps)]
        kept = sorted({float(cut) for cut in inner if d.low < cut < d.high})
        self.cuts = np.array([d.low, *kept, d.high])
        self.corners = (d.low, *(kept if isinstance(d, Triangular) else ()), d.high)

    def value(self, t: "Array") -> "Array":
        """The input."""
        if self._table is not None:
            t = np.interp(t, *self._table)
        elif not self.bounded:
            t = self.distribution.at(t)
        return t if self._image is None else self._image(t)

    def density(self, t: "Array") -> "Array":
        """Probability per coordinate."""
        d: Any = self.distribution
        if isinstance(d, Uniform):
            return np.full_like(t, 1.0 / (d.high - d.low))
        if isinstance(d, Triangular):
            width = d.high - d.low
            below, above = max(d.mode - d.low, 1e-300), max(d.high - d.mode, 1e-300)
            return 2.0 / width * np.where(t < d.mode, (t - d.low) / below, (d.high - t) / above)
        if isinstance(d, Truncated):
            score = (t - d.centre) / d.width
            return np.exp(-0.5 * score * score) / (np.sqrt(2.0 * np.pi) * d.width * self._mass())  # type: ignore[no-any-return]
        return np.exp(-0.5 * t * t) / np.sqrt(2.0 * np.pi)  # type: ignore[no-any-return]

    def below(self, t: "Array") -> "Array":
        """The distribution function."""
        d: Any = self.distribution
        if isinstance(d, Uniform):
            return (t - d.low) / (d.high - d.low)
        if isinstance(d, Triangular):
            width = d.high - d.low
            low, high = np.maximum(t - d.low, 0.0), np.maximum(d.high - t, 0.0)
            rising = low * low / (width * max(d.mode - d.low, 1e-300))
            return np.where(t < d.mode, rising, 1.0 - high * high / (width * max(d.high - d.mode, 1e-300)))
        if isinstance(d, Truncated):
            first = normal_arrays.lower((np.array([d.low]) - d.centre) / d.width)[0]
            return (normal_arrays.lower((t - d.centre) / d.width) - first) / self._mass()  # type: ignore[no-any-return]
        return normal_arrays.lower(t)

    def _mass(self) -> float:
        d: Any = self.distribution
        ends = normal_arrays.lower((np.array([d.low, d.high]) - d.centre) / d.width)
        return float(ends[1] - ends[0])


def points(axis: Axis, roots: "Array", count: int) -> "tuple[Array, Array, Array]":
    """Points of an axis for every row, cut at the row's own roots: row, coordinate, probability."""
    if roots.shape[1] or axis.bounded:
        row, t, width = _panels(axis.cuts, roots, count)
        return row, t, width * axis.density(t)
    t, weight = gauss_hermite(HERMITE[count])
    rows = roots.shape[0]
    return np.repeat(np.arange(rows), t.size), np.tile(t, rows), np.tile(weight, rows)


def _panels(cuts: "Array", roots: "Array", count: int) -> "tuple[Array, Array, Array]":
    """Gauss points between the cuts of every row (the common ones and the row's own): row, point, width."""
    own = np.concatenate([np.tile(cuts, (roots.shape[0], 1)), roots], axis=1)
    own.sort(axis=1)
    start, width = own[:, :-1], np.diff(own, axis=1)
    row, place = np.nonzero(width > 1e-13 * (cuts[-1] - cuts[0]))
    nodes, weights = _rule(count)
    wide = width[row, place][:, None]
    points = start[row, place][:, None] + wide * nodes
    return np.repeat(row, count), points.ravel(), (wide * weights).ravel()


def _rule(count: int) -> "tuple[Array, Array]":
    """Gauss–Legendre nodes and weights between 0 and 1."""
    if count not in _gauss:
        nodes, weights = zip(*legendre(count), strict=True)
        _gauss[count] = np.array(nodes), np.array(weights)
    return _gauss[count]
