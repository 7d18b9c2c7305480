"""Every vibration task against 40-digit references: its error, and the bound stated for it."""

import pytest

from dynamics_cli.accuracy.cases import load
from dynamics_cli.accuracy.catalogue import groups, questions
from dynamics_cli.accuracy.measure import errors_of
from dynamics_cli.accuracy.questions import Question

QUESTIONS = {one.task: one for one in questions("vibration", "") if isinstance(one, Question)}
# Half last bits of ordinary cases; what hard ones lose is in their bounds.
MOST_ULPS = 12.0
# A displacement at a time may be a small part of the swing.
SWINGS = ("free",)
# A bound over the error, or over half a last bit.
LOOSE = 100.0


@pytest.mark.parametrize("task", QUESTIONS)
def test_errors_are_small_and_stated_bounds_hold(task: str) -> None:
    question = QUESTIONS[task]
    method = question.methods[0]
    cases = [case for case in load("vibration.json") if case.task == question.cases]
    assert cases
    for case in cases:
        errors = errors_of(method.call(), [case], groups("vibration"), tracked=method.tracked)
        assert errors.refused == 0, case.name
        assert errors.broken == 0, (case.name, errors.worst)
        assert max(errors.looseness, default=0.0) <= LOOSE, (case.name, errors.looseness)
        assert case.hard or task in SWINGS or max(errors.ulps) <= MOST_ULPS, (case.name, errors.worst)
