"""Refusals and advice speak in the units that the inputs were written in."""

import json
import re
import shlex

import pytest
from harness import answer, run

from dynamics_cli.core.answering.messages import in_written_units
from dynamics_cli.core.inputs.values import Fields, Several, Value
from dynamics_cli.core.output.failure import error_text
from dynamics_cli.errors import InadmissibleError, UsageError, require, worded
from dynamics_cli.quantities import Angle, Distance, Friction, Mass, RoadSpeed

MILE = 0.44704


def inputs(*values: Value) -> Fields:
    return Fields(None, {"group": Several(list(values))})


FEET = Value("distance", Distance, 18.288, 60.0, "ft")
MPH = Value("speed", RoadSpeed, 30 * MILE, 30, "mph")
MILLIMETRES = Value("lift", Distance, 0.015, 15, "mm")
METRES = Value("distance", Distance, 0.25, 0.25, "m")
DEGREES = Value("angle", Angle, 0.3490658503988659, 20, "deg")
MINUTES = Value("angle", Angle, 0.35779249665883756, 1230, "arcmin")
RADIANS = Value("angle", Angle, -0.349066, -0.349066, "rad")
QUARTER = Value("distance", Distance, 0.25, 250, "mm")
POUNDS = Value("mass", Mass, 0.90718474, 2, "lb")


HELIX = worded("the helix of {angle:6} cancels", angle=(0.357792496658836, Angle))


@pytest.mark.parametrize(
    ("text", "values", "wanted"),
    [
        (worded("a mark of {x} is long", x=(18.288, Distance)), (FEET,), "a mark of 60 ft is long"),
        (worded("it turned {x:2}", x=(3.3, Angle)), (DEGREES,), "it turned 190 deg"),
        (worded("it stops after {x}", x=(13.1, Distance)), (FEET, MPH), "it stops after 42.98 ft"),
        (worded("it stops after {x:6}", x=(13.1, Distance)), (FEET,), "it stops after 42.979 ft"),
        (worded("{x} of {y}", x=(0.0125, Distance), y=(0.015, Distance)), (MILLIMETRES,), "12.5 mm of 15 mm"),
        (worded("{x}", x=(0.25, Distance)), (QUARTER, METRES), "250 mm"),
        (worded("a mass of {m}", m=(0.90718474, Mass)), (POUNDS,), "a mass of 2 lb"),
        (worded("it turns by {a}", a=(0.7853981633974483, Angle)), (), "it turns by 45 deg"),
        (worded("it turns by {a}", a=(0.5, Angle)), (Value("angle", Angle, 0.5, 0.5, "rad"),), "it turns by 0.5 rad"),
        (HELIX, (MINUTES,), "the helix of 20.5 deg cancels"),
        (worded("the helix {a}", a=(-0.349066, Angle)), (DEGREES, RADIANS), "the helix -0.349066 rad"),
        (worded("friction {f} may be", f=(0.7, Friction)), (FEET,), "friction 0.7 may be"),
        (worded("{where} 3 m", where="18.288 m:"), (FEET,), "18.288 m: 3 m"),
        ("such as rise 20 mm in 18.288 m", (FEET,), "such as rise 20 mm in 18.288 m"),
    ],
)
def test_values_in_messages(text, values, wanted) -> None:
    assert in_written_units(text, inputs(*values)) == wanted


def test_refusals_quote_what_was_written() -> None:
    call = ("skid", "distance", "--speed", "30 mph", "--end-speed", "40 mph", "--friction", "0.7", "--json")
    outcome = run(*call)
    assert outcome.status == 3
    assert outcome.error["message"].startswith("the end speed of 40 mph exceeds the speed of 30 mph")


def test_advice_quotes_what_was_written() -> None:
    call = ("skid", "yaw", "--chord", "60 ft", "--middle-ordinate", "1 in", "--friction", "0.7")
    assert "the middle ordinate of 1 in" in answer(*call)["warnings"][0]["message"]


def test_advice_speaks_in_the_units_of_the_answer() -> None:
    call = ["impact", "momentum", "--first-mass", "8000 kg", "--first-approach-heading", "0 deg", "--first-exit-speed",
            "15 m/s", "--first-exit-heading", "2 deg", "--second-mass", "300 kg", "--second-approach-heading",
            "90 deg", "--second-exit-speed", "14 m/s", "--second-exit-heading", "10 deg"]  # fmt: skip
    for units, change in ((), "26 km/h"), (("--units", "us"), "16.1 mph"), (("--units", "base"), "7.22 m/s"):
        assert f"changes it by {change}" in answer(*call, *units)["warnings"][0]["message"]


