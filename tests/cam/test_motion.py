"""Programs and motions: both ways of writing them, joints, sides, zones, arrays, and what is refused."""

import random
import subprocess
import sys
from math import pi, radians

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.rise import rise
from dynamics_cli.cam.program.parts import radians as exact_radians
from dynamics_cli.cam.program.reading import Move, Point, Program, Segment, exact_degrees, motion_of
from dynamics_cli.cam.program.revolution import motion
from dynamics_cli.cam.program.singularity import Form, delta
from dynamics_cli.cam.program.summary import extreme, jumps, root_mean_square
from dynamics_cli.errors import InadmissibleError, UsageError

LINE = "rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg 3-4-5; dwell"
LINES = [
    LINE,
    "rise 12 mm in 33.3 deg modified sine; dwell 0.001 deg; return in 77 deg mt; dwell",
    "start 30 deg; rise 20 mm in 100/3 deg scca 0.25 0.5 0.25; rise 5 mm in 1 rad linear; return in 2 rad poly; dwell",
    "return 8 mm in 1 rad double harmonic; rise 8 mm in 2 rad trapezoid; dwell",
    "rise 20 deg in 180 deg 4567; return in 180 deg mcv 0.4",
    "rise 3 mm in 1e-6 rad; dwell 100 deg; return in 0.0001 deg harmonic; dwell",
]


def of(line: str):
    return motion_of(Program(), line)


def test_commas_between_clauses_and_no_word_before_the_angle() -> None:
    other = of("rise 20 mm 90 deg cycloidal, dwell 60 deg, return in 90 deg 3-4-5, rest")
    assert other.in_zone(0, 0.3) == of(LINE).in_zone(0, 0.3)
    assert other.joints == of(LINE).joints


@pytest.mark.parametrize(
    "line",
    [
        "rise 20mm in 90 cycloidal; dwell 60; fall over 90; hold",
        "0-90: rise 20 mm cycloidal; 90–150° dwell; 150..240 return; 240-360 dwell",
        "Rise 20 mm 0-90 deg cycloidal; dwell 90-150; return 150-240 345; dwell 240-360",
        "rise 20 mm from 0 to 90 deg with cycloidal motion; dwell until 150 deg; return to 0 in 90; dwell to 360",
    ],
)
def test_angles_as_designers_write_them(line: str) -> None:
    assert of(line).joints == of(LINE).joints
    assert of(line).in_zone(0, 0.3) == of(LINE).in_zone(0, 0.3)
    assert of(line).in_zone(2, 0.3) == of(LINE).in_zone(2, 0.3)


def test_a_range_begins_where_the_one_before_ends() -> None:
    assert of("30-90 rise 20 mm; 90-150 return; dwell").joints[0] == pytest.approx(radians(30.0), rel=1e-15)
    with pytest.raises(UsageError, match="it begins at 160 deg, where the one before ends at 150 deg"):
        of("0-90 rise 20 mm; 90-150 dwell; 160-240 return; dwell")
    with pytest.raises(UsageError, match="not known where it begins"):
        of("rise 20 mm; return until 240 deg; dwell")


def test_in_before_an_angle_is_not_inches() -> None:
    with pytest.raises(UsageError, match="the lift has no unit"):
        of("rise 20 in 90 deg; return in 90 deg; dwell")
    assert of("rise 1 in in 90 deg; return in 90 deg; dwell").in_zone(0, 1.0)[0] == pytest.approx(0.0254, rel=1e-15)


