"""Solids of revolution and their parts. The measure is the volume."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.shapes.sizes import ConicalBody, Ring, RingBody, Round, RoundBody, Taper, require_ring
from dynamics_cli.inertia.shapes.unit import (
    CENTRE,
    FIFTH,
    FOUR_THIRDS,
    FOUR_THIRDS_OVER_PI,
    HALF_DISK,
    PI,
    QUARTER_DISK,
    TWO_THIRDS,
    Unit,
)
from dynamics_cli.quantities import Annotated, Size
from dynamics_cli.records import record, tagged


@tagged("shape")
@record
class Sphere(RoundBody):
    """A solid sphere about the origin."""

    size: Round

    also = ("ball",)
    dimension = 3
    formula = "Ixx = Iyy = Izz = (2/5)·m·R²"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = self.radius * self.radius
        ixx = square / 5.0
        return Unit(FOUR_THIRDS * PI * square * self.radius, CENTRE, ixx, ixx, ixx)


@tagged("shape")
@record
class Hemisphere(RoundBody):
    """A solid hemisphere, its flat face on the x-y plane about the origin, on the side of positive z."""

    size: Round

    dimension = 3
    formula = "z̄ = 3R/8, Ixx = Iyy = (83/320)·m·R², Izz = (2/5)·m·R²"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = self.radius * self.radius
        ixx = square / 5.0
        return Unit(
            TWO_THIRDS * PI * square * self.radius, (0.0, 0.0, 0.375 * self.radius), ixx, ixx, 19.0 * square / 320.0
        )


@tagged("shape")
@record
class Cylinder(RoundBody):
    """A solid circular cylinder along z, its middle at the origin."""

    size: Round
    length: Annotated[Size, "Length along z [m]."]

    also = ("shaft", "round-bar", "solid-cylinder")
    dimension = 3
    formula = "Izz = m·R²/2, Ixx = Iyy = m·(3R² + L²)/12"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = self.radius * self.radius
        return Unit(PI * square * self.length, CENTRE, 0.25 * square, 0.25 * square, self.length * self.length / 12.0)


@tagged("shape")
@record
class HalfCylinder(RoundBody):
    """Half a solid cylinder along z, its flat face on the y-z plane, at positive x, its mid-plane at z = 0."""

    size: Round
    length: Annotated[Size, "Length along z [m]."]

    dimension = 3
    formula = "x̄ = 4R/(3π), Izz = m·R²·(1/2 − 16/(9π²)), Ixx = m·(3R² + L²)/12"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = self.radius * self.radius
        return Unit(
            0.5 * PI * square * self.length,
            (FOUR_THIRDS_OVER_PI * self.radius, 0.0, 0.0),
            HALF_DISK * square,
            0.25 * square,
            self.length * self.length / 12.0,
        )


@tagged("shape")
@record
class QuarterCylinder(RoundBody):
    """A quarter of a solid cylinder along z between the x-z and y-z planes, its edge on z, its mid-plane at z = 0."""

    size: Round
    length: Annotated[Size, "Length along z [m]."]

    dimension = 3
    formula = "x̄ = ȳ = 4R/(3π), Izz = m·R²·(1/2 − 32/(9π²)), ∫xy dm = m·R²·(1/(2π) − 16/(9π²))"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = self.radius * self.radius
        middle = FOUR_THIRDS_OVER_PI * self.radius
        ixx = HALF_DISK * square
        return Unit(
            0.25 * PI * square * self.length,
            (middle, middle, 0.0),
            ixx,
            ixx,
            self.length * self.length / 12.0,
            xy=QUARTER_DISK * square,
        )


@tagged("shape")
@record
class Cone(RoundBody):
    """A solid circular cone, its base on the x-y plane about the origin, its apex at z = height."""

    size: Round
    height: Annotated[Size, "Height along z [m]."]

    dimension = 3
    formula = "z̄ = h/4, Izz = (3/10)·m·R², Ixx = Iyy = (3/80)·m·(4R² + h²)"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = self.radius * self.radius
        ixx = 3.0 * square / 20.0
        return Unit(
            PI * square * self.height / 3.0,
            (0.0, 0.0, 0.25 * self.height),
            ixx,
            ixx,
            3.0 * self.height * self.height / 80.0,
        )


@tagged("shape")
@record
class Frustum(ConicalBody):
    """A solid frustum of a circular cone, its base on the x-y plane about the origin."""

    taper: Taper
    height: Annotated[Size, "Height along z [m]."]

    dimension = 3
    formula = "Izz = (3/10)·m·(a⁵ − b⁵)/(a³ − b³), z̄ = h·(a² + 2ab + 3b²)/(4·(a² + ab + b²))"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a, b = self.base_radius, self.top_radius
        size = a * a + a * b + b * b
        require(size > 0.0, "a frustum needs a base or a top", code="frustum")
        first = a * a + 2.0 * a * b + 3.0 * b * b
        # the factored form of ∫z² less the square of the mean: no term is negative
        spread = a * a * (a * a + 4.0 * a * b + 10.0 * b * b) + b * b * (4.0 * a * b + b * b)
        fourth = a * a * (a * a + a * b + b * b) + b * b * (a * b + b * b)
        ixx = 3.0 * fourth / size / 20.0
        return Unit(
            PI * self.height * size / 3.0,
            (0.0, 0.0, 0.25 * self.height * first / size),
            ixx,
            ixx,
            3.0 * self.height * self.height * (spread / size / size) / 80.0,
        )


@tagged("shape")
@record
class Capsule(RoundBody):
    """A solid cylinder along z with a half ball on either end, its middle at the origin."""

    size: Round
    length: Annotated[Size, "Length of the cylinder between the half balls, along z [m]."]

    dimension = 3
    formula = "Izz = m_c·R²/2 + m_b·(2/5)·R², mass shared by volume: cylinder L, balls (4/3)·R"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        r, length = self.radius, self.length
        balls = 4.0 * r / 3.0
        total = length + balls
        require(total > 0.0, "a capsule needs a radius or a length", code="capsule")
        ixx = r * r * (0.25 * length + FIFTH * balls) / total
        # a half ball's centroid is 3R/8 off its face: its spread is 19R²/320 and the square of that distance
        away = 0.5 * length + 0.375 * r
        along = (length * length * length / 12.0 + balls * (19.0 * r * r / 320.0 + away * away)) / total
        return Unit(PI * r * r * total, CENTRE, ixx, ixx, along)


@tagged("shape")
@record
class Torus(RingBody):
    """A solid ring of circular section about z, its middle at the origin."""

    ring: Ring
    size: Round

    dimension = 3
    formula = "Izz = m·(R² + 3r²/4), Ixx = Iyy = m·(R²/2 + 5r²/8)"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        ring, square = self.ring_radius, self.radius * self.radius
        require_ring(ring, self.radius)
        ixx = 0.5 * ring * ring + 0.375 * square
        return Unit(2.0 * PI * PI * ring * square, CENTRE, ixx, ixx, 0.25 * square)
