"""Paths and ratio laws of planar impacts against the event by event account in many digits, and rows of them."""

import random

import numpy as np
from mpmath import mp, mpf
from references.comparison import cases
from references.impact_events import brach, follow, kudlich_slibar

from dynamics_cli.impact.planar.envelope_grid import impulses, ratio_impulses
from dynamics_cli.impact.planar.laws import LAWS, ON_THE_PATH, Meeting, outcome
from dynamics_cli.impact.planar.path import Mobility, determinant, travel

# The promise of the closed form, relative to the impulse.
PROMISE = 2e-15


def test_there_are_enough_hard_cases() -> None:
    hard = [case for case in cases("impact_rigid.json", "planar") if case["kind"] == "hard"]
    assert len(hard) >= 60
    assert all(case["why"] for case in hard)
    assert {case["inputs"]["law"]["word"] for case in hard} == set(LAWS)


def contact(generator: random.Random) -> tuple[float, ...]:
    """K, velocities, friction, restitution: random, and pushed on purpose to where a branch or a cancellation is."""
    r = generator
    if r.random() < 0.5:
        m1, m2 = r.uniform(800.0, 3000.0), r.uniform(800.0, 3000.0)
        j1, j2 = m1 * r.uniform(1.0, 2.5), m2 * r.uniform(1.0, 2.5)
        a, b, c, d = (r.uniform(-2.5, 2.5) for _ in range(4))
        s = 1.0 / m1 + 1.0 / m2
        kt, kn, kx = s + a * a / j1 + b * b / j2, s + c * c / j1 + d * d / j2, -a * c / j1 - b * d / j2
    else:
        lean = r.uniform(0.0, 3.14)
        s, c = 0.5 * np.sin(lean), 0.5 * np.cos(lean)
        kt, kn, kx = float(1.0 + 12.0 * s * s), float(1.0 + 12.0 * c * c), float(-12.0 * s * c)
    ut, un = r.uniform(-20.0, 20.0), -(10.0 ** r.uniform(-12.0, 1.5))
    mu, e = r.uniform(0.0, 1.2), r.uniform(0.0, 1.0)
    near = r.choice([0.0, 1e-16, -1e-16, 1e-15, -1e-15, 1e-9, -1e-9])
    which = r.randrange(16)
    if which == 0:
        mu = abs(kx) / kt * (1.0 + near)
    elif which == 1:
        e = r.choice([0.0, 1.0])
    elif which == 2:
        ut *= 10.0 ** r.uniform(-18.0, 0.0) * r.choice([0.0, 1.0])
    elif which == 3:
        kx *= 10.0 ** r.uniform(-20.0, -1.0) * r.choice([0.0, 1.0])
    elif which == 4:
        mu = r.choice([0.0, 1e-300, 1e6])
    elif which in (5, 6):
        # slip stops as compression, or as restitution ends
        c = -mu if ut > 0.0 else mu
        slope, change = kn + kx * c, kx + kt * c
        if slope > 0.0 and ut * change < 0.0:
            un = slope * (ut / change) * (1.0 + near) / (1.0 if which == 5 else 1.0 + e)
    elif which == 7:
        scale = 10.0 ** r.uniform(-20.0, 20.0)
        kt, kx, kn = scale * kt, scale * kx, scale * kn
    return kt, kx, kn, ut, un, mu, e


def test_the_path_keeps_its_promise_over_a_thousand_cases() -> None:
    mp.dps = 60
    generator = random.Random(9)
    worst = 0.0
    for _ in range(1000):
        kt, kx, kn, ut, un, mu, e = given = contact(generator)
        k = Mobility(kt, kx, kn, determinant(kt, kx, kn))
        for law in ON_THE_PATH:
            found, exact = travel(k, ut, un, mu, e, law), follow(*given, law)
            size = mp.hypot(exact["normal"], exact["tangential"])
            for name in ("normal", "tangential", "compression"):
                error = float(abs(mpf(getattr(found, name)) - exact[name]) / size)
                assert error <= PROMISE, (law, name, given)
                worst = max(worst, error)
            for name in ("compression_work", "restitution_work", "friction_work"):
                scale = exact["compression_work"] + exact["friction_work"]
                assert abs(mpf(getattr(found, name)) - exact[name]) <= PROMISE * scale, (law, name, given)
    assert worst > 0.0


def test_the_ratio_laws_keep_the_same_promise() -> None:
    mp.dps = 60
    generator = random.Random(10)
    answered = 0
    for _ in range(1000):
        kt, kx, kn, ut, un, mu, e = given = contact(generator)
        k = Mobility(kt, kx, kn, determinant(kt, kx, kn))
        meeting = Meeting(k, ut, un, mu, e, 0.0, 1.0, 1.0, (0.0, 0.0))
        for law, reference in (("brach", brach), ("kudlich-slibar", kudlich_slibar)):
            found = outcome(meeting, law)
            if not found.feasible:
                continue
            pt, pn = reference(*given)
            size = mp.hypot(pt, pn)
            # k_n + c k_x and the critical ratio cancel where they vanish: then the inputs decide, not the rounding
            loose = kn / abs(kn + kx * found.tangential / found.normal) + (abs(ut / un) if kx else 0.0)
            for own, true in ((found.normal, pn), (found.tangential, pt)):
                assert float(abs(mpf(own) - true) / size) <= PROMISE * (1.0 + float(loose)), (law, given)
            answered += 1
    assert answered > 1600


def test_the_fast_path_agrees() -> None:
    generator = random.Random(11)
    rows = [contact(generator) for _ in range(4000)]
    kt, kx, kn, ut, un, mu, e = map(np.array, zip(*rows, strict=True))
    det = np.array([determinant(a, b, c) for a, b, c in zip(kt, kx, kn, strict=True)])
    for law in ON_THE_PATH:
        exact = travel(Mobility(kt, kx, kn, det), ut, un, mu, e, law)
        pn, pt = impulses(kt, kx, kn, det, ut, un, mu, e, law=law)
        size = np.hypot(exact.normal, exact.tangential)
        # plain sums lose a little where K is nearly singular
        assert np.all(np.abs(pn - exact.normal) <= 2e-14 * size), law
        assert np.all(np.abs(pt - exact.tangential) <= 2e-14 * size), law
    for law in ("brach", "kudlich-slibar"):
        meeting = Meeting(Mobility(kt, kx, kn, det), ut, un, mu, e, 0.0 * ut, 1.0, 1.0, (0.0, 0.0))
        found = outcome(meeting, law)
        pn, pt = ratio_impulses(kt, kx, kn, det, ut, un, mu, e, law=law)
        good = found.feasible & (kn + kx * found.tangential / found.normal > 1e-6 * kn)
        assert np.array_equal(np.isfinite(pn[good]), np.ones(good.sum(), dtype=bool))
        size = np.hypot(found.normal, found.tangential) * (1.0 + np.abs(ut / un))
        assert np.all(np.abs(pn - found.normal)[good] <= 1e-9 * size[good]), law
        assert np.all(np.abs(pt - found.tangential)[good] <= 1e-9 * size[good]), law
