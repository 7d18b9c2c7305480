"""The four-bar at its hard places: change points from both sides, limits, toggles, signs, and refusals."""

import shlex
import subprocess
import sys
from fractions import Fraction
from math import cos, degrees, hypot, pi, radians, sin
from pathlib import Path

import pytest
from harness import answer, run
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp, mpf

from dynamics_cli import cli
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.linkage.fourbar.closure import Branch
from dynamics_cli.linkage.fourbar.four_bar import four_bar
from dynamics_cli.linkage.fourbar.grashof import classify
from dynamics_cli.linkage.fourbar.lengths import margin

CROSSED = Branch("crossed")
ROUNDING = 1e-13
# A crank-rocker, a double crank, a double rocker, a rocker-crank and a triple rocker.
LENGTHS = ((0.04, 0.12, 0.08, 0.1), (0.1, 0.09, 0.12, 0.04), (0.09, 0.04, 0.11, 0.1), (0.11, 0.1, 0.04, 0.12),
           (0.03, 0.02, 0.025, 0.04))  # fmt: skip


def pose(lengths: tuple[float, ...], angle: float, branch: str = "open", **more: float) -> object:
    a, b, c, d = lengths
    return four_bar(crank=a, coupler=b, rocker=c, ground=d, crank_angle=angle, branch=Branch(branch), **more)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("lengths", "angle", "first", "second"),
    [
        # (ω₃, ω₄)/ω₂ of both motions, from (ab ± √(abcd))/(b(c − b)) in 30 digits
        ((2.0, 5.0, 4.0, 3.0), 0.0, (0.190890230020664, 0.738612787525831), (-4.19089023002066, -4.73861278752583)),
        (
            (0.1, 0.5, 0.3, 0.7),
            pi,
            (-0.13117376914898996, 0.551956281914983),
            (0.38117376914898996, -0.301956281914983),
        ),
        ((1.0, 3.0, 1.0, 3.0), pi, (0.0, 1.0), (0.5, -0.5)),
    ],
)
def test_both_motions_run_through_a_change_point(
    lengths: tuple[float, ...], angle: float, first: tuple[float, float], second: tuple[float, float]
) -> None:
    for branch, (coupler, rocker) in (("open", first), ("crossed", second)):
        for step in (-1e-3, -1e-6, 0.0, 1e-6, 1e-3):
            made = pose(lengths, angle + step, branch)
            near = 1e-12 + 40.0 * abs(step)
            assert made.coupler_ratio == pytest.approx(coupler, abs=near)  # type: ignore[attr-defined]
            assert made.rocker_ratio == pytest.approx(rocker, abs=near)  # type: ignore[attr-defined]


def test_a_parallelogram_stays_one_all_the_way_round() -> None:
    for k in range(25):
        made = pose((1.0, 3.0, 1.0, 3.0), k * pi / 12.0, speed=2.0)
        assert made.rocker_speed == pytest.approx(2.0, abs=1e-12)  # type: ignore[attr-defined]


def test_a_kite_at_its_free_turn_is_refused_and_beside_it_answers() -> None:
    with pytest.raises(InadmissibleError, match="freely"):
        pose((2.0, 3.0, 3.0, 2.0), 0.0)
    made = pose((2.0, 3.0, 3.0, 2.0), 1e-9)
    assert (made.coupler_ratio, made.rocker_ratio) == pytest.approx((1.0 / 6.0, 5.0 / 6.0))  # type: ignore[attr-defined]
    other = pose((2.0, 3.0, 3.0, 2.0), 1e-9, "crossed")
    assert (other.coupler_ratio, other.rocker_ratio) == pytest.approx((5.0 / 6.0, 1.0 / 6.0))  # type: ignore[attr-defined]


def test_equality_is_of_the_decimals_and_not_of_the_doubles() -> None:
    assert 0.1 + 0.7 != 0.5 + 0.3
    assert margin((1, -1, -1, 1), (0.1, 0.5, 0.3, 0.7)) == 0.0
    assert classify(crank=0.1, coupler=0.5, rocker=0.3, ground=0.7).kind.startswith("change point")
    above, below = 0.30000000000001, 0.29999999999999
    assert classify(crank=0.1, coupler=0.5, rocker=above, ground=0.7).kind == "crank-rocker"
    assert classify(crank=0.1, coupler=0.5, rocker=below, ground=0.7).kind.startswith("triple rocker")


