"""Profiles: closed to the bit, within the deviation that is proved, cut by the rack and by nothing else."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.gear.flank_arcs import flank_arcs
from dynamics_cli.gear.pitch import NormalModule
from dynamics_cli.gear.single.flanks import ToothForm, flank, trochoid_points
from dynamics_cli.gear.single.gear import Sign
from dynamics_cli.gear.single.outline import chain_points
from dynamics_cli.gear.single.profile import Form, GearProfile, gear_of, profile, tooth_form
from dynamics_cli.gear.single.rack import Profile
from dynamics_cli.outlines import Arc, Line, Points

MM = 1e-3
PITCH = NormalModule(2 * MM)
LINES = Form("lines")


def form_of(
    teeth: int, x: float = 0.0, beta: float = 0.0, *, internal: bool = False, rho: float | None = None
) -> ToothForm:
    gear = gear_of(
        teeth=teeth,
        pitch=PITCH,
        profile="a",
        pressure_angle=math.radians(20.0),
        addendum_factor=None,
        dedendum_factor=None,
        root_radius_factor=rho,
        helix_angle=beta,
        profile_shift=x,
        internal=internal,
        shift_sign="iso",
    )
    return tooth_form(gear, None, rho)


def pieces(answer: GearProfile):
    assert answer.drawing is not None
    return answer.drawing.outlines[0].pieces


GEARS = [(9, 0.0, 0.0), (9, 0.4, 0.0), (17, 0.0, 0.0), (20, 0.0, 0.0), (30, 0.5, 0.5), (100, -0.5, 0.2), (6, 0.5, 0.9)]


@pytest.mark.parametrize(("teeth", "x", "beta"), GEARS)
def test_a_whole_gear_is_closed_and_in_order(teeth: int, x: float, beta: float) -> None:
    answer = profile(teeth=teeth, pitch=PITCH, profile_shift=x, helix_angle=beta, form=LINES)
    found = pieces(answer)
    assert len(found) == 6 * teeth
    kinds = [type(piece).__name__ for piece in found[:6]]
    assert kinds == ["Points", "Points", "Arc", "Points", "Points", "Arc"]
    for piece, following in zip(found, found[1:] + found[:1], strict=True):
        assert piece.end == following.start  # to the bit
    for arc in (piece for piece in found if isinstance(piece, Arc)):
        tip = arc is found[2] or abs(math.hypot(*arc.start) - answer.tip_diameter / 2) < 1e-9
        wanted = answer.tip_diameter / 2 if tip else answer.root_diameter / 2
        assert arc.radius == pytest.approx(wanted, rel=1e-11)
        assert math.hypot(*arc.centre) < 1e-11
    joint = math.hypot(*found[1].start)
    assert joint == pytest.approx(answer.form_diameter / 2, rel=1e-14)


def chord_errors(x: np.ndarray, y: np.ndarray, fine_x: np.ndarray, fine_y: np.ndarray) -> float:
    """The largest distance of a chord's polyline from points of the exact curve between its ends."""
    worst = 0.0
    per = (len(fine_x) - 1) // (len(x) - 1)
    for i in range(len(x) - 1):
        px, py = fine_x[i * per : (i + 1) * per + 1], fine_y[i * per : (i + 1) * per + 1]
        dx, dy = x[i + 1] - x[i], y[i + 1] - y[i]
        worst = max(worst, float(np.max(np.abs((px - x[i]) * dy - (py - y[i]) * dx)) / math.hypot(dx, dy)))
    return worst


