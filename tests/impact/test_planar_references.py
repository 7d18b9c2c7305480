"""Planar impacts against references in many digits: errors, stated bounds, arrays, checks, derivatives."""

import random
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf
from references.comparison import Measured, cases, leaves
from references.impact_events import brach, follow, kudlich_slibar
from references.impact_particles_comparison import answer, disagreements, flat, measure

from dynamics_cli.impact.planar.envelope_grid import impulses, ratio_impulses
from dynamics_cli.impact.planar.impact import planar
from dynamics_cli.impact.planar.laws import LAWS, ON_THE_PATH, Meeting, outcome
from dynamics_cli.impact.planar.path import Mobility, determinant, travel
from dynamics_cli.numerics.tracked import Tracked

FILE = "impact_rigid.json"
EVERY = cases(FILE, "planar")
WELL_CONDITIONED = 10.0
# The promise of the closed form, relative to the impulse.
PROMISE = 2e-15


def cancels(one: Measured) -> bool:
    """Spins after a jam are the fiftieth part of the two moments whose difference they are."""
    return one.where.startswith("jam") and "spin" in one.where


def measured(case: dict[str, Any]) -> list[Measured]:
    return measure(planar, case)


def test_there_are_enough_hard_cases() -> None:
    hard = [case for case in EVERY if case["kind"] == "hard"]
    assert len(hard) >= 60
    assert all(case["why"] for case in hard)
    assert {case["inputs"]["law"]["word"] for case in hard} == set(LAWS)


def test_results_are_right_to_a_few_ulps_where_well_conditioned() -> None:
    every = [one for case in EVERY for one in measured(case)]
    judged = [one for one in every if one.condition <= WELL_CONDITIONED and not cancels(one)]
    assert len(judged) > len(every) / 2
    worst = max(judged, key=lambda one: one.ulps)
    assert worst.ulps <= 16.0, worst


def test_stated_bound_holds() -> None:
    for case in EVERY:
        for one in measured(case):
            assert one.error <= one.bound, one


def test_stated_bound_is_tight() -> None:
    for case in EVERY:
        for one in measured(case):
            if one.value != 0.0 and not cancels(one):
                assert min(one.excess, one.excess_by_inputs) <= 2.0, one


def test_arrays_give_the_bits_of_scalars() -> None:
    for seed, case in enumerate(EVERY[:30]):
        assert not disagreements(planar, case, seed), case["name"]


def test_checks_pass_and_name_themselves() -> None:
    named = set()
    for case in EVERY:
        result = answer(planar, case["inputs"], list(leaves(case["inputs"])))
        assert all(check.passed for check in result.checks), (case["name"], result.checks)
        named |= {check.name for check in result.checks}
    assert {f"restitution as {law} defines it" for law in LAWS} <= named
    assert len(named) >= 15


def test_derivatives_are_those_of_the_answer() -> None:
    for case in EVERY[:8]:
        tree = case["inputs"]
        numbers = list(leaves(tree))
        tracked = flat(answer(planar, tree, Tracked.inputs(numbers)))
        for index, number in enumerate(numbers):
            step = 1e-6 * max(abs(number), 1e-2)
            ends = []
            for side in (-step, step):
                moved = [value + side if i == index else value for i, value in enumerate(numbers)]
                ends.append(flat(answer(planar, tree, moved)))
            for name, value in tracked.items():
                body = name.partition(".")[0]
                if name.endswith("clock") or (name in (f"{body}.heading", f"{body}.speed") and at_rest(ends, body)):
                    # hours are whole, and a body at rest has no direction
                    continue
                slope = value.slopes[index] if isinstance(value, Tracked) else 0.0
                estimate = (ends[1][name] - ends[0][name]) / (2.0 * step)
                size = abs(ends[1][name]) / max(abs(number), 1e-2) + abs(slope)
                assert slope == pytest.approx(estimate, abs=5e-6 * size + 1e-7), (case["name"], name, index)


def at_rest(ends: list[dict[str, float]], name: str) -> bool:
    """Whether a body hardly moves afterwards."""
    return max(abs(end[f"{name}.velocity[{axis}]"]) for end in ends for axis in (0, 1)) < 1e-3


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


def test_the_path_keeps_its_promise_over_thousands_of_cases() -> None:
    mp.dps = 60
    generator = random.Random(9)
    worst = 0.0
    for _ in range(3000):
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
    for _ in range(3000):
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
    assert answered > 5000


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
