"""Components, polygons, triads, lines, matrices: the hard cases, both sides of every switch, invariants, refusals."""

import math
from fractions import Fraction
from typing import Any

import pytest
from harness import answer, run
from hypothesis import given, reject, settings
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.vec.frame import frame
from dynamics_cli.vec.lines import Item, lines
from dynamics_cli.vec.matrix import matrix
from dynamics_cli.vec.polygon import polygon
from dynamics_cli.vec.resolve import Along, Basis, Plane, resolve

FEW = settings(max_examples=25, deadline=None)
COMPONENT = st.floats(-10.0, 10.0).map(lambda x: round(x, 2))
VECTOR = st.tuples(COMPONENT, COMPONENT, COMPONENT).filter(lambda v: math.hypot(*v) > 0.1)
LAST_BITS = 4e-16


def code(*argv: str) -> tuple[int, str]:
    outcome = run("vec", *argv, "--json")
    return outcome.status, outcome.error["code"]


def test_v6_an_oblique_basis() -> None:
    basis = Basis((1.0, 0.0, 0.0), (1.0, 1e-6, 0.0), (1.0, 1.0, 1e-3))
    made = resolve((2.0, 3.0, 4.0), onto=basis)
    assert made.components is not None
    coefficients = [row.coefficient.value for row in made.components]
    assert coefficients == pytest.approx([3996996002.0, -3997000000.0, 4000.0], rel=LAST_BITS)
    assert [one.code for one in made.advice] == ["condition"]


@FEW
@given(VECTOR, VECTOR)
def test_parts_along_and_across_are_square_and_add_up(v: Any, n: Any) -> None:
    made = resolve(v, onto=Along(n))
    size = math.hypot(*v)
    along, across = made.part_along.value, made.part_across.value
    assert [p + q for p, q in zip(along, across, strict=True)] == pytest.approx(v, abs=1e-14 * size)
    assert sum(p * q for p, q in zip(along, across, strict=True)) == pytest.approx(0.0, abs=1e-13 * size * size)
    plane = resolve(v, onto=Plane(n))
    assert (plane.out_of_plane.value, plane.in_plane.value) == (made.component.value, made.across.value)
    assert plane.angle == pytest.approx(math.pi / 2 - made.angle, abs=1e-14)


@FEW
@given(VECTOR, VECTOR, VECTOR, VECTOR)
def test_parts_in_a_basis_add_up_and_the_reciprocal_basis_is_dual(v: Any, a: Any, b: Any, c: Any) -> None:
    try:
        made = resolve(v, onto=Basis(a, b, c))
    except InadmissibleError:
        reject()
    assert made.components is not None
    duals = [row.reciprocal.value for row in made.components]
    for i, dual in enumerate(duals):
        for j, given_ in enumerate((a, b, c)):
            assert sum(p * q for p, q in zip(dual, given_, strict=True)) == pytest.approx(
                float(i == j), abs=1e-13 * made.condition
            )


@pytest.mark.parametrize(("z", "refused"), [(1.0, True), (1.0 + 2.0**-51, True), (1.0 + 1e-14, False)])
def test_a_basis_in_one_plane_is_refused(z: float, refused: bool) -> None:
    basis = Basis((1.0, 0.0, 1.0), (0.0, 1.0, 0.0), (1.0, 1.0, z))
    if refused:
        with pytest.raises(InadmissibleError, match="lie in one plane"):
            resolve((1.0, 2.0, 3.0), onto=basis)
    else:
        assert resolve((1.0, 2.0, 3.0), onto=basis).condition > 1e13


def test_v11_both_solutions() -> None:
    table = answer("vec", "polygon", "--sum", "6, 2", "--magnitudes", "5, 4")["results"]["solutions"]
    degrees = sorted((row["first_angle"]["value"], row["second_angle"]["value"]) for row in table)
    assert degrees[0] == pytest.approx((-20.781951583510463734, 70.650592154056043705), rel=LAST_BITS)
    assert degrees[1] == pytest.approx((57.651849229354485031, -33.780694508212022408), rel=LAST_BITS)


@pytest.mark.parametrize(("a", "solutions"), [(0.1, 1), (0.1 + 2e-16, 2), (0.2, 2), (0.9, 1)])
def test_a_polygon_that_just_closes(a: float, solutions: int) -> None:
    # 0.1 + 0.4 = |(0.3, 0.4)| as typed, and 0.9 − 0.4
    assert len(polygon(sum_=(0.3, 0.4), magnitudes=(a, 0.4)).solutions) == solutions


