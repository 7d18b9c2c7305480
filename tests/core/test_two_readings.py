"""Text that may mean two things is refused, with both ways to write it; short forms mean the same everywhere."""

import json

import pytest

from tests.harness import answer, run

BEAM = ("force", "equilibrium", "--load", "500 N down at 2 m", "--support", "pin at 0 m", "--support", "roller at 6 m")


@pytest.mark.parametrize(
    "vector",
    ["1 500 N", "10 000 N", "1,000 N", "1,500 N", "1 000 000 N", "5 ft, 6 in", "10k N", "3 k"],
)
def test_a_vector_that_may_be_one_number_is_refused(vector: str) -> None:
    outcome = run("vec", "resultant", vector, "--json")
    assert outcome.status == 2
    assert vector.partition(" N")[0] in outcome.error["message"]


@pytest.mark.parametrize("vector", ["100, 200 N", "(100,200) N", "0 500 N", "100 200 300 N", "100,200,300 N"])
def test_components_that_can_be_nothing_else_are_read(vector: str) -> None:
    assert run("vec", "resultant", vector).status == 0


def test_brackets_within_unit_vectors_are_not_dropped() -> None:
    for force in ("-(3i + 4j) N", "3(i + j) N"):
        assert run("force", "resultant", "--load", f"force={force}, at=0 m").status == 2
    loads = answer("force", "resultant", "--load", "force=(-3i - 4j) N, at=0 m")["inputs"]["loads"]
    assert loads[0]["force"]["value"] == [-3, -4]


@pytest.mark.parametrize("place", ["1 500 mm", "1,500 mm", "10 000 mm", "5 ft, 6 in"])
def test_a_place_along_x_is_not_taken_for_two_coordinates(place: str) -> None:
    for load in (f"500 N down at {place}", f"force=0, -500 N, at={place}"):
        error = run("force", "resultant", "--load", load, "--json").error
        assert (error["code"], error["parameter"]) == ("ambiguous", "loads[0].at")


@pytest.mark.parametrize("distances", ["1 500, 2 000 mm", "10 000 mm", "5 ft, 6 in"])
def test_lists_that_may_be_one_number_are_refused(distances: str) -> None:
    from dynamics_cli import quantities as q
    from dynamics_cli.core.inputs.forms.lists import split_items
    from dynamics_cli.core.inputs.specification import Leaf, Many
    from dynamics_cli.errors import UsageError

    with pytest.raises(UsageError, match="may be one"):
        split_items(Many(Leaf(q.Length)), distances)


@pytest.mark.parametrize(
    ("load", "place"),
    [
        ("20 N at 30 deg at 2 m", [2, 0, 0]),
        ("20 N @ 30 deg at 2, 1 m", [2, 1, 0]),
        ("20 N along 3, 4 at 2 m", [2, 0, 0]),
    ],
)
def test_the_last_at_is_the_place(load: str, place: list[float]) -> None:
    assert answer("force", "resultant", "--load", load)["inputs"]["loads"][0]["at"]["value"] == place


def test_a_direction_by_an_angle_is_refused_without_an_internal_error() -> None:
    outcome = run(*BEAM[:-1], "roller at 6 m, direction=90 deg", "--json")
    assert outcome.status == 2 or outcome.error["code"] == "kind"


@pytest.mark.parametrize("name", ["supports[1].at", "loads[0].at"])
def test_a_sweep_reaches_into_parts_that_begin_with_their_value(name: str) -> None:
    swept = answer(*BEAM, "--sweep", f"{name}=3:5 m:3")["results"]["sweep"]["largest"]["value"]
    for place, largest in zip((3, 4, 5), swept, strict=True):
        load = f"500 N down at {place if name[0] == 'l' else 2} m"
        roller = f"roller at {place if name[0] == 's' else 6} m"
        one = answer("force", "equilibrium", "--load", load, "--support", "pin at 0 m", "--support", roller)
        assert one["results"]["largest"]["value"] == largest


@pytest.mark.parametrize("unit", ["^2 ft", "½ ft"])
def test_a_unit_that_would_join_the_number_is_refused(unit: str) -> None:
    row = json.dumps({"distance": {"value": 10, "unit": unit}, "friction": 0.7})
    assert run("skid", "speed", "--rows", "-", stdin=row).status == 4


@pytest.mark.parametrize(("option", "text"), [("--restitution", "1.2 ± 5 %"), ("--height", "1 m ± 5 % ft")])
def test_a_share_that_may_be_a_difference_is_refused(option: str, text: str) -> None:
    options = {"--height": "1 m", "--restitution": "0.5", option: text}
    words = [word for pair in options.items() for word in pair]
    assert run("impact", "drop", *words, "--json").error["code"] == "ambiguous"
    options["--restitution"], options["--height"] = "70 ± 5 %", "1 m"
    assert run("impact", "drop", *[word for pair in options.items() for word in pair]).status == 0


def test_names_with_braces_are_written_as_they_are() -> None:
    mesh = ("--mesh", "first={a}, second={b}, first-teeth=20, second-teeth=40")
    outcome = run("gear", "train", *mesh, "--driver", "{a}", "--driven", "{b}", "--fixed", "{b}", "--json")
    assert outcome.error["hint"] == "release {b}"


def test_an_angle_does_not_take_the_unit_of_a_length() -> None:
    error = run("coords", "3", "30", "2 m", "--from", "cyl", "--into", "xyz", "--json").error
    assert error["message"] == "theta is an angle and has no unit"


@pytest.mark.parametrize(
    ("text", "why"), [("80 % kg", "a percentage"), ("2 kg %", "a percentage"), ("5 m, 6 in", "one value or two")]
)
def test_a_share_of_a_unit_and_parts_that_do_not_divide_are_refused(text: str, why: str) -> None:
    outcome = run("convert", text, "m" if "m," in text else "kg")
    assert (outcome.status, why in outcome.err) == (2, True)


def test_parts_after_a_comma_and_percent_per_time_are_read() -> None:
    for text, unit, value in (("5 ft, 6 in", "in", 66.0), ("2 h, 30 min", "min", 150.0), ("5 %/s", "1/s", 0.05)):
        assert answer("convert", text, unit)["results"]["value"]["value"] == value
