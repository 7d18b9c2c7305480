"""The table of a slider-crank or a four-bar at a given speed is the pose at each of its angles."""

import math

import numpy as np
import pytest

from dynamics_cli.linkage.fourbar.four_bar import four_bar
from dynamics_cli.linkage.sliders.slider_crank import slider_crank
from dynamics_cli.linkage.sliders.stroke import End

LENGTHS = {"crank": 0.05, "rod": 0.15, "offset": 0.02}


def test_a_speed_gives_velocities_and_accelerations() -> None:
    turning = {"speed": 300.0, "angular_acceleration": -4000.0}
    rows = slider_crank(**LENGTHS, **turning).table
    assert rows is not None
    for row in rows:
        pose = slider_crank(**LENGTHS, **turning, crank_angle=row.crank_angle)
        assert row.velocity == pytest.approx(pose.velocity, rel=1e-12, abs=1e-12)
        assert row.acceleration == pytest.approx(pose.acceleration, rel=1e-12, abs=1e-9)
        assert row.slope is None
        assert row.bend is None


def test_without_a_speed_they_are_ratios() -> None:
    rows = slider_crank(**LENGTHS).table
    assert rows is not None
    assert all(row.velocity is None and row.acceleration is None and row.slope is not None for row in rows)


def test_a_four_bar_at_a_speed() -> None:
    lengths = {"crank": 0.04, "coupler": 0.11, "rocker": 0.08, "ground": 0.1}
    turning = {"speed": 10.0, "angular_acceleration": 3.0}
    rows = four_bar(**lengths, **turning, steps=7).table
    assert rows is not None
    for row in rows:
        pose = four_bar(**lengths, **turning, crank_angle=row.crank_angle)
        assert (row.rocker_speed, row.rocker_acceleration) == pytest.approx(
            (pose.rocker_speed, pose.rocker_acceleration), rel=1e-12
        )
        assert row.rocker_ratio is None


@pytest.mark.parametrize("offset", [0.02, -0.03])
def test_dead_centres_and_the_largest_speed_of_a_slider_on_the_left(offset: float) -> None:
    """The slider on the left has those of the mirror image; so has one that is driven there."""
    links = {"crank": 0.05, "rod": 0.15, "offset": offset}
    result = slider_crank(**links, crank_angle=0.4, end=End("left"))
    driven = slider_crank(**links, slider_position=-0.15)
    right = slider_crank(**links, crank_angle=0.4)
    turn = math.tau * np.arange(100_000) / 100_000
    x = 0.05 * np.cos(turn) - np.sqrt(0.15**2 - (offset - 0.05 * np.sin(turn)) ** 2)
    for one in (result, driven):
        assert one.outer_at % math.tau == pytest.approx(turn[x.argmin()], abs=1e-4)
        assert one.inner_at % math.tau == pytest.approx(turn[x.argmax()], abs=1e-4)
        assert one.top_at % math.tau == pytest.approx((math.pi - right.top_at) % math.tau, abs=1e-9)
        assert one.stroke == pytest.approx(np.ptp(x), rel=1e-8)