@pytest.mark.parametrize("line", LINES)
class TestAnyMotion:
    def test_it_closes_and_repeats_to_the_bit(self, line: str) -> None:
        found = of(line)
        last = len(found.zones) - 1
        assert found.in_zone(last, 1.0)[0] == found.in_zone(0, 0.0)[0]
        assert found.joints[-1] == found.at(found.joints[0]) or found.joints[-1] - found.joints[0] == pytest.approx(
            2 * pi
        )
        assert found.at(found.joints[0]) == found.at(found.joints[-1])
        assert found.at(found.joints[0], side=-1) == found.at(found.joints[-1], side=-1)

    def test_joints_are_met_to_the_bit(self, line: str) -> None:
        found = of(line)
        for index, span in enumerate(found.segments):
            assert found.at(found.joints[index])[0] == span.low
            assert found.at(found.joints[index + 1], side=-1)[0] == span.high

    def test_zones_tile_the_turn(self, line: str) -> None:
        found = of(line)
        assert found.zones[0].start == found.joints[0]
        assert found.zones[-1].end == found.joints[-1]
        for before, after in zip(found.zones, found.zones[1:], strict=False):
            assert before.end == after.start
            assert before.start < before.end

    def test_arrays_in_any_order_are_the_floats(self, line: str) -> None:
        found = of(line)
        generator = np.random.default_rng(3)
        theta = np.concatenate(
            [np.linspace(-7.0, 14.0, 801), np.array(found.joints), [zone.start for zone in found.zones]]
        )
        sizes = [max(abs(extreme(found, order).least), abs(extreme(found, order).greatest)) for order in range(4)]
        for angles in (
            np.sort(theta),
            generator.permutation(theta),
            np.sort(theta[(theta >= found.start) & (theta <= found.joints[-1])]),
        ):
            for side in (-1, 1):
                many = found.at(angles, side=side)
                for place, *values in zip(angles.tolist(), *many, strict=True):
                    for own, value, size in zip(found.at(place, side=side), values, sizes, strict=True):
                        assert abs(own - value) <= 2e-15 * size

    def test_zones_give_the_same_as_angles(self, line: str) -> None:
        found = of(line)
        for index, zone in enumerate(found.zones):
            t = np.linspace(0.0, 1.0, 33)
            inside = found.in_zone(index, t)
            for place, *values in zip(t.tolist(), *inside, strict=True):
                assert [float(value) for value in values] == pytest.approx(
                    found.in_zone(index, place), rel=1e-13, abs=1e-300
                )
            if zone.end - zone.start > 0.01:
                angles = zone.start + (zone.end - zone.start) * t[1:-1]
                for own, other in zip(inside, found.at(angles), strict=True):
                    assert abs(own[1:-1] - other).max() <= 2e-12 * (abs(own).max() + 1e-3)

    def test_extremes_miss_nothing_on_a_dense_grid(self, line: str) -> None:
        found = of(line)
        for order in range(4):
            ends = extreme(found, order)
            for index, zone in enumerate(found.zones):
                values = found.in_zone(index, np.linspace(0.0, 1.0, 2001))[order]
                size = max(abs(ends.least), abs(ends.greatest))
                assert values.max() <= ends.greatest + 1e-14 * size
                assert values.min() >= ends.least - 1e-14 * size
                assert zone.start < zone.end

    def test_singularity_functions_agree(self, line: str) -> None:
        form = Form(of(line))
        assert form.disagreement() <= 1e-10
        assert "δ" in form.written()


def test_a_file_and_a_line_are_one_motion() -> None:
    records = Program(
        (
            Segment(Move("rise"), radians(90.0), 0.02, law=LawName("cycloidal")),
            Segment(Move("dwell"), radians(60.0)),
            Segment(Move("return"), radians(90.0), law=LawName("345")),
            Segment(Move("dwell")),
        )
    )
    one, other = motion_of(records), of(LINE)
    assert one.joints == other.joints
    assert [(s.start, s.end, s.low, s.high) for s in one.segments] == [
        (s.start, s.end, s.low, s.high) for s in other.segments
    ]


@settings(max_examples=300, deadline=None)
@given(st.integers(1, 360_000_000))
def test_degrees_are_read_back_from_radians(millionths: int) -> None:
    exact = (millionths, 1_000_000)
    top, bottom = exact_degrees(exact_radians(exact)[0])
    assert top * 1_000_000 == millionths * bottom


def test_random_tables_of_degrees_close_exactly() -> None:
    generator = random.Random(5)
    for _ in range(200):
        spans = [generator.randint(1, 9000) / 100 for _ in range(generator.randint(2, 12))]
        spans = [span for span in spans if span]
        rest = round(720.0 - sum(spans), 2) % 360.0
        scale_ok = sum(spans) < 360.0
        if not scale_ok or not rest:
            continue
        rest = round(360.0 - sum(spans), 2)
        line = "; ".join(f"dwell {span} deg" for span in spans) + f"; dwell {rest} deg"
        found = of(line)
        assert found.segments[-1].end[0] == 360 * found.segments[-1].end[1]
        assert found.joints[-1] == 2.0 * pi


def test_a_polynomial_takes_the_state_of_its_neighbours() -> None:
    found = of("rise 5 mm in 40 deg poly; rise 10 mm in 50 deg linear; return in 90 deg polynomial 7; dwell")
    for _, words, steps in jumps(found):
        assert steps[:3] == [0.0, 0.0, 0.0], words
    assert found.at(radians(40.0), side=-1)[1] == pytest.approx(0.01 / radians(50.0), rel=1e-14)


def test_given_end_states_are_met() -> None:
    line = (
        "rise 20 mm in 90 deg poly v1=5 mm/rad a1=-0.01mm/deg^2; "
        "return in 90 deg poly v0=5mm/rad a0=-0.01 mm/deg^2; dwell"
    )
    found = of(line)
    for side in (-1, 1):
        state = found.at(pi / 2, side=side)
        assert state[0] == 0.02
        assert state[1] == pytest.approx(0.005, rel=1e-14)
        assert state[2] == pytest.approx(-1e-5 * (180 / pi) ** 2, rel=1e-14)
    assert found.stroke[1] > 0.02


