"""The short answer, and what is asked for beyond it."""

import json
from pathlib import Path

import pytest
from harness import answer, run

SPEED = ("skid", "speed", "--distance", "60 ft", "--friction", "0.7")
UNCERTAIN = ("skid", "speed", "--distance", "38.5 ± 0.6 m", "--friction", "0.72 ± 0.04", "--grade", "-3 ± 0.5 %")
SWEEP = ("skid", "speed", "--distance", "60 ft", "--sweep", "friction=0.3:0.9:40")


class TestScreen:
    def test_the_headline_comes_first_with_its_limit_beside_it(self) -> None:
        first = run(*SPEED, "--limit", "50 km/h").out.splitlines()[0]
        assert first == "speed           57.044 km/h    exceeds the limit of 50 km/h by 7.044 km/h"
        assert "within the limit of 60 km/h by 2.956" in run(*SPEED, "--limit", "60 km/h").out

    def test_a_small_energy_is_in_joules_on_the_screen_alone(self) -> None:
        ball = (
            "--first-mass",
            "170 g",
            "--second-mass",
            "170 g",
            "--second-velocity",
            "0 m/s",
            "--restitution",
            "0.95",
        )
        call = ("impact", "central", "--first-velocity", "2 m/s", *ball)
        assert "energy lost E              0.016575 J" in run(*call, "-q").out
        assert run(*call, "-q", "--to", "energy_lost=kJ").out.endswith("1.6575e-05 kJ\n")
        assert run(*call, "--json").document["results"]["energy_lost"]["unit"] == "kJ"

    def test_uncertain_results_show_two_digits_of_their_deviation(self) -> None:
        lines = run(*UNCERTAIN, "--limit", "80 km/h").out.splitlines()
        assert lines[0] == "speed           82.2 km/h    95 %: 77.2 to 86.9  80 km/h exceeded: 80 %"
        assert lines[1] == "time            3.37 s       95 %: 3.19 to 3.59"
        driven = next(line for line in lines if "driven by" in line)
        assert driven == "speed, time are driven by  friction 92 %, distance 7 %, grade 2 %"

    def test_what_it_is_for_by_and_more(self) -> None:
        text = run(*SPEED).out
        assert "for   distance 60 ft, friction 0.7, gravity 9.80665 m/s² (standard)" in text
        assert "by    work–energy, Josephs & Huston §10.10; checks passed" in text
        assert "more  --all (" in text

    def test_long_tables_show_their_ends(self) -> None:
        lines = run(*SWEEP).out.splitlines()
        assert len(lines) <= 24
        assert any("rows more: --all, or --output FILE.csv" in line for line in lines)
        assert len(run(*SWEEP, "--all").out.splitlines()) > 40

    def test_rounding_is_shown_as_zero(self) -> None:
        """A cylinder turned by quarter turns has no products of inertia; what rounding leaves of them is not shown."""
        call = ("inertia", "shape", "cylinder", "--radius", "50 mm", "--length", "0.2 m", "--mass", "3 kg", "--all")
        assert "e-1" in run(*call).out
        assert "e-1" not in run(*call[:-1]).out

    def test_width_follows_the_terminal(self, monkeypatch: pytest.MonkeyPatch) -> None:
        assert max(map(len, run(*UNCERTAIN).out.splitlines())) <= 80


class TestAsked:
    def test_only_some_results_bare(self) -> None:
        assert run(*SPEED, "--only", "speed").out == "57.044 km/h\n"
        assert run(*SPEED, "--only", "speed,time").out == "57.044 km/h\n2.30828 s\n"
        assert json.loads(run(*SPEED, "--only", "time", "--json").out) == {"time": answer(*SPEED)["results"]["time"]}
        refused = run(*SPEED, "--only", "sped", "--json")
        assert (refused.status, refused.error["code"]) == (2, "unknown-result")

    def test_one_table_whole(self) -> None:
        csv = run(*SWEEP, "--table", "sweep", "--format", "csv").out.splitlines()
        assert csv[0] == "friction,speed[km/h],time[s],total_distance[m]"
        assert len(csv) == 41
        refused = run(*SPEED, "--table", "nosuch", "--json")
        assert (refused.status, refused.error["parameter"]) == (2, "table")

    def test_quiet_is_the_headline_alone(self) -> None:
        assert run(*SPEED, "-q").out == run(*SPEED).out.partition("\n\n")[0] + "\n"

    def test_all_is_everything(self) -> None:
        text = run(*SPEED, "--all").out
        assert "(error ≤" in text
        assert "surfaces" in text


class TestStatus:
    @pytest.mark.parametrize(
        ("words", "status"),
        [
            (("--limit", "50 km/h"), 0),
            (("--limit", "50 km/h", "--fail"), 6),
            (("--limit", "60 km/h", "--fail"), 0),
            (("--fail",), 0),
        ],
    )
    def test_fail_tells_by_the_status(self, words: tuple[str, ...], status: int) -> None:
        assert run(*SPEED, *words).status == status

    @pytest.mark.parametrize(("above", "status"), [("50 %", 6), ("90 %", 0)])
    def test_uncertain_limits_fail_above_a_probability(self, above: str, status: int) -> None:
        assert run(*UNCERTAIN, "--limit", "80 km/h", "--fail-above", above).status == status


