"""The picture of an uncertain result's distribution."""

import math

import numpy as np

from dynamics_cli.core.uncertainty.pictures import _density
from dynamics_cli.core.uncertainty.propagation import Spread, across_range
from dynamics_cli.pictures import Axis, Curve
from dynamics_cli.quantities import Length

# Three deviations of a kernel estimate, sqrt(f R(K)/(n h)) with R(K) = 0.28, n = 4096, h = 0.17, of the greatest f.
SCATTER = 0.1


def density(cases: int) -> tuple[list[float], list[float]]:
    sample = np.sort(np.random.default_rng(3).standard_normal(4096))
    spread = Spread("length", "sample", [-1.96, 0.0, 1.96], 0.0, 1.0)
    values = across_range(spread.interval)
    spread.cumulative = (values.tolist(), (np.searchsorted(sample, values) / sample.size).tolist())
    spread.cases = cases
    panel = _density(spread, Axis("length", Length), 0.95, [])
    curve = next(item for item in panel.items if isinstance(item, Curve) and item.label == "density")
    return list(curve.x), list(curve.y)


def test_counted_cases_give_a_smooth_density() -> None:
    x, y = density(4096)
    assert max(abs(b - math.exp(-0.5 * a * a)) for a, b in zip(x, y, strict=True)) < SCATTER
    turns = np.count_nonzero(np.diff(np.sign(np.diff(y)[np.abs(np.diff(y)) > 1e-9])))
    assert turns <= 3


def test_an_integrated_density_is_drawn_as_it_is() -> None:
    _, y = density(0)
    assert max(y) == 1.0
    assert np.count_nonzero(np.diff(np.sign(np.diff(y)))) > 20
