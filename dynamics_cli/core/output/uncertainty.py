"""Uncertain inputs and results as a table for people shows them."""

from dynamics_cli.core.documents import columns, number, quantity
from dynamics_cli.core.output.row_layout import SPREAD

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any

# A mean farther than this share of the deviation from the middle of the interval makes it skewed.
LOPSIDED = 0.02
MOST_DRIVERS = 6


def spreads(node: "Any", address: str = "") -> "Iterator[tuple[str, dict[str, Any]]]":
    """Every result with an interval, by address."""
    if isinstance(node, dict):
        if "interval" in node:
            yield address, node
            return
        for key, item in node.items():
            yield from spreads(item, f"{address}.{key}" if address else key)


def spread_tails(results: "dict[str, Any]", digits: int) -> "dict[str, str]":
    """The text beside an uncertain result: the interval and its probability, and the deviation."""
    tails = {}
    for address, node in spreads(results):
        unit = str(node.get("unit") or "")
        parts = unit if ";" in unit else ""
        low, high = (quantity(end, parts, digits) for end in node["interval"])
        chance = f"{100.0 * node['coverage']:.6g} %"
        chance += " each" if isinstance(node["value"], list) and not parts else ""
        deviation = f", σ {quantity(node['std'], parts, 3)}" if node["std"] is not None else ""
        tails[address] = f"{chance} within {low} to {high}{deviation}{_lean(node)}"
    return tails


def _lean(node: "dict[str, Any]") -> str:
    """The median, where the distribution is skewed enough to matter."""
    low, high = node["interval"]
    median = node["median"]
    if isinstance(low, list) or not high > low:
        return ""
    below, above = median - low, high - median
    return f", median {number(median, 6)}" if abs(above - below) > LOPSIDED * (high - low) else ""


def sweep_columns(document: "dict[str, Any]", headline: "Sequence[str]") -> "tuple[dict[str, Any], str]":
    """An uncertain sweep with the headline first, and a label by which each result has the ends of its interval."""
    table = document["results"]["sweep"]
    share = f"{100.0 * document['numerics']['uncertainty']['coverage']:.6g} %"
    heads = {}
    chances = [name for name in table if name.rpartition(".")[2].startswith("limit_probability")]
    # What is asked for comes first: a screen may not hold all columns.
    limited = [name.rpartition(".")[0] for name in chances]
    swept = [axis["parameter"] for axis in document["inputs"]["sweep"]]
    for name in dict.fromkeys([*swept, *limited, *headline, *table]):
        result, _, figure = name.rpartition(".")
        if name in table and name not in chances and (figure not in SPREAD or result not in table):
            heads[name] = ""
            heads |= {chance: "beyond limit" for chance in chances if chance.rpartition(".")[0] == name}
            heads |= {f"{name}.low": f"{share} from", f"{name}.high": "to"} if f"{name}.low" in table else {}
    ordered = {name: table[name] for name in dict.fromkeys([*heads, *table])}
    return ordered, "sweep | " + ", ".join(f"{name}={head}" for name, head in heads.items())


def nominal_line(tables: "Sequence[Any]", document: "dict[str, Any]") -> "list[str]":
    """A line for tables of numbers beside uncertain results: they are not spread."""
    uncertain = "results" in document["numerics"].get("uncertainty", {})
    told = any(item["code"] == "nothing-varies" for item in document["warnings"])
    numbers = [t for t in tables if any(isinstance(v, float | list) for _, _, values in columns(t) for v in values)]
    if not uncertain or told or not numbers:
        return []
    return [f"  {'tables' if len(numbers) > 1 else 'table'} at the inputs' nominal values"]


def driver_lines(document: "dict[str, Any]", digits: int) -> "list[str]":
    """For every result: the inputs ranked by their share of the variance, and the range that each alone gives."""
    lines: list[str] = []
    listed: list[Any] = []
    for name, entry in document.get("sensitivity", {}).items():
        rows = entry["inputs"]
        # The drivers of a vector's components are in the document.
        if entry in listed or name.endswith("]"):
            continue
        listed.append(entry)
        unit = entry.get("unit", "")
        lines += ["", f"  {name} is driven by"]
        width = max(len(row["input"]) for row in rows)
        rows = [row for row in rows if row.get("total", row["share"]) or len(rows) == 1]
        for row in rows[:MOST_DRIVERS]:
            fraction = row.get("total", row["share"])
            low, high = row["alone"]
            none = low is None and high is None
            alone = "" if none else f"alone {_range((low, high), unit, digits)}"
            lines.append(f"    {row['input']:<{width}}  {100.0 * fraction:5.1f} %  {alone}".rstrip())
        if len(rows) > MOST_DRIVERS:
            lines.append(f"    and {len(rows) - MOST_DRIVERS} more")
        if "worst_case" in entry:
            lines.append(f"    worst case, all inputs at their limits: {_range(entry['worst_case'], unit, digits)}")
    return lines


def _range(ends: "Sequence[Any]", unit: str, digits: int) -> str:
    """Two numbers with their unit, or each in the parts of compound units."""
    if ";" in unit:
        return " to ".join(quantity(end, unit, digits) for end in ends)
    return f"{' to '.join(number(end, digits) for end in ends)} {unit}".rstrip()


def with_spreads(plain: "list[tuple[str, Any, str]]", results: "dict[str, Any]") -> "list[tuple[str, Any, str]]":
    """CSV columns, each uncertain result followed by its mean, median, deviation and the ends of its interval."""
    beside: dict[str, list[tuple[str, Any, str]]] = {}
    for address, node in spreads(results):
        unit = node.get("unit", "")
        low, high = node["interval"]
        figures = {"mean": node["mean"], "median": node.get("median"), "std": node["std"], "low": low, "high": high}
        for name, figure in figures.items():
            for place, value in _cells(figure):
                component_unit = unit.split(";")[int(place[1:-1])].strip() if ";" in unit else unit
                beside.setdefault(f"{address}{place}", []).append((f"{address}{place}.{name}", value, component_unit))
    return [cell for entry in plain for cell in (entry, *beside.get(entry[0], ()))]


def _cells(value: "Any") -> "Iterator[tuple[str, Any]]":
    """Every number of nested lists, with its indices as text."""
    if isinstance(value, list):
        for index, item in enumerate(value):
            yield from ((f"[{index}]{place}", number_) for place, number_ in _cells(item))
    else:
        yield "", value
