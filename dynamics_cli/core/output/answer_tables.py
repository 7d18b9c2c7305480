"""Tables and written files in a short answer, within the available width and lines."""

from dynamics_cli.core.documents import columns, number, quantity
from dynamics_cli.core.output.answer_words import in_words, without_rounding
from dynamics_cli.core.output.wrapping import wrapped

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.answering.task import Task

# In mm: a smaller deviation is written in micrometres.
MICROMETRES_BELOW = 0.01
# Lines that a cut must save: a table a little longer than the screen is shown as a whole.
LEAST_SAVED = 4


def headline_tables(
    document: "dict[str, Any]", task: "Task", labels: "dict[str, str]", bounds: "dict[str, Any]", *, digits: int,
    width: int, space: int,
) -> "list[str]":  # fmt: skip
    """The tables with these labels by address, and beside uncertain results what inputs they are for."""
    tables = {address: document["results"][address] for address in labels}
    nominal: list[str] = []
    if tables and "uncertainty" in document["numerics"]:
        from dynamics_cli.core.output.uncertainty import nominal_line, sweep_columns

        nominal = nominal_line(list(tables.values()), document)
        if "sweep" in tables:
            tables["sweep"], labels["sweep"] = sweep_columns(document, [name for name, _ in task.headline])
    lines: list[str] = []
    for address, table in tables.items():
        lines_each = (space - len(nominal)) // len(tables)
        lines += [
            "",
            *table_lines(table, address, labels[address], bounds, digits=digits, width=width, space=lines_each),
        ]
    return lines + nominal


def table_lines(
    node: "Any", address: str, label: str, bounds: "dict[str, Any]", *, digits: int, width: int, space: int
) -> "list[str]":
    """A table within the available width and lines: first and last rows, and the columns that fit."""
    every = columns(node)
    title, _, wanted = label.partition(" | ")
    heads_of = {name: head or in_words(name) for name, _, head in (part.partition("=") for part in wanted.split(", "))}
    chosen = [column for column in every if column[0] in heads_of] or every
    cells = [[heads_of.get(name, in_words(name)) for name, _, _ in chosen], [unit for _, unit, _ in chosen]]
    body = [cells[0]] + ([cells[1]] if any(cells[1]) else [])
    heads = len(body)
    texts = [
        [number(without_rounding(value, bounds.get(f"{address}.{name}")), digits) for value in values]
        for name, _, values in chosen
    ]
    body += [list(row) for row in zip(*texts, strict=True)]
    words = [any(isinstance(value, str) for value in values) for _, _, values in chosen]
    widths = [max(len(row[i]) for row in body) for i in range(len(chosen))]
    columns_shown, total = 0, 2
    while columns_shown < len(widths) and total + widths[columns_shown] <= width:
        total += widths[columns_shown] + 2
        columns_shown += 1
    shown_names = {name for name, _, _ in chosen[:columns_shown]}
    omitted = [in_words(name) for name, _, _ in every if name not in shown_names]
    rows = body[heads:]
    # besides the rows: a blank line, the title, the line of the gap and the line of omitted columns
    row_limit = max(space - heads - 3 - bool(omitted), 2)
    gap = len(rows) - row_limit if len(rows) > row_limit + LEAST_SAVED else 0
    if gap:
        rows = rows[: (row_limit + 1) // 2] + rows[len(rows) - row_limit // 2 :]
    lines = [title]
    for index, row in enumerate([*body[:heads], *rows]):
        if gap and index == heads + (row_limit + 1) // 2:
            lines.append(f"  … {gap} rows more: --all, or {_whole(address)}")
        padded = [f"{c:<{w}}" if t else f"{c:>{w}}" for c, w, t in zip(row, widths, words, strict=True)][:columns_shown]
        lines.append(("  " + "  ".join(padded)).rstrip())
    if omitted:
        named = f"  more columns with --all: {', '.join(omitted)}"
        lines.append(named if len(named) <= width else f"  {len(omitted)} more columns with --all")
    return lines


def _whole(address: str) -> str:
    """How the whole table is written to a file."""
    return "--output FILE.csv" + (f" --table {address}" if address != "sweep" else "")


def file_lines(file: "dict[str, Any]", width: int) -> "list[str]":
    """A line for a written file, with its contents."""
    parts = [file["holds"]] if "holds" in file else []
    if "deviation" in file:
        value, unit = file["deviation"]["value"], file["deviation"].get("unit", "")
        if unit == "mm" and value < MICROMETRES_BELOW:
            value, unit = 1e3 * value, "µm"
        parts.append(f"within {quantity(value, unit, 3)} of the true profile")
    return wrapped(f"{file['name']}  {', '.join(parts) or 'written'}", width, 2)
