"""Result documents as trees of plain data: their quantities and tables, numbers as text."""

from math import floor, log10

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

# Keys of a certain input.
PLAIN = {"value", "unit"}


# A number below this is written without an exponent.
PLAIN_BELOW = 1e9


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
            value = distribution_text(node)
        elif "distributions" in node or "magnitude" in node:
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


def given_inputs(node: "Any", name: str = "") -> "Iterator[tuple[str, Any, str]]":
    """Inputs by address: numbers of one unit in a list as one entry; of several records, without address, how many."""
    if isinstance(node, dict) and not is_quantity(node):
        for key, item in node.items():
            if name or key != "sweep":
                yield from given_inputs(item, f"{name}.{key}" if name else key)
    elif is_table(node):
        yield "", f"{len(node)} {(name if len(node) > 1 else singular(name)).replace('_', ' ').replace('.', ' ')}", ""
    elif isinstance(node, list) and node and all(is_quantity(item) and item.keys() <= PLAIN for item in node):
        for unit in dict.fromkeys(item.get("unit", "") for item in node):
            yield name, [item["value"] for item in node if item.get("unit", "") == unit], unit
    else:
        yield from flatten(node, name)


def singular(name: str) -> str:
    """The name of one of several: bodies, body; meshes, mesh; masses, mass; `axis` and `radius` are one already."""
    if name.endswith("ies"):
        return f"{name[:-3]}y"
    if name.endswith(("hes", "sses")):
        return name[:-2]
    return name[:-1] if name.endswith("s") and name[-2:-1] not in ("s", "u", "i") else name


class WithUnit(str):
    """A cell with its own unit: as text in full, as `number` shows it rounded."""

    value: "Any"
    unit: str

    def __new__(cls, value: "Any", unit: str) -> "WithUnit":
        """The cell of a value and its unit."""
        from dynamics_cli.core.json_text import to_json

        cell = super().__new__(cls, f"{to_json(value)} {unit}")
        cell.value, cell.unit = value, unit
        return cell


def columns(table: "Any") -> "list[tuple[str, str, list[Any]]]":
    """A table's columns: name, unit, values."""
    if isinstance(table, dict):
        return [(name, column.get("unit", ""), column["value"]) for name, column in table.items()]
    names: dict[str, set[str]] = {}
    rows = []
    for row in table:
        fields = [(key, item) for key, item in row.items() if not (isinstance(item, list) and is_table(item))]
        cells = {name: (value, unit) for key, item in fields for name, value, unit in flatten(item, key)}
        for name, (_, unit) in cells.items():
            names.setdefault(name, set()).add(unit)
        rows.append(cells)
    found_columns = []
    for name, units in names.items():
        named_cells = [row.get(name, (None, "")) for row in rows]
        if len(units) == 1:
            found_columns.append((name, units.pop(), [value for value, _ in named_cells]))
        else:
            # Rows written in several units each keep their own.
            found_columns.append((name, "", [WithUnit(value, unit) if unit else value for value, unit in named_cells]))
    return found_columns


def number(value: "Any", digits: int) -> str:
    """A value as a table shows it."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        # A negative zero carries no meaning.
        text = repr(value + 0.0) if digits >= 17 else f"{value + 0.0:.{digits}g}"
        if "e+0" in text and abs(value) < PLAIN_BELOW:
            text = f"{float(text):.0f}"
        return text.removesuffix(".0")
    if value is None:
        return "–"
    if isinstance(value, list):
        return "[" + ", ".join(number(item, digits) for item in value) + "]"
    if isinstance(value, WithUnit):
        return quantity(value.value, value.unit, digits)
    return str(value)


def quantity(value: "Any", unit: str, digits: int) -> str:
    """A value with its unit; compound units part by part."""
    if ";" in unit and isinstance(value, list):
        return " ".join(
            f"{number(part, digits)} {name.strip()}" for part, name in zip(value, unit.split(";"), strict=False)
        )
    return f"{number(value, digits)} {unit}".rstrip()


def decimals(value: float, deviation: float) -> str:
    """A number to the place of the second significant digit of its standard deviation."""
    # a deviation of 9.96 is 10
    place = 1 - floor(log10(float(f"{abs(deviation):.1e}")))
    if -9 <= place <= 12:
        rounded = round(value, place)
        return f"{rounded + 0.0:.{max(place, 0)}f}"
    return f"{value:.6g}"


def distribution_text(node: "dict[str, Any]") -> str:
    """An uncertain input as it would be written, without its unit."""
    name = node["distribution"]
    if name == "normal":
        return f"{number(node['mean'], 17)} ± {number(node['std'], 6)}"
    if name in ("uniform", "triangular"):
        ends = [node["low"], *([node["mode"]] if name == "triangular" else []), node["high"]]
        return "..".join(number(end, 17) for end in ends)
    if name == "truncated":
        inside = f"{number(node['centre'], 17)} ± {number(node['width'], 6)}"
        return f"truncated({inside}, {number(node['low'], 17)}, {number(node['high'], 17)})"
    if name == "lognormal":
        return f"lognormal({number(node['mean'], 17)} ± {number(node['std'], 6)})"
    if name == "result":
        low, high = node["low"], node["high"]
        middle = node.get("value", node["median"])
        # four deviations of a normal distribution lie between the ends of its usual interval
        middle, low, high = (
            decimals(each, 0.25 * (high - low)) if high > low else number(each, 6) for each in (middle, low, high)
        )
        return f"{middle} ({low} to {high})"
    values = node.get("readings") or node.get("values") or []
    listed = ", ".join(number(value, 17) for value in values)
    return f"[{listed}]" if name == "readings" else f"empirical({listed})"


def component_texts(node: "dict[str, Any]") -> "tuple[str, str]":
    """An uncertain vector as it would be written: the text and its unit."""
    if "magnitude" in node:
        parts = (node["magnitude"], node["direction"])
        texts = [distribution_text(part) if "distribution" in part else number(part["value"], 17) for part in parts]
        joint = " along " if isinstance(parts[1]["value"], list) else " @ "
        return joint.join(
            f"{text} {part.get('unit', '')}".rstrip() for text, part in zip(texts, parts, strict=True)
        ), ""
    texts = []
    for value, part in zip(node["value"], node["distributions"], strict=True):
        unit = part.get("unit", "") if part else ""
        suffix = f" {unit}" if unit != node.get("unit", "") else ""
        texts.append(f"{distribution_text(part)}{suffix}" if part else number(value, 17))
    listed = ", ".join(texts)
    return listed if len(texts) == 1 else f"[{listed}]", node.get("unit", "")


def bound_text(entry: "dict[str, Any] | None") -> str:
    """A bound in words: `1.2e-16 relative`, `3e-12 mm`, `exact` or `unknown`."""
    if entry is None:
        return "unknown"
    if entry.get("relative", entry.get("absolute")) == 0.0:
        return "exact"
    if "relative" in entry:
        return f"{entry['relative']:.1e} relative"
    return f"{entry['absolute']:.1e} {entry.get('unit', '')}".rstrip()


def quantity_node(value: "Any", unit: str) -> "dict[str, Any]":
    """A number (or numbers) with its unit, if it has one."""
    return {"value": value, "unit": unit} if unit else {"value": value}


def check_line(check: "dict[str, Any]") -> str:
    """A check in one line."""
    value = f" ({check['value']:.2g})" if check.get("value") is not None else ""
    return f"{check['name']}: {'passed' if check['passed'] else 'FAILED'}{value}"
