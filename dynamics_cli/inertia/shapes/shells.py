"""Shells of zero thickness. The measure is the area."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.shapes.sizes import ConicalBody, Ring, RingBody, Round, RoundBody, Taper, require_ring
from dynamics_cli.inertia.shapes.unit import CENTRE, HALF_RING, PI, TWO_OVER_PI, Unit
from dynamics_cli.numerics.elementary import hypot
from dynamics_cli.quantities import Annotated, Size
from dynamics_cli.records import Choice, record, tagged


class Ends(Choice):
    """Which ends of a cylindrical shell are closed."""

    names = ("open", "one", "both")
    aliases = {"none": "open", "closed": "both"}  # noqa: RUF012


@tagged("shape")
@record
class CylindricalShell(RoundBody):
    """A thin circular cylinder along z, its middle at the origin."""

    size: Round
    length: Annotated[Size, "Length along z [m]."]
    ends: Annotated[Ends, "Which ends are closed by a disk of the same sheet: open, one (at −length/2), both."] = Ends(
        "open"
    )

    dimension = 2
    formula = "open: Izz = m·R², Ixx = Iyy = m·(6R² + L²)/12; ends share the mass by area"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        r, length = self.radius, self.length
        count = Ends.names.index(self.ends)
        total = 2.0 * length + count * r
        require(total > 0.0, "a shell needs a length or an end", code="size")
        wall, end = 2.0 * length / total, r / total
        across = r * r * (0.5 * wall + 0.25 * count * end)
        square = length * length
        # one end shifts the centroid; two do not
        along = square * (wall / 12.0 + 0.25 * (end * wall if count == 1 else count * end))
        middle = -0.5 * length * end if count == 1 else 0.0
        return Unit(PI * r * total, (0.0, 0.0, middle), across, across, along)


@tagged("shape")
@record
class HalfCylindricalShell(RoundBody):
    """Half a thin circular cylinder along z, open, on the side of positive x, its mid-plane at z = 0."""

    size: Round
    length: Annotated[Size, "Length along z [m]."]

    dimension = 2
    formula = "x̄ = 2R/π, Izz = m·R²·(1 − 4/π²), Ixx = m·(6R² + L²)/12"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        square = self.radius * self.radius
        return Unit(
            PI * self.radius * self.length,
            (TWO_OVER_PI * self.radius, 0.0, 0.0),
            HALF_RING * square,
            0.5 * square,
            self.length * self.length / 12.0,
        )


@tagged("shape")
@record
class ConicalShell(RoundBody):
    """A thin circular cone, its rim on the x-y plane about the origin, its apex at z = height."""

    size: Round
    height: Annotated[Size, "Height along z [m]."]
    closed: Annotated[bool, "Close the rim with a disk of the same sheet."] = False

    dimension = 2
    formula = "open: z̄ = h/3, Izz = m·R²/2, Ixx = Iyy = m·(R²/4 + h²/18); a base shares the mass by area"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        r, h = self.radius, self.height
        slant = hypot(r, h)
        total = slant + r if self.closed else slant
        require(total > 0.0, "a cone needs a radius or a height", code="size")
        wall = slant / total
        ixx = 0.25 * r * r
        away = r / total if self.closed else 0.0
        return Unit(PI * r * total, (0.0, 0.0, wall * h / 3.0), ixx, ixx, h * h * wall * (1.0 + 2.0 * away) / 18.0)


@tagged("shape")
@record
class FrustumShell(ConicalBody):
    """A thin frustum of a circular cone, open, its base on the x-y plane about the origin."""

    taper: Taper
    height: Annotated[Size, "Height along z [m]."]

    dimension = 2
    formula = "Izz = m·(a² + b²)/2, z̄ = h·(a + 2b)/(3·(a + b))"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a, b, h = self.base_radius, self.top_radius, self.height
        radius_sum = a + b
        require(radius_sum > 0.0, "a frustum needs a base or a top", code="frustum")
        ixx = 0.25 * (a * a + b * b)
        return Unit(
            PI * radius_sum * hypot(a - b, h),
            (0.0, 0.0, h * (a + 2.0 * b) / (3.0 * radius_sum)),
            ixx,
            ixx,
            h * h * (a * a + 4.0 * a * b + b * b) / (18.0 * radius_sum * radius_sum),
        )


@tagged("shape")
@record
class SphericalShell(RoundBody):
    """A thin sphere about the origin."""

    size: Round

    dimension = 2
    formula = "Ixx = Iyy = Izz = (2/3)·m·R²"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        ixx = self.radius * self.radius / 3.0
        return Unit(4.0 * PI * self.radius * self.radius, CENTRE, ixx, ixx, ixx)


@tagged("shape")
@record
class HemisphericalShell(RoundBody):
    """A thin hemisphere, its rim on the x-y plane about the origin, on the side of positive z."""

    size: Round
    closed: Annotated[bool, "Close the rim with a disk of the same sheet."] = False

    dimension = 2
    formula = "open: z̄ = R/2, Izz = (2/3)·m·R², Ixx = Iyy = (5/12)·m·R²; closed: z̄ = R/3, Izz = (11/18)·m·R²"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        r = self.radius
        square = r * r
        if self.closed:
            ixx = 11.0 * square / 36.0
            return Unit(3.0 * PI * square, (0.0, 0.0, r / 3.0), ixx, ixx, square / 9.0)
        ixx = square / 3.0
        return Unit(2.0 * PI * square, (0.0, 0.0, 0.5 * r), ixx, ixx, square / 12.0)


@tagged("shape")
@record
class BoxShell:
    """A thin closed box about the origin."""

    width: Annotated[Size, "Side along x [m]."]
    depth: Annotated[Size, "Side along y [m]."]
    height: Annotated[Size, "Side along z [m]."]

    dimension = 2
    formula = "six rectangles that share the mass by area"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        a, b, c = self.width, self.depth, self.height
        x, y, z = b * c, c * a, a * b
        size = x + y + z
        require(size > 0.0, "a box needs two sides", code="size")
        return Unit(
            2.0 * size,
            CENTRE,
            a * a * (3.0 * x + y + z) / size / 12.0,
            b * b * (x + 3.0 * y + z) / size / 12.0,
            c * c * (x + y + 3.0 * z) / size / 12.0,
        )


@tagged("shape")
@record
class TorusShell(RingBody):
    """A thin ring of circular section about z, its middle at the origin."""

    ring: Ring
    size: Round

    dimension = 2
    formula = "Izz = m·(R² + 3r²/2), Ixx = Iyy = m·(R²/2 + 5r²/4)"

    def unit(self) -> Unit:
        """Measure, mass centre and second moments for a mass of 1 kg."""
        ring, square = self.ring_radius, self.radius * self.radius
        require_ring(ring, self.radius)
        ixx = 0.5 * ring * ring + 0.75 * square
        return Unit(4.0 * PI * PI * ring * self.radius, CENTRE, ixx, ixx, 0.5 * square)
