"""Solids with flat faces. The measure is the volume."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.shapes.polygon import Vertex, polygon_unit
from dynamics_cli.inertia.shapes.sizes import Diameter, Radius
from dynamics_cli.inertia.shapes.unit import CENTRE, PI, Unit
from dynamics_cli.numerics.elementary import cos, sin
from dynamics_cli.numerics.vectors import add, subtract
from dynamics_cli.quantities import Annotated, Count, PartPosition, Size
from dynamics_cli.records import record, tagged


@tagged("shape")
@record
class Block:
    """A solid rectangular block about the origin."""

    width: Annotated[Size, "Side along x [m]."]
    depth: Annotated[Size, "Side along y [m]."]
    height: Annotated[Size, "Side along z [m]."]

    also = ("box", "cuboid", "plate")
    dimension = 3
    formula = "Ixx = m·(d² + h²)/12, Iyy = m·(h² + w²)/12, Izz = m·(w² + d²)/12"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a, b, c = self.width, self.depth, self.height
        return Unit(a * b * c, CENTRE, a * a / 12.0, b * b / 12.0, c * c / 12.0)


@tagged("shape")
@record
class Wedge:
    """A right triangular prism: legs from the origin along x and y, its length along z, its mid-plane at z = 0."""

    width: Annotated[Size, "Leg along x [m]."]
    height: Annotated[Size, "Leg along y [m]."]
    length: Annotated[Size, "Length along z [m]."]

    dimension = 3
    formula = "centroid (w/3, h/3): Ixx = m·(h²/18 + L²/12), Iyy = m·(w²/18 + L²/12), ∫xy dm = −m·w·h/36"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a, b, c = self.width, self.height, self.length
        return Unit(
            0.5 * a * b * c, (a / 3.0, b / 3.0, 0.0), a * a / 18.0, b * b / 18.0, c * c / 12.0, xy=-(a * b) / 36.0
        )


@tagged("shape")
@record
class Prism:
    """A straight prism along z on a polygon, its mid-plane at z = 0."""

    vertices: Annotated[tuple[Vertex, ...], "The corners of the polygon in the x-y plane, in either sense [m]."]
    height: Annotated[Size, "Height along z [m]."]

    dimension = 3
    formula = "that of the polygon, with Σz² = m·h²/12"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        return polygon_unit(self.vertices, self.height, solid=True)


@record
class AcrossFlats:
    """A regular polygon of an even number of sides by the distance of opposite ones."""

    across_flats: Annotated[Size, "Distance of opposite sides, in place of the radius, e.g. 17 mm."]


@tagged("shape")
@record
class RegularPrism:
    """A straight prism along z on a regular polygon with a corner on x, its middle at the origin."""

    sides: Annotated[Count, "Number of sides, at least 3, e.g. 6."]
    size: Annotated[Radius | Diameter | AcrossFlats, "The circle through the corners, or the width across flats."]
    height: Annotated[Size, "Height along z [m]."]

    dimension = 3
    formula = "Izz = m·R²·(2 + cos(2π/n))/6, Ixx = Iyy = Izz/2 + m·h²/12"

    @property
    def radius(self) -> float:
        """The radius of the circle through the corners."""
        if not isinstance(self.size, AcrossFlats):
            return self.size.radius
        require(
            self.sides % 2 == 0,
            "a polygon of {sides} sides has no opposite flats",
            code="polygon",
            hint="give its radius or diameter, through the corners",
            sides=self.sides,
        )
        across = self.size.across_flats
        return 0.5 * across / cos(PI.beside(across) / self.sides)

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        require(self.sides >= 3, "a polygon needs at least 3 sides; read {sides}", code="polygon", sides=self.sides)
        radius = self.radius
        step = 2.0 * PI.beside(radius) / self.sides
        square = radius * radius
        ixx = square * (2.0 + cos(step)) / 12.0
        return Unit(
            0.5 * self.sides * square * sin(step) * self.height, CENTRE, ixx, ixx, self.height * self.height / 12.0
        )


@tagged("shape")
@record
class Pyramid:
    """A solid pyramid on a rectangular base in the x-y plane about the origin, its apex at z = height."""

    width: Annotated[Size, "Side of the base along x [m]."]
    depth: Annotated[Size, "Side of the base along y [m]."]
    height: Annotated[Size, "Height along z [m]."]

    dimension = 3
    formula = "z̄ = h/4, Izz = m·(w² + d²)/20, Ixx = m·(d²/20 + 3h²/80)"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a, b, c = self.width, self.depth, self.height
        return Unit(a * b * c / 3.0, (0.0, 0.0, 0.25 * c), a * a / 20.0, b * b / 20.0, 3.0 * c * c / 80.0)


@tagged("shape")
@record
class Tetrahedron:
    """A solid tetrahedron by its corners."""

    first: Annotated[PartPosition, "A corner [m]."]
    second: Annotated[PartPosition, "A corner [m]."]
    third: Annotated[PartPosition, "A corner [m]."]
    fourth: Annotated[PartPosition, "A corner [m]."]

    dimension = 3
    formula = "∫rrᵀ dm about the centroid = m/80·Σ over the six edges e eᵀ"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        corners = (self.first, self.second, self.third, self.fourth)
        a, b, c = (subtract(corner, self.first) for corner in corners[1:])
        edges = (a, b, c, subtract(b, a), subtract(c, b), subtract(a, c))
        volume = (
            a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        ) / 6.0
        away = add(add(a, b), c)
        middle = add(self.first, (0.25 * away[0], 0.25 * away[1], 0.25 * away[2]))
        ixx = [
            [sum((e[i] * e[j] for e in edges[1:]), edges[0][i] * edges[0][j]) / 80.0 for j in range(3)]
            for i in range(3)
        ]
        return Unit(
            abs(volume),
            middle,
            ixx[0][0],
            ixx[1][1],
            ixx[2][2],
            xy=ixx[0][1],
            yz=ixx[1][2],
            zx=ixx[2][0],
        )
