"""Results that are words, yes or no, or whole numbers: in rows and sweeps, by arrays as one by one."""

import json

from harness import run as call
from row_helpers import run

from dynamics_cli.core.answering.task import Family, Model, Task
from dynamics_cli.quantities import Annotated, Count, Ratio, Remark, Text
from dynamics_cli.records import record


@record
class Verdict:
    says: Text
    sure: bool
    half: Ratio
    rounds: Count
    of_note: Annotated[Text | None, "Only of large numbers."]
    convention: Annotated[Remark, "The same for every case."] = "numbers grow upwards"


def judge(*, a: Ratio) -> Verdict:
    large = bool(a > 2.0)
    return Verdict('large, "too" large' if large else "small", large, a / 2.0, 3, "far off" if large else None)


JUDGE = Task("judge", "Words.", Model("all", "test_words_in_rows:judge", source="none"))
FAMILY = Family("test", "Tests.", JUDGE)
HEAD = b"a,says,sure,half,rounds,of_note,error\n"


def row(a: float) -> bytes:
    return b'%g,"large, ""too"" large",true,%s,3,far off,\n' % (a, repr(a / 2).encode()) if a > 2 else (
        b"%g,small,false,%s,3,,\n" % (a, repr(a / 2).encode())
    )  # fmt: skip


def test_words_are_plain_columns_by_every_route() -> None:
    numbers = [0.5, 3.5] * 20
    data = "a\n" + "".join(f"{number:g}\n" for number in numbers)
    wanted = HEAD + b"".join(map(row, numbers))
    for arrays in (True, False):
        status, out, _ = run(JUDGE, data.encode(), arrays=arrays)
        assert (status, out) == (0, wanted)
        status, out, _ = run(JUDGE, data.encode(), arrays=arrays, format="ndjson", only="says,sure,rounds")
        results = [json.loads(line)["results"] for line in out.splitlines()]
        assert results[0] == {"says": "small", "sure": False, "rounds": {"value": 3}}
        assert results[1] == {"says": 'large, "too" large', "sure": True, "rounds": {"value": 3}}


def test_an_incline_says_in_each_row_how_the_block_moves() -> None:
    cases = "mass[kg],friction,angle[deg]\n2,0.3,30\n2,0.3,10\n"
    outcome = call("particle", "incline", "--rows", "-", "--only", "motion,repose", stdin=cases)
    assert [line.split(",")[3] for line in outcome.out.splitlines()] == ["motion", "slides down", "rests"]


def test_a_sweep_has_a_column_of_words() -> None:
    words = "particle incline --mass 2kg --friction 0.3 --sweep angle=10:30deg:2 --only motion --format csv"
    assert call(*words.split(" ")).out == "angle[deg],motion\n10.0,rests\n30.0,slides down\n"
