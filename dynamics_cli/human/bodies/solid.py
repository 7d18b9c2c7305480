"""The task `solid`: segments as solids between two sections: frusta, stadium and elliptical solids, ellipsoids."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import pi_beside, sqrt
from dynamics_cli.quantities import Annotated, Density, Inertia, Length, Mass, Volume
from dynamics_cli.records import Check, record, tagged

TYPE_CHECKING = False
if TYPE_CHECKING:
    Section = tuple[float, float, float]

# Gauss's three points on 0 to 1: exact for the fourth powers that the sections give.
POINTS = ((0.5, 8.0 / 18.0), (-1.0, 5.0 / 18.0), (1.0, 5.0 / 18.0))
ABSCISSA = 0.6


@record
class Radii:
    """Round ends by their radii."""

    base_radius: Annotated[Length, "Radius at the first end, e.g. 9 cm."]
    top_radius: Annotated[Length, "Radius at the second end, e.g. 6 cm."]

    def radii(self, pi: float) -> "tuple[float, float]":
        """The radii of the ends."""
        return self.base_radius, self.top_radius


@record
class Girths:
    """Round ends by their girths."""

    base_girth: Annotated[Length, "Girth at the first end, e.g. 56 cm."]
    top_girth: Annotated[Length, "Girth at the second end, e.g. 38 cm."]

    def radii(self, pi: float) -> "tuple[float, float]":
        """The radii of the ends."""
        return 0.5 * self.base_girth / pi, 0.5 * self.top_girth / pi


@tagged("shape")
@record
class Frustum:
    """A cone's frustum, as Hanavan's limbs."""

    length: Annotated[Length, "From end to end, e.g. 42 cm."]
    ends: Annotated[Radii | Girths, "The round ends."]

    def section(self, s: float, pi: float) -> "Section":
        """Area and second moments across width and depth, at a share of the length."""
        base, top = self.ends.radii(pi)
        for radius in (base, top):
            require(radius >= 0.0, "a radius of {radius} is below zero", radius=(radius, Length), code="radius")
        r = base + s * (top - base)
        return pi * (r * r), 0.25 * pi * (r * r * r * r), 0.25 * pi * (r * r * r * r)


@tagged("shape")
@record
class Stadium:
    """A solid between two stadiums, as Yeadon's trunk: half circles and a straight part, by girth and width."""

    length: Annotated[Length, "From end to end, e.g. 15 cm."]
    base_girth: Annotated[Length, "Girth at the first end, e.g. 78 cm."]
    base_width: Annotated[Length, "Width at the first end, e.g. 30 cm."]
    top_girth: Annotated[Length | None, "Girth at the second end; as the first if left out, e.g. 90 cm."] = None
    top_width: Annotated[Length | None, "Width at the second end; as the first if left out, e.g. 33 cm."] = None

    def section(self, s: float, pi: float) -> "Section":
        """Area and second moments; the radius and the straight half change evenly along the length."""
        r0, t0 = _stadium("first", self.base_girth, self.base_width, pi)
        r1, t1 = _stadium("second", self.top_girth or self.base_girth, self.top_width or self.base_width, pi)
        r, t = r0 + s * (r1 - r0), t0 + s * (t1 - t0)
        cube, square = r * r * r, t * t
        width = 4.0 * r * t * square / 3.0 + 0.25 * pi * cube * r + pi * (r * r) * square + 8.0 * cube * t / 3.0
        return pi * (r * r) + 4.0 * r * t, width, 4.0 * cube * t / 3.0 + 0.25 * pi * cube * r


@tagged("shape")
@record
class EllipticalSolid:
    """A solid between two ellipses, as Hanavan's trunk."""

    length: Annotated[Length, "From end to end, e.g. 40 cm."]
    base_width: Annotated[Length, "Width at the first end, e.g. 32 cm."]
    base_depth: Annotated[Length, "Depth at the first end, e.g. 20 cm."]
    top_width: Annotated[Length | None, "Width at the second end; as the first if left out, e.g. 36 cm."] = None
    top_depth: Annotated[Length | None, "Depth at the second end; as the first if left out, e.g. 22 cm."] = None

    def section(self, s: float, pi: float) -> "Section":
        """Area and second moments; half axes change evenly along the length."""
        a0, b0 = 0.5 * self.base_width, 0.5 * self.base_depth
        a1 = a0 if self.top_width is None else 0.5 * self.top_width
        b1 = b0 if self.top_depth is None else 0.5 * self.top_depth
        a, b = a0 + s * (a1 - a0), b0 + s * (b1 - b0)
        return pi * (a * b), 0.25 * pi * (a * a * a * b), 0.25 * pi * (a * b * b * b)


@tagged("shape")
@record
class Ellipsoid:
    """An ellipsoid, as Hanavan's head and hands."""

    length: Annotated[Length, "From end to end, e.g. 24 cm."]
    width: Annotated[Length, "Its width, e.g. 16 cm."]
    depth: Annotated[Length | None, "Its depth; as the width if left out, e.g. 19 cm."] = None


@record
class ByMass:
    """The amount by the mass."""

    mass: Annotated[Mass, "Its mass, e.g. 7.9 kg."]


