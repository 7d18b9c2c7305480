"""Both speeds before an impact over the error of the heading that changes each of them most."""

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.impact.conventions import Axes
from dynamics_cli.impact.reconstruction.momentum import momentum, momentum_of_samples
from dynamics_cli.impact.reconstruction.momentum_records import Vehicle
from dynamics_cli.impact.reconstruction.momentum_verdict import DEGREE
from dynamics_cli.pictures import Axis, Curve, Mark, Panel
from dynamics_cli.quantities import Angle, RoadSpeed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

SIDES = ("first", "second")
# The error shown to both sides, and points of a curve.
REACH, POINTS = 3.0 * DEGREE, 25


def worst_headings(
    bodies: "Sequence[Any]", bulks: "Sequence[Any]", names: "Sequence[str]", axes: Axes, gravity: float, *, wide: bool
) -> "list[Panel]":
    """What up to three degrees of its worst heading make of each speed; nothing where momentum does not decide.

    `bodies` have the headings before and the motion after, as answered.
    """
    one, other = (
        Vehicle(bulk, None, body.approach_heading, body.exit_speed, body.exit_heading)
        for body, bulk in zip(bodies, bulks, strict=True)
    )
    items: list[Any] = []
    for role, (side, name) in enumerate(zip(SIDES, names, strict=True)):
        try:
            found = getattr(momentum(first=one, second=other, axes=axes, gravity=gravity), side)
        except InadmissibleError:
            return []
        moved, _, heading = found.determined.worst_heading.partition(".")
        errors, speeds = [], []
        for nth in range(POINTS):
            error = REACH * (2.0 * nth / (POINTS - 1) - 1.0)
            first, second = (
                Vehicle(**{**vehicle.__dict__, heading: getattr(vehicle, heading) + error})
                if place == moved
                else vehicle
                for place, vehicle in zip(SIDES, (one, other), strict=True)
            )
            try:
                shifted = momentum_of_samples(first=first, second=second, axes=axes, gravity=gravity)
            except InadmissibleError:
                continue
            errors.append(error)
            speeds.append(getattr(shifted, side).approach_speed)
        whose = f"{names[moved == 'second']} {heading.removesuffix('_heading')}"
        items += [
            Curve(errors, speeds, f"{name}, by {whose} heading", role=role),
            Mark(0.0, found.approach_speed, "", role=role),
        ]
    across, up = Axis("error of its worst heading", Angle), Axis("speed before the impact", RoadSpeed)
    return [Panel(across, up, tuple(items), "what its worst heading makes of each speed", wide=wide)]
