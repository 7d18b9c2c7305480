"""Pairs of gears: both ways between shifts and distance, the path of contact, interference, forces, refusals."""

from itertools import pairwise
from math import cos, degrees, hypot, pi, radians, sin, tan

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.gear.pair.forces import Bearings
from dynamics_cli.gear.pair.interference import extremum
from dynamics_cli.gear.pair.pair import pair
from dynamics_cli.gear.pair.records import Mate
from dynamics_cli.gear.pair.shift_split import Split, Tips
from dynamics_cli.gear.pitch import NormalDiametralPitch, NormalModule, TransverseModule
from dynamics_cli.gear.single.gear import Hand, Sign

TWO = NormalModule(0.002)
FULL = Tips("full")


@settings(max_examples=60, deadline=None)
@given(st.integers(18, 60), st.integers(18, 120), st.floats(0.0, 0.5), st.floats(0.0, 0.5), st.floats(0.0, 0.6))
def test_distance_gives_the_shifts_back(z1: int, z2: int, x1: float, x2: float, helix: float) -> None:
    there = pair(first=Mate(z1, x1), second=Mate(z2, x2), pitch=TWO, helix_angle=helix)
    back = pair(
        first=Mate(z1, x1), second=Mate(z2), pitch=TWO, helix_angle=helix, centre_distance=there.centre_distance
    )
    assert back.second_profile_shift == pytest.approx(x2, abs=1e-11)
    both = pair(
        first=Mate(z1, x1), second=Mate(z2, x2), pitch=TWO, helix_angle=helix, centre_distance=there.centre_distance
    )
    assert both.circumferential_backlash == pytest.approx(0.0, abs=1e-14)
    assert all(check.passed for check in there.checks)


@settings(max_examples=40, deadline=None)
@given(st.integers(18, 60), st.integers(18, 60), st.floats(0.0, 0.5), st.floats(0.0, 0.5), st.floats(0.1, 9.0))
def test_exchange_and_scale(z1: int, z2: int, x1: float, x2: float, factor: float) -> None:
    one = pair(first=Mate(z1, x1), second=Mate(z2, x2), pitch=TWO)
    other = pair(first=Mate(z2, x2), second=Mate(z1, x1), pitch=TWO)
    scaled = pair(first=Mate(z1, x1), second=Mate(z2, x2), pitch=NormalModule(0.002 * factor))
    assert other.centre_distance == pytest.approx(one.centre_distance, rel=1e-14)
    assert other.transverse_contact_ratio == pytest.approx(one.transverse_contact_ratio, rel=1e-12)
    assert other.approach_length == pytest.approx(one.recess_length, rel=1e-10)
    assert scaled.centre_distance == pytest.approx(factor * one.centre_distance, rel=1e-14)
    assert scaled.transverse_contact_ratio == pytest.approx(one.transverse_contact_ratio, rel=1e-12)
    assert scaled.efficiency == pytest.approx(one.efficiency, rel=1e-14)


def test_units_of_the_same_gear_agree() -> None:
    inch = pair(first=Mate(18), second=Mate(40), pitch=NormalDiametralPitch(8 / 0.0254))
    metric = pair(first=Mate(18), second=Mate(40), pitch=NormalModule(0.0254 / 8))
    assert inch.centre_distance == pytest.approx(metric.centre_distance, rel=1e-15)
    helix = radians(20.0)
    normal = pair(first=Mate(18), second=Mate(40), pitch=NormalModule(0.003 * cos(helix)), helix_angle=helix)
    transverse = pair(first=Mate(18), second=Mate(40), pitch=TransverseModule(0.003), helix_angle=helix)
    assert transverse.centre_distance == pytest.approx(normal.centre_distance, rel=1e-15)


def test_an_internal_pair_is_its_external_formula_with_negative_teeth() -> None:
    iso = pair(first=Mate(16, 0.1), second=Mate(40, -0.3), pitch=TWO, internal=True)
    khk = pair(first=Mate(16, 0.1), second=Mate(40, 0.3), pitch=TWO, internal=True, shift_sign=Sign("outward"))
    assert iso == khk
    assert iso.second_working_diameter / iso.first_working_diameter == pytest.approx(2.5, rel=1e-15)
    assert (iso.second_working_diameter - iso.first_working_diameter) / 2 == pytest.approx(iso.centre_distance)


