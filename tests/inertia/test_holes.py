"""What is cut out of an assembly has to be there, and mesh parts have to bound what they seem to."""

from pathlib import Path

import pytest
from references.inertia_solids import ball, write_stl

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.inertia.assembly.assembly import Assembly, body
from dynamics_cli.inertia.assembly.parts import Part
from dynamics_cli.inertia.bodies.amount import OfDensity, OfMass
from dynamics_cli.inertia.bodies.properties import MassProperties
from dynamics_cli.inertia.mesh.surface import LengthUnit
from dynamics_cli.inertia.shapes import Block, Cylinder, Sphere
from dynamics_cli.inertia.shapes.sizes import Radius
from dynamics_cli.numerics.orientation.rotations import AxisAngle


def body_of(*items: Part) -> MassProperties:
    return body(Assembly(parts=items))


class TestHoles:
    PLATE = Part(name="plate", shape=Block(1.0, 1.0, 0.1), amount=OfDensity(1000.0))

    @staticmethod
    def codes(*items: Part) -> list[str]:
        return [advice.code for advice in body_of(*items).advice]

    @pytest.mark.parametrize(
        ("length", "turn", "wanted"),
        [(0.1, None, []), (0.05, None, []), (0.11, None, ["hole-outside"]), (0.3, 1.0, ["hole-outside"]),
         (0.02, 1.0, [])],
    )  # fmt: skip
    def test_a_hole_ends_where_its_body_does(self, length: float, turn: float | None, wanted: list[str]) -> None:
        way = None if turn is None else AxisAngle((1.0, 0.0, 0.0), turn)
        hole = Part(shape=Cylinder(Radius(0.02), length), amount=OfDensity(1000.0), subtract=True, turn=way)
        assert self.codes(self.PLATE, hole) == wanted
        # the same within an assembly that is turned and away from the origin
        group = Part(parts=(self.PLATE, hole), position=(5.0, 6.0, 7.0), turn=AxisAngle((1.0, 2.0, 3.0), 0.7))
        assert self.codes(group) == wanted

    def test_a_hole_through_two_plates_is_within_them(self) -> None:
        upper = Part(shape=Block(1.0, 1.0, 0.1), amount=OfDensity(1000.0), position=(0.0, 0.0, 0.1))
        hole = Part(
            shape=Cylinder(Radius(0.02), 0.2), amount=OfDensity(1000.0), subtract=True, position=(0.0, 0.0, 0.05)
        )
        assert self.codes(self.PLATE, upper, hole) == []

    def test_a_hole_takes_away_the_material_of_a_body(self) -> None:
        hole = Part(shape=Cylinder(Radius(0.02), 0.1), amount=OfDensity(900.0), subtract=True)
        assert self.codes(self.PLATE, hole) == ["hole-density"]
        brass = Part(shape=Sphere(Radius(0.1)), amount=OfDensity(900.0), position=(3.0, 0.0, 0.0))
        assert self.codes(self.PLATE, brass, hole) == []
        measured = Part(amount=OfMass(3.0), tensor=((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))
        assert self.codes(measured, hole) == []

    def test_a_hole_without_a_density_has_that_of_the_body_before_or_around_it(self) -> None:
        hole = Part(name="hole", shape=Cylinder(Radius(0.02), 0.1), subtract=True)
        dense = Part(name="hole", shape=Cylinder(Radius(0.02), 0.1), subtract=True, amount=OfDensity(1000.0))
        assert body_of(self.PLATE, hole) == body_of(self.PLATE, dense)
        drilled = Part(name="plate", shape=self.PLATE.shape, amount=self.PLATE.amount, parts=(hole,))
        assert body_of(drilled).mass == body_of(self.PLATE, dense).mass
        with pytest.raises(InadmissibleError, match="neither mass nor density"):
            body_of(hole, self.PLATE)

    def test_a_mesh_part_given_twice_is_named(self, tmp_path: Path) -> None:
        path = tmp_path / "ball.stl"
        write_stl(path, ball(1) + ball(1), binary=True)
        part = Part(name="ball", mesh=str(path), length_unit=LengthUnit("m"), amount=OfDensity(1.0))
        (advice,) = body_of(part).advice
        assert (advice.code, advice.severity) == ("duplicated", "serious")
        assert advice.message.startswith("ball: ")
