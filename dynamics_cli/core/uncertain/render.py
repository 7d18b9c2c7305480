"""Uncertain inputs and results as a table for people shows them."""

from dynamics_cli.core.render import number

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

# A mean further than this share of the deviation from the middle of the interval makes it lopsided.
LOPSIDED = 0.02
MOST_DRIVERS = 6


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
        return f"{number(node.get('value', node['median']), 6)} ({number(node['low'], 6)} to {number(node['high'], 6)})"
    values = node.get("readings") or node.get("values") or []
    listed = ", ".join(number(value, 17) for value in values)
    return f"[{listed}]" if name == "readings" else f"empirical({listed})"


def _spreads(node: "Any", address: str = "") -> "Iterator[tuple[str, dict[str, Any]]]":
    """Every result with an interval, by address."""
    if isinstance(node, dict):
        if "interval" in node:
            yield address, node
            return
        for key, item in node.items():
            yield from _spreads(item, f"{address}.{key}" if address else key)


def spread_tails(results: "dict[str, Any]", digits: int) -> "dict[str, str]":
    """What stands beside an uncertain result: the interval and its probability, and the deviation."""
    made = {}
    for address, node in _spreads(results):
        low, high = (number(end, digits) for end in node["interval"])
        chance = f"{100.0 * node['coverage']:.6g} %"
        deviation = f", σ {number(node['std'], 3)}" if node["std"] is not None else ""
        made[address] = f"{chance} within {low} to {high}{deviation}{_lean(node)}"
    return made


def _lean(node: "dict[str, Any]") -> str:
    """The median where the distribution leans to one side enough to matter."""
    low, high = node["interval"]
    median = node["median"]
    if isinstance(low, list) or not high > low:
        return ""
    below, above = median - low, high - median
    return f", median {number(median, 6)}" if abs(above - below) > LOPSIDED * (high - low) else ""


def driver_lines(document: "dict[str, Any]", digits: int) -> "list[str]":
    """For every result: the inputs ranked by their share of the variance, and what each makes of the result alone."""
    lines: list[str] = []
    shown: list[Any] = []
    for name, entry in document.get("sensitivity", {}).items():
        rows = entry["inputs"]
        if entry in shown:
            continue
        shown.append(entry)
        unit = entry.get("unit", "")
        lines += ["", f"  {name} is driven by"]
        width = max(len(row["input"]) for row in rows)
        rows = [row for row in rows if row.get("total", row["share"]) or len(rows) == 1]
        for row in rows[:MOST_DRIVERS]:
            share = row.get("total", row["share"])
            low, high = row["alone"]
            alone = f"alone {number(low, digits)} to {number(high, digits)} {unit}".rstrip()
            lines.append(f"    {row['input']:<{width}}  {100.0 * share:5.1f} %  {alone}")
        if len(rows) > MOST_DRIVERS:
            lines.append(f"    and {len(rows) - MOST_DRIVERS} more")
        if "worst_case" in entry:
            low, high = (number(end, digits) for end in entry["worst_case"])
            lines.append(f"    every input at its worst: {low} to {high} {unit}".rstrip() + " (not an interval)")
    return lines


def spread_columns(results: "dict[str, Any]") -> "list[tuple[str, Any, str]]":
    """Further CSV columns: mean, deviation and the ends of the interval."""
    made = []
    for address, node in _spreads(results):
        unit = node.get("unit", "")
        made += [(f"{address}.mean", node["mean"], unit), (f"{address}.std", node["std"], unit)]
        made += [(f"{address}.low", node["interval"][0], unit), (f"{address}.high", node["interval"][1], unit)]
    return made
