"""The parts of a mass property report."""

from dynamics_cli.quantities import (
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
    """What a shaft feels of a body.

    Parameters
    ----------
    moment : Inertia
        Moment of inertia about the shaft [kg*m^2].
    radius_of_gyration : Size
        Radius of gyration about the shaft [m].
    eccentricity : Size
        Distance of the mass centre from the shaft [m].
    wr2 : Measured
        WR², weight times radius of gyration squared, as motor tables give it [lb*ft^2].
    gd2 : Measured
        GD² = 4 J, weight times diameter of gyration squared, as older metric tables give it [kg*m^2].
    inertia_lbf_in_s2 : Measured
        The moment in lbf·in·s², as motion control catalogues give it.
    """

    moment: Inertia
    radius_of_gyration: Size
    eccentricity: Size
    wr2: Measured
    gd2: Measured
    inertia_lbf_in_s2: Measured


@record
class AxisMoments:
    """Moments of inertia about three axes.

    Parameters
    ----------
    xx : Inertia
        About x [kg*m^2].
    yy : Inertia
        About y [kg*m^2].
    zz : Inertia
        About z [kg*m^2].
    """

    xx: Inertia
    yy: Inertia
    zz: Inertia


@record
class AxisProducts:
    """Products of inertia of three axes.

    Parameters
    ----------
    xy : ProductOfInertia
        Of x and y [kg*m^2].
    yz : ProductOfInertia
        Of y and z [kg*m^2].
    zx : ProductOfInertia
        Of z and x [kg*m^2].
    """

    xy: ProductOfInertia
    yz: ProductOfInertia
    zx: ProductOfInertia


@record
class PrincipalMoments:
    """Principal moments of inertia, the smallest first.

    Parameters
    ----------
    first : Inertia
        The smallest [kg*m^2].
    second : Inertia
        The one between [kg*m^2].
    third : Inertia
        The greatest [kg*m^2].
    """

    first: Inertia
    second: Inertia
    third: Inertia


@record
class PartShare:
    """What one part brings.

    Parameters
    ----------
    part : Text
        Its name, after those of the assemblies it is in.
    mass : SignedMass
        Its mass, negative for what is cut out [kg].
    centroid : PartPosition
        Its mass centre, in the given axes [m].
    moments : InertiaTriple
        What it adds to the moments xx, yy, zz, its offset from the reference point included [kg*m^2].
    """

    part: Text
    mass: SignedMass
    centroid: PartPosition
    moments: InertiaTriple


@record
class Cancellation:
    """How much of what the parts bring cancels: the sum of sizes over the size of the sum; digits are lost by it.

    Parameters
    ----------
    mass : Ratio
        Of the mass [-].
    moments : Vector
        Of the moments xx, yy, zz about the reference point [-].
    """

    mass: Ratio
    moments: Vector


@record
class Deviation:
    """Standard uncertainties that those of the measured parts lead to, in first order, the parts independent.

    Parameters
    ----------
    mass : Mass
        Of the mass [kg].
    centroid : PartPosition
        Of the mass centre's coordinates [m].
    moments : InertiaTriple
        Of the moments xx, yy, zz about the mass centre, in the given axes [kg*m^2].
    products : InertiaTriple
        Of the products xy, yz, zx about the mass centre, in the given axes [kg*m^2].
    principal_moments : InertiaTriple
        Of the principal moments, their axes held [kg*m^2].
    """

    mass: Mass
    centroid: PartPosition
    moments: InertiaTriple
    products: InertiaTriple
    principal_moments: InertiaTriple
