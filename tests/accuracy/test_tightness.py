"""Stated bounds are true and tight on every shipped case of every question."""

import pytest

from dynamics_cli.accuracy import catalogue
from dynamics_cli.accuracy.report import Accuracy
from dynamics_cli.accuracy.rows import Row

# The most that a bound may be of max(error, 2⁻⁵³·|result|), for every result of every shipped case.
ROOM = 100.0
# Beside a parallelogram the bound covers what reading the decimals into doubles does, the reference is of the decimals.
AS_TYPED = ("linkage four-bar",)
# Bounds that are differences of two step sizes, or enclosures of extremes or of roots that lie close: how near a value
# comes by chance depends on the rounding of the processor, so that only their median is held.
BY_CHANCE = ("path rectilinear, law of acceleration", "cam size", "stability routh")
FAMILIES = sorted({question.family for question in catalogue.questions("", "")})


def proved(report: Accuracy, family: str) -> list[Row]:
    """The program's own methods that state bounds."""
    return [row for row in report.methods if row.family == family and row.is_proved]


# Estimates of uncertainty are no bounds; answers of stability are counted exactly or enclosed, and state none.
WITHOUT = ("uncertainty",)


@pytest.mark.parametrize("family", [family for family in FAMILIES if family not in WITHOUT])
def test_every_bound_is_true_and_within_a_hundred_times_the_error(family: str, untimed_report: Accuracy) -> None:
    rows = proved(untimed_report, family)
    assert rows
    assert {row.question: row.broken for row in rows if row.broken} == {}
    loosest = {row.question: row.loosest for row in rows if row.loosest is not None and row.loosest > ROOM}
    assert set(loosest) <= {*AS_TYPED, *BY_CHANCE}
    assert all(row.looseness <= ROOM for row in rows if row.looseness is not None)
    assert all(row.loosest >= row.looseness for row in rows if row.looseness is not None)


@pytest.mark.parametrize("family", WITHOUT)
def test_some_families_state_no_bounds(family: str, untimed_report: Accuracy) -> None:
    assert proved(untimed_report, family) == []
