"""Josephs, H. and Huston, R. L., Dynamics of Mechanical Systems, CRC Press, 2002, section 1.6: points in other systems.

The points of the book's examples and exercises; their other coordinates follow from its definitions, in closed form:
cylindrical x = r cos θ, y = r sin θ; spherical φ from the Z-axis, θ in the X–Y plane from X.
"""

from math import acos, atan2, degrees, pi, sqrt

import pytest
from harness import answer

from dynamics_cli.convert import coords

RELATIVE = 1e-15


@pytest.mark.parametrize(("x", "y", "z"), [(3.0, 1.0, 4.0), (1.0, 2.0, 5.0)])
def test_cartesian_points(x: float, y: float, z: float) -> None:
    cylindrical = coords.cartesian_to_cylindrical(x, y, z)
    spherical = coords.cartesian_to_spherical(x, y, z)
    rho = sqrt(x * x + y * y + z * z)
    assert cylindrical.r == pytest.approx(sqrt(x * x + y * y), rel=RELATIVE)
    assert cylindrical.theta == pytest.approx(atan2(y, x), rel=RELATIVE)
    assert cylindrical.z == z
    assert spherical.rho == pytest.approx(rho, rel=RELATIVE)
    assert spherical.phi == pytest.approx(acos(z / rho), rel=1e-14)
    assert spherical.theta == cylindrical.theta


def test_cylindrical_point() -> None:
    point = coords.cylindrical_to_cartesian(4.0, pi / 6, 2.0)
    assert (point.x, point.y, point.z) == pytest.approx((2.0 * sqrt(3.0), 2.0, 2.0), rel=RELATIVE)
    spherical = coords.cylindrical_to_spherical(4.0, pi / 6, 2.0)
    assert spherical.rho == pytest.approx(2.0 * sqrt(5.0), rel=RELATIVE)
    assert spherical.phi == pytest.approx(atan2(2.0, 1.0), rel=RELATIVE)
    assert spherical.theta == pi / 6


def test_spherical_point() -> None:
    point = coords.spherical_to_cartesian(7.0, pi / 4, pi / 3)
    # 7 sin 45° cos 60°, 7 sin 45° sin 60°, 7 cos 45°
    expected = (7.0 * sqrt(2.0) / 4.0, 7.0 * sqrt(6.0) / 4.0, 7.0 * sqrt(2.0) / 2.0)
    assert (point.x, point.y, point.z) == pytest.approx(expected, rel=RELATIVE)
    cylindrical = coords.spherical_to_cylindrical(7.0, pi / 4, pi / 3)
    assert cylindrical.r == pytest.approx(3.5 * sqrt(2.0), rel=RELATIVE)
    assert cylindrical.theta == pi / 3


def test_the_command_gives_the_books_point() -> None:
    results = answer("coords", "3", "1", "4", "--from", "cartesian", "--into", "spherical")["results"]
    assert results["rho"]["value"] == pytest.approx(sqrt(26.0), rel=RELATIVE)
    assert results["phi"]["value"] == pytest.approx(degrees(acos(4.0 / sqrt(26.0))), rel=1e-14)
    assert results["theta"]["value"] == pytest.approx(degrees(atan2(1.0, 3.0)), rel=RELATIVE)