@pytest.mark.parametrize("split", Split.names)
def test_every_split_serves_the_distance(split: str) -> None:
    answer = pair(first=Mate(17), second=Mate(43), pitch=TWO, centre_distance=0.061, split=Split(split))
    again = pair(first=Mate(17, answer.first_profile_shift), second=Mate(43, answer.second_profile_shift), pitch=TWO)
    assert again.centre_distance == pytest.approx(0.061, rel=1e-13)
    if split == "balanced-sliding":
        assert answer.points[0].first_sliding == pytest.approx(answer.points[-1].second_sliding, rel=1e-9)


def test_path_of_contact() -> None:
    answer = pair(first=Mate(12, 0.6), second=Mate(24, 0.36), pitch=NormalModule(0.003), speed=100.0)
    a, b, c, d, e = answer.points
    pitch = pi * 0.003 * cos(radians(20.0))
    assert e.path - a.path == pytest.approx(answer.path_length, rel=1e-13)
    assert (e.path - b.path, d.path - a.path) == pytest.approx((pitch, pitch), rel=1e-12)
    assert a.second_diameter == pytest.approx(answer.second_tip_diameter, rel=1e-14)
    assert e.first_diameter == pytest.approx(answer.first_tip_diameter, rel=1e-14)
    assert (c.sliding_factor, c.first_sliding) == (0.0, 0.0)
    # sliding from the two rotations
    assert e.sliding_speed == pytest.approx(100.0 * e.first_curvature - 50.0 * e.second_curvature, rel=1e-11)
    assert a.first_sliding == pytest.approx(1.0 - a.second_curvature / (2.0 * a.first_curvature), rel=1e-12)


def test_thinning_and_distance_add_their_backlash() -> None:
    nominal = pair(first=Mate(20, 0.2), second=Mate(31, 0.1), pitch=TWO)
    thin = pair(first=Mate(20, 0.2, thinning=5e-5), second=Mate(31, 0.1, thinning=3e-5), pitch=TWO)
    growth = nominal.centre_distance / nominal.reference_distance
    assert thin.circumferential_backlash == pytest.approx(8e-5 * growth, rel=1e-9)
    wide = pair(first=Mate(20, 0.2), second=Mate(31, 0.1), pitch=TWO, centre_distance=nominal.centre_distance + 1e-5)
    # to first order 2 Δa tan α_w
    assert wide.circumferential_backlash == pytest.approx(2e-5 * tan(nominal.working_pressure_angle), rel=2e-3)
    assert wide.normal_backlash < wide.circumferential_backlash


def test_undercut_shortens_the_path() -> None:
    answer = pair(first=Mate(9), second=Mate(40), pitch=TWO, tips=FULL)
    assert answer.nominal_contact_ratio is not None
    assert answer.transverse_contact_ratio < answer.nominal_contact_ratio
    assert [verdict.free for verdict in answer.verdicts[:4]] == [False, True, False, True]
    assert any(advice.code == "interference" for advice in answer.advice)


def handbook_trimming(z1: int, z2: int, answer: object) -> float:
    """θ₁ + inv α_a1 − inv α_w − (z₂/z₁)(θ₂ + inv α_a2 − inv α_w), as handbooks print it."""
    from math import acos, asin, sqrt

    from dynamics_cli.numerics.involute import involute

    one = acos(answer.first_base_diameter / answer.first_tip_diameter)  # type: ignore[attr-defined]
    two = acos(answer.second_base_diameter / answer.second_tip_diameter)  # type: ignore[attr-defined]
    work = involute(answer.working_pressure_angle)  # type: ignore[attr-defined]
    first = asin(sqrt((1 - (cos(one) / cos(two)) ** 2) / (1 - (z1 / z2) ** 2)))
    second = asin(sqrt(((cos(two) / cos(one)) ** 2 - 1) / ((z2 / z1) ** 2 - 1)))
    return first + involute(one) - work - z2 / z1 * (second + involute(two) - work)


@pytest.mark.parametrize("z1", [22, 24, 26, 28, 30, 34, 36, 38])
def test_trimming_agrees_with_the_handbooks_condition(z1: int) -> None:
    z2 = 48
    answer = pair(first=Mate(z1, 0.0), second=Mate(z2, 0.0), pitch=TWO, internal=True, tips=FULL)
    verdict = next(verdict for verdict in answer.verdicts if verdict.kind.startswith("trimming"))
    assert verdict.free == (handbook_trimming(z1, z2, answer) >= 0.0)


