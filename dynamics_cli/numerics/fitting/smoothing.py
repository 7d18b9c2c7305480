"""Smoothing splines of degree 5 through measured points: the smallest mean square of the third derivative.

The minimum of Σ(y − f)² + λ∫f‴² among quintic splines, with λ by generalised cross-validation or, for a known noise, by
the unbiased estimate of the risk (Mallows). In the basis in which both sums are diagonal, every λ costs one division
for each function, and the noise of the values and derivatives follows from the same numbers.
Craven & Wahba, Smoothing noisy data with spline functions, Numer. Math. 31 (1979); Eilers & Marx, Flexible smoothing
with B-splines and penalties, Statist. Sci. 11 (1996).
"""

import math

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

DEGREE = 5
# More knots than this are thinned: the cost of the decomposition grows with their cube.
MOST_KNOTS = 300
FEWEST_POINTS = 8
DECADES, PER_DECADE = 24.0, 8
# Freedom counts this much in the cross-validation, which now and then follows the noise otherwise (Wood, Generalized
# Additive Models, 2nd ed., CRC Press 2017, section 6.2).
CAUTION = 1.4


class Smooth:
    """A smoothing spline of several coordinates: values and derivatives, and their standard deviations."""

    def __init__(self, times: "Any", values: "Any", sigma: float | None) -> None:
        from scipy.interpolate import BSpline

        count = len(times)
        self.start, self.span = float(times[0]), float(times[-1] - times[0])
        t = (times - times[0]) / self.span
        inside = t[3:-3]
        if len(inside) > MOST_KNOTS:
            inside = inside[np.linspace(0, len(inside) - 1, MOST_KNOTS).astype(int)]
        self.knots = np.concatenate([np.zeros(DEGREE + 1), inside, np.ones(DEGREE + 1)])
        self.thinned = len(inside) < count - 6
        self._spline = BSpline
        self._basis, penalties = self._decomposed(t)
        fits = self.basis(times, 0)
        middle = values.mean(axis=0)
        parts = fits.T @ (values - middle)
        rest = ((values - middle - fits @ parts) ** 2).sum()
        self._middle = middle
        self.sigma_given = sigma
        shrink = self._chosen(penalties, parts, float(rest), count, sigma)
        self._shrink = shrink
        self._parts = parts * shrink[:, None]
        self.freedom = float(shrink.sum())
        self.residual = float(rest + (((1.0 - shrink[:, None]) * parts) ** 2).sum())
        self.sigma = sigma or math.sqrt(self.residual / (values.shape[1] * max(count - self.freedom, 1e-9)))
        self.measured_sigma = math.sqrt(self.residual / (values.shape[1] * max(count - self.freedom, 1e-9)))

    def _decomposed(self, t: "Any") -> "tuple[Any, Any]":
        """Coefficients of the functions in which both sums are diagonal, and their penalties.

        By singular values: of the smoothest functions, whose penalties decide what is smooth, the eigenvalues of the
        products of these matrices keep three digits only.
        """
        from scipy.linalg import qr, solve_triangular, svd

        count = len(self.knots) - DEGREE - 1
        design = self._spline.design_matrix(t, self.knots, DEGREE).toarray()
        edges = np.unique(self.knots)
        nodes, weights = np.polynomial.legendre.leggauss(3)
        middle, half = 0.5 * (edges[1:] + edges[:-1]), 0.5 * np.diff(edges)
        places = (middle[:, None] + half[:, None] * nodes).ravel()
        third = self._spline(self.knots, np.eye(count), DEGREE).derivative(3)(places)
        weighted = third * np.sqrt((half[:, None] * weights).ravel())[:, None]
        triangle = qr(design, mode="r")[0][:count]
        roughness = solve_triangular(triangle, weighted.T, trans="T").T
        _, values, functions = svd(qr(roughness, mode="r")[0][:count])
        # quadratics are not penalised
        values[-3:] = 0.0
        return solve_triangular(triangle, functions.T), (values / values[0]) ** 2

    def _chosen(self, penalties: "Any", parts: "Any", rest: float, count: int, sigma: float | None) -> "Any":
        """The weight of each function, from the criterion's minimum over λ."""
        squares = (parts**2).sum(axis=1)
        width = parts.shape[1]
        scale = float(np.median(penalties[:-3]))

        def criterion(power: float) -> float:
            shrink: Any = 1.0 / (1.0 + 10.0**power / scale * penalties)
            residual = rest + float(((1.0 - shrink) ** 2 * squares).sum())
            if sigma is not None:
                return residual + 2.0 * float(width) * sigma * sigma * float(shrink.sum())
            freedom = count - CAUTION * float(shrink.sum())
            return residual / (freedom * freedom) if freedom > 0.0 else math.inf

        def falls(power: float) -> bool:
            """Whether the criterion falls there: its slope shows a flat minimum to more digits than its values."""
            shrink: Any = 1.0 / (1.0 + 10.0**power / scale * penalties)
            rise = float(((1.0 - shrink) ** 2 * shrink * squares).sum())
            loss = float((shrink * (1.0 - shrink)).sum())
            if sigma is not None:
                return rise < float(width) * sigma * sigma * loss
            residual = rest + float(((1.0 - shrink) ** 2 * squares).sum())
            return rise * (count - CAUTION * float(shrink.sum())) < CAUTION * residual * loss

        powers = np.linspace(-0.5 * DECADES, 0.5 * DECADES, int(DECADES * PER_DECADE) + 1)
        values = [criterion(power) for power in powers]
        best = int(np.argmin(values))
        low, high = powers[max(best - 1, 0)], powers[min(best + 1, len(powers) - 1)]
        for _ in range(48):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if falls(middle) else (low, middle)
        self.power = 0.5 * (low + high)
        return 1.0 / (1.0 + 10.0**self.power / scale * penalties)

    def basis(self, times: "Any", order: int) -> "Any":
        """The functions, or their derivatives of that order by time, at some times: a row for each time."""
        t = np.clip((np.asarray(times) - self.start) / self.span, 0.0, 1.0)
        count = len(self.knots) - DEGREE - 1
        spline = self._spline(self.knots, np.eye(count), DEGREE)
        values = spline(t) if order == 0 else spline.derivative(order)(t)
        return (values @ self._basis) / self.span**order

    def curve(self, order: int) -> "Callable[[float], Any]":
        """The smooth function, or its derivative of that order, of a single time: faster than `at`, without noise."""
        spline = self._spline(self.knots, self._basis @ self._parts, DEGREE).derivative(order)
        middle = self._middle if order == 0 else 0.0

        def value(time: float) -> "Any":
            return spline(min(max((time - self.start) / self.span, 0.0), 1.0)) / self.span**order + middle

        return value

    def at(self, times: "Any", order: int) -> "tuple[Any, Any]":
        """Values or derivatives at some times, a row for each, and the standard deviation of every coordinate there.

        The deviation includes the part that smoothing removes (Wahba, Bayesian confidence intervals for the
        cross-validated smoothing spline, J. R. Statist. Soc. B 45 (1983)).
        """
        basis = self.basis(times, order)
        values = basis @ self._parts
        deviation = self.sigma * np.sqrt((basis**2 * self._shrink).sum(axis=1))
        return values + (self._middle if order == 0 else 0.0), deviation
