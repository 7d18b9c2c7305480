"""The stated error of uncertain results holds on fresh random problems; `coverage_experiment.py` runs many more."""

import pytest
from coverage_experiment import KINDS, experiment


@pytest.mark.parametrize("kind", [kind for kind in KINDS if "kinked" not in kind])
def test_the_estimate_holds(kind: str) -> None:
    held, met, _, _ = experiment(kind, 24)
    # At 95 % each, four or more failures of 24 happen once in thirty such tests by chance.
    assert held >= 20 / 24
    assert met >= 22 / 24


def test_the_estimate_holds_at_kinks() -> None:
    held, met, _, _ = experiment("impact, kinked", 4)
    assert held >= 0.75
    assert met >= 0.75
