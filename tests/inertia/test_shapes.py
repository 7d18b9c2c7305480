"""Shapes: limits met from both sides, laws of scale and lamina, parts that make up wholes, refusals."""

import math
from typing import Any

import harness
import pytest
from harness import answer, run
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.inertia.bodies.amount import OfArealDensity, OfDensity, OfLinearDensity, OfMass, OfMaterial
from dynamics_cli.inertia.bodies.materials import TABLE, density_of, materials
from dynamics_cli.inertia.bodies.properties import Axes, ProductSign
from dynamics_cli.inertia.bodies.records import Shaft
from dynamics_cli.inertia.shapes import (
    PLATES,
    RODS,
    Annulus,
    ArcRod,
    Block,
    Capsule,
    ClosedCylinder,
    Cone,
    ConicalShell,
    Cylinder,
    CylindricalShell,
    Disk,
    Frustum,
    FrustumShell,
    HalfDisk,
    Hemisphere,
    HemisphericalShell,
    HollowBlock,
    HollowCylinder,
    HollowFrustum,
    HollowHemisphere,
    HollowSphere,
    HollowTorus,
    Polygon,
    Prism,
    QuarterDisk,
    Rectangle,
    RectangularTube,
    RegularPrism,
    Rod,
    Sector,
    SemicircleRod,
    Shape,
    Sphere,
    SphericalShell,
    Torus,
    TorusShell,
    Triangle,
    Wedge,
)
from dynamics_cli.inertia.shapes.listing import shapes as listed
from dynamics_cli.inertia.shapes.polygon import Vertex
from dynamics_cli.inertia.shapes.polyhedra import AcrossFlats
from dynamics_cli.inertia.shapes.shells import Ends
from dynamics_cli.inertia.shapes.sizes import (
    Diameter,
    Diameters,
    InnerDiameter,
    InnerRadius,
    Radii,
    Radius,
    RingDiameter,
    RingRadius,
    Thickness,
)
from dynamics_cli.inertia.shapes.task import shape
from dynamics_cli.numerics.orientation.rotations import AxisAngle

SIZE = st.floats(0.05, 5.0)
ONE = OfMass(1.0)


def numbers(own: Any) -> list[float]:
    """Centroid and second moments of mass one."""
    unit = own.unit()
    return [*unit.centroid, *(unit.second[i][j] for i in range(3) for j in range(i + 1))]


def alike(a: Any, b: Any, within: float = 1e-13, *, measure: bool = True) -> None:
    assert numbers(a) == pytest.approx(numbers(b), rel=within, abs=within * max(map(abs, numbers(b))))
    if measure:
        assert a.unit().measure == pytest.approx(b.unit().measure, rel=within)


@given(SIZE, SIZE, SIZE)
def test_a_wall_as_thick_as_the_body_leaves_no_hole(r: float, length: float, big: float) -> None:
    alike(HollowSphere(Radius(r), Thickness(r)), Sphere(Radius(r)))
    alike(HollowHemisphere(Radius(r), Thickness(r)), Hemisphere(Radius(r)))
    alike(HollowCylinder(Radius(r), Thickness(r), length), Cylinder(Radius(r), length))
    alike(Annulus(Radius(r), Thickness(r)), Disk(Radius(r)))
    alike(ClosedCylinder(Radius(r), min(r, length / 2), length), Cylinder(Radius(r), length))
    alike(HollowBlock(r, length, big, min(r, length, big) / 2), Block(r, length, big))
    alike(RectangularTube(r, length, min(r, length) / 2, big), Block(r, length, big))
    alike(HollowFrustum(Radii(r, r), r, length), Frustum(Radii(r, r), length))
    alike(HollowTorus(RingRadius(6.0), Radius(r), r), Torus(RingRadius(6.0), Radius(r)))


