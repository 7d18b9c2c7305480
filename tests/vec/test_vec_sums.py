"""Sums, directions, angles and products: the hard cases, both sides of every switch, invariants, refusals."""

import math
from typing import Any

import pytest
from harness import answer, run
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.vec.angles import angle
from dynamics_cli.vec.products import product
from dynamics_cli.vec.sums import direction, resultant

FEW = settings(max_examples=25, deadline=None)
COMPONENT = st.floats(-100.0, 100.0).map(lambda x: round(x, 3))
VECTOR = st.tuples(COMPONENT, COMPONENT, COMPONENT).filter(lambda v: math.hypot(*v) > 0.1)
LAST_BITS = 4e-16


def refusal(*argv: str) -> tuple[int, str, str]:
    outcome = run("vec", *argv, "--json")
    return outcome.status, outcome.error["code"], outcome.error["message"]


def turned(v: tuple[float, ...], a: float, b: float) -> tuple[float, ...]:
    """A rotation about z and then about x."""
    x, y, z = v
    x, y = x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a)
    return x, y * math.cos(b) - z * math.sin(b), y * math.sin(b) + z * math.cos(b)


def test_v1_to_v3_small_angles_keep_their_digits() -> None:
    assert angle((1.0, 0.0, 0.0), (1.0, 1e-9, 0.0)).angle == pytest.approx(9.9999999999999999967e-10, rel=LAST_BITS)
    near = angle((1.0, 1.0, 1.0), (1.0, 1.0, 1.0 + 2.0**-40)).angle
    assert near == pytest.approx(4.2873991405111953065826e-13, rel=LAST_BITS)
    opposite = angle((1.0, 2.0, 3.0), (-1.0, -2.0, -3.0 - 2.0**-30))
    assert opposite.supplement == pytest.approx(1.4875004181462337202717e-10, rel=LAST_BITS)


def test_v4_direction_angles() -> None:
    results = answer("vec", "direction", "8, 12, 7 m")["results"]
    assert results["magnitude"] == {"value": pytest.approx(16.031219541881397365, rel=LAST_BITS), "unit": "m"}
    degrees = [results[f"angle_{axis}"]["value"] for axis in "xyz"]
    assert degrees == pytest.approx(
        [60.064399303475972531, 41.535982948506546886, 64.109794681494910813], rel=LAST_BITS
    )


def test_v8_and_v9_decimals_decide() -> None:
    assert product((0.1, 0.2, 0.3), (0.4, 0.5, 0.6), (0.7, 0.8, 0.9)).triple_product.value == 0.0
    assert product((1.0, 2.0, 3.0), (4.0, 5.0, 6.0), (7.0, 8.0, 9.0000000001)).triple_product.value == -3e-10
    said = [product((0.1, 0.2, 0.3), (0.4, 0.5, 0.6), (0.7, 0.8, z)).coplanar for z in (0.9, 0.9 + 2e-16, 0.91)]
    assert said[0] == "coplanar, exactly as typed"
    assert said[1] is not None
    assert said[1].startswith("coplanar within rounding (")
    assert said[2] == "not coplanar, left-handed"


def test_v10_a_long_thin_triangle() -> None:
    assert product((1e8, 1.0), (2e8, 2.00000001)).triangle.value == 0.5


@pytest.mark.parametrize(
    ("second", "relation"),
    [
        ((0.3, 0.6, 0.9), "parallel, exactly as typed"),
        ((-0.3, -0.6, -0.9), "opposite, exactly as typed"),
        ((0.3, 0.6, 0.9000000000000002), "parallel within rounding (sine 1.3e-16)"),
        ((0.3, 0.6, 0.90000000000002), "oblique"),
        ((-0.2, 0.1, 0.0), "perpendicular, exactly as typed"),
        ((-0.2, 0.1, 1e-13), "oblique"),
    ],
)
def test_relations_say_how_they_are_known(second: tuple[float, ...], relation: str) -> None:
    assert angle((0.1, 0.2, 0.3), second).relation == relation


