"""The two returns of a law, and polynomials: those that come back to where they began, and their digits."""

import random
from fractions import Fraction
from math import pi, prod, sin

import pytest

from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.polynomials import polynomial
from dynamics_cli.cam.laws.rise import rise
from dynamics_cli.cam.laws.selection import Condition
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.errors import InadmissibleError

NAMED = [name for name in LawName.names if name not in ("scca", "polynomial", "spline")]


@pytest.mark.parametrize("name", NAMED)
def test_a_falling_rise_is_the_return_of_cam_motion(name: str) -> None:
    turn = motion_of(Program(), f"rise 15 mm in 60 deg; dwell 100 deg; return in 60 deg {name}; dwell")
    start, end = turn.joints[2:4]
    # places at which no law has a joint
    angles = tuple((end - start) * k / 23 for k in range(1, 23))
    found = rise(law=LawName(name), lift=0.015, span=end - start, at=angles, falling=True)
    for angle, point in zip(angles, found.points, strict=True):
        values = (point.lift, point.velocity, point.acceleration, point.jerk)
        for value, wanted, size in zip(values, turn.at(start + angle), (0.015, 0.05, 0.5, 5.0), strict=True):
            assert value == pytest.approx(wanted, rel=1e-9, abs=1e-11 * size)


def test_both_returns_of_a_half_cycloid_by_its_closed_form() -> None:
    # f(¼) = ¼ − sin(π/4)/π
    quarter = 0.25 - sin(0.25 * pi) / pi
    back = 0.75 - sin(0.75 * pi) / pi
    for name, share in (("falling", 1.0 - quarter), ("mirrored", back)):
        found = rise(law=LawName("half-cycloid-start"), lift=0.015, span=pi / 3, at=(pi / 12,), **{name: True})
        assert found.points[0].lift == pytest.approx(0.015 * share, rel=1e-15)
        assert [one.code for one in found.advice] == ["return"]
    # the acceleration of 3-4-5 is as great near either end: the first in the order of the cam angle is named
    ways = [
        rise(law=LawName("3-4-5"), lift=0.015, span=1.0, **more) for more in ({}, {"falling": True}, {"mirrored": True})
    ]
    assert len({(way.peak_acceleration_at < 0.5) for way in ways}) == 1
    with pytest.raises(InadmissibleError, match="either falling or mirrored"):
        rise(law=LawName("cubic"), lift=0.015, span=1.0, falling=True, mirrored=True)
    assert not rise(law=LawName("3-4-5"), lift=0.015, span=1.0, falling=True).advice


def test_a_polynomial_that_comes_back_is_answered() -> None:
    # 16 x²(1 − x)² is what a lobe of single dwell does
    ends = [Condition(x, lift=0.0, velocity=0.0) for x in (0.0, 1.0)]
    found = rise(
        law=LawName("polynomial"), lift=0.01, span=1.0, at=(0.0, 0.3, 0.5, 0.8, 1.0),
        conditions=(ends[0], Condition(0.5, lift=1.0), ends[1]),
    )  # fmt: skip
    for point in found.points:
        x = Fraction(point.angle)
        assert point.lift == pytest.approx(float(16 * x * x * (1 - x) ** 2) * 0.01, rel=1e-15, abs=1e-18)
    assert found.points[-1].lift == found.points[-1].velocity == 0.0
    assert all(check.passed for check in found.checks)


def exact_polynomial(conditions: list[tuple[float, int, float]]) -> list[Fraction]:
    """Coefficients by elimination in rationals."""
    count = len(conditions)
    rows = [
        [Fraction(x) ** (i - k) * prod(range(i - k + 1, i + 1)) if i >= k else Fraction(0) for i in range(count)]
        + [Fraction(value)]
        for x, k, value in conditions
    ]
    for column in range(count):
        pivot = next(row for row in rows[column:] if row[column])
        rows.remove(pivot)
        rows.insert(column, [value / pivot[column] for value in pivot])
        for i in range(count):
            if i != column:
                rows[i] = [a - rows[i][column] * b for a, b in zip(rows[i], rows[column], strict=True)]
    return [row[-1] for row in rows]


@pytest.mark.parametrize("seed", range(12))
def test_polynomials_keep_their_digits_at_mid_span(seed: int) -> None:
    chance = random.Random(seed)
    conditions = [(0.0, 0, 0.0), (1.0, 0, chance.choice((0.0, 1.0, 0.3)))]
    for order in range(1, chance.randint(3, 5)):
        conditions += [(end, order, chance.uniform(-3.0, 3.0) if order > 1 else 0.0) for end in (0.0, 1.0)]
    law, coefficients = polynomial(conditions), exact_polynomial(conditions)
    places = [k / 64 for k in range(65)]
    peaks = [max(abs(law.at(x, 3)[order]) for x in places) for order in range(4)]
    for x in places:
        for order, value in enumerate(law.at(x, 3)):
            exact = sum(
                c * prod(range(i - order + 1, i + 1)) * Fraction(x) ** (i - order)
                for i, c in enumerate(coefficients)
                if i >= order
            )
            error = abs(Fraction(value) - exact)
            assert error <= (4.0, 8.0, 12.0, 16.0)[order] * 2.0**-53 * peaks[order]


def test_a_rise_of_more_than_one_turn_is_refused() -> None:
    with pytest.raises(InadmissibleError, match=r"span of 6.981 rad is more than one turn"):
        rise(law=LawName("3-4-5"), lift=0.01, span=400.0 * pi / 180.0)
    assert rise(law=LawName("3-4-5"), lift=0.01, span=2.0 * pi).points[-1].lift == 0.01
