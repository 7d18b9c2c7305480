"""Bounds of chains: true and tight on every shipped case, and where masses, speeds or restitutions are far apart."""

from fractions import Fraction
from itertools import pairwise
from typing import Any

import pytest
from references.comparison import cases
from references.impact_particles_comparison import answer, flat
from references.impact_particles_tasks import TASKS

from dynamics_cli.accuracy.cases import leaves
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.impact.particles.chain import Body, ChainLaw, chain

UNIT_ROUNDOFF = Fraction(1, 2**53)
EVERY = cases("impact_particles.json", "chain")


def stated(result: Any) -> dict[str, Fraction]:
    """The bound on every result, as an absolute number."""
    values = flat(result)
    return {
        one.result: Fraction(one.bound) * (abs(Fraction(values[one.result])) if one.relative else 1)
        for one in result.numerics.bounds
    }


def judge(result: Any, exact: dict[str, Fraction]) -> None:
    """Every bound holds, and is no more than a hundred times the error or half a last bit."""
    values, bounds = flat(result), stated(result)
    for name, true in exact.items():
        error = abs(Fraction(values[name]) - true)
        assert error <= bounds[name], name
        assert not true or bounds[name] <= 100 * max(error, UNIT_ROUNDOFF * abs(true)), name


@pytest.mark.parametrize("case", EVERY, ids=lambda case: case["name"])
def test_every_shipped_result_has_a_bound_that_is_true_and_tight(case: dict[str, Any]) -> None:
    result = answer(TASKS["chain"], case["inputs"], list(leaves(case["inputs"])))
    exact = {name: Fraction(text) for name, text in case["results"].items()}
    # the references are rounded to 40 digits
    exact = {name: true for name, true in exact.items() if not name.endswith((".body", ".collisions"))}
    values, bounds = flat(result), stated(result)
    for name, true in exact.items():
        error = abs(Fraction(values[name]) - true)
        assert error <= bounds.get(name, 0) + abs(true) / 10**39, name
        assert not true or bounds[name] <= 100 * max(error, UNIT_ROUNDOFF * abs(true)), name


def in_turn(masses: list[float], velocities: list[float], ratios: list[float]) -> dict[str, Fraction]:
    """Pairs one after another in rational numbers."""
    m, v, e = (list(map(Fraction, numbers)) for numbers in (masses, velocities, ratios))
    start, pushes, lost = list(v), [Fraction(0)] * len(e), Fraction(0)
    while True:
        closing = [a - b for a, b in pairwise(v)]
        i = closing.index(max(closing))
        if closing[i] <= 0:
            break
        reduced = m[i] * m[i + 1] / (m[i] + m[i + 1])
        push = (1 + e[i]) * reduced * closing[i]
        lost += (1 - e[i] * e[i]) * reduced * closing[i] ** 2 / 2
        pushes[i] += push
        v[i], v[i + 1] = v[i] - push / m[i], v[i + 1] + push / m[i + 1]
    found = {"laws[0].energy_lost": lost}
    for i, speed in enumerate(v):
        found |= {f"bodies[{i}].velocity": speed, f"bodies[{i}].delta_v": speed - start[i]}
    return found | {f"bodies[{i}].impulse_to_next": push for i, push in enumerate(pushes)}


@pytest.mark.parametrize(
    ("masses", "velocities", "ratios"),
    [
        # closing speeds of one last bit
        ([1.0, 1.0, 1.0], [1.0, 1.0 - 2.0**-53, 1.0 - 2.0**-52], [0.5, 0.5]),
        # a speck between planets
        ([3e24, 2e-15, 5e23], [1e-3, 0.0, 1.0], [1.0, 0.0]),
        # balls that differ by one last bit: what the first keeps is a product of two such differences
        ([1.0, 1.0, 1.0000000000000002], [1.0000000000000002, 0.0, 0.0], [0.9999999999999998] * 2),
        # a fast body far behind slow ones
        ([1.0, 2.0, 4.0], [1e30, 1e-9, 1e-10], [0.75, 0.25]),
        # elastic: nothing is lost, not a little
        ([1.0, 3.0, 0.5, 2.0], [2.0, 0.0, 0.0, -1.0], [1.0, 1.0, 1.0]),
    ],
)
def test_pairs_in_turn_are_those_of_rational_numbers(
    masses: list[float], velocities: list[float], ratios: list[float]
) -> None:
    bodies = tuple(map(Body, masses, velocities, [*ratios, None]))
    judge(chain(bodies=bodies, restitution=0.0, law=ChainLaw("sequential")), in_turn(masses, velocities, ratios))


def test_a_pair_that_hardly_closes_still_collides() -> None:
    bodies = Body(2.0, 1.0), Body(2.0, 1.0 - 2.0**-53)
    for law in ("sequential", "simultaneous"):
        found = chain(bodies=bodies, restitution=1.0, law=ChainLaw(law))
        assert [one.delta_v for one in found.bodies] == [-(2.0**-53), 2.0**-53]
        assert found.laws[0].collisions == 1


def test_pairs_that_come_to_rest_in_ever_more_collisions_end_as_one_body() -> None:
    # without rebound and squeezed between equals, the limit is the common velocity
    bodies = Body(4.0, 1.0), Body(1.0), Body(4.0, -0.5)
    found = chain(bodies=bodies, restitution=0.0, law=ChainLaw("sequential"))
    common = Fraction(2, 9)
    assert found.laws[0].collisions > 50
    bounds = stated(found)
    for i, one in enumerate(found.bodies):
        error = abs(Fraction(one.velocity) - common)
        assert error <= bounds[f"bodies[{i}].velocity"] <= 3 * UNIT_ROUNDOFF * common


def test_collisions_that_are_left_out_are_in_the_bound() -> None:
    # collisions die down so slowly that they are cut off long before they are nothing
    bodies = Body(170.0, 1.0), Body(1.0), Body(170.0, -1.0)
    found = chain(bodies=bodies, restitution=0.0, law=ChainLaw("sequential"))
    assert found.laws[0].collisions > 8000
    for i, one in enumerate(found.bodies):
        assert abs(Fraction(one.velocity)) <= stated(found)[f"bodies[{i}].velocity"]
    with pytest.raises(InadmissibleError, match="go on colliding"):
        chain(bodies=(Body(1e6, 1.0), Body(1.0), Body(1e6, -1.0)), restitution=0.0, law=ChainLaw("sequential"))


def test_unlike_restitutions_at_one_moment_hold_their_bounds() -> None:
    # found by search: rounds go on, ever more slowly
    bodies = (
        Body(1.0, 0.0, 0.0),
        Body(1.0, 0.0, 0.9987380791854007),
        Body(0.0013881145363659484, 0.0, 0.0),
        Body(1.0, -3.3715063536501244),
    )
    found = chain(bodies=bodies, restitution=0.0, law=ChainLaw("simultaneous"))
    m, v = [Fraction(body.mass) for body in bodies], [Fraction(body.velocity) for body in bodies]
    after = [Fraction(one.velocity) for one in found.bodies]
    bounds = stated(found)
    room = sum(mass * bounds[f"bodies[{i}].velocity"] for i, mass in enumerate(m))
    assert abs(sum(a * (x - y) for a, x, y in zip(m, v, after, strict=True))) <= room
    lost = sum(a * (x * x - y * y) for a, x, y in zip(m, v, after, strict=True)) / 2
    assert abs(lost - Fraction(found.laws[0].energy_lost)) <= bounds["laws[0].energy_lost"] + 8 * room
    assert all(one.bound <= 3.0 * 2.0**-53 for one in found.numerics.bounds if one.relative)  # type: ignore[union-attr]
