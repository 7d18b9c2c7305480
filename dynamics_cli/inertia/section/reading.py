"""Effect on a section of the rounding of typed coordinates to doubles, before the exact arithmetic."""

from math import fsum

from dynamics_cli.records import Advice, Condition

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.section.contours import Contour

UNIT_ROUNDOFF = 2.0**-53
# A share of a result that the rounding of its inputs may change without a word.
SILENT = 1e-13
# Which integrals over the outline bound the change of which result.
_RESULTS = {
    "area": 0, "centroidal.ix": 1, "centroidal.iy": 2, "centroidal.polar": 3, "principal.i1": 3, "principal.i2": 3,
}  # fmt: skip


def conditions(
    shapes: "list[Contour]", unit: int, centroid: "tuple[float, float]", values: "dict[str, float]"
) -> "tuple[Condition, ...]":
    """Relative changes of results per relative change of the coordinates, in the worst case.

    A side whose ends move by p and q sweeps at most an area of (|p × e| + |q × e|)/2; a moment changes by this area
    times its maximum weight along the side, and a shift of the centroid changes central moments in second order only.
    """
    rows = []
    for contour in shapes:
        for swept, ends in _sides(contour, unit):
            x2, y2 = (max((end[k] - centroid[k]) ** 2 for end in ends) for k in (0, 1))
            rows.append((swept, swept * y2, swept * x2, swept * (x2 + y2)))
    totals = [fsum(column) for column in zip(*rows, strict=True)]
    return tuple(
        Condition(name, "coordinates", totals[k] / values[name]) for name, k in _RESULTS.items() if values[name]
    )


def _sides(contour: "Contour", unit: int) -> "list[tuple[float, list[tuple[float, float]]]]":
    """The area that each side may sweep for relative changes of one, and its ends; a circle is four sides."""
    if contour.diameter:
        (x, y), d = (part / unit for part in contour.corners[0]), contour.diameter / unit
        around = [(x + 0.5 * d, y), (x - 0.5 * d, y), (x, y + 0.5 * d), (x, y - 0.5 * d)]
        return [(2.0 * d * (abs(x) + abs(y)) + 2.0 * d * d, around)]
    sides = []
    for a, b in contour.sides():
        ends = [(a[0] / unit, a[1] / unit), (b[0] / unit, b[1] / unit)]
        across, along = abs(a[1] - b[1]) / unit, abs(a[0] - b[0]) / unit
        sides.append((0.5 * sum(abs(x) * across + abs(y) * along for x, y in ends), ends))
    return sides


def advice(changes: "tuple[Condition, ...]") -> "tuple[Advice, ...]":
    """A warning where the rounding of the coordinates as they were typed may be seen in the results."""
    change = max((condition.value for condition in changes), default=0.0) * UNIT_ROUNDOFF
    if change <= SILENT:
        return ()
    message = f"coordinates are rounded to doubles when read, which may change moments by a share of {change:.2g}"
    return (Advice("coordinates-rounded", message, "caution", "count the coordinates from a corner of the section"),)
