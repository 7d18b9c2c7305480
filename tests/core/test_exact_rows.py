"""Conversions by the million: each the nearest double to the exact ratio, and the same as its single call."""

import json
import random
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from row_helpers import run

from dynamics_cli.cli import find_task
from dynamics_cli.core.units.lookup import parse_pair
from dynamics_cli.errors import UsageError

CONVERT = find_task(["convert"])[0]
PAIRS = (
    "mph ft/s", "lb N", "lb kg", "ft m", "psi kPa", "in mm", "km/h mph", "hp kW", "deg rad", "rpm rad/s",
    "degF degC", "degC K", "K degF", "degR K", "deg rev", "ft lb J", "slug lb", "yd ft;in", "% ppm", "deg arcmin",
    "nmi mi", "Nm lbf*ft",
)  # fmt: skip


def numbers(generator: random.Random) -> str:
    """A number as people, programs and mischief write it."""
    digits = generator.choice((1, 3, 5, 15, 16, 17, 25))
    number = str(generator.randint(0, 10**digits))
    form = generator.randrange(8)
    if form < 4:
        return f"{number[:3]}.{number[3:] or 0}"
    return (number, f"-{number}", f"{number}e{generator.randint(-330, 330)}", f"0.{'0' * (digits // 2)}{number}")[
        form - 4
    ]


def text_rows(seed: int, count: int, odd: float = 0.05) -> bytes:
    generator = random.Random(seed)
    lines = []
    for _ in range(count):
        line = f"{numbers(generator)} {generator.choice(PAIRS)}"
        if generator.random() < odd:
            line = generator.choice(
                ("60mph ft/s", "60 mph kg", "60 mhp ft/s", "5 ft 6 in", '"5 ft 6 in" m', "x", "60", "60 mph",
                 "-500 degF K", "1e400 m ft", "60 mph ft/s km/h", "1_0 m ft", "60  mph ft/s", " 60 mph ft/s",
                 "60 m 'ft", "\udcff m ft")
            )  # fmt: skip
        lines.append(line)
    return "\n".join(lines).encode(errors="surrogateescape") + b"\n"


@pytest.mark.parametrize("seed", range(8))
def test_lines_agree_with_single_calls(seed: int) -> None:
    data = text_rows(seed, 1500)
    assert run(CONVERT, data) == run(CONVERT, data, arrays=False)


@pytest.mark.parametrize("form", ["csv", "ndjson"])
def test_lines_to_other_formats(form: str) -> None:
    data = text_rows(77, 800)
    assert run(CONVERT, data, format=form) == run(CONVERT, data, format=form, arrays=False)


@pytest.mark.parametrize("pair", PAIRS)
def test_fixed_pair(pair: str) -> None:
    source, _, target = pair.rpartition(" ")
    generator = random.Random(pair)
    lines = [numbers(generator) for _ in range(600)]
    for place in generator.sample(range(600), 8):
        lines[place] = generator.choice((f"6 {source}", "x", "5 kg", "", "+5", "1e999", "0", "-0.0"))
    data = "\n".join(lines).encode()
    text = run(CONVERT, data, source, target)
    assert text == run(CONVERT, data, source, target, arrays=False)
    cells = f"value[{source}]\n".encode() + data
    table = run(CONVERT, cells, target)
    assert table == run(CONVERT, cells, target, arrays=False)
    assert table[1].startswith(f"value[{source}],".encode())


def test_every_number_is_the_nearest_double() -> None:
    generator = random.Random(4)
    rational = [
        pair.split(" ")
        for pair in PAIRS
        if pair.split(" ")[0] in ("mph", "lb", "psi", "in", "km/h", "hp", "slug", "degF")
    ]
    rows = [(numbers(generator), *generator.choice(rational)) for _ in range(4000)]
    _, out, _ = run(CONVERT, "\n".join(" ".join(row) for row in rows).encode())
    checked = 0
    for (number, source, target), line in zip(rows, out.decode().split("\n"), strict=False):
        result = line.split("\t")[1]
        if not result:
            assert "error" in line
            continue
        one, other = parse_pair(source, target)
        si = Fraction(number) * Fraction(one.numerator, one.denominator) + Fraction(*one.offset)
        exact = (si - Fraction(*other.offset)) * Fraction(other.denominator, other.numerator)
        assert float(result) == exact.numerator / exact.denominator
        checked += 1
    assert checked > 3000


