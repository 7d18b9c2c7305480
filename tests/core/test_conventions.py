"""Each convention of signatures, proved on a small task through the command line, JSON and both routes."""

import json
import math
from pathlib import Path

import pytest
from harness import answer, run

from dynamics_cli.core.inputs.specification import Field, SpecificationError, interpret
from dynamics_cli.quantities import Length
from dynamics_cli.records import record

pytestmark = pytest.mark.usefixtures("toy")


def value(document: dict, name: str) -> object:
    return document["results"][name]["value"]


@record
class Turned:
    """Fields in an order that is not that of the alphabet."""

    turn_axis: Length
    turn_angle: Length
    euler: Length
    order: Length


@record
class Turning:
    """Another."""

    speed: Length
    axis: Length


class TestCommandLine:
    def test_all_the_rest_are_options_and_a_trailing_underscore_is_dropped(self) -> None:
        document = answer("toy", "arc", "--radius", "2 m", "--from", "0.5 rad", "--upto", "1.5 rad")
        assert value(document, "value") == 2.0
        assert document["inputs"]["from"] == {"value": 0.5, "unit": "rad"}

    def test_flags_choices_ratios_and_text(self) -> None:
        argv = ("--law", "harmonic", "--note", "hello", "--teeth", "365.2422/27.3217", "--loud")
        assert answer("toy", "say", *argv)["results"]["said"].startswith("MODIFIED-SINE HELLO (")

    def test_a_range_of_whole_numbers(self) -> None:
        document = answer("toy", "say", "--law", "linear", "--times", "12..120")
        assert document["results"]["said"] == "linear  None (12, 120)"
        assert document["inputs"]["times"] == "12..120"
        again = run("toy", "say", "--input", "-", "--json", stdin='{"law": "linear", "times": [12, 120]}')
        assert again.document["results"] == document["results"]

    @pytest.mark.parametrize("text", ["12", "12..", "2..1", "1.5..2", "1..2..3", "-1..2"])
    def test_what_is_no_range_is_refused(self, text: str) -> None:
        outcome = run("toy", "say", "--law", "linear", "--times", text, "--json")
        assert outcome.status == 2
        assert outcome.error["parameter"] == "times"

    @pytest.mark.parametrize("law", ["Modified Sine", "modified_sine", "MODIFIED-SINE"])
    def test_a_choice_is_read_in_any_case_and_with_any_joint(self, law: str) -> None:
        assert answer("toy", "say", "--law", law)["results"]["said"].startswith("modified-sine")

    def test_an_unknown_choice_names_those_there_are(self) -> None:
        outcome = run("toy", "say", "--law", "linnear", "--json")
        assert outcome.status == 2
        assert "linear" in outcome.error["message"]
        assert "did you mean linear" in outcome.error["hint"]


class TestAlternatives:
    def test_the_names_given_choose(self) -> None:
        by_radius = answer("toy", "arc", "--radius", "5 m", "--upto", "1 rad")
        by_chord = answer("toy", "arc", "--chord", "8 m", "--ordinate", "2 m", "--upto", "1 rad")
        assert value(by_radius, "value") == value(by_chord, "value") == 5.0

    def test_two_alternatives_at_once_are_an_error_that_names_both(self) -> None:
        outcome = run("toy", "arc", "--radius", "5 m", "--chord", "8 m", "--upto", "1 rad", "--json")
        assert outcome.status == 2
        assert outcome.error["code"] == "exclusive"
        assert "radius" in outcome.error["message"]
        assert "chord" in outcome.error["message"]

    def test_none_of_them_is_an_error_that_names_all(self) -> None:
        outcome = run("toy", "arc", "--upto", "1 rad", "--json")
        assert outcome.error["message"] == "one of these is missing: --radius, or --chord and --ordinate"

    def test_half_of_one_says_what_is_missing(self) -> None:
        outcome = run("toy", "arc", "--chord", "8 m", "--upto", "1 rad", "--json")
        assert outcome.error["parameter"] == "ordinate"

    def test_alternatives_that_cannot_be_told_apart_are_refused_when_registered(self) -> None:
        @record
        class Same:
            radius: Length

        @record
        class Other:
            radius: Length
            more: Length = 0.0

        with pytest.raises(SpecificationError, match="distinguished"):
            interpret(Same | Other, {})

    def test_keys_stand_in_the_order_of_the_fields(self) -> None:
        node = interpret(Turned | Turning, {})
        assert Field("pose", node, None).spread() == ("turn_axis", "turn_angle", "euler", "order", "speed", "axis")


