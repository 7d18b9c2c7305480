"""Rows: each equals its single call to the bit, a bad row costs only itself, and order and memory are kept."""

import io
import json
import os
import random
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from row_helpers import MODELS, NAMED, PROBE, Slow, run

from dynamics_cli.core.batch import stream
from dynamics_cli.core.batch.rows import plan
from dynamics_cli.core.batch.text import blocks, records
from dynamics_cli.errors import ManyErrors, UsageError

NUMBERS = ("60", "0.7", "12.25", "1e-3", "17.123456789012345", "0", "33", "5e2", "0.1", "2.5", "123456789.123", "0.3")
BAD = ("", "x", "-5", "1,5", "nan", "1e400", "1_000", "5 kg", "٣", "0x1", "1e-400", "--1", "+5", ".5", "7.", " 8 ")


def cells(generator: random.Random, *, spoiled: float) -> list[str]:
    """Six cells: distance[ft], friction, temperature, surface, count, id."""
    made = [
        generator.choice(NUMBERS),
        f"{generator.randint(0, 120) / 20}",
        generator.choice(("70 degF", "20 degC", "300 K", "-500 degF", "21.5 degC")),
        generator.choice(("dry", "wet")),
        generator.choice(("1", "2", "3")),
        f"case {generator.randint(0, 99)}",
    ]
    if generator.random() < spoiled:
        made[generator.randrange(5)] = generator.choice(BAD)
    if generator.random() < spoiled / 4:
        made.append("more")
    return made


HEADER = "distance[ft],friction,temperature,surface,count,id"


def csv_rows(count: int, seed: int, spoiled: float = 0.05) -> bytes:
    generator = random.Random(seed)
    return "\n".join([HEADER, *(",".join(cells(generator, spoiled=spoiled)) for _ in range(count))]).encode() + b"\n"


def json_rows(count: int, seed: int, spoiled: float = 0.05) -> bytes:
    generator = random.Random(seed)
    lines = []
    for _ in range(count):
        distance, friction, temperature, surface, number, name = cells(generator, spoiled=spoiled)[:6]
        shape = generator.randrange(4)
        first = {"value": 0, "unit": "ft"} if shape else f"{distance} ft"
        row = {"id": name, "distance": first, "friction": "FRICTION", "surface": surface, "count": "COUNT"}
        if shape == 2:
            row["temperature"] = temperature
        if shape == 3:
            row["at"] = {"value": [1, generator.randint(-9, 9), 2.5], "unit": "m"}
        text = json.dumps(row).replace('"value": 0', f'"value": {distance}')
        lines.append(text.replace('"FRICTION"', friction or '""').replace('"COUNT"', number or "1"))
    return "\n".join(lines).encode() + b"\n"


