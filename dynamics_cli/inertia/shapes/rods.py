"""Thin rods: the straight rod and the arcs of a circle. The measure is the length."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.shapes.sizes import Round, RoundBody
from dynamics_cli.inertia.shapes.unit import CENTRE, HALF_RING, PI, QUARTER_RING, TWO_OVER_PI, Unit
from dynamics_cli.numerics.arcs import cosine_variance, one_less_sinc
from dynamics_cli.quantities import Angle, Annotated, Size
from dynamics_cli.records import record, tagged


@tagged("shape")
@record
class Rod:
    """A thin straight rod along x, its middle at the origin."""

    length: Annotated[Size, "Length: of a rod along x, of cylinders and tubes along z [m]."]

    instead = dict.fromkeys(("diameter", "radius"), "a rod with a diameter is a cylinder, along z")
    dimension = 1
    formula = "Iyy = Izz = m·L²/12, Ixx = 0"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        return Unit(self.length, CENTRE, self.length * self.length / 12.0, 0.0, 0.0)


@tagged("shape")
@record
class RingRod(RoundBody):
    """A thin rod bent to a full circle in the x-y plane about the origin."""

    size: Round

    dimension = 1
    formula = "Izz = m·R², Ixx = Iyy = m·R²/2"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = 0.5 * self.radius * self.radius
        return Unit(2.0 * PI * self.radius, CENTRE, square, square, 0.0)


@tagged("shape")
@record
class ArcRod(RoundBody):
    """A thin rod bent to an arc in the x-y plane, its circle's centre at the origin, symmetric about x."""

    size: Round
    angle: Annotated[Angle, "Whole angle of an arc or a sector, up to a full turn [rad]."]

    dimension = 1
    formula = "α = angle/2: x̄ = R·sin α/α, Ixx = m·R²·(1 − sin 2α/2α)/2, Izz about O = m·R²"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        half = half_angle(self.angle)
        square = self.radius * self.radius
        return Unit(
            self.radius * self.angle,
            (self.radius * (1.0 - one_less_sinc(half)), 0.0, 0.0),
            square * cosine_variance(half),
            0.5 * square * one_less_sinc(2.0 * half),
            0.0,
        )


@tagged("shape")
@record
class SemicircleRod(RoundBody):
    """A thin rod bent to a half circle in the x-y plane, centred at the origin, on the side of positive x."""

    size: Round

    dimension = 1
    formula = "x̄ = 2R/π, Ixx = m·R²/2, Iyy = m·R²·(1/2 − 4/π²)"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = self.radius * self.radius
        return Unit(PI * self.radius, (TWO_OVER_PI * self.radius, 0.0, 0.0), HALF_RING * square, 0.5 * square, 0.0)


@tagged("shape")
@record
class QuarterCircleRod(RoundBody):
    """A thin rod bent to a quarter circle in the x-y plane from x to y, its circle's centre at the origin."""

    size: Round

    dimension = 1
    formula = "x̄ = ȳ = 2R/π, Ixx = Iyy = m·R²·(1/2 − 4/π²), ∫xy dm = m·R²·(1/π − 4/π²)"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = self.radius * self.radius
        middle = TWO_OVER_PI * self.radius
        return Unit(
            0.5 * PI * self.radius,
            (middle, middle, 0.0),
            HALF_RING * square,
            HALF_RING * square,
            0.0,
            xy=QUARTER_RING * square,
        )


def half_angle(angle: float) -> float:
    """Half the opening of an arc or a sector, which is at most a full turn."""
    require(
        angle > 0.0,
        "an arc needs an angle greater than zero; read {angle:6}",
        code="angle",
        hint="give the whole angle at the centre, for example 90 deg",
        angle=(angle, Angle),
    )
    require(
        angle <= 2.0 * PI,
        "an angle of {angle:6} is more than a full turn",
        code="angle",
        hint="at most 360 deg",
        angle=(angle, Angle),
    )
    return 0.5 * angle
