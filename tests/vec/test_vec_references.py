"""Every vector task against 40-digit references: its error, and the bound stated for it."""

import pytest

from dynamics_cli.accuracy.cases import load
from dynamics_cli.accuracy.catalogue import groups, questions
from dynamics_cli.accuracy.measure import errors_of

QUESTIONS = {question.task: question for question in questions("vec", "")}
# Of drawn cases, feet and sides that happen to be short beside what they are the difference of.
CANCELLING = 100.0
MOST_ULPS = 2.0


@pytest.mark.parametrize("task", QUESTIONS)
def test_errors_are_small_and_stated_bounds_hold(task: str) -> None:
    question = QUESTIONS[task]
    method = question.methods[0]
    cases = [case for case in load("vec.json") if case.task == question.cases]
    assert any(case.hard for case in cases)
    for case in cases:
        errors = errors_of(method.call(), [case], groups("vec"), tracked=True)
        assert errors.refused == 0, case.name
        assert errors.broken == 0, (case.name, errors.worst)
        assert max(errors.looseness, default=0.0) <= CANCELLING, (case.name, errors.looseness)
        assert max(errors.ulps) <= (MOST_ULPS if case.hard else CANCELLING), (case.name, errors.worst)
