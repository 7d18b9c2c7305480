"""Numbers of generalized coordinates with the kinds that follow from them: a force or a torque, metres or radians."""

from dynamics_cli.motion.equations.kane import generalized
from dynamics_cli.motion.equations.records import ConditionForce, MassRow, Partial, Share, SpeedEquation
from dynamics_cli.quantities import Acceleration, AngularAcceleration, Force, Kind, SignedMass, Speed, Torque, TurnRate
from dynamics_cli.records import Quantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    from dynamics_cli.motion.equations.constraints import Constrained
    from dynamics_cli.motion.equations.kane import Kane, Load
    from dynamics_cli.motion.equations.system import System

# Of a length or an angle: what moves per unit of it.
PER_LENGTH = Kind("partial velocity", "", about="velocity per velocity")
PER_ANGLE = Kind("partial velocity", "m/rad", us="ft/rad", about="velocity per angular velocity")
TURN_PER_LENGTH = Kind("partial angular velocity", "rad/m", us="rad/ft", about="angular velocity per velocity")
TURN_PER_ANGLE = Kind("partial angular velocity", "", about="angular velocity per angular velocity")
# Entries of the mass matrix by how many of the two coordinates are angles; either sign.
MASSES: "tuple[Any, ...]" = (
    SignedMass, Kind("mass times length", "kg*m", us="lb*ft"), Kind("moment of inertia", "kg*m^2", us="slug*ft^2"),
)  # fmt: skip


def force(angular: bool, value: float) -> Quantity:
    """A generalized force: a torque where the coordinate or speed is angular."""
    return Quantity(value, Torque if angular else Force)


def acceleration(angular: bool, value: float) -> Quantity:
    """A second derivative of a coordinate, or the derivative of a speed."""
    return Quantity(value, AngularAcceleration if angular else Acceleration)


def speed_rows(reduced: "Constrained", loads: "list[Load]", rates: "list[float]") -> "tuple[SpeedEquation, ...]":
    """The equations of the generalized speeds."""
    rows = []
    for k, (name, turns) in enumerate(zip(reduced.names, reduced.angular, strict=True)):
        active = generalized(loads, len(reduced.ways) + 1 + k)
        value = Quantity(reduced.values[k], TurnRate if turns else Speed)
        rows.append(SpeedEquation(name, value, acceleration(turns, rates[k]), force(turns, active)))
    return tuple(rows)


def condition_rows(system: "System", forces: "list[float]", multipliers: "list[float]") -> "tuple[ConditionForce, ...]":
    """The forces that keep the conditions."""
    pairs = zip(system.conditions, forces, multipliers, strict=True)
    return tuple(ConditionForce(name, Quantity(one, Force), Quantity(other, Force)) for name, one, other in pairs)


def mass_rows(system: "System", matrix: "list[list[float]]") -> "tuple[MassRow, ...]":
    """The mass matrix by rows."""
    turns = system.angular
    return tuple(
        MassRow(name, tuple(Quantity(value, MASSES[turns[r] + turns[s]]) for s, value in enumerate(row)))
        for r, (name, row) in enumerate(zip(system.names, matrix, strict=True))
    )


def partials(kane: "Kane") -> "Iterator[Partial]":
    """Partial velocities of the centres and points, and partial angular velocities of the bodies."""
    system = kane.system
    for r, name in enumerate(system.names):
        for of in system.places:
            spin = kane.partial_spin[of][r] if system.turns.get(of) else None
            velocity: Any = _vector(system, kane.partial[of][r], _slope(system.angular[r]))
            yield Partial(name, of, velocity, _turn(system, spin, _spin(system.angular[r])))


def share_of(system: "System", load: "Load", r: int, name: str, turns: bool) -> Share:
    """What a load contributes to the generalized force of a coordinate or speed."""
    return Share(
        coordinate=name,
        of=load.name,
        sort=load.sort,
        velocity=_vector(system, load.velocities[r], _slope(turns)) if load.force is not None else None,
        force=_vector(system, load.force, Force),
        angular_velocity=_turn(system, load.turns[r] if load.moment and any(load.moment) else None, _spin(turns)),
        moment=_turn(system, load.moment if load.moment and any(load.moment) else None, Torque),
        share=force(turns, load.share(r)),
    )


def _slope(turns: bool) -> Kind:
    return PER_ANGLE if turns else PER_LENGTH


def _spin(turns: bool) -> Kind:
    return TURN_PER_ANGLE if turns else TURN_PER_LENGTH


def _vector(system: "System", parts: "Any", kind: "Any") -> "Quantity | None":
    """A vector of a kind, of two components in the plane."""
    if parts is None:
        return None
    size, form = (2, "planar") if system.flat else (3, "vector")
    return Quantity(tuple(parts[:size]), Kind(kind.name, kind.unit, form=form, si=kind.si, us=kind.us, size=size))


def _turn(system: "System", parts: "Any", kind: "Any") -> "Quantity | None":
    """A turn or a moment; in the plane it is a number."""
    if parts is None or not system.flat:
        return _vector(system, parts, kind)
    return Quantity(parts[2], kind)
