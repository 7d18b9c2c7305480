"""Errors that laws carry, at places and on cells: true in 50 digits for every law, tight, of both sides of joints."""

import random

import numpy as np
import pytest
from mpmath import diff, mp, mpf, pi
from references import generate_cam_motion_references as references

from dynamics_cli.cam.export.path import _about
from dynamics_cli.cam.laws.normalised import law_named
from dynamics_cli.cam.laws.peaks import errors_of, extremes, peak, peak_bound
from dynamics_cli.cam.laws.polynomials import polynomial, spline
from dynamics_cli.cam.program.motion import Motion
from dynamics_cli.cam.program.parts import Span
from dynamics_cli.numerics.discs import Disc

U = 2.0**-53
RISE = 0.0137
SPAN = (773, 10)


def conditions(chance: random.Random, degree: int) -> list[tuple[float, int, float]]:
    orders = range((degree + 1) // 2)
    return [
        (x, k, (x if k == 0 else round(chance.uniform(-4, 4), 2))) for k in orders for x in (0.0, 1.0)
    ]  # fmt: skip


def exact_parts(shape):
    """A polynomial shape in mpmath, as it is stored."""
    origin, coefficients = shape.origin, shape._polynomials[0]
    return lambda t: sum(
        mpf(c) * ((mpf(origin) - t) if shape.backwards else t - mpf(origin)) ** i for i, c in enumerate(coefficients)
    )


def stored(law):
    """A law as its pieces are stored: what a spline is."""

    def value(x):
        piece = next((one for one in law.pieces if x < mpf(one.high)), law.pieces[-1])
        f = exact_parts(piece.shape)(1 - x if piece.far else x)
        return law.total - f if piece.far else f

    return lambda x: tuple(diff(value, x, order) if order else value(x) for order in range(4))


def laws():
    """(name, law, the law in mpmath) of every law, with shares, polynomials and splines at random."""
    mp.dps = 50
    chance = random.Random(7)
    for name, exact in references.LAWS.items():
        yield name, law_named(name), exact
    for number in range(6):
        b, c = round(chance.uniform(0.0, 0.6), 3), round(chance.uniform(0.0, 0.4), 3)
        d, constant = 1.0 - b - c, (0.0, 0.4)[number % 2]
        yield f"scca {b} {c} {constant}", law_named("scca", (b, c, d), constant), references.scca(b, c, d, constant)
    for degree in (3, 5, 7, 9):
        made = conditions(chance, degree)
        yield f"polynomial {degree}", polynomial(made), references.polynomial(made)
    for count in (2, 5):
        points = [(i / (count + 1), round(chance.uniform(-0.2, 1.2), 3)) for i in range(1, count + 1)]
        law = spline([(0.0, 0.0), *points, (1.0, 1.0)], 0.3, -0.7)
        yield f"spline {count}", law, stored(law)


ALL = {name: (law, exact) for name, law, exact in laws()}


def motion_with(law, span=SPAN, rise=RISE) -> Motion:
    # a quotient of whole numbers of degrees: the end is exact
    rest = (360 * span[1] - span[0], span[1])
    back = ((rest[0] + span[0]), rest[1])
    return Motion([Span((0, 1), span, 0.0, rise, law), Span(span, back, rise, 0.0, law_named("3-4-5"))])


def zones_of(motion: Motion):
    return [index for index, zone in enumerate(motion.zones) if zone.segment == 0]


@pytest.mark.parametrize("name", ALL)
def test_no_law_ever_leaves_its_enclosure(name: str) -> None:
    mp.dps = 50
    law, exact = ALL[name]
    chance = random.Random(name)
    motion, width = motion_with(law), mpf(SPAN[0]) / SPAN[1] * pi / 180
    for index in zones_of(motion):
        zone = motion.zones[index]
        low, high = zone.start, zone.end
        for _ in range(14):
            half = (high - low) * 10.0 ** chance.uniform(-13, -0.31) * chance.choice((0.0, 1.0, 1.0))
            middle = chance.choice((low + half, high - half, chance.uniform(low + half, high - half)))
            found = _about(motion, index, np.array([middle]), np.array([half]), 3)
            for share in (chance.uniform(-1, 1), chance.choice((-1, 1))):
                theta = mpf(middle) + mpf(share) * mpf(half)
                # strictly inside the zone: at a joint the exact law may be the neighbour's already
                x = min(max(theta / width, mpf(low) / width + mpf(10) ** -15), mpf(high) / width - mpf(10) ** -15)
                if abs(x * width - mpf(middle)) > mpf(half):
                    continue
                for order, value in enumerate(exact(x)):
                    disc = found[order]
                    off = abs(mpf(RISE) * value / width**order - mpf(float(disc.centre[0])))
                    assert off <= mpf(float(disc.radius[0])), (index, middle, half, order)


@pytest.mark.parametrize(("span", "rise"), [((1, 17453), 1e-9), ((359, 1), 1.0), ((1, 10**6), 1e-12), ((90, 1), -0.02)])
def test_hard_spans_and_lifts(span: tuple[int, int], rise: float) -> None:
    mp.dps = 50
    law, exact = ALL["cycloidal"]
    motion = motion_with(law, span, rise)
    width = mpf(span[0]) / span[1] * pi / 180
    zone = motion.zones[0]
    for share in (0.0, 1e-9, 0.3, 0.5, 0.999999, 1.0):
        middle = zone.start + share * (zone.end - zone.start)
        for half in (0.0, 1e-3 * (zone.end - zone.start)):
            found = _about(motion, 0, np.array([middle]), np.array([half]), 3)
            x = min(max((mpf(middle) + mpf(half) / 2) / width, mpf(0)), mpf(1))
            for order, value in enumerate(exact(x)):
                assert abs(mpf(rise) * value / width**order - float(found[order].centre[0])) <= float(
                    found[order].radius[0]
                )


def test_both_sides_of_a_joint_have_their_own_values() -> None:
    motion = motion_with(law_named("trapezoid"))
    for index in zones_of(motion)[:-1]:
        joint = np.array([motion.zones[index].end])
        before = _about(motion, index, joint, np.zeros(1), 3)
        after = _about(motion, index + 1, joint, np.zeros(1), 3)
        for order in range(3):
            apart = abs(before[order].centre - after[order].centre)
            assert (apart <= before[order].radius + after[order].radius).all()
        jumps = abs(before[3].centre - after[3].centre) > before[3].radius + after[3].radius
        assert bool(jumps[0])


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
                    single, bounds = piece.shape(t, 3), errors_of(piece, t, 2.0 * U * t, 3)
                    many = piece.shape(Disc(np.array([t, t]), np.array([2.0 * U * t] * 2)), 3)
                    for order in range(4):
                        slack = mpf(10) ** -40 * (1 + abs(wanted[order]))
                        assert abs(mpf(single[order]) - wanted[order]) <= mpf(bounds[order]) + slack, (t, order)
                        off = abs(mpf(float(many[order].centre[0])) - wanted[order])
                        assert off <= mpf(float(many[order].radius[1])) + slack, (t, order)


@pytest.mark.parametrize("name", [name for name in ALL if name in references.LAWS])
def test_bounds_of_named_laws_are_a_few_roundings_of_the_peak(name: str) -> None:
    law, _ = ALL[name]
    tops = [max(abs(value) for _, value in extremes(law, order)) or 1.0 for order in range(4)]
    for piece in law.pieces:
        for share in np.linspace(0.0, 1.0, 23):
            t = float(piece.ends[0] + (piece.ends[1] - piece.ends[0]) * share)
            for bound, top in zip(errors_of(piece, t, 2.0 * U * t, 3), tops, strict=True):
                assert bound <= 70.0 * U * top


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
    assert errors_of(odd.pieces[0], 0.02, 0.02 * U, 3)[2] > U


def test_a_narrow_share_knows_how_little_it_knows() -> None:
    # a share of 1e-9: where its place is off by a rounding of one, its jerk is off by a millionth
    law = law_named("scca", (1e-9, 0.3, 0.7 - 1e-9))
    assert errors_of(law.pieces[0], 4e-10, 4e-10 * U, 3)[3] >= law.pieces[0].shape.off * 1e8
