"""Tables as people have them: other separators, titles for names, mistakes in every row."""

from math import hypot

import pytest
from harness import run

SPEED = ("skid", "speed", "--rows", "-", "--only", "speed")
PLAIN = "60,0.7,57.04399891126848,"


@pytest.mark.parametrize("separator", [";", "\t"])
def test_semicolons_and_tabs_part_cells_too(separator: str) -> None:
    rows = ["name,distance[ft],friction", "a,60,0.7", '"b,c",60,0.7', '"d ""e""",60,0.7', "f,60"]
    rows[2:2] = ["a,60,0.7"] * 400
    with_commas = run(*SPEED, stdin="\n".join(rows) + "\n")
    found = "\n".join(rows).replace(",", separator).replace(f'"b{separator}c"', '"b,c"') + "\n"
    assert run(*SPEED, stdin=found) == with_commas


def test_a_separator_within_quotes_stays() -> None:
    outcome = run(*SPEED, stdin='note;distance[ft];friction\r\n"a;b";60;0.7\r\n"open;60;0.7\r\nc;60,5;0,7\r\n')
    lines = outcome.out.splitlines()
    assert lines[1] == f"a;b,{PLAIN}"
    assert "the row is not CSV" in lines[2]
    assert "'60,5' is not a decimal number" in lines[3]


@pytest.mark.parametrize(
    "head",
    [
        "distance (ft),friction",
        "Distance [ft], Friction ",
        "DISTANCE (ft);friction",
        "distance[ft],friction",
        "Distance_ft,friction",
    ],
)
def test_titles_are_read_as_names(head: str) -> None:
    outcome = run(*SPEED, stdin=f"{head}\n60,0.7\n".replace("\n60,", "\n60;" if ";" in head else "\n60,"))
    assert outcome.status == 0
    assert outcome.out.splitlines()[1] == PLAIN


def test_an_ending_that_is_no_unit_of_the_parameter_is_none() -> None:
    outcome = run(*SPEED, stdin="distance_ft,distance_m,distance_s,distance_old,friction\n60,1,2,3,0.7\n")
    assert outcome.out.splitlines()[1] == f"60,1,2,3,{PLAIN.partition(',')[2]}"
    inner = run(
        "impact",
        "central",
        "--rows",
        "-",
        stdin="first_mass_kg,first_velocity_mph,second_mass_kg,restitution\n2,3,1,0.5\n",
    )
    assert inner.status == 0


@pytest.mark.parametrize(
    ("head", "row", "wanted"),
    [
        ("distance_ft,friction,End speed km/h", "60,0.7,10", "57.913882720715584"),
        ("distance_ft,friction,end_speed_km_h", "60,0.7,10", "57.913882720715584"),
        ("distance_ft,friction,gravity_g", "60,0.7,1", "57.04399891126848"),
        ("distance_ft,friction,gravity_m_s2", "60,0.7,9.80665", "57.04399891126848"),
    ],
)
def test_units_of_several_words_and_those_of_a_kind(head: str, row: str, wanted: str) -> None:
    assert run(*SPEED, stdin=f"{head}\n{row}\n").out.splitlines()[1].split(",")[3] == wanted


@pytest.mark.parametrize(
    ("heads", "cells"),
    [
        ("first_weight_lb,first_velocity_mph", '3,"3, 4"'),
        ("first_weight[lb],first_velocity[0][mph],first_velocity[1][mph]", "3,3,4"),
        ("first_weight[lbf],first_velocity[mph]", "3,5 @ 53.13010235415598 deg"),
    ],
)
def test_parts_of_a_body_are_columns_under_the_names_of_options(heads: str, cells: str) -> None:
    words = ["impact", "oblique", "--normal", "0 deg", "--restitution", "0.5", "--only", "first.speed", "--rows", "-"]
    outcome = run(*words, stdin=f'{heads},second_mass_kg,second_velocity\n{cells},2,"0, 0 m/s"\n')
    mass = 3.0 * 0.45359237
    along = 3.0 * (mass - 0.5 * 2.0) / (mass + 2.0)
    assert float(outcome.out.splitlines()[1].split(",")[-2]) == pytest.approx(0.44704 * hypot(along, 4.0), rel=1e-12)
    assert not outcome.err


def test_a_misspelt_part_of_a_body_is_named() -> None:
    words = ["impact", "oblique", "--normal", "0 deg", "--restitution", "0.5", "--rows", "-", "--first-mass", "1 kg"]
    outcome = run(*words, stdin="first_velocity_mph,first_radus\n")
    assert "'first_radus' is not a parameter of impact oblique and passes through (not first_radius?)" in outcome.err


def test_a_name_comes_before_a_title() -> None:
    outcome = run(*SPEED, stdin="Distance (m),distance[ft],friction\n1,60,0.7\n")
    assert outcome.out.splitlines()[1] == f"1,{PLAIN}"


def test_a_title_with_several_words_and_a_remark_that_is_none() -> None:
    outcome = run(*SPEED, stdin="End speed (km/h),Remark (free),distance[ft],friction\n10,x,60,0.7\n")
    assert outcome.out.splitlines()[1] == "10,x,60,0.7,57.913882720715584,"
    assert not outcome.err


def test_rows_that_failed_are_counted_and_the_first_is_told_with_its_remedy() -> None:
    outcome = run(*SPEED, stdin="distance,friction\n60,0.7\n60 ft,0.7\n80,0.7\n")
    assert outcome.status == 4
    assert "2 rows could not be answered; the first: distance: '60' has no unit" in outcome.err
    assert "name the unit in the header: distance[…]" in outcome.err


def test_what_failed_in_an_earlier_step_is_not_told_again() -> None:
    first = run(*SPEED, "--format", "ndjson", stdin='{"distance": "60", "friction": 0.7}\n')
    again = run(*SPEED, stdin=first.out)
    assert again.status == 4
    assert not again.err


def test_an_object_over_several_lines_is_refused_at_once() -> None:
    outcome = run(*SPEED, stdin='{\n  "distance": "60 ft",\n  "friction": 0.7\n}\n')
    assert outcome.status == 2
    assert "jq -c" in outcome.err