@pytest.mark.parametrize("size", [1e-300, 1e-61, 1e-59, 1e59, 1e61, 1e200, 1e307])
def test_sizes_near_the_ends_of_doubles(size: float) -> None:
    between = angle((size, 0.0, 0.0), (size, size, 0.0))
    assert between.angle == pytest.approx(math.pi / 4, rel=LAST_BITS)
    square = angle((size, 0.0, 0.0), (0.0, size, 0.0))
    assert square.relation == "perpendicular, exactly as typed"


@FEW
@given(VECTOR, VECTOR, st.floats(-3.0, 3.0), st.floats(-3.0, 3.0))
def test_angles_do_not_depend_on_the_axes(a: Any, b: Any, turn: float, tilt: float) -> None:
    here, there = angle(a, b), angle(turned(a, turn, tilt), turned(b, turn, tilt))
    assert there.angle == pytest.approx(here.angle, rel=1e-12, abs=1e-14)
    assert here.angle + here.supplement == pytest.approx(math.pi, rel=1e-15)
    assert angle(b, a).angle == here.angle


@FEW
@given(VECTOR, VECTOR, VECTOR)
def test_double_products_obey_jacobi(a: Any, b: Any, c: Any) -> None:
    sums = [product(*those).first_with_product.value for those in ((a, b, c), (b, c, a), (c, a, b))]
    size = max(abs(x) for one in sums for x in one)
    assert [sum(parts) for parts in zip(*sums, strict=True)] == pytest.approx([0.0] * 3, abs=1e-15 * size + 1e-300)
    assert product(a, b, c).triple_product.value == product(b, c, a).triple_product.value


@FEW
@given(st.lists(VECTOR, min_size=1, max_size=5))
def test_the_equilibrant_balances(vectors: list[Any]) -> None:
    whole = resultant(*vectors)
    nothing = resultant(*vectors, whole.equilibrant.value)
    assert nothing.magnitude.value <= 1e-12 * sum(math.hypot(*v) for v in vectors)
    assert whole.cancellation is None or whole.cancellation >= 1.0 - 1e-15


def test_equilibrium_is_seen_in_the_decimals() -> None:
    document = answer("vec", "resultant", "0.1, 0.2 N", "0.2, 0.1 N", "-0.3, -0.3 N")
    assert document["results"]["magnitude"]["value"] == 0.0
    assert document["results"]["direction"] is None
    assert [one["code"] for one in document["warnings"]] == ["equilibrium"]
    almost = answer("vec", "resultant", "0.1, 0.2 N", "0.2, 0.1 N", "-0.3, -0.3000001 N")
    assert [one["code"] for one in almost["warnings"]] == ["cancellation"]
    assert not answer("vec", "resultant", "0.1, 0.2 N", "0.2, 0.1 N", "-0.3, -0.30001 N")["warnings"]


def test_a_signed_angle_is_the_turn_about_the_axis() -> None:
    for axis, sign in (((0.0, 0.0, 2.0), 1.0), ((0.0, 0.0, -0.5), -1.0)):
        signed = angle((1.0, 0.0, 3.0), (0.0, 2.0, -5.0), axis=axis)
        assert signed.angle == pytest.approx(sign * math.pi / 2, rel=LAST_BITS)
    assert refusal("angle", "0, 0, 1", "0, 1, 0", "--axis", "0, 3, 0")[:2] == (3, "parallel-axis")