def test_a_spline_segment_goes_through_its_points() -> None:
    points = (Point(0.3, 0.004), Point(1.0, 0.015))
    found = motion_of(
        Program(
            (
                Segment(Move("rise"), 1.5, 0.02, law=LawName("spline"), points=points),
                Segment(Move("return"), 1.5),
                Segment(Move("dwell")),
            )
        )
    )
    assert found.at(0.3)[0] == pytest.approx(0.004, rel=1e-14)
    assert found.at(1.0)[0] == pytest.approx(0.015, rel=1e-14)
    assert len([zone for zone in found.zones if zone.segment == 0]) == 3


def test_continuity_is_reported_at_every_joint() -> None:
    found = motion(Program(), program="rise 1 in in 120 deg parabolic; dwell 60 deg; return in 120 deg linear; dwell")
    assert found.continuity == "C0"
    by_angle = {round(joint.angle * 180 / pi): joint for joint in found.joints}
    assert by_angle[60].acceleration == pytest.approx(-8 * 0.0254 / (2 * pi / 3) ** 2)
    assert by_angle[60].velocity == 0.0
    assert by_angle[180].velocity == pytest.approx(-0.0254 / (2 * pi / 3))
    assert by_angle[0].acceleration == pytest.approx(4 * 0.0254 / (2 * pi / 3) ** 2)
    assert any(advice.code == "velocity-jumps" and advice.severity == "serious" for advice in found.advice)


def test_the_rms_acceleration_is_the_closed_form() -> None:
    found = of("rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg harmonic; dwell")
    peak_c, peak_h = (0.02 * f / (pi / 2) ** 2 for f in (2 * pi, pi * pi / 2))
    assert root_mean_square(found, 2)[0] == pytest.approx(((peak_c**2 / 2 + peak_h**2 / 2) / 4) ** 0.5, rel=1e-14)


def test_the_book_s_indices_of_singularity_functions() -> None:
    assert [delta(n, 2.0) for n in (1, 2, 3, 4)] == [1.0, 2.0, 2.0, 8.0 / 6.0]
    assert delta(1, 0.0) == 0.5
    assert delta(2, 0.0) == 0.0
    form = Form(of("rise 20 mm in 90 deg linear; dwell 90 deg; return in 90 deg parabolic; dwell"))
    assert [(index, round(place * 180 / pi)) for _, index, place in form.terms] == [
        (2, 0), (2, 90), (3, 180), (3, 225), (3, 270),
    ]  # fmt: skip
    slope = 0.02 / (pi / 2)
    bend = 4 * 0.02 / (pi / 2) ** 2
    assert [factor for factor, _, _ in form.terms] == pytest.approx([slope, -slope, -bend, 2 * bend, -bend])


def test_angles_of_lift_make_a_swing() -> None:
    found = motion(
        Program(), program="rise 20 deg in 120 deg ms; dwell 60 deg; return in 180 deg", count=7, shaft_speed=2.0
    )
    assert found.lift is None
    assert found.swing.greatest == pytest.approx(radians(20.0), rel=1e-15)
    assert found.swing_in_time.speed == pytest.approx(2 * found.swing.greatest_velocity)
    assert len(found.swing_table) == 7


def test_a_table_lands_on_the_joints() -> None:
    found = motion(Program(), program=LINE, count=361)
    columns = found.table.arrays
    assert columns["angle"][90] == pi / 2
    assert columns["lift"][90] == 0.02
    assert columns["velocity"][90] == 0.0
    assert columns["lift"][-1] == 0.0


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("", "program"),
        (";;", "program"),
        ("rise 20 mm in 90 deg; return in 280 deg", "turn"),
        ("rise 20 mm in 90 deg; return in 269.999999 deg", "turn"),
        ("rise 20 mm in 90 deg; return in 270 deg; dwell", "turn"),
        ("rise 20 mm in 90 deg; dwell", "not-closed"),
        ("rise 20 mm; dwell", "span"),
        ("rise in 90 deg; dwell", "lift"),
        ("rise 0 mm in 90 deg; dwell", "lift"),
        ("rise -3 mm in 90 deg; dwell", "lift"),
        ("return in 90 deg; dwell", "lift"),
        ("rise 20 mm in 0 deg; return in 10 deg; dwell", "span"),
        ("rise 20 mm in -5 deg; return in 10 deg; dwell", "span"),
        ("rise 20 mm in 1e-8 deg; return in 10 deg; dwell", "span"),
        ("rise 20 mm in 90 deg; return 5 deg in 90 deg; dwell", "swing"),
        ("rise 20 mm in 90 deg 345 v0=1; return in 90 deg; dwell", "law"),
        ("rise 20 mm in 90 deg poly 4; return in 90 deg; dwell", "degree"),
        ("rise to 20 mm in 90 deg; rise to 10 mm in 90 deg; dwell", "lift"),
    ],
)
def test_programs_that_cannot_be(line: str, code: str) -> None:
    with pytest.raises(InadmissibleError) as refused:
        of(line)
    assert refused.value.code == code


