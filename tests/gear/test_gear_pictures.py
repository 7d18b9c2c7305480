"""Pictures of single gears, of crossing axes and of wheels: what is drawn lies where the answer says."""

import math

import pytest

from dynamics_cli.gear.crossing import pictures, skew_pictures
from dynamics_cli.gear.crossing.bevel import bevel
from dynamics_cli.gear.crossing.crossed import Screw, crossed
from dynamics_cli.gear.crossing.hypoid import hypoid
from dynamics_cli.gear.crossing.worm import AxialModule, WormDiameter, worm
from dynamics_cli.gear.measure import pictures as measure_pictures
from dynamics_cli.gear.measure.measurement import measure
from dynamics_cli.gear.pair.rack import rack
from dynamics_cli.gear.pitch import NormalModule
from dynamics_cli.gear.single import pictures as single_pictures
from dynamics_cli.gear.single.cylindrical import helical, spur
from dynamics_cli.gear.trains import wheel_pictures
from dynamics_cli.gear.trains.wheels import Drive, wheels
from dynamics_cli.pictures import Arrow, Curve, Mark, Panel, Picture

M3 = NormalModule(0.003)


def styled(picture: Picture, style: str) -> list[Curve]:
    return [item for panel in picture.panels for item in panel.items if isinstance(item, Curve) and item.style == style]


def radii(curve: Curve) -> list[float]:
    return [math.hypot(x, y) for x, y in zip(curve.x, curve.y, strict=True)]


@pytest.mark.parametrize(
    ("made", "given"),
    [
        (spur(teeth=12, pitch=M3, profile_shift=0.6), {"teeth": 12, "profile_shift": 0.6}),
        (spur(teeth=9, pitch=M3, avoid_undercut=True), {"teeth": 9, "avoid_undercut": True}),
        (helical(teeth=20, pitch=M3, helix_angle=0.3), {"teeth": 20, "helix_angle": 0.3}),
    ],
)
def test_teeth_reach_from_the_root_to_the_tip_circle_and_stand_upright(made: object, given: dict) -> None:
    picture = single_pictures.gear_picture(made, pitch=M3, **given)
    (teeth,) = (item for item in picture.panels[-1].items if isinstance(item, Curve) and item.style == "outline")
    own = radii(teeth)
    assert max(own) == pytest.approx(0.5 * made.tip_diameter, rel=1e-9)
    assert min(own) == pytest.approx(0.5 * made.root_diameter, rel=1e-9)
    assert min(teeth.x) == pytest.approx(-max(teeth.x), rel=1e-9)


def test_a_fillet_that_does_not_fit_leaves_the_circles() -> None:
    given = {"teeth": 60, "internal": True, "root_radius_factor": 0.9}
    picture = single_pictures.gear_picture(spur(pitch=M3, **given), pitch=M3, **given)
    enlarged = [item for item in picture.panels[-1].items if isinstance(item, Curve)]
    assert not any(item.style == "outline" for item in enlarged)
    assert sum(item.style == "centre" for item in enlarged) == 1


def test_the_span_line_is_as_long_as_the_span_and_touches_the_base_circle() -> None:
    made = measure(teeth=24, pitch=M3, profile_shift=0.4)
    picture = measure_pictures.measure_picture(made, teeth=24, pitch=M3, profile_shift=0.4)
    (line,) = styled(picture, "dashed")
    (x0, x1), (y0, y1) = line.x, line.y
    assert math.hypot(x1 - x0, y1 - y0) == pytest.approx(made.span.span, rel=1e-12)
    assert math.hypot(x0 + x1, y0 + y1) == pytest.approx(2 * 0.5 * 24 * 0.003 * math.cos(math.radians(20)), rel=1e-9)


def test_a_gear_s_tooth_fills_the_space_of_its_rack() -> None:
    made = rack(teeth=20, pitch=M3)
    picture = single_pictures.rack_picture(made, teeth=20, pitch=M3)
    bar, teeth = styled(picture, "filled")
    assert max(teeth.y) == pytest.approx(-made.datum_distance + made.addendum, rel=1e-12)
    assert min(bar.y) == pytest.approx(-0.5 * made.tip_diameter, rel=1e-9)


def test_both_bevel_wheels_meet_along_one_pitch_line() -> None:
    made = bevel(first_teeth=20, second_teeth=40, module=0.003, face_width=0.022)
    items = pictures.bevel(made, face_width=0.022).panels[0].items
    lines = [item for item in items if isinstance(item, Curve) and item.style == "dotted"]
    ends = [(line.x[1], line.y[1]) for line in lines]
    assert ends[0] == pytest.approx(ends[2], rel=1e-12)
    assert math.hypot(*ends[0]) == pytest.approx(made.cone_distance, rel=1e-12)