@pytest.mark.parametrize(("a", "gap"), [(0.0999, "0.0001"), (0.9001, "0.0001")])
def test_a_polygon_that_does_not_close_names_the_gap(a: float, gap: str) -> None:
    outcome = run("vec", "polygon", "--sum", "0.3, 0.4 kN", "--magnitudes", f"{a}, 0.4 kN")
    assert outcome.status == 3
    assert f"{gap} kN" in outcome.err


@FEW
@given(COMPONENT, COMPONENT, st.floats(0.1, 3.0), st.floats(-3.0, 3.0))
def test_polygons_close_with_what_was_given(x: float, y: float, turn: float, start: float) -> None:
    made = polygon((1.0, 2.0), sum_=(x, y), directions=(start, start + turn))
    one = made.solutions[0]
    for axis, whole in enumerate((x, y)):
        parts = one.first.value[axis], one.second.value[axis], (1.0, 2.0)[axis]
        assert sum(parts) == pytest.approx(whole, abs=1e-12 * (1.0 + max(map(abs, parts))))
    assert (one.first_angle, one.second_angle) == (start, start + turn)
    mixed = polygon(sum_=(x, y), magnitudes=(20.0,), directions=(start,))
    for each in mixed.solutions:
        assert math.hypot(*each.first.value) == pytest.approx(20.0, rel=1e-14)


@FEW
@given(VECTOR, VECTOR, VECTOR)
def test_a_triad_is_right_handed_and_keeps_lengths(x: Any, y: Any, v: Any) -> None:
    try:
        made = frame(x=x, y=y, vector=v)
    except InadmissibleError:
        reject()
    rows = list(zip(*made.rotation_matrix, strict=True))
    third = rows[0][1] * rows[1][2] - rows[0][2] * rows[1][1]
    assert third == pytest.approx(rows[2][0], abs=1e-14)
    assert math.hypot(*made.components.value) == pytest.approx(math.hypot(*v), rel=1e-14)
    back = [sum(rows[i][j] * made.components.value[i] for i in range(3)) for j in range(3)]
    assert back == pytest.approx(v, abs=1e-13)


@pytest.mark.parametrize("names", ["xy", "yz", "xz"])
def test_any_two_directions_make_the_same_triad(names: str) -> None:
    axes = {"x": (0.6, 0.8, 0.0), "y": (-0.8, 0.6, 0.0), "z": (0.0, 0.0, 1.0)}
    made = frame(**{name: axes[name] for name in names})
    assert (made.x_axis.value, made.y_axis.value, made.z_axis.value) == (axes["x"], axes["y"], axes["z"])
    assert made.departure == 0.0


def test_three_directions_show_their_handedness() -> None:
    right = frame(x=(1.0, 0.0, 0.0), y=(0.0, 1.0, 0.0), z=(0.0, 0.1, 1.0))
    assert (right.handedness, right.advice) == ("right-handed", ())
    assert right.departure == pytest.approx(math.atan(0.1), rel=1e-15)
    left = frame(x=(1.0, 0.0, 0.0), y=(0.0, 1.0, 0.0), z=(0.0, 0.1, -1.0))
    assert left.handedness == "left-handed"
    assert left.z_axis.value == (0.0, 0.0, 1.0)


def test_three_points_make_a_triad() -> None:
    made = frame((1.0, 1.0, 1.0), (1.0, 3.0, 1.0), (0.0, 9.0, 1.0))
    assert (made.x_axis.value, made.y_axis.value) == ((0.0, 1.0, 0.0), (-1.0, 0.0, 0.0))


def test_v7_nearly_parallel_lines() -> None:
    made = lines(first=Item((1.0, 2.0, 3.0), (1.0, 1.0, 1.0)), second=Item((4.0, 0.5, -1.0), (1.0, 1.0, 1.0001)))
    assert made.distance.value == pytest.approx(3.1819805153394638598, rel=LAST_BITS)
    assert made.angle == pytest.approx(4.7138880748161704032e-5, rel=LAST_BITS)
    assert made.relation == "skew"
    closer = lines(first=Item((1.0, 2.0, 3.0), (1.0, 1.0, 1.0)), second=Item((4.0, 0.5, -1.0), (1.0, 1.0, 1.0000001)))
    assert [one.code for one in closer.advice] == ["near-parallel"]


