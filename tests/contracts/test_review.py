"""Faults that a reviewer found, each kept from coming back."""

import hashlib
import json
import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest
from harness import answer, run
from shell import ROOT

from dynamics_cli.core.json_text import to_json
from dynamics_cli.errors import FaultError

OK = ("skid", "speed", "--distance", "60 ft", "--friction", "0.7")


def shell(command: str) -> subprocess.CompletedProcess[str]:
    program = f"{sys.executable} -m dynamics_cli"
    return subprocess.run(
        ["bash", "-c", command.replace("dynamics ", f"{program} ")],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )


class TestBounds:
    def test_a_column_with_a_zero_keeps_a_bound_that_holds_for_every_cell(self) -> None:
        argv = ("--speed", "50 km/h", "--friction", "0.75", "--reaction-time", "1 s", "--build-up-time", "0.2 s")
        document = answer("skid", "stop", *argv)
        assert document["results"]["timeline"][-1]["speed"]["value"] == 0.0
        bound = document["numerics"]["error_bound"]["timeline.speed"]
        assert bound.get("relative", 0.0) > 1e-16 or bound.get("absolute", 0.0) > 1e-16

    def test_no_document_holds_an_infinity(self) -> None:
        with pytest.raises(FaultError):
            to_json({"value": float("inf")})
        with pytest.raises(FaultError):
            to_json([float("nan")])

    def test_a_bound_of_compound_units_is_in_the_last_part_s_unit(self) -> None:
        argv = ("--segment", "distance=10 m, friction=0.7", "--segment", "distance=0.1 m, friction=0.7")
        document = answer("skid", "speed", *argv, "--to", "total_distance=ft;in")
        bound = document["numerics"]["error_bound"]["total_distance"]
        assert bound.get("unit", "in") == "in"

    def test_subnormal_conversions_state_an_absolute_bound(self) -> None:
        bound = answer("convert", "1.05e-318 km", "m")["numerics"]["error_bound"]["value"]
        assert bound == {"absolute": 5e-324}


class TestFiles:
    def test_a_pipe_s_hash_is_of_what_was_read(self, tmp_path: Path) -> None:
        fifo = tmp_path / "pipe"
        os.mkfifo(fifo)
        data = b'{"distance": "60 ft", "friction": 0.7}'
        writer = threading.Thread(target=fifo.write_bytes, args=(data,))
        writer.start()
        document = answer("skid", "speed", "--input", str(fifo))
        writer.join()
        assert document["files"] == [{"name": str(fifo), "sha256": hashlib.sha256(data).hexdigest()}]

    def test_a_reference_cannot_read_standard_input(self) -> None:
        outcome = run("skid", "distance", "--speed", "@-:speed", "--friction", "0.7")
        assert outcome.status == 2
        assert "--input -" in outcome.err

    def test_links_and_modes_survive(self, tmp_path: Path) -> None:
        target, link = tmp_path / "real.txt", tmp_path / "link.txt"
        target.write_text("before")
        target.chmod(0o600)
        link.symlink_to(target)
        assert run(*OK, "--output", str(link)).status == 0
        assert link.is_symlink()
        assert target.read_text().startswith("speed  ")
        assert target.stat().st_mode & 0o777 == 0o600

    def test_a_name_that_is_not_utf_8(self, tmp_path: Path) -> None:
        name = os.fsdecode(os.fsencode(tmp_path) + b"/caf\xe9.json")
        Path(name).write_text('{"distance": "60 ft", "friction": 0.7}')
        document = answer("skid", "speed", "--input", name)
        assert document["files"][0]["name"].endswith("caf\\xe9.json")


class TestStreams:
    def test_a_closed_standard_output(self) -> None:
        done = shell("dynamics skid speed --distance '60 ft' --friction 0.7 >&-")
        assert done.returncode == 5
        assert "standard output is closed" in done.stderr

    def test_a_closed_standard_input(self) -> None:
        done = shell("dynamics skid speed --input - <&-")
        assert done.returncode == 2
        assert "standard input is closed" in done.stderr


