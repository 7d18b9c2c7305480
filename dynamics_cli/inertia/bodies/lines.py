"""Moments about lines and shafts."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.bodies.mass_moments import turned
from dynamics_cli.inertia.bodies.principal_tracked import root
from dynamics_cli.inertia.bodies.records import ShaftMoment
from dynamics_cli.numerics.elementary import hypot
from dynamics_cli.numerics.vectors import cross, dot, length, subtract
from dynamics_cli.records import Measured

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.bodies.mass_moments import Lump, Vector
    from dynamics_cli.inertia.bodies.records import Shaft

# One avoirdupois pound [kg], one foot and one inch [m], one lbf·s²/in [kg].
POUND, FOOT, INCH = 0.45359237, 0.3048, 0.0254
SNAIL = POUND * 9.80665 / INCH


def unit(direction: "Vector") -> "Vector":
    """The unit vector along a direction; a vector along an axis keeps its exact zeros."""
    size = length(direction)
    require(size > 0.0, "the direction is the zero vector", code="direction")
    return direction[0] / size, direction[1] / size, direction[2] / size


def complement(u: "Vector") -> "tuple[Vector, Vector]":
    """Two unit vectors perpendicular to `u` and to each other; exact for an axis."""
    x, y, z = u
    size = tuple(abs(part) for part in u)
    if size[0] <= size[1] and size[0] <= size[2]:
        first = (0.0, z, -y)
    elif size[1] <= size[2]:
        first = (-z, 0.0, x)
    else:
        first = (y, -x, 0.0)
    first = unit(first)
    return first, cross(u, first)


def moment_about(body: "Lump", point: "Vector", direction: "Vector") -> "tuple[float, float]":
    """Moment of inertia about a line, as a sum of two second moments, and the mass centre's distance."""
    moment = distance = 0.0
    d = subtract(body.centroid, point)
    for e in complement(unit(direction)):
        along = turned(body.second, (e, e, e))[0][0]
        off = dot(e, d)
        moment = moment + along + body.mass * off * off
        distance = hypot(distance, off)
    return moment, distance


def shaft_moment(body: "Lump", shaft: "Shaft") -> ShaftMoment:
    """Moment about a shaft in the units used in drive engineering."""
    moment, distance = moment_about(body, shaft.point, shaft.direction)
    number = getattr(moment, "value", moment)
    return ShaftMoment(
        moment=moment,
        radius_of_gyration=root(moment / body.mass),
        eccentricity=distance,
        wr2=Measured(number / (POUND * FOOT * FOOT), "lb*ft^2"),
        gd2=Measured(4.0 * number, "kg*m^2"),
        inertia_lbf_in_s2=Measured(number / (SNAIL * INCH * INCH), "lbf*in*s^2"),
    )