class TestGroups:
    def test_one_by_plain_fields(self) -> None:
        document = answer("toy", "journey", "--distance", "10 m")
        assert value(document, "total") == 10.0
        assert document["inputs"] == {"distance": {"value": 10, "unit": "m"}}

    def test_several_by_a_repeated_option_named_after_the_record(self) -> None:
        argv = ("--stretch", "distance=10 m, friction=0.5", "--stretch", "distance=5 m")
        document = answer("toy", "journey", *argv)
        assert value(document, "total") == 15.0
        assert [row["work"]["value"] for row in document["results"]["rows"]] == [5.0, 3.5]

    def test_several_as_a_list_in_json(self) -> None:
        scene = {"stretches": [{"distance": "10 m"}, {"distance": {"value": 5, "unit": "m"}}]}
        assert value(answer("toy", "journey", "--input", "-", stdin=json.dumps(scene)), "total") == 15.0

    def test_both_ways_at_once_are_refused(self) -> None:
        outcome = run("toy", "journey", "--distance", "1 m", "--stretch", "distance=5 m", "--json")
        assert outcome.error["code"] == "exclusive"

    def test_a_nested_record_prefixes_its_fields(self) -> None:
        argv = ("--first-mass", "1 kg", "--first-velocity", "3, 0 m/s", "--second-mass", "2 kg")
        document = answer("toy", "pair", *argv, "--second-velocity", "6, 3 m/s", "--units", "base")
        assert value(document, "velocity") == [5.0, 2.0]

    def test_lists_of_quantities_share_the_last_unit(self) -> None:
        document = answer("toy", "mean", "--torques", "1, 2, 6 N*m", "--side", "2 mm")
        assert value(document, "torque") == 3.0


class TestAddresses:
    def test_errors_name_the_address(self) -> None:
        scene = {"stretches": [{"distance": "10 m"}, {"distance": "5 kg"}]}
        outcome = run("toy", "journey", "--input", "-", "--json", stdin=json.dumps(scene))
        assert outcome.error["parameter"] == "stretches[1].distance"

    def test_condition_numbers_name_the_address(self) -> None:
        argv = ("--first-mass", "1 kg", "--first-velocity", "3, 0 m/s", "--second-mass", "2 kg")
        document = answer("toy", "pair", *argv, "--second-velocity", "6, 3 m/s")
        condition = document["numerics"]["condition"]["mass"]
        assert condition["first.mass"] == pytest.approx(1 / 3, rel=1e-5)
        assert "second.velocity[1]" in condition

    def test_to_names_the_address(self) -> None:
        document = answer("toy", "journey", "--distance", "10 m", "--to", "rows.distance=ft")
        assert document["results"]["rows"][0]["distance"]["unit"] == "ft"
        assert document["results"]["total"]["unit"] == "m"


