"""Surfaces that are closed and yet bound no solid, or bound it twice; files that are nearly what they should be."""

import math
import sys
import zipfile
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest
from harness import answer, run
from references.inertia_solids import ball, prism, write_stl

from dynamics_cli.inertia.mesh import opening
from dynamics_cli.inertia.mesh.faults.crossing import Windings

CUBE = prism([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)], 2.0)


def moved(made: list[Any], by: tuple[float, float, float], scale: float | tuple[float, ...] = 1.0) -> list[Any]:
    scales = scale if isinstance(scale, tuple) else (scale,) * 3
    return [tuple(tuple(s * x + d for s, x, d in zip(scales, p, by, strict=True)) for p in t) for t in made]


def flipped(made: list[Any]) -> list[Any]:
    return [(a, c, b) for a, b, c in made]


def called(tmp_path: Path, made: list[Any], *more: str) -> dict[str, Any]:
    path = tmp_path / "part.stl"
    write_stl(path, made, binary=False)
    return answer("inertia", "mesh", str(path), "--length-unit", "m", "--density", "1 kg/m^3", *more)


def codes(document: dict[str, Any]) -> list[str]:
    return [warning["code"] for warning in document["warnings"]]


class TestOverlaps:
    @pytest.mark.parametrize(
        ("made", "wanted"),
        [
            pytest.param(CUBE + CUBE, {"duplicated"}, id="given twice"),
            pytest.param(CUBE + moved(CUBE, (0.5, 0.5, 0.5), 0.25), {"overlap"}, id="inner shell facing outwards"),
            pytest.param(CUBE + moved(CUBE, (1.5, 1.5, 1.5)), {"crossing", "overlap"}, id="corners overlap"),
            pytest.param(CUBE + moved(CUBE, (1.0, 0.0, 0.0)), {"overlap"}, id="overlap along common faces"),
            pytest.param(CUBE + moved(CUBE, (0.6, -2.0, 0.7), (0.4, 3.0, 0.4)), {"crossing"}, id="crossed bars"),
            pytest.param(
                CUBE + flipped(moved(CUBE, (1.6, 0.5, 0.5), 0.25)), {"crossing", "against"}, id="cavity leaves"
            ),
            pytest.param(ball(2) + moved(ball(1), (0.1, 0.0, 0.0), 0.4), {"overlap"}, id="a ball in a ball"),
        ],
    )
    def test_what_counts_twice_or_negative_is_warned_of(self, tmp_path: Path, made: Any, wanted: set[str]) -> None:
        document = called(tmp_path, made)
        assert wanted <= set(codes(document))
        assert {w["severity"] for w in document["warnings"]} == {"serious"}

    @pytest.mark.parametrize(
        "made",
        [
            pytest.param(CUBE + flipped(moved(CUBE, (0.5, 0.5, 0.5), 0.25)), id="cavity"),
            pytest.param(CUBE + moved(CUBE, (0.0, 0.0, 2.0)), id="stacked, the common face given both ways round"),
            pytest.param(CUBE + moved(CUBE, (1.0, 0.5, 2.0)), id="stacked aside"),
            pytest.param(CUBE + moved(CUBE, (2.0, 2.0, 0.0)), id="along one edge"),
            pytest.param(CUBE + moved(CUBE, (2.0, 2.0, 2.0)), id="at one corner"),
            pytest.param(CUBE + moved(CUBE, (5.0, 0.0, 0.0)), id="apart"),
            pytest.param(
                CUBE + flipped(moved(CUBE, (0.25, 0.25, 0.25), 0.75)) + moved(CUBE, (0.5, 0.5, 0.5), 0.25),
                id="a cube in a cavity",
            ),
            pytest.param(ball(2), id="ball"),
        ],
    )
    def test_what_bounds_a_solid_is_not(self, tmp_path: Path, made: Any) -> None:
        document = called(tmp_path, made)
        assert codes(document) == []
        faults = document["results"]["surface"]["faults"]
        assert [faults[name]["value"] for name in ("crossing", "within", "against", "repeated")] == [0] * 4

    def test_it_says_which_was_done(self, tmp_path: Path) -> None:
        """Slivers round an axis are all near one another; twice as many even triangles are not."""
        rim = [(math.cos(t), math.sin(t)) for t in np.linspace(0.0, 2.0 * np.pi, 801)[:-1].tolist()]
        silent = called(tmp_path, prism(rim, 1.0))
        assert "only closure" in silent["results"]["surface"]["examined"]
        assert "faults" not in silent["results"]["surface"]
        made = ball(4)
        looked = called(tmp_path, made + moved(made, (0.51, 0.07, 0.03)))
        assert "were checked" in looked["results"]["surface"]["examined"]
        assert looked["results"]["surface"]["faults"]["pairs"]["value"] > len(made)
        assert {"crossing", "overlap"} <= set(codes(looked))
        short = prism(rim[::8], 1.0)
        asked = called(tmp_path, short + moved(short, (0.3, 0.4, 0.2)), "--diagnose")
        assert {"crossing", "overlap"} <= set(codes(asked))

    @pytest.mark.parametrize("seed", range(12))
    def test_windings_are_solid_angles_over_a_sphere(self, seed: int) -> None:
        """Rays and signs against another formula: the angles under which triangles are seen add up to 4π."""
        random = np.random.default_rng(seed)
        made = CUBE + moved(ball(1), tuple(random.uniform(-0.5, 2.5, 3)), 0.7)
        if seed % 2:
            # places where rays meet edges and corners
            made = CUBE + moved(CUBE, tuple(random.integers(-3, 4, 3) / 2.0), 0.5)
        if seed % 3 == 0:
            turned, _ = np.linalg.qr(random.normal(size=(3, 3)))
            made = (np.array(made) @ turned).tolist()
        corners = np.array(made, dtype=float)
        at = np.concatenate((random.uniform(-1.0, 3.0, (40, 3)), random.integers(-2, 5, (40, 3)) / 2.0 + 0.25))
        nowhere, label = np.full(len(at), -1), np.arange(len(corners))
        a, b, c = (corners[None, :, k] - at[:, None] for k in range(3))
        x, y, z = (np.linalg.norm(part, axis=2) for part in (a, b, c))
        down = x * y * z + (a * b).sum(2) * z + (b * c).sum(2) * x + (c * a).sum(2) * y
        seen = (np.arctan2((a * np.cross(b, c)).sum(2), down)).sum(1) / (2.0 * np.pi)
        for axis in range(3):
            found = Windings(corners, at, np.full(len(at), axis), nowhere, label).numbers()
            touched = np.isnan(found)
            assert touched.mean() < 0.5
            assert found[~touched] == pytest.approx(seen[~touched], abs=1e-9)

    def test_pieces_that_share_edges_are_judged_as_one(self, tmp_path: Path) -> None:
        """Two stacked blocks that face inwards, outside the body: every triangle of theirs takes away."""
        block = flipped(moved(CUBE, (22.0, 22.0, 22.0)))
        document = called(tmp_path, moved(CUBE, (0.0, 0.0, 0.0), 10.0) + block + moved(block, (0.0, 0.0, 2.0)))
        assert document["results"]["surface"]["faults"]["against"]["value"] == 24