def test_format_of_lines() -> None:
    assert run(CONVERT, b"60 mph ft/s\n150 lb N\n")[1] == b"60 mph ft/s\t88.0\n150 lb N\t667.233242289075\n"
    assert run(CONVERT, b"60 mph ft/s km/h\n1.8796 m ft;in\n")[1].split(b"\n")[0] == b"60 mph ft/s km/h\t88.0\t96.56064"
    assert run(CONVERT, b"1.8796 m ft;in")[1].split(b"\t")[1:] == [b"6", b"2.0\n"]


def test_fixed_words() -> None:
    assert run(CONVERT, b"60\n30 km/h\n", "mph", "ft/s")[1].split(b"\n")[0] == b"60\t88.0"
    assert run(CONVERT, b"60 mph\n", "ft/s")[1] == b"60 mph\t88.0\n"
    # Of several words the first is the unit of bare numbers; the others are the units wanted.
    assert run(CONVERT, b"60\n", "mph", "ft/s", "km/h")[1] == b"60\t88.0\t96.56064\n"
    # Where no row has a bare number, all words are units wanted.
    assert run(CONVERT, b"60 mph\n", "ft/s", "km/h")[1] == b"60 mph\t88.0\t96.56064\n"
    for row in (b'{"value":60}', b'{"value":{"value":60}}', b'{"value":"60"}'):
        assert json.loads(run(CONVERT, row, "mph", "ft/s")[1])["results"]["value"]["value"] == 88.0
    status, out, _ = run(CONVERT, b"60\n", "ft/s")
    assert status == 4
    assert b"has no unit" in out


def test_csv_of_fixed_units() -> None:
    _, out, _ = run(CONVERT, b"id,value[mph]\na,60\nb,61\n", "ft/s")
    assert out == b"id,value[mph],results.value[ft/s],exact,error\na,60,88.0,true,\nb,61,89.46666666666667,false,\n"
    _, out, _ = run(CONVERT, b"value\n60 mph\n", "ft/s", "km/h", format="csv")
    assert out.startswith(b"value,")
    _, out, _ = run(CONVERT, b"value[mph]\n60\n", "ft/s", "km/h")
    assert out == b"value[mph],values[0][ft/s],values[1][km/h],exact,error\n60,88.0,96.56064,false,\n"


@pytest.mark.parametrize("arrays", [True, False])
def test_csv_of_units_in_rows(arrays: bool) -> None:
    rows = b"60 mph,ft/s\n1 kg,lb\n" * 40
    _, out, _ = run(CONVERT, b"value,targets\n" + rows, arrays=arrays)
    lines = out.split(b"\n")
    assert lines[0] == b"value,targets,results.value,value.unit,values,values.unit,exact,error"
    assert lines[1] == b"60 mph,ft/s,88.0,ft/s,,,true,"
    assert lines[2] == b"1 kg,lb,2.2046226218487757,lb,,,false,"


@pytest.mark.parametrize("arrays", [True, False])
def test_ndjson(arrays: bool) -> None:
    rows = [b'{"id":%d,"value":{"value":%d.5,"unit":"mph"},"targets":["ft/s"]}' % (i, i) for i in range(200)]
    status, out, _ = run(CONVERT, b"\n".join(rows), arrays=arrays)
    assert status == 0
    row = json.loads(out.split(b"\n")[59])
    assert row["results"] == {"value": {"value": 87.26666666666667, "unit": "ft/s"}, "exact": False}
    _, out, _ = run(CONVERT, b'{"value":"60 mph"}\n' * 100, "ft/s", "km/h", arrays=arrays)
    assert out.count(b"\n") == 100


@settings(max_examples=60, deadline=None)
@given(st.lists(st.text("0123456789.eE+- mphkgft/s;", max_size=14), min_size=1, max_size=80))
def test_any_text_agrees(rows: list[str]) -> None:
    data = "\n".join(["60 mph ft/s"] * 20 + rows).encode()
    try:
        expected = run(CONVERT, data, arrays=False)
    except UsageError:
        return
    assert run(CONVERT, data) == expected


@settings(max_examples=60, deadline=None)
@given(st.lists(st.from_regex(rb"-?[0-9]{1,18}(\.[0-9]{1,18})?([eE][+-]?[0-9]{1,3})?", fullmatch=True), min_size=5))
def test_any_number_agrees(tokens: list[bytes]) -> None:
    rows = b"\n".join(token + b" " + pair for token in tokens for pair in (b"mph ft/s", b"degF degC", b"deg rad"))
    for form in ("csv", "ndjson"):
        assert run(CONVERT, rows, format=form) == run(CONVERT, rows, format=form, arrays=False)
