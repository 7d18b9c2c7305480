"""Sizes of rockers, pairs and tracks: no smaller base circle keeps the limits on a dense grid of cam angles."""

import random
from math import cos, hypot, inf, pi, radians, sin

import numpy as np
import pytest
from geometry_cases import CYCLE, NOTHING, STEEP, SWING, random_program
from search_length import EVALUATIONS

from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.program.reading import motion_of
from dynamics_cli.cam.sizing import records, size
from dynamics_cli.errors import InadmissibleError

HAIR = 1e-9


def dense(program: str):
    """Lift and two derivatives at many angles of every zone, ends among them."""
    motion = motion_of(NOTHING, program)
    share = 0.5 - 0.5 * np.cos(np.linspace(0.0, pi, 3001))
    columns = [motion.in_zone(index, share, 2) for index in range(len(motion.zones))]
    return [np.concatenate([np.broadcast_to(column[k], share.shape) for column in columns]) for k in range(3)]


def keeps(follower, states, limits, least, *, rotation="ccw", flank="inner") -> bool:
    """Whether a cam keeps its limits at every angle of the grid, but for a hair."""
    try:
        geometry = Geometry(follower, rotation, flank)
    except InadmissibleError:
        return False
    touch = geometry.touch(*states)
    steep = (touch.pressure_angle.max() <= limits[0] + HAIR) and (-touch.pressure_angle.min() <= limits[1] + HAIR)
    if least is None:
        return bool(steep)
    if touch.radius is not None:
        return bool(steep and touch.radius.min() >= least - HAIR)
    bend = geometry.side * touch.curvature
    round_ = 1.0 / bend.max() - geometry.roller if bend.max() > 0.0 else inf
    return bool(steep and round_ >= least - HAIR)


def smaller_ones_fail(make, base: float, states, limits, least, **given) -> bool:
    return not any(
        keeps(make(share * base), states, limits, least, **given)
        for share in (*np.linspace(0.02, 0.99, 60), 1.0 - 1e-5)
    )


@pytest.mark.parametrize("seed", range(12))
def test_no_smaller_base_circle_suits_a_flat_rocker(seed: int) -> None:
    chance = random.Random(seed)
    program = random_program(chance, swing=True)
    pivot, back = chance.uniform(0.09, 0.13), chance.choice([0.0, 0.006, -0.004])
    rotation = followers.Rotation(chance.choice(["ccw", "cw"]))
    least, limits = chance.choice([0.0, 0.002, 0.01]), (radians(35), radians(40))
    wanted = records.OscillatingFlat(pivot, back, 0.001)
    given = {"rise_limit": limits[0], "return_limit": limits[1], "least_radius": least, "rotation": rotation}
    states = dense(program)
    made = [followers.OscillatingFlat(base, pivot, back) for base in np.linspace(0.0, pivot - abs(back), 400)[:-1]]
    turns = -1.0 if rotation == "clockwise" else 1.0
    follows = (1.0 + turns * states[1]).min() > 0.0
    if not follows or not any(keeps(one, states, limits, least, rotation=rotation) for one in made):
        with pytest.raises(InadmissibleError) as error:
            size.size(NOTHING, program=program, follower=wanted, **given)
        assert error.value.code in ("limits-clash", "face-too-fast")
        return
    found = size.size(NOTHING, program=program, follower=wanted, **given)
    assert all(one.passed for one in found.checks)
    assert keeps(followers.OscillatingFlat(found.base_radius, pivot, back), states, limits, least, rotation=rotation)
    if found.binding == "least radius of curvature":
        assert found.least_convex_radius == pytest.approx(least, abs=1e-12)
        assert smaller_ones_fail(
            lambda base: followers.OscillatingFlat(base, pivot, back),
            found.base_radius, states, limits, least, rotation=rotation,
        )  # fmt: skip


