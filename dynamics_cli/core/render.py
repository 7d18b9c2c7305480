"""Documents as JSON, NDJSON, CSV, Markdown or a table for people; plain text built here costs no import.

Every number is the document's own: JSON and CSV carry the shortest text that round-trips, tables the digits asked for.
"""

try:
    from _json import encode_basestring
except ImportError:  # another Python than CPython
    from json.encoder import encode_basestring

from math import isfinite

from dynamics_cli.errors import FaultError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Document = dict[str, Any]


quote = encode_basestring


def to_json(value: "Any") -> str:
    """Compact JSON on one line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{quote(str(key))}: {to_json(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(to_json, value)) + "]"
    if isinstance(value, str):
        return quote(value)
    if value is True:
        return "true"
    if value is False:
        return "false"
    if value is None:
        return "null"
    if isinstance(value, float) and not isfinite(value):
        raise FaultError(f"{value} has no place in a document", code="not-finite")
    return repr(value)


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


def is_quantity(value: "Any") -> bool:
    """Whether a node of the document is a number (or numbers) with its unit."""
    return isinstance(value, dict) and "value" in value and not isinstance(value["value"], dict)


def is_table(value: "Any") -> bool:
    """Whether a node is a list of rows or a set of columns."""
    if isinstance(value, list):
        return bool(value) and all(isinstance(row, dict) and not is_quantity(row) for row in value)
    return (
        isinstance(value, dict)
        and bool(value)
        and all(is_quantity(v) and isinstance(v["value"], list) for v in value.values())
    )


def flatten(node: "Any", address: str = "") -> "list[tuple[str, Any, str]]":
    """Every quantity or word below a node that is not a table: address, value, unit."""
    if is_quantity(node):
        value = node["value"]
        if "distribution" in node:
            from dynamics_cli.core.uncertain.render import distribution_text

            value = distribution_text(node)
        elif "distributions" in node or "magnitude" in node:
            from dynamics_cli.core.uncertain.render import component_texts

            return [(address, *component_texts(node))]
        return [(address, value, node.get("unit", ""))]
    if isinstance(node, dict):
        return [
            entry
            for key, item in node.items()
            if not (address == "" and is_table(item))
            for entry in flatten(item, f"{address}.{key}" if address else key)
        ]
    if isinstance(node, list) and all(isinstance(item, str) for item in node):
        return [(address, ", ".join(node), "")]
    if isinstance(node, list):
        return [entry for index, item in enumerate(node) for entry in flatten(item, f"{address}[{index}]")]
    return [(address, node, "")]


def columns(table: "Any") -> "list[tuple[str, str, list[Any]]]":
    """A table's columns: name, unit, values."""
    if isinstance(table, dict):
        return [(name, column.get("unit", ""), column["value"]) for name, column in table.items()]
    names: dict[str, set[str]] = {}
    rows = []
    for row in table:
        cells = {name: (value, unit) for name, value, unit in flatten({"": row}, "")}
        cells = {name.lstrip("."): cell for name, cell in cells.items()}
        for name, (_, unit) in cells.items():
            names.setdefault(name, set()).add(unit)
        rows.append(cells)
    made = []
    for name, units in names.items():
        found = [row.get(name, (None, "")) for row in rows]
        if len(units) == 1:
            made.append((name, units.pop(), [value for value, _ in found]))
        else:
            # Rows written in several units keep each its own.
            made.append((name, "", [f"{to_json(value)} {unit}".rstrip() if unit else value for value, unit in found]))
    return made


