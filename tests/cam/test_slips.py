"""Running bounds of rounding: true at random places of every law in 60 digits, on floats and arrays, and tight."""

import random

import numpy as np
import pytest
from mpmath import mp, mpf
from references import generate_cam_motion_references as references
from test_enclosures import ALL

from dynamics_cli.cam.laws.normalised import law_named
from dynamics_cli.cam.laws.peaks import extremes, peak, peak_bound
from dynamics_cli.cam.proof.law_rounding import HALVES_OF_FLOATS, of_law, slips

U = 2.0**-53


def places(chance: random.Random, low: float, high: float) -> list[float]:
    """Inside a piece: anywhere, and close to its ends."""
    shares = [chance.random(), 10.0 ** chance.uniform(-9.0, 0.0), 1.0 - 10.0 ** chance.uniform(-9.0, -1.0)]
    return [t for t in (low + (high - low) * share for share in shares) if low < t < high]


def exactly(law, exact, piece, t: float) -> list:
    """The law and three derivatives in the piece's own coordinate."""
    values = exact(1 - mpf(t) if piece.far else mpf(t))
    if not piece.far:
        return list(values[:4])
    total = mpf(law.total) if not law.monotone else mpf(1)
    return [total - values[0], *(value if order % 2 == 0 else -value for order, value in enumerate(values[1:4]))]


@pytest.mark.parametrize("name", ALL)
def test_no_value_is_off_by_more(name: str) -> None:
    law, exact = ALL[name]
    chance = random.Random(name)
    with mp.workdps(60):
        for piece in law.pieces:
            for _ in range(8):
                for t in places(chance, *piece.ends):
                    wanted = exactly(law, exact, piece, t)
                    single, many = piece.shape(t, 3), piece.shape(np.array([t, t]), 3)
                    bounds = slips(piece.shape, t, 2.0 * U * t, 3, HALVES_OF_FLOATS)
                    wide = slips(piece.shape, np.array([t, t]), np.array([2.0 * U * t] * 2), 3)
                    for order in range(4):
                        slack = mpf(10) ** -40 * (1 + abs(wanted[order]))
                        assert abs(mpf(single[order]) - wanted[order]) <= mpf(bounds[order]) + slack, (t, order)
                        assert abs(mpf(float(many[order][0])) - wanted[order]) <= mpf(float(wide[order][0])) + slack
                        assert bounds[order] <= wide[order][1] * (1.0 + 1e-9), (t, order)


@pytest.mark.parametrize("name", [name for name in ALL if name in references.LAWS])
def test_bounds_of_named_laws_are_a_few_roundings_of_the_peak(name: str) -> None:
    law, _ = ALL[name]
    tops = [max(abs(value) for _, value in extremes(law, order)) or 1.0 for order in range(4)]
    for piece in law.pieces:
        for share in np.linspace(0.0, 1.0, 23):
            t = float(piece.ends[0] + (piece.ends[1] - piece.ends[0]) * share)
            for bound, top in zip(slips(piece.shape, t, 2.0 * U * t, 3, HALVES_OF_FLOATS), tops, strict=True):
                assert bound <= 60.0 * U * top


@pytest.mark.parametrize("name", [name for name in ALL if name in references.LAWS])
def test_peaks_keep_their_bounds(name: str) -> None:
    law, exact = ALL[name]
    with mp.workdps(60):
        for order in (1, 2):
            top, place = peak(law, order)
            if top == float("inf"):
                continue
            bound = peak_bound(law, order)
            assert bound <= 60.0 * U
            # about a peak the law is flat, and at a joint one of its sides
            near = [
                abs(exact(min(max(mpf(place) + shift * mpf(10) ** -30, mpf(0)), mpf(1)))[order]) for shift in (-1, 1)
            ]
            assert abs(max(near) - mpf(top)) <= mpf(bound) * mpf(top) + mpf(10) ** -28 * mpf(top)


def test_shares_that_do_not_sum_to_one_widen_the_bound() -> None:
    even, odd = law_named("scca", (0.25, 0.5, 0.25)), law_named("scca", (0.1, 0.2, 0.7))
    assert even.pieces[0].shape.off == 0.0
    assert odd.pieces[0].shape.off > 0.0
    assert of_law(odd, 0.02)[2] > U


def test_a_narrow_share_knows_how_little_it_knows() -> None:
    # a share of 1e-9: where its place is off by a rounding of one, its jerk is off by a millionth
    law = law_named("scca", (1e-9, 0.3, 0.7 - 1e-9))
    assert of_law(law, 4e-10)[3] >= law.pieces[0].shape.off * 1e8
