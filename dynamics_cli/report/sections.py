"""One result document as the blocks of a report's section."""

from dynamics_cli.core.render import (
    bound_text,
    check_line,
    columns,
    flatten,
    is_table,
    number,
    quantity,
    to_pretty_json,
)
from dynamics_cli.report.blocks import Block, Code, Heading, Items, Paragraph, Table

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Document = dict[str, Any]

ALL_DIGITS = 17
# A longer table is shown by its first and last rows.
MOST_ROWS = 40


def section(nth: int, document: "Document", summary: str, digits: int) -> "list[Block]":
    """What a document says: results, inputs, how they came about, what drives them, checks and warnings."""
    blocks: list[Block] = [Heading(2, f"{nth}. dynamics {document['command']}")]
    if summary:
        blocks.append(Paragraph(summary))
    blocks += _results(document, digits)
    blocks += _inputs(document)
    blocks += _reasons(document, digits)
    blocks += _drivers(document, digits)
    return blocks + _diagnostics(document)


def _results(document: "Document", digits: int) -> "list[Block]":
    results = document["results"]
    bounds = document["numerics"].get("error_bound", {})
    spread = _spreads(results)
    head = ["result", "value", *(["interval", "standard deviation"] if spread else []), "rounding error at most"]
    rows = []
    for name, value, unit in flatten(results):
        row = [name, quantity(value, unit, digits)]
        if spread:
            row += _interval(spread.get(name), unit, digits)
        rows.append([*row, bound_text(bounds[name]) if name in bounds else ""])
    blocks: list[Block] = [Heading(3, "Results")]
    if rows:
        blocks.append(Table(head, rows))
    blocks += _tables(results, digits)
    limits = [item["message"] for item in document.get("limits", ())]
    return blocks + ([Items(limits)] if limits else [])


def _spreads(node: "Any", address: str = "") -> "dict[str, Document]":
    made: dict[str, Document] = {}
    if isinstance(node, dict):
        if "interval" in node:
            return {address: node}
        for key, item in node.items():
            made |= _spreads(item, f"{address}.{key}" if address else key)
    return made


def _interval(node: "Document | None", unit: str, digits: int) -> "list[str]":
    if node is None:
        return ["", ""]
    low, high = (number(end, digits) for end in node["interval"])
    chance = f"{100.0 * node['coverage']:.6g} %"
    deviation = quantity(node["std"], unit, 3) if node["std"] is not None else ""
    return [f"{low} to {high} {unit}".rstrip() + f" ({chance})", deviation]


def _tables(node: "Document", digits: int) -> "list[Block]":
    blocks: list[Block] = []
    for name, table in node.items():
        if not is_table(table):
            continue
        made = columns(table)
        rows = [[number(cell, digits) for cell in row] for row in zip(*(values for _, _, values in made), strict=True)]
        if len(rows) > MOST_ROWS:
            half = MOST_ROWS // 2
            rows = [*rows[:half], ["…"] * len(made), *rows[-half:]]
        heads = [f"{label} [{unit}]" if unit else label for label, unit, _ in made]
        blocks += [Paragraph(f"{name.replace('_', ' ')}:"), Table(heads, rows)]
    return blocks


def _inputs(document: "Document") -> "list[Block]":
    inputs = document["inputs"]
    rows = [[name, quantity(value, unit, ALL_DIGITS)] for name, value, unit in flatten(inputs)]
    blocks: list[Block] = [Heading(3, "Inputs")]
    if rows:
        blocks.append(Table(["input", "value"], rows))
    blocks += _tables(inputs, ALL_DIGITS)
    told = document["numerics"].get("uncertainty", {}).get("correlations", {})
    if told:
        pairs = [f"{' and '.join(pair.split(','))}: {number(rho, 6)}" for pair, rho in told.items()]
        blocks.append(Items([f"correlation of {pair}" for pair in pairs]))
    return blocks


def _reasons(document: "Document", digits: int) -> "list[Block]":
    model = document["model"]
    explained = document.get("explanation", {})
    lines = [f"model: {model['name']}" + (f" ({model['why']})" if model.get("why") else "")]
    lines += [f"assumption: {text}" for text in model.get("assumptions", ())]
    lines += [f"source: {model['source']}", f"method: {document['numerics'].get('method', '')}"]
    blocks: list[Block] = [Heading(3, "How it was calculated"), Items(lines)]
    formula = [explained[key] for key in ("formula", "with_numbers") if explained.get(key)]
    if formula:
        where = "; ".join(explained.get("symbols", ()))
        blocks.append(Code("\n".join([*formula, *([f"where {where}"] if where else [])])))
    return blocks


def _drivers(document: "Document", digits: int) -> "list[Block]":
    blocks: list[Block] = []
    for name, entry in document.get("sensitivity", {}).items():
        unit = entry.get("unit", "")
        rows = [
            [
                row["input"],
                f"{100.0 * row.get('total', row['share']):.1f} %",
                f"{number(row['alone'][0], digits)} to {number(row['alone'][1], digits)} {unit}".rstrip(),
            ]
            for row in entry["inputs"]
        ]
        blocks += [Paragraph(f"What drives {name}:"), Table(["input", "share of the variance", "alone"], rows)]
        if "worst_case" in entry:
            low, high = (number(end, digits) for end in entry["worst_case"])
            blocks.append(Paragraph(f"Every input at its worst: {low} to {high} {unit}".rstrip() + " (no interval)."))
    return [Heading(3, "What drives the results"), *blocks] if blocks else []


def _diagnostics(document: "Document") -> "list[Block]":
    lines = [f"check: {check_line(check)}" for check in document["checks"]]
    for item in document["warnings"]:
        mend = f" ({item['mend']})" if item.get("mend") else ""
        lines.append(f"{item['severity']}: {item['message']}{mend}")
    lines += [f"file {file['name']}: SHA-256 {file['sha256']}" for file in document.get("files", ())]
    return [Heading(3, "Checks and warnings"), Items(lines)] if lines else []


def embedded(documents: "list[Document]") -> "list[Block]":
    """The inputs as data: what `--input` takes to calculate everything again."""
    blocks: list[Block] = [Heading(2, "Inputs as data")]
    words = "Each block is what --input reads: saved in a file, it calculates its section again."
    blocks.append(Paragraph(words))
    for nth, document in enumerate(documents, 1):
        blocks += [
            Paragraph(f"{nth}. dynamics {document['command']}, version {document['version']}:"),
            Code(to_pretty_json(document["inputs"]).rstrip()),
        ]
    return blocks