@given(SIZE, SIZE)
def test_a_thin_wall_tends_to_the_shell(r: float, length: float) -> None:
    thin = 1e-9
    alike(HollowSphere(Radius(r), Thickness(thin * r)), SphericalShell(Radius(r)), 1e-8, measure=False)
    alike(HollowHemisphere(Radius(r), Thickness(thin * r)), HemisphericalShell(Radius(r)), 1e-8, measure=False)
    alike(
        HollowCylinder(Radius(r), Thickness(thin * r), length), CylindricalShell(Radius(r), length), 1e-8, measure=False
    )
    alike(
        ClosedCylinder(Radius(r), thin * min(r, length), length),
        CylindricalShell(Radius(r), length, Ends("both")),
        1e-7,
        measure=False,
    )
    alike(
        HollowTorus(RingRadius(6.0), Radius(r), thin * r), TorusShell(RingRadius(6.0), Radius(r)), 1e-8, measure=False
    )
    assert HollowSphere(Radius(r), Thickness(thin * r)).unit().measure == pytest.approx(
        SphericalShell(Radius(r)).unit().measure * thin * r, rel=1e-8
    )


@given(SIZE, SIZE, SIZE)
def test_limits_of_cones_prisms_and_capsules(r: float, top: float, h: float) -> None:
    alike(Frustum(Radii(r, 0.0), h), Cone(Radius(r), h))
    assert numbers(Frustum(Radii(r, r), h))[3:] == pytest.approx(numbers(Cylinder(Radius(r), h))[3:], rel=1e-14)
    alike(FrustumShell(Radii(r, 0.0), h), ConicalShell(Radius(r), h))
    alike(Capsule(Radius(r), 0.0), Sphere(Radius(r)))
    square = RegularPrism(4, Radius(r), h)
    side = r * math.sqrt(2.0)
    assert square.unit().measure == pytest.approx(Block(side, side, h).unit().measure, rel=1e-14)
    assert numbers(square) == pytest.approx(numbers(Block(side, side, h)), rel=1e-13)
    upside = Frustum(Radii(top, r), h).unit().centroid[2]
    assert Frustum(Radii(r, top), h).unit().centroid[2] == pytest.approx(h - upside, rel=1e-13)


@given(SIZE)
def test_arcs_and_sectors_at_their_named_angles(r: float) -> None:
    alike(Sector(Radius(r), math.pi), HalfDisk(Radius(r)), 1e-15)
    alike(Sector(Radius(r), 2.0 * math.pi), Disk(Radius(r)), 1e-15)
    alike(ArcRod(Radius(r), math.pi), SemicircleRod(Radius(r)), 1e-15)
    quarter = Sector(Radius(r), 0.5 * math.pi).unit().lump(1.0)
    turned = shape(QuarterDisk(Radius(r)), amount=ONE, turn=AxisAngle((0.0, 0.0, 1.0), 0.25 * math.pi))
    assert turned.second_moments[0][0] == pytest.approx(quarter.second[0][0], rel=1e-13)
    assert turned.second_moments[1][1] == pytest.approx(quarter.second[1][1], rel=1e-13)


@pytest.mark.parametrize("switch", [1.5, 3.0, 1.6 * 2.0])
@pytest.mark.parametrize("cls", [ArcRod, Sector])
def test_series_and_closed_forms_meet_at_their_switch(cls: type, switch: float) -> None:
    below, above = cls(Radius(1.0), math.nextafter(switch, 0.0)), cls(Radius(1.0), math.nextafter(switch, 9.0))
    assert numbers(below) == pytest.approx(numbers(above), rel=2e-14)


@pytest.mark.parametrize("cls", [c for members in (RODS, PLATES) for c in members.__args__])
def test_a_lamina_has_no_second_moment_across_it(cls: type) -> None:
    sizes: dict[str, Any] = {
        "size": Radius(0.7), "wall": Thickness(0.1), "vertices": (Vertex(0.0, 0.0), Vertex(1.0, 0.0), Vertex(0.3, 0.8)),
    }  # fmt: skip
    found = shape(cls(**{name: sizes.get(name, 0.7) for name in cls.fields}), amount=ONE)  # type: ignore[attr-defined]
    assert found.second_moments[2][2] == 0.0
    assert found.moments.zz == found.moments.xx + found.moments.yy
    assert found.principal_moments.first >= 0.0


