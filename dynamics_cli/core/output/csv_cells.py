"""Cells of CSV: text quoted where it must be, and guarded where a spreadsheet would carry it out."""

from dynamics_cli.core.inputs.quantity_text import number_end

# What begins a formula in a spreadsheet, and what a number or a quantity never has after its sign.
FORMULA_SIGNS = "=+-@"
_ACTIVE = "=@(|!"


def csv_cell(text: str) -> str:
    """A cell, quoted when it must be; text that a spreadsheet would carry out stands after an apostrophe."""
    if text and text[0] in FORMULA_SIGNS and not _is_quantity(text):
        text = "'" + text
    if any(mark in text for mark in ',"\n\r'):
        return '"' + text.replace('"', '""') + '"'
    return text


def _is_quantity(text: str) -> bool:
    end = number_end(text, 0) if text[0] in "+-" else 0
    return end > 0 and not any(mark in text for mark in _ACTIVE)


def without_guard(cell: str) -> str:
    """A cell as it was before `csv_cell` put an apostrophe before it."""
    return cell[1:] if cell[:1] == "'" and cell[1:2] and cell[1] in FORMULA_SIGNS else cell


def header(name: str, unit: str) -> str:
    """A CSV column's header: `speed[km/h]`."""
    return csv_cell(f"{name}[{unit}]" if unit else name)
