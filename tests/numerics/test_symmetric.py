"""Eigenvalues of 3 × 3 matrices: graded, close, equal, of every size; bounds; vectors."""

import random
from itertools import product
from typing import Any

import numpy as np
import pytest
from mpmath import eigsy, matrix, mp, mpf

from dynamics_cli.numerics.eigen3 import quotients_lanes
from dynamics_cli.numerics.eigen3.jacobi import eigen
from dynamics_cli.numerics.eigen3.residual import quotients
from dynamics_cli.numerics.lanes import Lanes

Rows = tuple[tuple[float, float, float], ...]


def symmetric(generator: random.Random, grade: float, spread: float) -> Rows:
    """D A D with A near 1 (spread small) or any positive matrix (spread large)."""
    d = [10.0 ** -generator.uniform(0.0, grade) for _ in range(3)]
    rows = [[float(i == j) + spread * generator.gauss(0.0, 1.0) for i in range(3)] for j in range(4)]
    full = [[0.0] * 3 for _ in range(3)]
    for i in range(3):
        for j in range(i + 1):
            full[i][j] = full[j][i] = d[i] * d[j] * sum(row[i] * row[j] for row in rows)
    return tuple(tuple(row) for row in full)  # type: ignore[return-value]


def true(rows: Rows) -> list[mpf]:
    with mp.workdps(60):
        return sorted(eigsy(matrix([list(row) for row in rows]), eigvals_only=True), reverse=True)


@pytest.mark.parametrize("grade", [0.0, 3.0, 8.0])
@pytest.mark.parametrize("spread", [1e-14, 1e-8, 1e-3, 1.0])
def test_values_are_within_their_bounds(grade: float, spread: float) -> None:
    generator = random.Random(f"{grade} {spread}")
    for _ in range(40):
        rows = symmetric(generator, grade, spread)
        found = eigen(rows)  # type: ignore[arg-type]
        for value, bound, exact in zip(found.values, found.bounds, true(rows), strict=True):
            assert abs(value - exact) <= bound
            if spread < 0.1:
                # well-scaled: every eigenvalue to its own digits, whatever the grading
                assert abs(value - exact) <= 4e-15 * exact
                assert bound <= 1e-14 * exact


def test_a_matrix_without_sign_keeps_a_bound_of_its_norm() -> None:
    generator = random.Random(4)
    for _ in range(200):
        a, b, c, d, e, f = (generator.gauss(0.0, 1.0) for _ in range(6))
        rows = ((a, b, c), (b, d, e), (c, e, f))
        found = eigen(rows)
        norm = max(abs(x) for row in rows for x in row)
        for value, bound, exact in zip(found.values, found.bounds, true(rows), strict=True):
            assert abs(value - exact) <= bound <= 1e-14 * norm


@pytest.mark.parametrize("size", [1e-300, 1e-160, 1.0, 1e150, 1e300])
def test_any_size(size: float) -> None:
    rows = tuple(tuple(size * x for x in row) for row in ((2.0, 1.0, 0.0), (1.0, 2.0, 0.0), (0.0, 0.0, 5.0)))
    assert eigen(rows).values == pytest.approx((5.0 * size, 3.0 * size, size), rel=1e-15)  # type: ignore[arg-type]


def test_a_diagonal_matrix_is_taken_as_it_is() -> None:
    found = eigen(((2.0, 0.0, 0.0), (0.0, 7.0, 0.0), (0.0, 0.0, 3.0)))
    assert found.values == (7.0, 3.0, 2.0)
    assert found.vectors == ((0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
    assert found.bounds == (0.0, 0.0, 0.0)


def test_vectors_are_orthonormal_and_satisfy_the_equation() -> None:
    generator = random.Random(9)
    for _ in range(100):
        rows = symmetric(generator, 4.0, 1.0)
        found = eigen(rows)  # type: ignore[arg-type]
        for (i, u), (j, v) in product(enumerate(found.vectors), repeat=2):
            assert sum(a * b for a, b in zip(u, v, strict=True)) == pytest.approx(float(i == j), abs=2e-15)
        for value, vector in zip(found.values, found.vectors, strict=True):
            image = [sum(row[k] * vector[k] for k in range(3)) for row in rows]
            assert image == pytest.approx([value * x for x in vector], abs=4e-15 * found.values[0])


def test_zero_and_rank_one() -> None:
    nothing = ((0.0, 0.0, 0.0),) * 3
    assert eigen(nothing).values == (0.0, 0.0, 0.0)
    ones = ((1.0, 1.0, 1.0),) * 3
    found = eigen(ones)
    assert found.values[0] == pytest.approx(3.0, rel=1e-15)
    assert max(abs(value) for value in found.values[1:]) <= found.bounds[1]


@pytest.mark.parametrize("bad", [float("nan"), float("inf")])
def test_only_finite_numbers(bad: float) -> None:
    for i, j in ((0, 0), (1, 0), (2, 1)):
        rows = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        rows[i][j] = bad
        with pytest.raises(OverflowError):
            eigen(tuple(map(tuple, rows)))  # type: ignore[arg-type]


@pytest.mark.parametrize("size", [1.0, 1e-160, 1e150, 1e-290])
def test_quotients_of_lanes_have_the_bits_of_single_ones(size: float) -> None:
    generator = random.Random(11)
    cases = [symmetric(generator, grade, 1.0) for grade in (0.0, 4.0, 12.0) for _ in range(60)]
    # whole numbers have quotients between which none need be rounded, zeros none that pairs can judge
    cases += [((2.0, 1.0, 0.0), (1.0, 2.0, 0.0), (0.0, 0.0, 5.0)), ((0.0, 0.0, 0.0),) * 3, ((1.0, 1.0, 1.0),) * 3]
    cases = [tuple(tuple(size * x for x in row) for row in rows) for rows in cases]
    turned = [eigen(rows).vectors for rows in cases]
    wanted = [quotients(rows, lines) for rows, lines in zip(cases, turned, strict=True)]
    asked = []

    def exact(*given: Any) -> Any:
        asked.append(given)
        return quotients(*given)

    lanes, vectors = (
        tuple(tuple(np.array([case[i][j] for case in given]).view(Lanes) for j in range(3)) for i in range(3))
        for given in (cases, turned)
    )
    found = quotients_lanes.quotients(lanes, vectors, exact)  # type: ignore[arg-type]
    assert isinstance(found[0], Lanes)
    assert list(zip(*(row.tolist() for row in found), strict=True)) == wanted  # type: ignore[attr-defined]
    # whole numbers are the way out, not the way
    assert len(asked) < 20 or size == 1e-290
    if size == 1e-290:
        assert len(asked) == len(cases)