@pytest.mark.parametrize("seed", range(12))
def test_a_pair_on_a_slide_keeps_its_limits_on_both_cams_and_no_nearer_rollers_do(seed: int) -> None:
    chance = random.Random(100 + seed)
    program, states = random_program(chance), None
    limits = radians(chance.uniform(20, 40)), radians(chance.uniform(20, 40))
    offset, least = chance.choice([0.0, 0.004]), chance.choice([None, 0.012])
    rotation = followers.Rotation(chance.choice(["ccw", "cw"]))

    def sized(distance):
        wanted = records.ConjugateRoller(0.006, distance, offset)
        return size.size(NOTHING, program=program, follower=wanted, rise_limit=limits[0], return_limit=limits[1],
                         least_radius=least, rotation=rotation)  # fmt: skip

    found, states = sized(None), dense(program)
    base, apart = found.base_radius, found.roller_distance
    given = {"rotation": rotation}
    assert keeps(followers.Roller(base, 0.006, offset), states, limits, least, **given)
    assert keeps(followers.ConjugateRoller(base, 0.006, apart, offset), states, limits, least, **given)
    if base > 0.0:
        assert smaller_ones_fail(lambda one: followers.Roller(one, 0.006, offset), base, states, limits, least, **given)
    near = followers.ConjugateRoller(base, 0.006, apart * (1.0 - 1e-5), offset)
    assert not keeps(near, states, limits, least, **given)
    assert all(one.passed for one in found.checks)
    # farther rollers leave the first cam as it is, nearer ones are refused with the distance that would do
    assert sized(1.2 * apart).base_radius == base
    with pytest.raises(InadmissibleError) as error:
        sized(0.99 * apart)
    assert error.value.code == "limits-clash"
    assert f"{apart:.6g} m" in error.value.hint


@pytest.mark.parametrize("seed", range(8))
def test_a_pair_on_a_rocker_keeps_its_limits_on_both_cams(seed: int) -> None:
    chance = random.Random(200 + seed)
    program = random_program(chance, swing=True)
    arm, pivot = 0.08, chance.uniform(0.1, 0.12)
    limits, least = (radians(chance.uniform(35, 50)), radians(chance.uniform(35, 50))), chance.choice([None, 0.012])
    rotation = followers.Rotation(chance.choice(["ccw", "cw"]))

    def sized(angle):
        wanted = records.ConjugateOscillatingRoller(0.006, arm, pivot, angle)
        return size.size(NOTHING, program=program, follower=wanted, rise_limit=limits[0], return_limit=limits[1],
                         least_radius=least, rotation=rotation)  # fmt: skip

    found, states = sized(None), dense(program)
    base, given = found.base_radius, {"rotation": rotation}
    assert keeps(followers.OscillatingRoller(base, 0.006, arm, pivot), states, limits, least, **given)
    second = followers.ConjugateOscillatingRoller(base, 0.006, arm, pivot, found.arm_angle)
    assert keeps(second, states, limits, least, **given)
    assert smaller_ones_fail(
        lambda one: followers.OscillatingRoller(one, 0.006, arm, pivot), base, states, limits, least, **given
    )
    near = followers.ConjugateOscillatingRoller(base, 0.006, arm, pivot, found.arm_angle - 1e-5)
    assert not keeps(near, states, limits, least, **given)
    with pytest.raises(InadmissibleError) as error:
        sized(found.arm_angle - 0.01)
    assert error.value.code == "limits-clash"


@pytest.mark.parametrize("least", [0.005, 0.03, 0.08])
@pytest.mark.parametrize("rotation", ["ccw", "cw"])
def test_an_outer_flank_is_as_round_where_its_roller_path_is_hollow(least: float, rotation: str) -> None:
    given = {"rise_limit": radians(80), "return_limit": radians(80), "least_radius": least,
             "rotation": followers.Rotation(rotation), "flank": followers.Flank("outer")}  # fmt: skip
    found = size.size(NOTHING, program=CYCLE, follower=records.Roller(0.006, 0.003), **given)
    assert found.binding == "least radius of curvature"
    assert found.least_concave_radius == pytest.approx(least, rel=1e-10)
    assert smaller_ones_fail(
        lambda base: followers.Roller(base, 0.006, 0.003), found.base_radius, dense(CYCLE), (1.4, 1.4), least,
        rotation=rotation, flank="outer",
    )  # fmt: skip
    swung = size.size(NOTHING, program=SWING, follower=records.OscillatingRoller(0.006, 0.08, 0.1), **given)
    assert swung.least_concave_radius >= least * (1.0 - 1e-10)


