"""Meshes: turned profiles against the closed forms of the pair, and against polygons that may or may not overlap."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.gear import options
from dynamics_cli.gear.mesh import flank_clearance
from dynamics_cli.gear.mesh.mesh import MeshProof, forms_of, mesh
from dynamics_cli.gear.pitch import NormalModule
from dynamics_cli.gear.single.flanks import ToothForm, flank
from dynamics_cli.gear.single.gear import Sign
from dynamics_cli.gear.single.outline import chain_points

MM = 1e-3
M2 = NormalModule(2 * MM)


def involute(angle: float) -> float:
    return math.tan(angle) - angle


@settings(max_examples=15, deadline=None)
@given(st.integers(18, 120), st.integers(18, 200), st.floats(0.0, 0.4), st.floats(0.0, 0.4), st.floats(0.0, 0.6))
def test_an_external_pair_keeps_its_closed_forms(z1: int, z2: int, x1: float, x2: float, beta: float) -> None:
    answer = mesh(
        first_teeth=z1,
        second_teeth=z2,
        pitch=M2,
        first_profile_shift=x1,
        second_profile_shift=x2,
        helix_angle=beta,
        points=500,
    )
    at = math.atan(math.tan(math.radians(20)) / math.cos(beta))
    r1, r2 = z1 * MM / math.cos(beta), z2 * MM / math.cos(beta)
    b1, b2 = r1 * math.cos(at), r2 * math.cos(at)
    working = answer.working_pressure_angle
    wanted = involute(at) + 2 * (x1 + x2) * math.tan(math.radians(20)) / (z1 + z2)
    assert involute(working) == pytest.approx(wanted, rel=1e-11)
    a1, a2 = r1 + (1 + x1) * 2 * MM, r2 + (1 + x2) * 2 * MM
    reach = math.sqrt(a1**2 - b1**2) + math.sqrt(a2**2 - b2**2) - answer.centre_distance * math.sin(working)
    pitch = 2 * math.pi * b1 / z1
    assert answer.nominal_contact_ratio == pytest.approx(reach / pitch, rel=1e-11)
    assert answer.contact_ratio <= answer.nominal_contact_ratio * (1 + 1e-14)
    assert answer.transmission_error < 1e-13
    assert abs(answer.backlash) < 1e-15 * 1e3
    assert all(check.passed for check in answer.checks)


@pytest.mark.parametrize(("z1", "z2", "x2"), [(20, 60, 0.0), (16, 24, -0.5), (40, 100, -0.2), (30, 200, 0.1)])
def test_an_internal_pair_keeps_its_closed_forms(z1: int, z2: int, x2: float) -> None:
    answer = mesh(first_teeth=z1, second_teeth=z2, pitch=M2, internal=True, second_profile_shift=x2, points=500)
    alpha = math.radians(20)
    wanted = involute(alpha) - 2 * x2 * math.tan(alpha) / (z2 - z1)
    assert involute(answer.working_pressure_angle) == pytest.approx(wanted, rel=1e-11)
    b1, b2 = z1 * MM * math.cos(alpha), z2 * MM * math.cos(alpha)
    assert answer.centre_distance == pytest.approx((b2 - b1) / math.cos(answer.working_pressure_angle), rel=1e-13)
    a1, a2 = z1 * MM + 2 * MM, z2 * MM - (1 + x2) * 2 * MM
    reach = (
        math.sqrt(a1**2 - b1**2)
        - math.sqrt(a2**2 - b2**2)
        + answer.centre_distance * math.sin(answer.working_pressure_angle)
    )
    assert answer.nominal_contact_ratio == pytest.approx(reach / (2 * math.pi * b1 / z1), rel=1e-11)
    assert answer.transmission_error < 1e-13
    assert abs(answer.backlash) < 1e-12


def test_a_hundred_thousand_points_turn_evenly() -> None:
    answer = mesh(first_teeth=17, second_teeth=53, pitch=M2, first_profile_shift=0.3)
    assert answer.contact_points == 100_000
    assert answer.transmission_error < 1e-14


@given(st.floats(-0.2e-3, 0.5e-3))
@settings(max_examples=10, deadline=None)
def test_backlash_follows_the_centre_distance(more: float) -> None:
    """j = 2 p·(inv α_w' − inv α_w)·…: from the working angles at both distances."""
    base = mesh(first_teeth=20, second_teeth=40, pitch=M2, points=10)
    wider = mesh(first_teeth=20, second_teeth=40, pitch=M2, centre_distance=base.centre_distance + more, points=10)
    bases = 60 * MM * math.cos(math.radians(20.0))
    wanted = 2 * bases * (involute(wider.working_pressure_angle) - involute(base.working_pressure_angle))
    assert wider.backlash == pytest.approx(wanted, abs=1e-16)
    assert ("jam" in [one.code for one in wider.advice]) == (wider.backlash < -1e-12)
    if wider.backlash < -1e-12:
        assert not wider.runs


def overlap(first: ToothForm, second: ToothForm, distance: float, turn: float, play: float) -> bool:
    """Whether any corner of one gear's polygon lies within the other's, both turned by exact angles."""

    def polygon(form: ToothForm, rotation: float, at: float) -> np.ndarray:
        x, y = chain_points(form, flank(form, 1e-7), form.teeth)
        points = (x.ravel() + 1j * y.ravel()) * np.exp(1j * rotation)
        return points + at

    def inside(points: np.ndarray, shape: np.ndarray) -> np.ndarray:
        hits = np.zeros(points.shape, dtype=bool)
        for a, b in zip(shape, np.roll(shape, -1), strict=True):
            crosses = (a.imag > points.imag) != (b.imag > points.imag)
            if crosses.any():
                at = a.real + (points.imag - a.imag) * (b.real - a.real) / (
                    b.imag - a.imag if b.imag != a.imag else 1.0
                )
                hits ^= crosses & (points.real < at)
        return hits

    # a tooth of gear 1 and a space of gear 2 on the line of centres
    one = polygon(first, -math.pi / 2 + turn, 0.0)
    two = polygon(second, math.pi / 2 + math.pi / second.teeth - turn * first.teeth / second.teeth + play, distance)
    close_one = one[np.abs(one - distance) < second.tip]
    close_two = two[np.abs(two) < first.tip]
    # flanks touch by design: what overlaps only there is rounding and chords
    deep_one = close_one[np.abs(close_one - distance) < second.form * (1 - 1e-5)]
    deep_two = close_two[np.abs(close_two) < first.form * (1 - 1e-5)]
    return bool(inside(deep_one, two).any() or inside(deep_two, one).any())


def forms(answer_of: dict) -> tuple[ToothForm, ToothForm]:
    from test_profile import form_of

    one = form_of(answer_of["first_teeth"], answer_of.get("first_profile_shift", 0.0))
    return one, form_of(answer_of["second_teeth"], answer_of.get("second_profile_shift", 0.0))


@pytest.mark.parametrize(
    ("first_teeth", "second_teeth", "addendum", "fouls"),
    [(20, 40, 1.0, False), (17, 51, 1.0, False), (12, 60, 1.0, False), (30, 30, 1.0, False)],
)
def test_polygons_agree_that_roots_are_clear(first_teeth: int, second_teeth: int, addendum: float, fouls: bool) -> None:
    arguments = {"first_teeth": first_teeth, "second_teeth": second_teeth}
    answer = mesh(pitch=M2, points=10, **arguments)
    one, two = forms(arguments)
    found = any(
        overlap(one, two, answer.centre_distance, turn, 0.0)
        for turn in np.linspace(-1.2, 1.2, 9) * math.pi / first_teeth
    )
    clear = min(x for x in (answer.first_in_second, answer.second_in_first) if x is not None) > -2e-9
    assert found is fouls
    assert clear is not fouls


def test_a_long_tip_digs_into_the_root_it_turns_through() -> None:
    """A wheel with long teeth against a pinion of 20: its tips pass the pinion's form circle off the involute."""
    shorter = mesh(first_teeth=20, second_teeth=200, pitch=M2, points=10)
    longer = mesh(first_teeth=20, second_teeth=200, pitch=M2, second_tip_diameter=404.4 * MM, points=10)
    assert shorter.second_in_first is not None
    assert longer.second_in_first is not None
    assert longer.second_in_first < shorter.second_in_first
    assert longer.second_in_first < -1e-6
    assert not longer.runs
    assert {"interference", "clipped"} <= {one.code for one in longer.advice}


def test_room_beside_the_flanks_does_not_depend_on_where_the_points_fall() -> None:
    """Distances from root and flank grow steadily with the centre distance, as the profiles themselves do."""
    distances = np.linspace(68.05, 68.15, 11) * MM
    proofs = [mesh(first_teeth=17, second_teeth=51, pitch=M2, centre_distance=d, points=10) for d in distances]
    for name in ("first_in_second", "second_in_first"):
        gaps = np.array([getattr(proof, name) for proof in proofs])
        assert (np.diff(gaps) > 0.0).all()
        # a smooth curve: third differences are a small part of first ones
        assert np.abs(np.diff(gaps, 3)).max() < 0.01 * np.diff(gaps).max()


def outlines(first: ToothForm, second: ToothForm, distance: float, play: float) -> float:
    """The least distance of a whole tooth's points from the points of the root it turns through."""
    tooth, space = flank(first, 1e-9), flank(second, 1e-9)
    angle, radius = np.concatenate([-tooth.angle, tooth.angle]), np.concatenate([tooth.radius, tooth.radius])
    below = slice(0, space.joint + 1)
    root = space.radius[below] * np.exp(1j * (math.pi / second.teeth - space.angle[below]))
    least = np.inf
    for turn in np.linspace(-0.5, 0.5, 601):
        points = (distance - radius * np.exp(1j * (angle + turn))) * np.exp(
            1j * (turn * first.teeth / second.teeth - play)
        )
        near = points[np.abs(points) < second.form + 0.3 * second.module]
        for side in (near, near.conj()):
            if len(side):
                least = min(least, float(np.abs(side[:, None] - root).min()))
    return least


@pytest.mark.parametrize(("z1", "z2", "more"), [(12, 24, 0.2), (17, 51, 0.0), (30, 25, 0.5), (13, 70, 0.1)])
def test_distances_from_the_root_are_those_of_whole_outlines(z1: int, z2: int, more: float) -> None:
    """No other point of the tooth comes nearer than the edge of its tip, and none of the root nearer than is said."""
    close = mesh(first_teeth=z1, second_teeth=z2, pitch=M2, points=10)
    distance = close.centre_distance + more * MM
    answer = mesh(first_teeth=z1, second_teeth=z2, pitch=M2, centre_distance=distance, points=10)
    one, two = form_at(z1, z2, internal=False)
    play = max(answer.backlash, 0.0) / (2.0 * two.base)
    for gap, first, second, turned in (
        (answer.first_in_second, one, two, play),
        (answer.second_in_first, two, one, play * z2 / z1),
    ):
        assert gap is not None
        # an involute that gets as far as where the other begins touches it there
        found = outlines(first, second, distance, turned)
        assert gap - 1e-9 * MM <= found <= abs(gap) + 0.001 * MM


def test_a_distance_is_that_of_the_gears_whichever_drives_and_however_large() -> None:
    answer = mesh(first_teeth=19, second_teeth=41, pitch=M2, first_profile_shift=0.2, points=10)
    large = mesh(first_teeth=41, second_teeth=19, pitch=NormalModule(2.0), second_profile_shift=0.2, points=10)
    for one, other in (("first_in_second", "second_in_first"), ("second_in_first", "first_in_second")):
        assert getattr(large, other) == pytest.approx(1e3 * getattr(answer, one), rel=1e-11)


def test_tips_that_stay_beyond_the_form_circle_have_no_distance() -> None:
    answer = mesh(first_teeth=58, second_teeth=76, pitch=M2, internal=True, points=10)
    assert answer.first_in_second is None
    assert "first_in_second" not in {one.result for one in answer.numerics.bounds}
    assert answer.second_in_first is not None


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("internal", [False, True])
def test_sharp_roots_have_room_like_nearly_sharp_ones(internal: bool) -> None:
    common = {"first_teeth": 20, "second_teeth": 60, "pitch": M2, "internal": internal, "points": 10}
    common |= {"first_tip_diameter": 45 * MM} if internal else {}
    sharp, nearly = (mesh(**common, root_radius_factor=radius) for radius in (0.0, 1e-6))
    assert sharp.second_in_first == pytest.approx(nearly.second_in_first, abs=1e-7 * MM)
    assert sharp.first_in_second == pytest.approx(nearly.first_in_second, abs=1e-5 * MM)


def test_every_number_of_a_mesh_has_a_bound() -> None:
    answer = mesh(first_teeth=12, second_teeth=24, pitch=M2, points=10)
    names = {name for name in answer.fields if isinstance(getattr(answer, name), float)}
    columns = {f"path.{name}" for name in answer.path.arrays}
    assert {one.result for one in answer.numerics.bounds} == names | columns


@pytest.mark.parametrize("internal", [False, True])
def test_room_is_the_least_of_many_more_points(internal: bool) -> None:
    teeth = (16, 40) if internal else (12, 24)
    first = form_at(*teeth, internal=internal)
    for one, two in (first, first[::-1]):
        distance = 24.3 * MM if internal else 36.2 * MM
        found = flank_clearance.flank_gap(one, two, distance, 0.0)
        turn, reach = flank_clearance._Turn(one, two, distance, 0.0), flank_clearance._reach(one, two, distance)
        edge = one.half_angle(one.roll(one.tip))
        edge = math.pi / one.teeth - edge if one.internal else edge
        many = min(turn.least(side, np.linspace(-reach, reach, 100_001))[0] for side in (-edge, edge))
        assert many - 2e-6 * MM < found <= many


def form_at(first: int, second: int, *, internal: bool) -> list[ToothForm]:
    more = {"helix_angle": 0.0, "pitch": M2, "profile": options.RACK_A, "pressure_angle": math.radians(20)}
    more |= {"addendum_factor": None, "dedendum_factor": None}
    return forms_of(
        first_teeth=first, second_teeth=second, first_profile_shift=0.0, second_profile_shift=0.0, internal=internal,
        shift_sign=Sign("iso"), root_radius_factor=None, first_tip_diameter=None, second_tip_diameter=None, **more,
    )  # fmt: skip


def turned(answer: MeshProof) -> tuple[float, ...]:
    return (answer.contact_ratio, answer.backlash, answer.centre_distance)


def test_gears_may_be_named_in_either_order() -> None:
    one = mesh(first_teeth=20, second_teeth=45, pitch=M2, first_profile_shift=0.3, points=10)
    other = mesh(first_teeth=45, second_teeth=20, pitch=M2, second_profile_shift=0.3, points=10)
    assert turned(one) == pytest.approx(turned(other), rel=1e-12, abs=1e-15)
    assert one.first_in_second == pytest.approx(other.second_in_first, rel=1e-6)
    assert one.second_in_first == pytest.approx(other.first_in_second, rel=1e-6)
    assert (one.begins_at, one.ends_at) == ("tip of gear 2", "tip of gear 1")


def test_an_undercut_pinion_clips_the_contact() -> None:
    answer = mesh(first_teeth=8, second_teeth=60, pitch=M2, points=10)
    assert answer.begins_at == "form circle of gear 1"
    assert answer.contact_ratio == pytest.approx(0.912751, abs=1e-6)
    assert answer.nominal_contact_ratio > 1.5
    assert not answer.runs
    assert "open-mesh" in {one.code for one in answer.advice}


@pytest.mark.parametrize(("ring", "meets"), [(64, True), (66, True), (68, True), (69, False), (70, False)])
def test_tips_meet_where_tooth_numbers_differ_little(ring: int, meets: bool) -> None:
    """Full-depth 20° teeth: the tips pass one another only when the ring has nine teeth more."""
    answer = mesh(first_teeth=60, second_teeth=ring, pitch=M2, internal=True, points=10)
    assert ("tip-interference" in {one.code for one in answer.advice}) == meets
    # by the tips' own angles: where tip circles cross, the pinion's tip must be ahead of the ring's
    r1, r2, a = 62 * MM, (ring - 2) * MM, answer.centre_distance
    alpha, bases = math.radians(20.0), (60 * MM, ring * MM)
    crossing_first = math.pi - math.acos((r1**2 + a**2 - r2**2) / (2 * r1 * a))
    crossing_second = math.acos((r2**2 + a**2 - r1**2) / (2 * r2 * a))
    tips = [math.acos(base * math.cos(alpha) / r) for base, r in zip(bases, (r1, r2), strict=True)]
    lead = [
        crossing + involute(tip) - involute(alpha)
        for crossing, tip in ((crossing_first, tips[0]), (crossing_second, tips[1]))
    ]
    assert (60 / ring * lead[0] < lead[1]) == meets


def test_one_tooth_of_difference_at_a_high_working_angle() -> None:
    answer = mesh(
        first_teeth=60,
        second_teeth=61,
        pitch=M2,
        internal=True,
        second_profile_shift=-1.0,
        addendum_factor=0.5,
        dedendum_factor=0.7,
        root_radius_factor=0.05,
        points=100,
    )
    assert math.degrees(answer.working_pressure_angle) == pytest.approx(61.06, abs=0.01)
    assert answer.transmission_error < 1e-12


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ({"first_teeth": 20, "second_teeth": 40, "centre_distance": 50 * MM}, "centre-distance"),
        ({"first_teeth": 20, "second_teeth": 40, "centre_distance": 65 * MM}, "open-mesh"),
        (
            {"first_teeth": 20, "second_teeth": 40, "first_profile_shift": -2.5, "second_profile_shift": -2.5},
            "no-flank",
        ),
        (
            {"first_teeth": 100, "second_teeth": 140, "first_profile_shift": -2.5, "second_profile_shift": -2.5},
            "no-working-angle",
        ),
        ({"first_teeth": 20, "second_teeth": 40, "points": 1}, "points"),
        ({"first_teeth": 20, "second_teeth": 40, "points": 10**9}, "points"),
        ({"first_teeth": 2, "second_teeth": 40}, "teeth"),
    ],
)
def test_what_cannot_be_is_refused(arguments: dict, code: str) -> None:
    with pytest.raises(InadmissibleError) as caught:
        mesh(pitch=M2, **arguments)
    assert caught.value.code == code


