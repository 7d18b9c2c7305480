"""Assemblies: frames, order, nesting, holes, measured parts, uncertainties, and scenes that contradict themselves."""

import json
import math
import random
from pathlib import Path
from typing import Any

import pytest
from harness import answer, run
from hypothesis import given, settings
from hypothesis import strategies as st
from references.inertia_solids import ball, write_stl

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.inertia.assembly.assembly import Assembly, body
from dynamics_cli.inertia.assembly.compare import Pair, compare
from dynamics_cli.inertia.assembly.parts import Part, each_number
from dynamics_cli.inertia.bodies.amount import OfDensity, OfMass
from dynamics_cli.inertia.bodies.properties import MassProperties
from dynamics_cli.inertia.mesh.surface import LengthUnit
from dynamics_cli.inertia.shapes import Block, Cylinder, Disk, HollowSphere, Rod, Sphere
from dynamics_cli.inertia.shapes.sizes import Radius, Thickness
from dynamics_cli.inertia.shapes.task import shape
from dynamics_cli.numerics.number import over_plain
from dynamics_cli.numerics.orientation.rotations import AxisAngle, ByMatrix, ByQuaternion, Euler, departure, matrix_of
from dynamics_cli.numerics.tracked import Tracked

ROOT = Path(__file__).parents[2]
STEEL = OfDensity(7850.0)


def parts(seed: int, count: int) -> tuple[Part, ...]:
    draw = random.Random(seed)

    def place() -> tuple[float, float, float]:
        return draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)

    kinds = (Block(0.1, 0.2, 0.3), Cylinder(Radius(0.1), 0.5), Sphere(Radius(0.2)), Rod(0.7), Disk(Radius(0.3)), None)
    return tuple(
        Part(
            shape=draw.choice(kinds),
            amount=OfMass(draw.uniform(0.1, 3.0)),
            position=place(),
            turn=AxisAngle(place(), draw.uniform(-3, 3)),
        )
        for _ in range(count)
    )


def solved(*items: Part, **more: Any) -> MassProperties:
    return over_plain(body(Assembly(parts=items), **more))


def same(a: MassProperties, b: MassProperties, within: float = 1e-13) -> None:
    assert a.mass == pytest.approx(b.mass, rel=within)
    for name in ("first", "second", "third"):
        assert getattr(a.principal_moments, name) == pytest.approx(getattr(b.principal_moments, name), rel=within)


@given(st.integers(0, 999), st.integers(2, 7))
@settings(max_examples=25, deadline=None)
def test_order_nesting_and_frames_change_nothing(seed: int, count: int) -> None:
    items = parts(seed, count)
    whole = solved(*items)
    same(whole, solved(*items[::-1]))
    same(whole, solved(items[0], Part(parts=items[1:])))
    moved = solved(Part(parts=items, position=(3.0, -2.0, 5.0), turn=Euler((0.3, 1.1, -0.7), "zyx")))
    same(whole, moved)
    turn = matrix_of(Euler((0.3, 1.1, -0.7), "zyx"))
    want = [sum(turn[i][k] * whole.centroid[k] for k in range(3)) + (3.0, -2.0, 5.0)[i] for i in range(3)]
    assert moved.centroid == pytest.approx(want, abs=1e-14)


@given(st.integers(0, 999), st.floats(1.0, 1e8))
@settings(max_examples=25, deadline=None)
def test_an_offset_costs_no_digit_of_the_moments(seed: int, far: float) -> None:
    far = math.floor(far)
    items = parts(seed, 4)
    exact = tuple(
        Part(**{**part.__dict__, "position": tuple(round(x * 1024) / 1024 for x in part.position)}) for part in items
    )
    away = tuple(Part(**{**part.__dict__, "position": tuple(x + far for x in part.position)}) for part in exact)
    same(solved(*exact), solved(*away), 4e-15)


def test_a_hole_filled_again_is_the_body() -> None:
    plate = Part(shape=Block(0.4, 0.3, 0.02), amount=STEEL)
    bore = {"shape": Cylinder(Radius(0.03), 0.02), "amount": STEEL, "position": (0.1, 0.05, 0.0)}
    holed = solved(plate, Part(**bore, subtract=True))
    assert holed.cancellation is not None
    assert holed.cancellation.mass > 1.0
    same(solved(plate, Part(**bore, subtract=True), Part(**bore)), solved(plate), 1e-14)
    assert holed.moments.xx < solved(plate).moments.xx


