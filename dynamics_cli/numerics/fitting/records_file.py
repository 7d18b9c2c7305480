"""Files of measured signals: CSV with a time and a value, and matrices of numbers."""

import math
from itertools import pairwise

from dynamics_cli.errors import require
from dynamics_cli.quantities import STANDARD_GRAVITY, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Units allowed in brackets after the name of the time.
TIMES = {"": 1.0, "s": 1.0, "ms": 1e-3, "us": 1e-6, "min": 60.0}
MOST = 200_000
# Times in a file are rounded: intervals may differ by this share.
UNEVEN = 0.02
# Units of a load.
FORCES = {"N": 1.0, "kN": 1e3, "lbf": 4.4482216152605}
# Numbers that are written as words.
WORDS = {"on": 1.0, "off": 0.0, "yes": 1.0, "no": 0.0}
LENGTHS = {"mm": 1e-3, "m": 1.0, "um": 1e-6, "cm": 1e-2, "in": 0.0254, "ft": 0.3048}
ACCELERATIONS = {"m/s^2": 1.0, "m/s²": 1.0, "g": STANDARD_GRAVITY, "mm/s^2": 1e-3, "ft/s^2": 0.3048}


def _cells(file: str) -> "list[list[str]]":
    import csv

    with open(file, encoding="utf-8-sig", newline="") as stream:
        rows = [row for row in csv.reader(stream) if row and not row[0].lstrip().startswith("#")]
    require(bool(rows), "the file is empty", code="record")
    return rows


def _number(text: str, line: int) -> float:
    try:
        value = float(text)
    except ValueError:
        value = WORDS.get(text.lower(), math.nan)
    require(math.isfinite(value), "line {line}: {text} is not a number", code="number", line=line, text=repr(text[:30]))
    return value


def read_record(file: str, units: "dict[str, float] | None" = None) -> "tuple[list[float], list[float], str]":
    """Times and values of the first two columns, and the unit of the values.

    `units` are those that the value's bracket may name, as SI factors.

    Times must increase; a header like `t[s],a[g]` is wanted.
    """
    rows = _cells(file)
    require(
        len(rows[0]) >= 2,
        "the file has one column; a time and a value are wanted",
        code="header",
        hint="name the columns t[s] and, for example, a[g]",
    )
    names = [cell.strip().partition("[") for cell in rows[0][:2]]
    time, unit = (part[2].strip().rstrip("]").strip() for part in names)
    factors = units if units is not None else {unit: 1.0}
    require(
        names[0][0].strip().lower() in ("t", "time") and time in TIMES and unit in factors,
        "the header {header} has no columns of a time and a value that is wanted",
        header=repr(",".join(rows[0])[:60]),
        code="header",
        hint="name them t[s],{value}",
        value=f"a[{next(iter(factors))}]" if units else "x[mm]",
    )
    require(
        3 <= len(rows) - 1 <= MOST, "the record has {count} samples; 3 to 200,000 are read", code="length",
        count=str(len(rows) - 1),
    )  # fmt: skip
    table = [[_number(cell.strip(), line) for cell in row[:2]] for line, row in enumerate(rows[1:], 2)]
    require(all(len(row) == 2 for row in table), "a row of the record has no value", code="number")
    times = [row[0] * TIMES[time] for row in table]
    _require_rising(times)
    return times, [row[1] * factors[unit] for row in table], unit


def _require_rising(times: "list[float]") -> None:
    for line, (before, after) in enumerate(pairwise(times), 3):
        require(
            after > before,
            "line {line}: the time of {after:6} is not later than the one before",
            line=line,
            after=(after, Time),
            code="times",
        )


def read_columns(file: str, known: "dict[str, dict[str, float]]") -> "tuple[list[float], dict[str, list[float]]]":
    """Times and the other columns, by name; `known` are the names that may stand there with their units' SI factors."""
    rows = _cells(file)
    parts = [cell.strip().rstrip("]").partition("[") for cell in rows[0]]
    heads = [(name.strip().lower(), unit.strip()) for name, _, unit in parts]
    (time, unit), rest = heads[0], heads[1:]
    columns = [(name, next(iter(units))) for name, units in known.items()]
    expected = "t[s]," + ", or ".join(f"{name}[{u}]" if u else name for name, u in columns)
    require(
        time in ("t", "time") and unit in TIMES and rest
        and all(name in known and u in known[name] for name, u in rest),
        "the header {header} is not one of a time and columns that are wanted",
        header=repr(",".join(rows[0])[:60]), code="header", hint="such as {wanted}", wanted=expected,
    )  # fmt: skip
    require(2 <= len(rows) - 1 <= MOST, "the table has {count} rows; 2 to 200,000 are read", code="length",
            count=str(len(rows) - 1))  # fmt: skip
    table = [[_number(cell.strip(), line) for cell in row] for line, row in enumerate(rows[1:], 2)]
    require(all(len(row) == len(heads) for row in table), "a row of the table has a value too few or too many",
            code="number")  # fmt: skip
    times = [row[0] * TIMES[unit] for row in table]
    _require_rising(times)
    return times, {name: [row[k] * known[name][u] for row in table] for k, (name, u) in enumerate(rest, 1)}


def interval_of(times: "list[float]") -> float:
    """The interval between samples; refuses times that are not equally spaced, beyond their rounding."""
    steps = [after - before for before, after in pairwise(times)]
    require(
        max(steps) - min(steps) <= UNEVEN * sum(steps) / len(steps),
        "the samples are not equally spaced: {least} to {greatest} apart", code="spacing",
        least=(min(steps), Time), greatest=(max(steps), Time), hint="leave out the rows that differ",
    )  # fmt: skip
    return (times[-1] - times[0]) / len(steps)


def read_load(file: str, units: "dict[str, float] | None" = None) -> "tuple[Any, Any, bool]":
    """Times from zero and values of a recorded load as arrays, and whether it is an acceleration of the base."""
    import numpy as np

    times, values, unit = read_record(file, units or FORCES | ACCELERATIONS)
    return np.array(times) - times[0], np.array(values), unit in ACCELERATIONS


def read_matrix(file: str) -> "list[list[float]]":
    """A square matrix of numbers without a header."""
    rows = [[_number(cell.strip(), line) for cell in row] for line, row in enumerate(_cells(file), 1)]
    require(
        all(len(row) == len(rows) for row in rows),
        "the matrix in the file is not square: {count} rows of {width}",
        count=str(len(rows)),
        width=", ".join(sorted({str(len(row)) for row in rows})),
        code="shape",
    )
    return rows


def read_named(file: str, wanted: "tuple[tuple[str, ...], ...]") -> "tuple[list[int], list[list[float]]]":
    """Lines and numbers of some columns, each known by several names, whatever others there are; gaps are left out."""
    rows = _cells(file)
    heads = [cell.strip().lower() for cell in rows[0]]
    places = [next((heads.index(name) for name in names if name in heads), -1) for names in wanted]
    require(
        -1 not in places,
        "the header {header} lacks the columns {names}",
        header=repr(",".join(rows[0])[:60]),
        names=", ".join(names[0] for names in wanted),
        code="header",
    )
    require(len(rows) - 1 <= MOST, "the file has {count} rows; up to 200,000 are read", code="length",
            count=str(len(rows) - 1))  # fmt: skip
    lines, table = [], []
    for line, row in enumerate(rows[1:], 2):
        cells = [row[place].strip() if place < len(row) else "" for place in places]
        if any(cells):
            lines.append(line)
            table.append([_number(cell, line) for cell in cells])
    return lines, table
