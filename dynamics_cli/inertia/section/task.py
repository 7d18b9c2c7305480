"""Area properties of a plane section for beams and plates in bending."""

from math import atan2, fsum, hypot, pi

from dynamics_cli.errors import require
from dynamics_cli.inertia.bodies.amount import OfDensity, OfMaterial, mass_of
from dynamics_cli.inertia.bodies.principal_tracked import SHOWN
from dynamics_cli.inertia.section.contours import Hole, Piece, contours
from dynamics_cli.inertia.section.integrals import Integrals, direction, principal, root
from dynamics_cli.inertia.section.profiles import Bar
from dynamics_cli.inertia.section.results import Gyration, Moduli, PlaneMoments, PrincipalPlane, SectionProperties
from dynamics_cli.inertia.section.simple import require_sound
from dynamics_cli.quantities import Annotated, Area, SectionCoordinate
from dynamics_cli.records import Advice, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.section.contours import Contour

UNIT_ROUNDOFF = 2.0**-53
# Moments closer than this fraction of the greatest are equal within the rounding of the inputs.
EQUAL = 8.0 * 2.0**-52
# Second moments of anything smaller would leave the range of a double.
SMALLEST = 1e-140
METHOD = "exact rational arithmetic of the coordinates as typed, rounded once"


@record
class Drawn:
    """A section as drawn: in a file, or by options."""

    polygon: Annotated[
        tuple[SectionCoordinate, ...], "Corners x1, y1, x2, y2, … of the outline in order, e.g. 0, 0, 60, 0, 60, 40 mm."
    ] = ()
    bars: Annotated[
        Bar | tuple[Bar, ...], "Profiles by their sizes: i-beam, channel, tee, angle, box, tube, flat, round."
    ] = ()
    pieces: Annotated[tuple[Piece, ...], "Material, as further polygons, circles and rectangles."] = ()
    holes: Annotated[tuple[Hole, ...], "Holes, as polygons, circles and rectangles within the material."] = ()
    amount: Annotated[OfDensity | OfMaterial | None, "What it is made of, for its mass per length."] = None


def section_of(drawn: Annotated[Drawn, "The section, from a file or by options."], /) -> SectionProperties:
    """Area, centroid, second moments, principal axes, radii of gyration and section moduli of a section as drawn.

    Returns
    -------
    SectionProperties
        As `section` gives them, which says how.
    """
    return section(polygon=drawn.polygon, pieces=drawn.pieces, holes=drawn.holes, bars=drawn.bars, amount=drawn.amount)


def section(
    *,
    polygon: tuple[SectionCoordinate, ...] = (),
    pieces: tuple[Piece, ...] = (),
    holes: tuple[Hole, ...] = (),
    bars: Bar | tuple[Bar, ...] = (),
    amount: OfDensity | OfMaterial | None = None,
) -> SectionProperties:
    """Area, centroid, second moments, principal axes, radii of gyration and section moduli of a plane section.

    `polygon`: corners x1, y1, x2, y2, … of the outline in order, either way round [m]; `pieces`: material, as further
    polygons, circles and rectangles; `holes`: holes, as polygons, circles and rectangles within the material. Returns
    the area properties. Raises InadmissibleError when contours cross themselves or one another, a hole is outside its
    material, pieces overlap, or the area is zero.

    Coordinates are the typed decimals in their unit; doubles are taken as exact ratios. All integrals over polygons are
    formed in exact ratios and rounded once (π is cut after 100 decimals), so that a section far from the origin, or
    very thin, loses no digits. The polar second moment is the torsion constant of round sections only; of open thin
    sections it is larger by orders of magnitude.

    Equation
    --------
    A = ½ Σ (xᵢ yⱼ − xⱼ yᵢ); Ix = ∫ y² dA = Σ (xᵢ yⱼ − xⱼ yᵢ)(yᵢ² + yᵢ yⱼ + yⱼ²)/12, j = i + 1,
    less A ȳ² about the centroid; I₁ = (Ix + Iy)/2 + √(((Ix − Iy)/2)² + Ixy²), I₂ = (Ix Iy − Ixy²)/I₁.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 7 and appendix II; Mohr's circle: section
    7.9.

    Examples
    --------
    >>> section(pieces=(Piece(width=3.0, height=4.0),)).centroidal.ix
    16.0
    """
    shapes, unit = contours(polygon, pieces, holes, bars)
    drawn = [contour for contour in shapes if not contour.way]
    for contour in drawn:
        area = Integrals([contour], unit).area
        require(area != 0, "{contour} has no area", code="polygon", hint="check its corners", contour=contour.name)
    require_sound(drawn)
    sums = Integrals(shapes, unit)
    require(sums.area > 0, "the holes leave no material", code="no-area")
    up, down = sums.moment(sums.area, 2)
    require(up / down > SMALLEST, "an area of {area} is out of range", code="range", area=(up / down, Area))
    return _Report(shapes, sums, None if amount is None else mass_of(amount, up / down, 3)).record()


