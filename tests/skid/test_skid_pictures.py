"""Pictures of drag factors and spins: the curves go through what was answered."""

import pytest

from dynamics_cli.pictures import Curve, Mark
from dynamics_cli.quantities import STANDARD_GRAVITY
from dynamics_cli.skid import pictures
from dynamics_cli.skid.drag import Axles, Sled, Surface, drag_factor
from dynamics_cli.skid.spin import Rotation, Share, spin


@pytest.mark.parametrize(
    "measurement",
    [Surface(0.7, -0.04, 0.85), Sled(124.0, 178.0, 0.1, 0.05), Axles(0.75, 0.75, 2.7, 1.2, 0.55, 1.0, 0.4, 0.03)],
)
def test_the_curve_over_the_grade_goes_through_the_answer(measurement: Surface | Sled | Axles) -> None:
    made = drag_factor(measurement=measurement)
    panel = pictures.drag_factor(made, measurement=measurement).panels[0]
    curve, mark = panel.items[:2]
    assert isinstance(curve, Curve)
    assert isinstance(mark, Mark)
    nth = max(k for k in range(len(curve.x)) if curve.x[k] <= mark.x)
    assert curve.y[nth] <= mark.y <= curve.y[nth + 1]
    assert mark.y == made.drag_factor


@pytest.mark.parametrize("drag", [Rotation(3.7, 0.2, 0.1), Share(0.6)])
def test_a_spin_begins_and_ends_at_its_speeds(drag: Rotation | Share) -> None:
    given = {"drag": drag, "distance": 18.0, "friction": 0.65, "grade": 0.02, "end_speed": 3.0}
    made = spin(**given)
    road = pictures.spin(made, **given, gravity=STANDARD_GRAVITY).panels[-1].items[0]
    assert isinstance(road, Curve)
    assert road.y[0] == pytest.approx(made.speed, rel=1e-12)
    assert road.y[-1] == pytest.approx(3.0, rel=1e-12)
    assert list(road.y) == sorted(road.y, reverse=True)