@pytest.mark.parametrize(
    ("program", "wanted", "options", "code"),
    [
        (SWING, records.OscillatingFlat(0.1), {"flank": followers.Flank("outer")}, "flank"),
        (CYCLE, records.KnifeEdge(), {"flank": followers.Flank("outer")}, "flank"),
        (CYCLE, records.ConjugateRoller(0.006), {"flank": followers.Flank("outer")}, "flank"),
        (SWING, records.OscillatingFlat(0.02, 0.03), {}, "pivot-inside"),
        (SWING, records.OscillatingFlat(0.03), {"least_radius": 0.1}, "curvature-binds"),
        (CYCLE, records.OscillatingFlat(0.1), {}, "lift-kind"),
        (SWING, records.ConjugateRoller(0.006), {}, "lift-kind"),
        ("rise 40 deg in 60 deg; return in 30 deg; dwell", records.OscillatingFlat(0.1), {}, "face-too-fast"),
        (SWING, records.OscillatingFlat(0.1, 0.09), {"return_limit": radians(10)}, "limits-clash"),
        (SWING, records.OscillatingRoller(0.006, 0.08, 0.1), {"least_radius": 1.0}, "curvature-binds"),
        (SWING, records.ConjugateOscillatingRoller(0.006, 0.2, 0.1), {}, "limit-binds"),
    ],
)
def test_what_cannot_be_is_refused_with_what_binds(program: str, wanted, options, code: str) -> None:
    with pytest.raises(InadmissibleError) as error:
        size.size(NOTHING, program=program, follower=wanted, **options)
    assert error.value.code == code
    assert error.value.hint


def start_radius_by_grid(program: str, limits, wanted: float, low: float, high: float) -> float:
    """The smallest start radius over a grid of offsets, the height of each by bisection on a dense grid of angles."""
    states = dense(program)

    def radius(e: float) -> float:
        def kept(d: float) -> bool:
            x, y = d + states[0], states[1] - e
            if x.min() <= 0.0:
                return False
            w = np.hypot(x, y)
            bend = (w * w + y * states[1] - x * states[2]) / w**3
            angle = np.arctan2(y, x)
            return bool(bend.max() <= 1.0 / wanted and angle.max() <= limits[0] and -angle.min() <= limits[1])

        a, b = 0.0, 1.0
        for _ in range(42):
            middle = 0.5 * (a + b)
            a, b = (a, middle) if kept(middle) else (middle, b)
        return hypot(e, b)

    return min(radius(e) for e in np.linspace(low, high, 121))


