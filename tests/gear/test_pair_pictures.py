"""Pictures of pairs: flanks that touch at the pitch point and do not cross, sliding that is zero there."""

from math import hypot, isfinite

import pytest

from dynamics_cli.gear.pair.pair import pair
from dynamics_cli.gear.pair.pictures import involute_curve
from dynamics_cli.gear.pair.pictures import pair as pair_picture
from dynamics_cli.gear.pair.records import Mate
from dynamics_cli.gear.pitch import NormalModule
from dynamics_cli.gear.single.gear import Sign
from dynamics_cli.gear.single.involute_curve import AtAngle, involute_point
from dynamics_cli.pictures import Band, Curve, Dimension, Label, Mark, Rows

TWO = NormalModule(0.002)


@pytest.mark.parametrize(("second", "internal"), [(Mate(31, 0.2), False), (Mate(60, -0.1), True)])
def test_the_flanks_touch_at_the_pitch_point(second: Mate, internal: bool) -> None:
    first = Mate(20, 0.3)
    made = pair(first=first, second=second, pitch=TWO, internal=internal)
    picture = pair_picture(made, first=first, second=second, internal=internal, pitch=TWO)
    whole, contact, rows, sliding = picture.panels
    shapes = [item for item in whole.items if isinstance(item, Curve) and item.style in ("filled", "outline")]
    assert len(shapes) == 2
    radius = 0.5 * made.first_working_diameter
    for curve in shapes:
        nearest = min(hypot(x - radius, y) for x, y in zip(curve.x, curve.y, strict=True))
        assert nearest < 0.2 * 0.002
    (distance,) = (item for item in whole.items if isinstance(item, Dimension))
    assert distance.x[1] - distance.x[0] == pytest.approx(made.centre_distance, rel=1e-14)
    marks = [item for item in contact.items if isinstance(item, Mark)]
    assert hypot(marks[-1].x, marks[-1].y) == pytest.approx(0.5 * made.points[-1].first_diameter, rel=1e-12)
    centre = -made.centre_distance if internal else made.centre_distance
    assert hypot(marks[0].x - centre, marks[0].y) == pytest.approx(0.5 * made.points[0].second_diameter, rel=1e-12)
    assert isinstance(rows.items[0], Rows)
    own, mate = sliding.items[:2]
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
    panels = pair_picture(made, first=first, second=second, pitch=TWO).panels
    marks = [item for item in panels[1].items if isinstance(item, Mark)]
    names = [item for item in panels[3].items if isinstance(item, Label)]
    names = [item for item in names if not item.text.startswith("gear")]
    for items in (marks, names):
        assert [item.label if isinstance(item, Mark) else item.text for item in items] == ["A", "B", "C", "D", "E"]
    bands = [item for item in panels[3].items if isinstance(item, Band)]
    assert [band.low for band in bands] == [point.path for point in made.points]
    assert all(not band.label for band in bands)


def test_a_gear_without_an_exact_root_is_drawn_by_its_circles() -> None:
    first, second = Mate(16), Mate(24, 0.5)
    given = {"pitch": TWO, "internal": True, "shift_sign": Sign("outward")}
    made = pair(first=first, second=second, **given)
    picture = pair_picture(made, first=first, second=second, root_radius_factor=0.9, **given)
    circles = [item for item in picture.panels[0].items if isinstance(item, Curve) and item.style == "outline"]
    assert [max(item.x) - min(item.x) for item in circles] == pytest.approx(
        [made.first_tip_diameter, made.second_tip_diameter], rel=1e-9
    )