@given(SIZE, SIZE, st.floats(-3.0, 3.0))
def test_a_triangle_is_a_polygon_is_a_wedge(base: float, height: float, offset: float) -> None:
    corners = (Vertex(0.0, 0.0), Vertex(base, 0.0), Vertex(offset, height))
    alike(Polygon(corners), Triangle(base, height, offset), 1e-12)
    alike(Polygon(corners[::-1]), Triangle(base, height, offset), 1e-12)
    alike(Prism((Vertex(0.0, 0.0), Vertex(base, 0.0), Vertex(0.0, height)), 2.0), Wedge(base, height, 2.0), 1e-12)


@given(SIZE, SIZE, st.floats(1e-3, 1e3))
def test_second_moments_grow_with_the_square_of_the_size(r: float, length: float, k: float) -> None:
    one, other = Cylinder(Radius(r), length).unit(), Cylinder(Radius(k * r), k * length).unit()
    assert other.measure == pytest.approx(one.measure * k**3, rel=1e-13)
    assert other.second[2][2] == pytest.approx(one.second[2][2] * k * k, rel=1e-13)


@pytest.mark.parametrize("cls", Shape.__args__)  # type: ignore[attr-defined]
def test_no_shape_has_a_moment_no_body_has(cls: type) -> None:
    sizes: dict[str, Any] = {
        "thickness": 0.05, "sides": 7, "ends": Ends("one"), "base": 0.9,
        "size": Radius(0.6), "taper": Radii(0.6, 0.6), "ring": RingRadius(3.0), "wall": Thickness(0.05),
        "vertices": (Vertex(0.0, 0.0), Vertex(1.0, 0.1), Vertex(0.4, 0.9)),
        "first": (0.0, 0.0, 0.0), "second": (1.0, 0.0, 0.1), "third": (0.0, 1.0, 0.2), "fourth": (0.3, 0.3, 1.0),
    }  # fmt: skip
    made = {name: sizes.get(name, 0.6) for name in cls.fields}  # type: ignore[attr-defined]
    found = shape(cls(**made), amount=ONE)
    p = found.principal_moments
    assert 0.0 <= p.first <= p.second <= p.third <= (p.first + p.second) * (1.0 + 1e-15)
    assert found.mass == 1.0


def test_about_any_point_the_parallel_axes_hold() -> None:
    for own in (Cone(Radius(0.4), 1.1), Triangle(1.0, 0.7, 0.2), HollowSphere(Radius(0.5), Thickness(0.1))):
        centre = shape(own, amount=OfMass(3.0))
        there = shape(own, amount=OfMass(3.0), about_point=(0.3, -0.4, 0.9))
        d = [a - b for a, b in zip(centre.centroid, (0.3, -0.4, 0.9), strict=True)]
        square = sum(x * x for x in d)
        for i in range(3):
            for j in range(3):
                want = centre.tensor[i][j] + 3.0 * ((square if i == j else 0.0) - d[i] * d[j])
                assert there.tensor[i][j] == pytest.approx(want, rel=1e-14, abs=1e-15)


def test_product_sign_turns_products_and_leaves_the_tensor() -> None:
    minus = shape(Wedge(0.3, 0.4, 0.5), amount=ONE)
    plus = shape(Wedge(0.3, 0.4, 0.5), amount=ONE, product_sign=ProductSign("positive"))
    assert plus.products.xy == -minus.products.xy == -0.3 * 0.4 / 36.0
    assert plus.tensor == minus.tensor
    assert "-∫" in minus.product_sign
    assert "+∫" in plus.product_sign


def test_principal_axes_leave_no_products() -> None:
    found = shape(QuarterDisk(Radius(0.3)), amount=ONE, axes=Axes("principal"))
    assert abs(found.products.xy) <= 1e-17
    assert [found.moments.xx, found.moments.yy, found.moments.zz] == pytest.approx(
        [found.principal_moments.first, found.principal_moments.second, found.principal_moments.third], rel=1e-14
    )


