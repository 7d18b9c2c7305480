"""Cells of CSV: text quoted where necessary, and guarded where a spreadsheet would execute it."""

from dynamics_cli.core.inputs.quantity_text import number_end

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
