"""Meshes against exact references: errors, bounds, and what the family promises of thin and of distant bodies."""

import json
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from mpmath import mp, mpf
from references.generate_inertia_mesh_references import integrals, recipe
from references.inertia_solids import triangles, write_stl

from dynamics_cli.accuracy.cases import DATA
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.inertia.bodies.amount import OfArealDensity, OfDensity
from dynamics_cli.inertia.mesh import measurement as reading
from dynamics_cli.inertia.mesh.surface import LengthUnit
from dynamics_cli.inertia.mesh.task import mesh
from dynamics_cli.numerics.tracked import Tracked

EVERY_CASE = json.loads((DATA / "inertia_mesh.json").read_text(encoding="utf-8"))["cases"]
CASES: list[dict[str, Any]] = [case for case in EVERY_CASE if case["task"] == "mesh"]
U = mpf(2) ** -53
EVERY = pytest.mark.parametrize("index", range(len(CASES)), ids=[case["name"] for case in CASES])


def plain(tree: Any) -> Any:
    if isinstance(tree, dict):
        return {name: part if name == "solid" else plain(part) for name, part in tree.items()}
    if isinstance(tree, list):
        return [plain(part) for part in tree]
    return float(tree) if isinstance(tree, str) else tree


def by_address(record: Any, address: str) -> Any:
    for name in address.replace("]", "").replace("[", ".").split("."):
        record = record[int(name)] if name.isdigit() else getattr(record, name)
    return record


@cache
def measured(index: int, folder: Path, few: int = reading.FEW) -> list[tuple[str, Any, Any, Any]]:
    """Address, reference, true error and stated bound of every result of a case; `few` triangles in whole numbers."""
    mp.dps = 60
    case = CASES[index]
    inputs = plain(case["inputs"])
    path = folder / f"{index}.stl"
    write_stl(path, triangles(inputs), binary=inputs["single"])
    one = Tracked(1.0, 0.0, (1.0,))
    amount = OfArealDensity(one) if inputs["shell"] else OfDensity(one)
    reading._LAST.clear()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(reading, "FEW", few)
        made = mesh(str(path), length_unit=LengthUnit("m"), amount=amount)  # type: ignore[arg-type]
    found = []
    for address, text in case["results"].items():
        own, reference = by_address(made, address), mpf(text)
        error = max(abs(own.value - reference) - abs(reference) * mpf(10) ** -39, mpf(0))
        found.append((address, reference, error, mpf(own.error)))
    return found


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("meshes")


def scale_of(address: str, rows: list[tuple[str, Any, Any, Any]]) -> Any:
    """What an error is measured by: the number, but for coordinates and products the largest of their kind."""
    kind = address.split(".")[0].split("[")[0]
    kin = {"products": ("products", "moments"), "centroid": ("centroid",), "moments": ("moments",)}.get(kind)
    return max(abs(r) for a, r, _, _ in rows if (a == address if kin is None else a.startswith(kin)))


def cancelled(index: int) -> float:
    """How much larger than their difference two surfaces are: a wall of 1 % leaves 3 % of the volume."""
    return 1.0 / (1.0 - 0.99**3) if "hollow" in CASES[index]["name"] and not CASES[index]["inputs"]["shell"] else 1.0


# by the way that its number of triangles asks for, and by the one that more of them would
WAYS = pytest.mark.parametrize("few", [reading.FEW, 0], ids=["", "in doubles"])


@WAYS
@EVERY
def test_every_bound_holds(index: int, few: int, folder: Path) -> None:
    rows = measured(index, folder, few)
    assert [(a, float(e), float(b)) for a, _, e, b in rows if e > b] == []


@WAYS
@EVERY
def test_thin_or_far_no_digit_is_lost(index: int, few: int, folder: Path) -> None:
    for address, reference, error, _ in measured(index, folder, few):
        if address.startswith(("principal", "volume", "area")):
            assert error <= 2e-15 * cancelled(index) * abs(reference), address


@pytest.mark.parametrize(
    ("solid", "shell", "stretch", "quaternion", "offset"),
    [
        # corners on few planes: slivers whose normals are small differences
        ("hollow ball", True, (1.1579057613544608e-06, 1.0, 4.339789464892827e-07),
         (0.4672648380964908, 0.09101777301063718, -0.13334979794471713, 0.04904933202500139),
         (-686671.2212973118, 111.51660928946501, -0.0)),
        # faces that overlap: 1e-5 of the volume of the pieces is left
        ("ball 1", False, (4.86701289842683e-06, 1.0, 1.0665268401674459e-05),
         (0.4725303871435367, -0.5112828827977729, -0.5940675403495015, -0.008336961677416488),
         (0.0, -71392684.1989399, -0.0)),
    ],
)  # fmt: skip
def test_bounds_hold_where_single_precision_leaves_no_shape(
    solid: str, shell: bool, stretch: Any, quaternion: Any, offset: Any, folder: Path
) -> None:
    mp.dps = 60
    inputs = recipe(solid, stretch, quaternion, offset, single=True, shell=shell)
    path = folder / "collapsed.stl"
    write_stl(path, triangles(inputs), binary=True)
    one = Tracked(1.0, 0.0, (1.0,))
    made = mesh(str(path), length_unit=LengthUnit("m"), amount=OfArealDensity(one) if shell else OfDensity(one))  # type: ignore[arg-type]
    for address, text in integrals(inputs).items():
        own = by_address(made, address)
        assert abs(own.value - mpf(text)) <= own.error, address


def test_a_surface_whose_second_moment_is_negative_is_refused(folder: Path) -> None:
    """Rounding to single precision has pushed the inner surface of a flat hollow body through the outer one."""
    stretch, turn = (1.0, 5.112285578557569e-06, 3.664419566395208e-07), (
        0.2151757659475666, 0.2484434120778023, -0.05789805408238524, -0.9985539893280186,
    )  # fmt: skip
    path = folder / "crossing.stl"
    inputs = recipe("hollow ball", stretch, turn, (0.0, 0.0, 0.0), single=True)
    assert float(integrals(inputs)["principal_moments.first"]) > 0.0
    write_stl(path, triangles(inputs), binary=True)
    with pytest.raises(InadmissibleError) as caught:
        mesh(str(path), length_unit=LengthUnit("m"), amount=OfDensity(1.0))  # type: ignore[arg-type]
    assert caught.value.code == "crossing"


@EVERY
def test_bounds_in_doubles_are_within_reason(index: int, folder: Path) -> None:
    rows = measured(index, folder, 0)
    for address, _, error, bound in rows:
        if address.startswith("centroid"):
            continue
        assert bound <= 100 * max(error, U * cancelled(index) * scale_of(address, rows)), address