def words(made: list[Any]) -> bytes:
    """An ASCII STL file, a plain one."""
    lines = ["solid part"]
    for triangle in made:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex " + " ".join(map(repr, point)) for point in triangle]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid part", ""]).encode()


def asked(path: Path, *more: str) -> Any:
    return run("inertia", "mesh", str(path), "--density", "1 kg/m^3", "--json", *more)


class TestText:
    @pytest.mark.parametrize("name", ["part", "facet", "endfacet vertex 1 2", "outer loop", "solid endsolid"])
    @pytest.mark.parametrize("end", [b"\n", b"\r", b"\r\n"])
    @pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"])
    def test_marks_line_ends_and_names(self, tmp_path: Path, name: str, end: bytes, mark: bytes) -> None:
        path = tmp_path / "part.stl"
        path.write_bytes(mark + words(CUBE).replace(b"part", name.encode()).replace(b"\n", end))
        document = asked(path, "--length-unit", "m").document
        assert document["results"]["volume"]["value"] == pytest.approx(8e9, rel=1e-15)
        assert document["warnings"] == []

    def test_without_endsolid_it_answers_with_a_caution(self, tmp_path: Path) -> None:
        path = tmp_path / "part.stl"
        text = words(CUBE)
        path.write_bytes(text[: text.index(b"endsolid")])
        document = asked(path, "--length-unit", "m").document
        assert [(w["code"], w["severity"]) for w in document["warnings"]] == [("cut-off", "caution")]
        path.write_bytes(text[: text.index(b"endsolid") - 12])
        assert asked(path, "--length-unit", "m").error["code"] == "truncated"

    def test_each_vertex_has_three_numbers(self, tmp_path: Path) -> None:
        """Two and four add up to six, as three and three do."""
        path = tmp_path / "part.stl"
        path.write_bytes(words(CUBE).replace(b"vertex 0.0 0.0 0.0\nvertex 2.0", b"vertex 0.0 0.0\nvertex 0.0 2.0", 1))
        assert asked(path, "--length-unit", "m").error["code"] == "stl"


