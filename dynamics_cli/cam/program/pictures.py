"""Pictures of cam motion: lift, velocity, acceleration and jerk over the turn, and peak factors."""

from math import nan, pi

from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.rise import Rise, rise
from dynamics_cli.cam.program.motion import Motion
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.cam.program.revolution_records import Revolution
from dynamics_cli.errors import worded
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import (
    Angle,
    CamAcceleration,
    CamJerk,
    CamVelocity,
    Coordinate,
    SwingAcceleration,
    SwingJerk,
    SwingVelocity,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

STEPS = 96
LENGTHS = (("lift", Coordinate), ("velocity", CamVelocity), ("acceleration", CamAcceleration), ("jerk", CamJerk))
SWINGS = (("swing", Angle), ("velocity", SwingVelocity), ("acceleration", SwingAcceleration), ("jerk", SwingJerk))
SYMBOLS = {"lift": "lift s", "velocity": "velocity v", "acceleration": "acceleration a", "jerk": "jerk j"}
SWING_SYMBOLS = {"swing": "swing ψ", "velocity": "velocity ψ′", "acceleration": "acceleration ψ″", "jerk": "jerk ψ‴"}
# Offsets of the labels of a maximum and of a minimum, in points.
ABOVE, BELOW, LEFT = (4.0, 4.0), (4.0, -11.0), -4.0


def svaj(result: Revolution, scene: Program, program: str = "", **inputs: "Any") -> Picture:
    """Draw lift, velocity, acceleration and jerk, one below the other; a jump is a gap.

    Returns four panels over the cam angle, the segments shaded in turn.
    """
    del inputs
    motion = motion_of(scene, program)
    angles, columns = sampled(motion)
    axes = SWINGS if motion.swing else LENGTHS
    extremes: tuple[Any, ...] = (result.lift, result.velocity, result.acceleration, result.jerk)
    if result.swing is not None:
        extremes = _of_swing(motion)
    symbols = SWING_SYMBOLS if motion.swing else SYMBOLS
    panels = []
    for order, (name, kind) in enumerate(axes):
        items: list[Band | Curve | Mark] = [*bands(motion, order), Curve(angles, columns[order])]
        ends = extremes[order]
        if ends is not None:
            items += extreme_mark(ends.greatest_at, ends.greatest, kind, ABOVE)
            # that the follower starts from rest needs no words
            items += extreme_mark(ends.least_at, ends.least or None, kind, BELOW)
        panels.append(Panel(turn_axis(motion), Axis(symbols[name], kind), tuple(items)))
    title = worded(
        "Cam motion, continuity {continuity}\n{program}",
        continuity=result.continuity,
        program=named_program(scene, program),
    )
    return Picture(tuple(panels), title)


def _of_swing(motion: Motion) -> "tuple[Any, ...]":
    from dynamics_cli.cam.program.summary import extreme

    return tuple(extreme(motion, order) for order in range(4))


def turn_axis(motion: Motion) -> Axis:
    """The cam angle over one turn."""
    return Axis("cam angle θ", Angle, ends=(motion.joints[0], motion.joints[-1]), step=pi / 6.0)


def extreme_mark(
    at: float | None, value: float | None, kind: "Any", aside: "tuple[float, float]"
) -> "tuple[Mark, ...]":
    """An extreme with its value beside it, to its left near the end of the turn."""
    if at is None or value is None:
        return ()
    across = LEFT if at > 1.7 * pi else aside[0]
    return (Mark(at, value, worded("{value}", value=(value, kind)), (across, aside[1])),)


def named_program(scene: Program, program: str) -> str:
    """A program as written, the file of its lifts, or the number of its segments."""
    from_file = f"lifts of {scene.lifts}" if scene.lifts else f"{len(scene.segments)} segments"
    return " ".join(program.split()) or from_file


def sampled(motion: Motion, steps: int = STEPS) -> "tuple[list[float], list[list[float]]]":
    """Angles and the four curves, zone by zone, broken between zones where any of them may jump.

    `steps`: steps on each zone. Returns angles, and s, v, a, j at them; NaN separates the zones.
    """
    import numpy as np

    t = np.linspace(0.0, 1.0, steps + 1)
    angles: list[float] = []
    columns: list[list[float]] = [[], [], [], []]
    for index, zone in enumerate(motion.zones):
        angles += (zone.start + (zone.end - zone.start) * t).tolist() + [zone.end]
        for column, values in zip(columns, motion.in_zone(index, t), strict=True):
            column += values.tolist() + [nan]
    return angles, columns


def bands(motion: Motion, order: int) -> "tuple[Band, ...]":
    """Bands for the moving segments; only the first panel has them in its legend."""
    moving = [i for i, span in enumerate(motion.segments) if span.law is not None]
    return tuple(
        Band(motion.joints[i], motion.joints[i + 1], "follower moves" if order == 0 and i == moving[0] else "")
        for i in moving
    )


def one_rise(result: Rise, law: LawName, lift: float, span: float, **inputs: "Any") -> Picture:
    """Draw one rise: lift, velocity, acceleration and jerk, with the requested points.

    `lift`: the lift [m]; `span`: the span [rad]. Returns four panels over the cam angle.
    """
    inputs = {key: value for key, value in inputs.items() if key not in ("at", "count", "shaft_speed")}
    dense = rise(law=law, lift=lift, span=span, count=401, **inputs).points
    angles = [point.angle for point in dense]
    requested = [point.angle for point in result.points]
    panels = []
    for name, kind in LENGTHS:
        curve = Curve(angles, [getattr(point, name) for point in dense])
        points = Curve(requested, [getattr(point, name) for point in result.points], style="points")
        panels.append(Panel(Axis("cam angle θ", Angle, ends=(0.0, span)), Axis(SYMBOLS[name], kind), (curve, points)))
    title = worded("Rise of {lift} in {span}, {law}", lift=(lift, Coordinate), span=(span, Angle), law=str(law))
    return Picture(tuple(panels), title)
