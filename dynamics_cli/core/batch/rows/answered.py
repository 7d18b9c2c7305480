"""Columns of results: rows answered in the same way, their numbers as shown, and as text."""

import numpy as np

from dynamics_cli.core.batch.text.columns import joined_texts, texts
from dynamics_cli.core.batch.text.weaving import Answered, Unsuited, rows_of
from dynamics_cli.core.output.csv_text import csv_cell
from dynamics_cli.core.output.row_layout import Part, compact
from dynamics_cli.core.units.display import Shown
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.exact.factors import Factor, scale

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.batch.text.weaving import Result

    Array = NDArray[Any]
    Mask = NDArray[Any]
    Rows = NDArray[np.int64]

NAN = float("nan")


def kept(rows: "Rows", columns: "list[Result]", good: "Mask", trail: "tuple[Any, ...]") -> "Answered | None":
    """The results of the rows without errors."""
    if not good.all():
        if not good.any():
            return None
        columns = [(part, how, rows_of(how, value, good)) for part, how, value in columns]
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


def written(results: "list[Result]", form: str) -> "list[Result]":
    """Results with flags and compound numbers as the format writes them; columns of doubles stay."""
    return [
        (part, how, _listed(value.tolist(), part, form))
        if how == "each" and isinstance(value, np.ndarray) and value.dtype == object
        else (part, how, value)
        for part, how, value in results
    ]


def texts_of(runs: "list[list[Any]]") -> "list[list[bytes]]":
    """The texts of columns of doubles, those of a run together; texts stay."""
    alone = [run[0] for run in runs if len(run) == 1 and isinstance(run[0], np.ndarray)]
    cells = iter(texts(alone) if alone else [])
    return [
        joined_texts(run) if len(run) > 1 else next(cells) if isinstance(run[0], np.ndarray) else run[0] for run in runs
    ]


def _listed(rows: "list[Any]", part: Part, form: str) -> "list[bytes]":
    if form == "ndjson":
        return [compact(row).encode() for row in rows]
    if form == "csv":
        return [",".join(map(csv_cell, part.cells(row))).encode() for row in rows]
    return ["\t".join(part.cells(row)).encode() for row in rows]