@pytest.mark.parametrize(
    ("argv", "status", "code"),
    [
        (("angle", "0, 0, 0", "1, 1, 1"), 3, "zero-vector"),
        (("direction", "1, 2 m", "1, 2 m"), 3, "zero-vector"),
        (("direction", "1, 2 m", "1, 2 N"), 3, "mixed-kinds"),
        (("resultant", "1, 2 N", "1, 2 m/s"), 3, "mixed-kinds"),
        (("resultant", "1, 2 N", "30 N*m"), 3, "no-direction"),
        (("resultant", "15 N", "12 m", "--between", "60 deg"), 3, "mixed-kinds"),
        (("resultant", "15 N", "--between", "60 deg"), 3, "magnitudes"),
        (("resultant",), 3, "missing"),
        (("angle", "1, 2, 3, 4", "1, 1, 1"), 2, "components"),
        (("angle", "20 N @ 30", "1, 1, 1"), 2, "missing-unit"),
        (("angle", "20 N @ 30, 40, 50 deg", "1, 1, 1"), 2, "direction-angles"),
        (("angle", "20 N along 0, 0, 0", "1, 1, 1"), 2, "zero-vector"),
        (("angle", "20 N from 1, 2 to 1, 2 m", "1, 1, 1"), 2, "zero-vector"),
        (("angle", "1, x, 2", "1, 1, 1"), 2, "number"),
        (("angle", "20, 30 degC", "1, 1"), 2, "kind"),
    ],
)
def test_refusals(argv: tuple[str, ...], status: int, code: str) -> None:
    assert refusal(*argv)[:2] == (status, code)


@pytest.mark.parametrize(
    ("written", "components"),
    [
        ("20 N @ 90 deg", [0.0, 20.0]),
        ("20 N ∠ 90°", [0.0, 20.0]),
        ("20 N at 90 deg", [0.0, 20.0]),
        ("3i - 4j N", [3.0, -4.0]),
        ("(2k - i) N", [-1.0, 0.0, 2.0]),
        ("30 N along 1, 2, 2", [10.0, 20.0, 20.0]),
        ("30 N @ (1, 2, 2)", [10.0, 20.0, 20.0]),
        ("70 N @ (60, 45, 60 deg)", [35.0, 49.49747468305833, 35.0]),
        ("30 N along 3, 4", [18.0, 24.0]),
        ("30 N from 1, 0, 0 ft to 2, 2, 2 ft", [10.0, 20.0, 20.0]),
        ("10 N @ 60, 60, 45 deg", [5.0, 5.0, 10.0 / math.sqrt(2.0)]),
        ("3 kN, 4000 N", [3000.0, 4000.0]),
    ],
)
def test_a_vector_may_be_written_in_many_ways(written: str, components: list[float]) -> None:
    document = answer("vec", "resultant", written, "--units", "base")
    assert document["results"]["resultant"]["value"] == pytest.approx(components, rel=1e-15, abs=1e-14)
    again = answer(
        "vec", "resultant", "--input", "-", "--units", "base", stdin=str(document["inputs"]).replace("'", '"')
    )
    assert again["results"] == document["results"]


def test_units_are_those_that_were_written_and_kinds_are_multiplied() -> None:
    assert answer("vec", "resultant", "30 mph @ 45 deg")["results"]["magnitude"]["unit"] == "mph"
    assert answer("vec", "resultant", "20, 10 N", "--units", "us")["results"]["magnitude"]["unit"] == "lbf"
    units = {}
    pairs = {"1, 2 ft": "3, 4 lbf", "1, 2 m": "3, 4 N", "1, 2 mm": "3, 4 mm", "1, 2 rad/s": "3, 4 m"}
    for first, second in {**pairs, "1, 2 m/s": "3, 4 kg/s"}.items():
        results = answer("vec", "product", first, second)["results"]
        units[first, second] = results["scalar_product"].get("unit"), results["vector_product"].get("unit")
    assert units["1, 2 ft", "3, 4 lbf"] == ("ft·lbf", "lbf·ft")
    assert units["1, 2 m", "3, 4 N"] == ("J", "N·m")
    assert units["1, 2 mm", "3, 4 mm"] == ("mm²", "mm²")
    assert units["1, 2 rad/s", "3, 4 m"][1] == "m/s"
    assert answer("convert", f"1 {units['1, 2 m/s', '3, 4 kg/s'][0]}", "N")["results"]["value"]["value"] == 1.0


