"""Pictures of pairs: flanks that touch at the pitch point and do not cross, sliding that is zero there."""

from math import hypot, isfinite

import pytest

from dynamics_cli.gear.curve import AtAngle, involute_point
from dynamics_cli.gear.gear import NormalModule
from dynamics_cli.gear.pair import pair
from dynamics_cli.gear.pair_data import Mate
from dynamics_cli.gear.pair_pictures import involute_curve
from dynamics_cli.gear.pair_pictures import pair as pair_picture
from dynamics_cli.pictures import Band, Curve, Mark

TWO = NormalModule(0.002)


@pytest.mark.parametrize(("second", "internal"), [(Mate(31, 0.2), False), (Mate(60, -0.1), True)])
def test_the_flanks_touch_at_the_pitch_point(second: Mate, internal: bool) -> None:
    first = Mate(20, 0.3)
    made = pair(first=first, second=second, pitch=TWO, internal=internal)
    picture = pair_picture(made, first=first, second=second, internal=internal)
    assert len(picture.panels) == 3
    one, two = (item for item in picture.panels[0].items[:2] if isinstance(item, Curve))
    radius = 0.5 * made.first_working_diameter
    for curve in (one, two):
        nearest = min(hypot(x - radius, y) for x, y in zip(curve.x, curve.y, strict=True))
        assert nearest < 0.05 * 0.002
    sliding = picture.panels[1].items[0]
    assert isinstance(sliding, Curve)
    assert sliding.y[0] == pytest.approx(made.points[0].sliding_factor, rel=1e-9)
    assert sliding.y[-1] == pytest.approx(made.points[-1].sliding_factor, rel=1e-9)
    own, mate = picture.panels[2].items[:2]
    assert own.y[-1] == pytest.approx(made.points[-1].first_sliding, rel=1e-9)  # type: ignore[union-attr]
    assert mate.y[0] == pytest.approx(made.points[0].second_sliding, rel=1e-9)  # type: ignore[union-attr]


def test_the_involute_ends_where_it_was_asked_for() -> None:
    made = involute_point(at=AtAngle(0.6), base_diameter=0.05)
    curve = involute_curve(made, base_diameter=0.05).panels[0].items[0]
    assert isinstance(curve, Curve)
    assert hypot(curve.x[-1], curve.y[-1]) == pytest.approx(0.5 * made.diameter, rel=1e-14)
    plain = involute_curve(involute_point(at=AtAngle(0.6))).panels[0].items[0]
    assert isinstance(plain, Curve)
    assert all(isfinite(y) for y in plain.y)


def test_the_points_of_contact_are_named_on_the_curve_and_not_in_the_legend() -> None:
    first, second = Mate(20, 0.3), Mate(31, 0.2)
    made = pair(first=first, second=second, pitch=TWO)
    for panel in pair_picture(made, first=first, second=second).panels[1:]:
        marks = [item for item in panel.items if isinstance(item, Mark)]
        assert [mark.label for mark in marks] == ["A", "B", "C", "D", "E"]
        assert [mark.x for mark in marks] == [point.path for point in made.points]
        assert all(not item.label for item in panel.items if isinstance(item, Band))