def number(value: "Any", digits: int) -> str:
    """A value as a table shows it."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        # Nobody means anything by a negative zero.
        text = repr(value + 0.0) if digits >= 17 else f"{value + 0.0:.{digits}g}"
        return text.removesuffix(".0")
    if value is None:
        return "–"
    if isinstance(value, list):
        return "[" + ", ".join(number(item, digits) for item in value) + "]"
    return str(value)


def quantity(value: "Any", unit: str, digits: int) -> str:
    """A value with its unit; compound units part by part."""
    if ";" in unit and isinstance(value, list):
        return " ".join(
            f"{number(part, digits)} {name.strip()}" for part, name in zip(value, unit.split(";"), strict=False)
        )
    return f"{number(value, digits)} {unit}".rstrip()


def _aligned(entries: "list[tuple[str, Any, str]]", digits: int, tails: "dict[str, str]") -> "list[str]":
    width = max((len(name) for name, _, _ in entries), default=0)
    lines = []
    shown = [(name, quantity(value, unit, digits), tails.get(name, "")) for name, value, unit in entries]
    middle = max((len(text) for _, text, tail in shown if tail), default=0)
    for name, text, tail in shown:
        lines.append(f"  {name:<{width}}  {text:<{middle}}  {tail}".rstrip() if tail else f"  {name:<{width}}  {text}")
    return lines


def _grid(table: "Any", digits: int) -> "list[list[str]]":
    """Header rows (names, units) and cells as text."""
    made = columns(table)
    body = [[number(value, digits) for value in values] for _, _, values in made]
    units = [unit for _, unit, _ in made]
    head = [[name for name, _, _ in made]] + ([units] if any(units) else [])
    return head + [list(row) for row in zip(*body, strict=True)]


def to_table(document: "Document", digits: int, layout: "Callable[[Any], list[str]] | None" = None) -> str:
    """The document for people: inputs, results with their error bounds, tables, checks, warnings, source.

    `layout` writes the results, where a task has a way of its own.
    """
    model = document["model"]
    lines = [document["command"]]
    inputs = flatten(document["inputs"])
    tables = {name: node for name, node in document["inputs"].items() if is_table(node)}
    if inputs or tables:
        lines += ["", *_aligned(inputs, 17, {}), *_tables(tables, 17)]
    bounds = document["numerics"].get("error_bound", {})
    tails = {name: f"(error ≤ {bound_text(entry)})".replace("error ≤ exact", "exact") for name, entry in bounds.items()}
    uncertain = "uncertainty" in document["numerics"]
    if uncertain:
        from dynamics_cli.core.uncertain.render import driver_lines, spread_tails

        tails |= spread_tails(document["results"], digits)
    results = document["results"]
    if layout is not None:
        lines += layout(results)
    else:
        lines += ["", *_aligned(flatten(results), digits, tails)]
        lines += _tables({name: node for name, node in results.items() if is_table(node)}, digits)
    lines += driver_lines(document, digits) if uncertain else []
    lines.append("")
    lines += [f"  limit: {item['message']}" for item in document.get("limits", ())]
    lines += [f"  check: {check_line(check)}" for check in document["checks"]]
    for item in document["warnings"]:
        mend = f" ({item['mend']})" if item.get("mend") else ""
        lines.append(f"  {item['severity']}: {item['message']}{mend}")
    lines.append(f"  model: {model['name']}" + (f" ({model['why']})" if model.get("why") else ""))
    lines.append(f"  source: {model['source']}")
    lines += [f"  written: {file['name']}" for file in document.get("files", ()) if file.get("written")]
    if "timing" in document:
        lines.append(f"  computation: {document['timing']['value'] * 1e6:.0f} µs")
    if "explanation" in document:
        lines += ["", *_explanation(document["explanation"])]
    return "\n".join(lines) + "\n"


def _tables(tables: "dict[str, Any]", digits: int) -> "list[str]":
    lines = []
    for name, table in tables.items():
        words = [any(isinstance(value, str) for value in values) for _, _, values in columns(table)]
        grid = _grid(table, digits)
        widths = [max(len(row[i]) for row in grid) for i in range(len(grid[0]))]
        lines += ["", f"  {name}"]
        for row in grid:
            cells = zip(row, widths, words, strict=True)
            shown = [f"{cell:<{width}}" if word else f"{cell:>{width}}" for cell, width, word in cells]
            lines.append("    " + "  ".join(shown).rstrip())
    return lines


def bound_text(entry: "dict[str, Any] | None") -> str:
    """A bound in words: `1.2e-16 relative`, `3e-12 mm`, `exact` or `unknown`."""
    if entry is None:
        return "unknown"
    if entry.get("relative", entry.get("absolute")) == 0.0:
        return "exact"
    if "relative" in entry:
        return f"{entry['relative']:.1e} relative"
    return f"{entry['absolute']:.1e} {entry.get('unit', '')}".rstrip()


def check_line(check: "dict[str, Any]") -> str:
    """A check in one line."""
    value = f" ({check['value']:.2g})" if check.get("value") is not None else ""
    return f"{check['name']}: {'passed' if check['passed'] else 'FAILED'}{value}"


def _explanation(explanation: "dict[str, Any]") -> "list[str]":
    lines = []
    for name, content in explanation.items():
        if isinstance(content, list):
            lines += [f"  {name.replace('_', ' ')}:", *(f"    {item}" for item in content)]
        else:
            lines.append(f"  {name.replace('_', ' ')}: {content}")
    return lines


def csv_cell(text: str) -> str:
    """A cell, quoted when it must be."""
    if any(mark in text for mark in ',"\n\r'):
        return '"' + text.replace('"', '""') + '"'
    return text


def _csv_value(value: "Any") -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if value is None:
        return ""
    return csv_cell(value if isinstance(value, str) else to_json(value))


def header(name: str, unit: str) -> str:
    """A CSV column's header: `speed[km/h]`."""
    return csv_cell(f"{name}[{unit}]" if unit else name)