def test_a_ball_less_a_ball_is_a_hollow_ball_and_says_what_cancels() -> None:
    outer, inner = (
        Part(shape=Sphere(Radius(1.0)), amount=STEEL),
        Part(shape=Sphere(Radius(0.9)), amount=STEEL, subtract=True),
    )
    one = solved(outer, inner)
    other = shape(HollowSphere(Radius(1.0), Thickness(1.0 - 0.9)), amount=STEEL)
    assert one.moments.zz == pytest.approx(other.moments.zz, rel=1e-14)
    thin = Part(shape=Sphere(Radius(1.0 - 1e-9)), amount=STEEL, subtract=True)
    codes = [advice.code for advice in body(Assembly(parts=(outer, thin))).advice]
    assert codes == ["cancellation"]


def test_subtracting_within_a_subtracted_assembly_adds() -> None:
    block = Part(shape=Block(1.0, 1.0, 1.0), amount=STEEL)
    island = Part(shape=Sphere(Radius(0.1)), amount=STEEL, subtract=True)
    hole = Part(shape=Sphere(Radius(0.3)), amount=STEEL, subtract=True, parts=(island,))
    want = 7850.0 * (1.0 - 4.0 / 3.0 * math.pi * (0.3**3 - 0.1**3))
    assert solved(block, hole).mass == pytest.approx(want, rel=1e-14)


QUARTER = 0.5 * math.pi


def test_every_way_of_writing_a_rotation_is_the_same_rotation() -> None:
    axis = matrix_of(AxisAngle((0.0, 0.0, 2.0), 0.7))
    half = 0.35
    for turn in (
        ByQuaternion((2.0 * math.cos(half), 0.0, 0.0, 2.0 * math.sin(half))),
        Euler((0.7, 0.0, 0.0), "zyx"),
        Euler((0.0, 0.0, 0.7), "XYZ"),
        ByMatrix(((math.cos(0.7), -math.sin(0.7), 0.0), (math.sin(0.7), math.cos(0.7), 0.0), (0.0, 0.0, 1.0))),
        ByMatrix(((0.764842, -0.644218, 0.0), (0.644218, 0.764842, 0.0), (0.0, 0.0, 1.0))),
    ):
        found = matrix_of(turn)
        assert [x for row in found for x in row] == pytest.approx([x for row in axis for x in row], abs=1e-6)
        assert departure(found) < 1e-15
    intrinsic, extrinsic = matrix_of(Euler((0.2, 0.4, 0.6), "zyx")), matrix_of(Euler((0.6, 0.4, 0.2), "XYZ"))
    assert [x for row in intrinsic for x in row] == pytest.approx([x for row in extrinsic for x in row], abs=1e-15)


@pytest.mark.parametrize(
    ("turn", "message"),
    [
        (AxisAngle((0.0, 0.0, 0.0), 1.0), "axis has no length"),
        (ByQuaternion((0.0, 0.0, 0.0, 0.0)), "quaternion has no length"),
        (Euler((1.0, 2.0, 3.0), "zzx"), "order of Euler angles 'zzx' is unknown"),
        (Euler((1.0, 2.0, 3.0), "zYx"), "order of Euler angles"),
        (Euler((1.0, 2.0), "zyx"), "read 2 Euler angles"),
        (ByMatrix(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))), "read 2 rows"),
        (ByMatrix(((1.0, 0.1, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))), "not a rotation: its rows depart .* by 0.1"),
        (ByMatrix(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, -1.0))), "reflection"),
    ],
)
def test_what_is_no_rotation_is_refused(turn: Any, message: str) -> None:
    with pytest.raises(InadmissibleError, match=message):
        matrix_of(turn)


BLOCK = Block(1.0, 1.0, 1.0)


