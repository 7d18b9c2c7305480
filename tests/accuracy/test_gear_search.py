"""Bounds of gear tasks that no other numbers go through, against exact ones (a longer search is on demand)."""

import gear_search
import pytest
from gear_search import QUESTIONS
from search_length import EVALUATIONS

# The most that a bound may be of max(error, 2⁻⁵³·size), in the median over the search: of all results, and of each.
ROOM = 100.0
FOUND: dict[str, gear_search.Findings] = {}


def found(task: str) -> gear_search.Findings:
    """What the search finds; once."""
    if task not in FOUND:
        FOUND[task] = gear_search.search(task, EVALUATIONS, 20)
    return FOUND[task]


@pytest.mark.parametrize("task", QUESTIONS)
def test_no_bound_is_below_the_error(task: str) -> None:
    made = found(task)
    assert made.broken == []
    assert made.evaluations >= EVALUATIONS
    assert made.compared >= made.evaluations


@pytest.mark.parametrize("task", QUESTIONS)
def test_bounds_are_tight_in_the_median(task: str) -> None:
    made = found(task)
    assert 0.0 < made.median <= ROOM
    assert {name: middle for name, middle in made.medians().items() if middle > ROOM} == {}


@pytest.mark.parametrize("task", QUESTIONS)
def test_a_bound_that_is_too_small_is_found(task: str, monkeypatch: pytest.MonkeyPatch) -> None:
    draw, ask = QUESTIONS[task]

    def shrunk(inputs: gear_search.Inputs) -> tuple[int, list[gear_search.Compared]]:
        rows, compared = ask(inputs)
        return rows, [(name, value, 0.02 * bound, exact, size) for name, value, bound, exact, size in compared]

    monkeypatch.setitem(QUESTIONS, task, (draw, shrunk))
    assert len(gear_search.search(task, 300, 1).broken) > 20


def test_a_result_without_a_bound_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    draw, ask = QUESTIONS["gear data-block"]

    def bare(inputs: gear_search.Inputs) -> tuple[int, list[gear_search.Compared]]:
        rows, compared = ask(inputs)
        return rows, [(name, value, -1.0, exact, size) for name, value, _, exact, size in compared]

    monkeypatch.setitem(QUESTIONS, "gear data-block", (draw, bare))
    made = gear_search.search("gear data-block", 100, 1)
    assert len(made.broken) == made.compared


def test_hard_cases_are_where_the_search_starts() -> None:
    for task in QUESTIONS:
        assert len(gear_search.hard_cases(task)) >= 10
