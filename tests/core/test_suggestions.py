"""What an unknown option or field is taken to mean, and how messages name what was typed."""

import pytest

from dynamics_cli.cli import FAMILIES, family
from dynamics_cli.core.inputs.suggestions import SYNONYMS, suggestions
from tests.harness import run


@pytest.mark.parametrize(
    ("call", "hint"),
    [
        ("skid|speed|--dist|60 ft|--friction|0.7", "did you mean --distance?"),
        ("crash|job.toml", "did you mean dynamics impact crash?"),
        ("skid|speed|--report|x.html", "dynamics report case.json"),
        ("skid|speed|--distance|60 ft|--friction|0.7|--plot|x.dxf", "--drawing x.dxf"),
        ("skid|timeline|--end-speed|3 m/s|--phase|braking 14 m", "kind=braking; it takes duration, distance,"),
        ("units|pressure", "did you mean dynamics units list --kind pressure"),
        ("units|list|pressure", "did you mean --kind pressure?"),
        ("inertia|shape|sphere|--radius|1 m|--density|steel", "--material steel"),
        ("linkage|solve", "dynamics linkage solve --template"),
        ("skid|speed|--mu|0.7", "did you mean --friction?"),
        ("skid|speed|--fricton|0.7", "did you mean --friction?"),
        ("skid|speed|--frmat|json", "did you mean --format?"),
        ("skid|speed|--zzzz|1", "try: dynamics skid speed --help"),
        ("gear|ratio|--ratio|3", "did you mean --target?"),
        ("gear|train|--held|sun", "did you mean --fixed?"),
        ("balance|trial|--run|170 um", "did you mean --initial or --first or --second?"),
        ("balance|grade|--grade|G x", "'G x' is not a balance grade"),
        ("force|resultant|--force|1, 0 N|--force|2, 0 N", 'several: --load "force=…" for each'),
        ("gear|pair|--z1|20", "did you mean --first-teeth?"),
        ("gear|measure|--pin-diameter|3 mm", "did you mean --pin or --over?"),
        ("gear|wheels|--diameter|3 m", "did you mean --first-diameter?"),
        ("gear|ratio|--tolerance|3 mm", "did you mean --distance-tolerance?"),
        ("cam|size|--max-pressure-angle|30 deg", "did you mean --rise-limit or --return-limit?"),
        ("impact|central|--m1|3 kg", "did you mean --first-mass?"),
        ("inertia|shape|hollow-cylinder|--bore|3 mm", "did you mean --inner-diameter or --thickness?"),
        ("impact|momentum|--first-exit-angle|3 deg", "did you mean --first-exit-heading?"),
        ("cam|profile|--base-circle|3 mm", "did you mean --base-radius?"),
        ("skid|speed|--speed-limit|50 km/h", "did you mean --limit?"),
        ("gear|spur|--shift|0.3", "did you mean --profile-shift or --shift-sign?"),
        ("impact|inverse|cars.toml", "a file of them: dynamics impact inverse --input cars.toml"),
        ("skid|speed|60 ft|0.7", 'for example: dynamics skid speed --distance "60 ft" --friction 0.7'),
        ("skid|speed|--segment|distance=20 ft, mu=0.3", "did you mean friction?"),
        ("inertia|section|--polygons|0, 0, 5, 0, 5, 5 mm", "did you mean --polygon?"),
    ],
)
def test_unknown_names(call: str, hint: str) -> None:
    outcome = run(*call.split("|"))
    assert outcome.status == 2
    assert hint in outcome.err


@pytest.mark.parametrize("call", ["gear|pair|--z1|17|--z2|43", "cam|profile|--z1|17|--z2|43"])
def test_all_unknown_options_are_told_at_once(call: str) -> None:
    errors = run(*call.split("|"), "--json").error["errors"]
    assert [error["parameter"] for error in errors] == ["z1", "z2"]


def test_what_was_typed_is_named() -> None:
    outcome = run("skid", "stop", "--speed", "50 km/h", "--friction", "0.75", "--reaction-time", "1 m")
    assert outcome.err.startswith("dynamics: --reaction-time: '1 m'")


def test_every_synonym_leads_to_an_option() -> None:
    options = {name for name in FAMILIES for task in family(name).tasks.values() for name in task.options}
    # a body's parameter is meant with the body before it
    options |= {name.removeprefix("first-") for name in options}
    options |= {"limit", "input", "output", "rows", "format", "units", "to", "digits", "all", "explain"}
    for word, names in SYNONYMS.items():
        assert options.issuperset(names.split()), word
        assert word not in names.split()


def test_a_beginning_that_fits_one_name_wins() -> None:
    assert suggestions("rad", ("radius", "grade")) == ["radius"]
    assert suggestions("first_m", ("first_mass", "first_speed")) == ["first_mass"]
    assert suggestions("first", ("first_mass", "first_speed")) == ["first_mass", "first_speed"]


def test_what_is_missing_is_described_as_its_help_does() -> None:
    assert "--friction is missing: coefficient of friction between tyre and road\n" in run("skid", "speed").err
    assert "--first-teeth is missing: number of teeth\n" in run("gear", "pair").err
    assert "--lengths is missing: lengths of the rods from the top\n" in run("motion", "chain").err
    slide = run("impact", "slide").err
    assert "--front-axle is missing: distance from the mass centre ahead to the front axle\n" in slide
    assert "--track is missing: distance between the left and the right wheels\n" in slide


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("0.7-0.8", "0.7..0.8"),
        ("0.7–0.8", "0.7..0.8"),
        ("70 - 80 %", "70..80 %"),
        ("70 % to 80 %", "70 %..80 %"),
    ],
)
def test_a_range_is_told_how_it_is_written(typed: str, meant: str) -> None:
    told = f"dynamics: --friction: {typed!r} is not one number\n  write a range as {meant}\n"
    assert run("skid", "speed", "--distance", "18 m", "--friction", typed).err == told
    assert run("skid", "speed", "--distance", "18 m", "--friction", meant, "--method", "linear").status == 0


def test_a_call_that_gives_nothing_is_shown_one_that_works() -> None:
    example = 'an example:\n  dynamics skid speed --distance "60 ft" --friction 0.7\n'
    assert run("skid", "speed").err.endswith(example)
    assert "an example" not in run("skid", "speed", "--friction", "0.7").err
    assert "an example" not in run("skid", "speed", "--json").err


@pytest.mark.parametrize(
    ("task", "typed", "meant"),
    [
        ("linkage four-bar", "--theta2", "--crank-angle"),
        ("linkage four-bar", "--d", "--ground"),
        ("linkage slider-crank", "--stroke", "--crank, half of it, as in 60/2 mm"),
        ("path rectilinear", "--u", "--start-speed"),
        ("path polar", "--r-dot", "--radial-speed"),
        ("orient convert", "--rpy", "--yaw or --pitch or --roll"),
        ("orient rates", "--yaw-rate", "--angle-rates"),
    ],
)
def test_symbols_of_textbooks_lead_to_the_option(task: str, typed: str, meant: str) -> None:
    assert f"did you mean {meant}?" in run(*task.split(), typed, "1").err
