"""Exact profiles of gears as ordered pieces: root arc, trochoid or fillet, involute, tip arc, sharing their end points.

Angles are measured from a tooth's centreline, radii in metres, in the transverse plane. A profile is a chain of points
of one tooth in polar form; a whole gear repeats the chain, and the arcs between the chains close it.
"""

from math import ceil, pi

from dynamics_cli.errors import require
from dynamics_cli.gear.single.trochoid import Cutter, Root
from dynamics_cli.numerics.elementary import atan, pi_beside, sqrt
from dynamics_cli.quantities import Annotated, Size
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# A root or tip land narrower than this share of a pitch counts as a point.
_NO_LAND = 1e-12
_MOST_POINTS = 2_000_000
# Steps of the first sampling of a trochoid.
_COARSE = 48


@record
class ToothForm:
    """One tooth, ready to be drawn or meshed; lengths in metres."""

    teeth: Annotated[int, "Number of teeth."]
    internal: Annotated[bool, "Whether the teeth point inwards."]
    module: Annotated[float, "Normal module [m]."]
    base: Annotated[float, "Base radius [m]."]
    tip: Annotated[float, "Tip radius [m]."]
    form: Annotated[float, "Radius where the involute begins above the root [m]."]
    root: Annotated[float, "Root radius [m]."]
    half_base: Annotated[
        float,
        "Half angle between the involutes of one tooth (of one space of an internal gear) at the base circle [rad].",
    ]
    cutter: Annotated[Cutter | None, "The rack that cuts the root of an external gear."] = None
    junction: Annotated[Root | None, "Where its trochoid meets the involute."] = None
    fillet: Annotated[float, "Radius of the fillet of an internal gear [m]."] = 0.0

    def length(self, radius: float) -> float:
        """Length of the line of action from the base circle to a radius."""
        return sqrt((radius - self.base) * (radius + self.base))

    def roll(self, radius: float) -> float:
        """Roll angle t of the involute at a radius."""
        return self.length(radius) / self.base

    def half_angle(self, roll: float) -> float:
        """Half the angle of the tooth (of the space of an internal gear) where the involute has this roll angle."""
        return self.half_base - (roll - atan(roll))


def fillet_centre(shape: ToothForm) -> tuple[float, float]:
    """Radius, and angle from the centreline of the tooth, of the fillet's centre of an internal gear."""
    centre = shape.root - shape.fillet
    ratio = centre / shape.base
    t = sqrt((ratio - 1.0) * (ratio + 1.0))
    half = shape.half_base - (t - atan(t)) - shape.fillet / shape.base
    require(
        half >= 0.0,
        "a fillet of {fillet:6} is wider than the tooth space",
        fillet=(shape.fillet, Size),
        code="fillet",
        hint="give a smaller one",
    )
    return centre, pi_beside(half) / shape.teeth - half


@record
class Chain:
    """One flank from root to tip in polar form, and the deviation of its chords."""

    radius: Annotated["Array", "Radii, root first [m]."]
    angle: Annotated["Array", "Angles from the tooth's centreline, positive [rad]."]
    joint: Annotated[int, "Index of the point where trochoid or fillet ends and the involute begins."]
    deviation: Annotated[float, "Proved bound on the distance of the chords, or arcs, from the exact curves [m]."]
    bulge: Annotated["Array | None", "Bulges of the arcs between the points; None for chords."] = None


def flank(shape: ToothForm, tolerance: float) -> Chain:
    """Sample one flank so that no chord leaves the exact curve by more than `tolerance`, with the bound proved.

    Involute: |P''| in u² is r_b/(4u), so a chord deviates by at most (u₁² − u₀²)²·r_b/(32 u₀); near the base circle by
    (u₁ − u₀)²·r_b √(1 + u₁²)/8, or the height of the triangle of chord and end tangents. Trochoid: it turns one way
    only, so it lies in that triangle.
    """
    import numpy as np

    low, high, invert = shape.roll(max(shape.form, shape.base)), shape.roll(shape.tip), shape.internal
    if shape.junction is not None:
        low = shape.junction.roll
    rolls, off = _involute_rolls(shape.base, min(low, high), max(low, high), tolerance)
    if invert:
        rolls = rolls[::-1]
    radius = shape.base * np.sqrt(1.0 + rolls * rolls)
    half = shape.half_base - (rolls - np.arctan(rolls))
    # the ends are exactly the radii in the record
    radius[0], radius[-1] = shape.form, shape.tip
    if invert:
        return Chain(radius, pi / shape.teeth - half, 0, off)
    root_radius, root_angle, more = _trochoid(shape, tolerance)
    return Chain(
        np.concatenate([root_radius[:-1], radius]),
        np.concatenate([root_angle[:-1], half]),
        len(root_radius) - 1,
        max(off, more),
    )


