"""Pictures of bodies: every shape lies within its picture, the ellipsoid is the body's own, holes are told apart."""

import math
from typing import Any

import pytest

from dynamics_cli.inertia.assembly.assembly import Assembly, body
from dynamics_cli.inertia.assembly.parts import Part
from dynamics_cli.inertia.bodies.amount import OfDensity, OfMass
from dynamics_cli.inertia.pictures import body_picture, drawn_picture, shape_picture
from dynamics_cli.inertia.shapes import Block, Cylinder, Ellipsoid, Shape
from dynamics_cli.inertia.shapes.polygon import Vertex
from dynamics_cli.inertia.shapes.shells import Ends
from dynamics_cli.inertia.shapes.sizes import Radii, Radius, RingRadius, Thickness
from dynamics_cli.inertia.shapes.task import shape
from dynamics_cli.inertia.shapes.wires import wires
from dynamics_cli.numerics.orientation.rotations import AxisAngle
from dynamics_cli.pictures import Curve, Mark

SIZES: dict[str, Any] = {
    "thickness": 0.05, "sides": 7, "ends": Ends("one"), "base": 0.9, "closed": True,
    "size": Radius(0.6), "taper": Radii(0.6, 0.6), "ring": RingRadius(3.0), "wall": Thickness(0.05),
    "vertices": (Vertex(0.0, 0.0), Vertex(1.0, 0.1), Vertex(0.4, 0.9)),
    "first": (0.0, 0.0, 0.0), "second": (1.0, 0.0, 0.1), "third": (0.0, 1.0, 0.2), "fourth": (0.3, 0.3, 1.0),
}  # fmt: skip


@pytest.mark.parametrize("cls", Shape.__args__, ids=lambda cls: cls.tag[1])  # type: ignore[attr-defined]
def test_the_lines_of_a_shape_go_around_its_centroid_and_spread_as_it_does(cls: type) -> None:
    own = cls(**{name: SIZES.get(name, 0.6) for name in cls.fields})  # type: ignore[attr-defined]
    points = [point for wire in wires(own) for point in wire]
    unit = own.unit()
    for k in range(3):
        low, high = min(p[k] for p in points), max(p[k] for p in points)
        assert low - 1e-12 <= unit.centroid[k] <= high + 1e-12
        spread = math.sqrt(unit.second[k][k])
        assert spread <= 0.5 * (high - low) * (1.0 + 1e-12)
        assert spread >= 0.05 * (high - low)
    picture = shape_picture(shape(own, amount=OfMass(1.0)), own)
    assert len(picture.panels) == 3
    assert all(
        math.isfinite(x)
        for panel in picture.panels
        for item in panel.items
        if isinstance(item, Curve)
        for x in (*item.x, *item.y)
    )


def test_the_ellipsoid_of_an_ellipsoid_is_itself() -> None:
    own = Ellipsoid(0.3, 0.5, 0.9)
    picture = drawn_picture(shape(own, amount=OfMass(1.0)), [], "")
    curve = next(item for item in picture.panels[1].items if isinstance(item, Curve))
    assert max(curve.x) == pytest.approx(0.3, rel=1e-3)
    assert max(curve.y) == pytest.approx(0.9, rel=1e-3)


def test_holes_are_dashed_and_parts_are_where_they_are() -> None:
    plate = Part(
        name="plate",
        shape=Block(0.4, 0.2, 0.02),
        amount=OfDensity(2700.0),
        turn=AxisAngle((0.0, 0.0, 1.0), math.pi / 2),
    )
    bore = Part(
        name="bore",
        shape=Cylinder(Radius(0.03), 0.02),
        amount=OfDensity(2700.0),
        position=(0.05, 0.1, 0.0),
        subtract=True,
    )
    scene = Assembly(parts=(plate, bore), name="a plate")
    picture = body_picture(body(scene), scene)
    assert picture.title == "a plate"
    curves = [item for item in picture.panels[0].items if isinstance(item, Curve)]
    solid = [c for c in curves if c.style == "thin"]
    holes = [c for c in curves if c.style == "dashed"]
    assert max(max(c.x) for c in solid) == pytest.approx(0.1, rel=1e-12)
    assert max(max(c.y) for c in solid) == pytest.approx(0.2, rel=1e-12)
    assert min(min(c.x) for c in holes) == pytest.approx(0.02, rel=1e-12)


def test_names_that_would_run_into_one_another_are_left_out() -> None:
    parts = tuple(
        Part(name=name, shape=Block(1.0, 1.0, 0.1), amount=OfDensity(density), position=(x, 0.0, 0.0))
        for name, x, density in (("middle", 0.5, 10.0), ("near", 0.45, 1.0), ("far", 2.0, 1.0))
    )
    scene = Assembly(parts=parts)
    marks = [item.label for item in body_picture(body(scene), scene).panels[0].items if isinstance(item, Mark)]
    assert marks == ["C", "far"]
