"""Where a pair ends: thinned teeth, interference as the exact profiles show it, meshes that do not close."""

import math

import pytest
from harness import run
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp, mpf

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.gear.mesh.mesh import mesh
from dynamics_cli.gear.pair.pair import pair
from dynamics_cli.gear.pair.records import Mate
from dynamics_cli.gear.pitch import NormalModule

ONE = NormalModule(1e-3)


def test_thinned_teeth_end_where_their_flanks_meet() -> None:
    """Thinning reaches the tip: 40-digit values of the pointed diameter and the contact ratio that is left."""
    mp.dps = 40
    base, angle = 40 * mp.cos(mp.pi / 9), mp.pi / 9
    half = (mp.pi * 2 / 2 - 2) / 40 + mp.tan(angle) - angle
    pressure = mp.findroot(lambda a: mp.tan(a) - a - half, mp.mpf("0.45"))
    pointed = base / mp.cos(pressure)
    recess = base / 2 * mp.tan(pressure) + mp.sqrt(42**2 - base**2) - 60 * mp.sin(angle)
    answer = pair(first=Mate(20, thinning=2e-3), second=Mate(40), pitch=NormalModule(2e-3))
    assert 1e3 * answer.first_tip_diameter == pytest.approx(float(pointed), rel=1e-13)
    assert answer.transverse_contact_ratio == pytest.approx(float(recess / (2 * mp.pi * mp.cos(angle))), rel=1e-13)
    assert round(answer.transverse_contact_ratio, 3) == 1.397
    assert answer.second_tip_diameter == 84e-3
    assert "pointed" in [one.code for one in answer.advice]
    # a ring's teeth become pointed towards its centre
    ring = pair(first=Mate(20), second=Mate(60, thinning=2.3e-3), pitch=NormalModule(2e-3), internal=True)
    pressure = mp.findroot(lambda a: mp.tan(a) - a - (mp.tan(angle) - angle - (mp.pi - 2.3) / 120), mp.mpf("0.3"))
    assert 1e3 * ring.second_tip_diameter == pytest.approx(float(120 * mp.cos(angle) / mp.cos(pressure)), rel=1e-13)


def test_thinning_that_leaves_a_land_leaves_the_tip() -> None:
    answer = pair(first=Mate(20, thinning=0.2e-3), second=Mate(40), pitch=NormalModule(2e-3))
    assert (
        answer.first_tip_diameter == pair(first=Mate(20), second=Mate(40), pitch=NormalModule(2e-3)).first_tip_diameter
    )
    assert "pointed" not in [one.code for one in answer.advice]


OVERLAPS = [
    (14, 100, False, {}, False),  # undercut: the root that the tip would enter is cut away
    (12, 80, False, {}, False),
    (30, 60, True, {}, True),
    (20, 40, False, {}, False),
    (17, 200, False, {}, False),
    (20, 60, True, {"shift": 0.3}, True),
    (30, 60, True, {"shift": -0.4}, False),
    (38, 73, False, {"tips": 0.2e-3}, None),
    (14, 100, True, {}, True),
]


@pytest.mark.parametrize(("z1", "z2", "internal", "more", "overlaps"), OVERLAPS)
def test_severities_are_those_of_the_proof(z1: int, z2: int, internal: bool, more: dict, overlaps: bool | None) -> None:
    """A pair's interference is serious where the exact profiles that `gear mesh` turns overlap, and only there."""
    shift = more.get("shift", 0.0)
    plain = pair(first=Mate(z1), second=Mate(z2, shift), pitch=ONE, internal=internal)
    tips = [plain.first_tip_diameter + more.get("tips", 0.0), plain.second_tip_diameter + more.get("tips", 0.0)]
    mates = Mate(z1, 0.0, tip_diameter=tips[0]), Mate(z2, shift, tip_diameter=tips[1])
    answer = pair(first=mates[0], second=mates[1], pitch=ONE, internal=internal)
    proof = mesh(
        first_teeth=z1, second_teeth=z2, pitch=ONE, internal=internal, second_profile_shift=shift,
        first_tip_diameter=tips[0], second_tip_diameter=tips[1], points=100,
    )  # fmt: skip
    gaps = [proof.first_in_second, proof.second_in_first]
    deepest = min((gap for gap in gaps if gap is not None), default=1.0)
    serious = [one for one in answer.advice if one.code == "interference" and one.severity == "serious"]
    assert bool(serious) == (deepest < -1e-9)
    assert overlaps is None or bool(serious) == overlaps
    found = [one.margin for one in answer.verdicts if one.kind.startswith("profiles")]
    assert found == [] or min(found) == pytest.approx(deepest, abs=1e-12)


