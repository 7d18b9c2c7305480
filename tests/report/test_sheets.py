"""Data sheets: one gear pair or one cam on one page, with the sizes that its drawing and its inspector need."""

import re
from pathlib import Path

import pytest
from harness import answer, run

CYCLE = "rise 10 mm in 90 deg ms; dwell 90 deg; return in 90 deg; dwell"
SWING = "rise 15 deg in 120 deg; dwell 60 deg; return in 120 deg; dwell"
PAIR = ("gear", "pair", "--first-teeth", "17", "--second-teeth", "43", "--module", "3 mm")
SHIFTED = (*PAIR, "--first-profile-shift", "0.3", "--backlash", "0.1 mm")
HELICAL = (
    "gear", "pair", "--first-teeth", "12", "--second-teeth", "60", "--module", "3 mm", "--helix-angle", "30 deg",
    "--centre-distance", "125 mm", "--split", "first", "--face-width", "60 mm", "--power", "5 kW", "--speed",
    "1450 rpm",
)  # fmt: skip
RING = (
    "gear", "pair", "--first-teeth", "16", "--second-teeth", "24", "--diametral-pitch", "8 1/in", "--internal",
    "--second-profile-shift", "0.5", "--shift-sign", "khk", "--units", "us",
)  # fmt: skip
ROLLER = ("cam", "profile", "--program", CYCLE, "--follower", "roller", "--base-radius", "25 mm",
          "--roller-radius", "6 mm")  # fmt: skip
ARM = ("cam", "export", "--program", SWING, "--follower", "oscillating-roller", "--base-radius", "30 mm",
       "--roller-radius", "8 mm", "--arm", "80 mm", "--pivot-distance", "100 mm", "--tolerance", "2 um")  # fmt: skip
FLAT = ("cam", "profile", "--program", CYCLE, "--follower", "flat-face", "--base-radius", "45 mm", "--thickness",
        "10 mm", "--density", "7800 kg/m^3")  # fmt: skip


def sheet(folder: Path, argv: tuple[str, ...], *more: str) -> str:
    """The data sheet of a call, in Markdown."""
    name = str(folder / "a.json")
    assert run(*argv, "--json", "--output", name).status == 0
    outcome = run("report", name, *more)
    assert outcome.status == 0, outcome.err
    return outcome.out


def rows(text: str) -> dict[str, list[str]]:
    """The cells of every row by its name."""
    cells = [[cell.strip() for cell in line.strip("| ").split("|")] for line in text.splitlines() if line[:1] == "|"]
    return {row[0]: row[2:] for row in cells}


@pytest.mark.parametrize("argv", [SHIFTED, HELICAL, RING, ROLLER, ARM, FLAT], ids=lambda argv: " ".join(argv[:6]))
def test_a_sheet_is_one_page(argv: tuple[str, ...], tmp_path: Path) -> None:
    pytest.importorskip("typst")
    pytest.importorskip("matplotlib")
    sheet(tmp_path, argv)
    for paper in ("a4", "letter"):
        file = tmp_path / f"{paper}.pdf"
        assert run("report", str(tmp_path / "a.json"), "--paper", paper, "--output", str(file)).status == 0
        assert len(re.findall(rb"/Type\s*/Page\b", file.read_bytes())) == 1, paper


def test_a_pair_is_measured_as_gear_measure_does(tmp_path: Path) -> None:
    shown = rows(sheet(tmp_path, SHIFTED))
    # ISO 21771: A_sn of each gear is half of j_wt at the reference circles, 0.05 · a_d/a_w
    assert shown["thinning of the teeth"] == ["0.04952 mm"] * 2
    thin = str(-0.1 / 2.0 * 90.0 / 90.8692848) + " mm"
    for nth, (teeth, shift, tip) in enumerate(((17, "0.3", "58.7386622"), (43, "0", "134.938662"))):
        one = answer("gear", "measure", "--teeth", str(teeth), "--module", "3 mm", "--profile-shift", shift,
                     "--tip-diameter", f"{tip} mm", "--upper-allowance", thin)["results"]  # fmt: skip
        for name, value in (
            ("span (base tangent)", one["span"]["span"]),
            ("span, thinned", one["span"]["span_upper"]),
            ("size over (between) pins", one["pins"]["size"]),
            ("size over pins, thinned", one["pins"]["size_upper"]),
            ("pin or ball diameter", one["pins"]["pin"]),
            ("chordal thickness", one["chordal"]["thickness"]),
        ):
            assert shown[name][nth] == f"{value['value']:.6g} mm", name


