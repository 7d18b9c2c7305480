"""Every hard case says why it is hard in a sentence of its own, and every family has enough of them."""

import json
import re
from collections import Counter, defaultdict
from pathlib import Path

import pytest

from dynamics_cli.accuracy.cases import DATA

FILES = sorted(DATA.glob("*.json"))
# Files whose name does not begin with their family's.
FAMILY = {"coords": "convert", "eigen": "inertia"}
LEAST = 40
# Words that say of any case that it is hard, and of none why.
EMPTY = re.compile(r"\b(hard|difficult|tricky|delicate|edge case|corner case|extreme case|challenging|ill-behaved)\b")


def hard(path: Path) -> list[dict]:
    return [case for case in json.loads(path.read_text(encoding="utf-8"))["cases"] if case["kind"] != "ordinary"]


@pytest.mark.parametrize("path", FILES, ids=[path.stem for path in FILES])
def test_every_hard_case_says_why(path: Path) -> None:
    cases = hard(path)
    assert cases
    for case in cases:
        why = case.get("why", "").strip()
        assert len(why) >= 30, (case["name"], why)
        assert len(why.split()) >= 6, (case["name"], why)
        assert not EMPTY.search(why), (case["name"], why)
        assert why.lower() != case["name"].lower()


@pytest.mark.parametrize("path", FILES, ids=[path.stem for path in FILES])
def test_one_sentence_serves_one_series(path: Path) -> None:
    """Where cases share a sentence they are of one task, and no sentence stands for a quarter of a file's hard cases.

    A series is the same difficulty at several sizes, or for each law, shape or unit; a sentence that told nothing would
    serve cases of several tasks.
    """
    cases = hard(path)
    tasks: dict[str, set[str]] = defaultdict(set)
    for case in cases:
        tasks[case["why"]].add(case["task"])
    counts = Counter(case["why"] for case in cases)
    for why, shared in tasks.items():
        assert len(shared) <= 2 or path.stem in ("coords", "skid"), why
        # slopes that cancel, and points of all six transformations, are the same wherever they come
        assert len(shared) <= 6, why
    most, count = counts.most_common(1)[0]
    assert count <= max(16, len(cases) // 4), most


@pytest.mark.parametrize("path", FILES, ids=[path.stem for path in FILES])
def test_sentences_are_many(path: Path) -> None:
    """At least a quarter as many sentences as hard cases, or fifteen."""
    cases = hard(path)
    assert len({case["why"] for case in cases}) >= min(15, len(cases) / 4)


def test_every_family_has_enough() -> None:
    counts: Counter[str] = Counter()
    for path in FILES:
        counts[FAMILY.get(path.stem, path.stem.split("_")[0])] += len(hard(path))
    for family in ("convert", "skid", "impact", "inertia", "cam", "gear", "uncertainty"):
        assert counts[family] >= LEAST, family


def test_ordinary_cases_make_no_claim() -> None:
    for path in FILES:
        for case in json.loads(path.read_text(encoding="utf-8"))["cases"]:
            assert case["kind"] in ("ordinary", "hard")
            assert case["kind"] == "hard" or not case.get("why"), case["name"]
