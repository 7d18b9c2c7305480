"""The normal and Student distributions against mpmath, tails included."""

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.numerics.distributions import normal, normal_arrays, student

mp.mp.dps = 50
RNG = np.random.default_rng(20)
SCORES = np.concatenate([RNG.uniform(-8.0, 37.5, 800), RNG.uniform(-1.0, 1.0, 200), [0.0, 1e-12, 5.0, 36.9]])
CHANCES = np.concatenate([10.0 ** RNG.uniform(-300.0, -0.31, 700), RNG.uniform(0.001, 0.999, 300)])


def upper(z: float) -> mp.mpf:
    return mp.erfc(mp.mpf(z) / mp.sqrt(2)) / 2


def quantile(p: float) -> mp.mpf:
    z = mp.mpf(normal.quantile(p))
    for _ in range(4):
        z -= (upper(-z) - mp.mpf(p)) / mp.npdf(z)
    return z


def ulps(found: float, exact: mp.mpf) -> float:
    return float(abs(mp.mpf(float(found)) - exact) / mp.mpf(math.ulp(float(exact)))) if exact else float(abs(found))


def test_the_tail_is_within_a_few_ulp() -> None:
    exact = [upper(float(z)) for z in SCORES]
    assert max(ulps(normal.upper(float(z)), e) for z, e in zip(SCORES, exact, strict=True)) < 4.0
    assert max(ulps(f, e) for f, e in zip(normal_arrays.upper(SCORES), exact, strict=True)) < 8.0


def test_the_quantile_is_within_a_few_ulp() -> None:
    exact = [quantile(float(p)) for p in CHANCES]
    assert max(ulps(normal.quantile(float(p)), e) for p, e in zip(CHANCES, exact, strict=True)) < 10.0
    assert max(ulps(f, e) for f, e in zip(normal_arrays.quantile(CHANCES), exact, strict=True)) < 10.0


def test_the_density_is_within_a_few_ulp() -> None:
    assert max(ulps(normal.density(float(z)), mp.npdf(mp.mpf(float(z)))) for z in SCORES) < 5.0


@given(st.floats(-37.0, 37.0))
def test_both_tails_make_one(z: float) -> None:
    assert math.isclose(normal.upper(z) + normal.lower(z), 1.0, rel_tol=3e-16)
    assert normal.upper(z) == normal.lower(-z)


@given(st.floats(1e-300, 0.4999999))
def test_quantile_and_tail_undo_one_another(p: float) -> None:
    z = normal.quantile(p)
    assert math.isclose(normal.lower(z), p, rel_tol=1e-15 * (1.0 + z * z))


def test_probabilities_of_small_and_large_arrays_agree() -> None:
    z = np.linspace(-9.0, 9.0, 2001)
    few = np.concatenate([normal_arrays.probability(part) for part in np.array_split(z, 10)])
    assert np.abs(few - normal_arrays.probability(z)).max() < 3e-16


@pytest.mark.parametrize("freedom", [1.0, 2.0, 3.0, 4.0, 9.0, 30.0, 2.5])
def test_students_tail_against_the_incomplete_beta_function(freedom: float) -> None:
    for t in (1e-3, 0.5, 1.0, 2.0, 5.0, 20.0, 300.0):
        exact = mp.betainc(mp.mpf(freedom) / 2, 0.5, 0, freedom / (freedom + mp.mpf(t) ** 2), regularized=True) / 2
        assert math.isclose(student.upper(t, freedom), float(exact), rel_tol=3e-14)


@settings(max_examples=40, deadline=None)
@given(st.sampled_from([1.0, 2.0, 3.0, 5.0, 12.0]), st.floats(-8.9, 8.9))
def test_students_table_agrees_with_its_solver(freedom: float, z: float) -> None:
    found = float(student.quantiles(np.array([z]), freedom)[0])
    assert math.isclose(found, student.quantile(z, freedom), rel_tol=1e-12, abs_tol=1e-14)
    if abs(z) > 1e-6:
        assert math.isclose(student.upper(abs(found), freedom), normal.upper(abs(z)), rel_tol=1e-11)
