"""Pictures of cam motion: lift, velocity, acceleration and jerk over the turn, and peak factors."""

from math import nan, pi

from dynamics_cli.cam.laws import LawName
from dynamics_cli.cam.motion import Motion
from dynamics_cli.cam.program import Program, motion_of
from dynamics_cli.cam.revolution_records import Revolution
from dynamics_cli.cam.rises import Rise, rise
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


def svaj(result: Revolution, scene: Program, program: str = "", **given: "Any") -> Picture:
    """Draw lift, velocity, acceleration and jerk one below another; a jump is a gap.

    Parameters
    ----------
    result : Revolution
        What `cam motion` found.
    scene : Program
        The program from a file.
    program : str
        The program in one line.
    **given
        The task's other parameters.

    Returns
    -------
    Picture
        Four panels over the cam angle, the segments shaded in turn.
    """
    del given
    motion = motion_of(scene, program)
    angles, columns = sampled(motion)
    axes = SWINGS if motion.swing else LENGTHS
    extremes = (result.lift, result.velocity, result.acceleration, result.jerk)
    panels = []
    for order, (name, kind) in enumerate(axes):
        found = extremes[order]
        marks = () if found is None else (Mark(found.greatest_at, found.greatest), Mark(found.least_at, found.least))
        panels.append(
            Panel(
                Axis("cam angle", Angle, ends=(motion.joints[0], motion.joints[-1]), step=pi / 6.0),
                Axis(name, kind),
                (*bands(motion, order), Curve(angles, columns[order]), *marks),
            )
        )
    return Picture(tuple(panels), f"Cam motion, continuity {result.continuity}")


def sampled(motion: Motion, steps: int = STEPS) -> "tuple[list[float], list[list[float]]]":
    """Angles and the four curves, zone by zone, broken between zones where any of them may jump.

    Parameters
    ----------
    motion : Motion
        The motion.
    steps : int
        Steps on each zone.

    Returns
    -------
    (list of float, list of list of float)
        Angles, and s, v, a, j at them; NaN parts the zones.
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
    """Every segment that moves; the legend of the first panel says so once."""
    moving = [i for i, span in enumerate(motion.segments) if span.law is not None]
    return tuple(
        Band(motion.joints[i], motion.joints[i + 1], "follower moves" if order == 0 and i == moving[0] else "")
        for i in moving
    )


def one_rise(result: Rise, law: LawName, lift: float, span: float, **given: "Any") -> Picture:
    """Draw one rise: lift, velocity, acceleration and jerk, with the points asked for.

    Parameters
    ----------
    result : Rise
        What `cam rise` found.
    law : LawName
        The law.
    lift : float
        The lift [m].
    span : float
        The span [rad].
    **given
        The task's other parameters.

    Returns
    -------
    Picture
        Four panels over the cam angle.
    """
    given = {key: value for key, value in given.items() if key not in ("at", "count", "shaft_speed")}
    dense = rise(law=law, lift=lift, span=span, count=401, **given).points
    angles = [point.angle for point in dense]
    asked = [point.angle for point in result.points]
    panels = []
    for name, kind in LENGTHS:
        curve = Curve(angles, [getattr(point, name) for point in dense], str(law) if name == "lift" else "")
        points = Curve(asked, [getattr(point, name) for point in result.points], style="points")
        panels.append(Panel(Axis("cam angle", Angle), Axis(name, kind), (curve, points)))
    return Picture(tuple(panels), f"Rise by the law {law}")
