"""`@loads.csv` and `@turning.json:torque`: the rows of a table as the items of a repeated option."""

import os

from dynamics_cli.core.inputs.sources.files import decode, read_bytes
from dynamics_cli.core.inputs.sources.hashes import entry_of
from dynamics_cli.core.inputs.sources.references import resolve
from dynamics_cli.core.terminal import Terminal
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.inputs.context import Context
    from dynamics_cli.core.inputs.specification import Record

MOST_ROWS = 10_000
AXES = ("_x", "_y", "_z")


def with_tables(items: "list[Any]", node: "Record", context: "Context", own: str) -> "list[Any]":
    """The items, each reference replaced by the rows of its table."""
    out: list[Any] = []
    for item in items:
        if not isinstance(item, str) or item[:1] != "@":
            out.append(item)
        elif item.lower().endswith(".csv"):
            out.extend(_csv_items(item[1:], node, context, own))
        else:
            rows = resolve(item, context, own)
            if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
                raise UsageError(f"{item} is not a table", code="no-value", hint="a table of results is wanted")
            # a table of results may have further columns
            out.extend({name: row[name] for name in row if name in node.names} for row in rows)
    return out


def _csv_items(name: str, node: "Record", context: "Context", own: str) -> "list[dict[str, str]]":
    """Rows of a CSV file whose header has the names of the fields with units, vectors by components or as one cell."""
    import csv

    if context.references is not None:
        raise UsageError(f"read '@{name}': rows may not read from files", code="reference")
    path = name if os.path.isabs(name) else os.path.join(context.folder, name)
    data = read_bytes(path, Terminal())
    lines = [line for line in decode(data, name).splitlines() if line.strip() and not line.lstrip().startswith("#")]
    context.files.append(entry_of(path, data))
    header, *rows = list(csv.reader(lines)) or [[]]
    if not 1 <= len(rows) <= MOST_ROWS:
        raise UsageError(f"{name!r} has {len(rows)} rows below its header; 1 to {MOST_ROWS} are read", code="rows")
    heads = [_head(cell, node, name) for cell in header]
    items = []
    for line, row in enumerate(rows, 2):
        if len(row) != len(heads):
            message = f"{name!r}, row {line}: read {len(row)} cells, the header has {len(heads)}"
            raise UsageError(message, code="rows", hint='a vector in one cell is quoted: "2, 0"')
        item: dict[str, str] = {}
        for (field, unit), cell in zip(heads, row, strict=True):
            if field in item:
                # a further component: the unit stands behind the last
                item[field] = f"{item[field].removesuffix(unit).rstrip()}, {cell.strip()} {unit}".strip()
            elif cell.strip():
                item[field] = f"{cell.strip()} {unit}".strip()
        items.append(item)
    return items


def _head(cell: str, node: "Record", name: str) -> "tuple[str, str]":
    """The field that a column is of, and the unit behind its numbers."""
    head, _, unit = cell.strip().partition("[")
    field = head.strip().lower().replace("-", "_").replace(" ", "_")
    if field not in node.names and field.endswith(AXES):
        field = field[:-2]
    if field not in node.names:
        raise UsageError(
            f"{name!r}: there is no field {head.strip()!r} for its column", code="header",
            hint=f"known here: {', '.join(node.keys())}, with units as in angle[deg]; components as at_x, at_y",
        )  # fmt: skip
    return field, unit.strip().rstrip("]").strip()
