"""Columns of results: rows answered in the same way, their numbers as shown, and as text."""

import numpy as np

from dynamics_cli.core.batch.text.columns import Unsuited, joined_texts, texts
from dynamics_cli.core.output.row_layout import Part, compact
from dynamics_cli.core.units.display import Shown
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.exact.factors import Factor, scale

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]
    Mask = NDArray[Any]
    Rows = NDArray[np.int64]
    # (part, "each", one value or text a row), (part, "measured", (texts, units)), (part, "all", that of every row) or
    # (part, "beside", None) where its text is that of the part before.
    Result = tuple[Part, str, Any]

NAN = float("nan")
# Numbers whose texts are put together at once, and the fewest rows.
SLICE_NUMBERS, LEAST_SLICE = 10_000, 100


class Answered:
    """Rows answered in the same way: their indices, results and branch."""

    __slots__ = ("results", "rows", "signature")

    def __init__(self, rows: "Rows", results: "list[Result]", signature: "tuple[Any, ...]") -> None:
        self.rows = rows
        self.results = results
        self.signature = signature


def kept(rows: "Rows", columns: "list[Result]", good: "Mask", trail: "tuple[Any, ...]") -> "Answered | None":
    """The results of the rows without errors."""
    if not good.all():
        if not good.any():
            return None
        columns = [(part, how, _rows(how, value, good)) for part, how, value in columns]
        rows = rows[good]
    return Answered(rows, columns, trail)


def constant(part: Part, record: "Any") -> "Any":
    """A result that is the same in all rows, as it is shown."""
    try:
        return part.value(record)
    except UsageError as error:
        raise Unsuited(error.message) from None


def shown(found: "Any", part: Part, factor: "Factor | None", good: "Mask") -> "Any":
    """A column of results as shown: doubles, or the text of compound units and flags."""
    if part.how != "number":
        return np.asarray(found).astype(object)
    return scaled(np.asarray(found, dtype=float), part.shown, factor, good)


def scaled(values: "Array", show: "Shown | None", factor: "Factor | None", good: "Mask") -> "Any":
    """A column of numbers as shown; rows whose numbers cannot be are no longer good."""
    if show is None or (factor is not None and factor.is_one):
        return values
    if factor is None:
        return _mapped(values, show, good)
    with np.errstate(all="ignore"):
        column = scale(np.where(good, values, 0.0), factor, _one_by_one(show))
    lost = np.isnan(column)
    if lost.any():
        good &= ~lost
        column[lost] = 0.0
    return column


def _one_by_one(shown: Shown) -> "Any":
    def one(value: float) -> "Any":
        try:
            return shown.value(value)
        except UsageError:
            return NAN

    return one


def _mapped(values: "Array", shown: Shown, good: "Mask") -> "Any":
    mapped = np.empty(len(values), dtype=object)
    convert = _one_by_one(shown)
    for row in np.flatnonzero(good).tolist():
        mapped[row] = convert(float(values[row]))
        if mapped[row] != mapped[row]:
            good[row] = False
    return mapped


def shown_factor(shown: "Shown | None") -> "Factor | None":
    """From SI to the unit shown; None where it takes more than a factor."""
    if shown is None or shown.compound:
        return None
    unit = shown.unit
    if unit is None:
        return Factor(1, 1)
    if shown.kind.form == "slope" and unit.text != "%":
        return None
    shift, over = unit.offset
    return Factor(unit.denominator, unit.numerator, -unit.pi, (-shift * unit.denominator, over * unit.numerator))


def sliced(results: "list[Result]", count: int) -> "Iterator[tuple[slice, list[Result]]]":
    """The results of a few rows at a time: their texts are put together while they are in the processor's cache."""
    step = max(LEAST_SLICE, SLICE_NUMBERS // max(len(results), 1))
    if count <= step:
        yield slice(0, count), results
        return
    for start in range(0, count, step):
        rows = slice(start, min(start + step, count))
        yield rows, [(part, how, _rows(how, value, rows)) for part, how, value in results]


def _rows(how: str, value: "Any", rows: "slice | Mask") -> "Any":
    if how == "measured":
        columns, units = value
        return [column[rows] for column in columns], units
    return value[rows] if how == "each" else value


def written(results: "list[Result]", form: str) -> "list[Result]":
    """Columns as texts: the shortest text of every number, flags and compound numbers as the format writes them.

    Neighbours with nothing but commas between them are written together, which saves a split and a join for each row;
    those after the first are then (part, "beside", None).
    """
    made: list[Result] = []
    side: list[Array] = []
    for part, how, value in results:
        if how == "measured":
            side, (numbers, units) = [], value
            made.append(
                (part, how, ([texts(item) if isinstance(item, np.ndarray) else item for item in numbers], units))
            )
        elif how != "each" or not isinstance(value, np.ndarray) or value.dtype == object:
            side = []
            listed = how == "each" and isinstance(value, np.ndarray)
            made.append((part, how, _listed(value.tolist(), part, form) if listed else value))
        elif side and (form == "csv" or (form == "ndjson" and _in_one_list(part, made[-1][0]))):
            side.append(value)
            made.append((part, "beside", None))
        else:
            side = [value]
            made.append((part, how, side))
    return [
        (part, how, joined_texts(value) if how == "each" and value and isinstance(value[0], np.ndarray) else value)
        for part, how, value in made
    ]


def _in_one_list(part: Part, before: Part) -> bool:
    """Whether two results are components of the same vector, or of the same row of a matrix."""
    return isinstance(part.steps[-1], int) and part.steps[:-1] == before.steps[:-1]


def _listed(rows: "list[Any]", part: Part, form: str) -> "list[bytes]":
    if form == "ndjson":
        return [compact(row).encode() for row in rows]
    separator = "," if form == "csv" else "\t"
    return [separator.join(part.cells(row)).encode() for row in rows]
