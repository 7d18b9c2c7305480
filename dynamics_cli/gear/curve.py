"""The involute: its function and inverse, roll angle, curvature, thickness at any radius, points of the curve."""

from math import pi

from dynamics_cli.errors import require
from dynamics_cli.gear.trochoid import roll_less_arc
from dynamics_cli.numerics.elementary import atan, cos, sin, sqrt, tan
from dynamics_cli.numerics.involute import inverse_involute, involute
from dynamics_cli.quantities import Angle, Coordinate, Count, Positive, Ratio, Size
from dynamics_cli.records import Check, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


@record
class AtAngle:
    """A point of the involute by its pressure angle.

    Parameters
    ----------
    angle : Angle
        Pressure angle α_y there [rad].
    """

    angle: Angle


@record
class AtInvolute:
    """A point of the involute by its involute function.

    Parameters
    ----------
    involute : Positive
        Its inv α_y.
    """

    involute: Positive


@record
class AtRoll:
    """A point of the involute by its roll angle.

    Parameters
    ----------
    roll : Angle
        Roll angle ξ_y = tan α_y [rad].
    """

    roll: Angle


@record
class AtDiameter:
    """A point of the involute by its diameter.

    Parameters
    ----------
    diameter : Size
        Diameter d_y; needs the base diameter [m].
    """

    diameter: Size


@record
class CurvePoint:
    """A point of the involute that starts at (r_b, 0).

    Parameters
    ----------
    roll : Angle
        Roll angle [rad].
    radius : Size
        Radius [m].
    x : Coordinate
        Coordinate along the start [m].
    y : Coordinate
        Coordinate across it [m].
    """

    roll: Angle
    radius: Size
    x: Coordinate
    y: Coordinate


@record
class InvoluteData:
    """An involute at one point.

    Parameters
    ----------
    pressure_angle : Angle
        Pressure angle α_y [rad].
    involute : Ratio
        Involute function inv α_y = tan α_y − α_y: the polar angle in radians.
    roll_angle : Angle
        Roll angle ξ_y = tan α_y [rad].
    diameter : Size
        Diameter d_y = d_b/cos α_y [m].
    curvature_radius : Size
        Radius of curvature ρ_y = r_b tan α_y, the length of the line of action to the base circle [m].
    arc_length : Size
        Length of the involute from the base circle, r_b ξ²/2 [m].
    thickness : Coordinate
        Tooth thickness there as arc, where one is known elsewhere [m].
    pointed_diameter : Size
        Diameter at which this tooth would be pointed [m].
    points : tuple of CurvePoint
        Points from the base circle, at equal steps of √ξ, to this one.
    """

    pressure_angle: Angle
    involute: Ratio
    roll_angle: Angle
    diameter: Size | None
    curvature_radius: Size | None
    arc_length: Size | None
    thickness: Coordinate | None
    pointed_diameter: Size | None
    points: tuple[CurvePoint, ...] | None
    checks: tuple[Check, ...] = ()


