"""Meshes: files of every fault, surfaces open, flipped and inside out, shells, views, and what must not change."""

import math
import os
import struct
import threading
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from harness import answer, run
from references.inertia_solids import SOLIDS, ball, prism, write_stl

from dynamics_cli.errors import DynamicsError, ExitStatus, InadmissibleError, UsageError
from dynamics_cli.inertia.bodies.amount import OfArealDensity, OfDensity, OfLinearDensity, OfMass
from dynamics_cli.inertia.bodies.properties import Axes, MassProperties
from dynamics_cli.inertia.bodies.records import Shaft
from dynamics_cli.inertia.mesh import measurement as reading
from dynamics_cli.inertia.mesh import passes
from dynamics_cli.inertia.mesh import stl as forms
from dynamics_cli.inertia.mesh.faults.closure import edge_sum, vertex_hashes
from dynamics_cli.inertia.mesh.opening import open_mesh
from dynamics_cli.inertia.mesh.passes import first_pass, second_pass
from dynamics_cli.inertia.mesh.pictures import DRAWN, mesh_picture, outlines
from dynamics_cli.inertia.mesh.stl import BLOCK, BinaryStl, Corners
from dynamics_cli.inertia.mesh.surface import LengthUnit
from dynamics_cli.inertia.mesh.task import mesh
from dynamics_cli.inertia.mesh.tracked_integrals import Lift

BOX = prism([(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0)], 1.0)


def stl(folder: Path, made: list[Any], *, binary: bool = True) -> str:
    path = folder / ("part.stl" if binary else "text.stl")
    write_stl(path, made, binary=binary)
    return str(path)


def solid(name: str, **more: Any) -> MassProperties:
    inputs = {"length_unit": LengthUnit("m"), "amount": OfDensity(1.0), **more}
    return mesh(name, **inputs)


def refused(name: str, kind: type[DynamicsError] = InadmissibleError, **more: Any) -> DynamicsError:
    with pytest.raises(kind) as caught:
        solid(name, **more)
    return caught.value


def torus(around: int, across: int) -> np.ndarray:
    """Corners of a torus of radii 3 and 1, (n, 3, 3)."""
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across, indexing="ij")
    points = np.stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)], -1).astype(np.float32)
    b, d = np.roll(points, -1, 0), np.roll(points, -1, 1)
    c = np.roll(b, -1, 1)
    halves = [np.stack(three, -2).reshape(-1, 3, 3) for three in ((points, b, c), (points, c, d))]
    return np.concatenate(halves).astype(float)


def write_array(path: Path, made: np.ndarray) -> str:
    rows = np.zeros(len(made), dtype=[("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")])
    rows["v"] = made
    path.write_bytes(b"torus".ljust(80) + struct.pack("<I", len(made)) + rows.tobytes())
    return str(path)


