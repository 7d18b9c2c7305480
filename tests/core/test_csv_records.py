"""CSV records over several lines: as the csv module reads them, whatever the blocks; an open quote costs its line."""

import csv
import io
import random

import pytest
from row_helpers import PROBE, Slow, run

from dynamics_cli.core.batch.text import records as module
from dynamics_cli.core.batch.text.records import cleared, first_record, records

HEADER = b"marks.distance[ft],note\n"
CELLS = ("plain", "two\nlines", 'a "word"', "blank\n\n\nlines", ",", "\n", 'x"y', "", '5 ft 6"')


def joined(text: bytes, sizes: "list[int]") -> "list[bytes]":
    lines = text.split(b"\n")
    blocks, start = [], 0
    while start < len(lines):
        size = sizes[len(blocks) % len(sizes)]
        blocks.append(lines[start : start + size])
        start += size
    return [line for block in cleared(records(blocks)) for line in block]


@pytest.mark.parametrize("seed", range(30))
def test_records_are_those_of_the_csv_module_however_the_blocks_fall(seed) -> None:
    rng = random.Random(seed)
    rows = [[rng.choice(CELLS) for _ in range(3)] for _ in range(60)]
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(rows)
    found = joined(out.getvalue().encode(), [rng.randint(1, 9) for _ in range(5)])
    assert [next(csv.reader([line.decode()], strict=True)) for line in found] == rows


def test_an_open_quote_costs_its_own_line_only() -> None:
    text = b'1,"open\n2,b\n3,"c\nd"\n4,e'
    # the quote that opens the third row would close the first's, and then a letter follows it
    assert joined(text, [2]) == [b'1,"open', b"2,b", b'3,"c\nd"', b"4,e"]


def test_an_open_quote_does_not_swallow_the_stream(monkeypatch) -> None:
    monkeypatch.setattr(module, "MOST_LINES", 5)
    text = b'1,"open\n' + b"\n".join(b"%d,x" % i for i in range(20))
    assert joined(text, [3]) == text.split(b"\n")


def test_a_line_too_long_ends_what_waits() -> None:
    blocks = [[b'1,"open'], [None], [b'2,"a', b'b"']]
    assert [line for block in cleared(records(blocks)) for line in block] == [b'1,"open', None, b'2,"a\nb"']


def test_a_header_may_run_over_lines() -> None:
    assert first_record([b'"a', b'[ft]",b', b"1,2"]) == (b'"a\n[ft]",b', [b"1,2"])
    assert first_record([b'"a', b"b", None]) == (b'"a', [b"b", None])


@pytest.mark.parametrize("arrays", [False, True])
@pytest.mark.parametrize("step", [None, 7])
def test_rows_with_notes_over_lines_are_answered_and_given_back(arrays, step) -> None:
    rows = [f'{60 + i},"note {i}\n\nand ""more"""' if i % 5 == 0 else f"{60 + i},short" for i in range(40)]
    data = HEADER + "\n".join(rows).encode() + b"\n"
    status, out, _ = run(PROBE, data, stdin=Slow(data, step) if step else None, arrays=arrays)
    made = list(csv.DictReader(io.StringIO(out.decode())))
    assert status == 0
    assert len(made) == 40
    assert [row["note"] for row in made[:2]] == ['note 0\n\nand "more"', "short"]
    plain = "\n".join(f"{60 + i},n" for i in range(40))
    _, without, _ = run(PROBE, HEADER + plain.encode(), arrays=arrays)
    assert [row["speed[km/h]"] for row in made] == [
        row["speed[km/h]"] for row in csv.DictReader(io.StringIO(without.decode()))
    ]


def test_notes_over_lines_become_json_of_one_line() -> None:
    status, out, _ = run(PROBE, HEADER + b'60,"a\nb"\n', format="ndjson")
    assert status == 0
    assert out.count(b"\n") == 1
    assert b'"note":"a\\nb"' in out


def test_quotes_within_quoted_cells_are_no_reason_to_answer_rows_one_by_one() -> None:
    from harness import run as run_program

    from dynamics_cli.core.batch.stream import _Stream

    rows = [
        '60 ft,0.7,"a ""b"""',
        '"61 ft","0.7","""all"""',
        '62 ft,0.7,""',
        '63 ft,0.7,""""""',
        '"5 ft 6""",0.7,"x, ""y"""',
    ]
    head = "distance,friction,note\n"
    singly = [run_program("skid", "speed", "--rows", "-", stdin=head + row + "\n").out.splitlines()[1] for row in rows]
    many = [row for _ in range(200) for row in rows]
    single, calls = _Stream._single, []

    def counted(self, line):
        calls.append(line)
        return single(self, line)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(_Stream, "_single", counted)
        together = run_program("skid", "speed", "--rows", "-", stdin=head + "\n".join(many) + "\n").out.splitlines()[1:]
    assert together == singly * 200
    # the inch mark is no number's end that arrays know
    assert len(calls) <= 200