def test_trochoid_interference_appears_as_the_numbers_approach() -> None:
    margins = []
    for z1 in range(40, 57):
        answer = pair(first=Mate(z1, 0.0), second=Mate(60, 0.0), pitch=TWO, internal=True, tips=FULL)
        margins.append(next(v.margin for v in answer.verdicts if v.kind.startswith("trochoid")))
    assert margins[0] > 0.0 > margins[-1]
    assert all(later < earlier for earlier, later in pairwise(margins))


def test_extremum_inside_and_at_an_end() -> None:
    assert extremum(lambda x: (x - 0.3) ** 2, lambda x: 2.0 * (x - 0.3), 0.0, 1.0) == pytest.approx(0.3, rel=1e-15)
    assert extremum(lambda x: x, lambda x: 1.0, 0.25, 1.0) == 0.25
    assert extremum(lambda x: -x, lambda x: -1.0, 0.1, 0.7) == 0.7


@pytest.mark.parametrize(("z1", "z2", "x1", "x2"), [(16, 24, 0.0, 0.5), (60, 64, 0.0, 0.0), (20, 90, 0.3, -0.2)])
def test_slopes_of_an_internal_pairs_clearances(z1: int, z2: int, x1: float, x2: float) -> None:
    """Against differences of the clearances themselves."""
    from dynamics_cli.gear.pair.engagement import at_tight_distance
    from dynamics_cli.gear.pair.interference import _Corner, _last_turn
    from dynamics_cli.gear.single.gear import Gear
    from dynamics_cli.gear.single.rack import BasicRack

    made = at_tight_distance(Gear(z1, 0.003, BasicRack(), 0.0, x1), Gear(-z2, 0.003, BasicRack(), 0.0, -x2))
    corner = _Corner(made)
    last = _last_turn(corner)
    for share in (0.3, 0.6, 0.9):
        turn, h = share * last, 1e-6 * last
        for value, slope in ((corner.clearance, corner.clearance_slope), (corner.sideways, corner.sideways_slope)):
            wanted = (value(turn + h) - value(turn - h)) / (2.0 * h)
            assert slope(turn) == pytest.approx(wanted, rel=1e-6, abs=1e-9)


def test_forces_and_bearings_are_in_balance() -> None:
    helix = radians(18.0)
    answer = pair(
        first=Mate(23),
        second=Mate(57),
        pitch=TWO,
        helix_angle=helix,
        hand=Hand("left"),
        power=4000.0,
        speed=150.0,
        first_bearings=Bearings(0.03, 0.05),
        second_bearings=Bearings(-0.02, 0.09),
    )
    forces = answer.forces
    assert forces is not None
    assert answer.torque == pytest.approx(4000.0 / 150.0)
    assert forces.tangential == pytest.approx(2.0 * answer.torque / answer.first_working_diameter)
    assert forces.axial < 0.0
    assert forces.normal == pytest.approx(hypot(forces.tangential, forces.radial, forces.axial), rel=1e-13)
    assert answer.bearings is not None
    for shaft in ("first", "second"):
        left, right = (load for load in answer.bearings if load.shaft == shaft)
        assert left.tangential + right.tangential == pytest.approx(forces.tangential)
        assert left.radial + right.radial == pytest.approx(forces.radial)
        assert left.total == pytest.approx(hypot(left.tangential, left.radial))
    assert answer.second_torque == pytest.approx(answer.torque * 57 / 23)


def test_frequencies() -> None:
    answer = pair(first=Mate(12), second=Mate(60), pitch=TWO, speed=2.0 * pi * 25.0)
    assert answer.mesh_frequency == pytest.approx(300.0)
    assert answer.common_factor == 12
    assert answer.hunting_frequency == pytest.approx(5.0)
    prime = pair(first=Mate(13), second=Mate(60), pitch=TWO, speed=2.0 * pi * 60.0)
    assert prime.hunting_frequency == pytest.approx(1.0)