class _Report:
    """Numbers of a section, each rounded from its exact ratio."""

    def __init__(self, shapes: "list[Contour]", sums: Integrals, linear_density: float | None) -> None:
        self.linear_density = linear_density
        self.contours = shapes
        self.sums = sums
        self.unit = sums.unit
        self.centroid = (sums.x, sums.area * self.unit), (sums.y, sums.area * self.unit)

    def record(self) -> SectionProperties:
        """The record."""
        sums = self.sums
        ix, iy, ixy = sums.central()
        scale = sums.central_scale
        (up1, down1), (up2, down2) = principal(ix, iy, ixy)
        first, second = (up1, down1 * scale), (up2, down2 * scale)
        i1, i2 = first[0] / first[1], second[0] / second[1]
        equal = (i1 - i2) <= EQUAL * i1
        angle = 0.0 if equal else _angle(ix, iy, ixy)
        area = sums.moment(sums.area, 2)
        origin_moments = [sums.moment(part, 4) for part in (sums.yy, sums.xx, sums.xy, sums.yy + sums.xx)]
        corners = sum(len(contour.corners) for contour in self.contours if not (contour.diameter or contour.way))
        return SectionProperties(
            area=area[0] / area[1],
            perimeter=self._perimeter(),
            x=self.centroid[0][0] / self.centroid[0][1],
            y=self.centroid[1][0] / self.centroid[1][1],
            centroidal=PlaneMoments(ix / scale, iy / scale, ixy / scale, (ix + iy) / scale),
            about_origin=PlaneMoments(*(up / down for up, down in origin_moments)),
            principal=PrincipalPlane(
                i1,
                i2,
                angle,
                "every axis through the centroid is principal: both moments are equal"
                if equal
                else "none: the principal moments are different",
            ),
            gyration=Gyration(
                *(_over(part, area) for part in ((ix, scale), (iy, scale), first, second, (ix + iy, scale)))
            ),
            moduli=self._moduli((ix, scale), (iy, scale), first, second, (1, 0) if equal else direction(ix, iy, ixy)),
            corners=corners,
            linear_density=self.linear_density,
            advice=_advice(self.contours),
            numerics=Numerics(METHOD, tuple(_bounds(weighed=self.linear_density is not None))),
        )

    def _perimeter(self) -> float:
        """Length of all contours."""
        lengths = [
            hypot((b[0] - a[0]) / self.unit, (b[1] - a[1]) / self.unit)
            for contour in self.contours
            for a, b in contour.sides()
        ]
        lengths += [pi * (contour.diameter / self.unit) for contour in self.contours]
        # a fillet's arc in place of the two sides of its corner
        lengths += [(0.5 * pi - 2.0) * (contour.radius / self.unit) for contour in self.contours]
        return fsum(lengths)

    def _moduli(
        self,
        ix: "tuple[int, int]",
        iy: "tuple[int, int]",
        first: "tuple[int, int]",
        second: "tuple[int, int]",
        greatest: "tuple[int, int]",
    ) -> Moduli:
        """Moments over the distances of the outermost fibres; `greatest` is along the axis of the first."""
        sides = [self._reach(axis, sign) for axis in (1, 0) for sign in (1, -1)]
        top, bottom, rightmost, leftmost = (
            (moment[0] * reach[1]) / (moment[1] * reach[0])
            for moment, reach in zip((ix, ix, iy, iy), sides, strict=True)
        )
        least = []
        for moment, nx, ny in ((first, -greatest[1], greatest[0]), (second, *greatest)):
            reach = self._farthest(nx, ny)
            least.append((moment[0] * reach[1]) / (moment[1] * reach[0]))
        return Moduli(top, bottom, rightmost, leftmost, *least)

    def _reach(self, axis: int, sign: int) -> "tuple[int, int]":
        """How far the section reaches along an axis from its centroid, as a ratio."""
        up, down = self.centroid[axis]
        twice = max(
            2 * sign * corner[axis] + contour.diameter for contour in self.contours for corner in contour.corners
        )
        return twice * (down // self.unit) - 2 * sign * up, 2 * down

    def _farthest(self, nx: int, ny: int) -> "tuple[int, int]":
        """The greatest distance from the line through the centroid across (nx, ny), as a ratio."""
        sums = self.sums
        up, down = root(nx * nx + ny * ny, 1)
        most = max(
            2 * abs(nx * (corner[0] * sums.area - sums.x) + ny * (corner[1] * sums.area - sums.y)) * down
            + contour.diameter * sums.area * up
            for contour in self.contours
            for corner in contour.corners
        )
        return most, 2 * sums.area * up * self.unit


def _angle(ix: int, iy: int, ixy: int) -> float:
    """Direction of the axis of the greatest moment: tan 2φ = −2 Ixy/(Ix − Iy)."""
    size = max(abs(ix - iy), abs(2 * ixy))
    angle = 0.5 * atan2(-2 * ixy / size, (ix - iy) / size)
    return angle if angle > -0.5 * pi else 0.5 * pi


def _over(moment: "tuple[int, int]", area: "tuple[int, int]") -> float:
    """√(I/A)."""
    up, down = root(moment[0] * area[1], moment[1] * area[0])
    return up / down


def _bounds(*, weighed: bool) -> "list[ErrorBound]":
    """One rounding of an exact ratio and one of its display unit; a few more for an angle or a sum of lengths."""
    once = UNIT_ROUNDOFF * (1.0 + 2.0**-40) + SHOWN
    names = ["area", "x", "y", "principal.i1", "principal.i2"]
    names += [f"{group}.{part}" for group in ("centroidal", "about_origin") for part in PlaneMoments.fields]  # type: ignore[attr-defined]
    names += [f"gyration.{part}" for part in Gyration.fields]  # type: ignore[attr-defined]
    names += [f"moduli.{part}" for part in Moduli.fields]  # type: ignore[attr-defined]
    out = [ErrorBound(name, once) for name in names]
    several = ("perimeter", "principal.angle", *(("linear_density",) if weighed else ()))
    out += [ErrorBound(name, 4.0 * UNIT_ROUNDOFF + SHOWN) for name in several]
    return out


def _advice(shapes: "list[Contour]") -> "tuple[Advice, ...]":
    if all(contour.diameter for contour in shapes):
        centres = {contour.corners[0] for contour in shapes}
        if len(centres) == 1:
            return ()
    message = "the polar second moment is not the torsion constant of this section, which is not round"
    return (Advice("not-torsion", message, "note"),)
