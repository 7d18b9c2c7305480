"""How every command reads, answers and writes."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from harness import answer, run
from shell import ROOT

import dynamics_cli

OK = ("skid", "speed", "--distance", "60 ft", "--friction", "0.7")


def speed(*more: str, **keywords: object) -> dict:
    return answer(*OK, *more, **keywords)["results"]["speed"]


class TestQuantities:
    @pytest.mark.parametrize(
        "text", ["60 ft", "60ft", "6e1 ft", "60.0 ft", "+60 ft", "20 yd", "720 in", "60 ft 0 in", "18.288 m", "18288mm"]
    )
    def test_one_length_in_many_spellings(self, text: str) -> None:
        document = answer("skid", "speed", "--distance", text, "--friction", "0.7")
        assert document["results"]["speed"]["value"] == 57.04399891126848

    def test_negative_numbers_just_work(self) -> None:
        assert answer("convert", "-40", "degC", "degF")["results"]["value"]["value"] == -40.0
        assert speed("--grade", "-3 %")["value"] < speed()["value"]
        assert speed("--grade", "-3 %") == speed("--grade", "−3 %") == speed("--grade", "-0.03")

    def test_a_grade_may_be_an_angle(self) -> None:
        assert speed("--grade", "45 deg")["value"] == pytest.approx(speed("--grade", "100 %")["value"], rel=1e-15)

    def test_lb_is_a_force_or_a_mass_by_what_is_wanted_and_the_reading_is_reported(self) -> None:
        document = answer(*OK, "--mass", "3300 lb")
        assert document["warnings"][0]["message"] == "mass: lb read as pound-mass"
        document = answer("convert", "150", "lb", "N")
        assert document["warnings"][0]["message"] == "lb read as pound-force"

    def test_g_is_standard_gravity_whatever_gravity_says(self) -> None:
        assert answer("convert", "1", "g", "m/s^2")["results"]["value"]["value"] == 9.80665
        assert answer("convert", "1", "g", "kg")["results"]["value"]["value"] == 0.001

    def test_an_earlier_result_by_reference(self, tmp_path: Path) -> None:
        first = tmp_path / "first.json"
        assert run(*OK, "--json", "--output", str(first)).status == 0
        document = answer("skid", "speed", "--distance", "30 ft", "--friction", "0.5", "--end-speed", f"@{first}:speed")
        assert document["inputs"]["end_speed"]["value"] == 57.04399891126848
        assert document["files"][0]["name"] == str(first)
        surfaces = answer("convert", f"@{first}:surfaces[0].entry_speed", "mph")
        assert surfaces["results"]["value"]["value"] == pytest.approx(35.4455, abs=1e-4)


class TestGravity:
    def test_the_value_used_is_in_the_output(self) -> None:
        assert answer(*OK)["inputs"]["gravity"] == {"value": 9.80665, "unit": "m/s²"}

    def test_the_environment_sets_it_and_the_option_wins(self) -> None:
        env = {"DYNAMICS_GRAVITY": "32.2 ft/s^2"}
        assert answer(*OK, env=env)["inputs"]["gravity"] == {"value": 32.2, "unit": "ft/s^2"}
        document = answer(*OK, "--gravity", "9.8 m/s^2", env=env)
        assert document["inputs"]["gravity"] == {"value": 9.8, "unit": "m/s^2"}

    def test_a_wrong_environment_is_told(self) -> None:
        outcome = run(*OK, "--json", env={"DYNAMICS_GRAVITY": "32.2"})
        assert outcome.status == 2
        assert outcome.error["parameter"] == "gravity"


class TestUnits:
    def test_systems(self) -> None:
        assert speed()["unit"] == "km/h"
        assert speed("--units", "us")["unit"] == "mph"
        assert speed("--units", "base") == {"value": 15.845555253130133, "unit": "m/s"}

    def test_the_unit_of_one_result(self) -> None:
        document = answer(*OK, "--to", "speed=ft/s", "--to", "total_distance=ft;in")
        assert document["results"]["speed"]["unit"] == "ft/s"
        assert document["results"]["total_distance"] == {"value": [60, 0.0], "unit": "ft;in"}
        assert "60 ft 0 in" in run(*OK, "--to", "total-distance=ft;in").out

    def test_table_and_json_show_the_same_units(self) -> None:
        assert "35.445" in run(*OK, "--units", "us").out
        assert "mph" in run(*OK, "--units", "us").out

    def test_unit_strings_parse_back_in(self) -> None:
        document = answer(*OK, "--mass", "1500 kg", "--units", "us")
        energy = document["results"]["energy"]
        again = answer("convert", f"{energy['value']} {energy['unit']}", "J")
        assert again["results"]["value"]["value"] == pytest.approx(188312, rel=1e-4)


class TestOutput:
    def test_formats(self) -> None:
        assert run(*OK).out.startswith("speed           57.044 km/h\n")
        assert run(*OK, "--format", "csv").out.splitlines()[0].startswith("distance[ft],friction,")
        assert run(*OK, "--format", "markdown").out.startswith("## skid speed\n")
        assert json.loads(run(*OK, "--format", "ndjson").out) == answer(*OK)
        assert run(*OK, "--format", "ndjson").out.count("\n") == 1
        assert run(*OK, env={"DYNAMICS_FORMAT": "csv"}).out == run(*OK, "--format", "csv").out

    def test_csv_of_one_case_is_the_row_that_rows_would_write(self) -> None:
        one = run(*OK, "--mass", "1500 kg", "--gravity", "9.81 m/s^2", "--format", "csv").out
        rows = run("skid", "speed", "--rows", "-", stdin=one)
        single, many = (
            dict(zip(*(line.split(",") for line in out.splitlines()), strict=True)) for out in (one, rows.out)
        )
        assert single["friction"] == "0.7"
        assert single["speed[km/h]"] == many["results.speed[km/h]"]
        assert list(single)[-1] == "error"

    def test_an_uncertain_case_has_its_spread_beside_each_result(self) -> None:
        head, cells = run(
            "skid", "speed", "--distance", "60 ft", "--friction", "0.7 ± 0.03", "--format", "csv"
        ).out.splitlines()
        columns = head.split(",")
        at = columns.index("speed[km/h]")
        names = ("mean", "median", "std", "low", "high")
        assert columns[at + 1 : at + 6] == [f"speed.{name}[km/h]" for name in names]
        assert cells.split(",")[columns.index("friction")] == "0.7 ± 0.03"

    def test_digits_are_of_tables_json_carries_all(self) -> None:
        assert "57.0440 " not in run(*OK).out
        assert "57.0439989" in run(*OK, "--digits", "9").out
        assert "57.04399891126848" in run(*OK, "--digits", "17").out
        assert speed("--digits", "2")["value"] == 57.04399891126848

    def test_the_document_has_what_the_contract_says(self) -> None:
        document = answer(*OK)
        assert list(document) == [
            "schema", "command", "version", "inputs", "results", "model", "numerics", "checks", "warnings",
        ]  # fmt: skip
        assert document["schema"] == "dynamics/2"
        assert document["command"] == "skid speed"
        assert document["version"] == dynamics_cli.__version__
        assert document["inputs"]["distance"] == {"value": 60, "unit": "ft"}
        assert document["inputs"]["friction"] == {"value": 0.7}
        assert document["numerics"]["condition"]["speed"] == {"distance": 0.5, "friction": 0.5, "gravity": 0.5}
        assert document["numerics"]["error_bound"]["speed"]["relative"] < 1e-15
        assert document["checks"][0]["passed"] is True

    def test_same_input_same_output(self) -> None:
        assert run(*OK, "--json").out == run(*OK, "--json").out

    def test_results_go_to_stdout_and_nothing_else_does(self) -> None:
        assert run(*OK).err == ""
        assert run("skid", "speed").out == ""

    def test_version_help_and_timing(self) -> None:
        assert run("--version").out == f"dynamics {dynamics_cli.__version__}\n"
        assert run("--version", route="tree").out == f"dynamics {dynamics_cli.__version__}\n"
        assert run().out == run("--help").out
        timing = answer(*OK, "--timing")["timing"]
        assert timing["unit"] == "s"
        assert 0.0 < timing["value"] < 1.0
        assert "took  " in run(*OK, "--timing").out

    def test_explain(self) -> None:
        explanation = answer(*OK, "--explain")["explanation"]
        assert explanation["formula"] == "v = √(vₑ² + 2·g·Σ f·d), f = (η·μ + G)/√(1 + G²)"
        assert explanation["with_numbers"].startswith("(57.044 km/h) = √((0 km/h)² + 2·(9.80665 m/s²)")
        assert "Josephs & Huston" in explanation["source"]
        assert explanation["assumptions"]
        assert "formula  v = " in run(*OK, "--explain").out

    def test_limits(self) -> None:
        (limit,) = answer(*OK, "--limit", "50 mph")["limits"]
        assert limit["beyond"] is False
        assert limit["limit"] == {"value": 50, "unit": "mph"}
        (limit,) = answer(*OK, "--limit", "speed=30 mph", "--units", "us")["limits"]
        assert limit["beyond"] is True
        assert limit["by"]["value"] == pytest.approx(5.4455, abs=1e-4)
        assert "exceeds the limit of 30 mph by 5.4455 mph" in run(*OK, "--limit", "30 mph", "--units", "us").out

    def test_a_special_file_is_written_through(self, tmp_path: Path) -> None:
        assert run(*OK, "--output", os.devnull).status == 0
        assert not Path(os.devnull).is_file()

    def test_a_closed_pipe_ends_quietly(self) -> None:
        command = f"{sys.executable} -m dynamics_cli units list --json | head -n 1"
        done = subprocess.run(command, shell=True, capture_output=True, text=True, check=False, cwd=ROOT)
        assert done.stdout == "{\n"
        assert done.stderr == ""


class TestInput:
    def test_json_toml_and_standard_input_agree(self, tmp_path: Path) -> None:
        scene = {"distance": "60 ft", "friction": 0.7}
        (tmp_path / "scene.json").write_text(json.dumps(scene))
        (tmp_path / "scene.toml").write_text('distance = "60 ft"\nfriction = 0.7\n')
        plain = answer(*OK)["results"]
        for name in ("scene.json", "scene.toml"):
            assert answer("skid", "speed", "--input", str(tmp_path / name))["results"] == plain
        for text in (json.dumps(scene), 'distance = "60 ft"\nfriction = 0.70', "\ufeff" + json.dumps(scene)):
            assert answer("skid", "speed", "--input", "-", stdin=text)["results"] == plain

    def test_options_win(self) -> None:
        document = answer(
            "skid", "speed", "--input", "-", "--friction", "0.7", stdin='{"distance":"60 ft","friction":1}'
        )
        assert document["inputs"]["friction"] == {"value": 0.7}

    def test_a_lone_segment_on_the_command_line_replaces_the_file_s_list(self) -> None:
        scene = json.dumps({"segments": [{"distance": "1 m", "friction": 1}], "end_speed": "1 m/s"})
        document = answer(*OK, "--input", "-", stdin=scene)
        assert "segments" not in document["inputs"]
        assert document["inputs"]["end_speed"] == {"value": 1, "unit": "m/s"}

    def test_the_results_of_an_earlier_document_are_read_as_parameters(self) -> None:
        first = run(*OK, "--json").out
        document = answer("skid", "distance", "--friction", "0.7", "--input", "-", stdin=first)
        assert document["results"]["distance"]["value"] == pytest.approx(18.288, rel=1e-14)

    def test_bare_numbers_are_read_exactly_from_their_text(self) -> None:
        text = '{"distance": "60 ft", "friction": 0.70000000000000000000000001}'
        assert answer("skid", "speed", "--input", "-", stdin=text)["inputs"]["friction"] == {"value": 0.7}


class TestPython:
    def test_run_answers_with_the_document(self) -> None:
        document = dynamics_cli.run("skid speed", distance="60 ft", friction=0.7)
        assert document == answer(*OK)

    def test_run_takes_lists_of_records(self) -> None:
        document = dynamics_cli.run("skid speed", segments=[{"distance": "60 ft", "friction": 0.7}])
        assert document["results"]["speed"]["value"] == 57.04399891126848

    def test_run_raises_what_the_command_line_reports(self) -> None:
        from dynamics_cli.errors import DynamicsError

        with pytest.raises(DynamicsError, match="distance is missing"):
            dynamics_cli.run("skid speed", friction=0.7)

    def test_module_run(self) -> None:
        done = subprocess.run(
            [sys.executable, "-m", "dynamics_cli", *OK], capture_output=True, text=True, cwd=ROOT, check=False
        )
        assert done.stdout == run(*OK).out


class TestCompletion:
    @pytest.mark.parametrize(
        ("words", "count", "expected"),
        [
            ("dynamics sk", 1, "skid"),
            ("dynamics skid sp", 2, "speed"),
            ("dynamics skid speed --fr", 3, "--friction"),
            ("dynamics skid speed --format j", 4, "json"),
            ("dynamics units table jo", 3, "josephs-huston"),
            ("dynamics convert 60 mp", 3, "mph"),
            ("dynamics skid speed --method mo", 4, "monte-carlo"),
            ("dynamics skid vault --model ", 4, "known-take-off-angle"),
            ("dynamics schema sk", 2, "skid"),
            ("dynamics schema skid th", 3, "throw"),
            ("dynamics reference co", 2, "convert"),
            ("dynamics reference skid --format m", 4, "man"),
        ],
    )
    def test_names_complete(self, words: str, count: int, expected: str) -> None:
        env = {**os.environ, "COMP_WORDS": words, "COMP_CWORD": str(count), "_DYNAMICS_COMPLETE": "complete_bash"}
        code = "import sys; sys.argv = ['dynamics']; from dynamics_cli.cli import main; main()"
        done = subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, env=env, cwd=ROOT, check=False
        )
        assert expected in done.stdout.split()

    @pytest.mark.parametrize("name", ["bash", "zsh", "fish"])
    def test_scripts_are_printed(self, name: str) -> None:
        assert "_DYNAMICS_COMPLETE" in run("--show-completion", name).out

    def test_another_shell_is_refused(self) -> None:
        assert run("--show-completion", "tcsh").status == 2
