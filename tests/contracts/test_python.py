"""Use from Python: streams of cases as bytes, and partitions spread over a cluster, with the bits of single calls."""

import csv
import importlib.util
import io
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from harness import run
from shell import ROOT

import dynamics_cli
from dynamics_cli.errors import UsageError

LINES = b"".join(b"%d,0.%d,a\n" % (20 + i % 90, 3 + i % 6) for i in range(3000))
ROWS = b"distance[ft],friction,note\n" + LINES + b"-1,0.7,bad\n"


def test_rows_from_python_are_those_of_the_command() -> None:
    made = dynamics_cli.run_rows("skid speed", ROWS, "--units", "us")
    assert made.decode() == run("skid", "speed", "--units", "us", "--rows", "-", stdin=ROWS.decode()).out


def test_a_wrong_call_raises() -> None:
    with pytest.raises(UsageError, match="no column"):
        dynamics_cli.run_rows("skid speed", b"weight,height\n1,2\n")
    with pytest.raises(UsageError):
        dynamics_cli.run_rows("skid leap", ROWS)


@pytest.mark.slow
@pytest.mark.parametrize("form", ["csv", "parquet"])
def test_partitions_on_a_cluster_give_the_same_numbers(form: str, tmp_path: Path) -> None:
    for name in ("dask", "distributed", "pandas", "pyarrow"):
        if importlib.util.find_spec(name) is None:
            pytest.skip(f"{name} is not installed")
    head, *lines = ROWS.decode().splitlines(keepends=True)
    parts = [head + "".join(lines[start::3]) for start in range(3)]
    files = []
    for nth, part in enumerate(parts):
        file = tmp_path / f"part-{nth}.{form}"
        files.append(str(file))
        if form == "csv":
            file.write_text(part)
        else:
            import pandas

            pandas.read_csv(io.StringIO(part)).to_parquet(file)
    script = ROOT / "examples" / "partitions" / "dask_rows.py"
    done = subprocess.run(
        [sys.executable, str(script), "skid speed", str(tmp_path / "out"), *files],
        capture_output=True, text=True, check=False, cwd=ROOT,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    for nth, part in enumerate(parts):
        alone = dynamics_cli.run_rows("skid speed", part.encode())
        made = tmp_path / "out" / f"part-{nth}.{form}"
        if form == "csv":
            assert made.read_bytes() == alone
        else:
            from pyarrow import parquet

            for found, expected in zip(
                parquet.read_table(made).to_pylist(), csv.DictReader(io.StringIO(alone.decode())), strict=True
            ):
                for name, text in expected.items():
                    value = found[name]
                    # An empty cell is an empty text or, in a column of numbers, none.
                    assert ("" if value is None else value) == (float(text) if isinstance(value, int | float) else text)


@pytest.mark.parametrize(
    "option", [{"output": "a.json"}, {"rows": "-"}, {"format": "json"}, {"json": True}, {"digits": 3}, {"plot": "-"}]
)
def test_options_that_a_function_cannot_honour_are_refused(option: dict[str, object]) -> None:
    with pytest.raises(UsageError, match="option of the command line only"):
        dynamics_cli.run("skid speed", distance="60 ft", friction=0.7, **option)


@pytest.mark.parametrize("option", [{"explain": "no"}, {"units": True}, {"samples": [1]}, {"to": {"speed": "mph"}}])
def test_options_of_another_type_are_refused(option: dict[str, object]) -> None:
    with pytest.raises(UsageError):
        dynamics_cli.run("skid speed", distance="60 ft", friction=0.7, **option)


def test_input_and_sweep_mean_what_the_options_do(tmp_path: Path) -> None:
    file = tmp_path / "scene.toml"
    file.write_text('distance = "60 ft"\nfriction = 0.5\n')
    made = dynamics_cli.run("skid speed", input=str(file), friction=0.7, limit="50 mph")
    argv = ("skid", "speed", "--input", str(file), "--friction", "0.7", "--limit", "50 mph")
    assert made == run(*argv, "--json").document
    swept = dynamics_cli.run("skid speed", distance="60 ft", sweep="friction=0.3:0.9:7", jobs=1)
    argv = ("skid", "speed", "--distance", "60 ft", "--sweep", "friction=0.3:0.9:7")
    assert swept == run(*argv, "--json").document


def test_numbers_of_numpy_are_numbers() -> None:
    plain = dynamics_cli.run("skid speed", distance={"value": 60, "unit": "ft"}, friction=0.7)
    numbers = {"distance": {"value": np.int64(60), "unit": "ft"}, "friction": np.float64(0.7)}
    assert dynamics_cli.run("skid speed", **numbers) == plain
    single = dynamics_cli.run("skid speed", distance="60 ft", friction=np.float32(0.5))
    assert single == dynamics_cli.run("skid speed", distance="60 ft", friction=0.5)
    readings = np.array([0.71, 0.74, 0.70])
    assert dynamics_cli.run("skid speed", distance="60 ft", friction=readings) == dynamics_cli.run(
        "skid speed", distance="60 ft", friction=(0.71, 0.74, 0.70)
    )
    with pytest.raises(UsageError, match="range of a double"):
        dynamics_cli.run("skid speed", distance="60 ft", friction=10**5000)
