"""What there is to look at in a pair of gears: the teeth at the pitch point, and sliding along the path of contact."""

from math import acos, atan, cos, isfinite, pi, sin, tan

from dynamics_cli.numerics.involute import involute
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Coordinate, Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.gear.pair_data import PairData

POINTS = 41
TEETH = (-1, 0, 1)
PATH = Axis("path of contact from the pitch point", Coordinate)
# Specific sliding beyond this leaves the panel: it has no bound at a base circle.
_STEEPEST = 6.0


def pair(
    made: "PairData", *, first: "Any", second: "Any", internal: bool = False, helix_angle: float = 0.0, **_: "Any"
) -> Picture:
    """The teeth about the pitch point in the transverse plane, and sliding over the path of contact."""
    return Picture(
        (_teeth(made, first.teeth, second.teeth, internal, helix_angle), *_sliding(made, internal)),
        f"{first.teeth} and {second.teeth} teeth",
    )


def _flank(base: float, low: float, high: float, half: "Any") -> "list[tuple[float, float]]":
    """Radii and half angles of one flank, from the base circle or the root up."""
    start = max(base, low)
    rows = []
    for k in range(POINTS):
        radius = start + (high - start) * k / (POINTS - 1)
        rows.append((radius, half(radius)))
    if low < base:
        rows.insert(0, (low, rows[0][1]))
    return rows


def _outline(
    centre: float, rows: "list[tuple[float, float]]", middle: float, pitch: float, label: str, role: int
) -> Curve:
    """Both flanks of three teeth as one line, joined along root and tip."""
    x: list[float] = []
    y: list[float] = []
    for tooth in TEETH:
        angle = middle + tooth * pitch
        up = [(radius, angle - half) for radius, half in rows]
        down = [(radius, angle + half) for radius, half in reversed(rows)]
        for radius, own in up + down:
            x.append(centre + radius * cos(own))
            y.append(radius * sin(own))
    return Curve(x, y, label, role=role)


def _teeth(made: "PairData", z1: int, z2: int, internal: bool, helix_angle: float) -> Panel:
    way = -1 if internal else 1
    cosine = (made.second_base_diameter + way * made.first_base_diameter) / (2.0 * made.reference_distance)
    angle = acos(min(1.0, cosine))
    lean = tan(angle) * cos(helix_angle)

    def half_of(teeth: int, base: float, shift: float, ring: bool) -> "Any":
        start = (0.5 * pi + (-2.0 if ring else 2.0) * shift * lean) / teeth + involute(angle)

        def half(radius: float) -> float:
            own = start - involute(acos(min(1.0, base / radius)))
            return pi / teeth - own if ring else own

        return half

    one = half_of(z1, 0.5 * made.first_base_diameter, made.first_profile_shift, False)
    two = half_of(z2, 0.5 * made.second_base_diameter, made.second_profile_shift, internal)
    r1, r2 = 0.5 * made.first_working_diameter, 0.5 * made.second_working_diameter
    own = _flank(0.5 * made.first_base_diameter, 0.5 * made.first_root_diameter, 0.5 * made.first_tip_diameter, one)
    ends = 0.5 * made.second_root_diameter, 0.5 * made.second_tip_diameter
    mate = _flank(0.5 * made.second_base_diameter, min(ends), max(ends), two)
    # a ring's tooth is joined along its tip, which is its smaller radius
    mate = mate[::-1] if internal else mate
    centre = -made.centre_distance if internal else made.centre_distance
    middle = two(r2) if internal else pi - two(r2)
    work = made.working_pressure_angle
    ends_of_path = [point.path for point in (made.points[0], made.points[-1])]
    line = Curve(
        [r1 - s * sin(work) for s in ends_of_path], [s * cos(work) for s in ends_of_path], "path of contact", "thin"
    )
    items: list[Any] = [
        _outline(0.0, own, -one(r1), 2.0 * pi / z1, "first", 0),
        _outline(centre, mate, middle, 2.0 * pi / z2, "second", 1),
        _arc(0.0, r1, 0.0, 3.0 * pi / z1),
        _arc(centre, r2, 0.0 if internal else pi, 3.0 * pi / z2),
        line,
        Mark(r1, 0.0, "C"),
    ]
    across = Axis("from the first axis", Coordinate)
    return Panel(across, Axis("across", Coordinate), tuple(items), "teeth at the pitch point", equal=True)