class TestScenes:
    def test_a_tagged_union_serves_words_and_files(self, tmp_path: Path) -> None:
        by_word = answer("toy", "volume", "ball", "--radius", "10 mm", "--units", "base")
        scene = tmp_path / "scene.toml"
        scene.write_text('shape = "ball"\nradius = "10 mm"\n')
        by_file = answer("toy", "assembly", str(scene), "--units", "base")
        assert value(by_word, "volume") == value(by_file, "volume") == pytest.approx(4e-6)

    def test_a_field_of_another_shape_is_refused(self) -> None:
        outcome = run("toy", "volume", "ball", "--radius", "1 mm", "--length", "2 mm", "--json")
        assert outcome.status == 2
        assert outcome.error["parameter"] == "length"

    def test_an_unknown_shape_suggests(self) -> None:
        assert "cylinder" in run("toy", "volume", "cilinder", "--json").error["hint"]

    def test_recursion_and_default_units(self, tmp_path: Path) -> None:
        scene = tmp_path / "scene.toml"
        scene.write_text(
            '[units]\nsize = "mm"\n[[parts]]\nshape = "ball"\nradius = 10\n'
            '[[parts]]\n[[parts.parts]]\nshape = "cylinder"\nradius = "1 cm"\nlength = 20\nposition = "1, 2, 3 m"\n'
        )
        document = answer("toy", "assembly", str(scene), "--units", "base")
        assert value(document, "count") == 2
        assert value(document, "volume") == pytest.approx(4e-6 + 6e-6)
        assert document["files"][0]["sha256"]

    def test_default_units_must_be_units_of_a_kind(self) -> None:
        scene = json.dumps({"units": {"size": "kg"}, "shape": "ball", "radius": 1})
        outcome = run("toy", "assembly", "--input", "-", "--json", stdin=scene)
        assert outcome.error["parameter"] == "units.size"

    def test_files_named_in_a_scene_are_found_beside_it(self, tmp_path: Path) -> None:
        (tmp_path / "part.stl").write_text("solid")
        scene = tmp_path / "scene.json"
        scene.write_text('{"law": "linear", "file": "part.stl"}')
        document = answer("toy", "say", "--input", str(scene))
        assert document["results"]["said"].endswith("part.stl")
        assert len(document["files"]) == 2


class TestVectorsAndTensors:
    def test_a_planar_vector_by_magnitude_and_direction(self) -> None:
        argv = ("--first-mass", "1 kg", "--first-velocity", "10 m/s @ 90 deg", "--second-mass", "1 kg")
        document = answer("toy", "pair", *argv, "--second-velocity", "4, 0 m/s", "--units", "base")
        assert value(document, "velocity") == pytest.approx([2.0, 5.0])

    @pytest.mark.parametrize(
        "text",
        [
            "[[2, 1, 0], [1, 3, 0], [0, 0, 4]] kg*m^2",
            "2, 3, 4, 1, 0, 0 kg*m^2",
            '{"moments": "2, 3, 4 kg*m^2", "products": "1, 0, 0 kg*m^2"}',
        ],
    )
    def test_a_tensor_in_every_form(self, text: str) -> None:
        scene = {"tensor": json.loads(text) if text.startswith("{") else text, "axis": "1, 1, 0 m"}
        document = answer("toy", "spin", "--input", "-", stdin=json.dumps(scene))
        assert value(document, "moment") == pytest.approx(3.5)

    def test_a_tensor_that_is_not_symmetric_is_refused(self) -> None:
        argv = ("--tensor", "[[2, 1, 0], [0, 3, 0], [0, 0, 4]] kg*m^2", "--axis", "1, 0, 0 m")
        assert "not symmetric" in run("toy", "spin", *argv, "--json").error["message"]

    @pytest.mark.parametrize("text", ["1 2 -3 m", "(1 2 -3 m)", "[1  2  -3 m]"])
    def test_spaces_alone_separate_numbers_before_one_unit(self, text: str) -> None:
        scene = {"tensor": "1, 2, 3 kg*m^2", "axis": text}
        spaced = answer("toy", "spin", "--input", "-", stdin=json.dumps(scene))
        commas = answer("toy", "spin", "--input", "-", stdin=json.dumps(scene | {"axis": "1, 2, -3 m"}))
        assert spaced["results"] == commas["results"]

    @pytest.mark.parametrize("text", ["1 2 1/2 m", "1 m 2 m 3 m", "1 2 3 ± 0.1 m"])
    def test_spaces_do_not_separate_fractions_or_numbers_with_units(self, text: str) -> None:
        assert run("toy", "spin", "--tensor", "1, 2, 3 kg*m^2", "--axis", text, "--json").status == 2

    def test_the_number_of_components_is_checked(self) -> None:
        argv = ("--tensor", "1, 2, 3 kg*m^2", "--axis", "1, 0, 0, 0 m")
        assert "read 4 components, wanted 2 or 3" in run("toy", "spin", *argv, "--json").error["message"]

    @pytest.mark.parametrize("axis", ["1, 2 m", '{"value": [1, 2], "unit": "m"}', '["1 m", "2 m"]', "100, 200 cm"])
    def test_a_vector_in_the_plane_has_no_z(self, axis: str) -> None:
        whole, planar = (
            answer("toy", "spin", "--input", "-", stdin=json.dumps({"tensor": "1, 2, 3 kg*m^2", "axis": one}))
            for one in ("1, 2, 0 m", axis if axis[0] not in "[{" else json.loads(axis))
        )
        assert planar["results"] == whole["results"]


