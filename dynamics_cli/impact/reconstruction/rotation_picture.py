"""The approach speed over the lever of the impulse."""

from dynamics_cli.pictures import Axis, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Distance, RoadSpeed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

POINTS = 81


def rotation(made: "Any", *, lever: float, exit_speed: float = 0.0, **_: "Any") -> Picture:
    """How the speed depends on where the impulse passed, all else as it is."""
    levers = [lever * (0.6 + 0.8 * i / (POINTS - 1)) for i in range(POINTS)]
    change = float(made.light_change)
    speeds = [change * lever / place + exit_speed for place in levers]
    items = (Curve(levers, speeds, role=0), Mark(lever, change + exit_speed, "here"))
    panel = Panel(Axis("lever of the impulse about the heavy vehicle", Distance), Axis("speed", RoadSpeed), items)
    return Picture((panel,), "speed of the light vehicle")