def _involute_rolls(base: float, low: float, high: float, tolerance: float) -> "tuple[Array, float]":
    """Roll angles distributed so that all chords have the same deviation, and its proved bound."""
    import numpy as np

    first, last = low * sqrt(low), high * sqrt(high)
    count = max(2, ceil((last - first) * sqrt(base / (18.0 * tolerance))))
    while True:
        require(
            count < _MOST_POINTS,
            "a tolerance of {tolerance:3} needs too many points",
            tolerance=(tolerance, Size),
            code="tolerance",
        )
        steps = np.linspace(first, last, count + 1)
        rolls = np.cbrt(steps) ** 2
        rolls[0], rolls[-1] = low, high
        step = rolls[1:] - rolls[:-1]
        near = step * step * np.sqrt(1.0 + rolls[1:] * rolls[1:])
        rise = step * (rolls[1:] + rolls[:-1])
        far = 0.25 * rise * rise / np.maximum(rolls[:-1], 1e-300)
        # the triangle of chord and end tangents: the chord is at most as long as its arc r_b (t₁² − t₀²)/2
        corner = 2.0 * rise * np.tan(0.5 * np.minimum(step, 1.0)) + (step > 1.0) * 1e300
        off = 0.125 * base * float(np.max(np.minimum(np.minimum(near, far), corner)))
        if off <= tolerance:
            return rolls, off
        count += 1 + count // 8


def _trochoid(shape: ToothForm, tolerance: float) -> "tuple[Array, Array, float]":
    """The trochoid from the root circle to the involute: radii, angles, and the proved bound of its chords."""
    import numpy as np

    cutter, junction = shape.cutter, shape.junction
    assert cutter is not None
    assert junction is not None
    coarse = np.linspace(0.5 * pi, junction.direction, _COARSE + 1)
    heights = shape.module * _triangles(*trochoid_points(cutter, coarse))
    # where the coarse triangles are high the chords are short: all deviate equally
    spread = np.concatenate([[0.0], np.cumsum(np.sqrt(heights))])
    count = max(2, ceil(1.05 * float(spread[-1]) / sqrt(tolerance)))
    while True:
        require(
            count < _MOST_POINTS,
            "a tolerance of {tolerance:3} needs too many points",
            tolerance=(tolerance, Size),
            code="tolerance",
        )
        theta = np.interp(np.linspace(0.0, spread[-1], count + 1), spread, coarse)
        radius, angle, direction = trochoid_points(cutter, theta)
        off = shape.module * float(np.max(_triangles(radius, angle, direction)))
        if off <= tolerance:
            break
        count += 1 + count // 8
    radius, angle = shape.module * radius, pi / shape.teeth - angle
    radius[0], radius[-1] = shape.root, shape.form
    angle[-1] = shape.half_angle(junction.roll)
    return radius, angle, off


def trochoid_points(cutter: Cutter, theta: "Array") -> "tuple[Array, Array, Array]":
    """Radii in modules, half angles of the space, and directions of the curve, at directions θ of its normal."""
    import numpy as np

    sine, cosine = np.sin(theta), np.cos(theta)
    radius, excess = cutter.pitch_radius, cutter.stretch * cutter.stretch - 1.0
    widening = np.sqrt(1.0 + excess * cosine * cosine)
    depth = cutter.corner_depth + cutter.tip_radius * sine / widening
    xi = radius * sine - depth / sine
    across = radius * cosine
    travel = cutter.corner_depth * cosine / sine - cutter.corner_offset - cutter.tip_radius * excess * cosine / widening
    turn = travel / radius
    return np.sqrt(across * across + xi * xi), theta - np.arctan2(xi, across) - turn, turn - theta


def _triangles(radius: "Array", angle: "Array", direction: "Array") -> "Array":
    """Heights of the triangles of chord and end tangents of a curve that turns one way; infinite if it does not."""
    import numpy as np

    steps = np.diff(direction)
    turned = np.abs(steps)
    if np.any(steps[1:] * steps[:-1] < 0.0) or np.any(turned > 1.0):
        return np.full(steps.shape, np.inf)
    away = np.hypot(np.diff(radius), 0.5 * (radius[1:] + radius[:-1]) * np.diff(angle))
    return 0.5 * away * np.tan(0.5 * turned)