class TestTables:
    def test_columns_stand_under_one_unit_and_csv_writes_the_table_asked_for(self) -> None:
        document = answer("toy", "curve", "--lift", "20 mm", "--count", "3")
        assert document["results"]["points"]["lift"] == {"value": [0.0, 10.0, 20.0], "unit": "mm"}
        out = run("toy", "curve", "--lift", "20 mm", "--count", "2", "--format", "csv", "--table", "points").out
        assert out.splitlines()[0] == "angle[deg],lift[mm]"
        assert len(out.splitlines()) == 3

    def test_few_rows_are_objects(self) -> None:
        out = run("toy", "journey", "--distance", "10 m", "--format", "csv", "--table", "rows").out
        assert out == "distance[m],work\n10.0,7.0\n"

    def test_checks_advice_and_stated_bounds_reach_the_document(self) -> None:
        document = answer("toy", "curve", "--lift", "20 mm")
        assert document["checks"][0]["passed"]
        assert document["warnings"][0]["remedy"] == "raise the span to 114.592 deg"
        assert document["numerics"]["method"] == "sampling"
        assert document["numerics"]["error_bound"]["peak"]["relative"] >= 1e-15


class TestRefusal:
    def test_a_condition_refuses_a_scalar_with_its_number(self) -> None:
        outcome = run("toy", "fall", "--height", "-2 m", "--json")
        assert outcome.status == 3
        assert outcome.error["message"] == "the height -2 m is not above zero"
        assert outcome.error["code"] == "no-height"

    def test_an_overflow_is_refused(self) -> None:
        outcome = run("toy", "fall", "--height", "1 m", "--speed-before", "1e300 m/s", "--json")
        assert outcome.status == 3
        assert "range of a double" in outcome.error["message"]


class TestConditioning:
    def test_the_tracked_answer_is_the_plain_answer_and_its_bound_is_stated(self) -> None:
        document = answer("toy", "fall", "--height", "3 m", "--speed-before", "4 m/s", "--units", "base")
        assert value(document, "speed") == math.sqrt(2.0 * 9.8 * 3.0 + 16.0)
        assert 1e-16 < document["numerics"]["error_bound"]["speed"]["relative"] < 1e-15
        assert document["numerics"]["condition"]["speed"]["height"] == pytest.approx(0.5 * 58.8 / 74.8, rel=1e-5)


class TestSmallestModel:
    def test_the_first_that_suffices_answers_and_says_why(self) -> None:
        document = answer("toy", "fall", "--height", "3 m")
        assert document["model"]["name"] == "model standing"
        assert document["model"]["why"] == "it starts from rest"

    def test_the_larger_where_it_is_needed(self) -> None:
        document = answer("toy", "fall", "--height", "3 m", "--speed-before", "1 m/s")
        assert document["model"]["name"] == "model fall"

    def test_model_overrules(self) -> None:
        document = answer("toy", "fall", "--height", "3 m", "--model", "model-fall")
        assert document["model"]["why"] == "asked for"

    def test_an_unknown_model_is_refused(self) -> None:
        outcome = run("toy", "fall", "--height", "3 m", "--model", "big", "--json")
        assert outcome.error["hint"] == "there is model-standing, model-fall"


class TestReserved:
    def test_a_parameter_may_not_take_the_name_of_a_universal_option(self) -> None:
        import toys

        from dynamics_cli.core.answering.task import Model, Task

        def clash(*, output: Length) -> toys.One:
            return toys.One(output)

        toys.clash = clash
        with pytest.raises(SpecificationError, match="output"):
            _ = Task("clash", "", Model("m", "toys:clash", source="")).specification


