"""Coordinates against 40-digit references and against each other: near the axes, tiny and huge, canonical, refused."""

import math
from collections.abc import Callable
from typing import Any

import pytest
from harness import answer
from hypothesis import assume, given
from hypothesis import strategies as st
from references.comparison import cases, disagreements, measure

from dynamics_cli.convert import coords
from dynamics_cli.errors import InadmissibleError

SYSTEMS = ("cartesian", "cylindrical", "spherical")
TASKS = [f"{source}_to_{target}" for source in SYSTEMS for target in SYSTEMS if source != target]
WELL_CONDITIONED = 10.0
COMPONENT = st.floats(-1e3, 1e3).filter(lambda x: x == 0.0 or abs(x) > 1e-3)
WIDE = st.floats(-1e300, 1e300)


def function(task: str) -> Callable[..., Any]:
    return getattr(coords, task)  # type: ignore[no-any-return]


@pytest.mark.parametrize("task", TASKS)
def test_errors_are_below_two_ulps(task: str) -> None:
    for case in cases("coords.json", task):
        for one in measure(function(task), case, {}):
            if one.condition <= WELL_CONDITIONED or abs(one.value) < 1e-300:
                assert one.ulps <= 2.0, one


@pytest.mark.parametrize("task", TASKS)
def test_stated_bound_holds_and_is_tight(task: str) -> None:
    for case in cases("coords.json", task):
        for one in measure(function(task), case, {}):
            assert one.error <= one.bound, one
            assert min(one.excess, one.excess_by_inputs) <= 1.0, one


@pytest.mark.parametrize("task", TASKS)
def test_arrays_give_the_bits_of_scalars(task: str) -> None:
    for seed, case in enumerate(cases("coords.json", task)[:25]):
        assert not disagreements(function(task), case["inputs"], {}, seed)


def close(one: float, other: float, size: float) -> bool:
    return abs(one - other) <= 1e-14 * size


@given(COMPONENT, COMPONENT, COMPONENT)
def test_round_trips(x: float, y: float, z: float) -> None:
    size = math.hypot(x, y, z)
    cylindrical = coords.cartesian_to_cylindrical(x, y, z)
    spherical = coords.cartesian_to_spherical(x, y, z)
    ways = [
        coords.cylindrical_to_cartesian(cylindrical.r, cylindrical.theta, cylindrical.z),
        coords.spherical_to_cartesian(spherical.rho, spherical.phi, spherical.theta),
    ]
    for back in ways:
        assert close(back.x, x, size)
        assert close(back.y, y, size)
        assert close(back.z, z, size)
    around = coords.cylindrical_to_spherical(cylindrical.r, cylindrical.theta, cylindrical.z)
    assert around.rho == pytest.approx(spherical.rho, rel=1e-15)
    assert around.phi == pytest.approx(spherical.phi, rel=1e-15)
    assert around.theta == spherical.theta
    there = coords.spherical_to_cylindrical(spherical.rho, spherical.phi, spherical.theta)
    assert close(there.r, cylindrical.r, size)
    assert close(there.z, z, size)


@given(WIDE, WIDE, WIDE)
def test_results_are_canonical(x: float, y: float, z: float) -> None:
    cylindrical = coords.cartesian_to_cylindrical(x, y, z)
    spherical = coords.cartesian_to_spherical(x, y, z)
    assert cylindrical.r >= 0.0
    assert spherical.rho >= cylindrical.r * (1.0 - 1e-15)
    assert 0.0 <= spherical.phi <= math.pi
    assert -math.pi <= spherical.theta <= math.pi
    assert cylindrical.theta == spherical.theta
    assert math.copysign(1.0, spherical.theta) == 1.0 or y < 0.0


@given(COMPONENT, COMPONENT, COMPONENT, st.integers(-900, 900))
def test_powers_of_two_scale_exactly(x: float, y: float, z: float, power: int) -> None:
    assume(any((x, y, z)))
    factor = 2.0**power
    base = coords.cartesian_to_spherical(x, y, z)
    scaled = coords.cartesian_to_spherical(x * factor, y * factor, z * factor)
    assert scaled.rho == pytest.approx(base.rho * factor, rel=2.3e-16)
    assert scaled.phi == pytest.approx(base.phi, rel=2.3e-16)
    assert scaled.theta == base.theta


@given(st.floats(1e-3, 1e3), st.floats(-1e6, 1e6))
def test_any_turn_comes_back_within_half_a_turn(r: float, theta: float) -> None:
    spherical = coords.cylindrical_to_spherical(r, theta, 1.0)
    assert -math.pi < spherical.theta <= math.pi
    assert math.sin(spherical.theta) == pytest.approx(math.sin(theta), abs=1e-15)
    assert math.cos(spherical.theta) == pytest.approx(math.cos(theta), abs=1e-15)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_near_the_axis_angles_keep_their_digits(sign: float) -> None:
    for small in (1e-5, 1e-20, 1e-200, 5e-324):
        near = coords.cartesian_to_spherical(small, 0.0, sign)
        assert near.phi == (small if sign > 0.0 else math.pi) or small == 1e-5
        assert near.rho == math.hypot(small, 1.0)
        assert not near.advice
    assert coords.cartesian_to_spherical(1e-5, 0.0, 1.0).phi == math.atan(1e-5)


