"""Documents as JSON, NDJSON, CSV, Markdown or a table for people; plain text built here costs no import.

Every number is the document's own: JSON and CSV carry the shortest text that round-trips, tables the digits asked for.
"""

from dynamics_cli.core.documents import (
    bound_text,
    check_line,
    columns,
    decimals,
    flatten,
    is_table,
    number,
    quantity,
    quantity_node,
)
from dynamics_cli.core.json_text import quote, to_json
from dynamics_cli.core.output.csv_text import to_csv
from dynamics_cli.core.output.wrapping import wrapped
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Iterable
    from typing import Any

    Document = dict[str, Any]


# Columns before a table.
MARGIN = 4
SCREEN = 80
# Columns of the sensitivities with `--all`, which may be wider than a screen.
WIDE = 110


def to_pretty_json(document: "Document") -> str:
    """JSON for eyes and pipes alike: small things on one line, large ones indented."""
    return _pretty(document, "") + "\n"


def _pretty(value: "Any", indent: str) -> str:
    line = to_json(value)
    if len(line) + len(indent) <= 110 or not isinstance(value, dict | list) or not value:
        return line
    inner = indent + "  "
    if isinstance(value, dict):
        items = [f"{inner}{quote(str(key))}: {_pretty(item, inner)}" for key, item in value.items()]
        return "{\n" + ",\n".join(items) + f"\n{indent}}}"
    return "[\n" + ",\n".join(inner + _pretty(item, inner) for item in value) + f"\n{indent}]"


def _aligned(entries: "list[tuple[str, Any, str]]", digits: int, tails: "dict[str, str]") -> "list[str]":
    width = max((len(name) for name, _, _ in entries), default=0)
    lines = []
    texts = [(name, quantity(value, unit, digits), tails.get(name, "")) for name, value, unit in entries]
    middle = max((len(text) for _, text, tail in texts if tail), default=0)
    for name, text, tail in texts:
        lines.append(f"  {name:<{width}}  {text:<{middle}}  {tail}".rstrip() if tail else f"  {name:<{width}}  {text}")
    return lines


def _grid(table: "Any", digits: int) -> "list[list[str]]":
    """Header rows (names, units) and cells as text."""
    from dynamics_cli.core.output.answer_words import without_rounding

    table_columns = columns(table)
    body = [[number(without_rounding(value), digits) for value in values] for _, _, values in table_columns]
    head = [[name for name, _, _ in table_columns], [unit for _, unit, _ in table_columns]]
    return [row for row in head if any(row)] + [list(row) for row in zip(*body, strict=True)]


def to_full_table(
    document: "Document",
    digits: int,
    layout: "Callable[[Any], list[str]] | None" = None,
    width: int = 0,
    screen: int = 0,
) -> str:
    """The whole document for people: inputs, results with their error bounds, tables, checks, warnings, source.

    Tables are no wider than the `screen`. `layout` writes the results of a task that has its own; the lines below are
    then as wide as `width`.
    """
    lines = [document["command"]]
    inputs = flatten(document["inputs"])
    tables = {name: node for name, node in document["inputs"].items() if is_table(node)}
    if inputs or tables:
        lines += ["", *_aligned(inputs, 17, {}), *_tables(tables, 17, screen)]
    bounds = document["numerics"].get("error_bound", {})
    tails = {name: f"(error ≤ {bound_text(entry)})".replace("error ≤ exact", "exact") for name, entry in bounds.items()}
    uncertain = "uncertainty" in document["numerics"]
    if uncertain:
        from dynamics_cli.core.output.uncertainty import driver_lines, nominal_line, spread_tails

        tails |= spread_tails(document["results"], digits)
    results = document["results"]
    if layout is not None:
        lines += layout(results)
    else:
        lines += ["", *_aligned([entry for entry in flatten(results) if entry[1] != ""], digits, tails)]
        tables = {name: node for name, node in results.items() if is_table(node)}
        lines += _tables(tables, digits, screen)
        lines += nominal_line(list(tables.values()), document) if uncertain else []
    lines += driver_lines(document, digits) if uncertain else []
    notes = _notes(document)
    lines += ["", *(f"  {line}" for note in notes for line in (wrapped(note, width - 2, 2) if width else [note]))]
    if "timing" in document:
        lines.append(f"  computation: {document['timing']['value'] * 1e6:.0f} µs")
    if "explanation" in document:
        lines += ["", *_explanation(document["explanation"])]
    return "\n".join(lines) + "\n"


def to_verdict(document: "Document", lines: "list[str]", width: int) -> str:
    """Results laid out by their task, and of the notes what is wrong, or to be known."""
    return (
        "\n".join([*lines, *(line for note in _notes(document, brief=True) for line in wrapped(note, width, 2))]) + "\n"
    )


