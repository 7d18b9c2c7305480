"""Axes that rounding leaves undetermined, the bound of those that are determined, and assemblies within assemblies."""

import json
import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from harness import answer, run
from mpmath import matrix, mp, mpf
from references.inertia_solids import ball, write_stl

from dynamics_cli.inertia.assembly.assembly import Assembly, body
from dynamics_cli.inertia.assembly.parts import Part, ZAxis
from dynamics_cli.inertia.bodies.amount import OfMass
from dynamics_cli.inertia.bodies.properties import MassProperties
from dynamics_cli.inertia.shapes import Block, Sphere
from dynamics_cli.inertia.shapes.sizes import Radius
from dynamics_cli.inertia.tensors.tensor import Whole, tensor
from dynamics_cli.numerics.eigen3.jacobi import eigen
from dynamics_cli.numerics.eigen3.residual import tilt_bounds
from dynamics_cli.numerics.orientation.rotations import ByQuaternion
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.records import over_parts

UNKNOWN = "differ by less than the uncertainty"
QUATERNION = (1.0, 2.0, 3.0, 4.0)


def tracked(tree: Any) -> Any:
    """A tree of records with exact tracked numbers for its floats."""
    return Tracked(tree, 0.0, ()) if type(tree) is float else over_parts(tree, tracked)


def nested(*inner: Part) -> MassProperties:
    whole = Part(parts=inner, turn=ByQuaternion(QUATERNION), position=(3.0, -2.0, 1.0))
    beside = Part(shape=Sphere(size=Radius(5e-4)), amount=OfMass(1e-12), position=(3.0, -2.0, 1.0))
    return body(Assembly(parts=tracked((whole, beside))))


def bound_of(made: MassProperties, moment: str) -> float:
    """The relative bound stated for a principal moment."""
    assert made.numerics is not None
    return next(bound.bound for bound in made.numerics.bounds if bound.result == f"principal_moments.{moment}")


def rotation() -> Any:
    """The rotation by the quaternion 1, 2, 3, 4, in rationals over 30."""
    return matrix([[-20, 4, 22], [20, -10, 20], [10, 28, 4]]) / 30


class TestUndetermined:
    def test_a_thin_hollow_ball_of_equal_moments(self, tmp_path: Path) -> None:
        """The moments of a ball made from an octahedron are equal; those of its thin wall come out 3e-10 apart."""
        outer = ball(3)
        inner = [tuple(tuple(x * (1.0 - 1e-8) for x in p) for p in (a, c, b)) for a, b, c in outer]
        path = tmp_path / "hollow.stl"
        write_stl(path, outer + inner, binary=False)
        made = answer("inertia", "mesh", str(path), "--length-unit", "m", "--density", "1 kg/m^3")
        assert made["results"]["degeneracy"].startswith("every axis is principal")
        assert UNKNOWN in made["results"]["degeneracy"]
        assert "principal_axes" not in made["numerics"]["error_bound"]

    def test_a_turned_cube_less_a_cube(self) -> None:
        """Every axis of a cubic shell is principal; the difference of two turned cubes leaves rounding only."""
        turn = ByQuaternion((0.3, 0.7, -0.2, 0.61))
        solid = Part(shape=Block(1.0, 1.0, 1.0), amount=OfMass(1.0), turn=turn)
        side = 1.0 - 1e-6
        hole = Part(shape=Block(side, side, side), amount=OfMass(1.0 - 3e-6), turn=turn, subtract=True)
        made = body(Assembly(parts=tracked((solid, hole))))
        assert made.degeneracy.startswith("every axis is principal")
        assert UNKNOWN in made.degeneracy


