"""Least sideways speed that trips a rigid vehicle: at a kerb, or in soil that holds it with a steady deceleration."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import atan, hypot, sqrt
from dynamics_cli.numerics.elliptic import first_kind_with_pair
from dynamics_cli.quantities import Acceleration


def kerb_speed(half: float, height: float, turning: float, gravity: float) -> float:
    """Speed that lifts the mass centre over the wheels after a stop in an instant.

    Moment of momentum about the kerb gives the turning, its energy the rise t²/(√(h² + t²) + h). `turning` is k² + r²,
    the moment of inertia about the kerb over the mass.
    """
    rise = half * (half / (hypot(height, half) + height))
    return sqrt(2.0 * gravity * turning * rise) / height


def soil_trip(
    half: float, height: float, turning: float, deceleration: float, gravity: float
) -> "tuple[float, float, float]":
    """Minimum speed, angle and time of a trip by a steady deceleration that must last until the vehicle tips over.

    It must last until its work about the wheels, a·X, equals the work of the rise, g·rise, at the angle θ, tan(θ/2) =
    u. Up to there (dθ/dt)²·I_o/(2m) = 2(εu + κu²)/(1 + u²), ε = ah − gt, κ = at + gh, so that the time is an elliptic
    integral of the first kind.
    """
    excess = deceleration * height - gravity * half
    require(
        excess > 0.0,
        "a deceleration of {given} does not tip the vehicle: more than {least} is needed",
        given=(deceleration, Acceleration), least=(gravity * half / height, Acceleration), code="no-trip",
        hint="a soft edge, a kerb or a furrow gives more than a plain road",
    )  # fmt: skip
    rise = half * (half / (hypot(height, half) + height))
    sliding = gravity * rise / deceleration
    turned = sliding / (height + sqrt(height * height + sliding * (2.0 * half - sliding)))
    more = deceleration * half + gravity * height
    integral = first_kind_with_pair(excess + more * turned, excess, excess * turned)
    time = 2.0 * sqrt(turning * turned) * integral
    return deceleration * time, 2.0 * atan(turned), time