class TestSizes:
    def test_inside_out_has_an_option(self, tmp_path: Path) -> None:
        path = tmp_path / "part.stl"
        path.write_bytes(words(flipped(CUBE)))
        refused = asked(path, "--length-unit", "m").error
        assert (refused["code"], refused["hint"]) == ("inverted", "--flip turns all triangles round")
        document = asked(path, "--length-unit", "m", "--flip").document
        path.write_bytes(words(CUBE))
        assert document["results"]["tensor"] == asked(path, "--length-unit", "m").document["results"]["tensor"]
        assert asked(path, "--length-unit", "m", "--flip").error["code"] == "inverted"

    @pytest.mark.parametrize(("u", "v"), [(0.3, 0.4), (0.2, 0.5), (0.6, 0.7)])
    def test_a_flat_tetrahedron_has_no_volume(self, tmp_path: Path, u: float, v: float) -> None:
        """Its fourth corner is a + u (b − a) + v (c − a), rounded."""
        a, b, c = (0.1, 0.2, 0.3), (1.1, 0.3, 0.7), (0.4, 1.3, 0.2)
        d = tuple(x + u * (y - x) + v * (z - x) for x, y, z in zip(a, b, c, strict=True))
        path = tmp_path / "part.stl"
        path.write_bytes(words([(a, c, b), (a, b, d), (b, c, d), (c, a, d)]))
        outcome = run("inertia", "mesh", str(path), "--length-unit", "m", "--mass", "1 kg", "--json")
        assert (outcome.status, outcome.error["code"]) == (3, "no-volume")

    @pytest.mark.parametrize("scale", [1e-70, 1e-80])
    def test_second_moments_below_a_double_are_refused_and_not_zero(self, tmp_path: Path, scale: float) -> None:
        path = tmp_path / "part.stl"
        path.write_bytes(words(moved(CUBE, (0.0, 0.0, 0.0), scale)))
        assert asked(path, "--length-unit", "m").error["code"] == "range"


class TestOtherFormats:
    def packed(self, path: Path, text: bytes, **more: Any) -> Path:
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("3D/3dmodel.model", text, **more)
        return path

    def stand_in(self, monkeypatch: pytest.MonkeyPatch) -> None:
        """A reader of the test's own, which returns the cube and no unit."""
        corners = sorted({p for t in CUBE for p in t})
        faces = np.array([[corners.index(p) for p in t] for t in CUBE])
        module = ModuleType("trimesh")
        loaded = SimpleNamespace(vertices=np.array(corners), faces=faces)
        module.load = lambda *_, **__: loaded  # type: ignore[attr-defined]
        monkeypatch.setitem(sys.modules, "trimesh", module)

    @pytest.mark.parametrize(
        ("said", "metres"),
        [("inch", 0.0254), ("foot", 0.3048), ("micron", 1e-6), ("centimeter", 0.01), ("meter", 1.0), (None, 1e-3)],
    )
    def test_a_3mf_file_says_its_unit(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, said: str | None, metres: float
    ) -> None:
        self.stand_in(monkeypatch)
        unit = f' unit="{said}"' if said else ""
        path = self.packed(tmp_path / "part.3mf", f"<model{unit}><resources/></model>".encode())
        document = asked(path).document
        assert document["results"]["volume"]["value"] == pytest.approx(8e9 * metres**3, rel=1e-15)
        if said == "inch":
            assert asked(path, "--length-unit", "in").status == 0
            refused = asked(path, "--length-unit", "mm").error
            assert refused["code"] == "unit"
            assert "in in, and mm was given" in refused["message"]

    def test_a_bomb_is_refused_by_its_unpacked_size(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(opening, "MOST_UNPACKED", 1 << 20)
        path = self.packed(tmp_path / "part.3mf", b"<model>" + b" " * (opening.MOST_UNPACKED + 1))
        assert path.stat().st_size < 1e4
        refused = asked(path, "--length-unit", "mm").error
        assert refused["code"] == "too-large"
        assert str(opening.MOST_UNPACKED) in refused["message"]

    def test_what_is_no_archive_is_refused(self, tmp_path: Path) -> None:
        path = tmp_path / "part.3mf"
        path.write_bytes(b"PK\x03\x04 not an archive")
        assert asked(path, "--length-unit", "mm").error["code"] == "form"

    @pytest.mark.parametrize(
        ("line", "said"),
        [("v 1 2", "line 2: a vertex has 2 numbers"), ("f 0 1 2", "line 2: a face refers to vertex 0"),
         ("f 1/1 0/2 2/3", "vertex 0"), ("v 1 2 3 4 5", "5 numbers")],
    )  # fmt: skip
    def test_an_obj_file_that_would_be_read_as_another(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, line: str, said: str
    ) -> None:
        self.stand_in(monkeypatch)
        path = tmp_path / "part.obj"
        path.write_text(f"v 0 0 0\n{line}\n")
        refused = asked(path, "--length-unit", "mm").error
        assert refused["code"] == "form"
        assert said in refused["message"]

    @pytest.mark.parametrize("ending", ["dae", "amf", "step"])
    def test_only_what_is_read_is_offered(self, tmp_path: Path, ending: str) -> None:
        path = tmp_path / f"part.{ending}"
        path.write_text("x")
        refused = asked(path, "--length-unit", "mm").error
        assert refused["code"] == "form"
        assert f"ends in '.{ending}'" in refused["message"]
        assert "dae" not in refused["message"].partition("meshes end")[2]

    def test_the_unit_is_missing_where_the_file_says_none(self, tmp_path: Path) -> None:
        path = tmp_path / "part.stl"
        path.write_bytes(words(CUBE))
        outcome = asked(path)
        assert (outcome.status, outcome.error["parameter"]) == (2, "length_unit")
