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


def test_shafts_are_named_as_they_were_written() -> None:
    """A Ravigneaux set names its planets P and p; each letter is a shaft of its own."""
    meshes = (
        "first=s, first_teeth=30, second=p, second_teeth=20, carrier=C",
        "first=p, first_teeth=20, second=P, second_teeth=25, carrier=C",
        "first=P, first_teeth=25, second=c, second_teeth=90, carrier=C, internal=true",
    )
    words = [word for mesh in meshes for word in ("--mesh", mesh)]
    results = answer("gear", "train", *words, "--driver", "s", "--driven", "C", "--fixed", "c")["results"]
    assert [one["name"] for one in results["shafts"]] == ["s", "p", "C", "P", "c"]
    # the carrier held, sun to ring is 30/90 with two external meshes: i0 = z_c/z_s, and i = 1 - i0
    assert results["ratio"] == "-2"
    refused = run("gear", "train", *words, "--driver", "S", "--driven", "C", "--fixed", "c")
    assert refused.status != 0
    assert "there is no shaft 'S'" in refused.err


def test_the_frame_may_be_written_in_any_case() -> None:
    words = ("--mesh", "first=A, first_teeth=20, second=a, second_teeth=50, carrier=Frame")
    results = answer("gear", "train", *words, "--driver", "A", "--driven", "a")["results"]
    assert (results["freedom"]["value"], results["ratio"]) == (1, "-5/2")


def test_a_flag_is_written_in_a_repeated_group() -> None:
    """Text says a flag as a cell of a table does; a number or another word is refused by name."""
    mesh = "first=a, first_teeth=20, second=b, second_teeth=80, internal="
    for word, ratio in (("true", "4"), ("YES", "4"), ("1", "4"), ("no", "-4"), ("false", "-4"), ("0", "-4")):
        found = answer("gear", "train", "--mesh", mesh + word, "--driver", "a", "--driven", "b")
        assert found["results"]["ratio"] == ratio
    refused = run("gear", "train", "--mesh", mesh + "perhaps", "--driver", "a", "--driven", "b")
    assert refused.status == 2
    assert "--mesh: internal: read 'perhaps', wanted true or false" in refused.err


def test_stages_stand_apart_by_commas_or_blanks() -> None:
    for stages in ("20:60,18:54", "20:60 18 : 54", "20 : 60; 18:54"):
        assert answer("gear", "train", "--stages", stages)["results"]["ratio"] == "9"
    assert run("gear", "train", "--stages", "20 60, 18:54").status == 3
