"""Principal axes: which are determined, how they are chosen when they are not, and that moments are sums."""

import random

import pytest

from dynamics_cli.inertia.bodies.principal import principal

EPS = 2.0**-52


def diagonal(x: float, y: float, z: float) -> tuple[tuple[float, float, float], ...]:
    return (x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z)


def determinant(axes: tuple[tuple[float, float, float], ...]) -> float:
    (a, b, c), (d, e, f), (g, h, i) = axes
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def turned(second: tuple[float, float, float], seed: int) -> tuple[tuple[float, float, float], ...]:
    """R diag R^T for a random rotation."""
    generator = random.Random(seed)
    w, x, y, z = (generator.gauss(0.0, 1.0) for _ in range(4))
    n = w * w + x * x + y * y + z * z
    r = (
        ((w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n),
        (2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n),
        (2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n),
    )
    full = [[sum(r[i][k] * second[k] * r[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
    return tuple(tuple(full[max(i, j)][min(i, j)] for j in range(3)) for i in range(3))  # type: ignore[return-value]


def test_moments_ascend_and_are_sums() -> None:
    found = principal(diagonal(1.0, 3.0, 2.0))
    assert found.seconds == (3.0, 2.0, 1.0)
    assert found.moments == (3.0, 4.0, 5.0)
    assert found.axes[:2] == ((0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    assert found.degeneracy.startswith("none")


def test_a_needle_keeps_its_least_moment() -> None:
    found = principal(diagonal(1.0, 3e-20, 2e-20))
    assert found.moments == (5e-20, 1.0, 1.0)
    assert found.degeneracy.startswith("axes 2 and 3")


@pytest.mark.parametrize("seed", range(20))
@pytest.mark.parametrize(
    "second", [(3.0, 2.0, 1.0), (1.0, 1.0, 0.3), (2.0, 0.5, 0.5), (1.0, 1.0, 1.0), (1.0, 1e-9, 0.0)]
)
def test_axes_are_right_handed_and_canonical(second: tuple[float, float, float], seed: int) -> None:
    found = principal(turned(second, seed))
    assert determinant(found.axes) == pytest.approx(1.0, abs=1e-14)
    for axis in found.axes:
        assert sum(x * x for x in axis) == pytest.approx(1.0, abs=1e-15)
    if found.degeneracy.startswith("none"):
        for axis in found.axes[:2]:
            assert max(axis, key=abs) > 0.0
    assert found.moments == pytest.approx(
        (second[1] + second[2], second[2] + second[0], second[0] + second[1]), abs=5e-15
    )


@pytest.mark.parametrize("factor", [2.0, 40.0])
def test_equal_is_within_eight_roundings(factor: float) -> None:
    upper = principal(diagonal(1.0 + factor * EPS, 1.0, 0.5))
    lower = principal(diagonal(2.0, 1.0 + factor * EPS, 1.0))
    assert upper.degeneracy.startswith("axes 1 and 2") is (factor < 16.0)
    assert lower.degeneracy.startswith("axes 2 and 3") is (factor < 24.0)


def test_all_equal_takes_the_input_axes() -> None:
    found = principal(turned((1.0, 1.0, 1.0), 3))
    assert found.axes == diagonal(1.0, 1.0, 1.0)
    assert found.degeneracy.startswith("every axis")


def test_an_uncertainty_makes_axes_undetermined() -> None:
    second = diagonal(1.01, 1.0, 0.5)
    assert principal(second, (0.0005, 0.0005, 0.0)).degeneracy.startswith("none")
    found = principal(second, (0.01, 0.01, 0.0))
    assert found.degeneracy.startswith("axes 1 and 2")
    assert "less than the uncertainty" in found.degeneracy


def test_what_rounding_made_negative_is_zero() -> None:
    assert principal(diagonal(1.0, 1.0, -1e-16)).seconds[2] == 0.0
    assert principal(diagonal(1.0, 1.0, -1e-3)).seconds[2] == -1e-3


def test_a_frame_gives_axes_in_the_input_axes() -> None:
    frame = ((0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
    found = principal(diagonal(3.0, 2.0, 1.0), (0.0, 0.0, 0.0), frame)
    assert found.axes == frame
    round_ = principal(diagonal(3.0, 1.0, 1.0), (0.0, 0.0, 0.0), frame)
    assert round_.axes == ((0.0, 1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, -1.0))
