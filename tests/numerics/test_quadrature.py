"""Hermite, Genz–Keister and Smolyak rules and lattices: exact where theory says so."""

import runpy
from math import factorial
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest

from dynamics_cli.numerics.quadrature import hermite, smolyak
from dynamics_cli.numerics.quadrature.lattice import lattice

REFERENCES = Path(__file__).parents[1] / "references"


def moment(power: int) -> float:
    return 0.0 if power % 2 else factorial(power) / (2 ** (power // 2) * factorial(power // 2))


@pytest.mark.parametrize("count", [1, 2, 3, 5, 8, 12, 18, 27, 40, 60])
def test_gauss_hermite_integrates_polynomials(count: int) -> None:
    nodes, weights = hermite.gauss_hermite(count)
    assert (weights > 0.0).all()
    for power in range(min(2 * count, 24)):
        scale = max(moment(power + power % 2), 1.0)
        assert abs(weights @ nodes**power - moment(power)) < 1e-13 * scale


def test_gauss_hermite_nodes_to_full_precision() -> None:
    nodes, weights = hermite.gauss_hermite(20)
    with mp.workdps(40):
        for node, weight in zip(nodes, weights, strict=True):
            exact = mp.findroot(lambda x: mp.hermite(20, x / mp.sqrt(2)), mp.mpf(float(node)))
            assert abs(float(exact) - node) <= 4e-16 * max(abs(node), 1.0)
            assert weight > 0.0


def test_the_embedded_rules_are_as_derived() -> None:
    made = runpy.run_path(str(REFERENCES / "generate_hermite_tables.py"))["rules"]()
    for nodes, weights in made:
        own_nodes, own_weights = hermite.genz_keister(len(nodes))
        assert [float(x) for x in nodes] == own_nodes.tolist()
        assert np.allclose(own_weights, [float(w) for w in weights], rtol=1e-15, atol=0.0)


@pytest.mark.parametrize(("dimensions", "level"), [(3, 1), (3, 4), (5, 3), (7, 2), (11, 2)])
def test_smolyak_is_exact_to_its_degree(dimensions: int, level: int) -> None:
    points, weights = smolyak.smolyak(dimensions, level)
    assert smolyak.size(dimensions, level) - weights.size in range(2 * smolyak.size(dimensions, 2))
    rng = np.random.default_rng(dimensions + level)
    for _ in range(30):
        powers = np.zeros(dimensions, dtype=int)
        for _ in range(int(rng.integers(2 * level + 2))):
            powers[rng.integers(dimensions)] += 1
        exact = np.prod([moment(int(power)) for power in powers])
        found = weights @ np.prod(points ** powers[:, None], axis=0)
        assert abs(found - exact) < 1e-11 * max(exact, 1.0)


def test_sizes_of_the_sparse_grids() -> None:
    sizes = [smolyak.size(7, 2), smolyak.size(7, 3), smolyak.size(7, 4), smolyak.size(11, 2), smolyak.size(11, 3)]
    assert sizes == [99, 421, 1485, 243, 1629]


def test_lattices_are_reproducible_and_better_than_chance() -> None:
    points = lattice(6, 1024, 8, seed=3)
    assert np.array_equal(points, lattice(6, 1024, 8, seed=3))
    assert not np.array_equal(points, lattice(6, 1024, 8, seed=4))
    assert points.min() > 0.0
    assert points.max() < 1.0
    found = np.prod(1.0 + (points - 0.5), axis=0).reshape(8, -1).mean(axis=1)
    assert np.abs(found - 1.0).max() < 1e-3


def test_a_lattice_refuses_what_it_is_not() -> None:
    with pytest.raises(ValueError, match="no lattice"):
        lattice(3, 100, 8)
