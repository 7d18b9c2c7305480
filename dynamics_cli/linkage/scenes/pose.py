"""One pose of a linkage from a scene: angles of its links, places of its pins, and their rates."""

from dynamics_cli.numerics.linkages.records import GROUND
from dynamics_cli.quantities import (
    Angle,
    AngularAcceleration,
    Annotated,
    PartAcceleration,
    PartPoint,
    PartVelocity,
    Text,
    TurnRate,
)
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.numerics.linkages.system import System

# Below this the smallest singular value over the largest means a pose that can move without its drivers.
SINGULAR = 1e-9
# Parts of this share of the largest are rounding.
DUST = 1e-14
# An angular acceleration of this share of that which the fastest pin would give is rounding.
TURNED = 1e-13


@record
class LinkMotion:
    """One link."""

    name: Annotated[Text, "The link."]
    angle: Annotated[Angle, "Angle of its own axes [rad]."]
    speed: Annotated[TurnRate | None, "Angular velocity [rad/s]."]
    acceleration: Annotated[AngularAcceleration | None, "Angular acceleration [rad/s^2]."]


@record
class PinMotion:
    """One pin."""

    name: Annotated[Text, "The pin."]
    position: Annotated[PartPoint, "Where it is [m]."]
    velocity: Annotated[PartVelocity | None, "Its velocity [m/s]."]
    acceleration: Annotated[PartAcceleration | None, "Its acceleration [m/s^2]."]


def posed(
    system: "System", q: "Any", jacobian: "Any", free: bool
) -> "tuple[tuple[LinkMotion, ...], tuple[PinMotion, ...]]":
    """Links and pins at q; without rates where the pose is free to move with its drivers held."""
    velocity, acceleration = (None, None) if free else system.rates(q, jacobian)
    moving, bending, place = _spread(system, velocity), _spread(system, acceleration), _clean(system.positions(q))
    links = tuple(
        _link(shape, place, moving, bending, system.scene.drivers)
        for shape in system.shapes.values()
        if shape.name != GROUND
    )
    pins = tuple(PinMotion(pin, *(pair(part, pin, system.scale) for part in (place, moving, bending))) for pin in place)
    return links, pins


def is_free(system: "System", jacobian: "Any") -> bool:
    """Whether the linkage can move at this pose with its drivers held."""
    import numpy as np

    values = np.linalg.svd(jacobian, compute_uv=False)
    return bool(values.min(initial=1.0) <= SINGULAR * values.max(initial=1.0)) or len(values) < system.size


def _spread(system: "System", vector: "Any") -> "dict[str, complex] | None":
    """Rates of every pin; fixed ones have none."""
    if vector is None:
        return None
    half = len(system.unknown)
    rates = {pin: complex(vector[i], vector[half + i]) for pin, i in system.place.items()}
    return _clean(dict.fromkeys(system.known, 0j) | rates)


def _clean(places: "dict[str, complex]") -> "dict[str, complex]":
    """Zero for parts that are below the rounding of the largest."""
    least = DUST * max(map(abs, places.values()))

    def part(x: float) -> float:
        return x if abs(x) > least else 0.0

    return {pin: complex(part(z.real), part(z.imag)) for pin, z in places.items()}


def _link(shape: "Any", at: "Any", moving: "Any", bending: "Any", drivers: "Any") -> LinkMotion:
    from cmath import phase

    base = at[shape.last] - at[shape.first]
    square = abs(base) ** 2
    angle = phase(base / shape.base) + 0.0
    if moving is None or bending is None:
        return LinkMotion(shape.name, angle, None, None)
    for driver in drivers:
        if driver.link == shape.name and driver.against == GROUND:
            # the driver's own rates, without rounding
            return LinkMotion(shape.name, angle, driver.speed, driver.angular_acceleration)
    turn = (base.conjugate() * (moving[shape.last] - moving[shape.first])).imag / square
    bend = (base.conjugate() * (bending[shape.last] - bending[shape.first])).imag / square
    least = TURNED * max(map(abs, bending.values())) / square**0.5
    return LinkMotion(shape.name, angle, turn, bend if abs(bend) > least else 0.0)


def pair(values: "Any", pin: str, scale: float) -> "Any":
    """Coordinates of one pin in metres."""
    return None if values is None else (float(values[pin].real) * scale, float(values[pin].imag) * scale)
