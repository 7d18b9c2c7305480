"""A motion from a table of cam angles and lifts: rows of equal lift are dwells, splines go through the others."""

from itertools import pairwise

from dynamics_cli.cam.laws.polynomials import slopes_through, spline
from dynamics_cli.cam.laws.rounded_points import ANGLES as ANGLE_UNITS
from dynamics_cli.cam.laws.rounded_points import LENGTHS as LENGTH_UNITS
from dynamics_cli.cam.laws.rounded_points import decimal_step
from dynamics_cli.cam.program.motion import Motion
from dynamics_cli.cam.program.parts import Exact, Span, from_radians, radians
from dynamics_cli.cam.program.text import ANGLES, LENGTHS, decimal
from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.rational import nearest, total
from dynamics_cli.quantities import Angle, Coordinate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    # An angle in degrees, and a lift in metres or radians.
    Row = tuple[Exact, float]

EXAMPLE = "angle[deg],lift[mm]"
FEWEST, MOST = 8, 4000
# So many equal lifts in a row are a dwell.
DWELL = 3
TURN: Exact = (360, 1)
# Rows beyond the ends of the turn that the slope at its joint follows: a row's effect falls by a factor 3.7 each.
BEYOND = 30


def motion_of_table(file: str) -> Motion:
    """The motion through the rows of a CSV file with a header such as `angle[deg],lift[mm]`.

    One row more at the end of the turn may repeat the first. What a shorter table leaves of the turn is a dwell, where
    its lift ends as it begins. Cubic splines join the rows: lift, velocity and, but at the ends of dwells,
    acceleration are continuous. Raises InadmissibleError when rows are missing, out of order or open.
    """
    rows, swing = _read(file)
    ends, levels = [row[0] for row in rows], [row[1] for row in rows]
    stroke = max(levels) - min(levels)
    require(stroke > 0.0, "all lifts of the table are equal", code="table")
    cuts = _cuts(levels)
    around = _around(ends, levels) if not cuts else 0.0
    lift_step = decimal_step(levels, (*LENGTH_UNITS, *ANGLE_UNITS[1:]))
    place_step = decimal_step([nearest(end) for end in ends])
    spans = []
    for low, high in pairwise(sorted({0, *cuts, len(rows) - 1})):
        start, end, first, last = ends[low], ends[high], levels[low], levels[high]
        if all(level == first for level in levels[low : high + 1]):
            spans.append(Span(start, end, first, first, None, "dwell"))
            continue
        width = _less(end, start)
        points = [
            (nearest(_share(_less(ends[i], start), width)), (levels[i] - first) / stroke) for i in range(low, high + 1)
        ]
        slope = around * radians(width)[0] / stroke
        law = spline(points, slope, slope, (place_step / nearest(width), lift_step / stroke))
        name = "rise" if last > first else "return" if last < first else "lobe"
        spans.append(Span(start, end, first, last, law, name, stroke))
    return Motion(spans, swing=swing)


def _cuts(levels: "list[float]") -> "list[int]":
    """The rows where dwells begin and end."""
    cuts, first = [], 0
    for i in range(1, len(levels) + 1):
        if i == len(levels) or levels[i] != levels[first]:
            if i - first >= DWELL:
                cuts += [first, i - 1]
            first = i
    return cuts


def _around(ends: "list[Exact]", levels: "list[float]") -> float:
    """The slope per radian where the turn joins itself, of a spline through the rows before and after it."""
    places = [radians(end)[0] for end in ends]
    turn, count = places[-1] - places[0], min(BEYOND, len(places) - 1)
    points = [
        (place - turn, level) for place, level in zip(places[-1 - count : -1], levels[-1 - count : -1], strict=True)
    ]
    points += list(zip(places[: count + 1], levels[: count + 1], strict=True))
    return slopes_through(points, 0.0, 0.0)[count]


def _less(a: Exact, b: Exact) -> Exact:
    return total((a, (-b[0], b[1])))


def _share(a: Exact, b: Exact) -> Exact:
    return a[0] * b[1], a[1] * b[0]