@pytest.mark.parametrize(
    ("items", "message"),
    [
        ((Part(shape=BLOCK),), "part 1 has neither mass nor density"),
        ((Part(),), "part 1 has neither shape, mesh, tensor, mass nor parts"),
        ((Part(name="lid", amount=OfDensity(1.0)),), "lid has a density and no shape"),
        ((Part(shape=BLOCK, amount=STEEL, tensor=((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))),), "together"),
        ((Part(shape=BLOCK, amount=STEEL, centroid=(0.0, 0.0, 1.0)),), "which its shape already determines"),
        ((Part(amount=OfMass(1.0), tensor_std=((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))),), "a tensor"),
        ((Part(mass_std=0.1, parts=(Part(amount=OfMass(1.0)),)),), "gives mass_std without a body"),
        ((Part(amount=OfMass(1.0), tensor=((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 3.0))),), "exceeds the sum"),
        ((Part(amount=OfMass(1.0), tensor=((1.0, 2.0, 0.0), (2.0, 1.0, 0.0), (0.0, 0.0, 1.0))),), "is negative"),
        ((Part(name="a", amount=OfMass(1.0)), Part(name="a", amount=OfMass(1.0))), "two parts are named 'a'"),
        ((Part(shape=BLOCK, amount=STEEL, subtract=True),), "there is no body"),
        ((Part(shape=BLOCK, amount=STEEL), Part(shape=BLOCK, amount=STEEL, subtract=True)), "0 kg remains"),
        (
            (Part(shape=Block(1.0, 1.0, 0.1), amount=STEEL), Part(shape=Rod(3.0), amount=OfMass(300.0), subtract=True)),
            "a hole is larger than its body or lies outside",
        ),
    ],
)
def test_scenes_that_contradict_themselves_are_refused(items: tuple[Part, ...], message: str) -> None:
    with pytest.raises(InadmissibleError, match=message):
        body(Assembly(parts=items))


def test_about_a_named_part() -> None:
    hub = Part(name="hub", amount=OfMass(2.0), position=(1.0, 0.0, 0.0))
    arm = Part(
        name="arm", parts=(Part(name="tip", amount=OfMass(1.0), position=(0.0, 3.0, 0.0)),), position=(1.0, 0.0, 0.0)
    )
    found = solved(hub, arm, about="hub")
    assert found.reference_point == (1.0, 0.0, 0.0)
    assert found.moments.xx == 9.0
    assert solved(hub, arm, about="arm/tip").moments.xx == 18.0
    with pytest.raises(InadmissibleError, match="no reference point 'tip'"):
        solved(hub, arm, about="tip")


def test_measured_parts_keep_their_tensor() -> None:
    tensor = ((0.5, 0.02, -0.01), (0.02, 0.4, 0.03), (-0.01, 0.03, 0.6))
    found = solved(Part(amount=OfMass(3.0), centroid=(0.1, 0.0, 0.0), tensor=tensor, position=(1.0, 1.0, 1.0)))
    assert found.tensor == tuple(pytest.approx(row, abs=1e-15) for row in tensor)
    assert found.centroid == (1.1, 1.0, 1.0)


def uncertain(seed: int) -> tuple[Part, ...]:
    draw = random.Random(seed)
    made = []
    for part in parts(seed, 3):
        std = tuple(draw.uniform(0.001, 0.01) for _ in range(3))
        measured = {
            "shape": None,
            "tensor": ((0.5, 0.02, -0.01), (0.02, 0.4, 0.03), (-0.01, 0.03, 0.6)),
            "tensor_std": ((0.01, 0.003, 0.004), (0.003, 0.02, 0.005), (0.004, 0.005, 0.03)),
            "centroid": (0.1, 0.2, -0.1),
            "mass_std": 0.05,
            "centroid_std": std,
        }
        made.append(Part(**{**part.__dict__, **measured}))
    return (*made, parts(seed + 1, 1)[0])


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_rolled_up_uncertainties_are_the_first_order_ones(seed: int) -> None:
    """Against central differences of the composition itself by every uncertain number."""
    items = uncertain(seed)
    found = solved(*items).standard_uncertainty
    assert found is not None
    sums: dict[str, float] = {}

    def spread(index: int, name: str, change: Any, sigma: float) -> None:
        ends = []
        for sign in (1.0, -1.0):
            moved = list(items)
            moved[index] = Part(
                **{**items[index].__dict__, name: change(getattr(items[index], name), sign * 1e-3 * sigma)}
            )
            ends.append(solved(*moved))
        for address, get in GETTERS.items():
            sums[address] = sums.get(address, 0.0) + ((get(ends[0]) - get(ends[1])) / 2e-3) ** 2

    for index in range(3):
        spread(index, "amount", lambda old, h: OfMass(old.mass + h), 0.05)
        for k in range(3):
            sigma = items[index].centroid_std[k]  # type: ignore[index]
            spread(index, "centroid", lambda old, h, k=k: tuple(x + h * (i == k) for i, x in enumerate(old)), sigma)
        for i in range(3):
            for j in range(i + 1):
                sigma = items[index].tensor_std[i][j]  # type: ignore[index]
                spread(index, "tensor", lambda old, h, i=i, j=j: _nudged(old, i, j, h), sigma)
    for address, variance in sums.items():
        own = {
            "mass": found.mass, "x": found.centroid[0], "z": found.centroid[2],
            "xx": found.moments[0], "zz": found.moments[2], "xy": found.products[0], "zx": found.products[2],
            "first": found.principal_moments[0], "third": found.principal_moments[2],
        }[address]  # fmt: skip
        assert own == pytest.approx(math.sqrt(variance), rel=1e-4), address


