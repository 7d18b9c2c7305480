"""Sizes of round bodies by radius or diameter, walls by thickness or inner size, and sums that powers factor into."""

from dynamics_cli.errors import require
from dynamics_cli.quantities import Annotated, Size
from dynamics_cli.records import record


@record
class Radius:
    """A round body by its radius."""

    radius: Annotated[Size, "Radius: the outer one of a wall, of a torus that of its section [m]."]


@record
class Diameter:
    """A round body by its diameter."""

    diameter: Annotated[Size, "Diameter, in place of the radius, e.g. 50 mm."]

    @property
    def radius(self) -> float:
        """Half the diameter."""
        return 0.5 * self.diameter


@record
class Radii:
    """The ends of a frustum by their radii."""

    base_radius: Annotated[Size, "Outer radius at z = 0 [m]."]
    top_radius: Annotated[Size, "Outer radius at z = height [m]."]


@record
class Diameters:
    """The ends of a frustum by their diameters."""

    base_diameter: Annotated[Size, "Outer diameter at z = 0, e.g. 50 mm."]
    top_diameter: Annotated[Size, "Outer diameter at z = height, e.g. 30 mm."]

    @property
    def base_radius(self) -> float:
        """Half the diameter of the base."""
        return 0.5 * self.base_diameter

    @property
    def top_radius(self) -> float:
        """Half the diameter of the top."""
        return 0.5 * self.top_diameter


@record
class RingRadius:
    """A torus by the radius of its centre line."""

    ring_radius: Annotated[Size, "Radius of the circle through the middles of the sections [m]."]


@record
class RingDiameter:
    """A torus by the diameter of its centre line."""

    ring_diameter: Annotated[Size, "Diameter of the circle through the middles of the sections, e.g. 200 mm."]

    @property
    def ring_radius(self) -> float:
        """Half the diameter."""
        return 0.5 * self.ring_diameter


@record
class Thickness:
    """A wall by its thickness."""

    thickness: Annotated[Size, "Wall thickness: outer less inner radius, e.g. 3 mm."]

    def inside(self, outer: float) -> tuple[float, float]:
        """The inner radius and the thickness."""
        return inner_radius(outer, self.thickness), self.thickness


@record
class InnerRadius:
    """A wall by its inner radius."""

    inner_radius: Annotated[Size, "Inner radius, in place of the thickness, e.g. 20 mm."]

    def inside(self, outer: float) -> tuple[float, float]:
        """The inner radius and the thickness."""
        require(
            self.inner_radius <= outer,
            "the inner radius of {inner:6} exceeds the outer one of {outer:6}",
            code="thickness",
            inner=(self.inner_radius, Size),
            outer=(outer, Size),
        )
        return self.inner_radius, outer - self.inner_radius


@record
class InnerDiameter:
    """A wall by its inner diameter."""

    inner_diameter: Annotated[Size, "Inner diameter, in place of the thickness, e.g. 40 mm."]

    def inside(self, outer: float) -> tuple[float, float]:
        """The inner radius and the thickness."""
        require(
            self.inner_diameter <= 2.0 * outer,
            "the inner diameter of {inner:6} exceeds the outer one of {outer:6}",
            code="thickness",
            inner=(self.inner_diameter, Size),
            outer=(2.0 * outer, Size),
        )
        inner = 0.5 * self.inner_diameter
        return inner, outer - inner


Round = Radius | Diameter
Taper = Radii | Diameters
Ring = RingRadius | RingDiameter
Wall = Thickness | InnerRadius | InnerDiameter


class RoundBody:
    """A shape with one radius."""

    size: Round

    @property
    def radius(self) -> float:
        """Its radius, of the outside where there is a wall."""
        return self.size.radius


class RingBody(RoundBody):
    """A ring of round section."""

    ring: Ring

    @property
    def ring_radius(self) -> float:
        """The radius of its centre line."""
        return self.ring.ring_radius


class ConicalBody:
    """A shape whose radius changes from its base to its top."""

    taper: Taper

    @property
    def base_radius(self) -> float:
        """Its radius at z = 0."""
        return self.taper.base_radius

    @property
    def top_radius(self) -> float:
        """Its radius at z = height."""
        return self.taper.top_radius


def inner_radius(outer: float, thickness: float) -> float:
    """The inner radius of a wall."""
    inner = outer - thickness
    require(
        inner >= 0.0,
        "a wall of {thickness:6} does not fit in a radius of {outer:6}",
        code="thickness",
        hint="give a thickness of at most the outer radius",
        thickness=(thickness, Size),
        outer=(outer, Size),
    )
    return inner


def inner_side(outer: float, thickness: float) -> float:
    """The inner side between two walls."""
    inner = outer - 2.0 * thickness
    require(
        inner >= 0.0,
        "two walls of {thickness:6} do not fit in {outer:6}",
        code="thickness",
        hint="give a thickness of at most half the outer side",
        thickness=(thickness, Size),
        outer=(outer, Size),
    )
    return inner


def cubes(a: float, b: float) -> tuple[float, float]:
    """(a³ − b³)/(a − b) and (a⁵ − b⁵)/(a − b), sums without a negative term."""
    size = a * a + a * b + b * b
    require(size > 0.0, "the outer radius is zero", code="size")
    return size, a * a * size + b * b * b * (a + b)


def require_ring(ring: float, section: float) -> None:
    """Refuse a ring whose sections overlap in the middle."""
    require(
        section <= ring,
        "a section of radius {section:6} overlaps itself in a ring of radius {ring:6}",
        code="torus",
        hint="give a ring radius of at least the section's radius",
        section=(section, Size),
        ring=(ring, Size),
    )
