"""The scene of a crash as a drawing: DXF on layers in true coordinates, SVG and PDF at a round scale."""

import math
import re
from pathlib import Path

import ezdxf
import pytest
from harness import answer
from shell import ROOT

SCENE = str(ROOT / "examples" / "crash_scene" / "crash.toml")
LAYERS = {"road", "marks", "vehicles", "paths", "vectors", "uncertainty", "text"}
FOOT = 0.3048


def drawn(folder: Path, form: str, *more: str) -> tuple[Path, dict]:
    file = folder / f"scene.{form}"
    return file, answer("impact", "crash", SCENE, "--method", "linear", "--drawing", str(file), *more)


@pytest.mark.parametrize(("system", "unit", "code"), [("si", 1.0, 6), ("us", FOOT, 2), ("base", 1.0, 6)])
def test_dxf_is_true_to_scale_on_layers(tmp_path: Path, system: str, unit: float, code: int) -> None:
    file, document = drawn(tmp_path, "dxf", "--units", system)
    assert document["files"][-1]["holds"].startswith("layers road, marks, vehicles, ")
    read = ezdxf.readfile(file)
    assert not read.audit().errors
    assert read.header["$INSUNITS"] == code
    space = read.modelspace()
    assert {entity.dxf.layer for entity in space} == LAYERS
    # the Ford's skid mark of 12.4 m, as wide as a tyre, and its outline of 4.6 m
    marks = [one for one in space.query('LWPOLYLINE[layer=="marks"]') if one.dxf.const_width]
    assert [math.dist(*[point[:2] for point in mark.get_points()]) * unit for mark in marks] == pytest.approx(
        [12.4] * 2
    )
    bodies = [one for one in space.query('LWPOLYLINE[layer=="vehicles"]') if one.closed and len(one) == 8]
    sizes = {round(max(math.dist(a[:2], b[:2]) for a in body for b in body) * unit, 2) for body in bodies}
    assert len(sizes) == 2
    assert math.hypot(4.6, 1.8) - 0.3 < max(sizes) < math.hypot(4.6, 1.8)
    words = {text.dxf.text for text in space.query("TEXT")}
    assert {"Ford at rest", "Opel at rest", "impact"} <= words
    assert any(("mph" if system == "us" else "km/h" if system == "si" else "m/s") in word for word in words)


def test_the_same_drawing_has_the_same_bytes(tmp_path: Path) -> None:
    first, _ = drawn(tmp_path, "dxf")
    data = first.read_bytes()
    assert drawn(tmp_path, "dxf")[0].read_bytes() == data


@pytest.mark.parametrize("form", ["svg", "pdf"])
def test_paper_is_at_a_round_scale(tmp_path: Path, form: str) -> None:
    file, document = drawn(tmp_path, form)
    said = re.fullmatch(r"scale 1:(\d+) on A4", document["files"][-1]["holds"])
    assert said
    assert int(said[1]) in (100, 150, 200, 250)
    assert file.read_bytes().startswith(b"%PDF" if form == "pdf" else b"<?xml")


def test_a_slide_is_drawn_where_it_was(tmp_path: Path) -> None:
    """Marks as wide as tyres in the coordinates of the scene, from the place of the separation to that of rest."""
    file = tmp_path / "slide.dxf"
    motion = "--speed 12m/s --course 30deg --spin 3rad/s --place 100,50m"
    car = "--front-axle 1.2m --rear-axle 1.4m --track 1.5m --radius-of-gyration 1.35m --friction 0.7 --braking 100%"
    document = answer("impact", "slide", *motion.split(), *car.split(), "--drawing", str(file))
    assert document["files"][-1]["holds"].startswith("layers marks, vehicles, paths, vectors, text")
    space = ezdxf.readfile(file).modelspace()
    marks = [one for one in space.query('LWPOLYLINE[layer=="marks"]') if one.dxf.const_width]
    assert len(marks) >= 4
    assert all(one.dxf.const_width == pytest.approx(0.2) for one in marks)
    # the left front wheel begins 1.2 m ahead of the place and 0.75 m to its left
    begins = [one.get_points()[0][:2] for one in marks]
    assert min(math.dist(one, (101.2, 50.75)) for one in begins) < 0.02
    path = next(one for one in space.query('LWPOLYLINE[layer=="paths"]')).get_points()
    rest = document["results"]["rest_position"]["value"]
    assert math.dist(path[-1][:2], rest) < 1e-6