@pytest.mark.parametrize("z", [2.0, -2.0])
def test_on_the_axis_theta_is_zero_and_said_to_be(z: float) -> None:
    for x, y in [(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0), (-0.0, -0.0)]:
        spherical = coords.cartesian_to_spherical(x, y, z)
        assert (spherical.rho, spherical.theta) == (2.0, 0.0)
        assert spherical.phi == (0.0 if z > 0.0 else math.pi)
        assert [one.code for one in spherical.advice] == ["angle-undetermined"]
        assert coords.cartesian_to_cylindrical(x, y, z).advice
    assert coords.cylindrical_to_spherical(0.0, 1.0, z).theta == 0.0
    assert coords.spherical_to_cylindrical(2.0, 0.0, 1.0).theta == 0.0


def test_off_the_axis_by_less_than_a_double_tells_theta_stays() -> None:
    near = coords.spherical_to_cylindrical(1.16e-295, 1.2e-105, -1.676)
    assert (near.r, near.theta, near.advice) == (0.0, -1.676, ())
    assert coords.spherical_to_cylindrical(0.0, 1.0, -1.676).theta == 0.0
    assert coords.spherical_to_cylindrical(0.0, 1.0, -1.676).advice


def test_at_the_origin_both_angles_are_zero_and_said_to_be() -> None:
    for made in (coords.cartesian_to_spherical(0.0, 0.0, 0.0), coords.cylindrical_to_spherical(0.0, 1.0, 0.0)):
        assert (made.rho, made.phi, made.theta) == (0.0, 0.0, 0.0)
        assert [one.code for one in made.advice] == ["angles-undetermined"]


def test_minus_half_a_turn_is_half_a_turn() -> None:
    assert coords.cartesian_to_cylindrical(-1.0, -0.0, 0.0).theta == math.pi
    assert coords.cylindrical_to_spherical(1.0, -math.pi, 0.0).theta == math.pi
    assert coords.cylindrical_to_spherical(1.0, math.pi, 0.0).theta == math.pi


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: coords.cylindrical_to_cartesian(-1.0, 0.0, 0.0), r"r is a distance and cannot be -1: .* 180 degrees"),
        (lambda: coords.cylindrical_to_spherical(-2.5, 0.0, 0.0), r"r is a distance and cannot be -2.5"),
        (lambda: coords.spherical_to_cartesian(-1.0, 0.0, 0.0), r"rho is a distance and cannot be -1"),
        (lambda: coords.spherical_to_cylindrical(1.0, -0.1, 0.0), r"it cannot be -5.7295779\d* degrees"),
        (lambda: coords.spherical_to_cartesian(1.0, 3.2, 0.0), r"it cannot be 183.34649444\d* degrees"),
        (lambda: coords.spherical_to_cartesian(1.0, math.radians(180.0001), 0.0), r"it cannot be 180.0001 degrees"),
        (lambda: coords.spherical_to_cylindrical(1.0, 3.1415926535897936, 0.0), r"\(3.1415926535897936 rad\)"),
        (lambda: coords.cartesian_to_spherical(1.7e308, 1.7e308, 0.0), r"exceeds the largest double, 1.79769e\+308"),
        (lambda: coords.cartesian_to_cylindrical(1.7e308, 1.7e308, 0.0), r"exceeds the largest double"),
    ],
)
def test_refusals_give_the_deciding_number(call: Callable[[], object], message: str) -> None:
    with pytest.raises(InadmissibleError, match=message):
        call()


@pytest.mark.parametrize(
    ("words", "into", "wanted"),
    [
        (["1 m", "90 deg", "0 m"], "cartesian", {"x": 0.0, "y": 1.0}),
        (["1", "100 gon", "0"], "cartesian", {"x": 0.0, "y": 1.0}),
        (["2", "0.5 turn", "1"], "cartesian", {"x": -2.0, "y": 0.0}),
        (["2", "30 deg", "1"], "cartesian", {"y": 1.0}),
    ],
)
def test_quarter_turns_and_sixths_are_exact_as_typed(words: list[str], into: str, wanted: dict[str, float]) -> None:
    results = answer("coords", *words, "--from", "cylindrical", "--into", into)["results"]
    for name, value in wanted.items():
        assert results[name]["value"] == value


def test_right_angles_of_spheres_as_typed() -> None:
    results = answer("coords", "2", "90 deg", "30 deg", "--from", "spherical", "--into", "cartesian")["results"]
    assert (results["y"]["value"], results["z"]["value"]) == (1.0, 0.0)
    results = answer("coords", "2", "180 deg", "30 deg", "--from", "spherical", "--into", "cylindrical")["results"]
    assert (results["r"]["value"], results["z"]["value"]) == (0.0, -2.0)
    # radians are taken at their word
    results = answer("coords", "1", "1.5707963267948966 rad", "0", "--from", "cylindrical", "--into", "cartesian")
    assert results["results"]["x"]["value"] == math.cos(1.5707963267948966) != 0.0
