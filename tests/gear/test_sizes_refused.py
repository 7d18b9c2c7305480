"""Sizes beyond any gear are refused by name and at once."""

import pytest
from harness import run

HUGE = "1e300 mm"
REFUSED = [
    ("profile", ("--teeth", "20", "--module", HUGE, "--internal"), 3, "module"),
    ("profile", ("--teeth", "20", "--module", HUGE), 3, "module"),
    ("profile", ("--teeth", "9007199254740991", "--module", "1 mm", "--rack"), 3, "too-many-points"),
    ("measure", ("--teeth", "20", "--module", HUGE), 3, "module"),
    ("measure", ("--teeth", "1000000000000", "--module", "1 mm"), 3, "too-many-teeth"),
    ("mesh", ("--first-teeth", "100000000", "--second-teeth", "20", "--module", "1 mm"), 3, "too-many-teeth"),
    ("data-block", ("--teeth", "1000000000000", "--module", "1 mm"), 3, "too-many-teeth"),
    ("spur", ("--teeth", "9007199254740991", "--module", "1 mm"), 3, "too-many-teeth"),
    ("spur", ("--teeth", "100000000000000000000", "--module", "1 mm"), 2, "bounds"),
    ("bevel", ("--first-teeth", "20", "--second-teeth", "40", "--module", HUGE, "--face-width", "1 mm"), 3, "module"),
    ("worm", ("--threads", "1", "--teeth", "40", "--module", HUGE, "--diameter-factor", "10"), 3, "module"),
    ("ratio", ("--target", "3", "--centre-distance", HUGE, "--module", "1 mm"), 3, "centre-distance"),
    ("involute", ("--base-diameter", "100 mm", "--diameter", HUGE), 3, "size"),
    (
        "involute",
        ("--base-diameter", "9 mm", "--diameter", "12 mm", "--known-diameter", HUGE, "--known-thickness", "1 mm"),
        3,
        "size",
    ),
]


@pytest.mark.parametrize(("command", "words", "status", "code"), REFUSED)
def test_what_is_too_large_is_named(command: str, words: tuple[str, ...], status: int, code: str) -> None:
    outcome = run("gear", command, *words, "--json")
    assert (outcome.status, outcome.error["code"]) == (status, code)


def test_too_many_teeth_are_still_a_whole_number() -> None:
    outcome = run("gear", "spur", "--teeth", "100000000000000000000", "--module", "1 mm")
    assert "at most 9007199254740992" in outcome.err
    assert "not a whole number" not in outcome.err


def test_a_wide_tolerance_of_the_distance_looks_at_no_more_pairs_than_there_are() -> None:
    outcome = run(
        "gear", "ratio", "--target", "3", "--stages", "1", "--centre-distance", "40 mm", "--module", "1 mm",
        "--distance-tolerance", "1e300 mm", "--json",
    )  # fmt: skip
    assert outcome.status == 0
    assert outcome.document["results"]["best"][0]["error"] == "0"


def test_a_mesh_of_very_unlike_gears_passes_its_own_check() -> None:
    """The rounding of the slow gear's angle counts by the ratio on the fast one."""
    outcome = run(
        "gear", "mesh", "--first-teeth", "1000000", "--second-teeth", "20", "--module", "1 mm", "--points", "1000",
        "--json",
    )  # fmt: skip
    assert outcome.status == 0
    assert outcome.document["results"]["runs"] is True
