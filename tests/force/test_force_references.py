"""Resultants, wrenches, equivalent systems and reactions against references by other formulas."""

import json
import runpy
import shlex
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from harness import answer
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.force.equilibrium import equilibrium
from dynamics_cli.force.equivalent import Form, equivalent
from dynamics_cli.force.laws.friction import friction
from dynamics_cli.force.laws.masses import AtAltitude, Beside, Particle, first_moment, gravity
from dynamics_cli.force.laws.spring import Ends, spring
from dynamics_cli.force.moment import moment
from dynamics_cli.force.resultant import resultant
from dynamics_cli.force.supports import Holding, Support
from dynamics_cli.force.system import Couple, Load
from dynamics_cli.numerics.exact.typed import TypedNumber

HERE = Path(__file__).parent
REFERENCES: dict[str, Any] = json.loads((HERE / "force.json").read_text(encoding="utf-8"))
ONE_ROUNDING, FEW = 2.0**-53, 4e-16


def typed(text: str) -> Any:
    return tuple(TypedNumber(*Fraction(part).as_integer_ratio()) for part in text.split())


def loads_of(case: Any) -> tuple[Load, ...]:
    return tuple(Load(typed(force), typed(at)) for force, at in case["loads"])


def near(value: Any, text: str, tolerance: float) -> None:
    reference = Fraction(text)
    assert abs(Fraction(value) - reference) <= Fraction(tolerance) * abs(reference) * (1 + Fraction(1, 10**12))


@pytest.mark.parametrize("case", REFERENCES["systems"], ids=lambda case: str(case["name"]))
def test_resultants(case: Any) -> None:
    made = resultant(loads=loads_of(case), couples=tuple(Couple(typed(one)) for one in case["couples"]))
    expected = case["results"]
    assert made.system == expected["system"]
    assert all(check.passed for check in made.checks)
    for name in ("force", "moment", "axis_point"):
        for value, text in zip(getattr(made, name) or (), expected.get(name, ()), strict=True):
            near(value, text, ONE_ROUNDING)
    for name in ("pitch", "wrench_moment", "magnitude"):
        if name in expected:
            near(getattr(made, name), expected[name], FEW)
    if "pitch" not in expected:
        assert made.pitch is None


def test_doubles_that_are_no_decimals_of_fifteen_digits_still_tell_a_couple() -> None:
    """0.1 + 0.2 − 0.3 is 5.6e-17 in doubles, which has an axis 7e15 m away."""
    those = tuple(Load((x, 0.0, 0.0), (0.0, y, 0.0)) for x, y in ((0.1, 0.0), (0.2, 1.0), (-0.3, 2.0)))
    assert resultant(loads=those).system == "couple"


@pytest.mark.parametrize("case", REFERENCES["supported"], ids=lambda case: str(case["name"]))
def test_reactions(case: Any) -> None:
    supports = tuple(Support(Holding(kind), typed(at), typed(way)) for kind, at, way in case["supports"])
    made = equilibrium(loads=loads_of(case), supports=supports)
    assert all(check.passed for check in made.checks)
    for reaction, (x, y) in zip(made.reactions, case["reactions"], strict=True):
        near(reaction.force[0], x, ONE_ROUNDING)
        near(reaction.force[1], y, ONE_ROUNDING)


def test_supports_that_nearly_fail_say_by_how_much() -> None:
    """Three links miss a common point by 1e-9 m."""
    case = next(one for one in REFERENCES["supported"] if one["name"] == "three links that nearly meet")
    supports = tuple(Support(Holding(kind), typed(at), typed(way)) for kind, at, way in case["supports"])
    made = equilibrium(loads=loads_of(case), supports=supports)
    assert made.margin is not None
    assert 1e-10 < made.margin < 1e-9
    assert [one.code for one in made.advice] == ["nearly-improper"]


NUMBERS = st.integers(-9999, 9999).map(lambda n: TypedNumber(n, 100))
VECTORS = st.tuples(NUMBERS, NUMBERS, NUMBERS)
LOADS = st.lists(st.builds(Load, VECTORS, VECTORS), min_size=1, max_size=4).map(tuple)


@settings(max_examples=20, deadline=None)
@given(LOADS, VECTORS, st.sampled_from(["force-couple", "two-forces"]))
def test_an_equivalent_system_has_the_same_resultant(loads: Any, point: Any, form: str) -> None:
    made = equivalent(loads=loads, about=point, form=Form(form))
    assert made.checks[0].passed
    whole = resultant(loads=loads)
    assert made.second_force is not None or made.force == whole.force


