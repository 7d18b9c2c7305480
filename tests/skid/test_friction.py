"""Friction from test skids: it undoes the speed from marks, and its statistics are those of the sample."""

import statistics

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.skid import friction as subject
from dynamics_cli.skid.braking import Segment, speed

FRICTION = st.floats(0.15, 1.0)
GRADE = st.floats(-0.08, 0.2)


@given(FRICTION, GRADE, st.floats(0.9, 1.0), st.floats(5.0, 50.0))
def test_friction_undoes_speed(true: float, grade: float, braking: float, length: float) -> None:
    made = speed(segments=Segment(length, true, grade, braking)).speed
    answer = subject.friction(skids=subject.TestSkid(made, length, grade, braking))
    assert answer.friction == pytest.approx(true, rel=1e-13, abs=1e-14)
    assert answer.standard_deviation is None
    assert answer.standard_error is None
    assert [advice.code for advice in answer.advice] == ["one-test-skid"]


@given(st.lists(st.floats(10.0, 16.0), min_size=2, max_size=9))
def test_statistics_are_those_of_the_sample(lengths: list[float]) -> None:
    answer = subject.friction(skids=tuple(subject.TestSkid(13.4, length) for length in lengths))
    found = [test.friction for test in answer.tests]
    assert answer.friction == pytest.approx(statistics.fmean(found), rel=1e-14)
    assert answer.standard_deviation == pytest.approx(statistics.stdev(found), rel=1e-9, abs=1e-15)
    assert answer.standard_error == pytest.approx(statistics.stdev(found) / len(found) ** 0.5, rel=1e-9, abs=1e-15)
    assert (answer.lowest, answer.highest) == (min(found), max(found))
    assert all(check.passed for check in answer.checks)


@given(st.floats(10.0, 16.0), st.integers(2, 12))
def test_equal_skids_do_not_scatter(length: float, count: int) -> None:
    answer = subject.friction(skids=(subject.TestSkid(13.4, length),) * count)
    assert answer.standard_deviation == 0.0
    assert answer.friction == answer.lowest == answer.highest
    assert not answer.advice


@given(st.permutations([11.0, 12.5, 13.0, 15.9]))
def test_order_does_not_matter(lengths: list[float]) -> None:
    answer = subject.friction(skids=tuple(subject.TestSkid(13.4, length) for length in lengths))
    assert answer.friction == pytest.approx(0.7111734, rel=1e-6)
    assert [advice.code for advice in answer.advice] == ["test-skids-scatter"]


@pytest.mark.parametrize(
    ("skid", "message"),
    [
        (subject.TestSkid(10.0, 0.0), "the distance of a skid must be more than zero"),
        (subject.TestSkid(0.0, 10.0), "the speed of a skid must be more than zero"),
        (subject.TestSkid(10.0, 10.0, 0.0, 0.0), "the braking of a test skid must be more than zero"),
        (subject.TestSkid(10.0, 50.0, 0.2), "friction would be -0.096"),
    ],
)
def test_refusals_give_the_deciding_number(skid: subject.TestSkid, message: str) -> None:
    with pytest.raises(InadmissibleError, match=message):
        subject.friction(skids=skid)
    with pytest.raises(InadmissibleError, match=r"skids\[1\]: .*" + message):
        subject.friction(skids=(subject.TestSkid(13.4, 12.9), skid))
    with pytest.raises(InadmissibleError, match="no test skid"):
        subject.friction(skids=())
