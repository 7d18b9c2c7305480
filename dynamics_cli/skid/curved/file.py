"""Surveyed points from a CSV file, its decimals kept as written."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.typed import TypedNumber

NAMES = {"x": "x", "e": "x", "east": "x", "easting": "x", "y": "y", "n": "y", "north": "y", "northing": "y"}
# Units allowed in brackets after a name: numerator and denominator in metres.
UNITS = {"": (1, 1), "m": (1, 1), "cm": (1, 100), "mm": (1, 1000), "ft": (3048, 10000), "ftus": (1200, 3937)}
MOST_POINTS = 2000


def read_points(file: str) -> tuple[float, ...]:
    """x1, y1, x2, y2, … of a file with the columns x and y, or easting and northing, in order of travel."""
    import csv

    with open(file, encoding="utf-8-sig", newline="") as stream:
        rows = [row for row in csv.reader(stream) if row and not row[0].lstrip().startswith("#")]
    require(bool(rows), "the survey is empty", code="survey")
    places = _columns(rows[0])
    require(
        len(rows) - 1 <= MOST_POINTS, "the survey has more than {most} points", code="survey", most=MOST_POINTS,
        hint="give the points of one mark",
    )  # fmt: skip
    return tuple(_number(row, *places[name], line) for line, row in enumerate(rows[1:], 2) for name in ("x", "y"))


def _columns(header: "list[str]") -> "dict[str, tuple[int, tuple[int, int]]]":
    """Where x and y are, with their units."""
    columns: dict[str, tuple[int, tuple[int, int]]] = {}
    for place, cell in enumerate(header):
        name, _, unit = cell.strip().lower().partition("[")
        key, unit = NAMES.get(name.strip(), ""), unit.strip().rstrip("]").strip()
        if not key:
            continue
        require(
            unit in UNITS, "the column {cell} has a unit that surveys are not read in", cell=repr(cell), code="unit",
            hint="use one of " + ", ".join(filter(None, UNITS)),
        )  # fmt: skip
        columns[key] = place, UNITS[unit]
    require(
        len(columns) == 2, "the header {header} has no columns x and y", header=repr(",".join(header)[:60]),
        code="header", hint="name them x[m],y[m] or easting[ft],northing[ft]",
    )  # fmt: skip
    return columns


def _number(row: "list[str]", place: int, unit: "tuple[int, int]", line: int) -> float:
    """A cell as an exact number of metres."""
    from decimal import Decimal, InvalidOperation

    text = row[place].strip() if place < len(row) else ""
    try:
        number = Decimal(text)
    except InvalidOperation:
        number = Decimal("nan")
    require(
        number.is_finite() and abs(number.adjusted()) < 30, "line {line}: {text} is not a coordinate", line=line,
        text=repr(text), code="number", hint="leave out rows without a point",
    )  # fmt: skip
    top, bottom = number.as_integer_ratio()
    return TypedNumber(top * unit[0], bottom * unit[1])