@pytest.mark.parametrize("tolerance", [1e-4, 1e-5, 1e-6, 1e-8])
@pytest.mark.parametrize(("teeth", "x", "beta"), GEARS)
def test_the_proved_deviation_holds_and_is_not_idle(teeth: int, x: float, beta: float, tolerance: float) -> None:
    form = form_of(teeth, x, beta)
    chain = flank(form, tolerance)
    assert chain.deviation <= tolerance
    radius, angle, joint = chain.radius, chain.angle, chain.joint
    rolls = np.sqrt((radius[joint:] / form.base - 1.0) * (radius[joint:] / form.base + 1.0))
    rolls[0] = form.junction.roll
    fine = np.concatenate([np.linspace(a, b, 20, endpoint=False) for a, b in pairwise(rolls)] + [rolls[-1:]])
    exact_radius, exact_angle = form.base * np.sqrt(1 + fine * fine), form.half_base - (fine - np.arctan(fine))
    involute = chord_errors(
        radius[joint:] * np.cos(angle[joint:]),
        radius[joint:] * np.sin(angle[joint:]),
        exact_radius * np.cos(exact_angle),
        exact_radius * np.sin(exact_angle),
    )
    assert involute <= chain.deviation * (1 + 1e-6) + 1e-16
    if len(rolls) > 6:
        assert involute >= 0.3 * tolerance