class TestConvert:
    def test_weight_reads_the_target_as_what_it_becomes(self) -> None:
        document = answer("convert", "150 N", "lb", "--weight")
        assert document["results"]["value"]["value"] == pytest.approx(33.7213, abs=1e-4)
        assert document["inputs"]["gravity"] == {"value": 9.80665, "unit": "m/s²"}
        assert document["warnings"][0]["message"] == "lb read as pound-mass"

    def test_without_weight_gravity_is_nobody_s_business(self) -> None:
        assert "gravity" not in answer("convert", "60 mph", "ft/s", env={"DYNAMICS_GRAVITY": "nonsense"})["inputs"]

    def test_below_absolute_zero_from_a_scale_without_offset(self) -> None:
        assert run("convert", "-1", "K", "degC").status == 3

    def test_a_result_of_convert_is_converted_again(self) -> None:
        first = run("convert", "60 mph", "ft/s", "--json").out
        again = answer("convert", "--input", "-", "km/h", stdin=first)
        assert again["results"]["value"] == {"value": 96.56064, "unit": "km/h"}

    def test_reciprocal_units_are_words_of_their_own(self) -> None:
        assert answer("convert", "60", "1/in", "1/ft")["results"]["value"]["value"] == 720.0

    def test_two_readings_of_one_value_are_a_caution(self) -> None:
        warnings = answer("convert", "150 lb", "N", "kg")["warnings"]
        assert {warning["severity"] for warning in warnings} == {"caution"}

    def test_explanations_tell_input_from_result(self) -> None:
        explanation = answer("convert", "20 degC", "degF", "--explain")["explanation"]
        assert explanation["with_numbers"] == "(68.0 degF) = (20 degC)·9/5 + 32 (exactly 68)".replace("68.0", "68")

    def test_coordinates_take_the_unit_asked_for(self) -> None:
        argv = ("coords", "1", "1", "1", "--from", "cartesian", "--into", "cylindrical", "--to", "theta=rad")
        assert answer(*argv)["results"]["theta"] == {"value": pytest.approx(0.7853981633974483), "unit": "rad"}


class TestScenes:
    def test_default_units_of_two_kinds_stay_apart(self) -> None:
        scene = json.dumps({"units": {"length": "ft", "size": "mm"}, "distance": 60, "friction": 0.7})
        document = answer("skid", "speed", "--input", "-", stdin=scene)
        assert document["inputs"]["distance"] == {"value": 60, "unit": "ft"}

    def test_default_units_are_not_for_the_command_line(self) -> None:
        outcome = run(
            "skid", "speed", "--input", "-", "--distance", "60", stdin='{"units":{"length":"ft"},"friction":1}'
        )
        assert outcome.status == 2
        assert "has no unit" in outcome.err

    def test_a_wrong_default_unit_is_reported_once(self) -> None:
        outcome = run(
            "skid", "speed", "--input", "-", "--json", stdin='{"units":{"length":5},"distance":1,"friction":1}'
        )
        assert outcome.error["parameter"] == "units.length"

    def test_numbers_and_compound_units_must_match(self) -> None:
        scene = json.dumps({"distance": {"value": [5, 6, 7], "unit": "ft;in"}, "friction": 0.7})
        assert run("skid", "speed", "--input", "-", stdin=scene).status == 2


class TestErrors:
    def test_the_parameter_is_named_even_when_the_message_holds_its_name(self) -> None:
        assert run("skid", "speed", "--distance", "60 ft", "--friction", "x").err.startswith("dynamics: --friction: ")

    def test_an_explicit_format_decides_how_errors_go_out(self) -> None:
        outcome = run("skid", "speed", "--format", "table", env={"DYNAMICS_FORMAT": "json"})
        assert outcome.err.startswith("dynamics: ")

    def test_names_are_printed_without_control_characters(self) -> None:
        outcome = run("skid", "speed", "--input", "-", stdin='{"\\u001b[31mx": 1, "distance": "1 m", "friction": 1}')
        assert "\x1b" not in outcome.err

    def test_an_option_is_not_a_value(self) -> None:
        outcome = run(*OK, "--output", "--json")
        assert outcome.status == 2
        assert not Path("--json").exists()


class TestLimits:
    def test_a_limit_applies_to_the_first_result_of_its_kind(self) -> None:
        argv = ("--speed", "62 km/h", "--sight-distance", "32 m", "--reaction-time", "1.2 s", "--friction", "0.75")
        (limit,) = answer("skid", "avoid", *argv, "--limit", "50 km/h")["limits"]
        assert limit["result"] == "impact_speed"

    def test_a_result_without_a_value_is_told(self) -> None:
        assert "has no value here" in run(*OK, "--limit", "energy=5 kJ").err


class TestPython:
    def test_run_takes_the_universal_options_and_keywords(self) -> None:
        from dynamics_cli import run as answer_for

        document = answer_for("coords", first="3", second="1", third="4", from_="cartesian", into="spherical")
        assert document["results"]["rho"]["value"] == pytest.approx(26**0.5)  # type: ignore[index]
        document = answer_for("skid speed", distance="60 ft", friction=0.7, units="us", limit="50 mph")
        assert document["results"]["speed"]["unit"] == "mph"  # type: ignore[index]
        assert document["limits"]

    def test_a_slope_may_be_shown_as_any_angle_or_ratio(self, monkeypatch: pytest.MonkeyPatch) -> None:
        from dynamics_cli.core.units.display import Shown
        from dynamics_cli.quantities import Slope

        for unit, expected in (("%", 3.0), ("percent", 3.0), ("deg", 1.7183580016554572), ("grad", 1.909286668506)):
            assert Shown(Slope, unit).value(0.03) == pytest.approx(expected, rel=1e-12)  # type: ignore[arg-type]


