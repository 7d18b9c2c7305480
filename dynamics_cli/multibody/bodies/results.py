"""Rows that several tasks of a scene give: numbers of speeds with the kinds that follow from their joints."""

from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.vectors import length, times
from dynamics_cli.quantities import (
    Acceleration,
    AngularAcceleration,
    Annotated,
    Force,
    ForceVector,
    FreeNumber,
    Kind,
    SignedMass,
    Speed,
    Text,
    Torque,
    TorqueVector,
    TurnRate,
)
from dynamics_cli.records import Quantity, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.multibody.bodies.system import System
    from dynamics_cli.numerics.trees.newton_euler import Wrench
    from dynamics_cli.numerics.vectors import Vector

# Entries of the mass matrix by how many of the two speeds turn; of either sign.
MASSES: "tuple[Any, ...]" = (
    SignedMass, Kind("mass times length", "kg*m", us="lb*ft"), Kind("moment of inertia", "kg*m^2", us="slug*ft^2"),
)  # fmt: skip

# Of a sum of a dozen terms.
ROUNDING = 4e-15


@record
class Reaction:
    """What a joint transmits to the body it carries."""

    joint: Annotated[Text, "The body that the joint carries."]
    by: Annotated[Text, "The body that acts."]
    force: Annotated[ForceVector, "Force on the body, in ground axes [N]."]
    moment: Annotated[TorqueVector, "Moment on it about its own origin, of a loop about its point [N*m]."]
    undetermined: Annotated[
        Text | None, "Components that loops leave open: any value balances; that shown is the smallest."
    ] = None


@record
class MassRow:
    """A row of the mass matrix."""

    name: Annotated[Text, "The speed."]
    values: Annotated[tuple[FreeNumber, ...], "Its elements, in the order of the speeds."]


def effort(turning: bool, value: float) -> Quantity:
    """A torque or a force."""
    return Quantity(value, Torque if turning else Force)


def second(turning: bool, value: float) -> Quantity:
    """The rate of a speed."""
    return Quantity(value, AngularAcceleration if turning else Acceleration)


def rate(turning: bool, value: float) -> Quantity:
    """A speed."""
    return Quantity(value, TurnRate if turning else Speed)


def mass_rows(system: "System", matrix: "Sequence[Sequence[float]]") -> "tuple[MassRow, ...]":
    """The mass matrix by rows."""
    turns = system.turning
    return tuple(
        MassRow(name, tuple(Quantity(value, MASSES[turns[r] + turns[s]]) for s, value in enumerate(row)))
        for r, (name, row) in enumerate(zip(system.names, matrix, strict=True))
    )


def reaction_rows(
    system: "System", wrenches: "Sequence[Wrench]", unknown: "Sequence[str | None] | None" = None
) -> "tuple[Reaction, ...]":
    """What every joint transmits; of a joint of several speeds once."""
    rows = []
    force_size = max((length(force) for force, _ in wrenches), default=0.0)
    lever = max((max(length(link.position), length(link.centroid)) for link in system.tree.links), default=0.0)
    for body in system.bodies:
        k = system.link[body.name]
        rotation = system.ground[k][0]
        force, moment = (times(rotation, part) for part in wrenches[k])
        force, moment = rounded(force, force_size), rounded(moment, force_size * lever)
        rows.append(Reaction(body.name, body.parent, force, moment, unknown[k] if unknown else None))
    return tuple(rows)


def rounded(v: "Vector", size: float) -> "Vector":
    """Components that are rounding beside a size as zeros."""
    least = ROUNDING * plain(size)
    x, y, z = (part if abs(plain(part)) > least else 0.0 * part + 0.0 for part in v)
    return x, y, z
