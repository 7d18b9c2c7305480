"""Outlines of a cam with their proved deviation, and its tables."""

from math import pi

import numpy as np

from dynamics_cli.cam.export.path import Path
from dynamics_cli.cam.export.records import LiftPoint, PolarPoint, SwingPoint
from dynamics_cli.cam.geometry.contact import Geometry, check_speed, turned_back
from dynamics_cli.cam.program.pieces import sample
from dynamics_cli.errors import require
from dynamics_cli.numerics.fitting.outline import outlined
from dynamics_cli.outlines import Outline
from dynamics_cli.quantities import Angle, Size
from dynamics_cli.records import Columns

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def drawn(
    geometry: Geometry, motion: "Any", away: float, start_angle: float, form: str, tolerance: float, name: str
) -> Outline:
    """The curve as an outline whose proved deviation keeps the tolerance.

    `motion`: the program; `away`: distance of the curve from the contact, into the follower [m]; `start_angle`:
    rotation of the cam's frame; `form`: "arcs", "cubics" or "lines"; `tolerance`: largest deviation allowed;
    `name`: name of the outline. Raises InadmissibleError when the curve is undercut or broken, or the tolerance cannot
    be kept.
    """
    path = Path(geometry, motion, away=away, start_angle=start_angle)
    path.require_regular()
    points = _joints(path)
    return outlined(path, form, tolerance, points, name)


def _joints(path: Path) -> "Any":
    """The joints of the smooth pieces, evaluated from both sides; a refusal where the curve is broken."""
    after = np.stack(path.at(path.starts)[:2], axis=1)
    ends = [np.stack(path.at(path.ends[index : index + 1], index)[:2], axis=1) for index in range(path.ends.size)]
    before = np.roll(np.concatenate(ends), 1, axis=0)
    gap = np.hypot(*(after - before).T)
    worst = int(np.argmax(gap))
    require(
        gap[worst] <= 1e-9 * np.abs(after).max(),
        "the follower's velocity jumps at a cam angle of {place:6}: the curve breaks by {gap} there",
        place=(path.starts[worst], Angle),
        gap=(gap[worst], Size),
        code="velocity-jump",
        hint="choose laws whose velocities join, for example 3-4-5 or cycloidal in place of linear",
    )
    return after


def tables(geometry: Geometry, motion: "Any", away: float, start_angle: float, count: int) -> "tuple[Any, Any, Any]":
    """Exact points in polar coordinates, and the lift for a controller.

    `motion`: the program; `away`: distance of the curve from the contact [m]; `start_angle`: rotation of the cam's
    frame; `count`: points of a turn; the controller's table repeats the first at its end. Returns columns
    of points, of lifts or None, of swings or None.
    """
    theta = np.arange(count + 1) * (2.0 * pi / count)
    s, s1, s2 = sample(motion, theta, 2)
    check_speed(geometry, s1)
    touch = geometry.touch(s, s1, s2)
    (x, y), (nx, ny) = touch.point, touch.normal
    x, y = (x + away * nx)[:-1], (y + away * ny)[:-1]
    cos, sin = turned_back(count, start_angle, geometry.turn)
    x, y = x * cos + y * sin + 0.0, y * cos - x * sin + 0.0
    angle = np.arctan2(y, x)
    polar = Columns(
        PolarPoint, cam_angle=theta[:-1], polar_angle=np.where(angle < 0.0, angle + 2.0 * pi, angle),
        radius=np.hypot(x, y), x=x, y=y,
    )  # fmt: skip
    if geometry.oscillating:
        return polar, None, Columns(SwingPoint, cam_angle=theta, swing=s, velocity=s1, acceleration=s2)
    return polar, Columns(LiftPoint, cam_angle=theta, lift=s, velocity=s1, acceleration=s2), None