class TestSameAsSingle:
    """The array route and the single route give the same bytes, errors included."""

    @pytest.mark.parametrize("seed", range(6))
    @pytest.mark.parametrize("form", ["csv", "ndjson"])
    def test_csv(self, seed: int, form: str) -> None:
        data = csv_rows(700, seed)
        assert run(PROBE, data, format=form) == run(PROBE, data, format=form, arrays=False)

    @pytest.mark.parametrize("seed", range(6))
    @pytest.mark.parametrize("form", ["csv", "ndjson"])
    def test_ndjson(self, seed: int, form: str) -> None:
        data = json_rows(700, seed)
        assert run(PROBE, data, format=form) == run(PROBE, data, format=form, arrays=False)

    @pytest.mark.parametrize("units", ["si", "us", "base"])
    def test_units(self, units: str) -> None:
        data = csv_rows(400, 11, spoiled=0.01)
        assert run(PROBE, data, units=units) == run(PROBE, data, units=units, arrays=False)

    def test_units_by_name(self) -> None:
        data = csv_rows(400, 12, spoiled=0.01)
        to = ["inner.moved=ft;in", "turn=rev", "slope=deg", "speed=mm/day", "rows.own=cm"]
        assert run(PROBE, data, to=to) == run(PROBE, data, to=to, arrays=False)

    def test_extreme_magnitudes(self) -> None:
        generator = random.Random(3)
        lines = ["distance[ft],friction,invert"]
        for _ in range(600):
            distance = f"{generator.random():.{generator.randint(1, 17)}g}e{generator.randint(-99, 99)}"
            invert = f"{generator.choice(('-', ''))}{generator.random()}e{generator.randint(-320, 320)}"
            lines += [f"{distance},{generator.random()!r},{invert}"]
        lines += ["1e300,0.1,0", "1e308,1,1", "1e-320,0.1,5e-324"] * 20
        data = "\n".join(lines).encode()
        for to in (["speed=ym/s"], ["speed=Ym/s"], []):
            assert run(PROBE, data, to=to) == run(PROBE, data, to=to, arrays=False)

    def test_alternatives_and_several_of_a_group(self) -> None:
        generator = random.Random(5)
        head = "segments[0].x"
        head = (
            "marks[0].distance[m],marks[0].friction,marks[1].distance[ft],marks[1].friction,radius[m],chord[m],middle"
        )
        lines = [head]
        for _ in range(500):
            row = [f"{generator.randint(1, 999) / 10}" for _ in range(7)]
            for index in generator.choice(((4,), (5, 6), (4, 5, 6), (6,), ())):
                row[index] = ""
            row[6] = row[6] and row[6] + " cm"
            lines.append(",".join(row))
        data = "\n".join(lines).encode()
        status, out, _ = run(PROBE, data)
        assert (status, out) == run(PROBE, data, arrays=False)[:2]
        assert status == 4
        assert b"cannot be given together" in out

    def test_array_route_is_taken(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(stream._Stream, "_single", lambda self, line: pytest.fail(f"one by one: {line!r}"))
        rows = [
            f"{i / 7:.3f},{i / 200},{t},{s}" for i in range(300) for t in ("70 degF", "3 degC") for s in ("dry", "wet")
        ]
        assert run(PROBE, "\n".join(["distance[ft],friction,temperature,surface", *rows, ""]).encode())[0] == 0

    def test_choice_of_model_by_value_goes_one_by_one(self) -> None:
        data = b"a\n" + b"\n".join(str(i / 200).encode() for i in range(200))
        assert run(MODELS, data) == run(MODELS, data, arrays=False)
        _, out, _ = run(MODELS, data)
        assert out.split(b"\n")[1].startswith(b"0.0,0.0,")
        assert out.split(b"\n")[200].startswith(b"0.995,10.764")

    @pytest.mark.parametrize("head", ["a", "a,b"])
    def test_choice_of_model_by_name(self, head: str) -> None:
        data = head.encode() + b"\n" + b"\n".join(b"0.3,0.4"[: 4 * len(head) - 1] for _ in range(200))
        assert run(NAMED, data) == run(NAMED, data, arrays=False)

    def test_model_asked_for(self) -> None:
        data = b"a\n" + b"0.3\n" * 200
        assert run(MODELS, data, model="large") == run(MODELS, data, model="large", arrays=False)
        with pytest.raises(UsageError, match="no model"):
            run(MODELS, data, model="huge")

    def test_disagreement_falls_back(self, monkeypatch: pytest.MonkeyPatch) -> None:
        """Should the array route ever differ, its first block shows it and single calls take over."""
        data = csv_rows(300, 4, spoiled=0.0)
        right = run(PROBE, data, arrays=False)
        honest = plan.Plan.run

        def wrong(self, columns):
            results, good = honest(self, columns)
            return [(p, h, v + 1.0 if h == "each" and p.how == "number" else v) for p, h, v in results], good

        monkeypatch.setattr(plan.Plan, "run", wrong)
        assert run(PROBE, data) == right


class TestBadRows:
    def test_costs_only_itself(self) -> None:
        good = b"60,0.7\n" * 500
        data = b"distance[ft],friction\n" + good + b"60 kg,0.7\n" + good
        status, out, _ = run(PROBE, data)
        lines = out.split(b"\n")
        assert status == 4
        assert lines[501].startswith(b"60 kg,0.7,,,")
        assert b"kg is a mass" in lines[501]
        assert len({*lines[1:501], *lines[502:1002]}) == 1
        assert lines[1002:] == [b""]

    def test_each_sort(self) -> None:
        rows = [
            b"60",
            b"60,0.7,1",
            b'"60,0.7',
            b'"60",0.7',
            b"60,\xff",
            b"1e999,0.7",
            b"60,7",
            b"60,",
            b"\x00,0.5",
            b",",
        ]
        data = b"distance[ft],friction\n" + b"\n".join(rows)
        status, out, _ = run(PROBE, data)
        lines = out.decode(errors="surrogateescape").split("\n")
        assert status == 4
        width = lines[0].count(",")
        import csv

        for line in csv.reader(lines[:-1]):
            assert len(line) == width + 1
        errors = [next(csv.reader([line]))[-1] for line in lines[1:-1]]
        wanted = ["", "3 cells", "not CSV", "", "not UTF-8", "range", "glue", "", "", "missing"]
        for error, part in zip(errors, wanted, strict=True):
            assert (part in error) if part else True
        assert errors[3] == errors[7] == ""

    def test_json_sorts(self) -> None:
        rows = [
            b'{"distance":"60 ft"}', b"{", b"[1]", b"3", b'"x"', b'{"distance":"60 ft","distance":"61 ft"}',
            b'{"distance":NaN}', b'{"distance":"\xff"}', b'{"distance":{"value":60}}', b'{"distance":[1]}',
            b'{"distance":null}', b"{}",
            b'{"distance":"60 ft","friction":9}', b"[" * 100000, b'{"distance":"60 ft"} ', b'{"distance":1e999}',
        ]  # fmt: skip
        status, out, _ = run(PROBE, b"\n".join(rows))
        made = [json.loads(line) for line in out.splitlines()]
        assert status == 4
        assert [index for index, row in enumerate(made) if "results" in row] == [0, 14]
        assert all(("error" in row) != ("results" in row) for row in made)
        assert made[1]["row"] == "{"
        assert made[12]["error"]["code"] == "glue"
        assert made[12]["error"]["message"] == "friction 9 is glue"
        assert made[11]["error"]["code"] == "missing"

    def test_all_wrong_parameters_at_once(self) -> None:
        _, out, _ = run(PROBE, b'{"distance":"60 kg","friction":-1}')
        error = json.loads(out)["error"]
        assert [one["parameter"] for one in error["errors"]] == ["distance", "friction"]

    def test_fixed_parameter_that_is_wrong_is_told_at_once(self) -> None:
        with pytest.raises(UsageError, match="kg is a mass"):
            run(PROBE, b"distance[ft]\n60\n", friction="3 kg")
        with pytest.raises(ManyErrors):
            run(PROBE, b"distance[ft]\n60\n", friction="3 kg", temperature="1 m")

    @pytest.mark.parametrize(
        ("data", "code"),
        [
            (b"[1,2]", "json"),
            (b"a,b\n1,2\n", "header"),
            (b"distance,distance\n1,2\n", "csv"),
            (b"\xff,a\n", "encoding"),
        ],
    )
    def test_refused_streams(self, data: bytes, code: str) -> None:
        with pytest.raises(UsageError) as caught:
            run(PROBE, data)
        assert caught.value.code == code

    @pytest.mark.parametrize("head", ["at,at[0]", "path,marks[0],marks[0].distance", "at[99999999999],distance[m]"])
    def test_whole_and_parts(self, head: str) -> None:
        status, out, _ = run(PROBE, f"{head}\n1,2,3\n1,2\n".encode())
        assert status == 4
        assert out.count(b"\n") == 3

    @pytest.mark.parametrize("option", ["explain", "timing"])
    def test_options_for_one_case(self, option: str) -> None:
        with pytest.raises(UsageError):
            run(PROBE, b"distance[ft]\n1\n", **{option: True})

    @pytest.mark.parametrize("form", ["table", "markdown"])
    def test_formats_for_people_are_refused(self, form: str) -> None:
        with pytest.raises(UsageError, match="rows cannot be written"):
            run(PROBE, b"distance[ft]\n1\n", format=form)

    def test_missing_file(self, tmp_path) -> None:
        with pytest.raises(UsageError, match="cannot read"):
            run(PROBE, b"", rows=str(tmp_path / "none.csv"))

    def test_misspelt_column_is_told(self) -> None:
        _, out, err = run(PROBE, b"distance[ft],frction\n60,0.7\n")
        assert out.startswith(b"distance[ft],frction,speed")
        assert "frction" in err
        assert "friction" in err


class TestFormats:
    def test_header_and_units(self) -> None:
        _, out, _ = run(PROBE, b"distance[ft],speed\n60,x\n", units="us")
        head = out.split(b"\n")[0].decode()
        assert head == (
            "distance[ft],speed,results.speed[mph],warm[degF],turn[deg],slope[%],inner.mean,inner.moved[0][ft],"
            "inner.moved[1][ft],inner.moved[2][ft],inverse,fast,surface,total,error"
        )

    def test_results_of_ndjson(self) -> None:
        _, out, _ = run(PROBE, b'{"id": 7, "distance": "60 ft"}')
        row = json.loads(out)
        assert out.startswith(b'{"id": 7, "distance": "60 ft","results":{"speed":{"value":')
        assert row["results"]["inner"]["moved"]["value"][1:] == [0.0, 0.0]
        assert row["results"]["fast"] is False
        assert row["results"]["surface"] == "dry"
        assert row["results"]["total"] == {"value": 2}
        assert "inverse" not in row["results"]

    def test_results_of_an_earlier_step(self) -> None:
        rows = [b'{"distance":"9 ft","id":%d,"results":{"distance":{"value":%d,"unit":"ft"},"x":{"value":1}}}' % (i, i)
                for i in range(1, 300)]  # fmt: skip
        status, out, _ = run(PROBE, b"\n".join(rows))
        assert status == 0
        assert (status, out) == run(PROBE, b"\n".join(rows), arrays=False)[:2]
        plain = run(PROBE, b'{"distance":"7 ft"}')[1]
        assert json.loads(out.splitlines()[6])["results"] == json.loads(plain)["results"]
        assert out.splitlines()[6].count(b'"results"') == 1

    def test_results_column_of_an_earlier_step(self) -> None:
        _, out, _ = run(PROBE, b"distance[ft],results.distance[ft]\n60,7\n")
        assert out.split(b"\n")[1].split(b",")[2] == run(PROBE, b"distance[ft]\n7\n")[1].split(b"\n")[1].split(b",")[1]

    def test_error_of_an_earlier_step_goes_on(self) -> None:
        line = b'{"distance":"9 ft","error":{"code":"glue","parameter":"friction","message":"stuck","hint":"none"}}'
        status, out, _ = run(PROBE, line)
        assert (status, out.strip()) == (4, line)
        status, out, _ = run(PROBE, b"distance[ft],error\n60,stuck\n61,\n")
        assert status == 4
        assert out.split(b"\n")[1].endswith(b",stuck")
        assert out.split(b"\n")[0].endswith(b",results.error")

    def test_documents_as_rows(self) -> None:
        line = b'{"schema":"dynamics/1","command":"x","results":{"distance":{"value":60,"unit":"ft"}},"warnings":[]}'
        status, out, _ = run(PROBE, line)
        assert status == 0
        assert json.loads(out)["results"]["speed"]["unit"] == "km/h"

    def test_csv_to_ndjson_can_be_read_again(self) -> None:
        data = csv_rows(50, 8, spoiled=0.0)
        _, out, _ = run(PROBE, data, format="ndjson")
        again = [json.loads(line) for line in run(PROBE, out)[1].splitlines()]
        assert [row.get("results") for row in again] == [json.loads(line).get("results") for line in out.splitlines()]

    def test_ndjson_to_csv(self) -> None:
        rows = b'{"id":1,"distance":{"value":60,"unit":"ft"}}\n{"distance":{"value":20,"unit":"m"},"id":2}\nx\n'
        lines = run(PROBE, rows, format="csv")[1].decode().split("\n")
        assert lines[0].startswith("id,distance[ft],speed[km/h]")
        assert lines[1].startswith("1,60,")
        assert lines[2].startswith("2,20 m,")
        assert lines[3].startswith("x,,,")

    def test_line_ends_blank_lines_and_byte_order_mark(self) -> None:
        plain = run(PROBE, b"distance[ft],friction\n60,0.7\n61,0.7\n")
        assert run(PROBE, b"\xef\xbb\xbfdistance[ft],friction\r\n60,0.7\r\n\r\n  \r\n61,0.7") == plain

    def test_nothing_in_nothing_out(self) -> None:
        assert run(PROBE, b"") == (0, b"", "")
        assert run(PROBE, b"\n \n\n")[:2] == (0, b"")

    def test_header_alone(self) -> None:
        status, out, _ = run(PROBE, b"distance[ft]\n")
        assert status == 0
        assert out.startswith(b"distance[ft],speed")

    def test_options_win_over_rows(self) -> None:
        data = b"distance[ft],friction\n" + b"60,0.7\n61,0.7\n" * 100
        fixed = run(PROBE, data, friction="0.5")
        assert fixed == run(PROBE, data, friction="0.5", arrays=False)
        own = run(PROBE, data.replace(b"0.7", b"0.5"))
        assert fixed[1].split(b"\n")[5].split(b",")[2:] == own[1].split(b"\n")[5].split(b",")[2:]

    def test_rows_win_over_input_file(self, tmp_path) -> None:
        (tmp_path / "base.json").write_text('{"friction": 0.3, "distance": "9 ft"}')
        data = b"distance[ft]\n" + b"60\n61\n" * 100
        got = run(PROBE, data, input=str(tmp_path / "base.json"))
        assert got == run(PROBE, data, friction="0.3")

    def test_output_file_is_whole(self, tmp_path) -> None:
        status, out, _ = run(PROBE, b"distance[ft]\n60\n", output=str(tmp_path / "o.csv"))
        assert (status, out) == (0, b"")
        assert (tmp_path / "o.csv").read_bytes() == run(PROBE, b"distance[ft]\n60\n")[1]
        with pytest.raises(UsageError):
            run(PROBE, b"nothing\n60\n", output=str(tmp_path / "p.csv"))
        assert not (tmp_path / "p.csv").exists()


class TestReading:
    @pytest.mark.parametrize("size", [1, 2, 3, 7, 100, 65536])
    def test_any_pieces(self, size: int) -> None:
        data = b"\xef\xbb\xbf" + csv_rows(60, 2)
        assert run(PROBE, b"", stdin=Slow(data, size)) == run(PROBE, data)

    def test_long_line(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(blocks, "LONGEST_LINE", 1000)
        long = b"9" * 300_000
        data = b"distance[ft],friction\n60,0.7\n" + long + b"\n61,0.7\n" + long
        for size in (100, 1000, 70_000):
            status, out, _ = run(PROBE, b"", stdin=Slow(data, size))
            lines = out.decode().split("\n")
            assert status == 4
            assert lines[1].startswith("60,0.7,5")
            assert lines[3].startswith("61,0.7,5")
            if size < 70_000:
                assert "longer" in lines[2]
                assert "longer" in lines[4]
                assert len(lines) == 6

    def test_answers_while_the_pipe_is_open(self) -> None:
        command = [sys.executable, "-m", "dynamics_cli", "convert", "mph", "ft/s", "--rows", "-"]
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0) as process:
            assert process.stdin is not None
            assert process.stdout is not None
            for text, answer in ((b"60\n", b"60\t88.0\n"), (b"30\n", b"30\t44.0\n")):
                process.stdin.write(text)
                assert process.stdout.readline() == answer
            process.stdin.close()
            assert process.wait(timeout=20) == 0

    def test_closed_reader_ends_quietly(self, tmp_path) -> None:
        (tmp_path / "rows.csv").write_bytes(b"distance[ft],friction\n" + b"60,0.7\n" * 200_000)
        command = f"{sys.executable} -m dynamics_cli skid speed --rows {tmp_path / 'rows.csv'} | head -2"
        done = subprocess.run(["bash", "-c", command], capture_output=True, timeout=60, check=False)
        assert done.stdout.count(b"\n") == 2
        assert done.stderr == b""

    def test_progress_on_a_terminal_only(self, monkeypatch: pytest.MonkeyPatch) -> None:
        from dynamics_cli.core.batch.rows import progress

        monkeypatch.setattr(progress, "PATIENCE", -1.0)
        monkeypatch.setattr("dynamics_cli.core.terminal.Terminal.shows_progress", True)
        _, out, err = run(PROBE, csv_rows(200, 1, spoiled=0.0))
        assert "rows" in err
        assert out.startswith(HEADER.encode())


def csv_records(data: bytes) -> list[bytes]:
    """The records that are no white space: lines, joined where a quoted cell runs on."""
    lines = data.replace(b"\r\n", b"\n").removesuffix(b"\r").removesuffix(b"\n").split(b"\n")
    return [record for block in records.records([lines]) for record in block if record and not record.isspace()]


class TestFuzz:
    @settings(max_examples=150, deadline=None)
    @given(st.lists(st.binary(max_size=60), max_size=20), st.booleans())
    def test_bytes_of_csv(self, rows: list[bytes], arrays: bool) -> None:
        data = b"distance[ft],friction,id\n" + b"\n".join(rows)
        status, out, _ = run(PROBE, data, arrays=arrays)
        assert status in (0, 4)
        assert len(csv_records(out)) == len(csv_records(data))

    @settings(max_examples=150, deadline=None)
    @given(st.binary(max_size=80))
    def test_any_bytes(self, data: bytes) -> None:
        with suppress(UsageError):
            assert run(PROBE, data)[0] in (0, 4)

    @settings(max_examples=150, deadline=None)
    @given(st.text("distancefrom.[]0123456789,_-at\n", max_size=60))
    def test_any_header(self, head: str) -> None:
        with suppress(UsageError):
            assert run(PROBE, f"distance,{head}\n60 m,1,2,3\n60 m,1\n60 m\n".encode())[0] in (0, 4)

    @settings(max_examples=150, deadline=None)
    @given(st.lists(st.binary(max_size=60), max_size=20), st.booleans())
    def test_bytes_of_ndjson(self, rows: list[bytes], arrays: bool) -> None:
        status, out, _ = run(PROBE, b'{"distance":"60 ft"}\n' + b"\n".join(rows), arrays=arrays)
        assert status in (0, 4)
        for line in out.splitlines():
            json.loads(line)

    JSON = st.recursive(
        st.none() | st.booleans() | st.floats(allow_nan=False) | st.integers() | st.text(max_size=8),
        lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
        max_leaves=6,
    )
    KEYS = st.sampled_from(
        ["distance", "friction", "at", "path", "marks", "surface", "results", "error", "value", "unit"]
    )

    @settings(max_examples=200, deadline=None)
    @given(st.lists(st.dictionaries(KEYS, JSON, max_size=4), max_size=12), st.booleans())
    def test_objects(self, rows: list[dict], arrays: bool) -> None:
        lines = ['{"distance":"60 ft"}', *(json.dumps(row) for row in rows)]
        status, out, _ = run(PROBE, "\n".join(lines).encode(), arrays=arrays)
        assert status in (0, 4)
        assert len([json.loads(line) for line in out.splitlines()]) == len(lines)

    @settings(max_examples=60, deadline=None)
    @given(st.lists(st.text("0123456789.,-+eE \"'ftkm[]{}%x", max_size=12), min_size=1, max_size=150))
    def test_cells_agree(self, rows: list[str]) -> None:
        data = ("distance[ft],friction\n" + "\n".join(["60,0.7"] * 70 + [f"{row},0.5" for row in rows])).encode()
        assert run(PROBE, data) == run(PROBE, data, arrays=False)


def peak_memory(rows: int, line: bytes, *command: str) -> float:
    """Megabytes at most of a stream through the program."""
    code = (
        "import sys\nfrom dynamics_cli.cli import run_argv\nfrom dynamics_cli.core.terminal import Terminal\n"
        "status = run_argv(sys.argv[1:], Terminal(stdout=open('/dev/null', 'wb')))\n"
        # Not ru_maxrss: that begins with what the parent had when it forked.
        "peak = next(line for line in open('/proc/self/status') if line.startswith('VmHWM'))\n"
        "print(status, peak.split()[1])"
    )
    with subprocess.Popen(
        [sys.executable, "-c", code, *command, "--rows", "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        for _ in range(rows // 1000):
            process.stdin.write(line * 1000)
        process.stdin.close()
        status, size = process.stdout.read().split()
    assert status == b"0"
    return int(size) / 1024


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="needs /proc")
@pytest.mark.parametrize(
    ("line", "command"),
    [
        (b"60 mph ft/s\n", ("convert",)),
        (b'{"distance":{"value":60,"unit":"ft"},"friction":0.7}\n', ("skid", "speed")),
    ],
)
def test_memory_is_constant(line: bytes, command: tuple[str, ...]) -> None:
    small = peak_memory(200_000, line, *command)
    large = peak_memory(1_000_000, line, *command)
    assert large <= 48.0
    # How much comes at a time depends on the pipe.
    assert large - small < 10.0


@pytest.mark.skipif(sys.platform != "linux", reason="needs /proc")
def test_arrays_of_one_block_do_not_wait_for_the_end(tmp_path: Path) -> None:
    """An impact's arrays stand in circles, which only the collector frees."""
    code = (
        "import os, sys\nimport dynamics_cli.__main__\nfrom dynamics_cli.cli import main\nmain()\n"
        "peak = next(line for line in open('/proc/self/status') if line.startswith('VmHWM'))\n"
        "print(peak.split()[1], file=sys.stderr)"
    )
    rest = ["--first-mass", "1500 kg", "--first-inertia", "2500 kg*m^2", "--first-lever", "2, -0.4 m"]
    rest += ["--second-mass", "1200 kg", "--second-inertia", "1800 kg*m^2", "--second-lever", "-0.8, 0.5 m"]
    rest += ["--restitution", "0.1"]
    peaks = []
    for count in (20_000, 60_000):
        file = tmp_path / f"{count}.csv"
        rows = (f'"{5 + k % 16}, 0 m/s","0, {5 + k % 7} m/s",{k % 31} deg,0.{20 + k % 51}' for k in range(count))
        file.write_text("first_velocity,second_velocity,normal,friction\n" + "\n".join(rows) + "\n")
        command = [sys.executable, "-c", code, "impact", "planar", *rest, "--rows", str(file)]
        run_once = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=True)
        peaks.append(int(run_once.stderr.split()[-1]) / 1024.0)
    assert peaks[1] - peaks[0] < 15.0, peaks


def test_small_streams_do_without_numpy() -> None:
    code = (
        "import io, sys\nfrom dynamics_cli.cli import run_argv\nfrom dynamics_cli.core.terminal import Terminal\n"
        "run_argv(['skid', 'speed', '--rows', '-'], Terminal(stdin=io.BytesIO(b'distance[ft],friction\\n60,0.7\\n'),"
        " stdout=io.BytesIO()))\nprint({'numpy', 'msgspec', 'typer'} & set(sys.modules))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, env={**os.environ})
    assert done.stdout.strip() == b"set()"


def test_reading_waits_for_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """A raw stream that has nothing more to give ends the rows at once."""

    def waits(*_: object) -> None:
        raise AssertionError("waited for more")

    monkeypatch.setattr("time.sleep", waits)
    monkeypatch.setattr("select.select", waits)
    assert run(PROBE, b"", stdin=io.BytesIO(b"distance[ft]\n60\n"))[0] == 0
