"""Bounds that came out loose are measured by a second pass in many digits."""

from harness import answer as document_of

from dynamics_cli.core.answering.tightening import ROOM, tighten
from dynamics_cli.numerics.elementary import only_in_doubles, sqrt
from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF, Tracked
from dynamics_cli.records import record


@record
class Answer:
    """Numbers of every kind of place."""

    near_nothing: float
    table: tuple
    plain: float = 1.0
    gap: float | None = None


def nearly_cancelled(numbers):
    (x,) = numbers
    left = (x + 1.0) / 3.0 - x / 3.0 - 1.0 / 3.0
    return Answer(left, (sqrt(x) * sqrt(x) - x, x * x))


def test_a_loose_bound_becomes_tight_and_a_tight_one_stays():
    answer = nearly_cancelled(Tracked.inputs([1e6]))
    loose, square = answer.near_nothing.error, answer.table[1].error
    tighten(answer, [1e6], nearly_cancelled)
    assert answer.near_nothing.error < loose / 2
    assert answer.near_nothing.error <= 6.0 * abs(answer.near_nothing.value)
    assert answer.table[1].error == square <= ROOM * UNIT_ROUNDOFF * 1e12


def test_nothing_runs_again_where_all_bounds_are_tight():
    def once(numbers):
        assert type(numbers[0]) is not list
        return Answer(numbers[0] * 3.0, ())

    def never(numbers):
        raise AssertionError

    answer = once(Tracked.inputs([0.1]))
    tighten(answer, [0.1], never)


def test_bounds_stay_where_many_digits_refuse_or_go_another_way():
    def in_doubles(numbers):
        only_in_doubles(*numbers)
        return nearly_cancelled(numbers)

    def elsewhere(numbers):
        answer = nearly_cancelled(numbers)
        if isinstance(numbers[0], Tracked):
            return answer
        return Answer(None, answer.table[:1], gap=answer.near_nothing)

    for call in (in_doubles, elsewhere):
        answer = call(Tracked.inputs([1e6]))
        loose = answer.near_nothing.error, answer.table[0].error
        tighten(answer, [1e6], call)
        assert (answer.near_nothing.error, answer.table[0].error) == loose


def test_a_command_states_the_measured_error():
    skids = ["--test-skid", "speed=10 m/s, distance=7.3 m", "--test-skid", "speed=10 m/s, distance=7.30000000000001 m"]
    document = document_of("skid", "friction", *skids)
    deviation = document["results"]["standard_deviation"]["value"]
    bound = document["numerics"]["error_bound"]["standard_deviation"]
    assert 0.0 < bound.get("absolute", bound.get("relative", 0.0) * deviation) < 2.0 * deviation
