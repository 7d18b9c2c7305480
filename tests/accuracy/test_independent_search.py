"""Bounds of tasks that no other numbers go through, against other formulas (a longer search is on demand)."""

from fractions import Fraction

import independent_search
import pytest
from independent_search import QUESTIONS
from search_length import EVALUATIONS

FOUND: dict[str, independent_search.Findings] = {}


def found(task: str) -> independent_search.Findings:
    """What the search finds; once."""
    if task not in FOUND:
        FOUND[task] = independent_search.search(task, EVALUATIONS, 20)
    return FOUND[task]


@pytest.mark.parametrize("task", QUESTIONS)
def test_no_bound_is_below_the_error(task: str) -> None:
    made = found(task)
    assert made.broken == []
    assert made.evaluations >= EVALUATIONS
    assert made.compared >= made.evaluations


@pytest.mark.parametrize("task", QUESTIONS)
def test_bounds_are_tight_in_the_median(task: str) -> None:
    assert 0.0 < found(task).median <= 100.0


def test_a_bound_that_is_too_small_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    def halved(rng):
        for name, value, bound, exact in QUESTIONS["gear train"](rng):
            yield name, value, 0.25 * bound, exact

    monkeypatch.setitem(QUESTIONS, "halved", halved)
    made = independent_search.search("halved", 200, 1)
    assert 60 < len(made.broken) < 200


def test_decimals_are_exact() -> None:
    made = independent_search.quantity("-12.5e-3", "m")
    assert Fraction(made.numerator, made.denominator) == Fraction(-1, 80)
