"""Given tensors: principal moments, what no body has, extremes, other axes; inertia torques; files for simulators."""

import json
import math
import random
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest
from harness import answer, run

from dynamics_cli.errors import InadmissibleError, MissingError
from dynamics_cli.inertia.assembly.assembly import Assembly, body
from dynamics_cli.inertia.assembly.parts import Part
from dynamics_cli.inertia.assembly.writers import mjcf, sdf, urdf
from dynamics_cli.inertia.bodies.amount import OfMass
from dynamics_cli.inertia.bodies.mass_moments import second_of, tensor_of
from dynamics_cli.inertia.bodies.properties import Axes, ProductSign
from dynamics_cli.inertia.shapes import QuarterDisk, Wedge
from dynamics_cli.inertia.shapes.sizes import Radius
from dynamics_cli.inertia.shapes.task import shape
from dynamics_cli.inertia.tensors.tensor import Parts, Whole, tensor
from dynamics_cli.inertia.tensors.torque import torque
from dynamics_cli.numerics.orientation.rotations import AxisAngle

ROOT = Path(__file__).parents[2]
FULL = ((10.0, -2.0, 1.0), (-2.0, 12.0, 3.0), (1.0, 3.0, 14.0))


def test_principal_moments_have_the_invariants_of_the_tensor() -> None:
    p = tensor(inertia=Whole(FULL)).principal_moments
    assert p.first + p.second + p.third == pytest.approx(36.0, rel=1e-15)
    assert p.first * p.second * p.third == pytest.approx(10 * (168 - 9) + 2 * (-28 - 3) + (-6 - 12), rel=1e-14)


def test_no_axes_have_a_greater_product_than_the_extreme_one() -> None:
    found = tensor(inertia=Whole(FULL))
    draw = random.Random(3)

    def product(a: list[float], b: list[float]) -> float:
        return abs(sum(FULL[i][j] * a[i] * b[j] for i in range(3) for j in range(3)))

    for _ in range(2000):
        a = [draw.gauss(0, 1) for _ in range(3)]
        n = math.sqrt(sum(x * x for x in a))
        a = [x / n for x in a]
        b = [draw.gauss(0, 1) for _ in range(3)]
        along = sum(x * y for x, y in zip(a, b, strict=True))
        b = [y - along * x for x, y in zip(a, b, strict=True)]
        n = math.sqrt(sum(x * x for x in b))
        assert product(a, [x / n for x in b]) <= found.greatest_product * (1.0 + 1e-12)
    one, other = (list(axis) for axis in found.greatest_product_axes)
    assert product(one, other) == pytest.approx(found.greatest_product, rel=1e-14)
    there = sum(FULL[i][j] * one[i] * one[j] for i in range(3) for j in range(3))
    assert there == pytest.approx(found.moment_there, rel=1e-14)


def test_signs_of_products_are_told_apart() -> None:
    minus = tensor(inertia=Parts((10.0, 12.0, 14.0), (-2.0, 3.0, 1.0)))
    plus = tensor(inertia=Parts((10.0, 12.0, 14.0), (2.0, -3.0, -1.0), ProductSign("positive")))
    assert minus.principal_moments == plus.principal_moments == tensor(inertia=Whole(FULL)).principal_moments


def test_a_turned_tensor_keeps_its_principal_moments() -> None:
    found = tensor(inertia=Whole(FULL), turn=AxisAngle((1.0, 2.0, 3.0), 0.8))
    again = tensor(inertia=Whole(found.tensor))
    for name in ("first", "second", "third"):
        own = getattr(found.principal_moments, name)
        assert getattr(again.principal_moments, name) == pytest.approx(own, rel=1e-14)


def test_a_moment_about_a_direction() -> None:
    assert tensor(inertia=Whole(FULL), direction=(2.0, 2.0, 0.0)).direction_moment == pytest.approx(9.0, rel=1e-15)


def test_a_lamina_is_a_body_and_so_is_a_rod() -> None:
    lamina = tensor(inertia=Parts((1.0, 2.0, 3.0)), mass=2.0)
    assert lamina.slack == 0.0
    assert [advice.code for advice in lamina.advice] == ["lamina"]
    assert lamina.equivalent_box is not None
    assert lamina.equivalent_box[2] == 0.0
    assert tensor(inertia=Parts((0.0, 2.0, 2.0))).ellipsoid_axes == (1.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("given", "message", "hint"),
    [
        (Parts((1.0, 2.0, 3.001)), "exceeds the sum of 1 kg.m.2 and 2 kg.m.2", "larger tolerance"),
        (Parts((1.0, 1.0, 1.0), (1.5, 0.0, 0.0)), "is negative: -0.5", None),
        (Parts((2.0, 2.0, 2.0), (0.7, 0.7, 0.7)), "exceeds the sum", "other sign"),
        (Parts((0.0, 0.0, 0.0)), "no positive moment", None),
        (Parts((1.0, 2.0)), "read 2 moments", None),
        (Parts((1.0, 2.0, 2.0), (0.0,)), "read 1 products", None),
    ],
)
def test_tensors_that_no_body_has_are_refused(given: Parts, message: str, hint: str | None) -> None:
    with pytest.raises(InadmissibleError, match=message) as refused:
        tensor(inertia=given)
    if hint is not None:
        assert hint in (refused.value.hint or "")