GETTERS = {
    "mass": lambda a: a.mass,
    "x": lambda a: a.centroid[0],
    "z": lambda a: a.centroid[2],
    "xx": lambda a: a.moments.xx,
    "zz": lambda a: a.moments.zz,
    "xy": lambda a: a.products.xy,
    "zx": lambda a: a.products.zx,
    "first": lambda a: a.principal_moments.first,
    "third": lambda a: a.principal_moments.third,
}


def _nudged(tensor: Any, i: int, j: int, h: float) -> Any:
    return tuple(tuple(x + h * ((r, c) in ((i, j), (j, i))) for c, x in enumerate(row)) for r, row in enumerate(tensor))


def test_a_shape_of_uncertain_mass_carries_its_own_inertia() -> None:
    found = solved(Part(shape=Sphere(Radius(0.5)), amount=OfMass(2.0), mass_std=0.02)).standard_uncertainty
    assert found is not None
    assert found.moments[0] == pytest.approx(0.4 * 0.25 * 0.02, rel=1e-14)


def test_axes_that_the_data_do_not_determine_are_said_to_be_so() -> None:
    tensor = ((1.0, 0.0, 0.0), (0.0, 1.01, 0.0), (0.0, 0.0, 1.5))
    blurred = ((0.02, 0.0, 0.0), (0.0, 0.02, 0.0), (0.0, 0.0, 0.02))
    loose = body(Assembly(parts=(Part(amount=OfMass(1.0), tensor=tensor, tensor_std=blurred),)))
    assert [advice.code for advice in loose.advice] == ["axes-uncertain"]
    assert "moments 1 and 2" in loose.advice[0].message
    sharp = ((0.001, 0.0, 0.0), (0.0, 0.001, 0.0), (0.0, 0.0, 0.001))
    assert body(Assembly(parts=(Part(amount=OfMass(1.0), tensor=tensor, tensor_std=sharp),))).advice == ()


def test_comparing_a_body_with_itself_turned() -> None:
    block = Part(shape=Block(0.3, 0.5, 0.9), amount=OfMass(2.0))
    turned = Part(shape=Block(0.3, 0.5, 0.9), amount=OfMass(2.0), turn=AxisAngle((0.0, 0.0, 1.0), 0.3))
    found = over_plain(compare(Pair(first=Assembly(parts=(block,)), second=Assembly(parts=(turned,)))))
    assert found.axes_angle == pytest.approx(0.3, abs=1e-14)
    assert found.mass_ratio == 1.0
    alike = over_plain(compare(Pair(first=Assembly(parts=(block,)), second=Assembly(parts=(block,)))))
    assert alike.tensor_distance == 0.0
    assert alike.axes_angle == pytest.approx(0.0, abs=1e-15)
    ball = Assembly(parts=(Part(shape=Sphere(Radius(0.3)), amount=OfMass(2.0)),))
    undetermined = compare(Pair(first=ball, second=ball))
    assert undetermined.axes_angle is None
    assert undetermined.advice[0].result == "axes_angle"