@pytest.mark.parametrize(
    ("z1", "z2", "x1", "x2", "internal"),
    [(12, 24, 0.6, 0.36, False), (17, 51, 0.0, 0.0, False), (30, 90, -0.2, 0.3, False), (25, 70, 0.1, -0.2, True)],
)
def test_the_stated_bounds_hold(z1: int, z2: int, x1: float, x2: float, internal: bool) -> None:
    """Against 50 digits from the same doubles: distance, working angle, nominal contact ratio, no backlash."""
    from mpmath import acos, cos, findroot, mp, mpf, pi, sqrt, tan

    mp.dps = 50
    answer = mesh(
        first_teeth=z1,
        second_teeth=z2,
        pitch=M2,
        first_profile_shift=x1,
        second_profile_shift=x2,
        internal=internal,
        points=10,
    )
    m, alpha = mpf(2 * MM), mpf(20.0 * math.pi / 180.0)
    sign = -1 if internal else 1
    teeth, shifts = z1 + sign * z2, mpf(x1) + mpf(x2)
    inv = tan(alpha) - alpha + 2 * shifts * tan(alpha) / teeth
    working = findroot(lambda a: tan(a) - a - inv, mpf(answer.working_pressure_angle))
    b1, b2 = z1 * m * cos(alpha) / 2, z2 * m * cos(alpha) / 2
    distance = abs(b1 + sign * b2) / cos(working)
    a1 = z1 * m / 2 + m * (1 + mpf(x1))
    a2 = z2 * m / 2 + sign * m * (1 + mpf(x2))
    assert acos(abs(b1 + sign * b2) / distance) - working < mpf(10) ** -40
    reach = sqrt(a1**2 - b1**2) + sign * sqrt(a2**2 - b2**2) - sign * distance * mp.sin(working)
    ratio = reach / (2 * pi * b1 / z1)
    bounds = {one.result: one.bound for one in answer.numerics.bounds}
    for name, wanted in (
        ("centre_distance", distance),
        ("working_pressure_angle", working),
        ("nominal_contact_ratio", ratio),
    ):
        assert abs(mpf(getattr(answer, name)) / wanted - 1) <= bounds[name], name
        assert bounds[name] < 1e-13, name
    assert abs(answer.backlash) <= bounds["backlash"]


def test_full_tips_are_named_with_those_of_the_pair() -> None:
    from dynamics_cli.gear.pair.pair import pair
    from dynamics_cli.gear.pair.records import Mate

    common = {"first_teeth": 12, "second_teeth": 24, "pitch": NormalModule(0.003)}
    shifts = {"first_profile_shift": 0.6, "second_profile_shift": 0.36}
    (note,) = (one for one in mesh(**common, **shifts, points=100).advice if one.code == "full-tips")
    shortened = pair(first=Mate(12, 0.6), second=Mate(24, 0.36), pitch=NormalModule(0.003))
    assert note.remedy is not None
    for tip in (shortened.first_tip_diameter, shortened.second_tip_diameter):
        assert f'"{tip:.9g} m"' in note.remedy
    tips = {"first_tip_diameter": shortened.first_tip_diameter, "second_tip_diameter": shortened.second_tip_diameter}
    same = mesh(**common, **shifts, **tips, points=100)
    assert same.contact_ratio == pytest.approx(shortened.transverse_contact_ratio, rel=1e-13)
    assert "full-tips" not in [one.code for one in same.advice]
    assert "full-tips" not in [one.code for one in mesh(**common, points=100).advice]
