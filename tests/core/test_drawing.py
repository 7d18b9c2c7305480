"""Drawings to files: each format read back by small readers of our own, to the bit and within the deviation stated."""

import csv
import hashlib
import io
import json
import math
import os
import subprocess
import sys
import xml.etree.ElementTree as ET
from fractions import Fraction
from pathlib import Path

import ezdxf
import mpmath
import pytest
import toys
from harness import answer, run
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli import run as run_python
from dynamics_cli.core.answering.task import Model, Task
from dynamics_cli.core.command.schema import schema
from dynamics_cli.core.inputs.specification import SpecificationError
from dynamics_cli.core.output.drawing import write_drawing
from dynamics_cli.core.output.drawing.scaled import FILE_UNITS, box, quartered, round_bound, scaled
from dynamics_cli.errors import OutputError, UsageError
from dynamics_cli.outlines import Arc, Cubic, Drawing, Line, Outline, Points, arc_about, circle

pytestmark = pytest.mark.usefixtures("toy")

PLATE = ("toy", "plate", "--width", "0.3 m")
SHAPE = toys.plate(width=0.3).shape
MM, INCH = Fraction(1000), Fraction(10000, 254)


def to_unit(point: tuple[float, float], factor: Fraction) -> tuple[float, float]:
    """The nearest doubles, by exact rationals."""
    return tuple(float(Fraction(part) * factor) for part in point)


def drawn(folder: Path, form: str, *more: str) -> tuple[bytes, dict]:
    name = str(folder / f"a.{form}")
    document = answer(*PLATE, "--drawing", name, *more)
    return Path(name).read_bytes(), document


def dxf_entities(data: bytes) -> tuple[list[str], dict[str, str], list[dict]]:
    """Comments, header variables and entities, from nothing but group codes."""
    lines = data.decode("cp1252").splitlines()
    pairs = [(int(code), value) for code, value in zip(lines[::2], lines[1::2], strict=True)]
    comments = [value for code, value in pairs if code == 999]
    header = {pairs[i][1]: pairs[i + 1][1] for i, (code, _) in enumerate(pairs) if code == 9}
    start = pairs.index((2, "ENTITIES"))
    end = next(i for i in range(start, len(pairs)) if pairs[i] == (0, "ENDSEC"))
    entities: list[dict] = []
    for code, value in pairs[start + 1 : end]:
        if code == 0:
            entities.append({"type": value, "points": [], "knots": [], "bulges": {}})
        elif code == 10:
            entities[-1]["points"].append([float(value)])
        elif code == 20:
            entities[-1]["points"][-1].append(float(value))
        elif code == 42:
            entities[-1]["bulges"][len(entities[-1]["points"]) - 1] = float(value)
        elif code == 40:
            entities[-1]["knots"].append(float(value))
        elif code == 8:
            entities[-1]["layer"] = value
        elif code == 70:
            entities[-1]["flags"] = int(value)
        elif code == 1041:
            entities[-1]["deviation"] = float(value)
    return comments, header, entities


def svg_paths(data: bytes) -> tuple[ET.Element, list[list[tuple[str, list[float]]]]]:
    root = ET.fromstring(data.decode())
    paths = []
    for path in root.iter("{http://www.w3.org/2000/svg}path"):
        words: list[tuple[str, list[float]]] = []
        for word in path.get("d").replace(",", " ").split():
            if word.isalpha():
                words.append((word, []))
            else:
                words[-1][1].append(float(word))
        paths.append(words)
    return root, paths