def test_a_shaft_in_the_units_of_the_trade() -> None:
    found = shape(Disk(Radius(0.2)), amount=OfMass(30.0), shaft=Shaft(direction=(0.0, 0.0, 5.0)))
    assert found.shaft is not None
    assert found.shaft.moment == pytest.approx(0.6, rel=1e-15)
    assert found.shaft.wr2.value == pytest.approx(0.6 / 0.45359237 / 0.3048**2, rel=1e-15)
    assert found.shaft.gd2.value == pytest.approx(2.4, rel=1e-15)
    assert found.shaft.inertia_lbf_in_s2.value == pytest.approx(0.6 / 0.1129848290276167, rel=1e-14)
    off = shape(Disk(Radius(0.2)), amount=OfMass(30.0), shaft=Shaft(direction=(1.0, 1.0, 1.0), point=(0.1, 0.0, 0.0)))
    assert off.shaft is not None
    assert off.shaft.eccentricity == pytest.approx(0.1 * math.sqrt(2.0 / 3.0), rel=1e-15)
    diagonal = (0.3 + 0.3 + 0.6) / 3.0
    assert off.shaft.moment == pytest.approx(diagonal + 30.0 * 0.01 * 2.0 / 3.0, rel=1e-14)


def test_a_rod_does_not_resist_turning_about_itself() -> None:
    found = shape(Rod(2.0), amount=ONE, shaft=Shaft(direction=(1.0, 0.0, 0.0)))
    assert found.shaft is not None
    assert found.shaft.moment == 0.0
    assert found.ellipsoid_axes == (1.0, 0.0, 0.0)
    assert found.degeneracy.startswith("axes 2 and 3")


def test_the_box_and_the_ellipsoid_of_a_block_and_an_ellipsoid() -> None:
    found = shape(Block(0.3, 0.9, 0.5), amount=OfMass(7.0))
    assert found.equivalent_box == pytest.approx((0.9, 0.5, 0.3), rel=1e-14)
    ball = shape(Sphere(Radius(0.4)), amount=OfMass(7.0))
    assert ball.equivalent_ellipsoid == pytest.approx((0.4, 0.4, 0.4), rel=1e-14)


@pytest.mark.parametrize(
    ("own", "amount", "mass"),
    [
        (Rod(2.0), OfLinearDensity(3.0), 6.0),
        (Rectangle(2.0, 0.5), OfArealDensity(3.0), 3.0),
        (Block(1.0, 2.0, 3.0), OfDensity(10.0), 60.0),
        (Block(1.0, 2.0, 3.0), OfMaterial("Steel"), 47100.0),
    ],
)
def test_mass_by_density(own: Any, amount: Any, mass: float) -> None:
    assert shape(own, amount=amount).mass == pytest.approx(mass, rel=1e-15)


@pytest.mark.parametrize(
    ("own", "amount", "message"),
    [
        (Disk(Radius(1.0)), OfDensity(1000.0), "an area and no volume, but the density given is per volume"),
        (Rod(1.0), OfMaterial("steel"), "a length and no area"),
        (Sphere(Radius(1.0)), OfArealDensity(2.0), "a volume"),
        (Sphere(Radius(1.0)), OfMaterial("unobtainium"), "no material 'unobtainium'"),
        (Sphere(Radius(1.0)), OfMass(0.0), "mass of the sphere is zero"),
        (Sphere(Radius(0.0)), OfDensity(1000.0), "mass of the sphere is zero"),
        (HollowSphere(Radius(1.0), Thickness(1.5)), ONE, "wall of 1.5 m does not fit in a radius of 1 m"),
        (HollowBlock(1.0, 1.0, 0.1, 0.06), ONE, "two walls of 0.06 m do not fit in 0.1 m"),
        (HollowSphere(Radius(0.0), Thickness(0.0)), ONE, "outer radius is zero"),
        (Torus(RingRadius(0.1), Radius(0.2)), ONE, "overlaps itself"),
        (Frustum(Radii(0.0, 0.0), 1.0), ONE, "needs a base or a top"),
        (ArcRod(Radius(1.0), 7.0), ONE, "more than a full turn"),
        (Sector(Radius(1.0), 0.0), ONE, "an arc needs an angle"),
        (Sector(Radius(1.0), -1.0), ONE, "an arc needs an angle"),
        (RegularPrism(2, Radius(1.0), 1.0), ONE, "at least 3 sides; read 2"),
        (Polygon((Vertex(0.0, 0.0), Vertex(1.0, 0.0))), ONE, "at least 3 corners; read 2"),
        (Polygon((Vertex(0.0, 0.0), Vertex(1.0, 1.0), Vertex(1.0, 0.0), Vertex(0.0, 1.0))), ONE, "sides 1 and 3"),
        (Polygon((Vertex(0.0, 0.0), Vertex(1.0, 1.0), Vertex(2.0, 2.0))), ONE, "has no area"),
    ],
)
def test_refusals_give_the_deciding_number(own: Any, amount: Any, message: str) -> None:
    with pytest.raises(InadmissibleError, match=message):
        shape(own, amount=amount)