@record
class ByDensity:
    """The amount by the density."""

    density: Annotated[Density, "Its density, e.g. 1050 kg/m^3."]


@record
class SolidProperties:
    """Mass properties of a segment as a solid."""

    mass: Annotated[Mass, "Its mass [kg]."]
    volume: Annotated[Volume, "Its volume [m^3]."]
    centroid: Annotated[Length, "Mass centre from the first end [m]."]
    centroid_share: Annotated[float, "The same over the length [-]."]
    axial: Annotated[Inertia, "Moment of inertia about the long axis [kg*m^2]."]
    about_width: Annotated[Inertia, "About the axis of the width (left-right) through the mass centre [kg*m^2]."]
    about_depth: Annotated[Inertia, "About the axis of the depth (front-back) through the mass centre [kg*m^2]."]
    checks: tuple[Check, ...] = ()


def solid(
    shape: Annotated[Frustum | Stadium | EllipticalSolid | Ellipsoid, "The shape"],
    /,
    *,
    amount: Annotated[ByMass | ByDensity, "Mass, or density."],
) -> SolidProperties:
    """Mass, mass centre and moments of inertia of a body segment as a solid, from girths and widths.

    Equation
    --------
    V = ∫ A ds, z = ∫ A·s ds/V, I = ρ·∫ (J + A·(s − z)²) ds along the length; a stadium of girth P and width w has the
    radius r = (P − 2w)/(2π − 4) and the straight half t = w/2 − r.

    Returns
    -------
    SolidProperties
        Mass, mass centre from the first end, moments about the mass centre.

    Raises
    ------
    InadmissibleError
        When a size is not above zero, or no stadium has this girth and width.

    Notes
    -----
    Sections change evenly from end to end, so that the integrals are of fourth powers, for which Gauss's rule of three
    points is exact.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 20.2.

    Examples
    --------
    >>> answer = solid(Frustum(0.42, Radii(0.09, 0.06)), amount=ByDensity(1050.0))
    >>> round(answer.mass, 9), round(answer.about_width, 9)
    (7.897021453, 0.123118065)
    """
    length = shape.length
    require(length > 0.0, "the length of {length} is not above zero", length=(length, Length), code="length")
    if isinstance(shape, Ellipsoid):
        volume, centre, sums = _ellipsoid(shape)
    else:
        volume, centre, sums = _between_sections(shape)
    require(volume > 0.0, "the solid has no volume", code="volume")
    across, deep, along = sums
    density = amount.density if isinstance(amount, ByDensity) else amount.mass / volume
    require(density > 0.0, "a mass or density of nothing", code="amount")
    return SolidProperties(
        mass=density * volume,
        volume=volume,
        centroid=centre,
        centroid_share=centre / length,
        axial=density * (across + deep),
        about_width=density * (deep + along),
        about_depth=density * (across + along),
    )


def _between_sections(
    shape: "Frustum | Stadium | EllipticalSolid",
) -> "tuple[float, float, tuple[float, float, float]]":
    """Volume, mass centre, and the integrals of x², y² (width, depth) and of the distance along, about the centre."""
    pi, length = pi_beside(shape.length), shape.length
    root = 0.5 * sqrt(ABSCISSA + 0.0 * length)
    places = [(0.5 + (0.0 if sign == 0.5 else sign * root), weight) for sign, weight in POINTS]
    rows = [(s, weight, *shape.section(s, pi)) for s, weight in places]
    area = sum(weight * a for _, weight, a, _, _ in rows)
    centre = sum(weight * s * a for s, weight, a, _, _ in rows) / area
    along = sum(weight * a * ((s - centre) * (s - centre)) for s, weight, a, _, _ in rows)
    across = sum(weight * j for _, weight, _, j, _ in rows)
    deep = sum(weight * j for _, weight, _, _, j in rows)
    return length * area, length * centre, (length * across, length * deep, length * length * length * along)


def _ellipsoid(shape: Ellipsoid) -> "tuple[float, float, tuple[float, float, float]]":
    a, b, c = 0.5 * shape.width, 0.5 * (shape.depth or shape.width), 0.5 * shape.length
    volume = 4.0 * pi_beside(a) * (a * b * c) / 3.0
    return volume, c, (0.2 * volume * (a * a), 0.2 * volume * (b * b), 0.2 * volume * (c * c))


def _stadium(which: str, girth: float, width: float, pi: float) -> "tuple[float, float]":
    """Radius and straight half of a stadium; a girth that no such shape has is refused with those that it can have."""
    r = (girth - 2.0 * width) / (2.0 * pi - 4.0)
    t = 0.5 * width - r
    slack = 1e-12 * width
    require(
        (r > 0.0) & (t >= 0.0 - slack),
        "no stadium is {width} wide with a girth of {girth}, at the {which} end: its girth lies between {low} and "
        "{high}", width=(width, Length), girth=(girth, Length), which=which,
        low=(2.0 * width, Length), high=(pi * width, Length), code="stadium",
        hint="check which is girth and which is width, and their units",
    )  # fmt: skip
    return r, t