@settings(max_examples=15, deadline=None)
@given(st.integers(8, 40), st.integers(10, 90), st.floats(-0.4, 0.8), st.floats(-0.4, 0.8))
def test_roots_that_are_not_searched_have_room(z1: int, z2: int, x1: float, x2: float) -> None:
    """Where the pair looks at no exact root, the proof of the same gears finds none in the way."""
    try:
        answer = pair(first=Mate(z1, x1), second=Mate(z2, x2), pitch=ONE)
    except InadmissibleError:
        return
    if any(one.kind.startswith("profiles") for one in answer.verdicts):
        return
    proof = mesh(
        first_teeth=z1, second_teeth=z2, pitch=ONE, first_profile_shift=x1, second_profile_shift=x2,
        first_tip_diameter=answer.first_tip_diameter, second_tip_diameter=answer.second_tip_diameter, points=100,
    )  # fmt: skip
    assert all(gap is None or gap > -1e-9 for gap in (proof.first_in_second, proof.second_in_first))


@pytest.mark.parametrize(("z1", "z2", "x1", "x2"), [(1000, 1000, "5", "-4.9"), (300, 100, "-2.2", "0.3")])
def test_teeth_far_from_their_reference_circle(z1: int, z2: int, x1: str, x2: str) -> None:
    """The reference circle lies beyond the teeth, where their thickness would be negative: 40-digit closed forms."""
    with mp.workdps(40):
        alpha = mp.pi / 9
        value = mp.tan(alpha) - alpha + 2 * (mpf(x1) + mpf(x2)) * mp.tan(alpha) / (z1 + z2)
        working = mp.findroot(lambda a: mp.tan(a) - a - value, mpf("0.34"))
        distance = (z1 + z2) * mp.cos(alpha) / mp.cos(working) / 2
        assert any(mp.pi / 2 + 2 * mpf(x) * mp.tan(alpha) < 0 for x in (x1, x2))
        answer = pair(first=Mate(z1, float(x1)), second=Mate(z2, float(x2)), pitch=ONE)
        assert 1e3 * answer.centre_distance == pytest.approx(float(distance), rel=1e-13)
        assert answer.transverse_contact_ratio > 1.5


def test_backlash_of_gears_that_no_distance_closes() -> None:
    """inv α_w < 0, and yet the gears run at a wider distance: the play is that of the turned profiles."""
    mates = Mate(19, -0.59), Mate(29, -0.678)
    with pytest.raises(InadmissibleError, match="inv α_w would be"):
        pair(first=mates[0], second=mates[1], pitch=ONE)
    answer = pair(first=mates[0], second=mates[1], pitch=ONE, centre_distance=23.184e-3)
    proof = mesh(
        first_teeth=19,
        second_teeth=29,
        first_profile_shift=-0.59,
        second_profile_shift=-0.678,
        pitch=ONE,
        centre_distance=23.184e-3,
    )
    assert proof.runs
    assert answer.involute < 0.0
    assert answer.normal_backlash == pytest.approx(proof.backlash, rel=1e-12)
    assert answer.transverse_contact_ratio == pytest.approx(proof.contact_ratio, rel=1e-12)


def test_jammed_gears_are_called_jammed() -> None:
    """Not an open mesh, which tips shortened by a distance far too small would make of it."""
    with pytest.raises(InadmissibleError) as refused:
        pair(first=Mate(21, 0.55), second=Mate(60, -0.14), pitch=ONE, internal=True, centre_distance=21.07e-3)
    assert refused.value.code == "jammed"


