"""Vectors in one cell or one string: blocks of them are answered together, to the bits of single answers."""

import json
import random

import pytest
from row_helpers import PROBE, run

from dynamics_cli.core.batch.rows.case import Case

WAYS = (
    '"{0}, {1}, {2} ft"',
    '"{0},{1},{2} ft"',
    "{0} {1} {2} ft",
    '"{0} {1} {2} ft"',
    '"[{0}, {1}, {2}] ft"',
    '"({0}, {1}, {2})"',
    '"{0} ft, {1} ft, {2} ft"',
    '"{0} ft, {1} m, {2} ft"',
    '"{0} ft, {1}, {2} m"',
    '"{0}, {1} ft"',
    '"{0}; {1}; {2} ft"',
    '"{0}, {1}, {2}, {3} ft"',
    '"{0}, {1}, {2} 1/ft"',
    '"{0}, , {2} ft"',
    '"{0}, {1}, 3/4 ft"',
    '"{0}, {1}, {2}e ft"',
    '"{0}, {1}, {2} ""ft"""',
    '"{0}, {1}, {2}"',
    "{0} 1/2 ft",
)


NUMBERS = ("0", "-1", "0.25", "17.123456789012345", "3e2", ".5", "-.5e1", "+2.5", "7.", "007", "+.0000000000000000001")


def numbers(draw: random.Random) -> list[str]:
    return [draw.choice((*NUMBERS, f"{draw.random():.6f}")) for _ in range(4)]


def table(way: str, count: int, head: str = "at") -> bytes:
    draw = random.Random(way)
    names = ("Smith", '"Smith, John"', '"a ""quoted"" name"', "")
    lines = [f"name,distance[ft],{head}"]
    for _ in range(count):
        distance = f"{draw.choice(('', '+', '0'))}{draw.randint(20, 90)}{draw.choice(('', '.'))}"
        lines.append(f"{draw.choice(names[:3])},{distance},{way.format(*numbers(draw))}")
    return "\n".join(lines).encode() + b"\n"


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("head", ["at", "at[ft]"])
def test_cells_of_a_vector_equal_single_answers(way: str, head: str) -> None:
    data = table(way, 40, head).replace(b"distance", b"marks.distance")
    assert run(PROBE, data) == run(PROBE, data, arrays=False)


@pytest.mark.parametrize("way", WAYS)
def test_strings_of_a_vector_equal_single_answers(way: str) -> None:
    draw = random.Random(way)
    rows = [
        {"marks": {"distance": f"{draw.randint(20, 90)} ft"}, "at": way.strip('"').format(*numbers(draw))}
        for _ in range(40)
    ]
    data = "\n".join(map(json.dumps, rows)).encode()
    assert run(PROBE, data) == run(PROBE, data, arrays=False)


def test_ways_of_writing_may_differ_from_row_to_row() -> None:
    draw = random.Random(3)
    lines = ["marks.distance[ft],at,name"]
    lines += [f'{draw.randint(20, 90)},{draw.choice(WAYS).format(*numbers(draw))},"a, b"' for _ in range(400)]
    data = "\n".join(lines).encode()
    assert run(PROBE, data) == run(PROBE, data, arrays=False)


@pytest.mark.parametrize("way", [*WAYS[:5], WAYS[9]])
def test_blocks_of_them_are_answered_together(way: str, monkeypatch: pytest.MonkeyPatch) -> None:
    singly = []
    values = Case.values
    monkeypatch.setattr(Case, "values", lambda case, row: singly.append(row) or values(case, row))
    data = table(way, 400).replace(b"distance", b"marks.distance").replace(b'""', b"'")
    status, out, _ = run(PROBE, data)
    assert status == 0, out
    assert out.count(b"\n") == 401
    assert len(singly) <= 30  # the first and the last row of each way are compared


@pytest.mark.parametrize("spaces", ["{}, {}", "{} ,  {} ", "  {},{}   "])
@pytest.mark.parametrize("unit", ["", " ft"])
def test_spaces_around_cells_are_no_reason_to_go_one_by_one(
    spaces: str, unit: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    draw = random.Random(spaces)
    rows = [spaces.format(f"{draw.choice(numbers(draw))}{unit}".lstrip("-"), draw.random()) for _ in range(400)]
    data = "\n".join([f"marks.distance{'' if unit else '[ft]'},marks.friction", *rows]).encode()
    expected = run(PROBE, data, arrays=False)
    singly = []
    values = Case.values
    monkeypatch.setattr(Case, "values", lambda case, row: singly.append(row) or values(case, row))
    assert run(PROBE, data) == expected
    assert len(singly) <= 30
