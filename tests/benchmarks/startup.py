"""Start-up, as whole processes: each command in turn with its yardstick, medians of the pairwise ratios.

Run it with the Python of an environment where the package is installed (not editable), after `python -m compileall`:

    python tests/benchmarks/startup.py [PAIRS]
"""

import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

BARE_APP = '''
import typer

app = typer.Typer()


@app.command()
def speed(distance: str = "60 ft", friction: str = "0.7") -> None:
    """Speed of a skid."""
    print(distance, friction)


app()
'''
SKID = ("skid", "speed", "--distance", "60 ft", "--friction", "0.7")


def elapsed(command: list[str], env: dict[str, str]) -> float:
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=env)
    return time.perf_counter() - start


def ratio(command: list[str], yardstick: list[str], env: dict[str, str], pairs: int) -> tuple[float, float, float]:
    """Median of the pairwise ratios, ratio of the minima, and the yardstick's median time."""
    plain = dict(os.environ)
    both = [(elapsed(command, env), elapsed(yardstick, plain)) for _ in range(pairs + 2)][2:]
    ratios = [a / b for a, b in both]
    return (
        statistics.median(ratios),
        min(a for a, _ in both) / min(b for _, b in both),
        statistics.median(b for _, b in both),
    )


def main() -> None:
    pairs = int(sys.argv[1]) if len(sys.argv) > 1 else 25
    script = shutil.which("dynamics", path=str(Path(sys.executable).parent))
    if script is None:
        sys.exit("install the package into this environment first")
    with tempfile.TemporaryDirectory() as folder:
        bare = Path(folder, "bare.py")
        bare.write_text(BARE_APP)
        nothing = [sys.executable, "-c", "pass"]
        app = [sys.executable, str(bare)]
        app_help = [*app, "--help"]
        tree = {**os.environ, "DYNAMICS_ROUTE": "tree"}
        plain = dict(os.environ)
        cases = [
            ("convert 60 mph ft/s", "python -c pass", [script, "convert", "60", "mph", "ft/s"], nothing, plain, 2.2),
            ("skid speed", "python -c pass", [script, *SKID], nothing, plain, 2.8),
            ("skid speed --json", "python -c pass", [script, *SKID, "--json"], nothing, plain, 2.8),
            ("skid speed by typer", "bare typer app", [script, *SKID], app, tree, 1.3),
            ("--help", "its --help", [script, "--help"], app_help, plain, 1.3),
            ("skid --help", "its --help", [script, "skid", "--help"], app_help, plain, 1.3),
            ("skid speed --help", "its --help", [script, "skid", "speed", "--help"], app_help, plain, 1.3),
        ]
        print(f"{'command':24} {'against':16} {'median':>7} {'minima':>7} {'at most':>8}   yardstick")
        for name, against, command, yardstick, env, limit in cases:
            median, minima, size = ratio(command, yardstick, env, pairs)
            print(f"{name:24} {against:16} {median:7.2f} {minima:7.2f} {limit:8.1f}   {size * 1e3:.1f} ms")


if __name__ == "__main__":
    main()
