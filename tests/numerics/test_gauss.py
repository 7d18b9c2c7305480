"""Gauss–Legendre rules: numpy's nodes, and polynomials integrated exactly."""

import numpy as np
import pytest

from dynamics_cli.numerics.quadrature.gauss import legendre


@pytest.mark.parametrize("count", [2, 3, 5, 12, 28, 40])
def test_nodes_and_weights(count: int) -> None:
    nodes, weights = np.polynomial.legendre.leggauss(count)
    made = sorted(legendre(count))
    assert np.allclose([node for node, _ in made], 0.5 * (1.0 + nodes), rtol=0.0, atol=4e-16)
    assert np.allclose([weight for _, weight in made], 0.5 * weights, rtol=1e-12, atol=0.0)


@pytest.mark.parametrize("count", [2, 5, 28])
def test_polynomials_up_to_the_degree_are_exact(count: int) -> None:
    rule = legendre(count)
    for power in range(2 * count):
        assert sum(weight * node**power for node, weight in rule) == pytest.approx(1.0 / (power + 1), rel=1e-13)
    over = sum(weight * node ** (2 * count) for node, weight in rule)
    if count < 6:
        assert over != pytest.approx(1.0 / (2 * count + 1), rel=1e-9)
