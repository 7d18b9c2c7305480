"""Cartesian, cylindrical and spherical coordinates, stable near the axes and from the smallest to the largest double.

Cylindrical (r, θ, z): x = r cos θ, y = r sin θ. Spherical (ρ, φ, θ): φ is measured from the Z-axis and θ in the X–Y
plane from X: x = ρ sin φ cos θ, y = ρ sin φ sin θ, z = ρ cos φ (Josephs & Huston, Dynamics of Mechanical Systems, CRC
Press 2002, section 1.6). Results are canonical: r, ρ ≥ 0, 0 ≤ φ ≤ π, −π < θ ≤ π; an angle that the point does not
determine is zero, and said to be.
"""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, atan2, cos, hypot, maximum, sin, where
from dynamics_cli.quantities import Angle, Annotated
from dynamics_cli.records import Advice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import TypeAlias

    Turn: TypeAlias = Callable[[float], tuple[float, float]]

PI = 3.141592653589793
LARGEST = 1.7976931348623157e308
# Powers of two that bring components whose squares or sums would leave the range of doubles back into it, exactly.
_SMALL, _LARGE, _UP, _DOWN = 2.0**-500, 2.0**500, 2.0**520, 2.0**-520


def cosine_and_sine(angle: float) -> tuple[float, float]:
    """Cosine and sine of a double as it is."""
    return cos(angle), sin(angle)


@record
class Cartesian:
    """A point by its Cartesian coordinates."""

    x: Annotated[float, "Along the X-axis."]
    y: Annotated[float, "Along the Y-axis."]
    z: Annotated[float, "Along the Z-axis."]
    advice: tuple[Advice, ...] = ()


@record
class Cylindrical:
    """A point by its cylindrical coordinates."""

    r: Annotated[float, "Distance from the Z-axis."]
    theta: Annotated[Angle, "Angle θ in the X–Y plane, from X towards Y [rad]."]
    z: Annotated[float, "Along the Z-axis."]
    advice: tuple[Advice, ...] = ()


@record
class Spherical:
    """A point by its spherical coordinates."""

    rho: Annotated[float, "Distance ρ from the origin."]
    phi: Annotated[Angle, "Angle φ from the Z-axis [rad]."]
    theta: Annotated[Angle, "Angle θ in the X–Y plane, from X towards Y [rad]."]
    advice: tuple[Advice, ...] = ()


def cartesian_to_cylindrical(x: float, y: float, z: float) -> Cylindrical:
    """Cylindrical coordinates of a Cartesian point.

    `x`: along the X-axis; `y`: along the Y-axis; `z`: along the Z-axis. Returns r ≥ 0, −π < θ ≤ π and z. Raises
    InadmissibleError when r exceeds the largest double.

    Equation
    --------
    r = √(x² + y²), θ = atan2(y, x).

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 1.6.

    Examples
    --------
    >>> round(cartesian_to_cylindrical(3.0, 1.0, 4.0).r, 4)
    3.1623
    """
    r = _representable(hypot(x, y))
    return Cylindrical(r, atan2(y + 0.0, x + 0.0), z, _undetermined(r, None))


def cartesian_to_spherical(x: float, y: float, z: float) -> Spherical:
    """Spherical coordinates of a Cartesian point.

    `x`: along the X-axis; `y`: along the Y-axis; `z`: along the Z-axis. Returns ρ ≥ 0, 0 ≤ φ ≤ π and −π < θ ≤ π. Raises
    InadmissibleError when ρ exceeds the largest double.

    Equation
    --------
    ρ = √(x² + y² + z²), φ = atan2(√(x² + y²), z), θ = atan2(y, x).

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 1.6.

    Examples
    --------
    >>> round(cartesian_to_spherical(3.0, 1.0, 4.0).rho, 4)
    5.099
    """
    largest = maximum(maximum(absolute(x), absolute(y)), absolute(z))
    scale = where(largest < _SMALL, _UP, where(largest > _LARGE, _DOWN, 1.0))
    axial = z * scale
    across = hypot(x * scale, y * scale)
    rho = _representable(hypot(across, axial) / scale)
    off_axis = where(x == 0.0, y, x)
    phi = where(largest == 0.0, 0.0, atan2(across, axial + 0.0))
    return Spherical(rho, phi, atan2(y + 0.0, x + 0.0), _undetermined(absolute(off_axis), rho))


def cylindrical_to_cartesian(r: float, theta: Angle, z: float, turn: "Turn" = cosine_and_sine) -> Cartesian:
    """Cartesian coordinates of a cylindrical point.

    `r`: distance from the Z-axis, not negative; `theta`: angle θ in the X–Y plane, from X towards Y [rad]; `z`: along
    the Z-axis; `turn`: gives cosine and sine of an angle, from its double or from the typed value. Returns x, y and z.
    Raises InadmissibleError when r is negative.

    Equation
    --------
    x = r cos θ, y = r sin θ.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 1.6.

    Examples
    --------
    >>> round(cylindrical_to_cartesian(4.0, 0.5235987755982988, 2.0).x, 4)
    3.4641
    """
    _require_distance("r", r)
    cosine, sine = turn(theta)
    return Cartesian(r * cosine, r * sine, z)


