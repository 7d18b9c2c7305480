"""Every hard case says why it is hard, and every family has enough of them."""

import json
from collections import Counter
from pathlib import Path

import pytest

from dynamics_cli.accuracy.cases import DATA

FILES = sorted(DATA.glob("*.json"))
# Files whose name does not begin with their family's.
FAMILY = {"coords": "convert", "eigen": "inertia"}
LEAST = 40


def hard(path: Path) -> list[dict]:
    return [case for case in json.loads(path.read_text(encoding="utf-8"))["cases"] if case["kind"] != "ordinary"]


@pytest.mark.parametrize("path", FILES, ids=[path.stem for path in FILES])
def test_every_hard_case_says_why(path: Path) -> None:
    cases = hard(path)
    assert cases
    for case in cases:
        why = case.get("why", "").strip()
        assert len(why) >= 8, case["name"]
        assert " " in why, case["name"]
        assert why.lower() not in ("hard", "a hard case", case["name"].lower()), case["name"]


@pytest.mark.parametrize("path", FILES, ids=[path.stem for path in FILES])
def test_reasons_are_of_the_case(path: Path) -> None:
    """No one sentence stands for most of a file's hard cases."""
    cases = hard(path)
    counts = Counter(case["why"] for case in cases)
    assert counts.most_common(1)[0][1] <= max(30, 0.6 * len(cases))


def test_every_family_has_enough() -> None:
    counts: Counter[str] = Counter()
    for path in FILES:
        counts[FAMILY.get(path.stem, path.stem.split("_")[0])] += len(hard(path))
    for family in ("convert", "skid", "impact", "inertia", "cam", "gear"):
        assert counts[family] >= LEAST, family


def test_ordinary_cases_make_no_claim() -> None:
    for path in FILES:
        for case in json.loads(path.read_text(encoding="utf-8"))["cases"]:
            assert case["kind"] in ("ordinary", "hard")
            assert case["kind"] == "hard" or not case.get("why"), case["name"]
