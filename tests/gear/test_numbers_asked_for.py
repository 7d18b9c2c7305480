"""Numbers that users ask a handbook for, against closed forms written independently."""

from math import degrees, radians

import pytest
from harness import run
from mpmath import mp, mpf

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.gear.crossing.bevel import bevel
from dynamics_cli.gear.crossing.bevel_records import Kind
from dynamics_cli.gear.crossing.hypoid import hypoid
from dynamics_cli.gear.crossing.worm import AxialModule, WormDiameter, worm
from dynamics_cli.gear.pair.rack import rack
from dynamics_cli.gear.pitch import NormalModule
from dynamics_cli.gear.single.cylindrical import helical, spur

mp.dps = 40
THREE = NormalModule(3e-3)


@pytest.mark.parametrize(("teeth", "beta"), [(12, 30.0), (20, 15.0), (9, 0.0)])
def test_equivalent_teeth(teeth: int, beta: float) -> None:
    answer = helical(teeth=teeth, pitch=THREE, helix_angle=radians(beta), profile_shift=0.6)
    assert answer.equivalent_teeth == pytest.approx(float(teeth / mp.cos(mp.radians(beta)) ** 3), rel=1e-13)
    assert spur(teeth=20, pitch=THREE).equivalent_teeth is None


@pytest.mark.parametrize("beta", [0.0, 20.0, 40.0])
@pytest.mark.parametrize("shift", [-0.5, 0.0, 0.3, 0.9, 1.2])
def test_least_teeth_are_the_first_without_undercut(shift: float, beta: float) -> None:
    """One tooth fewer is undercut, by the test of the root itself."""
    many = helical(teeth=60, pitch=THREE, helix_angle=radians(beta), profile_shift=shift)
    least = many.least_teeth
    assert least is not None
    reach = mpf("1.25") - mpf("0.38") * (1 - mp.sin(mp.pi / 9)) - mpf(shift)
    transverse = mp.atan(mp.tan(mp.pi / 9) / mp.cos(mp.radians(beta)))
    assert least == max(1, mp.ceil(2 * mp.cos(mp.radians(beta)) * reach / mp.sin(transverse) ** 2))
    if least > 12:
        for teeth, undercut in ((least, False), (least - 1, True)):
            own = helical(teeth=teeth, pitch=THREE, helix_angle=radians(beta), profile_shift=shift)
            assert own.undercut is undercut


def test_nominal_contact_ratio_of_a_rack() -> None:
    """Full height on both sides: (√(r_a² − r_b²) − r sin α + h_a/sin α)/p_b."""
    alpha = mp.pi / 9
    answer = rack(teeth=10, pitch=THREE)
    recess = mp.sqrt(18**2 - (15 * mp.cos(alpha)) ** 2) - 15 * mp.sin(alpha)
    wanted = (recess + 3 / mp.sin(alpha)) / (3 * mp.pi * mp.cos(alpha))
    assert answer.nominal_contact_ratio == pytest.approx(float(wanted), rel=1e-13)
    assert answer.transverse_contact_ratio < answer.nominal_contact_ratio
    assert rack(teeth=30, pitch=THREE).nominal_contact_ratio is None


def test_the_shaft_angle_of_a_crown_gear() -> None:
    answer = bevel(first_teeth=20, second_teeth=40, module=3e-3, face_width=1e-3, kind=Kind("standard"))
    assert answer.crown_shaft_angle == pytest.approx(radians(120.0), rel=1e-15)
    crown = bevel(
        first_teeth=20,
        second_teeth=40,
        module=3e-3,
        face_width=1e-3,
        kind=Kind("standard"),
        shaft_angle=answer.crown_shaft_angle,
    )
    assert degrees(crown.second.pitch_angle) == pytest.approx(90.0, abs=1e-13)
    assert bevel(first_teeth=20, second_teeth=20, module=3e-3, face_width=1e-3).crown_shaft_angle is None


def test_a_worms_shift_from_its_centre_distance_and_its_normal_force() -> None:
    """x₂ = (a − (d₁ + d₂)/2)/m_x; F_n from the three forces on the worm, by their geometry."""
    common = {"threads": 2, "teeth": 30, "size": AxialModule(3e-3), "worm": WormDiameter(44e-3), "torque": 5.0}
    answer = worm(**common, centre_distance=68e-3)  # type: ignore[arg-type]
    assert answer.profile_shift == pytest.approx(1 / 3, rel=1e-13)
    again = worm(**common, profile_shift=answer.profile_shift)  # type: ignore[arg-type]
    assert again.centre_distance == pytest.approx(68e-3, rel=1e-14)
    assert again.throat_diameter == pytest.approx(answer.throat_diameter, rel=1e-14)
    # all of the force on the worm is F_n and the friction μF_n, which stand at right angles
    force = mp.sqrt(
        mpf(answer.worm_tangential_force) ** 2 + mpf(answer.worm_axial_force) ** 2 + mpf(answer.radial_force) ** 2
    )
    assert answer.normal_force == pytest.approx(float(force / mp.sqrt(1 + mpf("0.05") ** 2)), rel=1e-12)
    with pytest.raises(InadmissibleError, match="both given"):
        worm(**common, centre_distance=68e-3, profile_shift=0.1)  # type: ignore[arg-type]


@pytest.mark.parametrize("shafts", [75.0, 90.0, 110.0])
@pytest.mark.parametrize("offset", [-0.02, 0.035])
def test_a_hypoid_from_both_spiral_angles(offset: float, shafts: float) -> None:
    """The offset that made a wheel's spiral angle is found from it again."""
    common = {"first_teeth": 10, "second_teeth": 41, "wheel_radius": 0.085, "shaft_angle": radians(shafts)}
    known = hypoid(**common, offset=offset, pinion_spiral_angle=radians(45.0))  # type: ignore[arg-type]
    found = hypoid(  # type: ignore[arg-type]
        **common, pinion_spiral_angle=radians(45.0), wheel_spiral_angle=known.second_spiral_angle
    )
    assert known.offset is None
    assert found.offset == pytest.approx(offset, rel=1e-12)
    assert found.first_pitch_radius == pytest.approx(known.first_pitch_radius, rel=1e-13)
    assert found.second_spiral_angle == pytest.approx(known.second_spiral_angle, rel=1e-13)


def test_a_hypoid_needs_its_offset_or_the_wheels_spiral() -> None:
    for more in ((), ("--offset", "30 mm", "--wheel-spiral-angle", "30 deg")):
        outcome = run(
            "gear", "hypoid", "--first-teeth", "10", "--second-teeth", "41", "--wheel-radius", "85 mm", *more, "--json"
        )
        assert (outcome.status, outcome.error["code"]) == (3, "offset")