def test_results_are_inputs_elsewhere(tmp_path: Any) -> None:
    file = tmp_path / "sum.json"
    outcome = run("vec", "resultant", "20 ± 1 m @ 30 deg", "15, 3 m", "--output", str(file))
    assert outcome.status == 0, outcome.err
    inner = answer("vec", "direction", f"@{file}:resultant")["results"]
    assert inner["magnitude"]["value"] == pytest.approx(34.837, abs=1e-3)
    # both components vary together, as they came from one magnitude
    assert inner["magnitude"]["std"] == pytest.approx(math.cos(math.radians(30.0 - inner["angle"]["value"])), rel=1e-3)


def test_rows_equal_single_answers() -> None:
    rows = 'first,second\n"1,2,3","4,5,6"\n"20 N @ 30 deg","3, 4, 5 m"\n"0,0,0","1,1,1"\n'
    outcome = run("vec", "angle", "--rows", "-", stdin=rows)
    assert outcome.status == 4
    _, pure, mixed, refused = outcome.out.splitlines()
    one = answer("vec", "angle", "1,2,3", "4,5,6")["results"]
    assert pure.split('",')[-1].split(",")[0] == repr(one["angle"]["value"])
    two = answer("vec", "angle", "20 N @ 30 deg", "3, 4, 5 m")["results"]
    assert mixed.split('",')[-1].split(",")[0] == repr(two["angle"]["value"])
    assert refused.endswith('"the first vector is a zero vector, which has no direction"')


def test_uncertain_magnitudes_and_directions() -> None:
    results = answer("vec", "resultant", "20 ± 1 N @ 30 ± 2 deg", "15, 3 N")["results"]
    assert results["magnitude"]["std"] == pytest.approx(0.996, abs=0.01)
    assert results["angle"]["std"] == pytest.approx(1.163, abs=0.02)


@pytest.mark.parametrize(("first", "second"), [((3.0, 4.0), (4.0, -3.0)), ((3.0, 4.0, 0.0), (0.0, 0.0, 2.0))])
def test_direction_from_one_point_to_another(first: Any, second: Any) -> None:
    way = direction(first, second)
    assert way.vector.value == tuple(b - a for a, b in zip(first, second, strict=True))
    assert (way.angle is None) == (len(first) == 3)


def test_a_direction_is_swept() -> None:
    swept = answer("vec", "resultant", "3 N @ 20 deg", "4, 0 N", "--sweep", "vectors[0].direction=0:180 deg:3")
    table = swept["results"]["sweep"]
    assert table["magnitude"] == {"value": pytest.approx([7.0, 5.0, 1.0], rel=LAST_BITS), "unit": "N"}
    sized = answer("vec", "angle", "3 N @ 20 deg", "4, 0 N", "--sweep", "first.magnitude=1:2 N:2")["results"]["sweep"]
    assert sized["angle"]["value"] == pytest.approx([20.0, 20.0], rel=LAST_BITS)


def test_other_families_read_the_vectors(tmp_path: Any) -> None:
    file = tmp_path / "turn.json"
    assert run("vec", "resultant", "2 rad/s along 0, 3, 4", "1, 0, 0 rad/s", "--output", str(file)).status == 0
    tensor = "[[2, 0, 0], [0, 3, 0], [0, 0, 4]] kg*m^2"
    given_ = answer("inertia", "torque", "--tensor", tensor, "--angular-velocity", f"@{file}:resultant")
    typed = answer("inertia", "torque", "--tensor", tensor, "--angular-velocity", "1, 1.2, 1.6 rad/s")
    names = ("inertia_torque", "angular_momentum")
    for name in names:
        assert given_["results"][name]["value"] == pytest.approx(typed["results"][name]["value"], rel=1e-15)


def test_two_and_three_forces_of_the_book() -> None:
    """15 and 12 N at 60 deg, then 10 N square to both: √549 and √649."""
    two = resultant(15.0, 12.0, between=math.pi / 3.0)
    assert two.magnitude.value == pytest.approx(math.sqrt(549.0), rel=1e-15)
    flat = (21.0, 12.0 * math.sin(math.pi / 3.0), 0.0)
    assert resultant(flat, (0.0, 0.0, 10.0)).magnitude.value == pytest.approx(math.sqrt(649.0), rel=1e-15)