def arc_distance(piece: Arc, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Distances of points from the circle of an arc."""
    (cx, cy) = piece.centre
    return np.abs(np.hypot(x - cx, y - cy) - piece.radius)


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8])
@pytest.mark.parametrize(
    ("teeth", "x", "beta", "internal"), [*((*gear, False) for gear in GEARS), (72, 0.0, 0.0, True)]
)
def test_arcs_keep_the_deviation_they_state(
    teeth: int, x: float, beta: float, internal: bool, tolerance: float
) -> None:
    """Fine chords of the same flank, which are proved by other means, lie on the arcs; and arcs are far fewer."""
    form = form_of(teeth, x, beta, internal=internal)
    arcs, fine = flank_arcs(form, tolerance), flank(form, 1e-3 * tolerance)
    assert arcs is not None
    assert arcs.deviation <= tolerance
    ax, ay = arcs.radius * np.cos(arcs.angle), -arcs.radius * np.sin(arcs.angle)
    fx, fy = fine.radius * np.cos(fine.angle), -fine.radius * np.sin(fine.angle)
    owner = np.clip(np.searchsorted(arcs.radius, fine.radius, side="right") - 1, 0, len(ax) - 2)
    if internal:
        owner = np.clip(np.searchsorted(-arcs.radius, -fine.radius, side="right") - 1, 0, len(ax) - 2)
    worst = 0.0
    for index, bulge in enumerate(arcs.bulge.tolist()):
        near = owner == index
        piece = Arc((ax[index], ay[index]), (ax[index + 1], ay[index + 1]), bulge)
        worst = max([worst, *arc_distance(piece, fx[near], fy[near])])
    assert worst <= arcs.deviation * 1.002
    if tolerance < 1e-5:
        assert worst >= 0.5 * arcs.deviation
        assert len(arcs.radius) < 0.5 * len(flank(form, tolerance).radius)


def test_arcs_of_a_gear_join_with_one_direction_and_close() -> None:
    answer = profile(teeth=20, pitch=PITCH, profile_shift=0.3)
    found = pieces(answer)
    assert all(isinstance(piece, Arc) for piece in found)
    turns = []
    for piece, following in zip(found, found[1:] + found[:1], strict=True):
        assert piece.end == following.start
        ends = []
        for arc, sign in ((piece, 1.0), (following, -1.0)):
            chord = math.atan2(arc.end[1] - arc.start[1], arc.end[0] - arc.start[0])
            ends.append(chord + sign * 2.0 * math.atan(arc.bulge))
        turns.append(abs(math.remainder(ends[1] - ends[0], 2.0 * math.pi)))
    # a corner at each end of the tips, and nowhere else
    assert sum(turn > 1e-6 for turn in turns) == 40


def test_the_trochoid_lies_within_its_triangles() -> None:
    form = form_of(9, 0.0)
    cutter = form.cutter
    coarse = np.linspace(0.5 * np.pi, form.junction.direction, 13)
    fine = np.linspace(0.5 * np.pi, form.junction.direction, 12 * 30 + 1)
    sampled, exact = trochoid_points(cutter, coarse), trochoid_points(cutter, fine)
    off = chord_errors(
        sampled[0] * np.cos(sampled[1]),
        sampled[0] * np.sin(sampled[1]),
        exact[0] * np.cos(exact[1]),
        exact[0] * np.sin(exact[1]),
    )
    from dynamics_cli.gear.single.flanks import _triangles

    bound = float(np.max(_triangles(*sampled)))
    assert 0.3 * bound <= off <= bound


@pytest.mark.parametrize(("teeth", "x", "beta"), GEARS)
def test_the_rack_cuts_this_profile_and_no_more(teeth: int, x: float, beta: float) -> None:
    """Every point of the rack's tooth, rolled past the gear, stays in the space; and it touches it everywhere."""
    form = form_of(teeth, x, beta)
    cutter = form.cutter
    r, stretch = cutter.pitch_radius, cutter.stretch
    turn = np.linspace(0.0, 0.5 * np.pi - cutter.pressure_angle, 400)
    corner_x = cutter.corner_offset + stretch * cutter.tip_radius * np.cos(cutter.pressure_angle + turn)
    corner_y = -(cutter.corner_depth + cutter.tip_radius * np.sin(cutter.pressure_angle + turn))
    depth = np.linspace(-1.0 - x, cutter.form_depth, 400)
    slope = math.tan(cutter.transverse_angle)
    flank_x = corner_x[0] + (cutter.form_depth - depth) * slope
    px, py = np.concatenate([flank_x, corner_x]), np.concatenate([-depth, corner_y])
    travel = np.linspace(-4.0 - teeth * 0.02, 4.0 + teeth * 0.02, 3001)[:, None]
    gx, gy = px + travel, r + py
    radius = np.hypot(gx, gy)
    angle = np.arctan2(gx, gy) - travel / r
    chain = flank(form, 1e-9)
    space = np.pi / teeth - chain.angle
    lowest = form.root / form.module
    assert float(np.min(radius)) > lowest - 1e-12
    # near the root circle, which both touch, an angle at a radius says nothing
    inside = (radius < form.tip / form.module) & (radius > lowest + 0.02)
    gap = np.interp(radius[inside] * form.module, chain.radius, space) - angle[inside]
    lean = np.interp(radius[inside] * form.module, chain.radius, chain.radius * np.gradient(space, chain.radius))
    assert float(np.min(gap * radius[inside] / np.sqrt(1.0 + lean * lean))) > -1e-6
    # touched: at every height of the profile some point of the rack comes within the step of this sampling
    edges = np.linspace(lowest + 0.02, form.tip / form.module, 40)
    cells = np.digitize(radius[inside], edges)
    for cell in range(2, 39):
        assert float(np.min(gap[cells == cell] * radius[inside][cells == cell])) < 0.02


@pytest.mark.parametrize(("teeth", "x"), [(36, -0.3), (72, 0.0), (200, 0.3)])
def test_an_internal_gear_is_closed_and_its_fillets_are_tangent(teeth: int, x: float) -> None:
    answer = profile(teeth=teeth, pitch=PITCH, profile_shift=x, internal=True, form=LINES)
    found = pieces(answer)
    assert [type(piece).__name__ for piece in found[:6]] == ["Arc", "Points", "Arc", "Points", "Arc", "Arc"]
    for piece, following in zip(found, found[1:] + found[:1], strict=True):
        assert piece.end == following.start
    fillet, curve, tip, land = found[0], found[1], found[2], found[5]
    assert fillet.radius == pytest.approx(0.2 * 2 * MM, rel=1e-9)
    assert tip.radius == pytest.approx(answer.tip_diameter / 2, rel=1e-11)
    assert land.radius == pytest.approx(answer.root_diameter / 2, rel=1e-9)
    # tangent to the root circle: the centres and the touching point lie on one ray
    assert math.hypot(*fillet.centre) == pytest.approx(answer.root_diameter / 2 - fillet.radius, rel=1e-10)
    # tangent to the involute: its normal touches the base circle, and passes through the fillet's centre
    (x0, y0), (cx, cy) = curve.start, fillet.centre
    away = abs(x0 * (cy - y0) - y0 * (cx - x0)) / math.hypot(cx - x0, cy - y0)
    assert away == pytest.approx(answer.base_diameter / 2, rel=1e-8)


def test_an_internal_space_is_the_tooth_of_its_pinion_twin() -> None:
    """An internal gear's space has the flanks of an external gear of as many teeth with the shift reversed."""
    ring, gear = form_of(60, -0.2, internal=True), form_of(60, 0.2)
    assert ring.half_base == pytest.approx(gear.half_base, rel=1e-14)
    assert ring.base == pytest.approx(gear.base, rel=1e-15)


def test_a_rack_is_tangent_and_repeats() -> None:
    found = pieces(profile(teeth=3, pitch=PITCH, rack=True))
    arcs = [piece for piece in found if isinstance(piece, Arc)]
    assert len(arcs) == 6
    for arc in arcs:
        assert arc.radius == pytest.approx(0.38 * 2 * MM, rel=1e-11)
    lines = [piece for piece in found if isinstance(piece, Line)]
    flanks = [line for line in lines if line.start[1] != line.end[1]]
    for line in flanks:
        dx, dy = line.end[0] - line.start[0], line.end[1] - line.start[1]
        assert abs(math.degrees(math.atan2(abs(dx), abs(dy)))) == pytest.approx(20.0, rel=1e-12)
    assert found[0].start[0] + 3 * math.pi * 2 * MM == pytest.approx(
        found[-1].end[0] + 2 * MM * (math.pi - 2 * _half_root()), rel=1e-9
    )


def _half_root() -> float:
    """Half the width of the rack's tooth at its root, in modules, from the corner's geometry."""
    alpha, rho = math.radians(20.0), 0.38
    tool_tip = math.pi / 4 - 1.25 * math.tan(alpha) - rho * (1 - math.sin(alpha)) / math.cos(alpha)
    return math.pi / 2 - tool_tip


@settings(max_examples=12, deadline=None)
@given(st.integers(5, 120), st.floats(-0.2, 0.5), st.floats(1e-3, 0.1))
def test_everything_scales_with_the_module(teeth: int, x: float, module: float) -> None:
    try:
        small = profile(teeth=teeth, pitch=NormalModule(module), profile_shift=x, tolerance=1e-4 * module)
    except InadmissibleError:
        return
    large = profile(teeth=teeth, pitch=NormalModule(2 * module), profile_shift=x, tolerance=2e-4 * module)
    assert large.form_diameter == pytest.approx(2 * small.form_diameter, rel=1e-14)
    assert abs(large.points - small.points) <= 4 * teeth
    (x0, y0), (x1, y1) = pieces(small)[0].start, pieces(large)[0].start
    assert (x1, y1) == pytest.approx((2 * x0, 2 * y0), rel=1e-12)


def test_one_tooth_is_the_first_of_the_whole() -> None:
    one, whole = profile(teeth=20, pitch=PITCH, only_teeth=1), profile(teeth=20, pitch=PITCH)
    assert pieces(one) == pieces(whole)[: len(pieces(one))]
    assert one.drawing is not None
    assert not one.drawing.outlines[0].closed


def test_all_chains_are_one_turned() -> None:
    form = form_of(20)
    chain = flank(form, 1e-6)
    x, y = chain_points(form, chain, 20)
    turn = 2 * math.pi * 7 / 20
    assert x[7] == pytest.approx(x[0] * math.cos(turn) - y[0] * math.sin(turn), abs=1e-16 * 1e3)
    middle = len(x[0]) // 2
    assert x[0][:middle] == pytest.approx(-x[0][::-1][:middle], abs=1e-17 * 1e3)


def test_a_sharp_corner_and_a_full_round() -> None:
    sharp = profile(teeth=12, pitch=PITCH, root_radius_factor=0.0, form=LINES)
    assert sharp.undercut
    assert all(isinstance(piece, (Points, Arc)) for piece in pieces(sharp))
    widest = (
        (math.pi / 4 - 1.25 * math.tan(math.radians(20)))
        * math.cos(math.radians(20))
        / (1 - math.sin(math.radians(20)))
    )
    assert len(pieces(profile(teeth=30, pitch=PITCH, root_radius_factor=widest * (1 - 1e-9)))) >= 5 * 30


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ({"teeth": 6, "profile_shift": 1.0}, "pointed"),
        ({"teeth": 5, "profile_shift": -1.0}, "no-flank"),
        ({"teeth": 24, "internal": True}, "tip-inside-base"),
        ({"teeth": 30, "root_radius_factor": 0.6}, "tip-radius"),
        ({"teeth": 30, "tolerance": 1e-15}, "tolerance"),
        ({"teeth": 30, "only_teeth": 31}, "teeth"),
        ({"teeth": 30, "only_teeth": 0}, "teeth"),
        ({"teeth": 1_000_000}, "too-many-points"),
        ({"teeth": 2}, "teeth"),
        ({"teeth": 0, "rack": True}, "teeth"),
        ({"teeth": 5, "rack": True, "internal": True}, "rack"),
        ({"teeth": 5, "rack": True, "helix_angle": 0.3}, "helix"),
        ({"teeth": 5, "rack": True, "root_radius_factor": 0.6}, "tip-radius"),
        ({"teeth": 30, "pressure_angle": 1.2}, "pressure-angle"),
        ({"teeth": 30, "helix_angle": 1.56}, "helix-angle"),
        ({"teeth": 72, "internal": True, "root_radius_factor": 0.9}, "fillet"),
    ],
)
def test_what_cannot_be_is_refused(arguments: dict, code: str) -> None:
    with pytest.raises(InadmissibleError) as caught:
        profile(pitch=PITCH, **arguments)
    assert caught.value.code == code