@pytest.mark.parametrize(
    ("words", "status"),
    [
        (["sphere", "--radius", "-1 m", "--mass", "1 kg"], 2),
        (["sphere", "--radius", "1 m", "--mass", "-1 kg"], 2),
        (["sphere", "--radius", "1 kg", "--mass", "1 kg"], 2),
        (["sphere", "--radius", "1 m"], 2),
        (["sphere", "--radius", "1 m", "--mass", "1 kg", "--density", "1 kg/m^3"], 2),
        (["spere", "--radius", "1 m", "--mass", "1 kg"], 2),
        (["sphere", "--radius", "inf m", "--mass", "1 kg"], 2),
        (["sphere", "--radius", "1e200 m", "--mass", "1 kg"], 3),
        (["sphere", "--radius", "1 m", "--mass", "1 kg", "--about", "hub"], 3),
        (["sphere", "--radius", "1 m", "--mass", "1 kg", "--about", "origin", "--about-point", "1,2,3 m"], 3),
        (["sphere", "--radius", "1 m", "--mass", "1 kg", "--shaft-direction", "0,0,0"], 3),
        (["block", "--width", "1 m", "--depth", "1 m", "--height", "1 m", "--mass", "1 kg", "--rotation-matrix",
          "(1,0,0),(0,1,0),(0,0,2)"], 3),
        (["disk", "--radius", "1 m", "--length", "1 m", "--mass", "1 kg"], 2),
    ],
)  # fmt: skip
def test_hostile_calls_are_refused_in_order(words: list[str], status: int) -> None:
    outcome = run("inertia", "shape", *words, "--json")
    assert outcome.status == status, outcome.err
    assert outcome.error["message"]
    assert outcome.out == ""


def test_uncertain_mass_reaches_the_moments() -> None:
    found = answer("inertia", "shape", "disk", "--radius", "0.2 m", "--mass", "30 ± 0.3 kg")
    assert found["results"]["moments"]["zz"]["std"] == pytest.approx(0.006, rel=1e-6)
    assert found["results"]["principal_moments"]["third"]["std"] == pytest.approx(0.006, rel=1e-6)


def test_the_list_names_every_shape_and_its_sizes() -> None:
    rows = listed().shapes
    assert {row.shape for row in rows} == {cls.tag[1] for cls in Shape.__args__}  # type: ignore[attr-defined]
    assert {row.kind for row in listed(kind="hollow").shapes} == {"hollow"}
    assert listed(kind="torus").shapes[0].sizes == "ring-radius, radius"
    with pytest.raises(InadmissibleError):
        listed(kind="teapot")


def test_materials_lie_within_their_ranges() -> None:
    for name, (density, least, greatest, source) in TABLE.items():
        assert least <= density <= greatest, name
        assert source, name
    assert density_of("Carbon Steel") == 7850.0
    assert materials(name="aluminum").materials[0].name == "aluminium"
    with pytest.raises(InadmissibleError) as refused:
        density_of("stainles")
    assert "stainless-304" in (refused.value.hint or "")


def test_a_rod_has_an_end_and_shapes_further_names() -> None:
    at_end = answer("inertia", "shape", "rod", "--length", "2 m", "--mass", "3 kg", "--about", "end")
    assert at_end["results"]["moments"]["zz"]["value"] == pytest.approx(4.0)
    sizes = ("--radius", "30 mm", "--thickness", "5 mm", "--length", "1 m", "--mass", "1 kg")
    tube, hollow = (answer("inertia", "shape", name, *sizes)["results"] for name in ("tube", "hollow-cylinder"))
    assert tube == hollow
    assert [row["shape"] for row in answer("inertia", "shapes", "--kind", "pipe")["results"]["shapes"]] == [
        "hollow-cylinder"
    ]