def test_loss_factor_against_the_integral_of_sliding() -> None:
    """Mean of |v_g|·F over a pitch at constant force, one or two pairs sharing: exact for 1 ≤ ε ≤ 2 by halves."""
    answer = pair(first=Mate(25), second=Mate(40), pitch=TWO, tips=FULL)
    pitch = pi * 0.002 * cos(radians(20.0))
    start, end = answer.points[0].path, answer.points[-1].path
    steps, total = 20000, 0.0
    for k in range(steps):
        place = start + (k + 0.5) * pitch / steps
        pairs = [place] if place + pitch > end else [place, place + pitch]
        total += sum(abs(s) for s in pairs) / len(pairs) / steps
    base = 12.5 * 0.002 * cos(radians(20.0))
    # sliding over the speed of the line of action, |s|(1/r_b1 + 1/r_b2)
    mean = total * (1.0 / base + 1.0 / (base * 40 / 25))
    assert answer.loss_factor == pytest.approx(mean, rel=0.12)
    assert answer.efficiency == pytest.approx(1.0 - 0.06 * answer.loss_factor)


REFUSED = {
    "involute-below-zero": {"first": Mate(10, -0.5), "second": Mate(12, -0.5)},
    "centre-distance": {"first": Mate(20), "second": Mate(30), "centre_distance": 0.046},
    "jammed": {"first": Mate(20, 0.3), "second": Mate(30, 0.3), "centre_distance": 0.0502},
    "ring-too-small": {"first": Mate(30), "second": Mate(30), "internal": True},
    "tip-inside-base": {"first": Mate(18), "second": Mate(24), "internal": True},
    "open-mesh": {"first": Mate(20, 0.0), "second": Mate(30, 0.0), "centre_distance": 0.0545},
    "pointed": {"first": Mate(8, 0.7), "second": Mate(30, 0.0)},
    "load": {"first": Mate(20), "second": Mate(30), "torque": 1.0, "power": 1.0},
    "speed": {"first": Mate(20), "second": Mate(30), "power": 1.0},
    "two-pressure-angles": {
        "first": Mate(20),
        "second": Mate(30),
        "pressure_angle": 0.3,
        "transverse_pressure_angle": 0.3,
    },
    "friction": {"first": Mate(20), "second": Mate(30), "friction": 30.0},
    "helix-angle": {"first": Mate(20), "second": Mate(30), "helix_angle": 1.6},
    "bearings": {"first": Mate(20), "second": Mate(30), "torque": 1.0, "first_bearings": Bearings(0.01, -0.01)},
}


@pytest.mark.parametrize("code", REFUSED)
def test_refusals(code: str) -> None:
    with pytest.raises(InadmissibleError) as caught:
        pair(pitch=TWO, **REFUSED[code])  # type: ignore[arg-type]
    assert caught.value.code == code


def test_the_refusal_says_by_how_much() -> None:
    with pytest.raises(InadmissibleError) as caught:
        pair(first=Mate(10, -0.5), second=Mate(12, -0.5), pitch=TWO)
    # inv 20° − 2 tan 20°/22 = −0.018184
    assert "-0.0181838" in caught.value.message
    assert "-0.450444" in caught.value.message
    mended = pair(first=Mate(40, -0.2), second=Mate(52, -0.2503), pitch=TWO)
    assert degrees(mended.working_pressure_angle) < 20.0
    assert sin(mended.working_pressure_angle) > 0.0


def test_a_tooth_cannot_be_thinned_away() -> None:
    thickness = 0.5 * pi * 0.002
    assert pair(first=Mate(17, thinning=0.99 * thickness), second=Mate(40), pitch=TWO).circumferential_backlash > 0.0
    # nothing is left where the involute begins: m_n·z·(ψ_b − inv α_Ff), 3.648 mm
    pair(first=Mate(17, thinning=3.6e-3), second=Mate(40), pitch=TWO)
    with pytest.raises(InadmissibleError, match=r"vanish at 0\.00364834 m") as refused:
        pair(first=Mate(17, thinning=3.7e-3), second=Mate(40), pitch=TWO)
    assert refused.value.code == "thinning"


def test_a_distance_that_only_absurd_shifts_reach_is_refused_by_their_sum() -> None:
    with pytest.raises(InadmissibleError, match="tips are shortened by 22"):
        pair(first=Mate(17), second=Mate(40), pitch=TWO, centre_distance=0.1)