class TestBoundsOfAxes:
    @pytest.mark.parametrize("power", [0, 3, 6, 9, 12])
    def test_the_turn_of_each_axis_is_within_its_bound(self, power: int) -> None:
        """Against eigenvectors in 60 digits, of moments that differ by 10⁻ᵖ; the bound is no looser than 100 times."""
        draw = np.random.default_rng(power)
        looseness = []
        for _ in range(30):
            turn, _ = np.linalg.qr(draw.normal(size=(3, 3)))
            full = turn @ np.diag([1.0, 1.0 + 10.0**-power, 1.5]) @ turn.T
            given = tuple(tuple(float(full[max(i, j), min(i, j)]) for j in range(3)) for i in range(3))
            found = eigen(given)  # type: ignore[arg-type]
            bounds = tilt_bounds(given, found.vectors)  # type: ignore[arg-type]
            with mp.workdps(60):
                _, columns = mp.eigsy(matrix(given))
                true = [[columns[i, 2 - k] for i in range(3)] for k in range(3)]
                for vector, exact, bound in zip(found.vectors, true, bounds, strict=True):
                    sense = mp.sign(sum(mpf(x) * y for x, y in zip(vector, exact, strict=True)))
                    off = max(abs(mpf(x) - sense * y) for x, y in zip(vector, exact, strict=True))
                    assert off <= bound
                    looseness.append(bound / max(float(off), 2.0**-53))
        assert np.median(looseness) < 100.0

    def test_errors_of_the_matrix_turn_axes(self) -> None:
        """With an error e beside the diagonal and a gap g the axes turn by e/g and no more than its arc."""
        one = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
        errors = ((0.0, 1e-6, 0.0), (1e-6, 0.0, 0.0), (0.0, 0.0, 0.0))
        bounds = tilt_bounds(((1.0, 0.0, 0.0), (0.0, 1.01, 0.0), (0.0, 0.0, 5.0)), one, errors)
        assert 1e-4 <= bounds[0] == pytest.approx(1e-4, rel=1e-3)
        assert tilt_bounds(((1.0, 0.0, 0.0), (0.0, 1.0 + 1e-6, 0.0), (0.0, 0.0, 5.0)), one, errors)[0] == float("inf")

    def test_every_task_states_it(self, tmp_path: Path) -> None:
        path = tmp_path / "ball.stl"
        write_stl(path, [tuple((x, 0.7 * y, 0.4 * z) for x, y, z in t) for t in ball(3)], binary=True)
        scene = tmp_path / "scene.toml"
        scene.write_text(
            '[[parts]]\nshape = "block"\nwidth = "3 m"\ndepth = "2 m"\nheight = "1 m"\nmass = "2 kg"\n'
            '[[parts]]\nmass = "1 kg"\nposition = "1, 2, 3 m"\n'
        )
        for call in (
            ("mesh", str(path), "--length-unit", "m", "--mass", "1 kg"),
            ("body", str(scene)),
            ("shape", "triangle", "--base", "3 m", "--height", "2 m", "--offset", "0.7 m", "--mass", "2 kg"),
            ("tensor", "--tensor", "[[2, -0.3, 0.1], [-0.3, 2.2, 0.2], [0.1, 0.2, 3]] kg*m^2"),
        ):
            stated = answer("inertia", *call)["numerics"]["error_bound"]["principal_axes"]["absolute"]
            assert 0.0 < stated < 1e-13, call

    def test_a_tensor_of_close_moments(self) -> None:
        given = ((1.0, 1e-13, 0.0), (1e-13, 1.0, 0.0), (0.0, 0.0, 1.5))
        made = tensor(inertia=Whole(tracked(given)))
        assert made.numerics is not None
        (bound,) = made.numerics.bounds
        assert not bound.relative
        assert bound.bound < 0.01


class TestNesting:
    def test_what_is_cut_out_cancels_in_the_frame_of_its_assembly(self) -> None:
        """A plate less an equal one of half its thickness: thin along its own axis, not the scene's."""
        plate = Part(shape=Block(1.0, 1.0, 2.0**-20), amount=OfMass(1.0))
        hole = Part(shape=Block(1.0, 1.0, 2.0**-21), amount=OfMass(0.5), subtract=True)
        made = nested(plate, hole)
        with mp.workdps(60):
            across, thin = mpf(1) / 24, (mpf(2) ** -40 - mpf(2) ** -43) / 12
            small = mpf(1e-12) * mpf(5e-4) ** 2 * 2 / 5
            turn = rotation()
            second = turn * mp.diag([across, across, thin]) * turn.T + small / 2 * mp.eye(3)
            for i, j in ((0, 1), (1, 2), (2, 0)):
                found = made.second_moments[i][j]
                assert abs(mpf(found.value) - second[i, j]) <= found.error
            true = across + thin + small
            assert abs(mpf(made.principal_moments.first) - true) <= bound_of(made, "first") * true

    def test_an_assembly_of_holes_alone_and_one_that_weighs_nothing(self) -> None:
        body_ = Part(shape=Block(1.0, 1.0, 1.0), amount=OfMass(8.0))
        holes = tuple(
            Part(shape=Sphere(size=Radius(0.05)), amount=OfMass(0.5), position=(x, 0.0, 0.0), subtract=True)
            for x in (-0.25, 0.25)
        )
        flat = body(Assembly(parts=(body_, *holes)))
        grouped = body(Assembly(parts=(body_, Part(parts=holes))))
        assert grouped.mass == flat.mass == 7.0
        assert grouped.tensor == pytest.approx(np.array(flat.tensor), rel=1e-15, abs=1e-16)
        one, other = holes[0], Part(shape=Sphere(size=Radius(0.05)), amount=OfMass(0.5), position=(0.25, 0.0, 0.0))
        cancelled = body(Assembly(parts=(body_, Part(parts=(one, other), position=(0.0, 0.125, 0.0)))))
        assert cancelled.mass == 8.0
        # two masses of 1/2 of opposite sign half apart: a first moment of 1/4, and no second one along x
        assert cancelled.centroid == pytest.approx((0.25 / 8.0, 0.0, 0.0), abs=1e-16)

    @pytest.mark.parametrize("seed", range(8))
    def test_depth_changes_nothing_beyond_the_bounds(self, seed: int) -> None:
        draw = random.Random(seed)

        def number() -> float:
            return draw.uniform(-1.0, 1.0)

        def turn() -> ByQuaternion:
            return ByQuaternion((number(), number(), number(), number()))

        leaves = tuple(
            Part(
                shape=Block(0.1, 0.2, 0.3), amount=OfMass((1.0, 0.01, 2.0, 3.0)[k]),
                position=(number(), number(), number()), turn=turn(), subtract=k == 1 and bool(seed % 2),
            )
            for k in range(4)
        )  # fmt: skip
        beside = Part(amount=OfMass(3.0), position=(number(), number(), number()))
        place, turned = (number(), number(), number()), turn()
        once = body(Assembly(parts=tracked((Part(parts=leaves, position=place, turn=turned), beside))))
        deep = Part(parts=(Part(parts=leaves[:2]), Part(parts=leaves[2:])), position=place, turn=turned)
        twice = body(Assembly(parts=tracked((deep, beside))))
        for one, other in zip(sum(once.tensor, ()), sum(twice.tensor, ()), strict=True):
            assert abs(one.value - other.value) <= one.error + other.error  # type: ignore[attr-defined]