class TestFiles:
    def test_text_and_binary_give_the_same(self, tmp_path: Path) -> None:
        binary, text = solid(stl(tmp_path, BOX)), solid(stl(tmp_path, BOX, binary=False))
        assert binary.tensor == text.tensor
        assert (binary.volume, binary.centroid) == (6.0, (1.5, 1.0, 0.5))
        assert binary.surface is not None
        assert text.surface is not None
        assert (binary.surface.form, text.surface.form) == ("binary STL", "ASCII STL")
        assert text.surface.quantisation is None

    def test_a_binary_header_may_say_solid(self, tmp_path: Path) -> None:
        path = Path(stl(tmp_path, BOX))
        path.write_bytes(b"solid facet normal".ljust(80) + path.read_bytes()[80:])
        assert solid(str(path)).volume == 6.0

    def test_words_in_capitals_and_several_solids(self, tmp_path: Path) -> None:
        path = Path(stl(tmp_path, BOX, binary=False))
        other = prism([(10.0, 0.0), (11.0, 0.0), (11.0, 1.0), (10.0, 1.0)], 1.0)
        write_stl(tmp_path / "other.stl", other, binary=False)
        path.write_text((path.read_text() + (tmp_path / "other.stl").read_text()).upper())
        assert solid(str(path)).volume == 7.0

    @pytest.mark.parametrize("name", ["vertex", "outer loop", "solid facet normal", "Émile", ""])
    def test_a_solid_may_have_any_name(self, tmp_path: Path, name: str) -> None:
        path = Path(stl(tmp_path, BOX, binary=False))
        path.write_text(path.read_text().replace("recipe", name), encoding="utf-8")
        assert solid(str(path)).volume == 6.0

    def test_a_text_of_many_chunks(self, tmp_path: Path) -> None:
        corners = torus(80, 60)
        path = tmp_path / "torus.stl"
        write_stl(path, [tuple(tuple(p) for p in t) for t in corners.tolist()], binary=False)
        assert path.stat().st_size > 2**21
        whole = np.concatenate([block.T for block in open_mesh(str(path)).blocks()])
        assert (whole.reshape(-1, 3, 3) == corners).all()

    def test_windows_line_ends(self, tmp_path: Path) -> None:
        path = Path(stl(tmp_path, BOX, binary=False))
        path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
        assert solid(str(path)).volume == 6.0

    def test_an_empty_file(self, tmp_path: Path) -> None:
        (tmp_path / "a.stl").write_bytes(b"")
        assert refused(str(tmp_path / "a.stl")).code == "empty"

    def test_no_triangles(self, tmp_path: Path) -> None:
        (tmp_path / "a.stl").write_bytes(b"x".ljust(80) + struct.pack("<I", 0))
        assert refused(str(tmp_path / "a.stl")).code == "empty"
        (tmp_path / "b.stl").write_text("solid x\nendsolid x\n")
        assert refused(str(tmp_path / "b.stl")).code == "empty"

    @pytest.mark.parametrize("size", [1, 5, 83, 84, 100, 84 + 50 * 11 + 49])
    def test_cut_off(self, tmp_path: Path, size: int) -> None:
        path = Path(stl(tmp_path, BOX))
        path.write_bytes(path.read_bytes()[:size])
        assert refused(str(path)).code == "truncated"

    @pytest.mark.parametrize("share", [0.3, 0.6, 0.99])
    def test_text_cut_off(self, tmp_path: Path, share: float) -> None:
        path = Path(stl(tmp_path, BOX, binary=False))
        whole = path.read_bytes()
        path.write_bytes(whole[: int(share * len(whole)) - 10])
        assert refused(str(path)).code in ("truncated", "stl")

    @pytest.mark.parametrize("claimed", [13, 2**31, 2**32 - 1])
    def test_more_triangles_claimed_than_there_are(self, tmp_path: Path, claimed: int) -> None:
        path = Path(stl(tmp_path, BOX))
        data = path.read_bytes()
        path.write_bytes(data[:80] + struct.pack("<I", claimed) + data[84:])
        error = refused(str(path))
        assert error.code == "truncated"
        assert str(claimed) in error.message

    def test_fewer_triangles_claimed_than_there_are(self, tmp_path: Path) -> None:
        path = Path(stl(tmp_path, BOX))
        path.write_bytes(path.read_bytes() + b"more")
        assert refused(str(path)).code == "count"

    def test_words_that_are_no_numbers(self, tmp_path: Path) -> None:
        path = Path(stl(tmp_path, BOX, binary=False))
        path.write_text(path.read_text().replace("vertex 3.0 2.0 1.0", "vertex 3.0 two 1.0"))
        assert refused(str(path)).code == "stl"

    def test_a_corner_too_few(self, tmp_path: Path) -> None:
        path = Path(stl(tmp_path, BOX, binary=False))
        path.write_text(path.read_text().replace("vertex 3.0 2.0 1.0\n", "", 1))
        assert refused(str(path)).code == "stl"

    @pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
    @pytest.mark.parametrize("place", [0, 7, 11])
    def test_a_number_that_is_none_is_named(self, tmp_path: Path, bad: float, place: int) -> None:
        made = list(BOX)
        a, b, c = made[place]
        made[place] = (a, (b[0], bad, b[2]), c)
        for binary in (True, False):
            error = refused(stl(tmp_path, made, binary=binary))
            assert error.code == "not-finite"
            assert f"coordinate y of corner 2 of triangle {place + 1}" in error.message

    def test_coordinates_out_of_range(self, tmp_path: Path) -> None:
        huge = [tuple(tuple(1e60 * x for x in p) for p in t) for t in BOX]
        assert refused(stl(tmp_path, huge, binary=False)).code == "range"

    def test_an_unknown_ending_and_garbage(self, tmp_path: Path) -> None:
        (tmp_path / "part.step").write_text("ISO-10303-21;")
        assert refused(str(tmp_path / "part.step")).code == "form"
        (tmp_path / "part.stl").write_bytes(bytes(range(256)) * 4)
        assert refused(str(tmp_path / "part.stl")).code in ("truncated", "count")

    def test_trimesh_is_asked_for_by_name(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setitem(__import__("sys").modules, "trimesh", None)
        (tmp_path / "part.obj").write_text("v 0 0 0\n")
        error = refused(str(tmp_path / "part.obj"), UsageError)
        assert error.code == "not-installed"
        assert error.status == ExitStatus.USAGE
        assert "dynamics-cli[mesh]" in str(error.hint)

    def test_a_file_that_changes_is_read_again(self, tmp_path: Path) -> None:
        name = stl(tmp_path, BOX)
        assert solid(name).volume == 6.0
        stl(tmp_path, ball(1))
        assert solid(name).volume != 6.0


class TestSurfaces:
    def test_open(self, tmp_path: Path) -> None:
        error = refused(stl(tmp_path, BOX[:-1]))
        assert error.code == "open"
        assert "3 open edges" in error.message
        # slivers round an axis, all near one another
        large = prism([(math.cos(k * math.tau / 900), math.sin(k * math.tau / 900)) for k in range(900)], 1.0)
        error = refused(stl(tmp_path, large[:-1]))
        assert "--diagnose" in str(error.hint)
        assert "3 open edges" in refused(stl(tmp_path, large[:-1]), diagnose=True).message

    def test_open_allowed(self, tmp_path: Path) -> None:
        made = solid(stl(tmp_path, BOX[:-1]), allow_open=True)
        assert made.surface is not None
        assert made.surface.closed == "no"
        # the face that is missing has an area of 1 (its legs are 2 and 1) of 22
        assert made.surface.closure == pytest.approx(1.0 / 21.0, rel=1e-12)
        assert [(advice.code, advice.severity) for advice in made.advice] == [("open-surface", "serious")]
        # a check is of our own work: what is wrong with the file is a warning
        assert made.checks == ()

    def test_the_command_answers_for_an_open_surface(self, tmp_path: Path) -> None:
        name = stl(tmp_path, BOX[:-1])
        found = answer("inertia", "mesh", name, "--length-unit", "m", "--material", "steel", "--allow-open")
        assert found["results"]["surface"]["closed"] == "no"
        assert [warning["code"] for warning in found["warnings"]] == ["open-surface"]

    def test_a_shell_says_whether_it_is_closed(self, tmp_path: Path) -> None:
        for made, closed in ((BOX, "yes"), (BOX[:-1], "no")):
            found = solid(stl(tmp_path, made), amount=OfArealDensity(1.0))
            assert found.surface is not None
            assert found.surface.closed == closed

    def test_a_surface_given_twice_is_warned_of_when_diagnosed(self, tmp_path: Path) -> None:
        made = solid(stl(tmp_path, BOX + BOX), diagnose=True)
        assert made.volume == 12.0
        assert [advice.code for advice in made.advice] == ["duplicated"]
        assert solid(stl(tmp_path, BOX), diagnose=True).advice == ()

    def test_opposite_faces_missing_have_no_closure_vector_and_are_found_all_the_same(self, tmp_path: Path) -> None:
        walls = BOX[4:]
        made = solid(stl(tmp_path, walls), allow_open=True)
        assert made.surface is not None
        assert made.surface.closure < 1e-15
        assert refused(stl(tmp_path, walls)).code == "open"

    def test_one_flipped(self, tmp_path: Path) -> None:
        made = list(BOX)
        made[5] = (made[5][0], made[5][2], made[5][1])
        name = stl(tmp_path, made)
        assert refused(name).code == "open"
        faults = solid(name, allow_open=True, diagnose=True).surface.faults  # type: ignore[union-attr]
        assert faults is not None
        assert (faults.flipped, faults.open_edges, faults.clashing_edges) == (1, 0, 3)
        assert "triangle 6 is flipped" in faults.places

    def test_inside_out(self, tmp_path: Path) -> None:
        name = stl(tmp_path, [(a, c, b) for a, b, c in BOX])
        assert refused(name).code == "inverted"
        # the area and so a shell do not mind
        assert solid(name, amount=OfArealDensity(1.0)).area == 22.0

    def test_a_crack_of_one_rounding(self, tmp_path: Path) -> None:
        made = ball(2)
        (x, y, z), b, c = made[17]
        step = math.ldexp(1.0, -24)
        made[17] = ((x + step * (1.0 if abs(x) > 0.3 else 0.0), y + (0.0 if abs(x) > 0.3 else step), z), b, c)
        assert refused(stl(tmp_path, made)).code == "open"

    @pytest.mark.parametrize("binary", [True, False])
    @pytest.mark.parametrize("index", range(0, 128, 9))
    def test_any_triangle_missing_flipped_or_mirrored_is_found(self, tmp_path: Path, index: int, binary: bool) -> None:
        made = ball(2)
        assert refused(stl(tmp_path, made[:index] + made[index + 1 :], binary=binary)).code == "open"
        a, b, c = made[index]
        made[index] = (a, c, b)
        assert refused(stl(tmp_path, made, binary=binary)).code == "open"
        for signs in ((-1.0, -1.0, 1.0), (-1.0, 1.0, 1.0), (1.0, -1.0, -1.0)):
            made[index] = tuple(tuple(s * x for s, x in zip(signs, p, strict=True)) for p in (a, b, c))  # type: ignore[assignment]
            assert refused(stl(tmp_path, made, binary=binary)).code == "open"

    @pytest.mark.parametrize("single", [True, False])
    @pytest.mark.parametrize("step", [1.0, 0.001, 2.0**40])
    def test_numbers_of_vertices_do_not_repeat(self, single: bool, step: float) -> None:
        side = np.arange(-27.0, 27.0) * step
        x, y, z = (part.ravel() for part in np.meshgrid(side, side, side))
        points = np.stack([x, y, z]).astype(np.float32 if single else float).astype(float) + 0.0
        h, spare = np.empty((2, 1, points.shape[1]), np.uint64)
        vertex_hashes(points, h, spare)
        assert len(np.unique(h[0])) == points.shape[1]
        # nor do their last bits, which decide whether a product of their differences vanishes
        for bits in (8, 12, 16):
            counts = np.bincount((h[0] % np.uint64(1 << bits)).astype(np.intp), minlength=1 << bits)
            expected = h.size / (1 << bits)
            assert ((counts - expected) ** 2).sum() / expected == pytest.approx(1 << bits, rel=8.0 / 2 ** (bits / 2))

    @pytest.mark.parametrize("step", [1.0, 0.001])
    @pytest.mark.parametrize("axis", [0, 1, 2])
    def test_a_corner_in_the_middle_of_an_edge_opens_it(self, axis: int, step: float) -> None:
        """Also where all three lie along an axis and the numbers are whole."""
        low, middle, high = (np.roll((k * step, 3.0 * step, 5.0 * step), axis) for k in (0.0, 1.0, 2.0))
        one, other = np.roll((1.0, 9.0, 5.0), axis), np.roll((1.0, 3.0, -9.0), axis)
        made = [(low, high, one), (high, low, other), (low, one, other), (one, high, other)]
        whole = np.array(made).reshape(-1, 9).T + 0.0
        cut = np.array([*made[1:], (low, middle, one), (middle, high, one)]).reshape(-1, 9).T + 0.0

        def sums(corners: np.ndarray) -> int:
            rows = np.ascontiguousarray(corners)
            return edge_sum(rows, *np.empty((2, 3, rows.shape[1]), np.uint64))

        assert sums(whole) == 0
        assert sums(cut) != 0

    def test_the_sum_is_that_over_directed_edges(self) -> None:
        corners = np.random.default_rng(3).normal(size=(9, 50))
        h, g = np.empty((2, 3, 50), np.uint64)
        vertex_hashes(corners, h, g)
        assert (g == h >> np.uint64(32)).all()
        whole = [[int(value) for value in row] for row in h]
        upper = [[value >> 32 for value in row] for row in whole]
        edges = 0
        for u, v in ((0, 1), (1, 2), (2, 0)):
            edges += sum(whole[u][k] * upper[v][k] - whole[v][k] * upper[u][k] for k in range(50))
        assert edge_sum(corners, h, g) == edges % 2**64

    def test_minus_zero_is_zero(self, tmp_path: Path) -> None:
        made = [tuple(tuple(-0.0 if x == 0.0 and k % 2 else x for x in p) for p in t) for k, t in enumerate(BOX)]
        assert solid(stl(tmp_path, made)).volume == 6.0
        assert solid(stl(tmp_path, made, binary=False)).volume == 6.0

    def test_a_hollow_body_has_its_inner_surface_turned_inwards(self, tmp_path: Path) -> None:
        inner = [tuple(tuple(0.5 * x for x in p) for p in (a, c, b)) for a, b, c in ball(2)]
        made = solid(stl(tmp_path, ball(2) + inner), diagnose=True)
        assert made.volume == pytest.approx(solid(stl(tmp_path, ball(2))).volume * 0.875, rel=1e-6)
        assert made.surface is not None
        assert made.surface.faults is not None
        assert made.surface.faults.shells == 2
        assert made.surface.faults.flipped == 0

    def test_duplicated_and_degenerate_triangles_are_counted(self, tmp_path: Path) -> None:
        a, b, c = BOX[0]
        sheet = [BOX[0], (a, c, b)]
        flat = [((9.0, 0.0, 0.0), (9.0, 0.0, 0.0), (9.0, 1.0, 0.0))]
        faults = solid(stl(tmp_path, BOX + sheet + flat), allow_open=True, diagnose=True).surface.faults  # type: ignore[union-attr]
        assert faults is not None
        assert (faults.duplicated, faults.degenerate) == (2, 1)
        assert "triangle 15 has no area" in faults.places

    def test_a_doubled_sheet_encloses_nothing(self, tmp_path: Path) -> None:
        a, b, c = BOX[0]
        assert refused(stl(tmp_path, [(a, b, c), (a, c, b)])).code == "no-volume"

    def test_parts_inside_out_make_negative_moments_and_are_refused(self, tmp_path: Path) -> None:
        small = [
            tuple(tuple(x / 3.0 + 40.0 * (k == 0) for k, x in enumerate(p)) for p in (a, c, b)) for a, b, c in ball(1)
        ]
        assert refused(stl(tmp_path, ball(1) + small)).code == "crossing"

    def test_far_from_the_origin_single_precision_is_warned_of(self, tmp_path: Path) -> None:
        far = [tuple((x + 1e5, y, z) for x, y, z in t) for t in ball(2)]
        made = solid(stl(tmp_path, far))
        assert [advice.code for advice in made.advice] == ["coarse-coordinates"]

    def test_the_quantisation_is_the_order_of_the_error(self, tmp_path: Path) -> None:
        ratios = []
        for k in range(8):
            moved = [tuple((0.9 * x + 100.3 + k, 0.8 * y + 70.7, z + 33.1) for x, y, z in t) for t in ball(3)]
            exact = solid(stl(tmp_path, moved, binary=False)).volume
            rounded = solid(stl(tmp_path, moved))
            assert exact is not None
            assert rounded.surface is not None
            ratios.append((rounded.volume - exact) / rounded.surface.quantisation)
        assert 0.2 < math.sqrt(sum(r * r for r in ratios) / len(ratios)) < 5.0


class TestAmounts:
    def test_a_density_of_the_wrong_dimension(self, tmp_path: Path) -> None:
        name = stl(tmp_path, BOX)
        assert refused(name, amount=OfLinearDensity(1.0)).code == "dimension"
        assert refused(name, amount=OfArealDensity(1.0), thickness=0.1).code == "exclusive"
        assert refused(name, thickness=0.0).code == "thickness"
        assert refused(name, amount=OfMass(0.0)).code == "no-mass"
        assert refused(name, amount=OfDensity(0.0)).code == "no-mass"

    def test_a_shell_of_a_box_by_its_faces(self, tmp_path: Path) -> None:
        name = stl(tmp_path, BOX)
        made = solid(name, amount=OfDensity(10.0), thickness=0.1)
        assert made.area == pytest.approx(22.0, rel=1e-15)
        assert made.mass == pytest.approx(22.0, rel=1e-15)
        # about x: two faces across x, two across y (area 3, at 1 from the centre), two across z (area 6, at 1/2)
        xx = 2 * (2.0 * (4 + 1) / 12) + 2 * (3.0 * (1.0 / 12 + 1.0)) + 2 * (6.0 * (4.0 / 12 + 0.25))
        assert made.moments.xx == pytest.approx(xx, rel=1e-14)
        assert solid(name, amount=OfArealDensity(1.0)).moments.xx == pytest.approx(xx, rel=1e-14)

    @pytest.mark.parametrize(("wall", "severity"), [(90.0, None), (110.0, "caution"), (510.0, "serious")])
    def test_a_wall_that_is_not_thin_is_warned_of(self, tmp_path: Path, wall: float, severity: str | None) -> None:
        made = solid(stl(tmp_path, BOX), length_unit=LengthUnit("m"), thickness=wall * 1e-3)
        assert [a.severity for a in made.advice if a.code == "thick-wall"] == ([severity] if severity else [])

    def test_an_open_shell_needs_no_proof(self, tmp_path: Path) -> None:
        made = solid(stl(tmp_path, BOX[:1]), amount=OfArealDensity(2.0))
        assert (made.area, made.mass) == (pytest.approx(3.0, rel=1e-15), pytest.approx(6.0, rel=1e-15))
        assert made.principal_moments.third == pytest.approx(
            made.principal_moments.first + made.principal_moments.second, rel=1e-15
        )

    def test_units_of_length(self, tmp_path: Path) -> None:
        name = stl(tmp_path, BOX)
        for unit, metres in {"m": 1.0, "mm": 1e-3, "cm": 1e-2, "um": 1e-6, "in": 0.0254, "ft": 0.3048}.items():
            made = solid(name, length_unit=LengthUnit(unit))
            assert made.volume == pytest.approx(6.0 * metres**3, rel=1e-15)
            assert made.moments.zz == pytest.approx(6.5 * metres**5, rel=2e-15)


class TestViews:
    def test_about_the_origin_and_principal_axes(self, tmp_path: Path) -> None:
        name = stl(tmp_path, BOX)
        at = solid(name, about="origin")
        assert at.moments.zz == pytest.approx(6.0 * (9.0 + 4.0) / 3.0, rel=1e-15)
        assert at.products.xy == pytest.approx(-6.0 * 1.5, rel=1e-15)
        main = solid(name, axes=Axes("principal"))
        assert main.moments.xx == pytest.approx(6.0 * (4.0 + 1.0) / 12.0, rel=1e-15)
        assert main.products.xy == pytest.approx(0.0, abs=1e-16)

    def test_about_a_shaft(self, tmp_path: Path) -> None:
        made = solid(stl(tmp_path, BOX), shaft=Shaft((0.0, 0.0, 2.0), (0.0, 0.0, 5.0)))
        assert made.shaft is not None
        assert made.shaft.moment == pytest.approx(6.0 * (9.0 + 4.0) / 3.0, rel=1e-15)

    def test_a_cube_has_no_axes_of_its_own(self, tmp_path: Path) -> None:
        cube = prism([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], 1.0)
        made = solid(stl(tmp_path, cube))
        assert made.degeneracy.startswith("every axis is principal")
        assert made.principal_axes == ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))

    def test_plain_floats_in_plain_floats_out_with_bounds_beside(self, tmp_path: Path) -> None:
        made = solid(stl(tmp_path, BOX))
        assert type(made.volume) is float
        assert made.numerics is not None
        bounds = {bound.result: bound.bound for bound in made.numerics.bounds}
        assert 0.0 < bounds["volume"] < 1e-14
        assert 0.0 < bounds["principal_moments.first"] < 1e-13


