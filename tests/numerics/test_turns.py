"""Cosines and sines of angles as written: exact at multiples of 30 degrees, alike for floats, arrays and tracked."""

import math

import numpy as np
import pytest
from harness import answer, run
from mpmath import mp

from dynamics_cli.impact.spatial.arithmetic import cosine_and_sine
from dynamics_cli.numerics.exact.many_digits import ManyDigits
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.numerics.turns import multiple_of, tangent, turned


def nearest(degrees: int) -> float:
    with mp.workdps(60):
        return float(mp.pi * degrees / 180)


@pytest.mark.parametrize("degrees", [*range(-720, 721, 30), 36000, -36030, 29999970])
def test_multiples_of_thirty_degrees_are_exact(degrees: int) -> None:
    with mp.workdps(60):
        exact = [float(mp.cospi(mp.mpf(degrees) / 180)), float(mp.sinpi(mp.mpf(degrees) / 180))]
    angle = nearest(degrees)
    assert list(turned(angle)) == exact
    assert not any(math.copysign(1.0, part) < 0.0 for part in turned(angle) if part == 0.0)
    assert [part.item() for part in np.array(turned(np.array([angle, 0.1])))[:, 0]] == exact
    for part, value, slope in zip(turned(Tracked.inputs([angle])[0]), exact, (-exact[1], exact[0]), strict=True):
        assert part.value == value  # type: ignore[attr-defined]
        assert part.slopes == pytest.approx((slope,))  # type: ignore[attr-defined]
    assert [float(part) for part in cosine_and_sine(ManyDigits.inputs([angle])[0].exact)] == exact  # type: ignore[arg-type]


@pytest.mark.parametrize("degrees", [30, 60, 90, 120, 150, 180, 210, 270, 330, 450])
def test_bounds_allow_for_the_double_that_was_read(degrees: int) -> None:
    angle = nearest(degrees)
    with mp.workdps(40):
        true = mp.cos(mp.mpf(angle)), mp.sin(mp.mpf(angle))
        for part, reference in zip(turned(Tracked.inputs([angle])[0]), true, strict=True):
            assert abs(mp.mpf(part.value) - reference) <= part.error <= 2e-16 * (1.0 + angle)  # type: ignore[attr-defined]


def test_other_angles_keep_their_bits() -> None:
    for angle in (0.1, math.nextafter(nearest(90), 2.0), math.nextafter(nearest(30), 0.0), 1e22):
        assert turned(angle) == (math.cos(angle), math.sin(angle))
    assert multiple_of(nearest(45)) is None


@pytest.mark.parametrize("angle", ["90 deg", "-90 deg", "270 deg", "100 gon", "0.25 turn"])
def test_bodies_that_pass_along_the_surface_do_not_meet(angle: str) -> None:
    call = ["impact", "oblique", "--first-mass", "1 kg", "--first-velocity", "10, 0 m/s", "--second-fixed"]
    outcome = run(*call, "--normal", angle, "--restitution", "0.5", "--json")
    assert (outcome.status, outcome.error["code"]) == (3, "no-impact")


def test_a_direction_of_ninety_degrees_has_no_part_along_x() -> None:
    call = ["impact", "oblique", "--first-mass", "1 kg", "--first-velocity", "10 m/s @ 90 deg", "--second-fixed"]
    first = answer(*call, "--normal", "90 deg", "--restitution", "0.5", "--units", "base")["results"]["first"]
    assert first["velocity"]["value"] == [0.0, -5.0]
    assert first["tangential_velocity"]["value"] == 0.0


@pytest.mark.parametrize("count", [0, 1, 3, 4, 5, 7, -1, 9])
def test_tangents_of_eighths_are_whole(count: int) -> None:
    angle = nearest(45 * count)
    wanted = (0.0, 1.0, math.nan, -1.0)[count % 4]
    assert tangent(angle) == wanted
    assert tangent(np.array([angle, 0.3])).tolist() == [wanted, math.tan(0.3)]
    tracked = tangent(Tracked.inputs([angle])[0])
    assert tracked.value == wanted
    assert tracked.slopes[0] == 1.0 + wanted * wanted
    with mp.workdps(40):
        assert abs(wanted - mp.tan(mp.mpf(angle))) <= tracked.error


def test_other_tangents_are_as_they_are() -> None:
    for angle in (0.3, math.radians(90), math.nextafter(math.pi / 4, 1.0), -1.2, 1e9):
        assert tangent(angle) == math.tan(angle)