def cylindrical_to_spherical(r: float, theta: Angle, z: float) -> Spherical:
    """Spherical coordinates of a cylindrical point.

    `r`: distance from the Z-axis, not negative; `theta`: angle θ in the X–Y plane, from X towards Y [rad]; `z`: along
    the Z-axis. Returns ρ ≥ 0, 0 ≤ φ ≤ π and −π < θ ≤ π. Raises InadmissibleError when r is negative or ρ exceeds the
    largest double.

    Equation
    --------
    ρ = √(r² + z²), φ = atan2(r, z).

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 1.6.

    Examples
    --------
    >>> round(cylindrical_to_spherical(4.0, 0.5235987755982988, 2.0).rho, 4)
    4.4721
    """
    _require_distance("r", r)
    rho = _representable(hypot(r, z))
    return Spherical(rho, atan2(r + 0.0, z + 0.0), _canonical(theta, r), _undetermined(r, rho))


def spherical_to_cartesian(rho: float, phi: Angle, theta: Angle, turn: "Turn" = cosine_and_sine) -> Cartesian:
    """Cartesian coordinates of a spherical point.

    `rho`: distance ρ from the origin, not negative; `phi`: angle φ from the Z-axis, from 0 to π [rad]; `theta`: angle θ
    in the X–Y plane, from X towards Y [rad]. Returns x, y and z. Raises InadmissibleError when ρ is negative or φ is
    not within 0 to π.

    Equation
    --------
    x = ρ sin φ cos θ, y = ρ sin φ sin θ, z = ρ cos φ.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 1.6.

    Examples
    --------
    >>> round(spherical_to_cartesian(7.0, 0.7853981633974483, 1.0471975511965976).y, 4)
    4.2866
    """
    _require_distance("rho", rho)
    _require_polar(phi)
    along, sine = turn(phi)
    across = rho * sine
    ahead, aside = turn(theta)
    return Cartesian(across * ahead, across * aside, rho * along)


def spherical_to_cylindrical(rho: float, phi: Angle, theta: Angle, turn: "Turn" = cosine_and_sine) -> Cylindrical:
    """Cylindrical coordinates of a spherical point.

    `rho`: distance ρ from the origin, not negative; `phi`: angle φ from the Z-axis, from 0 to π [rad]; `theta`: angle θ
    in the X–Y plane, from X towards Y [rad]. Returns r ≥ 0, −π < θ ≤ π and z. Raises InadmissibleError when ρ is
    negative or φ is not within 0 to π.

    Equation
    --------
    r = ρ sin φ, z = ρ cos φ.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 1.6.

    Examples
    --------
    >>> round(spherical_to_cylindrical(7.0, 0.7853981633974483, 1.0471975511965976).r, 4)
    4.9497
    """
    _require_distance("rho", rho)
    _require_polar(phi)
    cosine, sine = turn(phi)
    # not by r, which may underflow off the axis
    off_axis = where(rho == 0.0, 0.0, sine)
    return Cylindrical(rho * sine, _canonical(theta, off_axis), rho * cosine, _undetermined(off_axis, None))


def _representable(distance: float) -> float:
    require(
        distance <= LARGEST,
        "the distance exceeds the largest double, {0:.6g}",
        LARGEST,
        code="overflow",
        hint="use a larger unit",
    )
    return distance


def _require_distance(name: str, value: float) -> None:
    require(
        value >= 0.0,
        name + " is a distance and cannot be {0:.6g}: the point opposite has the angle turned by 180 degrees",
        value,
        code="negative-distance",
    )


def _require_polar(phi: float) -> None:
    require(
        (phi >= 0.0) & (phi <= PI),
        "φ is measured from the Z-axis, from 0 to 180 degrees; it cannot be {0:.15g} degrees ({1!r} rad)",
        phi * (180.0 / PI),
        phi,
        code="polar-angle",
    )


def _canonical(theta: float, off_axis: float) -> float:
    """The same direction within (−π, π], and zero on the axis, where none is determined."""
    within = where(theta <= -PI, theta + 2.0 * PI, theta)
    turned = where(absolute(theta) <= PI, within, atan2(sin(theta), cos(theta)))
    return where(off_axis == 0.0, 0.0, turned)


def _undetermined(off_axis: float, distance: float | None) -> tuple[Advice, ...]:
    """Name the angles that the point leaves open; nothing for arrays."""
    if getattr(off_axis, "ndim", 0) or getattr(distance, "ndim", 0):
        return ()
    if off_axis != 0.0:
        return ()
    if distance is not None and distance == 0.0:
        message = "at the origin φ and θ are not determined: 0 is shown"
        return (Advice(code="angles-undetermined", message=message, severity="note"),)
    return (
        Advice(code="angle-undetermined", message="on the Z-axis θ is not determined: 0 is shown", severity="note"),
    )