def test_few_digits_need_a_tolerance() -> None:
    printed = Parts((1.33, 1.33, 2.67))
    with pytest.raises(InadmissibleError):
        tensor(inertia=printed)
    made = tensor(inertia=printed, tolerance=0.01)
    assert made.slack < 0.0
    assert [(advice.code, advice.severity) for advice in made.advice] == [("no-body", "caution")]
    far = tensor(inertia=Parts((1.0, 1.0, 9.0)), tolerance=2.0)
    assert [(advice.code, advice.severity) for advice in far.advice] == [("no-body", "serious")]


def test_no_tolerance_is_offered_where_there_is_none() -> None:
    flat = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 3.0))
    with pytest.raises(InadmissibleError) as caught:
        torque(tensor=flat)
    assert "tolerance" not in str(caught.value.hint)
    with pytest.raises(InadmissibleError) as caught:
        body(Assembly(parts=(Part(name="pump", amount=OfMass(1.0), tensor=flat),)))
    assert "pump" in str(caught.value.hint)


def test_second_moments_and_tensors_are_each_others() -> None:
    for row, want in zip(tensor_of(second_of(FULL)), FULL, strict=True):
        assert row == pytest.approx(want, rel=1e-15)


def test_torque_along_principal_axes_is_eulers() -> None:
    moments, w, a = (2.0, 3.0, 4.5), (10.0, -7.0, 4.0), (1.0, 2.0, -3.0)
    diagonal = ((2.0, 0.0, 0.0), (0.0, 3.0, 0.0), (0.0, 0.0, 4.5))
    found = torque(tensor=diagonal, angular_velocity=w, angular_acceleration=a)
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        want = -moments[k] * a[k] + (moments[i] - moments[j]) * w[i] * w[j]
        assert found.inertia_torque[k] == pytest.approx(want, rel=1e-15)
    assert found.rotational_energy == 0.5 * sum(m * x * x for m, x in zip(moments, w, strict=True))


def test_the_gyroscopic_torque_does_no_work_and_vanishes_on_a_principal_axis() -> None:
    w = (3.0, -2.0, 5.0)
    found = torque(tensor=FULL, angular_velocity=w)
    assert sum(t * x for t, x in zip(found.gyroscopic_part, w, strict=True)) == pytest.approx(0.0, abs=1e-12)
    axis = tensor(inertia=Whole(FULL)).principal_axes[1]
    along = torque(tensor=FULL, angular_velocity=tuple(100.0 * x for x in axis))  # type: ignore[arg-type]
    assert all(abs(t) < 1e-9 for t in along.gyroscopic_part)


def test_an_inertia_force_needs_mass_and_acceleration() -> None:
    found = torque(tensor=FULL, mass=2.0, acceleration=(1.0, -2.0, 0.0))
    assert found.inertia_force == (-2.0, 4.0, 0.0)
    with pytest.raises(MissingError, match="both the mass and its acceleration"):
        torque(tensor=FULL, mass=2.0)
    with pytest.raises(InadmissibleError, match="exceeds the sum"):
        torque(tensor=((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 3.0)))


@pytest.mark.parametrize(
    ("words", "status"),
    [
        (["tensor", "--moments", "1, 2, 3 kg"], 2),
        (["tensor", "--moments", "-1, 2, 3 kg*m^2"], 2),
        (["tensor", "--moments", "1, 2, 3"], 2),
        (["tensor"], 2),
        (["tensor", "--moments", "1, 2, 3 kg*m^2", "--tensor", "1,2,3 kg*m^2"], 2),
        (["tensor", "--tensor", "[[1, 2, 0], [3, 4, 0], [0, 0, 5]] kg*m^2"], 2),
        (["tensor", "--moments", "1, 2, 9 kg*m^2"], 3),
        (["tensor", "--moments", "1, 2, 2 kg*m^2", "--mass", "0 kg"], 3),
        (["tensor", "--moments", "1, 2, 2 kg*m^2", "--tolerance", "0"], 2),
        (["torque", "--tensor", "1,2,3 kg*m^2", "--angular-velocity", "1, 2, 3 m/s"], 2),
        (["torque", "--tensor", "1,2,3 kg*m^2", "--angular-velocity", "1e200, 1e200, 1e200 rad/s"], 3),
    ],
)
def test_hostile_calls_are_refused_in_order(words: list[str], status: int) -> None:
    outcome = run("inertia", *words, "--json")
    assert outcome.status == status, outcome.err
    assert outcome.error["message"]


