"""Pictures of approach speeds from exit motion: the scene with velocities, and how well the measurements agree."""

from dynamics_cli.impact.scene_pictures import axes_of, collision, names_of, north_of, seen
from dynamics_cli.pictures import Axis, Band, Bars, Panel, Picture

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def inverse(result: "Any", *, first: "Any", second: "Any", **_: "Any") -> Picture:
    """The vehicles at the impact with fitted velocities, and every measurement with its residual."""
    axes = axes_of(result)
    flip = -1.0 if axes == "sae" else 1.0
    before, after, noses = [], [], []
    for vehicle, entered in zip((result.first, result.second), (first, second), strict=True):
        before.append(seen(vehicle.approach_speed, vehicle.approach_heading, axes))
        after.append((vehicle.exit_velocity[0], flip * vehicle.exit_velocity[1]))
        noses.append(seen(1.0, vehicle.approach_heading if entered.nose is None else entered.nose, axes))
    scene = collision(names_of(first, second), noses, before, after, north_of(axes))
    title = "approach from exit motion"
    if not result.residuals:
        return Picture((scene,), title, scene=True)
    sizes = [-vehicle.residual for vehicle in result.residuals]
    # the longest bar may be short, but one standard deviation is always visible
    bars = Bars(
        tuple(vehicle.measurement.replace(" along ", ", ") for vehicle in result.residuals),
        [min(value, 0.0) for value in sizes],
        [max(value, 0.0) for value in sizes],
    )
    reach = 1.1 * max(1.0, *map(abs, sizes))
    residuals = Axis("measured − fitted, in standard deviations", ends=(-reach, reach))
    agreement = Panel(residuals, Axis(""), (bars, Band(0.0, 0.0)), "measurements against the fit")
    return Picture((scene, agreement), title, columns=2, scene=True)