@settings(max_examples=20, deadline=None)
@given(VECTORS, VECTORS, VECTORS, VECTORS)
def test_the_moment_about_a_line_is_the_same_for_each_of_its_points(force: Any, at: Any, about: Any, axis: Any) -> None:
    if not any(axis):
        return
    one = moment(force=force, at=at, about=about, axis=axis).about_line
    moved = tuple(a + 3 * b for a, b in zip(about, axis, strict=True))
    other = moment(force=force, at=at, about=moved, axis=axis).about_line
    assert one == pytest.approx(other, rel=1e-9, abs=1e-6)


@settings(max_examples=15, deadline=None)
@given(LOADS)
def test_reactions_of_a_shaft_in_space_put_back_give_zero(loads: Any) -> None:
    supports = (
        Support(Holding("ball"), (0.0, 0.0, 0.0)),
        Support(Holding("cable"), (1.0, 0.0, 0.0), (0.0, 1.0, 0.5)),
        Support(Holding("link"), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)),
        Support(Holding("link"), (0.0, 2.0, 0.0), (0.0, 0.5, 1.0)),
    )
    made = equilibrium(loads=loads, supports=supports)
    assert made.checks[0].passed
    everything = (*loads, *(Load(one.force, one.at) for one in made.reactions))
    whole = resultant(loads=everything)
    size = sum(abs(x) for load in everything for x in load.force) + 1.0
    assert max(map(abs, whole.force)) <= 1e-14 * size
    assert max(map(abs, whole.moment)) <= 1e-12 * size


def test_a_spring_stretched_by_less_than_its_length_resolves() -> None:
    """√(1 + 1e-16) − 1 is zero in doubles."""
    made = spring(place=Ends((0.0, 0.0, 0.0), (1.0, 1e-8, 0.0)), stiffness=1e6, free_length=1.0)
    near(made.stretch, "4.999999999999999875e-17", FEW)
    near(made.tension, "4.999999999999999875e-11", 6e-16)


@pytest.mark.parametrize("case", REFERENCES["bounded"], ids=lambda case: str(case["call"])[:60])
def test_errors_are_within_stated_bounds(case: Any) -> None:
    made = answer("force", *shlex.split(case["call"]), "--units", "base")
    for name, text in case["results"].items():
        bound = made["numerics"]["error_bound"][name]
        value = Fraction(made["results"][name]["value"])
        allowed = Fraction(bound.get("relative", 0.0)) * abs(value) + Fraction(bound.get("absolute", 0.0))
        error = abs(value - Fraction(text))
        assert error <= allowed, name
        assert allowed <= 100 * max(error, Fraction(2.0**-54) * abs(value)), name


def test_first_moment_about_the_mass_centre_is_zero() -> None:
    those = Particle(0.1, (0.7, 0.1, 0.0)), Particle(0.2, (0.1, 0.4, 0.0)), Particle(0.5, (0.3, 0.3, 8.0))
    centre = first_moment(particles=those).centre
    near(centre[0], "0.3", FEW)
    near(centre[2], "5.0", FEW)
    assert max(map(abs, first_moment(particles=those, about=centre).first_moment)) < 1e-16


def test_gravity_of_the_earth_both_ways() -> None:
    """The earth's mass and mean radius give standard gravity to two parts in a thousand."""
    one = gravity(mass=2.0, place=AtAltitude(1e6))
    assert one.force == pytest.approx(2.0 * 9.80665 * (6371.0 / 7371.0) ** 2, rel=1e-15)
    other = gravity(mass=2.0, place=Beside(5.972e24, 7371e3))
    assert other.force == pytest.approx(one.force, rel=2e-3)


def test_a_block_at_its_limits_is_in_equilibrium_with_the_normal_force_at_the_edge_or_full_friction() -> None:
    call = {"mass": 30.0, "angle": 0.2, "width": 0.4, "centre_height": 0.5, "push_height": 0.9}
    tips = friction(friction=2.0, **call)
    assert tips.largest_push is not None
    assert friction(friction=2.0, push=tips.largest_push, **call).pressure_point == pytest.approx(0.2, rel=1e-14)
    up = friction(friction=0.3, push=10.0, **call | {"push_height": 0.1})
    assert up.largest_push is not None
    edge = friction(friction=0.3, push=up.largest_push, **call | {"push_height": 0.1})
    assert edge.needed_friction == pytest.approx(0.3, rel=1e-14)


def test_generating_again_gives_the_same_bytes(tmp_path: Path) -> None:
    made = tmp_path / "force.json"
    runpy.run_path(str(HERE.parent / "references" / "generate_force_references.py"))["main"](made)
    assert made.read_bytes() == (HERE / "force.json").read_bytes()
