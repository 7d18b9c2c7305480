"""Uncertainty by libraries of others: uncertainties and GTC to first order, mcerp by Latin hypercubes.

Each takes the distributions, their correlations by place, and a formula, and gives low, high, median, mean and
deviation. First-order libraries know a mean and a deviation only: their interval is that of a normal distribution.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.accuracy.alternatives.uncertainty.models import Formula
    from dynamics_cli.core.inputs.uncertain.distributions import Distribution

    Correlation = Sequence[tuple[int, int, float]]
    Found = tuple[float, float, float, float, float]

SCORE = 1.959963984540054
SEED = 20240917


def _straight(mean: float, std: float) -> "Found":
    """What a mean and a deviation say of a normal distribution."""
    return mean - SCORE * std, mean + SCORE * std, mean, mean, std


def _imported(name: str) -> "Any":
    """A library that may not be there, and has no types."""
    from importlib import import_module

    return import_module(name)


def by_uncertainties(inputs: "Sequence[Distribution]", correlation: "Correlation", formula: "Formula") -> "Found":
    """First order, by `uncertainties`."""
    library, umath = _imported("uncertainties"), _imported("uncertainties.umath")
    if correlation:
        matrix = _matrix(len(inputs), correlation)
        numbers = library.correlated_values_norm([(one.mean, one.std) for one in inputs], matrix)
    else:
        numbers = [library.ufloat(one.mean, one.std) for one in inputs]
    made = formula(numbers, umath)
    return _straight(float(made.nominal_value), float(made.std_dev))


def by_gtc(inputs: "Sequence[Distribution]", correlation: "Correlation", formula: "Formula") -> "Found":
    """First order, by `GTC`."""
    GTC = _imported("GTC")
    numbers = [GTC.ureal(one.mean, one.std, independent=not correlation) for one in inputs]
    for i, j, rho in correlation:
        GTC.set_correlation(rho, numbers[i], numbers[j])

    class Functions:
        sqrt, exp, log, sin, tan, atan = GTC.sqrt, GTC.exp, GTC.log, GTC.sin, GTC.tan, GTC.atan
        fabs = GTC.magnitude

    made = formula(numbers, Functions)
    return _straight(float(GTC.value(made)), float(GTC.uncertainty(made)))


def by_mcerp(inputs: "Sequence[Distribution]", correlation: "Correlation", formula: "Formula") -> "Found":
    """A Latin hypercube of 10,000 points, by `mcerp`."""
    import numpy as np

    mcerp = _imported("mcerp")
    before = np.random.get_state()  # noqa: NPY002 -- mcerp draws from numpy's own state
    np.random.seed(SEED)  # noqa: NPY002
    try:
        numbers = [_of_mcerp(one) for one in inputs]
        if correlation:
            mcerp.correlate(numbers, _matrix(len(inputs), correlation))
        made = formula(numbers, mcerp.umath)
    finally:
        np.random.set_state(before)  # noqa: NPY002
    points = np.asarray(made._mcpts)
    low, median, high = np.quantile(points, (0.025, 0.5, 0.975))
    return float(low), float(high), float(median), float(points.mean()), float(points.std())


def _of_mcerp(one: "Distribution") -> "Any":
    mcerp, stats = _imported("mcerp"), _imported("scipy.stats")
    given: dict[str, Any] = one.parameters()
    if one.name == "normal":
        return mcerp.N(given["mean"], given["std"])
    if one.name == "uniform":
        return mcerp.U(given["low"], given["high"])
    if one.name == "triangular":
        return mcerp.Tri(given["low"], given["mode"], given["high"])
    if one.name == "lognormal":
        import math

        width = math.sqrt(math.log1p((given["std"] / given["mean"]) ** 2))
        # its own LogN takes the median where the mean of the logarithm is meant
        return mcerp.uv(stats.lognorm(width, scale=given["mean"] * math.exp(-0.5 * width * width)))
    if one.name == "truncated":
        ends = [(given[key] - given["centre"]) / given["width"] for key in ("low", "high")]
        return mcerp.uv(stats.truncnorm(*ends, given["centre"], given["width"]))
    if one.name == "readings":
        return mcerp.uv(stats.t(len(given["readings"]) - 1, one.mean, one.scale))  # type: ignore[attr-defined]
    raise ValueError(one.name)


def _matrix(count: int, correlation: "Correlation") -> "Any":
    import numpy as np

    made = np.eye(count)
    for i, j, rho in correlation:
        made[i, j] = made[j, i] = rho
    return made