def test_rows_quote_what_was_written() -> None:
    rows = "speed[mph],end_speed[mph],friction\n30,40,0.7\n"
    outcome = run("skid", "distance", "--rows", "-", "--format", "ndjson", stdin=rows)
    assert "the end speed of 40 mph exceeds the speed of 30 mph" in json.loads(outcome.out)["error"]["message"]


def test_numbers_that_share_a_unit_are_all_turned() -> None:
    helices = ("--first-helix-angle", "20 deg", "--second-helix-angle", "-20 deg")
    teeth = ("--first-teeth", "15", "--second-teeth", "20", "--module", "3 mm")
    outcome = run("gear", "crossed", *teeth, *helices, "--json")
    assert outcome.error["message"].startswith("the helices 20 deg and -20 deg cancel")
    outcome = run("inertia", "tensor", "--moments", "1, 2, 3.5 lb*ft^2", "--json")
    assert "3.5 lb·ft² exceeds the sum of 1 lb·ft² and 2 lb·ft² by 0.143 of it" in outcome.error["message"]


def test_modules_of_a_series_stay_in_millimetres() -> None:
    warning = answer("gear", "spur", "--teeth", "20", "--module", "0.11 in")["warnings"][0]
    assert warning["message"].startswith("a module of 0.11 in is in neither series")
    assert warning["remedy"] == "the nearest, in millimetres: 3 (series I), 2.75 (series II)"


@pytest.mark.parametrize("name", ["{x}", "{}", "{0}", "{", "}", "{0:.6g}", "{{}}", "%s"])
@pytest.mark.parametrize(
    "argv",
    [
        ("gear", "train", "--mesh", "first=a, second=b, first-teeth=20, second-teeth=40", "--driver", "NAME"),
        ("gear", "train", "--stages", "NAME:60"),
        ("gear", "train", "--stages", "20:60, NAME"),
        ("gear", "train", "--stages", "20:60", "--fixed", "NAME"),
        ("inertia", "body", "NAME"),
        ("skid", "speed", "--distance", "NAME", "--friction", "0.7"),
        ("skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--limit", "NAME=1"),
        ("skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--to", "speed=NAME"),
        ("skid", "speed", "--NAME", "60 ft"),
        ("convert", "60", "NAME", "ft/s"),
        ("units", "show", "NAME"),
    ],
    ids=lambda argv: " ".join(argv[:3]),
)
def test_what_a_user_typed_is_no_template(argv: tuple[str, ...], name: str) -> None:
    outcome = run(*(word.replace("NAME", name) for word in argv))
    assert outcome.status in (2, 3), outcome.err
    assert "internal error" not in outcome.err


def test_values_fill_a_template_and_a_message_without_them_stands_as_it_is() -> None:
    with pytest.raises(InadmissibleError, match=re.escape("no {0} here")):
        require(False, "no {0} here")
    with pytest.raises(InadmissibleError, match=re.escape("no {x} of 1.5 here")):
        require(False, "no {0} of {1:.3g} here", "{x}", 1.5)


class TestMissingMembers:
    """Messages name a parameter as the call gives it: options as typed, members of a file by their address."""

    @pytest.mark.parametrize(
        ("argv", "stdin", "said"),
        [
            (("impact", "crush"), "", "dynamics: one of these is missing: --first-mass, or --first-weight\n"),
            (("impact", "crush", "--input", "-"), "{}", "one of these is missing: first.mass, or first.weight\n"),
            (("impact", "crush", "--first-mass", "1 kg", "--first-stiffness-a", "9 N/m"), "",
             "--first-stiffness-b is missing"),
            (("impact", "crush", "--first-mass", "1 kg", "--first-width", "1 m"), "",
             "one of these is missing: --first-stations, or --first-mean-crush"),
            (("impact", "central", "--first-mass", "1 kg", "--first-weight", "3 lbf"), "",
             "--first-mass and --first-weight cannot be given together"),
            (("skid", "speed", "--segment", "distance=3 m"), "", "--segment: friction is missing"),
            (("skid", "speed", "--segment", "distance=3 m", "--segment", "friction=0.7"), "",
             "--segment no. 2: distance is missing"),
            (("skid", "speed", "--input", "-"), '{"segments": [{"distance": "3 m"}]}',
             "segment 1 (segments[0]): friction is missing"),
            (("inertia", "body", "-"), '{"parts": [{"name": "hub", "shape": "sphere", "radius": "1 kg"}]}',
             "part 'hub': radius: '1 kg' is not"),
            (("skid", "speed", "--segment", "distance=3 m, friction=x"), "", "--segment: friction: 'x' is not"),
            (("gear", "train", "--mesh", "first=a, second=b"), "", "--mesh: first_teeth is missing"),
            (("inertia", "section", "--polygon", "0, 0, 1, 1 m, x mm, 2 mm"), "", "--polygon no. 5"),
        ],
    )  # fmt: skip
    def test_named_as_given(self, argv: tuple[str, ...], stdin: str, said: str) -> None:
        outcome = run(*argv, stdin=stdin)
        assert outcome.status == 2
        assert said in outcome.err


