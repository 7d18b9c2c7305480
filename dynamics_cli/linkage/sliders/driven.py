"""A slider-crank that its slider drives: crank angle, speed and acceleration from those of the slider."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, atan2, hypot, sqrt, where
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import Coordinate, Size
from dynamics_cli.records import Choice


class Pin(Choice):
    """Side of the line from the crank's pivot to the slider on which the crank pin is."""

    names = ("left", "right")
    aliases = {"above": "left", "below": "right", "up": "left", "down": "right"}  # noqa: RUF012


LEFT = Pin("left")


def crank_of(lengths: "tuple[float, float, float]", position: float, pin: Pin) -> "tuple[float, float]":
    """Crank angle at a position of the slider, and 1 or −1 where the slider is to the right or left of the crank pin.

    The pin is where the circles of crank and rod about pivot and slider meet.
    """
    crank, rod, offset = lengths
    reach = hypot(position, offset)
    for gap, words, hint in (
        (reach - (crank + rod), "too far from the crank's pivot for crank and rod", "nearer to"),
        (absolute(crank - rod) - reach, "too near to the crank's pivot for crank and rod", "farther from"),
    ):
        require(
            (gap <= 0.0) & (reach > 0.0),
            f"a slider at {{position}} is {{gap}} {words}",
            position=(position, Coordinate),
            gap=(gap, Size),
            code="unreachable",
            hint=f"bring it {hint} the pivot by {{gap}}",
        )
    # twice the pin's parts along and across the line to the slider, times its length
    along = reach * reach + (crank - rod) * (crank + rod)
    far, near = (crank + rod - reach) * (crank + rod + reach), (reach - crank + rod) * (reach + crank - rod)
    across = sqrt(far * near)
    side = 1.0 if pin == LEFT else -1.0
    angle = atan2(offset, position) + side * atan2(across, along)
    return angle, where(position - crank * turned(angle)[0] >= 0.0, 1.0, -1.0)


def rates_of(slopes: "tuple[float, float]", velocity: float, acceleration: float) -> "tuple[float, float]":
    """Angular velocity and acceleration of the crank from those of the slider, by dx/dθ and d²x/dθ²."""
    slope, bend = slopes
    require(
        slope != 0.0,
        "crank and rod are in line (a dead centre): the slider cannot drive the crank through this pose",
        code="toggle",
        hint="give a position beside it",
    )
    speed = velocity / slope
    return speed, (acceleration - bend * speed * speed) / slope
