"""Symmetric tensors from text or JSON: the full matrix, or moments and products."""

from dynamics_cli.core.grammar import read_scalar, split_list
from dynamics_cli.core.leaves import Token
from dynamics_cli.errors import UsageError
from dynamics_cli.quantities import Kind

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Matrix = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]


def read_tensor(kind: Kind, raw: "Any", default_unit: str) -> "tuple[Matrix, list[list[Any]], str]":
    """The matrix in SI, the matrix as written, and its unit.

    Reads `[[a, b, c], [b, d, e], [c, e, f]] kg*m^2`, three moments, six numbers (xx, yy, zz, xy, yz, zx: elements of
    the matrix), or an object with `moments` and `products`.
    """
    items, unit = _items(raw, kind)
    unit = unit or default_unit
    cells = [read_scalar(f"{item} {unit}".strip() if _bare(item) else item, kind) for item in items]
    if len(cells) == 9:
        rows = [cells[0:3], cells[3:6], cells[6:9]]
        for i, j in ((0, 1), (0, 2), (1, 2)):
            if rows[i][j].si != rows[j][i].si:
                raise UsageError(
                    f"the tensor is not symmetric: element {i + 1},{j + 1} is {rows[i][j].value} and "
                    f"{j + 1},{i + 1} is {rows[j][i].value}"
                )
    elif len(cells) in (3, 6):
        zero = read_scalar(f"0 {unit}".strip(), kind)
        xx, yy, zz, xy, yz, zx = cells if len(cells) == 6 else (*cells, zero, zero, zero)
        rows = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]
    else:
        raise UsageError(f"read {len(cells)} elements, wanted 3, 6 or 9", hint=f"for example {kind.example!r}")
    si = tuple(tuple(cell.si for cell in row) for row in rows)
    return si, [[cell.value for cell in row] for row in rows], cells[0].unit  # type: ignore[return-value]


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
        flat = [cell for row in raw for cell in (row if isinstance(row, list | tuple) else [row])]
        return [cell if isinstance(cell, str) else repr(cell) for cell in flat], ""
    if not isinstance(raw, str) or isinstance(raw, Token):
        raise UsageError(f"read {raw!r}, wanted {kind.about}", hint=f"for example {kind.example!r}")
    body, bracket, unit = raw.strip().rpartition("]")
    if not bracket:
        items = split_list(raw)
        number, _, unit = items[-1].strip().partition(" ")
        return [*(item.strip() for item in items[:-1]), number], unit.strip()
    return [cell.strip() for cell in body.replace("[", " ").replace("]", " ").split(",")], unit.strip()


def _bare(item: str) -> bool:
    return item.strip()[-1:].isdigit() or item.strip().endswith(".")
