"""Motion of one link or pin over a turn of the first driver."""

from math import pi

from dynamics_cli.errors import InadmissibleError, require
from dynamics_cli.linkage.scenes.records import Driver, Scene
from dynamics_cli.quantities import (
    Angle,
    AngularAcceleration,
    Annotated,
    PartAcceleration,
    PartPoint,
    PartVelocity,
    TurnRate,
)
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

MANY = 2_000


@record
class Followed:
    """One position of the driver."""

    driver_angle: Annotated[Angle, "Angle of the first driver [rad]."]
    angle: Annotated[Angle | None, "Angle of the link [rad]."]
    speed: Annotated[TurnRate | None, "Its angular velocity [rad/s]."]
    acceleration: Annotated[AngularAcceleration | None, "Its angular acceleration [rad/s^2]."]
    position: Annotated[PartPoint | None, "Where the pin is [m]."]
    velocity: Annotated[PartVelocity | None, "Its velocity [m/s]."]
    pin_acceleration: Annotated[PartAcceleration | None, "Its acceleration [m/s^2]."]


def driven(scene: Scene, angle: float) -> Scene:
    """The scene with its first driver at another angle."""
    first = scene.drivers[0]
    given = {name: getattr(first, name) for name in Driver.fields} | {"angle": angle}  # type: ignore[attr-defined]
    return Scene(scene.links, (Driver(**given), *scene.drivers[1:]), scene.slides, scene.sides, scene.near)


def followed(scene: Scene, name: str, steps: int, solved: "Callable[[Scene], Any]") -> "tuple[Followed, ...]":
    """Rows over a turn of the first driver; positions that cannot be reached are left out.

    Parameters
    ----------
    scene : Scene
        The linkage, its assembly named by sides.
    name : str
        A link or a pin.
    steps : int
        Steps of the turn.
    solved : callable
        Solves a scene.

    Returns
    -------
    tuple
        The rows.
    """
    first = scene.drivers[0]
    require(not first.point, "a motion is followed over an angle: let the first driver turn a link", code="driver")
    require(1 <= steps <= MANY, "steps: {count}; a turn has 1 to {most}", count=steps, most=MANY, code="steps")
    rows = []
    for index in range(steps + 1):
        angle = first.angle + 2.0 * pi * index / steps
        try:
            result = solved(driven(scene, angle))
        except InadmissibleError as error:
            if error.code != "cannot-be-closed":
                raise
            continue
        link = next((one for one in result.links if one.name == name), None)
        pin = next((one for one in result.pins if one.name == name), None)
        require(link is not None or pin is not None, "no link or pin is called {name}", name=repr(name), code="name")
        turning = (link.angle, link.speed, link.acceleration) if link else (None, None, None)
        moving = (pin.position, pin.velocity, pin.acceleration) if pin and not link else (None, None, None)
        rows.append(Followed(angle, *turning, *moving))
    return tuple(rows)