def _notes(document: "Document", *, brief: bool = False) -> "list[str]":
    """The notes under the results: limits, checks, warnings, the model and its source, files; `brief` what matters."""
    model = document["model"]
    notes = [f"limit: {item['message']}" for item in document.get("limits", ())]
    notes += [f"quantile: {item['message']}" for item in document.get("quantiles", ())]
    notes += [f"check: {check_line(check)}" for check in document["checks"] if not (brief and check["passed"])]
    for item in document["warnings"]:
        remedy = f" ({item['remedy']})" if item.get("remedy") else ""
        notes.append(f"{item['severity']}: {item['message']}{remedy}")
    why = f" ({model['why']})" if model.get("why") else ""
    notes += [] if brief else [f"model: {model['name']}{why}", f"source: {model['source']}"]
    return notes + [f"written: {file['name']}" for file in document.get("files", ()) if file.get("written")]


def _tables(tables: "dict[str, Any]", digits: int, width: int = 0) -> "list[str]":
    """Tables with all their rows; one wider than the screen in blocks of columns, each with the first of them."""
    lines = []
    for name, table in tables.items():
        words = [any(isinstance(value, str) for value in values) for _, _, values in columns(table)]
        grid = _grid(table, digits)
        widths = [max(len(row[i]) for row in grid) for i in range(len(grid[0]))]
        for nth, block in enumerate(_blocks(widths, width - MARGIN if width else 0)):
            lines += ["", f"  {name}{', continued' if nth else ''}"]
            for row in grid:
                cells = [f"{row[i]:<{widths[i]}}" if words[i] else f"{row[i]:>{widths[i]}}" for i in block]
                lines.append(" " * MARGIN + "  ".join(cells).rstrip())
    return lines


def _blocks(widths: "list[int]", room: int) -> "list[list[int]]":
    """The columns of each block that fits into the room (0: endless); every one begins with the first column."""
    blocks = [[0]] if widths else []
    for column in range(1, len(widths)):
        if room and len(blocks[-1]) > 1 and sum(widths[i] + 2 for i in [*blocks[-1], column]) - 2 > room:
            blocks.append([0])
        blocks[-1].append(column)
    return blocks


def _explanation(explanation: "dict[str, Any]") -> "list[str]":
    lines: list[str] = []
    for name, content in explanation.items():
        if isinstance(content, dict):
            from dynamics_cli.core.output.sensitivity import sensitivity_lines

            lines += [f"  {line}" for line in sensitivity_lines(content, str, str, WIDE)]
        elif isinstance(content, list):
            lines += [f"  {name.replace('_', ' ')}:", *(f"    {item}" for item in content)]
        else:
            lines.append(f"  {name.replace('_', ' ')}: {content}")
    return lines


def to_markdown(document: "Document", digits: int) -> str:
    """The document as a Markdown section: tables of inputs and results, checks, source."""
    from dynamics_cli.markup import fenced, markdown

    lines = [f"## {document['command']}", ""]
    bounds = document["numerics"].get("error_bound", {})
    for title, node in (("input", document["inputs"]), ("result", document["results"])):
        entries = flatten(node)
        shown_digits = 17 if title == "input" else digits
        if entries:
            tail = " | error at most" if title == "result" else ""
            lines += [f"| {title} | value{tail} |", "|---|---:" + ("|---|" if tail else "|")]
            for name, value, unit in entries:
                bound = f" | {bound_text(bounds[name]) if name in bounds else ''}" if tail else ""
                lines.append(f"| {markdown(name)} | {markdown(quantity(value, unit, shown_digits))}{bound} |")
            lines.append("")
        for name, table in ((name, item) for name, item in node.items() if is_table(item)):
            lines += [f"**{markdown(name)}**", "", *_markdown_table(table, shown_digits), ""]
    remarks = [f"limit: {item['message']}" for item in document.get("limits", ())]
    remarks += [f"quantile: {item['message']}" for item in document.get("quantiles", ())]
    remarks += [f"check: {check_line(check)}" for check in document["checks"]]
    remarks += [f"{item['severity']}: {item['message']}" for item in document["warnings"]]
    remarks.append(f"model: {document['model']['name']}; source: {document['model']['source']}")
    lines += [f"- {markdown(text)}" for text in remarks]
    if "explanation" in document:
        lines += ["", fenced("\n".join(_explanation(document["explanation"])))]
    return "\n".join(lines) + "\n"


def _markdown_table(table: "Any", digits: int) -> "list[str]":
    from dynamics_cli.core.output.answer_words import without_rounding
    from dynamics_cli.markup import markdown

    table_columns = columns(table)
    heads = [f"{label} [{unit}]" if unit else label for label, unit, _ in table_columns]
    cells = [[number(without_rounding(value), digits) for value in values] for _, _, values in table_columns]
    head, *rows = ("| " + " | ".join(map(markdown, row)) + " |" for row in (heads, *zip(*cells, strict=True)))
    return [head, "|" + "---:|" * len(table_columns), *rows]


