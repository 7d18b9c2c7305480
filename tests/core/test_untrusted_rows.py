"""Rows from strangers: what they may read, what a spreadsheet makes of what is written, and odd line ends."""

import csv
import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest
from harness import answer, run

import dynamics_cli

SPEED = ("skid", "speed", "--rows", "-")


@pytest.fixture
def earlier(tmp_path: Path) -> str:
    file = tmp_path / "first.json"
    file.write_text(json.dumps(answer("skid", "speed", "--distance", "60 ft", "--friction", "0.7")))
    return str(file)


def test_rows_read_no_files_unless_they_are_allowed_to(earlier: str) -> None:
    name = f"@{earlier}:total_distance"
    for row in (f'{{"distance": "{name}", "friction": 0.7}}\n', f"distance,friction\n{name},0.7\n"):
        refused = run(*SPEED, "--format", "ndjson", stdin=row)
        assert refused.status == 4
        assert "--references" in json.loads(refused.out)["error"]["hint"]
        assert "total_distance" not in json.loads(refused.out).get("results", {})
        allowed = run(*SPEED, "--format", "ndjson", "--references", stdin=row)
        assert allowed.status == 0, allowed.out
        assert json.loads(allowed.out)["results"]["total_distance"]["value"] == pytest.approx(18.288)
    assert run("skid", "speed", "--distance", "1 m", "--friction", "0.7", "--references").status == 2


def test_the_call_itself_may_refer_to_files(earlier: str) -> None:
    outcome = run(*SPEED, "--distance", f"@{earlier}:total_distance", stdin='{"friction": 0.7}\n')
    assert outcome.status == 0, outcome.out
    listed = run(*SPEED, stdin=f'{{"distance": "3 m", "friction": "@{earlier}:speed"}}\n')
    assert listed.status == 4


@pytest.mark.parametrize(
    ("text", "cell"),
    [
        ('=HYPERLINK("http://x")', '"\'=HYPERLINK(""http://x"")"'),
        ("@SUM(1)", "'@SUM(1)"), ("+cmd|' /C calc'!A0", "'+cmd|' /C calc'!A0"),
        ("-2+3+cmd|' /C calc'!A0", "'-2+3+cmd|' /C calc'!A0"),
        ("-", "'-"), ("-x", "'-x"), ("-3", "-3"), ("-3.5e-7", "-3.5e-7"), ("-3 m", "-3 m"), ("+40 degC", "+40 degC"),
        ("-3 ± 0.5 %", "-3 ± 0.5 %"), ("plain", "plain"), ("a=b", "a=b"), ("", ""),
    ],
)  # fmt: skip
def test_text_that_a_spreadsheet_would_carry_out_is_quoted(text: str, cell: str) -> None:
    row = json.dumps({"id": text, "distance": "3 m", "friction": 0.7}, ensure_ascii=False)
    out = run(*SPEED, "--format", "csv", stdin=row + "\n").out
    assert out.splitlines()[1].startswith(cell + ",")
    # The next step of a pipe reads what was meant.
    again = json.loads(run(*SPEED, "--format", "ndjson", stdin=out).out)
    assert again.get("id", "") == text


def test_numbers_stay_numbers() -> None:
    rows = "".join(f'{{"distance": "{n} m", "friction": 0.7, "grade": "{-n} %", "id": {-n}}}\n' for n in range(1, 4))
    for cells in csv.DictReader(run(*SPEED, "--format", "csv", stdin=rows).out.splitlines()):
        assert float(cells["id"]) < 0.0


def test_carriage_returns_alone_are_no_line_ends() -> None:
    outcome = run(*SPEED, stdin=b"distance,friction\r3 m,0.7\r4 m,0.7\r")
    assert outcome.status == 2
    assert "carriage returns" in outcome.err
    assert run(*SPEED, stdin=b"distance,friction\r\n3 m,0.7\r\n").status == 0


def test_the_table_of_units_is_there_in_a_zipapp(tmp_path: Path) -> None:
    package = Path(dynamics_cli.__file__).parent
    archive = tmp_path / "dynamics.pyz"
    with zipfile.ZipFile(archive, "w") as file:
        for path in package.rglob("*"):
            if path.suffix in (".py", ".csv") and path.is_file():
                file.write(path, str(path.relative_to(package.parent)))
    script = "import sys; sys.path.insert(0, sys.argv.pop(1)); from dynamics_cli import cli; sys.exit(cli.main())"
    environ: dict[str, Any] = {**os.environ, "PYTHONPATH": ""}
    done = subprocess.run(
        [sys.executable, "-c", script, str(archive), "units", "table", "book", "--json"],
        capture_output=True, text=True, check=False, env=environ, cwd=tmp_path,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == answer("units", "table", "book")
