"""A follower as lines and circles in the fixed frame, for pictures and for the turning cam."""

from cmath import exp, pi

from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.geometry.followers import MATES, FlatFace, KnifeEdge
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

CIRCLE = tuple(exp(2j * pi * k / 90) for k in range(91))


@record
class Figure:
    """The drawn parts of a follower."""

    shape: Annotated[tuple[complex, ...], "The line that touches: the roller's circle, the face, the knife-edge."]
    name: Annotated[str, "What it is."]
    holder: Annotated[tuple[complex, ...], "The slide's rod or the arm."]
    holder_name: Annotated[str, "Which of the two."]
    pivot: Annotated[complex | None, "The arm's pivot."]
    base: Annotated[float, "Radius of the base circle; zero where it is another cam's."]


def figure(geometry: Geometry, lift: float, size: float, face: "tuple[float, float] | None") -> Figure:
    """The follower at a lift.

    `lift`: its lift [m or rad]; `size`: size of the cam, which sets the length of rods [m]; `face`: where a flat face
    is touched along it, lowest and highest [m]. Returns the lines.
    """
    f: Any = geometry.follower
    base = 0.0 if isinstance(f, MATES) else f.base_radius
    level = geometry.start + lift
    low, high = face or (0.0, 0.0)
    margin = 0.08 * size
    if isinstance(f, FlatFace):
        position = 1j * level
        middle = 0.5 * (low + high)
        ends = position + low - margin, position + high + margin
        return Figure(ends, "face", (position + middle, position + middle + 0.6j * size), "rod", None, base)
    if geometry.flat:
        # along the arm from the pivot, and square to it towards the cam
        pivot = complex(f.pivot_distance)
        along = -exp(-1j * level)
        foot = pivot + f.face_offset * 1j * along
        ends = foot + along * max(low - margin, 0.0), foot + along * (high + margin)
        holder = (pivot, foot, ends[0]) if f.face_offset else (pivot, ends[0])
        return Figure(ends, "face", holder, "arm", pivot, base)
    if geometry.oscillating:
        pivot = complex(f.pivot_distance)
        centre = pivot - f.arm * exp(-1j * level)
        return Figure(_round(centre, geometry.roller), "roller", (pivot, centre), "arm", pivot, base)
    centre = complex(f.offset, level)
    rod = (centre, centre + geometry.way * 0.6j * size)
    if isinstance(f, KnifeEdge) or geometry.roller == 0.0:
        half = 0.05 * size
        edge = (centre, centre + half * (1 + 2j), centre + half * (-1 + 2j), centre)
        return Figure(edge, "knife-edge", (centre + 2j * half, rod[1]), "rod", None, base)
    return Figure(_round(centre, geometry.roller), "roller", rod, "rod", None, base)


def _round(centre: complex, radius: float) -> tuple[complex, ...]:
    return tuple(centre + radius * step for step in CIRCLE)


def turning_arrow(turn: float, radius: float) -> tuple[complex, ...]:
    """An arc with a head, in the sense in which the cam turns."""
    arc = [radius * exp(1j * turn * (0.35 + 1.5 * k / 24)) for k in range(25)]
    tip, back = arc[-1], -1j * turn * arc[-1] / abs(arc[-1])
    head = [tip + 0.28 * radius * back * exp(0.5j), tip, tip + 0.28 * radius * back * exp(-0.5j)]
    return (*arc, *head)