@pytest.mark.parametrize(
    ("lengths", "kind"),
    list(zip(LENGTHS, ("crank-rocker", "double crank", "double rocker", "rocker-crank", "triple rocker, longest link "
                       "the ground"), strict=True)),
)  # fmt: skip
def test_classes(lengths: tuple[float, ...], kind: str) -> None:
    a, b, c, d = lengths
    assert classify(crank=a, coupler=b, rocker=c, ground=d).kind == kind


def test_limits_and_both_sides_of_them() -> None:
    made = classify(crank=3.0, coupler=2.0, rocker=2.5, ground=4.0)
    assert made.outer_limit is not None
    assert degrees(made.outer_limit) == pytest.approx(78.584842257269508863, rel=1e-15)
    assert pose((3.0, 2.0, 2.5, 4.0), made.outer_limit - 1e-12).transmission_angle > 3.1415  # type: ignore[attr-defined]
    with pytest.raises(InadmissibleError, match="gap"):
        pose((3.0, 2.0, 2.5, 4.0), made.outer_limit + 1e-12)
    done = classify(crank=0.04, coupler=0.12, rocker=0.08, ground=0.1)
    assert done.swing is not None
    assert done.extended_at is not None
    assert done.folded_at is not None
    assert degrees(done.swing) == pytest.approx(73.7818196488829521)
    assert (degrees(done.extended_at), degrees(done.folded_at)) == pytest.approx(
        (24.1468479965023866, 231.31781254651056)
    )
    assert done.time_ratio == pytest.approx(1.3555733302903552)
    ends = degrees(done.least_transmission_angle), degrees(done.greatest_transmission_angle)
    assert ends == pytest.approx((26.3843297494079658, 86.4166783015280271), rel=1e-15)
    # the rocker stands still at its ends
    assert pose((0.04, 0.12, 0.08, 0.1), done.extended_at).rocker_ratio == pytest.approx(0.0, abs=1e-12)  # type: ignore[attr-defined]


@settings(max_examples=40, deadline=None)
@given(st.sampled_from(LENGTHS), st.floats(-pi, pi), st.sampled_from(("open", "crossed")))
def test_closure_velocity_and_power(lengths: tuple[float, ...], angle: float, branch: str) -> None:
    a, b, c, d = lengths
    try:
        made = pose(lengths, angle, branch, speed=2.0, load_torque=7.0)
        ahead, behind = (pose(lengths, angle + step, branch) for step in (1e-6, -1e-6))
    except InadmissibleError:
        return
    t3, t4 = made.coupler_angle, made.rocker_angle  # type: ignore[attr-defined]
    gap = hypot(a * cos(angle) + b * cos(t3) - c * cos(t4) - d, a * sin(angle) + b * sin(t3) - c * sin(t4))
    assert gap <= ROUNDING
    # power in = power out
    assert made.crank_torque * 2.0 == pytest.approx(7.0 * made.rocker_speed)  # type: ignore[attr-defined]
    if abs(sin(made.transmission_angle)) > 0.05:  # type: ignore[attr-defined]
        turn = (ahead.rocker_angle - behind.rocker_angle + pi) % (2.0 * pi) - pi  # type: ignore[attr-defined]
        assert made.rocker_ratio == pytest.approx(turn / 2e-6, abs=1e-6)  # type: ignore[attr-defined]
        change = (ahead.rocker_ratio - behind.rocker_ratio) / 2e-6  # type: ignore[attr-defined]
        assert made.rocker_acceleration == pytest.approx(4.0 * change, rel=1e-5, abs=1e-5)  # type: ignore[attr-defined]


# A pose in degrees (lengths, crank angle, branch), and its angles printed to 18 digits.
PRINTED = [
    ((40.0, 120.0, 80.0, 100.0), 40.0, "open", "coupler_angle", 20.297882788196474700),
    ((40.0, 120.0, 80.0, 100.0), 40.0, "open", "rocker_angle", 57.324880070360794216),
    ((40.0, 120.0, 80.0, 100.0), 40.0, "open", "transmission_angle", 37.026997282164319516),
    ((40.0, 120.0, 80.0, 100.0), 40.0, "crossed", "coupler_angle", -60.977966795864430686),
    ((40.0, 120.0, 80.0, 100.0), 40.0, "crossed", "rocker_angle", -98.004964078028750203),
    ((1.0, 3.0, 1.000000001, 3.0), 180.0, "open", "transmission_angle", 179.9970412586694705),
]