def test_a_helical_pair_has_its_forces_and_hands(tmp_path: Path) -> None:
    shown = rows(sheet(tmp_path, HELICAL))
    assert shown["hand of helix"] == ["right", "left"]
    # T = P/ω, and F_t = 2T/d_w
    assert shown["torque on gear 1"] == ["32.9286 N·m"]
    assert shown["tangential force"] == ["1580.6 N"]
    assert shown["overlap ratio"] == ["3.183"]


def test_a_ring_is_in_the_units_of_its_document(tmp_path: Path) -> None:
    text = sheet(tmp_path, RING)
    assert text.startswith("# Gear pair 16 / 24 internal, diametral pitch 8 1/in")
    shown = rows(text)
    assert shown["reference diameter"] == ["2 in", "3 in"]
    assert shown["number of teeth"] == ["16", "-24"]
    assert shown["interference"] == ["yes: involute, root"]


def test_a_cam_has_its_motion_limits_and_the_deviation_of_its_drawing(tmp_path: Path) -> None:
    text = sheet(tmp_path, ROLLER)
    shown = rows(text)
    assert shown["maximum pressure angle"] == ["17.434 deg at 41.64 deg"]
    assert shown["cam curve as drawn (DXF)"][0].endswith("arcs")
    assert 0.0 < float(shown["deviation, proved"][0].removesuffix(" mm")) <= 1e-3
    table = [line for line in text.splitlines() if re.match(r"\| \d+ \|", line)]
    assert [float(line.split("|")[1]) for line in table] == [30.0 * nth for nth in range(12)]
    # half of a modified sine's lift at half of its span lies between 30 and 60 degrees; at 90 it is whole
    assert table[3].split("|")[2].strip() == "10.000"
    exported = rows(sheet(tmp_path, ARM))
    assert float(exported["deviation, proved"][0].removesuffix(" mm")) <= 2e-3
    assert exported["length of the arm"] == ["80 mm"]


def test_a_plate_s_mass_is_that_of_its_area(tmp_path: Path) -> None:
    shown = rows(sheet(tmp_path, FLAT))
    area, mass = (float(shown[name][0].split()[0]) for name in ("area of the plate", "mass of the plate"))
    assert mass == pytest.approx(area * 1e-6 * 0.010 * 7800.0, rel=1e-5)


def test_the_whole_report_is_there_when_asked_for_and_where_no_sheet_can_be_drawn(tmp_path: Path) -> None:
    assert "## Appendix" in sheet(tmp_path, PAIR, "--full")
    uncertain = (*PAIR, "--friction", "0.06 ± 0.01")
    assert "## Appendix" in sheet(tmp_path, uncertain)
    assert "## Appendix" not in sheet(tmp_path, PAIR)


def test_several_results_are_a_page_each(tmp_path: Path) -> None:
    names = [str(tmp_path / f"{nth}.json") for nth in (1, 2)]
    for name, argv in zip(names, (PAIR, ROLLER), strict=True):
        assert run(*argv, "--json", "--output", name).status == 0
    text = run("report", *names, "--title", "Drive").out
    assert text.startswith("# Drive")
    assert text.count("\n---\n") == 1
    assert "## Gear pair 17 / 43, module 3 mm" in text
    assert "## Roller cam, base circle radius 25 mm" in text