@pytest.mark.parametrize(
    ("first", "second", "relation", "distance"),
    [
        (Item((0.0, 0.0, 0.0)), Item((3.0, 4.0, 0.0)), "apart", 5.0),
        (Item((0.3, 0.6, 0.9)), Item((0.1, 0.2, 0.3), (0.2, 0.4, 0.6)),
         "the point is on the line, exactly as typed", 0.0),
        (Item((0.0, 2.0, 0.0)), Item((5.0, 0.0, 0.0), to=(9.0, 0.0, 0.0)), "apart", 2.0),
        (Item((0.0, 0.0, -3.0)), Item((1.0, 1.0, 0.0), normal=(0.0, 0.0, 2.0)),
         "apart, on the side away from the normal", 3.0),
        (Item((0.0, 0.0, 0.0), (0.1, 0.2, 0.3)), Item((0.0, 1.0, 0.0), (0.3, 0.6, 0.9)), "parallel, exactly as typed",
         math.sqrt(10.0 / 14.0)),
        (Item((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)), Item((2.0, 1.0, 0.0), (0.0, 3.0, 0.0)),
         "intersecting, exactly as typed", 0.0),
        (Item((0.0, 0.0, 1.0), (1.0, 1.0, 0.0)), Item((0.0, 0.0, 0.0), normal=(0.0, 0.0, 1.0)),
         "parallel, exactly as typed", 1.0),
        (Item((0.0, 0.0, 0.0), (1.0, 1.0, 0.0)), Item((7.0, 0.0, 0.0), normal=(0.0, 0.0, 1.0)),
         "the line is in the plane, exactly as typed", 0.0),
        (Item((0.0, 0.0, 0.0), normal=(0.0, 0.0, 1.0)), Item((0.0, 0.0, 4.0), normal=(0.0, 0.0, 5.0)),
         "parallel, exactly as typed", 4.0),
        (Item((0.0, 0.0, 0.0), normal=(0.0, 0.0, 1.0)), Item((1.0, 0.0, 4.0), normal=(1.0, 0.0, 0.0)),
         "intersecting in a line", 0.0),
    ],
)  # fmt: skip
def test_every_pair_of_shapes(first: Item, second: Item, relation: str, distance: float) -> None:
    made = lines(first=first, second=second)
    assert (made.relation, made.distance.value) == (relation, pytest.approx(distance, rel=LAST_BITS))
    again = lines(first=second, second=first)
    assert (again.relation, again.distance.value) == (made.relation, made.distance.value)
    assert (again.first_foot is None) == (made.second_foot is None)
    if made.second_foot is not None and relation.startswith("apart"):
        assert again.first_foot.value == made.second_foot.value


def test_where_a_line_meets_a_plane_and_two_planes_meet() -> None:
    plane = Item((0.0, 0.0, 2.0), normal=(0.0, 0.0, 1.0))
    made = lines(first=Item((0.0, 0.0, 0.0), (1.0, 2.0, 1.0)), second=plane)
    assert made.intersection.value == (2.0, 4.0, 2.0)
    wall = lines(first=plane, second=Item((5.0, 0.0, 0.0), normal=(1.0, 0.0, 0.0)))
    assert (wall.intersection.value[0], wall.intersection.value[2]) == (5.0, 2.0)
    assert wall.common_direction.value == (0.0, 1.0, 0.0)


def rows(*given_: list[float]) -> Any:
    return tuple(tuple(Fraction(str(x)).as_integer_ratio() for x in row) for row in given_)


def test_a_matrix_is_inverted_exactly() -> None:
    for size in range(1, 7):
        hilbert = tuple(tuple((1, i + j + 1) for j in range(size)) for i in range(size))
        made = matrix(hilbert, times=hilbert)
        assert made.inverse_exact is not None
        inverse = tuple(
            tuple(Fraction(cell).as_integer_ratio() for cell in row.split(", "))
            for row in made.inverse_exact.split("; ")
        )
        one = matrix(hilbert, times=inverse)
        assert one.product == tuple(tuple(float(i == j) for j in range(size)) for i in range(size))
        solved = matrix(hilbert, right_hand=hilbert).solution
        assert solved == one.product
    assert made.determinant == float(Fraction(1, 186313420339200000))
    assert [item.code for item in made.advice] == ["condition"]


def test_determinants_change_sign_with_their_rows() -> None:
    assert matrix(rows([0.1, 0.2], [0.3, 0.7])).determinant_exact == "1/100"
    assert matrix(rows([0.3, 0.7], [0.1, 0.2])).determinant == -0.01
    singular = matrix(rows([0.1, 0.2], [0.3, 0.6]))
    assert (singular.determinant, singular.inverse, singular.rank) == (0.0, None, 1)