def render(document: "Document", form: str, digits: int, table: str = "") -> str:
    """The document in one of the formats."""
    if form == "json":
        return to_pretty_json(document)
    if form == "ndjson":
        return to_json(document) + "\n"
    if form == "csv":
        return to_csv(document, table)
    if form == "markdown":
        return to_markdown(document, digits)
    return to_full_table(document, digits)


def only(
    document: "Document", names: "list[str]", digits: int, form: str, *, asked: bool = False, width: int = 0
) -> str:
    """Some results, one on each line: number and unit in a table, the document's own nodes in JSON.

    An uncertain result is rounded to its deviation, unless digits are requested (`asked`). Tables are no wider than
    `width`.
    """
    from dynamics_cli.core.output.answer_words import deviation

    results = document["results"]
    if "sweep" in document["inputs"]:
        return _of_sweep(document, names, digits, form, width)
    flat = {name: (value, unit) for name, value, unit in flatten(results)}
    names = [each for name in names for each in ([name] if is_table(results.get(name)) else _members(name, flat))]
    unknown = [name for name in names if name not in flat and not is_table(results.get(name))]
    if unknown:
        raise _unknown_result(unknown[0], flat)
    if form in ("json", "ndjson"):
        picked = {name: quantity_node(*flat[name]) if name in flat else results[name] for name in names}
        return to_json(picked) + "\n"

    def bare(name: str) -> str:
        value, unit = flat[name]
        std = 0.0 if asked else deviation(results, name)
        return f"{decimals(value, std)} {unit}".rstrip() if std and form == "table" else quantity(value, unit, digits)

    return "".join(
        bare(name) + "\n" if name in flat else whole_table(document, name, digits, form, width) for name in names
    )


def _of_sweep(document: "Document", names: "list[str]", digits: int, form: str, width: int) -> str:
    """Some columns of a sweep with their spread, the swept parameters and the errors."""
    columns_of = document["results"]["sweep"]
    swept = [entry["parameter"] for entry in document["inputs"]["sweep"]]
    names_known = [name for name in columns_of if name not in (*swept, "error")]
    names = [each for name in names for each in _members(name, names_known)]
    for name in names:
        if name not in names_known:
            raise _unknown_result(name, names_known)
    names_shown = (*swept, *names, "error")
    spread = tuple(f"{name}." for name in names)
    columns_shown = {name: node for name, node in columns_of.items() if name in names_shown or name.startswith(spread)}
    return whole_table({**document, "results": {"sweep": columns_shown}}, "sweep", digits, form, width)


def _members(name: str, known: "Collection[str]") -> "list[str]":
    """The results that a name stands for: `moments` for moments.xx, moments.yy, moments.zz; else itself."""
    return (name not in known and [each for each in known if each.startswith((f"{name}.", f"{name}["))]) or [name]


def _unknown_result(name: str, known: "Iterable[str]") -> UsageError:
    from dynamics_cli.core.units.near_names import instead_of

    hint = instead_of(name, known)
    return UsageError(f"there is no result {name!r}", parameter="only", code="unknown-result", hint=hint)


def whole_table(document: "Document", name: str, digits: int, form: str, width: int = 0, label: str = "") -> str:
    """One table of the result with all its rows, as CSV, JSON, Markdown or columns no wider than `width`.

    Where it is wider than a screen it has the columns that a headline's `label` names.
    """
    sides = {**document["inputs"], **document["results"]}
    tables = [table_name for table_name, node in sides.items() if is_table(node)]
    if name not in tables:
        raise UsageError(
            f"there is no table {name!r}",
            parameter="table",
            code="unknown-table",
            hint=f"tables are {', '.join(tables)}" if tables else "this answer has no table",
        )
    if form in ("json", "ndjson"):
        return to_json(sides[name]) + "\n"
    if form == "csv":
        return to_csv({**document, "results": {name: sides[name]}}, name)
    if form == "markdown":
        return "\n".join(_markdown_table(sides[name], digits)) + "\n"
    lines = _tables({name: sides[name]}, digits)[2:]
    room = width or SCREEN
    if " | " in label and max(map(len, lines)) - 2 > room:
        from dynamics_cli.core.output.answer_tables import table_lines

        bounds = document["numerics"].get("error_bound", {})
        lines = table_lines(sides[name], name, label, bounds, digits=digits, width=room, space=len(lines) + 9)
        return "\n".join(lines[1:]) + "\n"
    if width:
        lines = _tables({name: sides[name]}, digits, width + 2)[2:]
    return "\n".join("" if line == f"  {name}, continued" else line[2:] for line in lines) + "\n"
