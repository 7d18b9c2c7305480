"""No bound of a random section lies below its true error (a longer search is on demand)."""

import random

import exact_search

BODIES = 120


def test_bounds_hold() -> None:
    rng = random.Random(20)
    answered = [exact_search.short(exact_search.section, rng) for _ in range(BODIES)]
    assert [line for _, found in answered for line in found] == []
    assert sum(count > 0 for count, _ in answered) >= 0.9 * BODIES


def test_the_search_would_find_a_bound_that_is_short() -> None:
    class Own:
        value, error = 1.0, 2.0**-60

    def make(_):
        yield "area", "1.0000000000000002", Own

    assert exact_search.short(make, random.Random(1)) == (1, ["make area: off by 2.00e-16, bound 8.67e-19"])
