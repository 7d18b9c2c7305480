"""Single gears, the involute curve, the rack, the glossary and the data block."""

from math import cos, degrees, hypot, pi, radians, sin, tan

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.errors import DynamicsError, InadmissibleError
from dynamics_cli.gear.glossary import glossary
from dynamics_cli.gear.measure.data_block import data_block
from dynamics_cli.gear.pair.rack import rack
from dynamics_cli.gear.pitch import (
    NormalCircularPitch,
    NormalDiametralPitch,
    NormalModule,
    TransverseCircularPitch,
    TransverseDiametralPitch,
    TransverseModule,
    module_advice,
)
from dynamics_cli.gear.single.cylindrical import helical, spur
from dynamics_cli.gear.single.gear import Hand, Sign, signed_gear
from dynamics_cli.gear.single.involute_curve import AtAngle, AtDiameter, AtInvolute, AtRoll, involute_point
from dynamics_cli.gear.single.rack import Profile, basic_rack

THREE = NormalModule(0.003)


@pytest.mark.parametrize(
    "pitch",
    [
        NormalModule(0.002),
        NormalDiametralPitch(500.0),
        NormalCircularPitch(0.002 * pi),
        TransverseModule(0.002 / cos(0.3)),
        TransverseDiametralPitch(500.0 * cos(0.3)),
        TransverseCircularPitch(0.002 * pi / cos(0.3)),
    ],
)
def test_every_size_of_teeth_makes_the_same_gear(pitch: object) -> None:
    answer = helical(teeth=20, pitch=pitch, helix_angle=0.3)  # type: ignore[arg-type]
    assert answer.reference_diameter == pytest.approx(20 * 0.002 / cos(0.3), rel=1e-15)
    assert answer.normal_module == pytest.approx(0.002, rel=1e-15)


@settings(max_examples=80, deadline=None)
@given(st.integers(5, 200), st.floats(-0.3, 0.6), st.floats(0.0, 0.7))
def test_identities_of_one_gear(z: int, x: float, beta: float) -> None:
    try:
        answer = helical(teeth=z, pitch=THREE, helix_angle=beta, profile_shift=x)
    except InadmissibleError as error:
        if error.code in ("pointed", "no-flank", "no-root"):
            return
        raise
    assert all(check.passed for check in answer.checks)
    assert answer.tip_diameter - answer.root_diameter == pytest.approx(2.0 * answer.tooth_depth, rel=1e-12)
    assert answer.base_pitch * z == pytest.approx(pi * answer.base_diameter, rel=1e-14)
    assert answer.transverse_thickness + answer.transverse_space == pytest.approx(answer.transverse_pitch, rel=1e-14)
    assert answer.undercut == (x < answer.least_shift)
    assert x <= answer.pointed_shift
    assert answer.root_form_diameter >= answer.base_diameter * (1.0 - 1e-15)
    # the base helix by tan β_b = tan β cos α_t
    assert tan(answer.base_helix_angle) == pytest.approx(tan(beta) * cos(answer.transverse_pressure_angle), abs=1e-14)


def test_least_and_greatest_shift_of_few_teeth() -> None:
    """x where undercut ends and where the tips are pointed, 20° full depth: none serves up to 7 teeth."""
    published = {5: (0.708, 0.3298), 6: (0.649, 0.4149), 7: (0.591, 0.4933), 8: (0.532, 0.5662), 9: (0.474, 0.6348)}
    for z, (least, most) in published.items():
        answer = spur(teeth=z, pitch=THREE, profile_shift=0.2)
        assert answer.least_shift == pytest.approx(least, abs=5.1e-4)
        assert answer.pointed_shift == pytest.approx(most, abs=5.1e-5)
        if z <= 7:
            with pytest.raises(InadmissibleError, match="no profile shift is possible"):
                spur(teeth=z, pitch=THREE, avoid_undercut=True)
        else:
            chosen = spur(teeth=z, pitch=THREE, avoid_undercut=True)
            assert chosen.profile_shift == chosen.least_shift
            assert chosen.root_form_diameter == pytest.approx(chosen.base_diameter, rel=1e-12)
    assert spur(teeth=30, pitch=THREE, avoid_undercut=True).profile_shift == 0.0


def test_pointed_on_both_sides_of_its_limit() -> None:
    limit = spur(teeth=12, pitch=THREE).pointed_shift
    assert spur(teeth=12, pitch=THREE, profile_shift=limit - 1e-9).tip_thickness < 1e-8
    with pytest.raises(InadmissibleError, match="pointed"):
        spur(teeth=12, pitch=THREE, profile_shift=limit + 1e-9)


