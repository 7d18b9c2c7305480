"""Reports: what a document says, calculated again from the inputs it holds, in Markdown and HTML."""

import hashlib
import json
import re
import sys
from html.parser import HTMLParser
from pathlib import Path

import pytest
from harness import run
from shell import ROOT

SPEED = ("skid", "speed", "--distance", "60 ± 2 ft", "--friction", "0.7 ± 0.05", "--limit", "35 mph", "--units", "us")
SAME = "every result is the same to the last digit"


def written(folder: Path, name: str, *argv: str) -> str:
    file = folder / name
    outcome = run(*argv, "--json", "--output", str(file))
    assert outcome.status == 0, outcome.err
    return str(file)


class Page(HTMLParser):
    """Checks that every element is closed, and collects names."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.ids: list[str] = []
        self.words: list[str] = []
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list) -> None:
        self.ids += [value for key, value in attrs if key == "id"]
        if tag not in ("meta", "use", "path"):
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list) -> None:
        self.ids += [value for key, value in attrs if key == "id"]

    def handle_endtag(self, tag: str) -> None:
        if tag not in ("meta", "use", "path"):
            assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.words.append(data)


@pytest.mark.parametrize(
    "argv",
    [
        SPEED,
        (*SPEED, "--correlate", "distance,friction=0.3", "--coverage", "90 %"),
        (*SPEED[:2], "--distance", "60 ft", "--friction", "0.7", "--to", "speed=ft/s", "--to", "total-distance=ft;in"),
        ("skid", "vault", "--distance", "18 m", "--rise", "-3 m", "--take-off", "6 deg"),
        ("skid", "vault", "--distance", "18 m", "--rise", "-3 m", "--model", "least-speed-over-all-angles"),
        ("skid", "stop", "--speed", "50 km/h", "--friction", "0.75", "--reaction-time", "1 s", "--units", "us"),
        ("skid", "speed", "--segment", "distance=60 ft, friction=0.7", "--segment", "distance=9 m, friction=0.3"),
        ("convert", "60", "mph", "ft/s", "km/h"),
        ("convert", "1.8796 m", "ft;in"),
        # its results hold `mass` and, as a pure number, `cancellation.mass`
        ("inertia", "body", str(ROOT / "examples" / "flywheel.toml"), "--to", "mass=lb"),
        ("cam", "motion", "--program", "rise 1 in in 120 deg parabolic; dwell 60 deg; return in 120 deg linear; dwell",
         "--singularity", "--units", "us"),
        ("coords", "3", "1", "4", "--from", "cartesian", "--into", "spherical"),
    ],
)  # fmt: skip
def test_documents_are_calculated_again_to_the_last_digit(argv: tuple[str, ...], tmp_path: Path) -> None:
    outcome = run("report", written(tmp_path, "a.json", *argv))
    assert outcome.status == 0, outcome.err
    assert SAME in outcome.out


def test_a_report_says_what_the_document_says(tmp_path: Path) -> None:
    text = run("report", written(tmp_path, "a.json", *SPEED), "--title", "Case 7").out
    for words in (
        "# Case 7", "1. A: the speed was **35.4 mph** (95 %: 32.6 to 38.1), above the limit of 35 mph with",
        "| speed | 35.4 mph | 32.6 to 38.1 | above the limit of 35 mph with a probability of 62 % | friction 82 %",
        "**Given:** distance 60 ± 2 ft; friction 0.7 ± 0.05; gravity 9.80665 m/s² (standard).",
        "friction is constant on each surface", "v = √(vₑ² + 2·g·Σ f·d) = √((0 km/h)² + ", " = 35.4 mph",
        "energy balance: passed", "| speed | 35.445", "| 3.5e-16 relative |",
        "Source: Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10",
    ):  # fmt: skip
        assert words in text, words


TWO = (
    "--first-kind", "constant", "--first-duration", "5 s", "--first-end-speed", "13 m/s",
    "--second-kind", "constant", "--second-duration", "5 s", "--second-end-speed", "1.5 m/s",
)  # fmt: skip


@pytest.mark.parametrize(
    ("argv", "finding"),
    [
        (("skid", "sight", *TWO, "--corner-before", "6 m", "--corner-aside", "1.8 m", "--eye-behind", "2 m",
          "--first-name", "Ford"),
         "the second party came into sight **1.622 s** before the impact, with the Ford **21.08 m** from it at "
         "**13 m/s**."),
        (("skid", "meet", *TWO, "--first-name", "car 2", "--second-name", "child"),
         "the child set out **5 s** before the impact, with car 2 **65 m** away at **13 m/s**."),
        (("impact", "central", "--first-mass", "1 kg", "--first-velocity", "3 m/s", "--second-mass", "1 kg",
          "--restitution", "1"), "the second body's velocity after the impact was **3 m/s**"),
        (("energy", "body", "--body", "mass=2 kg, velocity=3, 0 m/s"),
         "the kinetic energy is **9 J**; of the mass centres: **9 J**"),
        (("stability", "routh", "s^2 + s + 1"), "roots on the left: **2**; on the right: **0**"),
    ],
)  # fmt: skip
def test_findings_are_sentences(argv: tuple[str, ...], finding: str, tmp_path: Path) -> None:
    assert finding in run("report", written(tmp_path, "a.json", *argv)).out


def test_a_changed_result_is_told(tmp_path: Path) -> None:
    name = written(tmp_path, "a.json", *SPEED)
    document = json.loads(Path(name).read_text())
    document["results"]["speed"]["value"] = 36.0
    Path(name).write_text(json.dumps(document))
    text = run("report", name).out
    assert SAME not in text
    assert "these differ: speed was 36" in text


def test_the_inputs_it_holds_calculate_it_again(tmp_path: Path) -> None:
    text = run("report", written(tmp_path, "a.json", *SPEED)).out
    inputs = text.rpartition("```\n{")[2].partition("\n```")[0]
    file = tmp_path / "inputs.json"
    file.write_text("{" + inputs)
    again = run("skid", "speed", "--input", str(file), "--json").document
    assert again["results"]["speed"]["value"] == run(*SPEED[:6], "--json").document["results"]["speed"]["value"]


def test_html_is_one_whole_page_with_its_pictures(tmp_path: Path) -> None:
    names = [written(tmp_path, "a.json", *SPEED), written(tmp_path, "b.json", *SPEED[:-2])]
    page = tmp_path / "report.html"
    assert run("report", *names, "--output", str(page)).status == 0
    text = page.read_text()
    parsed = Page(text)
    # on the first page the picture of the second, in its section that of the first
    assert text.count("<svg") == 2
    assert len(parsed.ids) == len(set(parsed.ids))
    assert not re.search(r'(src|href)="https?:', re.sub(r'xmlns[:\w]*="[^"]*"', "", text))
    assert "SHA-256" in text


def test_markdown_puts_its_pictures_beside_it(tmp_path: Path) -> None:
    page = tmp_path / "my report.md"
    assert run("report", written(tmp_path, "a.json", *SPEED), "--output", str(page)).status == 0
    assert "](my%20report-1.svg)" in page.read_text()
    assert (tmp_path / "my report-1.svg").read_bytes().startswith(b"<?xml")


def test_words_in_a_document_cannot_become_markup(tmp_path: Path) -> None:
    name = written(tmp_path, "a.json", *SPEED)
    document = json.loads(Path(name).read_text())
    document["warnings"] = [{"code": "x", "severity": "note", "message": "<script>alert(1)</script> | *b*"}]
    Path(name).write_text(json.dumps(document))
    assert "<script>" not in run("report", name, "--format", "html").out
    assert "\\<script>" in run("report", name).out


def test_several_documents_from_standard_input_and_a_sweep(tmp_path: Path) -> None:
    lines = run(*SPEED, "--format", "ndjson").out * 2
    text = run("report", "-", stdin=lines).out
    assert text.count(SAME) == 2
    sweep = written(tmp_path, "s.json", "skid", "speed", "--distance", "9 m", "--friction", "0.7",
                    "--sweep", "friction=0.1:0.9:99")  # fmt: skip
    shown = run("report", sweep).out
    assert SAME in shown
    assert "| … |" in shown
    assert "99 rows, of which the first and the last 20 are shown" in shown
    assert "friction 0.1 to 0.9, 99 values" in shown


@pytest.mark.parametrize(
    "more",
    [
        ("--friction", "0.7", "--sweep", "friction=0.1:0.9:4", "--sweep", "distance=3 m:9 m:3", "--units", "us"),
        ("--friction", "0.7", "--sweep", "friction=0.1:0.9:5", "--to", "speed=ft/s"),
        ("--sweep", "distance=3 m:9 m:3", "--friction", "0.7 ± 0.05", "--coverage", "90 %"),
    ],
)
def test_sweeps_are_calculated_again_and_what_differs_is_told(more: tuple[str, ...], tmp_path: Path) -> None:
    name = written(tmp_path, "s.json", "skid", "speed", "--distance", "9 m", *more)
    assert SAME in run("report", name).out
    document = json.loads(Path(name).read_text())
    document["results"]["sweep"]["speed"]["value"][1] *= 1.0 + 1e-15
    Path(name).write_text(json.dumps(document))
    text = run("report", name).out
    assert SAME not in text
    assert r"these differ: sweep.speed\[1] was" in text


def test_a_changed_interval_is_told_and_so_is_a_changed_row_of_a_table(tmp_path: Path) -> None:
    name = written(tmp_path, "a.json", *SPEED)
    text = Path(name).read_text()
    for change in (("interval", 0), ("std", None)):
        document = json.loads(text)
        node = document["results"]["speed"]
        if change[1] is None:
            node[change[0]] *= 1.001
        else:
            node[change[0]][change[1]] *= 1.001
        Path(name).write_text(json.dumps(document))
        place = change[0] if change[1] is None else f"{change[0]}\\[{change[1]}]"
        assert f"these differ: speed, {place} was" in run("report", name).out
    document = json.loads(text)
    document["results"]["surfaces"][0]["time"]["value"] *= 1.001
    Path(name).write_text(json.dumps(document))
    assert r"these differ: surfaces\[0].time was" in run("report", name).out


def test_a_report_leads_with_its_case_and_what_was_found(tmp_path: Path) -> None:
    first = written(tmp_path, "before.json", *SPEED[:-2])
    second = written(tmp_path, "after.json", "skid", "distance", "--speed", f"@{first}:speed", "--friction", "0.7")
    text = run("report", first, second, "--case", "2026-17", "--author", "A. Expert", "--date", "1 May 2026").out
    assert text.startswith("# Calculations\n\n- Case: 2026-17\n- Prepared by: A. Expert\n- 1 May 2026\n- dynamics ")
    assert "1. Before: the speed was **57.0 km/h** (95 %: 52.5 to 61.4), above the limit of 35 mph with" in text
    assert "2. After: the distance was **" in text
    assert "2 of 2 calculations gave the same results" in text
    assert "## 2. After: distance and time in which" in text
    files = text.partition("Appendix D: Files")[2]
    digest = hashlib.sha256(Path(first).read_bytes()).hexdigest()
    assert f"| before.json | document of section 1; read by section 2 | {digest} |" in files


def test_tables_and_figures_are_numbered_and_the_methods_of_uncertainty_are_told(tmp_path: Path) -> None:
    page = tmp_path / "r.html"
    assert run("report", written(tmp_path, "a.json", *SPEED), "--output", str(page)).status == 0
    text = page.read_text()
    numbers = [int(one) for one in re.findall(r"<caption>Table (\d+)\.", text)]
    assert numbers == list(range(1, text.count("<table") + 1))
    assert "<figcaption>Figure 1. Section 1, A: " in text
    assert "uncertainty: tensor Gauss–Hermite along the gradient, its error estimated at" in text


def test_without_the_library_there_are_no_pictures_and_it_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    name = written(tmp_path, "a.json", *SPEED)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    outcome = run("report", name, "--format", "html")
    assert outcome.status == 0
    assert "<svg" not in outcome.out
    assert "dynamics-cli[plot]" in outcome.err


@pytest.mark.parametrize(
    ("text", "words"),
    [("{}", "no result document"), ("", "is empty"), ("[1, 2", "not JSON"), ('{"schema": "dynamics/9"}', "no result"),
     ("[]", "no result document")],
)  # fmt: skip
def test_what_is_no_document_is_refused(text: str, words: str) -> None:
    outcome = run("report", "-", stdin=text)
    assert outcome.status == 2
    assert words in outcome.err


def test_a_document_of_an_unknown_command_is_shown_and_not_calculated(tmp_path: Path) -> None:
    name = written(tmp_path, "a.json", *SPEED)
    Path(name).write_text(Path(name).read_text().replace('"skid speed"', '"skid leap"'))
    text = run("report", name).out
    assert "this version has no command 'skid leap'" in text
    assert "not calculated here" in text
    assert '"value": 35.44' in text
    assert "| speed |" not in text


def test_a_document_in_another_folder_finds_the_files_of_its_command(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bracket.stl").write_bytes((ROOT / "examples" / "bracket.stl").read_bytes())
    (tmp_path / "results").mkdir()
    mesh = ("inertia", "mesh", "bracket.stl", "--length-unit", "mm", "--mass", "50 g")
    name = written(tmp_path, "results/mesh.json", *mesh)
    assert "1 of 1 calculation gave the same results" in run("report", name).out


def test_wrong_calls(tmp_path: Path) -> None:
    assert run("report").status == 2
    assert run("report", "none.json").status == 2
    name = written(tmp_path, "a.json", *SPEED)
    assert run("report", name, "--format", "pdf").status == 2
    assert run("report", name, "--digits", "0").status == 2
    assert run("report", name, "--output", "report.docx").status == 2
    assert run("report", name, "--output", str(tmp_path / "no" / "a.html")).status == 5


def test_an_answer_in_words_is_a_finding_and_symbols_have_subscripts(tmp_path: Path) -> None:
    gain, drive = (str(tmp_path / name) for name in ("gain.json", "drive.json"))
    run("stability", "gain", "s(s+1)(s+2) + K", "--json", "--output", gain)
    road = ("--rolling-resistance", "0.012", "--drag-area", "0.7 m^2")
    run("energy", "drive", "--mass", "1500 kg", "--speed", "90 km/h", *road, "--json", "--output", drive)
    text = run("report", gain, drive, "--format", "html").out
    assert "Gain: stable for <strong>0 &lt; K &lt; 6</strong>" in text
    assert "c<sub>dA</sub> is drag area" in text
    assert "drag area 0.7 m²" in text
    assert run("report", gain).out.startswith("# Gains for which a closed loop is stable, exactly\n")
