"""Ratios: the search against every train there is, constraints, exactness and refusals."""

import itertools
import math
import random
from fractions import Fraction

import pytest

from dynamics_cli.errors import DynamicsError
from dynamics_cli.gear.trains.ratio import RatioFound, ratio


def pairs_of(stages: str) -> list[tuple[int, int]]:
    return [tuple(map(int, stage.split(":"))) for stage in stages.split(", ")]  # type: ignore[misc]


def every_train(low: int, high: int, stages: int, keep) -> dict[Fraction, int]:
    """Each ratio there is, with the fewest teeth that give it; pairs in every order."""
    teeth = range(low, high + 1)
    pairs = [(a, b) for a in teeth for b in teeth if keep((a, b))]
    found: dict[Fraction, int] = {}
    for train in itertools.combinations_with_replacement(pairs, stages):
        value = math.prod(Fraction(b, a) for a, b in train)
        total = sum(map(sum, train))
        if keep(train) and total < found.get(value, 10**9):
            found[value] = total
    return found


def hold(answer: RatioFound, trains: dict[Fraction, int], target: Fraction) -> None:
    ranked = sorted(trains, key=lambda value: abs(value / target - 1))
    for one, wanted in zip(answer.best, ranked, strict=False):
        value = math.prod(Fraction(b, a) for a, b in pairs_of(one.stages))
        assert value == Fraction(one.ratio)
        assert value / target - 1 == Fraction(one.error)
        assert abs(Fraction(one.error)) == abs(wanted / target - 1)
        assert one.teeth == trains[value], one.stages
        assert one.error_value == float(Fraction(one.error))
    assert len(answer.best) == min(len(trains), 5)
    assert all(check.passed for check in answer.checks)


@pytest.mark.parametrize(("low", "high", "stages"), [(12, 60, 1), (12, 24, 2), (9, 15, 3), (3, 6, 4)])
def test_nothing_better_exists(low: int, high: int, stages: int) -> None:
    trains = every_train(low, high, stages, lambda _: True)
    generator = random.Random(stages)
    reach = (high / low) ** stages
    for _ in range(12):
        target = Fraction(generator.uniform(1.0 / reach, reach)).limit_denominator(10**6)
        hold(ratio(target=target.as_integer_ratio(), stages=stages, teeth=(low, high)), trains, target)
    exact = next(iter(trains))
    answer = ratio(target=exact.as_integer_ratio(), stages=stages, teeth=(low, high))
    hold(answer, trains, exact)
    assert answer.best[0].error == "0"


CONSTRAINTS = {
    "coprime": (
        {"coprime": True},
        lambda train: all(math.gcd(*pair) == 1 for pair in ([train] if isinstance(train[0], int) else train)),
    ),
    "coaxial": (
        {"coaxial": True},
        lambda train: isinstance(train[0], int) or len({sum(pair) for pair in train}) == 1,
    ),
    "tooth_sum": (
        {"tooth_sum": 40},
        lambda train: all(sum(pair) == 40 for pair in ([train] if isinstance(train[0], int) else train)),
    ),
    "largest": (
        {"largest_stage": 1.5},
        lambda train: all(max(pair) <= 1.5 * min(pair) for pair in ([train] if isinstance(train[0], int) else train)),
    ),
    "all": (
        {"coprime": True, "coaxial": True, "largest_stage": 1.8},
        lambda train: (
            all(math.gcd(*p) == 1 and max(p) <= 1.8 * min(p) for p in ([train] if isinstance(train[0], int) else train))
            and (isinstance(train[0], int) or len({sum(pair) for pair in train}) == 1)
        ),
    ),
}


