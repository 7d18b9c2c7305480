"""Work and energy over the surfaces that a vehicle slid across, followed back from its end."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import hypot, sqrt, where
from dynamics_cli.numerics.road.drag import drag_along, require_drag
from dynamics_cli.quantities import Annotated, Distance, DragFactor, RoadSpeed, Time
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any


@record
class SurfaceCrossed:
    """The slide on one surface."""

    entry_speed: Annotated[RoadSpeed, "Speed where the surface begins [m/s]."]
    exit_speed: Annotated[RoadSpeed, "Speed where the surface ends [m/s]."]
    drag_factor: Annotated[DragFactor, "Deceleration along the road over gravity [-]."]
    time: Annotated[Time, "Time spent on the surface [s]."]
    distance: Annotated[Distance, "Length of the surface [m]."]


def require_kept(nonzero: object, quantity: str) -> None:
    """Refuse a nonzero number that underflowed to zero."""
    require(
        nonzero,
        quantity + " is too small: the calculation leaves the range of a double",
        code="range",
        hint="check the size of the inputs",
    )


def crossing_time(distance: float, entry_speed: float, exit_speed: float) -> float:
    """Time 2d/(v₁ + v₂) of a uniformly slowed stretch; zero if distance and speed are zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 3.
    """
    speed_sum = entry_speed + exit_speed
    require_kept((speed_sum > 0.0) | (distance == 0.0), "the speed over the distance")
    return 2.0 * distance / where(speed_sum > 0.0, speed_sum, 1.0)


def crossed_back(
    stretches: "Sequence[Any]", end_speed: float, gravity: float, names: "Sequence[str]"
) -> "tuple[tuple[SurfaceCrossed, ...], float]":
    """Every stretch in the order it was crossed, and Σ f d of them all: v² = v_e² + 2g Σ f d.

    A stretch has friction, grade, braking and distance; its name precedes its refusals.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10.
    """
    crossed: list[SurfaceCrossed] = []
    work: float = 0.0
    exit_speed = end_speed
    for stretch, name in zip(reversed(stretches), reversed(names), strict=True):
        drag = require_drag(drag_along(stretch.friction, stretch.grade, stretch.braking), name)
        work = work + drag * stretch.distance
        entry_speed = hypot(end_speed, sqrt(2.0 * gravity * work))
        time = crossing_time(stretch.distance, entry_speed, exit_speed)
        crossed.append(SurfaceCrossed(entry_speed, exit_speed, drag, time, stretch.distance))
        exit_speed = entry_speed
    crossed.reverse()
    return tuple(crossed), work
