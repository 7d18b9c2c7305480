"""Cranks and banks of usual engines: where each throw stands, where its cylinder points, its place along the shaft.

Angles in degrees in the sense of rotation, places in spacings. The pistons of a V on one throw share a place.
"""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import pi_beside
from dynamics_cli.records import Choice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Place = tuple[Any, Any, Any]

INLINE = {
    "inline-1": (0,),
    "inline-2": (0, 180),
    "inline-2-even": (0, 0),
    "inline-3": (0, 120, 240),
    "inline-4": (0, 180, 180, 0),
    "inline-5": (0, 144, 216, 288, 72),
    "inline-6": (0, 120, 240, 240, 120, 0),
}
# Throws, and by how much the second of each pair stands after the first.
VEES = {
    "v2": ((0,), 0, 90),
    "v4": ((0, 180), 0, 90),
    "v6": ((0, 120, 240), -60, 60),
    "v8-cross": ((0, 90, 270, 180), 0, 90),
    "v8-flat": ((0, 180, 180, 0), 0, 90),
    "v12": ((0, 120, 240, 240, 120, 0), 0, 60),
}
BOXERS = {"boxer-2": (0, 180), "boxer-4": (0, 180, 180, 0), "boxer-6": (0, 180, 120, 300, 240, 60)}
RADIALS = {f"radial-{count}": count for count in (3, 5, 7, 9)}


class Preset(Choice):
    """A usual engine."""

    names = (*INLINE, *VEES, *BOXERS, *RADIALS)
    aliases = {  # noqa: RUF012
        **{f"i{count}": f"inline-{count}" for count in range(1, 7)},
        **{f"inline{count}": f"inline-{count}" for count in range(1, 7)},
        **{f"flat-{count}": f"boxer-{count}" for count in (2, 4, 6)},
    }


def layout(preset: str, bank_angle: "Any", spacing: "Any") -> "list[Place]":
    """Crank angle, bank angle and place of every cylinder, about the middle of the shaft."""
    require(
        bank_angle is None or preset in VEES,
        "{preset} has no angle between banks",
        code="no-bank",
        hint="leave out --bank-angle, or take a V",
        preset=preset,
    )
    degree = pi_beside(spacing) / 180.0
    rows: list[Place]
    if preset in RADIALS:
        count = RADIALS[preset]
        rows = [(0.0, 360 * k * degree / count, 0.0) for k in range(count)]
    elif preset in VEES:
        throws, after, usual = VEES[preset]
        half = 0.5 * (usual * degree if bank_angle is None else bank_angle)
        rows = []
        for place, throw in enumerate(throws):
            rows += [(throw * degree, -half, place), ((throw + after) * degree, half, place)]
    elif preset in BOXERS:
        throws = BOXERS[preset]
        rows = [(throw * degree, 180 * degree * (nth % 2), nth) for nth, throw in enumerate(throws)]
    else:
        rows = [(throw * degree, 0.0, nth) for nth, throw in enumerate(INLINE[preset])]
    middle = 0.5 * rows[-1][2]
    return [(crank, bank, (place - middle) * spacing) for crank, bank, place in rows]
