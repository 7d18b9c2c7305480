"""Pictures of rigid impacts: finite, in the right axes, and true to the answer."""

import math
from typing import Any

import pytest

from dynamics_cli.impact import rigid_pictures
from dynamics_cli.impact.conventions import Axes, ByMass, ByVelocity, Fixed, Restituted
from dynamics_cli.impact.planar.bodies import ByInertia, Lever, RigidBody, RigidTarget
from dynamics_cli.impact.planar.envelope import envelope
from dynamics_cli.impact.planar.impact import planar
from dynamics_cli.impact.planar.laws import LAWS, Law
from dynamics_cli.impact.spatial.impact import BodyInSpace, LeverInSpace, TargetInSpace, spatial
from dynamics_cli.impact.vehicle_outlines import outline
from dynamics_cli.pictures import Arrow, Curve, Mark, Picture
from dynamics_cli.quantities import Impulse

CARS = {
    "first": RigidBody(ByMass(1500.0), ByInertia(2500.0), Lever((2.0, -0.4)), ByVelocity((15.0, 0.0))),
    "second": RigidTarget(ByMass(1200.0), ByInertia(1800.0), Lever((-0.8, 0.5)), ByVelocity((0.0, 10.0))),
    "normal": 0.17,
}
WALL = {"first": CARS["first"], "second": RigidTarget(Fixed(True)), "normal": 0.17}


def numbers(picture: Picture) -> list[float]:
    found: list[float] = []
    for panel in picture.panels:
        for item in panel.items:
            if isinstance(item, Curve):
                assert len(item.x) == len(item.y)
                found += [*item.x, *item.y]
            elif isinstance(item, Mark):
                found += [item.x, item.y]
            elif isinstance(item, Arrow):
                found += [item.x, item.y, item.dx, item.dy]
    return found


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("scene", [CARS, WALL], ids=["cars", "wall"])
@pytest.mark.parametrize("friction", [0.0, 0.4, 5.0])
def test_planar_pictures_end_where_the_impact_ends(law: str, scene: dict[str, Any], friction: float) -> None:
    given = {**scene, "friction": friction, "contact": Restituted(0.3), "law": Law(law)}
    made = planar(**given)
    picture = rigid_pictures.planar(made, **given)
    assert all(map(math.isfinite, numbers(picture)))
    diagram = picture.panels[-1]
    assert diagram.x.kind is Impulse
    path = next(item for item in diagram.items if isinstance(item, Curve) and item.label == "impulse")
    assert (path.x[-1], path.y[-1]) == (made.normal_impulse, made.tangential_impulse)
    limit = friction * (1.0 + 1e-12)
    assert all(abs(q) <= limit * p + 1e-9 for p, q in zip(path.x, path.y, strict=True))


def test_sae_axes_are_turned_over_on_the_page() -> None:
    """The same wall seen from above, its y once to the left and once to the right."""
    drawn = []
    for axes, side in (("mathematical", 1.0), ("sae", -1.0)):
        car = RigidBody(ByMass(1500.0), ByInertia(2500.0), Lever((2.0, -0.4 * side)), ByVelocity((15.0, 3.0 * side)))
        given = {"first": car, "second": RigidTarget(Fixed(True)), "normal": 0.17 * side, "friction": 0.4,
                 "axes": Axes(axes), "contact": Restituted(0.3), "law": Law("stronge")}  # fmt: skip
        panels = rigid_pictures.planar(planar(**given), **given).panels
        drawn.append(numbers(Picture(panels[:2], "")))
    assert drawn[0] == pytest.approx(drawn[1], rel=1e-12, abs=1e-12)


def test_the_hodograph_begins_with_the_slip_before() -> None:
    inertia = ((0.02, 0.0, 0.0), (0.0, 0.03, 0.004), (0.0, 0.004, 0.04))
    body = BodyInSpace(ByMass(2.0), inertia, LeverInSpace((0.1, 0.05, -0.2)), (3.0, 1.0, -4.0), (0.0, 5.0, 2.0))
    given = {"first": body, "second": TargetInSpace(Fixed(True)), "normal": (0.0, 0.0, -1.0), "friction": 0.4,
             "contact": Restituted(0.6)}  # fmt: skip
    made = spatial(**given)
    picture = rigid_pictures.spatial(made, **given)
    assert all(map(math.isfinite, numbers(picture)))
    slip = picture.panels[1].items[0]
    assert math.hypot(slip.x[0], slip.y[0]) == pytest.approx(math.hypot(*made.sliding_before))
    assert math.hypot(slip.x[-1], slip.y[-1]) == pytest.approx(math.hypot(*made.sliding_after), rel=0.05)


def test_envelopes_draw_a_curve_for_each_restitution() -> None:
    made = envelope(**CARS, restitution_points=10, friction_points=10, map_points=4)
    picture = rigid_pictures.envelope(made)
    assert [len(panel.items) for panel in picture.panels] == [4, 4]
    assert len(rigid_pictures.envelope(envelope(**WALL, restitution_points=5, friction_points=5)).panels) == 1


def test_a_narrow_vehicle_is_a_two_wheeler() -> None:
    car, motorcycle = (outline((0.0, 0.0), (1.0, 0.0), 0, length=2.2, width=width) for width in (1.8, 0.8))
    assert [sum(item.style == "thick" for item in items) for items in (car, motorcycle)] == [4, 2]
    for items, width in ((car, 1.8), (motorcycle, 0.8)):
        across = [y for item in items for y in item.y]
        along = [x for item in items for x in item.x]
        assert (max(across), min(across)) == pytest.approx((0.5 * width, -0.5 * width))
        assert (max(along), min(along)) == pytest.approx((1.1, -1.1))
