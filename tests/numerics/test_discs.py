"""Discs hold what they must: every operation at complex numbers of 60 digits, roundings at radius zero, refusals."""

import cmath
import random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp, mpc, mpf

from dynamics_cli.numerics.discs import Disc, arc_tangent

PAIRS = {
    "sum": (lambda a, b: a + b, lambda a, b: a + b),
    "difference": (lambda a, b: a - b, lambda a, b: a - b),
    "product": (lambda a, b: a * b, lambda a, b: a * b),
    "quotient": (lambda a, b: a / b, lambda a, b: a / b),
    "square": (lambda a, b: a.square(), lambda a, b: a * a),
    "power": (lambda a, b: np.square(a) * b - a, lambda a, b: a * a * b - a),
    "root": (lambda a, b: np.sqrt(a * a + 9.0), lambda a, b: mp.sqrt(a * a + 9)),
    "sine": (lambda a, b: np.sin(a + b), lambda a, b: mp.sin(a + b)),
    "cosine": (lambda a, b: np.cos(a) * 3.0, lambda a, b: mp.cos(a) * 3),
    "exponential": (lambda a, b: np.exp(a), lambda a, b: mp.exp(a)),
    "logarithm": (lambda a, b: np.log(a + 12.0), lambda a, b: mp.log(a + 12)),
    "arc cosine": (lambda a, b: np.arccos(a / 16.0), lambda a, b: mp.acos(a / 16)),
    "arc sine": (lambda a, b: np.arcsin(a / 16.0), lambda a, b: mp.asin(a / 16)),
    "arc tangent": (lambda a, b: np.arctan2(a, b), lambda a, b: arc(a, b)),
    "scalars": (lambda a, b: 2.0 - (0.1 * a - b / 3.0) / 7.0, lambda a, b: 2 - (mpf(0.1) * a - b / 3) / 7),
    "from the left": (lambda a, b: 1.0 / (2.0 - a) + np.float64(3.0) * b, lambda a, b: 1 / (2 - a) + 3 * b),
}


def arc(y, x):
    """The angle of x + iy, continued into complex arguments from the real one on the same side of the cut."""
    return (mp.log(x + 1j * y) - mp.log(x - 1j * y)) / 2j


@pytest.mark.parametrize("name", PAIRS)
def test_every_operation_holds_complex_numbers_of_its_discs(name: str) -> None:
    mp.dps = 60
    chance = random.Random(name)
    discs, exact = PAIRS[name]
    known = 0
    for _ in range(300):
        a, b = chance.uniform(-9.0, 9.0), chance.uniform(-9.0, 9.0)
        ra, rb = (10.0 ** chance.uniform(-18, 0.7) * chance.choice((0.0, 1.0)) for _ in range(2))
        with np.errstate(all="ignore"):
            found = discs(Disc(np.array(a), np.array(ra)), Disc(np.array(b), np.array(rb)))
        if not np.isfinite(found.radius):
            continue
        known += 1
        for _ in range(4):
            turns = [cmath.exp(1j * chance.uniform(0.0, 6.3)) * chance.choice((1.0, chance.random())) for _ in range(2)]
            # exactly inside: the double exponential may be outside the unit circle by a rounding
            x, y = (mpf(c) + mpf(r) * mpc(turn) / (1 + mpf(2) ** -50)
                    for c, r, turn in zip((a, b), (ra, rb), turns, strict=True))  # fmt: skip
            if name == "arc tangent" and b < 0.0 and abs(a) <= 2.0 * ra:
                continue
            assert abs(exact(x, y) - mpf(float(found.centre))) <= mpf(float(found.radius)), (a, b, ra, rb)
    assert known > 100


@given(st.floats(-30.0, 30.0), st.floats(1e-3, 30.0))
def test_at_radius_zero_a_disc_is_a_few_roundings_wide(a: float, b: float) -> None:
    x, y = Disc(np.array(a)), Disc(np.array(b))
    for found in (x + y, x * y, x / y, np.sqrt(y), np.arctan2(x, y)):
        assert 0.0 <= found.radius <= 1.2e-15 * abs(found.centre) + 1e-299
    for found in (np.sin(x), np.cos(x)):
        assert found.radius <= 1e-15


def test_nothing_is_claimed_where_a_function_is_not_analytic() -> None:
    wide = Disc(np.array(0.5), np.array(0.6))
    with np.errstate(all="ignore"):
        for unknown in (1.0 / wide, np.sqrt(wide), np.log(wide), np.arccos(wide), np.hypot(wide, 0.0),
                        np.clip(wide, -1.0, 1.0), np.arctan2(Disc(np.array(0.1), np.array(0.2)), -1.0),
                        arc_tangent(wide, 0.0)):  # fmt: skip
            assert not np.isfinite(unknown.radius)
    assert np.clip(Disc(np.array(3.0), np.array(0.5)), -1.0, 1.0).radius == 0.0


def test_what_discs_cannot_do_is_refused() -> None:
    one = Disc(np.ones(2), np.zeros(2))
    for forbidden in (lambda: np.abs(one), lambda: np.maximum(one, 0.0), lambda: np.add.reduce(one)):
        with pytest.raises(TypeError):
            forbidden()
    with pytest.raises(TypeError):
        np.where(one, one, one)


def test_arrays_go_together() -> None:
    rows = np.stack(np.broadcast_arrays(Disc(np.ones((3, 1)), 0.1 * np.ones((3, 4))), np.zeros_like(Disc(np.ones(4)))))
    assert rows.centre.shape == rows.radius.shape == (2, 3, 4)
    assert rows[1].radius.max() == 0.0
    assert rows[None].shape == (1, 2, 3, 4)
    both = np.ones(3) * Disc(np.arange(3.0), np.ones(3)) + np.ones(3)
    assert isinstance(both, Disc)
    assert both.centre.tolist() == [1.0, 2.0, 3.0]
    assert (np.ones_like(both).size >= 1.0).all()
    assert (both.least <= both.centre - both.radius).all()
