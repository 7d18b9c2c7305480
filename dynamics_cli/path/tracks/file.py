"""Files of measured positions: CSV with a time and two or three lengths, or latitude and longitude."""

import csv
import math
from itertools import pairwise

from dynamics_cli.errors import require
from dynamics_cli.quantities import Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Units allowed in brackets after a name, in SI units.
UNITS = {
    "m": 1.0, "mm": 1e-3, "cm": 1e-2, "km": 1e3, "ft": 0.3048, "in": 0.0254, "s": 1.0, "ms": 1e-3, "min": 60.0,
    "h": 3600.0, "deg": 1.0,
}  # fmt: skip
TIMES = ("t", "time")
LENGTHS = ("x", "y", "z")
GLOBE = {"lat": "lat", "latitude": "lat", "lon": "lon", "lng": "lon", "long": "lon", "longitude": "lon"}
MOST_ROWS = 20000
# WGS 84: equatorial radius and the square of the eccentricity.
EQUATOR, ECCENTRICITY = 6378137.0, 6.69437999014e-3


class Origin:
    """Latitude [rad] and longitude [deg] of a plane's origin, and metres to a radian of each."""

    def __init__(self, first: "dict[str, float]", latitudes: "list[float]") -> None:
        self.latitude, self.longitude = latitudes[0], first["lon"]
        middle = 0.5 * (min(latitudes) + max(latitudes))
        bulge = 1.0 - ECCENTRICITY * math.sin(middle) ** 2
        self.north = EQUATOR * (1.0 - ECCENTRICITY) / bulge**1.5
        self.east = EQUATOR / math.sqrt(bulge) * math.cos(middle)


class Track:
    """Times [s] and positions [m] as rows of numbers, with the origin of those that were latitudes and longitudes.

    Dates with times count from the first, whose seconds since 1970 are `clock`.
    """

    def __init__(
        self, times: "list[float]", clock: float | None, places: "list[list[float]]", names: "list[str]",
        origin: Origin | None,
    ) -> None:  # fmt: skip
        self.times = times
        self.clock = clock
        self.places = places
        self.names = names
        self.origin = origin


def read_track(file: str, origin: Origin | None = None) -> Track:
    """Read a track; refuse cells without numbers, times that do not increase, and too few points.

    Latitudes and longitudes become east and north of the origin given, or of the track's first point, on the plane that
    touches the ellipsoid half way.
    """
    with open(file, encoding="utf-8-sig", newline="") as stream:
        rows = [row for row in csv.reader(stream) if row and not row[0].lstrip().startswith("#")]
    require(bool(rows), "the file is empty", code="track", hint="a header t[s],x[m],y[m], then a row for each time")
    columns = _columns(rows[0])
    require(len(rows) - 1 <= MOST_ROWS, "the track has more than {most} points", code="track", most=MOST_ROWS,
            hint="give a part of it")  # fmt: skip
    numbers = [_row(row, columns, line) for line, row in enumerate(rows[1:], 2)]
    clock = numbers[0]["t"] if numbers and ":" in rows[1][columns["t"][0]] else None
    times = [row["t"] - (clock or 0.0) for row in numbers]
    for line, (before, after) in enumerate(pairwise(times), 3):
        require(
            after > before,
            "line {line}: the time of {after:6} is not later than the one before",
            code="times",
            hint="sort the rows by time, and keep one of those at the same time",
            line=line,
            after=(after, Time),
        )
    names = [name for name in LENGTHS if name in columns]
    if "lat" not in columns:
        return Track(times, clock, [[row[name] for name in names] for row in numbers], names, None)
    latitudes = [math.radians(row["lat"]) for row in numbers]
    origin = origin or Origin(numbers[0], latitudes)
    places = []
    for row, latitude in zip(numbers, latitudes, strict=True):
        turned = math.radians(math.remainder(row["lon"] - origin.longitude, 360.0))
        flat = [origin.east * turned, origin.north * (latitude - origin.latitude)]
        places.append([*flat, row["z"]] if "z" in names else flat)
    return Track(times, clock, places, ["x", "y", *(["z"] if "z" in names else [])], origin)


def _columns(header: "list[str]") -> "dict[str, tuple[int, float]]":
    """Where each column is, and its unit's factor."""
    columns: dict[str, tuple[int, float]] = {}
    for place, cell in enumerate(header):
        name, _, unit = cell.strip().lower().partition("[")
        name, unit = name.strip(), unit.strip().rstrip("]").strip()
        key = "t" if name in TIMES else GLOBE.get(name, name)
        if key not in ("t", *LENGTHS, "lat", "lon"):
            continue
        require(
            not unit or unit in UNITS,
            "the column {cell} has a unit that tracks cannot have",
            code="unit",
            hint="use one of {known}",
            cell=repr(cell),
            known=", ".join(UNITS),
        )
        columns[key] = place, UNITS[unit] if unit else 1.0
    enough = "t" in columns and ("x" in columns or ("lat" in columns and "lon" in columns))
    require(
        enough,
        "the header {header} has no columns of a time and a position",
        code="header",
        hint="name them t[s],x[m],y[m] (and z[m]), or t[s],lat[deg],lon[deg]",
        header=repr(",".join(header)[:60]),
    )
    return columns


def _row(row: "list[str]", columns: "dict[str, tuple[int, float]]", line: int) -> "dict[str, float]":
    numbers = {}
    for name, (place, factor) in columns.items():
        text = row[place].strip() if place < len(row) else ""
        value, factor = (_clock(text), 1.0) if name == "t" and ":" in text else (_number(text), factor)
        require(
            math.isfinite(value),
            "line {line}: {text} is not a number" + (" of seconds, nor a time as 2024-05-01T10:00:00Z" * (name == "t")),
            code="number",
            hint="leave out rows without a measurement",
            line=line,
            text=repr(text),
        )
        numbers[name] = value * factor
    return numbers


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return math.nan


def _clock(text: str) -> float:
    """Seconds since 1970 of a date with a time, as GPS loggers write it."""
    from datetime import UTC, datetime

    try:
        moment = datetime.fromisoformat(text)
    except ValueError:
        return math.nan
    return (moment if moment.tzinfo else moment.replace(tzinfo=UTC)).timestamp()


def third_differences(values: "Any") -> float:
    """The noise of equally good measurements, from their third differences: √(Σ(Δ³y)²/(20 n))."""
    import numpy as np

    third = np.diff(np.asarray(values), 3, axis=0)
    return float(np.sqrt((third**2).mean() / 20.0))