@pytest.mark.parametrize(
    "line",
    [
        "climb 20 mm", "rise 20 kg in 90 deg", "rise 20 in 90 deg", "rise 20 mm in 90 deg fancy",
        "rise 20 mm in ninety deg",
        "dwell 20 mm", "rise nan mm in 90 deg", "rise 1,5 mm in 90 deg", "rise 20 mm in 90 deg 345 7",
        "dwell 90 deg 345",
        "rise ١ mm in 90 deg", "rise 1_0 mm in 90 deg", "rise 20 mm in 1/0 deg", "rise 20 mm in 90 deg poly v0=",
        "rise 20",
        "rise 20 mm in 90 deg poly q=1", "rise 20 mm in 90 deg poly v0=1 kg", "start", "rise inf mm in 90 deg",
    ],
)  # fmt: skip
def test_words_that_are_not_understood(line: str) -> None:
    with pytest.raises(UsageError) as wrong:
        of(line + "; return in 90 deg; dwell")
    assert wrong.value.code == "program-words"
    assert line.split(";")[0].split()[0] in wrong.value.message


def test_a_law_that_is_none_suggests_the_near_ones() -> None:
    with pytest.raises(UsageError, match="did you mean cycloidal or half-cycloid-start"):
        of("rise 20 mm in 90 deg cyclodal; return in 90 deg; dwell")
    with pytest.raises(UsageError, match="'fancy'; `dynamics cam laws` lists all"):
        of("rise 20 mm in 90 deg fancy; return in 90 deg; dwell")


def test_two_programs_are_refused() -> None:
    with pytest.raises(InadmissibleError):
        motion_of(Program((Segment(Move("dwell")),)), LINE)


def test_a_scalar_rise_starts_without_numpy() -> None:
    code = (
        "import sys\nfrom dynamics_cli.cli import main\n"
        "sys.argv = ['dynamics', 'cam', 'rise', '--law', 'cycloidal', '--lift', '20 mm', '--span', '90 deg']\n"
        "sys.argv += ['--at', '30 deg', '--all']\n"
        "try:\n    main()\nexcept SystemExit:\n    pass\n"
        "print(sorted({'numpy', 'scipy', 'pint', 'fractions', 'dataclasses'} & set(sys.modules)), file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stderr.strip() == "[]", done.stderr
    assert "19.0986" in done.stdout


@pytest.mark.parametrize("law", ["cycloidal", "harmonic", "3-4-5", "modified-trapezoid", "gutman", "mcv50"])
def test_a_zero_is_printed_as_zero_and_a_small_number_is_kept(law: str) -> None:
    line = f"rise 20 mm in 100 deg {law}; dwell 55 deg; return in 130 deg {law}; dwell"
    columns = motion(Program(), program=line, count=73).table.arrays
    for name in ("lift", "velocity", "acceleration", "jerk"):
        peak = max(abs(columns[name]))
        assert not any(0.0 < abs(value) < 1e-14 * peak for value in columns[name]), name
    # the middle of the rise, where the acceleration passes zero
    assert columns["acceleration"][10] == 0.0


def test_a_small_lift_at_the_start_of_a_rise_is_kept() -> None:
    line = "rise 20 mm in 180 deg 5-6-7-8-9; return in 180 deg 5-6-7-8-9"
    columns = motion(Program(), program=line, count=100_001).table.arrays
    assert 0.0 < columns["lift"][1] < 1e-22
    assert 0.0 < columns["acceleration"][1] < 1e-12


def test_a_rise_has_no_acceleration_where_it_passes_zero() -> None:
    found = rise(law=LawName("cycloidal"), lift=0.02, span=pi / 2, count=19)
    assert found.points[9].acceleration == 0.0
    assert found.points[9].velocity > 0.0


def test_a_table_at_chosen_cam_angles() -> None:
    angles = [radians(angle) for angle in (90.0, 30.0, 360.0, 45.5)]
    table = motion(Program(), program=LINE, at=tuple(angles)).table
    assert list(table.arrays["angle"]) == sorted(angles)
    turn = of(LINE)
    for angle, lift, velocity in zip(*(table.arrays[name] for name in ("angle", "lift", "velocity")), strict=True):
        assert (lift, velocity) == pytest.approx(turn.at(float(angle), 1), abs=1e-18)
    with pytest.raises(InadmissibleError, match="outside the turn"):
        motion(Program(), program=LINE, at=(7.0,))
