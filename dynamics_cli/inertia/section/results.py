"""The parts of a section's report."""

from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Area,
    Coordinate,
    Count,
    LinearDensity,
    SecondMoment,
    SectionModulus,
    Size,
    Text,
)
from dynamics_cli.records import Advice, Check, Numerics, record


@record
class PlaneMoments:
    """Second moments of an area about axes through a point, parallel to x and y."""

    ix: Annotated[SecondMoment, "∫ y² dA, for bending about x [m^4]."]
    iy: Annotated[SecondMoment, "∫ x² dA, for bending about y [m^4]."]
    ixy: Annotated[SecondMoment, "The product ∫ x y dA [m^4]."]
    polar: Annotated[SecondMoment, "∫ r² dA = ix + iy; not the torsion constant unless the section is round [m^4]."]


@record
class PrincipalPlane:
    """Principal second moments of an area about its centroid."""

    i1: Annotated[SecondMoment, "The larger one [m^4]."]
    i2: Annotated[SecondMoment, "The smaller one [m^4]."]
    angle: Annotated[Angle, "From the x axis to the axis of `i1`, anticlockwise, above −90° and up to 90° [rad]."]
    degeneracy: Annotated[Text, "Whether these axes are determined."]


@record
class Gyration:
    """Radii of gyration about the centroid."""

    rx: Annotated[Size, "√(ix/A) [m]."]
    ry: Annotated[Size, "√(iy/A) [m]."]
    r1: Annotated[Size, "√(i1/A) [m]."]
    r2: Annotated[Size, "√(i2/A), that of buckling [m]."]
    polar: Annotated[Size, "√(polar/A) [m]."]


@record
class Moduli:
    """Elastic section moduli: second moment over distance of the outermost fibre."""

    x_top: Annotated[SectionModulus, "ix over the distance of the highest fibre [m^3]."]
    x_bottom: Annotated[SectionModulus, "ix over the distance of the lowest fibre [m^3]."]
    y_right: Annotated[SectionModulus, "iy over the distance of the rightmost fibre [m^3]."]
    y_left: Annotated[SectionModulus, "iy over the distance of the leftmost fibre [m^3]."]
    first_least: Annotated[SectionModulus, "i1 over the distance of the fibre farthest from axis 1 [m^3]."]
    second_least: Annotated[SectionModulus, "i2 over the distance of the fibre farthest from axis 2 [m^3]."]


@record
class SectionProperties:
    """Area properties of a section."""

    area: Annotated[Area, "Area [m^2]."]
    perimeter: Annotated[Size, "Length of all contours, holes included [m]."]
    x: Annotated[Coordinate, "Centroid [m]."]
    y: Annotated[Coordinate, "Centroid [m]."]
    centroidal: Annotated[PlaneMoments, "Second moments about the centroid."]
    about_origin: Annotated[PlaneMoments, "Second moments about the origin."]
    principal: Annotated[PrincipalPlane, "Principal second moments and their axes."]
    gyration: Annotated[Gyration, "Radii of gyration."]
    moduli: Annotated[Moduli, "Elastic section moduli."]
    corners: Annotated[Count, "Number of corners."]
    linear_density: Annotated[LinearDensity | None, "Mass per length, of a density or material [kg/m]."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None