def test_the_flywheel_by_hand() -> None:
    """Rings of steel by ½ m (R² + r²), holes by ½ m r² + m d², a keyway by its sides, all about the shaft."""
    found = answer("inertia", "body", str(ROOT / "examples" / "flywheel.toml"), "--shaft-direction", "0,0,1")
    rho, pi = 7850.0, math.pi

    def ring(outer: float, inner: float, length: float) -> float:
        return 0.5 * rho * pi * length * (outer**4 - inner**4)

    hole = rho * pi * 0.03**2 * 0.02
    key = rho * 0.004 * 0.008 * 0.09
    want = ring(0.25, 0.21, 0.08) + ring(0.21, 0.045, 0.02) + ring(0.045, 0.025, 0.09)
    want -= 3.0 * hole * (0.5 * 0.03**2 + 0.13**2) + key * ((0.004**2 + 0.008**2) / 12.0 + 0.027**2)
    assert found["results"]["shaft"]["moment"]["value"] == pytest.approx(want, rel=1e-12)


def scene(tmp_path: Path, tree: Any) -> str:
    file = tmp_path / "scene.json"
    file.write_text(json.dumps(tree))
    return str(file)


@pytest.mark.parametrize(
    ("tree", "status"),
    [
        ({}, 2),
        ({"parts": []}, 2),
        ({"parts": [{"shape": "cube", "mass": "1 kg"}]}, 2),
        ({"parts": [{"shape": "sphere", "radius": "1 m", "mass": "-1 kg"}]}, 2),
        ({"parts": [{"shape": "sphere", "radius": 1, "mass": "1 kg"}]}, 2),
        ({"parts": [{"shape": "sphere", "radius": "1 m", "mass": "1 kg", "colour": "red"}]}, 2),
        ({"parts": [{"mesh": "nothing.stl", "length_unit": "mm", "mass": "1 kg"}]}, 2),
        ({"parts": [{"mass": "1 kg", "rotation_axis": "0,0,1"}]}, 2),
        ({"parts": [{"mass": "1 kg", "quaternion": "1,0,0"}]}, 2),
        ({"parts": [{"mass": "1 kg", "tensor": "[[1,2,3],[4,5,6],[7,8,9]] kg*m^2"}]}, 2),
        ({"parts": [{"mass": "0 kg"}]}, 3),
        ({"parts": [{"mass": "1e300 kg", "position": "1e300, 0, 0 m"}, {"mass": "1e300 kg"}]}, 3),
    ],
)
def test_hostile_scenes_are_refused_in_order(tmp_path: Path, tree: Any, status: int) -> None:
    outcome = run("inertia", "body", scene(tmp_path, tree), "--json")
    assert outcome.status == status, outcome.err
    assert outcome.error["message"]
    assert "Traceback" not in outcome.err


def test_many_parts_are_answered_without_a_bound() -> None:
    def tracked(x: float) -> Tracked:
        return Tracked(x, 0.0, (0.0,) * 200)

    found = body(each_number(Assembly(parts=parts(5, 2100)), tracked))
    assert found.advice[0].code == "no-bound"
    assert found.mass == pytest.approx(sum(part.amount.mass for part in parts(5, 2100)), rel=1e-13)  # type: ignore[union-attr]


def test_a_mesh_part_is_what_the_mesh_is(tmp_path: Path) -> None:
    file = str(ROOT / "examples" / "bracket.stl")
    tree = {"parts": [{"mesh": file, "length_unit": "mm", "density": "2700 kg/m^3", "position": "1, 2, 3 m"}]}
    one = answer("inertia", "body", scene(tmp_path, tree))["results"]
    other = answer("inertia", "mesh", file, "--length-unit", "mm", "--density", "2700 kg/m^3")["results"]
    for name in ("first", "second", "third"):
        own, mesh = (r["principal_moments"][name]["value"] for r in (one, other))
        assert own == pytest.approx(mesh, rel=1e-13)
    assert one["mass"]["value"] == pytest.approx(other["mass"]["value"], rel=1e-15)


def test_an_open_mesh_part_is_named(tmp_path: Path) -> None:
    path = tmp_path / "open.stl"
    write_stl(path, ball(2)[:-1], binary=True)
    hull = Part(name="hull", mesh=str(path), length_unit=LengthUnit("mm"), amount=STEEL)
    with pytest.raises(InadmissibleError) as caught:
        body(Assembly(parts=(hull,)))
    assert "of hull" in caught.value.message
    assert "inertia mesh" in str(caught.value.hint)