def numbers(text: str) -> list[float]:
    return [float(word) for word in text.split()]


@pytest.mark.parametrize("axes", ["given", "principal"])
def test_files_for_simulators_hold_the_tensor_about_the_mass_centre(axes: str) -> None:
    found = shape(Wedge(0.3, 0.4, 0.5), amount=OfMass(2.0), axes=Axes(axes), product_sign=ProductSign("positive"))
    plain = shape(Wedge(0.3, 0.4, 0.5), amount=OfMass(2.0))
    want = {
        "ixx": plain.moments.xx, "iyy": plain.moments.yy, "izz": plain.moments.zz,
        "ixy": plain.products.xy, "ixz": plain.products.zx, "iyz": plain.products.yz,
    }  # fmt: skip
    robot = ET.fromstring(urdf(found))
    assert robot.tag == "robot"
    (link,) = robot.findall("link/inertial")
    assert {k: float(v) for k, v in link.find("inertia").attrib.items()} == pytest.approx(want, abs=1e-17)  # type: ignore[union-attr]
    assert numbers(link.find("origin").attrib["xyz"]) == list(plain.centroid)  # type: ignore[union-attr]
    (pose,) = ET.fromstring(sdf(found)).findall("model/link/inertial")
    assert {e.tag: float(e.text or "") for e in pose.find("inertia")} == pytest.approx(want, abs=1e-17)  # type: ignore[union-attr]
    mujoco = ET.fromstring(mjcf(found)).find("worldbody/body/inertial").attrib  # type: ignore[union-attr]
    order = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
    assert numbers(mujoco["fullinertia"]) == pytest.approx([want[k] for k in order], abs=1e-17)
    assert float(mujoco["mass"]) == 2.0


@pytest.mark.parametrize("ending", ["urdf", "sdf", "mjcf", "xml"])
def test_the_command_writes_them(tmp_path: Path, ending: str) -> None:
    file = tmp_path / f"part.{ending}"
    found = answer("inertia", "body", str(ROOT / "examples" / "payload.toml"), "--drawing", str(file))
    assert found["files"][-1]["written"] is True
    assert "15.67" in file.read_text()


def test_a_lamina_keeps_its_plane_in_every_file() -> None:
    robot = ET.fromstring(urdf(shape(QuarterDisk(Radius(0.3)), amount=OfMass(1.0))))
    inertia = {k: float(v) for k, v in robot.find("link/inertial/inertia").attrib.items()}  # type: ignore[union-attr]
    assert inertia["izz"] == inertia["ixx"] + inertia["iyy"]


class TestReading:
    @pytest.mark.parametrize("text", [True, False])
    def test_products_of_matrices_are_symmetric_to_rounding(self, text: bool) -> None:
        """R I Rᵀ as numpy makes it differs across the diagonal in the last bits, in most cases."""
        draw = np.random.default_rng(11)
        apart = 0
        for _ in range(60):
            turn, _ = np.linalg.qr(draw.normal(size=(3, 3)))
            full = (turn @ np.diag(draw.uniform(1.0, 1.9, 3) * 10.0 ** draw.integers(-3, 4)) @ turn.T).tolist()
            apart += any(full[i][j] != full[j][i] for i in range(3) for j in range(i))
            if text:
                document = answer("inertia", "tensor", "--tensor", f"{full} kg*m^2")
            else:
                given = json.dumps({"tensor": {"value": full, "unit": "kg*m^2"}})
                document = answer("inertia", "tensor", "--input", "-", stdin=given)
            wanted = np.linalg.eigvalsh(np.array(full))
            found = [document["results"]["principal_moments"][name]["value"] for name in ("first", "second", "third")]
            assert found == pytest.approx(wanted.tolist(), rel=1e-12)
        assert apart > 30
        assert run("inertia", "tensor", "--tensor", "[[2, 0.1, 0], [0.1000001, 2, 0], [0, 0, 2]] kg*m^2").status == 2

    @pytest.mark.parametrize(
        "given", ["[[1, 2, 3], [4, 5, 6]] kg*m^2", "[[1, 2], [3, 4], [5, 6]] kg*m^2", "[[1, 2, 3]] kg*m^2"]
    )
    def test_rows_that_are_not_three_by_three_are_refused(self, given: str) -> None:
        outcome = run("inertia", "tensor", "--tensor", given, "--json")
        assert outcome.status == 2
        assert "wanted 3 rows of 3" in outcome.error["message"]
        value = json.loads(given.removesuffix(" kg*m^2"))
        again = run(
            "inertia", "tensor", "--input", "-", "--json",
            stdin=json.dumps({"tensor": {"value": value, "unit": "kg*m^2"}}),
        )  # fmt: skip
        assert "wanted 3 rows of 3" in again.error["message"]

    def test_one_list_of_six_is_moments_and_products(self) -> None:
        one = answer("inertia", "tensor", "--tensor", "[2, 3, 4, 0.1, 0.2, 0.3] kg*m^2")
        other = answer("inertia", "tensor", "--tensor", "[[2, 0.1, 0.3], [0.1, 3, 0.2], [0.3, 0.2, 4]] kg*m^2")
        assert one["results"] == other["results"]