@pytest.mark.parametrize(
    "argv",
    [
        ("toy", "arc", "--radius", "2 m", "--upto", "1.5 rad"),
        ("toy", "journey", "--stretch", "distance=10 m", "--stretch", "distance=3 ft"),
        ("toy", "volume", "ball", "--radius", "10 mm", "--format", "markdown"),
        ("toy", "fall", "--height", "3 m", "--explain"),
        ("toy", "say", "--law", "linear", "--loud"),
        ("toy", "fall", "--height", "-3 m"),
    ],
)
def test_both_routes_are_byte_identical(argv: tuple[str, ...]) -> None:
    assert run(*argv) == run(*argv, route="tree")


class TestScenesByOptions:
    def test_a_scene_needs_no_file(self) -> None:
        document = answer("toy", "assembly", "--shape", "ball", "--radius", "2 m")
        assert document["results"]["volume"] == {"value": 32e9, "unit": "mm³"}

    def test_options_stand_over_the_file(self, tmp_path: Path) -> None:
        scene = tmp_path / "scene.toml"
        scene.write_text('shape = "ball"\nradius = "2 m"\n')
        assert value(answer("toy", "assembly", str(scene)), "volume") == 32e9
        assert value(answer("toy", "assembly", str(scene), "--radius", "1 m"), "volume") == 4e9

    def test_its_options_are_those_of_its_fields_once(self) -> None:
        from dynamics_cli import cli

        names = list(cli.family("toy").tasks["assembly"].options)
        assert "position" in names
        assert "radius" in names


class TestFilesThatAFamilyReads:
    @pytest.mark.parametrize("size", [10, (1 << 24) + 5])
    def test_are_named_with_their_hash_large_or_small(self, tmp_path: Path, size: int) -> None:
        import hashlib

        file = tmp_path / "part.stl"
        file.write_bytes(b"x" * size)
        document = answer("toy", "say", "--law", "linear", "--file", str(file))
        assert document["files"] == [{"name": str(file), "sha256": hashlib.sha256(b"x" * size).hexdigest()}]

    def test_of_every_point_of_a_sweep_once(self, tmp_path: Path) -> None:
        file = tmp_path / "part.stl"
        file.write_bytes(b"x" * ((1 << 24) + 5))
        outcome = run("toy", "say", "--law", "linear", "--file", str(file), "--times", "1..2", "--json")
        assert len(outcome.document["files"]) == 1


class TestSchemas:
    def test_a_ratio_may_be_text_or_as_a_document_writes_it(self) -> None:
        import jsonschema

        from dynamics_cli import cli
        from dynamics_cli.core.command.schema import schema

        inputs = schema(cli.family("toy").tasks["say"])["properties"]["inputs"]["properties"]["teeth"]
        for value in ("365.2422/27.3217", {"value": "365.2422/27.3217"}):
            jsonschema.validate(value, inputs)
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(1.5, inputs)


class TestStatedBounds:
    def test_absolute_ones_are_shown_in_the_unit_of_their_result(self) -> None:
        from dynamics_cli.core.output.document import _stated_bound, _Walk
        from dynamics_cli.core.units.display import Display
        from dynamics_cli.quantities import Size
        from dynamics_cli.records import ErrorBound

        walk = _Walk(Display("si", {}), None)  # type: ignore[arg-type]
        walk._scalar(0.012, Size, "width", table=True)  # type: ignore[arg-type]
        assert _stated_bound(walk, ErrorBound("width", 1e-9, relative=False)) == {"absolute": 1.1e-6, "unit": "mm"}
        assert _stated_bound(walk, ErrorBound("width", 1e-9)) == {"relative": 1.1e-9}
        assert _stated_bound(walk, ErrorBound("width", 0.0)) == {"relative": 1.2e-16}
        assert _stated_bound(walk, ErrorBound("other", 1e-9, relative=False)) == {"absolute": 1.1e-9}


def test_scenes_nested_beyond_reason_are_refused(tmp_path: Path) -> None:
    scene = tmp_path / "deep.json"
    scene.write_text('{"parts": [' * 400 + '{"shape": "ball", "radius": "1 m"}' + "]}" * 400)
    outcome = run("toy", "assembly", str(scene), "--json")
    assert (outcome.status, outcome.error["code"]) == (2, "nested")