def test_the_worm_lies_on_the_curve_of_its_efficiency() -> None:
    made = worm(threads=2, teeth=30, size=AxialModule(0.003), worm=WormDiameter(0.044))
    panel = pictures.worm(made, teeth=30).panels[1]
    forward, backward, mark = panel.items[:3]
    assert isinstance(forward, Curve)
    assert isinstance(backward, Curve)
    assert isinstance(mark, Mark)
    for curve, value in ((forward, made.efficiency), (backward, made.backward_efficiency)):
        nth = min(range(len(curve.x)), key=lambda k: abs(curve.x[k] - made.lead_angle))
        assert curve.y[nth] == pytest.approx(value, abs=0.03)
    assert (mark.x, mark.y) == (made.lead_angle, made.efficiency)


def sliding(panel: Panel) -> tuple[Arrow, Arrow, Arrow]:
    first, second, slip = (item for item in panel.items if isinstance(item, Arrow))
    return first, second, slip


@pytest.mark.parametrize("hands", [(0.35, 0.52), (0.6, -0.2), (-0.35, -0.52)])
def test_screws_slide_along_their_teeth_alone(hands: tuple[float, float]) -> None:
    first, second = Screw(15, hands[0]), Screw(24, hands[1])
    made = crossed(first=first, second=second, module=0.003)
    _, _, slip = sliding(skew_pictures.crossed(made, first=first, second=second, module=0.003).panels[1])
    along = math.cos(hands[0]), math.sin(hands[0])
    assert slip.dx * along[1] - slip.dy * along[0] == pytest.approx(0.0, abs=1e-9)


def test_a_hypoid_pair_slides_as_it_says() -> None:
    made = hypoid(first_teeth=10, second_teeth=41, offset=0.035, wheel_radius=0.085)
    picture = skew_pictures.hypoid(made, offset=0.035, wheel_radius=0.085)
    _, second, slip = sliding(picture.panels[1])
    ratio = math.hypot(slip.dx, slip.dy) / math.hypot(second.dx, second.dy)
    assert ratio == pytest.approx(made.sliding_ratio, rel=1e-9)


@pytest.mark.parametrize("drive", ["open-belt", "crossed-belt"])
def test_a_belt_touches_both_wheels(drive: str) -> None:
    given = {"first_diameter": 0.1, "second_diameter": 0.3, "centre_distance": 0.5, "drive": Drive(drive)}
    (belt,) = styled(wheel_pictures.wheels(wheels(**given), **given), "thick")
    (x0, x1), (y0, y1) = belt.x[:2], belt.y[:2]
    length = math.hypot(x1 - x0, y1 - y0)
    assert length == pytest.approx(wheels(**given).span, rel=1e-12)
    for x, radius in ((0.0, 0.05), (0.5, 0.15)):
        assert abs((x1 - x0) * (0.0 - y0) - (x - x0) * (y1 - y0)) / length == pytest.approx(radius, rel=1e-12)


@pytest.mark.parametrize("drive", ["open-belt", "crossed-belt"])
def test_a_belt_is_as_long_as_the_answer_says(drive: str) -> None:
    given = {"first_diameter": 0.1, "second_diameter": 0.3, "centre_distance": 0.5, "drive": Drive(drive)}
    made = wheels(**given)
    (belt,) = styled(wheel_pictures.wheels(made, **given), "thick")
    steps = zip(belt.x, belt.y, belt.x[1:], belt.y[1:], strict=False)
    assert sum(math.hypot(c - a, d - b) for a, b, c, d in steps) == pytest.approx(made.belt_length, rel=1e-4)


def test_crossed_gears_show_their_teeth_in_one_direction_where_they_touch() -> None:
    first, second = Screw(15, 0.35), Screw(24, 0.52)
    made = crossed(first=first, second=second, module=0.003)
    scene = skew_pictures.crossed(made, first=first, second=second, module=0.003).panels[0]
    traces = [item for item in scene.items if isinstance(item, Curve) and item.style == "thin"]
    through = [trace for trace in traces if min(map(math.hypot, trace.x, trace.y)) < 1e-12]
    slopes = []
    for trace in through:
        middle = min(range(len(trace.x)), key=lambda k: math.hypot(trace.x[k], trace.y[k]))
        before, after = middle - 1, middle + 1
        slopes.append(math.atan2(trace.y[after] - trace.y[before], trace.x[after] - trace.x[before]))
    assert len(slopes) == 2
    assert slopes == pytest.approx([made.first_working_helix] * 2, abs=0.01)