def test_names_of_the_trade() -> None:
    assert Sign("khk") == "outward"
    assert Profile("full-depth") == "a"


@pytest.mark.parametrize("pressure_angle", [0.2 + 0.01 * k for k in range(30)])
def test_a_rack_with_sharp_corners_joins_to_the_bit(pressure_angle: float) -> None:
    """Flank and root land were calculated each by itself, and differed by an ulp here and there."""
    found = pieces(profile(teeth=4, pitch=PITCH, rack=True, root_radius_factor=0.0, pressure_angle=pressure_angle))
    for piece, following in pairwise(found):
        assert piece.end == following.start


def test_circles_state_tight_bounds() -> None:
    for arguments in ({"teeth": 9}, {"teeth": 27, "profile_shift": -1.5}, {"teeth": 72, "internal": True}):
        bounds = profile(pitch=PITCH, **arguments).numerics.bounds
        assert {one.result for one in bounds} == {f"{name}_diameter" for name in ("tip", "root", "base", "form")}
        assert all(one.relative and one.bound < 25 * 2.0**-53 for one in bounds)


def test_a_rack_is_drawn_up_to_a_number_of_teeth_and_whatever_gear_it_meets() -> None:
    """No gear of so many teeth has to exist: few teeth of a deep rack are drawn, and far too many refused at once."""
    assert profile(teeth=3, pitch=NormalModule(1e-3), rack=True, dedendum_factor=1.6, pressure_angle=0.3).pieces > 0
    with pytest.raises(InadmissibleError) as refused:
        profile(teeth=9007199254740993, pitch=NormalModule(1e-3), rack=True)
    assert refused.value.code == "too-many-points"


def test_layers_of_a_gear_s_drawing() -> None:
    answer = profile(teeth=20, pitch=PITCH, bore=0.01)
    assert answer.drawing is not None
    assert [outline.name for outline in answer.drawing.outlines] == ["profile", "bore"]
    pitch_circle, *centre_lines = answer.drawing.construction
    assert pitch_circle.name == "pitch circle"
    assert pitch_circle.pieces[0].start[0] == pytest.approx(10.0 * PITCH.module, rel=1e-15)
    assert {line.name for line in centre_lines} == {"centre lines"}
    with pytest.raises(InadmissibleError, match="below the root diameter"):
        profile(teeth=20, pitch=PITCH, bore=0.05)
    with pytest.raises(InadmissibleError, match="no bore"):
        profile(teeth=72, pitch=PITCH, internal=True, bore=0.01)
