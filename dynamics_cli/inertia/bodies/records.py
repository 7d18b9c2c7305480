"""The parts of a mass property report."""

from dynamics_cli.quantities import (
    Annotated,
    Direction,
    Inertia,
    InertiaTriple,
    Mass,
    PartPosition,
    ProductOfInertia,
    Ratio,
    SignedMass,
    Size,
    Text,
    Vector,
)
from dynamics_cli.records import Measured, record


@record
class ShaftMoment:
    """Inertia of a body about a shaft."""

    moment: Annotated[Inertia, "Moment of inertia about the shaft [kg*m^2]."]
    radius_of_gyration: Annotated[Size, "Radius of gyration about the shaft [m]."]
    eccentricity: Annotated[Size, "Distance of the mass centre from the shaft [m]."]
    wr2: Annotated[Measured, "WR², weight times radius of gyration squared, as motor tables give it [lb*ft^2]."]
    gd2: Annotated[
        Measured, "GD² = 4 J, weight times diameter of gyration squared, as older metric tables give it [kg*m^2]."
    ]
    inertia_lbf_in_s2: Annotated[Measured, "The moment in lbf·in·s², as motion control catalogues give it."]


@record
class AxisMoments:
    """Moments of inertia about three axes."""

    xx: Annotated[Inertia, "About x [kg*m^2]."]
    yy: Annotated[Inertia, "About y [kg*m^2]."]
    zz: Annotated[Inertia, "About z [kg*m^2]."]


@record
class AxisProducts:
    """Products of inertia of three axes."""

    xy: Annotated[ProductOfInertia, "Of x and y [kg*m^2]."]
    yz: Annotated[ProductOfInertia, "Of y and z [kg*m^2]."]
    zx: Annotated[ProductOfInertia, "Of z and x [kg*m^2]."]


@record
class PrincipalMoments:
    """Principal moments of inertia, the smallest first."""

    first: Annotated[Inertia, "The smallest [kg*m^2]."]
    second: Annotated[Inertia, "The middle one [kg*m^2]."]
    third: Annotated[Inertia, "The largest [kg*m^2]."]


@record
class PartShare:
    """Contribution of one part."""

    part: Annotated[Text, "Its name, preceded by those of its assemblies."]
    mass: Annotated[SignedMass, "Its mass, negative for a hole [kg]."]
    centroid: Annotated[PartPosition, "Its mass centre, in the given axes [m]."]
    moments: Annotated[InertiaTriple, "Its contribution to the moments xx, yy, zz about the reference point [kg*m^2]."]


@record
class Cancellation:
    """Cancellation between material and holes: sum of magnitudes over magnitude of the sum."""

    mass: Annotated[Ratio, "Of the mass [-]."]
    moments: Annotated[Vector, "Of the moments xx, yy, zz about the reference point [-]."]


@record
class Deviation:
    """Standard uncertainties from those of the measured parts, to first order, with independent parts."""

    mass: Annotated[Mass, "Of the mass [kg]."]
    centroid: Annotated[PartPosition, "Of the mass centre's coordinates [m]."]
    moments: Annotated[InertiaTriple, "Of the moments xx, yy, zz about the mass centre, in the given axes [kg*m^2]."]
    products: Annotated[InertiaTriple, "Of the products xy, yz, zx about the mass centre, in the given axes [kg*m^2]."]
    principal_moments: Annotated[InertiaTriple, "Of the principal moments, their axes held [kg*m^2]."]


@record
class Shaft:
    """An axis of rotation."""

    direction: Annotated[Direction, "Direction of the shaft, in the given axes, of any length [-]."]
    point: Annotated[PartPosition, "A point of the shaft; the origin when not given [m]."] = (0.0, 0.0, 0.0)