class TestFiles:
    @pytest.mark.parametrize(
        ("ending", "start"),
        [
            (".json", "{\n"), (".ndjson", '{"schema"'), (".csv", "distance[ft],friction,"), (".md", "## skid speed"),
            (".txt", "speed  "), ("", "speed  "),
        ],
    )  # fmt: skip
    def test_the_ending_decides(self, tmp_path: Path, ending: str, start: str) -> None:
        path = tmp_path / f"answer{ending}"
        assert run(*SPEED, "-o", str(path)).status == 0
        assert path.read_text().startswith(start)

    @pytest.mark.parametrize(("ending", "word"), [("dxf", "--drawing"), ("png", "--plot"), ("xlsx", "endings are")])
    def test_an_ending_that_cannot_be_written_is_refused(self, tmp_path: Path, ending: str, word: str) -> None:
        outcome = run(*SPEED, "--output", str(tmp_path / f"a.{ending}"), "--format", "table")
        assert outcome.status == 2
        assert word in outcome.err
        assert not list(tmp_path.iterdir())

    def test_format_and_ending_may_not_contradict(self, tmp_path: Path) -> None:
        outcome = run(*SPEED, "--output", str(tmp_path / "a.json"), "--format", "csv")
        assert outcome.status == 2
        assert "contradict" in outcome.err
        assert run(*SPEED, "--output", str(tmp_path / "a.json"), "--format", "json").status == 0


def test_help_by_word_and_by_letter() -> None:
    assert run("help", "skid", "speed").out == run("skid", "speed", "--help").out == run("skid", "speed", "-h").out
    assert run("help").out == run("--help").out


def test_a_number_that_looks_like_letters_is_kept() -> None:
    assert run("convert", "-40degC", "degF", "-q").out == "-40 degF\n"


UNCERTAIN = ("skid", "speed", "--distance", "38.5 ± 0.6 m", "--friction", "0.72 ± 0.04", "--grade", "-3 ± 0.5 %")


def test_a_bare_uncertain_result_has_the_digits_that_its_deviation_leaves() -> None:
    assert run(*UNCERTAIN, "--only", "speed").out == "82.2 km/h\n"
    assert run(*UNCERTAIN, "--only", "speed", "--digits", "9").out.startswith("82.15")
    assert run(*UNCERTAIN, "--digits", "9", "-q").out.splitlines()[0].split()[1].startswith("82.15")


def test_inputs_are_said_as_they_were_typed() -> None:
    assert "grade -3 ± 0.5 %" in run(*UNCERTAIN).out
    rise = run("cam", "rise", "--law", "cycloidal", "--lift", "20 mm", "--span", "90 deg", "--at", "30 deg").out
    assert "at 30 deg" in rise
    vehicle = ("--first-mass", "1500 kg", "--first-stiffness-a", "600 N/cm", "--first-stiffness-b", "45 N/cm^2")
    places = ("--first-stations", "10,25 ± 2,30,12 cm", "--first-width", "150 cm")
    other = ("--second-mass", "1200 kg", "--second-energy", "20 kJ")
    assert "first stations [10, 25 ± 2, 30, 12] cm" in run("impact", "crush", *vehicle, *places, *other).out


def test_a_model_named_after_its_source_is_said_once() -> None:
    text = run("gear", "train", "--stages", "20:60, 18:54").out
    assert "by    Willis, Principles of Mechanism" in text


def test_a_quoted_temperature_with_its_target() -> None:
    assert run("convert", "98.6 F C").out.startswith("37 C\n")


def test_errors_heed_the_short_options() -> None:
    assert run("skid", "speed", "-j").err.startswith('{"error"')
    assert "--output: a document cannot be written as .pdf" in run(*SPEED, "-o", "speed.pdf").err


def test_lengths_below_a_tenth_of_a_metre_are_in_millimetres_on_the_screen_alone() -> None:
    call = ("particle", "fall", "--latitude", "45 deg", "--height")
    assert "deflection to the east  15.5239 mm\n" in run(*call, "100 m", "-q").out
    assert run(*call, "1 km", "-q").out.endswith("0.49091 m\n")
    assert answer(*call, "100 m")["results"]["deflection"]["unit"] == "m"
    assert run(*call, "100 m", "--only", "deflection").out == "0.0155239 m\n"
    assert run(*call, "100 m", "-q", "--to", "deflection=m").out.endswith("0.0155239 m\n")


def test_the_headline_alone_is_a_table_where_the_answer_is_one() -> None:
    polygon = run("vec", "polygon", "--sum", "6, 2 kN", "--magnitudes", "5, 4 kN", "-q").out
    assert "70.6506" in polygon
    assert "by    " not in polygon
    assert "torus" in run("inertia", "shapes", "--kind", "torus", "-q").out


def test_only_takes_a_group_of_results() -> None:
    call = ("inertia", "shape", "disk", "--diameter", "2 m", "--mass", "4 kg")
    assert run(*call, "--only", "moments,mass").out == "1 kg·m²\n1 kg·m²\n2 kg·m²\n4 kg\n"
    assert "moments.zz" in run(*call, "--only", "moments", "--sweep", "diameter=1:2 m:2").out
    assert "did you mean" in run(*call, "--only", "momentz").err


def test_a_table_beside_uncertain_results_says_once_that_it_is_nominal() -> None:
    phases = ("--phase", "reaction, duration=1.2 s", "--phase", "braking, distance=14 m, friction=0.7")
    line = "  table at the inputs' nominal values"
    uncertain = run("skid", "timeline", "--end-speed", "8 ± 0.5 m/s", *phases)
    assert uncertain.out.splitlines().count(line) == 1
    every = run("skid", "timeline", "--end-speed", "8 ± 0.5 m/s", *phases, "--all").out
    assert every.count("at the inputs' nominal values") == 1
    assert line not in run("skid", "timeline", "--end-speed", "8 m/s", *phases).out
    assert line not in run("skid", "speed", "--distance", "38 ± 1 m", "--friction", "0.7").out
