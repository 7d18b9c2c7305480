"""Gears, teeth and racks as outlines: the chain of one tooth repeated, every piece starting where the last one ends."""

from math import cos, pi, sin, tan

from dynamics_cli.errors import require
from dynamics_cli.gear.single.flanks import _NO_LAND, Chain, ToothForm, fillet_centre, flank
from dynamics_cli.outlines import Arc, Line, Outline, Points, arc_about, circle

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.gear.single.trochoid import Cutter
    from dynamics_cli.outlines import Piece

    Array = NDArray[Any]

# Coordinates are rounded too; the bound of a chord includes that.
_ROUNDING = 8.0 * 2.0**-53
# More would take minutes and gigabytes.
MOST_POINTS = 2_000_000
MOST_RACK_TEETH = 100_000
# How far centre lines extend beyond a gear.
BEYOND = 1.1


def chain_points(shape: ToothForm, chain: Chain, count: int) -> "tuple[Array, Array]":
    """Coordinates of the chains of `count` teeth, right flank upwards and left flank downwards, one row a tooth."""
    import numpy as np

    angle = np.concatenate([-chain.angle, chain.angle[::-1]])
    radius = np.concatenate([chain.radius, chain.radius[::-1]])
    centre = 0.5 * pi + 2.0 * pi / shape.teeth * np.arange(count)
    turned = centre[:, None] + angle
    return radius * np.cos(turned), radius * np.sin(turned)


def gear_outline(
    shape: ToothForm, tolerance: float, *, teeth: int | None = None, arcs: bool = False
) -> tuple[Outline, int]:
    """The outline of the whole gear, or of `teeth` of its teeth (open), and its number of points.

    Its curves are chords, or `arcs` that join with one direction; chords if arcs cannot keep the tolerance.

    Tooth 0 points along +y. An external gear runs anticlockwise: root arc, trochoid, involute, tip arc, involute,
    trochoid, tooth after tooth. An internal gear has fillet arcs in place of trochoids.
    """
    chain = _chain(shape, tolerance, arcs=arcs)
    count = shape.teeth if teeth is None else teeth
    require(
        0 < count <= shape.teeth,
        "the gear has {teeth} teeth: {count} cannot be drawn",
        teeth=shape.teeth,
        count=count,
        code="teeth",
    )
    require(
        2 * count * len(chain.angle) <= MOST_POINTS,
        "{count} teeth need {points} points at this tolerance",
        count=count,
        points=2 * count * len(chain.angle),
        code="too-many-points",
        hint="draw fewer teeth with --only-teeth, or give a larger tolerance",
    )
    xs, ys = chain_points(shape, chain, count)
    rows = [tuple(zip(x, y, strict=True)) for x, y in zip(xs.tolist(), ys.tolist(), strict=True)]
    closed = teeth is None
    marks = _Marks(shape, chain)
    pieces: list[Piece] = []
    starts = [_tooth_start(shape, marks, row, index) for index, row in enumerate(rows)]
    for index, row in enumerate(rows):
        following = starts[(index + 1) % len(rows)] if closed or index + 1 < len(rows) else None
        pieces += _tooth(shape, marks, row, index, starts[index], following)
    deviation = chain.deviation + _ROUNDING * max(shape.root, shape.tip)
    outline = Outline(tuple(pieces), closed=closed, deviation=deviation, name="profile" if closed else "tooth")
    return outline, sum(len(row) for row in rows)


def _chain(shape: ToothForm, tolerance: float, *, arcs: bool) -> Chain:
    if arcs:
        from dynamics_cli.gear.flank_arcs import flank_arcs

        flanks = flank_arcs(shape, tolerance)
        if flanks is not None:
            return flanks
    return flank(shape, tolerance)


def bore_outline(diameter: float) -> Outline:
    """The circle of a bore."""
    radius = 0.5 * diameter
    return Outline(circle((0.0, 0.0), radius), closed=True, deviation=_ROUNDING * radius, name="bore")


def construction_lines(pitch_diameter: float, outer_diameter: float) -> tuple[Outline, ...]:
    """The pitch circle and the two centre lines of a gear, each in a layer of that name."""
    radius, reach = 0.5 * pitch_diameter, 0.5 * BEYOND * outer_diameter
    return (
        Outline(circle((0.0, 0.0), radius), closed=True, deviation=_ROUNDING * radius, name="pitch circle"),
        Outline((Line((-reach, 0.0), (reach, 0.0)),), closed=False, deviation=0.0, name="centre lines"),
        Outline((Line((0.0, -reach), (0.0, reach)),), closed=False, deviation=0.0, name="centre lines"),
    )


class _Marks:
    """Bulges of the arcs, and where chains are cut."""

    def __init__(self, shape: ToothForm, chain: Chain) -> None:
        self.joint = chain.joint
        self.bulges = None if chain.bulge is None else [*chain.bulge.tolist(), *reversed(chain.bulge.tolist())]
        self.size = len(chain.angle)
        tip = float(chain.angle[-1])
        self.tip_land = tip > _NO_LAND
        self.tip_bulge = tan(0.5 * tip)
        if shape.internal:
            self.root_angle = fillet_centre(shape)[1]
            land = pi / shape.teeth - self.root_angle
            self.fillet_radius, self.fillet_turn = _fillet_turn(shape)
        else:
            self.root_angle = float(chain.angle[0])
            land = pi / shape.teeth - self.root_angle
        self.root_land = land > _NO_LAND
        self.root_bulge = tan(0.5 * land)

    def run(self, points: "Any", first: int) -> "list[Piece]":
        """A part of a flank: chords, or the arcs from the one numbered `first`, right flank before left."""
        if self.bulges is None:
            return [Points(tuple(points))]
        return [Arc(points[k], points[k + 1], self.bulges[first + k]) for k in range(len(points) - 1)]


