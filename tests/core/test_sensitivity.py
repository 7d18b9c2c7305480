"""The table of sensitivities that `--explain` prints."""

from dynamics_cli.core.output.sensitivity import sensitivity_lines
from tests.harness import answer, run

CHANGES = {"speed": {"distance": 0.5, "first_mass": -0.25}, "time": {"first_mass": 1.0 / 3.0}}


def lines(width: int) -> list[str]:
    return sensitivity_lines(CHANGES, str.capitalize, lambda name: name.replace("_", " "), width)


def test_a_line_for_each_result_and_a_column_for_each_input() -> None:
    assert lines(80) == [
        "sensitivity: change in % for +1 % of",
        "                    first",
        "         distance    mass",
        "  Speed       0.5   -0.25",
        "  Time              0.333",
    ]


def test_columns_that_do_not_fit_follow_below() -> None:
    assert lines(20) == [
        "sensitivity: change in % for +1 % of",
        "         distance",
        "  Speed       0.5",
        "          first",
        "           mass",
        "  Speed   -0.25",
        "  Time    0.333",
    ]
    assert sensitivity_lines({}, str, str, 80) == []


def test_the_document_carries_every_digit() -> None:
    call = ("skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--explain")
    assert answer(*call)["explanation"]["sensitivity"]["time"] == {"distance": 0.5, "friction": -0.5, "gravity": -0.5}
    assert ["time", "0.5", "-0.5", "-0.5"] in [line.split() for line in run(*call).out.splitlines()]