@pytest.mark.parametrize("name", CONSTRAINTS)
def test_constraints_are_kept_and_nothing_better_keeps_them(name: str) -> None:
    options, keep = CONSTRAINTS[name]
    for low, high, stages in ((14, 26, 2), (16, 22, 3)):
        trains = every_train(low, high, stages, keep)
        for target in (Fraction(6, 5), Fraction(31415, 27183), Fraction(9, 10)):
            hold(ratio(target=target.as_integer_ratio(), stages=stages, teeth=(low, high), **options), trains, target)


def test_a_centre_distance_is_kept() -> None:
    answer = ratio(target=(63, 10), teeth=(17, 90), centre_distance=0.090, module=0.002)
    assert all(a + b == 90 for one in answer.best for a, b in pairs_of(one.stages))
    loose = ratio(target=(63, 10), teeth=(17, 90), centre_distance=0.090, module=0.002, distance_tolerance=0.0015)
    assert all(89 <= a + b <= 91 for one in loose.best for a, b in pairs_of(one.stages))
    assert abs(loose.best[0].error_value) <= abs(answer.best[0].error_value)


def test_drivers_and_driven_gears_may_have_ranges_of_their_own() -> None:
    answer = ratio(target=(10, 1), stages=2, teeth=(12, 20), driven_teeth=(50, 70))
    for one in answer.best:
        for a, b in pairs_of(one.stages):
            assert 12 <= a <= 20
            assert 50 <= b <= 70


def test_the_sidereal_train_and_the_convergent_of_pi() -> None:
    """11473·10²/83143: the best of 5.4·10⁹ ratios, as a search over sorted doubles finds it too."""
    answer = ratio(target=(3652422, 273217), stages=3, teeth=(12, 120))
    assert answer.best[0].ratio == "1111473/83143"
    assert answer.best[0].error_value == pytest.approx(-1.2200610847e-8, rel=1e-9)
    assert answer.considered == 73388**2
    assert ratio(target=(314159265358979, 10**14), stages=1, teeth=(17, 400)).best[0].ratio == "355/113"


def test_huge_numbers_of_the_target_stay_exact() -> None:
    """A target a hair from 2: the sign and size of the error are those of the hair."""
    hair = Fraction(2) + Fraction(1, 10**40)
    answer = ratio(target=hair.as_integer_ratio(), stages=1, teeth=(12, 40))
    assert answer.best[0].stages == "12:24"
    assert Fraction(answer.best[0].error) == 2 / hair - 1
    assert answer.best[0].error_value == float(2 / hair - 1)


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ({"target": (-3, 1)}, "ratio"),
        ({"target": (0, 1)}, "ratio"),
        ({"target": (3, 1), "stages": 0}, "stages"),
        ({"target": (3, 1), "stages": 5}, "stages"),
        ({"target": (3, 1), "teeth": (0, 9)}, "teeth"),
        ({"target": (3, 1), "teeth": (20, 10)}, "teeth"),
        ({"target": (10**9, 1)}, "out-of-reach"),
        ({"target": (1, 10**9)}, "out-of-reach"),
        ({"target": (3, 1), "count": 0}, "count"),
        ({"target": (3, 1), "stages": 4, "teeth": (12, 1000)}, "too-many"),
        ({"target": (3, 1), "centre_distance": 0.03333, "module": 0.002}, "centre-distance"),
        ({"target": (3, 1), "centre_distance": 0.03}, "module"),
        ({"target": (3, 1), "centre_distance": 0.03, "module": 0.001, "tooth_sum": 60}, "tooth-sum"),
        ({"target": (3, 1), "distance_tolerance": 0.03}, "centre-distance"),
        ({"target": (3, 1), "tooth_sum": 5}, "constraints"),
        ({"target": (1, 1), "stages": 1, "teeth": (12, 12), "coprime": True}, "constraints"),
        ({"target": (3, 1), "stages": 1, "teeth": (12, 99_999_999)}, "too-many"),
    ],
)
def test_what_cannot_be_is_refused(arguments: dict, code: str) -> None:
    with pytest.raises(DynamicsError) as caught:
        ratio(**arguments)
    assert caught.value.code == code