def test_internal_gears_by_either_sign() -> None:
    iso = spur(teeth=40, pitch=THREE, profile_shift=-0.3, internal=True)
    khk = spur(teeth=40, pitch=THREE, profile_shift=0.3, internal=True, shift_sign=Sign("KHK"))
    assert iso == khk
    assert iso.root_diameter > iso.tip_diameter
    # the space of a ring is the tooth of the external gear with the opposite shift
    tooth = spur(teeth=40, pitch=THREE, profile_shift=0.3)
    assert iso.transverse_space == pytest.approx(tooth.normal_thickness, rel=1e-15)


def test_hand_and_sign_of_the_helix() -> None:
    assert helical(teeth=20, pitch=THREE, helix_angle=-0.2).hand == "left"
    assert helical(teeth=20, pitch=THREE, helix_angle=-0.2, hand=Hand("lh")).hand == "right"
    assert helical(teeth=20, pitch=THREE, helix_angle=0.0).hand is None


def test_a_helix_of_nothing_is_a_spur_gear() -> None:
    straight, flat = spur(teeth=20, pitch=THREE), helical(teeth=20, pitch=THREE, helix_angle=0.0)
    assert flat.tip_thickness == pytest.approx(straight.tip_thickness, rel=1e-14)
    assert flat.lead is None
    assert flat.transverse_pressure_angle == pytest.approx(radians(20.0), rel=1e-15)


def test_profiles_and_their_corners() -> None:
    assert Profile("ISO 53 D") == "d"
    assert basic_rack("d", radians(20.0)).dedendum == 1.4
    # at 25° the corner of profile A does not fit and becomes a full round
    full = basic_rack("a", radians(25.0))
    assert full.tip_radius == pytest.approx(
        (pi / 4 * cos(radians(25)) - 1.25 * sin(radians(25))) / (1 - sin(radians(25)))
    )
    assert spur(teeth=20, pitch=THREE, pressure_angle=radians(25.0)).undercut is False
    with pytest.raises(InadmissibleError, match="pointed above its tip"):
        basic_rack("a", radians(33.0))


def test_module_series() -> None:
    assert module_advice(THREE, 0.003) == ()
    mend = module_advice(NormalModule(0.0036), 0.0036)[0].remedy or ""
    assert "4 (series I), 3.5 (series II)" in mend
    assert module_advice(NormalDiametralPitch(300.0), 1 / 300.0) == ()


REFUSED = {
    "helix-angle": {"helix_angle": pi / 2},
    "pressure-angle": {"pressure_angle": 0.0},
    "two-pressure-angles": {"pressure_angle": 0.3, "transverse_pressure_angle": 0.4},
    "no-root": {"profile_shift": -8.0, "teeth": 10},
    "no-tooth": {"addendum_factor": -2.0},
    "tip-inside-base": {"internal": True, "teeth": 20},
    "tip-radius": {"root_radius_factor": 0.6},
    "no-flank": {"tip_shortening": 0.0014, "teeth": 5, "profile_shift": -0.5, "helix_angle": 0.0},
}


@pytest.mark.parametrize("code", REFUSED)
def test_refusals(code: str) -> None:
    given = {"teeth": 20, "pitch": THREE, "helix_angle": 0.1} | REFUSED[code]
    with pytest.raises(InadmissibleError) as caught:
        helical(**given)  # type: ignore[arg-type]
    assert caught.value.code == code


@given(st.floats(1e-6, 1.55))
def test_every_way_to_a_point_of_the_involute(angle: float) -> None:
    base = 0.05
    one = involute_point(at=AtAngle(angle), base_diameter=base)
    two = involute_point(at=AtInvolute(one.involute), base_diameter=base)
    three = involute_point(at=AtRoll(one.roll_angle), base_diameter=base)
    assert two.pressure_angle == pytest.approx(angle, rel=1e-14)
    assert three.involute == pytest.approx(one.involute, rel=1e-13)
    if angle > 1e-2:
        four = involute_point(at=AtDiameter(one.diameter), base_diameter=base)
        assert four.pressure_angle == pytest.approx(angle, rel=1e-11)


def test_points_lie_on_the_unwound_string() -> None:
    answer = involute_point(at=AtAngle(0.7), base_diameter=0.08, points=9)
    assert answer.points is not None
    for point in answer.points:
        foot = (0.04 * cos(point.roll), 0.04 * sin(point.roll))
        assert hypot(point.x - foot[0], point.y - foot[1]) == pytest.approx(0.04 * point.roll, abs=1e-16)
        assert hypot(point.x, point.y) == pytest.approx(point.radius, rel=1e-15)


