"""Pictures of approach speeds from exit motion: the scene with velocities, and how well the measurements agree."""

from dynamics_cli.impact.conventions import Axes, direction_of
from dynamics_cli.impact.scene_pictures import collision
from dynamics_cli.pictures import Axis, Band, Bars, Panel, Picture

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def inverse(result: "Any", *, first: "Any", second: "Any", **_: "Any") -> Picture:
    """The vehicles at the impact with fitted velocities, and every measurement with its residual."""
    axes = Axes(result.conventions.axes.partition(":")[0].lower())
    flip = -1.0 if axes == "sae" else 1.0
    results = result.first, result.second
    names = [getattr(vehicle, "name", None) or word for vehicle, word in ((first, "first"), (second, "second"))]
    before, after, noses = [], [], []
    for vehicle, entered in zip(results, (first, second), strict=True):
        x, y = direction_of(vehicle.approach_heading, axes)
        before.append((vehicle.approach_speed * x, flip * vehicle.approach_speed * y))
        after.append((vehicle.exit_velocity[0], flip * vehicle.exit_velocity[1]))
        x, y = (x, y) if entered.nose is None else direction_of(entered.nose, axes)
        noses.append((x, flip * y))
    north = (0.0, 1.0) if axes == "compass" else None
    scene = collision(names, noses, before, after, north)
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
