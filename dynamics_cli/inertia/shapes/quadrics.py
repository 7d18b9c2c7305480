"""Solids bounded by ellipsoids, elliptic cylinders and paraboloids. The measure is the volume."""

from dynamics_cli.inertia.shapes.sizes import Round, RoundBody
from dynamics_cli.inertia.shapes.unit import CENTRE, FOUR_THIRDS, PI, TWO_THIRDS, Unit
from dynamics_cli.quantities import Annotated, Size
from dynamics_cli.records import record, tagged


@tagged("shape")
@record
class EllipticCylinder:
    """A solid elliptic cylinder along z, its middle at the origin."""

    x_radius: Annotated[Size, "Semi-axis along x [m]."]
    y_radius: Annotated[Size, "Semi-axis along y [m]."]
    length: Annotated[Size, "Length along z [m]."]

    dimension = 3
    formula = "Ixx = m·(3b² + L²)/12, Iyy = m·(3a² + L²)/12, Izz = m·(a² + b²)/4"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a, b = self.x_radius, self.y_radius
        return Unit(PI * a * b * self.length, CENTRE, 0.25 * a * a, 0.25 * b * b, self.length * self.length / 12.0)


@tagged("shape")
@record
class Paraboloid(RoundBody):
    """A solid paraboloid of revolution, its tip at the origin, its flat face at z = height."""

    size: Round
    height: Annotated[Size, "Height along z [m]."]

    dimension = 3
    formula = "z̄ = 2h/3, Izz = m·R²/3, Ixx = Iyy = m·(3R² + h²)/18"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        ixx = self.radius * self.radius / 6.0
        return Unit(
            0.5 * PI * self.radius * self.radius * self.height,
            (0.0, 0.0, 2.0 * self.height / 3.0),
            ixx,
            ixx,
            self.height * self.height / 18.0,
        )


@tagged("shape")
@record
class Ellipsoid:
    """A solid ellipsoid about the origin."""

    x_radius: Annotated[Size, "Semi-axis along x [m]."]
    y_radius: Annotated[Size, "Semi-axis along y [m]."]
    z_radius: Annotated[Size, "Semi-axis along z [m]."]

    dimension = 3
    formula = "Ixx = m·(b² + c²)/5, Iyy = m·(c² + a²)/5, Izz = m·(a² + b²)/5"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a, b, c = self.x_radius, self.y_radius, self.z_radius
        return Unit(FOUR_THIRDS * PI * a * b * c, CENTRE, a * a / 5.0, b * b / 5.0, c * c / 5.0)


@tagged("shape")
@record
class HalfEllipsoid:
    """Half a solid ellipsoid, its flat face on the x-y plane about the origin, on the side of positive z."""

    x_radius: Annotated[Size, "Semi-axis along x [m]."]
    y_radius: Annotated[Size, "Semi-axis along y [m]."]
    z_radius: Annotated[Size, "Semi-axis along z [m]."]

    dimension = 3
    formula = "z̄ = 3c/8, Izz = m·(a² + b²)/5, Ixx = m·(b²/5 + 19c²/320)"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a, b, c = self.x_radius, self.y_radius, self.z_radius
        return Unit(TWO_THIRDS * PI * a * b * c, (0.0, 0.0, 0.375 * c), a * a / 5.0, b * b / 5.0, 19.0 * c * c / 320.0)