def _read(file: str) -> "tuple[list[Row], bool]":
    """The rows over one turn, the last one turn after the first, and whether the lifts are angles."""
    with open(file, encoding="utf-8-sig") as stream:
        lines = [(number, line.strip()) for number, line in enumerate(stream, 1)]
    lines = [(number, line) for number, line in lines if line and not line.startswith("#")]
    require(
        FEWEST <= len(lines) - 1 <= MOST,
        "the table has {count} rows; {fewest} to {most} are read",
        count=max(len(lines) - 1, 0),
        fewest=FEWEST,
        most=MOST,
        code="table",
        hint="a header {example}, then a row for each angle",
        example=EXAMPLE,
    )
    (angle, angle_unit), (lift, lift_unit) = _columns(lines[0][1])
    rows = []
    for number, line in lines[1:]:
        cells = _cells(line)
        values = [decimal(cells[place].strip()) if place < len(cells) else None for place in (angle, lift)]
        require(None not in values, "line {number}: {line} is not an angle and a lift", number=number,
                line=repr(line[:40]), code="table")  # fmt: skip
        rows.append((_degrees(values[0], angle_unit), _lift(values[1], lift_unit)))
    swing = lift_unit not in LENGTHS
    for (before, _), (after, _), (number, _) in zip(rows, rows[1:], lines[2:], strict=False):
        require(
            nearest(after) > nearest(before),
            "line {number}: the angle of {after:6} is not beyond the one before",
            number=number,
            after=(radians(after)[0], Angle),
            code="table",
        )
    return _closed(rows, Angle if swing else Coordinate), swing


def _closed(rows: "list[Row]", kind: "Any") -> "list[Row]":
    """Rows up to one turn after the first."""
    (start, first), (end, last) = rows[0], rows[-1]
    covered = nearest(_less(end, start))
    whole = total((start, TURN))
    require(covered <= 360.0 + 1e-9, "the table covers {covered:6}, more than one turn",
            covered=(radians(_less(end, start))[0], Angle), code="table")  # fmt: skip
    step = nearest(_less(rows[-1][0], rows[-2][0]))
    if covered >= 360.0 - 1e-9:
        rows[-1] = (whole, last)
    elif covered + 1.5 * step >= 360.0:
        rows.append((whole, first))
    elif first == last:
        middle = total((end, whole))
        rows += [((middle[0], 2 * middle[1]), first), (whole, first)]
    require(
        rows[-1][0] == whole and rows[-1][1] == first,
        "the table does not close: it begins with a lift of {first:6} and ends with {last:6}",
        first=(first, kind),
        last=(last, kind),
        code="not-closed",
        hint="give a whole turn, or rows that end at the lift that they begin with",
    )
    return rows


def _columns(header: str) -> "tuple[tuple[int, str], tuple[int, str]]":
    """Where angle and lift are, and their units."""
    heads = [cell.strip().rstrip("]").partition("[")[::2] for cell in _cells(header)]
    places = [i for i, (_, unit) in enumerate(heads) if unit.strip() in (*ANGLES, "rad")]
    lengths = [i for i, (_, unit) in enumerate(heads) if unit.strip() in LENGTHS]
    chosen = (places + lengths)[:2] if places else []
    require(
        len(chosen) == 2,
        "the header {header} does not name an angle and a lift with their units",
        header=repr(header[:60]),
        code="header",
        hint="write {example} above the rows",
        example=EXAMPLE,
    )
    return (chosen[0], heads[chosen[0]][1].strip()), (chosen[1], heads[chosen[1]][1].strip())


def _cells(line: str) -> "list[str]":
    """The cells of a row: apart by semicolons, commas, tabs or blanks."""
    for separator in (";", ",", "\t"):
        if separator in line:
            return line.split(separator)
    return line.split()


def _degrees(value: "Any", unit: str) -> Exact:
    if unit == "rad":
        return from_radians(value)
    a, b = ANGLES[unit]
    return value[0] * a, value[1] * b


def _lift(value: "Any", unit: str) -> float:
    if unit in LENGTHS:
        a, b = LENGTHS[unit]
        return nearest((value[0] * a, value[1] * b))
    return radians(_degrees(value, unit))[0]
