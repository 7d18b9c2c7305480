"""The junction of trochoid and involute: both sides of the limit of undercut, bounds, derivatives, refusals."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.gear.single.flanks import trochoid_points
from dynamics_cli.gear.single.trochoid import SERIES_LIMIT, Cutter, roll_less_arc, root
from dynamics_cli.numerics.tracked import Tracked

TWENTY = math.radians(20.0)


@given(st.floats(-3.0, 3.0))
def test_roll_less_arc_is_odd_and_true(t: float) -> None:
    assert roll_less_arc(-t) == -roll_less_arc(t)
    if abs(t) > 0.1:
        assert roll_less_arc(t) == pytest.approx(t - math.atan(t), rel=1e-13)
    else:
        assert roll_less_arc(t) == pytest.approx(t**3 / 3 - t**5 / 5 + t**7 / 7 - t**9 / 9, rel=1e-8, abs=5e-324)


def test_both_sides_of_the_series() -> None:
    below, above = math.nextafter(SERIES_LIMIT, 0.0), SERIES_LIMIT
    assert roll_less_arc(below) == pytest.approx(roll_less_arc(above), rel=3e-15)


@given(st.integers(5, 400), st.floats(-3.0, 1.0), st.floats(0.0, 1.0), st.floats(0.0, 0.45))
def test_the_junction_lies_on_both_curves(teeth: int, x: float, beta: float, rho: float) -> None:
    cutter = Cutter(teeth, TWENTY, beta, x, 1.25, rho)
    if cutter.root_radius <= 0.05:
        return
    found = root(cutter)
    radius, angle, _ = trochoid_points(cutter, found.direction)
    assert radius == pytest.approx(found.form_radius, rel=1e-13)
    assert angle == pytest.approx(
        cutter.space_half_angle + roll_less_arc(found.roll), abs=2e-15 * (1 + abs(angle) * 30)
    )
    assert found.form_radius == pytest.approx(cutter.base_radius * math.sqrt(1 + found.roll**2), rel=1e-13)
    assert found.undercut == (found.margin < 0.0)


@given(st.integers(6, 60))
def test_the_limit_of_undercut_is_met_from_both_sides(teeth: int) -> None:
    """x_min = h_F − z sin²α/2, h_F = 1.00003 here; the form radius falls to the base circle from both sides."""
    limit = Cutter(teeth, TWENTY).form_depth - 0.5 * teeth * math.sin(TWENTY) ** 2
    for step in (1e-3, 1e-6, 1e-9):
        over, under = (root(Cutter(teeth, TWENTY, 0.0, limit + side * step)) for side in (1, -1))
        assert not over.undercut
        assert under.undercut
        base = Cutter(teeth, TWENTY).base_radius
        assert 0.0 <= over.form_radius / base - 1.0 <= 20.0 * step**2 + 4e-16
        assert 0.0 <= under.form_radius / base - 1.0 <= 20.0 * step**2 + 4e-16


@pytest.mark.parametrize("values", [(12, 0.0, 0.0), (9, -0.3, 0.3), (17, -0.01, 0.0), (30, -2.0, 0.2), (40, 0.5, 0.0)])
def test_derivatives_through_the_root(values: tuple[int, float, float]) -> None:
    teeth, x, beta = values
    inputs = [TWENTY, beta, x, 1.25, 0.38]
    own = root(Cutter(teeth, *Tracked.inputs(inputs))).form_radius
    for index in range(5):
        if index == 1 and beta == 0.0:
            continue
        step = 1e-6
        ends = []
        for side in (1, -1):
            moved = list(inputs)
            moved[index] += side * step
            ends.append(root(Cutter(teeth, *moved)).form_radius)
        assert own.slopes[index] == pytest.approx((ends[0] - ends[1]) / (2 * step), rel=1e-5, abs=1e-7)


def test_more_undercut_with_fewer_teeth_and_less_shift() -> None:
    share = [root(Cutter(z, TWENTY)).form_radius / Cutter(z, TWENTY).base_radius for z in range(5, 17)]
    assert share == sorted(share, reverse=True)
    by_shift = [root(Cutter(12, TWENTY, 0.0, x / 10)).form_radius for x in range(-20, 3)]
    assert by_shift == sorted(by_shift, reverse=True)


@pytest.mark.parametrize(
    ("cutter", "code"),
    [
        (Cutter(30, TWENTY, 0.0, 0.0, 1.25, 0.5), "tip-radius"),
        (Cutter(30, TWENTY, 0.0, 0.0, 2.3, 0.0), "tip-radius"),
        (Cutter(5, TWENTY, 0.0, -1.3), "no-root"),
    ],
)
def test_no_rack_no_root(cutter: Cutter, code: str) -> None:
    with pytest.raises(InadmissibleError) as caught:
        root(cutter)
    assert caught.value.code == code
