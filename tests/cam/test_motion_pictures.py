"""Pictures of motion show what the documents say."""

from math import isnan, pi

import pytest

from dynamics_cli.cam.forces.forces import force
from dynamics_cli.cam.forces.pictures import forces
from dynamics_cli.cam.forces.records import Slide
from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.rise import rise
from dynamics_cli.cam.program.pictures import one_rise, svaj
from dynamics_cli.cam.program.reading import Program
from dynamics_cli.cam.program.revolution import motion
from dynamics_cli.core.output.plot import pages
from dynamics_cli.pictures import Curve, Mark

LINE = "rise 20 mm in 90 deg parabolic; dwell 60 deg; return in 90 deg 3-4-5; dwell"


def curve(panel) -> Curve:
    return next(item for item in panel.items if isinstance(item, Curve))


def test_svaj_has_four_panels_over_the_turn_that_reach_the_extremes() -> None:
    found = motion(Program(), program=LINE)
    picture = svaj(found, Program(), program=LINE, count=37, shaft_speed=None, singularity=False)
    assert [panel.y.title for panel in picture.panels] == ["lift s", "velocity v", "acceleration a", "jerk j"]
    for panel, ends in zip(picture.panels, (found.lift, found.velocity, found.acceleration, found.jerk), strict=True):
        line = curve(panel)
        assert line.x[0] == 0.0
        assert line.x[-1] == 2 * pi
        drawn = [y for y in line.y if not isnan(y)]
        assert max(drawn) == pytest.approx(ends.greatest, rel=1e-3)
        assert min(drawn) == pytest.approx(ends.least, rel=1e-3, abs=1e-12)
        # an extreme of nothing needs no mark
        marked = {mark.y for mark in panel.items if isinstance(mark, Mark)}
        assert marked | {0.0} == {ends.greatest, ends.least, 0.0}


def test_a_jump_is_a_gap() -> None:
    line = curve(svaj(motion(Program(), program=LINE), Program(), program=LINE).panels[2])
    gaps = [index for index, y in enumerate(line.y) if isnan(y)]
    assert len(gaps) == 5
    assert line.y[gaps[0] - 1] > 0.0 > line.y[gaps[0] + 1]


def test_a_swing_is_drawn_as_an_angle() -> None:
    line = "rise 20 deg in 180 deg; return in 180 deg"
    picture = svaj(motion(Program(), program=line), Program(), program=line)
    assert picture.panels[0].y.title == "swing ψ"


def test_a_rise_marks_the_points_asked_for() -> None:
    given = {"law": LawName("cycloidal"), "lift": 0.02, "span": 1.5}
    picture = one_rise(rise(**given, at=(0.3, 0.75)), **given, at=(0.3, 0.75), count=19, falling=False)
    points = picture.panels[0].items[1]
    assert list(points.x) == [0.3, 0.75]
    assert points.y[1] == 0.01


def test_forces_are_drawn_with_their_extremes() -> None:
    given = {"shaft_speed": 50.0, "train": Slide(0.5, 5000.0, 60.0)}
    found = force(Program(), program=LINE, **given)
    picture = forces(found, Program(), program=LINE, **given)
    drawn = [y for y in curve(picture.panels[1]).y if not isnan(y)]
    assert max(drawn) == pytest.approx(found.greatest_force, rel=1e-3)
    assert min(drawn) == pytest.approx(found.least_force, rel=1e-3)


def test_the_turn_fills_the_axis_of_cam_angles() -> None:
    axes = pytest.importorskip("matplotlib.figure").Figure().add_subplot()
    panel = svaj(motion(Program(), program=LINE), Program(), program=LINE).panels[0]
    pages._panel(axes, panel, "si", 1)
    assert axes.get_xlim() == pytest.approx((0.0, 360.0))
    assert list(axes.get_xticks()) == pytest.approx([30.0 * k for k in range(-1, 14)])
