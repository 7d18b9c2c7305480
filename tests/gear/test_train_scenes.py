"""Trains as scene files and on one line."""

import shlex
from pathlib import Path

from harness import answer, run

EXAMPLES = Path(__file__).parents[2] / "examples"


def test_the_ravigneaux_scene() -> None:
    """First gear, ring over small sun by hand: (short/small)·(long/short)·(ring/long) = 80/28."""
    document = answer("gear", "train", "--input", str(EXAMPLES / "ravigneaux.toml"))
    results = document["results"]
    assert results["ratio"] == "20/7"
    second = answer(
        *shlex.split("gear train --driver small --driven ring --fixed large"),
        "--input",
        str(EXAMPLES / "ravigneaux.toml"),
    )
    # by Willis with the ring turning by one: (0 − c)/(1 − c) = −80/36, then (small − c)/(1 − c) = 80/28
    arm = 80 / 116
    small = arm + 80 / 28 * (1.0 - arm)
    assert abs(second["results"]["ratio_value"]["value"] / small - 1.0) < 1e-14


def test_a_fixed_shaft_of_a_scene_can_be_changed_on_the_line() -> None:
    locked = run(
        *shlex.split("gear train --fixed carrier,ring"), "--input", str(EXAMPLES / "ravigneaux.toml"), "--json"
    )
    assert locked.status == 3
    assert locked.error["code"] == "locked"


def test_rows_of_trains() -> None:
    rows = '{"stages": "20:60"}\n{"stages": "20"}\n{"stages": "99:100, 101:100"}\n'
    done = run("gear", "train", "--rows", "-", stdin=rows)
    assert done.status == 4
    lines = done.out.splitlines()
    assert len(lines) == 3
    assert '"stage"' in lines[1]
    assert "1.000100010001" in lines[2]


def test_uncertain_sizes_of_a_gear() -> None:
    document = answer(*shlex.split('gear measure --teeth 24 --module "3 mm" --profile-shift "0.4 ± 0.01" --over 4'))
    span = document["results"]["span"]["span"]
    # 2 m sin α per unit of shift
    assert abs(span["std"] / (2 * 3 * 0.3420201433 * 0.01) - 1) < 1e-6
