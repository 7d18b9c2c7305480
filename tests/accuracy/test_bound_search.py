"""No stated bound is below the true error, from whatever start inputs are disturbed (a longer search is on demand)."""

import bound_search
import pytest
import search_starts
from search_length import evaluations

STARTS = bound_search.by_task()

# The most that a bound may be of max(error, 2⁻⁵³·|result|), in the median over the search.
ROOM = 100.0
FOUND: dict[str, bound_search.Findings] = {}


def found(task: str) -> bound_search.Findings:
    """What the search finds; once."""
    if task not in FOUND:
        FOUND[task] = bound_search.search(task, STARTS[task], evaluations(task), 20)
    return FOUND[task]


@pytest.mark.parametrize("task", STARTS)
def test_no_bound_is_below_the_error(task: str) -> None:
    made = found(task)
    assert made.broken == []
    assert made.answered >= evaluations(task)
    assert made.compared > made.answered


@pytest.mark.parametrize("task", STARTS)
def test_bounds_are_tight_in_the_median(task: str) -> None:
    made = found(task)
    assert made.looseness
    assert made.median <= ROOM
    assert made.loose() == {}


@pytest.mark.parametrize("task", STARTS)
def test_floats_give_the_bits_of_tracked_numbers(task: str) -> None:
    assert found(task).unlike == []


def test_every_tracked_task_is_searched() -> None:
    tasks = {task.path for task in search_starts.tracked_tasks()}
    assert tasks - set(STARTS) == {*search_starts.ARRAYS_ONLY, *search_starts.OTHERWISE}


def test_a_bound_that_is_too_small_is_found() -> None:
    """The search itself: a formula whose bound leaves one rounding out."""
    from dynamics_cli.numerics.tracked import Tracked
    from dynamics_cli.records import record

    @record
    class Answer:
        third: float

    def call(numbers: list) -> Answer:
        third = numbers[0] / 3.0
        if isinstance(third, Tracked):
            third.error *= 0.5
        return Answer(third)

    start = search_starts.Start("toy", "a third", [1.0], [None], call)
    made = bound_search.search("toy", [start], 200, 1)
    assert 20 < len(made.broken) < 190
    assert made.unlike == []


def test_floats_that_go_another_way_are_found() -> None:
    from dynamics_cli.records import record

    @record
    class Answer:
        half: float

    start = search_starts.Start(
        "toy", "a half", [1.0], [None], lambda own: Answer(own[0] * (0.5 if isinstance(own[0], float) else 0.25))
    )
    made = bound_search.search("toy", [start], 40, 1)
    assert len(made.unlike) >= 40 // bound_search.FLOATS_EVERY


def test_disturbed_numbers_stay_within_their_kinds() -> None:
    import random

    for start in STARTS["skid yaw"] + STARTS["inertia tensor"]:
        rng = random.Random(3)
        for _ in range(50):
            numbers = bound_search.disturbed(rng, start, start.numbers)
            for kind, number in zip(start.kinds, numbers, strict=True):
                assert kind is None or kind.outside(number) is None
            for index, kind in enumerate(start.kinds):
                if kind is not None and kind.form == "tensor":
                    place = bound_search.tensor_place(start, index)
                    twin = index - place + 3 * (place % 3) + place // 3
                    assert numbers[index] == numbers[twin]
