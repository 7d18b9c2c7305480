"""Every picture of path is drawn of what was answered: arrows along v and a, curves through the table."""

import math
from itertools import pairwise
from typing import Any

import pytest

from dynamics_cli.numerics.orientation.moving_frame import moving_frame
from dynamics_cli.path import pictures
from dynamics_cli.path.circle import Turning, circle
from dynamics_cli.path.components import components
from dynamics_cli.path.coordinates import polar
from dynamics_cli.path.curves.named import Cycloid, Helix
from dynamics_cli.path.curves.task import curve
from dynamics_cli.path.relative.motions import Mover
from dynamics_cli.path.relative.task import relative
from dynamics_cli.path.straight.task import Phase, rectilinear
from dynamics_cli.pictures import Arrow, Curve


def items(picture: Any, kind: type, panel: int = 0) -> list[Any]:
    return [item for item in picture.panels[panel].items if isinstance(item, kind)]


def test_straight_motion_is_smooth_between_its_rows() -> None:
    phases = (Phase(start_speed=0.0, end_speed=20.0, acceleration=2.0), Phase(acceleration=0.0, time=5.0))
    drawn = pictures.rectilinear(rectilinear(phases=phases, steps=2), phases=phases)
    (place,), (speed,), (rate,) = (items(drawn, Curve, panel) for panel in range(3))
    for t, s, v, a in zip(place.x, place.y, speed.y, rate.y, strict=True):
        assert s == pytest.approx(t * t if t <= 10.0 else 100.0 + 20.0 * (t - 10.0), abs=1e-9)
        assert v == pytest.approx(min(2.0 * t, 20.0), abs=1e-9)
        assert a == pytest.approx(2.0, abs=1e-9) or a == pytest.approx(0.0, abs=1e-9)


def test_arrows_point_along_velocity_and_acceleration() -> None:
    made = polar(radius=0.3, angle=0.5, radial_speed=0.8, angular_velocity=5.0, angular_acceleration=2.0)
    *parts, velocity, rate = items(pictures.around(made, radius=0.3, angle=0.5), Arrow)
    for arrow, vector in ((velocity, made.cartesian_velocity), (rate, made.cartesian_acceleration)):
        assert math.atan2(arrow.dy, arrow.dx) == pytest.approx(math.atan2(vector[1], vector[0]))
    assert sum(part.dx for part in parts) == pytest.approx(rate.dx)


def test_the_circle_of_curvature_touches_the_path() -> None:
    made = curve(shape=Cycloid(0.3), start=1.0, end=3.0)
    drawn = pictures.curve(made, shape=Cycloid(0.3))
    ring = next(item for item in items(drawn, Curve) if item.label)
    # the centre of the circle through three of its points
    one, two, three = (complex(ring.x[k], ring.y[k]) for k in (0, len(ring.x) // 2, -1))
    a, b = two - one, three - one
    away = one - 1j * (b * abs(a) ** 2 - a * abs(b) ** 2) / (2.0 * (a.conjugate() * b).imag)
    centre = away.real, away.imag
    assert math.dist(centre, made.position[:2]) == pytest.approx(made.radius_of_curvature)
    assert abs(two - complex(*made.position[:2])) < 0.05 * made.radius_of_curvature
    assert (centre[0] - made.position[0]) * made.acceleration[0] + (centre[1] - made.position[1]) * made.acceleration[
        1
    ] > 0


def test_terms_are_drawn_head_to_tail() -> None:
    made = moving_frame(
        position=(0.3, 0.0, 0.0),
        angular_velocity=(0.0, 0.0, 5.0),
        relative_velocity=(0.8, 0.1, 0.0),
        relative_acceleration=(1.0, 0.0, 0.0),
    )
    *terms, total = items(pictures.moving_frame(made), Arrow)
    assert all((one.x + one.dx, one.y + one.dy) == pytest.approx((other.x, other.y)) for one, other in pairwise(terms))
    assert (total.dx, total.dy) == pytest.approx((terms[-1].x + terms[-1].dx, terms[-1].y + terms[-1].dy))


def test_closest_approach_is_marked() -> None:
    first, second = Mover(velocity=(15.0, 0.0, 0.0)), Mover((120.0, -80.0, 0.0), (0.0, 11.0, 0.0))
    made = relative(first=first, second=second)
    link = items(pictures.relative(made, first=first, second=second), Curve)[-1]
    assert math.dist((link.x[0], link.y[0]), (link.x[1], link.y[1])) == pytest.approx(made.closest_distance)


def test_circle_and_rest_are_drawn() -> None:
    drawn = pictures.circle(circle(radius=2.0, state=Turning(3.0, 1.0), time=1.0), radius=2.0)
    assert len(items(drawn, Arrow)) == 4
    rest = components(velocity=(0.0, 0.0, 0.0), acceleration=(1.0, 0.0, 0.0))
    assert [arrow.label for arrow in items(pictures.in_space(rest), Arrow)] == ["a"]


def test_a_curve_in_space_is_seen_obliquely() -> None:
    shape = Helix(0.5, 0.3)
    made = curve(shape=shape, start=0.0, end=12.0)
    drawn = pictures.curve(made, shape=shape)
    path = items(drawn, Curve)[0]
    assert "obliquely" in drawn.title
    # the pitch shows: the ends of two turns do not fall together
    assert abs(path.y[-1] - path.y[0]) > 0.1
    assert len(items(drawn, Arrow)) == 5
