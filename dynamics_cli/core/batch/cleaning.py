"""`convert --rows FILE --column "speed=m/s"`: a table whose cells hold units, with its columns in one unit each.

Units go from cells into the header, `speed[m/s]`; other columns stay as they are. A cell that cannot be read is left
empty and reported in the row's `error` column and, with its row number, on standard error; the following rows are
processed.
"""

import csv
from io import StringIO

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.batch.rows.heads import split_header
from dynamics_cli.core.batch.rows.inputs import decode_line
from dynamics_cli.core.batch.text.blocks import Source
from dynamics_cli.core.batch.text.records import cleared, records
from dynamics_cli.core.inputs.quantity_text import is_uncertain, read_amount, total
from dynamics_cli.core.inputs.settings import Call, Settings
from dynamics_cli.core.inputs.suggestions import suggestions
from dynamics_cli.core.output.csv_text import without_guard
from dynamics_cli.core.output.files import output
from dynamics_cli.core.units.conversion import convert, is_offset, nearest, to_si
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.core.units.unit import Unit, conformable
from dynamics_cli.errors import ExitStatus, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from dynamics_cli.core.terminal import Terminal

# How many bad cells are listed on standard error; the `error` column has all of them.
MOST_TOLD = 20
DELIMITERS = ",;\t"


class _Column:
    """A column to be cleaned: its place, its name, the header's unit for bare numbers, and the target unit."""

    __slots__ = ("name", "place", "unit", "wanted")

    def __init__(self, place: int, name: str, unit: str, wanted: Unit) -> None:
        self.place = place
        self.name = name
        self.unit = unit
        self.wanted = wanted

    def cleaned(self, cell: str, notes: "dict[str, None]") -> str:
        """The number of a cell in the target unit, rounded once; an empty cell stays empty."""
        text = without_guard(cell).strip()
        if not text:
            return ""
        if is_uncertain(text):
            raise UsageError("is an uncertain value; wanted one number and its unit")
        if self.unit and text[-1] in "0123456789.":
            text = f"{text} {self.unit}"
        amount = read_amount(text)
        if not amount.parts[-1][2] and any(self.wanted.dimension):
            raise UsageError("has no unit")
        numerator, denominator, unit = total(amount, self.wanted)
        if not conformable(unit, self.wanted):
            from dynamics_cli.core.units.names import explain_mismatch

            raise UsageError(explain_mismatch(unit, self.wanted)[0])
        if is_offset(unit) and to_si(numerator, denominator, unit) < 0.0:
            raise UsageError("is below absolute zero")
        notes.update(dict.fromkeys(f"{self.name}: {note}" for note in unit.notes))
        return repr(nearest(*convert(numerator, denominator, unit, self.wanted)))


def clean_columns(task: Task, call: Call, settings: Settings, terminal: "Terminal") -> int:
    """Clean the requested columns, each given as `name=unit`; returns whether every cell could be read."""
    if not task.columns or call.words or call.options:
        hint = 'for example: dynamics convert --rows messy.csv --column "speed=m/s"'
        raise UsageError("--column is for convert --rows alone", parameter="column", code="exclusive", hint=hint)
    if (settings.format_given and settings.format != "csv") or settings.jobs > 1:
        wrong = "jobs" if settings.jobs > 1 else "format"
        raise UsageError("--column reads and writes CSV in one process", parameter=wrong, code="exclusive")
    requested = _wanted(settings.columns)
    source = Source(settings.rows, terminal)
    notes: dict[str, None] = {}
    failed = row = 0
    try:
        with output(settings.output, terminal) as sink:
            columns: list[_Column] = []
            separator, heads, error_at = ",", 0, -1
            for line in _lines(source):
                if not columns:
                    separator = max(DELIMITERS, key=line.count)
                    names = _cells(line.removeprefix("\ufeff"), separator)
                    columns, heads = _columns(names, requested), len(names)
                    error_at = names.index("error") if "error" in names else -1
                    for column in columns:
                        names[column.place] = f"{column.name}[{column.wanted.text}]"
                    sink.write(_joined([*names, *(["error"] if error_at < 0 else [])]))
                    continue
                row += 1
                cells, errors = _row(_cells(line, separator), heads, columns, notes)
                failed += bool(errors)
                if errors and failed <= MOST_TOLD:
                    terminal.tell(f"dynamics: row {row}: {'; '.join(errors)}\n")
                if error_at < 0:
                    cells.append("; ".join(errors))
                elif errors:
                    cells[error_at] = "; ".join(filter(None, [cells[error_at], *errors]))
                sink.write(_joined(cells))
            if not columns:
                raise UsageError("the table is empty", parameter="rows", code="csv")
    finally:
        source.close()
    for note in notes:
        terminal.tell(f"dynamics: {note}\n")
    if failed:
        terminal.tell(f"dynamics: {failed} of {row} rows have a cell that cannot be read; see the column error\n")
    return ExitStatus.SOME_FAILED if failed else ExitStatus.DONE


def _row(
    cells: "list[str]", heads: int, columns: "list[_Column]", notes: "dict[str, None]"
) -> "tuple[list[str], list[str]]":
    """A row with its columns cleaned and bad cells empty, and the errors of those cells."""
    errors = [] if len(cells) == heads else [f"the row has {len(cells)} cells, wanted {heads}"]
    cells = (cells + [""] * heads)[:heads]
    for column in columns:
        cell = cells[column.place]
        try:
            cells[column.place] = column.cleaned(cell, notes)
        except UsageError as error:
            cells[column.place] = ""
            errors.append(f"{column.name}: read {cell.strip()!r}: {error.message}")
    return cells, errors


def _wanted(columns: "list[str]") -> "dict[str, Unit]":
    units = {}
    for item in columns:
        name, _, unit = (part.strip() for part in item.partition("="))
        if not (name and unit):
            raise UsageError(f"read {item!r}, wanted NAME=UNIT", parameter="column", hint="for example speed=m/s")
        if name in units:
            raise UsageError(f"the column {name!r} is given twice", parameter="column")
        units[name] = parse_unit(unit)
    return units


def _columns(names: "list[str]", wanted: "dict[str, Unit]") -> "list[_Column]":
    split = [split_header(name) for name in names]
    columns = []
    for name, unit in wanted.items():
        places = [place for place, (head, _) in enumerate(split) if head == name]
        places = places or [place for place, (head, _) in enumerate(split) if head.lower() == name.lower()]
        if len(places) != 1:
            near = suggestions(name, [head for head, _ in split])
            hint = (
                f"did you mean {' or '.join(near)}?" if near else f"columns are {', '.join(head for head, _ in split)}"
            )
            problem = "there are several columns" if places else "there is no column"
            raise UsageError(f"{problem} {name!r}", parameter="column", code="unknown-column", hint=hint)
        head, header_unit = split[places[0]]
        columns.append(_Column(places[0], head, header_unit, unit))
    return columns


def _lines(source: Source) -> "Iterator[str]":
    for block in cleared(records(source.blocks())):
        for line in block:
            if line is None:
                raise UsageError("a row is longer than 16 MB", parameter="rows", code="too-long")
            if line.strip():
                yield decode_line(line)


def _cells(line: str, separator: str) -> "list[str]":
    return next(csv.reader([line], delimiter=separator), [])


def _joined(cells: "list[str]") -> bytes:
    line = StringIO()
    csv.writer(line, lineterminator="\n").writerow(cells)
    return line.getvalue().encode()
