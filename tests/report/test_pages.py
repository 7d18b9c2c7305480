"""A crash from the road backwards: one value for one thing, pages that are enough, a page everybody can read."""

import json
import re
import sys
import zlib
from html.parser import HTMLParser
from pathlib import Path

import pytest
from harness import run
from shell import ROOT

from dynamics_cli import cli
from dynamics_cli.core.answering.explain import filled
from dynamics_cli.core.output.answer import to_answer
from dynamics_cli.impact.commands import FAMILIES
from dynamics_cli.report import formula, typst
from dynamics_cli.report.blocks import Image

CRASH = ROOT / "examples" / "crash"


@pytest.fixture(scope="module")
def crash(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    folder = tmp_path_factory.mktemp("crash")
    names = [str(folder / f"{name}.json") for name in ("1_first_after", "2_second_after", "3_impact", "4_before")]

    def written(name: str, *argv: str) -> None:
        outcome = run(*argv, "--json", "--output", name)
        assert outcome.status == 0, outcome.err

    written(names[0], "skid", "speed", "--input", str(CRASH / "first_after.toml"))
    written(names[1], "skid", "speed", "--input", str(CRASH / "second_after.toml"))
    written(
        names[2], "impact", "momentum", "--axes", "compass",
        "--first-mass", "1500 ± 30 kg", "--first-approach-heading", "90 deg",
        "--first-exit-speed", f"@{names[0]}:speed", "--first-exit-heading", "48 ± 2 deg",
        "--second-mass", "1150 ± 30 kg", "--second-approach-heading", "0 deg",
        "--second-exit-speed", f"@{names[1]}:speed", "--second-exit-heading", "53 ± 2 deg",
    )  # fmt: skip
    written(
        names[3], "skid", "speed", "--distance", "12.4 ± 0.3 m", "--friction", "0.72 ± 0.04",
        "--end-speed", f"@{names[2]}:first.approach_speed", "--limit", "70 km/h",
    )  # fmt: skip
    return names


@pytest.fixture(scope="module")
def page(crash: list[str], tmp_path_factory: pytest.TempPathFactory) -> str:
    file = tmp_path_factory.mktemp("page") / "report.html"
    outcome = run("report", *crash, "--title", "Two-car crash", "--output", str(file))
    assert outcome.status == 0, outcome.err
    return file.read_text()


def test_what_one_section_found_is_what_the_next_takes(crash: list[str]) -> None:
    text = run("report", *crash).out
    found = dict(re.findall(r"(First after|Second after|Before): the speed was \*\*([\d.]+ km/h)\*\*", text))
    impact = re.search(r"speed before the impact was \*\*([\d.]+ km/h)\*\*", text)
    assert impact is not None
    section = text.partition("## 3. ")[2].partition("## 4. ")[0]
    first, second = found["First after"], found["Second after"]
    assert f"| exit speed | {first} (95 %: 38.2 to 43.5), from section 1 | {second} (" in section
    assert f"1500 kg·{first}·sin(0° − 48°)" in section
    last = text.partition("## 4. ")[2].partition("## Appendix")[0]
    assert f"end speed {impact[1]} (95 %: 50.3 to 59.3), from section 3" in last
    assert f"√(({impact[1]})² + 2·9.80665 m/s²·0.72·12.4 m) = {found['Before']}" in last


def test_a_value_outside_its_interval_is_explained(tmp_path: Path) -> None:
    name = str(tmp_path / "a.json")
    argv = ("--first-mass", "1500 kg", "--first-approach-heading", "0 ± 4 deg", "--first-exit-speed", "8 m/s",
            "--first-exit-heading", "40 deg", "--second-mass", "1200 kg", "--second-approach-heading", "90 ± 4 deg",
            "--second-exit-speed", "9 m/s", "--second-exit-heading", "37 deg",
            "--limit", "angle-condition=2")  # fmt: skip
    assert run("impact", "momentum", *argv, "--json", "--output", name).status == 0
    text = run("report", name).out
    assert "Angle condition: the value is the one at the nominal inputs and lies below the interval" in text


def test_the_pdf_of_a_crash_has_six_pages_at_most(crash: list[str], tmp_path: Path) -> None:
    pytest.importorskip("typst")
    pytest.importorskip("matplotlib")
    for paper in ("a4", "letter"):
        file = tmp_path / f"{paper}.pdf"
        outcome = run("report", *crash, "--title", "Two-car crash", "--paper", paper, "--output", str(file))
        assert outcome.status == 0, outcome.err
        data = file.read_bytes()
        assert data.startswith(b"%PDF")
        pages = len(re.findall(rb"/Type\s*/Page\b", data))
        assert 3 <= pages <= 6, paper


@pytest.mark.parametrize("paper", ["a4", "letter"])
def test_a_picture_taller_than_a_page_is_drawn_smaller(paper: str) -> None:
    pytest.importorskip("typst")
    svg = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 300"><path d="M 0 0 H 99 V 99 z"/></svg>'
    data = typst.pdf([Image(svg, "A tower", "a tower", 0.85)], "", "", paper)
    streams = re.findall(rb"stream\r?\n(x.*?)endstream", data, re.DOTALL)
    drawn = b"".join(zlib.decompressobj().decompress(stream) for stream in streams)
    placed = re.search(rb"q ([\d.]+) 0 0 -\1 [\d.]+ ([\d.]+) cm/", drawn)
    assert placed is not None
    scale, top = float(placed[1]), float(placed[2])
    assert top - 300.0 * scale > 15.0 / 25.4 * 72.0


def test_without_typst_it_is_said_what_to_install(
    crash: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "typst", None)
    outcome = run("report", crash[0], "--output", str(tmp_path / "a.pdf"))
    assert outcome.status == 2
    assert "dynamics-cli[report]" in outcome.err
    assert not (tmp_path / "a.pdf").exists()


class Structure(HTMLParser):
    """Headings, tables and pictures of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.headings: list[int] = []
        self.scopes: list[str | None] = []
        self.pictures: list[dict[str, str | None]] = []
        self.tables = self.captions = 0
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        named = dict(attrs)
        if re.fullmatch("h[1-6]", tag):
            self.headings.append(int(tag[1]))
        elif tag == "th":
            self.scopes.append(named.get("scope"))
        elif tag == "svg":
            self.pictures.append(named)
        self.tables += tag == "table"
        self.captions += tag == "caption"


def test_a_page_is_structured_for_who_cannot_see_it(page: str) -> None:
    made = Structure(page)
    assert made.headings[0] == 1
    assert made.headings.count(1) == 1
    assert all(after <= before + 1 for before, after in zip(made.headings, made.headings[1:], strict=False))
    assert set(made.scopes) == {"col", "row"}
    assert made.tables == made.captions > 0
    assert made.pictures
    assert all(picture.get("role") == "img" and picture.get("aria-label") for picture in made.pictures)
    assert '<html lang="en">' in page


def test_a_data_sheet_is_structured_too(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    name, file = str(tmp_path / "a.json"), tmp_path / "a.html"
    pair = ("--first-teeth", "17", "--second-teeth", "43", "--module", "3 mm")
    assert run("gear", "pair", *pair, "--json", "--output", name).status == 0
    assert run("report", name, "--output", str(file)).status == 0
    made = Structure(file.read_text())
    assert made.headings == [1]
    assert set(made.scopes) == {"col", "row"}
    assert made.tables == made.captions == 2
    assert len(made.pictures) == 3
    assert all(picture.get("role") == "img" and picture.get("aria-label") for picture in made.pictures)
    assert "a<sub>w</sub>" in file.read_text()


def test_text_contrasts_with_its_ground(page: str) -> None:
    style = page.partition("<style>")[2].partition("</style>")[0]

    def luminance(colour: str) -> float:
        digits = colour * 2 if len(colour) == 1 else colour
        whole = "".join(letter * 2 for letter in digits) if len(digits) == 3 else digits
        parts = [int(whole[i : i + 2], 16) / 255.0 for i in (0, 2, 4)]
        linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    colours = re.findall(r"(?<![-\w])color:#([0-9a-f]{3,6})", style)
    assert colours
    # WCAG 2 asks for 4.5 to 1; the darkest ground is that of code
    assert all((luminance("f4f4f4") + 0.05) / (luminance(colour) + 0.05) >= 4.5 for colour in colours)


def test_every_formula_is_typeset() -> None:
    for family in cli.FAMILIES:
        for task in cli.family(family).tasks.values():
            for text in (text for model in task.models for text in model.formulas):
                element = formula.mathml(filled(text, {}))
                Structure(element)
                assert element.count("<mrow>") == element.count("</mrow>")
                assert formula.typst(filled(text, {})).count("lr(") == formula.typst(filled(text, {})).count("lr(\\")


def test_every_symbol_of_a_formula_names_an_input_or_a_result() -> None:
    """Brackets of another kind, as in e^{iφ}, would be taken for such a name."""
    unknown = []
    for family in cli.FAMILIES:
        for task in cli.family(family).tasks.values():
            for text in (text for model in task.models for text in model.formulas):
                names = [piece.partition("}")[0].partition("|")[0] for piece in text.split("{")[1:]]
                unknown += [f"{task.path}: {name}" for name in names if not re.fullmatch(r"[a-z0-9_.]+", name)]
    assert unknown == []


@pytest.mark.parametrize("text", ["x = e^", "x = a/", "x = √", "x = -", "x = sin ", "x = (a", "x = {", ""])
def test_a_formula_that_breaks_off_is_still_typeset(text: str) -> None:
    Structure(formula.mathml(text))
    formula.typst(text)


def test_a_formula_reads_roots_fractions_scripts_and_units() -> None:
    number = formula.quantity("15.2", "m/s")
    assert formula.plain(f"v = √({number}² + 2·a)") == "v = √((15.2 m/s)² + 2·a)"
    element = formula.mathml(f"v_r = √({number}² + h/β²)")
    assert "<msqrt>" in element
    assert "<mfrac>" in element
    assert "<msub><mrow><mi>v</mi></mrow><mtext>r</mtext></msub>" in element
    assert "<mtext>\u00a0m/s</mtext>" in element


def test_a_cam_in_a_report_has_units_of_the_trade_and_tables_that_fit(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    name, file = str(tmp_path / "a.json"), tmp_path / "a.md"
    program = "rise 10 mm in 90 deg ms; dwell 90 deg; return in 90 deg; dwell"
    cam = ("--program", program, "--follower", "roller", "--base-radius", "25 mm", "--roller-radius", "6 mm")
    assert run("cam", "profile", *cam, "--json", "--output", name).status == 0
    assert run("report", name, "--full", "--output", str(file)).status == 0
    text = file.read_text()
    assert "base circle radius 25 mm; rise 10 mm in 90 deg" in text
    table = text.partition("points; 360 rows")[2]
    assert max(map(len, re.findall(r"\d[\d.]*", table.partition("\n\n")[2].partition("\n\n")[0]))) <= 10
    assert '"angle from the follower\'s direction"' in formula.typst("angle from the follower's direction")


def test_a_scene_of_a_crash_is_told_in_its_own_names(tmp_path: Path) -> None:
    for scene in ("crash_scene/crash.toml", "slide/turned.toml"):
        name = str(tmp_path / "scene.json")
        argv = ("impact", "crash", str(ROOT / "examples" / scene), "--method", "linear")
        assert run(*argv, "--json", "--output", name).status == 0
        task = FAMILIES["impact"].tasks["crash"]
        answer = to_answer(json.loads(Path(name).read_text()), task, task.digits, 80)
        assert "accurate to" not in answer
        text = run("report", name).out
        assert "Ford's speed into the impact was **" in text
        assert "driven by road friction" in text
        shown = re.findall(r"v error per degree +([\d.]+) km/h", answer)
        assert shown == re.findall(r"v error per degree \| ([\d.]+) km/h", text)
        assert all(len(digits) <= len("0.75") for digits in shown)