def involute_point(
    *,
    at: AtAngle | AtInvolute | AtRoll | AtDiameter,
    base_diameter: Size | None = None,
    known_thickness: Size | None = None,
    known_diameter: Size | None = None,
    points: Count = 0,
) -> InvoluteData:
    """Involute function, its inverse, roll angle, curvature, thickness and points of an involute.

    Equation
    --------
    inv α = tan α − α; d_y = d_b/cos α_y; s_y = d_y(s/d + inv α − inv α_y).

    Parameters
    ----------
    at : AtAngle | AtInvolute | AtRoll | AtDiameter
        The point, by one of its numbers.
    base_diameter : Size
        Base diameter d_b, for lengths [m].
    known_thickness : Size
        Tooth thickness as arc at `known_diameter` [m].
    known_diameter : Size
        Diameter at which a tooth thickness is known [m].
    points : Count
        How many points of the curve to list, up to 1000.

    Returns
    -------
    InvoluteData
        Angles, and with a base diameter lengths.

    Raises
    ------
    InadmissibleError
        When the angle is not from 0 to 90 degrees, a diameter lies inside the base circle, or lengths are asked for
        without a base diameter.

    Notes
    -----
    The inverse is not iterated: a series in ∛(3 inv α) below 60°, and one in 1/(inv α + π/2) above, both within
    1.3 ulp. The condition of inv α by α is 3 near 0; that of the inverse is 1/3 at most.

    References
    ----------
    ISO 21771, section 4; Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 17.4.

    Examples
    --------
    >>> from math import degrees
    >>> round(degrees(involute_point(at=AtInvolute(0.034316)).pressure_angle), 3)
    26.089
    """
    angle, value, roll = _angles(at, base_diameter)
    diameter = curvature = length = thickness = pointed = None
    if base_diameter is not None:
        require(base_diameter > 0.0, "a base diameter of {0:.6g} m makes no involute", base_diameter, code="base")
        diameter = at.diameter if isinstance(at, AtDiameter) else base_diameter * sqrt(1.0 + roll * roll)
        curvature = 0.5 * base_diameter * roll
        length = 0.5 * curvature * roll
    if known_thickness is not None or known_diameter is not None or points > 0:
        require(
            base_diameter is not None, "lengths need the base diameter", code="no-base", hint="give --base-diameter"
        )
    if known_thickness is not None or known_diameter is not None:
        require(
            known_thickness is not None and known_diameter is not None,
            "a known tooth thickness needs the diameter at which it is known, and the other way round",
            code="thickness",
            hint="give --known-thickness and --known-diameter",
        )
        half = known_thickness / known_diameter + roll_less_arc(_roll(known_diameter, base_diameter))  # type: ignore[operator, arg-type]
        thickness = diameter * (half - value)  # type: ignore[operator]
        pointed = base_diameter / cos(inverse_involute(half))  # type: ignore[operator]
    return InvoluteData(
        angle, value, roll, diameter, curvature, length, thickness, pointed, _points(base_diameter, roll, points)
    )


def _angles(at: "Any", base_diameter: float | None) -> tuple[float, float, float]:
    """Pressure angle, involute function and roll angle."""
    if isinstance(at, AtInvolute):
        angle = inverse_involute(at.involute)
        # t = inv + α loses nothing, where tan of an angle near 90° would
        return angle, at.involute, at.involute + angle
    if isinstance(at, AtAngle):
        require(
            (at.angle >= 0.0) & (at.angle < 0.5 * pi),
            "a pressure angle of {0:.9g} rad is not from 0 to below 90 degrees",
            at.angle,
            code="pressure-angle",
        )
        return at.angle, involute(at.angle), tan(at.angle)
    if isinstance(at, AtRoll):
        roll = at.roll
        require(roll >= 0.0, "a roll angle of {0:.6g} rad is before the base circle", roll, code="roll-angle")
    else:
        require(
            base_diameter is not None, "a diameter needs the base diameter", code="no-base", hint="give --base-diameter"
        )
        roll = _roll(at.diameter, base_diameter)  # type: ignore[arg-type]
    return atan(roll), roll_less_arc(roll), roll


def _roll(diameter: float, base: float) -> float:
    require(
        diameter >= base,
        "a diameter of {0:.9g} mm lies inside the base circle of {1:.9g} mm, where there is no involute",
        1e3 * diameter,
        1e3 * base,
        code="inside-base-circle",
    )
    return sqrt((diameter - base) * (diameter + base)) / base


def _points(base_diameter: float | None, roll: float, count: int) -> tuple[CurvePoint, ...] | None:
    require(count <= 1000, "{0} points are too many for this table", count, code="points", hint="use gear profile")
    if base_diameter is None or count == 0:
        return None
    made = []
    for index in range(count):
        share = index / (count - 1) if count > 1 else 1.0
        # the curve bends most near the base circle
        own = roll * share * share
        radius = 0.5 * base_diameter * sqrt(1.0 + own * own)
        polar = roll_less_arc(own)
        made.append(CurvePoint(own, radius, radius * cos(polar), radius * sin(polar)))
    return tuple(made)
