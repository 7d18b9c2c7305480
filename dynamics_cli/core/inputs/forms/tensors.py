"""Symmetric tensors from text or JSON: the full matrix, or moments and products."""

from dynamics_cli.core.inputs.context import Token
from dynamics_cli.core.inputs.forms.lists import spaced_numbers
from dynamics_cli.core.inputs.forms.splitting import split_list
from dynamics_cli.core.inputs.quantity_text import read_scalar
from dynamics_cli.errors import UsageError
from dynamics_cli.quantities import Kind

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Matrix = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]

# Rounding of a product of three matrices leaves mirrored elements apart by this share of the largest one.
ROUNDING = 16.0 * 2.0**-53


def read_tensor(kind: Kind, raw: "Any", default_unit: str) -> "tuple[Matrix, list[list[Any]], str]":
    """The matrix in SI, the matrix as written, and its unit.

    Reads `[[a, b, c], [b, d, e], [c, e, f]] kg*m^2`, three moments, six numbers (xx, yy, zz, xy, yz, zx: elements of
    the matrix), or an object with `moments` and `products`.
    """
    items, unit = _items(raw, kind)
    unit = unit or default_unit
    cells = [read_scalar(f"{item} {unit}".strip() if _bare(item) else item, kind) for item in items]
    if len(cells) == 9:
        return _symmetric([cells[0:3], cells[3:6], cells[6:9]])
    elif len(cells) in (3, 6):
        zero = read_scalar(f"0 {unit}".strip(), kind)
        xx, yy, zz, xy, yz, zx = cells if len(cells) == 6 else (*cells, zero, zero, zero)
        rows = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]
    else:
        raise UsageError(f"read {len(cells)} elements, wanted 3, 6 or 9", hint=f"for example {kind.example!r}")
    si = tuple(tuple(cell.si for cell in row) for row in rows)
    return si, [[cell.value for cell in row] for row in rows], cells[0].unit  # type: ignore[return-value]


def _symmetric(rows: "list[list[Any]]") -> "tuple[Matrix, list[list[Any]], str]":
    """A full matrix; elements that differ by the rounding of a product of matrices are taken at their mean."""
    si, shown = [[cell.si for cell in row] for row in rows], [[cell.value for cell in row] for row in rows]
    tolerance = ROUNDING * max(abs(x) for row in si for x in row)
    for i, j in ((0, 1), (0, 2), (1, 2)):
        if abs(si[i][j] - si[j][i]) > tolerance:
            raise UsageError(
                f"the tensor is not symmetric: element {i + 1},{j + 1} is {shown[i][j]} and "
                f"{j + 1},{i + 1} is {shown[j][i]}"
            )
        if si[i][j] != si[j][i]:
            si[i][j] = si[j][i] = 0.5 * (si[i][j] + si[j][i])
            shown[i][j] = shown[j][i] = 0.5 * (shown[i][j] + shown[j][i])
    return tuple(map(tuple, si)), shown, rows[0][0].unit  # type: ignore[return-value]


def _require_square(sizes: "list[int]") -> None:
    """Refuse rows that are not three by three: six elements in two rows are not moments and products."""
    if sizes != [3, 3, 3]:
        count = " and ".join(map(str, sizes))
        raise UsageError(f"read rows of {count} elements, wanted 3 rows of 3", hint="or 3 or 6 elements in one list")


def _items(raw: "Any", kind: Kind) -> "tuple[list[str], str]":
    if isinstance(raw, dict) and "moments" in raw:
        moments, unit = _items(raw["moments"], kind)
        products, other = _items(raw["products"], kind) if "products" in raw else (["0", "0", "0"], unit)
        if unit and other and unit != other:
            raise UsageError(f"moments are in {unit} and products in {other}", hint="give both in one unit")
        return moments + products, unit or other
    if isinstance(raw, dict) and "value" in raw:
        items, _ = _items(raw["value"], kind)
        return items, str(raw.get("unit") or "")
    if isinstance(raw, list | tuple):
        if any(isinstance(row, list | tuple) for row in raw):
            _require_square([len(row) if isinstance(row, list | tuple) else 1 for row in raw])
        flat = [cell for row in raw for cell in (row if isinstance(row, list | tuple) else [row])]
        return [cell if isinstance(cell, str) else repr(cell) for cell in flat], ""
    if not isinstance(raw, str) or isinstance(raw, Token):
        raise UsageError(f"read {raw!r}, wanted {kind.about}", hint=f"for example {kind.example!r}")
    text = raw.strip()
    if text.startswith("("):
        text = text.replace("(", "[").replace(")", "]")
    body, bracket, unit = text.rpartition("]")
    if not bracket:
        rows = [_in_row(row) for row in text.split(";")]
        if len(rows) > 1:
            _require_square([len(row) for row in rows])
        items = [item for row in rows for item in row]
        number, _, unit = items[-1].strip().partition(" ")
        return [*(item.strip() for item in items[:-1]), number], unit.strip()
    if body.count("[") > 1:
        written = [row.strip(" ,\t\n") for row in body.replace("[", "]").split("]")]
        _require_square([row.count(",") + 1 for row in written if row])
    return [cell.strip() for cell in body.replace("[", " ").replace("]", " ").split(",")], unit.strip()


def _in_row(row: str) -> "list[str]":
    """The elements of a row with commas or only spaces between them; the last one keeps its unit."""
    spaced = spaced_numbers(row)
    return [*(item.partition(" ")[0] for item in spaced[:-1]), spaced[-1]] if spaced else split_list(row)


def _bare(item: str) -> bool:
    return item.strip()[-1:].isdigit() or item.strip().endswith(".")