def _fillet_turn(shape: ToothForm) -> tuple[float, float]:
    """Radius of the fillet of an internal gear, and the tangent of a quarter of its angle."""
    from math import atan, sqrt

    centre = shape.root - shape.fillet
    reach = sqrt((centre - shape.base) * (centre + shape.base))
    # the fillet turns from the root circle, across the radius, to the normal of the involute
    turn = 0.5 * pi + atan(reach / shape.base) if shape.fillet else 0.0
    return shape.fillet, tan(0.25 * (pi - turn))


def _on_root(shape: ToothForm, marks: _Marks, index: int, side: float) -> tuple[float, float]:
    angle = 0.5 * pi + 2.0 * pi / shape.teeth * index + side * marks.root_angle
    return shape.root * cos(angle), shape.root * sin(angle)


def _tooth_start(shape: ToothForm, marks: _Marks, row: "tuple[Any, ...]", index: int) -> "tuple[float, float]":
    """The point where a tooth leaves the root circle."""
    return _on_root(shape, marks, index, -1.0) if shape.internal else row[0]


def _tooth(
    shape: ToothForm,
    marks: _Marks,
    row: "tuple[Any, ...]",
    index: int,
    start: "tuple[float, float]",
    following: "tuple[float, float] | None",
) -> "list[Piece]":
    size, joint = marks.size, marks.joint
    pieces: list[Piece] = []
    top = row[size] if marks.tip_land else row[size - 1]
    left_flank = (top, *row[size + 1 :])
    end = row[-1]
    if not marks.root_land and following is not None:
        end = following
    if shape.internal:
        # material is outside: the right side of the tooth comes first
        pieces.append(Arc(start, row[0], marks.fillet_turn))
        pieces += marks.run(row[:size], 0)
        if marks.tip_land:
            pieces.append(Arc(row[size - 1], top, marks.tip_bulge))
        pieces += marks.run(left_flank, size - 1)
        end = _on_root(shape, marks, index, 1.0) if marks.root_land or following is None else following
        pieces.append(Arc(row[-1], end, marks.fillet_turn))
    else:
        pieces += marks.run(row[: joint + 1], 0)
        pieces += marks.run(row[joint:size], joint)
        if marks.tip_land:
            pieces.append(Arc(row[size - 1], top, marks.tip_bulge))
        cut = size - joint
        pieces += marks.run(left_flank[:cut], size - 1)
        pieces += marks.run((*left_flank[cut - 1 : -1], end), size + cut - 2)
    if following is not None and marks.root_land:
        pieces.append(Arc(end, following, marks.root_bulge))
    return pieces


def rack_outline(cutter: "Cutter", module: float, addendum: float, teeth: int) -> Outline:
    """The profile of a rack with `teeth` teeth along x, its reference line on y = 0, exact but for rounding.

    Flanks are lines, corners arcs of the normal plane; a helical rack is drawn in its normal plane, where its corners
    are arcs.
    """
    from math import cos as cosine
    from math import sin as sine

    alpha, rho = cutter.pressure_angle, cutter.tip_radius
    require(
        cutter.helix_angle == 0.0,
        "a helical rack is drawn in its normal plane: leave the helix angle out",
        code="helix",
    )
    require(
        teeth <= MOST_RACK_TEETH,
        "{teeth} teeth of a rack are too many to draw: at most {most}",
        teeth=teeth,
        most=MOST_RACK_TEETH,
        code="too-many-points",
        hint="draw fewer teeth; they repeat",
    )
    slope = sine(alpha) / cosine(alpha)
    tip_half = 0.25 * pi - addendum * slope
    require(tip_half > 0.0, "the rack's teeth are pointed below their tips", code="pointed")
    root_half = 0.5 * pi - cutter.corner_offset
    depth = cutter.dedendum - rho * (1.0 - sine(alpha))
    pieces: list[Piece] = []
    last = None
    for index in range(teeth):
        x = pi * index
        right = [(x + tip_half, addendum), (x + 0.25 * pi + depth * slope, -depth), (x + root_half, -cutter.dedendum)]
        if rho == 0.0:
            # flank and root land share one corner to the bit
            right[1] = right[2]
        left_flank = [(2.0 * x - px, py) for px, py in reversed(right)]
        tooth = [(module * px, module * py) for px, py in left_flank + right]
        if last is not None and abs(last[0] - tooth[0][0]) > _NO_LAND * module:
            pieces.append(Line(last, tooth[0]))
        elif last is not None:
            tooth[0] = last
        pieces += _rack_tooth(tooth, module * x, module * cutter.corner_offset, -module * (cutter.dedendum - rho), rho)
        last = tooth[-1]
    return Outline(tuple(pieces), closed=False, deviation=_ROUNDING * module * pi * (teeth + 1), name="rack")


def _rack_tooth(tooth: "list[tuple[float, float]]", x: float, offset: float, depth: float, rho: float) -> "list[Piece]":
    a, b, c, d, e, f = tooth
    half = a[0]
    ends: list[Piece] = [Line(b, c), Line(c, d), Line(d, e)]
    if rho == 0.0 or a == b:
        return ends
    # the corners' centres are above the ends of the root land
    return [arc_about(a, b, (half, depth), clockwise=False), *ends, arc_about(e, f, (f[0], depth), clockwise=False)]
