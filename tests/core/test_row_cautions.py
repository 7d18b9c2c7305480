"""Cautions of rows: told once when the stream ends, whichever way the rows were answered."""

import pytest
from harness import answer, run

HIGH = "friction of 65 is more than tyres reach on any road"


def rows(count: int, odd: int, friction: str) -> bytes:
    cells = [f"{20 + row % 7},{friction if row == odd else 0.7}" for row in range(count)]
    return "\n".join(["distance[m],friction", *cells, ""]).encode()


@pytest.mark.parametrize("count", [3, 2000])
@pytest.mark.parametrize("jobs", ["1", "2"])
def test_a_caution_among_many_rows_is_told_once(count: int, jobs: str) -> None:
    outcome = run("skid", "speed", "--rows", "-", "--jobs", jobs, stdin=rows(count, count - 2, "65"))
    assert outcome.status == 0
    assert outcome.err.count("caution for at least one row") == 1
    assert HIGH in outcome.err
    assert "write 0.7 or 70 %" in outcome.err


def test_rows_without_cautions_say_nothing() -> None:
    assert run("skid", "speed", "--rows", "-", stdin=rows(2000, 5, "0.72")).err == ""


def test_notes_are_not_cautions() -> None:
    """`lb` read as a mass is a note of every single answer."""
    data = b"first.mass,second.mass,first.velocity\n3000 lb,2000 lb,30 mph\n"
    assert run("impact", "central", "--restitution", "0.2", "--rows", "-", stdin=data).err == ""


def test_a_caution_is_told_beside_failures() -> None:
    told = run("skid", "speed", "--rows", "-", stdin=rows(3, 1, "65") + b"30,x\n").err
    assert "1 row could not be answered" in told
    assert HIGH in told


@pytest.mark.parametrize("count", [3, 2000])
def test_a_sweep_tells_the_cautions_of_its_ends(count: int) -> None:
    sweep = ("--sweep", f"friction=0.7:70:{count}")
    (caution,) = answer("skid", "speed", "--distance", "60 ft", *sweep)["warnings"]
    assert caution["message"] == "in this range: friction of 70 is more than tyres reach on any road"
    assert caution["remedy"] == "write 0.7 or 70 %"
