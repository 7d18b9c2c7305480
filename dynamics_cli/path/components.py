"""One state of motion in every system: Cartesian, cylindrical, spherical, and along the path itself."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import hypot
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.vectors import Vector, dot, length
from dynamics_cli.path.bends import OF_ALL_MOTION, advice_of, along_and_across, bend, centre_of
from dynamics_cli.path.coordinates import combined, local_axes
from dynamics_cli.quantities import (
    Acceleration,
    AccelerationVector,
    Annotated,
    Curvature,
    Direction,
    JerkVector,
    Length,
    Position,
    Speed,
    Velocity,
)
from dynamics_cli.records import Advice, Check, Choice, record


class Axes(Choice):
    """The directions that components are along."""

    names = ("cartesian", "cylindrical", "spherical")
    aliases = {"polar": "cylindrical"}  # noqa: RUF012


@record
class Components:
    """Velocity and acceleration in every system."""

    speed: Annotated[Speed, "Magnitude of the velocity [m/s]."]
    acceleration_size: Annotated[Acceleration, "Magnitude of the acceleration [m/s^2]."]
    tangential: Annotated[Acceleration | None, "Along the path, a_t [m/s^2]."]
    normal: Annotated[Acceleration | None, "Towards the centre of curvature, a_n [m/s^2]."]
    radius_of_curvature: Annotated[Length | None, "Radius of curvature ρ [m]."]
    curvature: Annotated[Curvature | None, "Curvature κ [1/m]."]
    torsion: Annotated[Curvature | None, "Torsion τ; needs the jerk [1/m]."]
    tangent: Annotated[Direction | None, "Direction T of motion [-]."]
    normal_direction: Annotated[Direction | None, "Direction N to the centre of curvature [-]."]
    binormal: Annotated[Direction | None, "Direction B = T × N [-]."]
    centre: Annotated[Position | None, "Centre of curvature [m]."]
    cartesian_velocity: Annotated[Velocity, "Along x, y, z [m/s]."]
    cartesian_acceleration: Annotated[AccelerationVector, "Along x, y, z [m/s^2]."]
    cylindrical_velocity: Annotated[Velocity | None, "Along r, θ, z [m/s]."]
    cylindrical_acceleration: Annotated[AccelerationVector | None, "Along r, θ, z [m/s^2]."]
    spherical_velocity: Annotated[Velocity | None, "Along ρ, φ, θ [m/s]."]
    spherical_acceleration: Annotated[AccelerationVector | None, "Along ρ, φ, θ [m/s^2]."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def components(
    *,
    velocity: Annotated[Velocity, "Velocity, e.g. 20, 5, 0 m/s."],
    acceleration: Annotated[AccelerationVector, "Acceleration, e.g. -2, 3, 0 m/s^2."],
    position: Annotated[Position | None, "Cartesian position, for the other systems, e.g. 3, 4, 1 m."] = None,
    jerk: Annotated[JerkVector | None, "Rate of the acceleration, for the torsion, e.g. 0, 1, 0 m/s^3."] = None,
    axes: Annotated[Axes, "Directions: cartesian, cylindrical (r, θ, z) or spherical (ρ, φ, θ)."] = Axes("cartesian"),  # noqa: B008
) -> Components:
    """Velocity and acceleration along x, y, z; r, θ, z; ρ, φ, θ; and along and across the path.

    Equation
    --------
    a_t = v·a/‖v‖, a_n = ‖v×a‖/‖v‖, ρ = ‖v‖³/‖v×a‖, τ = (v×a)·j/‖v×a‖², T = v/‖v‖, B = v×a/‖v×a‖, N = B×T.

    Raises
    ------
    InadmissibleError
        When the position leaves the directions open that the components are along.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 3.6.

    Examples
    --------
    >>> round(components(velocity=(3.0, 4.0, 0.0), acceleration=(0.0, 5.0, 0.0)).tangential, 9)
    4.0
    """
    frames = {} if position is None else _frames(position)
    frame_axes = frames.get(axes)
    require(
        axes == "cartesian" or frame_axes is not None,
        "without a position off the Z-axis the directions of {axes} coordinates are not determined",
        code="on-axis",
        hint="--position '3, 4, 1 m'",
        axes=str(axes),
    )
    if frame_axes is not None:
        velocity, acceleration = combined(frame_axes, velocity), combined(frame_axes, acceleration)
        jerk = None if jerk is None else combined(frame_axes, jerk)
    motion = bend(velocity, acceleration, jerk)
    round_axis, round_pole = frames.get("cylindrical"), frames.get("spherical")
    asked = (*(("torsion",) if jerk is not None else ()), *(("centre",) if position is not None else ()))
    directions = ("radius_of_curvature", "normal_direction", "binormal")
    advice = list(advice_of(motion, *directions, *asked, *OF_ALL_MOTION))
    if round_axis is None and position is not None:
        names = [f"{system}_{what}" for system in ("cylindrical", "spherical") for what in ("velocity", "acceleration")]
        words = "on the Z-axis the directions of cylindrical and spherical coordinates are not determined"
        advice += [Advice("on-axis", words, "note", "give a position off the Z-axis", result=name) for name in names]
    return Components(
        **along_and_across(motion),
        acceleration_size=motion.magnitude,
        curvature=motion.curvature,
        torsion=motion.torsion,
        tangent=motion.tangent,
        normal_direction=motion.normal_direction,
        binormal=motion.binormal,
        centre=None if position is None else centre_of(position, motion),
        cartesian_velocity=velocity,
        cartesian_acceleration=acceleration,
        cylindrical_velocity=_along(round_axis, velocity),
        cylindrical_acceleration=_along(round_axis, acceleration),
        spherical_velocity=_along(round_pole, velocity),
        spherical_acceleration=_along(round_pole, acceleration),
        advice=tuple(advice),
    )


def _frames(position: Vector) -> dict[str, tuple[Vector, Vector, Vector]]:
    """The local directions at a position, of the systems that determine them there."""
    x, y, z = position
    radius = hypot(x, y)
    if plain(radius) == 0.0:
        return {}
    cosine, sine = x / radius, y / radius
    zero, unity = 0.0 * cosine, 0.0 * cosine + 1.0
    distance = length(position)
    return {
        "cylindrical": ((cosine, sine, zero), (-sine, cosine, zero), (zero, zero, unity)),
        "spherical": local_axes(z / distance, radius / distance, cosine, sine),
    }


def _along(axes: "tuple[Vector, Vector, Vector] | None", vector: Vector) -> "Vector | None":
    return None if axes is None else (dot(axes[0], vector), dot(axes[1], vector), dot(axes[2], vector))