def _arc(centre: float, radius: float, middle: float, half: float) -> Curve:
    angles = [middle - half + 2.0 * half * k / (POINTS - 1) for k in range(POINTS)]
    return Curve([centre + radius * cos(a) for a in angles], [radius * sin(a) for a in angles], "", "dotted", role=2)


def _sliding(made: "PairData", internal: bool) -> "tuple[Panel, Panel]":
    """Sliding factor and specific sliding, with the points A to E."""
    start, end = made.points[0], made.points[-1]
    pitch = made.points[2]
    u = -made.ratio if internal else made.ratio
    other = -pitch.second_curvature if internal else pitch.second_curvature
    steps = [start.path + (end.path - start.path) * k / (4 * POINTS) for k in range(4 * POINTS + 1)]
    slope = 2.0 * (1.0 + 1.0 / u) / made.first_working_diameter
    # Lines without names: in the legend they would all look alike, so the points are named on the curve.
    bands: tuple[Any, ...] = tuple(Band(point.path, point.path) for point in made.points)
    names = tuple(Mark(point.path, slope * point.path, point.point) for point in made.points)
    factor = Panel(
        PATH,
        Axis("sliding over pitch line velocity", Ratio),
        (Curve(steps, [slope * s for s in steps], role=0), *bands, *names),
    )
    own = [_bounded(s * (1.0 + 1.0 / u), pitch.first_curvature + s) for s in steps]
    mate = [_bounded(-s * (1.0 + u), other - s) for s in steps]
    reach = max(abs(value) for value in own + mate if isfinite(value))
    low = tuple(Mark(point.path, -reach, point.point) for point in made.points)
    both = (Curve(steps, own, "first", role=0), Curve(steps, mate, "second", role=1), *bands, *low)
    return factor, Panel(PATH, Axis("specific sliding", Ratio), both)


def _bounded(above: float, below: float) -> float:
    """The quotient, or a gap in the line where it leaves the panel."""
    value = above / below if below else float("nan")
    return value if isfinite(value) and abs(value) <= _STEEPEST else float("nan")


def involute_curve(made: "Any", *, base_diameter: "float | None" = None, **_: "Any") -> Picture:
    """The involute from its base circle to the point asked for, or the involute function when there is no circle."""
    if base_diameter is None:
        angles = [made.pressure_angle * k / (POINTS - 1) for k in range(POINTS)]
        from dynamics_cli.quantities import Angle

        items = (Curve(angles, [involute(a) for a in angles]), Mark(made.pressure_angle, made.involute, "inv α"))
        return Picture(
            (Panel(Axis("pressure angle", Angle), Axis("involute function", Ratio), items),), "involute function"
        )
    base = 0.5 * base_diameter
    rolls = [made.roll_angle * k / (POINTS - 1) for k in range(POINTS)]
    radii = [base * (1.0 + t * t) ** 0.5 for t in rolls]
    polar = [t - atan(t) for t in rolls]
    x, y = (
        [r * cos(p) for r, p in zip(radii, polar, strict=True)],
        [r * sin(p) for r, p in zip(radii, polar, strict=True)],
    )
    string = Curve([base * cos(rolls[-1]), x[-1]], [base * sin(rolls[-1]), y[-1]], "string", "thin")
    items2 = (Curve(x, y, "involute"), _arc(0.0, base, 0.5 * rolls[-1], 0.5 * rolls[-1]), string)
    across = Axis("from the centre", Coordinate)
    return Picture((Panel(across, Axis("across", Coordinate), items2, equal=True),), "an involute")
