"""The involute: its function and inverse, roll angle, curvature, thickness at any radius, points of the curve."""

from math import pi

from dynamics_cli.errors import require, require_given
from dynamics_cli.gear.single.trochoid import roll_less_arc
from dynamics_cli.numerics.elementary import atan, cos, sin, sqrt, tan
from dynamics_cli.numerics.involute import inverse_involute, involute
from dynamics_cli.quantities import Angle, Annotated, Coordinate, Count, Positive, Ratio, Size
from dynamics_cli.records import Check, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Diameters whose squares stay within the range of a double [m].
SMALLEST, LARGEST = 1e-150, 1e150


@record
class AtAngle:
    """A point of the involute by its pressure angle."""

    angle: Annotated[Angle, "Pressure angle α_y there, e.g. 20 deg [rad]."]


@record
class AtInvolute:
    """A point of the involute by its involute function."""

    involute: Annotated[Positive, "Its inv α_y, e.g. 0.0149."]


@record
class AtRoll:
    """A point of the involute by its roll angle."""

    roll: Annotated[Angle, "Roll angle ξ_y = tan α_y, e.g. 20 deg [rad]."]


@record
class AtDiameter:
    """A point of the involute by its diameter."""

    diameter: Annotated[Size, "Diameter d_y; needs the base diameter, e.g. 45 mm [m]."]


@record
class CurvePoint:
    """A point of the involute that starts at (r_b, 0)."""

    roll: Annotated[Angle, "Roll angle [rad]."]
    radius: Annotated[Size, "Radius [m]."]
    x: Annotated[Coordinate, "Coordinate along the start [m]."]
    y: Annotated[Coordinate, "Coordinate across it [m]."]


@record
class InvoluteData:
    """An involute at one point."""

    pressure_angle: Annotated[Angle, "Pressure angle α_y [rad]."]
    involute: Annotated[Ratio, "Involute function inv α_y = tan α_y − α_y: the polar angle in radians."]
    roll_angle: Annotated[Angle, "Roll angle ξ_y = tan α_y [rad]."]
    diameter: Annotated[Size | None, "Diameter d_y = d_b/cos α_y [m]."]
    curvature_radius: Annotated[
        Size | None, "Radius of curvature ρ_y = r_b tan α_y, the length of the line of action to the base circle [m]."
    ]
    arc_length: Annotated[Size | None, "Length of the involute from the base circle, r_b ξ²/2 [m]."]
    thickness: Annotated[Coordinate | None, "Tooth thickness there as arc, where one is known elsewhere [m]."]
    pointed_diameter: Annotated[Size | None, "Diameter at which this tooth would be pointed [m]."]
    points: Annotated[tuple[CurvePoint, ...] | None, "Points from the base circle, at equal steps of √ξ, to this one."]
    checks: tuple[Check, ...] = ()


def involute_point(
    *,
    at: Annotated[AtAngle | AtInvolute | AtRoll | AtDiameter, "The point, given by one of its quantities."],
    base_diameter: Annotated[Size | None, "Base diameter d_b, for lengths, e.g. 34 mm [m]."] = None,
    known_thickness: Annotated[Size | None, "Tooth thickness as arc at `known_diameter`, e.g. 6 mm [m]."] = None,
    known_diameter: Annotated[Size | None, "Diameter at which a tooth thickness is known, e.g. 36 mm [m]."] = None,
    points: Annotated[Count, "Number of points of the curve to list, up to 1000."] = 0,
) -> InvoluteData:
    """Involute function, its inverse, roll angle, curvature, thickness and points of an involute.

    Equation
    --------
    inv α = tan α − α; d_y = d_b/cos α_y; s_y = d_y(s/d + inv α − inv α_y).

    Returns
    -------
    InvoluteData
        Angles, and with a base diameter lengths.

    Raises
    ------
    InadmissibleError
        When the angle is not from 0 to 90 degrees, a diameter lies inside the base circle, or lengths are requested
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
        require(
            base_diameter > 0.0,
            "the base diameter {base_diameter:6} must be above zero",
            base_diameter=(base_diameter, Size),
            code="base",
        )
        diameter = at.diameter if isinstance(at, AtDiameter) else base_diameter * sqrt(1.0 + roll * roll)
        curvature = 0.5 * base_diameter * roll
        length = 0.5 * curvature * roll
    if known_thickness is not None or known_diameter is not None or points > 0:
        require_given(base_diameter is not None, "lengths need the base diameter", ("base_diameter",), code="no-base")
    if known_thickness is not None or known_diameter is not None:
        require_given(
            known_thickness is not None and known_diameter is not None,
            "a known tooth thickness and the diameter at which it is known go together",
            ("known_thickness", "known_diameter"),
            code="thickness",
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
            "the pressure angle {angle:9} must be at least 0 and below 90 degrees",
            angle=(at.angle, Angle),
            code="pressure-angle",
        )
        return at.angle, involute(at.angle), tan(at.angle)
    if isinstance(at, AtRoll):
        roll = at.roll
        require(roll >= 0.0, "the roll angle {roll:6} must not be negative", roll=(roll, Angle), code="roll-angle")
    else:
        require(
            base_diameter is not None, "a diameter needs the base diameter", code="no-base", hint="give --base-diameter"
        )
        roll = _roll(at.diameter, base_diameter)  # type: ignore[arg-type]
    return atan(roll), roll_less_arc(roll), roll


def _roll(diameter: float, base: float) -> float:
    for size in (diameter, base):
        require(
            (size > SMALLEST) & (size < LARGEST),
            "the diameter {size:6} is outside the range of the calculation",
            size=(size, Size),
            code="size",
            hint="diameters may be from 1e-150 m to 1e150 m",
        )
    require(
        diameter >= base,
        "a diameter of {diameter:9} lies inside the base circle of {base:9}, where there is no involute",
        diameter=(diameter, Size),
        base=(base, Size),
        code="inside-base-circle",
    )
    return sqrt((diameter - base) * (diameter + base)) / base


def _points(base_diameter: float | None, roll: float, count: int) -> tuple[CurvePoint, ...] | None:
    require(
        count <= 1000, "{count} points are too many for this table", count=count, code="points", hint="use gear profile"
    )
    if base_diameter is None or count == 0:
        return None
    points = []
    for index in range(count):
        fraction = index / (count - 1) if count > 1 else 1.0
        # the curve bends most near the base circle
        roll_here = roll * fraction * fraction
        radius = 0.5 * base_diameter * sqrt(1.0 + roll_here * roll_here)
        polar = roll_less_arc(roll_here)
        points.append(CurvePoint(roll_here, radius, radius * cos(polar), radius * sin(polar)))
    return tuple(points)
