"""Undercut and tips of bevel, crossed and worm gears, against closed forms in 40 digits and published limits."""

from math import radians

import pytest
from mpmath import mp, mpf

from dynamics_cli.gear.crossing.bevel import bevel
from dynamics_cli.gear.crossing.bevel_records import Kind
from dynamics_cli.gear.crossing.crossed import Screw, crossed
from dynamics_cli.gear.crossing.virtual_teeth import tip_land, undercut_depth
from dynamics_cli.gear.crossing.worm import AxialModule, WormDiameter, worm

mp.dps = 40


def codes(answer: object) -> list[str]:
    return [one.code for one in answer.advice]  # type: ignore[attr-defined]


def of_bevel(first: int, second: int, kind: str = "gleason") -> list[str]:
    return codes(bevel(first_teeth=first, second_teeth=second, module=3e-3, face_width=1e-3, kind=Kind(kind)))


# Gleason's fewest teeth without undercut for straight teeth of 20 degrees and shafts at right angles.
@pytest.mark.parametrize(("first", "second"), [(16, 16), (15, 17), (14, 20), (13, 30)])
def test_gleasons_fewest_teeth_are_not_undercut(first: int, second: int) -> None:
    assert "undercut" not in of_bevel(first, second)
    assert "pointed" not in of_bevel(first, second)


@pytest.mark.parametrize(("first", "second", "who"), [(8, 40, 1), (3, 3, 2)])
def test_few_teeth_of_bevel_gears_are_undercut(first: int, second: int, who: int) -> None:
    assert of_bevel(first, second).count("undercut") == who


def test_standard_bevel_teeth_need_as_many_virtual_teeth_as_spur_gears() -> None:
    """Full depth teeth: z/cos δ ≥ 2/sin²20° = 17.097, for the first of 12/z₂ from δ = atan(12/z₂)."""
    for second in range(12, 60):
        virtual = 12 / mp.cos(mp.atan(mpf(12) / second))
        undercut = virtual < 2 / mp.sin(mp.pi / 9) ** 2
        own = bevel(first_teeth=12, second_teeth=second, module=3e-3, face_width=1e-3, kind=Kind("standard"))
        assert any("pinion" in one.message for one in own.advice if one.code == "undercut") == undercut


@pytest.mark.parametrize(
    ("teeth", "angle", "height", "shift"), [(8, 20, 1.0, 0.0), (12, 25, 0.8, 0.3), (40, 14.5, 1, -0.4), (6, 20, 2, 1)]
)
def test_tip_land_in_many_digits(teeth: int, angle: float, height: float, shift: float) -> None:
    alpha = mp.radians(mpf(angle))
    tip = teeth + 2 * mpf(height)
    at = mp.acos(teeth * mp.cos(alpha) / tip)
    land = tip * ((mp.pi / 2 + 2 * mpf(shift) * mp.tan(alpha)) / teeth + mp.tan(alpha) - alpha - mp.tan(at) + at)
    assert tip_land(teeth, radians(angle), height, shift) == pytest.approx(float(land), rel=1e-13, abs=1e-13)
    assert undercut_depth(teeth, radians(angle)) == pytest.approx(float(teeth * mp.sin(alpha) ** 2 / 2), rel=1e-14)


def test_a_tip_inside_its_base_circle_has_no_land() -> None:
    assert tip_land(20, radians(20.0), -1.0) is None


def test_crossed_gears_of_few_teeth() -> None:
    """Undercut where (1 − x)cos β exceeds z sin²α_t/2; many teeth are quiet."""
    few = crossed(first=Screw(5, radians(20), 1.0), second=Screw(6, radians(25)), module=2e-3)
    assert {"undercut", "pointed"} <= set(codes(few))
    lean, alpha = mp.radians(25), mp.radians(20)
    transverse = mp.atan(mp.tan(alpha) / mp.cos(lean))
    assert mp.cos(lean) > 3 * mp.sin(transverse) ** 2
    usual = crossed(first=Screw(15, radians(20), 0.4), second=Screw(24, radians(30), 0.2), module=3e-3)
    assert not {"undercut", "pointed", "thin-tip"} & set(codes(usual))


@pytest.mark.parametrize(
    ("teeth", "shift", "wanted"),
    [(30, 0.0, set()), (8, 0.0, {"undercut"}), (30, 5.0, {"pointed"}), (30, -5.0, {"undercut", "no-flank"})],
)
def test_teeth_of_a_worm_wheel(teeth: int, shift: float, wanted: set[str]) -> None:
    answer = worm(
        threads=2, teeth=teeth, size=AxialModule(3e-3), worm=WormDiameter(44e-3), profile_shift=shift, friction=0.02
    )
    assert {"undercut", "pointed", "thin-tip", "no-flank"} & set(codes(answer)) == wanted