def test_thickness_at_any_diameter_is_that_of_the_gear() -> None:
    gear = spur(teeth=12, pitch=THREE, profile_shift=0.6)
    answer = involute_point(
        at=AtDiameter(gear.tip_diameter),
        base_diameter=gear.base_diameter,
        known_thickness=gear.normal_thickness,
        known_diameter=gear.reference_diameter,
    )
    assert answer.thickness == pytest.approx(gear.tip_thickness, rel=1e-12)
    for wrong in ({"known_thickness": 0.004}, {"known_diameter": 0.03}, {"points": 2000}):
        with pytest.raises(DynamicsError):
            involute_point(at=AtAngle(0.3), base_diameter=0.05, **wrong)  # type: ignore[arg-type]
    for at in (AtAngle(1.6), AtRoll(-0.1), AtDiameter(0.01)):
        with pytest.raises(InadmissibleError):
            involute_point(at=at, base_diameter=0.05)


def test_rack_as_the_limit_of_a_large_gear() -> None:
    from dynamics_cli.gear.pair.pair import pair
    from dynamics_cli.gear.pair.records import Mate
    from dynamics_cli.gear.pair.shift_split import Tips

    on_rack = rack(teeth=20, pitch=THREE, profile_shift=0.3)
    large = pair(first=Mate(20, 0.3), second=Mate(2_000_000, 0.0), pitch=THREE, tips=Tips("full"))
    assert large.transverse_contact_ratio == pytest.approx(on_rack.transverse_contact_ratio, rel=2e-5)
    assert on_rack.travel == pytest.approx(20 * on_rack.pitch)
    with pytest.raises(InadmissibleError, match="never touch"):
        rack(teeth=30, pitch=THREE, profile_shift=0.95, tip_shortening=0.006)


def test_glossary() -> None:
    terms = [entry.term for entry in glossary().entries]
    assert len(terms) == len(set(terms)) > 50
    assert [entry.term for entry in glossary("Center distance", "DP").entries] == ["centre distance", "diametral pitch"]
    assert {entry.term for entry in glossary("bevel").entries} == {"bevel gear", "spiral bevel gear"}
    with pytest.raises(InadmissibleError, match="backlash"):
        glossary("backlsh")


def test_data_block() -> None:
    block = data_block(teeth=31, pitch=NormalModule(0.0035), helix_angle=radians(21.0), hand=Hand("left"), accuracy="7")
    lines = {row.item: (row.data, row.unit) for row in block.rows}
    assert lines["Number of teeth"] == ("31", "")
    assert lines["Hand of helix"] == ("left", "")
    assert lines["Reference diameter"] == (f"{31 * 3.5 / cos(radians(21.0)):.4f}", "mm")
    assert lines["Helix angle"] == ("21.0000", "deg")
    assert "Span" in lines
    ring = data_block(teeth=60, pitch=THREE, internal=True)
    assert ring.rows[0].data == "-60"


def test_the_internal_record_keeps_iso_signs() -> None:
    ring = signed_gear(40, 0.003, basic_rack("a", radians(20.0)), internal=True)
    assert ring.reference_diameter == -0.12
    assert ring.thickness(ring.reference_diameter) == pytest.approx(0.003 * pi / 2)
    assert degrees(ring.transverse_angle) == pytest.approx(20.0)


def test_the_back_of_a_rack_lies_below_its_teeth() -> None:
    assert rack(teeth=20, pitch=THREE, datum_height=0.0038).mounting_distance is not None
    with pytest.raises(InadmissibleError, match="datum line"):
        rack(teeth=20, pitch=THREE, datum_height=0.0037)


@pytest.mark.parametrize("internal", [False, True])
def test_a_tip_diameter_in_place_of_the_rack_s(internal: bool) -> None:
    sizes = {"teeth": 40, "pitch": NormalModule(2e-3), "profile_shift": 0.2, "internal": internal}
    shortened = spur(**sizes, tip_shortening=1e-4)
    given_tip = spur(**sizes, tip_diameter=shortened.tip_diameter)
    assert given_tip.tip_diameter == pytest.approx(shortened.tip_diameter, rel=1e-15)
    assert given_tip.tip_thickness == pytest.approx(shortened.tip_thickness, rel=1e-12)
    assert given_tip.addendum == pytest.approx(shortened.addendum, rel=1e-12)
    with pytest.raises(InadmissibleError, match="both given"):
        spur(**sizes, tip_shortening=1e-4, tip_diameter=82e-3)