@pytest.mark.parametrize(("lengths", "at", "branch", "name", "printed"), PRINTED)
def test_angles_that_are_printed(lengths: tuple[float, ...], at: float, branch: str, name: str, printed: float) -> None:
    assert degrees(getattr(pose(lengths, radians(at), branch), name)) == pytest.approx(printed, rel=1e-14)


def test_coupler_motion_of_the_reference_pose() -> None:
    made = pose((40.0, 120.0, 80.0, 100.0), radians(40.0), "crossed", speed=10.0, angular_acceleration=5.0)
    found = (made.coupler_speed, made.rocker_speed, made.coupler_acceleration, made.rocker_acceleration)  # type: ignore[attr-defined]
    wanted = (-3.7035089198158967136, -8.1510687828256862362, 94.6566716930528256, 65.6532121947963111)
    assert found == pytest.approx(wanted, rel=1e-13)
    flat = pose((3.0, 5.0, 2.0, 6.0), pi / 2.0, "crossed")
    assert degrees(flat.rocker_angle) == pytest.approx(180.0) or degrees(flat.rocker_angle) == pytest.approx(-180.0)  # type: ignore[attr-defined]
    assert flat.rocker_ratio == pytest.approx(-2.0)  # type: ignore[attr-defined]


ARM = ("linkage", "four-bar", "--coupler", "2 in", "--rocker", "2.5 in", "--ground", "4 in")


def test_an_unreachable_pose_names_the_gap_and_what_closes_it() -> None:
    refused = run(*ARM, "--crank", "3 in", "--crank-angle", "90 deg")
    assert refused.status == 3
    assert "leave a gap of 0.5 in" in refused.err
    assert "±78.584842 deg; or lengthen coupler or rocker by 0.5 in" in refused.err


@pytest.mark.parametrize(
    ("crank", "words"),
    [("0 in", "a link needs more than zero"), ("30 in", "cannot be closed by 21.5 in"), ("-1 in", "crank")],
)
def test_impossible_lengths_are_refused(crank: str, words: str) -> None:
    refused = run(*ARM, "--crank", crank, "--crank-angle", "10 deg")
    assert refused.status in (2, 3)
    assert words in refused.err


def test_a_toggle_has_no_speeds() -> None:
    # f = 7 at 60 degrees, exactly
    with pytest.raises(InadmissibleError, match="toggle"):
        pose((3.0, 3.0, 4.0, 8.0), 1.0471975511965979, speed=1.0)
    made = pose((3.0, 3.0, 4.0, 8.0), 1.0471975511965979)
    assert made.rocker_ratio is None  # type: ignore[attr-defined]
    assert degrees(made.transmission_angle) == 180.0  # type: ignore[attr-defined]


@pytest.mark.parametrize("branch", ["open", "crossed"])
def test_the_table_begins_with_the_swing_of_a_wiper(branch: str) -> None:
    links = ("--crank", "40 mm", "--coupler", "120 mm", "--rocker", "80 mm", "--ground", "100 mm")
    shown = answer("linkage", "four-bar", *links, "--branch", branch, "--steps", "720")["results"]
    angles = [row["rocker_angle"]["value"] for row in shown["table"]]
    ends = [shown[f"rocker_{end}"]["value"] for end in ("least", "greatest")]
    assert ends == pytest.approx([min(angles), max(angles)], abs=0.01)
    swing = answer("linkage", "class", *links)["results"]["swing"]["value"]
    assert shown["swing"]["value"] == swing == pytest.approx(ends[1] - ends[0])


def test_the_table_covers_what_can_be_reached_and_is_silent_at_toggles() -> None:
    table = answer("linkage", "four-bar", "--crank", "30 mm", "--coupler", "20 mm", "--rocker", "25 mm", "--ground",
                   "40 mm", "--steps", "4")["results"]["table"]  # fmt: skip
    angles = [row["crank_angle"]["value"] for row in table]
    assert angles[0] == pytest.approx(-78.584842257269508863)
    assert angles[-1] == pytest.approx(78.584842257269508863)
    assert [row.get("rocker_ratio") is not None for row in table] == [False, True, True, True, False]


LEAN = """
import sys
sys.path.insert(0, {root!r})
from dynamics_cli.cli import run_argv
from dynamics_cli.core.terminal import Terminal
import io
for argv in {calls!r}:
    assert run_argv(argv, Terminal(io.BytesIO(), io.BytesIO(), io.BytesIO(), {{}})) == 0, argv
sys.exit(sorted(set(sys.modules) & {{"numpy", "typer", "pint"}}) or None)
"""


