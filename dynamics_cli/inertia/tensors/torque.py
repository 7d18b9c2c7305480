"""Inertia force and torque of a moving rigid body: d'Alembert's addition to the applied forces."""

from dynamics_cli.errors import require_given
from dynamics_cli.inertia.bodies.mass_moments import minus
from dynamics_cli.numerics.elementary import hypot
from dynamics_cli.numerics.vectors import add, times
from dynamics_cli.quantities import (
    AccelerationVector,
    AngularAccelerationVector,
    AngularMomentumVector,
    AngularVelocity,
    Annotated,
    Energy,
    ForceVector,
    InertiaTensor,
    Mass,
    Torque,
    TorqueVector,
)
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.bodies.mass_moments import Matrix


@record
class InertiaTorque:
    """The inertia torque and its parts."""

    inertia_torque: Annotated[TorqueVector, "T* = −(I·α + ω × (I·ω)) about the mass centre [N*m]."]
    magnitude: Annotated[Torque, "Its size [N*m]."]
    acceleration_part: Annotated[TorqueVector, "−I·α [N*m]."]
    gyroscopic_part: Annotated[TorqueVector, "−ω × (I·ω), of rotation about an axis that is not principal [N*m]."]
    angular_momentum: Annotated[AngularMomentumVector, "I·ω about the mass centre [N*m*s]."]
    rotational_energy: Annotated[Energy, "ω·I·ω/2 [J]."]
    inertia_force: Annotated[ForceVector | None, "F* = −m·a, when mass and acceleration are given [N]."] = None


def torque(
    *,
    tensor: Annotated[
        InertiaTensor, "Inertia tensor about the mass centre; its elements off the diagonal are −∫ x y dm [kg*m^2]."
    ],
    angular_velocity: Annotated[
        AngularVelocity, "Angular velocity in an inertial frame, by components in the axes of the tensor [rad/s]."
    ] = (0.0, 0.0, 0.0),
    angular_acceleration: Annotated[AngularAccelerationVector, "Angular acceleration, in the same axes [rad/s^2]."] = (
        0.0,
        0.0,
        0.0,
    ),
    mass: Annotated[Mass | None, "Mass of the body, for the inertia force, e.g. 12 kg."] = None,
    acceleration: Annotated[
        AccelerationVector | None, "Acceleration of the mass centre, in the same axes, for the inertia force [m/s^2]."
    ] = None,
) -> InertiaTorque:
    """Inertia torque of a rigid body about its mass centre, and its inertia force.

    Equation
    --------
    T* = −I·α − ω × (I·ω); along principal axes T₁* = −I₁ α₁ + (I₂ − I₃) ω₂ ω₃ and so on; F* = −m a.

    Returns
    -------
    InertiaTorque
        The torque, its two parts, the angular momentum and the energy of rotation.

    Raises
    ------
    InadmissibleError
        When no body can have the tensor.

    Notes
    -----
    The gyroscopic part vanishes when ω lies along a principal axis: its remainder is then rounding, as its
    stated bound shows.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 7.12.

    Examples
    --------
    >>> torque(
    ...     tensor=((1.0, 0.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, 2.5)),
    ...     angular_velocity=(0.0, 3.0, 4.0), angular_acceleration=(0.0, 0.0, 1.0)
    ... ).inertia_torque
    (-6.0, 0.0, -2.5)
    """
    from dynamics_cli.inertia.tensors.tensor import require_tensor

    require_tensor(tensor, hint="check the tensor: its moments, its units, and more digits for a lamina")
    momentum = times(tensor, angular_velocity)
    inertial = opposite(times(tensor, angular_acceleration))
    gyroscopic = _gyroscopic(tensor, angular_velocity)
    total = add(inertial, gyroscopic)
    w = angular_velocity
    force = None
    if mass is not None or acceleration is not None:
        require_given(
            mass is not None and acceleration is not None,
            "an inertia force needs both the mass and its acceleration",
            ("mass", "acceleration"),
        )
        force = opposite(tuple(mass * part for part in acceleration))  # type: ignore[arg-type, union-attr, operator]
    return InertiaTorque(
        inertia_torque=total,
        magnitude=hypot(hypot(total[0], total[1]), total[2]),
        acceleration_part=inertial,
        gyroscopic_part=gyroscopic,
        angular_momentum=momentum,
        rotational_energy=0.5 * (momentum[0] * w[0] + momentum[1] * w[1] + momentum[2] * w[2]),
        inertia_force=force,
    )


def opposite(v: "tuple[float, float, float]") -> "tuple[float, float, float]":
    """The opposite vector."""
    return minus(v[0]), minus(v[1]), minus(v[2])


def _gyroscopic(tensor: "Matrix", w: "tuple[float, float, float]") -> "tuple[float, float, float]":
    """−ω × (I·ω) by differences of moments, which are exactly zero where the moments are equal."""
    (xx, xy, zx), (_, yy, yz), (_, _, zz) = tensor
    x, y, z = w
    return (
        (yy - zz) * y * z + yz * (z * z - y * y) + x * (xy * z - zx * y),
        (zz - xx) * z * x + zx * (x * x - z * z) + y * (yz * x - xy * z),
        (xx - yy) * x * y + xy * (y * y - x * x) + z * (zx * y - yz * x),
    )
