"""Laminae in the x-y plane. The measure is the area; ∫z² dm is exactly zero."""

from dynamics_cli.inertia.shapes.polygon import Vertex, polygon_unit
from dynamics_cli.inertia.shapes.rods import half_angle
from dynamics_cli.inertia.shapes.sizes import Round, RoundBody, Wall
from dynamics_cli.inertia.shapes.unit import CENTRE, FOUR_THIRDS_OVER_PI, HALF_DISK, PI, QUARTER_DISK, Unit
from dynamics_cli.numerics.arcs import one_less_sinc
from dynamics_cli.quantities import Angle, Annotated, Coordinate, Size
from dynamics_cli.records import record, tagged


@tagged("shape")
@record
class Triangle:
    """A triangular lamina: its base on x from the origin, its apex at (offset, height)."""

    base: Annotated[Size, "Length of the base, along x [m]."]
    height: Annotated[Size, "Height: of laminae along y, of solids and shells along z [m]."]
    offset: Annotated[
        Coordinate,
        "Position of the apex along the base: 0 for a right angle at the origin, half the base for equal sides [m].",
    ] = 0.0

    instead = {"thickness": "a triangle with a thickness is a prism, or a wedge where it has a right angle"}  # noqa: RUF012
    dimension = 2
    formula = "centroid ((a + b)/3, h/3): Ixx = m·h²/18, Iyy = m·(b² − a·b + a²)/18, ∫xy dm = m·h·(2a − b)/36"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        rest = self.base - self.offset
        along = self.base * self.base + self.offset * self.offset + rest * rest
        return Unit(
            0.5 * self.base * self.height,
            ((self.base + self.offset) / 3.0, self.height / 3.0, 0.0),
            along / 36.0,
            self.height * self.height / 18.0,
            0.0,
            xy=self.height * (self.offset - rest) / 36.0,
        )


@tagged("shape")
@record
class Rectangle:
    """A rectangular lamina about the origin."""

    width: Annotated[Size, "Side along x [m]."]
    height: Annotated[Size, "Side along y [m]."]

    instead = {"thickness": "a rectangle with a thickness is a block: width, depth, height"}  # noqa: RUF012
    dimension = 2
    formula = "Ixx = m·h²/12, Iyy = m·w²/12, Izz = Ixx + Iyy"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        return Unit(
            self.width * self.height, CENTRE, self.width * self.width / 12.0, self.height * self.height / 12.0, 0.0
        )


@tagged("shape")
@record
class Polygon:
    """A lamina bounded by straight sides that do not cross, its corners in order."""

    vertices: Annotated[tuple[Vertex, ...], "The corners, three at least, in either sense."]

    instead = {"thickness": "a polygon with a thickness is a prism: give it as height"}  # noqa: RUF012
    dimension = 2
    formula = "sums over the sides: A = Σ xᵢ×xᵢ₊₁/2, and so on, from the centroid"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        return polygon_unit(self.vertices)


@tagged("shape")
@record
class Disk(RoundBody):
    """A circular lamina about the origin."""

    size: Round

    also = ("disc", "circle")
    instead = {"thickness": "a disk with a thickness is a cylinder: give it as --length"}  # noqa: RUF012
    dimension = 2
    formula = "Ixx = Iyy = m·R²/4, Izz = m·R²/2"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = self.radius * self.radius
        return Unit(PI * square, CENTRE, 0.25 * square, 0.25 * square, 0.0)


@tagged("shape")
@record
class HalfDisk(RoundBody):
    """Half a circular lamina, its straight edge on y through the origin, on the side of positive x."""

    size: Round

    dimension = 2
    formula = "x̄ = 4R/(3π), Ixx = m·R²/4, Iyy = m·R²·(1/4 − 16/(9π²))"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = self.radius * self.radius
        middle = FOUR_THIRDS_OVER_PI * self.radius
        return Unit(0.5 * PI * square, (middle, 0.0, 0.0), HALF_DISK * square, 0.25 * square, 0.0)


@tagged("shape")
@record
class QuarterDisk(RoundBody):
    """A quarter of a circular lamina between x and y, its corner at the origin."""

    size: Round

    dimension = 2
    formula = "x̄ = ȳ = 4R/(3π), Ixx = Iyy = m·R²·(1/4 − 16/(9π²)), ∫xy dm = m·R²·(1/(2π) − 16/(9π²))"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = self.radius * self.radius
        middle = FOUR_THIRDS_OVER_PI * self.radius
        ixx = HALF_DISK * square
        return Unit(0.25 * PI * square, (middle, middle, 0.0), ixx, ixx, 0.0, xy=QUARTER_DISK * square)


@tagged("shape")
@record
class Sector(RoundBody):
    """A sector of a circular lamina, its tip at the origin, symmetric about x."""

    size: Round
    angle: Annotated[Angle, "Whole angle at the tip, up to a full turn [rad]."]

    dimension = 2
    formula = "α = angle/2: x̄ = 2R·sin α/(3α), Ixx = m·R²·(1 − sin 2α/2α)/4, Izz about O = m·R²/2"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        half = half_angle(self.angle)
        square = self.radius * self.radius
        short, double = one_less_sinc(half), one_less_sinc(2.0 * half)
        along = (1.0 - 4.5 * double + 8.0 * short * (2.0 - short)) / 18.0
        return Unit(
            0.5 * self.angle * square,
            (2.0 * self.radius * (1.0 - short) / 3.0, 0.0, 0.0),
            square * along,
            0.25 * square * double,
            0.0,
        )


@tagged("shape")
@record
class Ellipse:
    """An elliptic lamina about the origin."""

    x_radius: Annotated[Size, "Semi-axis along x [m]."]
    y_radius: Annotated[Size, "Semi-axis along y [m]."]

    instead = {"thickness": "an ellipse with a thickness is an elliptic-cylinder: give it as length"}  # noqa: RUF012
    dimension = 2
    formula = "Ixx = m·b²/4, Iyy = m·a²/4, Izz = Ixx + Iyy"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a, b = self.x_radius, self.y_radius
        return Unit(PI * a * b, CENTRE, 0.25 * a * a, 0.25 * b * b, 0.0)


@tagged("shape")
@record
class Annulus(RoundBody):
    """A circular lamina with a concentric hole, about the origin."""

    size: Round
    wall: Wall

    dimension = 2
    formula = "r = R − t: Izz = m·(R² + r²)/2, Ixx = Iyy = Izz/2, A = π·t·(R + r)"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        inner, thickness = self.wall.inside(self.radius)
        ixx = 0.25 * (self.radius * self.radius + inner * inner)
        return Unit(PI * thickness * (self.radius + inner), CENTRE, ixx, ixx, 0.0)
