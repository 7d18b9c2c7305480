"""Enclosures of every law against 40 digits: never left, tight, on both sides of joints, around places of the plane."""

import cmath
import random

import numpy as np
import pytest
from mpmath import diff, mp, mpc, mpf, pi
from references import generate_cam_motion_references as references

from dynamics_cli.cam.laws.normalised import law_named
from dynamics_cli.cam.laws.polynomials import polynomial, spline
from dynamics_cli.cam.program.motion import Motion
from dynamics_cli.cam.program.parts import Span
from dynamics_cli.cam.proof.law_discs import Parts, discs
from dynamics_cli.cam.proof.law_enclosures import bound, derivative, rounding, spreads
from dynamics_cli.cam.proof.motion_enclosures import about_angles

RISE = 0.0137
SPAN = (773, 10)


def conditions(chance: random.Random, degree: int) -> list[tuple[float, int, float]]:
    orders = range((degree + 1) // 2)
    return [
        (x, k, (x if k == 0 else round(chance.uniform(-4, 4), 2))) for k in orders for x in (0.0, 1.0)
    ]  # fmt: skip


def exact_parts(shape):
    """A shape at complex places in mpmath, from its parts as they are stored."""
    coefficients, waves, origin, backwards = shape.parts

    def value(t):
        tau = (mpf(origin) - t) if backwards else t - mpf(origin)
        total = sum(mpf(c) * tau**i for i, c in enumerate(coefficients))
        for amplitude, w, start in waves:
            u = mpf(w) * tau
            total += mpf(amplitude) * (u - mp.sin(u), 1 - mp.cos(u), mp.sin(u))[start]
        return total

    return value


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
            found = about_angles(motion, index, np.array([middle]), np.array([half]), 4)
            for share in (chance.uniform(-1, 1), chance.choice((-1, 1))):
                theta = mpf(middle) + mpf(share) * mpf(half)
                # strictly inside the zone: at a joint the exact law may be the neighbour's already
                x = min(max(theta / width, mpf(low) / width + mpf(10) ** -15), mpf(high) / width - mpf(10) ** -15)
                if abs(x * width - mpf(middle)) > mpf(half):
                    continue
                values = [*exact(x), diff(lambda u: exact(u)[3], x, h=mpf(10) ** -20)]
                for order, value in enumerate(values):
                    disc = found[order]
                    off = abs(mpf(RISE) * value / width**order - mpf(float(disc.centre[0])))
                    room = mpf(float(disc.radius[0])) * (1 + (mpf(10) ** -15 if order == 4 else 0))
                    assert off <= room, (index, middle, half, order)


@pytest.mark.parametrize("name", ALL)
def test_enclosures_are_tight(name: str) -> None:
    law, _ = ALL[name]
    motion = motion_with(law)
    chance = random.Random(name)
    for index in zones_of(motion):
        zone = motion.zones[index]
        whole = np.linspace(zone.start, zone.end, 60)[1:-1]
        alone = about_angles(motion, index, whole, np.zeros(58), 3)
        for point, values in zip(alone, motion.at(whole), strict=True):
            # a point's own radius is its rounding
            assert point.radius.max() <= 1e-11 * float(np.abs(values).max()) + 1e-14 * RISE
        for _ in range(6):
            half = (zone.end - zone.start) * 10.0 ** chance.uniform(-5, -2)
            middle = chance.uniform(zone.start + half, zone.end - half)
            wide = about_angles(motion, index, np.array([middle]), np.array([half]), 3)
            alone = about_angles(motion, index, np.array([middle]), np.zeros(1), 3)
            theta = np.linspace(middle - half, middle + half, 101)
            for order, (disc, point, values) in enumerate(zip(wide, alone, motion.at(theta), strict=True)):
                moved = float(np.abs(values - disc.centre).max())
                # to first order the range itself; what is beyond is by the largest second derivative there may be
                beyond = max(
                    abs(part.scales[order]) * (half / part.span) ** 2 * bound(part.law_piece.shape, order + 2, 1.0)
                    for part in motion.parts_of(index)
                )
                assert disc.radius[0] <= 1.01 * moved + beyond + 3.0 * point.radius[0]


@pytest.mark.parametrize("name", ALL)
def test_discs_of_the_complex_plane_hold_the_continued_law(name: str) -> None:
    mp.dps = 40
    law, _ = ALL[name]
    chance = random.Random(name)
    for piece in law.pieces:
        low, high = piece.ends
        exact = exact_parts(piece.shape)
        for _ in range(5):
            t, radius = chance.uniform(low, high), (high - low) * 10.0 ** chance.uniform(-2, 0.6)
            wide = spreads(piece.shape, np.array([t]), np.array([radius]), 3)
            z = mpf(t) + mpf(radius) * mpc(cmath.exp(1j * chance.uniform(0, 6.3))) / (1 + mpf(2) ** -50)
            for order in range(4):
                there, here = (diff(exact, place, order) if order else exact(place) for place in (z, mpf(t)))
                assert abs(there - here) <= mpf(float(wide[order][0])) * (1 + mpf(10) ** -12), (order, t, radius)


@pytest.mark.parametrize("name", ALL)
def test_bounds_of_derivatives_and_roundings_of_shapes(name: str) -> None:
    mp.dps = 40
    law, _ = ALL[name]
    chance = random.Random(name)
    for piece in law.pieces:
        shape, (low, high) = piece.shape, piece.ends
        reach = max(abs(low - shape.parts[2]), abs(high - shape.parts[2]))
        exact = exact_parts(shape)
        for _ in range(4):
            t = chance.uniform(low, high)
            values = shape(t, 4)
            for order in range(6):
                value = diff(exact, mpf(t), order) if order else exact(mpf(t))
                size, slip = mpf(bound(shape, order, reach)), mpf(rounding(shape, order, reach))
                assert abs(value) <= size * (1 + mpf(10) ** -12)
                assert abs(derivative(shape, order, t) - value) <= slip + mpf(10) ** -14 * size
                if order < 5:
                    assert abs(values[order] - value) <= slip


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
            found = about_angles(motion, 0, np.array([middle]), np.array([half]), 3)
            x = min(max((mpf(middle) + mpf(half) / 2) / width, mpf(0)), mpf(1))
            for order, value in enumerate(exact(x)):
                assert abs(mpf(rise) * value / width**order - float(found[order].centre[0])) <= float(
                    found[order].radius[0]
                )


def test_both_sides_of_a_joint_have_their_own_values() -> None:
    motion = motion_with(law_named("trapezoid"))
    for index in zones_of(motion)[:-1]:
        joint = np.array([motion.zones[index].end])
        before = about_angles(motion, index, joint, np.zeros(1), 3)
        after = about_angles(motion, index + 1, joint, np.zeros(1), 3)
        for order in range(3):
            apart = abs(before[order].centre - after[order].centre)
            assert (apart <= before[order].radius + after[order].radius).all()
        jumps = abs(before[3].centre - after[3].centre) > before[3].radius + after[3].radius
        assert bool(jumps[0])


def test_rows_of_discs_are_those_one_by_one() -> None:
    motion = motion_with(law_named("modified-sine"))
    parts = [part for index in zones_of(motion) for part in motion.parts_of(index)]
    which = np.arange(len(parts))
    ends = np.array([part.law_piece.ends for part in parts])
    t = ends[:, :1] + (ends[:, 1:] - ends[:, :1]) * np.array([0.2, 0.7])
    radius = np.full((len(parts), 2), 1e-3)
    together = discs(Parts(parts), which, t, radius, 3)
    for row in range(len(parts)):
        alone = discs(Parts([parts[row]]), np.zeros(1, dtype=int), t[row : row + 1], radius[row : row + 1], 3)
        for order in range(4):
            assert together[order].centre[row].tolist() == alone[order].centre[0].tolist()
            assert together[order].radius[row].tolist() == alone[order].radius[0].tolist()
