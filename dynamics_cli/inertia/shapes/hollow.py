"""Hollow solids by outer size and wall thickness, in factored forms that keep every digit of a thin wall.

The measure is the volume.
"""

from dynamics_cli.errors import require
from dynamics_cli.inertia.shapes.sizes import (
    ConicalBody,
    Ring,
    RingBody,
    Round,
    RoundBody,
    Taper,
    Wall,
    cubes,
    inner_radius,
    inner_side,
    require_ring,
)
from dynamics_cli.inertia.shapes.unit import CENTRE, FOUR_THIRDS, PI, TWO_THIRDS, Unit
from dynamics_cli.quantities import Annotated, Size
from dynamics_cli.records import record, tagged


@tagged("shape")
@record
class HollowSphere(RoundBody):
    """A ball with a concentric cavity, about the origin."""

    size: Round
    wall: Wall

    dimension = 3
    formula = "r = R − t: Ixx = Iyy = Izz = (2/5)·m·(R⁵ − r⁵)/(R³ − r³), factored"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        inner, thickness = self.wall.inside(self.radius)
        size, fourth = cubes(self.radius, inner)
        ixx = fourth / size / 5.0
        return Unit(FOUR_THIRDS * PI * thickness * size, CENTRE, ixx, ixx, ixx)


@tagged("shape")
@record
class HollowHemisphere(RoundBody):
    """Half a ball with a concentric cavity, its rim on the x-y plane about the origin, open below."""

    size: Round
    wall: Wall

    dimension = 3
    formula = "r = R − t: z̄ = (3/8)·(R⁴ − r⁴)/(R³ − r³), Izz = (2/5)·m·(R⁵ − r⁵)/(R³ − r³), factored"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a = self.radius
        b, thickness = self.wall.inside(a)
        size, fourth = cubes(a, b)
        ixx = fourth / size / 5.0
        # ∫z² less the square of the mean, as a polynomial in the inner over the outer radius without a negative term
        s = b / a
        ends = 19.0 + s * (38.0 + s * (57.0 + s * (12.0 + s * (57.0 + s * (38.0 + s * 19.0)))))
        ratio_sum = 1.0 + s * (1.0 + s)
        return Unit(
            TWO_THIRDS * PI * thickness * size,
            (0.0, 0.0, 0.375 * (a + b) * (a * a + b * b) / size),
            ixx,
            ixx,
            a * a * (ends / (320.0 * ratio_sum * ratio_sum)),
        )


@tagged("shape")
@record
class HollowCylinder(RoundBody):
    """A tube along z, its middle at the origin."""

    size: Round
    wall: Wall
    length: Annotated[Size, "Length along z [m]."]

    also = ("tube", "pipe", "washer", "bush", "hollow-shaft")
    dimension = 3
    formula = "r = R − t: Izz = m·(R² + r²)/2, Ixx = Iyy = m·(3·(R² + r²) + L²)/12"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        inner, thickness = self.wall.inside(self.radius)
        ixx = 0.25 * (self.radius * self.radius + inner * inner)
        return Unit(
            PI * thickness * (self.radius + inner) * self.length,
            CENTRE,
            ixx,
            ixx,
            self.length * self.length / 12.0,
        )


@tagged("shape")
@record
class ClosedCylinder(RoundBody):
    """A can along z, its walls and both its ends of one thickness, its middle at the origin."""

    size: Round
    thickness: Annotated[Size, "Wall thickness, e.g. 3 mm."]
    length: Annotated[Size, "Outer length along z [m]."]

    dimension = 3
    formula = "outer less inner cylinder, factored in the thickness"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a, t, c = self.radius, self.thickness, self.length
        b, d = inner_radius(a, t), inner_side(c, t)
        wall, ends = (a + b) * c, 2.0 * b * b
        size = wall + ends
        require(size > 0.0, "a closed cylinder needs a radius", code="size")
        ixx = 0.25 * ((a * a + b * b) * wall + b * b * ends) / size
        along = (c * c * wall + (c * c + c * d + d * d) * ends) / size / 12.0
        return Unit(PI * t * size, CENTRE, ixx, ixx, along)


