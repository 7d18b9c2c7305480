"""Greatest values by turning places: true against mpmath, to the rounding of one evaluation, on hard shapes too."""

import random
from typing import Any

import numpy as np
import pytest
from mpmath import findroot, mp, mpf

from dynamics_cli.numerics.chebyshev.remainders import proved_proxies
from dynamics_cli.numerics.chebyshev.summits import doubtful, settled, summits
from dynamics_cli.numerics.discs import Disc

U = 2.0**-53


def summit(function: Any, low: float, high: float, sign: float = 1.0) -> tuple[float, float, float]:
    """Value, place and bound of the greatest (or, with -1, the least) value of a function of discs."""
    made = proved_proxies(lambda x, piece: np.stack([function(x)]), np.array([low]), np.array([high]))
    found = summits(made)[0 if sign > 0.0 else 1]
    starts, ends = made.starts[found.rows], made.ends[found.rows]
    places = 0.5 * (starts + ends) + 0.5 * (ends - starts) * found.units
    places = np.where(found.units == 1.0, ends, np.where(found.units == -1.0, starts, places))
    values = function(Disc(places, np.zeros(places.shape)))
    value, index, error = settled(found, sign * values.centre, values.radius + 0.0 * values.centre)
    return sign * value, float(places[index]), error


@pytest.mark.parametrize("seed", range(40))
def test_sums_of_waves_against_mpmath(seed: int) -> None:
    chance = random.Random(seed)
    waves = [(chance.uniform(-1, 1), chance.uniform(0.3, 3.0), chance.uniform(0, 6)) for _ in range(3)]

    def function(x: Any) -> Any:
        return sum((a * np.sin(w * x + c) for a, w, c in waves), 0.0 * x)

    with mp.workdps(40):

        def exact(x: Any) -> Any:
            return sum(mpf(a) * mp.sin(mpf(w) * x + mpf(c)) for a, w, c in waves)

        def slope(x: Any) -> Any:
            return sum(mpf(a) * mpf(w) * mp.cos(mpf(w) * x + mpf(c)) for a, w, c in waves)

        for sign in (1.0, -1.0):
            value, place, error = summit(function, 0.0, 5.0, sign)
            grid = np.linspace(0.0, 5.0, 4001)
            dense = sign * sum(a * np.sin(w * grid + c) for a, w, c in waves)
            near = mpf(float(grid[int(dense.argmax())]))
            # the end itself, or a turn less than a step of the grid from it
            turn = findroot(slope, near)
            near = max((place for place in (near, turn) if 0 <= place <= 5), key=lambda place: sign * exact(place))
            true = exact(near)
            assert abs(true - mpf(value)) <= mpf(error)
            assert error <= 60.0 * U
            assert abs(near - mpf(place)) < 1e-5


def test_a_slope_at_an_end_costs_nothing() -> None:
    value, place, error = summit(lambda x: np.exp(x), 0.0, 1.0)
    assert place == 1.0
    assert value == pytest.approx(2.718281828459045, rel=1e-15)
    # the library's exponential, four units in the last place
    assert error <= 12.0 * U * value


def test_equal_summits_are_both_looked_at() -> None:
    value, place, error = summit(lambda x: np.sin(x) * np.sin(x), 0.1, 6.0)
    assert value == 1.0
    assert place == pytest.approx(np.pi / 2, abs=1e-7)
    assert error <= 20.0 * U


@pytest.mark.parametrize("apart", [1e-1, 1e-3, 1e-6, 1e-9])
def test_summits_that_run_into_each_other(apart: float) -> None:
    """1 − (x² − a²)² has two summits of 1 at ±a, and hardly any valley between them."""
    value, _, error = summit(lambda x: 1.0 - np.square(x * x - apart * apart), -1.0, 1.5)
    assert abs(value - 1.0) <= error
    # where no curvature can be told the proxy keeps its own error, which pieces cut finer make small (`Cover.cut`)
    assert error <= (100.0 * U if apart > 0.01 else 1e-12)


def test_a_constant_is_known_on_still_pieces() -> None:
    made = proved_proxies(lambda x, piece: np.stack([0.0 * x + 3.0]), np.array([0.0]), np.array([1.0]))
    moving, still = summits(made)[0], summits(made, still=np.array([True]))[0]
    assert doubtful(moving, 3.0).any()
    assert not doubtful(still, 3.0).any()
    values = np.full(still.rows.shape, 3.0)
    assert settled(still, values, 0.0 * values)[2] == 0.0


def test_what_is_not_proved_has_no_gain() -> None:
    """Without a bound of its slope a proxy keeps its whole error."""
    from dynamics_cli.numerics.chebyshev.proxies import proxies

    made = proxies(lambda x, piece: np.sin(x)[None], np.array([0.0]), np.array([3.0]))
    found = summits(made)[0]
    assert np.isinf(found.gains).all()
    values = np.sin(
        0.5 * (made.starts + made.ends)[found.rows] + 0.5 * (made.ends - made.starts)[found.rows] * found.units
    )
    value, _, error = settled(found, values, np.full(values.shape, U))
    assert abs(value - 1.0) <= error < 1e-13