class TestDxf:
    def test_by_group_codes(self, tmp_path: Path) -> None:
        data, document = drawn(tmp_path, "dxf")
        comments, header, entities = dxf_entities(data)
        assert header["$INSUNITS"] == "4"
        assert header["$ACADVER"] == "AC1015"
        assert "unit: mm" in comments
        assert [entity["type"] for entity in entities] == ["LWPOLYLINE", "SPLINE", "LWPOLYLINE"] + ["LWPOLYLINE"] * 2
        first, spline, last, bore, score = entities
        edge = SHAPE.outlines[0].pieces
        assert first["points"] == [list(to_unit(p, MM)) for p in (edge[0].start, edge[1].start, edge[1].end)]
        assert first["bulges"] == {1: 1.0}
        cubic = edge[2]
        controls = (cubic.start, cubic.control1, cubic.control2, cubic.end)
        assert spline["points"] == [list(to_unit(p, MM)) for p in controls]
        assert spline["knots"] == [0.0] * 4 + [1.0] * 4
        # pieces meet to the bit, and the outline closes to the bit
        assert first["points"][-1] == spline["points"][0]
        assert spline["points"][-1] == last["points"][0]
        assert last["points"][-1] == first["points"][0]
        assert (bore["flags"], bore["bulges"]) == (1, {0: -1.0, 1: -1.0})
        assert (score["flags"], len(score["points"])) == (0, 20)
        assert [entity["layer"] for entity in entities] == ["edge"] * 3 + ["bore ø", "outline 3"]
        deviations = [entity["deviation"] for entity in entities]
        assert deviations[0] == deviations[2] == 1.251e-6
        assert max(deviations) == document["files"][0]["deviation"]["value"]
        assert any(f"edge: closed, at most {deviations[0]!r} mm" in comment for comment in comments)

    def test_by_ezdxf_without_a_complaint(self, tmp_path: Path) -> None:
        drawn(tmp_path, "dxf")
        document = ezdxf.readfile(tmp_path / "a.dxf")
        assert document.audit().errors == []
        spline = document.modelspace().query("SPLINE").first
        cubic = SHAPE.outlines[0].pieces[2]
        assert tuple(spline.control_points[3])[:2] == to_unit(cubic.end, MM)
        middle = spline.construction_tool().point(0.5)
        exact = [
            (a + 3 * b + 3 * c + d) / 8
            for a, b, c, d in zip(cubic.start, cubic.control1, cubic.control2, cubic.end, strict=True)
        ]
        assert middle.x == pytest.approx(1000 * exact[0])
        assert middle.y == pytest.approx(1000 * exact[1])
        bore = document.modelspace().query("LWPOLYLINE")[2]
        assert bore.closed
        assert bore.get_xdata("DYNAMICS")[1].value < 1e-12
        assert document.header["$EXTMIN"][0] <= 0.0

    def test_cubics_alone_are_one_closed_spline(self, tmp_path: Path) -> None:
        a, b, c = (0.0, 0.0), (0.02, 0.0), (0.0, 0.02)
        ring = (
            Cubic(a, (0.005, -0.01), (0.015, -0.01), b),
            Cubic(b, (0.025, 0.01), (0.01, 0.03), c),
            Cubic(c, (-0.01, 0.01), (-0.005, 0.01), a),
        )
        file = tmp_path / "ring.dxf"
        write_drawing(Drawing((Outline(ring, True, 0.0, "ring"),)), str(file))
        document = ezdxf.readfile(file)
        (spline,) = document.modelspace()
        assert spline.closed
        assert not document.audit().errors
        found = list(spline.construction_tool().bezier_decomposition())
        for piece, points in zip(ring, found, strict=True):
            for wanted, point in zip((piece.start, piece.control1, piece.control2, piece.end), points, strict=True):
                assert tuple(point)[:2] == pytest.approx([1e3 * x for x in wanted], abs=1e-12)

    def test_inches(self, tmp_path: Path) -> None:
        data, document = drawn(tmp_path, "dxf", "--units", "us")
        comments, header, entities = dxf_entities(data)
        assert (header["$INSUNITS"], header["$MEASUREMENT"]) == ("1", "0")
        assert "unit: in" in comments
        assert entities[0]["points"][1] == list(to_unit((0.3, 0.0), INCH))
        assert document["files"][0]["deviation"]["unit"] == "in"

    def test_without_ezdxf_it_says_how_to_get_it(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setitem(sys.modules, "ezdxf", None)
        outcome = run(*PLATE, "--drawing", str(tmp_path / "a.dxf"), "--json")
        assert outcome.status == 2
        assert "pip install 'dynamics-cli[drawing]'" in outcome.error["hint"]
        assert os.listdir(tmp_path) == []
        assert run(*PLATE, "--drawing", str(tmp_path / "a.svg")).status == 0

    def test_a_name_that_no_layer_may_have(self, tmp_path: Path) -> None:
        outline = Outline((Line((0.0, 0.0), (1.0, 0.0)),), False, 0.0, "tip/root: 1")
        write_drawing(Drawing((outline,)), str(tmp_path / "a.dxf"))
        assert ezdxf.readfile(tmp_path / "a.dxf").modelspace()[0].dxf.layer == "tip_root_ 1"


class TestSvg:
    def test_end_points_units_and_deviation(self, tmp_path: Path) -> None:
        data, document = drawn(tmp_path, "svg")
        root, paths = svg_paths(data)
        width, height = (float(root.get(name).removesuffix("mm")) for name in ("width", "height"))
        view = [float(word) for word in root.get("viewBox").split()]
        assert view[2:] == [width, height]
        text = root.findtext("{http://www.w3.org/2000/svg}desc")
        assert "unit: mm" in text
        assert f"at most {document['files'][0]['deviation']['value']!r} mm from the exact curve" in text
        edge, bore, score = paths
        x, y = to_unit(SHAPE.outlines[0].pieces[2].start, MM)
        assert [word for word, _ in edge] == ["M", "L", "A", "A", "C", "L", "L", "Z"]
        assert edge[3][1][-2:] == [x, -y]
        assert edge[0][1] == edge[-2][1] == [0.0, 0.0]
        assert [word for word, _ in bore] == ["M", "A", "A", "A", "A", "Z"]
        assert [word for word, _ in score] == ["M", "L"]
        assert len(score[1][1]) == 2 * 19

    @pytest.mark.parametrize(("units", "page", "times"), [("us", "in", 1.0), ("base", "mm", 1000.0)])
    def test_the_page_has_the_true_size(self, tmp_path: Path, units: str, page: str, times: float) -> None:
        root, _ = svg_paths(drawn(tmp_path, "svg", "--units", units)[0])
        assert root.get("width").endswith(page)
        wide = float(root.get("width").removesuffix(page))
        assert wide == pytest.approx(times * float(root.get("viewBox").split()[2]))

    def test_names_are_escaped(self, tmp_path: Path) -> None:
        outline = Outline((Line((0.0, 0.0), (1.0, 0.0)),), False, 0.0, 'a < b & "c"')
        write_drawing(Drawing((outline,), "<t>"), str(tmp_path / "a.svg"))
        root, _ = svg_paths((tmp_path / "a.svg").read_bytes())
        assert root.findtext(".//{http://www.w3.org/2000/svg}path/{http://www.w3.org/2000/svg}title") == 'a < b & "c"'


class TestCsv:
    def test_every_piece_in_full(self, tmp_path: Path) -> None:
        data, _ = drawn(tmp_path, "csv")
        rows = list(csv.DictReader(io.StringIO(data.decode())))
        assert [row["kind"] for row in rows[:6]] == ["line", "arc", "cubic", "line", "line", "line"]
        for before, after in zip(rows[:6], rows[1:6] + rows[:1], strict=True):
            assert (before["end_x[mm]"], before["end_y[mm]"]) == (after["start_x[mm]"], after["start_y[mm]"])
        arc = rows[1]
        assert (float(arc["end_x[mm]"]), float(arc["end_y[mm]"])) == to_unit((0.3, 0.02), MM)
        assert [float(arc[name]) for name in ("bulge", "centre_x[mm]", "centre_y[mm]", "radius[mm]")] == [
            1,
            300,
            10,
            10,
        ]
        assert {row["deviation[mm]"] for row in rows if row["outline"] == "edge"} == {"1.251e-06"}
        assert len(rows) == 6 + 2 + 19
        assert rows[-1]["closed"] == "false"


@pytest.mark.parametrize("form", ["dxf", "svg", "csv"])
class TestFiles:
    def test_the_document_lists_the_file_with_its_hash(self, tmp_path: Path, form: str) -> None:
        data, document = drawn(tmp_path, form)
        entry = document["files"][0]
        assert entry["name"] == str(tmp_path / f"a.{form}")
        assert entry["written"] is True
        assert entry["sha256"] == hashlib.sha256(data).hexdigest()

    def test_same_input_same_bytes_in_another_process_too(self, tmp_path: Path, form: str) -> None:
        data, _ = drawn(tmp_path, form)
        code = (
            "from dynamics_cli.core.output.drawing import write_drawing; import toys;"
            f"write_drawing(toys.plate(width=0.3).shape, {str(tmp_path / 'b')!r} + '.{form}')"
        )
        path = os.pathsep.join([str(Path(toys.__file__).parent), str(Path(toys.__file__).parents[2])])
        subprocess.run(
            [sys.executable, "-c", code], check=True, env={**os.environ, "PYTHONPATH": path, "TZ": "Asia/Tokyo"}
        )
        assert (tmp_path / f"b.{form}").read_bytes() == data

    def test_both_routes_are_byte_identical(self, tmp_path: Path, form: str) -> None:
        name = str(tmp_path / f"a.{form}")
        plainly = run(*PLATE, "--drawing", name, "--json")
        data = Path(name).read_bytes()
        os.unlink(name)
        assert plainly == run(*PLATE, "--drawing", name, "--json", route="tree")
        assert Path(name).read_bytes() == data

    def test_where_it_cannot_be_written_nothing_is_left(self, tmp_path: Path, form: str) -> None:
        outcome = run(*PLATE, "--drawing", str(tmp_path / "no" / f"a.{form}"), "--json")
        assert (outcome.status, outcome.out) == (5, "")
        assert outcome.error["parameter"] == "drawing"
        assert os.listdir(tmp_path) == []

    def test_where_the_document_cannot_be_written_the_drawing_is_as_before(self, tmp_path: Path, form: str) -> None:
        name = tmp_path / f"a.{form}"
        argv = (*PLATE, "--drawing", str(name), "--output", str(tmp_path / "no" / "d.json"))
        assert run(*argv).status == 5
        assert os.listdir(tmp_path) == []
        name.write_bytes(b"before")
        assert run(*argv).status == 5
        assert name.read_bytes() == b"before"
        assert os.listdir(tmp_path) == [name.name]

    def test_from_python(self, tmp_path: Path, form: str) -> None:
        name = tmp_path / f"a.{form}"
        document = run_python("toy plate", width="0.3 m", drawing=str(name))
        assert document["files"][0]["sha256"] == hashlib.sha256(name.read_bytes()).hexdigest()


class TestCalls:
    def test_a_closed_pipe_leaves_the_drawing(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        from dynamics_cli import cli
        from dynamics_cli.core.terminal import Terminal

        class Closed(io.BytesIO):
            def write(self, data: bytes) -> int:
                raise BrokenPipeError

        monkeypatch.setattr(cli, "_close_quietly", lambda: None)
        terminal = Terminal(io.BytesIO(), Closed(), io.BytesIO(), {})
        assert cli.run_argv([*PLATE, "--drawing", str(tmp_path / "a.svg")], terminal) == 0
        assert os.listdir(tmp_path) == ["a.svg"]

    @pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no /dev/full here")
    def test_a_full_standard_output_takes_the_drawing_back(self, tmp_path: Path) -> None:
        from dynamics_cli import cli
        from dynamics_cli.core.terminal import Terminal

        with open("/dev/full", "wb", buffering=0) as raw:
            terminal = Terminal(io.BytesIO(), io.BufferedWriter(raw), io.BytesIO(), {})
            assert cli.run_argv([*PLATE, "--drawing", str(tmp_path / "a.svg")], terminal) == 5
            assert os.listdir(tmp_path) == []
            with pytest.raises(OSError, match="space"):
                terminal.stdout.close()

    def test_another_ending_is_refused_naming_the_three(self, tmp_path: Path) -> None:
        for name in ("a.png", "a", "-"):
            outcome = run(*PLATE, "--drawing", str(tmp_path / name), "--json")
            assert outcome.status == 2
            assert ".dxf, .svg or .csv" in outcome.error["message"]

    def test_a_task_without_a_drawing_refuses(self) -> None:
        for route in ("", "tree"):
            outcome = run("toy", "fall", "--height", "1 m", "--drawing", "a.svg", "--json", route=route)
            assert (outcome.status, outcome.error["code"]) == (2, "no-drawing")
            assert outcome.error["message"] == "toy fall has no drawing"

    def test_a_case_without_one_says_why(self, tmp_path: Path) -> None:
        assert answer(*PLATE, "--thin")["results"]["shape"] is None
        outcome = run(*PLATE, "--thin", "--drawing", str(tmp_path / "a.svg"), "--json")
        assert (outcome.status, outcome.error["hint"]) == (3, "it is too thin to cut")
        assert os.listdir(tmp_path) == []

    def test_for_one_case_only_and_to_a_file_of_its_own(self, tmp_path: Path) -> None:
        name = str(tmp_path / "a.csv")
        for more in (("--sweep", "radius=1 mm:2 mm:3"), ("--rows", "-"), ("--output", name)):
            outcome = run(*PLATE, "--drawing", name, *more, "--json")
            assert (outcome.status, outcome.error["code"]) == (2, "exclusive")

    def test_rows_and_sweeps_of_such_a_task(self) -> None:
        rows = run("toy", "plate", "--rows", "-", stdin="width[mm]\n300\n400\n")
        assert rows.status == 0
        assert rows.out == "width[mm],results.width[mm],error\n300,300.0,\n400,400.0,\n"
        assert run("toy", "plate", "--sweep", "width=100 mm:300 mm:3").status == 0

    def test_the_summary_keeps_its_schema_and_units(self) -> None:
        jsonschema = pytest.importorskip("jsonschema")
        document = answer(*PLATE, "--units", "base", "--to", "shape.deviation=um")
        shape = document["results"]["shape"]
        assert (shape["outlines"]["value"], shape["pieces"]["value"]) == (3, 8)
        assert shape["deviation"]["unit"] == "um"
        assert shape["deviation"]["value"] == pytest.approx(0.2, rel=1e-3)
        made = schema(toys.FAMILIES["toy"].tasks["plate"])
        jsonschema.validate({"inputs": document["inputs"], "results": document["results"]}, made)

    def test_every_format_of_the_document(self, tmp_path: Path) -> None:
        for form in ("table", "csv", "markdown", "ndjson"):
            outcome = run(*PLATE, "--format", form, "--drawing", str(tmp_path / "a.svg"))
            assert (outcome.status, outcome.err) == (0, "")
            assert "deviation" in outcome.out

    def test_a_link_stays_a_link(self, tmp_path: Path) -> None:
        (tmp_path / "a.csv").symlink_to(tmp_path / "b.csv")
        argv = (*PLATE, "--drawing", str(tmp_path / "a.csv"))
        assert run(*argv, "--output", str(tmp_path / "no" / "d.json")).status == 5
        assert os.listdir(tmp_path) == ["a.csv"]
        assert run(*argv).status == 0
        assert (tmp_path / "a.csv").is_symlink()
        assert (tmp_path / "b.csv").read_bytes() == (tmp_path / "a.csv").read_bytes()

    def test_files_read_come_before_files_written(self, tmp_path: Path) -> None:
        scene = tmp_path / "scene.json"
        scene.write_text('{"width": "300 mm"}')
        document = answer("toy", "plate", "--input", str(scene), "--drawing", str(tmp_path / "a.csv"))
        assert [entry.get("written", False) for entry in document["files"]] == [False, True]


class TestOwnWriters:
    def test_a_family_writes_its_own_from_plain_numbers(self, tmp_path: Path) -> None:
        name = tmp_path / "a.words"
        document = answer("toy", "disc", "--radius", "3 mm", "--drawing", str(name))
        assert name.read_text() == "disc of 0.003 m\n"
        assert document["files"][0]["sha256"] == hashlib.sha256(name.read_bytes()).hexdigest()
        assert answer("toy", "disc", "--radius", "3 mm", "--drawing", str(tmp_path / "a.svg"))["files"]

    def test_unknown_endings_name_them_too(self) -> None:
        message = run("toy", "disc", "--radius", "3 mm", "--drawing", "a.png", "--json").error["message"]
        assert message == "read 'a.png', wanted a file that ends in .dxf, .svg, .csv or .words"

    def test_a_drawing_is_no_parameter(self) -> None:
        def bent(*, shape: Drawing) -> toys.One:
            return toys.One(shape.deviation)

        toys.bent = bent
        with pytest.raises(SpecificationError, match="not a parameter"):
            _ = Task("bent", "", Model("m", "toys:bent", source="")).specification

    def test_the_three_are_taken(self) -> None:
        task = Task("disc", "", Model("m", "toys:disc", source=""), writers={"svg": "toys:as_words"})
        with pytest.raises(SpecificationError, match="dxf, svg and csv"):
            _ = task.specification


class TestOutlines:
    A, B, C = (0.0, 0.0), (1.0, 0.0), (1.0, 1.0)

    def test_pieces_must_meet_to_the_bit(self) -> None:
        near = (math.nextafter(1.0, 2.0), 0.0)
        with pytest.raises(ValueError, match="piece 1 of rim starts at"):
            Outline((Line(self.A, self.B), Line(near, self.C)), False, 0.0, "rim")
        with pytest.raises(ValueError, match="is closed"):
            Outline((Line(self.A, self.B), Line(self.B, self.C)), True, 0.0)

    def test_minus_zero_is_zero(self) -> None:
        line = Line((-0.0, 0.0), (1.0, -0.0))
        assert math.copysign(1.0, line.start[0]) == math.copysign(1.0, line.end[1]) == 1.0

    def test_what_cannot_be_is_refused(self) -> None:
        line = Line(self.A, self.B)
        for pieces, deviation, name in (((), 0.0, ""), ((line,), -1.0, ""), ((line,), 0.0, "two\nlines")):
            with pytest.raises(ValueError):  # noqa: PT011
                Outline(pieces, False, deviation, name)
        with pytest.raises(ValueError, match="two points"):
            Points((self.A,))
        with pytest.raises(ValueError, match="one outline"):
            Drawing(())
        with pytest.raises(OverflowError):
            Line(self.A, (math.nan, 0.0))
        with pytest.raises(OverflowError):
            Outline((line,), False, math.inf)

    def test_a_number_of_numpy_becomes_a_plain_one(self) -> None:
        import numpy as np

        assert type(Line(np.array([0.0, 1.0]), self.B).start[1]) is float

    def test_records_stay_frozen(self) -> None:
        with pytest.raises(AttributeError):
            Line(self.A, self.B).start = self.C

    def test_a_single_point_is_no_drawing(self, tmp_path: Path) -> None:
        outline = Outline((Line(self.A, self.A),), False, 0.0)
        with pytest.raises(Exception, match="single point"):
            write_drawing(Drawing((outline,)), str(tmp_path / "a.svg"))

    def test_pieces_that_vanish_in_the_file_are_left_out(self) -> None:
        points = Points((self.A, self.A, self.B, self.B, self.C))
        outline = Outline((Line(self.A, self.A), points, Cubic(*[self.C] * 4)), False, 0.0)
        (made,) = scaled(Drawing((outline,)), FILE_UNITS["si"]).outlines
        assert made.pieces == (Points(((0.0, 0.0), (1000.0, 0.0), (1000.0, 1000.0))),)

    def test_a_write_that_fails_and_an_ending_unknown(self, tmp_path: Path) -> None:
        with pytest.raises(UsageError, match=r"\.dxf, \.svg or \.csv"):
            write_drawing(SHAPE, str(tmp_path / "a.pdf"))
        with pytest.raises(OutputError):
            write_drawing(SHAPE, str(tmp_path / "no" / "a.svg"))

    @pytest.mark.parametrize("clockwise", [False, True])
    @pytest.mark.parametrize("degrees", [1e-7, 1.0, 90.0, 180.0, 270.0, 359.0])
    def test_an_arc_about_its_centre(self, degrees: float, clockwise: bool) -> None:
        turn = math.radians(-degrees if clockwise else degrees)
        end = (2.0 + 3.0 * math.cos(turn), 1.0 + 3.0 * math.sin(turn))
        arc = arc_about((5.0, 1.0), end, (2.0, 1.0), clockwise=clockwise)
        assert (arc.start, arc.end) == ((5.0, 1.0), end)
        assert arc.bulge == pytest.approx(math.tan(turn / 4.0), rel=1e-7)
        assert arc.radius == pytest.approx(3.0, rel=1e-7)
        if degrees > 1e-3:
            assert arc.centre == pytest.approx((2.0, 1.0), abs=1e-12)

    def test_an_arc_that_cannot_be(self) -> None:
        for end in (self.B, (0.0, 1.1)):
            with pytest.raises(ValueError, match="no arc about"):
                arc_about(self.B, end, self.A, clockwise=False)


def circle_of(start: tuple, end: tuple, bulge: object) -> tuple:
    """Centre and radius of an arc, in many digits."""
    (x0, y0), (x1, y1) = [[mpmath.mpf(part) for part in point] for point in (start, end)]
    away = (1 / mpmath.mpf(bulge) - mpmath.mpf(bulge)) / 4
    centre = ((x0 + x1) / 2 - away * (y1 - y0), (y0 + y1) / 2 + away * (x1 - x0))
    return centre, mpmath.hypot(x1 - x0, y1 - y0) * (1 / abs(mpmath.mpf(bulge)) + abs(mpmath.mpf(bulge))) / 4


def points_of(start: tuple, end: tuple, bulge: object) -> list:
    """Points of an arc, in many digits."""
    centre, _ = circle_of(start, end, bulge)
    z0 = mpmath.mpc(*start) - mpmath.mpc(*centre)
    sweep = 4 * mpmath.atan(mpmath.mpf(bulge))
    return [mpmath.mpc(*centre) + z0 * mpmath.expj(sweep * k / 12) for k in range(13)]


COORDINATES = st.tuples(*[st.floats(-3.0, 3.0, allow_subnormal=False)] * 2)


@settings(max_examples=150, deadline=None)
@given(COORDINATES, COORDINATES, st.floats(1e-9, 50.0), st.booleans(), st.sampled_from(["si", "us"]))
def test_files_are_within_the_deviation_they_state(
    start: tuple, end: tuple, bulge: float, clockwise: bool, units: str
) -> None:
    """The arc as DXF and SVG mean it, against the exact arc, in 50 digits."""
    if math.dist(start, end) < 1e-12:
        return
    arc = Arc(start, end, -bulge if clockwise else bulge)
    unit = FILE_UNITS[units]
    inside = scaled(Drawing((Outline((arc,), False, 0.0),)), unit)
    with mpmath.workdps(50):
        factor = mpmath.mpf(1000) if units == "si" else mpmath.mpf(10000) / 254
        centre, radius = circle_of(
            *[[mpmath.mpf(p) * factor for p in point] for point in (arc.start, arc.end)], arc.bulge
        )
        (one,) = inside.outlines[0].pieces
        for point in points_of(one.start, one.end, one.bulge):
            assert abs(abs(point - mpmath.mpc(*centre)) - radius) <= inside.deviation
        parts = quartered(inside)
        left, right, low, high = box(inside)
        for part in parts.outlines[0].pieces:
            if isinstance(part, Line):
                continue
            # as SVG reads it: ends and radius, the smaller arc
            half = mpmath.hypot(*(mpmath.mpf(b) - mpmath.mpf(a) for a, b in zip(part.start, part.end, strict=True))) / 2
            if not half:
                continue
            r = max(mpmath.mpf(part.radius), half)
            meant = mpmath.tan(mpmath.asin(half / r) / 2) * (1 if part.bulge > 0 else -1)
            for point in points_of(part.start, part.end, meant):
                assert abs(abs(point - mpmath.mpc(*centre)) - radius) <= parts.deviation
                assert left - parts.deviation <= point.real <= right + parts.deviation
                assert low - parts.deviation <= point.imag <= high + parts.deviation
    assert parts.deviation < 1e-9 * (1.0 + bulge) ** 2


@given(st.floats(1e-300, 1e300))
def test_a_bound_is_never_rounded_below_itself(bound: float) -> None:
    assert bound <= round_bound(bound) <= 1.0021 * bound


def test_a_circle_is_two_halves() -> None:
    first, second = circle((1.0, 2.0), 0.5)
    assert (first.start, first.end, first.bulge) == ((1.5, 2.0), (0.5, 2.0), 1.0)
    assert second.end == first.start
    assert json.dumps(first.centre) == "[1.0, 2.0]"
