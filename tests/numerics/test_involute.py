"""The involute function and its inverse: last bits, joins of the series, arrays as scalars, tracked bounds."""

import math
import random

import numpy as np
import pytest
from mpmath import mp, mpf, tan

from dynamics_cli.numerics.involute import MEETING, inverse_involute, involute
from dynamics_cli.numerics.tracked import Tracked

BANDS = [(1e-8, 1e-3), (1e-3, 0.0873), (0.0873, 0.611), (0.611, 1.2217), (1.2217, math.radians(89.9999))]


def exact_inverse(value: float) -> mpf:
    phi = mpf(inverse_involute(value))
    for _ in range(4):
        phi -= (tan(phi) - phi - mpf(value)) / tan(phi) ** 2
    return phi


@pytest.mark.parametrize(("low", "high"), BANDS)
def test_both_within_their_ulps(low: float, high: float) -> None:
    mp.dps = 90
    generator = random.Random(int(1e9 * low))
    for _ in range(400):
        phi = low * (high / low) ** generator.random()
        reference = tan(mpf(phi)) - mpf(phi)
        assert abs(mpf(involute(phi)) - reference) <= 2.1 * math.ulp(float(reference))
        value = float(reference)
        inverse = exact_inverse(value)
        assert abs(mpf(inverse_involute(value)) - inverse) <= 1.3 * math.ulp(float(inverse))


@pytest.mark.parametrize("value", [MEETING, math.nextafter(MEETING, 1.0), math.nextafter(MEETING, 0.0), 0.98, 1e-280])
def test_joins_are_smooth(value: float) -> None:
    mp.dps = 900 if value < 1e-100 else 60
    reference = exact_inverse(value)
    assert abs(mpf(inverse_involute(value)) - reference) <= 1.3 * math.ulp(float(reference))


def test_arrays_have_the_bits_of_scalars() -> None:
    generator = np.random.default_rng(5)
    phi = np.concatenate([np.exp(generator.uniform(-18.0, 0.0, 3000)), generator.uniform(0.0, 1.57, 3000), [0.0]])
    values = involute(phi)
    assert values.tolist() == [involute(float(x)) for x in phi]
    back = inverse_involute(values)
    assert back.tolist() == [inverse_involute(float(x)) for x in values]
    tall = inverse_involute(values[:6000].reshape(2, 3000))
    assert tall.shape == (2, 3000)
    assert tall[1, 7] == back[3007]


def test_odd_and_refusing() -> None:
    assert involute(-0.3) == -involute(0.3)
    assert inverse_involute(0) == inverse_involute(0.0) == 0.0
    assert np.isnan(inverse_involute(np.array([-1.0, 0.1]))).tolist() == [True, False]
    for bad in (-1e-30, math.nan, -math.inf):
        with pytest.raises(ValueError, match="no angle"):
            inverse_involute(bad)


@pytest.mark.parametrize("value", [1e-20, 1e-6, 0.0149, 0.6, 0.7, 40.0])
@pytest.mark.parametrize("share", [0.0, 1e-15, 1e-3])
def test_tracked_inverse_bounds_what_an_error_of_the_input_does(value: float, share: float) -> None:
    error = value * share
    own = inverse_involute(Tracked(value, error, (1.0,)))
    mp.dps = 60
    for side in (mpf(value) - error, mpf(value) + error):
        phi = mpf(own.value)
        for _ in range(60):
            phi -= (tan(phi) - phi - side) / tan(phi) ** 2
        assert abs(phi - mpf(own.value)) <= own.error
    assert own.slopes[0] == pytest.approx(1.0 / math.tan(own.value) ** 2)


def test_tracked_forward() -> None:
    own = involute(Tracked(0.35, 1e-15, (2.0,)))
    assert own.value == involute(0.35)
    assert own.slopes[0] == pytest.approx(2.0 * math.tan(0.35) ** 2)
    assert math.tan(0.35) ** 2 * 1e-15 <= own.error < 2e-16