@pytest.mark.parametrize(
    ("argv", "expected"),
    [
        (("resolve", "1, 2, 3", "--along", "0, 0, 0"), (3, "zero-vector")),
        (("resolve", "1, 2, 3", "--first", "1, 0, 0", "--second", "0, 1, 0"), (3, "basis")),
        (("resolve", "1, 2", "--first", "0.1, 0.2", "--second", "0.3, 0.6"), (3, "parallel-basis")),
        (("resolve", "1, 2, 3", "--along", "1, 0, 0", "--normal", "0, 1, 0"), (2, "exclusive")),
        (("polygon", "--sum", "1, 2, 3", "--magnitudes", "5, 4"), (3, "planar")),
        (("polygon", "--sum", "1, 2 N", "--magnitudes", "5, 4 m"), (3, "mixed-kinds")),
        (("polygon", "--sum", "1, 2", "--magnitudes", "5"), (3, "unknowns")),
        (("polygon", "--magnitudes", "5, 5"), (3, "undetermined")),
        (("polygon", "--sum", "1, 2", "--directions", "30, 210 deg"), (3, "parallel")),
        (("polygon", "--sum", "1, 2", "--magnitudes", "1", "--directions", "0 deg"), (3, "gap")),
        (("frame", "--x", "1, 0, 0"), (3, "directions")),
        (("frame", "--x", "0.1, 0.2, 0.3", "--z", "0.3, 0.6, 0.9"), (3, "parallel")),
        (("frame", "--x", "1, 0, 0", "--y", "0, 1, 0", "--z", "1, 1, 0"), (3, "coplanar-basis")),
        (("frame", "1, 2, 3 m", "1, 2, 4 m"), (3, "points")),
        (("lines", "--first-point", "1, 2 m", "--second-point", "1, 2 N"), (3, "mixed-kinds")),
        (("lines", "--first-point", "1, 2", "--second-point", "1, 2", "--second-to", "1, 2"), (3, "zero-vector")),
        (("lines", "--first-point", "1, 2", "--second-point", "1, 2", "--second-to", "1, 3", "--second-normal", "1, 0"),
         (3, "shape")),
        (("matrix", "1, 2; 3"), (2, "matrix")),
        (("matrix", "1, 2; 3, 4", "--plus", "1, 2"), (3, "sizes")),
        (("matrix", "1, 2; 3, 4", "--times", "1, 2"), (3, "sizes")),
        (("matrix", "1, 2; 2, 4", "--right-hand", "1, 3"), (3, "inconsistent")),
        (("matrix", "1, 2; 2, 4", "--right-hand", "1, 2"), (3, "undetermined")),
        (("matrix", "1, 2, 3, 4, 5, 6, 7"), (2, "matrix")),
    ],
)  # fmt: skip
def test_refusals(argv: tuple[str, ...], expected: tuple[int, str]) -> None:
    assert code(*argv) == expected


def test_directions_of_many_turns_still_close_the_polygon() -> None:
    """The difference of such angles is rounded by more than a check of closure allows; their sines are not."""
    made = answer("vec", "polygon", "0, -500 N", "--directions", "36000000030, 135 deg")["results"]["solutions"]
    near = answer("vec", "polygon", "0, -500 N", "--directions", "30, 135 deg")["results"]["solutions"]
    assert made[0]["first_magnitude"]["value"] == pytest.approx(near[0]["first_magnitude"]["value"], rel=1e-6)
    assert run("vec", "polygon", "0, -500 N", "--directions", "3e10..3.9e10, 135 deg").status == 0


def test_a_plane_through_three_points() -> None:
    plane = Item((1.0, 0.0, 0.0), to=(0.0, 2.0, 0.0), third=(0.0, 0.0, 3.0))
    normal = Item((1.0, 0.0, 0.0), normal=(6.0, 3.0, 2.0))
    point = Item((1.0, 1.0, 5.0))
    by_points, by_normal = (lines(first=point, second=item) for item in (plane, normal))
    assert by_points.distance.value == by_normal.distance.value == 13.0 / 7.0
    assert by_points.second_foot.value == by_normal.second_foot.value
    for wrong, message in (
        (Item((0.0, 0.0, 0.0), third=(1.0, 0.0, 0.0)), "a third point and no second one"),
        (Item((0.0, 0.0, 0.0), to=(0.1, 0.2, 0.3), third=(0.3, 0.6, 0.9)), "lie on one line"),
    ):
        with pytest.raises(InadmissibleError, match=message):
            lines(first=point, second=wrong)