@pytest.mark.parametrize(
    ("argv", "said"),
    [
        (("--friction", "0.02", "--grade", "-5 %"), "the drag factor of -0.02996 is"),
        (("--friction", "2 %", "--grade", "-3 deg"), "the drag factor of -0.03236 is"),
        (("--friction", "0.05", "--grade", "-4.9 %"), "friction of 0.05 hardly exceeds the downhill grade of 4.9 %"),
        (("--friction", "5 %", "--grade", "-0.049"), "friction of 5 % hardly exceeds the downhill grade of 0.049"),
    ],
)
def test_pure_numbers_are_written_as_those_of_their_kind(argv: tuple[str, ...], said: str) -> None:
    outcome = run("skid", "speed", "--distance", "20 m", *argv)
    assert said in " ".join((outcome.out + outcome.err).split())


def test_messages_are_no_wider_than_a_terminal() -> None:
    error = UsageError("a " + "word " * 40, parameter="distance", hint="a hint of many words " * 9)
    wide = error_text(error, json=False)
    assert max(map(len, wide.splitlines())) > 150
    lines = error_text(error, json=False, columns=80).splitlines()
    assert max(map(len, lines)) <= 80
    assert " ".join(" ".join(lines).split()) == " ".join(wide.split())
    assert json.loads(error_text(error, json=True, columns=80))["error"]["hint"] == error.hint


def test_a_closing_speed_of_minus_zero_is_zero() -> None:
    call = 'impact planar --first-mass "10 kg" --first-inertia "1 kg*m^2" --first-velocity "10, 0 m/s" --first-lever '
    call += '"0.5, 0.5 m" --second-fixed --normal "-90 deg" --restitution 0.5 --friction 0.3'
    assert "their closing speed is 0 m/s" in run(*shlex.split(call)).err


def test_a_document_of_the_same_command_gives_its_inputs() -> None:
    given = ("skid", "speed", "--distance", "30 m", "--friction", "0.7", "--json")
    assert run("skid", "speed", "--input", "-", "--json", stdin=run(*given).out).out == run(*given).out


@pytest.mark.parametrize(
    ("environ", "shown"), [({}, True), ({"NO_COLOR": "1"}, False), ({"NO_COLOR": ""}, True), ({"TERM": "dumb"}, False)]
)
def test_a_terminal_shows_colours_unless_they_are_forbidden(
    environ: dict[str, str], shown: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    call = ("skid", "speed", "--distance", "60 ft", "--friction", "70")
    plain = run(*call)
    monkeypatch.setattr("dynamics_cli.core.terminal.Terminal.columns", 80)
    monkeypatch.setattr("dynamics_cli.core.terminal.Terminal.error_columns", 80)
    coloured, refused = run(*call, env=environ), run(*call[:-1], "x", env=environ)
    lines = coloured.out.splitlines()
    assert lines[0].startswith("\x1b[1mspeed ") == shown
    assert any(line.startswith("\x1b[33mcaution: ") for line in lines) == shown
    assert refused.err.startswith("\x1b[31mdynamics: ") == shown
    assert re.sub(r"\x1b\[\d*m", "", coloured.out) == plain.out


def test_pipes_have_no_colours() -> None:
    outcome = run("skid", "speed", "--distance", "60 ft", "--friction", "70")
    assert "\x1b" not in outcome.out + run("skid", "speed").err
