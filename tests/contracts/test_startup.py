"""What a plain call may load, and generous bounds on what it may cost."""

import shlex
import subprocess
import sys
import time
from pathlib import Path

import pytest

from dynamics_cli import cli

ROOT = Path(__file__).parents[2]
HEAVY = (  # noqa: SIM905
    "typing re json dataclasses inspect fractions decimal enum numpy pint typer click rich msgspec scipy pydantic "
    "argparse difflib tomllib hashlib contextlib"
).split()
CONVERT = ["convert", "60", "mph", "ft/s"]
SKID = ["skid", "speed", "--distance", "60 ft", "--friction", "0.7"]
# Every documented example of a task that needs no array.
PLAIN = [
    shlex.split(example)[1:]
    for name in ("convert", "coords", "skid")
    for task in cli.family(name).tasks.values()
    for example in task.examples
    if "--rows" not in example
]
# Examples with a result near nothing, whose rounding bound takes a second pass in many digits.
MEASURED = ("friction --test-skid", "avoid --speed 62 km/h", "meet ", "follow ")
CODE = """
import sys
sys.path.insert(0, {root!r})
from dynamics_cli.cli import main
sys.argv = ["dynamics", *{argv!r}]
status = main()
print(*sorted(set(sys.modules) & set({heavy!r})), file=sys.stderr)
sys.exit(status)
"""


@pytest.mark.parametrize("argv", PLAIN, ids=" ".join)
def test_a_plain_call_loads_nothing_heavy(argv: list[str]) -> None:
    code = CODE.format(root=str(ROOT), argv=argv, heavy=HEAVY)
    done = subprocess.run([sys.executable, "-I", "-S", "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    measured = " ".join(argv[1:]).startswith(MEASURED)
    assert set(done.stderr.split()) <= ({"decimal"} if measured else set())


@pytest.mark.parametrize("argv", [["--help"], ["skid", "--help"], ["skid", "speed", "--help"]], ids=" ".join)
def test_help_loads_no_numerical_library(argv: list[str]) -> None:
    code = CODE.format(root=str(ROOT), argv=argv, heavy=["numpy", "pint", "scipy", "pydantic", "rich", "msgspec"])
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stderr.split() == []


def test_listing_the_families_imports_none_of_them() -> None:
    code = CODE.format(root=str(ROOT), argv=["--help"], heavy=["dynamics_cli.skid", "dynamics_cli.convert"])
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stderr.split() == []


def test_importing_the_package_is_nearly_free() -> None:
    code = "import time; t = time.perf_counter(); import dynamics_cli; print(time.perf_counter() - t)"
    times = [
        float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT).stdout)
        for _ in range(5)
    ]
    assert min(times) < 0.005


@pytest.mark.parametrize(("argv", "limit"), [(CONVERT, 3.0), (SKID, 3.5)], ids=["convert", "skid speed"])
def test_a_plain_call_costs_little_more_than_the_interpreter(argv: list[str], limit: float) -> None:
    """Generous: `tests/benchmarks/startup.py` measures the real ratios."""
    code = f"import sys; sys.argv = ['dynamics', *{argv!r}]; from dynamics_cli.cli import main; main()"

    def fastest(source: str) -> float:
        times = []
        for _ in range(12):
            start = time.perf_counter()
            subprocess.run([sys.executable, "-c", source], check=True, stdout=subprocess.DEVNULL, cwd=ROOT)
            times.append(time.perf_counter() - start)
        return min(times)

    fastest(code)
    assert fastest(code) / fastest("pass") < limit
