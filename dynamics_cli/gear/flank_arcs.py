"""A flank of a gear as tangent arcs, as few as the tolerance allows, with proved distance from the exact curve.

Between two close points of a curve that turns one way, curve and chord differ at most by the height of the triangle of
chord and end tangents, and arc and chord by the arc's rise. The distance of the points from their arc plus these two
bounds the distance of the curve.
"""

from abc import ABC, abstractmethod
from math import pi

import numpy as np

from dynamics_cli.gear.single.flanks import Chain, ToothForm, trochoid_points
from dynamics_cli.numerics.fitting.pieces import circle_distance, fit

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Share of the tolerance used by the fit; the proof needs the rest.
SHARE = 0.9
TRIES = 4
# Points of the proof on every arc.
POINTS = 65


class _Curve(ABC):
    """A smooth piece of a flank over one parameter, with the interface that fitting uses."""

    still = (False,)
    straight = ()
    turn = 1.0

    def __init__(self, start: float, end: float) -> None:
        self.starts, self.ends = (start,), (end,)

    def on(self, _: int) -> "_Curve":
        """Itself: a flank curve is a single smooth piece."""
        return self

    def at(self, place: "Any") -> "tuple[Any, ...]":
        """Point, unit direction and speed."""
        x, y, direction, speed = self.course(np.asarray(place))
        return x, y, np.sin(direction), np.cos(direction), speed

    @abstractmethod
    def course(self, place: "Any") -> "tuple[Any, ...]":
        """Point, direction clockwise from the tooth's centreline, and speed."""


class _Involute(_Curve):
    """z′ = r_b t e(ψ_b − t) of the roll angle t; of an internal gear mirrored, and from its root to its tip."""

    def __init__(self, form: ToothForm) -> None:
        self.form = form
        low, high = form.roll(max(form.form, form.base)), form.roll(form.tip)
        if form.junction is not None:
            low = form.junction.roll
        super().__init__(*((-low, -high) if form.internal else (low, high)))

    def course(self, place: "Any") -> "tuple[Any, ...]":
        """At roll angles; the speed is r_b t."""
        base, roll = self.form.base, np.abs(place)
        radius = base * np.sqrt(1.0 + roll * roll)
        angle, direction = self.form.half_base - (roll - np.arctan(roll)), self.form.half_base - roll
        if self.form.internal:
            angle, direction = pi / self.form.teeth - angle, pi / self.form.teeth - direction + pi
        return radius * np.sin(angle), radius * np.cos(angle), direction, base * roll


class _Trochoid(_Curve):
    """The root that the rack's corner cuts, by the direction of the corner's normal, backwards: root first."""

    def __init__(self, form: ToothForm) -> None:
        assert form.junction is not None
        self.form = form
        super().__init__(-0.5 * pi, -form.junction.direction)

    def course(self, place: "Any") -> "tuple[Any, ...]":
        """At minus the directions of the corner's normal; the speed is only nominal."""
        assert self.form.cutter is not None
        radius, angle, direction = trochoid_points(self.form.cutter, -place)
        radius, angle = self.form.module * radius, pi / self.form.teeth - angle
        return radius * np.sin(angle), radius * np.cos(angle), pi / self.form.teeth + direction, np.ones_like(radius)


def flank_arcs(form: ToothForm, tolerance: float) -> "Chain | None":
    """Give a flank as arcs within the tolerance; None if arcs cannot reach it.

    The ends of the flank, and its joint of root curve and involute, are the radii that the form states.
    """
    curves: list[_Curve] = [_Involute(form)]
    if not form.internal:
        curves.insert(0, _Trochoid(form))
    parts = [part for part in (_fitted(curve, tolerance) for curve in curves) if part is not None]
    if len(parts) < len(curves):
        return None
    x, y, bulge, deviation = parts[0]
    joint = 0
    if len(parts) > 1:
        more_x, more_y, more, off = parts[1]
        joint = bulge.size
        x, y = np.concatenate([x[:-1], more_x]), np.concatenate([y[:-1], more_y])
        bulge, deviation = np.concatenate([bulge, more]), max(deviation, off)
    radius, angle = np.hypot(x, y), np.arctan2(x, y)
    if not form.internal:
        radius[0] = form.root
    radius[joint], radius[-1] = form.form, form.tip
    return Chain(radius, angle, joint, deviation, bulge)


def _fitted(curve: _Curve, tolerance: float) -> "tuple[Any, Any, Any, float] | None":
    from dynamics_cli.errors import InadmissibleError

    aim = SHARE * tolerance
    for _ in range(TRIES):
        try:
            ((_, places, bulge),) = fit(curve, "arcs", aim)  # type: ignore[arg-type]
        except InadmissibleError:
            return None
        off = float(np.max(_deviations(curve, places, bulge)))
        if off <= tolerance:
            x, y = curve.at(places)[:2]
            return x, y, bulge, off
        aim *= 0.7
    return None


def _deviations(curve: _Curve, places: "Any", bulge: "Any") -> "Any":
    """The proved distance of the curve from each of its arcs."""
    x, y = curve.at(places)[:2]
    chord = np.hypot(np.diff(x), np.diff(y))
    inner = places[:-1, None] + np.diff(places)[:, None] * np.linspace(0.0, 1.0, POINTS)
    px, py, direction, _ = curve.course(inner)
    ends = (x[:-1, None], y[:-1, None], x[1:, None], y[1:, None])
    away = np.abs(circle_distance(*ends, bulge[:, None], px, py)[0]).max(axis=1)
    step = np.hypot(np.diff(px), np.diff(py))
    turns = np.diff(direction)
    one_way = (turns >= 0.0).all(axis=1) | (turns <= 0.0).all(axis=1)
    turned = np.abs(turns)
    bounded = one_way & (turned < 1.0).all(axis=1)
    triangle = np.where(bounded, (0.5 * step * np.tan(0.5 * turned)).max(axis=1), np.inf)
    # the rise of an arc of chord c and curvature κ: at most κc²/7 below a quarter turn
    curvature = 4.0 * np.abs(bulge) / (chord * (1.0 + bulge * bulge))
    return away + triangle + step.max(axis=1) ** 2 * curvature / 7.0