def test_plain_calls_load_no_numpy() -> None:
    calls = [
        shlex.split(task.examples[0])[1:]
        for task in cli.family("linkage").tasks.values()
        if task.name in ("four-bar", "class", "slider-crank", "quick-return", "body", "chain", "synthesize")
    ]
    assert len(calls) == 7
    plain = [call for call in calls if not any(word.startswith(("--chain-link", "--pair")) for word in call)]
    code = LEAN.format(root=str(Path(__file__).parents[2]), calls=plain)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_ends_of_a_swing_beside_a_change_point() -> None:
    """In doubles the flat triangle of crank and coupler could not close: its angle came out as 0, known exactly."""
    lengths = (0.0508, 0.127, 0.1016, 0.07620000000000002)
    made = classify(crank=lengths[0], coupler=lengths[1], rocker=lengths[2], ground=lengths[3])
    a, b, c, d = (Fraction(repr(length)) for length in lengths)
    with mp.workdps(60):
        near, far = (c - a - b + d) * (c + a + b - d), (a + b + d - c) * (a + b + d + c)
        exact = 2 * mp.atan2(mp.sqrt(mp.mpf(near.numerator) / near.denominator),
                             mp.sqrt(mp.mpf(far.numerator) / far.denominator))  # fmt: skip
    assert made.extended_at == pytest.approx(float(exact), rel=1e-12)
    assert 1e-8 < made.extended_at < 2e-8  # type: ignore[operator]


def test_extremes_of_a_crank_rocker_beside_forty_digits() -> None:
    lengths = (0.04, 0.12, 0.08, 0.1)
    a, b, c, d = (mpf(x) for x in lengths)
    made = classify(crank=0.04, coupler=0.12, rocker=0.08, ground=0.1)
    # the angle between coupler and rocker, by the cosine rule in the triangle over the diagonal
    wanted = [mp.acos((b**2 + c**2 - f**2) / (2 * b * c)) for f in (d - a, d + a)]
    assert (made.least_transmission_angle, made.greatest_transmission_angle) == pytest.approx(
        tuple(map(float, wanted)), rel=1e-15
    )
    # where the coupler stands still for a moment: its instant centre is at infinity, O₂A and O₄B are parallel
    at = 69.512684885277336533
    still = pose(lengths, radians(at))
    assert still.coupler_ratio == pytest.approx(0.0, abs=1e-15)  # type: ignore[attr-defined]
    assert still.rocker_ratio == pytest.approx(0.5, rel=1e-14)  # type: ignore[attr-defined]


@pytest.mark.parametrize(("branch", "rocker", "speed"), [("open", 126.8698976458440213, 2.4), ("crossed", 180.0, -2.0)])
def test_where_the_quotient_of_half_angles_is_indeterminate(branch: str, rocker: float, speed: float) -> None:
    made = pose((3.0, 5.0, 2.0, 6.0), 0.5 * pi, branch, speed=1.0)
    assert abs(degrees(made.rocker_angle)) == pytest.approx(rocker, rel=1e-15)  # type: ignore[attr-defined]
    assert made.rocker_speed == pytest.approx(speed, rel=1e-14)  # type: ignore[attr-defined]


def test_a_crank_of_a_micrometre_and_a_near_parallelogram() -> None:
    tiny = pose((1e-6, 1.0, 0.8, 0.9), radians(70.0), speed=1.0)
    assert tiny.rocker_acceleration == pytest.approx(1.369150701025882917642e-6, rel=1e-14)  # type: ignore[attr-defined]
    # by the first order of the crank: ω₄ = ω₂·a·sin(θ₂ − θ₃)/(c·sin(θ₄ − θ₃))
    angles = tiny.rocker_angle - tiny.coupler_angle, radians(70.0) - tiny.coupler_angle  # type: ignore[attr-defined]
    assert tiny.rocker_speed == pytest.approx(1e-6 * sin(angles[1]) / (0.8 * sin(angles[0])), rel=1e-14)  # type: ignore[attr-defined]
    assert degrees(tiny.rocker_angle) == pytest.approx(108.2098784177582294926, rel=1e-15)  # type: ignore[attr-defined]
    for branch, rocker in (("open", 0.23547903488196945135), ("crossed", 0.26452096511793679865)):
        near = pose((1.0, 3.0, 1.000000001, 3.0), pi + 1e-6, branch)
        # θ₂ as a double is off by 1e-16, which the gap of 1e-9 multiplies
        assert near.rocker_ratio == pytest.approx(rocker, rel=1e-6)  # type: ignore[attr-defined]
