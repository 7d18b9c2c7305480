"""A document as CSV, and its cells: quoted where necessary, and guarded where a spreadsheet would execute them."""

from dynamics_cli.core.documents import columns, flatten, is_table
from dynamics_cli.core.inputs.quantity_text import number_end
from dynamics_cli.core.json_text import to_json

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Document = dict[str, Any]

# Characters that begin a formula in a spreadsheet, and ones that a number or quantity never has after its sign.
FORMULA_SIGNS = "=+-@"
_ACTIVE = "=@(|!"


def csv_cell(text: str) -> str:
    """A cell, quoted when it must be; text that a spreadsheet would execute gets a leading apostrophe."""
    if text and text[0] in FORMULA_SIGNS and not _is_quantity(text):
        text = "'" + text
    if any(mark in text for mark in ',"\n\r'):
        return '"' + text.replace('"', '""') + '"'
    return text


def _is_quantity(text: str) -> bool:
    end = number_end(text, 0) if text[0] in "+-" else 0
    return end > 0 and not any(mark in text for mark in _ACTIVE)


def without_guard(cell: str) -> str:
    """A cell without the apostrophe that `csv_cell` put before it."""
    return cell[1:] if cell[:1] == "'" and cell[1:2] and cell[1] in FORMULA_SIGNS else cell


def header(name: str, unit: str) -> str:
    """A CSV column's header: `speed[km/h]`."""
    return csv_cell(f"{name}[{unit}]" if unit else name)


def free_name(name: str, names_in_use: "set[str]") -> str:
    """A column name for a result beside an input of the same name."""
    while name in names_in_use:
        name = f"results.{name}"
    return name


def _csv_value(value: "Any") -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if value is None:
        return ""
    return csv_cell(value if isinstance(value, str) else to_json(value))


def to_csv(document: "Document", table: str) -> str:
    """One row, as `--rows` writes it: inputs, results with their spread, an empty error; or the named table."""
    results = document["results"]
    node = next((results[name] for name in table.split() if results.get(name)), None)
    plain = [] if node else _split_lists(flatten(results))
    if not plain and not node:
        node = next((item for item in results.values() if is_table(item)), None)
    if node:
        node_columns = columns(node)
    else:
        if "uncertainty" in document["numerics"]:
            from dynamics_cli.core.output.uncertainty import with_spreads

            plain = with_spreads(plain, results)
        inputs = _split_lists(_input_cells(document["inputs"]))
        names_in_use = {name for name, _, _ in inputs}
        named = [(free_name(name, names_in_use), value, unit) for name, value, unit in [*plain, ("error", None, "")]]
        node_columns = [(name, unit, [value]) for name, value, unit in [*inputs, *named]]
    lines = [",".join(header(name, unit) for name, unit, _ in node_columns)]
    lines += [",".join(map(_csv_value, row)) for row in zip(*(values for _, _, values in node_columns), strict=True)]
    return "\n".join(lines) + "\n"


def _input_cells(inputs: "dict[str, Any]") -> "list[tuple[str, Any, str]]":
    """Every input by address, those of repeated groups by their index: `segments[0].distance`."""
    cells = []
    for name, node in inputs.items():
        if isinstance(node, list) and is_table(node):
            cells += [cell for index, row in enumerate(node) for cell in flatten(row, f"{name}[{index}]")]
        else:
            cells += flatten(node, name)
    return cells


def _split_lists(entries: "list[tuple[str, Any, str]]") -> "list[tuple[str, Any, str]]":
    split = []
    for name, value, unit in entries:
        if isinstance(value, list):
            units = unit.split(";") if ";" in unit else [unit] * len(value)
            split += _split_lists([(f"{name}[{i}]", item, units[i]) for i, item in enumerate(value)])
        else:
            split.append((name, value, unit))
    return split
