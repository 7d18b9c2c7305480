"""Moments about lines and shafts."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.bodies.mass_moments import turned
from dynamics_cli.inertia.bodies.principal_tracked import root
from dynamics_cli.inertia.bodies.records import ShaftMoment
from dynamics_cli.numerics.elementary import hypot
from dynamics_cli.numerics.vectors import subtract
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
    length = hypot(hypot(direction[0], direction[1]), direction[2])
    require(length > 0.0, "the direction is the zero vector", code="direction")
    return direction[0] / length, direction[1] / length, direction[2] / length


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
    a, b, c = first = unit(first)
    return first, (y * c - z * b, z * a - x * c, x * b - y * a)


def moment_about(body: "Lump", point: "Vector", direction: "Vector") -> "tuple[float, float]":
    """Moment of inertia about a line, as a sum of two second moments, and the mass centre's distance."""
    moment = distance = 0.0
    d = subtract(body.centroid, point)
    for e in complement(unit(direction)):
        along = turned(body.second, (e, e, e))[0][0]
        off = e[0] * d[0] + e[1] * d[1] + e[2] * d[2]
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