class TestBodiesThatNoTensorHas:
    """Each diagonal element is less than the others together; of the principal moments 0.0105, 0.02, 0.0595 not."""

    TENSOR = "[[0.02, 0, 0], [0, 0.03, 0.024], [0, 0.024, 0.04]] kg*m^2"

    @pytest.mark.parametrize(
        "call",
        [("tensor", "--tensor", TENSOR), ("torque", "--tensor", TENSOR, "--angular-velocity", "1, 0, 0 rad/s")],
        ids=["tensor", "torque"],
    )
    def test_by_options(self, call: tuple[str, ...]) -> None:
        outcome = run("inertia", *call, "--json")
        assert (outcome.status, outcome.error["code"]) == (3, "triangle-inequality")

    def test_of_parts(self, tmp_path: Path) -> None:
        part = {"mass": "2 kg", "tensor": self.TENSOR}
        body = tmp_path / "body.json"
        body.write_text(json.dumps({"parts": [part]}))
        outcome = run("inertia", "body", str(body), "--json")
        assert (outcome.status, outcome.error["code"]) == (3, "triangle-inequality")
        pair = tmp_path / "pair.json"
        pair.write_text(json.dumps({"first": {"parts": [{"mass": "1 kg"}]}, "second": {"parts": [part]}}))
        outcome = run("inertia", "compare", str(pair), "--json")
        assert (outcome.status, outcome.error["code"]) == (3, "triangle-inequality")


def test_second_moments_are_half_the_trace_less_the_tensor() -> None:
    """Of a solid block of 2 × 3 × 4 and mass 12 they are a², b², c², and they turn as a tensor does."""
    block = "[[25, 0, 0], [0, 20, 0], [0, 0, 13]] kg*m^2"
    found = answer("inertia", "tensor", "--tensor", block)
    assert found["results"]["second_moments"]["value"] == [[4.0, 0.0, 0.0], [0.0, 9.0, 0.0], [0.0, 0.0, 16.0]]
    assert found["results"]["second_moments"]["unit"] == "kg·m²"
    turned = answer("inertia", "tensor", "--tensor", block, "--rotation-axis", "0, 0, 1", "--rotation-angle", "90 deg")
    second = np.array(turned["results"]["second_moments"]["value"])
    assert second == pytest.approx(np.diag([9.0, 4.0, 16.0]), abs=1e-13)


def test_rows_may_be_separated_by_semicolons() -> None:
    nested = answer("inertia", "tensor", "--tensor", "[[10, -2, 1], [-2, 12, 3], [1, 3, 14]] kg*m^2")
    rows = answer("inertia", "tensor", "--tensor", "10, -2, 1; -2, 12, 3; 1, 3, 14 kg*m^2")
    assert rows["results"] == nested["results"]
    assert "rows of 2 and 3 and 3" in run("inertia", "tensor", "--tensor", "10, -2; -2, 12, 3; 1, 3, 14 kg*m^2").err


@pytest.mark.parametrize(
    "written",
    [
        "10, -2, 1; -2, 12, 3; 1, 3, 14 kg*m^2",
        "10 -2 1; -2 12 3; 1 3 14 kg*m^2",
        "(10, -2, 1), (-2, 12, 3), (1, 3, 14) kg*m^2",
    ],
)
def test_a_tensor_may_be_written_in_rows(written: str) -> None:
    first = run("inertia", "tensor", "--tensor", written, "--only", "principal_moments.first")
    assert first.out == "7.70286 kg·m²\n"
    moments = run("inertia", "tensor", "--moments", "10 12 14 kg*m^2", "--only", "principal_moments.third")
    assert moments.out == "14 kg·m²\n"
