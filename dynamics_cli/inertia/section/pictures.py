"""A section with its centroid and principal axes, and Mohr's circle of its second moments."""

from math import cos, hypot, pi, sin

from dynamics_cli.inertia.section.contours import contours
from dynamics_cli.pictures import Arrow, Axis, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Coordinate, SecondMoment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.section.contours import Contour
    from dynamics_cli.inertia.section.results import SectionProperties
    from dynamics_cli.inertia.section.task import Drawn

STEPS = 96
# Points of Mohr's circle this close, relative to its radius, share a label.
CLOSE = 0.06
# A circle this small beside its distance from zero is a point.
SHRUNK = 1e-6
MATERIAL, CUT, AXES = 0, 1, 2


def section_picture(answer: "SectionProperties", contours: "Drawn") -> Picture:
    """The section and its principal axes; Mohr's circle."""
    shape = _shape(answer, contours)
    return Picture((shape, _mohr(answer)), columns=2)


def _shape(answer: "SectionProperties", drawn: "Drawn") -> Panel:
    shapes, unit = contours(drawn.polygon, drawn.pieces, drawn.holes, drawn.bars)
    items: list[Curve | Mark | Arrow] = []
    fillets = {contour.corners[0]: contour for contour in shapes if contour.way}
    for contour in shapes:
        if contour.way:
            continue
        points = [(x / unit, y / unit) for x, y in contour.corners]
        if contour.diameter:
            (x0, y0), r = points[0], 0.5 * (contour.diameter / unit)
            points = [(x0 + r * cos(t), y0 + r * sin(t)) for t in _turns()]
        else:
            points = [
                point
                for corner in zip([contour.corners[-1], *contour.corners], contour.corners, strict=False)
                for point in _rounded(*corner, fillets, unit)
            ]
            points.append(points[0])
        style, role = ("solid", MATERIAL) if contour.sign > 0 else ("dashed", CUT)
        items.append(Curve([x for x, _ in points], [y for _, y in points], "", style, role))  # type: ignore[arg-type]
    for length, angle, name in (
        (answer.gyration.r2, answer.principal.angle, "1"),
        (answer.gyration.r1, answer.principal.angle + 0.5 * pi, "2"),
    ):
        items.append(Arrow(answer.x, answer.y, 1.5 * length * cos(angle), 1.5 * length * sin(angle), name, AXES))
    items.append(Mark(answer.x, answer.y, "C", (-6.0, -10.0)))
    return Panel(Axis("x", Coordinate), Axis("y", Coordinate), tuple(items), "section and principal axes", equal=True)


def _rounded(
    before: "tuple[int, int]", corner: "tuple[int, int]", fillets: "dict[tuple[int, int], Contour]", unit: int
) -> "list[tuple[float, float]]":
    """A corner, or the points of its fillet in the order of the sides."""
    x0, y0 = corner[0] / unit, corner[1] / unit
    fillet = fillets.get(corner)
    if fillet is None or fillet.way is None:
        return [(x0, y0)]
    (i, j), r = fillet.way, fillet.radius / unit
    turns = [t for t in _turns() if t <= 0.5 * pi]
    arc = [(x0 + i * r * (1.0 - cos(t)), y0 + j * r * (1.0 - sin(t))) for t in turns]
    return arc[::-1] if before[1] == corner[1] else arc


def _mohr(answer: "SectionProperties") -> Panel:
    """The circle of (I, product) over all directions: its diameter joins the points of x and of y."""
    about_centroid, main = answer.centroidal, answer.principal
    centre, radius = 0.5 * (main.i1 + main.i2), 0.5 * (main.i1 - main.i2)
    axes = Axis("second moment", SecondMoment), Axis("product", SecondMoment)
    if radius <= SHRUNK * centre:
        # A single point has no extent to set the scale: the axis starts at zero.
        alike = Curve([0.0, centre], [0.0, 0.0], style="thin"), Mark(centre, 0.0, "every direction")
        return Panel(*axes, alike, "Mohr's circle", equal=True)
    items: tuple[Curve | Mark, ...] = (
        Curve([centre + radius * cos(t) for t in _turns()], [radius * sin(t) for t in _turns()]),
        Curve([about_centroid.ix, about_centroid.iy], [about_centroid.ixy, -about_centroid.ixy], style="dashed"),
        *_marks(answer, radius),
    )
    return Panel(*axes, items, "Mohr's circle", equal=True)


def _marks(answer: "SectionProperties", radius: float) -> "list[Mark]":
    """The directions x and y and the principal ones, named together where they fall together."""
    about_centroid, main = answer.centroidal, answer.principal
    directions = [(about_centroid.ix, about_centroid.ixy, "x"), (about_centroid.iy, -about_centroid.ixy, "y")]
    out = []
    for value, name in ((main.i1, "I₁"), (main.i2, "I₂")):
        near = [word for x, y, word in directions if hypot(x - value, y) < CLOSE * radius]
        directions = [item for item in directions if item[2] not in near]
        out.append(Mark(value, 0.0, ", ".join((name, *near))))
    return out + [Mark(*item) for item in directions]


def _turns() -> "list[float]":
    return [2.0 * pi * k / STEPS for k in range(STEPS + 1)]