def to_csv(document: "Document", table: str) -> str:
    """The task's main table (the first there is of several names), or else its results on one line."""
    results = document["results"]
    node = next((results[name] for name in table.split() if results.get(name)), None)
    plain = [] if node else _split_lists(flatten(results))
    if plain and "uncertainty" in document["numerics"]:
        from dynamics_cli.core.uncertain.render import spread_columns

        plain += spread_columns(results)
    made = columns(node) if node else [(name, unit, [value]) for name, value, unit in plain]
    lines = [",".join(header(name, unit) for name, unit, _ in made)]
    lines += [",".join(map(_csv_value, row)) for row in zip(*(values for _, _, values in made), strict=True)]
    return "\n".join(lines) + "\n"


def _split_lists(entries: "list[tuple[str, Any, str]]") -> "list[tuple[str, Any, str]]":
    made = []
    for name, value, unit in entries:
        if isinstance(value, list):
            units = unit.split(";") if ";" in unit else [unit] * len(value)
            made += _split_lists([(f"{name}[{i}]", item, units[i]) for i, item in enumerate(value)])
        else:
            made.append((name, value, unit))
    return made


def to_markdown(document: "Document", digits: int) -> str:
    """The document as a Markdown section: tables of inputs and results, checks, source."""
    lines = [f"## {document['command']}", ""]
    bounds = document["numerics"].get("error_bound", {})
    for title, node in (("input", document["inputs"]), ("result", document["results"])):
        entries = flatten(node)
        shown = 17 if title == "input" else digits
        if entries:
            tail = " | error at most" if title == "result" else ""
            lines += [f"| {title} | value{tail} |", "|---|---:" + ("|---|" if tail else "|")]
            for name, value, unit in entries:
                bound = f" | {bound_text(bounds[name]) if name in bounds else ''}" if tail else ""
                lines.append(f"| {name} | {_cell(quantity(value, unit, shown))}{bound} |")
            lines.append("")
        for name, table in ((name, item) for name, item in node.items() if is_table(item)):
            made = columns(table)
            heads = [_cell(f"{label} [{unit}]" if unit else label) for label, unit, _ in made]
            lines += [f"**{name}**", "", "| " + " | ".join(heads) + " |", "|" + "---:|" * len(made)]
            lines += [
                "| " + " | ".join(_cell(number(cell, shown)) for cell in row) + " |"
                for row in zip(*(values for _, _, values in made), strict=True)
            ]
            lines.append("")
    lines += [f"- limit: {item['message']}" for item in document.get("limits", ())]
    lines += [f"- check: {check_line(check)}" for check in document["checks"]]
    lines += [f"- {item['severity']}: {item['message']}" for item in document["warnings"]]
    lines.append(f"- model: {document['model']['name']}; source: {document['model']['source']}")
    if "explanation" in document:
        lines += ["", "```", *_explanation(document["explanation"]), "```"]
    return "\n".join(lines) + "\n"


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


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
    return to_table(document, digits)
