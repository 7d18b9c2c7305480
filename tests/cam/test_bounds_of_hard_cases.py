"""Cases a search broke bounds with, or found them needlessly wide: each against what is known otherwise."""

from math import inf, pi

import numpy as np
import pytest
from geometry_cases import NOTHING, by_rays

from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.geometry.profile import profile
from dynamics_cli.cam.program.reading import motion_of
from dynamics_cli.cam.program.revolution import motion
from dynamics_cli.cam.program.summary import root_mean_square
from dynamics_cli.cam.sizing import records, size
from dynamics_cli.errors import InadmissibleError

DEGREE = pi / 180.0
CYCLE = "rise 10 mm in 90 deg modified-sine; dwell 90 deg; return in 90 deg cycloidal; dwell"


def test_a_short_span_late_in_the_turn_is_not_the_difference_of_its_rounded_ends() -> None:
    line = "dwell 300 deg; rise 5 mm in 0.0001 deg linear; dwell 10 deg; return linear"
    found = motion(NOTHING, program=line, count=3)
    assert found.velocity is not None
    assert found.velocity.greatest == pytest.approx(0.005 / (1e-4 * DEGREE), rel=1e-15)


def test_the_mean_of_a_law_of_ten_half_waves_is_its_closed_form() -> None:
    found = motion_of(NOTHING, "rise 10 mm in 180 deg freudenstein-1-3-5; return freudenstein-1-3-5")
    # a = Σ 2πk c_k sin 2πkx, in units of the rise and the span
    mean = sum((2 * pi * k * c) ** 2 / 2 for k, c in ((1, 1125 / 1192), (3, 62.5 / 1192), (5, 4.5 / 1192)))
    value, bound = root_mean_square(found, 2)
    assert value == pytest.approx(0.01 / pi**2 * mean**0.5, rel=4e-15)
    assert bound <= 100 * 2.0**-53 * value


def test_a_pressure_angle_that_passes_half_a_turn_is_refused() -> None:
    follower = followers.ConjugateOscillatingRoller(
        0.05639462830893849, 0.009088447977223912, 0.09677401232567454, 0.10095166712434105, 1.01078365428814
    )
    line = "rise 24.02 deg in 104.0 deg 4-5-6-7; return 24.02 deg 4-5-6-7"
    with pytest.raises(InadmissibleError, match="passes 180 deg"):
        profile(NOTHING, program=line, follower=follower, rotation=followers.Rotation("clockwise"))


@pytest.mark.parametrize("limit", [1e-9, 1e-3, 0.1, 89.9999])
def test_sizes_for_extreme_limits_are_as_well_known_as_others(limit: float) -> None:
    made = size.size(NOTHING, program=CYCLE, follower=records.Roller(0.005), rise_limit=limit * DEGREE)
    assert made.numerics is not None
    assert made.numerics.bounds[0].bound <= 3e-14


def test_no_base_circle_has_an_absolute_bound() -> None:
    made = size.size(
        NOTHING, program="return 4.3425 mm in 155.0 deg modified-trapezoid; rise 4.3425 mm trapezoid",
        follower=records.Roller(0.014184577115182314), rise_limit=0.5888636890617149, return_limit=0.7729994451944644,
    )  # fmt: skip
    assert made.numerics is not None
    (bound,) = made.numerics.bounds
    assert made.base_radius == 0.0
    assert not bound.relative
    assert 0.0 < bound.bound < 1e-16


def test_an_arm_whose_arc_cosine_is_cut_off_somewhere_has_a_bound() -> None:
    line = (
        "rise 5.5125 deg in 29.2 deg scca 0.34375 0.1875 0.46875; dwell 23.0 deg; "
        "rise 0.7875 deg in 34.0 deg modified-sine; return 6.3 deg in 74.093 deg modified-sine; dwell"
    )
    follower = records.OscillatingRoller(0.005151427609123134, 0.1037294436492433, 0.12619110039737602)
    made = size.size(
        NOTHING, program=line, follower=follower, rise_limit=0.5878595225718926, return_limit=0.27294027665571596
    )
    assert made.numerics is not None
    assert made.numerics.bounds[0].bound <= 5e-14 < inf


def test_a_plate_with_a_very_short_steep_return() -> None:
    """Its centroid was off by a tenth of a millimetre where all pieces were of one length."""
    line = (
        "dwell 49.68 deg; rise 6.27 mm in 60.5 deg 4-5-6-7; return 6.27 mm in 0.000254 deg "
        "modified-constant-velocity 0.4375; dwell"
    )
    # a point in line is at the radius |start + s|: centroid and area are integrals over the angle alone
    follower = followers.ConjugateRoller(0.0573355233419435, 0.0, 0.09684574099333015, 0.0)
    made = profile(NOTHING, program=line, follower=follower)
    motion, start = motion_of(NOTHING, line), Geometry(follower).start
    nodes, weights = np.polynomial.legendre.leggauss(60)
    area = moment = 0.0
    for zone in motion.zones:
        half = 0.5 * (zone.end - zone.start)
        theta = zone.start + half * (1.0 + nodes)
        radius = np.abs(start + motion.in_zone(motion.zones.index(zone), 0.5 * (1.0 + nodes), 0)[0])
        area += 0.5 * half * (weights * radius**2).sum()
        moment += half * (weights * radius**3 * -np.sin(theta)).sum() / 3.0
    assert made.area == pytest.approx(area, rel=1e-13)
    assert made.centroid_x == pytest.approx(moment / area, rel=1e-12)
    assert made.numerics is not None
    stated = {bound.result: bound.bound for bound in made.numerics.bounds}
    assert stated["area"] <= 1.2e-14
    assert stated["centroid_x"] <= 1e-14


def test_the_same_short_return_undercut_by_a_roller_leaves_a_plate() -> None:
    line = (
        "dwell 49.68 deg; rise 6.27 mm in 60.5 deg 4-5-6-7; return 6.27 mm in 0.000254 deg "
        "modified-constant-velocity 0.4375; dwell"
    )
    follower = followers.ConjugateRoller(0.0573355233419435, 0.007777373188608402, 0.09684574099333015, 0.0)
    made = profile(NOTHING, program=line, follower=follower)
    wanted = by_rays(Geometry(follower), motion_of(NOTHING, line))
    assert (made.area, made.perimeter) == pytest.approx(wanted[:2], rel=1e-3)


@pytest.mark.parametrize("short", [1e-6, 1e-9, 1e-12])
def test_an_arm_next_to_stretching_is_known_to_rounding(short: float) -> None:
    line = "rise 0.001 deg in 90 deg cycloidal; dwell 90 deg; return in 90 deg cycloidal; dwell"
    made = profile(NOTHING, program=line, follower=followers.OscillatingRoller(0.172 - short, 0.008, 0.08, 0.1))
    assert made.numerics is not None
    stated = {bound.result: bound.bound for bound in made.numerics.bounds}
    assert max(stated["largest_pressure_angle"], stated["least_pressure_angle"]) <= 1e-14