DIAMETERS = [
    (Disk(Radius(0.7)), Disk(Diameter(1.4))),
    (Frustum(Radii(0.3, 0.1), 0.4), Frustum(Diameters(0.6, 0.2), 0.4)),
    (Torus(RingRadius(0.9), Radius(0.04)), Torus(RingDiameter(1.8), Diameter(0.08))),
    (Annulus(Radius(0.5), Thickness(0.25)), Annulus(Diameter(1.0), InnerDiameter(0.5))),
    (HollowCylinder(Radius(0.5), Thickness(0.25), 2.0), HollowCylinder(Radius(0.5), InnerRadius(0.25), 2.0)),
]


@pytest.mark.parametrize(("by_radius", "by_diameter"), DIAMETERS)
def test_a_diameter_is_twice_a_radius_exactly(by_radius: Any, by_diameter: Any) -> None:
    assert numbers(by_radius) == numbers(by_diameter)
    assert by_radius.unit().measure == by_diameter.unit().measure


def test_a_hexagon_may_be_given_across_its_flats() -> None:
    # the area of a hexagon of width s across flats is (√3/2)·s²
    assert RegularPrism(6, AcrossFlats(0.3), 1.0).unit().measure == pytest.approx(
        0.09 * math.sqrt(3.0) / 2.0, rel=1e-15
    )
    with pytest.raises(InadmissibleError, match="no opposite flats"):
        RegularPrism(5, AcrossFlats(0.3), 1.0).unit()


def test_sizes_as_drawings_give_them() -> None:
    sizes = ("--diameter", "50 mm", "--inner-diameter", "40 mm", "--length", "1 m")
    results = answer("inertia", "shape", "tube", *sizes, "--density", "7850 kg/m^3")["results"]
    assert results["mass"]["value"] == pytest.approx(7850.0 * math.pi / 4.0 * (0.05**2 - 0.04**2), rel=1e-14)
    outcome = run("inertia", "shape", "tube", *sizes, "--mass", "1 kg", "--radius", "2 mm")
    assert "--diameter and --radius cannot be given together" in outcome.err
    outcome = run("inertia", "shape", "tube", "--diameter", "30 mm", *sizes[2:], "--mass", "1 kg")
    assert "the inner diameter of 40 mm exceeds the outer one of 30 mm" in outcome.err


@pytest.mark.parametrize(
    ("call", "hint"),
    [
        ("disk|--thickness|2 mm", "a disk with a thickness is a cylinder"),
        ("rod|--diameter|2 mm", "a rod with a diameter is a cylinder"),
        ("cyl|--diameter|2 mm", "did you mean cylindrical-shell or cylinder?"),
    ],
)
def test_a_size_that_makes_it_another_shape(call: str, hint: str) -> None:
    outcome = run("inertia", "shape", *call.split("|"), "--mass", "1 kg")
    assert outcome.status == 2
    assert hint in outcome.err


def test_the_mass_centre_by_other_names() -> None:
    call = ("inertia", "shape", "shaft", "--diameter", "40 mm", "--length", "1 m", "--mass", "2 kg", "--about")
    assert run(*call, "centre of mass", "-q").out == run(*call, "centroid", "-q").out


@pytest.mark.parametrize(
    ("words", "formula", "with_numbers"),
    [
        ("cylinder --mass 2kg --radius 3cm --length 10cm", "Izz = m·R²/2, Ixx = Iyy = m·(3R² + L²)/12",
         "Izz = (2 kg)·(3 cm)²/2, Ixx = Iyy = (2 kg)·(3(3 cm)² + (10 cm)²)/12"),
        ("disc --mass 2kg --diameter 6cm", "Ixx = Iyy = m·R²/4, Izz = m·R²/2", None),
    ],
)  # fmt: skip
def test_the_formula_explained_is_that_of_the_shape(words: str, formula: str, with_numbers: str | None) -> None:
    explanation = harness.answer("inertia", "shape", *words.split(), "--explain")["explanation"]
    assert (explanation["formula"], explanation.get("with_numbers")) == (formula, with_numbers)
