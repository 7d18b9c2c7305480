"""Laminae in the x-y plane. The measure is the area; ∫z² dm is exactly zero."""

from dynamics_cli.inertia.shapes.polygon import Vertex, polygon_unit
from dynamics_cli.inertia.shapes.rods import half_angle
from dynamics_cli.inertia.shapes.sizes import inner_radius
from dynamics_cli.inertia.shapes.unit import CENTRE, FOUR_THIRDS_OVER_PI, HALF_DISK, PI, QUARTER_DISK, Unit
from dynamics_cli.numerics.arcs import one_less_sinc
from dynamics_cli.quantities import Angle, Coordinate, Size
from dynamics_cli.records import record, tagged


@tagged("shape")
@record
class Triangle:
    """A triangular lamina: its base on x from the origin, its apex at (offset, height).

    Parameters
    ----------
    base : Size
        Length of the base, along x [m].
    height : Size
        Height: of laminae along y, of solids and shells along z [m].
    offset : Coordinate
        Position of the apex along the base: 0 for a right angle at the origin, half the base for equal sides [m].
    """

    base: Size
    height: Size
    offset: Coordinate = 0.0

    dimension = 2
    formula = "centroid ((a + b)/3, h/3): Ixx = m·h²/18, Iyy = m·(b² − a·b + a²)/18, ∫xy dm = m·h·(2a − b)/36"

    def unit(self) -> Unit:
        """Of mass one."""
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
    """A rectangular lamina about the origin.

    Parameters
    ----------
    width : Size
        Side along x [m].
    height : Size
        Side along y [m].
    """

    width: Size
    height: Size

    dimension = 2
    formula = "Ixx = m·h²/12, Iyy = m·w²/12, Izz = Ixx + Iyy"

    def unit(self) -> Unit:
        """Of mass one."""
        return Unit(
            self.width * self.height, CENTRE, self.width * self.width / 12.0, self.height * self.height / 12.0, 0.0
        )


@tagged("shape")
@record
class Polygon:
    """A lamina bounded by straight sides that do not cross, its corners in order.

    Parameters
    ----------
    vertices : tuple of Vertex
        The corners, three at least, in either sense.
    """

    vertices: tuple[Vertex, ...]

    dimension = 2
    formula = "sums over the sides: A = Σ xᵢ×xᵢ₊₁/2, and so on, from the centroid"

    def unit(self) -> Unit:
        """Of mass one."""
        return polygon_unit(self.vertices)


@tagged("shape")
@record
class Disk:
    """A circular lamina about the origin.

    Parameters
    ----------
    radius : Size
        Radius [m].
    """

    radius: Size

    dimension = 2
    formula = "Ixx = Iyy = m·R²/4, Izz = m·R²/2"

    def unit(self) -> Unit:
        """Of mass one."""
        square = self.radius * self.radius
        return Unit(PI * square, CENTRE, 0.25 * square, 0.25 * square, 0.0)


@tagged("shape")
@record
class HalfDisk:
    """Half a circular lamina, its straight edge on y through the origin, on the side of positive x.

    Parameters
    ----------
    radius : Size
        Radius [m].
    """

    radius: Size

    dimension = 2
    formula = "x̄ = 4R/(3π), Ixx = m·R²/4, Iyy = m·R²·(1/4 − 16/(9π²))"

    def unit(self) -> Unit:
        """Of mass one."""
        square = self.radius * self.radius
        middle = FOUR_THIRDS_OVER_PI * self.radius
        return Unit(0.5 * PI * square, (middle, 0.0, 0.0), HALF_DISK * square, 0.25 * square, 0.0)


@tagged("shape")
@record
class QuarterDisk:
    """A quarter of a circular lamina between x and y, its corner at the origin.

    Parameters
    ----------
    radius : Size
        Radius [m].
    """

    radius: Size

    dimension = 2
    formula = "x̄ = ȳ = 4R/(3π), Ixx = Iyy = m·R²·(1/4 − 16/(9π²)), ∫xy dm = m·R²·(1/(2π) − 16/(9π²))"

    def unit(self) -> Unit:
        """Of mass one."""
        square = self.radius * self.radius
        middle = FOUR_THIRDS_OVER_PI * self.radius
        own = HALF_DISK * square
        return Unit(0.25 * PI * square, (middle, middle, 0.0), own, own, 0.0, xy=QUARTER_DISK * square)


@tagged("shape")
@record
class Sector:
    """A sector of a circular lamina, its tip at the origin, symmetric about x.

    Parameters
    ----------
    radius : Size
        Radius [m].
    angle : Angle
        Whole angle at the tip, up to a full turn [rad].
    """

    radius: Size
    angle: Angle

    dimension = 2
    formula = "α = angle/2: x̄ = 2R·sin α/(3α), Ixx = m·R²·(1 − sin 2α/2α)/4, Izz about O = m·R²/2"

    def unit(self) -> Unit:
        """Of mass one."""
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
    """An elliptic lamina about the origin.

    Parameters
    ----------
    x_radius : Size
        Semi-axis along x [m].
    y_radius : Size
        Semi-axis along y [m].
    """

    x_radius: Size
    y_radius: Size

    dimension = 2
    formula = "Ixx = m·b²/4, Iyy = m·a²/4, Izz = Ixx + Iyy"

    def unit(self) -> Unit:
        """Of mass one."""
        a, b = self.x_radius, self.y_radius
        return Unit(PI * a * b, CENTRE, 0.25 * a * a, 0.25 * b * b, 0.0)


@tagged("shape")
@record
class Annulus:
    """A circular lamina with a concentric hole, about the origin.

    Parameters
    ----------
    radius : Size
        Outer radius [m].
    thickness : Size
        Width of the ring, outer less inner radius [m].
    """

    radius: Size
    thickness: Size

    dimension = 2
    formula = "r = R − t: Izz = m·(R² + r²)/2, Ixx = Iyy = Izz/2, A = π·t·(R + r)"

    def unit(self) -> Unit:
        """Of mass one."""
        inner = inner_radius(self.radius, self.thickness)
        own = 0.25 * (self.radius * self.radius + inner * inner)
        return Unit(PI * self.thickness * (self.radius + inner), CENTRE, own, own, 0.0)