class TestBlocks:
    @pytest.mark.parametrize("count", [4, BLOCK - 4, BLOCK, BLOCK + 4, 8 * BLOCK, 8 * BLOCK + 4])
    def test_no_triangle_is_lost_between_blocks(self, tmp_path: Path, count: int) -> None:
        one = np.array(SOLIDS["tetrahedron"]())
        corners = np.concatenate([one + np.array((k % 64, k // 64, 0.0)) for k in range(count // 4)])
        source = BinaryStl(write_array(tmp_path / "many.stl", corners), count)
        sums, moments = first_pass(source, shell=False, prove=True)
        assert sums.count == count
        assert moments.measure == pytest.approx(count / 24.0, rel=1e-14)
        read = np.concatenate([np.array(block, dtype=float).T for block in source.blocks()])
        assert (read.reshape(-1, 3, 3) == corners).all()
        assert sums.closed

    def test_cores_share_the_work_and_change_no_bit(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        name = write_array(tmp_path / "torus.stl", torus(330, 70))
        monkeypatch.setattr(forms, "SPAN", BLOCK)
        assert len(open_mesh(name).spans()) == 6
        answers = []
        for cores in (1, 3):
            monkeypatch.setattr(passes, "_cores", lambda cores=cores: cores)
            source = open_mesh(name)
            sums, moments = first_pass(source, shell=False, prove=True)
            again = second_pass(source, sums, moments, np.eye(3))
            assert sums.closed
            assert sums.count == 330 * 70 * 2
            answers.append(
                [moments.measure, *moments.second.ravel(), *again.second.ravel(), *sums.low, *sums.high]
                + [
                    again.measure,
                    *sums.closure,
                    *sums.squares,
                    *again.second_error.ravel(),
                    *moments.second_error.ravel(),
                ]
            )
        assert answers[0] == answers[1]

    def test_a_faulty_corner_is_named_whichever_core_reads_it(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        corners = torus(330, 70)
        corners[30_000, 1, 2] = math.nan
        corners[40_000, 0, 0] = math.inf
        monkeypatch.setattr(forms, "SPAN", BLOCK)
        monkeypatch.setattr(passes, "_cores", lambda: 4)
        assert passes._may_fork()
        with pytest.raises(InadmissibleError, match="coordinate z of corner 2 of triangle 30001 is nan"):
            first_pass(open_mesh(write_array(tmp_path / "torus.stl", corners)), shell=False, prove=True)

    @pytest.mark.parametrize(("name", "allowed"), [("hash_0", True), ("other", False)])
    def test_processes_are_forked_beside_the_hash_of_a_file_but_of_no_other_thread(
        self, name: str, allowed: bool
    ) -> None:
        end = threading.Event()
        thread = threading.Thread(target=end.wait, name=name)
        thread.start()
        try:
            assert passes._may_fork() is allowed
        finally:
            end.set()
            thread.join()

    def test_a_process_that_dies_costs_time_and_nothing_else(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        name = write_array(tmp_path / "torus.stl", torus(330, 70))
        monkeypatch.setattr(forms, "SPAN", BLOCK)
        monkeypatch.setattr(passes, "_cores", lambda: 3)
        parent, added = os.getpid(), passes._added

        def deadly(*given: Any) -> Any:
            for part in added(*given):
                if os.getpid() != parent:
                    os._exit(9)
                yield part

        one = first_pass(open_mesh(name), shell=False, prove=True)[1]
        monkeypatch.setattr(passes, "_added", deadly)
        other = first_pass(open_mesh(name), shell=False, prove=True)[1]
        assert (other.measure, other.second.tolist()) == (one.measure, one.second.tolist())

    def test_the_second_pass_is_for_thin_and_for_small(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(reading, "SMALL", 10)
        wide = solid(stl(tmp_path, ball(3)))
        assert wide.numerics is not None
        assert "once more" not in wide.numerics.method
        thin = [tuple((x, 1e-3 * y, z) for x, y, z in t) for t in ball(3)]
        again = solid(stl(tmp_path, thin))
        assert again.numerics is not None
        assert "once more" in again.numerics.method

    @pytest.mark.parametrize("shell", [False, True])
    @pytest.mark.parametrize("move", [(0.0, 0.0, 0.0), (1e7, -3e3, 0.1)])
    def test_few_triangles_are_integrated_in_whole_numbers(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, shell: bool, move: tuple[float, ...]
    ) -> None:
        """On both sides of the switch the same, and closer within it."""
        few = [tuple(tuple(p + m for p, m in zip(q, move, strict=True)) for q in t) for t in ball(2)]
        assert len(few) == reading.FEW
        name = stl(tmp_path, few, binary=False)
        amount = OfArealDensity(2.0) if shell else OfDensity(2.0)
        whole = solid(name, amount=amount)
        reading._LAST.clear()
        monkeypatch.setattr(reading, "FEW", len(few) - 1)
        again = solid(name, amount=amount)
        for made, word in ((whole, "whole numbers"), (again, "once more")):
            assert made.numerics is not None
            assert word in made.numerics.method
        one, other = ({b.result: b.bound for b in made.numerics.bounds} for made in (whole, again))  # type: ignore[union-attr]
        for moment in ("first", "second", "third"):
            address = f"principal_moments.{moment}"
            assert one[address] < min(1e-15, other[address])
            own = getattr(whole.principal_moments, moment)
            assert getattr(again.principal_moments, moment) == pytest.approx(own, rel=one[address] + other[address])
        assert again.centroid == pytest.approx(whole.centroid, rel=1e-15, abs=1e-15)

    def test_an_uneven_scale_of_coordinates_takes_whole_numbers_of_any_length(self, tmp_path: Path) -> None:
        box = [tuple((1e50 * x, 1e-60 * y, 1e-3 * z) for x, y, z in t) for t in BOX]
        made = solid(stl(tmp_path, box, binary=False))
        assert made.volume == pytest.approx(6.0 * 1e-13, rel=1e-15)
        assert made.principal_moments.first == pytest.approx(
            6.0 * 1e-13 * (1e-60**2 * 4.0 + 1e-6 * 1.0) / 12.0, rel=1e-14
        )

    def test_both_passes_agree(self, tmp_path: Path) -> None:
        source = open_mesh(write_array(tmp_path / "torus.stl", torus(120, 60)))
        sums, moments = first_pass(source, shell=False, prove=False)
        again = second_pass(source, sums, moments, np.eye(3))
        assert again.measure == pytest.approx(moments.measure, rel=1e-15)
        assert np.allclose(again.second, moments.second, rtol=2e-15, atol=1e-14 * moments.second.max())
        assert np.allclose(again.centroid, moments.centroid, atol=1e-15)

    def test_memory_does_not_grow(self, tmp_path: Path) -> None:
        import tracemalloc

        peaks = []
        for around in (200, 1600):
            name = write_array(tmp_path / f"{around}.stl", torus(around, 100))
            solid(name)
            reading._LAST.clear()
            tracemalloc.start()
            solid(name)
            peaks.append(tracemalloc.get_traced_memory()[1])
            tracemalloc.stop()
            reading._LAST.clear()
        assert peaks[1] < 1.3 * peaks[0] + 4e6

    def test_vertices_and_faces_in_memory(self) -> None:
        corners = torus(12, 8).reshape(-1, 3)
        source = Corners("x", "OBJ", corners, np.arange(len(corners)).reshape(-1, 3))
        sums, moments = first_pass(source, shell=False, prove=True)
        assert sums.closed
        assert moments.measure > 0.0

    @pytest.mark.parametrize("few", [reading.FEW, 0])
    def test_a_volume_that_all_but_underflows_states_no_bound_that_is_none(
        self, few: int, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(reading, "FEW", few)
        points = np.array([
            (-980.8921229130134, 5e-324, -4348.781855060251), (-1057.3344982206313, 0.0, -4336.692743671449),
            (-1057.3148873253658, 0.0, 4336.692743671448), (-1057.314887325366, 0.0, -4336.6393438970945),
        ])  # fmt: skip
        source = Corners("", "", points, np.array([(0, 1, 2), (0, 2, 3), (0, 3, 1), (2, 1, 3)]))
        shell: Any = Lift(reading.Measured(source, shell=True), LengthUnit("m"), 0).measure()
        assert shell.value > 0.0
        assert shell.error <= 1e-14 * shell.value
        centroid: Any = Lift(reading.Measured(source, shell=False), LengthUnit("m"), 0).centroid()
        middle = points.mean(axis=0)
        for own, true in zip(centroid, middle, strict=True):
            assert abs(own.value - true) <= own.error
            assert own.error <= 1e-12 if few else own.error == np.inf


class TestInvariants:
    def test_moving_and_turning(self, tmp_path: Path) -> None:
        base = solid(stl(tmp_path, [tuple((x, 0.7 * y, 0.4 * z) for x, y, z in t) for t in ball(2)], binary=False))
        # a quarter turn about z and a move by whole numbers round nothing
        moved = [tuple((-0.7 * y + 64.0, x - 32.0, 0.4 * z + 16.0) for x, y, z in t) for t in ball(2)]
        made = solid(stl(tmp_path, moved, binary=False))
        for name in ("first", "second", "third"):
            assert getattr(made.principal_moments, name) == pytest.approx(
                getattr(base.principal_moments, name), rel=1e-14
            )
        assert made.moments.xx == pytest.approx(base.moments.yy, rel=1e-14)

    def test_principal_moments_are_never_negative(self, tmp_path: Path) -> None:
        generator = np.random.default_rng(3)
        for _ in range(20):
            thin = 10.0 ** -generator.uniform(0.0, 9.0, 3)
            turn, _ = np.linalg.qr(generator.normal(size=(3, 3)))
            made = [tuple(tuple(turn @ (thin * np.array(p))) for p in t) for t in ball(1)]
            if np.linalg.det(turn) < 0.0:
                made = [(a, c, b) for a, b, c in made]
            text = [tuple(tuple(float(x) for x in p) for p in t) for t in made]
            moments = solid(stl(tmp_path, text, binary=False)).principal_moments
            assert 0.0 < moments.first <= moments.second <= moments.third
            assert moments.third <= (moments.first + moments.second) * (1.0 + 1e-15)


class TestCommand:
    def test_a_document(self, tmp_path: Path) -> None:
        name = stl(tmp_path, BOX)
        document = answer("inertia", "mesh", name, "--length-unit", "mm", "--material", "steel")
        results = document["results"]
        assert results["volume"] == {"value": pytest.approx(6.0, rel=1e-15), "unit": "mm³"}
        assert results["surface"]["closed"] == "yes"
        assert document["files"][0]["sha256"]
        assert document["numerics"]["error_bound"]["volume"]

    def test_an_uncertain_density(self, tmp_path: Path) -> None:
        name = stl(tmp_path, BOX)
        outcome = run("inertia", "mesh", name, "--length-unit", "mm", "--density", "7850±50 kg/m^3", "--json")
        assert outcome.status == 0, outcome.err

    def test_what_is_missing_is_named(self, tmp_path: Path) -> None:
        name = stl(tmp_path, BOX)
        assert run("inertia", "mesh", name, "--density", "1 kg/m^3").status == 2
        assert run("inertia", "mesh", name, "--length-unit", "mm").status == 2
        assert run("inertia", "mesh", str(tmp_path / "no.stl"), "--length-unit", "mm", "--mass", "1 kg").status == 2
        assert run("inertia", "mesh", name, "--length-unit", "parsec", "--mass", "1 kg").status == 2
        assert run("inertia", "mesh", name, "--length-unit", "mm", "--density", "-1 kg/m^3").status == 2
        assert run("inertia", "mesh", name, "--length-unit", "mm", "--mass", "0 kg").status == 3


class TestPicture:
    def test_three_views_with_triangles(self, tmp_path: Path) -> None:
        name = stl(tmp_path, BOX)
        made = solid(name)
        picture = mesh_picture(made, name, length_unit=LengthUnit("m"))
        assert [panel.title for panel in picture.panels] == ["top view", "front view", "side view"]
        lines = picture.panels[0].items[0]
        finite = [x for x in lines.x if x == x]  # type: ignore[union-attr]
        assert (min(finite), max(finite), len(finite)) == (0.0, 3.0, 4 * len(BOX))

    def test_large_files_are_thinned(self, tmp_path: Path) -> None:
        name = write_array(tmp_path / "torus.stl", torus(300, 40))
        wire = outlines(name, 1e-3)
        assert DRAWN / 2 < len(wire) / 5 <= DRAWN


class TestLimits:
    def test_finer_balls_tend_to_the_ball_by_the_square_of_the_mesh(self, tmp_path: Path) -> None:
        volume, moment = 4.0 * math.pi / 3.0, 8.0 * math.pi / 15.0
        errors = []
        for level in (2, 3, 4):
            made = solid(stl(tmp_path, ball(level), binary=False))
            assert made.volume is not None
            errors.append((1.0 - made.volume / volume, 1.0 - made.moments.xx / moment))
        for coarse, fine in pairwise(errors):
            assert fine == pytest.approx((coarse[0] / 4.0, coarse[1] / 4.0), rel=0.1)

    def test_a_thin_solid_wall_tends_to_the_shell(self, tmp_path: Path) -> None:
        # all faces of a cube are as far from its centre, so a scaled copy leaves a wall of one thickness
        cube = prism([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)], 2.0)
        outer = [tuple(tuple(x - 1.0 for x in p) for p in t) for t in cube]
        shell = solid(stl(tmp_path, outer), amount=OfMass(1.0), thickness=1e-3)
        gaps = []
        for wall in (1e-2, 1e-3):
            inner = [tuple(tuple((1.0 - wall) * x for x in p) for p in (a, c, b)) for a, b, c in outer]
            made = solid(stl(tmp_path, [*outer, *inner], binary=False), amount=OfMass(1.0))
            gaps.append(1.0 - made.moments.zz / shell.moments.zz)
        # a wall inward of the triangles is half a thickness nearer, and moments go by the square
        assert gaps[0] == pytest.approx(1e-2, rel=0.05)
        assert gaps[1] == pytest.approx(1e-3, rel=0.05)