@pytest.mark.parametrize("seed", range(EVALUATIONS // 30))
def test_no_offset_on_a_grid_beats_the_one_found_for_a_curvature(seed: int) -> None:
    chance = random.Random(300 + seed)
    program = random_program(chance)
    limits = radians(chance.uniform(25, 45)), radians(chance.uniform(25, 45))
    least = chance.uniform(0.01, 0.06)
    found = size.size(NOTHING, program=program, follower=records.Roller(0.006), rise_limit=limits[0],
                      return_limit=limits[1], least_radius=least)  # fmt: skip
    assert found.numerics is not None
    assert found.numerics.bounds[0].bound <= 1e-9
    radius = found.start_radius
    coarse = start_radius_by_grid(program, limits, least + 0.006, -radius, radius)
    close = start_radius_by_grid(program, limits, least + 0.006, found.offset - 1e-4, found.offset + 1e-4)
    assert coarse >= radius * (1.0 - 1e-6)
    # a grid of angles sees a little less curvature than there is
    assert close == pytest.approx(radius, rel=2e-6)


def test_a_flat_rocker_about_a_far_pivot_is_a_flat_slide() -> None:
    # the arm so long that its swing is a lift: ρ = R + s + s″ with s = cψ
    pivot, lift = 1e4, 0.01
    turn = lift / pivot
    swing = f"rise {turn!r} rad in 120 deg 3-4-5; dwell 60 deg; return in 120 deg 3-4-5; dwell"
    slide = f"rise {lift!r} m in 120 deg 3-4-5; dwell 60 deg; return in 120 deg 3-4-5; dwell"
    far = size.size(NOTHING, program=swing, follower=records.OscillatingFlat(pivot), least_radius=0.004)
    near = size.size(NOTHING, program=slide, follower=records.FlatFace(), least_radius=0.004)
    assert far.base_radius == pytest.approx(near.base_radius, rel=1e-4)


def test_a_symmetric_pair_has_rollers_of_one_start_radius_at_half_lift() -> None:
    program = "rise 10 mm in 180 deg cycloidal; return in 180 deg cycloidal"
    found = size.size(NOTHING, program=program, follower=records.ConjugateRoller(0.006))
    assert found.second.start_radius - 0.01 == pytest.approx(found.start_radius, rel=1e-13)
    assert found.second.largest_pressure_angle == pytest.approx(found.largest_pressure_angle, rel=1e-12)
    swing = "rise 12 deg in 180 deg cycloidal; return in 180 deg cycloidal"
    arms = size.size(NOTHING, program=swing, follower=records.ConjugateOscillatingRoller(0.006, 0.08, 0.1))
    second = arms.arm_angle - arms.arm_start_angle
    assert arms.second.start_radius == pytest.approx(hypot(0.1 - 0.08 * cos(second), 0.08 * sin(second)), rel=1e-13)


def test_an_edge_where_the_velocity_jumps_is_told() -> None:
    line = "rise 10 mm in 180 deg linear; return in 180 deg linear"
    made = size.size(NOTHING, program=line, follower=records.Roller(0.006))
    assert made.advice[-1].code == "velocity-jump"
    assert not size.size(NOTHING, program=CYCLE, follower=records.Roller(0.006)).advice


@pytest.mark.parametrize("least", [0.005, 0.05, 0.3])
def test_the_size_under_a_curvature_has_its_mirror_images(least: float) -> None:
    line = "rise 19.4 mm in 129 deg modified-sine; dwell 20 deg; return in 10 deg 3-4-5; dwell"
    backwards = "rise 19.4 mm in 10 deg 3-4-5; dwell 20 deg; return in 129 deg modified-sine; dwell"

    def sized(program: str, rise: float, back: float, rotation: str) -> records.CamSize:
        return size.size(NOTHING, program=program, follower=records.Roller(0.004), least_radius=least, rise_limit=rise,
                         return_limit=back, rotation=followers.Rotation(rotation))  # fmt: skip

    one = sized(line, 1.35, 0.47, "ccw")
    for other, side in (
        (sized(line, 1.35, 0.47, "cw"), -1.0),
        (sized(backwards, 0.47, 1.35, "ccw"), -1.0),
        (sized(backwards, 0.47, 1.35, "cw"), 1.0),
    ):
        assert other.base_radius == pytest.approx(one.base_radius, rel=1e-12)
        assert other.offset == pytest.approx(side * one.offset, rel=1e-7)
        assert all(check.passed for check in other.checks)


def test_an_arm_that_returns_faster_than_the_cam_turns_is_refused_where_it_must() -> None:
    line = "rise 20 deg in 132 deg 5-6-7-8-9; dwell 10 deg; return in 3 deg cubic; dwell"
    with pytest.raises(InadmissibleError) as error:
        size.size(NOTHING, program=line, follower=records.OscillatingRoller(0.002, 0.065, 0.057), rise_limit=1.27,
                  return_limit=1.46)  # fmt: skip
    assert error.value.code in ("limit-binds", "limits-clash")


@pytest.mark.parametrize(
    ("program", "wanted"),
    [
        (CYCLE, records.Roller(0.006)),
        (CYCLE, records.FlatFace()),
        (CYCLE, records.ConjugateRoller(0.006)),
        (SWING, records.OscillatingRoller(0.008, 0.08, 0.1)),
        (SWING, records.OscillatingFlat(0.09, 0.004)),
        (SWING, records.ConjugateOscillatingRoller(0.008, 0.08, 0.1)),
    ],
)
def test_sizes_are_known_to_eleven_digits(program: str, wanted) -> None:
    found = size.size(NOTHING, program=program, follower=wanted, rise_limit=0.8, return_limit=0.8)
    assert found.numerics is not None
    assert all(bound.bound < 1e-11 for bound in found.numerics.bounds)


@pytest.mark.parametrize("rotation", ["ccw", "cw"])
def test_a_cam_left_with_a_point_is_not_called_undercut(rotation: str) -> None:
    for program, wanted, least in (
        (STEEP, records.Roller(0.015), 0.0),
        (SWING, records.OscillatingRoller(0.03, 0.08, 0.1), 0.0),
        (CYCLE, records.ConjugateRoller(0.03), 0.0),
        ("dwell", records.Roller(0.006), None),
    ):
        found = size.size(NOTHING, program=program, follower=wanted, rise_limit=1.2, return_limit=1.2,
                          least_radius=least, rotation=followers.Rotation(rotation))  # fmt: skip
        radii = [found.least_convex_radius, *([found.second.least_convex_radius] if found.second else [])]
        codes = [one.code for one in found.advice]
        assert "undercut" not in codes
        assert ("sharp" in codes) == (min(radii) < 1e-12)


def test_the_checks_of_a_pair_do_not_depend_on_its_size() -> None:
    line = "rise {0!r} m in 120 deg 3-4-5; dwell 60 deg; return in 120 deg 3-4-5; dwell"
    for scale in (1e-6, 1.0, 1e6):
        wanted = records.ConjugateRoller(0.006 * scale)
        found = size.size(NOTHING, program=line.format(0.01 * scale), follower=wanted, least_radius=0.07 * scale)
        assert all(one.passed for one in found.checks)
        assert all(0.0 < one.tolerance <= scale * 1e-11 for one in found.checks if "curvature" in one.name)