MOMENTUM = (
    "impact momentum --axes compass --first-mass|3300 lb|--first-approach-heading|90 deg|--first-exit-speed|15 mph|"
    "--first-exit-heading|50 deg|--second-mass|2600 lb|--second-approach-heading|330 deg|--second-exit-speed|12 mph|"
    "--second-exit-heading|20 deg"
)


def test_momentum_is_explained_with_its_masses_and_the_condition_it_calculates() -> None:
    first, *rest = MOMENTUM.split("|")
    document = answer(*first.split(), *rest, "--explain")
    shown = document["explanation"]["with_numbers"]
    assert "(3300 lb)·(15 mph)" in shown
    assert "(2600 lb)·(12 mph)" in shown
    assert "m₁" not in shown
    # 120° between the lines of approach: they are as far from square as at 60°
    assert document["results"]["angle_condition"]["value"] == pytest.approx(3.0**0.5)
    assert shown.endswith("1.73205 = (1 + |cos((330 deg) − (90 deg))|)/|sin((330 deg) − (90 deg))|")


def test_inputs_that_do_not_matter_are_not_listed_with_rounding() -> None:
    first, *rest = MOMENTUM.split("|")
    changes = answer(*first.split(), *rest, "--explain")["explanation"]["sensitivity"]
    assert min(abs(change) for entry in changes.values() for change in entry.values()) > 1e-9


def test_a_formula_with_nothing_to_fill_is_shown_once() -> None:
    program = "rise 20 mm in 90 deg; dwell 60 deg; return in 90 deg; dwell"
    sizes = ("--roller-radius", "8 mm", "--base-radius", "40 mm")
    shown = answer("cam", "profile", "--program", program, "--follower", "roller", *sizes, "--explain")["explanation"]
    assert "formula" in shown
    assert "with_numbers" not in shown


def test_a_reference_to_no_result_names_those_there_are(tmp_path: Path) -> None:
    file = tmp_path / "a.json"
    file.write_text(run("skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--json").out)
    call = ("skid", "speed", "--friction", "0.7", "--json", "--distance")
    assert run(*call, f"@{file}:sped").error["hint"] == "did you mean speed?"
    assert run(*call, f"@{file}:nothing").error["hint"] == "there is speed, time, total_distance"
    file.write_text('{"a": 1}')
    assert "a result document is wanted" in run(*call, f"@{file}:a").error["hint"]


def test_schema_says_what_is_missing_and_suggests_near_tasks() -> None:
    assert "the task of gear is missing" in run("schema", "gear").err
    assert "did you mean dynamics gear crossed?" in run("schema", "gear", "crosed").err


@pytest.mark.parametrize(("name", "near"), [("stel", "there is steel"), ("alminium", "there is aluminium")])
def test_a_material_that_is_none_suggests_near_ones(name: str, near: str) -> None:
    call = ("inertia", "shape", "cylinder", "--radius", "1 in", "--length", "2 in", "--json")
    assert run(*call, "--material", name).error["hint"].startswith(near)


def test_numbers_between_brackets_have_no_more_of_them() -> None:
    sizes = ("--first-teeth", "20", "--second-teeth", "40", "--module", "3 mm", "--face-width", "20 mm")
    shown = answer("gear", "bevel", *sizes, "--explain")["explanation"]["with_numbers"]
    assert shown.startswith("(26.5651 deg) = atan2(sin(90 deg), 2 + cos(90 deg))")


def test_the_drag_factor_of_axles_is_explained_by_the_formula_it_follows() -> None:
    sizes = ("--wheelbase", "9 ft", "--cm-position", "4 ft", "--cm-height", "2 ft", "--rear-braking", "50 %")
    document = answer("skid", "drag-factor", "--front-friction", "0.7", "--rear-friction", "0.6", *sizes, "--explain")
    # (0.7·5 + 0.3·4)/(9 + 2·(0.3 − 0.7))
    assert document["results"]["effective_friction"]["value"] == pytest.approx(4.7 / 8.2, rel=1e-14)
    assert "·((9 ft) − (4 ft)) + 0.6·(50 %)·(4 ft))/((9 ft) + (2 ft)·(" in document["explanation"]["with_numbers"]


def test_files_may_write_names_as_options_do(tmp_path: Path) -> None:
    scene = tmp_path / "skid.toml"
    scene.write_text('distance = "60 ft"\nfriction = 0.7\nend-speed = "10 mph"\n')
    results = answer("skid", "speed", "--input", str(scene))["results"]
    call = ("skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--end-speed", "10 mph")
    assert results == answer(*call)["results"]
    scene.write_text('distance = "60 ft"\nfriction = 0.7\nend-sped = "10 mph"\n')
    assert "'end-sped'" in run("skid", "speed", "--input", str(scene)).err
    scene.write_text('distance = "60 ft"\nfriction = 0.7\nend-speed = "10 mph"\nend_speed = "9 mph"\n')
    assert run("skid", "speed", "--input", str(scene)).status == 2