MATRIX = "[[0, -1, 0], [1, 0, 0], [0, 0, 1]]"


@pytest.mark.parametrize(
    "text",
    [
        "(0, -1, 0), (1, 0, 0), (0, 0, 1)",
        "[0, -1, 0], [1, 0, 0], [0, 0, 1]",
        "0, -1, 0; 1, 0, 0; 0, 0, 1",
        "0 -1 0; 1 0 0; 0 0 1;",
    ],
)
def test_a_matrix_is_read_as_json_and_as_people_write_rows(text: str) -> None:
    call = ("inertia", "tensor", "--moments", "1, 2, 2.5 kg*m^2", "--rotation-matrix")
    assert answer(*call, text)["results"]["tensor"] == answer(*call, MATRIX)["results"]["tensor"]


def test_a_matrix_of_an_earlier_document_turns_a_body(tmp_path: Path) -> None:
    call = ("inertia", "tensor", "--moments", "1, 2, 2.5 kg*m^2", "--products", "0.1, 0.2, 0 kg*m^2")
    first = answer(*call)
    (tmp_path / "first.json").write_text(json.dumps(first))
    second = answer(*call, "--rotation-matrix", f"@{tmp_path}/first.json:principal_axes")["inputs"]
    assert second["rotation_matrix"] == first["results"]["principal_axes"]
    refused = run(*call, "--rotation-matrix", f"@{tmp_path}/first.json:nothing")
    assert refused.status == 2
    assert "no result 'nothing'" in refused.err


@pytest.mark.parametrize(
    "direction", [(0.0, 0.0, 1.0), (0.0, 0.0, -2.0), (1.0, 0.0, 0.0), (0.3, -2.0, -0.7), (1e-9, 0.0, -1.0)]
)
def test_a_part_turned_by_its_z_axis(direction: tuple[float, float, float]) -> None:
    turn = np.array(ZAxis(direction).matrix)
    assert turn @ turn.T == pytest.approx(np.eye(3), abs=1e-15)
    assert np.linalg.det(turn) == pytest.approx(1.0, rel=1e-15)
    assert turn[:, 2] == pytest.approx(np.array(direction) / np.linalg.norm(direction), rel=1e-15, abs=1e-16)


def test_a_welded_frame_by_directions() -> None:
    tube = {"shape": "tube", "diameter": "30 mm", "thickness": "2 mm", "length": "1 m", "mass": "3 kg"}
    parts = [tube | {"z_axis": "1, 0, 0", "position": "0.5, 0, 0 m"}, tube | {"z_axis": "0, -1, 0"}]
    made = answer("inertia", "body", "--input", "-", stdin=json.dumps({"parts": parts}))["results"]
    along, across = 3.0 * (0.015**2 + 0.013**2) / 2.0, 3.0 * ((0.015**2 + 0.013**2) / 4.0 + 1.0 / 12.0)
    apart = 2 * 3.0 * 0.25**2
    moments = [made["moments"][axis]["value"] for axis in ("xx", "yy", "zz")]
    assert moments == pytest.approx([along + across, along + across + apart, 2 * across + apart], rel=1e-14)