@tagged("shape")
@record
class HollowFrustum(ConicalBody):
    """A conical tube, its base on the x-y plane about the origin, its wall of one thickness across the axis."""

    taper: Taper
    thickness: Annotated[Size, "Wall thickness, measured across the axis, e.g. 3 mm."]
    height: Annotated[Size, "Height along z [m]."]

    dimension = 3
    formula = "outer less inner frustum, factored in the thickness"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a, b, t = self.base_radius, self.top_radius, self.thickness
        p, q = a + inner_radius(a, t), b + inner_radius(b, t)
        radius_sum = p + q
        require(radius_sum > 0.0, "a frustum needs a base or a top", code="frustum")
        # a ring at z has the area π t s and π t s (s² + t²)/8 across, where s runs straight from p to q
        across = 0.125 * (0.5 * (p * p + q * q) + t * t)
        h = self.height
        return Unit(
            0.5 * PI * t * radius_sum * h,
            (0.0, 0.0, h * (p + 2.0 * q) / (3.0 * radius_sum)),
            across,
            across,
            h * h * (p * p + 4.0 * p * q + q * q) / (18.0 * radius_sum * radius_sum),
        )


@tagged("shape")
@record
class HollowBlock:
    """A closed box about the origin, all six walls of one thickness."""

    width: Annotated[Size, "Outer side along x [m]."]
    depth: Annotated[Size, "Outer side along y [m]."]
    height: Annotated[Size, "Outer side along z [m]."]
    thickness: Annotated[Size, "Wall thickness, e.g. 3 mm."]

    dimension = 3
    formula = "outer less inner block, factored in the thickness"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        t = self.thickness
        a, b, c = self.width, self.depth, self.height
        x, y, z = inner_side(a, t), inner_side(b, t), inner_side(c, t)
        across_x, across_y, across_z = b * c, x * c, x * y
        size = across_x + across_y + across_z
        require(size > 0.0, "a box needs two sides", code="size")
        return Unit(
            2.0 * t * size,
            CENTRE,
            ((a * a + a * x + x * x) * across_x + x * x * (across_y + across_z)) / size / 12.0,
            (b * b * across_x + (b * b + b * y + y * y) * across_y + y * y * across_z) / size / 12.0,
            (c * c * (across_x + across_y) + (c * c + c * z + z * z) * across_z) / size / 12.0,
        )


@tagged("shape")
@record
class RectangularTube:
    """A straight tube of rectangular section along z, open at its ends, its middle at the origin."""

    width: Annotated[Size, "Outer side along x [m]."]
    depth: Annotated[Size, "Outer side along y [m]."]
    thickness: Annotated[Size, "Wall thickness, e.g. 3 mm."]
    length: Annotated[Size, "Length along z [m]."]

    also = ("box-section", "square-tube")
    dimension = 3
    formula = "outer less inner block, factored in the thickness; Σz² = m·L²/12"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        t = self.thickness
        a, b = self.width, self.depth
        x, y = inner_side(a, t), inner_side(b, t)
        size = b + x
        require(size > 0.0, "a tube needs a side", code="size")
        return Unit(
            2.0 * t * size * self.length,
            CENTRE,
            ((a * a + a * x + x * x) * b + x * x * x) / size / 12.0,
            (b * b * b + (b * b + b * y + y * y) * x) / size / 12.0,
            self.length * self.length / 12.0,
        )


@tagged("shape")
@record
class HollowTorus(RingBody):
    """A ring of tubular section about z, its middle at the origin."""

    ring: Ring
    size: Round
    thickness: Annotated[Size, "Wall thickness, e.g. 3 mm."]

    dimension = 3
    formula = "r = R_s − t: Izz = m·(R² + 3·(R_s² + r²)/4), Ixx = Iyy = m·(R²/2 + 5·(R_s² + r²)/8)"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        ring, outer = self.ring_radius, self.radius
        require_ring(ring, outer)
        inner = inner_radius(outer, self.thickness)
        square = outer * outer + inner * inner
        ixx = 0.5 * ring * ring + 0.375 * square
        return Unit(2.0 * PI * PI * ring * self.thickness * (outer + inner), CENTRE, ixx, ixx, 0.25 * square)
