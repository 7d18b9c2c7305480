"""A result against a limit: decided only where the result's error bound allows it."""

import math
from decimal import Decimal, localcontext

import pytest
from harness import answer, run

STOP = ("skid", "speed", "--distance", "30 m", "--friction", "0.7")
with localcontext(prec=40):
    SPEED = (2 * Decimal("9.80665") * 30 * Decimal("0.7")).sqrt()


@pytest.mark.parametrize("ulps", [-2, -1, 0, 1, 2])
def test_a_limit_within_the_error_bound_is_not_decided(ulps: int) -> None:
    limit = float(SPEED) + ulps * math.ulp(float(SPEED))
    (entry,) = answer(*STOP, "--limit", f"{limit!r} m/s")["limits"]
    assert entry["undecided"] is True
    assert "at the limit" in entry["message"]
    assert "error bound" in entry["message"]


@pytest.mark.parametrize(("share", "beyond"), [("1.00000000000001", False), ("0.99999999999999", True)])
def test_a_limit_just_outside_the_error_bound_is_decided(share: str, beyond: bool) -> None:
    (entry,) = answer(*STOP, "--limit", f"{SPEED * Decimal(share)} m/s")["limits"]
    assert "undecided" not in entry
    assert entry["beyond"] is beyond


def test_the_distance_to_a_limit_is_in_one_unit() -> None:
    outcome = run(*STOP, "--to", "total_distance=ft;in", "--limit", "total_distance=100 ft")
    assert outcome.status == 0, outcome.err
    (line,) = [line for line in outcome.out.splitlines() if "the limit of" in line]
    assert line.endswith(" in")
    assert "ft;in" not in line