@pytest.mark.parametrize("command", ["pair", "mesh"])
@pytest.mark.parametrize(
    ("words", "status", "hint"),
    [
        # the base circles all but touch: the roots' ends have passed each other
        (("20", "40", "28.27 mm", "-0.61", "-0.61"), 3, "raise the centre distance"),
        (("20", "40", "33 mm", "0", "0"), 3, "nearer"),
    ],
)
def test_an_open_mesh_is_refused_alike_with_what_closes_it(command: str, words: tuple, status: int, hint: str) -> None:
    z1, z2, distance, x1, x2 = words
    outcome = run(
        "gear", command, "--first-teeth", z1, "--second-teeth", z2, "--module", "1 mm", "--centre-distance", distance,
        f"--first-profile-shift={x1}", f"--second-profile-shift={x2}", "--json",
    )  # fmt: skip
    assert outcome.status == status
    assert outcome.error["code"] == "open-mesh"
    wanted = "lower the centre distance" if hint == "nearer" else hint
    assert outcome.error["hint"].startswith(wanted)


def test_a_ring_needs_more_teeth_than_its_pinion_in_a_proof_too() -> None:
    with pytest.raises(InadmissibleError) as refused:
        mesh(first_teeth=51, second_teeth=50, pitch=ONE, internal=True, centre_distance=1.1e-3)
    assert refused.value.code == "ring-too-small"


@pytest.mark.parametrize(
    ("z1", "z2", "x1", "internal", "distance"),
    [(20, 40, 0.1, False, None), (24, 31, 0.0, False, 27.7e-3), (25, 80, 0.0, True, None)],
)
def test_a_backlash_is_cut_by_its_generating_shifts(
    z1: int, z2: int, x1: float, internal: bool, distance: float | None
) -> None:
    """Gears cut with the generating shifts turn with the backlash that was asked for, found from their profiles."""
    answer = pair(
        first=Mate(z1, x1), second=Mate(z2, 0.0), pitch=ONE, internal=internal, centre_distance=distance, backlash=2e-4
    )
    assert answer.circumferential_backlash == pytest.approx(2e-4, rel=1e-12)
    proof = mesh(
        first_teeth=z1,
        second_teeth=z2,
        pitch=ONE,
        internal=internal,
        centre_distance=answer.centre_distance,
        first_profile_shift=answer.first_generating_shift,
        second_profile_shift=answer.second_generating_shift,
        first_tip_diameter=answer.first_tip_diameter,
        second_tip_diameter=answer.second_tip_diameter,
        points=1000,
    )
    assert proof.backlash == pytest.approx(answer.normal_backlash, rel=1e-9)
    found = [one.margin for one in answer.verdicts if one.kind.startswith("profiles")]
    gaps = [gap for gap in (proof.first_in_second, proof.second_in_first) if gap is not None]
    assert found == [] or found == pytest.approx(gaps, abs=1e-11)


def test_generating_shifts_of_a_thinning() -> None:
    """x_E = x − A_sn/(2 m_n tan α_n)."""
    answer = pair(first=Mate(20, 0.3, thinning=0.1e-3), second=Mate(40), pitch=ONE)
    wanted = mpf("0.3") - mpf("0.1") / (2 * mp.tan(mp.pi / 9))
    assert answer.first_generating_shift == pytest.approx(float(wanted), rel=1e-14)
    assert answer.second_generating_shift is None


@pytest.mark.parametrize(
    ("more", "code"), [({"backlash": 1e-6, "centre_distance": 30.5e-3}, "backlash"), ({"thin": 1e-5}, "thinning")]
)
def test_a_backlash_that_cannot_be(more: dict, code: str) -> None:
    first = Mate(20, 0.0, thinning=more.pop("thin", 0.0))
    with pytest.raises(InadmissibleError) as refused:
        pair(first=first, second=Mate(40, 0.0), pitch=ONE, **({"backlash": 1e-4} | more))
    assert refused.value.code == code


@pytest.mark.parametrize(("teeth", "mate"), [(12, 43), (9, 43), (14, 60)])
def test_the_remedy_of_an_undercut_pinion_is_the_shift_that_frees_the_mesh(teeth: int, mate: int) -> None:
    cut = pair(first=Mate(teeth), second=Mate(mate), pitch=NormalModule(2e-3))
    remedies = {advice.remedy for advice in cut.advice if advice.code == "interference"}
    assert len(remedies) == 1
    words = next(iter(remedies)).split()
    shift = float(next(word for word in words if word[0] == "0"))
    assert 0.0 <= shift - (1.0 - teeth * math.sin(math.radians(20.0)) ** 2 / 2.0) <= 2e-3
    kept = pair(first=Mate(teeth, shift), second=Mate(mate), pitch=NormalModule(2e-3))
    assert not [advice for advice in kept.advice if advice.code == "interference"]
